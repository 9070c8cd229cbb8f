//! The desk a program works at: the machine, the keys that mean the same everywhere, and the help page.

use super::lesson::{self, Lesson};
use super::notice::{MESSAGE_TIME, Notice, Stay};
use super::words::{self, Phrase, Words};
use crate::figure::screen_png;
use crate::machine::{Event, Key, Language, Machine, Quit, Storage, Tick};
use crate::screen::{Color, HEIGHT, Screen, WIDTH};
use std::time::Duration;

/// A program's whole picture. Questions draw it under themselves.
pub trait Picture {
    /// Draws the picture in a language.
    fn draw(&self, screen: &mut Screen, language: Language);
}

impl<F: Fn(&mut Screen, Language)> Picture for F {
    fn draw(&self, screen: &mut Screen, language: Language) {
        self(screen, language);
    }
}

/// One line of the help page: keys and what they do.
pub type KeyHelp = (Words, Words);

/// What a program says about itself to its user.
#[derive(Clone, Copy, Debug)]
pub struct Manual {
    /// The program's name, in lower case, as files are named after it.
    pub name: &'static str,
    /// What it is for, in one line.
    pub about: Words,
    /// Its keys.
    pub keys: &'static [KeyHelp],
    /// What it teaches, shown under the keys; empty for most.
    pub lesson: &'static [Lesson],
}

/// A machine with the manual of the program that works on it.
pub struct Desk<'m> {
    /// The machine.
    pub machine: &'m mut Machine,
    manual: Manual,
    notice: Option<Notice>,
    /// How long the help page has been open, all times together.
    away: Duration,
}

/// When a desk wakes a program without any event.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wake {
    Never,
    Frame,
    At(Duration),
}

impl<'m> Desk<'m> {
    /// A desk for a program.
    pub fn new(machine: &'m mut Machine, manual: Manual) -> Desk<'m> {
        Desk { machine, manual, notice: None, away: Duration::ZERO }
    }

    /// The name of the program that works here.
    pub fn program(&self) -> &'static str {
        self.manual.name
    }

    /// Draws the picture and sleeps until something happens that is for the program: F1 (help), F2
    /// (language) and F12 (picture of the screen) are dealt with here.
    ///
    /// # Errors
    /// [`Quit`] when the display is being closed.
    pub async fn event(&mut self, picture: &dyn Picture) -> Result<Tick, Quit> {
        self.event_within(picture, Wake::Never).await
    }

    /// As [`Desk::event`], but not beyond a moment: a tick without event then.
    ///
    /// # Errors
    /// [`Quit`] when the display is being closed.
    pub async fn event_before(&mut self, picture: &dyn Picture, moment: Duration) -> Result<Tick, Quit> {
        self.event_within(picture, Wake::At(moment)).await
    }

    /// As [`Desk::event`], but not beyond the next frame of an animation: a tick without event then.
    ///
    /// # Errors
    /// [`Quit`] when the display is being closed.
    pub async fn frame(&mut self, picture: &dyn Picture) -> Result<Tick, Quit> {
        self.event_within(picture, Wake::Frame).await
    }

    /// Time since the program started, without that on the help page: an animation by this clock stands
    /// still while its help is read.
    pub fn clock(&self) -> Duration {
        self.machine.now().saturating_sub(self.away)
    }

    async fn event_within(&mut self, picture: &dyn Picture, wake: Wake) -> Result<Tick, Quit> {
        loop {
            self.draw(picture);
            let expiry = self.notice.as_ref().and_then(|notice| notice.until);
            let tick = match (wake, expiry) {
                (Wake::Frame, _) => self.machine.frame().await?,
                (Wake::At(moment), None) => self.machine.event_before(moment).await?,
                (Wake::At(moment), Some(expiry)) => self.machine.event_before(moment.min(expiry)).await?,
                (Wake::Never, Some(expiry)) => self.machine.event_before(expiry).await?,
                (Wake::Never, None) => self.machine.event().await?,
            };
            let due = match wake {
                Wake::Never => false,
                Wake::Frame => true,
                Wake::At(moment) => moment <= tick.now,
            };
            self.forget_notice(&tick);
            match tick.key() {
                Some(Key::F(1)) => self.help().await?,
                Some(Key::F(2)) => self.machine.set_language(self.machine.language().other()),
                Some(Key::F(12)) => self.keep_picture(),
                None if tick.event.is_none() && !due => {}
                _ => return Ok(tick),
            }
        }
    }

