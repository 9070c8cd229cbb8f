//! The scene while it is worked on: selection, pages, mouse, keys and questions.

use super::edit::{self, Affine, Index};
use super::eye::{Eye, FIELD};
use super::paint::{self, Show};
use super::rows::{self, Action, Hit, Value, Way};
use super::shape::{Shape, Shapes};
use super::{coefficients, pointers, space, speed, status, texts};
use crate::design::ec::{
    Bases, MOST_PARTS, coefficients as coefficients_of, equal_parts, fewest_parts, patch_space,
};
use crate::file::ec::{Coefficients, EcDocument, Fill, Interval, Item, Join, Scene, SpaceFile, values};
use crate::file::{Document, Format};
use crate::geometry::ec::{CriticalLength, EcError, Real, Root, Space};
use crate::geometry::{ParamCurve, ParamSurface, Point};
use crate::machine::{Asked, Asking, Button, Event, Key, Language, Machine, Manner, Tick};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Hot, Phrase, Words};
use crate::ui::{
    Answer, Command, Commands, Desk, Hint, KeyHelp, Manual, Picture, Question, Stay, TOP, page, raised,
    sunken,
};
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

/// What a command does.
#[derive(Clone, Copy)]
enum Do {
    Page(Page),
    Change,
    New,
    Result,
    Roots,
    Delete,
    Quit,
    Polygons,
    Inspect,
    Section,
    Speed,
    Copy,
    Paste,
    NextItem,
    Home,
    Larger,
    Smaller,
}

const fn button(x: i32, y: i32, text: Hot) -> crate::ui::Button {
    crate::ui::Button::new(x, y, text)
}

