//! The player's moves and questions, and what runs by itself.

mod page;
mod score;

use super::super::puzzles::{self, CONTROLS, Control, Help, MOST, Party, controls};
use super::game::{Game, Problem};
use super::hand::Hand;
use super::picture::{Style, move_at};
use super::show::{Aim, Demonstration, Playing, Seeking, Show};
use super::texts;
use crate::editor::keys;
use crate::file::{BeadWheel, Document, Format};
use crate::machine::{Asked, Asking, Best, Button as MouseButton, Event, Key, Machine, Manner, Stop, Tick};
use crate::puzzle::wheel::{Difficulty, Move, Tables, Wheel};
use crate::screen::Palette;
use crate::ui::{
    Answer, Area, Button, Caption, Choices, Command, Commands, Desk, Field, Form, KeyHelp, MIDDLE, Manual,
    Number, Phrase, Question, Stay, Stopwatch,
};
use crate::work::{self, History, Next, Work};
use serde::Serialize;
use std::time::Duration;

/// What a command does.
#[derive(Clone, Copy)]
pub(super) enum Action {
    Restart,
    NewProblem,
    Seek(Aim),
    Demonstrate,
    Quit,
}

/// The commands, with the buttons of the original; moves have the other letters.
pub(super) const COMMANDS: Commands<Action> = Commands(&[
    Command::told(texts::PUSH),
    Command::told(texts::TURN),
    Command::told(texts::CLICK),
    Command::told(texts::UNDO),
    Command::key(Key::Char('R'), texts::RESTART, Action::Restart),
    Command::key(Key::Char('U'), texts::NEW_PROBLEM, Action::NewProblem),
    Command::key(Key::Char('H'), texts::HINT, Action::Seek(Aim::Hint)),
    Command::key(Key::Char('S'), texts::SOLVE, Action::Seek(Aim::Solve)),
    Command::button(Button::new(400, 21, texts::DEMONSTRATION), texts::DEMONSTRATE, Action::Demonstrate),
    Command::told(texts::SAVE),
    Command::button(Button::new(400, 38, texts::QUIT), keys::QUIT, Action::Quit),
    Command::told(texts::STOP),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

const ROWS: [Command<Control>; CONTROLS] = controls((402, 172), 2);
/// The buttons in the manner of today, which are those of the other puzzle too.
pub(super) const TODAY: Commands<Control> = Commands(&ROWS);

/// The help page in the manner of today.
const KEYS_TODAY: &[KeyHelp] = &{
    const OWN: usize = 3;
    const SHARED: usize = TODAY.lines();
    const COMMON: [KeyHelp; SHARED] = TODAY.help();
    let mut keys = [texts::PUSH; OWN + SHARED + 3];
    keys[1] = texts::TURN;
    keys[2] = texts::DRAG;
    let mut row = 0;
    while row < SHARED {
        keys[OWN + row] = COMMON[row];
        row += 1;
    }
    keys[OWN + SHARED] = texts::DEMONSTRATE;
    keys[OWN + SHARED + 1] = texts::SAVE;
    keys[OWN + SHARED + 2] = keys::QUIT;
    keys
};

/// The program's state: the game with its past is what undo restores, all else is view.
struct Player {
    games: History<Game>,
    /// Whether there is a game, not only questions.
    begun: bool,
    /// Whether the buttons have come up.
    buttons: bool,
    clock: Stopwatch,
    /// The time of the picture.
    now: Duration,
    hint: Option<Move>,
    show: Show,
    /// What searches have found out about the wheel.
    tables: Tables,
    /// The number of the next problem that is made without being asked for.
    number: u64,
    style: Style,
    /// What the mouse holds.
    hand: Option<Hand>,
    /// How much has been helped since the last move.
    help: Help,
    /// A move that was refused last.
    refused: Option<Move>,
    party: Option<Party>,
    /// The name of the game that results are kept under, and the best one.
    best: (String, Option<Best>),
    /// A solution from the start of a game: where that is, its length, and whether it is proven to be shortest.
    found: Option<(Wheel, usize, bool)>,
}

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    game: Game,
    /// The wheel that is shown.
    shown: Wheel,
    solved: bool,
    /// The letter of the hinted move.
    hint: Option<char>,
    /// `none`, `search`, `solution` or `demonstration`.
    show: &'static str,
    seconds: u64,
    unsaved: bool,
}

/// Plays until the end.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(crate) async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Asked<()> {
    let player = Player {
        games: History::new(Game::from(Wheel::solved())),
        begun: false,
        buttons: false,
        clock: Stopwatch::default(),
        now: Duration::ZERO,
        hint: None,
        show: Show::Nothing,
        tables: Tables::default(),
        number: machine.seed(),
        style: Style { manner: machine.manner(), signs: false },
        hand: None,
        help: Help::None,
        refused: None,
        party: None,
        best: (String::new(), None),
        found: None,
    };
    let mut desk = Desk::new(machine, manual);
    work::run(player, &mut desk, document).await
}

