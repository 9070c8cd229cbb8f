//! What can be wrong with knots, and why a point is not reached, in sentences.

use super::{MAX_ORDER, MIN_ORDER};
use crate::geometry::GeometryError;
use crate::geometry::error::few_digits;
use std::fmt;

/// Why there is no such curve, path or solution. Knots, spans and control points are counted from 0, as in the
/// formulas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KnotError {
    /// An order that is not [`MIN_ORDER`] to [`MAX_ORDER`].
    Order {
        /// What was given.
        given: usize,
    },
    /// Too few knots for the order, or too many.
    KnotCount {
        /// How many were given.
        given: usize,
        /// How many are needed at least.
        least: usize,
        /// How many are allowed at most.
        most: usize,
    },
    /// A knot that is not a number within 1e40.
    NotFinite {
        /// The knot.
        knot: usize,
    },
    /// A knot that is smaller than the one before.
    NotAscending {
        /// The knot.
        knot: usize,
        /// The knot before.
        before: f64,
        /// Its own value.
        value: f64,
    },
    /// Two knots that are neither equal nor 1e-40 apart.
    TooNear {
        /// The second one.
        knot: usize,
    },
    /// Too many equal knots.
    TooMultiple {
        /// The last of them.
        knot: usize,
        /// How many there are allowed.
        most: usize,
    },
    /// The domain has no length.
    NoSpan,
    /// A weight that is not a number from 1e-40 to 1e40.
    Weight {
        /// The control point.
        point: usize,
        /// What was given.
        value: f64,
    },
    /// Another number of weights than of points.
    WeightCount {
        /// How many were given.
        given: usize,
        /// How many points there are.
        needed: usize,
    },
    /// A span, knot or control point that does not exist or cannot be asked for here.
    Index {
        /// What it is: `span`, `knot`, `point`, `multiplicity`.
        name: &'static str,
        /// What was given.
        given: usize,
        /// The first possible.
        first: usize,
        /// The last possible.
        last: usize,
    },
    /// A knot that moves the curve nowhere.
    Idle {
        /// The knot.
        knot: usize,
    },
    /// A span without length.
    EmptySpan {
        /// The span.
        span: usize,
    },
    /// A value outside its range.
    Outside {
        /// What it is: `u`, `v`, `t`.
        name: &'static str,
        /// What was given.
        value: f64,
        /// The range.
        range: [f64; 2],
    },
    /// A value at the end of a span, where the formula divides by zero.
    OnKnot {
        /// What it is: `u`.
        name: &'static str,
        /// What was given.
        value: f64,
        /// The ends of the span.
        span: [f64; 2],
    },
    /// Two knots of a formula coincide, so that it has no value.
    Coincide {
        /// The value of the moved knot.
        value: f64,
    },
    /// A curve of order 2 (or whose order is one above the multiplicity) has no envelope curve.
    NoEnvelope {
        /// The order.
        order: usize,
        /// The multiplicity of the moved knot.
        multiplicity: usize,
    },
    /// The method is for another order.
    OrderNeeded {
        /// The order of the curve.
        given: usize,
        /// The lowest order that is right.
        least: usize,
        /// The highest order that is right.
        most: usize,
    },
    /// The method is for curves without weights.
    Rational,
    /// The method is for open curves.
    Closed,
    /// The curve would move too far.
    WouldMove {
        /// By how much, in the unit of the points.
        by: f64,
        /// The largest distance allowed.
        tolerance: f64,
    },
    /// No knots or weights of this kind bring the curve to the point.
    Unreached(Unreached),
    /// The control points are wrong.
    Points(GeometryError),
}

/// Why a point is not reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unreached {
    /// The sides along which the point would move are parallel.
    Parallel,
    /// A blending function would not be positive.
    Function {
        /// The control point it belongs to.
        point: usize,
        /// The value it would have.
        value: f64,
    },
    /// A knot would have to leave its neighbours.
    Knot {
        /// The knot.
        knot: usize,
        /// The value it would have.
        value: f64,
        /// The range it may have.
        range: [f64; 2],
    },
    /// The point is not inside the triangle of three control points.
    Triangle {
        /// The first of them.
        first: usize,
    },
    /// A weight would not be positive.
    Weight {
        /// The control point.
        point: usize,
        /// The weight it would have.
        value: f64,
    },
    /// A search found nothing.
    NotFound,
}

