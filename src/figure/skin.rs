//! Skins of circles in a figure and for CAD programs: their arcs exactly, and the caps of their end circles.

use super::picture::{Figure, Style};
use super::plot::tolerance;
use super::step_curve::StepCurve;
use crate::geometry::ph::RationalArc;
use crate::geometry::skin::{Cap, Circle, Outline, Piece};
use crate::geometry::{Closure, CubicBezier, GeometryError, ParamCurve, Point};
use std::f64::consts::{FRAC_PI_2, TAU};

const DISC_INK: [u8; 3] = [150, 150, 150];
const DISC_WIDTH: f64 = 1.0;
const SKIN_WIDTH: f64 = 2.0;
/// What a skin is filled with.
const FILLING: [u8; 3] = [214, 222, 246];
const PAPER: [u8; 3] = [255, 255, 255];
/// Steps of a piece for the area that an outline encloses.
const STEPS: usize = 8;

impl Figure {
    /// Adds the rims of circles, with their numbers from 1 on at the middles.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`].
    pub fn plot_discs(&mut self, circles: &[Circle]) -> Result<(), GeometryError> {
        circles.iter().zip(1..).try_for_each(|(circle, number)| self.plot_disc(circle, number))
    }

    /// Adds the rim of a circle with its number.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`].
    pub fn plot_disc(&mut self, circle: &Circle, number: usize) -> Result<(), GeometryError> {
        self.curve(cubics(&whole(circle))?, Closure::Closed, Style::line(DISC_INK, DISC_WIDTH));
        self.disc(circle.center, 1.0, Style::filled(DISC_INK, DISC_INK), Some(number.to_string()));
        Ok(())
    }

    /// Adds an outline of a skin: its arcs exactly, the caps within a tolerance that no picture shows. A filled one has
    /// the discs inside; an outline that runs the other way round is the border of a hole.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`].
    pub fn plot_outline(
        &mut self,
        outline: &Outline,
        ink: [u8; 3],
        filled: bool,
    ) -> Result<(), GeometryError> {
        let arcs = cubics(&outline.pieces)?;
        let closure = if outline.closed { Closure::Closed } else { Closure::Open };
        let line = Style::line(ink, SKIN_WIDTH);
        let fill = if is_hole(outline) { PAPER } else { FILLING };
        let style = Style { fill: Some(fill).filter(|_| filled && outline.closed), ..line };
        self.curve(arcs, closure, style);
        Ok(())
    }
}

/// An outline as rational cubic arcs: all of it exactly.
#[must_use]
pub fn outline_step(outline: &Outline) -> StepCurve {
    let weighted = |[x, y]: Point<2>| [x, y, 1.0];
    let arcs = outline.pieces.iter().flat_map(|piece| match piece {
        Piece::Arc(arc) => vec![RationalArc::new(arc.bezier.p.map(weighted).to_vec())],
        Piece::Cap(cap) => rational(cap),
    });
    StepCurve { arcs: arcs.collect(), closed: outline.closed }
}

/// The cubic arcs of pieces.
fn cubics(pieces: &[Piece]) -> Result<Vec<CubicBezier<2>>, GeometryError> {
    let mut arcs = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Arc(arc) => arcs.push(arc.bezier),
            Piece::Cap(_) => {
                let cap = Outline { pieces: vec![*piece], closed: false };
                arcs.extend(cap.to_cubics(tolerance(cap.bounding_box()))?);
            }
        }
    }
    Ok(arcs)
}

/// A circle as a cap all round.
fn whole(circle: &Circle) -> [Piece; 1] {
    let start = circle.point([1.0, 0.0]);
    [Piece::Cap(Cap { circle: 0, disc: *circle, start, end: start, angles: [0.0, TAU] })]
}

/// Whether an outline runs clockwise, with the discs outside: the inner one of a ring.
#[must_use]
pub fn is_hole(outline: &Outline) -> bool {
    let points = outline.polyline(STEPS).unwrap_or_default();
    let next = points.iter().cycle().skip(1);
    let Some([x, y]) = points.first() else { return false };
    let area = |([a, b], [c, d]): (&Point<2>, &Point<2>)| (a - x) * (d - y) - (c - x) * (b - y);
    points.iter().zip(next).map(area).sum::<f64>() < 0.0
}

