//! The colours of a terminal, and the control sequences that turn one picture of cells into another one.

use super::{Cell, Place};
use crate::screen::{Color, Palette};
use std::fmt::Write;

/// How many colours a terminal has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Red, green and blue of 8 bits each: the colours of the VGA as they are.
    Full,
    /// The 256 colours of xterm: the nearest of its cube.
    Cube,
    /// The terminal's own 16 colours.
    Sixteen,
    /// None: letters and lines only.
    Plain,
}

/// The number of the nearest level of xterm's cube.
fn nearest_level(level: u8) -> u32 {
    const LEVELS: [u8; 6] = [0, 95, 135, 175, 215, 255];
    (0..).zip(LEVELS).min_by_key(|(_, known)| known.abs_diff(level)).map_or(0, |(number, _)| number)
}

impl Depth {
    /// What the environment says of a terminal: the values of `COLORTERM` and `TERM`, and whether `NO_COLOR` asks for
    /// none.
    pub fn of(colorterm: &str, term: &str, no_color: bool) -> Depth {
        if no_color || term == "dumb" || term.ends_with("-mono") || term.starts_with("vt1") {
            Depth::Plain
        } else if matches!(colorterm, "truecolor" | "24bit") || term.ends_with("-direct") {
            Depth::Full
        } else if term.contains("256") {
            Depth::Cube
        } else {
            Depth::Sixteen
        }
    }

    /// Appends the parameters of the control sequence that selects a colour; `base` is 30 for the ink and 40 for the
    /// paper.
    fn select(self, palette: Palette, base: u32, index: u8, out: &mut String) {
        let color = Color::from_index(index);
        let [red, green, blue] = palette.rgb(color);
        // Writing to a string cannot fail.
        let _ = match self {
            Depth::Full => write!(out, "{};2;{red};{green};{blue}", base + 8),
            Depth::Cube => {
                let [red, green, blue] = [red, green, blue].map(nearest_level);
                write!(out, "{};5;{}", base + 8, 16 + 36 * red + 6 * green + blue)
            }
            Depth::Sixteen => {
                // Terminals count red as 1 and blue as 4, the VGA the other way round.
                let number = u32::from(index);
                let ansi = number & 2 | (number & 1) << 2 | (number >> 2 & 1);
                write!(out, "{}", base + ansi + if number & 8 == 0 { 0 } else { 60 })
            }
            Depth::Plain => Ok(()),
        };
    }
}

/// The control sequences that turn one picture of cells into another one; `before` is `None` when nothing is known of
/// what the terminal shows.
pub(in super::super) fn difference(
    before: Option<&[Cell]>,
    after: &[Cell],
    place: Place,
    (depth, palette): (Depth, Palette),
) -> String {
    let mut out = String::new();
    let mut cursor = None;
    let [mut ink, mut paper] = [None; 2];
    for (at, cell) in after.iter().enumerate() {
        if before.and_then(|cells| cells.get(at)) == Some(cell) {
            continue;
        }
        let (row, column) = (at / place.width.max(1), at % place.width.max(1));
        if cursor != Some(at) || column == 0 {
            let (row, column) = (row + usize::from(place.row) + 1, column + usize::from(place.column) + 1);
            // Writing to a string cannot fail.
            let _ = write!(out, "\x1b[{row};{column}H");
        }
        if depth != Depth::Plain {
            // The ink of a blank is not seen.
            let wanted = (cell.ch != ' ').then_some(cell.ink).or(ink);
            let changed = [(30, wanted, &mut ink), (40, Some(cell.paper), &mut paper)];
            let mut begun = false;
            for (base, wanted, current) in changed {
                if let Some(index) = wanted.filter(|_| wanted != *current) {
                    out.push_str(if begun { ";" } else { "\x1b[" });
                    begun = true;
                    depth.select(palette, base, index, &mut out);
                    *current = wanted;
                }
            }
            if begun {
                out.push('m');
            }
        }
        out.push(cell.ch);
        cursor = Some(at + 1);
    }
    if !out.is_empty() && depth != Depth::Plain {
        out.push_str("\x1b[0m");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::super::place::Extent;
    use super::super::{Blocks, Glyphs};
    use super::*;
    use crate::screen::Screen;

    #[test]
    fn only_what_changed_is_written() {
        let mut screen = Screen::new();
        let place = Place::of_blocks(Extent { columns: 80, rows: 30, cell: None }).unwrap();
        let blocks = Blocks::new(80, 30, Glyphs::Blocks).unwrap();
        let before = blocks.picture(&screen, None).cells;
        screen.text(8, 16, "ab", Color::Yellow);
        let after = blocks.picture(&screen, None).cells;
        let written = |depth| difference(Some(&before), &after, place, (depth, Palette::Vga));
        assert_eq!(written(Depth::Sixteen), "\x1b[2;2H\x1b[93;40mab\x1b[0m");
        assert_eq!(written(Depth::Plain), "\x1b[2;2Hab");
        assert_eq!(difference(Some(&after), &after, place, (Depth::Full, Palette::Vga)), "");
        assert!(difference(None, &after, place, (Depth::Cube, Palette::Vga)).contains("\x1b[38;5;227mab"));
    }

    #[test]
    fn colors_by_what_the_terminal_has() {
        assert_eq!(Depth::of("truecolor", "xterm", false), Depth::Full);
        assert_eq!(Depth::of("", "xterm-256color", false), Depth::Cube);
        assert_eq!(Depth::of("", "linux", false), Depth::Sixteen);
        assert_eq!(Depth::of("truecolor", "xterm-256color", true), Depth::Plain);
        assert_eq!(Depth::of("", "dumb", false), Depth::Plain);
        let selected = |depth: Depth, base, color: Color| {
            let mut out = String::new();
            depth.select(Palette::Vga, base, color.index(), &mut out);
            out
        };
        assert_eq!(selected(Depth::Sixteen, 30, Color::Blue), "34");
        assert_eq!(selected(Depth::Sixteen, 40, Color::LightRed), "101");
        assert_eq!(selected(Depth::Full, 40, Color::Brown), "48;2;170;85;0");
    }
}
