//! Every method against an independent route: other formulas, dense elimination, exact integers.
//! The agreement asked for is 1e-12 of the control polygon's size, for 3 to 99 points, open and
//! closed, with double and triple points.

use grafika::geometry::{Closure, Curve, Ends, GeometryError, Method, ParamCurve, Point, Weights};

const SIZE: f64 = 560.0;
const TOLERANCE: f64 = 1e-12 * SIZE;
const COUNTS: [usize; 8] = [3, 4, 5, 6, 9, 20, 50, 99];
const CLOSURES: [Closure; 2] = [Closure::Open, Closure::Closed];

/// Whole coordinates from a small generator, with a double and a triple point when there is room.
fn polygon(n: usize) -> Vec<Point<3>> {
    let mut state = 12345_u64 + n as u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((state >> 33) % 561) as f64
    };
    let mut points: Vec<Point<3>> = (0..n).map(|_| [next(), next(), next()]).collect();
    if n >= 5 {
        points[1] = points[0];
    }
    if n >= 9 {
        points[4] = points[3];
        points[5] = points[3];
    }
    points
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    (0..3).map(|d| (a[d] - b[d]).abs()).fold(0.0, f64::max)
}

/// The largest distance from `expected(points, span, u)` over all spans and several parameters.
fn largest_difference(
    method: Method,
    closure: Closure,
    points: &[Point<3>],
    expected: impl Fn(usize, f64) -> Point<3>,
) -> f64 {
    let curve = Curve::through(method, closure, points).unwrap();
    let mut largest = 0.0_f64;
    for sample in curve.sample(7).unwrap() {
        let want = expected(sample.span, sample.u);
        largest = largest.max(distance(sample.point, want));
        largest = largest.max(distance(curve.eval(sample.span, sample.u).unwrap(), want));
    }
    largest
}

/// Sum of weights times points.
fn combine(terms: &[(f64, Point<3>)]) -> Point<3> {
    std::array::from_fn(|d| terms.iter().map(|(w, p)| w * p[d]).sum())
}

/// Point number `i`, held at the ends of an open polygon, wrapped round a closed one.
fn at(points: &[Point<3>], closure: Closure, i: isize) -> Point<3> {
    let n = points.len() as isize;
    let index = match closure {
        Closure::Open => i.clamp(0, n - 1),
        Closure::Closed => i.rem_euclid(n),
    };
    points[index as usize]
}

/// Equations (2.12)-(2.15) as they stand.
fn coons(points: &[Point<3>], closure: Closure, k0: f64, span: usize, u: f64) -> Point<3> {
    let i = span as isize;
    let p = |i| at(points, closure, i);
    let tangent = |i: isize| combine(&[(k0, p(i + 1)), (-k0, p(i - 1))]);
    let (u2, u3) = (u * u, u * u * u);
    combine(&[
        (2.0 * u3 - 3.0 * u2 + 1.0, p(i)),
        (-2.0 * u3 + 3.0 * u2, p(i + 1)),
        (u3 - 2.0 * u2 + u, tangent(i)),
        (u3 - u2, tangent(i + 1)),
    ])
}

#[test]
fn coons_and_local_agree_with_the_direct_formula() {
    for n in COUNTS {
        let points = polygon(n);
        for closure in CLOSURES {
            for k0 in [0.5, 1.0, -5.0, 0.0, 10.0] {
                let expected = |span, u| coons(&points, closure, k0, span, u);
                let scale = 1.0 + f64::abs(k0);
                for method in [Method::Coons { k0 }, Method::Local { k0 }] {
                    let difference = largest_difference(method, closure, &points, expected);
                    assert!(difference < TOLERANCE * scale, "n {n} {closure:?} {k0}: {difference:e}");
                }
            }
        }
    }
}

