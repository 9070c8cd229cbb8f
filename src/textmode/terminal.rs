//! Pages in a terminal.

use super::{Doing, TextEvent, TextProgram};
use crate::display::terminal::{LineEvent, Lines, TerminalError};
use std::time::Duration;

/// The longest sleep, which limits the delay of anything that does not wake the display.
const LONGEST_SLEEP: Duration = Duration::from_secs(1);

/// Runs a program in the terminal until it has ended. Ctrl+C closes it. The terminal is restored on return, error or
/// panic.
///
/// # Errors
/// [`TerminalError`] if there is no terminal, if it disappears, or if a signal ends the process. The program has then
/// been told that it is being closed.
pub fn in_terminal(program: &mut dyn TextProgram) -> Result<(), TerminalError> {
    let shown = Lines::open().and_then(|mut lines| run(program, &mut lines));
    if shown.is_err() {
        program.event(TextEvent::Close);
    }
    shown
}

fn run(program: &mut dyn TextProgram, lines: &mut Lines) -> Result<(), TerminalError> {
    loop {
        let page = program.page();
        let mut area = ratatui::layout::Rect::default();
        lines.draw(|frame| {
            area = frame.area();
            page.draw(area, frame.buffer_mut());
        })?;
        let patience = match program.doing() {
            Doing::Ended => return Ok(()),
            Doing::Waiting => LONGEST_SLEEP,
            Doing::Working => {
                program.work();
                Duration::ZERO
            }
        };
        for told in lines.events(patience)? {
            match told {
                LineEvent::Key(key) => program.event(TextEvent::Key(key)),
                LineEvent::Wheel(steps) => program.event(TextEvent::Wheel(steps)),
                LineEvent::Close => program.event(TextEvent::Close),
                LineEvent::Click(column, row) => {
                    // The click belongs to the page that was visible, not to one that an earlier event has opened.
                    if let Some(hit) = page.hit(area, column, row) {
                        program.event(TextEvent::Click(hit));
                    }
                }
            }
        }
    }
}
