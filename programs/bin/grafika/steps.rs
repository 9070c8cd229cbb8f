//! In how many steps a span of a surface is taken where the user does not say.

use crate::sample::SURFACE_STEPS;
use grafika::geometry::{MAX_SAMPLES, ParamSurface};
use grafika::launch::say;

/// Cells of a surface in a picture, at most, unless the user asks for more: finer lines run into each other, and a page of
/// them takes minutes.
const DRAWN: usize = 1 << 20;

/// What the steps are for.
#[derive(Clone, Copy)]
pub(crate) enum For {
    /// Lines of a picture.
    Picture,
    /// Samples, or triangles of a model.
    Points,
}

/// The steps that are asked for, or else ten, or as many as such large surfaces fit the limits with, which is told.
pub(crate) fn of_surfaces(asked: Option<u32>, surfaces: &[&dyn ParamSurface], made: For) -> usize {
    if let Some(asked) = asked {
        return asked as usize;
    }
    let most = match made {
        For::Picture => DRAWN,
        For::Points => MAX_SAMPLES,
    };
    let fits = |steps: &usize| {
        let sizes = surfaces.iter().map(|surface| surface.grid_size(*steps));
        let points =
            sizes.map(|size| size.map_or(usize::MAX, |[rows, columns]| rows.saturating_mul(columns)));
        points.fold(0, usize::saturating_add) <= most
    };
    let usual = SURFACE_STEPS as usize;
    let steps = (1..=usual).rev().find(fits).unwrap_or(1);
    if steps < usual {
        say("grafika", &format!("steps a span: {steps}, as the surface is large; --per-span takes others"));
    }
    steps
}
