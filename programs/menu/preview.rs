//! The small pictures of the programs. Behind each the program itself runs, on a machine of its own without
//! files and without a clock but the menu's.

use crate::file::{Document, Format};
use crate::machine::{Event, Key, Language, Machine, Memory, Script, Session, Settings, Storage, play};
use crate::screen::{Color, HEIGHT, Screen, WIDTH};
use crate::ui::Program;
use std::time::Duration;

/// The reduction: pixels of the screen per pixel of the small picture, along a side.
const SCALE: i32 = 5;
/// Size of a small picture in pixels.
pub(super) const SMALL: (i32, i32) = (WIDTH / SCALE, HEIGHT / SCALE);

/// A program that runs for its small picture.
pub(super) struct Preview {
    session: Session,
    now: Duration,
    /// The key that it gets at every step.
    motion: Option<Key>,
    pixels: Vec<Color>,
    /// Steps since the small picture last changed.
    still: u32,
}

/// After so many steps without a change a small picture stands: what happens in its program is not to be seen.
const STANDS: u32 = 20;

impl Preview {
    /// Starts a program and leads it to its picture. What a script cannot do is left out: there is a
    /// picture in any case.
    pub(super) fn new(program: &Program, language: Language) -> Preview {
        let storage = Memory::default();
        let demo = program.demo;
        let document = Format::from_name(demo.file).and_then(|format| {
            let content = storage.read(demo.file).ok()?;
            Document::read(format, &content).ok()
        });
        let machine = Machine::new(Box::new(storage), Settings { language, ..Settings::default() });
        let start = (program.start)(document);
        let mut session = Session::start(machine, move |mut machine| async move {
            match start {
                Ok(start) => start(&mut machine).await,
                Err(_) => Ok(()),
            }
        });
        let script = Script::parse(demo.script).unwrap_or_default();
        let _ = play(&mut session, &script, &mut ());
        let pixels = small(&session.screen());
        Preview { session, now: Duration::ZERO, motion: demo.motion, pixels, still: 0 }
    }

    /// Whether its picture changes by itself.
    pub(super) fn moves(&self) -> bool {
        let goes_on = self.motion.is_some() || self.session.deadline().is_some();
        self.still < STANDS && goes_on && !self.session.ended()
    }

    /// Lets a picture that stands move again.
    pub(super) fn wake(&mut self) {
        self.still = 0;
    }

    /// Lets the program go on for a while.
    pub(super) fn go_on(&mut self, time: Duration) {
        self.now += time;
        self.session.settle(self.now);
        if let Some(key) = self.motion {
            self.session.send(Event::Key(key), self.now);
        }
        let before = std::mem::replace(&mut self.pixels, small(&self.session.screen()));
        self.still = if before == self.pixels { self.still + 1 } else { 0 };
    }

    /// Draws the small picture.
    pub(super) fn draw(&self, screen: &mut Screen, (x, y): (i32, i32)) {
        let rows = self.pixels.chunks(SMALL.0 as usize);
        for (y, row) in (y..).zip(rows) {
            screen.row(x, y, row.iter().copied().map(Some));
        }
    }
}

/// A screen made smaller: every pixel has the colour that its square of the screen has more of than is to be
/// expected, so that thin lines stay and grids vanish.
fn small(screen: &Screen) -> Vec<Color> {
    let weights = count([screen.pixels()]).map(|count| 1.0 / f64::from(count).sqrt().max(1.0));
    let place = |index: i32| (index % SMALL.0 * SCALE, index / SMALL.0 * SCALE);
    (0..SMALL.0 * SMALL.1).map(|index| shown(screen, place(index), &weights)).collect()
}

/// How often every colour is among rows of pixels.
fn count<'p>(rows: impl IntoIterator<Item = &'p [u8]>) -> [u32; 16] {
    let mut count = [0; 16];
    rows.into_iter().flatten().for_each(|pixel| count[usize::from(pixel & 15)] += 1);
    count
}

/// The colour that a square of the screen shows.
fn shown(screen: &Screen, (x, y): (i32, i32), weights: &[f64; 16]) -> Color {
    let rows = (y..y + SCALE).map(|y| {
        // The square is on the screen.
        let start = (y * WIDTH + x) as usize;
        screen.pixels().get(start..start + SCALE as usize).unwrap_or_default()
    });
    let count = count(rows);
    let weight = |color: u8| f64::from(count[usize::from(color)]) * weights[usize::from(color)];
    let most = (0..16_u8).max_by(|a, b| weight(*a).total_cmp(&weight(*b)));
    Color::from_index(most.unwrap_or(0))
}
