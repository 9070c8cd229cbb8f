//! The editor of surfaces: a net of control points in space, seen from a direction that the user turns, and
//! the surface through it or near it (chapter 3). Which net and which methods is the program's [`Plan`].

mod ask;
mod commands;
mod dump;
mod fine;
mod frame;
mod inspect;
mod joint;
mod map;
mod normals;
mod picture;
mod plan;
mod show;
pub(crate) mod surface;
mod tables;
mod weights;

pub(crate) use inspect::{Inspection, Section};
pub use plan::{Family, Plan, Start};
pub use show::{Constant, SHOW_KEYS, Show, show};
pub(crate) use surface::{Display, Drawn, Fill, draw_parts};
pub use tables::{
    B_SPLINE_KEYS, B_SPLINE_POLES_KEYS, BETA_KEYS, BEZIER_KEYS, FINER_KEYS, HERMITE_KEYS, LOCAL_KEYS,
    NORMALS_KEYS, SPLINE_POLES_KEYS,
};

use super::lens::Held;
use super::picture::{Layer, Page};
use super::seen::Item;
use super::stage::Stage;
use super::{Craft, Dial, Editor, refusal};
use crate::design::{DesignError, Index, NetDesign, Part, nets};
use crate::file::{Document, Format, Method, Net, NetKind, NetSettings};
use crate::geometry::{Border, BoundingBox, ParamSurface, Point, Topology};
use crate::machine::{Asked, Asking, Key, Tick};
use crate::ui::look::{Look, Poles, SIGHT_KEY, Viewer};
use crate::ui::words::{self, Phrase};
use crate::ui::{self, Commands, Desk, Hint, Stay};
use crate::work::Next;
use ask::ask_display;
use dump::Dump;
use frame::Frame;
use map::Map;
use normals::{Beside, Facts};
use serde::Serialize;
use std::rc::Rc;
use tables::Action;

/// Prepares the editor, with or without a document to open.
///
/// # Errors
/// The reason why it cannot open the document.
pub fn start(plan: &'static Plan, document: Option<Document>) -> Result<ui::Start, Phrase> {
    super::start(Nets::new(plan), plan.manual, document)
}

/// The [`Craft`] of surfaces.
struct Nets {
    plan: &'static Plan,
    /// The surface shown by the last F, if it replaces the net in the picture.
    drawn: Option<Rc<Drawn>>,
    display: Display,
    inspection: Inspection,
    section: Option<Section>,
    /// The control point being changed, and which part of it.
    chosen: Option<(Index, Part)>,
    /// What surfaces with normals show besides.
    beside: Beside,
    /// What is known about such a surface.
    facts: Option<Facts>,
    /// What is shown over the surface.
    frame: Frame,
    /// The point whose weight is shown.
    weight: Option<Index>,
    /// The point that was changed last.
    last: Option<Index>,
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Handle {
    Point(Index),
    /// The tip of a normal.
    Normal(Index),
}

impl Handle {
    fn index(self) -> Index {
        match self {
            Handle::Point(index) | Handle::Normal(index) => index,
        }
    }
}

impl Nets {
    fn new(plan: &'static Plan) -> Nets {
        Nets {
            plan,
            drawn: None,
            display: Display::Wire,
            inspection: Inspection::Off,
            section: None,
            chosen: None,
            beside: Beside::default(),
            facts: None,
            frame: Frame::Off,
            weight: None,
            last: None,
        }
    }

    /// Whether the user can choose between wires and filled cells; height fields have no wires.
    fn asks_display(&self) -> bool {
        self.plan.family != Family::Heights
    }
}

impl Craft<3> for Nets {
    type Value = NetDesign;
    type Handle = Handle;
    type Lens = Viewer;
    type Action = Action;

    fn format(&self) -> Format {
        self.plan.kind.format()
    }

