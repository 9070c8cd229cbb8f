//! `grafika solve`: the solution of a puzzle.

use clap::Args;
use grafika::file::Document;
use grafika::launch::{Failure, open, write_output};
use grafika::puzzle::wheel::{Search, Solver, Wheel, moves_from_text, moves_to_text};
use std::path::Path;

/// Positions of the wheel that are looked at before an unproven solution is given: some seconds.
const ENOUGH: u64 = 60_000_000;
/// Positions between two looks at the progress.
const PIECE: u64 = 1_000_000;

/// The command line of `grafika solve`.
#[derive(Args)]
pub(crate) struct Solve {
    /// A file of a puzzle (.GYK), a position of the bead wheel as the program shows it
    /// (0-1111-2222-3333-4444-5555-6666), or moves from the solved wheel (MCEM)
    puzzle: String,
    /// Count the solutions, for puzzles that have several
    #[arg(long)]
    count: bool,
    /// Threads to work with, for puzzles whose work can be divided
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: u16,
}

impl Solve {
    /// Solves and tells.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        // A file has an extension, a text has no point.
        if !self.puzzle.contains('.') {
            return self.wheel(&wheel_of_text(&self.puzzle)?);
        }
        match open(Path::new(&self.puzzle))?.document {
            Document::BeadWheel(wheel) => {
                self.wheel(&Wheel::try_from(&wheel).map_err(|error| self.problem(error))?)
            }
            other => Err(self.problem(format!("{}; there is a solver for .GYK", other.format().english()))),
        }
    }

    fn problem(&self, problem: impl std::fmt::Display) -> Failure {
        Failure::work(format!("{}: {problem}", self.puzzle))
    }

    /// The bead wheel: the moves, how many there are, whether that is proven.
    fn wheel(&self, wheel: &Wheel) -> Result<(), Failure> {
        if self.count {
            return Err(Failure::usage(
                "--count: solutions of the bead wheel are not counted, any number of detours leads there",
            ));
        }
        // One thread is enough here, however many there may be.
        let _ = self.threads;
        let mut solver = Solver::new(*wheel);
        loop {
            let progress = solver.step(PIECE);
            let content = progress.best.is_some() && progress.spent >= ENOUGH;
            if progress.search == Search::Done || content {
                break;
            }
        }
        let at_least = solver.progress().at_least;
        let solution = solver.solution().ok_or_else(|| self.problem("no solution was found"))?;
        let proof = match solution.proven {
            true => "proven shortest".to_string(),
            false => format!("not proven shortest; at least {at_least} are needed"),
        };
        let text = format!("{}\n{} moves, {proof}\n", moves_to_text(&solution.moves), solution.moves.len());
        write_output(None, text.as_bytes())
    }
}

/// A position, or the one that moves lead to.
fn wheel_of_text(text: &str) -> Result<Wheel, Failure> {
    let wrong = |problem: String| Failure::usage(format!("{text:?}: {problem}"));
    if text.chars().any(|letter| letter.is_ascii_digit()) {
        return text.parse::<Wheel>().map_err(|error| wrong(error.to_string()));
    }
    let moves = moves_from_text(text).map_err(|error| wrong(error.to_string()))?;
    Ok(Wheel::solved().after_all(&moves))
}
