//! A surface as a model for other programs, in any of their formats.

use super::mesh::{Triangles, write_obj, write_ply};
use super::mesh_rows::MeshRows;
use super::step::surfaces_step;
use super::stl::StlRows;
use super::{FigureError, Mesh};
use crate::geometry::{GeometryError, Grid, ParamSurface};
use std::{fmt, io};

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
        let model = self.model(surfaces, options)?;
        let note = model.note.clone();
        Ok((model.into_bytes(), note))
    }

    /// The same, of which a mesh need not stand in memory.
    ///
    /// # Errors
    /// Those of [`ModelFormat::encode`].
    ///
    /// ```
    /// use grafika::figure::{ModelFormat, ModelOptions};
    /// use grafika::geometry::{Method, ParamSurface, Scheme, Surface, Topology};
    ///
    /// let net: Vec<Vec<[f64; 3]>> =
    ///     (0..5).map(|k| (0..4).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
    /// let surface = Surface::new(Scheme::new(Method::Spline, Topology::Open), &net)?;
    /// let options = ModelOptions { steps: 10, tolerance: 1e-6, name: "saddle" };
    /// let mut file = Vec::new();
    /// ModelFormat::Stl.model(&[&surface], &options)?.write(&mut file)?;
    /// assert_eq!(file.len(), 84 + 50 * 2 * 40 * 30);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn model<'a>(
        self,
        surfaces: &[&'a dyn ParamSurface],
        options: &ModelOptions<'_>,
    ) -> Result<Model<'a>, FigureError> {
        if self == ModelFormat::Step {
            let exact = surfaces.iter().all(|surface| surface.to_bspline().is_some());
            let text = surfaces_step(surfaces, options.name, options.tolerance)?;
            let note = (!exact).then(|| {
                let part = options.tolerance;
                format!("the surface has no exact form in .step; it is fitted within {part:e} of its size")
            });
            return Ok(Model { content: Content::Whole(text.into_bytes()), note });
        }
        if let [surface] = *surfaces
            && let Some(content) = self.by_rows(surface, options.steps)?
        {
            return Ok(Model { content, note: None });
        }
        let grids: Vec<Grid> =
            surfaces.iter().map(|surface| surface.grid(options.steps)).collect::<Result<_, _>>()?;
        let mesh = Mesh::from_grids(&grids)?;
        let (bytes, note) = match self {
            ModelFormat::Stl => {
                let stl = mesh.to_stl()?;
                let warning = stl.warning();
                (stl.bytes, warning)
            }
            ModelFormat::Ply => (mesh.to_ply()?, None),
            ModelFormat::Obj | ModelFormat::Step => (mesh.to_obj().into_bytes(), None),
        };
        Ok(Model { content: Content::Whole(bytes), note })
    }

    /// The mesh of a surface row by row, if it is simple enough.
    fn by_rows(self, surface: &dyn ParamSurface, steps: usize) -> Result<Option<Content<'_>>, GeometryError> {
        let Some(mesh) = MeshRows::new(surface, steps)? else { return Ok(None) };
        let [vertices, _] = mesh.counts();
        Ok(match self {
            ModelFormat::Stl => StlRows::new(mesh)?.map(Content::Stl),
            ModelFormat::Ply => i32::try_from(vertices).is_ok().then_some(Content::Ply(mesh)),
            ModelFormat::Obj => Some(Content::Obj(mesh)),
            ModelFormat::Step => None,
        })
    }

    /// Whether the file is text.
    #[must_use]
    pub fn is_text(self) -> bool {
        matches!(self, ModelFormat::Step | ModelFormat::Obj)
    }
}

/// A model that can be written.
pub struct Model<'a> {
    content: Content<'a>,
    /// What the user should know about it, in a sentence.
    pub note: Option<String>,
}

