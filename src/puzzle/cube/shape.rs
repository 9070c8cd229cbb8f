//! The fourteen pieces of the Csángó cube: cells, corners and faces of the six types.

/// Size of the table that the pieces lie on, in cells: x, y and height.
pub const TABLE: [i8; 3] = [10, 10, 7];

/// Number of pieces.
pub const PIECES: usize = 14;

/// The shape of a piece as it lies at the start. Cell 1 is the pivot of rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PieceShape {
    /// Cells relative to cell 1, which is the first.
    pub cells: &'static [[i8; 3]],
    /// Corners relative to the centre of cell 1, in half cell edges.
    pub corners: &'static [[i8; 3]],
    /// Corners of every face, counted from 1, anticlockwise seen from outside; the first three make a
    /// convex corner.
    pub faces: &'static [&'static [u8]],
}

/// The shape of piece `index`, counted from 0; `None` from [`PIECES`] on. Pieces of one type share a shape.
#[must_use]
pub fn shape(index: usize) -> Option<&'static PieceShape> {
    TYPES.get(index).and_then(|&kind| SHAPES.get(kind))
}

/// The type of each piece, counted from 0.
pub(super) const TYPES: [usize; PIECES] = [0, 1, 2, 3, 4, 5, 1, 2, 0, 1, 2, 3, 4, 5];

