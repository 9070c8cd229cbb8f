//! Points in tables of text, as people have them: CSV with any delimiter, a decimal point or comma, a header or
//! none, and more columns than coordinates.
//!
//! What is read and what is refused:
//!
//! - The delimiter is a tab, else a semicolon, else a comma or blanks: the first with which there are columns of
//!   numbers.
//! - Columns are found by their names, else because there are only two columns of numbers, or three.
//! - A number with one comma and three digits after it, `1,234`, is neither 1.234 nor 1234 until another number or
//!   the user says which sign is the decimal one.
//!
//! What cannot be decided is an error that names the option that decides it.

mod columns;
mod grid;
mod number;
mod options;
mod read;
mod text;

pub(super) use columns::{Chosen, Unchosen, by_axes, by_numbers, by_option};
pub(super) use grid::Grid;
pub(super) use number::{Number, decimal, doubt, value};
pub use options::{Columns, Decimal, Delimiter, TableOptions};
pub(super) use read::{comment_names, header, names_above, place_of, told};
pub(super) use text::{Lines, decoded, decoded_table};

use super::ec::EcDocument;
use super::{CloudFormat, Document, FileError, Places, PlanePoints, SpacePoints, check};
use read::{Refusal, Stage, Table};

const PLANE_HEADER: &str = "x,y";
const SPACE_HEADER: &str = "x,y,z";

impl Document {
    /// The control points in a table of text, in the plane or in space; see [`Document::from_table`].
    ///
    /// # Errors
    /// Those of [`Document::from_table`].
    ///
    /// ```
    /// use grafika::file::Document;
    ///
    /// let ours = Document::from_csv("x,y\n1.5,2.5\n7,0\n")?;
    /// assert_eq!(Document::from_csv("x;y\r\n1,5;2,5\r\n7;0\r\n")?, ours);
    /// assert_eq!(Document::from_csv("# scope\nTime (s)\tVolts\n1.5\t2.5\n7\t0\n")?, ours);
    /// let doubt = Document::from_csv("x;y\n1,234;2\n").unwrap_err().to_string();
    /// assert!(doubt.starts_with("line 2, column 1 (x): \"1,234\" may be 1.234 or 1234"));
    /// # Ok::<(), grafika::file::FileError>(())
    /// ```
    pub fn from_csv(text: &str) -> Result<Self, FileError> {
        Self::from_table(text, &TableOptions::default())
    }

    /// The control points in a table of text. What the options do not say follows from the table: the
    /// delimiter, the decimal sign, the header and the columns.
    ///
    /// # Errors
    /// [`FileError::Text`] with the line and the column for what is no finite number, and for what cannot be
    /// decided, with the option that would.
    pub fn from_table(text: &str, options: &TableOptions) -> Result<Self, FileError> {
        let lines = Lines::read(text)?;
        if lines.numbers.is_empty() {
            let problem = "the table is empty; it has a row for every point, as in 1,2".to_owned();
            return Err(error(1, "", problem));
        }
        if let Some(delimiter) = options.delimiter.or(lines.delimiter) {
            return Table::read(&lines, delimiter, options)
                .and_then(|table| table.points(options))
                .map_err(|refusal| refusal.error);
        }
        let mut best: Option<Refusal> = None;
        let mut found: Option<(Delimiter, Self)> = None;
        for delimiter in Delimiter::ALL {
            if !appears(&lines.text, delimiter) {
                continue;
            }
            let result = Table::read(&lines, delimiter, options).and_then(|table| table.points(options));
            match (result, &found) {
                (Ok(document), None) => {
                    // Nobody writes one of these between columns for another reason.
                    let sure = matches!(delimiter, Delimiter::Tab | Delimiter::Semicolon);
                    if sure {
                        return Ok(document);
                    }
                    found = Some((delimiter, document));
                }
                (Ok(document), Some((other, before))) if document != *before => {
                    let [one, two] = [other.name(), delimiter.name()];
                    let option = TableOptions::DELIMITER;
                    let problem = format!(
                        "{one} or {two} may separate the cells; {option} {one} or {option} {two} decides"
                    );
                    return Err(error(lines.numbers.first().copied().unwrap_or(1), "", problem));
                }
                (Ok(_), Some(_)) => {}
                (Err(refusal), _) => {
                    let farther = best.as_ref().is_none_or(|best| refusal.stage > best.stage);
                    best = if farther { Some(refusal) } else { best };
                }
            }
        }
        match (found, best) {
            (Some((_, document)), _) => Ok(document),
            (None, Some(refusal)) if refusal.stage > Stage::Table || options.columns.is_some() => {
                Err(refusal.error)
            }
            (None, _) => Err(no_table(&lines)),
        }
    }