const COMMANDS: Commands<Do> = Commands(&[
    Command::button(
        button(30, 21, Hot::new('1', " Nézet", " View")),
        texts::HELP_PAGES,
        Do::Page(Page::View),
    ),
    Command::button(
        button(30, 38, Hot::new('2', " Görbe", " Curve")),
        texts::HELP_PAGES,
        Do::Page(Page::Curve),
    )
    .untold(),
    Command::button(
        button(120, 21, Hot::new('3', " Felül.", " Surf.")),
        texts::HELP_PAGES,
        Do::Page(Page::Surface),
    )
    .untold(),
    Command::button(
        button(120, 38, Hot::new('4', " Pont", " Point")),
        texts::HELP_PAGES,
        Do::Page(Page::Point),
    )
    .untold(),
    Command::button(button(460, 4, Hot::new('V', "áltozás", "-change")), texts::HELP_CHANGE, Do::Change),
    Command::button(button(460, 21, Hot::new('B', "-új", "-new")), texts::HELP_NEW, Do::New),
    Command::button(button(460, 38, Hot::new('E', "redmény", "-result")), texts::HELP_RESULT, Do::Result),
    Command::button(button(550, 4, Hot::new('G', "yökök", "-roots")), texts::HELP_ROOTS, Do::Roots),
    Command::button(button(550, 21, Hot::new('T', "örlés", "-delete")), texts::HELP_NEW, Do::Delete).untold(),
    Command::button(button(550, 38, Hot::new('Q', "-kilép", "-quit")), texts::HELP_QUIT, Do::Quit),
    Command::told(texts::HELP_PANEL),
    Command::told(texts::HELP_SELECT),
    Command::also(Key::Tab, Do::NextItem),
    Command::told(texts::HELP_DRAG),
    Command::told(texts::HELP_TURN),
    Command::told(texts::HELP_ZOOM),
    Command::also(Key::Home, Do::Home),
    Command::key(Key::PageUp, texts::HELP_SCALE, Do::Larger),
    Command::also(Key::PageDown, Do::Smaller),
    Command::key(Key::F(3), texts::HELP_POLYGONS, Do::Polygons),
    Command::key(Key::F(5), texts::HELP_INSPECT, Do::Inspect),
    Command::also(Key::F(6), Do::Section),
    Command::key(Key::F(7), texts::HELP_SPEED, Do::Speed),
    Command::key(Key::Ctrl('C'), texts::HELP_COPY, Do::Copy),
    Command::also(Key::Ctrl('V'), Do::Paste),
    Command::told(texts::HELP_UNDO),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

/// What the mouse holds.
#[derive(Clone, Debug)]
struct Grip {
    button: Button,
    from: (i32, i32),
    what: Held,
    /// Whether the mouse has moved so far that it is no click.
    moved: bool,
}

#[derive(Clone, Debug)]
enum Held {
    View(Eye),
    Item(Box<Item>),
    Point(Index, Point<3>),
}

/// How far a drag has to go.
const DRAG: i32 = 2;
/// How near the mouse has to be to a control point.
const NEAR: i32 = 8;

/// The program's state.
pub(super) struct Studio {
    pub(super) history: History<Scene>,
    /// The scene while something is dragged.
    preview: Option<Scene>,
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
    grip: Option<Grip>,
    polygons: bool,
    inspection: Option<Fill>,
    section: Option<(usize, f64)>,
    /// The row of the list of items, while it is open.
    list: Option<usize>,
    /// The picture alone, perhaps in wires.
    result: Option<bool>,
    copied: Option<Item>,
    pub(super) kept_space: Option<SpaceFile>,
    lengths: Lengths,
    now: Duration,
    manner: Manner,
    /// A mark at a parameter of the selected curve, while a place is asked for.
    mark: Option<Point<3>>,
}

/// Critical lengths that are known, and the search for the next.
#[derive(Default)]
pub(super) struct Lengths {
    known: Vec<(Space, f64)>,
    search: Option<(Space, CriticalLength)>,
}

impl Lengths {
    pub(super) fn of(&self, space: &Space) -> Option<f64> {
        self.known.iter().find(|(known, _)| known == space).map(|(_, length)| *length)
    }

    /// Advances the search for the spaces of a scene by some steps.
    fn advance(&mut self, scene: &Scene) {
        if self.search.is_none() {
            let spaces = scene.items.iter().flat_map(|item| match item {
                Item::Curve(curve) => vec![&curve.space],
                Item::Patch(patch) => vec![&patch.space_u, &patch.space_v],
            });
            let unknown = spaces.into_iter().find(|space| self.of(space).is_none());
            self.search = unknown.map(|space| (space.clone(), CriticalLength::new(space)));
        }
        if let Some((unknown, search)) = &mut self.search
            && let Some(length) = (0..space::budget(unknown.dimension())).find_map(|_| search.advance())
        {
            self.known.push((unknown.clone(), length));
            self.search = None;
            // Enough for every scene, and no more than a session needs.
            if self.known.len() > KEPT {
                self.known.remove(0);
            }
        }
    }

    fn busy(&self, scene: &Scene) -> bool {
        self.search.is_some()
            || scene.items.iter().any(|item| match item {
                Item::Curve(curve) => self.of(&curve.space).is_none(),
                Item::Patch(patch) => [&patch.space_u, &patch.space_v].iter().any(|it| self.of(it).is_none()),
            })
    }
}

/// Spaces whose lengths are kept.
const KEPT: usize = 200;

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    page: Page,
    selected: Option<Selected>,
    view: crate::file::ec::SceneView,
    settings: crate::file::ec::SceneSettings,
    items: Vec<Dumped>,
    joins: Vec<Join>,
    unsaved: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    dialog: Option<space::Told>,
}

#[derive(Serialize)]
struct Selected {
    item: usize,
    point: Option<Vec<usize>>,
}

#[derive(Serialize)]
struct Dumped {
    #[serde(flatten)]
    item: Item,
    is_exact: bool,
    hidden: bool,
    length: Vec<f64>,
    critical: Vec<Option<f64>>,
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
    fn change_item(&mut self, item: Item) {
        let Some(at) = self.selected else { return };
        let scene = self.with_item(at, item);
        self.change(scene);
    }

    fn with_item(&mut self, at: usize, item: Item) -> Scene {
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
    fn add(&mut self, items: Vec<Item>) {
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
    fn settle_selection(&mut self) {
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

    fn own_interval(&self) -> Option<[f64; 2]> {
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

    /// What the mouse points at: a control point of the selected item, the selected item, another one, or nothing.
    fn under(&self, at: (i32, i32)) -> Under {
        let radius = paint::radius(self.scene(), self.show()).max(NEAR);
        if let Some(item) = self.item() {
            let points = edit::control_points(item).into_iter();
            let near = points.filter_map(|(index, point)| {
                let (x, y) = self.eye.pixel(point);
                let away = (x - at.0).pow(2) + (y - at.1).pow(2);
                (away <= radius.pow(2)).then_some((index, away))
            });
            if let Some((index, _)) = near.min_by_key(|(_, away)| *away) {
                return Under::Point(index);
            }
        }
        let items = self.scene().items.iter().enumerate().filter(|(_, item)| !paint::is_hidden(item));
        let hits = items.filter_map(|(number, _)| {
            let depth = paint::hit(self.shapes.of(number)?, self.eye, at)?;
            Some((number, depth))
        });
        match hits.max_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((number, _)) if self.selected == Some(number) => Under::Selected,
            Some((number, _)) => Under::Item(number),
            None => Under::Nothing,
        }
    }

    /// Takes up an event of the mouse in the picture, and turns and zooms by keys; whether it was for that.
    fn look_around(&mut self, tick: &Tick) -> bool {
        let at = (tick.mouse.x, tick.mouse.y);
        if let Some(grip) = self.grip.take() {
            return self.drag(grip, tick);
        }
        let in_picture = self.result.is_some() || paint::in_field(at);
        match tick.event {
            Some(Event::Press(button @ (Button::Left | Button::Right))) if in_picture => {
                let what = self.taken(button, at);
                self.grip = Some(Grip { button, from: at, what, moved: false });
                true
            }
            Some(Event::Wheel(steps)) if in_picture => {
                self.eye = self.eye.zoomed(steps, at);
                true
            }
            Some(Event::Key(Key::Char(sign @ ('+' | '-')))) => {
                let forward = sign == '+';
                match &mut self.section {
                    Some((axis, offset)) => {
                        let extent = self.shapes.bounds(None).map_or(1.0, |it| it.extent());
                        let step = extent / 50.0 * if forward { 1.0 } else { -1.0 };
                        let (axis, moved) = (*axis, (*offset + step).clamp(-edit::FARTHEST, edit::FARTHEST));
                        self.section = Some((axis, moved));
                    }
                    None => self.eye = self.eye.zoomed(if forward { 1 } else { -1 }, (252, 261)),
                }
                true
            }
            Some(Event::Key(key)) => {
                let eye = self.eye.after(key);
                self.eye = eye.unwrap_or(self.eye);
                eye.is_some()
            }
            _ => false,
        }
    }

    /// What a press of a button takes up. A press on an item selects it.
    fn taken(&mut self, button: Button, at: (i32, i32)) -> Held {
        if self.result.is_some() {
            return Held::View(self.eye);
        }
        match (self.under(at), button) {
            (Under::Point(index), Button::Left) => {
                let place = self.item().and_then(|item| edit::control_point(item, index));
                self.point = Some(index);
                self.page = Page::Point;
                Held::Point(index, place.unwrap_or_default())
            }
            (Under::Selected | Under::Point(_), _) => {
                self.item().map_or(Held::View(self.eye), |item| Held::Item(Box::new(item.clone())))
            }
            (Under::Item(number), Button::Left) => {
                self.select(Some(number));
                Held::View(self.eye)
            }
            _ => Held::View(self.eye),
        }
    }

    /// Goes on with what the mouse holds.
    fn drag(&mut self, mut grip: Grip, tick: &Tick) -> bool {
        let at = (tick.mouse.x, tick.mouse.y);
        let by = (at.0 - grip.from.0, at.1 - grip.from.1);
        if tick.pressed(Key::Esc) {
            if let Held::View(eye) = grip.what {
                self.eye = eye;
            }
            self.preview = None;
            return true;
        }
        grip.moved |= by.0.abs() > DRAG || by.1.abs() > DRAG;
        if grip.moved {
            self.preview = self.dragged(&grip, by);
        }
        let released = tick.event == Some(Event::Release(grip.button)) || !tick.mouse.holds(grip.button);
        if !released {
            self.grip = Some(grip);
            return true;
        }
        match (self.preview.take(), &grip.what) {
            (Some(scene), _) => self.change(scene),
            // A click on nothing selects nothing.
            (None, Held::View(_)) if !grip.moved && grip.button == Button::Left && self.result.is_none() => {
                if matches!(self.under(at), Under::Nothing) {
                    self.select(None);
                }
            }
            _ => {}
        }
        true
    }

    /// The scene with what is held moved or turned; a view has none.
    fn dragged(&mut self, grip: &Grip, by: (i32, i32)) -> Option<Scene> {
        let at = self.selected;
        let movement = self.eye.movement(by);
        match &grip.what {
            Held::View(eye) => {
                self.eye = match grip.button {
                    Button::Left if self.result.is_none() => eye.moved_by(by),
                    _ => eye.turned_by(by),
                };
                None
            }
            Held::Item(item) => {
                let map = match grip.button {
                    Button::Left => Affine::moved(movement),
                    _ => Affine::about(self.eye.rotation(by), edit::middle(item)),
                };
                Some(self.with_item(at?, edit::mapped(item, &map)))
            }
            Held::Point(index, place) => {
                let item = self.history.now().items.get(at?)?.clone();
                let moved =
                    std::array::from_fn(|d| (place[d] + movement[d]).clamp(-edit::FARTHEST, edit::FARTHEST));
                Some(self.with_item(at?, edit::with_point(item, *index, moved)))
            }
        }
    }

    fn fit(&mut self) {
        self.shapes.follow(self.preview.as_ref().unwrap_or(self.history.now()), &mut self.bases);
        if let Some(bounds) = self.shapes.bounds(None) {
            self.eye = self.eye.fitted(bounds);
        }
    }

    /// The scene of a document.
    fn scene_of(&mut self, document: &EcDocument) -> Result<Scene, Phrase> {
        match document {
            EcDocument::Space(file) => {
                let curve = self.curve_over(file).map_err(|error| texts::problem(&error))?;
                Ok(curve.into())
            }
            EcDocument::Coefficients(coefficients) => {
                let items = self.bases.strips(coefficients, [None; 2]);
                let items = items.map_err(|error| texts::problem(&error))?;
                Ok(Scene { items, ..Scene::default() })
            }
            other => self.bases.scene(other).map_err(|error| Phrase::plain(&error)),
        }
    }

    /// A new curve over a space.
    fn curve_over(&mut self, file: &SpaceFile) -> Result<Item, EcError> {
        let Item::Curve(mut curve) = edit::new_curve(0) else { return Ok(edit::new_curve(0)) };
        let interval = file.interval.clone().unwrap_or([0.0.into(), 1.0.into()]);
        self.bases.of(&file.space, values(&interval))?;
        curve.points = space::fitting_points(&curve.points, file.space.dimension());
        (curve.space, curve.interval, curve.name) = (file.space.clone(), interval, file.name.clone());
        Ok(Item::Curve(curve))
    }

    pub(super) fn told(&self) -> impl Serialize + 'static {
        self.model_with(None)
    }

    fn model_with(&self, dialog: Option<space::Told>) -> Model {
        let scene = self.scene();
        let items = scene.items.iter().map(|item| {
            let spaces: Vec<(&Space, &Interval)> = match item {
                Item::Curve(curve) => vec![(&curve.space, &curve.interval)],
                Item::Patch(patch) => vec![patch_space(patch, 0), patch_space(patch, 1)],
            };
            let length = |interval: &Interval| interval[1].value() - interval[0].value();
            Dumped {
                item: item.clone(),
                is_exact: edit::is_exact(item),
                hidden: paint::is_hidden(item),
                length: spaces.iter().map(|(_, interval)| length(interval)).collect(),
                critical: spaces
                    .iter()
                    .map(|(space, _)| self.lengths.of(space).filter(|length| length.is_finite()))
                    .collect(),
            }
        });
        let selected = self.selected.map(|item| Selected {
            item,
            point: self.point.map(|index| match self.item() {
                Some(Item::Patch(_)) => index.to_vec(),
                _ => vec![index[0]],
            }),
        });
        Model {
            page: self.page,
            selected,
            view: self.eye.to_file(),
            settings: scene.settings.clone(),
            items: items.collect(),
            joins: scene.joins.clone(),
            unsaved: self.history.unsaved(),
            dialog,
        }
    }

    /// Publishes the model while a dialog is open.
    pub(super) fn publish(&self, desk: &mut Desk<'_>, dialog: space::Told) {
        desk.machine.publish(self.model_with(Some(dialog)));
    }
}

/// What lies under the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Under {
    Nothing,
    Item(usize),
    Selected,
    Point(Index),
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
    fn draw_page_buttons(&self, screen: &mut Screen, _: Language) {
        let at = |page: Page| Page::ALL.iter().position(|&it| it == page).unwrap_or(0);
        let places = [(30, 21), (30, 38), (120, 21), (120, 38)];
        let (x, y) = places[at(self.page)];
        screen.bar(x, y, x + 70, y + 12, Color::White);
    }

    /// A page that cannot be opened has grey letters.
    fn draw_closed_pages(&self, screen: &mut Screen, language: Language) {
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

impl Studio {
    fn point_pointer(&self, desk: &mut Desk<'_>, tick: &Tick) {
        let at = (tick.mouse.x, tick.mouse.y);
        let outside = self.result.is_some() || !paint::in_field(at);
        let under = if outside { Under::Nothing } else { self.under(at) };
        desk.machine.set_pointer(pointers::of(match (&self.grip, under) {
            (Some(Grip { what: Held::Item(_), .. }), _) => pointers::Shape::Move,
            (_, Under::Nothing) => pointers::Shape::Arrow,
            (_, Under::Item(_)) => pointers::Shape::Hand,
            (_, Under::Point(_)) => pointers::Shape::Point,
            (_, Under::Selected) => pointers::Shape::Move,
        }));
    }

    /// Carries out a key or a click; the next step if the scene is left.
    async fn obey(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> Asked<Option<Next>> {
        if self.result.is_some() {
            self.in_result(tick);
            return Ok(None);
        }
        if self.list.is_some() && self.in_list(tick) {
            return Ok(None);
        }
        if tick.pressed(Key::Esc) && (self.selected.is_some() || self.page != Page::View) {
            match self.point.take() {
                Some(_) if self.page == Page::Point => self.back_from_point(),
                _ => self.select(None),
            }
            return Ok(None);
        }
        if work::common_key(self, desk, tick.key()).await? {
            self.settle_selection();
            return Ok(None);
        }
        // Rows of the page first: their actions have letters that no command has.
        let letter = tick.letter().and_then(|letter| rows::action_of(self.page, letter));
        let clicked = tick.click().and_then(|at| rows::hit(self.page, at));
        match (letter, clicked) {
            (Some(action), _) | (_, Some(Hit::Action(action))) => {
                self.act(desk, action).await?;
                return Ok(None);
            }
            (_, Some(Hit::Value(value))) => {
                self.change_value(desk, value).await?;
                return Ok(None);
            }
            _ => {}
        }
        if let (Some(Event::Wheel(steps)), Some(Hit::Value(value))) =
            (tick.event, rows::hit(self.page, (tick.mouse.x, tick.mouse.y)))
        {
            self.turn(value, steps > 0);
            return Ok(None);
        }
        if let Some(row) = tick.click().and_then(|at| status::row_at(self, at)) {
            self.list = None;
            self.select(Some(row));
            return Ok(None);
        }
        match COMMANDS.find(tick) {
            Some(command) => self.command(desk, command).await,
            None => Ok(None),
        }
    }

    fn back_from_point(&mut self) {
        self.page = match self.item() {
            Some(Item::Patch(_)) => Page::Surface,
            _ => Page::Curve,
        };
    }

    fn in_result(&mut self, tick: &Tick) {
        match tick.key() {
            Some(Key::Esc) => self.result = None,
            Some(Key::Char('d' | 'D')) => self.result = Some(true),
            Some(Key::Char('t' | 'T')) => self.result = Some(false),
            Some(Key::Home) => self.fit(),
            _ => {}
        }
    }

    /// Moves in the list of items; whether the event was for that.
    fn in_list(&mut self, tick: &Tick) -> bool {
        let Some(row) = self.list else { return false };
        let last = self.scene().items.len().saturating_sub(1);
        match tick.key() {
            Some(Key::Up) => self.list = Some(row.saturating_sub(1)),
            Some(Key::Down) => self.list = Some((row + 1).min(last)),
            Some(Key::Enter) => {
                self.list = None;
                self.select(Some(row));
            }
            Some(Key::Char(' ')) => {
                let mut scene = self.history.now().clone();
                match scene.items.get_mut(row) {
                    Some(Item::Curve(curve)) => curve.style.hidden = !curve.style.hidden,
                    Some(Item::Patch(patch)) => patch.style.hidden = !patch.style.hidden,
                    None => {}
                }
                self.change(scene);
            }
            Some(Key::Esc) => self.list = None,
            _ => return false,
        }
        true
    }

    async fn command(&mut self, desk: &mut Desk<'_>, command: Do) -> Asked<Option<Next>> {
        match command {
            Do::Page(page) if self.is_open(page) => self.page = page,
            Do::Page(_) => desk.tell(texts::NOTHING_SELECTED, Stay::Briefly),
            Do::Change => {
                let value = self.ask_row(desk).await?;
                self.change_value(desk, value).await?;
            }
            Do::New => {
                let question = Question::new(TOP, texts::ASK_KIND, [texts::CURVE, texts::SURFACE]);
                let answer = desk.ask(&*self, &question).await?;
                let number = self.scene().items.len();
                self.add(vec![match answer {
                    Answer::First => edit::new_curve(number),
                    Answer::Second => edit::new_patch(number),
                }]);
                if number == 0 {
                    self.eye = Eye { zoom: 1.0, shift: [0.0; 2], ..self.eye };
                }
            }
            Do::Result => self.result = Some(false),
            Do::Roots => self.change_space(desk).await?,
            Do::Delete => self.delete(desk).await?,
            Do::Quit => {
                return work::quit(self, desk).await.map(|next| Some(next).filter(|it| *it != Next::Work));
            }
            Do::Polygons => self.polygons = !self.polygons,
            Do::Inspect => self.inspect(desk),
            Do::Section => {
                let middle = self
                    .shapes
                    .bounds(None)
                    .map_or([0.0; 3], |it| std::array::from_fn(|d| it.min[d] / 2.0 + it.max[d] / 2.0));
                self.section = match self.section {
                    None => Some((0, middle[0])),
                    Some((axis @ (0 | 1), _)) => Some((axis + 1, middle[axis + 1])),
                    Some(_) => None,
                };
            }
            Do::Speed => speed::measure(self, desk).await?,
            Do::Copy => match self.item().cloned() {
                Some(item) => {
                    self.copied = Some(item);
                    desk.tell(texts::COPIED, Stay::Briefly);
                }
                None => desk.tell(texts::NOTHING_SELECTED, Stay::Briefly),
            },
            Do::Paste => match self.copied.clone() {
                Some(item) => self.add(vec![item]),
                None => desk.tell(texts::NOTHING_KEPT, Stay::Briefly),
            },
            Do::NextItem => {
                let count = self.scene().items.len();
                let next = self.selected.map_or(0, |at| at + 1);
                self.select(Some(next).filter(|&next| next < count));
            }
            Do::Home => self.fit(),
            Do::Larger | Do::Smaller => {
                let factor = if matches!(command, Do::Larger) { 1.05 } else { 1.0 / 1.05 };
                match self.item().cloned() {
                    Some(item) => {
                        let map = Affine::scaled(factor, edit::middle(&item));
                        self.change_item(edit::mapped(&item, &map));
                    }
                    None => desk.tell(texts::NOTHING_SELECTED, Stay::Briefly),
                }
            }
        }
        Ok(None)
    }

    fn inspect(&mut self, desk: &mut Desk<'_>) {
        let order = [None, Some(Fill::Zebra), Some(Fill::Gaussian), Some(Fill::Mean), Some(Fill::Height)];
        let at = order.iter().position(|it| *it == self.inspection).unwrap_or(0);
        self.inspection = order[(at + 1) % order.len()];
        if let Some(fill) = self.inspection {
            let name = Fill::ALL.iter().position(|it| *it == fill).map(|at| texts::FILLS[at]);
            if let Some(name) = name {
                desk.tell(name, Stay::Briefly);
            }
        }
    }

    async fn delete(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some(at) = self.selected else {
            desk.tell(texts::NOTHING_SELECTED, Stay::Briefly);
            return Ok(());
        };
        if desk.ask(&*self, &Question::new(TOP, texts::ASK_DELETE, [words::YES, words::NO])).await?
            == Answer::First
        {
            let mut scene = self.history.now().clone();
            edit::replace(&mut scene, at, Vec::new());
            self.select(None);
            self.change(scene);
        }
        Ok(())
    }

    /// Asks for a row of the page by its letter.
    async fn ask_row(&mut self, desk: &mut Desk<'_>) -> Asked<Value> {
        let page_now = self.page;
        let letters = rows::rows(page_now).iter().filter_map(|row| match row {
            rows::Row::Value(letter, ..) => Some(*letter),
            _ => None,
        });
        let letters: String = letters.flat_map(|letter| [letter, ' ']).collect();
        let found = |tick: &Tick| {
            let clicked = tick.click().and_then(|at| match rows::hit(page_now, at) {
                Some(Hit::Value(value)) => Some(value),
                _ => None,
            });
            tick.letter().and_then(|letter| rows::value_of(page_now, letter)).or(clicked)
        };
        ask_key(desk, &*self, texts::ASK_ROW, &letters, found).await
    }

    /// Changes a value of the page: a choice turns, others are asked for.
    async fn change_value(&mut self, desk: &mut Desk<'_>, value: Value) -> Asked<()> {
        let name = rows::rows(self.page).iter().find_map(|row| match row {
            rows::Row::Value(letter, name, own) if *own == value => Some((*letter, *name)),
            _ => None,
        });
        let caption = name.map_or(Phrase::new("", ""), |(letter, name)| {
            let text = |language| format!("{letter}{}", name.of(language));
            Phrase::new(text(Language::Hungarian), text(Language::English))
        });
        let typed = self.typed(value);
        match value.way() {
            Way::Turn => self.turn(value, true),
            Way::Number([low, high]) => {
                let number = desk.meaning(&*self, caption, &typed, |text| number(text, [low, high])).await?;
                self.set(value, number);
            }
            Way::Whole(range) => {
                let read = |text: &str| whole(text, range);
                let number = desk.meaning(&*self, caption, &typed, read).await?;
                self.set_whole(value, [number; 2]);
            }
            Way::Pair(range) => {
                let read = |text: &str| {
                    let parts: Vec<&str> =
                        text.split(['x', 'X', ',', ' ']).filter(|it| !it.is_empty()).collect();
                    match parts.as_slice() {
                        [one] => whole(one, range).map(|number| [number; 2]),
                        [one, other] => Ok([whole(one, range)?, whole(other, range)?]),
                        _ => Err(texts::NO_WHOLE.into()),
                    }
                };
                let pair = desk.meaning(&*self, caption, &typed, read).await?;
                self.set_whole(value, pair);
            }
            Way::Place => {
                self.along = self.ask_direction(desk).await?;
                self.settle_selection();
                self.ask_place(desk).await?;
            }
            Way::Index => {
                let item = self.item().cloned();
                let read = |text: &str| {
                    let numbers: Option<Vec<usize>> = text
                        .split([',', ' '])
                        .filter(|it| !it.is_empty())
                        .map(|it| it.parse().ok())
                        .collect();
                    let numbers = numbers.unwrap_or_default();
                    let index = match (numbers.as_slice(), &item) {
                        ([k], Some(Item::Curve(_))) => Some([*k, 0]),
                        ([k, l], Some(Item::Patch(_))) => Some([*k, *l]),
                        _ => None,
                    };
                    let there = |index: &Index| {
                        item.as_ref().is_some_and(|it| edit::control_point(it, *index).is_some())
                    };
                    index.filter(there).ok_or_else(|| texts::NO_ITEM.into())
                };
                self.point = Some(desk.meaning(&*self, caption, &typed, read).await?);
            }
        }
        Ok(())
    }

    /// Along which direction of a patch; curves have one.
    async fn ask_direction(&mut self, desk: &mut Desk<'_>) -> Asked<usize> {
        if !matches!(self.item(), Some(Item::Patch(_))) {
            return Ok(0);
        }
        let question = Question::new(TOP, texts::ASK_DIRECTION, [texts::ALONG_U, texts::ALONG_V]);
        let proposed = if self.along == 0 { Answer::First } else { Answer::Second };
        let question = Question { proposed, ..question };
        let answer = desk.ask(&*self, &question).await?;
        self.along = usize::from(answer == Answer::Second);
        self.settle_selection();
        Ok(self.along)
    }

    /// Asks where to divide: typed, or by a click on the curve, along which a mark runs with the mouse.
    async fn ask_place(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some([start, end]) = self.own_interval() else { return Ok(()) };
        let inside = move |at: &Real| start < at.value() && at.value() < end;
        let mut entry = crate::ui::Entry::new(
            crate::ui::Area::new(TOP.0 + 6, TOP.1 + 19, TOP.0 + 234, TOP.1 + 33),
            (TOP.0 + 12, TOP.1 + 23),
            60,
            crate::ui::Accepts::Text,
        )
        .proposing(self.typed(Value::At));
        let asked = loop {
            let typing = crate::ui::Over::new(&*self, |screen: &mut Screen, language: Language| {
                page(screen, TOP);
                screen.text(TOP.0 + 8, TOP.1 + 5, texts::ASK_MIDDLE.of(language), Color::Black);
                entry.draw(screen);
            });
            let tick = match desk.event(&typing).await {
                Ok(tick) => tick,
                Err(stop) => break Err(stop),
            };
            let mouse = (tick.mouse.x, tick.mouse.y);
            let on_curve = self.place_under(mouse);
            self.mark = on_curve.and_then(|s| self.point_at(s));
            if let (Some(_), Some(s)) = (tick.click(), on_curve) {
                let at = Real::from(start + s * (end - start));
                if inside(&at) {
                    break Ok(at);
                }
            }
            match tick.key().map_or(crate::ui::Typed::On, |key| entry.key(key)) {
                crate::ui::Typed::On => {}
                crate::ui::Typed::Cancelled => break Err(crate::machine::Stop::Cancelled),
                crate::ui::Typed::Done => match Real::typed(&entry.text) {
                    Ok(at) if inside(&at) => break Ok(at),
                    Ok(at) => {
                        let error = EcError::Outside { at: at.value(), interval: [start, end] };
                        desk.tell(texts::problem(&error), Stay::UntilRead);
                    }
                    Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
                },
            }
        };
        self.mark = None;
        self.at = Some(asked?);
        Ok(())
    }

    fn place_under(&self, at: (i32, i32)) -> Option<f64> {
        match self.shapes.of(self.selected?)? {
            Shape::Curve { line, .. } if paint::in_field(at) => paint::nearest_parameter(line, self.eye, at),
            _ => None,
        }
    }

    fn point_at(&self, s: f64) -> Option<Point<3>> {
        match self.shapes.of(self.selected?)? {
            Shape::Curve { arc, .. } => arc.eval(0, s),
            _ => None,
        }
    }

    /// An action of the page.
    async fn act(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<()> {
        match action {
            Action::Centre => {
                if let Some(bounds) = self.selected.and_then(|at| self.shapes.bounds(Some(at))) {
                    let middle = std::array::from_fn(|d| bounds.min[d] / 2.0 + bounds.max[d] / 2.0);
                    self.eye = self.eye.centred(middle);
                } else {
                    desk.tell(texts::NOTHING_SELECTED, Stay::Briefly);
                }
            }
            Action::Load => self.load(desk).await?,
            Action::Save => self.save_item(desk).await?,
            Action::Items if self.scene().items.is_empty() => desk.tell(texts::EMPTY, Stay::Briefly),
            Action::Items => self.list = Some(self.selected.unwrap_or(0)),
            Action::Elevate => self.elevate(desk).await?,
            Action::Divide => {
                let direction = self.ask_direction(desk).await?;
                if let Some(at) = self.at.clone() {
                    self.divide(desk, direction, &[at]);
                }
            }
            Action::IntoEqual => self.divide_equally(desk).await?,
            Action::Coefficients => coefficients::edit(self, desk).await?,
            Action::Join => self.join(desk).await?,
            Action::Interpolate => self.interpolate(desk),
            Action::NextPoint => self.step_point(true),
            Action::PreviousPoint => self.step_point(false),
        }
        Ok(())
    }

    async fn elevate(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let direction = self.ask_direction(desk).await?;
        let root = self.order.clone();
        let Some(item) = self.item().cloned() else { return Ok(()) };
        let raised = match &item {
            Item::Curve(curve) => self.bases.elevated_curve(curve, &root).map(Item::Curve),
            Item::Patch(patch) => self.bases.elevated_patch(patch, direction, &root).map(Item::Patch),
        };
        match raised {
            Ok(item) => self.change_item(item),
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// Divides the selected item; the second part of a curve has another colour.
    fn divide(&mut self, desk: &mut Desk<'_>, direction: usize, places: &[Real]) {
        let (Some(at), Some(item)) = (self.selected, self.item().cloned()) else { return };
        match self.bases.divided(&item, direction, places) {
            Ok(mut parts) => {
                for (number, part) in parts.iter_mut().enumerate().skip(1) {
                    if let Item::Curve(curve) = part {
                        curve.style.colour = PART_COLORS[number % PART_COLORS.len()];
                    }
                }
                let mut scene = self.history.now().clone();
                edit::replace(&mut scene, at, parts);
                self.change(scene);
                self.select(Some(at));
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
    }

    /// A strip of equal parts: of an exact item over a freely typed interval, of another over its own.
    async fn divide_equally(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let (Some(at), Some(item)) = (self.selected, self.item().cloned()) else { return Ok(()) };
        let Some(coefficients) = coefficients_of(&item) else {
            let direction = self.ask_direction(desk).await?;
            let parts = ask_parts(desk, &*self, texts::ASK_PARTS, 2).await?;
            if let Some(interval) = self.own_interval() {
                let interval = interval.map(Real::from);
                let places: Vec<Real> =
                    equal_parts(&interval, parts).into_iter().skip(1).map(|[start, _]| start).collect();
                self.divide(desk, direction, &places);
            }
            return Ok(());
        };
        let (coefficients, parts) = match coefficients {
            Coefficients::Curve { space, interval, coefficients } => {
                let interval = ask_interval(desk, &*self, texts::ASK_INTERVAL, &interval).await?;
                let proposed = fewest_parts(&space, values(&interval));
                let parts = ask_parts(desk, &*self, texts::ASK_PARTS, proposed).await?;
                (Coefficients::Curve { space, interval, coefficients }, [Some(parts), None])
            }
            Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients } => {
                let interval_u = ask_interval(desk, &*self, texts::ASK_INTERVAL_U, &interval_u).await?;
                let proposed = fewest_parts(&space_u, values(&interval_u));
                let u = ask_parts(desk, &*self, texts::ASK_PARTS_U, proposed).await?;
                let interval_v = ask_interval(desk, &*self, texts::ASK_INTERVAL_V, &interval_v).await?;
                let proposed = fewest_parts(&space_v, values(&interval_v));
                let v = ask_parts(desk, &*self, texts::ASK_PARTS_V, proposed).await?;
                let all = Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients };
                (all, [Some(u), Some(v)])
            }
        };
        match self.bases.strips(&coefficients, parts) {
            Ok(mut strip) => {
                for part in &mut strip {
                    match (part, &item) {
                        (Item::Curve(part), Item::Curve(whole)) => part.style = whole.style.clone(),
                        (Item::Patch(part), Item::Patch(whole)) => part.style = whole.style.clone(),
                        _ => {}
                    }
                }
                let mut scene = self.history.now().clone();
                edit::replace(&mut scene, at, strip);
                self.change(scene);
                self.select(Some(at));
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// Joins another item to the selected one, and keeps them joined.
    async fn join(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let (Some(at), Some(item)) = (self.selected, self.item().cloned()) else { return Ok(()) };
        let count = self.scene().items.len();
        let proposal = if at + 1 < count { at + 2 } else { 1 };
        let read = |text: &str| {
            let number: Option<usize> = text.trim().parse().ok();
            number
                .and_then(|number| number.checked_sub(1))
                .filter(|&other| other < count && other != at)
                .ok_or_else(|| Phrase::from(texts::NO_ITEM))
        };
        let other = desk.meaning(&*self, texts::ASK_OTHER, &proposal.to_string(), read).await?;
        let Some(second) = self.scene().items.get(other).cloned() else { return Ok(()) };
        if matches!(item, Item::Curve(_)) != matches!(second, Item::Curve(_)) {
            desk.tell(texts::OTHER_KIND, Stay::UntilRead);
            return Ok(());
        }
        let read = |text: &str| match text.trim() {
            "g" | "G" => Ok((1, true)),
            text => match text.parse::<usize>() {
                Ok(order @ 0..=3) => Ok((order, false)),
                _ => Err(texts::NO_ORDER.into()),
            },
        };
        let (order, geometric) = desk.meaning(&*self, texts::ASK_ORDER, "1", read).await?;
        let [from, to] = edit::nearest_borders(&item, &second);
        let join = Join { a: (at, from), b: (other, to), order, geometric };
        match edit::joined(&item, from, &second, to, &join, &mut self.bases) {
            Ok(changed) => {
                let mut scene = self.history.now().clone();
                if let Some(slot) = scene.items.get_mut(other) {
                    *slot = changed;
                }
                scene.joins.retain(|it| {
                    let sides = [it.a, it.b];
                    !(sides.contains(&join.a) || sides.contains(&join.b))
                });
                scene.joins.push(join);
                self.change(scene);
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// The curve goes through its present control points, at equal steps of its parameter.
    fn interpolate(&mut self, desk: &mut Desk<'_>) {
        let Some(Item::Curve(curve)) = self.item().cloned() else { return };
        let through = self.bases.of(&curve.space, values(&curve.interval)).and_then(|basis| {
            let last = curve.points.len().saturating_sub(1).max(1) as f64;
            let places: Vec<f64> = (0..curve.points.len()).map(|k| k as f64 / last).collect();
            basis.interpolate(&places, &curve.points)
        });
        match through {
            Ok(points) => {
                self.change_item(Item::Curve(crate::file::ec::EcCurve { points, exact: None, ..curve }));
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
    }

    /// The space dialog of the selected item, and what follows from another space.
    async fn change_space(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some(item) = self.item().cloned() else {
            desk.tell(texts::NOTHING_SELECTED, Stay::Briefly);
            return Ok(());
        };
        let direction = self.ask_direction(desk).await?;
        let (old, old_interval) = match &item {
            Item::Curve(curve) => (curve.space.clone(), curve.interval.clone()),
            Item::Patch(patch) => {
                let (space, interval) = patch_space(patch, direction);
                (space.clone(), interval.clone())
            }
        };
        let title = match (&item, direction) {
            (Item::Curve(_), _) => texts::SPACE_OF_CURVE,
            (_, 0) => texts::SPACE_OF_U,
            _ => texts::SPACE_OF_V,
        };
        let (space, interval) = space::edit(self, desk, title, (&old, &old_interval)).await?;
        if space == old && values(&interval) == values(&old_interval) {
            return Ok(());
        }
        let same_place = values(&interval) == values(&old_interval);
        let mut stays = false;
        if same_place && space.contains(&old) {
            let question = Question::new(TOP, texts::ASK_KEEP_CURVE, [texts::ELEVATE, texts::KEEP_POINTS]);
            stays = desk.ask(&*self, &question).await? == Answer::First;
        }
        let exact = space.contains(&old).then(|| coefficients_of(&item)).flatten().is_some();
        let made = if stays || exact {
            // The same functions, in the larger space, on the new interval.
            match &item {
                Item::Curve(curve) => self.bases.moved_curve(curve, &space, &interval).map(Item::Curve),
                Item::Patch(patch) => {
                    self.bases.moved_patch(patch, direction, &space, &interval).map(Item::Patch)
                }
            }
        } else {
            Ok(space::with_space(&item, direction, &space, &interval))
        };
        match made {
            Ok(item) => self.change_item(item),
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// The selected item becomes what coefficients describe, over its own interval.
    pub(super) fn describe(&mut self, coefficients: &Coefficients) -> Result<(), EcError> {
        let Some(old) = self.item().cloned() else { return Ok(()) };
        let described = match (self.bases.described(coefficients)?, old) {
            (Item::Curve(new), Item::Curve(old)) => {
                Item::Curve(crate::file::ec::EcCurve { style: old.style, name: old.name, ..new })
            }
            (Item::Patch(new), Item::Patch(old)) => {
                Item::Patch(crate::file::ec::EcPatch { style: old.style, name: old.name, ..new })
            }
            (_, old) => old,
        };
        self.change_item(described);
        Ok(())
    }

    /// Asks for a stored file.
    pub(super) async fn ask_file(&mut self, desk: &mut Desk<'_>) -> Asked<String> {
        if desk.machine.manner() == Manner::Today {
            return work::choose_file(&*self, desk).await;
        }
        let name = desk.text(&*self, words::FILE_NAME, "").await?.trim().to_uppercase();
        Ok(if name.contains('.') { name } else { format!("{name}.KCJ") })
    }

    /// Reads a stored document.
    pub(super) fn read_file(&mut self, desk: &mut Desk<'_>, name: &str) -> Result<EcDocument, Phrase> {
        let format = Format::from_name(name).unwrap_or(Format::Kcj);
        match work::read_document(desk.machine.storage(), name, format)? {
            Document::Ec(document) => Ok(*document),
            _ => Err(texts::NO_DOCUMENT.into()),
        }
    }

    /// Opens a scene, or adds what a file holds to the one that is there.
    async fn load(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let name = self.ask_file(desk).await?;
        let empty = self.history.now().items.is_empty();
        let read = self.read_file(desk, &name).and_then(|document| {
            if empty {
                let is_scene = matches!(document, EcDocument::Scene(_));
                self.open(&document.into())?;
                return Ok(is_scene);
            }
            let scene = self.scene_of(&document)?;
            let checked = self.bases.shapes(&EcDocument::Scene(scene.clone()));
            checked.map_err(|error| Phrase::plain(&error))?;
            let mut whole = self.history.now().clone();
            let first = whole.items.len();
            whole.items.extend(scene.items);
            whole.joins.extend(scene.joins.into_iter().map(|join| Join {
                a: (join.a.0 + first, join.a.1),
                b: (join.b.0 + first, join.b.1),
                ..join
            }));
            self.change(whole);
            Ok(false)
        });
        match read {
            Ok(true) => desk.machine.set_file(Some(name)),
            Ok(false) => {}
            Err(problem) => desk.tell(problem, Stay::UntilRead),
        }
        self.fit();
        Ok(())
    }

    /// Saves the selected item alone, or the scene where nothing is selected.
    async fn save_item(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let document = match self.item().cloned() {
            None => return work::save(self, desk).await.map(|_| ()),
            Some(Item::Curve(curve)) => EcDocument::Curve(curve),
            Some(Item::Patch(patch)) => EcDocument::Patch(patch),
        };
        store(self, desk, document).await
    }
}

/// Colours of the parts of a divided curve.
const PART_COLORS: [u8; 4] = [15, 14, 11, 10];

/// Asks for a name and stores a document under it.
pub(super) async fn store(studio: &mut Studio, desk: &mut Desk<'_>, document: EcDocument) -> Asked<()> {
    let document = Document::from(document);
    let name = desk.file_name(&*studio, document.format().extension(), crate::ui::Way::Save).await?;
    if !desk.may_write(&*studio, &[&name]).await? {
        return Ok(());
    }
    let content = document.write(document.format()).map_err(|error| words::in_file(&name, &error));
    let stored = content.and_then(|content| {
        let written = desk.machine.storage().write(&name, &content);
        written.map_err(|error| words::storage_problem(&error))
    });
    match stored {
        Ok(()) => desk.tell(words::figure_saved(&desk.located(&name)), Stay::Briefly),
        Err(problem) => desk.tell(problem, Stay::UntilRead),
    }
    Ok(())
}

/// A key or a click that means something; the page says which keys do.
pub(super) async fn ask_key<T>(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    caption: Words,
    letters: &str,
    found: impl Fn(&Tick) -> Option<T>,
) -> Asked<T> {
    loop {
        let asking = crate::ui::Over::new(picture, |screen: &mut Screen, language: Language| {
            page(screen, TOP);
            screen.text(TOP.0 + 8, TOP.1 + 8, caption.of(language), Color::Black);
            let shown: String = letters.chars().take(28).collect();
            screen.text(TOP.0 + 8, TOP.1 + 24, &shown, Color::Blue);
        });
        let tick = desk.event(&asking).await?;
        if tick.pressed(Key::Esc) {
            return Err(crate::machine::Stop::Cancelled);
        }
        if let Some(found) = found(&tick) {
            return Ok(found);
        }
    }
}

async fn ask_parts(desk: &mut Desk<'_>, studio: &Studio, caption: Words, proposed: usize) -> Asked<usize> {
    let most = i64::try_from(MOST_PARTS).unwrap_or(i64::MAX).min(100);
    desk.meaning(studio, caption, &proposed.to_string(), |text| whole(text, [1, most])).await
}

async fn ask_interval(
    desk: &mut Desk<'_>,
    studio: &Studio,
    caption: Words,
    present: &Interval,
) -> Asked<Interval> {
    let proposal = format!("{}, {}", present[0], present[1]);
    desk.meaning(studio, caption, &proposal, |text| {
        let (start, end) = text.split_once(',').ok_or(Phrase::from(texts::TWO_ENDS))?;
        let read = |text: &str| Real::typed(text).map_err(|error| texts::problem(&error));
        let interval = [read(start)?, read(end)?];
        let [start, end] = values(&interval);
        match start < end {
            true => Ok(interval),
            false => Err(texts::problem(&EcError::Interval { start, end })),
        }
    })
    .await
}

/// A number in a range, typed as an expression.
pub(super) fn number(text: &str, [low, high]: [f64; 2]) -> Result<Real, Phrase> {
    let real = Real::typed(text).map_err(|error| texts::problem(&error))?;
    match (low..=high).contains(&real.value()) {
        true => Ok(real),
        false => Err(Phrase::new(format!("{low} és {high} között kell"), format!("{low} to {high}, please"))),
    }
}

/// A whole number in a range.
pub(super) fn whole(text: &str, [low, high]: [i64; 2]) -> Result<usize, Phrase> {
    let number: i64 = text.trim().parse().map_err(|_| Phrase::from(texts::NO_WHOLE))?;
    match (low..=high).contains(&number) {
        true => Ok(usize::try_from(number).unwrap_or(0)),
        false => Err(Phrase::new(format!("{low} és {high} között kell"), format!("{low} to {high}, please"))),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!(super::COMMANDS.shared_keys(), []);
        assert_eq!(super::COMMANDS.too_wide(), [""; 0]);
    }
}
