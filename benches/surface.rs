//! Speed of a surface's filled picture: a torus of 100 000 cells, its points projected and its cells
//! drawn with their outlines by the depth of every pixel, as it is done anew when the view is turned. And a net of 8 x 8
//! points with normals, whose surface and offset are made anew while a point is dragged.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use euc::buffer::Buffer2d;
use euc::rasterizer::{BackfaceCullingDisabled, BackfaceCullingEnabled, Triangles};
use euc::{Pipeline, Target};
use grafika::geometry::{DepthBuffer, Grid, ParamSurface, PnData, PnMethod, PnNet, Point, Vertex, View};
use std::f64::consts::TAU;
use std::hint::black_box;

/// Cells around the torus, and around its tube.
const LONG: usize = 400;
const SHORT: usize = 250;

/// The torus' middle circle and its tube: 400 pixels wide.
const RADII: [f64; 2] = [140.0, 60.0];

fn torus() -> Vec<Point<3>> {
    let place = |j: usize, count: usize| (TAU * j as f64 / count as f64).sin_cos();
    let point = |index: usize| {
        let ((sin, cos), (height, width)) = (place(index / SHORT, LONG), place(index % SHORT, SHORT));
        let radius = RADII[0] + RADII[1] * width;
        [radius * cos, radius * sin, RADII[1] * height]
    };
    (0..LONG * SHORT).map(point).collect()
}

fn project(points: &[Point<3>], view: &View, out: &mut Vec<Vertex>) {
    out.clear();
    out.extend(points.iter().map(|&point| {
        let [x, y] = view.pixel(point, 1.0);
        Vertex { x: x as i32, y: y as i32, depth: view.depth(point) as f32 }
    }));
}

/// The corners of a cell, as indices of points.
fn cell(number: usize) -> [usize; 4] {
    let (k, l) = (number / SHORT, number % SHORT);
    let at = |k: usize, l: usize| k % LONG * SHORT + l % SHORT;
    [at(k + 1, l), at(k + 1, l + 1), at(k, l + 1), at(k, l)]
}

// Cells as small as these are drawn as they come; larger ones by `geometry::near_first`.
fn draw(vertices: &[Vertex], buffer: &mut DepthBuffer) {
    buffer.clear();
    for number in 0..LONG * SHORT {
        buffer.cell(&cell(number).map(|at| vertices[at]), 0, Some(15));
    }
}

/// The same torus for `euc`, which fills it without outlines.
struct Filled<'a> {
    points: &'a [Point<3>],
    view: View,
}

impl Pipeline for Filled<'_> {
    type Vertex = usize;
    type VsOut = f32;
    type Pixel = u32;

    fn vert(&self, index: &usize) -> ([f32; 4], f32) {
        let point = self.points[*index];
        let [x, y] = self.view.pixel(point, 1.0);
        let depth = self.view.depth(point) as f32;
        ([x as f32 / 320.0 - 1.0, 1.0 - y as f32 / 240.0, -depth / 1000.0, 1.0], depth)
    }

    fn frag(&self, depth: &f32) -> u32 {
        *depth as u32
    }
}

/// Pictures by `euc`: with its triangles turned away left out, and with all.
fn peer(group: &mut BenchmarkGroup<'_, WallTime>, points: &[Point<3>], view: View) {
    let triangles: Vec<usize> = (0..LONG * SHORT)
        .flat_map(|number| {
            let [a, b, c, d] = cell(number);
            [a, b, c, a, c, d]
        })
        .collect();
    let (mut color, mut depth) = (Buffer2d::new([640, 480], 0_u32), Buffer2d::new([640, 480], 1.0_f32));
    let filled = Filled { points, view };
    group.bench_function("euc, culled", |b| {
        b.iter(|| {
            color.clear(0);
            depth.clear(1.0);
            let depth = Some(&mut depth);
            filled.draw::<Triangles<_, BackfaceCullingEnabled>, _>(black_box(&triangles), &mut color, depth);
        });
    });
    let drawn = color.as_ref().iter().filter(|&&pixel| pixel != 0).count();
    assert!(drawn > 20_000, "euc drew {drawn} pixels of the side that is seen");
    group.bench_function("euc", |b| {
        b.iter(|| {
            color.clear(0);
            depth.clear(1.0);
            let depth = Some(&mut depth);
            filled.draw::<Triangles<_, BackfaceCullingDisabled>, _>(black_box(&triangles), &mut color, depth);
        });
    });
}

