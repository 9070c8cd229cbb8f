//! The beta-spline's shape in the curve editors (chapter 2.3.7): its bias and tension, the buttons and
//! questions that change them, their display, and the marks at the joints.

use super::choice::ask_real;
use crate::geometry::{Closure, Curve, ParamCurve, Point, Shape};
use crate::machine::{Asked, Language};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Button, Desk, Picture, words};
use std::ops::RangeInclusive;

/// What the bias may be.
pub(super) const BIAS: RangeInclusive<f64> = 0.05..=20.0;
/// What the tension may be: four characters can be typed, and nothing is too much.
pub(super) const TENSION: RangeInclusive<f64> = f64::MIN..=f64::MAX;

/// The buttons that ask for the bias and the tension.
pub(super) const BUTTONS: [Button; 2] =
    [Button::new(30, 21, words::BIAS_BUTTON), Button::new(120, 21, words::TENSION_BUTTON)];

/// Asks for the bias.
pub(super) async fn ask_bias(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<f64> {
    ask_real(desk, picture, (words::BIAS_ENTRY, (232, 26)), BIAS).await
}

/// Asks for the tension.
pub(super) async fn ask_tension(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<f64> {
    ask_real(desk, picture, (words::TENSION_ENTRY, (232, 26)), TENSION).await
}

/// Writes the two values above and below their buttons.
pub(super) fn draw_values(screen: &mut Screen, shape: Shape, language: Language) {
    screen.bar(75, 2, 155, 17, Color::LightCyan);
    screen.bar(110, 37, 200, 52, Color::LightCyan);
    let line = |name: words::Words, value: f64| format!("{}{}", name.of(language), shown(value));
    screen.text(20, 5, &line(words::BIAS_VALUE, shape.bias), Color::Black);
    screen.text(35, 40, &line(words::TENSION_VALUE, shape.tension), Color::Black);
}

/// A value with two decimals, or with an exponent where that would not fit.
fn shown(value: f64) -> String {
    if value.abs() < 1e5 { format!("{value:.2}") } else { format!("{value:e}") }
}

/// The ends of a beta-spline's spans: the last point of each, and the first one of an open curve.
pub(super) fn joints<const D: usize>(curve: &Curve<D>, closure: Closure) -> Vec<Point<D>> {
    let start = (closure == Closure::Open).then(|| curve.eval(0, 0.0)).flatten();
    let ends = (0..curve.spans()).filter_map(|span| curve.eval(span, 1.0));
    start.into_iter().chain(ends).collect()
}

/// Marks a joint by a small disc.
pub(super) fn draw_joint(screen: &mut Screen, (x, y): (i32, i32)) {
    screen.disc(x, y, 3, Color::Black, Color::White);
    screen.circle(x, y, 3, Stroke::thick(Color::White));
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

    #[test]
    fn an_open_curve_has_a_mark_at_its_start() {
        let points = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]];
        for (closure, marks) in [(Closure::Open, 4), (Closure::Closed, 4)] {
            let curve = Curve::through(Shape::default().method(), closure, &points).unwrap();
            assert_eq!(joints(&curve, closure).len(), marks);
        }
    }
}
