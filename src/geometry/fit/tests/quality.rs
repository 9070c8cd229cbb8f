//! What the fit reaches on clouds of known surfaces: data RMS at most 1.15 of the noise, surface RMS at most 0.6 of it.

use super::super::{Fit, Fitted, Report};
use crate::geometry::cloud::{Cloud, CloudShape};
use crate::geometry::kohonen::{Learning, Net, Rule, Topology};
use crate::geometry::{ParamCurve, ParamSurface, Point};

const NOISE: f64 = 0.02;

fn learnt(cloud: &Cloud, start: Net, radius: Option<f64>) -> Net {
    let rule = Rule { steps: Some(20_000), radius, ..Rule::default() };
    let mut learning = Learning::new(cloud, start, rule).unwrap();
    learning.advance(u64::MAX);
    learning.into_net()
}

fn fitted(cloud: &Cloud, net: &Net) -> (Report, Fit) {
    let mut fit = Fit::new(cloud, net, Fit::CORRECTIONS).unwrap();
    while fit.advance(10_000).is_none() {}
    (fit.report().unwrap().clone(), fit)
}

fn rms(shape: CloudShape, points: &[Point<3>]) -> f64 {
    (points.iter().map(|point| shape.distance(*point).powi(2)).sum::<f64>() / points.len() as f64).sqrt()
}

#[test]
fn data_and_surface_are_as_near_as_the_noise_allows() {
    use CloudShape::{Hemisphere, Ring, Saddle, Sphere, Terrain, Torus};
    for (shape, size, topology) in [
        (Saddle, [10, 10], Topology::Open),
        (Hemisphere, [12, 12], Topology::Open),
        (Terrain, [12, 12], Topology::Open),
        (Ring, [6, 24], Topology::Cylinder),
        (Sphere, [12, 20], Topology::Sphere),
        (Torus, [10, 16], Topology::Torus),
    ] {
        let cloud = Cloud::of_shape(shape, 3000, NOISE, 2).unwrap();
        let net = if topology == Topology::Open {
            learnt(&cloud, Net::random(&cloud, size, topology, 5).unwrap(), None)
        } else {
            learnt(&cloud, Net::shaped(&cloud, size, topology).unwrap(), Some(1.0))
        };
        let (report, fit) = fitted(&cloud, &net);
        let Fitted::Surface(surface) = fit.fitted().unwrap() else { panic!("a surface") };
        let (data, truth) = (report.rms / NOISE, rms(shape, surface.grid(3).unwrap().points()) / NOISE);
        assert!(data < 1.15 && truth < 0.6, "{}: {data} {truth}", shape.name());
        // Every correction gains, the base surface was far worse.
        assert!(report.history.windows(2).all(|pair| pair[1] <= pair[0]));
        assert!(report.mean.abs() < 0.1 * report.rms && report.percentile_95 < 2.2 * NOISE);
        assert!(report.largest >= report.percentile_95 && report.points == 3000);
        let control = fit.net().unwrap();
        assert_eq!((control.size(), control.topology()), (size, topology));
    }
}

/// Against the nearest of many places of the surface: what is told is no longer, at borders and corners either.
#[test]
fn distances_are_those_of_the_nearest_places() {
    for (shape, size) in [(CloudShape::Hemisphere, [9, 9]), (CloudShape::Saddle, [8, 8])] {
        let cloud = Cloud::of_shape(shape, 700, NOISE, 1).unwrap();
        let net = learnt(&cloud, Net::random(&cloud, size, Topology::Open, 1).unwrap(), None);
        let (report, fit) = fitted(&cloud, &net);
        let Fitted::Surface(surface) = fit.fitted().unwrap() else { panic!("a surface") };
        let places = surface.grid(30).unwrap();
        for (point, distance) in cloud.points().iter().zip(fit.distances()) {
            let square =
                |place: &Point<3>| place.iter().zip(point).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
            let nearest = places.points().iter().map(square).fold(f64::INFINITY, f64::min).sqrt();
            assert!(
                distance.abs() <= nearest + 0.01 * report.rms,
                "{}: {point:?} {distance} {nearest}",
                shape.name()
            );
        }
    }
}

