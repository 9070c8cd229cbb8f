//! A running program as a display sees it: events and time go in, pictures come out.
//!
//! Frames and deadlines fall on a fixed grid of the session's own time, whatever the display's rate, so
//! that a recorded session replays to the same pictures.

use super::event::{Event, Mouse, Tick};
use super::port::{Port, Wait};
use super::record::Recorder;
use super::{
    Asked, Glyphs, KeyLine, Language, Look, Machine, Manner, Pointer, PointerSpeed, Pointing, Request, Stop,
    StorageError,
};
use crate::screen::{Color, Masks, Palette, Screen, WIDTH, visible};
use std::cell::{Ref, RefCell};
use std::future::Future;
use std::pin::Pin;
use std::rc::Rc;
use std::task::{Context, Waker};
use std::time::Duration;

/// A program as a display polls it.
type Running = Pin<Box<dyn Future<Output = Asked<()>>>>;

/// Frames of an animation a second.
pub const FRAMES_PER_SECOND: u32 = 60;

/// The most frames that are caught up after a delay of the display; older ones are skipped.
const FRAMES_CAUGHT_UP: u32 = 2 * FRAMES_PER_SECOND;

/// Radius of the mark of a film in pixels.
const MARK: i32 = 6;

/// A program that has been started and waits for its display.
pub struct Session {
    port: Rc<RefCell<Port>>,
    program: Option<Running>,
    recorder: Option<Recorder>,
}

impl Session {
    /// Starts a program on a machine and runs it until it first waits.
    pub fn start<P, F>(machine: Machine, program: P) -> Session
    where
        P: FnOnce(Machine) -> F,
        F: Future<Output = Asked<()>> + 'static,
    {
        let port = machine.port();
        let mut session = Session { port, program: Some(Box::pin(program(machine))), recorder: None };
        session.poll();
        session
    }

    /// Writes every event from now on as a script, after the language and the manner.
    pub fn record(&mut self, mut recorder: Recorder) {
        let port = self.port.borrow();
        recorder.begin(port.language, port.manner);
        drop(port);
        self.recorder = Some(recorder);
    }

    /// Whether the program has ended.
    pub fn ended(&self) -> bool {
        self.program.is_none()
    }

