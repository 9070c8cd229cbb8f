//! What both puzzles share in the manner of today: the same keys and buttons, presets and numbers of problems, the
//! celebration of a solved puzzle, the best results.

use crate::machine::{Asked, Best, Key, Language};
use crate::screen::{Color, Screen};
use crate::ui::{
    Area, Caption, Choices, Command, Desk, Field, Form, Hot, KeyHelp, MIDDLE, Number, Pad, Phrase, Picture,
    Stay, Stopwatch, Words, line,
};
use std::time::Duration;

/// What the keys of both puzzles do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Control {
    /// Another problem of the same difficulty.
    New,
    /// A problem by difficulty and number.
    Choose,
    Hint,
    Solve,
    Undo,
    Redo,
    Restart,
    Help,
}

/// How many rows [`controls`] has.
pub(crate) const CONTROLS: usize = 10;

/// The rows of both puzzles, their buttons in columns from a corner on.
pub(crate) const fn controls((x, y): (i32, i32), columns: i32) -> [Command<Control>; CONTROLS] {
    [
        pad(x, y, columns, 0, Key::F(7), NEW, NEW_HELP, Control::New),
        pad(x, y, columns, 1, Key::Char('P'), CHOOSE, CHOOSE_HELP, Control::Choose),
        pad(x, y, columns, 2, Key::Char('H'), HINT, HINT_HELP, Control::Hint),
        pad(x, y, columns, 3, Key::Char('O'), SOLVE, SOLVE_HELP, Control::Solve),
        pad(x, y, columns, 4, Key::Ctrl('Z'), UNDO, UNDO_HELP, Control::Undo),
        pad(x, y, columns, 5, Key::Ctrl('Y'), REDO, UNDO_HELP, Control::Redo).untold(),
        pad(x, y, columns, 6, Key::F(6), RESTART, RESTART_HELP, Control::Restart),
        // The desk itself answers F1, and tells of it.
        pad(x, y, columns, 7, Key::F(1), HELP, RESTART_HELP, Control::Help).untold(),
        Command::also(Key::F(4), Control::Hint),
        Command::also(Key::F(5), Control::Solve),
    ]
}

#[allow(clippy::too_many_arguments, reason = "a row of the table above")]
const fn pad(
    x: i32,
    y: i32,
    columns: i32,
    place: i32,
    key: Key,
    text: Words,
    help: KeyHelp,
    control: Control,
) -> Command<Control> {
    let pad = Pad::new(x + 110 * (place % columns), y + 17 * (place / columns), text);
    Command::pad(key, pad, help, control)
}

const NEW: Words = Words("új játék", "new game");
const CHOOSE: Words = Words("szint, szám", "level, no.");
const HINT: Words = Words("segítség", "hint");
const SOLVE: Words = Words("megoldás", "solve");
const UNDO: Words = Words("vissza", "undo");
const REDO: Words = Words("mégis", "redo");
const RESTART: Words = Words("elölről", "restart");
const HELP: Words = Words("súgó", "help");
const NEW_HELP: KeyHelp = line("F7", "új játék, ugyanilyen nehéz", "a new game, as difficult as this one");
const CHOOSE_HELP: KeyHelp =
    line("P", "új játék: nehézség és sorszám", "a new game by difficulty and number");
const HINT_HELP: KeyHelp = line("H F4", "segítség: a következő lépés", "hint: the next move");
const SOLVE_HELP: KeyHelp =
    line("O F5", "megoldás lejátszása; Esc megállítja", "play a solution; Esc stops it");
const UNDO_HELP: KeyHelp = line("Ctrl+Z Ctrl+Y", "lépés visszavonása, mégis", "undo, redo a move");
const RESTART_HELP: KeyHelp = line("F6", "ugyanez elölről", "the same from its start");

/// How much the machine has helped in a game; only a game without help counts for the best results.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Help {
    #[default]
    None,
    Hints,
    Solution,
}

/// The largest number of a problem.
pub(crate) const MOST: i32 = 999_999;

