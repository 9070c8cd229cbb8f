//! Knot vectors: checked once, so that nothing behind them divides by zero.

use super::local::{Hom, blossom, derivatives, functions};
use super::{KnotError, MAX_ORDER, MIN_ORDER};
use crate::geometry::param::clipped;
use crate::geometry::{Basis, MAX_POINTS};

/// The largest knot, and the reciprocal of the smallest distance of two: nothing overflows then.
const LIMIT: f64 = 1e40;

/// Knots `u_0 <= ... <= u_{n+k}` of order `k` for control points 0 to n, and the B-spline functions of them
/// (de Boor 1972, Cox 1972). The domain is `[u_{k-1}, u_{n+1}]`; span `j` is `[u_j, u_{j+1}]`.
///
/// As a [`Basis`] it counts only spans that have a length, and their parameters run from 0 to 1.
///
/// ```
/// use grafika::geometry::knots::KnotVector;
/// use grafika::geometry::{Blend, ParamCurve};
///
/// let knots = KnotVector::new(3, vec![0.0, 0.0, 0.0, 1.0, 3.0, 3.0, 3.0])?;
/// assert_eq!(knots.domain(), [0.0, 3.0]);
/// let curve = Blend::new(knots, vec![[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]])?;
/// assert_eq!((curve.spans(), curve.eval(0, 0.0)), (2, Some([0.0, 0.0])));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KnotVector {
    order: usize,
    /// All of them; of a closed curve over one period and `order - 1` more at either side.
    knots: Vec<f64>,
    /// The spans of the domain that have a length.
    spans: Vec<usize>,
    /// The number of control points of a closed curve.
    period: Option<usize>,
}

impl KnotVector {
    /// The knots of an open curve.
    ///
    /// # Errors
    /// A wrong order or number of knots, knots that descend, more than `order` equal ones, a domain without length.
    pub fn new(order: usize, knots: Vec<f64>) -> Result<Self, KnotError> {
        Self::checked(order, knots, None)
    }

    /// The knots of a closed curve of `breaks.len() - 1` control points: the domain is from the first break to the
    /// last, which is the first again. Control point 0 begins at `order - 1` knots before the first break.
    ///
    /// # Errors
    /// As [`KnotVector::new`]; there must be `order` control points at least.
    pub fn closed(order: usize, breaks: &[f64]) -> Result<Self, KnotError> {
        check_order(order)?;
        let count = breaks.len().saturating_sub(1);
        check_knots(breaks)?;
        if count < order || count > MAX_POINTS {
            let (least, most) = (order + 1, MAX_POINTS + 1);
            return Err(KnotError::KnotCount { given: breaks.len(), least, most });
        }
        let period = breaks[count] - breaks[0];
        let (first, last) = (breaks[0], breaks[count]);
        // Counted from one period before; the seam is the same number from both sides.
        let knot = |e: usize| match (e / count, breaks[e % count]) {
            (0, knot) if knot == last => first,
            (0, knot) => knot - period,
            (1, knot) => knot,
            (_, knot) if knot == first => last,
            (_, knot) => knot + period,
        };
        let knots = (count + 1 - order..2 * count + order).map(knot).collect();
        Self::checked(order, knots, Some(count))
    }

    /// Knots 0, 1, 2, ... of an open curve of `points` control points.
    ///
    /// # Errors
    /// As [`KnotVector::new`].
    pub fn uniform(order: usize, points: usize) -> Result<Self, KnotError> {
        check_order(order)?;
        check_points(order, points)?;
        Self::new(order, (0..points + order).map(|i| i as f64).collect())
    }

    /// Knots 0, 1, 2, ... whose first and last are there `order` times: the curve runs from its first control point
    /// to its last.
    ///
    /// # Errors
    /// As [`KnotVector::new`].
    pub fn clamped(order: usize, points: usize) -> Result<Self, KnotError> {
        check_order(order)?;
        check_points(order, points)?;
        let last = points + 1 - order;
        Self::new(
            order,
            (0..points + order).map(|i| (i + 1).saturating_sub(order).min(last) as f64).collect(),
        )
    }

