//! Random events: what nobody would type, a hundred thousand times.

use super::{Kept, session, shared_out};
use grafika::machine::{
    Button, Event, FRAMES_PER_SECOND, Key, Manner, Memory, Recorder, Script, Session, Settings, play,
};
use grafika::ui::Program;
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;
use std::time::{Duration, Instant};

const MANNERS: [Manner; 2] = [Manner::Original, Manner::Today];

/// A small generator (SplitMix64), so that a seed gives the same events everywhere.
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Dice {
        Dice(seed)
    }

    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (word ^ (word >> 31)) % bound
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len() as u64) as usize]
    }
}

/// Keys that programs know, those that answer and confirm more often than others.
fn key(dice: &mut Dice) -> Key {
    let special = [
        Key::Enter,
        Key::Enter,
        Key::Enter,
        Key::Esc,
        Key::Backspace,
        Key::Tab,
        Key::Up,
        Key::Down,
        Key::Left,
        Key::Right,
        Key::Home,
        Key::End,
        Key::PageUp,
        Key::PageDown,
        Key::Insert,
        Key::Delete,
        Key::F(1),
        Key::F(2),
        Key::F(3),
        Key::F(4),
        Key::F(5),
        Key::F(6),
        Key::F(7),
        Key::F(8),
        Key::F(10),
        Key::F(11),
        Key::Ctrl('Z'),
        Key::Ctrl('Z'),
        Key::Ctrl('Y'),
        Key::Ctrl('S'),
        Key::CtrlF(12),
    ];
    match dice.below(10) {
        0..3 => dice.of(&special),
        3..5 => Key::Char(char::from(b'0' + dice.below(10) as u8)),
        5..9 => Key::Char(char::from(b'a' + dice.below(26) as u8)),
        _ => Key::Char(dice.of(&['.', '-', ' ', 'é', '/', '\\', 'Ő', '€'])),
    }
}

/// One random event; `Close` is rare.
pub(crate) fn event(dice: &mut Dice) -> Event {
    let button = match dice.below(8) {
        0 => Button::Right,
        1 => Button::Middle,
        _ => Button::Left,
    };
    match dice.below(100) {
        0..50 => Event::Key(key(dice)),
        50..75 => Event::Move(dice.below(660) as i32 - 10, dice.below(500) as i32 - 10),
        75..86 => Event::Press(button),
        86..97 => Event::Release(button),
        97..99 => Event::Wheel(dice.below(7) as i32 - 3),
        _ => Event::Close,
    }
}

/// A random script of so many events, with a picture at the end.
pub(crate) fn script(seed: u64, events: usize) -> String {
    let mut dice = Dice::new(seed);
    let mut text = String::new();
    let written = Shared::default();
    let mut recorder = Recorder::new(Box::new(written.clone()), "random");
    for index in 0..events {
        recorder.event(event(&mut dice), Duration::from_millis(index as u64 * 17));
    }
    text.push_str(&String::from_utf8(written.0.borrow().clone()).expect("scripts are text"));
    text.lines().filter(|line| *line != "close").map(|line| format!("{line}\n")).collect()
}

/// Events of a storm where programs answer quickly, and where their pictures take longer.
pub(crate) const MANY: usize = 100_000;
pub(crate) const SOME: usize = 3000;

/// How many of so many events are sent: all on a machine that promises all tests (`GRAFIKA_CI`), elsewhere a twentieth, or
/// as many as `GRAFIKA_EVENTS` says.
pub(crate) fn share(events: usize) -> usize {
    let said = std::env::var("GRAFIKA_EVENTS").ok().and_then(|text| text.parse().ok());
    said.unwrap_or(if std::env::var_os("GRAFIKA_CI").is_some() { events } else { events / 20 })
}

/// How many of so many events are recorded and replayed: all on a machine that promises all tests, elsewhere a third.
pub(crate) fn part(events: usize) -> usize {
    if std::env::var_os("GRAFIKA_CI").is_some() { events } else { events / 3 }
}

/// Sends random events to a program in either manner, a share of so many; it is started again whenever it ends.
pub(crate) fn storm(program: Program, events: usize) {
    let events = share(events);
    shared_out(&MANNERS, |&manner| storm_in(program, manner, "", events, events));
}

/// The same, and after so many events it starts anew with a script, which leads to a page that is soon left.
pub(crate) fn storm_after(program: Program, script: &str, each: usize, events: usize) {
    storm_in(program, Manner::Today, script, each, share(events));
}

fn storm_in(program: Program, manner: Manner, script: &str, each: usize, events: usize) {
    let settings = Settings { manner, ..Settings::default() };
    let script = Script::parse(script).expect("the script is right");
    let start = || {
        let mut running = session(program, Memory::default(), settings);
        play(&mut running, &script, &mut Kept::default()).expect("the outlet takes all");
        (running, Duration::ZERO)
    };
    let mut dice = Dice::new(1997);
    let (mut running, mut now) = start();
    let begun = Instant::now();
    for number in 1..=events {
        if dice.below(50) == 0 {
            now += Duration::from_millis(dice.below(3000));
        } else if dice.below(4) == 0 {
            now += Duration::from_secs(1) / FRAMES_PER_SECOND;
        }
        running.send(event(&mut dice), Duration::from_millis(now.as_millis() as u64));
        if running.ended() || number % each == 0 {
            (running, now) = start();
        }
    }
    println!("{}: {events} events in {:.1} s", program.manual.name, begun.elapsed().as_secs_f64());
}

/// Plays a script in either manner while it is recorded, plays the recording, and compares the screens.
pub(crate) fn assert_replays(program: Program, script: &str) {
    let replays = |manner: &Manner| {
        assert_replays_in(program, &format!("manner {}\n{script}", manner.name()));
    };
    shared_out(&MANNERS, replays);
}

fn assert_replays_in(program: Program, script: &str) {
    let run = |script: &str, recorder: Option<Recorder>| -> Session {
        let parsed = Script::parse(script).expect("the script is right");
        let mut running = session(program, Memory::default(), parsed.begun_with(Settings::default()));
        if let Some(recorder) = recorder {
            running.record(recorder);
        }
        play(&mut running, &parsed, &mut Kept::default()).expect("the outlet takes all");
        running.finish_recording().expect("memory takes all");
        running
    };
    let written = Shared::default();
    let first = run(script, Some(Recorder::new(Box::new(written.clone()), program.manual.name)));
    let recorded = String::from_utf8(written.0.borrow().clone()).expect("scripts are text");
    let second = run(&recorded, None);
    assert!(*first.screen() == *second.screen(), "the replay ends with another picture");
    assert_eq!(first.ended(), second.ended());
    assert_eq!(first.model().map(Result::unwrap), second.model().map(Result::unwrap));
}

/// A place to write that is looked into afterwards.
#[derive(Clone, Default)]
pub(crate) struct Shared(pub(crate) Rc<RefCell<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
