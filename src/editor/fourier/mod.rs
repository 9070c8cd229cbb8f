//! The editor of plane curves by Fourier coefficients: four columns of windows beside the curve
//! x(t) = a0 + Σ a_k sin(kt + π p_k), y likewise with b and q (chapter 2.2, equation 2.8). Changes are seen at
//! once; the coefficients can be fitted to the control points of a stored plane curve.

mod fitting;
mod layout;
mod picture;

use super::keys::{QUIT, SAVE, UNDO};
use crate::design::fourier::{Coefficient, Column};
use crate::file::{Document, Format, Fourier};
use crate::machine::{Asked, Asking, Event, Key, Machine, Manner, Request, Stop, Tick};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Phrase};
use crate::ui::{
    Accepts, Area, Button, Command, Commands, Desk, Entry, KeyHelp, Manual, Number, Over, Start, Stay, TOP,
    Typed, Words, page, window,
};
use crate::work::{self, History, Next, Work, common_key, event, quit};
use fitting::Target;
use serde::Serialize;

/// What the screen shows.
#[derive(Clone, Debug, PartialEq)]
enum Stage {
    /// Before there is a configuration; shows the previous one, if any.
    Starting(Option<Box<Fourier>>),
    /// Editing.
    Working,
}

/// The editor's whole state.
struct Editor {
    history: History<Fourier>,
    stage: Stage,
    /// The coefficient that the keys change: the last one used.
    chosen: Coefficient,
    /// The coefficient that is shown with all its digits.
    marked: Option<Coefficient>,
    /// The number being typed for the chosen coefficient.
    typing: Option<Entry>,
    /// The coefficient that was last changed by steps; further steps join that change.
    stepping: Option<Coefficient>,
    target: Option<Target>,
}

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    #[serde(flatten)]
    coefficients: Fourier,
    target: Option<String>,
    rms: Option<f64>,
    largest: Option<f64>,
    unsaved: bool,
}

/// What a command does.
#[derive(Clone, Copy)]
enum Action {
    Change,
    Step(i32),
    Choose(fn(Coefficient) -> Coefficient),
    Type,
    Fit,
    Quit,
    Back,
}

const COMMANDS: Commands<Action> = Commands(&[
    Command::told((Words("egér", "mouse"), words::HELP_WINDOW)),
    Command::button(
        Button::new(550, 21, words::CHANGE),
        (Words("V", "V"), words::HELP_COEFFICIENT),
        Action::Change,
    ),
    Command::key(Key::Up, (Words("görgő Fel Le", "wheel Up Down"), words::HELP_STEP), Action::Step(1)),
    Command::also(Key::Down, Action::Step(-1)),
    Command::key(Key::PageUp, (Words("PgUp PgDn", "PgUp PgDn"), words::HELP_TEN_STEPS), Action::Step(10)),
    Command::also(Key::PageDown, Action::Step(-10)),
    Command::key(
        Key::Tab,
        (Words("Bal Jobb Tab", "Left Right Tab"), words::HELP_OTHER_WINDOW),
        Action::Choose(Coefficient::below),
    ),
    Command::also(Key::Right, Action::Choose(|place| place.beside(1))),
    Command::also(Key::Left, Action::Choose(|place| place.beside(3))),
    Command::key(Key::Enter, (Words("Enter", "Enter"), words::HELP_TYPE), Action::Type),
    Command::key(Key::F(5), (Words("F5", "F5"), words::HELP_FIT), Action::Fit),
    Command::button(Button::new(550, 38, words::QUIT), QUIT, Action::Quit),
    Command::told(SAVE),
    Command::told(UNDO),
    Command::also(Key::Esc, Action::Back),
]);

/// The help page; a program adds no keys.
pub const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

/// Prepares the editor, with or without a document to open.
///
/// # Errors
/// The reason why it cannot open the document.
pub fn start(manual: Manual, document: Option<Document>) -> Result<Start, Phrase> {
    document.as_ref().map_or(Ok(()), check)?;
    Ok(Box::new(move |machine| Box::pin(run(machine, manual, document))))
}

/// Runs the editor, with or without a document to open.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed and nothing is left to save.
pub async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Asked<()> {
    work::run(Editor::new(), &mut Desk::new(machine, manual), document).await
}

