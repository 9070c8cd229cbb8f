//! Scripts: played line by line without a display, in virtual time.

use super::event::{Button, Event, Key, Modifier};
use super::session::Session;
use super::{Language, Manner, Pointing, Settings};
use crate::screen::Screen;
use std::fmt;
use std::time::Duration;

/// One line of a script.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// One key.
    Key(Key),
    /// Text, character by character.
    Type(String),
    /// The mouse moves.
    Move(i32, i32),
    /// A button goes down.
    Press(Button),
    /// A button goes up.
    Release(Button),
    /// A modifier goes down (`true`) or up.
    Hold(Modifier, bool),
    /// The mouse moves to a place and clicks.
    Click(i32, i32, Button),
    /// The mouse goes from one place to another with a button down.
    Drag([i32; 4], Button),
    /// The wheel turns.
    Wheel(i32),
    /// Virtual time passes.
    Wait(Duration),
    /// The screen is written as a picture.
    Shot(String),
    /// The program's model is written as JSON.
    Dump(String),
    /// Whether pictures show the mouse pointer from now on.
    Pointer(bool),
    /// The language that the program speaks from now on.
    Language(Language),
    /// How the program behaves from now on.
    Manner(Manner),
    /// What moves the pointer from now on, for hints.
    Pointing(Pointing),
    /// The close button.
    Close,
}

/// A line of a script that cannot be carried out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScriptError {
    /// The line's number, from 1.
    pub line: usize,
    /// What is wrong with it and what would be right.
    pub message: String,
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for ScriptError {}

/// A parsed script: commands with their line numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    commands: Vec<(usize, Command)>,
}

/// The longest wait, a day; more is a typing error.
const LONGEST_WAIT_MS: u64 = 24 * 60 * 60 * 1000;

impl Script {
    /// Parses a script; empty lines and lines that start with `#` are skipped.
    ///
    /// # Errors
    /// [`ScriptError`] for the first wrong line.
    pub fn parse(text: &str) -> Result<Script, ScriptError> {
        let mut commands = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let line = line.strip_suffix('\r').unwrap_or(line);
            if line.trim().is_empty() || line.trim_start().starts_with('#') {
                continue;
            }
            let command = parse_line(line).map_err(|message| ScriptError { line: index + 1, message })?;
            commands.push((index + 1, command));
        }
        Ok(Script { commands })
    }
}

impl Script {
    /// The settings that a script begins with: those lines count from the very start of the program.
    #[must_use]
    pub fn begun_with(&self, mut settings: Settings) -> Settings {
        for (_, command) in &self.commands {
            match command {
                Command::Language(language) => settings.language = *language,
                Command::Manner(manner) => settings.manner = *manner,
                _ => break,
            }
        }
        settings
    }
}

fn parse_line(line: &str) -> Result<Command, String> {
    let line = line.trim_start();
    let (verb, rest) = line.split_once(' ').unwrap_or((line, ""));
    if verb == "type" {
        return Ok(Command::Type(rest.to_string()));
    }
    let words: Vec<&str> = rest.split_whitespace().collect();
    match (verb.trim_end(), words.as_slice()) {
        ("key", [name]) => {
            let names = "a letter, a digit, Enter, Esc, Backspace, Tab, Space, Up, Down, Left, Right, F1 ... F12, Ctrl+Z";
            let key = Key::from_name(name)
                .ok_or_else(|| format!("there is no key {name:?}; keys are {names} ..."))?;
            Ok(Command::Key(key))
        }
        ("move", [x, y]) => Ok(Command::Move(number(x)?, number(y)?)),
        ("press" | "release", [name]) => {
            let down = verb.trim_end() == "press";
            match Modifier::from_name(name) {
                Some(modifier) => Ok(Command::Hold(modifier, down)),
                None if down => Ok(Command::Press(button(name)?)),
                None => Ok(Command::Release(button(name)?)),
            }
        }
        ("click", [x, y]) => Ok(Command::Click(number(x)?, number(y)?, Button::Left)),
        ("click", [x, y, name]) => Ok(Command::Click(number(x)?, number(y)?, button(name)?)),
        ("drag", [from_x, from_y, to_x, to_y, name @ ..]) if name.len() <= 1 => {
            let places = [number(from_x)?, number(from_y)?, number(to_x)?, number(to_y)?];
            Ok(Command::Drag(places, name.first().map_or(Ok(Button::Left), |name| button(name))?))
        }
        ("wheel", [steps]) => Ok(Command::Wheel(number(steps)?)),
        ("wait", [ms]) => match ms.parse() {
            Ok(ms @ 0..=LONGEST_WAIT_MS) => Ok(Command::Wait(Duration::from_millis(ms))),
            _ => {
                Err(format!("{ms:?} is no time to wait; give whole milliseconds, at most {LONGEST_WAIT_MS}"))
            }
        },
        ("shot", [_, ..]) => Ok(Command::Shot(rest.trim().to_string())),
        ("dump", [_, ..]) => Ok(Command::Dump(rest.trim().to_string())),
        ("pointer", ["on"]) => Ok(Command::Pointer(true)),
        ("pointer", ["off"]) => Ok(Command::Pointer(false)),
        ("lang", ["hu"]) => Ok(Command::Language(Language::Hungarian)),
        ("lang", ["en"]) => Ok(Command::Language(Language::English)),
        ("manner", ["today"]) => Ok(Command::Manner(Manner::Today)),
        ("manner", ["1997"]) => Ok(Command::Manner(Manner::Original)),
        ("pointing", ["mouse"]) => Ok(Command::Pointing(Pointing::Mouse)),
        ("pointing", ["keys"]) => Ok(Command::Pointing(Pointing::Keys)),
        ("close", []) => Ok(Command::Close),
        (verb, _) => Err(match FORMS.iter().find(|(known, _)| *known == verb) {
            Some((_, form)) => format!("{line:?} should be \"{form}\""),
            None => {
                let known: Vec<&str> = FORMS.iter().map(|&(known, _)| known).collect();
                format!("there is no command {verb:?}; commands are {}", known.join(", "))
            }
        }),
    }
}

