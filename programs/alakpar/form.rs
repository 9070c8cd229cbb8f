//! What is edited: the points, the family with its parameters, and whether the points are data that the curve passes.

use crate::design::{Edit, Place, Sketch, follow};
use crate::file::{FamilyName, LambdaValue, Places, ShapedPoints};
use crate::geometry::shaped::{Family, LambdaKind, Lambdas, Parameter, ShapedCurve, interpolate};
use crate::geometry::{Closure, GeometryError, ParamCurve, Point};

/// A curve with shape parameters as the editor has it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Form<const D: usize> {
    /// Control points, or the points that the curve passes.
    pub(super) points: Vec<Point<D>>,
    /// The polygon that is blended in, where a file gave one that does not follow from the points.
    blend: Option<Vec<Point<D>>>,
    /// Whether the curve passes the points.
    pub(super) through: bool,
    /// Family, parameters and closure; its own points are empty. Of several lambdas, one belongs to every point above.
    recipe: ShapedPoints,
}

/// Digits to which data are read out of the curve that passes them.
const GRAIN: f64 = 1e9;

impl<const D: usize> Form<D> {
    /// The cubic B-spline, as the F-B-spline of omega 0, without points.
    pub(super) fn empty() -> Form<D> {
        Form {
            points: Vec::new(),
            blend: None,
            through: false,
            recipe: ShapedPoints::of_points(Places::default()),
        }
    }

    /// The family's name.
    pub(super) fn family(&self) -> FamilyName {
        self.recipe.family
    }

    /// Whether the curve is closed.
    pub(super) fn closure(&self) -> Closure {
        if self.recipe.closed || self.family() == FamilyName::Cyclic {
            Closure::Closed
        } else {
            Closure::Open
        }
    }

    /// The family with its parameters.
    pub(super) fn parameters(&self) -> Result<Family, GeometryError> {
        self.recipe.parameters()
    }

    /// The value of a parameter.
    pub(super) fn value(&self, parameter: Parameter) -> Option<f64> {
        self.parameters().ok()?.value(parameter)
    }

    /// The parameters by their names in documents.
    pub(super) fn numbers(&self) -> Vec<(&'static str, serde_json::Value)> {
        let recipe = &self.recipe;
        let number = |value: Option<f64>| value.map(serde_json::Value::from);
        let all = [
            ("alpha", number(recipe.alpha)),
            ("beta", number(recipe.beta)),
            ("omega", number(recipe.omega)),
            ("n1", recipe.n1.map(serde_json::Value::from)),
            ("n2", recipe.n2.map(serde_json::Value::from)),
            ("phi", recipe.phi.and_then(|phi| serde_json::to_value(phi).ok())),
            ("lambda", recipe.lambda.as_ref().and_then(|lambda| serde_json::to_value(lambda).ok())),
        ];
        all.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
    }

    /// The lambdas, if every point has its own.
    pub(super) fn lambdas(&self) -> Option<&[f64]> {
        match &self.recipe.lambda {
            Some(LambdaValue::Each(all)) => Some(all),
            _ => None,
        }
    }

    /// The same points with another value of a parameter.
    pub(super) fn with(&self, parameter: Parameter, value: f64) -> Result<Form<D>, GeometryError> {
        let family = self.parameters()?.with(parameter, value, self.points.len())?;
        Ok(self.with_parameters(&family))
    }

    /// The same points with a family's parameters, which are those of the recipe's family.
    fn with_parameters(&self, family: &Family) -> Form<D> {
        Form { recipe: self.recipe.with_parameters(family), ..self.clone() }
    }

    /// The same points as a curve of another family. Interpolation stays where the family has it.
    pub(super) fn by(&self, name: FamilyName, family: &Family, closed: bool) -> Form<D> {
        let recipe = ShapedPoints { family: name, closed, ..ShapedPoints::default() }.with_parameters(family);
        let blended = matches!(name, FamilyName::Alpha | FamilyName::Gb | FamilyName::Spb);
        Form {
            recipe,
            points: self.points.clone(),
            blend: self.blend.clone().filter(|_| blended),
            through: self.through && interpolates(name),
        }
    }

