//! The user's preferences, shared by all programs. Values only: where they are kept is decided by whoever starts the
//! programs, and reached through [`Keeper`].

use super::{Language, Manner};
use crate::screen::Palette;

/// The preferences. What is not set is left to the environment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Preferences {
    /// The language of the texts at the start.
    pub language: Option<Language>,
    /// Where programs show themselves.
    pub display: Option<Shown>,
    /// The window's size as a multiple of 640x480, 1 to 16.
    pub scale: Option<u32>,
    /// How programs behave; scripts have their own default.
    pub manner: Manner,
    /// How the picture fills the window.
    pub look: Look,
    /// How the colours look.
    pub palette: Palette,
    /// The cloth of the billiard table.
    pub cloth: Cloth,
    /// How many letters Ctrl with an arrow key moves the mouse in the terminal, 1 to 8.
    pub pointer_speed: PointerSpeed,
    /// Which characters draw the picture in a terminal without graphics; without a choice, those that the terminal is
    /// known to have.
    pub glyphs: Option<Glyphs>,
    /// The folder of programs that were started without a file.
    pub folder: Option<String>,
}

impl Default for Preferences {
    fn default() -> Self {
        Preferences {
            language: None,
            display: None,
            scale: None,
            manner: Manner::Today,
            look: Look::default(),
            palette: Palette::default(),
            cloth: Cloth::default(),
            pointer_speed: PointerSpeed::default(),
            glyphs: None,
            folder: None,
        }
    }
}

/// A place for programs to show themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// In a window.
    Window,
    /// In the terminal.
    Terminal,
}

/// How a window shows the picture that it is larger than.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// Magnified by a whole number: every pixel is a sharp square, with margins around all.
    #[default]
    Sharp,
    /// As large as it fits, with pixels whose edges are mixed where they fall between those of the window.
    Fill,
    /// As large as it fits, with the soft pixels and dark gaps between lines of a picture tube.
    Crt,
}

impl Look {
    /// The name of the look as a setting.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Look::Sharp => "sharp",
            Look::Fill => "fill",
            Look::Crt => "crt",
        }
    }

    /// The look of a name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Look> {
        [Look::Sharp, Look::Fill, Look::Crt].into_iter().find(|look| look.name() == name)
    }
}

/// The colour of the cloth on the billiard table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cloth {
    /// As in 1997.
    #[default]
    White,
    /// As in a hall.
    Green,
    /// As at a tournament.
    Blue,
}

impl Cloth {
    /// The name of the cloth as a setting.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Cloth::White => "white",
            Cloth::Green => "green",
            Cloth::Blue => "blue",
        }
    }

    /// The cloth of a name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Cloth> {
        [Cloth::White, Cloth::Green, Cloth::Blue].into_iter().find(|cloth| cloth.name() == name)
    }
}

/// The characters that draw the picture in a terminal, each set with those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Glyphs {
    /// Those of a typewriter, for letters too.
    Ascii,
    /// Lines, halves and quarters, eighths, and the dots of Braille: what most fonts have.
    Blocks,
    /// Sextants and wedges, added in Unicode 13.
    Unicode13,
    /// Octants, added in Unicode 16.
    Unicode16,
}

impl Glyphs {
    const ALL: [Glyphs; 4] = [Glyphs::Ascii, Glyphs::Blocks, Glyphs::Unicode13, Glyphs::Unicode16];

    /// The name of the set as a setting.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Glyphs::Ascii => "ascii",
            Glyphs::Blocks => "blocks",
            Glyphs::Unicode13 => "unicode13",
            Glyphs::Unicode16 => "unicode16",
        }
    }

    /// The set of a name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Glyphs> {
        Glyphs::ALL.into_iter().find(|glyphs| glyphs.name() == name)
    }
}

/// How far a key moves the mouse, in letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointerSpeed(u8);

impl Default for PointerSpeed {
    fn default() -> Self {
        PointerSpeed(1)
    }
}

impl PointerSpeed {
    /// The number of letters.
    #[must_use]
    pub fn letters(self) -> i32 {
        i32::from(self.0)
    }
}