/// Every command with its form, for messages.
const FORMS: [(&str, &str); 16] = [
    ("key", "key NAME"),
    ("type", "type TEXT"),
    ("move", "move X Y"),
    ("press", "press left|right|middle|shift|ctrl"),
    ("release", "release left|right|middle|shift|ctrl"),
    ("click", "click X Y [left|right|middle]"),
    ("drag", "drag X1 Y1 X2 Y2 [left|right|middle]"),
    ("wheel", "wheel STEPS"),
    ("wait", "wait MS"),
    ("shot", "shot FILE.png"),
    ("dump", "dump FILE.json"),
    ("pointer", "pointer on|off"),
    ("lang", "lang hu|en"),
    ("manner", "manner today|1997"),
    ("pointing", "pointing mouse|keys"),
    ("close", "close"),
];

fn number(word: &str) -> Result<i32, String> {
    word.parse().map_err(|_| format!("{word:?} is no whole number"))
}

fn button(name: &str) -> Result<Button, String> {
    Button::from_name(name)
        .ok_or_else(|| format!("there is no button {name:?}; buttons are left, right, middle"))
}

/// Where a script's pictures and models go.
pub trait Outlet {
    /// Writes the screen as a picture.
    ///
    /// # Errors
    /// What went wrong, with the path.
    fn picture(&mut self, path: &str, screen: &Screen) -> Result<(), String>;

    /// Writes a text.
    ///
    /// # Errors
    /// What went wrong, with the path.
    fn text(&mut self, path: &str, text: &str) -> Result<(), String>;
}

/// Takes everything and keeps nothing.
impl Outlet for () {
    fn picture(&mut self, _: &str, _: &Screen) -> Result<(), String> {
        Ok(())
    }

    fn text(&mut self, _: &str, _: &str) -> Result<(), String> {
        Ok(())
    }
}

/// Plays a script in a session. After each command the program has fully reacted before the next one
/// is read; the end of the program ends the script too.
///
/// # Errors
/// [`ScriptError`] when a picture or model cannot be written.
pub fn play(session: &mut Session, script: &Script, outlet: &mut dyn Outlet) -> Result<(), ScriptError> {
    let mut now = Duration::ZERO;
    let mut pointer = false;
    for (line, command) in &script.commands {
        let wrong = |message| ScriptError { line: *line, message };
        match command {
            Command::Wait(pause) => {
                now += *pause;
                session.settle(now);
            }
            Command::Pointer(on) => pointer = *on,
            Command::Language(language) => session.set_language(*language),
            Command::Manner(manner) => session.set_manner(*manner),
            Command::Pointing(pointing) => session.set_pointing(*pointing),
            Command::Shot(path) => {
                let mut screen = session.screen().clone();
                if let (true, Some((masks, x, y))) = (pointer, session.pointer()) {
                    screen.pointer(x, y, masks);
                }
                outlet.picture(path, &screen).map_err(wrong)?;
            }
            Command::Dump(path) => {
                let model = match session.model() {
                    Some(model) => model.map_err(|error| wrong(error.to_string()))?,
                    None => return Err(wrong("the program has no model to dump".to_string())),
                };
                outlet.text(path, &model).map_err(wrong)?;
            }
            command => events(command).into_iter().for_each(|event| session.send(event, now)),
        }
    }
    Ok(())
}

