//! The terminal as it is, in lines of characters: for pages of a text mode, which are no pictures.

use super::TerminalError;
use super::input::{pauses, plain};
use super::tty::{Told, Tty};
use crate::machine::Key;
use crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEventKind};
use ratatui::backend::CrosstermBackend;
use ratatui::{Frame, Terminal};
use std::io::{Stdout, stdout};
use std::time::Duration;

/// What a terminal of lines tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineEvent {
    /// A key.
    Key(Key),
    /// A press of the left button on the cell of a column and a row, counted from 0.
    Click(u16, u16),
    /// The wheel, in steps; positive is away from the user.
    Wheel(i32),
    /// Ctrl+C.
    Close,
}

/// A terminal in lines; dropped, it is as before.
pub struct Lines {
    screen: Terminal<CrosstermBackend<Stdout>>,
    tty: Tty,
}

impl Lines {
    /// Takes the terminal.
    ///
    /// # Errors
    /// [`TerminalError`] when there is none, or it does not do what it is told.
    pub fn open() -> Result<Lines, TerminalError> {
        let tty = Tty::open_plain()?;
        let screen = Terminal::new(CrosstermBackend::new(stdout()))?;
        Ok(Lines { screen, tty })
    }

    /// Draws one frame and shows what has changed.
    ///
    /// # Errors
    /// [`TerminalError`] when the terminal is lost.
    pub fn draw(&mut self, draw: impl FnOnce(&mut Frame)) -> Result<(), TerminalError> {
        self.screen.draw(draw)?;
        Ok(())
    }

    /// What happened, at the latest after `longest` (then often nothing). A new size of the terminal ends the wait.
    ///
    /// # Errors
    /// [`TerminalError`] when the terminal is lost or a signal ends the process.
    pub fn events(&mut self, longest: Duration) -> Result<Vec<LineEvent>, TerminalError> {
        let Told { events, paused } = self.tty.events(longest)?;
        if paused {
            self.screen.clear()?;
        }
        // Pages of text have nothing to undo, so that the usual key pauses them too.
        let paused = |event: &Event| matches!(event, Event::Key(key) if pauses(*key) || undoes(*key));
        if events.iter().any(paused) {
            self.tty.pause();
        }
        Ok(events.into_iter().filter_map(told).collect())
    }
}

fn undoes(key: KeyEvent) -> bool {
    key.modifiers == KeyModifiers::CONTROL && matches!(key.code, KeyCode::Char('z' | 'Z'))
}

fn told(event: Event) -> Option<LineEvent> {
    match event {
        Event::Key(key) if key.kind != KeyEventKind::Release => {
            let ctrl = key.modifiers.contains(KeyModifiers::CONTROL);
            match key.code {
                KeyCode::Char('c' | 'C') if ctrl => Some(LineEvent::Close),
                // Ctrl and Alt together are how some systems tell AltGr, which types characters.
                KeyCode::Char(_) if ctrl != key.modifiers.contains(KeyModifiers::ALT) => None,
                code => plain(code).map(LineEvent::Key),
            }
        }
        Event::Mouse(mouse) => match mouse.kind {
            MouseEventKind::Down(MouseButton::Left) => Some(LineEvent::Click(mouse.column, mouse.row)),
            MouseEventKind::ScrollUp => Some(LineEvent::Wheel(1)),
            MouseEventKind::ScrollDown => Some(LineEvent::Wheel(-1)),
            _ => None,
        },
        _ => None,
    }
}
