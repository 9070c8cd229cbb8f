//! How long an interval may be.

use super::Space;
use super::dd::Dd;
use super::series::{Series, polynomial};
use std::f64::consts::PI;

/// Whether the functions of a space on an interval of this length look like a normalized B-basis. Below the critical
/// length they do; just above it they do not, but far above they may.
fn passes(space: &Space, h: f64) -> bool {
    let h = Dd::from(h);
    let radius = radius(space) * h.value();
    Series::new(&polynomial(space, h, false), radius).is_some_and(|series| series.passes())
}

/// The largest absolute value of a root.
pub(super) fn radius(space: &Space) -> f64 {
    space.roots().iter().fold(0.0, |most, root| most.max(root.re.value().hypot(root.im.value())))
}

/// Part of the critical length by which an interval must be shorter, because the search is not more accurate.
const MARGIN: f64 = 1e-13;

/// The critical length of equally spaced waves g, 2g, ..., ng, each of them once, with constants alone or with straight
/// lines. It is a zero of so high a multiplicity that a search would not find it.
///
/// A trigonometric polynomial of degree n has at most 2n zeros in [0, 2π), and (1 - cos x)^n has them all in one place.
/// Without a constant, [0, π) takes the place of [0, 2π).
fn of_equal_waves(space: &Space) -> Option<f64> {
    let (zero, others) = space.roots().split_first()?;
    let length = match zero.multiplicity {
        1 => PI,
        2 => 2.0 * PI,
        _ => return None,
    };
    let mut waves: Vec<f64> = others.iter().map(|root| root.im.value()).collect();
    waves.sort_by(f64::total_cmp);
    let slowest = *waves.first().filter(|&&wave| wave > 0.0)?;
    let equal = (1..).zip(&waves).all(|(k, wave)| {
        let expected = f64::from(k) * slowest;
        (wave - expected).abs() <= 4.0 * f64::EPSILON * expected
    });
    let simple = others.iter().all(|root| root.multiplicity == 1 && root.re.value() == 0.0);
    (equal && simple).then(|| length / slowest)
}

/// The search for the critical length for design of a space: the supremum l' of the lengths of intervals on which the
/// space has a normalized B-basis. Advances in steps, so that a program may draw between them.
///
/// It walks in steps of a fraction of the fastest wave until a length does not pass, and then bisects: a single test
/// far above the critical length can pass by chance, and determinants may touch zero without changing sign.
/// Relative error about 1e-14; where many zeros meet, as for equally spaced waves more than once, it is larger. Where the
/// length is known it is not searched for.
///
/// ```
/// use grafika::geometry::ec::{CriticalLength, Space};
///
/// let space: Space = "0,i".parse()?;
/// let length = CriticalLength::new(&space).finish();
/// assert!((length - std::f64::consts::PI).abs() < 1e-13);
/// # Ok::<(), grafika::geometry::ec::EcError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CriticalLength {
    space: Space,
    step: f64,
    /// Steps taken, all of which passed.
    taken: u32,
    most: u32,
    /// The longest length that passed, and the shortest that did not.
    good: f64,
    bad: Option<f64>,
    result: Option<f64>,
}

impl CriticalLength {
    /// The search for l' of a space. With real roots alone it is infinite and there is nothing to search.
    #[must_use]
    pub fn new(space: &Space) -> Self {
        let fastest = space.fastest();
        Self {
            space: space.clone(),
            step: PI / (4.0 * fastest),
            taken: 0,
            most: 4 * u32::try_from(space.dimension()).unwrap_or(u32::MAX / 4),
            good: 0.0,
            bad: None,
            result: if space.is_real() { Some(f64::INFINITY) } else { of_equal_waves(space) },
        }
    }

    /// The search for the length l up to which the space itself is an extended Chebyshev space: l' of the space with
    /// one zero root more.
    #[must_use]
    pub fn of_itself(space: &Space) -> Self {
        Self::new(&space.integral())
    }

    /// The result, if it is known.
    #[must_use]
    pub fn result(&self) -> Option<f64> {
        self.result
    }

    /// One step, which costs one set-up of a basis; the result as soon as it is known.
    pub fn advance(&mut self) -> Option<f64> {
        if self.result.is_some() {
            return self.result;
        }
        match self.bad {
            None => {
                let next = self.step * f64::from(self.taken + 1);
                if passes(&self.space, next) {
                    (self.taken, self.good) = (self.taken + 1, next);
                    if self.taken >= self.most {
                        // Beyond the bound n π / b of the theory nothing passes.
                        self.result = Some(self.good);
                    }
                } else {
                    self.bad = Some(next);
                }
            }
            Some(bad) => {
                let middle = 0.5 * (self.good + bad);
                if bad - self.good <= 1e-15 * bad || middle <= self.good || middle >= bad {
                    self.result = Some(middle);
                } else if passes(&self.space, middle) {
                    self.good = middle;
                } else {
                    self.bad = Some(middle);
                }
            }
        }
        self.result
    }

