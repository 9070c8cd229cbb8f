//! Inspection of surfaces: zebra stripes, which show breaks of continuity, Gaussian curvature, and sections by a
//! plane.

use super::Nets;
use super::plan::Family;
use super::surface::{Drawn, draw_cells, draw_gap, draw_wires};
use crate::editor::Editor;
use crate::geometry::{Plane, Point, section};
use crate::machine::{Key, Tick};
use crate::screen::{Color, Screen};
use crate::ui::look::Look;
use crate::ui::tint::{self, Zebra};
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
    /// Draws a surface in colours; `false` if nothing is inspected, or there is no surface.
    pub(crate) fn draw(self, screen: &mut Screen, drawn: &Drawn, look: Look, distance: f64) -> bool {
        let fine = drawn.fine();
        let colors: Vec<Color> = match self {
            Inspection::Off => return false,
            Inspection::Zebra => {
                let (stripes, toward) = (Zebra::new(), look.view.toward());
                fine.normals(drawn).iter().map(|normal| stripes.color(*normal, toward)).collect()
            }
            Inspection::Curvature => {
                let Some(size) = fine.size(drawn) else { return false };
                let relative = |curvature: f64| curvature * size * size;
                fine.curvatures(drawn).iter().map(|it| tint::curvature(it.map(relative))).collect()
            }
            Inspection::Radius => {
                let Some(size) = fine.size(drawn) else { return false };
                let reach = if distance == 0.0 { size / 8.0 } else { distance.abs() };
                fine.radii(drawn).iter().map(|radius| tint::radius(*radius, reach)).collect()
            }
        };
        draw_tinted(screen, drawn, look, &colors)
    }
}

/// Draws a surface in small cells of these colours; `false` if there is no surface.
pub(super) fn draw_tinted(screen: &mut Screen, drawn: &Drawn, look: Look, colors: &[Color]) -> bool {
    let fine = drawn.fine();
    if colors.is_empty() {
        return false;
    }
    draw_cells(screen, &fine.grids(), look, |place, _| {
        (colors.get(fine.number(place)).copied().unwrap_or(tint::FLAT), None)
    });
    drawn.gaps.iter().for_each(|gap| draw_gap(screen, gap, look));
    for part in &drawn.parts {
        if let Some(ink) = part.ink {
            draw_wires(screen, &part.grid, look, ink);
        }
    }
    true
}