#[test]
fn overhauser_is_coons_with_one_half() {
    // (2.16)-(2.17): two parabolas blended.
    let points = polygon(9);
    let overhauser = |span: usize, u: f64| {
        let p = |i: isize| at(&points, Closure::Closed, span as isize + i);
        let v = 1.0 - u;
        let before = [u * (u - 1.0) / 2.0, (u + 1.0) * v, u * (u + 1.0) / 2.0];
        let after = [v * (2.0 - u) / 2.0, u * (2.0 - u), u * (u - 1.0) / 2.0];
        combine(&[
            (v * before[0], p(-1)),
            (v * before[1] + u * after[0], p(0)),
            (v * before[2] + u * after[1], p(1)),
            (u * after[2], p(2)),
        ])
    };
    let half = Method::Coons { k0: 0.5 };
    assert!(largest_difference(half, Closure::Closed, &points, overhauser) < TOLERANCE);
    // The comparison can fail: another factor is far away.
    let other = Method::Coons { k0: 0.50001 };
    assert!(largest_difference(other, Closure::Closed, &points, overhauser) > 1e6 * TOLERANCE);
}

/// Gaussian elimination with row exchange.
fn solve_dense(mut rows: Vec<Vec<f64>>, mut rhs: Vec<Point<3>>) -> Vec<Point<3>> {
    let n = rhs.len();
    for column in 0..n {
        let pivot =
            (column..n).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs())).unwrap();
        rows.swap(column, pivot);
        rhs.swap(column, pivot);
        for row in column + 1..n {
            let factor = rows[row][column] / rows[column][column];
            if factor != 0.0 {
                let (above, below) = rows.split_at_mut(row);
                for (x, y) in below[0].iter_mut().zip(&above[column]).skip(column) {
                    *x -= factor * y;
                }
                rhs[row] = combine(&[(1.0, rhs[row]), (-factor, rhs[column])]);
            }
        }
    }
    for row in (0..n).rev() {
        for column in row + 1..n {
            rhs[row] = combine(&[(1.0, rhs[row]), (-rows[row][column], rhs[column])]);
        }
        rhs[row] = rhs[row].map(|x| x / rows[row][row]);
    }
    rhs
}

/// All power coefficients of all spans of the spline from its conditions, nothing else: each span
/// joins its points, first and second derivatives agree at joints, natural or periodic ends.
fn spline_coefficients(points: &[Point<3>], closure: Closure) -> Vec<[Point<3>; 4]> {
    let n = points.len();
    let spans = if closure == Closure::Open { n - 1 } else { n };
    let mut rows = Vec::new();
    let mut rhs = Vec::new();
    let mut equation = |terms: &[(usize, f64)], value: Point<3>| {
        let mut row = vec![0.0; 4 * spans];
        for &(unknown, factor) in terms {
            row[unknown] += factor;
        }
        rows.push(row);
        rhs.push(value);
    };
    for s in 0..spans {
        let (a, next) = (4 * s, 4 * ((s + 1) % spans));
        equation(&[(a, 1.0)], points[s]);
        equation(&[(a, 1.0), (a + 1, 1.0), (a + 2, 1.0), (a + 3, 1.0)], points[(s + 1) % n]);
        if s + 1 < spans || closure == Closure::Closed {
            equation(&[(a + 1, 1.0), (a + 2, 2.0), (a + 3, 3.0), (next + 1, -1.0)], [0.0; 3]);
            equation(&[(a + 2, 2.0), (a + 3, 6.0), (next + 2, -2.0)], [0.0; 3]);
        }
    }
    if closure == Closure::Open {
        let last = 4 * (spans - 1);
        equation(&[(2, 1.0)], [0.0; 3]);
        equation(&[(last + 2, 2.0), (last + 3, 6.0)], [0.0; 3]);
    }
    solve_dense(rows, rhs).chunks(4).map(|c| [c[0], c[1], c[2], c[3]]).collect()
}

#[test]
fn spline_agrees_with_dense_elimination_of_its_conditions() {
    for n in COUNTS {
        let points = polygon(n);
        for closure in CLOSURES {
            let spans = spline_coefficients(&points, closure);
            let expected = |span: usize, u: f64| {
                let [a, b, c, d] = spans[span];
                combine(&[(1.0, a), (u, b), (u * u, c), (u * u * u, d)])
            };
            let difference = largest_difference(Method::Spline, closure, &points, expected);
            assert!(difference < TOLERANCE, "n {n} {closure:?}: {difference:e}");
        }
        // The comparison can fail: the open spline is not the closed one.
        let closed = spline_coefficients(&points, Closure::Closed);
        let curve = Curve::through(Method::Spline, Closure::Open, &points).unwrap();
        assert!(distance(curve.at(0, 0.0).unwrap()[1], closed[0][1]) > 1e-3);
    }
}

