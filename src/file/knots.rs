//! Curves and surfaces by their knots, `.CSM` and `.CSF`, which are JSON only.

use super::check::{self, number};
use super::{FileError, Places};
use crate::geometry::Point;
use crate::geometry::knots::{KnotError, KnotSurface, KnotVector, MAX_ORDER, MIN_ORDER};
use serde::{Deserialize, Serialize};

/// The most control points of curves and nets by knots.
pub const MAX_CONTROLS: usize = 100_000;

/// The order of cubic curves.
const CUBIC: usize = 4;

/// A B-spline curve or a NURBS.
///
/// Points may be fewer than the order: such a document is no curve yet. Knots are always as many as points and the order
/// together; of a closed curve they are the breaks of one period, one more than points.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnotPoints {
    /// Degree + 1, 2 to 8.
    pub order: usize,
    /// Whether the last span is followed by the first.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// The control points.
    pub points: Places,
    /// A weight for every point; all 1 if they are missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights: Option<Vec<f64>>,
    /// The knots, ascending.
    pub knots: Vec<f64>,
}

/// A B-spline surface or a NURBS.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnotNet {
    /// Degree + 1 along u and v, 2 to 8.
    pub order: [usize; 2],
    /// Whether the last span along u, along v is followed by the first.
    #[serde(default, skip_serializing_if = "is_open")]
    pub closed: [bool; 2],
    /// The control points: rows count along u, points of a row along v.
    pub points: Vec<Vec<Point<3>>>,
    /// A weight for every point; all 1 if they are missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights: Option<Vec<Vec<f64>>>,
    /// The knots along u and v, ascending; those of a closed direction as of a closed [curve](KnotPoints).
    pub knots: [Vec<f64>; 2],
}

fn is_open(closed: &[bool; 2]) -> bool {
    *closed == [false; 2]
}

/// One sentence about a document that cannot be.
fn invalid(error: impl ToString) -> FileError {
    FileError::Invalid(error.to_string())
}

impl KnotPoints {
    /// The cubic B-spline over the knots 0, 1, 2, ...
    #[must_use]
    pub fn of_points(points: impl Into<Places>) -> Self {
        let points = points.into();
        let knots = (0..points.len() + CUBIC).map(|knot| knot as f64).collect();
        Self { order: CUBIC, points, knots, ..Self::default() }
    }

    /// The knots as the mathematics knows them.
    ///
    /// # Errors
    /// What is wrong with them; also [`KnotError::KnotCount`] for fewer points than the order.
    pub fn vector(&self) -> Result<KnotVector, KnotError> {
        vector(self.order, self.closed, &self.knots)
    }

    /// Whether there are enough points for a curve.
    #[must_use]
    pub fn is_curve(&self) -> bool {
        self.points.len() >= self.order
    }

    /// # Errors
    /// [`FileError::Invalid`] with the number that would be right.
    pub(super) fn check(&self) -> Result<(), FileError> {
        self.points.check()?;
        if !(MIN_ORDER..=MAX_ORDER).contains(&self.order) {
            return Err(invalid(KnotError::Order { given: self.order }));
        }
        let count = self.points.len();
        let needed = if self.closed { count + 1 } else { count + self.order };
        if self.knots.len() != needed && !(self.closed && count == 0 && self.knots.is_empty()) {
            return Err(invalid(format!(
                "{} knots for {count} points of order {}; there must be {needed}",
                self.knots.len(),
                self.order
            )));
        }
        if let Some(knot) = self.knots.iter().position(|knot| !knot.is_finite()) {
            return Err(invalid(KnotError::NotFinite { knot }));
        }
        if let Some(before) = self.knots.windows(2).position(|pair| pair[0] > pair[1]) {
            let [before_it, value] = [self.knots[before], self.knots[before + 1]];
            return Err(invalid(KnotError::NotAscending { knot: before + 1, before: before_it, value }));
        }
        if let Some(weights) = &self.weights {
            check::one_each("weights", weights.len(), count)?;
            check_weights(weights)?;
        }
        if self.is_curve() { self.vector().map(|_| ()).map_err(invalid) } else { Ok(()) }
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let kind = if self.weights.is_some() { "NURBS curve" } else { "B-spline curve" };
        let place = if matches!(self.points, Places::Plane(_)) { "of the plane" } else { "in space" };
        let closed = if self.closed { ", closed" } else { "" };
        let count = check::counted(self.points.len(), "control point");
        let mut lines = vec![format!("{kind} {place}: {count}, order {}{closed}", self.order)];
        lines.extend(self.points.bounds());
        if let Ok(vector) = self.vector() {
            let [from, to] = vector.domain().map(number);
            lines.push(format!("domain: {from} to {to}, {} spans", vector.filled_spans().len()));
        }
        lines.push(format!("knots: {}", listed(&self.knots)));
        let weight = |index: usize| match &self.weights {
            Some(weights) => format!(", weight {}", weights.get(index).copied().map_or("1".into(), number)),
            None => String::new(),
        };
        lines.extend(self.points.table(weight));
        lines
    }
}