    /// The screen as the program left it.
    pub fn screen(&self) -> Ref<'_, Screen> {
        Ref::map(self.port.borrow(), |port| &*port.screen)
    }

    /// The mouse pointer's shape and place, if the program shows one.
    pub fn pointer(&self) -> Option<(&'static Masks, i32, i32)> {
        let port = self.port.borrow();
        match port.pointer {
            Pointer::Hidden => None,
            Pointer::Shown(masks) => Some((masks, port.mouse.x, port.mouse.y)),
        }
    }

    /// Position and buttons of the mouse as the program knows them.
    pub fn mouse(&self) -> Mouse {
        self.port.borrow().mouse
    }

    /// What a window calls the session: the program, its file, and a mark when something is unsaved.
    pub fn title(&self, program: &str) -> String {
        let port = self.port.borrow();
        let file = port.file.as_ref().map(|file| format!(" - {}", visible(file))).unwrap_or_default();
        format!("{program}{file}{}", if port.unsaved { " *" } else { "" })
    }

    /// Whether something would be lost.
    pub fn unsaved(&self) -> bool {
        self.port.borrow().unsaved
    }

    /// The keys that the program has told.
    pub fn keys(&self) -> Vec<KeyLine> {
        self.port.borrow().prompt.keys.clone()
    }

    /// What the program asks for now, if anything.
    pub fn request(&self) -> Option<Request> {
        self.port.borrow().prompt.request.clone()
    }

    /// What is being made as JSON, on a machine [with documents](Machine::with_documents).
    pub fn document(&self) -> Option<String> {
        self.port.borrow().prompt.document.as_ref().and_then(|document| document())
    }

    /// A copy of the screen, with a red dot in the upper right corner while a film is being recorded. No saved picture
    /// has the dot.
    pub fn marked_screen(&self) -> Screen {
        let mut screen = self.screen().clone();
        if self.port.borrow().filming {
            let (right, top) = (WIDTH - 1 - MARK, MARK);
            screen.disc(right, top, MARK, Color::White, Color::White);
            screen.disc(right, top, MARK - 2, Color::LightRed, Color::LightRed);
        }
        screen
    }

    /// What a display shows: [`Session::marked_screen`] with the program's mouse pointer.
    pub fn picture(&self) -> Screen {
        let mut picture = self.marked_screen();
        if let Some((masks, x, y)) = self.pointer() {
            picture.pointer(x, y, masks);
        }
        picture
    }

    /// The language that the program speaks now.
    pub fn language(&self) -> Language {
        self.port.borrow().language
    }

    /// Changes the language that the program speaks, as a script does; the program draws itself again.
    pub fn set_language(&mut self, language: Language) {
        let before = std::mem::replace(&mut self.port.borrow_mut().language, language);
        self.redraw_if(before != language);
    }

    /// Changes how the program behaves, as a script does.
    pub fn set_manner(&mut self, manner: Manner) {
        let before = std::mem::replace(&mut self.port.borrow_mut().manner, manner);
        self.redraw_if(before != manner);
    }

    /// Tells what moves the pointer on the display, which a recording repeats.
    pub fn set_pointing(&mut self, pointing: Pointing) {
        let before = std::mem::replace(&mut self.port.borrow_mut().pointing, pointing);
        if let Some(recorder) = self.recorder.as_mut().filter(|_| before != pointing) {
            recorder.pointing(pointing);
        }
        self.redraw_if(before != pointing);
    }

    fn redraw_if(&mut self, changed: bool) {
        let now = self.port.borrow().now;
        if changed && !self.ended() {
            self.deliver(None, now);
        }
    }

    /// How the colours are to look.
    pub fn palette(&self) -> Palette {
        self.port.borrow().preferences.palette
    }

    /// How a window is to show the picture.
    pub fn look(&self) -> Look {
        self.port.borrow().preferences.look
    }

    /// The characters that draw the picture in a terminal, if they were chosen.
    pub fn glyphs(&self) -> Option<Glyphs> {
        self.port.borrow().preferences.glyphs
    }

    /// How far keys move the mouse.
    pub fn pointer_speed(&self) -> PointerSpeed {
        self.port.borrow().preferences.pointer_speed
    }

    /// The program's model as JSON, if it has one.
    pub fn model(&self) -> Option<serde_json::Result<String>> {
        self.port.borrow().model.as_ref().map(|model| model.json())
    }

    /// When the program wants to run again without any event; `None` while it only waits for one.
    pub fn deadline(&self) -> Option<Duration> {
        let port = self.port.borrow();
        match port.wait {
            _ if self.program.is_none() => None,
            Wait::Event => None,
            Wait::Frame => Some(next_frame(port.now)),
            Wait::Until(moment) => Some(moment),
        }
    }

    /// Advances the session's time to `now`; frames and deadlines on the way are delivered in order.
    pub fn advance(&mut self, now: Duration) {
        let oldest = now.saturating_sub(Duration::from_secs(1) * FRAMES_CAUGHT_UP / FRAMES_PER_SECOND);
        while let Some(deadline) = self.deadline().filter(|&deadline| deadline <= now) {
            let animated = self.port.borrow().wait == Wait::Frame;
            let moment = if animated { deadline.max(oldest) } else { deadline };
            self.deliver(None, moment);
        }
        let mut port = self.port.borrow_mut();
        port.now = port.now.max(now);
    }

    /// Advances the session's time to `now`, and delivers a frame to an animated program even if none is due, so that
    /// its model is that of this very moment.
    pub fn settle(&mut self, now: Duration) {
        self.advance(now);
        let behind = self.port.borrow().wait == Wait::Frame;
        if behind && !self.ended() {
            self.deliver(None, now);
        }
    }

    /// Delivers one event that happened at `now`; the program has fully reacted when this returns.
    pub fn send(&mut self, event: Event, now: Duration) {
        self.advance(now);
        if self.ended() {
            return;
        }
        if let Some(recorder) = &mut self.recorder {
            recorder.event(event, now);
        }
        self.deliver(Some(event), now);
    }

    /// Ends the program without asking it; a film being recorded is saved.
    ///
    /// # Errors
    /// [`StorageError`] when it could not be saved.
    pub fn finish(&mut self) -> Result<(), StorageError> {
        self.program = None;
        self.port.borrow_mut().lost.take().map_or(Ok(()), Err)
    }

    /// Ends the recording and reports whether all of it was written.
    pub fn finish_recording(&mut self) -> std::io::Result<()> {
        self.recorder.take().map_or(Ok(()), |recorder| recorder.finish(self.port.borrow().now))
    }

    fn deliver(&mut self, event: Option<Event>, now: Duration) {
        let mut port = self.port.borrow_mut();
        port.now = port.now.max(now);
        if let Some(event) = event {
            port.mouse = port.mouse.after(event);
        }
        port.answer = Some(match event {
            Some(Event::Close) => Err(Stop::Closed),
            event => Ok(Tick { event, now: port.now, mouse: port.mouse }),
        });
        drop(port);
        self.poll();
    }

    fn poll(&mut self) {
        let Some(program) = &mut self.program else { return };
        let mut context = Context::from_waker(Waker::noop());
        // However the program ended. `Stop::Cancelled` means Esc in a question outside of any command.
        if program.as_mut().poll(&mut context).is_ready() {
            self.program = None;
        }
    }
}

