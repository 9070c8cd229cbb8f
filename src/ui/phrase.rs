//! Texts in Hungarian and English, with or without a hot letter.

use super::hungarian;
use crate::machine::Language;
use crate::screen::visible;
use std::borrow::Cow;

/// A fixed text in Hungarian and in English.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words(pub &'static str, pub &'static str);

impl Words {
    /// The text in a language.
    pub fn of(self, language: Language) -> &'static str {
        match language {
            Language::Hungarian => self.0,
            Language::English => self.1,
        }
    }
}

/// A text in both languages that is composed at run time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phrase {
    hungarian: Cow<'static, str>,
    english: Cow<'static, str>,
}

impl Phrase {
    /// A phrase of its two texts. Control characters, which names and files may bring into a text, are shown as
    /// escapes; ends of lines stay.
    pub fn new(hungarian: impl Into<Cow<'static, str>>, english: impl Into<Cow<'static, str>>) -> Phrase {
        let shown = |text: Cow<'static, str>| match text {
            Cow::Owned(text) => Cow::Owned(text.split('\n').map(visible).collect::<Vec<_>>().join("\n")),
            fixed => fixed,
        };
        Phrase { hungarian: shown(hungarian.into()), english: shown(english.into()) }
    }

    /// A text of the library, such as an error, which is in English, with the Hungarian of the list.
    pub fn plain(text: &dyn std::fmt::Display) -> Phrase {
        let text = text.to_string();
        Phrase::new(hungarian::told(&text), text)
    }

    /// The text in a language.
    pub fn of(&self, language: Language) -> &str {
        match language {
            Language::Hungarian => &self.hungarian,
            Language::English => &self.english,
        }
    }
}

impl From<Words> for Phrase {
    fn from(words: Words) -> Phrase {
        Phrase::new(words.0, words.1)
    }
}

/// The text of a button or answer: a hot letter and the rest of the word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hot {
    /// The hot letter or digit, in upper case.
    pub letter: char,
    /// The rest of the text.
    pub rest: Words,
}

impl Hot {
    /// A hot letter with the rest of the word in Hungarian and in English.
    #[must_use]
    pub const fn new(letter: char, hungarian: &'static str, english: &'static str) -> Hot {
        Hot { letter, rest: Words(hungarian, english) }
    }

    /// How wide it is in a language, in pixels: letters of eight pixels, the last of which is blank.
    pub fn width(&self, language: Language) -> i32 {
        let rest = self.rest.of(language).trim_end().chars().count();
        i32::try_from(8 * (1 + rest)).map_or(i32::MAX, |width| width - 1)
    }
}
