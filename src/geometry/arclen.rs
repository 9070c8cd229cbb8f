//! Arc length by adaptive Gauss-Legendre quadrature of the speed.

/// Positive nodes and their weights of the 16-point Gauss-Legendre rule on [-1, 1].
pub(super) const GAUSS: [(f64, f64); 8] = [
    (0.09501250983763744, 0.1894506104550685),
    (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254),
    (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388),
    (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.062253523938647894),
    (0.9894009349916499, 0.027152459411754096),
];

/// How often an interval is halved at most; a cusp's remaining share is then below rounding.
const DEPTH: u32 = 50;

/// The integral of `speed` from `a` to `b` with an absolute error of about `accuracy`: intervals
/// are halved until the rule on the whole and on its halves agree.
pub(super) fn integrate(speed: &impl Fn(f64) -> f64, [a, b]: [f64; 2], accuracy: f64) -> f64 {
    refine(speed, [a, b], gauss(speed, [a, b]), accuracy, DEPTH)
}

fn refine(speed: &impl Fn(f64) -> f64, [a, b]: [f64; 2], whole: f64, accuracy: f64, depth: u32) -> f64 {
    let middle = 0.5 * (a + b);
    let (left, right) = (gauss(speed, [a, middle]), gauss(speed, [middle, b]));
    if depth == 0 || (left + right - whole).abs() <= accuracy {
        return left + right;
    }
    let (half, less) = (0.5 * accuracy, depth - 1);
    refine(speed, [a, middle], left, half, less) + refine(speed, [middle, b], right, half, less)
}

/// The rule itself, exact to degree 31.
pub(super) fn gauss(speed: &impl Fn(f64) -> f64, [a, b]: [f64; 2]) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    half * GAUSS.iter().map(|&(x, w)| w * (speed(middle - half * x) + speed(middle + half * x))).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rule_is_exact_to_degree_31() {
        for degree in 0..32 {
            let got = gauss(&|u| f64::from(degree + 1) * u.powi(degree), [0.0, 1.0]);
            assert!((got - 1.0).abs() < 1e-14, "degree {degree}: {got}");
        }
        // And no further, so the check above can fail.
        let got = gauss(&|u| 33.0 * (2.0 * u - 1.0).powi(32), [0.0, 1.0]);
        assert!((got - 1.0).abs() > 1e-10);
    }

    #[test]
    fn kinks_are_integrated_too() {
        let got = integrate(&|u: f64| (u - 0.3).abs(), [0.0, 1.0], 1e-13);
        assert!((got - 0.29).abs() < 1e-13);
    }
}
