//! A piece held by the mouse, which follows it cell by cell as far as its way is free.

use super::eye::{EDGE, Eye, centre};
use crate::puzzle::cube::{Action, CsangoCube, Move, Rules};

/// Most cells that a piece is moved at one event: more than the table is wide.
const FARTHEST: f64 = 20.0;

/// A held piece.
pub(crate) struct Hand {
    piece: usize,
    /// Where the button went down.
    pressed: (i32, i32),
    /// Cell 1 then, with what the wheel has lifted since.
    from: [i8; 3],
    /// The position with the piece where it is now.
    pub(crate) cube: CsangoCube,
    /// The position before.
    before: CsangoCube,
}

impl Hand {
    pub(crate) fn new(piece: usize, pressed: (i32, i32), cube: CsangoCube) -> Option<Hand> {
        let from = cube.pieces.get(piece)?.cell;
        Some(Hand { piece, pressed, from, cube, before: cube })
    }

    /// Moves the piece towards the mouse, in the plane of two axes that faces the viewer.
    pub(crate) fn follow(&mut self, (x, y): (i32, i32), eye: Eye) {
        let axes = eye.facing_plane();
        let origin = eye.pixel(centre(self.from));
        let [first, second] = axes.map(|axis| {
            let mut next = centre(self.from);
            next[axis] += EDGE;
            let [px, py] = eye.pixel(next);
            [px - origin[0], py - origin[1]]
        });
        let by = [f64::from(x - self.pressed.0), f64::from(y - self.pressed.1)];
        let area = first[0] * second[1] - first[1] * second[0];
        if area.abs() < 1e-6 {
            return; // a plane that faces the viewer is seen as one
        }
        let steps =
            [(by[0] * second[1] - by[1] * second[0]) / area, (first[0] * by[1] - first[1] * by[0]) / area];
        let mut goal = self.from;
        for (axis, step) in axes.into_iter().zip(steps) {
            goal[axis] = goal[axis].saturating_add(step.round().clamp(-FARTHEST, FARTHEST) as i8);
        }
        while axes.into_iter().any(|axis| self.towards(axis, goal)) {}
    }

    /// Moves one cell towards a goal along an axis; returns whether it moved.
    fn towards(&mut self, axis: usize, goal: [i8; 3]) -> bool {
        let Some(piece) = self.cube.pieces.get(self.piece) else { return false };
        let ways = [[Action::X, Action::U], [Action::Y, Action::V], [Action::Z, Action::W]];
        match goal[axis].cmp(&piece.cell[axis]) {
            std::cmp::Ordering::Greater => self.go(ways[axis][0]),
            std::cmp::Ordering::Less => self.go(ways[axis][1]),
            std::cmp::Ordering::Equal => false,
        }
    }

    fn go(&mut self, action: Action) -> bool {
        // Moves by one cell are the same under all rules.
        let after = self.cube.after(Move { piece: self.piece, action }, Rules::Book);
        after.map(|after| self.cube = after).is_ok()
    }

    /// Lifts the piece by a number of cells, as far as there is room.
    pub(crate) fn lift(&mut self, steps: i32) {
        let (action, by) = if steps > 0 { (Action::Z, 1) } else { (Action::W, -1) };
        for _ in 0..steps.unsigned_abs().min(10) {
            if self.go(action) {
                self.from[2] = self.from[2].saturating_add(by);
            }
        }
    }

    /// Moves by single cells that the piece has made, at least.
    pub(crate) fn moves(&self) -> u32 {
        let cell = |cube: &CsangoCube| cube.pieces.get(self.piece).map_or([0; 3], |piece| piece.cell);
        cell(&self.cube).iter().zip(cell(&self.before)).map(|(a, b)| u32::from(a.abs_diff(b))).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever the projection, a piece that is free to move stays under the pointer, within half a cell.
    #[test]
    fn a_dragged_piece_stays_under_the_pointer() {
        let mut followed = 0;
        for sights in 0..3 {
            for turns in 0..12 {
                let eye = (0..sights).fold(Eye::HOME.turned(turns), |eye, _| eye.next_sight());
                for eye in [eye, eye.higher(), eye.higher().higher()] {
                    for piece in 0..3 {
                        let mut cube = CsangoCube::start();
                        // Lifted above the others, so that nothing is in the way.
                        for _ in 0..3 {
                            cube = cube.after(Move { piece, action: Action::Z }, Rules::Book).unwrap_or(cube);
                        }
                        let from = cube.pieces[piece].cell;
                        for (axis, by) in
                            eye.facing_plane().into_iter().flat_map(|axis| [(axis, 1), (axis, -1)])
                        {
                            let mut goal = from;
                            goal[axis] += by;
                            let pixel = |cell: [i8; 3]| eye.pixel(centre(cell)).map(|x| x.round() as i32);
                            let ([x1, y1], [x2, y2]) = (pixel(from), pixel(goal));
                            let mut hand = Hand::new(piece, (x1, y1), cube).unwrap();
                            hand.follow((x2, y2), eye);
                            let now = hand.cube.pieces[piece].cell;
                            if now != from {
                                assert_eq!(now, goal, "{eye:?} {piece} {axis} {by}");
                                followed += 1;
                            }
                        }
                    }
                }
            }
        }
        assert!(followed > 300, "{followed}");
    }
}
