//! The key F4: all solutions of the same data together, with their bending energy E and absolute rotation R.

use super::{in_field, texts};
use crate::design::Sketch;
use crate::file::Method;
use crate::geometry::ph::{Knots, PhCurve, PhSegment};
use crate::geometry::{Closure, ParamCurve, Point};
use crate::machine::{Asked, Key, Language, Request};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Desk, Over, Phrase, Picture, panel};

/// Colours of the solutions; the chosen one is white.
const INKS: [Color; 4] = [Color::White, Color::LightGreen, Color::LightRed, Color::LightBlue];
/// The knots that a spline may have, in the order of the keys.
const KNOTS: [Knots; 3] = [Knots::Chord, Knots::Uniform, Knots::Centripetal];
/// The list over the picture.
const LIST: (i32, i32) = (36, 64);
const LIST_WIDTH: i32 = 282;
/// Segments of a solution on the screen.
const STEPS: usize = 50;

/// One of the solutions.
struct Solution {
    name: Phrase,
    ink: Color,
    line: Vec<Point<2>>,
    energy: Option<f64>,
    rotation: f64,
    length: f64,
}

impl Solution {
    fn of_segment(name: Phrase, ink: Color, segment: &PhSegment) -> Solution {
        let line = (0..=STEPS).map(|k| segment.at(k as f64 / STEPS as f64)[0]).collect();
        let speed = segment.speed_coefficients();
        Solution {
            name,
            ink,
            line,
            energy: segment.energy(),
            rotation: segment.absolute_rotation(),
            length: speed.iter().sum::<f64>() / speed.len().max(1) as f64,
        }
    }

    fn of_curve(name: Phrase, ink: Color, curve: &PhCurve) -> Solution {
        Solution {
            name,
            ink,
            line: curve.polyline(STEPS).unwrap_or_default(),
            energy: curve.energy(),
            rotation: curve.absolute_rotation(),
            length: curve.total_length(),
        }
    }
}

/// The solutions of a spline: one for every rule for the knots.
fn of_spline(sketch: &Sketch<2>) -> Vec<Solution> {
    let chosen = sketch.knot_rule(Method::PhSpline, Knots::default()).unwrap_or_default();
    let mut others = INKS.into_iter().skip(1);
    let solution = |knots: Knots| {
        let ink = if knots == chosen { INKS[0] } else { others.next().unwrap_or(Color::LightGray) };
        let mut sketch = sketch.clone();
        sketch.settings.knots = Some(knots.into());
        Some(Solution::of_curve(texts::knots(knots), ink, &sketch.ph_curve().ok()?))
    };
    KNOTS.into_iter().filter_map(solution).collect()
}

/// The solutions of one span with its tangents, the chosen one first.
fn of_span(sketch: &Sketch<2>, span: usize) -> Vec<Solution> {
    let ends = [span, (span + 1) % sketch.points.len().max(1)];
    let Some(tangents) = &sketch.tangents else { return Vec::new() };
    let data = ends.map(|at| sketch.points.get(at).copied().zip(tangents.get(at).copied()));
    let [Some((p0, d0)), Some((p1, d1))] = data else { return Vec::new() };
    let segments: Vec<PhSegment> = match sketch.settings.method {
        Some(Method::PhCubic) => PhSegment::cubics([p0, p1], [d0, d1]).unwrap_or_default(),
        _ => PhSegment::hermite([p0, p1], [d0, d1]).map(|(all, _)| all.to_vec()).unwrap_or_default(),
    };
    let cubic = sketch.settings.method == Some(Method::PhCubic);
    let best = sketch.ph_curve().ok().and_then(|curve| curve.segments().get(span).cloned());
    let mut others = INKS.into_iter().skip(1);
    let named = segments.iter().enumerate().map(|(at, segment)| {
        let chosen = best.as_ref().is_some_and(|best| best.preimage() == segment.preimage());
        let ink = if chosen { INKS[0] } else { others.next().unwrap_or(Color::LightGray) };
        Solution::of_segment(texts::solution(at, cubic), ink, segment)
    });
    named.collect()
}

/// Shows the solutions until Esc. Of a spline, a number takes up the knots.
pub(super) async fn show(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    sketch: &Sketch<2>,
) -> Asked<Option<Sketch<2>>> {
    let spline = sketch.settings.method == Some(Method::PhSpline);
    let count = sketch.points.len();
    let spans = if sketch.closure() == Closure::Closed { count } else { count.saturating_sub(1) };
    let mut span = 0;
    let keys = if spline { ['1', '2', '3'].map(Key::Char).to_vec() } else { vec![Key::Left, Key::Right] };
    loop {
        let solutions = if spline { of_spline(sketch) } else { of_span(sketch, span) };
        let title = if spline { texts::ALL_KNOTS.into() } else { texts::all_of_span(span + 1, spans) };
        let over = Over::new(picture, |screen: &mut Screen, language: Language| {
            draw(screen, language, &title, &solutions);
        });
        let tick = desk.event_asked(&over, Request::Keys(keys.clone())).await?;
        match tick.key() {
            Some(Key::Esc | Key::Enter | Key::F(4)) => return Ok(None),
            Some(Key::Right) if !spline => span = (span + 1) % spans.max(1),
            Some(Key::Left) if !spline => span = (span + spans.max(1) - 1) % spans.max(1),
            Some(Key::Char(digit @ '1'..='3')) if spline => {
                let mut chosen = sketch.clone();
                chosen.settings.knots = KNOTS.get(digit as usize - '1' as usize).map(|rule| (*rule).into());
                return Ok(Some(chosen));
            }
            _ => {}
        }
    }
}

fn draw(screen: &mut Screen, language: Language, title: &Phrase, solutions: &[Solution]) {
    let pixel = |at: &Point<2>| super::pixel(*at);
    // The chosen one comes last, over the others.
    for solution in
        solutions.iter().filter(|it| it.ink != INKS[0]).chain(solutions.iter().filter(|it| it.ink == INKS[0]))
    {
        let pixels: Vec<(i32, i32)> = solution.line.iter().map(pixel).collect();
        in_field(screen, &pixels, Stroke::thick(solution.ink));
    }
    let (x, y) = LIST;
    let rows = i32::try_from(solutions.len()).unwrap_or(0);
    panel(screen, x, y, LIST_WIDTH, 20 + 12 * rows);
    screen.text(x + 8, y + 6, title.of(language), Color::Blue);
    for (row, solution) in (0..).zip(solutions) {
        let y = y + 19 + 12 * row;
        screen.bar(x + 8, y, x + 18, y + 7, solution.ink);
        screen.text(x + 24, y, solution.name.of(language), Color::Black);
        let facts = texts::facts(solution.energy, solution.rotation, solution.length);
        screen.text(x + 92, y, &facts, Color::Black);
    }
}
