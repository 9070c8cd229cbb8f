//! Curves for several values of one parameter together, each in its colour (figures 2.5, 2.24, 2.25, 2.32), and the
//! names of all curves that are compared.

use super::compare::Kind;
use super::{Ambient, Curves, Tools};
use crate::design::{Place, Sketch};
use crate::editor::picture::Page;
use crate::editor::{Editor, refusal, values};
use crate::file::Method;
use crate::geometry::Point;
use crate::machine::Asked;
use crate::screen::Color;
use crate::ui::tint;
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, Question, Stay, TOP};
use serde::Serialize;
use std::ops::RangeInclusive;

/// A parameter that can have several values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Parameter {
    K0,
    Bias,
    Tension,
}

/// The values of a parameter whose curves are shown together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Series {
    parameter: Parameter,
    values: Vec<f64>,
}

/// Curves of a series at most.
const MOST: usize = 6;

impl Parameter {
    fn name(self) -> words::Words {
        match self {
            Parameter::K0 => words::K0_NAME,
            Parameter::Bias => words::BIAS_NAME,
            Parameter::Tension => words::TENSION_NAME,
        }
    }

    /// What curves are called by.
    fn letter(self) -> &'static str {
        match self {
            Parameter::K0 => "k0",
            Parameter::Bias => "bias",
            Parameter::Tension => "tension",
        }
    }

    fn allowed(self) -> RangeInclusive<f64> {
        match self {
            Parameter::K0 => values::K0.range(),
            Parameter::Bias => values::BIAS.range(),
            Parameter::Tension => values::TENSION.range(),
        }
    }

    /// The sketch with a value of the parameter.
    fn of<const D: usize>(self, sketch: &Sketch<D>, value: f64) -> Sketch<D> {
        let mut sketch = sketch.clone();
        match self {
            Parameter::K0 => sketch.settings.k0 = Some(value),
            Parameter::Bias => return sketch.with_shape(|shape| shape.bias = value),
            Parameter::Tension => return sketch.with_shape(|shape| shape.tension = value),
        }
        let automatic = sketch.tangents.is_some().then(|| sketch.with_automatic_tangents(sketch.closure()));
        automatic.and_then(Result::ok).unwrap_or(sketch)
    }
}

/// A curve beside the chosen one.
pub(super) struct Beside<const D: usize> {
    pub(super) sketch: Sketch<D>,
    pub(super) method: Method,
    pub(super) name: String,
    pub(super) ink: Color,
}

/// Reads values that stand beside each other, with blanks, commas or semicolons between.
fn read(parameter: Parameter, text: &str) -> Result<Vec<f64>, Phrase> {
    let separates = |letter: char| letter.is_whitespace() || [',', ';'].contains(&letter);
    let mut values = Vec::new();
    for word in text.split(separates).filter(|word| !word.is_empty()) {
        let value: Option<f64> = word.parse().ok();
        let Some(value) = value.filter(|value| parameter.allowed().contains(value)) else {
            return Err(words::wrong_value(word, &parameter.allowed()));
        };
        if !values.contains(&value) {
            values.push(value);
        }
    }
    match values.len() {
        0..=MOST => Ok(values),
        count => Err(words::too_many_values(count, MOST)),
    }
}

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// The key F4 of programs with one method: values of its parameter whose curves are shown together.
    pub(super) async fn ask_series(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let parameter = match self.craft.tools {
            Tools::Beta => {
                let answers = [words::BIAS_ANSWER, words::TENSION_ANSWER];
                match desk.ask(self, &Question::new(TOP, words::ASK_SERIES, answers)).await? {
                    Answer::First => Parameter::Bias,
                    Answer::Second => Parameter::Tension,
                }
            }
            _ => Parameter::K0,
        };
        let shown = |series: &Series| series.values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
        let before = self.craft.series.as_ref().filter(|series| series.parameter == parameter);
        let proposal = before.map(shown).unwrap_or_default();
        let caption = words::series_of(parameter.name());
        let values = desk.meaning(self, caption, &proposal, |text| read(parameter, text)).await?;
        // What has no curve is told; the others are shown.
        let wrong =
            values.iter().find_map(|&value| parameter.of(&self.drawn(), value).check_parameters().err());
        if let Some(error) = wrong {
            desk.tell(refusal::of_curve(&error.into()), Stay::UntilRead);
        }
        self.craft.series = Some(Series { parameter, values }).filter(|series| !series.values.is_empty());
        Ok(())
    }

    /// The curves beside the chosen one: other methods, then other values.
    pub(super) fn beside(&self) -> Vec<Beside<D>> {
        let mut open = self.preview();
        open.settings.closed = open.settings.closed.filter(|_| !self.craft.measured);
        let kinds = Kind::ALL.into_iter().filter(|(kind, ..)| self.craft.compared.contains(kind));
        let of_kind = |(kind, name, ink): (Kind, &'static str, Color)| Beside {
            sketch: open.by(kind.method()),
            method: kind.method(),
            name: name.to_owned(),
            ink,
        };
        let kinds = kinds.map(of_kind);
        let series = self.craft.series.as_ref().filter(|_| !self.craft.measured);
        let of_value = |(value, ink): (&f64, Color), parameter: Parameter| {
            let method = match parameter {
                Parameter::K0 if self.craft.tools == Tools::Tangents => Method::Hermite,
                Parameter::K0 => Method::Coons,
                Parameter::Bias | Parameter::Tension => Method::Beta,
            };
            Beside {
                sketch: parameter.of(&self.drawn(), *value).by(method),
                method,
                name: format!("{}={value}", parameter.letter()),
                ink,
            }
        };
        let values = series.into_iter().flat_map(|series| {
            series.values.iter().zip(tint::LINES).map(move |value| of_value(value, series.parameter))
        });
        kinds.chain(values).collect()
    }

    /// The names of the compared curves in their colours, two to a line.
    pub(super) fn draw_names(&self, page: &mut Page<'_>, (x, y): (i32, i32), ink: Color) {
        let beside = self.beside();
        // More than six are three to a line.
        let (columns, width, mark) = if beside.len() > 6 { (3, 76, 6) } else { (2, 116, 12) };
        for (place, beside) in (0..).zip(&beside) {
            let (x, y) = (x + width * (place % columns), y + 11 * (place / columns));
            page.screen.bar(x, y, x + mark, y + 7, beside.ink);
            page.screen.text(x + mark + mark / 2, y, &beside.name, ink);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Language;

    #[test]
    fn values_are_read_or_refused_with_the_reason() {
        assert_eq!(read(Parameter::K0, " 0.3, 0.5;1 1 -5"), Ok(vec![0.3, 0.5, 1.0, -5.0]));
        assert_eq!(read(Parameter::Tension, ""), Ok(Vec::new()));
        let refused = |parameter, text| read(parameter, text).unwrap_err().of(Language::English).to_owned();
        assert_eq!(refused(Parameter::Bias, "1 0"), "\"0\" is not a number from 0.05 to 20");
        assert_eq!(refused(Parameter::K0, "nan"), "\"nan\" is not a number from -10 to 10");
        assert_eq!(refused(Parameter::K0, "1 2 3 4 5 6 7"), "7 values are too many: 6 at most");
    }
}
