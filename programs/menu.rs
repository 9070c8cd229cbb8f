//! The menu: the programs by groups, each with a line about it and a small picture in which it runs; started
//! with Enter or a click, found by typing.

mod layout;
mod preview;
#[cfg(feature = "native")]
pub mod text;

use super::ALL;
use crate::machine::{Asked, Asking, Key, Language, Machine, Stop, Tick};
use crate::screen::{Color, Direction, Screen};
use crate::ui::{Area, CommandLine, Demo, Desk, Manual, Picture, Program, Words, sunken, without_document};
use layout::{Line, lines, picture_area};
use preview::Preview;
use std::collections::BTreeMap;
use std::time::Duration;

const MANUAL: Manual = Manual {
    name: "grafika",
    about: Words("A könyv programjai", "The programs of the book"),
    intro: Words("", ""),
    keys: &[
        (Words("Fel Le", "Up Down"), Words("választás", "choose")),
        (Words("Bal Jobb", "Left Right"), Words("előző, következő csoport", "previous, next group")),
        (Words("Home End", "Home End"), Words("első, utolsó program", "first, last program")),
        (Words("betűk", "letters"), Words("keresés névben és leírásban", "search in names and descriptions")),
        (Words("Backspace", "Backspace"), Words("a keresett szó utolsó betűje el", "take back a letter")),
        (Words("Enter egér", "Enter mouse"), Words("indítás", "start")),
        (Words("Esc", "Esc"), Words("keresés vége, kilépés", "end the search, quit")),
        (Words("Q", "Q"), Words("kilépés", "quit")),
    ],
    lesson: &[],
};

/// The menu as a program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "5",
    group: &super::groups::INSTALLER,
    opens: &[],
    demo: Demo { file: "", script: "", motion: None },
    start: |document| without_document(document, |machine| Box::pin(run(machine))),
    command_line: CommandLine::Usual,
};

/// The time between two pictures of the chosen program.
const STEP: Duration = Duration::from_millis(50);
/// After this time without a key the pictures stop, so that a forgotten menu uses no power.
const REST: Duration = Duration::from_secs(30);

/// What the menu shows.
struct Menu {
    /// Index of the chosen program.
    chosen: usize,
    /// The search text, in lower case.
    search: String,
    /// The small pictures made so far, by the index of the program.
    previews: BTreeMap<usize, Preview>,
}

/// The effect of an event.
enum Next {
    Stay,
    Start,
    End,
}

impl Menu {
    /// Whether a program matches the search text.
    fn finds(&self, index: usize) -> bool {
        let Some(program) = ALL.get(index) else { return false };
        let Words(hungarian, english) = program.manual.about;
        [program.manual.name, hungarian, english].iter().any(|text| folded(text).contains(&self.search))
    }

    /// Chooses the next or the previous matching program, wrapping around.
    fn step(&mut self, forward: bool) {
        let mut order: Vec<usize> = layout::order().collect();
        if !forward {
            order.reverse();
        }
        let at = order.iter().position(|index| *index == self.chosen).map_or(0, |at| at + 1);
        let mut others = order.iter().cycle().skip(at).take(order.len());
        self.chosen = others.find(|index| self.finds(**index)).copied().unwrap_or(self.chosen);
    }

    /// Chooses a program of the next or the previous group.
    fn step_group(&mut self, forward: bool) {
        let group = layout::group(self.chosen);
        for _ in 0..ALL.len() {
            self.step(forward);
            if layout::group(self.chosen) != group {
                return;
            }
        }
    }

    /// Changes the search text, unless nothing matches the longer text.
    fn look_for(&mut self, search: String) {
        let before = std::mem::replace(&mut self.search, search);
        match layout::order().find(|&index| self.finds(index)) {
            None => self.search = before,
            Some(_) if self.finds(self.chosen) => {}
            Some(first) => self.chosen = first,
        }
    }

    fn react(&mut self, tick: &Tick) -> Next {
        if let Some(index) = tick.click().and_then(|place| self.at(place)) {
            self.chosen = index;
            return Next::Start;
        }
        match tick.key() {
            Some(Key::Down) => self.step(true),
            Some(Key::Up) => self.step(false),
            Some(Key::Right | Key::PageDown) => self.step_group(true),
            Some(Key::Left | Key::PageUp) => self.step_group(false),
            Some(Key::Home) => {
                self.chosen = layout::order().last().unwrap_or(0);
                self.step(true);
            }
            Some(Key::End) => {
                self.chosen = layout::order().next().unwrap_or(0);
                self.step(false);
            }
            Some(Key::Enter) => return Next::Start,
            Some(Key::Esc) if !self.search.is_empty() => self.search.clear(),
            Some(Key::Esc) => return Next::End,
            Some(Key::Char('q' | 'Q')) if self.search.is_empty() => return Next::End,
            Some(Key::Backspace) => {
                self.search.pop();
            }
            Some(Key::Char(typed)) => self.look_for(format!("{}{}", self.search, folded(&typed.to_string()))),
            _ => {}
        }
        Next::Stay
    }

    /// The program whose line or picture is at a place.
    fn at(&self, (x, y): (i32, i32)) -> Option<usize> {
        let line = lines().find_map(|(area, line)| match line {
            Line::Program(index) if area.holds(x, y) => Some(index),
            _ => None,
        });
        let mut shown = layout::group(self.chosen).into_iter().flat_map(layout::programs).enumerate();
        line.or_else(|| shown.find(|&(at, _)| picture_area(at).holds(x, y)).map(|(_, index)| index))
    }

