//! The page of curves: what CSOMO adds to the editor of handles.

use super::facts::{Cache, Facts};
use super::rail::{Stack, stacks};
use super::region::Known;
use super::sheet::{self, FIELD, LINE, RAIL, STORE, STRIP, Sheet, in_field};
use super::table::{Action, COMMANDS};
use super::through::Search;
use super::{model, texts};
use crate::design::knots::edit;
use crate::editor::field::on_disc;
use crate::editor::lens::{Held, Lens};
use crate::editor::passage::Passage;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::editor::stage::Stage;
use crate::editor::{Craft, Editor};
use crate::file::{Document, Format, KnotPoints, MAX_POINTS, Places};
use crate::geometry::Point;
use crate::geometry::knots::KnotCurve;
use crate::machine::{Asked, Event, Modifier, Mouse, Tick};
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Commands, Desk, Hint, Question, Stay};
use crate::work::Next;
use serde::Serialize;
use std::rc::Rc;

/// How far from the curve a click is on it, in pixels.
const REACH: f64 = 5.0;

/// What the user has chosen to see. It belongs to the view, not to the file.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Options {
    pub(super) paths: bool,
    pub(super) envelope: bool,
    /// Whether the chosen knot moves against its partner.
    pub(super) opposed: bool,
    /// Whether the curve follows while something is dragged.
    pub(super) live: bool,
    /// Whether the curve at the start is shown too.
    pub(super) compared: bool,
    pub(super) comb: bool,
    pub(super) hodograph: bool,
    pub(super) region: bool,
}

/// The craft of curves by their knots.
pub(super) struct Bench {
    pub(super) options: Options,
    /// The marked parameter; `None` for the usual one.
    pub(super) u: Option<f64>,
    /// The chosen knot; `None` for the usual one.
    pub(super) knot: Option<usize>,
    /// The curve as it was opened.
    pub(super) start: Option<KnotPoints>,
    /// The search for a curve through a point, while it goes on.
    pub(super) search: Option<Search>,
    /// The mouse before the present event.
    pub(super) mouse: Mouse,
    cache: Cache,
    pub(super) region: Known,
    /// Set where the page of surfaces is wanted.
    pub(super) passage: Rc<Passage>,
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Handle {
    /// A control point; the index after the last is the store's.
    Point(usize),
    /// A new point behind the last.
    New,
    /// Copies of a knot from one of them, the lowest first: all that stand above go with it.
    Knots { first: usize, copies: usize, level: usize },
    /// Two knots against each other.
    Opposed([usize; 2]),
    /// The parameter, in the strip.
    Mark,
    /// The parameter, on the curve.
    OnCurve,
}

impl Handle {
    /// The knots that move up or down.
    pub(super) fn group(self, up: bool) -> Option<(usize, usize)> {
        match self {
            Handle::Knots { first, copies, level } if up => Some((first + level, copies - level)),
            Handle::Knots { first, copies, level } => Some((first, copies - level)),
            Handle::Opposed([first, _]) => Some((first, 1)),
            _ => None,
        }
    }
}

impl Bench {
    pub(super) fn new(passage: Rc<Passage>) -> Bench {
        let options = Options {
            paths: false,
            envelope: false,
            opposed: false,
            live: true,
            compared: false,
            comb: false,
            hodograph: false,
            region: false,
        };
        Bench {
            options,
            u: None,
            knot: None,
            start: None,
            search: None,
            mouse: Mouse::default(),
            cache: Cache::default(),
            region: Known::default(),
            passage,
        }
    }
}

impl Craft<2> for Bench {
    type Value = KnotPoints;
    type Handle = Handle;
    type Lens = Sheet;
    type Action = Action;

    fn format(&self) -> Format {
        Format::Csm
    }

    fn formats(&self, _: &KnotPoints) -> Vec<Format> {
        vec![Format::Csm, Format::Ip2]
    }

    fn commands(&self) -> Commands<Action> {
        COMMANDS
    }

    fn lens(&self) -> Sheet {
        Sheet
    }

    /// Without points, of the same order.
    fn fresh(&self, before: Option<&KnotPoints>) -> KnotPoints {
        let empty = KnotPoints::of_points(Vec::<Point<2>>::new());
        match before {
            Some(before) => edit::of_kind(&empty, before.order, edit::Ends::Open),
            None => empty,
        }
    }

