//! The menu: the programs by groups, each with a small picture in which it runs and a line about it; chosen by arrows
//! or by pointing, started with Enter or a click, found by typing.

mod layout;
mod preview;
#[cfg(feature = "native")]
pub mod text;

use super::ALL;
use crate::figure::wrap;
use crate::machine::{Asked, Asking, Event, Key, Language, Machine, Stop, Tick};
use crate::screen::{Color, Direction, HEIGHT, Screen, Stroke, WIDTH, base_letter};
use crate::ui::{
    Area, CommandLine, Demo, Desk, Manual, Phrase, Picture, Program, Stay, Words, sunken, without_document,
    words,
};
use layout::{Grid, PITCH, Step, VIEW};
use preview::{Preview, SMALL};
use std::collections::BTreeMap;
use std::time::Duration;

const MANUAL: Manual = Manual {
    name: "grafika",
    about: Words("A könyv programjai", "The programs of the book"),
    intro: Words(
        "Füzi János Interaktív grafika című könyvének (1997) programjai; mindegyik fut a saját kis képében. Kezdje a \
         GB_2D_IP-vel (húzzon el egy pontot) vagy a BILIARD-dal (lökje meg a bal oldali golyót). A könyv alapgondolata: ami a \
         képernyőn látszik, azt egérrel meg lehet fogni, és a rajz követi.",
        "The programs of János Füzi's book Interaktív grafika (1997), each with a picture in which it runs. Try GB_2D_IP \
         first (drag a point) or BILIARD (shoot the ball on the left). The idea of the book: what is on the screen can be \
         taken with the mouse, and the drawing follows.",
    ),
    keys: &[
        (Words("nyilak", "arrows"), Words("választás a rácsban", "choose in the grid")),
        (Words("PgUp PgDn", "PgUp PgDn"), Words("három sorral feljebb, lejjebb", "three rows up, down")),
        (Words("Home End", "Home End"), Words("első, utolsó program", "first, last program")),
        (Words("betűk", "letters"), Words("keresés névben és leírásban", "search in names and descriptions")),
        (Words("Backspace", "Backspace"), Words("az utolsó betű törlése", "delete the last letter")),
        (
            Words("egér", "mouse"),
            Words("rámutatva választ, kattintva indít", "point to choose, click to start"),
        ),
        (Words("görgő", "wheel"), Words("lapozás", "scroll")),
        (Words("Enter", "Enter"), Words("indítás", "start")),
        (
            Words("Esc", "Esc"),
            Words("keresés vége; kilépés, kérdés után", "end the search; quit, which is asked for"),
        ),
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

/// The time between two pictures of the chosen program: enough for a small one, and under 3 % of a core.
const STEP: Duration = Duration::from_millis(200);
/// After so long without a key the pictures stand, so that a forgotten menu takes no power.
const REST: Duration = Duration::from_secs(30);
/// Letters in a line about a program.
const LETTERS: usize = 19;

/// What the menu shows.
struct Menu {
    /// Index of the chosen program.
    chosen: usize,
    /// Pixels of the grid above the part that is seen.
    scroll: i32,
    /// What is searched for, as it is searched in.
    search: String,
    /// The programs that are found.
    grid: Grid,
    /// The small pictures made so far, by the programs' numbers.
    previews: BTreeMap<usize, Preview>,
}

/// The effect of an event.
enum Next {
    Stay,
    Start,
    Quit,
    /// Nothing has what is searched for with one more letter.
    Refuse(String),
}

/// Whether a program has all words that are searched for, in its name, its line or the name of its group.
fn finds(program: &Program, search: &str) -> bool {
    let Words(hungarian, english) = program.manual.about;
    let Words(group, of_group) = program.group.name;
    let text = folded(&[program.manual.name, hungarian, english, group, of_group].join("\n"));
    search.split_whitespace().all(|word| text.contains(word))
}

/// The programs that are found.
fn grid(search: &str) -> Grid {
    Grid::of(|index| ALL.get(index).is_some_and(|program| finds(program, search)))
}

impl Menu {
    fn new() -> Menu {
        let grid = grid("");
        let chosen = grid.first().unwrap_or(0);
        Menu { chosen, scroll: 0, search: String::new(), grid, previews: BTreeMap::new() }
    }

    fn choose(&mut self, index: usize) {
        if self.chosen != index {
            self.chosen = index;
            self.previews.get_mut(&index).into_iter().for_each(Preview::wake);
        }
    }

    fn step(&mut self, step: Step) {
        self.choose(self.grid.after(self.chosen, step));
        self.scroll = self.grid.revealing(self.chosen, self.scroll);
    }

    /// Changes what is searched for; a longer text that nothing has is not taken.
    fn look_for(&mut self, search: String) -> Next {
        let found = grid(&search);
        let Some(first) = found.first() else { return Next::Refuse(search) };
        if !found.tiles().any(|(index, _)| index == self.chosen) {
            self.choose(first);
        }
        (self.search, self.grid) = (search, found);
        self.scroll = self.grid.revealing(self.chosen, self.scroll);
        Next::Stay
    }

    fn react(&mut self, tick: &Tick) -> Next {
        let pointed = self.at((tick.mouse.x, tick.mouse.y));
        match tick.event {
            Some(Event::Move(..)) => pointed.into_iter().for_each(|index| self.choose(index)),
            Some(Event::Wheel(steps)) => {
                let by = steps.clamp(-100, 100) * PITCH;
                self.scroll = (self.scroll - by).clamp(0, self.grid.farthest());
                // What has come under the mouse is pointed at.
                self.at((tick.mouse.x, tick.mouse.y)).into_iter().for_each(|index| self.choose(index));
            }
            _ => {}
        }
        if let Some(index) = tick.click().and(pointed) {
            self.choose(index);
            return Next::Start;
        }
        let Some(key) = tick.key() else { return Next::Stay };
        if let Some((_, step)) = STEPS.iter().find(|(known, _)| *known == key) {
            self.step(*step);
            return Next::Stay;
        }
        match key {
            Key::Enter => Next::Start,
            Key::Esc if self.search.is_empty() => Next::Quit,
            Key::Esc => self.look_for(String::new()),
            Key::Backspace => {
                let mut shorter = self.search.clone();
                shorter.pop();
                self.look_for(shorter)
            }
            // A blank alone looks for nothing.
            Key::Char(' ') if self.search.is_empty() => Next::Stay,
            Key::Char(typed) => self.look_for(format!("{}{}", self.search, folded(&typed.to_string()))),
            _ => Next::Stay,
        }
    }

    /// The tiles that are seen, if only in part, where they are seen.
    fn seen(&self) -> impl Iterator<Item = (usize, Area)> {
        let by = VIEW.y1 - self.scroll;
        let tiles = self.grid.tiles();
        let moved = tiles.map(move |(index, it)| (index, Area::new(it.x1, it.y1 + by, it.x2, it.y2 + by)));
        moved.filter(|(_, area)| area.y1 <= VIEW.y2 && VIEW.y1 <= area.y2)
    }

    /// The program at a place.
    fn at(&self, (x, y): (i32, i32)) -> Option<usize> {
        let hit = |area: Area| VIEW.holds(x, y) && area.holds(x, y);
        self.seen().find(|(_, area)| hit(*area)).map(|(index, _)| index)
    }

    /// A program that is seen and whose picture is still to be made, the chosen one first.
    fn missing(&self) -> Option<usize> {
        let seen = self.seen().map(|(index, _)| index);
        std::iter::once(self.chosen).chain(seen).find(|index| !self.previews.contains_key(index))
    }

    /// Makes one small picture.
    fn make(&mut self, index: usize, language: Language) {
        let Some(program) = ALL.get(index) else { return };
        self.previews.insert(index, Preview::new(program, language));
    }
}

/// The keys that move over the grid.
const STEPS: [(Key, Step); 8] = [
    (Key::Left, Step::Left),
    (Key::Right, Step::Right),
    (Key::Up, Step::Up),
    (Key::Down, Step::Down),
    (Key::PageUp, Step::PageUp),
    (Key::PageDown, Step::PageDown),
    (Key::Home, Step::First),
    (Key::End, Step::Last),
];

/// A text as it is searched in: small letters without accents, so that a search needs no Hungarian keyboard.
fn folded(text: &str) -> String {
    text.to_lowercase().chars().map(base_letter).collect()
}

impl Picture for Menu {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::Black);
        for (group, top) in self.grid.headings() {
            let y = VIEW.y1 + top - self.scroll + 7;
            screen.text(LEFT, y, group.name.of(language), Color::LightMagenta);
        }
        self.seen().for_each(|(index, area)| self.draw_tile(screen, area, index, language));
        if let Some(handle) = self.grid.handle(self.scroll) {
            screen.bar(handle.x1, handle.y1, handle.x2, handle.y2, Color::Cyan);
        }
        // Rows are seen in part at the edges of the view: what lies around it covers the rest.
        let inner = Area::new(12, 12, 627, 467);
        for (top, bottom, color) in [
            (0, inner.y1 - 1, Color::LightCyan),
            (inner.y1, VIEW.y1 - 1, Color::Black),
            (VIEW.y2 + 1, inner.y2, Color::Black),
            (inner.y2 + 1, HEIGHT - 1, Color::LightCyan),
        ] {
            screen.bar(0, top, WIDTH - 1, bottom, color);
        }
        screen.bar(0, 0, inner.x1 - 1, HEIGHT - 1, Color::LightCyan);
        screen.bar(inner.x2 + 1, 0, WIDTH - 1, HEIGHT - 1, Color::LightCyan);
        sunken(screen, inner, 4);
        self.draw_texts(screen, language);
    }
}

