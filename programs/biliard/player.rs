//! What the player does: aiming, shooting, watching, and the keys.

use super::game::Game;
use super::picture::{Discs, View, ball_at};
use super::rolling::{Pace, Rolling};
use super::texts;
use crate::machine::{Asked, Asking, Button, Event, Key, Language, Machine, Stop, StorageProblem, Tick};
use crate::screen::Screen;
use crate::table::{Surface, Table};
use crate::ui::{Desk, Manual, Phrase, Picture, Stay, Way, words};
use crate::work::{History, rescue};
use serde::Serialize;
use std::time::Duration;

/// The extension of saved games.
const EXTENSION: &str = "JSON";
/// The most spin of a shot, in quarters of its speed.
const MOST_SPIN: i32 = 4;
/// Where the mouse may be while it aims: the cloth, as in the original.
const CLOTH: [[i32; 2]; 2] = [[38, 601], [38, 441]];

/// A ball held by the mouse.
#[derive(Clone, Copy)]
struct Grip {
    ball: usize,
    /// Where the button went down.
    from: (i32, i32),
    /// Where the ghost is, once the mouse has moved.
    ghost: Option<(i32, i32)>,
}

/// The program's state: the game with its past is what undo restores, all else is view.
struct Player {
    games: History<Game>,
    discs: Discs,
    grip: Option<Grip>,
    rolling: Option<Rolling>,
    line: bool,
    spin: i32,
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
/// [`Stop::Closed`] when the display is being closed.
pub(crate) async fn run(machine: &mut Machine, manual: Manual) -> Asked<()> {
    let mut player = Player {
        games: History::new(Game::new()),
        discs: Discs::new(),
        grip: None,
        rolling: None,
        line: true,
        spin: 0,
    };
    let mut desk = Desk::new(machine, manual);
    desk.machine.set_file(None);
    if rescue::offer(&mut player, &mut desk, Player::take_up, Player::put_down).await? {
        player.games.mark_unsaved();
    }
    let ended = loop {
        match player.play(&mut desk).await {
            Ok(()) => break Ok(()),
            Err(Stop::Closed) if player.may_close(&mut desk).await => break Err(Stop::Closed),
            // The player stays after all.
            Err(_) => {}
        }
    };
    rescue::forget(&mut desk);
    ended
}

/// The picture of a table at rest.
impl Picture for Player {
    fn draw(&self, screen: &mut Screen, language: Language) {
        self.view(Duration::ZERO).draw(screen, language);
    }
}

impl Player {
    /// Takes up a game that an earlier session has lost.
    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        self.games = History::new(Game::read(work.as_bytes()).map_err(|why| Phrase::plain(&why))?);
        Ok(())
    }

    fn put_down(&mut self) {
        self.games = History::new(Game::new());
    }

    /// Keeps the game as long as it is unsaved; a shot in motion as it will end.
    fn keep(&mut self, desk: &mut Desk<'_>) {
        if self.games.take_touched() {
            rescue::keep(desk, || {
                let game = self.outcome();
                let unsaved = game.points.is_some() && self.games.differs(&game);
                unsaved.then(|| serde_json::to_string(&game).map_err(|error| Phrase::plain(&error)))
            });
        }
        rescue::tell_problem(desk);
    }

    /// The game when the balls have come to rest.
    fn outcome(&self) -> Game {
        match &self.rolling {
            Some(rolling) if rolling.pace == Pace::Full => rolling.outcome(self.games.now()),
            _ => self.games.now().clone(),
        }
    }

    /// Plays until the player asks for the end.
    async fn play(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        loop {
            let now = desk.machine.now();
            self.let_roll(now);
            self.keep(desk);
            desk.machine.publish(self.model());
            let view = self.view(now);
            let tick = match &self.rolling {
                Some(rolling) => desk.event_before(&view, rolling.next_moment(now)).await?,
                None => desk.event(&view).await?,
            };
            self.let_roll(tick.now);
            self.mouse(&tick);
            if let Some(key) = tick.key()
                && self.key(desk, key).await.unless_cancelled()? == Some(true)
            {
                return Ok(());
            }
        }
    }

    fn model(&self) -> Model {
        let table = self.rolling.as_ref().map_or_else(|| self.games.now().table(), |it| it.table.clone());
        Model {
            rolling: self.rolling.is_some(),
            table,
            game: self.games.now().clone(),
            unsaved: self.unsaved(),
        }
    }

