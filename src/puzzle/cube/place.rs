//! Places of pieces in the cube of 4 x 4 x 4 cells, as masks of 64 bits: cell (x, y, z) is bit x + 4y + 16z.

use super::position::{CsangoCube, CubePiece, ROTATIONS};
use super::shape::{PIECES, SHAPES, TYPES};

/// Number of different shapes.
pub(super) const KINDS: usize = SHAPES.len();
/// How many pieces there are of each shape.
pub(super) const SUPPLY: [u8; KINDS] = [2, 3, 3, 2, 2, 2];

/// A piece in the cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Placed {
    /// The type, counted from 0: see [`super::shape()`].
    pub kind: usize,
    /// Its cells.
    pub mask: u64,
}

/// A filled cube.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Filling {
    /// The fourteen pieces in any order.
    pub placed: Vec<Placed>,
}

impl Filling {
    /// The pieces, by their numbers, with the cube's lowest corner at a cell of the table; pieces of one
    /// type take their places in the order of their numbers. `None` if these are not the fourteen pieces.
    #[must_use]
    pub fn position(&self, corner: [i8; 3]) -> Option<CsangoCube> {
        let mut cube = CsangoCube::start();
        let mut left = self.placed.clone();
        for (index, piece) in cube.pieces.iter_mut().enumerate() {
            let at = left.iter().position(|placed| Some(placed.kind) == kind_of(index))?;
            *piece = laid(index, left.swap_remove(at).mask, corner)?;
        }
        Some(cube)
    }
}

/// The type of a piece, counted from 0.
pub(super) fn kind_of(index: usize) -> Option<usize> {
    TYPES.get(index).copied()
}

/// How a piece lies that has these cells of the cube at a corner: the first of the rotations that do.
pub(super) fn laid(index: usize, mask: u64, corner: [i8; 3]) -> Option<CubePiece> {
    ROTATIONS.iter().find_map(|&rotation| {
        (0..64).filter(|bit| mask >> bit & 1 == 1).find_map(|bit| {
            let own = [bit % 4, bit / 4 % 4, bit / 16].map(|v: i8| v);
            let cell = [corner[0] + own[0], corner[1] + own[1], corner[2] + own[2]];
            let piece = CubePiece { cell, rotation };
            (mask_of(piece.cells(index), corner) == Some(mask)).then_some(piece)
        })
    })
}

/// The mask of cells in the cube at a corner; `None` if one is outside.
pub(super) fn mask_of(cells: impl Iterator<Item = [i8; 3]>, corner: [i8; 3]) -> Option<u64> {
    cells.into_iter().try_fold(0, |mask, cell| {
        let mut bit = 0;
        for (axis, weight) in [1, 4, 16].into_iter().enumerate() {
            let v = cell[axis].checked_sub(corner[axis]).filter(|v| (0..4).contains(v))?;
            bit += weight * u32::from(v.unsigned_abs());
        }
        Some(mask | 1 << bit)
    })
}

/// Every place of every type in the cube, the types one after the other.
pub(super) fn places() -> Vec<Placed> {
    let mut all: Vec<Placed> = Vec::with_capacity(2300);
    for kind in 0..KINDS {
        // Some piece has each type.
        let Some(index) = (0..PIECES).find(|&index| kind_of(index) == Some(kind)) else { continue };
        let begin = all.len();
        for rotation in ROTATIONS {
            for bit in 0..64_i8 {
                let piece = CubePiece { cell: [bit % 4, bit / 4 % 4, bit / 16], rotation };
                let Some(mask) = mask_of(piece.cells(index), [0; 3]) else { continue };
                all.push(Placed { kind, mask });
            }
        }
        // A piece that is its own image in a rotation has every place twice.
        if let Some(own) = all.get_mut(begin..) {
            own.sort_unstable_by_key(|placed| placed.mask);
        }
        all.dedup();
    }
    all
}

/// The 48 symmetries of the cube, mirrors among them, as maps of its cells.
pub(super) fn symmetries() -> Vec<[u8; 64]> {
    let mirrored = [[1, 0, 0], [0, 1, 0], [0, 0, -1]];
    let product = |a: [[i8; 3]; 3], b: [[i8; 3]; 3]| {
        a.map(|row| [0, 1, 2].map(|j: usize| (0..3).map(|k: usize| row[k] * b[k][j]).sum::<i8>()))
    };
    let all = ROTATIONS.iter().flat_map(|&rotation| [rotation, product(rotation, mirrored)]);
    all.map(|matrix| {
        std::array::from_fn(|bit| {
            // In half cells from the centre: -3, -1, 1, 3.
            let from = [bit % 4, bit / 4 % 4, bit / 16].map(|v| 2 * v as i8 - 3);
            let to = matrix.map(|row| (row[0] * from[0] + row[1] * from[1] + row[2] * from[2] + 3) / 2);
            (to[0] + 4 * to[1] + 16 * to[2]).unsigned_abs()
        })
    })
    .collect()
}

/// A mask in another attitude of the cube.
pub(super) fn mapped(mask: u64, symmetry: &[u8; 64]) -> u64 {
    let bits = symmetry.iter().enumerate().filter(|(bit, _)| mask >> bit & 1 == 1);
    bits.fold(0, |image, (_, &to)| image | 1 << (to & 63))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_of_places_are_the_known_ones() {
        let all = places();
        let counts: Vec<_> = (0..KINDS).map(|kind| all.iter().filter(|p| p.kind == kind).count()).collect();
        assert_eq!(counts, [432, 432, 432, 324, 324, 288]);
        assert!(all.windows(2).all(|pair| pair[0].kind <= pair[1].kind));
        let supply: Vec<_> =
            (0..KINDS).map(|kind| TYPES.iter().filter(|&&it| it == kind).count() as u8).collect();
        assert_eq!(supply, SUPPLY);
    }

    #[test]
    fn symmetries_map_places_to_places() {
        let all = places();
        let symmetries = symmetries();
        assert_eq!(symmetries.len(), 48);
        for symmetry in &symmetries {
            let image = mapped(u64::MAX, symmetry);
            assert_eq!(image, u64::MAX);
            // Mirrors exchange types 2 and 3, and 4 and 5.
            for placed in all.iter().step_by(17) {
                assert!(all.iter().any(|other| other.mask == mapped(placed.mask, symmetry)));
            }
        }
    }
}
