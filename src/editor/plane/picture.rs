//! The picture of the plane editor: the model as pixels, changing nothing.

use super::curves::{self, Kind};
use super::layout::{STORE_AT, control_point, grid, on_disc, surroundings};
use super::{Editor, Stage};
use crate::editor::choice::{COMMANDS, Choice, METHODS};
use crate::editor::field::ground;
use crate::machine::Language;
use crate::screen::{Color, Screen};
use crate::ui::{Picture, TOP, page, words};

impl Picture for Editor {
    fn draw(&self, screen: &mut Screen, language: Language) {
        match self.stage {
            Stage::Result { points } => self.draw_result(screen, points, language),
            stage => self.draw_desk(screen, stage, language),
        }
    }
}

impl Editor {
    /// The curve without its surroundings.
    fn draw_result(&self, screen: &mut Screen, points: bool, language: Language) {
        screen.clear(Color::Black);
        grid(screen);
        self.draw_curves(screen);
        if points {
            self.draw_points(screen);
        }
        screen.text(5, 5, words::BACK.of(language), Color::LightGray);
        self.draw_legend(screen, 400, 5);
    }

    /// The editor with its frame and buttons.
    fn draw_desk(&self, screen: &mut Screen, stage: Stage, language: Language) {
        ground(screen);
        grid(screen);
        screen.text(607, 67, words::STORE.of(language), Color::White);
        if self.shown.visible || self.held.is_some() || !self.compared.is_empty() {
            self.draw_curves(screen);
        }
        self.draw_points(screen);
        surroundings(screen);
        page(screen, TOP);
        if let Some(note) = &self.note {
            screen.text(262, 23, note, Color::Black);
        } else {
            self.draw_legend(screen, 216, 10);
        }
        if stage == (Stage::Starting { buttons: false }) {
            return;
        }
        let title = if stage == Stage::Choosing { Color::LightMagenta } else { Color::Black };
        screen.text(28, 5, words::METHOD_TITLE.of(language), title);
        COMMANDS.iter().chain(&METHODS).for_each(|button| button.draw(screen, language));
    }

    /// The chosen curve and those that it is compared with, through the points as they would be if a
    /// dragged one were dropped now.
    fn draw_curves(&self, screen: &mut Screen) {
        let drawing = self.preview();
        let closure = self.closure();
        for (kind, _, color) in Kind::ALL.into_iter().filter(|(kind, ..)| self.compared.contains(kind)) {
            let choice = Choice { closure, method: kind.method(self.k0) };
            curves::draw(screen, choice, drawing.points(), color);
        }
        let shown = self.shown.visible || matches!(self.stage, Stage::Result { .. });
        if let Some(choice) = self.shown.choice.filter(|_| shown) {
            curves::draw(screen, choice, drawing.points(), Color::White);
        }
    }

    /// The names of the compared curves in their colours, two to a line.
    fn draw_legend(&self, screen: &mut Screen, x: i32, y: i32) {
        let compared = Kind::ALL.into_iter().filter(|(kind, ..)| self.compared.contains(kind));
        for (place, (_, name, color)) in (0..).zip(compared) {
            let (x, y) = (x + 116 * (place % 2), y + 11 * (place / 2));
            screen.bar(x, y, x + 12, y + 7, color);
            let ink =
                if matches!(self.stage, Stage::Result { .. }) { Color::LightGray } else { Color::Black };
            screen.text(x + 18, y, name, ink);
        }
    }

    /// The control points with their numbers, and the next one in the store.
    fn draw_points(&self, screen: &mut Screen) {
        let points = self.history.now().points();
        let held_point = |index| self.held.filter(|held| held.index == index).map(|held| held.at);
        for (index, &point) in points.iter().enumerate() {
            control_point(screen, held_point(index).unwrap_or(point), index + 1);
        }
        let stored = !matches!(self.stage, Stage::Starting { .. } | Stage::Result { .. })
            && !self.history.now().full();
        if stored {
            control_point(screen, held_point(points.len()).unwrap_or(STORE_AT), points.len() + 1);
        }
    }

    /// The point whose disc lies on top at a pixel; the store counts as the point behind the last one.
    pub(super) fn point_at(&self, x: i32, y: i32) -> Option<usize> {
        let points = self.history.now().points();
        if !self.history.now().full() && on_disc(STORE_AT, (x, y)) {
            return Some(points.len());
        }
        points.iter().rposition(|&point| on_disc(point, (x, y)))
    }
}