    fn view(&self, now: Duration) -> View<'_> {
        let game = self.games.now();
        let aimed = self.grip.and_then(|grip| {
            let ghost = grip.ghost?;
            Some((game.shot(grip.ball, ghost, self.spin)?, ghost))
        });
        View {
            discs: &self.discs,
            game,
            table: self.rolling.as_ref().map_or_else(|| game.table(), |rolling| rolling.at(now)),
            aimed,
            line: self.line,
            spin: self.spin,
            replay: self.rolling.as_ref().is_some_and(|rolling| rolling.pace == Pace::Slow),
        }
    }

    /// Makes the steps that are due, and takes up where the balls have come to rest.
    fn let_roll(&mut self, now: Duration) {
        if self.rolling.as_mut().is_some_and(|rolling| rolling.advance(now)) {
            self.come_to_rest();
        }
    }

    fn come_to_rest(&mut self) {
        let after = self.outcome();
        if self.rolling.take().is_some_and(|rolling| rolling.pace == Pace::Full) {
            self.games.change(after);
        }
    }

    fn mouse(&mut self, tick: &Tick) {
        // The button may have gone up while the help page was read.
        let let_go = tick.event == Some(Event::Release(Button::Left));
        self.grip = self.grip.filter(|_| let_go || tick.mouse.holds(Button::Left));
        match tick.event {
            Some(Event::Press(Button::Left)) if self.rolling.is_none() => {
                let (x, y) = (tick.mouse.x, tick.mouse.y);
                let ball = ball_at(&self.games.now().balls, x, y);
                self.grip = ball.map(|ball| Grip { ball, from: (x, y), ghost: None });
            }
            Some(Event::Move(..)) => self.drag(tick.mouse.x, tick.mouse.y),
            Some(Event::Release(Button::Left)) => self.let_go(tick.now),
            Some(Event::Wheel(steps)) => self.turn_spin(steps),
            _ => {}
        }
    }

    /// Moves the ghost; it appears when the mouse has left the place of the click by more than a pixel.
    fn drag(&mut self, x: i32, y: i32) {
        let Some(grip) = &mut self.grip else { return };
        let far = (x - grip.from.0).abs() + (y - grip.from.1).abs() > 1;
        if far || grip.ghost.is_some() {
            let [columns, rows] = CLOTH;
            grip.ghost = Some((x.clamp(columns[0], columns[1]), y.clamp(rows[0], rows[1])));
        }
    }

    fn let_go(&mut self, now: Duration) {
        let Some(grip) = self.grip.take() else { return };
        let shot = grip.ghost.and_then(|ghost| self.games.now().shot(grip.ball, ghost, self.spin));
        // A ghost brought back onto the ball's centre is no shot.
        if let Some(shot) = shot.filter(|shot| shot.velocity != [0.0, 0.0]) {
            self.rolling = Rolling::start(shot, Pace::Full, now);
            self.games.touch();
            self.spin = 0;
        }
    }

    fn turn_spin(&mut self, steps: i32) {
        if self.games.now().surface == Surface::Rough {
            self.spin = self.spin.saturating_add(steps).clamp(-MOST_SPIN, MOST_SPIN);
        }
    }

    /// Carries out a key; `true` is the end.
    async fn key(&mut self, desk: &mut Desk<'_>, key: Key) -> Asked<bool> {
        match key {
            Key::Esc if self.grip.take().is_some() => {}
            Key::Esc if self.is_replay() => self.rolling = None,
            Key::Esc | Key::Char('q' | 'Q') => return self.end(desk).await,
            Key::Enter => self.come_to_rest(),
            Key::Left => self.turn_spin(-1),
            Key::Right => self.turn_spin(1),
            Key::Char('a' | 'A') => self.line = !self.line,
            Key::Char('r' | 'R') => self.replay(desk),
            Key::Char('s' | 'S') => self.change(Game::with_other_surface),
            Key::Char('p' | 'P') => self.change(Game::with_other_mode),
            Key::Char('n' | 'N') => self.new_rack(desk).await?,
            Key::Ctrl('Z') => self.undo(desk),
            Key::Ctrl('Y') => self.redo(desk),
            Key::Ctrl('S') => {
                self.save(desk).await?;
            }
            Key::Ctrl('O') => self.load(desk).await?,
            _ => {}
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

    /// A shot in motion is taken back by stopping it.
    fn undo(&mut self, desk: &mut Desk<'_>) {
        self.grip = None;
        let stopped = self.rolling.take().is_some_and(|rolling| rolling.pace == Pace::Full);
        self.games.touch();
        if !stopped && !self.games.undo() {
            desk.tell(words::NO_MORE, Stay::Briefly);
        }
    }

    fn redo(&mut self, desk: &mut Desk<'_>) {
        self.grip = None;
        self.come_to_rest();
        if !self.games.redo() {
            desk.tell(words::NO_MORE, Stay::Briefly);
        }
    }

    fn replay(&mut self, desk: &mut Desk<'_>) {
        self.grip = None;
        self.come_to_rest();
        match self.games.now().last.clone() {
            Some(shot) => self.rolling = Rolling::start(shot, Pace::Slow, desk.machine.now()),
            None => desk.tell(texts::NO_SHOT, Stay::Briefly),
        }
    }

    /// Balls must rest before a question is asked: the clock goes on while it stands.
    fn settle(&mut self, desk: &Desk<'_>) -> View<'_> {
        self.grip = None;
        self.come_to_rest();
        self.view(desk.machine.now())
    }

    async fn new_rack(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let view = self.settle(desk);
        if desk.yes(&view, texts::ASK_NEW).await? {
            self.change(Game::racked);
        }
        Ok(())
    }

    /// Asks whether this is the end; a game for points is offered to be saved first.
    async fn end(&mut self, desk: &mut Desk<'_>) -> Asked<bool> {
        let view = self.settle(desk);
        if !desk.yes(&view, words::ASK_END).await? {
            return Ok(false);
        }
        if self.unsaved() {
            self.offer_to_save(desk).await?;
        }
        Ok(true)
    }

    /// Whether a game for points would be lost.
    fn unsaved(&self) -> bool {
        self.games.now().points.is_some() && self.games.unsaved()
    }

    /// Asks whether to save until it is answered and done; Esc: nothing shall be left.
    async fn offer_to_save(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        loop {
            let view = self.settle(desk);
            if !desk.yes(&view, texts::ASK_SAVE).await? {
                return Ok(());
            }
            // Esc in the questions for the name leads back to this one.
            if self.save(desk).await.unless_cancelled()? == Some(true) {
                return Ok(());
            }
        }
    }

    /// Whether the display may close; the close button pressed again leaves the question standing.
    async fn may_close(&mut self, desk: &mut Desk<'_>) -> bool {
        self.come_to_rest();
        while self.unsaved() {
            match self.offer_to_save(desk).await {
                Ok(()) => return true,
                Err(Stop::Cancelled) => return false,
                Err(Stop::Closed) => {}
            }
        }
        true
    }

    /// Asks for a name and saves; whether it was done.
    async fn save(&mut self, desk: &mut Desk<'_>) -> Asked<bool> {
        let view = self.settle(desk);
        let name = desk.file_name(&view, EXTENSION, Way::Save).await?;
        if !desk.may_write(&view, &[&name]).await? {
            return Ok(false);
        }
        match store(self.games.now(), desk, &name) {
            Ok(()) => {
                desk.machine.set_file(Some(name));
                self.games.mark_saved();
                desk.tell(texts::SAVED, Stay::Briefly);
                Ok(true)
            }
            Err(problem) => {
                desk.tell(problem, Stay::UntilRead);
                Ok(false)
            }
        }
    }

    /// Asks for a name and takes the game up; undo leads back to the one before.
    async fn load(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let view = self.settle(desk);
        let name = desk.file_name(&view, EXTENSION, Way::Load).await?;
        match read(desk, &name) {
            Ok(game) => {
                desk.machine.set_file(Some(name));
                self.games.change(game);
                self.games.mark_saved();
            }
            Err(problem) => desk.tell(problem, Stay::UntilRead),
        }
        Ok(())
    }
}

fn store(game: &Game, desk: &mut Desk<'_>, name: &str) -> Result<(), Phrase> {
    let mut content =
        serde_json::to_vec_pretty(game).map_err(|error| texts::no_game(name, &error.to_string()))?;
    content.push(b'\n');
    desk.machine.storage().write(name, &content).map_err(|error| Phrase::plain(&error))
}

fn read(desk: &mut Desk<'_>, name: &str) -> Result<Game, Phrase> {
    let content = desk.machine.storage().read(name).map_err(|error| match error.problem {
        StorageProblem::NotFound => words::NO_SUCH_FILE.into(),
        _ => Phrase::plain(&error),
    })?;
    Game::read(&content).map_err(|why| texts::no_game(name, &why))
}
