//! The painter's algorithm step by step (chapters 3.1, 4.4.2, 4.4.3): which step is shown, and what is told about it.

use super::desk::{KeyHelp, line};
use super::words::Words;
use crate::geometry::painter::{Painting, Step, Test};
use crate::machine::{Button, Event, Key, Language, Tick};
use crate::screen::{Color, Screen};
use serde::Serialize;

/// The key that begins it.
pub(crate) const PAINTER_KEY: Key = Key::F(8);
/// Its line on the help page.
pub(crate) const PAINTER_HELP: KeyHelp =
    line("F8", "a festő sorrendje, lapról lapra", "the painter's order, face by face");

/// The steps of a painting: nothing, then face by face, at last the picture by the depth of every pixel.
pub(crate) struct Steps {
    painting: Painting,
    at: usize,
    /// The pixels that are wrong now.
    wrong: Vec<[i32; 2]>,
}

/// The step as `dump` writes it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct StepsModel {
    /// How many faces are painted; one more than there are when the depths are shown.
    step: usize,
    faces: usize,
    left_out: usize,
    /// The face just painted, from 1, and the one that it was put before.
    face: Option<usize>,
    before: Option<usize>,
    /// Pixels of something nearer that it hides; wrong pixels so far and in the end.
    spoils: usize,
    wrong: usize,
    wrong_at_last: usize,
    /// Whether some order suits all pairs.
    possible: bool,
}

impl Steps {
    pub(crate) fn new(painting: Painting) -> Steps {
        Steps { painting, at: 0, wrong: Vec::new() }
    }

    fn count(&self) -> usize {
        self.painting.steps.len()
    }

    /// The steps of the faces that are painted; `None` for the picture by depth.
    pub(crate) fn painted(&self) -> Option<&[Step]> {
        self.painting.steps.get(..self.at)
    }

    /// The face just painted.
    pub(crate) fn last(&self) -> Option<&Step> {
        self.painted()?.last()
    }

    /// The pixels that are wrong now.
    pub(crate) fn wrong(&self) -> &[[i32; 2]] {
        &self.wrong
    }

    /// Finds the pixels that are wrong now.
    fn look(&mut self) {
        self.wrong = match self.last() {
            Some(step) if step.wrong > 0 => self.painting.wrong_after(self.at),
            _ => Vec::new(),
        };
    }

    pub(crate) fn model(&self) -> StepsModel {
        let last = self.last();
        StepsModel {
            step: self.at,
            faces: self.count(),
            left_out: self.painting.left_out.len(),
            face: last.map(|step| step.face + 1),
            before: last.and_then(|step| step.moved).map(|(face, _)| face + 1),
            spoils: last.map_or(0, |step| step.spoils),
            wrong: last.map_or(0, |step| step.wrong),
            wrong_at_last: self.painting.wrong.len(),
            possible: self.painting.possible,
        }
    }

    /// Takes up an event; returns `false` if it leaves the steps.
    pub(crate) fn heed(&mut self, tick: &Tick) -> bool {
        let (before, last) = (self.at, self.count() + 1);
        // Many faces are passed in twenty leaps.
        let leap = (self.count() / 20).max(1);
        let forth = |at: usize, by: usize| at.saturating_add(by).min(last);
        match tick.event {
            Some(Event::Key(Key::Esc)) => return false,
            Some(Event::Key(Key::Char(' ') | Key::Enter | Key::Right | Key::Down)) => {
                self.at = forth(self.at, 1);
            }
            Some(Event::Key(Key::Backspace | Key::Left | Key::Up)) => self.at = self.at.saturating_sub(1),
            Some(Event::Key(Key::PageDown)) => self.at = forth(self.at, leap),
            Some(Event::Key(Key::PageUp)) => self.at = self.at.saturating_sub(leap),
            Some(Event::Key(Key::Home)) => self.at = 0,
            Some(Event::Key(Key::End)) => self.at = last,
            Some(Event::Key(PAINTER_KEY)) => self.at = self.next_wrong(),
            Some(Event::Press(Button::Left)) => self.at = forth(self.at, 1),
            Some(Event::Wheel(by)) => {
                let by_leaps = leap.saturating_mul(usize::try_from(by.unsigned_abs()).unwrap_or(0));
                self.at = if by < 0 { forth(self.at, by_leaps) } else { self.at.saturating_sub(by_leaps) };
            }
            _ => {}
        }
        if self.at != before {
            self.look();
        }
        true
    }

    /// The next step whose face hides something nearer; else the last one.
    fn next_wrong(&self) -> usize {
        let steps = (1..).zip(&self.painting.steps).skip(self.at);
        let mut wrong = steps.filter(|(_, step)| step.spoils > 0);
        wrong.next().map_or(self.count() + 1, |(at, _)| at)
    }

    /// Writes what is told about the step from a pixel down, each line in ink on its ground.
    pub(crate) fn draw(
        &self,
        screen: &mut Screen,
        (x, y): (i32, i32),
        [ink, ground]: [Color; 2],
        language: Language,
    ) {
        for (row, text) in (0..).zip(self.lines(language)) {
            let (y, width) = (y + 12 * row, 8 * i32::try_from(text.chars().count()).unwrap_or(0));
            screen.bar(x - 2, y - 2, x + width + 1, y + 9, ground);
            screen.text(x, y, &text, ink);
        }
    }