/// The events that a command stands for.
fn events(command: &Command) -> Vec<Event> {
    match command {
        Command::Key(key) => vec![Event::Key(*key)],
        Command::Type(text) => text.chars().map(|typed| Event::Key(Key::Char(typed))).collect(),
        Command::Move(x, y) => vec![Event::Move(*x, *y)],
        Command::Press(button) => vec![Event::Press(*button)],
        Command::Release(button) => vec![Event::Release(*button)],
        Command::Hold(modifier, down) => vec![Event::Hold(*modifier, *down)],
        Command::Click(x, y, button) => {
            vec![Event::Move(*x, *y), Event::Press(*button), Event::Release(*button)]
        }
        Command::Drag([from_x, from_y, to_x, to_y], button) => vec![
            Event::Move(*from_x, *from_y),
            Event::Press(*button),
            Event::Move(*to_x, *to_y),
            Event::Release(*button),
        ],
        Command::Wheel(steps) => vec![Event::Wheel(*steps)],
        Command::Close => vec![Event::Close],
        Command::Wait(_)
        | Command::Shot(_)
        | Command::Dump(_)
        | Command::Pointer(_)
        | Command::Language(_)
        | Command::Manner(_)
        | Command::Pointing(_) => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Machine, Memory, Recorder, Settings};
    use std::cell::RefCell;
    use std::rc::Rc;

    #[test]
    fn every_command_parses() {
        let text = "# comment\n\nkey A\nkey Ctrl+Z\ntype a b \nmove -3 700\npress left\nrelease right\n\
                    click 1 2\nclick 1 2 middle\ndrag 1 2 3 4\nwheel -2\nwait 1500\nshot a b.png\n\
                    dump x.json\npointer on\npointer off\nclose\n  key Enter  \r\n";
        let script = Script::parse(text).unwrap();
        assert_eq!(script.commands.len(), 17);
        assert_eq!(script.commands[2], (5, Command::Type("a b ".to_string())));
        assert_eq!(script.commands[11].1, Command::Shot("a b.png".to_string()));
    }

    #[test]
    fn a_wrong_line_says_its_number_and_what_would_be_right() {
        let message = |text| Script::parse(text).unwrap_err().to_string();
        assert_eq!(message("key A\nmove 3"), r#"line 2: "move 3" should be "move X Y""#);
        assert_eq!(message("click a 3"), r#"line 1: "a" is no whole number"#);
        assert!(
            message("\n\njump").contains(r#"line 3: there is no command "jump"; commands are key, type"#)
        );
        assert!(message("key Return").contains(r#"no key "Return""#));
        assert!(message("press up").contains("buttons are left, right, middle"));
        assert!(message("wait -5").contains("milliseconds"));
        assert!(message("wait 99999999999999999999").contains("at most"));
    }

    #[derive(Default)]
    struct Kept(Vec<String>);

    impl Outlet for Kept {
        fn picture(&mut self, path: &str, _: &Screen) -> Result<(), String> {
            self.0.push(path.to_string());
            Ok(())
        }
        fn text(&mut self, path: &str, text: &str) -> Result<(), String> {
            self.0.push(format!("{path}={text}"));
            Ok(())
        }
    }

    #[derive(Clone, Default)]
    struct Shared(Rc<RefCell<Vec<u8>>>);

    impl std::io::Write for Shared {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0.borrow_mut().extend_from_slice(bytes);
            Ok(bytes.len())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    fn listener() -> Session {
        let machine = Machine::new(Box::new(Memory::default()), Settings::default());
        Session::start(machine, |mut machine| async move {
            let mut log: Vec<String> = Vec::new();
            loop {
                let event = machine.event().await?;
                log.push(format!("{:?} at {:?}", event.event, event.now));
                machine.publish(log.clone());
            }
        })
    }

    #[test]
    fn a_recording_replays_to_the_same_events_at_the_same_times() {
        let script = "key A\ntype aé-ő\nwait 20\nclick 5 6\nwait 3\nkey Space\nkey F2\ndrag 1 2 3 4 right\nwheel -1\nwait 7\nkey Esc\nwait 9";
        let written = Shared::default();
        let mut first = listener();
        first.record(Recorder::new(Box::new(written.clone()), "listener"));
        play(&mut first, &Script::parse(script).unwrap(), &mut Kept::default()).unwrap();
        first.finish_recording().unwrap();
        let recorded = String::from_utf8(written.0.borrow().clone()).unwrap();
        let mut second = listener();
        play(&mut second, &Script::parse(&recorded).unwrap(), &mut Kept::default()).unwrap();
        assert_eq!(first.model().unwrap().unwrap(), second.model().unwrap().unwrap());
    }

    #[test]
    fn pictures_and_models_go_to_the_outlet() {
        let mut kept = Kept::default();
        let script = Script::parse("key A\nshot one.png\ndump two.json").unwrap();
        play(&mut listener(), &script, &mut kept).unwrap();
        assert_eq!(kept.0[0], "one.png");
        assert!(kept.0[1].starts_with("two.json=[") && kept.0[1].contains("Char('A')"));
        let early = Script::parse("\ndump two.json").unwrap();
        let error = play(&mut listener(), &early, &mut kept).unwrap_err();
        assert_eq!(error.to_string(), "line 2: the program has no model to dump");
    }
}
