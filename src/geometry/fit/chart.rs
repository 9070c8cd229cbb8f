//! The first parameters of points: the nearest place of the net, its cells taken as bilinear.

use super::axis::Axis;
use super::step::Tangents;
use crate::geometry::kohonen::{KohonenError, Net, Search, Topology};
use crate::geometry::{Point, dot};

/// Steps towards the foot of a point in a cell.
const STEPS: usize = 6;

/// A net that gives parameters.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    net: Net,
    /// By the neuron at which they begin.
    cells: Vec<Cell>,
    room: Search,
}

/// A bilinear cell: `corner + s along + t across + s t twist`.
#[derive(Clone, Copy, Debug)]
struct Cell {
    corner: Point<3>,
    along: Point<3>,
    across: Point<3>,
    twist: Point<3>,
}

impl Cell {
    /// The cell of a neuron with the next row and the next column; where there is none, it has no width.
    fn new(axes: &[Axis; 2], net: &Net, [i, j]: [usize; 2]) -> Self {
        let next = [axes[0].beside(i, 1).unwrap_or(i), axes[1].beside(j, 1).unwrap_or(j)];
        let [a, b] = [net.point([i, j]), net.point([next[0], j])];
        let [c, d] = [net.point([i, next[1]]), net.point(next)];
        Self {
            corner: a,
            along: std::array::from_fn(|k| b[k] - a[k]),
            across: std::array::from_fn(|k| c[k] - a[k]),
            twist: std::array::from_fn(|k| d[k] - b[k] - c[k] + a[k]),
        }
    }
}

impl Chart {
    /// The chart of a net by its neurons, in the unit of the points to come.
    pub(super) fn new(
        axes: &[Axis; 2],
        topology: Topology,
        neurons: &[Vec<Point<3>>],
    ) -> Result<Self, KohonenError> {
        let net = Net::new(topology, neurons)?;
        let columns = axes[1].count();
        let cells = (0..axes[0].count() * columns).map(|k| Cell::new(axes, &net, [k / columns, k % columns]));
        Ok(Self { cells: cells.collect(), net, room: Search::default() })
    }

    /// The parameters of a point.
    pub(super) fn parameters(&mut self, axes: &[Axis; 2], point: Point<3>) -> [f64; 2] {
        let ([i, j], _) = self.net.search(point, &mut self.room);
        let mut best = ([0.0; 2], f64::INFINITY);
        for row in beginnings(&axes[0], i) {
            // All cells meet at a pole.
            let pole = self.net.topology() == Topology::Sphere && (i == 0 || i + 1 == axes[0].count());
            let around = if pole { 0..axes[1].count() } else { 0..0 };
            let columns = around.map(Some).chain(beginnings(&axes[1], j).filter(|_| !pole).map(Some));
            for column in columns.flatten() {
                let (part, square) = self.foot(row * axes[1].count() + column, point);
                if square < best.1 {
                    let u = axes[0].parameter(row, part[0]);
                    best = ([u, axes[1].parameter(column, part[1])], square);
                }
            }
        }
        best.0
    }

    /// The place in a cell that is nearest to a point, and the square of its distance.
    fn foot(&self, cell: usize, point: Point<3>) -> ([f64; 2], f64) {
        let Some(Cell { corner, along, across, twist }) = self.cells.get(cell) else {
            return ([0.0; 2], f64::INFINITY);
        };
        let to: Point<3> = std::array::from_fn(|k| point[k] - corner[k]);
        let way = |[s, t]: [f64; 2]| -> Point<3> {
            std::array::from_fn(|k| to[k] - s * along[k] - t * across[k] - s * t * twist[k])
        };
        let mut at = [0.5; 2];
        for _ in 0..STEPS {
            let rest = way(at);
            let su: Point<3> = std::array::from_fn(|k| along[k] + at[1] * twist[k]);
            let sv: Point<3> = std::array::from_fn(|k| across[k] + at[0] * twist[k]);
            let metric = [dot(su, su), dot(su, sv), dot(sv, sv)];
            let next = Tangents { metric, way: [dot(rest, su), dot(rest, sv)] }.target(at, [false; 2]);
            let moved = (next[0] - at[0]).abs().max((next[1] - at[1]).abs());
            at = next;
            // What is left changes no digit of a first guess.
            if moved < 1e-9 {
                break;
            }
        }
        let rest = way(at);
        (at, dot(rest, rest))
    }
}

/// The neurons at which the edges beside a neuron begin; itself where there are no edges.
fn beginnings(axis: &Axis, node: usize) -> impl Iterator<Item = usize> + use<> {
    let before = axis.beside(node, -1);
    let itself = axis.is_point() || axis.beside(node, 1).is_some();
    before.into_iter().chain(itself.then_some(node))
}
