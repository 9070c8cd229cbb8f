//! The commands of the page of space.

use super::super::obey::{ask_existing, ask_number};
use super::super::texts;
use super::commands::Action;
use super::craft::{Bench, Handle, RADII, Strings, as_circles};
use super::strings::{self, Row};
use crate::design::skin;
use crate::editor::Craft;
use crate::editor::stage::Stage;
use crate::file::Document;
use crate::geometry::Point;
use crate::geometry::skin::Clearing;
use crate::machine::{Asked, Stop};
use crate::ui::words;
use crate::ui::{Answer, Desk, Picture, Question, Stay, TOP};
use crate::work::{Next, quit};

/// The largest coordinate that can be typed.
const FARTHEST: f64 = 1e4;
/// The radius that is proposed for the first sphere.
const NEW_RADIUS: f64 = 40.0;

/// Carries out a command.
pub(super) async fn carry_out(editor: &mut Bench, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
    let count = editor.history.now().spheres.len();
    match action {
        Action::Insert => insert(editor, desk).await?,
        Action::Change => {
            let index = ask_existing(editor, desk, count, texts::NO_SPHERES).await?;
            editor.craft.pointed_out = Some(index);
            let changed = ask_row(editor, desk, index).await;
            editor.craft.pointed_out = None;
            let new = strings::with_sphere(editor.history.now(), index, changed?);
            editor.history.change(new);
        }
        Action::Delete => {
            let index = ask_existing(editor, desk, count, texts::NO_SPHERES).await?;
            delete(editor, desk, index);
        }
        Action::DeleteHere => {
            let mouse = desk.machine.mouse();
            match Strings::handle_at(editor, (mouse.x, mouse.y)) {
                Some(Handle::Middle(index) | Handle::Rim(index)) => delete(editor, desk, index),
                None => desk.tell(texts::NO_SPHERE_HERE, Stay::Briefly),
            }
        }
        Action::Clearing => {
            let what = Question::new(TOP, texts::ASK_SKIN, [texts::PLAIN_SHORT, texts::CLEARED_SHORT]);
            editor.craft.options.clearing = match desk.ask(editor, &what).await? {
                Answer::First => Clearing::Plain,
                Answer::Second => Clearing::Scaled,
            };
        }
        Action::Result => editor.show_result(desk).await?,
        Action::Ring => {
            if count < 3 {
                desk.tell(texts::RING_OF_THREE, Stay::Briefly);
                return Ok(Next::Work);
            }
            let ring = strings::as_ring(editor.history.now());
            desk.tell(if ring.closed { texts::RING } else { texts::CHAIN }, Stay::Briefly);
            editor.history.change(ring);
        }
        Action::Elsewhere => {
            if editor.history.unsaved() {
                crate::work::offer_to_save(editor, desk).await?;
            }
            let circles = as_circles(editor.history.now());
            editor.craft.passage.lead(Some(Document::Circles(Box::new(circles))));
            return Ok(Next::End);
        }
        Action::Touching => editor.craft.options.touching ^= true,
        Action::Filled => editor.craft.options.filled ^= true,
        Action::Nearest => nearest(editor, desk),
        Action::Quit => return quit(editor, desk).await,
    }
    Ok(Next::Work)
}

fn delete(editor: &mut Bench, desk: &mut Desk<'_>, index: usize) {
    let rest = strings::deleted(editor.history.now(), index);
    editor.history.change(rest);
    desk.tell(texts::sphere_deleted(index + 1), Stay::Briefly);
}

/// Three coordinates, with decimals.
async fn ask_place(picture: &dyn Picture, desk: &mut Desk<'_>, proposal: Point<3>) -> Asked<Point<3>> {
    let read = |text: &str| {
        let words = text.split([' ', ';']).filter(|word| !word.is_empty());
        let numbers: Option<Vec<f64>> = words.map(|word| word.replace(',', ".").parse().ok()).collect();
        let place = numbers.and_then(|numbers| Point::<3>::try_from(numbers).ok());
        place.filter(|place| place.iter().all(|x| x.abs() <= FARTHEST)).ok_or_else(texts::not_a_place)
    };
    let proposal = proposal.map(|x| x.to_string()).join(" ");
    desk.meaning(picture, texts::PLACE_ENTRY, &proposal, read).await
}

