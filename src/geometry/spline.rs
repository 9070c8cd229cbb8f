//! The interpolating cubic spline: tangents from one linear system, then Hermite arcs.
//!
//! Unlike the window methods every span depends on every control point, so instead of a full
//! matrix this keeps the factored system: applying it costs a few operations per point.

use super::cyclic::Cyclic;
use super::hermite::arcs_through;
use super::method::Closure;
use super::point::scaled_difference;
use super::tridiagonal::Tridiagonal;
use super::{CubicBezier, Point};

/// The system `m[i-1] + 4 m[i] + m[i+1] = 3 (p[i+1] - p[i-1])` for the tangents `m`: equations
/// (2.30) and (2.39) written for first instead of second derivatives. Natural ends (2.24) give
/// `2 m[0] + m[1] = 3 (p[1] - p[0])` and its mirror image.
#[derive(Clone, Debug)]
pub(super) struct Spline {
    points: usize,
    system: System,
}

#[derive(Clone, Debug)]
enum System {
    Natural(Tridiagonal),
    Periodic(Cyclic),
}

impl Spline {
    /// The open spline with natural ends through `n` points, at least 2.
    pub(super) fn natural(n: usize) -> Self {
        let diagonal = |i| if i == 0 || i + 1 == n { 2.0 } else { 4.0 };
        Self { points: n, system: System::Natural(Tridiagonal::new((0..n).map(diagonal))) }
    }

    /// The closed, periodic spline through `n` points, at least 3.
    pub(super) fn periodic(n: usize) -> Self {
        Self { points: n, system: System::Periodic(Cyclic::new(n)) }
    }

    pub(super) fn spans(&self) -> usize {
        match self.system {
            System::Natural(_) => self.points.saturating_sub(1),
            System::Periodic(_) => self.points,
        }
    }

    /// One arc per span, from control point to control point exactly.
    pub(super) fn arcs<const D: usize>(&self, points: &[Point<D>]) -> Vec<CubicBezier<D>> {
        let mut tangents = self.outer(points, 1.0);
        self.solve(&mut tangents);
        let closure = match self.system {
            System::Natural(_) => Closure::Open,
            System::Periodic(_) => Closure::Closed,
        };
        arcs_through(closure, points, &tangents)
    }

    /// The weights of Bernstein coefficient `coefficient` (0 to 3) of a span, one per point.
    ///
    /// The system is symmetric, so a row of its inverse is the solution for a unit right-hand
    /// side; the transposed right-hand side of the tangents then acts on that row.
    pub(super) fn row(&self, span: usize, coefficient: usize) -> Vec<f64> {
        let next = if span + 1 < self.points { span + 1 } else { 0 };
        let (at, third) = match coefficient {
            0 => (span, 0.0),
            1 => (span, 1.0 / 3.0),
            2 => (next, -1.0 / 3.0),
            _ => (next, 0.0),
        };
        let unit: Vec<Point<1>> = (0..self.points).map(|i| [f64::from(u8::from(i == at))]).collect();
        let mut inverse = unit.clone();
        self.solve(&mut inverse);
        let transposed = self.outer(&inverse, -1.0);
        unit.iter().zip(&transposed).map(|([one], [x])| one - third * x).collect()
    }

    /// Three times the difference of each entry's neighbours. Beyond open ends lies `held` times
    /// the end entry: 1 gives the right-hand side of the tangents, and -1 the transposed of that
    /// map with opposite sign.
    fn outer<const D: usize>(&self, entries: &[Point<D>], held: f64) -> Vec<Point<D>> {
        let (Some(&first), Some(&last)) = (entries.first(), entries.last()) else {
            return Vec::new();
        };
        let (mut before, after) = match self.system {
            System::Natural(_) => (first.map(|x| held * x), last.map(|x| held * x)),
            System::Periodic(_) => (last, first),
        };
        let nexts = entries.iter().skip(1).chain(std::iter::once(&after));
        let difference = |(&entry, &next): (&Point<D>, &Point<D>)| {
            let difference = scaled_difference(3.0, before, next);
            before = entry;
            difference
        };
        entries.iter().zip(nexts).map(difference).collect()
    }

    fn solve<const D: usize>(&self, rhs: &mut [Point<D>]) {
        match &self.system {
            System::Natural(system) => system.solve(rhs),
            System::Periodic(system) => system.solve(rhs),
        }
    }
}
