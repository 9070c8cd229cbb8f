//! The settings page (F9): what is chosen for all programs.

use super::desk::{Desk, Picture};
use super::entry::Accepts;
use super::frame::{Area, panel};
use super::notice::Stay;
use super::save::line_entry;
use super::words::{self, Phrase, Words};
use crate::machine::{Asked, Asking, Key, Language, Preference, Preferences};
use crate::screen::{Color, Screen};

/// The panel of the page, and where its lines begin.
const PAGE: Area = Area::new(88, 120, 551, 345);
const TOP: i32 = PAGE.y1 + 40;
const LINE: i32 = 20;
/// Where the values stand.
const VALUES: i32 = PAGE.x1 + 232;
/// Letters of a value that the page has room for.
const ROOM: usize = 27;
/// Letters that a folder may have.
const LONGEST_FOLDER: usize = 250;

/// What the page shows over the program's picture.
struct Page<'p> {
    under: &'p dyn Picture,
    preferences: Preferences,
    chosen: usize,
}

const fn name(preference: Preference) -> Words {
    match preference {
        Preference::Language => Words("Nyelv", "Language"),
        Preference::Display => Words("Hol jelenjen meg", "Where to show"),
        Preference::Scale => Words("Az ablak nagyítása", "Scale of the window"),
        Preference::Palette => Words("Színek", "Colours"),
        Preference::PointerSpeed => Words("Az egér lépése (betű)", "Mouse step (letters)"),
        Preference::Folder => Words("A fileok mappája", "Folder of the files"),
    }
}

/// What a value is called on the page.
fn shown(preference: Preference, value: &str, language: Language) -> String {
    let words = match (preference, value) {
        (Preference::Folder, "") => Words("(ahol indul)", "(where it starts)"),
        (_, "auto") => Words("magától", "automatic"),
        (_, "hu") => Words("magyar", "magyar"),
        (_, "en") => Words("English", "English"),
        (_, "window") => Words("ablakban", "in a window"),
        (_, "terminal") => Words("a terminálban", "in the terminal"),
        (_, "vga") => Words("VGA", "VGA"),
        (_, "amber") => Words("borostyán", "amber"),
        (_, "green") => Words("zöld", "green"),
        (_, "contrast") => Words("nagy kontraszt", "high contrast"),
        (_, "colorblind") => Words("színtévesztőknek", "colour-blind safe"),
        (_, other) => {
            // The end of a long path tells more than its beginning.
            let letters = other.chars().count();
            return other.chars().skip(letters.saturating_sub(ROOM)).collect();
        }
    };
    words.of(language).to_string()
}

impl Page<'_> {
    fn line(index: usize) -> Area {
        let y = TOP + LINE * i32::try_from(index).unwrap_or(0);
        Area::new(PAGE.x1 + 12, y - 6, PAGE.x2 - 12, y + 13)
    }
}

impl Picture for Page<'_> {
    fn draw(&self, screen: &mut Screen, language: Language) {
        self.under.draw(screen, language);
        panel(screen, PAGE.x1, PAGE.y1, PAGE.x2 - PAGE.x1, PAGE.y2 - PAGE.y1);
        screen.text(PAGE.x1 + 16, PAGE.y1 + 12, words::SETTINGS.of(language), Color::LightRed);
        for (index, preference) in Preference::ALL.into_iter().enumerate() {
            let area = Self::line(index);
            if index == self.chosen {
                screen.bar(area.x1, area.y1, area.x2, area.y2, Color::White);
            }
            let y = area.y1 + 6;
            screen.text(PAGE.x1 + 16, y, name(preference).of(language), Color::Black);
            let value = shown(preference, &self.preferences.get(preference), language);
            screen.text(VALUES, y, &value, Color::Blue);
        }
        // All 16 colours, as they are now.
        for (x, color) in (PAGE.x1 + 16..).step_by(27).zip(Color::ALL) {
            screen.bar(x, PAGE.y2 - 58, x + 26, PAGE.y2 - 44, color);
        }
        screen.text(PAGE.x1 + 16, PAGE.y2 - 30, words::SETTINGS_KEYS.of(language), Color::Black);
    }
}

impl Desk<'_> {
    /// The key F9: shows the settings over the program's picture until Esc; every change counts at once and is
    /// kept.
    pub(super) async fn settings(&mut self, under: &dyn Picture) -> Asked<()> {
        let mut page = Page { under, preferences: self.machine.preferences(), chosen: 0 };
        loop {
            let tick = self.event(&page).await?;
            let Some(&preference) = Preference::ALL.get(page.chosen) else { return Ok(()) };
            let last = Preference::ALL.len() - 1;
            let clicked = tick.click().map(|(x, y)| (0..=last).find(|&index| Page::line(index).holds(x, y)));
            let forward = match (tick.key(), clicked) {
                (_, Some(Some(index))) if index != page.chosen => {
                    page.chosen = index;
                    continue;
                }
                (_, Some(Some(_))) => true,
                (Some(Key::Up), _) => {
                    page.chosen = page.chosen.checked_sub(1).unwrap_or(last);
                    continue;
                }
                (Some(Key::Down), _) => {
                    page.chosen = if page.chosen == last { 0 } else { page.chosen + 1 };
                    continue;
                }
                (Some(Key::Left), _) => false,
                (Some(Key::Right | Key::Enter | Key::Char(' ')), _) => true,
                (Some(Key::Esc | Key::F(9)), _) => return Ok(()),
                _ => continue,
            };
            if preference == Preference::Folder {
                let entry =
                    line_entry(LONGEST_FOLDER, Accepts::Text).proposing(page.preferences.get(preference));
                let typed = self.type_line(&page, words::FOLDER_ENTRY, entry).await;
                let Some(folder) = typed.unless_cancelled()? else { continue };
                // Any text is a folder; whether there is one shows when a file is saved.
                let _ = page.preferences.set(preference, &folder);
            } else {
                page.preferences.turn(preference, forward);
            }
            if let Err(problem) = self.machine.set_preferences(page.preferences.clone()) {
                self.tell(Phrase::plain(&problem), Stay::UntilRead);
            }
        }
    }
}
