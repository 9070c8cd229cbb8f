//! What curves, control points and surfaces look like in a figure: the same in every program and on the
//! command line.

use super::picture::{Figure, Style};
use super::wireframe::{all_lines, visible_lines};
use crate::geometry::{BoundingBox, Closure, CubicBezier, GeometryError, Grid, ParamCurve, Point, View};
use crate::screen::Color;

/// Greatest distance of a picture's arcs from the curve, by the size of the curve: far below a
/// thousandth of a pixel in a picture 800 pixels wide.
const TOLERANCE: f64 = 1e-7;
/// The same by the last bits of the coordinates; far from the origin doubles keep no less.
const LEAST_TOLERANCE: f64 = 4.0;

/// Widths of lines in nominal pixels.
const CURVE_WIDTH: f64 = 2.0;
const WIRE_WIDTH: f64 = 1.0;
/// Radius of a control point in nominal pixels.
const POINT_RADIUS: f64 = 4.0;
/// Radius of a joint between two spans.
const JOINT_RADIUS: f64 = 2.5;

const POLYGON: [u8; 3] = [130, 130, 130];
const POINT: [u8; 3] = [255, 255, 255];
const EDGE: [u8; 3] = [170, 0, 0];

/// The colour of a curve that stands alone.
pub const CURVE_INK: [u8; 3] = [0, 0, 170];

/// A colour of the screen, which is for black ground, as one for white paper: darker.
#[must_use]
pub fn print_ink(color: Color) -> [u8; 3] {
    // Two thirds of a byte are a byte.
    color.rgb().map(|channel| (u16::from(channel) * 2 / 3) as u8)
}

/// Whether the lines that a surface hides are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hidden {
    /// All lines are drawn, as of a surface of wires.
    Drawn,
    /// Only what is seen of an opaque surface.
    LeftOut,
}

/// How far the arcs of a picture may be from a curve that is no row of cubics, by the box of the curve.
#[must_use]
pub fn tolerance<const D: usize>(bounds: Option<BoundingBox<D>>) -> f64 {
    let bounds = bounds.unwrap_or(BoundingBox::of_point([0.0; D]));
    (TOLERANCE * bounds.extent()).max(LEAST_TOLERANCE * bounds.last_bits()).max(f64::MIN_POSITIVE)
}

impl Figure {
    /// Adds a curve of the plane, exactly where it is cubic, else as near as any picture can show; one that
    /// returns to its beginning is closed.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`]; rows of cubic arcs have none.
    pub fn plot_curve(&mut self, curve: &dyn ParamCurve<2>, ink: [u8; 3]) -> Result<(), GeometryError> {
        self.plot_arcs(curve, |point| point, Style::line(ink, CURVE_WIDTH))
    }

