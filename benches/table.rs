//! Speed of the billiard table: steps of the book's eleven balls during a break, and crowds of 1000 and
//! 10 000 moving balls, whose time must grow with their number and not with its square. A step is 31 ms of
//! table time: a crowd runs in real time if its step takes less.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grafika::table::{Ball, Cloth, Field, Table};

/// Steps of one round of the break; the balls come to rest after some 3400.
const STEPS: u64 = 1000;

fn breaks(c: &mut Criterion) {
    let mut group = c.benchmark_group("table");
    group.throughput(Throughput::Elements(STEPS));
    let mut table = Table::rack();
    table.shoot(0, [500.0, 6.0], 0.0).expect("a good shot");
    group.bench_function("break of 11 balls, 1000 steps", |b| {
        b.iter(|| {
            let mut table = table.clone();
            assert_eq!(table.advance(STEPS), STEPS);
            table
        });
    });
    group.finish();
}

/// Balls with speeds up to 300 pixels a second each way, as dense as on the book's table.
fn crowd(count: u32) -> Table {
    let columns = f64::from(count).sqrt().ceil() as u32;
    let mut state = 1997u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        600.0 * ((state >> 11) as f64 / (1u64 << 53) as f64 - 0.5)
    };
    let (wide, high) = (168.0, 120.0);
    let balls = (0..count).map(|i| {
        let [column, row] = [i % columns, i / columns].map(f64::from);
        let at = [wide * (column + 0.5) + 0.05 * random(), high * (row + 0.5) + 0.05 * random()];
        Ball { at, velocity: [random(), random()], spin: 0.0 }
    });
    let field = Field { min: [0.0; 2], max: [wide * f64::from(columns), high * f64::from(columns)] };
    Table::new(field, Cloth { damping: 1.0, ..Cloth::default() }, balls.collect()).expect("a good table")
}

fn crowds(c: &mut Criterion) {
    let mut group = c.benchmark_group("table");
    for count in [1000, 10_000] {
        group.throughput(Throughput::Elements(u64::from(count)));
        let mut table = crowd(count);
        group.bench_function(format!("step of {count} balls"), |b| b.iter(|| table.step()));
    }
    group.finish();
}

criterion_group!(benches, breaks, crowds);
criterion_main!(benches);
