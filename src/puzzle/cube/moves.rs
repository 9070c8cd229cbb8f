//! The twelve things that can be done with a piece: moves by one cell and turns by a right angle.

use super::position::{CsangoCube, CubePiece, TABLE_CELLS, add, on_table};
use super::shape::PIECES;
use crate::geometry::Dice;
use std::fmt;

/// Words of 64 bits that a table takes.
const WORDS: usize = TABLE_CELLS.div_ceil(64);

/// What is done with a piece. Turns go about an axis through cell 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Action {
    /// X: one cell towards +x.
    X,
    /// U: one cell towards -x.
    U,
    /// Y: one cell towards +y.
    Y,
    /// V: one cell towards -y.
    V,
    /// Z: one cell up.
    Z,
    /// W: one cell down.
    W,
    /// R: (x, y, z) becomes (x, -z, y).
    R,
    /// E: (x, y, z) becomes (x, z, -y).
    E,
    /// S: (x, y, z) becomes (z, y, -x).
    S,
    /// F: (x, y, z) becomes (-z, y, x).
    F,
    /// T: (x, y, z) becomes (-y, x, z).
    T,
    /// G: (x, y, z) becomes (y, -x, z).
    G,
}

impl Action {
    /// Every action.
    pub const ALL: [Action; 12] = [
        Action::X,
        Action::U,
        Action::Y,
        Action::V,
        Action::Z,
        Action::W,
        Action::R,
        Action::E,
        Action::S,
        Action::F,
        Action::T,
        Action::G,
    ];

    /// The letter that stands for it.
    #[must_use]
    pub const fn letter(self) -> char {
        // In the order of the variants, all of them.
        ['X', 'U', 'Y', 'V', 'Z', 'W', 'R', 'E', 'S', 'F', 'T', 'G'][self as usize]
    }

    /// The action of an upper-case letter.
    #[must_use]
    pub fn from_letter(letter: char) -> Option<Action> {
        Action::ALL.into_iter().find(|action| action.letter() == letter)
    }

    /// The action that takes this one back.
    #[must_use]
    pub fn reverse(self) -> Action {
        use Action::*;
        match self {
            X => U,
            U => X,
            Y => V,
            V => Y,
            Z => W,
            W => Z,
            R => E,
            E => R,
            S => F,
            F => S,
            T => G,
            G => T,
        }
    }

    /// The step in cells; `None` for a turn.
    #[must_use]
    pub fn step(self) -> Option<[i8; 3]> {
        match self {
            Action::X => Some([1, 0, 0]),
            Action::U => Some([-1, 0, 0]),
            Action::Y => Some([0, 1, 0]),
            Action::V => Some([0, -1, 0]),
            Action::Z => Some([0, 0, 1]),
            Action::W => Some([0, 0, -1]),
            _ => None,
        }
    }

    /// A vector from the pivot after the action; a move leaves it.
    #[must_use]
    pub fn turn(self, [x, y, z]: [i8; 3]) -> [i8; 3] {
        match self {
            Action::R => [x, -z, y],
            Action::E => [x, z, -y],
            Action::S => [z, y, -x],
            Action::F => [-z, y, x],
            Action::T => [-y, x, z],
            Action::G => [y, -x, z],
            _ => [x, y, z],
        }
    }

    /// A piece after the action, wherever that is.
    #[must_use]
    pub fn apply(self, piece: CubePiece) -> CubePiece {
        if let Some(step) = self.step() {
            return CubePiece { cell: add(piece.cell, step), ..piece };
        }
        // The columns of a rotation are what becomes of the axes.
        let m = piece.rotation;
        let columns = [0, 1, 2].map(|j| self.turn([m[0][j], m[1][j], m[2][j]]));
        CubePiece { rotation: [0, 1, 2].map(|i| [columns[0][i], columns[1][i], columns[2][i]]), ..piece }
    }
}

/// An action with the piece it is done with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Move {
    /// The piece, counted from 0.
    pub piece: usize,
    /// What is done.
    pub action: Action,
}

impl Move {
    /// The move that takes this one back.
    #[must_use]
    pub fn reverse(self) -> Move {
        Move { action: self.action.reverse(), ..self }
    }
}

impl fmt::Display for Move {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.piece + 1, self.action.letter())
    }
}

/// What a turn needs. Moves by a cell pass through nothing anyway.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Rules {
    /// As in the book: only the cells at the end must be free, so that a turn may go through other pieces.
    #[default]
    Book,
    /// As with pieces of wood: every cell that the piece sweeps must be free, and nothing gets below the
    /// table. Beside and above the table there is air.
    Rigid,
}

/// Why a move is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refused {
    /// There is no such piece.
    NoPiece,
    /// A cell of the piece would leave the table.
    OffTable,
    /// Another piece is in the way, counted from 0.
    Occupied(usize),
    /// The turning piece would go through the table.
    ThroughTable,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::NoPiece => write!(f, "there is no such piece; they are 1 to {PIECES}"),
            Refused::OffTable => f.write_str("the piece would leave the table of 10 x 10 x 7 cells"),
            Refused::Occupied(other) => write!(f, "piece {} is in the way", other + 1),
            Refused::ThroughTable => f.write_str("the turning piece would go through the table"),
        }
    }
}

