//! Speed of PH curves where a program needs them at every move of the mouse: the spline of as many points as a DOS file
//! holds is solved, offset and trimmed. The goal is 2 ms each.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::geometry::Point;
use grafika::geometry::ph::{Knots, PhCurve, SplineEnds};
use std::f64::consts::TAU;
use std::hint::black_box;

/// Control points of the largest curve of the original programs.
const POINTS: usize = 99;

/// A wavy ring in the field.
fn ring() -> Vec<Point<2>> {
    let point = |k: usize| {
        let angle = TAU * k as f64 / POINTS as f64;
        let radius = 140.0 + 25.0 * (7.0 * angle).sin() + 6.0 * (31.0 * angle).cos();
        [280.0 + 1.4 * radius * angle.cos(), 190.0 + radius * angle.sin()]
    };
    (0..POINTS).map(point).collect()
}

fn spline(points: &[Point<2>]) -> PhCurve {
    PhCurve::spline(Knots::Chord, SplineEnds::Closed, points).expect("the ring has a spline")
}

fn ph(c: &mut Criterion) {
    let points = ring();
    let curve = spline(&points);
    c.bench_function("ph, closed C2 spline of 99 points", |b| b.iter(|| spline(black_box(&points))));
    c.bench_function("ph, limits and extreme curvatures", |b| {
        b.iter(|| (black_box(&curve).offset_limits(), curve.curvature_extrema()));
    });
    // Clean, with some cusps, and with a fold at every wave.
    for distance in [-3.0, 12.0, 25.0] {
        let offset = || black_box(&curve).offset(black_box(distance)).expect("the distance is small");
        let cusps = offset().cusps().len();
        c.bench_function(&format!("ph, offset by {distance}: {cusps} cusps"), |b| b.iter(offset));
        let crossings = offset().trimmed().crossings.len();
        c.bench_function(&format!("ph, offset by {distance} trimmed: {crossings} crossings"), |b| {
            b.iter(|| offset().trimmed());
        });
    }
    c.bench_function("ph, 1000 places at equal lengths", |b| {
        b.iter(|| black_box(&curve).equal_lengths(1000));
    });
}

criterion_group!(benches, ph);
criterion_main!(benches);
