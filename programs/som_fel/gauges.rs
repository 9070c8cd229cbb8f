//! What stands around the picture: the map of wins, gain and radius, the message page, the legend of the errors.

use super::paint::{ABOVE, BELOW};
use super::run::Run;
use super::state::{Source, State};
use super::texts;
use super::trainer::Trainer;
use crate::geometry::fit::{ErrorClass, Stage};
use crate::geometry::kohonen::Schedule;
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Area, TOP, page, tint, window};

/// The map of the net, and the room of its cells.
const MAP: Area = Area::new(5, 4, 91, 50);
const MAP_ROOM: (i32, i32) = (82, 42);
/// Gain and radius over t.
const STRIP: Area = Area::new(29, 446, 589, 471);
/// Pixels between two places of its lines.
const STRIP_STEP: i32 = 4;
/// Upper left corner of the legend, and its rows.
const LEGEND: (i32, i32) = (558, 144);
const LEGEND_ROW: i32 = 13;
/// Letters on a line of the message page.
const LETTERS: usize = 28;

/// Draws all of it.
pub(super) fn draw(trainer: &Trainer, screen: &mut Screen, language: Language) {
    draw_map(trainer, screen);
    draw_values(trainer, screen, language);
    draw_strip(trainer, screen);
    draw_errors(trainer, screen, Color::Black);
    page(screen, TOP);
    // In the manner of today, the first two lines say what can be done where there is no net.
    for (row, line) in (0..).zip(lines(trainer, language)) {
        let line: String = line.chars().take(LETTERS).collect();
        screen.text(TOP.0 + 8, TOP.1 + 7 + 11 * row, &line, Color::Black);
    }
}

/// A colour for every neuron, by how often it has won.
fn draw_map(trainer: &Trainer, screen: &mut Screen) {
    window(screen, MAP);
    let Some(net) = trainer.net() else { return };
    let wins = trainer.learning().map(|learning| learning.wins()).unwrap_or_default();
    let most = wins.iter().copied().max().unwrap_or(0);
    let [rows, columns] = net.size();
    // A polygon of one column lies along the map.
    let lies = columns == 1;
    let [down, across] = if lies { [1, rows] } else { [rows, columns] };
    let size = |count: usize| i32::try_from(count).unwrap_or(i32::MAX).max(1);
    let cell = (MAP_ROOM.0 / size(across)).min(MAP_ROOM.1 / size(down)).min(12);
    let (width, height) = match cell {
        0 => (size(across).min(MAP_ROOM.0), size(down).min(MAP_ROOM.1)),
        cell => (cell * size(across), cell * size(down)),
    };
    let (left, top) = ((MAP.x1 + MAP.x2 - width) / 2, (MAP.y1 + MAP.y2 - height) / 2);
    let index = |place: i32, of: i32, count: usize| (place as usize * count) / of.max(1) as usize;
    let step = cell.max(1);
    for y in (0..height).step_by(step as usize) {
        for x in (0..width).step_by(step as usize) {
            let (i, j) = (index(y, height, down), index(x, width, across));
            let at = if lies { j } else { i * columns + j };
            let color = match wins.get(at) {
                Some(&wins) if wins > 0 => tint::height(wins as f64 / most.max(1) as f64),
                _ => Color::DarkGray,
            };
            screen.bar(left + x, top + y, left + x + step - 1, top + y + step - 1, color);
        }
    }
}

fn draw_values(trainer: &Trainer, screen: &mut Screen, language: Language) {
    let Some(step) = trainer.learning().and_then(|learning| learning.last()) else { return };
    let values = [(texts::GAIN, format!("{:.3}", step.gain)), (texts::RADIUS, format!("{:.2}", step.radius))];
    for (row, (name, value)) in (0..).zip(values) {
        screen.text(98, 14 + 16 * row, name.of(language), Color::Black);
        screen.text(154, 14 + 16 * row, &value, Color::Blue);
    }
}

/// Gain (green) and radius (yellow) from their largest values down to 0, and where learning is.
fn draw_strip(trainer: &Trainer, screen: &mut Screen) {
    window(screen, STRIP);
    let (left, right) = (STRIP.x1 + 3, STRIP.x2 - 3);
    let (top, bottom) = (STRIP.y1 + 3, STRIP.y2 - 3);
    let learning = trainer.learning();
    let Some(schedule) = learning.map(|it| *it.schedule()).or_else(|| planned(trainer.state())) else {
        return;
    };
    let steps = schedule.steps();
    let t = |x: i32| (steps as f64 * f64::from(x - left) / f64::from(right - left)) as u64;
    let mut curve = |value: &dyn Fn(u64) -> f64, ink: Color| {
        let largest = value(0).max(f64::MIN_POSITIVE);
        let y = |x: i32| {
            let part = (value(t(x)) / largest).clamp(0.0, 1.0);
            bottom - (part * f64::from(bottom - top)).round() as i32
        };
        let pixels: Vec<(i32, i32)> =
            (left..=right).step_by(STRIP_STEP as usize).map(|x| (x, y(x))).collect();
        screen.polyline(&pixels, Stroke::thin(ink));
    };
    curve(&|t| schedule.gain(t), Color::LightGreen);
    curve(&|t| schedule.radius(t), Color::Yellow);
    if let Some(learning) = learning {
        let part = learning.t() as f64 / steps.max(1) as f64;
        let x = left + (part.min(1.0) * f64::from(right - left)).round() as i32;
        screen.line(x, top, x, bottom, Stroke::thin(Color::LightRed));
    }
}

