//! The settings page (F9): preferences of all programs.

use super::desk::{Desk, Picture};
use super::frame::Area;
use super::notice::Stay;
use super::panel::{Panel, Row, Tab};
use super::words::{self, Phrase, Words};
use crate::machine::{Asked, Asking, Language, Preference, Preferences};
use crate::screen::{Color, Screen};

/// Where the page lies.
const PAGE: Area = Area::new(88, 110, 551, 355);
/// Letters of a value that the page has room for.
const ROOM: usize = 27;
const fn name(preference: Preference) -> Words {
    match preference {
        Preference::Language => Words("Nyelv", "Language"),
        Preference::Display => Words("Megjelenítés", "Display"),
        Preference::Scale => Words("Az ablak nagyítása", "Window scale"),
        Preference::Manner => Words("Viselkedés", "Behaviour"),
        Preference::Palette => Words("Színek", "Colours"),
        Preference::PointerSpeed => Words("Egérlépés (karakter)", "Mouse step (characters)"),
        Preference::Folder => Words("A fájlok mappája", "Folder for files"),
    }
}

/// The text of a value on the page.
fn shown(preference: Preference, value: &str, language: Language) -> String {
    let words = match (preference, value) {
        (Preference::Folder, "") => Words("(ahol elindul)", "(current folder)"),
        (_, "auto") => Words("automatikus", "automatic"),
        (_, "hu") => Words("magyar", "magyar"),
        (_, "en") => Words("English", "English"),
        (_, "window") => Words("ablakban", "in a window"),
        (_, "terminal") => Words("a terminálban", "in the terminal"),
        (_, "vga") => Words("VGA", "VGA"),
        (_, "today") => Words("mai", "modern"),
        (_, "1997") => Words("mint 1997-ben", "as in 1997"),
        (_, "amber") => Words("borostyán", "amber"),
        (_, "green") => Words("zöld", "green"),
        (_, "contrast") => Words("nagy kontraszt", "high contrast"),
        (_, "colorblind") => Words("színtévesztőknek", "colour-blind safe"),
        (_, other) => {
            // The end of a long path says more than its beginning.
            let letters = other.chars().count();
            return other.chars().skip(letters.saturating_sub(ROOM)).collect();
        }
    };
    words.of(language).to_string()
}

/// The row of a preference.
fn row(preference: Preference) -> Row<Preferences> {
    let shown = |it: &Preferences, row: usize, language: Language| {
        let preference = Preference::ALL.get(row).copied().unwrap_or(Preference::Folder);
        shown(preference, &it.get(preference), language)
    };
    match preference {
        Preference::Folder => Row::Text {
            name: name(preference),
            caption: words::FOLDER_ENTRY,
            get: |it| it.get(Preference::Folder),
            shown,
            // Any text is accepted; whether the folder exists shows when a file is saved.
            set: |it, folder| drop(it.set(Preference::Folder, folder)),
        },
        _ => Row::Choice {
            name: name(preference),
            shown,
            turn: |it, row, forward| {
                Preference::ALL.get(row).into_iter().for_each(|&preference| it.turn(preference, forward));
            },
        },
    }
}

impl Desk<'_> {
    /// The key F9: shows the settings over the program's picture until Esc; every change counts at once and is
    /// kept.
    pub(super) async fn settings(&mut self, under: &dyn Picture) -> Asked<()> {
        // The 16 colours with the present palette.
        let colors = Row::Preview(2, |_: &Preferences, screen: &mut Screen, area: Area| {
            for (x, color) in (area.x1 + 4..).step_by(27).zip(Color::ALL) {
                screen.bar(x, area.y1 + 13, x + 26, area.y1 + 27, color);
            }
        });
        let rows = Preference::ALL.into_iter().map(row).chain([colors]).collect();
        let tabs = vec![Tab { name: words::SETTINGS, rows }];
        let mut panel =
            Panel { area: PAGE, title: words::SETTINGS, keys: words::SETTINGS_KEYS, tabs, chosen: [0, 0] };
        let mut preferences = self.machine.preferences();
        while self.panel(under, &mut panel, &mut preferences).await.unless_cancelled()?.is_some() {
            if let Err(problem) = self.machine.set_preferences(preferences.clone()) {
                self.tell(Phrase::plain(&problem), Stay::UntilRead);
            }
        }
        Ok(())
    }
}
