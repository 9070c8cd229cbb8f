//! Every surface method with every topology against the equations of chapter 3 as they stand: dense
//! elimination for splines, printed weights for B-splines, beta-splines and local splines, de Casteljau for
//! Bézier, the Hermite matrix product. The agreement asked for is 1e-12 of the net's size.

use grafika::geometry::{Border, Method, ParamSurface, Point, Scheme, Surface, Topology};

const SIZE: f64 = 560.0;
const TOLERANCE: f64 = 1e-12 * SIZE;

type Net = Vec<Vec<Point<3>>>;

/// Numbers from -280 to 280.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 11) as f64 / (1_u64 << 53) as f64 - 0.5) * SIZE
    }

    fn point(&mut self) -> Point<3> {
        [self.next(), self.next(), self.next()]
    }
}

/// A random net; those of odd seeds have coinciding points and rows and a straight piece.
fn net([rows, columns]: [usize; 2], topology: Topology, seed: u64) -> Net {
    let mut numbers = Numbers(seed);
    let mut net: Net = (0..rows).map(|_| (0..columns).map(|_| numbers.point()).collect()).collect();
    if seed % 2 == 1 {
        net[1] = net[0].clone();
        let last = net[rows - 1].clone();
        net[rows - 1][columns - 2] = last[columns - 1];
        for (l, point) in net[2].iter_mut().enumerate() {
            *point = [l as f64 * 30.0, -20.0 * l as f64, 7.0];
        }
    }
    if topology == Topology::Sphere {
        let (north, south) = (numbers.point(), numbers.point());
        for row in &mut net {
            row[0] = north;
            row[columns - 1] = south;
        }
    }
    net
}

fn combine(terms: &[(f64, Point<3>)]) -> Point<3> {
    std::array::from_fn(|d| terms.iter().map(|(w, p)| w * p[d]).sum())
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    (0..3).map(|d| (a[d] - b[d]).abs()).fold(0.0, f64::max)
}

/// Gaussian elimination with row exchange.
fn solve(mut rows: Vec<Vec<f64>>, mut rhs: Vec<Point<3>>) -> Vec<Point<3>> {
    let n = rhs.len();
    for c in 0..n {
        let pivot = (c..n).max_by(|&a, &b| rows[a][c].abs().total_cmp(&rows[b][c].abs())).unwrap();
        rows.swap(c, pivot);
        rhs.swap(c, pivot);
        for r in (0..n).filter(|&r| r != c) {
            let factor = rows[r][c] / rows[c][c];
            let above = rows[c].clone();
            rows[r].iter_mut().zip(&above).for_each(|(x, y)| *x -= factor * y);
            rhs[r] = combine(&[(1.0, rhs[r]), (-factor, rhs[c])]);
        }
    }
    (0..n).map(|r| rhs[r].map(|x| x / rows[r][r])).collect()
}

/// (3.20)-(3.22), and (2.39) for cyclic ones: the parameters a_k, then the point.
fn spline(points: &[Point<3>], cyclic: bool, span: usize, u: f64) -> Point<3> {
    let n = points.len();
    let (mut rows, mut rhs) = (vec![vec![0.0; n]; n], vec![[0.0; 3]; n]);
    for k in 0..n {
        if !cyclic && (k == 0 || k + 1 == n) {
            rows[k][k] = 1.0;
            continue;
        }
        let (before, after) = ((k + n - 1) % n, (k + 1) % n);
        rows[k][before] += 1.0;
        rows[k][k] += 4.0;
        rows[k][after] += 1.0;
        rhs[k] = combine(&[(1.0, points[before]), (-2.0, points[k]), (1.0, points[after])]);
    }
    let a = solve(rows, rhs);
    let (next, w) = ((span + 1) % n, 1.0 - u);
    combine(&[(w.powi(3) - w, a[span]), (u.powi(3) - u, a[next]), (w, points[span]), (u, points[next])])
}

