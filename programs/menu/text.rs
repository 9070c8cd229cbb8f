//! The menu in the terminal: the programs by groups on a page of text, found by typing, started in the same terminal.

use super::folded;
use crate::file::Format;
use crate::machine::{Key, Language, SAMPLES};
use crate::programs::groups::MENU;
use crate::textmode::{Doing, Hit, Overlay, Page, Row, Summary, TextEvent, TextProgram, chosen_after};
use crate::ui::{Group, Program, Words, words};

const TITLE: Words = Words(
    "GRAFIKA - Füzi János: Interaktív grafika (1997)",
    "GRAFIKA - János Füzi: Interaktív grafika (1997)",
);
const LIST: Words = Words("Programok", "Programs");

/// The keys of the last line.
const KEYS: [(Key, Words, Words); 5] = [
    (Key::Enter, Words("Enter", "Enter"), Words("indítás", "start")),
    (Key::Down, Words("A-Z", "A-Z"), Words("keresés", "search")),
    (Key::F(2), Words("F2", "F2"), Words("English", "magyar")),
    (Key::Ctrl('Z'), Words("Ctrl+Z", "Ctrl+Z"), Words("szünet", "pause")),
    (Key::Esc, Words("Esc", "Esc"), Words("kilépés", "quit")),
];

/// A line of the list, with what it stands for.
enum Entry {
    Group(&'static Group),
    Program(&'static Program),
}

/// The menu as a page of text.
pub struct TextMenu {
    language: Language,
    entries: Vec<Entry>,
    chosen: usize,
    /// What has been typed to find a program.
    typed: String,
    started: Option<&'static Program>,
    left: bool,
    message: Option<String>,
    /// Whether it is asked if this is the end.
    ending: bool,
}

/// The answers to that question, yes first; both languages' letters are understood in either.
const ANSWERS: [(&str, Words); 2] = [("IY", Words("igen", "yes")), ("N", Words("nem", "no"))];

impl TextMenu {
    /// The menu in a language, with its first program chosen.
    pub fn new(language: Language) -> TextMenu {
        let of_group = |group: &'static Group| {
            [Entry::Group(group)].into_iter().chain(group.programs().map(Entry::Program))
        };
        let entries = MENU.into_iter().flat_map(of_group).collect();
        TextMenu {
            language,
            entries,
            chosen: 1,
            typed: String::new(),
            started: None,
            left: false,
            message: None,
            ending: false,
        }
    }

    /// The program that the user has chosen to start, once.
    pub fn take_started(&mut self) -> Option<&'static Program> {
        self.started.take()
    }

    /// The language that the user has chosen.
    pub fn language(&self) -> Language {
        self.language
    }

    /// Says at the next page why a program failed.
    pub fn tell(&mut self, message: String) {
        self.message = Some(message);
    }

