//! The picture in characters: two colours to a cell, the program's texts as real characters, frames and rules as
//! line-drawing characters, and for the rest the character that comes nearest to the pixels.
//!
//! Texts come first and keep their letters whole. Then come thin lines, in dots of Braille, with the colour that stands
//! out most; areas last. A regular grid is ground: it shows as dots at some of its crossings.

mod colors;
mod glyphs;
mod ground;
mod layout;

pub use colors::Depth;
pub(super) use colors::difference;

use super::place::{Extent, Place};
use crate::machine::Glyphs;
use crate::screen::{Color, HEIGHT, Screen, Text, WIDTH};
use ground::{Ground, Kind, most};
use layout::{Layout, Placed};

/// One character of the terminal; the colours are those of the picture, 0 to 15.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The character.
    pub ch: char,
    /// The colour of its strokes; that of the paper when it has none.
    pub ink: u8,
    /// The colour behind it.
    pub paper: u8,
}

impl Cell {
    const fn blank(paper: u8) -> Cell {
        Cell { ch: ' ', ink: paper, paper }
    }
}

/// The mouse pointer: at the size of a cell a sign is clearer than a shrunk arrow.
const POINTER: Cell = Cell { ch: '↖', ink: Color::White.index(), paper: Color::Red.index() };

/// The arms of a line down.
const SIDES: glyphs::Arms = 0b1100;

/// Makes cells of pictures, for one size of terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Blocks {
    place: Place,
    glyphs: Glyphs,
}

/// A rectangle of the screen in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spot {
    /// Left edge.
    pub x: i32,
    /// Upper edge.
    pub y: i32,
    /// Width.
    pub width: i32,
    /// Height.
    pub height: i32,
}

impl Spot {
    /// The pixel at parts of the width and of the height, 0 to 1.
    #[must_use]
    pub fn at(&self, across: f64, down: f64) -> (i32, i32) {
        let part = |from: i32, size: i32, part: f64| from + (f64::from(size) * part).floor() as i32;
        (
            part(self.x, self.width, across).clamp(0, WIDTH - 1),
            part(self.y, self.height, down).clamp(0, HEIGHT - 1),
        )
    }
}

/// A picture in cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The cells, row by row.
    pub cells: Vec<Cell>,
    /// How many cells a row has.
    pub width: usize,
    /// The part of the screen that each cell stands for: a click on a letter is one on the letter, wherever it was put.
    pub spots: Vec<Spot>,
    /// The texts that found no room.
    pub missing: Vec<String>,
}

impl Picture {
    /// The characters, a string for each row.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        self.cells.chunks(self.width.max(1)).map(|row| row.iter().map(|cell| cell.ch).collect()).collect()
    }
}

impl Blocks {
    /// For a terminal of so many columns and rows; `None` when it is smaller than 60x20.
    #[must_use]
    pub fn new(columns: u16, rows: u16, glyphs: Glyphs) -> Option<Blocks> {
        let place = Place::of_blocks(Extent { columns, rows, cell: None })?;
        Some(Blocks { place, glyphs })
    }

    pub(super) const fn at(place: Place, glyphs: Glyphs) -> Blocks {
        Blocks { place, glyphs }
    }

    /// The cells of a picture; `pointer` is where the mouse is, if it is shown.
    #[must_use]
    pub fn picture(&self, screen: &Screen, pointer: Option<(i32, i32)>) -> Picture {
        let texts = screen.texts();
        let layout = Layout::new(self.place, &texts);
        let ground = Ground::new(screen, &texts, &layout);
        let mut picture = Picture {
            cells: Vec::with_capacity(self.place.width * self.place.height),
            width: self.place.width,
            spots: Vec::with_capacity(self.place.width * self.place.height),
            missing: Vec::new(),
        };
        // The arms of frames' upper and lower edges that share cells with what the frames hold.
        let mut edges = Vec::with_capacity(picture.cells.capacity());
        for row in layout.rows.windows(2) {
            for column in layout.columns.windows(2) {
                let area =
                    Rect { left: column[0], right: column[1], top: row[0], bottom: row[1].max(row[0] + 1) };
                let (cell, edge) = self.cell(&ground, area);
                picture.cells.push(cell);
                edges.push(edge);
                picture.spots.push(area.spot());
            }
        }
        self.show_grid(&mut picture, &ground, &layout);
        let placed = layout::place(&texts, &layout);
        self.write_texts(&mut picture, (&texts, &placed), &ground);
        // Texts stay as they are.
        for placed in &placed {
            edges[placed.row * picture.width + placed.column..][..placed.letters.len()].fill(0);
        }
        for placed in placed.iter().filter(|placed| layout::is_wordy(&texts[placed.text])) {
            self.clear_frames(&mut picture, &edges, placed.row);
        }
        if let Some((x, y)) = pointer {
            let (column, row) = layout.cell((x.clamp(0, WIDTH - 1), y.clamp(0, HEIGHT - 1)));
            if let Some(cell) = picture.cells.get_mut(row * self.place.width + column) {
                // A letter under the pointer can still be read.
                let letter = cell.ch.is_alphanumeric();
                let arrow = if self.glyphs == Glyphs::Ascii { '^' } else { POINTER.ch };
                *cell = Cell { ch: if letter { cell.ch } else { arrow }, ..POINTER };
            }
        }
        picture
    }

