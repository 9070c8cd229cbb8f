//! Where the menu has its programs: a grid of tiles under the headings of their groups, as high as it needs, of
//! which the screen shows a part.

use super::preview::SMALL;
use crate::programs::ALL;
use crate::programs::groups::MENU;
use crate::ui::{Area, Group};

/// The part of the screen in which the grid is seen.
pub(super) const VIEW: Area = Area::new(16, 50, 623, 435);
/// Left edges of the columns, one behind the other.
const COLUMNS: [i32; 2] = [20, 318];
/// Size of a tile: the picture, and beside it what the program is.
const TILE: (i32, i32) = (SMALL.0 + 166, SMALL.1 + 6);
/// From one row of tiles to the next.
pub(super) const PITCH: i32 = TILE.1 + 4;
/// Height of a heading.
const HEADING: i32 = 20;
/// Rows of tiles that Page Up and Page Down go.
const LEAP: usize = 3;

/// A row of the grid.
enum Row {
    Heading(&'static Group),
    /// Programs beside each other, by their numbers.
    Tiles(Vec<usize>),
}

/// A way from a program to another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Left,
    Right,
    Up,
    Down,
    PageUp,
    PageDown,
    First,
    Last,
}

/// The programs in rows, with the upper edge of each row. Edges count from the grid's own.
pub(super) struct Grid {
    rows: Vec<(i32, Row)>,
    height: i32,
}

impl Grid {
    /// The grid of some programs; groups without any are left out.
    pub(super) fn of(shown: impl Fn(usize) -> bool) -> Grid {
        let mut grid = Grid { rows: Vec::new(), height: 0 };
        for group in MENU {
            let programs: Vec<usize> = programs(group).filter(|&index| shown(index)).collect();
            if !programs.is_empty() {
                grid.add(Row::Heading(group), HEADING);
            }
            programs.chunks(COLUMNS.len()).for_each(|row| grid.add(Row::Tiles(row.to_vec()), PITCH));
        }
        grid
    }

    fn add(&mut self, row: Row, height: i32) {
        self.rows.push((self.height, row));
        self.height += height;
    }

    /// The headings and their upper edges.
    pub(super) fn headings(&self) -> impl Iterator<Item = (&'static Group, i32)> {
        self.rows.iter().filter_map(|(top, row)| match row {
            Row::Heading(group) => Some((*group, *top)),
            Row::Tiles(_) => None,
        })
    }

    /// The programs and their tiles, row by row.
    pub(super) fn tiles(&self) -> impl Iterator<Item = (usize, Area)> {
        self.rows().flat_map(|(top, row)| {
            let tile = move |x: i32| Area::new(x, top, x + TILE.0 - 1, top + TILE.1 - 1);
            row.iter().copied().zip(COLUMNS.map(tile))
        })
    }

    fn rows(&self) -> impl Iterator<Item = (i32, &[usize])> {
        self.rows.iter().filter_map(|(top, row)| match row {
            Row::Heading(_) => None,
            Row::Tiles(programs) => Some((*top, programs.as_slice())),
        })
    }

    /// The first program, if there is one.
    pub(super) fn first(&self) -> Option<usize> {
        self.rows().next()?.1.first().copied()
    }

    /// Where a step from a program leads to; at an edge nowhere.
    pub(super) fn after(&self, program: usize, step: Step) -> usize {
        let rows: Vec<&[usize]> = self.rows().map(|(_, row)| row).collect();
        let all = rows.concat();
        let found = rows.iter().enumerate().find_map(|(row, programs)| {
            programs.iter().position(|&it| it == program).map(|column| (row, column))
        });
        let (row, column) = found.unwrap_or((0, 0));
        let at = all.iter().position(|&it| it == program).unwrap_or(0);
        let (last_row, last) = (rows.len().saturating_sub(1), all.len().saturating_sub(1));
        let beside = |at: usize| all.get(at.min(last)).copied();
        let in_row = |row: usize| {
            let programs = rows.get(row.min(last_row))?;
            programs.get(column).or(programs.last()).copied()
        };
        let next = match step {
            Step::Left => beside(at.saturating_sub(1)),
            Step::Right => beside(at + 1),
            Step::Up => in_row(row.saturating_sub(1)),
            Step::Down => in_row(row + 1),
            Step::PageUp => in_row(row.saturating_sub(LEAP)),
            Step::PageDown => in_row(row + LEAP),
            Step::First => beside(0),
            Step::Last => beside(last),
        };
        next.unwrap_or(program)
    }

