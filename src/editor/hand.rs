//! What the keyboard and the wheel do in the manner of today: Tab chooses a handle and the arrows move it (1.5.1);
//! a letter keeps it to an axis of space; potentiometers turn parameters (1.5.2).

use super::lens::{Held, Lens};
use super::values::Values;
use super::{Craft, Editor};
use crate::geometry::Point;
use crate::machine::{Button, Event, Key, Manner, Modifier, Tick};
use crate::screen::Screen;
use crate::ui::{Area, Desk, Slider, Stay};

/// A potentiometer in the picture: a value that is shown, with its track beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dial {
    pub(crate) slider: Slider,
    /// Where the value stands; the wheel turns it there.
    pub(crate) text: Area,
    pub(crate) value: f64,
}

impl Dial {
    /// A potentiometer for a value of so many letters at a place, with its track so many pixels below.
    pub(crate) fn new((x, y): (i32, i32), letters: i32, below: i32, value: f64, of: Values) -> Dial {
        let track = (x + 2, x + 8 * letters - 4, y + below);
        let Values { allowed, track: range, step } = of;
        Dial { slider: Slider { range, allowed, step, track }, text: Area::of_line((x, y), letters), value }
    }

    fn holds(&self, (x, y): (i32, i32)) -> bool {
        self.text.holds(x, y) || self.slider.area().holds(x, y)
    }

    /// Draws its track and knob.
    pub(crate) fn draw(&self, screen: &mut Screen) {
        self.slider.draw(screen, Some(self.value), true);
    }
}

/// What is being turned.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Turning {
    /// The potentiometer that the mouse holds, and where it stands.
    pub(crate) held: Option<(usize, f64)>,
    /// The potentiometer that keys turn: the one turned last.
    last: usize,
    /// The row of keys or turns that one undo takes back.
    row: Option<Row>,
}

/// A row of events that change the same thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Row {
    Dial(usize),
    Nudges,
}

impl<C: Craft<D>, const D: usize> Editor<C, D> {
    /// Forgets what the keyboard or a potentiometer had taken up.
    pub(super) fn let_hand_go(&mut self) {
        (self.picked, self.axis) = (None, None);
        self.turning = Turning::default();
    }

    /// Forgets the chosen handle if a command has changed the value, since it may mean another one then.
    pub(super) fn forget_changed(&mut self, before: &C::Value) {
        if self.picked.is_some() && self.history.now() != before {
            self.let_hand_go();
        }
    }

    /// Takes up an event for a potentiometer or the chosen handle; returns whether it was for one.
    pub(super) fn turns_by_hand(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        if self.manner != Manner::Today {
            return false;
        }
        self.turns_dial(desk, tick) || self.moves_picked(tick)
    }

    fn turns_dial(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        let at = self.mouse;
        if let Some((dial, to)) = self.turning.held {
            let turned = C::dials(self).get(dial).map(|dial| dial.slider.value_at(at.0));
            match tick.event {
                Some(Event::Move(..)) => self.turning.held = Some((dial, turned.unwrap_or(to))),
                Some(Event::Release(Button::Left)) => {
                    let value = self.preview();
                    self.turning.held = None;
                    self.reshape(desk, value);
                }
                Some(Event::Key(Key::Esc)) => self.turning.held = None,
                _ if !tick.mouse.holds(Button::Left) => self.turning.held = None,
                _ => {}
            }
            return true;
        }
        let dials = C::dials(self);
        let under = || dials.iter().position(|dial| dial.holds(at));
        let (dial, steps) = match (tick.event, tick.key()) {
            (Some(Event::Press(Button::Left)), _) => {
                let on = |dial: &Dial| dial.slider.area().holds(at.0, at.1) && !dial.text.holds(at.0, at.1);
                let Some(dial) = dials.iter().position(on) else { return false };
                let to = dials.get(dial).map_or(0.0, |dial| dial.slider.value_at(at.0));
                self.turning = Turning { held: Some((dial, to)), last: dial, row: None };
                return true;
            }
            (Some(Event::Wheel(steps)), _) => (under(), f64::from(steps)),
            (_, Some(Key::Up)) => (under(), 1.0),
            (_, Some(Key::Down)) => (under(), -1.0),
            (_, Some(Key::PageUp)) => (Some(self.turning.last), 1.0),
            (_, Some(Key::PageDown)) => (Some(self.turning.last), -1.0),
            _ => return false,
        };
        let Some((dial, found)) = dial.and_then(|dial| Some((dial, dials.get(dial)?))) else { return false };
        let fine = if tick.mouse.with(Modifier::Shift) { 0.1 } else { 1.0 };
        let to = found.slider.stepped(found.value, fine * steps);
        let value = C::dialled(self, dial, to);
        self.turning.last = dial;
        self.in_row(Row::Dial(dial), value);
        match C::problem(self) {
            Some(problem) => desk.tell(problem, Stay::Briefly),
            None => C::reshaped(self, desk),
        }
        true
    }