impl std::error::Error for Refused {}

/// Which cells of the table are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Taken([u64; WORDS]);

impl Taken {
    /// The cells of all pieces but one.
    pub(super) fn without(cube: &CsangoCube, piece: usize) -> Taken {
        let mut taken = Taken::default();
        for (index, other) in cube.pieces.iter().enumerate().filter(|&(index, _)| index != piece) {
            other.cells(index).for_each(|cell| taken.take(cell));
        }
        taken
    }

    /// Takes a cell; one off the table is left alone.
    pub(super) fn take(&mut self, cell: [i8; 3]) {
        if let Some(place) = on_table(cell)
            && let Some(word) = self.0.get_mut(place / 64)
        {
            *word |= 1 << (place % 64);
        }
    }

    /// Whether a cell is taken; `None` off the table.
    pub(super) fn holds(&self, cell: [i8; 3]) -> Option<bool> {
        let place = on_table(cell)?;
        Some(self.0.get(place / 64).is_some_and(|word| word >> (place % 64) & 1 == 1))
    }

    /// Whether a piece may do something, so far as these cells go.
    pub(super) fn allows(&self, index: usize, piece: CubePiece, action: Action, rules: Rules) -> bool {
        let after = action.apply(piece);
        after.cells(index).all(|cell| self.holds(cell) == Some(false))
            && (rules == Rules::Book
                || swept(index, piece, action).all(|cell| cell[2] >= 0 && self.holds(cell) != Some(true)))
    }
}

