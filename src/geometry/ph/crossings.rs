//! Where an offset crosses itself: chords that cross, and Newton's method from there.

use super::complex::Complex;
use super::curve::Place;
use super::offset::Offset;
use crate::geometry::method::Closure;
use crate::geometry::{BoundingBox, Point};

/// A point where an offset crosses itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The two places, in the order of the curve.
    pub places: [Place; 2],
    /// The point.
    pub point: Point<2>,
}

/// The flat pieces are within this share of the size of their chords.
const FLAT: f64 = 1e-4;
/// The longest chord, in the parameter of its span.
const LONGEST: f64 = 0.125;
/// The shortest chord, in the parameter of its span.
const CUT_OFF: f64 = 1e-9;
/// Steps of Newton's method at most.
const STEPS: u32 = 30;
/// The remainder of a crossing, as a share of the size.
const MET: f64 = 1e-9;
/// The last step of Newton's method, in parameters of spans.
const SETTLED: f64 = 1e-9;
/// Parameters in one span nearer than this are the same place.
const APART: f64 = 1e-6;
/// Crossings whose parameters differ by less than this are the same one.
const SAME: f64 = 1e-8;
/// So near to a cusp, in the parameter, its two arms are the same by rounding, for they part with the third power.
const AT_A_CUSP: f64 = 1e-4;

/// The crossings of an offset, ordered by their first places. Parts that touch or coincide have no crossing.
pub(super) fn crossings(offset: &Offset) -> Vec<Crossing> {
    let chords = Chords::new(offset);
    let mut found: Vec<Crossing> = Vec::new();
    chords.for_each_pair(|a, b| {
        if let Some(start) = meeting(a, b, chords.tolerance)
            && let Some(crossing) = chords.refine([a.span, b.span], start)
        {
            found.push(crossing);
        }
    });
    let key = |crossing: &Crossing| crossing.places.map(|place| (place.span, place.u));
    found.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(std::cmp::Ordering::Equal));
    let mut distinct: Vec<Crossing> = Vec::new();
    for crossing in found {
        // Equal ones are neighbours but for rounding in the first place.
        let near = |other: &&Crossing| chords.along(crossing.places[0], other.places[0]) <= SAME;
        let same = |other: &Crossing| chords.along(crossing.places[1], other.places[1]) <= SAME;
        if !distinct.iter().rev().take_while(near).any(same) {
            distinct.push(crossing);
        }
    }
    distinct.retain(|crossing| !chords.turns_back_between(crossing));
    distinct
}

/// A nearly straight piece of an offset.
#[derive(Clone, Copy, Debug)]
struct Chord {
    /// Its number along the curve.
    number: usize,
    span: usize,
    /// Its range of the parameter.
    range: [f64; 2],
    ends: [Complex; 2],
}

impl Chord {
    fn low(&self) -> Complex {
        Complex::new(self.ends[0].re.min(self.ends[1].re), self.ends[0].im.min(self.ends[1].im))
    }

    fn high(&self) -> Complex {
        Complex::new(self.ends[0].re.max(self.ends[1].re), self.ends[0].im.max(self.ends[1].im))
    }
}

/// An offset in pieces that are nearly straight.
struct Chords<'a> {
    offset: &'a Offset,
    chords: Vec<Chord>,
    size: f64,
    tolerance: f64,
}

impl<'a> Chords<'a> {
    /// Whether the places of a crossing are only the two arms of one cusp, which do not cross.
    fn turns_back_between(&self, crossing: &Crossing) -> bool {
        let [a, b] = crossing.places;
        let between = |cusp: &&Place| {
            let key = |place: &Place| (place.span, place.u);
            (key(&a) <= key(cusp)) == (key(cusp) <= key(&b))
        };
        self.along(a, b) <= AT_A_CUSP && self.offset.cusps().iter().filter(between).count() == 1
    }

