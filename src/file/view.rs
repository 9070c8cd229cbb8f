//! The orthogonal projection of the 3-D programs, as far as their files hold its results.

/// The centre of the drawing field on the screen.
const CENTRE: [f64; 2] = [331.0, 260.0];

/// A direction towards the viewer; not along z.
#[derive(Clone, Copy, Debug)]
pub(super) struct View(pub(super) [f64; 3]);

impl View {
    /// The place on the screen, cut to 16 bits; rounded half to even.
    pub(super) fn screen(self, [x, y, z]: [f64; 3]) -> [i16; 2] {
        let [a, b, c] = self.0;
        let (flat, scale) = self.lengths();
        let right = (a * y - b * x) / flat;
        let up = (flat * flat * z - c * (a * x + b * y)) / scale;
        // A conversion to i16 cuts to its range.
        [CENTRE[0] + right.round_ties_even(), CENTRE[1] - up.round_ties_even()].map(|v| v as i16)
    }

    /// The depth that the 3-D curve programs sort by: larger is nearer.
    pub(super) fn depth(self, [x, y, z]: [f64; 3]) -> f64 {
        let [a, b, c] = self.0;
        (a * x + b * y + c * z) / self.lengths().1
    }

    /// Length of the view vector along the ground, and that times its full length.
    fn lengths(self) -> (f64, f64) {
        let [a, b, c] = self.0;
        let flat = a.hypot(b);
        (flat, flat * flat.hypot(c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pascal::Reader;

    /// A view after steps of 3 degrees to the left (or, below zero, to the right) and up.
    fn rotated([a, b, c]: [f64; 3], left: i32, up: i32) -> View {
        let (sin, cos) = (3.0 * f64::from(left)).to_radians().sin_cos();
        let [a, b] = [a * cos - b * sin, a * sin + b * cos];
        let (sin, cos) = (3.0 * f64::from(up)).to_radians().sin_cos();
        let flat = a.hypot(b);
        View([a * cos + a * c / flat * sin, b * cos + b * c / flat * sin, c * cos - flat * sin])
    }

    #[test]
    fn places_that_the_dos_programs_saved() {
        let heights = include_bytes!("../../tests/files/TESZT.FEM");
        let sphere = include_bytes!("../../tests/files/TESZT.ZMS");
        let hermite = include_bytes!("../../tests/files/TESZT.FHC");
        for (bytes, view, drawn) in [
            (heights, rotated([0.3, -0.7, 0.2], -55, 8), 40),
            (sphere, rotated([0.3, -0.7, 0.2], 1, 2), 40),
            (hermite, rotated([0.4, -0.7, 0.2], 5, 34), 4),
        ] {
            let mut reader = Reader::new(bytes);
            let mut found = 0;
            for record in 0..40 {
                let mut coordinate = || f64::from(reader.single().unwrap());
                let point = [coordinate(), coordinate(), coordinate()];
                let place = [reader.i16().unwrap(), reader.i16().unwrap()];
                if place != [0; 2] {
                    assert_eq!(view.screen(point), place, "record {record}");
                    found += 1;
                }
            }
            assert_eq!(found, drawn);
        }
    }

    #[test]
    fn far_places_are_cut() {
        assert_eq!(View([1.0, 0.0, 0.0]).screen([0.0, 1e300, -1e300]), [i16::MAX, i16::MAX]);
    }
}
