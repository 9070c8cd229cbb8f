//! The cells of a table, as a delimiter separates them.

use super::super::FileError;
use super::Delimiter;
use super::text::Lines;
use csv::{ReaderBuilder, StringRecord, Terminator};
use std::ops::Range;

/// The cells of a table in one text, row by row; rows without anything in them are left out.
#[derive(Debug)]
pub(in crate::file) struct Grid {
    text: String,
    /// Where cells end in the text.
    ends: Vec<usize>,
    rows: Vec<Row>,
}

#[derive(Debug)]
struct Row {
    /// The number of its line in the file.
    line: usize,
    /// The number of cells before the end of the row.
    end: usize,
}

impl Grid {
    /// Separates the cells of all lines.
    ///
    /// # Errors
    /// [`FileError::Text`] for what the reader of CSV does not take.
    pub(in crate::file) fn read(lines: &Lines<'_>, delimiter: Delimiter) -> Result<Grid, FileError> {
        let blanks = delimiter == Delimiter::Blanks;
        let spaced = (blanks && lines.text.contains('\t')).then(|| lines.text.replace('\t', " "));
        let text = spaced.as_deref().unwrap_or(&lines.text);
        let mut reader = ReaderBuilder::new()
            // All of them are ASCII.
            .delimiter(delimiter.sign() as u8)
            .has_headers(false)
            .flexible(true)
            .terminator(Terminator::Any(b'\n'))
            .from_reader(text.as_bytes());
        let mut grid = Grid { text: String::with_capacity(text.len()), ends: Vec::new(), rows: Vec::new() };
        let mut record = StringRecord::new();
        loop {
            let at = usize::try_from(reader.position().line()).unwrap_or(1).saturating_sub(1);
            let line = lines.numbers.get(at).copied().unwrap_or(1);
            let more = reader.read_record(&mut record).map_err(|error| FileError::Text {
                line,
                place: String::new(),
                problem: error.to_string(),
            })?;
            if !more {
                return Ok(grid);
            }
            // Blanks in a row are one.
            grid.add(line, record.iter().map(cleaned).filter(|cell| !blanks || !cell.is_empty()));
        }
    }

    fn add<'c>(&mut self, line: usize, cells: impl Iterator<Item = &'c str>) {
        let before = self.ends.len();
        let mut filled = before;
        for cell in cells {
            self.text.push_str(cell);
            self.ends.push(self.text.len());
            filled = if cell.is_empty() { filled } else { self.ends.len() };
        }
        // A delimiter at the end of a line begins no cell.
        self.ends.truncate(filled);
        if filled > before {
            self.rows.push(Row { line, end: filled });
        }
    }

    /// The number of rows.
    pub(in crate::file) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The number of a row's line in the file.
    pub(in crate::file) fn line(&self, row: usize) -> usize {
        self.rows.get(row).map_or(1, |row| row.line)
    }

    fn range(&self, row: usize) -> Range<usize> {
        let end = |row: usize| self.rows.get(row).map_or(0, |row| row.end);
        row.checked_sub(1).map_or(0, end)..end(row)
    }

    /// How many cells a row has.
    pub(in crate::file) fn width(&self, row: usize) -> usize {
        self.range(row).len()
    }

    /// The cell in a column of a row; empty if there is none.
    pub(in crate::file) fn cell(&self, row: usize, column: usize) -> &str {
        let range = self.range(row);
        if column >= range.len() {
            return "";
        }
        let index = range.start + column;
        let start = index.checked_sub(1).and_then(|before| self.ends.get(before)).copied().unwrap_or(0);
        self.ends.get(index).and_then(|&end| self.text.get(start..end)).unwrap_or("")
    }

    /// The cells of a row.
    pub(in crate::file) fn cells(&self, row: usize) -> impl Iterator<Item = &str> {
        (0..self.width(row)).map(move |column| self.cell(row, column))
    }
}

/// A cell without blanks, and without quotes that the blanks kept from being taken off.
fn cleaned(cell: &str) -> &str {
    let cell = cell.trim();
    let inner = cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"'));
    inner.map_or(cell, str::trim)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(text: &str, delimiter: Delimiter) -> Vec<(usize, Vec<String>)> {
        let grid = Grid::read(&Lines::read(text).unwrap(), delimiter).unwrap();
        (0..grid.len()).map(|row| (grid.line(row), grid.cells(row).map(str::to_owned).collect())).collect()
    }

    #[test]
    fn cells_with_their_lines() {
        let row = |line: usize, cells: &[&str]| (line, cells.iter().map(|cell| (*cell).to_owned()).collect());
        assert_eq!(
            grid("a, \"b\" \n\n,,\n# c\n\"1,5\",2,,\n\"two\nlines\",3\n4", Delimiter::Comma),
            [row(1, &["a", "b"]), row(5, &["1,5", "2"]), row(6, &["two\nlines", "3"]), row(8, &["4"])]
        );
        assert_eq!(grid("  1 \t 2   3  ", Delimiter::Blanks), [row(1, &["1", "2", "3"])]);
        assert_eq!(grid("1\t\t2", Delimiter::Tab), [row(1, &["1", "", "2"])]);
    }
}