    /// How far the grid can be scrolled.
    pub(super) fn farthest(&self) -> i32 {
        (self.height - view_height()).max(0)
    }

    /// How far the grid has to be scrolled so that a program is seen; as it is, if it is. A heading right above comes
    /// along.
    pub(super) fn revealing(&self, program: usize, scroll: i32) -> i32 {
        let Some((_, tile)) = self.tiles().find(|(index, _)| *index == program) else { return 0 };
        let headed = self.headings().any(|(_, top)| top + HEADING == tile.y1);
        let top = if headed { tile.y1 - HEADING } else { tile.y1 };
        scroll.max(tile.y2 + 1 - view_height()).min(top).clamp(0, self.farthest())
    }

    /// The handle of the scroll bar, if there is more than the screen shows.
    pub(super) fn handle(&self, scroll: i32) -> Option<Area> {
        let (room, all) = (view_height(), self.height.max(1));
        let top = VIEW.y1 + scroll * room / all;
        (self.farthest() > 0).then(|| Area::new(VIEW.x2 - 5, top, VIEW.x2 - 2, top + room * room / all - 1))
    }
}

/// The height of the part that the screen shows.
const fn view_height() -> i32 {
    VIEW.y2 - VIEW.y1 + 1
}

/// The numbers of a group's programs.
fn programs(group: &'static Group) -> impl Iterator<Item = usize> {
    (0..).zip(ALL).filter(move |(_, program)| program.group == group).map(|(index, _)| index)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> usize {
        ALL.iter().position(|program| program.manual.name == name).expect("there is such a program")
    }

    fn way(steps: &[Step]) -> &'static str {
        let grid = Grid::of(|_| true);
        let start = grid.first().expect("there are programs");
        ALL[steps.iter().fold(start, |at, &step| grid.after(at, step))].manual.name
    }

    #[test]
    fn every_program_has_a_tile_of_its_own_within_the_columns() {
        let grid = Grid::of(|_| true);
        let mut seen: Vec<usize> = grid.tiles().map(|(index, _)| index).collect();
        seen.sort_unstable();
        assert!(seen.into_iter().eq(0..ALL.len()));
        for (_, tile) in grid.tiles() {
            assert!(VIEW.x1 < tile.x1 && tile.x2 < VIEW.x2 - 6 && tile.y2 < grid.height);
        }
    }

    #[test]
    fn steps_follow_the_grid_as_it_stands() {
        use Step::{Down, First, Last, Left, PageDown, PageUp, Right, Up};
        assert_eq!(way(&[]), "gb_p_2d");
        assert_eq!(way(&[Right]), "gb_2d_ch");
        assert_eq!(way(&[Down]), "gb_2d_ip");
        assert_eq!(way(&[Right, Down]), "gb_2d_bt");
        // Over a heading, into a row that is shorter, and back.
        assert_eq!(way(&[Down, Down]), "biliard");
        assert_eq!(way(&[Right, Down, Down, Down]), "csango_k");
        assert_eq!(way(&[Right, Right]), "gb_2d_ip");
        assert_eq!((way(&[Up]), way(&[Left]), way(&[Last, Right])), ("gb_p_2d", "gb_p_2d", way(&[Last])));
        assert_eq!(way(&[PageDown, PageUp]), "gb_p_2d");
        assert_eq!(way(&[Last, First]), "gb_p_2d");
    }

    #[test]
    fn a_chosen_program_is_seen_with_its_heading() {
        let grid = Grid::of(|_| true);
        assert_eq!(grid.revealing(named("gb_p_2d"), 500), 0);
        for (index, tile) in grid.tiles() {
            for scroll in [0, 300, grid.farthest()] {
                let scroll = grid.revealing(index, scroll);
                assert!(scroll <= tile.y1 && tile.y2 < scroll + view_height());
                let handle = grid.handle(scroll).expect("not all is seen at once");
                assert!(VIEW.y1 <= handle.y1 && handle.y2 <= VIEW.y2);
            }
        }
        // What fits needs no bar.
        let few = Grid::of(|index| index == named("biliard"));
        assert_eq!((few.farthest(), few.handle(0)), (0, None));
        assert_eq!((Grid::of(|_| false).first(), Grid::of(|_| false).after(3, Step::Down)), (None, 3));
    }
}
