//! The examples and figures of Róth's thesis and the curves and surfaces it names, as tests of spaces, exact
//! descriptions, order elevation and subdivision.

use grafika::design::ec::{Bases, EcArc, EcWeave};
use grafika::file::Document;
use grafika::file::ec::{
    Coefficients, CurveTerm, EcCurve, EcDocument, EcPatch, Interval, Item, PatchTerm, values,
};
use grafika::geometry::ec::{EcBasis, EcError, Real, Root, Space};
use grafika::geometry::{Basis, Blend, ParamCurve, ParamSurface, Point};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

fn space(roots: &str) -> Space {
    roots.parse().unwrap()
}

fn real(text: &str) -> Real {
    Real::typed(text).unwrap()
}

fn interval([start, end]: [&str; 2]) -> Interval {
    [real(start), real(end)]
}

/// The zigzag of so many points that stands where the thesis gives no control points.
fn zigzag(count: usize) -> Vec<Point<3>> {
    let y = [0.0, 25.0, -10.0, 30.0, 5.0, -20.0, 15.0];
    let z = [0.0, 5.0, 20.0, -5.0];
    (0..count).map(|i| [10.0 * i as f64, y[i % 7], z[i % 4]]).collect()
}

fn arc(roots: &str, ends: [&str; 2], points: Vec<Point<3>>) -> EcCurve {
    let (space, interval) = (space(roots), interval(ends));
    EcCurve { space, interval, points, exact: None, style: Default::default(), name: None }
}

#[track_caller]
fn assert_near(found: &[Point<3>], expected: &[Point<3>], error: f64) {
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().flatten().fold(1.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!((0..3).all(|d| (a[d] - b[d]).abs() <= error * size), "{a:?} {b:?}");
    }
}

/// A curve at `s` of its interval.
fn at(curve: &EcArc, s: f64) -> Point<3> {
    curve.eval(0, s).unwrap()
}

fn blending(roots: &str, [start, end]: [f64; 2], s: f64) -> Vec<f64> {
    let mut out = Vec::new();
    EcBasis::new(&space(roots), [start, end]).unwrap().derivatives(0, s, &mut out);
    out
}

#[test]
fn figure_1_1_bernstein() {
    for (i, s, height) in [(0, 0.0, 1.0), (1, 1.0 / 3.0, 4.0 / 9.0), (2, 2.0 / 3.0, 4.0 / 9.0), (3, 1.0, 1.0)]
    {
        let value = |s: f64| blending("0^4", [0.0, 1.0], s)[i];
        assert!((value(s) - height).abs() < 1e-15);
        assert!([-1e-3, 1e-3].iter().all(|d| !(0.0..=1.0).contains(&(s + d)) || value(s + d) < value(s)));
    }
}

#[test]
fn examples_1_4_and_1_5_have_their_equations_and_symmetry() {
    let at8 = space("0^3,i^2,2i");
    assert_eq!(at8.equation("v"), "v(9) + 6 v(7) + 9 v(5) + 4 v(3) = 0");
    let ae5 = space("0^2,1^2,2^2");
    assert_eq!(ae5.equation("v"), "v(6) - 6 v(5) + 13 v(4) - 12 v(3) + 4 v'' = 0");
    for k in 0..=40 {
        let s = f64::from(k) / 40.0;
        let [one, other] = [s, 1.0 - s].map(|s| blending("0^3,i^2,2i", [-FRAC_PI_2, FRAC_PI_2], s));
        assert!(one.iter().zip(other.iter().rev()).all(|(a, b)| (a - b).abs() < 1e-15));
    }
    let [one, other] = [0.2, 0.8].map(|s| blending("0^2,1^2,2^2", [-1.0, 1.0], s));
    assert!(one.iter().zip(other.iter().rev()).any(|(a, b)| (a - b).abs() > 0.01));
}

