//! The solver: good ways soon, then better ones, then the proof that none is shorter, as far as one waits.

use super::Wheel;
use super::ball::Ball;
use super::beam::Beam;
use super::deepen::{Deepen, Deepened};
use super::moves::Move;
use super::patterns::Patterns;

/// What is done one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// The distances of single colours.
    Patterns,
    /// How promising patterns are.
    Scores,
    /// The positions near solved, up to so many moves.
    Ball(u8),
    /// All ways shorter than this.
    Deepen(u8),
    /// A beam of this width.
    Beam(usize),
}

/// The plan: what is cheap and helps most comes first. A beam of 1000 gives a way for every position within
/// a fraction of a second.
const PLAN: [Stage; 13] = [
    Stage::Patterns,
    Stage::Ball(6),
    Stage::Deepen(12),
    Stage::Scores,
    Stage::Beam(1000),
    Stage::Ball(7),
    Stage::Deepen(15),
    Stage::Beam(32_000),
    Stage::Ball(8),
    Stage::Deepen(17),
    Stage::Beam(60_000),
    Stage::Beam(250_000),
    Stage::Deepen(u8::MAX),
];

/// All ways up to some length are looked at in vain when the best one of a beam is longer by more than this.
const NEAR: u8 = 6;

/// What all searches share and no search has to make again: the distances of single colours (22 megabytes) and
/// the positions near solved (up to 64 megabytes). They are made while a [`Solver`] works.
#[derive(Clone, Debug, Default)]
pub struct Tables {
    patterns: Patterns,
    ball: Ball,
}

/// A way to the solved wheel. It has been made move by move on a wheel before it was handed out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solution {
    /// The moves.
    pub moves: Vec<Move>,
    /// Whether it is proven that there is no shorter one.
    pub proven: bool,
}

/// Whether a solver has anything left to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// The budget was used up.
    Working,
    /// A shortest solution has been found and proven.
    Done,
}

/// How far a search is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Whether there is anything left to do.
    pub search: Search,
    /// Every solution has at least so many moves.
    pub at_least: usize,
    /// The best solution so far has so many moves.
    pub best: Option<usize>,
    /// How many positions have been looked at.
    pub spent: u64,
}

/// A search for the shortest solution of a position, a value that advances by a budget.
#[derive(Clone, Debug)]
pub struct Solver {
    start: Wheel,
    tables: Tables,
    /// Number of the stage in the plan.
    stage: usize,
    beam: Option<Beam>,
    deepen: Deepen,
    best: Option<Vec<Move>>,
    spent: u64,
}

impl Solver {
    /// A search from nothing.
    #[must_use]
    pub fn new(start: Wheel) -> Solver {
        Solver::with_tables(start, Tables::default())
    }

    /// A search with tables that an earlier one has made, or begun.
    #[must_use]
    pub fn with_tables(start: Wheel, tables: Tables) -> Solver {
        Solver { start, tables, stage: 0, beam: None, deepen: Deepen::new(start), best: None, spent: 0 }
    }

    /// Ends the search and gives its tables back.
    #[must_use]
    pub fn into_tables(self) -> Tables {
        self.tables
    }

    /// The position that is being solved.
    #[must_use]
    pub fn start(&self) -> Wheel {
        self.start
    }

    /// Looks at about so many positions more, at some millions a second.
    pub fn step(&mut self, budget: u64) -> Progress {
        let mut left = budget;
        while left > 0 && !self.is_proven() {
            let Some(&stage) = PLAN.get(self.stage) else { break };
            if self.work(stage, &mut left) {
                self.stage += 1;
            }
        }
        self.spent = self.spent.saturating_add(budget - left);
        self.progress()
    }

    /// Works on a stage; whether it has ended.
    fn work(&mut self, stage: Stage, budget: &mut u64) -> bool {
        let Tables { patterns, ball } = &mut self.tables;
        match stage {
            Stage::Patterns => patterns.measure(budget),
            Stage::Scores => patterns.score(budget),
            Stage::Ball(radius) => ball.advance(radius, budget),
            Stage::Beam(width) => {
                let beam = self.beam.get_or_insert_with(|| Beam::new(self.start, width));
                let ended = beam.advance(&mut self.best, patterns, ball, budget);
                if ended {
                    self.beam = None;
                }
                ended
            }
            Stage::Deepen(end) => {
                let best = self.best.as_ref().and_then(|best| u8::try_from(best.len()).ok());
                if best.is_some_and(|best| best > end.saturating_add(NEAR)) {
                    return true;
                }
                // A way as long as the best one is no gain.
                let end = best.map_or(end, |best| best.min(end));
                match self.deepen.advance(end, patterns, ball, budget) {
                    Deepened::Interrupted => false,
                    Deepened::NotWithin => true,
                    Deepened::Found(way) => {
                        self.best = Some(way);
                        true
                    }
                }
            }
        }
    }

