//! Positions of the Csángó cube: `.CSK`.
//!
//! 14 records of 1216 bytes, one a piece: the centre of cell 1 (reals), numbers of corners, cells, faces and
//! visible faces (bytes), corners relative to cell 1 and their two projections (18 points of reals each),
//! cells (5 triples of signed bytes, the first absolute, the others relative to it), faces as lists of
//! corners (12 x 9 bytes, the first the length), and what the program computes for the picture.

use super::{FileError, Format};
use crate::pascal::{Reader, Writer};
use serde::{Deserialize, Serialize};

pub use super::cube_shapes::{PIECES, PieceShape, TABLE, shape};

const RECORD: usize = 1216;
/// Where the fields stand in a record.
const COUNTS: usize = 18;
const CORNERS: usize = 22;
const CELLS: usize = 994;
const FACES: usize = 1009;
/// Bytes for one face: its length and up to eight corners.
const FACE: usize = 9;
/// Half a cell edge in pixels.
const HALF_EDGE: i32 = 13;
/// Cells of the table.
const TABLE_CELLS: usize = TABLE[0] as usize * TABLE[1] as usize * TABLE[2] as usize;

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

/// What is wrong with a position: piece (counted from 0), offset in its record, sentence.
type Problem = (usize, usize, String);

impl CubePiece {
    /// The cells of piece `index` (counted from 0) lying here, cell 1 first; none for no piece. They are
    /// not cut to the table.
    pub fn cells(&self, index: usize) -> impl Iterator<Item = [i8; 3]> + use<> {
        let Self { cell, rotation } = *self;
        let cells = shape(index).map_or(&[][..], |shape| shape.cells);
        cells.iter().map(move |&relative| add(cell, turned(&rotation, relative)))
    }