    /// Whether the points of this family can be data.
    pub(super) fn can_interpolate(&self) -> bool {
        interpolates(self.family())
    }

    /// The same points as data, or as control points.
    pub(super) fn through(&self, through: bool) -> Form<D> {
        Form { through, blend: None, ..self.clone() }
    }

    /// The points after an edit, which lambdas and the blended polygon follow.
    pub(super) fn edited(&self, edit: Edit<Point<D>>) -> Form<D>
    where
        Point<D>: Place<D>,
    {
        let points = Sketch { points: self.points.clone(), ..Sketch::default() }.edited(edit).points;
        self.with_points(points, edit)
    }

    fn with_points(&self, points: Vec<Point<D>>, edit: Edit<Point<D>>) -> Form<D> {
        let mut form = self.clone();
        let counts = [self.points.len(), points.len()];
        if let Some(LambdaValue::Each(all)) = &mut form.recipe.lambda {
            let near = |index: usize| all.get(index.min(all.len().saturating_sub(1))).copied().unwrap_or(0.0);
            let new = match edit {
                Edit::Insert(index, _) => 0.5 * (near(index.saturating_sub(1)) + near(index)),
                _ => 0.0,
            };
            follow(all, edit, counts, new);
            if all.is_empty() {
                form.recipe.lambda = Some(LambdaValue::One(new));
            }
        }
        if let Some(blend) = &mut form.blend {
            let new = match edit {
                Edit::Insert(index, at) => points.get(index).copied().unwrap_or(at),
                _ => [0.0; D],
            };
            // A point and that of the polygon move together.
            if let Edit::Move(index, _) = edit
                && let (Some(place), Some(from), Some(to)) =
                    (blend.get_mut(index), self.points.get(index), points.get(index))
            {
                *place = std::array::from_fn(|d| place[d] + (to[d] - from[d]));
            }
            follow(blend, edit, counts, new);
        }
        form.points = points;
        form
    }

    /// The first points alone.
    pub(super) fn shortened(&self, count: usize) -> Form<D>
    where
        Point<D>: Place<D>,
    {
        (count..self.points.len()).rev().fold(self.clone(), |form, index| form.edited(Edit::Delete(index)))
    }

    /// The points behind the elevation of a cyclic curve.
    pub(super) fn elevated(&self) -> Result<Form<D>, GeometryError> {
        let points = crate::geometry::shaped::elevate_cyclic(&self.points, 1)?;
        Ok(Form { points, ..self.clone() })
    }

    /// With other points, where every parameter is one for the curve.
    pub(super) fn replaced(&self, points: Vec<Point<D>>) -> Form<D> {
        Form { points, ..self.clone() }
    }

    /// The curve.
    pub(super) fn curve(&self) -> Result<ShapedCurve<D>, GeometryError> {
        let (family, closed) = (self.parameters()?, self.closure() == Closure::Closed);
        if self.through {
            let family = self.of_all_points(family);
            return interpolate(&family, &self.points, closed)?.curve(family, closed);
        }
        let curve = ShapedCurve::new(family, self.points.clone(), closed)?;
        match &self.blend {
            Some(blend) => curve.with_blend(blend.clone()),
            None => Ok(curve),
        }
    }

    /// The family of the control points, where an open curve through points has one more at either end.
    fn of_all_points(&self, family: Family) -> Family {
        match family {
            Family::Lambda { kind, lambda: Lambdas::Each(mut all) } if self.closure() == Closure::Open => {
                let ends = [all.first().copied(), all.last().copied()].map(|it| it.unwrap_or(0.0));
                all.insert(0, ends[0]);
                all.push(ends[1]);
                Family::Lambda { kind, lambda: Lambdas::Each(all) }
            }
            other => other,
        }
    }

