//! The characters that a cell can show, and the one that comes nearest to its pixels.

use crate::machine::Glyphs;
use crate::screen::base_letter;
use std::sync::LazyLock;

/// The pixels of a cell, 8 to a row and 16 rows; bit `8 * row + column` is set where the ink is.
pub(super) type Mask = u128;

/// Width and height of a mask.
pub(super) const SIZE: (usize, usize) = (8, 16);

/// The characters by their quarters: bit 0 upper left, 1 upper right, 2 lower left, 3 lower right.
const QUARTERS: [char; 16] = [' ', '▘', '▝', '▀', '▖', '▌', '▞', '▛', '▗', '▚', '▐', '▜', '▄', '▙', '▟', '█'];

/// The characters whose lower or left eighths are filled, one eighth to seven.
const LOWER: [char; 7] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇'];
const LEFT: [char; 7] = ['▏', '▎', '▍', '▌', '▋', '▊', '▉'];

/// Octants that Unicode 16 did not add, because others have them: by their pattern, bit 0 upper left, bit 1 upper right,
/// downwards to bit 7.
const OTHER_OCTANTS: [(u8, char); 26] = [
    (0, ' '),
    (1, '\u{1CEA8}'),
    (2, '\u{1CEAB}'),
    (3, '\u{1FB82}'),
    (5, '▘'),
    (10, '▝'),
    (15, '▀'),
    (20, '\u{1FBE6}'),
    (40, '\u{1FBE7}'),
    (63, '\u{1FB85}'),
    (64, '\u{1CEA3}'),
    (80, '▖'),
    (85, '▌'),
    (90, '▞'),
    (95, '▛'),
    (128, '\u{1CEA0}'),
    (160, '▗'),
    (165, '▚'),
    (170, '▐'),
    (175, '▜'),
    (192, '▂'),
    (240, '▄'),
    (245, '▙'),
    (250, '▟'),
    (252, '▆'),
    (255, '█'),
];

/// Two points of a line, in halves of the width and thirds of the height, and whether the ink is at the lower right of it
/// instead of the lower left.
type Wedge = ((u8, u8), (u8, u8), bool);

/// The wedges from U+1FB3C on.
const WEDGES: [Wedge; 22] = [
    ((0, 2), (1, 3), false),
    ((0, 2), (2, 3), false),
    ((0, 1), (1, 3), false),
    ((0, 1), (2, 3), false),
    ((0, 0), (1, 3), false),
    ((0, 1), (1, 0), true),
    ((0, 1), (2, 0), true),
    ((0, 2), (1, 0), true),
    ((0, 2), (2, 0), true),
    ((0, 3), (1, 0), true),
    ((0, 2), (2, 1), true),
    ((1, 3), (2, 2), true),
    ((0, 3), (2, 2), true),
    ((1, 3), (2, 1), true),
    ((0, 3), (2, 1), true),
    ((1, 3), (2, 0), true),
    ((1, 0), (2, 1), false),
    ((0, 0), (2, 1), false),
    ((1, 0), (2, 2), false),
    ((0, 0), (2, 2), false),
    ((1, 0), (2, 3), false),
    ((0, 1), (2, 2), false),
];

/// A mask of the pixels that a test holds for, by column and row.
fn mask(inked: impl Fn(usize, usize) -> bool) -> Mask {
    let places = (0..SIZE.1).flat_map(|row| (0..SIZE.0).map(move |column| (column, row)));
    places
        .filter(|&(column, row)| inked(column, row))
        .fold(0, |mask, (column, row)| mask | 1 << (8 * row + column))
}

/// A way to divide the cell into two columns of parts.
struct Parts {
    masks: Vec<Mask>,
}

impl Parts {
    /// Parts of so many rows; their edges are rounded as terminals round them.
    fn new(rows: usize) -> Parts {
        let edge = |row: usize| (SIZE.1 * row + rows / 2) / rows;
        let part = |part: usize| {
            let (left, row) = (4 * (part % 2), part / 2);
            mask(|x, y| (left..left + 4).contains(&x) && (edge(row)..edge(row + 1)).contains(&y))
        };
        Parts { masks: (0..2 * rows).map(part).collect() }
    }

    /// The pattern of the parts that are mostly ink, and how many pixels it gets wrong.
    fn nearest(&self, pixels: Mask) -> (usize, u32) {
        let mut nearest = (0, 0);
        for (bit, part) in self.masks.iter().enumerate() {
            let (inked, all) = ((pixels & part).count_ones(), part.count_ones());
            let on = 2 * inked > all;
            nearest.0 |= usize::from(on) << bit;
            nearest.1 += if on { all - inked } else { inked };
        }
        nearest
    }
}

