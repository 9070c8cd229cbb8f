//! Field by field through the bytes of packed records.

use super::real48::{self, Real48Error};
use std::fmt;

/// The bytes end inside a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShortRead {
    /// Where the field begins, in bytes from the start.
    pub offset: usize,
    /// How many bytes the field takes.
    pub wanted: usize,
    /// How many bytes there are in all.
    pub length: usize,
}

impl fmt::Display for ShortRead {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { offset, wanted, length } = self;
        write!(f, "the data end at byte {length}; byte {offset} should begin a field of {wanted}")
    }
}

impl std::error::Error for ShortRead {}

/// Reads packed fields from the start of a byte slice onwards.
///
/// ```
/// use grafika::pascal::Reader;
/// let mut reader = Reader::new(&[0x2c, 0x01, 0x81, 0, 0, 0, 0, 0x80]);
/// assert_eq!(reader.i16(), Ok(300));
/// assert_eq!(reader.real(), Ok(-1.0));
/// assert!(reader.u8().is_err());
/// ```
#[derive(Clone, Debug)]
pub struct Reader<'a> {
    bytes: &'a [u8],
    offset: usize,
}

/// Every method that takes a field fails with [`ShortRead`] when the bytes end first, and then stays where
/// it is.
#[allow(clippy::missing_errors_doc, reason = "said once, above")]
impl<'a> Reader<'a> {
    /// A reader at the first byte.
    #[must_use]
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, offset: 0 }
    }

    /// Bytes passed so far: where the next field begins.
    #[must_use]
    pub fn offset(&self) -> usize {
        self.offset
    }

    /// The next `N` bytes.
    pub fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ShortRead> {
        let field = self.bytes.get(self.offset..).and_then(<[u8]>::first_chunk::<N>);
        let field = field.copied().ok_or_else(|| self.short(N))?;
        self.offset += N;
        Ok(field)
    }

    /// Passes over `count` bytes.
    pub fn skip(&mut self, count: usize) -> Result<(), ShortRead> {
        let end = self.offset.checked_add(count).filter(|&end| end <= self.bytes.len());
        self.offset = end.ok_or_else(|| self.short(count))?;
        Ok(())
    }

    /// A `byte`.
    pub fn u8(&mut self) -> Result<u8, ShortRead> {
        self.bytes().map(u8::from_le_bytes)
    }

    /// A `shortint`.
    pub fn i8(&mut self) -> Result<i8, ShortRead> {
        self.bytes().map(i8::from_le_bytes)
    }

    /// An `integer`.
    pub fn i16(&mut self) -> Result<i16, ShortRead> {
        self.bytes().map(i16::from_le_bytes)
    }

    /// A `single`; may be infinite or not a number.
    pub fn single(&mut self) -> Result<f32, ShortRead> {
        self.bytes().map(f32::from_le_bytes)
    }

    /// A `real` of six bytes; always finite.
    pub fn real(&mut self) -> Result<f64, ShortRead> {
        self.bytes().map(real48::decode)
    }

    fn short(&self, wanted: usize) -> ShortRead {
        ShortRead { offset: self.offset, wanted, length: self.bytes.len() }
    }
}

/// Appends packed fields to a growing list of bytes.
///
/// ```
/// use grafika::pascal::Writer;
/// let mut writer = Writer::default();
/// writer.i16(300);
/// writer.real(-1.0)?;
/// assert_eq!(writer.into_bytes(), [0x2c, 0x01, 0x81, 0, 0, 0, 0, 0x80]);
/// # Ok::<(), grafika::pascal::Real48Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Writer {
    bytes: Vec<u8>,
}

impl Writer {
    /// Bytes written so far: where the next field begins.
    #[must_use]
    pub fn offset(&self) -> usize {
        self.bytes.len()
    }

    /// A `byte`.
    pub fn u8(&mut self, value: u8) {
        self.bytes.push(value);
    }

    /// A `shortint`.
    pub fn i8(&mut self, value: i8) {
        self.bytes.extend(value.to_le_bytes());
    }

    /// An `integer`.
    pub fn i16(&mut self, value: i16) {
        self.bytes.extend(value.to_le_bytes());
    }

    /// A `single`.
    pub fn single(&mut self, value: f32) {
        self.bytes.extend(value.to_le_bytes());
    }

    /// A `real` of six bytes, the nearest to `value`.
    ///
    /// # Errors
    /// [`Real48Error`] when `value` is not finite or too large; nothing is written then.
    pub fn real(&mut self, value: f64) -> Result<(), Real48Error> {
        self.bytes.extend(real48::encode(value)?);
        Ok(())
    }

    /// Zero bytes up to `offset`; nothing if that has been passed.
    pub fn zeros_to(&mut self, offset: usize) {
        if offset > self.bytes.len() {
            self.bytes.resize(offset, 0);
        }
    }

    /// What has been written.
    #[must_use]
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_short_read_says_where_and_moves_nothing() {
        let mut reader = Reader::new(&[1, 2, 3]);
        assert_eq!(reader.i16(), Ok(0x0201));
        let error = ShortRead { offset: 2, wanted: 4, length: 3 };
        assert_eq!(reader.single(), Err(error));
        assert_eq!(error.to_string(), "the data end at byte 3; byte 2 should begin a field of 4");
        assert_eq!(reader.skip(usize::MAX).map_err(|e| e.offset), Err(2));
        assert_eq!(reader.i8(), Ok(3));
        assert_eq!(reader.offset(), 3);
    }

    proptest! {
        #[test]
        fn what_is_written_reads_back(a: u8, b: i8, c: i16, d: f32, e in -1e30f32..1e30, gap in 0usize..9) {
            let mut writer = Writer::default();
            writer.u8(a);
            writer.i8(b);
            writer.i16(c);
            writer.single(d);
            writer.zeros_to(8 + gap);
            let e = f64::from(e); // 24 bits, so exact as a 6-byte real
            let e = if e.abs() < real48::MIN_POSITIVE { 0.0 } else { e };
            writer.real(e).unwrap();
            prop_assert_eq!(writer.offset(), 14 + gap);
            let bytes = writer.into_bytes();
            let mut reader = Reader::new(&bytes);
            prop_assert_eq!(reader.u8(), Ok(a));
            prop_assert_eq!(reader.i8(), Ok(b));
            prop_assert_eq!(reader.i16(), Ok(c));
            prop_assert_eq!(reader.single().map(f32::to_bits), Ok(d.to_bits()));
            prop_assert_eq!(reader.skip(gap), Ok(()));
            prop_assert_eq!(reader.real(), Ok(e));
        }
    }
}
