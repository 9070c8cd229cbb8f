//! Visible items, independent of pixels. They are made once from a design; one walk paints them on the screen,
//! another plots them into a figure.

use super::field::numbered_disc;
use super::lens::Lens;
use crate::figure::{CURVE_INK, Figure, print_ink, tolerance};
use crate::geometry::{BoundingBox, Closure, ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};

/// A visible item.
pub(crate) enum Item<const D: usize> {
    /// A curve with its segments per span, its stroke, and its name in a figure.
    Curve { curve: Box<dyn ParamCurve<D>>, steps: usize, stroke: Stroke, name: Option<Label> },
    /// Where spans join.
    Joint(Point<D>),
    /// A tangent, drawn from its tip to the tip's mirror image.
    Tangent { tip: Point<D>, point: Point<D>, fill: Color },
    /// A control point with its number, counted from 1.
    Disc { at: Point<D>, number: usize, fill: Color },
    /// A control point in the store, which is not part of a figure.
    Stored { at: Point<D>, number: usize, fill: Color },
    /// A control point of a result.
    Dot(Point<D>),
    /// A control point of a net.
    Knot { at: Point<D>, fill: Color },
    /// A line of a net; white ones are borders of the surface.
    Line { ends: [Point<D>; 2], ink: Color },
    /// A short text beside a place.
    Note { at: Point<D>, text: String, ink: Color },
    /// An item of one editor only.
    Own(Box<dyn Own<D>>),
}

/// The name of a curve, and where along the curve it would best be written.
pub(crate) struct Label {
    pub(crate) name: String,
    /// The fraction of the curve: numerator and denominator.
    pub(crate) part: [usize; 2],
}

/// An item of one editor only.
pub(crate) trait Own<const D: usize> {
    fn paint(&self, screen: &mut Screen);
    /// Returns `false` if lines cannot show it.
    fn plot(&self, figure: &mut Figure) -> bool;
    fn bounds(&self) -> Option<BoundingBox<D>>;
}

/// Places along a curve that are tried for its name.
const NAME_PLACES: usize = 24;
/// Radius of the disc at the tip of a tangent, of a control point of a result, and of one of a net.
pub(crate) const TIP_RADIUS: i32 = 7;
const DOT_RADIUS: i32 = 4;

impl<const D: usize> Item<D> {
    /// Paints it on the screen.
    pub(crate) fn paint(&self, screen: &mut Screen, lens: &impl Lens<D>) {
        match self {
            Item::Curve { curve, steps, stroke, .. } => {
                // More segments than any screen can show: nothing is painted.
                let Ok(line) = curve.polyline(*steps) else { return };
                // Short segments often end on the same pixel, which is painted once.
                let mut pixels: Vec<(i32, i32)> = line.into_iter().map(|point| lens.pixel(point)).collect();
                pixels.dedup();
                screen.polyline(&pixels, *stroke);
            }
            Item::Joint(at) => {
                let (x, y) = lens.pixel(*at);
                screen.disc(x, y, 3, Color::Black, Color::White);
                screen.circle(x, y, 3, Stroke::thick(Color::White));
            }
            Item::Tangent { tip, point, fill } => {
                let ((x, y), (tip_x, tip_y)) = (lens.pixel(*point), lens.pixel(*tip));
                let stroke = Stroke::thin(Color::White).dotted();
                screen.line(tip_x, tip_y, 2 * x - tip_x, 2 * y - tip_y, stroke);
                screen.disc(tip_x, tip_y, TIP_RADIUS, *fill, Color::White);
            }
            Item::Disc { at, number, fill } | Item::Stored { at, number, fill } => {
                numbered_disc(screen, lens.pixel(*at), *number, *fill);
            }
            Item::Dot(at) => {
                let (x, y) = lens.pixel(*at);
                screen.disc(x, y, DOT_RADIUS, Color::White, Color::White);
            }
            Item::Knot { at, fill } => {
                let (x, y) = lens.pixel(*at);
                screen.disc(x, y, DOT_RADIUS, *fill, Color::White);
            }
            Item::Line { ends, ink } => {
                let [(x1, y1), (x2, y2)] = ends.map(|end| lens.pixel(end));
                screen.line(x1, y1, x2, y2, Stroke::thin(*ink));
            }
            Item::Note { at, text, ink } => {
                let (x, y) = lens.pixel(*at);
                let width = 8 * i32::try_from(text.chars().count()).unwrap_or(0);
                // Beside the disc of a control point.
                screen.bar(x + 11, y - 17, x + 12 + width, y - 8, Color::Black);
                screen.text(x + 12, y - 16, text, *ink);
            }
            Item::Own(own) => own.paint(screen),
        }
    }

    /// Plots it into a figure; returns `false` if a figure cannot show it.
    fn plot(&self, figure: &mut Figure, lens: &impl Lens<D>) -> bool {
        match self {
            Item::Curve { curve, stroke, name, .. } => {
                let ink = if stroke.color == Color::White { CURVE_INK } else { print_ink(stroke.color) };
                if let Some(Label { name, part: [numerator, denominator] }) = name {
                    let arcs = curve.to_cubics(tolerance(curve.bounding_box())).unwrap_or_default();
                    let step = (arcs.len() / NAME_PLACES).max(1);
                    let from_part =
                        arcs.iter().cycle().skip(numerator * arcs.len() / denominator).take(arcs.len());
                    let places = from_part.step_by(step).map(|arc| lens.flat(arc.eval(0.5)));
                    figure.name(places.collect(), name.clone(), ink);
                }
                lens.plot(figure, &**curve, ink);
            }
            Item::Joint(at) => figure.plot_joint(lens.flat(*at)),
            Item::Tangent { tip, point, .. } => {
                let [tip, [x, y]] = [tip, point].map(|place| lens.flat(*place));
                figure.plot_tangent(tip, [2.0 * x - tip[0], 2.0 * y - tip[1]]);
            }
            Item::Disc { at, number, .. } => figure.plot_point(lens.flat(*at), Some(number.to_string())),
            Item::Dot(at) | Item::Knot { at, .. } => figure.plot_point(lens.flat(*at), None),
            Item::Line { ends, ink } => {
                let line = ends.map(|end| lens.flat(end)).to_vec();
                match ink {
                    Color::White => figure.plot_border(line),
                    _ => figure.plot_polygon(line, Closure::Open),
                }
            }
            Item::Note { at, text, .. } => figure.text(lens.flat(*at), text.clone()),
            Item::Stored { .. } => {}
            Item::Own(own) => return own.plot(figure),
        }
        true
    }

    fn bounds(&self) -> Option<BoundingBox<D>> {
        match self {
            Item::Curve { curve, .. } => curve.bounding_box(),
            Item::Disc { at, .. } | Item::Dot(at) | Item::Knot { at, .. } => Some(BoundingBox::of_point(*at)),
            Item::Own(own) => own.bounds(),
            Item::Joint(_)
            | Item::Tangent { .. }
            | Item::Stored { .. }
            | Item::Line { .. }
            | Item::Note { .. } => None,
        }
    }
}

/// The items as a figure; `None` without items, or if lines cannot show one of them.
pub(crate) fn figure<const D: usize>(items: &[Item<D>], lens: &impl Lens<D>) -> Option<Figure> {
    let mut figure = Figure::new();
    if !items.iter().all(|item| item.plot(&mut figure, lens)) || figure.is_empty() {
        return None;
    }
    let bounds = items.iter().filter_map(Item::bounds).reduce(BoundingBox::union);
    if let Some(axes) = bounds.and_then(|bounds| lens.axes(bounds)) {
        figure.set_axes(axes);
    }
    Some(figure)
}
