//! The module as the page sees it.

use crate::files::{Files, Shared};
use crate::host::Host;
use crate::open;
use crate::settings::{Results, Settings, preferences};
use crate::work::{Keeping, Trouble};
use crate::{catalog, share};
use grafika::display::Display;
use grafika::display::canvas::{Canvas, CanvasError, Fingers, Phase, Stage, Stroke, taken};
use grafika::file::{Document, Format};
use grafika::machine::{
    Button, Event, Key, KeyLine, Language, Machine, Manner, Modifier, Request, Session,
    Settings as MachineSettings, check_name,
};
use grafika::programs::{by_name, menu, of_format};
use grafika::ui::{Phrase, Program};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// How a program begins.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Begin {
    program: String,
    /// A file of this browser, or a sample.
    open: Option<String>,
    /// A document in the address.
    doc: Option<String>,
    puzzle: Option<String>,
    /// For this time only.
    manner: Option<String>,
    language: Option<String>,
    /// Where random numbers start from.
    seed: u64,
    /// What lost pages have left.
    left: Vec<crate::work::Left>,
}

/// What the strip of keys shows.
#[derive(Serialize)]
struct Strip {
    /// `keys`, `number` or `text` where something is asked.
    asked: Option<&'static str>,
    answers: Vec<String>,
    lines: Vec<StripLine>,
}

#[derive(Serialize)]
struct StripLine {
    keys: Vec<String>,
    about: &'static str,
}

/// The programs on a canvas.
#[wasm_bindgen]
pub struct App {
    host: Rc<Host>,
    files: Shared,
    canvas: Canvas,
    session: Option<Session>,
    program: Option<&'static Program>,
    fingers: Fingers,
    /// Which buttons of the mouse are down.
    held: [bool; 3],
    /// Parts of a wheel's notch that have not made a whole one.
    turned: f64,
    trouble: Trouble,
    usual: Language,
}

fn thrown(error: impl std::fmt::Display) -> JsValue {
    JsValue::from_str(&error.to_string())
}

#[wasm_bindgen]
impl App {
    /// The app on a canvas that stands in a place of some size, in a usual language (`hu` or `en`).
    ///
    /// # Errors
    /// Why nothing can be shown.
    #[wasm_bindgen(constructor)]
    pub fn new(host: Host, canvas: HtmlCanvasElement, language: &str) -> Result<App, JsValue> {
        let host = Rc::new(host);
        let usual = Language::from_code(language).unwrap_or(Language::English);
        let told = |error: CanvasError| thrown(Phrase::plain(&error).of(usual));
        let stage = Stage { width: 640.0, height: 480.0, density: 1.0 };
        Ok(App {
            files: Rc::new(RefCell::new(Files::new(Rc::clone(&host)))),
            canvas: Canvas::new(canvas, stage).map_err(told)?,
            host,
            session: None,
            program: None,
            fingers: Fingers::default(),
            held: [false; 3],
            turned: 0.0,
            trouble: Trouble::default(),
            usual,
        })
    }

    /// The groups and programs as JSON.
    pub fn catalog(&self) -> String {
        catalog::json()
    }

    /// The language of the program, else the preferred one.
    pub fn language(&self) -> String {
        self.spoken().code().to_owned()
    }

    /// Prefers a language from now on.
    ///
    /// # Errors
    /// Why it cannot be kept.
    #[wasm_bindgen(js_name = setLanguage)]
    pub fn set_language(&mut self, code: &str) -> Result<(), JsValue> {
        let Some(language) = Language::from_code(code) else { return Ok(()) };
        Settings(Rc::clone(&self.host)).speak(language).map_err(thrown)
    }

