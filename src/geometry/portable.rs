//! Exponential function and logarithm of nothing but IEEE arithmetic: those of the standard library differ in their
//! last bits from system to system, and what is learnt from a seed shall be the same on all.

use std::f64::consts::{LN_2, LOG2_E, SQRT_2};

/// The upper bits of ln 2, so that small multiples are exact, and the rest.
const LN_2_PARTS: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
/// Added to a number below 2^51, it leaves the nearest whole number in the lowest bits.
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;
/// Coefficients of the power series, 1/13! first.
const SERIES: [f64; 13] = {
    let mut series = [1.0; 13];
    let (mut k, mut factor) = (0, 1.0);
    while k < 13 {
        factor *= (k + 1) as f64;
        series[12 - k] = 1.0 / factor;
        k += 1;
    }
    series
};

/// The exponential function within 2e-16 of itself; arguments are clipped to [-700, 700]. There is no branch in it, so
/// that a loop over it becomes one of vectors.
pub(super) fn exp(x: f64) -> f64 {
    let x = x.clamp(-700.0, 700.0);
    let shifted = x * LOG2_E + TO_WHOLE;
    let whole = shifted - TO_WHOLE;
    let rest = (x - whole * LN_2_PARTS[0]) - whole * LN_2_PARTS[1];
    let series = SERIES.iter().fold(0.0, |sum, factor| (sum + factor) * rest);
    (1.0 + series) * f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52)
}

/// The natural logarithm of a positive number that is not below 1e-300, within 4e-16 or as much of itself.
pub(super) fn ln(x: f64) -> f64 {
    let bits = x.to_bits();
    let mut exponent = (bits >> 52) as i32 - 1023;
    let mut mantissa = f64::from_bits(bits & 0x000F_FFFF_FFFF_FFFF | 0x3FF0_0000_0000_0000);
    if mantissa > SQRT_2 {
        mantissa *= 0.5;
        exponent += 1;
    }
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    // 2 artanh s, where |s| is at most 0.172.
    let series = (0..12).rev().fold(0.0, |sum, k| sum * s * s + 2.0 / f64::from(2 * k + 1));
    f64::from(exponent) * LN_2 + s * series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_agree_with_the_standard_library() {
        for k in -70_000..=70_000 {
            let x = f64::from(k) * 0.01;
            assert!((exp(x) / x.exp() - 1.0).abs() < 4e-16, "exp({x})");
            let y = x.exp();
            assert!((ln(y) - y.ln()).abs() <= 5e-16 * x.abs().max(1.0), "ln({y})");
        }
        assert_eq!((exp(0.0), ln(1.0)), (1.0, 0.0));
        assert!(exp(-1e300) > 0.0 && exp(-1e300) < 1e-300 && exp(1e300).is_finite());
    }
}
