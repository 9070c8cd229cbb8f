//! Options of `grafika render` that what is drawn has no place for: they are refused.

use super::Render;
use crate::picture::Format;
use grafika::design::Shape;
use grafika::launch::Failure;

impl Render {
    /// Options that a curve has no place for.
    pub(super) fn check_curve(&self) -> Result<(), Failure> {
        match self.per_span {
            Some(_) => Err(Failure::usage("--per-span is for surfaces; curves are drawn exactly")),
            None => Ok(()),
        }
    }

    /// The joints of what has none.
    pub(super) fn check_joints(&self, shape: &Shape) -> Result<(), Failure> {
        match shape {
            Shape::Plane(_) | Shape::Space(_) => Ok(()),
            _ if self.joints => {
                Err(Failure::usage("--joints is for single curves; this file holds something else"))
            }
            _ => Ok(()),
        }
    }

    /// Options that are for control points, of what has none to be seen.
    pub(super) fn check_points(&self) -> Result<(), Failure> {
        let given = [("--points", self.points), ("--polygon", self.polygon)];
        match given.into_iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(Failure::usage(format!(
                "{option} is for control points; this file holds Bézier arcs or patches"
            ))),
            None => Ok(()),
        }
    }

    /// Options that a model has no place for.
    pub(super) fn check_model(&self, format: Format) -> Result<(), Failure> {
        let unused = [
            ("--view", self.view.is_some()),
            ("--points", self.points),
            ("--polygon", self.polygon),
            ("--joints", self.joints),
            ("--caption", self.caption.is_some()),
            ("--axes", self.axes),
            ("--width", self.width.is_some()),
        ];
        if let Some((option, _)) = unused.into_iter().find(|(_, given)| *given) {
            return Err(Failure::usage(format!("{option} is for pictures; models have no such thing")));
        }
        match format {
            Format::Step if self.per_span.is_some() => {
                Err(Failure::usage("--per-span is for pictures and meshes; .step has no steps"))
            }
            Format::Step => Ok(()),
            _ if self.title.is_some() => {
                Err(Failure::usage("--title is for pictures and .step; meshes have no name"))
            }
            _ if self.tolerance.is_some() => {
                Err(Failure::usage("--tolerance is for .step; how fine a mesh is, --per-span says"))
            }
            _ => Ok(()),
        }
    }

    /// Options that a picture of surfaces has no place for.
    pub(super) fn check_wires(&self) -> Result<(), Failure> {
        match self.tolerance {
            Some(_) => {
                Err(Failure::usage("--tolerance is for .step; how fine these lines are, --per-span says"))
            }
            None => Ok(()),
        }
    }
}
