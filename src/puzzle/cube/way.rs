//! The moves from any position to the finished cube. The cube is taken apart in thought, single pieces going
//! straight out, which gives an order to build it in; then every piece goes its shortest way from where it
//! lies. What lies where the cube will stand goes out of the way first.

use super::moves::{Move, Refused, Rules, Taken};
use super::place::{Filling, Placed, kind_of, mask_of};
use super::position::{CsangoCube, CubePiece};
use super::reach::shortest;
use super::shape::PIECES;
use std::fmt;

/// The lowest corner of the finished cube on the table: x 3 to 6, y 2 to 5, height 0 to 3.
pub const CORNER: [i8; 3] = [3, 2, 0];

/// Directions in which pieces leave the cube: all but down into the table.
const OUT: [[i8; 3]; 5] = [[0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]];

/// Why there is no way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WayError {
    /// The filling does not have the fourteen pieces.
    NoFilling,
    /// No piece can get out of the way or to its place.
    Stuck,
    /// A move of the list is not allowed, from 0: the list would have been wrong.
    Wrong(usize, Refused),
}

impl fmt::Display for WayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WayError::NoFilling => f.write_str("these are not the fourteen pieces of the cube"),
            WayError::Stuck => f.write_str("no piece finds a way to its place"),
            WayError::Wrong(number, refused) => write!(f, "move {}: {refused}", number + 1),
        }
    }
}

impl std::error::Error for WayError {}

/// The pieces of a position that lie wholly where the cube will stand.
pub(super) fn inside(cube: &CsangoCube) -> Vec<(usize, Placed)> {
    let pieces = cube.pieces.iter().enumerate();
    pieces
        .filter_map(|(index, piece)| {
            let mask = mask_of(piece.cells(index), CORNER)?;
            Some((index, Placed { kind: kind_of(index)?, mask }))
        })
        .collect()
}

impl CsangoCube {
    /// The pieces that lie wholly where the cube is built, at [`CORNER`].
    #[must_use]
    pub fn placed(&self) -> Vec<Placed> {
        inside(self).into_iter().map(|(_, placed)| placed).collect()
    }

    /// The pieces, counted from 0, that lie partly where the cube is built and partly outside.
    #[must_use]
    pub fn sticking_out(&self) -> Vec<usize> {
        let whole = |index: usize, piece: CubePiece| mask_of(piece.cells(index), CORNER).is_some();
        let pieces = self.pieces.iter().enumerate();
        pieces
            .filter(|&(index, &piece)| touches(index, piece) && !whole(index, piece))
            .map(|(index, _)| index)
            .collect()
    }
}

impl CsangoCube {
    /// The filling of a finished cube, wherever it stands.
    #[must_use]
    pub fn filling(&self) -> Option<Filling> {
        let cells = || self.pieces.iter().enumerate().flat_map(|(index, piece)| piece.cells(index));
        let corner = cells().reduce(|[x, y, z], [u, v, w]| [x.min(u), y.min(v), z.min(w)])?;
        let place = |(index, piece): (usize, &CubePiece)| {
            Some(Placed { kind: kind_of(index)?, mask: mask_of(piece.cells(index), corner)? })
        };
        let placed = self.pieces.iter().enumerate().map(place).collect::<Option<Vec<_>>>()?;
        self.is_finished().then_some(Filling { placed })
    }
}

impl Filling {
    /// The order in which the pieces go in, each straight along an axis, with the direction in which each
    /// comes out again; `None` if some cannot. The first ones may be given: they stay inside.
    #[must_use]
    pub fn order(&self, first: &[Placed]) -> Option<Vec<(Placed, [i8; 3])>> {
        let mut inside = self.placed.clone();
        let mut order = Vec::new();
        while inside.len() > first.len() {
            let filled = inside.iter().fold(0, |all, placed| all | placed.mask);
            let free = inside.iter().enumerate().filter(|(_, placed)| !first.contains(placed)).find_map(
                |(index, placed)| {
                    let way_out =
                        OUT.into_iter().find(|&way| leaves(placed.mask, filled & !placed.mask, way));
                    Some((index, way_out?))
                },
            );
            let (index, way_out) = free?;
            order.push((inside.remove(index), way_out));
        }
        order.reverse();
        Some(order)
    }

    /// The filling in another of the 24 attitudes of the cube.
    fn turned(&self, rotation: &[[i8; 3]; 3]) -> Filling {
        let turn = |mask: u64| {
            let cells = (0..64_i8).filter(|bit| mask >> bit & 1 == 1).map(|bit| {
                let from = [bit % 4, bit / 4 % 4, bit / 16].map(|v| 2 * v - 3);
                super::turned(rotation, from).map(|v| (v + 3) / 2)
            });
            mask_of(cells, [0; 3]).unwrap_or(0) // a rotation keeps the cube
        };
        let placed = self.placed.iter().map(|&Placed { kind, mask }| Placed { kind, mask: turn(mask) });
        Filling { placed: placed.collect() }
    }
}

