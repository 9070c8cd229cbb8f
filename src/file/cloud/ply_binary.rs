//! The data of a binary PLY file in pieces.

use super::super::FileError;
use super::gathered::{Gathered, Spot};
use super::ply::ended;
use super::ply_header::{Element, Header, Number, Property};

/// The data, while it is read.
#[derive(Debug)]
pub(super) struct Binary {
    big_endian: bool,
    /// The elements up to the points, the last of which are the points.
    elements: Vec<Element>,
    /// Which properties of the points are x, y and z.
    axes: [usize; 3],
    /// The elements that are being read.
    element: usize,
    /// How many of them have been read, and the property that comes next.
    read: u64,
    property: usize,
    /// The coordinates of the point so far.
    point: [f64; 3],
    /// How many bytes are passed over.
    skip: u64,
    /// The beginning of a number or of a point whose end is still to come.
    begun: Vec<u8>,
    /// How many bytes of the file have come.
    offset: u64,
}

impl Binary {
    /// The data behind a header.
    pub(super) fn new(header: Header, big_endian: bool) -> Binary {
        let Header { before: mut elements, vertex, axes, bytes, .. } = header;
        elements.push(vertex);
        let mut binary = Binary {
            big_endian,
            elements,
            axes,
            element: 0,
            read: 0,
            property: 0,
            point: [0.0; 3],
            skip: 0,
            begun: Vec::new(),
            offset: bytes as u64,
        };
        binary.settle();
        binary
    }

    pub(super) fn is_big_endian(&self) -> bool {
        self.big_endian
    }

    /// Whether all points have been read.
    pub(super) fn is_done(&self) -> bool {
        self.element >= self.elements.len()
    }

    /// Whether the elements that are being read are the points.
    fn in_points(&self) -> bool {
        self.element + 1 == self.elements.len()
    }

    /// Goes on to elements of which there is something to read. Those before the points are passed over at once if
    /// they have one size.
    fn settle(&mut self) {
        while let Some(element) = self.elements.get(self.element) {
            let left = element.count.saturating_sub(self.read);
            if left > 0 {
                match element.stride() {
                    Some(stride) if !self.in_points() => {
                        self.skip = self.skip.saturating_add(left.saturating_mul(stride as u64));
                    }
                    _ => return,
                }
            }
            self.element += 1;
            self.read = 0;
        }
    }

    /// Reads what ends in this piece.
    ///
    /// # Errors
    /// [`FileError`] with the byte.
    pub(super) fn feed(&mut self, gathered: &mut Gathered, piece: &[u8]) -> Result<(), FileError> {
        let mut rest = piece;
        while !self.is_done() && !rest.is_empty() {
            let stride = self.elements.get(self.element).and_then(Element::stride);
            rest = match stride {
                _ if self.skip > 0 => {
                    let length = usize::try_from(self.skip).unwrap_or(usize::MAX).min(rest.len());
                    self.skip -= length as u64;
                    self.pass(rest, length)
                }
                Some(stride) => self.points(gathered, rest, stride)?,
                None => self.number(gathered, rest)?,
            };
        }
        Ok(())
    }

