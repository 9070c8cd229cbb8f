//! What a user may say about a table, where the table itself does not tell.

use super::super::FileError;
use std::fmt;
use std::str::FromStr;

/// What a user says about a table; all that is left out follows from the table, or is asked for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableOptions {
    /// The columns of the coordinates.
    pub columns: Option<Columns>,
    /// What separates the cells of a row.
    pub delimiter: Option<Delimiter>,
    /// The sign in front of the fraction of a number.
    pub decimal: Option<Decimal>,
}

impl TableOptions {
    /// The command line's option for the first that is given.
    #[must_use]
    pub fn given(&self) -> Option<&'static str> {
        let given = [
            (Self::COLUMNS, self.columns.is_some()),
            (Self::DELIMITER, self.delimiter.is_some()),
            (Self::DECIMAL, self.decimal.is_some()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(name, _)| name)
    }

    /// The options by the names that messages give them.
    pub(super) const COLUMNS: &'static str = "--columns";
    pub(super) const DELIMITER: &'static str = "--delimiter";
    pub(super) const DECIMAL: &'static str = "--decimal";
}

/// What separates the cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Delimiter {
    /// A comma.
    Comma,
    /// A semicolon, as spreadsheets write where the decimal sign is a comma.
    Semicolon,
    /// A tab.
    Tab,
    /// Any number of blanks and tabs.
    Blanks,
}

impl Delimiter {
    /// Every delimiter; those that are looked for first stand first.
    pub(in crate::file) const ALL: [Self; 4] = [Self::Tab, Self::Semicolon, Self::Comma, Self::Blanks];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Comma => "comma",
            Self::Semicolon => "semicolon",
            Self::Tab => "tab",
            Self::Blanks => "blanks",
        }
    }

    /// Its sign; a blank stands for any number of them.
    #[must_use]
    pub fn sign(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Semicolon => ';',
            Self::Tab => '\t',
            Self::Blanks => ' ',
        }
    }
}

impl FromStr for Delimiter {
    type Err = FileError;

    /// By its name, or by the sign itself.
    fn from_str(text: &str) -> Result<Self, FileError> {
        let is = |delimiter: &Self| {
            text.eq_ignore_ascii_case(delimiter.name()) || text.chars().eq([delimiter.sign()])
        };
        match (Self::ALL.into_iter().find(is), text) {
            (Some(delimiter), _) => Ok(delimiter),
            (None, "\\t") => Ok(Self::Tab),
            (None, _) => Err(FileError::Invalid("there are comma, semicolon, tab and blanks".to_owned())),
        }
    }
}

/// The sign in front of the fraction of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Decimal {
    /// A point, as in 1.5.
    Point,
    /// A comma, as in 1,5.
    Comma,
}

impl Decimal {
    /// The sign.
    #[must_use]
    pub fn sign(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }
}

impl fmt::Display for Decimal {
    /// Its name on the command line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Point => "point",
            Self::Comma => "comma",
        })
    }
}

impl FromStr for Decimal {
    type Err = FileError;

    /// By its name, or by the sign itself.
    fn from_str(text: &str) -> Result<Self, FileError> {
        match text.to_ascii_lowercase().as_str() {
            "point" | "dot" | "." => Ok(Self::Point),
            "comma" | "," => Ok(Self::Comma),
            _ => Err(FileError::Invalid("there are point and comma".to_owned())),
        }
    }
}

/// The columns of the coordinates: two for points of the plane, three for points in space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns(Vec<Column>);

/// A column as a user names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::file) enum Column {
    /// By its number, from 1.
    Number(usize),
    /// By its name.
    Name(String),
}

impl Columns {
    /// Whether all of them are numbers.
    pub(in crate::file) fn are_numbers(&self) -> bool {
        self.0.iter().all(|column| matches!(column, Column::Number(_)))
    }

    /// The columns in the order of the axes.
    pub(in crate::file) fn list(&self) -> &[Column] {
        &self.0
    }
}

impl FromStr for Columns {
    type Err = FileError;

    /// Two or three names, or numbers from 1, with commas between them.
    fn from_str(text: &str) -> Result<Self, FileError> {
        let column = |word: &str| match word.parse() {
            Ok(number) => Column::Number(number),
            Err(_) => Column::Name(word.to_owned()),
        };
        let words: Vec<&str> = text.split(',').map(str::trim).collect();
        let columns: Vec<Column> = words.iter().map(|word| column(word)).collect();
        let usable = |(index, column): (usize, &Column)| {
            !matches!(column, Column::Number(0)) && !columns[..index].contains(column)
        };
        let named = words.iter().all(|word| !word.is_empty());
        match (2..=3).contains(&columns.len()) && named && columns.iter().enumerate().all(usable) {
            true => Ok(Self(columns)),
            false => {
                let wanted = "give two or three different names, or numbers from 1, as in x,y or 2,3,5";
                Err(FileError::Invalid(wanted.to_owned()))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_signs() {
        for delimiter in Delimiter::ALL {
            assert_eq!(delimiter.name().parse(), Ok(delimiter));
            assert_eq!(delimiter.sign().to_string().parse(), Ok(delimiter));
        }
        assert_eq!("\\t".parse(), Ok(Delimiter::Tab));
        for decimal in [Decimal::Point, Decimal::Comma] {
            assert_eq!(decimal.to_string().parse(), Ok(decimal));
            assert_eq!(decimal.sign().to_string().parse(), Ok(decimal));
        }
    }

    #[test]
    fn columns_by_name_and_number() {
        let columns: Columns = "time, 3".parse().unwrap();
        assert_eq!(columns.list(), [Column::Name("time".to_owned()), Column::Number(3)]);
        for wrong in ["", "x", "x,", "1,2,3,4", "0,1", "2,2", "a,b,a"] {
            assert!(wrong.parse::<Columns>().is_err(), "{wrong}");
        }
    }
}
