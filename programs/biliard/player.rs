//! What the player does: aiming, shooting, watching, and the keys.

use super::picture::{Discs, View, ball_at};
use super::rolling::{Pace, Rolling};
use super::texts;
use crate::file::{Document, Format};
use crate::machine::{Asked, Asking, Button, Event, Key, Language, Machine, Manner, Preference, Tick};
use crate::screen::Screen;
use crate::table::Game;
use crate::table::{Surface, Table};
use crate::ui::{Command, Commands, Desk, Hint, KeyHelp, Manual, Phrase, Picture, Stay, Words, words};
use crate::work::{self, History, Next, Work};
use serde::Serialize;
use std::time::Duration;

/// The most spin of a shot, in quarters of its speed.
const MOST_SPIN: i32 = 4;
/// The area of the mouse while aiming: the cloth, as in the original.
const CLOTH: [[i32; 2]; 2] = [[38, 601], [38, 441]];

/// What a command does.
#[derive(Clone, Copy)]
enum Action {
    Do(fn(&mut Player, &mut Desk<'_>)),
    Back,
    NewRack,
    Save,
    Load,
    End,
}

const COMMANDS: Commands<Action> = Commands(&[
    Command::told(texts::SHOOT),
    Command::key(Key::Esc, texts::BACK, Action::Back),
    Command::key(Key::Enter, texts::SKIP, Action::Do(|player, _| player.come_to_rest())),
    Command::key(Key::Char('A'), texts::LINE, Action::Do(|player, _| player.line = !player.line)),
    Command::key(
        Key::Char('T'),
        texts::CLOTH,
        Action::Do(|_, desk| desk.prefer(|it| it.turn(Preference::Cloth, true))),
    ),
    Command::key(Key::Char('R'), texts::SLOWLY, Action::Do(Player::replay)),
    Command::key(
        Key::Char('S'),
        texts::ROUGH,
        Action::Do(|player, _| player.change(Game::with_other_surface)),
    ),
    Command::key(Key::Left, texts::SPIN, Action::Do(|player, _| player.turn_spin(-1))),
    Command::also(Key::Right, Action::Do(|player, _| player.turn_spin(1))),
    Command::key(Key::Char('P'), texts::POINTS, Action::Do(|player, _| player.change(Game::with_other_mode))),
    Command::key(Key::Char('N'), texts::RACK, Action::NewRack),
    Command::key(Key::Ctrl('S'), texts::FILES, Action::Save),
    Command::also(Key::Ctrl('O'), Action::Load),
    Command::key(Key::Ctrl('Z'), texts::UNDO, Action::Do(Player::undo)),
    Command::also(Key::Ctrl('Y'), Action::Do(Player::redo)),
    Command::key(Key::Char('Q'), texts::END, Action::End),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

/// A ball held by the mouse.
#[derive(Clone, Copy)]
struct Grip {
    ball: usize,
    /// Where the button went down.
    from: (i32, i32),
    /// The place of the ghost, once the mouse has moved.
    ghost: Option<(i32, i32)>,
}

/// The program's state. Undo restores the game only; all else is view.
struct Player {
    games: History<Game>,
    discs: Discs,
    grip: Option<Grip>,
    rolling: Option<Rolling>,
    line: bool,
    spin: i32,
    /// Time on the machine's clock; balls continue to roll while help is read.
    now: Duration,
    manner: Manner,
}

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    /// Whether balls are in motion.
    rolling: bool,
    table: Table,
    game: Game,
    unsaved: bool,
}

/// Plays until the end.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(crate) async fn run(machine: &mut Machine, manual: Manual, game: Option<Box<Game>>) -> Asked<()> {
    let player = Player {
        games: History::new(Game::new()),
        discs: Discs::new(machine.preferences().cloth),
        grip: None,
        rolling: None,
        line: true,
        spin: 0,
        now: Duration::ZERO,
        manner: machine.manner(),
    };
    work::run(player, &mut Desk::new(machine, manual), game.map(Document::Billiards)).await
}

impl Picture for Player {
    fn draw(&self, screen: &mut Screen, language: Language) {
        self.view().draw(screen, language);
    }

    fn hint(&self) -> Option<Hint> {
        let won = self.games.now().points.is_some_and(|points| points.winner().is_some());
        let (mouse, keys) = match &self.rolling {
            Some(rolling) if rolling.pace == Pace::Slow => (texts::HINT_REPLAY, texts::HINT_REPLAY),
            Some(_) => (texts::HINT_ROLL, texts::HINT_ROLL),
            None if self.grip.is_some() => (texts::HINT_AIM, texts::KEYS_AIM),
            None if won => (texts::HINT_WON, texts::HINT_WON),
            None => (texts::HINT_SHOOT, texts::KEYS_SHOOT),
        };
        // Beside the speed, while there is one.
        let letters = if self.grip.is_some() { 40 } else { 70 };
        Some(Hint::at((40, 455), letters, mouse).by_keys(keys))
    }
}

impl Work for Player {
    type Value = Game;

    const ASK_SAVE: Words = texts::ASK_SAVE;
    const SAVED: Option<Words> = Some(texts::SAVED);

    fn format(&self) -> Format {
        Format::Bil
    }

    fn history(&mut self) -> &mut History<Game> {
        &mut self.games
    }

    /// Only a game for points is worth a question; a shot in motion counts as it will end.
    fn unsaved(&mut self) -> bool {
        self.games.now().points.is_some() && self.games.differs(&self.outcome())
    }

    fn reset(&mut self) {
        self.games = History::new(Game::new());
    }

    /// Undo leads back to the game before.
    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let Document::Billiards(game) = document else { return Err(texts::NO_DOCUMENT.into()) };
        self.games.change(Game::clone(game));
        Ok(())
    }

    /// A shot in motion counts as it will end.
    fn document(&self) -> Result<Document, Phrase> {
        Ok(Document::Billiards(Box::new(self.outcome())))
    }

    fn model(&self) -> impl Serialize + 'static {
        let game = self.games.now().clone();
        Model {
            rolling: self.rolling.is_some(),
            table: self.rolling.as_ref().map_or_else(|| game.table(), |it| it.table.clone()),
            unsaved: game.points.is_some() && self.games.unsaved(),
            game,
        }
    }

