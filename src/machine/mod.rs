//! What a program runs on: screen, keyboard, mouse, clock and storage, behind one value, [`Machine`].
//!
//! A program is an `async` function on a machine: straight-line code that asks and gets an answer. It
//! never blocks, starts no thread and touches no file itself; a display polls it through a
//! [`Session`]. The one display here is a script, [`play`]; those that need a system are in
//! [`display`](crate::display).
//!
//! ```
//! use grafika::machine::{Asked, Event, Key, Machine, Memory, Session, Settings, Stop};
//! use grafika::screen::Color;
//! use std::time::Duration;
//!
//! async fn run(mut machine: Machine) -> Asked<()> {
//!     while !machine.event().await?.pressed(Key::Esc) {
//!         machine.screen().bar(10, 10, 20, 20, Color::Yellow);
//!     }
//!     Ok(())
//! }
//!
//! let machine = Machine::new(Box::new(Memory::default()), Settings::default());
//! let mut session = Session::start(machine, run);
//! session.send(Event::Key(Key::Char('A')), Duration::ZERO);
//! assert_eq!(session.screen().pixel(15, 15), Some(Color::Yellow));
//! ```

mod bests;
mod event;
mod files;
mod film;
mod pointing;
mod port;
mod preferences;
mod prompt;
mod record;
mod recovery;
mod samples;
mod script;
mod session;
mod stop;
mod storage;

pub use bests::{Best, Bests};
pub use event::{Button, Event, Key, Modifier, Mouse, Tick};
pub use files::{Files, Standing};
pub use pointing::{POINTER_KEYS, PointerKey, Pointing};
pub use port::Wait;
pub use preferences::{Cloth, Glyphs, Keeper, Look, PointerSpeed, Preference, Preferences, Shown};
pub use prompt::{KeyLine, Request};
pub use record::Recorder;
pub use recovery::{Lost, Recovery, Verdict, Work};
pub use samples::{SAMPLES, SAMPLES_PAGE, sample};
pub use script::{Command, Outlet, Script, ScriptError, play};
pub use session::{FRAMES_PER_SECOND, Session};
pub use stop::{Asked, Asking, Stop};
pub use storage::{
    Memory, Storage, StorageError, StorageProblem, Stream, check_name, free_name, sample_or_not_found,
};

use crate::screen::{Masks, Screen};
use film::Film;
use port::{Port, Turn};
use prompt::Prompt;
use serde::Serialize;
use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;
use std::time::Duration;

/// The language of the texts on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Language {
    /// Hungarian, the language of the originals.
    #[default]
    Hungarian,
    /// English.
    English,
}

impl Language {
    /// The language of a code as `--lang` takes it.
    pub fn from_code(code: &str) -> Option<Language> {
        match code {
            "hu" => Some(Language::Hungarian),
            "en" => Some(Language::English),
            _ => None,
        }
    }

    /// The code as `--lang` takes it.
    pub fn code(self) -> &'static str {
        match self {
            Language::Hungarian => "hu",
            Language::English => "en",
        }
    }

    /// The other language.
    pub fn other(self) -> Language {
        match self {
            Language::Hungarian => Language::English,
            Language::English => Language::Hungarian,
        }
    }
}

/// How a program behaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Manner {
    /// Like the originals, without their faults; scripts default to this.
    #[default]
    Original,
    /// As users expect today.
    Today,
}

impl Manner {
    /// The manner of a name as `--manner` takes it.
    pub fn from_name(name: &str) -> Option<Manner> {
        match name {
            "1997" => Some(Manner::Original),
            "today" => Some(Manner::Today),
            _ => None,
        }
    }

    /// The name as `--manner` takes it.
    pub const fn name(self) -> &'static str {
        match self {
            Manner::Original => "1997",
            Manner::Today => "today",
        }
    }
}

