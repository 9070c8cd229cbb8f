//! The points: dropped, taken up, found by the mouse.

use super::craft::{Bench, Handle};
use super::form::Form;
use super::room::{Here, Room};
use crate::design::{Edit, Place};
use crate::editor::field::on_disc;
use crate::editor::lens::{Held, Lens};
use crate::editor::place;
use crate::file::{MAX_POINTS, Places};
use crate::geometry::{ParamCurve, Point};
use serde::Serialize;

/// Whether no more points can be added.
pub(super) fn full<const D: usize>(form: &Form<D>) -> bool {
    form.points.len() >= MAX_POINTS
}

/// Steps of a span on the screen.
pub(super) fn steps(spans: usize) -> usize {
    if spans < 4 { 200 } else { 50 }
}

/// The form with a point dropped at a place; in the plane, one dropped outside the field is deleted.
pub(super) fn dropped<const D: usize>(form: &Form<D>, index: usize, new: bool, at: Point<D>) -> Form<D>
where
    Here: Room<D>,
    Point<D>: Place<D>,
{
    let there = !new && index < form.points.len();
    match (there, at.fits()) {
        (true, false) if <Here as Room<D>>::STORE.is_some() => form.edited(Edit::Delete(index)),
        (true, _) => form.edited(Edit::Move(index, at)),
        (false, true) => form.edited(Edit::Insert(index, at)),
        (false, false) => form.clone(),
    }
}

/// The point at a pixel; the one in the store comes after the last.
pub(super) fn at<const D: usize>(editor: &Bench<D>, at: (i32, i32)) -> Option<Handle>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let (form, lens) = (editor.history.now(), &editor.lens);
    if <Here as Room<D>>::STORE.is_some_and(|store| on_disc(lens.pixel(store), at)) && !full(form) {
        return Some(Handle::Point(form.points.len()));
    }
    let under = |&index: &usize| form.points.get(index).is_some_and(|&it| on_disc(lens.pixel(it), at));
    lens.order(&form.points).into_iter().rev().find(under).map(Handle::Point)
}

/// A new point at a pixel: on the curve between the points there, else behind the last.
pub(super) fn new_at<const D: usize>(editor: &Bench<D>, at: (i32, i32)) -> Option<Held<Handle, D>>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now();
    if full(form) {
        return None;
    }
    let on_curve = editor.curve().and_then(|curve| {
        let line = curve.polyline(steps(curve.spans())).ok()?;
        place::on_line(&line, &form.points, form.closure(), &editor.lens, at)
    });
    let open = <Here as Room<D>>::open_place(at);
    let (place, index) = match on_curve {
        Some((place, index)) => (open.unwrap_or(place.nearest()), index),
        None => (open?, form.points.len()),
    };
    place.fits().then_some(Held { handle: Handle::New(index), pressed: at, from: place, at: place })
}
