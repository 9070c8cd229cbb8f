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
mod text;

pub(super) use columns::{Unchosen, by_axes, by_numbers, by_option};
pub use options::{Columns, Decimal, Delimiter, TableOptions};
pub(super) use text::{decoded, decoded_table};

use super::{Document, FileError, PlanePoints, SpacePoints, check};
use columns::Chosen;
use grid::Grid;
use number::{Number, Signs};
use options::Column;
use text::Lines;

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
            return Err(error(
                1,
                "",
                "the table is empty; it has a row for every point, as in 1,2".to_owned(),
            ));
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
                    return Err(error(
                        lines.numbers.first().copied().unwrap_or(1),
                        "",
                        format!(
                            "the cells may be separated by {} or by {}; {} {} or {} {} decides",
                            other.name(),
                            delimiter.name(),
                            TableOptions::DELIMITER,
                            other.name(),
                            TableOptions::DELIMITER,
                            delimiter.name()
                        ),
                    ));
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
            (None, Some(refusal)) if refusal.stage > Stage::NoTable || options.columns.is_some() => {
                Err(refusal.error)
            }
            (None, _) => Err(no_table(&lines)),
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
                Ok(written(PLANE_HEADER, points))
            }
            Self::SpacePoints(SpacePoints { points, settings }) if settings.is_empty() => {
                Ok(written(SPACE_HEADER, points))
            }
            Self::PlanePoints(PlanePoints { tangents: Some(_), .. }) => Err(misfit("tangents")),
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

/// How far the reading of a table has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Stage {
    /// With this delimiter it is no table of numbers.
    NoTable,
    /// It is one, but which columns count is not known.
    NoColumns,
    /// The columns are known, but not every cell in them is a number.
    NoNumbers,
}

/// Why a table is not read with a delimiter.
#[derive(Debug)]
struct Refusal {
    stage: Stage,
    error: FileError,
}

impl Refusal {
    fn new(stage: Stage, line: usize, problem: String) -> Refusal {
        Refusal { stage, error: error(line, "", problem) }
    }
}

/// A table whose columns are known.
struct Table {
    grid: Grid,
    /// The names of all columns; none without a header.
    names: Vec<String>,
    columns: Vec<usize>,
    /// The first row of numbers.
    first: usize,
    /// Whether rows may not be longer than the header.
    bounded: bool,
}

