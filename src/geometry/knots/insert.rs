//! A further knot, and other ends, with the same curve.

use super::local::{Hom, blossom};
use super::{KnotCurve, KnotError, KnotVector};

impl<const D: usize> KnotCurve<D> {
    /// The same curve with a further knot (Boehm 1980), which may make the curve's order as many equal ones at the ends
    /// and one less inside.
    ///
    /// # Errors
    /// [`KnotError::Outside`] the domain, [`KnotError::TooMultiple`].
    pub fn with_inserted(&self, u: f64) -> Result<Self, KnotError> {
        let (vector, knots, order) = (self.vector(), self.vector().knots(), self.vector().order());
        let range = vector.domain();
        if !(u >= range[0] && u <= range[1]) {
            return Err(KnotError::Outside { name: "u", value: u, range });
        }
        // The seam of a closed curve is its beginning.
        let u = if vector.breaks().is_some() && u == range[1] { range[0] } else { u };
        let (span, times) = (knots.partition_point(|knot| *knot <= u) - 1, vector.multiplicity(u));
        let at_end = vector.breaks().is_none() && range.contains(&u);
        let most = if at_end { order } else { order - 1 };
        if times >= most {
            return Err(KnotError::TooMultiple { knot: span, most });
        }
        let new = |i: usize| {
            if i + order < span + 2 {
                return self.homogeneous(i);
            }
            if i + times > span {
                return self.homogeneous(i - 1);
            }
            let share = (u - knots[i]) / (knots[i + order - 1] - knots[i]);
            self.homogeneous(i - 1).mixed(1.0 - share, share, self.homogeneous(i))
        };
        let rational = self.weights().is_some();
        let Some(breaks) = vector.breaks() else {
            let points: Vec<Hom<D>> = (0..=vector.controls()).map(new).collect();
            let mut knots = knots.to_vec();
            knots.insert(span + 1, u);
            return Self::of_homogeneous(KnotVector::new(order, knots)?, &points, rational);
        };
        let place = breaks.partition_point(|knot| *knot <= u);
        let mut breaks = breaks.to_vec();
        breaks.insert(place, u);
        let (count, first) = (breaks.len() - 1, span + 2 - order);
        // Point i begins `span + 1 - i` knots before the new one.
        let mut points = vec![Hom::ZERO; count];
        for i in first..first + count {
            points[(i + count + order - 1 + place - (span + 1)) % count] = new(i);
        }
        Self::of_homogeneous(KnotVector::closed(order, &breaks)?, &points, rational)
    }

    /// The same curve over knots whose first and last are there as often as the order says, so that it runs from its
    /// first control point to its last.
    ///
    /// # Errors
    /// [`KnotError::Closed`].
    pub fn clamped(&self) -> Result<Self, KnotError> {
        let [from, to] = self.vector().domain();
        let order = self.vector().order();
        let inner = self.vector().knots().iter().filter(|knot| **knot > from && **knot < to);
        let ends = |end: f64| std::iter::repeat_n(end, order);
        self.over(KnotVector::new(order, ends(from).chain(inner.copied()).chain(ends(to)).collect())?)
    }

    /// The same curve over knots that go on beyond the ends of the domain in steps of the span there, as they are for
    /// curves that end anywhere.
    ///
    /// # Errors
    /// [`KnotError::Closed`].
    pub fn unclamped(&self) -> Result<Self, KnotError> {
        let [from, to] = self.vector().domain();
        let (order, knots, spans) =
            (self.vector().order(), self.vector().knots(), self.vector().filled_spans());
        let width = |span: Option<&usize>| span.map_or(1.0, |&j| knots[j + 1] - knots[j]);
        let (first, last) = (width(spans.first()), width(spans.last()));
        let inner = knots.iter().filter(|knot| **knot > from && **knot < to);
        let before = (0..order).rev().map(|i| from - i as f64 * first);
        let after = (0..order).map(|i| to + i as f64 * last);
        self.over(KnotVector::new(order, before.chain(inner.copied()).chain(after).collect())?)
    }

    /// The same curve over other knots of the same domain that are nowhere smoother. Every control point is the
    /// blossom of an arc under it at the inner knots of its function (Ramshaw 1987).
    fn over(&self, vector: KnotVector) -> Result<Self, KnotError> {
        if self.vector().breaks().is_some() {
            return Err(KnotError::Closed);
        }
        let (order, knots) = (vector.order(), self.vector().knots());
        let point = |i: usize| {
            let span = self.arc_under(&vector, i)?;
            let arguments = &vector.knots()[i + 1..i + order];
            blossom(knots, span, &self.local(span)[..order], 0, 1.0, |r| arguments[r])
        };
        let points: Option<Vec<Hom<D>>> = (0..vector.controls()).map(point).collect();
        let points = points.ok_or(KnotError::NoSpan)?;
        Self::of_homogeneous(vector, &points, self.weights().is_some())
    }

    /// The middle one of this curve's spans that function `i` of other knots lives on.
    pub(super) fn arc_under(&self, vector: &KnotVector, i: usize) -> Option<usize> {
        let (knots, own) = (self.vector().knots(), self.vector().filled_spans());
        let (from, to) = (*vector.knots().get(i)?, *vector.knots().get(i + vector.order())?);
        let under: Vec<usize> =
            own.iter().copied().filter(|&j| knots[j] < to && knots[j + 1] > from).collect();
        under.get(under.len() / 2).copied()
    }
}
