//! The picture of the surface editor: the model as pixels, changing nothing.

use super::inspect::Inspection;
use super::model::{Index, Model, Part};
use super::plan::Family;
use super::surface::{Drawn, draw_grid};
use super::{Editor, Stage};
use crate::editor::axes::{draw_axes, draw_legend};
use crate::editor::field::{ground, surroundings};
use crate::figure::Figure;
use crate::geometry::{ParamSurface, Point};
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::words;
use crate::ui::{Button, Picture, TOP, page};

/// The buttons of all surface programs.
const COMMANDS: [Button; 4] = [
    Button::new(460, 4, words::CHANGE),
    Button::new(460, 21, words::SURFACE),
    Button::new(460, 38, words::RESULT),
    Button::new(550, 38, words::NET_QUIT),
];
const BETA: [Button; 2] =
    [Button::new(550, 4, words::BIAS_BUTTON), Button::new(550, 21, words::TENSION_BUTTON)];
const LOCAL: [Button; 1] = [Button::new(550, 21, words::K0_BUTTON)];

/// Radius of a control point's circle.
const RADIUS: i32 = 4;
/// How near a click has to be to it.
const REACH: i32 = 6;
/// Length of the drawn tangents of a Hermite patch.
const TANGENT: f64 = 0.2;
/// Steps of its border curves.
const BORDER_STEPS: usize = 16;

/// The buttons of a program.
pub(super) fn buttons(family: Family) -> impl Iterator<Item = Button> {
    let own: &[Button] = match family {
        Family::Beta => &BETA,
        Family::Local => &LOCAL,
        _ => &[],
    };
    COMMANDS.iter().chain(own).copied()
}

impl Picture for Editor {
    fn draw(&self, screen: &mut Screen, language: Language) {
        match self.stage {
            Stage::Result => self.draw_result(screen, language),
            stage => self.draw_desk(screen, stage, language),
        }
    }

    fn figure(&self) -> Option<Figure> {
        self.as_figure()
    }
}

