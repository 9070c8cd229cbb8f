//! Speed of spaces, curves and surfaces over extended Chebyshev spaces, beside the formulas of Róth's thesis written
//! plainly, (1.14), (1.15), (1.21) and (1.22), in the same run: the spaces of its table 3.1.
//!
//! Goals: set-up 20 ms, 1000 points of a curve 1 ms, 50 x 50 points of a surface 2 ms (by tables 1 ms), each at least a
//! hundred times faster than the plain formulas. A point of a surface of 200 x 200 points dragged at 60 pictures a
//! second.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use grafika::file::ec::{EcDocument, EcPatch, Interval, Item, PatchStyle, Scene};
use grafika::geometry::ec::{EcBasis, Real, Space};
use grafika::geometry::{Basis, Blend, ParamCurve, ParamSurface, Point, Weave};
use grafika::machine::{Button, Event, Machine, Memory, Script, Session, Settings, play};
use grafika::programs::kc_ter::PROGRAM;
use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;
use std::time::Duration;

const SPACES: [(&str, &str, f64); 6] = [
    ("P5", "0^6", 1.0),
    ("P11", "0^12", 1.0),
    ("T11", "0,i,2i,3i,4i,5i", FRAC_PI_2),
    ("AT13", "0,i^3,2i^3", FRAC_PI_2),
    ("AE10", "0,1^3,2^3,3^3", 1.0),
    ("AET13", "0,1+i^2,1+2i^2,2+i^2", 1.0),
];

/// The thesis's construction in doubles, for the interval [0, end].
struct Plain {
    space: Space,
    end: f64,
    /// Row i: the coefficients of the bicanonical function i in the ordinary basis.
    rho: Vec<Vec<f64>>,
    /// The inverse of U.
    mu: Vec<Vec<f64>>,
    /// The first column of the inverse of L.
    lambda: Vec<f64>,
}

impl Plain {
    fn new(space: &Space, end: f64) -> Self {
        let n = space.dimension() - 1;
        let at_start: Vec<Vec<f64>> = (0..=n).map(|j| space.ordinary(j, 0.0)).collect();
        let at_end: Vec<Vec<f64>> = (0..=n).map(|j| space.ordinary(j, end)).collect();
        let rho: Vec<Vec<f64>> = (0..=n)
            .map(|i| {
                let rows = (0..=i).map(|j| at_start[j].clone()).chain((0..n - i).map(|j| at_end[j].clone()));
                let right = (0..=n).map(|j| if j == i { 1.0 } else { 0.0 }).collect();
                solve(rows.collect(), right)
            })
            .collect();
        let derivative =
            |i: usize, j: usize| -> f64 { rho[i].iter().zip(&at_end[j]).map(|(a, b)| a * b).sum() };
        let wronskian: Vec<Vec<f64>> =
            (0..=n).map(|j| (0..=n).map(|k| derivative(n - k, j)).collect()).collect();
        let (lower, upper) = doolittle(&wronskian);
        let unit = |k: usize| (0..=n).map(|j| if j == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = (0..=n).map(|k| solve(upper.clone(), unit(k))).collect();
        let mu = (0..=n).map(|r| (0..=n).map(|k| columns[k][r]).collect()).collect();
        Self { space: space.clone(), end, rho, mu, lambda: solve(lower, unit(0)) }
    }

    /// Function k of the ordinary basis.
    fn phi(&self, k: usize, u: f64) -> f64 {
        let mut first = 0;
        for root in self.space.roots() {
            let (re, im) = (root.re.value(), root.im.value());
            let count = root.dimension();
            if k < first + count {
                let at = k - first;
                let power = if im == 0.0 { at } else { at / 2 };
                let growth = u.powi(power as i32) * (re * u).exp();
                return match (im == 0.0, at % 2) {
                    (true, _) => growth,
                    (false, 0) => growth * (im * u).cos(),
                    (false, _) => growth * (im * u).sin(),
                };
            }
            first += count;
        }
        0.0
    }

    /// Function n - i of the NB-basis as (1.22) has it.
    fn value(&self, i: usize, u: f64) -> f64 {
        let n = self.rho.len() - 1;
        let inner = |r: usize| (0..=n).map(|k| self.rho[n - r][k] * self.phi(k, u)).sum::<f64>();
        self.lambda[i] * (0..=i).map(|r| self.mu[r][i] * inner(r)).sum::<f64>()
    }

    fn point(&self, points: &[Point<3>], u: f64) -> Point<3> {
        let n = points.len() - 1;
        points.iter().enumerate().fold([0.0; 3], |sum, (i, point)| {
            let value = self.value(n - i, u);
            std::array::from_fn(|d| sum[d] + value * point[d])
        })
    }

    /// A point of a surface with this space along both directions.
    fn surface_point(&self, net: &[Vec<Point<3>>], u: f64, v: f64) -> Point<3> {
        let n = net.len() - 1;
        let along_v: Vec<f64> = (0..=n).map(|j| self.value(n - j, v)).collect();
        net.iter().enumerate().fold([0.0; 3], |sum, (i, row)| {
            let value = self.value(n - i, u);
            row.iter()
                .zip(&along_v)
                .fold(sum, |sum, (point, w)| std::array::from_fn(|d| sum[d] + value * w * point[d]))
        })
    }
}

/// Gauss's elimination with pivots.
fn solve(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs())).unwrap_or(k);
        rows.swap(k, pivot);
        right.swap(k, pivot);
        let row = rows[k].clone();
        for i in k + 1..n {
            let factor = rows[i][k] / row[k];
            rows[i].iter_mut().zip(&row).skip(k).for_each(|(a, b)| *a -= factor * b);
            right[i] -= factor * right[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * right[j]).sum();
        right[k] = (right[k] - known) / rows[k][k];
    }
    right
}