    /// Lays a message over the screen: for its time, or until the next key or click, which still does
    /// what it does without the message.
    pub fn tell(&mut self, text: impl Into<Phrase>, stay: Stay) {
        let until = match stay {
            Stay::Briefly => Some(self.machine.now() + MESSAGE_TIME),
            Stay::UntilRead => None,
        };
        self.notice = Some(Notice { text: text.into(), until });
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
        if let Some(notice) = &self.notice {
            notice.draw(self.machine.screen(), language);
        }
    }

    /// Saves the screen as a PNG under the first free name and says so.
    fn keep_picture(&mut self) {
        match self.save_picture() {
            Ok(name) => {
                self.tell(Phrase::new(format!("Kép: {name}"), format!("Picture: {name}")), Stay::Briefly)
            }
            Err(problem) => self.tell(problem, Stay::UntilRead),
        }
    }

    fn save_picture(&mut self) -> Result<String, Phrase> {
        let picture = screen_png(self.machine.screen()).map_err(|error| words::plain(&error))?;
        let storage = self.machine.storage();
        let name = free_name(storage, self.manual.name);
        storage.write(&name, &picture).map_err(|error| words::storage_problem(&error))?;
        Ok(name)
    }

    /// Shows the help page and keeps the time that it takes.
    async fn help(&mut self) -> Result<(), Quit> {
        let begun = self.machine.now();
        let ended = self.read_help().await;
        self.away += self.machine.now().saturating_sub(begun);
        ended
    }

    /// Shows the program's keys until a key or click.
    async fn read_help(&mut self) -> Result<(), Quit> {
        loop {
            let language = self.machine.language();
            help_page(self.machine.screen(), &self.manual, language);
            let tick = self.machine.event().await?;
            match tick.key() {
                Some(Key::F(2)) => self.machine.set_language(language.other()),
                Some(_) => return Ok(()),
                None if tick.click().is_some() => return Ok(()),
                None => {}
            }
        }
    }
}

/// The first name `NAME-1.png`, `NAME-2.png`, … that is not taken.
fn free_name(storage: &dyn Storage, program: &str) -> String {
    let name = |number: u32| format!("{program}-{number}.png");
    let number = (1..u32::MAX).find(|&number| storage.find(&name(number)).is_none());
    name(number.unwrap_or(u32::MAX))
}

/// Keys of every program, listed under its own but for those that it lists itself.
const COMMON_KEYS: &[KeyHelp] = &[
    (Words("F1", "F1"), words::HELP_HELP),
    (Words("F2", "F2"), words::HELP_LANGUAGE),
    (Words("F11", "F11"), words::HELP_LARGEST),
    (Words("F12", "F12"), words::HELP_PICTURE),
    (Words("Esc", "Esc"), words::HELP_ESC),
];

fn help_page(screen: &mut Screen, manual: &Manual, language: Language) {
    screen.clear(Color::LightCyan);
    let inner = super::frame::Area::new(16, 16, WIDTH - 17, HEIGHT - 17);
    screen.bar(inner.x1, inner.y1, inner.x2, inner.y2, Color::Black);
    super::frame::sunken(screen, inner, 4);
    screen.text(40, 36, &manual.name.to_uppercase(), Color::Yellow);
    screen.text(40, 52, manual.about.of(language), Color::White);
    let mut y = 80;
    // A key that has a meaning of its own in a program has no other.
    let own =
        |key: &str| manual.keys.iter().any(|(keys, _)| keys.of(language).split(' ').any(|own| own == key));
    let common = COMMON_KEYS.iter().filter(|(key, _)| !own(key.of(language)));
    for (keys, what) in manual.keys.iter().chain(common) {
        screen.text(40, y, keys.of(language), Color::LightRed);
        screen.text(176, y, what.of(language), Color::White);
        y += 16;
    }
    lesson::draw(screen, y + 8, manual.lesson, language);
    screen.text(40, HEIGHT - 40, words::HELP_LEAVE.of(language), Color::LightGray);
}
