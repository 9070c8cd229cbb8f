//! The best results, and how a finished cube compares.

use super::super::super::puzzles;
use super::super::super::puzzles::{Help, Party};
use super::super::texts;
use super::{Play, Player};
use crate::machine::{Best, Language};
use crate::puzzle::cube::Rules;
use crate::ui::Desk;

impl Player {
    pub(super) fn look_at_best(&mut self, desk: &mut Desk<'_>) {
        let name = self.results().unwrap_or_default();
        if name != self.best.0 {
            let best = desk.machine.bests().and_then(|bests| bests.best(&name));
            self.best = (name, best);
        }
    }

    /// The name that results of this game are kept under.
    pub(super) fn results(&self) -> Option<String> {
        let deal = self.plays.now().deal?;
        let rules = match self.rules {
            Rules::Book => "",
            Rules::Rigid => " rigid",
        };
        Some(format!("csango_k {:?}{rules}", deal.preset).to_lowercase())
    }

    /// The cube has just been finished.
    pub(super) fn celebrate(&mut self, desk: &mut Desk<'_>, play: Play) {
        if let Some(name) = self.results().filter(|_| play.help == Help::None) {
            let seconds = self.clock.time(self.now).as_secs();
            let best = puzzles::keep_best(desk, &name, Best { moves: play.moves, seconds });
            self.best = (name, best);
        }
        if play.help != Help::Solution {
            self.party = Some(Party::new(self.now));
        }
    }

    /// Lines in the field in the manner of today: the game, the best results, how a finished cube compares.
    pub(super) fn told(&self, language: Language) -> Vec<String> {
        let play = self.plays.now();
        let mut lines = Vec::new();
        if !self.begun {
            return lines;
        }
        lines.extend(play.deal.map(|deal| texts::game(deal.preset, deal.number, language)));
        lines.extend(self.best.1.map(|best| puzzles::best_text(best, language)));
        if play.cube.is_finished() && play.moves > 0 {
            lines.push(puzzles::end_text(play.help).of(language).to_owned());
            if let Some((_, count)) = self.known.filter(|(first, _)| *first == play.first) {
                lines.push(puzzles::known_text(count, false, language));
            }
        }
        lines
    }
}
