//! B-spline and NURBS surfaces: two knot vectors, a net, perhaps weights. What a moving knot does is done line by line.

use super::envelope::{envelope_knots, envelope_order};
use super::local::Hom;
use super::{KnotCurve, KnotError, KnotVector};
use crate::geometry::point::check_points;
use crate::geometry::{BSplineSurface, Basis, Derivatives, GeometryError, ParamSurface, Point};

/// A surface over two knot vectors. Row `k` of the net counts along `u`, point `l` of it along `v`.
#[derive(Clone, Debug, PartialEq)]
pub struct KnotSurface {
    vectors: [KnotVector; 2],
    net: Vec<Vec<Point<3>>>,
    weights: Option<Vec<Vec<f64>>>,
}

impl KnotSurface {
    /// The surface of a net; weights are as many as points, in rows like them.
    ///
    /// # Errors
    /// A net of another size than the knots are for, a bad coordinate, a wrong weight.
    pub fn new(
        vectors: [KnotVector; 2],
        net: Vec<Vec<Point<3>>>,
        weights: Option<Vec<Vec<f64>>>,
    ) -> Result<Self, KnotError> {
        let [rows, needed] = [0, 1].map(|d| vectors[d].points());
        if net.len() != rows {
            return Err(GeometryError::WrongCount { given: net.len(), needed: rows }.into());
        }
        for (row, points) in net.iter().enumerate() {
            if points.len() != needed {
                return Err(GeometryError::Ragged { row, given: points.len(), needed }.into());
            }
            check_points(points)?;
            let Some(weights) = &weights else { continue };
            let own = weights.get(row).cloned().unwrap_or_default();
            KnotCurve::rational(vectors[1].clone(), points.clone(), own)?;
        }
        if let Some(given) = weights.as_ref().map(Vec::len).filter(|given| *given != rows) {
            return Err(KnotError::WeightCount { given, needed: rows });
        }
        Ok(Self { vectors, net, weights })
    }

    /// The knots along `u` and `v`.
    #[must_use]
    pub fn vectors(&self) -> &[KnotVector; 2] {
        &self.vectors
    }

    /// The control points.
    #[must_use]
    pub fn net(&self) -> &[Vec<Point<3>>] {
        &self.net
    }

    /// The weights; `None` without.
    #[must_use]
    pub fn weights(&self) -> Option<&[Vec<f64>]> {
        self.weights.as_deref()
    }

    /// The same with other knots along one direction.
    ///
    /// # Errors
    /// As [`KnotCurve::with_knot`].
    pub fn with_knot(&self, direction: usize, knot: usize, value: f64) -> Result<Self, KnotError> {
        let mut new = self.clone();
        new.vectors[direction.min(1)] = self.vectors[direction.min(1)].with_knot(knot, value)?;
        Ok(new)
    }

    /// The point at parameters of the knots; `None` outside the domain.
    #[must_use]
    pub fn point_at(&self, [u, v]: [f64; 2]) -> Option<Point<3>> {
        self.line(0, v).ok()?.point_at(u)
    }

    /// The curve along a direction (0: `u`, 1: `v`) at a parameter of the other. Its control points do not depend on the
    /// knots of this direction: all that [`KnotCurve`] says about moving knots holds for it.
    ///
    /// # Errors
    /// [`KnotError::Outside`].
    pub fn line(&self, direction: usize, at: f64) -> Result<KnotCurve<3>, KnotError> {
        let along = direction.min(1);
        let across = &self.vectors[1 - along];
        let outside = KnotError::Outside { name: ["v", "u"][along], value: at, range: across.domain() };
        let span = across.span_of(at).ok_or(outside)?;
        let first = span + 1 - across.order();
        let values = super::local::functions(across.knots(), across.order(), span, at).ok_or(outside)?;
        let points: Vec<Hom<3>> = (0..self.vectors[along].points())
            .map(|i| {
                (0..across.order()).fold(Hom::ZERO, |sum, l| {
                    let place = if along == 0 { [i, first + l] } else { [first + l, i] };
                    sum.mixed(1.0, values[l], self.homogeneous(place))
                })
            })
            .collect();
        KnotCurve::of_homogeneous(self.vectors[along].clone(), &points, self.weights.is_some())
    }

