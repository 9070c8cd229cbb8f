//! A surface by a control net, with its recipe.

use super::{DesignError, NORMALS_SIZE};
use crate::file::{Method, Net, NetKind, NetSettings};
use crate::geometry::{Border, Method as Formula, ParamSurface, Point, Scheme, Surface, Topology};

/// The part of a Hermite matrix that a change concerns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
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
    /// Every part.
    pub const ALL: [Part; 4] = [Part::Place, Part::Twist, Part::TangentU, Part::TangentV];

    /// Its offset in the matrix (3.17) from the corner.
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
pub type Index = [usize; 2];

/// A control net, and how the surface follows it.
#[derive(Clone, Debug, PartialEq)]
pub struct NetDesign {
    /// The net with method and parameters. Row k holds the points of constant u; all rows have the same length.
    pub net: Net,
    /// The method where the net names none.
    pub implied: Method,
}

/// The largest net of an editor: JSON files may hold more than the 8 x 5 of the DOS files.
pub(super) const MOST: usize = 64;
/// The largest coordinate of an editor.
pub(super) const FARTHEST: f64 = 1e6;

impl NetDesign {
    /// A net with the method that its kind implies.
    pub fn new(net: Net) -> NetDesign {
        let implied = match net.kind {
            NetKind::Fhc => Method::Hermite,
            NetKind::Fps | NetKind::Fem | NetKind::Zms | NetKind::Zys => Method::Spline,
            NetKind::Fpb => Method::Bezier,
            NetKind::Fbs | NetKind::Zmb | NetKind::Zyb => Method::BSpline3,
            NetKind::Zyp => Method::Beta,
            NetKind::Pn => Method::Pn,
        };
        NetDesign { net, implied }
    }

    /// The method that the surface follows the net by.
    pub fn method(&self) -> Method {
        self.net.settings.method.unwrap_or(self.implied)
    }

    /// Bias along u and v.
    pub fn bias(&self) -> [f64; 2] {
        self.net.settings.bias.unwrap_or([1.0; 2])
    }

    /// Tension along u and v.
    pub fn tension(&self) -> [f64; 2] {
        self.net.settings.tension.unwrap_or([0.0; 2])
    }

    /// Coefficient of the tangents along u and v.
    pub fn k0(&self) -> [f64; 2] {
        self.net.settings.k0.unwrap_or([0.5; 2])
    }

    /// Where a cubic B-spline ends, and whether poles are ordinary ends.
    pub fn border(&self) -> Border {
        let NetSettings { extended, free_poles, inner, .. } = self.net.settings;
        match self.net.kind.topology() {
            Topology::Sphere if free_poles == Some(true) => Border::Free,
            Topology::Open if inner == Some(true) => Border::Inner,
            _ if extended == Some(true) => Border::Reached,
            _ => Border::Doubled,
        }
    }

    /// The design with another border.
    #[must_use]
    pub fn with_border(&self, border: Border) -> NetDesign {
        self.with_settings(|settings| {
            settings.extended = (border == Border::Reached).then_some(true);
            settings.free_poles = (border == Border::Free).then_some(true);
            settings.inner = (border == Border::Inner).then_some(true);
        })
    }

    /// The design with other settings.
    #[must_use]
    pub fn with_settings(&self, change: impl FnOnce(&mut NetSettings)) -> NetDesign {
        let mut design = self.clone();
        change(&mut design.net.settings);
        design
    }

    /// Methods along u and v, topology and border; `None` for the Hermite patch and for surfaces with Pythagorean
    /// normals.
    ///
    /// # Errors
    /// [`DesignError`] if the net lacks what the method needs.
    pub fn scheme(&self) -> Result<Option<Scheme>, DesignError> {
        let method = self.method();
        match (method, self.net.kind) {
            (Method::Hermite, NetKind::Fhc) => return Ok(None),
            (_, NetKind::Fhc) => return Err(DesignError::OnlyHermite),
            (Method::Hermite, _) => return Err(DesignError::NeedsTwists),
            (
                Method::Coons
                | Method::Arcs
                | Method::BSpline
                | Method::Fourier
                | Method::PhSpline
                | Method::PhHermite
                | Method::PhCubic,
                _,
            ) => {
                return Err(DesignError::ForCurves(method));
            }
            (Method::Pn | Method::PnThesis, kind) => {
                let open = kind.topology() == Topology::Open;
                return if open { Ok(None) } else { Err(DesignError::OpenOnly(method)) };
            }
            _ => {}
        }
        let (k0, bias, tension) = (self.k0(), self.bias(), self.tension());
        let along = |d: usize| -> Result<Formula, DesignError> {
            method.with(k0[d], bias[d], tension[d]).ok_or(DesignError::Needs(method))
        };
        let topology = self.net.kind.topology();
        Ok(Some(Scheme { u: along(0)?, v: along(1)?, topology, border: self.border() }))
    }

