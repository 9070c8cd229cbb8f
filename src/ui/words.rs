//! Every text that the user sees, in Hungarian and English. The hot letters are the same in both, so
//! that scripts and habits work in either language.

use crate::machine::{Language, StorageError, StorageProblem};
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

/// A text that is put together while the program runs, in both languages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phrase {
    hungarian: Cow<'static, str>,
    english: Cow<'static, str>,
}

impl Phrase {
    /// A phrase of its two texts.
    pub fn new(hungarian: impl Into<Cow<'static, str>>, english: impl Into<Cow<'static, str>>) -> Phrase {
        Phrase { hungarian: hungarian.into(), english: english.into() }
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

/// What stands behind a hot letter on a button or in an answer: the letter and the rest of the word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hot {
    /// The hot letter or digit, in upper case.
    pub letter: char,
    /// The rest of the text.
    pub rest: Words,
}

const fn hot(letter: char, hungarian: &'static str, english: &'static str) -> Hot {
    Hot { letter, rest: Words(hungarian, english) }
}

// Answers.
pub(crate) const YES: Hot = hot('I', "gen", "-yes");
pub(crate) const NO: Hot = hot('N', "em", "-no");
pub(crate) const NEW: Hot = hot('U', "j", "-new");
pub(crate) const STORED: Hot = hot('T', "árolt", "-file");
pub(crate) const OPEN: Hot = hot('N', "yitott", "-open");
pub(crate) const CLOSED: Hot = hot('Z', "árt", "-ring");
pub(crate) const NUMBER: Hot = hot('S', "orszám", "-numb.");
pub(crate) const PLACE: Hot = hot('H', "ely", "-place");
pub(crate) const TWO: Hot = hot('2', "", "");
pub(crate) const THREE: Hot = hot('3', "", "");

// Command buttons of the curve programs.
pub(crate) const CHANGE: Hot = hot('V', "álaszt", "-change");
pub(crate) const QUIT: Hot = hot('Q', "-kilép", "-quit");
pub(crate) const RESULT: Hot = hot('E', "redmény", "-result");
pub(crate) const INSERT: Hot = hot('B', "eszúr", "-insert");
pub(crate) const DELETE: Hot = hot('T', "öröl", "-delete");
pub(crate) const CURVE: Hot = hot('G', "örbe", "-curve");

// Method buttons.
pub(crate) const COONS: Hot = hot('1', " Coons", " Coons");
pub(crate) const BEZIER: Hot = hot('2', " Bézier", " Bézier");
pub(crate) const SPLINE: Hot = hot('3', " Spline", " Spline");
pub(crate) const B_SPLINE: Hot = hot('4', " B-spl.", " B-spl.");

// Questions. The blanks centre them as in the original.
pub(crate) const ASK_END: Words = Words("Vége a munkának ?", "End of work ?");
pub(crate) const ASK_NEW: Words = Words("Uj konfiguráció ?", "New configuration ?");
pub(crate) const ASK_SAVE: Words = Words("Menteni a konfigurációt ?", "Save the configuration ?");
pub(crate) const ASK_CONFIGURATION: Words = Words("Konfiguráció ?", "Configuration ?");
pub(crate) const ASK_SHAPE: Words = Words("Görbe alakja ?", "Shape of the curve ?");
pub(crate) const ASK_DEGREE: Words = Words("Polinomok foka ?", "Degree ?");
pub(crate) const ASK_CHANGE: Words = Words("Mi változik ?", "What changes ?");
pub(crate) const ASK_POINTS: Words = Words(" Kontrollpontok látszanak ?", "  Show control points ?");
pub(crate) const FILE_NAME: Words = Words("File neve ?", "File name ?");
pub(crate) const NO_SUCH_FILE: Words = Words("Nincs ilyen file", "No such file");

// Entries.
pub(crate) const NUMBER_ENTRY: Words = Words("Sorszám:", "Number:");
pub(crate) const PLACE_ENTRY: Words = Words("Hely:", "Place");
pub(crate) const COEFFICIENT: Words = Words("együttható = ", "coefficient =");

// The plane editor.
pub(crate) const STORE: Words = Words("Tár", "New");
pub(crate) const METHOD_TITLE: Words = Words("Interpolációs eljárás", "Interpolation method");
pub(crate) const BACK: Words = Words("ESC - vissza", "ESC - back");
pub(crate) const NO_DOT: Words = Words(
    "A névben nem lehet pont: legfeljebb 8 betű, szám vagy -",
    "A name has no dot: at most 8 letters, digits or -",
);

// The help page.
pub(crate) const HELP_UNDO: Words = Words("visszavonás, mégis", "undo, redo");
pub(crate) const HELP_HELP: Words = Words("ez a lap", "this page");
pub(crate) const HELP_LANGUAGE: Words = Words("nyelv: magyar, angol", "language: Hungarian, English");
pub(crate) const HELP_LARGEST: Words = Words("legnagyobb ablak és vissza", "largest window and back");
pub(crate) const HELP_PICTURE: Words = Words("a képernyő mentése PNG-be", "save the screen as PNG");
pub(crate) const HELP_ESC: Words = Words("kérdés, beírás elvetése", "cancel a question or an entry");
pub(crate) const HELP_LEAVE: Words = Words("Vissza: bármely billentyű", "Back: any key");

/// An error that has its sentence in English only.
pub(crate) fn plain(error: &dyn std::fmt::Display) -> Phrase {
    let text = error.to_string();
    Phrase::new(text.clone(), text)
}

/// What is wrong with a stored file.
pub(crate) fn storage_problem(error: &StorageError) -> Phrase {
    let StorageError { name, problem } = error;
    let hungarian = match problem {
        StorageProblem::NotFound => format!("{name}: nincs ilyen file"),
        StorageProblem::BadName(_) => format!("{name}: nem használható név"),
        StorageProblem::System(message) => format!("{name}: {message}"),
    };
    Phrase::new(hungarian, error.to_string())
}