    /// The envelope of the surfaces that copies of a knot of one direction make: of order `k - m` there and of the old
    /// one across. The point `(u_i, v_j)` stays on the envelope of both directions, `envelope(0, ..)` of
    /// `envelope(1, ..)`, whichever of the two knots moves.
    ///
    /// # Errors
    /// As [`KnotCurve::envelope`].
    pub fn envelope(&self, direction: usize, knot: usize, multiplicity: usize) -> Result<Self, KnotError> {
        let along = direction.min(1);
        let (vector, across) = (&self.vectors[along], &self.vectors[1 - along]);
        let low = envelope_order(vector.order(), multiplicity)?;
        let (first, last) = (low, vector.controls());
        let (start, copies) = vector.copies(knot)?;
        if !(first..=last).contains(&knot) {
            return Err(KnotError::Index { name: "knot", given: knot, first, last });
        }
        if !(1..=start + copies - knot).contains(&multiplicity) {
            let last = start + copies - knot;
            return Err(KnotError::Index { name: "multiplicity", given: multiplicity, first: 1, last });
        }
        let (own, _) = envelope_knots(vector.knots(), knot, multiplicity, low)?;
        let mut vectors = [own, across.clone()];
        let size = if along == 0 { [low, across.points()] } else { [across.points(), low] };
        if along == 1 {
            vectors.swap(0, 1);
        }
        let point = |[i, j]: [usize; 2]| {
            let from = knot - low;
            self.homogeneous(if along == 0 { [from + i, j] } else { [i, from + j] })
        };
        let rows = |of: &dyn Fn(Hom<3>) -> Point<3>| -> Vec<Vec<Point<3>>> {
            (0..size[0]).map(|i| (0..size[1]).map(|j| of(point([i, j]))).collect()).collect()
        };
        let net = rows(&|hom| hom.p.map(|x| x / hom.w));
        let weights = self
            .weights
            .is_some()
            .then(|| (0..size[0]).map(|i| (0..size[1]).map(|j| point([i, j]).w).collect()).collect());
        Self::new(vectors, net, weights)
    }

    /// A control point as the formulas count.
    pub(super) fn homogeneous(&self, place: [usize; 2]) -> Hom<3> {
        let [k, l] = [0, 1].map(|d| self.vectors[d].point_index(place[d]));
        let weight = self.weights.as_ref().and_then(|rows| rows.get(k)?.get(l)).copied().unwrap_or(1.0);
        self.net.get(k).and_then(|row| row.get(l)).map_or(Hom::ZERO, |&point| Hom::of(point, weight))
    }
}

impl ParamSurface for KnotSurface {
    fn spans(&self) -> [usize; 2] {
        [0, 1].map(|d| self.vectors[d].spans())
    }

    fn closed(&self) -> [bool; 2] {
        [0, 1].map(|d| self.vectors[d].closed())
    }

    fn at(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Derivatives> {
        let (mut along, mut across) = (Vec::new(), Vec::new());
        let first = [
            self.vectors[0].weights(spans[0], uv[0], &mut along)?,
            self.vectors[1].weights(spans[1], uv[1], &mut across)?,
        ];
        // By degree along u, then along v.
        let mut sums = [[Hom::<3>::ZERO; 3]; 3];
        for (k, a) in along.iter().enumerate() {
            for (l, b) in across.iter().enumerate() {
                let point = self.homogeneous([first[0] + k, first[1] + l]);
                for (i, j) in [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)] {
                    sums[i][j] = sums[i][j].mixed(1.0, a[i] * b[j], point);
                }
            }
        }
        let w = sums[0][0].w;
        // The quotient rule; too large numbers can only be derivatives.
        let over = |of: [usize; 2], rest: &[(f64, [usize; 2], Point<3>)]| -> Point<3> {
            let mut value = sums[of[0]][of[1]].p;
            for &(factor, [i, j], lower) in rest {
                value = std::array::from_fn(|d| value[d] - factor * sums[i][j].w * lower[d]);
            }
            value.map(|x| if (x / w).is_finite() { x / w } else { 0.0 })
        };
        let point = over([0, 0], &[]);
        let (u, v) = (over([1, 0], &[(1.0, [1, 0], point)]), over([0, 1], &[(1.0, [0, 1], point)]));
        Some(Derivatives {
            point,
            u,
            v,
            uu: over([2, 0], &[(2.0, [1, 0], u), (1.0, [2, 0], point)]),
            uv: over([1, 1], &[(1.0, [1, 0], v), (1.0, [0, 1], u), (1.0, [1, 1], point)]),
            vv: over([0, 2], &[(2.0, [0, 1], v), (1.0, [0, 2], point)]),
        })
    }

    /// Exactly, over clamped knots; `None` for a surface with a gap, and where control points would be too far away.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        self.clamped().ok()
    }
}
