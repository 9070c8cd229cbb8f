//! Inspection of surfaces: zebra stripes, which show breaks of continuity, Gaussian curvature, and sections by a
//! plane.

use super::Nets;
use super::plan::Family;
use super::surface::{Drawn, draw_cells, draw_gap, draw_wires};
use crate::editor::Editor;
use crate::geometry::{BoundingBox, Grid, ParamSurface, Plane, Point, section};
use crate::machine::{Key, Tick};
use crate::screen::{Color, Screen};
use crate::ui::look::Look;
use crate::ui::tint;
use crate::ui::{Desk, Stay, Words, words};

/// What colours show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Inspection {
    Off,
    /// Isophotes: bands of equal angle between the normal and the direction to the viewer.
    Zebra,
    /// Blue where the surface is a saddle, red where it is a dome, grey where it is flat.
    Curvature,
    /// The smaller of the radii of curvature: how far offsets go.
    Radius,
}

impl Inspection {
    /// The one after it; maps of radii are for surfaces with offsets.
    pub(crate) fn next(self, offsets: bool) -> Inspection {
        match self {
            Inspection::Off => Inspection::Zebra,
            Inspection::Zebra => Inspection::Curvature,
            Inspection::Curvature if offsets => Inspection::Radius,
            Inspection::Curvature | Inspection::Radius => Inspection::Off,
        }
    }

    /// What its colours show.
    pub(crate) fn name(self) -> Option<Words> {
        let [_, zebra, curvature] = words::INSPECTIONS;
        match self {
            Inspection::Off => None,
            Inspection::Zebra => Some(zebra),
            Inspection::Curvature => Some(curvature),
            Inspection::Radius => Some(RADIUS),
        }
    }
}

/// A plane perpendicular to an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Section {
    /// 0 is x, 1 is y, 2 is z.
    axis: usize,
    offset: f64,
}

const RADIUS: Words = Words("kisebbik görbületi sugár", "smaller radius of curvature");
/// Distance by which + and - move the plane, at the scale of 1.
const STEP: f64 = 10.0;
/// Coloured cells per cell of the net, in each direction.
const FINE: usize = 28;
/// The same where a patch has no cells of a net, as a Hermite patch.
const FINEST: usize = 84;
/// Largest number of coloured cells along one direction.
const MOST_CELLS: usize = 256;
impl Editor<Nets, 3> {
    /// Switches inspection, section, frame and weights, and moves the plane; returns whether the event was for that.
    pub(super) fn inspect(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        self.follow_weights(tick);
        let normals = self.craft.plan.family == Family::Normals;
        match tick.letter() {
            Some('K') => {
                let net_seen = self.craft.drawn.is_none() && !self.stage.is_result();
                self.craft.frame = self.craft.frame.next(net_seen || self.craft.weight.is_some());
                desk.tell(self.craft.frame.name(), Stay::Briefly);
                return true;
            }
            Some('W') if !normals => {
                self.switch_weights(desk, tick);
                return true;
            }
            _ => {}
        }
        match tick.key() {
            Some(Key::F(5)) => {
                // Stripes and weights are colours of the same surface.
                self.craft.weight = None;
                self.craft.inspection = self.craft.inspection.next(normals);
                if let Some(name) = self.craft.inspection.name() {
                    desk.tell(name, Stay::Briefly);
                }
            }
            Some(Key::F(6)) => self.craft.section = Section::next(self.craft.section, self.lens.look),
            Some(Key::Char(sign @ ('+' | '-'))) if self.craft.section.is_some() => {
                let moved = |section: Section| section.moved(sign == '+', self.lens.look);
                self.craft.section = self.craft.section.map(moved);
            }
            _ => return false,
        }
        true
    }
}

impl Section {
    /// The section after it: through the middle of the picture across x, y, z, or none.
    pub(crate) fn next(present: Option<Section>, look: Look) -> Option<Section> {
        let axis = match present {
            None => 0,
            Some(Section { axis: 2, .. }) => return None,
            Some(Section { axis, .. }) => axis + 1,
        };
        Some(Section { axis, offset: look.middle(axis) })
    }

    /// Moved by a step along its axis, up or down.
    pub(crate) fn moved(self, up: bool, look: Look) -> Section {
        let step = look.length(if up { STEP } else { -STEP });
        let step = if step.abs() >= 1.0 { step.round() } else { step };
        Section { offset: (self.offset + step).clamp(-1e6, 1e6), ..self }
    }

