//! Which curves the editor draws through the control points, and as what pixels.

use super::layout::to_screen;
use super::sketch::Sketch;
use super::tools::Tools;
use crate::editor::beta;
use crate::editor::choice::{BETA_STEPS, Choice};
use crate::figure::tolerance;
use crate::geometry::{
    BoundingBox, Closure, CubicBezier, Curve, GeometryError, Method, ParamCurve, Point, VaryingBeta,
    hermite_arcs,
};
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

/// The curve that a program draws for a choice.
pub(super) enum Traced {
    Plain(Curve<2>),
    /// A beta-spline whose joints differ in shape.
    Varying(VaryingBeta<2>),
}

/// The curve that a program draws for a choice, or why there is none.
pub(super) fn trace(tools: Tools, choice: Choice, sketch: &Sketch) -> Result<Traced, GeometryError> {
    let (closure, points) = (choice.closure, sketch.points());
    match (tools, &sketch.tangents, &sketch.joints) {
        (Tools::Tangents, Some(tangents), _) => {
            hermite_arcs(closure, points, tangents).map(|arcs| Traced::Plain(Curve::Piecewise(arcs)))
        }
        (Tools::Beta, _, Some(joints)) => VaryingBeta::new(closure, points, joints).map(Traced::Varying),
        (Tools::Beta, ..) => {
            let choice = Choice { closure, method: sketch.shape.method() };
            choice.curve(points).map(Traced::Plain)
        }
        _ => choice.curve(points).map(Traced::Plain),
    }
}

impl Traced {
    /// The curve as cubic arcs: exactly, or as near as a picture can show.
    pub(super) fn arcs(&self, points: &[Point<2>]) -> Result<Vec<CubicBezier<2>>, GeometryError> {
        match self {
            Traced::Plain(curve) => curve.to_cubics(tolerance(curve.bounding_box())),
            Traced::Varying(curve) => curve.to_cubics(tolerance(BoundingBox::of_points(points))),
        }
    }

    /// Where its spans join, if the program marks that.
    pub(super) fn joints(&self, tools: Tools, closure: Closure) -> Vec<Point<2>> {
        match self {
            Traced::Plain(curve) if tools == Tools::Beta => beta::joints(curve, closure),
            Traced::Plain(_) => Vec::new(),
            Traced::Varying(curve) => curve.joints(),
        }
    }
}

/// The curve that a program draws for a choice as pixels, or why there is none.
pub(super) fn pixels(tools: Tools, choice: Choice, sketch: &Sketch) -> Result<Pixels, GeometryError> {
    let traced = trace(tools, choice, sketch)?;
    let steps = match tools {
        Tools::Methods => choice.steps(),
        Tools::Tangents => TANGENT_STEPS,
        Tools::Beta => BETA_STEPS,
    };
    let line = match &traced {
        Traced::Plain(curve) => screen_line(curve.polyline(steps)?),
        Traced::Varying(curve) => screen_line(curve.polyline(steps)?),
    };
    Ok(Pixels { line, joints: places(traced.joints(tools, choice.closure)) })
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