    fn checked(order: usize, knots: Vec<f64>, period: Option<usize>) -> Result<Self, KnotError> {
        check_order(order)?;
        if knots.len() < 2 * order || knots.len() > MAX_POINTS + 2 * MAX_ORDER {
            let most = MAX_POINTS + 2 * MAX_ORDER;
            return Err(KnotError::KnotCount { given: knots.len(), least: 2 * order, most });
        }
        check_knots(&knots)?;
        if let Some(i) = (order..knots.len()).find(|&i| knots[i - order] == knots[i]) {
            return Err(KnotError::TooMultiple { knot: i, most: order });
        }
        let spans: Vec<usize> =
            (order - 1..knots.len() - order).filter(|&j| knots[j] < knots[j + 1]).collect();
        if spans.is_empty() {
            return Err(KnotError::NoSpan);
        }
        Ok(Self { order, knots, spans, period })
    }

    /// The order: degree + 1.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// All knots; those of a closed curve go on for `order - 1` knots at either side of its domain.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// From the first break of a closed curve to the last; `None` for an open one.
    #[must_use]
    pub fn breaks(&self) -> Option<&[f64]> {
        self.period.and_then(|count| self.knots.get(self.order - 1..self.order + count))
    }

    /// The parameters from which to which the curve runs.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        [self.knots[self.order - 1], self.knots[self.controls()]]
    }

    /// How many control points the formulas count: those of a closed curve go on with its first `order - 1` again.
    #[must_use]
    pub fn controls(&self) -> usize {
        self.knots.len() - self.order
    }

    /// The spans of the domain that have a length, in the order in which a [`Basis`] counts them.
    #[must_use]
    pub fn filled_spans(&self) -> &[usize] {
        &self.spans
    }

    /// The span of a parameter: the largest that begins at or before it, so that the right end is in the last one.
    /// `None` outside the domain.
    #[must_use]
    pub fn span_of(&self, u: f64) -> Option<usize> {
        let [from, to] = self.domain();
        if !(from <= u && u <= to) {
            return None;
        }
        let later = self.spans.partition_point(|&j| self.knots[j] <= u);
        self.spans.get(later.checked_sub(1)?).copied()
    }

    /// How often a value is among the knots.
    #[must_use]
    pub fn multiplicity(&self, u: f64) -> usize {
        self.knots.iter().filter(|knot| **knot == u).count()
    }

    /// Of knot `knot` and its equal neighbours, the first and how many there are.
    ///
    /// # Errors
    /// [`KnotError::Index`].
    pub fn copies(&self, knot: usize) -> Result<(usize, usize), KnotError> {
        let Some(&value) = self.knots.get(knot) else {
            let last = self.knots.len() - 1;
            return Err(KnotError::Index { name: "knot", given: knot, first: 0, last });
        };
        let first = self.knots.partition_point(|other| *other < value);
        Ok((first, self.multiplicity(value)))
    }

    /// The same with other values of knots, in order; a closed curve takes one period of them.
    ///
    /// # Errors
    /// As [`KnotVector::new`] and [`KnotVector::closed`].
    pub fn with_knot(&self, knot: usize, value: f64) -> Result<Self, KnotError> {
        let last = self.knots.len() - 1;
        if knot > last {
            return Err(KnotError::Index { name: "knot", given: knot, first: 0, last });
        }
        let Some(count) = self.period else {
            let mut knots = self.knots.clone();
            knots[knot] = value;
            return Self::new(self.order, knots);
        };
        // The copy of the knot in the domain.
        let mut breaks = self.knots[self.order - 1..self.order + count].to_vec();
        let period = breaks[count] - breaks[0];
        let place = (knot + count * 2 + 1 - self.order) % count;
        let moved = value - self.knots[knot];
        breaks[place] += moved;
        if place == 0 {
            breaks[count] = breaks[0] + period;
        }
        Self::closed(self.order, &breaks)
    }

    /// Control points as the formulas count them, for index `i`.
    pub(super) fn point_index(&self, i: usize) -> usize {
        self.period.map_or(i, |count| i % count)
    }

    /// The functions that live on the span of `u`: the first of them and, for every one, the value and all derivatives
    /// by `u` up to degree `order - 1`. `None` outside the domain.
    #[must_use]
    pub fn all_derivatives(&self, u: f64) -> Option<(usize, Vec<Vec<f64>>)> {
        let span = self.span_of(u)?;
        let rows: Option<Vec<[f64; MAX_ORDER]>> =
            (0..self.order).map(|r| derivatives(&self.knots, self.order, span, u, r, 1.0)).collect();
        let rows = rows?;
        Some((
            span + 1 - self.order,
            (0..self.order).map(|l| rows.iter().map(|row| row[l]).collect()).collect(),
        ))
    }

    /// The functions that live on a span as exact Bézier arcs: the Bernstein coefficients of each.
    ///
    /// # Errors
    /// A span outside the domain or without length.
    pub fn bernstein(&self, span: usize) -> Result<Vec<Vec<f64>>, KnotError> {
        self.check_span(span)?;
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        let coefficient = |function: usize, c: usize| {
            let mut local = [Hom::<0>::ZERO; MAX_ORDER];
            local[function].w = 1.0;
            let argument = |r: usize| if r < c { to } else { from };
            blossom(&self.knots, span, &local[..self.order], 0, 1.0, argument).map_or(0.0, |value| value.w)
        };
        Ok((0..self.order).map(|l| (0..self.order).map(|c| coefficient(l, c)).collect()).collect())
    }

    /// The check on a span that is given.
    pub(super) fn check_span(&self, span: usize) -> Result<(), KnotError> {
        let (first, last) = (self.order - 1, self.controls() - 1);
        if !(first..=last).contains(&span) {
            return Err(KnotError::Index { name: "span", given: span, first, last });
        }
        if self.knots[span] >= self.knots[span + 1] {
            return Err(KnotError::EmptySpan { span });
        }
        Ok(())
    }

    /// The check on a parameter of a span.
    pub(super) fn check_inside(&self, name: &'static str, span: usize, u: f64) -> Result<(), KnotError> {
        self.check_span(span)?;
        let range = [self.knots[span], self.knots[span + 1]];
        if u >= range[0] && u <= range[1] {
            return Ok(());
        }
        Err(KnotError::Outside { name, value: u, range })
    }

    /// The span and its parameter of span number `number` of the [`Basis`] at `u` in [0, 1], and its width.
    pub(super) fn place(&self, number: usize, u: f64) -> Option<(usize, f64, f64)> {
        let span = *self.spans.get(number)?;
        let (from, to, u) = (self.knots[span], self.knots[span + 1], clipped(u));
        Some((span, (1.0 - u) * from + u * to, to - from))
    }
}