/// Left edge of the texts.
const LEFT: i32 = 24;

impl Menu {
    fn draw_texts(&self, screen: &mut Screen, language: Language) {
        screen.title(LEFT, 16, "GRAFIKA", Color::LightMagenta, 3, Direction::Horizontal);
        let subtitle =
            Words("Füzi János: Interaktív grafika (1997)", "János Füzi: Interaktív grafika (1997)");
        screen.text(204, 22, subtitle.of(language), Color::LightGray);
        let word = Words("Keresés:", "Search:").of(language);
        match self.search.as_str() {
            "" => {
                let typing = Words("gépeljen bármit", "just type").of(language);
                screen.text(204, 36, &format!("{word} {typing}"), Color::LightGray);
            }
            search => screen.text(204, 36, &format!("{word} {search}_"), Color::Yellow),
        }
        let keys = Words(
            "Enter, kattintás: indítás   F1: súgó   F2: English   Esc: kilépés",
            "Enter, click: start   F1: help   F2: magyar   Esc: quit",
        );
        screen.text(LEFT, 447, keys.of(language), Color::LightGray);
    }

    /// A program: its picture, and beside it its name and what it is.
    fn draw_tile(&self, screen: &mut Screen, area: Area, index: usize, language: Language) {
        let Some(program) = ALL.get(index) else { return };
        let chosen = index == self.chosen;
        if chosen {
            screen.bar(area.x1, area.y1, area.x2, area.y2, Color::Blue);
        }
        let ink = if chosen { Color::White } else { Color::DarkGray };
        screen.rectangle(area.x1, area.y1, area.x2, area.y2, Stroke::thin(ink));
        if let Some(preview) = self.previews.get(&index) {
            preview.draw(screen, (area.x1 + 3, area.y1 + 3));
        }
        let x = area.x1 + SMALL.0 + 10;
        screen.text(x, area.y1 + 8, &program.manual.name.to_uppercase(), Color::Yellow);
        let ink = if chosen { Color::White } else { Color::LightGray };
        let about = wrap(program.manual.about.of(language), LETTERS);
        for (y, line) in (area.y1 + 24..).step_by(12).zip(&about) {
            screen.text(x, y, line, ink);
        }
    }
}

