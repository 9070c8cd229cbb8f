//! The visible items of a surface and its net, and the values under the picture.

use super::frame::legs;
use super::inspect::{Inspection, Section};
use super::normals::{self, Gauss};
use super::plan::Family;
use super::surface::{Display, Drawn, Fill, draw_parts};
use super::tables::Action;
use super::{Handle, Nets};
use crate::design::{Index, NetDesign, Part};
use crate::editor::field::within;
use crate::editor::lens::Lens;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::{Item, Own};
use crate::editor::values::{BIAS, SURFACE_K0, TENSION};
use crate::editor::{Dial, Editor};
use crate::figure::{Axes, Figure, Hidden};
use crate::geometry::{BoundingBox, Grid, Point, View};
use crate::machine::{Language, Manner};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::Area;
use crate::ui::look::Look;
use crate::ui::words::{self, Words};
use std::rc::Rc;

/// Largest distance of a click from a control point, in pixels.
const REACH: i32 = 6;
/// Where the shape parameters stand, and how many letters of each are sure to be there.
const VALUES_Y: i32 = 470;
const VALUE_LETTERS: i32 = 13;
/// Length of the drawn tangents of a Hermite patch.
const TANGENT: f64 = 0.2;
/// Segments of its border curves.
const BORDER_STEPS: usize = 16;

/// A surface in the picture.
struct Surfaced {
    drawn: Rc<Drawn>,
    look: Look,
    display: Display,
    fill: Fill,
    ink: Color,
    inspection: Inspection,
    section: Option<Section>,
    /// The distance of the offset beside it.
    distance: f64,
}

impl Own<3> for Surfaced {
    fn paint(&self, screen: &mut Screen) {
        if !self.inspection.draw(screen, &self.drawn, self.look, self.distance) {
            draw_parts(screen, &self.drawn, self.look, (self.display, self.fill), self.ink);
        }
        let Some(section) = self.section else { return };
        screen.text(560, 66, &section.name(), Color::Yellow);
        for line in section.lines(&self.drawn) {
            let pixels: Vec<(i32, i32)> = line.into_iter().map(|point| self.look.to_screen(point)).collect();
            screen.polyline(&pixels, Stroke::thick(Color::Yellow));
        }
    }

    /// Lines cannot tell what colours tell.
    fn plot(&self, figure: &mut Figure) -> bool {
        let view = self.look.seen();
        let grids: Vec<Grid> = self.drawn.parts.iter().map(|part| part.grid.clone()).collect();
        figure.plot_surfaces(&grids, &view, hidden(self.display));
        for line in self.section.into_iter().flat_map(|section| section.lines(&self.drawn)) {
            figure.plot_section(line.into_iter().map(|point| view.place(point)).collect());
        }
        self.inspection == Inspection::Off
    }

    fn bounds(&self) -> Option<BoundingBox<3>> {
        self.drawn.bounds()
    }
}

impl Editor<Nets, 3> {
    /// The surface, or the net with the surface that follows it.
    pub(super) fn items(&self) -> Vec<Item<3>> {
        if self.craft.beside.gauss
            && let Some(gauss) = Gauss::of(&self.preview(), self.lens.look)
        {
            return vec![Item::Own(Box::new(gauss))];
        }
        if self.stage.begun()
            && let Some(items) = self.weight_items()
        {
            return items;
        }
        // While a potentiometer is turned, the surface follows it.
        let turned = self.turning.held.is_some() && self.craft.drawn.is_some();
        let turned = turned.then(|| self.craft.draw_up(&self.preview()).ok()).flatten().map(Rc::new);
        if let Some(drawn) = turned.as_ref().or(self.craft.drawn.as_ref()) {
            let mut items = vec![self.surface(Rc::clone(drawn), Color::White)];
            items.extend(self.craft.frame.items(self.history.now()));
            return items;
        }
        let mut items = Vec::new();
        if !self.stage.begun() {
            return items;
        }
        let net = self.preview();
        let follows = self.shown.follow || self.held.is_some();
        if let Some(drawn) = follows.then(|| self.craft.draw_up(&net).ok()).flatten() {
            let plain = self.craft.inspection == Inspection::Off && self.craft.plan.family != Family::Normals;
            let ink = if plain { Color::Cyan } else { Color::White };
            items.push(self.surface(Rc::new(drawn), ink));
        }
        items.extend(
            self.strokes(&net).into_iter().map(|(from, to, ink)| Item::Line { ends: [from, to], ink }),
        );
        items.extend(self.craft.frame.items(&net));
        let knot = |index: Index| {
            // Every copy of a pole is the chosen one.
            let chosen = self.picked().and_then(|picked| net.point(picked));
            let fill =
                if chosen.is_some() && chosen == net.point(index) { Color::LightRed } else { Color::Black };
            net.point(index).map(|at| Item::Knot { at, fill })
        };
        items.extend(net.indices().filter_map(knot));
        if self.craft.plan.family == Family::Normals {
            for index in net.indices() {
                let Some((point, tip)) = net.point(index).zip(normals::tip(&net, index)) else { continue };
                items.push(Item::Line { ends: [point, tip], ink: Color::LightGreen });
                let held = self.held.is_some_and(|held| held.handle == Handle::Normal(index));
                let fill = if held { Color::LightRed } else { Color::Green };
                items.push(Item::Knot { at: tip, fill });
            }
        }
        items
    }

