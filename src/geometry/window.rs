//! Methods whose spans see a window of at most four neighbouring control points.

use super::method::{Ends, Method};
use super::{CubicBezier, Point};

/// One span: Bernstein coefficient `c` is the sum of `rows[c][j]` times point `at[j]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    /// Numbers of the control points, all valid; a repeated one has its weights summed in one place.
    pub(super) at: [usize; 4],
    pub(super) rows: Rows,
}

/// Four Bernstein coefficients by four window points.
type Rows = [[f64; 4]; 4];

impl Window {
    /// The window of the points `first .. first + 4`, wrapped or held at the ends, with `rows`
    /// divided by `denominator`. Weights of one point are summed before the division, so that
    /// rows of one point only come out as exactly 1.
    fn new(first: isize, n: usize, ends: Ends, rows: &Rows, denominator: f64) -> Self {
        let at: [usize; 4] = std::array::from_fn(|j| place(first.saturating_add_unsigned(j), n, ends));
        let owner: [usize; 4] = std::array::from_fn(|j| at.iter().position(|&a| a == at[j]).unwrap_or(j));
        let mut folded = [[0.0; 4]; 4];
        for (sums, row) in folded.iter_mut().zip(rows) {
            for (&j, &weight) in owner.iter().zip(row) {
                sums[j] += weight;
            }
            for sum in sums {
                *sum /= denominator;
            }
        }
        Self { at, rows: folded }
    }

    /// The arc of the span, or `None` when the window reaches outside the points.
    pub(super) fn arc<const D: usize>(&self, points: &[Point<D>]) -> Option<CubicBezier<D>> {
        let [a, b, c, d] = self.at;
        let (a, b, c, d) = (points.get(a)?, points.get(b)?, points.get(c)?, points.get(d)?);
        let p = self.rows.map(|row| {
            std::array::from_fn(|i| row[0] * a[i] + row[1] * b[i] + row[2] * c[i] + row[3] * d[i])
        });
        Some(CubicBezier { p })
    }

    /// The first point of the window, and the Bernstein coefficients of its weight and of its followers', each point
    /// once.
    pub(super) fn functions(&self) -> (usize, Vec<[f64; 4]>) {
        let mut functions: Vec<(usize, [f64; 4])> = Vec::with_capacity(4);
        for (j, &at) in self.at.iter().enumerate() {
            let column = self.rows.map(|row| row[j]);
            // Ends are held, and few points come round: a point may be here twice.
            match functions.iter_mut().find(|(known, _)| *known == at) {
                Some((_, sums)) => sums.iter_mut().zip(column).for_each(|(sum, weight)| *sum += weight),
                None => functions.push((at, column)),
            }
        }
        (self.at[0], functions.into_iter().map(|(_, function)| function).collect())
    }

    /// The weights of one Bernstein coefficient, spread over all `n` control points.
    pub(super) fn row(&self, coefficient: usize, n: usize) -> Option<Vec<f64>> {
        let mut row = vec![0.0; n];
        for (&at, weight) in self.at.iter().zip(self.rows.get(coefficient)?) {
            *row.get_mut(at)? += weight;
        }
        Some(row)
    }
}

/// The number of the control point at a place that may lie beyond the ends; `n` is positive.
fn place(index: isize, n: usize, ends: Ends) -> usize {
    // n is at most MAX_POINTS, so both conversions keep the value.
    let n = n as isize;
    let inside = match ends {
        Ends::Closed => index.rem_euclid(n),
        Ends::Open | Ends::Doubled | Ends::Auxiliary => index.clamp(0, n - 1),
    };
    inside.unsigned_abs()
}

/// All spans of a window method for `n` points, or `None` when the method has no windows
/// (spline, Bézier). The number of points is checked by the caller.
pub(super) fn windows(method: Method, ends: Ends, n: usize) -> Option<Vec<Window>> {
    let (rows, denominator) = inner_rows(method)?;
    let (spans, offset) = layout(method, ends, n);
    let mut windows: Vec<Window> = (0..spans)
        .map(|span| Window::new(offset.saturating_add_unsigned(span), n, ends, &rows, denominator))
        .collect();
    match (method, ends) {
        (_, Ends::Open) => open_ends(method, &mut windows),
        (Method::BSpline2, Ends::Doubled) => straight_ends(&mut windows),
        _ => {}
    }
    Some(windows)
}

