//! The picture in block characters: two colours and four quarters to a cell, the program's texts as real
//! characters over them.

use super::place::Place;
use crate::screen::{Color, HEIGHT, Letter, Palette, Screen, WIDTH};
use std::fmt::Write;

/// One character of the terminal; the colours are those of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) ch: char,
    pub(super) ink: u8,
    pub(super) paper: u8,
}

/// How many colours a terminal has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Depth {
    /// Red, green and blue of 8 bits each: the colours of the VGA as they are.
    Full,
    /// The 256 colours of xterm: the nearest of its cube.
    Cube,
    /// The terminal's own 16 colours.
    Sixteen,
}

/// The number of the nearest level of xterm's cube.
fn nearest_level(level: u8) -> u32 {
    const LEVELS: [u8; 6] = [0, 95, 135, 175, 215, 255];
    (0..).zip(LEVELS).min_by_key(|(_, known)| known.abs_diff(level)).map_or(0, |(number, _)| number)
}

impl Depth {
    /// What the environment says of a terminal.
    pub(super) fn of(colorterm: &str, term: &str) -> Depth {
        if matches!(colorterm, "truecolor" | "24bit") || term.ends_with("-direct") {
            Depth::Full
        } else if term.contains("256") {
            Depth::Cube
        } else {
            Depth::Sixteen
        }
    }

    /// The parameters of the control sequence that selects a colour; `base` is 30 for the ink and 40 for
    /// the paper.
    fn sequence(self, palette: Palette, base: u32, index: u8) -> String {
        let color = Color::from_index(index);
        let [red, green, blue] = palette.rgb(color);
        match self {
            Depth::Full => format!("{};2;{red};{green};{blue}", base + 8),
            Depth::Cube => {
                let [red, green, blue] = [red, green, blue].map(nearest_level);
                format!("{};5;{}", base + 8, 16 + 36 * red + 6 * green + blue)
            }
            Depth::Sixteen => {
                // Terminals count red as 1 and blue as 4, the VGA the other way round.
                let number = u32::from(index);
                let ansi = number & 2 | (number & 1) << 2 | (number >> 2 & 1);
                format!("{}", base + ansi + if number & 8 == 0 { 0 } else { 60 })
            }
        }
    }
}

/// The characters by their quarters: bit 0 upper left, 1 upper right, 2 lower left, 3 lower right.
const QUARTERS: [char; 16] = [' ', '▘', '▝', '▀', '▖', '▌', '▞', '▛', '▗', '▚', '▐', '▜', '▄', '▙', '▟', '█'];

/// The mouse pointer: at the size of a cell a sign is clearer than a shrunk arrow.
const POINTER: Cell = Cell { ch: '↖', ink: Color::White.index(), paper: Color::Red.index() };

/// The cells of a picture, row by row; `pointer` is where the mouse is, if it is shown.
pub(super) fn grid(screen: &Screen, pointer: Option<(i32, i32)>, place: Place) -> Vec<Cell> {
    let letters: Vec<Letter> = screen.letters().collect();
    let bare = without(screen, &letters);
    let thin = lines(&bare);
    let columns = edges(place.width, WIDTH as usize);
    let rows = edges(place.height, HEIGHT as usize);
    let mut cells = Vec::with_capacity(place.width * place.height);
    for row in rows.windows(2) {
        for column in columns.windows(2) {
            cells.push(cell(&bare, &thin, (column[0], column[1]), (row[0], row[1])));
        }
    }
    write_texts(&mut cells, &letters, place);
    if let Some((x, y)) = pointer {
        let column = x.clamp(0, WIDTH - 1) as usize * place.width / WIDTH as usize;
        let row = y.clamp(0, HEIGHT - 1) as usize * place.height / HEIGHT as usize;
        if let Some(cell) = cells.get_mut(row * place.width + column) {
            *cell = POINTER;
        }
    }
    cells
}

