//! The nets that the surface programs begin with (chapter 3): row k is the points of constant u.

use crate::geometry::Point;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The matrix of a Hermite patch: a flat square with its middle in the origin, all vectors zero.
pub fn square(side: f64) -> Vec<Vec<Point<3>>> {
    let corner = |k: usize, l: usize| [k, l].map(|index| (index as f64 - 0.5) * side);
    (0..4)
        .map(|k| {
            (0..4)
                .map(|l| match (k, l) {
                    (0 | 1, 0 | 1) => [corner(k, l)[0], corner(k, l)[1], 0.0],
                    _ => [0.0; 3],
                })
                .collect()
        })
        .collect()
}

/// A flat grid with its middle in the origin.
pub fn plane([rows, columns]: [usize; 2], spacing: f64) -> Vec<Vec<Point<3>>> {
    let place = |index: usize, count: usize| (index as f64 - (count - 1) as f64 / 2.0) * spacing;
    (0..rows).map(|k| (0..columns).map(|l| [place(k, rows), place(l, columns), 0.0]).collect()).collect()
}

/// Meridians of a sphere, from pole to pole.
pub fn sphere([rows, columns]: [usize; 2], radius: f64) -> Vec<Vec<Point<3>>> {
    let meridian = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / rows as f64).sin_cos();
        (0..columns)
            .map(|l| {
                let from_pole = PI * l as f64 / (columns - 1) as f64;
                // The sine of pi is not exactly zero, and the poles are one point.
                let flat = if l == 0 || l + 1 == columns { 0.0 } else { radius * from_pole.sin() };
                [flat * cos, flat * sin, radius * from_pole.cos()]
            })
            .collect()
    };
    (0..rows).map(meridian).collect()
}

/// Circles around the tube of a torus.
pub fn torus([rows, columns]: [usize; 2], ring: f64, tube: f64) -> Vec<Vec<Point<3>>> {
    let circle = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / rows as f64).sin_cos();
        (0..columns)
            .map(|l| {
                let around = TAU * l as f64 / columns as f64 + FRAC_PI_2;
                let out = ring + tube * around.sin();
                [out * cos, out * sin, tube * around.cos()]
            })
            .collect()
    };
    (0..rows).map(circle).collect()
}

/// A grid over the plane, highest in the middle, falling with the square of the distance to the height 0 in its corners.
pub fn vault(shape: [usize; 2], spacing: f64, height: f64) -> Vec<Vec<Point<3>>> {
    let flat = plane(shape, spacing);
    let corner = flat.first().and_then(|row| row.first()).map_or(1.0, |[x, y, _]| x * x + y * y);
    let lift = |[x, y, _]: Point<3>| [x, y, (height * (1.0 - (x * x + y * y) / corner)).round()];
    flat.into_iter().map(|row| row.into_iter().map(lift).collect()).collect()
}

/// The unit normals of [`vault`], upwards.
pub fn vault_normals(shape: [usize; 2], spacing: f64, height: f64) -> Vec<Vec<Point<3>>> {
    let flat = plane(shape, spacing);
    let corner = flat.first().and_then(|row| row.first()).map_or(1.0, |[x, y, _]| x * x + y * y);
    let normal = |[x, y, _]: Point<3>| {
        let slope = [x, y].map(|side| 2.0 * height * side / corner);
        let length = (slope[0] * slope[0] + slope[1] * slope[1] + 1.0).sqrt();
        [slope[0] / length, slope[1] / length, 1.0 / length]
    };
    flat.into_iter().map(|row| row.into_iter().map(normal).collect()).collect()
}
