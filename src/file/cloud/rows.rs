//! Tables of points in pieces: XYZ and CSV. Their beginning tells how they are laid out.

use super::super::FileError;
use super::super::table::{self, Decimal, Delimiter, TableOptions};
use super::Encoding;
use super::gathered::{Gathered, Spot};
use super::layout::Layout;
use super::lines::{Lines, no_number, number, trimmed, wrong};

/// The layout is taken from so many bytes, or more if no row is among them.
const HEAD: usize = 1 << 16;
/// More than stands above the rows of any table.
const LONGEST_HEAD: usize = 1 << 20;

/// A table, while it is read.
#[derive(Debug)]
pub(super) struct Rows {
    options: TableOptions,
    /// The beginning, until the layout is known.
    head: Vec<u8>,
    lines: Lines,
    layout: Option<Layout>,
}

impl Rows {
    pub(super) fn new(options: TableOptions) -> Rows {
        Rows { options, head: Vec::new(), lines: Lines::default(), layout: None }
    }

    /// What kind of table it is, as soon as that is known.
    pub(super) fn encoding(&self) -> Option<Encoding> {
        self.layout.as_ref().map(|layout| match layout.delimiter {
            Delimiter::Blanks | Delimiter::Tab => Encoding::Xyz,
            Delimiter::Comma | Delimiter::Semicolon => Encoding::Csv,
        })
    }

    /// Reads the rows that end in a piece.
    ///
    /// # Errors
    /// [`FileError::Text`] with the line.
    pub(super) fn feed(&mut self, gathered: &mut Gathered, piece: &[u8]) -> Result<(), FileError> {
        if self.layout.is_some() {
            return self.rows(gathered, piece);
        }
        // Pieces of any size give the same layout.
        let mut rest = piece;
        while self.layout.is_none() && !rest.is_empty() {
            let wanted = (self.head.len() / HEAD + 1) * HEAD - self.head.len();
            let (part, after) = rest.split_at(rest.len().min(wanted));
            self.head.extend_from_slice(part);
            rest = after;
            if !self.head.len().is_multiple_of(HEAD) {
                return Ok(());
            }
            self.begin(gathered, false)?;
        }
        self.rows(gathered, rest)
    }

    /// Finds the layout and reads what has come, if there is a row.
    fn begin(&mut self, gathered: &mut Gathered, whole: bool) -> Result<(), FileError> {
        let is_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let end = match self.head.iter().rposition(is_end) {
            _ if whole => self.head.len(),
            at => at.map_or(0, |at| at + 1),
        };
        self.layout = Layout::of(self.head.get(..end).unwrap_or_default(), &self.options)?;
        if self.layout.is_some() {
            let head = std::mem::take(&mut self.head);
            return self.rows(gathered, &head);
        }
        if self.head.len() < LONGEST_HEAD && !whole {
            return Ok(());
        }
        let problem = "there is no table of points: rows of two or three numbers with blanks, tabs, commas or \
                       semicolons between them, perhaps below a row of names as in x,y,z";
        Err(wrong(1, String::new(), problem.to_owned()))
    }

    fn rows(&mut self, gathered: &mut Gathered, piece: &[u8]) -> Result<(), FileError> {
        let Self { options, lines, layout, .. } = self;
        let Some(layout) = layout else { return Ok(()) };
        lines.feed(piece, |number, line| row(gathered, layout, options, number, line))
    }

    /// The end of the file.
    ///
    /// # Errors
    /// Those of [`Rows::feed`].
    pub(super) fn finish(&mut self, gathered: &mut Gathered) -> Result<(), FileError> {
        if self.layout.is_none() {
            self.begin(gathered, true)?;
        }
        let Self { options, lines, layout, .. } = self;
        let Some(layout) = layout else { return Ok(()) };
        lines.finish(|number, line| row(gathered, layout, options, number, line))
    }
}

