//! The desk a program works at: the machine, the keys common to all programs, and the help page.

use super::hint::Hint;
use super::key_lines::key_lines;
use super::lesson::Lesson;
use super::notice::{MESSAGE_TIME, Notice, Stay};
use super::words::{Phrase, Words};
use crate::figure::Figure;
use crate::file::Document;
use crate::geometry::ParamSurface;
use crate::machine::{
    Asked, Asking, Event, Key, Language, Machine, Manner, Preference, Preferences, Request, Tick,
};
use crate::screen::Screen;
use std::pin::Pin;
use std::time::Duration;

/// A program's whole picture. Questions draw it under themselves.
pub trait Picture {
    /// Draws the picture in a language.
    fn draw(&self, screen: &mut Screen, language: Language);

    /// Its geometry without title and axes, which F10 saves. If it is `None`, F10 saves the screen.
    fn figure(&self) -> Option<Figure> {
        None
    }

    /// The surfaces that it shows, which F10 can save as a model too.
    fn surfaces(&self) -> Vec<Box<dyn ParamSurface>> {
        Vec::new()
    }

    /// What it shows as a document, for pictures whose own files hold something else; F10 can save it too.
    fn exported(&self) -> Option<Document> {
        None
    }

    /// What can be done now, which is shown where nothing is asked, in the manner of today.
    fn hint(&self) -> Option<Hint> {
        None
    }
}

impl<F: Fn(&mut Screen, Language)> Picture for F {
    fn draw(&self, screen: &mut Screen, language: Language) {
        self(screen, language);
    }
}

/// A picture with something drawn on top, such as a question. Its figure is that of the picture.
pub struct Over<'p, F> {
    under: &'p dyn Picture,
    over: F,
}

impl<'p, F: Fn(&mut Screen, Language)> Over<'p, F> {
    /// A picture with what is drawn over it.
    pub fn new(under: &'p dyn Picture, over: F) -> Over<'p, F> {
        Over { under, over }
    }
}

impl<F: Fn(&mut Screen, Language)> Picture for Over<'_, F> {
    fn draw(&self, screen: &mut Screen, language: Language) {
        self.under.draw(screen, language);
        (self.over)(screen, language);
    }

    fn figure(&self) -> Option<Figure> {
        self.under.figure()
    }

    fn surfaces(&self) -> Vec<Box<dyn ParamSurface>> {
        self.under.surfaces()
    }

    fn exported(&self) -> Option<Document> {
        self.under.exported()
    }
}

/// One line of the help page: keys and what they do.
pub type KeyHelp = (Words, Words);

/// A line of the help page whose keys are called the same in both languages.
pub const fn line(keys: &'static str, hungarian: &'static str, english: &'static str) -> KeyHelp {
    (Words(keys, keys), Words(hungarian, english))
}

/// The line about the key that ends the smallest programs.
pub const END: KeyHelp = line("Esc", "vége", "end");

/// The description of a program on its help page.
#[derive(Clone, Copy, Debug)]
pub struct Manual {
    /// The program's name, in lower case, as files are named after it.
    pub name: &'static str,
    /// What it is for, in one line.
    pub about: Words,
    /// What it is, what to try first, and the idea behind it, in three sentences: how the help page begins.
    pub intro: Words,
    /// Its keys.
    pub keys: &'static [KeyHelp],
    /// An explanation of its subject, shown under the keys; empty for most.
    pub lesson: &'static [Lesson],
}

/// A machine with the manual of the program that works on it.
pub struct Desk<'m> {
    /// The machine.
    pub machine: &'m mut Machine,
    pub(super) manual: Manual,
    notice: Option<Notice>,
    /// The total time that the help page and the questions about a figure have been open.
    away: Duration,
    /// Whether the desk is handling a key of its own, F9 or F10.
    aside: bool,
}

/// When a desk wakes a program without an event.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Wake {
    Never,
    /// Not without an event, but also by a key of the desk that changed a preference.
    Preference,
    Frame,
    At(Duration),
}