/// Bernstein rows of an inner span, as numerators and their common denominator.
fn inner_rows(method: Method) -> Option<(Rows, f64)> {
    Some(match method {
        // (2.13) with the tangents of (2.15), which is (3.61).
        Method::Coons { k0 } | Method::Local { k0 } => {
            let t = k0 / 3.0;
            ([[0.0, 1.0, 0.0, 0.0], [-t, 1.0, t, 0.0], [0.0, t, 1.0, -t], [0.0, 0.0, 1.0, 0.0]], 1.0)
        }
        // (2.57) raised to degree 3; the fourth point has no weight.
        Method::BSpline2 => {
            ([[3.0, 3.0, 0.0, 0.0], [1.0, 5.0, 0.0, 0.0], [0.0, 5.0, 1.0, 0.0], [0.0, 3.0, 3.0, 0.0]], 6.0)
        }
        // (2.58)
        Method::BSpline3 => {
            ([[1.0, 4.0, 1.0, 0.0], [0.0, 4.0, 2.0, 0.0], [0.0, 2.0, 4.0, 0.0], [0.0, 1.0, 4.0, 1.0]], 6.0)
        }
        Method::Beta { bias, tension } => beta_rows(bias, tension),
        Method::Bezier | Method::Arcs | Method::Spline => return None,
    })
}

/// (2.64) in Bernstein form; delta with the 1 that its print has lost.
fn beta_rows(b: f64, tension: f64) -> (Rows, f64) {
    let (b2, b3) = (b * b, b * b * b);
    let joint = 2.0 * b2 + 2.0 * b + tension;
    let rows = [
        [b3, joint, 1.0, 0.0],
        [0.0, b3 + 2.0 * b2 + b + tension, b + 1.0, 0.0],
        [0.0, b3 + b2, b2 + 2.0 * b + tension + 1.0, 0.0],
        [0.0, b3, joint, 1.0],
    ];
    (rows, b3 + joint + 1.0)
}

/// The number of spans, and which point the first window begins with.
fn layout(method: Method, ends: Ends, n: usize) -> (usize, isize) {
    match (method, ends) {
        (_, Ends::Closed) => (n, -1),
        (Method::BSpline2, Ends::Open | Ends::Auxiliary) => (n.saturating_sub(2), 0),
        (Method::BSpline2, Ends::Doubled) => (n, -1),
        (_, Ends::Auxiliary) => (n.saturating_sub(3), 0),
        (Method::BSpline3, Ends::Open) => (n.saturating_add(1), -2),
        (_, Ends::Open | Ends::Doubled) => (n.saturating_sub(1), -1),
    }
}

/// Puts the ends of open curves exactly into the first and last control point. For the beta-spline
/// the auxiliary points (2.65) enter no other coefficient than these two; for the quadratic
/// B-spline the inner coefficient beside them changes too, since the end spans are parabolas again.
fn open_ends(method: Method, windows: &mut [Window]) {
    match method {
        Method::Beta { .. } => {
            if let Some(first) = windows.first_mut() {
                // The points held at the beginning are folded into place 0.
                first.rows[0] = [1.0, 0.0, 0.0, 0.0];
            }
            if let Some(last) = windows.last_mut() {
                last.rows[3] = unit_of_last(last.at);
            }
        }
        Method::BSpline2 => {
            if let Some(first) = windows.first_mut() {
                first.rows[0] = [1.0, 0.0, 0.0, 0.0];
                first.rows[1] = [1.0 / 3.0, 2.0 / 3.0, 0.0, 0.0];
            }
            if let Some(last) = windows.last_mut() {
                last.rows[2] = [0.0, 2.0 / 3.0, 1.0 / 3.0, 0.0];
                last.rows[3] = [0.0, 0.0, 1.0, 0.0];
            }
        }
        Method::Coons { .. } | Method::Local { .. } | Method::BSpline3 => {}
        Method::Bezier | Method::Arcs | Method::Spline => {}
    }
}

/// The end spans of a quadratic B-spline with doubled ends are straight; in steps that keep the speed of the
/// spans beside them (3.32, 3.35) they are half a span long and run evenly. The middles are folded into
/// places 0 and 2 of the first window, whose points are 0, 0, 1, and into 0 and 1 of the last.
fn straight_ends(windows: &mut [Window]) {
    let (half, third, sixth) = (0.5, 2.0 / 3.0, 1.0 / 3.0);
    if let Some(first) = windows.first_mut() {
        // Points 0, 0, 1: the folded weights are in places 0 and 2.
        first.rows = [1.0, 1.0 - half * sixth, 1.0 - half * third, half].map(|w| [w, 0.0, 1.0 - w, 0.0]);
    }
    if let Some(last) = windows.last_mut() {
        // Points n-2, n-1, n-1: in places 0 and 1.
        last.rows = [half, half * third, half * sixth, 0.0].map(|w| [w, 1.0 - w, 0.0, 0.0]);
    }
}

/// Weight 1 for the last point of a window whose end is held.
fn unit_of_last(at: [usize; 4]) -> [f64; 4] {
    let place = at.iter().position(|&a| a == at[3]).unwrap_or(3);
    std::array::from_fn(|j| f64::from(u8::from(j == place)))
}