impl Work for Player {
    type Value = Game;

    fn format(&self) -> Format {
        Format::Gyk
    }

    fn history(&mut self) -> &mut History<Game> {
        &mut self.games
    }

    fn reset(&mut self) {
        self.stop();
        self.begun = false;
        self.games = History::new(Game::from(Wheel::solved()));
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        self.begin(Game::of(document)?);
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        Ok(Document::BeadWheel(BeadWheel::from(&self.games.now().wheel)))
    }

    fn unsaved_work(&self) -> Result<String, Phrase> {
        self.games.now().to_work()
    }

    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        let buttons = self.buttons;
        self.begin(Game::from_work(work)?);
        // They come up when the work goes on.
        self.buttons = buttons;
        Ok(())
    }

    fn model(&self) -> impl Serialize + 'static {
        let game = self.games.now().clone();
        Model {
            shown: self.shown(),
            solved: game.wheel.is_solved(),
            hint: self.hint.map(Move::letter),
            show: match self.show {
                Show::Nothing => "none",
                Show::Seeking(_) => "search",
                Show::Playing(_) => "solution",
                Show::Demonstration(_) => "demonstration",
            },
            seconds: self.clock.time(self.now).as_secs(),
            unsaved: self.games.unsaved(),
            game,
        }
    }

    async fn ask_first(&mut self, desk: &mut Desk<'_>) -> Asked<bool> {
        while desk.machine.manner() == Manner::Today {
            let asked =
                puzzles::ask_preset(desk, &*self, texts::ASK_START, &texts::START, Some(Difficulty::Four));
            let game = match asked.await.unless_cancelled()? {
                Some(Some(difficulty)) => Game::new(Problem { difficulty, number: self.next_number() }),
                Some(None) => match work::load(self, desk, Stay::Briefly).await.unless_cancelled()? {
                    Some(true) => return Ok(true),
                    _ => continue,
                },
                None if desk.machine.return_to_host() => return Err(Stop::Closed),
                None => Game::from(Wheel::solved()),
            };
            self.begin(game);
            return Ok(true);
        }
        let question = Question::new(MIDDLE, texts::ASK_GAME, [texts::PLAY, texts::LEARN]);
        let learn = desk.ask(&*self, &question).await.unless_cancelled()? == Some(Answer::Second);
        if learn {
            self.begin(Game::from(Wheel::solved()));
        }
        Ok(learn)
    }

    fn look(&mut self, desk: &Desk<'_>) {
        self.now = desk.clock();
        let signs = desk.machine.preferences().palette == Palette::ColorBlind;
        self.style = Style { manner: desk.machine.manner(), signs };
        if self.party.is_some_and(|party| party.next(self.now).is_none()) {
            self.party = None;
        }
    }

    fn due(&self) -> Option<Duration> {
        let going_on = match &self.show {
            Show::Seeking(seeking) => Some(seeking.due),
            Show::Playing(playing) => Some(playing.due),
            Show::Demonstration(demonstration) => Some(demonstration.due),
            Show::Nothing => None,
        };
        let party = self.party.and_then(|party| party.next(self.now));
        let next = going_on.into_iter().chain(self.clock.next_second(self.now)).chain(party).min()?;
        Some(next.saturating_sub(self.now))
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        if !self.begun {
            let problem = Problem { difficulty: Difficulty::Book, number: self.next_number() };
            self.begin(Game::new(problem));
        }
        self.buttons = true;
        self.hand = None;
        loop {
            self.look_at_best(desk);
            desk.set_keys(match desk.machine.manner() {
                Manner::Original => KEYS,
                Manner::Today => KEYS_TODAY,
            });
            let tick = work::event(self, desk).await?;
            let before = self.games.now().clone();
            let next = self.react(desk, &tick).await.unless_cancelled()?.flatten();
            let now = self.games.now();
            if now.wheel.is_solved() && now.moves > before.moves && !before.wheel.is_solved() {
                self.celebrate(desk);
            }
            if let Some(next) = next {
                return Ok(next);
            }
        }
    }
}

impl Player {
    /// Takes up a game that needs no saving.
    fn begin(&mut self, game: Game) {
        self.stop();
        self.games = History::new(game);
        self.clock = Stopwatch::default();
        (self.begun, self.buttons) = (true, true);
    }

