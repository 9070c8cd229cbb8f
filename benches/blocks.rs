//! How long a picture in characters takes: the goal is 4 ms.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::display::terminal::blocks::Blocks;
use grafika::file::{Document, Format};
use grafika::machine::{Glyphs, Machine, Memory, Session, Settings, sample};
use grafika::programs;
use grafika::screen::Screen;
use std::hint::black_box;

/// The first picture of a program with a sample.
fn screen(program: &str, name: &str) -> Option<Screen> {
    let program = *programs::by_name(program)?;
    let document = Document::read(Format::from_name(name)?, sample(name)?).ok()?;
    let start = (program.start)(Some(document)).ok()?;
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    Some(session.marked_screen())
}

fn pictures(criterion: &mut Criterion) {
    for (program, file) in [("gb_2d_ip", "A.IP2"), ("zm_hspl", "A.ZMS"), ("gb_p_2d", "A.GBP")] {
        let Some(screen) = screen(program, file) else { continue };
        for (columns, rows) in [(80, 24), (120, 50), (200, 60)] {
            for glyphs in [Glyphs::Blocks, Glyphs::Unicode16] {
                let Some(blocks) = Blocks::new(columns, rows, glyphs) else { continue };
                criterion.bench_function(
                    &format!("{program} {columns}x{rows} {}", glyphs.name()),
                    |bencher| {
                        bencher.iter(|| blocks.picture(black_box(&screen), None));
                    },
                );
            }
        }
    }
}

criterion_group!(benches, pictures);
criterion_main!(benches);