impl<'m> Desk<'m> {
    /// A desk for a program.
    pub fn new(machine: &'m mut Machine, manual: Manual) -> Desk<'m> {
        machine.tell_keys(key_lines(manual.keys));
        Desk { machine, manual, notice: None, away: Duration::ZERO, aside: false }
    }

    /// The name of the program that works here.
    pub fn program(&self) -> &'static str {
        self.manual.name
    }

    /// Shows other keys on the help page, where the manner has other ones.
    pub fn set_keys(&mut self, keys: &'static [KeyHelp]) {
        self.manual.keys = keys;
        self.machine.tell_keys(key_lines(keys));
    }

    /// Draws the picture and sleeps until an event for the program. F1 (help), F2 (language), F9 (settings), F10 (figure),
    /// Ctrl+F11 (look of the window), F12 (picture of the screen) and Ctrl+F12 (film) are handled here.
    ///
    /// # Errors
    /// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
    pub async fn event(&mut self, picture: &dyn Picture) -> Asked<Tick> {
        self.event_within(picture, Wake::Never).await
    }

    /// Like [`Desk::event`], while something is asked.
    pub(crate) async fn event_asked(&mut self, picture: &dyn Picture, request: Request) -> Asked<Tick> {
        self.machine.tell_request(Some(request));
        let tick = self.event(picture).await;
        self.machine.tell_request(None);
        tick
    }

    /// Like [`Desk::event`], but returns a tick without an event at a given moment.
    ///
    /// # Errors
    /// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
    pub async fn event_before(&mut self, picture: &dyn Picture, moment: Duration) -> Asked<Tick> {
        self.event_within(picture, Wake::At(moment)).await
    }

    /// Like [`Desk::event`], but returns a tick without an event at the next frame of an animation.
    ///
    /// # Errors
    /// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
    pub async fn frame(&mut self, picture: &dyn Picture) -> Asked<Tick> {
        self.event_within(picture, Wake::Frame).await
    }

    /// Time since the program started, without the time spent on the help page and in questions about a figure, so
    /// that animations pause there.
    pub fn clock(&self) -> Duration {
        self.machine.now().saturating_sub(self.away)
    }

    pub(super) async fn event_within(&mut self, picture: &dyn Picture, wake: Wake) -> Asked<Tick> {
        loop {
            self.draw(picture);
            if self.machine.film_is_full() {
                self.end_film(Stay::UntilRead);
                continue;
            }
            // The desk's own deadlines.
            let expiry = self.notice.as_ref().and_then(|notice| notice.until);
            let own = expiry.into_iter().chain(self.machine.film_end()).min();
            let tick = match (wake, own) {
                (Wake::Frame, _) => self.machine.frame().await?,
                (Wake::At(moment), None) => self.machine.event_before(moment).await?,
                (Wake::At(moment), Some(own)) => self.machine.event_before(moment.min(own)).await?,
                (Wake::Never | Wake::Preference, Some(own)) => self.machine.event_before(own).await?,
                (Wake::Never | Wake::Preference, None) => self.machine.event().await?,
            };
            let due = match wake {
                Wake::Never | Wake::Preference => false,
                Wake::Frame => true,
                Wake::At(moment) => moment <= tick.now,
            };
            self.forget_notice(&tick);
            match tick.key() {
                Some(Key::F(1)) => self.help().await?,
                Some(key) if self.turns_preference(key) => {
                    if wake == Wake::Preference {
                        return Ok(tick);
                    }
                }
                Some(Key::F(9)) if !self.aside => self.change_settings(picture).await?,
                Some(Key::F(10)) if !self.aside => self.save_figure(picture).await?,
                Some(Key::F(12)) => self.keep_picture(),
                Some(Key::CtrlF(12)) => self.switch_film(),
                None if tick.event.is_none() && !due => {}
                _ => return Ok(tick),
            }
        }
    }

    /// The keys that change a preference, now and at the next start: F2 the language, Ctrl+F11 the look of the window.
    /// Whether the key was one of them.
    pub(super) fn turns_preference(&mut self, key: Key) -> bool {
        match key {
            Key::F(2) => {
                let kept = self.machine.prefer_other_language();
                self.tell_if_not_kept(kept);
            }
            Key::CtrlF(11) => self.prefer(|it| it.turn(Preference::Look, true)),
            _ => return false,
        }
        true
    }

