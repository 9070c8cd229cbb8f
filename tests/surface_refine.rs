//! A refined net is the same surface, under the mapping of the parameters that `refine` states.

use grafika::geometry::{
    Border, GeometryError, Method, ParamSurface, Point, RefineDirection, Scheme, Surface, Topology, refine,
};
use proptest::prelude::*;

type Net = Vec<Vec<Point<3>>>;

const SIZE: f64 = 1000.0;

fn net(topology: Topology) -> impl Strategy<Value = Net> {
    let point = || [-SIZE..SIZE, -SIZE..SIZE, -SIZE..SIZE];
    let shape = (2_usize..5, 3_usize..7).prop_map(|(half, columns)| (2 * half, columns));
    let points = shape.prop_flat_map(move |(rows, columns)| {
        prop::collection::vec(prop::collection::vec(point(), columns), rows)
    });
    points.prop_map(move |mut net: Net| {
        if topology == Topology::Sphere {
            let poles = [net[0][0], *net[0].last().unwrap()];
            for row in &mut net {
                let last = row.len() - 1;
                (row[0], row[last]) = (poles[0], poles[1]);
            }
        }
        net
    })
}

fn topology() -> impl Strategy<Value = Topology> {
    prop_oneof![Just(Topology::Open), Just(Topology::Sphere), Just(Topology::Torus)]
}

fn direction() -> impl Strategy<Value = RefineDirection> {
    prop_oneof![Just(RefineDirection::U), Just(RefineDirection::V), Just(RefineDirection::Both)]
}

/// Methods with the borders by which they can be refined.
fn refinable() -> impl Strategy<Value = (Method, Border)> {
    prop_oneof![
        Just((Method::Spline, Border::Doubled)),
        Just((Method::BSpline2, Border::Doubled)),
        Just((Method::BSpline2, Border::Reached)),
        Just((Method::BSpline3, Border::Reached)),
        Just((Method::Beta { bias: 1.0, tension: 0.0 }, Border::Doubled)),
    ]
}

/// Where place `u` of a span is in the refined direction.
fn mapped(surface: &Surface, direction: usize, span: usize, u: f64) -> (usize, f64) {
    let lengths = surface.lengths(direction);
    // Straight end spans: the quarter at the border, and the square root from there.
    if lengths[span] == 0.5 && span == 0 {
        return if u < 0.25 { (0, 4.0 * u) } else { (1, 2.0 * u.sqrt() - 1.0) };
    }
    if lengths[span] == 0.5 {
        let w = 1.0 - u;
        return if w < 0.25 { (2 * span + 1, 1.0 - 4.0 * w) } else { (2 * span, 2.0 - 2.0 * w.sqrt()) };
    }
    if u < 0.5 { (2 * span, 2.0 * u) } else { (2 * span + 1, 2.0 * u - 1.0) }
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    (0..3).map(|d| (a[d] - b[d]).abs()).fold(0.0, f64::max)
}

/// The largest distance of places that belong to each other.
fn deviation(scheme: Scheme, net: &Net, direction: RefineDirection) -> f64 {
    let coarse = Surface::new(scheme, net).unwrap();
    let fine = Surface::new(scheme, &refine(scheme, net, direction).unwrap()).unwrap();
    let [in_u, in_v] = [direction != RefineDirection::V, direction != RefineDirection::U];
    let doubled = |spans: usize, finer: bool| if finer { 2 * spans } else { spans };
    let [rows, columns] = coarse.spans();
    assert_eq!(fine.spans(), [doubled(rows, in_u), doubled(columns, in_v)]);
    let off = |s: &grafika::geometry::SurfaceSample| {
        let (mut i, mut j, [mut u, mut v]) = (s.spans[0], s.spans[1], s.parameters);
        if in_u {
            (i, u) = mapped(&coarse, 0, i, u);
        }
        if in_v {
            (j, v) = mapped(&coarse, 1, j, v);
        }
        distance(fine.eval([i, j], [u, v]).unwrap(), s.point)
    };
    coarse.sample(5).unwrap().iter().map(off).fold(0.0, f64::max)
}

