//! Which curves the editor draws through the control points, and as what pixels.

use super::layout::to_screen;
use super::sketch::Sketch;
use super::tools::Tools;
use crate::editor::beta;
use crate::editor::choice::{BETA_STEPS, Choice};
use crate::geometry::{Curve, GeometryError, Method, Point, VaryingBeta, hermite_arcs};
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

/// A curve as pixels: the line, and where its spans join if the program marks that.
#[derive(Clone, Debug, Default)]
pub(super) struct Pixels {
    pub(super) line: Vec<(i32, i32)>,
    pub(super) joints: Vec<(i32, i32)>,
}

/// Steps that a span with given tangents is drawn in.
const TANGENT_STEPS: usize = 20;

/// The curve that a program draws for a choice, or why there is none.
pub(super) fn pixels(tools: Tools, choice: Choice, sketch: &Sketch) -> Result<Pixels, GeometryError> {
    let closure = choice.closure;
    match (tools, &sketch.tangents, &sketch.joints) {
        (Tools::Tangents, Some(tangents), _) => {
            let curve = Curve::Piecewise(hermite_arcs(closure, sketch.points(), tangents)?);
            Ok(Pixels { line: screen_line(curve.polyline(TANGENT_STEPS)?), joints: Vec::new() })
        }
        (Tools::Beta, _, Some(joints)) => {
            let curve = VaryingBeta::new(closure, sketch.points(), joints)?;
            let points = (0..curve.spans()).flat_map(|span| curve.span_points(span, BETA_STEPS));
            Ok(Pixels { line: screen_line(points), joints: places(curve.joints()) })
        }
        (Tools::Beta, ..) => {
            let choice = Choice { closure, method: sketch.shape.method() };
            let joints = beta::joints(&choice.curve(sketch.points())?, closure);
            Ok(Pixels { line: screen_line(choice.polyline(sketch.points())?), joints: places(joints) })
        }
        _ => Ok(Pixels { line: screen_line(choice.polyline(sketch.points())?), joints: Vec::new() }),
    }
}

/// The pixels of points, one for each.
fn places(points: Vec<Point<2>>) -> Vec<(i32, i32)> {
    points.into_iter().map(to_screen).collect()
}

/// The pixels that a polyline goes through. Fine steps fall on the same pixel many times; once is enough.
fn screen_line(points: impl IntoIterator<Item = Point<2>>) -> Vec<(i32, i32)> {
    let mut pixels: Vec<_> = points.into_iter().map(to_screen).collect();
    pixels.dedup();
    pixels
}

/// Draws a curve with a thick line and its joints with small discs.
pub(super) fn draw(screen: &mut Screen, pixels: &Pixels, color: Color) {
    screen.polyline(&pixels.line, Stroke::thick(color));
    pixels.joints.iter().for_each(|&joint| beta::draw_joint(screen, joint));
}