/// Another place or radius of a sphere.
async fn ask_row(editor: &Bench, desk: &mut Desk<'_>, index: usize) -> Asked<Row> {
    let sphere = editor.history.now().spheres.get(index).copied();
    let [x, y, z, r] = sphere.unwrap_or([0.0, 0.0, 0.0, NEW_RADIUS]);
    let what = Question::new(TOP, words::ASK_CHANGE, [words::PLACE, texts::RADIUS]);
    Ok(match desk.ask(editor, &what).await? {
        Answer::First => {
            let [x, y, z] = ask_place(editor, desk, [x, y, z]).await?;
            [x, y, z, r]
        }
        Answer::Second => [x, y, z, ask_number(editor, desk, texts::RADIUS_ENTRY, RADII, r).await?],
    })
}

/// A new sphere: between two neighbours halfway, at the ends of a chain where the user says.
async fn insert(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<()> {
    let spheres = editor.history.now().clone();
    let count = spheres.spheres.len();
    if strings::is_full(&spheres) {
        desk.tell(texts::full(), Stay::Briefly);
        return Ok(());
    }
    let read = |text: &str| match text.trim().parse::<usize>() {
        Ok(number) if (1..=count + 1).contains(&number) => Ok(number - 1),
        _ => Err(texts::no_such(count + 1)),
    };
    let index = if count == 0 {
        0
    } else {
        desk.meaning(&*editor, words::NUMBER_ENTRY, &(count + 1).to_string(), read).await?
    };
    let pair = match index {
        _ if count == 0 => None,
        _ if spheres.closed && (index == 0 || index == count) => Some([count - 1, 0]),
        0 => None,
        _ if index < count => Some([index - 1, index]),
        _ => None,
    };
    let row = match pair.and_then(|pair| strings::halfway(&spheres, pair)) {
        Some(row) => row,
        None => {
            let last = spheres.spheres.last().copied();
            let [x, y, z, r] =
                last.map_or([0.0, 0.0, 0.0, NEW_RADIUS], |[x, y, z, r]| [x + 3.0 * r, y, z, r]);
            let [x, y, z] = ask_place(editor, desk, [x, y, z]).await?;
            [x, y, z, ask_number(editor, desk, texts::RADIUS_ENTRY, RADII, r).await?]
        }
    };
    editor.history.change(strings::inserted(&spheres, index, row));
    Ok(())
}

/// The key F8: the offending spheres shrink until the rules are kept.
fn nearest(editor: &mut Bench, desk: &mut Desk<'_>) {
    let before = editor.history.now().clone();
    let Ok(spheres) = skin::spheres(&before) else {
        desk.tell(texts::NO_SPHERES, Stay::Briefly);
        return;
    };
    let Some(found) = spheres.nearest_admissible() else {
        desk.tell(texts::NEVER, Stay::UntilRead);
        return;
    };
    let mut after = before.clone();
    for (row, sphere) in after.spheres.iter_mut().zip(found.spheres()) {
        row[3] = sphere.radius;
    }
    let shrunk = before.spheres.iter().zip(&after.spheres).filter(|(a, b)| a != b).count();
    if shrunk == 0 {
        desk.tell(texts::IS_ADMISSIBLE, Stay::Briefly);
    } else {
        editor.history.change(after);
        desk.tell(texts::spheres_shrunk(shrunk), Stay::Briefly);
    }
}

/// Whether there is a skin to show alone; asks whether with the spheres.
pub(super) async fn begin_result(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<bool> {
    if editor.covered().is_none_or(|covered| covered.skin.parts().is_empty()) {
        desk.tell(texts::NO_SPHERE_SKIN, Stay::Briefly);
        return Err(Stop::Cancelled);
    }
    let answer = desk.ask(editor, &Question::yes_no(texts::ASK_SPHERES)).await?;
    editor.stage = Stage::Result { points: answer == Answer::First };
    Ok(true)
}
