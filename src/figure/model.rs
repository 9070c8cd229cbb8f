//! A surface as a model for other programs, in any of their formats.

use super::step::surfaces_step;
use super::{FigureError, Mesh};
use crate::geometry::{Grid, ParamSurface};

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

/// How a model is made.
#[derive(Clone, Copy, Debug)]
pub struct ModelOptions<'a> {
    /// Steps a span of a mesh.
    pub steps: usize,
    /// How far a surface without an exact form may be from its model in STEP, as a part of its size.
    pub tolerance: f64,
    /// The name of the part in STEP.
    pub name: &'a str,
}

/// The tolerance of models for which none is given.
pub const MODEL_TOLERANCE: f64 = 1e-6;

impl ModelFormat {
    /// The file of surfaces, of which those that touch hang together in a mesh. And what the user should know about it,
    /// in a sentence.
    ///
    /// # Errors
    /// [`FigureError`] for a surface without area, and where the format has no numbers for it.
    pub fn encode(
        self,
        surfaces: &[&dyn ParamSurface],
        options: &ModelOptions<'_>,
    ) -> Result<(Vec<u8>, Option<String>), FigureError> {
        if self == ModelFormat::Step {
            let exact = surfaces.iter().all(|surface| surface.to_bspline().is_some());
            let text = surfaces_step(surfaces, options.name, options.tolerance)?;
            let note = (!exact).then(|| {
                let part = options.tolerance;
                format!("the surface has no exact form in .step; it is fitted within {part:e} of its size")
            });
            return Ok((text.into_bytes(), note));
        }
        let grids: Vec<Grid> =
            surfaces.iter().map(|surface| surface.grid(options.steps)).collect::<Result<_, _>>()?;
        let mesh = Mesh::from_grids(&grids)?;
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