    fn surface(&self, drawn: Rc<Drawn>, ink: Color) -> Item<3> {
        let Nets { inspection, section, .. } = self.craft;
        let (look, display, fill) = (self.lens.look, self.craft.display_now(), self.craft.fill());
        let distance = self.history.now().distance();
        Item::Own(Box::new(Surfaced { drawn, look, display, fill, ink, inspection, section, distance }))
    }

    /// Map, values and legends.
    pub(super) fn draw_own(&self, layer: Layer, page: &mut Page<'_>) {
        match layer {
            Layer::Frame => self.map().draw(page.screen, self.picked()),
            Layer::Titles => match self.line(page.language) {
                Some(line) => {
                    page.screen.bar(0, 467, 639, 479, Color::LightCyan);
                    page.screen.text(130, 470, &line, Color::Black);
                }
                None if self.craft.plan.family == Family::Normals => {
                    self.draw_radii(page.screen, page.language);
                }
                None => {
                    self.draw_values(page.screen, page.language);
                    self.draw_joint(page.screen, (2, VALUES_Y), page.language);
                }
            },
            Layer::Over
                if self.craft.plan.family == Family::Normals
                    && self.stage.begun()
                    && !self.stage.is_result() =>
            {
                self.draw_corner(page.screen, page.language);
            }
            Layer::Legend if self.craft.plan.family != Family::Heights => {
                self.craft.display.draw_legend(page.screen, page.language);
            }
            _ => {}
        }
    }