    /// The piece whose cells are these, cell 1 first.
    fn from_cells(index: usize, cells: &[[i8; 3]]) -> Option<Self> {
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

    /// Checks that every piece is turned by one of the 24 rotations and lies on the table, and that no two
    /// share a cell.
    ///
    /// # Errors
    /// [`FileError::Invalid`] with the piece and what is wrong.
    pub fn check(&self) -> Result<(), FileError> {
        self.problem()
            .map_or(Ok(()), |(i, _, text)| Err(FileError::Invalid(format!("piece {}: {text}", i + 1))))
    }

    fn problem(&self) -> Option<Problem> {
        let mut owners = [None; TABLE_CELLS];
        for (index, piece) in self.pieces.iter().enumerate() {
            if !ROTATIONS.contains(&piece.rotation) {
                return Some((index, CELLS, "its matrix is none of the 24 rotations".to_owned()));
            }
            for (number, cell) in piece.cells(index).enumerate() {
                let offset = CELLS + 3 * number;
                let Some(owner) = on_table(cell).and_then(|place| owners.get_mut(place)) else {
                    let text = format!("cell {} is at {cell:?}, outside the 10 x 10 x 7 table", number + 1);
                    return Some((index, offset, text));
                };
                if let Some(other) = owner.replace(index + 1) {
                    return Some((index, offset, format!("piece {other} is at {cell:?} as well")));
                }
            }
        }
        None
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let state = if self.is_finished() { "the finished cube" } else { "not finished" };
        let mut lines = vec![format!("position of the Csángó cube, {state}")];
        lines.extend(self.pieces.iter().enumerate().map(|(index, piece)| {
            let cells: Vec<_> = piece.cells(index).map(|[u, v, w]| format!("({u} {v} {w})")).collect();
            format!("piece {}: {}", index + 1, cells.join(" "))
        }));
        lines
    }

    pub(super) fn read(bytes: &[u8]) -> Result<Self, FileError> {
        let at = |index, offset, text| {
            FileError::value(format!("piece {}", index + 1), RECORD * index + offset, text)
        };
        let mut cube = Self::start();
        for (index, (piece, record)) in cube.pieces.iter_mut().zip(bytes.chunks(RECORD)).enumerate() {
            let Some(shape) = shape(index) else { continue }; // there are 14
            *piece = read_piece(index, shape, record)?.map_err(|(offset, text)| at(index, offset, text))?;
        }
        cube.problem().map_or(Ok(cube), |(index, offset, text)| Err(at(index, offset, text)))
    }

    pub(super) fn write(&self) -> Result<Vec<u8>, FileError> {
        let mut writer = Writer::default();
        for (index, piece) in self.pieces.iter().enumerate() {
            let Some(shape) = shape(index) else { continue }; // there are 14
            // Whole numbers below 200: every one has a 6-byte real.
            write_piece(&mut writer, RECORD * index, shape, piece)
                .map_err(|error| FileError::misfit(Format::Csk, error.to_string()))?;
        }
        Ok(writer.into_bytes())
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

/// A piece from its record, or what is wrong at which offset of the record.
fn read_piece(
    index: usize,
    shape: &PieceShape,
    record: &[u8],
) -> Result<Result<CubePiece, (usize, String)>, FileError> {
    let mut reader = Reader::new(record);
    let centre = [reader.real()?, reader.real()?, reader.real()?];
    let counts = [reader.u8()?, reader.u8()?, reader.u8()?].map(usize::from);
    let expected = [shape.corners.len(), shape.cells.len(), shape.faces.len()];
    for (number, ((name, found), right)) in
        ["corners", "cells", "faces"].into_iter().zip(counts).zip(expected).enumerate()
    {
        if found != right {
            return Ok(Err((COUNTS + number, format!("{found} {name}; this piece has {right}"))));
        }
    }
    reader.skip(1)?;
    let mut corners = Vec::with_capacity(shape.corners.len());
    for _ in shape.corners {
        corners.push([reader.real()?, reader.real()?, reader.real()?]);
    }
    reader.skip(CELLS - reader.offset())?;
    let mut cells = Vec::with_capacity(shape.cells.len());
    for _ in shape.cells {
        cells.push([reader.i8()?, reader.i8()?, reader.i8()?]);
    }
    reader.skip(FACES - reader.offset())?;
    let mut faces = Vec::with_capacity(shape.faces.len());
    for _ in shape.faces {
        faces.push(reader.bytes::<FACE>()?);
    }
    Ok(checked(index, shape, centre, &corners, &cells, &faces))
}

/// The piece, if cells, corners, faces and centre agree with its shape and with each other.
fn checked(
    index: usize,
    shape: &PieceShape,
    centre: [f64; 3],
    corners: &[[f64; 3]],
    cells: &[[i8; 3]],
    faces: &[[u8; FACE]],
) -> Result<CubePiece, (usize, String)> {
    let Some((&cell, relative)) = cells.split_first() else {
        return Err((CELLS, "it has no cells".to_owned()));
    };
    let absolute: Vec<_> =
        std::iter::once(cell).chain(relative.iter().map(|&other| add(cell, other))).collect();
    let piece = CubePiece::from_cells(index, &absolute).ok_or_else(|| {
        let text = format!("the cells {relative:?} from cell 1 are none of the 24 rotations of its shape");
        (CELLS + 3, text)
    })?;
    let right = pixel_centre(cell).map(f64::from);
    if centre != right {
        return Err((0, format!("its centre is {centre:?}; cell {cell:?} is at {right:?}")));
    }
    for (number, (&found, &corner)) in corners.iter().zip(shape.corners).enumerate() {
        let right = turned(&piece.rotation, corner).map(|v| f64::from(i32::from(v) * HALF_EDGE));
        if found != right {
            let text = format!("corner {} is {found:?}; turned like its cells it is {right:?}", number + 1);
            return Err((CORNERS + 18 * number, text));
        }
    }
    // The order of the faces, and the corner each begins with, are the program's own business.
    let mut missing: Vec<_> = shape.faces.iter().map(|face| turned_to_least(face)).collect();
    for (number, face) in faces.iter().enumerate() {
        let found = cycle(face);
        let Some(place) = missing.iter().position(|face| *face == found) else {
            let text =
                format!("face {} is none of the faces of this piece, or one of them again", number + 1);
            return Err((FACES + FACE * number, text));
        };
        missing.swap_remove(place);
    }
    Ok(piece)
}

fn write_piece(
    writer: &mut Writer,
    base: usize,
    shape: &PieceShape,
    piece: &CubePiece,
) -> Result<(), crate::pascal::Real48Error> {
    for value in pixel_centre(piece.cell) {
        writer.real(f64::from(value))?;
    }
    for count in [shape.corners.len(), shape.cells.len(), shape.faces.len()] {
        writer.u8(count as u8); // at most 18
    }
    writer.zeros_to(base + CORNERS);
    for &corner in shape.corners {
        for value in turned(&piece.rotation, corner) {
            writer.real(f64::from(i32::from(value) * HALF_EDGE))?;
        }
    }
    writer.zeros_to(base + CELLS);
    piece.cell.into_iter().for_each(|v| writer.i8(v));
    for &cell in shape.cells.iter().skip(1) {
        turned(&piece.rotation, cell).into_iter().for_each(|v| writer.i8(v));
    }
    writer.zeros_to(base + FACES);
    for (number, face) in shape.faces.iter().enumerate() {
        writer.u8(face.len() as u8); // at most 8
        face.iter().for_each(|&corner| writer.u8(corner));
        writer.zeros_to(base + FACES + FACE * (number + 1));
    }
    writer.zeros_to(base + RECORD);
    Ok(())
}

/// The centre of a cell in pixels; the table is centred on the z axis.
fn pixel_centre([u, v, w]: [i8; 3]) -> [i32; 3] {
    [2 * i32::from(u) - 9, 2 * i32::from(v) - 9, 2 * i32::from(w) + 1].map(|half| half * HALF_EDGE)
}

/// The corners of a face in a file, turned so that the least comes first.
fn cycle(face: &[u8; FACE]) -> Option<Vec<u8>> {
    let [length, corners @ ..] = face;
    corners.get(..usize::from(*length)).and_then(turned_to_least)
}

fn turned_to_least(corners: &[u8]) -> Option<Vec<u8>> {
    let least = corners.iter().enumerate().min_by_key(|(_, corner)| **corner)?.0;
    let mut turned = corners.to_vec();
    turned.rotate_left(least);
    Some(turned)
}

/// The number of a cell of the table, below [`TABLE_CELLS`].
fn on_table(cell: [i8; 3]) -> Option<usize> {
    cell.iter().zip(TABLE).try_fold(0, |place, (&v, size)| {
        let v = usize::try_from(v).ok().filter(|_| v < size)?;
        Some(place * usize::from(size.unsigned_abs()) + v)
    })
}

/// Saturating, so that wild numbers end outside the table.
fn add(a: [i8; 3], b: [i8; 3]) -> [i8; 3] {
    let ([a0, a1, a2], [b0, b1, b2]) = (a, b);
    [a0.saturating_add(b0), a1.saturating_add(b1), a2.saturating_add(b2)]
}

fn turned(rotation: &[[i8; 3]; 3], vector: [i8; 3]) -> [i8; 3] {
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
        assert_eq!(CsangoCube::start().check(), Ok(()));
        assert!(!CsangoCube::start().is_finished());
    }

    #[test]
    fn impossible_positions_say_why() {
        let mut cube = CsangoCube::start();
        cube.pieces[1].cell = [8, 4, 0];
        let message = cube.check().unwrap_err().to_string();
        assert_eq!(message, "piece 3: piece 2 is at [8, 4, 0] as well");
        cube.pieces[1].cell = [0, 4, 0];
        let message = cube.check().unwrap_err().to_string();
        assert_eq!(message, "piece 2: cell 3 is at [-1, 4, 0], outside the 10 x 10 x 7 table");
        cube.pieces[1].rotation = [[1, 0, 0], [0, 1, 0], [0, 0, -1]];
        assert_eq!(cube.check().unwrap_err().to_string(), "piece 2: its matrix is none of the 24 rotations");
    }
}
