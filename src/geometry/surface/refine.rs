//! Finer nets of the same surface: knots inserted in the middle of all spans of a B-spline or a spline, the
//! degree of a Bézier net raised.
//!
//! The finer net is one for the same scheme, so that it can be edited on. That asks more than knot insertion,
//! which would give points for any end rule: the points beyond the border that the scheme adds to the finer
//! net by itself have to be those that knot insertion gives. Where they are not, there is no finer net, as
//! four points of a uniform cubic B-spline are fixed by its span: this is an error that says so.

use super::weave::one_pole;
use super::{Border, Scheme, Surface, Topology};
use crate::geometry::point::{add_scaled, lerp};
use crate::geometry::{Ends, GeometryError, Method, Point, Weights};

/// The directions in which a net is refined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RefineDirection {
    /// More rows.
    U,
    /// More points in every row.
    V,
    /// Both.
    Both,
}

type Line = Vec<Point<3>>;
type Net = Vec<Line>;

/// What becomes of a line of `n` points of the net.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// Quadratic B-spline: `2 n` points, a quarter of the way to the neighbours.
    Quadratic,
    /// Cubic B-spline: the points moved towards their neighbours, and the middles between.
    Cubic,
    /// Spline: the points, and points of the curve between.
    Spline,
    /// Bézier curve: `n + 1` points of one degree more.
    Elevation,
}

/// How a line ends.
#[derive(Clone, Copy, Debug)]
enum Closing {
    /// The first point follows the last.
    Closed,
    /// From this first to this last point of the finer line.
    Between(Point<3>, Point<3>),
}

/// A net of the same scheme and the same surface with more points.
///
/// A span becomes two: parameter `u` of span `s` is `2 u` of span `2 s` up to the middle, `2 u - 1` of span
/// `2 s + 1` after it. Only the end spans of a quadratic B-spline between borders, which run evenly through a
/// straight piece, are parted at a quarter from the border: place `u` of the first span is `4 u` of the new
/// first one, then `2 sqrt(u) - 1` of the second; the last span mirrors it. A Bézier net keeps its one span and
/// its parameters, and has one degree more in the directions named.
///
/// - Quadratic B-splines: everywhere.
/// - Cubic B-splines: in closed directions, and between borders and poles with [`Border::Reached`]; as that is
///   the beta-spline with bias 1 and tension 0, this one too.
/// - Interpolating splines: everywhere; the points between are those of the surface.
/// - Bézier nets: by raising the degree.
///
/// Nets whose border points are auxiliary ([`Border::Inner`]) have none.
///
/// ```
/// use grafika::geometry::{Method, ParamSurface, RefineDirection, Scheme, Surface, Topology, refine};
///
/// let net: Vec<Vec<[f64; 3]>> =
///     (0..4).map(|k| (0..3).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
/// let scheme = Scheme::new(Method::Spline, Topology::Open);
/// let finer = refine(scheme, &net, RefineDirection::U)?;
/// assert_eq!((finer.len(), finer[0].len()), (7, 3));
/// let (before, after) = (Surface::new(scheme, &net)?, Surface::new(scheme, &finer)?);
/// assert_eq!(before.eval([1, 0], [0.5, 0.0]), after.eval([3, 0], [0.0, 0.0]));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
///
/// # Errors
/// As [`Surface::new`]; [`GeometryError::NotRefinable`] for other methods, and for cubic B-splines with doubled
/// border points in a direction that has borders: the border point of the finer net and its double would have
/// to be two different points.
pub fn refine(
    scheme: Scheme,
    net: &[Vec<Point<3>>],
    direction: RefineDirection,
) -> Result<Vec<Vec<Point<3>>>, GeometryError> {
    Surface::new(scheme, net)?;
    let mut finer = one_pole(scheme.topology, net).unwrap_or_else(|| net.to_vec());
    if direction != RefineDirection::U {
        finer = finer_rows(scheme, &finer)?;
    }
    if direction != RefineDirection::V {
        let rule = rule(scheme.u, scheme, scheme.topology != Topology::Open)?;
        let finer_column = |column: &Line| {
            let closing = if scheme.topology == Topology::Open { open(column) } else { Closing::Closed };
            rule.apply(column, closing)
        };
        let columns: Result<Net, _> = transposed(&finer).iter().map(finer_column).collect();
        finer = transposed(&columns?);
    }
    // Whatever is handed out is a good net.
    Surface::new(scheme, &finer).map(|_| finer)
}

