//! The dialog of an exact description: a table of coefficients, a column for every function or product.

use super::preview::Preview;
use super::studio::Studio;
use super::texts;
use crate::file::ec::{Coefficients, CurveTerm, EcDocument, Item, PatchTerm, curve_formulas, patch_formulas};
use crate::geometry::ec::{EcError, Real};
use crate::machine::{Asked, Asking, Key, Language, Request, Stop};
use crate::screen::{Color, Screen};
use crate::ui::words::Hot;
use crate::ui::{
    Accepts, Area, Command, Commands, Desk, Entry, KeyHelp, Picture, Stay, TOP, Typed, line, page, panel,
    window,
};

/// Columns that are seen, and their place.
const SEEN: usize = 6;
const TABLE: Area = Area::new(28, 64, 612, 160);
const COLUMN: i32 = 92;
/// The lower edge of the preview.
const BOTTOM: i32 = 465;
/// Letters in a cell.
const LETTERS: usize = 10;

#[derive(Clone, Copy)]
enum Do {
    Change,
    Update,
    Clear,
    Load,
    Save,
}

const HELP: KeyHelp = line("V R C O M", "lásd a gombokat", "see the buttons");

const fn at(x: i32, y: i32, text: Hot) -> crate::ui::Button {
    crate::ui::Button::new(x, y, text)
}

const COMMANDS: Commands<Do> = Commands(&[
    Command::button(at(460, 4, Hot::new('V', "áltozás", "-change")), HELP, Do::Change),
    Command::button(at(460, 21, Hot::new('C', "-nullák", "-clear")), HELP, Do::Clear),
    Command::button(at(550, 4, Hot::new('R', "endben", "-update")), HELP, Do::Update),
    Command::button(at(30, 21, Hot::new('O', "-betölt", "-load")), HELP, Do::Load),
    Command::button(at(120, 21, Hot::new('M', "ent", "-save")), HELP, Do::Save),
]);

struct Table {
    /// The item whose description it is.
    item: Item,
    /// The names of the columns, and the functions along u and v of each.
    columns: Vec<(String, [usize; 2])>,
    cells: Vec<[Real; 3]>,
    chosen: [usize; 2],
    /// The cell that is being typed.
    entry: Option<Entry>,
    preview: Preview,
}

impl Table {
    fn new(item: &Item) -> Table {
        let columns: Vec<(String, [usize; 2])> = match item {
            Item::Curve(curve) => {
                let named = curve.space.functions("u").into_iter().enumerate();
                named.map(|(k, name)| (name, [k, 0])).collect()
            }
            Item::Patch(patch) => {
                let along_v = patch.space_v.functions("v");
                let pairs = patch.space_u.functions("u").into_iter().enumerate().flat_map(|(k, u)| {
                    along_v.clone().into_iter().enumerate().map(move |(l, v)| {
                        let name = match (u.as_str(), v.as_str()) {
                            ("1", one) | (one, "1") => one.to_owned(),
                            _ => format!("{u} {v}"),
                        };
                        (name, [k, l])
                    })
                });
                pairs.collect()
            }
        };
        let cells = vec![Default::default(); columns.len()];
        let mut table = Table {
            item: item.clone(),
            columns,
            cells,
            chosen: [0; 2],
            entry: None,
            preview: Preview::default(),
        };
        match item {
            Item::Curve(curve) => {
                curve.exact.iter().flatten().for_each(|term| table.put([term.function, 0], &term.value));
            }
            Item::Patch(patch) => {
                patch.exact.iter().flatten().for_each(|term| table.put([term.u, term.v], &term.value));
            }
        }
        table
    }

    /// Adds a coefficient to what is there.
    fn put(&mut self, functions: [usize; 2], value: &[Real; 3]) {
        let column = self.columns.iter().position(|(_, own)| *own == functions);
        if let Some(cell) = column.and_then(|at| self.cells.get_mut(at)) {
            for (own, value) in cell.iter_mut().zip(value) {
                let empty = own.value() == 0.0;
                *own = if empty { value.clone() } else { Real::from(own.value() + value.value()) };
            }
        }
    }

    /// The coefficients that are not 0.
    fn terms(&self) -> impl Iterator<Item = ([usize; 2], &[Real; 3])> {
        let filled = |cell: &[Real; 3]| cell.iter().any(|value| value.value() != 0.0);
        self.columns
            .iter()
            .zip(&self.cells)
            .filter(move |(_, cell)| filled(cell))
            .map(|((_, it), cell)| (*it, cell))
    }

