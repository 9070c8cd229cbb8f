//! The map of the net beside the page: a disc for each control point, which a click chooses.

use crate::design::Index;
use crate::screen::{Color, Screen, Stroke};

/// The map of a net by its numbers of control points along u and v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Map {
    counts: [usize; 2],
    /// Distance between discs in pixels.
    spacing: [i32; 2],
    radius: i32,
}

/// Centre of the disc of point (0, 0).
const ORIGIN: (i32, i32) = (50, 36);
/// Width and height available for discs, and their preferred distance, in pixels.
const ROOM: [i32; 2] = [70, 32];
const SPACING: [i32; 2] = [10, 8];

impl Map {
    pub(super) fn new(counts: [usize; 2]) -> Map {
        let spacing = [0, 1].map(|direction| {
            let steps = i32::try_from(counts[direction].saturating_sub(1).max(1)).unwrap_or(i32::MAX);
            SPACING[direction].min(ROOM[direction] / steps)
        });
        let radius = if spacing == SPACING { 3 } else { (spacing[0].min(spacing[1]) / 2).clamp(1, 2) };
        Map { counts, spacing, radius }
    }

    fn center(&self, [k, l]: Index) -> (i32, i32) {
        let along = |index: usize, direction: usize| {
            let steps = self.counts[direction].saturating_sub(1).max(1);
            match self.spacing[direction] {
                spacing if spacing == SPACING[direction] => i32::try_from(index).unwrap_or(0) * spacing,
                // Many points share the whole width or height.
                _ => (index as f64 / steps as f64 * f64::from(ROOM[direction])) as i32,
            }
        };
        (ORIGIN.0 + along(k, 0), ORIGIN.1 - along(l, 1))
    }

    /// The control point whose disc is under a pixel.
    pub(super) fn hit(&self, (x, y): (i32, i32)) -> Option<Index> {
        let [rows, columns] = self.counts;
        let distance = |index: Index| {
            let (cx, cy) = self.center(index);
            (x - cx).pow(2) + (y - cy).pow(2)
        };
        let all = (0..rows).flat_map(|k| (0..columns).map(move |l| [k, l]));
        all.min_by_key(|&index| distance(index)).filter(|&index| distance(index) < 10)
    }

    /// Draws the map with one point highlighted.
    pub(super) fn draw(&self, screen: &mut Screen, chosen: Option<Index>) {
        let [rows, columns] = self.counts;
        for k in 0..rows {
            for l in 0..columns {
                let (x, y) = self.center([k, l]);
                let fill = if chosen == Some([k, l]) { Color::LightRed } else { Color::LightGray };
                screen.disc(x, y, self.radius, fill, Color::Black);
            }
        }
        // If not all numbers fit, only the last one is written.
        let named = |count: usize, room: bool| (0..count).filter(move |&index| room || index + 1 == count);
        for k in named(rows, self.spacing[0] == SPACING[0]) {
            screen.text(self.center([k, 0]).0 - 3, 44, &k.to_string(), Color::Black);
        }
        for l in named(columns, self.spacing[1] == SPACING[1]) {
            let name = l.to_string();
            let left = if name.len() > 1 { 28 } else { 36 };
            screen.text(left, self.center([0, l]).1 - 2, &name, Color::Black);
        }
        // To the right of the last number, which may have two digits.
        let right = self.center([rows.saturating_sub(1), 0]).0 + if rows > 10 { 8 } else { 0 };
        for (x, y, letter) in [(20, 20, "l"), (right + 10, 44, "k"), (170, 30, "u"), (140, 4, "v")] {
            screen.text(x, y, letter, Color::LightRed);
        }
        for [x1, y1, x2, y2] in ARROWS {
            screen.line(x1, y1, x2, y2, Stroke::thin(Color::Black));
        }
    }
}

/// The arrows of u and v.
const ARROWS: [[i32; 4]; 6] = [
    [150, 45, 150, 5],
    [150, 5, 152, 9],
    [150, 5, 148, 9],
    [130, 27, 175, 27],
    [175, 27, 171, 29],
    [175, 27, 171, 25],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_click_on_a_disc_is_its_point() {
        let map = Map::new([8, 5]);
        assert_eq!(map.hit((60, 12)), Some([1, 3]));
        assert_eq!(map.hit((124, 36)), None);
        assert_eq!(map.hit((300, 300)), None);
        let large = Map::new([64, 64]);
        assert!(large.center([63, 63]).0 <= 120 && large.center([63, 63]).1 >= 4);
    }
}
