//! The mouse pointers of the picture: what a press would do.

use crate::machine::Pointer;
use crate::screen::Masks;

/// What a press would do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// Move the view.
    Arrow,
    /// Select an item.
    Hand,
    /// Take a control point.
    Point,
    /// Move the selected item.
    Move,
}

pub(super) fn of(shape: Shape) -> Pointer {
    Pointer::Shown(match shape {
        Shape::Arrow => &Masks::ARROW,
        Shape::Hand => &HAND,
        Shape::Point => &POINT,
        Shape::Move => &MOVE,
    })
}

/// A white figure with a black edge round it.
const fn edged(figure: [u16; 16], hot: (i32, i32)) -> Masks {
    let mut screen = [0xFFFF; 16];
    let mut row = 0;
    while row < 16 {
        let mut near = figure[row];
        if row > 0 {
            near |= figure[row - 1];
        }
        if row < 15 {
            near |= figure[row + 1];
        }
        screen[row] = !(near | near << 1 | near >> 1);
        row += 1;
    }
    Masks { screen, cursor: figure, hot }
}

const HAND: Masks = edged(
    [
        0x0000, 0x0600, 0x0600, 0x0600, 0x0600, 0x06D8, 0x06D8, 0x36D8, 0x37F8, 0x3FF8, 0x1FF8, 0x0FF8,
        0x0FF0, 0x07F0, 0x07E0, 0x0000,
    ],
    (6, 1),
);

const POINT: Masks = edged(
    [
        0x0000, 0x0100, 0x0100, 0x0100, 0x0000, 0x0380, 0x07C0, 0x76DC, 0x07C0, 0x0380, 0x0000, 0x0100,
        0x0100, 0x0100, 0x0000, 0x0000,
    ],
    (7, 7),
);

const MOVE: Masks = edged(
    [
        0x0000, 0x0100, 0x0380, 0x07C0, 0x0100, 0x1110, 0x3118, 0x7FFC, 0x3118, 0x1110, 0x0100, 0x07C0,
        0x0380, 0x0100, 0x0000, 0x0000,
    ],
    (7, 7),
);
