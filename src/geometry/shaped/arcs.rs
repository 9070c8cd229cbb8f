//! Curves with shape parameters as Bézier arcs, where they are piecewise polynomial.

use super::curve::ShapedCurve;
use super::family::Family;
use super::lambda::LambdaKind;
use crate::geometry::{Basis, Point};

/// The highest degree of an arc.
const DEGREE: usize = 10;

/// Coefficients by powers of x.
type Powers = [f64; DEGREE + 1];

/// `10 x^3 - 15 x^4 + 6 x^5`.
const QUINTIC: Powers = [0.0, 0.0, 0.0, 10.0, -15.0, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// The uniform cubic B-spline, times 6.
const SPLINE: [[f64; 4]; 4] =
    [[1.0, -3.0, 3.0, -1.0], [4.0, 0.0, -6.0, 3.0], [1.0, 3.0, 3.0, -3.0], [0.0, 0.0, 0.0, 1.0]];

/// `(1 - x)^3 (1 + 3x)` and `x^3 (4 - 3x)`.
const HUMPS: [[f64; 5]; 2] = [[1.0, 0.0, -6.0, 8.0, -3.0], [0.0, 0.0, 0.0, 4.0, -3.0]];

fn padded(coefficients: &[f64]) -> Powers {
    std::array::from_fn(|i| coefficients.get(i).copied().unwrap_or(0.0))
}

fn plus(a: Powers, factor: f64, b: Powers) -> Powers {
    std::array::from_fn(|i| a[i] + factor * b[i])
}

/// The product, without what exceeds the degree.
fn times(a: Powers, b: Powers) -> Powers {
    std::array::from_fn(|n| (0..=n).map(|i| a[i] * b[n - i]).sum())
}

/// The Bernstein coefficients of so high a degree.
fn bernstein(powers: Powers, degree: usize) -> Vec<f64> {
    let binomial =
        |n: usize, k: usize| (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64);
    (0..=degree).map(|j| (0..=j).map(|i| binomial(j, i) / binomial(degree, i) * powers[i]).sum()).collect()
}

impl<const D: usize> ShapedCurve<D> {
    /// The spans as Bézier arcs, each by its control points: of degree 3 for `omega = 0`, 4 for Han's splines, 5 for
    /// alpha-B-splines, 10 for GB-splines with different lambdas. `None` for curves that are no polynomials.
    #[must_use]
    pub fn bezier_arcs(&self) -> Option<Vec<Vec<Point<D>>>> {
        let basis = self.basis();
        let degree = match basis.family() {
            Family::FBezier { omega } if *omega == 0.0 => return Some(vec![self.points().to_vec()]),
            Family::FBSpline { omega } if *omega == 0.0 => 3,
            Family::Lambda { kind: LambdaKind::Han, .. } => 4,
            Family::Lambda { kind: LambdaKind::Alpha, .. } => 5,
            Family::Lambda { kind: LambdaKind::Gb, .. } => DEGREE,
            _ => return None,
        };
        Some((0..basis.spans()).map(|span| self.arc(span, degree)).collect())
    }

    fn arc(&self, span: usize, degree: usize) -> Vec<Point<D>> {
        let spline = SPLINE.map(|s| padded(&s.map(|x| x / 6.0)));
        let mut own = spline;
        let mut line = [[0.0; DEGREE + 1]; 4];
        if let Family::Lambda { kind, lambda } = self.basis().family() {
            let [first, second] = [span + 1, span + 2].map(|index| lambda.of(index));
            if *kind == LambdaKind::Han {
                let humps = HUMPS.map(|hump| padded(&hump.map(|x| x / 24.0)));
                for (lambda, hump, at) in [(first, humps[0], 0), (second, humps[1], 1)] {
                    for (factor, i) in [(-1.0, at), (2.0, at + 1), (-1.0, at + 2)] {
                        own[i] = plus(own[i], factor * lambda, hump);
                    }
                }
            } else {
                let q = plus(padded(&[first]), second - first, QUINTIC);
                let one = padded(&[1.0]);
                own = spline.map(|s| times(plus(one, -1.0, q), s));
                line[1] = times(q, plus(one, -1.0, QUINTIC));
                line[2] = times(q, QUINTIC);
            }
        }
        let count = self.points().len();
        let place = |points: &[Point<D>], i: usize| points.get((span + i) % count.max(1)).copied();
        let blend = self.blend().unwrap_or(self.points());
        let mut arc = vec![[0.0; D]; degree + 1];
        for i in 0..4 {
            for (powers, points) in [(own[i], self.points()), (line[i], blend)] {
                let point = place(points, i).unwrap_or([0.0; D]);
                for (corner, share) in arc.iter_mut().zip(bernstein(powers, degree)) {
                    *corner = std::array::from_fn(|d| corner[d] + share * point[d]);
                }
            }
        }
        arc
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Lambdas, interpolate};
    use super::*;
    use crate::geometry::ParamCurve;
    use proptest::prelude::*;

    /// De Casteljau's algorithm.
    fn casteljau(mut points: Vec<Point<2>>, t: f64) -> Point<2> {
        while points.len() > 1 {
            points = points.windows(2).map(|p| [0, 1].map(|d| (1.0 - t) * p[0][d] + t * p[1][d])).collect();
        }
        points[0]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn arcs_are_the_curve(
            points in prop::collection::vec([-10.0..10.0f64, -10.0..10.0f64], 5..8),
            lambdas in prop::collection::vec(-3.0..4.0f64, 8),
            closed: bool,
            t in 0.0..=1.0f64,
        ) {
            let each = Lambdas::Each(lambdas[..points.len()].to_vec());
            let families = [
                Family::FBSpline { omega: 0.0 },
                Family::Lambda { kind: LambdaKind::Han, lambda: each.clone() },
                Family::Lambda { kind: LambdaKind::Alpha, lambda: Lambdas::One(lambdas[0]) },
                Family::Lambda { kind: LambdaKind::Gb, lambda: each },
            ];
            for family in families {
                let curve = ShapedCurve::new(family, points.clone(), closed).unwrap();
                let arcs = curve.bezier_arcs().unwrap();
                prop_assert_eq!(arcs.len(), curve.spans());
                for (span, arc) in arcs.into_iter().enumerate() {
                    let (expected, found) = (curve.eval(span, t).unwrap(), casteljau(arc, t));
                    let off = (expected[0] - found[0]).hypot(expected[1] - found[1]);
                    prop_assert!(off < 1e-11, "{off}");
                }
            }
        }
    }

    #[test]
    fn a_polygon_of_its_own_is_blended_in() {
        let data = [[0.0, 0.0], [3.0, 5.0], [7.0, 1.0], [9.0, 6.0]];
        let family = Family::Lambda { kind: LambdaKind::Alpha, lambda: Lambdas::One(0.5) };
        let curve = interpolate(&family, &data, false).unwrap().curve(family, false).unwrap();
        let arcs = curve.bezier_arcs().unwrap();
        for (span, arc) in arcs.into_iter().enumerate() {
            let [x, y] = casteljau(arc, 1.0);
            let [to_x, to_y] = data[span + 1];
            assert!((x - to_x).hypot(y - to_y) < 1e-12);
        }
    }
}