/// The mouse pointer that a program wants to be shown.
#[derive(Clone, Copy, Debug)]
pub enum Pointer {
    /// No pointer (a program that draws a cursor of its own).
    Hidden,
    /// A pointer of these masks.
    Shown(&'static Masks),
}

/// The settings of a machine at the start of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The language at the start.
    pub language: Language,
    /// The seed of random numbers.
    pub seed: u64,
    /// How programs behave.
    pub manner: Manner,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { language: Language::default(), seed: 1, manner: Manner::default() }
    }
}

/// The machine that a program runs on.
pub struct Machine {
    port: Rc<RefCell<Port>>,
    screen: Box<Screen>,
    files: Files,
    recovery: Option<Box<dyn Recovery>>,
    keeper: Option<Box<dyn Keeper>>,
    /// The language of the environment, which counts where none is preferred.
    usual_language: Language,
    bests: Option<Box<dyn Bests>>,
    file: Option<String>,
    seed: u64,
    film: Option<Film>,
    visit: Visit,
}

/// Whether another program runs this one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Visit {
    #[default]
    None,
    Guest,
    Leaving,
}

impl Machine {
    /// A machine with a black screen.
    pub fn new(storage: Box<dyn Storage>, settings: Settings) -> Machine {
        let port = Port {
            screen: Box::new(Screen::new()),
            pointer: Pointer::Shown(&Masks::ARROW),
            mouse: Mouse::default(),
            now: Duration::ZERO,
            wait: Wait::Event,
            model: None,
            file: None,
            unsaved: false,
            filming: false,
            lost: None,
            language: settings.language,
            manner: settings.manner,
            pointing: Pointing::default(),
            preferences: Preferences::default(),
            prompt: Prompt::default(),
            answer: None,
        };
        Machine {
            port: Rc::new(RefCell::new(port)),
            screen: Box::new(Screen::new()),
            files: Files::new(storage),
            recovery: None,
            keeper: None,
            usual_language: settings.language,
            bests: None,
            file: None,
            seed: settings.seed,
            film: None,
            visit: Visit::None,
        }
    }

    /// The machine with a place that keeps unsaved work across a crash; without one, nothing is kept.
    #[must_use]
    pub fn with_recovery(mut self, recovery: impl Recovery + 'static) -> Machine {
        self.recovery = Some(Box::new(recovery));
        self
    }

    /// The machine with the user's preferences, the place where changes to them are kept, and the language of the
    /// environment.
    #[must_use]
    pub fn with_preferences(
        mut self,
        preferences: Preferences,
        keeper: impl Keeper + 'static,
        usual_language: Language,
    ) -> Machine {
        self.port.borrow_mut().preferences = preferences;
        self.keeper = Some(Box::new(keeper));
        self.usual_language = usual_language;
        self
    }

    /// The machine with a place that keeps the best results of games; without one, none are kept.
    #[must_use]
    pub fn with_bests(mut self, bests: impl Bests + 'static) -> Machine {
        self.bests = Some(Box::new(bests));
        self
    }

    /// The machine with a display that passes documents on, as [`Session::document`] gives them.
    #[must_use]
    pub fn with_documents(self) -> Machine {
        self.port.borrow_mut().prompt.wanted = true;
        self
    }

    /// Tells the display which keys the program has.
    pub fn tell_keys(&mut self, keys: Vec<KeyLine>) {
        self.port.borrow_mut().prompt.keys = keys;
    }

    /// Tells the display what is asked for now, if anything.
    pub fn tell_request(&mut self, request: Option<Request>) {
        self.port.borrow_mut().prompt.request = request;
    }

    /// Whether the display asks for documents.
    pub fn wants_documents(&self) -> bool {
        self.port.borrow().prompt.wanted
    }

    /// Gives the display what is being made, as JSON when it asks for it; `None` if it is no document.
    pub fn tell_document(&mut self, document: impl Fn() -> Option<String> + 'static) {
        self.port.borrow_mut().prompt.document = Some(Box::new(document));
    }

    fn port(&self) -> Rc<RefCell<Port>> {
        Rc::clone(&self.port)
    }

    /// The screen, to draw on.
    pub fn screen(&mut self) -> &mut Screen {
        &mut self.screen
    }

    /// Where files are read and written.
    pub fn storage(&mut self) -> &mut dyn Storage {
        &mut self.files
    }

