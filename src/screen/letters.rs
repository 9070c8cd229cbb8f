//! Letters of 8x8 pixels from the VGA's ROM.

use super::{Color, HEIGHT, Screen, WIDTH};

/// Width and height of a letter in pixels.
pub(super) const SIZE: i32 = 8;

/// The letters with a Unicode table (PSF version 1, mode with 512 glyphs and a table); see
/// `fonts/README.md`.
static FONT: &[u8] = include_bytes!("fonts/Uni2-VGA8.psf");

const HEADER: usize = 4;
const GLYPHS: usize = 512;
const TABLE: usize = HEADER + GLYPHS * SIZE as usize;

/// Ends the characters of one glyph in the font's table.
const END: u16 = 0xFFFF;
/// Begins sequences of combining characters, which are not used here.
const SEQUENCE: u16 = 0xFFFE;

/// Number of characters that the font has a glyph for.
const CHARACTERS: usize = count_characters();

/// Character codes and glyph numbers, sorted by code; made of the font's table at compile time.
static INDEX: [(u16, u16); CHARACTERS] = sorted_index();

/// What stands for characters that the font lacks.
const UNKNOWN: [u8; 8] = [0x7E, 0x42, 0x42, 0x42, 0x42, 0x42, 0x7E, 0x00];

const fn table_entry(at: usize) -> u16 {
    u16::from_le_bytes([FONT[at], FONT[at + 1]])
}

const fn count_characters() -> usize {
    index_into([(0, 0); GLYPHS * 4]).1
}

const fn sorted_index() -> [(u16, u16); CHARACTERS] {
    index_into([(0, 0); CHARACTERS]).0
}

/// Writes the font's characters into `index` by insertion, and counts them. Runs in the compiler
/// only, where an index out of bounds would be an error of compilation.
const fn index_into<const N: usize>(mut index: [(u16, u16); N]) -> ([(u16, u16); N], usize) {
    let (mut count, mut glyph, mut at, mut in_sequence) = (0, 0, TABLE, false);
    while at + 1 < FONT.len() {
        let entry = table_entry(at);
        at += 2;
        if entry == END {
            glyph += 1;
            in_sequence = false;
        } else if entry == SEQUENCE {
            in_sequence = true;
        } else if !in_sequence {
            let mut place = count;
            while place > 0 && index[place - 1].0 > entry {
                index[place] = index[place - 1];
                place -= 1;
            }
            index[place] = (entry, glyph);
            count += 1;
        }
    }
    (index, count)
}

/// The eight rows of a letter from the top, the leftmost pixel in the highest bit; `None` when there
/// is no letter for the character.
#[must_use]
pub fn glyph(ch: char) -> Option<[u8; 8]> {
    let number = match redrawn(ch) {
        Some(rows) => return Some(rows),
        None => corrected(ch).or_else(|| listed(ch))?,
    };
    let start = HEADER + usize::from(number) * SIZE as usize;
    FONT.get(start..start + SIZE as usize)?.try_into().ok()
}

/// The number of a character's glyph by the font's table. The table's Greek letters point to glyphs
/// that are none, so they do not count.
fn listed(ch: char) -> Option<u16> {
    if ('\u{370}'..='\u{3FF}').contains(&ch) {
        return None;
    }
    let code = u16::try_from(u32::from(ch)).ok()?;
    let place = INDEX.binary_search_by_key(&code, |entry| entry.0).ok()?;
    INDEX.get(place).map(|entry| entry.1)
}

/// The glyphs of characters for which the font's table gives wrong ones or none.
fn corrected(ch: char) -> Option<u16> {
    Some(match ch {
        'α' => 461,
        'Γ' | 'Г' => 462,
        'δ' => 469,
        'ε' | '∈' => 470,
        'Θ' => 467,
        'μ' => 464,
        'π' => 463,
        'Σ' | '∑' => 235,
        'σ' => 238,
        'τ' => 465,
        'Φ' | 'Ф' => 466,
        'Ω' => 468,
        '∩' => 471,
        '≡' => 227,
        _ => return None,
    })
}

/// Letters that the font lacks, or draws so that they cannot be read: its ő looks like an 8.
fn redrawn(ch: char) -> Option<[u8; 8]> {
    match ch {
        'ő' => Some([0x66, 0xCC, 0x00, 0x7C, 0xC6, 0xC6, 0x7C, 0x00]),
        '…' => Some([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xDB, 0x00]),
        _ => None,
    }
}

