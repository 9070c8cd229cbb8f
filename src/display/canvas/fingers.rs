//! Fingers as a mouse: a tap is a click, a drag is a drag, a long press is the right button. Two fingers turn, as the right
//! button does, and their distance is the wheel.
//!
//! A finger that has come down means nothing yet: it may be the first of two. It becomes a pressed button when it moves, is
//! lifted, or has stayed.

use crate::machine::{Button, Event};

/// What a finger does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It comes down.
    Down,
    /// It moves.
    Move,
    /// It is lifted.
    Up,
    /// The browser has taken it away.
    Cancel,
}

/// How far a finger trembles, in pixels of style sheets.
const TREMBLE: f64 = 8.0;
/// How long a finger stays for the right button, in milliseconds.
const LONG: f64 = 500.0;
/// By what factor the distance of two fingers is a notch of the wheel: four notches are twice the distance.
const NOTCH: f64 = 1.189;

/// A finger on the canvas, and where it came down.
#[derive(Clone, Copy, Debug)]
struct Finger {
    id: i32,
    at: (f64, f64),
    from: (f64, f64),
}

/// What the fingers are doing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Doing {
    #[default]
    Nothing,
    /// One is down since this moment.
    Waiting(f64),
    /// One holds a button.
    Holding(Button),
    /// Two are down: the distance at the last notch, and whether they turn already.
    Two { notch: f64, turning: bool },
    /// The rest of a gesture of two: nothing until all are lifted.
    Over,
}

/// The fingers on a canvas. Places are in pixels of style sheets, times in milliseconds; `pixel` gives the pixel of the
/// picture at a place.
#[derive(Clone, Debug, Default)]
pub struct Fingers {
    down: Vec<Finger>,
    doing: Doing,
}

fn distance(one: (f64, f64), other: (f64, f64)) -> f64 {
    (one.0 - other.0).hypot(one.1 - other.1)
}

impl Fingers {
    /// When a finger that stays becomes the right button.
    #[must_use]
    pub fn due(&self) -> Option<f64> {
        match self.doing {
            Doing::Waiting(since) => Some(since + LONG),
            _ => None,
        }
    }

    /// What a finger does, as events of a mouse.
    pub fn event(
        &mut self,
        (id, phase): (i32, Phase),
        at: (f64, f64),
        now: f64,
        pixel: impl Fn((f64, f64)) -> (i32, i32),
    ) -> Vec<Event> {
        let mut events = self.late(now, &pixel);
        let moved = |at| {
            let (x, y) = pixel(at);
            Event::Move(x, y)
        };
        match phase {
            Phase::Down => {
                self.down.retain(|finger| finger.id != id);
                self.down.push(Finger { id, at, from: at });
                events.extend(let_go(self.doing));
                self.doing = match self.down.as_slice() {
                    [_] => {
                        events.push(moved(at));
                        Doing::Waiting(now)
                    }
                    [one, other] => Doing::Two { notch: distance(one.at, other.at).max(1.0), turning: false },
                    _ => Doing::Over,
                };
                if let [one, other] = self.down.as_mut_slice() {
                    (one.from, other.from) = (one.at, other.at);
                }
            }
            Phase::Move => {
                let Some(finger) = self.down.iter_mut().find(|finger| finger.id == id) else { return events };
                finger.at = at;
                let from = finger.from;
                match self.doing {
                    Doing::Waiting(_) if distance(from, at) > TREMBLE => {
                        events.extend([moved(from), Event::Press(Button::Left), moved(at)]);
                        self.doing = Doing::Holding(Button::Left);
                    }
                    Doing::Holding(_) => events.push(moved(at)),
                    Doing::Two { notch, turning } => events.extend(self.both(notch, turning, moved)),
                    _ => {}
                }
            }
            Phase::Up | Phase::Cancel => {
                let before = self.down.len();
                self.down.retain(|finger| finger.id != id);
                if before == self.down.len() {
                    return events;
                }
                match self.doing {
                    Doing::Waiting(_) if phase == Phase::Up => {
                        events.extend([moved(at), Event::Press(Button::Left), Event::Release(Button::Left)]);
                    }
                    Doing::Holding(_) if phase == Phase::Up => {
                        events.push(moved(at));
                        events.extend(let_go(self.doing));
                    }
                    doing => events.extend(let_go(doing)),
                }
                self.doing = if self.down.is_empty() { Doing::Nothing } else { Doing::Over };
            }
        }
        events
    }

    /// The right button of a finger that has stayed.
    pub fn late(&mut self, now: f64, pixel: impl Fn((f64, f64)) -> (i32, i32)) -> Vec<Event> {
        let (Some(due), [finger]) = (self.due(), self.down.as_slice()) else { return Vec::new() };
        if now < due {
            return Vec::new();
        }
        self.doing = Doing::Holding(Button::Right);
        let (x, y) = pixel(finger.at);
        vec![Event::Move(x, y), Event::Press(Button::Right)]
    }

    /// Lifts all fingers: what they do from now on happens elsewhere.
    pub fn lift(&mut self) -> Vec<Event> {
        self.down.clear();
        let_go(std::mem::take(&mut self.doing)).into_iter().collect()
    }

