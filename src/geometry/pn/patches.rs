//! Rational Bézier patches as a surface, such as those that offsets are written as.

use super::bernstein::Tensor;
use super::rational::RationalPatch;
use crate::geometry::param::clipped;
use crate::geometry::point::within_limit;
use crate::geometry::{BSplineSurface, Derivatives, GeometryError, ParamSurface, Point};

/// The highest degree, with which binomials are still exact.
const MOST_DEGREES: usize = 25;

/// A surface of rational Bézier patches in a net, which need not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct RationalPatches {
    size: [usize; 2],
    patches: Vec<RationalPatch>,
}

impl RationalPatch {
    /// The patch of homogeneous points (xw, yw, zw, w), as [`RationalPatch::points`] gives them.
    ///
    /// # Errors
    /// [`GeometryError::TooFewPoints`], [`GeometryError::Ragged`], [`GeometryError::TooManyPoints`] for a degree
    /// above 25, and [`GeometryError::NotFinite`].
    pub fn new(points: &[Vec<[f64; 4]>]) -> Result<Self, GeometryError> {
        let columns = points.first().map_or(0, Vec::len);
        let given = points.len().min(columns);
        if given == 0 {
            return Err(GeometryError::TooFewPoints { given, needed: 1 });
        }
        if let Some(row) = points.iter().position(|row| row.len() != columns) {
            return Err(GeometryError::Ragged { row, given: points[row].len(), needed: columns });
        }
        let most = points.len().max(columns);
        if most > MOST_DEGREES + 1 {
            return Err(GeometryError::TooManyPoints { given: most, most: MOST_DEGREES + 1 });
        }
        let place = points.iter().flatten().position(|point| point.iter().any(|x| !x.is_finite()));
        if let Some(place) = place {
            return Err(GeometryError::NotFinite { number: place + 1 });
        }
        let degrees = [points.len() - 1, columns - 1];
        let part = |d: usize| Tensor::from_fn(degrees, |k, l| points[k][l][d]);
        Ok(Self { parts: std::array::from_fn(part) })
    }

    fn at(&self, u: f64, v: f64) -> Option<Derivatives> {
        let [x, y, z, w] = self.parts.each_ref().map(|part| part.jet(u, v));
        // With X = x w and so on: w x' = X' - w' x, w x'' = X'' - 2 w' x' - w'' x.
        let quotient = |x: [f64; 6]| {
            let [value, u, v, uu, uv, vv] = x;
            let value = value / w[0];
            let (u, v) = ((u - w[1] * value) / w[0], (v - w[2] * value) / w[0]);
            [
                value,
                u,
                v,
                (uu - 2.0 * w[1] * u - w[3] * value) / w[0],
                (uv - w[1] * v - w[2] * u - w[4] * value) / w[0],
                (vv - 2.0 * w[2] * v - w[5] * value) / w[0],
            ]
        };
        let axes = [x, y, z].map(quotient);
        let [point, u, v, uu, uv, vv] = std::array::from_fn(|k| axes.map(|axis| axis[k]));
        let finite = [u, v, uu, uv, vv].iter().flatten().all(|x| x.is_finite());
        (finite && within_limit(&point)).then_some(Derivatives { point, u, v, uu, uv, vv })
    }
}

impl RationalPatches {
    /// A net of patches, row by row.
    ///
    /// # Errors
    /// [`GeometryError::TooFewPoints`] for another number of patches than rows and columns say, and for a patch
    /// without a point somewhere on its corners, as where all weights are zero.
    pub fn new(size: [usize; 2], patches: Vec<RationalPatch>) -> Result<Self, GeometryError> {
        let needed = size[0].saturating_mul(size[1]).max(1);
        let whole = patches.iter().filter(|patch| {
            [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].iter().all(|[u, v]| patch.at(*u, *v).is_some())
        });
        let given = whole.count();
        if given != needed || patches.len() != needed {
            return Err(GeometryError::TooFewPoints { given, needed });
        }
        Ok(Self { size, patches })
    }

    fn patch(&self, [i, j]: [usize; 2]) -> Option<&RationalPatch> {
        if j < self.size[1] { self.patches.get(i * self.size[1] + j) } else { None }
    }
}

impl ParamSurface for RationalPatches {
    fn spans(&self) -> [usize; 2] {
        self.size
    }

    fn closed(&self) -> [bool; 2] {
        [false, false]
    }

    fn at(&self, spans: [usize; 2], [u, v]: [f64; 2]) -> Option<Derivatives> {
        self.patch(spans)?.at(clipped(u), clipped(v))
    }