    /// The same files, with what this program last read or wrote there.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// Where unsaved work is kept, if anywhere.
    pub fn recovery(&mut self) -> Option<&mut (dyn Recovery + 'static)> {
        self.recovery.as_deref_mut()
    }

    /// Where the best results of games are kept, if anywhere.
    pub fn bests(&mut self) -> Option<&mut (dyn Bests + 'static)> {
        self.bests.as_deref_mut()
    }

    /// The name of the file that the work was last read from or saved to.
    pub fn file(&self) -> Option<&str> {
        self.file.as_deref()
    }

    /// Sets the file that the work belongs to.
    pub fn set_file(&mut self, name: Option<String>) {
        self.port.borrow_mut().file.clone_from(&name);
        self.file = name;
    }

    /// Says whether something would be lost, for the title of the window.
    pub fn set_unsaved(&mut self, unsaved: bool) {
        self.port.borrow_mut().unsaved = unsaved;
    }

    /// Where random numbers start from (`--seed`).
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// How programs behave (`--manner`).
    pub fn manner(&self) -> Manner {
        self.port.borrow().manner
    }

    /// What moves the pointer.
    pub fn pointing(&self) -> Pointing {
        self.port.borrow().pointing
    }

    /// The position of the mouse and its buttons.
    pub fn mouse(&self) -> Mouse {
        self.port.borrow().mouse
    }

    /// Moves the mouse of the program and its pointer to a pixel, until the real mouse moves: to confine it to a part
    /// of the screen, or to move it by keys.
    pub fn put_mouse(&mut self, x: i32, y: i32) {
        let mut port = self.port.borrow_mut();
        port.mouse = port.mouse.after(Event::Move(x, y));
    }

    /// Time since the program started.
    pub fn now(&self) -> Duration {
        self.port.borrow().now
    }

    /// The language of the texts.
    pub fn language(&self) -> Language {
        self.port.borrow().language
    }

    /// Changes the language of the texts; the caller draws the screen again.
    pub fn set_language(&mut self, language: Language) {
        self.port.borrow_mut().language = language;
    }

    /// What the user has chosen for all programs.
    pub fn preferences(&self) -> Preferences {
        self.port.borrow().preferences.clone()
    }

    /// What can be chosen where the program is shown.
    pub fn offered_preferences(&self) -> Vec<Preference> {
        let offered = |it: &Preference| self.keeper.as_ref().is_none_or(|keeper| keeper.offers(*it));
        Preference::ALL.into_iter().filter(offered).collect()
    }

    /// Changes what the user has chosen: what can change at once does (language, manner, colours, the look of the
    /// window), the rest at the next start. What is as it was stays as the program was started with.
    ///
    /// # Errors
    /// Why it cannot be kept; it counts until the program ends.
    pub fn set_preferences(&mut self, preferences: Preferences) -> Result<(), String> {
        if preferences.language != self.preferences().language {
            self.set_language(preferences.language.unwrap_or(self.usual_language));
        }
        let kept = self.keeper.as_mut().map_or(Ok(()), |keeper| keeper.keep(&preferences));
        let mut port = self.port.borrow_mut();
        if preferences.manner != port.preferences.manner {
            port.manner = preferences.manner;
        }
        port.preferences = preferences;
        kept
    }

    /// Changes the language of the texts to the other one, as the user prefers it from now on.
    ///
    /// # Errors
    /// Those of [`Machine::set_preferences`].
    pub fn prefer_other_language(&mut self) -> Result<(), String> {
        let language = self.language().other();
        let kept = self.set_preferences(Preferences { language: Some(language), ..self.preferences() });
        // The program may have been started in another language than the preferred one.
        self.set_language(language);
        kept
    }

    /// Makes the program that runs next a guest of this one.
    pub fn become_guest(&mut self) {
        self.visit = Visit::Guest;
    }

    /// Makes a guest return to its host; `false` if the program is no guest.
    pub fn return_to_host(&mut self) -> bool {
        let guest = self.visit != Visit::None;
        if guest {
            self.visit = Visit::Leaving;
        }
        guest
    }