    fn lines(&self, language: Language) -> Vec<String> {
        let hungarian = language == Language::Hungarian;
        let Painting { left_out, boxes, decided, possible, wrong, .. } = &self.painting;
        let (count, left_out, wrong) = (self.count(), left_out.len(), wrong.len());
        let mut lines = match (self.painted(), self.last()) {
            (None, _) if hungarian => vec![
                "Képpontonkénti mélység szerint: a helyes kép".to_owned(),
                format!("A festő képén {wrong} képpont rossz"),
            ],
            (None, _) => vec![
                "By the depth of every pixel: the right picture".to_owned(),
                format!("The painter got {wrong} pixels wrong"),
            ],
            (Some(_), Some(step)) => self.told(step, hungarian),
            (Some(_), None) if hungarian => vec![
                format!("Hátulról előre: {count} lap látszik, {left_out} elfordul (4.25)"),
                format!("Fedő dobozok: {boxes} pár, a próbák döntöttek: {decided}"),
                (if *possible {
                    "Van minden párra jó sorrend"
                } else {
                    "Körben fedő lapok: minden párra jó sorrend nincs"
                })
                .to_owned(),
            ],
            (Some(_), None) => vec![
                format!("From far to near: {count} faces, {left_out} turn away (4.25)"),
                format!("Boxes overlap: {boxes} pairs; the tests decide {decided}"),
                (if *possible {
                    "Some order suits all pairs"
                } else {
                    "Faces overlap in a circle: no order suits all pairs"
                })
                .to_owned(),
            ],
        };
        lines.push(KEYS.of(language).to_owned());
        lines
    }

    /// What is told about a face that has just been painted.
    fn told(&self, step: &Step, hungarian: bool) -> Vec<String> {
        let (at, count, number, mean) = (self.at, self.count(), step.face + 1, step.mean);
        let (spoils, wrong) = (step.spoils, step.wrong);
        let test = step.moved.map(|(other, test)| (other + 1, test));
        if hungarian {
            return vec![
                format!("{at}/{count}: {number}. lap, közepes mélysége {mean:.1}"),
                match test {
                    None => "Helye a közepes mélység szerint".to_owned(),
                    Some((other, Test::Sides)) => {
                        format!("A(z) {other}. lap elé téve: metsző oldalak (4.29)")
                    }
                    Some((other, Test::Corner)) => {
                        format!("A(z) {other}. lap elé téve: csúcs a másik lapban (4.38)")
                    }
                },
                if spoils > 0 {
                    format!("Rosszul: {spoils} közelebbi képpontra fest; rossz: {wrong}")
                } else {
                    format!("Rossz képpontok: {wrong}")
                },
            ];
        }
        vec![
            format!("{at}/{count}: face {number}, mean depth {mean:.1}"),
            match test {
                None => "In its place by mean depth".to_owned(),
                Some((other, Test::Sides)) => format!("Put before face {other}: sides cross (4.29)"),
                Some((other, Test::Corner)) => format!("Put before face {other}: a corner is inside (4.38)"),
            },
            if spoils > 0 {
                format!("Wrongly: hides {spoils} nearer pixels; wrong: {wrong}")
            } else {
                format!("Wrong pixels: {wrong}")
            },
        ]
    }
}

/// The keys of the steps.
const KEYS: Words = Words(
    "szóköz: tovább, ←: vissza, F8: hiba, Home End, Esc",
    "Space: next, ←: back, F8: fault, Home End, Esc",
);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::painter::Backs;
    use crate::machine::Mouse;
    use std::time::Duration;

    fn steps() -> Steps {
        // Three bars in a circle.
        let bar = |k: u8| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 3.0).sin_cos();
            [[-70.0, 20.0, -30.0], [-70.0, 40.0, -30.0], [70.0, 40.0, 30.0], [70.0, 20.0, 30.0]]
                .map(|[x, y, z]: [f64; 3]| [100.0 + x * cos - y * sin, 100.0 + x * sin + y * cos, z])
                .to_vec()
        };
        Steps::new(Painting::new(&[bar(0), bar(1), bar(2)], Backs::Painted, [200, 200]))
    }

    fn after(keys: &[Key]) -> (Steps, bool) {
        let mut steps = steps();
        let stays = keys.iter().all(|&key| {
            steps.heed(&Tick { event: Some(Event::Key(key)), now: Duration::ZERO, mouse: Mouse::default() })
        });
        (steps, stays)
    }

    #[test]
    fn keys_step_forth_and_back() {
        let space = Key::Char(' ');
        for (keys, at) in [
            (&[][..], 0),
            (&[space, Key::Enter, Key::Down], 3),
            (&[Key::End], 4),
            (&[Key::End, space], 4),
            (&[Key::End, Key::Left], 3),
            (&[Key::End, Key::Home], 0),
            (&[Key::PageDown, Key::PageDown, Key::PageUp], 1),
            (&[Key::F(8)], 3),
            (&[Key::F(8), Key::F(8)], 4),
        ] {
            let (steps, stays) = after(keys);
            assert_eq!((steps.at, stays), (at, true), "{keys:?}");
        }
        assert!(!after(&[Key::Esc]).1);
    }

    #[test]
    fn every_step_is_told_in_lines_that_fit() {
        for end in 0..5 {
            let (steps, _) = after(&vec![Key::Right; end]);
            for language in [Language::Hungarian, Language::English] {
                let lines = steps.lines(language);
                assert!(lines.len() >= 3 && lines.iter().all(|line| line.chars().count() <= 54), "{lines:?}");
            }
            assert_eq!(steps.wrong().len(), steps.model().wrong);
        }
        assert!(after(&[Key::End, Key::Left]).0.model().wrong > 0);
    }
}