async fn run(machine: &mut Machine) -> Asked<()> {
    let mut menu = Menu::new();
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
                Next::Refuse(search) => desk.tell(nothing_has(&search), Stay::Briefly),
                Next::Quit => {
                    if desk.yes(&menu, words::ASK_END).await.unless_cancelled()? == Some(true) {
                        return Ok(());
                    }
                }
                Next::Start => start(&mut desk, menu.chosen).await?,
            }
        } else if let Some(index) = menu.missing() {
            menu.make(index, desk.machine.language());
        } else if let Some(preview) = menu.previews.get_mut(&menu.chosen) {
            preview.go_on(STEP);
            shown = tick.now;
        }
    }
}

/// No program has what is searched for.
fn nothing_has(search: &str) -> Phrase {
    Phrase::new(format!("Nincs ilyen: {search}"), format!("Nothing found: {search}"))
}

/// Runs a program as a guest until it comes back. Esc brings back here; the close button closes the menu too.
async fn start(desk: &mut Desk<'_>, index: usize) -> Asked<()> {
    let program = ALL.get(index).ok_or(Stop::Closed)?;
    let Ok(start) = (program.start)(None) else { return Ok(()) };
    desk.machine.set_file(None);
    desk.machine.become_guest();
    let ended = start(desk.machine).await;
    // The keys are the menu's again.
    desk.set_keys(MANUAL.keys);
    if !desk.machine.end_visit() {
        ended.unless_cancelled()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_program_is_stands_beside_its_picture() {
        for program in ALL {
            let Words(hungarian, english) = program.manual.about;
            for about in [hungarian, english] {
                assert!(wrap(about, LETTERS).len() <= 6, "{about}");
            }
        }
    }
}
