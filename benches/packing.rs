//! Speed of the searches for the Csángó cube: the first filling, a part of a count, the moves that build it.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grafika::puzzle::cube::{Count, CsangoCube, Placed, Progress, Rules, Search, Way};
use std::hint::black_box;

fn first_filling(seed: u64) -> grafika::puzzle::cube::Filling {
    match Search::new(&[], seed).advance(u64::MAX) {
        Progress::Found(filling) => filling,
        Progress::Working | Progress::Exhausted => panic!("there are fillings"),
    }
}

fn packing(c: &mut Criterion) {
    c.bench_function("first filling", |b| b.iter(|| first_filling(black_box(0))));
    c.bench_function("first filling, 20 orders", |b| {
        b.iter(|| (1..=20).map(|seed| first_filling(seed).placed.len()).sum::<usize>());
    });
    // One part of the count of 151 296 fillings.
    let count = Count::with_fixed(&[Placed { kind: 0, mask: 0x60_0222 }]);
    let part = count.parts() / 2;
    let mut item = count.part(part);
    while item.advance(u64::MAX).is_none() {}
    let mut group = c.benchmark_group("count");
    group.sample_size(10);
    group.throughput(Throughput::Elements(item.nodes()));
    group.bench_function("a part, nodes", |b| b.iter(|| count.part(part).finish()));
    group.finish();
    let filling = first_filling(0);
    let start = CsangoCube::start();
    c.bench_function("way from the start", |b| {
        b.iter(|| Way::new(black_box(&start), &filling, Rules::Book).and_then(Way::finish));
    });
}

criterion_group!(benches, packing);
criterion_main!(benches);
