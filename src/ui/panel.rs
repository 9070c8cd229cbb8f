//! A panel: a page of rows over the program's picture, which stays open while its values change.

use super::desk::{Desk, Picture, Wake};
use super::entry::Accepts;
use super::frame::{Area, panel};
use super::save::line_entry;
use super::words::{self, Words};
use super::{Number, Stay};
use crate::machine::{Asked, Asking, Key, Language, Stop, Tick};
use crate::screen::{Color, Screen};
use std::ops::RangeInclusive;

/// A row of a panel over a model. Functions get the row's number, so that rows of one kind share them.
pub enum Row<M: 'static> {
    /// A number to type.
    Value {
        /// Its name.
        name: Words,
        /// The present number.
        get: fn(&M) -> f64,
        /// Sets another one.
        set: fn(&mut M, f64),
        /// Its range.
        range: RangeInclusive<f64>,
    },
    /// A text to type, under a caption.
    Text {
        /// Its name.
        name: Words,
        /// The caption above the entry.
        caption: Words,
        /// The present text.
        get: fn(&M) -> String,
        /// The text as it is shown.
        shown: fn(&M, usize, Language) -> String,
        /// Sets another one.
        set: fn(&mut M, &str),
    },
    /// A choice among several values.
    Choice {
        /// Its name.
        name: Words,
        /// The choice as it is shown.
        shown: fn(&M, usize, Language) -> String,
        /// Chooses the next value (`true`) or the previous one.
        turn: fn(&mut M, usize, bool),
    },
    /// A button.
    Button(Words),
    /// A picture of the result, with its height in rows.
    Preview(i32, fn(&M, &mut Screen, Area)),
}

/// Rows under a name.
pub struct Tab<M: 'static> {
    /// The name, shown where there are several.
    pub name: Words,
    /// The rows.
    pub rows: Vec<Row<M>>,
}

/// A panel with the chosen row.
pub struct Panel<M: 'static> {
    /// Where it lies.
    pub area: Area,
    /// Its title.
    pub title: Words,
    /// The line about its keys.
    pub keys: Words,
    /// Its tabs.
    pub tabs: Vec<Tab<M>>,
    /// The tab and the row that are chosen.
    pub chosen: [usize; 2],
}

/// An action of the user on a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Done {
    /// Changed a value.
    Changed,
    /// Pressed the button of a row of the present tab.
    Pressed(usize),
    /// Changed nothing on the panel, but perhaps a preference, by a key of the desk.
    Nothing,
}

/// Height of a row, and distance of values from the left edge.
const LINE: i32 = 20;
const VALUES: i32 = 232;
/// Greatest length of a text.
const LONGEST: usize = 250;

impl<M> Panel<M> {
    fn rows(&self) -> &[Row<M>] {
        self.tabs.get(self.chosen[0]).map_or(&[], |tab| &tab.rows)
    }

    /// The rows of the present tab and where they stand.
    fn lines(&self) -> impl Iterator<Item = (usize, &Row<M>, Area)> {
        let mut y = self.area.y1 + 34;
        self.rows().iter().enumerate().map(move |(index, row)| {
            let high = if let Row::Preview(rows, _) = row { rows * LINE } else { LINE };
            let area = Area::new(self.area.x1 + 12, y, self.area.x2 - 12, y + high - 1);
            y += high;
            (index, row, area)
        })
    }

    /// Where the names of the tabs stand, if there are several.
    fn tab_areas(&self) -> impl Iterator<Item = (usize, &Tab<M>, Area)> {
        let tabs = if self.tabs.len() > 1 { self.tabs.as_slice() } else { &[] };
        let left = |index: usize| self.area.x1 + 100 + 90 * i32::try_from(index).unwrap_or(0);
        let y = self.area.y1 + 8;
        tabs.iter()
            .enumerate()
            .map(move |(index, tab)| (index, tab, Area::new(left(index), y, left(index) + 86, y + 16)))
    }

    fn draw(&self, model: &M, screen: &mut Screen, language: Language) {
        let Area { x1, y1, x2, y2 } = self.area;
        panel(screen, x1, y1, x2 - x1, y2 - y1);
        screen.text(x1 + 16, y1 + 12, self.title.of(language), Color::LightRed);
        for (index, tab, area) in self.tab_areas() {
            let ink = if index == self.chosen[0] { Color::LightRed } else { Color::Black };
            screen.text(area.x1, area.y1 + 4, tab.name.of(language), ink);
        }
        for (index, row, area) in self.lines() {
            let (name, value) = match row {
                Row::Value { name, get, .. } => (*name, get(model).to_string()),
                Row::Text { name, shown, .. } | Row::Choice { name, shown, .. } => {
                    (*name, shown(model, index, language))
                }
                Row::Button(name) => (*name, String::new()),
                Row::Preview(_, draw) => {
                    draw(model, screen, area);
                    continue;
                }
            };
            if index == self.chosen[1] {
                screen.bar(area.x1, area.y1, area.x2, area.y2, Color::White);
            }
            screen.text(x1 + 16, area.y1 + 6, name.of(language), Color::Black);
            screen.text(x1 + VALUES, area.y1 + 6, &value, Color::Blue);
            if let (Row::Choice { .. }, true) = (row, index == self.chosen[1]) {
                screen.text(x1 + VALUES - 16, area.y1 + 6, "<", Color::LightRed);
                screen.text(x2 - 28, area.y1 + 6, ">", Color::LightRed);
            }
        }
        screen.text(x1 + 16, y2 - 30, self.keys.of(language), Color::Black);
    }

