//! The picture of the plane editor: the model as pixels, changing nothing.

use super::curves::{self, Kind};
use super::layout::{STORE_AT, control_point, grid, on_disc, surroundings};
use super::{Editor, Handle, Stage, Tools, tangents};
use crate::editor::beta;
use crate::editor::choice::{COMMANDS, Choice};
use crate::editor::field::ground;
use crate::figure::Figure;
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

    fn figure(&self) -> Option<Figure> {
        self.as_figure()
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
        if stage == Stage::FIRST {
            return;
        }
        self.draw_title(screen, language);
        COMMANDS.iter().chain(self.tools.buttons()).for_each(|button| button.draw(screen, language));
    }

    /// What stands left of the communication page and on it.
    fn draw_title(&self, screen: &mut Screen, language: Language) {
        let note = self.note.as_deref().unwrap_or("");
        match self.tools {
            Tools::Methods => {
                let chosen = self.stage == Stage::Choosing;
                let color = if chosen { Color::LightMagenta } else { Color::Black };
                screen.text(28, 5, words::METHOD_TITLE.of(language), color);
                screen.text(262, 23, note, Color::Black);
                if note.is_empty() {
                    self.draw_legend(screen, 216, 10);
                }
            }
            Tools::Tangents => {
                screen.text(20, 20, words::COONS_TITLE.of(language), Color::Black);
                screen.text(134, 10, words::COONS_ACCENTS.of(language), Color::Black);
                screen.text(65, 43, note, Color::Black);
            }
            Tools::Beta => beta::draw_values(screen, self.history.now().shape, language),
        }
    }

    /// The chosen curve and those that it is compared with, through the points as they would be if a
    /// dragged one were dropped now.
    fn draw_curves(&self, screen: &mut Screen) {
        let sketch = self.preview();
        let mut draw = |choice: Choice, color: Color| {
            // A curve that does not exist is not drawn; it was told when it was chosen.
            if let Ok(pixels) = curves::pixels(self.tools, choice, &sketch) {
                curves::draw(screen, &pixels, color);
            }
        };
        let closure = self.closure();
        for (kind, _, color) in Kind::ALL.into_iter().filter(|(kind, ..)| self.compared.contains(kind)) {
            draw(Choice { closure, method: kind.method(self.k0) }, color);
        }
        let shown = self.shown.visible || matches!(self.stage, Stage::Result { .. });
        if let Some(choice) = self.shown.choice.filter(|_| shown) {
            draw(choice, Color::White);
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

    /// The tangents, the control points with their numbers, and the next one in the store.
    fn draw_points(&self, screen: &mut Screen) {
        let sketch = self.history.now();
        let held_at = |handle| self.held.filter(|held| held.handle == handle).map(|held| held.at);
        for (index, &point) in sketch.points().iter().enumerate() {
            if let Some(tip) = held_at(Handle::Tip(index)).or(sketch.tip(index)) {
                tangents::draw(screen, point, tip);
            }
        }
        for (index, &point) in sketch.points().iter().enumerate() {
            control_point(screen, held_at(Handle::Point(index)).unwrap_or(point), index + 1);
        }
        let stored = !matches!(self.stage, Stage::Starting { .. } | Stage::Offering | Stage::Result { .. });
        if stored && !sketch.drawing.full() {
            let at = held_at(Handle::Point(self.count())).unwrap_or(STORE_AT);
            control_point(screen, at, self.count() + 1);
        }
        self.draw_joint_shapes(screen);
    }

    /// What lies on top at a pixel: points before tips; the store's point is the one behind the last.
    pub(super) fn handle_at(&self, x: i32, y: i32) -> Option<Handle> {
        let sketch = self.history.now();
        if !sketch.drawing.full() && on_disc(STORE_AT, (x, y)) {
            return Some(Handle::Point(self.count()));
        }
        let point = sketch.points().iter().rposition(|&point| on_disc(point, (x, y)));
        let on_tip = |&index: &usize| sketch.tip(index).is_some_and(|tip| tangents::on_tip(tip, (x, y)));
        let tip = || (0..self.count()).rev().find(on_tip);
        point.map(Handle::Point).or_else(|| tip().map(Handle::Tip))
    }
}
