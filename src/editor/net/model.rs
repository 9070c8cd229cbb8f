//! What a surface program edits: a net and its shape parameters, changed by named edits.

use super::plan::{Family, Form, Plan};
use crate::file::{Method as MethodName, Net, NetSettings};
use crate::geometry::{Border, GeometryError, Point, Surface, Topology};
use crate::ui::words::{self, Phrase};

/// What part of a Hermite matrix a change is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// A control point; for the Hermite patch a corner.
    Place,
    /// The derivative by u in a corner.
    TangentU,
    /// The derivative by v.
    TangentV,
    /// The mixed derivative.
    Twist,
}

impl Part {
    /// Where it stands in the matrix (3.17), from the corner's place.
    fn offset(self) -> [usize; 2] {
        match self {
            Part::Place => [0, 0],
            Part::TangentU => [2, 0],
            Part::TangentV => [0, 2],
            Part::Twist => [2, 2],
        }
    }
}

/// The place of a control point: k counts in the direction of u, l in that of v.
pub(super) type Index = [usize; 2];

/// A net with its shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Model {
    /// Row k is the points of constant u, all of the same number.
    pub(super) net: Vec<Vec<Point<3>>>,
    pub(super) form: Form,
    /// Where a cubic B-spline ends.
    pub(super) border: Border,
}

/// The largest net: JSON files may hold more than the 8 x 5 of the DOS files.
const MOST: usize = 64;
/// The largest coordinate.
const FARTHEST: f64 = 1e6;

impl Model {
    pub(super) fn new(plan: &Plan) -> Model {
        Model { net: plan.net(), form: Form::default(), border: Border::Doubled }
    }

    /// The numbers of rows and of points in a row.
    pub(super) fn shape(&self) -> [usize; 2] {
        [self.net.len(), self.net.first().map_or(0, Vec::len)]
    }

    /// How many control points can be chosen in each direction: those of the map.
    pub(super) fn choices(&self, plan: &Plan) -> [usize; 2] {
        if plan.family == Family::Hermite { [2, 2] } else { self.shape() }
    }

    /// The places that can be chosen.
    pub(super) fn indices(&self, plan: &Plan) -> impl Iterator<Item = Index> + use<> {
        let [rows, columns] = self.choices(plan);
        (0..columns).flat_map(move |l| (0..rows).map(move |k| [k, l]))
    }

    pub(super) fn point(&self, index: Index) -> Option<Point<3>> {
        self.part(index, Part::Place)
    }

    pub(super) fn part(&self, [k, l]: Index, part: Part) -> Option<Point<3>> {
        let [down, right] = part.offset();
        self.net.get(k + down)?.get(l + right).copied()
    }

    /// The model with another value for a part of a control point. A pole is one point in all rows.
    pub(super) fn with_part(&self, plan: &Plan, [k, l]: Index, part: Part, value: Point<3>) -> Model {
        let mut model = self.clone();
        let [down, right] = part.offset();
        let [_, columns] = self.shape();
        let pole = plan.kind.topology() == Topology::Sphere && (l == 0 || l + 1 == columns);
        let rows = if pole { 0..self.net.len() } else { k + down..k + down + 1 };
        for row in rows {
            if let Some(point) = model.net.get_mut(row).and_then(|row| row.get_mut(l + right)) {
                *point = value;
            }
        }
        model
    }

    /// The model with a control point moved; where only heights change, only that.
    pub(super) fn moved(&self, plan: &Plan, index: Index, to: Point<3>) -> Model {
        let Some([x, y, _]) = self.point(index) else { return self.clone() };
        let to = to.map(|value| value.clamp(-FARTHEST, FARTHEST));
        let to = if plan.family == Family::Heights { [x, y, to[2]] } else { to };
        self.with_part(plan, index, Part::Place, to)
    }

    /// The model mirrored in the plane where an axis is zero: 0 is x, 1 is y, 2 is z.
    pub(super) fn mirrored(&self, axis: usize) -> Model {
        let mut model = self.clone();
        for value in model.net.iter_mut().flatten().filter_map(|point| point.get_mut(axis)) {
            // Adding zero makes a negative zero positive.
            *value = -*value + 0.0;
        }
        model
    }

    /// The surface of the net.
    pub(super) fn surface(&self, plan: &Plan, degree: super::Degree) -> Result<Surface, GeometryError> {
        match plan.scheme(&self.form, degree, self.border) {
            Some(scheme) => Surface::new(scheme, &self.net),
            None => Surface::hermite(&self.matrix()),
        }
    }

    fn matrix(&self) -> [[Point<3>; 4]; 4] {
        std::array::from_fn(|r| std::array::from_fn(|c| self.part([r, c], Part::Place).unwrap_or_default()))
    }

    /// The net of a file with the shape that it gives, or else keeps.
    pub(super) fn of_file(plan: &Plan, net: &Net, form: Form) -> Result<Model, Phrase> {
        if net.kind != plan.kind && !plan.reads.contains(&net.kind) {
            return Err(words::other_net(plan.kind.format(), net.kind.format()));
        }
        let shape = [net.points.len(), net.points.first().map_or(0, Vec::len)];
        let least = plan.kind.shape().map(|count| {
            count.min(match plan.kind.topology() {
                Topology::Open => 2,
                Topology::Sphere | Topology::Torus => 3,
            })
        });
        let fits = match plan.family {
            Family::Hermite => shape == [4, 4],
            _ => shape.iter().zip(least).all(|(&count, least)| (least..=MOST).contains(&count)),
        };
        let near = net.points.iter().flatten().flatten().all(|value| value.abs() <= FARTHEST);
        if !fits || !near || net.points.iter().any(|row| row.len() != shape[1]) {
            return Err(words::net_size(shape, least, MOST));
        }
        let NetSettings { k0, bias, tension, extended, .. } = net.settings;
        let form = Form {
            k0: k0.unwrap_or(form.k0),
            bias: bias.unwrap_or(form.bias),
            tension: tension.unwrap_or(form.tension),
        };
        let border = if extended == Some(true) { Border::Reached } else { Border::Doubled };
        let model = Model { net: net.points.clone(), form, border };
        Ok(model.with_one_pole(plan))
    }

    /// Files in single precision have the poles apart by rounding.
    fn with_one_pole(self, plan: &Plan) -> Model {
        let [_, columns] = self.shape();
        match plan.kind.topology() {
            Topology::Sphere => [0, columns.saturating_sub(1)].iter().fold(self, |model, &l| {
                let pole = model.point([0, l]).unwrap_or_default();
                model.with_part(plan, [0, l], Part::Place, pole)
            }),
            Topology::Open | Topology::Torus => self,
        }
    }

    /// The net as a file; with its shape, which only JSON holds, if asked for.
    pub(super) fn to_file(&self, plan: &Plan, degree: super::Degree, settings: bool) -> Net {
        let mut net = Net::new(plan.kind, self.net.clone());
        if settings {
            let (method, form) = (plan.scheme(&self.form, degree, self.border), &self.form);
            net.settings = NetSettings {
                method: method.and_then(|scheme| MethodName::from_name(scheme.u.name())),
                k0: (plan.family == Family::Local).then_some(form.k0),
                bias: (plan.family == Family::Beta).then_some(form.bias),
                tension: (plan.family == Family::Beta).then_some(form.tension),
                extended: (self.border == Border::Reached).then_some(true),
            };
        }
        net
    }
}
