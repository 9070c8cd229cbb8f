//! What the player does: choosing, moving and turning pieces, looking around, asking for help.

use super::eye::Eye;
use super::hand::Hand;
use super::panel::{self, FIELD};
use super::picture::{Scene, draw_axes};
use super::task::{PACE, Plan, Quest, Task, Wanted};
use super::texts;
use crate::editor::keys;
use crate::file::{CsangoCube, Document, Format};
use crate::machine::{Asked, Asking, Button, Event, FRAMES_PER_SECOND, Key, Language, Machine, Tick};
use crate::puzzle::cube::{self, Move, PIECES, Rules};
use crate::screen::{Color, Screen};
use crate::ui::{Command, Commands, Desk, KeyHelp, Manual, Phrase, Picture, Stay, Stopwatch};
use crate::work::{self, History, Next, Work};
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// Time within which a second digit belongs to the first.
const DIGITS: Duration = Duration::from_millis(1000);
/// Number of random attempts to move a piece in a scramble.
const TRIES: u32 = 2000;

/// What a command does.
#[derive(Clone, Copy)]
enum Action {
    Do(fn(&mut Player, &mut Desk<'_>)),
    Quit,
}

/// The commands; moves have the other letters.
const COMMANDS: Commands<Action> = Commands(&[
    Command::told(texts::MOVE),
    Command::told(texts::TURN),
    Command::key(Key::Char('A'), texts::OTHER, Action::Do(|player, _| player.select(player.selected + 1))),
    Command::also(Key::Char('B'), Action::Do(|player, _| player.select(player.selected + PIECES - 1))),
    Command::told(texts::DRAG),
    Command::told(texts::LIFT),
    Command::key(Key::Left, texts::LOOK, Action::Do(|player, _| player.eye = player.eye.turned(1))),
    Command::also(Key::Right, Action::Do(|player, _| player.eye = player.eye.turned(-1))),
    Command::also(Key::Up, Action::Do(|player, _| player.eye = player.eye.lower())),
    Command::also(Key::Down, Action::Do(|player, _| player.eye = player.eye.higher())),
    Command::also(Key::Home, Action::Do(|player, _| player.eye = Eye::HOME)),
    Command::key(Key::F(3), texts::RIGID, Action::Do(Player::switch_rules)),
    Command::key(Key::F(4), texts::HINT, Action::Do(|player, desk| player.seek(desk, Wanted::Hint))),
    Command::key(Key::F(5), texts::SOLVE, Action::Do(|player, desk| player.seek(desk, Wanted::Solution))),
    Command::key(Key::F(6), texts::RESTART, Action::Do(|player, _| player.begin(player.first))),
    Command::key(Key::F(7), texts::SCRAMBLE, Action::Do(|player, _| player.scramble())),
    Command::told(keys::UNDO),
    Command::told(keys::SAVE),
    Command::key(Key::Char('Q'), keys::QUIT, Action::Quit),
    Command::also(Key::Esc, Action::Do(|player, _| player.hinted = false)),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

/// What undo takes back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Play {
    cube: CsangoCube,
    moves: u32,
}

/// A game as it is kept while it is unsaved.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Kept {
    first: CsangoCube,
    cube: CsangoCube,
    moves: u32,
}

/// The program's state.
struct Player {
    plays: History<Play>,
    /// The position of the restart.
    first: CsangoCube,
    selected: usize,
    eye: Eye,
    rules: Rules,
    clock: Stopwatch,
    /// The desk's time at the last look.
    now: Duration,
    digit: Option<(usize, Duration)>,
    hand: Option<Hand>,
    task: Task,
    plan: Option<Plan>,
    hinted: bool,
    seed: u64,
}

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    /// The position in a line: four signs a piece.
    state: String,
    finished: bool,
    moves: u32,
    /// The chosen piece, from 1.
    piece: usize,
    eye: Eye,
    rigid: bool,
    unsaved: bool,
    /// What the program does: `idle`, `seeking` or `playing`.
    task: &'static str,
    hint: Option<String>,
    cube: CsangoCube,
}

/// Plays until the end.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(crate) async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Asked<()> {
    let player = Player::new(machine.seed());
    work::run(player, &mut Desk::new(machine, manual), document).await
}

