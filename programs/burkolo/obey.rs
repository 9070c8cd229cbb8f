//! The commands.

use super::commands::Action;
use super::craft::{Bench, NEW_RADIUS, RADII, radius};
use super::dressed::Style;
use super::space::of_circles;
use super::value::{self, Row};
use super::{discs, texts};
use crate::design::skin;
use crate::editor::curve::ask::ask_index;
use crate::editor::field::PICTURE;
use crate::editor::place::ask_place_in_field;
use crate::editor::stage::Stage;
use crate::file::{Document, FIELD};
use crate::geometry::skin::Clearing;
use crate::machine::{Asked, Key, Language, Request, Stop};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Hot, Words};
use crate::ui::{Answer, Area, Choices, Desk, Over, Picture, Question, Stay, TOP, page};
use crate::work::{Next, quit};

/// Carries out a command.
pub(super) async fn carry_out(editor: &mut Bench, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
    let count = editor.history.now().circles.len();
    match action {
        Action::Insert => insert(editor, desk).await?,
        Action::Change => {
            let index = ask_existing(editor, desk, count, texts::NO_CIRCLES).await?;
            editor.craft.pointed_out = Some(index);
            let changed = ask_row(editor, desk, index).await;
            editor.craft.pointed_out = None;
            let new = value::with_circle(editor.history.now(), index, changed?);
            editor.history.change(new);
        }
        Action::Delete => {
            let index = ask_existing(editor, desk, count, texts::NO_CIRCLES).await?;
            delete(editor, desk, index);
        }
        Action::DeleteHere => {
            let mouse = desk.machine.mouse();
            match discs::number_at(editor, (mouse.x, mouse.y)) {
                Some(index) => delete(editor, desk, index),
                None => desk.tell(texts::NOTHING_HERE, Stay::Briefly),
            }
        }
        Action::Skin => choose_skin(editor, desk).await?,
        Action::Result => editor.show_result(desk).await?,
        Action::Link => {
            let pair = pick_two(editor, desk).await?;
            let (linked, is_link) = value::linked(editor.history.now(), pair);
            editor.history.change(linked);
            desk.tell(if is_link { texts::LINKED } else { texts::UNLINKED }, Stay::Briefly);
        }
        Action::Ring => {
            if count < 3 {
                desk.tell(texts::RING_OF_THREE, Stay::Briefly);
                return Ok(Next::Work);
            }
            let ring = value::as_ring(editor.history.now());
            desk.tell(if ring.closed { texts::RING } else { texts::CHAIN }, Stay::Briefly);
            editor.history.change(ring);
        }
        Action::Apollonius => editor.craft.options.apollonius ^= true,
        Action::Radical => editor.craft.options.radical ^= true,
        Action::Nearest => nearest(editor, desk),
        Action::Elsewhere => {
            if editor.history.unsaved() {
                crate::work::offer_to_save(editor, desk).await?;
            }
            let spheres = of_circles(editor.history.now());
            editor.craft.passage.lead(Some(Document::Spheres(Box::new(spheres))));
            return Ok(Next::End);
        }
        Action::Quit => return quit(editor, desk).await,
    }
    Ok(Next::Work)
}

fn delete(editor: &mut Bench, desk: &mut Desk<'_>, index: usize) {
    let rest = value::deleted(editor.history.now(), index);
    editor.history.change(rest);
    desk.tell(texts::deleted(index + 1), Stay::Briefly);
}

/// Asks for the number of a circle or sphere that there is; `none` says that there are none.
pub(super) async fn ask_existing(
    picture: &dyn Picture,
    desk: &mut Desk<'_>,
    count: usize,
    none: Words,
) -> Asked<usize> {
    if count == 0 {
        desk.tell(none, Stay::Briefly);
        return Err(Stop::Cancelled);
    }
    if count > 99 {
        // The field of the shared question has room for two digits.
        let read = |text: &str| match text.trim().parse::<usize>() {
            Ok(number) if (1..=count).contains(&number) => Ok(number - 1),
            _ => Err(texts::no_such(count)),
        };
        return desk.meaning(picture, words::NUMBER_ENTRY, "", read).await;
    }
    let index = ask_index(desk, picture).await?;
    if index >= count {
        desk.tell(texts::no_such(count), Stay::Briefly);
        return Err(Stop::Cancelled);
    }
    Ok(index)
}

