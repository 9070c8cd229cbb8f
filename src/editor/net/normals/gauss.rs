//! The image of the normals: the net of patches on the unit sphere and in the plane of p and q. A patch is
//! regular where its image covers an area once.

use crate::design::NetDesign;
use crate::editor::seen::Own;
use crate::figure::Figure;
use crate::geometry::{BoundingBox, Jacobian, Point};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::Area;
use crate::ui::look::Look;

/// The centre and the radius of the sphere.
const CENTRE: (i32, i32) = (176, 262);
const RADIUS: f64 = 135.0;
/// The plane of p and q.
const PLANE: Area = Area::new(340, 110, 620, 420);
/// Lines of a patch along each direction, and steps of a line.
const LINES: usize = 4;
const STEPS: usize = 12;

/// The image in the picture.
pub(in crate::editor::net) struct Gauss {
    look: Look,
    lines: Vec<Line>,
}

/// A line of a patch.
struct Line {
    ink: Color,
    normals: Vec<Point<3>>,
    plane: Vec<Point<2>>,
}

impl Gauss {
    /// The image of the normals of a net; `None` where the normals fit into no chart.
    pub(in crate::editor::net) fn of(net: &NetDesign, look: Look) -> Option<Gauss> {
        let patches = net.patches_with_normals().ok()?;
        let [rows, columns] = patches.size();
        let mut lines = Vec::new();
        for [i, j] in (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j])) {
            let ink = match patches.jacobian(i, j)? {
                Jacobian::Changes => Color::LightRed,
                Jacobian::Positive => Color::White,
                Jacobian::Negative => Color::LightCyan,
            };
            let patch = patches.isotropic(i, j)?;
            for along in 0..2 {
                for line in 0..=LINES {
                    let at = |step: usize| {
                        let (s, t) = (line as f64 / LINES as f64, step as f64 / STEPS as f64);
                        if along == 0 { [t, s] } else { [s, t] }
                    };
                    let places = || (0..=STEPS).map(at);
                    lines.push(Line {
                        ink,
                        normals: places().filter_map(|uv| patches.gauss_normal([i, j], uv)).collect(),
                        plane: places()
                            .map(|[u, v]| {
                                let [p, q, _] = patch.eval(u, v);
                                [p, q]
                            })
                            .collect(),
                    });
                }
            }
        }
        // What turns back lies over the others.
        lines.sort_by_key(|line| line.ink == Color::LightRed);
        Some(Gauss { look, lines })
    }
}

impl Own<3> for Gauss {
    fn paint(&self, screen: &mut Screen) {
        screen.circle(CENTRE.0, CENTRE.1, RADIUS as i32, Stroke::thin(Color::LightGray));
        let place = |normal: Point<3>| {
            let [x, y] = self.look.view.place(normal);
            (
                CENTRE.0 + (RADIUS * x).round_ties_even() as i32,
                CENTRE.1 - (RADIUS * y).round_ties_even() as i32,
            )
        };
        for line in &self.lines {
            for pair in line.normals.windows(2) {
                let [from, to] = [pair[0], pair[1]];
                let behind = self.look.view.depth(from) < 0.0;
                let ink = if behind { Color::DarkGray } else { line.ink };
                let ((x1, y1), (x2, y2)) = (place(from), place(to));
                screen.line(x1, y1, x2, y2, Stroke::thin(ink));
            }
        }
        let points: Vec<Point<2>> = self.lines.iter().flat_map(|line| line.plane.iter().copied()).collect();
        let Some(bounds) = BoundingBox::of_points(&points) else { return };
        let (width, height) = (f64::from(PLANE.x2 - PLANE.x1), f64::from(PLANE.y2 - PLANE.y1));
        let extent = |d: usize| (bounds.max[d] - bounds.min[d]).max(1e-9);
        let scale = (width / extent(0)).min(height / extent(1));
        let at = |[p, q]: Point<2>| {
            let middle = |d: usize| 0.5 * (bounds.max[d] + bounds.min[d]);
            let x = 0.5 * f64::from(PLANE.x1 + PLANE.x2) + scale * (p - middle(0));
            let y = 0.5 * f64::from(PLANE.y1 + PLANE.y2) - scale * (q - middle(1));
            (x.round_ties_even() as i32, y.round_ties_even() as i32)
        };
        for line in &self.lines {
            let pixels: Vec<(i32, i32)> = line.plane.iter().map(|point| at(*point)).collect();
            screen.polyline(&pixels, Stroke::thin(line.ink));
        }
        screen.text(CENTRE.0 - 12, PLANE.y2 + 12, "S\u{b2}", Color::LightGray);
        screen.text((PLANE.x1 + PLANE.x2) / 2 - 20, PLANE.y2 + 12, "(p, q)", Color::LightGray);
    }

    /// Lines of one colour would not tell which patch turns back.
    fn plot(&self, _: &mut Figure) -> bool {
        false
    }

    fn bounds(&self) -> Option<BoundingBox<3>> {
        None
    }
}
