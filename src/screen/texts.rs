//! The journal of the texts that stand on the screen.
//!
//! The screen is pixels and nothing else; but a display in a terminal shows texts better as letters than as blocks. So
//! every text drawn is noted down, and [`Screen::texts`] gives those back whose pixels nobody has touched since.

use super::letters::{SIZE, glyph};
use super::{Color, HEIGHT, Screen, WIDTH};
use std::collections::{BTreeMap, HashSet};

/// A text on the screen: letters in one row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// Left edge in pixels.
    pub x: i32,
    /// Upper edge in pixels.
    pub y: i32,
    /// Width in pixels.
    pub width: i32,
    /// Height in pixels: 8, or more for strokes.
    pub height: i32,
    /// The characters from left to right with their colours; blanks among them have the colour of the letter before.
    pub letters: Vec<(char, Color)>,
    /// Something hides a part of it.
    pub covered: bool,
}

impl Text {
    /// The characters alone.
    #[must_use]
    pub fn string(&self) -> String {
        self.letters.iter().map(|&(ch, _)| ch).collect()
    }

    /// Where it has ended, in pixels.
    fn end(&self) -> i32 {
        self.x + self.width
    }
}

/// What was written at one place.
#[derive(Clone, Debug)]
struct Note {
    text: Box<str>,
    color: Color,
    /// Where the pixels of strokes are, and the size of their box; letters need none.
    strokes: Option<Strokes>,
}

#[derive(Clone, Debug)]
struct Strokes {
    size: (i32, i32),
    pixels: Box<[(i16, i16)]>,
}

/// The texts drawn, by row and column; a text in the same place takes the place of the former.
#[derive(Clone, Debug, Default)]
pub(super) struct Journal {
    notes: BTreeMap<(i32, i32), Note>,
    /// Letters written since the last pruning, and those kept by it.
    letters: usize,
}

/// A journal of more letters than this is pruned of overwritten texts. More than any screen holds: 80x60 letters stand
/// side by side.
const JOURNAL_LIMIT: usize = 10_000;

/// Texts up to this length are numbers and names of points: covered in part they are shown whole or not at all.
const SHORT: usize = 3;

impl Journal {
    pub(super) fn clear(&mut self) {
        *self = Journal::default();
    }

    pub(super) fn note(&mut self, place: (i32, i32), text: &str, color: Color) {
        self.insert(place, Note { text: text.into(), color, strokes: None });
    }

    fn insert(&mut self, (x, y): (i32, i32), note: Note) {
        let beside = x >= WIDTH || y >= HEIGHT || y <= -SIZE;
        if beside || note.text.trim().is_empty() {
            return;
        }
        self.letters = self.letters.saturating_add(note.text.len());
        let length = note.text.chars().count();
        let Some(before) = self.notes.insert((y, x), note).filter(|before| before.strokes.is_none()) else {
            return;
        };
        // Of a longer text the rest may stand still.
        let rest: String = before.text.chars().skip(length).collect();
        let end = i32::try_from(length).ok().and_then(|length| x.checked_add(length.checked_mul(SIZE)?));
        if let Some(end) = end.filter(|_| !rest.trim().is_empty()) {
            self.notes.entry((y, end)).or_insert(Note { text: rest.into(), ..before });
        }
    }

    pub(super) fn is_long(&self) -> bool {
        self.letters > JOURNAL_LIMIT
    }
}

/// What can be seen of a note.
enum Seen {
    Nothing,
    Whole(Text),
    /// Pieces of it, none of them cut within a word.
    Parts(Vec<Text>),
}

impl Screen {
    /// Notes a title whose strokes have just been drawn in a box.
    pub(super) fn note_title(&mut self, (x, y): (i32, i32), size: (i32, i32), text: &str, color: Color) {
        let (right, bottom) = (x.saturating_add(size.0), y.saturating_add(size.1));
        if x < 0 || y < 0 || right > WIDTH || bottom > HEIGHT || !text.chars().all(has_letter) {
            return;
        }
        let places = (y..bottom).flat_map(|y| (x..right).map(move |x| (x, y)));
        let inked = places.filter(|&(x, y)| self.pixel(x, y) == Some(color));
        // All of them lie on the screen.
        let pixels = inked.map(|(x, y)| (x as i16, y as i16)).collect();
        let note = Note { text: text.into(), color, strokes: Some(Strokes { size, pixels }) };
        self.journal.insert((x, y), note);
    }

    /// Forgets the texts that are gone. Should a screen full of overlapping specks still be left, forgets all, so that
    /// the next pruning is far away.
    pub(super) fn prune(&mut self) {
        let mut journal = std::mem::take(&mut self.journal);
        journal.notes.retain(|&place, note| !matches!(self.seen(place, note), Seen::Nothing));
        journal.letters = journal.notes.values().map(|note| note.text.len()).sum();
        if journal.letters <= JOURNAL_LIMIT / 2 {
            self.journal = journal;
        }
    }

