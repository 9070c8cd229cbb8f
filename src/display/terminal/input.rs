//! Keys and mouse of a terminal as programs see them, and a mouse for those who have only keys.

use super::blocks::Spot;
use super::place::{Extent, Place};
use crate::machine::{Button, Event, Key, Modifier, PointerSpeed};
use crate::screen::{HEIGHT, WIDTH};
use crossterm::event::{
    KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEvent, MouseEventKind,
};

/// How far Ctrl and an arrow move the mouse at the least speed, in pixels: one letter.
const STRIDE: i32 = 8;

/// The keyboard and the mouse of a terminal.
#[derive(Clone, Debug, Default)]
pub(super) struct Input {
    /// Whether the mouse is told in pixels.
    pixel_mouse: bool,
    held: [Option<By>; 3],
    /// Whether Shift and Ctrl are down, as the mouse reports it.
    with: [bool; 2],
}

/// What holds a button down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    Mouse,
    Keyboard,
}

const BUTTONS: [Button; 3] = [Button::Left, Button::Right, Button::Middle];

impl Input {
    pub(super) fn new(pixel_mouse: bool) -> Input {
        Input { pixel_mouse, held: [None; 3], with: [false; 2] }
    }

    /// What a key means; `at` is where the mouse is.
    pub(super) fn key(&mut self, event: KeyEvent, at: (i32, i32), speed: PointerSpeed) -> Option<Event> {
        if event.kind == KeyEventKind::Release {
            return None;
        }
        let (ctrl, alt, shift) = (
            event.modifiers.contains(KeyModifiers::CONTROL),
            event.modifiers.contains(KeyModifiers::ALT),
            event.modifiers.contains(KeyModifiers::SHIFT),
        );
        let stride = match (ctrl || alt, shift) {
            (true, _) => Some(STRIDE * speed.letters()),
            (false, true) => Some(1),
            (false, false) => None,
        };
        if let (Some(stride), Some((right, down))) = (stride, arrow(event.code)) {
            let x = (at.0 + right * stride).clamp(0, WIDTH - 1);
            let y = (at.1 + down * stride).clamp(0, HEIGHT - 1);
            return Some(Event::Move(x, y));
        }
        match event.code {
            // Ctrl and Alt together are how some systems tell AltGr, which types characters.
            KeyCode::Char(typed) if ctrl && !alt => self.ctrl(typed),
            KeyCode::Char(typed) if alt && !ctrl => self.alt(typed),
            KeyCode::PageUp if alt => Some(Event::Wheel(1)),
            KeyCode::PageDown if alt => Some(Event::Wheel(-1)),
            KeyCode::Null => self.toggle(Button::Left),
            KeyCode::F(11) => None,
            KeyCode::F(number @ 1..=12) if ctrl => Some(Event::Key(Key::CtrlF(number))),
            code => plain(code).map(Event::Key),
        }
    }

    fn ctrl(&mut self, typed: char) -> Option<Event> {
        match typed {
            'c' | 'C' => Some(Event::Close),
            ' ' | '@' => self.toggle(Button::Left),
            typed if typed.is_ascii_alphanumeric() => Some(Event::Key(Key::Ctrl(typed.to_ascii_uppercase()))),
            _ => None,
        }
    }

    fn alt(&mut self, typed: char) -> Option<Event> {
        match typed {
            'l' | 'L' => self.toggle(Button::Left),
            'r' | 'R' => self.toggle(Button::Right),
            _ => None,
        }
    }

    fn toggle(&mut self, button: Button) -> Option<Event> {
        let held = &mut self.held[button as usize];
        *held = if held.is_some() { None } else { Some(By::Keyboard) };
        Some(if held.is_some() { Event::Press(button) } else { Event::Release(button) })
    }

    /// A press and its release always come in pairs, whatever the terminal leaves out: a second press ends the first.
    fn button(&mut self, button: Button, down: bool) -> Vec<Event> {
        let before = std::mem::replace(&mut self.held[button as usize], down.then_some(By::Mouse));
        let release = before.map(|_| Event::Release(button));
        release.into_iter().chain(down.then_some(Event::Press(button))).collect()
    }

    /// Lets go of the buttons that a mouse holds, whose release was lost.
    fn lost_releases(&mut self) -> Vec<Event> {
        let held = BUTTONS.into_iter().filter(|&button| self.held[button as usize] == Some(By::Mouse));
        let events: Vec<Event> = held.map(Event::Release).collect();
        self.held = self.held.map(|by| by.filter(|&by| by != By::Mouse));
        events
    }

