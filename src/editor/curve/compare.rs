//! Curves of several methods together, each in its colour.

use super::{Ambient, Curves};
use crate::design::Place;
use crate::editor::Editor;
use crate::file::Method;
use crate::geometry::Point;
use crate::machine::{Asked, Key, Language, Request};
use crate::screen::{Color, Screen};
use crate::ui::words;
use crate::ui::{Area, Desk, Over, TOP};
use serde::Serialize;

/// A kind of curve that can be compared with others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Kind {
    Coons,
    Bezier,
    Spline,
    BSpline2,
    BSpline3,
}

impl Kind {
    /// Every kind with its name in the list and its colour.
    pub(super) const ALL: [(Kind, &'static str, Color); 5] = [
        (Kind::Coons, "Coons", Color::LightRed),
        (Kind::Bezier, "Bézier", Color::LightGreen),
        (Kind::Spline, "Spline", Color::Yellow),
        (Kind::BSpline2, "B-spl. 2", Color::LightBlue),
        (Kind::BSpline3, "B-spl. 3", Color::LightMagenta),
    ];

    /// The method of this kind.
    pub(super) fn method(self) -> Method {
        match self {
            Kind::Coons => Method::Coons,
            Kind::Bezier => Method::Bezier,
            Kind::Spline => Method::Spline,
            Kind::BSpline2 => Method::BSpline2,
            Kind::BSpline3 => Method::BSpline3,
        }
    }
}

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// Chooses which curves are shown together, each in its colour.
    pub(super) async fn compare(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let place = |index: i32| (216 + 116 * (index % 2), 9 + 13 * (index / 2));
        let keys: Vec<Key> = ('1'..='6').map(Key::Char).collect();
        loop {
            let compared = self.craft.compared.clone();
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
                let (x, y) = place(Kind::ALL.len() as i32);
                screen.text(x, y, "6", Color::Red);
                screen.text(x + 34, y, "k0", Color::Black);
                screen.text(x + 68, y, words::ENTER_ONLY.of(language), Color::Blue);
            });
            let tick = desk.event_asked(&page, Request::Keys(keys.clone())).await?;
            let clicked = tick.click().and_then(|(x, y)| {
                (0..).zip(Kind::ALL).position(|(index, _)| {
                    let (left, top) = place(index);
                    Area::new(left - 2, top - 3, left + 112, top + 10).holds(x, y)
                })
            });
            let series = tick.click().is_some_and(|(x, y)| {
                let (left, top) = place(Kind::ALL.len() as i32);
                Area::new(left - 2, top - 3, left + 60, top + 10).holds(x, y)
            });
            if series || tick.letter() == Some('6') {
                return self.ask_series(desk).await;
            }
            let typed = tick
                .letter()
                .and_then(|letter| letter.to_digit(10))
                .and_then(|digit| (digit as usize).checked_sub(1));
            match clicked.or(typed).and_then(|index| Kind::ALL.get(index)) {
                Some(&(kind, ..)) if compared.contains(&kind) => {
                    self.craft.compared.retain(|&other| other != kind);
                }
                Some(&(kind, ..)) => self.craft.compared.push(kind),
                None if matches!(tick.key(), Some(Key::Enter | Key::Esc | Key::F(4))) => {
                    return Ok(());
                }
                None => {}
            }
        }
    }
}
