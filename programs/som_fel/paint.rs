//! The picture of cloud, net and surface, on the screen and as a figure.

use super::gauges;
use super::run::{PARTS, Run, Slow};
use super::trainer::{Shown, Trainer};
use crate::editor::net::{Display, Drawn, Fill, Inspection, draw_parts};
use crate::figure::{Axes, CURVE_INK, Figure, Hidden};
use crate::geometry::fit::{ErrorClass, Fitted};
use crate::geometry::kohonen::Net;
use crate::geometry::{BoundingBox, Closure, Grid, ParamCurve, Point};
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::axes::{draw_axes, draw_legend};
use crate::ui::look::Look;
use crate::ui::{Area, sunken, words};

/// The picture, its frame, and how far its middle is from that of the whole screen.
pub(super) const PICTURE: Area = Area::new(29, 58, 549, 434);
const FRAME: Area = Area::new(25, 54, 553, 438);
const SHIFT: (i32, i32) = (-42, -14);
/// The most points that are drawn on the screen and in a figure; of more, every n-th is.
const MOST_POINTS: usize = 20_000;
const MOST_PLOTTED: usize = 2_000;
/// Segments of a span of a curve.
const CURVE_STEPS: usize = 8;
/// Where the plane of a section is named.
const SECTION: (i32, i32) = (440, 66);
/// Colours of errors by their level, above the surface and below it.
pub(super) const ABOVE: [Color; ErrorClass::LEVELS] =
    [Color::Green, Color::LightGreen, Color::Yellow, Color::LightRed, Color::Red];
pub(super) const BELOW: [Color; ErrorClass::LEVELS] =
    [Color::Cyan, Color::LightCyan, Color::LightBlue, Color::Blue, Color::Magenta];

/// The colour of an error class.
fn ink(class: ErrorClass) -> Color {
    let inks = if class.below { BELOW } else { ABOVE };
    inks.get(class.level).copied().unwrap_or(Color::White)
}

impl Trainer {
    /// The look in the present picture.
    fn eye(&self) -> Look {
        self.viewer.look.shifted(if self.options.alone { (0, 0) } else { SHIFT })
    }

    /// Whether a pixel is in the picture.
    pub(super) fn on_picture(&self, (x, y): (i32, i32)) -> bool {
        self.options.alone || PICTURE.holds(x, y)
    }

    /// Whether points are drawn in the colours of their errors.
    pub(super) fn shows_errors(&self) -> bool {
        self.options.errors
            && self.options.shown != Shown::Net
            && self.surface().is_some_and(|surface| surface.fit.is_some())
    }
}

/// The black background of the picture.
pub(super) fn ground(screen: &mut Screen) {
    screen.bar(PICTURE.x1, PICTURE.y1, PICTURE.x2, PICTURE.y2, Color::Black);
}

/// Everything around the picture, drawn over what leaves it.
pub(super) fn surroundings(screen: &mut Screen) {
    let Area { x1, y1, x2, y2 } = FRAME;
    for [x1, y1, x2, y2] in [[0, 0, 639, y1], [0, y2, 639, 479], [0, y1, x1, y2], [x2, y1, 639, y2]] {
        screen.bar(x1, y1, x2, y2, Color::LightCyan);
    }
    sunken(screen, FRAME, 4);
}

/// What stands over the picture alone.
pub(super) fn draw_alone(trainer: &Trainer, screen: &mut Screen, language: Language) {
    draw_legend(screen, words::LEAVE, language);
    if trainer.drawn().is_some() {
        trainer.options.display.draw_legend(screen, language);
    }
    gauges::draw_errors(trainer, screen, Color::LightGray);
}