    fn program(&self) -> Option<&'static Program> {
        match self.entries.get(self.chosen) {
            Some(Entry::Program(program)) => Some(program),
            _ => None,
        }
    }

    fn rows(&self) -> Vec<Row> {
        let row = |entry: &Entry| match entry {
            Entry::Group(group) => Row::Heading(group.name.of(self.language).to_owned()),
            Entry::Program(program) => {
                let name = program.manual.name.to_uppercase();
                Row::Item(format!("  {name:10} {}", program.manual.about.of(self.language)))
            }
        };
        self.entries.iter().map(row).collect()
    }

    fn summary(&self) -> Summary {
        let Some(program) = self.program() else { return Summary::default() };
        let of = |words: Words| words.of(self.language);
        let mut lines = vec![of(program.manual.about).to_owned(), String::new()];
        lines.push(format!("{}: {}", of(Words("Fejezet", "Chapter")), program.chapter));
        let opens = |name: &&str| Format::from_name(name).is_some_and(|it| program.opens.contains(&it));
        let samples: Vec<&str> = SAMPLES.iter().map(|(name, _)| *name).filter(opens).collect();
        if !samples.is_empty() {
            lines.push(format!("{}: {}", of(Words("Példák", "Samples")), samples.join(" ")));
        }
        lines.push(String::new());
        lines.extend(program.manual.keys.iter().map(|(key, what)| format!("{}: {}", of(*key), of(*what))));
        Summary { title: program.manual.name.to_uppercase(), lines }
    }

    /// Chooses the first program that matches the typed text: by the beginning of its name, else by its description.
    fn find(&self, typed: &str) -> Option<usize> {
        let typed = folded(typed);
        let programs = || {
            self.entries.iter().enumerate().filter_map(|(index, entry)| match entry {
                Entry::Program(program) => Some((index, program)),
                Entry::Group(_) => None,
            })
        };
        let by_name = programs().find(|(_, program)| program.manual.name.starts_with(&typed));
        let by_line = || {
            programs().find(|(_, program)| {
                let about = folded(program.manual.about.of(self.language));
                program.manual.name.contains(&typed) || about.contains(&typed)
            })
        };
        by_name.or_else(by_line).map(|(index, _)| index)
    }

    /// The typed text grows only while something matches it.
    fn type_letter(&mut self, letter: char) {
        let typed: String = self.typed.chars().chain([letter]).collect();
        if let Some(index) = self.find(&typed) {
            self.chosen = index;
            self.typed = typed;
        }
    }

    fn key(&mut self, key: Key) {
        match key {
            Key::Enter => self.started = self.program(),
            Key::F(2) => self.language = self.language.other(),
            Key::Esc if self.typed.is_empty() => self.ending = true,
            Key::Esc => self.typed.clear(),
            Key::Backspace => {
                self.typed.pop();
                self.chosen =
                    self.find(&self.typed).filter(|_| !self.typed.is_empty()).unwrap_or(self.chosen);
            }
            Key::Char(' ') if self.typed.is_empty() => {}
            Key::Char(letter) => self.type_letter(letter),
            _ => {}
        }
    }
}

impl TextMenu {
    /// What is answered to whether this is the end.
    fn answer(&mut self, event: TextEvent) {
        let answer = match event {
            TextEvent::Click(Hit::Answer(index)) => Some(index),
            // Esc takes the question back.
            TextEvent::Key(Key::Esc) => Some(1),
            TextEvent::Key(Key::Char(typed)) => {
                ANSWERS.iter().position(|(letters, _)| letters.contains(typed.to_ascii_uppercase()))
            }
            _ => None,
        };
        if let Some(answer) = answer {
            (self.ending, self.left) = (false, answer == 0);
        }
    }
}

impl TextProgram for TextMenu {
    fn page(&self) -> Page {
        let language = self.language;
        let list = LIST.of(language);
        let keys = KEYS.iter().map(|(_, key, what)| (key.of(language).into(), what.of(language).into()));
        let message = |lines: &str, answers| Overlay::Message {
            title: "GRAFIKA".into(),
            lines: vec![lines.trim().into()],
            answers,
        };
        let go_on = || vec![("Enter".into(), Words("tovább", "go on").of(language).into())];
        let answers = || {
            // The letter of the language: the first in Hungarian, the last in English.
            let letter = |letters: &str| match language {
                Language::Hungarian => letters.chars().take(1).collect(),
                Language::English => letters.chars().rev().take(1).collect(),
            };
            ANSWERS.map(|(letters, word)| (letter(letters), word.of(language).into())).to_vec()
        };
        let overlay = match &self.message {
            Some(text) => Some(message(text, go_on())),
            None => self.ending.then(|| message(words::ASK_END.of(language), answers())),
        };
        Page {
            language,
            title: TITLE.of(language).to_owned(),
            list_title: if self.typed.is_empty() {
                list.to_owned()
            } else {
                format!("{list}: {}", self.typed)
            },
            rows: self.rows(),
            chosen: self.chosen,
            summary: self.summary(),
            keys: keys.collect(),
            overlay,
        }
    }

    fn event(&mut self, event: TextEvent) {
        if event == TextEvent::Close {
            self.left = true;
        } else if self.message.is_some() {
            let goes_on = matches!(event, TextEvent::Key(_) | TextEvent::Click(Hit::Answer(_)));
            self.message = self.message.take().filter(|_| !goes_on);
        } else if self.ending {
            self.answer(event);
        } else if event == TextEvent::Click(Hit::Row(self.chosen)) {
            self.started = self.program();
        } else if let Some(chosen) = chosen_after(&self.rows(), self.chosen, event) {
            self.chosen = chosen;
            self.typed.clear();
        } else if let TextEvent::Key(key) = event {
            self.key(key);
        } else if let TextEvent::Click(Hit::Key(index)) = event
            && let Some(&(key, ..)) = KEYS.get(index)
        {
            self.key(key);
        }
    }

