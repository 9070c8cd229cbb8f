//! Positions of the Csángó cube: `.CSK`.
//!
//! 14 records of 1216 bytes, one a piece: the centre of cell 1 (reals), numbers of corners, cells, faces and
//! visible faces (bytes), corners relative to cell 1 and their two projections (18 points of reals each),
//! cells (5 triples of signed bytes, the first absolute, the others relative to it), faces as lists of
//! corners (12 x 9 bytes, the first the length), and what the program computes for the picture.

use super::{FileError, Format};
use crate::pascal::{Reader, Writer};
use crate::puzzle::cube::{add, turned};

pub use crate::puzzle::cube::{CsangoCube, CubePiece, PIECES, PieceShape, ROTATIONS, TABLE, shape};

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
impl CsangoCube {
    /// Checks that every piece is turned by one of the 24 rotations and lies on the table, and that no two
    /// share a cell.
    ///
    /// # Errors
    /// [`FileError::Invalid`] with the piece and what is wrong.
    pub fn check(&self) -> Result<(), FileError> {
        self.fault().map_or(Ok(()), |fault| Err(FileError::Invalid(fault.to_string())))
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
        match cube.fault() {
            None => Ok(cube),
            Some(fault) => Err(at(fault.piece, CELLS + 3 * fault.cell, fault.problem)),
        }
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
