//! A stretch of an offset as a curve of its own, such as the parts that trimming keeps.

use super::curve::Place;
use super::offset::Offset;
use super::rational::RationalArc;
use super::trim::Trimmed;
use crate::geometry::cubic::check_arcs;
use crate::geometry::param::{add_cubics, check_tolerance, clipped};
use crate::geometry::{CubicBezier, GeometryError, ParamCurve, Point};

/// The part of an offset between two places. Its spans are the pieces of the offset's spans.
#[derive(Clone, Debug)]
pub struct OffsetPart<'a> {
    offset: &'a Offset,
    /// A span of the offset and the range of its parameter.
    pieces: Vec<(usize, [f64; 2])>,
    closed: bool,
}

/// Pieces shorter than this, in the parameter, are none.
const SHORTEST: f64 = 1e-11;

impl Offset {
    /// The part from one place to a later one.
    #[must_use]
    pub fn part(&self, [from, to]: [Place; 2]) -> OffsetPart<'_> {
        let spans = ParamCurve::spans(self);
        let pieces: Vec<(usize, [f64; 2])> = (from.span..=to.span.min(spans.saturating_sub(1)))
            .map(|span| {
                let start = if span == from.span { clipped(from.u) } else { 0.0 };
                let end = if span == to.span { clipped(to.u) } else { 1.0 };
                (span, [start, end])
            })
            .filter(|(span, [start, end])| *span < spans && end - start > SHORTEST)
            .collect();
        let whole = pieces.len() == spans && pieces.iter().all(|(_, range)| *range == [0.0, 1.0]);
        OffsetPart { offset: self, pieces, closed: whole && ParamCurve::closed(self) }
    }

    /// The parts that trimming keeps.
    pub fn parts<'a>(&'a self, trimmed: &'a Trimmed) -> impl Iterator<Item = OffsetPart<'a>> {
        trimmed.kept.iter().map(|&stretch| self.part(stretch))
    }

    /// Cubic arcs of a piece of a span, cut at cusps and inflections of the curve, where no arc could follow.
    pub(super) fn add_cubics_of(
        &self,
        (span, [from, to]): (usize, [f64; 2]),
        tolerance: f64,
        arcs: &mut Vec<CubicBezier<2>>,
    ) -> Result<(), GeometryError> {
        let Some(segment) = self.curve().segments().get(span) else { return Ok(()) };
        let mut cuts: Vec<f64> = self.cusps_of_span(span).chain(segment.inflections()).collect();
        cuts.retain(|cut| *cut > from + SHORTEST && *cut < to - SHORTEST);
        cuts.sort_by(f64::total_cmp);
        let mut start = from;
        for end in cuts.into_iter().chain([to]) {
            let length = end - start;
            add_cubics(&|u| ParamCurve::eval(self, span, start + length * u), tolerance, arcs)?;
            start = end;
        }
        Ok(())
    }
}

impl OffsetPart<'_> {
    /// The place of the offset that is at `u` of a span of the part; `None` outside its spans.
    #[must_use]
    pub fn place(&self, span: usize, u: f64) -> Option<Place> {
        let (span, [from, to]) = *self.pieces.get(span)?;
        Some(Place { span, u: from + (to - from) * clipped(u) })
    }

    /// The exact rational form of every span of the part.
    #[must_use]
    pub fn arcs(&self) -> Vec<RationalArc> {
        let arcs = self.offset.arcs();
        self.pieces.iter().filter_map(|&(span, range)| arcs.get(span)?.part(range)).collect()
    }
}

impl ParamCurve<2> for OffsetPart<'_> {
    fn spans(&self) -> usize {
        self.pieces.len()
    }

    fn closed(&self) -> bool {
        self.closed
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let place = self.place(span, u)?;
        let (_, [from, to]) = self.pieces.get(span)?;
        let [point, slope, bend] = self.offset.at(place.span, place.u)?;
        let length = to - from;
        Some([point, slope.map(|x| x * length), bend.map(|x| x * length * length)])
    }

    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<2>>, GeometryError> {
        check_tolerance(tolerance)?;
        let mut arcs = Vec::new();
        for &piece in &self.pieces {
            self.offset.add_cubics_of(piece, tolerance, &mut arcs)?;
        }
        check_arcs(arcs)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Knots, PhCurve, SplineEnd, SplineEnds};
    use super::*;
    use crate::geometry::norm;

    fn bay() -> PhCurve {
        let points =
            [[60.0, 120.0], [150.0, 300.0], [250.0, 170.0], [330.0, 110.0], [420.0, 190.0], [500.0, 320.0]];
        PhCurve::spline(Knots::Chord, SplineEnds::Open([SplineEnd::Cubic; 2]), &points).unwrap()
    }

    #[test]
    fn the_parts_of_the_bay() {
        let curve = bay();
        let offset = curve.offset(60.0).unwrap();
        let trimmed = offset.trimmed();
        let parts: Vec<OffsetPart<'_>> = offset.parts(&trimmed).collect();
        // (0,0)-(2,0.7119) and (3,0.2413)-(4,1), which meet in the crossing.
        assert_eq!(parts.iter().map(ParamCurve::spans).collect::<Vec<_>>(), [3, 2]);
        let [end, start] = [parts[0].eval(2, 1.0).unwrap(), parts[1].eval(0, 0.0).unwrap()];
        assert!(norm([0, 1].map(|d| end[d] - start[d])) < 1e-9);
        assert!(!parts[0].closed());
        assert_eq!(parts[1].place(1, 0.5), Some(Place { span: 4, u: 0.5 }));
    }

    #[test]
    fn cubics_follow_offsets_with_cusps() {
        let curve = bay();
        for d in [-70.0, -40.0, 60.0] {
            let offset = curve.offset(d).unwrap();
            for tolerance in [1e-2, 1e-5] {
                let arcs = ParamCurve::to_cubics(&offset, tolerance).unwrap();
                assert!(arcs.len() < 600, "{}", arcs.len());
                for cusp in offset.cusps() {
                    let point = ParamCurve::eval(&offset, cusp.span, cusp.u).unwrap();
                    let near = |arc: &CubicBezier<2>| norm([0, 1].map(|d| arc.p[3][d] - point[d])) < 1e-9;
                    assert!(arcs.iter().any(near), "an arc ends at every cusp");
                }
            }
        }
        assert!(ParamCurve::to_cubics(&curve.offset(5.0).unwrap(), 0.0).is_err());
    }
}
