//! Explanations on the help page: lines of text, and tables of operations on colours, drawn by these operations.

use super::words::{self, Words};
use crate::machine::Language;
use crate::screen::{Color, Masks, Put, Screen, Stroke};

/// A piece of the explanation under the keys of the help page.
#[derive(Clone, Copy, Debug)]
pub enum Lesson {
    /// One line of text, at most 70 letters.
    Line(Words),
    /// The table of an operation (chapter 1.2): a row for each colour on the screen, a column for each colour of the
    /// bitmap, and the resulting colour in the cell. Tables are drawn side by side.
    Operation(Put),
    /// The table of the mouse driver's two masks (chapter 1.4): a row for each pair of mask bits, a column for each
    /// colour on the screen.
    Pointer,
    /// The images of two masks beside that table, a white cell for a bit of 1, and their words under it.
    Masks(&'static Masks),
}

/// Height of a line of text in pixels.
const LINE: i32 = 12;
/// Left edge of the page's text.
const LEFT: i32 = 40;
/// Horizontal distance of tables.
const TABLE: i32 = 260;
/// Side of a table's cell in pixels.
const CELL: i32 = 8;
/// Distance between the headings of a table and its cells.
const GAP: i32 = 4;
/// Cells of a row.
const COLORS: i32 = 16;
/// Where the images of masks are, from the left edge of the table beside them, and how far from each other.
const IMAGES: [i32; 2] = [420, 80];
/// Side of a mask's bit in pixels.
const BIT: i32 = 4;
/// Words of a mask in a line.
const WORDS: usize = 8;

/// The height of an explanation with the room above it.
pub(super) fn height(lesson: &[Lesson]) -> i32 {
    let table = 2 * GAP + LINE + CELL + GAP;
    let lines = lesson.iter().filter(|piece| matches!(piece, Lesson::Line(_))).count();
    let tables = lesson.iter().map(|piece| match piece {
        Lesson::Line(_) => 0,
        Lesson::Operation(_) => table + COLORS * CELL,
        Lesson::Pointer => table + 4 * LINE,
        Lesson::Masks(_) => table + 4 * LINE + 4 * LINE,
    });
    let room = if lesson.is_empty() { 0 } else { 2 * GAP };
    room + LINE * i32::try_from(lines).unwrap_or(0) + tables.max().unwrap_or(0)
}

/// Draws an explanation from `top` down.
pub(super) fn draw(screen: &mut Screen, top: i32, lesson: &[Lesson], language: Language) {
    let (mut x, mut y) = (LEFT, top);
    // Tables stand a little below the text.
    let below = |y: i32| y + 2 * GAP;
    for piece in lesson {
        match piece {
            Lesson::Line(text) => {
                screen.text(LEFT, y, text.of(language), Color::LightCyan);
                y += LINE;
            }
            Lesson::Operation(put) => {
                operation(screen, (x, below(y)), *put, language);
                x += TABLE;
            }
            Lesson::Pointer => pointer(screen, (x, below(y)), language),
            Lesson::Masks(masks) => self::masks(screen, (x, below(y)), masks),
        }
    }
}

/// One cell of a table with its upper left corner at a place.
fn cell(screen: &mut Screen, x: i32, y: i32, color: Color) {
    screen.bar(x, y, x + CELL - 1, y + CELL - 1, color);
}

/// The sixteen colours with the numbers of their rows or columns.
fn colors() -> impl Iterator<Item = (i32, Color)> {
    (0..).zip(Color::ALL)
}

fn operation(screen: &mut Screen, (x, y): (i32, i32), put: Put, language: Language) {
    let name = match put {
        Put::Copy => "COPY",
        Put::Not => "NOT",
        Put::Or => "OR",
        Put::Xor => "XOR",
        Put::And => "AND",
    };
    frames(screen, (x, y));
    screen.text(x, y, name, Color::Yellow);
    screen.text(x + 40, y, words::LESSON_AXES.of(language), Color::LightGray);
    let (left, top) = (x + CELL + GAP, y + LINE + CELL + GAP);
    for (row, below) in colors() {
        cell(screen, x, top + CELL * row, below);
        cell(screen, left + CELL * row, y + LINE, below);
        for (column, above) in colors() {
            cell(screen, left + CELL * column, top + CELL * row, put.apply(below, above));
        }
    }
}

/// Lines around the headings and cells of an operation's table with its title at (x, y). They make black cells
/// visible.
fn frames(screen: &mut Screen, (x, y): (i32, i32)) {
    let gray = Stroke::thin(Color::DarkGray);
    let (left, top) = (x + CELL + GAP, y + LINE + CELL + GAP);
    let (right, bottom) = (left + COLORS * CELL, top + COLORS * CELL);
    screen.rectangle(left - 1, top - 1, right, bottom, gray);
    screen.rectangle(x - 1, top - 1, x + CELL, bottom, gray);
    row_frame(screen, left, y + LINE);
}

/// Lines around a row of sixteen cells.
fn row_frame(screen: &mut Screen, x: i32, y: i32) {
    screen.rectangle(x - 1, y - 1, x + COLORS * CELL, y + CELL, Stroke::thin(Color::DarkGray));
}

fn pointer(screen: &mut Screen, (x, y): (i32, i32), language: Language) {
    let left = x + 128;
    screen.text(x, y, words::LESSON_MASKS.of(language), Color::Yellow);
    let top = y + LINE + CELL + GAP;
    row_frame(screen, left, y + LINE);
    for (column, below) in colors() {
        cell(screen, left + CELL * column, y + LINE, below);
    }
    let rows = [
        (0, 0, words::LESSON_BLACK),
        (0, 1, words::LESSON_WHITE),
        (1, 0, words::LESSON_KEPT),
        (1, 1, words::LESSON_INVERSE),
    ];
    for (row, (kept, inverted, meaning)) in (0..).zip(rows) {
        let y = top + LINE * row;
        screen.text(x, y, &format!("{kept}       {inverted}"), Color::White);
        row_frame(screen, left, y);
        for (column, below) in colors() {
            cell(screen, left + CELL * column, y, Masks::apply(below, kept == 1, inverted == 1));
        }
        screen.text(left + CELL * COLORS + 16, y, meaning.of(language), Color::White);
    }
}

/// The images of masks beside the table whose title is at (x, y), and their words under it.
fn masks(screen: &mut Screen, (x, y): (i32, i32), masks: &Masks) {
    let under = y + LINE + CELL + GAP + 4 * LINE;
    for (number, (name, rows)) in (0..).zip([("AND", masks.screen), ("XOR", masks.cursor)]) {
        let (left, top) = (x + IMAGES[0] + number * IMAGES[1], y + LINE);
        screen.text(left, y, name, Color::Yellow);
        screen.rectangle(left - 1, top - 1, left + 16 * BIT, top + 16 * BIT, Stroke::thin(Color::DarkGray));
        for (row, word) in (0..).zip(rows) {
            for column in (0..16).filter(|column| word << column & 0x8000 != 0) {
                let (x, y) = (left + BIT * column, top + BIT * row);
                screen.bar(x, y, x + BIT - 1, y + BIT - 1, Color::White);
            }
        }
        for (line, words) in (0..).zip(rows.chunks(WORDS)) {
            let words: Vec<String> = words.iter().map(|word| format!("{word:04X}")).collect();
            let name = if line == 0 { name } else { "   " };
            screen.text(
                x,
                under + LINE * (2 * number + line),
                &format!("{name} {}", words.join(" ")),
                Color::White,
            );
        }
    }
}