    fn is_proven(&self) -> bool {
        self.best.as_ref().is_some_and(|best| best.len() <= usize::from(self.deepen.at_least()))
    }

    /// How far the search is.
    #[must_use]
    pub fn progress(&self) -> Progress {
        Progress {
            search: if self.is_proven() { Search::Done } else { Search::Working },
            at_least: self.deepen.at_least().into(),
            best: self.best.as_ref().map(Vec::len),
            spent: self.spent,
        }
    }

    /// How many positions near solved are known, those that are alike counted once.
    #[must_use]
    pub fn known(&self) -> usize {
        self.tables.ball.len()
    }

    /// The best solution so far; `None` if there is none yet.
    #[must_use]
    pub fn solution(&self) -> Option<Solution> {
        let moves = self.best.clone()?;
        // Whatever a table may say: only what solves the wheel is a solution.
        let solved = self.start.replay(&moves).is_ok_and(|end| end.is_solved());
        solved.then(|| Solution { moves, proven: self.is_proven() })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Difficulty, Scramble, moves_from_text};
    use super::*;

    /// Solves with a budget that is far more than enough and checks the way on a wheel.
    fn solve(wheel: Wheel, tables: Tables, budget: u64) -> (Solver, Solution) {
        let mut solver = Solver::with_tables(wheel, tables);
        while solver.progress().search == Search::Working && solver.progress().spent < budget {
            solver.step(50_000);
        }
        let solution = solver.solution().expect("there is a solution");
        assert!(wheel.replay(&solution.moves).unwrap().is_solved());
        (solver, solution)
    }

    #[test]
    fn scrambles_are_solved_in_their_proven_lengths() {
        let mut tables = Tables::default();
        for (letters, length) in [
            ("", 0),
            ("AA", 1),
            ("MCEM", 4),
            ("JLMAFD", 6),
            ("IDFBAEKN", 8),
            ("ECMJAMFNNC", 10),
            ("KKKKNDMEMFJJC", 11),
            ("EIBMJNIENLABDN", 8),
        ] {
            let wheel = Wheel::solved().after_all(&moves_from_text(letters).unwrap());
            let (solver, solution) = solve(wheel, tables, u64::MAX);
            assert_eq!((solution.moves.len(), solution.proven), (length, true), "{letters}");
            tables = solver.into_tables();
        }
    }

    #[test]
    fn any_position_is_solved_soon() {
        let mut tables = Tables::default();
        let mut lengths = Vec::new();
        for number in 0..3 {
            let wheel = Scramble::new(Difficulty::Any, number).wheel;
            let (solver, solution) = solve(wheel, tables, 2_500_000);
            assert!(solution.moves.len() <= 30 && !solution.proven, "{}", solution.moves.len());
            lengths.push(solution.moves.len());
            tables = solver.into_tables();
        }
        assert!(lengths.iter().sum::<usize>() <= 27 * lengths.len(), "{lengths:?}");
    }

    /// What a small machine does in two and in ten seconds, for every position from a cold start.
    #[test]
    #[ignore = "some minutes"]
    fn a_hundred_positions_are_solved_well() {
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for number in 0..100 {
            let mut solver = Solver::new(Scramble::new(Difficulty::Any, number).wheel);
            for (lengths, budget) in [(&mut first, 2_500_000), (&mut second, 20_000_000)] {
                while solver.progress().spent < budget {
                    solver.step(100_000);
                }
                lengths.push(solver.solution().expect("there is a solution").moves.len());
            }
        }
        let mean = |lengths: &[usize]| lengths.iter().sum::<usize>() as f64 / lengths.len() as f64;
        println!("{:.2} {first:?}\n{:.2} {second:?}", mean(&first), mean(&second));
        assert!(first.iter().all(|&length| length <= 30));
        assert!(mean(&second) <= 25.0);
    }

    #[test]
    fn pieces_of_work_lead_to_the_same_solution() {
        let wheel = Scramble::new(Difficulty::Sixteen, 3).wheel;
        let solve = |piece: u64| {
            let mut solver = Solver::new(wheel);
            while solver.progress().best.is_none() {
                solver.step(piece);
            }
            solver.solution()
        };
        assert_eq!(solve(777), solve(100_000));
    }
}
