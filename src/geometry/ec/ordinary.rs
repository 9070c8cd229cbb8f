//! The ordinary basis of a space: powers times exponentials times waves (1.3).

use super::dd::{Dd, ONE, ZERO};
use super::{Root, Space};

/// The Taylor coefficients of the ordinary functions at parameter `at`, `count` each: coefficient j is that of s^j where
/// the parameter is `at + h s`.
pub(super) fn taylor(space: &Space, at: f64, h: Dd, count: usize) -> Vec<Vec<Dd>> {
    space.roots().iter().flat_map(|root| taylor_of(root, at, h, count)).collect()
}

fn taylor_of(root: &Root, at: f64, h: Dd, count: usize) -> Vec<Vec<Dd>> {
    let [a, b] = [root.re.value(), root.im.value()];
    // e^(z (at + h s)) = e^(z at) times the sum of (z h s)^j / j!.
    let size = (Dd::from(a) * at).exp();
    let (sin, cos) = (Dd::from(b) * at).sin_cos();
    let z = [h * a, h * b];
    let mut wave = Vec::with_capacity(count);
    let mut term = [size * cos, size * sin];
    for j in 0..count {
        wave.push(term);
        let k = Dd::from((j + 1) as f64);
        term = [(term[0] * z[0] - term[1] * z[1]) / k, (term[0] * z[1] + term[1] * z[0]) / k];
    }
    let mut functions = Vec::new();
    for power in 0..root.multiplicity {
        if power > 0 {
            // Times (at + h s).
            for j in (0..count).rev() {
                let below = if j > 0 { wave[j - 1] } else { [ZERO; 2] };
                let here = wave[j];
                wave[j] = std::array::from_fn(|part| here[part] * at + below[part] * h);
            }
        }
        for part in 0..if b == 0.0 { 1 } else { 2 } {
            functions.push(wave.iter().map(|term| term[part]).collect());
        }
    }
    functions
}

impl Space {
    /// The `order`-th derivatives of the ordinary functions at `u`, in the order of the roots. What overflows is
    /// infinite.
    #[must_use]
    pub fn ordinary(&self, order: usize, u: f64) -> Vec<f64> {
        let factorial = (1..=order).fold(1.0, |product, k| product * k as f64);
        let coefficient = |row: Vec<Dd>| row.last().map_or(0.0, |c| (*c * factorial).value());
        taylor(self, u, ONE, order + 1).into_iter().map(coefficient).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_agree_with_closed_forms() {
        let space: Space = "0^3,2^2,1+3i^2".parse().unwrap();
        for u in [-1.3, 0.0, 0.4, 2.0_f64] {
            let values = space.ordinary(0, u);
            let (wave, waves) = (u.exp() * (3.0 * u).cos(), u.exp() * (3.0 * u).sin());
            let expected =
                [1.0, u, u * u, (2.0 * u).exp(), u * (2.0 * u).exp(), wave, waves, u * wave, u * waves];
            let slopes = space.ordinary(1, u);
            let (turn, turns) = (wave - 3.0 * waves, waves + 3.0 * wave);
            let grown = (2.0 * u).exp();
            let expected_slopes = [
                0.0,
                1.0,
                2.0 * u,
                2.0 * grown,
                grown + 2.0 * u * grown,
                turn,
                turns,
                wave + u * turn,
                waves + u * turns,
            ];
            for (found, expected) in values.iter().zip(expected).chain(slopes.iter().zip(expected_slopes)) {
                assert!((found - expected).abs() <= 1e-13 * (1.0 + expected.abs()), "{found} {expected}");
            }
        }
        assert_eq!("0^3,i".parse::<Space>().unwrap().ordinary(3, 0.0), [0.0, 0.0, 0.0, 0.0, -1.0]);
    }
}
