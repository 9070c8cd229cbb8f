//! Surfaces with Pythagorean normals in the surface editor: sticks for normals, offsets, the other method beside
//! this one, what is known about the radii of curvature, and the image of the normals.

mod edit;
mod facts;
mod gauss;
mod offsets;
mod say;

pub(super) use facts::{Facts, Told};
pub(super) use gauss::Gauss;

use super::surface::{Drawn, Part};
use crate::design::{DesignError, Index, NetDesign};
use crate::file::Method;
use crate::geometry::{BoundingBox, Grid, Jacobian, ParamSurface, PnNet, Point, norm};
use crate::screen::Color;
use serde::Serialize;
use std::cell::OnceCell;

/// The length of a stick as a part of the net's extent.
const STICK: f64 = 0.18;
/// The fewest and the most steps that a patch is drawn in, and lines along a direction of the whole surface.
const STEPS: [usize; 2] = [3, 10];
const LINES: usize = 30;

/// What is shown beside the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(super) struct Beside {
    /// The offset on the other side too.
    pub(super) both: bool,
    /// Walls between the surface and its offset.
    pub(super) shell: bool,
    /// The surface by the other method.
    pub(super) compared: bool,
    /// The image of the normals instead of the surface.
    pub(super) gauss: bool,
}

/// The other of the two methods.
pub(super) fn other(method: Method) -> Method {
    if method == Method::PnThesis { Method::Pn } else { Method::PnThesis }
}

/// The design by the other method.
fn by_the_other(net: &NetDesign) -> NetDesign {
    let method = other(net.method());
    net.with_settings(|settings| settings.method = Some(method))
}

/// The length of the sticks of a net.
pub(super) fn stick(net: &NetDesign) -> f64 {
    let points = net.net.points.iter().flatten().copied();
    BoundingBox::around(points).map_or(0.0, |bounds| STICK * bounds.extent())
}

/// The tip of the stick of a normal.
pub(super) fn tip(net: &NetDesign, index: Index) -> Option<Point<3>> {
    let (point, normal, length) = (net.point(index)?, net.normal(index)?, stick(net));
    Some(std::array::from_fn(|d| point[d] + length * normal[d]))
}

/// The design with the normal of a point turned to a place.
pub(super) fn with_tip(net: &NetDesign, index: Index, at: Point<3>) -> NetDesign {
    let Some(point) = net.point(index) else { return net.clone() };
    let normal: Point<3> = std::array::from_fn(|d| at[d] - point[d]);
    // Where the tip lies in the point, no direction can be told.
    if norm(normal) < 1e-9 * stick(net) { net.clone() } else { net.with_normal(index, normal) }
}

/// All patches of a net: those that are regular as surfaces, with offsets and the other method as asked for; cells
/// whose patches are parabolic somewhere as gaps.
pub(super) fn draw_up(net: &NetDesign, beside: Beside) -> Result<Drawn, DesignError> {
    let patches = net.patches_with_normals()?;
    let spans = patches.size();
    let steps = (LINES / spans[0].max(spans[1]).max(1)).clamp(STEPS[0], STEPS[1]);
    let mut drawn =
        Drawn { parts: Vec::new(), gaps: gaps(net, &patches), spans, steps, fine: OnceCell::new() };
    add(&mut drawn, &patches, None)?;
    if beside.compared {
        let other = by_the_other(net).patches_with_normals()?;
        add(&mut drawn, &other, Some(Color::LightMagenta))?;
    }
    offsets::add(&mut drawn, &patches, net.distance(), beside)?;
    Ok(drawn)
}

/// Adds the regular patches of a net, each as a part.
fn add(drawn: &mut Drawn, patches: &PnNet, ink: Option<Color>) -> Result<(), DesignError> {
    let [rows, columns] = patches.size();
    for [i, j] in (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j])) {
        if let Some(Ok(surface)) = patches.patch_surface(i, j) {
            let grid = surface.grid(drawn.steps)?;
            let folded = offsets::is_folded(&surface);
            drawn.parts.push(Part { surface: Some(Box::new(surface)), grid, ink, folded });
        }
    }
    Ok(())
}

/// The cells of the net whose patches are parabolic somewhere.
fn gaps(net: &NetDesign, patches: &PnNet) -> Vec<Grid> {
    let [rows, columns] = patches.size();
    let places = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
    let gaps = places.filter(|[i, j]| patches.jacobian(*i, *j) == Some(Jacobian::Changes));
    let corner = |[i, j]: [usize; 2]| {
        Grid::from_fn([2, 2], [false, false], |k, l| net.point([i + k, j + l]).unwrap_or_default())
    };
    gaps.map(corner).collect()
}