    /// Dots at the crossings of the grid, where nothing else is.
    fn show_grid(&self, picture: &mut Picture, ground: &Ground, layout: &Layout) {
        let dot = if self.glyphs == Glyphs::Ascii { '.' } else { '·' };
        for &(x, y, color) in &ground.crossings {
            // Both lie on the screen.
            let (column, row) = layout.cell((x as i32, y as i32));
            if let Some(cell) = picture.cells.get_mut(row * picture.width + column)
                && cell.ch == ' '
                && cell.paper != color
            {
                *cell = Cell { ch: dot, ink: color, paper: cell.paper };
            }
        }
    }

    /// Writes the texts over the cells, each letter on the colour that it stands on.
    fn write_texts(&self, picture: &mut Picture, (texts, placed): (&[Text], &[Placed]), ground: &Ground) {
        for placed in placed {
            let text = &texts[placed.text];
            // Texts have letters, and not more than a screen is wide.
            let step = text.width / i32::try_from(text.letters.len()).unwrap_or(i32::MAX).max(1);
            for (column, at) in (placed.column..).zip(placed.letters.clone()) {
                let (ch, color) = text.letters[at];
                let left = text.x + step * at as i32;
                let paper = ground.paper((left, text.y), (step.max(1), text.height));
                let cell = picture.cells.get_mut(placed.row * picture.width + column);
                let spot = picture.spots.get_mut(placed.row * picture.width + column);
                if let (Some(cell), Some(spot)) = (cell, spot) {
                    let ch = if self.glyphs == Glyphs::Ascii { glyphs::ascii(ch) } else { ch };
                    *cell = match ch {
                        ' ' => Cell::blank(paper),
                        _ => Cell { ch, ink: color.index(), paper },
                    };
                    *spot = Spot { x: left, y: text.y, width: step.max(1), height: text.height };
                }
            }
        }
        let left_out = |at: &usize| !texts[*at].covered && !placed.iter().any(|placed| placed.text == *at);
        picture.missing = (0..texts.len()).filter(left_out).map(|at| texts[at].string()).collect();
    }

    /// In a row of text, the upper and lower edges of frames, which have no row of their own, give way to the sides.
    fn clear_frames(&self, picture: &mut Picture, edges: &[glyphs::Arms], row: usize) {
        let cells = picture.cells.iter_mut().zip(edges).skip(row * picture.width).take(picture.width);
        for (cell, arms) in cells.filter(|(_, arms)| **arms != 0) {
            *cell = match arms & SIDES {
                0 => Cell::blank(cell.paper),
                _ => Cell { ch: glyphs::straight(self.glyphs, SIDES), ..*cell },
            };
        }
    }

    /// The character that comes nearest to a rectangle of the picture; the arms of straight lines, if a line across is
    /// near the upper or lower edge.
    fn cell(&self, ground: &Ground, area: Rect) -> (Cell, glyphs::Arms) {
        let counts = Counts::new(ground, area);
        let Some(colors) = counts.colors() else { return (Cell::blank(counts.only()), 0) };
        let mut edge = 0;
        let cell = match colors {
            Colors::Line { paper, ink } => {
                let ch = match area.arms(ground, ink) {
                    Some((arms, at_edge)) => {
                        edge = if at_edge { arms } else { 0 };
                        glyphs::straight(self.glyphs, arms)
                    }
                    None => glyphs::line(self.glyphs, area.dots(ground, ink)),
                };
                if ch == ' ' { Cell::blank(paper) } else { Cell { ch, ink, paper } }
            }
            Colors::Area { paper, ink } => {
                let (ch, inverse) = glyphs::area(self.glyphs, area.mask(ground, (paper, ink)));
                let (paper, ink) = if inverse { (ink, paper) } else { (paper, ink) };
                match ch {
                    ' ' => Cell::blank(paper),
                    '█' => Cell::blank(ink),
                    _ => Cell { ch, ink, paper },
                }
            }
        };
        (cell, edge)
    }
}