#[test]
fn figure_1_4_longer_intervals_give_flatter_curves() {
    let points = vec![[0.0, 0.0, 0.0], [50.0, 100.0, 0.0], [100.0, 0.0, 0.0]];
    for (end, height) in [("0.1", 49.969), ("1", 46.740), ("1.5", 42.253), ("2", 35.078)] {
        let curve = Bases::default().arc(&arc("0,i", ["0", end], points.clone())).unwrap();
        let middle = at(&curve, 0.5);
        assert!((middle[0] - 50.0).abs() < 1e-12 && (middle[1] - height).abs() < 5e-4, "{middle:?}");
    }
}

#[test]
fn figure_1_5_an_elevated_curve_is_the_same() {
    let mut bases = Bases::default();
    let low = arc("0^3,1", ["0", "1"], zigzag(4));
    let high = bases.elevated_curve(&low, &Root::zero(1)).unwrap();
    assert_near(
        &high.points,
        &[
            [0.0, 0.0, 0.0],
            [7.280544128827668, 18.20136032206917, 3.640272064413834],
            [14.671350458358287, 8.650273395746, 12.007025687537428],
            [22.218971492320755, -1.124114030716979, 14.452571269198112],
            [30.0, 30.0, -5.0],
        ],
        1e-14,
    );
    assert_eq!(high.space, space("0^4,1"));
    let curves = [bases.arc(&low).unwrap(), bases.arc(&high).unwrap()];
    for k in 0..=50 {
        let [a, b] = curves.each_ref().map(|curve| at(curve, f64::from(k) / 50.0));
        assert_near(&[b], &[a], 1e-14);
    }
}

#[test]
fn figure_1_6_a_divided_curve_is_two_arcs_of_the_same() {
    let mut bases = Bases::default();
    let whole = arc("0^3,i", ["0", "pi/2"], zigzag(5));
    let halves = bases.divided(&Item::Curve(whole.clone()), 0, &[real("pi/6")]).unwrap();
    let whole = bases.arc(&whole).unwrap();
    let [Item::Curve(left), Item::Curve(right)] = &halves[..] else { panic!("two curves") };
    assert_eq!((left.points.len(), right.points.len()), (5, 5));
    let meeting = at(&whole, 1.0 / 3.0);
    assert_near(&[left.points[4], right.points[0]], &[meeting; 2], 1e-14);
    assert_near(
        &left.points,
        &[
            [0.0, 0.0, 0.0],
            [3.2117941681322932, 8.029485420330733, 1.6058970840661466],
            [6.481658303497146, 9.787224904802576, 4.310315960738621],
            [9.813749663630725, 9.9117701138963, 6.3246856210340505],
            [13.208837914195119, 9.939792648916995, 7.245656126089766],
        ],
        1e-14,
    );
    assert_near(
        &right.points[1..],
        &[
            [20.093499371327532, 9.99661758321909, 9.113227650411355],
            [26.85694932179398, 9.658796908258868, 6.4433191780921515],
            [33.48702776314955, 21.282430592126136, -3.256486118425227],
            [40.0, 5.0, 0.0],
        ],
        1e-14,
    );
    let curves = [left, right].map(|half| bases.arc(half).unwrap());
    for k in 0..=30 {
        let s = f64::from(k) / 30.0;
        assert_near(&[at(&curves[0], s)], &[at(&whole, s / 3.0)], 1e-14);
        assert_near(&[at(&curves[1], s)], &[at(&whole, (1.0 + 2.0 * s) / 3.0)], 1e-14);
    }
}