/// Paints what is shown.
pub(super) fn paint(trainer: &Trainer, screen: &mut Screen, _: Language) {
    let look = trainer.eye();
    draw_axes(screen, look);
    let options = trainer.options;
    let errors = trainer.shows_errors();
    // Wires leave the points behind them visible; a filled surface would hide them all.
    let behind = options.display == Display::Wire && options.inspection == Inspection::Off && !errors;
    if behind {
        paint_points(trainer, screen, look);
    }
    paint_surface(trainer, screen, look);
    if !behind {
        paint_points(trainer, screen, look);
    }
    let Some(net) = trainer.net().filter(|_| options.shown != Shown::Points) else { return };
    match &trainer.run {
        Run::Slow(slow) => paint_step(trainer, slow, screen, look),
        Run::Learning(learning) => {
            paint_net(net, screen, look);
            if let Some(step) = learning.last() {
                let (x, y) = look.to_screen(net.point(step.winner));
                screen.disc(x, y, 4, Color::LightRed, Color::White);
            }
        }
        _ => paint_net(net, screen, look),
    }
}

fn paint_points(trainer: &Trainer, screen: &mut Screen, look: Look) {
    if trainer.options.shown == Shown::Net {
        return;
    }
    let Some(cloud) = trainer.state().cloud() else { return };
    let points = cloud.points();
    let fit = trainer.surface().and_then(|surface| surface.fit.as_ref()).filter(|_| trainer.shows_errors());
    for (index, point) in points.iter().enumerate().step_by(points.len().div_ceil(MOST_POINTS).max(1)) {
        let (x, y) = look.to_screen(*point);
        match fit.and_then(|fit| Some((fit.distances.get(index)?, fit.report.rms))) {
            Some((distance, rms)) => {
                let ink = ink(ErrorClass::of(*distance, rms));
                // Two pixels, so that the colours can be told.
                screen.set(x, y, ink);
                screen.set(x + 1, y, ink);
            }
            None => screen.set(x, y, Color::LightGray),
        }
    }
}

fn paint_net(net: &Net, screen: &mut Screen, look: Look) {
    for line in net.lines() {
        let mut pixels: Vec<(i32, i32)> = line.into_iter().map(|point| look.to_screen(point)).collect();
        pixels.dedup();
        screen.polyline(&pixels, Stroke::thin(Color::White));
    }
}

fn paint_surface(trainer: &Trainer, screen: &mut Screen, look: Look) {
    let Some(surface) = trainer.surface() else { return };
    if let Fitted::Curve(curve) = &surface.fitted {
        let line = curve.polyline(CURVE_STEPS).unwrap_or_default();
        let mut pixels: Vec<(i32, i32)> = line.into_iter().map(|point| look.to_screen(point)).collect();
        pixels.dedup();
        screen.polyline(&pixels, Stroke::thick(Color::Cyan));
        return;
    }
    let Some(drawn) = trainer.drawn() else { return };
    let options = trainer.options;
    // Not in a colour of errors.
    let ink = if trainer.shows_errors() { Color::DarkGray } else { Color::Cyan };
    if !options.inspection.draw(screen, drawn, look, 0.0) {
        draw_parts(screen, drawn, look, (options.display, Fill::Plain), ink);
    }
    for line in section_lines(trainer, drawn) {
        let pixels: Vec<(i32, i32)> = line.into_iter().map(|point| look.to_screen(point)).collect();
        screen.polyline(&pixels, Stroke::thick(Color::Yellow));
    }
    if let Some(section) = options.section {
        screen.text(SECTION.0, SECTION.1, &section.name(), Color::Yellow);
    }
}

fn section_lines(trainer: &Trainer, drawn: &Drawn) -> Vec<Vec<Point<3>>> {
    trainer.options.section.map(|section| section.lines(drawn)).unwrap_or_default()
}

