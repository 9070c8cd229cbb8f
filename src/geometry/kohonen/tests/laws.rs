//! A step against its formulas written plainly, and what must hold for every net.

use super::super::{End, KohonenError, Learning, Net, Order, Rule, Schedule, Topology, Weighting};
use crate::geometry::cloud::{Cloud, CloudShape};
use crate::geometry::{Point, cross, dot, norm};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// The distance on the net by which a neuron is a neighbour: squared for bells, of rows or columns for bubbles.
fn apart(topology: Topology, [m, n]: [usize; 2], a: [usize; 2], b: [usize; 2], bubble: bool) -> f64 {
    if topology == Topology::Sphere {
        let place = |[i, j]: [usize; 2]| {
            let (a, b) = (PI * i as f64 / (m - 1) as f64, TAU * j as f64 / n as f64);
            [a.sin() * b.cos(), a.sin() * b.sin(), a.cos()]
        };
        let angle = norm(cross(place(a), place(b))).atan2(dot(place(a), place(b))) * (m - 1) as f64 / PI;
        return if bubble { angle } else { angle * angle };
    }
    let [closed_i, closed_j] = topology.closed();
    let ring = |closed: bool, count: usize, d: usize| if closed { d.min(count - d) } else { d };
    let (i, j) = (ring(closed_i, m, a[0].abs_diff(b[0])), ring(closed_j, n, a[1].abs_diff(b[1])));
    if bubble { i.max(j) as f64 } else { (i * i + j * j) as f64 }
}

/// One pass through a cloud by the formulas.
fn plainly(start: &Net, cloud: &Cloud, weighting: Weighting) -> Vec<Vec<Point<3>>> {
    let (mut net, [m, n]) = (start.rows(), start.size());
    let start_radius = m.max(n) as f64 / 2.0;
    for (t, point) in cloud.points().iter().enumerate() {
        let f = t as f64 / cloud.points().len() as f64;
        let square = |w: &Point<3>| (0..3).map(|d| (w[d] - point[d]).powi(2)).sum::<f64>();
        let places = (0..m).flat_map(|i| (0..n).map(move |j| [i, j]));
        let winner = places
            .clone()
            .min_by(|a, b| square(&net[a[0]][a[1]]).total_cmp(&square(&net[b[0]][b[1]])))
            .unwrap();
        let gain = 0.5 * (0.01_f64 / 0.5).powf(f);
        let radius = start_radius * (0.5 / start_radius).powf(f);
        let bubble = weighting == Weighting::Bubble;
        for [i, j] in places {
            let d = apart(start.topology(), [m, n], winner, [i, j], bubble);
            let h = if bubble {
                let within = ((start_radius + 1.0) * (1.0 - f).powi(2)).floor();
                if d <= within + 1e-6 { gain } else { 0.0 }
            } else {
                gain * (-d / (2.0 * radius * radius)).exp()
            };
            let w = &mut net[i][j];
            *w = std::array::from_fn(|d| w[d] + h * (point[d] - w[d]));
        }
    }
    net
}

fn finite(net: &Net) -> bool {
    net.rows().concat().iter().flatten().all(|x| x.is_finite())
}

fn topology() -> impl Strategy<Value = Topology> {
    proptest::sample::select(Topology::ALL.to_vec())
}

fn weighting() -> impl Strategy<Value = Weighting> {
    prop_oneof![Just(Weighting::Gauss), Just(Weighting::Bubble)]
}

