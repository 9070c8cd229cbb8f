//! Exact offsets as documents, and back.

use crate::file::{Cusp, RationalSpan, RationalSpans, SelfCrossing};
use crate::geometry::ph::{Offset, Place, RationalArc, RationalCurve, Trimmed};
use crate::geometry::{GeometryError, ParamCurve};

/// The document of an offset; with `trimmed`, it says which stretches keep the distance.
#[must_use]
pub fn document(offset: &Offset, trimmed: Option<&Trimmed>) -> RationalSpans {
    let arcs = offset.arcs();
    let spans =
        arcs.iter().map(|arc| RationalSpan { degree: arc.degree(), homogeneous: arc.homogeneous().to_vec() });
    let cusp = |&Place { span, u }: &Place| {
        let [x, y] = ParamCurve::eval(offset, span, u)?;
        Some(Cusp { span, u, x, y })
    };
    let crossings = trimmed.map(|Trimmed { crossings, .. }| {
        let crossing = crossings.iter().map(|crossing| {
            let ([first, second], [x, y]) = (crossing.places, crossing.point);
            SelfCrossing { span: first.span, u: first.u, span2: second.span, u2: second.u, x, y }
        });
        crossing.collect()
    });
    let kept = trimmed.map(|Trimmed { kept, .. }| {
        kept.iter().map(|[from, to]| (from.span, from.u, to.span, to.u)).collect()
    });
    RationalSpans {
        distance: offset.distance(),
        length: offset.length(),
        closed: ParamCurve::closed(offset),
        spans: spans.collect(),
        cusps: offset.cusps().iter().filter_map(cusp).collect(),
        crossings,
        kept,
    }
}

/// The curve of a document: all of it, or where it says so only the stretches that keep the distance.
///
/// # Errors
/// Those of [`RationalCurve::new`].
pub fn curve(document: &RationalSpans) -> Result<RationalCurve, GeometryError> {
    let arcs = document.spans.iter().map(|span| RationalArc::new(span.homogeneous.clone()));
    let whole = RationalCurve::new(arcs.collect(), document.closed)?;
    let Some(kept) = &document.kept else { return Ok(whole) };
    let all = kept.len() == 1 && kept[0] == (0, 0.0, document.spans.len().saturating_sub(1), 1.0);
    if all {
        return Ok(whole);
    }
    let mut parts = Vec::new();
    for &(start, from, end, to) in kept {
        for (span, arc) in whole.arcs().iter().enumerate().take(end.saturating_add(1)).skip(start) {
            let from = if span == start { from } else { 0.0 };
            let to = if span == end { to } else { 1.0 };
            parts.extend(arc.part([from, to]));
        }
    }
    RationalCurve::new(parts, false)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Sketch;
    use crate::file::{Document, Method};

    #[test]
    fn an_offset_comes_back_from_its_document() {
        let points = vec![
            [60.0, 120.0],
            [150.0, 300.0],
            [250.0, 170.0],
            [330.0, 110.0],
            [420.0, 190.0],
            [500.0, 320.0],
        ];
        let sketch = Sketch { points, ..Sketch::default() }.by(Method::PhSpline);
        let offset = sketch.ph_curve().unwrap().offset(60.0).unwrap();
        let trimmed = offset.trimmed();
        for trimmed in [None, Some(&trimmed)] {
            let spans = document(&offset, trimmed);
            let text = Document::Rational(Box::new(spans.clone())).to_json().unwrap();
            assert_eq!(Document::from_json(&text), Ok(Document::Rational(Box::new(spans.clone()))));
            let curve = curve(&spans).unwrap();
            assert_eq!(curve.spans(), 5, "2 + 3 spans in two stretches, or all five");
            let (found, want) = match trimmed {
                None => (curve.eval(3, 0.5), ParamCurve::eval(&offset, 3, 0.5)),
                Some(trimmed) => {
                    let [from, to] = trimmed.kept[1];
                    assert_eq!((from.span, to.span), (3, 4));
                    (curve.eval(3, 0.5), ParamCurve::eval(&offset, 3, 0.5 * (from.u + 1.0)))
                }
            };
            let ([x, y], [a, b]) = (found.unwrap(), want.unwrap());
            assert!((x - a).hypot(y - b) < 1e-10);
        }
        let mut nothing = document(&offset, Some(&trimmed));
        nothing.kept = Some(Vec::new());
        assert_eq!(curve(&nothing).unwrap().spans(), 0);
    }
}