/// A number of a range as it is typed, with decimals.
pub(super) async fn ask_number(
    picture: &dyn Picture,
    desk: &mut Desk<'_>,
    caption: Words,
    [least, most]: [f64; 2],
    proposal: f64,
) -> Asked<f64> {
    let read = |text: &str| {
        let number = text.trim().replace(',', ".").parse::<f64>().ok();
        number.filter(|r| (least..=most).contains(r)).ok_or_else(|| words::out_of(&(least..=most)))
    };
    desk.meaning(picture, caption, &proposal.to_string(), read).await
}

/// Another place or radius of a circle.
async fn ask_row(editor: &Bench, desk: &mut Desk<'_>, index: usize) -> Asked<Row> {
    let [x, y, r] = editor.history.now().circles.get(index).copied().unwrap_or([0.0, 0.0, NEW_RADIUS]);
    let what = Question::new(TOP, words::ASK_CHANGE, [words::PLACE, texts::RADIUS]);
    Ok(match desk.ask(editor, &what).await? {
        Answer::First => {
            let [x, y] = ask_place_in_field(desk, editor, FIELD).await?;
            [x, y, r]
        }
        Answer::Second => [x, y, ask_number(editor, desk, texts::RADIUS_ENTRY, RADII, r).await?],
    })
}

