//! Spheres: tubes against the skin in the plane, exact forms against points, meshes.

use super::*;
use crate::geometry::{ParamSurface, Point, cross, dot};
use proptest::prelude::*;
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn balls(rows: &[[f64; 4]]) -> Vec<Sphere> {
    rows.iter().map(|[x, y, z, r]| Sphere::new([*x, *y, *z], *r)).collect()
}

fn chain(rows: &[[f64; 4]]) -> Spheres {
    Spheres::chain(balls(rows)).unwrap()
}

/// Five spheres along a snail.
fn snail() -> Spheres {
    chain(&[
        [0.0, 0.0, 0.0, 1.0],
        [3.0, 1.0, 0.5, 1.3],
        [6.0, 0.5, 2.0, 0.9],
        [8.0, 2.5, 4.0, 1.2],
        [8.5, 6.0, 5.0, 0.7],
    ])
}

/// Six spheres round a ring that is not flat.
fn ring() -> Spheres {
    let at = |k: i32| {
        let (sine, cosine) = (TAU * f64::from(k) / 6.0).sin_cos();
        Sphere::new([5.0 * cosine, 4.0 * sine, 0.8 * f64::from(k % 3)], 1.0 + 0.2 * f64::from(k % 2))
    };
    Spheres::new((0..6).map(at).collect(), vec![], true).unwrap()
}

/// Admissible chains in space.
fn chains() -> impl Strategy<Value = Spheres> {
    let steps = prop::collection::vec((-0.9..0.9, -0.9..0.9, 0.7..1.8, 0.4..2.0), 2..7);
    steps.prop_filter_map("admissible", |steps| {
        let mut spheres: Vec<Sphere> = Vec::new();
        let (mut turn, mut rise) = (0.0, 0.0);
        for (more, higher, distance, radius) in steps {
            turn += more;
            rise = 0.5 * rise + higher;
            let place = spheres.last().map_or([0.0; 3], |last| {
                let away = distance * (last.radius + radius);
                let (flat, up) = (away * f64::cos(rise), away * f64::sin(rise));
                [
                    last.center[0] + flat * f64::cos(turn),
                    last.center[1] + flat * f64::sin(turn),
                    last.center[2] + up,
                ]
            });
            spheres.push(Sphere::new(place, radius));
        }
        Spheres::chain(spheres).ok().filter(Spheres::is_admissible)
    })
}

/// The points of a tube at whole steps, each with span and parameters.
fn places(surface: &dyn ParamSurface, steps: usize) -> impl Iterator<Item = ([usize; 2], [f64; 2])> {
    let [quarters, spans] = surface.spans();
    let at = move |k: usize| (k as f64 + 0.37) / steps as f64;
    (0..quarters * steps).flat_map(move |k| {
        (0..spans * steps).map(move |l| ([k / steps, l / steps], [at(k % steps), at(l % steps)]))
    })
}

#[test]
fn the_section_of_a_flat_chain_is_the_skin_in_the_plane() {
    let rows = [[0.0, 0.0, 1.0], [3.0, 1.0, 1.4], [6.0, 0.5, 0.8], [8.5, 2.5, 1.2], [9.0, 6.0, 1.0]];
    let flat = Circles::chain(discs(&rows)).unwrap().skin(Clearing::Plain);
    let space = chain(&rows.map(|[x, y, r]| [x, y, 0.0, r])).skin(Clearing::Plain);
    let tube = &space.arms[0].tubes[0];
    let sides = [Side::Left, Side::Right].map(|side| flat.side_arcs(side));
    // The frames begin perpendicular to the plane, so quarter turns lie in it.
    for span in 0..4 {
        for quarter in [1, 3] {
            let point = |v: f64| tube.eval([quarter, span], [0.0, v]).unwrap();
            assert!(point(0.3)[2].abs() < 1e-14);
            let side = sides.iter().find(|arcs| {
                let start = arcs[span].bezier.p[0];
                apart([start[0], start[1], 0.0], point(0.0)) < 1e-9
            });
            let arc = side.expect("the left or the right side")[span].bezier;
            for v in [0.0, 0.2, 0.5, 0.9, 1.0] {
                let [x, y] = arc.eval(v);
                assert!(apart(point(v), [x, y, 0.0]) < 1e-13);
            }
        }
    }
}

