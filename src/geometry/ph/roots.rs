//! Real roots in [0, 1] of a polynomial in Bernstein form, isolated by sign changes of its coefficients.
//!
//! The number of roots in (0, 1) is at most the number of sign changes, and differs from it by an even number
//! (Descartes' rule in Bernstein form). Without a change there is none, with one there is exactly one; else the
//! interval is halved.

use super::bernstein::{derivative, eval, size, split};

/// Pieces whose coefficients are below this share of the largest one are rounding errors of zero.
const ROUNDING: f64 = 1e-15;

/// Pieces shorter than this are not halved any more.
const SHORTEST: f64 = 1e-14;

/// Roots nearer than this are one.
const MERGED: f64 = 1e-12;

/// The two roots into which rounding splits a double one are no further apart than this.
const DOUBLE: f64 = 1e-6;

/// The roots in [0, 1] in ascending order, multiple ones once, to the accuracy that the coefficients have.
///
/// `scale` is the size of the terms that the coefficients were computed from: coefficients of at most 1e-14 of it
/// are rounding errors of zero, and a polynomial that is zero everywhere has no roots to report.
pub(super) fn roots(c: &[f64], scale: f64) -> Vec<f64> {
    let largest = size(c);
    if !largest.is_finite() || largest <= 1e-14 * scale || largest == 0.0 {
        return Vec::new();
    }
    // Coefficients near 1 neither overflow nor vanish when they are multiplied.
    let scaled: Vec<f64> = c.iter().map(|value| value / largest).collect();
    // Intervals that hold one root each; those at which nothing but rounding is left are wider than a point.
    let mut found: Vec<[f64; 2]> = Vec::new();
    let mut waiting: Vec<(Vec<f64>, [f64; 2])> = vec![(scaled.clone(), [0.0, 1.0])];
    while let Some((piece, [from, to])) = waiting.pop() {
        let piece = without_end_roots(piece, [from, to], &mut found);
        match changes(&piece) {
            0 => {}
            1 => {
                let root = from + crossing(&piece) * (to - from);
                found.push([root, root]);
            }
            _ if to - from < SHORTEST || size(&piece) <= ROUNDING => found.push([from, to]),
            _ => {
                let middle = 0.5 * (from + to);
                let [left, right] = split(&piece, 0.5);
                waiting.extend([(right, [middle, to]), (left, [from, middle])]);
            }
        }
    }
    found.sort_by(|a, b| a[0].total_cmp(&b[0]));
    // A double root that rounding has split in two: between them the polynomial is nothing but rounding.
    let same = |a: f64, b: f64| {
        b - a <= MERGED || (b - a <= DOUBLE && eval(&scaled, 0.5 * (a + b)).abs() <= ROUNDING)
    };
    let mut merged: Vec<[f64; 2]> = Vec::new();
    for interval in found {
        match merged.last_mut() {
            Some(last) if same(last[1], interval[0]) => last[1] = last[1].max(interval[1]),
            _ => merged.push(interval),
        }
    }
    merged.iter().map(|[from, to]| 0.5 * (from + to)).collect()
}

/// Divides by `u` and `1 - u` while the end coefficients are zero, and notes the roots there.
fn without_end_roots(mut piece: Vec<f64>, [from, to]: [f64; 2], found: &mut Vec<[f64; 2]>) -> Vec<f64> {
    while piece.len() > 1 && piece[0] == 0.0 {
        found.push([from, from]);
        let degree = (piece.len() - 1) as f64;
        piece = piece[1..].iter().enumerate().map(|(k, value)| value * degree / (k + 1) as f64).collect();
    }
    while piece.len() > 1 && piece.last() == Some(&0.0) {
        found.push([to, to]);
        let degree = piece.len() - 1;
        piece.truncate(degree);
        for (k, value) in piece.iter_mut().enumerate() {
            *value *= degree as f64 / (degree - k) as f64;
        }
    }
    piece
}

/// The number of sign changes; zeros do not count.
fn changes(c: &[f64]) -> usize {
    let mut before = 0.0;
    let mut count = 0;
    for &value in c.iter().filter(|value| **value != 0.0) {
        count += usize::from(before * value < 0.0);
        before = value.signum();
    }
    count
}

