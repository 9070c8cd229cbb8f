//! Inspection of surfaces: zebra stripes, which show breaks of continuity, Gaussian curvature, and sections by a
//! plane.

use super::Nets;
use super::surface::{Drawn, draw_cells};
use crate::editor::Editor;
use crate::geometry::{ParamSurface, Plane, Point, section};
use crate::machine::{Key, Tick};
use crate::screen::{Color, Screen};
use crate::ui::look::Look;
use crate::ui::tint;
use crate::ui::{Desk, Stay, words};

/// What colours show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inspection {
    Off,
    /// Isophotes: bands of equal angle between the normal and the direction to the viewer.
    Zebra,
    /// Blue where the surface is a saddle, red where it is a dome, grey where it is flat.
    Curvature,
}

impl Inspection {
    fn next(self) -> Inspection {
        match self {
            Inspection::Off => Inspection::Zebra,
            Inspection::Zebra => Inspection::Curvature,
            Inspection::Curvature => Inspection::Off,
        }
    }
}

/// A plane perpendicular to an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Section {
    /// 0 is x, 1 is y, 2 is z.
    axis: usize,
    offset: f64,
}

/// Distance by which + and - move the plane.
const STEP: f64 = 10.0;
/// Coloured cells per cell of the net, in each direction.
const FINE: usize = 28;
/// Largest number of coloured cells along one direction.
const MOST_CELLS: usize = 256;
impl Editor<Nets, 3> {
    /// Switches inspection and section, and moves the plane; returns whether the event was for that.
    pub(super) fn inspect(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        match tick.key() {
            Some(Key::F(5)) => {
                self.craft.inspection = self.craft.inspection.next();
                let [_, zebra, curvature] = words::INSPECTIONS;
                match self.craft.inspection {
                    Inspection::Off => {}
                    Inspection::Zebra => desk.tell(zebra, Stay::Briefly),
                    Inspection::Curvature => desk.tell(curvature, Stay::Briefly),
                }
            }
            Some(Key::F(6)) => {
                self.craft.section = match self.craft.section {
                    None => Some(Section { axis: 0, offset: 0.0 }),
                    Some(Section { axis: 2, .. }) => None,
                    Some(Section { axis, .. }) => Some(Section { axis: axis + 1, offset: 0.0 }),
                };
            }
            Some(Key::Char(sign @ ('+' | '-'))) if self.craft.section.is_some() => {
                let step = if sign == '+' { STEP } else { -STEP };
                self.craft.section = self
                    .craft
                    .section
                    .map(|section| Section { offset: (section.offset + step).clamp(-1e6, 1e6), ..section });
            }
            _ => return false,
        }
        true
    }
}

impl Section {
    /// What stands in the corner of the picture.
    pub(super) fn name(self) -> String {
        format!("{} = {}", ["x", "y", "z"][self.axis.min(2)], self.offset)
    }

    /// The section of a surface by the plane.
    pub(super) fn lines(self, drawn: &Drawn) -> Vec<Vec<Point<3>>> {
        let mut normal = [0.0; 3];
        normal[self.axis.min(2)] = 1.0;
        section(&*drawn.surface, Plane { normal, offset: self.offset }, drawn.steps).unwrap_or_default()
    }
}

impl Inspection {
    /// Draws a surface in colours; `false` if nothing is inspected.
    pub(super) fn draw(self, screen: &mut Screen, drawn: &Drawn, look: Look) -> bool {
        let surface = &*drawn.surface;
        let [rows, columns] = surface.spans();
        let steps = FINE.min(MOST_CELLS / rows.max(columns).max(1)).max(2);
        let Ok(grid) = surface.grid(steps) else { return false };
        let size = surface.bounding_box().map_or(1.0, |bounds| bounds.extent());
        let toward = look.view.toward();
        let color: Box<dyn Fn(&Place<'_>) -> Color> = match self {
            Inspection::Off => return false,
            Inspection::Zebra => Box::new(move |place| place.zebra(toward)),
            Inspection::Curvature => Box::new(move |place| place.curvature(size)),
        };
        let mut colors = places(surface, steps, [grid.rows(), grid.columns()]).map(|place| color(&place));
        draw_cells(screen, &grid, look, |_| (colors.next().unwrap_or(tint::FLAT), None));
        true
    }
}

/// The centre of a cell of a grid.
struct Place<'s> {
    surface: &'s dyn ParamSurface,
    spans: [usize; 2],
    parameters: [f64; 2],
}

/// The centres of all cells of a surface's grid, in the order of its cells.
fn places(
    surface: &dyn ParamSurface,
    steps: usize,
    [rows, columns]: [usize; 2],
) -> impl Iterator<Item = Place<'_>> {
    let [u, v] = [surface.line_places(0, steps), surface.line_places(1, steps)];
    (1..rows).flat_map(move |k| {
        let (u, v) = (u.clone(), v.clone());
        (1..columns).filter_map(move |l| {
            let ((i, u), (j, v)) = (*u.get(k - 1)?, *v.get(l - 1)?);
            Some(Place { surface, spans: [i, j], parameters: [u, v] })
        })
    })
}

impl Place<'_> {
    fn zebra(&self, toward: Point<3>) -> Color {
        tint::zebra(self.surface.normal(self.spans, self.parameters), toward)
    }

    fn curvature(&self, size: f64) -> Color {
        let curvature = self.surface.gaussian_curvature(self.spans, self.parameters);
        tint::curvature(curvature.map(|curvature| curvature * size * size))
    }
}
