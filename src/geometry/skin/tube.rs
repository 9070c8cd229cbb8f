//! Tubes: the surface between touching circles of successive spheres.

use super::clear::{Clearing, choose, near};
use super::frame::{Framed, Wave};
use super::hermite::Hermite;
use super::{Sphere, TouchingCircle};
use crate::geometry::param::clipped;
use crate::geometry::{BSplineSurface, CubicBezier, Derivatives, MAX_POINTS, ParamSurface, Point, dot};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Angles at which a tube is looked at for entering a sphere.
const LOOKED_AT: u32 = 32;
/// Angles that are nearer are one.
const NEAREST: f64 = 1e-9;

/// The surface between touching circles of successive spheres: direction 0 goes round in four quarter turns, direction 1
/// along the chain, a span from sphere to sphere. Normals point outwards.
///
/// It is rational: cubic along the chain, of degree 4 round it, and so exact as a B-spline surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Tube {
    circles: Vec<Framed>,
    spans: Vec<TubeSpan>,
    closed: bool,
}

/// What a tube is between two spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TubeSpan {
    /// The numbers of the spheres.
    pub spheres: [usize; 2],
    /// The factors of the tangents beside the plain ones.
    pub scale: [f64; 2],
    /// Whether it keeps out of all spheres, as far as 32 lines along it tell.
    pub clear: bool,
    /// The lengths of the tangents with the sign of the distance from the radical plane.
    lengths: [Wave<f64>; 2],
}

/// The value of a wave at an angle.
fn value(wave: &Wave<f64>, [cosine, sine]: [f64; 2]) -> f64 {
    wave[0] + wave[1] * cosine + wave[2] * sine
}

/// The vector of a wave at an angle.
fn vector(wave: &Wave<Point<3>>, [cosine, sine]: [f64; 2]) -> Point<3> {
    std::array::from_fn(|d| wave[0][d] + wave[1][d] * cosine + wave[2][d] * sine)
}

/// The span between two circles, unless its spheres are concentric or its numbers too large.
pub(super) fn span([from, to]: [&Framed; 2], spheres: &[Sphere], clearing: Clearing) -> Option<TubeSpan> {
    let axis = from.sphere.axis(&to.sphere)?;
    let lengths = [from, to].map(|framed| {
        let [center, x, y] = framed.points();
        let way: Point<3> = std::array::from_fn(|d| center[d] - from.sphere.center[d]);
        [
            2.0 * (dot(way, axis.direction) - axis.radical),
            2.0 * dot(x, axis.direction),
            2.0 * dot(y, axis.direction),
        ]
    });
    let numbers = [from.circle.sphere, to.circle.sphere];
    let end = |framed: &Framed, at: [f64; 2]| (vector(&framed.points(), at), vector(&framed.forward(), at));
    let arcs: Vec<Hermite<3>> = (0..LOOKED_AT)
        .map(|k| {
            let (sine, cosine) = (TAU * f64::from(k) / f64::from(LOOKED_AT)).sin_cos();
            Hermite::between([&from.sphere, &to.sphere], [from, to].map(|framed| end(framed, [cosine, sine])))
        })
        .collect();
    if !arcs.iter().all(Hermite::is_drawn) || !lengths.iter().flatten().all(|x| x.is_finite()) {
        return None;
    }
    let others = near(&arcs, spheres, numbers);
    let (scale, clear) = choose(clearing, &arcs, [&from.sphere, &to.sphere], &others);
    Some(TubeSpan { spheres: numbers, scale, clear, lengths })
}

impl Tube {
    pub(super) fn new(circles: Vec<Framed>, spans: Vec<TubeSpan>, closed: bool) -> Self {
        Self { circles, spans, closed }
    }

    /// The spans from sphere to sphere.
    #[must_use]
    pub fn tube_spans(&self) -> &[TubeSpan] {
        &self.spans
    }

    /// The touching circles in the order of the chain.
    pub fn circles(&self) -> impl Iterator<Item = &TouchingCircle> {
        self.circles.iter().map(|framed| &framed.circle)
    }

    /// The circles with their frames.
    pub(super) fn framed(&self) -> &[Framed] {
        &self.circles
    }

    /// The circles at the ends of a span.
    fn ends(&self, span: usize) -> Option<[&Framed; 2]> {
        let to = if self.closed { (span + 1) % self.circles.len() } else { span + 1 };
        Some([self.circles.get(span)?, self.circles.get(to)?])
    }

    /// The line along a span after a number of quarter turns.
    pub(super) fn line(&self, span: usize, quarters: f64) -> Option<CubicBezier<3>> {
        self.lines(span, quarters * FRAC_PI_2).map(|[line, ..]| line)
    }

