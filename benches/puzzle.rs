//! Speed of the bead wheel's solver: its tables, proofs from a cold start, and good solutions of any position.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::puzzle::wheel::{Difficulty, Scramble, Search, Solver, Tables, Wheel, moves_from_text};
use std::hint::black_box;

fn wheel(text: &str) -> Wheel {
    Wheel::solved().after_all(&moves_from_text(text).expect("these are moves"))
}

/// Works until the shortest solution is proven.
fn prove(wheel: Wheel, tables: Tables) -> Solver {
    let mut solver = Solver::with_tables(wheel, tables);
    while solver.step(100_000).search == Search::Working {}
    solver
}

fn proofs(c: &mut Criterion) {
    let mut group = c.benchmark_group("wheel");
    group.sample_size(10);
    for (name, letters) in
        [("8 moves", "IDFBAEKN"), ("10 moves", "ECMJAMFNNC"), ("11 moves", "KKKKNDMEMFJJC")]
    {
        group.bench_function(format!("{name}, proven from a cold start"), |b| {
            b.iter(|| prove(black_box(wheel(letters)), Tables::default()).solution());
        });
    }
    // These numbers have shortest solutions of 16 and 15 moves.
    for number in [0, 1] {
        let problem = Scramble::new(Difficulty::Sixteen, number).wheel;
        group.bench_function(format!("problem {number} of 16 moves, proven from a cold start"), |b| {
            b.iter(|| prove(black_box(problem), Tables::default()).solution());
        });
    }
    group.finish();
}

fn any(c: &mut Criterion) {
    let mut group = c.benchmark_group("wheel");
    group.sample_size(10);
    let problem = Scramble::new(Difficulty::Any, 0).wheel;
    group.bench_function("any position, first solution from a cold start", |b| {
        b.iter(|| {
            let mut solver = Solver::new(black_box(problem));
            while solver.step(20_000).best.is_none() {}
            solver.solution()
        });
    });
    group.finish();
}

criterion_group!(benches, proofs, any);
criterion_main!(benches);
