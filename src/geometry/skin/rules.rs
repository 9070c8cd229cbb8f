//! Which circles and spheres are admissible (definition 2.14), and which rules they break.

use super::{Ball, Circle, Links};
use crate::geometry::Point;
use std::f64::consts::PI;
use std::fmt;

/// A rule that circles (or spheres) break. All are counted from 0; the sentences count from 1 as users see them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Violation {
    /// Rule 1: one is covered by the others.
    Covered {
        /// The one.
        number: usize,
    },
    /// Rule 2: two that are too far apart in the chain (in a tree: no neighbours) have a point in common.
    Meet {
        /// The two.
        numbers: [usize; 2],
    },
    /// Rule 3: the two neighbours of one meet outside it.
    MeetOutside {
        /// The neighbours.
        numbers: [usize; 2],
        /// The one between them.
        middle: usize,
    },
    /// Rule 3 for a ring of three, where all are neighbours: they have a common point, and the ring no hole.
    NoHole {
        /// The three.
        numbers: [usize; 3],
    },
}

impl Violation {
    /// The number of the rule, 1 to 3.
    #[must_use]
    pub fn rule(&self) -> u8 {
        match self {
            Self::Covered { .. } => 1,
            Self::Meet { .. } => 2,
            Self::MeetOutside { .. } | Self::NoHole { .. } => 3,
        }
    }

    /// The circles concerned, from 0, in the order of a chain.
    #[must_use]
    pub fn numbers(&self) -> Vec<usize> {
        match *self {
            Self::Covered { number } => vec![number],
            Self::Meet { numbers } => numbers.to_vec(),
            Self::MeetOutside { numbers: [a, b], middle } => vec![a, middle, b],
            Self::NoHole { numbers } => numbers.to_vec(),
        }
    }
}

impl Violation {
    /// The same with the numbers that a list has in these places.
    pub(super) fn renumbered(&self, list: &[usize]) -> Self {
        let at = |number: usize| list.get(number).copied().unwrap_or(number);
        match *self {
            Self::Covered { number } => Self::Covered { number: at(number) },
            Self::Meet { numbers } => Self::Meet { numbers: numbers.map(at) },
            Self::MeetOutside { numbers, middle } => {
                Self::MeetOutside { numbers: numbers.map(at), middle: at(middle) }
            }
            Self::NoHole { numbers } => Self::NoHole { numbers: numbers.map(at) },
        }
    }

    /// What is wrong in a sentence about a `circle` or a `sphere`.
    #[must_use]
    pub fn sentence(&self, noun: &str) -> String {
        match *self {
            Self::Covered { number } => format!("{noun} {} is covered by the others", number + 1),
            Self::Meet { numbers: [a, b] } => format!("{noun}s {} and {} meet", a + 1, b + 1),
            Self::MeetOutside { numbers: [a, b], middle } => {
                format!("{noun}s {} and {} meet outside {noun} {}", a + 1, b + 1, middle + 1)
            }
            Self::NoHole { numbers: [a, b, c] } => {
                format!("{noun}s {}, {} and {} leave no hole in the ring", a + 1, b + 1, c + 1)
            }
        }
    }
}

/// The sentence about circles.
impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence("circle"))
    }
}

/// All broken rules in their order. `covered` tells which of the balls are covered, by lists of those that each meets;
/// `flat` is three balls in the plane of their centres.
pub(super) fn violations<const D: usize>(
    balls: &[Ball<D>],
    links: &Links,
    covered: impl FnOnce(&[Vec<usize>], f64) -> Vec<usize>,
    flat: impl Fn([&Ball<D>; 3]) -> [Circle; 3],
) -> Vec<Violation> {
    let e = super::tolerance(balls);
    let meeting = meeting(balls, e);
    let mut found: Vec<Violation> =
        covered(&meeting, e).into_iter().map(|number| Violation::Covered { number }).collect();
    let neighbours = links.neighbours(balls.len());
    let far = |i: usize, j: usize| match links {
        Links::Chain => j - i > 2,
        Links::Ring => (j - i).min(balls.len() - (j - i)) > 2,
        Links::Edges(_) => !neighbours.get(i).is_some_and(|list| list.contains(&j)),
    };
    for (i, others) in meeting.iter().enumerate() {
        let pairs = others.iter().filter(|&&j| j > i && far(i, j));
        found.extend(pairs.map(|&j| Violation::Meet { numbers: [i, j] }));
    }
    for [a, middle, b] in links.triples(balls.len()) {
        if lens_outside(flat([a, middle, b].map(|number| &balls[number])), e) {
            found.push(Violation::MeetOutside { numbers: [a, b], middle });
        }
    }
    if let (Links::Ring, [a, b, c]) = (links, balls)
        && have_common_point(flat([a, b, c]), e)
    {
        found.push(Violation::NoHole { numbers: [0, 1, 2] });
    }
    found
}

