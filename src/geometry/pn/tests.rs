use super::examples::{Example, cylinder, data, paraboloid, saddle, sphere, torus_crest, torus_outside};
use super::*;
use crate::geometry::point::{add_scaled, norm, scaled_difference};
use crate::geometry::{GeometryError, ParamSurface, Point, cross, dot};
use proptest::prelude::*;

fn surface(example: Example, rows: usize, columns: usize) -> PnSurface {
    PnSurface::new(&data(example, rows, columns), PnMethod::Normalised).expect("the examples are regular")
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    norm(scaled_difference(1.0, a, b))
}

/// Places of every patch, borders included.
fn places(surface: &PnSurface, steps: usize) -> Vec<([usize; 2], [f64; 2])> {
    let samples = surface.sample(steps).expect("few steps");
    samples.into_iter().map(|sample| (sample.spans, sample.parameters)).collect()
}

#[test]
fn points_and_normals_are_those_of_the_data() {
    for (example, method) in [(saddle as Example, PnMethod::Normalised), (paraboloid, PnMethod::Thesis)] {
        let data = data(example, 4, 5);
        let surface = PnSurface::new(&data, method).unwrap();
        let last = surface.spans().map(|spans| spans - 1);
        for [i, j] in data.indices() {
            let spans = [i.min(last[0]), j.min(last[1])];
            let uv = [(i - spans[0]) as f64, (j - spans[1]) as f64];
            let place = surface.place(spans, uv).unwrap();
            assert!(distance(place.point, data.point(i, j).unwrap()) < 4e-14);
            assert!(distance(place.normal, data.normal(i, j).unwrap()) < 1e-15);
        }
    }
}

/// Numbers computed with 40 digits by another route: curvature by differences of points and normals.
#[test]
fn reference_values() {
    let check = |surface: &PnSurface, spans, uv, point, normal, radii: [f64; 2], size: f64| {
        let place = surface.place(spans, uv).unwrap();
        assert!(distance(place.point, point) < 4e-15 * size, "{place:?}");
        assert!(distance(surface.eval(spans, uv).unwrap(), point) < 4e-15 * size);
        assert!(distance(place.normal, normal) < 1e-15, "{place:?}");
        assert!(
            place.radii.iter().zip(radii).all(|(a, b)| (a - b).abs() < 4e-14 * b.abs().max(size)),
            "{place:?}"
        );
    };
    let third = 1.0 / 3.0;
    let surface = |example: Example, rows: usize, columns: usize, method: PnMethod| {
        PnSurface::new(&data(example, rows, columns), method).unwrap()
    };
    check(
        &surface(paraboloid, 4, 4, PnMethod::Normalised),
        [2, 2],
        [2.0 * third, third],
        [15.583970164805805, 8.023996830544748, 4.037997619019423],
        [0.2784187251525793, 0.3607698446967535, -0.890128155178732],
        [25.35325873592851, 60.97741383544446],
        40.0,
    );
    check(
        &surface(paraboloid, 3, 3, PnMethod::Thesis),
        [1, 1],
        [2.0 * third, third],
        [12.826922948597366, 6.119917133838291, 2.056005062679791],
        [0.2779483765255696, 0.2289666664916955, -0.9329088731609754],
        [18.1642890495625, 31.748172939583476],
        40.0,
    );
    let saddle = surface(saddle, 3, 4, PnMethod::Normalised);
    check(
        &saddle,
        [1, 2],
        [2.0 * third, third],
        [1.2915061598977138, 1.0857766258098063, 0.13395664983839395],
        [0.3531553924048678, -0.19760953362813505, -0.9144570744625659],
        [-5.342831502385646, 4.1976152782210265],
        4.0,
    );
    let offset = saddle.offset(-0.2).unwrap().rational_patch([0, 1]).unwrap().eval(0.9, 0.1).unwrap();
    assert!(distance(offset, [-0.17403397704852794, -0.5461054199776918, 0.1763395904795312]) < 1e-14);
}