    /// Brings the balls to rest, because the clock runs during questions.
    fn settle(&mut self) {
        self.grip = None;
        self.come_to_rest();
    }

    async fn ask_first(&mut self, _: &mut Desk<'_>) -> Asked<bool> {
        Ok(true)
    }

    /// Makes the steps that are due, and commits the game when the balls have come to rest.
    fn look(&mut self, desk: &Desk<'_>) {
        self.now = desk.machine.now();
        self.manner = desk.machine.manner();
        self.discs.cover(desk.machine.preferences().cloth);
        if self.rolling.as_mut().is_some_and(|rolling| rolling.advance(self.now)) {
            self.come_to_rest();
        }
    }

    fn due(&self) -> Option<Duration> {
        Some(self.rolling.as_ref()?.next_moment(self.now).saturating_sub(self.now))
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        loop {
            let tick = work::event(self, desk).await?;
            self.mouse(&tick);
            if let Some(action) = COMMANDS.find(&tick)
                && self.obey(desk, action).await.unless_cancelled()? == Some(true)
            {
                return Ok(Next::End);
            }
        }
    }
}

impl Player {
    /// The game when the balls have come to rest.
    fn outcome(&self) -> Game {
        match &self.rolling {
            Some(rolling) if rolling.pace == Pace::Full => rolling.outcome(self.games.now()),
            _ => self.games.now().clone(),
        }
    }

