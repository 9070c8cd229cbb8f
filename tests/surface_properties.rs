//! Properties of surfaces by any net: smooth joints, seams and poles, interpolation, hulls, symmetry, and
//! grids without cracks.

use grafika::geometry::{Border, Derivatives, Method, ParamSurface, Point, Scheme, Surface, Topology};
use proptest::prelude::*;

type Net = Vec<Vec<Point<3>>>;

const SIZE: f64 = 1000.0;
const TOLERANCE: f64 = 1e-12 * SIZE;

/// Nets of an even number of rows, at times with coinciding points, rows and columns, or flat.
fn net() -> impl Strategy<Value = Net> {
    let point = || [-SIZE..SIZE, -SIZE..SIZE, -SIZE..SIZE];
    let shape = (2_usize..5, 3_usize..7);
    let any = shape.prop_flat_map(move |(half, columns)| {
        prop::collection::vec(prop::collection::vec(point(), columns), 2 * half)
    });
    (any, 0_u8..6).prop_map(|(mut net, kind)| {
        match kind {
            1 => net[1] = net[0].clone(),
            2 => net.iter_mut().for_each(|row| row[2] = row[1]),
            3 => net[2][1] = net[1][1],
            4 => net.iter_mut().flatten().for_each(|p| p[2] = 250.0),
            _ => {}
        }
        net
    })
}

fn poled(mut net: Net) -> Net {
    let last = net[0].len() - 1;
    let poles = [net[0][0], net[0][last]];
    net.iter_mut().for_each(|row| (row[0], row[last]) = (poles[0], poles[1]));
    net
}

fn fitted(net: Net, topology: Topology) -> Net {
    if topology == Topology::Sphere { poled(net) } else { net }
}

fn kinds() -> impl Strategy<Value = [Method; 2]> {
    let beta = || (0.4..2.5, 0.0..9.0).prop_map(|(bias, tension)| Method::Beta { bias, tension });
    let local = || (-2.0..2.0).prop_map(|k0| Method::Local { k0 });
    prop_oneof![
        Just([Method::Spline; 2]),
        Just([Method::BSpline2; 2]),
        Just([Method::BSpline3; 2]),
        [beta(), beta()],
        [local(), local()],
        (-2.0..2.0).prop_map(|k0| [Method::Coons { k0 }; 2]),
    ]
}

fn scheme() -> impl Strategy<Value = Scheme> {
    let topology = prop_oneof![Just(Topology::Open), Just(Topology::Sphere), Just(Topology::Torus)];
    let border = prop_oneof![Just(Border::Doubled), Just(Border::Reached)];
    (kinds(), topology, border).prop_map(|([u, v], topology, border)| Scheme { u, v, topology, border })
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    (0..3).map(|d| (a[d] - b[d]).abs()).fold(0.0, f64::max)
}

fn dot(a: Point<3>, b: Point<3>) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross(a: Point<3>, b: Point<3>) -> Point<3> {
    std::array::from_fn(|d| a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3])
}

fn scaled(k: f64, a: Point<3>) -> Point<3> {
    a.map(|x| k * x)
}

/// What follows behind a joint from the first and second derivatives before it: `first r'` and
/// `first² r'' + second r'` (2.61)-(2.62); no law for the second where `None`.
fn law(method: Method) -> (f64, Option<f64>) {
    match method {
        Method::Spline | Method::BSpline3 => (1.0, Some(0.0)),
        Method::Beta { bias, tension } => (bias, Some(2.0 * tension)),
        _ => (1.0, None),
    }
}

/// Point, first and second derivative across a joint.
type Jet = [Point<3>; 3];

fn jet(at: &Derivatives, direction: usize, length: f64) -> Jet {
    let (first, second) = if direction == 0 { (at.u, at.uu) } else { (at.v, at.vv) };
    [at.point, scaled(1.0 / length, first), scaled(1.0 / (length * length), second)]
}

/// The curvature vector of the line across the joint.
fn curvature([_, first, second]: Jet) -> Point<3> {
    let speed = dot(first, first);
    scaled(1.0 / (speed * speed), cross(cross(first, second), first))
}

