//! Values of exact arithmetic.

use super::super::{KnotError, KnotSurface, KnotVector, Pair};
use super::reference::{ENVELOPES, LIMITS, OPPOSED, PATHS, REFINED, SAMPLES, SURFACES, THROUGH, WEIGHTS};
use super::{apart, curve};

/// The largest coordinate of the curves.
const SIZE: f64 = 100.0;

#[test]
fn points_and_derivatives() {
    for (given, at, rows) in SAMPLES {
        let curve = curve(given);
        for (k, &u) in at.iter().enumerate() {
            let all = curve.derivatives(u, 2).unwrap();
            for (r, row) in rows.iter().enumerate() {
                let size = SIZE.max(row[k][0].abs()).max(row[k][1].abs());
                assert!(apart(all[r], row[k]) < 1e-14 * size, "{r}: {:?} {:?}", all[r], row[k]);
            }
        }
    }
}

#[test]
fn paths_of_points() {
    for (given, knot, paths) in PATHS {
        let curve = curve(given);
        for &(span, u, values, points, straight) in *paths {
            let path = curve.path(*knot, span, u).unwrap();
            assert_eq!(path.straight().is_some(), straight);
            assert_eq!(path.order() == 1, straight);
            for (value, point) in values.iter().zip(points) {
                assert!(apart(path.at(*value).unwrap(), *point) < 1e-13 * SIZE);
            }
        }
    }
}

#[test]
fn envelopes() {
    for &(ref given, knot, multiplicity, order, control, range, ratio, at, points) in ENVELOPES {
        let curve = curve(given);
        let envelope = curve.envelope(knot, multiplicity).unwrap();
        assert_eq!(envelope.curve.vector().order(), order);
        assert_eq!(envelope.curve.vector().domain(), range);
        assert_eq!(envelope.knots.len() + multiplicity, given.knots.len());
        match (envelope.curvature_ratio, ratio) {
            (Some(a), Some(b)) => assert!((a - b).abs() < 1e-15),
            (a, b) => assert_eq!(a, b),
        }
        for (a, b) in envelope.curve.points().iter().zip(control) {
            assert!(apart(*a, *b) < 1e-14 * SIZE);
        }
        for (v, point) in at.iter().zip(points) {
            assert!(apart(envelope.curve.point_at(*v).unwrap(), *point) < 1e-14 * SIZE);
        }
    }
}

#[test]
fn limits_belong_to_arcs() {
    for (given, knot, multiplicity, [after, before]) in LIMITS {
        let limits = curve(given).limits(*knot, *multiplicity).unwrap();
        assert_eq!((limits.after, limits.before), (Some(*after), Some(*before)));
    }
}

#[test]
fn opposed_knots() {
    for (given, knot, u, values, points, straight) in OPPOSED {
        let curve = curve(given);
        let path = curve.opposed(*knot, *u).unwrap();
        assert_eq!(path.straight(), *straight);
        assert_eq!(path.pencil(), (given.order == 3 && *straight).then_some(*knot));
        for (t, point) in values.iter().zip(*points) {
            assert!(apart(path.at(*t).unwrap(), *point) < 1e-13 * SIZE);
        }
    }
}

#[test]
fn through_points() {
    for &(by, ref given, point, index, u, knots) in THROUGH {
        let curve = curve(given);
        if by == "one" {
            let [value, u] = knots.unwrap() else { panic!("a value and u") };
            let found = curve.through_knot(point, index).unwrap();
            assert!(found.iter().all(|it| it.miss(point) < 1e-10));
            let near = found
                .iter()
                .any(|it| (it.curve.vector().knots()[index] - value).abs() < 1e-7 && (it.u - u).abs() < 1e-7);
            assert!(near, "{found:?} {value} {u}");
            continue;
        }
        let found = match by.strip_prefix("pair:") {
            None => curve.through_outer(point, index, u),
            Some(name) => {
                let pair = Pair::ALL.into_iter().find(|pair| pair.name() == name).unwrap();
                curve.through_pair(point, index, u, pair)
            }
        };
        match (found, knots) {
            (Ok(found), Some(knots)) => {
                assert!(found.miss(point) < 1e-12 * SIZE);
                for (a, b) in found.curve.vector().knots().iter().zip(knots) {
                    assert!((a - b).abs() < 1e-11, "{by}: {a} {b}");
                }
            }
            (Err(KnotError::Unreached(_)), None) => {}
            (found, knots) => panic!("{by}: {found:?} {knots:?}"),
        }
    }
}

#[test]
fn through_points_by_weights() {
    for &(ref given, point, knot, u, pair, weights) in WEIGHTS {
        match curve(given).through_weights(point, knot, u, pair) {
            Ok(found) => {
                assert!(found.miss(point) < 1e-12 * SIZE);
                for (i, weight) in pair.iter().zip(weights) {
                    assert!((found.curve.weights().unwrap()[*i] - weight).abs() < 1e-10 * weight);
                }
            }
            Err(error) => assert!(weights[0] <= 0.0 || weights[1] <= 0.0, "{error}"),
        }
    }
}

#[test]
fn insertion_and_removal() {
    for &(ref given, u, points) in REFINED {
        let coarse = curve(given);
        let fine = coarse.with_inserted(u).unwrap();
        for (a, b) in fine.points().iter().zip(points) {
            assert!(apart(*a, *b) < 1e-14 * SIZE);
        }
        let knot = fine.vector().knots().iter().position(|x| *x == u).unwrap();
        let (back, by) = fine.with_removed(knot, 1e-9).unwrap();
        assert!(by < 1e-12 && back.vector() == coarse.vector());
        for (a, b) in back.points().iter().zip(coarse.points()) {
            assert!(apart(*a, *b) < 1e-12 * SIZE);
        }
        assert!(matches!(back.with_removed(given.order, 1e-9), Err(KnotError::WouldMove { .. })));
    }
}

#[test]
fn surfaces_through_points() {
    for &([u, v], net, point, at) in SURFACES {
        let vectors = [u, v].map(|knots| KnotVector::new(4, knots.to_vec()).unwrap());
        let net = net.iter().map(|row| row.to_vec()).collect();
        let surface = KnotSurface::new(vectors, net, None).unwrap();
        let moved = surface.through_outer(point, at).unwrap();
        assert!(apart(moved.point_at(at).unwrap(), point) < 1e-12 * SIZE);
        assert!(surface.through_outer([1e3, 0.0, 0.0], at).is_err());
    }
}

#[test]
fn the_least_move_is_found() {
    for (by, given, point, index, u, knots) in THROUGH.iter().filter(|(by, ..)| *by == "outer") {
        let curve = curve(given);
        let Ok((_, found)) = curve.through_any(*point) else {
            assert!(knots.is_none(), "{by} reaches {point:?}");
            continue;
        };
        assert!(found.miss(*point) < 1e-10 * SIZE);
        if knots.is_some() {
            let one = curve.through_outer(*point, *index, *u).unwrap();
            assert!(found.effort(curve.vector()) <= one.effort(curve.vector()) * (1.0 + 1e-2) + 1e-6);
        }
    }
    let curve = curve(&THROUGH[0].1);
    let far = [curve.points()[4][0], 1000.0];
    assert!(curve.through_any(far).is_err());
    let nearest = curve.nearest_reached(far).unwrap();
    assert!(nearest[1] < 100.0 && curve.through_any(nearest).is_ok());
}
