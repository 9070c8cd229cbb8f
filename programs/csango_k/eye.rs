//! The perspective of the book (4.17): the viewer looks at the middle of the table from one of three heights
//! and goes around it by steps of 30 degrees. He may come nearer, or go infinitely far away.

use crate::geometry::{Projection, Vertex};
use crate::ui::look::Sight;
use serde::Serialize;

/// A point in space: pixels from the middle of the table, z up.
pub(crate) type Place = [f64; 3];

/// Column of the table's middle on the screen.
const COLUMN: f64 = 260.0;
/// Its row, for each height of the viewer.
const ROWS: [f64; 3] = [380.0, 300.0, 275.0];
/// Edge of a cell in pixels.
pub(crate) const EDGE: f64 = 26.0;

/// Where the viewer is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Eye {
    /// Steps of 30 degrees around the axis z, from -20 degrees.
    around: i32,
    /// How far above: 0 is 70 degrees from the axis z, 1 is 40, 2 is 10.
    height: usize,
    /// How far away.
    #[serde(rename = "projection")]
    pub(crate) sight: Sight,
}

impl Eye {
    pub(crate) const HOME: Eye = Eye { around: 0, height: 0, sight: Sight::Central };

    /// The first place of the viewer, as far away as now.
    pub(crate) fn home(self) -> Eye {
        Eye { sight: self.sight, ..Eye::HOME }
    }

    /// From the next distance.
    pub(crate) fn next_sight(self) -> Eye {
        Eye { sight: self.sight.next(), ..self }
    }

    /// The table and everything on it lie within 300 pixels of the middle, before every eye.
    fn projection(self) -> Projection {
        self.sight.projection(1.0, 300.0)
    }

    /// Turned by a number of steps, modulo a whole turn.
    pub(crate) fn turned(self, steps: i32) -> Eye {
        Eye { around: (self.around + steps).rem_euclid(12), ..self }
    }

    pub(crate) fn higher(self) -> Eye {
        Eye { height: (self.height + 1).min(ROWS.len() - 1), ..self }
    }

    pub(crate) fn lower(self) -> Eye {
        Eye { height: self.height.saturating_sub(1), ..self }
    }

    /// To the right, up, and to the viewer.
    fn seen(self, [x, y, z]: Place) -> Place {
        let (sin_a, cos_a) = f64::from(30 * self.around - 20).to_radians().sin_cos();
        let steps = u8::try_from(self.height).unwrap_or(0); // at most 2
        let (sin_e, cos_e) = f64::from(70 - 30 * i32::from(steps)).to_radians().sin_cos();
        let out = x * cos_a + y * sin_a;
        [y * cos_a - x * sin_a, z * sin_e - out * cos_e, out * sin_e + z * cos_e]
    }

    /// Pixels to the right and up from the middle, and how near it is: a number that grows linearly along
    /// straight lines of the picture.
    fn projected(self, place: Place) -> [f64; 3] {
        self.projection().image(self.seen(place))
    }

    /// The viewer, or a place far away on his side where he is at no place, and the place on the plane through the
    /// middle that is seen at a pixel.
    #[cfg(test)]
    pub(crate) fn ray(self, x: f64, y: f64) -> (Place, Place) {
        // The rows of `seen` are the directions to the right, up and to the viewer.
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|unit| self.seen(unit));
        let back = |seen: Place| columns.map(|c| c[0] * seen[0] + c[1] * seen[1] + c[2] * seen[2]);
        let row = ROWS.get(self.height).copied().unwrap_or(ROWS[0]);
        let (right, up) = (x - COLUMN, row - y);
        let viewer = match self.projection() {
            Projection::Central(distance) => [0.0, 0.0, distance],
            Projection::Parallel => [right, up, 1e5],
        };
        (back(viewer), back([right, up, 0.0]))
    }

    /// A place on the screen with fractions of pixels, y down.
    pub(crate) fn pixel(self, place: Place) -> [f64; 2] {
        let [x, y, _] = self.image(place);
        [x, y]
    }

    /// The same with how near it is.
    pub(crate) fn image(self, place: Place) -> Place {
        let [right, up, near] = self.projected(place);
        [COLUMN + right, ROWS.get(self.height).copied().unwrap_or(ROWS[0]) - up, near]
    }

    /// A place as a corner of the picture.
    pub(crate) fn vertex(self, place: Place) -> Vertex {
        let [right, up, near] = self.projected(place);
        let row = ROWS.get(self.height).copied().unwrap_or(ROWS[0]);
        // Small numbers: the casts cut nothing.
        Vertex {
            x: COLUMN as i32 + right.round() as i32,
            y: row as i32 - up.round() as i32,
            depth: near as f32,
        }
    }

    /// Pixels to the right and down from the foot of the axes in the corner of the field.
    pub(crate) fn axis(self, tip: Place) -> (i32, i32) {
        let [right, up, _] = self.projected(tip);
        (right.round() as i32, -up.round() as i32)
    }

    /// The two axes of the table whose plane faces the viewer most.
    pub(crate) fn facing_plane(self) -> [usize; 2] {
        let towards = |axis: usize| {
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            self.seen(unit)[2].abs()
        };
        let (x, y, z) = (towards(0), towards(1), towards(2));
        if z >= x && z >= y {
            [0, 1]
        } else if x >= y {
            [1, 2]
        } else {
            [0, 2]
        }
    }
}

/// The centre of a cell of the table.
pub(crate) fn centre([u, v, w]: [i8; 3]) -> Place {
    [2 * i32::from(u) - 9, 2 * i32::from(v) - 9, 2 * i32::from(w) + 1]
        .map(|half| f64::from(half) * EDGE / 2.0)
}