    /// Opens a tab at its first row that is not a picture.
    fn open_tab(&mut self, tab: usize) {
        self.chosen = [tab, 0];
        if matches!(self.rows().first(), Some(Row::Preview(..))) {
            self.step(1);
        }
    }

    /// Chooses the next or the previous row, wrapping around.
    fn step(&mut self, by: usize) {
        let count = self.rows().len().max(1);
        for _ in 0..count {
            self.chosen[1] = (self.chosen[1] + by) % count;
            if !matches!(self.rows().get(self.chosen[1]), Some(Row::Preview(..))) {
                return;
            }
        }
    }

    /// Moves over the panel. Whether the chosen row shall be carried out: forward, or back.
    fn react(&mut self, tick: &Tick) -> Option<bool> {
        let count = self.rows().len().max(1);
        if let Some((x, y)) = tick.click() {
            let tab = self.tab_areas().find(|(.., area)| area.holds(x, y)).map(|(index, ..)| index);
            if let Some(tab) = tab {
                self.open_tab(tab);
            }
            let hit =
                self.lines().find(|(_, row, area)| area.holds(x, y) && !matches!(row, Row::Preview(..)));
            let (index, ..) = hit.filter(|_| tab.is_none())?;
            let again = index == self.chosen[1];
            self.chosen[1] = index;
            let value = x - self.area.x1 - VALUES;
            return match self.rows().get(index) {
                // Left of a choice turns it back, the choice itself and what is right of it forward.
                Some(Row::Choice { .. }) if value >= -24 => Some(value >= -4),
                Some(Row::Button(_)) => Some(true),
                _ => again.then_some(true),
            };
        }
        match tick.key()? {
            Key::Up => self.step(count - 1),
            Key::Down => self.step(1),
            Key::Tab => self.open_tab((self.chosen[0] + 1) % self.tabs.len().max(1)),
            // Only a choice has a previous value.
            Key::Left if !matches!(self.rows().get(self.chosen[1]), Some(Row::Choice { .. })) => {}
            Key::Left => return Some(false),
            Key::Right | Key::Enter | Key::Char(' ') => return Some(true),
            _ => {}
        }
        None
    }
}