/// L with ones on its diagonal, and U.
fn doolittle(a: &[Vec<f64>]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let n = a.len();
    let (mut lower, mut upper) = (vec![vec![0.0; n]; n], vec![vec![0.0; n]; n]);
    for i in 0..n {
        for j in i..n {
            upper[i][j] = a[i][j] - (0..i).map(|k| lower[i][k] * upper[k][j]).sum::<f64>();
        }
        lower[i][i] = 1.0;
        for j in i + 1..n {
            lower[j][i] = (a[j][i] - (0..i).map(|k| lower[j][k] * upper[k][i]).sum::<f64>()) / upper[i][i];
        }
    }
    (lower, upper)
}

fn zigzag(count: usize) -> Vec<Point<3>> {
    (0..count).map(|k| [k as f64, (k % 3) as f64, (k % 4) as f64]).collect()
}

fn table(c: &mut Criterion) {
    for (name, roots, end) in SPACES {
        let space: Space = roots.parse().expect("a space");
        let basis = EcBasis::new(&space, [0.0, end]).expect("a good interval");
        let plain = Plain::new(&space, end);
        let points = zigzag(basis.points());
        let net: Vec<Vec<Point<3>>> =
            (0..points.len()).map(|i| points.iter().map(|p| [p[0], i as f64, p[2]]).collect()).collect();
        let curve = Blend::new(&basis, points.clone()).expect("as many points as functions");
        let surface = Weave::new(&basis, &basis, net.clone()).expect("a net that fits");
        // Both are the same curve, as far as the plain formulas carry.
        let [a, b] = [curve.eval(0, 0.3).expect("inside"), plain.point(&points, 0.3 * plain.end)];
        assert!((0..3).all(|d| (a[d] - b[d]).abs() < 1e-3), "{name}: {a:?} {b:?}");

        let mut group = c.benchmark_group("set-up");
        group.bench_with_input(BenchmarkId::new("grafika", name), &space, |bencher, space| {
            bencher.iter(|| EcBasis::new(black_box(space), [0.0, end]));
        });
        group.bench_with_input(BenchmarkId::new("plain", name), &space, |bencher, space| {
            bencher.iter(|| Plain::new(black_box(space), end));
        });
        group.finish();
        let mut group = c.benchmark_group("1000 points of a curve");
        group.bench_function(BenchmarkId::new("grafika", name), |bencher| {
            bencher.iter(|| black_box(&curve).polyline(999));
        });
        group.bench_function(BenchmarkId::new("plain", name), |bencher| {
            let place = |k: u32| plain.end * f64::from(k) / 999.0;
            bencher.iter(|| (0..1000).map(|k| plain.point(&points, place(k))).collect::<Vec<_>>());
        });
        group.finish();
        let mut group = c.benchmark_group("50 x 50 points of a surface");
        group.bench_function(BenchmarkId::new("grafika", name), |bencher| {
            bencher.iter(|| black_box(&surface).mesh([49, 49]));
        });
        group.bench_function(BenchmarkId::new("grafika, point by point", name), |bencher| {
            let point = |k: usize| surface.eval([0, 0], [(k / 50) as f64 / 49.0, (k % 50) as f64 / 49.0]);
            bencher.iter(|| (0..2500).map(point).collect::<Vec<_>>());
        });
        group.bench_function(BenchmarkId::new("plain", name), |bencher| {
            let place = |k: usize| plain.end * k as f64 / 49.0;
            bencher.iter(|| {
                let point = |k: usize| plain.surface_point(&net, place(k / 50), place(k % 50));
                (0..2500).map(point).collect::<Vec<_>>()
            });
        });
        group.finish();
    }
}

/// One point of a surface of 200 x 200 points follows the mouse: events of KC_TER with their pictures.
fn drag(c: &mut Criterion) {
    let (_, roots, end) = SPACES[5];
    let space: Space = roots.parse().expect("a space");
    let interval: Interval = [Real::default(), Real::from(end)];
    let middle = (space.dimension() / 2) as f64;
    // The point in the middle of the net is the origin, which is seen in the middle of the picture.
    let place = |k: usize| 20.0 * (k as f64 - middle);
    let row = |k: usize| (0..space.dimension()).map(|l| [place(k), place(l), 0.0]).collect();
    let patch = EcPatch {
        space_u: space.clone(),
        interval_u: interval.clone(),
        space_v: space.clone(),
        interval_v: interval,
        net: (0..space.dimension()).map(row).collect(),
        exact: None,
        style: PatchStyle::default(),
        name: None,
    };
    let mut scene = Scene::from(Item::Patch(patch));
    scene.settings.mesh = [199, 199];
    let start =
        (PROGRAM.start)(Some(EcDocument::Scene(scene).into())).unwrap_or_else(|_| panic!("it starts"));
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let mut session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    let script = Script::parse("key Tab\nmove 252 261\npress left\n").expect("a right script");
    play(&mut session, &script, &mut ()).expect("nothing is written");
    let net = |session: &Session| session.model().expect("a model").expect("it is JSON");
    let before = net(&session);
    let mut x = 0;
    let mut now = Duration::from_secs(1);
    c.bench_function("a point of a surface of 200 x 200 points is dragged", |bencher| {
        bencher.iter(|| {
            x = (x + 7) % 60;
            now += Duration::from_millis(16);
            session.send(black_box(Event::Move(260 + x, 250)), now);
        });
    });
    session.send(Event::Release(Button::Left), now);
    assert_ne!(before, net(&session), "no point was dragged");
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(600));
    targets = table, drag
}
criterion_main!(benches);
