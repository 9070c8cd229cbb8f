//! Circles of Apollonius, radical lines and power points, to be shown beside the skin.

use super::graph::Graph;
use super::{Circle, Circles};
use crate::geometry::Point;
use crate::geometry::point::norm;

/// What touches a circle and two neighbours of it from the same side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apollonius {
    /// The neighbours, and the circle in the middle: neighbour, circle, next neighbour counterclockwise.
    pub circles: [usize; 3],
    /// Where the middle one is touched; the skin does so too.
    pub touch: Point<2>,
    /// The touching circle itself.
    pub shape: TouchingShape,
}

/// A circle, or the line that it becomes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TouchingShape {
    /// A circle.
    Circle(Circle),
    /// A line through the touching point, in the direction of this unit vector; also for circles of more than a million
    /// times the size of those that it touches.
    Line(Point<2>),
}

/// The line of equal powers of two neighbours: where their circles meet or, if they are apart, between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadicalLine {
    /// The neighbours.
    pub circles: [usize; 2],
    /// Where the line crosses that of the centres.
    pub point: Point<2>,
    /// Its direction, a unit vector.
    pub direction: Point<2>,
}

/// The point with the same power to three circles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerPoint {
    /// The circles; of a chain or ring three successive ones.
    pub circles: [usize; 3],
    /// The point.
    pub point: Point<2>,
    /// Its power, positive outside all three discs, as it is where the circles are admissible.
    pub power: f64,
}

/// Touching circles of a larger radius, in sizes of those that they touch, are lines.
const STRAIGHT: f64 = 1e6;

impl Circles {
    /// The touching circles of all gaps between two neighbours of a circle that have one. In a chain there is one to
    /// the left and one to the right of every inner circle.
    #[must_use]
    pub fn apollonius(&self) -> Vec<Apollonius> {
        let graph = Graph::new(self);
        let found = graph.gaps().into_iter().filter_map(|(circles, contact)| {
            let [before, here, behind] = circles.map(|number| self.circles().get(number));
            let (before, here, behind) = (before?, here?, behind?);
            let size = [before, behind]
                .iter()
                .map(|other| other.distance(here.center) + other.radius)
                .fold(here.radius, f64::max);
            // R + r, by which the centre is further along the normal.
            let reach = 0.5 / contact.bend;
            let touch = here.point(contact.normal);
            let center: Point<2> = std::array::from_fn(|d| here.center[d] + reach * contact.normal[d]);
            let radius = (reach - here.radius).abs();
            let shape = if radius < STRAIGHT * size && radius > 0.0 {
                TouchingShape::Circle(Circle { center, radius })
            } else {
                TouchingShape::Line(contact.forward())
            };
            Some(Apollonius { circles, touch, shape })
        });
        found.collect()
    }

    /// The radical lines of all pairs of neighbours, except concentric ones.
    #[must_use]
    pub fn radical_lines(&self) -> Vec<RadicalLine> {
        let line = |circles: [usize; 2]| {
            let [first, last] = circles.map(|number| self.circles().get(number));
            let (first, last) = (first?, last?);
            let axis = first.axis(last)?;
            let point: Point<2> = std::array::from_fn(|d| first.center[d] + axis.radical * axis.direction[d]);
            let [x, y] = axis.direction;
            point.iter().all(|x| x.is_finite()).then_some(RadicalLine { circles, point, direction: [-y, x] })
        };
        self.edges().into_iter().filter_map(line).collect()
    }

    /// The power points of every circle with two successive neighbours, except of collinear centres.
    #[must_use]
    pub fn power_points(&self) -> Vec<PowerPoint> {
        let graph = Graph::new(self);
        graph.triples().into_iter().filter_map(|circles| self.power_point(circles)).collect()
    }

    /// The power point of three circles.
    fn power_point(&self, circles: [usize; 3]) -> Option<PowerPoint> {
        let [before, here, behind] = circles.map(|number| self.circles().get(number));
        let (before, here, behind) = (before?, here?, behind?);
        let (a, b) = (here.axis(before)?, here.axis(behind)?);
        let ([ax, ay], [bx, by]) = (a.direction, b.direction);
        let sine = ax * by - ay * bx;
        // From the middle circle it is as far along each axis as the radical line crosses it.
        let away = [(a.radical * by - b.radical * ay) / sine, (b.radical * ax - a.radical * bx) / sine];
        let size = a.length.max(b.length).max(here.radius);
        if !away.iter().all(|x| x.abs() < STRAIGHT * size) {
            return None;
        }
        let point: Point<2> = std::array::from_fn(|d| here.center[d] + away[d]);
        let distance = norm(away);
        let power = (distance - here.radius) * (distance + here.radius);
        power.is_finite().then_some(PowerPoint { circles, point, power })
    }
}