/// How many pixels of a cell have each colour: those of areas and those of lines. Ground does not count.
struct Counts {
    areas: [u32; 16],
    lines: [u32; 16],
    ground: [u32; 16],
}

/// The two colours of a cell.
enum Colors {
    /// A thin line on a ground.
    Line { paper: u8, ink: u8 },
    /// Two areas.
    Area { paper: u8, ink: u8 },
}

/// How far colours are apart for the eye, 0 to 255.
fn contrast(a: u8, b: u8) -> u32 {
    let bright = |index: u8| {
        let [red, green, blue] = Color::from_index(index).rgb().map(u32::from);
        (30 * red + 59 * green + 11 * blue) / 100
    };
    bright(a).abs_diff(bright(b))
}

impl Counts {
    fn new(ground: &Ground, area: Rect) -> Counts {
        let mut counts = Counts { areas: [0; 16], lines: [0; 16], ground: [0; 16] };
        area.each(ground, |_, _, index, kind| {
            let kinds = match kind {
                Kind::Area => &mut counts.areas,
                Kind::Ground => &mut counts.ground,
                Kind::Thin | Kind::Across | Kind::Down => &mut counts.lines,
            };
            kinds[usize::from(index)] += 1;
        });
        counts
    }

    /// The colour of a cell that has no other.
    fn only(&self) -> u8 {
        match (self.areas.iter().sum::<u32>(), self.lines.iter().sum::<u32>()) {
            (1.., _) => most(&self.areas),
            (0, 1..) => most(&self.lines),
            (0, 0) => most(&self.ground),
        }
    }

    /// The colours that show; `None` when there is one.
    fn colors(&self) -> Option<Colors> {
        let paper = self.only();
        let highest = |weight: &dyn Fn(u8) -> u32| {
            let others = (0..16).filter(|&color| color != paper).map(|color| (weight(color), color));
            others.max_by_key(|&(weight, color)| (weight, 15 - color)).filter(|&(weight, _)| weight > 0)
        };
        let count = |counts: &[u32; 16], color: u8| counts[usize::from(color)];
        let all = self.areas.iter().chain(&self.lines).sum::<u32>();
        // Less is the end of a line that the next cell shows.
        let speck = all / 50;
        let line = highest(&|color| match count(&self.lines, color) {
            few if few <= speck => 0,
            count => count * (contrast(color, paper) + 60),
        });
        let area = highest(&|color| count(&self.areas, color));
        match (line, area) {
            (Some((_, ink)), area) => {
                let (thin, wide) = (count(&self.lines, ink), area.map_or(0, |(count, _)| count));
                match area {
                    // An area that fills a good part of the cell, with hardly a line at its edge.
                    Some((_, other)) if 8 * wide > all && wide > 3 * thin => {
                        Some(Colors::Area { paper, ink: other })
                    }
                    _ => Some(Colors::Line { paper, ink }),
                }
            }
            (None, Some((_, ink))) => Some(Colors::Area { paper, ink }),
            (None, None) => None,
        }
    }
}

/// The pixels of a cell; right and bottom do not belong to it.
#[derive(Clone, Copy, Debug)]
struct Rect {
    left: usize,
    right: usize,
    top: usize,
    bottom: usize,
}

impl Rect {
    fn spot(&self) -> Spot {
        // The screen's edges are far fewer than 32 bits count.
        let (x, y) = (self.left as i32, self.top as i32);
        Spot { x, y, width: self.right as i32 - x, height: self.bottom as i32 - y }
    }

    fn each(&self, ground: &Ground, mut told: impl FnMut(usize, usize, u8, Kind)) {
        for y in self.top..self.bottom {
            let row = y * WIDTH as usize + self.left..y * WIDTH as usize + self.right;
            let (Some(pixels), Some(kinds)) = (ground.pixels.get(row.clone()), ground.kinds.get(row)) else {
                return;
            };
            for (x, (index, kind)) in (self.left..).zip(pixels.iter().zip(kinds)) {
                told(x, y, index & 15, *kind);
            }
        }
    }

