//! The display in a terminal: the terminal's own graphics where it has them (Kitty's protocol, Sixel),
//! else block characters with the program's texts as real characters.
//!
//! The display sleeps until a key, the mouse or the session's deadline, and writes only what changed.
//! What the mouse does, the keyboard does too ([`POINTER_KEYS`](crate::machine::POINTER_KEYS)); Ctrl+C is the close button.

mod answers;
pub mod blocks;
mod graphics;
mod input;
mod lines;
mod place;
mod tty;

pub use lines::{LineEvent, Lines};
pub use tty::Signals;

use super::Display;
use super::clock::Clock;
use crate::machine::{Event, Glyphs, Key, Language, Pointing, Session};
use crate::screen::{Palette, Screen};
use blocks::{Blocks, Depth};
use crossterm::event::Event as TerminalEvent;
use graphics::Part;
use input::Input;
use place::{Extent, LEAST, Place};
use std::io;
use std::time::{Duration, Instant};
use tty::{Told, Tty};

/// What can go wrong with a terminal.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TerminalError {
    /// Input or output is no terminal.
    #[error(
        "there is no terminal to show the program in; start it in one, without redirecting its input or output"
    )]
    NoTerminal,
    /// The terminal is gone or does not do what it is told; the system's own message.
    #[error("the terminal is lost: {0}")]
    Lost(String),
    /// The process was asked to end by a signal.
    #[error("the program was stopped by signal {0}")]
    Stopped(u8),
}

impl From<io::Error> for TerminalError {
    fn from(error: io::Error) -> TerminalError {
        TerminalError::Lost(error.to_string())
    }
}

/// The most that is sent in a second, in bytes: lines are shared, and what they buffer comes late.
const MOST_SENT: f64 = 200.0 * 1024.0;

/// The longest sleep, so that nothing that fails to wake the display is missed for long.
const LONGEST_SLEEP: Duration = Duration::from_secs(1);

/// Runs a session in the terminal until its program has ended. Ctrl+C reaches the program as
/// [`Event::Close`]. The terminal is as it was before when this returns, fails or panics.
///
/// # Errors
/// [`TerminalError`] when there is no terminal, it goes away, or a signal ends the process.
pub fn run(session: &mut Session) -> Result<(), TerminalError> {
    let tty = Tty::open()?;
    let mut view = View::new(&tty)?;
    session.set_pointing(Pointing::Keys);
    while !session.ended() {
        let due = view.step(session)?;
        let Told { events, paused } = tty.events(view.sleep(due))?;
        if paused {
            view.resume(session)?;
        }
        let (events, now) = (view.events(session, events)?, view.now());
        events.into_iter().for_each(|event| session.send(event, now));
    }
    Ok(())
}

/// How the picture is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Kitty(Place),
    Sixel(Place),
    Blocks(Place),
    /// Not at all, for want of room.
    TooSmall,
}

impl Style {
    fn of(tty: &Tty, extent: Extent) -> Style {
        let graphics = Place::of_graphics(extent);
        match (graphics, Place::of_blocks(extent)) {
            (Some(place), _) if tty.answers.kitty => Style::Kitty(place.in_whole_cells()),
            (Some(place), _) if tty.answers.sixel => Style::Sixel(place),
            (_, Some(place)) => Style::Blocks(place),
            (_, None) => Style::TooSmall,
        }
    }

    fn place(self) -> Option<Place> {
        match self {
            Style::Kitty(place) | Style::Sixel(place) | Style::Blocks(place) => Some(place),
            Style::TooSmall => None,
        }
    }

    /// The shortest time from one picture to the next: graphics are long to send and to draw.
    fn pace(self) -> Duration {
        Duration::from_millis(match self {
            Style::Kitty(_) => 33,
            Style::Sixel(_) => 50,
            Style::Blocks(_) | Style::TooSmall => 16,
        })
    }
}

/// What the terminal shows now.
enum Shown {
    Nothing,
    /// With Kitty's graphics.
    Picture(Screen),
    /// With Sixel: the colour numbers of the scaled picture.
    Pixels(Vec<u8>),
    Cells(blocks::Picture),
    /// The message on the size, in a language, and whether leaving waits for an answer.
    Message(Language, bool),
}

