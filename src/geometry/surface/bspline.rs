//! A surface as one B-spline surface, the form in which other programs take exact surfaces.
//!
//! Nothing is fitted: the control points are the blossoms of the patches at the knots, and a knot is as often
//! there as the method's smoothness asks. The borders are clamped, those of a closed direction too, so that
//! the surface begins and ends in its outer control points.

use super::{Body, Direction, Patch, Surface};
use crate::geometry::point::lerp;
use crate::geometry::{CubicBezier, Point};

/// Joints of a closed direction and points of a pole that differ by no more than this part of the largest
/// coordinate are the same point but for rounding.
const ROUNDING: f64 = 1e-12;

/// A B-spline surface over clamped knots. Direction 0 is `u`, 1 is `v`.
#[derive(Clone, Debug, PartialEq)]
pub struct BSplineSurface {
    /// The degrees.
    pub degrees: [usize; 2],
    /// The different knots, ascending from 0.
    pub knots: [Vec<f64>; 2],
    /// How often each knot is there; the first and the last once more than the degree.
    pub multiplicities: [Vec<usize>; 2],
    /// The control points: row `k` counts in the direction of `u`, point `l` of it in that of `v`.
    pub net: Vec<Vec<Point<3>>>,
}

impl Surface {
    /// The whole surface as one B-spline surface. A span is as long in its parameters as
    /// [`Surface::lengths`] says, so that span (i, j) at (u, v) is the point at the sum of the lengths before
    /// plus `u` and `v` times its own. Inner knots are simple where the second derivatives are continuous
    /// (spline, cubic B-spline), double where the first ones are (quadratic B-spline, local spline,
    /// beta-spline of bias 1) and triple for other beta-splines. A Bézier net keeps its degrees.
    ///
    /// Seams and poles are closed exactly, where they are closed but for rounding.
    #[must_use]
    pub fn to_bspline(&self) -> BSplineSurface {
        let mut surface = match &self.body {
            Body::Patches(patches) => self.of_spans(patches),
            Body::Bezier(net) => of_bezier(net),
        };
        surface.close(self.closed());
        surface
    }

    fn of_spans(&self, patches: &[Patch]) -> BSplineSurface {
        let [u, v] = [0, 1].map(|d| Axis::new(&self.lengths(d), self.directions[d]));
        let spans = self.directions[1].spans;
        let at = |i: usize, j: usize| patches.get(i * spans + j).map_or([[[0.0; 3]; 4]; 4], |patch| patch.p);
        // Along v for the four rows of every patch, then along u for every column of the results.
        let rows: Vec<[Vec<Point<3>>; 4]> = (0..self.directions[0].spans)
            .map(|i| std::array::from_fn(|r| v.control_points(|j| CubicBezier { p: at(i, j)[r] })))
            .collect();
        let columns: Vec<Vec<Point<3>>> = (0..v.control_count())
            .map(|l| {
                let point = |row: &Vec<Point<3>>| row.get(l).copied().unwrap_or([0.0; 3]);
                u.control_points(|i| CubicBezier {
                    p: rows.get(i).map_or([[0.0; 3]; 4], |rows| rows.each_ref().map(point)),
                })
            })
            .collect();
        let net = (0..u.control_count())
            .map(|k| columns.iter().filter_map(|column| column.get(k).copied()).collect())
            .collect();
        let multiplicities = [u.multiplicities, v.multiplicities];
        BSplineSurface { degrees: [3; 2], knots: [u.breaks, v.breaks], multiplicities, net }
    }
}

/// The Bézier patch of a net, whose knots are 0 and 1.
fn of_bezier(net: &[Vec<Point<3>>]) -> BSplineSurface {
    let counts = [net.len(), net.first().map_or(0, Vec::len)];
    BSplineSurface {
        degrees: counts.map(|count| count.saturating_sub(1)),
        knots: [vec![0.0, 1.0], vec![0.0, 1.0]],
        multiplicities: counts.map(|count| vec![count, count]),
        net: net.to_vec(),
    }
}

/// The knots of a cubic direction.
struct Axis {
    lengths: Vec<f64>,
    breaks: Vec<f64>,
    multiplicities: Vec<usize>,
    /// Which break every knot is.
    which: Vec<usize>,
}

impl Axis {
    fn new(lengths: &[f64], direction: Direction) -> Self {
        let mut breaks = vec![0.0];
        // Whole and half numbers: the sums are exact.
        breaks.extend(lengths.iter().scan(0.0, |sum, length| {
            *sum += length;
            Some(*sum)
        }));
        let last = lengths.len();
        let inner = 3 - direction.smoothness.min(2);
        let multiplicities: Vec<usize> =
            (0..=last).map(|k| if k == 0 || k == last { 4 } else { inner }).collect();
        let which = repeated(&multiplicities).collect();
        Self { lengths: lengths.to_vec(), breaks, multiplicities, which }
    }

    fn control_count(&self) -> usize {
        self.which.len().saturating_sub(4)
    }

