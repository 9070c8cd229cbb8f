//! What a terminal can do, by its own answers.

use super::place::Extent;
use crate::machine::Glyphs;

/// Asks for everything at once; the last question is one that every terminal answers.
/// Kitty's graphics, Kitty's keyboard, mouse in pixels, size of the text and of a cell, name and version, device
/// attributes.
pub(super) const QUESTIONS: &[u8] =
    b"\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[?u\x1b[?1016$p\x1b[14t\x1b[16t\x1b[>q\x1b[c";

/// What a terminal answered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Answers {
    pub(super) kitty: bool,
    pub(super) sixel: bool,
    /// Keys are told without ambiguity on demand.
    pub(super) clear_keys: bool,
    /// The mouse is told in pixels on demand.
    pub(super) pixel_mouse: bool,
    /// Height and width of the text in pixels.
    text: Option<(u16, u16)>,
    /// Height and width of a cell in pixels.
    cell: Option<(u16, u16)>,
    /// It draws sextants and wedges itself, whatever its font has.
    draws_sextants: bool,
    /// The last answer has come.
    pub(super) complete: bool,
}

/// The names of terminals that draw the characters of Unicode 13 themselves, as they tell them.
const DRAW_SEXTANTS: [&str; 7] = ["kitty", "foot", "WezTerm", "ghostty", "contour", "VTE", "Konsole"];

impl Answers {
    /// Reads whatever a terminal has sent; what is no answer (keys that were typed meanwhile) is skipped.
    pub(super) fn read(bytes: &[u8]) -> Answers {
        let text = String::from_utf8_lossy(bytes);
        let mut answers = Answers::default();
        for sequence in text.split('\x1b').skip(1) {
            if let Some(graphics) = sequence.strip_prefix("_G") {
                answers.kitty |= graphics.starts_with("i=31") && graphics.ends_with(";OK");
            } else if let Some(name) = sequence.strip_prefix("P>|") {
                answers.draws_sextants = DRAW_SEXTANTS.iter().any(|known| name.starts_with(known));
            } else if let Some(control) = sequence.strip_prefix('[') {
                answers.control(control);
            }
        }
        answers
    }

    /// The same where answers come as keys that are typed, as in the console of Windows. Some versions of it lose the Esc that
    /// begins an answer, so that it is put where the answers to [`QUESTIONS`] begin and end.
    #[cfg_attr(unix, allow(dead_code, reason = "consoles of Windows answer so"))]
    pub(super) fn typed(keys: &str) -> Answers {
        if keys.contains('\x1b') {
            return Answers::read(keys.as_bytes());
        }
        let begun = ["[?", "[4;", "[6;", "P>|", "_G", "\\"]
            .iter()
            .fold(keys.to_owned(), |keys, begin| keys.replace(begin, &format!("\x1b{begin}")));
        Answers::read(begun.as_bytes())
    }

    fn control(&mut self, control: &str) {
        let Some(end) = control.find(|ch: char| ('\x40'..='\x7e').contains(&ch)) else { return };
        let (parameters, rest) = control.split_at(end);
        let private = parameters.strip_prefix('?');
        let numbers = |text: &str| -> Vec<u16> {
            text.trim_end_matches('$').split(';').map(|number| number.parse().unwrap_or(0)).collect()
        };
        match (rest.chars().next(), private) {
            (Some('c'), Some(attributes)) => {
                self.complete = true;
                // The first number is the terminal's class.
                self.sixel = numbers(attributes).iter().skip(1).any(|&attribute| attribute == 4);
            }
            (Some('u'), Some(_)) => self.clear_keys = true,
            (Some('y'), Some(mode)) => {
                self.pixel_mouse |= matches!(numbers(mode)[..], [1016, 1..=3]);
            }
            (Some('t'), None) => match numbers(parameters)[..] {
                [4, height, width] => self.text = Some((height, width)),
                [6, height, width] => self.cell = Some((height, width)),
                _ => {}
            },
            _ => {}
        }
    }

    /// The characters that can be trusted: by its own name, by `TERM`, and by the encoding of the locale, as the
    /// variables `LC_ALL`, `LC_CTYPE` and `LANG` name it.
    pub(super) fn glyphs(&self, term: &str, locale: [&str; 3]) -> Glyphs {
        let locale =
            locale.into_iter().find(|locale| !locale.is_empty()).unwrap_or_default().to_ascii_lowercase();
        let encoded = locale.contains("utf-8") || locale.contains("utf8");
        if matches!(term, "linux" | "dumb") || term.starts_with("vt1") || !encoded && !cfg!(windows) {
            Glyphs::Ascii
        } else if self.draws_sextants {
            Glyphs::Unicode13
        } else {
            Glyphs::Blocks
        }
    }