    /// The texts written by [`Screen::text`] and [`Screen::title`] (across) that still stand on the screen, row by row.
    /// Texts that touch or have one blank between them are one. Of a long text that is covered in part, the words
    /// are left of which at least three quarters can be seen; a short one is given whole, as covered, if at least half of it can be seen.
    #[must_use]
    pub fn texts(&self) -> Vec<Text> {
        let mut texts: Vec<Text> = Vec::new();
        let mut known = HashSet::new();
        for (&place, note) in &self.journal.notes {
            let seen = match self.seen(place, note) {
                Seen::Nothing => continue,
                Seen::Whole(text) => vec![text],
                Seen::Parts(parts) => parts,
            };
            for text in seen {
                // A short text over a longer one of the same letters is one text.
                if !known.insert((text.y, text.end(), text.letters.last().copied())) {
                    continue;
                }
                match texts.last_mut() {
                    Some(before) if joined(before, &text) => join(before, text),
                    _ => texts.push(text),
                }
            }
        }
        texts
    }

    fn seen(&self, (y, x): (i32, i32), note: &Note) -> Seen {
        if let Some(strokes) = &note.strokes {
            let color = Some(note.color);
            if !strokes.pixels.iter().all(|&(x, y)| self.pixel(x.into(), y.into()) == color) {
                return Seen::Nothing;
            }
            let letters = note.text.chars().map(|ch| (ch, note.color)).collect();
            let (width, height) = strokes.size;
            return Seen::Whole(Text { x, y, width, height, letters, covered: false });
        }
        let place = |at: usize| i32::try_from(at).ok().and_then(|at| x.checked_add(at.checked_mul(SIZE)?));
        let shown: Vec<Option<bool>> = note
            .text
            .chars()
            .enumerate()
            .map(|(at, ch)| {
                (ch != ' ').then(|| place(at).is_some_and(|x| self.shows_whole((x, y), ch, note.color)))
            })
            .collect();
        let letters: Vec<char> = note.text.chars().collect();
        let text = |from: usize, to: usize, covered| {
            let slice = letters.get(from..to).unwrap_or_default();
            let letters: Vec<(char, Color)> = slice.iter().map(|&ch| (ch, note.color)).collect();
            let width = i32::try_from(letters.len()).unwrap_or(0) * SIZE;
            Text { x: place(from).unwrap_or(x), y, width, height: SIZE, letters, covered }
        };
        let seen = shown.iter().filter(|shown| **shown == Some(true)).count();
        let all = shown.iter().flatten().count();
        let first = shown.iter().position(Option::is_some).unwrap_or(0);
        let last = shown.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
        if seen == 0 {
            Seen::Nothing
        } else if seen == all {
            Seen::Whole(text(first, last, false))
        } else if last - first <= SHORT {
            let inside =
                x >= 0 && y >= 0 && place(last).is_some_and(|end| end <= WIDTH) && y <= HEIGHT - SIZE;
            let enough = 2 * seen >= all && inside && letters.iter().all(|&ch| has_letter(ch));
            if enough { Seen::Parts(vec![text(first, last, true)]) } else { Seen::Nothing }
        } else {
            // A frame may touch a letter of a word.
            let touched =
                |from: usize, to: usize| shown[from..to].iter().filter(|seen| **seen != Some(true)).count();
            let known = |from: usize, to: usize| letters[from..to].iter().all(|&ch| has_letter(ch));
            let whole =
                words(&shown).filter(|&(from, to)| 4 * touched(from, to) <= to - from && known(from, to));
            Seen::Parts(whole.map(|(from, to)| text(from, to, false)).collect())
        }
    }

    /// Whether a letter stands on the screen untouched and uncut, and is one that a terminal can show as well: a box is
    /// no text, and a terminal might obey the character that it stands for, or give it two cells.
    fn shows_whole(&self, (x, y): (i32, i32), ch: char, color: Color) -> bool {
        (0..=WIDTH - SIZE).contains(&x)
            && (0..=HEIGHT - SIZE).contains(&y)
            && has_letter(ch)
            && self.shows((x, y), ch, color)
    }
}

fn has_letter(ch: char) -> bool {
    !ch.is_control() && glyph(ch).is_some_and(|rows| ch == ' ' || rows != [0; 8])
}

/// The places of words: where they begin, and where they have ended.
fn words(shown: &[Option<bool>]) -> impl Iterator<Item = (usize, usize)> {
    let mut from = 0;
    shown.chunk_by(|a, b| a.is_some() == b.is_some()).filter_map(move |run| {
        let start = from;
        from += run.len();
        run.first().is_some_and(Option::is_some).then_some((start, from))
    })
}

