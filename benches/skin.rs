//! Speed of skins: what an editor does for every picture while a disc or a sphere is dragged.
//!
//! Goal: 100 circles skinned and checked in 1 ms, as the program has 4 ms for a picture.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::geometry::ParamSurface;
use grafika::geometry::skin::{Circle, Circles, Clearing, Links, MESH_STEPS, Sphere, Spheres};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Duration;

const COUNT: u32 = 100;

/// A chain along a wave.
fn chain() -> Circles {
    let disc = |k: u32| {
        let x = f64::from(k);
        Circle::new([2.4 * x, 3.0 * (0.4 * x).sin()], 0.7 + 0.25 * f64::from(k % 3))
    };
    Circles::chain((0..COUNT).map(disc).collect()).expect("good circles")
}

fn ring() -> Circles {
    let disc = |k: u32| {
        let (sine, cosine) = (TAU * f64::from(k) / f64::from(COUNT)).sin_cos();
        Circle::new([40.0 * cosine, 40.0 * sine], 0.9 + 0.2 * f64::from(k % 3))
    };
    Circles::new((0..COUNT).map(disc).collect(), Links::Ring).expect("good circles")
}

/// A star with arms of eleven circles.
fn tree() -> Circles {
    let mut circles = vec![Circle::new([0.0; 2], 4.0)];
    let mut edges = Vec::new();
    for arm in 0..9 {
        let (sine, cosine) = (TAU * f64::from(arm) / 9.0).sin_cos();
        for k in 0..11 {
            let away = 5.5 + 2.5 * f64::from(k);
            let here = circles.len();
            edges.push([if k == 0 { 0 } else { here - 1 }, here]);
            circles.push(Circle::new([away * cosine, away * sine], 0.7 + 0.25 * f64::from(k % 3)));
        }
    }
    Circles::new(circles, Links::Edges(edges)).expect("good circles")
}

/// Circles that overlap far too much: all rules are broken, and hardly an arc is clear.
fn crowd() -> Circles {
    let disc = |k: u32| Circle::new([f64::from(k * 37 % 100), f64::from(k * 61 % 100)], 12.0);
    Circles::chain((0..COUNT).map(disc).collect()).expect("good circles")
}

fn circles(c: &mut Criterion) {
    let shapes = [("chain", chain()), ("ring", ring()), ("tree", tree()), ("crowd", crowd())];
    for (name, circles) in &shapes {
        assert_eq!(circles.is_admissible(), *name != "crowd", "{name}");
        let mut group = c.benchmark_group(format!("{name} of {COUNT} circles"));
        group.bench_function("skin", |bencher| bencher.iter(|| black_box(circles).skin(Clearing::Scaled)));
        group.bench_function("plain skin", |bencher| {
            bencher.iter(|| black_box(circles).skin(Clearing::Plain));
        });
        group.bench_function("check", |bencher| bencher.iter(|| black_box(circles).violations()));
        group.bench_function("nearest admissible", |bencher| {
            bencher.iter(|| black_box(circles).nearest_admissible());
        });
        group.finish();
    }
}

fn spheres(c: &mut Criterion) {
    let ball = |k: u32| {
        let x = f64::from(k);
        Sphere::new([2.4 * x, 3.0 * (0.4 * x).sin(), 3.0 * (0.4 * x).cos()], 0.7 + 0.25 * f64::from(k % 3))
    };
    let spheres = Spheres::chain((0..COUNT).map(ball).collect()).expect("good spheres");
    assert!(spheres.is_admissible());
    let skin = spheres.skin(Clearing::Scaled);
    let mut group = c.benchmark_group(format!("chain of {COUNT} spheres"));
    group.bench_function("skin", |bencher| bencher.iter(|| black_box(&spheres).skin(Clearing::Scaled)));
    group.bench_function("check", |bencher| bencher.iter(|| black_box(&spheres).violations()));
    group.bench_function("mesh of 48 x 12 a span", |bencher| {
        bencher.iter(|| black_box(&skin).mesh(MESH_STEPS));
    });
    let tube = &skin.arms[0].tubes[0];
    group.bench_function("exact form", |bencher| bencher.iter(|| black_box(tube).to_bspline()));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800));
    targets = circles, spheres
}
criterion_main!(benches);
