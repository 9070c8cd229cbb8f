//! The radii of curvature over a patch, and how far offsets go without folds.

use super::PnSurface;
use crate::geometry::ParamSurface;
use crate::geometry::surface::indices;

/// Places along each direction of a patch that extremes are looked for from.
const PLACES: usize = 17;
/// Rounds of searching along both parameters and the way of the last round.
const ROUNDS: usize = 40;
/// Steps of a golden section; the bracket shrinks to 1e-9 of itself.
const STEPS: usize = 43;
/// Radii below this part of the largest are zero.
const ZERO: f64 = 1e-12;

/// The radii of curvature r1 <= r2 over a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusRange {
    /// The smallest and the largest r1.
    pub r1: [f64; 2],
    /// The smallest and the largest r2.
    pub r2: [f64; 2],
}

impl RadiusRange {
    /// Whether a radius is zero somewhere in the patch: there the surface has a cuspidal edge and is folded,
    /// although its normals turn regularly.
    #[must_use]
    pub fn is_folded(&self) -> bool {
        let zero = ZERO * [self.r1, self.r2].iter().flatten().fold(0.0_f64, |most, r| most.max(r.abs()));
        [self.r1, self.r2].iter().any(|[low, high]| *low <= zero && *high >= -zero)
    }
}

/// The distances at which offsets have no local folds: all between the two. Parts far from each other may still
/// meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SafeDistances {
    /// The limit of negative distances, -min of the positive radii; `None` where there is none.
    pub low: Option<f64>,
    /// The limit of positive distances, -max of the negative radii; `None` where there is none.
    pub high: Option<f64>,
}

impl PnSurface {
    /// The radii of curvature over a patch, from 17 x 17 places with the extremes refined; `None` outside the
    /// spans.
    #[must_use]
    pub fn radius_range(&self, spans: [usize; 2]) -> Option<RadiusRange> {
        let step = 1.0 / (PLACES - 1) as f64;
        let places: Vec<[f64; 2]> =
            indices([PLACES; 2]).map(|place| place.map(|index| index as f64 * step)).collect();
        let radii: Option<Vec<[f64; 2]>> = places.iter().map(|uv| self.radii(spans, *uv)).collect();
        let radii = radii?;
        let least = |which: usize, sign: f64| {
            let value =
                |uv: [f64; 2]| self.radii(spans, uv).map_or(f64::INFINITY, |radii| sign * radii[which]);
            let known = places.iter().zip(&radii).map(|(uv, radii)| (*uv, sign * radii[which]));
            let start = known.min_by(|a, b| a.1.total_cmp(&b.1));
            start.map_or(f64::NAN, |start| sign * least_near(&value, start, step))
        };
        Some(RadiusRange { r1: [least(0, 1.0), least(0, -1.0)], r2: [least(1, 1.0), least(1, -1.0)] })
    }

    /// The radii of curvature over every patch, row by row.
    #[must_use]
    pub fn radius_ranges(&self) -> Vec<RadiusRange> {
        indices(self.spans()).filter_map(|spans| self.radius_range(spans)).collect()
    }

    /// Between which distances from this surface offsets have no local folds; `None` when the surface itself is
    /// folded: where a radius of curvature is zero somewhere, or has one sign on one side of a border of
    /// patches and the other on the other.
    #[must_use]
    pub fn safe_distances(&self) -> Option<SafeDistances> {
        let ranges = self.radius_ranges();
        if ranges.iter().any(RadiusRange::is_folded) {
            return None;
        }
        // The sign of r1 r2 is that of the surface's side; it is the same everywhere, or there is a fold.
        let saddle = |range: &RadiusRange| range.r1[0] < 0.0 && range.r2[0] > 0.0;
        if ranges.iter().any(saddle) && !ranges.iter().all(saddle) {
            return None;
        }
        let all = || ranges.iter().flat_map(|range| [range.r1, range.r2]);
        let least = all().map(|[low, _]| low).filter(|low| *low > 0.0).reduce(f64::min);
        let most = all().map(|[_, high]| high).filter(|high| *high < 0.0).reduce(f64::max);
        Some(SafeDistances { low: least.map(|it| -it), high: most.map(|it| -it) })
    }
}

/// The least value near a place with a known value, by golden sections along u, v and the way of the last
/// round, each within a step.
pub(super) fn least_near(value: &dyn Fn([f64; 2]) -> f64, start: ([f64; 2], f64), step: f64) -> f64 {
    let (mut place, mut least) = start;
    for _ in 0..ROUNDS {
        let (before, old) = (place, least);
        let along = |place: &mut [f64; 2], least: &mut f64, way: [f64; 2]| {
            let at = |t: f64| [0, 1].map(|d| (place[d] + t * way[d]).clamp(0.0, 1.0));
            let (t, found) = golden(&|t| value(at(t)), -1.0, 1.0);
            if found < *least {
                (*place, *least) = (at(t), found);
            }
        };
        along(&mut place, &mut least, [step, 0.0]);
        along(&mut place, &mut least, [0.0, step]);
        let way = [place[0] - before[0], place[1] - before[1]];
        if way[0] != 0.0 && way[1] != 0.0 {
            let longer = step / way[0].abs().max(way[1].abs());
            along(&mut place, &mut least, way.map(|x| x * longer));
        }
        if old - least <= 1e-15 * least.abs() {
            break;
        }
    }
    least
}