fn check((topology, net): (Topology, Net), kind: [(Method, Border); 2], direction: RefineDirection) -> f64 {
    let [(u, border_u), (v, border_v)] = kind;
    let border = if border_u == border_v { border_u } else { Border::Reached };
    deviation(Scheme { u, v, topology, border }, &net, direction)
}

fn closed_net() -> impl Strategy<Value = (Topology, Net)> {
    topology().prop_flat_map(|topology| net(topology).prop_map(move |net| (topology, net)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn finer_nets_are_the_same_surface(
        net in closed_net(), u in refinable(), v in refinable(), direction in direction(),
    ) {
        let off = check(net, [u, v], direction);
        prop_assert!(off < 1e-12 * SIZE, "{off:e}");
    }

    #[test]
    fn doubled_cubics_are_refined_in_closed_directions(net in net(Topology::Torus)) {
        let torus = Scheme::new(Method::BSpline3, Topology::Torus);
        prop_assert!(deviation(torus, &net, RefineDirection::Both) < 1e-12 * SIZE);
        let sphere = Scheme::new(Method::BSpline3, Topology::Sphere);
        prop_assert!(deviation(sphere, &net, RefineDirection::U) < 1e-12 * SIZE);
        for (scheme, direction) in [
            (sphere, RefineDirection::V),
            (sphere, RefineDirection::Both),
            (Scheme { topology: Topology::Open, ..sphere }, RefineDirection::U),
        ] {
            let error = refine(scheme, &net, direction);
            let refused = matches!(error, Err(GeometryError::NotRefinable { method: "bspline3", .. }));
            prop_assert!(refused);
        }
    }

    #[test]
    fn raised_bezier_nets_are_the_same_patch(net in net(Topology::Open), direction in direction()) {
        let scheme = Scheme::new(Method::Bezier, Topology::Open);
        let (coarse, finer) = (Surface::new(scheme, &net).unwrap(), refine(scheme, &net, direction).unwrap());
        let more = |yes: bool| usize::from(yes);
        prop_assert_eq!(finer.len(), net.len() + more(direction != RefineDirection::V));
        prop_assert_eq!(finer[0].len(), net[0].len() + more(direction != RefineDirection::U));
        let fine = Surface::new(scheme, &finer).unwrap();
        for (a, b) in coarse.sample(7).unwrap().iter().zip(fine.sample(7).unwrap()) {
            prop_assert!(distance(a.point, b.point) < 1e-12 * SIZE);
        }
    }
}

#[test]
fn refining_again_and_again_approaches_the_surface() {
    let mut net: Net =
        (0..4).map(|k| (0..4).map(|l| [k as f64, l as f64, (k * l) as f64]).collect()).collect();
    let scheme = Scheme { border: Border::Reached, ..Scheme::new(Method::BSpline3, Topology::Open) };
    for _ in 0..6 {
        net = refine(scheme, &net, RefineDirection::Both).unwrap();
    }
    let surface = Surface::new(scheme, &net).unwrap();
    for (k, row) in net.iter().enumerate().take(net.len() - 1) {
        for (l, &p) in row.iter().enumerate().take(row.len() - 1) {
            assert!(distance(surface.eval([k, l], [0.0, 0.0]).unwrap(), p) < 1e-3);
        }
    }
}

#[test]
fn what_cannot_be_refined_says_why() {
    let net: Net = (0..4).map(|k| (0..4).map(|l| [k as f64, l as f64, 1.0]).collect()).collect();
    for method in
        [Method::Local { k0: 0.5 }, Method::Coons { k0: 1.0 }, Method::Beta { bias: 1.0, tension: 1.0 }]
    {
        let error = refine(Scheme::new(method, Topology::Torus), &net, RefineDirection::Both).unwrap_err();
        let text = error.to_string();
        assert!(text.contains(method.name()) && text.contains("without changing the surface: "), "{text}");
    }
    let ragged = [vec![[0.0; 3]; 3], vec![[0.0; 3]; 2]];
    let error = refine(Scheme::new(Method::Spline, Topology::Open), &ragged, RefineDirection::U);
    assert!(matches!(error, Err(GeometryError::Ragged { .. })));
    let empty = refine(Scheme::new(Method::Spline, Topology::Open), &[], RefineDirection::U);
    assert!(matches!(empty, Err(GeometryError::TooFewPoints { .. })));
}
