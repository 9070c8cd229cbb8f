//! The painted picture beside the right one: of every pixel what was painted last, and what is nearest.

use super::face::Face;
use crate::geometry::MAX_SIDE;

/// A pixel by the depths of faces.
#[derive(Clone, Copy)]
struct Place {
    last: f64,
    nearest: f64,
}

/// The field of pixels.
pub(super) struct Field {
    size: [usize; 2],
    slack: f64,
    places: Vec<Place>,
    wrong: usize,
}

impl Field {
    pub(super) fn new(size: [usize; 2], slack: f64) -> Field {
        let size = size.map(|side| side.min(MAX_SIDE));
        let empty = Place { last: f64::NEG_INFINITY, nearest: f64::NEG_INFINITY };
        Field { size, slack, places: vec![empty; size[0] * size[1]], wrong: 0 }
    }

    /// The number of pixels that show something else than what is nearest.
    pub(super) fn wrong(&self) -> usize {
        self.wrong
    }

    /// These pixels, row by row.
    pub(super) fn wrong_pixels(&self) -> Vec<[i32; 2]> {
        let width = self.size[0].max(1);
        let wrong =
            self.places.iter().enumerate().filter(|(_, place)| place.nearest > place.last + self.slack);
        // Sides are at most a few thousand pixels.
        wrong.map(|(at, _)| [(at % width) as i32, (at / width) as i32]).collect()
    }

    /// Paints a face over all before; returns how many pixels of something nearer it hides.
    pub(super) fn paint(&mut self, face: &Face) -> usize {
        let mut spoils = 0;
        let rows = clipped(face.low[1], face.high[1], self.size[1]);
        for y in rows {
            let mut ends: Vec<f64> = face.crossings(y as f64).collect();
            ends.sort_by(f64::total_cmp);
            for pair in ends.chunks_exact(2) {
                let &[from, to] = pair else { continue };
                for x in clipped(from, to, self.size[0]) {
                    let depth = face.depth([x as f64, y as f64]);
                    let Some(place) = self.places.get_mut(y * self.size[0] + x) else { continue };
                    let was = place.nearest > place.last + self.slack;
                    *place = Place { last: depth, nearest: place.nearest.max(depth) };
                    let is = place.nearest > place.last + self.slack;
                    spoils += usize::from(is);
                    self.wrong = self.wrong + usize::from(is) - usize::from(was);
                }
            }
        }
        spoils
    }
}

/// The whole numbers from one place to before another one, within a picture.
fn clipped(from: f64, to: f64, size: usize) -> std::ops::Range<usize> {
    // Not negative, and small.
    let limit = |x: f64| x.ceil().clamp(0.0, size as f64) as usize;
    limit(from)..limit(to)
}
