//! From control points to others of the same function: order elevation, subdivision, exact description.
//!
//! One idea serves all: the control points of any function of the space follow from its Taylor coefficients at both
//! ends of the interval ([`Series::control_points`](super::series::Series::control_points)).

use super::basis::EcBasis;
use super::dd::{Dd, ONE, ZERO};
use super::ordinary::taylor;
use super::{EcError, series};
use crate::geometry::{Basis, GeometryError, Point};

/// Taylor coefficients at a place, one point each.
type JetOf<const D: usize> = Vec<[Dd; D]>;

impl EcBasis {
    /// The Taylor coefficients at `t` of the curve, by `s`.
    fn jet<const D: usize>(&self, points: &[[Dd; D]], t: Dd) -> JetOf<D> {
        if !self.mirrored {
            return self.series.jet(points, t);
        }
        let reversed: Vec<[Dd; D]> = points.iter().rev().copied().collect();
        turned(self.series.jet(&reversed, ONE - t))
    }

    /// The control points of the function with these Taylor coefficients at both ends.
    fn points_of<const D: usize>(&self, start: JetOf<D>, end: JetOf<D>) -> Vec<[Dd; D]> {
        if !self.mirrored {
            return self.series.control_points(&start, &end);
        }
        let mut points = self.series.control_points(&turned(end), &turned(start));
        points.reverse();
        points
    }

    /// Where a parameter lies, 0 at the start and 1 at the end.
    fn place(&self, u: f64) -> Dd {
        match self.interval() {
            [start, _] if u == start => ZERO,
            [_, end] if u == end => ONE,
            [start, _] => Dd::difference(u, start) / self.h,
        }
    }

    /// The control points by which `target` describes the curve that these points have in this basis. The space of
    /// `target` must contain this one: order elevation (1.28, 1.29), if the intervals are the same, by any roots at
    /// once; subdivision (1.35 to 1.41), shortening and prolonging, if the spaces are.
    ///
    /// # Errors
    /// A wrong number of points, and [`GeometryError::Overflow`] where a point leaves the range of doubles.
    pub fn transfer<const D: usize>(
        &self,
        points: &[Point<D>],
        target: &Self,
    ) -> Result<Vec<Point<D>>, EcError> {
        let points = self.counted(points)?;
        let ratio = target.h / self.h;
        let [start, end] = target.interval().map(|u| {
            let mut jet = self.jet(&points, self.place(u));
            jet.resize(target.points().max(jet.len()), [ZERO; D]);
            if ratio != ONE {
                let mut power = ONE;
                for term in &mut jet {
                    *term = term.map(|c| c * power);
                    power = power * ratio;
                }
            }
            jet
        });
        // A larger space asks for derivatives that the smaller one has beyond its own number.
        let (start, end) = match target.points() > self.points() {
            false => (start, end),
            true => (self.extended(&points, target, 0), self.extended(&points, target, 1)),
        };
        rounded(target.points_of(start, end))
    }

    /// The Taylor coefficients that a larger space needs at an end of `target`, which has half of its dimension from
    /// either end: never more than the own space has itself, but for small ones.
    fn extended<const D: usize>(&self, points: &[[Dd; D]], target: &Self, end: usize) -> JetOf<D> {
        let u = target.interval()[end];
        let ratio = target.h / self.h;
        let mut jet = self.jet(points, self.place(u));
        // y^(k + n + 1) follows from the differential equation: with c_k the coefficients,
        // sum over i of g_i c_(k+i) (k+i)! = 0.
        let polynomial = series::polynomial(self.space(), self.h, false);
        let dimension = self.points();
        while jet.len() < target.points() {
            let k = jet.len() - dimension;
            let next: [Dd; D] = std::array::from_fn(|d| {
                let mut product = ONE;
                let mut sum = ZERO;
                for i in (0..dimension).rev() {
                    product = product * (k + i + 1) as f64;
                    sum += polynomial[i] * jet[k + i][d] / product;
                }
                -sum
            });
            jet.push(next);
        }
        let mut power = ONE;
        for term in &mut jet {
            *term = term.map(|c| c * power);
            power = power * ratio;
        }
        jet
    }

    /// The control points of a sum of ordinary functions: `coefficients[i]` times function i (1.45, 1.46). From the
    /// Taylor coefficients of the sum, for the matrix of all functions may be large where they cancel.
    ///
    /// # Errors
    /// A wrong number of coefficients, and [`GeometryError::Overflow`].
    pub fn exact<const D: usize>(&self, coefficients: &[Point<D>]) -> Result<Vec<Point<D>>, EcError> {
        let coefficients = self.counted(coefficients)?;
        let [start, end] = self.interval().map(|u| {
            let functions = taylor(self.space(), u, self.h, self.points());
            let sum = |j: usize| -> [Dd; D] {
                std::array::from_fn(|d| {
                    functions.iter().zip(&coefficients).fold(ZERO, |sum, (row, c)| sum + row[j] * c[d])
                })
            };
            (0..self.points()).map(sum).collect::<Vec<_>>()
        });
        rounded(self.points_of(start, end))
    }

