//! A surface of any kind as a bicubic B-spline surface within a tolerance.

use super::scheme::Direction;
use super::{BSplineSurface, ParamSurface, Patch, exact};
use crate::geometry::param::check_tolerance;
use crate::geometry::{GeometryError, Point};

/// The most patches along a direction.
const MOST: usize = 256;
/// Where a patch is compared: its error has its extremes near the middle.
const COMPARED: [f64; 3] = [0.25, 0.5, 0.75];

/// The surface by Hermite patches on finer and finer grids, until they are near enough. The error falls by sixteen with
/// every halving.
pub(super) fn fitted(
    surface: &(impl ParamSurface + ?Sized),
    tolerance: f64,
) -> Result<BSplineSurface, GeometryError> {
    check_tolerance(tolerance)?;
    let [u, v] = surface.spans();
    let mut parts = 2;
    loop {
        let patches = patches(surface, parts);
        let off = distance(surface, parts, &patches);
        if off <= tolerance {
            // Spans of a surface need not be smooth where they meet, pieces of one are.
            let smoothness = usize::from([u, v] == [1, 1]);
            let directions = [0, 1].map(|d| Direction {
                spans: surface.spans()[d] * parts,
                cells: 1,
                half_ends: false,
                closed: surface.closed()[d],
                smoothness,
            });
            return Ok(exact::of_patches(&patches, directions));
        }
        if parts * u.max(v) >= MOST {
            return Err(GeometryError::ToleranceTooSmall { value: tolerance, least: off });
        }
        parts *= 2;
    }
}

/// The span and the parameter of a grid line; `end` says to which of the two spans at a joint it belongs.
fn place(line: usize, parts: usize, end: bool) -> (usize, f64) {
    let (span, step) = (line / parts, line % parts);
    if end && step == 0 { (span.saturating_sub(1), 1.0) } else { (span, step as f64 / parts as f64) }
}

fn patches(surface: &(impl ParamSurface + ?Sized), parts: usize) -> Vec<Patch> {
    let [rows, columns] = surface.spans().map(|spans| spans * parts);
    let step = 1.0 / parts as f64;
    let corner = |k: usize, l: usize, ends: [bool; 2]| -> [Point<3>; 4] {
        let ((i, u), (j, v)) = (place(k, parts, ends[0]), place(l, parts, ends[1]));
        surface.at([i, j], [u, v]).map_or([[0.0; 3]; 4], |at| {
            [at.point, at.u.map(|x| step * x), at.v.map(|x| step * x), at.uv.map(|x| step * step * x)]
        })
    };
    let patch = |k: usize, l: usize| {
        let corners = [0, 1].map(|a| [0, 1].map(|b| corner(k + a, l + b, [a == 1, b == 1])));
        // Rows and columns 2 and 3 are the derivatives at the borders 0 and 1.
        let entry = |r: usize, c: usize| corners[r % 2][c % 2][r / 2 + 2 * (c / 2)];
        Patch::from_hermite(&std::array::from_fn(|r| std::array::from_fn(|c| entry(r, c))))
    };
    (0..rows).flat_map(|k| (0..columns).map(move |l| (k, l))).map(|(k, l)| patch(k, l)).collect()
}

/// The largest distance by coordinate, twice, for together they are further in space.
fn distance(surface: &(impl ParamSurface + ?Sized), parts: usize, patches: &[Patch]) -> f64 {
    let columns = surface.spans()[1] * parts;
    let mut worst = 0.0_f64;
    for (number, patch) in patches.iter().enumerate() {
        let ((i, u), (j, v)) = (place(number / columns, parts, false), place(number % columns, parts, false));
        for s in COMPARED {
            for t in COMPARED {
                let uv = [u + s / parts as f64, v + t / parts as f64];
                let Some(theirs) = surface.eval([i, j], uv) else { continue };
                let ours = patch.eval(s, t);
                worst = ours.iter().zip(theirs).fold(worst, |worst, (a, b)| worst.max((a - b).abs()));
            }
        }
    }
    2.0 * worst
}

#[cfg(test)]
mod tests {
    use crate::geometry::ec::EcBasis;
    use crate::geometry::{ParamSurface, Weave};

    #[test]
    fn a_torus_patch_is_met_within_the_tolerance() {
        let along = EcBasis::new(&"0,i".parse().unwrap(), [0.0, 1.5]).unwrap();
        let net = [[3.0, 0.0, 0.0], [3.0, 3.0, 1.0], [2.0, 3.0, 2.0]];
        let net = (0..3).map(|k| (0..3).map(|l| net[(k + l) % 3]).collect()).collect();
        let surface = Weave::new(&along, &along, net).unwrap();
        let form = surface.fitted_bspline(1e-8).unwrap();
        assert_eq!((form.degrees, form.net.len()), ([3, 3], form.net[0].len()));
        let [last_u, last_v] = [0, 1].map(|d| *form.knots[d].last().unwrap());
        for (u, v) in [(0.0, 0.0), (0.31, 0.77), (0.5, 0.9), (1.0, 1.0), (0.123, 0.456)] {
            let (one, other) =
                (surface.eval([0, 0], [u, v]).unwrap(), form.eval(u * last_u, v * last_v).unwrap());
            assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-8), "{one:?} {other:?}");
        }
        assert!(surface.fitted_bspline(1e-15).is_err() && surface.fitted_bspline(0.0).is_err());
    }
}