    /// Changes what the user has chosen for all programs.
    pub fn prefer(&mut self, change: impl FnOnce(&mut Preferences)) {
        let mut preferences = self.machine.preferences();
        change(&mut preferences);
        let kept = self.machine.set_preferences(preferences);
        self.tell_if_not_kept(kept);
    }

    fn tell_if_not_kept(&mut self, kept: Result<(), String>) {
        if let Err(problem) = kept {
            self.tell(Phrase::plain(&problem), Stay::UntilRead);
        }
    }

    /// Shows a message for a while, or until the next key or click, which keeps its usual effect.
    pub fn tell(&mut self, text: impl Into<Phrase>, stay: Stay) {
        self.notice = Some(self.notice_of(text.into(), stay));
    }

    /// Whether something succeeded; if not, says why.
    pub(crate) fn done(&mut self, result: Result<(), Phrase>, stay: Stay) -> bool {
        result.map_err(|problem| self.tell(problem, stay)).is_ok()
    }

    /// Like [`Desk::tell`], with a message that a film does not show.
    pub(super) fn tell_off_film(&mut self, text: Phrase, stay: Stay) {
        self.notice = Some(Notice { filmed: false, ..self.notice_of(text, stay) });
    }

    fn notice_of(&self, text: Phrase, stay: Stay) -> Notice {
        let until = match stay {
            Stay::Briefly => Some(self.machine.now() + MESSAGE_TIME),
            Stay::UntilRead => None,
        };
        Notice { text, until, filmed: true }
    }

    fn forget_notice(&mut self, tick: &Tick) {
        let over =
            self.notice.as_ref().and_then(|notice| notice.until).is_some_and(|until| until <= tick.now);
        if over || matches!(tick.event, Some(Event::Key(_) | Event::Press(_))) {
            self.notice = None;
        }
    }

    fn draw(&mut self, picture: &dyn Picture) {
        let language = self.machine.language();
        picture.draw(self.machine.screen(), language);
        if let (Manner::Today, Some(hint)) = (self.machine.manner(), picture.hint()) {
            let pointing = self.machine.pointing();
            hint.draw(self.machine.screen(), language, pointing);
        }
        let (filmed, other) = match self.notice.take() {
            Some(notice) if notice.filmed => (Some(notice), None),
            notice => (None, notice),
        };
        if let Some(notice) = &filmed {
            notice.draw(self.machine.screen(), language);
        }
        self.film_screen();
        if let Some(notice) = &other {
            notice.draw(self.machine.screen(), language);
        }
        // A film that failed has left its own message.
        self.notice = self.notice.take().or(filmed).or(other);
    }

    /// Shows the help page and adds up the time it takes.
    ///
    /// # Errors
    /// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
    pub async fn help(&mut self) -> Asked<()> {
        let begun = self.machine.now();
        let ended = self.read_help().await;
        self.away += self.machine.now().saturating_sub(begun);
        ended
    }

    /// Asks about a figure and saves it, and stops the clock meanwhile. The future is boxed because the questions
    /// wait for events at this desk, so it is recursive.
    async fn save_figure(&mut self, picture: &dyn Picture) -> Asked<()> {
        let begun = self.machine.now();
        self.aside = true;
        let asked: Pin<Box<dyn Future<Output = Asked<()>> + '_>> =
            Box::pin(self.ask_and_save_figure(picture));
        let ended = asked.await;
        self.aside = false;
        self.away += self.machine.now().saturating_sub(begun);
        // After Esc in a question nothing is saved, and the program sees no event.
        ended.unless_cancelled().map(|_| ())
    }

    /// Shows the settings and stops the clock meanwhile.
    async fn change_settings(&mut self, picture: &dyn Picture) -> Asked<()> {
        let begun = self.machine.now();
        self.aside = true;
        let chosen: Pin<Box<dyn Future<Output = Asked<()>> + '_>> = Box::pin(self.settings(picture));
        let ended = chosen.await;
        self.aside = false;
        self.away += self.machine.now().saturating_sub(begun);
        ended
    }
}
