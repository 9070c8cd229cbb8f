//! What can be wrong with points and parameters, in sentences.

use super::limits::COORDINATE_LIMIT;
use std::fmt;

/// Why a curve or its weights cannot be computed. Points are counted from 1, as users see them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GeometryError {
    /// The method needs more control points.
    TooFewPoints {
        /// How many were given.
        given: usize,
        /// How many are needed at least.
        needed: usize,
    },
    /// More control points than [`MAX_POINTS`](super::MAX_POINTS).
    TooManyPoints {
        /// How many were given.
        given: usize,
        /// How many are allowed at most.
        most: usize,
    },
    /// Weights or tangents made for another number of points.
    WrongCount {
        /// How many points (or tangents) were given.
        given: usize,
        /// How many belong there.
        needed: usize,
    },
    /// A number of points that no row of Bézier arcs has.
    ArcCount {
        /// How many points were given.
        given: usize,
        /// The next number that is right.
        needed: usize,
        /// Whether the curve is closed.
        closed: bool,
    },
    /// The knots of a B-spline are not as many as its points and its degree need.
    KnotNumber {
        /// How many knots were given.
        given: usize,
        /// How many belong there.
        needed: usize,
        /// The number of control points.
        points: usize,
        /// The degree.
        degree: usize,
    },
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The point's number, from 1.
        number: usize,
    },
    /// A coordinate is larger than [`COORDINATE_LIMIT`](super::COORDINATE_LIMIT).
    TooLarge {
        /// The point's number, from 1.
        number: usize,
        /// The coordinate.
        value: f64,
    },
    /// The curve leaves the range of [`COORDINATE_LIMIT`](super::COORDINATE_LIMIT).
    Overflow {
        /// The first span that does, from 0.
        span: usize,
    },
    /// A parameter is not finite or outside its range.
    Parameter {
        /// The parameter's name: `k0`, `bias`, `tension`, `tolerance`, …
        name: &'static str,
        /// What was given.
        value: f64,
        /// What would be right, as the end of a sentence.
        wanted: &'static str,
    },
    /// A shape parameter that the curves of a family do not have.
    NoParameter {
        /// Its name on the command line.
        name: &'static str,
        /// Those that they have; empty for none.
        known: &'static str,
    },
    /// A shape parameter of a control point that is not there.
    NoControlPoint {
        /// The control point, from 0.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// The tolerance is smaller than double precision can keep for this curve.
    ToleranceTooSmall {
        /// What was given.
        value: f64,
        /// The smallest tolerance that can be kept.
        least: f64,
    },
    /// The tension makes the beta-spline's delta vanish (equation 2.67).
    CriticalTension {
        /// The bias.
        bias: f64,
        /// The tension given.
        tension: f64,
        /// The critical tension `-(bias^3 + 2 bias^2 + 2 bias + 1)` of this bias.
        critical: f64,
    },
    /// The method is not made of cubic spans, so it has no weights.
    NotPiecewise {
        /// The method's name.
        method: &'static str,
    },
    /// The method does not know this end rule.
    EndsNotOffered {
        /// The method's name.
        method: &'static str,
    },
    /// A coefficient of a Fourier curve is not finite or too large.
    Coefficient {
        /// Which one: `offset`, `amplitude` or `phase`.
        name: &'static str,
        /// Of which harmonic; 0 is the constant part.
        harmonic: usize,
        /// What was given.
        value: f64,
    },
    /// More harmonics than [`MAX_HARMONICS`](super::MAX_HARMONICS).
    TooManyHarmonics {
        /// How many were given.
        given: usize,
        /// How many are allowed at most.
        most: usize,
    },
    /// All points of a closed path are the same, so that it has no length to run through.
    NoLength,
    /// The rows of a control net are not equally long.
    Ragged {
        /// The row, from 0.
        row: usize,
        /// How many points it has.
        given: usize,
        /// How many the first row has.
        needed: usize,
    },
    /// The method has no surfaces of this topology.
    TopologyNotOffered {
        /// The method's name.
        method: &'static str,
        /// The topology's name.
        topology: &'static str,
    },
    /// A sphere's meridians have to come in opposite pairs for this method.
    OddMeridians {
        /// How many there are.
        given: usize,
    },
    /// A net of normals that does not fit the net of points.
    NormalCount {
        /// Rows and columns of the normals; a ragged net counts its first row.
        given: [usize; 2],
        /// Rows and columns of the points.
        needed: [usize; 2],
    },
    /// A normal that is no unit vector within 1e-6.
    NotUnit {
        /// The row of the net, from 0.
        row: usize,
        /// The place in the row, from 0.
        column: usize,
        /// The length of the vector given.
        length: f64,
    },
    /// A normal too near to +z for the method that does not turn the data.
    NormalUp {
        /// The row of the net, from 0.
        row: usize,
        /// The place in the row, from 0.
        column: usize,
    },
    /// Normals that do not fit into one chart of the sphere.
    NormalsTooWide,
    /// All normals are the same.
    NormalsEqual,
    /// A patch whose normals do not cover an area of the sphere once.
    Parabolic {
        /// The patch along u and v, from 0.
        patch: [usize; 2],
    },
    /// A patch whose rational form has no positive weights in pieces of reasonable number.
    NoPositiveWeights {
        /// The patch along u and v, from 0.
        patch: [usize; 2],
    },
    /// A net that cannot be refined without changing the surface.
    NotRefinable {
        /// The method's name.
        method: &'static str,
        /// Why, and what would be possible.
        reason: &'static str,
    },
    /// Two successive points are the same, and the curve cannot stop between them.
    EqualNeighbours {
        /// The first point's number, from 1.
        number: usize,
        /// The second one's: the next, or 1 where a closed curve returns.
        next: usize,
    },
    /// A tangent is zero and has no direction.
    NoDirection {
        /// The tangent's number, from 1.
        number: usize,
    },
    /// No Pythagorean-hodograph cubic has these ends.
    NoPhCubic {
        /// The number of the point that the span begins at, from 1.
        number: usize,
    },
    /// The equations of a Pythagorean-hodograph spline could not be solved.
    NotSolved {
        /// How large the equations' remainder still is, as a share of the longest chord.
        remainder: f64,
    },
    /// More samples than [`MAX_SAMPLES`](super::MAX_SAMPLES), or none.
    Samples {
        /// Steps asked for per span.
        per_span: usize,
        /// The largest number of steps for this curve.
        most: usize,
    },
}

