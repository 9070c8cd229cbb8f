//! Pieces by mouse, wheel, keys and digits.

use super::super::hand::Hand;
use super::super::panel::FIELD;
use super::{Action, COMMANDS, DIGITS, Play, Player};
use crate::file::CsangoCube;
use crate::machine::{Asked, Button, Event, Key, Tick};
use crate::puzzle::cube;
use crate::puzzle::cube::{Move, PIECES};
use crate::ui::Desk;
use crate::work;
use crate::work::Next;

impl Player {
    /// Makes a move if it is allowed; returns whether it was.
    pub(super) fn make(&mut self, step: Move) -> bool {
        (self.refused, self.party) = (None, None);
        let cube = match self.plays.now().cube.after(step, self.rules) {
            Ok(cube) => cube,
            Err(why) => {
                self.refused = Some(why);
                return false;
            }
        };
        self.plan = self.plan.take().and_then(|plan| plan.after(step, cube));
        self.change(cube, 1);
        true
    }

    /// Commits another position, and adds to the number of moves.
    pub(super) fn change(&mut self, cube: CsangoCube, moves: u32) {
        self.hinted = false;
        self.clock.note(false, self.now);
        let play = *self.plays.now();
        let moves = play.moves.saturating_add(moves);
        let help = play.help.max(std::mem::take(&mut self.help));
        self.plays.change(Play { cube, moves, help, ..play });
    }

    pub(super) fn select(&mut self, piece: usize) {
        self.selected = piece % PIECES;
        self.hinted = false;
    }

    /// A digit chooses a piece; two digits choose one above 9.
    pub(super) fn digit(&mut self, digit: usize) {
        let before = self.digit.filter(|&(_, at)| self.now.saturating_sub(at) < DIGITS);
        let number = before.map(|(first, _)| 10 * first + digit).filter(|&number| number <= PIECES);
        let number = number.unwrap_or(digit);
        self.digit = Some((digit, self.now));
        if let Some(piece) = number.checked_sub(1) {
            self.select(piece);
        }
    }

    pub(super) fn mouse(&mut self, desk: &mut Desk<'_>, tick: &Tick) {
        let at = (tick.mouse.x, tick.mouse.y);
        match tick.event {
            Some(Event::Press(Button::Left)) if FIELD.holds(at.0, at.1) => {
                if let Some(piece) = self.scene().piece_at(at.0, at.1) {
                    self.select(piece);
                    self.hand = Hand::new(piece, at, self.plays.now().cube);
                }
            }
            Some(Event::Move(..)) => {
                if let Some(hand) = &mut self.hand {
                    hand.follow(at, self.eye);
                }
            }
            Some(Event::Wheel(steps)) => match &mut self.hand {
                Some(hand) => hand.lift(steps),
                None => self.lift(desk, steps),
            },
            Some(Event::Release(Button::Left)) => self.let_go(desk),
            _ => {}
        }
    }

    pub(super) fn lift(&mut self, desk: &mut Desk<'_>, steps: i32) {
        self.hand = Hand::new(self.selected, (0, 0), self.plays.now().cube);
        if let Some(hand) = &mut self.hand {
            hand.lift(steps);
        }
        self.let_go(desk);
    }

    /// Leaves a held piece where it is.
    pub(super) fn let_go(&mut self, desk: &mut Desk<'_>) {
        let Some(hand) = self.hand.take().filter(|hand| hand.cube != self.plays.now().cube) else { return };
        self.plan = None;
        (self.refused, self.party) = (None, None);
        self.change(hand.cube, hand.moves());
        self.look_whether_finished(desk);
    }

    /// What a key or its button does; what leads out of the configuration is told.
    pub(super) async fn key(&mut self, desk: &mut Desk<'_>, key: Key) -> Asked<Next> {
        if let Some(action) = key.letter().and_then(cube::Action::from_letter) {
            if self.make(Move { piece: self.selected, action }) {
                self.look_whether_finished(desk);
            }
            return Ok(Next::Work);
        }
        match COMMANDS.of_key(key) {
            Some(Action::Do(what)) => what(self, desk),
            Some(Action::Quit) => return work::quit(self, desk).await,
            None => {
                if let Some(digit) = key.letter().and_then(|typed| typed.to_digit(10)) {
                    self.digit(digit as usize);
                }
            }
        }
        Ok(Next::Work)
    }
}
