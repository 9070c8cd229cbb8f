//! A curve by control points, with its recipe.

use super::edit::full;
use super::{DesignError, Edit, Place, closure};
use crate::file::{CurveSettings, Document, KnotRule, MAX_POINTS, Method, PlanePoints, SpacePoints};
use crate::geometry::knots::{KnotSource, bspline};
use crate::geometry::ph::Knots;
use crate::geometry::{
    Closure, Curve, GeometryError, Method as Formula, ParamCurve, Point, Shape, VaryingBeta,
    automatic_tangents, hermite_arcs, stepped_spline,
};

/// The degree of a B-spline that names none.
pub const USUAL_DEGREE: usize = 3;

/// Control points with their tangents and joints, and the recipe of the curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sketch<const D: usize> {
    /// The control points.
    pub points: Vec<Point<D>>,
    /// The full tangent vector at each point, if the user sets them.
    pub tangents: Option<Vec<Point<D>>>,
    /// The shape of the joint at each point, where the joints of a beta-spline differ.
    pub joints: Option<Vec<Shape>>,
    /// Method, closure and parameters.
    pub settings: CurveSettings,
}

impl<const D: usize> Sketch<D> {
    /// The tangent at a point; `None` without tangents.
    pub fn tangent(&self, index: usize) -> Option<Point<D>> {
        self.tangents.as_ref()?.get(index).copied()
    }

    /// Bias and tension of the beta-spline.
    pub fn shape(&self) -> Shape {
        let neutral = Shape::default();
        Shape {
            bias: self.settings.bias.unwrap_or(neutral.bias),
            tension: self.settings.tension.unwrap_or(neutral.tension),
        }
    }

    /// The shape of every joint.
    pub fn shapes(&self) -> Vec<Shape> {
        self.joints.clone().unwrap_or_else(|| vec![self.shape(); self.points.len()])
    }

    /// The coefficient of automatic tangents.
    pub fn k0(&self) -> f64 {
        self.settings.k0.unwrap_or(0.5)
    }

    /// Whether the curve returns to its first point.
    pub fn closure(&self) -> Closure {
        closure(&self.settings)
    }

    /// The method: the named one, else the one implied by tangents or joints.
    pub fn method(&self) -> Option<Method> {
        let implied = match (&self.tangents, &self.joints) {
            (Some(_), _) => Some(Method::Hermite),
            (_, Some(_)) => Some(Method::Beta),
            _ => None,
        };
        self.settings.method.or(implied)
    }

    /// The same points by another method.
    #[must_use]
    pub fn by(&self, method: Method) -> Sketch<D> {
        let mut sketch = self.clone();
        sketch.settings.method = Some(method);
        sketch
    }

    /// The tip of the tangent at a point: the point plus half the vector, rounded to integers.
    pub fn tip(&self, index: usize) -> Option<Point<D>> {
        let (point, tangent) = (self.points.get(index)?, self.tangent(index)?);
        Some(std::array::from_fn(|d| point[d] + (tangent[d] / 2.0).round_ties_even()))
    }

    /// The sketch with the tip of a tangent at another place.
    #[must_use]
    pub fn with_tip(&self, index: usize, tip: Point<D>) -> Sketch<D> {
        match self.points.get(index) {
            Some(point) => self.with_tangent(index, std::array::from_fn(|d| 2.0 * (tip[d] - point[d]))),
            None => self.clone(),
        }
    }

    /// The sketch with automatic tangents for an open or closed curve, rounded to integers as the files hold them.
    ///
    /// # Errors
    /// Too few points, or a coefficient that is not finite.
    pub fn with_automatic_tangents(&self, closure: Closure) -> Result<Sketch<D>, GeometryError> {
        let tangents = automatic_tangents(closure, self.k0(), &self.points)?;
        let rounded = tangents.into_iter().map(|tangent| tangent.map(f64::round_ties_even)).collect();
        Ok(Sketch { tangents: Some(rounded), ..self.clone() })
    }

    /// The sketch with another tangent at a point.
    #[must_use]
    pub fn with_tangent(&self, index: usize, tangent: Point<D>) -> Sketch<D> {
        let mut sketch = self.clone();
        if let Some(old) = sketch.tangents.as_mut().and_then(|tangents| tangents.get_mut(index)) {
            *old = tangent;
        }
        sketch
    }

