//! Speed of what happens when a surface is shown: a net becomes patches, patches become a grid.
//! The goal is 5 ns for a point of the grid on one core.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grafika::geometry::{Method, ParamSurface, Point, Scheme, Surface, Topology};
use std::hint::black_box;

fn net(rows: usize, columns: usize) -> Vec<Vec<Point<3>>> {
    let height = |k: f64, l: f64| 60.0 * (1.7 * k).sin() * (0.9 * l).cos();
    let point = |k: usize, l: usize| {
        let (k, l) = (k as f64, l as f64);
        [40.0 * k, 40.0 * l, height(k, l)]
    };
    (0..rows).map(|k| (0..columns).map(|l| point(k, l)).collect()).collect()
}

/// The surface methods with typical parameters.
const METHODS: [Method; 5] = [
    Method::Spline,
    Method::Local { k0: 0.5 },
    Method::BSpline2,
    Method::BSpline3,
    Method::Beta { bias: 1.5, tension: 2.0 },
];

/// 20 x 20 spans in 50 steps each: a million points; 8 x 4 spans in 10: the grid of the original programs.
fn grids(c: &mut Criterion) {
    let mut group = c.benchmark_group("grid");
    for (spans, steps) in [([20, 20], 50), ([8, 4], 10)] {
        let [rows, columns] = spans;
        let scheme = Scheme::new(Method::BSpline3, Topology::Open);
        let surface = Surface::new(scheme, &net(rows + 1, columns + 1)).expect("a good net");
        group.throughput(Throughput::Elements(((rows * steps + 1) * (columns * steps + 1)) as u64));
        group.bench_function(format!("{rows}x{columns} spans, {steps} steps"), |b| {
            b.iter(|| black_box(&surface).grid(black_box(steps)));
        });
    }
    group.finish();
}

/// What moving a control point costs.
fn weaving(c: &mut Criterion) {
    let mut group = c.benchmark_group("surface of 8x5 points");
    let net = net(8, 5);
    for method in METHODS {
        let scheme = Scheme::new(method, Topology::Torus);
        group.bench_function(method.name(), |b| b.iter(|| Surface::new(scheme, black_box(&net))));
    }
    group.finish();
}

criterion_group!(benches, grids, weaving);
criterion_main!(benches);