    fn new(offset: &'a Offset) -> Self {
        let segments = offset.curve().segments();
        let control = segments.iter().flat_map(|segment| segment.parts().control).map(|point| point.point());
        let extent = BoundingBox::around(control).map_or(0.0, |bounds| bounds.extent());
        let size = extent + offset.distance().abs();
        let mut this = Self { offset, chords: Vec::new(), size, tolerance: FLAT * size };
        let extra = this.breaks_near_cusps();
        let mut extra = extra.into_iter().peekable();
        for span in 0..segments.len() {
            let mut breaks: Vec<f64> = offset.cusps_of_span(span).collect();
            while let Some((_, u)) = extra.next_if(|(of, _)| *of == span) {
                breaks.push(u);
            }
            breaks.extend([0.0, 1.0]);
            breaks.sort_by(f64::total_cmp);
            breaks.dedup_by(|a, b| *a - *b < CUT_OFF);
            for pair in breaks.windows(2) {
                this.flatten(span, [pair[0], pair[1]]);
            }
        }
        this
    }

    /// More places to cut at, by span: a pair of cusps near each other belongs to a loop of that size, which longer
    /// chords would miss.
    fn breaks_near_cusps(&self) -> Vec<(usize, f64)> {
        let spans = self.offset.curve().segments().len();
        let places: Vec<f64> = self.offset.cusps().iter().map(|cusp| cusp.span as f64 + cusp.u).collect();
        let mut breaks = Vec::new();
        for pair in places.windows(2) {
            let gap = pair[1] - pair[0];
            let mut reach = 0.5 * gap;
            while reach > CUT_OFF && reach < 2.0 * LONGEST {
                for place in [pair[0] - reach, pair[1] + reach] {
                    if place > 0.0 && place < spans as f64 {
                        breaks.push((place.floor() as usize, place.fract()));
                    }
                }
                reach *= 1.5;
            }
        }
        breaks.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        breaks
    }

    fn point(&self, span: usize, u: f64) -> Complex {
        self.place(span, u)[0]
    }

    /// The point and the derivative.
    fn place(&self, span: usize, u: f64) -> [Complex; 2] {
        let segment = self.offset.curve().segments().get(span);
        segment.map_or([Complex::default(); 2], |segment| self.offset.moved(segment, u))
    }

    /// Adds the chords of a stretch without cusps inside.
    fn flatten(&mut self, span: usize, range: [f64; 2]) {
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let ends = range.map(|u| self.point(span, u));
        let mut waiting = vec![(range, ends, self.point(span, middle(range)))];
        while let Some((range, ends, centre)) = waiting.pop() {
            let [from, to] = range;
            let halves = [[from, middle(range)], [middle(range), to]];
            let [first, third] = halves.map(|half| self.point(span, middle(half)));
            let flat = || [first, centre, third].iter().all(|&point| distance(point, ends) <= self.tolerance);
            if to - from > 2.0 * CUT_OFF && (to - from > LONGEST || !flat()) {
                waiting
                    .extend([(halves[1], [centre, ends[1]], third), (halves[0], [ends[0], centre], first)]);
            } else {
                self.chords.push(Chord { number: self.chords.len(), span, range, ends });
            }
        }
    }

    /// Calls `visit` for every pair of chords whose boxes meet and that are not neighbours, the earlier one first.
    fn for_each_pair(&self, mut visit: impl FnMut(&Chord, &Chord)) {
        let closed = self.offset.curve().closure() == Closure::Closed;
        let last = self.chords.len().saturating_sub(1);
        let neighbours = |a: &Chord, b: &Chord| {
            let [first, second] = [a.number.min(b.number), a.number.max(b.number)];
            second - first < 2 || (closed && first == 0 && second == last)
        };
        // Swept from left to right: `open` are the chords whose boxes reach the present place.
        let mut order: Vec<&Chord> = self.chords.iter().collect();
        order.sort_by(|a, b| a.low().re.total_cmp(&b.low().re));
        let mut open: Vec<&Chord> = Vec::new();
        for chord in order {
            let (low, high) = (chord.low(), chord.high());
            open.retain(|other| other.high().re + self.tolerance >= low.re);
            for other in &open {
                let apart =
                    other.low().im > high.im + self.tolerance || low.im > other.high().im + self.tolerance;
                if !apart && !neighbours(chord, other) {
                    let (a, b) = if chord.number < other.number { (chord, *other) } else { (*other, chord) };
                    visit(a, b);
                }
            }
            open.push(chord);
        }
    }