/// The data of a sphere give the sphere, and those of its offset the offset.
#[test]
fn sphere_is_exact() {
    for (rows, columns) in [(2, 2), (4, 4), (3, 8)] {
        let surface = surface(sphere, rows, columns);
        for (spans, uv) in places(&surface, 5) {
            let place = surface.place(spans, uv).unwrap();
            let radius = scaled_difference(1.0, [2.0, -1.0, 3.0], place.point);
            assert!((norm(radius) - 30.0).abs() < 3e-14);
            assert!(distance(radius.map(|x| x / 30.0), place.normal) < 2e-15);
            assert!(place.radii.iter().all(|r| (r - 30.0).abs() < 1e-11));
        }
    }
}

/// The largest distance from the surface that the data come from.
fn error(example: Example, rows: usize, method: PnMethod, from: impl Fn(Point<3>) -> f64) -> f64 {
    let surface = PnSurface::new(&data(example, rows, rows), method).unwrap();
    let points = places(&surface, 4).into_iter().map(|(spans, uv)| surface.eval(spans, uv).unwrap());
    points.map(|point| from(point).abs()).fold(0.0, f64::max)
}

#[test]
fn finer_data_come_nearer_to_the_surface() {
    let torus = |[x, y, z]: Point<3>| (x.hypot(y) - 60.0).hypot(z) - 25.0;
    let vault = |[x, y, z]: Point<3>| z - 0.01 * x * x - 0.025 * y * y;
    for method in [PnMethod::Normalised, PnMethod::Thesis] {
        for (coarse, fine) in [
            (error(paraboloid, 5, method, vault), error(paraboloid, 9, method, vault)),
            (
                error(saddle, 5, method, |[x, y, z]| z - 0.15 * x * x + 0.1 * y * y),
                error(saddle, 9, method, |[x, y, z]| z - 0.15 * x * x + 0.1 * y * y),
            ),
        ] {
            assert!(fine < coarse / 5.0, "{coarse} {fine}");
        }
    }
    let (coarse, fine) = (
        error(torus_outside, 4, PnMethod::Normalised, torus),
        error(torus_outside, 8, PnMethod::Normalised, torus),
    );
    assert!(coarse < 0.1 && fine < coarse / 5.0, "{coarse} {fine}");
}

/// The thesis's other way: x solves n·x = h, n_u·x = h_u, n_v·x = h_v. Everything by differences.
#[test]
fn points_are_those_of_the_support_function() {
    for example in [saddle as Example, paraboloid, torus_outside] {
        let surface = surface(example, 4, 4);
        let h = 1e-5;
        for (spans, [u, v]) in places(&surface, 4) {
            let (u, v) = (u.clamp(0.1, 0.9), v.clamp(0.1, 0.9));
            let at = |i: f64, j: f64| surface.place(spans, [u + i * h, v + j * h]).unwrap();
            let support = |i: f64, j: f64| dot(at(i, j).point, at(i, j).normal);
            let slope =
                |d: [f64; 2]| scaled_difference(0.5 / h, at(-d[0], -d[1]).normal, at(d[0], d[1]).normal);
            let (n, n_u, n_v) = (at(0.0, 0.0).normal, slope([1.0, 0.0]), slope([0.0, 1.0]));
            let h_u = (support(1.0, 0.0) - support(-1.0, 0.0)) / (2.0 * h);
            let h_v = (support(0.0, 1.0) - support(0.0, -1.0)) / (2.0 * h);
            // Cramer's rule by vector products.
            let determinant = dot(n, cross(n_u, n_v));
            let x = add_scaled(
                add_scaled(cross(n_u, n_v).map(|c| c * support(0.0, 0.0)), h_u, cross(n_v, n)),
                h_v,
                cross(n, n_u),
            )
            .map(|c| c / determinant);
            let size = norm(at(0.0, 0.0).point).max(1.0);
            assert!(distance(x, at(0.0, 0.0).point) < 1e-6 * size, "{x:?} {:?}", at(0.0, 0.0).point);
        }
    }
}

