//! PLY in pieces: the points of its element `vertex`. What stands behind them is not looked at.

use super::super::FileError;
use super::Encoding;
use super::gathered::{Gathered, Spot};
use super::lines::{Lines, no_number, number, words, wrong};
use super::ply_binary::Binary;
use super::ply_header::{Element, Header, Property};

/// So many bytes are taken at a time until the header is complete.
const STEP: usize = 4096;

/// A file, while it is read.
#[derive(Debug)]
pub(super) enum Ply {
    /// The bytes of the header so far.
    Header(Vec<u8>),
    /// The data as text.
    Text(Text),
    /// The data as bytes.
    Binary(Binary),
}

impl Default for Ply {
    fn default() -> Self {
        Self::Header(Vec::new())
    }
}

impl Ply {
    /// How the data is written, as soon as it is known.
    pub(super) fn encoding(&self) -> Encoding {
        match self {
            Self::Header(_) | Self::Text(_) => Encoding::PlyText,
            Self::Binary(binary) if binary.is_big_endian() => Encoding::PlyBigEndian,
            Self::Binary(_) => Encoding::PlyLittleEndian,
        }
    }

    /// Whether all points have been read.
    pub(super) fn is_done(&self) -> bool {
        match self {
            Self::Header(_) => false,
            Self::Text(text) => text.is_done(),
            Self::Binary(binary) => binary.is_done(),
        }
    }

    /// Reads a piece.
    ///
    /// # Errors
    /// [`FileError`] with the line or the byte.
    pub(super) fn feed(&mut self, gathered: &mut Gathered, piece: &[u8]) -> Result<(), FileError> {
        match self {
            Self::Header(head) => {
                // A header is short; it is looked at again whenever more has come.
                let mut rest = piece;
                while !rest.is_empty() {
                    let (part, after) = rest.split_at(rest.len().min(STEP));
                    head.extend_from_slice(part);
                    rest = after;
                    let Some(header) = Header::read(head)? else { continue };
                    gathered.announce(header.vertex.count)?;
                    let data = head.split_off(header.bytes);
                    *self = match header.encoding {
                        Encoding::PlyText => Self::Text(Text::new(header)),
                        encoding => Self::Binary(Binary::new(header, encoding == Encoding::PlyBigEndian)),
                    };
                    self.feed(gathered, &data)?;
                    return self.feed(gathered, rest);
                }
                Ok(())
            }
            Self::Text(text) => text.feed(gathered, piece),
            Self::Binary(binary) => binary.feed(gathered, piece),
        }
    }

    /// The end of the file.
    ///
    /// # Errors
    /// [`FileError`] when it comes before that of the points.
    pub(super) fn finish(&mut self, gathered: &mut Gathered) -> Result<(), FileError> {
        match self {
            Self::Header(_) => Err(wrong(
                1,
                String::new(),
                "the file ends within its header, before \"end_header\"".to_owned(),
            )),
            Self::Text(text) => text.finish(gathered),
            Self::Binary(binary) => binary.finish(),
        }
    }
}

/// Why a file is refused that ends before its points do.
pub(super) fn ended(read: u64, count: u64) -> String {
    format!("the file ends here; {read} of {count} points were read")
}

/// Data as text: a line for every element.
#[derive(Debug)]
pub(super) struct Text {
    lines: Lines,
    rows: Rows,
}

#[derive(Debug)]
struct Rows {
    /// How many lines stand before the points.
    before: u64,
    vertex: Element,
    axes: [usize; 3],
    read: u64,
}

impl Text {
    fn new(header: Header) -> Text {
        let Header { before, vertex, axes, lines, .. } = header;
        let before = before.iter().fold(0, |sum: u64, element| sum.saturating_add(element.count));
        Text { lines: Lines::after(lines), rows: Rows { before, vertex, axes, read: 0 } }
    }

    fn is_done(&self) -> bool {
        self.rows.is_done()
    }

    fn feed(&mut self, gathered: &mut Gathered, piece: &[u8]) -> Result<(), FileError> {
        let Self { lines, rows } = self;
        lines.feed(piece, |number, line| rows.line(gathered, number, line))
    }

    fn finish(&mut self, gathered: &mut Gathered) -> Result<(), FileError> {
        let Self { lines, rows } = self;
        lines.finish(|number, line| rows.line(gathered, number, line))?;
        match rows.is_done() {
            true => Ok(()),
            false => Err(wrong(lines.current(), String::new(), ended(rows.read, rows.vertex.count))),
        }
    }
}

