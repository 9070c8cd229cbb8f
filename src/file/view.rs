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