/// The only root in (0, 1) of a polynomial with end coefficients of opposite sign: Newton's method within a
/// bracket, which is halved where a step leaves it or gains too little.
fn crossing(c: &[f64]) -> f64 {
    let slope = derivative(c);
    let rising = c.first().is_some_and(|first| *first < 0.0);
    let (mut low, mut high) = (0.0, 1.0);
    let mut u = match c {
        [first, .., last] => first / (first - last),
        _ => 0.5,
    };
    let mut step = 1.0_f64;
    for _ in 0..100 {
        let value = eval(c, u);
        if value == 0.0 {
            return u;
        }
        if (value < 0.0) == rising {
            low = u;
        } else {
            high = u;
        }
        let mut next = u - value / eval(&slope, u);
        // The comparison also catches a slope of zero.
        if !(next > low && next < high) || (next - u).abs() > 0.5 * step.abs() {
            next = 0.5 * (low + high);
        }
        step = next - u;
        if step.abs() <= 1e-17 || next == u {
            return next;
        }
        u = next;
    }
    u
}

#[cfg(test)]
mod tests {
    use super::super::bernstein::product;
    use super::*;
    use proptest::prelude::*;

    /// The polynomial with these roots, times a quadratic without real roots.
    fn with_roots(roots: &[f64]) -> Vec<f64> {
        roots.iter().fold(vec![1.0, 0.2, 1.3], |c, root| product(&c, &[-root, 1.0 - root]))
    }

    fn distinct() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::btree_set(-30_i32..130, 0..7)
            .prop_map(|set| set.into_iter().map(|k| f64::from(k) / 100.0).collect())
    }

    proptest! {
        #[test]
        fn roots_are_found_where_they_were_put(places in distinct()) {
            let want: Vec<f64> = places.iter().copied().filter(|u| (0.0..=1.0).contains(u)).collect();
            let mut got = roots(&with_roots(&places), 1.0);
            // A root at an end may fall outside by a rounding error.
            let inner = |u: &f64| *u > 1e-6 && *u < 1.0 - 1e-6;
            got.retain(inner);
            let want: Vec<f64> = want.into_iter().filter(inner).collect();
            prop_assert_eq!(got.len(), want.len(), "{:?} {:?}", got, want);
            for (a, b) in got.iter().zip(&want) {
                prop_assert!((a - b).abs() < 1e-7, "{} {}", a, b);
            }
        }

        #[test]
        fn any_coefficients_end_quickly(c in proptest::collection::vec(-1.0..1.0, 1..12), zeros in 0_usize..4) {
            let mut c = c;
            for value in c.iter_mut().take(zeros) {
                *value = 0.0;
            }
            let found = roots(&c, 1.0);
            prop_assert!(found.len() < c.len().max(1));
            prop_assert!(found.iter().all(|u| (0.0..=1.0).contains(u) && eval(&c, *u).abs() < 1e-13));
            prop_assert!(found.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }

    #[test]
    fn multiple_roots_come_once() {
        for place in [0.3, 0.5, 0.7182] {
            let got = roots(&with_roots(&[place, place]), 1.0);
            assert!(got.len() <= 1, "{got:?}");
            assert!(got.iter().all(|u| (u - place).abs() < 1e-7));
            let got = roots(&with_roots(&[place, place, place]), 1.0);
            assert!(got.len() == 1 && (got[0] - place).abs() < 1e-4, "{got:?}");
        }
        // Exactly on the middle and on the ends.
        assert_eq!(roots(&with_roots(&[0.5, 0.5]), 1.0), [0.5]);
        assert_eq!(roots(&[0.0, 0.0, 1.0, 0.0], 1.0), [0.0, 1.0]);
    }

    #[test]
    fn rounding_errors_of_zero_have_no_roots() {
        assert!(roots(&[1e-15, -1e-15, 1e-15], 1.0).is_empty());
        assert!(roots(&[0.0; 5], 0.0).is_empty());
        assert!(roots(&[f64::NAN, 1.0], 1.0).is_empty());
        assert!(roots(&[], 1.0).is_empty());
        assert_eq!(roots(&[-1e-15, 1e-15], 1e-15), [0.5]);
        assert_eq!(roots(&[-1e200, 1e200], 1e200), [0.5]);
    }

    #[test]
    fn roots_far_below_the_other_terms_are_found_to_the_last_bit() {
        let got = roots(&[-1e-9, 1.0, 1.0, 1.0], 1.0);
        assert!((got[0] * 3.0 - 1e-9).abs() < 1e-17);
    }
}