    fn next_number(&mut self) -> u64 {
        let number = self.number;
        self.number = self.number.wrapping_add(1);
        match self.style.manner {
            Manner::Original => number,
            // A number that can be typed.
            Manner::Today => number % (MOST as u64 + 1),
        }
    }

    /// The wheel that is to be seen.
    fn shown(&self) -> Wheel {
        if let Some(hand) = &self.hand {
            return hand.wheel;
        }
        match &self.show {
            Show::Demonstration(demonstration) => demonstration.wheel,
            _ => self.games.now().wheel,
        }
    }

    /// Ends what runs by itself; a search leaves its tables for the next one.
    fn stop(&mut self) {
        (self.hint, self.refused, self.party) = (None, None, None);
        if let Show::Seeking(seeking) = std::mem::replace(&mut self.show, Show::Nothing) {
            self.tables = seeking.solver.into_tables();
        }
    }

    /// Handles an event or the passing of time; `Some` leaves the game.
    async fn react(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> Asked<Option<Next>> {
        let today = self.style.manner == Manner::Today;
        if self.hand.is_some() {
            self.drag(tick);
            return Ok(None);
        }
        let pressed = matches!(tick.event, Some(Event::Key(_) | Event::Press(_)));
        if pressed && !matches!(self.show, Show::Nothing) {
            let was_demonstration = matches!(self.show, Show::Demonstration(_));
            self.stop();
            // A key that takes over from a solution also makes its move; a demonstration only ends.
            if was_demonstration || tick.pressed(Key::Esc) {
                return Ok(None);
            }
        }
        if tick.event.is_none() {
            self.go_on(desk);
        }
        if let Some(control) = TODAY.find(tick).filter(|_| today) {
            self.control(desk, control).await?;
            return Ok(None);
        }
        let wheel = self.games.now().wheel;
        let held = tick.click().filter(|_| today).and_then(|at| Hand::new(wheel, at));
        if held.is_some() {
            (self.refused, self.party) = (None, None);
            self.hand = held;
            return Ok(None);
        }
        let clicked = tick.click().and_then(|(x, y)| move_at(&wheel, x, y));
        if let Some(action) = COMMANDS.find(tick) {
            return self.obey(desk, action).await;
        }
        if let Some(a_move) = tick.letter().and_then(Move::from_letter).or(clicked) {
            self.make(a_move);
        }
        if let Some(key @ (Key::Esc | Key::Ctrl('Z' | 'Y' | 'S'))) = tick.key() {
            self.step(desk, key).await?;
        }
        Ok(None)
    }

    /// Goes on with what goes on by itself.
    fn go_on(&mut self, desk: &mut Desk<'_>) {
        let now = self.now;
        match &mut self.show {
            Show::Nothing => {}
            Show::Demonstration(demonstration) => {
                if demonstration.advance(now) {
                    self.stop();
                }
            }
            Show::Playing(playing) => {
                let (next, over) = (playing.next(now), playing.is_over());
                if let Some(next) = next {
                    self.help = Help::Solution;
                    self.change(next);
                }
                if over {
                    self.stop();
                }
            }
            Show::Seeking(seeking) => {
                if seeking.advance(now) {
                    let (aim, solution) = (seeking.aim, seeking.solver.solution());
                    self.stop();
                    // A search ends with a solution.
                    let Some(solution) = solution else { return };
                    let game = self.games.now();
                    if game.wheel == game.start {
                        self.found = Some((game.start, solution.moves.len(), solution.proven));
                    }
                    match aim {
                        Aim::Hint => {
                            self.hint = solution.moves.first().copied();
                            self.help = self.help.max(Help::Hints);
                        }
                        Aim::Solve => {
                            self.show =
                                Show::Playing(Playing::new(&solution.moves, solution.proven, desk.clock()));
                        }
                    }
                }
            }
        }
    }

    /// Makes a move of the player.
    fn make(&mut self, a_move: Move) {
        self.stop();
        self.change(a_move);
    }

    fn change(&mut self, a_move: Move) {
        self.change_by(&[a_move]);
    }

    /// Makes moves that undo takes back together.
    fn change_by(&mut self, moves: &[Move]) {
        let mut game = self.games.now().clone();
        for &a_move in moves {
            match game.after(a_move) {
                Some(after) => game = after,
                None => self.refused = Some(a_move),
            }
        }
        if game.moves > self.games.now().moves {
            game.help = game.help.max(std::mem::take(&mut self.help));
            self.games.change(game);
            self.clock.note(self.games.now().wheel.is_solved(), self.now);
        }
    }

    /// Goes on with what the mouse holds; a key puts it back.
    fn drag(&mut self, tick: &Tick) {
        let Some(mut hand) = self.hand.take() else { return };
        match tick.event {
            Some(Event::Key(_)) => {}
            Some(Event::Release(MouseButton::Left)) => {
                hand.follow((tick.mouse.x, tick.mouse.y));
                self.stop();
                self.change_by(&hand.moves());
            }
            // The button went up while help was read.
            _ if !tick.mouse.holds(MouseButton::Left) => {}
            _ => {
                hand.follow((tick.mouse.x, tick.mouse.y));
                self.hand = Some(hand);
            }
        }
    }

    /// Carries out what both puzzles can do.
    async fn control(&mut self, desk: &mut Desk<'_>, control: Control) -> Asked<()> {
        match control {
            Control::New => {
                let before = self.games.now().problem;
                let difficulty = before.map_or(Difficulty::Four, |problem| problem.difficulty);
                let number = self.next_number();
                self.replace(Game::new(Problem { difficulty, number }));
            }
            Control::Choose => {
                self.stop();
                let now = self.games.now().problem.map_or(Difficulty::Four, |problem| problem.difficulty);
                let title = texts::ASK_START;
                let asked = puzzles::ask_preset(desk, &*self, title, &texts::DIFFICULTIES, now);
                let difficulty = asked.await?;
                let proposal = self.next_number();
                let number = puzzles::ask_number(desk, &*self, proposal).await?;
                self.replace(Game::new(Problem { difficulty, number }));
            }
            Control::Hint => self.seek(desk, Aim::Hint),
            Control::Solve => self.seek(desk, Aim::Solve),
            Control::Undo => self.step(desk, Key::Ctrl('Z')).await?,
            Control::Redo => self.step(desk, Key::Ctrl('Y')).await?,
            Control::Restart => self.replace(self.games.now().restarted()),
            Control::Help => desk.help().await?,
        }
        Ok(())
    }

    /// A key that every editor shares.
    async fn step(&mut self, desk: &mut Desk<'_>, key: Key) -> Asked<()> {
        self.stop();
        let before = self.games.now().wheel;
        work::common_key(self, desk, Some(key)).await?;
        let wheel = self.games.now().wheel;
        if wheel != before {
            self.clock.note(wheel.is_solved(), desk.clock());
        }
        Ok(())
    }

    /// Takes up another game that undo leads back from.
    fn replace(&mut self, game: Game) {
        self.stop();
        self.games.change(game);
        self.clock = Stopwatch::default();
        self.help = Help::None;
    }

    /// Carries out a command; `Some` leaves the game.
    async fn obey(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<Option<Next>> {
        match action {
            Action::Quit => {
                self.stop();
                let next = work::quit(self, desk).await?;
                return Ok(Some(next).filter(|&next| next != Next::Work));
            }
            Action::Demonstrate => {
                self.stop();
                let number = self.next_number();
                self.show = Show::Demonstration(Demonstration::new(number, self.now));
            }
            Action::Restart => self.replace(self.games.now().restarted()),
            Action::NewProblem => self.new_problem(desk).await?,
            Action::Seek(aim) => self.seek(desk, aim),
        }
        Ok(None)
    }

    fn seek(&mut self, desk: &mut Desk<'_>, aim: Aim) {
        self.stop();
        let wheel = self.games.now().wheel;
        if wheel.is_solved() {
            desk.tell(texts::IS_SOLVED, Stay::Briefly);
        } else {
            self.show = Show::Seeking(Seeking::new(aim, wheel, std::mem::take(&mut self.tables), self.now));
        }
    }

    /// Asks for difficulty and number of a problem, and starts it.
    async fn new_problem(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        self.stop();
        let difficulty = desk.choose(&*self, &difficulties()).await?;
        let field = Field {
            area: Area::new(300, 8, 380, 22),
            at: (308, 12),
            longest: 6,
            kind: Number::Whole(0..=MOST),
        };
        let form = Form::new(vec![Caption::new((216, 12), texts::NUMBER)], [field]);
        let [number] = desk.numbers(&*self, &form).await?;
        // The number is an integer between 0 and the largest one.
        self.replace(Game::new(Problem { difficulty, number: number as u64 }));
        Ok(())
    }
}

/// The question for the difficulty.
fn difficulties() -> Choices<Difficulty> {
    let (x, y) = MIDDLE;
    let mut left = x + 5;
    let mut window = |width: i32| {
        let area = Area::new(left, y + 21, left + width, y + 34);
        left += width + 5;
        area
    };
    let windows = [18, 18, 27, 58, 82].map(&mut window).into_iter();
    Choices {
        place: MIDDLE,
        captions: vec![Caption::new((x + 7, y + 8), texts::ASK_DIFFICULTY)],
        answers: windows.zip(texts::DIFFICULTIES).map(|(area, (text, it))| (area, text, it)).collect(),
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