    /// Coloured lines between control points; white ones are borders of the surface.
    pub(super) fn strokes(&self, net: &NetDesign) -> Vec<(Point<3>, Point<3>, Color)> {
        let inked = |lines: Vec<Line>, ink: Color| lines.into_iter().map(move |(from, to)| (from, to, ink));
        match self.craft.plan.family {
            Family::Heights => inked(ground_lines(net), Color::DarkGray).collect(),
            Family::Hermite if net.joint().is_some() => {
                let legs = net
                    .polygons()
                    .into_iter()
                    .flat_map(|(line, _)| legs(&line, false))
                    .map(|[from, to]| (from, to))
                    .collect();
                let borders = inked(border_lines(net), Color::White);
                borders.chain(inked(legs, Color::LightGray)).collect()
            }
            Family::Hermite => {
                let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|corner| net.point(corner));
                let sides = corners.iter().zip(corners.iter().cycle().skip(1));
                let sides = sides.filter_map(|(from, to)| from.zip(*to)).collect();
                let borders = inked(border_lines(net), Color::White);
                borders.chain(inked(sides, Color::LightGray)).collect()
            }
            _ => {
                let closed = net.net.kind.topology().closed();
                inked(net_lines(net, closed), Color::LightGray).collect()
            }
        }
    }

    fn picked(&self) -> Option<Index> {
        let held = self.held.map(|held| held.handle);
        let by_tab = self.picked.filter(|_| self.craft.chosen.is_none());
        held.or(by_tab).map(Handle::index).or(self.craft.chosen.map(|(index, _)| index))
    }

    /// The line under the picture: the point being dragged or changed.
    fn line(&self, language: Language) -> Option<String> {
        let (index, part) = match self.held {
            Some(held) => (held.handle.index(), Part::Place),
            None => {
                let place = |index| (index, Part::Place);
                let by_tab = self.picked.map(|handle| place(handle.index()));
                let under = || self.point_at(self.mouse).filter(|_| self.manner == Manner::Today).map(place);
                self.craft.chosen.or(by_tab).or_else(under)?
            }
        };
        if self.held.is_some_and(|held| matches!(held.handle, Handle::Normal(_))) {
            let normal = self.preview().normal(index)?.map(|x| format!("{x:.3}")).join(", ");
            return Some(format!("n[{}, {}] = ({normal})", index[0], index[1]));
        }
        let value = self.preview().part(index, part)?;
        let phrase = match self.craft.plan.family {
            Family::Heights => words::height_of(index, value[2]),
            _ => words::part_of(index, part.title(), value),
        };
        Some(phrase.of(language).to_string())
    }

    /// The shape parameters under the picture: where they begin, their names and values, and what changes them.
    fn values(&self) -> Vec<(i32, Words, String, Action)> {
        self.values_of(&self.preview())
    }

    /// The same of a net.
    fn values_of(&self, net: &NetDesign) -> Vec<(i32, Words, String, Action)> {
        let (bias, tension, k0) = (net.bias(), net.tension(), net.k0());
        let two = |value: f64| format!("{value:.2}");
        let value = |x, name, direction: usize, value: String, action: fn(Option<usize>) -> Action| {
            let letter = if direction == 0 { "u" } else { "v" };
            (x, name, format!("_{letter} = {value}"), action(Some(direction)))
        };
        match self.craft.plan.family {
            Family::Beta => vec![
                value(2, words::BIAS_NAME, 0, two(bias[0]), Action::Bias),
                value(145, words::BIAS_NAME, 1, two(bias[1]), Action::Bias),
                value(292, words::TENSION_NAME, 0, short(tension[0]), Action::Tension),
                value(471, words::TENSION_NAME, 1, short(tension[1]), Action::Tension),
            ],
            Family::Local => vec![
                value(120, words::K0_NAME, 0, two(k0[0]), Action::K0),
                value(340, words::K0_NAME, 1, two(k0[1]), Action::K0),
            ],
            _ => Vec::new(),
        }
    }

    fn draw_values(&self, screen: &mut Screen, language: Language) {
        for (x, name, value, _) in self.values() {
            screen.text(x, VALUES_Y, &format!("{}{value}", name.of(language)), Color::Black);
        }
        self.value_dials().iter().for_each(|dial| dial.draw(screen));
    }

    /// The shape parameters with their tracks over them.
    pub(super) fn value_dials(&self) -> Vec<Dial> {
        if self.manner != Manner::Today || !self.stage.begun() || self.stage.is_result() {
            return Vec::new();
        }
        let net = self.preview();
        let dial = |(x, _, _, action): &(i32, Words, String, Action)| {
            let of = |values: [f64; 2], direction: usize| values.get(direction).copied().unwrap_or_default();
            let (value, values) = match action {
                Action::Bias(Some(direction)) => (of(net.bias(), *direction), BIAS),
                Action::Tension(Some(direction)) => (of(net.tension(), *direction), TENSION),
                Action::K0(Some(direction)) => (of(net.k0(), *direction), SURFACE_K0),
                _ => return None,
            };
            Some(Dial::new((*x, VALUES_Y), VALUE_LETTERS, -2, value, values))
        };
        self.values().iter().filter_map(dial).collect()
    }

    /// The net with the value of a potentiometer changed.
    pub(super) fn with_dial(&self, dial: usize, to: f64) -> NetDesign {
        let now = self.history.now();
        // Of the net as it is: the preview asks here.
        let Some((.., action)) = self.values_of(now).into_iter().nth(dial) else { return now.clone() };
        let set = |mut values: [f64; 2], direction: usize| {
            if let Some(value) = values.get_mut(direction) {
                *value = to;
            }
            Some(values)
        };
        let (bias, tension, k0) = (now.bias(), now.tension(), now.k0());
        now.with_settings(|settings| match action {
            Action::Bias(Some(direction)) => settings.bias = set(bias, direction),
            Action::Tension(Some(direction)) => settings.tension = set(tension, direction),
            Action::K0(Some(direction)) => settings.k0 = set(k0, direction),
            _ => {}
        })
    }

    /// What changes the parameter that is shown at a pixel.
    pub(super) fn value_shown_at(&self, (x, y): (i32, i32)) -> Option<Action> {
        let hit = |left: i32| Area::of_line((left, VALUES_Y), VALUE_LETTERS).holds(x, y);
        self.values().into_iter().find(|(left, ..)| hit(*left)).map(|(.., action)| action)
    }

    /// The control point at a pixel, the one nearest to the viewer; `None` while the surface replaces the net.
    pub(super) fn point_at(&self, at: (i32, i32)) -> Option<Index> {
        self.nearest_at(at, NetDesign::point)
    }

    /// The normal whose tip is at a pixel.
    pub(super) fn tip_at(&self, at: (i32, i32)) -> Option<Index> {
        self.nearest_at(at, normals::tip)
    }

    fn nearest_at(
        &self,
        (x, y): (i32, i32),
        of: impl Fn(&NetDesign, Index) -> Option<Point<3>>,
    ) -> Option<Index> {
        let hidden = self.craft.drawn.is_some() && self.craft.weight.is_none();
        if hidden || self.craft.beside.gauss {
            return None;
        }
        self.nearest_of(self.history.now(), (x, y), of)
    }

    /// The point of a net at a pixel, the one nearest to the viewer.
    pub(super) fn nearest_of(
        &self,
        net: &NetDesign,
        at: (i32, i32),
        of: impl Fn(&NetDesign, Index) -> Option<Point<3>>,
    ) -> Option<Index> {
        let under = net.indices().filter_map(|index| {
            let point = of(net, index)?;
            within(REACH, self.lens.pixel(point), at).then(|| (index, self.lens.look.seen().depth(point)))
        });
        under.max_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(index, _)| index)
    }
}

