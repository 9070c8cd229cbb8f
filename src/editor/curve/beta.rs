//! Bias and tension of beta-splines in the curve editors (chapter 2.3.7): buttons, questions and display.

use super::ask::ask_real;
use crate::editor::values::{BIAS, TENSION};
use crate::geometry::Shape;
use crate::machine::{Asked, Language};
use crate::screen::{Color, Screen};
use crate::ui::{Area, Desk, Picture, words};

/// Where the two values stand, and how many letters they have room for.
pub(super) const BIAS_AT: (i32, i32) = (20, 5);
pub(super) const TENSION_AT: (i32, i32) = (35, 40);
pub(super) const ROOM: i32 = 20;

/// Which of the two values, bias and tension, is shown at a pixel.
pub(in crate::editor) fn value_at<T>((x, y): (i32, i32), [bias, tension]: [T; 2]) -> Option<T> {
    let places = [(BIAS_AT, bias), (TENSION_AT, tension)];
    places.into_iter().find(|(at, _)| Area::of_line(*at, ROOM).holds(x, y)).map(|(_, value)| value)
}

/// Asks for the bias.
pub(in crate::editor) async fn ask_bias(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<f64> {
    ask_real(desk, picture, (words::BIAS_ENTRY, (232, 26)), BIAS.range()).await
}

/// Asks for the tension.
pub(in crate::editor) async fn ask_tension(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<f64> {
    ask_real(desk, picture, (words::TENSION_ENTRY, (232, 26)), TENSION.range()).await
}

/// Writes the two values above and below their buttons.
pub(in crate::editor) fn draw_values(screen: &mut Screen, shape: Shape, language: Language) {
    screen.bar(75, 2, 155, 17, Color::LightCyan);
    screen.bar(110, 37, 200, 52, Color::LightCyan);
    let line = |name: words::Words, value: f64| format!("{}{}", name.of(language), shown(value));
    screen.text(BIAS_AT.0, BIAS_AT.1, &line(words::BIAS_VALUE, shape.bias), Color::Black);
    screen.text(TENSION_AT.0, TENSION_AT.1, &line(words::TENSION_VALUE, shape.tension), Color::Black);
}

/// A value with two decimals, or with an exponent where that would not fit.
fn shown(value: f64) -> String {
    if value.abs() < 1e5 { format!("{value:.2}") } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_fit_beside_the_page() {
        for (value, expected) in [(1.0, "1.00"), (-31.0, "-31.00"), (9e99, "9e99"), (-1e9, "-1e9")] {
            assert_eq!(shown(value), expected);
        }
        assert_eq!(Shape::default().method().check(), Ok(()));
    }
}
