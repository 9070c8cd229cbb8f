//! Conjugate gradients with diagonal scaling, for closed and large nets, all coordinates at once.

use super::axis::Axis;
use super::equations::{AROUND, Equations, REACH};
use crate::geometry::Point;

/// The remainder at which a solution is one, as part of the right side.
const ACCURACY: f64 = 1e-12;

/// A solution as far as it has come.
#[derive(Clone, Debug)]
pub(super) struct Gradients {
    equations: Equations,
    /// Whether the first and the last row of the net are one control point each.
    poles: bool,
    scale: Vec<f64>,
    solution: Vec<Point<3>>,
    rest: Vec<Point<3>>,
    direction: Vec<Point<3>>,
    /// Of every coordinate: remainder times scaled remainder, and whether it is small enough.
    energy: Point<3>,
    limit: f64,
    left: usize,
    room: Vec<[f64; 4]>,
    product: Vec<Point<3>>,
}

/// The sums of products, by coordinate.
fn products(a: &[Point<3>], b: &[Point<3>]) -> Point<3> {
    a.iter().zip(b).fold([0.0; 3], |sum, (a, b)| std::array::from_fn(|d| sum[d] + a[d] * b[d]))
}

impl Gradients {
    pub(super) fn new(axes: &[Axis; 2], equations: Equations, poles: bool) -> Self {
        let columns = axes[1].count();
        let centre = AROUND * REACH + REACH;
        let mut scale: Vec<f64> = equations.matrix.iter().map(|row| row[centre]).collect();
        let mut rest = equations.right.clone();
        if poles {
            gather_poles(&mut rest, columns);
            let rows = scale.len() / columns.max(1);
            for row in [0, rows.saturating_sub(1)] {
                let own = equations.matrix.iter().skip(row * columns).take(columns);
                scale[row * columns] =
                    own.map(|row| row.iter().skip(AROUND * REACH).take(AROUND).sum::<f64>()).sum();
            }
        }
        // A control point that nothing depends on stays.
        scale.iter_mut().for_each(|x| *x = if *x > 0.0 { 1.0 / *x } else { 0.0 });
        let direction: Vec<Point<3>> = rest.iter().zip(&scale).map(|(x, s)| x.map(|x| x * s)).collect();
        Self {
            poles,
            energy: products(&rest, &direction),
            solution: vec![[0.0; 3]; rest.len()],
            limit: ACCURACY * equations.size,
            left: 1000 + 20 * rest.len(),
            direction,
            rest,
            scale,
            equations,
            room: Vec::new(),
            product: Vec::new(),
        }
    }

    /// What a step costs, in points that are gathered.
    pub(super) fn cost(&self) -> usize {
        1 + self.rest.len() / 4
    }

    /// One step more; the solution when the remainder is small enough in all coordinates.
    pub(super) fn advance(&mut self, axes: &[Axis; 2]) -> Option<Vec<Point<3>>> {
        let columns = axes[1].count();
        let squares = products(&self.rest, &self.rest);
        let going: [bool; 3] =
            std::array::from_fn(|d| squares[d].sqrt() > self.limit && self.energy[d] > 0.0);
        if self.left == 0 || going == [false; 3] {
            if self.poles {
                spread_poles(&mut self.solution, columns);
            }
            return Some(std::mem::take(&mut self.solution));
        }
        self.left -= 1;
        if self.poles {
            spread_poles(&mut self.direction, columns);
        }
        self.equations.times_into(axes, &self.direction, &mut self.room, &mut self.product);
        if self.poles {
            gather_poles(&mut self.product, columns);
            // Counted once from here on.
            clear_poles(&mut self.direction, columns);
        }
        let curvature = products(&self.direction, &self.product);
        let step: Point<3> = std::array::from_fn(|d| {
            if going[d] && curvature[d] > 0.0 { self.energy[d] / curvature[d] } else { 0.0 }
        });
        for ((x, rest), (direction, product)) in
            self.solution.iter_mut().zip(&mut self.rest).zip(self.direction.iter().zip(&self.product))
        {
            for d in 0..3 {
                x[d] += step[d] * direction[d];
                rest[d] -= step[d] * product[d];
            }
        }
        let mut energy = [0.0; 3];
        for (rest, scale) in self.rest.iter().zip(&self.scale) {
            for d in 0..3 {
                energy[d] += rest[d] * rest[d] * scale;
            }
        }
        let back: Point<3> = std::array::from_fn(|d| {
            if going[d] && self.energy[d] > 0.0 { energy[d] / self.energy[d] } else { 0.0 }
        });
        for ((direction, rest), scale) in self.direction.iter_mut().zip(&self.rest).zip(&self.scale) {
            *direction = std::array::from_fn(|d| rest[d] * scale + back[d] * direction[d]);
        }
        self.energy = energy;
        None
    }
}

/// The first places of the two poles, which stand for all.
fn pole_rows(count: usize, columns: usize) -> [usize; 2] {
    [0, count.saturating_sub(columns)]
}

/// Gives all places of a pole the value of the first.
fn spread_poles(values: &mut [Point<3>], columns: usize) {
    for first in pole_rows(values.len(), columns) {
        if let Some(row) = values.get_mut(first..first + columns) {
            let value = row.first().copied().unwrap_or_default();
            row.fill(value);
        }
    }
}

/// Leaves the value of the first place only.
fn clear_poles(values: &mut [Point<3>], columns: usize) {
    for first in pole_rows(values.len(), columns) {
        if let Some(row) = values.get_mut(first + 1..first + columns) {
            row.fill([0.0; 3]);
        }
    }
}

/// Brings the sum of a pole's places to the first.
fn gather_poles(values: &mut [Point<3>], columns: usize) {
    for first in pole_rows(values.len(), columns) {
        let Some(row) = values.get_mut(first..first + columns) else { continue };
        let sum = row.iter().fold([0.0; 3], |sum, x| std::array::from_fn(|d| sum[d] + x[d]));
        if let Some(place) = row.first_mut() {
            *place = sum;
        }
    }
    clear_poles(values, columns);
}
