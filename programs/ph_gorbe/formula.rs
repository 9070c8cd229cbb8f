//! The key F6: the polynomials of one span, with pictures of w and of the hodograph.

use super::analysis::Analysis;
use super::texts;
use crate::geometry::Point;
use crate::geometry::ph::PhSegment;
use crate::machine::{Asked, Key, Language, Request};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Desk, Over, Picture};

/// The form in which polynomials are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Power,
    Bernstein,
}

/// Shows the formulas until Esc; arrows choose the span, B the form.
pub(super) async fn show(desk: &mut Desk<'_>, picture: &dyn Picture, analysis: &Analysis) -> Asked<()> {
    let segments = analysis.curve.segments();
    let (mut span, mut form) = (0, Form::Power);
    loop {
        let Some(segment) = segments.get(span) else { return Ok(()) };
        let over = Over::new(picture, |screen: &mut Screen, language: Language| {
            draw(screen, language, segment, [span + 1, segments.len()], form);
        });
        let tick =
            desk.event_asked(&over, Request::Keys(vec![Key::Left, Key::Right, Key::Char('B')])).await?;
        match tick.key() {
            Some(Key::Esc | Key::Enter | Key::F(6)) => return Ok(()),
            Some(Key::Right) => span = (span + 1) % segments.len(),
            Some(Key::Left) => span = (span + segments.len() - 1) % segments.len(),
            Some(key) if key.letter() == Some('B') => {
                form = if form == Form::Power { Form::Bernstein } else { Form::Power };
            }
            _ => {}
        }
    }
}

/// The power form of Bernstein coefficients: `a_k = C(n,k) sum_j (-1)^(k-j) C(k,j) b_j`.
fn power(bernstein: &[f64]) -> Vec<f64> {
    let mut differences = bernstein.to_vec();
    let mut factor = 1.0;
    let count = bernstein.len();
    let mut powers = Vec::with_capacity(count);
    for k in 0..count {
        powers.push(factor * differences.first().copied().unwrap_or(0.0));
        differences = differences.windows(2).map(|pair| pair[1] - pair[0]).collect();
        factor *= (count - 1 - k) as f64 / (k + 1) as f64;
    }
    powers
}

/// A polynomial with two decimals.
fn written(bernstein: &[f64], form: Form) -> String {
    if form == Form::Bernstein {
        let list: Vec<String> = bernstein.iter().map(|it| texts::number(*it, 2)).collect();
        return format!("({})", list.join(", "));
    }
    let mut text = String::new();
    // What is zero but for rounding is left out.
    let zero = 1e-9 * bernstein.iter().fold(0.0_f64, |most, it| most.max(it.abs()));
    let terms = power(bernstein).into_iter().enumerate();
    for (k, value) in terms.filter(|(k, value)| *k == 0 || value.abs() > zero) {
        let sign = if value < 0.0 { "-" } else { "+" };
        let number = texts::number(value.abs(), 2);
        let variable = match k {
            0 => String::new(),
            1 => " t".to_owned(),
            _ => format!(" t^{k}"),
        };
        match (k, sign) {
            (0, "-") => text.push_str(&format!("-{number}")),
            (0, _) => text.push_str(&number),
            _ => text.push_str(&format!(" {sign} {number}{variable}")),
        }
    }
    text
}

fn draw(screen: &mut Screen, language: Language, segment: &PhSegment, [span, spans]: [usize; 2], form: Form) {
    screen.bar(29, 58, 633, 462, Color::Black);
    let [left, right] = [40, 350];
    screen.text(left, 66, texts::formulas_of(span, spans).of(language), Color::Yellow);
    screen.text(left, 78, texts::FORMULA_KEYS.of(language), Color::LightGray);
    let (w, slope) = (segment.preimage(), segment.hodograph());
    let axis = |of: &[Point<2>], axis: usize| -> Vec<f64> { of.iter().map(|point| point[axis]).collect() };
    let rows = [
        ("m(t) = ", axis(&w, 0), Color::LightGreen),
        ("n(t) = ", axis(&w, 1), Color::LightGreen),
        ("x'(t) = ", axis(&slope, 0), Color::White),
        ("y'(t) = ", axis(&slope, 1), Color::White),
        ("sigma = ", segment.speed_coefficients().to_vec(), Color::Yellow),
    ];
    for (row, (name, polynomial, ink)) in (0..).zip(rows) {
        let text = format!("{name}{}", written(&polynomial, form));
        screen.text(left, 98 + 14 * row, &text, ink);
    }
    let h = texts::number(segment.step(), 4);
    screen.text(
        left,
        172,
        &format!("h = {h}   x' = h (m² - n²)   y' = 2 h m n   sigma = h (m² + n²)"),
        Color::LightCyan,
    );
    let steps = 60;
    let at = |coefficients: &[Point<2>]| -> Vec<Point<2>> {
        (0..=steps).map(|k| bezier(coefficients, f64::from(k) / f64::from(steps))).collect()
    };
    plot(screen, left, texts::W_PICTURE.of(language), &at(&w), Color::LightGreen);
    plot(screen, right, texts::HODOGRAPH.of(language), &at(&slope), Color::White);
}

/// De Casteljau.
fn bezier(coefficients: &[Point<2>], t: f64) -> Point<2> {
    let mut points = coefficients.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| [0, 1].map(|axis| (1.0 - t) * pair[0][axis] + t * pair[1][axis]))
            .collect();
    }
    points.first().copied().unwrap_or([0.0; 2])
}

/// A curve in its own plane with the origin in the middle.
fn plot(screen: &mut Screen, left: i32, name: &str, points: &[Point<2>], ink: Color) {
    let (half, top) = (120, 206);
    let (x, y) = (left + half, top + half);
    let most = points.iter().flatten().fold(1e-9_f64, |most, it| most.max(it.abs()));
    screen.text(left, 192, name, ink);
    screen.rectangle(left, top, left + 2 * half, top + 2 * half, Stroke::thin(Color::DarkGray));
    screen.line(left, y, left + 2 * half, y, Stroke::thin(Color::DarkGray));
    screen.line(x, top, x, top + 2 * half, Stroke::thin(Color::DarkGray));
    let scale = 0.94 * f64::from(half) / most;
    let pixel = |it: &Point<2>| {
        let near = |it: f64| if it.is_finite() { (it * scale).round() as i32 } else { 0 };
        (x + near(it[0]), y - near(it[1]))
    };
    let pixels: Vec<(i32, i32)> = points.iter().map(pixel).collect();
    screen.polyline(&pixels, Stroke::thick(ink));
    if let Some(&(x, y)) = pixels.first() {
        screen.disc(x, y, 3, ink, Color::Black);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_are_the_same_polynomial() {
        let bernstein = [3.0, -1.0, 4.0, 1.0, -5.0];
        let powers = power(&bernstein);
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            let horner = powers.iter().rev().fold(0.0, |sum, it| sum * t + it);
            let points: Vec<Point<2>> = bernstein.iter().map(|it| [*it, 0.0]).collect();
            assert!((horner - bezier(&points, t)[0]).abs() < 1e-12);
        }
        assert_eq!(written(&[1.0, 0.5], Form::Power), "1.00 - 0.50 t");
        assert_eq!(written(&[1.0, 0.5], Form::Bernstein), "(1.00, 0.50)");
    }
}
