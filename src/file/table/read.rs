//! Reading a table with a delimiter: where the coordinates are, and what they are.

use super::super::{Document, FileError};
use super::columns::{Chosen, Unchosen, by_axes, by_numbers, by_option};
use super::error;
use super::grid::Grid;
use super::number::{self, Number};
use super::options::{Columns, Decimal, Delimiter, TableOptions};
use super::text::Lines;

/// What the reading of a table has failed at, the earliest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Stage {
    /// With this delimiter it is no table of numbers.
    Table,
    /// It is one, but which columns count is not known.
    Columns,
    /// The columns are known, but not every cell in them is a number.
    Numbers,
}

/// Why a table is not read with a delimiter.
#[derive(Debug)]
pub(super) struct Refusal {
    pub(super) stage: Stage,
    pub(super) error: FileError,
}

impl Refusal {
    fn new(stage: Stage, line: usize, problem: String) -> Refusal {
        Refusal { stage, error: error(line, "", problem) }
    }
}

/// A table whose columns are known.
pub(super) struct Table {
    grid: Grid,
    place: Place,
}

/// Where the coordinates are in a table.
struct Place {
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
    pub(super) fn read(
        lines: &Lines<'_>,
        delimiter: Delimiter,
        options: &TableOptions,
    ) -> Result<Table, Refusal> {
        let grid = Grid::read(lines, delimiter).map_err(|error| Refusal { stage: Stage::Table, error })?;
        let place = match Place::by_header(&grid, delimiter, options)? {
            Some(place) => place,
            None => Place::by_rows(&grid, lines, delimiter, options)?,
        };
        Ok(Table { grid, place })
    }

    /// The points in the rows.
    pub(super) fn points(&self, options: &TableOptions) -> Result<Document, Refusal> {
        let refuse = |error| Refusal { stage: Stage::Numbers, error };
        let decimal = self.decimal(options).map_err(refuse)?;
        let mut points = Vec::with_capacity(self.grid.len().saturating_sub(self.place.first));
        for row in self.place.first..self.grid.len() {
            let width = self.grid.width(row);
            if self.place.bounded && width > self.place.names.len() {
                let wanted = self.place.names.len();
                let problem = format!("{width} columns; the header has {wanted}");
                return Err(refuse(error(self.grid.line(row), "row", problem)));
            }
            let mut point = [0.0; 3];
            for (value, &column) in point.iter_mut().zip(&self.place.columns) {
                *value = self.value(row, column, decimal, options).map_err(refuse)?;
            }
            points.push(point);
        }
        Ok(Document::of_points(points, self.place.columns.len()))
    }

    /// The decimal sign of the numbers in the columns.
    fn decimal(&self, options: &TableOptions) -> Result<Decimal, FileError> {
        let cells = (self.place.first..self.grid.len()).flat_map(|row| {
            self.place.columns.iter().map(move |&column| ((row, column), self.grid.cell(row, column)))
        });
        options.decimal.map_or_else(|| number::decimal(cells), Ok).map_err(|(row, column)| {
            let problem = number::doubt(self.grid.cell(row, column));
            error(self.grid.line(row), &self.place_of(column), problem)
        })
    }

    /// The number in a cell.
    fn value(
        &self,
        row: usize,
        column: usize,
        decimal: Decimal,
        options: &TableOptions,
    ) -> Result<f64, FileError> {
        let value = number::value(self.grid.cell(row, column), decimal, options.decimal);
        value.map_err(|problem| error(self.grid.line(row), &self.place_of(column), problem))
    }

    fn place_of(&self, column: usize) -> String {
        place_of(column, &self.place.names)
    }
}

/// A column for messages: `column 2 (y)`.
pub(in crate::file) fn place_of(column: usize, names: &[String]) -> String {
    match names.get(column).filter(|name| !name.is_empty()) {
        Some(name) => format!("column {} ({name})", column + 1),
        None => format!("column {}", column + 1),
    }
}

