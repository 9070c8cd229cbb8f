//! Smoothing of measured points: a B-spline by the points, then a Bézier curve by points of the B-spline.
//!
//! Section 2.3.8 of the book compares the methods on noisy measurements and ends with this advice: make
//! the points a continuous curve by a B-spline, then approach a large number of points of it by a Bézier
//! curve. The B-spline damps noise from point to point; the Bézier curve, whose every point is a mean of
//! many control points, filters what alternates in sign. Peaks become flatter too, and the fewer points
//! of the B-spline the Bézier curve gets, the more: with one for each measured point it loses a narrow
//! peak altogether, so that the large number the book asks for matters. The first and the last point stay where they are.
//!
//! Every measured point has a parameter on the open curves: on the B-spline the joint nearest to it (the
//! middle of a span when the degree is 2), on the Bézier curve by `n` points `i / (n - 1)`. There is no
//! smoothing of closed curves.

use super::binomial::equal_steps;
use super::point::{check_count, check_points, norm};
use super::{Closure, Curve, GeometryError, Method, ParamCurve, Point};

/// The fewest measured points that can be smoothed.
pub const FEWEST_MEASURED: usize = 3;

/// The largest number of control points of the Bézier curve that smooths, [`DENSITY`] for every point of the longest row
/// ([`MAX_POINTS`](super::MAX_POINTS)): they stand in memory together, a quarter of a gigabyte in the plane.
pub const MAX_FILTERED: usize = 1 << 24;

/// The usual number of points of the B-spline for every measured one. The noisy Gauss curve of the
/// samples comes nearest to the clean one by about this many.
pub const DENSITY: usize = 16;

/// The degree of the B-spline that smooths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Degree {
    /// The quadratic B-spline (2.57). It damps less: a point keeps 3/4 of itself.
    Quadratic,
    /// The cubic B-spline (2.58). A point keeps 2/3 of itself.
    Cubic,
}

impl Degree {
    /// The method that draws this B-spline.
    #[must_use]
    pub fn method(self) -> Method {
        match self {
            Self::Quadratic => Method::BSpline2,
            Self::Cubic => Method::BSpline3,
        }
    }

    /// Where measured point `index` (from 0) of `n` lies on the open B-spline: the number of its span plus
    /// `u`. These are the Greville abscissae, but for the cubic's ends, where the curve's ends are.
    pub(super) fn parameter(self, index: usize, n: usize) -> f64 {
        let last = n.saturating_sub(1);
        let index_here = index.min(last) as f64;
        match self {
            _ if index == 0 => 0.0,
            Self::Quadratic if index >= last => (n as f64) - 2.0,
            Self::Quadratic => index_here - 0.5,
            Self::Cubic if index >= last => (n as f64) + 1.0,
            Self::Cubic => index_here + 1.0,
        }
    }
}

/// Which of the two steps are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// The B-spline only.
    BSpline,
    /// The Bézier curve by the measured points themselves.
    Bezier,
    /// The B-spline, then the Bézier curve by its points.
    Both,
}

/// How measured points are smoothed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Smoothing {
    /// The degree of the B-spline.
    pub degree: Degree,
    /// The steps taken.
    pub stage: Stage,
    /// How many points of the B-spline the Bézier curve gets for every measured one, at least 1. With
    /// more of them it follows the B-spline closer: as wide as it smooths, counted in measured points,
    /// falls with the square root of this number.
    pub density: usize,
}

impl Default for Smoothing {
    /// Cubic, both steps, [`DENSITY`] points of the B-spline for every measured one.
    fn default() -> Self {
        Self { degree: Degree::Cubic, stage: Stage::Both, density: DENSITY }
    }
}

impl Smoothing {
    /// The usual smoothing of so many measured points: [`DENSITY`], or as much of it as [`MAX_FILTERED`] allows.
    #[must_use]
    pub fn of(measured: usize) -> Self {
        let usual = Self::default();
        Self { density: usual.density.min(Self::largest_density(measured)), ..usual }
    }

    /// The largest density with which [`Stage::Both`] takes so many measured points; at least 1, which may be too
    /// much as well.
    #[must_use]
    pub fn largest_density(measured: usize) -> usize {
        ((MAX_FILTERED - 1) / measured.saturating_sub(1).max(1)).max(1)
    }

    /// Whether these points can be smoothed so.
    pub(super) fn check<const D: usize>(self, measured: &[Point<D>]) -> Result<(), GeometryError> {
        check_count(measured.len(), FEWEST_MEASURED)?;
        check_points(measured)?;
        match self.stage {
            Stage::BSpline => Ok(()),
            Stage::Bezier => check_filtered(measured.len()),
            Stage::Both => check_density(measured.len(), self.density),
        }
    }
}