fn surface(c: &mut Criterion) {
    let points = torus();
    let mut vertices = Vec::with_capacity(points.len());
    let mut buffer = DepthBuffer::new(640, 480);
    let mut group = c.benchmark_group("torus of 100 000 cells");
    for (name, elevation) in [("from above", 1.5), ("slanting", 0.7), ("from the side", 0.1)] {
        let view = View::from_angles(0.4, elevation);
        group.bench_function(name, |b| {
            b.iter(|| {
                project(black_box(&points), &view, &mut vertices);
                draw(&vertices, &mut buffer);
                black_box(&mut buffer);
            });
        });
    }
    let view = View::from_angles(0.4, 0.7);
    group.bench_function("projection alone", |b| {
        b.iter(|| project(black_box(&points), &view, black_box(&mut vertices)));
    });
    peer(&mut group, &points, view);
    let mut copy = vec![0; 640 * 480];
    group.bench_function("copy alone", |b| {
        b.iter(|| {
            for (y, row) in black_box(&buffer).rows() {
                for (to, pixel) in copy[640 * y..].iter_mut().zip(row) {
                    *to = pixel.color().unwrap_or(*to);
                }
            }
            black_box(&mut copy);
        });
    });
    group.finish();
}

/// A vault of 8 x 8 points with their normals.
fn vault() -> PnData {
    let at = |k: usize, l: usize| -> Point<3> {
        let [x, y] = [k, l].map(|index| 40.0 * (index as f64 - 3.5));
        [x, y, -0.002 * (x * x + 1.5 * y * y)]
    };
    let points: Vec<Vec<Point<3>>> = (0..8).map(|k| (0..8).map(|l| at(k, l)).collect()).collect();
    PnData::automatic(&points).expect("the points have a spline")
}

/// The grids of all patches and of their offsets.
fn grids(data: &PnData) -> Vec<Grid> {
    let net = PnNet::new(data, PnMethod::Normalised).expect("the vault curves everywhere");
    let patches = (0..49).filter_map(|index| net.patch_surface(index / 7, index % 7)?.ok());
    let both = patches.flat_map(|patch| {
        let offset = patch.offset(20.0).expect("the distance is finite");
        [patch.grid(4), offset.grid(2)]
    });
    both.collect::<Result<_, _>>().expect("there are few steps")
}

fn normals(c: &mut Criterion) {
    let data = vault();
    let mut group = c.benchmark_group("net of 8 x 8 points with normals");
    group.bench_function("surface and offset", |b| b.iter(|| grids(black_box(&data))));
    let (mut buffer, view) = (DepthBuffer::new(640, 480), View::from_angles(0.4, 0.7));
    group.bench_function("surface and offset, drawn", |b| {
        let mut vertices = Vec::new();
        b.iter(|| {
            buffer.clear();
            for grid in grids(black_box(&data)) {
                project(grid.points(), &view, &mut vertices);
                for cell in grid.cells() {
                    buffer.cell(&cell.map(|corner| vertices[corner]), 0, Some(15));
                }
            }
            black_box(&mut buffer);
        });
    });
    let net = PnNet::new(&data, PnMethod::Normalised).expect("the vault curves everywhere");
    for (name, places, refined) in [("facts while dragging", 4, false), ("facts at rest", 9, true)] {
        group.bench_function(name, |b| b.iter(|| black_box(&net).overview(places, refined)));
    }
    group.finish();
}

criterion_group!(benches, surface, normals);
criterion_main!(benches);