/// Where cells begin and end in the picture.
fn edges(cells: usize, size: usize) -> Vec<usize> {
    (0..=cells).map(|cell| cell * size / cells.max(1)).collect()
}

/// The pixels without the letters: they take the colour that is most frequent between their strokes.
fn without(screen: &Screen, letters: &[Letter]) -> Vec<u8> {
    let mut pixels = screen.pixels().to_vec();
    for letter in letters {
        // Letters lie wholly on the screen.
        let (Ok(left), Ok(top)) = (usize::try_from(letter.x), usize::try_from(letter.y)) else { continue };
        let ink = letter.color.index();
        let starts = (top..top + 8).map(|y| y * WIDTH as usize + left);
        let mut counts = [0u32; 16];
        for start in starts.clone() {
            for &index in pixels.get(start..start + 8).unwrap_or(&[]) {
                counts[usize::from(index & 15)] += u32::from(index != ink);
            }
        }
        let paper = most(&counts);
        for start in starts {
            for index in pixels.get_mut(start..start + 8).unwrap_or(&mut []) {
                if *index == ink {
                    *index = paper;
                }
            }
        }
    }
    pixels
}

/// The colour of the highest count, the lower number among equals.
fn most(counts: &[u32; 16]) -> u8 {
    let highest = counts.iter().copied().max().unwrap_or_default();
    // There are 16 counts.
    counts.iter().position(|&count| count == highest).unwrap_or_default() as u8
}

/// Runs of equal pixels shorter than this, in rows or columns, belong to a line and not to an area.
const AREA: usize = 4;

/// Which pixels belong to lines.
fn lines(pixels: &[u8]) -> Vec<bool> {
    let width = WIDTH as usize;
    let mut thin = vec![false; pixels.len()];
    for (row, marks) in pixels.chunks(width).zip(thin.chunks_mut(width)) {
        let mut start = 0;
        for run in row.chunk_by(|a, b| a == b) {
            if run.len() < AREA {
                marks[start..start + run.len()].fill(true);
            }
            start += run.len();
        }
    }
    // The length of the run above every pixel of the row that is being looked at.
    let mut above = vec![0usize; width];
    for (y, row) in pixels.chunks(width).enumerate() {
        let next = pixels.get((y + 1) * width..).unwrap_or(&[]);
        for (x, index) in row.iter().enumerate() {
            above[x] += 1;
            if next.get(x) != Some(index) {
                for up in (0..above[x]).filter(|_| above[x] < AREA) {
                    thin[(y - up) * width + x] = true;
                }
                above[x] = 0;
            }
        }
    }
    thin
}

/// The pixels of one cell or of a quarter of it, by colour: all of them, and those of lines.
#[derive(Clone, Copy, Default)]
struct Counts {
    all: [u32; 16],
    thin: [u32; 16],
}

impl Counts {
    /// Whether a quarter shows ink: a line counts however little it covers, an area has to fill half.
    fn inked(&self, paper: u8, cell_width: usize) -> bool {
        let other = |counts: &[u32; 16]| counts.iter().sum::<u32>() - counts[usize::from(paper)];
        // More than half of what a line across a quarter covers.
        other(&self.thin) as usize > cell_width / 4 || other(&self.all) * 2 > self.all.iter().sum()
    }
}