fn check_order(order: usize) -> Result<(), KnotError> {
    if (MIN_ORDER..=MAX_ORDER).contains(&order) {
        return Ok(());
    }
    Err(KnotError::Order { given: order })
}

fn check_points(order: usize, points: usize) -> Result<(), KnotError> {
    if (order..=MAX_POINTS).contains(&points) {
        return Ok(());
    }
    let given = points.saturating_add(order);
    Err(KnotError::KnotCount { given, least: 2 * order, most: MAX_POINTS + order })
}

fn check_knots(knots: &[f64]) -> Result<(), KnotError> {
    if let Some(knot) = knots.iter().position(|u| u.is_nan() || u.abs() > LIMIT) {
        return Err(KnotError::NotFinite { knot });
    }
    for (i, pair) in knots.windows(2).enumerate() {
        if pair[1] < pair[0] {
            return Err(KnotError::NotAscending { knot: i + 1, before: pair[0], value: pair[1] });
        }
        if pair[1] > pair[0] && pair[1] - pair[0] < 1.0 / LIMIT {
            return Err(KnotError::TooNear { knot: i + 1 });
        }
    }
    Ok(())
}

impl Basis for KnotVector {
    fn points(&self) -> usize {
        self.period.unwrap_or(self.controls())
    }

    fn spans(&self) -> usize {
        self.spans.len()
    }

    fn closed(&self) -> bool {
        self.period.is_some()
    }

    fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize> {
        let (j, u, width) = self.place(span, u)?;
        let of = |slopes| derivatives(&self.knots, self.order, j, u, slopes, width);
        let [values, slopes, bends] = [functions(&self.knots, self.order, j, u)?, of(1)?, of(2)?];
        out.clear();
        out.extend((0..self.order).map(|l| [values[l], slopes[l], bends[l]]));
        Some(self.point_index(j + 1 - self.order))
    }

    fn values(&self, span: usize, u: f64, out: &mut Vec<f64>) -> Option<usize> {
        let (j, u, _) = self.place(span, u)?;
        let values = functions(&self.knots, self.order, j, u)?;
        out.clear();
        out.extend_from_slice(&values[..self.order]);
        Some(self.point_index(j + 1 - self.order))
    }
}
