//! Rational curves of the plane, such as exact offsets: `.RBC`, which is JSON only.

use super::FileError;
use super::check;
use serde::{Deserialize, Serialize};

/// The offset of a curve, span by span as rational Bézier arcs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RationalSpans {
    /// The distance that the curve was offset by, positive to the left of the direction of travel.
    pub distance: f64,
    /// The length of all spans together.
    pub length: f64,
    /// Whether the last span is followed by the first.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// The spans in order.
    pub spans: Vec<RationalSpan>,
    /// Where the direction turns back.
    #[serde(default)]
    pub cusps: Vec<Cusp>,
    /// Where the curve crosses itself, if that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossings: Option<Vec<SelfCrossing>>,
    /// The stretches that keep the distance, if that was asked for: span and parameter of the start, and of the end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kept: Option<Vec<(usize, f64, usize, f64)>>,
}

/// One rational Bézier arc.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RationalSpan {
    /// The degree, one less than the number of points.
    pub degree: usize,
    /// The points times their weights, and the weights: `[x w, y w, w]`.
    pub homogeneous: Vec<[f64; 3]>,
}

/// A place with its point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cusp {
    /// The span, from 0.
    pub span: usize,
    /// The parameter in the span, 0 to 1.
    pub u: f64,
    /// The point.
    pub x: f64,
    /// The point.
    pub y: f64,
}

/// Two places with the same point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SelfCrossing {
    /// The span of the first place, from 0.
    pub span: usize,
    /// The parameter in the span, 0 to 1.
    pub u: f64,
    /// The span of the second place.
    pub span2: usize,
    /// The parameter in that span.
    pub u2: f64,
    /// The point.
    pub x: f64,
    /// The point.
    pub y: f64,
}

impl RationalSpans {
    /// # Errors
    /// [`FileError::Invalid`] when a number is not finite, a degree and its number of points differ, or a place is on no
    /// span.
    pub(super) fn check(&self) -> Result<(), FileError> {
        let wrong = |problem: String| Err(FileError::Invalid(problem));
        if !self.distance.is_finite() || !self.length.is_finite() {
            return wrong("distance and length must be finite numbers".to_owned());
        }
        for (index, RationalSpan { degree, homogeneous }) in self.spans.iter().enumerate() {
            check::finite(&format!("span {index}, point"), homogeneous)?;
            if homogeneous.len() != degree.saturating_add(1) {
                return wrong(format!(
                    "span {index} has the degree {degree} and {} points; it must have one more than the degree",
                    homogeneous.len()
                ));
            }
        }
        let cusps = self.cusps.iter().map(|cusp| ("cusp", cusp.span, cusp.u));
        let crossings = self.crossings.iter().flatten();
        let crossings = crossings.flat_map(|it| [(it.span, it.u), (it.span2, it.u2)]);
        let crossings = crossings.map(|(span, u)| ("crossing", span, u));
        let kept = self.kept.iter().flatten().flat_map(|&(span, u, end, to)| [(span, u), (end, to)]);
        let kept = kept.map(|(span, u)| ("kept stretch", span, u));
        for (what, span, u) in cusps.chain(crossings).chain(kept) {
            if span >= self.spans.len() || !(0.0..=1.0).contains(&u) {
                return wrong(format!(
                    "a {what} is at {u} of span {span}; parameters are 0 to 1, spans below {}",
                    self.spans.len()
                ));
            }
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let spans = self.spans.len();
        let mut lines = vec![
            format!("rational curve of the plane: {spans} span{}", if spans == 1 { "" } else { "s" }),
            format!("offset by {}, length {}", check::number(self.distance), check::number(self.length)),
        ];
        lines.extend(self.spans.iter().enumerate().map(|(index, span)| {
            let weights = span.homogeneous.iter().map(|point| point[2]);
            let [low, high] = weights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], weight| {
                [low.min(weight), high.max(weight)]
            });
            let [low, high] = [low, high].map(check::number);
            format!("span {index}: degree {}, weights {low} .. {high}", span.degree)
        }));
        let place = |span: usize, u: f64| format!("{} of span {span}", check::number(u));
        lines.extend(self.cusps.iter().map(|cusp| format!("cusp: {}", place(cusp.span, cusp.u))));
        lines.extend(self.crossings.iter().flatten().map(|crossing| {
            format!(
                "crossing: {} and {}",
                place(crossing.span, crossing.u),
                place(crossing.span2, crossing.u2)
            )
        }));
        lines.extend(
            self.kept
                .iter()
                .flatten()
                .map(|&(span, u, end, to)| format!("kept: {} to {}", place(span, u), place(end, to))),
        );
        lines
    }
}
