//! The file that preferences are kept in: `config.toml` of the program's folder among the user's settings. What
//! is wrong in it is told and left alone; it never keeps a program from starting.

use super::Failure;
use crate::machine::{Keeper, Preference, Preferences, UserFolder, write_safely};
use std::path::{Path, PathBuf};
use toml_edit::{DocumentMut, Item, Value, value};

/// Where the settings are: `config.toml` in [`UserFolder::Config`]. `None` when the environment names no such
/// place.
pub fn config_path() -> Option<PathBuf> {
    UserFolder::Config.path().map(|folder| folder.join("config.toml"))
}

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

/// The user's preferences; what is wrong with them goes to stderr.
pub(super) fn preferences() -> Preferences {
    let Some(path) = config_path() else { return Preferences::default() };
    match std::fs::read_to_string(&path) {
        Ok(text) => {
            let (preferences, problems) = read(&text);
            problems.iter().for_each(|problem| eprintln!("{}: {problem}", path.display()));
            preferences
        }
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Preferences::default(),
        Err(error) => {
            eprintln!("{}: {error}", path.display());
            Preferences::default()
        }
    }
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

/// The file of settings as a machine's keeper.
#[derive(Debug)]
pub(super) struct ConfigFile;

impl Keeper for ConfigFile {
    fn keep(&mut self, preferences: &Preferences) -> Result<(), String> {
        let path = config_path().ok_or("the environment names no home folder to keep settings in")?;
        let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(told(&error)),
        };
        let text = written(&text, preferences).map_err(|error| told(&error))?;
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|error| told(&error))?;
        }
        write_safely(&path, text.as_bytes()).map_err(|error| told(&error))
    }
}

/// `grafika config`: shows the settings, one setting, or changes it.
///
/// # Errors
/// [`Failure`] when there is no such setting or value, or it cannot be kept.
pub fn configure(key: Option<&str>, chosen: Option<&str>) -> Result<String, Failure> {
    let mut now = preferences();
    let Some(key) = key else {
        let mut text = config_path().map_or(String::new(), |path: PathBuf| format!("# {}\n", path.display()));
        for preference in Preference::ALL {
            let values = preference.values().join(", ");
            let line = format!("{} = {:?}", preference.key(), now.get(preference));
            text += &if values.is_empty() { format!("{line}\n") } else { format!("{line:32} # {values}\n") };
        }
        return Ok(text);
    };
    let preference = Preference::from_key(key).ok_or_else(|| {
        let known = Preference::ALL.map(Preference::key).join(", ");
        Failure::usage(format!("there is no setting {key:?}; there are {known}"))
    })?;
    if let Some(chosen) = chosen {
        now.set(preference, chosen).map_err(Failure::usage)?;
        if preference == Preference::Folder && now.folder.as_deref().is_some_and(|it| !Path::new(it).is_dir())
        {
            return Err(Failure::work(format!("{chosen}: there is no such folder")));
        }
        ConfigFile.keep(&now).map_err(Failure::work)?;
    }
    Ok(format!("{}\n", now.get(preference)))
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
