//! The smallest display in a window, by the library minifb: for systems on which the one in `window` does not build, and
//! to see how little a display is. `--display minifb` asks for it, in a build with the feature `minifb`.
//!
//! minifb tells the state of things whenever it is asked, which is every [`POLL`]. Keys come through a callback, and none
//! is lost. Everything else has limits, which is why this is not the usual window:
//!
//! - A click that is shorter than [`POLL`] is missed, and so are all notches of the wheel but one.
//! - Closing cannot be taken back. A program that would ask about unsaved work is ended, and its work is kept as after a
//!   crash ([`End::Closed`]): the next start offers it.
//! - The size of the desktop is unknown: the window has that of the picture, or its scale. F11 does not fill the desktop.
//! - On Windows, Ctrl goes by the letters of an American keyboard. On Wayland the window comes by way of X11.

use super::desktop::{WindowError, checked_scale};
use super::{Display, clock::Clock, layout::Layout};
use crate::machine::{Button, Event, Key, Modifier, Session};
use crate::screen::{HEIGHT, Palette, Screen, WIDTH};
use minifb::{Key as Named, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};
use std::sync::mpsc::{self, Receiver, Sender};
use std::time::Duration;

/// The time from one question to the next: short for hands, long for a processor.
pub const POLL: Duration = Duration::from_millis(8);

/// The window is painted after this time even if the picture has not changed: minifb does not tell that it was covered.
const REPAINT: Duration = Duration::from_millis(250);

/// How a session ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The program ended.
    Ended,
    /// The window was closed, and the program had something to ask yet.
    Closed,
}

/// Runs a session in a window until its program has ended or the window is closed.
///
/// # Errors
/// [`WindowError`] when the window cannot be opened or painted.
pub fn run(session: &mut Session, title: &str, scale: Option<u32>) -> Result<End, WindowError> {
    let mut front = Front::open(title, checked_scale(scale)?.unwrap_or(1))?;
    while !session.ended() {
        let due = front.step(session)?;
        front.pass_on(session);
        if !front.window.is_open() {
            session.send(Event::Close, front.now());
            return Ok(if session.ended() { End::Ended } else { End::Closed });
        }
        let left = due.map_or(POLL, |due| due.saturating_sub(front.now()));
        std::thread::sleep(left.min(POLL));
    }
    Ok(End::Ended)
}

/// What there is to be seen, when it was painted, and what is held.
struct Front {
    clock: Clock,
    window: Window,
    title: String,
    told: Receiver<Told>,
    keys: Keys,
    pixels: Vec<u32>,
    shown: Option<(Screen, Palette, Layout, Duration)>,
}

impl Front {
    fn open(title: &str, scale: u32) -> Result<Front, WindowError> {
        let size = [WIDTH, HEIGHT].map(|side| side as usize * scale as usize);
        let scale_mode = ScaleMode::UpperLeft;
        let options = WindowOptions { resize: true, scale_mode, ..WindowOptions::default() };
        let window = Window::new(title, size[0], size[1], options);
        let mut window = window.map_err(|error| WindowError::Open(reason(error)))?;
        let (teller, told) = mpsc::channel();
        window.set_input_callback(Box::new(Listener(teller)));
        // The time between two questions is kept by `run`, so that a deadline is met.
        window.set_target_fps(0);
        // The picture has a pointer of its own.
        window.set_cursor_visibility(false);
        let (clock, title, keys) = (Clock::start(), title.to_owned(), Keys::default());
        Ok(Front { clock, window, title, told, keys, pixels: Vec::new(), shown: None })
    }

    /// Passes on what the last question has brought.
    fn pass_on(&mut self, session: &mut Session) {
        if !self.window.is_active() {
            // Another window hears of the keys that are let go now.
            self.keys = Keys::default();
            self.send(session, Event::Hold(Modifier::Ctrl, false));
            self.send(session, Event::Hold(Modifier::Shift, false));
        }
        while let Ok(told) = self.told.try_recv() {
            self.keys.event(&told).into_iter().for_each(|event| self.send(session, event));
        }
        if let Some((x, y)) = self.window.get_unscaled_mouse_pos(MouseMode::Pass) {
            let layout = Layout::of(self.window.get_size(), session.look());
            let (x, y) = (f64::from(x), f64::from(y));
            // Outside of the window the mouse is the program's business only while it drags.
            if layout.holds(x, y) || session.mouse().down.contains(&true) {
                let at = layout.pixel_at(x, y);
                self.send(session, Event::Move(at.0, at.1));
            }
        }
        for button in [Button::Left, Button::Right, Button::Middle] {
            let down = self.window.get_mouse_down(match button {
                Button::Left => MouseButton::Left,
                Button::Right => MouseButton::Right,
                Button::Middle => MouseButton::Middle,
            });
            self.send(session, if down { Event::Press(button) } else { Event::Release(button) });
        }
        if let Some((_, turned)) = self.window.get_scroll_wheel().filter(|(_, turned)| *turned != 0.0) {
            self.send(session, Event::Wheel(if turned > 0.0 { 1 } else { -1 }));
        }
    }