impl fmt::Display for Unreached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Parallel => {
                f.write_str("the two sides of the polygon are parallel; another span has a solution")
            }
            Self::Function { point, value } => {
                write!(f, "the influence of control point {point} would be {value}; it must be positive")
            }
            Self::Knot { knot, value, range: [from, to] } => {
                write!(f, "knot {knot} would have to be {value}; it must be between {from} and {to}")
            }
            Self::Triangle { first } => write!(
                f,
                "the point must be inside the triangle of the control points {first}, {} and {}",
                first + 1,
                first + 2
            ),
            Self::Weight { point, value } => {
                write!(f, "the weight of control point {point} would be {value}; it must be positive")
            }
            Self::NotFound => f.write_str("outside the reachable region"),
        }
    }
}

impl fmt::Display for KnotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Order { given } => {
                write!(f, "the order is {given}; it must be {MIN_ORDER} to {MAX_ORDER}")
            }
            Self::KnotCount { given, least, most } => {
                write!(f, "there are {given} knots; {least} to {most} are possible")
            }
            Self::NotFinite { knot } => write!(f, "knot {knot} is not a number within 1e40"),
            Self::NotAscending { knot, before, value } => {
                write!(f, "knot {knot} is {value}, but the one before is {before}; knots must not descend")
            }
            Self::TooNear { knot } => {
                write!(f, "knot {knot} is too near to the one before; both must be equal or 1e-40 apart")
            }
            Self::TooMultiple { knot, most } => {
                write!(f, "there are too many knots equal to knot {knot}; {most} are allowed")
            }
            Self::NoSpan => f.write_str("all knots of the domain are the same; two must be different"),
            Self::Weight { point, value } => {
                write!(f, "the weight of control point {point} is {value}; it must be 1e-40 to 1e40")
            }
            Self::WeightCount { given, needed } => {
                write!(f, "there are {given} weights for {needed} control points; every point needs one")
            }
            Self::Index { name, given, first, last } if first <= last => {
                write!(f, "there is no {name} {given} here; {first} to {last} are possible")
            }
            Self::Index { name, given, .. } => {
                write!(f, "there is no {name} {given} here, the curve is too short for any")
            }
            Self::Idle { knot } => {
                write!(f, "the arc does not depend on knot {knot}; only the nearest arcs do")
            }
            Self::EmptySpan { span } => write!(f, "span {span} has no length; another one is needed"),
            Self::Outside { name, value, range: [from, to] } => {
                write!(f, "{name} is {value}; it must be between {from} and {to}")
            }
            Self::OnKnot { name, value, span: [from, to] } => {
                write!(f, "{name} is {value}, a knot; it must be larger than {from} and smaller than {to}")
            }
            Self::Coincide { value } => {
                write!(
                    f,
                    "with the knot at {value} two knots of the formula coincide; another value is needed"
                )
            }
            Self::NoEnvelope { order, multiplicity } => write!(
                f,
                "curves of order {order} have no envelope for a knot of multiplicity {multiplicity}; it must be {} at most",
                order.saturating_sub(2)
            ),
            Self::OrderNeeded { given, least, most } if least == most => {
                write!(f, "the curve has order {given}; this is for order {least}")
            }
            Self::OrderNeeded { given, least, most } => {
                write!(f, "the curve has order {given}; this is for orders {least} to {most}")
            }
            Self::Rational => f.write_str("the curve has weights; this is for curves without weights"),
            Self::Closed => f.write_str("the curve is closed; this is for open curves, or for more spans"),
            Self::WouldMove { by, tolerance } => {
                let [by, most] = [by, tolerance].map(few_digits);
                write!(f, "the curve would move by {by}; at most {most} is allowed")
            }
            Self::Unreached(reason) => reason.fmt(f),
            Self::Points(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for KnotError {}

impl From<GeometryError> for KnotError {
    fn from(error: GeometryError) -> Self {
        Self::Points(error)
    }
}

impl From<Unreached> for KnotError {
    fn from(reason: Unreached) -> Self {
        Self::Unreached(reason)
    }
}
