//! Polynomials in two variables by their Bernstein coefficients on the unit square.

/// A polynomial of degrees m in u and n in v: coefficient (k, l) is at `k * (n + 1) + l`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tensor {
    degrees: [usize; 2],
    coefficients: Vec<f64>,
}

/// The number of ways to choose k of n things.
fn choose(n: usize, k: usize) -> f64 {
    (0..k.min(n)).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

impl Tensor {
    pub(super) fn from_fn(degrees: [usize; 2], coefficient: impl Fn(usize, usize) -> f64) -> Self {
        let indices = crate::geometry::surface::indices(degrees.map(|degree| degree + 1));
        Self { degrees, coefficients: indices.map(|[k, l]| coefficient(k, l)).collect() }
    }

    /// The same value everywhere.
    pub(super) fn constant(value: f64) -> Self {
        Self { degrees: [0, 0], coefficients: vec![value] }
    }

    pub(super) fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    pub(super) fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    pub(super) fn coefficient(&self, k: usize, l: usize) -> f64 {
        self.coefficients.get(k * (self.degrees[1] + 1) + l).copied().unwrap_or(0.0)
    }

    /// The product: coefficients weighted with binomials are convolved in both directions.
    pub(super) fn times(&self, other: &Self) -> Self {
        let ([a, b], [c, d]) = (self.degrees, other.degrees);
        let weights = |m: usize, n: usize| -> Vec<Vec<f64>> {
            let weight = |i: usize, j: usize| choose(m, i) * choose(n, j) / choose(m + n, i + j);
            (0..=m).map(|i| (0..=n).map(|j| weight(i, j)).collect()).collect()
        };
        let (by_u, by_v) = (weights(a, c), weights(b, d));
        let mut product = Self::from_fn([a + c, b + d], |_, _| 0.0);
        for (i, row) in by_u.iter().enumerate() {
            for (k, by_u) in row.iter().enumerate() {
                for (j, row) in by_v.iter().enumerate() {
                    for (l, by_v) in row.iter().enumerate() {
                        let place = (i + k) * (b + d + 1) + j + l;
                        if let Some(sum) = product.coefficients.get_mut(place) {
                            *sum += by_u * by_v * self.coefficient(i, j) * other.coefficient(k, l);
                        }
                    }
                }
            }
        }
        product
    }

    /// The sum; the lower degrees are raised to the higher ones.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let degrees = [0, 1].map(|d| self.degrees[d].max(other.degrees[d]));
        let (a, b) = (self.raised(degrees), other.raised(degrees));
        Self::from_fn(degrees, |k, l| a.coefficient(k, l) + b.coefficient(k, l))
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self { coefficients: self.coefficients.iter().map(|c| factor * c).collect(), ..*self }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(-1.0))
    }

    /// The same polynomial with degrees that are at least as high.
    pub(super) fn raised(&self, degrees: [usize; 2]) -> Self {
        let by = [0, 1].map(|d| degrees[d].saturating_sub(self.degrees[d]));
        if by == [0, 0] { self.clone() } else { self.times(&Self::from_fn(by, |_, _| 1.0)) }
    }

    /// The partial derivative by u (direction 0) or v.
    pub(super) fn derivative(&self, direction: usize) -> Self {
        let [m, n] = self.degrees;
        if direction == 0 {
            let leg = |k: usize, l: usize| self.coefficient(k + 1, l) - self.coefficient(k, l);
            Self::from_fn([m.saturating_sub(1), n], |k, l| if m == 0 { 0.0 } else { m as f64 * leg(k, l) })
        } else {
            let leg = |k: usize, l: usize| self.coefficient(k, l + 1) - self.coefficient(k, l);
            Self::from_fn([m, n.saturating_sub(1)], |k, l| if n == 0 { 0.0 } else { n as f64 * leg(k, l) })
        }
    }

    /// The parts before and after the parameter `t` of a direction, by de Casteljau's algorithm.
    pub(super) fn split(&self, direction: usize, t: f64) -> [Self; 2] {
        let [m, n] = self.degrees;
        let (mut left, mut right) = (self.clone(), self.clone());
        let (degree, lines) = if direction == 0 { (m, n) } else { (n, m) };
        let place = |k: usize, line: usize| match direction {
            0 => k * (n + 1) + line,
            _ => line * (n + 1) + k,
        };
        for line in 0..=lines {
            let mut row: Vec<f64> = (0..=degree).map(|k| self.coefficients[place(k, line)]).collect();
            for k in 0..=degree {
                left.coefficients[place(k, line)] = row[0];
                right.coefficients[place(degree - k, line)] = row[degree - k];
                for i in 0..degree - k {
                    row[i] = (1.0 - t) * row[i] + t * row[i + 1];
                }
            }
        }
        [left, right]
    }

    /// The value with the derivatives by u, v, uu, uv and vv.
    pub(super) fn jet(&self, u: f64, v: f64) -> [f64; 6] {
        let [m, n] = self.degrees;
        let rows = (0..=m).map(|k| line_jet((0..=n).map(|l| self.coefficient(k, l)).collect(), v));
        let rows: Vec<[f64; 3]> = rows.collect();
        let [[value, by_u, by_uu], [by_v, by_uv, _], [by_vv, ..]] =
            std::array::from_fn(|order| line_jet(rows.iter().map(|row| row[order]).collect(), u));
        [value, by_u, by_v, by_uu, by_uv, by_vv]
    }

    /// The four quarters, by u, then by v.
    pub(super) fn quarters(&self) -> [Self; 4] {
        let [before, after] = self.split(0, 0.5);
        let ([a, b], [c, d]) = (before.split(1, 0.5), after.split(1, 0.5));
        [a, b, c, d]
    }

    /// The smallest and the largest coefficient, between which the values on the square lie.
    pub(super) fn range(&self) -> [f64; 2] {
        let range = |[low, high]: [f64; 2], c: &f64| [low.min(*c), high.max(*c)];
        self.coefficients.iter().fold([f64::INFINITY, f64::NEG_INFINITY], range)
    }

    /// The values at the corners.
    pub(super) fn corners(&self) -> [f64; 4] {
        let [m, n] = self.degrees;
        [[0, 0], [0, n], [m, 0], [m, n]].map(|[k, l]| self.coefficient(k, l))
    }
}

