//! Titles in a stroked Triplex face, in ten sizes, across or upwards.
//!
//! The strokes are Hershey's roman triplex, which the Triplex face of the original's graphics library
//! goes back to; heights, widths and places are fitted to what the programs showed. Hershey drew no
//! Hungarian letters: accents are strokes of our own over the base letters.

use super::{Color, Screen, Stroke};
use serde::{Deserialize, Serialize};

/// The direction in which a title runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Direction {
    /// From left to right.
    #[default]
    Horizontal,
    /// From below upwards, the letters lying on their backs.
    Vertical,
}

/// The strokes, one line a character from the blank to the tilde; see `fonts/README.md`. A line has
/// the glyph's number in columns 0-4, the number of pairs in 5-7, then pairs of letters, each minus
/// `R` a coordinate, y downwards: first the left and right bounds, then the points of the strokes.
/// The pair ` R` lifts the pen.
static FONT: &str = include_str!("fonts/rowmant.jhf");

const FIRST: u32 = ' ' as u32;
const GLYPHS: usize = 95;

/// Where the line of each glyph begins in [`FONT`].
static LINES: [usize; GLYPHS] = line_starts();

/// Runs in the compiler only, where an index out of bounds would be an error of compilation.
const fn line_starts() -> [usize; GLYPHS] {
    let mut starts = [0; GLYPHS];
    let (mut at, mut glyph) = (0, 1);
    while glyph < GLYPHS {
        if FONT.as_bytes()[at] == b'\n' {
            starts[glyph] = at + 1;
            glyph += 1;
        }
        at += 1;
    }
    starts
}

/// Size of the pixels' grid in the units of the font, for the sizes 1 to 10.
const SCALES: [f64; 10] = [0.55, 0.65, 0.75, 1.0, 1.3, 1.65, 2.0, 2.5, 3.0, 4.0];
/// The original's face is narrower than Hershey's.
const NARROWING: f64 = 0.91;
/// The y of the base line in the font's units, and those of the tops of small letters and capitals.
const BASE: f64 = 9.0;
const SMALL_TOP: f64 = -5.0;
const CAPITAL_TOP: f64 = -12.0;
/// Heights above and below the base line of the box that a title is placed by: room for accents
/// above the capitals, and for descenders.
const ASCENT: f64 = 28.0;
const DESCENT: f64 = 7.0;

fn scale(size: u8) -> f64 {
    let index = usize::from(size.clamp(1, 10)) - 1;
    SCALES.get(index).copied().unwrap_or(1.0)
}

/// A character drawn as strokes.
struct Glyph {
    left: f64,
    right: f64,
    strokes: Vec<Vec<(f64, f64)>>,
}

impl Glyph {
    /// The glyph of a character; that of the question mark where there is none.
    fn new(ch: char) -> Glyph {
        let (base, accent) = decompose(ch);
        let mut glyph = Glyph::plain(base).or_else(|| Glyph::plain('?')).unwrap_or(Glyph::BLANK);
        if let Some(accent) = accent {
            glyph.put(accent, if base.is_uppercase() { CAPITAL_TOP } else { SMALL_TOP });
        }
        glyph
    }

    const BLANK: Glyph = Glyph { left: -8.0, right: 8.0, strokes: Vec::new() };

    /// The glyph of a printable ASCII character.
    fn plain(ch: char) -> Option<Glyph> {
        let start = *LINES.get(u32::from(ch).checked_sub(FIRST)? as usize)?;
        let line = FONT.get(start..)?.lines().next()?.get(8..)?;
        let mut pairs = line.as_bytes().chunks_exact(2).filter_map(|pair| <[u8; 2]>::try_from(pair).ok());
        let coordinate = |letter: u8| f64::from(letter) - f64::from(b'R');
        let [left, right] = pairs.next()?.map(coordinate);
        let mut strokes = vec![Vec::new()];
        for pair in pairs {
            match strokes.last_mut() {
                Some(stroke) if pair != *b" R" => {
                    let [x, y] = pair.map(coordinate);
                    stroke.push((x, y));
                }
                _ => strokes.push(Vec::new()),
            }
        }
        Some(Glyph { left, right, strokes })
    }

    /// Puts an accent above a letter whose top is at `top`, in the place of the dot of an i or j.
    fn put(&mut self, accent: Accent, top: f64) {
        self.strokes.retain(|stroke| stroke.iter().any(|&(_, y)| y >= top));
        let middle = (self.left + self.right) / 2.0;
        for stroke in accent.strokes() {
            self.strokes.push(stroke.iter().map(|&(x, y)| (middle + x, top + y)).collect());
        }
    }