#[test]
fn two_spheres_have_a_cone() {
    let skin = chain(&[[0.0, 0.0, 0.0, 2.0], [0.0, 0.0, 6.0, 1.0]]).skin(Clearing::Scaled);
    let tube = &skin.arms[0].tubes[0];
    for (spans, uv) in places(tube, 7) {
        let [x, y, z] = tube.eval(spans, uv).unwrap();
        // The tangent from the apex (0, 0, 12) has the sine 1/6.
        let expected = (12.0 - z) / 35.0_f64.sqrt();
        assert!((x.hypot(y) - expected).abs() < 1e-13);
    }
    // Equal spheres have a cylinder, run through evenly.
    let skin = chain(&[[0.0, 0.0, 0.0, 1.0], [4.0, 0.0, 0.0, 1.0]]).skin(Clearing::Scaled);
    let [x, y, z] = skin.arms[0].tubes[0].eval([2, 0], [0.4, 0.25]).unwrap();
    assert!((x - 1.0).abs() < 1e-14 && (y.hypot(z) - 1.0).abs() < 1e-14);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn tubes_touch_their_spheres_and_enter_none(spheres in chains()) {
        let skin = spheres.skin(Clearing::Scaled);
        prop_assert!(skin.is_whole());
        prop_assert_eq!((skin.arms.len(), skin.arms[0].tubes.len()), (1, 1));
        let numbers = &skin.arms[0].spheres;
        for (k, circle) in skin.circles().iter().enumerate() {
            let [before, behind] = [k.saturating_sub(1), (k + 1).min(numbers.len() - 1)]
                .map(|k| spheres.spheres()[numbers[k]].center);
            prop_assert!(dot(circle.axis, scaled_difference(1.0, before, behind)) > 0.0);
        }
        let tube = &skin.arms[0].tubes[0];
        for (spans, [u, v]) in places(tube, 5) {
            let own = &tube.tube_spans()[spans[1]];
            for (end, number) in [0.0, 1.0].into_iter().zip(own.spheres) {
                let sphere = &spheres.spheres()[number];
                let at = tube.at(spans, [u, end]).unwrap();
                prop_assert!((sphere.distance(at.point) - sphere.radius).abs() < 1e-13);
                let outwards = scaled_difference(1.0 / sphere.radius, sphere.center, at.point);
                prop_assert!(dot(outwards, at.v).abs() < 1e-12 && dot(outwards, at.u).abs() < 1e-12);
                // Normals point outwards.
                prop_assert!(tube.normal(spans, [u, end]).is_none_or(|normal| dot(normal, outwards) > 1.0 - 1e-9));
            }
            let point = tube.eval(spans, [u, v]).unwrap();
            let deepest = spheres.spheres().iter().map(|ball| ball.radius - ball.distance(point)).fold(-1.0, f64::max);
            prop_assert!(deepest < 1e-3 || !own.clear, "{}", deepest);
        }
    }

    #[test]
    fn exact_forms_are_the_tubes(spheres in chains()) {
        let skin = spheres.skin(Clearing::Scaled);
        let tube = &skin.arms[0].tubes[0];
        let form = tube.to_bspline().unwrap();
        prop_assert_eq!((form.degrees, form.net.first()), ([4, 3], form.net.last()));
        prop_assert!(form.weights.iter().flatten().flatten().all(|weight| *weight > 0.0));
        for ([quarter, span], [u, v]) in places(tube, 4) {
            let found = form.eval(quarter as f64 + turned(u), span as f64 + v).unwrap();
            let expected = tube.eval([quarter, span], [u, v]).unwrap();
            prop_assert!(apart(found, expected) < 1e-12, "{:?} {:?}", found, expected);
        }
    }

    #[test]
    fn derivatives_agree_with_differences(spheres in chains(), u in 0.0..1.0, v in 0.0..1.0) {
        let h = 1e-5;
        let ([u, v], size) = ([0.01 + 0.98 * u, 0.01 + 0.98 * v], 20.0);
        for part in spheres.skin(Clearing::Plain).parts() {
            let at = |du: f64, dv: f64| part.at([2, part.spans()[1] - 1], [u + du, v + dv]).unwrap();
            let slope = |a: Point<3>, b: Point<3>| scaled_difference(0.5 / h, a, b);
            let here = at(0.0, 0.0);
            let (by_u, by_v) = ([at(-h, 0.0), at(h, 0.0)], [at(0.0, -h), at(0.0, h)]);
            for (found, expected) in [
                (slope(by_u[0].point, by_u[1].point), here.u),
                (slope(by_v[0].point, by_v[1].point), here.v),
                (slope(by_u[0].u, by_u[1].u), here.uu),
                (slope(by_u[0].v, by_u[1].v), here.uv),
                (slope(by_v[0].v, by_v[1].v), here.vv),
            ] {
                prop_assert!(apart(found, expected) < 1e-5 * size, "{:?} {:?}", found, expected);
            }
        }
    }
}

