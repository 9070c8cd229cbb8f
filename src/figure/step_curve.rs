//! Exact plane curves for CAD programs: rational B-splines as a wire frame in a STEP file.

use super::FigureError;
use super::step::{File, Flag, Id, List, MOST_DEGREES, reals};
use crate::geometry::GeometryError;
use crate::geometry::ph::RationalArc;

/// A curve of the plane for a STEP file.
#[derive(Clone, Debug)]
pub struct StepCurve {
    /// Rational arcs of the same degree in a row, each starting where the one before ends.
    pub arcs: Vec<RationalArc>,
    /// Whether the last arc ends where the first starts.
    pub closed: bool,
}

/// Curves as the text of a STEP file with one product of the given name: each is one B-spline curve in the plane z = 0,
/// rational where it has different weights. Knots are 0, 1, ... at the ends of the arcs; an arc with weights that are not
/// positive is divided until they are. One unit is one millimetre. The same curves give the same text.
///
/// # Errors
/// [`FigureError::Geometry`] for no arcs at all and for a weight that is not positive somewhere on a curve,
/// [`FigureError::Degree`], [`FigureError::Coordinate`].
pub fn curves_step(curves: &[StepCurve], name: &str) -> Result<String, FigureError> {
    let mut file = File::new(name, "curves of the plane");
    let mut ids = Vec::new();
    for curve in curves.iter().filter(|curve| !curve.arcs.is_empty()) {
        ids.push(Spline::new(curve)?.write(&mut file, curve.closed));
    }
    if ids.is_empty() {
        return Err(FigureError::NoCurve);
    }
    let set = file.add(format_args!("GEOMETRIC_CURVE_SET('',{})", List(&ids)));
    Ok(file.finish(set, "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"))
}

/// One rational B-spline whose inner knots have the multiplicity of its degree.
struct Spline {
    degree: usize,
    /// Homogeneous points.
    points: Vec<[f64; 3]>,
    knots: Vec<f64>,
}

impl Spline {
    fn new(curve: &StepCurve) -> Result<Self, FigureError> {
        let degree = curve.arcs.iter().map(RationalArc::degree).max().unwrap_or(0);
        if degree > MOST_DEGREES {
            return Err(FigureError::Degree { given: degree, most: MOST_DEGREES });
        }
        let (mut points, mut knots): (Vec<[f64; 3]>, Vec<f64>) = (Vec::new(), vec![0.0]);
        for (span, arc) in curve.arcs.iter().enumerate() {
            let pieces = arc.with_positive_weights().filter(|_| arc.degree() == degree && degree > 0);
            let Some(pieces) = pieces else {
                let value = arc.homogeneous().iter().fold(f64::INFINITY, |least, point| least.min(point[2]));
                let wanted =
                    "positive all along the curve for .step; a curve that stops has no exact offset there";
                return Err(GeometryError::Parameter { name: "weight", value, wanted }.into());
            };
            for (piece, [_, to]) in pieces {
                // The weight at a joint is that of the piece before, as one B-spline has it.
                let weight = |point: Option<&[f64; 3]>| point.map_or(1.0, |point| point[2]);
                let factor = points.last().map_or(1.0, |last| last[2] / weight(piece.homogeneous().first()));
                let piece = piece.scaled(factor);
                let skipped = usize::from(!points.is_empty());
                points.extend(piece.homogeneous().iter().skip(skipped));
                knots.push(span as f64 + to);
            }
        }
        for &[x, y, weight] in &points {
            let bad = [x / weight, y / weight, weight].into_iter().find(|value| !value.is_finite());
            if let Some(value) = bad {
                return Err(FigureError::Coordinate { item: "curve".to_owned(), value });
            }
        }
        Ok(Self { degree, points, knots })
    }