    /// The sketch with another shape of one joint.
    #[must_use]
    pub fn with_joint(&self, index: usize, shape: Shape) -> Sketch<D> {
        let mut joints = self.shapes();
        if let Some(old) = joints.get_mut(index) {
            *old = shape;
        }
        Sketch { joints: Some(joints), ..self.clone() }
    }

    /// The sketch with a new bias or tension of all joints.
    #[must_use]
    pub fn with_shape(&self, change: impl Fn(&mut Shape)) -> Sketch<D> {
        let (mut sketch, mut shape) = (self.clone(), self.shape());
        change(&mut shape);
        (sketch.settings.bias, sketch.settings.tension) = (Some(shape.bias), Some(shape.tension));
        sketch.joints.iter_mut().flatten().for_each(change);
        sketch
    }

    /// Whether the parameters of the method have a curve.
    ///
    /// # Errors
    /// Those of [`Formula::check`].
    pub fn check_parameters(&self) -> Result<(), GeometryError> {
        let Shape { bias, tension } = self.shape();
        let formula: Option<Formula> = self.method().and_then(|it| it.with(self.k0(), bias, tension));
        formula.map_or(Ok(()), Formula::check)
    }

    /// The rule for the knots of a method that takes one only; a usual one where none is named.
    ///
    /// # Errors
    /// [`DesignError::OnlyRules`] for knots that are given.
    pub fn knot_rule(&self, method: Method, usual: Knots) -> Result<Knots, DesignError> {
        match &self.settings.knots {
            None => Ok(usual),
            Some(knots) => knots.rule().ok_or(DesignError::OnlyRules(method)),
        }
    }

    /// The derivatives that the settings give to the ends.
    ///
    /// # Errors
    /// [`DesignError::EndCoordinates`].
    pub fn end_derivatives(&self) -> Result<[Option<Point<D>>; 2], DesignError> {
        let of = |end: &Option<Vec<f64>>| match end {
            None => Ok(None),
            Some(end) => <Point<D>>::try_from(end.as_slice())
                .map(Some)
                .map_err(|_| DesignError::EndCoordinates { given: end.len(), needed: D }),
        };
        Ok([of(&self.settings.start)?, of(&self.settings.end)?])
    }

    /// The B-spline of the degree and knots that are set.
    fn bspline(&self) -> Result<Box<dyn ParamCurve<D>>, DesignError> {
        let source = match &self.settings.knots {
            None => KnotSource::By(Knots::Uniform),
            Some(KnotRule::By(rule)) => KnotSource::By(*rule),
            Some(KnotRule::Given(knots)) => KnotSource::Given(knots),
        };
        let degree = self.settings.degree.unwrap_or(USUAL_DEGREE);
        Ok(bspline(degree, self.closure(), source, &self.points)?)
    }

    /// The spline with steps or ends of its own; `None` for the usual one.
    fn stepped(&self) -> Result<Option<Curve<D>>, DesignError> {
        let closure = self.closure();
        let rule = self.knot_rule(Method::Spline, Knots::Uniform)?;
        let ends = match closure {
            Closure::Open => self.end_derivatives()?,
            Closure::Closed => [None; 2],
        };
        if rule == Knots::Uniform && ends == [None; 2] {
            return Ok(None);
        }
        Ok(Some(Curve::Piecewise(stepped_spline(closure, rule, ends, &self.points)?)))
    }

    /// Whether no more points can be added.
    pub fn full(&self) -> bool {
        full(&self.points)
    }
}