impl Picture for Player {
    fn draw(&self, screen: &mut Screen, language: Language) {
        let hint = self.hint();
        let color = |piece: usize| Color::ALL.get(piece + 1).copied().unwrap_or_default();
        panel::draw(screen, language, color(self.selected), hint.map(|it| it.action.letter()));
        self.scene().draw(screen);
        draw_axes(screen, self.eye);
        screen.text(330, 468, &self.line(language), Color::Black);
        if let Some(hint) = hint {
            screen.bar(316, 467, 325, 476, color(hint.piece));
        }
    }
}

impl Player {
    fn new(seed: u64) -> Player {
        let start = CsangoCube::start();
        Player {
            plays: History::new(Play { cube: start, moves: 0 }),
            first: start,
            selected: 0,
            eye: Eye::HOME,
            rules: Rules::Book,
            clock: Stopwatch::default(),
            now: Duration::ZERO,
            digit: None,
            hand: None,
            task: Task::Idle,
            plan: None,
            hinted: false,
            seed,
        }
    }

    /// The position, with a held piece where it is held.
    fn cube(&self) -> CsangoCube {
        self.hand.as_ref().map_or(self.plays.now().cube, |hand| hand.cube)
    }

    fn scene(&self) -> Scene {
        Scene::new(&self.cube(), self.eye)
    }

    /// The move that is shown.
    fn hint(&self) -> Option<Move> {
        let plan = self.plan.as_ref().filter(|plan| self.hinted && plan.at == self.plays.now().cube)?;
        plan.moves.front().copied()
    }

    /// The line under the field; empty before the first move.
    fn line(&self, language: Language) -> String {
        match (&self.task, self.hint()) {
            (Task::Seeking(quest), _) => texts::progress(quest.progress(), language),
            (Task::Playing(moves, _), _) => texts::left(moves.len(), language),
            (Task::Idle, Some(hint)) => texts::hint(hint, language),
            (Task::Idle, None) => match (self.plays.now().moves, self.rules) {
                (0, Rules::Book) => String::new(),
                (moves, rules) => texts::score(moves, self.clock.time(self.now), rules, language),
            },
        }
    }

    /// Continues what the program does by itself.
    fn go_on(&mut self, desk: &mut Desk<'_>) {
        match std::mem::replace(&mut self.task, Task::Idle) {
            Task::Idle => {}
            Task::Seeking(mut quest) => match quest.advance() {
                Ok(None) => self.task = Task::Seeking(quest),
                Ok(Some(moves)) => {
                    let plan = Plan { at: self.plays.now().cube, rules: self.rules, moves: moves.into() };
                    self.take_up(plan, quest.wanted);
                }
                Err(_) => desk.tell(texts::NO_WAY, Stay::Briefly),
            },
            Task::Playing(mut moves, due) if due <= self.now => {
                let Some(step) = moves.pop_front() else { return };
                self.selected = step.piece;
                if self.make(step) {
                    self.task = Task::Playing(moves, self.now + PACE);
                    self.look_whether_finished(desk);
                }
            }
            playing => self.task = playing,
        }
    }

    fn take_up(&mut self, plan: Plan, wanted: Wanted) {
        match wanted {
            Wanted::Hint => self.hinted = true,
            Wanted::Solution => self.task = Task::Playing(plan.moves.clone(), self.now),
        }
        if let Some(step) = plan.moves.front().filter(|_| wanted == Wanted::Hint) {
            self.selected = step.piece;
        }
        self.plan = Some(plan);
    }

    /// Makes a move if it is allowed; returns whether it was.
    fn make(&mut self, step: Move) -> bool {
        let Ok(cube) = self.plays.now().cube.after(step, self.rules) else { return false };
        self.plan = self.plan.take().and_then(|plan| plan.after(step, cube));
        self.change(cube, 1);
        true
    }

    /// Commits another position, and adds to the number of moves.
    fn change(&mut self, cube: CsangoCube, moves: u32) {
        self.hinted = false;
        self.clock.note(false, self.now);
        let moves = self.plays.now().moves.saturating_add(moves);
        self.plays.change(Play { cube, moves });
    }

