//! The Bézier curve of high degree against exact integers and twofold doubles, to 2e-14 of the size
//! of the control polygon.

use grafika::geometry::{Closure, Curve, Method, ParamCurve, Point};

const SIZE: f64 = 560.0;

/// Whole coordinates without pattern.
fn polygon(n: usize) -> Vec<Point<3>> {
    let whole = |i: usize, factor: usize| (i * i * factor + 31 * i * factor % 97) % 561;
    (0..n).map(|i| [whole(i, 37) as f64, whole(i, 101) as f64, whole(i, 211) as f64]).collect()
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    (0..3).map(|d| (a[d] - b[d]).abs()).fold(0.0, f64::max)
}

/// C(n, k) exactly.
fn binomial(n: usize, k: usize) -> i128 {
    (0..k).fold(1, |c, i| c * (n - i) as i128 / (i as i128 + 1))
}

/// The Bézier sum at `u = numerator / 2^shift` in whole numbers; one rounding at the end.
fn exact_bezier(points: &[Point<3>], numerator: i128, shift: u32) -> Point<3> {
    let degree = points.len() - 1;
    let rest = (1_i128 << shift) - numerator;
    let power = |base: i128, exponent: usize| (0..exponent).fold(1_i128, |p, _| p * base);
    std::array::from_fn(|d| {
        let term = |k| binomial(degree, k) * power(numerator, k) * power(rest, degree - k);
        let sum: i128 = (0..=degree).map(|k| term(k) * points[k][d] as i128).sum();
        sum as f64 / 2_f64.powi((shift as usize * degree) as i32)
    })
}

#[test]
fn bezier_agrees_with_exact_integers() {
    for (n, shift) in [(2, 6), (3, 6), (4, 6), (10, 6), (20, 5), (30, 3), (38, 3), (55, 2), (99, 1)] {
        let points = polygon(n);
        let curve = Curve::through(Method::Bezier, Closure::Open, &points).unwrap();
        for numerator in 1..1_i128 << shift {
            let u = numerator as f64 / 2_f64.powi(shift as i32);
            let (got, want) = (curve.eval(0, u).unwrap(), exact_bezier(&points, numerator, shift));
            assert!(distance(got, want) < 1e-14 * SIZE, "n {n}, u {u}: {:e}", distance(got, want));
        }
    }
}

/// A sum of two doubles carrying about 32 digits.
#[derive(Clone, Copy)]
struct Twofold(f64, f64);

impl Twofold {
    fn plus(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        let part = sum - self.0;
        let error = (self.0 - (sum - part)) + (other.0 - part) + self.1 + other.1;
        Self(sum + error, error - ((sum + error) - sum))
    }

    fn times(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let error = self.0.mul_add(other.0, -product) + self.0 * other.1 + self.1 * other.0;
        Self(product + error, error - ((product + error) - product))
    }
}

/// De Casteljau's algorithm in twofold doubles.
fn twofold_bezier(points: &[Point<3>], u: f64) -> Point<3> {
    let rest = Twofold(1.0, 0.0).plus(Twofold(-u, 0.0));
    std::array::from_fn(|d| {
        let mut row: Vec<Twofold> = points.iter().map(|p| Twofold(p[d], 0.0)).collect();
        while row.len() > 1 {
            row = row.windows(2).map(|w| w[0].times(rest).plus(w[1].times(Twofold(u, 0.0)))).collect();
        }
        row[0].0
    })
}

#[test]
fn bezier_agrees_with_de_casteljau_in_twofold_doubles() {
    for n in [3, 9, 41, 99, 150] {
        let points = polygon(n);
        for closure in [Closure::Open, Closure::Closed] {
            let curve = Curve::through(Method::Bezier, closure, &points).unwrap();
            let mut controls = points.clone();
            if closure == Closure::Closed {
                controls.push(points[0]);
            }
            for u in [0.0, 1e-300, 1e-9, 0.01, 0.1, 0.3, 0.5, 0.77, 0.9, 0.99, 1.0 - 1e-9, 1.0] {
                let difference = distance(curve.eval(0, u).unwrap(), twofold_bezier(&controls, u));
                assert!(difference < 2e-14 * SIZE, "n {n}, u {u}: {difference:e}");
            }
            assert_eq!(curve.eval(0, 0.0), Some(controls[0]));
            assert_eq!(curve.eval(0, 1.0), controls.last().copied());
        }
    }
}

#[test]
fn gauss_like_polygon_does_not_underflow() {
    // 41 points of which the original drew the end of the curve at the origin.
    let points: Vec<Point<2>> = (0..41).map(|i| [f64::from(i) * 14.0, 380.0]).collect();
    let curve = Curve::through(Method::Bezier, Closure::Open, &points).unwrap();
    for j in 0..=100 {
        let [x, y] = curve.eval(0, f64::from(j) / 100.0).unwrap();
        assert!((x - 5.6 * f64::from(j)).abs() < 1e-12 * SIZE && (y - 380.0).abs() < 1e-12 * SIZE);
    }
}