/// For every ball those that have a point in common with it.
fn meeting<const D: usize>(balls: &[Ball<D>], e: f64) -> Vec<Vec<usize>> {
    let mut meeting = vec![Vec::new(); balls.len()];
    for (i, ball) in balls.iter().enumerate() {
        for (j, other) in balls.iter().enumerate().skip(i + 1) {
            if ball.meets(other, e) {
                meeting[i].push(j);
                meeting[j].push(i);
            }
        }
    }
    meeting
}

/// The discs that are part of the union of the others.
///
/// One that no single other holds is covered when its whole circle is, and no hole between the others lies inside it. A
/// hole has a corner where two others cross, and no further disc there.
pub(super) fn covered_discs(circles: &[Circle], meeting: &[Vec<usize>], e: f64) -> Vec<usize> {
    let is_inside = |i: usize| meeting[i].iter().any(|&j| circles[j].holds(&circles[i], e));
    let (mut covered, rest): (Vec<usize>, Vec<usize>) = (0..circles.len()).partition(|&i| is_inside(i));
    let mut round: Vec<usize> =
        rest.into_iter().filter(|&i| is_rim_covered(&circles[i], &meeting[i], circles, e)).collect();
    if !round.is_empty() {
        let mut has_hole = vec![false; circles.len()];
        let pairs = meeting.iter().enumerate().flat_map(|(j, list)| list.iter().map(move |&k| (j, k)));
        for (j, k) in pairs.filter(|(j, k)| j < k) {
            for corner in crossings(&circles[j], &circles[k]).into_iter().flatten() {
                // Whatever covers the corner meets disc j there.
                let others = meeting[j].iter().filter(|&&i| i != k && circles[i].contains(corner, e));
                let mut others = others.copied();
                if let (Some(i), None) = (others.next(), others.next())
                    && circles[i].distance(corner) < circles[i].radius - e
                {
                    has_hole[i] = true;
                }
            }
        }
        round.retain(|&i| !has_hole[i]);
        covered.append(&mut round);
        covered.sort_unstable();
    }
    covered
}

/// Whether other discs cover a whole circle: the middle of every part that they cut it into.
fn is_rim_covered(circle: &Circle, meeting: &[usize], circles: &[Circle], e: f64) -> bool {
    let mut cuts: Vec<f64> = meeting.iter().filter_map(|&j| cuts(circle, &circles[j])).flatten().collect();
    cuts.sort_by(f64::total_cmp);
    let first = cuts.first().copied().unwrap_or(0.0);
    cuts.push(first + 2.0 * PI);
    let middles =
        cuts.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).chain((cuts.len() == 1).then_some(first));
    middles
        .map(|angle| circle.point([angle.cos(), angle.sin()]))
        .all(|middle| meeting.iter().any(|&j| circles[j].contains(middle, e)))
}

/// The directions from the centre of a circle to where another one cuts it, from 0 to 2 pi.
fn cuts(circle: &Circle, other: &Circle) -> Option<[f64; 2]> {
    let axis = circle.axis(other)?;
    let cosine = axis.radical / circle.radius;
    if cosine.abs() > 1.0 {
        return None;
    }
    let (towards, half) = (axis.direction[1].atan2(axis.direction[0]), cosine.acos());
    Some([towards - half, towards + half].map(|angle| angle.rem_euclid(2.0 * PI)))
}

/// Where two circles cross.
fn crossings(circle: &Circle, other: &Circle) -> Option<[Point<2>; 2]> {
    let axis = circle.axis(other)?;
    let cosine = axis.radical / circle.radius;
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let [x, y] = axis.direction;
    (!sine.is_nan())
        .then(|| [sine, -sine].map(|sine| circle.point([cosine * x - sine * y, cosine * y + sine * x])))
}

/// Whether the first and the last of three discs have a point in common outside the middle one. Their common part is
/// in it when its corners are, and on each of its arcs the point farthest from the centre of the middle one.
fn lens_outside([first, middle, last]: [Circle; 3], e: f64) -> bool {
    if !first.meets(&last, e) {
        return false;
    }
    for (small, large) in [(&first, &last), (&last, &first)] {
        if large.holds(small, e) {
            return !middle.holds(small, e);
        }
    }
    // Discs that only touch have a sine of nearly 0, on either side of it.
    let touching = || first.axis(&last).map(|axis| [first.point(axis.direction); 2]);
    let Some(corners) = crossings(&first, &last).or_else(touching) else { return true };
    let farthest = |circle: &Circle, other: &Circle| {
        let axis = middle.axis(circle)?;
        Some(circle.point(axis.direction)).filter(|point| other.contains(*point, e))
    };
    let arcs = [farthest(&first, &last), farthest(&last, &first)];
    !corners.into_iter().chain(arcs.into_iter().flatten()).all(|point| middle.contains(point, e))
}

/// Whether three discs, none of which lies in another, have a point in common: a corner of two in the third.
fn have_common_point([a, b, c]: [Circle; 3], e: f64) -> bool {
    [(a, b, c), (b, c, a), (c, a, b)].into_iter().any(|(first, last, third)| {
        crossings(&first, &last).into_iter().flatten().any(|corner| third.contains(corner, e))
    })
}