    /// Takes back [`Machine::return_to_host`].
    pub fn stay_guest(&mut self) {
        if self.visit == Visit::Leaving {
            self.visit = Visit::Guest;
        }
    }

    /// Ends a guest's visit; whether it returned to its host, rather than because the display closes.
    pub fn end_visit(&mut self) -> bool {
        std::mem::take(&mut self.visit) == Visit::Leaving
    }

    /// Chooses the mouse pointer.
    pub fn set_pointer(&mut self, pointer: Pointer) {
        self.port.borrow_mut().pointer = pointer;
    }

    /// Publishes a copy of the model, for `dump` in a script.
    pub fn publish<T: Serialize + 'static>(&mut self, model: T) {
        self.port.borrow_mut().model = Some(Box::new(model));
    }

    /// Shows the screen and sleeps until something happens.
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    pub async fn event(&mut self) -> Asked<Tick> {
        self.turn(Wait::Event).await
    }

    /// Shows the screen and sleeps until something happens or the next frame of an animation is due.
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    pub async fn frame(&mut self) -> Asked<Tick> {
        self.turn(Wait::Frame).await
    }

    /// Shows the screen and sleeps until something happens, but not beyond a moment of [`Machine::now`].
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    pub async fn event_before(&mut self, moment: Duration) -> Asked<Tick> {
        self.turn(Wait::Until(moment)).await
    }

    /// Starts a film, a GIF of every screen passed to [`Machine::film_screen`]. A film being recorded continues. A
    /// film is saved when it is stopped or the machine is dropped.
    ///
    /// # Errors
    /// [`StorageError`] if the encoder fails; no screen is known to make it fail.
    pub fn start_film(&mut self, program: &'static str) -> Result<(), StorageError> {
        if self.film.is_none() {
            let film = Film::new(program, self.now()).map_err(|error| no_film(program, &error))?;
            self.film = Some(film);
            self.port.borrow_mut().filming = true;
        }
        Ok(())
    }

    /// When the film being recorded reaches its maximum length of ten minutes.
    pub fn film_end(&self) -> Option<Duration> {
        self.film.as_ref().map(Film::end)
    }

    /// Whether the film being recorded is full: ten minutes long or 64 megabytes large.
    pub fn film_is_full(&self) -> bool {
        self.film.as_ref().is_some_and(|film| film.is_full(self.now()))
    }

    /// Adds the present screen to the film.
    ///
    /// # Errors
    /// [`StorageError`] if the encoder fails; no screen is known to make it fail.
    pub fn film_screen(&mut self) -> Result<(), StorageError> {
        let now = self.now();
        let Some(film) = &mut self.film else { return Ok(()) };
        film.show(&self.screen, now).map_err(|error| no_film(film.program, &error))
    }

    /// Stops and saves the film under the first free name, which it returns; `None` without a film.
    ///
    /// # Errors
    /// [`StorageError`] with the name and what is wrong.
    pub fn stop_film(&mut self) -> Result<Option<String>, StorageError> {
        let Some(film) = self.film.take() else { return Ok(None) };
        self.port.borrow_mut().filming = false;
        let program = film.program;
        let content = film.finish(self.now()).map_err(|error| no_film(program, &error))?;
        let name = free_name(self.storage(), program, "gif");
        self.storage().write(&name, &content)?;
        Ok(Some(name))
    }

    fn turn(&mut self, wait: Wait) -> Turn<'_> {
        Turn { port: &self.port, screen: &mut self.screen, wait, handed_over: false }
    }
}

impl Drop for Machine {
    /// Saves a film being recorded; the session reports what went wrong.
    fn drop(&mut self) {
        if let Err(error) = self.stop_film() {
            self.port.borrow_mut().lost = Some(error);
        }
    }
}

/// The error of a film that could not be made.
fn no_film(program: &str, error: &dyn fmt::Display) -> StorageError {
    StorageError { name: format!("{program}.gif"), problem: StorageProblem::System(error.to_string()) }
}