    /// Starts a program; `begin` is JSON, `now` the page's time in milliseconds.
    ///
    /// # Errors
    /// What is wrong with its file, puzzle or document, or that there is no such program.
    pub fn start(&mut self, begin: &str, now: f64) -> Result<(), JsValue> {
        let begin: Begin = serde_json::from_str(begin).map_err(thrown)?;
        let preferences = preferences(&self.host);
        let wished = begin.language.as_deref().and_then(Language::from_code);
        let language = wished.or(preferences.language).unwrap_or(self.usual);
        let own_menu = menu::PROGRAM.manual.name;
        let program: &'static Program = match by_name(&begin.program) {
            Some(program) => program,
            None if begin.program.eq_ignore_ascii_case(own_menu) => &menu::PROGRAM,
            None => {
                let name = &begin.program;
                let none =
                    Phrase::new(format!("nincs {name} program"), format!("there is no program {name}"));
                return Err(thrown(none.of(language)));
            }
        };
        let manner = begin.manner.as_deref().and_then(Manner::from_name).unwrap_or(preferences.manner);
        let settings = MachineSettings { language, seed: begin.seed, manner };
        let keeping = Keeping::new(Rc::clone(&self.host), begin.left, Rc::clone(&self.trouble));
        let mut machine = Machine::new(Box::new(Rc::clone(&self.files)), settings)
            .with_preferences(preferences, Settings(Rc::clone(&self.host)), self.usual)
            .with_bests(Results(Rc::clone(&self.host)))
            .with_recovery(keeping)
            .with_documents();
        let clouds = program.opens.contains(&Format::Xyz);
        let opened = match (&begin.open, &begin.doc, &begin.puzzle) {
            // Through the machine's own storage, which remembers what was read.
            (Some(name), ..) => Some(open::file(machine.storage(), name, clouds)),
            (_, Some(packed), _) => Some(open::shared(packed)),
            (.., Some(text)) => Some(open::puzzle(program, text)),
            _ => None,
        };
        let opened = opened.transpose().map_err(|problem| thrown(problem.of(language)))?;
        let (document, name): (_, Option<String>) = match opened {
            Some((document, name)) => (Some(document), name),
            None => (None, None),
        };
        machine.set_file(name);
        let start = (program.start)(document).map_err(|problem| thrown(problem.of(language)))?;
        self.canvas.begin(now);
        (self.program, self.held, self.turned) = (Some(program), [false; 3], 0.0);
        self.fingers = Fingers::default();
        self.session =
            Some(Session::start(machine, move |mut machine| async move { start(&mut machine).await }));
        Ok(())
    }

    /// Advances to the present and paints. Returns when to come again, in the page's time: -1 for at an event only, -2 when the
    /// program has ended.
    ///
    /// # Errors
    /// Why the canvas cannot be painted.
    pub fn step(&mut self, now: f64) -> Result<f64, JsValue> {
        self.canvas.set_now(now);
        let canvas = &self.canvas;
        let late = self.fingers.late(now, |at| canvas.pixel_at(at.0, at.1));
        self.send_all(late);
        let language = self.spoken();
        let told = |error: &dyn std::fmt::Display| thrown(Phrase::plain(error).of(language));
        let Some(session) = &mut self.session else { return Ok(-2.0) };
        let due = self.canvas.advance(session).map_err(|error| told(&error))?;
        if session.ended() {
            // A film being recorded has been saved, or that has failed.
            let finished = session.finish();
            (self.session, self.program) = (None, None);
            finished.map_err(|error| told(&error))?;
            return Ok(-2.0);
        }
        let first = due.into_iter().chain(self.fingers.due()).min_by(f64::total_cmp);
        Ok(first.unwrap_or(-1.0))
    }

    /// The place of the picture has another size, or pixels of another density.
    pub fn resize(&mut self, width: f64, height: f64, density: f64) {
        self.canvas.set_stage(Stage { width, height, density });
    }

    /// A key as a browser tells it. Whether it is the program's.
    #[allow(clippy::too_many_arguments, reason = "the fields of an event of the browser")]
    pub fn key(
        &mut self,
        key: &str,
        code: &str,
        ctrl: bool,
        alt: bool,
        meta: bool,
        third: bool,
        now: f64,
    ) -> bool {
        let taken = taken(Stroke { key, code, ctrl, alt, meta, third });
        if let Some(key) = taken {
            self.canvas.set_now(now);
            self.send(Event::Key(key));
        }
        taken.is_some()
    }

    /// A key by its name in scripts, such as `Ctrl+Z`; or a text, sign by sign.
    pub fn press(&mut self, name: &str, now: f64) {
        self.canvas.set_now(now);
        match Key::from_name(name) {
            Some(key) => self.send(Event::Key(key)),
            None => name
                .chars()
                .filter(|sign| !sign.is_control())
                .for_each(|sign| self.send(Event::Key(Key::Char(sign)))),
        }
    }

    /// Which of Shift and Ctrl are held.
    pub fn hold(&mut self, shift: bool, ctrl: bool, now: f64) {
        self.canvas.set_now(now);
        for (modifier, down) in [(Modifier::Shift, shift), (Modifier::Ctrl, ctrl)] {
            if self.session.as_ref().is_some_and(|session| session.mouse().with(modifier) != down) {
                self.send(Event::Hold(modifier, down));
            }
        }
    }

    /// The mouse or a pen is at a place of the stage, with these buttons down, as browsers number them.
    pub fn mouse(&mut self, x: f64, y: f64, buttons: u16, now: f64) {
        self.canvas.set_now(now);
        let (x, y) = self.canvas.pixel_at(x, y);
        self.send(Event::Move(x, y));
        for (bit, button) in [(1, Button::Left), (2, Button::Right), (4, Button::Middle)] {
            let down = buttons & bit != 0;
            if std::mem::replace(&mut self.held[button as usize], down) != down {
                self.send(if down { Event::Press(button) } else { Event::Release(button) });
            }
        }
    }

    /// A finger at a place of the stage: `down`, `move`, `up`, else it is taken away.
    pub fn finger(&mut self, id: i32, phase: &str, x: f64, y: f64, now: f64) {
        self.canvas.set_now(now);
        let phase = match phase {
            "down" => Phase::Down,
            "move" => Phase::Move,
            "up" => Phase::Up,
            _ => Phase::Cancel,
        };
        let canvas = &self.canvas;
        let events = self.fingers.event((id, phase), (x, y), now, |at| canvas.pixel_at(at.0, at.1));
        self.send_all(events);
    }

    /// The wheel has turned by so many pixels, towards the user positive.
    pub fn wheel(&mut self, pixels: f64, now: f64) {
        /// Pixels to a notch of a wheel.
        const NOTCH: f64 = 100.0;
        self.canvas.set_now(now);
        self.turned -= pixels / NOTCH;
        // The conversion saturates.
        let steps = self.turned.trunc() as i32;
        if steps != 0 {
            self.turned = self.turned.fract();
            self.send(Event::Wheel(steps));
        }
    }

    /// Lets go of everything: what happens to it happens elsewhere.
    #[wasm_bindgen(js_name = letGo)]
    pub fn let_go(&mut self, now: f64) {
        self.canvas.set_now(now);
        let mut events = self.fingers.lift();
        for button in [Button::Left, Button::Right, Button::Middle] {
            if std::mem::take(&mut self.held[button as usize]) {
                events.push(Event::Release(button));
            }
        }
        self.send_all(events);
        self.hold(false, false, now);
    }

    /// Asks the program to close; it has if `step` says so.
    pub fn close(&mut self, now: f64) {
        self.canvas.set_now(now);
        self.send(Event::Close);
    }

    /// What stands on the screen, a line for each text.
    pub fn texts(&self) -> String {
        let Some(session) = &self.session else { return String::new() };
        let texts: Vec<String> = session.screen().texts().iter().map(|text| text.string()).collect();
        texts.join("\n")
    }

    /// The keys to be touched, as JSON.
    pub fn strip(&self) -> String {
        let Some(session) = &self.session else { return "null".to_owned() };
        let names = |keys: &[Key]| keys.iter().map(ToString::to_string).collect();
        let language = usize::from(session.language() == Language::English);
        let (asked, answers) = match session.request() {
            None => (None, Vec::new()),
            Some(Request::Keys(keys)) => (Some("keys"), names(&keys)),
            Some(Request::Number) => (Some("number"), Vec::new()),
            Some(Request::Text) => (Some("text"), Vec::new()),
        };
        let line = |line: KeyLine| StripLine { keys: names(&line.keys), about: line.about[language] };
        let lines = session.keys().into_iter().map(line).collect();
        serde_json::to_string(&Strip { asked, answers, lines }).unwrap_or_default()
    }

    /// What is asked: `keys`, `number`, `text`, or nothing.
    pub fn asked(&self) -> Option<String> {
        let request = self.session.as_ref()?.request()?;
        Some(
            match request {
                Request::Keys(_) => "keys",
                Request::Number => "number",
                Request::Text => "text",
            }
            .to_owned(),
        )
    }

    /// The program's name, its file, and a mark where something is unsaved.
    pub fn title(&self) -> String {
        match (&self.session, self.program) {
            (Some(session), Some(program)) => session.title(&program.manual.name.to_uppercase()),
            _ => String::new(),
        }
    }

    /// Whether something would be lost.
    pub fn unsaved(&self) -> bool {
        self.session.as_ref().is_some_and(Session::unsaved)
    }

    /// The program's model as `dump` writes it.
    pub fn model(&self) -> Option<String> {
        self.session.as_ref()?.model()?.ok()
    }

    /// The part of an address that opens what is being made: its program, and the document packed.
    pub fn share(&self) -> Option<String> {
        let text = self.session.as_ref()?.document()?;
        let open = self.program.filter(|program| program.manual.name != menu::PROGRAM.manual.name);
        // What the menu has started is known by what it makes.
        let of_text = || Document::from_json(&text).ok().and_then(|document| of_format(document.format()));
        let program = open.or_else(of_text)?;
        Some(format!("program={}&doc={}", program.manual.name, share::packed(&text)))
    }

    /// The program that a file belongs to.
    ///
    /// # Errors
    /// What is wrong with the file.
    #[wasm_bindgen(js_name = programOf)]
    pub fn program_of(&self, name: &str) -> Result<String, JsValue> {
        let program = open::program_of(&self.files, name, self.program)
            .map_err(|problem| thrown(problem.of(self.spoken())))?;
        Ok(program.manual.name.to_owned())
    }

    /// A file of this browser has come, or has another content.
    #[wasm_bindgen(js_name = setFile)]
    pub fn set_file(&mut self, name: &str, content: Vec<u8>) {
        self.files.borrow_mut().set(name, Some(content));
    }

    /// A file of this browser is gone.
    #[wasm_bindgen(js_name = removeFile)]
    pub fn remove_file(&mut self, name: &str) {
        self.files.borrow_mut().set(name, None);
    }

    /// The content of a file of this browser.
    pub fn file(&self, name: &str) -> Option<Vec<u8>> {
        self.files.borrow().content(name).map(<[u8]>::to_vec)
    }

    /// Checks the name of a file.
    ///
    /// # Errors
    /// What is wrong with it.
    #[wasm_bindgen(js_name = checkName)]
    pub fn check_name(&self, name: &str) -> Result<(), JsValue> {
        check_name(name).map_err(|error| thrown(Phrase::plain(&error).of(self.spoken())))
    }

    /// All files of this browser in one.
    ///
    /// # Errors
    /// Why they cannot be.
    pub fn zip(&self) -> Result<Vec<u8>, JsValue> {
        self.files.borrow().zip().map_err(thrown)
    }

    /// Unsaved work could not be kept.
    #[wasm_bindgen(js_name = workTrouble)]
    pub fn work_trouble(&mut self, why: &str) {
        *self.trouble.borrow_mut() = Some(why.to_owned());
    }

    fn spoken(&self) -> Language {
        let session = self.session.as_ref().map(Session::language);
        session.or(preferences(&self.host).language).unwrap_or(self.usual)
    }

    fn send_all(&mut self, events: Vec<Event>) {
        events.into_iter().for_each(|event| self.send(event));
    }

    fn send(&mut self, event: Event) {
        let now = self.canvas.now();
        if let Some(session) = &mut self.session {
            session.send(event, now);
        }
    }
}
