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
        // Between the ends of the side, so these fit.
        let floor = numerator.div_euclid(height) as i32;
        Some(Crossing { floor, ceil: floor + i32::from(numerator.rem_euclid(height) != 0) })
    }
}

/// The place where a side crosses a row: the pixels next to it on the left and on the right, the same
/// one when it lies on a pixel.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Crossing {
    floor: i32,
    ceil: i32,
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
                    self.span(left.ceil, right.floor, y as i32, fill);
                }
            }
        }
        self.polyline(corners, outline);
        self.line(last.0, last.1, first.0, first.1, outline);
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::assert_art;
    use super::*;
    use proptest::prelude::*;

    fn art(corners: &[(i32, i32)], expected: &str) {
        let mut screen = Screen::new();
        screen.polygon(corners, Color::LightGray, Stroke::thin(Color::White));
        assert_art(&screen, expected);
    }

    #[test]
    fn trapezoid_of_a_raised_frame() {
        art(
            &[(4, 1), (1, 4), (12, 4), (9, 1)],
            "..............
             ....FFFFFF....
             ...F777777F...
             ..F77777777F..
             .FFFFFFFFFFFF.
             ..............",
        );
    }

    #[test]
    fn concave_polygon_keeps_its_notch() {
        art(
            &[(0, 0), (5, 4), (10, 0), (10, 6), (0, 6)],
            "F.........F
             FF.......FF
             F7FF...FF7F
             F777F.F777F
             F7777F7777F
             F777777777F
             FFFFFFFFFFF",
        );
    }

    #[test]
    fn parts_enclosed_twice_stay_empty() {
        art(
            &[(0, 0), (8, 0), (8, 6), (2, 6), (2, 2), (6, 2), (6, 4), (0, 4)],
            "FFFFFFFFF
             F7777777F
             F7FFFFF7F
             F7F...F7F
             FFFFFFF7F
             ..F77777F
             ..FFFFFFF",
        );
    }

    #[test]
    fn no_corner_one_corner_two_corners() {
        art(&[], "..\n..");
        art(&[(1, 0)], ".F\n..");
        art(&[(0, 0), (2, 2)], "F..\n.F.\n..F");
    }

    /// Whether a point lies strictly inside of a triangle.
    fn inside(corners: &[(i32, i32)], x: i64, y: i64) -> bool {
        let turns: Vec<i64> = (0..3)
            .map(|k| {
                let ((ax, ay), (bx, by)) = (corners[k], corners[(k + 1) % 3]);
                let (ax, ay, bx, by) = (i64::from(ax), i64::from(ay), i64::from(bx), i64::from(by));
                (bx - ax) * (y - ay) - (by - ay) * (x - ax)
            })
            .collect();
        turns.iter().all(|&turn| turn > 0) || turns.iter().all(|&turn| turn < 0)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        #[test]
        fn triangles_are_filled(corners in prop::collection::vec((-900..1500, -700..1200), 3)) {
            let mut screen = Screen::new();
            screen.polygon(&corners, Color::LightGray, Stroke::thin(Color::White));
            for (x, y) in (0..640).step_by(7).flat_map(|x| (0..480).step_by(5).map(move |y| (x, y))) {
                let color = screen.pixel(x, y);
                if inside(&corners, i64::from(x), i64::from(y)) {
                    prop_assert_ne!(color, Some(Color::Black));
                } else {
                    prop_assert_ne!(color, Some(Color::LightGray));
                }
            }
        }

        #[test]
        fn any_polygon_is_clipped(corners in prop::collection::vec(any::<(i32, i32)>(), 0..9)) {
            Screen::new().polygon(&corners, Color::Red, Stroke::thick(Color::White));
        }
    }
}
