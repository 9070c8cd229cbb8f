//! How much a control point counts along a curve: its blending function.

use super::{Place, Sketch};
use crate::file::{KnotRule, Method};
use crate::geometry::ph::Knots;
use crate::geometry::{ParamCurve, Point};

impl<const D: usize> Sketch<D>
where
    Point<D>: Place<D>,
{
    /// The weight of a control point along the curve, as the first coordinate of a curve of the same spans: every point
    /// of the curve is the sum of the control points by these weights, and they sum to 1. `None` if there is no curve, no
    /// such point, or if the curve is not linear in its points, as Pythagorean-hodograph curves and curves with knots by
    /// chords are not.
    pub fn weight(&self, index: usize) -> Option<Box<dyn ParamCurve<D>>> {
        let rule = self.settings.knots.as_ref().and_then(KnotRule::rule);
        let by_chords = rule.is_some_and(|rule| rule != Knots::Uniform)
            && matches!(self.method()?, Method::Spline | Method::BSpline);
        if by_chords || matches!(self.method()?, Method::PhSpline | Method::PhHermite | Method::PhCubic) {
            return None;
        }
        let mut unit = Sketch { points: vec![[0.0; D]; self.points.len()], ..self.clone() };
        *unit.points.get_mut(index)?.first_mut()? = 1.0;
        for end in [&mut unit.settings.start, &mut unit.settings.end].into_iter().flatten() {
            end.iter_mut().for_each(|value| *value = 0.0);
        }
        unit.tangents.iter_mut().flatten().for_each(|tangent| *tangent = [0.0; D]);
        unit.curve().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::CurveSettings;
    use proptest::prelude::*;

    const METHODS: [Method; 6] =
        [Method::Coons, Method::Bezier, Method::Spline, Method::BSpline2, Method::BSpline3, Method::Beta];

    #[test]
    fn ends_that_are_given_and_knots_by_chords_are_no_weights_of_points() {
        let points = vec![[0.0, 0.0], [100.0, 200.0], [300.0, 100.0], [350.0, 0.0], [500.0, 60.0]];
        let settings = CurveSettings {
            method: Some(Method::Spline),
            start: Some(vec![300.0, 0.0]),
            end: Some(vec![0.0, -200.0]),
            ..CurveSettings::default()
        };
        let clamped = Sketch::<2> { points, settings, ..Sketch::default() };
        for span in 0..4 {
            let weight =
                |index| clamped.weight(index).expect("it is linear").eval(span, 0.3).expect("a span")[0];
            assert!(((0..5).map(weight).sum::<f64>() - 1.0).abs() < 1e-12);
        }
        let mut by_chords = clamped.clone();
        by_chords.settings.knots = Some(KnotRule::By(Knots::Chord));
        assert!(by_chords.curve().is_ok() && by_chords.weight(0).is_none());
        assert!(by_chords.by(Method::BSpline).weight(0).is_none());
    }

    proptest! {
        #[test]
        fn the_curve_is_the_mean_of_its_points_by_the_weights(
            points in prop::collection::vec(prop::array::uniform2(0.0..500.0f64), 3..9),
            method in prop::sample::select(&METHODS), closed: bool, part in 0.0..1.0f64,
        ) {
            let settings = CurveSettings { method: Some(method), closed: Some(closed), ..CurveSettings::default() };
            let sketch = Sketch::<2> { points, settings, ..Sketch::default() };
            let curve = sketch.curve().expect("three points are enough");
            for span in 0..curve.spans() {
                let weights: Vec<f64> = (0..sketch.points.len())
                    .map(|index| sketch.weight(index).expect("it is linear").eval(span, part).expect("a span")[0])
                    .collect();
                prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                let at = curve.eval(span, part).expect("a span");
                for d in 0..2 {
                    let mean: f64 = weights.iter().zip(&sketch.points).map(|(w, point)| w * point[d]).sum();
                    prop_assert!((mean - at[d]).abs() < 1e-9);
                }
            }
        }
    }
}
