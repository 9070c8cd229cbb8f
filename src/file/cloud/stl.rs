//! The corners of the triangles in STL, text and binary; equal ones once.

use super::super::FileError;
use super::gathered::{Gathered, Spot, is_usable};
use super::lines::{no_number, point, words, wrong};
use std::hash::{BuildHasher, RandomState};

/// The header, which may hold anything, and the number of triangles.
pub(super) const HEADER: usize = 84;
/// A triangle: a normal, three corners, all of singles, and two bytes for anything.
const TRIANGLE: usize = 50;
/// What other lines of text begin with.
const KEYWORDS: [&[u8]; 6] = [b"solid", b"facet", b"outer", b"endloop", b"endfacet", b"endsolid"];

/// Whether a file that begins so is binary, even if it begins with "solid": the last byte of the number of triangles.
/// No text has such a byte, and no file so many triangles.
pub(super) fn is_binary(head: &[u8]) -> bool {
    head.get(HEADER - 1).is_some_and(|&byte| byte < 8)
}

/// Whether a file that begins so is text.
pub(super) fn is_text(head: &[u8]) -> bool {
    let word = head.split(u8::is_ascii_whitespace).find(|word| !word.is_empty());
    word.is_some_and(|word| word.eq_ignore_ascii_case(KEYWORDS[0]))
}

/// Points, each once, in the order in which they come.
#[derive(Debug, Default)]
struct Corners {
    /// One more than the index of a point, at the place of its hash or behind it; 0 where there is none. At least a
    /// quarter of the places is free.
    slots: Vec<u32>,
    hasher: RandomState,
}

impl Corners {
    /// Adds a point if it is new.
    fn push(&mut self, gathered: &mut Gathered, point: [f64; 3], spot: Spot) -> Result<(), FileError> {
        // Zero has one sign, so that it is one number.
        let point = point.map(|value| value + 0.0);
        if !is_usable(&point) {
            return gathered.push(point, spot);
        }
        if 3 * self.slots.len() <= 4 * gathered.points().len() {
            self.grow(gathered.points());
        }
        let Some(slot) = self.place(gathered.points(), &point) else { return Ok(()) };
        gathered.push(point, spot)?;
        if let Some(slot) = self.slots.get_mut(slot) {
            // There are at most ten million points.
            *slot = gathered.points().len() as u32;
        }
        Ok(())
    }

    /// The free place for a point; `None` if it is there.
    fn place(&self, points: &[[f64; 3]], point: &[f64; 3]) -> Option<usize> {
        let mask = self.slots.len().wrapping_sub(1);
        // Keyed at random: nobody can make a file whose points all have one place.
        let mut at = self.hasher.hash_one(point.map(f64::to_bits)) as usize & mask;
        loop {
            match self.slots.get(at).copied()? {
                0 => return Some(at),
                number if points.get(number as usize - 1) == Some(point) => return None,
                _ => at = (at + 1) & mask,
            }
        }
    }

    fn grow(&mut self, points: &[[f64; 3]]) {
        let size = (2 * points.len() + 1).next_power_of_two().max(1024);
        self.slots.clear();
        self.slots.resize(size, 0);
        for (number, point) in (1..).zip(points) {
            if let Some(slot) = self.place(points, point).and_then(|at| self.slots.get_mut(at)) {
                *slot = number;
            }
        }
    }
}

/// STL as text, line by line.
#[derive(Debug, Default)]
pub(super) struct StlText {
    corners: Corners,
    /// Whether a solid has begun and not ended.
    open: bool,
}