    /// The surface as the book draws it, or extended to its borders.
    ///
    /// # Errors
    /// Those of [`NetDesign::scheme`], and of the geometry.
    pub fn surface(&self) -> Result<Box<dyn ParamSurface>, DesignError> {
        if let Some(joined) = self.joined()? {
            return Ok(Box::new(joined));
        }
        Ok(match self.scheme()? {
            Some(scheme) => Box::new(Surface::new(scheme, &self.net.points)?),
            None if self.is_matrix() => Box::new(Surface::hermite(&self.matrix()?)?),
            None => Box::new(self.patches_with_normals()?.surface()?),
        })
    }

    /// The surface as a solid model: on a sphere it reaches the poles, where the book's cubic B-spline leaves holes.
    ///
    /// # Errors
    /// As [`NetDesign::surface`].
    pub fn solid(&self) -> Result<Box<dyn ParamSurface>, DesignError> {
        match self.scheme()? {
            Some(scheme) if scheme.topology == Topology::Sphere && scheme.border != Border::Free => {
                let reached = Scheme { border: Border::Reached, ..scheme };
                Ok(Box::new(Surface::new(reached, &self.net.points)?))
            }
            _ => self.surface(),
        }
    }

    /// The matrix of a Hermite net, which JSON may hold in another size.
    pub(super) fn matrix(&self) -> Result<[[Point<3>; 4]; 4], DesignError> {
        let rows: Option<Vec<[Point<3>; 4]>> =
            self.net.points.iter().map(|row| row.as_slice().try_into().ok()).collect();
        rows.and_then(|rows| rows.try_into().ok()).ok_or(DesignError::NoMatrix)
    }

    /// Whether the net is the matrix of a Hermite patch.
    pub(super) fn is_matrix(&self) -> bool {
        self.net.kind == NetKind::Fhc
    }

    /// The numbers of rows and of points in a row.
    pub fn shape(&self) -> [usize; 2] {
        [self.net.points.len(), self.net.points.first().map_or(0, Vec::len)]
    }

    /// The numbers of control points that can be chosen along u and v.
    pub fn choices(&self) -> [usize; 2] {
        match self.is_matrix() {
            // The corners at the joint are there for the first and for the second patch.
            true if self.joint().is_some() => [4, 2],
            true => [2, 2],
            false => self.shape(),
        }
    }

    /// The places that can be chosen.
    pub fn indices(&self) -> impl Iterator<Item = Index> + use<> {
        let [rows, columns] = self.choices();
        (0..columns).flat_map(move |l| (0..rows).map(move |k| [k, l]))
    }

    /// A control point.
    pub fn point(&self, index: Index) -> Option<Point<3>> {
        self.part(index, Part::Place)
    }

    /// A part of a control point.
    pub fn part(&self, index: Index, part: Part) -> Option<Point<3>> {
        let [row, column] = self.entry(index, part)?;
        self.net.points.get(row)?.get(column).copied()
    }

    /// Where the net holds a part of a control point.
    pub(super) fn entry(&self, [k, l]: Index, part: Part) -> Option<[usize; 2]> {
        let [down, right] = part.offset();
        let row = match (self.is_matrix() && self.joint().is_some(), down) {
            (true, 0) => *[0, 1, 1, 2].get(k)?,
            (true, _) => k + 3,
            (false, _) => k + down,
        };
        Some([row, l + right])
    }

    /// The design with a new value for a part of a control point. A pole is one point in all rows; what two patches keep
    /// at their joint is kept.
    #[must_use]
    pub fn with_part(&self, index: Index, part: Part, value: Point<3>) -> NetDesign {
        let mut design = self.clone();
        let Some([row, column]) = self.entry(index, part) else { return design };
        let from = self.part(index, part).unwrap_or_default();
        design.put([row, column], value);
        if self.joint().is_some() {
            design.keep_joint([row, column], from);
        }
        design
    }

    /// Writes a point of the net; a pole into every row.
    pub(super) fn put(&mut self, [row, column]: [usize; 2], value: Point<3>) {
        let [rows, columns] = self.shape();
        let pole = self.net.kind.topology() == Topology::Sphere && (column == 0 || column + 1 == columns);
        for row in if pole { 0..rows } else { row..row + 1 } {
            if let Some(point) = self.net.points.get_mut(row).and_then(|row| row.get_mut(column)) {
                *point = value;
            }
        }
    }