    /// Lets go of every button.
    pub(super) fn let_go(&mut self) -> impl Iterator<Item = Event> + use<> {
        let held = std::mem::take(&mut self.held);
        BUTTONS.into_iter().filter(move |&button| held[button as usize].is_some()).map(Event::Release)
    }

    /// The modifiers that have gone down or up since the mouse was last heard of.
    fn modified(&mut self, now: KeyModifiers) -> Vec<Event> {
        let states = [(Modifier::Shift, KeyModifiers::SHIFT), (Modifier::Ctrl, KeyModifiers::CONTROL)];
        let changed = |(modifier, flag): (Modifier, KeyModifiers)| {
            let down = now.contains(flag);
            let before = std::mem::replace(&mut self.with[modifier as usize], down);
            (before != down).then_some(Event::Hold(modifier, down))
        };
        states.into_iter().filter_map(changed).collect()
    }

    /// Where the mouse is, and what it did there. `spots` are what the cells of the picture stand for, where it is
    /// made of cells.
    pub(super) fn mouse(
        &mut self,
        event: MouseEvent,
        (place, spots): (Place, &[Spot]),
        extent: Extent,
    ) -> (Event, Vec<Event>) {
        let (x, y) = (f64::from(event.column), f64::from(event.row));
        let (column, row) = match extent.cell.filter(|_| self.pixel_mouse) {
            Some((width, height)) => (x / f64::from(width), y / f64::from(height)),
            None => (x + 0.5, y + 0.5),
        };
        let spot = place.cell_at(column, row).and_then(|cell| spots.get(cell));
        let (x, y) =
            spot.map_or_else(|| place.pixel_at(column, row), |spot| spot.at(column.fract(), row.fract()));
        let what = match event.kind {
            MouseEventKind::Down(which) => self.button(button(which), true),
            MouseEventKind::Up(which) => self.button(button(which), false),
            MouseEventKind::ScrollUp => vec![Event::Wheel(1)],
            MouseEventKind::ScrollDown => vec![Event::Wheel(-1)],
            // Without a button; a drag has its button.
            MouseEventKind::Moved => self.lost_releases(),
            _ => Vec::new(),
        };
        let what = self.modified(event.modifiers).into_iter().chain(what).collect();
        (Event::Move(x, y), what)
    }
}

/// Whether a key asks for a pause. Ctrl+Z undoes.
pub(super) fn pauses(event: KeyEvent) -> bool {
    let both = KeyModifiers::CONTROL | KeyModifiers::ALT;
    event.kind != KeyEventKind::Release
        && event.modifiers.contains(both)
        && matches!(event.code, KeyCode::Char('z' | 'Z'))
}

fn arrow(code: KeyCode) -> Option<(i32, i32)> {
    match code {
        KeyCode::Left => Some((-1, 0)),
        KeyCode::Right => Some((1, 0)),
        KeyCode::Up => Some((0, -1)),
        KeyCode::Down => Some((0, 1)),
        _ => None,
    }
}

fn button(button: MouseButton) -> Button {
    match button {
        MouseButton::Left => Button::Left,
        MouseButton::Right => Button::Right,
        MouseButton::Middle => Button::Middle,
    }
}