/// The place and value of a minimum between two numbers.
fn golden(value: &dyn Fn(f64) -> f64, mut low: f64, mut high: f64) -> (f64, f64) {
    let part = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (high - part * (high - low), low + part * (high - low));
    let (mut at_a, mut at_b) = (value(a), value(b));
    for _ in 0..STEPS {
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - part * (high - low);
            at_a = value(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + part * (high - low);
            at_b = value(b);
        }
    }
    // Minima at the very ends are not met by the sections.
    let ends = [(low, value(low)), (high, value(high)), (b, at_b)];
    ends.into_iter().fold((a, at_a), |best, next| if next.1 < best.1 { next } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn least_value_inside_and_at_the_border() {
        let bowl = |[u, v]: [f64; 2]| {
            let (x, y) = (u - 0.4, v - 0.55);
            3.0 + x * x + 1.9 * x * y + y * y
        };
        assert!((least_near(&bowl, ([0.375, 0.5], bowl([0.375, 0.5])), 0.0625) - 3.0).abs() < 1e-12);
        let slope = |[u, v]: [f64; 2]| u + 2.0 * v;
        assert_eq!(least_near(&slope, ([0.0, 0.0], 0.0), 0.0625), 0.0);
        assert!(least_near(&slope, ([0.0625, 0.0625], 0.1875), 0.0625) < 1e-9);
    }

    use crate::geometry::pn::examples::{Example, data, paraboloid, saddle, sphere, torus_outside};
    use crate::geometry::{PnMethod, dot};

    fn surface(example: Example, rows: usize, columns: usize) -> PnSurface {
        PnSurface::new(&data(example, rows, columns), PnMethod::Normalised).unwrap()
    }

    /// Extremes found agree with dense samples, and are not beyond them by more than samples miss.
    #[test]
    fn ranges_agree_with_dense_samples() {
        for (example, rows, columns) in [(saddle as Example, 3, 4), (paraboloid, 4, 4), (torus_outside, 3, 3)]
        {
            let surface = surface(example, rows, columns);
            for spans in indices(surface.spans()) {
                let range = surface.radius_range(spans).unwrap();
                let dense = indices([201, 201]).map(|place| place.map(|k| k as f64 / 200.0));
                let mut seen = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
                for uv in dense {
                    for (seen, r) in seen.iter_mut().zip(surface.radii(spans, uv).unwrap()) {
                        *seen = [seen[0].min(r), seen[1].max(r)];
                    }
                }
                for ([low, high], seen) in [range.r1, range.r2].into_iter().zip(seen) {
                    let size = seen[0].abs().max(seen[1].abs());
                    assert!(low <= seen[0] + 1e-12 * size && low > seen[0] - 1e-3 * size, "{low} {seen:?}");
                    assert!(
                        high >= seen[1] - 1e-12 * size && high < seen[1] + 1e-3 * size,
                        "{high} {seen:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn limits_are_where_folds_begin() {
        let limits = surface(paraboloid, 4, 4).safe_distances().unwrap();
        assert!((limits.low.unwrap() + 15.626).abs() < 1e-3 && limits.high.is_none(), "{limits:?}");
        let limits = surface(sphere, 4, 4).safe_distances().unwrap();
        assert!((limits.low.unwrap() + 30.0).abs() < 1e-11 && limits.high.is_none(), "{limits:?}");
        let saddle = surface(saddle, 3, 4);
        let SafeDistances { low: Some(low), high: Some(high) } = saddle.safe_distances().unwrap() else {
            panic!("limits on both sides")
        };
        assert!((low + 3.2944).abs() < 1e-4 && (high - 4.7308).abs() < 1e-4, "{low} {high}");
        for (d, folded) in
            [(0.999 * low, false), (1.001 * low, true), (0.999 * high, false), (1.001 * high, true)]
        {
            let offset = saddle.offset(d).unwrap();
            assert_eq!(offset.safe_distances().is_none(), folded, "{d}");
            // Where it folds, r_u x r_v turns to the other side of the normal.
            let sides = offset.sample(64).unwrap().into_iter().map(|sample| {
                let at = offset.at(sample.spans, sample.parameters).unwrap();
                let normal = offset.place(sample.spans, sample.parameters).unwrap().normal;
                dot(crate::geometry::cross(at.u, at.v), normal) > 0.0
            });
            let sides: Vec<bool> = sides.collect();
            assert_eq!(sides.iter().any(|side| *side != sides[0]), folded, "{d}");
        }
        // Limits move along with the surface.
        let moved = saddle.offset(1.0).unwrap().safe_distances().unwrap();
        assert!(
            (moved.low.unwrap() - low + 1.0).abs() < 1e-12
                && (moved.high.unwrap() - high + 1.0).abs() < 1e-12
        );
    }
}
