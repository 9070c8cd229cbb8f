//! From a net to patches: weights along `v` for every row, then weights along `u` for every column of the
//! results. What happens at borders, poles and seams is decided here and nowhere else.

use super::Patch;
use super::scheme::{Border, Direction, Scheme, Topology};
use crate::geometry::point::add_scaled;
use crate::geometry::{CubicBezier, Ends, GeometryError, Method, Point, Weights};

/// The neutral beta-spline, which is the cubic B-spline with the auxiliary border points of the other.
const NEUTRAL: Method = Method::Beta { bias: 1.0, tension: 0.0 };

/// The patches of a checked net, row by row, and their two directions.
pub(super) fn patches(
    scheme: Scheme,
    net: &[Vec<Point<3>>],
) -> Result<(Vec<Patch>, [Direction; 2]), GeometryError> {
    let one_pole = one_pole(scheme.topology, net);
    let (rows, v) = along_v(scheme, one_pole.as_deref().unwrap_or(net))?;
    let (method, ends) = match scheme.topology {
        Topology::Open => between_borders(scheme.u, scheme.border),
        Topology::Sphere | Topology::Torus => (scheme.u, Ends::Closed),
    };
    let weights = Weights::with_ends(method, ends, rows.len())?;
    let u = direction(&weights, method, ends);
    let mut patches = vec![Patch { p: [[[0.0; 3]; 4]; 4] }; u.spans * v.spans];
    for j in 0..v.spans {
        for c in 0..4 {
            let column: Vec<Point<3>> =
                rows.iter().filter_map(|row| row.get(j).map(|arc| arc.p[c])).collect();
            for (i, arc) in weights.arcs(&column)?.into_iter().enumerate() {
                if let Some(patch) = patches.get_mut(i * v.spans + j) {
                    for (row, point) in patch.p.iter_mut().zip(arc.p) {
                        row[c] = point;
                    }
                }
            }
        }
    }
    Ok((patches, [u, v]))
}

/// The net of a sphere with the poles of its first row in every row: files in single precision have them
/// apart by rounding, and the surface shall have no gap there.
pub(super) fn one_pole(topology: Topology, net: &[Vec<Point<3>>]) -> Option<Vec<Vec<Point<3>>>> {
    let poles = [net.first()?.first().copied()?, net.first()?.last().copied()?];
    if topology != Topology::Sphere {
        return None;
    }
    let mut net = net.to_vec();
    for row in &mut net {
        if let [first, .., last] = row.as_mut_slice() {
            [*first, *last] = poles;
        }
    }
    Some(net)
}

type Rows = Vec<Vec<CubicBezier<3>>>;

/// The arcs in `v` of every row of the net.
fn along_v(scheme: Scheme, net: &[Vec<Point<3>>]) -> Result<(Rows, Direction), GeometryError> {
    let (method, ends) = match (scheme.topology, scheme.v) {
        (Topology::Open, method) => between_borders(method, scheme.border),
        (Topology::Torus, method) => (method, Ends::Closed),
        (Topology::Sphere, Method::BSpline3) if scheme.border == Border::Free => {
            return with_triple_poles(scheme.v, net);
        }
        (Topology::Sphere, method) if scheme.border == Border::Free => between_borders(method, scheme.border),
        (Topology::Sphere, Method::Spline | Method::Local { .. } | Method::Coons { .. }) => {
            return over_the_poles(scheme.v, net);
        }
        (Topology::Sphere, Method::BSpline3) if scheme.border == Border::Reached => {
            return with_poles(1.0, NEUTRAL, net);
        }
        (Topology::Sphere, Method::Beta { bias, .. }) => return with_poles(bias, scheme.v, net),
        (Topology::Sphere, method) => (method, Ends::Doubled),
    };
    let weights = Weights::with_ends(method, ends, net.first().map_or(0, Vec::len))?;
    let rows: Result<Rows, _> = net.iter().map(|row| weights.arcs(row)).collect();
    Ok((rows?, direction(&weights, method, ends)))
}

/// The method and ends of an open direction.
fn between_borders(method: Method, border: Border) -> (Method, Ends) {
    match (method, border) {
        (Method::BSpline3, Border::Reached) => (NEUTRAL, Ends::Open),
        (Method::BSpline2 | Method::BSpline3 | Method::Beta { .. }, Border::Inner) => {
            (method, Ends::Auxiliary)
        }
        (Method::BSpline2 | Method::BSpline3, _) => (method, Ends::Doubled),
        _ => (method, Ends::Open),
    }
}

fn direction(weights: &Weights, method: Method, ends: Ends) -> Direction {
    Direction {
        spans: weights.spans(),
        cells: 1,
        half_ends: method == Method::BSpline2 && ends == Ends::Doubled,
        closed: ends == Ends::Closed,
        smoothness: smoothness(method),
    }
}

