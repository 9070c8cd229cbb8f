//! `grafika solve`: moves that solve a puzzle, and the number of ways.

use crate::source::InputFormat;
use clap::Args;
use grafika::disk::{read_stream, reason};
use grafika::file::{CsangoCube, Document, TableOptions};
use grafika::launch::{Failure, answer, open_as, progress, write_output};
use grafika::puzzle::cube::{Count, PIECES, Placed, Rules, Solver as CubeSolver, all_fillings};
use grafika::puzzle::wheel::{Search, Solver, Wheel, moves_from_text, moves_to_text};
use serde_json::json;
use std::path::Path;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

/// Positions of the wheel that are looked at before an unproven solution is given: less than ten seconds, and
/// as many as the solver's widest beam needs.
const ENOUGH: u64 = 20_000_000;
/// Positions between two looks at the progress.
const PIECE: u64 = 1_000_000;

/// Signs of a position of the cube: four for each piece.
const CUBE_TEXT: usize = 4 * PIECES;
/// Moves of the cube in a line of the answer.
const IN_LINE: usize = 20;

/// The command line of `grafika solve`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika solve MCEM
  grafika solve MCEM --json
  grafika solve FILE.CSK --rigid
  grafika solve --count A.CSK
  grafika solve --count
  cat wheel.gyk | grafika solve - --from gyk")]
pub(crate) struct Solve {
    /// A file of a puzzle (.GYK, .CSK), a position as a program shows it, moves from the solved wheel (MCEM), or -
    /// for standard input: such a text, or a file with --from; none with --count means the empty cube
    #[arg(required_unless_present = "count")]
    puzzle: Option<String>,
    #[command(flatten)]
    from: InputFormat,
    /// Count the ways to fill the cube around the pieces that lie in its place; without any, up to rotations
    #[arg(long)]
    count: bool,
    /// Threads that count; the number is the same for any
    #[arg(long, value_name = "N", requires = "count", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
    /// Turns of the cube's pieces may not pass through other pieces or the table
    #[arg(long, conflicts_with = "count")]
    rigid: bool,
    /// Tell the answer as JSON
    #[arg(long)]
    json: bool,
}

