//! The surface with Pythagorean normals, and its offsets.

use super::chart::Chart;
use super::net::{Jacobian, PnNet};
use super::patch::{self, Local};
use super::{PnData, PnMethod};
use crate::geometry::limits::COORDINATE_LIMIT;
use crate::geometry::point::{add_scaled, within_limit};
use crate::geometry::{
    BSplineSurface, Derivatives, GeometryError, ParamSurface, Patch, Point, RationalSurface,
};

/// A regular surface with Pythagorean normals, or an offset of one, which is another.
///
/// It goes through the points of its data and has their normals there. Neighbouring patches have the same
/// points, normals and tangent planes at their border (G1). The patches are images of bicubic ones, and
/// rational of degree (11, 11).
///
/// ```
/// use grafika::geometry::{ParamSurface, PnData, PnMethod, PnSurface};
///
/// // A piece of the unit sphere, and a sphere of radius 3 as its offset.
/// let normal = |i: i32, j: i32| {
///     let (x, y) = (0.3 * f64::from(i), 0.3 * f64::from(j));
///     [x, y, -(1.0 - x * x - y * y).sqrt()]
/// };
/// let points: Vec<Vec<[f64; 3]>> = (-1..=1).map(|i| (-1..=1).map(|j| normal(i, j)).collect()).collect();
/// let sphere = PnSurface::new(&PnData::new(&points, &points)?, PnMethod::Normalised)?;
/// let place = sphere.offset(2.0)?.place([0, 1], [0.3, 0.8]).expect("there is such a patch");
/// let [x, y, z] = place.point;
/// assert!(((x * x + y * y + z * z).sqrt() - 3.0).abs() < 1e-14);
/// assert!(place.radii.iter().all(|radius| (radius - 3.0).abs() < 1e-13));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PnSurface {
    pub(super) chart: Chart,
    pub(super) size: [usize; 2],
    pub(super) patches: Vec<(Patch, Jacobian)>,
    /// From the surface through the data, in the unit of the data.
    distance: f64,
}

/// What a place of a surface is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PnPlace {
    /// The point.
    pub point: Point<3>,
    /// The unit normal, oriented as those of the data.
    pub normal: Point<3>,
    /// The radii of curvature r1 <= r2 in the principal directions: dx = r dn, so that they are negative where
    /// the surface bends towards its normal, and an offset at the distance d has r1 + d and r2 + d.
    pub radii: [f64; 2],
    /// The stereographic image of the normal in the chart of the data, as in [`PnNet::isotropic`].
    pub gauss: [f64; 2],
}

impl PnSurface {
    /// The surface through some data.
    ///
    /// # Errors
    /// Those of [`PnNet::new`]; [`GeometryError::Parabolic`] names the first patch that is not regular.
    pub fn new(data: &PnData, method: PnMethod) -> Result<Self, GeometryError> {
        PnNet::new(data, method)?.surface()
    }

    pub(super) fn of(chart: Chart, size: [usize; 2], patches: Vec<(Patch, Jacobian)>) -> Self {
        Self { chart, size, patches, distance: 0.0 }
    }

    /// The offset at a distance from this surface, positive along the normals; also where it folds.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a distance that is not finite or too large.
    pub fn offset(&self, distance: f64) -> Result<Self, GeometryError> {
        let sum = self.distance + distance;
        if sum.is_nan() || sum.abs() > COORDINATE_LIMIT {
            let wanted = "a finite number of at most 1e150";
            return Err(GeometryError::Parameter { name: "distance", value: distance, wanted });
        }
        Ok(Self { distance: sum, ..self.clone() })
    }

    /// The distance from the surface through the data.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// How far points of the chart are moved along their normals, in its unit.
    pub(super) fn shift(&self) -> f64 {
        self.chart.radius + self.chart.to_chart(self.distance)
    }

    fn patch(&self, [i, j]: [usize; 2]) -> Option<&Patch> {
        if j < self.size[1] { self.patches.get(i * self.size[1] + j).map(|(y, _)| y) } else { None }
    }

    /// Point, normal and radii of curvature at a place as in [`ParamSurface::at`].
    #[must_use]
    pub fn place(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<PnPlace> {
        let local = patch::jet_at(self.patch(spans)?, uv);
        let value = |jets: [super::jet::Jet2; 3]| jets.map(|jet| jet.0[0]);
        let place = PnPlace {
            point: self.in_space(value(local.point), value(local.normal)),
            normal: self.chart.direction(value(local.normal)),
            radii: self.radii_of(&local),
            gauss: local.gauss.map(|jet| jet.0[0]),
        };
        let finite = within_limit(&place.point) && place.radii.iter().all(|radius| radius.is_finite());
        finite.then_some(place)
    }

    /// The radii of curvature at a place alone.
    pub(super) fn radii(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<[f64; 2]> {
        Some(self.radii_of(&patch::jet_at(self.patch(spans)?, uv)))
    }

    fn radii_of(&self, local: &Local<super::jet::Jet2>) -> [f64; 2] {
        local.radii().map(|radius| self.chart.length(radius + self.chart.radius) + self.distance)
    }

    /// A point of the chart, moved along its normal, in space.
    fn in_space(&self, point: Point<3>, normal: Point<3>) -> Point<3> {
        self.chart.point(add_scaled(point, self.shift(), normal), 1.0)
    }
}

impl ParamSurface for PnSurface {
    fn spans(&self) -> [usize; 2] {
        self.size
    }

    fn closed(&self) -> [bool; 2] {
        [false, false]
    }

    fn at(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Derivatives> {
        let local = patch::jet_at(self.patch(spans)?, uv);
        let part = |k: usize| {
            let [point, normal] = [local.point, local.normal].map(|it| it.map(|jet| jet.0[k]));
            if k == 0 {
                self.in_space(point, normal)
            } else {
                let turned = self.chart.direction(add_scaled(point, self.shift(), normal));
                turned.map(|x| self.chart.length(x))
            }
        };
        let [point, u, v, uu, uv, vv] = std::array::from_fn(part);
        let finite = [point, u, v, uu, uv, vv].iter().flatten().all(|x| x.is_finite());
        finite.then_some(Derivatives { point, u, v, uu, uv, vv })
    }

    fn eval(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Point<3>> {
        let local = patch::at(self.patch(spans)?, uv);
        let point = self.in_space(local.point, local.normal);
        within_limit(&point).then_some(point)
    }

    /// The exact unit normal, in the direction of r_u x r_v, which is that of the data where -J r1 r2 is
    /// positive and the opposite where it is negative. `None` outside the spans and on a cuspidal edge, where a
    /// radius is zero.
    fn normal(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Point<3>> {
        let local = patch::jet_at(self.patch(spans)?, uv);
        let [r1, r2] = self.radii_of(&local);
        let side = -local.jacobian.0[0].signum() * r1.signum() * r2.signum();
        let normal = self.chart.direction(local.normal.map(|jet| side * jet.0[0]));
        (r1 != 0.0 && r2 != 0.0 && within_limit(&normal)).then_some(normal)
    }

    /// The rational B-spline surface of [`PnSurface::to_rational`].
    fn to_bspline(&self) -> Option<BSplineSurface> {
        let RationalSurface { degrees, knots, multiplicities, net } = self.to_rational().ok()?;
        Some(BSplineSurface::rational(degrees, knots, multiplicities, &net))
    }
}