    /// What follows so many bytes.
    fn pass<'p>(&mut self, piece: &'p [u8], length: usize) -> &'p [u8] {
        self.offset += length as u64;
        piece.get(length..).unwrap_or_default()
    }

    /// The next bytes, so many, if they are there, and what follows them.
    fn take<'p>(&mut self, piece: &'p [u8], wanted: usize) -> (Option<Vec<u8>>, &'p [u8]) {
        let length = piece.len().min(wanted.saturating_sub(self.begun.len()));
        self.begun.extend_from_slice(piece.get(..length).unwrap_or_default());
        let whole = (self.begun.len() >= wanted).then(|| std::mem::take(&mut self.begun));
        (whole, self.pass(piece, length))
    }

    /// Reads points of one size.
    fn points<'p>(
        &mut self,
        gathered: &mut Gathered,
        piece: &'p [u8],
        stride: usize,
    ) -> Result<&'p [u8], FileError> {
        let Some(vertex) = self.elements.get(self.element) else { return Ok(&[]) };
        let count = vertex.count;
        let places = self.axes.map(|axis| place(vertex, axis));
        let big_endian = self.big_endian;
        let point = |bytes: &[u8]| -> [f64; 3] {
            // The bytes are those of a whole point.
            places.map(|(at, number)| {
                bytes.get(at..).and_then(|bytes| number.read(bytes, big_endian)).unwrap_or(f64::NAN)
            })
        };
        if !self.begun.is_empty() {
            let (whole, rest) = self.take(piece, stride);
            if let Some(bytes) = whole {
                self.read += 1;
                gathered.push(point(&bytes), Spot::Point(self.read as usize))?;
                self.settle();
            }
            return Ok(rest);
        }
        let left = usize::try_from(count - self.read).unwrap_or(usize::MAX);
        let whole = left.min(piece.len() / stride);
        for bytes in piece.chunks_exact(stride).take(whole) {
            self.read += 1;
            gathered.push(point(bytes), Spot::Point(self.read as usize))?;
        }
        let rest = self.pass(piece, whole * stride);
        if whole == left {
            self.settle();
            return Ok(rest);
        }
        self.begun.extend_from_slice(rest);
        Ok(self.pass(rest, rest.len()))
    }

    /// Reads the next number of elements with lists.
    fn number<'p>(&mut self, gathered: &mut Gathered, piece: &'p [u8]) -> Result<&'p [u8], FileError> {
        let property = self.elements.get(self.element).and_then(|it| it.properties.get(self.property));
        let Some(&property) = property else { return Ok(&[]) };
        let (Property::One(kind) | Property::List(kind, _)) = property;
        let (Some(bytes), rest) = self.take(piece, kind.size()) else { return Ok(&[]) };
        let value = kind.read(&bytes, self.big_endian).unwrap_or(f64::NAN);
        if let Property::List(_, item) = property {
            if value < 0.0 {
                let place = format!("element {} of \"{}\"", self.read + 1, self.name());
                let offset = (self.offset - bytes.len() as u64) as usize;
                return Err(FileError::value(place, offset, format!("{value} is no length of a list")));
            }
            // A length of at most 32 bits.
            self.skip = value as u64 * item.size() as u64;
        } else if self.in_points()
            && let Some(axis) = self.axes.iter().position(|&axis| axis == self.property)
            && let Some(coordinate) = self.point.get_mut(axis)
        {
            *coordinate = value;
        }
        self.property += 1;
        if self.elements.get(self.element).is_some_and(|it| self.property >= it.properties.len()) {
            self.property = 0;
            self.read += 1;
            if self.in_points() {
                gathered.push(self.point, Spot::Point(self.read as usize))?;
            }
            self.settle();
        }
        Ok(rest)
    }

    fn name(&self) -> &str {
        self.elements.get(self.element).map_or("", |element| &element.name)
    }

    /// The end of the file.
    ///
    /// # Errors
    /// [`FileError::Value`] when it comes before that of the points.
    pub(super) fn finish(&self) -> Result<(), FileError> {
        if self.is_done() {
            return Ok(());
        }
        let read = if self.in_points() { self.read } else { 0 };
        let count = self.elements.last().map_or(0, |vertex| vertex.count);
        let place = format!("point {}", read + 1);
        Err(FileError::value(place, usize::try_from(self.offset).unwrap_or(usize::MAX), ended(read, count)))
    }
}

/// Where a property of elements of one size begins, and its type.
fn place(element: &Element, property: usize) -> (usize, Number) {
    let numbers = element.properties.iter().map(|property| match property {
        Property::One(number) | Property::List(number, _) => *number,
    });
    let before = numbers.clone().take(property).map(Number::size).sum();
    (before, numbers.clone().nth(property).unwrap_or(Number::F64))
}