    /// Two fingers: their middle turns, their distance is the wheel.
    fn both(&mut self, notch: f64, turning: bool, moved: impl Fn((f64, f64)) -> Event) -> Vec<Event> {
        let [one, other] = self.down.as_slice() else { return Vec::new() };
        let middle = |one: (f64, f64), other: (f64, f64)| ((one.0 + other.0) / 2.0, (one.1 + other.1) / 2.0);
        let (from, at) = (middle(one.from, other.from), middle(one.at, other.at));
        let mut events = Vec::new();
        let apart = distance(one.at, other.at).max(1.0);
        let steps = (apart / notch).log(NOTCH).trunc();
        let turns = turning || distance(from, at) > 2.0 * TREMBLE;
        if turns && !turning {
            events.extend([moved(from), Event::Press(Button::Right)]);
        }
        if turns || steps != 0.0 {
            events.push(moved(at));
        }
        if steps != 0.0 {
            // The conversion saturates.
            events.push(Event::Wheel(steps as i32));
        }
        self.doing = Doing::Two { notch: notch * NOTCH.powf(steps), turning: turns };
        events
    }
}

/// The release of what is held.
fn let_go(doing: Doing) -> Option<Event> {
    match doing {
        Doing::Holding(button) => Some(Event::Release(button)),
        Doing::Two { turning: true, .. } => Some(Event::Release(Button::Right)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Button::{Left, Right};
    use Event::{Move, Press, Release, Wheel};
    use proptest::prelude::*;

    fn pixel((x, y): (f64, f64)) -> (i32, i32) {
        (x as i32, y as i32)
    }

    fn play(steps: &[(i32, Phase, (f64, f64), f64)]) -> Vec<Event> {
        let mut fingers = Fingers::default();
        steps.iter().flat_map(|&(id, phase, at, now)| fingers.event((id, phase), at, now, pixel)).collect()
    }

    #[test]
    fn a_tap_is_a_click_and_a_drag_a_drag() {
        let tap = play(&[(1, Phase::Down, (10.0, 20.0), 0.0), (1, Phase::Up, (12.0, 20.0), 90.0)]);
        assert_eq!(tap, [Move(10, 20), Move(12, 20), Press(Left), Release(Left)]);
        let drag = play(&[
            (1, Phase::Down, (10.0, 20.0), 0.0),
            (1, Phase::Move, (12.0, 20.0), 10.0),
            (1, Phase::Move, (40.0, 20.0), 20.0),
            (1, Phase::Up, (50.0, 20.0), 90.0),
        ]);
        assert_eq!(
            drag,
            [Move(10, 20), Move(10, 20), Press(Left), Move(40, 20), Move(50, 20), Release(Left)]
        );
    }

    #[test]
    fn a_long_press_is_the_right_button() {
        let mut fingers = Fingers::default();
        fingers.event((1, Phase::Down), (10.0, 20.0), 0.0, pixel);
        assert_eq!(fingers.due(), Some(LONG));
        assert_eq!(fingers.late(LONG - 1.0, pixel), []);
        assert_eq!(fingers.late(LONG, pixel), [Move(10, 20), Press(Right)]);
        assert_eq!(fingers.event((1, Phase::Move), (60.0, 20.0), 600.0, pixel), [Move(60, 20)]);
        assert_eq!(fingers.event((1, Phase::Up), (60.0, 20.0), 700.0, pixel), [Move(60, 20), Release(Right)]);
    }

    #[test]
    fn two_fingers_turn_and_zoom() {
        let both = play(&[
            (1, Phase::Down, (100.0, 100.0), 0.0),
            (2, Phase::Down, (200.0, 100.0), 20.0),
            (2, Phase::Move, (300.0, 100.0), 40.0),
            (1, Phase::Up, (100.0, 100.0), 60.0),
            (2, Phase::Move, (400.0, 100.0), 80.0),
            (2, Phase::Up, (400.0, 100.0), 90.0),
        ]);
        assert_eq!(
            both,
            [Move(100, 100), Move(150, 100), Press(Right), Move(200, 100), Wheel(4), Release(Right)]
        );
    }

    #[test]
    fn a_second_finger_ends_a_drag() {
        let drag = play(&[
            (1, Phase::Down, (100.0, 100.0), 0.0),
            (1, Phase::Move, (150.0, 100.0), 5.0),
            (2, Phase::Down, (200.0, 100.0), 20.0),
        ]);
        assert_eq!(drag, [Move(100, 100), Move(100, 100), Press(Left), Move(150, 100), Release(Left)]);
    }

    proptest! {
        /// Whatever fingers do, presses and releases come in turn, and when all are lifted nothing is held.
        #[test]
        fn buttons_go_down_and_up_in_turn(
            steps in prop::collection::vec((0i32..4, 0u8..4, -50.0f64..900.0, -50.0f64..900.0, 0.0f64..700.0), 0..60),
        ) {
            let mut fingers = Fingers::default();
            let (mut now, mut held) = (0.0, None);
            let mut events = Vec::new();
            for (id, phase, x, y, later) in steps {
                now += later;
                let phase = [Phase::Down, Phase::Move, Phase::Up, Phase::Cancel][usize::from(phase)];
                events.extend(fingers.event((id, phase), (x, y), now, pixel));
            }
            events.extend(fingers.lift());
            for event in events {
                match event {
                    Press(button) => {
                        prop_assert_eq!(held, None);
                        held = Some(button);
                    }
                    Release(button) => {
                        prop_assert_eq!(held, Some(button));
                        held = None;
                    }
                    _ => {}
                }
            }
            prop_assert_eq!(held, None);
        }
    }
}
