//! Surfaces behind their trait: the same doubles as ever, derivatives that belong to the points, and what a surface
//! that says only what it must can do. Surfaces by two bases agree with those of patches.

use grafika::figure::{FigureError, Mesh, surface_step};
use grafika::geometry::{
    Basis, Border, Closure, Derivatives, Ends, Method, ParamSurface, Plane, Point, Scheme, Surface,
    SurfaceSample, Topology, Weave, Weights, section,
};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// A net that every machine has the same doubles of.
fn net(rows: usize, columns: usize) -> Vec<Vec<Point<3>>> {
    let factors = [(37, 101), (53, 89), (71, 97)];
    let point = |i: usize| std::array::from_fn(|d| 0.7 * ((i * factors[d].0) % factors[d].1) as f64 - 20.0);
    (0..rows).map(|k| (0..columns).map(|l| point(k * columns + l)).collect()).collect()
}

/// Every method with parameters that are no special case.
const METHODS: [Method; 7] = [
    Method::Coons { k0: 0.625 },
    Method::Bezier,
    Method::Spline,
    Method::BSpline2,
    Method::BSpline3,
    Method::Beta { bias: 1.5, tension: 2.25 },
    Method::Local { k0: 0.375 },
];

const TOPOLOGIES: [Topology; 3] = [Topology::Open, Topology::Sphere, Topology::Torus];