impl Screen {
    /// Writes a text of 8x8 letters in one line from (x, y), the top left of the first letter. The
    /// background stays as it is. A character without a letter is written as a box.
    pub fn text(&mut self, x: i32, y: i32, text: &str, color: Color) {
        let mut left = x;
        for ch in text.chars() {
            if left >= WIDTH {
                break;
            }
            self.letter((left, y), ch, color);
            left = left.saturating_add(SIZE);
        }
        self.journal.note((x, y), text, color);
        if self.journal.is_long() {
            self.prune();
        }
    }

    fn letter(&mut self, (x, y): (i32, i32), ch: char, color: Color) {
        if x <= -SIZE || x >= WIDTH || y <= -SIZE || y >= HEIGHT {
            return;
        }
        let rows = glyph(ch).unwrap_or(UNKNOWN);
        for (row, bits) in (y..).zip(rows) {
            for (column, bit) in (x..).zip([0x80, 0x40, 0x20, 0x10, 8, 4, 2, 1]) {
                if bits & bit != 0 {
                    self.set(column, row, color);
                }
            }
        }
    }

    /// Whether the pixels of a letter have its colour and the pixels between have not.
    pub(super) fn shows(&self, (x, y): (i32, i32), ch: char, color: Color) -> bool {
        let rows = glyph(ch).unwrap_or(UNKNOWN);
        (y..).zip(rows).all(|(y, bits)| {
            (x..x + SIZE)
                .zip([0x80, 0x40, 0x20, 0x10, 8, 4, 2, 1])
                .all(|(x, bit)| (self.pixel(x, y) == Some(color)) == (bits & bit != 0))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::assert_art;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn hungarian_letters_can_be_told_apart() {
        let mut screen = Screen::new();
        screen.text(0, 0, "oöőuüű", Color::White);
        assert_art(&screen, OU);
    }

    const OU: &str = "
        ........FF...FF..FF..FF.........FF..FF...FF..FF.
        ................FF..FF..................FF..FF..
        .FFFFF...FFFFF..........FF..FF..FF..FF..........
        FF...FF.FF...FF..FFFFF..FF..FF..FF..FF..FF..FF..
        FF...FF.FF...FF.FF...FF.FF..FF..FF..FF..FF..FF..
        FF...FF.FF...FF.FF...FF.FF..FF..FF..FF..FF..FF..
        .FFFFF...FFFFF...FFFFF...FFF.FF..FFF.FF..FFF.FF.
        ................................................";

    #[test]
    fn every_character_of_the_book_has_a_letter() {
        let ascii: String = (' '..='~').collect();
        let more = "áéíóöőúüűÁÉÍÓÖŐÚÜŰΣπ°²·←↑→↓–—“”„…±≡≤≥≈√─│┌┐└┘█░▒▓■☺";
        for ch in ascii.chars().chain(more.chars()) {
            assert!(glyph(ch).is_some(), "no letter for {ch:?}");
        }
        assert_eq!(glyph('\u{4E2D}'), None);
        assert_eq!(glyph('🙂'), None);
        assert_eq!(glyph('ψ'), None);
    }

    #[test]
    fn glyphs_are_found_in_a_sorted_table() {
        assert!(INDEX.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        assert_eq!(glyph('A'), Some([0x38, 0x6C, 0xC6, 0xFE, 0xC6, 0xC6, 0xC6, 0x00]));
    }

    #[test]
    fn greek_and_boxes() {
        let mut screen = Screen::new();
        screen.text(0, 0, "Σπ…中", Color::White);
        assert_art(&screen, GREEK);
    }

    const GREEK: &str = "
        FFFFFFF..................FFFFFF.
        FF...FF..................F....F.
        .FF.....FFFFFFF..........F....F.
        ..FF.....FF.FF...........F....F.
        .FF......FF.FF...........F....F.
        FF...FF..FF.FF...........F....F.
        FFFFFFF..FF.FF..FF.FF.FF.FFFFFF.
        ................................";

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        #[test]
        fn any_text_anywhere(x: i32, y: i32, text: String) {
            let mut screen = Screen::new();
            screen.text(x, y, &text, Color::White);
            screen.text(x % 700, y % 500, &text, Color::White);
            for shown in screen.texts() {
                prop_assert!(shown.letters.iter().all(|&(ch, _)| ch == ' ' || text.contains(ch)));
            }
        }
    }
}
