//! The command A: a curve through a point by its knots alone.

use super::bench::Bench;
use super::sheet::{Sheet, in_field};
use super::texts;
use crate::design::knots::document;
use crate::editor::Editor;
use crate::file::KnotPoints;
use crate::geometry::Point;
use crate::geometry::knots::{KnotError, Through, Way};
use crate::machine::{Asked, Button, Event, Key, Tick};
use crate::screen::Color;
use crate::ui::{Desk, Phrase};
use crate::work;

/// A search that goes on until it is taken or given up.
#[derive(Clone, Debug, Default)]
pub(super) struct Search {
    /// Where the curve shall pass.
    pub(super) target: Option<Point<2>>,
    found: Vec<(Way, Through<2>)>,
    /// The solution in the picture.
    at: usize,
    problem: Option<KnotError>,
}

impl Search {
    /// The solution in the picture.
    pub(super) fn chosen(&self) -> Option<&(Way, Through<2>)> {
        self.found.get(self.at)
    }

    /// How many solutions there are.
    pub(super) fn count(&self) -> usize {
        self.found.len()
    }

    /// What the page says, and in which colour.
    pub(super) fn told(&self, now: &KnotPoints) -> (Phrase, Color) {
        if let Some((way, through)) = self.chosen() {
            let effort = now.vector().map_or(0.0, |vector| through.effort(&vector));
            return (texts::solution(*way, self.at + 1, self.found.len(), effort), Color::Black);
        }
        match &self.problem {
            Some(KnotError::Unreached(_)) => (texts::NOT_REACHED.into(), Color::Red),
            Some(error) => (texts::refusal(error), Color::Red),
            None => (texts::HINT_TARGET.into(), Color::Black),
        }
    }

    fn look_for(&mut self, curve: &super::bench::Curve, target: Point<2>) {
        *self = Search { target: Some(target), ..Search::default() };
        match curve.through_every(target) {
            Ok(found) => self.found = found,
            Err(error) => self.problem = Some(error),
        }
    }
}

impl Editor<Bench, 2> {
    /// Asks for the target, shows the solutions, and takes one.
    pub(super) async fn go_through(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        self.craft.search = Some(Search::default());
        let taken = self.search(desk).await;
        let search = self.craft.search.take();
        if taken? && let Some((_, through)) = search.as_ref().and_then(Search::chosen) {
            self.history.change(document(&through.curve));
            self.craft.u = Some(through.u);
        }
        Ok(())
    }

    /// Returns whether the solution in the picture is taken.
    async fn search(&mut self, desk: &mut Desk<'_>) -> Asked<bool> {
        loop {
            let tick = work::event(self, desk).await?;
            let Some(mut search) = self.craft.search.take() else { return Ok(false) };
            let facts = self.facts(self.history.now());
            let count = search.count();
            match tick.key() {
                Some(Key::Esc) => return Ok(false),
                Some(Key::Enter) if count > 0 => {
                    self.craft.search = Some(search);
                    return Ok(true);
                }
                Some(Key::Right) if count > 0 => search.at = (search.at + 1) % count,
                Some(Key::Left) if count > 0 => search.at = (search.at + count - 1) % count,
                Some(Key::Char('o' | 'O')) if count == 0 => {
                    let curve = facts.as_ref().map(|facts| &facts.curve);
                    let near =
                        search.target.zip(curve).and_then(|(at, curve)| curve.nearest_reached(at).ok());
                    if let Some((near, curve)) = near.zip(curve) {
                        search.look_for(curve, near);
                    }
                }
                _ => match (target_of(&tick), facts) {
                    (Some((target, true)), Some(facts)) => search.look_for(&facts.curve, target),
                    (Some((target, false)), _) => search.target = Some(target),
                    _ => {}
                },
            }
            self.craft.search = Some(search);
        }
    }
}

/// Where the mouse puts the target, and whether it is put down there.
fn target_of(tick: &Tick) -> Option<(Point<2>, bool)> {
    let at = Sheet::place((tick.mouse.x, tick.mouse.y));
    match tick.event {
        Some(Event::Press(Button::Left)) if in_field(at) => Some((at, true)),
        Some(Event::Move(..)) if in_field(at) && tick.mouse.holds(Button::Left) => Some((at, true)),
        _ => None,
    }
}
