//! What the screen shows.

use super::super::picture::{Goal, Scene, draw_axes, draw_goal, draw_wrong};
use super::super::task::Task;
use super::super::{panel, texts};
use super::{Player, TODAY};
use crate::machine::{Language, Manner};
use crate::puzzle::cube::Rules;
use crate::screen::{Color, Screen};
use crate::ui::{Hint, Phrase, Picture};

impl Picture for Player {
    fn draw(&self, screen: &mut Screen, language: Language) {
        let hint = self.hinted_move();
        let color = |piece: usize| Color::ALL.get(piece + 1).copied().unwrap_or_default();
        let letter = hint.map(|it| it.action.letter());
        panel::draw(screen, language, self.manner, color(self.selected), letter);
        if let Some(steps) = &self.steps {
            Scene::painted(&self.cube(), self.eye, Goal::Unmarked, steps).draw(screen);
            draw_wrong(screen, steps);
            draw_axes(screen, self.eye);
            steps.draw(screen, (30, 60), [Color::Blue, Color::White], language);
            return;
        }
        if self.manner == Manner::Today {
            // Under the pieces, so that nothing hides them.
            draw_goal(screen, language);
            TODAY.draw(screen, language);
            for (row, line) in (0..).zip(self.told(language)) {
                screen.text(30, 150 + 12 * row, &line, Color::Blue);
            }
        }
        // The original shows an empty field until there is a configuration.
        if self.begun || self.manner == Manner::Today {
            self.scene().draw(screen);
            draw_axes(screen, self.eye);
        }
        screen.text(330, 468, &self.line(language), Color::Black);
        if let Some(hint) = hint {
            screen.bar(316, 467, 325, 476, color(hint.piece));
        }
        if let Some(party) = self.party {
            party.draw(screen, (260, 260), self.now);
        }
    }

    fn hint(&self) -> Option<Hint> {
        if !self.begun || !matches!(self.task, Task::Idle) || self.steps.is_some() {
            return None;
        }
        let play = self.plays.now();
        let at = |text: Phrase| Hint::at((30, 114), 44, text);
        let hint = if let Some(step) = self.hinted_move() {
            at(texts::do_this(step))
        } else if let Some(why) = self.refused {
            at(texts::refused(why))
        } else {
            match (play.cube.is_finished(), play.moves) {
                (true, _) => at(texts::AGAIN.into()),
                (false, 0) => at(texts::BEGIN.into()).by_keys(texts::BEGIN_BY_KEYS),
                (false, _) => at(texts::GO_ON.into()),
            }
        };
        Some(hint)
    }
}

impl Player {
    /// The line under the field; empty before the first move.
    pub(super) fn line(&self, language: Language) -> String {
        match (&self.task, self.hinted_move()) {
            (Task::Seeking(quest), _) => texts::progress(quest.progress(), language),
            (Task::Playing(moves, _), _) => texts::left(moves.len(), language),
            (Task::Idle, Some(hint)) => texts::hint(hint, language),
            (Task::Idle, None) => match (self.plays.now().moves, self.rules) {
                (0, Rules::Book) => String::new(),
                (moves, rules) => texts::score(moves, self.clock.time(self.now), rules, language),
            },
        }
    }
}
