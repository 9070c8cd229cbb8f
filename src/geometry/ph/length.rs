//! Exact arc length and its inverse: the speed is a polynomial, and so is its integral.

use super::bernstein::{antiderivative, eval};
use crate::geometry::param::clipped;

/// The arc length of every span as a polynomial of its parameter, and the sums of them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Lengths {
    spans: Vec<SpanLength>,
    /// The length before every span, and the whole length at the end: one more than spans.
    sums: Vec<f64>,
}

impl Lengths {
    /// From the Bernstein coefficients of the speed of every span.
    pub(super) fn new<'a>(speeds: impl Iterator<Item = &'a [f64]>) -> Self {
        let spans: Vec<SpanLength> = speeds.map(SpanLength::new).collect();
        let mut sum = 0.0;
        let after = spans.iter().map(|span| {
            sum += span.total();
            sum
        });
        let sums = std::iter::once(0.0).chain(after).collect();
        Self { spans, sums }
    }

    /// The whole length.
    pub(super) fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The length of a span.
    pub(super) fn of_span(&self, span: usize) -> Option<f64> {
        self.spans.get(span).map(SpanLength::total)
    }

    /// The length from the beginning of the curve to a place.
    pub(super) fn at(&self, span: usize, u: f64) -> Option<f64> {
        Some(self.sums.get(span)? + self.spans.get(span)?.at(clipped(u)))
    }

    /// The place at the length `s` from the beginning, which is clipped to the curve. At joints the earlier span
    /// ends there.
    pub(super) fn place(&self, s: f64) -> Option<(usize, f64)> {
        let last = self.spans.len().checked_sub(1)?;
        let s = if s > 0.0 { s } else { 0.0 };
        // The first span whose end is not before s.
        let span = self.sums.get(1..)?.partition_point(|end| *end < s).min(last);
        Some((span, self.spans[span].inverse(s - self.sums[span])))
    }
}

/// The arc length of one span.
#[derive(Clone, Debug, PartialEq)]
struct SpanLength {
    speed: Vec<f64>,
    length: Vec<f64>,
}

impl SpanLength {
    fn new(speed: &[f64]) -> Self {
        Self { speed: speed.to_vec(), length: antiderivative(0.0, speed) }
    }

    fn total(&self) -> f64 {
        self.length.last().copied().unwrap_or(0.0)
    }

    fn at(&self, u: f64) -> f64 {
        eval(&self.length, u)
    }

    /// The parameter at the length `s`, clipped to the span: Newton's method within a bracket that every step
    /// narrows; a step that leaves it becomes a halving. It ends when the length is met to the last bits or no longer
    /// gets nearer.
    fn inverse(&self, s: f64) -> f64 {
        let total = self.total();
        // The comparisons also catch a length of zero.
        if !(s > 0.0 && total > 0.0) {
            return 0.0;
        }
        if s >= total {
            return 1.0;
        }
        let (mut low, mut high) = (0.0, 1.0);
        let mut u = s / total;
        let mut before = f64::INFINITY;
        for _ in 0..100 {
            let off = self.at(u) - s;
            if off < 0.0 {
                low = u;
            } else {
                high = u;
            }
            let still_far = off.abs() > 1e-13 * total || off.abs() < 0.5 * before;
            if off.abs() <= 2e-16 * total || !still_far {
                break;
            }
            before = off.abs();
            let mut next = u - off / eval(&self.speed, u);
            if !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            if (next - u).abs() < 1e-16 {
                break;
            }
            u = next;
        }
        u
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::arclen::integrate;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn inverse_meets_the_length(
            a in proptest::array::uniform5(0.0001..9.0_f64),
            b in proptest::array::uniform5(0.0..9.0_f64),
            share in 0.0..1.0,
        ) {
            let lengths = Lengths::new([&a[..], &b[..]].into_iter());
            let s = share * lengths.total();
            let (span, u) = lengths.place(s).unwrap();
            let got = lengths.at(span, u).unwrap();
            prop_assert!((got - s).abs() <= 1e-14 * lengths.total(), "{} {}", got, s);
            let measured = integrate(&|u| eval(&a, u), [0.0, 1.0], 1e-13);
            prop_assert!((lengths.of_span(0).unwrap() - measured).abs() < 1e-12);
        }
    }

    #[test]
    fn ends_zeros_and_odd_numbers() {
        let stop: &[f64] = &[0.0, 0.0, 1.0, 0.0, 0.0];
        let lengths = Lengths::new([stop, &[0.0; 5]].into_iter());
        assert_eq!(lengths.place(0.0), Some((0, 0.0)));
        assert_eq!(lengths.place(-5.0), Some((0, 0.0)));
        assert_eq!(lengths.place(f64::NAN), Some((0, 0.0)));
        assert_eq!(lengths.place(lengths.total()), Some((0, 1.0)));
        assert_eq!(lengths.place(1e9), Some((1, 0.0)));
        let (_, u) = lengths.place(0.5 * lengths.total()).unwrap();
        assert!((u - 0.5).abs() < 1e-15);
        assert_eq!(Lengths::new(std::iter::empty()).place(1.0), None);
    }
}