/// How many derivatives by the parameter are continuous from span to span.
fn smoothness(method: Method) -> usize {
    match method {
        Method::Spline | Method::BSpline3 => 2,
        method if method == NEUTRAL => 2,
        // Of bias 1, so that the tangents keep their lengths.
        Method::Beta { bias: 1.0, .. } => 1,
        Method::Beta { .. } | Method::Bezier | Method::Arcs => 0,
        Method::BSpline2 | Method::Local { .. } | Method::Coons { .. } => 1,
    }
}

/// The poles of a cubic B-spline count three times (3.40): every meridian reaches them straight, for itself.
fn with_triple_poles(method: Method, net: &[Vec<Point<3>>]) -> Result<(Rows, Direction), GeometryError> {
    let columns = net.first().map_or(0, Vec::len);
    let weights = Weights::with_ends(method, Ends::Doubled, columns.saturating_add(2))?;
    let framed = |row: &Vec<Point<3>>| -> Vec<Point<3>> {
        row.first().into_iter().chain(row).chain(row.last()).copied().collect()
    };
    let rows: Result<Rows, _> = net.iter().map(|row| weights.arcs(&framed(row))).collect();
    Ok((rows?, direction(&weights, method, Ends::Doubled)))
}

/// A meridian goes on over both poles as the opposite one, and both are one closed curve (3.64-3.67).
fn over_the_poles(method: Method, net: &[Vec<Point<3>>]) -> Result<(Rows, Direction), GeometryError> {
    let columns = net.first().map_or(0, Vec::len);
    if !net.len().is_multiple_of(2) {
        return Err(GeometryError::OddMeridians { given: net.len() });
    }
    let spans = columns.saturating_sub(1);
    let weights = Weights::with_ends(method, Ends::Closed, spans.saturating_mul(2))?;
    let (mut near, mut far) = (Rows::new(), Rows::new());
    let (front, back) = net.split_at(net.len() / 2);
    for (meridian, opposite) in front.iter().zip(back) {
        let inner = opposite.get(1..spans).unwrap_or_default();
        let ring: Vec<Point<3>> = meridian.iter().chain(inner.iter().rev()).copied().collect();
        let mut arcs = weights.arcs(&ring)?;
        let returning = arcs.split_off(spans.min(arcs.len()));
        near.push(arcs);
        far.push(returning.iter().rev().map(CubicBezier::reversed).collect());
    }
    near.append(&mut far);
    Ok((near, Direction { spans, cells: 1, half_ends: false, closed: false, smoothness: smoothness(method) }))
}

/// Auxiliary points beyond the poles, one for each meridian, such that the tangents of the surface at a pole
/// sum to zero, and lie in one plane if the points around the pole do (3.51-3.56).
fn with_poles(bias: f64, method: Method, net: &[Vec<Point<3>>]) -> Result<(Rows, Direction), GeometryError> {
    method.check()?;
    let cube = bias * bias * bias;
    let columns = net.first().map_or(0, Vec::len);
    let weights = Weights::with_ends(method, Ends::Auxiliary, columns.saturating_add(2))?;
    // Weights::with_ends asked for 4 points or more, so that both poles have a neighbour.
    let ring_mean = |l: usize| {
        let sum = net.iter().filter_map(|row| row.get(l)).fold([0.0; 3], |sum, &p| add_scaled(sum, 1.0, p));
        sum.map(|x| x / net.len() as f64)
    };
    let pole = |l: usize| net.first().and_then(|row| row.get(l)).copied().unwrap_or([0.0; 3]);
    let (first, last) = (0, columns.saturating_sub(1));
    // The centres c_N and c_S, whose sums of weights are bias³ + 1.
    let scaled = |factor: f64, point: Point<3>| point.map(|x| factor * x);
    let north = add_scaled(scaled(bias + 1.0, ring_mean(first + 1)), bias * (bias * bias - 1.0), pole(first));
    let south = add_scaled(
        scaled(bias * bias * (bias + 1.0), ring_mean(last.saturating_sub(1))),
        1.0 - bias * bias,
        pole(last),
    );
    let rows: Result<Rows, _> = net
        .iter()
        .map(|row| {
            let (after, before) = match row.as_slice() {
                [_, after, .., before, _] => (*after, *before),
                [_, only, _] => (*only, *only),
                [a, b] => (*b, *a),
                _ => ([0.0; 3], [0.0; 3]),
            };
            let beyond_north = scaled(1.0 / cube, add_scaled(north, -1.0, after));
            let beyond_south = add_scaled(south, -cube, before);
            let framed: Vec<Point<3>> = std::iter::once(beyond_north)
                .chain(row.iter().copied())
                .chain(std::iter::once(beyond_south))
                .collect();
            weights.arcs(&framed)
        })
        .collect();
    Ok((rows?, direction(&weights, method, Ends::Auxiliary)))
}
