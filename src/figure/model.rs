//! A surface as a model for other programs, in any of their formats.

use super::{FigureError, Mesh, surface_step};
use crate::geometry::ParamSurface;

/// A format of models.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelFormat {
    /// The surface exactly.
    Step,
    /// A mesh in single precision.
    Stl,
    /// A mesh as text.
    Obj,
    /// A mesh in double precision.
    Ply,
}

impl ModelFormat {
    /// The file of a surface; a mesh has so many steps a span. And what the format could not hold, in a sentence.
    ///
    /// # Errors
    /// [`FigureError`] for a surface without area, and where the format has no numbers for it.
    pub fn encode(
        self,
        surface: &dyn ParamSurface,
        steps: usize,
        name: &str,
    ) -> Result<(Vec<u8>, Option<String>), FigureError> {
        if self == ModelFormat::Step {
            return Ok((surface_step(surface, name)?.into_bytes(), None));
        }
        let mesh = Mesh::from_grid(&surface.grid(steps)?)?;
        Ok(match self {
            ModelFormat::Stl => {
                let stl = mesh.to_stl()?;
                let warning = stl.warning();
                (stl.bytes, warning)
            }
            ModelFormat::Ply => (mesh.to_ply()?, None),
            ModelFormat::Obj | ModelFormat::Step => (mesh.to_obj().into_bytes(), None),
        })
    }
}