/// Asks for one of several presets, in windows from left to right; Enter takes the default.
///
/// # Errors
/// [`Stop`](crate::machine::Stop): Esc, or the display is being closed.
pub(crate) async fn ask_preset<T: Copy + PartialEq>(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    title: Words,
    presets: &[(Hot, T)],
    default: T,
) -> Asked<T> {
    let (x, y) = MIDDLE;
    let mut left = x + 5;
    let mut window = |text: &Hot| {
        // Wide enough for either language, which may change while the question stands.
        let letters = 1 + text.rest.0.chars().count().max(text.rest.1.chars().count());
        let width = 8 * i32::try_from(letters).unwrap_or(0) + 10;
        let area = Area::new(left, y + 21, left + width, y + 34);
        left += width + 4;
        area
    };
    let answers = presets.iter().map(|&(text, it)| (window(&text), text, it)).collect();
    let mut captions = vec![Caption::new((x + 7, y + 8), title)];
    if let Some((text, _)) = presets.iter().find(|(_, it)| *it == default) {
        // There is room for a number, or the letter of a word.
        let short = |rest: &'static str| if rest.len() > 1 { "" } else { rest };
        let taken = |rest| format!("Enter: {}{}", text.letter, short(rest));
        let taken = Phrase::new(taken(text.rest.0), taken(text.rest.1));
        captions.push(Caption::new((x + 164, y + 8), taken).colored(Color::Blue));
    }
    let choices = Choices { place: MIDDLE, captions, answers };
    desk.choose_or(picture, &choices, Some(default)).await
}

/// Asks for the number of a problem and proposes one.
///
/// # Errors
/// [`Stop`](crate::machine::Stop): Esc, or the display is being closed.
pub(crate) async fn ask_number(desk: &mut Desk<'_>, picture: &dyn Picture, proposal: u64) -> Asked<u64> {
    let field =
        Field { area: Area::new(340, 8, 430, 22), at: (348, 12), longest: 6, kind: Number::Whole(0..=MOST) };
    let captions = vec![
        Caption::new((216, 12), Words("Sorszám:", "Number:")),
        Caption::new((216, 30), Words("Enter: ez a szám", "Enter: this number")),
    ];
    let form = Form::new(captions, [field]);
    let [number] = desk.numbers_or(picture, &form, [proposal.to_string()]).await?;
    // The number is whole and between 0 and the largest one.
    Ok(number as u64)
}

/// A finished puzzle is celebrated for some frames; then nothing moves any more.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Party {
    begun: Duration,
}

const PARTY_FRAME: Duration = Duration::from_millis(100);
const PARTY_FRAMES: u32 = 24;

impl Party {
    pub(crate) fn new(now: Duration) -> Party {
        Party { begun: now }
    }

    fn frame(self, now: Duration) -> u32 {
        let passed = now.saturating_sub(self.begun).as_millis() / PARTY_FRAME.as_millis();
        u32::try_from(passed).unwrap_or(PARTY_FRAMES).min(PARTY_FRAMES)
    }

    /// When the next frame is due; `None` when all is over.
    pub(crate) fn next(self, now: Duration) -> Option<Duration> {
        let frame = self.frame(now);
        (frame < PARTY_FRAMES).then(|| self.begun + PARTY_FRAME * (frame + 1))
    }

    /// Draws sparks in all colours that fly from a centre.
    pub(crate) fn draw(self, screen: &mut Screen, (x, y): (i32, i32), now: Duration) {
        let frame = self.frame(now);
        if frame >= PARTY_FRAMES {
            return;
        }
        for spark in 0..42_u32 {
            let (sin, cos) = f64::from(spark * 137 + 5).to_radians().sin_cos();
            let far = f64::from(frame) * (4.0 + f64::from(spark % 7));
            // Sparks fall: half a pixel for every frame squared.
            let fall = f64::from(frame * frame) / 6.0;
            let at = (x + (far * cos).round() as i32, y + (far * sin + fall).round() as i32);
            let color = Color::from_index(9 + ((spark + frame) % 6) as u8);
            screen.disc(at.0, at.1, 3, color, Color::Black);
        }
    }
}

/// Keeps a result and gives the best one, where results are kept.
pub(crate) fn keep_best(desk: &mut Desk<'_>, game: &str, result: Best) -> Option<Best> {
    let bests = desk.machine.bests()?;
    let kept = bests.keep(game, result);
    let best = bests.best(game);
    if let Err(problem) = kept {
        desk.tell(Phrase::plain(&problem), Stay::UntilRead);
    }
    best
}

/// The best results so far.
pub(crate) fn best_text(best: Best, language: Language) -> String {
    let time = Stopwatch::text(Duration::from_secs(best.seconds));
    format!("{} {}, {time}", Words("Rekord:", "Best:").of(language), best.moves)
}

/// What the shortest known way is, beside the player's.
pub(crate) fn known_text(known: usize, proven: bool, language: Language) -> String {
    let proof = match proven {
        true => Words("(bizonyított)", "(proven)"),
        false => Words("(eddig ismert)", "(known so far)"),
    };
    format!("{} {known} {}", Words("Legrövidebb:", "Shortest:").of(language), proof.of(language))
}

/// How a game has ended.
pub(crate) fn end_text(help: Help) -> Words {
    match help {
        Help::None => Words("Kirakva!", "Solved!"),
        Help::Hints => Words("Kirakva, segítséggel", "Solved with hints"),
        Help::Solution => Words("A gép rakta ki: nem számít", "By the machine: no score"),
    }
}