impl Place {
    /// By the first row of names that tells the columns, if there is one.
    fn by_header(
        grid: &Grid,
        delimiter: Delimiter,
        options: &TableOptions,
    ) -> Result<Option<Place>, Refusal> {
        if options.columns.as_ref().is_some_and(Columns::are_numbers) {
            return Ok(None);
        }
        for row in (0..grid.len().min(LAST_HEADER)).filter(|&row| !grid.cells(row).any(is_number)) {
            let names = header(grid, row, delimiter);
            match told(&names, options) {
                Ok(Chosen(columns)) => {
                    let first = row + 1 + usize::from(is_units(grid, row + 1));
                    return Ok(Some(Place { names, columns, first, bounded: true }));
                }
                Err(doubt @ Unchosen::Twice(_)) => {
                    let problem = doubt.problem(&names, names.len());
                    return Err(Refusal::new(Stage::Columns, grid.line(row), problem));
                }
                Err(_) => {}
            }
        }
        Ok(None)
    }

    /// By the rows of numbers, with the names above them if there are any.
    fn by_rows(
        grid: &Grid,
        lines: &Lines<'_>,
        delimiter: Delimiter,
        options: &TableOptions,
    ) -> Result<Place, Refusal> {
        let numbered = options.columns.as_ref().filter(|columns| columns.are_numbers());
        let numbered =
            numbered.and_then(|columns| by_option(columns, &[]).ok()).map(|Chosen(columns)| columns);
        let Some(first) = first_row(grid, numbered.as_deref()) else {
            let problem = match &numbered {
                Some(columns) => {
                    let columns: Vec<String> =
                        columns.iter().map(|column| (column + 1).to_string()).collect();
                    format!("no row has numbers in columns {}", columns.join(" and "))
                }
                None => "there is no row of numbers".to_owned(),
            };
            return Err(Refusal::new(Stage::Table, grid.line(0), problem));
        };
        let line = grid.line(first);
        // What another delimiter would separate into numbers is not one cell.
        if options.delimiter.is_none() && (first..grid.len()).any(|row| grid.cells(row).any(is_several)) {
            return Err(Refusal::new(Stage::Table, line, "other signs separate the numbers".to_owned()));
        }
        let mut names = names_above(grid, first, delimiter);
        // A comment may be longer than the rows, a header not.
        let mut bounded = !names.is_empty() && numbered.is_none();
        if let (true, Some(comment)) = (names.is_empty(), lines.comment_above(line)) {
            names = comment_names(comment, delimiter, grid.width(first));
        }
        if names.iter().all(String::is_empty) {
            (names, bounded) = (Vec::new(), false);
        }
        if let Some(columns) = numbered {
            return Ok(Place { names, columns, first, bounded });
        }
        let numeric = numeric_columns(grid, first);
        let count = numeric.len();
        let chosen = match told(&names, options) {
            Err(Unchosen::Unknown) => by_numbers(numeric, &names),
            chosen => chosen,
        };
        let Chosen(columns) = chosen.map_err(|doubt| {
            let few = matches!(doubt, Unchosen::Few(_));
            let stage = if few { Stage::Table } else { Stage::Columns };
            Refusal::new(stage, line, doubt.problem(&names, count))
        })?;
        let alone = grid.len() == 1 && names.is_empty() && options.delimiter.is_none();
        if let (true, Delimiter::Comma, 2) = (alone, delimiter, grid.width(0)) {
            let cell = format!("{},{}", grid.cell(0, 0), grid.cell(0, 1));
            if is_number(&cell) {
                let problem = format!(
                    "\"{cell}\" alone may be a point or a number with a decimal comma; {} comma makes it a point",
                    TableOptions::DELIMITER
                );
                return Err(Refusal::new(Stage::Columns, line, problem));
            }
        }
        Ok(Place { names, columns, first, bounded })
    }
}

/// The columns that names tell, by what the user says or as axes.
pub(in crate::file) fn told(names: &[String], options: &TableOptions) -> Result<Chosen, Unchosen> {
    match &options.columns {
        Some(columns) => by_option(columns, names),
        None => by_axes(names),
    }
}

/// Letters of a unit without brackets.
const LONGEST_UNIT: usize = 5;

/// Rows in which a header is looked for.
const LAST_HEADER: usize = 1000;

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
pub(in crate::file) fn header(grid: &Grid, row: usize, delimiter: Delimiter) -> Vec<String> {
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
pub(in crate::file) fn comment_names(comment: &str, delimiter: Delimiter, width: usize) -> Vec<String> {
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
pub(in crate::file) fn names_above(grid: &Grid, first: usize, delimiter: Delimiter) -> Vec<String> {
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
