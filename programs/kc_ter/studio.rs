//! The scene while it is worked on: selection, pages, mouse, keys and questions.

use super::commands::{COMMANDS, Do};
use super::edit::{self, Index};
use super::eye::{Eye, FIELD};
use super::lengths::Lengths;
use super::mouse::Grip;
use super::paint::{self, Show};
use super::rows;
use super::shape::{Shape, Shapes};
use super::{status, texts};
use crate::design::ec::{Bases, patch_space};
use crate::file::ec::{EcDocument, Fill, Item, Scene, SpaceFile, values};
use crate::file::{Document, Format};
use crate::geometry::ec::{Real, Root, Space};
use crate::geometry::{ParamSurface, Point};
use crate::machine::{Asked, Asking, Language, Machine, Manner};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Phrase};
use crate::ui::{Desk, Hint, Manual, Picture, TOP, page, raised, sunken};
use crate::work::{self, History, Next, Work};
use serde::Serialize;
use std::time::Duration;

/// A page of the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Page {
    View,
    Curve,
    Surface,
    Point,
}

impl Page {
    pub(super) const ALL: [Page; 4] = [Page::View, Page::Curve, Page::Surface, Page::Point];
}

/// The program's state.
pub(super) struct Studio {
    pub(super) history: History<Scene>,
    /// The scene while something is dragged.
    pub(super) preview: Option<Scene>,
    pub(super) selected: Option<usize>,
    pub(super) point: Option<Index>,
    pub(super) page: Page,
    pub(super) eye: Eye,
    pub(super) shapes: Shapes,
    pub(super) bases: Bases,
    /// The root that elevation adds, the direction and the place of division, and the step of coordinates.
    pub(super) order: Root,
    pub(super) along: usize,
    pub(super) at: Option<Real>,
    pub(super) step: f64,
    pub(super) grip: Option<Grip>,
    pub(super) polygons: bool,
    pub(super) inspection: Option<Fill>,
    pub(super) section: Option<(usize, f64)>,
    /// The row of the list of items, while it is open.
    pub(super) list: Option<usize>,
    /// The picture alone, perhaps in wires.
    pub(super) result: Option<bool>,
    pub(super) copied: Option<Item>,
    pub(super) kept_space: Option<SpaceFile>,
    pub(super) lengths: Lengths,
    pub(super) now: Duration,
    pub(super) manner: Manner,
    /// A mark at a parameter of the selected curve, while a place is asked for.
    pub(super) mark: Option<Point<3>>,
}

/// Works until the end.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(super) async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Asked<()> {
    let studio = Studio::new(machine.manner());
    work::run(studio, &mut Desk::new(machine, manual), document).await
}

impl Studio {
    fn new(manner: Manner) -> Studio {
        Studio {
            history: History::new(Scene::default()),
            preview: None,
            selected: None,
            point: None,
            page: Page::View,
            eye: Eye::default(),
            shapes: Shapes::default(),
            bases: Bases::default(),
            order: Root::zero(1),
            along: 0,
            at: None,
            step: 1.0,
            grip: None,
            polygons: false,
            inspection: None,
            section: None,
            list: None,
            result: None,
            copied: None,
            kept_space: None,
            lengths: Lengths::default(),
            now: Duration::ZERO,
            manner,
            mark: None,
        }
    }

    pub(super) fn scene(&self) -> &Scene {
        self.preview.as_ref().unwrap_or_else(|| self.history.now())
    }

    pub(super) fn item(&self) -> Option<&Item> {
        self.scene().items.get(self.selected?)
    }

    pub(super) fn critical(&self, space: &Space) -> Option<f64> {
        self.lengths.of(space)
    }

    /// Commits a scene.
    pub(super) fn change(&mut self, scene: Scene) {
        self.history.change(scene);
        self.settle_selection();
    }

    /// Commits the scene with another selected item; what is joined with it follows.
    pub(super) fn change_item(&mut self, item: Item) {
        let Some(at) = self.selected else { return };
        let scene = self.with_item(at, item);
        self.change(scene);
    }

