//! The settings page (F9): preferences of all programs.

use super::desk::{Desk, Picture};
use super::frame::Area;
use super::panel::{Done, Panel, Row, Tab};
use super::words::{self, Words};
use crate::machine::{Asked, Asking, Language, Preference, Preferences};
use crate::screen::{Color, Screen};

/// Where the page lies.
const PAGE: Area = Area::new(88, 70, 551, 395);
/// Letters of a value that the page has room for.
const ROOM: usize = 27;
const fn name(preference: Preference) -> Words {
    match preference {
        Preference::Language => Words("Nyelv", "Language"),
        Preference::Display => Words("Megjelenítés", "Display"),
        Preference::Scale => Words("Az ablak mérete", "Window size"),
        Preference::Look => Words("Az ablak képe", "Window look"),
        Preference::Manner => Words("Viselkedés", "Behaviour"),
        Preference::Palette => Words("Színek", "Colours"),
        Preference::Cloth => Words("Biliárdposztó", "Billiard cloth"),
        Preference::PointerSpeed => Words("Egérlépés (karakter)", "Pointer step (characters)"),
        Preference::Glyphs => Words("A terminál jelei", "Terminal characters"),
        Preference::Folder => Words("Fájlok mappája", "Folder for files"),
    }
}

/// The text of a value on the page.
fn shown(preference: Preference, value: &str, language: Language) -> String {
    let words = match (preference, value) {
        (Preference::Folder, "") => Words("az aktuális mappa", "the current folder"),
        (Preference::Glyphs, "ascii") => Words("betűk (ASCII)", "Letters (ASCII)"),
        (Preference::Glyphs, "blocks") => Words("negyedek, Braille", "Quarters, Braille"),
        (Preference::Glyphs, "unicode13") => Words("hatodok, ékek", "Sextants, wedges"),
        (Preference::Glyphs, "unicode16") => Words("nyolcadok", "Octants"),
        (_, "auto") => Words("automatikus", "Automatic"),
        (Preference::Cloth, "white") => Words("fehér", "White"),
        (Preference::Cloth, "green") => Words("zöld", "Green"),
        (Preference::Cloth, "blue") => Words("kék", "Blue"),
        (Preference::Look, "sharp") => Words("éles képpontok", "Sharp pixels"),
        (Preference::Look, "fill") => Words("kitölti az ablakot", "Fill the window"),
        (Preference::Look, "crt") => Words("képcső", "CRT"),
        (_, "hu") => Words("magyar", "magyar"),
        (_, "en") => Words("English", "English"),
        (_, "window") => Words("ablakban", "Window"),
        (_, "terminal") => Words("terminálban", "Terminal"),
        (_, "vga") => Words("VGA", "VGA"),
        (_, "today") => Words("mai", "Modern"),
        (_, "1997") => Words("1997-es", "As in 1997"),
        (_, "amber") => Words("borostyán", "Amber"),
        (_, "green") => Words("zöld", "Green"),
        (_, "contrast") => Words("nagy kontraszt", "High contrast"),
        (_, "colorblind") => Words("színtévesztőknek", "Colour-blind safe"),
        // A multiple of the picture's size.
        (Preference::Scale, times) => return format!("{times}x"),
        (_, other) => {
            // The end of a long path says more than its beginning.
            let letters = other.chars().count();
            return other.chars().skip(letters.saturating_sub(ROOM)).collect();
        }
    };
    words.of(language).to_string()
}

/// What the page is about.
struct Chosen {
    preferences: Preferences,
    /// What can be chosen here, row by row.
    offered: Vec<Preference>,
}

/// The row of a preference.
fn row(preference: Preference) -> Row<Chosen> {
    let shown = |it: &Chosen, row: usize, language: Language| {
        let preference = it.offered.get(row).copied().unwrap_or(Preference::Folder);
        shown(preference, &it.preferences.get(preference), language)
    };
    match preference {
        Preference::Folder => Row::Text {
            name: name(preference),
            caption: words::FOLDER_ENTRY,
            get: |it| it.preferences.get(Preference::Folder),
            shown,
            // Any text is accepted; whether the folder exists shows when a file is saved.
            set: |it, folder| drop(it.preferences.set(Preference::Folder, folder)),
        },
        _ => Row::Choice {
            name: name(preference),
            shown,
            turn: |it, row, forward| {
                let chosen = it.offered.get(row).copied();
                chosen.into_iter().for_each(|preference| it.preferences.turn(preference, forward));
            },
        },
    }
}

impl Desk<'_> {
    /// The key F9: shows the settings over the program's picture until Esc; every change counts at once and is
    /// kept.
    pub(super) async fn settings(&mut self, under: &dyn Picture) -> Asked<()> {
        // The 16 colours with the present palette.
        let colors = Row::Preview(2, |_: &Chosen, screen: &mut Screen, area: Area| {
            for (x, color) in (area.x1 + 4..).step_by(27).zip(Color::ALL) {
                screen.bar(x, area.y1 + 13, x + 26, area.y1 + 27, color);
            }
        });
        let close = Row::Button(words::SETTINGS_CLOSE);
        let offered = self.machine.offered_preferences();
        let rows = offered.iter().copied().map(row).chain([colors, close]).collect();
        let tabs = vec![Tab { name: words::SETTINGS, rows }];
        let mut panel =
            Panel { area: PAGE, title: words::SETTINGS, keys: words::SETTINGS_KEYS, tabs, chosen: [0, 0] };
        let mut chosen = Chosen { preferences: self.machine.preferences(), offered };
        loop {
            match self.panel(under, &mut panel, &mut chosen).await.unless_cancelled()? {
                // The language may have been changed by F2 meanwhile: only what was turned counts.
                Some(Done::Changed) => {
                    if let Some(&turned) = chosen.offered.get(panel.chosen[1]) {
                        let value = chosen.preferences.get(turned);
                        self.prefer(|it| drop(it.set(turned, &value)));
                    }
                }
                Some(Done::Nothing) => {}
                // The only button is that for going back.
                Some(Done::Pressed(_)) | None => return Ok(()),
            }
            chosen.preferences = self.machine.preferences();
        }
    }
}
