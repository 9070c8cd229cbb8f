//! The reachable region (F8): where the arcs near the mouse could pass, by knots alone.

use super::bench::{Bench, Curve};
use super::facts::Facts;
use super::rail::Scale;
use super::sheet::{FIELD, LINE, ORIGIN, STRIP, Sheet, column, in_field};
use crate::editor::Editor;
use crate::file::KnotPoints;
use crate::geometry::Point;
use crate::geometry::knots::{KnotError, Pair};
use crate::screen::{Color, Screen};
use std::cell::RefCell;
use std::rc::Rc;

/// Cells of the field in either direction.
pub(super) const CELLS: usize = 40;

/// Which cells are reached, and by which spans.
#[derive(Debug)]
pub(super) struct Region {
    pub(super) cells: Vec<bool>,
    spans: [usize; 2],
}

/// The region of the last picture, with what it was worked out from.
#[derive(Debug, Default)]
pub(super) struct Known(RefCell<Option<(KnotPoints, usize, Rc<Region>)>>);

/// The middle of a cell.
fn middle(cell: usize) -> Point<2> {
    let part = |at: usize, size: f64| size * (at as f64 + 0.5) / CELLS as f64;
    [part(cell % CELLS, FIELD[0]), part(cell / CELLS, FIELD[1])]
}

/// Whether the curve comes to a point by a pair beside one of the knots around a span, at its present place, or by the
/// outer knots of a span in its middle.
fn reached(curve: &Curve, point: Point<2>, spans: [usize; 2]) -> bool {
    let knots = curve.vector().knots();
    let by_pair = |knot: usize| {
        Pair::ALL.into_iter().any(|pair| curve.through_pair(point, knot, knots[knot], pair).is_ok())
    };
    let by_outer =
        |span: usize| curve.through_outer(point, span, 0.5 * (knots[span] + knots[span + 1])).is_ok();
    (spans[0]..=spans[1] + 1).any(by_pair) || (spans[0]..=spans[1]).any(by_outer)
}

/// The cells reached by a span and its neighbours. Only plane open cubics without weights have closed forms.
fn region(curve: &Curve, span: usize) -> Result<Region, KnotError> {
    curve.through_outer([0.0; 2], span, curve.vector().knots()[span]).map(|_| ()).or_else(
        |error| match error {
            KnotError::Rational | KnotError::Closed | KnotError::OrderNeeded { .. } => Err(error),
            _ => Ok(()),
        },
    )?;
    let vector = curve.vector();
    let spans = [(span - 1).max(3), (span + 1).min(vector.controls() - 1)];
    let cells = (0..CELLS * CELLS).map(|cell| reached(curve, middle(cell), spans)).collect();
    Ok(Region { cells, spans })
}

impl Editor<Bench, 2> {
    /// Why there is no region.
    pub(super) fn region_problem(&self) -> Option<KnotError> {
        let facts = self.facts(self.history.now());
        facts.map_or(Some(KnotError::NoSpan), |facts| {
            let span = facts.curve.vector().filled_spans().first().copied()?;
            region(&facts.curve, span).err()
        })
    }

    /// The region of the arcs near the mouse; where it is not in the field, near the marked parameter.
    pub(super) fn region(&self, drawn: &KnotPoints, facts: &Facts) -> Option<Rc<Region>> {
        let mouse = Sheet::place((self.craft.mouse.x, self.craft.mouse.y));
        let near = || facts.nearest(mouse).map(|(u, _)| u).filter(|_| in_field(mouse));
        let span = facts.curve.vector().span_of(near().unwrap_or_else(|| self.u(facts)))?;
        let mut known = self.craft.region.0.borrow_mut();
        match known.as_ref() {
            Some((curve, at, region)) if curve == drawn && *at == span => Some(Rc::clone(region)),
            _ => {
                let region = Rc::new(region(&facts.curve, span).ok()?);
                *known = Some((drawn.clone(), span, Rc::clone(&region)));
                Some(region)
            }
        }
    }

    fn region_shown(&self) -> Option<(Rc<Facts>, Rc<Region>)> {
        let drawn = self.drawn();
        let facts = self.facts(&drawn).filter(|_| self.craft.options.region && self.stage.begun())?;
        let region = self.region(&drawn, &facts)?;
        Some((facts, region))
    }

    /// Shades what the knots reach.
    pub(super) fn draw_region(&self, screen: &mut Screen) {
        let Some((_, region)) = self.region_shown() else { return };
        for (cell, _) in region.cells.iter().enumerate().filter(|(_, reached)| **reached) {
            let edge = |at: usize, size: f64| (size * at as f64 / CELLS as f64).round() as i32;
            let (x1, x2) = (edge(cell % CELLS, FIELD[0]), edge(cell % CELLS + 1, FIELD[0]));
            let (y1, y2) = (edge(cell / CELLS, FIELD[1]), edge(cell / CELLS + 1, FIELD[1]));
            screen.bar(ORIGIN.0 + x1, ORIGIN.1 - y2 + 1, ORIGIN.0 + x2 - 1, ORIGIN.1 - y1, Color::Blue);
        }
    }

    /// Shows in the strip which arcs are meant.
    pub(super) fn draw_region_spans(&self, screen: &mut Screen, scale: &Scale) {
        let Some((facts, region)) = self.region_shown() else { return };
        let knots = facts.curve.vector().knots();
        let [from, to] = [region.spans[0], region.spans[1] + 1].map(|knot| column(scale, knots[knot]));
        screen.bar(from, STRIP.y1, to, STRIP.y2, Color::Blue);
        screen.bar(from, LINE.y1, to, LINE.y2, Color::Blue);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::knots::KnotVector;

    #[test]
    fn what_is_shaded_is_reached_and_places_on_the_curve_are() {
        let points: Vec<Point<2>> = [
            [20.0, 36.0],
            [45.0, 135.0],
            [130.0, 207.0],
            [280.0, 230.0],
            [430.0, 207.0],
            [515.0, 135.0],
            [540.0, 36.0],
        ]
        .to_vec();
        let curve = Curve::new(KnotVector::uniform(4, 7).unwrap(), points).unwrap();
        let region = region(&curve, 5).unwrap();
        let shaded: Vec<usize> = (0..CELLS * CELLS).filter(|cell| region.cells[*cell]).collect();
        assert!(shaded.len() > 20 && shaded.len() < CELLS * CELLS / 2, "{}", shaded.len());
        for &cell in shaded.iter().step_by(7) {
            assert!(curve.through_any(middle(cell)).is_ok(), "{:?}", middle(cell));
        }
        let closed = Curve::new(
            KnotVector::closed(4, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap(),
            vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [4.0, 12.0], [0.0, 9.0]],
        );
        assert_eq!(super::region(&closed.unwrap(), 3).err(), Some(KnotError::Closed));
    }
}
