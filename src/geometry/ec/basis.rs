//! The normalized B-basis of a space on an interval, ready to blend control points.

use super::critical::{CriticalLength, radius};
use super::dd::{Dd, ONE};
use super::series::{SHORTEST, Series, polynomial};
use super::{EcError, Space};
use crate::geometry::{Basis, Chebyshev};

/// The limits of precision, each for the interval's length times a part of the roots.
const DECAY: f64 = 24.0;
const WAVES: f64 = 32.0;
const GROWTH: f64 = 48.0;
/// The largest difference of the two ways to the functions.
const PRECISION: f64 = 1e-11;
/// How many times larger the error may be than what a disturbance of the last digits does.
const DISTURBANCE: f64 = 16.0;
/// The derivatives that are kept.
const ORDERS: usize = 4;

/// The normalized B-basis b_0, …, b_n of a space on [start, end] (1.8 to 1.10): functions that sum to 1, none of them
/// negative, function i with i zeros at the start and n - i at the end.
///
/// Set up once in double-double arithmetic and evaluated as Chebyshev series. Errors of the values are about 1e-15, of
/// the k-th derivatives (by the parameter of the span) about 1e-15 of their largest value.
///
/// It is a [`Basis`] of one span: control points blended by it are curves ([`Blend`](crate::geometry::Blend)) and
/// surfaces ([`Weave`](crate::geometry::Weave)) like all others.
///
/// ```
/// use grafika::geometry::ec::EcBasis;
/// use grafika::geometry::{Blend, ParamCurve};
/// use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
///
/// // A quarter of the unit circle, exactly and without weights of its points.
/// let basis = EcBasis::new(&"0,i".parse()?, [0.0, FRAC_PI_2])?;
/// let quarter = Blend::new(&basis, vec![[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let [x, y] = quarter.eval(0, 0.5).expect("there is one span");
/// assert!((x - FRAC_PI_4.cos()).abs() < 1e-15 && (y - FRAC_PI_4.sin()).abs() < 1e-15);
/// # Ok::<(), grafika::geometry::ec::EcError>(())
/// ```
#[derive(Clone, Debug)]
pub struct EcBasis {
    space: Space,
    interval: [f64; 2],
    pub(super) h: Dd,
    /// Of the space with opposite roots, where that is more precise: b_i(s) is its function n - i at 1 - s.
    pub(super) series: Series,
    pub(super) mirrored: bool,
    /// The functions and their derivatives.
    tables: [Chebyshev; ORDERS],
    precision: f64,
}

impl EcBasis {
    /// The basis of a space on an interval, which must be shorter than the critical length l' of the space.
    ///
    /// # Errors
    /// [`EcError::Interval`], [`EcError::TooShort`], [`EcError::TooLong`] with l', and [`EcError::TooStiff`] or
    /// [`EcError::Imprecise`] where double-double arithmetic does not suffice.
    pub fn new(space: &Space, interval: [f64; 2]) -> Result<Self, EcError> {
        let length = check(space, interval)?;
        let mut search = CriticalLength::new(space);
        if !search.decide(length) {
            return Err(EcError::TooLong { length, critical: search.finish() });
        }
        // What the walk let pass has a basis.
        let imprecise = EcError::Imprecise { length, error: 1.0 };
        let basis = Self::formal(space, interval)?.ok_or(imprecise)?;
        match basis.is_precise() {
            true => Ok(basis),
            false => Err(EcError::Imprecise { length, error: basis.precision }),
        }
    }

    /// What the formulas give, however long the interval is: to be looked at, for beyond the critical length the
    /// functions may be negative, and above all they are no basis of the kind that [`EcBasis::new`] promises. `None`
    /// where the formulas divide by zero.
    ///
    /// # Errors
    /// An interval that is none, is too short, or too long for the precision.
    pub fn formal(space: &Space, interval: [f64; 2]) -> Result<Option<Self>, EcError> {
        check(space, interval)?;
        let h = Dd::difference(interval[1], interval[0]);
        let [growth, decay] = growth(space);
        // A decaying exponential cancels in a power series, a growing one does not.
        let mirrored = decay > growth;
        let radius = radius(space) * h.value();
        let [own, opposite] = [mirrored, !mirrored].map(|mirrored| polynomial(space, h, mirrored));
        let Some(series) = Series::new(&own, radius) else { return Ok(None) };
        let off = |other: Option<Series>, reversed| {
            other.map_or(f64::INFINITY, |other| difference(&series, &other, reversed))
        };
        // The other direction is another way to the same functions, but it may be the only one that is wrong.
        let mut precision = off(Series::new(&opposite, radius), true);
        if precision > PRECISION {
            precision = precision.min(DISTURBANCE * off(Series::disturbed(&own, radius), false));
        }
        let tables: [Chebyshev; ORDERS] = std::array::from_fn(|order| {
            let table = Chebyshev::new(series.chebyshev(order));
            let sign = if order % 2 == 1 { -1.0 } else { 1.0 };
            if mirrored { table.mirrored(sign) } else { table }
        });
        if !tables.iter().all(Chebyshev::is_finite) {
            return Ok(None);
        }
        Ok(Some(Self { space: space.clone(), interval, h, series, mirrored, tables, precision }))
    }

