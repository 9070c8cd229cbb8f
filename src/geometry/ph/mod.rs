//! Pythagorean-hodograph curves: exact lengths, equal steps along the curve, and exact offsets.
//!
//! The hodograph of a planar PH curve is the square of a complex polynomial `w`, so its speed `|w|^2` is a polynomial
//! too. Length is then a polynomial, the unit normal and every offset are rational, and the places where an offset
//! has cusps are roots of a polynomial (Farouki, *Pythagorean-Hodograph Curves*, 2008).
//!
//! - Planar curves: [`PhCurve::spline`] through points (C2), [`PhCurve::hermite`] with derivatives (C1),
//!   [`PhCurve::cubics`] with directions (G1). All are [`PhSegment`]s in a row.
//! - Offsets: [`PhCurve::offset`], positive distances to the left of the direction of travel; an [`Offset`] knows its
//!   exact rational form, cusps and length, and [`Offset::trimmed`] says which parts keep their distance.
//!   [`Offset::approximated`] gives approximations of other programs for comparison.
//! - Space: [`SpacePhCurve::hermite`], with Euler-Rodrigues and rotation-minimising frames.

mod banded;
mod bernstein;
mod choice;
mod chords;
mod compare;
mod complex;
mod crossings;
mod cubic;
mod curve;
mod frame;
mod hermite;
mod length;
mod offset;
mod part;
mod quadrature;
mod quaternion;
mod rational;
mod rational_curve;
mod roots;
mod segment;
mod solver;
mod space;
mod space_curve;
mod spline;
mod start;
#[cfg(test)]
mod testing;
mod trim;
mod turning;

pub use chords::chords;
pub use compare::{ApproximateOffset, Rule};
pub use crossings::Crossing;
pub use curve::{CurvatureExtremum, PhCurve, Place};
pub use offset::Offset;
pub use part::OffsetPart;
pub use rational::RationalArc;
pub use rational_curve::RationalCurve;
pub use segment::PhSegment;
pub use space::SpacePhSegment;
pub use space_curve::SpacePhCurve;
pub use spline::{Knots, SplineEnd, SplineEnds};
pub use trim::Trimmed;

use super::GeometryError;
use super::limits::MAX_SAMPLES;
use length::Lengths;

/// Places at equal lengths, both ends included.
fn equal_lengths(lengths: &Lengths, steps: usize) -> Result<Vec<Place>, GeometryError> {
    let most = MAX_SAMPLES - 1;
    if steps == 0 || steps > most {
        return Err(GeometryError::Samples { per_span: steps, most });
    }
    let total = lengths.total();
    let place = |k: usize| lengths.place(total * (k as f64 / steps as f64));
    Ok((0..=steps).filter_map(place).map(|(span, u)| Place { span, u }).collect())
}