/// How far the smoothed points are from the measured ones, in the units of the coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residuals {
    /// The root of the mean square distance.
    pub rms: f64,
    /// The largest distance.
    pub largest: f64,
    /// The number of the first point with this distance, from 1.
    pub at: usize,
}

impl Residuals {
    /// The distances of points from those of the same number; those without a partner are left out, and
    /// without any pair there are no residuals.
    #[must_use]
    pub fn between<const D: usize>(measured: &[Point<D>], smoothed: &[Point<D>]) -> Option<Self> {
        let gap = |(a, b): (&Point<D>, &Point<D>)| norm::<D>(std::array::from_fn(|d| a[d] - b[d]));
        let distances: Vec<f64> = measured.iter().zip(smoothed).map(gap).collect();
        let farther = |best: (usize, f64), next: (usize, f64)| if next.1 > best.1 { next } else { best };
        let (index, largest) = distances.iter().copied().enumerate().reduce(farther)?;
        // By parts of the largest, so that no square overflows.
        let share = |distance: &f64| if largest > 0.0 { (distance / largest).powi(2) } else { 0.0 };
        let mean = distances.iter().map(share).sum::<f64>() / distances.len() as f64;
        Some(Self { rms: largest * mean.sqrt(), largest, at: index + 1 })
    }

    /// The root of the mean square and the largest distance as text: with so many decimals, or with a power of ten
    /// where these would not show two digits of them.
    ///
    /// ```
    /// use grafika::geometry::Residuals;
    ///
    /// let residuals = Residuals { rms: 8.04e-7, largest: 12.0, at: 4 };
    /// assert_eq!(residuals.texts(4), ["8.0e-7", "12.0000"]);
    /// ```
    #[must_use]
    pub fn texts(&self, decimals: usize) -> [String; 2] {
        // The decimals fit into an exponent: there are a few of them.
        let least = 10_f64.powi(1 - decimals.min(300) as i32);
        [self.rms, self.largest].map(|value| match value == 0.0 || (least..1e9).contains(&value) {
            true => format!("{value:.decimals$}"),
            false => format!("{value:.1e}"),
        })
    }
}

/// Smoothed points, as many as were measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Smoothed<const D: usize> {
    /// The smoothed points; the first and the last are the measured ones.
    pub points: Vec<Point<D>>,
    /// How far they are from the measured ones.
    pub residuals: Residuals,
}

/// Smooths a row of measured points.
///
/// # Errors
/// Fewer than [`FEWEST_MEASURED`] points, a bad coordinate, a density of 0, or more than [`MAX_FILTERED`]
/// control points for the Bézier curve.
///
/// ```
/// use grafika::geometry::{Smoothing, smooth};
///
/// // A straight line, measured with an error of 0.3 that changes its sign.
/// let measured: Vec<[f64; 2]> =
///     (0..21).map(|i| [f64::from(i), if i % 2 == 0 { 0.3 } else { -0.3 }]).collect();
/// let smoothed = smooth(&measured, Smoothing::default())?;
/// assert!(smoothed.points[6..15].iter().all(|[_, y]| y.abs() < 0.05));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
pub fn smooth<const D: usize>(
    measured: &[Point<D>],
    smoothing: Smoothing,
) -> Result<Smoothed<D>, GeometryError> {
    smoothing.check(measured)?;
    let Smoothing { degree, stage, density } = smoothing;
    let points = match stage {
        Stage::BSpline => spline_points(measured, degree, 1)?,
        Stage::Bezier => equal_steps(measured, measured.len()),
        Stage::Both => equal_steps(&spline_points(measured, degree, density)?, measured.len()),
    };
    let none = GeometryError::TooFewPoints { given: 0, needed: FEWEST_MEASURED };
    let residuals = Residuals::between(measured, &points).ok_or(none)?;
    Ok(Smoothed { points, residuals })
}

/// Whether the Bézier curve can have so many control points for every measured one.
fn check_density(n: usize, density: usize) -> Result<(), GeometryError> {
    if density == 0 {
        let wanted = "a whole number of at least 1";
        return Err(GeometryError::Parameter { name: "density", value: 0.0, wanted });
    }
    check_filtered(n.saturating_sub(1).saturating_mul(density).saturating_add(1))
}

