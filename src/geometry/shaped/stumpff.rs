//! Stumpff functions: sines, cosines and their hyperbolic counterparts with the singularity at 0 divided out, so that
//! one formula serves trigonometric, polynomial and hyperbolic curves.

/// Terms of the series below 1 in size: the last one is below 1e-26 of the first.
const TERMS: u32 = 12;

/// `cos s`, `s = sqrt z`; `cosh` of `sqrt -z` for negative `z`.
pub(super) fn c0(z: f64) -> f64 {
    if z < 0.0 { (-z).sqrt().cosh() } else { z.sqrt().cos() }
}

/// `sin s / s`.
pub(super) fn c1(z: f64) -> f64 {
    let s = z.abs().sqrt();
    if s == 0.0 {
        1.0
    } else if z < 0.0 {
        s.sinh() / s
    } else {
        s.sin() / s
    }
}

/// `(1 - cos s) / z`.
pub(super) fn c2(z: f64) -> f64 {
    if z.abs() < 1.0 {
        return series(z, 2, |_| 1.0);
    }
    let half = z.abs().sqrt() / 2.0;
    let root = if z < 0.0 { half.sinh() } else { half.sin() };
    2.0 * root * root / z.abs()
}

/// `(s - sin s) / s^3`.
pub(super) fn c3(z: f64) -> f64 {
    if z.abs() < 1.0 {
        return series(z, 3, |_| 1.0);
    }
    let s = z.abs().sqrt();
    let difference = if z < 0.0 { s.sinh() - s } else { s - s.sin() };
    difference / (s * s * s)
}

/// `c2 - c3 = (sin s - s cos s) / s^3`.
pub(super) fn c23(z: f64) -> f64 {
    if z.abs() < 1.0 {
        return series(z, 3, |j| f64::from(2 * j + 2));
    }
    let s = z.abs().sqrt();
    let difference = if z < 0.0 { s * s.cosh() - s.sinh() } else { s.sin() - s * s.cos() };
    difference / (s * s * s)
}

/// The sum of `factor(j) (-z)^j / (2 j + first)!`, smallest terms first.
fn series(z: f64, first: u32, factor: impl Fn(u32) -> f64) -> f64 {
    let mut terms = [0.0; TERMS as usize];
    let mut power = 1.0 / f64::from(if first == 2 { 2 } else { 6 });
    for (j, term) in (0..).zip(&mut terms) {
        *term = factor(j) * power;
        power *= -z / (f64::from(2 * j + first + 1) * f64::from(2 * j + first + 2));
    }
    terms.iter().rev().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_meet() {
        for function in [c0, c1, c2, c3, c23] {
            for z in [1.0_f64, -1.0] {
                let (inside, outside) = (function(z * (1.0 - 1e-15)), function(z));
                assert!((inside - outside).abs() < 2e-15, "{inside} {outside}");
            }
        }
        assert_eq!([c0(0.0), c1(0.0), c2(0.0), c3(0.0)], [1.0, 1.0, 0.5, 1.0 / 6.0]);
        assert!((c23(0.0) - 1.0 / 3.0).abs() < 1e-16);
    }

    #[test]
    fn the_recursion_holds() {
        // c(k) = 1/k! - z c(k + 2)
        for z in [-900.0, -30.0, -0.3, 1e-12, 0.7, 2.0, 9.8] {
            let size = c0(z).abs().max(1.0);
            assert!((c0(z) - (1.0 - z * c2(z))).abs() < 4e-15 * size, "{z}");
            assert!((c1(z) - (1.0 - z * c3(z))).abs() < 4e-15 * size, "{z}");
            assert!((c23(z) - (c2(z) - c3(z))).abs() < 4e-15 * size, "{z}");
        }
    }
}