impl Desk<'_> {
    /// Shows a panel over the program's picture until the user acts on it. To be called repeatedly until Esc.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn panel<M>(
        &mut self,
        under: &dyn Picture,
        panel: &mut Panel<M>,
        model: &mut M,
    ) -> Asked<Done> {
        loop {
            let draw = |screen: &mut Screen, language: Language| {
                under.draw(screen, language);
                panel.draw(model, screen, language);
            };
            let tick = self.event_within(&draw, Wake::Preference).await?;
            match tick.key() {
                Some(Key::Esc | Key::F(9)) => return Err(Stop::Cancelled),
                Some(Key::F(_) | Key::CtrlF(_)) => return Ok(Done::Nothing),
                _ => {}
            }
            let Some(forward) = panel.react(&tick) else { continue };
            let index = panel.chosen[1];
            let draw = |screen: &mut Screen, language: Language| {
                under.draw(screen, language);
                panel.draw(model, screen, language);
            };
            match panel.rows().get(index) {
                Some(Row::Value { get, set, range, .. }) => {
                    let entry = line_entry(LONGEST, Accepts::Number).proposing(get(model).to_string());
                    let typed = self.type_line(&draw, words::NEW_NUMBER, entry).await.unless_cancelled()?;
                    let Some(typed) = typed else { return Ok(Done::Nothing) };
                    match Number::Real(f64::MIN..=f64::MAX).read(&typed).filter(|it| range.contains(it)) {
                        Some(number) => set(model, number),
                        None => {
                            self.tell(words::out_of(range), Stay::Briefly);
                            continue;
                        }
                    }
                }
                Some(Row::Text { caption, get, set, .. }) => {
                    let entry = line_entry(LONGEST, Accepts::Text).proposing(get(model));
                    let typed = self.type_line(&draw, *caption, entry).await.unless_cancelled()?;
                    let Some(typed) = typed else { return Ok(Done::Nothing) };
                    set(model, &typed);
                }
                Some(Row::Choice { turn, .. }) => turn(model, index, forward),
                Some(Row::Button(_)) => return Ok(Done::Pressed(index)),
                Some(Row::Preview(..)) | None => continue,
            }
            return Ok(Done::Changed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Event, Machine, Memory, Session, Settings};
    use crate::ui::Manual;
    use std::time::Duration;

    const NAME: Words = Words("név", "name");

    fn panel() -> Panel<[f64; 2]> {
        let value = || Row::Value {
            name: NAME,
            get: |it: &[f64; 2]| it[0],
            set: |it: &mut [f64; 2], to| it[0] = to,
            range: 0.0..=9.0,
        };
        let picture = Row::Preview(3, |it: &[f64; 2], screen: &mut Screen, area: Area| {
            screen.bar(area.x1, area.y1, area.x1 + it[0] as i32, area.y2, Color::Yellow);
        });
        let turn = |it: &mut [f64; 2], _: usize, forward: bool| it[1] += if forward { 1.0 } else { -1.0 };
        let choice = Row::Choice { name: NAME, shown: |it: &[f64; 2], _, _| it[1].to_string(), turn };
        let tabs = vec![
            Tab { name: NAME, rows: vec![value(), picture] },
            Tab { name: NAME, rows: vec![choice, Row::Button(NAME)] },
        ];
        Panel { area: Area::new(88, 120, 551, 345), title: NAME, keys: NAME, tabs, chosen: [0, 0] }
    }

    /// The model after keys, the row of the button that was pressed last, and a pixel of the preview.
    fn after(keys: &str) -> (Vec<f64>, Option<usize>, Option<Color>) {
        let key = |key| match key {
            '>' => Key::Right,
            '<' => Key::Left,
            'v' => Key::Down,
            't' => Key::Tab,
            'e' => Key::Enter,
            'b' => Key::Backspace,
            'x' => Key::Esc,
            digit => Key::Char(digit),
        };
        after_events(keys.chars().map(key).map(Event::Key))
    }

    fn after_events(events: impl Iterator<Item = Event>) -> (Vec<f64>, Option<usize>, Option<Color>) {
        let manual = Manual { name: "panel", about: NAME, intro: Words("", ""), keys: &[], lesson: &[] };
        let machine = Machine::new(Box::new(Memory::default()), Settings::default());
        let mut session = Session::start(machine, move |mut machine| async move {
            let (mut panel, mut model) = (panel(), [5.0, 0.0]);
            let mut desk = Desk::new(&mut machine, manual);
            let mut pressed = None;
            loop {
                desk.machine.publish((model.to_vec(), pressed));
                match desk
                    .panel(
                        &|screen: &mut Screen, _: Language| screen.clear(Color::Black),
                        &mut panel,
                        &mut model,
                    )
                    .await
                {
                    Ok(Done::Changed | Done::Nothing) => {}
                    Ok(Done::Pressed(row)) => pressed = Some(row),
                    Err(stop) => return Err(stop),
                }
            }
        });
        events.for_each(|event| session.send(event, Duration::ZERO));
        let preview = session.screen().pixel(104, 180);
        let model = session.model().unwrap().unwrap();
        let (values, pressed): (Vec<f64>, Option<usize>) = serde_json::from_str(&model).unwrap();
        (values, pressed, preview)
    }

    #[test]
    fn values_are_typed_and_the_preview_follows() {
        let (values, _, preview) = after("eb7e");
        assert_eq!((values[0], preview), (7.0, Some(Color::Yellow)));
        assert_eq!(after("eb3e").2, Some(Color::LightCyan));
        // Out of range: it says so and keeps the value.
        assert_eq!(after("e5e").0[0], 5.0);
    }

    #[test]
    fn esc_ends_and_left_only_turns_choices() {
        // A key after Esc reaches nobody.
        assert_eq!(after("t>x>").0, [5.0, 1.0]);
        assert_eq!(after("tv<").1, None);
        assert_eq!(after("<7").0, [5.0, 0.0]);
    }

    #[test]
    fn clicks_choose_rows_and_turn_values_either_way() {
        let click = |x, y| [Event::Move(x, y), Event::Press(crate::machine::Button::Left)];
        // The second tab: a choice in its first row, a button in the second.
        let clicked = |places: &[(i32, i32)]| {
            let tab = [Event::Key(Key::Tab), Event::Key(Key::Down)];
            after_events(tab.into_iter().chain(places.iter().flat_map(|&(x, y)| click(x, y))))
        };
        let (left, value, right) = ((88 + 232 - 12, 164), (88 + 236, 164), (530, 164));
        assert_eq!(clicked(&[value]).0[1], 1.0);
        assert_eq!(clicked(&[right, right, left]).0[1], 1.0);
        assert_eq!(clicked(&[left]).0[1], -1.0);
        // The name only chooses the row.
        assert_eq!(clicked(&[(110, 164)]).0[1], 0.0);
        assert_eq!(clicked(&[(110, 184)]).1, Some(1));
    }

    #[test]
    fn tabs_hold_rows_of_their_own() {
        assert_eq!(after("t>>").0, [5.0, 2.0]);
        assert_eq!(after("t<").0, [5.0, -1.0]);
        assert_eq!(after("tve").1, Some(1));
    }
}