    fn look_whether_finished(&mut self, desk: &mut Desk<'_>) {
        let play = *self.plays.now();
        if play.cube.is_finished() && play.moves > 0 {
            self.task = Task::Idle;
            self.clock.note(true, self.now);
            desk.tell(texts::finished(play.moves), Stay::Briefly);
        }
    }

    /// Commits another position and restarts the count of moves.
    fn begin(&mut self, cube: CsangoCube) {
        self.plays.change(Play { cube, moves: 0 });
        self.clock = Stopwatch::default();
        (self.hinted, self.plan, self.task) = (false, None, Task::Idle);
    }

    /// A new scramble each time; sessions with the same seed get the same ones.
    fn scramble(&mut self) {
        self.seed = self.seed.wrapping_add(1);
        self.begin(self.plays.now().cube.scrambled(self.seed, TRIES, self.rules));
    }

    fn seek(&mut self, desk: &mut Desk<'_>, wanted: Wanted) {
        let cube = self.plays.now().cube;
        if cube.is_finished() {
            desk.tell(texts::ALREADY, Stay::Briefly);
            return;
        }
        let known = self.plan.take().filter(|plan| plan.at == cube && plan.rules == self.rules);
        match known.filter(|plan| !plan.moves.is_empty()) {
            Some(plan) => self.take_up(plan, wanted),
            None => self.task = Task::Seeking(Box::new(Quest::new(cube, self.rules, wanted, self.seed))),
        }
    }

    fn select(&mut self, piece: usize) {
        self.selected = piece % PIECES;
        self.hinted = false;
    }

    /// A digit chooses a piece; two digits choose one above 9.
    fn digit(&mut self, digit: usize) {
        let before = self.digit.filter(|&(_, at)| self.now.saturating_sub(at) < DIGITS);
        let number = before.map(|(first, _)| 10 * first + digit).filter(|&number| number <= PIECES);
        let number = number.unwrap_or(digit);
        self.digit = Some((digit, self.now));
        if let Some(piece) = number.checked_sub(1) {
            self.select(piece);
        }
    }

    fn mouse(&mut self, desk: &mut Desk<'_>, tick: &Tick) {
        let at = (tick.mouse.x, tick.mouse.y);
        match tick.event {
            Some(Event::Press(Button::Left)) if FIELD.holds(at.0, at.1) => {
                if let Some(piece) = self.scene().piece_at(at.0, at.1) {
                    self.select(piece);
                    self.hand = Hand::new(piece, at, self.plays.now().cube);
                }
            }
            Some(Event::Move(..)) => {
                if let Some(hand) = &mut self.hand {
                    hand.follow(at, self.eye);
                }
            }
            Some(Event::Wheel(steps)) => match &mut self.hand {
                Some(hand) => hand.lift(steps),
                None => self.lift(desk, steps),
            },
            Some(Event::Release(Button::Left)) => self.let_go(desk),
            _ => {}
        }
    }

    fn lift(&mut self, desk: &mut Desk<'_>, steps: i32) {
        self.hand = Hand::new(self.selected, (0, 0), self.plays.now().cube);
        if let Some(hand) = &mut self.hand {
            hand.lift(steps);
        }
        self.let_go(desk);
    }

    /// Leaves a held piece where it is.
    fn let_go(&mut self, desk: &mut Desk<'_>) {
        let Some(hand) = self.hand.take().filter(|hand| hand.cube != self.plays.now().cube) else { return };
        self.plan = None;
        self.change(hand.cube, hand.moves());
        self.look_whether_finished(desk);
    }

    /// What a key or its button does; what leads out of the configuration is told.
    async fn key(&mut self, desk: &mut Desk<'_>, key: Key) -> Asked<Next> {
        if let Some(action) = key.letter().and_then(cube::Action::from_letter) {
            if self.make(Move { piece: self.selected, action }) {
                self.look_whether_finished(desk);
            }
            return Ok(Next::Work);
        }
        match COMMANDS.of_key(key) {
            Some(Action::Do(what)) => what(self, desk),
            Some(Action::Quit) => return work::quit(self, desk).await,
            None => {
                if let Some(digit) = key.letter().and_then(|typed| typed.to_digit(10)) {
                    self.digit(digit as usize);
                }
            }
        }
        Ok(Next::Work)
    }

