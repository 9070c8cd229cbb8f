//! A beam search: of all positions that are so many moves away from the start, only the most promising ones
//! are followed up, by the scores of [`Patterns`]. It ends with the first position from which a table knows the
//! rest. It finds good ways from any position, and proves nothing.
//!
//! A layer is gone through twice. First the scores of all positions after it are counted, which takes no more
//! than some sums; that gives the limit up to which they are made at all.

use super::Wheel;
use super::ball::Ball;
use super::moves::Move;
use super::patterns::{BLOCKED, Patterns, Scores};
use std::ops::Range;

/// No way longer than this is followed.
const LONGEST: usize = 60;
/// Positions that are taken, or left out, in the time that one is looked at.
const AT_ONCE: usize = 16;
/// So many times the positions that there is room for are made, because many are reached in several ways.
const SURPLUS: usize = 2;

/// A last step: the number of the position before in its layer, and the move in the lowest four bits.
#[derive(Clone, Copy, Debug)]
struct Step(u32);

impl Step {
    fn new(from: usize, number: usize) -> Step {
        // A layer has far fewer than 2^28 positions.
        Step((from as u32) << 4 | number as u32)
    }

    fn from(self) -> usize {
        (self.0 >> 4) as usize
    }

    fn a_move(self) -> Option<Move> {
        Move::ALL.get(self.0 as usize & 15).copied()
    }
}

/// A position that was reached.
#[derive(Clone, Copy, Debug)]
struct Reached {
    wheel: Wheel,
    score: u16,
    step: Step,
}

/// What is done with a layer.
#[derive(Clone, Copy, Debug)]
enum Phase {
    /// The positions from this one on are still to be looked at.
    Look(usize),
    /// Their moves are still to be made, those whose score is at most the limit.
    Make { next: usize, limit: u16 },
    /// Of what was reached, this one and those after it are still to be taken, or left out beyond the limit.
    Take { next: usize, limit: u16 },
}

/// A beam that can be interrupted.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    width: usize,
    /// The outermost layer.
    layer: Vec<Wheel>,
    /// Scores of the positions after its moves.
    scores: Vec<Scores>,
    /// How many of them have a score.
    counts: Vec<u32>,
    /// Steps of all layers but the start's.
    steps: Vec<Vec<Step>>,
    phase: Phase,
    /// What was reached from the layer.
    reached: Vec<Reached>,
    /// What has been taken of it: the next layer, and the steps to it.
    taken: (Vec<Wheel>, Vec<Step>),
    seen: Seen,
}

/// Positions that have been in the beam: a detour back to one would only take the room of others. Some are
/// forgotten, for every position has but one place here.
#[derive(Clone, Debug)]
struct Seen(Vec<u32>);

impl Seen {
    fn new(size: usize) -> Seen {
        Seen(vec![0; size.next_power_of_two()])
    }

    /// The place and the mark of a position.
    fn place(&self, wheel: &Wheel) -> (usize, u32) {
        let [a, b, c] = wheel.planes.map(u64::from);
        let mixed = (a ^ b << 31).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ c.wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 29).wrapping_mul(0x94D0_49BB_1331_11EB);
        (mixed as usize & (self.0.len() - 1), (mixed >> 32) as u32 | 1)
    }

    /// Remembers a position; whether it is new. Of a thousand million others one is taken for it.
    fn insert(&mut self, wheel: &Wheel) -> bool {
        let (place, mark) = self.place(wheel);
        std::mem::replace(&mut self.0[place], mark) != mark
    }

    fn forget(&mut self, wheel: &Wheel) {
        let (place, mark) = self.place(wheel);
        if self.0[place] == mark {
            self.0[place] = 0;
        }
    }
}

/// The limit that at least `room` of the counted scores keep, or all of them.
fn limit(counts: &[u32], room: usize) -> u16 {
    let mut total = 0;
    let full = counts.iter().position(|&count| {
        total += count as usize;
        total >= room
    });
    full.and_then(|score| u16::try_from(score).ok()).unwrap_or(BLOCKED).min(BLOCKED - 1)
}

