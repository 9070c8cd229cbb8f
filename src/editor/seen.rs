//! What there is to be seen, before any pixel: made once from a design, painted on the screen and plotted into
//! a figure by one walk each.

use super::field::numbered_disc;
use super::lens::Lens;
use crate::figure::{CURVE_INK, Figure, print_ink, tolerance};
use crate::geometry::{BoundingBox, Closure, ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};

/// Something to be seen.
pub(super) enum Item<const D: usize> {
    /// A curve with the steps that a span is drawn in, its colour, and the name it has in a figure.
    Curve { curve: Box<dyn ParamCurve<D>>, steps: usize, color: Color, name: Option<Label> },
    /// Where spans join.
    Joint(Point<D>),
    /// A tangent from its tip to its mirror image.
    Tangent { tip: Point<D>, point: Point<D> },
    /// A control point with its number, counted from 1.
    Disc { at: Point<D>, number: usize, fill: Color },
    /// A control point that waits to be taken: it belongs to no figure.
    Stored { at: Point<D>, number: usize, fill: Color },
    /// A control point of a result.
    Dot(Point<D>),
    /// A control point of a net.
    Knot { at: Point<D>, fill: Color },
    /// A line of a net; white ones are borders of the surface.
    Line { ends: [Point<D>; 2], ink: Color },
    /// Something that only one editor shows.
    Own(Box<dyn Own<D>>),
}

/// A curve's name, and at which part of the curve it stands.
pub(super) struct Label {
    pub(super) name: &'static str,
    /// Numerator and denominator of the part.
    pub(super) part: [usize; 2],
}

/// What only one editor shows.
pub(super) trait Own<const D: usize> {
    fn paint(&self, screen: &mut Screen);
    /// `false` if it cannot be told by lines.
    fn plot(&self, figure: &mut Figure) -> bool;
    fn bounds(&self) -> Option<BoundingBox<D>>;
}

/// Radius of the disc at the tip of a tangent, of a control point of a result, and of one of a net.
pub(super) const TIP_RADIUS: i32 = 7;
const DOT_RADIUS: i32 = 4;

impl<const D: usize> Item<D> {
    /// Paints it on the screen.
    pub(super) fn paint(&self, screen: &mut Screen, lens: &impl Lens<D>) {
        match self {
            Item::Curve { curve, steps, color, .. } => {
                // Too many steps for any screen: there is nothing to paint.
                let Ok(line) = curve.polyline(*steps) else { return };
                // Fine steps fall on the same pixel many times; once is enough.
                let mut pixels: Vec<(i32, i32)> = line.into_iter().map(|point| lens.pixel(point)).collect();
                pixels.dedup();
                screen.polyline(&pixels, Stroke::thick(*color));
            }
            Item::Joint(at) => {
                let (x, y) = lens.pixel(*at);
                screen.disc(x, y, 3, Color::Black, Color::White);
                screen.circle(x, y, 3, Stroke::thick(Color::White));
            }
            Item::Tangent { tip, point } => {
                let ((x, y), (tip_x, tip_y)) = (lens.pixel(*point), lens.pixel(*tip));
                let stroke = Stroke::thin(Color::White).dotted();
                screen.line(tip_x, tip_y, 2 * x - tip_x, 2 * y - tip_y, stroke);
                screen.disc(tip_x, tip_y, TIP_RADIUS, Color::DarkGray, Color::White);
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
            Item::Own(own) => own.paint(screen),
        }
    }

    /// Plots it into a figure; `false` if that cannot show it.
    fn plot(&self, figure: &mut Figure, lens: &impl Lens<D>) -> bool {
        match self {
            Item::Curve { curve, color, name, .. } => {
                if let Some(Label { name, part: [numerator, denominator] }) = name {
                    let arcs = curve.to_cubics(tolerance(curve.bounding_box())).unwrap_or_default();
                    let arc = arcs.get(numerator * arcs.len() / denominator);
                    arc.into_iter().for_each(|arc| figure.text(lens.flat(arc.eval(0.5)), *name));
                }
                let ink = if *color == Color::White { CURVE_INK } else { print_ink(*color) };
                lens.plot(figure, &**curve, ink);
            }
            Item::Joint(at) => figure.plot_joint(lens.flat(*at)),
            Item::Tangent { tip, point } => {
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
            Item::Joint(_) | Item::Tangent { .. } | Item::Stored { .. } | Item::Line { .. } => None,
        }
    }
}

/// The items as a figure; `None` for nothing, and where one of them cannot be told by lines.
pub(super) fn figure<const D: usize>(items: &[Item<D>], lens: &impl Lens<D>) -> Option<Figure> {
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
