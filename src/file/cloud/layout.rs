//! How the rows of a table of points are laid out, from its beginning: the delimiter, the decimal sign, the columns.

use super::super::FileError;
use super::super::table::{
    self, Chosen, Columns, Decimal, Delimiter, Grid, Lines, Number, TableOptions, Unchosen, by_numbers,
    by_option, comment_names, decoded_table, header, names_above, told,
};
use super::lines::{number, wrong};

/// How rows are laid out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) delimiter: Delimiter,
    /// The decimal sign.
    pub(super) decimal: Decimal,
    /// The columns of x and y, and of z if it is no plane.
    pub(super) columns: Vec<usize>,
    /// The names of the columns, if there are any.
    pub(super) names: Vec<String>,
    /// The first line of the file that is a row.
    pub(super) first: usize,
}

impl Layout {
    /// The layout of a table that begins with these whole lines; `None` while there is no row.
    ///
    /// # Errors
    /// [`FileError::Text`] for what cannot be decided, with the option that decides.
    pub(super) fn of(head: &[u8], options: &TableOptions) -> Result<Option<Layout>, FileError> {
        let text = decoded_table(head);
        let lines = Lines::read(&text)?;
        let said = options.delimiter.or(lines.delimiter);
        let delimiters = Delimiter::ALL.into_iter().filter(|&it| said.is_none_or(|said| said == it));
        let mut best: Option<([usize; 2], Delimiter, Grid)> = None;
        for delimiter in delimiters {
            let Ok(grid) = Grid::read(&lines, delimiter) else { continue };
            let score = score(&grid);
            if best.as_ref().is_none_or(|(best, ..)| score > *best) {
                best = Some((score, delimiter, grid));
            }
        }
        let Some((_, delimiter, grid)) = best else { return Ok(None) };
        // A number alone above the rows is how many there are.
        let is_row = |&row: &usize| grid.width(row) > 1 && grid.cells(row).any(is_number);
        let Some(first) = (0..grid.len()).find(is_row) else { return Ok(None) };
        let (columns, names) = columns(&grid, first, &lines, delimiter, options)?;
        let cells = (first..grid.len())
            .flat_map(|row| columns.iter().map(move |&column| (row, column)))
            .map(|(row, column)| ((row, column), grid.cell(row, column)));
        let decimal = options.decimal.map_or_else(|| table::decimal(cells), Ok);
        let decimal = decimal.map_err(|(row, column)| {
            wrong(grid.line(row), table::place_of(column, &names), table::doubt(grid.cell(row, column)))
        })?;
        Ok(Some(Layout { delimiter, decimal, columns, names, first: grid.line(first) }))
    }

    /// A column for messages: `column 2 (y)`.
    pub(super) fn place_of(&self, column: usize) -> String {
        table::place_of(column, &self.names)
    }
}

/// Whether a cell is a number, be it NaN or infinite.
fn is_number(cell: &str) -> bool {
    Number::read(cell).is_some() || number(cell.as_bytes()).is_some()
}

/// How well a delimiter separates numbers: how many rows have several and nothing else, and how many numbers there are.
fn score(grid: &Grid) -> [usize; 2] {
    let mut score = [0; 2];
    for row in 0..grid.len() {
        let numbers = grid.cells(row).filter(|cell| is_number(cell)).count();
        score[0] += usize::from(numbers >= 2 && numbers == grid.width(row));
        score[1] += if numbers >= 2 { numbers } else { 0 };
    }
    score
}

/// The columns of the coordinates, and the names of all columns.
fn columns(
    grid: &Grid,
    first: usize,
    lines: &Lines<'_>,
    delimiter: Delimiter,
    options: &TableOptions,
) -> Result<(Vec<usize>, Vec<String>), FileError> {
    let (line, width) = (grid.line(first), grid.width(first));
    let refused = |line: usize, doubt: &Unchosen, names: &[String]| {
        wrong(line, String::new(), doubt.problem(names, width))
    };
    if let Some(said) = options.columns.as_ref().filter(|columns| Columns::are_numbers(columns)) {
        let Chosen(columns) = by_option(said, &[]).map_err(|doubt| refused(line, &doubt, &[]))?;
        return Ok((columns, Vec::new()));
    }
    // Headers first, then the comment right above the rows.
    let headers = (0..first).map(|row| (grid.line(row), header(grid, row, delimiter)));
    let comment = lines.comment_above(line).map(|comment| (line, comment_names(comment, delimiter, width)));
    for (line, names) in headers.chain(comment) {
        match told(&names, options) {
            Ok(Chosen(columns)) => return Ok((columns, names)),
            Err(doubt @ Unchosen::Twice(_)) => return Err(refused(line, &doubt, &names)),
            Err(_) => {}
        }
    }
    let names = names_above(grid, first, delimiter);
    if options.columns.is_some() {
        let doubt = told(&names, options).err().unwrap_or(Unchosen::Unknown);
        return Err(refused(line, &doubt, &names));
    }
    if names.is_empty() {
        return Ok(((0..leading(grid, first)).collect(), names));
    }
    let numeric = (0..width).filter(|&column| is_number(grid.cell(first, column))).collect();
    let Chosen(columns) = by_numbers(numeric, &names).map_err(|doubt| refused(line, &doubt, &names))?;
    Ok((columns, names))
}

/// How many coordinates there are without a header: as many as most rows begin with, two or three.
fn leading(grid: &Grid, first: usize) -> usize {
    let mut rows = [0_usize; 2];
    for row in first..grid.len() {
        match grid.cells(row).take(3).take_while(|cell| is_number(cell)).count() {
            2 => rows[0] += 1,
            3 => rows[1] += 1,
            _ => {}
        }
    }
    if rows[0] > rows[1] { 2 } else { 3 }
}