    /// Whether an interval of this length is good, as soon as it is known; the exact length need not be. It is not where
    /// it is shorter than the critical length by less than a part of 1e-13.
    #[must_use]
    pub fn admits(&self, length: f64) -> Option<bool> {
        let length = length * (1.0 + MARGIN);
        match self.result {
            Some(critical) => Some(length < critical),
            None if length <= self.good => Some(true),
            None if self.bad.is_some_and(|bad| length >= bad) => Some(false),
            None => None,
        }
    }

    /// The result, after all steps.
    #[must_use]
    pub fn finish(mut self) -> f64 {
        loop {
            if let Some(length) = self.advance() {
                return length;
            }
        }
    }

    /// Walks until it is known whether an interval of this length is good.
    pub(super) fn decide(&mut self, length: f64) -> bool {
        loop {
            if let Some(known) = self.admits(length) {
                return known;
            }
            // The bisection is not needed where the length itself can be tried.
            let length = length * (1.0 + MARGIN);
            if self.bad.is_some() || length < self.step * f64::from(self.taken + 1) {
                return passes(&self.space, length);
            }
            self.advance();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn critical(roots: &str) -> f64 {
        CriticalLength::new(&roots.parse().unwrap()).finish()
    }

    #[test]
    fn lengths_of_the_thesis() {
        for (roots, length) in [
            ("0,i", PI),
            ("0^2,i", 2.0 * PI),
            ("0^3,i", 2.0 * PI),
            ("0^4,i", 8.986_818_915_818_128),
            ("0,1/4+i", PI),
            ("0,i,2i", PI),
            ("0,i,2i,3i", PI),
            ("0,i,2i,3i,4i,5i", PI),
            ("0^3,i^2,2i", 2.0 * PI),
            ("0^4,i^3,2i^2,3i", 8.013_989_987_863_922),
            ("0,i^3,2i^3", 6.635_209_015_585_436),
            ("0,i^2", 4.493_409_457_909_064),
            ("0^2,i^2", 2.0 * PI),
            ("0,1+i^2,1+2i^2,2+i^2", 6.882_061_639_048_443),
            ("0,i,1/(6*pi),1/(3*pi),1/(6*pi)+i", 7.870_806_846_327_057),
            ("M4(1,0.2)", 16.694_941_067_198_363),
        ] {
            let found = critical(roots);
            assert!((found / length - 1.0).abs() < 1e-12, "{roots}: {found}");
        }
        assert_eq!(critical("0^2,1^2,2^2"), f64::INFINITY);
        // The lengths of the spaces themselves, which are zeros of higher multiplicity where less is asked.
        for (roots, length, error) in [
            ("0,i", 2.0 * PI, 1e-12),
            ("0^3,i", 8.986_818_915_818_128, 1e-12),
            ("0,1/4+i", 4.766_508_105_684_232, 1e-12),
            ("0,i,2i", 2.0 * PI, 1e-15),
            ("0,i,2i,3i", 2.0 * PI, 1e-15),
            ("T10", 2.0 * PI, 1e-15),
            ("0,2/3i,1/3i,i", 6.0 * PI, 1e-15),
            ("0^3,i^2,2i", 7.606_991_983_854_346, 1e-12),
            ("0,i^3,2i^3", 7.814_859_945_641_917, 1e-12),
            ("0,i^2", 2.0 * PI, 1e-12),
            ("0^2,i^2", 8.057_402_644_050_719, 1e-12),
            ("0,1+i^2,1+2i^2,2+i^2", 7.619_959_168_576_083, 1e-12),
            ("0,i,1/(6*pi),1/(3*pi),1/(6*pi)+i", 9.036_834_019_406_464, 1e-12),
        ] {
            let found = CriticalLength::of_itself(&roots.parse().unwrap()).finish();
            assert!((found / length - 1.0).abs() < error, "{roots}: {found}");
        }
    }

    #[test]
    fn a_length_that_is_critical_is_not_good() {
        for (roots, length) in
            [("0,i", PI), ("0,1/4+i", PI), ("0^2,i", 2.0 * PI), ("0^3,i", 2.0 * PI), ("T15", PI)]
        {
            let search = || CriticalLength::new(&roots.parse().unwrap());
            assert!(!search().decide(length), "{roots}");
            assert!(search().decide(length * (1.0 - 1e-12)), "{roots}");
            let mut found = search();
            while found.advance().is_none() {}
            assert_eq!(found.admits(length), Some(false), "{roots}");
        }
    }

    #[test]
    fn a_length_far_above_is_not_good_though_it_looks_so() {
        // {0^6, i} passes the single test from 1.36 to 1.56 of its critical length.
        let space: Space = "0^6,i".parse().unwrap();
        let length = 1.45 * critical("0^6,i");
        assert!(passes(&space, length));
        assert!(!CriticalLength::new(&space).decide(length));
        assert!(CriticalLength::new(&space).decide(0.7 * length / 1.45));
    }
}
