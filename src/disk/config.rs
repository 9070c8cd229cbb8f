//! The file that preferences are kept in: `config.toml` of the program's folder among the user's settings. What
//! is wrong in it is told and left alone; it never keeps a program from starting.

use super::{UserFolder, read_regular, reason, text, write_safely};
use crate::machine::{Keeper, Preference, Preferences};
use std::path::PathBuf;
use std::{fs, io};
use toml_edit::{DocumentMut, Item, Value, value};

/// The preferences of a text, and what is wrong with it.
fn read(text: &str) -> (Preferences, Vec<String>) {
    let mut preferences = Preferences::default();
    let document: DocumentMut = match text.parse() {
        Ok(document) => document,
        Err(error) => return (preferences, vec![format!("{error}").trim().replace('\n', " ")]),
    };
    let mut problems = Vec::new();
    for (key, item) in document.iter() {
        let Some(preference) = Preference::from_key(key) else {
            let known = Preference::ALL.map(Preference::key).join(", ");
            problems.push(format!("there is no setting {key:?}; there are {known}"));
            continue;
        };
        let text = match item {
            Item::Value(Value::String(text)) => text.value().clone(),
            Item::Value(Value::Integer(number)) => number.value().to_string(),
            _ => {
                problems.push(format!("{key} should be a text in quotes or a whole number"));
                continue;
            }
        };
        problems.extend(preferences.set(preference, &text).err());
    }
    (preferences, problems)
}

/// The text of a file with some preferences in it; comments and what is unknown stay.
fn written(text: &str, preferences: &Preferences) -> Result<String, String> {
    let mut document: DocumentMut =
        text.parse().map_err(|error| format!("{error}").trim().replace('\n', " "))?;
    let default = Preferences::default();
    for preference in Preference::ALL {
        let chosen = preferences.get(preference);
        if chosen == default.get(preference) {
            document.remove(preference.key());
            continue;
        }
        let new = match chosen.parse::<i64>() {
            Ok(number) => value(number),
            Err(_) => value(chosen),
        };
        match document.get_mut(preference.key()).and_then(Item::as_value_mut) {
            // The comment behind it stays.
            Some(old) => {
                let decor = old.decor().clone();
                *old = new.into_value().map_err(|_| "a setting is a value".to_string())?;
                *old.decor_mut() = decor;
            }
            None => {
                document.insert(preference.key(), new);
            }
        }
    }
    Ok(document.to_string())
}

/// The file of settings, also as a machine's keeper.
#[derive(Clone, Copy, Debug)]
pub struct ConfigFile;

impl ConfigFile {
    /// Where the settings are: `config.toml` in [`UserFolder::Config`]. `None` when the environment names no such
    /// place.
    #[must_use]
    pub fn path() -> Option<PathBuf> {
        UserFolder::Config.path().map(|folder| folder.join("config.toml"))
    }

    /// The user's preferences, and what is wrong with them, a line each.
    #[must_use]
    pub fn read() -> (Preferences, Vec<String>) {
        let Some(path) = ConfigFile::path() else { return Default::default() };
        let (preferences, problems) = match read_regular(&path).and_then(text) {
            Ok(text) => read(&text),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Default::default(),
            Err(error) => (Preferences::default(), vec![reason(&error)]),
        };
        let told = |problem| format!("{}: {problem}", path.display());
        (preferences, problems.into_iter().map(told).collect())
    }
}

impl Keeper for ConfigFile {
    fn keep(&mut self, preferences: &Preferences) -> Result<(), String> {
        let path = ConfigFile::path().ok_or("the environment names no home folder to keep settings in")?;
        let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let text = match read_regular(&path).and_then(text) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(told(&reason(&error))),
        };
        let text = written(&text, preferences).map_err(|error| told(&error))?;
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(|error| told(&reason(&error)))?;
        }
        write_safely(&path, text.as_bytes()).map_err(|error| told(&reason(&error)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Language;
    use crate::screen::Palette;

    #[test]
    fn settings_come_back_and_comments_stay() {
        let text = "# mine\nlanguage = \"hu\" # as in the book\nfuture = 3\nscale = 2\n";
        let (mut preferences, problems) = read(text);
        assert_eq!((preferences.language, preferences.scale), (Some(Language::Hungarian), Some(2)));
        assert!(problems.len() == 1 && problems[0].contains("\"future\""), "{problems:?}");
        preferences.language = Some(Language::English);
        preferences.scale = None;
        preferences.palette = Palette::Amber;
        let text = written(text, &preferences).unwrap();
        assert_eq!(text, "# mine\nlanguage = \"en\" # as in the book\nfuture = 3\npalette = \"amber\"\n");
        assert_eq!(read(&text).0, preferences);
    }

    #[test]
    fn what_is_wrong_is_told_and_the_rest_counts() {
        let (preferences, problems) =
            read("scale = \"big\"\npalette = \"green\"\ndisplay = [1]\nlanguage = 7\n");
        assert_eq!(preferences.palette, Palette::Green);
        assert_eq!(problems.len(), 3, "{problems:?}");
        let (preferences, problems) = read("palette = amber");
        assert_eq!((preferences, problems.len()), (Preferences::default(), 1));
        // A broken file is not written over.
        assert!(written("palette = amber", &Preferences::default()).is_err());
    }
}
