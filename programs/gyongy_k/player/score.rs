//! The best results, and how a solved wheel compares.

use super::super::super::puzzles;
use super::super::super::puzzles::{Help, Party};
use super::super::game::Problem;
use super::super::show::Show;
use super::Player;
use crate::machine::{Best, Language, Manner};
use crate::ui::Desk;

impl Player {
    /// The name that results of this game are kept under.
    pub(super) fn results(&self) -> Option<String> {
        let problem = self.games.now().problem?;
        Some(format!("gyongy_k {:?}", problem.difficulty).to_lowercase())
    }

    pub(super) fn look_at_best(&mut self, desk: &mut Desk<'_>) {
        let name = self.results().unwrap_or_default();
        if name != self.best.0 {
            let best = desk.machine.bests().and_then(|bests| bests.best(&name));
            self.best = (name, best);
        }
    }

    /// A wheel has just been solved.
    pub(super) fn celebrate(&mut self, desk: &mut Desk<'_>) {
        if self.style.manner == Manner::Original {
            return;
        }
        let game = self.games.now();
        let (help, moves) = (game.help, game.moves);
        if let Some(name) = self.results().filter(|_| help == Help::None) {
            let seconds = self.clock.time(self.now).as_secs();
            let best = puzzles::keep_best(desk, &name, Best { moves, seconds });
            self.best = (name, best);
        }
        if help != Help::Solution {
            self.party = Some(Party::new(self.now));
        }
    }

    /// More lines beside the board in the manner of today: the best results, and how a solved wheel compares.
    pub(super) fn told(&self, language: Language) -> Vec<String> {
        let game = self.games.now();
        let mut lines = Vec::new();
        if self.style.manner == Manner::Original || !matches!(self.show, Show::Nothing) {
            return lines;
        }
        lines.extend(self.best.1.map(|best| puzzles::best_text(best, language)));
        if game.wheel.is_solved() && game.moves > 0 {
            lines.push(puzzles::end_text(game.help).of(language).to_owned());
            let found = self.found.filter(|(start, ..)| *start == game.start);
            let found = found.map(|(_, count, proven)| (count, proven));
            let known = found.into_iter().chain(game.problem.and_then(Problem::known));
            // The shortest one; of two alike the one with a proof.
            if let Some((count, proven)) = known.min_by_key(|&(count, proven)| (count, !proven)) {
                lines.push(puzzles::known_text(count, proven, language));
            }
        }
        lines
    }
}