/// The parameter of a rational quarter turn for the part `u` of its angle: from the middle, tangents of half angles are
/// as parameters.
fn turned(u: f64) -> f64 {
    0.5 + 0.5 * (0.25 * PI * (u - 0.5)).tan() / (0.125 * PI).tan()
}

#[test]
fn caps_are_parts_of_their_spheres() {
    let skin = snail().skin(Clearing::Scaled);
    let [Some(first), Some(last)] = skin.arms[0].caps else { panic!("two caps") };
    for (cap, axis) in [(first, -1.0), (last, 1.0)] {
        let form = cap.to_bspline().unwrap();
        let circle = if cap.is_last() { *skin.circles().last().unwrap() } else { skin.circles()[0] };
        let sphere = cap.sphere();
        for k in 0..=40 {
            for l in 0..=20 {
                let (s, t) = (f64::from(k) / 10.0, f64::from(l) / 10.0);
                let points =
                    [form.eval(s, t).unwrap(), cap.eval([k as usize / 11, 0], [0.3, 0.5 * t]).unwrap()];
                for point in points {
                    assert!((sphere.distance(point) - sphere.radius).abs() < 1e-14);
                    // Beyond the plane of the circle.
                    let beyond = axis * dot(scaled_difference(1.0, circle.center, point), circle.axis);
                    assert!(beyond > -1e-14, "{beyond}");
                }
            }
        }
        // Both meet the tube along the circle.
        let tube = &skin.arms[0].tubes[0];
        let (v, span) = if cap.is_last() { (0.0, tube.spans()[1] - 1) } else { (1.0, 0) };
        for quarter in 0..4 {
            let own = cap.eval([quarter, 0], [0.3, v]).unwrap();
            let other = tube.eval([quarter, span], [0.3, 1.0 - v]).unwrap();
            assert!(apart(own, other) < 1e-14);
        }
    }
}

/// Vertices - edges + triangles if every edge lies between two triangles that run through it in opposite directions.
fn characteristic(mesh: &SkinMesh) -> Option<i64> {
    let mut edges: HashMap<[usize; 2], usize> = HashMap::new();
    for [a, b, c] in &mesh.triangles {
        for edge in [[*a, *b], [*b, *c], [*c, *a]] {
            *edges.entry(edge).or_default() += 1;
        }
    }
    let closed = edges.iter().all(|([a, b], count)| *count == 1 && edges.contains_key(&[*b, *a]));
    let used = mesh.vertices.len() as i64;
    closed.then(|| used - edges.len() as i64 / 2 + mesh.triangles.len() as i64)
}

fn volume(mesh: &SkinMesh) -> f64 {
    let corners = mesh.triangles.iter().map(|triangle| triangle.map(|k| mesh.vertices[k]));
    corners.map(|[a, b, c]| dot(a, cross(b, c)) / 6.0).sum()
}

#[test]
fn meshes_are_closed_and_turned_outwards() {
    let mesh = snail().skin(Clearing::Scaled).mesh(MESH_STEPS).unwrap();
    assert_eq!(characteristic(&mesh), Some(2));
    assert_eq!(mesh.vertices.len(), 48 * (4 * 12 + 1) + 2 * (48 * 11 + 1));
    assert!(volume(&mesh) > 0.0);
    let mesh = ring().skin(Clearing::Scaled).mesh([30, 7]).unwrap();
    assert_eq!(characteristic(&mesh), Some(0));
    assert!(volume(&mesh) > 0.0);
    // A cylinder with two hemispheres.
    let capsule = chain(&[[0.0, 0.0, 0.0, 1.0], [4.0, 0.0, 0.0, 1.0]]).skin(Clearing::Scaled);
    let mesh = capsule.mesh([400, 100]).unwrap();
    assert!((volume(&mesh) / (4.0 * PI + 4.0 / 3.0 * PI) - 1.0).abs() < 1e-3);
    for (steps, least) in [([2, 4], 3), ([48, 0], 1), ([1 << 30, 1], 3)] {
        let refused = capsule.mesh(steps);
        assert!(matches!(refused, Err(SkinError::Steps { least: l, .. }) if l == least), "{refused:?}");
    }
}

