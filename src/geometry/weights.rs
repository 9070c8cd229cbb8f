//! The linear map from control points to the arcs of a piecewise cubic curve.
//!
//! Weights depend on the method, the ends and the number of points, never on the points, so one
//! set serves every redraw while points move, every coordinate, and both directions of a surface:
//! weights along `v` for each row of the net, then weights along `u` for each column of results.

use super::cubic::check_arcs;
use super::method::{Closure, Ends, Method};
use super::point::{check_count, check_points};
use super::spline::Spline;
use super::window::{Window, windows};
use super::{CubicBezier, GeometryError, Point};

/// "Span `s`, Bernstein coefficient `c` is these weights times those control points" for one
/// method, end rule and number of points. Built once, applied to any points by [`Weights::arcs`].
///
/// Closed curves have one span per control point; span `s` starts at or near point `s` (that of
/// the quadratic B-spline turns around it). Open curves of `n` points have `n - 1` spans, the
/// quadratic B-spline `n - 2`, the cubic one `n + 1`.
#[derive(Clone, Debug)]
pub struct Weights {
    points: usize,
    closed: bool,
    rule: Rule,
}

#[derive(Clone, Debug)]
enum Rule {
    Windows(Vec<Window>),
    Spline(Spline),
}

impl Weights {
    /// The weights of a curve by `points` control points with the method's own ends.
    ///
    /// # Errors
    /// Too few or too many points, a bad parameter, the critical tension, or
    /// [`GeometryError::NotPiecewise`] for [`Method::Bezier`].
    pub fn new(method: Method, closure: Closure, points: usize) -> Result<Self, GeometryError> {
        Self::with_ends(method, closure.into(), points)
    }

    /// The weights with a chosen end rule; surfaces double their border points or give auxiliary
    /// ones. With [`Ends::Auxiliary`] the auxiliary points count among `points`.
    ///
    /// # Errors
    /// As [`Weights::new`]; [`GeometryError::EndsNotOffered`] when a spline is to have other ends
    /// than open or closed.
    pub fn with_ends(method: Method, ends: Ends, points: usize) -> Result<Self, GeometryError> {
        method.check()?;
        check_count(points, method.fewest_points(ends))?;
        let rule = match windows(method, ends, points) {
            Some(windows) => Rule::Windows(windows),
            None => other_rule(method, ends, points)?,
        };
        Ok(Self { points, closed: ends == Ends::Closed, rule })
    }

    /// The number of control points these weights are for.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// The number of spans.
    #[must_use]
    pub fn spans(&self) -> usize {
        match &self.rule {
            Rule::Windows(windows) => windows.len(),
            Rule::Spline(spline) => spline.spans(),
        }
    }

    /// Whether the curves return to their beginning.
    #[must_use]
    pub fn closed(&self) -> bool {
        self.closed
    }

    /// The first control point that a span sees, and the Bernstein coefficients of its weight and of its
    /// followers'; after the last point comes the first again. `None` outside the spans.
    pub(super) fn functions(&self, span: usize) -> Option<(usize, Vec<[f64; 4]>)> {
        match &self.rule {
            Rule::Windows(windows) => windows.get(span).map(Window::functions),
            Rule::Spline(spline) if span < spline.spans() => {
                let rows: [Vec<f64>; 4] = std::array::from_fn(|coefficient| spline.row(span, coefficient));
                let [a, b, c, d] = &rows;
                let columns = a.iter().zip(b).zip(c).zip(d).map(|(((a, b), c), d)| [*a, *b, *c, *d]);
                Some((0, columns.collect()))
            }
            Rule::Spline(_) => None,
        }
    }

    /// Weights times points: one arc per span.
    ///
    /// # Errors
    /// [`GeometryError::WrongCount`], a bad coordinate, or [`GeometryError::Overflow`].
    pub fn arcs<const D: usize>(&self, points: &[Point<D>]) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        if points.len() != self.points {
            return Err(GeometryError::WrongCount { given: points.len(), needed: self.points });
        }
        check_points(points)?;
        let arcs = match &self.rule {
            Rule::Windows(windows) => windows.iter().filter_map(|window| window.arc(points)).collect(),
            Rule::Spline(spline) => spline.arcs(points),
        };
        check_arcs(arcs)
    }

    /// The row of the matrix that gives Bernstein coefficient `coefficient` (0 to 3) of span
    /// `span`: one weight per control point, summing to 1. `None` outside the spans.
    #[must_use]
    pub fn row(&self, span: usize, coefficient: usize) -> Option<Vec<f64>> {
        if span >= self.spans() || coefficient > 3 {
            return None;
        }
        match &self.rule {
            Rule::Windows(windows) => windows.get(span)?.row(coefficient, self.points),
            Rule::Spline(spline) => Some(spline.row(span, coefficient)),
        }
    }
}

/// The rule of the methods that have no windows.
fn other_rule(method: Method, ends: Ends, n: usize) -> Result<Rule, GeometryError> {
    match (method, ends) {
        (Method::Spline, Ends::Open) => Ok(Rule::Spline(Spline::natural(n))),
        (Method::Spline, Ends::Closed) => Ok(Rule::Spline(Spline::periodic(n))),
        (Method::Spline, _) => Err(GeometryError::EndsNotOffered { method: method.name() }),
        _ => Err(GeometryError::NotPiecewise { method: method.name() }),
    }
}
