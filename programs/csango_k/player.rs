//! What the player does: choosing, moving and turning pieces, looking around, asking for help.

mod moving;
mod page;
mod score;

use super::super::puzzles::{self, CONTROLS, Control, Help, MOST, Party, controls};
use super::eye::Eye;
use super::game::{Deal, Preset};
use super::hand::Hand;
use super::panel;
use super::picture::{Goal, Scene, painting};
use super::task::{PACE, Plan, Quest, Task, Wanted};
use super::texts;
use crate::editor::keys;
use crate::file::{CsangoCube, Document, Format};
use crate::machine::{
    Asked, Asking, Best, Button, Event, FRAMES_PER_SECOND, Key, Machine, Manner, Stop, Tick,
};
use crate::puzzle::cube::{Move, PIECES, Refused, Rules};
use crate::ui::look::SIGHT_KEY;
use crate::ui::painter::{PAINTER_HELP, PAINTER_KEY, Steps, StepsModel};
use crate::ui::{Command, Commands, Desk, KeyHelp, Manual, Phrase, Stay, Stopwatch};
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
    Command::also(Key::Home, Action::Do(|player, _| player.eye = player.eye.home())),
    Command::key(SIGHT_KEY, keys::SIGHT, Action::Do(Player::next_sight)),
    Command::key(Key::F(3), texts::RIGID, Action::Do(Player::switch_rules)),
    Command::key(Key::F(4), texts::HINT, Action::Do(|player, desk| player.seek(desk, Wanted::Hint))),
    Command::key(Key::F(5), texts::SOLVE, Action::Do(|player, desk| player.seek(desk, Wanted::Solution))),
    Command::key(Key::F(6), texts::RESTART, Action::Do(|player, _| player.begin(player.plays.now().first))),
    Command::key(Key::F(7), texts::SCRAMBLE, Action::Do(|player, _| player.scramble())),
    Command::key(PAINTER_KEY, PAINTER_HELP, Action::Do(|player, _| player.paint())),
    Command::told(keys::UNDO),
    Command::told(keys::SAVE),
    Command::key(Key::Char('Q'), keys::QUIT, Action::Quit),
    Command::also(Key::Esc, Action::Do(|player, _| player.hinted = false)),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

const ROWS: [Command<Control>; CONTROLS] = controls((30, 60), 3);
/// The buttons in the manner of today, which are those of the other puzzle too.
const TODAY: Commands<Control> = Commands(&ROWS);

/// The help page in the manner of today.
const KEYS_TODAY: &[KeyHelp] = &{
    const OWN: usize = 7;
    const SHARED: usize = TODAY.lines();
    const COMMON: [KeyHelp; SHARED] = TODAY.help();
    let mut keys = [texts::MOVE; OWN + SHARED + 4];
    keys[1] = texts::TURN;
    keys[2] = texts::OTHER;
    keys[3] = texts::DRAG;
    keys[4] = texts::LIFT;
    keys[5] = texts::LOOK;
    keys[6] = keys::SIGHT;
    let mut row = 0;
    while row < SHARED {
        keys[OWN + row] = COMMON[row];
        row += 1;
    }
    keys[OWN + SHARED] = texts::RIGID;
    keys[OWN + SHARED + 1] = PAINTER_HELP;
    keys[OWN + SHARED + 2] = keys::SAVE;
    keys[OWN + SHARED + 3] = keys::QUIT;
    keys
};

/// What undo takes back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Play {
    /// The position of the restart.
    first: CsangoCube,
    cube: CsangoCube,
    moves: u32,
    /// The game of the number that it began with.
    deal: Option<Deal>,
    help: Help,
}

impl Play {
    fn from(first: CsangoCube) -> Play {
        Play { first, cube: first, moves: 0, deal: None, help: Help::None }
    }
}

