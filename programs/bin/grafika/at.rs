//! Points of a curve at given parameters, and of curves by their knots at equal steps of their own parameter.

use grafika::design::{Design, DesignError, Shape, knots, shaped};
use grafika::file::{FamilyName, ShapedPoints};
use grafika::geometry::knots::{KnotCurve, KnotError};
use grafika::geometry::shaped::ShapedCurve;
use grafika::geometry::{ParamCurve, Point, slopes};
use grafika::launch::Failure;
use std::f64::consts::TAU;

/// The columns of a sampled curve besides its parameters and points.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Columns {
    /// How many derivatives.
    pub(crate) derivatives: usize,
    /// Whether dy/dx, in space dz/dx too.
    pub(crate) slopes: bool,
}

impl Columns {
    /// Their names, after those of the parameters.
    pub(crate) fn names<const D: usize>(self) -> Vec<String> {
        let axes = ["x", "y", "z"].into_iter().take(D);
        let orders = ["", "d", "dd"].into_iter().take(self.derivatives + 1);
        let points = orders.flat_map(|order| axes.clone().map(move |axis| format!("{order}{axis}")));
        let slopes = slope_names::<D>().into_iter().filter(|_| self.slopes);
        points.chain(slopes).collect()
    }

    /// The numbers of a point with its derivatives, of which there is the first where there are slopes.
    pub(crate) fn numbers<const D: usize>(self, points: &[Point<D>]) -> Vec<Option<f64>> {
        let shown = points.iter().take(self.derivatives + 1).flatten().copied().map(Some);
        let tangent = points.get(1).filter(|_| self.slopes);
        shown.chain(tangent.into_iter().flat_map(|&tangent| slopes(tangent))).collect()
    }

    /// How many derivatives have to be known.
    fn needed(self) -> usize {
        self.derivatives.max(usize::from(self.slopes))
    }
}

/// The names of the slopes.
pub(crate) fn slope_names<const D: usize>() -> Vec<String> {
    ["y", "z"].into_iter().take(D.saturating_sub(1)).map(|axis| format!("d{axis}/dx")).collect()
}

/// A row of numbers, or why there is none.
pub(crate) type Row = Result<Vec<Option<f64>>, Failure>;

/// Rows of numbers below the names of their columns.
pub(crate) struct Rows {
    pub(crate) header: Vec<String>,
    pub(crate) rows: Box<dyn Iterator<Item = Row>>,
}

/// Points with so many derivatives at these parameters: by the knots of a curve that has some, by the position of a curve
/// with shape parameters, else by span + u.
pub(crate) fn rows(design: &Design, shape: &Shape, at: &[f64], columns: Columns) -> Result<Rows, Failure> {
    match design {
        Design::Knots(document) => match knots::curve(document).map_err(Failure::work)? {
            knots::Curve::Plane(curve) => table(at, columns, |u| by_knots(&curve, u, columns)),
            knots::Curve::Space(curve) => table(at, columns, |u| by_knots(&curve, u, columns)),
        },
        Design::Shaped(document) => match shaped::curve(document).map_err(Failure::work)? {
            shaped::Curve::Plane(curve) => table(at, columns, |u| by_position(document, &curve, u)),
            shaped::Curve::Space(curve) => table(at, columns, |u| by_position(document, &curve, u)),
        },
        _ => match shape {
            Shape::Plane(curve) => table(at, columns, |u| by_span(&**curve, u)),
            Shape::Space(curve) => table(at, columns, |u| by_span(&**curve, u)),
            Shape::Surface(_) | Shape::Parts(_) | Shape::Outlines(_) => {
                Err(Failure::usage("--at is for single curves; this file holds something else"))
            }
        },
    }
}

