//! The room against values of exact arithmetic, and the theorems against each other.

mod laws;
#[rustfmt::skip]
mod reference;
mod values;

use super::{KnotCurve, KnotVector};
use crate::geometry::{Point, norm};

/// The distance of two points.
fn apart<const D: usize>(a: Point<D>, b: Point<D>) -> f64 {
    norm::<D>(std::array::from_fn(|d| a[d] - b[d]))
}

fn curve(given: &reference::Given) -> KnotCurve<2> {
    let vector = KnotVector::new(given.order, given.knots.to_vec()).unwrap();
    if given.weights.is_empty() {
        return KnotCurve::new(vector, given.points.to_vec()).unwrap();
    }
    KnotCurve::rational(vector, given.points.to_vec(), given.weights.to_vec()).unwrap()
}
