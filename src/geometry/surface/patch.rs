//! The bicubic Bézier patch: what every piecewise surface is made of.

use crate::geometry::{CubicBezier, Point, cross, dot};

/// A bicubic Bézier patch (3.24), parameters `u` and `v` in [0, 1]. Bézier point `p[r][c]` counts `r` in the
/// direction of `u`, `c` in that of `v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// The Bézier points.
    pub p: [[Point<3>; 4]; 4],
}

impl Patch {
    /// The curve of constant `u`, an arc in `v`.
    #[must_use]
    pub fn across(&self, u: f64) -> CubicBezier<3> {
        CubicBezier { p: std::array::from_fn(|c| self.column(c).eval(u)) }
    }

    /// The derivatives by `u` along the curve of constant `u`: a row of Bézier points in `v`.
    fn across_derivative(&self, u: f64) -> CubicBezier<3> {
        CubicBezier { p: std::array::from_fn(|c| self.column(c).derivative(u)) }
    }

    fn across_second(&self, u: f64) -> CubicBezier<3> {
        CubicBezier { p: std::array::from_fn(|c| self.column(c).second_derivative(u)) }
    }

    fn column(&self, c: usize) -> CubicBezier<3> {
        CubicBezier { p: std::array::from_fn(|r| self.p[r][c]) }
    }

    /// The point at (u, v); exactly the corners there.
    #[must_use]
    pub fn eval(&self, u: f64, v: f64) -> Point<3> {
        self.across(u).eval(v)
    }

    /// The derivatives at (u, v).
    #[must_use]
    pub fn derivatives(&self, u: f64, v: f64) -> Derivatives {
        let (row, by_u) = (self.across(u), self.across_derivative(u));
        Derivatives {
            point: row.eval(v),
            u: by_u.eval(v),
            v: row.derivative(v),
            uu: self.across_second(u).eval(v),
            uv: by_u.derivative(v),
            vv: row.second_derivative(v),
        }
    }

    /// The patch of a Hermite matrix (3.17): rows 0 and 1 are the borders u = 0 and u = 1, rows 2 and 3 their
    /// derivatives by `u`; columns the same for `v`, so that the last four are the twists.
    #[must_use]
    pub fn from_hermite(a: &[[Point<3>; 4]; 4]) -> Self {
        let along = |[start, end, from, to]: [Point<3>; 4]| CubicBezier::from_hermite(start, end, from, to).p;
        // Along u for each column, then along v for each of the four rows of results.
        let columns: [[Point<3>; 4]; 4] = std::array::from_fn(|c| along(std::array::from_fn(|r| a[r][c])));
        Self { p: std::array::from_fn(|r| along(columns.map(|column| column[r]))) }
    }
}

/// A point of a surface with its partial derivatives by the parameters of its patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives {
    /// The point.
    pub point: Point<3>,
    /// By u.
    pub u: Point<3>,
    /// By v.
    pub v: Point<3>,
    /// By u twice.
    pub uu: Point<3>,
    /// By u and v.
    pub uv: Point<3>,
    /// By v twice.
    pub vv: Point<3>,
}

impl Derivatives {
    /// The unit normal, in the direction of r_u x r_v; `None` where the two have no plane, as at a pole.
    #[must_use]
    pub fn normal(&self) -> Option<Point<3>> {
        let normal = cross(self.u, self.v);
        let length = dot(normal, normal).sqrt();
        let size = dot(self.u, self.u).sqrt() * dot(self.v, self.v).sqrt();
        (length.is_finite() && length > 1e-12 * size).then(|| normal.map(|x| x / length))
    }

    /// The Gaussian curvature (LN - M²)/(EG - F²); it does not depend on the parametrization. `None` where
    /// there is no normal.
    #[must_use]
    pub fn gaussian_curvature(&self) -> Option<f64> {
        let normal = self.normal()?;
        let second = dot(self.uu, normal) * dot(self.vv, normal) - dot(self.uv, normal).powi(2);
        let f = dot(self.u, self.v);
        let first = dot(self.u, self.u) * dot(self.v, self.v) - f * f;
        let curvature = second / first;
        curvature.is_finite().then_some(curvature)
    }

    /// The mean curvature (EN - 2FM + GL)/(2(EG - F²)), positive where the surface bends towards its normal. `None` where
    /// there is no normal.
    #[must_use]
    pub fn mean_curvature(&self) -> Option<f64> {
        let normal = self.normal()?;
        let [e, f, g] = [dot(self.u, self.u), dot(self.u, self.v), dot(self.v, self.v)];
        let [l, m, n] = [self.uu, self.uv, self.vv].map(|second| dot(second, normal));
        let curvature = (e * n - 2.0 * f * m + g * l) / (2.0 * (e * g - f * f));
        curvature.is_finite().then_some(curvature)
    }
}