/// Whether a piece gets out of the cube in a direction between the others.
fn leaves(mask: u64, others: u64, way: [i8; 3]) -> bool {
    let mut cells: Vec<[i8; 3]> =
        (0..64).filter(|bit| mask >> bit & 1 == 1).map(|bit| [bit % 4, bit / 4 % 4, bit / 16]).collect();
    for _ in 0..4 {
        cells = cells.iter().map(|&cell| super::add(cell, way)).collect();
        cells.retain(|cell| cell.iter().all(|v| (0..4).contains(v)));
        let meets = mask_of(cells.iter().copied(), [0; 3]).is_some_and(|moved| moved & others != 0);
        if meets {
            return false;
        }
    }
    true
}

/// The search for the moves that build a filling; it advances piece by piece.
#[derive(Clone, Debug)]
pub struct Way {
    start: CsangoCube,
    rules: Rules,
    now: CsangoCube,
    moves: Vec<Move>,
    /// Places still to be filled, the next one first; the pieces in the others stay.
    order: Vec<Placed>,
    /// Pieces that lie where they belong.
    done: Vec<usize>,
    /// Moves of single pieces that are left before the search gives up.
    patience: u32,
}

impl Way {
    /// A search from a position to a filling at [`CORNER`]. Pieces that lie there already stay if the
    /// others can be put to them. Of the 24 attitudes of a filling that has none of them inside, any may
    /// be built: the one that can be taken apart.
    ///
    /// # Errors
    /// [`WayError::NoFilling`] if these are not the fourteen pieces; [`WayError::Stuck`] if the filling
    /// cannot be taken apart on the table.
    pub fn new(start: &CsangoCube, filling: &Filling, rules: Rules) -> Result<Way, WayError> {
        if filling.position(CORNER).is_none_or(|cube| cube.fault().is_some()) {
            return Err(WayError::NoFilling);
        }
        let kept: Vec<(usize, Placed)> =
            inside(start).into_iter().filter(|(_, placed)| filling.placed.contains(placed)).collect();
        let first: Vec<Placed> = kept.iter().map(|&(_, placed)| placed).collect();
        let with_kept = filling.order(&first).map(|order| (order, kept));
        let turned =
            || super::ROTATIONS.iter().find_map(|it| Some((filling.turned(it).order(&[])?, Vec::new())));
        let (order, kept) = with_kept.or_else(turned).ok_or(WayError::Stuck)?;
        Ok(Way {
            start: *start,
            rules,
            now: *start,
            moves: Vec::new(),
            order: order.into_iter().map(|(placed, _)| placed).collect(),
            done: kept.into_iter().map(|(index, _)| index).collect(),
            patience: 10 * PIECES as u32,
        })
    }

    /// Pieces that lie in their places so far, of fourteen.
    #[must_use]
    pub fn done(&self) -> usize {
        self.done.len()
    }

    /// Finds the way of one more piece. When all lie in their places, the moves, every one of which has
    /// been made again from the beginning and was allowed.
    ///
    /// # Errors
    /// [`WayError::Stuck`] if no piece can get on.
    pub fn advance(&mut self) -> Result<Option<Vec<Move>>, WayError> {
        let Some(&next) = self.order.first() else { return self.checked().map(Some) };
        self.patience = self.patience.checked_sub(1).ok_or(WayError::Stuck)?;
        if let Some((index, actions)) = self.nearest(next) {
            self.go(index, &actions);
            self.done.push(index);
            self.order.remove(0);
            return Ok(None);
        }
        // Something is in the way: first what lies in the cube's place, then what has the shortest way home.
        let blocking = (0..PIECES).filter(|index| !self.done.contains(index));
        let (in_the_way, beside): (Vec<usize>, Vec<usize>) = blocking
            .partition(|&index| self.now.pieces.get(index).is_some_and(|&piece| touches(index, piece)));
        let cleared = in_the_way.iter().chain(&beside).any(|&index| self.clear(index));
        if cleared { Ok(None) } else { Err(WayError::Stuck) }
    }

    /// The way of the piece that comes to a place in the fewest moves.
    fn nearest(&self, place: Placed) -> Option<(usize, Vec<super::Action>)> {
        let fitting =
            (0..PIECES).filter(|index| !self.done.contains(index) && kind_of(*index) == Some(place.kind));
        let ways = fitting.filter_map(|index| {
            let &from = self.now.pieces.get(index)?;
            let others = Taken::without(&self.now, index);
            let right = |piece: CubePiece| mask_of(piece.cells(index), CORNER) == Some(place.mask);
            Some((index, shortest(index, from, &others, self.rules, right)?))
        });
        ways.min_by_key(|(_, actions)| actions.len())
    }

