//! Arcs that keep out of discs: an exact test, and the lengths of tangents that pass it.

use super::Ball;
use super::hermite::Hermite;
use crate::geometry::point::{norm, scaled_difference};
use crate::geometry::{BoundingBox, CubicBezier, Point, dot};

/// Factors of the tangents that are tried, the plain ones first.
pub(super) const SCALES: [f64; 11] = [1.0, 1.15, 1.3, 1.5, 1.75, 2.0, 0.85, 0.7, 0.55, 0.4, 0.25];
/// How often a polynomial is halved to find its sign.
const HALVINGS: u32 = 20;
/// What counts as zero, as a part of the largest coefficient.
const ZERO: f64 = 1e-13;

/// Whether arcs are cleared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Clearing {
    /// Tangents of twice the distance from the radical line, whatever the arc does.
    Plain,
    /// Where such an arc enters a disc, both tangents are scaled by the first of some factors that keeps it out, or else
    /// by two factors of their own. The touching points and tangent directions stay.
    #[default]
    Scaled,
}

/// Factors of the tangents for arcs between the same two balls, and whether they keep all arcs out of these and of the
/// `others`. Where no factors do, those that keep out of the two alone, or else 1.
pub(super) fn choose<const D: usize>(
    clearing: Clearing,
    arcs: &[Hermite<D>],
    own: [&Ball<D>; 2],
    others: &[&Ball<D>],
) -> ([f64; 2], bool) {
    let clear = |scales: [f64; 2], others: &[&Ball<D>]| {
        arcs.iter().all(|arc| {
            let arc = arc.scaled(scales);
            keeps_out_of_own(&arc, own) && others.iter().all(|ball| keeps_out(&arc, ball))
        })
    };
    let plain = [1.0; 2];
    if clear(plain, others) {
        return (plain, true);
    }
    if clearing == Clearing::Plain {
        return (plain, false);
    }
    let search = |others: &[&Ball<D>]| {
        let same = SCALES.into_iter().map(|scale| [scale; 2]).find(|scales| clear(*scales, others));
        same.or_else(|| pairs().into_iter().find(|scales| clear(*scales, others)))
    };
    // Without factors that keep out of the two alone there are none that keep out of all, nor if an end is inside.
    let own_scales = search(&[]);
    let covered = |point: Point<D>| others.iter().any(|ball| ball.contains(point, -ZERO * ball.radius));
    let is_hopeless = own_scales.is_none() || arcs.iter().flat_map(|arc| arc.points).any(covered);
    if !is_hopeless && let Some(scales) = if others.is_empty() { own_scales } else { search(others) } {
        return (scales, true);
    }
    (own_scales.unwrap_or(plain), false)
}

/// Different factors for both tangents, those with the least sum of logarithms first.
fn pairs() -> Vec<[f64; 2]> {
    let mut pairs: Vec<[f64; 2]> = SCALES
        .into_iter()
        .flat_map(|f| SCALES.into_iter().map(move |g| [f, g]))
        .filter(|[f, g]| f != g)
        .collect();
    let off = |[f, g]: &[f64; 2]| f.ln().abs() + g.ln().abs();
    pairs.sort_by(|a, b| off(a).total_cmp(&off(b)));
    pairs
}

/// Those of the balls, without two of them, that arcs with any of the [`SCALES`] might enter.
pub(super) fn near<'a, const D: usize>(
    arcs: &[Hermite<D>],
    balls: &'a [Ball<D>],
    own: [usize; 2],
) -> Vec<&'a Ball<D>> {
    // The control points of arcs with smaller factors lie between those of the largest and the ends.
    let points = arcs.iter().flat_map(|arc| arc.scaled([2.0; 2]).p);
    let Some(bounds) = BoundingBox::around(points) else { return Vec::new() };
    let outside = |ball: &Ball<D>| {
        let off: Point<D> = std::array::from_fn(|d| {
            (bounds.min[d] - ball.center[d]).max(ball.center[d] - bounds.max[d]).max(0.0)
        });
        // The largest coordinate alone decides for most.
        off.iter().any(|x| *x >= ball.radius) || norm(off) >= ball.radius
    };
    let others = balls.iter().enumerate().filter(|(index, _)| !own.contains(index));
    others.map(|(_, ball)| ball).filter(|ball| !outside(ball)).collect()
}