fn vector(order: usize, closed: bool, knots: &[f64]) -> Result<KnotVector, KnotError> {
    match closed {
        true => KnotVector::closed(order, knots),
        false => KnotVector::new(order, knots.to_vec()),
    }
}

impl KnotNet {
    /// The surface.
    ///
    /// # Errors
    /// What is wrong with knots, points or weights.
    pub fn surface(&self) -> Result<KnotSurface, KnotError> {
        let [u, v] = [0, 1].map(|d| vector(self.order[d], self.closed[d], &self.knots[d]));
        KnotSurface::new([u?, v?], self.points.clone(), self.weights.clone())
    }

    /// The document of a surface.
    #[must_use]
    pub fn of(surface: &KnotSurface) -> Self {
        let [u, v] = surface.vectors();
        Self {
            order: [u.order(), v.order()],
            closed: [u, v].map(|vector| vector.breaks().is_some()),
            points: surface.net().to_vec(),
            weights: surface.weights().map(<[Vec<f64>]>::to_vec),
            knots: [u, v].map(|vector| vector.breaks().unwrap_or(vector.knots()).to_vec()),
        }
    }

    /// # Errors
    /// [`FileError::Invalid`] with the number that would be right.
    pub(super) fn check(&self) -> Result<(), FileError> {
        let count: usize = self.points.iter().map(Vec::len).sum();
        if count > MAX_CONTROLS {
            return Err(invalid(format!("{count} control points; there may be {MAX_CONTROLS} at most")));
        }
        for (row, points) in self.points.iter().enumerate() {
            check::finite(&format!("row {}, point", row + 1), points)?;
        }
        for weights in self.weights.iter().flatten() {
            check_weights(weights)?;
        }
        self.surface().map(|_| ()).map_err(invalid)
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let kind = if self.weights.is_some() { "NURBS surface" } else { "B-spline surface" };
        let columns = self.points.first().map_or(0, Vec::len);
        let [k, l] = self.order;
        let mut lines =
            vec![format!("{kind}: {} x {columns} control points, orders {k} and {l}", self.points.len())];
        lines.extend(check::Bounds::of(self.points.iter().flatten()).map(|bounds| bounds.describe()));
        for (name, knots) in ["u", "v"].into_iter().zip(&self.knots) {
            lines.push(format!("knots along {name}: {}", listed(knots)));
        }
        for (row, points) in self.points.iter().enumerate() {
            lines.extend(check::table(&format!("row {}, point", row + 1), points));
        }
        lines
    }
}

/// Every weight is a positive number.
fn check_weights(weights: &[f64]) -> Result<(), FileError> {
    match weights.iter().position(|weight| !(weight.is_finite() && *weight > 0.0)) {
        Some(point) => Err(invalid(KnotError::Weight { point, value: weights[point] })),
        None => Ok(()),
    }
}

fn listed(numbers: &[f64]) -> String {
    numbers.iter().copied().map(number).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use crate::file::Document;

    fn refused(text: &str) -> String {
        Document::from_json(text).unwrap_err().to_string()
    }

    #[test]
    fn what_is_wrong_is_told_with_what_would_be_right() {
        let with = |rest: &str| format!("{{\"format\":\"CSM\",\"order\":3,{rest}}}");
        let points = "\"points\":[[0,0],[1,2],[3,0]]";
        for (text, told) in [
            (
                with(&format!("{points},\"knots\":[0,0,0,1,1]")),
                "5 knots for 3 points of order 3; there must be 6",
            ),
            (with(&format!("{points},\"knots\":[0,0,0,2,1,1]")), "knot 4 is 1, but the one before is 2"),
            (
                with(&format!("{points},\"knots\":[0,0,0,0,1,1]")),
                "too many knots equal to knot 3; 3 are allowed",
            ),
            (
                with(&format!("{points},\"knots\":[0,0,0,1,1,1],\"weights\":[1,0,1]")),
                "weight of control point 1 is 0",
            ),
            (with(&format!("{points},\"knots\":[0,0,0,1,1,1],\"weights\":[1,1]")), "2 weights for 3 points"),
            (
                with("\"points\":[[0,0],[1,2,3]],\"knots\":[]"),
                "the number of coordinates of point 1 is 3; the first has 2",
            ),
            (
                with("\"points\":[[0]],\"knots\":[]"),
                "the number of coordinates of point 0 is 1; 2 or 3 are possible",
            ),
            (
                with(&format!("{points},\"knots\":[0,0,0,1,1,1]")).replace(":3,", ":9,"),
                "the order is 9; it must be 2 to 8",
            ),
        ] {
            let refused = refused(&text);
            assert!(refused.contains(told), "{refused}");
        }
    }

    #[test]
    fn fewer_points_than_the_order_are_no_curve_yet() {
        let text = "{\"format\":\"CSM\",\"order\":4,\"points\":[[0,0]],\"knots\":[0,1,2,3,4]}";
        let document = Document::from_json(text).unwrap();
        assert!(matches!(&document, Document::Knots(knots) if !knots.is_curve()));
        assert_eq!(Document::from_json(&document.to_json().unwrap()).unwrap(), document);
    }
}
