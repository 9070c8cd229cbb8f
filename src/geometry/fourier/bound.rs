//! The largest value of a trigonometric polynomial, by dividing the turn and dropping what cannot
//! reach the best value known.

use super::turn::turn;
use std::f64::consts::TAU;

/// Derivatives that the bound of a piece uses; the next one is bounded over the whole turn.
const ORDER: usize = 6;

/// How often a piece is halved at most. Others are settled long before.
const DEPTH: u32 = 48;

/// What a bound may be too large, by the sum of the amplitudes.
const SLACK: f64 = 1e-12;

/// `offset + sum of sin_k sin(k t) + cos_k cos(k t)`.
pub(super) struct Terms {
    pub(super) offset: f64,
    /// Sine and cosine coefficient of `k = 1, 2, …`.
    pub(super) pairs: Vec<[f64; 2]>,
}

/// An upper bound of the values, too large by no more than [`SLACK`].
pub(super) fn largest_value(terms: &Terms) -> f64 {
    let moment = |order: i32| -> f64 {
        let weighed = terms.pairs.iter().zip(1u32..);
        weighed.map(|([s, c], k)| (TAU * f64::from(k)).powi(order) * s.hypot(*c)).sum()
    };
    let slack = SLACK * moment(0);
    let beyond = moment(ORDER as i32);
    // Pieces by their middle and half width, small enough that each holds few extremes.
    let pieces = 4 * terms.pairs.len().max(1);
    let half = 0.5 / pieces as f64;
    let mut waiting: Vec<(f64, f64, u32)> =
        (0..pieces).map(|j| ((2 * j + 1) as f64 * half, half, DEPTH)).collect();
    let middles = waiting.iter().map(|&(middle, ..)| terms.derivatives(middle)[0]);
    let mut reached = middles.fold(f64::NEG_INFINITY, f64::max);
    let mut bound = reached;
    while let Some((middle, half, depth)) = waiting.pop() {
        let derivatives = terms.derivatives(middle);
        reached = reached.max(derivatives[0]);
        let top = taylor_bound(&derivatives, beyond, half);
        if top <= reached + slack || depth == 0 {
            bound = bound.max(top);
        } else {
            let quarter = 0.5 * half;
            waiting.push((middle - quarter, quarter, depth - 1));
            waiting.push((middle + quarter, quarter, depth - 1));
        }
    }
    bound.max(reached)
}

/// The largest value within `half` of a place with these derivatives, by Taylor's formula.
fn taylor_bound(derivatives: &[f64; ORDER], beyond: f64, half: f64) -> f64 {
    let mut power = 1.0;
    let mut bound = 0.0;
    for (order, derivative) in derivatives.iter().enumerate() {
        bound += if order == 0 { *derivative } else { power * derivative.abs() };
        power *= half / (order + 1) as f64;
    }
    bound + power * beyond
}

impl Terms {
    /// Value and derivatives by `u` at `u`.
    fn derivatives(&self, u: f64) -> [f64; ORDER] {
        let [sin, cos] = turn(u);
        let (mut sin_k, mut cos_k) = (sin, cos);
        let mut sums = [0.0; ORDER];
        for ([s, c], k) in self.pairs.iter().zip(1u32..) {
            let (value, slope) = (s * sin_k + c * cos_k, s * cos_k - c * sin_k);
            let mut power = 1.0;
            // Each derivative turns on by a quarter.
            for (order, sum) in sums.iter_mut().enumerate() {
                *sum += power * [value, slope, -value, -slope][order % 4];
                power *= TAU * f64::from(k);
            }
            (sin_k, cos_k) = (sin_k * cos + cos_k * sin, cos_k * cos - sin_k * sin);
        }
        sums[0] += self.offset;
        sums
    }
}