/// Whether a text continues another one.
fn joined(before: &Text, text: &Text) -> bool {
    let gap = text.x - before.end();
    let letters = before.height == SIZE && text.height == SIZE;
    letters && before.y == text.y && (0..=SIZE).contains(&gap) && !before.covered && !text.covered
}

fn join(before: &mut Text, text: Text) {
    let color = before.letters.last().map_or(Color::Black, |&(_, color)| color);
    if text.x - before.end() >= SIZE / 2 {
        before.letters.push((' ', color));
    }
    before.width = text.end() - before.x;
    before.letters.extend(text.letters);
}

#[cfg(test)]
mod tests {
    use super::super::{Direction, Stroke};
    use super::*;

    fn shown(screen: &Screen) -> Vec<String> {
        screen.texts().iter().map(Text::string).collect()
    }

    #[test]
    fn untouched_texts_are_reported_in_reading_order() {
        let mut screen = Screen::new();
        screen.text(50, 40, "second", Color::Red);
        screen.text(300, 20, "the first", Color::White);
        assert_eq!(shown(&screen), ["the first", "second"]);
        let first = &screen.texts()[0];
        assert_eq!((first.x, first.y, first.width, first.height), (300, 20, 72, 8));
        assert_eq!(first.letters[0], ('t', Color::White));
    }

    #[test]
    fn neighbours_are_one_text() {
        let mut screen = Screen::new();
        screen.text(50, 40, "B", Color::Red);
        screen.text(58, 40, "-insert", Color::White);
        screen.text(122, 40, "point", Color::White);
        screen.text(200, 40, "far", Color::White);
        screen.text(232, 41, "not level", Color::White);
        assert_eq!(shown(&screen), ["B-insert point", "far", "not level"]);
        assert_eq!(screen.texts()[0].letters[1], ('-', Color::White));
    }

    #[test]
    fn touched_texts_keep_their_whole_words() {
        let mut screen = Screen::new();
        screen.text(0, 0, "one two three", Color::White);
        screen.bar(40, 0, 47, 7, Color::Black);
        assert_eq!(shown(&screen), ["one", "three"]);
        screen.line(102, 0, 102, 7, Stroke::thin(Color::Red));
        assert_eq!(shown(&screen), ["one", "three"], "a letter is touched");
        screen.bar(0, 0, 7, 7, Color::Black);
        screen.text(0, 0, "O", Color::Yellow);
        assert_eq!(shown(&screen), ["One", "three"], "the first letter has a colour of its own");
        screen.clear(Color::Blue);
        assert!(shown(&screen).is_empty());
    }

    #[test]
    fn numbers_are_whole_or_not_at_all() {
        let mut screen = Screen::new();
        screen.text(100, 100, "49", Color::White);
        screen.bar(100, 100, 107, 107, Color::Black);
        assert_eq!(shown(&screen), ["49"]);
        assert!(screen.texts()[0].covered);
        screen.bar(108, 100, 115, 107, Color::Black);
        assert!(shown(&screen).is_empty());
        screen.text(100, 200, "123", Color::White);
        screen.bar(100, 200, 115, 207, Color::Black);
        assert!(shown(&screen).is_empty());
    }

    #[test]
    fn titles_are_texts_until_something_touches_them() {
        let mut screen = Screen::new();
        screen.title(100, 100, "Q", Color::Cyan, 2, Direction::Horizontal);
        screen.title(300, 100, "up", Color::Cyan, 2, Direction::Vertical);
        assert_eq!(shown(&screen), ["Q"]);
        assert!(screen.texts()[0].height > 8);
        screen.bar(100, 100, 110, 140, Color::Red);
        assert!(shown(&screen).is_empty());
    }

    #[test]
    fn what_is_no_letter_is_no_text() {
        let mut screen = Screen::new();
        screen.text(0, 0, "a\u{4E2D}bcd \u{7F}", Color::White);
        screen.text(-4, 20, "cut by the edge", Color::White);
        screen.text(0, 40, "   ", Color::White);
        assert_eq!(shown(&screen), ["by the edge"]);
    }

    #[test]
    fn texts_written_again_are_reported_once() {
        let mut screen = Screen::new();
        for round in 0..5000 {
            screen.bar(0, 0, 639, 100, Color::Cyan);
            screen.text(round % 200, 3, "Again", Color::Black);
        }
        assert_eq!(shown(&screen), ["Again"]);
        assert!(!screen.journal.is_long());
    }

    #[test]
    fn journal_is_bounded_even_when_all_letters_stand() {
        let mut screen = Screen::new();
        for (x, y) in (0..630).step_by(3).flat_map(|x| (0..470).step_by(3).map(move |y| (x, y))) {
            screen.text(x, y, ".", Color::from_index(((x + y) % 16) as u8));
        }
        assert!(!screen.journal.is_long());
    }
}