    fn advance(&self) -> f64 {
        (self.right - self.left) * NARROWING
    }
}

/// The accents of Hungarian.
#[derive(Clone, Copy)]
enum Accent {
    Acute,
    Dots,
    DoubleAcute,
}

impl Accent {
    /// Strokes relative to the middle of the letter's top.
    fn strokes(self) -> &'static [&'static [(f64, f64)]] {
        const ACUTE: &[(f64, f64)] = &[(-1.0, -2.0), (3.0, -7.0), (4.0, -6.0), (-1.0, -2.0)];
        const LEFT_ACUTE: &[(f64, f64)] = &[(-5.0, -2.0), (-2.0, -7.0), (-1.0, -6.0), (-5.0, -2.0)];
        const RIGHT_ACUTE: &[(f64, f64)] = &[(1.0, -2.0), (4.0, -7.0), (5.0, -6.0), (1.0, -2.0)];
        const LEFT_DOT: &[(f64, f64)] =
            &[(-5.0, -5.0), (-3.0, -5.0), (-3.0, -4.0), (-5.0, -4.0), (-5.0, -5.0)];
        const RIGHT_DOT: &[(f64, f64)] = &[(3.0, -5.0), (5.0, -5.0), (5.0, -4.0), (3.0, -4.0), (3.0, -5.0)];
        match self {
            Accent::Acute => &[ACUTE],
            Accent::Dots => &[LEFT_DOT, RIGHT_DOT],
            Accent::DoubleAcute => &[LEFT_ACUTE, RIGHT_ACUTE],
        }
    }
}

/// The letter without the accent that Hungarian may put on it.
#[must_use]
pub fn base_letter(ch: char) -> char {
    decompose(ch).0
}

/// The letter and the accent that a Hungarian letter is made of.
fn decompose(ch: char) -> (char, Option<Accent>) {
    let (base, accent) = match ch {
        'á' => ('a', Accent::Acute),
        'é' => ('e', Accent::Acute),
        'í' => ('i', Accent::Acute),
        'ó' => ('o', Accent::Acute),
        'ö' => ('o', Accent::Dots),
        'ő' => ('o', Accent::DoubleAcute),
        'ú' => ('u', Accent::Acute),
        'ü' => ('u', Accent::Dots),
        'ű' => ('u', Accent::DoubleAcute),
        'Á' => ('A', Accent::Acute),
        'É' => ('E', Accent::Acute),
        'Í' => ('I', Accent::Acute),
        'Ó' => ('O', Accent::Acute),
        'Ö' => ('O', Accent::Dots),
        'Ő' => ('O', Accent::DoubleAcute),
        'Ú' => ('U', Accent::Acute),
        'Ü' => ('U', Accent::Dots),
        'Ű' => ('U', Accent::DoubleAcute),
        other => return (other, None),
    };
    (base, Some(accent))
}

/// Width and height in pixels of the box of a title that runs horizontally: the height has room for
/// accents and descenders. Sizes are those of [`Screen::title`].
#[must_use]
pub fn title_size(text: &str, size: u8) -> (i32, i32) {
    let scale = scale(size);
    let glyphs: Vec<Glyph> = text.chars().map(Glyph::new).collect();
    (length(&glyphs, scale) as i32, ((ASCENT + DESCENT) * scale).round() as i32)
}

/// Length of a line of glyphs in whole pixels.
fn length(glyphs: &[Glyph], scale: f64) -> f64 {
    (glyphs.iter().map(Glyph::advance).sum::<f64>() * scale).round()
}