    /// Any open net may be taken; what is saved has normals.
    fn formats(&self, _: &NetDesign) -> Vec<Format> {
        let others = self.plan.reads.iter().filter(|_| self.plan.family == Family::Normals);
        std::iter::once(self.plan.kind).chain(others.copied()).map(NetKind::format).collect()
    }

    fn commands(&self) -> Commands<Action> {
        tables::of(self.plan)
    }

    fn lens(&self) -> Viewer {
        Viewer::new(Look::new(self.plan.view, Poles::Cross))
    }

    fn fresh(&self, before: Option<&NetDesign>) -> NetDesign {
        let kept = before.map(|before| before.net.settings).unwrap_or_default();
        let settings =
            NetSettings { k0: kept.k0, bias: kept.bias, tension: kept.tension, ..NetSettings::default() };
        let net = Net { settings, ..Net::new(self.plan.kind, self.plan.net()) };
        let design = NetDesign { net, implied: self.plan.family.method() };
        match self.plan.start {
            // A spline through the points has no curvature at the border; the vault's own normals have.
            Start::Vault(spacing, height) => {
                let normals = Some(nets::vault_normals(self.plan.kind.shape(), spacing, height));
                NetDesign { net: Net { normals, ..design.net }, ..design }
            }
            _ => design,
        }
    }

    fn of_document(
        &self,
        document: &Document,
        before: &NetDesign,
    ) -> Result<(NetDesign, Option<Phrase>), Phrase> {
        let Document::Net(net) = document else { return Err(words::NOT_A_NET.into()) };
        let (kind, kept) = (self.plan.kind, &before.net.settings);
        if net.kind != kind && !self.plan.reads.contains(&net.kind) {
            let other = DesignError::OtherNet { wanted: kind.format(), found: net.kind.format() };
            return Err(refusal::of_surface(&other));
        }
        let mut design = NetDesign { net: Net { kind, ..net.clone() }, implied: self.plan.family.method() };
        if self.plan.family == Family::Normals {
            (design.net.settings.joint, design.net.settings.ratio) = (None, None);
            // Any open net has a surface with normals.
            let named = design.net.settings.method.filter(|_| design.pn_method().is_some());
            design.net.settings.method = named;
            let design = design.fitting().map_err(|error| refusal::of_surface(&error))?;
            return Ok((design.with_given_normals(), None));
        }
        let settings = &mut design.net.settings;
        settings.k0 = settings.k0.or(kept.k0);
        settings.bias = settings.bias.or(kept.bias);
        settings.tension = settings.tension.or(kept.tension);
        design.scheme().map_err(|error| refusal::of_surface(&error))?;
        Ok((design.fitting().map_err(|error| refusal::of_surface(&error))?, None))
    }

    fn document(&self, design: &NetDesign) -> Document {
        Document::Net(design.net.clone())
    }

    fn implied(&self) -> Option<Method> {
        Some(self.plan.family.method())
    }

    fn fits_format(&self, design: &NetDesign) -> bool {
        self.plan.family == Family::Normals || design.shape() == self.plan.kind.shape()
    }

    /// Whether there is one shows when it is drawn.
    fn has_shape(_: &Editor<Nets, 3>) -> bool {
        true
    }

    fn surfaces(editor: &Editor<Nets, 3>) -> Vec<Box<dyn ParamSurface>> {
        match editor.craft.plan.family {
            Family::Normals => editor.models_with_offsets(),
            _ => editor.history.now().solid().into_iter().collect(),
        }
    }

    fn hint(editor: &Editor<Nets, 3>) -> Option<Hint> {
        let hint = match (editor.held, &editor.craft.drawn) {
            (None, _) if editor.craft.plan.family == Family::Normals => {
                Hint::new(words::HINT_NORMALS).by_keys(words::KEYS_NORMALS)
            }
            (Some(_), _) => Hint::new(words::HINT_HELD_3D).by_keys(words::KEYS_HELD),
            (None, None) => Hint::new(words::HINT_NET).by_keys(words::KEYS_NET),
            (None, Some(_)) if editor.craft.asks_display() => {
                Hint::new(words::HINT_SURFACE).by_keys(words::KEYS_SURFACE)
            }
            (None, Some(_)) => Hint::new(words::HINT_HEIGHTS).by_keys(words::KEYS_HEIGHTS),
        };
        Some(hint)
    }

