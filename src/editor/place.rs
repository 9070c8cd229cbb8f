//! The page that asks for a place in space, or for a vector.

use crate::geometry::Point;
use crate::machine::Quit;
use crate::screen::Color;
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Picture, Words};

/// What four characters can say, as in the original.
pub(super) const COORDINATES: std::ops::RangeInclusive<i32> = -999..=9999;

/// Asks for three whole coordinates under a title; nothing for Esc.
pub(super) async fn ask_place(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    title: Words,
) -> Result<Option<Point<3>>, Quit> {
    let axes = [(215, Words("x = ", "x = ")), (295, Words("y = ", "y = ")), (375, Words("z = ", "z = "))];
    let names = axes.map(|(x, text)| Caption::new((x, 30), text).colored(Color::LightMagenta));
    let fields = axes.map(|(x, _)| coordinate(Area::new(x + 27, 27, x + 65, 39)));
    let form =
        Form::new([Caption::new((300, 13), title)].into_iter().chain(names).collect(), fields.to_vec());
    let numbers = desk.numbers(picture, &form).await?;
    Ok(numbers.and_then(|numbers| numbers.try_into().ok()))
}

/// Asks for a height; nothing for Esc.
pub(super) async fn ask_height(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    title: Words,
) -> Result<Option<f64>, Quit> {
    let name = Caption::new((275, 30), Words("z = ", "z = ")).colored(Color::LightMagenta);
    let field = coordinate(Area::new(302, 27, 340, 39));
    let form = Form::new(vec![Caption::new((300, 13), title), name], vec![field]);
    let numbers = desk.numbers(picture, &form).await?;
    Ok(numbers.and_then(|numbers| numbers.first().copied()))
}

fn coordinate(area: Area) -> Field {
    Field { area, at: (area.x1 + 4, 30), longest: 4, kind: Number::Whole(COORDINATES) }
}