/// The value, the first and the second derivative of a polynomial by its Bernstein coefficients, by de Casteljau's
/// algorithm.
fn line_jet(mut row: Vec<f64>, t: f64) -> [f64; 3] {
    let degree = row.len().saturating_sub(1);
    let mut jet = [0.0; 3];
    for left in (0..=degree).rev() {
        match (left, row.as_slice()) {
            (2, [a, b, c, ..]) => jet[2] = (degree * (degree - 1)) as f64 * (c - 2.0 * b + a),
            (1, [a, b, ..]) => jet[1] = degree as f64 * (b - a),
            (0, [a, ..]) => jet[0] = *a,
            _ => {}
        }
        for i in 0..left {
            row[i] = (1.0 - t) * row[i] + t * row[i + 1];
        }
    }
    jet
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// By the definition of the Bernstein polynomials.
    fn value(tensor: &Tensor, u: f64, v: f64) -> f64 {
        let [m, n] = tensor.degrees;
        let basis =
            |n: usize, k: usize, t: f64| choose(n, k) * t.powi(k as i32) * (1.0 - t).powi((n - k) as i32);
        let indices = crate::geometry::surface::indices([m + 1, n + 1]);
        indices.map(|[k, l]| tensor.coefficient(k, l) * basis(m, k, u) * basis(n, l, v)).sum()
    }

    fn tensor() -> impl Strategy<Value = Tensor> {
        (0_usize..5, 0_usize..5).prop_flat_map(|(m, n)| {
            let coefficients = prop::collection::vec(-10.0..10.0_f64, (m + 1) * (n + 1));
            coefficients.prop_map(move |coefficients| Tensor { degrees: [m, n], coefficients })
        })
    }

    proptest! {
        #[test]
        fn operations_are_those_of_the_values(a in tensor(), b in tensor(), u in 0.0..1.0_f64, v in 0.0..1.0_f64) {
            let (at_a, at_b) = (value(&a, u, v), value(&b, u, v));
            prop_assert!((value(&a.times(&b), u, v) - at_a * at_b).abs() < 1e-12);
            prop_assert!((value(&a.plus(&b), u, v) - at_a - at_b).abs() < 1e-13);
            prop_assert!((value(&a.minus(&b), u, v) - at_a + at_b).abs() < 1e-13);
            let h = 1e-5;
            let (by_u, by_v) = (value(&a, u + h, v) - value(&a, u - h, v), value(&a, u, v + h) - value(&a, u, v - h));
            let jet = a.jet(u, v);
            let by = [a.derivative(0), a.derivative(1)];
            let seconds = [by[0].derivative(0), by[0].derivative(1), by[1].derivative(1)];
            for (jet, tensor) in jet.iter().zip([a.clone()].iter().chain(&by).chain(&seconds)) {
                prop_assert!((jet - value(tensor, u, v)).abs() < 1e-11);
            }
            prop_assert!((value(&a.derivative(0), u, v) - by_u / (2.0 * h)).abs() < 1e-6);
            prop_assert!((value(&a.derivative(1), u, v) - by_v / (2.0 * h)).abs() < 1e-6);
        }

        #[test]
        fn parts_have_the_values_of_the_whole(a in tensor(), u in 0.0..1.0_f64, v in 0.0..1.0_f64) {
            for (index, quarter) in a.quarters().iter().enumerate() {
                let (s, t) = (0.5 * (u + (index / 2) as f64), 0.5 * (v + (index % 2) as f64));
                prop_assert!((value(quarter, u, v) - value(&a, s, t)).abs() < 1e-13);
            }
            let [low, high] = a.range();
            prop_assert!((low..=high).contains(&value(&a, u, v)) || high - low < 1e-12);
            let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|[u, v]| value(&a, u, v));
            prop_assert_eq!(a.corners(), corners);
        }
    }
}