fn check_filtered(given: usize) -> Result<(), GeometryError> {
    match given <= MAX_FILTERED {
        true => Ok(()),
        false => Err(GeometryError::TooManyPoints { given, most: MAX_FILTERED }),
    }
}

/// The points of the B-spline at the parameters of the measured points, and in equal steps of the
/// parameter between them, `density` steps to each next one.
pub(super) fn spline_points<const D: usize>(
    measured: &[Point<D>],
    degree: Degree,
    density: usize,
) -> Result<Vec<Point<D>>, GeometryError> {
    let n = measured.len();
    let curve = Curve::through(degree.method(), Closure::Open, measured)?;
    let last_span = curve.spans().saturating_sub(1);
    let at = |t: f64| {
        // Positive and at most the number of spans; the end belongs to the last one.
        let span = (t as usize).min(last_span);
        curve.eval(span, t - span as f64)
    };
    let steps = |index: usize| {
        let [from, to] = [index, index + 1].map(|index| degree.parameter(index, n));
        (0..density).map(move |step| from + (to - from) * step as f64 / density as f64)
    };
    let inner = (0..n.saturating_sub(1)).flat_map(steps);
    let parameters = inner.chain([degree.parameter(n.saturating_sub(1), n)]);
    Ok(parameters.filter_map(at).collect())
}

#[cfg(test)]
mod tests {
    use super::super::{Bezier, MAX_POINTS};
    use super::*;
    use proptest::prelude::*;

    const ALL: [Stage; 3] = [Stage::BSpline, Stage::Bezier, Stage::Both];

    fn staged(stage: Stage) -> Smoothing {
        Smoothing { stage, density: 1, ..Smoothing::default() }
    }

    /// Points without any order, the same every time.
    fn scattered<const D: usize>(n: usize) -> Vec<Point<D>> {
        (0..n).map(|i| std::array::from_fn(|d| ((i * (37 + 16 * d)) % 101) as f64 - 50.0)).collect()
    }

    /// The cubic B-spline at its points by (2.58) at u = 0.
    fn direct_spline<const D: usize>(p: &[Point<D>]) -> Vec<Point<D>> {
        let last = p.len() - 1;
        let mean = |i: usize| std::array::from_fn(|d| (p[i - 1][d] + 4.0 * p[i][d] + p[i + 1][d]) / 6.0);
        (0..=last).map(|i| if i == 0 || i == last { p[i] } else { mean(i) }).collect()
    }

    /// The Bézier curve in `n` points by de Casteljau's algorithm (2.50).
    fn direct_bezier<const D: usize>(control: &[Point<D>], n: usize) -> Vec<Point<D>> {
        let at = |u: f64| {
            let mut row = control.to_vec();
            while row.len() > 1 {
                row = row
                    .windows(2)
                    .map(|p| std::array::from_fn(|d| (1.0 - u) * p[0][d] + u * p[1][d]))
                    .collect();
            }
            row[0]
        };
        (0..n).map(|i| at(i as f64 / (n - 1) as f64)).collect()
    }

    fn assert_near<const D: usize>(ours: &[Point<D>], theirs: &[Point<D>], tolerance: f64) {
        assert_eq!(ours.len(), theirs.len());
        for (a, b) in ours.iter().flatten().zip(theirs.iter().flatten()) {
            assert!((a - b).abs() <= tolerance, "{a} {b}");
        }
    }