impl Table {
    /// Separates the cells and finds the columns.
    fn read(lines: &Lines<'_>, delimiter: Delimiter, options: &TableOptions) -> Result<Table, Refusal> {
        let grid = Grid::read(lines, delimiter).map_err(|error| Refusal { stage: Stage::NoTable, error })?;
        let names = |row: usize| header(&grid, row, delimiter);
        let told = |names: &[String]| match &options.columns {
            Some(columns) => by_option(columns, names),
            None => by_axes(names),
        };
        let by_number =
            |columns: &Columns| columns.list().iter().all(|column| matches!(column, Column::Number(_)));
        // By a row of names that tells the columns: the first one, with numbers under it.
        if !options.columns.as_ref().is_some_and(by_number) {
            for row in (0..grid.len()).take_while(|&row| row < LAST_HEADER) {
                if grid.cells(row).any(is_number) {
                    continue;
                }
                let names = names(row);
                match told(&names) {
                    Ok(Chosen(columns)) => {
                        let first = row + 1 + usize::from(is_units(&grid, row + 1));
                        return Ok(Table { names, columns, first, bounded: true, grid });
                    }
                    Err(doubt @ Unchosen::Twice(_)) => {
                        let problem = doubt.problem(&names, names.len());
                        return Err(Refusal::new(Stage::NoColumns, grid.line(row), problem));
                    }
                    Err(_) => {}
                }
            }
        }
        // By the first row of numbers.
        let chosen = options.columns.as_ref().filter(|columns| by_number(columns));
        let chosen = chosen.and_then(|columns| by_option(columns, &[]).ok()).map(|Chosen(columns)| columns);
        let Some(first) = first_row(&grid, chosen.as_deref()) else {
            let problem = match &chosen {
                Some(columns) => {
                    let columns: Vec<String> =
                        columns.iter().map(|column| (column + 1).to_string()).collect();
                    format!("no row has numbers in columns {}", columns.join(" and "))
                }
                None => "there is no row of numbers".to_owned(),
            };
            return Err(Refusal::new(Stage::NoTable, grid.line(0), problem));
        };
        let line = grid.line(first);
        let above =
            lines.comment_above(line).map(|comment| comment_names(comment, delimiter, grid.width(first)));
        let (mut names, in_grid) = match (names_above(&grid, first, delimiter), above) {
            (names, Some(comment)) if names.is_empty() => (comment, false),
            (names, _) => (names, true),
        };
        if names.iter().all(String::is_empty) {
            names.clear();
        }
        let refuse =
            |doubt: Unchosen, width| Refusal::new(Stage::NoColumns, line, doubt.problem(&names, width));
        if let Some(columns) = chosen {
            return Ok(Table { names, columns, first, bounded: false, grid });
        }
        let numeric = numeric_columns(&grid, first);
        let count = numeric.len();
        let columns = match told(&names) {
            Ok(chosen) => Ok(chosen),
            Err(Unchosen::Unknown) => by_numbers(numeric, &names),
            Err(doubt) => Err(doubt),
        };
        let columns = match columns {
            Ok(Chosen(columns)) => columns,
            Err(Unchosen::Few(few)) => {
                return Err(Refusal::new(Stage::NoTable, line, Unchosen::Few(few).problem(&names, count)));
            }
            Err(doubt) => return Err(refuse(doubt, count)),
        };
        // What another delimiter would separate into numbers is not one cell.
        if options.delimiter.is_none() && (first..grid.len()).any(|row| grid.cells(row).any(is_several)) {
            return Err(Refusal::new(Stage::NoTable, line, "other signs separate the numbers".to_owned()));
        }
        let alone = grid.len() == 1 && names.is_empty() && options.delimiter.is_none();
        if let (true, Delimiter::Comma, 2) = (alone, delimiter, grid.width(0)) {
            let cell = format!("{},{}", grid.cell(0, 0), grid.cell(0, 1));
            if Number::read(&cell).is_some() {
                let problem = format!(
                    "\"{cell}\" alone may be a point or a number with a decimal comma; {} comma makes it a point",
                    TableOptions::DELIMITER
                );
                return Err(Refusal::new(Stage::NoColumns, line, problem));
            }
        }
        let bounded = in_grid && !names.is_empty();
        Ok(Table { names, columns, first, bounded, grid })
    }

    /// The points in the rows.
    fn points(&self, options: &TableOptions) -> Result<Document, Refusal> {
        let refuse = |error| Refusal { stage: Stage::NoNumbers, error };
        let decimal = self.decimal(options).map_err(refuse)?;
        let mut points = Vec::with_capacity(self.grid.len().saturating_sub(self.first));
        for row in self.first..self.grid.len() {
            let width = self.grid.width(row);
            if self.bounded && width > self.names.len() {
                let wanted = self.names.len();
                let problem = format!("{width} columns; the header has {wanted}");
                return Err(refuse(error(self.grid.line(row), "row", problem)));
            }
            let mut point = [0.0; 3];
            for (value, &column) in point.iter_mut().zip(&self.columns) {
                *value = self.value(row, column, decimal, options).map_err(refuse)?;
            }
            points.push(point);
        }
        Ok(Document::of_points(points, self.columns.len()))
    }