impl<const D: usize> Sketch<D>
where
    Point<D>: Place<D>,
{
    /// The curve through or near the control points.
    ///
    /// # Errors
    /// [`DesignError::NoMethod`] if none is named or implied, [`DesignError::Needs`] if the points do not have what
    /// the method needs, [`DesignError::ForPlane`] in space, and those of the geometry.
    pub fn curve(&self) -> Result<Box<dyn ParamCurve<D>>, DesignError> {
        let (closure, points) = (self.closure(), self.points.as_slice());
        let method = self.method().ok_or(DesignError::NoMethod)?;
        Ok(match (method, &self.tangents, &self.joints) {
            (Method::Hermite, Some(tangents), _) => {
                Box::new(Curve::Piecewise(hermite_arcs(closure, points, tangents)?))
            }
            (Method::PhSpline | Method::PhHermite | Method::PhCubic, ..) => Point::<D>::ph(self, method)?,
            (Method::BSpline, ..) => self.bspline()?,
            (Method::Beta, _, Some(joints)) => Box::new(VaryingBeta::new(closure, points, joints)?),
            _ => {
                if let Some(curve) = if method == Method::Spline { self.stepped()? } else { None } {
                    return Ok(Box::new(curve));
                }
                let Shape { bias, tension } = self.shape();
                let formula = method.with(self.k0(), bias, tension).ok_or(DesignError::Needs(method))?;
                Box::new(Curve::through(formula, closure, points)?)
            }
        })
    }

    /// The sketch as a closed one without its last point, if that repeats the first and nothing is said about ends.
    #[must_use]
    pub fn closed_up(&self) -> Sketch<D> {
        let repeats = self.points.len() > 3 && self.points.first() == self.points.last();
        if !repeats || self.settings.closed.is_some() {
            return self.clone();
        }
        let mut closed = self.edited(Edit::Delete(self.points.len() - 1));
        closed.settings.closed = Some(true);
        closed
    }

    /// The sketch after an edit of its points; tangents and joints follow their points. A new point has a zero tangent
    /// and the common shape.
    #[must_use]
    pub fn edited(&self, edit: Edit<Point<D>>) -> Sketch<D> {
        let mut sketch = self.clone();
        edit.carry_out(&mut sketch.points);
        let counts = [self.points.len(), sketch.points.len()];
        if let Some(tangents) = &mut sketch.tangents {
            follow(tangents, edit, counts, [0.0; D]);
        }
        if let Some(joints) = &mut sketch.joints {
            follow(joints, edit, counts, self.shape());
        }
        if let Some(smooth) = sketch.settings.smooth.take() {
            let mut marks: Vec<bool> = (1..=counts[0]).map(|number| smooth.contains(&number)).collect();
            follow(&mut marks, edit, counts, false);
            let kept = (1..).zip(marks).filter(|(_, marked)| *marked).map(|(number, _)| number);
            sketch.settings.smooth = Some(kept.collect()).filter(|kept: &Vec<usize>| !kept.is_empty());
        }
        sketch
    }

    /// The sketch, if an editor can show it.
    ///
    /// # Errors
    /// Too many points, or one outside of the allowed range.
    pub fn fitting(self) -> Result<Sketch<D>, DesignError> {
        if let Some((index, place)) = self.points.iter().enumerate().find(|(_, point)| !point.fits()) {
            return Err(DesignError::Outside(index + 1, place.to_vec()));
        }
        if self.points.len() > MAX_POINTS {
            return Err(DesignError::TooMany(self.points.len()));
        }
        Ok(self)
    }
}

impl From<PlanePoints> for Sketch<2> {
    fn from(PlanePoints { points, tangents, joints, settings }: PlanePoints) -> Sketch<2> {
        Sketch { points, tangents, joints, settings }
    }
}

impl From<SpacePoints> for Sketch<3> {
    fn from(SpacePoints { points, tangents, settings }: SpacePoints) -> Sketch<3> {
        Sketch { points, tangents, joints: None, settings }
    }
}

impl From<Sketch<2>> for Document {
    fn from(Sketch { points, tangents, joints, settings }: Sketch<2>) -> Document {
        Document::PlanePoints(PlanePoints { points, tangents, joints, settings })
    }
}

impl From<Sketch<3>> for Document {
    fn from(Sketch { points, tangents, settings, .. }: Sketch<3>) -> Document {
        Document::SpacePoints(SpacePoints { points, tangents, settings })
    }
}