    /// The arms of straight lines of a colour, if those are nearly all that the cell has of it; and whether a line across
    /// is nearer to the upper or lower edge than to the middle, or there is none.
    fn arms(&self, ground: &Ground, ink: u8) -> Option<(glyphs::Arms, bool)> {
        let (middle, center) = ((self.left + self.right) / 2, (self.top + self.bottom) / 2);
        // Which columns a line across passes, and which rows a line down.
        let (mut across, mut down) = ([false; 64], [false; 64]);
        let (mut straight, mut bent, mut central) = (0u32, 0u32, false);
        self.each(ground, |x, y, index, kind| {
            if index != ink {
                return;
            }
            match kind {
                Kind::Across => {
                    across[(x - self.left).min(63)] = true;
                    central |= 4 * y.abs_diff(center) < self.bottom - self.top;
                    straight += 1;
                }
                Kind::Down => {
                    down[(y - self.top).min(63)] = true;
                    straight += 1;
                }
                Kind::Thin => bent += 1,
                Kind::Area | Kind::Ground => {}
            }
        });
        if straight == 0 || 2 * bent > straight {
            return None;
        }
        let passed = |marks: &[bool; 64], from: usize, to: usize| {
            let count = marks[from.min(63)..to.min(64)].iter().filter(|mark| **mark).count();
            2 * count > to - from || (to == from && count > 0)
        };
        let (width, height) = (self.right - self.left, self.bottom - self.top);
        let (middle, center) = (middle - self.left, center - self.top);
        let arms = [
            passed(&across, 0, middle),
            passed(&across, middle, width),
            passed(&down, 0, center),
            passed(&down, center, height),
        ];
        let arms = (0..).zip(arms).fold(0, |all, (bit, arm)| all | u8::from(arm) << bit);
        (arms != 0).then_some((arms, !central))
    }

    /// The parts of the cell that lines of a colour pass.
    fn dots(&self, ground: &Ground, ink: u8) -> glyphs::Dots {
        let (width, height) = (self.right - self.left, self.bottom - self.top);
        let mut counts = [0usize; 8];
        self.each(ground, |x, y, index, _| {
            if index == ink {
                let (column, row) = ((x - self.left) * 2 / width.max(1), (y - self.top) * 4 / height.max(1));
                counts[(2 * row + column).min(7)] += 1;
            }
        });
        // A line that only touches the corner of a part would make it thick.
        let least = (width.min(height / 2) / 4).max(1);
        let highest = counts.iter().copied().max().unwrap_or(0);
        let on = |count: usize| count >= least.min(highest.max(1));
        counts.iter().enumerate().filter(|(_, count)| on(**count)).fold(0, |dots, (bit, _)| dots | 1 << bit)
    }

