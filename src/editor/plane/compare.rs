//! Curves of several methods together, each in its colour.

use super::Editor;
use super::curves::Kind;
use crate::machine::{Key, Language, Quit};
use crate::screen::{Color, Screen};
use crate::ui::words;
use crate::ui::{Area, Desk, Over, TOP};

impl Editor {
    /// Chooses which curves are shown together, each in its colour.
    pub(super) async fn compare(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        let place = |index: i32| (216 + 116 * (index % 2), 9 + 13 * (index / 2));
        loop {
            let compared = self.compared.clone();
            let page = Over::new(self, |screen: &mut Screen, language: Language| {
                crate::ui::page(screen, TOP);
                for (index, (kind, name, color)) in (0..).zip(Kind::ALL) {
                    let (x, y) = place(index);
                    if compared.contains(&kind) {
                        screen.bar(x + 16, y, x + 28, y + 7, color);
                    }
                    screen.text(x, y, &(index + 1).to_string(), Color::Red);
                    screen.text(x + 34, y, name, Color::Black);
                }
                screen.text(332, 35, words::ENTER_BACK.of(language), Color::Black);
            });
            let tick = desk.event(&page).await?;
            let clicked = tick.click().and_then(|(x, y)| {
                (0..).zip(Kind::ALL).position(|(index, _)| {
                    let (left, top) = place(index);
                    Area::new(left - 2, top - 3, left + 112, top + 10).holds(x, y)
                })
            });
            let typed = tick
                .letter()
                .and_then(|letter| letter.to_digit(10))
                .and_then(|digit| (digit as usize).checked_sub(1));
            match clicked.or(typed).and_then(|index| Kind::ALL.get(index)) {
                Some(&(kind, ..)) if self.compared.contains(&kind) => {
                    self.compared.retain(|&other| other != kind);
                }
                Some(&(kind, ..)) => self.compared.push(kind),
                None if matches!(tick.key(), Some(Key::Enter | Key::Esc | Key::F(4))) => {
                    return Ok(());
                }
                None => {}
            }
        }
    }
}
