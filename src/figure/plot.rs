//! How curves, control points and surfaces look in a figure, in every program and on the command line.

use super::picture::{Figure, Style};
use super::wireframe::{all_lines, visible_lines};
use crate::geometry::{
    BoundingBox, Closure, CubicBezier, GeometryError, Grid, ParamCurve, Point, Projection, View,
};
use crate::screen::Color;
use std::collections::HashMap;

/// Tolerance of arcs relative to the size of the curve: far below a thousandth of a pixel in a picture 800 pixels
/// wide.
const TOLERANCE: f64 = 1e-7;
/// The same by the last bits of the coordinates; far from the origin doubles keep no less.
const LEAST_TOLERANCE: f64 = 4.0;

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

/// The colours of several curves in one picture, which can be told apart on white paper.
pub const SERIES_INKS: [[u8; 3]; 16] = [
    CURVE_INK,
    [190, 0, 0],
    [0, 130, 0],
    [200, 110, 0],
    [140, 0, 150],
    [0, 135, 150],
    [90, 90, 90],
    [225, 70, 150],
    [110, 140, 0],
    [60, 130, 235],
    [125, 70, 25],
    [0, 75, 70],
    [240, 130, 100],
    [95, 85, 195],
    [170, 140, 60],
    [90, 0, 60],
];

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
    (TOLERANCE * bounds.extent()).max(LEAST_TOLERANCE * bounds.last_bits()).max(f64::MIN_POSITIVE)
}

impl Figure {
    /// Adds a plane curve: exactly if it is piecewise cubic, else within a tolerance that no picture shows. A curve
    /// that returns to its start is closed.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`]; piecewise cubic curves have none.
    pub fn plot_curve(&mut self, curve: &dyn ParamCurve<2>, ink: [u8; 3]) -> Result<(), GeometryError> {
        self.plot_arcs(curve, |point| point, Style::line(ink, CURVE_WIDTH))
    }

    /// Adds a plane curve by cubic arcs within a tolerance, in the unit of the points.
    ///
    /// # Errors
    /// Those of [`ParamCurve::to_cubics`].
    pub fn plot_curve_within(
        &mut self,
        curve: &dyn ParamCurve<2>,
        ink: [u8; 3],
        tolerance: f64,
    ) -> Result<(), GeometryError> {
        self.plot_arcs_within(curve, |point| point, Style::line(ink, CURVE_WIDTH), tolerance)
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
        if view.projection() == Projection::Parallel {
            // It is linear: it takes arcs to arcs.
            return self.plot_arcs(curve, |point| view.place(point), Style::line(ink, CURVE_WIDTH));
        }
        self.plot_curve(&Seen { curve, view }, ink)
    }

    /// Adds a thin curve, for comparison.
    ///
    /// # Errors
    /// Those of [`Figure::plot_curve`].
    pub fn plot_target(&mut self, curve: &dyn ParamCurve<2>) -> Result<(), GeometryError> {
        self.plot_arcs(curve, |point| point, Style::line(EDGE, WIRE_WIDTH))
    }

    fn plot_arcs<const D: usize>(
        &mut self,
        curve: &dyn ParamCurve<D>,
        place: impl Fn(Point<D>) -> Point<2>,
        style: Style,
    ) -> Result<(), GeometryError> {
        self.plot_arcs_within(curve, place, style, tolerance(curve.bounding_box()))
    }

    fn plot_arcs_within<const D: usize>(
        &mut self,
        curve: &dyn ParamCurve<D>,
        place: impl Fn(Point<D>) -> Point<2>,
        style: Style,
        tolerance: f64,
    ) -> Result<(), GeometryError> {
        let arcs = curve.to_cubics(tolerance)?;
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

    /// Adds control points with their numbers from 1 on. Points at the same place are one, with all their numbers, as
    /// in "4-6".
    pub fn plot_points(&mut self, points: &[Point<2>]) {
        for (point, label) in point_labels(points) {
            self.plot_point(point, Some(label));
        }
    }

    /// Adds a joint between two spans of a curve.
    pub fn plot_joint(&mut self, at: Point<2>) {
        self.plot_joint_in(at, CURVE_INK);
    }

    /// Adds a joint in the colour of its curve.
    pub fn plot_joint_in(&mut self, at: Point<2>, ink: [u8; 3]) {
        self.disc(at, JOINT_RADIUS, Style::filled(ink, ink), None);
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

    /// Adds the lines of a surface as a view shows them; a picture of one without area is refused.
    pub fn plot_surface(&mut self, grid: &Grid, view: &View, hidden: Hidden) {
        self.plot_surfaces(std::slice::from_ref(grid), view, hidden);
    }

    /// Adds the lines of surfaces that hide each other.
    pub fn plot_surfaces(&mut self, grids: &[Grid], view: &View, hidden: Hidden) {
        let lines = match hidden {
            Hidden::Drawn => grids.iter().flat_map(|grid| all_lines(grid, view)).collect(),
            Hidden::LeftOut => visible_lines(grids, view),
        };
        lines.into_iter().for_each(|line| self.plot_border(line));
        self.lacks_area |= !grids.iter().all(Grid::has_area);
    }
}

/// The different places of points with their numbers from 1 on, as in "4-6" where several are at one place.
#[must_use]
pub fn point_labels<const D: usize>(points: &[Point<D>]) -> Vec<(Point<D>, String)> {
    places(points).into_iter().map(|(point, numbers)| (point, ranges(&numbers))).collect()
}

/// Different places in the order of their first points, with the numbers of their points from 1 on.
fn places<const D: usize>(points: &[Point<D>]) -> Vec<(Point<D>, Vec<usize>)> {
    let mut found: HashMap<[u64; D], usize> = HashMap::new();
    let mut places: Vec<(Point<D>, Vec<usize>)> = Vec::new();
    for (number, &point) in (1..).zip(points) {
        // Zero has one sign here.
        let at = *found.entry(point.map(|x| (x + 0.0).to_bits())).or_insert(places.len());
        match places.get_mut(at) {
            Some((_, numbers)) => numbers.push(number),
            None => places.push((point, vec![number])),
        }
    }
    places
}

/// Ascending numbers as they are written: runs of neighbours by their ends.
fn ranges(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|one, next| one + 1 == *next);
    let texts = runs.filter_map(|run| match (run.first()?, run.last()?) {
        (first, last) if first == last => Some(first.to_string()),
        (first, last) => Some(format!("{first}-{last}")),
    });
    texts.collect::<Vec<_>>().join(", ")
}

/// A curve of space as a view shows it.
#[derive(Debug)]
struct Seen<'c> {
    curve: &'c dyn ParamCurve<3>,
    view: &'c View,
}

