//! How quickly the programs answer: from the start to the first picture, and one redraw with 99 points.
//!
//! Goals: start to first picture in a script 30 ms; GB_2D_IP with a closed spline by 99 points 1 ms; the other
//! curve programs at 99 points and 500 samples a span 2 ms; a surface turned by an arrow 2 ms; reading an
//! `.IP2` 20 µs.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::editor::curve::{self, Tools};
use grafika::editor::net;
use grafika::file::{Document, Format, NetKind, PlanePoints, SpacePoints};
use grafika::machine::{Event, Key, Machine, Memory, Script, Session, Settings, Storage, play};
use grafika::ui::{Manual, Phrase, Start, Words};
use std::hint::black_box;
use std::process::Command;
use std::time::Duration;

const MANUAL: Manual =
    Manual { name: "bench", about: Words("", ""), intro: Words("", ""), keys: &[], lesson: &[] };

/// 99 points on a rose of the field.
fn rose() -> Vec<[f64; 2]> {
    (0..99)
        .map(|k| {
            let angle = std::f64::consts::TAU * f64::from(k) / 99.0;
            let radius = 140.0 + 40.0 * (9.0 * angle).cos();
            [(280.0 + 1.4 * radius * angle.cos()).round(), (190.0 + radius * angle.sin()).round()]
        })
        .collect()
}

fn stored() -> Memory {
    let mut memory = Memory::default();
    let plane = Document::PlanePoints(PlanePoints::new(rose()));
    let space =
        rose().iter().zip(0..).map(|(&[x, y], k)| [x - 280.0, y - 190.0, f64::from(k % 40)]).collect();
    let space = Document::SpacePoints(SpacePoints::new(space));
    for (name, document, format) in [
        ("ROSE.IP2", &plane, Format::Ip2),
        ("ROSE.IC2", &plane, Format::Ic2),
        ("ROSE.IP3", &space, Format::Ip3),
    ] {
        memory.write(name, &document.write(format).expect("99 points fit")).expect("memory takes all");
    }
    memory
}

/// A session of a program after a script.
fn session(start: Result<Start, Phrase>, script: &str) -> Session {
    let start = start.unwrap_or_else(|_| panic!("without a document every program starts"));
    let machine = Machine::new(Box::new(stored()), Settings::default());
    let mut session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    play(&mut session, &Script::parse(script).expect("a right script"), &mut ()).expect("nothing is written");
    session
}

fn plane_session(tools: Tools, script: &str) -> Session {
    session(curve::plane(MANUAL, tools, None), script)
}

fn space_session(tools: Tools, script: &str) -> Session {
    session(curve::space(MANUAL, tools, None), script)
}

fn redraws(c: &mut Criterion) {
    let mut group = c.benchmark_group("redraw, 99 points");
    let load = "type trose\nkey Enter\n";
    let mut bench = |name: &str, mut session: Session| {
        let mut x = 0;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                x = (x + 1) % 20;
                session.send(black_box(Event::Move(300 + x, 20)), Duration::ZERO);
            });
        });
    };
    bench("gb_2d_ip, closed spline", plane_session(Tools::Methods, &format!("{load}type gz3")));
    bench("gb_2d_ip, closed Bézier", plane_session(Tools::Methods, &format!("{load}type gz2")));
    bench("gb_2d_ch, closed", plane_session(Tools::Tangents, &format!("{load}key N\ntype gz\nkey N")));
    bench("gb_2d_bt, closed", plane_session(Tools::Beta, &format!("{load}type gz")));
    bench("gb_3d_ip, closed spline", space_session(Tools::Methods, &format!("{load}type gz3")));
    bench("gb_3d_bt, closed", space_session(Tools::Beta, &format!("{load}type gz")));
}

/// The plan of ZM_HSPL, whose default picture is the largest.
static SPHERE: net::Plan = net::Plan {
    manual: MANUAL,
    kind: NetKind::Zms,
    reads: &[],
    family: net::Family::Local,
    start: net::Start::Sphere(160.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// A step of an arrow key with a surface in the picture.
fn turning(c: &mut Criterion) {
    let mut group = c.benchmark_group("turn a surface");
    for (name, script) in [
        ("wires", "key U\nkey F\nkey D"),
        ("filled", "key U\nkey F\nkey T"),
        ("zebra", "key U\nkey F\nkey T\nkey F5"),
        ("curvature", "key U\nkey F\nkey T\nkey F5\nkey F5"),
        ("section", "key U\nkey F\nkey T\nkey F6"),
    ] {
        let mut session = session(net::start(&SPHERE, None), script);
        group.bench_function(name, |bencher| {
            bencher.iter(|| session.send(black_box(Event::Key(Key::Left)), Duration::ZERO));
        });
    }
}

fn start(c: &mut Criterion) {
    let folder = std::env::temp_dir();
    let script = folder.join("grafika-bench-start.script");
    let picture = folder.join("grafika-bench-start.png");
    std::fs::write(&script, format!("shot {}\n", picture.display())).expect("a temporary file");
    c.bench_function("start to first picture in a script", |bencher| {
        bencher.iter(|| {
            let status = Command::new(env!("CARGO_BIN_EXE_gb_2d_ip")).arg("--script").arg(&script).status();
            assert!(status.expect("the program starts").success());
        });
    });
}

fn reading(c: &mut Criterion) {
    let content = stored().read("ROSE.IP2").expect("it was stored");
    c.bench_function("read an .IP2", |bencher| {
        bencher.iter(|| Document::read(Format::Ip2, black_box(&content)));
    });
}

criterion_group!(benches, redraws, turning, start, reading);
criterion_main!(benches);