/// More points in every row.
fn finer_rows(scheme: Scheme, net: &[Line]) -> Result<Net, GeometryError> {
    let rule = rule(scheme.v, scheme, scheme.topology == Topology::Torus)?;
    let free = scheme.border == Border::Free;
    match (scheme.topology, rule) {
        (Topology::Sphere, Rule::Spline) if !free => finer_rings(net),
        (Topology::Sphere, Rule::Cubic) if !free => {
            let closing = finer_poles(net);
            net.iter().map(|row| rule.apply(row, closing)).collect()
        }
        (Topology::Torus, _) => net.iter().map(|row| rule.apply(row, Closing::Closed)).collect(),
        _ => net.iter().map(|row| rule.apply(row, open(row))).collect(),
    }
}

/// What becomes of the lines of one direction.
fn rule(method: Method, scheme: Scheme, closed: bool) -> Result<Rule, GeometryError> {
    let auxiliary = scheme.border == Border::Inner && scheme.topology == Topology::Open;
    let reason = match method {
        Method::BSpline2 | Method::BSpline3 | Method::Beta { .. } if auxiliary => {
            "its border points are auxiliary ones, and those of the finer net would lie inside of them"
        }
        Method::Bezier => return Ok(Rule::Elevation),
        Method::Spline => return Ok(Rule::Spline),
        Method::BSpline2 => return Ok(Rule::Quadratic),
        Method::BSpline3 if closed || scheme.border == Border::Reached => return Ok(Rule::Cubic),
        Method::BSpline3 => {
            "with doubled border points only closed directions have a finer net; with the border reached all have"
        }
        Method::Beta { bias: 1.0, tension: 0.0 } => return Ok(Rule::Cubic),
        Method::Beta { .. } => "the joint in the middle of a span would need bias 1 and tension 0",
        Method::Arcs => "it is for curves, not for nets",
        Method::Coons { .. } | Method::Local { .. } => {
            "its tangents come from neighbours, which would be others in the finer net"
        }
    };
    Err(GeometryError::NotRefinable { method: method.name(), reason })
}

/// An open line from its first to its last point.
fn open(line: &[Point<3>]) -> Closing {
    match line {
        [first, .., last] => Closing::Between(*first, *last),
        _ => Closing::Closed,
    }
}

impl Rule {
    fn apply(self, line: &[Point<3>], closing: Closing) -> Result<Line, GeometryError> {
        match self {
            Self::Quadratic => Ok(quarters(line, closing)),
            Self::Cubic => Ok(eighths(line, closing)),
            Self::Spline => with_middles(line, closing),
            Self::Elevation => Ok(elevated(line)),
        }
    }
}

/// Every point with the one before it, in a closed line with the last.
fn neighbours(line: &[Point<3>]) -> impl Iterator<Item = (Point<3>, Point<3>)> + '_ {
    line.iter().copied().zip(line.iter().copied().cycle().skip(1))
}

/// A quarter of every leg is cut off on both sides (Chaikin). An end that is doubled stays, and its double
/// is the double of the finer line.
fn quarters(line: &[Point<3>], closing: Closing) -> Line {
    let mut finer: Line = neighbours(line).flat_map(|(a, b)| [lerp(a, b, 0.25), lerp(a, b, 0.75)]).collect();
    match closing {
        // The last leg leads back to the first point; what is a quarter before that begins the line.
        Closing::Closed => finer.rotate_right(1),
        Closing::Between(first, last) => {
            finer.truncate(finer.len().saturating_sub(2));
            finer.insert(0, first);
            finer.push(last);
        }
    }
    finer
}

