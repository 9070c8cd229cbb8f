//! What items look like in space: computed once, kept while nothing changes.

use crate::design::ec::{Bases, EcArc, EcWeave};
use crate::file::ec::{Item, Scene};
use crate::geometry::{BoundingBox, Grid, ParamCurve, Point};

/// An item with its points in space.
#[derive(Debug)]
pub(super) enum Shape {
    Curve {
        arc: EcArc,
        line: Vec<Point<3>>,
    },
    Patch {
        weave: EcWeave,
        grid: Grid,
    },
    /// What has no shape; scenes that are opened or edited have none of them.
    None,
}

impl Shape {
    pub(super) fn points(&self) -> &[Point<3>] {
        match self {
            Shape::Curve { line, .. } => line,
            Shape::Patch { grid, .. } => grid.points(),
            Shape::None => &[],
        }
    }
}

/// The shapes of a scene.
#[derive(Debug, Default)]
pub(super) struct Shapes {
    kept: Vec<Kept>,
}

#[derive(Debug)]
struct Kept {
    item: Item,
    steps: (usize, [usize; 2]),
    shape: Shape,
}

impl Shapes {
    /// Brings the shapes up to date with a scene.
    pub(super) fn follow(&mut self, scene: &Scene, bases: &mut Bases) {
        let steps = (scene.settings.points, scene.settings.mesh);
        self.kept.truncate(scene.items.len());
        for (at, item) in scene.items.iter().enumerate() {
            let fresh = self.kept.get(at).is_some_and(|kept| kept.steps == steps && same(&kept.item, item));
            if fresh {
                continue;
            }
            let kept = Kept { item: item.clone(), steps, shape: shape(item, steps, bases) };
            match self.kept.get_mut(at) {
                Some(old) => *old = kept,
                None => self.kept.push(kept),
            }
        }
    }

    pub(super) fn of(&self, item: usize) -> Option<&Shape> {
        self.kept.get(item).map(|kept| &kept.shape)
    }

    /// A box round some items, or all.
    pub(super) fn bounds(&self, only: Option<usize>) -> Option<BoundingBox<3>> {
        let kept = self.kept.iter().enumerate().filter(|(at, _)| only.is_none_or(|only| only == *at));
        kept.filter_map(|(_, kept)| BoundingBox::of_points(kept.shape.points())).reduce(BoundingBox::union)
    }
}

/// Whether two items have the same points; how they are drawn does not matter.
fn same(one: &Item, other: &Item) -> bool {
    match (one, other) {
        (Item::Curve(a), Item::Curve(b)) => {
            a.points == b.points && a.interval == b.interval && a.space == b.space
        }
        (Item::Patch(a), Item::Patch(b)) => {
            a.net == b.net
                && a.interval_u == b.interval_u
                && a.interval_v == b.interval_v
                && a.space_u == b.space_u
                && a.space_v == b.space_v
        }
        _ => false,
    }
}

fn shape(item: &Item, (points, mesh): (usize, [usize; 2]), bases: &mut Bases) -> Shape {
    let made = match item {
        Item::Curve(curve) => bases.arc(curve).map(|arc| {
            let line = arc.polyline(points).unwrap_or_default();
            Shape::Curve { arc, line }
        }),
        Item::Patch(patch) => bases.weave(patch).map(|weave| {
            let grid = weave.mesh(mesh);
            Shape::Patch { weave, grid }
        }),
    };
    made.unwrap_or(Shape::None)
}