/// The bits of numbers in one (FNV-1a).
fn digest(numbers: impl Iterator<Item = f64>) -> u64 {
    numbers
        .flat_map(|number| number.to_bits().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn numbers(sample: &SurfaceSample) -> impl Iterator<Item = f64> + use<> {
    sample.spans.map(|span| span as f64).into_iter().chain(sample.parameters).chain(sample.point)
}

/// Digests from the time when `Surface` was sampled by methods of its own (commit e85c4e1): of every method its
/// topologies; 0 where it has no such surface.
const DIGESTS: [[u64; 3]; 7] = [
    [0x662f_96cd_26e1_ef03, 0x1998_e7e4_10f8_1f74, 0xdd79_4396_d957_6a82],
    [0x5f33_518e_c550_e20c, 0, 0],
    [0x716c_c73f_1a26_e7bc, 0x7091_8eef_122b_92cb, 0xb794_0403_bddc_0b24],
    [0x24e7_7319_940f_b316, 0x6610_ec04_a33d_5e06, 0x4dff_20f1_f277_d5df],
    [0xf7ca_a05c_3c3b_0f80, 0xc3ec_cae5_d569_d48e, 0x30f8_732c_e73e_4c12],
    [0x505d_4590_da57_c27a, 0x8433_decf_6039_10a3, 0x4706_25e9_f8fe_bf1e],
    [0x5142_23f4_c8e4_ae0b, 0xaeed_1b2a_c19d_8bfb, 0x5140_4ce7_bac4_1c1b],
];

#[test]
fn surfaces_behind_the_trait_have_the_same_doubles_as_before() {
    for (method, want) in METHODS.into_iter().zip(DIGESTS) {
        for (topology, want) in TOPOLOGIES.into_iter().zip(want) {
            let scheme = Scheme { border: Border::Reached, ..Scheme::new(method, topology) };
            let got = Surface::new(scheme, &net(6, 5)).map_or(0, |surface| {
                let surface: &dyn ParamSurface = &surface;
                let samples = surface.sample(4).unwrap();
                let grid = surface.grid(5).unwrap();
                digest(samples.iter().flat_map(numbers).chain(grid.points().iter().flatten().copied()))
            });
            assert_eq!(got, want, "{method:?}, {topology:?}");
        }
    }
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn some_net() -> impl Strategy<Value = Vec<Vec<Point<3>>>> {
    prop::collection::vec(prop::collection::vec(prop::array::uniform3(-100.0..100.0), 5), 6)
}

fn method() -> impl Strategy<Value = Method> {
    prop::sample::select(METHODS.to_vec())
}

/// Any kind of surface.
fn any_surface() -> impl Strategy<Value = Box<dyn ParamSurface>> {
    let by_net = (method(), prop::sample::select(TOPOLOGIES.to_vec()), some_net()).prop_map(
        |(method, topology, net)| {
            let topology = if method == Method::Bezier { Topology::Open } else { topology };
            boxed(Surface::new(Scheme::new(method, topology), &net).unwrap())
        },
    );
    let woven = (0..6_usize, 0..6_usize, any::<[bool; 2]>(), some_net()).prop_map(|(u, v, closed, net)| {
        boxed(Weave::new(weights(u, closed[0], 6), weights(v, closed[1], 5), net).unwrap())
    });
    prop_oneof![by_net, woven, Just(()).prop_map(|()| boxed(Ball))]
}

/// The weights of one of the six piecewise methods.
fn weights(index: usize, closed: bool, points: usize) -> Weights {
    let method = METHODS.into_iter().filter(|method| *method != Method::Bezier).nth(index).unwrap();
    Weights::new(method, if closed { Closure::Closed } else { Closure::Open }, points).unwrap()
}

fn boxed(surface: impl ParamSurface + 'static) -> Box<dyn ParamSurface> {
    Box::new(surface)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn derivatives_agree_with_differences(
        surface in any_surface(), places in prop::array::uniform2(0.0..1.0), uv in prop::array::uniform2(0.01..0.99),
    ) {
        let counts = surface.spans();
        let spans = [0, 1].map(|d| ((places[d] * counts[d] as f64) as usize).min(counts[d] - 1));
        let h = 1e-5;
        let at = |du: f64, dv: f64| surface.at(spans, [uv[0] + du * h, uv[1] + dv * h]).unwrap();
        let here = at(0.0, 0.0);
        prop_assert!(distance(surface.eval(spans, uv).unwrap(), here.point) < 1e-11);
        let slope = |a: Point<3>, b: Point<3>| std::array::from_fn(|d| (a[d] - b[d]) / (2.0 * h));
        let ([east, west], [north, south]) = ([at(1.0, 0.0), at(-1.0, 0.0)], [at(0.0, 1.0), at(0.0, -1.0)]);
        for (got, want) in [
            (here.u, slope(east.point, west.point)),
            (here.v, slope(north.point, south.point)),
            (here.uu, slope(east.u, west.u)),
            (here.uv, slope(north.u, south.u)),
            (here.uv, slope(east.v, west.v)),
            (here.vv, slope(north.v, south.v)),
        ] {
            prop_assert!(distance(got, want) < 1e-2, "{got:?} {want:?}");
        }
        prop_assert_eq!(surface.at([counts[0], 0], uv), None);
        prop_assert_eq!(surface.at(spans, [f64::NAN, -1.0]), surface.at(spans, [0.0, 0.0]));
    }

    #[test]
    fn grids_have_the_points_of_their_lines(surface in any_surface(), steps in 1_usize..5) {
        let grid = surface.grid(steps).unwrap();
        let lines = [0, 1].map(|d| surface.lines(d, steps));
        let closed = surface.closed().map(usize::from);
        prop_assert_eq!([grid.rows(), grid.columns()], [lines[0].len() + closed[0], lines[1].len() + closed[1]]);
        for (k, &(i, u)) in lines[0].iter().enumerate() {
            for (l, &(j, v)) in lines[1].iter().enumerate() {
                let want = surface.eval([i, j], [u, v]).unwrap();
                prop_assert!(distance(grid.point(k, l).unwrap(), want) < 1e-10);
            }
        }
        for d in 0..2 {
            let middles = surface.line_places(d, steps);
            prop_assert_eq!(middles.len(), [grid.rows(), grid.columns()][d] - 1);
            for (&(span, middle), &(other, line)) in middles.iter().zip(&lines[d]) {
                prop_assert!(span == other && middle > line && middle < line + 1.0);
            }
        }
    }

    #[test]
    fn woven_bases_are_the_surface_of_patches(index in 0..6_usize, torus: bool, net in some_net()) {
        let along = |points| weights(index, torus, points);
        let method = METHODS.into_iter().filter(|method| *method != Method::Bezier).nth(index).unwrap();
        // Where the surface has other borders than the curve, they are asked for.
        let doubled = !torus && matches!(method, Method::BSpline2 | Method::BSpline3);
        let basis = |points| match doubled {
            true => Weights::with_ends(method, Ends::Doubled, points).unwrap(),
            false => along(points),
        };
        let topology = if torus { Topology::Torus } else { Topology::Open };
        let patches = Surface::new(Scheme::new(method, topology), &net).unwrap();
        let woven = Weave::new(basis(6), basis(5), net).unwrap();
        prop_assert_eq!((woven.spans(), woven.closed()), (patches.spans(), patches.closed()));
        for sample in patches.sample(3).unwrap() {
            let (a, b) = (patches.at(sample.spans, sample.parameters).unwrap(), woven.at(sample.spans, sample.parameters).unwrap());
            for (a, b) in [(a.point, b.point), (a.u, b.u), (a.v, b.v), (a.uu, b.uu), (a.uv, b.uv), (a.vv, b.vv)] {
                prop_assert!(distance(a, b) < 1e-9, "{a:?} {b:?}");
            }
        }
    }
}

/// A surface that says only what it must: the unit ball, once round in one span, from pole to pole in two.
#[derive(Debug)]
struct Ball;

impl ParamSurface for Ball {
    fn spans(&self) -> [usize; 2] {
        [1, 2]
    }

    fn closed(&self) -> [bool; 2] {
        [true, false]
    }

    fn at(&self, [i, j]: [usize; 2], uv: [f64; 2]) -> Option<Derivatives> {
        let [u, v] = uv.map(|x| if x > 0.0 { x.min(1.0) } else { 0.0 });
        // From above, the other way round: normals then look out.
        let ((s, c), (t, d)) = ((-TAU * u).sin_cos(), (0.5 * PI * (j as f64 + v)).sin_cos());
        let (a, b) = (-TAU, 0.5 * PI);
        let derivatives = Derivatives {
            point: [c * t, s * t, d],
            u: [-a * s * t, a * c * t, 0.0],
            v: [b * c * d, b * s * d, -b * t],
            uu: [-a * a * c * t, -a * a * s * t, 0.0],
            uv: [-a * b * s * d, a * b * c * d, 0.0],
            vv: [-b * b * c * t, -b * b * s * t, -b * b * d],
        };
        (i < 1 && j < 2).then_some(derivatives)
    }
}

#[test]
fn what_a_surface_does_not_say_itself_is_found() {
    let ball: &dyn ParamSurface = &Ball;
    let bounds = ball.bounding_box().unwrap();
    assert!(bounds.min.iter().chain(&bounds.max).all(|x| (x.abs() - 1.0).abs() < 0.01), "{bounds:?}");
    for (spans, uv) in
        [([0, 0], [0.3, 0.0]), ([0, 0], [0.3, 0.4]), ([0, 1], [0.9, 0.99]), ([0, 1], [0.0, 1.0])]
    {
        let point = ball.eval(spans, uv).unwrap();
        assert!(distance(ball.normal(spans, uv).unwrap(), point) < 1e-6, "{uv:?}");
        assert!((ball.gaussian_curvature(spans, uv).unwrap() - 1.0).abs() < 1e-4, "{uv:?}");
        assert!((ball.brightness(spans, uv, [0.0, 0.0, 9.0]).unwrap() - point[2]).abs() < 1e-6);
    }
    assert_eq!((ball.normal([1, 0], [0.5; 2]), ball.steps(0, 0, 7)), (None, 7));
    let circle = section(ball, Plane { normal: [0.0, 0.0, 1.0], offset: 0.6 }, 20).unwrap();
    assert!(circle.len() == 1 && circle[0].first() == circle[0].last());
    assert!(circle[0].iter().all(|[x, y, _]| (x.hypot(*y) - 0.8).abs() < 1e-9));
    let mesh = Mesh::from_grid(&ball.grid(40).unwrap()).unwrap();
    assert_eq!(mesh.closed_characteristic(), Some(2));
    assert!((mesh.volume() / (4.0 / 3.0 * PI) - 1.0).abs() < 0.01);
    let error = surface_step(ball, "ball").unwrap_err();
    assert!(error == FigureError::NoExactForm && error.to_string().contains(".obj"), "{error}");
}

#[test]
fn nets_that_do_not_belong_to_the_bases_are_errors() {
    let basis: Box<dyn Basis> = Box::new(weights(2, false, 4));
    assert!(Weave::new(&*basis, &basis, net(4, 4)).is_ok());
    assert!(Weave::new(&*basis, &basis, net(5, 4)).is_err());
    assert!(Weave::new(&*basis, &basis, net(4, 5)).is_err());
    let mut bad = net(4, 4);
    bad[2][1][0] = f64::NAN;
    assert!(Weave::new(&*basis, &basis, bad).is_err());
}
