//! How curves, control points and surfaces look in a figure, in every program and on the command line.

use super::picture::{Figure, Style};
use super::wireframe::{all_lines, visible_lines};
use crate::geometry::{BoundingBox, Closure, CubicBezier, GeometryError, Grid, ParamCurve, Point, View};
use crate::screen::Color;

/// Tolerance of arcs relative to the size of the curve: far below a thousandth of a pixel in a picture 800 pixels
/// wide.
const TOLERANCE: f64 = 1e-7;
/// Tolerance relative to the largest coordinate, near the precision of doubles.
const LEAST_TOLERANCE: f64 = 1e-11;

/// Line widths in nominal pixels.
const CURVE_WIDTH: f64 = 2.0;
const WIRE_WIDTH: f64 = 1.0;
/// Radius of a control point in nominal pixels.
const POINT_RADIUS: f64 = 4.0;
/// Radius of a joint between two spans.
const JOINT_RADIUS: f64 = 2.5;

const POLYGON: [u8; 3] = [130, 130, 130];
const POINT: [u8; 3] = [255, 255, 255];
const EDGE: [u8; 3] = [170, 0, 0];

/// The colour of a single curve.
pub const CURVE_INK: [u8; 3] = [0, 0, 170];

/// Darkens a colour of the screen, which is made for a black background, for white paper.
#[must_use]
pub fn print_ink(color: Color) -> [u8; 3] {
    // Two thirds of a byte fit into a byte.
    color.rgb().map(|channel| (u16::from(channel) * 2 / 3) as u8)
}

/// Whether the lines that a surface hides are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hidden {
    /// All lines are drawn, as for a wire frame.
    Drawn,
    /// Only the visible lines of an opaque surface are drawn.
    LeftOut,
}

/// The tolerance of arcs for a curve that is not piecewise cubic, by its bounding box.
#[must_use]
pub fn tolerance<const D: usize>(bounds: Option<BoundingBox<D>>) -> f64 {
    let bounds = bounds.unwrap_or(BoundingBox::of_point([0.0; D]));
    let extent = bounds.size().into_iter().fold(0.0_f64, f64::max);
    let largest = bounds.min.iter().chain(&bounds.max).fold(0.0_f64, |m, x| m.max(x.abs()));
    (TOLERANCE * extent).max(LEAST_TOLERANCE * largest).max(f64::MIN_POSITIVE)
}

impl Figure {
    /// Adds a plane curve: exactly if it is piecewise cubic, else within a tolerance that no picture shows. A curve
    /// that returns to its start is closed.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`]; piecewise cubic curves have none.
    pub fn plot_curve(&mut self, curve: &dyn ParamCurve<2>, ink: [u8; 3]) -> Result<(), GeometryError> {
        self.plot_arcs(arcs(curve)?, Style::line(ink, CURVE_WIDTH));
        Ok(())
    }

    /// Adds the projection of a space curve, with the tolerance of [`Figure::plot_curve`].
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`].
    pub fn plot_space_curve(
        &mut self,
        curve: &dyn ParamCurve<3>,
        view: &View,
        ink: [u8; 3],
    ) -> Result<(), GeometryError> {
        // The projection is linear, so it maps arcs to arcs.
        let seen = |arc: CubicBezier<3>| CubicBezier { p: arc.p.map(|point| view.place(point)) };
        let arcs = arcs(curve)?.into_iter().map(seen).collect();
        self.plot_arcs(arcs, Style::line(ink, CURVE_WIDTH));
        Ok(())
    }

    /// Adds a thin curve, for comparison.
    ///
    /// # Errors
    /// Those of [`Figure::plot_curve`].
    pub fn plot_target(&mut self, curve: &dyn ParamCurve<2>) -> Result<(), GeometryError> {
        self.plot_arcs(arcs(curve)?, Style::line(EDGE, WIRE_WIDTH));
        Ok(())
    }

    fn plot_arcs(&mut self, arcs: Vec<CubicBezier<2>>, style: Style) {
        let closure = closure(&arcs);
        self.curve(arcs, closure, style);
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

    /// Adds a joint between two spans of a curve.
    pub fn plot_joint(&mut self, at: Point<2>) {
        self.disc(at, JOINT_RADIUS, Style::filled(CURVE_INK, CURVE_INK), None);
    }

    /// Adds a tangent: a dashed line from its tip to its other end, with a mark at the tip.
    pub fn plot_tangent(&mut self, tip: Point<2>, end: Point<2>) {
        self.plot_polygon(vec![tip, end], Closure::Open);
        self.disc(tip, JOINT_RADIUS, Style::filled(POLYGON, POLYGON), None);
    }

    /// Adds a line of a plane section of a surface.
    pub fn plot_section(&mut self, line: Vec<Point<2>>) {
        self.polyline(line, Closure::Open, Style::line(EDGE, CURVE_WIDTH));
    }

    /// Adds a border of a surface as a polyline.
    pub fn plot_border(&mut self, line: Vec<Point<2>>) {
        self.polyline(line, Closure::Open, Style::line(CURVE_INK, WIRE_WIDTH));
    }

    /// Adds the projected lines of a surface.
    pub fn plot_surface(&mut self, grid: &Grid, view: &View, hidden: Hidden) {
        let lines = match hidden {
            Hidden::Drawn => all_lines(grid, view),
            Hidden::LeftOut => visible_lines(grid, view),
        };
        lines.into_iter().for_each(|line| self.plot_border(line));
    }
}

/// The arcs that a curve is drawn by.
fn arcs<const D: usize>(curve: &dyn ParamCurve<D>) -> Result<Vec<CubicBezier<D>>, GeometryError> {
    curve.to_cubics(tolerance(curve.bounding_box()))
}

/// The closure of a curve: closed if it returns to its start.
#[must_use]
pub fn closure(curve: &dyn ParamCurve<2>) -> Closure {
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
        assert_eq!(closure(&Vec::new()), Closure::Open);
    }

    #[test]
    fn tolerances_are_positive() {
        let far = BoundingBox { min: [1e6, 0.0], max: [1e6, 0.0] };
        assert!(tolerance::<2>(None) > 0.0);
        assert!((tolerance(Some(far)) / 1e-5 - 1.0).abs() < 1e-9);
    }
}