#[test]
fn a_letter_becomes_a_curve() {
    let cloud = Cloud::of_shape(CloudShape::Letter, 2000, NOISE, 2).unwrap();
    let mut reports = Vec::new();
    for size in [[24, 1], [1, 24]] {
        let net = learnt(&cloud, Net::random(&cloud, size, Topology::Open, 5).unwrap(), None);
        let (report, fit) = fitted(&cloud, &net);
        let Fitted::Curve(curve) = fit.fitted().unwrap() else { panic!("a curve") };
        let (data, truth) =
            (report.rms / NOISE, rms(CloudShape::Letter, &curve.polyline(10).unwrap()) / NOISE);
        assert!(data < 1.15 && truth < 0.6, "{data} {truth}");
        reports.push((report.rms, fit.distances().to_vec()));
    }
    // A row is a column.
    assert!((reports[0].0 - reports[1].0).abs() < 1e-9);
    assert!(reports[0].1.iter().zip(&reports[1].1).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn a_circle_of_points_becomes_a_closed_curve() {
    let ring = Cloud::of_shape(CloudShape::Ring, 2000, 0.01, 2).unwrap();
    let flat: Vec<Point<3>> = ring.points().iter().map(|[x, y, _]| [*x, *y, 0.0]).collect();
    let cloud = Cloud::new(flat).unwrap();
    for (size, topology) in [([1, 16], Topology::Cylinder), ([16, 1], Topology::Torus)] {
        let net = learnt(&cloud, Net::random(&cloud, size, topology, 5).unwrap(), None);
        let (report, fit) = fitted(&cloud, &net);
        let Fitted::Curve(curve) = fit.fitted().unwrap() else { panic!("a curve") };
        assert!(curve.closed() && curve.spans() == 16);
        assert!(report.rms < 0.0115, "{}", report.rms);
        // Positive outside.
        let outside = |k: usize| fit.distances()[k] > 0.0;
        let far = |[x, y, _]: Point<3>| x.hypot(y) - 1.0;
        assert!(
            (0..2000)
                .filter(|k| far(cloud.points()[*k]).abs() > 0.01)
                .all(|k| outside(k) == (far(cloud.points()[k]) > 0.0))
        );
    }
}

#[test]
fn distances_are_positive_above_and_outside() {
    for (shape, topology, size) in [
        (CloudShape::Terrain, Topology::Open, [8, 8]),
        (CloudShape::Sphere, Topology::Sphere, [8, 12]),
        (CloudShape::Torus, Topology::Torus, [8, 14]),
        (CloudShape::Ring, Topology::Cylinder, [4, 16]),
    ] {
        let clean = Cloud::of_shape(shape, 2000, 0.0, 2).unwrap();
        let mut points = clean.points().to_vec();
        // The first point is lifted off.
        let [x, y, z] = points[0];
        points[0] = match shape {
            CloudShape::Terrain => [x, y, z + 0.3],
            CloudShape::Sphere => [1.3 * x, 1.3 * y, 1.3 * z],
            _ => {
                let r = x.hypot(y);
                [x * (r + 0.3) / r, y * (r + 0.3) / r, z]
            }
        };
        if shape == CloudShape::Torus {
            points[0] = [1.7, 0.0, 0.0];
        }
        let cloud = Cloud::new(points).unwrap();
        for seed in 1..=3 {
            let net = if topology == Topology::Open {
                learnt(&cloud, Net::random(&cloud, size, topology, seed).unwrap(), None)
            } else {
                let start = Net::shaped(&cloud, size, topology).unwrap();
                // Half of the nets are mirrored.
                let mut rows = start.rows();
                if seed == 2 {
                    rows.iter_mut().for_each(|row| row.reverse());
                }
                learnt(&cloud, Net::new(topology, &rows).unwrap(), Some(1.0))
            };
            let (report, fit) = fitted(&cloud, &net);
            assert!(fit.distances()[0] > 0.15, "{} {seed}: {}", shape.name(), fit.distances()[0]);
            assert!(report.largest >= fit.distances()[0]);
        }
    }
}