/// A net of a size within reach.
fn size(topology: Topology) -> impl Strategy<Value = [usize; 2]> {
    let rows = if topology == Topology::Sphere { 3_usize } else { 1 };
    (rows..11, 1_usize..11).prop_map(|(m, n)| [m, n])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_pass_is_that_of_the_formulas(
        (topology, size) in topology().prop_flat_map(|topology| (Just(topology), size(topology))),
        weighting in weighting(),
        seed: u64,
    ) {
        let cloud = Cloud::of_shape(CloudShape::Terrain, 200, 0.1, seed).unwrap();
        // Spread, so that winners differ from the first step.
        let wide = Cloud::new(cloud.points().iter().map(|p| p.map(|x| 20.0 * x)).collect::<Vec<_>>()).unwrap();
        let start = Net::random(&wide, size, topology, seed).unwrap();
        let rule = Rule { weighting, order: Order::Listed, ..Rule::default() };
        let mut learning = Learning::new(&cloud, start.clone(), rule).unwrap();
        learning.advance(u64::MAX);
        let pairs = learning.net().rows().concat().into_iter().zip(plainly(&start, &cloud, weighting).concat());
        let error = pairs.flat_map(|(a, b)| [0, 1, 2].map(|d| (a[d] - b[d]).abs())).fold(0.0, f64::max);
        // Distances between neurons of a sphere are not whole numbers.
        prop_assert!(error < 1e-11, "{:e}", error);
    }

    #[test]
    fn budgets_do_not_matter(
        (topology, size) in topology().prop_flat_map(|topology| (Just(topology), size(topology))),
        weighting in weighting(),
        budgets in proptest::collection::vec(1_u64..400, 1..8),
        grows: bool,
    ) {
        let cloud = Cloud::of_shape(CloudShape::Torus, 300, 0.02, 5).unwrap();
        let start = Net::random(&cloud, size, topology, 7).unwrap();
        let learning = if grows {
            Learning::growing(&cloud, start, 120, 7).unwrap()
        } else {
            let rule = Rule { weighting, steps: Some(2500), ..Rule::default() };
            Learning::new(&cloud, start, rule).unwrap()
        };
        let (mut one, mut other) = (learning.clone(), learning);
        let mut progress = 0.0;
        for &budget in budgets.iter().cycle().take(40) {
            one.advance(budget);
            prop_assert!(one.progress() >= progress && one.progress() <= 1.0);
            progress = one.progress();
            let influence = one.influence();
            prop_assert!(influence.len() == one.wins().len() && influence.iter().all(|h| (0.0..=0.5).contains(h)));
        }
        other.advance(one.total());
        prop_assert_eq!(one.net(), other.net());
        prop_assert_eq!(one.wins(), other.wins());
        prop_assert_eq!(one.rms(), other.rms());
        prop_assert_eq!(one.last(), other.last());
    }

    #[test]
    fn any_cloud_can_be_learnt(
        (topology, size) in topology().prop_flat_map(|topology| (Just(topology), size(topology))),
        weighting in weighting(),
        points in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0), 1..6),
        flat in proptest::array::uniform3(prop_oneof![Just(0.0), Just(1.0), Just(1e-200), Just(1e150)]),
        grows: bool,
    ) {
        // Few points, points in a plane, on a line or all the same, tiny and huge clouds.
        let points: Vec<Point<3>> = points.iter().map(|p| std::array::from_fn(|d| p[d] * flat[d])).collect();
        let cloud = Cloud::new(points).unwrap();
        let start = Net::random(&cloud, size, topology, 1).unwrap();
        let mut learning = if grows {
            Learning::growing(&cloud, start, 110, 1).unwrap()
        } else {
            Learning::new(&cloud, start, Rule { weighting, steps: Some(1500), ..Rule::default() }).unwrap()
        };
        learning.advance(20_000);
        prop_assert!(finite(learning.net()));
        prop_assert!(learning.rms().is_some_and(f64::is_finite));
    }
}

#[test]
fn poles_stay_one_neuron() {
    let cloud = Cloud::of_shape(CloudShape::Sphere, 1000, 0.02, 1).unwrap();
    for weighting in [Weighting::Gauss, Weighting::Bubble] {
        let start = Net::random(&cloud, [7, 9], Topology::Sphere, 1).unwrap();
        let mut learning = Learning::new(&cloud, start, Rule { weighting, ..Rule::default() }).unwrap();
        learning.advance(u64::MAX);
        let rows = learning.net().rows();
        for row in [&rows[0], &rows[6]] {
            assert!(row.iter().all(|neuron| *neuron == row[0]));
        }
        // And only their first place wins.
        assert!(learning.wins()[0] > 0 && learning.wins()[1..9].iter().all(|wins| *wins == 0));
    }
}

#[test]
fn the_nearest_of_equal_neurons_is_the_first() {
    let rows = vec![vec![[1.0, 0.0, 0.0]; 5]; 3];
    let net = Net::new(Topology::Open, &rows).unwrap();
    assert_eq!(net.nearest([0.0; 3]), ([0, 0], 1.0));
    let mut rows = rows;
    rows[1][3] = [0.5, 0.0, 0.0];
    rows[2][0] = [0.5, 0.0, 0.0];
    assert_eq!(Net::new(Topology::Open, &rows).unwrap().nearest([0.0; 3]), ([1, 3], 0.25));
}