    /// The curve that a cubic would be with the same points, by the same reading of them: of Bézier kind where the
    /// family is.
    pub(super) fn cubic(&self) -> Option<Box<dyn ParamCurve<D>>> {
        let bezier =
            matches!(self.family(), FamilyName::CBezier | FamilyName::FBezier | FamilyName::TrigBezier);
        if bezier {
            let method = crate::geometry::Method::Bezier;
            let curve = crate::geometry::Curve::through(method, Closure::Open, &self.points).ok()?;
            return Some(Box::new(curve));
        }
        let closed = self.closure() == Closure::Closed;
        let spline =
            Form { blend: None, ..self.by(FamilyName::FBSpline, &Family::FBSpline { omega: 0.0 }, closed) };
        Some(Box::new(spline.curve().ok()?))
    }
}

impl<const D: usize> Form<D>
where
    Vec<Point<D>>: Into<Places>,
{
    /// The document. The control points of a curve through data are saved, with the mark that it is one; data that
    /// have no curve are saved as control points.
    pub(super) fn document(&self) -> ShapedPoints {
        let plain = ShapedPoints {
            points: self.points.clone().into(),
            blend: self.blend.clone().map(Into::into),
            ..self.recipe.clone()
        };
        let Some(curve) = self.curve().ok().filter(|_| self.through) else { return plain };
        let recipe = self.recipe.with_parameters(curve.basis().family());
        ShapedPoints {
            points: curve.points().to_vec().into(),
            blend: curve.blend().map(|blend| blend.to_vec().into()),
            through: true,
            ..recipe
        }
    }
}

impl<const D: usize> Form<D> {
    /// The form of a document with these points and this polygon.
    pub(super) fn of_document(
        document: &ShapedPoints,
        points: Vec<Point<D>>,
        blend: Option<Vec<Point<D>>>,
    ) -> Form<D> {
        let recipe =
            ShapedPoints { points: Places::default(), blend: None, through: false, ..document.clone() };
        let form = Form { points, blend, through: false, recipe };
        if document.through { form.with_data().unwrap_or(form) } else { form }
    }

    /// The same curve by the points that it passes, if it is one through points.
    fn with_data(&self) -> Option<Form<D>> {
        let curve = self.curve().ok().filter(|_| self.can_interpolate())?;
        let mut joints = curve.joints();
        let closed = self.closure() == Closure::Closed;
        if closed {
            // The first joint belongs to the second point.
            joints.rotate_right(1);
        }
        let mut recipe = self.recipe.clone();
        if let Some(LambdaValue::Each(all)) = recipe.lambda.as_mut().filter(|_| !closed) {
            *all = all.get(1..all.len().saturating_sub(1))?.to_vec();
        }
        let rounded = |x: f64| if x.abs() < 1e6 { (x * GRAIN).round() / GRAIN } else { x };
        let points: Vec<Point<D>> = joints.into_iter().map(|joint| joint.map(rounded)).collect();
        let form = Form { points, blend: None, through: true, recipe };
        // It must be the same curve.
        let again = form.curve().ok()?;
        let far = |a: &[Point<D>], b: &[Point<D>]| {
            let size = a.iter().flatten().fold(1.0, |size: f64, x| size.max(x.abs()));
            a.len() == b.len()
                && a.iter().flatten().zip(b.iter().flatten()).all(|(x, y)| (x - y).abs() <= 1e-6 * size)
        };
        let same = far(again.points(), curve.points())
            && far(again.blend().unwrap_or(&[]), curve.blend().unwrap_or(&[]));
        same.then_some(form)
    }
}

/// The family whose parameter every control point has its own of.
pub(super) fn is_local(family: &Family) -> bool {
    matches!(family, Family::Lambda { kind: LambdaKind::Han | LambdaKind::Gb, .. })
}

