//! Speed of Kohonen nets and of fits.
//!
//! Goals: a step of a net of 20 x 20 neurons 1 us, a fit of 20 x 20 control points to 100 000 points with five
//! corrections 2 s. Of a million points: parameters 1 s, a solution 0.5 s, a correction 1.5 s.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grafika::geometry::cloud::{Cloud, CloudShape};
use grafika::geometry::fit::{Fit, Stage};
use grafika::geometry::kohonen::{Learning, Net, Rule, Topology, Weighting};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Steps of a whole course of learning.
const STEPS: u64 = 40_000;
/// The passes that are measured one by one.
const STAGES: [(&str, &[Stage]); 3] = [
    ("parameters", &[Stage::Parameters]),
    ("solution", &[Stage::Equations, Stage::Solution]),
    ("correction", &[Stage::Correction]),
];

fn cloud(shape: CloudShape, points: usize) -> Cloud {
    Cloud::of_shape(shape, points, 0.02, 1).expect("a shape has points")
}

fn learning(cloud: &Cloud, size: [usize; 2], topology: Topology, weighting: Weighting) -> Learning {
    let start = Net::random(cloud, size, topology, 1).expect("a size that can be");
    let rule = Rule { weighting, steps: Some(STEPS), settle: 0.0, ..Rule::default() };
    Learning::new(cloud, start, rule).expect("a rule that can be")
}

/// Whole courses, so that all radii count.
fn steps(c: &mut Criterion) {
    let mut group = c.benchmark_group("40 000 steps");
    group.throughput(Throughput::Elements(STEPS));
    for (shape, size, topology, weighting) in [
        (CloudShape::Saddle, [20, 20], Topology::Open, Weighting::Gauss),
        (CloudShape::Saddle, [20, 20], Topology::Open, Weighting::Bubble),
        (CloudShape::Torus, [20, 20], Topology::Torus, Weighting::Gauss),
        (CloudShape::Sphere, [20, 20], Topology::Sphere, Weighting::Gauss),
        (CloudShape::Saddle, [50, 50], Topology::Open, Weighting::Gauss),
    ] {
        let start = learning(&cloud(shape, 10_000), size, topology, weighting);
        let name = format!("{} {}", topology.name(), weighting.name());
        group.bench_function(BenchmarkId::new(name, format!("{} x {}", size[0], size[1])), |bencher| {
            bencher.iter(|| {
                let mut learning = black_box(&start).clone();
                learning.advance(STEPS);
                learning
            });
        });
    }
    // Every point is somewhere else in memory.
    let start = learning(&cloud(CloudShape::Saddle, 1_000_000), [20, 20], Topology::Open, Weighting::Gauss);
    group.bench_function("a million points", |bencher| {
        bencher.iter(|| {
            let mut learning = black_box(&start).clone();
            learning.advance(STEPS);
            learning
        });
    });
    group.finish();
}

fn net(cloud: &Cloud) -> Net {
    let mut learning = learning(cloud, [20, 20], Topology::Open, Weighting::Gauss);
    learning.advance(STEPS);
    learning.into_net()
}

fn fits(c: &mut Criterion) {
    let few = cloud(CloudShape::Saddle, 100_000);
    let start = Fit::new(&few, &net(&few), Fit::CORRECTIONS).expect("enough points");
    c.bench_function("fit of 20 x 20 to 100 000 points", |bencher| {
        bencher.iter(|| {
            let mut fit = black_box(&start).clone();
            while fit.advance(10_000).is_none() {}
            fit
        });
    });
    let many = cloud(CloudShape::Saddle, 1_000_000);
    let start = Fit::new(&many, &net(&many), 0).expect("enough points");
    let mut group = c.benchmark_group("a million points");
    for (name, stages) in STAGES {
        group.bench_function(name, |bencher| {
            bencher.iter_custom(|times| {
                let mut sum = Duration::ZERO;
                for _ in 0..times {
                    let mut fit = start.clone();
                    while fit.stage() != Stage::Done {
                        let (stage, begun) = (fit.stage(), Instant::now());
                        fit.advance(10_000);
                        if stages.contains(&stage) {
                            sum += begun.elapsed();
                        }
                    }
                }
                sum
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800));
    targets = steps, fits
}
criterion_main!(benches);