impl Rows {
    fn is_done(&self) -> bool {
        self.read >= self.vertex.count
    }

    fn line(&mut self, gathered: &mut Gathered, number: usize, line: &[u8]) -> Result<(), FileError> {
        if self.is_done() {
            return Ok(());
        }
        let mut words = words(line).peekable();
        if words.peek().is_none() {
            return Ok(());
        }
        if self.before > 0 {
            self.before -= 1;
            return Ok(());
        }
        self.read += 1;
        match self.point(words, number)? {
            Some(point) => gathered.push(point, Spot::Line(number)),
            None => {
                gathered.short(number);
                Ok(())
            }
        }
    }

    /// The point of a line; `None` if it is too short.
    fn point<'l>(
        &self,
        words: impl Iterator<Item = &'l [u8]>,
        line: usize,
    ) -> Result<Option<[f64; 3]>, FileError> {
        let mut words = (1..).zip(words);
        let read = |(at, word): (usize, &[u8])| {
            number(word).ok_or_else(|| wrong(line, format!("word {at}"), no_number(word)))
        };
        let mut point = [0.0; 3];
        let last = self.axes.into_iter().max().unwrap_or_default();
        for (index, property) in self.vertex.properties.iter().enumerate().take(last + 1) {
            let Some(first) = words.next() else { return Ok(None) };
            if let Some(axis) = self.axes.iter().position(|&axis| axis == index) {
                if let Some(value) = point.get_mut(axis) {
                    *value = read(first)?;
                }
            } else if let Property::List(..) = property {
                let length = read(first)?;
                if length.fract() != 0.0 || length < 0.0 {
                    let problem = format!("{length} is no length of a list");
                    return Err(wrong(line, format!("word {}", first.0), problem));
                }
                // A line has fewer words than a usize counts.
                if length >= 1.0 && words.nth(length as usize - 1).is_none() {
                    return Ok(None);
                }
            }
        }
        Ok(Some(point))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Cloud, CloudFormat};
    use super::*;

    fn read(text: &str) -> Result<Cloud, String> {
        Cloud::read(CloudFormat::Ply, text.as_bytes()).map_err(|error| error.to_string())
    }

    fn file(body: &str) -> String {
        format!(
            "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\nelement vertex 3\n\
             property list uchar int near\nproperty uchar red\nproperty float z\nproperty float x\nproperty float y\n\
             property float u\nelement more 7\nproperty int a\nend_header\n{body}"
        )
    }

    #[test]
    fn points_are_found_among_other_things() {
        let body =
            "3 0 1 2\n\n2 0 1\n2 8 9 255 3 1 2e0 7\r\n\n0 0 6 4 5\n1 1 1 0 nan 0 0\n1 garbage behind them\n";
        let cloud = read(&file(body)).unwrap();
        assert_eq!(cloud.points, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        assert_eq!(cloud.encoding, Some(Encoding::PlyText));
        assert_eq!(cloud.skipped.told(), ["1 point with NaN, infinite or huge coordinates, in line 21"]);
        let cloud = read(&file("0\n0\n0 0 1 2\n0 0 1 2 3\n9 0 1 2 3\n")).unwrap();
        assert_eq!(cloud.points, [[2.0, 3.0, 1.0]]);
        assert_eq!(cloud.skipped.told(), ["2 lines with too few coordinates, the first in line 17"]);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (body, message) in [
            ("0\n0\n0 0 1 2 3\n0 0 1 2 x\n", "line 18, word 5: \"x\" is not a number"),
            ("0\n0\n0 0 1 2 3\n-1 0 1 2 3\n", "line 18, word 1: -1 is no length of a list"),
            ("0\n0\n0.5 0 1 2 3\n", "line 17, word 1: 0.5 is no length of a list"),
            ("0\n0\n0 0 1 2 3\n0 0 1 2 3\n", "line 19: the file ends here; 2 of 3 points were read"),
            ("0\n", "line 16: the file ends here; 0 of 3 points were read"),
        ] {
            assert_eq!(read(&file(body)).unwrap_err(), message, "{body}");
        }
        let header = file("");
        let cut = &header[..header.len() - 3];
        assert!(read(cut).unwrap_err().contains("the file ends within its header"));
        let none = header.replace("vertex 3", "vertex 0");
        assert_eq!(read(&none).unwrap_err(), "there are no points");
        let many = header.replace("vertex 3", "vertex 10000001");
        assert_eq!(read(&many).unwrap_err(), "10000001 points are too many; at most 10000000 are read");
        assert!(read("plywood").unwrap_err().contains("begins with \"ply\""));
    }
}
