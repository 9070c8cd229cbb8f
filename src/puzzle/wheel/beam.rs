//! A beam search: of all positions that are so many moves away from the start, only the most promising ones
//! are followed up, those whose colours are nearest to home by the sum of their squared distances. It finds
//! good ways between any two positions, and proves nothing.

use super::Wheel;
use super::ball::Ball;
use super::moves::Move;
use super::patterns::Patterns;
use std::collections::HashSet;

/// No way longer than this is followed.
const LONGEST: usize = 60;

/// A position that was reached, and from where.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Reached {
    score: u16,
    /// Positions of the same score are taken as if by lot: any other order would prefer one kind of them.
    lot: u32,
    wheel: Wheel,
    step: Step,
}

/// The last step to a position: the number of the position before in its layer, and the move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Step {
    from: u32,
    a_move: Move,
}

/// A number that depends on the whole position.
fn lot(wheel: &Wheel) -> u32 {
    let [a, b, c] = wheel.planes.map(u64::from);
    let mixed = (a ^ b << 31).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ c.wrapping_mul(0xBF58_476D_1CE4_E5B9);
    ((mixed ^ mixed >> 29).wrapping_mul(0x94D0_49BB_1331_11EB) >> 32) as u32
}

/// A beam that can be interrupted.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    width: usize,
    /// The outermost layer.
    layer: Vec<Reached>,
    /// Steps of all layers but the start's.
    steps: Vec<Vec<Step>>,
    /// The next position of the layer to be followed up.
    next: usize,
    /// What was reached from those before.
    reached: Vec<Reached>,
    /// Every position that has been in the beam: a detour back to one would only take the room of others.
    seen: HashSet<Wheel>,
}

impl Beam {
    /// A beam from a position that follows at most `width` positions at a time.
    pub(super) fn new(start: Wheel, width: usize) -> Beam {
        let step = Step { from: 0, a_move: Move::A };
        let start = Reached { score: 0, lot: 0, wheel: start, step };
        Beam {
            width,
            layer: vec![start],
            steps: Vec::new(),
            next: 0,
            reached: Vec::new(),
            seen: HashSet::new(),
        }
    }

    /// Works until the budget is used up or nothing better can come; whether it has ended. Ways shorter than
    /// `best` are put there.
    pub(super) fn advance(
        &mut self,
        best: &mut Option<Vec<Move>>,
        patterns: &Patterns,
        ball: &Ball,
        budget: &mut u64,
    ) -> bool {
        while !self.layer.is_empty() && self.steps.len() < LONGEST {
            while let Some(&parent) = self.layer.get(self.next) {
                if *budget == 0 {
                    return false;
                }
                for a_move in Move::ALL {
                    self.follow(&parent, a_move, best, patterns, ball, budget);
                }
                self.next += 1;
            }
            self.take_best();
        }
        true
    }

    fn follow(
        &mut self,
        parent: &Reached,
        a_move: Move,
        best: &mut Option<Vec<Move>>,
        patterns: &Patterns,
        ball: &Ball,
        budget: &mut u64,
    ) {
        // Turns of different rings are tried in every order: only one of them may have been taken into the beam.
        let back = !self.steps.is_empty() && a_move == parent.step.a_move.inverse();
        let Some(wheel) = parent.wheel.after(a_move).filter(|_| !back) else { return };
        *budget = budget.saturating_sub(1);
        let made = self.steps.len() + 1;
        let distances = patterns.distances(&wheel);
        let bound = distances.into_iter().max().unwrap_or(0);
        if best.as_ref().is_some_and(|best| made + usize::from(bound) >= best.len()) {
            return;
        }
        // A layer has no more than some hundred thousand positions.
        let step = Step { from: self.next as u32, a_move };
        if bound <= ball.radius()
            && let Some(distance) = ball.distance(&wheel)
        {
            let length = made + usize::from(distance);
            if best.as_ref().is_none_or(|best| length < best.len())
                && let Some(rest) = ball.way(&wheel)
            {
                *best = Some([self.way(step), rest].concat());
            }
            // Nothing beyond can be better than the shortest rest.
            return;
        }
        let score = distances.into_iter().map(|distance| u16::from(distance).pow(2)).sum();
        self.reached.push(Reached { score, lot: lot(&wheel), wheel, step });
    }

    /// The moves up to a step out of the outermost layer.
    fn way(&self, last: Step) -> Vec<Move> {
        let mut way = vec![last.a_move];
        let mut from = last.from;
        for layer in self.steps.iter().rev() {
            let Some(step) = layer.get(from as usize) else { break };
            way.push(step.a_move);
            from = step.from;
        }
        way.reverse();
        way
    }

    /// Makes the best positions that were reached the next layer, each only once.
    fn take_best(&mut self) {
        let mut reached = std::mem::take(&mut self.reached);
        // Many positions are reached in several ways, or have been in the beam already, so more than the width
        // are looked at.
        let most = 4 * self.width;
        if reached.len() > most {
            reached.select_nth_unstable(most);
            reached.truncate(most);
        }
        reached.sort_unstable();
        let mut room = self.width;
        reached.retain(|it| {
            let taken = room > 0 && self.seen.insert(it.wheel);
            room -= usize::from(taken);
            taken
        });
        self.steps.push(reached.iter().map(|it| it.step).collect());
        (self.layer, self.next) = (reached, 0);
    }
}
