//! The commands of the page of surfaces.

use super::super::actions::ask_number;
use super::super::texts;
use super::table::Action;
use super::{Nets, knot_moved};
use crate::editor::Editor;
use crate::editor::place::ask_place;
use crate::file::KnotNet;
use crate::machine::Asked;
use crate::ui::words;
use crate::ui::{Answer, Desk, Number, Question, Stay, TOP};
use crate::work::{Next, offer_to_save, quit};

impl Editor<Nets, 3> {
    /// Carries out a command.
    pub(super) async fn carry_out(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        match action {
            Action::Envelope => self.craft.envelope = !self.craft.envelope,
            Action::NextKnot => self.next_knot(),
            Action::Change => self.change(desk).await?,
            Action::Through => self.go_through(desk).await?,
            Action::Result => self.show_result(desk).await?,
            Action::Quit => return quit(self, desk).await,
            Action::Curves => {
                if self.history.unsaved() {
                    offer_to_save(self, desk).await?;
                }
                self.craft.passage.lead(None);
                return Ok(Next::End);
            }
        }
        Ok(Next::Work)
    }

    fn next_knot(&mut self) {
        let Ok(surface) = self.history.now().surface() else { return };
        let (all, chosen) = (self.movable(&surface), self.chosen(self.history.now(), &surface));
        let at = chosen.and_then(|(direction, stack)| {
            all.iter().position(|&(other, it)| other == direction && it.first == stack.first)
        });
        let next = at.and_then(|at| all.get(at + 1)).or(all.first());
        self.craft.knot = next.map(|(direction, stack)| (*direction, stack.first));
    }

    /// The command V.
    async fn change(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let question = Question::new(TOP, words::ASK_CHANGE, [words::POINT, texts::KNOT]);
        if desk.ask(self, &question).await? == Answer::First {
            let net = self.history.now();
            let last = [net.points.len(), net.points.first().map_or(0, Vec::len)]
                .map(|count| count.saturating_sub(1));
            let mut index = [0; 2];
            for (direction, caption) in [texts::ROW_ENTRY, texts::COLUMN_ENTRY].into_iter().enumerate() {
                let range = 0..=i32::try_from(last[direction]).unwrap_or(i32::MAX);
                index[direction] =
                    ask_number(self, desk, caption, Number::Whole(range), None).await? as usize;
            }
            return self.change_point(desk, index).await;
        }
        let question = Question::new(TOP, words::ASK_DIRECTION, [words::ALONG_U, words::ALONG_V]);
        let direction = if desk.ask(self, &question).await? == Answer::First { 0 } else { 1 };
        let knots = self.history.now().knots[direction].clone();
        let range = 0..=i32::try_from(knots.len()).unwrap_or(i32::MAX).saturating_sub(1);
        let old = self.craft.knot.filter(|(other, _)| *other == direction).map(|(_, knot)| knot as f64);
        let knot = ask_number(self, desk, texts::KNOT_ENTRY, Number::Whole(range), old).await? as usize;
        let at =
            |index: Option<usize>, end: f64| index.and_then(|index| knots.get(index)).copied().unwrap_or(end);
        let (low, high) = (at(knot.checked_sub(1), -1e6), at(Some(knot + 1), 1e6));
        let kind = Number::Real(low..=high);
        let value = ask_number(self, desk, texts::VALUE_ENTRY, kind, knots.get(knot).copied()).await?;
        self.craft.knot = Some((direction, knot));
        self.history.change(knot_moved(self.history.now(), direction, (knot, 1), value));
        Ok(())
    }

    /// Asks for a control point's new place.
    pub(super) async fn change_point(&mut self, desk: &mut Desk<'_>, [k, l]: [usize; 2]) -> Asked<()> {
        let place = ask_place(desk, self, words::PLACE_3D).await?;
        let mut net = self.history.now().clone();
        if let Some(point) = net.points.get_mut(k).and_then(|row| row.get_mut(l)) {
            *point = place;
        }
        self.history.change(net);
        Ok(())
    }

    /// The command A: the surface through a point at the marked parameters.
    async fn go_through(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let place = ask_place(desk, self, texts::TARGET).await?;
        let through = self.history.now().surface().and_then(|surface| {
            let at = self.uv(&surface);
            surface.through_outer(place, at).map(|surface| (surface, at))
        });
        match through {
            Ok((surface, at)) => {
                self.craft.at = at.map(Some);
                self.history.change(KnotNet::of(&surface));
            }
            Err(error) => desk.tell(texts::refusal(&error), Stay::UntilRead),
        }
        Ok(())
    }
}