    /// The pixels that are nearer to the ink than to the paper, at the size of a mask.
    fn mask(&self, ground: &Ground, (paper, ink): (u8, u8)) -> glyphs::Mask {
        let distance = |a: u8, b: u8| -> u32 {
            let (a, b) = (Color::from_index(a).rgb(), Color::from_index(b).rgb());
            a.iter().zip(b).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
        };
        // Of each colour, what it counts as.
        let mut inked = 0u16;
        for color in 0..16u8 {
            let is_ink = color == ink || color != paper && distance(color, ink) < distance(color, paper);
            inked |= u16::from(is_ink) << color;
        }
        let (columns, rows) = glyphs::SIZE;
        let mut mask = 0;
        for row in 0..rows {
            let y = self.top + (2 * row + 1) * (self.bottom - self.top) / (2 * rows);
            for column in 0..columns {
                let x = self.left + (2 * column + 1) * (self.right - self.left) / (2 * columns);
                let at = y * WIDTH as usize + x;
                let grid = ground.kinds.get(at) == Some(&Kind::Ground);
                let index = ground.pixels.get(at).copied().unwrap_or_default() & 15;
                let on = !grid && inked >> index & 1 == 1;
                mask |= glyphs::Mask::from(on) << (columns * row + column);
            }
        }
        mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screen::Stroke;

    fn lines(screen: &Screen, columns: u16, rows: u16) -> Vec<String> {
        Blocks::new(columns, rows, Glyphs::Blocks).unwrap().picture(screen, None).lines()
    }

    #[test]
    fn texts_stand_in_their_cells_and_leave_no_specks() {
        let mut screen = Screen::new();
        screen.clear(Color::LightCyan);
        screen.text(80, 160, "Őrült 12", Color::Black);
        let picture = Blocks::new(80, 30, Glyphs::Blocks).unwrap().picture(&screen, None);
        assert_eq!(picture.lines()[10].find("Őrült 12"), Some(10));
        let others = picture.cells.iter().filter(|cell| cell.ch == ' ');
        assert!(others.clone().count() == 2400 - 7 && others.clone().all(|cell| cell.paper == 11));
        assert_eq!(lines(&screen, 140, 45)[15].trim(), "Őrült 12");
        assert_eq!(lines(&screen, 60, 20)[6].trim(), "Őrült 12");
    }

    #[test]
    fn close_lines_of_text_do_not_cover_each_other() {
        let mut screen = Screen::new();
        for (line, text) in (0..).zip(["one", "two", "three", "four"]) {
            screen.text(0, 32 + 9 * line, text, Color::White);
        }
        for (columns, rows) in [(60, 20), (80, 24), (80, 30), (200, 60)] {
            let lines = lines(&screen, columns, rows);
            let found = |text: &str| lines.iter().position(|line| line.trim() == text);
            let rows = ["one", "two", "three", "four"].map(found);
            assert!(rows.is_sorted() && rows[0].is_some(), "{rows:?}");
        }
    }

    #[test]
    fn a_text_wider_than_the_terminal_goes_on_below() {
        let mut screen = Screen::new();
        let text = "Put down five points, press G, N and 3, then drag one of them over the field.";
        screen.text(0, 100, text, Color::White);
        let lines = lines(&screen, 60, 20);
        assert_eq!(lines[4].trim(), "Put down five points, press G, N and 3, then drag one of");
        assert_eq!(lines[5].trim(), "them over the field.");
    }

    #[test]
    fn numbers_stand_on_their_own_ground() {
        let mut screen = Screen::new();
        screen.disc(100, 100, 10, Color::DarkGray, Color::White);
        screen.text(92, 96, "49", Color::White);
        let picture = Blocks::new(80, 30, Glyphs::Blocks).unwrap().picture(&screen, None);
        let at = picture.cells.iter().position(|cell| cell.ch == '4').unwrap();
        assert_eq!(picture.cells[at], Cell { ch: '4', ink: 15, paper: 8 });
        assert_eq!(picture.cells[at + 1].ch, '9');
        assert_eq!(picture.spots[at].at(0.5, 0.5), (96, 100));
    }

    #[test]
    fn areas_lines_and_frames_show() {
        let mut screen = Screen::new();
        screen.clear(Color::White);
        screen.bar(8, 16, 15, 23, Color::Red);
        screen.line(100, 0, 100, 479, Stroke::thin(Color::Blue));
        screen.rectangle(203, 103, 299, 199, Stroke::thin(Color::Black));
        screen.line(400, 300, 439, 339, Stroke::thin(Color::Black));
        let picture = Blocks::new(80, 30, Glyphs::Blocks).unwrap().picture(&screen, Some((639, 479)));
        let cell = |column: usize, row: usize| picture.cells[80 * row + column];
        assert_eq!(cell(1, 1), Cell { ch: '▄', ink: 15, paper: 4 });
        assert_eq!(cell(12, 0), Cell { ch: '│', ink: 1, paper: 15 });
        assert_eq!(cell(0, 0), Cell::blank(15));
        let corners = [(25, 6), (37, 6), (25, 12), (37, 12), (30, 6)].map(|(x, y)| cell(x, y).ch);
        assert_eq!(corners, ['┌', '┐', '└', '┘', '─']);
        assert!(('⠁'..='⣿').contains(&cell(50, 18).ch), "{:?}", cell(50, 18));
        assert_eq!(picture.cells.last(), Some(&POINTER));
    }

    #[test]
    fn the_grid_recedes() {
        let mut screen = Screen::new();
        for at in (40..400).step_by(10) {
            screen.line(at, 40, at, 390, Stroke::thin(Color::LightGray));
            screen.line(40, at, 390, at, Stroke::thin(Color::LightGray));
        }
        screen.line(50, 60, 350, 300, Stroke::thick(Color::White));
        let picture = Blocks::new(80, 30, Glyphs::Blocks).unwrap().picture(&screen, None);
        let count = |ink| picture.cells.iter().filter(|cell| cell.ch != ' ' && cell.ink == ink).count();
        assert!(count(7) < 100 && count(15) >= 37, "{} {}", count(7), count(15));
    }

    #[test]
    fn only_ascii_where_nothing_else_is_trusted() {
        let mut screen = Screen::new();
        screen.text(80, 160, "Görbe →", Color::White);
        screen.circle(300, 200, 90, Stroke::thin(Color::White));
        screen.disc(500, 200, 30, Color::White, Color::Red);
        let picture = Blocks::new(80, 24, Glyphs::Ascii).unwrap().picture(&screen, Some((5, 5)));
        assert!(picture.cells.iter().all(|cell| cell.ch.is_ascii()));
        assert!(picture.lines().iter().any(|line| line.contains("Gorbe >")));
    }
}
