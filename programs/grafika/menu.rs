//! The menu: the programs with a line about each, started with Enter or a click.

use crate::PROGRAMS;
use grafika::launch::Program;
use grafika::machine::{Key, Language, Machine, Quit};
use grafika::screen::{Color, Direction, Screen};
use grafika::ui::{Area, Desk, Manual, Picture, Words, sunken};

const MANUAL: Manual = Manual {
    name: "grafika",
    about: Words("A könyv programjai", "The programs of the book"),
    keys: &[
        (Words("Fel Le", "Up Down"), Words("választás", "choose")),
        (Words("Enter, egér", "Enter, mouse"), Words("indítás", "start")),
        (Words("Q Esc", "Q Esc"), Words("vége", "end")),
    ],
    lesson: &[],
};

/// The menu as a program.
pub(crate) const MENU: Program =
    Program { manual: MANUAL, chapter: "5", run: |machine, _| Box::pin(run(machine)), check: |_| Ok(()) };

/// Upper edge of the first line of the list.
const TOP: i32 = 88;
/// Height of a line of the list.
const LINE: i32 = 11;

/// What the menu shows.
struct Menu {
    chosen: usize,
}

impl Picture for Menu {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::LightCyan);
        let inner = Area::new(12, 12, 627, 467);
        screen.bar(inner.x1, inner.y1, inner.x2, inner.y2, Color::Black);
        sunken(screen, inner, 4);
        screen.title(36, 24, "GRAFIKA", Color::LightMagenta, 4, Direction::Horizontal);
        let subtitle =
            Words("Füzi János: Interaktív grafika (1997)", "János Füzi: Interaktív grafika (1997)");
        screen.text(300, 46, subtitle.of(language), Color::LightGray);
        for (index, program) in PROGRAMS.iter().enumerate() {
            let Area { x1, y1, x2, y2 } = line(index);
            let ink = if index == self.chosen {
                screen.bar(x1, y1, x2, y2, Color::Cyan);
                Color::White
            } else {
                Color::LightGray
            };
            screen.text(x1 + 8, y1 + 2, &program.manual.name.to_uppercase(), Color::Yellow);
            screen.text(x1 + 96, y1 + 2, program.manual.about.of(language), ink);
        }
        let keys = Words(
            "Fel, Le, Enter: indítás   F1: súgó   F2: English   Q: vége",
            "Up, Down, Enter: start   F1: help   F2: magyar   Q: end",
        );
        screen.text(36, 440, keys.of(language), Color::LightGray);
    }
}

/// Where a line of the list stands.
fn line(index: usize) -> Area {
    let y = TOP + LINE * i32::try_from(index).unwrap_or(i32::MAX / LINE / 2);
    Area::new(28, y, 611, y + LINE - 1)
}

async fn run(machine: &mut Machine) -> Result<(), Quit> {
    let mut menu = Menu { chosen: 0 };
    loop {
        let mut desk = Desk::new(machine, MANUAL);
        let chosen = loop {
            let tick = desk.event(&menu).await?;
            if let Some(index) =
                tick.click().and_then(|(x, y)| (0..PROGRAMS.len()).find(|&index| line(index).holds(x, y)))
            {
                break index;
            }
            match tick.key() {
                Some(Key::Down) => menu.chosen = (menu.chosen + 1) % PROGRAMS.len(),
                Some(Key::Up) => menu.chosen = (menu.chosen + PROGRAMS.len() - 1) % PROGRAMS.len(),
                Some(Key::Enter) => break menu.chosen,
                Some(Key::Esc) => return Ok(()),
                _ if tick.letter() == Some('Q') => return Ok(()),
                _ => {}
            }
        };
        menu.chosen = chosen;
        machine.set_file(None);
        (PROGRAMS[chosen].run)(machine, None).await?;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_fits_into_the_menu() {
        assert!(line(PROGRAMS.len() - 1).y2 < 432);
        for program in PROGRAMS {
            let Words(hungarian, english) = program.manual.about;
            assert!(program.manual.name.len() <= 10, "{}", program.manual.name);
            assert!(
                hungarian.chars().count() <= 60 && english.chars().count() <= 60,
                "{}",
                program.manual.name
            );
        }
    }
}