/// The character that comes nearest to a rectangle of the picture.
fn cell(pixels: &[u8], thin: &[bool], (left, right): (usize, usize), (top, bottom): (usize, usize)) -> Cell {
    let (middle, center) = ((left + right).div_ceil(2), (top + bottom).div_ceil(2));
    let mut quarters = [Counts::default(); 4];
    let mut counts = [0u32; 16];
    let mut weights = [0u32; 16];
    for y in top..bottom {
        for x in left..right {
            let at = y * WIDTH as usize + x;
            let index = usize::from(pixels.get(at).copied().unwrap_or_default() & 15);
            let line = u32::from(thin.get(at).copied().unwrap_or_default());
            let quarter = &mut quarters[usize::from(x >= middle) + 2 * usize::from(y >= center)];
            quarter.all[index] += 1;
            quarter.thin[index] += line;
            counts[index] += 1;
            // Of two colours beside the paper's, that of a line is likely to be the one that is looked for.
            weights[index] += 1 + 3 * line;
        }
    }
    let paper = most(&counts);
    weights[usize::from(paper)] = 0;
    let ink = if weights == [0; 16] { paper } else { most(&weights) };
    let bits = quarters.iter().enumerate().filter(|(_, quarter)| quarter.inked(paper, right - left));
    match bits.fold(0usize, |mask, (bit, _)| mask | 1 << bit) {
        0 => Cell { ch: ' ', ink: paper, paper },
        15 => Cell { ch: ' ', ink, paper: ink },
        mask => Cell { ch: QUARTERS[mask], ink, paper },
    }
}

/// Writes the texts over the cells, every text in one piece with its middle where it is in the picture.
fn write_texts(cells: &mut [Cell], letters: &[Letter], place: Place) {
    let mut taken = vec![false; cells.len()];
    let mut rest = letters;
    while let Some(first) = rest.first() {
        // The letters come row by row; a blank between two words is not among them.
        let joined = |pair: &[Letter]| pair[0].y == pair[1].y && pair[1].x - pair[0].x <= 16;
        let length = 1 + rest.windows(2).take_while(|pair| joined(pair)).count();
        let (text, others) = rest.split_at(length);
        rest = others;
        let last = text.last().map_or(first.x, |letter| letter.x);
        let width = ((last - first.x + 15) / 8) as usize;
        let middle = f64::from(first.x + last + 8) * place.width as f64 / f64::from(2 * WIDTH);
        // Negative places become 0.
        let start = ((middle - width as f64 / 2.0).floor() as usize).min(place.width.saturating_sub(width));
        let row = (first.y + 4).clamp(0, HEIGHT - 1) as usize * place.height / HEIGHT as usize;
        let free = |row: usize| {
            let from = row * place.width + start;
            row < place.height && taken.get(from..from + width).is_some_and(|cells| !cells.contains(&true))
        };
        // Lines that stand closer than cells do move aside.
        let row = [row, row + 1, row.wrapping_sub(1)].into_iter().find(|&row| free(row)).unwrap_or(row);
        for letter in text {
            let at = row * place.width + start + ((letter.x - first.x) / 8) as usize;
            if let (Some(cell), Some(taken)) = (cells.get_mut(at), taken.get_mut(at)) {
                *cell = Cell { ch: letter.ch, ink: letter.color.index(), paper: cell.paper };
                *taken = true;
            }
        }
    }
}