impl fmt::Display for GeometryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooFewPoints { given, needed } => {
                write!(f, "too few control points: {given} given, at least {needed} needed")
            }
            Self::TooManyPoints { given, most } => {
                write!(f, "too many control points: {given} given, at most {most} allowed")
            }
            Self::WrongCount { given, needed } => {
                write!(f, "wrong number of points: {given} given, exactly {needed} needed")
            }
            Self::ArcCount { given, needed, closed } => {
                let missing = needed.saturating_sub(given);
                match closed {
                    false => write!(
                        f,
                        "{given} points given: open Bézier arcs take 4, 7, 10, ... points; {missing} more needed"
                    ),
                    true => write!(
                        f,
                        "{given} points given: closed Bézier arcs take 3, 6, 9, ... points; {missing} more needed"
                    ),
                }
            }
            Self::KnotNumber { given, needed, points, degree } => write!(
                f,
                "{given} knots given, but {points} control points need exactly {needed} knots at degree {degree}"
            ),
            Self::NotFinite { number } => {
                write!(f, "point {number} has a coordinate that is not a finite number")
            }
            Self::TooLarge { number, value } => {
                write!(f, "point {number} has the coordinate {value:e}, larger than {COORDINATE_LIMIT:e}")
            }
            Self::Overflow { span } => {
                write!(f, "span {span} of the curve leaves the range of {COORDINATE_LIMIT:e}")
            }
            // Hundreds of zeros tell nobody more than an exponent does.
            Self::Parameter { name, value, wanted } if value.is_finite() && value.abs() >= 1e16 => {
                write!(f, "{name} is {value:e}, but must be {wanted}")
            }
            Self::Parameter { name, value, wanted } => write!(f, "{name} is {value}, but must be {wanted}"),
            Self::NoParameter { name, known: "" } => {
                write!(f, "there is no parameter {name}: this family has none")
            }
            Self::NoParameter { name, known } => {
                write!(f, "this family has no parameter {name}; it has {known}")
            }
            Self::NoControlPoint { index, count } => {
                write!(f, "there is no control point {index}; there are {count}, counted from 0")
            }
            Self::ToleranceTooSmall { value, least } => {
                let [value, least] = [value, least].map(few_digits);
                write!(f, "tolerance is {value}, but doubles can keep no less than {least} here")
            }
            Self::CriticalTension { bias, tension, critical } => write!(
                f,
                "tension {tension} is the critical one for bias {bias}: the beta-spline does not exist at {critical}"
            ),
            Self::NotPiecewise { method } => {
                write!(f, "method {method} is made of arcs of its own and is for curves, not for nets")
            }
            Self::EndsNotOffered { method } => {
                write!(f, "method {method} has only its own open ends and the closed curve")
            }
            Self::Coefficient { name, harmonic, value } => write!(
                f,
                "{name} of harmonic {harmonic} is {value}, but must be a number of at most {COORDINATE_LIMIT:e}"
            ),
            Self::TooManyHarmonics { given, most } => {
                write!(f, "too many harmonics: {given} given, at most {most} allowed")
            }
            Self::NoLength => f.write_str("all points are the same; a closed path needs two different ones"),
            Self::Ragged { row, given, needed } => {
                write!(
                    f,
                    "row {} of the net has {given} points and row 1 has {needed}; all must have the same",
                    row + 1
                )
            }
            Self::TopologyNotOffered { method, topology } => {
                write!(f, "method {method} has no surface with the topology of a {topology}")
            }
            Self::OddMeridians { given } => write!(
                f,
                "{given} meridians, but this method joins each with the opposite one: their number must be even"
            ),
            Self::NormalCount { given: [rows, columns], needed: [n, m] } => write!(
                f,
                "the normals form a net of {rows} x {columns} and the points one of {n} x {m}; every point needs one normal"
            ),
            Self::NotUnit { row, column, length } => write!(
                f,
                "normal {} of row {} has the length {length}, but must be a unit vector (1 within 1e-6)",
                column + 1,
                row + 1
            ),
            Self::NormalUp { row, column } => write!(
                f,
                "normal {} of row {} is within 26 degrees of +z, where the method as printed fails; \
                 turn the data, or take the normalised method, which does",
                column + 1,
                row + 1
            ),
            Self::NormalsTooWide => f.write_str(
                "the normals point in too many directions for one surface: some direction is needed that all of them stay 26 degrees away from; \
                 cut the net into parts",
            ),
            Self::NormalsEqual => f.write_str(
                "all normals are the same, as those of a plane; normals are needed that turn along both directions of the net",
            ),
            Self::Parabolic { patch: [i, j] } => write!(
                f,
                "patch ({i}, {j}) is parabolic somewhere: its normals turn back or stay on a line; \
                 data are needed that curve in both directions everywhere, unlike a plane, a cylinder or the crest of a torus"
            ),
            Self::NoPositiveWeights { patch: [i, j] } => write!(
                f,
                "the weights of patch ({i}, {j}) are not all positive in 64 x 64 pieces; a finer net of points and normals is needed there"
            ),
            Self::NotRefinable { method, reason } => {
                write!(f, "a net of method {method} cannot be refined without changing the surface: {reason}")
            }
            Self::EqualNeighbours { number, next } => {
                write!(f, "points {number} and {next} are the same; successive points must differ")
            }
            Self::NoDirection { number } => {
                write!(f, "tangent {number} is zero; it must have a direction")
            }
            Self::NoPhCubic { number } => write!(
                f,
                "no PH cubic leaves point {number} and reaches the next one with these tangents: PH cubics have no \
                 inflection, so both tangents must point to the same side round the chord; PH quintics take any"
            ),
            Self::NotSolved { remainder } => write!(
                f,
                "the equations of the PH spline could not be solved (remainder {}); add points where the \
                 polygon turns sharply, or give tangents",
                few_digits(remainder)
            ),
            Self::Samples { per_span, most } => {
                write!(f, "{per_span} steps per span asked for, but 1 to {most} can be given")
            }
        }
    }
}