/// What the choice of a character needs.
struct Tables {
    quarters: Parts,
    sextants: Parts,
    octants: Parts,
    eighths: Vec<(char, Mask)>,
    wedges: Vec<(char, Mask)>,
    /// The characters of octants by their pattern.
    octant_characters: Vec<char>,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let lower = (1..).zip(LOWER).map(|(n, ch)| (ch, mask(|_, y| y >= SIZE.1 - 2 * n)));
    let left = (1..).zip(LEFT).map(|(n, ch)| (ch, mask(|x, _| x < n)));
    let wedges =
        (0x1FB3C..).zip(WEDGES).filter_map(|(code, wedge)| Some((char::from_u32(code)?, wedge_mask(wedge))));
    let mut code = 0x1CD00..;
    let octant = |pattern: u8| match OTHER_OCTANTS.iter().find(|(other, _)| *other == pattern) {
        Some(&(_, ch)) => ch,
        None => code.next().and_then(char::from_u32).unwrap_or(' '),
    };
    Tables {
        quarters: Parts::new(2),
        sextants: Parts::new(3),
        octants: Parts::new(4),
        eighths: lower.chain(left).collect(),
        wedges: wedges.collect(),
        octant_characters: (0..=u8::MAX).map(octant).collect(),
    }
});

fn wedge_mask((from, to, right): Wedge) -> Mask {
    let point = |(x, y): (u8, u8)| (f64::from(x) / 2.0, f64::from(y) / 3.0);
    let ((x1, y1), (x2, y2)) = (point(from), point(to));
    let side = |x: f64, y: f64| (x2 - x1) * (y - y1) - (y2 - y1) * (x - x1);
    let corner = side(f64::from(u8::from(right)), 1.0);
    // Coordinates of pixels' middles.
    mask(|x, y| side((x as f64 + 0.5) / 8.0, (y as f64 + 0.5) / 16.0) * corner > 0.0)
}

/// The character of a pattern of sextants, bit 0 upper left, bit 1 upper right, downwards.
fn sextant(pattern: usize) -> char {
    match pattern {
        0 => ' ',
        21 => '▌',
        42 => '▐',
        63 => '█',
        // Those three are left out of the row of the others.
        _ => {
            let skipped = 1 + u32::from(pattern > 21) + u32::from(pattern > 42);
            u32::try_from(pattern)
                .ok()
                .and_then(|code| char::from_u32(0x1FB00 + code - skipped))
                .unwrap_or(' ')
        }
    }
}

/// The character that comes nearest to the pixels of an area. The second value tells that ink and paper change places.
pub(super) fn area(glyphs: Glyphs, pixels: Mask) -> (char, bool) {
    let tables = &*TABLES;
    if glyphs == Glyphs::Ascii {
        return (' ', pixels.count_ones() > 64);
    }
    let (quarters, wrong) = tables.quarters.nearest(pixels);
    let mut best = (QUARTERS.get(quarters).copied().unwrap_or(' '), false, wrong);
    let mut consider = |ch: char, inverse: bool, wrong: u32| {
        // Among equals the plainer one stays.
        if wrong < best.2 {
            best = (ch, inverse, wrong);
        }
    };
    let compare = |list: &[(char, Mask)], consider: &mut dyn FnMut(char, bool, u32)| {
        for &(ch, mask) in list {
            let wrong = (mask ^ pixels).count_ones();
            consider(ch, false, wrong);
            consider(ch, true, 128 - wrong);
        }
    };
    compare(&tables.eighths, &mut consider);
    if matches!(glyphs, Glyphs::Unicode13 | Glyphs::Unicode16) {
        let (pattern, wrong) = tables.sextants.nearest(pixels);
        consider(sextant(pattern), false, wrong);
        compare(&tables.wedges, &mut consider);
    }
    if glyphs == Glyphs::Unicode16 {
        let (pattern, wrong) = tables.octants.nearest(pixels);
        consider(tables.octant_characters.get(pattern).copied().unwrap_or(' '), false, wrong);
    }
    (best.0, best.1)
}

/// The arms of a cell's straight lines: bit 0 left, 1 right, 2 up, 3 down.
pub(super) type Arms = u8;

/// The lines from the middle of a cell to its sides.
const BOXES: [char; 16] = [' ', '╴', '╶', '─', '╵', '┘', '└', '┴', '╷', '┐', '┌', '┬', '│', '┤', '├', '┼'];
const ASCII_BOXES: [char; 16] =
    [' ', '-', '-', '-', '|', '+', '+', '+', '|', '+', '+', '+', '|', '+', '+', '+'];

/// The character of straight lines.
pub(super) fn straight(glyphs: Glyphs, arms: Arms) -> char {
    let boxes = if glyphs == Glyphs::Ascii { ASCII_BOXES } else { BOXES };
    boxes.get(usize::from(arms)).copied().unwrap_or(' ')
}

/// Which of the 2x4 parts of a cell a thin line passes: bit `2 * row + column`.
pub(super) type Dots = u8;

