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