/// A cap in parts of a quarter turn at most: rational parabolas, raised to degree 3 as the arcs beside them are.
fn rational(cap: &Cap) -> Vec<RationalArc> {
    let parts = (cap.sweep() / FRAC_PI_2).ceil().max(1.0);
    let half = 0.5 * cap.sweep() / parts;
    let ends = |k: f64| {
        if k <= 0.0 {
            cap.start
        } else if k >= parts {
            cap.end
        } else {
            let (sine, cosine) = (cap.angles[0] + 2.0 * half * k).sin_cos();
            cap.disc.point([cosine, sine])
        }
    };
    let part = |k: u8| {
        let k = f64::from(k);
        let ([a, b], [c, d]) = (ends(k), ends(k + 1.0));
        let (sine, cosine) = (cap.angles[0] + half * (2.0 * k + 1.0)).sin_cos();
        // The middle point times its weight, the cosine of half the angle, does not grow without end.
        let [x, y, r] = [cap.disc.center[0], cap.disc.center[1], cap.disc.radius];
        let weight = half.cos();
        let middle = [x * weight + r * cosine, y * weight + r * sine, weight];
        let raised = |end: [f64; 3]| std::array::from_fn(|d| (end[d] + 2.0 * middle[d]) / 3.0);
        let (first, last) = ([a, b, 1.0], [c, d, 1.0]);
        RationalArc::new(vec![first, raised(first), raised(last), last])
    };
    // Four quarters make a turn.
    (0..parts.min(4.0) as u8).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::skin::{Circles, Clearing};

    fn skin() -> Outline {
        let discs = [([0.0, 0.0], 1.0), ([4.0, 0.0], 2.0), ([8.0, 1.0], 0.5)];
        let circles =
            Circles::chain(discs.map(|(center, radius)| Circle { center, radius }).to_vec()).unwrap();
        circles.skin(Clearing::Scaled).loops.remove(0)
    }

    #[test]
    fn rational_caps_lie_on_their_circles() {
        let curve = outline_step(&skin());
        assert!(curve.closed);
        assert!(curve.arcs.iter().all(|arc| arc.degree() == 3));
        let caps: Vec<Cap> = skin()
            .pieces
            .iter()
            .filter_map(|piece| if let Piece::Cap(cap) = piece { Some(*cap) } else { None })
            .collect();
        assert_eq!(caps.len(), 2);
        for cap in caps {
            for arc in rational(&cap) {
                for k in 0..=8 {
                    let point = arc.eval(f64::from(k) / 8.0).unwrap();
                    assert!((cap.disc.distance(point) - cap.disc.radius).abs() < 1e-14 * 8.0, "{point:?}");
                }
            }
        }
        // Each arc begins where the one before ends.
        for (arc, next) in curve.arcs.iter().zip(curve.arcs.iter().cycle().skip(1)) {
            let ([a, b], [c, d]) = (arc.eval(1.0).unwrap(), next.eval(0.0).unwrap());
            assert!((a - c).hypot(b - d) < 1e-12);
        }
    }

    #[test]
    fn filled_outlines_are_drawn() {
        let mut figure = Figure::new();
        figure.plot_outline(&skin(), [0, 0, 0], true).unwrap();
        figure.plot_discs(&[Circle { center: [0.0; 2], radius: 1.0 }]).unwrap();
        assert!(figure.to_svg().unwrap().contains("#d6def6"));
    }

    #[test]
    fn the_inner_outline_of_a_ring_is_a_hole() {
        assert!(!is_hole(&skin()));
        let circle = |k: u8| {
            let (sine, cosine) = (f64::from(k) * 45.0).to_radians().sin_cos();
            Circle { center: [5.0 * cosine, 5.0 * sine], radius: 1.5 }
        };
        let ring = Circles::new((0..8).map(circle).collect(), crate::geometry::skin::Links::Ring).unwrap();
        let mut holes: Vec<bool> = ring.skin(Clearing::Scaled).loops.iter().map(is_hole).collect();
        holes.sort_unstable();
        assert_eq!(holes, [false, true]);
    }
}
