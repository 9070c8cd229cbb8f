//! What can be wrong with circles, spheres and their links, in sentences.

use super::{MAX_BALLS, MAX_EDGES};
use crate::geometry::COORDINATE_LIMIT;
use crate::geometry::error::in_digits;
use std::fmt;

/// Why circles or spheres cannot be taken. The sentences count circles, spheres, edges and chains from 1, as users see
/// them; a number that an edge or chain names, and that nothing has, stands as in the document, from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SkinError {
    /// Too few for a chain or ring.
    TooFew {
        /// What they should become: `chain`, `ring`.
        shape: &'static str,
        /// How many were given.
        given: usize,
        /// How many are needed at least.
        needed: usize,
    },
    /// More than [`MAX_BALLS`].
    TooMany {
        /// How many were given.
        given: usize,
    },
    /// A coordinate that is no number, or larger than [`COORDINATE_LIMIT`].
    Center {
        /// The circle or sphere, from 1.
        number: usize,
        /// The coordinate.
        value: f64,
    },
    /// A radius that is not positive, no number, or larger than [`COORDINATE_LIMIT`].
    Radius {
        /// The circle or sphere, from 1.
        number: usize,
        /// The radius.
        value: f64,
    },
    /// More edges than [`MAX_EDGES`].
    TooManyEdges {
        /// How many were given.
        given: usize,
    },
    /// An edge or chain names what does not exist.
    NoSuch {
        /// What names it: `edge`, `chain`.
        what: &'static str,
        /// The edge or chain, from 0.
        index: usize,
        /// The number named, from 0.
        named: usize,
        /// How many there are.
        count: usize,
    },
    /// An edge from a circle to itself.
    ToItself {
        /// The edge, from 0.
        edge: usize,
        /// The circle, from 0.
        circle: usize,
    },
    /// Two edges between the same circles.
    Doubled {
        /// The second edge, from 0.
        edge: usize,
        /// The circles, from 0.
        circles: [usize; 2],
    },
    /// An edge that closes a cycle, where a tree is needed.
    Cycle {
        /// The edge, from 0.
        edge: usize,
        /// The circles that it joins, from 0.
        circles: [usize; 2],
    },
    /// No edges lead from the first circle to another one.
    NotConnected {
        /// The other circle, from 0.
        circle: usize,
    },
    /// A chain with less than two spheres.
    ShortChain {
        /// The chain, from 0.
        chain: usize,
    },
    /// A chain that comes back to one of its spheres.
    Repeated {
        /// The chain, from 0.
        chain: usize,
        /// The sphere, from 0.
        sphere: usize,
    },
    /// A sphere that is in no chain.
    Unlinked {
        /// The sphere, from 0.
        sphere: usize,
    },
    /// Several chains that should be closed.
    ClosedChains {
        /// How many were given.
        given: usize,
    },
    /// A mesh of too few or too many steps.
    Steps {
        /// The steps asked for.
        given: usize,
        /// The fewest that can be given.
        least: usize,
        /// The most that can be given.
        most: usize,
    },
}

/// A number that counts from 0, as users see it.
fn from_one(index: usize) -> usize {
    index.saturating_add(1)
}

impl fmt::Display for SkinError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooFew { shape, given, needed } => {
                write!(f, "too few for a {shape}: {given} given, at least {needed} needed")
            }
            Self::TooMany { given } => {
                write!(f, "too many circles or spheres: {given} given, at most {MAX_BALLS} allowed")
            }
            Self::Center { number, value } => write!(
                f,
                "the centre of number {number} has the coordinate {}, but it must be a number of at most {COORDINATE_LIMIT:e}",
                in_digits(value)
            ),
            Self::Radius { number, value } => write!(
                f,
                "the radius of number {number} is {}, but it must be positive and at most {COORDINATE_LIMIT:e}",
                in_digits(value)
            ),
            Self::TooManyEdges { given } => {
                write!(f, "too many edges: {given} given, at most {MAX_EDGES} allowed")
            }
            Self::NoSuch { what, index, named, count } => {
                let number = from_one(index);
                write!(f, "{what} {number} names number {named}, but there are {count}, numbered from 0")
            }
            Self::ToItself { edge, circle } => {
                let [edge, circle] = [edge, circle].map(from_one);
                write!(f, "edge {edge} joins circle {circle} with itself; it must join two circles")
            }
            Self::Doubled { edge, circles: [a, b] } => {
                let [edge, a, b] = [edge, a, b].map(from_one);
                write!(f, "edge {edge} joins circles {a} and {b} a second time; one edge is enough")
            }
            Self::Cycle { edge, circles: [a, b] } => {
                let [edge, a, b] = [edge, a, b].map(from_one);
                write!(
                    f,
                    "edge {edge} between circles {a} and {b} closes a cycle; in a tree there is one way between two circles"
                )
            }
            Self::NotConnected { circle } => {
                let circle = from_one(circle);
                write!(f, "no edges lead from circle 1 to circle {circle}; a tree hangs together")
            }
            Self::ShortChain { chain } => {
                let chain = from_one(chain);
                write!(f, "chain {chain} has less than two spheres; two are needed at least")
            }
            Self::Repeated { chain, sphere } => {
                let [chain, sphere] = [chain, sphere].map(from_one);
                write!(
                    f,
                    "chain {chain} has sphere {sphere} twice; a chain passes a sphere once (closed ones are marked as closed)"
                )
            }
            Self::Unlinked { sphere } => {
                let sphere = from_one(sphere);
                write!(f, "sphere {sphere} is in no chain; every sphere belongs to one at least")
            }
            Self::ClosedChains { given } => {
                write!(f, "{given} chains cannot be closed; only a single one can")
            }
            Self::Steps { given, least, most } => {
                write!(f, "{given} steps asked for, but {least} to {most} can be given")
            }
        }
    }
}

impl std::error::Error for SkinError {}