/// The printed weights of the four points round a span: (3.36), (3.41), (3.61).
fn four_weights(method: Method, u: f64) -> [f64; 4] {
    let (w, u2, u3) = (1.0 - u, u * u, u * u * u);
    match method {
        Method::BSpline3 => {
            [w * w * w, 3.0 * u3 - 6.0 * u2 + 4.0, -3.0 * u3 + 3.0 * u2 + 3.0 * u + 1.0, u3].map(|f| f / 6.0)
        }
        Method::Local { k0 } | Method::Coons { k0 } => {
            let (m, q) = (k0 * (-u3 + 2.0 * u2 - u), k0 * (u3 - u2));
            [m, 2.0 * u3 - 3.0 * u2 + 1.0 - q, -2.0 * u3 + 3.0 * u2 - m, q]
        }
        Method::Beta { bias: b, tension: t } => {
            let (f2, f3, f4) = (u2 * (3.0 - u), u * (3.0 - u2), 3.0 * u2 - 2.0 * u3);
            let delta = b * b * b + 2.0 * (b * b + b) + t + 1.0;
            let before = b * b * b * w * w * w;
            let here = b * b * b * (1.0 - w * w * w) + b * b * (2.0 - f2) + b * (2.0 - f3) + t * (1.0 - f4);
            let after = b * b * f2 + b * f3 + t * f4 + 1.0 - u3;
            [before, here, after, u3].map(|f| f / delta)
        }
        _ => panic!("{method:?} has no four weights"),
    }
}

/// Points with an auxiliary one at either end, four for a span.
fn by_four(framed: &[Point<3>], method: Method, span: usize, u: f64) -> Point<3> {
    let terms: Vec<_> = four_weights(method, u).into_iter().zip(framed[span..].iter().copied()).collect();
    combine(&terms)
}

/// (3.25) with the end spans of (3.32) and (3.35) when the ends are doubled.
fn quadratic(points: &[Point<3>], cyclic: bool, span: usize, at: f64) -> Point<3> {
    let n = points.len();
    let (before, after) = match cyclic {
        true => (points[(span + n - 1) % n], points[(span + 1) % n]),
        false => (points[span.saturating_sub(1)], points[(span + 1).min(n - 1)]),
    };
    let u = match (cyclic, span) {
        (false, 0) => at.sqrt(),
        (false, span) if span + 1 == n => 1.0 - (1.0 - at).sqrt(),
        _ => at,
    };
    let w = 1.0 - u;
    combine(&[(w * w / 2.0, before), (1.0 - (w * w + u * u) / 2.0, points[span]), (u * u / 2.0, after)])
}

fn casteljau(points: &[Point<3>], u: f64) -> Point<3> {
    let mut round = points.to_vec();
    while round.len() > 1 {
        round = round.windows(2).map(|p| combine(&[(1.0 - u, p[0]), (u, p[1])])).collect();
    }
    round[0]
}

/// A curve of an open or cyclic direction.
fn curve(points: &[Point<3>], method: Method, cyclic: bool, border: Border, span: usize, u: f64) -> Point<3> {
    let n = points.len();
    let ends = |first: Point<3>, last: Point<3>| -> Vec<Point<3>> {
        std::iter::once(first).chain(points.iter().copied()).chain([last]).collect()
    };
    let neutral = Method::Beta { bias: 1.0, tension: 0.0 };
    match method {
        Method::Spline => spline(points, cyclic, span, u),
        Method::BSpline2 => quadratic(points, cyclic, span, u),
        Method::Bezier => casteljau(points, u),
        _ if cyclic => {
            let mut framed = ends(points[n - 1], points[0]);
            framed.push(points[1]);
            by_four(&framed, method, span, u)
        }
        Method::BSpline3 if border == Border::Reached => curve(points, neutral, cyclic, border, span, u),
        // (3.42)-(3.46): auxiliary border points.
        Method::Beta { bias: b, .. } => {
            let cube = b * b * b;
            let before = combine(&[(1.0 + 1.0 / cube, points[0]), (-1.0 / cube, points[1])]);
            let after = combine(&[(1.0 + cube, points[n - 1]), (-cube, points[n - 2])]);
            by_four(&ends(before, after), method, span, u)
        }
        _ => by_four(&ends(points[0], points[n - 1]), method, span, u),
    }
}

