//! The exact rational form of patches and surfaces.

use super::PnSurface;
use super::bernstein::Tensor;
use super::net::Jacobian;
use super::patch::{tensors, wedge};
use crate::geometry::surface::indices;
use crate::geometry::{GeometryError, MAX_POINTS, ParamSurface, Patch, Point};

/// The degree of patches in both directions.
const DEGREE: usize = 11;
/// How often a strip of patches is halved at most until its weights are positive.
const HALVINGS: usize = 6;

/// A rational Bézier patch of degree (11, 11) by homogeneous points (xw, yw, zw, w).
#[derive(Clone, Debug, PartialEq)]
pub struct RationalPatch {
    /// x w, y w, z w and w.
    pub(super) parts: [Tensor; 4],
}

impl RationalPatch {
    /// The homogeneous points: row `k` counts in the direction of u, point `l` of it in that of v; 12 rows of
    /// 12. Weights are positive on the whole where the surface is regular, but single ones need not be.
    #[must_use]
    pub fn points(&self) -> Vec<Vec<[f64; 4]>> {
        let [m, n] = self.parts[0].degrees();
        let point = |k: usize, l: usize| std::array::from_fn(|d| self.parts[d].coefficient(k, l));
        (0..=m).map(|k| (0..=n).map(|l| point(k, l)).collect()).collect()
    }

    /// The degrees in u and v.
    #[must_use]
    pub fn degrees(&self) -> [usize; 2] {
        self.parts[0].degrees()
    }

    /// The point at parameters that are clipped to [0, 1]; `None` where it is not finite.
    #[must_use]
    pub fn eval(&self, u: f64, v: f64) -> Option<Point<3>> {
        homogeneous_point(self.parts.each_ref().map(|part| {
            let [_, after] = part.split(0, crate::geometry::param::clipped(u));
            after.split(1, crate::geometry::param::clipped(v))[1].coefficient(0, 0)
        }))
    }

    /// The parts before and after the middle of u (direction 0) or v.
    #[must_use]
    pub fn halves(&self, direction: usize) -> [Self; 2] {
        let halves = self.parts.each_ref().map(|part| part.split(direction, 0.5));
        [0, 1].map(|which| Self { parts: halves.each_ref().map(|pair| pair[which].clone()) })
    }

    /// Whether all weights are positive, as many programs need them.
    #[must_use]
    pub fn has_positive_weights(&self) -> bool {
        self.parts[3].coefficients().iter().all(|weight| *weight > 0.0)
    }
}

/// The point of homogeneous coordinates.
fn homogeneous_point([x, y, z, w]: [f64; 4]) -> Option<Point<3>> {
    let point = [x / w, y / w, z / w];
    point.iter().all(|c| c.is_finite()).then_some(point)
}

/// A surface as one rational B-spline surface of degree (11, 11) over clamped knots, by homogeneous control
/// points with positive weights. Neighbouring patches share the points of their border, so inner knots count as
/// often as the degree.
#[derive(Clone, Debug, PartialEq)]
pub struct RationalSurface {
    /// The degrees.
    pub degrees: [usize; 2],
    /// The different knots of u and v: span `i` goes from `i` to `i + 1`.
    pub knots: [Vec<f64>; 2],
    /// How often each knot is there; the first and the last once more than the degree.
    pub multiplicities: [Vec<usize>; 2],
    /// The control points (xw, yw, zw, w): rows count in the direction of u, points of them in that of v.
    pub net: Vec<Vec<[f64; 4]>>,
}

impl PnSurface {
    /// The rational form of a patch; `None` outside the spans.
    ///
    /// With J the Jacobian, A = r_u q_v - r_v q_u, B = p_u r_v - p_v r_u and rho = p² + q² the weight is
    /// w = J (1 + rho), and the numerators of the patch through the data are A (1 + rho) - p Z,
    /// B (1 + rho) - q Z and Z = 2 (p A + q B - r J). All four are negated where J is negative. Offsets have the
    /// same weights.
    #[must_use]
    pub fn rational_patch(&self, [i, j]: [usize; 2]) -> Option<RationalPatch> {
        if j >= self.size[1] {
            return None;
        }
        let (y, sign) = self.patches.get(i * self.size[1] + j)?;
        let sign = if *sign == Jacobian::Negative { -1.0 } else { 1.0 };
        let numerators = numerators(y, self.shift()).map(|part| part.scaled(sign));
        let place = |k: usize, l: usize| {
            let [x, y, z, w] = numerators.each_ref().map(|part| part.coefficient(k, l));
            (self.chart.point([x, y, z], w), w)
        };
        let part = |d: usize| {
            Tensor::from_fn([DEGREE; 2], |k, l| {
                let (point, w) = place(k, l);
                point.get(d).copied().unwrap_or(w)
            })
        };
        Some(RationalPatch { parts: std::array::from_fn(part) })
    }

