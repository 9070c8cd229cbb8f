//! Speed of what happens at every redraw: sampling arcs, weights times points, and of what
//! happens when the number of points changes: the weights. kurbo's evaluation is the peer.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grafika::geometry::{Bezier, Closure, CubicBezier, Curve, Method, ParamCurve, Point, Weights};
use kurbo::ParamCurve as _;
use std::hint::black_box;

/// Samples per arc in the sampling benches.
const SAMPLES: usize = 1001;

/// Control points of the largest curve of the original programs.
const POINTS: usize = 99;

fn polygon(n: usize) -> Vec<Point<3>> {
    let point = |i| {
        let t = i as f64;
        [280.0 + 200.0 * (1.7 * t).sin(), 190.0 + 150.0 * (2.3 * t).cos(), 100.0 * (0.9 * t).sin()]
    };
    (0..n).map(point).collect()
}

fn sampling(c: &mut Criterion) {
    let mut group = c.benchmark_group("sample");
    group.throughput(Throughput::Elements(SAMPLES as u64));
    let arc3 =
        CubicBezier { p: [[0.0, 1.0, 2.0], [30.0, -10.0, 5.0], [7.0, 60.0, -4.0], [20.0, 21.0, 22.0]] };
    let arc2 = CubicBezier { p: arc3.p.map(|[x, y, _]| [x, y]) };
    let mut out3 = vec![[0.0; 3]; SAMPLES];
    group.bench_function("space", |b| b.iter(|| black_box(&arc3).sample_into(black_box(&mut out3))));
    let curve: Box<dyn ParamCurve<3>> = Box::new(Curve::Piecewise(vec![arc3]));
    group.bench_function("space, behind the trait", |b| {
        b.iter(|| black_box(&curve).sample_span(0, black_box(&mut out3)));
    });
    let mut out2 = vec![[0.0; 2]; SAMPLES];
    group.bench_function("plane", |b| b.iter(|| black_box(&arc2).sample_into(black_box(&mut out2))));
    group.bench_function("plane, one by one", |b| {
        b.iter(|| {
            let arc = black_box(&arc2);
            for (j, point) in out2.iter_mut().enumerate() {
                *point = arc.eval(j as f64 * 1e-3);
            }
            black_box(&mut out2);
        });
    });
    group.bench_function("space, one by one, with derivatives", |b| {
        b.iter(|| {
            let arc = black_box(&arc3);
            let mut sum = [0.0; 3];
            for j in 0..SAMPLES {
                let u = j as f64 * 1e-3;
                let all = [arc.eval(u), arc.derivative(u), arc.second_derivative(u)];
                sum = std::array::from_fn(|d| sum[d] + all[0][d] + all[1][d] + all[2][d]);
            }
            sum
        });
    });
    group.bench_function("plane, one by one, with derivatives", |b| {
        b.iter(|| {
            let arc = black_box(&arc2);
            let mut sum = [0.0; 2];
            for j in 0..SAMPLES {
                let u = j as f64 * 1e-3;
                let all = [arc.eval(u), arc.derivative(u), arc.second_derivative(u)];
                sum = std::array::from_fn(|d| sum[d] + all[0][d] + all[1][d] + all[2][d]);
            }
            sum
        });
    });
    let curve2: Box<dyn ParamCurve<2>> = Box::new(Curve::Piecewise(vec![arc2]));
    group.bench_function("plane, one by one, behind the trait", |b| {
        b.iter(|| {
            let curve = black_box(&curve2);
            for (j, point) in out2.iter_mut().enumerate() {
                *point = curve.eval(0, j as f64 * 1e-3).unwrap_or_default();
            }
            black_box(&mut out2);
        });
    });
    group.bench_function("plane, one by one, with derivatives, behind the trait", |b| {
        b.iter(|| {
            let curve = black_box(&curve2);
            let mut sum = [0.0; 2];
            for j in 0..SAMPLES {
                let all = curve.at(0, j as f64 * 1e-3).unwrap_or_default();
                sum = std::array::from_fn(|d| sum[d] + all[0][d] + all[1][d] + all[2][d]);
            }
            sum
        });
    });
    let peer = kurbo::CubicBez::new((0.0, 1.0), (30.0, -10.0), (7.0, 60.0), (20.0, 21.0));
    let mut out = vec![kurbo::Point::ZERO; SAMPLES];
    group.bench_function("plane, kurbo", |b| {
        b.iter(|| {
            let arc = black_box(&peer);
            for (j, point) in out.iter_mut().enumerate() {
                *point = arc.eval(j as f64 * 1e-3);
            }
            black_box(&mut out);
        });
    });
    group.finish();
}

fn weights(c: &mut Criterion) {
    let points = polygon(POINTS);
    let methods = [
        Method::Coons { k0: 0.5 },
        Method::Spline,
        Method::BSpline3,
        Method::Beta { bias: 1.5, tension: 2.0 },
    ];
    for method in methods {
        let name = method.name();
        let new = || Weights::new(method, Closure::Closed, black_box(POINTS)).expect("good parameters");
        c.bench_function(&format!("weights of 99 points/{name}"), |b| b.iter(new));
        let weights = new();
        c.bench_function(&format!("arcs of 99 points/{name}"), |b| {
            b.iter(|| weights.arcs(black_box(&points)));
        });
    }
}

fn bezier(c: &mut Criterion) {
    let points = polygon(POINTS);
    let bezier = Bezier::new(Closure::Open, &points).expect("good points");
    c.bench_function("bezier of 99 points/point", |b| b.iter(|| bezier.eval(black_box(0.3))));
    let curve = Curve::Bezier(bezier.clone());
    c.bench_function("bezier of 99 points/100 steps", |b| b.iter(|| curve.polyline(black_box(100))));
    c.bench_function("bezier of 99 points/cubics to 1e-3", |b| b.iter(|| bezier.to_cubics(black_box(1e-3))));
    c.bench_function("bezier of 99 points/box", |b| b.iter(|| bezier.bounding_box()));
}

criterion_group!(benches, sampling, weights, bezier);
criterion_main!(benches);