    /// The decimal sign of the numbers in the columns.
    fn decimal(&self, options: &TableOptions) -> Result<Decimal, FileError> {
        if let Some(decimal) = options.decimal {
            return Ok(decimal);
        }
        let mut doubtful = None;
        for row in self.first..self.grid.len() {
            for &column in &self.columns {
                match Number::read(self.grid.cell(row, column)).map(|number| number.signs) {
                    Some(Signs::Sure(decimal)) => return Ok(decimal),
                    Some(Signs::Doubtful(Decimal::Comma)) => doubtful = doubtful.or(Some((row, column))),
                    // A point is a decimal point unless something speaks against it.
                    Some(Signs::Doubtful(Decimal::Point) | Signs::None) | None => {}
                }
            }
        }
        doubtful.map_or(Ok(Decimal::Point), |(row, column)| Err(self.doubt(row, column)))
    }

    /// The number in a cell.
    fn value(
        &self,
        row: usize,
        column: usize,
        decimal: Decimal,
        options: &TableOptions,
    ) -> Result<f64, FileError> {
        let cell = self.grid.cell(row, column);
        let problem = match Number::read(cell) {
            None if cell.is_empty() => "the cell is empty; a point needs every coordinate".to_owned(),
            None => format!("\"{cell}\" is not a finite number"),
            Some(number) => match number.signs {
                Signs::Sure(other) if other != decimal => match options.decimal {
                    Some(said) => format!("\"{cell}\" has a decimal {other}, not a decimal {said}"),
                    None => {
                        format!("\"{cell}\" has a decimal {other}, a number before it a decimal {decimal}")
                    }
                },
                Signs::Doubtful(other) if other != decimal && options.decimal.is_none() => {
                    return Err(self.doubt(row, column));
                }
                _ => match number.value(decimal) {
                    value if value.is_finite() => return Ok(value),
                    _ => format!("\"{cell}\" is not a finite number"),
                },
            },
        };
        Err(error(self.grid.line(row), &self.place(column), problem))
    }

    /// A number whose sign may be the decimal one or stand between thousands.
    fn doubt(&self, row: usize, column: usize) -> FileError {
        let cell = self.grid.cell(row, column);
        let values = [Decimal::Point, Decimal::Comma]
            .map(|decimal| Number::read(cell).map_or(f64::NAN, |number| number.value(decimal)));
        let [small, large] = match values {
            [a, b] if a.abs() <= b.abs() => [a, b],
            [a, b] => [b, a],
        };
        let option = TableOptions::DECIMAL;
        let problem = format!(
            "\"{cell}\" may be {} or {}; {option} point or {option} comma decides",
            check::number(small),
            check::number(large)
        );
        error(self.grid.line(row), &self.place(column), problem)
    }

    /// A column for messages: `column 2 (y)`.
    fn place(&self, column: usize) -> String {
        match self.names.get(column).filter(|name| !name.is_empty()) {
            Some(name) => format!("column {} ({name})", column + 1),
            None => format!("column {}", column + 1),
        }
    }
}

/// Letters of a unit without brackets.
const LONGEST_UNIT: usize = 5;

/// Rows in which a header is looked for.
const LAST_HEADER: usize = 1000;

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

fn is_number(cell: &str) -> bool {
    Number::read(cell).is_some()
}

/// Whether a cell holds several numbers with blanks, semicolons or tabs between them.
fn is_several(cell: &str) -> bool {
    let mut parts = cell.split([' ', ';', '\t']).filter(|part| !part.is_empty()).peekable();
    let first = parts.next().is_some_and(|part| is_number(part.trim_matches(',')));
    first && parts.peek().is_some() && parts.all(|part| is_number(part.trim_matches(',')))
}

/// The names in a row; units that blanks have separated from them belong to them.
fn header(grid: &Grid, row: usize, delimiter: Delimiter) -> Vec<String> {
    joined(grid.cells(row), delimiter)
}

fn joined<'c>(cells: impl Iterator<Item = &'c str>, delimiter: Delimiter) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for cell in cells {
        match names.last_mut() {
            Some(name) if delimiter == Delimiter::Blanks && cell.starts_with(['[', '(']) => {
                name.push(' ');
                name.push_str(cell);
            }
            _ => names.push(cell.to_owned()),
        }
    }
    names
}

