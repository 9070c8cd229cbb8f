//! Which curves the editor draws through the control points, and as what pixels.

use super::layout::to_screen;
use super::sketch::Sketch;
use super::tools::Tools;
use crate::editor::choice::Choice;
use crate::geometry::{Closure, CubicBezier, Curve, GeometryError, Method, Point, VaryingBeta, hermite_arcs};
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

/// In how many steps the originals draw a span.
fn steps(tools: Tools, method: Method) -> usize {
    match (tools, method) {
        (Tools::Tangents, _) => 20,
        (Tools::Beta, _) => 500,
        (Tools::Methods, Method::Bezier) => 100,
        (Tools::Methods, _) => 50,
    }
}

/// The curve that a program draws for a choice, or why there is none.
pub(super) fn pixels(tools: Tools, choice: Choice, sketch: &Sketch) -> Result<Pixels, GeometryError> {
    let Choice { closure, method } = choice;
    let steps = steps(tools, method);
    match (tools, &sketch.tangents, &sketch.joints) {
        (Tools::Tangents, Some(tangents), _) => {
            let curve = Curve::Piecewise(hermite_arcs(closure, sketch.points(), tangents)?);
            Ok(Pixels { line: screen_line(&curve.polyline(steps)?), joints: Vec::new() })
        }
        (Tools::Beta, _, Some(joints)) => {
            let curve = VaryingBeta::new(closure, sketch.points(), joints)?;
            let point = |span, step| curve.eval(span, step as f64 / steps as f64);
            let spans = 0..curve.spans();
            let line: Vec<_> =
                spans.flat_map(|span| (0..=steps).filter_map(move |step| point(span, step))).collect();
            let marks = curve.joints();
            Ok(Pixels { line: screen_line(&line), joints: screen_line(&marks) })
        }
        (Tools::Beta, ..) => {
            let curve = Curve::through(sketch.shape.method(), closure, sketch.points())?;
            let joints = match &curve {
                Curve::Piecewise(arcs) => joints(arcs, closure),
                Curve::Bezier(_) => Vec::new(),
            };
            Ok(Pixels { line: screen_line(&curve.polyline(steps)?), joints })
        }
        _ => {
            let curve = Curve::through(method, closure, sketch.points())?;
            Ok(Pixels { line: screen_line(&curve.polyline(steps)?), joints: Vec::new() })
        }
    }
}

/// Where arcs join: at both ends of each.
fn joints(arcs: &[CubicBezier<2>], closure: Closure) -> Vec<(i32, i32)> {
    let first = arcs.first().filter(|_| closure == Closure::Open).map(|arc| arc.p[0]);
    first.into_iter().chain(arcs.iter().map(|arc| arc.p[3])).map(to_screen).collect()
}

fn screen_line(points: &[Point<2>]) -> Vec<(i32, i32)> {
    points.iter().copied().map(to_screen).collect()
}

/// Draws a curve with a thick line and its joints with small discs.
pub(super) fn draw(screen: &mut Screen, pixels: &Pixels, color: Color) {
    screen.polyline(&pixels.line, Stroke::thick(color));
    for &(x, y) in &pixels.joints {
        screen.disc(x, y, 3, Color::Black, color);
        screen.circle(x, y, 3, Stroke::thick(color));
    }
}
