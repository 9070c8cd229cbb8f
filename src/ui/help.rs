//! The help page: what a program is for, its keys, and the explanation of its subject; then what its picture shows.
//!
//! Where a mouse points, each of both is one page. Where keys do, in a terminal, the page also names those keys, and is
//! given in parts of no more lines than a small terminal has rows.

use super::desk::{Desk, KeyHelp, Manual};
use super::lesson::{self, Lesson};
use super::seen::{self, Paragraph};
use super::words::{self, Words};
use crate::figure::wrap;
use crate::machine::{Asked, Key, Language, POINTER_KEYS, Pointing};
use crate::screen::{Color, HEIGHT, Screen, WIDTH};

impl Desk<'_> {
    /// Shows the program's help page until a key or click; one of several pages until it has been turned.
    pub(super) async fn read_help(&mut self) -> Asked<()> {
        let mut at = 0;
        loop {
            let language = self.machine.language();
            let pages = pages(&self.manual, language, self.machine.pointing());
            let Some(page) = pages.get(at) else { return Ok(()) };
            page.draw(self.machine.screen(), &self.manual, language);
            self.film_screen();
            let tick = self.machine.event().await?;
            match tick.key() {
                Some(key) if self.turns_preference(key) => {}
                Some(Key::CtrlF(12)) => {
                    self.switch_film();
                    return Ok(());
                }
                Some(Key::Esc) => return Ok(()),
                Some(Key::Up | Key::Left | Key::PageUp | Key::Backspace) if pages.len() > 1 => {
                    at = at.saturating_sub(1);
                }
                Some(_) => at += 1,
                None if tick.click().is_some() => at += 1,
                None => {}
            }
        }
    }
}

/// Keys common to all programs, listed after the program's own ones.
pub(super) const COMMON_KEYS: &[KeyHelp] = &[
    (Words("F1", "F1"), words::HELP_HELP),
    (Words("F2", "F2"), words::HELP_LANGUAGE),
    (Words("F9", "F9"), words::HELP_SETTINGS),
    (Words("F10", "F10"), words::HELP_FIGURE),
    (Words("F11 Ctrl+F11", "F11 Ctrl+F11"), words::HELP_WINDOW_LOOK),
    (Words("F12", "F12"), words::HELP_PICTURE),
    (Words("Ctrl+F12", "Ctrl+F12"), words::HELP_FILM),
    (Words("Esc", "Esc"), words::HELP_ESC),
];

/// Upper edge of the first line and of the introduction on the page.
const TOP: i32 = 36;
const INTRO_TOP: i32 = 68;
/// Lines of the introduction at most.
#[cfg(test)]
const INTRO_LINES: usize = 4;
/// Letters in a line of the introduction.
const INTRO_LETTERS: usize = 70;

/// Left edge of the help page's texts, and of what its keys do.
const COLUMNS: [i32; 2] = [40, 176];

/// Height of a line of the page about the picture.
const SEEN_LINE: i32 = 14;

/// Where the last line of the help page stands.
const LEAVE_TOP: i32 = HEIGHT - 40;

/// Lines of a page where keys point, but for its first and its last one.
const LINES: usize = 18;
/// Height of such a line.
const LINE: i32 = 20;
/// Letters of such a line, and of what a key does: what the narrowest terminal has room for.
const LETTERS: [usize; 2] = [54, 34];

/// A text of the help page: where its first letter stands, and its colour.
type Placed = ((i32, i32), String, Color);

/// One page.
struct Page {
    texts: Vec<Placed>,
    /// Where the explanation begins, if it is on this page.
    lesson: Option<i32>,
}

impl Page {
    fn draw(&self, screen: &mut Screen, manual: &Manual, language: Language) {
        screen.clear(Color::LightCyan);
        let inner = super::frame::Area::new(16, 16, WIDTH - 17, HEIGHT - 17);
        screen.bar(inner.x1, inner.y1, inner.x2, inner.y2, Color::Black);
        super::frame::sunken(screen, inner, 4);
        for ((x, y), text, color) in &self.texts {
            screen.text(*x, *y, text, *color);
        }
        if let Some(top) = self.lesson {
            lesson::draw(screen, top, manual.lesson, language);
        }
    }
}

/// The pages for a language and a way to point.
fn pages(manual: &Manual, language: Language, pointing: Pointing) -> Vec<Page> {
    match pointing {
        Pointing::Mouse => {
            let seen = seen_page(manual, language);
            let (texts, top) = whole(manual, language, leave(seen.is_none()));
            std::iter::once(Page { texts, lesson: Some(top) }).chain(seen).collect()
        }
        Pointing::Keys => parts(manual, language),
    }
}