/// A session as a terminal shows it.
struct View<'t> {
    tty: &'t Tty,
    clock: Clock,
    extent: Extent,
    style: Style,
    depth: Depth,
    /// The characters that the terminal can be trusted with.
    glyphs: Glyphs,
    palette: Palette,
    input: Input,
    shown: Shown,
    shown_at: Option<Instant>,
    /// How long the last picture keeps the line busy at the most that is sent.
    busy: Duration,
    /// A picture came too soon after the one before to be shown.
    late: bool,
    /// The terminal's size changed and what it shows is undefined.
    redraw: bool,
    /// The program was asked to end where the terminal is too small to show what it asks.
    leaving: bool,
}

impl<'t> View<'t> {
    fn new(tty: &'t Tty) -> Result<View<'t>, TerminalError> {
        let variable = |name| std::env::var(name).unwrap_or_default();
        let extent = tty.extent()?;
        Ok(View {
            tty,
            clock: Clock::start(),
            extent,
            style: Style::of(tty, extent),
            depth: Depth::of(&variable("COLORTERM"), &variable("TERM"), !variable("NO_COLOR").is_empty()),
            glyphs: tty.answers.glyphs(
                &variable("TERM"),
                ["LC_ALL", "LC_CTYPE", "LANG"].map(variable).each_ref().map(String::as_str),
            ),
            palette: Palette::default(),
            input: Input::new(tty.answers.pixel_mouse),
            shown: Shown::Nothing,
            shown_at: None,
            busy: Duration::ZERO,
            late: false,
            redraw: true,
            leaving: false,
        })
    }

    /// When the next picture may be shown.
    fn next(&self) -> Option<Instant> {
        self.shown_at.and_then(|moment| moment.checked_add(self.style.pace().max(self.busy)))
    }

    fn ready(&self) -> bool {
        self.redraw || self.next().is_none_or(|moment| moment <= Instant::now())
    }

    fn sleep(&self, due: Option<Duration>) -> Duration {
        let wanted = [due.and_then(|due| self.clock.at(due)), self.next().filter(|_| self.late)];
        let until = wanted.into_iter().flatten().min();
        until.map_or(LONGEST_SLEEP, |moment| {
            moment.saturating_duration_since(Instant::now()).min(LONGEST_SLEEP)
        })
    }

    /// What the terminal told, as events of the program.
    fn events(&mut self, session: &Session, told: Vec<TerminalEvent>) -> Result<Vec<Event>, TerminalError> {
        let mut events: Vec<Event> = Vec::new();
        let mut at = (session.mouse().x, session.mouse().y);
        for told in told {
            match told {
                TerminalEvent::Key(key) if input::pauses(key) => self.tty.pause(),
                TerminalEvent::Key(key) => events.extend(self.input.key(key, at, session.pointer_speed())),
                TerminalEvent::Mouse(mouse) => {
                    if let Some(place) = self.style.place() {
                        let spots = match &self.shown {
                            Shown::Cells(picture) => picture.spots.as_slice(),
                            _ => &[],
                        };
                        let (moved, what) = self.input.mouse(mouse, (place, spots), self.extent);
                        if moved != Event::Move(at.0, at.1) {
                            events.push(moved);
                        }
                        events.extend(what);
                    }
                }
                TerminalEvent::Resize(..) => self.resize()?,
                _ => {}
            }
            if let Some(&Event::Move(x, y)) = events.iter().rfind(|event| matches!(event, Event::Move(..))) {
                at = (x, y);
            }
        }
        if self.style == Style::TooSmall {
            // Nobody should act on what cannot be seen; leaving is always possible.
            events.retain(|event| matches!(event, Event::Close | Event::Key(Key::Esc)));
            for event in &mut events {
                *event = Event::Close;
                self.leaving = true;
            }
        } else {
            self.leaving = false;
        }
        Ok(only_last_moves(&events))
    }

    /// Goes on after a pause in which others have used the terminal.
    fn resume(&mut self, session: &mut Session) -> Result<(), TerminalError> {
        self.resize()?;
        self.redraw = true;
        let now = self.now();
        self.input.let_go().for_each(|event| session.send(event, now));
        Ok(())
    }

    fn resize(&mut self) -> Result<(), TerminalError> {
        let extent = self.tty.extent()?;
        if extent != self.extent {
            self.extent = extent;
            self.style = Style::of(self.tty, extent);
            self.redraw = true;
        }
        Ok(())
    }

    fn paint(&mut self, session: &Session) -> Result<(), TerminalError> {
        let mut frame = Vec::new();
        if self.palette != session.palette() {
            self.palette = session.palette();
            self.redraw = true;
        }
        if std::mem::take(&mut self.redraw) {
            if matches!(self.shown, Shown::Picture(_)) {
                frame.extend_from_slice(graphics::kitty_delete().as_bytes());
            }
            frame.extend_from_slice(b"\x1b[0m\x1b[2J");
            self.shown = Shown::Nothing;
        }
        match self.style {
            Style::Kitty(place) => self.show_kitty(session, place, &mut frame)?,
            Style::Sixel(place) => self.show_sixel(session, place, &mut frame),
            Style::Blocks(place) => self.show_blocks(session, place, &mut frame),
            Style::TooSmall => self.show_message(session.language(), &mut frame),
        }
        if !frame.is_empty() {
            self.tty.write(&frame)?;
            self.shown_at = Some(Instant::now());
            self.busy = Duration::from_secs_f64(frame.len() as f64 / MOST_SENT);
        }
        Ok(())
    }

    fn show_kitty(
        &mut self,
        session: &Session,
        place: Place,
        frame: &mut Vec<u8>,
    ) -> Result<(), TerminalError> {
        let picture = session.picture();
        if matches!(&self.shown, Shown::Picture(shown) if *shown == picture) {
            return Ok(());
        }
        let image = graphics::kitty(&picture, self.palette, place)
            .map_err(|error| TerminalError::Lost(error.to_string()))?;
        frame.extend_from_slice(go_to(place.column, place.row).as_bytes());
        frame.extend_from_slice(&image);
        self.shown = Shown::Picture(picture);
        Ok(())
    }

    fn show_sixel(&mut self, session: &Session, place: Place, frame: &mut Vec<u8>) {
        let pixels = graphics::scaled(&session.picture(), (place.width, place.height));
        let before = match &self.shown {
            Shown::Pixels(before) => Some(before.as_slice()),
            _ => None,
        };
        if let Some(part) = changed(before, &pixels, place) {
            // The part begins at the corner of a cell, and there are fewer cells than 16 bits count.
            let column = place.column + (part.left / usize::from(place.cell.0)) as u16;
            let row = place.row + (part.top / usize::from(place.cell.1)) as u16;
            frame.extend_from_slice(go_to(column, row).as_bytes());
            frame.extend_from_slice(&graphics::sixel(&pixels, self.palette, place.width, part));
        }
        self.shown = Shown::Pixels(pixels);
    }

    fn show_blocks(&mut self, session: &Session, place: Place, frame: &mut Vec<u8>) {
        let pointer = session.pointer().map(|(_, x, y)| (x, y));
        let blocks = Blocks::at(place, session.glyphs().unwrap_or(self.glyphs));
        let picture = blocks.picture(&session.marked_screen(), pointer);
        let before = match &self.shown {
            Shown::Cells(before) => Some(before.cells.as_slice()),
            _ => None,
        };
        let written = blocks::difference(before, &picture.cells, place, (self.depth, self.palette));
        frame.extend_from_slice(written.as_bytes());
        self.shown = Shown::Cells(picture);
    }

    fn show_message(&mut self, language: Language, frame: &mut Vec<u8>) {
        if matches!(self.shown, Shown::Message(shown, leaving) if (shown, leaving) == (language, self.leaving))
        {
            return;
        }
        let lines = too_small(language, self.extent, self.leaving);
        let top = self.extent.rows.saturating_sub(lines.len() as u16) / 2;
        frame.extend_from_slice(b"\x1b[0m\x1b[2J");
        for (row, line) in (top..).zip(&lines) {
            let length = u16::try_from(line.chars().count()).unwrap_or(u16::MAX);
            let column = self.extent.columns.saturating_sub(length) / 2;
            frame.extend_from_slice(go_to(column, row).as_bytes());
            let visible: String = line.chars().take(usize::from(self.extent.columns)).collect();
            frame.extend_from_slice(visible.as_bytes());
        }
        self.shown = Shown::Message(language, self.leaving);
    }
}

impl Display for View<'_> {
    type Error = TerminalError;

