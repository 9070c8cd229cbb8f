//! One step of Gauss and Newton towards the foot of a point.

/// The metric of a surface at a place and the way to the point along its tangents.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tangents {
    /// `s_u s_u`, `s_u s_v`, `s_v s_v`.
    pub(super) metric: [f64; 3],
    /// `(p - s) s_u`, `(p - s) s_v`.
    pub(super) way: [f64; 2],
}

impl Tangents {
    /// The parameters where the tangent plane is nearest to the point, within 0 and 1 in directions that are not closed;
    /// where there is no plane, nearest along the longer tangent.
    #[inline]
    pub(super) fn target(&self, [u, v]: [f64; 2], closed: [bool; 2]) -> [f64; 2] {
        let ([a, b, c], [p, q]) = (self.metric, self.way);
        let determinant = a * c - b * b;
        if determinant <= 1e-12 * a * c {
            if a >= c && a > 0.0 {
                return [limited(u + p / a, closed[0]), v];
            }
            return [u, if c > 0.0 { limited(v + q / c, closed[1]) } else { v }];
        }
        let free = [u + (c * p - b * q) / determinant, v + (a * q - b * p) / determinant];
        let mut at = [limited(free[0], closed[0]), limited(free[1], closed[1])];
        // At a border the other parameter is the best one there.
        if at[0] != free[0] {
            at[1] = limited(v + (q - b * (at[0] - u)) / c, closed[1]);
        } else if at[1] != free[1] {
            at[0] = limited(u + (p - b * (at[1] - v)) / a, closed[0]);
        }
        at
    }
}

fn limited(u: f64, closed: bool) -> f64 {
    if closed { u } else { u.clamp(0.0, 1.0) }
}