impl ParamCurve<2> for Seen<'_> {
    fn spans(&self) -> usize {
        self.curve.spans()
    }

    fn closed(&self) -> bool {
        self.curve.closed()
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let [point, first, second] = self.curve.at(span, u)?;
        let (place, size) = (self.view.place(point), self.view.magnification(point));
        // A change of w towards the viewer changes 1 / size by -w / distance; on what is too near, nothing does.
        let distance = match self.view.projection() {
            Projection::Central(distance) if size < MOST => distance,
            _ => f64::INFINITY,
        };
        let [by_first, by_second] = [first, second].map(|by| self.view.seen(by));
        let grows = [by_first, by_second].map(|by| size * size * by[2] / distance);
        let grows = [grows[0], grows[1] + 2.0 * grows[0] * size * by_first[2] / distance];
        // What is magnified: the place from the target, which stays.
        let from = self.view.beside_target(point);
        let by = |d: usize| {
            [
                by_first[d] * size + from[d] * grows[0],
                by_second[d] * size + 2.0 * by_first[d] * grows[0] + from[d] * grows[1],
            ]
        };
        let [x, y] = [by(0), by(1)];
        Some([place, [x[0], y[0]], [x[1], y[1]]])
    }
}

/// The largest magnification of a projection, but for rounding.
const MOST: f64 = 9.999;

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

    /// A curve seen by central rays: its arcs keep to the images of its points, and its derivatives are differences.
    #[test]
    fn a_curve_in_perspective_is_where_its_points_are() {
        let p = [[0.0, 0.0, 0.0], [200.0, 0.0, 50.0], [200.0, 150.0, 100.0], [-50.0, 200.0, 250.0]];
        let curve = vec![CubicBezier { p }];
        let view =
            View::from_direction([0.7, 0.2, 0.3]).projected(Projection::Central(600.0), [5.0, 6.0, 7.0]);
        let seen = Seen { curve: &curve, view: &view };
        let h = 1e-4;
        for u in [0.1, 0.4, 0.8] {
            let [place, first, second] = seen.at(0, u).unwrap();
            let [before, after] = [u - h, u + h].map(|u| view.place(curve.eval(0, u).unwrap()));
            for d in 0..2 {
                assert!((first[d] - (after[d] - before[d]) / (2.0 * h)).abs() < 1e-3, "{first:?}");
                assert!(
                    (second[d] - (after[d] - 2.0 * place[d] + before[d]) / (h * h)).abs() < 1e-1,
                    "{second:?}"
                );
            }
        }
        let arcs = seen.to_cubics(1e-6).unwrap();
        let ends = (arcs.eval(0, 0.0).unwrap(), arcs.eval(arcs.len() - 1, 1.0).unwrap());
        for (end, point) in [(ends.0, p[0]), (ends.1, p[3])] {
            assert!(end.iter().zip(view.place(point)).all(|(a, b)| (a - b).abs() < 1e-5));
        }
    }

    #[test]
    fn points_at_a_place_have_one_disc() {
        let [a, b, c] = [[1.0, 2.0], [0.0, 5.0], [-0.0, 5.0]];
        let found = places(&[a, b, c, b, a, [9.0, 9.0], a]);
        let texts: Vec<String> = found.iter().map(|(_, numbers)| ranges(numbers)).collect();
        assert_eq!(texts, ["1, 5, 7", "2-4", "6"]);
        assert_eq!(found.iter().map(|(place, _)| *place).collect::<Vec<_>>(), [a, b, [9.0, 9.0]]);
        assert!(places::<2>(&[]).is_empty());
    }

    #[test]
    fn tolerances_are_positive() {
        let far = BoundingBox { min: [1e9, 0.0], max: [1e9, 1.0] };
        assert!(tolerance::<2>(None) > 0.0);
        // Far below a pixel of a curve that is a billion times as far away as it is large.
        assert!((1e-7..1e-4).contains(&tolerance(Some(far))));
    }
}
