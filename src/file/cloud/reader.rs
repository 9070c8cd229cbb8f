//! Files of clouds in pieces, whatever their format.

use super::super::{FileError, TableOptions};
use super::gathered::Gathered;
use super::lines::{Lines, wrong};
use super::ply::Ply;
use super::rows::Rows;
use super::stl::{self, StlBinary, StlText};
use super::wide::Wide;
use super::{Cloud, CloudFormat, Encoding, obj, ply_header};

/// Reads a cloud from the pieces of a file, in memory of about its points.
///
/// ```
/// use grafika::file::{CloudFormat, CloudReader, TableOptions};
///
/// let mut reader = CloudReader::new(CloudFormat::Xyz, &TableOptions::default())?;
/// for piece in ["1 2 3\n4 5", " 6\n7 8 nan\n"] {
///     reader.feed(piece.as_bytes())?;
/// }
/// let cloud = reader.finish()?;
/// assert_eq!(cloud.points, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
/// assert_eq!(cloud.skipped.told(), ["1 point with NaN, infinite or huge coordinates, in line 3"]);
/// # Ok::<(), grafika::file::FileError>(())
/// ```
#[derive(Debug)]
pub struct CloudReader {
    gathered: Gathered,
    wide: Option<Wide>,
    state: State,
}

/// What is being read.
#[derive(Debug)]
enum State {
    /// The beginning, which tells what follows.
    Head {
        format: CloudFormat,
        options: TableOptions,
        head: Vec<u8>,
    },
    /// XYZ and CSV.
    Rows(Rows),
    Ply(Ply),
    Obj(Lines),
    StlText(StlText, Lines),
    StlBinary(StlBinary),
}

impl CloudReader {
    /// A reader of a format. A file that begins as PLY is read as PLY whatever it is called, and whether STL is text is
    /// seen from its content. The options are for tables.
    ///
    /// # Errors
    /// [`FileError::NoTable`] for options and another format.
    pub fn new(format: CloudFormat, options: &TableOptions) -> Result<Self, FileError> {
        let table = matches!(format, CloudFormat::Xyz | CloudFormat::Csv);
        if let Some(option) = options.given().filter(|_| !table) {
            return Err(FileError::NoTable { option });
        }
        let state = State::Head { format, options: options.clone(), head: Vec::new() };
        Ok(Self { gathered: Gathered::default(), wide: None, state })
    }

    /// Reads the next piece of the file. After an error nothing more can be read.
    ///
    /// # Errors
    /// [`FileError`] with the line or the byte that is wrong; also for more than ten million points.
    pub fn feed(&mut self, piece: &[u8]) -> Result<(), FileError> {
        let mut piece = piece;
        if let State::Head { head, .. } = &mut self.state {
            // What tells the two kinds of STL tells everything.
            let (part, rest) = piece.split_at(piece.len().min(stl::HEADER - head.len()));
            head.extend_from_slice(part);
            if head.len() < stl::HEADER {
                return Ok(());
            }
            self.begin()?;
            piece = rest;
        }
        match &mut self.wide {
            Some(wide) => {
                let text = wide.decode(piece);
                self.read(&text)
            }
            None => self.read(piece),
        }
    }

    /// Whether all points have been read, whatever follows.
    #[must_use]
    pub fn is_done(&self) -> bool {
        match &self.state {
            State::Ply(ply) => ply.is_done(),
            State::StlBinary(stl) => stl.is_done(),
            State::Head { .. } | State::Rows(_) | State::Obj(_) | State::StlText(..) => false,
        }
    }

