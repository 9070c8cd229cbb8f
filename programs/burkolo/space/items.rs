//! What is seen in space: the surface, the spheres, and the circles where it touches them.

use super::craft::{Bench, Covered};
use crate::editor::net::surface::{draw_cells, draw_wires};
use crate::editor::seen::{Item, Own};
use crate::editor::stage::Stage;
use crate::figure::{Figure, Hidden, print_ink};
use crate::geometry::skin::TouchingCircle;
use crate::geometry::{BoundingBox, Closure, Grid, Point, cross, norm};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::look::{Look, pixel};
use std::f64::consts::TAU;

/// Steps of a quarter turn and of a span.
const STEPS: usize = 5;
/// Steps of a touching circle.
const ROUND: u8 = 72;

/// The surface.
struct Surface {
    grids: Vec<Grid>,
    look: Look,
    filled: bool,
    ink: Color,
}

impl Own<3> for Surface {
    fn paint(&self, screen: &mut Screen) {
        if self.filled {
            let grids: Vec<&Grid> = self.grids.iter().collect();
            draw_cells(screen, &grids, self.look, |_, _| (Color::Black, Some(self.ink)));
        } else {
            self.grids.iter().for_each(|grid| draw_wires(screen, grid, self.look, self.ink));
        }
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        let hidden = if self.filled { Hidden::LeftOut } else { Hidden::Drawn };
        figure.plot_surfaces(&self.grids, &self.look.view, hidden);
        true
    }

    fn bounds(&self) -> Option<BoundingBox<3>> {
        let boxes = self.grids.iter().filter_map(|grid| BoundingBox::of_points(grid.points()));
        boxes.reduce(BoundingBox::union)
    }
}

/// A sphere as its rim is seen, with its number.
struct Rim {
    at: Point<3>,
    radius: f64,
    number: usize,
    rule: Option<u8>,
    look: Look,
}

impl Own<3> for Rim {
    fn paint(&self, screen: &mut Screen) {
        let ((x, y), r) = (self.look.to_screen(self.at), pixel(self.radius * self.look.scale()));
        let ink = if self.rule.is_some() { Color::LightRed } else { Color::LightGray };
        screen.circle(x, y, r, Stroke::thin(ink));
        let text = self.number.to_string();
        let half = 4 * i32::try_from(text.len()).unwrap_or(0);
        screen.text(x - half + 1, y - 3, &text, Color::White);
        if let Some(rule) = self.rule {
            screen.text(x - 11, y + 7, &format!("({rule})"), Color::Yellow);
        }
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        figure.plot_point(self.look.view.place(self.at), Some(self.number.to_string()));
        true
    }

    fn bounds(&self) -> Option<BoundingBox<3>> {
        Some(BoundingBox::of_point(self.at))
    }
}

/// Where the surface touches a sphere.
struct Touched {
    points: Vec<Point<3>>,
    look: Look,
}

impl Touched {
    fn new(circle: &TouchingCircle, look: Look) -> Touched {
        // Any unit vector across the axis, and the one across both.
        let least = (0..3).min_by(|&a, &b| circle.axis[a].abs().total_cmp(&circle.axis[b].abs()));
        let mut edge = [0.0; 3];
        edge[least.unwrap_or(0)] = 1.0;
        let first = cross(circle.axis, edge);
        let first = first.map(|x| x / norm(first));
        let second = cross(circle.axis, first);
        let at = |k: u8| {
            let (sine, cosine) = (f64::from(k) / f64::from(ROUND) * TAU).sin_cos();
            std::array::from_fn(|d| circle.center[d] + circle.radius * (cosine * first[d] + sine * second[d]))
        };
        Touched { points: (0..=ROUND).map(at).collect(), look }
    }
}

impl Own<3> for Touched {
    fn paint(&self, screen: &mut Screen) {
        let pixels: Vec<(i32, i32)> = self.points.iter().map(|&point| self.look.to_screen(point)).collect();
        screen.polyline(&pixels, Stroke::thick(Color::LightGreen));
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        let line = self.points.iter().map(|&point| self.look.view.place(point)).collect();
        let style = crate::figure::Style::line(print_ink(Color::LightGreen), 1.5);
        figure.polyline(line, Closure::Open, style);
        true
    }

    fn bounds(&self) -> Option<BoundingBox<3>> {
        None
    }
}

/// The grids of the surface.
pub(super) fn grids(covered: &Covered) -> Vec<Grid> {
    covered.skin.parts().iter().filter_map(|part| part.grid(STEPS).ok()).collect()
}

/// The visible items, topmost last.
pub(super) fn items(editor: &Bench) -> Vec<Item<3>> {
    let (value, options, look) = (editor.preview(), editor.craft.options, editor.lens.look);
    let covered = editor.covered();
    let mut items: Vec<Item<3>> = Vec::new();
    if let Some(covered) = &covered {
        let sound = covered.violations.is_empty();
        let ink = match (sound, options.filled) {
            (false, _) => Color::DarkGray,
            (true, true) => Color::White,
            (true, false) => Color::Cyan,
        };
        let grids = grids(covered);
        if !grids.is_empty() {
            items.push(Item::Own(Box::new(Surface { grids, look, filled: options.filled, ink })));
        }
        if options.touching {
            let circles = covered.skin.circles();
            let touched =
                circles.iter().map(|circle| Item::Own(Box::new(Touched::new(circle, look)) as Box<_>));
            items.extend(touched);
        }
    }
    if editor.stage != (Stage::Result { points: false }) {
        let rule = |index: usize| {
            let violations = covered.as_ref().map_or(&[][..], |covered| &covered.violations[..]);
            violations.iter().find(|it| it.numbers().contains(&index)).map(|it| it.rule())
        };
        for (index, &[x, y, z, radius]) in value.spheres.iter().enumerate() {
            let rim = Rim { at: [x, y, z], radius, number: index + 1, rule: rule(index), look };
            items.push(Item::Own(Box::new(rim)));
        }
    }
    items
}