/// The four border curves of a Hermite patch and the cross-boundary tangents (chapter 3.3); of two patches those of both.
fn border_lines(net: &NetDesign) -> Vec<Line> {
    let Ok(surface) = net.surface() else { return Vec::new() };
    let mut lines = Vec::new();
    let sides = [(0.0, false), (1.0, false), (0.0, true), (1.0, true)];
    for (span, (side, along_u)) in (0..surface.spans()[0]).flat_map(|span| sides.map(|side| (span, side))) {
        let mut before = None;
        for step in 0..=BORDER_STEPS {
            let t = step as f64 / BORDER_STEPS as f64;
            let (u, v) = if along_u { (t, side) } else { (side, t) };
            let Some(at) = surface.at([span, 0], [u, v]) else { continue };
            let across = if along_u { at.v } else { at.u };
            let tip = std::array::from_fn(|d| at.point[d] + TANGENT * across[d]);
            lines.push((at.point, tip));
            lines.extend(before.map(|before| (before, at.point)));
            before = Some(at.point);
        }
    }
    lines
}

/// A tension with one decimal, or in scientific notation if that does not fit.
fn short(value: f64) -> String {
    if value.abs() < 1e4 { format!("{value:.1}") } else { format!("{value:e}") }
}

type Line = (Point<3>, Point<3>);

/// The lines between neighbouring points of a net.
fn net_lines(net: &NetDesign, closed: [bool; 2]) -> Vec<Line> {
    let [rows, columns] = net.shape();
    let mut lines = Vec::new();
    for [k, l] in (0..columns).flat_map(|l| (0..rows).map(move |k| [k, l])) {
        let next = |index: usize, count: usize, closed: bool| match index + 1 {
            next if next < count => Some(next),
            _ if closed && count > 2 => Some(0),
            _ => None,
        };
        let along_u = next(k, rows, closed[0]).map(|k| [k, l]);
        let along_v = next(l, columns, closed[1]).map(|l| [k, l]);
        for other in [along_u, along_v].into_iter().flatten() {
            lines.extend(net.point([k, l]).zip(net.point(other)));
        }
    }
    lines
}

/// The grid on the ground under a height field, and the perpendiculars to it.
fn ground_lines(net: &NetDesign) -> Vec<Line> {
    let [rows, columns] = net.shape();
    let foot = |index: Index| net.point(index).map(|[x, y, _]| [x, y, 0.0]);
    let (k, l) = (rows.saturating_sub(1), columns.saturating_sub(1));
    let along = (0..columns).filter_map(|l| foot([0, l]).zip(foot([k, l])));
    let across = (0..rows).filter_map(|k| foot([k, 0]).zip(foot([k, l])));
    let all = (0..rows).flat_map(|k| (0..columns).map(move |l| [k, l]));
    let drops = all.filter_map(|index| foot(index).zip(net.point(index)));
    along.chain(across).chain(drops).collect()
}

/// The figure of a surface given by its points.
pub(super) fn of_grid(grid: &Grid, view: View, display: Display) -> Option<Figure> {
    let mut figure = Figure::new();
    figure.plot_surface(grid, &view, hidden(display));
    let bounds = BoundingBox::of_points(grid.points())?;
    figure.set_axes(Axes::Space { view, bounds });
    Some(figure)
}

/// Filled cells hide what is behind them; wires do not.
fn hidden(display: Display) -> Hidden {
    match display {
        Display::Wire => Hidden::Drawn,
        Display::Filled => Hidden::LeftOut,
    }
}