impl Editor {
    /// The surface without its surroundings.
    fn draw_result(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::Black);
        if let Some(drawn) = &self.drawn {
            self.draw_surface(screen, drawn, Color::White);
        }
        draw_legend(screen, language);
        if self.plan.family != Family::Heights {
            self.display.draw_legend(screen, language);
        }
    }

    fn draw_surface(&self, screen: &mut Screen, drawn: &Drawn, ink: Color) {
        let look = self.viewer.look;
        if !self.draw_inspected(screen, drawn, look) {
            draw_grid(screen, &drawn.grid, look, (self.display_now(), self.fill()), ink);
        }
        self.draw_section(screen, drawn, look);
    }

    /// The editor with its frame and buttons.
    fn draw_desk(&self, screen: &mut Screen, stage: Stage, language: Language) {
        match stage {
            // As the original comes back: the ground is not black yet.
            Stage::Returning => screen.clear(Color::LightCyan),
            _ => {
                ground(screen);
                self.draw_field(screen, stage);
            }
        }
        surroundings(screen);
        self.map().draw(screen, self.picked());
        page(screen, TOP);
        if matches!(stage, Stage::Starting { buttons: false } | Stage::Returning) {
            return;
        }
        buttons(self.plan.family).for_each(|button| button.draw(screen, language));
        match self.line(language) {
            Some(line) => {
                screen.bar(0, 467, 639, 479, Color::LightCyan);
                screen.text(130, 470, &line, Color::Black);
            }
            None => self.draw_values(screen, language),
        }
    }

    fn draw_field(&self, screen: &mut Screen, stage: Stage) {
        let look = self.viewer.look;
        if let Some(drawn) = &self.drawn {
            return self.draw_surface(screen, drawn, Color::White);
        }
        draw_axes(screen, look);
        if matches!(stage, Stage::Starting { .. }) {
            return;
        }
        let model = self.preview();
        if let Some(drawn) = self.under_net(&model) {
            let ink = if self.inspection == Inspection::Off { Color::Cyan } else { Color::White };
            self.draw_surface(screen, &drawn, ink);
        }
        self.draw_net(screen, &model);
    }

    /// The surface that is shown with its net.
    pub(super) fn under_net(&self, model: &Model) -> Option<Drawn> {
        let follows = self.follow || self.held.is_some();
        follows.then(|| self.draw_up(model).ok()).flatten()
    }

    /// The control points and the lines between them.
    fn draw_net(&self, screen: &mut Screen, model: &Model) {
        let look = self.viewer.look;
        for (from, to, ink) in self.strokes(model) {
            let ((x1, y1), (x2, y2)) = (look.to_screen(from), look.to_screen(to));
            screen.line(x1, y1, x2, y2, Stroke::thin(ink));
        }
        for index in model.indices(&self.plan) {
            let Some(point) = model.point(index) else { continue };
            let (x, y) = look.to_screen(point);
            let fill = if self.picked() == Some(index) { Color::LightRed } else { Color::Black };
            screen.disc(x, y, RADIUS, fill, Color::White);
        }
    }

    /// The lines between the control points in their colours; white ones are borders of the surface.
    pub(super) fn strokes(&self, model: &Model) -> Vec<(Point<3>, Point<3>, Color)> {
        let inked = |lines: Vec<Line>, ink: Color| lines.into_iter().map(move |(from, to)| (from, to, ink));
        match self.plan.family {
            Family::Heights => inked(ground_lines(model), Color::DarkGray).collect(),
            Family::Hermite => {
                let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|corner| model.point(corner));
                let sides = corners.iter().zip(corners.iter().cycle().skip(1));
                let sides = sides.filter_map(|(from, to)| from.zip(*to)).collect();
                let borders = inked(self.border_lines(model), Color::White);
                borders.chain(inked(sides, Color::LightGray)).collect()
            }
            _ => {
                let closed = self.plan.kind.topology().closed();
                inked(net_lines(model, closed), Color::LightGray).collect()
            }
        }
    }

    /// The four border curves of a Hermite patch and the tangents across them (chapter 3.3).
    fn border_lines(&self, model: &Model) -> Vec<(Point<3>, Point<3>)> {
        let Ok(surface) = model.surface(&self.plan, self.degree) else { return Vec::new() };
        let mut lines = Vec::new();
        for (side, along_u) in [(0.0, false), (1.0, false), (0.0, true), (1.0, true)] {
            let mut before = None;
            for step in 0..=BORDER_STEPS {
                let t = step as f64 / BORDER_STEPS as f64;
                let (u, v) = if along_u { (t, side) } else { (side, t) };
                let Some(at) = surface.at([0, 0], [u, v]) else { continue };
                let across = if along_u { at.v } else { at.u };
                let tip = std::array::from_fn(|d| at.point[d] + TANGENT * across[d]);
                lines.push((at.point, tip));
                lines.extend(before.map(|before| (before, at.point)));
                before = Some(at.point);
            }
        }
        lines
    }

    fn picked(&self) -> Option<Index> {
        self.held.map(|held| held.index).or(self.chosen.map(|(index, _)| index))
    }

    /// The line under the picture: the point that is held or about to be changed.
    fn line(&self, language: Language) -> Option<String> {
        let (index, part) = match self.held {
            Some(held) => (held.index, Part::Place),
            None => self.chosen?,
        };
        let value = self.preview().part(index, part)?;
        let phrase = match self.plan.family {
            Family::Heights => words::height_of(index, value[2]),
            _ => words::part_of(index, part.title(), value),
        };
        Some(phrase.of(language).to_string())
    }

    /// The shape parameters under the picture.
    fn draw_values(&self, screen: &mut Screen, language: Language) {
        let form = &self.history.now().form;
        let mut write = |x: i32, name: words::Words, direction: &str, value: String| {
            screen.text(x, 470, &format!("{}{direction} = {value}", name.of(language)), Color::Black);
        };
        match self.plan.family {
            Family::Beta => {
                write(2, words::BIAS_NAME, "_u", format!("{:.2}", form.bias[0]));
                write(145, words::BIAS_NAME, "_v", format!("{:.2}", form.bias[1]));
                write(292, words::TENSION_NAME, "_u", short(form.tension[0]));
                write(471, words::TENSION_NAME, "_v", short(form.tension[1]));
            }
            Family::Local => {
                write(120, words::K0_NAME, "_u", format!("{:.2}", form.k0[0]));
                write(340, words::K0_NAME, "_v", format!("{:.2}", form.k0[1]));
            }
            _ => {}
        }
    }

    /// The control point whose circle is at a pixel, the nearest to the viewer; none where the surface
    /// stands instead of the net.
    pub(super) fn point_at(&self, (x, y): (i32, i32)) -> Option<Index> {
        if self.drawn.is_some() {
            return None;
        }
        let (model, look) = (self.history.now(), self.viewer.look);
        let under = model.indices(&self.plan).filter_map(|index| {
            let point = model.point(index)?;
            let (px, py) = look.to_screen(point);
            let near = (px - x).pow(2) + (py - y).pow(2) <= REACH * REACH;
            near.then(|| (index, look.view.depth(point)))
        });
        under.max_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(index, _)| index)
    }
}

/// A tension with one decimal, or with an exponent where that would not fit.
fn short(value: f64) -> String {
    if value.abs() < 1e4 { format!("{value:.1}") } else { format!("{value:e}") }
}

type Line = (Point<3>, Point<3>);

/// The lines between neighbours of a net.
fn net_lines(model: &Model, closed: [bool; 2]) -> Vec<Line> {
    let [rows, columns] = model.shape();
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
            lines.extend(model.point([k, l]).zip(model.point(other)));
        }
    }
    lines
}

/// The grid on the ground under heights, and the drops to it.
fn ground_lines(model: &Model) -> Vec<Line> {
    let [rows, columns] = model.shape();
    let foot = |index: Index| model.point(index).map(|[x, y, _]| [x, y, 0.0]);
    let (k, l) = (rows.saturating_sub(1), columns.saturating_sub(1));
    let along = (0..columns).filter_map(|l| foot([0, l]).zip(foot([k, l])));
    let across = (0..rows).filter_map(|k| foot([k, 0]).zip(foot([k, l])));
    let all = (0..rows).flat_map(|k| (0..columns).map(move |l| [k, l]));
    let drops = all.filter_map(|index| foot(index).zip(model.point(index)));
    along.chain(across).chain(drops).collect()
}