#[test]
fn derivatives_agree_with_differences() {
    let surface = surface(saddle, 3, 4).offset(-0.4).unwrap();
    let h = 1e-4;
    for (spans, [u, v]) in places(&surface, 3) {
        let (u, v) = (u.clamp(0.1, 0.9), v.clamp(0.1, 0.9));
        let at = |i: f64, j: f64| surface.eval(spans, [u + i * h, v + j * h]).unwrap();
        let derivatives = surface.at(spans, [u, v]).unwrap();
        let sum =
            |terms: &[(f64, Point<3>)]| terms.iter().fold([0.0; 3], |sum, (k, p)| add_scaled(sum, *k, *p));
        let by_u = sum(&[(0.5 / h, at(1.0, 0.0)), (-0.5 / h, at(-1.0, 0.0))]);
        let by_v = sum(&[(0.5 / h, at(0.0, 1.0)), (-0.5 / h, at(0.0, -1.0))]);
        let second = 1.0 / (h * h);
        let uu = sum(&[(second, at(1.0, 0.0)), (-2.0 * second, at(0.0, 0.0)), (second, at(-1.0, 0.0))]);
        let vv = sum(&[(second, at(0.0, 1.0)), (-2.0 * second, at(0.0, 0.0)), (second, at(0.0, -1.0))]);
        let uv =
            [(0.25, at(1.0, 1.0)), (-0.25, at(1.0, -1.0)), (-0.25, at(-1.0, 1.0)), (0.25, at(-1.0, -1.0))];
        let uv = sum(&uv.map(|(k, point)| (k * second, point)));
        assert_eq!(derivatives.point, at(0.0, 0.0));
        for (exact, difference) in [(derivatives.u, by_u), (derivatives.v, by_v)] {
            assert!(distance(exact, difference) < 1e-5, "{exact:?} {difference:?}");
        }
        for (exact, difference) in [(derivatives.uu, uu), (derivatives.uv, uv), (derivatives.vv, vv)] {
            assert!(distance(exact, difference) < 1e-4, "{exact:?} {difference:?}");
        }
    }
}

