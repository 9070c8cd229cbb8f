//! Questions about loss: with the facts above them, and before files are overwritten.

use super::ask::{Answer, Question};
use super::desk::{Desk, Picture};
use super::notice;
use super::words::{self, Phrase};
use crate::machine::{Asked, Language, Standing};
use crate::screen::Screen;

impl Desk<'_> {
    /// Asks a yes-or-no question in the middle of the picture, with the facts on a panel above it.
    ///
    /// # Errors
    /// [`Stop`](crate::machine::Stop): Esc, or the display is being closed.
    pub async fn ask_about(
        &mut self,
        picture: &dyn Picture,
        facts: &Phrase,
        question: Question,
    ) -> Asked<Answer> {
        let picture = |screen: &mut Screen, language: Language| {
            picture.draw(screen, language);
            notice::preface(screen, facts.of(language));
        };
        self.ask(&picture, &question).await
    }

    /// Whether files may be written under these names. If files exist already, the user decides, and is told if one
    /// has changed since this program read or wrote it.
    ///
    /// # Errors
    /// [`Stop`](crate::machine::Stop): Esc, or the display is being closed.
    pub async fn may_write(&mut self, picture: &dyn Picture, names: &[&str]) -> Asked<bool> {
        loop {
            let standings = self.standings(names);
            let first = |wanted: fn(&Standing) -> bool| {
                let at = standings.iter().position(wanted)?;
                names.get(at).copied()
            };
            let changed = first(|standing| matches!(standing, Standing::Changed(_)));
            let there = first(|standing| matches!(standing, Standing::There(_)));
            let agreed = match (changed, there) {
                (Some(name), _) => {
                    let answer = self
                        .ask_about(
                            picture,
                            &words::changed(name),
                            Question::yes_no(words::ASK_OVERWRITE).careful(),
                        )
                        .await?;
                    answer == Answer::First
                }
                (None, Some(name)) => {
                    let question = Question::yes_no(words::exists(name)).careful();
                    self.ask(picture, &question).await? == Answer::First
                }
                (None, None) => return Ok(true),
            };
            // The user agreed to replace these contents; they may have changed during the question.
            if !agreed || self.standings(names) == standings {
                return Ok(agreed);
            }
        }
    }

    fn standings(&self, names: &[&str]) -> Vec<Standing> {
        names.iter().map(|name| self.machine.files().standing(name)).collect()
    }
}
