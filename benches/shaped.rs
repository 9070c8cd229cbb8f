//! Speed of curves with shape parameters: points a second of each family, and a picture of ALAKPAR while a parameter is
//! dragged, with paths and series.
//!
//! Goals: 10 million points a second of the families by polynomials, 2 million of those by sines; a dragged parameter
//! at 60 pictures a second.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grafika::file::{Document, FileKind};
use grafika::geometry::shaped::{Family, LambdaKind, Lambdas, Parameter, Phi, ShapedCurve, Trig};
use grafika::geometry::{ParamCurve, Point};
use grafika::machine::{Button, Event, Machine, Memory, SAMPLES, Session, Settings};
use grafika::programs::alakpar::PROGRAM;
use std::hint::black_box;
use std::time::Duration;

/// Steps of every span.
const STEPS: usize = 1000;

fn points(count: usize) -> Vec<Point<2>> {
    (0..count).map(|k| [60.0 * k as f64, if k % 2 == 0 { 100.0 } else { 300.0 }]).collect()
}

/// Every family with points of its own.
fn curves() -> Vec<(&'static str, ShapedCurve<2>)> {
    let lambda = |kind| Family::Lambda { kind, lambda: Lambdas::One(0.5) };
    let trig = Trig::new(2, 2, 3.0, 2.5, Phi::Trig).expect("it is in range");
    let families = [
        ("c-bezier", Family::c_bezier(2.0).expect("it is in range"), 4),
        ("c-bspline", Family::c_b_spline(2.0).expect("it is in range"), 9),
        ("f-bezier", Family::FBezier { omega: -4.0 }, 4),
        ("f-bezier -100", Family::FBezier { omega: -100.0 }, 4),
        ("f-bspline", Family::FBSpline { omega: 0.0 }, 9),
        ("trig-bezier", Family::Trig(trig), 5),
        ("han", lambda(LambdaKind::Han), 9),
        ("alpha", lambda(LambdaKind::Alpha), 9),
        ("gb", lambda(LambdaKind::Gb), 9),
        ("spb", lambda(LambdaKind::Spb), 9),
        ("han-quadratic", Family::HanQuadratic { lambda: 0.5 }, 9),
        ("cyclic", Family::Cyclic, 9),
    ];
    let curve = |(name, family, count)| {
        (name, ShapedCurve::new(family, points(count), false).expect("it has as many points as it needs"))
    };
    families.into_iter().map(curve).collect()
}

fn sampling(c: &mut Criterion) {
    let mut group = c.benchmark_group("shaped/points");
    for (name, curve) in curves() {
        group.throughput(Throughput::Elements((curve.spans() * STEPS) as u64));
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter(|| black_box(&curve).polyline(STEPS).expect("they are not too many"));
        });
    }
    group.finish();
}

fn searching(c: &mut Criterion) {
    let mut group = c.benchmark_group("shaped/through");
    for (name, curve) in curves() {
        let parameter = match curve.basis().family() {
            Family::FBezier { .. } | Family::FBSpline { .. } => Parameter::Omega,
            Family::Trig(_) => Parameter::Alpha,
            Family::Cyclic => continue,
            _ => Parameter::Lambda,
        };
        let [x, y] = curve.eval(0, 0.5).expect("it is on the curve");
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter(|| curve.through(parameter, black_box([x, y + 2.0])).expect("the family has it"));
        });
    }
    group.finish();
}

/// A picture of the program while the slider is dragged.
fn dragging(c: &mut Criterion) {
    let mut group = c.benchmark_group("shaped/drag");
    for name in ["LANC.ALP", "HAN.ALP"] {
        let (_, bytes) = SAMPLES.iter().find(|(sample, _)| *sample == name).expect("it is a sample");
        let kind = FileKind::from_name(name).expect("samples have a kind");
        let document = Document::decode(kind, bytes).expect("samples are right");
        let start = (PROGRAM.start)(Some(document)).unwrap_or_else(|_| panic!("it is opened"));
        let machine = Machine::new(Box::new(Memory::default()), Settings::default());
        let mut session =
            Session::start(machine, move |mut machine| async move { start(&mut machine).await });
        let mut now = Duration::ZERO;
        let mut send = |event: Event| {
            now += Duration::from_millis(1);
            session.send(event, now);
        };
        for key in ['p', 's'] {
            send(Event::Key(grafika::machine::Key::Char(key)));
        }
        send(Event::Move(113, 34));
        send(Event::Press(Button::Left));
        let mut x = 60;
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter(|| {
                x = if x < 150 { x + 1 } else { 60 };
                send(Event::Move(x, 34));
            });
        });
    }
    group.finish();
}

criterion_group!(benches, sampling, searching, dragging);
criterion_main!(benches);
