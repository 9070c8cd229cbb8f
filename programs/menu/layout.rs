//! Where the menu has its lines and pictures.

use super::preview::SMALL;
use crate::programs::ALL;
use crate::programs::groups::GROUPS;
use crate::ui::{Area, Group};

/// Left edge of the list and of the lines below.
pub(super) const LEFT: i32 = 24;
/// Right edge of the list.
const RIGHT: i32 = 190;
/// Upper edge of the list, and of the pictures.
const TOP: i32 = 52;
/// Lower edge of the list.
const BOTTOM: i32 = 434;
/// Largest and smallest height of a line of the list, whose letters have eight pixels.
const LINES: [i32; 2] = [10, 8];
/// Pictures beside each other, and the place of the first one.
const ACROSS: i32 = 3;
const FIRST: (i32, i32) = (204, TOP + 2);
/// Offset between the upper left corners of neighbouring pictures.
const PITCH: (i32, i32) = (SMALL.0 + 10, SMALL.1 + 26);

/// A line of the list.
pub(super) enum Line {
    /// The heading of a group.
    Group(&'static Group),
    /// The program of a number.
    Program(usize),
}

/// The lines of the list with their places.
pub(super) fn lines() -> impl Iterator<Item = (Area, Line)> {
    let all = GROUPS
        .into_iter()
        .flat_map(|group| std::iter::once(Line::Group(group)).chain(programs(group).map(Line::Program)));
    let count = i32::try_from(GROUPS.len() + ALL.len()).unwrap_or(i32::MAX);
    let [largest, smallest] = LINES;
    let high = ((BOTTOM - TOP) / count).clamp(smallest, largest);
    let area = move |y: i32| Area::new(LEFT, y, RIGHT, y + high - 1);
    (0..).zip(all).map(move |(index, line)| (area(TOP + index * high), line))
}

/// The numbers of a group's programs.
pub(super) fn programs(group: &'static Group) -> impl Iterator<Item = usize> {
    (0..).zip(ALL).filter(move |(_, program)| program.group == group).map(|(index, _)| index)
}

/// The numbers of all programs, in the order of the list.
pub(super) fn order() -> impl Iterator<Item = usize> {
    GROUPS.into_iter().flat_map(programs)
}

/// The group of a program.
pub(super) fn group(index: usize) -> Option<&'static Group> {
    ALL.get(index).map(|program| program.group)
}

/// The area of a program's picture, by its index in the group.
pub(super) fn picture_area(at: usize) -> Area {
    let at = i32::try_from(at).unwrap_or(i32::MAX / (2 * PITCH.1));
    let (x, y) = (FIRST.0 + at % ACROSS * PITCH.0, FIRST.1 + at / ACROSS * PITCH.1);
    Area::new(x, y, x + SMALL.0 - 1, y + SMALL.1 - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::Words;

    #[test]
    fn everything_fits_into_the_menu() {
        let last = lines().last().expect("there are programs").0;
        assert!(last.y2 < BOTTOM, "{}", last.y2);
        for group in GROUPS {
            let Words(hungarian, english) = group.name;
            let room = ((RIGHT - LEFT) / 8) as usize;
            assert!(hungarian.chars().count() <= room && english.chars().count() <= room, "{hungarian}");
            let area = picture_area(programs(group).count().saturating_sub(1));
            assert!(area.x2 < 616 && area.y2 < 418, "{hungarian}: {}", area.y2);
        }
        for program in ALL {
            let Words(hungarian, english) = program.manual.about;
            assert!(program.manual.name.len() <= 10, "{}", program.manual.name);
            assert!(hungarian.chars().count() <= 72 && english.chars().count() <= 72, "{hungarian}");
        }
    }
}