    pub(super) fn with_item(&mut self, at: usize, item: Item) -> Scene {
        let mut scene = self.history.now().clone();
        if let Some(slot) = scene.items.get_mut(at) {
            *slot = item;
        }
        if !scene.joins.is_empty() {
            edit::keep_joins(&mut scene, at, &mut self.bases);
        }
        scene
    }

    /// Adds items, selects the first of them and opens its page.
    pub(super) fn add(&mut self, items: Vec<Item>) {
        let mut scene = self.history.now().clone();
        let first = scene.items.len();
        scene.items.extend(items);
        self.change(scene);
        self.select(Some(first));
    }

    pub(super) fn select(&mut self, item: Option<usize>) {
        (self.selected, self.point, self.at) = (item, None, None);
        self.page = match self.item() {
            Some(Item::Curve(_)) => Page::Curve,
            Some(Item::Patch(_)) => Page::Surface,
            None => Page::View,
        };
        self.settle_selection();
    }

    /// What is selected exists, and the page fits to it.
    pub(super) fn settle_selection(&mut self) {
        let count = self.scene().items.len();
        self.selected = self.selected.filter(|&at| at < count);
        self.point = self
            .point
            .filter(|&index| self.item().is_some_and(|it| edit::control_point(it, index).is_some()));
        self.list = self.list.filter(|_| count > 0).map(|row| row.min(count.saturating_sub(1)));
        if !self.is_open(self.page) {
            self.page = Page::View;
        }
        let interval = self.own_interval();
        let inside = |at: &Real| interval.is_some_and(|[start, end]| start < at.value() && at.value() < end);
        if !self.at.as_ref().is_some_and(inside) {
            self.at = interval.map(|[start, end]| Real::from(start / 2.0 + end / 2.0));
        }
    }

    pub(super) fn own_interval(&self) -> Option<[f64; 2]> {
        Some(match self.item()? {
            Item::Curve(curve) => values(&curve.interval),
            Item::Patch(patch) => values(patch_space(patch, self.along).1),
        })
    }

    /// Whether a page can be opened now.
    pub(super) fn is_open(&self, page: Page) -> bool {
        match page {
            Page::View => true,
            Page::Curve => matches!(self.item(), Some(Item::Curve(_))),
            Page::Surface => matches!(self.item(), Some(Item::Patch(_))),
            Page::Point => self.point.is_some(),
        }
    }

    pub(super) fn show(&self) -> Show {
        let wires = self.result == Some(true);
        Show {
            selected: self.selected.filter(|_| self.result.is_none()),
            point: self.point,
            polygons: self.polygons,
            handles: self.result.is_none(),
            fill: if wires { Some(Fill::Wires) } else { self.inspection },
            section: self.section,
        }
    }

    pub(super) fn point_name(&self) -> Option<String> {
        let [k, l] = self.point?;
        Some(match self.item()? {
            Item::Curve(_) => k.to_string(),
            Item::Patch(_) => format!("{k},{l}"),
        })
    }

    pub(super) fn coordinate(&self, axis: usize) -> Option<f64> {
        edit::control_point(self.item()?, self.point?)?.get(axis).copied()
    }

    pub(super) fn set_coordinate(&mut self, axis: usize, value: f64) {
        let (Some(item), Some(index)) = (self.item().cloned(), self.point) else { return };
        let Some(mut place) = edit::control_point(&item, index) else { return };
        if let Some(slot) = place.get_mut(axis) {
            *slot = value.clamp(-edit::FARTHEST, edit::FARTHEST);
        }
        self.change_item(edit::with_point(item, index, place));
    }

