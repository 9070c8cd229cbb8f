//! Speed of curves by their knots, and of CSOMO while a knot is dragged.
//!
//! Goals: a knot of a curve of 13 points of order 8, with paths, envelope and strip, dragged at 60 pictures a second; the
//! reachable region within 50 ms; a search of all ways through a point within a tenth of a second.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grafika::file::{Document, KnotPoints};
use grafika::geometry::ParamCurve;
use grafika::geometry::knots::{KnotCurve, KnotVector};
use grafika::machine::{Button, Event, Machine, Memory, Script, Session, Settings, play};
use grafika::programs::csomo::PROGRAM;
use std::hint::black_box;
use std::time::Duration;

/// Thirteen points of a wave.
fn wave() -> Vec<[f64; 2]> {
    (0..13).map(|i| [20.0 + 43.0 * f64::from(i), 130.0 + 90.0 * f64::from(i).sin()]).collect()
}

/// Points of curves without and with weights, and their derivatives.
fn points(c: &mut Criterion) {
    let mut group = c.benchmark_group("points of a curve of 13 points");
    group.throughput(Throughput::Elements(1000));
    for order in [3, 4, 8] {
        let vector = KnotVector::uniform(order, 13).expect("knots");
        let plain = KnotCurve::new(vector.clone(), wave()).expect("a curve");
        let weights = (0..13).map(|i| 1.0 + 0.5 * f64::from(i % 3)).collect();
        let rational = KnotCurve::rational(vector, wave(), weights).expect("a curve");
        for (name, curve) in [("plain", &plain), ("rational", &rational)] {
            let [from, to] = curve.vector().domain();
            group.bench_function(format!("{name}, order {order}"), |bencher| {
                bencher.iter(|| {
                    (0..1000)
                        .filter_map(|k| curve.point_at(from + (to - from) * f64::from(k) / 1000.0))
                        .fold(0.0, |sum, [x, y]| sum + x + y)
                });
            });
        }
        group.bench_function(format!("with two derivatives, order {order}"), |bencher| {
            let spans = rational.spans();
            bencher.iter(|| {
                (0..1000_usize)
                    .filter_map(|k| rational.at(k % spans, 0.37))
                    .fold(0.0, |sum, [point, slope, bend]| sum + point[0] + slope[0] + bend[0])
            });
        });
    }
    group.finish();
}

/// A search through a point, all ways.
fn search(c: &mut Criterion) {
    let vector = KnotVector::uniform(4, 13).expect("knots");
    let curve = KnotCurve::new(vector, wave()).expect("a curve");
    let [x, y] = curve.point_at(7.3).expect("in the domain");
    let target = [x, y + 3.0];
    assert!(curve.through_every(target).is_ok());
    c.bench_function("all ways through a point, 13 points", |bencher| {
        bencher.iter(|| curve.through_every(black_box(target)));
    });
}

/// CSOMO on a document, after a script.
fn session(document: KnotPoints, script: &str) -> Session {
    let document = Some(Document::Knots(Box::new(document)));
    let start = (PROGRAM.start)(document).unwrap_or_else(|_| panic!("it starts"));
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let mut session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    play(&mut session, &Script::parse(script).expect("a right script"), &mut ()).expect("nothing is written");
    session
}

/// A knot of order 8 is dragged, with all that follows it.
fn drag(c: &mut Criterion) {
    let knots: Vec<f64> = (0..21).map(f64::from).collect();
    let document = KnotPoints { order: 8, knots, ..KnotPoints::of_points(wave()) };
    // Knot 10 of 0 to 20 is in the middle of the line.
    let mut session = session(document, "key P\nkey U\nmove 321 452\npress left\n");
    let model = |session: &Session| session.model().expect("a model").expect("it is JSON");
    let before = model(&session);
    let (mut x, mut now) = (0, Duration::from_secs(1));
    c.bench_function("a knot of a curve of order 8 is dragged", |bencher| {
        bencher.iter(|| {
            x = (x + 7) % 40;
            now += Duration::from_millis(16);
            session.send(black_box(Event::Move(303 + x, 452)), now);
        });
    });
    session.send(Event::Release(Button::Left), now);
    assert_ne!(before, model(&session), "no knot was dragged");
}

/// The reachable region is worked out anew for every place of the knot.
fn region(c: &mut Criterion) {
    let mut session = session(KnotPoints::of_points(wave()), "key F8\nmove 321 452\npress left\n");
    let (mut x, mut now) = (0, Duration::from_secs(1));
    c.bench_function("the reachable region while a knot is dragged", |bencher| {
        bencher.iter(|| {
            x = (x + 7) % 20;
            now += Duration::from_millis(16);
            session.send(black_box(Event::Move(325 + x, 452)), now);
        });
    });
}

criterion_group!(benches, points, search, drag, region);
criterion_main!(benches);