/// What can be chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the field of the same name")]
pub enum Preference {
    Language,
    Display,
    Scale,
    Look,
    Manner,
    Palette,
    Cloth,
    PointerSpeed,
    Glyphs,
    Folder,
}

/// Leaves a choice to the environment.
const AUTO: &str = "auto";
const SCALES: [&str; 9] = [AUTO, "1", "2", "3", "4", "5", "6", "7", "8"];
const SPEEDS: [&str; 5] = ["1", "2", "3", "4", "8"];
const GLYPHS: [&str; 5] =
    [AUTO, Glyphs::Ascii.name(), Glyphs::Blocks.name(), Glyphs::Unicode13.name(), Glyphs::Unicode16.name()];
const LANGUAGES: [&str; 3] = [AUTO, "hu", "en"];
const DISPLAYS: [&str; 3] = [AUTO, "window", "terminal"];
const MANNERS: [&str; 2] = [Manner::Today.name(), Manner::Original.name()];
const LOOKS: [&str; 3] = [Look::Sharp.name(), Look::Fill.name(), Look::Crt.name()];
const CLOTHS: [&str; 3] = [Cloth::White.name(), Cloth::Green.name(), Cloth::Blue.name()];
const PALETTES: [&str; 5] = [
    Palette::Vga.name(),
    Palette::Amber.name(),
    Palette::Green.name(),
    Palette::Contrast.name(),
    Palette::ColorBlind.name(),
];

impl Preference {
    /// Everything, in the order of the settings page.
    pub const ALL: [Preference; 10] = [
        Preference::Language,
        Preference::Display,
        Preference::Scale,
        Preference::Look,
        Preference::Manner,
        Preference::Palette,
        Preference::Cloth,
        Preference::PointerSpeed,
        Preference::Glyphs,
        Preference::Folder,
    ];

    /// The name of the setting in its file and on the command line.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Preference::Language => "language",
            Preference::Display => "display",
            Preference::Scale => "scale",
            Preference::Look => "look",
            Preference::Manner => "manner",
            Preference::Palette => "palette",
            Preference::Cloth => "cloth",
            Preference::PointerSpeed => "pointer_speed",
            Preference::Glyphs => "glyphs",
            Preference::Folder => "folder",
        }
    }

    /// The setting of a name.
    #[must_use]
    pub fn from_key(key: &str) -> Option<Preference> {
        Preference::ALL.into_iter().find(|preference| preference.key() == key)
    }

    /// The values to choose from; none where any text is one.
    #[must_use]
    pub const fn values(self) -> &'static [&'static str] {
        match self {
            Preference::Language => &LANGUAGES,
            Preference::Display => &DISPLAYS,
            Preference::Scale => &SCALES,
            Preference::Look => &LOOKS,
            Preference::Manner => &MANNERS,
            Preference::Palette => &PALETTES,
            Preference::Cloth => &CLOTHS,
            Preference::PointerSpeed => &SPEEDS,
            Preference::Glyphs => &GLYPHS,
            Preference::Folder => &[],
        }
    }
}

impl Preferences {
    /// The value of a setting as text.
    #[must_use]
    pub fn get(&self, preference: Preference) -> String {
        match preference {
            Preference::Language => self.language.map_or(AUTO, Language::code).to_string(),
            Preference::Display => match self.display {
                None => AUTO,
                Some(Shown::Window) => "window",
                Some(Shown::Terminal) => "terminal",
            }
            .to_string(),
            Preference::Scale => self.scale.map_or(AUTO.to_string(), |scale| scale.to_string()),
            Preference::Look => self.look.name().to_string(),
            Preference::Manner => self.manner.name().to_string(),
            Preference::Palette => self.palette.name().to_string(),
            Preference::Cloth => self.cloth.name().to_string(),
            Preference::PointerSpeed => self.pointer_speed.0.to_string(),
            Preference::Glyphs => self.glyphs.map_or(AUTO, Glyphs::name).to_string(),
            Preference::Folder => self.folder.clone().unwrap_or_default(),
        }
    }

