//! `grafika config`, and the user's preferences at a start.

use super::{Failure, meant, say};
use crate::disk::ConfigFile;
use crate::machine::{Keeper, Preference, Preferences};
use crate::screen::visible;
use serde_json::{Value, json};
use std::path::Path;

/// The user's preferences; what is wrong with them goes to stderr.
pub(super) fn preferences() -> Preferences {
    let (preferences, problems) = ConfigFile::read();
    problems.iter().for_each(|problem| say("grafika", problem));
    preferences
}

/// The setting of a name.
fn named(key: &str) -> Result<Preference, Failure> {
    Preference::from_key(key).ok_or_else(|| {
        let known = Preference::ALL.map(Preference::key);
        Failure::usage(format!(
            "there is no setting {key:?}{}; there are {}",
            meant(key, known),
            known.join(", ")
        ))
    })
}

/// `grafika config --json`: all settings with their values, or one.
///
/// # Errors
/// [`Failure`] when there is no such setting.
pub fn settings(key: Option<&str>) -> Result<Value, Failure> {
    let now = preferences();
    let chosen = match key {
        Some(key) => vec![named(key)?],
        None => Preference::ALL.to_vec(),
    };
    let told = |preference: &Preference| {
        let values = preference.values();
        let value = json!({ "value": now.get(*preference), "values": values });
        (preference.key().to_owned(), value)
    };
    Ok(Value::Object(chosen.iter().map(told).collect()))
}

/// `grafika config`: shows the settings, one setting, or changes it.
///
/// # Errors
/// [`Failure`] when there is no such setting or value, or it cannot be kept.
pub fn configure(key: Option<&str>, chosen: Option<&str>) -> Result<String, Failure> {
    let mut now = preferences();
    let Some(key) = key else {
        let mut text = ConfigFile::path().map_or(String::new(), |path| format!("# {}\n", path.display()));
        for preference in Preference::ALL {
            let values = preference.values().join(", ");
            let line = format!("{} = {:?}", preference.key(), now.get(preference));
            text += &if values.is_empty() { format!("{line}\n") } else { format!("{line:32} # {values}\n") };
        }
        return Ok(text);
    };
    let preference = named(key)?;
    if let Some(chosen) = chosen {
        now.set(preference, chosen).map_err(|problem| {
            Failure::usage(format!("{problem}{}", meant(chosen, preference.values().iter().copied())))
        })?;
        if preference == Preference::Folder && now.folder.as_deref().is_some_and(|it| !Path::new(it).is_dir())
        {
            return Err(Failure::work(format!("{chosen}: there is no such folder")));
        }
        ConfigFile.keep(&now).map_err(Failure::work)?;
    }
    Ok(format!("{}\n", visible(&now.get(preference))))
}