    fn coefficients(&self) -> Coefficients {
        match &self.item {
            Item::Curve(curve) => Coefficients::Curve {
                space: curve.space.clone(),
                interval: curve.interval.clone(),
                coefficients: self
                    .terms()
                    .map(|([function, _], value)| CurveTerm { function, value: value.clone() })
                    .collect(),
            },
            Item::Patch(patch) => Coefficients::Surface {
                space_u: patch.space_u.clone(),
                interval_u: patch.interval_u.clone(),
                space_v: patch.space_v.clone(),
                interval_v: patch.interval_v.clone(),
                coefficients: self
                    .terms()
                    .map(|([u, v], value)| PatchTerm { u, v, value: value.clone() })
                    .collect(),
            },
        }
    }

    fn first(&self) -> usize {
        self.chosen[0] / SEEN * SEEN
    }

    fn cell_area(&self, [column, row]: [usize; 2]) -> Area {
        let x = TABLE.x1 + 24 + COLUMN * i32::try_from(column - self.first()).unwrap_or(0);
        let y = TABLE.y1 + 32 + 21 * i32::try_from(row).unwrap_or(0);
        Area::new(x, y, x + COLUMN - 6, y + 14)
    }

    fn cell_under(&self, (x, y): (i32, i32)) -> Option<[usize; 2]> {
        let columns = self.first()..(self.first() + SEEN).min(self.columns.len());
        columns
            .flat_map(|column| (0..3).map(move |row| [column, row]))
            .find(|&at| self.cell_area(at).holds(x, y))
    }

    /// Begins to type the chosen cell.
    fn open(&mut self, first: Option<char>) {
        let area = self.cell_area(self.chosen);
        let mut entry = Entry::new(area, (area.x1 + 4, area.y1 + 4), 60, Accepts::Text);
        match first {
            Some(letter) => {
                entry.key(Key::Char(letter));
            }
            None => {
                let [column, row] = self.chosen;
                let present = self.cells.get(column).map(|cell| cell[row].to_string());
                entry = entry.proposing(present.unwrap_or_default());
            }
        }
        self.entry = Some(entry);
    }

    fn move_by(&mut self, columns: isize, rows: isize) {
        let [column, row] = self.chosen;
        let last = self.columns.len().saturating_sub(1);
        self.chosen =
            [column.saturating_add_signed(columns).min(last), row.saturating_add_signed(rows).min(2)];
    }

    /// A key while a cell is typed.
    fn type_key(&mut self, desk: &mut Desk<'_>, key: Key) {
        let Some(entry) = &mut self.entry else { return };
        match entry.key(key) {
            Typed::On => {}
            Typed::Cancelled => self.entry = None,
            Typed::Done => {
                let text = entry.text.trim().to_owned();
                let read = if text.is_empty() { Ok(Real::default()) } else { Real::typed(&text) };
                match read {
                    Ok(number) => {
                        let [column, row] = self.chosen;
                        if let Some(cell) = self.cells.get_mut(column) {
                            cell[row] = number;
                        }
                        self.entry = None;
                    }
                    Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
                }
            }
        }
    }
}

impl Picture for Table {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::LightCyan);
        screen.text(30, 6, texts::EXACT_TITLE.of(language), Color::Black);
        page(screen, TOP);
        COMMANDS.draw(screen, language);
        let Area { x1, y1, x2, y2 } = TABLE;
        panel(screen, x1, y1, x2 - x1, y2 - y1);
        let first = self.first();
        for column in first..(first + SEEN).min(self.columns.len()) {
            let name = crate::figure::wrap(&self.columns[column].0, LETTERS);
            for (y, line) in [y1 + 8, y1 + 19].into_iter().zip(name) {
                screen.text(self.cell_area([column, 0]).x1, y, &line, Color::Black);
            }
            for row in 0..3 {
                let area = self.cell_area([column, row]);
                window(screen, area);
                let text: String = self.cells[column][row].to_string().chars().take(LETTERS).collect();
                let ink = if self.chosen == [column, row] { Color::Yellow } else { Color::White };
                screen.text(area.x1 + 4, area.y1 + 4, &text, ink);
            }
        }
        for (row, axis) in (0..).zip(["x", "y", "z"]) {
            screen.text(x1 + 8, y1 + 36 + 21 * row, axis, Color::Black);
        }
        let last = (first + SEEN).min(self.columns.len());
        let count = self.columns.len();
        let chosen = self.columns.get(self.chosen[0]).map_or("", |(name, _)| name);
        let seen = format!("{} {}-{last} / {count}:  {chosen}", texts::COLUMNS.of(language), first + 1);
        screen.text(x1, y2 + 12, &seen, Color::Black);
        let formulas = match (&self.item, self.coefficients()) {
            (Item::Curve(curve), Coefficients::Curve { coefficients, .. }) => {
                curve_formulas(&curve.space, &coefficients)
            }
            (Item::Patch(patch), Coefficients::Surface { coefficients, .. }) => {
                patch_formulas(&patch.space_u, &patch.space_v, &coefficients)
            }
            _ => Vec::new(),
        };
        let lines = formulas.iter().flat_map(|formula| crate::figure::wrap(formula, 72));
        let mut y = y2 + 34;
        for text in lines.take(22) {
            screen.text(x1, y, &text, Color::Black);
            y += 12;
        }
        self.preview.draw(screen, Area::new(x1, y + 8, x2, BOTTOM));
        if let Some(entry) = &self.entry {
            entry.draw(screen);
        }
    }
}

