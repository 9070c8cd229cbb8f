//! Speed and growth of what is written for other programs: models of a net of 256 x 256 points, tables, hidden lines, pictures with
//! a label at every point, and the curve by all points as a picture. `docs/speed.md` says how these were measured.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use grafika::figure::{
    Axes, Figure, ModelFormat, ModelOptions, Style, TableFormat, surface_step, visible_lines, write_curve,
};
use grafika::geometry::{
    Bezier, Closure, Curve, Grid, Method, ParamCurve, Point, Scheme, Smoothing, Surface, Topology, View,
    samples, smooth,
};
use std::hint::black_box;
use std::io::{BufWriter, sink};
use std::time::Duration;

/// Steps of a cell in a mesh, as `grafika render` takes them.
const STEPS: usize = 10;

fn net(side: usize) -> Surface {
    let point = |k: usize, l: usize| -> Point<3> {
        let (k, l) = (k as f64, l as f64);
        [40.0 * k, 40.0 * l, 60.0 * (1.7 * k).sin() * (0.9 * l).cos()]
    };
    let net: Vec<Vec<Point<3>>> = (0..side).map(|k| (0..side).map(|l| point(k, l)).collect()).collect();
    Surface::new(Scheme::new(Method::BSpline3, Topology::Open), &net).expect("a good net")
}

fn models(c: &mut Criterion) {
    let mut group = c.benchmark_group("model");
    for side in [64, 256] {
        let surface = net(side);
        let options = ModelOptions { steps: STEPS, tolerance: 1e-6, name: "net" };
        group.bench_function(BenchmarkId::new("step", side), |b| {
            b.iter(|| surface_step(black_box(&surface), "net"));
        });
        group.bench_function(BenchmarkId::new("stl", side), |b| {
            b.iter(|| ModelFormat::Stl.encode(&[black_box(&surface)], &options));
        });
        // As the command line writes them, without the file in memory.
        for (name, format) in
            [("stl", ModelFormat::Stl), ("obj", ModelFormat::Obj), ("ply", ModelFormat::Ply)]
        {
            group.bench_function(BenchmarkId::new(format!("{name}, row by row"), side), |b| {
                b.iter(|| {
                    let model = format.model(&[black_box(&surface)], &options).expect("it has an area");
                    model.write(&mut BufWriter::with_capacity(1 << 16, sink()))
                });
            });
        }
    }
    group.finish();
}

/// Rows of a sampled curve, as `grafika sample` writes them.
fn tables(c: &mut Criterion) {
    let mut group = c.benchmark_group("table");
    let points: Vec<Point<2>> = (0..11).map(|i| [50.0 * i as f64, (i * i * 37 % 300) as f64]).collect();
    let curve = Curve::through(Method::Spline, Closure::Open, &points).expect("good points");
    for (name, format) in [("csv", TableFormat::Csv), ("json", TableFormat::Json)] {
        for per_span in [10_000, 100_000] {
            group.bench_function(BenchmarkId::new(name, 10 * per_span), |b| {
                b.iter(|| {
                    let rows = samples(black_box(&curve), per_span).expect("not too many");
                    let rows = rows.map(|sample| (sample.span, sample.u, vec![sample.point]));
                    write_curve(&mut BufWriter::with_capacity(1 << 16, sink()), format, 0, rows)
                });
            });
        }
    }
    group.finish();
}

/// A sheet of waves of a height, in cells along a side.
fn sheet(side: usize, height: f64) -> Grid {
    let step = std::f64::consts::TAU / side as f64;
    Grid::from_fn([side + 1, side + 1], [false; 2], |k, l| {
        let (x, y) = (step * k as f64, step * l as f64);
        [x, y, height * (3.0 * x).sin() * (2.0 * y).cos()]
    })
}

fn hidden(c: &mut Criterion) {
    let mut group = c.benchmark_group("hidden lines");
    let view = View::from_direction([0.3, -0.7, 0.4]);
    for side in [125, 250, 500, 707, 1000] {
        let grid = [sheet(side, 1.0)];
        group.bench_function(BenchmarkId::new("waves", side), |b| {
            b.iter(|| visible_lines(black_box(&grid), &view));
        });
    }
    // Seen along the sheet, and shrunk to a line: all triangles in one row of bins, or in one bin.
    let along = View::from_direction([0.3, -0.7, 0.0]);
    let line = Grid::from_fn([129, 129], [false; 2], |k, l| [k as f64 + l as f64, 1e-13 * l as f64, 0.0]);
    for (name, grid, view) in [("edge-on", sheet(128, 0.0), along), ("line", line, view)] {
        group.bench_function(name, |b| {
            b.iter(|| visible_lines(std::slice::from_ref(black_box(&grid)), &view));
        });
    }
    group.finish();
}

/// Discs on a lattice with a text beside each, all of them written.
fn labelled(count: usize, written: bool) -> Figure {
    let mut figure = Figure::new();
    let style = Style::filled([255; 3], [0; 3]);
    let side = (count as f64).sqrt().ceil() as usize;
    for index in 0..count {
        let at = [(index % side) as f64, (index / side) as f64];
        figure.disc(at, 2.0, style, None);
        if written {
            figure.text(at, (index + 1).to_string());
        }
    }
    figure
}

fn labels(c: &mut Criterion) {
    let mut group = c.benchmark_group("labels");
    for count in [1_000, 10_000, 100_000] {
        for (name, written) in [("", true), (" without labels", false)] {
            let figure = labelled(count, written);
            group.bench_function(BenchmarkId::new(format!("pdf{name}"), count), |b| {
                b.iter(|| black_box(&figure).to_pdf());
            });
            group.bench_function(BenchmarkId::new(format!("png{name}"), count), |b| {
                b.iter(|| black_box(&figure).to_png(800));
            });
        }
    }
    group.finish();
}

/// Measured points with noise.
fn measured(count: usize) -> Vec<Point<2>> {
    let noise = |i: usize| ((i * 7919) % 1000) as f64 * 1e-3 - 0.5;
    (0..count).map(|i| [i as f64, 20.0 * (i as f64 * 0.05).sin() + noise(i)]).collect()
}

fn curves(c: &mut Criterion) {
    let mut group = c.benchmark_group("bezier to svg");
    for count in [1_000, 4_000, 10_000] {
        let curve = Bezier::new(Closure::Open, &measured(count)).expect("good points");
        group.bench_function(BenchmarkId::from_parameter(count), |b| {
            b.iter(|| {
                let tolerance = 1e-4 * count as f64;
                let arcs = black_box(&curve).to_cubics(tolerance).expect("the tolerance is wide");
                let mut figure = Figure::new();
                figure.curve(arcs, Closure::Open, Style::line([0; 3], 1.0));
                figure.set_axes(Axes::Plane);
                figure.to_svg()
            });
        });
    }
    group.finish();
    let mut group = c.benchmark_group("smooth");
    for count in [500, 2_000, 30_000, 1_000_000] {
        let points = measured(count);
        group.bench_function(BenchmarkId::from_parameter(count), |b| {
            b.iter(|| smooth(black_box(&points), Smoothing::of(count)));
        });
    }
    group.finish();
}

fn config() -> Criterion {
    Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_secs(2))
}

criterion_group!(name = benches; config = config(); targets = models, tables, hidden, labels, curves);
criterion_main!(benches);
