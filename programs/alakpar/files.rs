//! Documents that the program opens, and cyclic curves whose points lie far out.

use super::craft::{Bench, Shaper};
use super::form::Form;
use super::obey::ask_number;
use super::room::{Here, Room};
use super::texts;
use crate::design::Place;
use crate::file::{Document, FIELD, FamilyName, Format, MAX_POINTS, Places, ShapedPoints};
use crate::geometry::shaped::{cyclic_from_fourier, cyclic_to_fourier};
use crate::geometry::{ParamCurve, Point};
use crate::machine::Asked;
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, Question};
use serde::Serialize;

/// How far outside the field, in its widths, points may lie before fewer harmonics are offered.
const FAR: f64 = 1.0;

/// The document as one of this program.
pub(super) fn shaped(document: &Document) -> Option<ShapedPoints> {
    if let Document::Fourier(fourier) = document {
        return ShapedPoints::of_fourier(fourier);
    }
    match document.clone().adapted(Format::Alp) {
        Document::Shaped(shaped) => Some(*shaped),
        _ => None,
    }
}

/// Whether a document belongs to the page of space.
pub(super) fn is_in_space(document: &Document) -> bool {
    shaped(document).is_some_and(|shaped| shaped.points.plane().is_none())
}

/// The form of a document; one of the other page is sent there.
pub(super) fn read<const D: usize>(
    craft: &Shaper<D>,
    document: &Document,
) -> Result<(Form<D>, Option<Phrase>), Phrase>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let shaped = shaped(document).ok_or(texts::NO_DOCUMENT)?;
    if shaped.points.len() > MAX_POINTS {
        return Err(words::too_many_points(shaped.points.len()));
    }
    let places = |places: &Places| <Here as Room<D>>::points(places).map(<[Point<D>]>::to_vec);
    let Some(points) = places(&shaped.points) else {
        craft.passage.lead(Some(document.clone()));
        return Ok((Form::empty(), None));
    };
    let blend = shaped.blend.as_ref().and_then(places);
    let form = Form::of_document(&shaped, points, blend);
    let outside = form.points.iter().filter(|point| !point.fits()).count();
    if let (Document::Fourier(_), Some((form, by))) = (document, centred(&form)) {
        return Ok((form, Some(texts::shifted(by))));
    }
    let remark = (outside > 0 && form.family() != FamilyName::Cyclic).then(|| texts::outside(outside));
    Ok((form, remark))
}

/// A curve that leaves the field, in the middle of it; its program draws it elsewhere. Also by how much it was moved.
fn centred<const D: usize>(form: &Form<D>) -> Option<(Form<D>, [f64; 2])> {
    let bounds = form.curve().ok()?.bounding_box()?;
    let inside = (0..D.min(2)).all(|d| bounds.min[d] >= 0.0 && bounds.max[d] <= FIELD[d]);
    // Half a pixel is not left to the rounding of the bounds, which differs from system to system.
    let whole = |shift: f64| ((1e6 * shift).round() / 1e6).round();
    let by: [f64; 2] = std::array::from_fn(|d| whole(0.5 * (FIELD[d] - bounds.min[d] - bounds.max[d])));
    let moved = |point: &Point<D>| std::array::from_fn(|d| point[d] + by.get(d).copied().unwrap_or(0.0));
    (!inside).then(|| (form.replaced(form.points.iter().map(moved).collect()), by))
}

/// Whether points of a cyclic curve of the plane lie so far out that nobody can take hold of them.
pub(super) fn flies_out<const D: usize>(form: &Form<D>) -> bool {
    D == 2 && form.family() == FamilyName::Cyclic && is_far(&form.points)
}

fn is_far<const D: usize>(points: &[Point<D>]) -> bool {
    let far = |(value, largest): (&f64, f64)| *value < -FAR * largest || *value > (1.0 + FAR) * largest;
    points.iter().any(|point| point.iter().zip(FIELD).any(far))
}

/// The same curve with so many of its harmonics.
fn reduced<const D: usize>(form: &Form<D>, harmonics: usize) -> Option<Form<D>> {
    let fourier = cyclic_to_fourier(&form.points).ok()?;
    Some(form.replaced(cyclic_from_fourier(&fourier, harmonics).ok()?))
}

/// Offers the largest number of harmonics whose points stay near.
pub(super) async fn offer_fewer<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<()>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    let all = form.points.len() / 2;
    let near = |harmonics: &usize| reduced(&form, *harmonics).is_some_and(|form| !is_far(&form.points));
    let Some(harmonics) = (1..all).rev().find(near) else { return Ok(()) };
    let facts = texts::far_out(all, harmonics);
    if desk.ask_about(editor, &facts, Question::yes_no(texts::ASK_FEWER)).await? == Answer::Second {
        return Ok(());
    }
    let most = [1.0, (all - 1) as f64];
    let wanted = ask_number(desk, editor, &texts::HARMONICS.into(), most, &harmonics.to_string()).await?;
    if let Some(fewer) = reduced(&form, wanted as usize) {
        editor.change(fewer);
    }
    Ok(())
}
