//! Control points as CSV: a header `x,y` or `x,y,z` and one row for every point.

use super::{Document, FileError, PlanePoints, SpacePoints, check};

const PLANE_HEADER: &str = "x,y";
const SPACE_HEADER: &str = "x,y,z";

impl Document {
    /// The control points in a CSV text: in the plane or in space as its header says. Blank lines and
    /// blanks around numbers do not matter.
    ///
    /// # Errors
    /// [`FileError::Text`] with the line and the column for another header, rows of another length, and
    /// what is no finite number.
    pub fn from_csv(text: &str) -> Result<Self, FileError> {
        let text = text.trim_start_matches('\u{feff}');
        let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
        let (line, header) = lines.next().unwrap_or((1, ""));
        let header: String = header.to_ascii_lowercase().split_whitespace().collect();
        match header.as_str() {
            PLANE_HEADER => rows(lines).map(|points| Self::PlanePoints(PlanePoints::new(points))),
            SPACE_HEADER => rows(lines).map(|points| Self::SpacePoints(SpacePoints::new(points))),
            _ => Err(error(line, "header", "must be \"x,y\" or \"x,y,z\"".to_owned())),
        }
    }

    /// The control points as CSV text; reading it back gives the same numbers.
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
                Ok(text(PLANE_HEADER, points))
            }
            Self::SpacePoints(SpacePoints { points, settings }) if settings.is_empty() => {
                Ok(text(SPACE_HEADER, points))
            }
            Self::PlanePoints(PlanePoints { tangents: Some(_), .. }) => Err(misfit("tangents")),
            Self::PlanePoints(PlanePoints { joints: Some(_), .. }) => Err(misfit("shapes of joints")),
            Self::PlanePoints(_) | Self::SpacePoints(_) => Err(misfit("settings")),
            _ => Err(misfit(self.format().english())),
        }
    }
}

fn rows<'a, const N: usize>(
    lines: impl Iterator<Item = (usize, &'a str)>,
) -> Result<Vec<[f64; N]>, FileError> {
    let row = |(line, text): (usize, &str)| {
        let cells: Vec<_> = text.split(',').map(str::trim).collect();
        let cells: [&str; N] = cells.try_into().map_err(|cells: Vec<_>| {
            error(line, "row", format!("{} columns; there must be {N}", cells.len()))
        })?;
        let mut point = [0.0; N];
        for ((value, cell), axis) in point.iter_mut().zip(cells).zip(check::AXES) {
            let number = cell.parse().ok().filter(|v: &f64| v.is_finite());
            *value = number.ok_or_else(|| error(line, axis, format!("\"{cell}\" is not a finite number")))?;
        }
        Ok(point)
    };
    lines.map(row).collect()
}

fn text<const N: usize>(header: &str, points: &[[f64; N]]) -> String {
    let rows = points.iter().map(|point| point.map(check::number).join(",") + "\n");
    std::iter::once(format!("{header}\n")).chain(rows).collect()
}

fn error(line: usize, place: &str, problem: String) -> FileError {
    FileError::Text { line, place: place.to_owned(), problem }
}

fn misfit(found: &str) -> FileError {
    FileError::Misfit { format: "CSV", problem: format!("{found}; it holds the coordinates of points") }
}