/// A slow step: the point, the winner, its neighbours, the movement.
fn paint_step(trainer: &Trainer, slow: &Slow, screen: &mut Screen, look: Look) {
    let Some(step) = slow.learning.last() else { return };
    let part = slow.part(trainer.now);
    let moved = (part - (PARTS - 1.0)).clamp(0.0, 1.0);
    let influence = slow.learning.influence();
    let after = slow.learning.net();
    let [rows, columns] = after.size();
    let between = |index: [usize; 2]| -> Point<3> {
        let (from, to) = (slow.before.point(index), after.point(index));
        std::array::from_fn(|d| from[d] + moved * (to[d] - from[d]))
    };
    let places: Vec<Vec<Point<3>>> =
        (0..rows).map(|i| (0..columns).map(|j| between([i, j])).collect()).collect();
    if let Ok(net) = Net::new(after.topology(), &places) {
        paint_net(&net, screen, look);
    }
    let most = influence.iter().copied().fold(0.0, f64::max);
    if part >= 2.0 && most > 0.0 {
        for (index, share) in influence.iter().enumerate() {
            let index = [index / columns.max(1), index % columns.max(1)];
            let ink = match share / most {
                share if share > 0.5 => Color::LightRed,
                share if share > 0.1 => Color::Yellow,
                share if share > 0.01 => Color::Brown,
                _ => continue,
            };
            let (x, y) = look.to_screen(between(index));
            if part >= PARTS - 1.0 {
                let (from_x, from_y) = look.to_screen(slow.before.point(index));
                screen.line(from_x, from_y, x, y, Stroke::thin(ink));
            }
            screen.disc(x, y, 2, ink, ink);
        }
    }
    if part >= 1.0 {
        let (x, y) = look.to_screen(between(step.winner));
        screen.disc(x, y, 4, Color::LightRed, Color::White);
    }
    let (x, y) = look.to_screen(step.point);
    screen.disc(x, y, 4, Color::Yellow, Color::White);
}

/// What is shown in lines; `None` where colours tell something, or without anything.
pub(super) fn figure(trainer: &Trainer) -> Option<Figure> {
    let options = trainer.options;
    let coloured = trainer.drawn().is_some() && options.inspection != Inspection::Off;
    if coloured || trainer.shows_errors() {
        return None;
    }
    let view = trainer.viewer.look.view;
    let mut figure = Figure::new();
    let mut around: Option<BoundingBox<3>> = None;
    let mut add = |bounds: Option<BoundingBox<3>>| {
        around = around.into_iter().chain(bounds).reduce(BoundingBox::union);
    };
    match trainer.surface().map(|surface| &surface.fitted) {
        Some(Fitted::Curve(curve)) => {
            // A curve that arcs cannot follow is left out, as on the screen.
            let _ = figure.plot_space_curve(curve, &view, CURVE_INK);
            add(curve.bounding_box());
        }
        Some(Fitted::Surface(_)) => {
            if let Some(drawn) = trainer.drawn() {
                let hidden = match options.display {
                    Display::Wire => Hidden::Drawn,
                    Display::Filled => Hidden::LeftOut,
                };
                let grids: Vec<Grid> = drawn.parts.iter().map(|part| part.grid.clone()).collect();
                figure.plot_surfaces(&grids, &view, hidden);
                for line in section_lines(trainer, drawn) {
                    figure.plot_section(line.into_iter().map(|point| view.place(point)).collect());
                }
                add(drawn.bounds());
            }
        }
        None => {}
    }
    if let Some(net) = trainer.net().filter(|_| options.shown != Shown::Points) {
        for line in net.lines() {
            figure.plot_polygon(line.into_iter().map(|point| view.place(point)).collect(), Closure::Open);
        }
        add(BoundingBox::around(net.rows().into_iter().flatten()));
    }
    if let Some(cloud) = trainer.state().cloud().filter(|_| options.shown != Shown::Net) {
        let every = cloud.points().len().div_ceil(MOST_PLOTTED).max(1);
        for point in cloud.points().iter().step_by(every) {
            figure.plot_point(view.place(*point), None);
        }
        add(Some(cloud.bounds()));
    }
    if let Some(bounds) = around {
        figure.set_axes(Axes::Space { view, bounds });
    }
    (!figure.is_empty()).then_some(figure)
}