#[test]
fn gain_and_radius_fall_from_end_to_end() {
    let schedule = Schedule::new(Weighting::Gauss, 1000, 10.0).unwrap();
    assert_eq!((schedule.gain(0), schedule.radius(0)), (0.5, 10.0));
    assert!((schedule.gain(1000) - 0.01).abs() < 1e-15 && (schedule.radius(1000) - 0.5).abs() < 1e-15);
    assert!((schedule.gain(500) - 0.005_f64.sqrt()).abs() < 1e-15);
    let bubble = Schedule::new(Weighting::Bubble, 1000, 10.0).unwrap();
    assert_eq!((bubble.radius(0), bubble.radius(500), bubble.radius(1000)), (11.0, 2.0, 0.0));
}

#[test]
fn a_net_that_rests_has_learnt() {
    let cloud = Cloud::new(vec![[1.0, 2.0, 3.0], [1.0, 2.0, 3.0 + 1e-3]]).unwrap();
    let start = Net::random(&cloud, [4, 4], Topology::Open, 1).unwrap();
    let rule = Rule { steps: Some(1_000_000), settle: 1.0, ..Rule::default() };
    let mut learning = Learning::new(&cloud, start.clone(), rule).unwrap();
    assert_eq!((learning.advance(u64::MAX), learning.total()), (Some(End::Settled), 1000));
    // It stays what it is.
    let net = learning.net().clone();
    assert_eq!((learning.advance(10), learning.total(), learning.net()), (Some(End::Settled), 1000, &net));
    let mut learning = Learning::new(&cloud, start, Rule { steps: Some(3000), settle: 0.0, ..rule }).unwrap();
    assert_eq!((learning.advance(u64::MAX), learning.total()), (Some(End::Steps), 3000));
}

#[test]
fn lines_return_where_the_net_is_closed() {
    let rows: Vec<Vec<Point<3>>> =
        (0..3).map(|i| (0..4).map(|j| [f64::from(i), f64::from(j), 0.0]).collect()).collect();
    let count = |topology| {
        let lines = Net::new(topology, &rows).unwrap().lines();
        (lines.len(), lines[0].len(), lines[3].len())
    };
    assert_eq!(count(Topology::Open), (7, 4, 3));
    assert_eq!(count(Topology::Cylinder), (7, 5, 3));
    assert_eq!(count(Topology::Torus), (7, 5, 4));
    let polygon = Net::new(Topology::Open, &rows[..1]).unwrap();
    assert!(polygon.is_polygon() && polygon.lines() == [rows[0].clone()]);
}

#[test]
fn what_cannot_be_is_told() {
    let cloud = Cloud::of_shape(CloudShape::Saddle, 10, 0.0, 1).unwrap();
    let error = Net::random(&cloud, [600, 2], Topology::Open, 1).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a net of 600 x 2 neurons is not possible; 1 x 1 to 512 rows and columns and 16384 neurons are"
    );
    assert!(Net::random(&cloud, [2, 8], Topology::Sphere, 1).is_err());
    assert!(Net::random(&cloud, [0, 8], Topology::Open, 1).is_err());
    assert!(Net::new(Topology::Open, &[vec![[0.0; 3]; 2], vec![[0.0; 3]; 3]]).is_err());
    assert!(Net::new(Topology::Open, &[vec![[f64::NAN; 3]; 2]]).is_err());
    let start = || Net::random(&cloud, [4, 4], Topology::Open, 1).unwrap();
    let refused = |rule| Learning::new(&cloud, start(), rule).unwrap_err();
    assert_eq!(refused(Rule { steps: Some(0), ..Rule::default() }), KohonenError::Steps { given: 0 });
    let error = refused(Rule { radius: Some(f64::NAN), ..Rule::default() });
    assert_eq!(error.to_string(), "radius is NaN, but must be a number of neurons from 0.5 to 10000");
    assert!(refused(Rule { settle: f64::INFINITY, ..Rule::default() }).to_string().contains("settle"));
    assert!(Learning::growing(&cloud, start(), 15, 1).is_err());
}