#[test]
fn spline_by_two_points_is_a_straight_line() {
    let points = [[1.0, 2.0, 3.0], [4.0, 8.0, -3.0]];
    let curve = Curve::through(Method::Spline, Closure::Open, &points).unwrap();
    for u in [0.0, 0.3, 0.5, 1.0] {
        let want = combine(&[(1.0 - u, points[0]), (u, points[1])]);
        assert!(distance(curve.eval(0, u).unwrap(), want) < 1e-14);
    }
}

/// Cox and de Boor's recursion for basis function `i` of `degree` over `knots`, on the interval
/// number `interval`.
fn cox_de_boor(knots: &[f64], interval: usize, i: usize, degree: usize, t: f64) -> f64 {
    if degree == 0 {
        return f64::from(u8::from(i == interval));
    }
    let share = |from: f64, to: f64, t: f64| if to > from { (t - from) / (to - from) } else { 0.0 };
    let rising = share(knots[i], knots[i + degree], t);
    let falling = if knots[i + degree + 1] > knots[i + 1] {
        1.0 - share(knots[i + 1], knots[i + degree + 1], t)
    } else {
        0.0
    };
    rising * cox_de_boor(knots, interval, i, degree - 1, t)
        + falling * cox_de_boor(knots, interval, i + 1, degree - 1, t)
}

#[test]
fn open_quadratic_bspline_is_the_clamped_uniform_one() {
    for n in COUNTS {
        let points = polygon(n);
        // 0, 0, 0, 1, 2, …, n - 2, n - 2, n - 2
        let knots: Vec<f64> = (0..n + 3).map(|k| (k as f64 - 2.0).clamp(0.0, (n - 2) as f64)).collect();
        let expected = |span: usize, u: f64| {
            let basis = |i| cox_de_boor(&knots, span + 2, i, 2, span as f64 + u);
            let terms: Vec<_> = points.iter().enumerate().map(|(i, &p)| (basis(i), p)).collect();
            combine(&terms)
        };
        let difference = largest_difference(Method::BSpline2, Closure::Open, &points, expected);
        assert!(difference < TOLERANCE, "n {n}: {difference:e}");
    }
}

/// The uniform B-spline of a degree by truncated powers, centred on 0.
fn truncated_powers(degree: i32, t: f64) -> f64 {
    let order = degree + 1;
    let (mut sum, mut binomial, mut factorial) = (0.0, 1.0, 1.0);
    for k in 0..=order {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        sum += sign * binomial * (t + f64::from(order) / 2.0 - f64::from(k)).max(0.0).powi(degree);
        binomial *= f64::from(order - k) / f64::from(k + 1);
    }
    (1..=degree).for_each(|k| factorial *= f64::from(k));
    sum / factorial
}

/// The uniform B-spline by truncated powers over the points `span + first ..`, whose middle is
/// where the parameter begins.
fn by_truncated_powers(points: &[Point<3>], closure: Closure, degree: i32, span: isize, u: f64) -> Point<3> {
    let start = if degree == 2 { -0.5 } else { 0.0 };
    let terms: Vec<_> = (-4..=5)
        .map(|j| (truncated_powers(degree, start + u - j as f64), at(points, closure, span + j)))
        .collect();
    combine(&terms)
}