    fn switch_rules(&mut self, desk: &mut Desk<'_>) {
        let (rules, told) = match self.rules {
            Rules::Book => (Rules::Rigid, texts::RIGID_ON),
            Rules::Rigid => (Rules::Book, texts::RIGID_OFF),
        };
        self.rules = rules;
        (self.plan, self.hinted) = (None, false);
        desk.tell(told, Stay::Briefly);
    }

    /// Whether an event stops what the program does by itself.
    fn stops(tick: &Tick) -> bool {
        matches!(tick.event, Some(Event::Key(_) | Event::Press(_) | Event::Wheel(_)))
    }
}

impl Work for Player {
    type Value = Play;

    fn format(&self) -> Format {
        Format::Csk
    }

    fn history(&mut self) -> &mut History<Play> {
        &mut self.plays
    }

    fn reset(&mut self) {
        *self = Player { rules: self.rules, ..Player::new(self.seed) };
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let Document::CsangoCube(cube) = document else { return Err(texts::NO_CUBE.into()) };
        self.first = *cube;
        self.plays = History::new(Play { cube: *cube, moves: 0 });
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        Ok(Document::CsangoCube(self.plays.now().cube))
    }

    fn unsaved_work(&self) -> Result<String, Phrase> {
        let Play { cube, moves } = *self.plays.now();
        let kept = Kept { first: self.first, cube, moves };
        serde_json::to_string(&kept).map_err(|error| Phrase::plain(&error))
    }

    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        let Kept { first, cube, moves } =
            serde_json::from_str(work).map_err(|error| Phrase::plain(&error))?;
        for cube in [first, cube] {
            Document::CsangoCube(cube).check().map_err(|error| Phrase::plain(&error))?;
        }
        self.first = first;
        self.plays = History::new(Play { cube, moves });
        Ok(())
    }

    fn model(&self) -> impl Serialize + 'static {
        let Play { cube, moves } = *self.plays.now();
        Model {
            state: cube.to_string(),
            finished: cube.is_finished(),
            moves,
            piece: self.selected + 1,
            eye: self.eye,
            rigid: self.rules == Rules::Rigid,
            unsaved: self.plays.unsaved(),
            task: match self.task {
                Task::Idle => "idle",
                Task::Seeking(_) => "seeking",
                Task::Playing(..) => "playing",
            },
            hint: self.hint().map(|step| step.to_string()),
            cube: self.cube(),
        }
    }

    fn look(&mut self, desk: &Desk<'_>) {
        self.now = desk.clock();
    }

    fn due(&self) -> Option<Duration> {
        let next = match &self.task {
            Task::Seeking(_) => return Some(Duration::from_secs(1) / FRAMES_PER_SECOND),
            Task::Playing(_, due) => *due,
            Task::Idle => self.clock.next_second(self.now).filter(|_| self.plays.now().moves > 0)?,
        };
        Some(next.saturating_sub(self.now))
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        // The close button may have been pressed in the middle of a task.
        (self.hand, self.task) = (None, Task::Idle);
        loop {
            let tick = work::event(self, desk).await?;
            if !matches!(self.task, Task::Idle) {
                if Player::stops(&tick) {
                    self.task = Task::Idle;
                    desk.tell(texts::STOPPED, Stay::Briefly);
                } else {
                    self.go_on(desk);
                }
                continue;
            }
            if self.hand.is_some() && tick.key().is_some() {
                // Any key puts a held piece back.
                self.hand = None;
                continue;
            }
            if self.hand.is_some()
                && !tick.mouse.holds(Button::Left)
                && tick.event != Some(Event::Release(Button::Left))
            {
                self.hand = None; // the button went up while help was read
            }
            let button = tick.click().and_then(|(x, y)| panel::key_at(x, y));
            if work::common_key(self, desk, tick.key()).await? {
                self.hinted = false;
            } else if let Some(key) = tick.key().or(button) {
                match self.key(desk, key).await.unless_cancelled()? {
                    None | Some(Next::Work) => {}
                    Some(next) => return Ok(next),
                }
            } else {
                self.mouse(desk, &tick);
            }
        }
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