    fn of_document(
        &self,
        document: &Document,
        _: &KnotPoints,
    ) -> Result<(KnotPoints, Option<Phrase>), Phrase> {
        let foreign = !matches!(document, Document::Knots(_));
        let Document::Knots(knots) = document.clone().adapted(Format::Csm) else {
            return Err(texts::WRONG_FILE.into());
        };
        let points: Vec<Point<2>> = match &knots.points {
            Places::Plane(points) => points.clone(),
            Places::Space(points) if points.iter().all(|[.., z]| *z == 0.0) => {
                points.iter().map(|&[x, y, _]| [x, y]).collect()
            }
            Places::Space(_) => return Err(texts::IN_SPACE.into()),
        };
        if points.len() > MAX_POINTS {
            return Err(words::too_many_points(points.len()));
        }
        let top = points.iter().map(|[_, y]| *y).fold(FIELD[1], f64::max);
        if foreign && top > FIELD[1] && points.iter().all(|[x, y]| (0.0..=FIELD[0]).contains(x) && *y >= 0.0)
        {
            let scale = FIELD[1] / top;
            let points: Vec<Point<2>> =
                points.iter().map(|point| point.map(|x| (scale * x).round())).collect();
            return Ok((KnotPoints { points: points.into(), ..*knots }, Some(texts::SHRUNK.into())));
        }
        let outside = points.iter().position(|point| !in_field(*point));
        let remark = outside.map(|index| texts::outside(index + 1, points[index]));
        Ok((KnotPoints { points: points.into(), ..*knots }, remark))
    }

    fn document(&self, curve: &KnotPoints) -> Document {
        Document::Knots(Box::new(curve.clone()))
    }

    fn names_shape(&self, curve: &KnotPoints) -> bool {
        curve.is_curve()
    }

    fn has_shape(editor: &Editor<Bench, 2>) -> bool {
        editor.history.now().is_curve()
    }

    fn hint(editor: &Editor<Bench, 2>) -> Option<Hint> {
        editor.advice()
    }

    fn model(editor: &Editor<Bench, 2>) -> impl Serialize + 'static {
        model::of(editor)
    }

    fn place(curve: &KnotPoints, handle: Handle) -> Option<Point<2>> {
        match handle {
            Handle::Point(index) => sheet::points(curve).get(index).copied().or(Some(STORE)),
            Handle::Knots { first, .. } | Handle::Opposed([first, _]) => {
                Some([sheet::scale(curve).along(*curve.knots.get(first)?), 0.0])
            }
            Handle::New | Handle::Mark | Handle::OnCurve => Some([0.0; 2]),
        }
    }

    /// A point dropped outside the field is deleted.
    fn moved(curve: &KnotPoints, handle: Handle, at: Point<2>) -> KnotPoints {
        let count = curve.points.len();
        if Bench::place(curve, handle) == Some(at) && handle != Handle::New {
            return curve.clone();
        }
        let value = sheet::scale(curve).value(at[0]);
        let before = |first: usize| curve.knots.get(first).copied().unwrap_or(value);
        match handle {
            Handle::Point(index) if index < count && in_field(at) => edit::moved(curve, index, at),
            Handle::Point(index) if index < count => edit::deleted(curve, index),
            Handle::Point(_) | Handle::New if in_field(at) => edit::inserted(curve, count, at),
            Handle::Opposed(knots) => edit::opposed(curve, knots, value - before(knots[0])),
            Handle::Knots { first, .. } => match handle.group(value > before(first)) {
                Some((first, copies)) => edit::knot_moved(curve, first, copies, value),
                None => curve.clone(),
            },
            _ => curve.clone(),
        }
    }

    fn handle_at(editor: &Editor<Bench, 2>, at: (i32, i32)) -> Option<Handle> {
        let curve = editor.history.now();
        let points = sheet::points(curve);
        if on_disc(Sheet.pixel(STORE), at) && points.len() < MAX_POINTS {
            return Some(Handle::Point(points.len()));
        }
        if let Some((stack, level)) = RAIL.stack_at(&curve.knots, at) {
            let Stack { first, copies, .. } = stack;
            let partner = editor.partner(curve, first).filter(|_| editor.craft.options.opposed);
            return Some(match partner {
                Some(partner) => Handle::Opposed([first, partner]),
                None => Handle::Knots { first, copies, level },
            });
        }
        if sheet::on(STRIP, at) || sheet::on(LINE, at) {
            return editor.facts(curve).map(|_| Handle::Mark);
        }
        let point = points.iter().rposition(|&point| on_disc(Sheet.pixel(point), at));
        let on_curve = || {
            let (_, far) = editor.facts(curve)?.nearest(Sheet::place(at))?;
            (far <= REACH).then_some(Handle::OnCurve)
        };
        point.map(Handle::Point).or_else(on_curve)
    }

