//! De Boor's scheme and Cox's recursion in a given span: formulas that go on outside it, as paths need them.

use super::MAX_ORDER;
use crate::geometry::Point;

/// A point with its weight, in homogeneous coordinates: `p` is already multiplied by `w`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hom<const D: usize> {
    pub(super) p: Point<D>,
    pub(super) w: f64,
}

impl<const D: usize> Hom<D> {
    pub(super) const ZERO: Self = Self { p: [0.0; D], w: 0.0 };

    pub(super) fn of(point: Point<D>, w: f64) -> Self {
        Self { p: point.map(|x| x * w), w }
    }

    /// `a * self + b * other`.
    pub(super) fn mixed(self, a: f64, b: f64, other: Self) -> Self {
        Self { p: std::array::from_fn(|d| a * self.p[d] + b * other.p[d]), w: a * self.w + b * other.w }
    }

    /// The point; `None` without a weight or where it is too far away.
    pub(super) fn point(self) -> Option<Point<D>> {
        let point = self.p.map(|x| x / self.w);
        point.iter().all(|x| x.is_finite()).then_some(point)
    }
}

/// The blossom of an arc at `arguments`, of which the first `slopes` are replaced by differences: with all arguments
/// `u`, `scale^slopes` times the derivative of this degree. `local` are the `order` control points of the arc. `None`
/// where knots coincide that must not, which happens to unordered knots only.
pub(super) fn blossom<const D: usize>(
    knots: &[f64],
    span: usize,
    local: &[Hom<D>],
    slopes: usize,
    scale: f64,
    argument: impl Fn(usize) -> f64,
) -> Option<Hom<D>> {
    let order = local.len();
    let mut d = [Hom::ZERO; MAX_ORDER];
    d.get_mut(..order)?.copy_from_slice(local);
    for round in 1..order {
        for l in (round..order).rev() {
            let i = (span + 1 + l).checked_sub(order)?;
            let (a, b) = (*knots.get(i)?, *knots.get(i + order - round)?);
            let width = b - a;
            if width == 0.0 {
                return None;
            }
            d[l] = if round <= slopes {
                let factor = (order - round) as f64 * (scale / width);
                d[l].mixed(factor, -factor, d[l - 1])
            } else {
                let t = argument(round - 1 - slopes);
                d[l - 1].mixed((b - t) / width, (t - a) / width, d[l])
            };
        }
    }
    let last = d[order.checked_sub(1)?];
    (last.w.is_finite() && last.p.iter().all(|x| x.is_finite())).then_some(last)
}

/// The values at `u` of the `order` functions that live on a span, by their recursion. `None` as in [`blossom`].
pub(super) fn functions(knots: &[f64], order: usize, span: usize, u: f64) -> Option<[f64; MAX_ORDER]> {
    let mut values = [0.0; MAX_ORDER];
    *values.first_mut()? = 1.0;
    for degree in 1..order {
        let mut saved = 0.0;
        for (r, function) in values.iter_mut().enumerate().take(degree) {
            let (a, b) = (*knots.get((span + 1 + r).checked_sub(degree)?)?, *knots.get(span + 1 + r)?);
            let width = b - a;
            if width == 0.0 {
                return None;
            }
            let value = *function;
            *function = saved + (b - u) / width * value;
            saved = (u - a) / width * value;
        }
        *values.get_mut(degree)? = saved;
    }
    Some(values)
}

/// Their derivatives of degree `slopes`, times `scale^slopes`; zeros from the order on.
pub(super) fn derivatives(
    knots: &[f64],
    order: usize,
    span: usize,
    u: f64,
    slopes: usize,
    scale: f64,
) -> Option<[f64; MAX_ORDER]> {
    if slopes >= order {
        return Some([0.0; MAX_ORDER]);
    }
    let mut values = functions(knots, order - slopes, span, u)?;
    for degree in order - slopes..order {
        // From order `degree` to the next: what a function loses, its neighbour before it gains.
        let mut saved = 0.0;
        for (r, function) in values.iter_mut().enumerate().take(degree) {
            let (a, b) = (*knots.get((span + 1 + r).checked_sub(degree)?)?, *knots.get(span + 1 + r)?);
            let share = degree as f64 * (scale / (b - a)) * *function;
            *function = saved - share;
            saved = share;
        }
        *values.get_mut(degree)? = saved;
    }
    Some(values)
}