#[test]
fn closed_bsplines_and_the_open_cubic_agree_with_truncated_powers() {
    for n in COUNTS {
        let points = polygon(n);
        let check = |method, closure, degree, shift: isize| {
            let expected =
                |span: usize, u| by_truncated_powers(&points, closure, degree, span as isize + shift, u);
            let difference = largest_difference(method, closure, &points, expected);
            assert!(difference < TOLERANCE, "n {n} {method:?} {closure:?}: {difference:e}");
        };
        check(Method::BSpline2, Closure::Closed, 2, 0);
        check(Method::BSpline3, Closure::Closed, 3, 0);
        // Triple end points: one more span before the first control point.
        check(Method::BSpline3, Closure::Open, 3, -1);
    }
}

#[test]
fn open_bsplines_begin_and_end_exactly_in_the_end_points() {
    for n in COUNTS {
        let points = polygon(n);
        for method in [Method::BSpline2, Method::BSpline3, Method::Beta { bias: 1.7, tension: -3.0 }] {
            let arcs = Weights::new(method, Closure::Open, n).unwrap().arcs(&points).unwrap();
            assert_eq!(arcs[0].p[0], points[0], "{method:?}");
            assert_eq!(arcs[arcs.len() - 1].p[3], points[n - 1], "{method:?}");
        }
    }
}

#[test]
fn three_points_of_the_open_quadratic_bspline_are_one_parabola() {
    let points = [[0.0, 0.0], [2.0, 4.0], [6.0, 1.0]];
    let curve = Curve::through(Method::BSpline2, Closure::Open, &points).unwrap();
    let bezier = Curve::through(Method::Bezier, Closure::Open, &points).unwrap();
    assert_eq!(curve.spans(), 1);
    for u in [0.0, 0.25, 0.5, 0.9, 1.0] {
        let (a, b) = (curve.eval(0, u).unwrap(), bezier.eval(0, u).unwrap());
        assert!((a[0] - b[0]).abs() < 1e-14 && (a[1] - b[1]).abs() < 1e-14);
    }
}

#[test]
fn span_counts() {
    let spans = |method, ends, n| Weights::with_ends(method, ends, n).unwrap().spans();
    let beta = Method::Beta { bias: 1.0, tension: 0.0 };
    let coons = Method::Coons { k0: 0.5 };
    let table = [
        (Method::BSpline2, [5, 7, 7, 5]),
        (Method::BSpline3, [8, 7, 6, 4]),
        (beta, [6, 7, 6, 4]),
        (coons, [6, 7, 6, 4]),
    ];
    for (method, counts) in table {
        for (ends, count) in
            [Ends::Open, Ends::Closed, Ends::Doubled, Ends::Auxiliary].into_iter().zip(counts)
        {
            assert_eq!(spans(method, ends, 7), count, "{method:?} {ends:?}");
        }
    }
    assert_eq!(spans(Method::Spline, Ends::Open, 7), 6);
    assert_eq!(spans(Method::Spline, Ends::Closed, 7), 7);
    let error = Weights::with_ends(Method::Spline, Ends::Doubled, 7).map(|_| ());
    assert_eq!(error, Err(GeometryError::EndsNotOffered { method: "spline" }));
    let error = Weights::new(Method::Bezier, Closure::Open, 7).map(|_| ());
    assert_eq!(error, Err(GeometryError::NotPiecewise { method: "bezier" }));
}

/// (2.63) with the weights as chapter 3 prints them (3.41), on the window of four points.
fn beta(window: [Point<3>; 4], b1: f64, b2: f64, u: f64) -> Point<3> {
    let (c2, c3) = (b1 * b1, b1 * b1 * b1);
    let delta = c3 + 2.0 * (c2 + b1) + b2 + 1.0;
    let (f2, f3, f4) = (u * u * (3.0 - u), u * (3.0 - u * u), 3.0 * u * u - 2.0 * u * u * u);
    let w = (1.0 - u).powi(3);
    let weights = [
        c3 * w,
        c3 * (1.0 - w) + c2 * (2.0 - f2) + b1 * (2.0 - f3) + b2 * (1.0 - f4),
        c2 * f2 + b1 * f3 + b2 * f4 + 1.0 - u * u * u,
        u * u * u,
    ];
    let terms: Vec<_> = weights.iter().map(|w| w / delta).zip(window).collect();
    combine(&terms)
}