/// A new circle: between two neighbours halfway, at the ends of a chain where the user says.
async fn insert(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<()> {
    let circles = editor.history.now().clone();
    let count = circles.circles.len();
    if value::is_full(&circles) {
        desk.tell(texts::full(), Stay::Briefly);
        return Ok(());
    }
    if circles.edges.is_some() {
        let pair = pick_two(editor, desk).await?;
        let new = value::halfway(&circles, pair).and_then(|row| value::between(&circles, pair, row));
        match new {
            Some(new) => editor.history.change(new),
            None => desk.tell(texts::no_neighbours(pair), Stay::UntilRead),
        }
        return Ok(());
    }
    let index = if count == 0 { 0 } else { ask_index(desk, editor).await?.min(count) };
    let pair = match index {
        0 if circles.closed => Some([count - 1, 0]),
        0 => None,
        _ if index < count => Some([index - 1, index]),
        _ if circles.closed => Some([count - 1, 0]),
        _ => None,
    };
    let row = match pair.and_then(|pair| value::halfway(&circles, pair)) {
        Some(row) => row,
        None => {
            let [x, y] = ask_place_in_field(desk, editor, FIELD).await?;
            [x, y, ask_number(editor, desk, texts::RADIUS_ENTRY, RADII, NEW_RADIUS).await?]
        }
    };
    let [x, y, r] = row;
    editor.history.change(value::inserted(&circles, index, [x, y, radius(r)]));
    Ok(())
}

/// Waits for clicks on two circles, or for their numbers after Enter.
async fn pick_two(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<[usize; 2]> {
    let count = editor.history.now().circles.len();
    if count < 2 {
        desk.tell(texts::NO_SKIN, Stay::Briefly);
        return Err(Stop::Cancelled);
    }
    let picked = pick(editor, desk, count).await;
    editor.craft.pointed_out = None;
    picked
}

async fn pick(editor: &mut Bench, desk: &mut Desk<'_>, count: usize) -> Asked<[usize; 2]> {
    loop {
        let first = editor.craft.pointed_out;
        let over = Over::new(&*editor, |screen: &mut Screen, language: Language| {
            page(screen, TOP);
            screen.text(TOP.0 + 8, TOP.1 + 10, texts::picked(first).of(language), Color::Black);
            screen.text(TOP.0 + 8, TOP.1 + 23, texts::PICK_KEYS.of(language), Color::Black);
        });
        let tick = desk.event_asked(&over, Request::Keys(Vec::new())).await?;
        if tick.pressed(Key::Esc) {
            return Err(Stop::Cancelled);
        }
        if tick.pressed(Key::Enter) {
            let read = |text: &str| two_numbers(text, count).ok_or_else(|| texts::not_two(count));
            return desk.meaning(&*editor, texts::WHICH_TWO, "", read).await;
        }
        let Some((x, y)) = tick.click() else { continue };
        match (first, discs::number_at(editor, (x, y))) {
            (Some(first), Some(second)) if first != second => return Ok([first, second]),
            (None, Some(first)) => editor.craft.pointed_out = Some(first),
            _ if PICTURE.holds(x, y) => {}
            _ => return Err(Stop::Cancelled),
        }
    }
}

/// Two different numbers from 1 to `count`, as indices.
fn two_numbers(text: &str, count: usize) -> Option<[usize; 2]> {
    let words = text.split([' ', ',', ';', '-']).filter(|word| !word.is_empty());
    let numbers: Result<Vec<usize>, _> = words.map(str::parse).collect();
    let [a, b] = <[usize; 2]>::try_from(numbers.ok()?).ok()?;
    let known = |number: &usize| (1..=count).contains(number);
    (known(&a) && known(&b) && a != b).then(|| [a - 1, b - 1])
}

/// How the skin is drawn.
#[derive(Clone, Copy, PartialEq)]
enum Choice {
    Style(Style),
    Clearing(Clearing),
}

async fn choose_skin(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<()> {
    let (x, y) = TOP;
    let window = |from: i32, to: i32, row: i32| Area::new(x + from, y + row, x + to, y + row + 13);
    let answer = |area: Area, text: Hot, choice: Choice| (area, text, choice);
    let answers = vec![
        answer(window(8, 76, 5), texts::OPEN, Choice::Style(Style::Open)),
        answer(window(86, 150, 5), texts::CAPS, Choice::Style(Style::Caps)),
        answer(window(160, 232, 5), texts::FILLED, Choice::Style(Style::Filled)),
        answer(window(8, 100, 24), texts::PLAIN, Choice::Clearing(Clearing::Plain)),
        answer(window(130, 232, 24), texts::CLEARED, Choice::Clearing(Clearing::Scaled)),
    ];
    let choices = Choices { place: TOP, captions: Vec::new(), answers };
    let present = Choice::Style(editor.craft.options.style);
    let default = desk.machine.manner() == crate::machine::Manner::Today;
    match desk.choose_or(&*editor, &choices, Some(present).filter(|_| default)).await? {
        Choice::Style(style) => editor.craft.options.style = style,
        Choice::Clearing(clearing) => editor.craft.options.clearing = clearing,
    }
    Ok(())
}

/// The key F8: the offending discs shrink until the rules are kept.
fn nearest(editor: &mut Bench, desk: &mut Desk<'_>) {
    let before = editor.history.now().clone();
    let Ok(circles) = skin::circles(&before) else {
        desk.tell(texts::NO_CIRCLES, Stay::Briefly);
        return;
    };
    match circles.nearest_admissible() {
        Some(found) => {
            let found = skin::document(&found);
            let shrunk = before.circles.iter().zip(&found.circles).filter(|(a, b)| a != b).count();
            if shrunk == 0 {
                desk.tell(texts::IS_ADMISSIBLE, Stay::Briefly);
            } else {
                editor.history.change(found);
                desk.tell(texts::shrunk(shrunk), Stay::Briefly);
            }
        }
        None => desk.tell(texts::NEVER, Stay::UntilRead),
    }
}

/// Whether there is a skin to show alone; asks whether with the circles.
pub(super) async fn begin_result(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<bool> {
    if editor.dressed().is_none_or(|dressed| dressed.skin.loops.is_empty()) {
        desk.tell(texts::NO_SKIN, Stay::Briefly);
        return Ok(false);
    }
    let answer = desk.ask(editor, &Question::yes_no(texts::ASK_CIRCLES)).await?;
    editor.stage = Stage::Result { points: answer == Answer::First };
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_numbers_are_read() {
        assert_eq!(two_numbers("2 3", 4), Some([1, 2]));
        assert_eq!(two_numbers(" 4-1", 4), Some([3, 0]));
        for text in ["", "2", "2 2", "0 1", "1 5", "1 2 3", "a b"] {
            assert_eq!(two_numbers(text, 4), None, "{text}");
        }
    }
}
