//! The offsets of a surface with Pythagorean normals, and the walls of a shell.

use super::Beside;
use crate::design::DesignError;
use crate::editor::net::surface::{Drawn, Part};
use crate::geometry::{Grid, Jacobian, ParamSurface, PnNet, PnSurface, Point};
use crate::screen::Color;

/// Places along each direction where a patch is looked at for folds.
const PLACES: usize = 5;

/// Adds the offsets at a distance, on both sides if asked for; patches that are folded there are red.
pub(super) fn add(
    drawn: &mut Drawn,
    patches: &PnNet,
    distance: f64,
    beside: Beside,
) -> Result<(), DesignError> {
    if distance == 0.0 {
        return Ok(());
    }
    let [rows, columns] = patches.size();
    let steps = (drawn.steps / 2).max(2);
    let sides = if beside.both { vec![distance, -distance] } else { vec![distance] };
    for [i, j] in (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j])) {
        let Some(Ok(surface)) = patches.patch_surface(i, j) else { continue };
        for &d in &sides {
            let offset = surface.offset(d)?;
            let folded = folds(&surface, d);
            let grid = offset.grid(steps)?;
            drawn.parts.push(Part {
                surface: Some(Box::new(offset)),
                grid,
                ink: Some(Color::Yellow),
                folded,
            });
        }
        if beside.shell {
            let near = surface.offset(if beside.both { -distance } else { 0.0 })?.grid(steps)?;
            let far = surface.offset(distance)?.grid(steps)?;
            let is_border = |[di, dj]: [isize; 2]| {
                let there = |index: usize, by: isize, count: usize| {
                    index.checked_add_signed(by).filter(|index| *index < count)
                };
                let next = there(i, di, rows).zip(there(j, dj, columns));
                next.is_none_or(|(i, j)| patches.jacobian(i, j) == Some(Jacobian::Changes))
            };
            for side in [[-1, 0], [1, 0], [0, -1], [0, 1]].into_iter().filter(|side| is_border(*side)) {
                let (one, other) = (border(&near, side), border(&far, side));
                let wall = Grid::from_fn([2, one.len()], [false, false], |k, l| {
                    let line = if k == 0 { &one } else { &other };
                    line.get(l).copied().unwrap_or_default()
                });
                drawn.parts.push(Part { surface: None, grid: wall, ink: Some(Color::Yellow), folded: false });
            }
        }
    }
    Ok(())
}

/// Whether an offset turns over somewhere in a patch: a radius has another sign there.
fn folds(surface: &PnSurface, distance: f64) -> bool {
    radii(surface).any(|pair| pair.iter().any(|radius| (radius + distance).signum() != radius.signum()))
}

/// Whether a patch is folded itself: a radius changes its sign.
pub(super) fn is_folded(surface: &PnSurface) -> bool {
    let mut signs = radii(surface).map(|pair| pair.map(f64::signum));
    let first = signs.next();
    signs.any(|sign| Some(sign) != first)
}

/// The radii of curvature in some places of a patch.
fn radii(surface: &PnSurface) -> impl Iterator<Item = [f64; 2]> + '_ {
    let place = |k: usize| k as f64 / (PLACES - 1) as f64;
    let places = (0..PLACES * PLACES).map(move |k| [place(k / PLACES), place(k % PLACES)]);
    places.filter_map(|uv| surface.place([0, 0], uv)).map(|place| place.radii)
}

/// The points of a grid along one of its sides, given by the way out of it.
fn border(grid: &Grid, side: [isize; 2]) -> Vec<Point<3>> {
    let (rows, columns) = (grid.rows(), grid.columns());
    let points = match side {
        [-1, _] => (0..columns).map(|l| grid.point(0, l)).collect::<Option<Vec<_>>>(),
        [1, _] => (0..columns).map(|l| grid.point(rows.saturating_sub(1), l)).collect(),
        [_, -1] => (0..rows).map(|k| grid.point(k, 0)).collect(),
        _ => (0..rows).map(|k| grid.point(k, columns.saturating_sub(1))).collect(),
    };
    points.unwrap_or_default()
}