    fn names_shape(&self, design: &NetDesign) -> bool {
        let settings = &design.net.settings;
        let named = settings.method.is_some()
            || settings.extended.is_some()
            || settings.joint.is_some()
            || matches!(design.border(), Border::Free | Border::Inner);
        self.plan.family != Family::Normals && named && self.draw_up(design).is_ok()
    }

    fn model(editor: &Editor<Nets, 3>) -> impl Serialize + 'static {
        Dump::of(editor)
    }

    fn place(design: &NetDesign, handle: Handle) -> Option<Point<3>> {
        match handle {
            Handle::Point(index) => design.point(index),
            Handle::Normal(index) => normals::tip(design, index),
        }
    }

    fn moved(design: &NetDesign, handle: Handle, at: Point<3>) -> NetDesign {
        match handle {
            Handle::Point(index) => design.moved(index, at),
            Handle::Normal(index) => normals::with_tip(design, index, at),
        }
    }

    fn handle_at(editor: &Editor<Nets, 3>, at: (i32, i32)) -> Option<Handle> {
        if editor.map().hit(at).is_some() {
            return None;
        }
        let tips = editor.craft.plan.family == Family::Normals;
        let tip = || editor.tip_at(at).filter(|_| tips).map(Handle::Normal);
        editor.point_at(at).map(Handle::Point).or_else(tip)
    }

    fn seen(editor: &Editor<Nets, 3>) -> Vec<Item<3>> {
        editor.items()
    }

    fn forget(editor: &mut Editor<Nets, 3>) {
        let drawn = editor.craft.draw_up(editor.history.now()).ok().map(Rc::new);
        let shown = editor.craft.names_shape(editor.history.now());
        let craft = &mut editor.craft;
        (craft.section, craft.chosen, craft.drawn) = (None, None, drawn.filter(|_| shown));
        (craft.frame, craft.weight, craft.last) = (Frame::Off, None, None);
        if craft.plan.family == Family::Normals {
            craft.beside = Beside::default();
            let points = editor.history.now().net.points.iter().flatten().copied();
            if let Some(bounds) = BoundingBox::around(points) {
                editor.lens.look = editor.lens.look.framing(&bounds);
            }
            editor.shown.follow = true;
        }
        editor.frame_joined();
    }

    async fn before_event(editor: &mut Editor<Nets, 3>, _: &mut Desk<'_>) -> Asked<()> {
        if editor.craft.plan.family == Family::Normals && editor.stage.begun() {
            editor.look_at_facts();
        }
        Ok(())
    }

    fn looked(editor: &mut Editor<Nets, 3>, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        if tick.letter().map(Key::Char) == Some(SIGHT_KEY) {
            let sight = editor.lens.look.sight().next();
            editor.lens.look = editor.lens.look.seen_from(sight, editor.bounds());
            desk.tell(sight.told(), Stay::Briefly);
            return true;
        }
        let display = match tick.letter().filter(|_| editor.stage.is_result() && editor.craft.asks_display())
        {
            Some('D') => Display::Wire,
            Some('T') => Display::Filled,
            _ => return editor.inspect(desk, tick),
        };
        editor.craft.display = display;
        true
    }

    /// A click on the map chooses its point.
    fn clicked(editor: &Editor<Nets, 3>, at: (i32, i32)) -> Option<Action> {
        editor.map().hit(at).map(Action::ChangeAt)
    }

    fn dials(editor: &Editor<Nets, 3>) -> Vec<Dial> {
        editor.value_dials()
    }

    fn dialled(editor: &Editor<Nets, 3>, dial: usize, to: f64) -> NetDesign {
        editor.with_dial(dial, to)
    }

