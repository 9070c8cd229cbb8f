//! What all regular patches have in common, quickly enough for an editor.

use super::radii::{SafeDistances, least_near};
use super::{PnData, PnNet, PnSurface};
use crate::geometry::Point;
use crate::geometry::point::{dot, norm, scaled_difference};
use crate::geometry::surface::indices;

/// Patches whose sampled extreme is within this part of the size of the best are searched too.
const NEAR: f64 = 0.02;

/// The radii of curvature and the distances without folds of all patches that are regular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overview {
    /// The smallest and the largest r1.
    pub r1: [f64; 2],
    /// The smallest and the largest r2.
    pub r2: [f64; 2],
    /// Between which distances offsets have no local folds; `None` where the surface itself is folded.
    pub limits: Option<SafeDistances>,
}

impl PnNet {
    /// The radii of all patches that are regular, from so many places along each direction of a patch; extremes are
    /// refined if asked for. `None` where no patch is regular.
    #[must_use]
    pub fn overview(&self, places: usize, refined: bool) -> Option<Overview> {
        let surfaces: Vec<PnSurface> =
            indices(self.size()).filter_map(|[i, j]| self.patch_surface(i, j)?.ok()).collect();
        let step = 1.0 / places.saturating_sub(1).max(1) as f64;
        let uvs: Vec<[f64; 2]> =
            indices([places.max(2); 2]).map(|place| place.map(|index| index as f64 * step)).collect();
        let sampled: Vec<Vec<[f64; 2]>> = surfaces
            .iter()
            .map(|surface| uvs.iter().filter_map(|uv| surface.radii([0, 0], *uv)).collect())
            .collect();
        let size = sampled.iter().flatten().flatten().fold(0.0_f64, |most, r| most.max(r.abs()));
        let least = |which: usize, sign: f64| -> f64 {
            let bests = sampled.iter().map(|radii| {
                let values = radii.iter().map(|r| sign * r[which]).enumerate();
                values.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::INFINITY))
            });
            let bests: Vec<(usize, f64)> = bests.collect();
            let best = bests.iter().map(|(_, value)| *value).fold(f64::INFINITY, f64::min);
            let near = bests
                .iter()
                .zip(&surfaces)
                .filter(|((_, value), _)| refined && *value <= best + NEAR * best.abs().max(NEAR * size));
            let refined = near.map(|((index, value), surface)| {
                let at = |uv: [f64; 2]| {
                    surface.radii([0, 0], uv).map_or(f64::INFINITY, |radii| sign * radii[which])
                };
                let from = uvs.get(*index).copied().unwrap_or_default();
                least_near(&at, (from, *value), step)
            });
            sign * refined.fold(best, f64::min)
        };
        let (r1, r2) = ([least(0, 1.0), least(0, -1.0)], [least(1, 1.0), least(1, -1.0)]);
        let known = r1.iter().chain(&r2).all(|radius| radius.is_finite());
        known.then(|| Overview { r1, r2, limits: limits(r1, r2) })
    }

    /// The unit normal at a place of a patch, also of one that is parabolic; `None` outside the net.
    #[must_use]
    pub fn gauss_normal(&self, [i, j]: [usize; 2], [u, v]: [f64; 2]) -> Option<Point<3>> {
        let [p, q, _] = self.isotropic(i, j)?.eval(u, v);
        let rho = p * p + q * q;
        Some(self.chart.direction([2.0 * p, 2.0 * q, rho - 1.0].map(|x| x / (1.0 + rho))))
    }
}

/// The distances without folds where each radius keeps its sign everywhere.
fn limits(r1: [f64; 2], r2: [f64; 2]) -> Option<SafeDistances> {
    let one_sign = |[low, high]: [f64; 2]| low > 0.0 || high < 0.0;
    if !one_sign(r1) || !one_sign(r2) {
        return None;
    }
    let positive = [r1, r2].into_iter().map(|[low, _]| low).filter(|low| *low > 0.0).reduce(f64::min);
    let negative = [r1, r2].into_iter().map(|[_, high]| high).filter(|high| *high < 0.0).reduce(f64::max);
    Some(SafeDistances { low: positive.map(|r| -r), high: negative.map(|r| -r) })
}

impl PnData {
    /// The centre and the radius of the sphere that fits points and normals best, N2 of the method; the radius is
    /// negative where normals point inwards. `None` for the data of a plane.
    #[must_use]
    pub fn sphere(&self) -> Option<(Point<3>, f64)> {
        let count = self.points().len().max(1) as f64;
        let mean = |all: &[Point<3>]| -> Point<3> {
            std::array::from_fn(|d| all.iter().map(|point| point[d]).sum::<f64>() / count)
        };
        let (point, normal) = (mean(self.points()), mean(self.normals()));
        let (mut above, mut below) = (0.0, 0.0);
        for (x, n) in self.points().iter().zip(self.normals()) {
            let turned = scaled_difference(1.0, *n, normal);
            above += dot(scaled_difference(1.0, *x, point), turned);
            below += norm(turned).powi(2);
        }
        let radius = above / below;
        let centre: Point<3> = std::array::from_fn(|d| point[d] - radius * normal[d]);
        (radius.is_finite() && centre.iter().all(|x| x.is_finite())).then_some((centre, radius))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::PnMethod;
    use crate::geometry::pn::examples::{data, paraboloid, saddle, sphere, torus_crest, torus_outside};

    #[test]
    fn overview_is_what_the_patches_say() {
        for (example, rows, columns) in
            [(saddle as fn(f64, f64) -> _, 3, 4), (paraboloid, 4, 4), (torus_outside, 4, 4)]
        {
            let net = PnNet::new(&data(example, rows, columns), PnMethod::Normalised).unwrap();
            let overview = net.overview(9, true).unwrap();
            let surface = net.surface().unwrap();
            let ranges = surface.radius_ranges();
            let low = ranges.iter().map(|range| range.r1[0]).fold(f64::INFINITY, f64::min);
            let high = ranges.iter().map(|range| range.r2[1]).fold(f64::NEG_INFINITY, f64::max);
            assert!((overview.r1[0] - low).abs() < 1e-9 * (1.0 + low.abs()), "{overview:?} {low}");
            assert!((overview.r2[1] - high).abs() < 1e-9 * (1.0 + high.abs()), "{overview:?} {high}");
            let (one, other) = (overview.limits.unwrap(), surface.safe_distances().unwrap());
            let apart = |a: Option<f64>, b: Option<f64>| (a.unwrap_or(0.0) - b.unwrap_or(0.0)).abs();
            assert!(apart(one.low, other.low) < 1e-9 && apart(one.high, other.high) < 1e-9);
        }
    }

    #[test]
    fn parabolic_patches_have_normals_but_no_radii() {
        let net = PnNet::new(&data(torus_crest, 4, 6), PnMethod::Normalised).unwrap();
        assert!(net.surface().is_err());
        assert!((norm(net.gauss_normal([1, 2], [0.3, 0.7]).unwrap()) - 1.0).abs() < 1e-12);
        assert!(net.gauss_normal([9, 9], [0.0, 0.0]).is_none());
    }

    #[test]
    fn sphere_is_found() {
        let (centre, radius) = data(sphere, 4, 4).sphere().unwrap();
        assert!((radius - 30.0).abs() < 1e-12);
        assert!(norm(scaled_difference(1.0, centre, [2.0, -1.0, 3.0])) < 1e-12);
    }
}