/// Equal steps in every span of a curve by its knots; `None` for other curves, whose spans have a parameter of their own.
pub(crate) fn steps(design: &Design, per_span: usize, columns: Columns) -> Result<Option<Rows>, Failure> {
    let Design::Knots(document) = design else { return Ok(None) };
    match knots::curve(document).map_err(Failure::work)? {
        knots::Curve::Plane(curve) => Ok(Some(spans(curve, per_span, columns))),
        knots::Curve::Space(curve) => Ok(Some(spans(curve, per_span, columns))),
    }
}

fn spans<const D: usize>(curve: KnotCurve<D>, per_span: usize, columns: Columns) -> Rows {
    let knots = curve.vector().knots().to_vec();
    let part = move |span: usize, k: usize| {
        let t = k as f64 / per_span as f64;
        (1.0 - t) * knots[span] + t * knots[span + 1]
    };
    let filled = curve.vector().filled_spans().to_vec();
    let inner = filled.into_iter().flat_map(move |span| (0..per_span).map(move |k| (span, k)));
    let end = std::iter::once(curve.vector().domain()[1]);
    let at = inner.map(move |(span, k)| part(span, k)).chain(end);
    let row = move |u| Ok(numbered(u, columns, &by_knots(&curve, u, columns)?));
    Rows { header: header::<D>(columns), rows: Box::new(at.map(row)) }
}

/// Rows for given parameters; that of each is there before the first is written.
fn table<const D: usize>(
    at: &[f64],
    columns: Columns,
    row: impl Fn(f64) -> Result<Vec<Point<D>>, Failure>,
) -> Result<Rows, Failure> {
    let rows: Vec<Vec<Option<f64>>> =
        at.iter().map(|&u| Ok(numbered(u, columns, &row(u)?))).collect::<Result<_, Failure>>()?;
    Ok(Rows { header: header::<D>(columns), rows: Box::new(rows.into_iter().map(Ok)) })
}

fn header<const D: usize>(columns: Columns) -> Vec<String> {
    std::iter::once("u".to_owned()).chain(columns.names::<D>()).collect()
}

fn numbered<const D: usize>(u: f64, columns: Columns, points: &[Point<D>]) -> Vec<Option<f64>> {
    std::iter::once(Some(u)).chain(columns.numbers(points)).collect()
}

fn by_knots<const D: usize>(
    curve: &KnotCurve<D>,
    u: f64,
    columns: Columns,
) -> Result<Vec<Point<D>>, Failure> {
    let range = curve.vector().domain();
    curve
        .derivatives(u, columns.needed())
        .ok_or_else(|| Failure::work(DesignError::from(KnotError::Outside { name: "u", value: u, range })))
}

/// The range of positions of a curve with shape parameters.
pub(crate) fn positions<const D: usize>(curve: &ShapedCurve<D>, family: FamilyName) -> [f64; 2] {
    [0.0, if family == FamilyName::Cyclic { TAU } else { curve.spans() as f64 }]
}

fn by_position<const D: usize>(
    document: &ShapedPoints,
    curve: &ShapedCurve<D>,
    position: f64,
) -> Result<Vec<Point<D>>, Failure> {
    let range = positions(curve, document.family);
    let outside = || Failure::work(KnotError::Outside { name: "the position", value: position, range });
    if !(range[0]..=range[1]).contains(&position) {
        return Err(outside());
    }
    let (span, x) = curve.basis().place(position);
    // Spans a unit of the position.
    let scale = curve.spans() as f64 / range[1];
    let [point, first, second] = curve.at(span, x).ok_or_else(outside)?;
    Ok(vec![point, first.map(|x| x * scale), second.map(|x| x * scale * scale)])
}

fn by_span<const D: usize>(curve: &dyn ParamCurve<D>, u: f64) -> Result<Vec<Point<D>>, Failure> {
    let spans = curve.spans();
    let range = [0.0, spans as f64];
    let inside = (range[0]..=range[1]).contains(&u);
    let span = if inside { (u as usize).min(spans.saturating_sub(1)) } else { spans };
    let outside = || Failure::work(KnotError::Outside { name: "u", value: u, range });
    curve.at(span, u - span as f64).map(|all| all.to_vec()).ok_or_else(outside)
}