    /// Chooses the value of a setting, given as text.
    ///
    /// # Errors
    /// Which values there are.
    pub fn set(&mut self, preference: Preference, value: &str) -> Result<(), String> {
        let value = value.trim();
        let wrong = || {
            let values = preference.values().join(", ");
            format!("{} = {value:?}: there are {values}", preference.key())
        };
        let number = |most: u32| {
            let number = value.parse().ok().filter(|number| (1..=most).contains(number));
            number.ok_or_else(|| format!("{} = {value:?}: a number from 1 to {most}", preference.key()))
        };
        match preference {
            Preference::Language if value == AUTO => self.language = None,
            Preference::Language => self.language = Some(Language::from_code(value).ok_or_else(wrong)?),
            Preference::Display => {
                self.display = match value {
                    AUTO => None,
                    "window" => Some(Shown::Window),
                    "terminal" => Some(Shown::Terminal),
                    _ => return Err(wrong()),
                }
            }
            Preference::Scale if value == AUTO => self.scale = None,
            Preference::Scale => self.scale = Some(number(16)?),
            Preference::Look => self.look = Look::from_name(value).ok_or_else(wrong)?,
            Preference::Manner => self.manner = Manner::from_name(value).ok_or_else(wrong)?,
            Preference::Palette => self.palette = Palette::from_name(value).ok_or_else(wrong)?,
            Preference::Cloth => self.cloth = Cloth::from_name(value).ok_or_else(wrong)?,
            Preference::PointerSpeed => self.pointer_speed = PointerSpeed(number(8)? as u8),
            Preference::Glyphs if value == AUTO => self.glyphs = None,
            Preference::Glyphs => self.glyphs = Some(Glyphs::from_name(value).ok_or_else(wrong)?),
            Preference::Folder => self.folder = Some(value.to_string()).filter(|folder| !folder.is_empty()),
        }
        Ok(())
    }

    /// Chooses the next or the previous value of a setting, wrapping around. Settings of free text stay.
    pub fn turn(&mut self, preference: Preference, forward: bool) {
        let values = preference.values();
        let Some(last) = values.len().checked_sub(1) else { return };
        let now = self.get(preference);
        let at = values.iter().position(|value| *value == now);
        let next = match (at, forward) {
            (None, _) => 0,
            (Some(at), true) => {
                if at == last {
                    0
                } else {
                    at + 1
                }
            }
            (Some(at), false) => at.checked_sub(1).unwrap_or(last),
        };
        if let Some(value) = values.get(next) {
            // Every value of the list is one.
            let _ = self.set(preference, value);
        }
    }
}

/// Where preferences are kept.
pub trait Keeper {
    /// Keeps them for the next start.
    ///
    /// # Errors
    /// Why they cannot be kept, for the user.
    fn keep(&mut self, preferences: &Preferences) -> Result<(), String>;

    /// Whether a setting means something where the programs are shown.
    fn offers(&self, _preference: Preference) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_listed_value_can_be_chosen_and_turns_around() {
        for preference in Preference::ALL {
            assert_eq!(Preference::from_key(preference.key()), Some(preference));
            let mut preferences = Preferences::default();
            let first = preferences.get(preference);
            for value in preference.values() {
                preferences.set(preference, value).unwrap();
                assert_eq!(preferences.get(preference), *value);
            }
            preferences.set(preference, &first).unwrap();
            preference.values().iter().for_each(|_| preferences.turn(preference, true));
            assert_eq!(preferences.get(preference), first);
            preferences.turn(preference, true);
            preferences.turn(preference, false);
            assert_eq!(preferences.get(preference), first);
        }
    }

    #[test]
    fn wrong_values_are_told_and_change_nothing() {
        for preference in Preference::ALL.into_iter().filter(|it| !it.values().is_empty()) {
            for value in ["", "0", "-1", "99", "x", "é"] {
                let mut preferences = Preferences::default();
                let message = preferences.set(preference, value).unwrap_err();
                assert!(message.contains(preference.key()), "{message}");
                assert_eq!(preferences, Preferences::default());
            }
        }
        let mut preferences = Preferences::default();
        preferences.set(Preference::Scale, "13").unwrap();
        preferences.turn(Preference::Scale, true);
        assert_eq!(preferences.get(Preference::Scale), AUTO);
    }
}