/// The key of a program for a key of the terminal without Ctrl and Alt.
pub(super) fn plain(code: KeyCode) -> Option<Key> {
    Some(match code {
        KeyCode::Char(typed) if !typed.is_control() => Key::Char(typed),
        KeyCode::F(number @ 1..=12) => Key::F(number),
        KeyCode::Enter => Key::Enter,
        KeyCode::Esc => Key::Esc,
        KeyCode::Backspace => Key::Backspace,
        KeyCode::Tab | KeyCode::BackTab => Key::Tab,
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::Left => Key::Left,
        KeyCode::Right => Key::Right,
        KeyCode::Home => Key::Home,
        KeyCode::End => Key::End,
        KeyCode::PageUp => Key::PageUp,
        KeyCode::PageDown => Key::PageDown,
        KeyCode::Insert => Key::Insert,
        KeyCode::Delete => Key::Delete,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(input: &mut Input, code: KeyCode, modifiers: KeyModifiers) -> Option<Event> {
        input.key(KeyEvent::new(code, modifiers), (320, 240), PointerSpeed::default())
    }

    #[test]
    fn keys_of_programs() {
        let mut input = Input::default();
        for (code, modifiers, expected) in [
            (KeyCode::Char('ő'), KeyModifiers::NONE, Key::Char('ő')),
            (KeyCode::Char('A'), KeyModifiers::SHIFT, Key::Char('A')),
            (KeyCode::Char('@'), KeyModifiers::CONTROL | KeyModifiers::ALT, Key::Char('@')),
            (KeyCode::Char('z'), KeyModifiers::CONTROL, Key::Ctrl('Z')),
            (KeyCode::F(2), KeyModifiers::NONE, Key::F(2)),
            (KeyCode::F(2), KeyModifiers::CONTROL, Key::CtrlF(2)),
            (KeyCode::BackTab, KeyModifiers::SHIFT, Key::Tab),
            (KeyCode::Up, KeyModifiers::NONE, Key::Up),
        ] {
            assert_eq!(key(&mut input, code, modifiers), Some(Event::Key(expected)));
        }
        assert_eq!(key(&mut input, KeyCode::F(11), KeyModifiers::NONE), None);
        assert_eq!(key(&mut input, KeyCode::Char('c'), KeyModifiers::CONTROL), Some(Event::Close));
    }

    #[test]
    fn the_keyboard_does_what_a_mouse_does() {
        let mut input = Input::default();
        let moved = key(&mut input, KeyCode::Left, KeyModifiers::CONTROL);
        assert_eq!(moved, Some(Event::Move(312, 240)));
        assert_eq!(key(&mut input, KeyCode::Down, KeyModifiers::SHIFT), Some(Event::Move(320, 241)));
        let space = (KeyCode::Char(' '), KeyModifiers::CONTROL);
        assert_eq!(key(&mut input, space.0, space.1), Some(Event::Press(Button::Left)));
        assert_eq!(key(&mut input, space.0, space.1), Some(Event::Release(Button::Left)));
        assert_eq!(key(&mut input, KeyCode::PageDown, KeyModifiers::ALT), Some(Event::Wheel(-1)));
    }

    #[test]
    fn the_mouse_is_as_fine_as_the_terminal_tells() {
        let extent = Extent { columns: 80, rows: 30, cell: Some((10, 20)) };
        let place = Place::of_blocks(extent).unwrap();
        let press = MouseEvent {
            kind: MouseEventKind::Down(MouseButton::Left),
            column: 10,
            row: 5,
            modifiers: KeyModifiers::NONE,
        };
        let mut input = Input::default();
        let told = input.mouse(press, (place, &[]), extent);
        assert_eq!(told, (Event::Move(84, 88), vec![Event::Press(Button::Left)]));
        let mut input = Input::new(true);
        let told = input.mouse(MouseEvent { column: 105, row: 110, ..press }, (place, &[]), extent);
        assert_eq!(told.0, Event::Move(84, 88));
    }

    #[test]
    fn a_lost_release_leaves_no_button_held() {
        let extent = Extent { columns: 80, rows: 30, cell: None };
        let place = Place::of_blocks(extent).unwrap();
        let mut input = Input::default();
        let mut mouse = |kind| {
            let event = MouseEvent { kind, column: 10, row: 5, modifiers: KeyModifiers::NONE };
            input.mouse(event, (place, &[]), extent).1
        };
        let (press, release) = (Event::Press(Button::Left), Event::Release(Button::Left));
        assert_eq!(mouse(MouseEventKind::Down(MouseButton::Left)), [press]);
        assert_eq!(mouse(MouseEventKind::Drag(MouseButton::Left)), []);
        assert_eq!(mouse(MouseEventKind::Down(MouseButton::Left)), [release, press]);
        assert_eq!(mouse(MouseEventKind::Moved), [release]);
        assert_eq!(mouse(MouseEventKind::Up(MouseButton::Left)), []);
        // What the keyboard holds, the mouse moves.
        assert_eq!(key(&mut input, KeyCode::Char(' '), KeyModifiers::CONTROL), Some(press));
        let event =
            MouseEvent { kind: MouseEventKind::Moved, column: 1, row: 1, modifiers: KeyModifiers::NONE };
        assert_eq!(input.mouse(event, (place, &[]), extent).1, []);
        assert_eq!(input.let_go().collect::<Vec<_>>(), [release]);
    }
}
