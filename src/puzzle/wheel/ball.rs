//! Every position within some moves of solved, with its distance: one entry for the twelve positions that are
//! alike up to turning and mirroring. Up to 8 moves these are 2.64 million entries, 64 megabytes.

use super::Wheel;
use super::moves::Move;

/// Where the distance stands in an entry, above the 93 bits of the position.
const DISTANCE: u32 = 96;
/// The bits of the position.
const POSITION: u128 = (1 << DISTANCE) - 1;

/// So many entries are passed in the time that a position takes, and so many are moved.
const PASSED: usize = 64;
const MOVED: usize = 8;

/// The positions near solved, which grow piece by piece.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    /// A hash table with open addresses; 0 is an empty place, for no position has the number 0.
    entries: Vec<u128>,
    /// Those of the table before, which are still to be moved; none while anything is looked up.
    moving: Vec<u128>,
    count: usize,
    /// Entries of the outermost whole layer, and of all whole layers.
    outermost: usize,
    whole: usize,
    radius: u8,
    /// The next entry to be followed up on the way to the next radius.
    next: usize,
}

impl Default for Ball {
    fn default() -> Ball {
        let mut ball = Ball {
            entries: vec![0; 1 << 10],
            moving: Vec::new(),
            count: 0,
            outermost: 1,
            whole: 1,
            radius: 0,
            next: 0,
        };
        ball.insert(Wheel::solved().orbit(), 0);
        ball
    }
}

fn distance_of(entry: u128) -> u8 {
    (entry >> DISTANCE) as u8
}

impl Ball {
    /// All positions at most so many moves from solved are known.
    pub(super) fn radius(&self) -> u8 {
        self.radius
    }

    /// How many positions are known, those that are alike counted once.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// The place of a position in the table, or the empty one where it would be put.
    fn place(&self, position: u128) -> usize {
        let folded = (position as u64) ^ ((position >> 64) as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mixed = (folded ^ folded >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mask = self.entries.len() - 1; // a power of two, at least 1024
        let mut place = (mixed ^ mixed >> 32) as usize & mask;
        // Some place is always empty: before every position that is followed up the table is less than three quarters full.
        while self.entries[place] != 0 && self.entries[place] & POSITION != position {
            place = (place + 1) & mask;
        }
        place
    }

    /// Adds a position that is not known yet.
    fn insert(&mut self, position: u128, distance: u8) {
        let place = self.place(position);
        if self.entries[place] == 0 {
            self.entries[place] = position | u128::from(distance) << DISTANCE;
            self.count += 1;
        }
    }

    /// Takes a larger table, into which all entries are to be moved; the layer that is being followed up is begun again.
    fn grow_to(&mut self, size: usize) {
        self.moving = std::mem::replace(&mut self.entries, vec![0; size]);
        self.next = 0;
    }

    /// Moves entries into the larger table until the budget is used up or none is left; whether none is left.
    fn settle(&mut self, budget: &mut u64) -> bool {
        while !self.moving.is_empty() {
            if *budget == 0 {
                return false;
            }
            for _ in 0..MOVED {
                let Some(entry) = self.moving.pop() else { break };
                if entry != 0 {
                    let place = self.place(entry & POSITION);
                    self.entries[place] = entry;
                }
            }
            *budget -= 1;
        }
        // Its room too.
        self.moving = Vec::new();
        true
    }

    /// Works towards a radius until the budget of moves is used up; whether the radius is reached.
    pub(super) fn advance(&mut self, radius: u8, budget: &mut u64) -> bool {
        while self.settle(budget) && self.radius < radius {
            if self.next == 0 {
                // A layer is some eight times the one before.
                let expected = self.count + 8 * self.outermost;
                let size = (4 * expected / 3).next_power_of_two();
                if size > self.entries.len() {
                    self.grow_to(size);
                    continue;
                }
            }
            while let Some(&entry) = self.entries.get(self.next) {
                if *budget == 0 {
                    return false;
                }
                if 4 * (self.count + Move::ALL.len()) > 3 * self.entries.len() {
                    self.grow_to(2 * self.entries.len());
                    break;
                }
                self.next += 1;
                if self.next.is_multiple_of(PASSED) {
                    *budget -= 1;
                }
                if entry != 0 && distance_of(entry) == self.radius {
                    let wheel = Wheel::of_orbit(entry & POSITION);
                    for next in Move::ALL.iter().filter_map(|&a_move| wheel.after(a_move)) {
                        self.insert(next.orbit(), self.radius + 1);
                    }
                    *budget = budget.saturating_sub(12);
                }
            }
            if self.next == 0 {
                continue;
            }
            self.radius += 1;
            self.next = 0;
            self.outermost = self.count - self.whole;
            self.whole = self.count;
        }
        self.moving.is_empty()
    }

    /// The distance of a position from solved, if it lies within the radius.
    pub(super) fn distance(&self, wheel: &Wheel) -> Option<u8> {
        let entry = self.entries[self.place(wheel.orbit())];
        (entry != 0).then(|| distance_of(entry)).filter(|&distance| distance <= self.radius)
    }

    /// A shortest way to solved from a position within the radius.
    pub(super) fn way(&self, wheel: &Wheel) -> Option<Vec<Move>> {
        let mut wheel = *wheel;
        let mut distance = self.distance(&wheel)?;
        let mut way = Vec::new();
        while distance > 0 {
            let steps = Move::ALL.into_iter().filter_map(|a_move| Some((a_move, wheel.after(a_move)?)));
            let nearer = |(_, next): &(Move, Wheel)| self.distance(next) == Some(distance - 1);
            let (a_move, next) = steps.into_iter().find(nearer)?;
            way.push(a_move);
            (wheel, distance) = (next, distance - 1);
        }
        Some(way)
    }

    /// How many positions lie at a distance, the symmetric ones counted each.
    #[cfg(test)]
    fn positions_at(&self, distance: u8) -> usize {
        let entries = self.entries.iter().filter(|&&it| it != 0 && distance_of(it) == distance);
        entries.map(|&entry| Wheel::of_orbit(entry & POSITION).orbit_size()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count_to(radius: u8) {
        let counts = [1, 12, 114, 1007, 8316, 65118, 494_325, 3_696_241, 27_422_616];
        let mut ball = Ball::default();
        assert!(ball.advance(radius, &mut u64::MAX.clone()));
        for (distance, count) in (0..=radius).zip(counts) {
            assert_eq!(ball.positions_at(distance), count, "{distance}");
        }
    }

    #[test]
    fn as_many_positions_as_there_are() {
        count_to(6);
    }

    #[test]
    #[ignore = "some seconds"]
    fn as_many_positions_as_there_are_up_to_eight_moves() {
        count_to(8);
    }

    #[test]
    fn small_budgets_make_the_same_ball() {
        let mut pieces = Ball::default();
        while !pieces.advance(4, &mut 7) {}
        let mut ball = Ball::default();
        assert!(ball.advance(4, &mut u64::MAX.clone()));
        assert_eq!((pieces.len(), pieces.entries), (ball.len(), ball.entries));
    }
}