/// The first frame of the grid after a moment.
fn next_frame(now: Duration) -> Duration {
    let frame = Duration::from_secs(1) / FRAMES_PER_SECOND;
    let number = now.as_nanos() / frame.as_nanos() + 1;
    frame.saturating_mul(u32::try_from(number).unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Button, Key, Memory, Settings};
    use crate::screen::Color;

    fn machine() -> Machine {
        Machine::new(Box::new(Memory::default()), Settings::default())
    }

    fn ms(milliseconds: u64) -> Duration {
        Duration::from_millis(milliseconds)
    }

    #[test]
    fn program_draws_and_the_display_sees_it() {
        let mut session = Session::start(machine(), |mut machine| async move {
            loop {
                let tick = machine.event().await?;
                if let Some((x, y)) = tick.click() {
                    machine.screen().set(x, y, Color::White);
                }
                if tick.pressed(Key::Esc) {
                    return Ok(());
                }
            }
        });
        session.send(Event::Move(30, 40), ms(1));
        session.send(Event::Press(Button::Left), ms(1));
        assert_eq!(session.screen().pixel(30, 40), Some(Color::White));
        assert_eq!(session.deadline(), None);
        session.send(Event::Key(Key::Esc), ms(2));
        assert!(session.ended());
        session.send(Event::Key(Key::Esc), ms(3));
    }

    #[test]
    fn close_is_an_error_that_a_program_may_answer() {
        let mut session = Session::start(machine(), |mut machine| async move {
            while machine.event().await.is_ok() {}
            machine.screen().clear(Color::Red);
            machine.event().await?;
            Ok(())
        });
        session.send(Event::Close, ms(0));
        assert!(!session.ended());
        assert_eq!(session.screen().pixel(0, 0), Some(Color::Red));
        session.send(Event::Close, ms(0));
        assert!(session.ended());
    }

    #[test]
    fn esc_that_nothing_answers_ends_a_program() {
        let mut session = Session::start(machine(), |mut machine| async move {
            match machine.event().await?.key() {
                Some(Key::Esc) => Err(Stop::Cancelled),
                _ => Ok(()),
            }
        });
        session.send(Event::Key(Key::Esc), ms(0));
        assert!(session.ended());
    }

    #[test]
    fn frames_fall_on_the_grid_whatever_the_display_does() {
        let count = |steps: &[u64]| {
            let mut session = Session::start(machine(), |mut machine| async move {
                let mut frames = 0u32;
                loop {
                    frames += 1;
                    machine.publish(frames);
                    machine.frame().await?;
                }
            });
            steps.iter().for_each(|&step| session.advance(ms(step)));
            session.model().unwrap().unwrap()
        };
        assert_eq!(count(&[1000]), "61");
        assert_eq!(count(&[1, 2, 3, 17, 500, 501, 999, 1000]), "61");
    }

    #[test]
    fn a_settled_session_has_shown_an_animated_program_this_very_moment() {
        let mut session = Session::start(machine(), |mut machine| async move {
            loop {
                let tick = machine.frame().await?;
                machine.publish(tick.now.as_nanos() as u64);
            }
        });
        for moment in [1, 1000, 1007] {
            session.settle(ms(moment));
            assert_eq!(session.model().unwrap().unwrap(), (moment * 1_000_000).to_string());
        }
    }

    #[test]
    fn a_deadline_passes_before_a_later_event() {
        let mut session = Session::start(machine(), |mut machine| async move {
            let first = machine.event_before(ms(2000)).await?;
            let second = machine.event().await?;
            machine.publish((first.event.is_none(), second.key() == Some(Key::Enter)));
            machine.event().await?;
            Ok(())
        });
        session.send(Event::Key(Key::Enter), ms(2500));
        assert!(session.model().unwrap().unwrap().contains("true"));
    }

    #[test]
    fn a_held_up_display_does_not_repeat_hours_of_frames() {
        let mut session = Session::start(machine(), |mut machine| async move {
            let mut frames = 0u32;
            loop {
                machine.frame().await?;
                frames += 1;
                machine.publish(frames);
            }
        });
        session.advance(Duration::from_secs(36_000));
        let frames: u32 = session.model().unwrap().unwrap().parse().unwrap();
        assert!(frames <= FRAMES_CAUGHT_UP + 1, "{frames}");
    }
}
