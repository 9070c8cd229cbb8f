//! Where the fourteen pieces lie on the table.

use super::shape::{PIECES, TABLE, shape};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Cells of the table.
pub(super) const TABLE_CELLS: usize = TABLE[0] as usize * TABLE[1] as usize * TABLE[2] as usize;

/// The 24 rotations of a cube as matrices: `rotated[i] = sum of matrix[i][j] * original[j]`. The first is
/// the identity.
pub const ROTATIONS: [[[i8; 3]; 3]; 24] = rotations();

/// Where a piece lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CubePiece {
    /// Cell 1 on the table: x and y 0..=9, height 0..=6.
    pub cell: [i8; 3],
    /// How the piece is turned from its start: one of [`ROTATIONS`].
    pub rotation: [[i8; 3]; 3],
}

/// A position of the fourteen pieces on the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "Cells", into = "Cells")]
pub struct CsangoCube {
    /// The pieces 1 to 14.
    pub pieces: [CubePiece; PIECES],
}

/// The JSON form: the cells of every piece, cell 1 first.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Cells {
    pieces: Vec<Vec<[i8; 3]>>,
}

/// What is wrong with a position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The piece, counted from 0.
    pub piece: usize,
    /// The cell of the piece, counted from 0; 0 where the whole piece is wrong.
    pub cell: usize,
    /// What is wrong, as a sentence.
    pub problem: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "piece {}: {}", self.piece + 1, self.problem)
    }
}

impl std::error::Error for Fault {}

impl CubePiece {
    /// The cells of piece `index` (counted from 0) lying here, cell 1 first; none for no piece. They are
    /// not cut to the table.
    pub fn cells(&self, index: usize) -> impl Iterator<Item = [i8; 3]> + use<> {
        let Self { cell, rotation } = *self;
        let cells = shape(index).map_or(&[][..], |shape| shape.cells);
        cells.iter().map(move |&relative| add(cell, turned(&rotation, relative)))
    }

    /// The piece whose cells are these, cell 1 first.
    pub(crate) fn from_cells(index: usize, cells: &[[i8; 3]]) -> Option<Self> {
        let &cell = cells.first()?;
        let place = |&rotation| Self { cell, rotation };
        ROTATIONS.iter().map(place).find(|piece| piece.cells(index).eq(cells.iter().copied()))
    }
}

impl CsangoCube {
    /// The pieces as they lie at the start.
    #[must_use]
    pub fn start() -> Self {
        let cells = [
            [6, 8, 0],
            [1, 4, 0],
            [8, 4, 0],
            [0, 8, 0],
            [9, 0, 0],
            [6, 0, 0],
            [1, 2, 0],
            [8, 6, 0],
            [3, 8, 0],
            [1, 6, 0],
            [8, 2, 0],
            [0, 0, 0],
            [9, 8, 0],
            [3, 0, 0],
        ];
        let [identity, ..] = ROTATIONS;
        Self { pieces: cells.map(|cell| CubePiece { cell, rotation: identity }) }
    }

    /// Whether the pieces make the finished cube of 4 x 4 x 4 cells.
    #[must_use]
    pub fn is_finished(&self) -> bool {
        let cells: Vec<_> = self.pieces.iter().enumerate().flat_map(|(i, p)| p.cells(i)).collect();
        (0..3).all(|axis| {
            let along = cells.iter().filter_map(|cell| cell.get(axis)); // three coordinates each
            let (low, high) = along.fold((i8::MAX, i8::MIN), |(l, h), &v| (l.min(v), h.max(v)));
            i16::from(high) - i16::from(low) == 3
        })
    }

    /// What is wrong with a position: a piece is turned by none of the 24 rotations, lies off the table, or
    /// shares a cell with another one.
    #[must_use]
    pub fn fault(&self) -> Option<Fault> {
        let mut owners = [None; TABLE_CELLS];
        for (index, piece) in self.pieces.iter().enumerate() {
            if !ROTATIONS.contains(&piece.rotation) {
                let problem = "its matrix is none of the 24 rotations".to_owned();
                return Some(Fault { piece: index, cell: 0, problem });
            }
            for (number, cell) in piece.cells(index).enumerate() {
                let Some(owner) = on_table(cell).and_then(|place| owners.get_mut(place)) else {
                    let problem =
                        format!("cell {} is at {cell:?}, outside the 10 x 10 x 7 table", number + 1);
                    return Some(Fault { piece: index, cell: number, problem });
                };
                if let Some(other) = owner.replace(index + 1) {
                    let problem = format!("piece {other} is at {cell:?} as well");
                    return Some(Fault { piece: index, cell: number, problem });
                }
            }
        }
        None
    }
}

