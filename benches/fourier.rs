//! Speed of a Fourier curve of 20 harmonics: 1000 samples as at every redraw, against the sines
//! themselves; the fit to a polygon, the box and the cubic arcs.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grafika::geometry::{ClosedPath, Fourier, ParamCurve, Point, Wave};
use std::f64::consts::{PI, TAU};
use std::hint::black_box;

/// Steps of the editor's picture.
const STEPS: usize = 1000;
/// Harmonics of the original.
const HARMONICS: usize = 20;

fn waves() -> Vec<[Wave; 2]> {
    let wave = |k: f64, phase| Wave { amplitude: 100.0 / k, phase };
    (1..=HARMONICS).map(|k| k as f64).map(|k| [wave(k, 0.1 * k), wave(k, 0.5 - 0.03 * k)]).collect()
}

fn evaluation(c: &mut Criterion) {
    let waves = waves();
    let curve = Fourier::new([3.0, -2.0], &waves).expect("good coefficients");
    let mut group = c.benchmark_group("fourier");
    // A term is one harmonic of one coordinate at one sample.
    group.throughput(Throughput::Elements((STEPS * HARMONICS * 2) as u64));
    group.bench_function("1000 steps", |b| b.iter(|| black_box(&curve).polyline(black_box(STEPS))));
    group.bench_function("1000 steps one by one", |b| {
        b.iter(|| (0..=STEPS).map(|j| curve.eval(j as f64 / STEPS as f64)).collect::<Vec<_>>());
    });
    let sines = |t: f64, d: usize| -> f64 {
        let terms = waves.iter().zip(1u32..);
        terms.map(|(row, k)| row[d].amplitude * (f64::from(k) * t + PI * row[d].phase).sin()).sum()
    };
    group.bench_function("1000 steps by sines", |b| {
        b.iter(|| {
            let times = (0..=STEPS).map(|j| TAU * j as f64 / STEPS as f64);
            times.map(|t| [sines(t, 0), sines(t, 1)]).collect::<Vec<_>>()
        });
    });
    group.finish();
    c.bench_function("fourier box", |b| b.iter(|| black_box(&curve).bounding_box()));
    c.bench_function("fourier cubics to 1e-3", |b| b.iter(|| curve.to_cubics(black_box(1e-3))));
}

fn fit(c: &mut Criterion) {
    let points: Vec<Point<2>> = (0..99).map(f64::from).map(|t| [(1.7 * t).sin(), (2.3 * t).cos()]).collect();
    let polygon = ClosedPath::polygon(&points).expect("good points");
    c.bench_function("fit to 99 points", |b| b.iter(|| Fourier::fit(black_box(&polygon), HARMONICS)));
    let curve = Fourier::fit(&polygon, HARMONICS).expect("few harmonics");
    c.bench_function("error in 1000 places", |b| b.iter(|| curve.deviation(black_box(&polygon), STEPS)));
}

criterion_group!(benches, evaluation, fit);
criterion_main!(benches);
