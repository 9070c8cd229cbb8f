//! Speed of reading and writing clouds of a million points.
//!
//! Goals: half a second for a million points in binary PLY; text as fast as its numbers can be read. Pieces of 64 KB, as
//! a program reads them, cost no more than one piece.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grafika::file::{Cloud, CloudFormat, CloudReader, FileError, TableOptions};
use std::hint::black_box;
use std::time::Duration;

const POINTS: usize = 1_000_000;
const PIECE: usize = 1 << 16;

/// Points on a wavy surface, with all their digits.
fn cloud() -> Cloud {
    let place = |k: usize| {
        let (u, v) = ((k % 1000) as f64 / 999.0, (k / 1000) as f64 / 999.0);
        [100.0 * u, 100.0 * v, (7.0 * u).sin() * (5.0 * v).cos()]
    };
    Cloud::new((0..POINTS).map(place).collect())
}

/// Binary STL: two triangles for every point, each beside its neighbours.
fn stl(cloud: &Cloud) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((2 * POINTS as u32).to_le_bytes());
    for k in 0..POINTS {
        for steps in [[0, 1, 1001], [0, 1001, 1000]] {
            bytes.extend([0; 12]);
            for step in steps {
                let point = cloud.points[(k + step) % POINTS];
                bytes.extend(point.into_iter().flat_map(|value| (value as f32).to_le_bytes()));
            }
            bytes.extend([0; 2]);
        }
    }
    bytes
}

fn in_pieces(format: CloudFormat, bytes: &[u8]) -> Result<Cloud, FileError> {
    let mut reader = CloudReader::new(format, &TableOptions::default())?;
    for piece in bytes.chunks(PIECE) {
        reader.feed(piece)?;
    }
    reader.finish()
}

fn clouds(c: &mut Criterion) {
    let cloud = cloud();
    let written = |format: CloudFormat| cloud.write(format).expect("a good cloud");
    let text = written(CloudFormat::Xyz);
    let header = "ply\nformat ascii 1.0\nelement vertex 1000000\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    let comma = written(CloudFormat::Csv).into_iter().map(|byte| match byte {
        b',' => b';',
        b'.' => b',',
        byte => byte,
    });
    let files = [
        ("PLY, binary", CloudFormat::Ply, written(CloudFormat::Ply)),
        ("PLY, text", CloudFormat::Ply, [header.as_bytes(), &text].concat()),
        ("XYZ", CloudFormat::Xyz, text),
        ("CSV", CloudFormat::Csv, written(CloudFormat::Csv)),
        ("CSV, decimal comma", CloudFormat::Csv, comma.collect()),
        ("OBJ", CloudFormat::Obj, written(CloudFormat::Obj)),
        ("STL, binary", CloudFormat::Stl, stl(&cloud)),
    ];
    let mut group = c.benchmark_group("a million points are read");
    for (name, format, bytes) in &files {
        let read = in_pieces(*format, bytes).expect("a good file");
        assert_eq!(read.points.len(), POINTS, "{name}");
        group.throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function(BenchmarkId::new("in pieces", name), |bencher| {
            bencher.iter(|| in_pieces(*format, black_box(bytes)));
        });
        group.bench_function(BenchmarkId::new("in one piece", name), |bencher| {
            bencher.iter(|| Cloud::read(*format, black_box(bytes)));
        });
    }
    group.finish();
    let mut group = c.benchmark_group("a million points are written");
    for (name, format) in [("XYZ", CloudFormat::Xyz), ("PLY", CloudFormat::Ply)] {
        group.bench_function(name, |bencher| bencher.iter(|| black_box(&cloud).write(format)));
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_secs(1));
    targets = clouds
}
criterion_main!(benches);
