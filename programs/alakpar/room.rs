//! What differs between the plane and space.

use super::commands::{Action, PLANE, SPACE};
use crate::editor::lens::{Field, Lens};
use crate::editor::place;
use crate::file::{FIELD, Places, SPACE_VIEW};
use crate::geometry::Point;
use crate::machine::Asked;
use crate::screen::Color;
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::{Commands, Desk, Picture, words};

/// The plane, or space.
pub(super) trait Room<const D: usize> {
    type Lens: Lens<D> + 'static;
    /// Where new points are taken from.
    const STORE: Option<Point<D>>;
    /// The fill colour of control points.
    const FILL: Color;
    fn commands() -> Commands<Action>;
    fn lens() -> Self::Lens;
    /// The place of a pixel on the empty ground; `None` where a pixel is no place.
    fn open_place(at: (i32, i32)) -> Option<Point<D>>;
    /// The point of a pixel in figures, where [`Lens::flat`] has places.
    fn flat(lens: &Self::Lens, at: (i32, i32)) -> Point<2>;
    /// The points of this kind in a document.
    fn points(places: &Places) -> Option<&[Point<D>]>;
    async fn ask_place(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Point<D>>;
    /// Azimuth, elevation and zoom, where there are any.
    fn angles(_: &Self::Lens) -> Option<[f64; 3]> {
        None
    }
}

/// The rooms.
pub(super) struct Here;

impl Room<2> for Here {
    type Lens = Field;
    const STORE: Option<Point<2>> = Some([577.0, 360.0]);
    const FILL: Color = Color::DarkGray;

    fn commands() -> Commands<Action> {
        PLANE
    }

    fn lens() -> Field {
        Field
    }

    fn open_place(at: (i32, i32)) -> Option<Point<2>> {
        Some(Field.place(at)).filter(|&at| crate::design::Place::fits(at))
    }

    fn flat(_: &Field, at: (i32, i32)) -> Point<2> {
        Field.place(at)
    }

    fn points(places: &Places) -> Option<&[Point<2>]> {
        places.plane()
    }

    async fn ask_place(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Point<2>> {
        place::ask_place_in_field(desk, picture, FIELD).await
    }
}

impl Room<3> for Here {
    type Lens = Viewer;
    const STORE: Option<Point<3>> = None;
    const FILL: Color = Color::Black;

    fn commands() -> Commands<Action> {
        SPACE
    }

    fn lens() -> Viewer {
        Viewer::new(Look::new(SPACE_VIEW, Poles::Stop))
    }

    fn open_place(_: (i32, i32)) -> Option<Point<3>> {
        None
    }

    fn flat(lens: &Viewer, (x, y): (i32, i32)) -> Point<2> {
        let look = lens.look;
        let middle: Point<3> = std::array::from_fn(|axis| look.middle(axis));
        let ((left, top), [right, up]) = (look.to_screen(middle), look.view.place(middle));
        let scale = look.scale();
        [right + f64::from(x - left) / scale, up + f64::from(top - y) / scale]
    }

    fn points(places: &Places) -> Option<&[Point<3>]> {
        places.space()
    }

    async fn ask_place(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Point<3>> {
        place::ask_place(desk, picture, words::PLACE_3D).await
    }

    fn angles(lens: &Viewer) -> Option<[f64; 3]> {
        Some(lens.look.angles())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_point_of_a_pixel_is_that_of_figures() {
        let mut viewer = <Here as Room<3>>::lens();
        for zoom in [0, 4, -4] {
            viewer.look = Look::new(SPACE_VIEW, Poles::Stop).turned_by((57, -31)).zoomed(zoom);
            let place = [70.0, -40.0, 110.0];
            let (flat, wanted) = (<Here as Room<3>>::flat(&viewer, viewer.pixel(place)), viewer.flat(place));
            // Pixels are whole.
            let grain = 0.5 / viewer.look.scale() + 1e-9;
            assert!((0..2).all(|d| (flat[d] - wanted[d]).abs() <= grain), "{flat:?} {wanted:?}");
        }
        assert_eq!(<Here as Room<2>>::flat(&Field, Field.pixel([100.0, 50.0])), [100.0, 50.0]);
    }
}