/// One way to write a coefficient: the function's number and x, y, z.
type Term<N> = (N, [&'static str; 3]);

fn of_curve(roots: &str, ends: [&str; 2], terms: &[Term<usize>]) -> Coefficients {
    let term = |&(function, value): &Term<usize>| CurveTerm { function, value: value.map(real) };
    let coefficients = terms.iter().map(term).collect();
    Coefficients::Curve { space: space(roots), interval: interval(ends), coefficients }
}

fn of_surface([u, v]: [(&str, [&str; 2]); 2], terms: &[Term<[usize; 2]>]) -> Coefficients {
    let term = |&([u, v], value): &Term<[usize; 2]>| PatchTerm { u, v, value: value.map(real) };
    Coefficients::Surface {
        space_u: space(u.0),
        interval_u: interval(u.1),
        space_v: space(v.0),
        interval_v: interval(v.1),
        coefficients: terms.iter().map(term).collect(),
    }
}

/// Describes a curve in parts and compares all of them with a form of the parameter.
#[track_caller]
fn assert_curve(coefficients: &Coefficients, parts: Option<usize>, form: impl Fn(f64) -> Point<3>) -> usize {
    let mut bases = Bases::default();
    let items = bases.strips(coefficients, [parts, None]).unwrap();
    for item in &items {
        let Item::Curve(curve) = item else { panic!("a curve") };
        let [start, end] = values(&curve.interval);
        let arc = bases.arc(curve).unwrap();
        for k in 0..=40 {
            let s = f64::from(k) / 40.0;
            assert_near(&[at(&arc, s)], &[form(start + s * (end - start))], 2e-14);
        }
    }
    items.len()
}

/// The same of a surface.
#[track_caller]
fn assert_surface(
    coefficients: &Coefficients,
    parts: [Option<usize>; 2],
    form: impl Fn(f64, f64) -> Point<3>,
) -> Vec<EcPatch> {
    let mut bases = Bases::default();
    let items = bases.strips(coefficients, parts).unwrap();
    let patches: Vec<EcPatch> = items
        .into_iter()
        .map(|item| match item {
            Item::Patch(patch) => patch,
            Item::Curve(_) => panic!("a patch"),
        })
        .collect();
    for patch in &patches {
        let weave = bases.weave(patch).unwrap();
        let [us, vs] = [&patch.interval_u, &patch.interval_v].map(values);
        for k in 0..=8 {
            for l in 0..=8 {
                let [s, t] = [k, l].map(|k| f64::from(k) / 8.0);
                let place = form(us[0] + s * (us[1] - us[0]), vs[0] + t * (vs[1] - vs[0]));
                assert_near(&[point(&weave, s, t)], &[place], 2e-14);
            }
        }
    }
    patches
}

fn point(weave: &EcWeave, s: f64, t: f64) -> Point<3> {
    weave.eval([0, 0], [s, t]).unwrap()
}

#[test]
fn a_circle_and_an_ellipse_in_three_arcs() {
    let ellipse = of_curve("0,i", ["0", "2*pi"], &[(1, ["5", "0", "0"]), (2, ["0", "3", "0"])]);
    let arcs = assert_curve(&ellipse, None, |u| [5.0 * u.cos(), 3.0 * u.sin(), 0.0]);
    assert_eq!(arcs, 3);
}

#[test]
fn a_helix_and_a_cycloid() {
    let helix = [(2, ["2", "0", "0"]), (3, ["0", "2", "0"]), (1, ["0", "0", "1/2"])];
    let helix = of_curve("0^2,i", ["0", "5"], &helix);
    assert_curve(&helix, Some(1), |u| [2.0 * u.cos(), 2.0 * u.sin(), u / 2.0]);
    let cycloid = [(1, ["1", "0", "0"]), (3, ["-1", "0", "0"]), (0, ["0", "1", "0"]), (2, ["0", "-1", "0"])];
    let cycloid = of_curve("0^2,i", ["0", "2*pi"], &cycloid);
    let arcs = assert_curve(&cycloid, None, |u| [u - u.sin(), 1.0 - u.cos(), 0.0]);
    assert_eq!(arcs, 2, "a whole arch is as long as the critical length, which is excluded");
    assert!(matches!(Bases::default().described(&cycloid), Err(EcError::TooLong { .. })));
}

#[test]
fn an_epicycloid_a_figure_of_lissajous_and_a_rose() {
    let whole = ["0", "2*pi"];
    let terms = [(1, ["4", "0", "0"]), (3, ["-1", "0", "0"]), (2, ["0", "4", "0"]), (4, ["0", "-1", "0"])];
    let form = |u: f64| [4.0 * u.cos() - (4.0 * u).cos(), 4.0 * u.sin() - (4.0 * u).sin(), 0.0];
    assert_curve(&of_curve("0,i,4i", whole, &terms), None, form);
    let lissajous = of_curve("0,2i,3i", whole, &[(4, ["1", "0", "0"]), (2, ["0", "1", "0"])]);
    assert_curve(&lissajous, None, |u| [(3.0 * u).sin(), (2.0 * u).sin(), 0.0]);
    let half = "1/2";
    let terms =
        [(1, [half, "0", "0"]), (3, [half, "0", "0"]), (4, ["0", half, "0"]), (2, ["0", "-1/2", "0"])];
    let form = |u: f64| [(2.0 * u).cos() * u.cos(), (2.0 * u).cos() * u.sin(), 0.0];
    assert_curve(&of_curve("0,i,3i", whole, &terms), None, form);
}

#[test]
fn a_hyperbola_and_a_catenary() {
    // {0, 1, -1} has e^u and e^-u.
    let half = "1/2";
    let hyperbola = [(1, [half, half, "0"]), (2, [half, "-1/2", "0"])];
    assert_curve(&of_curve("0,1,-1", ["-2", "2"], &hyperbola), Some(1), |u| [u.cosh(), u.sinh(), 0.0]);
    let catenary = [(1, ["1", "0", "0"]), (2, ["0", half, "0"]), (3, ["0", half, "0"])];
    assert_curve(&of_curve("0^2,1,-1", ["-2", "2"], &catenary), Some(1), |u| [u, u.cosh(), 0.0]);
}

#[test]
fn spirals() {
    // {0^2, i^2}: 1, u, cos u, sin u, u cos u, u sin u.
    let conical = [(4, ["1", "0", "0"]), (5, ["0", "1", "0"]), (1, ["0", "0", "1/3"])];
    let conical = of_curve("0^2,i^2", ["0", "4*pi"], &conical);
    assert_curve(&conical, None, |u| [u * u.cos(), u * u.sin(), u / 3.0]);
    let spiral = of_curve("0,1/4+i", ["0", "3*pi"], &[(1, ["1", "0", "0"]), (2, ["0", "1", "0"])]);
    let form = |t: f64| [(t / 4.0).exp() * t.cos(), (t / 4.0).exp() * t.sin(), 0.0];
    assert_eq!(assert_curve(&spiral, Some(6), form), 6);
    let refused = Bases::default().described(&spiral).unwrap_err().to_string();
    assert!(refused.contains("3.14159265358979"), "{refused}");
    // Arcs 1 and 5, and the derivative at the start.
    let items = Bases::default().strips(&spiral, [Some(6), None]).unwrap();
    let Item::Curve(second) = &items[1] else { panic!("a curve") };
    assert_near(
        &second.points[1..],
        &[[-1.7157994194028592, 1.9099225253406247, 0.0], [-2.1932800507380152, 0.0, 0.0]],
        1e-14,
    );
    let Item::Curve(first) = &items[0] else { panic!("a curve") };
    let [_, by_s, _] = Bases::default().arc(first).unwrap().at(0, 0.0).unwrap();
    assert_near(&[by_s.map(|x| x / FRAC_PI_2)], &[[0.25, 1.0, 0.0]], 1e-14);
}

#[test]
fn the_trefoil() {
    let form = |u: f64| {
        let radius = 2.0 + (3.0 * u).cos();
        [radius * (2.0 * u).cos(), radius * (2.0 * u).sin(), (3.0 * u).sin()]
    };
    let trefoil = [
        (1, ["1/2", "0", "0"]),
        (2, ["0", "-1/2", "0"]),
        (3, ["2", "0", "0"]),
        (4, ["0", "2", "0"]),
        (6, ["0", "0", "1"]),
        (7, ["1/2", "0", "0"]),
        (8, ["0", "1/2", "0"]),
    ];
    assert_curve(&of_curve("0,i,2i,3i,5i", ["0", "2*pi"], &trefoil), None, form);
}

/// Figures 1.7 and 2.10: the torus with radii 2 and 1.
#[test]
fn the_torus() {
    let whole = ["0", "2*pi"];
    let torus = of_surface(
        [("0,i", whole); 2],
        &[
            ([0, 1], ["2", "0", "0"]),
            ([1, 1], ["1", "0", "0"]),
            ([0, 2], ["0", "2", "0"]),
            ([1, 2], ["0", "1", "0"]),
            ([2, 0], ["0", "0", "1"]),
        ],
    );
    let form = |u: f64, v: f64| {
        let radius = 2.0 + u.cos();
        [radius * v.cos(), radius * v.sin(), u.sin()]
    };
    assert_eq!(assert_surface(&torus, [None; 2], form).len(), 9);
    let patches = assert_surface(&torus, [Some(4); 2], form);
    assert_eq!(patches.len(), 16);
    let net = [
        [[3.0, 0.0, 0.0], [3.0, 3.0, 0.0], [0.0, 3.0, 0.0]],
        [[3.0, 0.0, 1.0], [3.0, 3.0, 1.0], [0.0, 3.0, 1.0]],
        [[2.0, 0.0, 1.0], [2.0, 2.0, 1.0], [0.0, 2.0, 1.0]],
    ];
    for (row, expected) in patches[0].net.iter().zip(&net) {
        assert_near(row, expected, 1e-15);
    }
}

#[test]
fn spheres_and_ellipsoids() {
    let terms = [([1, 1], ["3", "0", "0"]), ([1, 2], ["0", "2", "0"]), ([2, 0], ["0", "0", "1"])];
    let ellipsoid = of_surface([("0,i", ["-pi/2", "pi/2"]), ("0,i", ["0", "2*pi"])], &terms);
    let form = |u: f64, v: f64| [3.0 * u.cos() * v.cos(), 2.0 * u.cos() * v.sin(), u.sin()];
    assert_surface(&ellipsoid, [None; 2], form);
}

#[test]
fn ruled_and_minimal_surfaces() {
    // v cos u, v sin u, c u over {0^2, i} x {0^2}.
    let helicoid = [([2, 1], ["1", "0", "0"]), ([3, 1], ["0", "1", "0"]), ([1, 0], ["0", "0", "1/2"])];
    let helicoid = of_surface([("0^2,i", ["0", "5"]), ("0^2", ["-1", "2"])], &helicoid);
    assert_surface(&helicoid, [Some(1); 2], |u, v| [v * u.cos(), v * u.sin(), u / 2.0]);
    let half = "1/2";
    let catenoid = [
        ([1, 2], [half, "0", "0"]),
        ([1, 3], [half, "0", "0"]),
        ([2, 2], ["0", half, "0"]),
        ([2, 3], ["0", half, "0"]),
        ([0, 1], ["0", "0", "1"]),
    ];
    let catenoid = of_surface([("0,i", ["0", "2*pi"]), ("0^2,1,-1", ["-1", "1"])], &catenoid);
    assert_surface(&catenoid, [None; 2], |u, v| [v.cosh() * u.cos(), v.cosh() * u.sin(), v]);
    let hyperboloid = [
        ([1, 1], [half, "0", "0"]),
        ([1, 2], [half, "0", "0"]),
        ([2, 1], ["0", half, "0"]),
        ([2, 2], ["0", half, "0"]),
        ([0, 1], ["0", "0", half]),
        ([0, 2], ["0", "0", "-1/2"]),
    ];
    let hyperboloid = of_surface([("0,i", ["0", "2*pi"]), ("0,1,-1", ["-1", "1"])], &hyperboloid);
    assert_surface(&hyperboloid, [None; 2], |u, v| [v.cosh() * u.cos(), v.cosh() * u.sin(), v.sinh()]);
}

/// The shell (3.3).
fn snail(ends_u: [&str; 2], ends_v: [&str; 2]) -> Coefficients {
    of_surface(
        [("0,i,1/(6*pi),1/(3*pi),1/(6*pi)+i", ends_u), ("0,i", ends_v)],
        &[
            ([1, 0], ["5/4", "0", "0"]),
            ([1, 1], ["1", "0", "0"]),
            ([5, 0], ["-5/4", "0", "0"]),
            ([5, 1], ["-1", "0", "0"]),
            ([6, 0], ["0", "5/4", "0"]),
            ([6, 1], ["0", "1", "0"]),
            ([2, 0], ["0", "-5/4", "0"]),
            ([2, 1], ["0", "-1", "0"]),
            ([0, 0], ["0", "0", "7"]),
            ([4, 0], ["0", "0", "-1"]),
            ([0, 2], ["0", "0", "-1"]),
            ([3, 2], ["0", "0", "1"]),
        ],
    )
}

fn shell(u: f64, v: f64) -> Point<3> {
    let [slow, fast] = [(u / (6.0 * PI)).exp(), (u / (3.0 * PI)).exp()];
    let width = 1.25 + v.cos();
    [(1.0 - slow) * u.cos() * width, (slow - 1.0) * u.sin() * width, 7.0 - fast - v.sin() + slow * v.sin()]
}

#[test]
fn the_shell_of_example_3_2_2() {
    let whole = snail(["30*pi/8", "50*pi/8"], ["-pi/3", "5*pi/3"]);
    let patches = assert_surface(&whole, [Some(4), Some(3)], shell);
    assert_eq!(patches.len(), 12);
    assert_near(
        &[patches[0].net[0][0]],
        &[[-1.074399557416729, -1.074399557416729, 2.7577339866687116]],
        1e-14,
    );
    assert_near(&[patches[0].net[0][0]], &[shell(30.0 * PI / 8.0, -FRAC_PI_3)], 1e-14);
    // The whole of u in one patch too, and the picture of Róth's own paper.
    assert_eq!(assert_surface(&whole, [Some(1), Some(3)], shell).len(), 3);
    let paper = snail(["7*pi/2", "57*pi/8"], ["-pi/6", "11*pi/6"]);
    assert_eq!(assert_surface(&paper, [Some(5), Some(6)], shell).len(), 30);
}

/// Figures 3.10 and 3.11.
#[test]
fn a_patch_of_the_shell_divided_and_elevated() {
    let mut bases = Bases::default();
    let coefficients = snail(["30*pi/8", "35*pi/8"], ["-pi/3", "pi/3"]);
    let Item::Patch(patch) = bases.described(&coefficients).unwrap() else { panic!("a patch") };
    let surface = bases.weave(&patch).unwrap();
    let parts = bases.divided(&Item::Patch(patch.clone()), 0, &[real("95*pi/24")]).unwrap();
    assert_eq!(parts.len(), 2);
    let [lower, upper] = [0, 1].map(|k| match &parts[k] {
        Item::Patch(part) => bases.weave(part).unwrap(),
        Item::Curve(_) => panic!("a patch"),
    });
    let elevated = bases.elevated_patch(&patch, 1, &Root::zero(1)).unwrap();
    assert_eq!((elevated.net.len(), elevated.net[0].len()), (7, 4));
    let elevated = bases.weave(&elevated).unwrap();
    for k in 0..=12 {
        for l in 0..=12 {
            let [s, t] = [k, l].map(|k| f64::from(k) / 12.0);
            assert_near(&[point(&elevated, s, t)], &[point(&surface, s, t)], 1e-14);
            assert_near(&[point(&lower, s, t)], &[point(&surface, s / 3.0, t)], 1e-14);
            assert_near(&[point(&upper, s, t)], &[point(&surface, (1.0 + 2.0 * s) / 3.0, t)], 1e-14);
        }
    }
}

#[test]
fn a_surface_divided_in_both_directions_is_the_same() {
    let mut bases = Bases::default();
    let whole = snail(["30*pi/8", "50*pi/8"], ["-pi/3", "pi/3"]);
    let Item::Patch(patch) = bases.described(&whole).unwrap() else { panic!("a patch") };
    let surface = bases.weave(&patch).unwrap();
    let [us, vs] = [&patch.interval_u, &patch.interval_v].map(values);
    for strip in bases.divided(&Item::Patch(patch), 0, &["33*pi/8", "47*pi/8"].map(real)).unwrap() {
        for part in bases.divided(&strip, 1, &["-0.3", "0.5", "0.9"].map(real)).unwrap() {
            let Item::Patch(part) = part else { panic!("a patch") };
            let weave = bases.weave(&part).unwrap();
            let ends = [&part.interval_u, &part.interval_v].map(values);
            for k in 0..=10 {
                for l in 0..=10 {
                    let [s, t] = [k, l].map(|k| f64::from(k) / 10.0);
                    let [u, v] =
                        [(s, ends[0]), (t, ends[1])].map(|(s, [start, end])| start + s * (end - start));
                    let whole = point(&surface, (u - us[0]) / (us[1] - us[0]), (v - vs[0]) / (vs[1] - vs[0]));
                    assert_near(&[point(&weave, s, t)], &[whole], 1e-12);
                }
            }
        }
    }
}

#[test]
fn the_samples_are_what_they_say() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let mut scenes = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let extension = path.extension().and_then(|it| it.to_str()).unwrap_or_default().to_lowercase();
        if !extension.starts_with("kc") || extension == "kct" {
            continue;
        }
        let format = grafika::file::Format::from_extension(&extension).unwrap();
        let document = Document::read(format, &std::fs::read(&path).unwrap()).unwrap();
        let Document::Ec(document) = document else { panic!("{}", path.display()) };
        let items = match &*document {
            EcDocument::Coefficients(coefficients) => {
                Bases::default().strips(coefficients, [None; 2]).unwrap()
            }
            _ => Bases::default().scene(&document).unwrap().items,
        };
        assert!(!items.is_empty(), "{}", path.display());
        scenes += 1;
    }
    assert_eq!(scenes, 8);
}