/// The lines about keys: the program's own, then the common ones.
fn key_lines(manual: &Manual, language: Language) -> Vec<KeyHelp> {
    // A program's own meaning of a key replaces the common one.
    let own =
        |key: &str| manual.keys.iter().any(|(keys, _)| keys.of(language).split(' ').any(|own| own == key));
    let common = COMMON_KEYS.iter().filter(|(key, _)| !own(key.of(language)));
    manual.keys.iter().chain(common).copied().collect()
}

fn intro(manual: &Manual, language: Language) -> impl Iterator<Item = String> {
    wrap(manual.intro.of(language), INTRO_LETTERS).into_iter().filter(|line| !line.is_empty())
}

/// What the last line of a page says.
fn leave(last: bool) -> Words {
    if last { words::HELP_LEAVE } else { words::HELP_TURN }
}

/// The lines that tell what a program's picture shows, with a blank one between paragraphs.
fn seen_lines(manual: &Manual, language: Language, letters: usize) -> Vec<(String, Color)> {
    let mut lines: Vec<(String, Color)> = Vec::new();
    let mut formula = false;
    for paragraph in seen::paragraphs(manual.name, language) {
        let follows = matches!(paragraph, Paragraph::Formula(_)) && formula;
        if !lines.is_empty() && !follows {
            lines.push((String::new(), Color::Black));
        }
        formula = matches!(paragraph, Paragraph::Formula(_));
        let (text, color) = match &paragraph {
            Paragraph::Text(text) => (text.as_str(), Color::LightCyan),
            Paragraph::Try(text) => (text.as_str(), Color::Yellow),
            // Its columns stay where there is room for them.
            Paragraph::Formula(text) if text.chars().count() <= letters => {
                lines.push(((*text).to_owned(), Color::White));
                continue;
            }
            Paragraph::Formula(text) => (*text, Color::White),
        };
        lines.extend(wrap(text, letters).into_iter().map(|line| (line, color)));
    }
    lines
}

/// The page about a program's picture, if there is something to tell.
fn seen_page(manual: &Manual, language: Language) -> Option<Page> {
    let [left, _] = COLUMNS;
    let lines = seen_lines(manual, language, INTRO_LETTERS);
    let last = ((left, LEAVE_TOP), words::HELP_LEAVE.of(language).to_owned(), Color::LightGray);
    let title = ((left, TOP), manual.name.to_uppercase(), Color::Yellow);
    let placed = (INTRO_TOP..).step_by(SEEN_LINE as usize).zip(lines);
    let texts = placed.map(|(y, (line, color))| ((left, y), line, color));
    let texts: Vec<Placed> = [title, last].into_iter().chain(texts).collect();
    (texts.len() > 2).then_some(Page { texts, lesson: None })
}

/// The texts of the first page, and where the lesson begins.
fn whole(manual: &Manual, language: Language, leave: Words) -> (Vec<Placed>, i32) {
    let [left, right] = COLUMNS;
    let mut texts = vec![
        ((left, TOP), manual.name.to_uppercase(), Color::Yellow),
        ((left, 52), manual.about.of(language).to_owned(), Color::White),
    ];
    let mut y = INTRO_TOP;
    for line in intro(manual, language) {
        texts.push(((left, y), line, Color::LightCyan));
        y += 11;
    }
    y += 12;
    let lines = key_lines(manual, language);
    let count = i32::try_from(lines.len()).unwrap_or(i32::MAX).max(1);
    // Where there is much to say, the lines move together.
    let room = HEIGHT - 48 - y - lesson::height(manual.lesson);
    let line = (room / count).clamp(9, 16);
    for (keys, what) in lines {
        texts.push(((left, y), keys.of(language).to_owned(), Color::LightRed));
        texts.push(((right, y), what.of(language).to_owned(), Color::White));
        y += line;
    }
    texts.push(((left, LEAVE_TOP), leave.of(language).to_owned(), Color::LightGray));
    (texts, y + 8)
}

/// A line of a part of the page.
enum Line {
    Text(String, Color),
    Keys(String, String),
}