/// Whether an arc keeps out of the two balls that it touches at its ends.
pub(super) fn keeps_out_of_own<const D: usize>(arc: &CubicBezier<D>, [first, last]: [&Ball<D>; 2]) -> bool {
    keeps_out_of_first(arc, first) && keeps_out_of_first(&arc.reversed(), last)
}

/// Whether an arc keeps out of the ball that it touches where it begins. The squared distance less the squared radius
/// has a double zero there; the rest is of degree 4.
fn keeps_out_of_first<const D: usize>(arc: &CubicBezier<D>, ball: &Ball<D>) -> bool {
    let start = arc.p[0];
    let normal = scaled_difference(1.0, ball.center, start);
    let [g, h, k]: [Point<D>; 3] = std::array::from_fn(|j| scaled_difference(1.0, start, arc.p[j + 1]));
    // |H - C|² - r² = |H - T|² + 2 (T - C).(H - T), the coefficients times binomial ones; (T - C).g is 0.
    let (second, third) = (3.0 * dot(normal, h), dot(normal, k));
    let sums = [
        9.0 * dot(g, g) + 2.0 * second,
        18.0 * dot(g, h) + 2.0 * (3.0 * second + third),
        9.0 * dot(h, h) + 6.0 * dot(g, k) + 2.0 * (3.0 * second + 3.0 * third),
        6.0 * dot(h, k) + 2.0 * (second + 3.0 * third),
        dot(k, k) + 2.0 * third,
    ];
    let [a, b, c, d, e] = sums;
    is_nowhere_negative([a, b / 4.0, c / 6.0, d / 4.0, e])
}

/// Whether an arc keeps out of a ball that it need not touch.
pub(super) fn keeps_out<const D: usize>(arc: &CubicBezier<D>, ball: &Ball<D>) -> bool {
    let d: [Point<D>; 4] = arc.p.map(|p| scaled_difference(1.0, ball.center, p));
    let square = ball.radius * ball.radius;
    let p = |i: usize, j: usize| dot(d[i], d[j]);
    is_nowhere_negative(
        [
            p(0, 0),
            p(0, 1),
            (6.0 * p(0, 2) + 9.0 * p(1, 1)) / 15.0,
            (2.0 * p(0, 3) + 18.0 * p(1, 2)) / 20.0,
            (6.0 * p(1, 3) + 9.0 * p(2, 2)) / 15.0,
            p(2, 3),
            p(3, 3),
        ]
        .map(|x| x - square),
    )
}

/// Whether the polynomial with these Bernstein coefficients is nowhere negative on [0, 1] but for rounding.
fn is_nowhere_negative<const N: usize>(coefficients: [f64; N]) -> bool {
    let largest = coefficients.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    // Sums of coefficients must be finite too, and NaN is lost in the maximum above.
    coefficients.iter().all(|x| x.is_finite())
        && halved(coefficients.map(|x| if largest > 0.0 { x / largest } else { x }), HALVINGS)
}

/// The same by halving until the sign is certain.
fn halved<const N: usize>(coefficients: [f64; N], halvings: u32) -> bool {
    if coefficients.iter().all(|x| *x >= -ZERO) {
        return true;
    }
    // The first and the last are values of the polynomial.
    let ends = [coefficients.first(), coefficients.last()];
    if ends.into_iter().flatten().any(|x| *x < -ZERO) {
        return false;
    }
    if halvings == 0 {
        // It is not negative at the ends of a millionth of the arc.
        return true;
    }
    let (mut first, mut last) = (coefficients, coefficients);
    for round in 1..N {
        for j in (round..N).rev() {
            first[j] = 0.5 * (first[j - 1] + first[j]);
        }
        for j in 0..N - round {
            last[j] = 0.5 * (last[j] + last[j + 1]);
        }
    }
    halved(first, halvings - 1) && halved(last, halvings - 1)
}
