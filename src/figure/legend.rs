//! The legend below a picture: which colour is which curve.

use super::layout::printable;
use super::letters::{Letters, length};
use super::picture::{Figure, NOMINAL_WIDTH};

/// Size of the letters, height of a row, gap between columns, and the margin below the last row.
const SIZE: f64 = 15.0;
const ROW: f64 = 20.0;
const GAP: f64 = 28.0;
const END: f64 = 8.0;
/// What shows the colour before a name.
const SWATCH: &str = "──";

/// An entry: a name and its colour.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) text: String,
    pub(super) ink: [u8; 3],
}

impl Figure {
    /// Adds a line to the legend below the picture: the name of something, in its colour (red, green, blue).
    pub fn add_to_legend(&mut self, text: impl Into<String>, ink: [u8; 3]) {
        self.legend.push(Entry { text: text.into(), ink });
    }
}

/// How many columns the entries stand in, of what width.
fn columns(texts: &[String]) -> (usize, f64) {
    let widest = texts.iter().map(|text| length(text, SIZE)).fold(0.0, f64::max) + GAP;
    // The longest entry may be wider than the picture; it has a row for itself then.
    let fitting = ((0.95 * f64::from(NOMINAL_WIDTH) + GAP) / widest).floor();
    ((fitting as usize).clamp(1, texts.len().max(1)), widest)
}

fn texts(entries: &[Entry]) -> Vec<String> {
    entries.iter().map(|entry| format!("{SWATCH} {}", printable(&entry.text))).collect()
}

/// The height of the legend; 0 without entries.
pub(super) fn height(entries: &[Entry]) -> f64 {
    if entries.is_empty() {
        return 0.0;
    }
    let (columns, _) = columns(&texts(entries));
    ROW * entries.len().div_ceil(columns) as f64 + END
}

/// The entries in rows from a height on, centred.
pub(super) fn letters(entries: &[Entry], top: f64) -> Vec<Letters> {
    let texts = texts(entries);
    let (columns, width) = columns(&texts);
    let left = (f64::from(NOMINAL_WIDTH) - (columns as f64 * width - GAP)) / 2.0;
    let entry = |(index, (text, entry)): (usize, (String, &Entry))| {
        let at = [left + (index % columns) as f64 * width, top + ROW * (index / columns) as f64 + SIZE];
        Letters { text, at, size: SIZE, ink: entry.ink }
    };
    texts.into_iter().zip(entries).enumerate().map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(count: usize, text: &str) -> Vec<Entry> {
        (0..count).map(|index| Entry { text: format!("{text}{index}"), ink: [0, 0, 170] }).collect()
    }

    #[test]
    fn rows_lie_within_the_picture_and_over_nothing() {
        for (count, text) in [(1, "k0="), (16, "k0="), (16, "coons bias=0.5 tension="), (3, "x")] {
            let entries = entries(count, text);
            let letters = letters(&entries, 100.0);
            assert_eq!(letters.len(), count);
            for (index, line) in letters.iter().enumerate() {
                let [left, top, right, bottom] = line.area();
                assert!(left >= 0.0 && right <= f64::from(NOMINAL_WIDTH), "{line:?}");
                assert!(top >= 100.0 && bottom <= 100.0 + height(&entries), "{line:?}");
                for other in &letters[..index] {
                    let area = other.area();
                    assert!(area[2] < left || area[3] < top + 2.0, "{line:?} {other:?}");
                }
            }
        }
        assert_eq!(height(&[]), 0.0);
        assert_eq!(super::letters(&entries(1, &"w".repeat(200)), 0.0).len(), 1);
    }
}
