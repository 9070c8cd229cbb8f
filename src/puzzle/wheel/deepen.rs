//! Iterative deepening: all ways of 0, 1, 2, ... moves, until one ends within the ball at the distance that is
//! left. The first one found is a shortest one.

use super::Wheel;
use super::ball::Ball;
use super::moves::{Move, Tail};
use super::patterns::Patterns;

/// A search for the shortest way that can be interrupted.
#[derive(Clone, Debug)]
pub(super) struct Deepen {
    start: Wheel,
    /// The length of the ways that are looked at; no shorter one exists.
    length: u8,
    /// The way to the position that is looked at.
    path: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    wheel: Wheel,
    tail: Tail,
    /// The next move to be tried: its number.
    next: usize,
}

/// How a piece of the search has ended.
pub(super) enum Deepened {
    /// The budget is used up.
    Interrupted,
    /// All shorter ways were looked at in vain.
    NotWithin,
    /// A shortest way.
    Found(Vec<Move>),
}

impl Deepen {
    /// A search that has looked at nothing yet.
    pub(super) fn new(start: Wheel) -> Deepen {
        Deepen { start, length: 0, path: Vec::new() }
    }

    /// There is no way shorter than this.
    pub(super) fn at_least(&self) -> u8 {
        self.length
    }

    /// Looks at all ways shorter than `end`. The ball may have grown since the last time.
    pub(super) fn advance(
        &mut self,
        end: u8,
        patterns: &Patterns,
        ball: &Ball,
        budget: &mut u64,
    ) -> Deepened {
        while self.length < end {
            if self.path.is_empty() {
                self.length = self.length.max(patterns.bound(&self.start));
                if self.length >= end {
                    break;
                }
                if self.length <= ball.radius()
                    && let Some(way) = self.finish(&self.start, ball)
                {
                    return Deepened::Found(way);
                }
                if self.length <= ball.radius() {
                    self.length += 1;
                    continue;
                }
                self.path.push(Node { wheel: self.start, tail: Tail::default(), next: 0 });
            }
            while let Some(node) = self.path.last_mut() {
                if *budget == 0 {
                    return Deepened::Interrupted;
                }
                let Some(&a_move) = Move::ALL.get(node.next) else {
                    self.path.pop();
                    continue;
                };
                node.next += 1;
                let (Some(tail), Some(wheel)) = (node.tail.then(a_move), node.wheel.after(a_move)) else {
                    continue;
                };
                *budget -= 1;
                // The path holds the start and the moves made, one fewer than positions; it is short.
                let left = self.length.saturating_sub(self.path.len() as u8);
                if patterns.bound(&wheel) > left {
                    continue;
                }
                if left > ball.radius() {
                    self.path.push(Node { wheel, tail, next: 0 });
                } else if let Some(way) = self.finish(&wheel, ball) {
                    return Deepened::Found(way);
                }
            }
            self.length = self.length.saturating_add(1);
        }
        Deepened::NotWithin
    }

    /// The whole way over a position, if its rest lies within the ball and is no longer than what is left.
    fn finish(&self, wheel: &Wheel, ball: &Ball) -> Option<Vec<Move>> {
        let left = usize::from(self.length).checked_sub(self.path.len())?;
        let distance = ball.distance(wheel)?;
        if usize::from(distance) > left {
            return None;
        }
        let made = self.path.iter().filter_map(|node| Move::ALL.get(node.next.checked_sub(1)?).copied());
        Some(made.chain(ball.way(wheel)?).collect())
    }
}
