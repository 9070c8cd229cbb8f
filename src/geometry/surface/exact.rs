//! A surface of patches as one B-spline surface.
//!
//! Nothing is fitted: the control points are the blossoms of the patches at the knots, and a knot is as often
//! there as the method's smoothness asks. The borders are clamped, those of a closed direction too, so that
//! the surface begins and ends in its outer control points.

use super::bspline::repeated;
use super::scheme::Direction;
use super::{BSplineSurface, Patch};
use crate::geometry::{CubicBezier, Point};

/// The surface of patches, row by row, in spans of these lengths.
///
/// A span is as long in its parameters as its length says, so that span (i, j) at (u, v) is the point at the sum
/// of the lengths before plus `u` and `v` times its own. Inner knots are simple where the second derivatives are
/// continuous (spline, cubic B-spline), double where the first ones are (quadratic B-spline, local spline,
/// beta-spline of bias 1) and triple for other beta-splines.
pub(super) fn of_patches(patches: &[Patch], directions: [Direction; 2]) -> BSplineSurface {
    let [u, v] = directions.map(Axis::new);
    let [rows, spans] = directions.map(|direction| direction.spans);
    let at = |i: usize, j: usize| patches.get(i * spans + j).map_or([[[0.0; 3]; 4]; 4], |patch| patch.p);
    // Along v for the four rows of every patch, then along u for every column of the results.
    let rows: Vec<[Vec<Point<3>>; 4]> = (0..rows)
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
    let mut surface =
        BSplineSurface { degrees: [3; 2], knots: [u.breaks, v.breaks], multiplicities, net, weights: None };
    surface.close(directions.map(|direction| direction.closed));
    surface
}

/// The Bézier patch of a net, whose knots are 0 and 1; it keeps its degrees.
pub(super) fn of_bezier(net: &[Vec<Point<3>>]) -> BSplineSurface {
    let counts = [net.len(), net.first().map_or(0, Vec::len)];
    let mut surface = BSplineSurface {
        degrees: counts.map(|count| count.saturating_sub(1)),
        knots: [vec![0.0, 1.0], vec![0.0, 1.0]],
        multiplicities: counts.map(|count| vec![count, count]),
        net: net.to_vec(),
        weights: None,
    };
    surface.close([false; 2]);
    surface
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
    fn new(direction: Direction) -> Self {
        let lengths = direction.lengths();
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
        Self { lengths, breaks, multiplicities, which }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Border, Method, ParamSurface, Rim, Scheme, Surface, Topology};
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
                let (one, other) = (surface.eval([i, j], [u, v]).unwrap(), form.eval(s, t).unwrap());
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
            let form = surface.to_bspline().unwrap();
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
            let form = surface.to_bspline().unwrap();
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
        let form = surface.to_bspline().unwrap();
        assert_eq!(form.multiplicities, [vec![4, 1, 1, 1, 1, 1, 4], vec![4, 1, 1, 1, 1, 4]]);
        for (k, l) in (2..5).flat_map(|k| (2..4).map(move |l| (k, l))) {
            let (ours, theirs) = (form.net[k + 1][l + 1], net[k][l]);
            assert!(ours.iter().zip(theirs).all(|(a, b)| (a - b).abs() < 1e-13), "{ours:?} {theirs:?}");
        }
    }

    #[test]
    fn what_does_not_belong_together_has_no_points() {
        let surface = Surface::new(Scheme::new(Method::Bezier, Topology::Open), &vec![vec![[1.0; 3]; 2]; 2]);
        let form = surface.unwrap().to_bspline().unwrap();
        assert_eq!(form.eval(9.0, -9.0), Some([1.0; 3]));
        assert_eq!(BSplineSurface { degrees: [7, 7], ..form.clone() }.eval(0.0, 0.0), None);
        assert_eq!(BSplineSurface { net: Vec::new(), ..form }.eval(0.0, 0.0), None);
    }
}
