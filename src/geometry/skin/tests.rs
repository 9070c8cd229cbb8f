//! Skins against values of 40 digits, against a brute-force reading of the definitions, and against each other.

mod laws;
#[rustfmt::skip]
mod reference;
mod space;
mod values;
mod wild;

use super::*;
use crate::geometry::point::{norm, scaled_difference};

/// The distance of two points.
fn apart<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    norm(scaled_difference(1.0, a, b))
}

/// The circles of rows x, y, r.
fn discs(rows: &[[f64; 3]]) -> Vec<Circle> {
    rows.iter().map(|[x, y, r]| Circle::new([*x, *y], *r)).collect()
}