impl Solve {
    /// Solves and tells.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let from = self.from.from;
        let Some(puzzle) = &self.puzzle else { return self.tell(&self.number(&[])) };
        if puzzle == "-" && from.is_none() {
            let failure = |problem: String| Failure::work(format!("standard input: {problem}"));
            let text = read_stream(std::io::stdin().lock()).map_err(|error| failure(reason(&error)))?;
            let text = String::from_utf8(text).map_err(|_| failure("the text is not UTF-8".to_owned()))?;
            return self.text(text.trim());
        }
        // A file has an extension, a text has no point.
        if !puzzle.contains('.') && from.is_none() {
            return self.text(puzzle.trim());
        }
        match open_as(Path::new(puzzle), from, &TableOptions::default())?.document {
            Document::BeadWheel(wheel) => {
                self.wheel(&Wheel::try_from(&wheel).map_err(|error| self.problem(error))?)
            }
            Document::CsangoCube(position) => self.write_cube(&position),
            other => {
                let what = other.format().english();
                Err(self.problem(format!("{what}; there are solvers for .GYK and .CSK")))
            }
        }
    }

    /// A position or moves that are given as text.
    fn text(&self, text: &str) -> Result<(), Failure> {
        // The cube's text is the longer one, whatever stands in it.
        match text.chars().count() == CUBE_TEXT {
            true => self.write_cube(&text.parse().map_err(|error| self.problem(error))?),
            false => self.wheel(&wheel_of_text(text)?),
        }
    }

    fn problem(&self, problem: impl std::fmt::Display) -> Failure {
        Failure::work(format!("{}: {problem}", self.puzzle.as_deref().unwrap_or_default()))
    }

    /// The bead wheel: the moves, how many there are, whether that is proven.
    fn wheel(&self, wheel: &Wheel) -> Result<(), Failure> {
        if self.count {
            return Err(Failure::usage(
                "--count: solutions of the bead wheel are not counted, any number of detours leads there",
            ));
        }
        if self.rigid {
            return Err(Failure::usage("--rigid is for the Csángó cube; beads have nothing to bump into"));
        }
        let mut solver = Solver::new(*wheel);
        let alive = progress::alive("searching");
        loop {
            let progress = solver.step(PIECE);
            alive.say(format!("searching: {} million positions", progress.spent / 1_000_000));
            let content = progress.best.is_some() && progress.spent >= ENOUGH;
            if progress.search == Search::Done || content {
                break;
            }
        }
        drop(alive);
        let at_least = solver.progress().at_least;
        let solution = solver.solution().ok_or_else(|| self.problem("no solution was found"))?;
        let (text, count) = (moves_to_text(&solution.moves), solution.moves.len());
        if self.json {
            let told =
                json!({ "moves": text, "count": count, "proven": solution.proven, "at_least": at_least });
            return write_output(format!("{told}\n").as_bytes());
        }
        let proof = match solution.proven {
            true => "proven shortest".to_string(),
            false => format!("not proven shortest; at least {at_least} are needed"),
        };
        let text = format!("{text}\n{}, {proof}\n", counted(count));
        answer(&text)
    }

    fn write_cube(&self, position: &CsangoCube) -> Result<(), Failure> {
        let text = self.cube(position).map_err(|why| self.problem(why))?;
        self.tell(&text)
    }

    /// Writes an answer: words in the user's language, JSON as it is.
    fn tell(&self, text: &str) -> Result<(), Failure> {
        if self.json { write_output(text.as_bytes()) } else { answer(text) }
    }

    /// The Csángó cube: the moves from the position to the finished cube, or the number of fillings.
    fn cube(&self, position: &CsangoCube) -> Result<String, String> {
        if self.count {
            return Ok(self.fillings(position));
        }
        if position.is_finished() {
            return Ok(match self.json {
                true => format!("{}\n", json!({ "moves": [], "count": 0 })),
                false => "the cube is finished\n".to_owned(),
            });
        }
        let rules = if self.rigid { Rules::Rigid } else { Rules::Book };
        let _alive = progress::alive("searching");
        let moves = CubeSolver::new(position, rules, 0).finish();
        let moves = moves.map_err(|why| format!("no solution is found from this position: {why}"))?;
        let words: Vec<String> = moves.iter().map(ToString::to_string).collect();
        if self.json {
            return Ok(format!("{}\n", json!({ "moves": words, "count": words.len() })));
        }
        let lines: Vec<String> = words.chunks(IN_LINE).map(|line| line.join(" ")).collect();
        Ok(format!("{}\n{}\n", counted(moves.len()), lines.join("\n")))
    }

    /// The number of fillings around the pieces of a position. A finished cube is one wherever it stands.
    fn fillings(&self, position: &CsangoCube) -> String {
        if let Some(filling) = position.filling() {
            return self.number(&filling.placed);
        }
        let mut text = self.number(&position.placed());
        if self.json {
            return text;
        }
        for piece in position.sticking_out() {
            text += &format!("piece {} lies partly in the cube's place and was not counted\n", piece + 1);
        }
        text
    }

    /// The number of fillings around some pieces, in words; around none, up to rotations.
    fn number(&self, placed: &[Placed]) -> String {
        let count = if placed.is_empty() { all_fillings() } else { Count::with_fixed(placed) };
        let total = self.counted(&count);
        if self.json {
            return format!("{}\n", json!({ "fillings": total, "placed": placed.len() }));
        }
        let fillings = if total == 1 { "filling" } else { "fillings" };
        let up_to = if placed.is_empty() { " up to rotations" } else { "" };
        format!("{total} {fillings}{up_to}, {} of the pieces in their places\n", placed.len())
    }

    /// Counts the parts on threads: each takes the next one that nobody has taken.
    fn counted(&self, count: &Count) -> u64 {
        let available = std::thread::available_parallelism().map_or(1, |number| number.get());
        let threads = self.threads.map_or(available, usize::from);
        let (next, total) = (AtomicUsize::new(0), AtomicU64::new(0));
        let bar = progress::bar("counting", count.parts());
        std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|| {
                    loop {
                        let part = next.fetch_add(1, Ordering::Relaxed);
                        if part >= count.parts() {
                            break;
                        }
                        total.fetch_add(count.part(part).finish(), Ordering::Relaxed);
                        bar.advance();
                    }
                });
            }
        });
        total.into_inner()
    }
}

/// A number of moves, in words.
fn counted(moves: usize) -> String {
    let noun = if moves == 1 { "move" } else { "moves" };
    format!("{moves} {noun}")
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
