//! The Pythagorean-hodograph curve of a sketch, with all that is exact about it.

use super::{DesignError, Sketch};
use crate::file::Method;
use crate::geometry::ph::{Knots, PhCurve, SpacePhCurve, SplineEnd, SplineEnds};
use crate::geometry::{
    Closure, Curve, GeometryError, Method as Formula, ParamCurve, Point, automatic_tangents,
};

impl Sketch<2> {
    /// The PH curve by the sketch's own method, which must be one of theirs.
    ///
    /// Without tangents, phhermite and phcubic take those of the cubic spline through the points, or where the sketch
    /// has a `k0`, the automatic ones of Coons curves.
    ///
    /// # Errors
    /// [`DesignError::NoMethod`], [`DesignError::NoPh`] for another method, and those of the geometry.
    pub fn ph_curve(&self) -> Result<PhCurve, DesignError> {
        plane(self, self.method().ok_or(DesignError::NoMethod)?)
    }
}

impl<const D: usize> Sketch<D> {
    /// The tangents of the PH curves that need some: the sketch's own ones, else those of the cubic spline, or with a
    /// `k0` the automatic ones of Coons curves.
    ///
    /// # Errors
    /// Too few points, or a bad coordinate.
    pub fn ph_tangents(&self) -> Result<Vec<Point<D>>, GeometryError> {
        tangents(self)
    }
}

impl Sketch<3> {
    /// The PH curve in space by the sketch's own method, which must be phhermite. Tangents as in
    /// [`Sketch::ph_curve`].
    ///
    /// # Errors
    /// [`DesignError::NoMethod`], [`DesignError::ForPlane`] and [`DesignError::NoPh`] for other methods, and those of
    /// the geometry.
    pub fn space_ph_curve(&self) -> Result<SpacePhCurve, DesignError> {
        space(self, self.method().ok_or(DesignError::NoMethod)?)
    }
}

pub(super) fn plane(sketch: &Sketch<2>, method: Method) -> Result<PhCurve, DesignError> {
    let (closure, points) = (sketch.closure(), sketch.points.as_slice());
    Ok(match method {
        Method::PhSpline => {
            let end =
                |derivative: Option<Point<2>>| derivative.map_or(SplineEnd::Cubic, SplineEnd::Derivative);
            let ends = match closure {
                Closure::Open => SplineEnds::Open(sketch.end_derivatives()?.map(end)),
                Closure::Closed => SplineEnds::Closed,
            };
            PhCurve::spline(sketch.knot_rule(method, Knots::default())?, ends, points)?
        }
        Method::PhHermite => PhCurve::hermite(closure, points, &tangents(sketch)?)?,
        Method::PhCubic => PhCurve::cubics(closure, points, &tangents(sketch)?)?,
        other => return Err(DesignError::NoPh(other)),
    })
}

pub(super) fn space(sketch: &Sketch<3>, method: Method) -> Result<SpacePhCurve, DesignError> {
    match method {
        Method::PhHermite => Ok(SpacePhCurve::hermite(sketch.closure(), &sketch.points, &tangents(sketch)?)?),
        Method::PhSpline | Method::PhCubic => Err(DesignError::ForPlane(method)),
        other => Err(DesignError::NoPh(other)),
    }
}