    /// The control points of the spline whose spans are these arcs: point `i` is the blossom of a span in its
    /// support at knots i + 1, i + 2 and i + 3.
    fn control_points(&self, arc: impl Fn(usize) -> CubicBezier<3>) -> Vec<Point<3>> {
        let point = |knots: &[usize]| {
            let &[_, a, b, c] = knots else { return [0.0; 3] };
            // The span that begins at the middle knot, or the one that ends there.
            let span = if c > b || b == 0 { b } else { b - 1 };
            let (start, length) = (self.breaks[span], self.lengths[span]);
            arc(span).blossom([a, b, c].map(|knot| (self.breaks[knot] - start) / length))
        };
        self.which.windows(4).take(self.control_count()).map(point).collect()
    }
}

/// Every index as often as its multiplicity says.
fn repeated(multiplicities: &[usize]) -> impl Iterator<Item = usize> + '_ {
    multiplicities.iter().enumerate().flat_map(|(k, &count)| std::iter::repeat_n(k, count))
}

impl BSplineSurface {
    /// All knots of a direction, each as often as it counts.
    #[must_use]
    pub fn knot_vector(&self, direction: usize) -> Vec<f64> {
        match (self.knots.get(direction), self.multiplicities.get(direction)) {
            (Some(knots), Some(counts)) => {
                repeated(counts).filter_map(|index| knots.get(index).copied()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The point at parameters of the knots, which are clipped to them, by de Boor's scheme. `None` when
    /// knots, degrees and net do not belong together.
    #[must_use]
    pub fn eval(&self, s: f64, t: f64) -> Option<Point<3>> {
        let [u, v] = [self.knot_vector(0), self.knot_vector(1)];
        let row: Option<Vec<Point<3>>> =
            self.net.iter().map(|row| de_boor(self.degrees[1], &v, row, t)).collect();
        de_boor(self.degrees[0], &u, &row?, s)
    }

    /// The curve of control points that bounds the surface at the beginning (or else at the end) of `u`
    /// (direction 0) or `v`.
    #[must_use]
    pub fn border(&self, direction: usize, end: Rim) -> Vec<Point<3>> {
        let row = match (direction, end) {
            (0, Rim::First) => self.net.first().cloned(),
            (0, Rim::Last) => self.net.last().cloned(),
            (_, Rim::First) => self.net.iter().map(|row| row.first().copied()).collect(),
            (_, Rim::Last) => self.net.iter().map(|row| row.last().copied()).collect(),
        };
        row.unwrap_or_default()
    }

    /// Whether a border is a single point, as at the pole of a sphere.
    #[must_use]
    pub fn is_pole(&self, direction: usize, end: Rim) -> bool {
        let border = self.border(direction, end);
        border.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// Makes points that differ by rounding the same: at seams and at poles.
    fn close(&mut self, closed: [bool; 2]) {
        let largest = self.net.iter().flatten().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        let near =
            |a: &Point<3>, b: &Point<3>| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= ROUNDING * largest);
        if let ([first, .., last], true) = (self.net.as_mut_slice(), closed[0]) {
            last.clone_from(first);
        }
        for row in &mut self.net {
            if let ([first, .., last], true) = (row.as_mut_slice(), closed[1]) {
                *last = *first;
            }
            if let [first, rest @ ..] = row.as_mut_slice()
                && rest.iter().all(|point| near(first, point))
            {
                rest.fill(*first);
            }
        }
        for end in [Rim::First, Rim::Last] {
            let column = self.border(1, end);
            let Some(&pole) = column.first().filter(|pole| column.iter().all(|point| near(pole, point)))
            else {
                continue;
            };
            for row in &mut self.net {
                let place = if end == Rim::First { row.first_mut() } else { row.last_mut() };
                if let Some(place) = place {
                    *place = pole;
                }
            }
        }
    }
}

/// An end of a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rim {
    /// Where the parameter begins.
    First,
    /// Where it ends.
    Last,
}

/// The point of a B-spline curve with all its knots.
fn de_boor(degree: usize, knots: &[f64], points: &[Point<3>], t: f64) -> Option<Point<3>> {
    if points.len() <= degree || knots.len() != points.len() + degree + 1 {
        return None;
    }
    let t = t.clamp(*knots.first()?, knots.last()?.max(*knots.first()?));
    // The last span that begins at or before t, and is not the empty one behind the last knot.
    let span = (degree..points.len()).rev().find(|&j| knots[j] <= t && knots[j] < knots[j + 1])?;
    let mut d: Vec<Point<3>> = points.get(span - degree..=span)?.to_vec();
    for round in 1..=degree {
        for j in (round..=degree).rev() {
            let (from, to) = (knots[span - degree + j], knots[span + 1 + j - round]);
            d[j] = lerp(d[j - 1], d[j], (t - from) / (to - from));
        }
    }
    d.last().copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Border, Method, Scheme, Topology};
    use proptest::prelude::*;

    fn method() -> impl Strategy<Value = Method> {
        prop_oneof![
            Just(Method::Spline),
            Just(Method::BSpline2),
            Just(Method::BSpline3),
            (-1.0..1.0).prop_map(|k0| Method::Local { k0 }),
            (0.3..3.0, 0.0..9.0).prop_map(|(bias, tension)| Method::Beta { bias, tension }),
            (0.0..9.0).prop_map(|tension| Method::Beta { bias: 1.0, tension }),
        ]
    }

    fn net(rows: usize, columns: usize) -> impl Strategy<Value = Vec<Vec<Point<3>>>> {
        prop::collection::vec(prop::collection::vec(prop::array::uniform3(-100.0..100.0), columns), rows)
    }

    fn size(surface: &Surface) -> f64 {
        let bounds = surface.bounding_box().unwrap();
        bounds.min.iter().chain(&bounds.max).fold(0.0, |m, x| m.max(x.abs()))
    }

    /// The largest distance between a surface and its B-spline form, by the size of the surface.
    fn apart(surface: &Surface, form: &BSplineSurface) -> f64 {
        let mut worst = 0.0_f64;
        let lengths = [surface.lengths(0), surface.lengths(1)];
        for (i, j) in (0..lengths[0].len()).flat_map(|i| (0..lengths[1].len()).map(move |j| (i, j))) {
            for (u, v) in [(0.0, 0.0), (0.3, 0.8), (0.5, 0.1), (1.0, 1.0)] {
                let s = form.knots[0][i] + u * lengths[0][i];
                let t = form.knots[1][j] + v * lengths[1][j];
                let (one, other) = (surface.eval(i, j, u, v).unwrap(), form.eval(s, t).unwrap());
                worst = one.iter().zip(other).fold(worst, |m, (a, b)| m.max((a - b).abs()));
            }
        }
        worst / size(surface)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]
        #[test]
        fn is_the_same_surface(
            u in method(), v in method(), mut net in net(6, 5),
            topology in prop::sample::select(vec![Topology::Open, Topology::Sphere, Topology::Torus]),
            border in prop::sample::select(vec![Border::Doubled, Border::Reached]),
        ) {
            if topology == Topology::Sphere {
                let (north, south) = (net[0][0], net[0][4]);
                net.iter_mut().for_each(|row| { row[0] = north; row[4] = south; });
            }
            let surface = Surface::new(Scheme { u, v, topology, border }, &net).unwrap();
            let form = surface.to_bspline();
            prop_assert!(apart(&surface, &form) < 1e-12, "{}", apart(&surface, &form));
            for d in 0..2 {
                let count = if d == 0 { form.net.len() } else { form.net[0].len() };
                prop_assert_eq!(form.knot_vector(d).len(), count + 4);
            }
            if surface.closed()[0] {
                prop_assert_eq!(form.border(0, Rim::First), form.border(0, Rim::Last));
            }
            let closes = !matches!(v, Method::BSpline3) || border == Border::Reached;
            if topology == Topology::Sphere && closes {
                prop_assert!(form.is_pole(1, Rim::First) && form.is_pole(1, Rim::Last));
            }
        }

        #[test]
        fn bezier_nets_keep_their_degrees(net in net(6, 4)) {
            let surface = Surface::new(Scheme::new(Method::Bezier, Topology::Open), &net).unwrap();
            let form = surface.to_bspline();
            prop_assert_eq!((form.degrees, &form.net), ([5, 3], &net));
            prop_assert!(apart(&surface, &form) < 1e-13);
        }
    }

    #[test]
    fn cubic_b_splines_get_their_own_net_back() {
        // Inside, the control points of a uniform cubic B-spline are the net itself.
        let net: Vec<Vec<Point<3>>> = (0..7_u8)
            .map(|k| (0..6_u8).map(|l| [f64::from(k), f64::from(l), f64::from(k * l % 5)]).collect())
            .collect();
        let surface = Surface::new(Scheme::new(Method::BSpline3, Topology::Open), &net).unwrap();
        let form = surface.to_bspline();
        assert_eq!(form.multiplicities, [vec![4, 1, 1, 1, 1, 1, 4], vec![4, 1, 1, 1, 1, 4]]);
        for (k, l) in (2..5).flat_map(|k| (2..4).map(move |l| (k, l))) {
            let (ours, theirs) = (form.net[k + 1][l + 1], net[k][l]);
            assert!(ours.iter().zip(theirs).all(|(a, b)| (a - b).abs() < 1e-13), "{ours:?} {theirs:?}");
        }
    }

    #[test]
    fn what_does_not_belong_together_has_no_points() {
        let surface = Surface::new(Scheme::new(Method::Bezier, Topology::Open), &vec![vec![[1.0; 3]; 2]; 2]);
        let form = surface.unwrap().to_bspline();
        assert_eq!(form.eval(9.0, -9.0), Some([1.0; 3]));
        assert_eq!(BSplineSurface { degrees: [7, 7], ..form.clone() }.eval(0.0, 0.0), None);
        assert_eq!(BSplineSurface { net: Vec::new(), ..form }.eval(0.0, 0.0), None);
    }
}