fn check_joint(method: Method, before: Jet, after: Jet) -> Result<(), TestCaseError> {
    prop_assert!(distance(before[0], after[0]) < TOLERANCE);
    let (first, second) = law(method);
    prop_assert!(distance(scaled(first, before[1]), after[1]) < 100.0 * TOLERANCE);
    let Some(second) = second else { return Ok(()) };
    let bend = std::array::from_fn(|d| first * first * before[2][d] + second * before[1][d]);
    prop_assert!(distance(bend, after[2]) < 1000.0 * TOLERANCE);
    let speed = dot(before[1], before[1]).sqrt();
    if speed > 0.1 * SIZE {
        let unit = |v: Point<3>| scaled(1.0 / dot(v, v).sqrt(), v);
        prop_assert!(distance(unit(before[1]), unit(after[1])) < 1e-11);
        prop_assert!(distance(curvature(before), curvature(after)) < 1e-11);
    }
    Ok(())
}

/// The joints of one direction, the seam too, at several places along them.
fn check_joints(scheme: Scheme, surface: &Surface, direction: usize) -> Result<(), TestCaseError> {
    let spans = surface.spans();
    let lengths = surface.lengths(direction);
    let method = if direction == 0 { scheme.u } else { scheme.v };
    let joints = spans[direction] - usize::from(!surface.closed()[direction]);
    for s in 0..joints {
        let next = (s + 1) % spans[direction];
        for t in 0..spans[1 - direction] {
            for place in [0.0, 0.4, 1.0] {
                let at = |span: usize, end: f64| {
                    let derivatives = match direction {
                        0 => surface.at([span, t], [end, place]),
                        _ => surface.at([t, span], [place, end]),
                    };
                    jet(&derivatives.unwrap(), direction, lengths[span])
                };
                check_joint(method, at(s, 1.0), at(next, 0.0))?;
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn joints_and_seams_are_smooth(scheme in scheme(), net in net()) {
        let surface = Surface::new(scheme, &fitted(net, scheme.topology)).unwrap();
        check_joints(scheme, &surface, 0)?;
        check_joints(scheme, &surface, 1)?;
    }

    /// A meridian and the opposite one are one curve: r_v turns round, r_vv stays.
    #[test]
    fn interpolating_surfaces_go_smoothly_over_the_poles(
        net in net(), k0 in -2.0..2.0_f64, spline: bool, u in 0.0..1.0_f64,
    ) {
        let method = if spline { Method::Spline } else { Method::Local { k0 } };
        let surface = Surface::new(Scheme::new(method, Topology::Sphere), &poled(net)).unwrap();
        let [rows, columns] = surface.spans();
        for (j, v) in [(0, 0.0), (columns - 1, 1.0)] {
            for i in 0..rows {
                let here = surface.at([i, j], [u, v]).unwrap();
                let there = surface.at([(i + rows / 2) % rows, j], [u, v]).unwrap();
                prop_assert!(distance(here.point, there.point) < TOLERANCE);
                prop_assert!(distance(here.v, scaled(-1.0, there.v)) < 10.0 * TOLERANCE);
                if spline {
                    prop_assert!(distance(here.vv, there.vv) < 100.0 * TOLERANCE);
                }
            }
        }
    }

    /// At the pole of a beta-spline the tangents of all meridians add up to nothing; by a flat ring round the
    /// pole they lie in its plane.
    #[test]
    fn beta_surfaces_are_balanced_at_the_poles(
        net in net(), bias in 0.4..2.5_f64, tension in 0.0..9.0_f64, flat: bool, u in 0.0..1.0_f64,
    ) {
        let mut net = poled(net);
        if flat {
            for row in &mut net {
                let [x, y, _] = row[1];
                row[1] = [x, y, 0.3 * x - 0.7 * y + 55.0];
            }
        }
        let scheme = Scheme { v: Method::Beta { bias, tension }, ..Scheme::new(Method::BSpline3, Topology::Sphere) };
        let surface = Surface::new(scheme, &net).unwrap();
        let rows = surface.spans()[0];
        for (j, v) in [(0, 0.0), (surface.spans()[1] - 1, 1.0)] {
            let tangents: Vec<Point<3>> =
                (0..rows).map(|i| surface.at([i, j], [u, v]).unwrap().v).collect();
            let sum = tangents.iter().fold([0.0; 3], |sum, t| std::array::from_fn(|d| sum[d] + t[d]));
            prop_assert!(distance(sum, [0.0; 3]) < 100.0 * TOLERANCE);
            if flat && j == 0 {
                for t in tangents {
                    prop_assert!((0.3 * t[0] - 0.7 * t[1] - t[2]).abs() < 10.0 * TOLERANCE);
                }
            }
        }
    }

    #[test]
    fn interpolating_surfaces_pass_through_their_nets(scheme in scheme(), net in net()) {
        prop_assume!(scheme.u.interpolates());
        let net = fitted(net, scheme.topology);
        let surface = Surface::new(scheme, &net).unwrap();
        let [rows, columns] = surface.spans();
        for (k, row) in net.iter().enumerate() {
            for (l, &p) in row.iter().enumerate() {
                let (i, u) = if k < rows { (k, 0.0) } else { (k - 1, 1.0) };
                let (j, v) = if l < columns { (l, 0.0) } else { (l - 1, 1.0) };
                prop_assert!(distance(surface.eval([i, j], [u, v]).unwrap(), p) < TOLERANCE);
            }
        }
    }

    #[test]
    fn maps_of_nets_are_maps_of_surfaces(
        scheme in scheme(), net in net(), m in prop::array::uniform3(prop::array::uniform3(-2.0..2.0_f64)),
        shift in prop::array::uniform3(-SIZE..SIZE),
    ) {
        let net = fitted(net, scheme.topology);
        let map = |p: Point<3>| -> Point<3> { std::array::from_fn(|d| dot(m[d], p) + shift[d]) };
        let mapped: Net = net.iter().map(|row| row.iter().map(|&p| map(p)).collect()).collect();
        let (a, b) = (Surface::new(scheme, &net).unwrap(), Surface::new(scheme, &mapped).unwrap());
        for (a, b) in a.sample(2).unwrap().iter().zip(b.sample(2).unwrap()) {
            prop_assert!(distance(map(a.point), b.point) < 20.0 * TOLERANCE);
        }
    }

    #[test]
    fn surfaces_keep_within_their_nets(scheme in scheme(), net in net(), bezier: bool, way in [-1.0..1.0, -1.0..1.0, -1.0..1.0]) {
        let scheme = if bezier { Scheme::new(Method::Bezier, Topology::Open) } else { scheme };
        prop_assume!(!scheme.u.interpolates());
        let net = fitted(net, scheme.topology);
        let reach = |points: &mut dyn Iterator<Item = Point<3>>| {
            points.map(|p| dot(p, way)).fold(f64::NEG_INFINITY, f64::max)
        };
        let surface = Surface::new(scheme, &net).unwrap();
        let ours = reach(&mut surface.grid(5).unwrap().points().iter().copied());
        prop_assert!(ours <= reach(&mut net.into_iter().flatten()) + TOLERANCE);
        let bounds = surface.bounding_box().unwrap();
        let samples = surface.sample(3).unwrap();
        let inside = |x: f64, d: usize| bounds.min[d] - TOLERANCE <= x && x <= bounds.max[d] + TOLERANCE;
        let all_inside = samples.iter().all(|s| (0..3).all(|d| inside(s.point[d], d)));
        prop_assert!(all_inside);
    }

    #[test]
    fn an_open_net_turned_over_is_the_surface_turned_over(scheme in scheme(), net in net(), bezier: bool) {
        let scheme = match bezier {
            true => Scheme::new(Method::Bezier, Topology::Open),
            false => Scheme { topology: if scheme.topology == Topology::Sphere { Topology::Open } else { scheme.topology }, ..scheme },
        };
        let turned: Net = (0..net[0].len()).map(|l| net.iter().map(|row| row[l]).collect()).collect();
        let (a, b) = (
            Surface::new(scheme, &net).unwrap(),
            Surface::new(Scheme { u: scheme.v, v: scheme.u, ..scheme }, &turned).unwrap(),
        );
        for s in a.sample(3).unwrap() {
            let ([i, j], [u, v]) = (s.spans, s.parameters);
            prop_assert!(distance(s.point, b.eval([j, i], [v, u]).unwrap()) < TOLERANCE);
        }
    }

    /// Rows in the opposite order are the surface in the opposite direction; for beta-splines with the inverse
    /// bias and the tension over its cube.
    #[test]
    fn a_net_run_through_backwards_is_the_surface_backwards(scheme in scheme(), net in net(), along_v: bool) {
        let net = fitted(net, scheme.topology);
        let mirrored = |method: Method| match method {
            Method::Beta { bias, tension } => {
                Method::Beta { bias: 1.0 / bias, tension: tension / bias.powi(3) }
            }
            method => method,
        };
        let (mut back, mut other) = (net.clone(), scheme);
        if along_v {
            back.iter_mut().for_each(|row| row.reverse());
            other.v = mirrored(scheme.v);
        } else {
            back.reverse();
            other.u = mirrored(scheme.u);
        }
        let (a, b) = (Surface::new(scheme, &net).unwrap(), Surface::new(other, &back).unwrap());
        let method = if along_v { scheme.v } else { scheme.u };
        let direction = usize::from(along_v);
        // The cubic span from point s to the next becomes the one before; a quadratic span stays round its point.
        let spans = a.spans()[direction];
        let shift = usize::from(a.closed()[direction] && method != Method::BSpline2);
        let place = |s: usize| (2 * spans - 1 - shift - s) % spans;
        for s in a.sample(3).unwrap() {
            let ([i, j], [u, v]) = (s.spans, s.parameters);
            let there = match along_v {
                true => b.eval([i, place(j)], [u, 1.0 - v]),
                false => b.eval([place(i), j], [1.0 - u, v]),
            };
            prop_assert!(distance(s.point, there.unwrap()) < TOLERANCE, "{s:?} {there:?}");
        }
    }

    #[test]
    fn grids_have_no_cracks(scheme in scheme(), net in net(), steps in 1_usize..7) {
        let surface = Surface::new(scheme, &fitted(net, scheme.topology)).unwrap();
        let grid = surface.grid(steps).unwrap();
        let (last_row, last_column) = (grid.rows() - 1, grid.columns() - 1);
        let same = |a: (usize, usize), b: (usize, usize)| {
            distance(grid.point(a.0, a.1).unwrap(), grid.point(b.0, b.1).unwrap()) < TOLERANCE
        };
        let [in_u, in_v] = grid.closed();
        prop_assert_eq!([in_u, in_v], [scheme.topology != Topology::Open, scheme.topology == Topology::Torus]);
        if in_u {
            prop_assert!((0..=last_column).all(|l| same((0, l), (last_row, l))));
        }
        if in_v {
            prop_assert!((0..=last_row).all(|k| same((k, 0), (k, last_column))));
        }
        // The doubled ends of the cubic B-spline leave a hole, as the original's did.
        let hole = scheme.v == Method::BSpline3 && scheme.border == Border::Doubled;
        if scheme.topology == Topology::Sphere && !hole {
            for l in [0, last_column] {
                prop_assert!((1..=last_row).all(|k| same((0, l), (k, l))));
            }
        }
        prop_assert!(grid.points().iter().flatten().all(|x| x.is_finite()));
    }

    /// A grid shows what evaluation gives.
    #[test]
    fn grids_are_evaluations(scheme in scheme(), net in net(), bezier: bool, steps in 1_usize..5) {
        let scheme = if bezier { Scheme::new(Method::Bezier, Topology::Open) } else { scheme };
        let surface = Surface::new(scheme, &fitted(net, scheme.topology)).unwrap();
        // Even, so that half spans have half as many.
        let grid = surface.grid(2 * steps).unwrap();
        let places = |direction: usize, lines: usize| -> Vec<(usize, f64)> {
            let lengths = surface.lengths(direction);
            let cells = if bezier { lines - 1 } else { 2 * steps };
            let mut places: Vec<(usize, f64)> = Vec::new();
            for (span, length) in lengths.iter().enumerate() {
                let count = (cells as f64 * length) as usize;
                places.extend((0..count).map(|step| (span, step as f64 / count as f64)));
            }
            places.push((lengths.len() - 1, 1.0));
            places
        };
        let (rows, columns) = (places(0, grid.rows()), places(1, grid.columns()));
        prop_assert_eq!([rows.len(), columns.len()], [grid.rows(), grid.columns()]);
        for (k, &(i, u)) in rows.iter().enumerate() {
            for (l, &(j, v)) in columns.iter().enumerate() {
                prop_assert!(distance(grid.point(k, l).unwrap(), surface.eval([i, j], [u, v]).unwrap()) < TOLERANCE);
            }
        }
    }
}

#[test]
fn nets_of_one_point_are_that_point() {
    let p = [12.0, -7.5, 3.25];
    for topology in [Topology::Open, Topology::Sphere, Topology::Torus] {
        for method in [
            Method::Spline,
            Method::BSpline2,
            Method::BSpline3,
            Method::Local { k0: 0.5 },
            Method::Beta { bias: 0.3, tension: 7.0 },
        ] {
            let surface = Surface::new(Scheme::new(method, topology), &vec![vec![p; 5]; 6]).unwrap();
            assert!(surface.grid(3).unwrap().points().iter().all(|&q| distance(p, q) < 1e-13), "{method:?}");
        }
    }
}
