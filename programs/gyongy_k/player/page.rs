//! What the screen shows.

use super::super::hand::Hand;
use super::super::picture::{Board, GoingOn, Slide, View};
use super::super::show::Show;
use super::super::texts;
use super::Player;
use crate::machine::Language;
use crate::screen::Screen;
use crate::ui::{Hint, Picture};

impl Picture for Player {
    fn draw(&self, screen: &mut Screen, language: Language) {
        let going_on = match &self.show {
            Show::Nothing => GoingOn::Nothing,
            Show::Seeking(seeking) => GoingOn::Search(seeking.solver.progress()),
            Show::Playing(it) => GoingOn::Solution { count: it.count, proven: it.proven },
            Show::Demonstration(_) => GoingOn::Demonstration,
        };
        let board = self.begun.then(|| Board {
            wheel: self.shown(),
            game: self.games.now(),
            time: self.clock.time(self.now),
            hint: self.hint.filter(|_| matches!(self.show, Show::Nothing)),
            going_on,
            slide: self.hand.as_ref().map_or(Slide::None, Hand::slide),
            told: self.told(language),
            party: self.party.map(|party| (party, self.now)),
        });
        View { buttons: self.buttons, board, style: self.style }.draw(screen, language);
    }

    fn hint(&self) -> Option<Hint> {
        if !self.begun || !matches!(self.show, Show::Nothing) {
            return None;
        }
        let game = self.games.now();
        let text = if let Some(hint) = self.hint {
            texts::do_this(hint)
        } else if let Some(refused) = self.refused {
            texts::is_in(refused, refused.inverse())
        } else {
            match (game.wheel.is_solved(), game.moves) {
                (true, 0) => texts::FREE,
                (true, _) => texts::AGAIN,
                (false, 0) => texts::BEGIN,
                (false, _) => texts::GO_ON,
            }
            .into()
        };
        Some(Hint::at((404, 134), 27, text))
    }
}
