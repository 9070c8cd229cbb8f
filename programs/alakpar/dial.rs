//! The windows of the parameters and the slider: typed numbers, the wheel, the mouse.

use super::commands::WINDOWS;
use super::craft::Bench;
use super::form::Form;
use super::kinds::{Knob, of_name};
use super::room::{Here, Room};
use super::texts;
use crate::design::Place;
use crate::editor::picture::Page;
use crate::file::Places;
use crate::geometry::Point;
use crate::geometry::shaped::Parameter;
use crate::machine::{Event, Key, Tick};
use crate::screen::Color;
use crate::ui::{Area, Desk, Slider, Stay, window};
use serde::Serialize;

/// The slider's track, and where the mouse takes its knob up.
const TRACK: (i32, i32, i32) = (54, 152, 34);
const SLIDER: Area = Area::new(48, 28, 158, 40);
/// Scales of the comb of curvature.
const COMB: [f64; 2] = [20.0, 1e6];

/// A value as a place, which the editor drags.
pub(super) fn as_place<const D: usize>(value: f64) -> Point<D> {
    std::array::from_fn(|axis| if axis == 0 { value } else { 0.0 })
}

/// The value of such a place.
pub(super) fn of_place<const D: usize>(place: Point<D>) -> f64 {
    place.first().copied().unwrap_or(0.0)
}

/// The potentiometer of a parameter.
pub(super) fn slider(knob: &Knob) -> Slider {
    Slider { range: knob.range, allowed: knob.allowed, step: knob.step, track: TRACK }
}

/// Whether a pixel is on the slider.
pub(super) fn on_slider((x, y): (i32, i32)) -> bool {
    SLIDER.holds(x, y)
}

/// The number of the window at a pixel.
pub(super) fn window_at((x, y): (i32, i32)) -> Option<usize> {
    WINDOWS.iter().position(|window| window.holds(x, y))
}

/// Takes up the wheel over a window or the slider, the keys that turn the parameter, and those of the comb.
pub(super) fn attended<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>, tick: &Tick) -> bool
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let at = (tick.mouse.x, tick.mouse.y);
    editor.craft.mouse = at;
    let steps = match (tick.event, tick.key()) {
        (Some(Event::Wheel(steps)), _) if window_at(at).is_some() || on_slider(at) => {
            let knobs = editor.knobs();
            match window_at(at) {
                Some(number) if number >= knobs.len() => return true,
                Some(number) => editor.craft.active = number,
                None => {}
            }
            f64::from(steps)
        }
        (_, Some(Key::PageUp)) => 1.0,
        (_, Some(Key::PageDown)) => -1.0,
        (_, Some(Key::Char('.'))) => 0.1,
        (_, Some(Key::Char(','))) => -0.1,
        (_, Some(Key::Char(sign @ ('+' | '-')))) => {
            let factor = if sign == '+' { 1.25 } else { 0.8 };
            let comb = &mut editor.craft.options.comb;
            *comb = comb.map(|scale| (scale * factor).clamp(COMB[0], COMB[1]));
            return comb.is_some();
        }
        _ => return false,
    };
    turn(editor, desk, steps);
    true
}

/// Turns the parameter by steps.
fn turn<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>, steps: f64)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now();
    let Some(knob) = editor.knob() else {
        desk.tell(texts::no_parameter(form.family()), Stay::Briefly);
        return;
    };
    let Some(value) = form.value(knob.parameter) else {
        desk.tell(texts::WHICH_LAMBDA, Stay::UntilRead);
        return;
    };
    if let Ok(next) = form.with(knob.parameter, slider(&knob).stepped(value, steps)) {
        editor.change(next);
    }
}

/// Draws family, windows and slider.
pub(super) fn draw<const D: usize>(editor: &Bench<D>, page: &mut Page<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let (form, knobs, language) = (editor.drawn(), editor.knobs(), page.language);
    let screen = &mut *page.screen;
    let names: Vec<String> = knobs.iter().map(name).collect();
    let title = format!("{}  {}", of_name(form.family()).title.of(language), names.join(" "));
    screen.text(8, 3, title.trim_end(), Color::Black);
    let active = editor.knob();
    for ((area, letter), at) in WINDOWS.into_iter().zip(["A", "C"]).zip(0..) {
        window(screen, area);
        let Some(knob) = knobs.get(at) else { continue };
        let ink = if active.as_ref() == Some(knob) { Color::Yellow } else { Color::White };
        screen.text(area.x1 + 4, area.y1 + 4, letter, Color::LightRed);
        let value = shown(&form, knob, language);
        screen.text(area.x1 + 18, area.y1 + 4, &value, ink);
    }
    let Some(knob) = active else { return };
    let (_, right, y) = TRACK;
    let [low, high] = knob.range.map(|end| texts::short((100.0 * end).round() / 100.0));
    let width = 8 * i32::try_from(low.len()).unwrap_or(0);
    screen.text(46 - width, y - 3, &low, Color::Black);
    screen.text(right + 10, y - 3, &high, Color::Black);
    slider(&knob).draw(screen, form.value(knob.parameter), false);
}

/// The name of a parameter, with the number of its point.
pub(super) fn name(knob: &Knob) -> String {
    match knob.parameter {
        Parameter::LambdaOf(index) => format!("{} {}", knob.name, index + 1),
        _ => knob.name.to_owned(),
    }
}

fn shown<const D: usize>(form: &Form<D>, knob: &Knob, language: crate::machine::Language) -> String {
    match form.value(knob.parameter) {
        Some(value) => texts::number(value),
        None => texts::EACH.of(language).to_owned(),
    }
}