impl StlText {
    /// Reads a line: the corner of `vertex x y z`.
    ///
    /// # Errors
    /// [`FileError::Text`] for other lines than those of STL and a coordinate that is no number;
    /// [`FileError::Invalid`] for too many points.
    pub(super) fn line(
        &mut self,
        gathered: &mut Gathered,
        number: usize,
        line: &[u8],
    ) -> Result<(), FileError> {
        let mut words = words(line);
        let Some(keyword) = words.next() else { return Ok(()) };
        if keyword.eq_ignore_ascii_case(b"vertex") {
            return match point(words, number, 1)? {
                Some(point) => self.corners.push(gathered, point, Spot::Line(number)),
                None => {
                    gathered.short(number);
                    Ok(())
                }
            };
        }
        match KEYWORDS.iter().position(|known| keyword.eq_ignore_ascii_case(known)) {
            Some(at) => {
                self.open = at + 1 < KEYWORDS.len();
                Ok(())
            }
            None => {
                let found = no_number(keyword).replace("is not a number", "begins no line of STL");
                Err(wrong(number, String::new(), format!("{found}; points follow \"vertex\"")))
            }
        }
    }

    /// The end of the file, after so many lines.
    ///
    /// # Errors
    /// [`FileError::Text`] when it comes before the end of the solid.
    pub(super) fn finish(&self, gathered: &Gathered, line: usize) -> Result<(), FileError> {
        if !self.open {
            return Ok(());
        }
        let count = gathered.points().len();
        let problem = format!("the file ends before \"endsolid\"; {count} different corners were read");
        Err(wrong(line, String::new(), problem))
    }
}

/// Binary STL in pieces.
#[derive(Debug)]
pub(super) struct StlBinary {
    corners: Corners,
    /// How many triangles the file announces, and how many have been read.
    announced: u32,
    read: u32,
    /// The beginning of a triangle whose end is still to come.
    begun: Vec<u8>,
}

impl StlBinary {
    /// The triangles after this header.
    pub(super) fn new(head: &[u8; HEADER]) -> StlBinary {
        let [.., a, b, c, d] = *head;
        let announced = u32::from_le_bytes([a, b, c, d]);
        StlBinary { corners: Corners::default(), announced, read: 0, begun: Vec::new() }
    }

    /// Whether all triangles have been read.
    pub(super) fn is_done(&self) -> bool {
        self.read >= self.announced
    }

    /// Reads the triangles that end in this piece.
    ///
    /// # Errors
    /// [`FileError::Invalid`] for too many points.
    pub(super) fn feed(&mut self, gathered: &mut Gathered, piece: &[u8]) -> Result<(), FileError> {
        let mut rest = piece;
        if !self.begun.is_empty() {
            let (part, after) = rest.split_at(rest.len().min(TRIANGLE - self.begun.len()));
            self.begun.extend_from_slice(part);
            rest = after;
            if self.begun.len() < TRIANGLE {
                return Ok(());
            }
            let triangle = std::mem::take(&mut self.begun);
            self.triangle(gathered, &triangle)?;
        }
        let mut triangles = rest.chunks_exact(TRIANGLE);
        for triangle in &mut triangles {
            if self.is_done() {
                return Ok(());
            }
            self.triangle(gathered, triangle)?;
        }
        if !self.is_done() {
            self.begun = triangles.remainder().to_vec();
        }
        Ok(())
    }

    fn triangle(&mut self, gathered: &mut Gathered, triangle: &[u8]) -> Result<(), FileError> {
        // The normal stands before the corners.
        for (number, corner) in (1..).zip(triangle.chunks_exact(12).skip(1)) {
            let mut point = [0.0; 3];
            for (value, bytes) in point.iter_mut().zip(corner.chunks_exact(4)) {
                *value = f64::from(f32::from_le_bytes(bytes.try_into().unwrap_or_default()));
            }
            self.corners.push(gathered, point, Spot::Point(3 * self.read as usize + number))?;
        }
        self.read += 1;
        Ok(())
    }

    /// The end of the file.
    ///
    /// # Errors
    /// [`FileError::Value`] when it comes before the end of the triangles.
    pub(super) fn finish(&self) -> Result<(), FileError> {
        if self.is_done() {
            return Ok(());
        }
        let Self { announced, read, .. } = self;
        let offset = HEADER + TRIANGLE * *read as usize + self.begun.len();
        let problem = format!("the file ends here; {read} of {announced} triangles were read");
        Err(FileError::value(format!("triangle {}", u64::from(*read) + 1), offset, problem))
    }
}
