//! Through a point by one knot and the parameter.

use super::local::{Hom, blossom};
use super::{KnotCurve, KnotError, MAX_ORDER, Through, Unreached};
use crate::geometry::point::check_points;
use crate::geometry::{Point, dot, norm};

/// The starts: values of the knot times parameters.
const GRID: [usize; 2] = [20, 40];
/// The nearest starts that are tried.
const TRIED: usize = 60;
/// Steps of Newton's method.
const STEPS: usize = 40;

impl<const D: usize> KnotCurve<D> {
    /// All curves through a point that moving one knot makes: none, one or two, for any order and weights. In the
    /// plane the point need only be near; in space it must lie on the surface that the moving curve draws.
    ///
    /// # Errors
    /// [`KnotError::Unreached`] without any; [`KnotError::Index`] for a knot that cannot move, [`KnotError::Closed`].
    pub fn through_knot(&self, point: Point<D>, knot: usize) -> Result<Vec<Through<D>>, KnotError> {
        check_points(&[point])?;
        self.vector().copies(knot)?;
        if self.vector().breaks().is_some() {
            return Err(KnotError::Closed);
        }
        let (room, changed) = (self.room(knot), self.changed_spans(knot));
        let (Some(room), [first, .., last] | [first @ last]) = (room, changed.as_slice()) else {
            return Err(KnotError::Idle { knot });
        };
        if room[0] >= room[1] {
            return Err(Unreached::NotFound.into());
        }
        let knots = self.vector().knots();
        // The changed arcs, also where the knot is the end of one.
        let bounds =
            [room, [knots[*first].min(room[0].max(knots[self.vector().order() - 1])), knots[last + 1]]];
        let search = Search { curve: self, point, knot, bounds, size: self.size() };
        let mut found: Vec<[f64; 2]> = Vec::new();
        for start in search.starts() {
            let Some(place) = search.newton(start) else { continue };
            let apart = |other: &[f64; 2]| {
                (0..2).any(|x| (place[x] - other[x]).abs() > 1e-6 * (bounds[x][1] - bounds[x][0]))
            };
            if found.iter().all(apart) {
                found.push(place);
            }
        }
        let solution = |&[value, u]: &[f64; 2]| Some(Through { curve: self.with_knot(knot, value).ok()?, u });
        let all: Vec<Through<D>> = found.iter().filter_map(solution).collect();
        if all.is_empty() { Err(Unreached::NotFound.into()) } else { Ok(all) }
    }

    /// The derivative of the point at `u` by the value of a knot: minus the curve of the control points
    /// `(d_l - d_{l-1}) / (u_{l+k-1} - u_l)` over the knots with this one doubled (Piegl and Tiller 1998).
    #[must_use]
    pub fn derivative_by_knot(&self, knot: usize, u: f64) -> Option<Point<D>> {
        let (knots, order) = (self.vector().knots(), self.vector().order());
        let span = self.vector().span_of(u)?;
        let place = self.homogeneous_in(knots, span, u)?;
        let point = place.point()?;
        let mut doubled = knots.to_vec();
        doubled.insert(knot, *knots.get(knot)?);
        let span = if span < knot { span } else { span + 1 };
        let change = |l: usize| {
            if l == 0 || l >= self.vector().controls() || l + order <= knot || l > knot {
                return Hom::ZERO;
            }
            let width = knots[l + order - 1] - knots[l];
            let factor = if width > 0.0 { 1.0 / width } else { 0.0 };
            self.homogeneous(l - 1).mixed(factor, -factor, self.homogeneous(l))
        };
        let local: [Hom<D>; MAX_ORDER] =
            std::array::from_fn(|l| if l < order { change(span + 1 + l - order) } else { Hom::ZERO });
        let slope = blossom(&doubled, span, &local[..order], 0, 1.0, |_| u)?;
        Some(std::array::from_fn(|d| (slope.p[d] - point[d] * slope.w) / place.w))
    }
}

struct Search<'a, const D: usize> {
    curve: &'a KnotCurve<D>,
    point: Point<D>,
    knot: usize,
    /// Of the knot and of the parameter.
    bounds: [[f64; 2]; 2],
    size: f64,
}

impl<const D: usize> Search<'_, D> {
    fn moved(&self, value: f64) -> Option<KnotCurve<D>> {
        self.curve.with_knot(self.knot, value).ok()
    }

    fn residual(&self, curve: &KnotCurve<D>, u: f64) -> Option<Point<D>> {
        let place = curve.point_at(u)?;
        Some(std::array::from_fn(|d| place[d] - self.point[d]))
    }

    /// The nearest places of a grid.
    fn starts(&self) -> Vec<[f64; 2]> {
        let value = |x: usize, step: usize| {
            let t = step as f64 / GRID[x] as f64;
            (1.0 - t) * self.bounds[x][0] + t * self.bounds[x][1]
        };
        let mut all: Vec<(f64, [f64; 2])> = Vec::new();
        for v in (0..=GRID[0]).map(|step| value(0, step)) {
            let Some(curve) = self.moved(v) else { continue };
            let places = (0..=GRID[1]).map(|step| value(1, step));
            all.extend(places.filter_map(|u| Some((norm(self.residual(&curve, u)?), [v, u]))));
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.into_iter().take(TRIED).map(|(_, place)| place).collect()
    }

    /// Damped steps from a start, clamped to the bounds; `None` if they do not arrive.
    fn newton(&self, start: [f64; 2]) -> Option<[f64; 2]> {
        let mut place = start;
        let mut curve = self.moved(place[0])?;
        let mut off = self.residual(&curve, place[1])?;
        for _ in 0..STEPS {
            if norm(off) <= 1e-14 * self.size {
                break;
            }
            let by_knot = curve.derivative_by_knot(self.knot, place[1])?;
            let by_u = *curve.derivatives(place[1], 1)?.get(1)?;
            let step = least_squares(by_knot, by_u, off)?;
            let mut damping = 1.0;
            let better = loop {
                let next: [f64; 2] = std::array::from_fn(|x| {
                    (place[x] - damping * step[x]).clamp(self.bounds[x][0], self.bounds[x][1])
                });
                let tried =
                    self.moved(next[0]).and_then(|curve| Some((self.residual(&curve, next[1])?, curve)));
                match tried {
                    Some((new, curve)) if norm(new) < norm(off) => break Some((next, new, curve)),
                    _ if damping < 1e-3 => break None,
                    _ => damping *= 0.5,
                }
            };
            let Some((next, new, next_curve)) = better else { break };
            (place, off, curve) = (next, new, next_curve);
        }
        let limit = if D == 2 { 1e-12 } else { 1e-9 };
        (norm(off) <= limit * self.size).then_some(place)
    }
}

/// The `x`, `y` for which `x a + y b` is nearest to `c`; `None` for parallel vectors.
fn least_squares<const D: usize>(a: Point<D>, b: Point<D>, c: Point<D>) -> Option<[f64; 2]> {
    let length = norm(a);
    let unit = a.map(|x| x / length);
    let along = dot(unit, b);
    let rest: Point<D> = std::array::from_fn(|d| b[d] - along * unit[d]);
    let square = dot(rest, rest);
    let y = dot(rest, c) / square;
    let x = (dot(unit, c) - along * y) / length;
    (x.is_finite() && y.is_finite()).then_some([x, y])
}