/// Reads a row.
fn row(
    gathered: &mut Gathered,
    layout: &Layout,
    options: &TableOptions,
    line: usize,
    text: &[u8],
) -> Result<(), FileError> {
    let text = trimmed(text);
    if line < layout.first || matches!(text, [] | [b'#' | b'%', ..] | [b'/', b'/', ..]) {
        return Ok(());
    }
    let mut cells: [&[u8]; 3] = [b""; 3];
    let last = layout.columns.iter().copied().max().unwrap_or_default();
    for (at, cell) in Cells::new(text, layout.delimiter).enumerate().take(last + 1) {
        for (place, &column) in cells.iter_mut().zip(&layout.columns) {
            if column == at {
                *place = cell;
            }
        }
    }
    let mut point = [0.0; 3];
    for ((value, cell), &column) in point.iter_mut().zip(cells).zip(&layout.columns) {
        if cell.is_empty() {
            gathered.short(line);
            return Ok(());
        }
        *value = self::value(cell, layout.decimal, options.decimal)
            .map_err(|problem| wrong(line, layout.place_of(column), problem))?;
    }
    gathered.push(point, Spot::Line(line))
}

/// The number in a cell.
fn value(cell: &[u8], decimal: Decimal, said: Option<Decimal>) -> Result<f64, String> {
    let is_sign = |byte: &u8| matches!(byte, b'.' | b',');
    if (decimal == Decimal::Point || !cell.iter().any(is_sign))
        && let Some(value) = number(cell)
    {
        return Ok(value);
    }
    if let Some(value) = with_comma(cell).filter(|_| decimal == Decimal::Comma) {
        return Ok(value);
    }
    let text = std::str::from_utf8(cell).map_err(|_| no_number(cell))?;
    let text = text.trim_matches(['"', ' ']);
    match number(text.as_bytes()).filter(|value| !value.is_finite()) {
        Some(value) => Ok(value),
        None => table::value(text, decimal, said).map_err(|problem| match table::Number::read(text) {
            Some(_) => problem,
            None => no_number(cell),
        }),
    }
}

/// The number in a cell with one comma between digits and no point, as almost all are where the comma is the decimal
/// sign.
fn with_comma(cell: &[u8]) -> Option<f64> {
    let mut room = [0; 32];
    let text = room.get_mut(..cell.len())?;
    text.copy_from_slice(cell);
    let at = cell.iter().position(|&byte| byte == b',')?;
    let [before, comma, after] = text.get_mut(at.checked_sub(1)?..at + 2)? else { return None };
    if !before.is_ascii_digit() || !after.is_ascii_digit() {
        return None;
    }
    *comma = b'.';
    // Another comma or a point makes it no number.
    std::str::from_utf8(text).ok()?.parse().ok()
}

/// The cells of a row.
struct Cells<'l> {
    rest: Option<&'l [u8]>,
    delimiter: Delimiter,
}

impl<'l> Cells<'l> {
    fn new(line: &'l [u8], delimiter: Delimiter) -> Self {
        Self { rest: Some(line), delimiter }
    }
}

impl<'l> Iterator for Cells<'l> {
    type Item = &'l [u8];

    fn next(&mut self) -> Option<&'l [u8]> {
        let rest = trimmed_start(self.rest?, self.delimiter);
        // What stands between quotes is one cell.
        let quoted = match rest {
            [b'"', inner @ ..] => inner.iter().position(|&byte| byte == b'"').map_or(0, |at| at + 2),
            _ => 0,
        };
        let is_end = |byte: &u8| match self.delimiter {
            Delimiter::Blanks => matches!(byte, b' ' | b'\t'),
            delimiter => *byte == delimiter.sign() as u8,
        };
        let length = rest.iter().skip(quoted).position(is_end).map_or(rest.len(), |at| quoted + at);
        let (cell, after) = rest.split_at(length);
        self.rest = after.get(1..);
        Some(trimmed(cell))
    }
}

/// A row without blanks at its beginning, but with tabs that separate.
fn trimmed_start(mut line: &[u8], delimiter: Delimiter) -> &[u8] {
    while let [b' ' | b'\t', rest @ ..] = line
        && (delimiter != Delimiter::Tab || line.first() == Some(&b' '))
    {
        line = rest;
    }
    line
}
