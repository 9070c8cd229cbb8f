//! The picture of the space editor: the model as pixels, changing nothing.

use super::{Editor, Stage, Tools};
use crate::editor::axes::{draw_axes, draw_legend};
use crate::editor::beta;
use crate::editor::choice::COMMANDS;
use crate::editor::field::{ground, numbered_disc, on_disc, surroundings};
use crate::figure::{Axes, CURVE_INK, Figure};
use crate::geometry::{BoundingBox, ParamCurve, Point};
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Picture, TOP, page, words};

impl Picture for Editor {
    fn draw(&self, screen: &mut Screen, language: Language) {
        match self.stage {
            Stage::Result { points } => self.draw_result(screen, points, language),
            stage => self.draw_desk(screen, stage, language),
        }
    }

    fn figure(&self) -> Option<Figure> {
        if matches!(self.stage, Stage::Starting { .. }) {
            return None;
        }
        let (drawing, view) = (self.preview(), self.viewer.look.view);
        let (mut figure, points) = (Figure::new(), drawing.points());
        let mut bounds = BoundingBox::of_points(points)?;
        let shown = self.shown.visible || self.held.is_some() || matches!(self.stage, Stage::Result { .. });
        if let Some(choice) = self.shown.choice.filter(|_| shown)
            && let Ok(curve) = choice.curve(points)
            && figure.plot_space_curve(&curve, &view, CURVE_INK).is_ok()
        {
            bounds = curve.bounding_box().map_or(bounds, |of_curve| bounds.union(of_curve));
            let joints =
                if self.tools == Tools::Beta { beta::joints(&curve, choice.closure) } else { vec![] };
            joints.into_iter().for_each(|joint| figure.plot_joint(view.place(joint)));
        }
        if !matches!(self.stage, Stage::Result { points: false }) {
            let places: Vec<Point<2>> = points.iter().map(|&point| view.place(point)).collect();
            figure.plot_points(&places);
        }
        figure.set_axes(Axes::Space { view, bounds });
        (!figure.is_empty()).then_some(figure)
    }
}

impl Editor {
    /// The curve without its surroundings.
    fn draw_result(&self, screen: &mut Screen, points: bool, language: Language) {
        screen.clear(Color::Black);
        draw_axes(screen, self.viewer.look);
        self.draw_curve(screen);
        let shown = if points { self.history.now().points() } else { &[] };
        for &point in shown {
            let (x, y) = self.viewer.look.to_screen(point);
            screen.disc(x, y, 4, Color::White, Color::White);
        }
        draw_legend(screen, language);
    }

    /// The editor with its frame and buttons.
    fn draw_desk(&self, screen: &mut Screen, stage: Stage, language: Language) {
        ground(screen);
        draw_axes(screen, self.viewer.look);
        if self.shown.visible || self.held.is_some() {
            self.draw_curve(screen);
        }
        self.draw_points(screen);
        surroundings(screen);
        self.draw_place(screen, language);
        page(screen, TOP);
        if let Some(note) = &self.note {
            screen.text(262, 23, note, Color::Black);
        }
        if stage == Stage::FIRST {
            return;
        }
        match self.tools {
            Tools::Methods => {
                let title = if stage == Stage::Choosing { Color::LightMagenta } else { Color::Black };
                screen.text(28, 5, words::METHOD_TITLE.of(language), title);
            }
            Tools::Beta => beta::draw_values(screen, self.shape, language),
        }
        COMMANDS.iter().chain(self.tools.buttons()).for_each(|button| button.draw(screen, language));
    }

    /// The chosen curve through the points as they would be if a dragged one were dropped now; one that
    /// does not exist is not drawn.
    fn draw_curve(&self, screen: &mut Screen) {
        let Some(choice) = self.shown.choice else { return };
        let drawing = self.preview();
        let Ok(line) = choice.polyline(drawing.points()) else { return };
        let mut pixels: Vec<_> = line.into_iter().map(|point| self.viewer.look.to_screen(point)).collect();
        pixels.dedup();
        screen.polyline(&pixels, Stroke::thick(Color::White));
        if self.tools == Tools::Beta
            && let Ok(curve) = choice.curve(drawing.points())
        {
            for joint in beta::joints(&curve, choice.closure) {
                beta::draw_joint(screen, self.viewer.look.to_screen(joint));
            }
        }
    }

    /// The control points with their numbers, the nearest on top.
    fn draw_points(&self, screen: &mut Screen) {
        let drawing = self.preview();
        for index in self.viewer.look.view.far_to_near(drawing.points()) {
            // The indices are those of these points.
            let Some(&point) = drawing.points().get(index) else { continue };
            numbered_disc(screen, self.viewer.look.to_screen(point), index + 1, Color::Black);
        }
    }

    /// The line under the picture: the place of the point that is held or about to be changed.
    fn draw_place(&self, screen: &mut Screen, language: Language) {
        let Some(index) = self.held.map(|held| held.index).or(self.pointed_out) else { return };
        let drawing = self.preview();
        let Some(&place) = drawing.points().get(index) else { return };
        screen.text(130, 470, words::place_of(index + 1, place).of(language), Color::Black);
    }

    /// The point whose disc lies on top at a pixel.
    pub(super) fn point_at(&self, x: i32, y: i32) -> Option<usize> {
        let points = self.history.now().points();
        let under = |index: &usize| {
            points.get(*index).is_some_and(|&point| on_disc(self.viewer.look.to_screen(point), (x, y)))
        };
        self.viewer.look.view.far_to_near(points).into_iter().rev().find(under)
    }
}