/// A meridian of a sphere.
fn meridian(net: &Net, scheme: Scheme, k: usize, span: usize, v: f64) -> Point<3> {
    let (rows, columns) = (net.len(), net[0].len());
    let opposite = &net[(k + rows / 2) % rows];
    let framed = |first: Point<3>, last: Point<3>| -> Vec<Point<3>> {
        std::iter::once(first).chain(net[k].iter().copied()).chain([last]).collect()
    };
    match scheme.v {
        // One closed curve with the opposite meridian.
        Method::Spline => {
            let back = opposite[1..columns - 1].iter().rev();
            let ring: Vec<_> = net[k].iter().chain(back).copied().collect();
            spline(&ring, true, span, v)
        }
        // (3.64)-(3.67) with the index l + i.
        Method::Local { .. } | Method::Coons { .. } => {
            by_four(&framed(opposite[1], opposite[columns - 2]), scheme.v, span, v)
        }
        // (3.51), (3.56)
        Method::Beta { bias: b, .. } => {
            let mean = |l: usize| {
                let terms: Vec<_> = net.iter().map(|row| (1.0 / rows as f64, row[l])).collect();
                combine(&terms)
            };
            let north = combine(&[(b + 1.0, mean(1)), (b * (b * b - 1.0), net[0][0])]);
            let south =
                combine(&[(b * b * (b + 1.0), mean(columns - 2)), (1.0 - b * b, net[0][columns - 1])]);
            let cube = b * b * b;
            let first = combine(&[(1.0 / cube, north), (-1.0 / cube, net[k][1])]);
            let last = combine(&[(1.0, south), (-cube, net[k][columns - 2])]);
            by_four(&framed(first, last), scheme.v, span, v)
        }
        Method::BSpline3 if scheme.border == Border::Reached => {
            let v_method = Method::Beta { bias: 1.0, tension: 0.0 };
            meridian(net, Scheme { v: v_method, ..scheme }, k, span, v)
        }
        method => curve(&net[k], method, false, Border::Doubled, span, v),
    }
}

fn expected(net: &Net, scheme: Scheme, [i, j]: [usize; 2], [u, v]: [f64; 2]) -> Point<3> {
    let closed = |topology| scheme.topology == topology;
    let column: Vec<_> = (0..net.len())
        .map(|k| match scheme.topology {
            Topology::Sphere => meridian(net, scheme, k, j, v),
            _ => curve(&net[k], scheme.v, closed(Topology::Torus), scheme.border, j, v),
        })
        .collect();
    curve(&column, scheme.u, !closed(Topology::Open), scheme.border, i, u)
}

/// The largest deviation over all spans and several parameters.
fn deviation(scheme: Scheme, net: &Net) -> f64 {
    let surface = Surface::new(scheme, net).unwrap();
    let samples = surface.sample(3).unwrap();
    let off = |s: &grafika::geometry::SurfaceSample| {
        distance(s.point, expected(net, scheme, s.spans, s.parameters))
    };
    samples.iter().map(off).fold(0.0, f64::max)
}

fn pairs() -> Vec<[Method; 2]> {
    let beta = |bias, tension| Method::Beta { bias, tension };
    vec![
        [Method::Spline; 2],
        [Method::BSpline2; 2],
        [Method::BSpline3; 2],
        [beta(1.0, 0.0); 2],
        [beta(2.0, 5.0), beta(0.5, 10.0)],
        [beta(0.4, 0.0), beta(3.0, -2.0)],
        [Method::Local { k0: 0.5 }; 2],
        [Method::Local { k0: 1.0 }, Method::Local { k0: -0.3 }],
        [Method::Coons { k0: 0.0 }, Method::Coons { k0: 0.7 }],
    ]
}

