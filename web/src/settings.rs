//! Settings and best results, which the page keeps as text.

use crate::host::Host;
use grafika::machine::{Best, Bests, Keeper, Language, Preference, Preferences};
use std::collections::BTreeMap;
use std::rc::Rc;
use wasm_bindgen::JsValue;

/// The names under which the page keeps them.
const SETTINGS: &str = "settings";
const BESTS: &str = "bests";

/// Settings that mean nothing in a browser: where programs show themselves is the page, and its files have no folder.
const ELSEWHERE: [Preference; 5] = [
    Preference::Display,
    Preference::Scale,
    Preference::PointerSpeed,
    Preference::Glyphs,
    Preference::Folder,
];

fn offered(preference: Preference) -> bool {
    !ELSEWHERE.contains(&preference)
}

/// Why something could not be kept, in the browser's words.
fn told(error: &JsValue) -> String {
    error.as_string().unwrap_or_else(|| format!("{error:?}"))
}

/// The user's preferences. What cannot be read is as it is at first.
pub(crate) fn preferences(host: &Host) -> Preferences {
    let kept = host.recall(SETTINGS).and_then(|text| serde_json::from_str(&text).ok());
    let kept: BTreeMap<String, String> = kept.unwrap_or_default();
    let mut preferences = Preferences::default();
    for (key, value) in kept {
        if let Some(preference) = Preference::from_key(&key).filter(|it| offered(*it)) {
            let _ = preferences.set(preference, &value);
        }
    }
    preferences
}

/// The place of the preferences.
pub(crate) struct Settings(pub(crate) Rc<Host>);

impl Settings {
    /// Prefers a language, as the page is shown in it.
    pub(crate) fn speak(&mut self, language: Language) -> Result<(), String> {
        let preferences = Preferences { language: Some(language), ..preferences(&self.0) };
        self.keep(&preferences)
    }
}

impl Keeper for Settings {
    fn keep(&mut self, preferences: &Preferences) -> Result<(), String> {
        let chosen = Preference::ALL.into_iter().filter(|it| offered(*it));
        let kept: BTreeMap<_, _> = chosen.map(|it| (it.key(), preferences.get(it))).collect();
        let text = serde_json::to_string(&kept).map_err(|error| error.to_string())?;
        self.0.remember(SETTINGS, &text).map_err(|error| told(&error))
    }

    fn offers(&self, preference: Preference) -> bool {
        offered(preference)
    }
}

/// The place of the best results; read anew every time, since other pages keep theirs there too.
pub(crate) struct Results(pub(crate) Rc<Host>);

impl Results {
    fn all(&self) -> BTreeMap<String, Best> {
        self.0.recall(BESTS).and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }
}

impl Bests for Results {
    fn best(&self, game: &str) -> Option<Best> {
        self.all().get(game).copied()
    }

    fn keep(&mut self, game: &str, result: Best) -> Result<(), String> {
        let mut all = self.all();
        let best = all.get(game).map_or(result, |known| known.with(result));
        if all.insert(game.to_owned(), best) == Some(best) {
            return Ok(());
        }
        let text = serde_json::to_string(&all).map_err(|error| error.to_string())?;
        self.0.remember(BESTS, &text).map_err(|error| told(&error))
    }
}
