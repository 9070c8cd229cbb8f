//! The fit as a task: budgets, units, and clouds that say little.

use super::super::{Fit, FitError, Report, Stage};
use super::shapes;
use crate::geometry::Point;
use crate::geometry::cloud::{Cloud, CloudShape};
use crate::geometry::kohonen::{Learning, Net, Order, Rule, Topology};
use proptest::prelude::*;

fn learnt(cloud: &Cloud, size: [usize; 2], topology: Topology) -> Net {
    let start = Net::random(cloud, size, topology, 1).unwrap();
    let rule = Rule { steps: Some(2000), order: Order::Random(1), ..Rule::default() };
    let mut learning = Learning::new(cloud, start, rule).unwrap();
    learning.advance(u64::MAX);
    learning.into_net()
}

fn finished(mut fit: Fit, budget: usize) -> (Report, Fit) {
    loop {
        if let Some(report) = fit.advance(budget) {
            return (report.clone(), fit);
        }
    }
}

fn cloud_of(topology: Topology) -> CloudShape {
    match topology {
        Topology::Open => CloudShape::Terrain,
        Topology::Cylinder => CloudShape::Ring,
        Topology::Torus => CloudShape::Torus,
        Topology::Sphere => CloudShape::Sphere,
    }
}

fn finite(fit: &Fit) -> bool {
    let points = fit.net().unwrap().rows().concat();
    let distances = fit.distances().iter().all(|d| d.is_finite());
    let parameters = fit.parameters().iter().flatten().all(|u| (0.0..=1.0).contains(u));
    points.iter().flatten().all(|x| x.is_finite()) && distances && parameters
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn budgets_do_not_matter(
        (topology, size) in shapes(),
        budgets in proptest::collection::vec(1_usize..300, 1..6),
        corrections in 0_usize..3,
    ) {
        let cloud = Cloud::of_shape(cloud_of(topology), 200, 0.02, 3).unwrap();
        let net = learnt(&cloud, size, topology);
        let fit = Fit::new(&cloud, &net, corrections).unwrap();
        let (report, other) = finished(fit.clone(), usize::MAX);
        let mut one = fit;
        let mut progress = 0.0;
        for budget in budgets.into_iter().cycle() {
            let done = one.advance(budget).is_some();
            prop_assert!(one.progress() >= progress && one.progress() <= 1.0);
            progress = one.progress();
            prop_assert!(one.fitted().is_ok());
            prop_assert_eq!(done, one.stage() == Stage::Done);
            if done {
                break;
            }
        }
        prop_assert_eq!(one.report(), Some(&report));
        prop_assert_eq!(one.fitted().unwrap(), other.fitted().unwrap());
        prop_assert_eq!(one.distances(), other.distances());
        prop_assert_eq!(one.parameters(), other.parameters());
        prop_assert!(one.history().len() <= corrections + 1 && finite(&one));
    }

    #[test]
    fn any_cloud_can_be_fitted(
        (topology, size) in shapes(),
        points in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0), 1..6),
        flat in proptest::array::uniform3(prop_oneof![Just(0.0), Just(1.0), Just(1e-300), Just(1e100)]),
        far in prop_oneof![Just(0.0), Just(1e9)],
    ) {
        // A few points again and again: equal, on a line, in a plane, tiny, huge or far away.
        let count = size[0] * size[1] + 20;
        let points: Vec<Point<3>> = points
            .iter()
            .map(|p| std::array::from_fn(|d| far + p[d] * flat[d]))
            .cycle()
            .take(count)
            .collect();
        let cloud = Cloud::new(points).unwrap();
        let net = learnt(&cloud, size, topology);
        let (report, fit) = finished(Fit::new(&cloud, &net, 2).unwrap(), 50);
        prop_assert!(finite(&fit));
        prop_assert!([report.rms, report.largest, report.mean, report.percentile_95].iter().all(|x| x.is_finite()));
        // No farther than the cloud is wide.
        prop_assert!(report.rms <= cloud.diagonal() + cloud.bounds().last_bits(), "{:?}", report);
    }

    #[test]
    fn unit_and_place_do_not_matter(power in -60_i32..60, shift in -4.0..4.0, seed in 0_u64..50) {
        let cloud = Cloud::of_shape(CloudShape::Hemisphere, 300, 0.02, seed).unwrap();
        let net = learnt(&cloud, [5, 5], Topology::Open);
        let unit = 2.0_f64.powi(power);
        let other = |point: &Point<3>| -> Point<3> { point.map(|x| unit * (x + shift)) };
        let rows: Vec<Vec<Point<3>>> = net.rows().iter().map(|row| row.iter().map(other).collect()).collect();
        let moved = Cloud::new(cloud.points().iter().map(other).collect::<Vec<_>>()).unwrap();
        let moved_net = Net::new(Topology::Open, &rows).unwrap();
        let (one, _) = finished(Fit::new(&cloud, &net, 2).unwrap(), 1000);
        let (two, _) = finished(Fit::new(&moved, &moved_net, 2).unwrap(), 1000);
        prop_assert!((two.rms / unit / one.rms - 1.0).abs() < 1e-6, "{} {}", one.rms, two.rms / unit);
    }
}

#[test]
fn too_few_points_are_told() {
    let cloud = Cloud::of_shape(CloudShape::Saddle, 99, 0.02, 1).unwrap();
    let net = Net::random(&cloud, [10, 10], Topology::Open, 1).unwrap();
    let error = Fit::new(&cloud, &net, 5).unwrap_err();
    assert_eq!(error, FitError::TooFewPoints { given: 99, needed: 100 });
    assert_eq!(
        error.to_string(),
        "the cloud has 99 points, but 100 control points can only be found from as many or more; take a smaller net"
    );
    // The poles of a sphere are one control point each.
    let net = Net::random(&cloud, [10, 10], Topology::Sphere, 1).unwrap();
    assert!(Fit::new(&cloud, &net, 5).is_ok());
    assert!(Fit::new(&cloud, &Net::random(&cloud, [3, 9], Topology::Open, 1).unwrap(), 5).is_err());
}

#[test]
fn a_surface_without_noise_is_found_again() {
    // Points of a bicubic surface, and its own net moved a little.
    let node = |i: usize, j: usize| {
        let (x, y) = (i as f64, j as f64);
        [x, y, 0.3 * ((i * 7 + j * 5) % 4) as f64]
    };
    let rows: Vec<Vec<Point<3>>> = (0..6).map(|i| (0..6).map(|j| node(i, j)).collect()).collect();
    let truth = super::super::Fitted::of_net(&Net::new(Topology::Open, &rows).unwrap()).unwrap();
    let surface = truth.surface().unwrap();
    let at = |k: usize| surface.point_at([(k % 41) as f64 / 40.0, (k / 41) as f64 / 40.0]).unwrap();
    let cloud = Cloud::new((0..41 * 41).map(at).collect::<Vec<_>>()).unwrap();
    let start: Vec<Vec<Point<3>>> =
        rows.iter().map(|row| row.iter().map(|[x, y, _]| [*x, *y, 0.5]).collect()).collect();
    let fit = Fit::new(&cloud, &Net::new(Topology::Open, &start).unwrap(), 60).unwrap();
    let (report, _) = finished(fit, 5000);
    assert!(report.rms < 2e-3, "{:?}", report.history);
}