    fn write(&self, file: &mut File, closed: bool) -> Id {
        let points: Vec<Id> =
            self.points.iter().map(|&[x, y, weight]| file.point([x / weight, y / weight, 0.0])).collect();
        let inner = self.knots.len().saturating_sub(2);
        let ends = self.degree + 1;
        let counts: Vec<usize> =
            std::iter::once(ends).chain(std::iter::repeat_n(self.degree, inner)).chain([ends]).collect();
        let weights: Vec<f64> = self.points.iter().map(|point| point[2]).collect();
        let (degree, points, closed) = (self.degree, List(&points), Flag(closed));
        let (counts, knots) = (List(&counts), reals(&self.knots));
        let knots = List(&knots);
        if weights.iter().all(|weight| *weight == 1.0) {
            return file.add(format_args!(
                "B_SPLINE_CURVE_WITH_KNOTS('',{degree},{points},.UNSPECIFIED.,{closed},.U.,{counts},{knots},\
                 .UNSPECIFIED.)"
            ));
        }
        let weights = reals(&weights);
        file.add(format_args!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE({degree},{points},.UNSPECIFIED.,{closed},.U.)\
             B_SPLINE_CURVE_WITH_KNOTS({counts},{knots},.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE({})REPRESENTATION_ITEM(''))",
            List(&weights)
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ParamCurve;
    use crate::geometry::ph::{Knots, PhCurve, SplineEnd, SplineEnds};

    fn bay() -> PhCurve {
        let points =
            [[60.0, 120.0], [150.0, 300.0], [250.0, 170.0], [330.0, 110.0], [420.0, 190.0], [500.0, 320.0]];
        PhCurve::spline(Knots::Chord, SplineEnds::Open([SplineEnd::Cubic; 2]), &points).unwrap()
    }

    /// The point of a B-spline by homogeneous control points, by de Boor's scheme.
    fn evaluated(spline: &Spline, t: f64) -> [f64; 2] {
        let n = spline.degree;
        let mut knots = vec![spline.knots[0]; n + 1];
        for knot in &spline.knots[1..spline.knots.len() - 1] {
            knots.extend(std::iter::repeat_n(*knot, n));
        }
        knots.extend(std::iter::repeat_n(*spline.knots.last().unwrap(), n + 1));
        assert_eq!(knots.len(), spline.points.len() + n + 1);
        let at = (n..spline.points.len()).rev().find(|&k| knots[k] <= t).unwrap();
        let mut d: Vec<[f64; 3]> = spline.points[at - n..=at].to_vec();
        for r in 1..=n {
            for j in (r..=n).rev() {
                let i = at - n + j;
                let a = (t - knots[i]) / (knots[i + n - r + 1] - knots[i]);
                d[j] = std::array::from_fn(|k| (1.0 - a) * d[j - 1][k] + a * d[j][k]);
            }
        }
        [d[n][0] / d[n][2], d[n][1] / d[n][2]]
    }

    #[test]
    fn one_b_spline_is_the_whole_offset() {
        let offset = bay().offset(-40.0).unwrap();
        let spline = Spline::new(&StepCurve { arcs: offset.arcs(), closed: false }).unwrap();
        assert!(spline.points.len() >= 9 * 5 + 1 && spline.degree == 9);
        assert!(spline.points.iter().all(|point| point[2] > 0.0));
        for k in 0..100 {
            let t = f64::from(k) / 20.0;
            let [x, y] = evaluated(&spline, t);
            let [a, b] = ParamCurve::eval(&offset, t.floor() as usize, t.fract()).unwrap();
            assert!((x - a).hypot(y - b) < 1e-9, "{t}: {x} {y}, not {a} {b}");
        }
    }

    #[test]
    fn the_text_has_the_entities() {
        let curve = bay();
        let offset = curve.offset(-40.0).unwrap();
        let both = [curve.arcs(), offset.arcs()].map(|arcs| StepCurve { arcs, closed: false });
        let text = curves_step(&both, "bay").unwrap();
        for entity in [
            "B_SPLINE_CURVE_WITH_KNOTS('',5,(#1,",
            "(BOUNDED_CURVE()B_SPLINE_CURVE(9,(",
            "RATIONAL_B_SPLINE_CURVE((",
            "GEOMETRIC_CURVE_SET('',(#",
            "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('bay',(",
            ",(6,5,5,5,5,6),(0.,1.,2.,3.,4.,5.),",
        ] {
            assert!(text.contains(entity), "{entity}");
        }
        assert_eq!(curves_step(&[], "none"), Err(FigureError::NoCurve));
        let stopping =
            StepCurve { arcs: vec![RationalArc::new(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 1.0]])], closed: false };
        assert!(matches!(curves_step(&[stopping], "none"), Err(FigureError::Geometry(_))));
    }
}
