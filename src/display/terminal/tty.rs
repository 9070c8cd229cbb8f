//! The terminal itself: its modes, its answers, its events, and everything as it was before at the end.

use super::TerminalError;
use super::answers::{Answers, QUESTIONS};
use super::graphics;
use super::place::Extent;
use crossterm::event::{
    DisableMouseCapture, EnableMouseCapture, Event, KeyboardEnhancementFlags, PopKeyboardEnhancementFlags,
    PushKeyboardEnhancementFlags,
};
use crossterm::terminal::{self, EnterAlternateScreen, LeaveAlternateScreen};
use crossterm::{cursor, execute, queue};
use std::cell::Cell;
use std::io::{self, IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// How long a terminal may take to answer; any that answers at all takes far less, but for a slow line.
const PATIENCE: Duration = Duration::from_millis(800);

/// Starts and stops a frame that is shown at once.
const TOGETHER: [&[u8]; 2] = [b"\x1b[?2026h", b"\x1b[?2026l"];

/// Mouse places in pixels.
const PIXEL_MOUSE: [&[u8]; 2] = [b"\x1b[?1016h", b"\x1b[?1016l"];

/// A terminal in the modes of the display; dropped, it is as before.
pub(super) struct Tty {
    pub(super) answers: Answers,
    signals: Signals,
    /// Bytes that the terminal may not have shown yet; `None` when it does not tell.
    unshown: Cell<Option<usize>>,
}

/// So many bytes may be under way: what a slow line needs a third of a second for.
const UNDER_WAY: usize = 4096;

/// A terminal that takes longer to answer is not asked again; the library gives up a little earlier.
const LONGEST_ANSWER: Duration = Duration::from_millis(2500);

/// Has the wish to end or to pause the process noted instead of carried out, until it is dropped: so that the terminal,
/// or whatever else is under way, can be put in order.
#[derive(Debug)]
pub struct Signals {
    /// The number of the signal that asked the process to end; 0 without one.
    end: Arc<AtomicUsize>,
    /// Set when the process is asked to pause.
    pause: Arc<AtomicBool>,
    /// Set when the process goes on after a pause, even one that nobody announced.
    resumed: Arc<AtomicBool>,
    #[cfg(unix)]
    watched: Vec<signal_hook::SigId>,
}

impl Signals {
    /// Watches for wishes to end. Where there are no signals, none come.
    pub fn watch() -> Signals {
        let mut signals = Signals {
            end: Arc::default(),
            pause: Arc::default(),
            resumed: Arc::default(),
            #[cfg(unix)]
            watched: Vec::new(),
        };
        signals.watch_ends();
        signals
    }

    /// Watches for pauses, too.
    pub(super) fn watch_all() -> Signals {
        let mut signals = Signals::watch();
        signals.watch_pauses();
        signals
    }

    #[cfg(unix)]
    fn watch_ends(&mut self) {
        use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
        // Their numbers are small and positive.
        let note =
            |signal| signal_hook::flag::register_usize(signal, Arc::clone(&self.end), signal as usize).ok();
        self.watched.extend([SIGHUP, SIGINT, SIGQUIT, SIGTERM].into_iter().filter_map(note));
    }

    #[cfg(unix)]
    fn watch_pauses(&mut self) {
        use signal_hook::consts::{SIGCONT, SIGTSTP};
        let flags = [(SIGTSTP, &self.pause), (SIGCONT, &self.resumed)];
        let note = |(signal, flag)| signal_hook::flag::register(signal, Arc::clone(flag)).ok();
        self.watched.extend(flags.into_iter().filter_map(note));
    }

    #[cfg(not(unix))]
    fn watch_ends(&mut self) {}

    #[cfg(not(unix))]
    fn watch_pauses(&mut self) {}

    /// The number of the signal by which the process has been asked to end.
    pub fn stop(&self) -> Option<u8> {
        u8::try_from(self.end.load(Ordering::Relaxed)).ok().filter(|&signal| signal > 0)
    }

    /// Pauses the process if it was asked to, between giving the terminal back and taking it again. Whether the
    /// terminal was taken again, because the process goes on after a pause.
    fn pass_pause(
        &self,
        give_back: impl FnOnce(),
        take: impl FnOnce() -> io::Result<()>,
    ) -> io::Result<bool> {
        if self.pause.swap(false, Ordering::Relaxed) {
            give_back();
            #[cfg(unix)]
            signal_hook::low_level::emulate_default_handler(signal_hook::consts::SIGTSTP)?;
            self.resumed.store(true, Ordering::Relaxed);
        }
        let resumed = self.resumed.swap(false, Ordering::Relaxed);
        if resumed {
            take()?;
        }
        Ok(resumed)
    }
}

impl Drop for Signals {
    fn drop(&mut self) {
        #[cfg(unix)]
        for &signal in &self.watched {
            signal_hook::low_level::unregister(signal);
        }
    }
}

/// What the terminal told.
pub(super) struct Told {
    pub(super) events: Vec<Event>,
    /// Whether the process had paused, so that nothing is known of what the terminal shows and of buttons that were down.
    pub(super) paused: bool,
}

impl Tty {
    /// Puts the terminal into the modes of the display and asks what it can do.
    pub(super) fn open() -> Result<Tty, TerminalError> {
        Tty::open_with(ask)
    }

    /// The same without asking: for lines of characters, which every terminal shows.
    pub(super) fn open_plain() -> Result<Tty, TerminalError> {
        Tty::open_with(|| Ok(Answers::default()))
    }

    fn open_with(ask: impl FnOnce() -> Result<Answers, TerminalError>) -> Result<Tty, TerminalError> {
        if !io::stdin().is_terminal() || !io::stdout().is_terminal() {
            return Err(TerminalError::NoTerminal);
        }
        let mut tty =
            Tty { signals: Signals::watch_all(), answers: Answers::default(), unshown: Cell::new(None) };
        // From here on every way out passes the drop, which undoes more than may have been done.
        tty.take_screen()?;
        tty.answers = ask()?;
        tty.unshown.set(tty.answers.complete.then_some(0));
        tty.take_input()?;
        Ok(tty)
    }

    fn take_screen(&self) -> io::Result<()> {
        terminal::enable_raw_mode()?;
        execute!(io::stdout(), EnterAlternateScreen, cursor::Hide)
    }

    fn take_input(&self) -> io::Result<()> {
        queue!(io::stdout(), terminal::DisableLineWrap, EnableMouseCapture)?;
        if self.answers.pixel_mouse {
            io::stdout().write_all(PIXEL_MOUSE[0])?;
        }
        if self.answers.clear_keys {
            let flags = KeyboardEnhancementFlags::DISAMBIGUATE_ESCAPE_CODES;
            queue!(io::stdout(), PushKeyboardEnhancementFlags(flags))?;
        }
        execute!(io::stdout(), terminal::Clear(terminal::ClearType::All))
    }

    /// Leaves the terminal as it was before.
    fn give_back(&self) {
        let mut out = io::stdout();
        // Each step is worth trying when another one fails, and nobody is left to be told.
        if self.answers.kitty {
            let _ = out.write_all(graphics::kitty_delete().as_bytes());
        }
        if self.answers.clear_keys {
            let _ = queue!(out, PopKeyboardEnhancementFlags);
        }
        if self.answers.pixel_mouse {
            let _ = out.write_all(PIXEL_MOUSE[1]);
        }
        let _ = out.write_all(TOGETHER[1]);
        let _ =
            queue!(out, DisableMouseCapture, terminal::EnableLineWrap, LeaveAlternateScreen, cursor::Show);
        let _ = out.flush();
        let _ = terminal::disable_raw_mode();
    }

    /// Takes the terminal again, whatever has used it in the meantime.
    fn take_again(&self) -> io::Result<()> {
        // A shell has set modes of its own; the library would take the terminal to be in its modes still.
        let _ = terminal::disable_raw_mode();
        self.take_screen()?;
        self.take_input()
    }

    /// The terminal's size.
    pub(super) fn extent(&self) -> Result<Extent, TerminalError> {
        let (columns, rows) = terminal::size()?;
        let pixels = terminal::window_size().map_or((0, 0), |size| (size.width, size.height));
        Ok(self.answers.extent(columns, rows, pixels))
    }

    /// Writes one frame.
    pub(super) fn write(&self, frame: &[u8]) -> Result<(), TerminalError> {
        let mut out = io::stdout().lock();
        out.write_all(TOGETHER[0])?;
        out.write_all(frame)?;
        out.write_all(TOGETHER[1])?;
        out.flush()?;
        drop(out);
        self.wait_until_shown(frame.len());
        Ok(())
    }

    /// Waits until a terminal that tells has shown what was sent, if that is much: else pictures would queue up in a slow
    /// line, and what the user does would be seen late.
    fn wait_until_shown(&self, sent: usize) {
        let unshown = self.unshown.get().map(|unshown| unshown.saturating_add(sent));
        self.unshown.set(match unshown {
            Some(UNDER_WAY..) => self.answers_where().then_some(0),
            other => other,
        });
    }

    /// Whether the terminal answers where the cursor is: the answer comes after all that was sent before. The library
    /// would ask for ever if the terminal went away meanwhile, so that it does so beside.
    fn answers_where(&self) -> bool {
        let (told, answer) = mpsc::channel();
        let asking = thread::Builder::new().spawn(move || told.send(cursor::position().is_ok()));
        if asking.is_err() {
            return false;
        }
        let end = Instant::now() + LONGEST_ANSWER;
        loop {
            match answer.recv_timeout(Duration::from_millis(50)) {
                Ok(shown) => return shown,
                Err(RecvTimeoutError::Timeout) if self.signals.stop().is_none() && Instant::now() < end => {}
                Err(_) => return false,
            }
        }
    }

    /// Pauses the process before the next event.
    pub(super) fn pause(&self) {
        self.signals.pause.store(true, Ordering::Relaxed);
    }

    /// What happened, at the latest after `longest` (then often nothing).
    pub(super) fn events(&self, longest: Duration) -> Result<Told, TerminalError> {
        let mut events = Vec::new();
        // What has been asked for already would not wake anybody, either.
        let asked = self.signals.pause.load(Ordering::Relaxed) || self.signals.stop().is_some();
        let longest = if asked { Duration::ZERO } else { longest };
        // What has been read already would not wake anybody.
        let mut pause = if crossterm::event::poll(Duration::ZERO)? { Duration::ZERO } else { wait(longest)? };
        if let Some(signal) = self.signals.stop() {
            // A terminal that goes away sends a signal, too.
            wait(Duration::ZERO)?;
            return Err(TerminalError::Stopped(signal));
        }
        let paused = self.signals.pass_pause(|| self.give_back(), || self.take_again())?;
        while crossterm::event::poll(pause)? {
            events.push(crossterm::event::read()?);
            pause = Duration::ZERO;
        }
        Ok(Told { events, paused })
    }
}

impl Drop for Tty {
    fn drop(&mut self) {
        self.give_back();
    }
}

/// Waits for input, a signal or the end of a time. Gives the time that is left to wait for the library's
/// own waiting.
#[cfg(unix)]
fn wait(longest: Duration) -> Result<Duration, TerminalError> {
    use rustix::event::{PollFd, PollFlags};
    let stdin = io::stdin();
    let mut watched = [PollFd::new(&stdin, PollFlags::IN)];
    match rustix::event::poll(&mut watched, longest.try_into().ok().as_ref()) {
        Ok(_) | Err(rustix::io::Errno::INTR) => {}
        Err(error) => return Err(io::Error::from(error).into()),
    }
    let seen = watched[0].revents();
    if seen.contains(PollFlags::HUP) {
        return Err(TerminalError::Lost("it was closed".to_string()));
    }
    // Some systems do not wait for terminals this way; the library knows another one.
    Ok(if seen.contains(PollFlags::NVAL) { longest } else { Duration::ZERO })
}

#[cfg(not(unix))]
fn wait(longest: Duration) -> Result<Duration, TerminalError> {
    Ok(longest)
}

/// Asks the terminal what it can do.
#[cfg(unix)]
fn ask() -> Result<Answers, TerminalError> {
    use rustix::event::{PollFd, PollFlags};
    let stdin = io::stdin();
    io::stdout().write_all(QUESTIONS)?;
    io::stdout().flush()?;
    let end = Instant::now() + PATIENCE;
    let mut received = Vec::new();
    loop {
        let left = end.saturating_duration_since(Instant::now());
        let mut watched = [PollFd::new(&stdin, PollFlags::IN)];
        let ready = match rustix::event::poll(&mut watched, left.try_into().ok().as_ref()) {
            Ok(ready) => ready > 0,
            Err(rustix::io::Errno::INTR) => continue,
            Err(error) => return Err(io::Error::from(error).into()),
        };
        if ready && watched[0].revents().contains(PollFlags::IN) {
            let mut buffer = [0; 1024];
            let length = rustix::io::read(&stdin, &mut buffer).map_err(io::Error::from)?;
            received.extend_from_slice(buffer.get(..length).unwrap_or_default());
        } else {
            let answers = Answers::read(&received);
            return Ok(with_text(answers));
        }
        if Answers::read(&received).complete {
            return Ok(with_text(Answers::read(&received)));
        }
    }
}

fn with_text(answers: Answers) -> Answers {
    terminal::size().map_or(answers, |(columns, rows)| answers.with_text_of(columns, rows))
}

/// The same where answers come as keys that are typed.
#[cfg(not(unix))]
fn ask() -> Result<Answers, TerminalError> {
    use crossterm::event::{KeyCode, KeyEventKind, poll, read};
    // A console of old would show the questions.
    #[cfg(windows)]
    if !crossterm::ansi_support::supports_ansi() {
        return Ok(Answers::default());
    }
    io::stdout().write_all(QUESTIONS)?;
    io::stdout().flush()?;
    let end = Instant::now() + PATIENCE;
    let mut typed = String::new();
    while !Answers::typed(&typed).complete && poll(end.saturating_duration_since(Instant::now()))? {
        match read()? {
            Event::Key(key) if key.kind == KeyEventKind::Release => {}
            Event::Key(key) => typed.extend(match key.code {
                KeyCode::Esc => Some('\x1b'),
                KeyCode::Char(typed) => Some(typed),
                _ => None,
            }),
            _ => {}
        }
    }
    Ok(with_text(Answers::typed(&typed)))
}