/// Knots inserted in the middle of the spans of a cubic B-spline: a point moves a quarter of the way to the
/// middle between its neighbours.
fn eighths(line: &[Point<3>], closing: Closing) -> Line {
    let before = line.iter().cycle().skip(line.len().saturating_sub(1));
    let moved = |before: Point<3>, p: Point<3>, next: Point<3>| lerp(p, lerp(before, next, 0.5), 0.25);
    let mut finer: Line = before
        .zip(neighbours(line))
        .flat_map(|(&before, (p, next))| [moved(before, p, next), lerp(p, next, 0.5)])
        .collect();
    if let Closing::Between(first, last) = closing {
        // No leg leads from the last point to the first, which were moved by each other.
        finer.pop();
        if let [start, .., end] = finer.as_mut_slice() {
            (*start, *end) = (first, last);
        }
    }
    finer
}

/// The points of a spline's knots and the points in the middle of its spans.
fn with_middles(line: &[Point<3>], closing: Closing) -> Result<Line, GeometryError> {
    let (ends, last) = match closing {
        Closing::Closed => (Ends::Closed, None),
        Closing::Between(_, last) => (Ends::Open, Some(last)),
    };
    let arcs = Weights::with_ends(Method::Spline, ends, line.len())?.arcs(line)?;
    Ok(arcs.iter().flat_map(|arc| [arc.p[0], arc.eval(0.5)]).chain(last).collect())
}

/// The control points of the same Bézier curve with one degree more.
fn elevated(line: &[Point<3>]) -> Line {
    let degree = line.len() as f64;
    let inner = neighbours(line).take(line.len().saturating_sub(1));
    let inner = inner.enumerate().map(|(k, (a, b))| lerp(b, a, (k + 1) as f64 / degree));
    line.first().copied().into_iter().chain(inner).chain(line.last().copied()).collect()
}

/// The meridians of a spline's sphere, each with the opposite one a closed line.
fn finer_rings(net: &[Line]) -> Result<Net, GeometryError> {
    let (front, back) = net.split_at(net.len() / 2);
    let (mut near, mut far) = (Net::new(), Net::new());
    for (meridian, opposite) in front.iter().zip(back) {
        let spans = meridian.len().saturating_sub(1);
        let inner = opposite.get(1..spans).unwrap_or_default();
        let ring: Line = meridian.iter().chain(inner.iter().rev()).copied().collect();
        let mut finer = with_middles(&ring, Closing::Closed)?;
        let start = finer.first().copied();
        // The south pole ends one meridian and, read backwards, the other.
        let returning = finer.get(2 * spans..).unwrap_or_default().iter().copied().chain(start);
        far.push(returning.rev().collect());
        finer.truncate(2 * spans + 1);
        near.push(finer);
    }
    near.append(&mut far);
    Ok(near)
}

/// The poles of the finer net: a quarter of the way to the mean of the ring beside them, for the auxiliary
/// points beyond a pole (3.51, 3.56) mirror that ring.
fn finer_poles(net: &[Line]) -> Closing {
    let mean = |at: &dyn Fn(&Line) -> Option<Point<3>>| {
        let sum = net.iter().filter_map(at).fold([0.0; 3], |sum, p| add_scaled(sum, 1.0, p));
        sum.map(|x| x / net.len().max(1) as f64)
    };
    let [north, south] =
        [mean(&|row| row.get(1).copied()), mean(&|row| row.get(row.len().checked_sub(2)?).copied())];
    match net.first().map(Vec::as_slice) {
        Some([first, .., last]) => Closing::Between(lerp(*first, north, 0.25), lerp(*last, south, 0.25)),
        _ => Closing::Closed,
    }
}

fn transposed(net: &[Line]) -> Net {
    let columns = net.first().map_or(0, Vec::len);
    (0..columns).map(|l| net.iter().filter_map(|row| row.get(l).copied()).collect()).collect()
}
