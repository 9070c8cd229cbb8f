//! What nets have learnt from clouds of known surfaces, by the quality that a prototype reaches.

use super::super::{Learning, Net, Rule, Topology, Weighting};
use crate::geometry::cloud::{Cloud, CloudShape};
use crate::geometry::norm;

/// The root of the mean squared distance of the neurons from the true surface.
fn off(net: &Net, shape: CloudShape) -> f64 {
    let neurons = net.rows().concat();
    let sum: f64 = neurons.iter().map(|neuron| shape.distance(*neuron).powi(2)).sum();
    (sum / neurons.len() as f64).sqrt()
}

/// The longest edge of a net.
fn longest(net: &Net) -> f64 {
    let lines = net.lines();
    let edges = lines.iter().flat_map(|line| line.windows(2));
    edges.map(|edge| norm::<3>(std::array::from_fn(|d| edge[1][d] - edge[0][d]))).fold(0.0, f64::max)
}

fn learnt(shape: CloudShape, size: [usize; 2], topology: Topology, weighting: Weighting) -> Net {
    let cloud = Cloud::of_shape(shape, 4000, 0.02, 1).unwrap();
    let start = Net::random(&cloud, size, topology, 5).unwrap();
    let rule = Rule { weighting, steps: Some(40_000), ..Rule::default() };
    let mut learning = Learning::new(&cloud, start, rule).unwrap();
    learning.advance(u64::MAX);
    learning.into_net()
}

#[test]
fn nets_of_every_topology_lie_on_the_surface() {
    use CloudShape::{Hemisphere, Ring, Saddle, Sphere};
    for (shape, size, topology, limits) in [
        (Saddle, [10, 10], Topology::Open, [0.004, 0.3]),
        (Hemisphere, [12, 12], Topology::Open, [0.027, 0.4]),
        (CloudShape::Torus, [10, 16], Topology::Torus, [0.09, 0.7]),
        (Ring, [6, 24], Topology::Cylinder, [0.03, 0.5]),
        (Sphere, [12, 20], Topology::Sphere, [0.055, 0.5]),
    ] {
        let net = learnt(shape, size, topology, Weighting::Gauss);
        let (off, longest) = (off(&net, shape), longest(&net));
        assert!(off < limits[0] && longest < limits[1], "{}: {off} {longest}", shape.name());
    }
    let net = learnt(Hemisphere, [12, 12], Topology::Open, Weighting::Bubble);
    assert!(off(&net, Hemisphere) < 0.01);
}

/// No neuron is far off: where a torus is pinched, a ring of neurons crosses the tube.
#[test]
fn shaped_starts_keep_their_shape() {
    for (shape, size, topology) in [
        (CloudShape::Torus, [10, 16], Topology::Torus),
        (CloudShape::Torus, [20, 20], Topology::Torus),
        (CloudShape::Torus, [16, 10], Topology::Torus),
        (CloudShape::Sphere, [12, 20], Topology::Sphere),
        (CloudShape::Ring, [6, 24], Topology::Cylinder),
        (CloudShape::Saddle, [8, 12], Topology::Open),
        (CloudShape::Saddle, [12, 8], Topology::Open),
    ] {
        let cloud = Cloud::of_shape(shape, 4000, 0.02, 1).unwrap();
        let start = Net::shaped(&cloud, size, topology).unwrap();
        let rule = Rule { steps: Some(20_000), radius: Some(1.0), ..Rule::default() };
        let mut learning = Learning::new(&cloud, start, rule).unwrap();
        learning.advance(u64::MAX);
        let neurons = learning.net().rows().concat();
        let furthest = neurons.iter().map(|neuron| shape.distance(*neuron)).fold(0.0, f64::max);
        assert!(furthest < 0.1, "{} {size:?}: {furthest}", shape.name());
    }
}

#[test]
fn a_polygon_puts_the_points_of_a_letter_in_order() {
    let net = learnt(CloudShape::Letter, [30, 1], Topology::Open, Weighting::Gauss);
    assert!(off(&net, CloudShape::Letter) < 0.02 && longest(&net) < 0.25);
    let ends = [net.point([0, 0]), net.point([29, 0])];
    // The ends of the letter, in either order.
    assert!(ends[0][0] * ends[1][0] < -0.1 && ends[0][1] * ends[1][1] < -0.1);
}

fn grown(shape: CloudShape, topology: Topology, limit: usize, seed: u64) -> Learning {
    let cloud = Cloud::of_shape(shape, 4000, 0.02, 1).unwrap();
    let start = Net::seedling(&cloud, topology, seed).unwrap();
    let mut learning = Learning::growing(&cloud, start, limit, seed).unwrap();
    learning.advance(u64::MAX);
    learning
}

#[test]
fn a_growing_net_ends_at_its_limit_on_the_surface() {
    let learning = grown(CloudShape::Saddle, Topology::Open, 100, 2);
    let net = learning.net();
    assert_eq!((net.size(), learning.is_growing(), learning.progress()), ([10, 10], false, 1.0));
    // The reference needed 31 300 steps.
    assert!((31_000..31_600).contains(&learning.total()), "{}", learning.total());
    assert!(off(net, CloudShape::Saddle) < 0.005 && longest(net) < 0.35);
}

#[test]
fn closed_nets_grow_too() {
    for (shape, topology, limits) in [
        (CloudShape::Ring, Topology::Cylinder, [0.02, 0.4]),
        (CloudShape::Torus, Topology::Torus, [0.07, 0.5]),
        (CloudShape::Sphere, Topology::Sphere, [0.07, 0.45]),
    ] {
        for seed in 1..=4 {
            let learning = grown(shape, topology, 200, seed);
            let (net, [m, n]) = (learning.net(), learning.net().size());
            assert!(m * n <= 200 && (m + 1) * (n + 1) > 200);
            let (off, longest) = (off(net, shape), longest(net));
            assert!(off < limits[0] && longest < limits[1], "{} {seed}: {off} {longest}", topology.name());
        }
    }
}