    /// The line along a span at an angle, and its first and second derivatives by the angle.
    fn lines(&self, span: usize, angle: f64) -> Option<[CubicBezier<3>; 3]> {
        let (ends, own) = (self.ends(span)?, self.spans.get(span)?);
        let (sine, cosine) = angle.sin_cos();
        let turns = [[cosine, sine], [-sine, cosine], [-cosine, -sine]];
        let derivative = |wave: &Wave<f64>, k: usize| {
            value(&[if k == 0 { wave[0] } else { 0.0 }, wave[1], wave[2]], turns[k])
        };
        let derivatives = |wave: &Wave<Point<3>>| -> [Point<3>; 3] {
            std::array::from_fn(|k| std::array::from_fn(|d| derivative(&wave.map(|vector| vector[d]), k)))
        };
        let sides: [[[Point<3>; 3]; 2]; 2] = std::array::from_fn(|end| {
            let points = derivatives(&ends[end].points());
            let forward = derivatives(&ends[end].forward());
            let length: [f64; 3] = std::array::from_fn(|k| derivative(&own.lengths[end], k));
            // The length of the tangent is the distance itself; the second tangent is laid off backwards.
            let factor = own.scale[end] / 3.0 * if length[0] < 0.0 { -1.0 } else { 1.0 } * [1.0, -1.0][end];
            let product = |k: usize, d: usize| match k {
                0 => length[0] * forward[0][d],
                1 => length[1] * forward[0][d] + length[0] * forward[1][d],
                _ => length[2] * forward[0][d] + 2.0 * length[1] * forward[1][d] + length[0] * forward[2][d],
            };
            let inner =
                std::array::from_fn(|k| std::array::from_fn(|d| points[k][d] + factor * product(k, d)));
            [points, inner]
        });
        let [[first, second], [last, third]] = sides;
        Some(std::array::from_fn(|k| CubicBezier { p: [first[k], second[k], third[k], last[k]] }))
    }

    /// The angles at which the rational pieces meet: those of quarter turns, and where a radical plane cuts a circle so
    /// that the lengths of the tangents, which are distances from it, have a kink.
    fn breaks(&self) -> Vec<f64> {
        let whole = (0..=4).map(|quarter| f64::from(quarter) * FRAC_PI_2);
        let mut breaks: Vec<f64> = Vec::new();
        for [constant, cosine, sine] in self.spans.iter().flat_map(|span| span.lengths) {
            let (amplitude, phase) = (cosine.hypot(sine), sine.atan2(cosine));
            if constant.abs() < amplitude {
                let half = (-constant / amplitude).acos();
                breaks.extend([phase - half, phase + half].map(|angle| angle.rem_euclid(TAU)));
            }
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|next, kept| *next - *kept < NEAREST);
        breaks.retain(|angle| whole.clone().all(|quarter| (angle - quarter).abs() > NEAREST));
        breaks.extend(whole);
        breaks.sort_by(f64::total_cmp);
        breaks
    }
}

impl ParamSurface for Tube {
    fn spans(&self) -> [usize; 2] {
        [4, self.spans.len()]
    }

    fn closed(&self) -> [bool; 2] {
        [true, self.closed]
    }

    fn at(&self, [quarter, span]: [usize; 2], [u, v]: [f64; 2]) -> Option<Derivatives> {
        if quarter > 3 {
            return None;
        }
        let (u, v) = (clipped(u), clipped(v));
        let [line, by_angle, twice] = self.lines(span, quarters(quarter, u) * FRAC_PI_2)?;
        Some(Derivatives {
            point: line.eval(v),
            u: by_angle.eval(v).map(|x| FRAC_PI_2 * x),
            v: line.derivative(v),
            uu: twice.eval(v).map(|x| FRAC_PI_2 * FRAC_PI_2 * x),
            uv: by_angle.derivative(v).map(|x| FRAC_PI_2 * x),
            vv: line.second_derivative(v),
        })
    }

    fn row(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
        let quarters = quarters(i, clipped(u));
        for (span, points) in (0..self.spans.len()).zip((0..).step_by(per_cell.max(1))) {
            let Some(line) = self.line(span, quarters) else { continue };
            for (step, point) in row.iter_mut().skip(points).take(per_cell + 1).enumerate() {
                *point = line.eval(step as f64 / per_cell as f64);
            }
        }
    }

