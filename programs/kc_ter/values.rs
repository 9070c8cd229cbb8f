//! Values of the panel, asked for and changed.

use super::asking::{ask_key, number, whole};
use super::edit::{self, Index};
use super::rows::{self, Hit, Value, Way};
use super::studio::Studio;
use super::texts;
use crate::file::ec::Item;
use crate::geometry::ec::{EcError, Real};
use crate::machine::{Asked, Language, Request, Tick};
use crate::screen::{Color, Screen};
use crate::ui::words::Phrase;
use crate::ui::{Answer, Desk, Question, Stay, TOP, page};

impl Studio {
    /// Asks for a row of the page by its letter.
    pub(super) async fn ask_row(&mut self, desk: &mut Desk<'_>) -> Asked<Value> {
        let page_now = self.page;
        let letters = rows::rows(page_now).iter().filter_map(|row| match row {
            rows::Row::Value(letter, ..) => Some(*letter),
            _ => None,
        });
        let letters: String = letters.flat_map(|letter| [letter, ' ']).collect();
        let found = |tick: &Tick| {
            let clicked = tick.click().and_then(|at| match rows::hit(page_now, at) {
                Some(Hit::Value(value)) => Some(value),
                _ => None,
            });
            tick.letter().and_then(|letter| rows::value_of(page_now, letter)).or(clicked)
        };
        ask_key(desk, &*self, texts::ASK_ROW, &letters, found).await
    }

    /// Changes a value of the page: a choice turns, others are asked for.
    pub(super) async fn change_value(&mut self, desk: &mut Desk<'_>, value: Value) -> Asked<()> {
        let name = rows::rows(self.page).iter().find_map(|row| match row {
            rows::Row::Value(letter, name, own) if *own == value => Some((*letter, *name)),
            _ => None,
        });
        let caption = name.map_or(Phrase::new("", ""), |(letter, name)| {
            let text = |language| format!("{letter}{}", name.of(language));
            Phrase::new(text(Language::Hungarian), text(Language::English))
        });
        let typed = self.typed(value);
        match value.way() {
            Way::Turn => self.turn(value, true),
            Way::Number([low, high]) => {
                let number = desk.meaning(&*self, caption, &typed, |text| number(text, [low, high])).await?;
                self.set(value, number);
            }
            Way::Whole(range) => {
                let read = |text: &str| whole(text, range);
                let number = desk.meaning(&*self, caption, &typed, read).await?;
                self.set_whole(value, [number; 2]);
            }
            Way::Pair(range) => {
                let read = |text: &str| {
                    let parts: Vec<&str> =
                        text.split(['x', 'X', ',', ' ']).filter(|it| !it.is_empty()).collect();
                    match parts.as_slice() {
                        [one] => whole(one, range).map(|number| [number; 2]),
                        [one, other] => Ok([whole(one, range)?, whole(other, range)?]),
                        _ => Err(texts::NO_WHOLE.into()),
                    }
                };
                let pair = desk.meaning(&*self, caption, &typed, read).await?;
                self.set_whole(value, pair);
            }
            Way::Place => {
                self.along = self.ask_direction(desk).await?;
                self.settle_selection();
                self.ask_place(desk).await?;
            }
            Way::Index => {
                let item = self.item().cloned();
                let read = |text: &str| {
                    let numbers: Option<Vec<usize>> = text
                        .split([',', ' '])
                        .filter(|it| !it.is_empty())
                        .map(|it| it.parse().ok())
                        .collect();
                    let numbers = numbers.unwrap_or_default();
                    let index = match (numbers.as_slice(), &item) {
                        ([k], Some(Item::Curve(_))) => Some([*k, 0]),
                        ([k, l], Some(Item::Patch(_))) => Some([*k, *l]),
                        _ => None,
                    };
                    let there = |index: &Index| {
                        item.as_ref().is_some_and(|it| edit::control_point(it, *index).is_some())
                    };
                    index.filter(there).ok_or_else(|| texts::NO_ITEM.into())
                };
                self.point = Some(desk.meaning(&*self, caption, &typed, read).await?);
            }
        }
        Ok(())
    }

    /// Along which direction of a patch; curves have one.
    pub(super) async fn ask_direction(&mut self, desk: &mut Desk<'_>) -> Asked<usize> {
        if !matches!(self.item(), Some(Item::Patch(_))) {
            return Ok(0);
        }
        let question = Question::new(TOP, texts::ASK_DIRECTION, [texts::ALONG_U, texts::ALONG_V]);
        let proposed = if self.along == 0 { Answer::First } else { Answer::Second };
        let question = Question { proposed, ..question };
        let answer = desk.ask(&*self, &question).await?;
        self.along = usize::from(answer == Answer::Second);
        self.settle_selection();
        Ok(self.along)
    }

    /// Asks where to divide: typed, or by a click on the curve, along which a mark runs with the mouse.
    pub(super) async fn ask_place(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some([start, end]) = self.own_interval() else { return Ok(()) };
        let inside = move |at: &Real| start < at.value() && at.value() < end;
        let mut entry = crate::ui::Entry::new(
            crate::ui::Area::new(TOP.0 + 6, TOP.1 + 19, TOP.0 + 234, TOP.1 + 33),
            (TOP.0 + 12, TOP.1 + 23),
            60,
            crate::ui::Accepts::Text,
        )
        .proposing(self.typed(Value::At));
        let asked = loop {
            let typing = crate::ui::Over::new(&*self, |screen: &mut Screen, language: Language| {
                page(screen, TOP);
                screen.text(TOP.0 + 8, TOP.1 + 5, texts::ASK_MIDDLE.of(language), Color::Black);
                entry.draw(screen);
            });
            let tick = match desk.event_asked(&typing, Request::Text).await {
                Ok(tick) => tick,
                Err(stop) => break Err(stop),
            };
            let mouse = (tick.mouse.x, tick.mouse.y);
            let on_curve = self.place_under(mouse);
            self.mark = on_curve.and_then(|s| self.point_at(s));
            if let (Some(_), Some(s)) = (tick.click(), on_curve) {
                let at = Real::from(start + s * (end - start));
                if inside(&at) {
                    break Ok(at);
                }
            }
            match tick.key().map_or(crate::ui::Typed::On, |key| entry.key(key)) {
                crate::ui::Typed::On => {}
                crate::ui::Typed::Cancelled => break Err(crate::machine::Stop::Cancelled),
                crate::ui::Typed::Done => match Real::typed(&entry.text) {
                    Ok(at) if inside(&at) => break Ok(at),
                    Ok(at) => {
                        let error = EcError::Outside { at: at.value(), interval: [start, end] };
                        desk.tell(texts::problem(&error), Stay::UntilRead);
                    }
                    Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
                },
            }
        };
        self.mark = None;
        self.at = Some(asked?);
        Ok(())
    }
}