/// The names in a comment, if there are as many as columns.
fn comment_names(comment: &str, delimiter: Delimiter, width: usize) -> Vec<String> {
    let blanks = delimiter == Delimiter::Blanks;
    let cells =
        comment.split(|sign: char| if blanks { sign.is_whitespace() } else { sign == delimiter.sign() });
    let cells = cells.map(|cell| cell.trim().trim_matches('"')).filter(|cell| !blanks || !cell.is_empty());
    let names = joined(cells, delimiter);
    if names.len() == width { names } else { Vec::new() }
}

/// Whether a row under a header holds units: no number, but something. As a row of data it would be wrong.
fn is_units(grid: &Grid, row: usize) -> bool {
    row < grid.len() && !grid.cells(row).any(is_number) && grid.cells(row).all(is_unit)
}

/// Whether a cell may be a unit: nothing, a word in brackets, or a short one that does not stand for a number.
fn is_unit(cell: &str) -> bool {
    let no_number = ["nan", "na", "n/a", "null", "none", "nil", "inf", "-inf", "+inf", "-", "?"];
    let short = cell.chars().count() <= LONGEST_UNIT && !no_number.contains(&cell.to_lowercase().as_str());
    cell.starts_with(['(', '[', '<', '{']) || short
}

/// The names above the first row of numbers, perhaps with units between them.
fn names_above(grid: &Grid, first: usize, delimiter: Delimiter) -> Vec<String> {
    let width = grid.width(first);
    let fits = |row: usize| {
        let names = header(grid, row, delimiter);
        let sound = names.len() == width && !grid.cells(row).any(is_number);
        sound.then_some(names)
    };
    let Some(above) = first.checked_sub(1) else { return Vec::new() };
    let units = grid
        .cells(above)
        .all(|cell| is_unit(cell) && (cell.len() <= 3 || !cell.starts_with(char::is_alphabetic)));
    let names = above.checked_sub(1).filter(|_| units).and_then(fits);
    names.filter(|_| fits(above).is_some()).or_else(|| fits(above)).unwrap_or_default()
}

/// The first row of numbers in these columns, or in those in which the last row of numbers has them. A row right
/// above it with a number there belongs to it: what else it holds is wrong, and is not passed over in silence.
fn first_row(grid: &Grid, columns: Option<&[usize]>) -> Option<usize> {
    let is_number_at = |row: usize, column: usize| is_number(grid.cell(row, column));
    let numbers = |row: usize| -> Vec<usize> {
        (0..grid.width(row)).filter(|&column| is_number_at(row, column)).collect()
    };
    let columns = match columns {
        Some(columns) => columns.to_vec(),
        None => (0..grid.len()).rev().map(numbers).find(|numbers| numbers.len() >= 2)?,
    };
    let first = (0..grid.len()).find(|&row| columns.iter().all(|&column| is_number_at(row, column)))?;
    let belongs = |&row: &usize| columns.iter().any(|&column| is_number_at(row, column));
    (0..first).rev().take_while(belongs).last().or(Some(first))
}

/// The columns in which more than half of the cells with anything in them are numbers.
fn numeric_columns(grid: &Grid, first: usize) -> Vec<usize> {
    let mut counts: Vec<[usize; 2]> = Vec::new();
    for row in first..grid.len() {
        if grid.width(row) > counts.len() {
            counts.resize(grid.width(row), [0; 2]);
        }
        for (count, cell) in counts.iter_mut().zip(grid.cells(row)).filter(|(_, cell)| !cell.is_empty()) {
            count[usize::from(is_number(cell))] += 1;
        }
    }
    let numeric = |&(_, [others, numbers]): &(usize, [usize; 2])| numbers > others;
    counts.into_iter().enumerate().filter(numeric).map(|(column, _)| column).collect()
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