/// Whether curves of a family can pass given points.
fn interpolates(name: FamilyName) -> bool {
    use FamilyName::{Alpha, CBSpline, FBSpline, Gb, Han, Spb};
    matches!(name, CBSpline | FBSpline | Han | Alpha | Gb | Spb)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A form of a family with points of the field.
    fn form(name: FamilyName, points: Vec<Point<2>>, closed: bool) -> Form<2> {
        let empty = Form::<2>::empty();
        let family = super::super::kinds::beginning(name, &empty);
        empty.by(name, &family, closed).replaced(points)
    }

    fn places() -> impl Strategy<Value = Vec<Point<2>>> {
        let place = (0..=560, 0..=380).prop_map(|(x, y)| [f64::from(x), f64::from(y)]);
        prop::collection::vec(place, 4..12)
    }

    proptest! {
        #[test]
        fn every_point_keeps_its_lambda(
            points in places(),
            edits in prop::collection::vec((0..4, 0..14usize, 0..14usize), 1..20),
        ) {
            let mut form = form(FamilyName::Han, points, false);
            // The lambda of a point is its x, so that it is known where the point goes.
            for index in 0..form.points.len() {
                form = form.with(Parameter::LambdaOf(index), form.points[index][0]).unwrap();
            }
            for (kind, from, to) in edits {
                let before = form.clone();
                form = form.edited(match kind {
                    0 => Edit::Insert(from, [1000.0, 0.0]),
                    1 => Edit::Delete(from),
                    2 => Edit::Renumber(from, to),
                    _ => Edit::Move(from, form.points.get(from).copied().unwrap_or([0.0; 2])),
                });
                prop_assert!(form.points.is_empty() || form.lambdas().is_none_or(|all| all.len() == form.points.len()));
                // What was there before has what it had; a new point has the mean of its neighbours.
                if let (true, Some(all)) = (kind == 1 || kind == 2, form.lambdas()) {
                    for (point, lambda) in form.points.iter().zip(all) {
                        let old = before.points.iter().zip(before.lambdas().unwrap_or(&[]));
                        let mut same = old.filter(|(place, _)| *place == point);
                        prop_assert!(same.any(|(_, old)| old == lambda));
                    }
                }
            }
        }

        #[test]
        fn a_curve_through_data_is_read_as_it_was_written(points in places(), closed: bool, which in 0..6usize) {
            use FamilyName::{Alpha, CBSpline, FBSpline, Gb, Han, Spb};
            let form = form([CBSpline, FBSpline, Han, Alpha, Gb, Spb][which], points, closed).through(true);
            prop_assume!(form.curve().is_ok());
            let document = form.document();
            let (points, blend) = (document.points.plane().unwrap(), document.blend.as_ref());
            let blend = blend.and_then(Places::plane).map(<[Point<2>]>::to_vec);
            prop_assert_eq!(Form::of_document(&document, points.to_vec(), blend), form);
        }

        #[test]
        fn the_dragged_datum_is_passed_by_blended_curves(points in places(), closed: bool, to in (0..=560, 0..=380)) {
            let form = form(FamilyName::Gb, points, closed).through(true);
            let index = form.points.len() / 2;
            let moved = form.edited(Edit::Move(index, [f64::from(to.0), f64::from(to.1)]));
            let mut joints = moved.curve().unwrap().joints();
            if closed {
                joints.rotate_right(1);
            }
            for (joint, datum) in joints.iter().zip(&moved.points) {
                prop_assert!((joint[0] - datum[0]).hypot(joint[1] - datum[1]) < 1e-9);
            }
        }
    }

    #[test]
    fn a_blend_of_a_file_moves_with_its_points() {
        let document = ShapedPoints {
            family: FamilyName::Alpha,
            lambda: Some(LambdaValue::One(0.5)),
            ..ShapedPoints::default()
        };
        let points: Vec<Point<2>> = (0..5).map(|x| [f64::from(100 * x), 100.0]).collect();
        let blend: Vec<Point<2>> = points.iter().map(|[x, y]| [*x, y + 50.0]).collect();
        let form = Form::of_document(&document, points, Some(blend));
        let moved = form.edited(Edit::Move(2, [210.0, 130.0])).edited(Edit::Delete(0));
        let blend = moved.document().blend.expect("it is kept");
        assert_eq!(blend.plane().unwrap()[1], [210.0, 180.0]);
        assert_eq!(blend.len(), 4);
        assert!(moved.curve().is_ok());
    }
}