    /// Chooses the next control point, or the one before, around.
    pub(super) fn step_point(&mut self, forward: bool) {
        let Some(item) = self.item() else { return };
        let points = edit::control_points(item);
        let count = points.len();
        let at = self.point.and_then(|index| points.iter().position(|(it, _)| *it == index));
        let next = match at {
            Some(at) => (at + if forward { 1 } else { count - 1 }) % count.max(1),
            None => 0,
        };
        self.point = points.get(next).map(|(index, _)| *index);
    }

    /// Moves the place of division by a hundredth of the interval.
    pub(super) fn step_place(&mut self, forward: bool) {
        let (Some([start, end]), Some(at)) = (self.own_interval(), &self.at) else { return };
        let step = (end - start) / 100.0 * if forward { 1.0 } else { -1.0 };
        self.at = Some(Real::from((at.value() + step).clamp(start + step.abs(), end - step.abs())));
    }

    /// What the elevation would do, in few letters; red where the larger space has no basis on the interval.
    pub(super) fn elevation_told(&self) -> (String, Color) {
        let Some(item) = self.item() else { return (String::new(), Color::Black) };
        let (space, interval) = match item {
            Item::Curve(curve) => (&curve.space, &curve.interval),
            Item::Patch(patch) => patch_space(patch, self.along),
        };
        let count = space.dimension();
        match space.with(&self.order) {
            Ok(larger) => {
                let [start, end] = values(interval);
                let short = self.lengths.of(&larger).is_some_and(|length| end - start >= length);
                let color = if short { Color::LightRed } else { Color::Blue };
                (format!("{count}->{}", larger.dimension()), color)
            }
            Err(_) => (format!("{count}->?"), Color::LightRed),
        }
    }

    pub(super) fn fit(&mut self) {
        self.shapes.follow(self.preview.as_ref().unwrap_or(self.history.now()), &mut self.bases);
        if let Some(bounds) = self.shapes.bounds(None) {
            self.eye = self.eye.fitted(bounds);
        }
    }
}

impl Picture for Studio {
    fn draw(&self, screen: &mut Screen, language: Language) {
        if self.result.is_some() {
            paint::paint(screen, paint::WHOLE, self.eye, self.scene(), &self.shapes, self.show());
            screen.text(5, 5, words::BACK.of(language), Color::LightGray);
            return;
        }
        screen.clear(Color::LightCyan);
        sunken(screen, crate::ui::Area::new(FIELD.x1 - 4, FIELD.y1 - 4, FIELD.x2 + 4, FIELD.y2 + 4), 4);
        paint::paint(screen, FIELD, self.eye, self.scene(), &self.shapes, self.show());
        if let Some(mark) = self.mark {
            let (x, y) = self.eye.pixel(mark);
            if FIELD.holds(x - 6, y - 6) && FIELD.holds(x + 6, y + 6) {
                let stroke = crate::screen::Stroke::thin(Color::Yellow);
                screen.line(x - 5, y, x + 5, y, stroke);
                screen.line(x, y - 5, x, y + 5, stroke);
            }
        }
        screen.text(30, 6, texts::PAGE.of(language), Color::Black);
        page(screen, TOP);
        self.draw_page_buttons(screen, language);
        COMMANDS.draw(screen, language);
        self.draw_closed_pages(screen, language);
        rows::draw(self, screen, language);
        status::draw(self, self.list, screen, language);
    }

    fn figure(&self) -> Option<crate::figure::Figure> {
        status::figure(self)
    }

    fn surfaces(&self) -> Vec<Box<dyn ParamSurface>> {
        let shapes = (0..self.scene().items.len()).filter_map(|at| self.shapes.of(at));
        let patches = shapes.filter_map(|shape| match shape {
            Shape::Patch { weave, .. } => Some(Box::new(weave.clone()) as Box<dyn ParamSurface>),
            _ => None,
        });
        patches.collect()
    }

    fn hint(&self) -> Option<Hint> {
        if self.result.is_some() {
            return None;
        }
        let text = match (self.list, self.point, self.item()) {
            (Some(_), ..) => texts::HINT_ITEMS,
            (_, Some(_), _) => texts::HINT_POINT,
            (_, _, Some(_)) => texts::HINT_CURVE,
            _ if self.scene().items.is_empty() => texts::HINT_EMPTY,
            _ => texts::HINT_NONE,
        };
        Some(Hint::new(text))
    }
}

