//! What an item would be, beside what it is: wires in a small picture.

use super::eye::Eye;
use super::paint::{Show, paint};
use super::shape::Shapes;
use crate::design::ec::Bases;
use crate::file::ec::{Fill, Item, Scene};
use crate::screen::{Color, Screen};
use crate::ui::{Area, window};

/// Points of a curve, and cells of a patch along each direction.
const POINTS: usize = 100;
const MESH: [usize; 2] = [12, 12];
/// The least height that shows something.
const LEAST: i32 = 60;

/// The present item in dark grey, and a new one in white.
#[derive(Debug, Default)]
pub(super) struct Preview {
    scene: Scene,
    shapes: Shapes,
    eye: Eye,
}

impl Preview {
    /// The picture of an item and of what it would be, as they are seen by this eye.
    pub(super) fn new(old: &Item, new: Option<Item>, eye: Eye, bases: &mut Bases) -> Preview {
        let old = in_wires(old.clone(), Color::DarkGray);
        let items = std::iter::once(old).chain(new.map(|new| in_wires(new, Color::White))).collect();
        let mut scene = Scene { items, ..Scene::default() };
        (scene.settings.points, scene.settings.mesh, scene.settings.axes) = (POINTS, MESH, false);
        let mut shapes = Shapes::default();
        shapes.follow(&scene, bases);
        Preview { scene, shapes, eye }
    }

    /// Draws all of both into an area, if it is high enough.
    pub(super) fn draw(&self, screen: &mut Screen, area: Area) {
        if area.y2 - area.y1 < LEAST {
            return;
        }
        window(screen, area);
        let inside = Area::new(area.x1 + 1, area.y1 + 1, area.x2 - 1, area.y2 - 1);
        if let Some(bounds) = self.shapes.bounds(None) {
            let eye = self.eye.fitted_in(bounds, inside);
            paint(screen, inside, eye, &self.scene, &self.shapes, Show::default());
        }
    }
}

fn in_wires(mut item: Item, color: Color) -> Item {
    match &mut item {
        Item::Curve(curve) => {
            curve.style = Default::default();
            curve.style.colour = color as u8;
        }
        Item::Patch(patch) => {
            patch.style = Default::default();
            (patch.style.fill, patch.style.line_colour) = (Fill::Wires, color as u8);
        }
    }
    item
}