    /// The matrix of the basis transformation (1.42 to 1.44): ordinary function i is the sum of `t[i][j]` times b_j.
    ///
    /// # Errors
    /// [`GeometryError::Overflow`] where a function leaves the range of doubles.
    pub fn transformation(&self) -> Result<Vec<Vec<f64>>, EcError> {
        (0..self.points())
            .map(|i| {
                let only: Vec<Point<1>> =
                    (0..self.points()).map(|k| [if k == i { 1.0 } else { 0.0 }]).collect();
                self.exact(&only).map(|row| row.into_iter().map(|[t]| t).collect())
            })
            .collect()
    }

    /// The control points of the curve that goes through `data[k]` at the parameter `places[k]` of the span, n + 1
    /// different places in [0, 1].
    ///
    /// # Errors
    /// A wrong number of data or places, [`EcError::Outside`] for a place that is not inside or not larger than the
    /// one before, and [`GeometryError::Overflow`].
    pub fn interpolate<const D: usize>(
        &self,
        places: &[f64],
        data: &[Point<D>],
    ) -> Result<Vec<Point<D>>, EcError> {
        let data = self.counted(data)?;
        self.counted(&places.iter().map(|&s| [s]).collect::<Vec<_>>())?;
        let mut last = -1.0;
        for &s in places {
            if !(s > last && (0.0..=1.0).contains(&s)) {
                return Err(EcError::Outside { at: s, interval: [last.max(0.0), 1.0] });
            }
            last = s;
        }
        let n = self.points() - 1;
        let value = |i: usize, s: f64| match self.mirrored {
            false => self.series.value(i, Dd::from(s)),
            true => self.series.value(n - i, ONE - Dd::from(s)),
        };
        let mut points = vec![[ZERO; D]; n + 1];
        for d in 0..D {
            let mut rows: Vec<Vec<Dd>> = places
                .iter()
                .zip(&data)
                .map(|(&s, point)| (0..=n).map(|i| value(i, s)).chain([point[d]]).collect())
                .collect();
            let solution = series::solve(&mut rows).ok_or(GeometryError::Overflow { span: 0 })?;
            points.iter_mut().zip(solution).for_each(|(point, x)| point[d] = x);
        }
        rounded(points)
    }

    /// The derivatives at the end of a curve with control points `points`, by the parameter of the space, order 0 to
    /// `order`; at the start if `end` is false.
    ///
    /// # Errors
    /// A wrong number of points.
    pub fn end_derivatives<const D: usize>(
        &self,
        points: &[Point<D>],
        end: bool,
        order: usize,
    ) -> Result<Vec<Point<D>>, EcError> {
        let jet = self.jet(&self.counted(points)?, if end { ONE } else { ZERO });
        let mut factor = ONE;
        let derivative = |(j, term): (usize, [Dd; D])| {
            if j > 0 {
                factor = factor * j as f64 / self.h;
            }
            term.map(|c| (c * factor).value())
        };
        Ok(jet.into_iter().take(order + 1).enumerate().map(derivative).collect())
    }

    /// Replaces the first control points (the last, if `end`), so that the curve begins (ends) with these derivatives
    /// by the parameter of the space; as many as there are, but not beyond the other end's own.
    ///
    /// # Errors
    /// A wrong number of points, and [`GeometryError::Overflow`].
    pub fn set_end_derivatives<const D: usize>(
        &self,
        points: &[Point<D>],
        end: bool,
        derivatives: &[Point<D>],
    ) -> Result<Vec<Point<D>>, EcError> {
        let mut points = self.counted(points)?;
        let n = self.points() - 1;
        // In the direction of the build: row j of the table of this end, function k from this end.
        let at_start = end == self.mirrored;
        let entry = |k: usize, j: usize| match at_start {
            true => self.series.start[k][j],
            false => self.series.end[n - k][j],
        };
        let sign = if self.mirrored { -ONE } else { ONE };
        let mut power = ONE;
        for (j, derivative) in derivatives.iter().enumerate().take(n + 1) {
            if j > 0 {
                power = power * self.h * sign / Dd::from(j as f64);
            }
            let index = |k: usize| if end { n - k } else { k };
            let point: [Dd; D] = std::array::from_fn(|d| {
                let wanted = Dd::from(derivative[d]) * power;
                let known = (0..j).fold(wanted, |sum, k| sum - points[index(k)][d] * entry(k, j));
                known / entry(j, j)
            });
            points[index(j)] = point;
        }
        rounded(points)
    }

    /// Points as double-doubles, if they are as many as the functions.
    fn counted<const D: usize>(&self, points: &[Point<D>]) -> Result<Vec<[Dd; D]>, EcError> {
        if points.len() != self.points() {
            return Err(GeometryError::WrongCount { given: points.len(), needed: self.points() }.into());
        }
        crate::geometry::point::check_points(points)?;
        Ok(points.iter().map(|point| point.map(Dd::from)).collect())
    }
}

/// Taylor coefficients of the same function in the opposite direction.
fn turned<const D: usize>(mut jet: JetOf<D>) -> JetOf<D> {
    for term in jet.iter_mut().skip(1).step_by(2) {
        *term = term.map(|c| -c);
    }
    jet
}

fn rounded<const D: usize>(points: Vec<[Dd; D]>) -> Result<Vec<Point<D>>, EcError> {
    let points: Vec<Point<D>> = points.into_iter().map(|point| point.map(Dd::value)).collect();
    match points.iter().all(crate::geometry::point::within_limit) {
        true => Ok(points),
        false => Err(GeometryError::Overflow { span: 0 }.into()),
    }
}