/// A game as it is kept while it is unsaved.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Kept {
    first: CsangoCube,
    cube: CsangoCube,
    moves: u32,
    #[serde(default)]
    deal: Option<Deal>,
    #[serde(default)]
    help: Help,
}

/// The program's state.
struct Player {
    plays: History<Play>,
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
    manner: Manner,
    /// Whether there is a configuration, not only a question for it.
    begun: bool,
    /// The game that is to be dealt when the work begins; it needs no saving.
    wanted: Option<Deal>,
    /// Whether the next game that is dealt is the first one.
    fresh: bool,
    /// How much has been helped since the last move.
    help: Help,
    refused: Option<Refused>,
    party: Option<Party>,
    /// The painter's steps, if they are shown.
    steps: Option<Steps>,
    /// The name of the game that results are kept under, and the best one.
    best: (String, Option<Best>),
    /// The solution from the start of a game that is known: where that is and its length.
    known: Option<(CsangoCube, usize)>,
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
    /// The step of the painter, if it is shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    painter: Option<StepsModel>,
    cube: CsangoCube,
}

/// Plays until the end.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(crate) async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Asked<()> {
    let player = Player::new(machine.seed(), machine.manner());
    work::run(player, &mut Desk::new(machine, manual), document).await
}

impl Player {
    fn new(seed: u64, manner: Manner) -> Player {
        Player {
            plays: History::new(Play::from(CsangoCube::start())),
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
            manner,
            begun: false,
            wanted: None,
            fresh: false,
            help: Help::None,
            refused: None,
            party: None,
            steps: None,
            best: (String::new(), None),
            known: None,
        }
    }

    /// The position, with a held piece where it is held.
    fn cube(&self) -> CsangoCube {
        self.hand.as_ref().map_or(self.plays.now().cube, |hand| hand.cube)
    }

    fn scene(&self) -> Scene {
        let goal = match self.manner {
            Manner::Original => Goal::Unmarked,
            Manner::Today => Goal::Marked,
        };
        Scene::new(&self.cube(), self.eye, goal)
    }

    /// The move that is shown.
    fn hinted_move(&self) -> Option<Move> {
        let plan = self.plan.as_ref().filter(|plan| self.hinted && plan.at == self.plays.now().cube)?;
        plan.moves.front().copied()
    }