#[test]
fn bad_input_says_what_would_be_right() {
    let said = |roots: &str| roots.parse::<Space>().unwrap_err().to_string();
    assert!(said("0,i,i").contains("twice") || said("0,i,i").contains("already"), "{}", said("0,i,i"));
    assert!(said("1,2").contains('0'), "{}", said("1,2"));
    assert!(said("0^20,i^9").contains("31"), "{}", said("0^20,i^9"));
    let zero = Real::typed("1/(2-2)").unwrap_err().to_string();
    assert!(zero.contains("zero") || zero.contains('0'), "{zero}");
    let said = |roots: &str, ends: [f64; 2]| EcBasis::new(&space(roots), ends).unwrap_err().to_string();
    assert!(said("0,i", [2.0, 1.0]).contains("start must be less"), "{}", said("0,i", [2.0, 1.0]));
    assert!(said("0,i", [0.0, 3.2]).contains("3.14159265358979"));
    let curve = Blend::new(EcBasis::new(&space("0,i"), [0.0, 1.0]).unwrap(), vec![[0.0; 3]; 4]);
    assert!(curve.is_err());
    assert!(EcBasis::new(&space("0,i"), [0.0, 1.0]).unwrap().points() == 3);
}

#[test]
fn control_points_become_a_curve_of_polynomials_and_go_back() {
    use grafika::file::{FileKind, convert};
    let [csv, kcg] = ["csv", "kcg"].map(|it| FileKind::from_extension(it).unwrap());
    let text = "x,y,z\n0,0,0\n1,2,0.5\n3,1,-1\n";
    let curve = convert(text.as_bytes(), csv, kcg).unwrap();
    let Document::Ec(document) = Document::decode(kcg, &curve).unwrap() else { panic!("a curve") };
    let EcDocument::Curve(arc) = &*document else { panic!("a curve") };
    assert_eq!((&arc.space, values(&arc.interval)), (&space("0^3"), [0.0, 1.0]));
    assert_eq!(String::from_utf8(convert(&curve, kcg, csv).unwrap()).unwrap(), text);
    // Of the plane, and by name as the command does it.
    let plane = Document::from_csv("0,0\n1,2\n3,1\n").unwrap();
    let files = grafika::work::dos_files(&plane, grafika::file::Format::Kcg, "arc.kcg").unwrap();
    let Ok(Document::Ec(document)) = Document::decode(kcg, &files[0].1) else { panic!("a curve") };
    assert!(matches!(&*document, EcDocument::Curve(curve) if curve.points[2] == [3.0, 1.0, 0.0]));
    // More points than the largest space has functions stay what they are, and are refused.
    let many: String = (0..32).map(|k| format!("{k},0,0\n")).collect();
    assert!(convert(many.as_bytes(), csv, kcg).is_err());
}