/// The tangents of the sketch, or automatic ones.
fn tangents<const D: usize>(sketch: &Sketch<D>) -> Result<Vec<Point<D>>, GeometryError> {
    let (closure, points) = (sketch.closure(), sketch.points.as_slice());
    match (&sketch.tangents, sketch.settings.k0) {
        (Some(tangents), _) => Ok(tangents.clone()),
        (None, Some(k0)) => automatic_tangents(closure, k0, points),
        (None, None) => {
            let spline = Curve::through(Formula::Spline, closure, points)?;
            let starts = (0..spline.spans()).map(|span| (span, 0.0));
            let last = (closure == Closure::Open).then(|| (spline.spans().saturating_sub(1), 1.0));
            let slope = |(span, u)| spline.at(span, u).map(|[_, slope, _]| slope);
            Ok(starts.chain(last).filter_map(slope).collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bay() -> Sketch<2> {
        let points = vec![
            [60.0, 120.0],
            [150.0, 300.0],
            [250.0, 170.0],
            [330.0, 110.0],
            [420.0, 190.0],
            [500.0, 320.0],
        ];
        Sketch { points, ..Sketch::default() }
    }

    #[test]
    fn the_recipe_says_knots_and_ends() {
        let mut sketch = bay().by(Method::PhSpline);
        let length = sketch.ph_curve().unwrap().total_length();
        assert!((length - 790.301522).abs() < 1e-6, "{length}");
        sketch.settings.knots = Some(Knots::Uniform.into());
        assert_ne!(sketch.ph_curve().unwrap().total_length(), length);
        sketch.settings.start = Some(vec![10.0, 90.0]);
        let curve = sketch.ph_curve().unwrap();
        let slope = curve.at(0, 0.0).unwrap()[1];
        // Uniform knots have steps of 1.
        assert!((slope[0] - 10.0).abs() + (slope[1] - 90.0).abs() < 1e-10, "{slope:?}");
        sketch.settings.closed = Some(true);
        assert_eq!(sketch.ph_curve().unwrap().spans(), 6);
    }

    #[test]
    fn tangents_are_the_given_ones_or_those_of_the_spline() {
        let sketch = bay().by(Method::PhHermite);
        let spline = bay().by(Method::Spline).curve().unwrap();
        let curve = sketch.ph_curve().unwrap();
        for span in 0..5 {
            let [slope, other] = [curve.at(span, 1.0), spline.at(span, 1.0)].map(|it| it.unwrap()[1]);
            assert!((slope[0] - other[0]).hypot(slope[1] - other[1]) < 1e-9);
        }
        let own = Sketch { tangents: Some(vec![[90.0, 10.0]; 6]), ..sketch.clone() };
        let slope = own.ph_curve().unwrap().at(3, 0.0).unwrap()[1];
        assert!((slope[0] - 90.0).hypot(slope[1] - 10.0) < 1e-9);
        let mut coons = sketch;
        coons.settings.k0 = Some(0.5);
        let slope = coons.ph_curve().unwrap().at(1, 0.0).unwrap()[1];
        assert!((slope[0] - 95.0).hypot(slope[1] - 25.0) < 1e-9, "{slope:?}");
    }

    #[test]
    fn a_sketch_draws_its_ph_curve_like_any_other() {
        for method in [Method::PhSpline, Method::PhHermite] {
            let sketch = bay().by(method);
            let (drawn, exact) = (sketch.curve().unwrap(), sketch.ph_curve().unwrap());
            assert_eq!(drawn.sample(7).unwrap(), exact.sample(7).unwrap());
        }
        let points = bay().points.into_iter().map(|[x, y]| [x, y, x - y]).collect();
        let space = Sketch::<3> { points, ..Sketch::default() };
        assert_eq!(space.by(Method::PhHermite).curve().unwrap().spans(), 5);
        for method in [Method::PhSpline, Method::PhCubic] {
            assert_eq!(space.by(method).curve().unwrap_err(), DesignError::ForPlane(method));
        }
        assert_eq!(bay().by(Method::Coons).ph_curve().unwrap_err(), DesignError::NoPh(Method::Coons));
        // An S has no PH cubic.
        let tangents = Some(vec![[1.0, 0.5]; 2]);
        let bent = Sketch { points: vec![[0.0, 0.0], [100.0, 0.0]], tangents, ..Sketch::default() };
        let refused = bent.by(Method::PhCubic).curve().unwrap_err();
        assert!(matches!(refused, DesignError::Geometry(GeometryError::NoPhCubic { .. })), "{refused}");
    }
}