    /// The crossing near two parameters by Newton's method; `None` where there is none.
    fn refine(&self, spans: [usize; 2], start: [f64; 2]) -> Option<Crossing> {
        let [mut t, mut s] = start;
        let mut moved = f64::INFINITY;
        for _ in 0..STEPS {
            let ([p, p_slope], [q, q_slope]) = (self.place(spans[0], t), self.place(spans[1], s));
            let off = q - p;
            let across = p_slope.cross(q_slope);
            // Parallel where they touch: no crossing.
            if across.abs() <= 1e-14 * p_slope.norm() * q_slope.norm() {
                return None;
            }
            let steps = [off.cross(q_slope) / across, off.cross(p_slope) / across];
            let next = [(t + steps[0]).clamp(0.0, 1.0), (s + steps[1]).clamp(0.0, 1.0)];
            moved = (next[0] - t).abs().max((next[1] - s).abs());
            [t, s] = next;
            if moved <= 1e-16 {
                break;
            }
        }
        let places = [Place { span: spans[0], u: t }, Place { span: spans[1], u: s }];
        let points = [self.point(spans[0], t), self.point(spans[1], s)];
        // Both branches of a cusp are so near each other that the distance alone says little; but towards a cusp
        // Newton's method only creeps.
        let met = moved <= SETTLED && (points[1] - points[0]).norm() <= MET * self.size;
        if !met || self.along(places[0], places[1]) <= APART {
            return None;
        }
        let [first, second] = places;
        let swapped = second < first;
        Some(Crossing {
            places: if swapped { [second, first] } else { places },
            point: points[usize::from(swapped)].point(),
        })
    }

    /// How far apart two places are along the curve, in parameters of spans.
    fn along(&self, a: Place, b: Place) -> f64 {
        let number = |place: Place| place.span as f64 + place.u;
        let apart = (number(a) - number(b)).abs();
        if self.offset.curve().closure() == Closure::Closed {
            apart.min(self.offset.curve().segments().len() as f64 - apart)
        } else {
            apart
        }
    }
}

/// The distance of a point from a chord.
fn distance(point: Complex, [from, to]: [Complex; 2]) -> f64 {
    let (chord, rest) = (to - from, point - from);
    let square = chord.norm_squared();
    let share = if square > 0.0 { (rest.dot(chord) / square).clamp(0.0, 1.0) } else { 0.0 };
    (rest - chord * share).norm()
}

/// Parameters near the point where two chords cross, or nearly do; `None` where they are further apart.
fn meeting(a: &Chord, b: &Chord, tolerance: f64) -> Option<[f64; 2]> {
    let (along, other, between) = (a.ends[1] - a.ends[0], b.ends[1] - b.ends[0], b.ends[0] - a.ends[0]);
    let across = along.cross(other);
    let parallel = across.abs() <= 1e-12 * along.norm() * other.norm();
    let shares = if parallel {
        [0.5, 0.5]
    } else {
        [between.cross(other) / across, between.cross(along) / across].map(|share| share.clamp(0.0, 1.0))
    };
    let at = |chord: &Chord, share: f64| chord.ends[0] + (chord.ends[1] - chord.ends[0]) * share;
    let near = (at(a, shares[0]) - at(b, shares[1])).norm() <= 4.0 * tolerance;
    near.then(|| {
        let u = |chord: &Chord, share: f64| chord.range[0] + share * (chord.range[1] - chord.range[0]);
        [u(a, shares[0]), u(b, shares[1])]
    })
}