    /// Sends an event that tells something new.
    fn send(&self, session: &mut Session, event: Event) {
        let mouse = session.mouse();
        let known = match event {
            Event::Move(x, y) => (mouse.x, mouse.y) == (x, y),
            Event::Press(button) => mouse.holds(button),
            Event::Release(button) => !mouse.holds(button),
            Event::Hold(modifier, down) => mouse.with(modifier) == down,
            _ => false,
        };
        if !known {
            session.send(event, self.now());
        }
    }
}

impl Display for Front {
    type Error = WindowError;

    fn now(&self) -> Duration {
        self.clock.now()
    }

    /// Shows the picture, and asks what has happened.
    fn show(&mut self, session: &Session) -> Result<(), WindowError> {
        let (picture, palette, layout) =
            (session.picture(), session.palette(), Layout::of(self.window.get_size(), session.look()));
        let now = self.now();
        let same = self.shown.as_ref().is_some_and(|(shown, in_colors, placed, painted)| {
            (shown, *in_colors, *placed) == (&picture, palette, layout) && now < *painted + REPAINT
        });
        if same {
            self.window.update();
            return Ok(());
        }
        let (width, height) = layout.window;
        self.window.set_title(&session.title(&self.title));
        self.pixels.resize(width * height, 0);
        layout.paint(&picture, palette, &mut self.pixels);
        self.shown = Some((picture, palette, layout, now));
        let painted = self.window.update_with_buffer(&self.pixels, width, height);
        painted.map_err(|error| WindowError::Paint(reason(error)))
    }
}

/// What the library tells by itself: keys and whether they are down, and what they type.
enum Told {
    Key(Named, bool),
    Typed(char),
}

struct Listener(Sender<Told>);

impl minifb::InputCallback for Listener {
    fn add_char(&mut self, code: u32) {
        // After the end nobody listens.
        let _ = char::from_u32(code).map(|typed| self.0.send(Told::Typed(typed)));
    }

    fn set_key_state(&mut self, key: Named, down: bool) {
        let _ = self.0.send(Told::Key(key, down));
    }
}

/// The keys that change what other keys mean, as they are held.
#[derive(Default)]
struct Keys {
    ctrl: bool,
    alt: bool,
    command: bool,
}

impl Keys {
    fn event(&mut self, told: &Told) -> Option<Event> {
        // Some systems report AltGr, which types characters, as Ctrl and Alt together.
        let ctrl = self.ctrl && !self.alt || cfg!(target_os = "macos") && self.command;
        let (key, down) = match *told {
            Told::Typed(typed) if typed.is_control() || ctrl || self.command => return None,
            Told::Typed(typed) => return Some(Event::Key(Key::Char(typed))),
            Told::Key(key, down) => (key, down),
        };
        let held = match key {
            Named::LeftShift | Named::RightShift => return Some(Event::Hold(Modifier::Shift, down)),
            Named::LeftCtrl | Named::RightCtrl => &mut self.ctrl,
            Named::LeftAlt | Named::RightAlt => &mut self.alt,
            Named::LeftSuper | Named::RightSuper => &mut self.command,
            key => return pressed(key, ctrl).filter(|_| down).map(Event::Key),
        };
        *held = down;
        Some(Event::Hold(Modifier::Ctrl, self.ctrl))
    }
}

/// The key of a program that a key is; none for one that types a character. Most have the names that scripts use.
fn pressed(key: Named, ctrl: bool) -> Option<Key> {
    let name = format!("{key:?}").replace("Escape", "Esc");
    match Key::from_name(name.trim_start_matches("Key").trim_start_matches("NumPad"))? {
        Key::F(number) if ctrl => Some(Key::CtrlF(number)),
        Key::Char(letter) if ctrl && letter.is_ascii_alphanumeric() => Some(Key::Ctrl(letter)),
        Key::Char(_) => None,
        named => Some(named),
    }
}

/// What the library says, without saying that it failed.
fn reason(error: minifb::Error) -> String {
    let text = error.to_string();
    text.split_once(": ").map_or(text.clone(), |(_, what)| what.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_follow_the_layout_and_ctrl_makes_commands() {
        let events = |told: &[Told]| -> Vec<Event> {
            let mut keys = Keys::default();
            told.iter().filter_map(|told| keys.event(told)).collect()
        };
        let down = |key| Told::Key(key, true);
        let named = [Named::F10, Named::NumPadEnter, Named::Escape, Named::PageUp, Named::Space].map(down);
        assert_eq!(events(&named), [Key::F(10), Key::Enter, Key::Esc, Key::PageUp].map(Event::Key));
        assert_eq!(
            events(&[down(Named::Y), Told::Typed('z'), Told::Typed('\u{8}')]),
            [Event::Key(Key::Char('z'))]
        );
        let (ctrl, held) = (Named::LeftCtrl, Event::Hold(Modifier::Ctrl, true));
        let keys = [Key::Ctrl('Z'), Key::Ctrl('1'), Key::CtrlF(2)].map(Event::Key);
        let told = [ctrl, Named::Z, Named::Key1, Named::F2].map(down);
        assert_eq!(events(&told), [&[held], &keys[..]].concat());
        let alt_gr = [down(ctrl), down(Named::RightAlt), Told::Typed('@')];
        assert_eq!(events(&alt_gr), [held, held, Event::Key(Key::Char('@'))]);
    }
}