/// Whether the editor can work with a document; else why not.
///
/// # Errors
/// The reason, in both languages.
pub fn check(document: &Document) -> Result<(), Phrase> {
    coefficients_of(document).map(|_| ())
}

fn coefficients_of(document: &Document) -> Result<Fourier, Phrase> {
    let Document::Fourier(fourier) = document else {
        return Err(words::NO_COEFFICIENTS.into());
    };
    fourier.curve().map_err(|error| Phrase::plain(&error))?;
    Ok(Fourier::clone(fourier))
}

/// The coefficients of a new configuration: a circle.
fn circle() -> Fourier {
    let mut fourier = Fourier::default();
    (fourier.a[1], fourier.b[1], fourier.q[1]) = (100.0, 100.0, 0.5);
    fourier
}

impl Work for Editor {
    type Value = Fourier;

    fn format(&self) -> Format {
        Format::Gbp
    }

    fn history(&mut self) -> &mut History<Fourier> {
        &mut self.history
    }

    fn reset(&mut self) {
        let before = (self.stage == Stage::Working).then(|| Box::new(self.history.now().clone()));
        self.load(circle());
        self.stage = Stage::Starting(before);
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        self.load(coefficients_of(document)?);
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        Ok(Document::Fourier(Box::new(self.history.now().clone())))
    }

    fn model(&self) -> impl Serialize + 'static {
        let error = self.target.as_ref().and_then(|target| target.deviation(self.history.now()));
        Model {
            coefficients: self.history.now().clone(),
            target: self.target.as_ref().map(|target| target.name.of(Default::default()).to_string()),
            rms: error.map(|error| error.rms),
            largest: error.map(|error| error.largest),
            unsaved: self.history.unsaved(),
        }
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        self.typing = None;
        loop {
            self.stage = Stage::Working;
            let tick = event(self, desk).await?;
            if self.type_on(&tick) || self.wheel(&tick) {
                continue;
            }
            // Esc first removes the mark.
            let busy = self.marked.is_some() || self.target.is_some();
            if common_key(self, desk, tick.key().filter(|key| !busy || *key != Key::Esc)).await? {
                self.marked = None;
                self.stepping = None;
                continue;
            }
            match self.command(&tick) {
                None => {}
                Some(Action::Change) => {
                    if let Some(place) = self.ask_coefficient(desk).await.unless_cancelled()? {
                        self.begin(place);
                    }
                }
                Some(Action::Quit) => {
                    self.marked = None;
                    let next = quit(self, desk).await?;
                    if next != Next::Work {
                        return Ok(next);
                    }
                }
                Some(Action::Fit) => {
                    self.fit(desk).await.unless_cancelled()?;
                }
                // In the manner of today nothing changes that was not chosen before.
                Some(Action::Step(_) | Action::Choose(_))
                    if self.marked.is_none() && desk.machine.manner() == Manner::Today =>
                {
                    self.mark(self.chosen);
                }
                Some(Action::Step(steps)) => self.step(self.chosen, steps),
                Some(Action::Choose(other)) => self.mark(other(self.chosen)),
                Some(Action::Type) => self.begin(self.chosen),
                Some(Action::Back) if self.marked.is_some() => self.marked = None,
                Some(Action::Back) => self.target = None,
            }
        }
    }
}

impl Editor {
    fn new() -> Editor {
        Editor {
            history: History::new(circle()),
            stage: Stage::Starting(None),
            chosen: Coefficient::new(Column::A, 1),
            marked: None,
            typing: None,
            stepping: None,
            target: None,
        }
    }

    /// Replaces the coefficients by ones that need no saving.
    fn load(&mut self, fourier: Fourier) {
        *self = Editor { history: History::new(fourier), stage: self.stage.clone(), ..Editor::new() };
    }

    /// Commits new coefficients as one change.
    fn change(&mut self, fourier: Fourier) {
        self.history.change(fourier);
        self.stepping = None;
    }

    /// Changes a coefficient by steps. Consecutive steps of one coefficient are undone together.
    fn step(&mut self, place: Coefficient, steps: i32) {
        let stepped = place.stepped(self.history.now(), steps);
        if self.stepping == Some(place) {
            self.history.undo();
        }
        let before = self.history.now().clone();
        self.history.change(stepped);
        self.stepping = (*self.history.now() != before).then_some(place);
        self.mark(place);
    }

    fn mark(&mut self, place: Coefficient) {
        self.chosen = place;
        self.marked = Some(place);
    }