    /// The points of the net, while it is in the picture.
    fn handles(editor: &Editor<Nets, 3>) -> Vec<Handle> {
        if editor.craft.drawn.is_some() || editor.craft.beside.gauss {
            return Vec::new();
        }
        let now = editor.history.now();
        let last = now.choices()[1].saturating_sub(1);
        // A pole is there once, though every meridian has it.
        let ball = now.net.kind.topology() == Topology::Sphere;
        let again = |[k, l]: &Index| ball && *k > 0 && (*l == 0 || *l == last);
        now.indices().filter(|index| !again(index)).map(Handle::Point).collect()
    }

    fn value_at(editor: &Editor<Nets, 3>, at: (i32, i32)) -> Option<Action> {
        editor.value_shown_at(at)
    }

    async fn obey(editor: &mut Editor<Nets, 3>, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        editor.carry_out(desk, action).await
    }

    /// After a change the net is shown.
    fn changed(editor: &mut Editor<Nets, 3>) {
        editor.craft.drawn = None;
        editor.shown.known = editor.shown.follow;
    }

    /// A point that was not moved is chosen.
    async fn dropped(
        editor: &mut Editor<Nets, 3>,
        desk: &mut Desk<'_>,
        held: Held<Handle, 3>,
        moved: NetDesign,
    ) -> Asked<()> {
        editor.craft.last = Some(held.handle.index());
        if held.at == held.from {
            return match held.handle {
                Handle::Point(index) => editor.change(desk, Some(index)).await,
                Handle::Normal(index) => editor.change_normals(desk, Action::NormalAt(index)).await,
            };
        }
        editor.history.change(moved);
        Nets::changed(editor);
        Ok(())
    }

    fn problem(editor: &Editor<Nets, 3>) -> Option<Phrase> {
        editor.craft.draw_up(editor.history.now()).err().map(|error| refusal::of_surface(&error))
    }

    /// As in the original, the shown surface is that of the last F, unless it follows changes.
    fn reshaped(editor: &mut Editor<Nets, 3>, desk: &mut Desk<'_>) {
        if editor.shown.follow && editor.craft.drawn.is_some() {
            editor.refresh(desk);
        }
    }

    async fn begin_result(editor: &mut Editor<Nets, 3>, desk: &mut Desk<'_>) -> Asked<bool> {
        if !editor.shown.known {
            desk.tell(words::NO_SURFACE, Stay::Briefly);
            return Ok(false);
        }
        if editor.craft.asks_display() {
            editor.craft.display = ask_display(desk, editor).await?;
        }
        if !editor.refresh(desk) {
            return Ok(false);
        }
        editor.stage = Stage::Result { points: false };
        Ok(true)
    }

    async fn end_result(editor: &mut Editor<Nets, 3>, desk: &mut Desk<'_>) -> Asked<()> {
        if editor.craft.asks_display() {
            editor.stage = Stage::Returning;
            let display = ask_display(desk, editor).await.unless_cancelled()?;
            editor.craft.display = display.unwrap_or(editor.craft.display);
        }
        editor.stage = Stage::Working;
        Ok(())
    }

    fn covers_ground(editor: &Editor<Nets, 3>) -> bool {
        editor.craft.drawn.is_some() || editor.craft.beside.gauss || editor.stage.is_result()
    }

    fn draw(editor: &Editor<Nets, 3>, layer: Layer, page: &mut Page<'_>) {
        editor.draw_own(layer, page);
    }
}

impl Editor<Nets, 3> {
    fn map(&self) -> Map {
        Map::new(self.history.now().choices())
    }

    /// A box round the net and the surface that is drawn.
    fn bounds(&self) -> Option<BoundingBox<3>> {
        let net = BoundingBox::around(self.history.now().net.points.iter().flatten().copied());
        let drawn = self.craft.drawn.as_ref().and_then(|drawn| drawn.bounds());
        net.into_iter().chain(drawn).reduce(BoundingBox::union)
    }
}
