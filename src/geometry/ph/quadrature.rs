//! Integrals of smooth functions with peaks to nearly full accuracy.

use crate::geometry::arclen::gauss;

/// How often an interval is halved at most.
const DEPTH: u32 = 30;
/// How many halvings there are at most in all; peaks need some hundred.
const BUDGET: u32 = 4096;

/// The integral over `[from, to]`, to about 1e-13 of itself or to `small`, whichever is more: intervals are halved
/// until the 16-point Gauss rule on the whole and on its halves agree. `small` may be 0 where the function does not
/// change its sign.
pub(super) fn integral(f: &impl Fn(f64) -> f64, [from, to]: [f64; 2], small: f64) -> f64 {
    let whole = gauss(f, [from, to]);
    let small = small.max(1e-13 * whole.abs());
    let (mut sum, mut budget) = (0.0, BUDGET);
    let mut waiting = vec![([from, to], whole, DEPTH)];
    while let Some(([from, to], whole, depth)) = waiting.pop() {
        let middle = 0.5 * (from + to);
        let (left, right) = (gauss(f, [from, middle]), gauss(f, [middle, to]));
        let off = (left + right - whole).abs();
        // What is not a number is not refined either.
        if depth == 0 || budget == 0 || off.is_nan() || off <= small.max(1e-13 * (left + right).abs()) {
            sum += left + right;
        } else {
            budget -= 1;
            waiting.extend([([middle, to], right, depth - 1), ([from, middle], left, depth - 1)]);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_are_found_to_full_accuracy() {
        for width in [1.0, 1e-2, 1e-4, 1e-6] {
            let peak = |u: f64| 1.0 / ((u - 0.3).powi(2) + width * width);
            let want = ((0.7_f64 / width).atan() + (0.3_f64 / width).atan()) / width;
            let got = integral(&peak, [0.0, 1.0], 0.0);
            assert!((got / want - 1.0).abs() < 1e-13, "{width}: {got} {want}");
        }
        assert_eq!(integral(&|_| 0.0, [0.0, 1.0], 0.0), 0.0);
        assert!(integral(&|_| f64::INFINITY, [0.0, 1.0], 0.0).is_infinite());
    }

    #[test]
    fn noise_ends_too() {
        let noise = |u: f64| (u * 1e9).sin();
        assert!(integral(&noise, [0.0, 1.0], 0.0).abs() < 1.0);
    }
}