    fn work(&mut self) {}

    fn doing(&self) -> Doing {
        match self.left || self.started.is_some() {
            true => Doing::Ended,
            false => Doing::Waiting,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::telepit::golden::assert_golden;

    fn type_into(menu: &mut TextMenu, text: &str) {
        for letter in text.chars() {
            menu.event(TextEvent::Key(Key::Char(letter)));
        }
    }

    fn chosen(menu: &TextMenu) -> &'static str {
        menu.program().map(|program| program.manual.name).unwrap_or_default()
    }

    #[test]
    fn every_program_can_be_chosen_and_started() {
        let mut menu = TextMenu::new(Language::English);
        let mut seen = Vec::new();
        for _ in crate::programs::ALL {
            seen.push(chosen(&menu));
            assert!(!menu.page().summary.lines.is_empty());
            menu.event(TextEvent::Key(Key::Down));
        }
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen.len(), crate::programs::ALL.len());
        menu.event(TextEvent::Key(Key::Enter));
        assert_eq!(menu.doing(), Doing::Ended);
        assert_eq!(menu.started.map(|program| program.manual.name), Some("telepit"));
    }

    #[test]
    fn the_page_looks_as_it_did() {
        for (language, code) in [(Language::Hungarian, "hu"), (Language::English, "en")] {
            let mut menu = TextMenu::new(language);
            type_into(&mut menu, "zm");
            assert_golden(&menu.page(), &format!("terminal_menu_{code}.txt"));
        }
    }

    #[test]
    fn typing_finds_names_and_lines() {
        let mut menu = TextMenu::new(Language::Hungarian);
        type_into(&mut menu, "GB_3");
        assert_eq!(chosen(&menu), "gb_3d_ip");
        menu.event(TextEvent::Key(Key::Esc));
        assert_eq!(menu.doing(), Doing::Waiting);
        type_into(&mut menu, "gyongyk");
        // What finds nothing is not typed.
        assert_eq!((chosen(&menu), menu.typed.as_str()), ("gyongy_k", "gyongyk"));
        type_into(&mut menu, "@");
        assert_eq!(menu.typed, "gyongyk");
        menu.event(TextEvent::Key(Key::Backspace));
        assert_eq!(menu.typed, "gyongy");
        menu.event(TextEvent::Key(Key::Down));
        assert_eq!((chosen(&menu), menu.typed.as_str()), ("csango_k", ""));
    }

    #[test]
    fn the_end_is_asked_for() {
        let after = |events: &[TextEvent]| {
            let mut menu = TextMenu::new(Language::English);
            events.iter().for_each(|event| menu.event(*event));
            (menu.doing(), menu.page().overlay.is_some())
        };
        let key = TextEvent::Key;
        assert_eq!(after(&[key(Key::Esc)]), (Doing::Waiting, true));
        for yes in
            [key(Key::Char('y')), key(Key::Char('I')), TextEvent::Click(Hit::Answer(0)), TextEvent::Close]
        {
            assert_eq!(after(&[key(Key::Esc), yes]).0, Doing::Ended);
        }
        for no in [key(Key::Char('n')), key(Key::Esc), TextEvent::Click(Hit::Answer(1))] {
            assert_eq!(after(&[key(Key::Esc), no]), (Doing::Waiting, false));
        }
        // Whatever is typed in the list only searches.
        assert_eq!(after(&[key(Key::Char('q')), key(Key::Char('Q'))]).0, Doing::Waiting);
    }

    #[test]
    fn a_message_waits_to_be_read() {
        let mut menu =
            TextMenu { message: Some("what went wrong".into()), ..TextMenu::new(Language::English) };
        menu.event(TextEvent::Click(Hit::Row(3)));
        assert!(menu.page().overlay.is_some());
        menu.event(TextEvent::Key(Key::Enter));
        assert!(menu.page().overlay.is_none() && menu.doing() == Doing::Waiting);
    }
}
