//! What is known about a PH curve and its offsets: worked out once for a picture, a page and a dump.

use crate::design::{DesignError, Sketch};
use crate::geometry::ph::{Offset, PhCurve, Place};
use crate::geometry::{ParamCurve, Point};
use crate::screen::{Color, Stroke};
use std::cell::RefCell;
use std::rc::Rc;

/// Segments of a span on the screen.
pub(super) const STEPS: usize = 50;
/// Parameters nearer to each other than this are one place.
const SAME: f64 = 1e-11;

/// A curve with its offsets.
#[derive(Debug)]
pub(super) struct Analysis {
    pub(super) curve: PhCurve,
    /// The safe range of distances.
    pub(super) limits: [Option<f64>; 2],
    pub(super) sides: Vec<Side>,
    /// The reason why there is no offset, if there is one.
    pub(super) refused: Option<DesignError>,
}

/// The offset on one side.
#[derive(Debug)]
pub(super) struct Side {
    pub(super) offset: Rc<Offset>,
    /// Its crossings, where it has been trimmed.
    pub(super) crossings: Option<usize>,
    /// The kept stretches, where it has been trimmed.
    pub(super) kept: Vec<[Place; 2]>,
    /// Its connected stretches, kept and cut off.
    pub(super) runs: Vec<(bool, Stretch)>,
}

/// A connected stretch of an offset: spans with their ranges of `u`.
#[derive(Clone, Debug)]
pub(super) struct Stretch {
    offset: Rc<Offset>,
    pieces: Vec<(usize, [f64; 2])>,
}

impl ParamCurve<2> for Stretch {
    fn spans(&self) -> usize {
        self.pieces.len()
    }

    fn closed(&self) -> bool {
        false
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let &(span, [from, to]) = self.pieces.get(span)?;
        let wide = to - from;
        let [point, first, second] = self.offset.at(span, from + wide * u.clamp(0.0, 1.0))?;
        Some([point, first.map(|it| it * wide), second.map(|it| it * wide * wide)])
    }
}

impl Stretch {
    /// How it is drawn: kept parts yellow, cut ones red.
    pub(super) fn stroke(kept: bool) -> Stroke {
        if kept { Stroke::thick(Color::Yellow) } else { Stroke::thin(Color::LightRed) }
    }
}

impl Side {
    fn new(offset: Offset, trim: bool) -> Side {
        let trimmed = trim.then(|| offset.trimmed());
        let offset = Rc::new(offset);
        let mut cuts: Vec<Place> = offset.cusps().to_vec();
        if let Some(trimmed) = &trimmed {
            cuts.extend(trimmed.crossings.iter().flat_map(|crossing| crossing.places));
            cuts.extend(trimmed.kept.iter().flatten());
        }
        let mut runs: Vec<(bool, Stretch)> = Vec::new();
        for span in 0..offset.curve().segments().len() {
            let inside = cuts.iter().filter(|cut| cut.span == span).map(|cut| cut.u);
            let mut marks: Vec<f64> = inside.chain([0.0, 1.0]).collect();
            marks.sort_by(f64::total_cmp);
            for pair in marks.windows(2).filter(|pair| pair[1] - pair[0] > SAME) {
                let middle = Place { span, u: 0.5 * (pair[0] + pair[1]) };
                let kept = trimmed.as_ref().is_none_or(|it| it.kept.iter().any(|part| holds(part, middle)));
                let piece = (span, [pair[0], pair[1]]);
                match runs.last_mut() {
                    Some((same, run)) if *same == kept => run.pieces.push(piece),
                    _ => runs.push((kept, Stretch { offset: Rc::clone(&offset), pieces: vec![piece] })),
                }
            }
        }
        let crossings = trimmed.as_ref().map(|it| it.crossings.len());
        Side { crossings, kept: trimmed.map(|it| it.kept).unwrap_or_default(), runs, offset }
    }

    /// Whether it has been trimmed and nothing is left.
    pub(super) fn vanished(&self) -> bool {
        self.crossings.is_some() && self.kept.is_empty()
    }
}

