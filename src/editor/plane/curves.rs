//! Which curves the editor draws through the control points, and as what pixels.

use super::layout::to_screen;
use crate::editor::choice::Choice;
use crate::geometry::{GeometryError, Method, Point};
use crate::screen::{Color, Screen, Stroke};
use serde::Serialize;

/// A kind of curve that can be laid beside others to compare them, with its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Kind {
    Coons,
    Bezier,
    Spline,
    BSpline2,
    BSpline3,
}

impl Kind {
    /// Every kind with the name it is listed by and its colour.
    pub(super) const ALL: [(Kind, &'static str, Color); 5] = [
        (Kind::Coons, "Coons", Color::LightRed),
        (Kind::Bezier, "Bézier", Color::LightGreen),
        (Kind::Spline, "Spline", Color::Yellow),
        (Kind::BSpline2, "B-spl. 2", Color::LightBlue),
        (Kind::BSpline3, "B-spl. 3", Color::LightMagenta),
    ];

    /// The method of this kind.
    pub(super) fn method(self, k0: f64) -> Method {
        match self {
            Kind::Coons => Method::Coons { k0 },
            Kind::Bezier => Method::Bezier,
            Kind::Spline => Method::Spline,
            Kind::BSpline2 => Method::BSpline2,
            Kind::BSpline3 => Method::BSpline3,
        }
    }
}

/// The pixels of a curve, or why there is none.
pub(super) fn pixels(choice: Choice, points: &[Point<2>]) -> Result<Vec<(i32, i32)>, GeometryError> {
    Ok(choice.polyline(points)?.into_iter().map(to_screen).collect())
}

/// Draws a curve with a thick line; one that does not exist draws nothing.
pub(super) fn draw(screen: &mut Screen, choice: Choice, points: &[Point<2>], color: Color) {
    if let Ok(pixels) = pixels(choice, points) {
        screen.polyline(&pixels, Stroke::thick(color));
    }
}