impl std::error::Error for GeometryError {}

/// A number in four digits; an exponent stands only where many zeros would.
pub(super) fn few_digits(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse().unwrap_or(value);
    in_digits(rounded)
}

/// A number in all its digits; an exponent stands only where many zeros would.
pub(super) fn in_digits(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-4..1e16).contains(&value.abs());
    // What is 0 has no sign.
    if plain { (value + 0.0).to_string() } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_say_what_was_given_and_what_is_right() {
        let text = GeometryError::TooFewPoints { given: 2, needed: 3 }.to_string();
        assert_eq!(text, "too few control points: 2 given, at least 3 needed");
        let text = GeometryError::CriticalTension { bias: 1.0, tension: -6.0, critical: -6.0 }.to_string();
        assert_eq!(text, "tension -6 is the critical one for bias 1: the beta-spline does not exist at -6");
        for (value, text) in [
            (5.471_635_994_339_879, "5.472"),
            (5.428_959_384_633_487e-7, "5.429e-7"),
            (20.0, "20"),
            (-0.0, "0"),
            (1e-300, "1e-300"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(few_digits(value), text);
        }
        let text = GeometryError::TooLarge { number: 7, value: 1e200 }.to_string();
        assert_eq!(text, "point 7 has the coordinate 1e200, larger than 1e150");
    }
}
