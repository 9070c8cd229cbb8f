//! Numbers as text that reads back as the same double.

use std::fmt;

/// A double in the fewest digits that read back as the same bits, with an exponent for very large and very small
/// numbers. Keeps the sign of zero.
pub(super) struct Number(pub(super) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size != 0.0 && !(1e-7..1e17).contains(&size) && size.is_finite() {
            write!(f, "{:e}", self.0)
        } else {
            write!(f, "{}", self.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, -0.0, 1.0, 0.1, -2.5e-9, 1e150, 123456789.0, 1e-7].map(|x| Number(x).to_string());
        assert_eq!(texts, ["0", "-0", "1", "0.1", "-2.5e-9", "1e150", "123456789", "0.0000001"]);
    }

    proptest! {
        #[test]
        fn numbers_read_back(x in proptest::num::f64::ANY) {
            let back: f64 = Number(x).to_string().parse().unwrap();
            prop_assert!(back.to_bits() == x.to_bits() || x.is_nan() && back.is_nan());
        }
    }
}
