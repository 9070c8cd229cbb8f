//! Filled polygons.
//!
//! The interior is filled row by row between the sides that cross the row (even-odd), and the sides
//! are drawn over it as lines, so that the fill never looks out from under its outline.

use super::{Color, HEIGHT, Screen, Stroke};

/// One side of a polygon that crosses rows, from its upper end to its lower end.
struct Side {
    top: (i64, i64),
    bottom: (i64, i64),
}

impl Side {
    /// The side between two points; `None` for a horizontal one, which crosses no row.
    fn new(a: (i32, i32), b: (i32, i32)) -> Option<Side> {
        let wide = |(x, y): (i32, i32)| (i64::from(x), i64::from(y));
        let (a, b) = (wide(a), wide(b));
        match a.1.cmp(&b.1) {
            std::cmp::Ordering::Less => Some(Side { top: a, bottom: b }),
            std::cmp::Ordering::Equal => None,
            std::cmp::Ordering::Greater => Some(Side { top: b, bottom: a }),
        }
    }

    /// Where the side crosses a row, as a fraction `numerator / height`; the lower end does not
    /// belong to the side, so that a corner between two sides counts once.
    fn crossing(&self, y: i64) -> Option<Crossing> {
        if !(self.top.1..self.bottom.1).contains(&y) {
            return None;
        }
        let height = i128::from(self.bottom.1 - self.top.1);
        let run = i128::from(self.bottom.0 - self.top.0) * i128::from(y - self.top.1);
        let numerator = i128::from(self.top.0) * height + run;
        Some(Crossing {
            floor: numerator.div_euclid(height) as i64,
            exact: numerator.rem_euclid(height) == 0,
        })
    }
}

/// The place where a side crosses a row: the last pixel not right of it, and whether it lies on it.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Crossing {
    floor: i64,
    exact: bool,
}

impl Crossing {
    /// The first pixel not left of the place.
    fn ceil(&self) -> i64 {
        if self.exact { self.floor } else { self.floor + 1 }
    }
}

impl Screen {
    /// Fills a polygon and draws its outline, from each corner to the next and from the last to the
    /// first. Where the sides cross each other, parts enclosed twice are not filled.
    pub fn polygon(&mut self, corners: &[(i32, i32)], fill: Color, outline: Stroke) {
        let (Some(&first), Some(&last)) = (corners.first(), corners.last()) else { return };
        let followers = corners.iter().skip(1).chain([&first]);
        let sides: Vec<Side> = corners.iter().zip(followers).filter_map(|(&a, &b)| Side::new(a, b)).collect();
        let top = sides.iter().map(|side| side.top.1).min().unwrap_or(0);
        let bottom = sides.iter().map(|side| side.bottom.1).max().unwrap_or(0);
        let mut crossings = Vec::new();
        for y in top.max(0)..bottom.min(i64::from(HEIGHT)) {
            crossings.clear();
            crossings.extend(sides.iter().filter_map(|side| side.crossing(y)));
            crossings.sort_unstable();
            for pair in crossings.chunks_exact(2) {
                if let [left, right] = pair {
                    // Crossings lie between two corners, and rows on the screen: both fit.
                    self.span(left.ceil() as i32, right.floor as i32, y as i32, fill);
                }
            }
        }
        self.polyline(corners, outline);
        self.line(last.0, last.1, first.0, first.1, outline);
    }
}
