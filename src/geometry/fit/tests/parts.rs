//! Evaluation, equations, solutions and feet of points, each against another way.

use super::super::axis::Axis;
use super::super::chart::Chart;
use super::super::cholesky::Cholesky;
use super::super::equations::Sums;
use super::super::gradients::Gradients;
use super::super::sheet::Sheet;
use super::super::{FitError, Fitted};
use super::{axes, nodes, shapes};
use crate::geometry::kohonen::{Net, Topology};
use crate::geometry::{Basis, ParamCurve, ParamSurface, Point, dot};
use proptest::prelude::*;

/// The values of all control points of a direction at a parameter, by the knot vector.
fn values(axis: &Axis, u: f64) -> Vec<f64> {
    let mut all = vec![0.0; axis.count()];
    if axis.is_point() {
        return vec![1.0];
    }
    let vector = axis.knots().unwrap();
    let span = vector.span_of(u).unwrap();
    let number = vector.filled_spans().iter().position(|j| *j == span).unwrap();
    let (from, to) = (vector.knots()[span], vector.knots()[span + 1]);
    let mut values = Vec::new();
    let first = vector.values(number, (u - from) / (to - from), &mut values).unwrap();
    for (l, value) in values.into_iter().enumerate() {
        // Counted from where a function begins, not from where its middle is.
        all[axis.node((first + l) % axis.count())] += value;
    }
    all
}

/// The solution of the normal equations by Gauss with pivots.
fn dense(mut rows: Vec<Vec<f64>>, mut right: Vec<Point<3>>) -> Vec<Point<3>> {
    let n = right.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs())).unwrap();
        rows.swap(k, pivot);
        right.swap(k, pivot);
        let (row, side) = (rows[k].clone(), right[k]);
        for i in k + 1..n {
            let factor = rows[i][k] / row[k];
            rows[i].iter_mut().zip(&row).skip(k).for_each(|(a, b)| *a -= factor * b);
            right[i] = std::array::from_fn(|d| right[i][d] - factor * side[d]);
        }
    }
    for k in (0..n).rev() {
        let known = (k + 1..n)
            .fold([0.0; 3], |sum: Point<3>, j| std::array::from_fn(|d| sum[d] + rows[k][j] * right[j][d]));
        right[k] = std::array::from_fn(|d| (right[k][d] - known[d]) / rows[k][k]);
    }
    right
}

/// The control points that the definition asks for, from rows of the overdetermined system.
fn by_definition(topology: Topology, axes: &[Axis; 2], points: &[([f64; 2], Point<3>)]) -> Vec<Point<3>> {
    let [m, n] = [axes[0].count(), axes[1].count()];
    // The unknown of a control point: one for every pole.
    let unknown = |i: usize, j: usize| match topology {
        Topology::Sphere if i == 0 => 0,
        Topology::Sphere => (i - 1).min(m - 2) * n + 1 + if i + 1 == m { 0 } else { j },
        _ => i * n + j,
    };
    let count = unknown(m - 1, n - 1) + 1;
    let mut equations: Vec<(Vec<f64>, Point<3>)> = Vec::new();
    for ([u, v], point) in points {
        let (along, across) = (values(&axes[0], *u), values(&axes[1], *v));
        let mut row = vec![0.0; count];
        for i in 0..m {
            for j in 0..n {
                row[unknown(i, j)] += along[i] * across[j];
            }
        }
        equations.push((row, *point));
    }
    let weight = (1e-6 * points.len() as f64).sqrt();
    for i in 0..m {
        for j in 0..n {
            for (direction, index) in [i, j].into_iter().enumerate() {
                let axis = &axes[direction];
                let (Some(before), Some(after)) = (axis.beside(index, -1), axis.beside(index, 1)) else {
                    continue;
                };
                let at = |k: usize| if direction == 0 { unknown(k, j) } else { unknown(i, k) };
                let mut row = vec![0.0; count];
                row[at(before)] += weight;
                row[at(index)] -= 2.0 * weight;
                row[at(after)] += weight;
                equations.push((row, [0.0; 3]));
            }
        }
    }
    let mut matrix = vec![vec![0.0; count]; count];
    let mut right = vec![[0.0; 3]; count];
    for (row, point) in &equations {
        for a in 0..count {
            for b in 0..count {
                matrix[a][b] += row[a] * row[b];
            }
            right[a] = std::array::from_fn(|d| right[a][d] + row[a] * point[d]);
        }
    }
    let solution = dense(matrix, right);
    (0..m).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| solution[unknown(i, j)]).collect()
}

fn apart(a: &[Point<3>], b: &[Point<3>]) -> f64 {
    a.iter().zip(b).flat_map(|(a, b)| [0, 1, 2].map(|d| (a[d] - b[d]).abs())).fold(0.0, f64::max)
}