/// The shapes of the six types.
pub(super) const SHAPES: [PieceShape; 6] = [
    PieceShape {
        cells: &[[0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, 1, 1]],
        corners: &[
            [3, -1, 1],
            [-3, -1, 1],
            [-3, -1, -1],
            [3, -1, -1],
            [3, 1, 1],
            [-3, 1, 1],
            [-3, 1, -1],
            [3, 1, -1],
            [1, 1, -1],
            [1, 3, -1],
            [-1, 3, -1],
            [-1, 1, -1],
            [1, 1, 3],
            [1, 3, 3],
            [-1, 3, 3],
            [-1, 1, 3],
            [1, 1, 1],
            [-1, 1, 1],
        ],
        faces: &[
            &[1, 4, 8, 5],
            &[2, 6, 7, 3],
            &[10, 11, 15, 14],
            &[1, 2, 3, 4],
            &[13, 14, 15, 16],
            &[4, 3, 7, 12, 11, 10, 9, 8],
            &[9, 10, 14, 13],
            &[11, 12, 16, 15],
            &[8, 9, 17, 5],
            &[7, 6, 18, 12],
            &[13, 16, 18, 17],
            &[5, 6, 2, 1],
        ],
    },
    PieceShape {
        cells: &[[0, 0, 0], [1, 0, 0], [-1, 0, 0], [-1, 1, 0], [-1, 1, 1]],
        corners: &[
            [3, -1, 1],
            [-3, -1, 1],
            [-3, -1, -1],
            [3, -1, -1],
            [3, 1, 1],
            [-3, 1, 1],
            [-1, 1, 1],
            [3, 1, -1],
            [-3, 3, 3],
            [-3, 3, -1],
            [-1, 3, -1],
            [-1, 1, -1],
            [-3, 1, 3],
            [-1, 1, 3],
            [-1, 3, 3],
        ],
        faces: &[
            &[1, 4, 8, 5],
            &[9, 10, 3, 2, 6, 13],
            &[11, 10, 9, 15],
            &[1, 2, 3, 4],
            &[9, 13, 14, 15],
            &[4, 3, 10, 11, 12, 8],
            &[15, 14, 12, 11],
            &[5, 8, 12, 7],
            &[6, 7, 14, 13],
            &[5, 6, 2, 1],
        ],
    },
    PieceShape {
        cells: &[[0, 0, 0], [1, 0, 0], [-1, 0, 0], [1, 1, 0], [1, 1, 1]],
        corners: &[
            [3, -1, 1],
            [-3, -1, 1],
            [-3, -1, -1],
            [3, -1, -1],
            [3, 1, 1],
            [-3, 1, 1],
            [-3, 1, -1],
            [1, 1, 1],
            [1, 1, -1],
            [1, 3, -1],
            [3, 3, 3],
            [3, 1, 3],
            [1, 1, 3],
            [1, 3, 3],
            [3, 3, -1],
        ],
        faces: &[
            &[1, 4, 15, 11, 12, 5],
            &[2, 6, 7, 3],
            &[11, 15, 10, 14],
            &[1, 2, 3, 4],
            &[14, 13, 12, 11],
            &[4, 3, 7, 9, 10, 15],
            &[13, 14, 10, 9],
            &[8, 9, 7, 6],
            &[12, 13, 8, 5],
            &[5, 6, 2, 1],
        ],
    },
    PieceShape {
        cells: &[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 1, 1]],
        corners: &[
            [3, -1, 1],
            [-1, -1, 1],
            [-1, -1, -1],
            [3, -1, -1],
            [3, 1, 1],
            [-1, 1, 1],
            [-1, 1, 3],
            [3, 1, -1],
            [1, 1, -1],
            [1, 3, -1],
            [-1, 3, -1],
            [1, 1, 1],
            [1, 1, 3],
            [1, 3, 3],
            [-1, 3, 3],
        ],
        faces: &[
            &[1, 4, 8, 5],
            &[3, 2, 6, 7, 15, 11],
            &[10, 11, 15, 14],
            &[1, 2, 3, 4],
            &[7, 13, 14, 15],
            &[4, 3, 11, 10, 9, 8],
            &[9, 10, 14, 13],
            &[8, 9, 12, 5],
            &[12, 13, 7, 6],
            &[5, 6, 2, 1],
        ],
    },
    PieceShape {
        cells: &[[0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, 1, 1]],
        corners: &[
            [1, -1, 1],
            [-3, -1, 1],
            [-3, -1, -1],
            [1, -1, -1],
            [1, 1, 1],
            [-3, 1, 1],
            [-3, 1, -1],
            [-1, 1, 3],
            [-1, 1, 1],
            [1, 3, -1],
            [-1, 3, -1],
            [-1, 1, -1],
            [1, 1, 3],
            [1, 3, 3],
            [-1, 3, 3],
        ],
        faces: &[
            &[1, 4, 10, 14, 13, 5],
            &[2, 6, 7, 3],
            &[10, 11, 15, 14],
            &[1, 2, 3, 4],
            &[8, 13, 14, 15],
            &[4, 3, 7, 12, 11, 10],
            &[11, 12, 8, 15],
            &[9, 12, 7, 6],
            &[8, 9, 5, 13],
            &[5, 6, 2, 1],
        ],
    },
    PieceShape {
        cells: &[[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 1, 0]],
        corners: &[
            [3, -1, 1],
            [-1, -1, 1],
            [-1, -1, -1],
            [3, -1, -1],
            [3, 1, 1],
            [-3, 1, 1],
            [-3, 1, -1],
            [3, 1, -1],
            [1, 1, -1],
            [1, 3, -1],
            [-3, 3, -1],
            [-1, 1, -1],
            [1, 1, 1],
            [1, 3, 1],
            [-3, 3, 1],
            [-1, 1, 1],
        ],
        faces: &[
            &[1, 4, 8, 5],
            &[6, 15, 11, 7],
            &[10, 11, 15, 14],
            &[1, 2, 3, 4],
            &[13, 14, 15, 6, 16, 2, 1, 5],
            &[4, 3, 12, 7, 11, 10, 9, 8],
            &[9, 10, 14, 13],
            &[16, 12, 3, 2],
            &[8, 9, 13, 5],
            &[6, 7, 12, 16],
        ],
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area vector of a face, in quarter cell faces.
    fn area(corners: &[[i32; 3]]) -> [i32; 3] {
        let mut sum = [0; 3];
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            for (axis, s) in sum.iter_mut().enumerate() {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                *s += a[i] * b[j] - a[j] * b[i];
            }
        }
        sum
    }

    #[test]
    fn the_pieces_fill_a_cube() {
        assert_eq!((0..PIECES).filter_map(shape).map(|s| s.cells.len()).sum::<usize>(), 64);
        assert_eq!(shape(PIECES), None);
    }

    #[test]
    fn faces_close_around_the_volume_of_the_cells() {
        for shape in &SHAPES {
            let mut closed = [0; 3];
            let mut volume = 0;
            for face in shape.faces {
                let corners: Vec<_> =
                    face.iter().map(|&c| shape.corners[usize::from(c) - 1].map(i32::from)).collect();
                let area = area(&corners);
                for axis in 0..3 {
                    closed[axis] += area[axis];
                    volume += area[axis] * corners[0][axis];
                }
            }
            assert_eq!(closed, [0; 3]);
            // Divergence theorem: sum of area . point / 3, with doubled areas, in eighths of a cell.
            assert_eq!(volume, 6 * 8 * shape.cells.len() as i32);
        }
    }
}