    fn assert_direct<const D: usize>(n: usize) {
        let measured = scattered::<D>(n);
        let spline = direct_spline(&measured);
        let expected =
            [spline.clone(), direct_bezier(&measured, measured.len()), direct_bezier(&spline, spline.len())];
        for (stage, expected) in ALL.into_iter().zip(expected) {
            let smoothed = smooth(&measured, staged(stage)).unwrap();
            assert_near(&smoothed.points, &expected, 2e-12);
            let distances: Vec<f64> = measured
                .iter()
                .zip(&expected)
                .map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt())
                .collect();
            let rms = (distances.iter().map(|r| r * r).sum::<f64>() / n as f64).sqrt();
            let Residuals { rms: ours, largest, at } = smoothed.residuals;
            assert!((ours - rms).abs() < 1e-11, "{ours} {rms}");
            assert!((largest - distances.iter().fold(0.0, |a, &b| f64::max(a, b))).abs() < 1e-11);
            assert!((distances[at - 1] - largest).abs() < 1e-11);
        }
    }

    #[test]
    fn agrees_with_the_equations_in_the_plane_and_in_space() {
        for n in [3, 4, 5, 6, 15, 41, 99, 300] {
            assert_direct::<2>(n);
            assert_direct::<3>(n);
        }
    }

    #[test]
    fn quadratic_points_are_those_of_the_middle_of_spans() {
        let p = scattered::<2>(9);
        let smoothing = Smoothing { degree: Degree::Quadratic, ..staged(Stage::BSpline) };
        let smoothed = smooth(&p, smoothing).unwrap().points;
        assert_eq!((smoothed[0], smoothed[8]), (p[0], p[8]));
        for i in 2..7 {
            let [x, _] = smoothed[i];
            assert!((x - (p[i - 1][0] + 6.0 * p[i][0] + p[i + 1][0]) / 8.0).abs() < 1e-13);
        }
    }

    #[test]
    fn more_points_of_the_spline_come_closer_to_it() {
        let p = scattered::<2>(12);
        let spline = smooth(&p, staged(Stage::BSpline)).unwrap().points;
        let gap = |density| {
            let smoothed = smooth(&p, Smoothing { density, ..Smoothing::default() }).unwrap();
            assert_eq!(smoothed.points.len(), p.len());
            // The ends of the B-spline have two spans to the next point, so only the middle is compared.
            Residuals::between(&spline[3..9], &smoothed.points[3..9]).unwrap().rms
        };
        let gaps = [1, 4, 16, 64, 256].map(gap);
        assert!(gaps.windows(2).all(|pair| pair[1] < pair[0]), "{gaps:?}");
        // From far to a few units in a field of 100.
        assert!(gaps[4] < 0.15 * gaps[0], "{gaps:?}");
    }

    #[test]
    fn noise_of_alternating_sign_is_damped_as_the_theory_says() {
        for n in [5, 10, 41, 99] {
            let noise = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
            let measured: Vec<Point<2>> = (0..n).map(|i| [i as f64, noise(i)]).collect();
            let degree = (n - 1) as i32;
            for stage in ALL {
                let smoothed = smooth(&measured, staged(stage)).unwrap();
                for (i, [_, y]) in smoothed.points.iter().enumerate().take(n - 1).skip(1) {
                    let u = i as f64 / f64::from(degree);
                    let alternating = (1.0 - 2.0 * u).powi(degree);
                    let ends = (1.0 - u).powi(degree) + noise(n - 1) * u.powi(degree);
                    let (expected, most) = match stage {
                        Stage::BSpline => (noise(i) / 3.0, 1.0 / 3.0),
                        Stage::Bezier => (alternating, (-2.0_f64).exp()),
                        // The ends keep their noise and give their neighbours some of it.
                        Stage::Both => (alternating / 3.0 + 2.0 / 3.0 * ends, 0.3),
                    };
                    assert!((y - expected).abs() < 1e-13, "{n} {stage:?} {i}: {y} {expected}");
                    assert!(y.abs() <= most + 1e-13, "{n} {stage:?} {i}: {y}");
                }
            }
        }
    }

    #[test]
    fn the_usual_density_keeps_the_limit() {
        for n in [3, 2048, 2049, 1_000_000, MAX_POINTS] {
            assert_eq!(Smoothing::of(n).density, DENSITY, "{n}");
            assert!(check_density(n, DENSITY).is_ok(), "{n}");
        }
        for (n, density) in [(2 * MAX_POINTS, 8), (MAX_FILTERED, 1), (2 * MAX_FILTERED, 1)] {
            assert_eq!(Smoothing::of(n).density, density, "{n}");
            assert_eq!(check_density(n, density).is_ok(), n <= MAX_FILTERED, "{n}");
        }
        assert!(check_density(MAX_POINTS, DENSITY + 1).is_err());
    }

    #[test]
    fn bad_input_has_its_sentence() {
        let points = scattered::<2>(5);
        let few = smooth(&points[..2], Smoothing::default());
        assert_eq!(few, Err(GeometryError::TooFewPoints { given: 2, needed: 3 }));
        let none = smooth(&points, Smoothing { density: 0, ..Smoothing::default() });
        assert_eq!(none.unwrap_err().to_string(), "density is 0, but must be a whole number of at least 1");
        let many = smooth(&points, Smoothing { density: usize::MAX, ..Smoothing::default() });
        assert!(matches!(many, Err(GeometryError::TooManyPoints { most: MAX_FILTERED, .. })));
        let bad = smooth(&[[0.0], [f64::NAN], [1.0]], Smoothing::default());
        assert_eq!(bad, Err(GeometryError::NotFinite { number: 2 }));
        let many = smooth(&vec![[0.0]; MAX_POINTS + 1], staged(Stage::Bezier));
        assert!(matches!(many, Err(GeometryError::TooManyPoints { .. })));
    }

    #[test]
    fn the_largest_coordinates_and_equal_points_give_numbers() {
        let far = [[1e150, -1e150], [-1e150, 1e150], [1e150, -1e150], [-1e150, 1e150]];
        for stage in ALL {
            let smoothed = smooth(&far, staged(stage)).unwrap();
            let Residuals { rms, largest, at } = smoothed.residuals;
            assert!(rms > 1e149 && rms <= largest && largest < 3e150 && (2..=3).contains(&at));
            let same = smooth(&[[7.0, 8.0]; 5], staged(stage)).unwrap();
            assert!(same.residuals.largest < 1e-14 && same.residuals.rms <= same.residuals.largest);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn points_at_equal_distances_on_a_line_stay(
            n in 3usize..120,
            from in prop::array::uniform3(-500.0..500.0f64),
            step in prop::array::uniform3(-20.0..20.0f64),
        ) {
            let line: Vec<Point<3>> =
                (0..n).map(|i| std::array::from_fn(|d| from[d] + i as f64 * step[d])).collect();
            for stage in ALL {
                let smoothed = smooth(&line, staged(stage)).unwrap();
                prop_assert!(smoothed.residuals.largest < 1e-10, "{stage:?} {:?}", smoothed.residuals);
            }
            // With other degrees and densities the ends of the B-spline draw their neighbours along.
            for (degree, density) in [(Degree::Quadratic, 1), (Degree::Cubic, 5)] {
                let smoothed = smooth(&line, Smoothing { degree, density, stage: Stage::Both }).unwrap();
                prop_assert!(smoothed.residuals.largest < 0.35 * norm(step) + 1e-10);
            }
        }

        /// By a sum over all weights for every point, as it once was.
        #[test]
        fn the_curve_is_that_of_all_its_control_points(
            points in prop::collection::vec(prop::array::uniform2(-300.0..300.0f64), 3..400),
            density in 1usize..20,
            cubic: bool,
        ) {
            let degree = if cubic { Degree::Cubic } else { Degree::Quadratic };
            let ours = smooth(&points, Smoothing { degree, density, stage: Stage::Both }).unwrap().points;
            let control = spline_points(&points, degree, density).unwrap();
            let curve = Bezier::new(Closure::Open, &control).unwrap();
            let last = (points.len() - 1) as f64;
            let theirs: Vec<Point<2>> = (0..points.len()).map(|i| curve.eval(i as f64 / last)).collect();
            assert_near(&ours, &theirs, 1e-10);
        }

        #[test]
        fn maps_of_the_points_are_maps_of_the_smoothed_points(
            points in prop::collection::vec(prop::array::uniform2(-300.0..300.0f64), 3..60),
            map in prop::array::uniform6(-3.0..3.0f64),
            density in 1usize..4,
            cubic: bool,
        ) {
            let [a, b, c, d, e, f] = map;
            let image = |[x, y]: Point<2>| [a * x + b * y + c, d * x + e * y + f];
            let degree = if cubic { Degree::Cubic } else { Degree::Quadratic };
            for stage in ALL {
                let smoothing = Smoothing { degree, stage, density };
                let before: Vec<Point<2>> = points.iter().copied().map(image).collect();
                let ours = smooth(&before, smoothing).unwrap().points;
                let theirs = smooth(&points, smoothing).unwrap().points;
                for (ours, theirs) in ours.into_iter().zip(theirs.into_iter().map(image)) {
                    prop_assert!((0..2).all(|d| (ours[d] - theirs[d]).abs() < 1e-10), "{ours:?} {theirs:?}");
                }
            }
        }

        #[test]
        fn the_ends_stay_and_all_is_within_the_measured_box(
            points in prop::collection::vec(prop::array::uniform2(-300.0..300.0f64), 3..60),
            density in 1usize..4,
        ) {
            let smoothed = smooth(&points, Smoothing { density, ..Smoothing::default() }).unwrap().points;
            prop_assert_eq!(smoothed.len(), points.len());
            prop_assert_eq!(smoothed.first(), points.first());
            prop_assert_eq!(smoothed.last(), points.last());
            for axis in 0..2 {
                let values = || points.iter().map(|point| point[axis]);
                let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
                let within = smoothed.iter().all(|p| p[axis] >= low - 1e-10 && p[axis] <= high + 1e-10);
                prop_assert!(within);
            }
        }
    }
}