    /// Opens the window of a coefficient for typing.
    fn begin(&mut self, place: Coefficient) {
        let width = place.column.quantity().width();
        self.mark(place);
        self.typing = Some(Entry::new(layout::area(place), layout::text_at(place), width, Accepts::Number));
    }

    /// Handles typing in a window; returns whether the event was for it. A click elsewhere accepts the text if it is
    /// a number; other keys discard it.
    fn type_on(&mut self, tick: &Tick) -> bool {
        let Some(entry) = &mut self.typing else { return false };
        match tick.key() {
            Some(key @ (Key::Enter | Key::Esc | Key::Backspace | Key::Char(_))) => match entry.key(key) {
                Typed::On => {}
                Typed::Done if self.take() => self.end_typing(),
                Typed::Done => {
                    // The original asks again.
                    let place = self.chosen;
                    self.begin(place);
                }
                Typed::Cancelled => self.end_typing(),
            },
            Some(_) => {
                self.end_typing();
                return false;
            }
            None if tick.click().is_some() => {
                self.take();
                self.end_typing();
                return false;
            }
            None => return false,
        }
        true
    }

    /// Sets the chosen coefficient to the typed value, clamped to its range; `false` if it is not a number.
    fn take(&mut self) -> bool {
        let range = Number::Real(self.chosen.column.quantity().range());
        let value = self.typing.as_ref().and_then(|entry| range.read(&entry.text));
        if let Some(value) = value {
            self.change(self.chosen.changed(self.history.now(), value));
        }
        value.is_some()
    }

    fn end_typing(&mut self) {
        self.typing = None;
        self.marked = None;
    }

    /// Changes the value under the mouse with the wheel; returns whether the event was that.
    fn wheel(&mut self, tick: &Tick) -> bool {
        let Some(Event::Wheel(steps)) = tick.event else { return false };
        self.typing = None;
        match layout::coefficient_at(tick.mouse.x, tick.mouse.y) {
            Some(place) => self.step(place, steps),
            None => self.marked = None,
        }
        true
    }

    /// The command of a key or of a click on a button; a click on a window opens it.
    fn command(&mut self, tick: &Tick) -> Option<Action> {
        if let Some(place) = tick.click().and_then(|(x, y)| layout::coefficient_at(x, y)) {
            self.begin(place);
            return None;
        }
        COMMANDS.find(tick)
    }

    /// Asks for a coefficient by name and number; a click on a window answers too.
    async fn ask_coefficient(&mut self, desk: &mut Desk<'_>) -> Asked<Coefficient> {
        self.marked = None;
        let windows = [Area::new(360, 10, 383, 23), Area::new(360, 28, 383, 41)];
        let mut column: Option<Column> = None;
        let mut number = Entry::new(windows[1], (364, 31), 2, Accepts::Number);
        loop {
            let request = if column.is_some() { Request::Number } else { Request::Text };
            let typing = Over::new(self, |screen: &mut Screen, language| {
                page(screen, TOP);
                screen.text(230, 26, words::COEFFICIENT_NAME.of(language), Color::Black);
                let color = |active| if active { Color::LightRed } else { Color::Black };
                screen.text(320, 12, words::LETTER.of(language), color(column.is_none()));
                screen.text(320, 30, words::DIGITS.of(language), color(column.is_some()));
                window(screen, windows[0]);
                screen.text(368, 13, column.map_or("", Column::name), Color::White);
                number.draw(screen);
            });
            let tick = desk.event_asked(&typing, request).await?;
            if let Some(place) = tick.click().and_then(|(x, y)| layout::coefficient_at(x, y)) {
                return Ok(place);
            }
            let Some(key) = tick.key() else { continue };
            match (column, number.key(key)) {
                (_, Typed::Cancelled) => return Err(Stop::Cancelled),
                (None, _) => {
                    number.text.clear();
                    column = tick.letter().and_then(Column::of_letter);
                }
                (Some(_), Typed::On) => {}
                (Some(column), Typed::Done) => {
                    let typed = number.text.parse().ok().filter(|k| column.numbers().contains(k));
                    match typed {
                        Some(k) => return Ok(Coefficient::new(column, k)),
                        None => {
                            number.text.clear();
                            desk.tell(words::no_such_coefficient(&column.numbers()), Stay::Briefly);
                        }
                    }
                }
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
