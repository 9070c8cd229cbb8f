//! The uniform cubic B-splines of one direction, fast, over parameters from 0 to 1.

use super::FitError;
use crate::geometry::knots::KnotVector;

/// The order of cubics.
pub(super) const ORDER: usize = 4;

/// One direction of a net of control points: clamped where it is open, periodic where it is closed, constant where
/// there is one point only.
///
/// At any parameter four control points count. They are numbered for this along the direction and on over its seam:
/// number `e` of a span is `e = span..span + 4`, and [`Axis::node`] says which control point it is.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    count: usize,
    closed: bool,
    spans: usize,
    /// By span: coefficients of powers of the span's parameter, of each of the four functions. One for all spans of a
    /// closed direction.
    pieces: Vec<[[f64; ORDER]; ORDER]>,
}

impl Axis {
    /// The direction of so many control points; `None` for 2 or 3.
    pub(super) fn new(count: usize, closed: bool) -> Result<Option<Self>, FitError> {
        if count == 1 {
            let mut constant = [[0.0; ORDER]; ORDER];
            constant[0][0] = 1.0;
            return Ok(Some(Self { count, closed: false, spans: 1, pieces: vec![constant] }));
        }
        if count < ORDER {
            return Ok(None);
        }
        let spans = if closed { count } else { count + 1 - ORDER };
        let mut axis = Self { count, closed, spans, pieces: Vec::new() };
        let vector = axis.knots()?;
        let own = vector.filled_spans();
        for span in own.iter().take(if closed { 1 } else { spans }) {
            let mut piece = [[0.0; ORDER]; ORDER];
            for (f, bernstein) in vector.bernstein(*span)?.iter().enumerate() {
                let &[a, b, c, d] = bernstein.as_slice() else { continue };
                let powers = [a, 3.0 * (b - a), 3.0 * (c - 2.0 * b + a), d - 3.0 * (c - b) - a];
                for (row, power) in piece.iter_mut().zip(powers) {
                    row[f] = power;
                }
            }
            axis.pieces.push(piece);
        }
        Ok(Some(axis))
    }

    /// The knots: 0, 0, 0, 0, 1/(m-3), ..., 1, 1, 1, 1 or, closed, breaks 0, 1/m, ..., 1.
    pub(super) fn knots(&self) -> Result<KnotVector, FitError> {
        let spans = self.spans;
        let at = |k: usize| k as f64 / spans as f64;
        Ok(if self.closed {
            KnotVector::closed(ORDER, &(0..=spans).map(at).collect::<Vec<_>>())?
        } else {
            let knots = (0..self.count + ORDER).map(|k| at((k + 1).saturating_sub(ORDER).min(spans)));
            KnotVector::new(ORDER, knots.collect())?
        })
    }

    /// The number of control points.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    pub(super) fn closed(&self) -> bool {
        self.closed
    }

    /// Whether there is one control point only.
    pub(super) fn is_point(&self) -> bool {
        self.count == 1
    }

    pub(super) fn spans(&self) -> usize {
        self.spans
    }

    /// How many of the four functions of a span count.
    pub(super) fn width(&self) -> usize {
        if self.is_point() { 1 } else { ORDER }
    }

    /// The control point of a number. In a closed direction the function of point `i` has its middle at `i / m`, where the
    /// net has its neuron `i`.
    pub(super) fn node(&self, e: usize) -> usize {
        if self.closed { (e + self.count - 1) % self.count } else { e.min(self.count - 1) }
    }

    /// The control point at a distance along the direction, over the seam where there is one.
    pub(super) fn beside(&self, node: usize, step: isize) -> Option<usize> {
        let count = self.count as isize;
        let next = node as isize + step;
        if self.closed {
            return usize::try_from(next.rem_euclid(count)).ok();
        }
        usize::try_from(next).ok().filter(|next| *next < self.count)
    }

    /// The parameter at a part of the edge that begins at a neuron of a net with as many.
    pub(super) fn parameter(&self, node: usize, part: f64) -> f64 {
        let edges = if self.closed { self.count } else { self.count.max(2) - 1 };
        self.inside((node as f64 + part) / edges as f64)
    }

    /// The parameter within 0 and 1: round the seam, or to the border.
    #[inline]
    pub(super) fn inside(&self, u: f64) -> f64 {
        if !self.closed {
            return u.clamp(0.0, 1.0);
        }
        let u = u - u.floor();
        // A tiny negative number gives 1.
        if u < 1.0 { u } else { 0.0 }
    }

    /// The span of a parameter and the parameter in it.
    #[inline]
    pub(super) fn place(&self, u: f64) -> (usize, f64) {
        let along = u * self.spans as f64;
        let span = (along as usize).min(self.spans - 1);
        (span, along - span as f64)
    }

    fn piece(&self, span: usize) -> &[[f64; ORDER]; ORDER] {
        let index = if self.pieces.len() == 1 { 0 } else { span };
        &self.pieces[index.min(self.pieces.len() - 1)]
    }

    /// The four functions of a span.
    #[inline]
    pub(super) fn values(&self, span: usize, t: f64) -> [f64; ORDER] {
        let [a, b, c, d] = self.piece(span);
        std::array::from_fn(|f| ((d[f] * t + c[f]) * t + b[f]) * t + a[f])
    }

    /// The four functions of a span and their derivatives by the parameter of the whole direction.
    #[inline]
    pub(super) fn slopes(&self, span: usize, t: f64) -> [[f64; ORDER]; 2] {
        let [a, b, c, d] = self.piece(span);
        let scale = self.spans as f64;
        [
            std::array::from_fn(|f| ((d[f] * t + c[f]) * t + b[f]) * t + a[f]),
            std::array::from_fn(|f| ((3.0 * d[f] * t + 2.0 * c[f]) * t + b[f]) * scale),
        ]
    }
}