    /// Exact: of degree 4 round the tube, 3 along it. `None` only where kinks of spheres that are not admissible make
    /// more than [`MAX_POINTS`] control points.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        let breaks = self.breaks();
        if (4 * breaks.len()).saturating_mul(3 * self.spans.len() + 1) > MAX_POINTS {
            return None;
        }
        let pieces: Vec<[f64; 2]> = breaks.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let mut net = vec![vec![[0.0; 4]; 3 * self.spans.len() + 1]; 4 * pieces.len() + 1];
        for (piece, [from, to]) in pieces.iter().enumerate() {
            let middle = 0.5 * (from + to);
            let (sine, cosine) = middle.sin_cos();
            let turn = Turn::new([*from, *to]);
            for (span, own) in self.spans.iter().enumerate() {
                for (end, framed) in self.ends(span)?.into_iter().enumerate() {
                    let points = framed.points().map(|[x, y, z]| [x, y, z, 0.0]);
                    let points = turn.squared(&[
                        [points[0][0], points[0][1], points[0][2], 1.0],
                        points[1],
                        points[2],
                    ]);
                    let length = own.lengths[end];
                    let sign =
                        if value(&length, [cosine, sine]) < 0.0 { -1.0 } else { 1.0 } * [1.0, -1.0][end];
                    let tangents =
                        turn.product(&length.map(|x| own.scale[end] / 3.0 * sign * x), &framed.forward());
                    for k in 0..5 {
                        let row = &mut net[4 * piece + k];
                        let [x, y, z] = tangents[k];
                        let [a, b, c, w] = points[k];
                        row[3 * (span + end)] = [a, b, c, w];
                        row[3 * span + 1 + end] = [a + x, b + y, c + z, w];
                    }
                }
            }
        }
        if self.closed {
            for row in &mut net {
                let first = row[0];
                if let Some(last) = row.last_mut() {
                    *last = first;
                }
            }
        }
        if let [first, .., last] = net.as_mut_slice() {
            last.clone_from(first);
        }
        let knots = [
            breaks.iter().map(|angle| angle / FRAC_PI_2).collect(),
            (0..=self.spans.len()).map(|k| k as f64).collect(),
        ];
        let counts = [clamped(4, pieces.len()), clamped(3, self.spans.len())];
        Some(BSplineSurface::rational([4, 3], knots, counts, &net))
    }
}

/// Quarter turns from the beginning. The last one ends where the first begins, with the same numbers.
pub(super) fn quarters(quarter: usize, u: f64) -> f64 {
    if quarter == 3 && u == 1.0 { 0.0 } else { quarter as f64 + u }
}

/// The multiplicities of the knots of so many Bézier pieces of a degree.
pub(super) fn clamped(degree: usize, pieces: usize) -> Vec<usize> {
    (0..=pieces).map(|k| if k == 0 || k == pieces { degree + 1 } else { degree }).collect()
}

/// A part of a turn as a rational quadratic: weight, cosine times weight, sine times weight, by their Bernstein
/// coefficients.
pub(super) struct Turn([[f64; 3]; 3]);

impl Turn {
    /// The turn from one angle to another, less than half a one.
    pub(super) fn new([from, to]: [f64; 2]) -> Self {
        let [(s0, c0), (s1, c1), (s2, c2)] = [from, 0.5 * (from + to), to].map(whole_turns);
        let weight = (0.5 * (to - from)).min(0.5 * PI).cos();
        Self([[1.0, weight, 1.0], [c0, c1, c2], [s0, s1, s2]])
    }

    /// The weight times a wave: quadratic.
    pub(super) fn wave<const D: usize>(&self, wave: &Wave<[f64; D]>) -> [[f64; D]; 3] {
        let [weight, cosine, sine] = &self.0;
        std::array::from_fn(|k| {
            std::array::from_fn(|d| wave[0][d] * weight[k] + wave[1][d] * cosine[k] + wave[2][d] * sine[k])
        })
    }

    /// The squared weight times a wave: of degree 4.
    fn squared<const D: usize>(&self, wave: &Wave<[f64; D]>) -> [[f64; D]; 5] {
        times(&self.0[0], &self.wave(wave))
    }

    /// The squared weight times the product of two waves.
    fn product<const D: usize>(&self, factor: &Wave<f64>, wave: &Wave<[f64; D]>) -> [[f64; D]; 5] {
        let factor = self.wave(&factor.map(|x| [x])).map(|[x]| x);
        times(&factor, &self.wave(wave))
    }
}

/// Sine and cosine, those of a whole turn the same as at its beginning.
fn whole_turns(angle: f64) -> (f64, f64) {
    if angle == TAU { (0.0, 1.0) } else { angle.sin_cos() }
}

/// The product of two quadratics by their Bernstein coefficients.
fn times<const D: usize>(a: &[f64; 3], b: &[[f64; D]; 3]) -> [[f64; D]; 5] {
    std::array::from_fn(|k| {
        std::array::from_fn(|d| match k {
            0 => a[0] * b[0][d],
            1 => 0.5 * (a[0] * b[1][d] + a[1] * b[0][d]),
            2 => (a[0] * b[2][d] + 4.0 * a[1] * b[1][d] + a[2] * b[0][d]) / 6.0,
            3 => 0.5 * (a[1] * b[2][d] + a[2] * b[1][d]),
            _ => a[2] * b[2][d],
        })
    })
}
