//! The page that asks for a point or vector in space.

use crate::geometry::Point;
use crate::machine::Asked;
use crate::screen::Color;
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Picture, Words};

/// The range that four characters can express, as in the original.
pub(crate) const COORDINATES: std::ops::RangeInclusive<i32> = -999..=9999;

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