    /// Moves a piece out of the way: out of the cube's place, or home; whether it moved.
    fn clear(&mut self, index: usize) -> bool {
        let (Some(&from), Some(&home)) = (self.now.pieces.get(index), CsangoCube::start().pieces.get(index))
        else {
            return false;
        };
        let others = Taken::without(&self.now, index);
        let right = |piece: CubePiece| if touches(index, from) { !near(index, piece) } else { piece == home };
        match shortest(index, from, &others, self.rules, right) {
            Some(actions) if !actions.is_empty() => {
                self.go(index, &actions);
                true
            }
            _ => false,
        }
    }

    fn go(&mut self, piece: usize, actions: &[super::Action]) {
        for &action in actions {
            self.moves.push(Move { piece, action });
            if let Some(place) = self.now.pieces.get_mut(piece) {
                *place = action.apply(*place);
            }
        }
    }

    /// The moves, made again one by one.
    fn checked(&self) -> Result<Vec<Move>, WayError> {
        let end = self.start.after_all(&self.moves, self.rules);
        let end = end.map_err(|(number, refused)| WayError::Wrong(number, refused))?;
        if end.is_finished() && end.fault().is_none() { Ok(self.moves.clone()) } else { Err(WayError::Stuck) }
    }

    /// All moves at once.
    ///
    /// # Errors
    /// As [`Way::advance`].
    pub fn finish(mut self) -> Result<Vec<Move>, WayError> {
        loop {
            if let Some(moves) = self.advance()? {
                return Ok(moves);
            }
        }
    }
}

/// Whether a piece has a cell where the cube will stand.
fn touches(index: usize, piece: CubePiece) -> bool {
    within(index, piece, 0)
}

/// Whether a piece has a cell there or right beside it.
fn near(index: usize, piece: CubePiece) -> bool {
    within(index, piece, 1)
}

fn within(index: usize, piece: CubePiece, margin: i8) -> bool {
    piece.cells(index).any(|cell| {
        cell.iter().zip(CORNER).all(|(v, corner)| (corner - margin..corner + 4 + margin).contains(v))
    })
}

#[cfg(test)]
mod tests {
    use super::super::{Progress, Search};
    use super::*;
    use proptest::prelude::*;

    fn filling(fixed: &[Placed], seed: u64) -> Filling {
        match Search::new(fixed, seed).advance(1_000_000) {
            Progress::Found(filling) => filling,
            other => panic!("{other:?}"),
        }
    }

    fn way(from: &CsangoCube, seed: u64, rules: Rules) -> Vec<Move> {
        let moves = Way::new(from, &filling(&[], seed), rules).and_then(Way::finish).expect("there is a way");
        assert!(from.after_all(&moves, rules).expect("allowed").is_finished());
        moves
    }

    #[test]
    fn from_the_start_in_about_a_hundred_moves_and_back() {
        let start = CsangoCube::start();
        for (seed, rules) in [(0, Rules::Book), (1, Rules::Book), (2, Rules::Rigid)] {
            let moves = way(&start, seed, rules);
            println!("{rules:?} {seed}: {} moves", moves.len());
            assert!(moves.len() < 200);
            let there = start.after_all(&moves, rules).expect("allowed");
            let back: Vec<Move> = moves.iter().rev().map(|it| it.reverse()).collect();
            assert_eq!(there.after_all(&back, rules), Ok(start));
        }
    }

    #[test]
    fn a_wrong_list_of_moves_is_found_out() {
        let start = CsangoCube::start();
        let mut moves = way(&start, 0, Rules::Book);
        let last = moves.len() - 1;
        moves[last].action = moves[last].action.reverse();
        assert!(
            start.after_all(&moves, Rules::Book).is_ok_and(|cube| !cube.is_finished())
                || start.after_all(&moves, Rules::Book).is_err()
        );
        let broken =
            Way { moves, ..Way::new(&start, &filling(&[], 0), Rules::Book).expect("it comes apart") };
        assert!(broken.checked().is_err());
    }

    #[test]
    fn what_lies_in_the_cube_stays() {
        let start = CsangoCube::start();
        let moves = way(&start, 0, Rules::Book);
        let half = start.after_all(&moves[..moves.len() / 2], Rules::Book).expect("allowed");
        let kept = half.placed();
        assert!(!kept.is_empty());
        let on =
            Way::new(&half, &filling(&kept, 0), Rules::Book).and_then(Way::finish).expect("there is a way");
        let moved = |piece: usize| on.iter().any(|it| it.piece == piece);
        assert!(inside(&half).iter().all(|&(index, _)| !moved(index)));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(6))]
        #[test]
        fn from_scattered_positions(seed in 1u64..1000) {
            let from = CsangoCube::start().scrambled(seed, 2000, Rules::Book);
            way(&from, seed, Rules::Book);
        }
    }
}
