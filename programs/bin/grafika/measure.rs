//! `grafika measure`: the exact length of a PH curve, how it bends, and how far it can be offset; of a surface with
//! Pythagorean normals, its radii of curvature and how far it can be offset.

use crate::curve::CurveArgs;
use crate::normals;
use crate::ph::PhShape;
use crate::source::Answer;
use clap::Args;
use grafika::design::Design;
use grafika::file::number;
use grafika::geometry::ph::{PhCurve, SpacePhCurve};
use grafika::launch::{Failure, progress};
use serde_json::{Value, json};
use std::fmt::Write;

/// The command line of `grafika measure`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika measure A.IP2 --method phspline --closed
  grafika measure A.IC2 --method phhermite -o a.json
  grafika measure N.PN")]
pub(crate) struct Measure {
    #[command(flatten)]
    curve: CurveArgs,
    #[command(flatten)]
    answer: Answer,
}

impl Measure {
    /// Measures and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.answer.apart(&self.curve.source.file)?;
        let json = self.answer.is_json("measures")?;
        let (design, name) = self.curve.design()?;
        if let Design::Net(net) = &design {
            let alive = progress::alive("measuring");
            let measured = normals::measured(net, &name)?;
            drop(alive);
            return match json {
                true => self.answer.write(format!("{measured}\n").as_bytes()),
                false => self.answer.tell(&format!("{}\n", normals::told(&measured).join("\n"))),
            };
        }
        let shape = PhShape::of(&design, &name)?;
        let alive = progress::alive("measuring");
        let text = match (&shape, json) {
            (PhShape::Plane(curve), true) => format!("{}\n", plane_json(curve)),
            (PhShape::Space(curve), true) => format!("{}\n", space_json(curve)),
            (PhShape::Plane(curve), false) => plane_text(curve),
            (PhShape::Space(curve), false) => space_text(curve),
        };
        drop(alive);
        if json { self.answer.write(text.as_bytes()) } else { self.answer.tell(&text) }
    }
}

fn plane_json(curve: &PhCurve) -> Value {
    let extrema = curve.curvature_extrema().into_iter().map(|extremum| {
        let place = extremum.place;
        json!({ "span": place.span, "u": place.u, "kappa": extremum.curvature })
    });
    let inflections =
        curve.inflections().into_iter().map(|place| json!({ "span": place.span, "u": place.u }));
    let spans =
        curve.segments().iter().enumerate().map(
            |(span, segment)| json!({ "length": curve.span_length(span), "control": segment.control() }),
        );
    json!({
        "length": curve.total_length(),
        "energy": curve.energy(),
        "rotation": turning(curve),
        "absolute_rotation": curve.absolute_rotation(),
        "offset_limits": curve.offset_limits(),
        "curvature_extrema": extrema.collect::<Vec<_>>(),
        "inflections": inflections.collect::<Vec<_>>(),
        "spans": spans.collect::<Vec<_>>(),
    })
}

fn space_json(curve: &SpacePhCurve) -> Value {
    let spans =
        curve.segments().iter().enumerate().map(
            |(span, segment)| json!({ "length": curve.span_length(span), "control": segment.control() }),
        );
    json!({
        "length": curve.total_length(),
        "energy": curve.energy(),
        "spans": spans.collect::<Vec<_>>(),
    })
}

/// The angle that a curve turns by to the left. A sum of nothing has no sign.
fn turning(curve: &PhCurve) -> f64 {
    curve.turning() + 0.0
}

/// A number, or that it is infinite.
fn finite(value: Option<f64>) -> String {
    value.map_or_else(|| "infinite".to_owned(), number)
}

fn plane_text(curve: &PhCurve) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let mut line = |name: &str, value: String| {
        let _ = writeln!(text, "{name:18} {value}");
    };
    line("length", number(curve.total_length()));
    line("energy", finite(curve.energy()));
    line("rotation", format!("{} rad to the left", number(turning(curve))));
    line("absolute rotation", format!("{} turns", number(curve.absolute_rotation())));
    let [right, left] = curve.offset_limits();
    let limit = |limit: Option<f64>| limit.map_or_else(|| "any distance".to_owned(), number);
    line("offset to the left", format!("clean up to {}", limit(left)));
    line("offset to the right", format!("clean up to {}", limit(right)));
    for extremum in curve.curvature_extrema() {
        let (place, curvature) = (extremum.place, extremum.curvature);
        let radius = if curvature == 0.0 { "infinite".to_owned() } else { number(1.0 / curvature) };
        line("curvature extremum", format!("radius {radius} at {} of span {}", number(place.u), place.span));
    }
    for place in curve.inflections() {
        line("inflection", format!("at {} of span {}", number(place.u), place.span));
    }
    for span in 0..curve.segments().len() {
        line(&format!("span {span}"), format!("length {}", finite(curve.span_length(span))));
    }
    text
}

fn space_text(curve: &SpacePhCurve) -> String {
    let mut text = format!("length {}\nenergy {}\n", number(curve.total_length()), finite(curve.energy()));
    for span in 0..curve.segments().len() {
        let _ = writeln!(text, "span {span}: length {}", finite(curve.span_length(span)));
    }
    text
}
