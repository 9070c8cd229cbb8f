//! A ring or a drawer held by the mouse: it turns or slides with it, move by move.

use super::picture::{CENTRE, HALF, STEP, Slide, on_arm_of};
use crate::puzzle::wheel::{ARMS, Move, Wheel};

/// What is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Grip {
    Ring(usize),
    /// The drawer of an arm, with all that moves on its diameter.
    Drawer(usize),
}

/// How far the mouse may stray in a click.
const CLICK: i32 = 4;
/// Where the rings end and the drawers begin, and as far as a drawer goes out.
const RINGS_END: f64 = 112.0;
const DRAWERS_END: f64 = 216.0;

/// A held part of the wheel.
pub(crate) struct Hand {
    grip: Grip,
    pressed: (i32, i32),
    /// Whether the mouse has moved so far that this is no click.
    dragged: bool,
    /// The direction of the mouse at the last look, in degrees.
    direction: f64,
    /// The wheel with the moves that the drag has made.
    pub(crate) wheel: Wheel,
    moves: Vec<Move>,
    /// Degrees or pixels beyond those moves.
    beyond: f64,
}

/// Distance from the centre and direction in degrees.
fn polar((x, y): (i32, i32)) -> (f64, f64) {
    let (right, up) = (f64::from(x - CENTRE.0), f64::from(CENTRE.1 - y));
    (right.hypot(up), up.atan2(right).to_degrees())
}

/// The push of an arm's drawer, from 1.
fn push(arm: usize) -> Move {
    Move::ALL[(arm + ARMS - 1) % ARMS]
}

/// The turns of a ring, counter-clockwise and clockwise.
const TURNS: [[Move; 2]; 3] = [[Move::I, Move::J], [Move::K, Move::L], [Move::M, Move::N]];

impl Hand {
    /// What is at a pixel, if it can be held. A drawer is held anywhere on its way, so that after a click the pointer
    /// is where the next click pushes it again.
    pub(crate) fn new(wheel: Wheel, at: (i32, i32)) -> Option<Hand> {
        let (far, direction) = polar(at);
        let grip = if far < HALF {
            return None;
        } else if far < RINGS_END {
            Grip::Ring(((far / STEP).round() as usize).clamp(1, TURNS.len()))
        } else {
            let arm = (1..=ARMS).find(|&arm| {
                let (along, aside) = on_arm_of(arm, at);
                (0.0..DRAWERS_END).contains(&along) && aside.abs() <= HALF
            })?;
            Grip::Drawer(arm)
        };
        Some(Hand { grip, pressed: at, dragged: false, direction, wheel, moves: Vec::new(), beyond: 0.0 })
    }

    /// Turns or slides towards the mouse as far as the rules allow.
    pub(crate) fn follow(&mut self, at: (i32, i32)) {
        let (dx, dy) = (at.0 - self.pressed.0, at.1 - self.pressed.1);
        self.dragged |= dx.abs() > CLICK || dy.abs() > CLICK;
        match self.grip {
            Grip::Ring(ring) => {
                let (far, direction) = polar(at);
                // At the very centre a pixel is half a turn.
                if far < HALF / 2.0 {
                    return;
                }
                let turned = (direction - self.direction + 540.0).rem_euclid(360.0) - 180.0;
                self.direction = direction;
                self.beyond += turned;
                let [left, right] = TURNS[(ring + TURNS.len() - 1) % TURNS.len()];
                while self.beyond > 30.0 && self.make(left) {
                    self.beyond -= 60.0;
                }
                while self.beyond < -30.0 && self.make(right) {
                    self.beyond += 60.0;
                }
            }
            Grip::Drawer(arm) => {
                let inwards = on_arm_of(arm, self.pressed).0 - on_arm_of(arm, at).0;
                let (pushes, pulls) = (push(arm), push(arm + ARMS / 2));
                let made = |moves: &[Move]| match moves.first() {
                    Some(&first) if first == pushes => moves.len() as f64,
                    Some(_) => -(moves.len() as f64),
                    None => 0.0,
                };
                while inwards - STEP * made(&self.moves) > STEP / 2.0 && self.make(pushes) {}
                while inwards - STEP * made(&self.moves) < -STEP / 2.0 && self.make(pulls) {}
                let room = |a_move| if self.wheel.allows(a_move) { STEP / 2.0 } else { 0.0 };
                self.beyond = (inwards - STEP * made(&self.moves)).clamp(-room(pulls), room(pushes));
            }
        }
    }

    /// Makes a move, or takes its inverse back; whether it was possible.
    fn make(&mut self, a_move: Move) -> bool {
        let Some(wheel) = self.wheel.after(a_move) else { return false };
        self.wheel = wheel;
        match self.moves.last() {
            Some(last) if *last == a_move.inverse() => {
                self.moves.pop();
            }
            _ => self.moves.push(a_move),
        }
        true
    }

    /// How the held part is shown beyond the moves that are made.
    pub(crate) fn slide(&self) -> Slide {
        match self.grip {
            _ if !self.dragged => Slide::None,
            Grip::Ring(ring) => Slide::Ring(ring, self.beyond),
            Grip::Drawer(arm) => Slide::Diameter(arm, self.beyond),
        }
    }

    /// The moves of the drag; a click on a drawer is a push.
    pub(crate) fn moves(self) -> Vec<Move> {
        match self.grip {
            Grip::Drawer(arm) if !self.dragged => vec![push(arm)],
            _ => self.moves,
        }
    }
}
