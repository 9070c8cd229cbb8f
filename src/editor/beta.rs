//! What the beta-spline programs have in common: buttons, values and questions for bias and tension.

use super::choice::ask_real;
use crate::geometry::{GeometryError, Shape};
use crate::machine::{Language, Quit};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Phrase};
use crate::ui::{Button, Desk, Picture};
use std::ops::RangeInclusive;

/// The buttons for bias and tension.
pub(super) const BUTTONS: [Button; 2] =
    [Button::new(30, 21, words::BIAS), Button::new(120, 21, words::TENSION)];

/// The biases that can be chosen.
pub(super) const BIASES: RangeInclusive<f64> = 0.05..=20.0;
/// The tensions that can be chosen; four characters cannot say more.
pub(super) const TENSIONS: RangeInclusive<f64> = -1e9..=1e9;

/// Draws the values and the buttons.
pub(super) fn draw(screen: &mut Screen, shape: Shape, language: Language) {
    screen.text(20, 5, &format!("{} = {:.2}", words::BIAS_VALUE.of(language), shape.bias), Color::Black);
    screen.text(
        35,
        40,
        &format!("{} = {:.2}", words::TENSION_VALUE.of(language), shape.tension),
        Color::Black,
    );
    BUTTONS.iter().for_each(|button| button.draw(screen, language));
}

/// Asks for a bias; what is out of range becomes the nearest end.
pub(super) async fn ask_bias(desk: &mut Desk<'_>, picture: &dyn Picture) -> Result<Option<f64>, Quit> {
    ask_real(desk, picture, (words::BIAS_ENTRY, (232, 26)), BIASES).await
}

/// Asks for a tension.
pub(super) async fn ask_tension(desk: &mut Desk<'_>, picture: &dyn Picture) -> Result<Option<f64>, Quit> {
    ask_real(desk, picture, (words::TENSION_ENTRY, (232, 26)), TENSIONS).await
}

/// Why there is no curve: the critical tension is explained, the rest says it in its own sentence.
pub(super) fn explain(error: &GeometryError) -> Phrase {
    match error {
        GeometryError::CriticalTension { bias, tension, critical } => Phrase::new(
            format!(
                "Kritikus feszültség: {bias:.2} eltolásnál {critical:.2} körül nincs görbe (2.67); most {tension:.2}. \
                 Más feszültséggel (C) vagy eltolással (A) van."
            ),
            format!(
                "Critical tension: with bias {bias:.2} there is no curve near {critical:.2} (2.67); it is {tension:.2}. \
                 Another tension (C) or bias (A) has one."
            ),
        ),
        error => words::plain(error),
    }
}