impl Screen {
    /// Draws a title in strokes one pixel wide, in size 1 (capitals 12 pixels high) to 10 (84 pixels);
    /// other sizes count as the nearest of these. (x, y) is the top left corner of the title's box,
    /// which has the size [`title_size`], its sides swapped for a vertical title; capitals stand a
    /// fifth of the box below its upper edge. Characters that the face lacks become question marks.
    pub fn title(&mut self, x: i32, y: i32, text: &str, color: Color, size: u8, direction: Direction) {
        let scale = scale(size);
        let base = (ASCENT * scale).floor();
        let glyphs: Vec<Glyph> = text.chars().map(Glyph::new).collect();
        let length = length(&glyphs, scale);
        let place = |along: f64, up: f64| {
            let (dx, dy) = match direction {
                Direction::Horizontal => (along.round(), base - up.round()),
                Direction::Vertical => (base - up.round(), length - along.round()),
            };
            (x.saturating_add(dx as i32), y.saturating_add(dy as i32))
        };
        let mut pen = 0.0;
        for glyph in &glyphs {
            for stroke in &glyph.strokes {
                let points: Vec<_> = stroke
                    .iter()
                    .map(|&(x, y)| {
                        let along = pen + (x - glyph.left) * NARROWING;
                        place(along * scale, (BASE - y) * scale)
                    })
                    .collect();
                self.polyline(&points, Stroke::thin(color));
            }
            pen += glyph.advance();
        }
        if direction == Direction::Horizontal {
            self.note_title((x, y), title_size(text, size), text, color);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::region;
    use super::*;
    use proptest::prelude::*;

    /// The smallest box around the pixels that are not black: left, top, right, bottom.
    fn bounds(screen: &Screen) -> (i32, i32, i32, i32) {
        let drawn = (0..640).flat_map(|x| (0..480).map(move |y| (x, y)));
        drawn
            .filter(|&(x, y)| screen.pixel(x, y) != Some(Color::Black))
            .fold((i32::MAX, i32::MAX, i32::MIN, i32::MIN), |(left, top, right, bottom), (x, y)| {
                (left.min(x), top.min(y), right.max(x), bottom.max(y))
            })
    }

    fn drawn(text: &str, size: u8, direction: Direction) -> Screen {
        let mut screen = Screen::new();
        screen.title(10, 10, text, Color::White, size, direction);
        screen
    }

    /// The places that the originals' titles take up on the screen.
    #[test]
    fn titles_take_up_the_room_of_the_originals() {
        let near = |a: i32, b: i32| (a - b).abs() <= 3;
        let (left, top, right, bottom) = bounds(&drawn("GYONGYKEREK", 4, Direction::Horizontal));
        assert_eq!((top, bottom), (17, 38));
        assert!(near(left, 13) && near(right, 231), "{left}..{right}");
        let (left, top, right, bottom) = bounds(&drawn("CSANGO KOCKA", 4, Direction::Horizontal));
        assert_eq!((top, bottom), (17, 38));
        assert!(near(left, 13) && near(right, 239), "{left}..{right}");
        let (_, top, _, bottom) = bounds(&drawn("M", 1, Direction::Horizontal));
        assert_eq!((top, bottom), (13, 25));
        let (_, top, _, bottom) = bounds(&drawn("X", 2, Direction::Horizontal));
        assert_eq!((top, bottom), (14, 28));
    }

    #[test]
    fn vertical_titles_are_turned_to_the_left() {
        let (across, up) = (drawn("Fg", 3, Direction::Horizontal), drawn("Fg", 3, Direction::Vertical));
        let (width, height) = title_size("Fg", 3);
        for (x, y) in (-1..width + 2).flat_map(|x| (-1..height + 2).map(move |y| (x, y))) {
            assert_eq!(across.pixel(10 + x, 10 + y), up.pixel(10 + y, 10 + width - x));
        }
    }

    #[test]
    fn accents_lie_within_the_box_above_their_letters() {
        for pair in ["áa", "ée", "íi", "óo", "öo", "őo", "úu", "üu", "űu", "ÁA", "ÉE", "ÍI", "ÓO", "ÖO"]
        {
            let mut letters = pair.chars().map(String::from);
            let (accented, plain) = (letters.next().unwrap(), letters.next().unwrap());
            assert_eq!(title_size(&accented, 4), title_size(&plain, 4));
            let (left, top, right, bottom) = bounds(&drawn(&accented, 4, Direction::Horizontal));
            let (width, height) = title_size(&accented, 4);
            assert!(left >= 10 && right <= 10 + width && top >= 10 && bottom <= 10 + height);
            assert_ne!(drawn(&accented, 4, Direction::Horizontal), drawn(&plain, 4, Direction::Horizontal));
        }
    }

    #[test]
    fn letters_are_told_apart_by_their_accents() {
        let picture = |text| region(&drawn(text, 1, Direction::Horizontal), 0, 0, 60, 60);
        assert_ne!(picture("ö"), picture("ő"));
        assert_ne!(picture("ü"), picture("ű"));
        assert_eq!(picture("中"), picture("?"));
    }

    #[test]
    fn every_printable_character_has_strokes() {
        for ch in '!'..='~' {
            assert!(Glyph::plain(ch).is_some_and(|glyph| glyph.strokes.iter().any(|s| s.len() > 1)), "{ch}");
        }
        assert!(Glyph::plain(' ').is_some_and(|glyph| glyph.right > glyph.left));
        assert!(Glyph::plain('\u{7F}').is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn any_title_anywhere(x: i32, y: i32, text: String, size: u8) {
            let mut screen = Screen::new();
            for direction in [Direction::Horizontal, Direction::Vertical] {
                screen.title(x, y, &text, Color::White, size, direction);
                screen.title(x % 640, y % 480, &text, Color::White, size, direction);
            }
        }
    }
}
