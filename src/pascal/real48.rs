//! Turbo Pascal's 6-byte `real`.
//!
//! Byte 0 is the exponent e (0 means the value 0, whatever follows), bytes 1..5 hold a 39-bit fraction f,
//! least significant byte first, with the sign in bit 7 of byte 5: `(-1)^sign (1 + f/2^39) 2^(e-129)`.
//! There are no infinities, no NaN and no subnormal numbers, so every pattern reads as a double exactly.

use std::fmt;

/// Bits of the stored fraction.
const FRACTION_BITS: u32 = 39;
/// Exponent byte of numbers in `1..2`.
const BIAS: i32 = 129;
/// Fraction bits of a double that a 6-byte real has no room for.
const DROPPED_BITS: u32 = 52 - FRACTION_BITS;

/// The smallest positive 6-byte real, 2^-128.
pub const MIN_POSITIVE: f64 = 1.0 / ((1u128 << 127) as f64) / 2.0;
/// The largest 6-byte real, (2 - 2^-39) 2^126.
pub const MAX: f64 = (((1u64 << 40) - 1) as f64) * ((1u128 << 87) as f64);

/// Why a double has no 6-byte real.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Real48Error {
    /// The value would round to 2^127 or more in magnitude.
    TooLarge(f64),
    /// The value is infinite or not a number.
    NotFinite(f64),
}

impl fmt::Display for Real48Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge(value) => write!(f, "{value:e} is too large; a 6-byte real ends at ±{MAX:.4e}"),
            Self::NotFinite(value) => write!(f, "{value} is not a finite number"),
        }
    }
}

impl std::error::Error for Real48Error {}

/// The value of six bytes; exact, and defined for every pattern.
#[must_use]
pub fn decode(bytes: [u8; 6]) -> f64 {
    let [exponent, b1, b2, b3, b4, b5] = bytes;
    if exponent == 0 {
        return 0.0;
    }
    let fraction = u64::from_le_bytes([b1, b2, b3, b4, b5 & 0x7f, 0, 0, 0]);
    let sign = u64::from(b5 >> 7);
    // 1..=255 - 129 lies well inside a double's normal exponents.
    let double_exponent = u64::from(exponent) + 1023 - 129;
    f64::from_bits((sign << 63) | (double_exponent << 52) | (fraction << DROPPED_BITS))
}

/// The nearest 6-byte real, ties to the even fraction.
///
/// Below 2^-128 the neighbours are 0 and 2^-128; the tie 2^-129 goes to 0. Zero is written as six zero
/// bytes, without a sign.
///
/// # Errors
/// [`Real48Error`] when the value is not finite or would round to 2^127 or more in magnitude.
pub fn encode(value: f64) -> Result<[u8; 6], Real48Error> {
    if !value.is_finite() {
        return Err(Real48Error::NotFinite(value));
    }
    let bits = value.abs().to_bits();
    let exponent = (bits >> 52) as i32 - 1023 + BIAS;
    if exponent < 0 || (exponent == 0 && bits & ((1 << 52) - 1) == 0) {
        return Ok([0; 6]);
    }
    // Between 2^-129 (exclusive) and 2^-128 the nearest is 2^-128, whatever the fraction.
    let (exponent, fraction) = if exponent == 0 { (1, 0) } else { rounded(exponent, bits) };
    let Ok(exponent) = u8::try_from(exponent) else {
        return Err(Real48Error::TooLarge(value));
    };
    let sign = if value < 0.0 { 0x80 } else { 0 };
    let [b1, b2, b3, b4, b5, ..] = fraction.to_le_bytes();
    Ok([exponent, b1, b2, b3, b4, b5 | sign])
}