/// Shows the dialog until the description is taken; Esc leaves everything as it was.
///
/// # Errors
/// [`Stop`]: Esc, or the display is being closed.
pub(super) async fn edit(studio: &mut Studio, desk: &mut Desk<'_>) -> Asked<()> {
    let Some(item) = studio.item().cloned() else { return Ok(()) };
    let mut table = Table::new(&item);
    let mut seen = None;
    loop {
        if seen.as_ref() != Some(&table.cells) {
            let new = studio.bases.described(&table.coefficients()).ok();
            table.preview = Preview::new(&item, new, studio.eye, &mut studio.bases);
            seen = Some(table.cells.clone());
        }
        let arrows = [Key::Left, Key::Right, Key::Up, Key::Down];
        let request = match table.entry {
            Some(_) => Request::Text,
            None => Request::Keys(COMMANDS.keys().into_iter().chain(arrows).collect()),
        };
        let tick = desk.event_asked(&table, request).await?;
        if table.entry.is_some() {
            if let Some(key) = tick.key() {
                table.type_key(desk, key);
            }
            continue;
        }
        if let Some(cell) = tick.click().and_then(|at| table.cell_under(at)) {
            table.chosen = cell;
            continue;
        }
        if let Some(command) = COMMANDS.find(&tick) {
            if carry_out(studio, desk, &mut table, command).await.unless_cancelled()? == Some(true) {
                return Ok(());
            }
            continue;
        }
        let page_step = SEEN as isize;
        match tick.key() {
            Some(Key::Esc) => return Err(Stop::Cancelled),
            Some(Key::Left) => table.move_by(-1, 0),
            Some(Key::Right | Key::Tab) => table.move_by(1, 0),
            Some(Key::Up) => table.move_by(0, -1),
            Some(Key::Down) => table.move_by(0, 1),
            Some(Key::PageUp) => table.move_by(-page_step, 0),
            Some(Key::PageDown) => table.move_by(page_step, 0),
            Some(Key::Enter) => table.open(None),
            Some(Key::Char(letter @ ('0'..='9' | '-' | '.' | '(' | 'p' | 's' | 'e'))) => {
                table.open(Some(letter));
            }
            _ => {}
        }
    }
}

async fn carry_out(studio: &mut Studio, desk: &mut Desk<'_>, table: &mut Table, command: Do) -> Asked<bool> {
    match command {
        Do::Change => table.open(None),
        Do::Clear => table.cells.iter_mut().for_each(|cell| *cell = Default::default()),
        Do::Update => match studio.describe(&table.coefficients()) {
            Ok(()) => return Ok(true),
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        },
        Do::Load => {
            let name = studio.ask_file(desk).await?;
            match studio.read_file(desk, &name) {
                Ok(EcDocument::Coefficients(coefficients)) => match taken(table, &coefficients) {
                    Ok(()) => {}
                    Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
                },
                Ok(_) => desk.tell(texts::NO_DOCUMENT, Stay::UntilRead),
                Err(problem) => desk.tell(problem, Stay::UntilRead),
            }
        }
        Do::Save => {
            let document = EcDocument::Coefficients(table.coefficients());
            super::files::store(studio, desk, document).await?;
        }
    }
    Ok(false)
}

/// Takes up coefficients of a file; those of another kind, or of functions that are not there, are refused.
fn taken(table: &mut Table, coefficients: &Coefficients) -> Result<(), EcError> {
    let mut fresh = Table { cells: vec![Default::default(); table.columns.len()], ..Table::new(&table.item) };
    let dimension = table.columns.len();
    let terms: Vec<([usize; 2], [Real; 3])> = match (coefficients, &table.item) {
        (Coefficients::Curve { coefficients, .. }, Item::Curve(_)) => {
            coefficients.iter().map(|term| ([term.function, 0], term.value.clone())).collect()
        }
        (Coefficients::Surface { coefficients, .. }, Item::Patch(_)) => {
            coefficients.iter().map(|term| ([term.u, term.v], term.value.clone())).collect()
        }
        _ => return Err(EcError::Function { given: dimension, dimension }),
    };
    for (functions, value) in terms {
        if !fresh.columns.iter().any(|(_, own)| *own == functions) {
            return Err(EcError::Function { given: functions[0].max(functions[1]), dimension });
        }
        fresh.put(functions, &value);
    }
    table.cells = fresh.cells;
    Ok(())
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!(super::COMMANDS.shared_keys(), []);
        assert_eq!(super::COMMANDS.too_wide(), [""; 0]);
    }
}