    fn seen(editor: &Editor<Bench, 2>) -> Vec<Item<2>> {
        editor.items()
    }

    fn forget(editor: &mut Editor<Bench, 2>) {
        let now = editor.history.now().clone();
        let craft = &mut editor.craft;
        (craft.u, craft.knot, craft.search) = (None, None, None);
        craft.start = Some(now).filter(KnotPoints::is_curve);
    }

    async fn before_event(editor: &mut Editor<Bench, 2>, desk: &mut Desk<'_>) -> Asked<()> {
        editor.craft.mouse = desk.machine.mouse();
        Ok(())
    }

    /// The wheel over a knot moves it by a hundredth of the mean distance, with Ctrl by a thousandth.
    fn looked(editor: &mut Editor<Bench, 2>, _: &mut Desk<'_>, tick: &Tick) -> bool {
        let Some(Event::Wheel(steps)) = tick.event else { return false };
        let curve = editor.history.now();
        let under = RAIL.stack_at(&curve.knots, (tick.mouse.x, tick.mouse.y));
        let Some((Stack { first, copies, value }, level)) = under.filter(|_| !editor.stage.is_result())
        else {
            return false;
        };
        let part = if tick.mouse.with(Modifier::Ctrl) { 1e-3 } else { 1e-2 };
        let by = f64::from(steps) * part * edit::mean_step(curve);
        let handle = Handle::Knots { first, copies, level };
        if let Some((first, copies)) = handle.group(by > 0.0) {
            let moved = edit::knot_moved(curve, first, copies, value + by);
            editor.craft.knot = Some(first);
            editor.history.change(moved);
        }
        true
    }

    fn taken_up(editor: &Editor<Bench, 2>, at: (i32, i32)) -> Option<Held<Handle, 2>> {
        let place = Sheet::place(at);
        let room = editor.history.now().points.len() < MAX_POINTS;
        (room && in_field(place)).then_some(Held { handle: Handle::New, pressed: at, from: place, at: place })
    }

    async fn obey(editor: &mut Editor<Bench, 2>, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        editor.carry_out(desk, action).await
    }

    async fn dropped(
        editor: &mut Editor<Bench, 2>,
        desk: &mut Desk<'_>,
        held: Held<Handle, 2>,
        moved: KnotPoints,
    ) -> Asked<()> {
        let marked = editor.marked(&held);
        let now = editor.history.now();
        match held.handle {
            Handle::Mark | Handle::OnCurve => editor.craft.u = marked,
            Handle::Knots { first, .. } | Handle::Opposed([first, _]) => {
                let up = moved.knots.get(first) == now.knots.get(first);
                editor.craft.knot = held.handle.group(up).map(|(first, _)| first);
                editor.history.change(moved);
            }
            Handle::Point(index) if index >= MAX_POINTS => desk.tell(words::FULL, Stay::Briefly),
            Handle::Point(_) | Handle::New => editor.history.change(moved),
        }
        Ok(())
    }

    async fn begin_result(editor: &mut Editor<Bench, 2>, desk: &mut Desk<'_>) -> Asked<bool> {
        if !editor.history.now().is_curve() {
            desk.tell(texts::NO_CURVE, Stay::Briefly);
            return Ok(false);
        }
        let answer = desk.ask(editor, &Question::yes_no(words::ASK_POINTS)).await?;
        editor.stage = Stage::Result { points: answer == Answer::First };
        Ok(true)
    }

    fn draw(editor: &Editor<Bench, 2>, layer: Layer, page: &mut Page<'_>) {
        editor.draw_layer(layer, page);
    }
}

impl Editor<Bench, 2> {
    /// What is known of a curve.
    pub(super) fn facts(&self, curve: &KnotPoints) -> Option<Rc<Facts>> {
        self.craft.cache.of(curve)
    }

    /// The document whose curve is in the picture: a solution of the search, or the present one with what is dragged.
    pub(super) fn drawn(&self) -> KnotPoints {
        let found = self.craft.search.as_ref().and_then(Search::chosen);
        match found {
            Some((_, through)) => crate::design::knots::document(&through.curve),
            None if self.craft.options.live => self.preview(),
            None => self.history.now().clone(),
        }
    }