#[test]
fn beta_spline_agrees_with_the_printed_weights() {
    let parameters =
        [(1.0, 0.0), (1.0, 10.0), (2.5, -4.0), (0.2, 1.0), (1.0, -5.0), (20.0, 3.0), (0.05, 0.0)];
    for n in COUNTS {
        let points = polygon(n);
        let last = n - 1;
        for (bias, tension) in parameters {
            let cube = bias * bias * bias;
            // The auxiliary points (2.65).
            let before = combine(&[(1.0 + 1.0 / cube, points[0]), (-1.0 / cube, points[1])]);
            let after = combine(&[(1.0 + cube, points[last]), (-cube, points[last - 1])]);
            let mut extended = vec![before];
            extended.extend(&points);
            extended.push(after);
            let open = |span: usize, u| {
                beta(
                    [extended[span], extended[span + 1], extended[span + 2], extended[span + 3]],
                    bias,
                    tension,
                    u,
                )
            };
            let closed = |span: usize, u| {
                let p = |i| at(&points, Closure::Closed, span as isize + i);
                beta([p(-1), p(0), p(1), p(2)], bias, tension, u)
            };
            let method = Method::Beta { bias, tension };
            // The formula itself loses digits where it goes through far auxiliary points.
            let tolerance = TOLERANCE * (1.0 + cube).max(1.0 / cube) / 4.0;
            let difference = largest_difference(method, Closure::Open, &points, open);
            assert!(difference < tolerance.max(TOLERANCE), "n {n} {bias} {tension}: {difference:e}");
            let difference = largest_difference(method, Closure::Closed, &points, closed);
            assert!(difference < TOLERANCE, "n {n} {bias} {tension}: {difference:e}");
            // The same auxiliary points given from outside.
            let weights = Weights::with_ends(method, Ends::Auxiliary, n + 2).unwrap();
            let given = Curve::Piecewise(weights.arcs(&extended).unwrap());
            let own = Curve::through(method, Closure::Open, &points).unwrap();
            for (a, b) in given.sample(5).unwrap().iter().zip(own.sample(5).unwrap()) {
                assert!(distance(a.point, b.point) < tolerance.max(TOLERANCE));
            }
        }
    }
}

#[test]
fn neutral_beta_spline_is_the_cubic_bspline() {
    let points = polygon(20);
    let neutral = Method::Beta { bias: 1.0, tension: 0.0 };
    let arcs = |method| Weights::new(method, Closure::Closed, 20).unwrap().arcs(&points).unwrap();
    assert_eq!(arcs(neutral), arcs(Method::BSpline3));
}

#[test]
fn doubled_ends_repeat_the_end_points() {
    let points = polygon(9);
    let (first, last) = (points[0], points[8]);
    let with = |extra: usize| {
        let repeat = |p| std::iter::repeat_n(p, extra);
        repeat(first).chain(points.iter().copied()).chain(repeat(last)).collect::<Vec<_>>()
    };
    let beta = Method::Beta { bias: 1.5, tension: 2.0 };
    for method in [Method::BSpline2, Method::BSpline3, beta, Method::Local { k0: 0.4 }] {
        let doubled = Weights::with_ends(method, Ends::Doubled, 9).unwrap().arcs(&points).unwrap();
        let given = with(1);
        let auxiliary = Weights::with_ends(method, Ends::Auxiliary, 11).unwrap().arcs(&given).unwrap();
        assert_eq!(doubled.len(), auxiliary.len());
        for (span, (a, b)) in doubled.iter().zip(&auxiliary).enumerate() {
            // The straight end spans of the quadratic B-spline run evenly (3.32, 3.35), the others as they are.
            let even = method == Method::BSpline2 && (span == 0 || span + 1 == doubled.len());
            let third = |c: usize| {
                let t = c as f64 / 3.0;
                std::array::from_fn(|d| (1.0 - t) * b.p[0][d] + t * b.p[3][d])
            };
            let expected = |c: usize| if even { third(c) } else { b.p[c] };
            assert!((0..4).all(|c| distance(a.p[c], expected(c)) < TOLERANCE), "{method:?}");
        }
    }
}
