//! What differs between curves of the plane and of space.

use super::tables::{self, Action};
use super::{Curves, Tools};
use crate::design::{Place, Sketch};
use crate::editor::lens::{Field, Lens};
use crate::editor::picture::{Layer as Part, Page};
use crate::editor::{Craft, Editor, place};
use crate::file::{Document, FIELD, Format, PlanePoints, SPACE_VIEW, SpacePoints};
use crate::geometry::Point;
use crate::machine::Asked;
use crate::screen::Color;
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::words::{self, Words};
use crate::ui::{Commands, Desk};

/// What differs between the plane and space.
pub(super) trait Ambient<const D: usize>: Sized {
    type Lens: Lens<D> + 'static;
    /// Where new points are taken from.
    const STORE: Option<Point<D>>;
    /// The fill colour of control points.
    const FILL: Color;
    /// Whether a curve that has disappeared is shown again while a point is dragged.
    const LIVE: bool;
    fn lens() -> Self::Lens;
    fn format(tools: Tools) -> Format;
    fn commands(tools: Tools) -> Commands<Action>;
    /// The place of a pixel on the empty ground; `None` where a pixel is no place.
    fn open_place(_: (i32, i32)) -> Option<Point<D>> {
        None
    }
    /// The sketch of a document of this kind.
    fn sketch(document: &Document) -> Result<Sketch<D>, Words>;
    fn document(sketch: Sketch<D>) -> Document;
    async fn ask_place(editor: &Editor<Curves<D>, D>, desk: &mut Desk<'_>) -> Asked<Point<D>>
    where
        Curves<D>: Craft<D>;
    /// Changes the tangent at a point, where there are tangents.
    async fn change_tangent(_: &mut Editor<Curves<D>, D>, _: &mut Desk<'_>, _: usize) -> Asked<()>
    where
        Curves<D>: Craft<D>,
    {
        Ok(())
    }
    /// Azimuth, elevation and zoom, where there are any.
    fn angles(_: &Self::Lens) -> Option<[f64; 3]> {
        None
    }
    /// Draws the layers that differ.
    fn draw(_: &Editor<Curves<D>, D>, _: Part, _: &mut Page<'_>)
    where
        Curves<D>: Craft<D>,
    {
    }
}

impl Ambient<2> for Curves<2> {
    type Lens = Field;
    const STORE: Option<Point<2>> = Some([577.0, 360.0]);
    const FILL: Color = Color::DarkGray;
    const LIVE: bool = false;

    fn lens() -> Field {
        Field
    }

    fn format(tools: Tools) -> Format {
        if tools == Tools::Tangents { Format::Ic2 } else { Format::Ip2 }
    }

    fn commands(tools: Tools) -> Commands<Action> {
        match tools {
            Tools::Methods => tables::METHODS,
            Tools::Tangents => tables::TANGENTS,
            Tools::Beta => tables::BETA,
            Tools::Own => Commands(&[]),
        }
    }

    fn sketch(document: &Document) -> Result<Sketch<2>, Words> {
        match document {
            Document::PlanePoints(plane) => Ok(PlanePoints::clone(plane).into()),
            _ => Err(words::WRONG_CONTENT),
        }
    }

    fn document(sketch: Sketch<2>) -> Document {
        sketch.into()
    }

    fn open_place((x, y): (i32, i32)) -> Option<Point<2>> {
        Some(Field.place((x, y))).filter(|at| at.fits())
    }

    async fn ask_place(editor: &Editor<Curves<2>, 2>, desk: &mut Desk<'_>) -> Asked<Point<2>> {
        place::ask_place_in_field(desk, editor, FIELD).await
    }

    async fn change_tangent(
        editor: &mut Editor<Curves<2>, 2>,
        desk: &mut Desk<'_>,
        index: usize,
    ) -> Asked<()> {
        editor.change_tangent(desk, index).await
    }

    fn draw(editor: &Editor<Curves<2>, 2>, layer: Part, page: &mut Page<'_>) {
        if layer == Part::Under && !editor.stage.is_result() {
            // It ends where the original's word does.
            let store = words::STORE.of(page.language);
            let width = 8 * i32::try_from(store.chars().count()).unwrap_or(0);
            page.screen.text(631 - width, 67, store, Color::White);
        }
    }
}

impl Ambient<3> for Curves<3> {
    type Lens = Viewer;
    const STORE: Option<Point<3>> = None;
    const FILL: Color = Color::Black;
    const LIVE: bool = true;

    fn lens() -> Viewer {
        Viewer::new(Look::new(SPACE_VIEW, Poles::Stop))
    }

    fn format(_: Tools) -> Format {
        Format::Ip3
    }

    fn commands(tools: Tools) -> Commands<Action> {
        if tools == Tools::Beta { tables::SPACE_BETA } else { tables::SPACE_METHODS }
    }

    fn sketch(document: &Document) -> Result<Sketch<3>, Words> {
        match document {
            Document::SpacePoints(space) => Ok(SpacePoints::clone(space).into()),
            _ => Err(words::NOT_IN_SPACE),
        }
    }

    fn document(sketch: Sketch<3>) -> Document {
        sketch.into()
    }

    async fn ask_place(editor: &Editor<Curves<3>, 3>, desk: &mut Desk<'_>) -> Asked<Point<3>> {
        place::ask_place(desk, editor, words::PLACE_3D).await
    }

    fn angles(lens: &Viewer) -> Option<[f64; 3]> {
        Some(lens.look.angles())
    }
}
