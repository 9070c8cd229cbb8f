//! The control points and curves in the picture, and the commands that change points by their numbers.

use super::ask::{FEWEST, ask_existing, ask_index};
use super::series::Beside;
use super::{Ambient, Curves, Handle, Tools, steps};
use crate::design::{Edit, Place, Sketch};
use crate::editor::lens::{Held, Lens};
use crate::editor::picture::Page;
use crate::editor::seen::{Item, Label};
use crate::editor::stage::Stage;
use crate::editor::{Craft, Editor, place};
use crate::figure::point_labels;
use crate::file::{MAX_POINTS, Method};
use crate::geometry::Point;
use crate::machine::{Asked, Manner};
use crate::screen::{Color, Stroke};
use crate::ui::words;
use crate::ui::{Answer, Desk, Hint, Question, Stay, TOP};
use serde::Serialize;

/// The fewest points that have a curve by methods of a layer, and with tangents.
const FEWEST_OF_LAYERS: usize = 2;

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// How many points there are.
    pub(super) fn count(&self) -> usize {
        self.history.now().points.len()
    }

    /// The sketch that the curve is drawn from.
    pub(super) fn method(&self) -> Option<Method> {
        self.craft.method_of(self.history.now())
    }

    /// The fewest points that have a curve.
    pub(super) fn fewest(&self) -> usize {
        // One arc with its two tangents is a curve; the original wants three points.
        let arc = self.craft.tools == Tools::Tangents && self.manner == Manner::Today;
        if self.craft.layer.is_some() || arc { FEWEST_OF_LAYERS } else { FEWEST }
    }

    /// The tip of the tangent at a point, where tangents are shown.
    pub(super) fn tip(&self, index: usize) -> Option<Point<D>> {
        let sketch = self.history.now();
        let shown = self.craft.layer.as_ref().is_none_or(|layer| layer.has_tips(&self.drawn()));
        sketch.tip(index).filter(|_| shown)
    }

    /// The sketch with the dragged handle dropped at the mouse, with the method of the program.
    pub(super) fn drawn(&self) -> Sketch<D> {
        let sketch = self.preview();
        if self.craft.layer.is_some() {
            let sketch = self.completed(if sketch.method().is_none() { sketch.closed_up() } else { sketch });
            return self.craft.method_of(&sketch).map_or(sketch.clone(), |method| sketch.by(method));
        }
        match sketch.method().or(self.craft.tools.implied()) {
            Some(method) => sketch.by(method),
            None => self.craft.usual.map_or(sketch.clone(), |method| sketch.closed_up().by(method)),
        }
    }

    /// A new point at a pixel: on the curve between the points there, else behind the last.
    pub(super) fn new_point(&self, at: (i32, i32)) -> Option<Held<Handle, D>> {
        let sketch = self.history.now();
        if sketch.full() || self.craft.measured || self.weights_cover(at) {
            return None;
        }
        let (index, place) = match self.on_curve(at) {
            Some((place, index)) => (index, place),
            None => (sketch.points.len(), Curves::<D>::open_place(at)?),
        };
        place.fits().then_some(Held { handle: Handle::New(index), pressed: at, from: place, at: place })
    }

    /// The place of the curve at a pixel, and the index that a point inserted there has.
    fn on_curve(&self, at: (i32, i32)) -> Option<(Point<D>, usize)> {
        let (sketch, curve) = (self.drawn(), self.drawn().curve().ok().filter(|_| self.shown.visible)?);
        let line = curve.polyline(steps(sketch.method()?)).ok()?;
        let (nearest, index) = place::on_line(&line, &sketch.points, sketch.closure(), &self.lens, at)?;
        Some((Curves::<D>::open_place(at).unwrap_or(nearest.nearest()), index))
    }

    /// What can be done now.
    pub(super) fn hint(&self) -> Option<Hint> {
        // The page holds either of them.
        if self.shows_k0() || !self.craft.compared.is_empty() || self.craft.series.is_some() {
            return None;
        }
        if let Some(layer) = self.craft.layer.as_ref().filter(|_| self.count() >= self.fewest()) {
            return layer.hint(&self.scene());
        }
        if let Some(hint) = self.hint_of_arcs() {
            return Some(hint);
        }
        let plane = Curves::<D>::STORE.is_some();
        let methods = self.craft.tools == Tools::Methods;
        let (mouse, keys) = match (self.held.map(|held| held.handle), self.count()) {
            (Some(Handle::Tip(_)), _) => (words::HINT_TIP, words::KEYS_HELD),
            (Some(_), _) if plane => (words::HINT_HELD, words::KEYS_HELD),
            (Some(_), _) => (words::HINT_HELD_3D, words::KEYS_HELD),
            (None, 0) if plane => (words::HINT_FIRST, words::KEYS_FIRST),
            (None, count) if count < self.fewest() && plane => (words::HINT_MORE, words::KEYS_MORE),
            (None, count) if count < self.fewest() => (words::HINT_MORE_3D, words::HINT_MORE_3D),
            (None, _) if !self.shown.visible => (words::HINT_CURVE, words::HINT_CURVE),
            (None, _) if self.craft.tools == Tools::Tangents => {
                (words::HINT_TANGENTS, words::KEYS_EDIT_CURVE)
            }
            (None, _) => match (methods, plane) {
                (true, true) => (words::HINT_EDIT, words::KEYS_EDIT),
                (false, true) => (words::HINT_EDIT_BETA, words::KEYS_EDIT_CURVE),
                (true, false) => (words::HINT_EDIT_3D, words::KEYS_EDIT_3D),
                (false, false) => (words::HINT_EDIT_BETA_3D, words::KEYS_EDIT_CURVE_3D),
            },
        };
        Some(Hint::new(mouse).by_keys(keys))
    }

    /// Makes a changed sketch the present one. As in the original the curve goes, unless it shall follow.
    pub(super) fn change(&mut self, sketch: Sketch<D>) {
        self.history.change(self.completed(sketch));
        self.shown.after_edit();
        self.forget_note();
    }

    /// Clears the communication page; the coefficient of tangents beside it stays.
    pub(super) fn forget_note(&mut self) {
        if self.craft.tools != Tools::Tangents {
            self.craft.note = None;
        }
    }

    /// The compared curves and the chosen one, with the joints of beta-splines.
    pub(super) fn curves_seen(&self) -> Vec<Item<D>> {
        let (mut items, sketch, result) = (Vec::new(), self.drawn(), self.stage.is_result());
        let live = Curves::<D>::LIVE && self.held.is_some() && self.shown.known;
        let shown = (self.shown.visible || live || result) && !self.craft.measured;
        let present = sketch.method().filter(|_| shown).zip(sketch.curve().ok());
        let method = present.as_ref().map(|(method, _)| *method);
        let beside = self.beside();
        for (index, Beside { sketch, method: of, name, ink }) in beside.iter().enumerate() {
            // A curve that does not exist is skipped; the user was told when choosing it. Each name is at another
            // fraction of its curve, so that the names stand apart.
            if let Ok(curve) = sketch.curve() {
                let name = Some(Label { name: name.clone(), part: [2 * index + 1, 2 * beside.len().max(5)] });
                // The present curve shows on both sides of its like.
                let alike = method == Some(*of) && present.is_some();
                let stroke = if alike { Stroke::thin(*ink) } else { Stroke::thick(*ink) };
                items.push(Item::Curve { curve, steps: steps(*of), stroke, name });
            }
        }
        let Some((method, curve)) = present else { return items };
        let joints = if method == Method::Beta { curve.joints() } else { Vec::new() };
        let white =
            Item::Curve { curve, steps: steps(method), stroke: Stroke::thick(Color::White), name: None };
        items.insert(0, white);
        items.extend(joints.into_iter().map(Item::Joint));
        items
    }

    /// The tangents, the control points with their numbers, and the next one in the store.
    pub(super) fn add_points(&self, items: &mut Vec<Item<D>>) {
        if self.stage == (Stage::Result { points: false }) {
            return;
        }
        let sketch = self.history.now();
        let held_at = |handle| self.held.filter(|held| held.handle == handle).map(|held| held.at);
        for (index, &point) in sketch.points.iter().enumerate() {
            if let Some(tip) = held_at(Handle::Tip(index)).or(self.tip(index)) {
                let picked = self.picked == Some(Handle::Tip(index));
                let fill = if picked { Color::Red } else { Color::DarkGray };
                items.push(Item::Tangent { tip, point, fill });
            }
        }
        let points: Vec<Point<D>> = (0..)
            .zip(&sketch.points)
            .map(|(index, &point)| held_at(Handle::Point(index)).unwrap_or(point))
            .collect();
        let points = self.points_carried().unwrap_or(points);
        let dots = self.stage.is_result() && Curves::<D>::STORE.is_none();
        for index in self.lens.order(&points) {
            // The indices come from these points.
            let Some(&at) = points.get(index) else { continue };
            items.push(match dots {
                true => Item::Dot(at),
                false => Item::Disc { at, number: index + 1, fill: self.fill_of(index) },
            });
        }
        if let Some((Handle::New(index), at)) = self.held.map(|held| (held.handle, held.at)) {
            items.push(Item::Disc { at, number: index + 1, fill: Curves::<D>::FILL });
        }
        let empty = !self.stage.begun() || self.stage.is_result() || self.stage == Stage::Offering;
        let stored = !empty && !sketch.full();
        if let Some(store) = Curves::<D>::STORE.filter(|_| stored) {
            let (at, number) = (held_at(Handle::Point(self.count())), self.count() + 1);
            items.push(match at {
                Some(at) if at.fits() => Item::Disc { at, number, fill: Curves::<D>::FILL },
                at => Item::Stored { at: at.unwrap_or(store), number, fill: Curves::<D>::FILL },
            });
        }
    }

    /// Writes the numbers of points that are at one place beside it, of which one disc is seen.
    pub(super) fn draw_multiples(&self, page: &mut Page<'_>) {
        let points = self.stage.begun() && self.stage != (Stage::Result { points: false });
        if self.manner != Manner::Today || !points {
            return;
        }
        for (at, text) in point_labels(&self.preview().points) {
            if text.contains(['-', ',']) {
                Item::Note { at, text, ink: Color::White }.paint(page.screen, &self.lens);
            }
        }
    }

    /// The command B: a new point with a number and a place.
    pub(super) async fn insert(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.history.now().full() {
            desk.tell(words::FULL, Stay::Briefly);
            return Ok(());
        }
        let index = ask_index(desk, self).await?;
        let place = Curves::<D>::ask_place(self, desk).await?;
        self.change(self.history.now().edited(Edit::Insert(index, place)));
        Ok(())
    }

    /// The command V: a new number or place for a point. With tangents, it first asks whether the point or its
    /// tangent changes.
    pub(super) async fn change_point(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let index = ask_existing(desk, self, self.count()).await?;
        if self.tip(index).is_some() && matches!(self.craft.tools, Tools::Tangents | Tools::Own) {
            let what = Question::new(TOP, words::ASK_CHANGE, [words::POINT, words::TANGENT]);
            if desk.ask(self, &what).await? == Answer::Second {
                return Curves::<D>::change_tangent(self, desk, index).await;
            }
        }
        self.craft.pointed_out = Some(index);
        let edit = self.ask_edit(desk, index).await;
        self.craft.pointed_out = None;
        self.change(self.history.now().edited(edit?));
        Ok(())
    }

    async fn ask_edit(&self, desk: &mut Desk<'_>, index: usize) -> Asked<Edit<Point<D>>> {
        let what = Question::new(TOP, words::ASK_CHANGE, [words::NUMBER, words::PLACE]);
        Ok(match desk.ask(self, &what).await? {
            Answer::First => Edit::Renumber(index, ask_existing(desk, self, self.count()).await?),
            Answer::Second => Edit::Move(index, Curves::<D>::ask_place(self, desk).await?),
        })
    }

    /// The key Delete: the point under the mouse goes.
    pub(super) fn delete_at(&mut self, desk: &mut Desk<'_>) {
        let mouse = desk.machine.mouse();
        match Curves::handle_at(self, (mouse.x, mouse.y)).or(self.picked) {
            Some(Handle::Point(index)) if index < self.count() => {
                self.change(self.history.now().removed(index));
                desk.tell(words::deleted(index + 1), Stay::Briefly);
            }
            _ => desk.tell(words::NOTHING_HERE, Stay::Briefly),
        }
    }

    /// The command T: a point goes.
    pub(super) async fn delete(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let index = ask_existing(desk, self, self.count()).await?;
        self.change(self.history.now().removed(index));
        Ok(())
    }
}

// The prompt for a point's number has room for two digits.
const _: () = assert!(MAX_POINTS <= 99);