/// Whether a place lies in a stretch.
fn holds([from, to]: &[Place; 2], place: Place) -> bool {
    let along = |place: &Place| (place.span, place.u);
    along(from) <= along(&place) && along(&place) <= along(to)
}

impl Analysis {
    /// The curve of a sketch with the offsets at some distances, trimmed or whole.
    ///
    /// # Errors
    /// The reason why there is no curve.
    pub(super) fn new(sketch: &Sketch<2>, distances: &[f64], trim: bool) -> Result<Analysis, DesignError> {
        let curve = sketch.ph_curve()?;
        let mut refused = None;
        let mut sides = Vec::new();
        for &distance in distances {
            match curve.offset(distance) {
                Ok(offset) => sides.push(Side::new(offset, trim)),
                Err(error) => refused = Some(error.into()),
            }
        }
        Ok(Analysis { limits: curve.offset_limits(), curve, sides, refused })
    }

    /// How many cusps and crossings the offsets have; no number of crossings where they are not known.
    pub(super) fn counts(&self) -> (usize, Option<usize>) {
        let cusps = self.sides.iter().map(|side| side.offset.cusps().len()).sum();
        (cusps, self.sides.iter().map(|side| side.crossings).sum())
    }

    /// The place of the curve nearest to a point, and its distance.
    pub(super) fn nearest(&self, to: Point<2>) -> Option<(Place, f64)> {
        let far = |at: Point<2>| (at[0] - to[0]).hypot(at[1] - to[1]);
        let place = |k: usize| Place { span: k / STEPS, u: (k % STEPS) as f64 / STEPS as f64 };
        let spans = self.curve.spans();
        let last = Place { span: spans.checked_sub(1)?, u: 1.0 };
        let places = (0..spans * STEPS).map(place).chain([last]);
        let distance = |place: Place| self.curve.eval(place.span, place.u).map_or(f64::INFINITY, far);
        let mut best = places.map(|place| (place, distance(place))).min_by(|a, b| a.1.total_cmp(&b.1))?;
        // Finer and finer steps around the nearest sample.
        let mut step = 1.0 / STEPS as f64;
        for _ in 0..24 {
            step *= 0.5;
            for u in [best.0.u - step, best.0.u + step] {
                let place = Place { span: best.0.span, u: u.clamp(0.0, 1.0) };
                let way = distance(place);
                if way < best.1 {
                    best = (place, way);
                }
            }
        }
        Some(best)
    }

    /// The signed distance of a point from the curve, positive to the left; a tenth of a pixel is enough.
    pub(super) fn signed_distance(&self, of: Point<2>) -> Option<f64> {
        let (place, far) = self.nearest(of)?;
        let at = self.curve.eval(place.span, place.u)?;
        let normal = self.curve.normal(place)?;
        let side = (of[0] - at[0]) * normal[0] + (of[1] - at[1]) * normal[1];
        Some((10.0 * far.copysign(side)).round() / 10.0)
    }

    /// The radius of curvature at a place, with its sign.
    pub(super) fn radius(&self, place: Place) -> Option<f64> {
        self.curve.curvature(place).map(|it| 1.0 / it).filter(|it| it.is_finite())
    }
}

/// The last analysis and what it was made from.
#[derive(Default)]
pub(super) struct Cache(RefCell<Option<Kept>>);

struct Kept {
    sketch: Sketch<2>,
    distances: Vec<f64>,
    trim: bool,
    made: Result<Rc<Analysis>, DesignError>,
}

impl Cache {
    /// The analysis, which is made again only when something has changed.
    pub(super) fn of(
        &self,
        sketch: &Sketch<2>,
        distances: &[f64],
        trim: bool,
    ) -> Result<Rc<Analysis>, DesignError> {
        let same = |kept: &Kept| kept.sketch == *sketch && kept.distances == distances && kept.trim == trim;
        if let Some(kept) = self.0.borrow().as_ref().filter(|kept| same(kept)) {
            return kept.made.clone();
        }
        let made = Analysis::new(sketch, distances, trim).map(Rc::new);
        let kept = Kept { sketch: sketch.clone(), distances: distances.to_vec(), trim, made: made.clone() };
        *self.0.borrow_mut() = Some(kept);
        made
    }
}
