//! The fit against independent routes, and what it reaches.

mod parts;
mod quality;
mod whole;

use super::axis::Axis;
use super::fitted;
use crate::geometry::Point;
use crate::geometry::kohonen::Topology;
use proptest::prelude::*;

/// A topology with a size that a surface or a curve can be made of.
fn shapes() -> impl Strategy<Value = (Topology, [usize; 2])> {
    let topology = proptest::sample::select(Topology::ALL.to_vec());
    let size = prop_oneof![
        4 => (4_usize..9, 4_usize..9),
        1 => (Just(1_usize), 4_usize..9),
        1 => (4_usize..9, Just(1_usize)),
    ];
    (topology, size)
        .prop_filter("a sphere has rows", |(topology, size)| *topology != Topology::Sphere || size.0 > 1)
        .prop_map(|(topology, (m, n))| (topology, [m, n]))
}

fn axes(topology: Topology, size: [usize; 2]) -> [Axis; 2] {
    fitted::axes(topology, size).unwrap()
}

/// Control points, those of poles equal.
fn nodes(topology: Topology, [m, n]: [usize; 2]) -> impl Strategy<Value = Vec<Point<3>>> {
    let point = proptest::array::uniform3(-1.0..1.0);
    proptest::collection::vec(point, m * n).prop_map(move |mut nodes| {
        if topology == Topology::Sphere {
            for row in [0, m - 1] {
                let pole = nodes[row * n];
                nodes[row * n..(row + 1) * n].fill(pole);
            }
        }
        nodes
    })
}