    /// The control points as CSV text; reading it back gives the same numbers. Those of a curve over an extended
    /// Chebyshev space are written without the space.
    ///
    /// # Errors
    /// [`FileError::Misfit`] for other documents than control points, and for tangents, joints and settings,
    /// which have no place there; [`FileError::Invalid`] when a number is not finite.
    pub fn to_csv(&self) -> Result<String, FileError> {
        self.check()?;
        match self {
            Self::PlanePoints(PlanePoints { points, tangents: None, joints: None, settings })
                if settings.is_empty() =>
            {
                Ok(written(PLANE_HEADER, points))
            }
            Self::SpacePoints(SpacePoints { points, tangents: None, settings }) if settings.is_empty() => {
                Ok(written(SPACE_HEADER, points))
            }
            Self::Cloud(cloud) => {
                let bytes = cloud.write(CloudFormat::Csv)?;
                String::from_utf8(bytes).map_err(|error| FileError::Invalid(error.to_string()))
            }
            Self::Ec(document) => match &**document {
                EcDocument::Curve(curve) => Ok(written(SPACE_HEADER, &curve.points)),
                _ => Err(misfit(self.format().english())),
            },
            Self::Knots(knots) => Ok(written_places(&knots.points)),
            Self::Shaped(shaped) => Ok(written_places(&shaped.points)),
            Self::PlanePoints(PlanePoints { tangents: Some(_), .. })
            | Self::SpacePoints(SpacePoints { tangents: Some(_), .. }) => Err(misfit("tangents")),
            Self::PlanePoints(PlanePoints { joints: Some(_), .. }) => Err(misfit("shapes of joints")),
            Self::PlanePoints(_) | Self::SpacePoints(_) => Err(misfit("settings")),
            _ => Err(misfit(self.format().english())),
        }
    }

    /// Points with two or three coordinates, of which the last is not used in the plane.
    pub(super) fn of_points(points: Vec<[f64; 3]>, coordinates: usize) -> Self {
        match coordinates {
            3 => Self::SpacePoints(SpacePoints::new(points)),
            _ => Self::PlanePoints(PlanePoints::new(points.into_iter().map(|[x, y, _]| [x, y]).collect())),
        }
    }
}

fn written_places(points: &Places) -> String {
    match points {
        Places::Plane(points) => written(PLANE_HEADER, points),
        Places::Space(points) => written(SPACE_HEADER, points),
    }
}

/// Whether a delimiter stands anywhere in a text.
fn appears(text: &str, delimiter: Delimiter) -> bool {
    match delimiter {
        Delimiter::Blanks => text.contains([' ', '\t']),
        _ => text.contains(delimiter.sign()),
    }
}

/// Nothing looks like a table.
fn no_table(lines: &Lines<'_>) -> FileError {
    let problem = "there is no table of points: rows of two or three numbers with commas, semicolons, tabs or \
                   blanks between them, perhaps below a row of names as in x,y";
    error(lines.numbers.first().copied().unwrap_or(1), "", problem.to_owned())
}

fn written<const N: usize>(header: &str, points: &[[f64; N]]) -> String {
    let rows = points.iter().map(|point| point.map(check::number).join(",") + "\n");
    std::iter::once(format!("{header}\n")).chain(rows).collect()
}

fn error(line: usize, place: &str, problem: String) -> FileError {
    FileError::Text { line, place: place.to_owned(), problem }
}

fn misfit(found: &str) -> FileError {
    FileError::Misfit { format: "CSV", problem: format!("{found}; it holds the coordinates of points") }
}