/// Cells that a cell sweeps which is turned by a right angle from x towards y about the centre of another
/// one, for the three distances that there are in a piece; the others follow by turning.
const SWEPT: [([i8; 2], &[[i8; 2]]); 3] = [
    ([0, 0], &[[-1, 0], [0, -1], [0, 0], [0, 1], [1, 0]]),
    ([1, 0], &[[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [2, 0]]),
    ([1, 1], &[[-1, 1], [-1, 2], [0, 1], [0, 2], [1, 1], [1, 2]]),
];

/// Cells that a cell of the plane sweeps in a turn about the origin from the first axis to the second.
fn swept_in_plane(cell: [i8; 2]) -> impl Iterator<Item = [i8; 2]> {
    let rotate = |[p, q]: [i8; 2], quarters: usize| (0..quarters).fold([p, q], |[p, q], _| [-q, p]);
    let found = SWEPT
        .iter()
        .find_map(|&(first, cells)| (0..4).find(|&k| rotate(first, k) == cell).map(|k| (k, cells)));
    let (quarters, cells) = found.unwrap_or((0, &[]));
    cells.iter().map(move |&cell| rotate(cell, quarters))
}

/// Cells that a piece passes through in a turn, its own among them; none for a move.
fn swept(index: usize, piece: CubePiece, action: Action) -> impl Iterator<Item = [i8; 3]> {
    // The axis, and the two others in the order of the turn.
    let axes = match action {
        Action::R => Some([0, 1, 2]),
        Action::E => Some([0, 2, 1]),
        Action::S => Some([1, 2, 0]),
        Action::F => Some([1, 0, 2]),
        Action::T => Some([2, 0, 1]),
        Action::G => Some([2, 1, 0]),
        _ => None,
    };
    let centre = piece.cell;
    axes.into_iter().flat_map(move |[axis, first, second]| {
        piece.cells(index).flat_map(move |cell| {
            let from = move |axis: usize| cell[axis].saturating_sub(centre[axis]);
            swept_in_plane([from(first), from(second)]).map(move |[p, q]| {
                let mut place = [0; 3];
                place[axis] = from(axis);
                place[first] = p;
                place[second] = q;
                add(centre, place)
            })
        })
    })
}

impl CsangoCube {
    /// The piece of a cell, counted from 0.
    #[must_use]
    pub fn piece_at(&self, cell: [i8; 3]) -> Option<usize> {
        self.pieces.iter().enumerate().position(|(index, piece)| piece.cells(index).any(|own| own == cell))
    }

    /// The position after a move.
    ///
    /// # Errors
    /// [`Refused`] if the rules do not allow it.
    pub fn after(&self, step: Move, rules: Rules) -> Result<CsangoCube, Refused> {
        let Move { piece: index, action } = step;
        let Some(&piece) = self.pieces.get(index) else { return Err(Refused::NoPiece) };
        let moved = action.apply(piece);
        let other_at = |cell| self.piece_at(cell).filter(|&other| other != index);
        for cell in moved.cells(index) {
            if on_table(cell).is_none() {
                return Err(Refused::OffTable);
            }
            other_at(cell).map_or(Ok(()), |other| Err(Refused::Occupied(other)))?;
        }
        if rules == Rules::Rigid {
            for cell in swept(index, piece, action) {
                if cell[2] < 0 {
                    return Err(Refused::ThroughTable);
                }
                other_at(cell).map_or(Ok(()), |other| Err(Refused::Occupied(other)))?;
            }
        }
        let mut after = *self;
        if let Some(place) = after.pieces.get_mut(index) {
            *place = moved;
        }
        Ok(after)
    }

    /// The position after a list of moves, each of which the rules allow.
    ///
    /// # Errors
    /// The number of the first move that they do not, from 0, and why.
    pub fn after_all(&self, moves: &[Move], rules: Rules) -> Result<CsangoCube, (usize, Refused)> {
        moves.iter().enumerate().try_fold(*self, |cube, (number, &step)| {
            cube.after(step, rules).map_err(|refused| (number, refused))
        })
    }

    /// The position after so many random tries to move a piece; the same for the same seed.
    #[must_use]
    pub fn scrambled(&self, seed: u64, tries: u32, rules: Rules) -> CsangoCube {
        let mut dice = Dice::new(seed);
        (0..tries).fold(*self, |cube, _| {
            let (piece, action) = (dice.below(PIECES), Action::ALL[dice.below(Action::ALL.len())]);
            cube.after(Move { piece, action }, rules).unwrap_or(cube)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    /// Whether two open unit squares overlap, one of them turned by an angle about the origin.
    fn overlap(turned: [i8; 2], still: [i8; 2], angle: f64) -> bool {
        let (sin, cos) = angle.sin_cos();
        let [p, q] = turned.map(f64::from);
        let [dx, dy] = [f64::from(still[0]) - (p * cos - q * sin), f64::from(still[1]) - (p * sin + q * cos)];
        let reach = 0.5 + (sin + cos) / 2.0 - 1e-9;
        let [u, v] = [dx * cos + dy * sin, dy * cos - dx * sin];
        [dx, dy, u, v].iter().all(|distance| distance.abs() < reach)
    }

    #[test]
    fn swept_cells_are_those_that_turned_squares_meet() {
        for cell in (-1..=1).flat_map(|p| (-1..=1).map(move |q| [p, q])) {
            for still in (-3..=3).flat_map(|p| (-3..=3).map(move |q| [p, q])) {
                let met = (0..=2000).any(|k| overlap(cell, still, FRAC_PI_2 * f64::from(k) / 2000.0));
                assert_eq!(swept_in_plane(cell).any(|it| it == still), met, "{cell:?} {still:?}");
            }
        }
    }

    #[test]
    fn turns_are_the_books() {
        let from = [1, 2, 3];
        let expected = [
            (Action::R, [1, -3, 2]),
            (Action::E, [1, 3, -2]),
            (Action::S, [3, 2, -1]),
            (Action::F, [-3, 2, 1]),
            (Action::T, [-2, 1, 3]),
            (Action::G, [2, -1, 3]),
        ];
        for (action, to) in expected {
            assert_eq!(action.turn(from), to);
        }
    }

    #[test]
    fn refusals_say_why() {
        let start = CsangoCube::start();
        let refused = |piece, action, rules| start.after(Move { piece, action }, rules).unwrap_err();
        assert_eq!(refused(11, Action::U, Rules::Book), Refused::OffTable);
        assert_eq!(refused(0, Action::X, Rules::Book), Refused::Occupied(12));
        assert_eq!(refused(14, Action::X, Rules::Book), Refused::NoPiece);
        assert!(start.after(Move { piece: 0, action: Action::R }, Rules::Book).is_ok());
        assert_eq!(refused(0, Action::R, Rules::Rigid), Refused::ThroughTable);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn play_keeps_positions_possible_and_every_move_can_be_taken_back(
            moves in prop::collection::vec((0usize..15, 0usize..12), 0..300),
            rigid in any::<bool>(),
        ) {
            let rules = if rigid { Rules::Rigid } else { Rules::Book };
            let mut cube = CsangoCube::start();
            for (piece, action) in moves {
                let step = Move { piece, action: Action::ALL[action] };
                let allowed = cube.pieces.get(piece).is_some_and(|&it| {
                    Taken::without(&cube, piece).allows(piece, it, step.action, rules)
                });
                match cube.after(step, rules) {
                    Ok(after) => {
                        prop_assert!(allowed);
                        prop_assert_eq!(after.fault(), None);
                        prop_assert_eq!(after.after(step.reverse(), rules), Ok(cube));
                        cube = after;
                    }
                    Err(_) => prop_assert!(!allowed),
                }
            }
        }

        #[test]
        fn scrambles_are_legal_and_repeatable(seed in any::<u64>()) {
            let scrambled = || CsangoCube::start().scrambled(seed, 300, Rules::Book);
            prop_assert_eq!(scrambled().fault(), None);
            prop_assert_eq!(scrambled(), scrambled());
        }
    }
}
