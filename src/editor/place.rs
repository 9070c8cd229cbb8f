//! Places of control points: asked for by their coordinates, and found on a curve by the mouse.

use super::field::{apart, within};
use super::lens::Lens;
use crate::geometry::{Closure, Point};
use crate::machine::Asked;
use crate::screen::Color;
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Picture, Words, words};

/// The range that four characters can express, as in the original.
pub(crate) const COORDINATES: std::ops::RangeInclusive<i32> = -999..=9999;

/// How far from the curve a click is on it, in pixels.
const REACH: i32 = 5;

/// Asks for three whole coordinates under a title.
pub(crate) async fn ask_place(desk: &mut Desk<'_>, picture: &dyn Picture, title: Words) -> Asked<Point<3>> {
    let axes = [(215, Words("x = ", "x = ")), (295, Words("y = ", "y = ")), (375, Words("z = ", "z = "))];
    let names = axes.map(|(x, text)| Caption::new((x, 30), text).colored(Color::LightMagenta));
    let fields = axes.map(|(x, _)| coordinate(Area::new(x + 27, 27, x + 65, 39)));
    let captions = [Caption::new((300, 13), title)].into_iter().chain(names).collect();
    desk.numbers(picture, &Form::new(captions, fields)).await
}

/// Asks for a height.
pub(crate) async fn ask_height(desk: &mut Desk<'_>, picture: &dyn Picture, title: Words) -> Asked<f64> {
    let name = Caption::new((275, 30), Words("z = ", "z = ")).colored(Color::LightMagenta);
    let field = coordinate(Area::new(302, 27, 340, 39));
    let form = Form::new(vec![Caption::new((300, 13), title), name], [field]);
    let [height] = desk.numbers(picture, &form).await?;
    Ok(height)
}

fn coordinate(area: Area) -> Field {
    Field { area, at: (area.x1 + 4, 30), longest: 4, kind: Number::Whole(COORDINATES) }
}

/// Asks for a place in the field of plane curves.
pub(crate) async fn ask_place_in_field(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    limits: [f64; 2],
) -> Asked<Point<2>> {
    let field = |y: i32, largest: f64| Field {
        area: Area::new(340, y - 2, 378, y + 10),
        at: (348, y + 1),
        longest: 3,
        kind: Number::Whole(0..=largest as i32),
    };
    let captions = vec![
        Caption::new((255, 23), words::PLACE_ENTRY),
        Caption::new((315, 15), Words("x = ", "x = ")).colored(Color::LightMagenta),
        Caption::new((315, 30), Words("y = ", "y = ")).colored(Color::LightMagenta),
    ];
    desk.numbers(picture, &Form::new(captions, [field(14, limits[0]), field(29, limits[1])])).await
}

/// The vertex of a line along a curve that is at a pixel, and the index that a control point inserted there has:
/// behind the nearest side of the control polygon.
pub(crate) fn on_line<const D: usize>(
    line: &[Point<D>],
    points: &[Point<D>],
    closure: Closure,
    lens: &impl Lens<D>,
    at: (i32, i32),
) -> Option<(Point<D>, usize)> {
    let nearest = *line.iter().min_by_key(|&&place| apart(lens.pixel(place), at))?;
    if !within(REACH, lens.pixel(nearest), at) {
        return None;
    }
    let sides = points.iter().zip(points.iter().cycle().skip(1));
    let count = points.len() - usize::from(closure == Closure::Open).min(points.len());
    let of_side = |(_, (from, to)): &(usize, (&Point<D>, &Point<D>))| distance_to_side(nearest, **from, **to);
    let side = sides.take(count).enumerate().min_by(|a, b| of_side(a).total_cmp(&of_side(b)))?.0;
    Some((nearest, side + 1))
}

/// The square of the distance of a point to the line between two others.
fn distance_to_side<const D: usize>(point: Point<D>, from: Point<D>, to: Point<D>) -> f64 {
    let dot = |a: Point<D>, b: Point<D>| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let minus = |a: Point<D>, b: Point<D>| -> Point<D> { std::array::from_fn(|axis| a[axis] - b[axis]) };
    let (side, way) = (minus(to, from), minus(point, from));
    let length = dot(side, side);
    let part = if length > 0.0 { (dot(way, side) / length).clamp(0.0, 1.0) } else { 0.0 };
    let rest: Point<D> = std::array::from_fn(|axis| way[axis] - part * side[axis]);
    dot(rest, rest)
}
