//! `grafika solve`: moves that finish a puzzle, and the number of ways.

use clap::Args;
use grafika::file::{CsangoCube, Document};
use grafika::launch::{Failure, open, write_output};
use grafika::puzzle::cube::{Count, Progress, Rules, Search, Way, all_fillings};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

/// Moves in a line of the answer.
const IN_LINE: usize = 20;

/// The command line of `grafika solve`.
#[derive(Args)]
pub(crate) struct Solve {
    /// A position: .CSK, .json, or a built-in sample
    file: PathBuf,
    /// Count the ways to fill the cube around the pieces that lie in its place; without any, up to rotations
    #[arg(long)]
    count: bool,
    /// Threads that count; the number is the same for any
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
    /// Turns may not pass through other pieces or the table
    #[arg(long)]
    rigid: bool,
}

impl Solve {
    /// Solves what the file holds.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let opened = open(&self.file)?;
        let text = match &opened.document {
            Document::CsangoCube(position) => self.cube(position),
            _ => Err("this file holds no puzzle; .CSK does".to_owned()),
        };
        let text = text.map_err(|why| Failure::work(format!("{}: {why}", opened.name)))?;
        write_output(None, text.as_bytes())
    }

    /// The Csángó cube: the moves from the position to the finished cube, or the number of fillings.
    fn cube(&self, position: &CsangoCube) -> Result<String, String> {
        let placed = position.placed();
        if self.count {
            let count = if placed.is_empty() { all_fillings() } else { Count::with_fixed(&placed) };
            let total = if position.is_finished() { 1 } else { self.counted(&count) };
            let up_to = if placed.is_empty() { " up to rotations" } else { "" };
            return Ok(format!("{total} fillings{up_to}, {} of the pieces in their places\n", placed.len()));
        }
        if position.is_finished() {
            return Ok("the cube is finished\n".to_owned());
        }
        let rules = if self.rigid { Rules::Rigid } else { Rules::Book };
        // What lies in the cube's place stays if it can; else all comes out.
        let found = [placed, Vec::new()].into_iter().find_map(|fixed| {
            let mut search = Search::new(&fixed, 0);
            let Progress::Found(filling) = search.advance(u64::MAX) else { return None };
            Way::new(position, &filling, rules).and_then(Way::finish).ok()
        });
        let moves = found.ok_or("no solution is found from this position")?;
        let words: Vec<String> = moves.iter().map(ToString::to_string).collect();
        let lines: Vec<String> = words.chunks(IN_LINE).map(|line| line.join(" ")).collect();
        Ok(format!("{} moves\n{}\n", moves.len(), lines.join("\n")))
    }

    /// Counts the parts on threads: each takes the next one that nobody has taken.
    fn counted(&self, count: &Count) -> u64 {
        let available = std::thread::available_parallelism().map_or(1, |number| number.get());
        let threads = self.threads.map_or(available, usize::from);
        let (next, total) = (AtomicUsize::new(0), AtomicU64::new(0));
        std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|| {
                    loop {
                        let part = next.fetch_add(1, Ordering::Relaxed);
                        if part >= count.parts() {
                            break;
                        }
                        total.fetch_add(count.part(part).finish(), Ordering::Relaxed);
                    }
                });
            }
        });
        total.into_inner()
    }
}