#[test]
fn rings_close_without_a_seam() {
    let skin = ring().skin(Clearing::Scaled);
    let tube = &skin.arms[0].tubes[0];
    assert!(skin.is_whole() && tube.closed() == [true, true]);
    for quarter in 0..4 {
        for u in [0.0, 0.4, 1.0] {
            let ends = [([quarter, 5], 1.0), ([quarter, 0], 0.0)];
            let [last, first] = ends.map(|(spans, v)| tube.at(spans, [u, v]).unwrap());
            assert_eq!(last.point, first.point);
            assert!(norm(cross(last.v, first.v)) < 1e-12 && dot(last.v, first.v) > 0.0);
        }
    }
    let form = tube.to_bspline().unwrap();
    assert!(form.net.iter().all(|row| row.first() == row.last()));
}

#[test]
fn arms_share_the_sphere_they_branch_at() {
    let rows = [
        [0.0, 0.0, 0.0, 3.0],
        [5.0, 0.0, 0.0, 1.0],
        [8.0, 1.0, 0.0, 0.8],
        [-2.5, 4.3, 0.0, 1.0],
        [-2.5, -4.3, 0.0, 1.0],
        [-5.0, -6.0, 1.0, 1.2],
    ];
    let tree = Spheres::new(balls(&rows), vec![vec![2, 1, 0, 3], vec![0, 4, 5]], false).unwrap();
    assert_eq!(tree.arms(), [vec![2, 1, 0], vec![0, 3], vec![0, 4, 5]]);
    assert!(tree.is_admissible());
    let skin = tree.skin(Clearing::Scaled);
    assert!(skin.is_whole() && skin.parts().len() == 9);
    let mesh = skin.mesh([24, 6]).unwrap();
    assert_eq!(characteristic(&mesh), Some(6));
    // An arm that meets another one.
    let moved = tree.with_sphere(3, Sphere::new([3.0, 4.0, 0.0], 3.5)).unwrap();
    let rules: Vec<u8> = moved.violations().iter().map(Violation::rule).collect();
    assert_eq!(rules, [2]);
    assert!(moved.nearest_admissible().is_some_and(|near| near.is_admissible()));
}

