//! A curve with what is shown of it, worked out once for a picture, a line of text and a dump.

use crate::design::knots::edit;
use crate::file::KnotPoints;
use crate::geometry::Point;
use crate::geometry::knots::KnotCurve;
use std::cell::RefCell;
use std::rc::Rc;

/// What is known about a curve.
#[derive(Debug)]
pub(super) struct Facts {
    pub(super) curve: KnotCurve<2>,
    /// The parameters of its inflections.
    pub(super) inflections: Vec<f64>,
}

/// The curves of the last pictures: that of the document, the dragged one, that at the start.
#[derive(Debug, Default)]
pub(super) struct Cache(RefCell<Vec<(KnotPoints, Rc<Facts>)>>);

/// How many are kept.
const KEPT: usize = 4;
/// Places in a span at which a curve is looked at for the place nearest to the mouse.
const STEPS: u32 = 64;

impl Cache {
    /// The facts of a document; `None` for fewer points than the order.
    pub(super) fn of(&self, document: &KnotPoints) -> Option<Rc<Facts>> {
        let mut kept = self.0.borrow_mut();
        if let Some(at) = kept.iter().position(|(known, _)| known == document) {
            let known = kept.remove(at);
            kept.insert(0, known);
        } else {
            let curve = edit::plane(document)?;
            let inflections = curve.inflections();
            kept.insert(0, (document.clone(), Rc::new(Facts { curve, inflections })));
            kept.truncate(KEPT);
        }
        kept.first().map(|(_, facts)| Rc::clone(facts))
    }
}

impl Facts {
    /// A parameter of the curve, moved into its domain; without one a place near the middle.
    pub(super) fn parameter(&self, u: Option<f64>) -> f64 {
        let [from, to] = self.curve.vector().domain();
        u.map_or(from + 0.46 * (to - from), |u| u.clamp(from, to))
    }

    /// The parameter of the place nearest to a point, and how far it is.
    pub(super) fn nearest(&self, [x, y]: Point<2>) -> Option<(f64, f64)> {
        let vector = self.curve.vector();
        let knots = vector.knots();
        let places = vector.filled_spans().iter().flat_map(|&span| {
            (0..=STEPS).map(move |step| {
                let t = f64::from(step) / f64::from(STEPS);
                (1.0 - t) * knots[span] + t * knots[span + 1]
            })
        });
        let far = |u: f64| self.curve.point_at(u).map(|[a, b]| (a - x).hypot(b - y));
        let tried = places.filter_map(|u| Some((u, far(u)?)));
        let (mut u, mut least) = tried.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let [from, to] = vector.domain();
        let mut step = (to - from) / f64::from(STEPS);
        while step > 1e-6 * (to - from) {
            let closer = [u - step, u + step].into_iter().find_map(|other| {
                let off = far(other.clamp(from, to))?;
                (off < least).then_some((other.clamp(from, to), off))
            });
            match closer {
                Some(found) => (u, least) = found,
                None => step *= 0.5,
            }
        }
        Some((u, least))
    }
}