/// The character of a thin line.
pub(super) fn line(glyphs: Glyphs, dots: Dots) -> char {
    if glyphs == Glyphs::Ascii {
        return stroke(dots);
    }
    // Braille numbers its dots down the columns; the lowest row came later.
    const BITS: [u32; 8] = [0, 3, 1, 4, 2, 5, 6, 7];
    let pattern = (0..8).filter(|bit| dots >> bit & 1 == 1).fold(0, |pattern, bit| pattern | 1 << BITS[bit]);
    char::from_u32(0x2800 + pattern).filter(|_| pattern != 0).unwrap_or(' ')
}

/// The stroke of a typewriter that comes nearest to a line.
fn stroke(dots: Dots) -> char {
    let set = (0..8).filter(|bit| dots >> bit & 1 == 1);
    // Twice the distances from the middle of the cell, in eighths of its height.
    let places: Vec<(i32, i32)> = set.map(|bit| (4 * (bit % 2) - 2, 2 * (bit / 2) - 3)).collect();
    let count = i32::try_from(places.len()).unwrap_or(1).max(1);
    let sum = |value: fn(&(i32, i32)) -> i32| places.iter().map(value).sum::<i32>();
    let (x, y) = (sum(|p| p.0), sum(|p| p.1));
    let spread = |value: fn(&(i32, i32)) -> i32, total: i32| count * sum(value) - total * total;
    let (across, down) = (spread(|p| p.0 * p.0, x), spread(|p| p.1 * p.1, y));
    let slope = count * sum(|p| p.0 * p.1) - x * y;
    match places.len() {
        0 => ' ',
        1 if y > 0 => '.',
        1 => '\'',
        _ if 3 * across < down => '|',
        _ if 3 * down < across && y >= 3 * count => '_',
        _ if 2 * slope.abs() < across.min(down) || 3 * down < across => {
            if places.len() > 5 {
                '#'
            } else {
                '-'
            }
        }
        _ if slope > 0 => '\\',
        _ => '/',
    }
}

/// A letter as ASCII has it.
pub(super) fn ascii(ch: char) -> char {
    match base_letter(ch) {
        plain @ ' '..='~' => plain,
        '←' => '<',
        '→' => '>',
        '↑' | '↖' => '^',
        '↓' => 'v',
        '–' | '—' | '─' => '-',
        '│' => '|',
        '“' | '”' | '„' => '"',
        '·' | '…' => '.',
        '°' | '○' => 'o',
        '²' => '2',
        '±' => '+',
        '≤' => '<',
        '≥' => '>',
        'Σ' | '∑' => 'S',
        'π' => 'p',
        'λ' => 'l',
        'ω' => 'w',
        '√' => 'V',
        '×' => 'x',
        '█' | '▓' | '▒' | '■' => '#',
        _ => '?',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_of_a_set_is_found_from_its_own_pixels() {
        let tables = &*TABLES;
        for &(ch, mask) in &tables.eighths {
            let (found, inverse) = area(Glyphs::Blocks, mask);
            assert!(found == ch && !inverse, "{ch} became {found}");
        }
        for &(ch, mask) in &tables.wedges {
            let (found, _) = area(Glyphs::Unicode13, mask);
            assert_eq!(found, ch);
        }
        for pattern in 0..=255usize {
            let parts = tables.octants.masks.iter().enumerate();
            let pixels =
                parts.filter(|(bit, _)| pattern >> bit & 1 == 1).fold(0, |all, (_, part)| all | part);
            let ch = tables.octant_characters[pattern];
            let (found, inverse) = area(Glyphs::Unicode16, pixels);
            let wrong = [ch == found, LOWER.contains(&found), LEFT.contains(&found), inverse];
            assert!(wrong.contains(&true), "{pattern}: {ch} became {found}");
        }
    }

    /// The ends of the rows of characters, as Unicode's charts have them.
    #[test]
    fn characters_of_unicode() {
        let tables = &*TABLES;
        assert_eq!(tables.octant_characters[4], '\u{1CD00}');
        assert_eq!(tables.octant_characters[254], '\u{1CDE5}');
        assert_eq!((sextant(1), sextant(20), sextant(22), sextant(62)), ('🬀', '🬓', '🬔', '🬻'));
        assert_eq!(tables.wedges.last().map(|wedge| wedge.0), Some('\u{1FB51}'));
        assert_eq!(line(Glyphs::Blocks, 0xFF), '⣿');
        assert_eq!(line(Glyphs::Blocks, 0b1100_0000), '⣀');
        assert_eq!(straight(Glyphs::Blocks, 0b1010), '┌');
    }

    #[test]
    fn strokes_of_a_typewriter() {
        for (dots, ch) in [
            (0b1100_0000, '_'),
            (0b0000_1100, '-'),
            (0b0101_0101, '|'),
            (0b1010_0101, '\\'),
            (0b0101_1010, '/'),
            (0b0000_0001, '\''),
            (0, ' '),
        ] {
            assert_eq!(line(Glyphs::Ascii, dots), ch, "{dots:08b}");
        }
        assert!("Őrült görbe →".chars().map(ascii).all(|ch| ch.is_ascii()));
    }
}