    /// The surface as one rational B-spline surface. Strips of patches are halved until all weights are
    /// positive, which few surfaces need.
    ///
    /// # Errors
    /// [`GeometryError::NoPositiveWeights`] for a patch that stays without in 64 x 64 pieces,
    /// [`GeometryError::TooManyPoints`] for more than [`MAX_POINTS`] control points.
    pub fn to_rational(&self) -> Result<RationalSurface, GeometryError> {
        let spans = self.spans();
        // Of patches as they are; what halving adds is checked below.
        check_size(spans)?;
        let patches: Vec<RationalPatch> =
            indices(spans).filter_map(|spans| self.rational_patch(spans)).collect();
        let mut halvings = spans.map(|count| vec![0_usize; count]);
        for ([i, j], patch) in indices(spans).zip(&patches) {
            while !pieces(patch, [halvings[0][i], halvings[1][j]])
                .iter()
                .flatten()
                .all(RationalPatch::has_positive_weights)
            {
                if halvings[0][i].max(halvings[1][j]) >= HALVINGS {
                    return Err(GeometryError::NoPositiveWeights { patch: [i, j] });
                }
                halvings[0][i] += 1;
                halvings[1][j] += 1;
            }
        }
        let knots = halvings.each_ref().map(|strips| knots_of(strips));
        check_size(knots.each_ref().map(|knots| knots.len() - 1))?;
        let [rows, columns] = knots.each_ref().map(|knots| DEGREE * (knots.len() - 1) + 1);
        let mut net = vec![vec![[0.0; 4]; columns]; rows];
        let first = |strips: &[usize]| strips.iter().map(|halvings| DEGREE << halvings).sum::<usize>();
        // Backwards, so that the shared points are those of the lower patch.
        for (index, patch) in patches.iter().enumerate().rev() {
            let (i, j) = (index / spans[1], index % spans[1]);
            let (top, left) = (first(&halvings[0][..i]), first(&halvings[1][..j]));
            let rows_of_pieces = pieces(patch, [halvings[0][i], halvings[1][j]]);
            for (a, row) in rows_of_pieces.iter().enumerate().rev() {
                for (b, piece) in row.iter().enumerate().rev() {
                    for (k, points) in piece.points().into_iter().enumerate() {
                        for (l, point) in points.into_iter().enumerate() {
                            net[top + a * DEGREE + k][left + b * DEGREE + l] = point;
                        }
                    }
                }
            }
        }
        let multiplicities = knots.each_ref().map(|knots| {
            let last = knots.len() - 1;
            (0..=last).map(|k| if k == 0 || k == last { DEGREE + 1 } else { DEGREE }).collect()
        });
        Ok(RationalSurface { degrees: [DEGREE; 2], knots, multiplicities, net })
    }
}

impl RationalSurface {
    /// All knots of a direction, each as often as it counts.
    #[must_use]
    pub fn knot_vector(&self, direction: usize) -> Vec<f64> {
        let knots = self.knots.get(direction).into_iter().flatten();
        let counts = self.multiplicities.get(direction).into_iter().flatten();
        knots.zip(counts).flat_map(|(knot, count)| std::iter::repeat_n(*knot, *count)).collect()
    }
}

/// The check on the number of control points.
fn check_size([rows, columns]: [usize; 2]) -> Result<(), GeometryError> {
    let given = rows.saturating_mul(columns).saturating_mul(DEGREE * DEGREE);
    if given > MAX_POINTS { Err(GeometryError::TooManyPoints { given, most: MAX_POINTS }) } else { Ok(()) }
}

/// The knots of strips that are halved so often, a unit each.
fn knots_of(strips: &[usize]) -> Vec<f64> {
    let inner = strips.iter().enumerate().flat_map(|(strip, halvings)| {
        let pieces = 1_u32 << halvings;
        (1..=pieces).map(move |piece| strip as f64 + f64::from(piece) / f64::from(pieces))
    });
    std::iter::once(0.0).chain(inner).collect()
}

/// A patch halved so often in both directions: rows along u of pieces along v.
fn pieces(patch: &RationalPatch, [by_u, by_v]: [usize; 2]) -> Vec<Vec<RationalPatch>> {
    let halved = |pieces: Vec<RationalPatch>, direction: usize| {
        pieces.iter().flat_map(|piece| piece.halves(direction)).collect::<Vec<_>>()
    };
    let rows = (0..by_u).fold(vec![patch.clone()], |pieces, _| halved(pieces, 0));
    rows.into_iter().map(|row| (0..by_v).fold(vec![row], |pieces, _| halved(pieces, 1))).collect()
}

/// x w, y w, z w and w in the chart, points moved along the normals by `shift`; degrees (11, 11).
fn numerators(y: &Patch, shift: f64) -> [Tensor; 4] {
    let [p, q, r] = tensors(y);
    let (jacobian, a, b) = (wedge(&p, &q), wedge(&r, &q), wedge(&p, &r));
    let rho = p.times(&p).plus(&q.times(&q));
    let one = Tensor::constant(1.0);
    let (above, below) = (rho.plus(&one), rho.minus(&one));
    let z = p.times(&a).plus(&q.times(&b)).minus(&r.times(&jacobian)).scaled(2.0);
    let weight = jacobian.times(&above);
    let moved = |numerator: Tensor, normal: Tensor| numerator.plus(&normal.scaled(shift)).raised([DEGREE; 2]);
    [
        moved(a.times(&above).minus(&p.times(&z)), p.times(&jacobian).scaled(2.0)),
        moved(b.times(&above).minus(&q.times(&z)), q.times(&jacobian).scaled(2.0)),
        moved(z, jacobian.times(&below)),
        weight,
    ]
}

#[cfg(test)]
mod tests;