    fn view(&self) -> View<'_> {
        let game = self.games.now();
        let aimed = self.grip.and_then(|grip| {
            let ghost = grip.ghost?;
            Some((game.shot(grip.ball, ghost, self.spin)?, ghost))
        });
        View {
            discs: &self.discs,
            game,
            table: self.rolling.as_ref().map_or_else(|| game.table(), |rolling| rolling.at(self.now)),
            aimed,
            line: self.line,
            spin: self.spin,
            replay: self.is_replay() && self.manner == Manner::Original,
            cue: self.manner == Manner::Today,
        }
    }

    fn come_to_rest(&mut self) {
        let after = self.outcome();
        if self.rolling.take().is_some_and(|rolling| rolling.pace == Pace::Full) {
            self.games.change(after);
        }
    }

    fn mouse(&mut self, tick: &Tick) {
        // The button may have been released on the help page.
        let let_go = tick.event == Some(Event::Release(Button::Left));
        self.grip = self.grip.filter(|_| let_go || tick.mouse.holds(Button::Left));
        match tick.event {
            // Nothing can be shot while balls roll.
            Some(Event::Press(Button::Left)) if self.rolling.is_some() && self.manner == Manner::Today => {
                self.come_to_rest();
            }
            Some(Event::Press(Button::Left)) if self.rolling.is_none() => {
                let (x, y) = (tick.mouse.x, tick.mouse.y);
                let ball = ball_at(&self.games.now().balls, x, y);
                self.grip = ball.map(|ball| Grip { ball, from: (x, y), ghost: None });
            }
            Some(Event::Move(..)) => self.drag(tick.mouse.x, tick.mouse.y),
            Some(Event::Release(Button::Left)) => self.let_go(),
            Some(Event::Wheel(steps)) => self.turn_spin(steps),
            _ => {}
        }
    }

    /// Moves the ghost. It appears when the mouse is more than a pixel away from the click.
    fn drag(&mut self, x: i32, y: i32) {
        let Some(grip) = &mut self.grip else { return };
        let far = (x - grip.from.0).abs() + (y - grip.from.1).abs() > 1;
        if far || grip.ghost.is_some() {
            let [columns, rows] = CLOTH;
            grip.ghost = Some((x.clamp(columns[0], columns[1]), y.clamp(rows[0], rows[1])));
        }
    }

    fn let_go(&mut self) {
        let Some(grip) = self.grip.take() else { return };
        let shot = grip.ghost.and_then(|ghost| self.games.now().shot(grip.ball, ghost, self.spin));
        // A ghost on the ball's centre is not a shot.
        if let Some(shot) = shot.filter(|shot| shot.velocity != [0.0, 0.0]) {
            self.rolling = Rolling::start(shot, Pace::Full, self.now);
            self.games.touch();
            self.spin = 0;
        }
    }

    fn turn_spin(&mut self, steps: i32) {
        if self.games.now().surface == Surface::Rough {
            self.spin = self.spin.saturating_add(steps).clamp(-MOST_SPIN, MOST_SPIN);
        }
    }

    /// Carries out a command; `true` is the end.
    async fn obey(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<bool> {
        match action {
            Action::Back if self.grip.take().is_some() => {}
            Action::Back if self.is_replay() => self.rolling = None,
            Action::Back | Action::End => return self.end(desk).await,
            Action::Do(what) => what(self, desk),
            Action::NewRack => self.new_rack(desk).await?,
            Action::Save => return work::save(self, desk).await.map(|_| false),
            Action::Load => return work::load(self, desk, Stay::UntilRead).await.map(|_| false),
        }
        Ok(false)
    }

    fn is_replay(&self) -> bool {
        self.rolling.as_ref().is_some_and(|rolling| rolling.pace == Pace::Slow)
    }

    /// Changes the game; balls in motion come to rest before.
    fn change(&mut self, change: fn(&Game) -> Game) {
        self.come_to_rest();
        self.grip = None;
        self.spin = 0;
        self.games.change(change(self.games.now()));
    }

    /// A shot in motion is undone by stopping it.
    fn undo(&mut self, desk: &mut Desk<'_>) {
        self.grip = None;
        let stopped = self.rolling.take().is_some_and(|rolling| rolling.pace == Pace::Full);
        self.games.touch();
        if !stopped && !self.games.undo() {
            desk.tell(words::NO_UNDO, Stay::Briefly);
        }
    }

    fn redo(&mut self, desk: &mut Desk<'_>) {
        self.grip = None;
        self.come_to_rest();
        if !self.games.redo() {
            desk.tell(words::NO_REDO, Stay::Briefly);
        }
    }

    fn replay(&mut self, desk: &mut Desk<'_>) {
        self.grip = None;
        self.come_to_rest();
        match self.games.now().last.clone() {
            Some(shot) => self.rolling = Rolling::start(shot, Pace::Slow, self.now),
            None => desk.tell(texts::NO_SHOT, Stay::Briefly),
        }
    }

    async fn new_rack(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        self.settle();
        if desk.yes(&*self, texts::ASK_NEW).await? {
            self.change(Game::racked);
        }
        Ok(())
    }

    /// Asks whether to end; before that, offers to save a game for points.
    async fn end(&mut self, desk: &mut Desk<'_>) -> Asked<bool> {
        self.settle();
        if !desk.yes(&*self, words::ASK_END).await? {
            return Ok(false);
        }
        if self.unsaved() {
            work::offer_to_save(self, desk).await?;
        }
        Ok(true)
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