    /// The surface whose first coordinate is the weight of a control point: all methods of nets but those of normals are
    /// linear in the points.
    ///
    /// # Errors
    /// As [`NetDesign::surface`].
    pub fn influence(&self, index: Index) -> Result<Box<dyn ParamSurface>, DesignError> {
        let mut unit = self.clone();
        unit.net.points.iter_mut().flatten().for_each(|point| *point = [0.0; 3]);
        if let Some(entry) = self.entry(index, Part::Place) {
            unit.put(entry, [1.0, 0.0, 0.0]);
        }
        unit.surface()
    }

    /// The design with a control point moved; for height fields only its height changes.
    #[must_use]
    pub fn moved(&self, index: Index, to: Point<3>) -> NetDesign {
        let Some([x, y, _]) = self.point(index) else { return self.clone() };
        let to = to.map(|value| value.clamp(-FARTHEST, FARTHEST));
        let to = if self.net.kind == NetKind::Fem { [x, y, to[2]] } else { to };
        self.with_part(index, Part::Place, to)
    }

    /// The design mirrored in the plane where an axis is zero: 0 is x, 1 is y, 2 is z.
    #[must_use]
    pub fn mirrored(&self, axis: usize) -> NetDesign {
        let mut design = self.clone();
        let normals = design.net.normals.iter_mut().flatten().flatten();
        let all = design.net.points.iter_mut().flatten().chain(normals);
        for value in all.filter_map(|point| point.get_mut(axis)) {
            // Adding zero makes a negative zero positive.
            *value = -*value + 0.0;
        }
        design
    }

    /// The design, if an editor can show it. Points of a pole that differ by rounding in the file become one point.
    ///
    /// # Errors
    /// [`DesignError::NetSize`].
    pub fn fitting(self) -> Result<NetDesign, DesignError> {
        let (kind, shape) = (self.net.kind, self.shape());
        let fewest = if kind.topology() == Topology::Open { 2 } else { 3 };
        let least = kind.shape().map(|count| count.min(fewest));
        let most = if kind == NetKind::Pn { *NORMALS_SIZE.end() } else { MOST };
        let fits = match self.is_matrix() {
            true if self.joint().is_some() => shape == [7, 4],
            true => shape == [4, 4],
            false => shape.iter().zip(least).all(|(&count, least)| (least..=most).contains(&count)),
        };
        let points = &self.net.points;
        let near = points.iter().flatten().flatten().all(|value| value.abs() <= FARTHEST);
        if !fits || !near || points.iter().any(|row| row.len() != shape[1]) {
            return Err(DesignError::NetSize { found: shape, least, most });
        }
        if kind.topology() != Topology::Sphere {
            return Ok(self);
        }
        Ok([0, shape[1].saturating_sub(1)].iter().fold(self, |design, &l| {
            let pole = design.point([0, l]).unwrap_or_default();
            design.with_part([0, l], Part::Place, pole)
        }))
    }

    /// The lines of the control net, and whether they are closed: along u, then along v.
    pub fn polygons(&self) -> Vec<(Vec<Point<3>>, bool)> {
        let [rows, columns] = self.choices();
        let [closed_u, closed_v] = self.net.kind.topology().closed();
        let line = |places: Vec<Index>| -> Vec<Point<3>> {
            let mut line: Vec<Point<3>> = places.into_iter().filter_map(|index| self.point(index)).collect();
            if self.is_matrix() {
                // The corners at a joint are there twice.
                line.dedup();
            }
            line
        };
        let along_u = (0..columns).map(|l| (line((0..rows).map(|k| [k, l]).collect()), closed_u));
        let along_v = (0..rows).map(|k| (line((0..columns).map(|l| [k, l]).collect()), closed_v));
        along_u.chain(along_v).collect()
    }

    /// The control points with their numbers, row by row, a pole only once.
    pub fn discs(&self) -> Vec<(Index, Point<3>)> {
        let [rows, columns] = self.choices();
        let sphere = self.net.kind.topology() == Topology::Sphere;
        let all = (0..rows).flat_map(|k| (0..columns).map(move |l| [k, l]));
        let joint = |k: usize| self.is_matrix() && self.joint().is_some() && k == 2;
        let once = all.filter(|&[k, l]| !(sphere && k > 0 && (l == 0 || l + 1 == columns)) && !joint(k));
        once.filter_map(|index| Some((index, self.point(index)?))).collect()
    }
}
