//! The header of PLY: how the data is written, and which properties its elements have.

use super::super::FileError;
use super::Encoding;
use super::lines::{words, wrong};

/// More than any header has.
const LONGEST: usize = 1 << 20;
/// The last line of a header.
const END: &[u8] = b"end_header";
/// The element that the points are.
const VERTEX: &str = "vertex";

/// A type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Number {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Its bytes in binary files.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number that begins these bytes; `None` if they are too few.
    pub(super) fn read(self, bytes: &[u8], big_endian: bool) -> Option<f64> {
        fn first<const N: usize>(bytes: &[u8], reversed: bool) -> Option<[u8; N]> {
            let mut bytes: [u8; N] = *bytes.first_chunk()?;
            if reversed {
                bytes.reverse();
            }
            Some(bytes)
        }
        Some(match self {
            Self::I8 => f64::from(i8::from_le_bytes(first(bytes, false)?)),
            Self::U8 => f64::from(u8::from_le_bytes(first(bytes, false)?)),
            Self::I16 => f64::from(i16::from_le_bytes(first(bytes, big_endian)?)),
            Self::U16 => f64::from(u16::from_le_bytes(first(bytes, big_endian)?)),
            Self::I32 => f64::from(i32::from_le_bytes(first(bytes, big_endian)?)),
            Self::U32 => f64::from(u32::from_le_bytes(first(bytes, big_endian)?)),
            Self::F32 => f64::from(f32::from_le_bytes(first(bytes, big_endian)?)),
            Self::F64 => f64::from_le_bytes(first(bytes, big_endian)?),
        })
    }
}

/// What a property is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Property {
    /// A number.
    One(Number),
    /// A list, with the type of its length and that of its numbers.
    List(Number, Number),
}

/// Elements of one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// The bytes of each in a binary file, if all have as many.
    pub(super) fn stride(&self) -> Option<usize> {
        let size = |property: &Property| match property {
            Property::One(number) => Some(number.size()),
            Property::List(..) => None,
        };
        self.properties.iter().map(size).sum()
    }
}

/// A header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    /// The elements before the points.
    pub(super) before: Vec<Element>,
    /// The points.
    pub(super) vertex: Element,
    /// Which properties of the points are x, y and z.
    pub(super) axes: [usize; 3],
    /// The number of lines.
    pub(super) lines: usize,
    /// The number of bytes.
    pub(super) bytes: usize,
}

/// Whether a file that begins so is PLY.
pub(super) fn is_ply(head: &[u8]) -> bool {
    matches!(head, [b'p', b'l', b'y', b'\r' | b'\n', ..])
}

impl Header {
    /// The header that begins these bytes; `None` while its end is missing.
    ///
    /// # Errors
    /// [`FileError::Text`] with the line that is wrong, or for a header without end.
    pub(super) fn read(bytes: &[u8]) -> Result<Option<Header>, FileError> {
        let Some(lines) = Self::split(bytes) else {
            if bytes.len() <= LONGEST {
                return Ok(None);
            }
            let problem = format!("the header has no line \"end_header\" in its first {LONGEST} bytes");
            return Err(wrong(1, String::new(), problem));
        };
        let mut encoding = None;
        // With the names of their properties.
        let mut elements: Vec<(Element, Vec<String>)> = Vec::new();
        for (number, line) in (2..).zip(lines.lines.iter().skip(1)) {
            let line = String::from_utf8_lossy(line);
            let refused = |problem: String| wrong(number, "header".to_owned(), problem);
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            match words[..] {
                [] | ["comment" | "obj_info", ..] => {}
                ["format", name, _] => {
                    encoding = Some(match name {
                        "ascii" => Encoding::PlyText,
                        "binary_little_endian" => Encoding::PlyLittleEndian,
                        "binary_big_endian" => Encoding::PlyBigEndian,
                        _ => {
                            return Err(refused(format!(
                                "\"{name}\" is none of ascii, binary_little_endian, binary_big_endian"
                            )));
                        }
                    });
                }
                ["element", name, count] => {
                    let count = count
                        .parse()
                        .map_err(|_| refused(format!("\"{count}\" is no number of elements")))?;
                    let element = Element { name: name.to_owned(), count, properties: Vec::new() };
                    elements.push((element, Vec::new()));
                }
                ["property", ref rest @ .., name] => {
                    let number = |name: &str| {
                        Number::named(name).ok_or_else(|| {
                            refused(format!(
                                "\"{name}\" is no type; there are char, uchar, short, ushort, int, uint, float, double"
                            ))
                        })
                    };
                    let property = match *rest {
                        [one] => Property::One(number(one)?),
                        ["list", length, item] => match number(length)? {
                            Number::F32 | Number::F64 => {
                                return Err(refused("the length of a list is a whole number".to_owned()));
                            }
                            length => Property::List(length, number(item)?),
                        },
                        _ => {
                            return Err(refused(format!(
                                "\"{line}\" is no property, as in property float x"
                            )));
                        }
                    };
                    let Some((element, names)) = elements.last_mut() else {
                        return Err(refused("a property stands below its element".to_owned()));
                    };
                    element.properties.push(property);
                    names.push(name.to_owned());
                }
                _ => {
                    let problem = format!("\"{line}\" begins none of format, comment, element, property");
                    return Err(refused(problem));
                }
            }
        }
        let refused = |problem: String| wrong(lines.lines.len() + 1, "header".to_owned(), problem);
        let encoding = encoding.ok_or_else(|| refused("there is no line \"format\"".to_owned()))?;
        let at = elements.iter().position(|(element, _)| element.name == VERTEX);
        let at = at.ok_or_else(|| refused("there is no element \"vertex\", the points".to_owned()))?;
        elements.truncate(at + 1);
        let Some((vertex, names)) = elements.pop() else {
            return Err(refused("there are no elements".to_owned()));
        };
        let mut axes = [0; 3];
        for (axis, name) in axes.iter_mut().zip(["x", "y", "z"]) {
            let found = names.iter().position(|known| known.eq_ignore_ascii_case(name));
            *axis =
                found.filter(|&at| matches!(vertex.properties.get(at), Some(Property::One(_)))).ok_or_else(
                    || refused(format!("the points have no number \"{name}\" among their properties")),
                )?;
        }
        let before = elements.into_iter().map(|(element, _)| element).collect();
        Ok(Some(Header { encoding, before, vertex, axes, lines: lines.lines.len() + 1, bytes: lines.bytes }))
    }

