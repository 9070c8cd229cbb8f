//! A surface as one B-spline surface, the form in which other programs take exact surfaces.

use crate::geometry::point::lerp;
use crate::geometry::{BoundingBox, Point};

/// A B-spline surface over clamped knots, rational if its control points have weights. Direction 0 is `u`, 1 is `v`.
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
    /// The weights of the control points of a rational surface, in the order of the net.
    pub weights: Option<Vec<Vec<f64>>>,
}

/// Every index as often as its multiplicity says.
pub(super) fn repeated(multiplicities: &[usize]) -> impl Iterator<Item = usize> + '_ {
    multiplicities.iter().enumerate().flat_map(|(k, &count)| std::iter::repeat_n(k, count))
}

impl BSplineSurface {
    /// The surface by homogeneous control points (xw, yw, zw, w) with positive weights.
    pub(in crate::geometry) fn rational(
        degrees: [usize; 2],
        knots: [Vec<f64>; 2],
        multiplicities: [Vec<usize>; 2],
        net: &[Vec<[f64; 4]>],
    ) -> Self {
        let point = |[x, y, z, w]: &[f64; 4]| [x / w, y / w, z / w];
        let weights = net.iter().map(|row| row.iter().map(|point| point[3]).collect()).collect();
        let net = net.iter().map(|row| row.iter().map(point).collect()).collect();
        Self { degrees, knots, multiplicities, net, weights: Some(weights) }
    }

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
        let Some(weights) = &self.weights else {
            let row: Option<Vec<Point<3>>> =
                self.net.iter().map(|row| de_boor(self.degrees[1], &v, row, t)).collect();
            return de_boor(self.degrees[0], &u, &row?, s);
        };
        let row: Option<Vec<[f64; 4]>> = self
            .net
            .iter()
            .zip(weights)
            .map(|(row, weights)| {
                let weighted = |([x, y, z], w): (&Point<3>, &f64)| [x * w, y * w, z * w, *w];
                let row: Vec<[f64; 4]> = row.iter().zip(weights).map(weighted).collect();
                de_boor(self.degrees[1], &v, &row, t)
            })
            .collect();
        let [x, y, z, w] = de_boor(self.degrees[0], &u, &row?, s)?;
        let point = [x / w, y / w, z / w];
        point.iter().all(|x| x.is_finite()).then_some(point)
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
    pub(in crate::geometry) fn close(&mut self, closed: [bool; 2]) {
        let bounds = BoundingBox::around(self.net.iter().flatten().copied());
        let rounding = bounds.map_or(0.0, |it| it.rounding());
        let near = |a: &Point<3>, b: &Point<3>| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= rounding);
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
fn de_boor<const D: usize>(degree: usize, knots: &[f64], points: &[[f64; D]], t: f64) -> Option<[f64; D]> {
    if points.len() <= degree || knots.len() != points.len() + degree + 1 {
        return None;
    }
    let t = t.clamp(*knots.first()?, knots.last()?.max(*knots.first()?));
    // The last span that begins at or before t, and is not the empty one behind the last knot.
    let span = (degree..points.len()).rev().find(|&j| knots[j] <= t && knots[j] < knots[j + 1])?;
    let mut d: Vec<[f64; D]> = points.get(span - degree..=span)?.to_vec();
    for round in 1..=degree {
        for j in (round..=degree).rev() {
            let (from, to) = (knots[span - degree + j], knots[span + 1 + j - round]);
            d[j] = lerp(d[j - 1], d[j], (t - from) / (to - from));
        }
    }
    d.last().copied()
}
