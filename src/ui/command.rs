//! Tables of commands: each row holds key, button, help line and action, so that none is written twice.

use super::desk::KeyHelp;
use super::frame::{Button, Pad};
use crate::machine::{Key, Language, Tick};
use crate::screen::Screen;

/// A command: its key and button, its help line and its action.
#[derive(Clone, Copy, Debug)]
pub struct Command<A: 'static> {
    /// A key in addition to the button's letter.
    pub key: Option<Key>,
    /// The button, whose hot letter is a key too.
    pub button: Option<Button>,
    /// A button that shows the key, where that is no letter.
    pub pad: Option<Pad>,
    /// The line of the help page; neighbouring commands may share one.
    pub help: Option<KeyHelp>,
    /// Its action; `None` for a mere help line, such as one about the mouse.
    pub action: Option<A>,
}

impl<A: Copy> Command<A> {
    const NOTHING: Command<A> = Command { key: None, button: None, pad: None, help: None, action: None };

    /// A command whose button shows its key.
    pub const fn pad(key: Key, pad: Pad, help: KeyHelp, action: A) -> Command<A> {
        Command { key: Some(key), pad: Some(pad), help: Some(help), action: Some(action), ..Command::NOTHING }
    }

    /// A command with a button.
    pub const fn button(button: Button, help: KeyHelp, action: A) -> Command<A> {
        Command { button: Some(button), help: Some(help), action: Some(action), ..Command::NOTHING }
    }

    /// A command with a key and no button.
    pub const fn key(key: Key, help: KeyHelp, action: A) -> Command<A> {
        Command { key: Some(key), help: Some(help), action: Some(action), ..Command::NOTHING }
    }

    /// Another key, described by the help line of a neighbour.
    pub const fn also(key: Key, action: A) -> Command<A> {
        Command { key: Some(key), action: Some(action), ..Command::NOTHING }
    }

    /// A help line about something that is not a command of this table.
    pub const fn told(help: KeyHelp) -> Command<A> {
        Command { help: Some(help), ..Command::NOTHING }
    }

    /// A key that is handled elsewhere and must not be used again.
    pub const fn elsewhere(key: Key, help: KeyHelp) -> Command<A> {
        Command { key: Some(key), help: Some(help), ..Command::NOTHING }
    }

    /// The command without a help line.
    #[must_use]
    pub const fn untold(self) -> Command<A> {
        Command { help: None, ..self }
    }

    /// The keys that give it.
    fn keys(&self) -> impl Iterator<Item = Key> {
        self.key.into_iter().chain(self.button.map(|button| Key::Char(button.text.letter)))
    }
}

/// The commands of a program, in the order of its help page.
#[derive(Clone, Copy, Debug)]
pub struct Commands<A: 'static>(pub &'static [Command<A>]);

impl<A: Copy> Commands<A> {
    /// The action of a key or of a click on a button; letters work in either case.
    pub fn find(&self, tick: &Tick) -> Option<A> {
        let Some((x, y)) = tick.click() else { return self.of_key(tick.key()?) };
        let hit = |command: &&Command<A>| {
            let pad = command.pad.is_some_and(|pad| pad.area.holds(x, y));
            pad || command.button.is_some_and(|button| button.hit(x, y))
        };
        self.0.iter().find(hit)?.action
    }

    /// The action of a key.
    pub fn of_key(&self, key: Key) -> Option<A> {
        let typed = key.letter().map_or(key, Key::Char);
        self.0.iter().find(|command| command.keys().any(|key| key == typed))?.action
    }

    /// Draws the buttons.
    pub fn draw(&self, screen: &mut Screen, language: Language) {
        for command in self.0 {
            if let Some(button) = command.button {
                button.draw(screen, language);
            }
            if let (Some(pad), Some(key)) = (command.pad, command.key) {
                pad.draw(screen, key, language);
            }
        }
    }

    /// The number of help lines.
    pub const fn lines(&self) -> usize {
        let (mut lines, mut row) = (0, 0);
        while row < self.0.len() {
            lines += self.0[row].help.is_some() as usize;
            row += 1;
        }
        lines
    }

    /// The lines of the help page; `N` is [`Commands::lines`].
    pub const fn help<const N: usize>(&self) -> [KeyHelp; N] {
        const NOTHING: super::Words = super::Words("", "");
        let mut help = [(NOTHING, NOTHING); N];
        let (mut line, mut row) = (0, 0);
        while row < self.0.len() {
            if let Some(told) = self.0[row].help {
                help[line] = told;
                line += 1;
            }
            row += 1;
        }
        help
    }

    /// Texts that are wider than their buttons, which are errors of the table.
    pub fn too_wide(&self) -> Vec<String> {
        let buttons = self.0.iter().filter_map(|command| command.button);
        let pairs =
            buttons.flat_map(|button| [Language::Hungarian, Language::English].map(|it| (button, it)));
        let wide = pairs.filter(|(button, language)| !button.fits(*language));
        wide.map(|(Button { text, .. }, it)| format!("{}{}", text.letter, text.rest.of(it))).collect()
    }

    /// The keys of all commands.
    pub fn keys(&self) -> Vec<Key> {
        self.0.iter().flat_map(Command::keys).collect()
    }

    /// The keys of more than one command, which are errors of the table.
    pub fn shared_keys(&self) -> Vec<Key> {
        let keys = self.keys();
        keys.iter().enumerate().filter(|(at, key)| keys[..*at].contains(key)).map(|(_, key)| *key).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Hot, Words};
    use super::*;
    use crate::machine::{Event, Mouse};
    use std::time::Duration;

    const HELP: KeyHelp = (Words("a", "a"), Words("b", "b"));
    const BUTTON: Button = Button::new(10, 10, Hot { letter: 'A', rest: Words("", "") });
    const TABLE: Commands<u8> = Commands(&[
        Command::told(HELP),
        Command::button(BUTTON, HELP, 1),
        Command::key(Key::F(3), HELP, 2).untold(),
    ]);
    const LINES: [KeyHelp; TABLE.lines()] = TABLE.help();

    fn find(event: Event) -> Option<u8> {
        let mouse = Mouse { x: 12, y: 12, ..Mouse::default() };
        TABLE.find(&Tick { event: Some(event), now: Duration::ZERO, mouse })
    }

    #[test]
    fn keys_and_buttons_lead_to_the_same_action() {
        assert_eq!(find(Event::Key(Key::Char('a'))), Some(1));
        assert_eq!(find(Event::Key(Key::F(3))), Some(2));
        assert_eq!(find(Event::Press(crate::machine::Button::Left)), Some(1));
        assert_eq!(find(Event::Key(Key::Char('x'))), None);
        assert_eq!(LINES.len(), 2);
    }

    #[test]
    fn a_text_wider_than_its_button_is_found() {
        assert!(TABLE.too_wide().is_empty());
        const WIDE: Button = Button::new(10, 10, Hot::new('A', "-kilences", "-eighty"));
        const TABLE_WIDE: Commands<u8> = Commands(&[Command::button(WIDE, HELP, 1)]);
        assert_eq!(TABLE_WIDE.too_wide(), ["A-kilences"]);
    }

    #[test]
    fn a_key_of_two_commands_is_found() {
        assert!(TABLE.shared_keys().is_empty());
        const TWICE: Commands<u8> =
            Commands(&[Command::button(BUTTON, HELP, 1), Command::key(Key::Char('A'), HELP, 2)]);
        assert_eq!(TWICE.shared_keys(), [Key::Char('A')]);
    }
}