#[test]
fn every_method_follows_its_equations() {
    let shapes = [[4, 3], [6, 4], [8, 5], [10, 9]];
    let mut worst = 0.0_f64;
    for topology in [Topology::Open, Topology::Sphere, Topology::Torus] {
        for border in [Border::Doubled, Border::Reached] {
            for [u, v] in pairs() {
                for (shape, seed) in shapes.into_iter().zip(1..) {
                    let scheme = Scheme { u, v, topology, border };
                    let off = deviation(scheme, &net(shape, topology, seed));
                    assert!(off < TOLERANCE, "{scheme:?} {shape:?}: {off:e}");
                    worst = worst.max(off);
                }
            }
        }
    }
    println!("largest deviation: {:e} of the size", worst / SIZE);
}

#[test]
fn methods_of_different_kinds_may_meet() {
    for (topology, seed) in [(Topology::Open, 5), (Topology::Sphere, 6), (Topology::Torus, 7)] {
        let kinds: Vec<Method> = pairs().into_iter().map(|[u, _]| u).collect();
        for (&u, &v) in kinds.iter().zip(kinds.iter().skip(1)) {
            let scheme = Scheme { u, v, topology, border: Border::Doubled };
            let off = deviation(scheme, &net([6, 5], topology, seed));
            assert!(off < TOLERANCE, "{scheme:?}: {off:e}");
        }
    }
}

#[test]
fn the_comparison_can_fail() {
    let net = net([8, 5], Topology::Sphere, 2);
    let scheme = Scheme::new(Method::Beta { bias: 1.5, tension: 1.0 }, Topology::Sphere);
    let surface = Surface::new(scheme, &net).unwrap();
    let nearby = Scheme { v: Method::Beta { bias: 1.500001, tension: 1.0 }, ..scheme };
    let off = distance(surface.eval([0, 0], [0.3, 0.0]).unwrap(), expected(&net, nearby, [0, 0], [0.3, 0.0]));
    assert!(off > 1e4 * TOLERANCE, "{off:e}");
}

#[test]
fn bezier_patches_are_those_of_de_casteljau() {
    for shape in [[2, 2], [3, 4], [4, 4], [5, 2], [9, 7], [20, 13]] {
        let net = net([shape[0].max(3), shape[1].max(2)], Topology::Open, 2);
        let scheme = Scheme::new(Method::Bezier, Topology::Open);
        let off = deviation(scheme, &net);
        assert!(off < TOLERANCE, "{shape:?}: {off:e}");
    }
}

#[test]
fn hermite_patches_are_the_matrix_product() {
    let mut numbers = Numbers(9);
    for _ in 0..20 {
        let a: [[Point<3>; 4]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| numbers.point()));
        let surface = Surface::hermite(&a).unwrap();
        let f = |u: f64| {
            let (u2, u3) = (u * u, u * u * u);
            [2.0 * u3 - 3.0 * u2 + 1.0, -2.0 * u3 + 3.0 * u2, u3 - 2.0 * u2 + u, u3 - u2]
        };
        for sample in surface.sample(5).unwrap() {
            let [u, v] = sample.parameters;
            let rows: Vec<_> = f(u).into_iter().zip(a).collect();
            let across = |(weight, row): &(f64, [Point<3>; 4])| {
                let terms: Vec<_> = f(v).into_iter().zip(*row).collect();
                (*weight, combine(&terms))
            };
            let want = combine(&rows.iter().map(across).collect::<Vec<_>>());
            assert!(distance(sample.point, want) < TOLERANCE);
        }
    }
}