impl Beam {
    /// A beam from a position that follows at most `width` positions at a time.
    pub(super) fn new(start: Wheel, width: usize) -> Beam {
        Beam {
            width,
            layer: vec![start],
            scores: Vec::new(),
            counts: vec![0; usize::from(BLOCKED) + 1],
            steps: Vec::new(),
            phase: Phase::Look(0),
            reached: Vec::new(),
            taken: (Vec::new(), Vec::new()),
            seen: Seen::new(8 * width),
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
        // Every way enters the ball at its surface, so it is shorter only if it has entered it early enough,
        // and none that enters it later is shorter than the first one.
        let longest = best.as_ref().map_or(LONGEST, Vec::len);
        while !self.layer.is_empty() && self.steps.len() + usize::from(ball.radius()) < longest {
            match self.phase {
                Phase::Look(number) => {
                    let Some(&wheel) = self.layer.get(number) else {
                        let limit = limit(&self.counts, SURPLUS * self.width);
                        self.counts.fill(0);
                        self.phase = Phase::Make { next: 0, limit };
                        continue;
                    };
                    if *budget == 0 {
                        return false;
                    }
                    let scores = self.look(number, &wheel, best, patterns, ball);
                    if best.as_ref().is_some_and(|best| best.len() < longest) {
                        return true;
                    }
                    self.scores.push(scores);
                    self.phase = Phase::Look(number + 1);
                    *budget -= 1;
                }
                Phase::Make { next, limit: most } => {
                    if next >= self.layer.len() {
                        let limit = limit(&self.counts, self.width);
                        self.phase = Phase::Take { next: 0, limit };
                        continue;
                    }
                    if *budget == 0 {
                        return false;
                    }
                    self.make(next, most);
                    self.phase = Phase::Make { next: next + 1, limit: most };
                    *budget -= 1;
                }
                Phase::Take { next, limit } => {
                    if next >= self.reached.len() {
                        self.go_on();
                        continue;
                    }
                    if *budget == 0 {
                        return false;
                    }
                    let end = next + AT_ONCE;
                    self.take(next..end, limit);
                    self.phase = Phase::Take { next: end, limit };
                    *budget -= 1;
                }
            }
        }
        true
    }

    /// The scores after the moves of a position of the layer, if any way over it can be better than the best.
    fn look(
        &mut self,
        number: usize,
        wheel: &Wheel,
        best: &mut Option<Vec<Move>>,
        patterns: &Patterns,
        ball: &Ball,
    ) -> Scores {
        let nothing = [BLOCKED; Move::ALL.len()];
        let (bound, mut scores) = patterns.look(wheel);
        let made = self.steps.len();
        let better = |rest: u8| best.as_ref().is_none_or(|best| made + usize::from(rest) < best.len());
        if !better(bound) {
            return nothing;
        }
        if bound <= ball.radius()
            && let Some(distance) = ball.distance(wheel)
        {
            if better(distance)
                && let Some(rest) = ball.way(wheel)
            {
                *best = Some([self.way(number), rest].concat());
            }
            // Nothing beyond can be better than the shortest rest.
            return nothing;
        }
        let last = self.steps.last().and_then(|steps| steps.get(number)?.a_move());
        if let Some(back) = last.and_then(|last| scores.get_mut(last.inverse() as usize)) {
            *back = BLOCKED;
        }
        for &score in scores.iter().filter(|&&score| score < BLOCKED) {
            self.counts[usize::from(score)] += 1;
        }
        scores
    }

    /// Makes the moves of a position of the layer that lead to scores within the limit.
    fn make(&mut self, from: usize, limit: u16) {
        let (Some(wheel), Some(scores)) = (self.layer.get(from), self.scores.get(from)) else { return };
        for (number, &score) in scores.iter().enumerate().filter(|&(_, &score)| score <= limit) {
            let after = Move::ALL.get(number).and_then(|&a_move| wheel.after(a_move));
            if let Some(wheel) = after.filter(|wheel| self.seen.insert(wheel)) {
                self.counts[usize::from(score)] += 1;
                self.reached.push(Reached { wheel, score, step: Step::new(from, number) });
            }
        }
    }

    /// The moves up to a position of the outermost layer.
    fn way(&self, number: usize) -> Vec<Move> {
        let mut way = Vec::new();
        let mut from = number;
        for steps in self.steps.iter().rev() {
            let Some(step) = steps.get(from) else { break };
            way.extend(step.a_move());
            from = step.from();
        }
        way.reverse();
        way
    }

    /// Takes the best of some positions that were reached.
    fn take(&mut self, some: Range<usize>, limit: u16) {
        let (layer, steps) = &mut self.taken;
        for it in self.reached.iter().take(some.end).skip(some.start) {
            if it.score <= limit && layer.len() < self.width {
                layer.push(it.wheel);
                steps.push(it.step);
            } else {
                self.seen.forget(&it.wheel);
            }
        }
    }

    /// Goes on with what was taken.
    fn go_on(&mut self) {
        self.counts.fill(0);
        self.scores.clear();
        self.reached.clear();
        let (layer, steps) = &mut self.taken;
        std::mem::swap(&mut self.layer, layer);
        layer.clear();
        self.steps.push(std::mem::take(steps));
        self.phase = Phase::Look(0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::patterns::whole;
    use super::super::{Difficulty, Scramble};
    use super::*;

    #[test]
    fn ways_are_ways_and_end_when_none_is_better() {
        let (patterns, mut ball) = (whole(), Ball::default());
        assert!(ball.advance(4, &mut u64::MAX.clone()));
        let start = Scramble::new(Difficulty::Eight, 1).wheel;
        let mut best = None;
        assert!(Beam::new(start, 500).advance(&mut best, &patterns, &ball, &mut u64::MAX.clone()));
        let way = best.clone().expect("a beam of 500 does not miss eight moves");
        assert!(start.replay(&way).unwrap().is_solved());
        // Nothing shorter exists, and the beam stops before it has looked at much.
        let (mut again, mut budget) = (Some(way.clone()), 1_000_000);
        assert!(Beam::new(start, 500).advance(&mut again, &patterns, &ball, &mut budget));
        assert_eq!((again, way.len()), (best, 8));
        assert!(budget > 990_000, "{budget}");
    }

    #[test]
    fn a_limit_keeps_enough() {
        let counts = [0, 3, 0, 5, 1];
        assert_eq!([1, 3, 4, 8, 9].map(|room| limit(&counts, room)), [1, 1, 3, 3, 4]);
        assert_eq!(limit(&counts, 10), BLOCKED - 1);
    }
}