    /// The size of a terminal of so many columns and rows; `pixels` is its size as the system knows it.
    pub(super) fn extent(&self, columns: u16, rows: u16, pixels: (u16, u16)) -> Extent {
        let divided = |(width, height): (u16, u16)| {
            let cell = (width.checked_div(columns)?, height.checked_div(rows)?);
            (cell.0 > 1 && cell.1 > 1).then_some(cell)
        };
        let told = self.cell.map(|(height, width)| (width, height)).filter(|cell| cell.0 > 1 && cell.1 > 1);
        Extent { columns, rows, cell: divided(pixels).or(told) }
    }

    /// The same with the cell's size found from the size of the text at the start, for a terminal that
    /// tells only that.
    pub(super) fn with_text_of(mut self, columns: u16, rows: u16) -> Answers {
        if let (None, Some((height, width))) = (self.cell, self.text) {
            self.cell = height.checked_div(rows).zip(width.checked_div(columns));
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_of_known_terminals() {
        let kitty = b"\x1b_Gi=31;OK\x1b\\\x1b[?0u\x1b[?1016;2$y\x1b[4;600;1000t\x1b[6;20;10t\x1b[?62;c";
        let answers = Answers::read(kitty);
        assert!(answers.kitty && !answers.sixel && answers.clear_keys && answers.pixel_mouse);
        assert!(answers.complete);
        assert_eq!(answers.extent(100, 30, (0, 0)).cell, Some((10, 20)));
        let foot = Answers::read(b"\x1b[?1016;0$y\x1b[4;480;800t\x1b[?62;4;22c").with_text_of(80, 24);
        assert!(foot.sixel && !foot.kitty && !foot.pixel_mouse);
        assert_eq!(foot.extent(100, 30, (0, 0)).cell, Some((10, 20)));
        assert_eq!(foot.extent(100, 30, (900, 540)).cell, Some((9, 18)));
    }

    #[test]
    fn answers_that_are_typed_are_the_same() {
        for terminal in [
            "\x1b[6;20;10t\x1b[?61;4;6;7;14;21;22;23;24;28;32;42c",
            "\x1b_Gi=31;OK\x1b\\\x1b[?1016;2$y\x1b[4;600;1000t\x1bP>|WezTerm 2025\x1b\\\x1b[?65;4c",
            "x\x1b[?1;0c",
            "abc",
        ] {
            let answers = Answers::read(terminal.as_bytes());
            assert_eq!(Answers::typed(terminal), answers);
            assert_eq!(Answers::typed(&terminal.replace('\x1b', "")), answers);
        }
    }

    #[test]
    fn characters_by_name_and_locale() {
        let foot = Answers::read(b"\x1bP>|foot(1.16.2)\x1b\\\x1b[?62;c");
        let other = Answers::read(b"\x1bP>|XTerm(379)\x1b\\\x1b[?62;c");
        let utf8 = ["", "", "hu_HU.UTF-8"];
        assert_eq!(foot.glyphs("foot", utf8), Glyphs::Unicode13);
        assert_eq!(other.glyphs("xterm-256color", utf8), Glyphs::Blocks);
        assert_eq!(other.glyphs("linux", utf8), Glyphs::Ascii);
        #[cfg(not(windows))]
        for locale in [["", "", ""], ["C", "", "hu_HU.UTF-8"], ["", "POSIX", "en_US.UTF-8"]] {
            assert_eq!(foot.glyphs("foot", locale), Glyphs::Ascii);
        }
        assert_eq!(other.glyphs("xterm", ["", "C.UTF-8", "C"]), Glyphs::Blocks);
    }

    #[test]
    fn nonsense_is_no_answer() {
        for bytes in [
            &b""[..],
            b"abc\r",
            b"\x1b",
            b"\x1b[",
            b"\x1b[?",
            b"\x1b[4;;t\x1b[6;1t",
            b"\x1b_Gi=31;ENOTSUP\x1b\\",
        ] {
            let answers = Answers::read(bytes);
            assert!(!answers.kitty && !answers.complete);
            assert_eq!(answers.with_text_of(0, 0).extent(0, 0, (0, 0)).cell, None);
        }
    }
}