/// Points with parameters, most of them everywhere, some in one corner.
fn data() -> impl Strategy<Value = Vec<([f64; 2], Point<3>)>> {
    let parameters = prop_oneof![
        3 => proptest::array::uniform2(0.0..1.0),
        1 => proptest::array::uniform2(prop_oneof![Just(0.0), Just(0.125), 0.9..1.0]),
    ];
    proptest::collection::vec((parameters, proptest::array::uniform3(-1.0..1.0)), 150..250)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_sheet_is_its_knot_surface(
        ((topology, size), nodes) in shapes().prop_flat_map(|(t, s)| (Just((t, s)), nodes(t, s))),
        places in proptest::collection::vec(proptest::array::uniform2(0.0..1.0), 1..20),
    ) {
        let axes = axes(topology, size);
        let sheet = Sheet::new(&axes, &nodes);
        let fitted = Fitted::of(&axes, &nodes).unwrap();
        for [u, v] in places.into_iter().chain([[0.0, 0.0], [1.0, 1.0], [0.5, 0.25]]) {
            // The end of a closed direction is its beginning.
            let inside = [axes[0].inside(u), axes[1].inside(v)];
            let place = sheet.at(inside);
            let expected = match &fitted {
                Fitted::Surface(surface) => surface.point_at(inside),
                Fitted::Curve(curve) => curve.point_at(if size[0] == 1 { inside[1] } else { inside[0] }),
            };
            prop_assert!(apart(&[place.point], &[expected.unwrap()]) < 1e-13);
            // Tangents by differences, as far as these go.
            let step = 1e-5;
            let inner = [u.clamp(0.01, 0.98), v.clamp(0.01, 0.98)];
            let place = sheet.at(inner);
            for (direction, tangent) in [place.u, place.v].into_iter().enumerate() {
                let [mut before, mut after] = [inner; 2];
                before[direction] -= step;
                after[direction] += step;
                let (a, b) = (sheet.at(before).point, sheet.at(after).point);
                let slope: Point<3> = std::array::from_fn(|d| (b[d] - a[d]) / (2.0 * step));
                // Where a knot lies between them, the second derivative has a corner.
                prop_assert!(apart(&[slope], &[tangent]) < 1e-5 * 300.0, "{:?} {:?}", slope, tangent);
            }
        }
    }

    #[test]
    fn solutions_are_those_of_the_definition(
        (topology, size) in shapes(),
        points in data(),
        start in proptest::array::uniform3(-1.0..1.0),
    ) {
        let axes = axes(topology, size);
        let expected = by_definition(topology, &axes, &points);
        let size_of = expected.iter().flatten().fold(1.0_f64, |most, x| most.max(x.abs()));
        // From anywhere.
        let nodes = vec![start; expected.len()];
        let mut sums = Sums::new(&axes);
        for (parameters, point) in &points {
            sums.add(&axes, *parameters, *point);
        }
        let moved = |moves: Vec<Point<3>>| -> Vec<Point<3>> {
            nodes.iter().zip(moves).map(|(a, b)| std::array::from_fn(|d| a[d] + b[d])).collect()
        };
        let poles = topology == Topology::Sphere && size[1] > 1;
        let mut gradients = Gradients::new(&axes, sums.equations(&axes, &nodes), poles);
        let moves = loop {
            if let Some(moves) = gradients.advance(&axes) {
                break moves;
            }
        };
        let error = apart(&moved(moves), &expected) / size_of;
        prop_assert!(error < 1e-7, "gradients: {:e}", error);
        if !axes.iter().any(Axis::closed) && !poles {
            let mut cholesky = Cholesky::new(&axes, &sums.equations(&axes, &nodes));
            let moves = loop {
                if let Some(moves) = cholesky.advance() {
                    break moves;
                }
            };
            let error = apart(&moved(moves), &expected) / size_of;
            prop_assert!(error < 1e-7, "Cholesky: {:e}", error);
        }
    }

    #[test]
    fn feet_are_never_farther_than_before(
        ((topology, size), nodes) in shapes().prop_flat_map(|(t, s)| (Just((t, s)), nodes(t, s))),
        at in proptest::array::uniform2(0.0..1.0),
        point in proptest::array::uniform3(-2.0..2.0),
    ) {
        let axes = axes(topology, size);
        let sheet = Sheet::new(&axes, &nodes);
        let at = [axes[0].inside(at[0]), axes[1].inside(at[1])];
        let distance = |at: [f64; 2]| {
            let place = sheet.at(at);
            let way: Point<3> = std::array::from_fn(|d| point[d] - place.point[d]);
            dot(way, way).sqrt()
        };
        let foot = sheet.foot(point, at);
        prop_assert!(foot.distance.abs() <= distance(at));
        prop_assert!((foot.distance.abs() - distance(foot.parameters)).abs() < 1e-14);
        prop_assert!(foot.parameters.iter().all(|u| (0.0..=1.0).contains(u)));
        // Repeated, it ends where the way stands on the surface, or at a border.
        let mut end = foot;
        for _ in 0..200 {
            end = sheet.foot(point, end.parameters);
        }
        prop_assert!(end.distance.abs() <= foot.distance.abs());
    }
}