/// The same in parts, with the keys that point.
fn parts(manual: &Manual, language: Language) -> Vec<Page> {
    let wrapped = |text: &str, color: Color| {
        let lines = wrap(text, LETTERS[0]).into_iter().filter(|line| !line.is_empty());
        lines.map(move |line| Line::Text(line, color)).collect::<Vec<_>>()
    };
    let mut lines = wrapped(manual.about.of(language), Color::White);
    lines.extend(wrapped(manual.intro.of(language), Color::LightCyan));
    lines.push(Line::Text(String::new(), Color::White));
    let keys = |(keys, what): KeyHelp| {
        let names = std::iter::once(keys.of(language).to_owned()).chain(std::iter::repeat(String::new()));
        names
            .zip(wrap(what.of(language), LETTERS[1]))
            .map(|(keys, what)| Line::Keys(keys, what))
            .collect::<Vec<_>>()
    };
    lines.extend(key_lines(manual, language).into_iter().flat_map(keys));
    let mut sections = vec![lines];
    let pointer =
        POINTER_KEYS.iter().map(|help| (Words(help.keys, help.keys), Words(help.hungarian, help.english)));
    let mut lines = vec![Line::Text(words::HELP_POINTER.of(language).to_owned(), Color::White)];
    lines.extend(pointer.flat_map(|(keys, what)| {
        // The keys are too long to stand beside what they do.
        [
            Line::Text(keys.of(language).to_owned(), Color::LightRed),
            Line::Text(format!("  {}", what.of(language)), Color::White),
        ]
    }));
    let tables = manual.lesson.iter().any(|piece| !matches!(piece, Lesson::Line(_)));
    if !tables && !manual.lesson.is_empty() {
        let told = manual.lesson.iter().filter_map(|piece| match piece {
            Lesson::Line(text) => Some(wrapped(text.of(language), Color::LightCyan)),
            _ => None,
        });
        sections.push(told.flatten().collect());
    }
    sections.push(lines);
    let seen = seen_lines(manual, language, LETTERS[0]).into_iter();
    sections.push(seen.map(|(text, color)| Line::Text(text, color)).collect());
    let chunks: Vec<&[Line]> = sections.iter().flat_map(|lines| lines.chunks(LINES)).collect();
    let count = chunks.len() + usize::from(tables);
    let page = |number: usize| {
        let title = format!("{} {number}/{count}", manual.name.to_uppercase());
        let [left, _] = COLUMNS;
        let last = ((left, LEAVE_TOP), leave(number == count).of(language).to_owned(), Color::LightGray);
        vec![((left, TOP), title, Color::Yellow), last]
    };
    let mut pages: Vec<Page> = Vec::new();
    for (number, lines) in (1..).zip(chunks) {
        let mut texts = page(number);
        for (y, line) in (TOP + LINE..).step_by(LINE as usize).zip(lines) {
            let [left, right] = COLUMNS;
            match line {
                Line::Text(text, color) => texts.push(((left, y), text.clone(), *color)),
                Line::Keys(keys, what) => {
                    texts.push(((left, y), keys.clone(), Color::LightRed));
                    texts.push(((right, y), what.clone(), Color::White));
                }
            }
        }
        pages.push(Page { texts, lesson: None });
    }
    if tables {
        pages.push(Page { texts: page(count), lesson: Some(TOP + LINE) });
    }
    pages
}

#[cfg(test)]
impl Manual {
    /// Whether there is a page that tells what the program's picture shows.
    pub(crate) fn tells_what_is_seen(&self, language: Language) -> bool {
        seen_page(self, language).is_some()
    }

    /// What does not fit on the help page in a language.
    pub(crate) fn misfits(&self, language: Language) -> Vec<String> {
        let [left, right] = COLUMNS;
        // The frame's inner edge.
        let edge = WIDTH - 17 - 4;
        let (texts, top) = whole(self, language, words::HELP_TURN);
        let width = |text: &str| 8 * i32::try_from(text.chars().count()).unwrap_or(i32::MAX / 8);
        let is_key = |color: &Color| *color == Color::LightRed;
        let beyond = texts
            .iter()
            .filter(|((x, _), text, color)| x + width(text) > if is_key(color) { right } else { edge });
        let mut misfits: Vec<String> = beyond.map(|(_, text, _)| text.clone()).collect();
        let lines: Vec<i32> = texts.iter().filter(|text| is_key(&text.2)).map(|((_, y), ..)| *y).collect();
        if lines.is_sorted_by(|above, below| above + 9 <= *below) && !lines.is_empty() {
            // The lesson has its distance to the keys in its height.
            let bottom = top - 8 + lesson::height(self.lesson);
            misfits.extend((bottom > LEAVE_TOP - 8).then(|| format!("the page ends at {bottom}")));
        } else {
            misfits.push("the keys stand too close".to_owned());
        }
        let lesson = self.lesson.iter().filter_map(|piece| match piece {
            Lesson::Line(words) => Some(words.of(language)),
            _ => None,
        });
        misfits.extend(lesson.filter(|text| left + width(text) > edge).map(str::to_owned));
        let seen = seen_page(self, language);
        let lowest = seen.iter().flat_map(|page| &page.texts[2..]).map(|((_, y), ..)| *y).max();
        misfits.extend(
            lowest.filter(|y| y + SEEN_LINE > LEAVE_TOP).map(|y| format!("the picture's page ends at {y}")),
        );
        let lines = parts(self, language).into_iter().chain(seen).flat_map(|page| page.texts);
        misfits.extend(lines.filter(|((x, _), text, _)| x + width(text) > edge).map(|(_, text, _)| text));
        if wrap(self.intro.of(language), INTRO_LETTERS).len() > INTRO_LINES {
            misfits.push(self.intro.of(language).to_owned());
        }
        misfits
    }
}
