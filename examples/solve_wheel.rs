//! A problem of the bead wheel by its number, and a proven shortest solution:
//!
//!     cargo run --release --example solve_wheel -- 7

use grafika::puzzle::wheel::{Difficulty, Scramble, Search, Solver, moves_to_text};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let number = std::env::args().nth(1).map_or(Ok(1), |text| text.parse())?;
    let problem = Scramble::new(Difficulty::Eight, number);
    println!("problem {number}: {}", moves_to_text(&problem.moves));

    // A solver works when it is told to, and can be asked or dropped in between.
    let mut solver = Solver::new(problem.wheel);
    while solver.step(100_000).search == Search::Working {}
    let solution = solver.solution().ok_or("every position has a solution")?;
    let proof = if solution.proven { "none is shorter" } else { "there may be a shorter one" };
    println!("solution: {} ({proof})", moves_to_text(&solution.moves));
    Ok(())
}
