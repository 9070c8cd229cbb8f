//! The control points of an `.IP2` file of 1997, one in a line; without a name those of a built-in sample:
//!
//!     cargo run --example read_ip2 -- A.IP2

use grafika::file::{Document, Format};
use grafika::machine::{Memory, Storage};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let content = match std::env::args().nth(1) {
        Some(name) => std::fs::read(name)?,
        // A storage without files of its own has the samples.
        None => Memory::default().read("A.IP2")?,
    };
    // A file that is too short, or counts more points than it can have, is an error that says so.
    let document = Document::read(Format::Ip2, &content)?;
    let Document::PlanePoints(points) = &document else {
        return Err("an .IP2 file holds points of the plane".into());
    };
    for [x, y] in &points.points {
        println!("{x} {y}");
    }
    Ok(())
}