    fn eval(&self, spans: [usize; 2], [u, v]: [f64; 2]) -> Option<Point<3>> {
        self.patch(spans)?.eval(u, v)
    }

    /// Exactly, where all patches have the same degrees and positive weights, and share the points of their borders.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        let degrees = self.patches.first()?.degrees();
        let [rows, columns] = [0, 1].map(|d| degrees[d] * self.size[d] + 1);
        let fits = |patch: &RationalPatch| patch.degrees() == degrees && patch.has_positive_weights();
        if degrees.contains(&0) || !self.patches.iter().all(fits) {
            return None;
        }
        let mut net: Vec<Vec<Option<[f64; 4]>>> = vec![vec![None; columns]; rows];
        for (index, patch) in self.patches.iter().enumerate() {
            let (i, j) = (index / self.size[1], index % self.size[1]);
            for (k, row) in patch.points().into_iter().enumerate() {
                for (l, point) in row.into_iter().enumerate() {
                    let place = &mut net[i * degrees[0] + k][j * degrees[1] + l];
                    if place.is_some_and(|known| !same(known, point)) {
                        return None;
                    }
                    *place = Some(place.unwrap_or(point));
                }
            }
        }
        let net: Option<Vec<Vec<[f64; 4]>>> = net.into_iter().map(|row| row.into_iter().collect()).collect();
        let knots = self.size.map(|spans| (0..=spans).map(|k| k as f64).collect());
        let multiplicities = [0, 1].map(|d| {
            let inner = |k: usize| if k == 0 || k == self.size[d] { degrees[d] + 1 } else { degrees[d] };
            (0..=self.size[d]).map(inner).collect()
        });
        Some(BSplineSurface::rational(degrees, knots, multiplicities, &net?))
    }
}

/// Whether homogeneous points are the same but for rounding.
fn same(a: [f64; 4], b: [f64; 4]) -> bool {
    let size = a.iter().chain(&b).fold(0.0_f64, |most, x| most.max(x.abs()));
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-12 * size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::pn::examples::{data, paraboloid, saddle};
    use crate::geometry::point::{norm, scaled_difference};
    use crate::geometry::surface::indices;
    use crate::geometry::{PnMethod, PnSurface};

    fn patches(surface: &PnSurface) -> RationalPatches {
        let patches = indices(surface.spans())
            .map(|spans| RationalPatch::new(&surface.rational_patch(spans).unwrap().points()).unwrap());
        RationalPatches::new(surface.spans(), patches.collect()).unwrap()
    }

    #[test]
    fn patches_are_the_offset_with_its_derivatives() {
        let surface =
            PnSurface::new(&data(saddle, 3, 4), PnMethod::Normalised).unwrap().offset(-0.7).unwrap();
        let written = patches(&surface);
        for sample in surface.sample(5).unwrap() {
            let one = surface.at(sample.spans, sample.parameters).unwrap();
            let other = written.at(sample.spans, sample.parameters).unwrap();
            for (one, other) in [
                (one.point, other.point),
                (one.u, other.u),
                (one.v, other.v),
                (one.uu, other.uu),
                (one.uv, other.uv),
                (one.vv, other.vv),
            ] {
                let apart = norm(scaled_difference(1.0, one, other));
                assert!(apart < 1e-10 * (1.0 + norm(one)), "{one:?} {other:?}");
            }
        }
    }

    #[test]
    fn whole_surface_is_one_b_spline() {
        let surface = PnSurface::new(&data(paraboloid, 3, 3), PnMethod::Normalised).unwrap();
        let (one, other) = (surface.to_bspline().unwrap(), patches(&surface).to_bspline().unwrap());
        for (s, t) in [(0.0, 0.0), (0.3, 1.7), (1.0, 1.0), (2.0, 0.4)] {
            let (one, other) = (one.eval(s, t).unwrap(), other.eval(s, t).unwrap());
            assert!(norm(scaled_difference(1.0, one, other)) < 1e-12);
        }
    }

    #[test]
    fn wrong_patches_are_named() {
        assert!(RationalPatch::new(&[]).is_err());
        assert!(RationalPatch::new(&[vec![[0.0; 4]], vec![]]).is_err());
        assert!(RationalPatch::new(&[vec![[f64::NAN; 4]]]).is_err());
        assert!(RationalPatch::new(&vec![vec![[1.0; 4]]; 27]).is_err());
        let empty = RationalPatch::new(&[vec![[0.0; 4]; 2]]).unwrap();
        assert!(RationalPatches::new([1, 1], vec![empty]).is_err());
        assert!(RationalPatches::new([1, 1], Vec::new()).is_err());
    }
}