/// Gaussian curvature from the derivatives is 1/(r1 r2), mean curvature -(1/r1 + 1/r2)/2 along the normal.
#[test]
fn radii_agree_with_the_fundamental_forms() {
    for example in [saddle as Example, paraboloid, torus_outside] {
        let surface = surface(example, 4, 4);
        for (spans, uv) in places(&surface, 4) {
            let (place, d) = (surface.place(spans, uv).unwrap(), surface.at(spans, uv).unwrap());
            let [r1, r2] = place.radii;
            let gauss = d.gaussian_curvature().unwrap() * r1 * r2;
            assert!((gauss - 1.0).abs() < 1e-11, "{gauss}");
            let (e, f, g) = (dot(d.u, d.u), dot(d.u, d.v), dot(d.v, d.v));
            let second = [d.uu, d.uv, d.vv].map(|it| dot(it, place.normal));
            let mean = (e * second[2] - 2.0 * f * second[1] + g * second[0]) / (2.0 * (e * g - f * f));
            assert!((mean + 0.5 / r1 + 0.5 / r2).abs() < 1e-11 * (1.0 / r1.abs() + 1.0 / r2.abs()));
            // The exact normal and that of the derivatives agree in direction and sign.
            let normal = surface.normal(spans, uv).unwrap();
            assert!(distance(normal, d.normal().unwrap()) < 1e-12);
            assert!((dot(normal, place.normal).abs() - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn neighbours_meet_with_common_tangent_planes() {
    let surface = surface(saddle, 4, 4);
    for k in 0..=10 {
        let t = f64::from(k) / 10.0;
        for (a, b) in [(([0, 1], [1.0, t]), ([1, 1], [0.0, t])), (([2, 1], [t, 1.0]), ([2, 2], [t, 0.0]))] {
            let (a, b) = (surface.place(a.0, a.1).unwrap(), surface.place(b.0, b.1).unwrap());
            assert!(distance(a.point, b.point) < 1e-14 && distance(a.normal, b.normal) < 1e-15);
        }
    }
}

#[test]
fn parabolic_data_are_refused_and_named() {
    let flat: Example = |s, t| ([s, t, 0.0], [0.0, 0.0, -1.0]);
    assert_eq!(PnNet::new(&data(flat, 3, 3), PnMethod::Normalised), Err(GeometryError::NormalsEqual));
    for method in [PnMethod::Normalised, PnMethod::Thesis] {
        let tube = PnSurface::new(&data(cylinder, 4, 4), method);
        assert_eq!(tube, Err(GeometryError::Parabolic { patch: [0, 0] }));
    }
    // The crest crosses the middle columns of patches only; the others can be shown alone.
    let net = PnNet::new(&data(torus_crest, 4, 6), PnMethod::Normalised).unwrap();
    assert!(matches!(net.surface(), Err(GeometryError::Parabolic { patch: [0, _] })));
    assert_eq!(net.jacobian(0, 2), Some(Jacobian::Changes));
    let (before, after) = (net.jacobian(1, 0).unwrap(), net.jacobian(1, 4).unwrap());
    assert!(
        before != after && before != Jacobian::Changes && after != Jacobian::Changes,
        "{before:?} {after:?}"
    );
    assert!(net.patch_surface(1, 0).unwrap().is_ok() && net.patch_surface(0, 2).unwrap().is_err());
    assert!(net.patch_surface(0, 5).is_none() && net.jacobian(3, 0).is_none());
    let up: Example = |s, t| ([s, t, 0.1 * (s * s + t * t)], [-0.2 * s, -0.2 * t, 1.0]);
    let error = PnNet::new(&data(up, 3, 3), PnMethod::Thesis);
    assert_eq!(error, Err(GeometryError::NormalUp { row: 0, column: 0 }));
    let round: Example = |s, t| {
        let n = [(3.0 * s).cos() * (1.5 * t).cos(), (3.0 * s).sin() * (1.5 * t).cos(), (1.5 * t).sin()];
        (n, n)
    };
    assert_eq!(PnNet::new(&data(round, 9, 9), PnMethod::Normalised), Err(GeometryError::NormalsTooWide));
}

/// A rotation by any unit quaternion.
fn turned([w, x, y, z]: [f64; 4], p: Point<3>) -> Point<3> {
    let axis = [x, y, z];
    let inner = add_scaled(cross(axis, p), w, p);
    add_scaled(p, 2.0, cross(axis, inner))
}

fn quaternion() -> impl Strategy<Value = [f64; 4]> {
    prop::array::uniform4(-1.0..1.0_f64).prop_filter_map("a direction", |q| {
        let length = norm(q);
        (length > 0.1).then(|| q.map(|c| c / length))
    })
}

fn mapped(
    data: &PnData,
    point: impl Fn(Point<3>) -> Point<3>,
    normal: impl Fn(Point<3>) -> Point<3>,
) -> PnData {
    let rows = |all: &[Point<3>], map: &dyn Fn(Point<3>) -> Point<3>| -> Vec<Vec<Point<3>>> {
        all.chunks(data.size()[1]).map(|row| row.iter().map(|it| map(*it)).collect()).collect()
    };
    PnData::new(&rows(data.points(), &point), &rows(data.normals(), &normal)).unwrap()
}

/// Random data: the graph of a quadratic with some cubic parts, on an uneven grid.
fn graph() -> impl Strategy<Value = PnData> {
    let parts = (prop::array::uniform4(-0.3..0.3_f64), prop::array::uniform3(-0.15..0.15_f64), 0.2..1.0_f64);
    (parts, 2_usize..5, 2_usize..5).prop_map(|((cubic, [a, b, c], bend), rows, columns)| {
        let at = |i: usize, j: usize| {
            let place =
                |k: usize, count: usize| 2.0 * k as f64 / (count - 1) as f64 - 1.0 + 0.05 * (k as f64).sin();
            let (x, y) = (place(i, rows), place(j, columns));
            let z = bend * (x * x + y * y)
                + a * x
                + b * y
                + c * x * y
                + cubic[0] * x * x * x
                + cubic[1] * y * y * y;
            let by_x = 2.0 * bend * x + a + c * y + 3.0 * cubic[0] * x * x;
            let by_y = 2.0 * bend * y + b + c * x + 3.0 * cubic[1] * y * y;
            let normal = [by_x, by_y, -1.0];
            let length = norm(normal);
            ([x, y, z], normal.map(|component| component / length))
        };
        let net = |which: &dyn Fn(usize, usize) -> Point<3>| -> Vec<Vec<Point<3>>> {
            (0..rows).map(|i| (0..columns).map(|j| which(i, j)).collect()).collect()
        };
        PnData::new(&net(&|i, j| at(i, j).0), &net(&|i, j| at(i, j).1)).unwrap()
    })
}

#[test]
fn only_the_normalised_method_is_free_of_coordinates() {
    let data = data(saddle, 4, 4);
    let shift = [1.0, -0.5, 2.0];
    let moved = mapped(&data, |p| add_scaled(p, 1.0, shift), |n| n);
    let change = |method: PnMethod| {
        let (a, b) = (PnSurface::new(&data, method).unwrap(), PnSurface::new(&moved, method).unwrap());
        let apart = |(spans, uv): ([usize; 2], [f64; 2])| {
            let back = add_scaled(b.eval(spans, uv).unwrap(), -1.0, shift);
            distance(a.eval(spans, uv).unwrap(), back)
        };
        places(&a, 4).into_iter().map(apart).fold(0.0, f64::max)
    };
    assert!(change(PnMethod::Normalised) < 1e-13);
    assert!(change(PnMethod::Thesis) > 1e-3);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn similar_data_give_a_similar_surface(
        data in graph(), turn in quaternion(), shift in prop::array::uniform3(-20.0..20.0_f64),
        scale in prop::sample::select(vec![1e-9, 0.3, 37.0, 1e12]),
    ) {
        let map = |p: Point<3>| add_scaled(turned(turn, p).map(|c| c * scale), scale, shift);
        let other = PnNet::new(&mapped(&data, map, |n| turned(turn, n)), PnMethod::Normalised).unwrap();
        let net = PnNet::new(&data, PnMethod::Normalised).unwrap();
        if let (Ok(a), Ok(b)) = (net.surface(), other.surface()) {
            for (spans, uv) in places(&a, 3) {
                let (a, b) = (a.place(spans, uv).unwrap(), b.place(spans, uv).unwrap());
                let [r1, r2] = a.radii;
                // Radii grow without limit near parabolic points, and rounding with them.
                let size = 40.0 + r1.abs().max(r2.abs()).powi(2);
                prop_assert!(distance(map(a.point), b.point) < 1e-13 * scale * size);
                prop_assert!(distance(turned(turn, a.normal), b.normal) < 1e-12);
                prop_assert!((a.radii[0] * scale - b.radii[0]).abs() < 1e-11 * scale * size);
            }
        }
    }

    #[test]
    fn offset_data_give_the_offset(data in graph(), d in -2.0..2.0_f64) {
        let moved = data.offset(d).unwrap();
        let [here, there] = [&data, &moved].map(|data| PnSurface::new(data, PnMethod::Normalised));
        if let (Ok(a), Ok(b)) = (here, there) {
            let offset = a.offset(d).unwrap();
            let back = offset.offset(-d).unwrap();
            for (spans, uv) in places(&a, 3) {
                let (here, there) = (a.place(spans, uv).unwrap(), offset.place(spans, uv).unwrap());
                let size = 10.0 + here.radii[0].abs().max(here.radii[1].abs()).powi(2);
                prop_assert!(distance(there.point, b.eval(spans, uv).unwrap()) < 1e-13 * size);
                prop_assert!(distance(add_scaled(here.point, d, here.normal), there.point) < 1e-14 * size);
                prop_assert!((here.radii[0] + d - there.radii[0]).abs() < 1e-14 * size);
                prop_assert!(distance(here.point, back.eval(spans, uv).unwrap()) < 1e-14 * size);
            }
        }
    }

    /// No sign of the Jacobian is contradicted by samples of the normals' area.
    #[test]
    fn proved_signs_hold(data in graph(), noise in prop::collection::vec(prop::array::uniform3(-0.2..0.2_f64), 16)) {
        let noisy = mapped(&data, |p| p, |n| {
            let index = data.normals().iter().position(|other| *other == n).unwrap_or(0);
            let moved = add_scaled(n, 1.0, noise[index % noise.len()]);
            let length = norm(moved);
            moved.map(|c| c / length)
        });
        let net = PnNet::new(&noisy, PnMethod::Normalised).unwrap();
        for [i, j] in crate::geometry::surface::indices(net.size()) {
            let y = net.isotropic(i, j).unwrap();
            let signs = crate::geometry::surface::indices([15, 15]).map(|place| {
                let [u, v] = place.map(|k| k as f64 / 14.0);
                let d = y.derivatives(u, v);
                d.u[0] * d.v[1] - d.v[0] * d.u[1]
            });
            let (low, high) = signs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
            match net.jacobian(i, j).unwrap() {
                Jacobian::Positive => prop_assert!(low > 0.0),
                Jacobian::Negative => prop_assert!(high < 0.0),
                Jacobian::Changes => {}
            }
        }
    }

    /// Whatever the data are, answers are errors or finite numbers.
    #[test]
    fn any_data_are_refused_or_finite(
        points in prop::collection::vec(prop::array::uniform3(prop::num::f64::ANY), 9),
        normals in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 9),
        scale in prop::sample::select(vec![0.0, 1e-320, 1e-150, 1.0, 1e149]),
        d in prop::num::f64::ANY,
    ) {
        let points: Vec<Vec<_>> = points.chunks(3).map(|row| row.iter().map(|p| p.map(|c| {
            if scale == 1.0 { c } else { scale * (c.abs().log10() / 300.0).clamp(-1.0, 1.0) }
        })).collect()).collect();
        let unit = |n: &Point<3>| { let length = norm(*n); n.map(|c| c / length) };
        // Near to -z, so that many are regular.
        let normals: Vec<Vec<_>> = normals.chunks(3).enumerate().map(|(i, row)| row.iter().enumerate().map(|(j, n)| {
            unit(&[i as f64 - 1.0 + 0.2 * n[0], j as f64 - 1.0 + 0.2 * n[1], -2.0])
        }).collect()).collect();
        let Ok(data) = PnData::new(&points, &normals) else { return Ok(()) };
        for method in [PnMethod::Normalised, PnMethod::Thesis] {
            let Ok(surface) = PnSurface::new(&data, method) else { continue };
            let offset = surface.offset(d);
            for surface in std::iter::once(surface).chain(offset) {
                for (spans, uv) in places(&surface, 2) {
                    let finite = |p: Option<Point<3>>| p.is_none_or(|p| p.iter().all(|c| c.is_finite()));
                    prop_assert!(finite(surface.eval(spans, uv)));
                    prop_assert!(finite(surface.place(spans, uv).map(|it| it.normal)));
                    prop_assert!(finite(ParamSurface::normal(&surface, spans, uv)));
                    prop_assert!(finite(surface.at(spans, uv).map(|it| it.uu)));
                    let rational = surface.rational_patch(spans).unwrap();
                    prop_assert!(finite(rational.eval(uv[0], uv[1])));
                }
                let limits = surface.safe_distances().map(|it| [it.low, it.high]);
                prop_assert!(limits.into_iter().flatten().flatten().all(f64::is_finite));
                let _ = surface.to_rational();
            }
        }
    }
}