impl Studio {
    /// The open page's button has white ground.
    pub(super) fn draw_page_buttons(&self, screen: &mut Screen, _: Language) {
        let at = |page: Page| Page::ALL.iter().position(|&it| it == page).unwrap_or(0);
        let places = [(30, 21), (30, 38), (120, 21), (120, 38)];
        let (x, y) = places[at(self.page)];
        screen.bar(x, y, x + 70, y + 12, Color::White);
    }

    /// A page that cannot be opened has grey letters.
    pub(super) fn draw_closed_pages(&self, screen: &mut Screen, language: Language) {
        for page in Page::ALL.into_iter().filter(|&page| !self.is_open(page)) {
            let button =
                COMMANDS.0.iter().find(|it| matches!(it.action, Some(Do::Page(other)) if other == page));
            if let Some(crate::ui::Button { x, y, text }) = button.and_then(|it| it.button) {
                screen.bar(x, y, x + 70, y + 12, Color::LightCyan);
                raised(screen, crate::ui::Area::new(x, y, x + 70, y + 12), 1);
                let whole = format!("{}{}", text.letter, text.rest.of(language));
                screen.text(x + 4, y + 2, &whole, Color::LightGray);
            }
        }
    }
}

impl Work for Studio {
    type Value = Scene;

    fn format(&self) -> Format {
        Format::Kcj
    }

    fn saved_as(&self) -> Option<Format> {
        Some(Format::Kcj)
    }

    fn extensions(&self) -> Vec<&'static str> {
        [Format::Kcj, Format::Kcg, Format::Kcf, Format::Kce, Format::Kct].map(Format::extension).into()
    }

    fn history(&mut self) -> &mut History<Scene> {
        &mut self.history
    }

    fn reset(&mut self) {
        let kept = self.kept_space.take();
        let copied = self.copied.take();
        *self = Studio { kept_space: kept, copied, ..Studio::new(self.manner) };
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let Document::Ec(document) = document else { return Err(texts::NO_DOCUMENT.into()) };
        let scene = self.scene_of(document)?;
        // A scene whose items have no shape is refused as a whole.
        let checked = self.bases.shapes(&EcDocument::Scene(scene.clone()));
        checked.map_err(|error| Phrase::plain(&error))?;
        let eye = scene.view.as_ref().map(Eye::of);
        self.history = History::new(Scene { view: None, ..scene });
        self.select(None);
        match eye {
            Some(eye) => self.eye = eye,
            None => self.fit(),
        }
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        let scene = Scene { view: Some(self.eye.to_file()), ..self.history.now().clone() };
        Ok(EcDocument::Scene(scene).into())
    }

    fn model(&self) -> impl Serialize + 'static {
        self.told()
    }

    fn settle(&mut self) {
        (self.grip, self.preview) = (None, None);
    }

    async fn ask_first(&mut self, _: &mut Desk<'_>) -> Asked<bool> {
        Ok(true)
    }

    fn look(&mut self, desk: &Desk<'_>) {
        (self.now, self.manner) = (desk.machine.now(), desk.machine.manner());
        self.settle_selection();
        self.lengths.advance(self.preview.as_ref().unwrap_or(self.history.now()));
        self.shapes.follow(self.preview.as_ref().unwrap_or(self.history.now()), &mut self.bases);
    }

    fn due(&self) -> Option<Duration> {
        self.lengths.busy(self.scene()).then_some(Duration::ZERO)
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        loop {
            let tick = work::event(self, desk).await?;
            self.point_pointer(desk, &tick);
            if self.look_around(&tick) {
                continue;
            }
            if let Some(next) = self.obey(desk, &tick).await.unless_cancelled()?.flatten() {
                return Ok(next);
            }
        }
    }
}