    fn now(&self) -> Duration {
        self.clock.now()
    }

    fn show(&mut self, session: &Session) -> Result<(), TerminalError> {
        self.late = !self.ready();
        if self.late { Ok(()) } else { self.paint(session) }
    }
}

fn too_small(language: Language, extent: Extent, leaving: bool) -> [String; 3] {
    let Extent { columns, rows, .. } = extent;
    let (least_columns, least_rows) = LEAST;
    match language {
        Language::Hungarian => [
            format!("A terminál {columns}x{rows} karakteres."),
            format!("Legalább {least_columns}x{least_rows} kell."),
            match leaving {
                true => "Kilépés előtt kérdés van: nagyítsa meg",
                false => "Nagyítsa meg, vagy vissza: Esc",
            }
            .to_string(),
        ],
        Language::English => [
            format!("The terminal is {columns}x{rows}."),
            format!("At least {least_columns}x{least_rows} is needed."),
            match leaving {
                true => "There is a question before the end: enlarge it",
                false => "Enlarge it, or Esc goes back",
            }
            .to_string(),
        ],
    }
}

fn go_to(column: u16, row: u16) -> String {
    format!("\x1b[{};{}H", u32::from(row) + 1, u32::from(column) + 1)
}

/// The events without the moves that are followed by another move.
fn only_last_moves(events: &[Event]) -> Vec<Event> {
    let moves = |event: Option<&Event>| matches!(event, Some(Event::Move(..)));
    let kept =
        events.iter().enumerate().filter(|&(at, event)| !(moves(Some(event)) && moves(events.get(at + 1))));
    kept.map(|(_, &event)| event).collect()
}