/// What is written.
enum Content<'a> {
    Whole(Vec<u8>),
    Stl(StlRows<'a>),
    Obj(MeshRows<'a>),
    Ply(MeshRows<'a>),
}

impl Model<'_> {
    /// Writes the file.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        match &self.content {
            Content::Whole(bytes) => out.write_all(bytes),
            Content::Stl(rows) => rows.write(out),
            Content::Obj(rows) => write_obj(rows, out),
            Content::Ply(rows) => write_ply(rows, out),
        }
    }

    fn into_bytes(self) -> Vec<u8> {
        match self.content {
            Content::Whole(bytes) => bytes,
            _ => {
                let size = if let Content::Stl(rows) = &self.content { rows.size() } else { 0 };
                let mut bytes = Vec::with_capacity(size);
                // Writing to a row of bytes cannot fail, nor a surface whose rows were there before.
                let _ = self.write(&mut bytes);
                bytes
            }
        }
    }
}

impl fmt::Debug for Model<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Model").field("note", &self.note).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Closure, Method, Point, Scheme, Surface, Topology, Weave, Weights};
    use proptest::prelude::*;

    /// The file by all points and triangles in memory.
    fn whole(format: ModelFormat, surface: &dyn ParamSurface, steps: usize) -> Result<Vec<u8>, FigureError> {
        let mesh = Mesh::from_grid(&surface.grid(steps)?)?;
        match format {
            ModelFormat::Stl => mesh.to_stl().map(|stl| stl.bytes),
            ModelFormat::Ply => mesh.to_ply(),
            ModelFormat::Obj | ModelFormat::Step => Ok(mesh.to_obj().into_bytes()),
        }
    }

    fn assert_same(surface: &dyn ParamSurface, steps: usize) -> Result<(), TestCaseError> {
        let options = ModelOptions { steps, tolerance: 1e-6, name: "" };
        for format in [ModelFormat::Stl, ModelFormat::Ply, ModelFormat::Obj] {
            let ours = format.encode(&[surface], &options).map(|(bytes, _)| bytes);
            let theirs = whole(format, surface, steps);
            prop_assert!(ours == theirs, "{format:?} {surface:?}");
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Of any topology, flat, shrunk, far away or with equal points.
        #[test]
        fn rows_make_the_file_of_the_whole_mesh(
            topology in prop::sample::select(vec![Topology::Open, Topology::Sphere, Topology::Torus]),
            method in prop::sample::select(vec![Method::BSpline3, Method::Spline, Method::BSpline2, Method::Local { k0: 0.5 }]),
            size in [4_usize..8, 4_usize..8], steps in 1_usize..5, shape in 0..6, seed in 0_usize..99,
        ) {
            let jump = |k: usize, l: usize| ((k * 31 + l * 17 + seed * 7) % 23) as f64 / 23.0;
            // Round, for those that are closed.
            let [rows, columns] = size;
            let point = |k: usize, l: usize| -> Point<3> {
                let (a, b) = (std::f64::consts::TAU * k as f64 / rows as f64, std::f64::consts::PI * l as f64 / (columns - 1) as f64);
                let ball = [(2.0 + b.sin()) * a.cos(), (2.0 + b.sin()) * a.sin(), b.cos() + 0.3 * jump(k, l)];
                match shape {
                    0 => ball,
                    1 => [k as f64, l as f64, jump(k, l)],
                    2 => [k as f64, l as f64, 0.0],
                    3 => [ball[0] + 1e9, ball[1], ball[2]],
                    4 => [ball[0], ball[1], 0.0],
                    _ => [jump(k, l).round(), jump(l, k).round(), jump(k + l, l).round()],
                }
            };
            let net: Vec<Vec<Point<3>>> = (0..rows).map(|k| (0..columns).map(|l| point(k, l)).collect()).collect();
            if let Ok(surface) = Surface::new(Scheme::new(method, topology), &net) {
                assert_same(&surface, steps)?;
            }
        }
    }

    #[test]
    fn woven_surfaces_come_row_by_row_too() {
        let along = Weights::new(Method::BSpline3, Closure::Closed, 6).unwrap();
        let turn = |k: usize| (k as f64).sin_cos();
        let point =
            |k: usize, l: usize| [(3.0 + turn(l).0) * turn(k).0, (3.0 + turn(l).0) * turn(k).1, turn(l).1];
        let net = (0..6).map(|k| (0..6).map(|l| point(k, l)).collect()).collect();
        assert_same(&Weave::new(&along, &along, net).unwrap(), 3).unwrap();
    }
}