    /// A program of the chosen group that has no picture yet, the chosen one first.
    fn missing(&self) -> Option<usize> {
        let group = layout::group(self.chosen).into_iter().flat_map(layout::programs);
        std::iter::once(self.chosen).chain(group).find(|index| !self.previews.contains_key(index))
    }

    /// Makes one small picture.
    fn make(&mut self, index: usize, language: Language) {
        let Some(program) = ALL.get(index) else { return };
        self.previews.insert(index, Preview::new(program, language));
    }
}

/// A text folded for searching: lower case without accents, so that no Hungarian keyboard is needed.
fn folded(text: &str) -> String {
    let plain = |letter: char| match letter {
        'á' => 'a',
        'é' => 'e',
        'í' => 'i',
        'ó' | 'ö' | 'ő' => 'o',
        'ú' | 'ü' | 'ű' => 'u',
        other => other,
    };
    text.to_lowercase().chars().map(plain).collect()
}

impl Picture for Menu {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::LightCyan);
        let inner = Area::new(12, 12, 627, 467);
        screen.bar(inner.x1, inner.y1, inner.x2, inner.y2, Color::Black);
        sunken(screen, inner, 4);
        screen.title(24, 16, "GRAFIKA", Color::LightMagenta, 3, Direction::Horizontal);
        let subtitle =
            Words("Füzi János: Interaktív grafika (1997)", "János Füzi: Interaktív grafika (1997)");
        screen.text(204, 30, subtitle.of(language), Color::LightGray);
        for (area, line) in lines() {
            match line {
                Line::Group(group) => {
                    screen.text(area.x1, area.y1 + 1, group.name.of(language), Color::LightMagenta);
                }
                Line::Program(index) => self.draw_line(screen, area, index),
            }
        }
        let shown = layout::group(self.chosen).into_iter().flat_map(layout::programs);
        shown.enumerate().for_each(|(at, index)| self.draw_preview(screen, picture_area(at), index));
        if let Some(program) = ALL.get(self.chosen) {
            screen.text(layout::LEFT, 436, program.manual.about.of(language), Color::White);
        }
        match self.search.as_str() {
            "" => {
                let keys = Words(
                    "Enter: indítás  betűk: keresés  F1: súgó  F2: English  Q: kilép",
                    "Enter: start  letters: search  F1: help  F2: magyar  Q: quit",
                );
                screen.text(layout::LEFT, 450, keys.of(language), Color::LightGray);
            }
            search => {
                let word = Words("Keresés:", "Search:").of(language);
                screen.text(layout::LEFT, 450, &format!("{word} {search}_"), Color::Yellow);
            }
        }
    }
}

impl Menu {
    fn draw_line(&self, screen: &mut Screen, area: Area, index: usize) {
        let Some(program) = ALL.get(index) else { return };
        let ink = match (index == self.chosen, self.finds(index)) {
            (true, _) => {
                screen.bar(area.x1, area.y1, area.x2, area.y2, Color::Cyan);
                Color::White
            }
            (false, true) => Color::Yellow,
            (false, false) => Color::DarkGray,
        };
        screen.text(area.x1 + 8, area.y1 + 1, &program.manual.name.to_uppercase(), ink);
    }

    fn draw_preview(&self, screen: &mut Screen, area: Area, index: usize) {
        let Some(program) = ALL.get(index) else { return };
        let ink = if index == self.chosen { Color::Yellow } else { Color::LightGray };
        screen.rectangle(
            area.x1 - 1,
            area.y1 - 1,
            area.x2 + 1,
            area.y2 + 1,
            crate::screen::Stroke::thin(ink),
        );
        if let Some(preview) = self.previews.get(&index) {
            preview.draw(screen, (area.x1, area.y1));
        }
        screen.text(area.x1, area.y2 + 4, &program.manual.name.to_uppercase(), ink);
    }
}

async fn run(machine: &mut Machine) -> Asked<()> {
    let mut menu = Menu { chosen: 0, search: String::new(), previews: BTreeMap::new() };
    let mut desk = Desk::new(machine, MANUAL);
    let (mut seen, mut shown) = (desk.machine.now(), desk.machine.now());
    loop {
        let now = desk.machine.now();
        let moving = now < seen + REST && menu.previews.get(&menu.chosen).is_some_and(Preview::moves);
        let tick = match menu.missing() {
            Some(_) => desk.event_before(&menu, now).await?,
            None if moving => desk.event_before(&menu, shown + STEP).await?,
            None => desk.event(&menu).await?,
        };
        if tick.event.is_some() {
            seen = tick.now;
            match menu.react(&tick) {
                Next::Stay => {}
                Next::End => return Ok(()),
                Next::Start => {
                    let program = ALL.get(menu.chosen).ok_or(Stop::Closed)?;
                    let Ok(start) = (program.start)(None) else { continue };
                    desk.machine.set_file(None);
                    desk.machine.become_guest();
                    let ended = start(desk.machine).await;
                    // Esc returns here; the close button closes the menu too.
                    if !desk.machine.end_visit() {
                        ended.unless_cancelled()?;
                    }
                }
            }
        } else if let Some(index) = menu.missing() {
            menu.make(index, desk.machine.language());
        } else if let Some(preview) = menu.previews.get_mut(&menu.chosen) {
            preview.go_on(STEP);
            shown = tick.now;
        }
    }
}