    /// Adds a curve in space as a view shows it, as near as [`Figure::plot_curve`].
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`].
    pub fn plot_space_curve(
        &mut self,
        curve: &dyn ParamCurve<3>,
        view: &View,
        ink: [u8; 3],
    ) -> Result<(), GeometryError> {
        // The projection is linear: it takes arcs to arcs.
        self.plot_arcs(curve, |point| view.place(point), Style::line(ink, CURVE_WIDTH))
    }

    /// Adds a thin curve that others are compared with.
    ///
    /// # Errors
    /// As [`Figure::plot_curve`].
    pub fn plot_target(&mut self, curve: &dyn ParamCurve<2>) -> Result<(), GeometryError> {
        self.plot_arcs(curve, |point| point, Style::line(EDGE, WIRE_WIDTH))
    }

    fn plot_arcs<const D: usize>(
        &mut self,
        curve: &dyn ParamCurve<D>,
        place: impl Fn(Point<D>) -> Point<2>,
        style: Style,
    ) -> Result<(), GeometryError> {
        let arcs = curve.to_cubics(tolerance(curve.bounding_box()))?;
        // Whoever made the curve knows best; one that is open may return to its beginning all the same.
        let closure = if curve.closed() { Closure::Closed } else { closure(&arcs) };
        let seen = arcs.into_iter().map(|arc| CubicBezier { p: arc.p.map(&place) });
        self.curve(seen.collect(), closure, style);
        Ok(())
    }

    /// Adds dashed lines from control point to control point.
    pub fn plot_polygon(&mut self, points: Vec<Point<2>>, closure: Closure) {
        self.polyline(points, closure, Style::line(POLYGON, WIRE_WIDTH).dashed(5.0, 4.0));
    }

    /// Adds a control point with its label, if it has one.
    pub fn plot_point(&mut self, at: Point<2>, label: Option<String>) {
        self.disc(at, POINT_RADIUS, Style::filled(POINT, EDGE), label);
    }

    /// Adds control points with their numbers from 1 on.
    pub fn plot_points(&mut self, points: &[Point<2>]) {
        for (number, &point) in (1..).zip(points) {
            let number: usize = number;
            self.plot_point(point, Some(number.to_string()));
        }
    }

    /// Adds the place where two spans of a curve join.
    pub fn plot_joint(&mut self, at: Point<2>) {
        self.disc(at, JOINT_RADIUS, Style::filled(CURVE_INK, CURVE_INK), None);
    }

    /// Adds a tangent: dashed from its tip to its other end, with a mark at the tip.
    pub fn plot_tangent(&mut self, tip: Point<2>, end: Point<2>) {
        self.plot_polygon(vec![tip, end], Closure::Open);
        self.disc(tip, JOINT_RADIUS, Style::filled(POLYGON, POLYGON), None);
    }

    /// Adds a line of a plane section through a surface.
    pub fn plot_section(&mut self, line: Vec<Point<2>>) {
        self.polyline(line, Closure::Open, Style::line(EDGE, CURVE_WIDTH));
    }

    /// Adds a border of a surface, which is straight from point to point.
    pub fn plot_border(&mut self, line: Vec<Point<2>>) {
        self.polyline(line, Closure::Open, Style::line(CURVE_INK, WIRE_WIDTH));
    }

    /// Adds the lines of a surface as a view shows them; a picture of one without area is refused.
    pub fn plot_surface(&mut self, grid: &Grid, view: &View, hidden: Hidden) {
        let lines = match hidden {
            Hidden::Drawn => all_lines(grid, view),
            Hidden::LeftOut => visible_lines(grid, view),
        };
        lines.into_iter().for_each(|line| self.plot_border(line));
        self.lacks_area |= !grid.has_area();
    }
}

/// The form of a curve: one that returns to its beginning is closed.
#[must_use]
pub fn closure<const D: usize>(curve: &dyn ParamCurve<D>) -> Closure {
    if curve.closed() { Closure::Closed } else { Closure::Open }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_that_comes_back_is_closed() {
        let arc = |from: Point<2>, to: Point<2>| CubicBezier { p: [from, [1.0, 5.0], [5.0, 1.0], to] };
        assert_eq!(closure(&vec![arc([0.0; 2], [9.0; 2]), arc([9.0; 2], [1e-14, 0.0])]), Closure::Closed);
        assert_eq!(closure(&vec![arc([0.0; 2], [9.0; 2])]), Closure::Open);
        assert_eq!(closure::<2>(&Vec::new()), Closure::Open);
    }

    #[test]
    fn an_open_curve_is_open_however_far_away_it_lies() {
        for far in [0.0, 1e6, 1e9, 1e12, 1e15] {
            let line = [[far, far], [far + 3.0, far + 8.0], [far + 6.0, far], [far + 1.0, far]];
            let arc = CubicBezier { p: line };
            assert_eq!(closure(&vec![arc]), Closure::Open, "{far:e}");
            let back = CubicBezier { p: [line[3], line[1], line[2], line[0]] };
            assert_eq!(closure(&vec![arc, back]), Closure::Closed, "{far:e}");
        }
    }

    #[test]
    fn tolerances_are_positive() {
        let far = BoundingBox { min: [1e9, 0.0], max: [1e9, 1.0] };
        assert!(tolerance::<2>(None) > 0.0);
        // Far below a pixel of a curve that is a billion times as far away as it is large.
        assert!((1e-7..1e-4).contains(&tolerance(Some(far))));
    }
}