/// Gain and radius of the learning that T would begin.
fn planned(state: &State) -> Option<Schedule> {
    let (settings, rule) = (&state.settings, state.settings.rule());
    let [rows, columns] = settings.size;
    let radius = rule.radius.unwrap_or(rows.max(columns) as f64 / 2.0);
    let steps = rule.steps.unwrap_or(100 * (rows * columns) as u64);
    Schedule::new(rule.weighting, steps, radius).ok()
}

/// The colours of the errors with their limits, in the unit of the points.
pub(super) fn draw_errors(trainer: &Trainer, screen: &mut Screen, text: Color) {
    let (x, mut y) = LEGEND;
    let rms = trainer.surface().and_then(|it| it.fit.as_ref()).map(|fit| fit.report.rms);
    if let Some(rms) = rms.filter(|_| trainer.shows_errors()) {
        let limit = |level: usize| match level.checked_sub(1).and_then(|at| ErrorClass::LIMITS.get(at)) {
            Some(limit) => texts::short(limit * rms),
            None => "0".to_owned(),
        };
        let above = (0..ErrorClass::LEVELS).rev().map(|level| (ABOVE[level], format!("+{}", limit(level))));
        let below = (0..ErrorClass::LEVELS).map(|level| (BELOW[level], format!("-{}", limit(level))));
        for (ink, from) in above.chain(below) {
            screen.bar(x, y, x + 9, y + 9, Color::Black);
            screen.bar(x + 1, y + 1, x + 8, y + 8, ink);
            screen.text(x + 13, y + 1, &from, text);
            y += LEGEND_ROW;
        }
    }
}

/// What stands on the message page.
fn lines(trainer: &Trainer, language: Language) -> [String; 3] {
    let percent = |part: f64| format!("{:.0} %", 100.0 * part);
    let cloud = cloud_line(trainer.state(), language);
    let learnt = trainer.learning().map(|learning| {
        let step = texts::STEP_WORD.of(language);
        let (total, t) = (texts::grouped(learning.total()), texts::grouped(learning.schedule().steps()));
        let first = match learning.is_growing() {
            true => format!("{step} {total}, {}", percent(learning.progress())),
            false => format!("{step} {} / {t}", texts::grouped(learning.t())),
        };
        (first, learning.rms())
    });
    let size = trainer.net().map(|net| {
        let [rows, columns] = net.size();
        format!("{rows} x {columns} {}", texts::topology(net.topology()).of(language))
    });
    match &trainer.run {
        Run::Reading(reading) => {
            let part = reading.progress().map(percent).unwrap_or_default();
            let points = texts::grouped(reading.points() as u64);
            [
                reading.name.clone(),
                format!("{} {part}", texts::READING.of(language)),
                format!("{points} {}", texts::POINTS.of(language)),
            ]
        }
        Run::Slow(slow) => {
            let part = slow.part(trainer.now).clamp(0.0, 3.0) as usize;
            let told = texts::STEP_PARTS.get(part).map_or("", |words| words.of(language));
            let (step, rms) = learnt.unwrap_or_default();
            [told.to_owned(), step, rms_line(rms)]
        }
        Run::Fitting(fit) => {
            let solution = fit.history().len() + usize::from(fit.stage() != Stage::Done);
            let part = percent(fit.progress());
            let first = format!("{} {solution}: {part}", texts::FITTING.of(language));
            [first, rms_line(fit.history().last().copied()), cloud]
        }
        Run::Nothing | Run::Learning(_) => {
            if let Some(fit) = trainer.surface().and_then(|surface| surface.fit.as_ref()) {
                let [rms, largest, mean, most] =
                    [fit.report.rms, fit.report.largest, fit.report.mean, fit.report.percentile_95]
                        .map(texts::short);
                let first = format!("RMS {rms}  {} {largest}", texts::LARGEST.of(language));
                return [first, format!("95 % {most}  {} {mean}", texts::MEAN.of(language)), cloud];
            }
            match learnt {
                Some((step, rms)) => {
                    let size = size.unwrap_or_default();
                    let short = rms.map(|rms| format!("RMS {}  ", texts::short(rms))).unwrap_or_default();
                    [step, format!("{short}{size}"), cloud]
                }
                None => [size.unwrap_or_default(), String::new(), cloud],
            }
        }
    }
}

fn rms_line(rms: Option<f64>) -> String {
    rms.map(|rms| format!("RMS {}", texts::short(rms))).unwrap_or_default()
}

/// The name of the cloud and the number of its points.
fn cloud_line(state: &State, language: Language) -> String {
    let Some(named) = &state.cloud else { return String::new() };
    let points = texts::grouped(named.cloud.points().len() as u64);
    let name = match &named.source {
        Source::File(name) => name.chars().take(12).collect(),
        Source::Made(recipe) => texts::shape(recipe.shape()).of(language).to_owned(),
    };
    format!("{name}: {points} {}", texts::POINTS.of(language)).trim_start_matches(": ").to_owned()
}