/// A net like a hill, where parameters can be found by trying.
fn hill(topology: Topology, [m, n]: [usize; 2]) -> Vec<Vec<Point<3>>> {
    let angle = |k: usize, count: usize| std::f64::consts::TAU * k as f64 / count as f64;
    let place = |i: usize, j: usize| {
        let (x, y) = (i as f64 / (m - 1) as f64, j as f64 / n as f64);
        match topology {
            Topology::Open => [x, y, x * (1.0 - x) * (1.0 + y)],
            Topology::Cylinder => [angle(j, n).cos(), angle(j, n).sin(), x],
            Topology::Torus => {
                let r = 1.0 + 0.4 * angle(i, m).cos();
                [r * angle(j, n).cos(), r * angle(j, n).sin(), 0.4 * angle(i, m).sin()]
            }
            Topology::Sphere => {
                let latitude = std::f64::consts::PI * x;
                let r = latitude.sin();
                [r * angle(j, n).cos(), r * angle(j, n).sin(), latitude.cos()]
            }
        }
    };
    (0..m).map(|i| (0..n).map(|j| place(i, j)).collect()).collect()
}

#[test]
fn first_parameters_are_the_nearest_place_of_the_cells() {
    for topology in Topology::ALL {
        let size = [6, 7];
        let (axes, rows) = (axes(topology, size), hill(topology, size));
        let mut chart = Chart::new(&axes, topology, &rows).unwrap();
        let bilinear = |[u, v]: [f64; 2]| -> Point<3> {
            let edges = [0, 1].map(|d| if axes[d].closed() { size[d] } else { size[d] - 1 });
            let (x, y) = (u * edges[0] as f64, v * edges[1] as f64);
            let (i, j) = ((x as usize).min(edges[0] - 1), (y as usize).min(edges[1] - 1));
            let (s, t) = (x - i as f64, y - j as f64);
            let corner = |a: usize, b: usize| rows[(i + a) % size[0]][(j + b) % size[1]];
            std::array::from_fn(|d| {
                (1.0 - s) * ((1.0 - t) * corner(0, 0)[d] + t * corner(0, 1)[d])
                    + s * ((1.0 - t) * corner(1, 0)[d] + t * corner(1, 1)[d])
            })
        };
        let distance = |at: [f64; 2], point: Point<3>| {
            let place = bilinear(at);
            let way: Point<3> = std::array::from_fn(|d| point[d] - place[d]);
            dot(way, way).sqrt()
        };
        for k in 0..60 {
            let (u, v) = (f64::from(k * 7 % 60) / 60.0, f64::from(k * 11 % 60) / 60.0);
            let place = bilinear([u, v]);
            let point: Point<3> =
                std::array::from_fn(|d| place[d] + 0.03 * f64::from((k * (d as i32 + 3)) % 7 - 3) / 3.0);
            let found = chart.parameters(&axes, point);
            let steps = 240;
            let tried = (0..=steps).flat_map(|a| (0..=steps).map(move |b| [a, b]));
            let least = tried
                .map(|at| distance(at.map(|k| f64::from(k) / f64::from(steps)), point))
                .fold(f64::INFINITY, f64::min);
            let own = distance(found, point);
            assert!(own < least + 1e-6, "{} {k}: {own} {least}", topology.name());
        }
    }
}

#[test]
fn the_base_surface_has_the_neurons_as_control_points() {
    for topology in Topology::ALL {
        let net = Net::new(topology, &hill(topology, [6, 7])).unwrap();
        let Fitted::Surface(surface) = Fitted::of_net(&net).unwrap() else { panic!("a surface") };
        assert_eq!(surface.closed(), topology.closed());
        assert_eq!((surface.net().len(), surface.net()[0].len()), (6, 7));
        let [rows, columns] = topology.closed().map(usize::from);
        // A knot vector counts a closed row of control points from its last.
        assert_eq!(surface.net()[rows][columns], net.point([0, 0]));
        let [u, v] = surface.vectors();
        if !topology.closed()[0] {
            assert_eq!(u.knots(), [0.0, 0.0, 0.0, 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0, 1.0, 1.0, 1.0]);
        }
        assert_eq!((u.domain(), v.domain()), ([0.0, 1.0], [0.0, 1.0]));
    }
    let polygon = Net::new(Topology::Open, &[vec![[0.0; 3], [1.0; 3], [2.0; 3], [2.0, 3.0, 4.0]]]).unwrap();
    let fitted = Fitted::of_net(&polygon).unwrap();
    assert!(fitted.surface().is_none());
    let curve = fitted.curve().unwrap();
    assert_eq!((curve.eval(0, 0.0), curve.eval(0, 1.0)), (Some([0.0; 3]), Some([2.0, 3.0, 4.0])));
}

#[test]
fn small_nets_are_told() {
    for size in [[3, 9], [9, 2], [1, 3], [1, 1]] {
        let rows = vec![vec![[0.0; 3]; size[1]]; size[0]];
        let error = Fitted::of_net(&Net::new(Topology::Open, &rows).unwrap()).unwrap_err();
        assert_eq!(error, FitError::Net { given: size });
    }
    assert_eq!(
        FitError::Net { given: [3, 9] }.to_string(),
        "a net of 3 x 9 neurons makes no cubic surface; at least 4 rows and 4 columns are needed, or one of them for a curve"
    );
}