/// Applies an edit of the points to a list that belongs to them; `before` and `after` count the points.
pub(crate) fn follow<T, P>(list: &mut Vec<T>, edit: Edit<P>, [before, after]: [usize; 2], new: T) {
    match edit {
        Edit::Insert(index, _) if after > before => list.insert(index.min(before), new),
        Edit::Delete(index) if after < before => {
            list.remove(index);
        }
        Edit::Renumber(from, to) if from.max(to) < before => {
            let value = list.remove(from);
            list.insert(to, value);
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn row(count: u8) -> Sketch<2> {
        Sketch { points: (0..count).map(|x| [f64::from(x), 0.0]).collect(), ..Sketch::default() }
    }

    fn order(sketch: &Sketch<2>) -> Vec<f64> {
        sketch.points.iter().map(|point| point[0]).collect()
    }

    #[test]
    fn edits_do_what_their_names_say() {
        let sketch = row(4);
        assert_eq!(order(&sketch.edited(Edit::Insert(1, [9.0, 0.0]))), [0.0, 9.0, 1.0, 2.0, 3.0]);
        assert_eq!(order(&sketch.edited(Edit::Insert(99, [9.0, 0.0]))), [0.0, 1.0, 2.0, 3.0, 9.0]);
        assert_eq!(order(&sketch.edited(Edit::Move(2, [999.0, -5.0]))), [0.0, 1.0, 560.0, 3.0]);
        assert_eq!(order(&sketch.edited(Edit::Delete(0))), [1.0, 2.0, 3.0]);
        assert_eq!(order(&sketch.edited(Edit::Renumber(0, 2))), [1.0, 2.0, 0.0, 3.0]);
        assert_eq!(order(&sketch.edited(Edit::Renumber(3, 1))), [0.0, 3.0, 1.0, 2.0]);
        for nothing in [Edit::Delete(4), Edit::Renumber(1, 4), Edit::Renumber(9, 0), Edit::Move(4, [0.0; 2])]
        {
            assert_eq!(sketch.edited(nothing), sketch);
        }
    }

    #[test]
    fn there_is_room_for_99_points_of_the_field() {
        assert!(row(99).full() && row(99).edited(Edit::Insert(0, [0.0; 2])) == row(99));
        let of = |points: Vec<Point<2>>| Sketch { points, ..Sketch::default() }.fitting();
        assert_eq!(of(vec![[0.0; 2]; 100]), Err(DesignError::TooMany(100)));
        assert_eq!(of(vec![[0.0; 2], [560.5, 0.0]]), Err(DesignError::Outside(2, vec![560.5, 0.0])));
        assert!(of(vec![[f64::NAN, 0.0]]).is_err());
        let in_space = |points: Vec<Point<3>>| Sketch { points, ..Sketch::default() }.fitting();
        assert!(in_space(vec![[f64::NAN, 0.0, 0.0]]).is_err());
        assert!(in_space(vec![[-1e9, 0.0, 1e100]]).is_ok());
    }

    #[test]
    fn the_named_method_comes_before_what_is_there() {
        let mut sketch = row(4);
        assert_eq!(sketch.curve().unwrap_err(), DesignError::NoMethod);
        sketch.tangents = Some(vec![[0.0, 9.0]; 4]);
        let hermite = sketch.curve().unwrap().sample(3).unwrap();
        let spline = sketch.by(Method::Spline).curve().unwrap().sample(3).unwrap();
        assert_ne!(hermite, spline);
        assert_eq!(row(4).by(Method::Hermite).curve().unwrap_err(), DesignError::Needs(Method::Hermite));
    }

    proptest! {
        #[test]
        fn every_edit_leaves_a_sketch(count in 0u8..100, index in 0usize..120, other in 0usize..120, x: i16, y: i16) {
            let point = [f64::from(x), f64::from(y)];
            for edit in [Edit::Insert(index, point), Edit::Move(index, point), Edit::Delete(index), Edit::Renumber(index, other)] {
                prop_assert!(row(count).edited(edit).fitting().is_ok());
            }
        }

        #[test]
        fn what_belongs_to_a_point_goes_with_it(
            edits in prop::collection::vec((0u8..4, 0usize..12, 0usize..12), 0..60),
        ) {
            // Every point carries the same mark in place, tangent and joint.
            let mut sketch = Sketch::<2> { tangents: Some(Vec::new()), joints: Some(Vec::new()), ..Sketch::default() };
            let mut mark = 0.0;
            for (kind, index, other) in edits {
                let count = sketch.points.len();
                match kind {
                    0 | 1 if count < 20 => {
                        mark += 1.0;
                        sketch = sketch.edited(Edit::Insert(index, [mark, 0.0]));
                        let at = index.min(count);
                        sketch = sketch.with_tangent(at, [mark, 0.0]).with_joint(at, Shape { bias: mark, tension: 0.0 });
                    }
                    2 => sketch = sketch.edited(Edit::Delete(index)),
                    _ => sketch = sketch.edited(Edit::Renumber(index, other)),
                }
                let marks = order(&sketch);
                let tangents: Vec<f64> = sketch.tangents.iter().flatten().map(|tangent| tangent[0]).collect();
                let joints: Vec<f64> = sketch.joints.iter().flatten().map(|shape| shape.bias).collect();
                prop_assert_eq!(&marks, &tangents);
                prop_assert_eq!(&marks, &joints);
            }
        }
    }
}