    /// The parameter that a held mark would have.
    fn marked(&self, held: &Held<Handle, 2>) -> Option<f64> {
        let facts = self.facts(self.history.now())?;
        let at = if held.at == held.from { Sheet::place(held.pressed) } else { held.at };
        let u = match held.handle {
            Handle::Mark => sheet::scale(self.history.now()).value(at[0]),
            Handle::OnCurve => facts.nearest(at)?.0,
            _ => return self.craft.u,
        };
        Some(facts.parameter(Some(u)))
    }

    /// The marked parameter of the curve in the picture.
    pub(super) fn u(&self, facts: &Facts) -> f64 {
        let found = self.craft.search.as_ref().and_then(Search::chosen).map(|(_, through)| through.u);
        let held = self.held.as_ref().and_then(|held| self.marked(held));
        facts.parameter(found.or(held).or(self.craft.u))
    }

    /// The copies of a knot that are chosen or dragged, as the document counts them.
    pub(super) fn chosen(&self, curve: &KnotPoints) -> Option<Stack> {
        let knot =
            |first: usize, copies: usize| curve.knots.get(first).map(|&value| Stack { first, copies, value });
        if let Some(held) = self.held {
            let now = self.history.now();
            let up = |first: usize| curve.knots.get(first) == now.knots.get(first);
            if let Handle::Knots { first, .. } | Handle::Opposed([first, _]) = held.handle {
                return held.handle.group(up(first)).and_then(|(first, copies)| knot(first, copies));
            }
        }
        let stacks = self.movable(curve);
        let named = |stack: &&Stack| self.craft.knot.is_some_and(|knot| stack.holds(knot));
        let u = self.facts(curve).map(|facts| self.u(&facts))?;
        let usual = || stacks.iter().find(|stack| stack.value > u).or(stacks.last());
        stacks.iter().find(named).or_else(usual).copied()
    }

    /// The knots that the curve depends on and that can be moved.
    pub(super) fn movable(&self, curve: &KnotPoints) -> Vec<Stack> {
        let Some(facts) = self.facts(curve) else { return Vec::new() };
        let counts = |stack: &Stack| {
            let ends = [stack.first, stack.first + stack.copies - 1];
            let seam = curve.closed && (ends[0] == 0 || ends[1] + 1 == curve.knots.len());
            !seam && ends.into_iter().any(|knot| !facts.curve.changed_spans(index(curve, knot)).is_empty())
        };
        stacks(&curve.knots).into_iter().filter(counts).collect()
    }

    /// The knot that moves against another one, `2 k - 3` behind it.
    pub(super) fn partner(&self, curve: &KnotPoints, first: usize) -> Option<usize> {
        let partner = first + 2 * curve.order - 3;
        let there = !curve.closed && first > 0 && partner + 1 < curve.knots.len();
        there.then_some(partner)
    }

    /// Where the mouse would have a held knot, neighbours or not, while Shift is down.
    pub(super) fn beyond(&self) -> Option<f64> {
        let held = self.held.filter(|_| self.craft.mouse.with(Modifier::Shift))?;
        matches!(held.handle, Handle::Knots { .. })
            .then(|| sheet::scale(self.history.now()).value(held.at[0]))
    }

    /// What can be done now.
    fn advice(&self) -> Option<Hint> {
        let curve = self.history.now();
        if self.craft.search.is_some() {
            return None;
        }
        let text: Phrase = match self.held.map(|held| held.handle) {
            Some(Handle::Knots { .. } | Handle::Opposed(_)) => texts::HINT_KNOT.into(),
            Some(Handle::Mark | Handle::OnCurve) => texts::HINT_MARK.into(),
            Some(_) => texts::HINT_POINT.into(),
            None if curve.points.is_empty() => texts::HINT_FIRST.into(),
            None if !curve.is_curve() => texts::more_points(curve.order - curve.points.len(), curve.order),
            None => texts::HINT_EDIT.into(),
        };
        Some(Hint::new(text))
    }
}

/// The index of a knot of the document among those of the formulas: of a closed curve the document has one period.
pub(super) fn index(curve: &KnotPoints, knot: usize) -> usize {
    if curve.closed { knot + curve.order - 1 } else { knot }
}

/// A curve of the formulas with the knots of the document.
pub(super) type Curve = KnotCurve<2>;
