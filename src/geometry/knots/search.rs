//! Through a point by whatever knots move least.

use super::through::check_cubic;
use super::{KnotCurve, KnotError, Pair, Through, Unreached};
use crate::geometry::{Point, norm};

/// Places in a span at which the closed forms are tried.
const PLACES: u32 = 15;
/// Steps of the golden section.
const POLISHED: usize = 40;
/// Halvings on the way from a point to the curve.
const HALVINGS: usize = 20;

/// A way through a point that leaves a parameter free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The outer knots of this span.
    Outer(usize),
    /// This knot at the point's parameter, and a pair beside it.
    Pair(usize, Pair),
    /// This knot alone.
    Knot(usize),
}

impl KnotCurve<2> {
    /// Of the plane cubics through a point that the outer knots of a span, a knot with a pair, or one knot alone make, the
    /// one whose knots move least ([`Through::effort`]), and how it is made. The parameter is tried at 15 places of every span and
    /// then polished.
    ///
    /// # Errors
    /// [`KnotError::Unreached`] outside the reachable region; a curve that is not a plane open cubic without weights.
    pub fn through_any(&self, point: Point<2>) -> Result<(Way, Through<2>), KnotError> {
        check_cubic(self, point)?;
        let mut best: Option<(f64, Way, [f64; 2], Through<2>)> = None;
        let mut consider = |way: Way, around: [f64; 2], found: Through<2>| {
            let effort = found.effort(self.vector());
            if best.as_ref().is_none_or(|(least, ..)| effort < *least) {
                best = Some((effort, way, around, found));
            }
        };
        for (way, [from, to]) in self.ways() {
            let step = (to - from) / f64::from(PLACES + 1);
            for place in 1..=PLACES {
                let at = from + step * f64::from(place);
                if let Some(found) = self.by(way, point, at) {
                    consider(way, [at - step, at + step], found);
                }
            }
        }
        for knot in 1..self.vector().knots().len() - 1 {
            for found in self.through_knot(point, knot).unwrap_or_default() {
                consider(Way::Knot(knot), [found.u; 2], found);
            }
        }
        let (_, way, around, found) = best.ok_or(Unreached::NotFound)?;
        Ok((way, self.polished(way, point, around, found)))
    }

    /// All curves through a point that [`KnotCurve::through_any`] compares, that with the least move of the knots first:
    /// the best of every way. Curves of other orders and rational ones only by one knot.
    ///
    /// # Errors
    /// [`KnotError::Unreached`] outside the reachable region, [`KnotError::Closed`].
    pub fn through_every(&self, point: Point<2>) -> Result<Vec<(Way, Through<2>)>, KnotError> {
        let mut all: Vec<(f64, Way, Through<2>)> = Vec::new();
        let ways = if check_cubic(self, point).is_ok() { self.ways() } else { Vec::new() };
        for (way, [from, to]) in ways {
            let step = (to - from) / f64::from(PLACES + 1);
            let places = (1..=PLACES).map(|place| from + step * f64::from(place));
            let tried = places.filter_map(|at| {
                let found = self.by(way, point, at)?;
                Some((found.effort(self.vector()), at, found))
            });
            if let Some((_, at, found)) = tried.min_by(|a, b| a.0.total_cmp(&b.0)) {
                let found = self.polished(way, point, [at - step, at + step], found);
                all.push((found.effort(self.vector()), way, found));
            }
        }
        for knot in 1..self.vector().knots().len() - 1 {
            match self.through_knot(point, knot) {
                Ok(found) => {
                    let found = found.into_iter().map(|it| (it.effort(self.vector()), Way::Knot(knot), it));
                    all.extend(found);
                }
                Err(error @ (KnotError::Closed | KnotError::Points(_))) => return Err(error),
                Err(_) => {}
            }
        }
        if all.is_empty() {
            return Err(Unreached::NotFound.into());
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(all.into_iter().map(|(_, way, found)| (way, found)).collect())
    }

    /// The point nearest to an unreachable one that the same search reaches on the way straight to the curve; the
    /// point itself where it is reached.
    ///
    /// # Errors
    /// As [`KnotCurve::through_any`], but for the region.
    pub fn nearest_reached(&self, point: Point<2>) -> Result<Point<2>, KnotError> {
        check_cubic(self, point)?;
        if self.through_any(point).is_ok() {
            return Ok(point);
        }
        let off = |p: &Point<2>| norm([p[0] - point[0], p[1] - point[1]]);
        let [from, to] = self.vector().domain();
        let places = (0..=1000).map(|k| from + (to - from) * (f64::from(k) / 1000.0));
        let nearest = places.filter_map(|u| self.point_at(u)).min_by(|a, b| off(a).total_cmp(&off(b)));
        let mut reached = nearest.ok_or(Unreached::NotFound)?;
        let mut beyond = point;
        for _ in 0..HALVINGS {
            let middle = [0, 1].map(|d| 0.5 * (reached[d] + beyond[d]));
            *(if self.through_any(middle).is_ok() { &mut reached } else { &mut beyond }) = middle;
        }
        Ok(reached)
    }

    /// The closed forms, with the range of their parameter.
    fn ways(&self) -> Vec<(Way, [f64; 2])> {
        let (vector, knots) = (self.vector(), self.vector().knots());
        let spans = vector.filled_spans().iter().map(|&j| (Way::Outer(j), [knots[j], knots[j + 1]]));
        let inner = (3..knots.len() - 3).filter(|&i| knots[i - 1] < knots[i + 1]);
        let pairs = inner.flat_map(|i| {
            Pair::ALL.into_iter().map(move |pair| (Way::Pair(i, pair), [knots[i - 1], knots[i + 1]]))
        });
        spans.chain(pairs).collect()
    }

    fn by(&self, way: Way, point: Point<2>, at: f64) -> Option<Through<2>> {
        match way {
            Way::Outer(span) => self.through_outer(point, span, at).ok(),
            Way::Pair(knot, pair) => self.through_pair(point, knot, at, pair).ok(),
            Way::Knot(_) => None,
        }
    }

    /// The least effort near a solution, by golden section; what is not admissible is no better.
    fn polished(&self, way: Way, point: Point<2>, around: [f64; 2], found: Through<2>) -> Through<2> {
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        let ([mut low, mut high], mut best) = (around, found);
        let mut least = best.effort(self.vector());
        for _ in 0..POLISHED {
            let places = [high - ratio * (high - low), low + ratio * (high - low)];
            let efforts = places.map(|at| {
                let Some(found) = self.by(way, point, at) else { return f64::INFINITY };
                let effort = found.effort(self.vector());
                if effort < least {
                    (least, best) = (effort, found);
                }
                effort
            });
            // Where neither is admissible, the way back is to the best so far.
            let left = if efforts[0] == efforts[1] { best.u < places[1] } else { efforts[0] < efforts[1] };
            if left {
                high = places[1];
            } else {
                low = places[0];
            }
        }
        best
    }
}