/// The smallest part of whole cells that holds every change; the whole picture when nothing is shown.
fn changed(before: Option<&[u8]>, after: &[u8], place: Place) -> Option<Part> {
    let (width, height) = (place.width.max(1), place.height);
    let whole = Part { left: 0, top: 0, right: place.width, bottom: height };
    let Some(before) = before.filter(|before| before.len() == after.len()) else { return Some(whole) };
    let mut part: Option<Part> = None;
    for (y, (old, new)) in before.chunks(width).zip(after.chunks(width)).enumerate() {
        let differs = |(old, new): (&u8, &u8)| old != new;
        let Some(first) = old.iter().zip(new).position(differs) else { continue };
        let last = old.iter().zip(new).rposition(differs).unwrap_or(first);
        let known = part.unwrap_or(Part { left: first, top: y, right: last, bottom: y });
        part = Some(Part {
            left: known.left.min(first),
            top: known.top,
            right: known.right.max(last + 1),
            bottom: y + 1,
        });
    }
    let (across, down) = (usize::from(place.cell.0.max(1)), usize::from(place.cell.1.max(1)));
    part.map(|part| Part {
        left: part.left / across * across,
        top: part.top / down * down,
        right: part.right.next_multiple_of(across).min(place.width),
        bottom: part.bottom.next_multiple_of(down).min(height),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Button;

    #[test]
    fn a_move_before_a_press_is_kept() {
        let (a, b) = (Event::Move(1, 1), Event::Move(2, 2));
        let press = Event::Press(Button::Left);
        assert_eq!(only_last_moves(&[a, b, press, a, b]), [b, press, b]);
    }

    #[test]
    fn the_changed_part_is_made_of_whole_cells() {
        let place = Place { column: 0, row: 0, width: 640, height: 480, cell: (10, 20) };
        let before = vec![0; 640 * 480];
        let mut after = before.clone();
        assert_eq!(changed(Some(&before), &after, place), None);
        after[45 * 640 + 123] = 1;
        after[61 * 640 + 119] = 1;
        let part = Part { left: 110, top: 40, right: 130, bottom: 80 };
        assert_eq!(changed(Some(&before), &after, place), Some(part));
        let whole = Part { left: 0, top: 0, right: 640, bottom: 480 };
        assert_eq!(changed(None, &after, place), Some(whole));
    }

    #[test]
    fn the_message_says_what_is_needed() {
        let extent = Extent { columns: 40, rows: 20, cell: None };
        for leaving in [false, true] {
            let message = too_small(Language::Hungarian, extent, leaving).join(" ");
            assert!(message.contains("40x20") && message.contains("60x20"), "{message}");
        }
    }
}
