//! Draws the Fourier editor.

use super::{COMMANDS, Editor, Stage, layout};
use crate::design::fourier::{Coefficient, Column};
use crate::figure::{CURVE_INK, Figure};
use crate::file::Fourier;
use crate::geometry::ParamCurve;
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Hint, Picture, TOP, page, words};

/// The place on the page below the marked coefficient.
const BELOW: (i32, i32) = (216, 24);
/// Number of segments of the drawn curve.
const STEPS: usize = 1000;

impl Picture for Editor {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::LightCyan);
        let shown = self.shown();
        if let Some(fourier) = shown {
            self.draw_field(screen, fourier);
        }
        layout::surroundings(screen);
        page(screen, TOP);
        if let Some(fourier) = shown {
            self.draw_columns(screen, fourier);
            COMMANDS.draw(screen, language);
        }
        if self.stage == Stage::Working {
            self.draw_notes(screen, language);
        }
    }

    fn figure(&self) -> Option<Figure> {
        let curve = self.shown()?.curve().ok()?;
        let mut figure = Figure::new();
        if let Some(target) = &self.target {
            figure.plot_target(&target.path.arcs().to_vec()).ok()?;
        }
        figure.plot_curve(&curve, CURVE_INK).ok()?;
        Some(figure)
    }

    /// Where nothing else stands on the page.
    fn hint(&self) -> Option<Hint> {
        if self.stage != Stage::Working || self.target.is_some() {
            return None;
        }
        Some(match (&self.typing, self.marked) {
            (Some(_), _) => Hint::at(BELOW, 28, words::HINT_TYPING),
            (None, Some(_)) => Hint::at(BELOW, 28, words::HINT_COEFFICIENT),
            (None, None) => Hint::new(words::HINT_COEFFICIENTS).by_keys(words::KEYS_COEFFICIENTS),
        })
    }
}

impl Editor {
    /// The coefficients of the drawn curve.
    fn shown(&self) -> Option<&Fourier> {
        match &self.stage {
            Stage::Starting(before) => before.as_deref(),
            Stage::Working => Some(self.history.now()),
        }
    }

    /// The curve on top of the one it was fitted to.
    fn draw_field(&self, screen: &mut Screen, fourier: &Fourier) {
        layout::field(screen);
        if let Some(target) = &self.target {
            screen.polyline(&target.outline, Stroke::thin(Color::LightRed));
        }
        // Coefficients without a curve are refused when a file is opened and cannot be typed.
        if let Ok(points) = fourier.curve().and_then(|curve| curve.polyline(STEPS)) {
            let pixels: Vec<_> = points.into_iter().map(layout::to_screen).collect();
            screen.polyline(&pixels, Stroke::thick(Color::White));
        }
    }

    fn draw_columns(&self, screen: &mut Screen, fourier: &Fourier) {
        Column::ALL.iter().for_each(|&(column, _)| layout::column(screen, column));
        for place in Coefficient::all() {
            let color = if self.marked == Some(place) { Color::Yellow } else { Color::White };
            let (x, y) = layout::text_at(place);
            screen.text(x, y, &place.column.quantity().shown(place.of(fourier)), color);
        }
        if let Some(entry) = &self.typing {
            entry.draw(screen);
        }
    }

    /// On the communication page: the marked coefficient with all its digits, and the error of the fit.
    fn draw_notes(&self, screen: &mut Screen, language: Language) {
        let fourier = self.history.now();
        if let Some(place) = self.marked {
            screen.text(216, 10, &place.exact(fourier), Color::Black);
        }
        if let Some(target) = &self.target {
            screen.text(216, 22, target.name.of(language), Color::Black);
            if let Some(error) = target.deviation(fourier) {
                let text = format!("RMS {} max {}", short(error.rms), short(error.largest));
                screen.text(216, 34, &text, Color::Black);
            }
        }
    }
}

/// A distance in pixels with two decimals, or in scientific notation when it is very long.
fn short(distance: f64) -> String {
    if distance < 1e5 { format!("{distance:.2}") } else { format!("{distance:.1e}") }
}
