//! What the key K shows over the surface: its control net, and the convex hull of the control points.

use crate::design::NetDesign;
use crate::editor::seen::Item;
use crate::geometry::{Closure, Point, convex_hull};
use crate::screen::Color;
use crate::ui::Words;
use serde::Serialize;

/// What is shown over the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Frame {
    #[default]
    Off,
    Net,
    Hull,
}

impl Frame {
    /// The one after it; a net that is in the picture anyway needs no second.
    pub(super) fn next(self, net_seen: bool) -> Frame {
        match self {
            Frame::Off if net_seen => Frame::Hull,
            Frame::Off => Frame::Net,
            Frame::Net => Frame::Hull,
            Frame::Hull => Frame::Off,
        }
    }

    pub(super) fn name(self) -> Words {
        match self {
            Frame::Off => Words("keret nélkül", "no net, no hull"),
            Frame::Net => Words("a kontrollháló", "the control net"),
            Frame::Hull => Words("a pontok konvex burka", "the convex hull of the points"),
        }
    }

    /// Its lines.
    pub(super) fn items(self, net: &NetDesign) -> Vec<Item<3>> {
        let line = |ends: [Point<3>; 2], ink: Color| Item::Line { ends, ink };
        match self {
            Frame::Off => Vec::new(),
            Frame::Net => {
                let lines = net.frame().into_iter().flat_map(|(points, closed)| legs(&points, closed));
                lines.map(|ends| line(ends, Color::LightGray)).collect()
            }
            Frame::Hull => {
                let points: Vec<Point<3>> = net.frame().into_iter().flat_map(|(points, _)| points).collect();
                let edges = convex_hull(&points).edges.into_iter();
                let ends = edges.filter_map(|[a, b]| Some([*points.get(a)?, *points.get(b)?]));
                ends.map(|ends| line(ends, Color::LightGreen)).collect()
            }
        }
    }
}

/// The lines from every point to the next.
pub(super) fn legs(points: &[Point<3>], closed: bool) -> Vec<[Point<3>; 2]> {
    let closure = if closed && points.len() > 2 { Closure::Closed } else { Closure::Open };
    let back = points.first().filter(|_| closure == Closure::Closed);
    points.iter().zip(points.iter().skip(1).chain(back)).map(|(a, b)| [*a, *b]).collect()
}