/// The control sequences that turn one picture of cells into another one; `before` is `None` when nothing
/// is known of what the terminal shows.
pub(super) fn difference(
    before: Option<&[Cell]>,
    after: &[Cell],
    place: Place,
    (depth, palette): (Depth, Palette),
) -> String {
    let mut out = String::new();
    let mut cursor = None;
    let mut colors = None;
    for (at, cell) in after.iter().enumerate() {
        if before.and_then(|cells| cells.get(at)) == Some(cell) {
            continue;
        }
        let (row, column) = (at / place.width.max(1), at % place.width.max(1));
        // Writing to a string cannot fail.
        if cursor != Some(at) || column == 0 {
            let (row, column) = (row + usize::from(place.row) + 1, column + usize::from(place.column) + 1);
            let _ = write!(out, "\x1b[{row};{column}H");
        }
        if colors != Some((cell.ink, cell.paper)) {
            let (ink, paper) =
                (depth.sequence(palette, 30, cell.ink), depth.sequence(palette, 40, cell.paper));
            let _ = write!(out, "\x1b[{ink};{paper}m");
            colors = Some((cell.ink, cell.paper));
        }
        out.push(cell.ch);
        cursor = Some(at + 1);
    }
    if !out.is_empty() {
        out.push_str("\x1b[0m");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::place::Extent;
    use super::*;
    use crate::screen::Stroke;

    fn place(columns: u16, rows: u16) -> Place {
        Place::of_blocks(Extent { columns, rows, cell: None }).unwrap()
    }

    fn line(cells: &[Cell], place: Place, row: usize) -> String {
        cells[row * place.width..][..place.width].iter().map(|cell| cell.ch).collect()
    }

    #[test]
    fn texts_stand_in_their_cells_and_leave_no_specks() {
        let mut screen = Screen::new();
        screen.clear(Color::LightCyan);
        screen.text(80, 160, "Őrült 12", Color::Black);
        let cells = grid(&screen, None, place(80, 30));
        assert_eq!(line(&cells, place(80, 30), 10).trim(), "Őrült 12");
        assert_eq!(line(&cells, place(80, 30), 10).chars().position(|ch| ch == 'Ő'), Some(10));
        let others = cells.iter().filter(|cell| cell.ch == ' ');
        assert!(others.clone().count() == 2400 - 7 && others.clone().all(|cell| cell.paper == 11));
        let large = place(140, 45);
        let cells = grid(&screen, None, large);
        assert_eq!(line(&cells, large, 15).trim(), "Őrült 12");
    }

    #[test]
    fn close_lines_of_text_do_not_cover_each_other() {
        let mut screen = Screen::new();
        screen.text(0, 32, "one", Color::White);
        screen.text(0, 40, "two", Color::White);
        let cells = grid(&screen, None, place(80, 30));
        let all: String = cells.iter().map(|cell| cell.ch).collect();
        assert!(all.contains("one") && all.contains("two"), "{all}");
    }

    #[test]
    fn areas_and_thin_lines_show() {
        let mut screen = Screen::new();
        screen.clear(Color::White);
        screen.bar(8, 16, 15, 22, Color::Red);
        screen.line(100, 0, 100, 479, Stroke::thin(Color::Blue));
        let cells = grid(&screen, Some((639, 479)), place(80, 30));
        assert_eq!(cells[81], Cell { ch: '▀', ink: 4, paper: 15 });
        assert_eq!(cells[12], Cell { ch: '▐', ink: 1, paper: 15 });
        assert_eq!(cells[0], Cell { ch: ' ', ink: 15, paper: 15 });
        assert_eq!(cells[2399], POINTER);
    }

    #[test]
    fn only_what_changed_is_written() {
        let mut screen = Screen::new();
        let size = place(80, 30);
        let before = grid(&screen, None, size);
        screen.text(8, 16, "ab", Color::Yellow);
        let after = grid(&screen, None, size);
        let written = difference(Some(&before), &after, size, (Depth::Sixteen, Palette::Vga));
        assert_eq!(written, "\x1b[2;2H\x1b[93;40mab\x1b[0m");
        assert_eq!(difference(Some(&after), &after, size, (Depth::Full, Palette::Vga)), "");
        assert!(
            difference(None, &after, size, (Depth::Cube, Palette::Vga)).contains("\x1b[38;5;227;48;5;16mab")
        );
    }

    #[test]
    fn colors_by_what_the_terminal_has() {
        assert_eq!(Depth::of("truecolor", "xterm"), Depth::Full);
        assert_eq!(Depth::of("", "xterm-256color"), Depth::Cube);
        assert_eq!(Depth::of("", "linux"), Depth::Sixteen);
        assert_eq!(Depth::Sixteen.sequence(Palette::Vga, 30, Color::Blue.index()), "34");
        assert_eq!(Depth::Sixteen.sequence(Palette::Vga, 40, Color::LightRed.index()), "101");
        assert_eq!(Depth::Full.sequence(Palette::Vga, 40, Color::Brown.index()), "48;2;170;85;0");
    }
}
