//! The pixels of a depth buffer, each one whole number: of two the larger is the one to be seen.

/// One pixel of a depth buffer: its depth, whether an outline made it, its colour, and the number of the
/// cell, from the highest bits to the lowest, so that of two the larger is the one to be seen. Zero where
/// nothing is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Pixel(u64);

impl Pixel {
    /// The colour drawn here, if anything is.
    #[inline]
    #[must_use]
    pub fn color(self) -> Option<u8> {
        (self.0 != 0).then_some((self.0 >> COLOR) as u8)
    }

    #[inline]
    pub(super) fn is_as_near_as(self, other: Pixel) -> bool {
        self.0 >> DEPTH == other.0 >> DEPTH
    }

    /// Whether the cell of an ink was the last to come as near as this pixel.
    #[inline]
    pub(super) fn is_of(self, ink: Ink) -> bool {
        (self.0 ^ ink.0) & OWNER == 0
    }

    /// The least of all pixels that are nearer than this one.
    #[inline]
    pub(super) fn least_nearer(self) -> Pixel {
        Pixel(((self.0 >> DEPTH) + 1) << DEPTH)
    }

    /// The pixel as deep, of an ink.
    #[inline]
    pub(super) fn inked(self, ink: Ink) -> Pixel {
        Pixel(self.0 >> DEPTH << DEPTH | ink.0)
    }

    /// The pixel of no cell that is still to be drawn.
    pub(super) fn disowned(self) -> Pixel {
        Pixel(self.0 & !OWNER)
    }

    /// The pixel with the cell's number of another one.
    #[inline]
    pub(super) fn owned_as(self, other: Pixel) -> Pixel {
        Pixel(self.0 & !OWNER | other.0 & OWNER)
    }
}

/// The lowest bit of a pixel's colour; below are the bits of the cell's number.
const COLOR: u32 = 23;
/// The bits of the cell's number, and the largest number.
pub(super) const OWNER: u64 = (1 << COLOR) - 1;
/// The bit of an outline.
const OUTLINE: u64 = 1 << 31;
/// The lowest bit of a pixel's depth.
const DEPTH: u32 = 32;

/// What a pixel holds besides its depth.
#[derive(Clone, Copy)]
pub(super) struct Ink(u64);

impl Ink {
    #[inline]
    pub(super) fn fill(color: u8, owner: u64) -> Ink {
        Ink(u64::from(color) << COLOR | owner)
    }

    #[inline]
    pub(super) fn outline(color: u8, owner: u64) -> Ink {
        Ink(OUTLINE | u64::from(color) << COLOR | owner)
    }

    #[inline]
    pub(super) fn at(self, depth: f32) -> Pixel {
        // Zero has one sign only. The bits of positive numbers are in order; those of negative ones are
        // in reverse.
        let bits = (depth + 0.0).to_bits();
        let order = bits ^ (((bits as i32 >> 31) as u32) | 1 << 31);
        Pixel(u64::from(order) << DEPTH | self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearer_pixels_are_larger() {
        let depths = [-1e20, -2.5, -2.0, -1e-40, 0.0, 1e-40, 1.0, 1.5, 1e20];
        let pixels = depths.map(|depth| Ink::fill(7, 1).at(depth));
        assert!(pixels.is_sorted() && pixels.iter().all(|pixel| pixel.color() == Some(7)));
        assert!(pixels.windows(2).all(|pair| pair[0].least_nearer() <= pair[1]));
        assert!(pixels.iter().all(|pixel| pixel.least_nearer() > pixel.inked(Ink::outline(255, OWNER))));
        assert_eq!(Ink::fill(7, 1).at(-0.0), Ink::fill(7, 1).at(0.0));
        assert!(Ink::fill(9, 5).at(1.0) < Ink::outline(0, 1).at(1.0));
    }
}