    /// Commits a value; those of one row are one change.
    fn in_row(&mut self, row: Row, value: C::Value) {
        if self.turning.row == Some(row) {
            self.history.amend(value);
            return;
        }
        // What changes nothing begins no row: the next step must be one that can be undone.
        self.turning.row = (value != *self.history.now()).then_some(row);
        self.history.change(value);
    }

    /// Tab and the arrows. Any other event but a movement of the mouse ends the row of changes.
    fn moves_picked(&mut self, tick: &Tick) -> bool {
        let Some(event) = tick.event else { return false };
        let Event::Key(key) = event else {
            // Shift only makes the steps of a row longer or shorter.
            if !matches!(event, Event::Move(..) | Event::Hold(..)) {
                self.turning.row = None;
            }
            return false;
        };
        let taken = self.craft.commands().of_key(key).is_some();
        let step = if tick.mouse.with(Modifier::Shift) { 10 } else { 1 };
        let by = match key {
            Key::Tab if !taken => return self.picks_next(tick.mouse.with(Modifier::Shift)),
            Key::Esc if self.picked.is_some() => {
                self.let_hand_go();
                return true;
            }
            Key::Left => (-step, 0),
            Key::Right => (step, 0),
            Key::Up => (0, step),
            Key::Down => (0, -step),
            key if !taken && self.picked.is_some() && self.keeps_axis(key) => return true,
            _ => {
                self.turning.row = None;
                return false;
            }
        };
        let Some(handle) = self.picked else { return false };
        let Some(from) = C::place(self.history.now(), handle) else {
            self.let_hand_go();
            return false;
        };
        let at = self.lens.nudged(from, by, self.axis);
        let moved = C::moved(self.history.now(), handle, at);
        if moved != *self.history.now() {
            self.in_row(Row::Nudges, moved);
            C::changed(self);
        }
        true
    }

    /// Chooses the next handle, or the one before.
    fn picks_next(&mut self, back: bool) -> bool {
        let handles = C::handles(self);
        let now = self.picked.and_then(|picked| handles.iter().position(|handle| *handle == picked));
        let next = match (now, back) {
            (Some(now), false) => now + 1,
            (Some(now), true) => now.wrapping_sub(1),
            (None, false) => 0,
            (None, true) => handles.len().wrapping_sub(1),
        };
        (self.axis, self.turning.row) = (None, None);
        self.picked = handles.get(next).copied();
        !handles.is_empty()
    }

    /// Keeps to the axis of the letter X, Y or Z, or, if it does already, to none; returns whether it is such a letter
    /// and this is space.
    pub(super) fn keeps_axis(&mut self, key: Key) -> bool {
        let axis = key.letter().and_then(|letter| ['X', 'Y', 'Z'].iter().position(|axis| *axis == letter));
        if D < 3 || axis.is_none() || self.manner != Manner::Today {
            return false;
        }
        self.axis = axis.filter(|_| self.axis != axis);
        true
    }

    /// The place of a held handle at the mouse, on its axis if it keeps to one.
    pub(super) fn dragged_to(&self, held: &Held<C::Handle, D>) -> Option<Point<D>> {
        match self.axis {
            Some(axis) => self.lens.dragged_along(held, self.mouse, axis),
            None => C::dragged(self, held, self.mouse),
        }
    }
}
