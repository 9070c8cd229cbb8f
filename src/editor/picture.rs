//! Draws the editor on the screen and as a figure.

use super::field::{ground, surroundings};
use super::lens::Lens;
use super::stage::Stage;
use super::{Craft, Editor, seen};
use crate::figure::Figure;
use crate::geometry::ParamSurface;
use crate::machine::Language;
use crate::screen::{Color, Screen};
use crate::ui::{self, Hint, Picture, TOP};

/// The parts of the screen where a craft draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// In the picture, under the items.
    Under,
    /// In the picture, over the items.
    Over,
    /// On the frame, beside the communication page.
    Frame,
    /// On the communication page.
    Page,
    /// Titles and values beside the buttons.
    Titles,
    /// In the corner of a result.
    Legend,
}

/// What is drawn on.
pub struct Page<'s> {
    /// The screen.
    pub screen: &'s mut Screen,
    /// The language of its texts.
    pub language: Language,
}

impl<C: Craft<D>, const D: usize> Picture for Editor<C, D> {
    fn draw(&self, screen: &mut Screen, language: Language) {
        let mut page = Page { screen, language };
        match self.stage {
            Stage::Result { .. } => self.draw_result(&mut page),
            _ => self.draw_desk(&mut page),
        }
    }

    fn figure(&self) -> Option<Figure> {
        if matches!(self.stage, Stage::Starting { .. } | Stage::Returning) {
            return None;
        }
        seen::figure(&C::seen(self), &self.lens)
    }

    fn surfaces(&self) -> Vec<Box<dyn ParamSurface>> {
        if self.stage.begun() { C::surfaces(self) } else { Vec::new() }
    }

    fn hint(&self) -> Option<Hint> {
        if self.stage == Stage::Working { C::hint(self) } else { None }
    }
}

impl<C: Craft<D>, const D: usize> Editor<C, D> {
    /// What is edited, without its surroundings.
    fn draw_result(&self, page: &mut Page<'_>) {
        page.screen.clear(Color::Black);
        self.draw_seen(page);
        self.lens.draw_legend(page.screen, page.language);
        C::draw(self, Layer::Legend, page);
    }

    /// The editor with its frame and buttons.
    fn draw_desk(&self, page: &mut Page<'_>) {
        match self.stage {
            // As when the original returns: the background is not black yet.
            Stage::Returning => page.screen.clear(Color::LightCyan),
            _ => {
                ground(page.screen);
                self.draw_seen(page);
            }
        }
        surroundings(page.screen);
        self.lens.draw_rim(page.screen);
        C::draw(self, Layer::Frame, page);
        ui::page(page.screen, TOP);
        C::draw(self, Layer::Page, page);
        if matches!(self.stage, Stage::FIRST | Stage::Returning) {
            return;
        }
        C::draw(self, Layer::Titles, page);
        self.craft.commands().draw(page.screen, page.language);
    }

    /// The picture itself.
    fn draw_seen(&self, page: &mut Page<'_>) {
        if !C::covers_ground(self) {
            self.lens.draw_ground(page.screen);
        }
        C::draw(self, Layer::Under, page);
        C::seen(self).iter().for_each(|item| item.paint(page.screen, &self.lens));
        C::draw(self, Layer::Over, page);
    }
}
