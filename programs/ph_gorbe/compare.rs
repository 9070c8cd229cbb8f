//! The key F5: what other programs draw instead of an offset, and how far it is off.

use super::analysis::{Analysis, STEPS};
use super::plane::Options;
use super::{in_field, speed, texts};
use crate::geometry::ParamCurve;
use crate::geometry::ph::{Offset, PhCurve, Rule};
use crate::machine::{Asked, Key, Language, Request};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Desk, Over, Picture, Stay, TOP, page};

/// Pieces a span, in the order of the keys + and -.
const PIECES: [usize; 4] = [1, 2, 4, 8];
/// Places of a piece where the error is measured.
const MEASURED: usize = 24;

/// The approximations, each in its colour.
const RULES: [(Rule, Color); 2] =
    [(Rule::TillerHanson, Color::LightMagenta), (Rule::Hermite, Color::Magenta)];

/// An approximate offset for the picture.
struct Approximation {
    ink: Color,
    /// The pixels of every offset.
    lines: Vec<Vec<(i32, i32)>>,
    /// The error of the first offset against the share of the length.
    errors: Vec<[f64; 2]>,
    largest: f64,
}

impl Approximation {
    fn new(curve: &PhCurve, offsets: &[&Offset], (rule, ink): (Rule, Color), pieces: usize) -> Approximation {
        let mut found = Approximation { ink, lines: Vec::new(), errors: Vec::new(), largest: 0.0 };
        for offset in offsets {
            let Ok(near) = offset.approximated(rule, pieces) else { continue };
            let line = near.curve().polyline(STEPS.div_ceil(pieces)).unwrap_or_default();
            found.lines.push(line.into_iter().map(super::pixel).collect());
            found.largest = found.largest.max(near.largest_deviation(MEASURED));
            if found.errors.is_empty() {
                let share = |place| curve.length_at(place).map(|s| s / curve.total_length());
                let rows = near.deviations(MEASURED).into_iter();
                found.errors = rows.filter_map(|(place, off)| Some([share(place)?, off])).collect();
            }
        }
        found
    }
}

/// Shows the approximations until Esc; + and - change how many pieces a span has.
pub(super) async fn show(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    analysis: &Analysis,
    options: &Options,
) -> Asked<()> {
    if options.distance.is_none() || analysis.sides.is_empty() {
        desk.tell(texts::NO_OFFSET, Stay::Briefly);
        return Ok(());
    }
    let offsets: Vec<&Offset> = analysis.sides.iter().map(|side| &*side.offset).collect();
    let mut at = 0;
    loop {
        let pieces = PIECES[at];
        let found = RULES.map(|rule| Approximation::new(&analysis.curve, &offsets, rule, pieces));
        loop {
            let over = Over::new(picture, |screen: &mut Screen, language: Language| {
                draw(screen, language, &found, pieces);
            });
            let tick = desk.event_asked(&over, Request::Keys(vec![Key::Char('+'), Key::Char('-')])).await?;
            let next = match tick.key() {
                Some(Key::Esc | Key::Enter | Key::F(5)) => return Ok(()),
                Some(Key::Char('+')) => at + 1,
                Some(Key::Char('-')) => at.saturating_sub(1),
                _ => continue,
            };
            at = next.min(PIECES.len() - 1);
            break;
        }
    }
}

fn draw(screen: &mut Screen, language: Language, found: &[Approximation], pieces: usize) {
    for approximation in found {
        for line in &approximation.lines {
            in_field(screen, line, Stroke::thin(approximation.ink));
        }
    }
    let most = found.iter().map(|it| it.largest).fold(1e-12, f64::max);
    let legend = texts::error_legend(most);
    speed::strip(screen, legend.of(language), Color::LightGray);
    for approximation in found {
        speed::plot(screen, &approximation.errors, most, Stroke::thick(approximation.ink));
    }
    page(screen, TOP);
    let (x, y) = (TOP.0 + 8, TOP.1 + 4);
    screen.text(x, y, texts::pieces(pieces).of(language), Color::Black);
    for (row, (approximation, name)) in (1..).zip(found.iter().zip(["Tiller-Hanson", "Hermite"])) {
        screen.bar(x, y + 9 * row, x + 8, y + 9 * row + 7, approximation.ink);
        let error = texts::error(approximation.largest);
        screen.text(x + 14, y + 9 * row, &format!("{name:14}{error}"), Color::Black);
    }
    screen.text(x, y + 28, texts::EXACT.of(language), Color::Blue);
}
