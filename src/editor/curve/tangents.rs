//! The tangents of GB_2D_CH: dragged by their tips, set by length and angle, or computed, which the original
//! offers after every action.

use super::ask::{ask_closure, ask_coefficient};
use super::commands::k0_note;
use super::{Ambient, Curves, Tools};
use crate::design::Place;
use crate::editor::Editor;
use crate::geometry::{Closure, Point};
use crate::machine::Asked;
use crate::screen::{Color, Stroke};
use crate::ui::words::{self, Words};
use crate::ui::{Answer, Area, Caption, Desk, Field, Form, Number, Question, Stay, TOP};
use serde::Serialize;

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// Asks whether to compute the tangents.
    pub(super) async fn offer_automatic_tangents(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.craft.tools != Tools::Tangents || self.count() < self.fewest() {
            return Ok(());
        }
        let question = Question::new(TOP, words::ASK_AUTOMATIC, [words::YES, words::NO]);
        if desk.ask(self, &question).await? == Answer::Second {
            return Ok(());
        }
        let closure = if ask_closure(desk, self).await? { Closure::Closed } else { Closure::Open };
        let k0 = ask_coefficient(desk, self).await?;
        let mut sketch = self.history.now().clone();
        sketch.settings.k0 = Some(k0);
        self.shown.after_change();
        let Ok(sketch) = sketch.with_automatic_tangents(closure) else {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        };
        self.history.change(sketch);
        self.craft.note = Some(k0_note(k0));
        Ok(())
    }
}

impl Editor<Curves<2>, 2> {
    /// Changes the length or the direction of the tangent at a point.
    pub(super) async fn change_tangent(&mut self, desk: &mut Desk<'_>, index: usize) -> Asked<()> {
        let Some(tangent) = self.history.now().tangent(index) else { return Ok(()) };
        let question = Question::new(TOP, words::ASK_CHANGE, [words::LENGTH, words::ANGLE]);
        let changed = match desk.ask(self, &question).await? {
            Answer::First => self.ask_length(desk, tangent).await?,
            Answer::Second => self.ask_angle(desk, tangent).await?,
        };
        self.change(self.history.now().with_tangent(index, changed.map(f64::round_ties_even)));
        Ok(())
    }

    async fn ask_length(&self, desk: &mut Desk<'_>, [x, y]: Point<2>) -> Asked<Point<2>> {
        let length = x.hypot(y);
        let form = tangent_form(words::TANGENT_LENGTH, (212, 30), length.round(), 999);
        let [longer] = desk.numbers(self, &form).await?;
        let factor = longer / length;
        // A zero tangent gets the direction of positive x.
        Ok(if length < 1.0 { [longer, 0.0] } else { [x * factor, y * factor] })
    }

    async fn ask_angle(&self, desk: &mut Desk<'_>, [x, y]: Point<2>) -> Asked<Point<2>> {
        let degrees = y.atan2(x).to_degrees().round().rem_euclid(360.0);
        let mut form = tangent_form(words::TANGENT_ANGLE, (276, 20), degrees, 359);
        form.ornament = |screen| {
            screen.circle(245, 26, 8, Stroke::thin(Color::Black));
            let labels = [(256, 22, "0"), (212, 22, "180"), (239, 9, "90"), (235, 36, "270"), (380, 27, "°")];
            labels.into_iter().for_each(|(x, y, text)| screen.text(x, y, text, Color::Black));
        };
        let [turned] = desk.numbers(self, &form).await?;
        let (sine, cosine) = turned.to_radians().sin_cos();
        let length = x.hypot(y);
        Ok([length * cosine, length * sine])
    }
}

/// The page that asks for a whole number, at least 0, and shows the present value.
fn tangent_form(title: Words, now_at: (i32, i32), now: f64, largest: i32) -> Form<1> {
    let captions = vec![
        Caption::new((285, 10), title),
        Caption::new(now_at, words::now_it_is(now)),
        Caption::new((316, 30), words::NEW_VALUE),
    ];
    let kind = Number::Whole(0..=largest);
    Form::new(captions, [Field { area: Area::new(340, 27, 378, 39), at: (348, 30), longest: 3, kind }])
}
