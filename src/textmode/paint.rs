//! Pages on the 640x480 screen: 80 columns and 30 rows of cells of 8x16 pixels.

use super::page::Page;
use super::{Doing, TextEvent, TextProgram};
use crate::machine::{Asked, Event, Machine};
use crate::screen::{Color, HEIGHT, Screen, WIDTH, glyph};
use ratatui::buffer::{Buffer, Cell};
use ratatui::layout::Rect;
use ratatui::style::{Color as Ink, Modifier};

/// Columns of a page on the screen.
pub const COLUMNS: u16 = (WIDTH / CELL.0) as u16;
/// Rows of a page on the screen.
pub const ROWS: u16 = (HEIGHT / CELL.1) as u16;

/// Width and height of a cell in pixels.
const CELL: (i32, i32) = (8, 16);
/// Distance of a letter from the upper edge of its cell in pixels.
const LETTER: i32 = 4;

const AREA: Rect = Rect { x: 0, y: 0, width: COLUMNS, height: ROWS };

/// Runs a program on a machine until it has ended.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed; the program has been told so.
pub async fn on_machine(machine: &mut Machine, program: &mut dyn TextProgram) -> Asked<()> {
    loop {
        let page = program.page();
        machine.set_language(page.language);
        paint(&page, machine.screen());
        let told = match program.doing() {
            Doing::Ended => return Ok(()),
            Doing::Waiting => machine.event().await,
            Doing::Working => {
                program.work();
                machine.frame().await
            }
        };
        let tick = match told {
            Ok(tick) => tick,
            Err(quit) => {
                program.event(TextEvent::Close);
                return Err(quit);
            }
        };
        if let Some(key) = tick.key() {
            program.event(TextEvent::Key(key));
        }
        if let Some(Event::Wheel(steps)) = tick.event {
            program.event(TextEvent::Wheel(steps));
        }
        if let Some((x, y)) = tick.click() {
            // The mouse stays on the screen, so its cell fits into 16 bits.
            let at = (x.clamp(0, WIDTH - 1) / CELL.0, y.clamp(0, HEIGHT - 1) / CELL.1);
            if let Some(hit) = page.hit(AREA, at.0 as u16, at.1 as u16) {
                program.event(TextEvent::Click(hit));
            }
        }
    }
}

/// Paints a page over the whole screen.
fn paint(page: &Page, screen: &mut Screen) {
    let mut cells = Buffer::empty(AREA);
    page.draw(AREA, &mut cells);
    screen.clear(Color::Black);
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            if let Some(cell) = cells.cell((column, row)) {
                paint_cell(cell, i32::from(column) * CELL.0, i32::from(row) * CELL.1, screen);
            }
        }
    }
}

fn paint_cell(cell: &Cell, x: i32, y: i32, screen: &mut Screen) {
    let (mut ink, mut paper) = (color(cell.fg, Color::LightGray), color(cell.bg, Color::Black));
    if cell.modifier.contains(Modifier::REVERSED) {
        std::mem::swap(&mut ink, &mut paper);
    }
    screen.bar(x, y, x + CELL.0 - 1, y + CELL.1 - 1, paper);
    match cell.symbol().chars().next() {
        None | Some(' ') => {}
        // Frames must have no gaps, so each row of their letters is two pixels high.
        Some(frame @ '\u{2500}'..='\u{259F}') => {
            let rows = glyph(frame).unwrap_or([0xFF; 8]);
            for (line, bits) in (y..y + CELL.1).zip(rows.iter().flat_map(|bits| [bits, bits])) {
                let pixels = (0..8).map(|bit| (bits >> (7 - bit) & 1 == 1).then_some(ink));
                screen.row(x, line, pixels);
            }
        }
        Some(_) => screen.text(x, y + LETTER, cell.symbol(), ink),
    }
}

/// The colour of the screen for a colour of the terminal.
fn color(wanted: Ink, default: Color) -> Color {
    match wanted {
        Ink::Black => Color::Black,
        Ink::Red => Color::Red,
        Ink::Green => Color::Green,
        Ink::Yellow => Color::Yellow,
        Ink::Blue => Color::Blue,
        Ink::Magenta => Color::Magenta,
        Ink::Cyan => Color::Cyan,
        Ink::Gray => Color::LightGray,
        Ink::DarkGray => Color::DarkGray,
        Ink::LightRed => Color::LightRed,
        Ink::LightGreen => Color::LightGreen,
        Ink::LightYellow => Color::Yellow,
        Ink::LightBlue => Color::LightBlue,
        Ink::LightMagenta => Color::LightMagenta,
        Ink::LightCyan => Color::LightCyan,
        Ink::White => Color::White,
        _ => default,
    }
}

#[cfg(test)]
mod tests {
    use super::super::page::tests::example;
    use super::*;

    #[test]
    fn frames_meet_and_letters_are_letters() {
        let mut screen = Screen::new();
        paint(&example(10, 3), &mut screen);
        // The left line of the list's frame has no gaps.
        let line = |y| (0..8).filter(|&x| screen.pixel(x, y) == Some(Color::LightGray)).count();
        assert!((40..440).all(|y| line(y) >= 2));
        let text: String = screen.texts().iter().map(|text| text.string().replace(' ', "")).collect();
        assert!(text.contains("TITLE") && text.contains("marked1"), "{text}");
        assert_eq!((COLUMNS, ROWS), (80, 30));
    }
}
