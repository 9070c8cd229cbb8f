use super::*;
use crate::geometry::pn::examples::{Example, data, paraboloid, saddle, sphere, torus_outside};
use crate::geometry::point::{norm, scaled_difference};
use crate::geometry::{PnData, PnMethod};

fn surface(example: Example, rows: usize, columns: usize) -> PnSurface {
    PnSurface::new(&data(example, rows, columns), PnMethod::Normalised).unwrap()
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    norm(scaled_difference(1.0, a, b))
}

/// De Boor's scheme with homogeneous points, by the definition of knots.
fn de_boor(knots: &[f64], points: &[[f64; 4]], t: f64) -> [f64; 4] {
    let span = (DEGREE..points.len()).rev().find(|&j| knots[j] <= t && knots[j] < knots[j + 1]).unwrap();
    let mut d = points[span - DEGREE..=span].to_vec();
    for round in 1..=DEGREE {
        for j in (round..=DEGREE).rev() {
            let (from, to) = (knots[span - DEGREE + j], knots[span + 1 + j - round]);
            let part = (t - from) / (to - from);
            d[j] = std::array::from_fn(|c| (1.0 - part) * d[j - 1][c] + part * d[j][c]);
        }
    }
    d[DEGREE]
}

#[test]
fn patches_are_the_surface_and_its_offsets() {
    for (example, size) in
        [(saddle as Example, 4.0), (paraboloid, 40.0), (sphere, 40.0), (torus_outside, 80.0)]
    {
        for d in [0.0, 0.01 * size, -0.03 * size] {
            let surface = surface(example, 3, 4).offset(d).unwrap();
            for sample in surface.sample(7).unwrap() {
                let patch = surface.rational_patch(sample.spans).unwrap();
                assert_eq!(patch.degrees(), [11, 11]);
                let [u, v] = sample.parameters;
                assert!(distance(patch.eval(u, v).unwrap(), sample.point) < 4e-14 * size);
                let [_, right] = patch.halves(0);
                let half = right.eval((2.0 * u - 1.0).max(0.0), v).unwrap();
                assert!(u < 0.5 || distance(half, sample.point) < 4e-14 * size);
            }
        }
    }
}

#[test]
fn offsets_have_the_same_weights() {
    let surface = surface(saddle, 3, 4);
    let offset = surface.offset(-0.7).unwrap();
    let weights = |surface: &PnSurface| surface.rational_patch([1, 2]).unwrap().parts[3].clone();
    assert_eq!(weights(&surface), weights(&offset));
    assert!(surface.rational_patch([1, 2]).unwrap().has_positive_weights());
    assert_eq!(surface.rational_patch([0, 3]), None);
    assert_eq!(surface.rational_patch([2, 0]), None);
}

#[test]
fn whole_surface_is_one_b_spline() {
    for d in [0.0, -0.2] {
        let surface = surface(saddle, 3, 4).offset(d).unwrap();
        let whole = surface.to_rational().unwrap();
        assert_eq!((whole.net.len(), whole.net[0].len()), (23, 34));
        assert_eq!(whole.multiplicities, [vec![12, 11, 12], vec![12, 11, 11, 12]]);
        let [by_u, by_v] = [0, 1].map(|direction| whole.knot_vector(direction));
        assert_eq!((by_u.len(), by_v.len()), (23 + 12, 34 + 12));
        assert!(whole.net.iter().flatten().all(|point| point[3] > 0.0));
        for sample in surface.sample(4).unwrap() {
            let [s, t] = [0, 1].map(|d| sample.spans[d] as f64 + sample.parameters[d]);
            let row: Vec<[f64; 4]> = whole.net.iter().map(|row| de_boor(&by_v, row, t)).collect();
            let point = homogeneous_point(de_boor(&by_u, &row, s)).unwrap();
            assert!(distance(point, sample.point) < 1e-13);
        }
    }
}

#[test]
fn neighbours_share_the_points_of_their_border() {
    let surface = surface(paraboloid, 3, 3).offset(1.0).unwrap();
    let points = |i, j| surface.rational_patch([i, j]).unwrap().points();
    for k in 0..12 {
        for (a, b) in [(points(0, 1)[11][k], points(1, 1)[0][k]), (points(1, 0)[k][11], points(1, 1)[k][0])] {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14 * (1.0 + a.abs())), "{a:?} {b:?}");
        }
    }
}

/// Strips are halved where weights are negative although the Jacobian is not.
#[test]
fn weights_become_positive_by_halving() {
    let normal = |i: usize, j: usize| {
        let [p, q]: [f64; 2] = [[[-0.38, -0.66], [-0.22, 0.18]], [[0.7, -0.86], [0.18, 0.82]]][i][j];
        let length = norm([p, q, 1.0]);
        [p / length, q / length, -1.0 / length]
    };
    let point = |i: usize, j: usize| [i as f64, j as f64, [[-0.1, -0.9], [-0.1, 0.7]][i][j]];
    let net = |at: &dyn Fn(usize, usize) -> Point<3>| -> Vec<Vec<Point<3>>> {
        (0..2).map(|i| (0..2).map(|j| at(i, j)).collect()).collect()
    };
    let data = PnData::new(&net(&point), &net(&normal)).unwrap();
    let surface = PnSurface::new(&data, PnMethod::Normalised).unwrap();
    assert!(!surface.rational_patch([0, 0]).unwrap().has_positive_weights());
    let whole = surface.to_rational().unwrap();
    assert_eq!(whole.knots, [[0.0, 0.5, 1.0], [0.0, 0.5, 1.0]]);
    assert!(whole.net.iter().flatten().all(|point| point[3] > 0.0));
    let [by_u, by_v] = [0, 1].map(|direction| whole.knot_vector(direction));
    for sample in surface.sample(8).unwrap() {
        let [u, v] = sample.parameters;
        let row: Vec<[f64; 4]> = whole.net.iter().map(|row| de_boor(&by_v, row, v)).collect();
        let point = homogeneous_point(de_boor(&by_u, &row, u)).unwrap();
        assert!(distance(point, sample.point) < 1e-11 * (1.0 + norm(point)), "{point:?} {:?}", sample.point);
    }
}