    /// The lines above the last one. The first line tells how lines end: behind the last one the data follows at once,
    /// which may begin with any byte.
    fn split(bytes: &[u8]) -> Option<Split<'_>> {
        let end = match bytes {
            [_, _, _, b'\r', b'\n', ..] => &b"\r\n"[..],
            [_, _, _, b'\r', ..] => b"\r",
            _ => b"\n",
        };
        let mut lines = Vec::new();
        let mut at = 0;
        loop {
            let rest = bytes.get(at..)?;
            let length = rest.windows(end.len()).position(|signs| signs == end)?;
            let line = rest.get(..length)?;
            at += length + end.len();
            if words(line).eq([END]) {
                return Some(Split { lines, bytes: at });
            }
            lines.push(line);
        }
    }
}

struct Split<'b> {
    lines: Vec<&'b [u8]>,
    /// The bytes with the last line.
    bytes: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "ply\nformat binary_big_endian 1.0\ncomment end_header comes\nelement face 2\n\
        property list uchar int vertex_indices\nelement vertex 3\nproperty uchar red\nproperty float y\n\
        property double x\nproperty list int8 float64 more\nproperty float32 z\nelement edge 1\nproperty int a\nend_header\n";

    #[test]
    fn elements_and_properties() {
        let header = Header::read(GOOD.as_bytes()).unwrap().unwrap();
        assert_eq!(header.encoding, Encoding::PlyBigEndian);
        assert_eq!((header.before.len(), header.before[0].stride()), (1, None));
        assert_eq!((header.vertex.count, header.axes), (3, [2, 1, 4]));
        assert_eq!(header.vertex.properties[3], Property::List(Number::I8, Number::F64));
        assert_eq!((header.lines, header.bytes), (14, GOOD.len()));
        for line_end in ["\r\n", "\r"] {
            let text = GOOD.replace('\n', line_end) + "\n\r\n";
            let again = Header::read(text.as_bytes()).unwrap().unwrap();
            assert_eq!(again, Header { bytes: text.len() - 3, ..header.clone() });
        }
        for length in 0..GOOD.len() {
            assert_eq!(Header::read(&GOOD.as_bytes()[..length]), Ok(None));
        }
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (good, bad, message) in [
            ("binary_big_endian 1.0", "binary 1.0", "line 2, header: \"binary\" is none of ascii"),
            ("format binary_big_endian 1.0\n", "", "line 13, header: there is no line \"format\""),
            ("element face 2", "element face -2", "line 4, header: \"-2\" is no number of elements"),
            ("element vertex", "element vertices", "line 14, header: there is no element \"vertex\""),
            ("float y", "quad y", "line 8, header: \"quad\" is no type"),
            ("float y", "float q", "line 14, header: the points have no number \"y\""),
            ("float y", "list uchar float y", "line 14, header: the points have no number \"y\""),
            ("list int8", "list float", "line 10, header: the length of a list is a whole number"),
            ("element face 2\n", "", "line 4, header: a property stands below its element"),
            ("property float y", "property y", "line 8, header: \"property y\" is no property"),
            ("property float y", "proberty float y", "line 8, header: \"proberty float y\" begins none of"),
        ] {
            let error = Header::read(GOOD.replacen(good, bad, 1).as_bytes()).unwrap_err().to_string();
            assert!(error.starts_with(message), "{error}");
        }
        let endless = [b"ply\n".as_slice(), &vec![b' '; LONGEST]].concat();
        assert!(Header::read(&endless).unwrap_err().to_string().contains("no line \"end_header\""));
    }
}