    /// What stands in the corner of the picture.
    pub(crate) fn name(self) -> String {
        let offset = (self.offset * 1e4).round() / 1e4;
        format!("{} = {offset}", ["x", "y", "z"][self.axis.min(2)])
    }

    /// The section of a surface by the plane.
    pub(crate) fn lines(self, drawn: &Drawn) -> Vec<Vec<Point<3>>> {
        let mut normal = [0.0; 3];
        normal[self.axis.min(2)] = 1.0;
        let plane = Plane { normal, offset: self.offset };
        let surfaces = drawn.parts.iter().filter_map(|part| part.surface.as_ref());
        surfaces.flat_map(|surface| section(&**surface, plane, drawn.steps).unwrap_or_default()).collect()
    }
}

impl Inspection {
    /// Draws a surface in colours; `false` if nothing is inspected.
    pub(crate) fn draw(self, screen: &mut Screen, drawn: &Drawn, look: Look, distance: f64) -> bool {
        let size = drawn.own().filter_map(|(surface, _)| surface.bounding_box());
        let Some(size) = size.reduce(BoundingBox::union).map(|bounds| bounds.extent()) else { return false };
        let reach = if distance == 0.0 { size / 8.0 } else { distance.abs() };
        let toward = look.view.toward();
        match self {
            Inspection::Off => false,
            Inspection::Zebra => draw_tinted(screen, drawn, look, |place| place.zebra(toward)),
            Inspection::Curvature => draw_tinted(screen, drawn, look, |place| place.curvature(size)),
            Inspection::Radius => {
                draw_tinted(screen, drawn, look, |place| tint::radius(place.radius(), reach))
            }
        }
    }
}

/// Draws a surface in small cells of a colour each; `false` if there is no surface.
pub(super) fn draw_tinted(
    screen: &mut Screen,
    drawn: &Drawn,
    look: Look,
    color: impl Fn(&Place<'_>) -> Color,
) -> bool {
    let [rows, columns] = drawn.spans;
    let alone = rows.max(columns) <= 2 && drawn.own().all(|(surface, _)| surface.steps(0, 0, 1) == 1);
    let most = if alone { FINEST } else { FINE };
    let steps = most.min(MOST_CELLS / rows.max(columns).max(1)).max(2);
    let fine: Vec<(&dyn ParamSurface, Grid)> =
        drawn.own().filter_map(|(surface, _)| Some((surface, surface.grid(steps).ok()?))).collect();
    if fine.is_empty() {
        return false;
    }
    let mut colors = fine.iter().flat_map(|(surface, grid)| {
        places(*surface, steps, [grid.rows(), grid.columns()]).map(|place| color(&place))
    });
    let grids: Vec<&Grid> = fine.iter().map(|(_, grid)| grid).collect();
    draw_cells(screen, &grids, look, |_, _| (colors.next().unwrap_or(tint::FLAT), None));
    drawn.gaps.iter().for_each(|gap| draw_gap(screen, gap, look));
    for part in &drawn.parts {
        if let Some(ink) = part.ink {
            draw_wires(screen, &part.grid, look, ink);
        }
    }
    true
}

/// The centre of a cell of a grid.
pub(super) struct Place<'s> {
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
    /// The value of something that is given by spans and parameters.
    pub(super) fn value(&self, of: impl Fn([usize; 2], [f64; 2]) -> Option<f64>) -> Option<f64> {
        of(self.spans, self.parameters)
    }

    fn zebra(&self, toward: Point<3>) -> Color {
        tint::zebra(self.surface.normal(self.spans, self.parameters), toward)
    }

    /// The smaller of the two radii of curvature.
    fn radius(&self) -> Option<f64> {
        let at = self.surface.at(self.spans, self.parameters)?;
        let (mean, gauss) = (at.mean_curvature()?, at.gaussian_curvature()?);
        Some(1.0 / (mean.abs() + (mean * mean - gauss).max(0.0).sqrt()))
    }

    fn curvature(&self, size: f64) -> Color {
        let curvature = self.surface.gaussian_curvature(self.spans, self.parameters);
        tint::curvature(curvature.map(|curvature| curvature * size * size))
    }
}