    /// The space.
    #[must_use]
    pub fn space(&self) -> &Space {
        &self.space
    }

    /// Start and end of the interval.
    #[must_use]
    pub fn interval(&self) -> [f64; 2] {
        self.interval
    }

    /// The length of the interval, by which a derivative by the parameter of the space is smaller than one by that of
    /// the span.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.h.value()
    }

    /// The measured error of the functions: the largest difference between two ways to them.
    #[must_use]
    pub fn precision(&self) -> f64 {
        self.precision
    }

    /// Whether the measured error is small enough for [`EcBasis::new`].
    #[must_use]
    pub fn is_precise(&self) -> bool {
        self.precision <= PRECISION
    }

    /// The values at `s` of the canonical basis: function k begins as s^k, and its other derivatives at the start up to
    /// order n vanish.
    #[must_use]
    pub fn canonical(&self, s: f64) -> Vec<f64> {
        let radius = radius(&self.space) * self.h.value();
        let rows = super::series::canonical(&polynomial(&self.space, self.h, false), radius);
        let s = Dd::from(crate::geometry::param::clipped(s));
        rows.iter().map(|row| row.iter().rev().fold(super::dd::ZERO, |sum, &c| sum * s + c).value()).collect()
    }

    /// Replaces `out` by the `order`-th derivatives of all functions at `s` in [0, 1], by `s`; order 3 at most, beyond
    /// it all are 0.
    pub fn derivatives(&self, order: usize, s: f64, out: &mut Vec<f64>) {
        let count = self.space.dimension();
        out.clear();
        out.resize(count, 0.0);
        let Some(functions) = self.tables.get(order) else { return };
        if order > 0 {
            return functions.values(s, out);
        }
        if let Some(at) = self.at_end(s) {
            out[at] = 1.0;
            return;
        }
        functions.values(s, out);
        // The sum is 1 but for the rounding of the series, which grows with the dimension.
        let factor = 1.0 / out.iter().sum::<f64>();
        out.iter_mut().for_each(|value| *value *= factor);
    }

    /// The function that is 1 at `s`, which is so at the two ends.
    fn at_end(&self, s: f64) -> Option<usize> {
        match crate::geometry::param::clipped(s) {
            0.0 => Some(0),
            1.0 => Some(self.space.dimension() - 1),
            _ => None,
        }
    }
}

/// The largest real part of a root, and the largest of an opposite root; 0 is among them.
fn growth(space: &Space) -> [f64; 2] {
    let parts = || space.roots().iter().map(|root| root.re.value());
    [parts().fold(0.0, f64::max), parts().map(|re| -re).fold(0.0, f64::max)]
}

/// The length of an interval, if precision allows it.
fn check(space: &Space, [start, end]: [f64; 2]) -> Result<f64, EcError> {
    let length = end - start;
    if start >= end || !length.is_finite() {
        return Err(EcError::Interval { start, end });
    }
    if length < SHORTEST {
        return Err(EcError::TooShort { length });
    }
    let [growth, decay] = growth(space);
    let limits = [(growth.min(decay), DECAY), (space.fastest(), WAVES), (growth.max(decay), GROWTH)];
    let most = limits.iter().map(|(part, limit)| limit / part).fold(f64::INFINITY, f64::min);
    if length > most { Err(EcError::TooStiff { length, most }) } else { Ok(length) }
}

/// How far the functions of two series differ; reversed, the second are those of the mirrored space.
fn difference(series: &Series, other: &Series, reversed: bool) -> f64 {
    let n = series.start.len() - 1;
    let mut worst = 0.0_f64;
    for s in [0.1, 0.25, 0.5, 0.75, 0.9].map(Dd::from) {
        for i in 0..=n {
            let (k, t) = if reversed { (n - i, ONE - s) } else { (i, s) };
            let off = (series.value(i, s) - other.value(k, t)).abs().value();
            // What is no number is wrong by any measure.
            worst = if off.is_finite() { worst.max(off) } else { f64::INFINITY };
        }
    }
    worst
}

impl Basis for EcBasis {
    fn points(&self) -> usize {
        self.space.dimension()
    }

    fn spans(&self) -> usize {
        1
    }

    fn closed(&self) -> bool {
        false
    }

    fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize> {
        if span > 0 {
            return None;
        }
        let mut values = Vec::new();
        out.clear();
        out.resize(self.points(), [0.0; 3]);
        for order in 0..3 {
            self.derivatives(order, u, &mut values);
            out.iter_mut().zip(&values).for_each(|(weights, &value)| weights[order] = value);
        }
        Some(0)
    }

    fn values(&self, span: usize, u: f64, out: &mut Vec<f64>) -> Option<usize> {
        if span > 0 {
            return None;
        }
        self.derivatives(0, u, out);
        Some(0)
    }

    fn chebyshev(&self, span: usize) -> Option<&Chebyshev> {
        self.tables.first().filter(|_| span == 0)
    }
}