impl From<CsangoCube> for Cells {
    fn from(cube: CsangoCube) -> Self {
        Self {
            pieces: cube
                .pieces
                .iter()
                .enumerate()
                .map(|(index, piece)| piece.cells(index).collect())
                .collect(),
        }
    }
}

impl TryFrom<Cells> for CsangoCube {
    type Error = String;

    fn try_from(cells: Cells) -> Result<Self, String> {
        if cells.pieces.len() != PIECES {
            return Err(format!("{} pieces; there are {PIECES}", cells.pieces.len()));
        }
        let mut cube = Self::start();
        for (index, (piece, cells)) in cube.pieces.iter_mut().zip(&cells.pieces).enumerate() {
            *piece = CubePiece::from_cells(index, cells).ok_or_else(|| {
                format!("piece {}: these cells are none of its 24 rotations, cell 1 first", index + 1)
            })?;
        }
        Ok(cube)
    }
}

/// The number of a cell of the table, below [`TABLE_CELLS`].
pub(super) fn on_table([x, y, z]: [i8; 3]) -> Option<usize> {
    let [length, width, height] = TABLE;
    let holds = (0..length).contains(&x) && (0..width).contains(&y) && (0..height).contains(&z);
    let [x, y, z, width, height] = [x, y, z, width, height].map(|it| usize::from(it.unsigned_abs()));
    holds.then_some((x * width + y) * height + z)
}

/// The sum of two vectors. Saturating, so that wild numbers end outside the table.
pub(crate) fn add(a: [i8; 3], b: [i8; 3]) -> [i8; 3] {
    let ([a0, a1, a2], [b0, b1, b2]) = (a, b);
    [a0.saturating_add(b0), a1.saturating_add(b1), a2.saturating_add(b2)]
}

/// A vector turned by a matrix.
pub(crate) fn turned(rotation: &[[i8; 3]; 3], vector: [i8; 3]) -> [i8; 3] {
    rotation.map(|row| {
        let sum: i32 = row.iter().zip(vector).map(|(&m, v)| i32::from(m) * i32::from(v)).sum();
        sum.clamp(i32::from(i8::MIN), i32::from(i8::MAX)) as i8
    })
}

/// All signed permutation matrices of determinant 1.
const fn rotations() -> [[[i8; 3]; 3]; 24] {
    let permutations = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];
    let mut all = [[[0; 3]; 3]; 24];
    let mut index = 0;
    while index < 24 {
        let permutation = permutations[index / 4];
        let odd: i8 = if index < 12 { 1 } else { -1 };
        let first: i8 = if index % 4 < 2 { 1 } else { -1 };
        let second: i8 = if index % 2 == 0 { 1 } else { -1 };
        all[index][0][permutation[0]] = first;
        all[index][1][permutation[1]] = second;
        all[index][2][permutation[2]] = first * second * odd;
        index += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twenty_four_different_rotations() {
        for (index, r) in ROTATIONS.iter().enumerate() {
            let minor = |i: usize, j: usize| r[1][i] * r[2][j] - r[1][j] * r[2][i];
            assert_eq!(r[0][0] * minor(1, 2) - r[0][1] * minor(0, 2) + r[0][2] * minor(0, 1), 1);
            assert!(ROTATIONS[..index].iter().all(|other| other != r));
        }
        assert_eq!(ROTATIONS[0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    }

    #[test]
    fn the_start_is_possible_and_not_finished() {
        assert_eq!(CsangoCube::start().fault(), None);
        assert!(!CsangoCube::start().is_finished());
    }

    #[test]
    fn impossible_positions_say_why() {
        let mut cube = CsangoCube::start();
        cube.pieces[1].cell = [8, 4, 0];
        let message = cube.fault().unwrap().to_string();
        assert_eq!(message, "piece 3: piece 2 is at [8, 4, 0] as well");
        cube.pieces[1].cell = [0, 4, 0];
        let message = cube.fault().unwrap().to_string();
        assert_eq!(message, "piece 2: cell 3 is at [-1, 4, 0], outside the 10 x 10 x 7 table");
        cube.pieces[1].rotation = [[1, 0, 0], [0, 1, 0], [0, 0, -1]];
        assert_eq!(cube.fault().unwrap().to_string(), "piece 2: its matrix is none of the 24 rotations");
    }
}