/// Exponent and 39-bit fraction of a double's bits, rounded to nearest, ties to even.
fn rounded(exponent: i32, bits: u64) -> (i32, u64) {
    let mantissa = bits & ((1 << 52) - 1);
    let kept = mantissa >> DROPPED_BITS;
    let rest = mantissa & ((1 << DROPPED_BITS) - 1);
    let half = 1 << (DROPPED_BITS - 1);
    let up = rest > half || (rest == half && kept & 1 == 1);
    let fraction = kept + u64::from(up);
    if fraction >> FRACTION_BITS == 1 { (exponent + 1, 0) } else { (exponent, fraction) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// `value` as a whole number of 2^-220 units is too wide for 128 bits, so values are compared as
    /// (mantissa, exponent) pairs brought to the smaller exponent.
    fn parts(value: f64) -> (i128, i32) {
        let bits = value.abs().to_bits();
        let exponent = (bits >> 52) as i32;
        let mantissa = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if exponent == 0 { (mantissa, 1) } else { (mantissa | (1 << 52), exponent) };
        (i128::from(mantissa) * if value < 0.0 { -1 } else { 1 }, exponent - 1075)
    }

    /// |a - b| and |a - c| compared exactly; the three must lie within a factor of 2^60 of each other.
    fn compare_distance(a: f64, b: f64, c: f64) -> std::cmp::Ordering {
        let all = [parts(a), parts(b), parts(c)];
        let low = all.iter().filter(|p| p.0 != 0).map(|p| p.1).min().unwrap_or(0);
        let [a, b, c] = all.map(|(m, e)| if m == 0 { 0 } else { m << (e - low) });
        (a - b).abs().cmp(&(a - c).abs())
    }

    /// The neighbours of a positive 6-byte real by counting up and down the pattern.
    fn neighbours(bytes: [u8; 6]) -> [Option<f64>; 2] {
        let [e, rest @ ..] = bytes;
        let fraction = u64::from_le_bytes([rest[0], rest[1], rest[2], rest[3], rest[4] & 0x7f, 0, 0, 0]);
        let count = (u64::from(e) << 39) | fraction;
        [count.checked_sub(1), Some(count + 1)].map(|count| {
            let count = count?;
            let exponent = u8::try_from(count >> 39).ok()?;
            let f = count & ((1 << 39) - 1);
            let b = f.to_le_bytes();
            Some(decode([exponent, b[0], b[1], b[2], b[3], b[4]]))
        })
    }

    fn check_nearest(value: f64) {
        let bytes = encode(value).unwrap();
        let near = decode(bytes);
        for neighbour in neighbours(bytes).into_iter().flatten() {
            let neighbour = neighbour.copysign(if near == 0.0 { value } else { near });
            let order = compare_distance(value, near, neighbour);
            assert!(order.is_le(), "{value:e}: {neighbour:e} is nearer than {near:e}");
            if order.is_eq() && near != neighbour {
                assert_eq!(bytes[1] & 1, 0, "{value:e}: a tie goes to the even fraction");
            }
        }
    }

    #[test]
    fn known_patterns() {
        for (value, bytes) in [
            (0.0, [0, 0, 0, 0, 0, 0]),
            (0.5, [0x80, 0, 0, 0, 0, 0]),
            (1.0, [0x81, 0, 0, 0, 0, 0]),
            (-1.0, [0x81, 0, 0, 0, 0, 0x80]),
            (100.0, [0x87, 0, 0, 0, 0, 0x48]),
            (-13.0, [0x84, 0, 0, 0, 0, 0xd0]),
            (MIN_POSITIVE, [1, 0, 0, 0, 0, 0]),
            (MAX, [255, 255, 255, 255, 255, 0x7f]),
        ] {
            assert_eq!(encode(value), Ok(bytes), "{value}");
            assert_eq!(decode(bytes), value);
        }
        assert_eq!(decode([0, 1, 2, 3, 4, 0xff]), 0.0);
        assert_eq!(encode(-0.0), Ok([0; 6]));
    }

    #[test]
    fn the_ends_of_the_range() {
        let step = 2f64.powi(126 - 39);
        assert_eq!(encode(MAX + step * 0.499).map(decode), Ok(MAX));
        assert_eq!(encode(MAX + step * 0.5), Err(Real48Error::TooLarge(MAX + step * 0.5)));
        assert_eq!(encode(-1e300), Err(Real48Error::TooLarge(-1e300)));
        assert!(matches!(encode(f64::NAN), Err(Real48Error::NotFinite(_))));
        assert!(matches!(encode(f64::NEG_INFINITY), Err(Real48Error::NotFinite(_))));
        let half = MIN_POSITIVE / 2.0;
        assert_eq!(encode(half), Ok([0; 6]));
        assert_eq!(encode(half.next_up()).map(decode), Ok(MIN_POSITIVE));
        assert_eq!(encode(-half.next_up()).map(decode), Ok(-MIN_POSITIVE));
        assert_eq!(encode(MIN_POSITIVE.next_down()).map(decode), Ok(MIN_POSITIVE));
        assert_eq!(encode(f64::from_bits(1)), Ok([0; 6]));
    }

    #[test]
    fn every_exponent_sign_and_top_byte_comes_back() {
        for exponent in 1..=255 {
            for top in 0..=255 {
                for low in [[0, 0, 0, 0], [1, 0, 0, 0], [255; 4], [0x55, 0xaa, 0x33, 0xcc]] {
                    let bytes = [exponent, low[0], low[1], low[2], low[3], top];
                    assert_eq!(encode(decode(bytes)), Ok(bytes));
                }
            }
        }
    }

    #[test]
    fn every_tail_of_dropped_bits_rounds_to_the_nearest() {
        for fraction in [0u64, 1, 2, (1 << 39) - 2, (1 << 39) - 1] {
            for tail in 0..(1u64 << DROPPED_BITS) {
                check_nearest(f64::from_bits((1023 << 52) | (fraction << DROPPED_BITS) | tail));
            }
        }
    }

    proptest! {
        #[test]
        fn any_pattern_reads_and_comes_back(bytes: [u8; 6]) {
            let value = decode(bytes);
            prop_assert!(value.is_finite());
            let expected = if bytes[0] == 0 { [0; 6] } else { bytes };
            prop_assert_eq!(encode(value), Ok(expected));
        }

        #[test]
        fn any_double_in_range_goes_to_the_nearest(
            exponent in 1023u64 - 131..1023 + 127,
            mantissa in 0u64..1 << 52,
            negative: bool,
        ) {
            let value = f64::from_bits((u64::from(negative) << 63) | (exponent << 52) | mantissa);
            if encode(value).is_ok() {
                check_nearest(value);
            } else {
                prop_assert!(value.abs() > MAX);
            }
        }
    }
}