#[test]
fn radical_planes_that_cut_touching_circles_make_kinks_but_no_error() {
    // The first two overlap so far that the second circle crosses both.
    let bent = chain(&[[0.0, 0.0, 0.0, 2.0], [1.0, 1.5, 0.0, 1.6], [3.4, 0.0, 0.0, 2.0]]);
    assert!(!bent.is_admissible());
    let skin = bent.skin(Clearing::Plain);
    let tube = &skin.arms[0].tubes[0];
    let form = tube.to_bspline().unwrap();
    assert!(form.knots[0].len() > 5, "no kink: {:?}", form.knots);
    // Points of the form lie on the surface: at the angle of their place on the first circle.
    let first = tube.circles().next().unwrap();
    let zero = tube.eval([0, 0], [0.0, 0.0]).unwrap();
    let x = scaled_difference(1.0 / first.radius, first.center, zero);
    let y = cross(first.axis, x);
    for k in 0..400 {
        let s = 4.0 * f64::from(k) / 400.0;
        let way = scaled_difference(1.0, first.center, form.eval(s, 0.0).unwrap());
        let turns = dot(way, y).atan2(dot(way, x)).rem_euclid(TAU) / FRAC_PI_2;
        let quarter = (turns as usize).min(3);
        for (t, place) in [(0.3, 0), (1.0, 0), (1.7, 1), (2.0, 1)] {
            let found = form.eval(s, t).unwrap();
            let expected = tube.eval([quarter, place], [turns - quarter as f64, t - place as f64]).unwrap();
            assert!(apart(found, expected) < 1e-12, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn rules_hold_for_balls() {
    assert!(snail().is_admissible() && ring().is_admissible());
    let rules = |rows: &[[f64; 4]]| chain(rows).violations();
    let row = [[0.0, 0.0, 0.0, 3.0], [0.0, 0.0, 1.0, 1.0], [0.0, 6.0, 0.0, 2.0]];
    assert_eq!(rules(&row), [Violation::Covered { number: 1 }]);
    assert_eq!(rules(&row)[0].sentence("sphere"), "sphere 2 is covered by the others");
    let row = [[0.0, 0.0, 0.0, 2.0], [0.0, 1.5, 3.0, 1.0], [0.0, 3.0, 0.0, 2.0]];
    assert_eq!(rules(&row), [Violation::MeetOutside { numbers: [0, 2], middle: 1 }]);
    // A chain in another order than its numbers.
    let order = Spheres::new(balls(&row), vec![vec![1, 0, 2]], false).unwrap();
    assert!(order.violations().is_empty());
}

#[test]
fn wrong_spheres_are_refused() {
    let row = balls(&[[0.0, 0.0, 0.0, 1.0], [4.0, 0.0, 0.0, 1.0], [8.0, 0.0, 0.0, 1.0]]);
    let error = |chains: &[&[usize]], closed: bool| {
        let chains = chains.iter().map(|chain| chain.to_vec()).collect();
        Spheres::new(row.clone(), chains, closed).unwrap_err()
    };
    assert_eq!(
        error(&[&[0, 1], &[2, 3]], false),
        SkinError::NoSuch { what: "chain", index: 1, named: 3, count: 3 }
    );
    assert_eq!(error(&[&[0, 1, 2, 0]], false), SkinError::Repeated { chain: 0, sphere: 0 });
    assert_eq!(error(&[&[0, 1, 2], &[2]], false), SkinError::ShortChain { chain: 1 });
    assert_eq!(error(&[&[0, 1]], false), SkinError::Unlinked { sphere: 2 });
    assert_eq!(error(&[&[0, 1], &[1, 2]], true), SkinError::ClosedChains { given: 2 });
    assert!(matches!(Spheres::chain(vec![]), Err(SkinError::TooFew { .. })));
    let bad = Spheres::chain(vec![Sphere::new([0.0, 0.0, f64::NAN], 1.0)]);
    assert!(matches!(bad, Err(SkinError::Center { number: 1, .. })));
    // One sphere alone is no error, and has no skin.
    let one = chain(&[[0.0, 0.0, 0.0, 1.0]]);
    assert!(one.is_admissible() && one.skin(Clearing::Scaled).parts().is_empty());
    assert_eq!(one.skin(Clearing::Scaled).mesh(MESH_STEPS), Ok(SkinMesh::default()));
}

/// Coordinates that coincide, are tiny, or huge.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-2_i32..3).prop_map(f64::from),
        2 => -10.0..10.0,
        1 => prop::sample::select(vec![1e-300, 5e-324, 1e-9, 1e9, 1e150, -1e150, 1e77]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn nothing_in_space_is_nan(
        rows in prop::collection::vec((coordinate(), coordinate(), coordinate(), coordinate()), 1..7),
        closed: bool,
    ) {
        let balls: Vec<Sphere> = rows
            .iter()
            .map(|(x, y, z, r)| Sphere::new([*x, *y, *z], if *r == 0.0 { 1.0 } else { r.abs() }))
            .collect();
        let spheres = Spheres::new(balls, vec![], closed && rows.len() > 2).unwrap();
        let skin = spheres.skin(Clearing::Scaled);
        let finite = |point: Point<3>| point.iter().all(|x| x.is_finite());
        for circle in skin.circles() {
            prop_assert!(finite(circle.center) && finite(circle.axis) && circle.radius > 0.0);
        }
        for part in skin.parts() {
            for (spans, uv) in places(part, 2) {
                let at = part.at(spans, uv).unwrap();
                prop_assert!([at.point, at.u, at.v, at.uu, at.uv, at.vv].into_iter().all(finite), "{:?}", at);
            }
            let form = part.to_bspline().unwrap();
            prop_assert!(form.net.iter().flatten().all(|point| finite(*point)));
        }
        let mesh = skin.mesh([8, 3]).unwrap();
        prop_assert!(mesh.vertices.iter().all(|point| finite(*point)));
        let whole = if spheres.closed() { 0 } else if rows.len() > 1 { 2 } else { 0 };
        prop_assert!(!skin.is_whole() || characteristic(&mesh) == Some(whole));
        let _ = spheres.violations();
    }
}