    /// The points so far.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        self.gathered.points()
    }

    /// Takes the points since the last time, so that they need no memory here; what `points` held before is dropped.
    /// [`CloudReader::finish`] gives the rest. Of STL, in which equal corners are told, all of them are the rest.
    ///
    /// ```
    /// use grafika::file::{CloudFormat, CloudReader, TableOptions};
    ///
    /// let mut reader = CloudReader::new(CloudFormat::Ply, &TableOptions::default())?;
    /// let header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty int x\nproperty int y\nproperty int z\nend_header\n";
    /// reader.feed(header.as_bytes())?;
    /// reader.feed(b"1 2 3\n")?;
    /// let mut points = Vec::new();
    /// reader.take(&mut points);
    /// assert_eq!(points, [[1.0, 2.0, 3.0]]);
    /// reader.feed(b"4 5 6\n")?;
    /// assert_eq!(reader.finish()?.points, [[4.0, 5.0, 6.0]]);
    /// # Ok::<(), grafika::file::FileError>(())
    /// ```
    pub fn take(&mut self, points: &mut Vec<[f64; 3]>) {
        match self.state {
            State::StlText(..) | State::StlBinary(_) => points.clear(),
            State::Head { .. } | State::Rows(_) | State::Ply(_) | State::Obj(_) => self.gathered.take(points),
        }
    }

    /// The cloud, at the end of the file.
    ///
    /// # Errors
    /// [`FileError`] when the file ends too early or holds no points, and those of [`CloudReader::feed`].
    pub fn finish(mut self) -> Result<Cloud, FileError> {
        if matches!(self.state, State::Head { .. }) {
            self.begin()?;
        }
        let Self { mut gathered, mut state, .. } = self;
        let encoding = match &mut state {
            State::Head { .. } => None,
            State::Rows(rows) => {
                rows.finish(&mut gathered)?;
                rows.encoding()
            }
            State::Ply(ply) => {
                ply.finish(&mut gathered)?;
                Some(ply.encoding())
            }
            State::Obj(lines) => {
                lines.finish(|number, line| obj::read_line(&mut gathered, number, line))?;
                Some(Encoding::Obj)
            }
            State::StlText(stl, lines) => {
                lines.finish(|number, line| stl.line(&mut gathered, number, line))?;
                stl.finish(&gathered, lines.current())?;
                Some(Encoding::StlText)
            }
            State::StlBinary(stl) => {
                stl.finish()?;
                Some(Encoding::StlBinary)
            }
        };
        let (points, skipped) = gathered.finish()?;
        Ok(Cloud { points, skipped, encoding })
    }

    /// Finds out what the file is, and reads its beginning.
    fn begin(&mut self) -> Result<(), FileError> {
        let State::Head { format, options, head } = &mut self.state else { return Ok(()) };
        let (format, options, mut head) = (*format, std::mem::take(options), std::mem::take(head));
        self.wide = Wide::of(&head);
        if let Some(wide) = &mut self.wide {
            head = wide.decode(&head);
        }
        let head = head.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&head);
        self.state = match format {
            _ if ply_header::is_ply(head) => State::Ply(Ply::default()),
            CloudFormat::Xyz | CloudFormat::Csv => State::Rows(Rows::new(options)),
            CloudFormat::Obj => State::Obj(Lines::default()),
            CloudFormat::Ply => {
                let problem =
                    "this is no PLY file, which begins with \"ply\" in a line of its own".to_owned();
                return Err(wrong(1, String::new(), problem));
            }
            CloudFormat::Stl => match head.split_first_chunk() {
                Some((header, triangles)) if stl::is_binary(header) => {
                    self.state = State::StlBinary(StlBinary::new(header));
                    return self.read(triangles);
                }
                _ if stl::is_text(head) => State::StlText(StlText::default(), Lines::default()),
                _ => {
                    let problem = "this is no STL file: text begins with \"solid\", and binary files have a header of \
                                   80 bytes, the number of triangles, and 50 bytes for each";
                    return Err(FileError::Invalid(problem.to_owned()));
                }
            },
        };
        self.read(head)
    }

    /// Reads a piece of what the file is.
    fn read(&mut self, piece: &[u8]) -> Result<(), FileError> {
        let Self { gathered, state, .. } = self;
        match state {
            State::Head { .. } => Ok(()),
            State::Rows(rows) => rows.feed(gathered, piece),
            State::Ply(ply) => ply.feed(gathered, piece),
            State::Obj(lines) => lines.feed(piece, |number, line| obj::read_line(gathered, number, line)),
            State::StlText(stl, lines) => lines.feed(piece, |number, line| stl.line(gathered, number, line)),
            State::StlBinary(stl) => stl.feed(gathered, piece),
        }
    }
}