    /// Continues what the program does by itself.
    fn go_on(&mut self, desk: &mut Desk<'_>) {
        match std::mem::replace(&mut self.task, Task::Idle) {
            Task::Idle => {}
            Task::Seeking(mut quest) => match quest.advance() {
                Ok(None) => self.task = Task::Seeking(quest),
                Ok(Some(moves)) => {
                    if let Wanted::Deal(deal) = quest.wanted {
                        let (cube, left) = deal.preset.along(&moves, self.rules);
                        return self.start_deal(deal, cube, left);
                    }
                    let play = self.plays.now();
                    if play.cube == play.first {
                        self.known = Some((play.first, moves.len()));
                    }
                    let plan = Plan { at: self.plays.now().cube, rules: self.rules, moves: moves.into() };
                    self.take_up(plan, quest.wanted);
                }
                Err(_) => desk.tell(texts::NO_WAY, Stay::Briefly),
            },
            Task::Playing(mut moves, due) if due <= self.now => {
                let Some(step) = moves.pop_front() else { return };
                self.selected = step.piece;
                self.help = Help::Solution;
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
            Wanted::Hint => {
                self.hinted = true;
                self.help = self.help.max(Help::Hints);
            }
            // A deal has been carried out where it was found.
            Wanted::Deal(_) => return,
            Wanted::Solution => self.task = Task::Playing(plan.moves.clone(), self.now),
        }
        if let Some(step) = plan.moves.front().filter(|_| wanted == Wanted::Hint) {
            self.selected = step.piece;
        }
        self.plan = Some(plan);
    }

    fn look_whether_finished(&mut self, desk: &mut Desk<'_>) {
        let play = *self.plays.now();
        if play.cube.is_finished() && play.moves > 0 {
            self.task = Task::Idle;
            self.clock.note(true, self.now);
            match self.manner {
                Manner::Original => desk.tell(texts::finished(play.moves), Stay::Briefly),
                Manner::Today => self.celebrate(desk, play),
            }
        }
    }

    /// Commits another position and restarts the count of moves.
    fn begin(&mut self, cube: CsangoCube) {
        let play = *self.plays.now();
        self.start_play(Play { cube, moves: 0, help: Help::None, ..play });
    }

    fn start_play(&mut self, play: Play) {
        match std::mem::take(&mut self.fresh) {
            true => self.plays = History::new(play),
            false => self.plays.change(play),
        }
        self.clock = Stopwatch::default();
        (self.hinted, self.plan, self.task) = (false, None, Task::Idle);
        (self.help, self.refused, self.party) = (Help::None, None, None);
    }

    /// Begins a game that has been dealt, with the moves that are known to solve it.
    fn start_deal(&mut self, deal: Deal, cube: CsangoCube, moves: Vec<Move>) {
        self.start_play(Play { deal: Some(deal), ..Play::from(cube) });
        self.known = Some((cube, moves.len())).filter(|&(_, count)| count > 0);
        self.plan = Some(Plan { at: cube, rules: self.rules, moves: moves.into() });
    }

    /// Deals a game: at once, or by the search for a cube that pieces are taken from.
    fn deal(&mut self, deal: Deal) {
        let start = CsangoCube::start();
        if deal.preset == Preset::Mixed {
            return self.start_deal(deal, start.scrambled(deal.number, TRIES, self.rules), Vec::new());
        }
        let quest = Quest::new(start, self.rules, Wanted::Deal(deal), deal.number);
        self.task = Task::Seeking(Box::new(quest));
    }

    /// The next number of a game, which can be typed.
    fn next_number(&mut self) -> u64 {
        self.seed = self.seed.wrapping_add(1);
        self.seed % (MOST as u64 + 1)
    }

    /// Carries out what both puzzles can do.
    async fn control(&mut self, desk: &mut Desk<'_>, control: Control) -> Asked<()> {
        match control {
            Control::New => {
                let preset = self.plays.now().deal.map_or(Preset::Three, |deal| deal.preset);
                let number = self.next_number();
                self.deal(Deal { preset, number });
            }
            Control::Choose => {
                let now = self.plays.now().deal.map_or(Preset::Three, |deal| deal.preset);
                let title = texts::ASK_START;
                let preset = puzzles::ask_preset(desk, &*self, title, &texts::PRESETS, now).await?;
                let proposal = self.next_number();
                let number = puzzles::ask_number(desk, &*self, proposal).await?;
                self.deal(Deal { preset, number });
            }
            Control::Hint => self.seek(desk, Wanted::Hint),
            Control::Solve => self.seek(desk, Wanted::Solution),
            Control::Undo => self.step(desk, Key::Ctrl('Z')).await?,
            Control::Redo => self.step(desk, Key::Ctrl('Y')).await?,
            Control::Restart => self.begin(self.plays.now().first),
            Control::Help => desk.help().await?,
        }
        Ok(())
    }

    async fn step(&mut self, desk: &mut Desk<'_>, key: Key) -> Asked<()> {
        (self.hinted, self.refused, self.party) = (false, None, None);
        work::common_key(self, desk, Some(key)).await?;
        let play = self.plays.now();
        self.clock.note(play.cube.is_finished() && play.moves > 0, self.now);
        Ok(())
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

    fn next_sight(&mut self, desk: &mut Desk<'_>) {
        self.eye = self.eye.next_sight();
        desk.tell(self.eye.sight.told(), Stay::Briefly);
    }

    /// Begins the painter's steps.
    fn paint(&mut self) {
        self.steps = Some(Steps::new(painting(&self.cube(), self.eye)));
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
        // Rules and view stay, as in the original.
        *self = Player { rules: self.rules, eye: self.eye, ..Player::new(self.seed, self.manner) };
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let Document::CsangoCube(cube) = document else { return Err(texts::NO_CUBE.into()) };
        self.plays = History::new(Play::from(*cube));
        self.begun = true;
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        Ok(Document::CsangoCube(self.plays.now().cube))
    }

    fn unsaved_work(&self) -> Result<String, Phrase> {
        let Play { first, cube, moves, deal, help } = *self.plays.now();
        let kept = Kept { first, cube, moves, deal, help };
        serde_json::to_string(&kept).map_err(|error| Phrase::plain(&error))
    }

    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        let Kept { first, cube, moves, deal, help } =
            serde_json::from_str(work).map_err(|error| Phrase::plain(&error))?;
        for cube in [first, cube] {
            Document::CsangoCube(cube).check().map_err(|error| Phrase::plain(&error))?;
        }
        self.plays = History::new(Play { first, cube, moves, deal, help });
        self.begun = true;
        Ok(())
    }

    fn model(&self) -> impl Serialize + 'static {
        let Play { cube, moves, .. } = *self.plays.now();
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
            hint: self.hinted_move().map(|step| step.to_string()),
            painter: self.steps.as_ref().map(Steps::model),
            cube: self.cube(),
        }
    }

    async fn ask_first(&mut self, desk: &mut Desk<'_>) -> Asked<bool> {
        while desk.machine.manner() == Manner::Today {
            let title = texts::ASK_START;
            let asked = puzzles::ask_preset(desk, &*self, title, &texts::START, Some(Preset::Three));
            let begun = match asked.await.unless_cancelled()? {
                Some(Some(preset)) => {
                    let number = self.next_number();
                    (self.wanted, self.fresh) = (Some(Deal { preset, number }), true);
                    true
                }
                Some(None) => work::load(self, desk, Stay::Briefly).await.unless_cancelled()? == Some(true),
                None if desk.machine.return_to_host() => return Err(Stop::Closed),
                None => true,
            };
            if begun {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn look(&mut self, desk: &Desk<'_>) {
        self.now = desk.clock();
        self.manner = desk.machine.manner();
        if self.party.is_some_and(|party| party.next(self.now).is_none()) {
            self.party = None;
        }
    }

    fn due(&self) -> Option<Duration> {
        let next = match &self.task {
            Task::Seeking(_) => return Some(Duration::from_secs(1) / FRAMES_PER_SECOND),
            Task::Playing(_, due) => *due,
            Task::Idle => {
                let second = self.clock.next_second(self.now).filter(|_| self.plays.now().moves > 0);
                let party = self.party.and_then(|party| party.next(self.now));
                second.into_iter().chain(party).min()?
            }
        };
        Some(next.saturating_sub(self.now))
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        // The close button may have been pressed in the middle of a task.
        (self.hand, self.task, self.steps) = (None, Task::Idle, None);
        self.begun = true;
        if let Some(deal) = self.wanted.take() {
            self.deal(deal);
        }
        loop {
            self.look_at_best(desk);
            desk.set_keys(match desk.machine.manner() {
                Manner::Original => KEYS,
                Manner::Today => KEYS_TODAY,
            });
            let tick = work::event(self, desk).await?;
            if let Some(steps) = &mut self.steps {
                if !steps.heed(&tick) {
                    self.steps = None;
                }
                continue;
            }
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
            if self.manner == Manner::Today {
                // A piece lies over the buttons, not under them.
                let piece = tick.click().and_then(|(x, y)| self.scene().piece_at(x, y));
                if let Some(control) = TODAY.find(&tick).filter(|_| piece.is_none() && self.hand.is_none()) {
                    self.control(desk, control).await.unless_cancelled()?;
                    continue;
                }
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
