//! The picture under its texts, and what its pixels belong to: areas, thin lines, straight rules, or the regular grid.

use super::layout::Layout;
use crate::screen::{HEIGHT, Screen, Text, WIDTH};

const ACROSS: usize = WIDTH as usize;
const DOWN: usize = HEIGHT as usize;

/// What a pixel belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Area,
    /// A line that is bent or slanted.
    Thin,
    /// A straight line across.
    Across,
    /// A straight line down.
    Down,
    /// A line of a grid, or one close beside another one, as in a raised frame: ground for everything else.
    Ground,
}

/// The picture without its letters.
pub(super) struct Ground {
    pub(super) pixels: Vec<u8>,
    pub(super) kinds: Vec<Kind>,
    /// The crossings of the grid that are shown, and its colour.
    pub(super) crossings: Vec<(usize, usize, u8)>,
}

/// Runs of equal pixels shorter than this, in rows or columns, belong to a line and not to an area.
const AREA: usize = 4;
/// A thin run of at least so many pixels is straight: two letters across, three quarters of a button down.
const RULE: (usize, usize) = (18, 12);
/// Straight lines nearer than this to one before them are its echo.
const ECHO: usize = 7;
/// A line of a grid is at least so long where nothing covers it.
const GRID_LINE: usize = 60;
/// Fewer lines in each direction are no grid.
const GRID_LINES: usize = 6;

impl Ground {
    pub(super) fn new(screen: &Screen, texts: &[Text], layout: &Layout) -> Ground {
        let pixels = without(screen, texts);
        let runs = Runs::new(&pixels);
        let mut kinds = runs.kinds();
        hush_echoes(&mut kinds, &runs);
        let grid = grid(&pixels, &runs);
        let mut crossings = Vec::new();
        if let Some(Grid { color, rows, columns }) = grid {
            for (y, line) in rows.iter().enumerate() {
                for (x, column) in columns.iter().enumerate() {
                    let at = y * ACROSS + x;
                    if (*line || *column) && pixels[at] == color {
                        kinds[at] = Kind::Ground;
                    }
                }
            }
            let (mut rows, columns) = (places(&rows), places(&columns));
            // Rows are counted from below, as their numbers are.
            rows.reverse();
            let cell = (ACROSS / (layout.columns.len() - 1).max(1), DOWN / (layout.rows.len() - 1).max(1));
            for &y in &thinned(&rows, 4 * cell.1) {
                for &x in &thinned(&columns, 12 * cell.0) {
                    if kinds[y * ACROSS + x] == Kind::Ground {
                        crossings.push((x, y, color));
                    }
                }
            }
        }
        Ground { pixels, kinds, crossings }
    }

    /// The colour that a letter stands on: the most frequent one in its box.
    pub(super) fn paper(&self, (left, top): (i32, i32), (width, height): (i32, i32)) -> u8 {
        let mut counts = [0u32; 16];
        let rows = top.max(0)..(top + height).min(HEIGHT);
        for y in rows {
            for x in left.max(0)..(left + width).min(WIDTH) {
                // Both lie on the screen.
                counts[usize::from(self.pixels[y as usize * ACROSS + x as usize] & 15)] += 1;
            }
        }
        most(&counts)
    }
}

/// Where marks are set.
fn places(marks: &[bool]) -> Vec<usize> {
    (0..marks.len()).filter(|&at| marks[at]).collect()
}

/// Every so many-th line of a grid (1, 2, 5 or 10), so that those left are some pixels apart.
fn thinned(lines: &[usize], distance: usize) -> Vec<usize> {
    let pitch = match lines {
        [first, .., last] => first.abs_diff(*last) / (lines.len() - 1),
        _ => distance,
    };
    let step = [1, 2, 5, 10].into_iter().find(|step| step * pitch >= distance).unwrap_or(20);
    lines.iter().copied().step_by(step).collect()
}

/// The pixels without the letters: they take the colour that is most frequent between their strokes.
fn without(screen: &Screen, texts: &[Text]) -> Vec<u8> {
    let mut pixels = screen.pixels().to_vec();
    for text in texts {
        let count = i32::try_from(text.letters.len()).unwrap_or(i32::MAX).max(1);
        for (at, &(ch, color)) in (0..).zip(&text.letters) {
            if ch == ' ' {
                continue;
            }
            let (left, right) = (text.x + text.width * at / count, text.x + text.width * (at + 1) / count);
            erase(&mut pixels, (left, right), (text.y, text.y + text.height), color.index());
        }
    }
    pixels
}

fn erase(pixels: &mut [u8], (left, right): (i32, i32), (top, bottom): (i32, i32), ink: u8) {
    let within = |from: i32, to: i32, size: i32| (from.clamp(0, size) as usize, to.clamp(0, size) as usize);
    let ((left, right), (top, bottom)) = (within(left, right, WIDTH), within(top, bottom, HEIGHT));
    let mut counts = [0u32; 16];
    for y in top..bottom {
        for &index in &pixels[y * ACROSS + left..y * ACROSS + right] {
            counts[usize::from(index & 15)] += u32::from(index != ink);
        }
    }
    if counts == [0; 16] {
        return;
    }
    let paper = most(&counts);
    for y in top..bottom {
        for index in &mut pixels[y * ACROSS + left..y * ACROSS + right] {
            if *index == ink {
                *index = paper;
            }
        }
    }
}

/// The colour of the highest count, the lower number among equals.
pub(super) fn most(counts: &[u32; 16]) -> u8 {
    let highest = counts.iter().copied().max().unwrap_or_default();
    // There are 16 counts.
    counts.iter().position(|&count| count == highest).unwrap_or_default() as u8
}

/// The lengths of the runs of equal pixels that every pixel is in, across and down.
struct Runs {
    across: Vec<u16>,
    down: Vec<u16>,
}

impl Runs {
    fn new(pixels: &[u8]) -> Runs {
        let (mut across, mut down) = (vec![0u16; pixels.len()], vec![0u16; pixels.len()]);
        for (row, lengths) in pixels.chunks(ACROSS).zip(across.chunks_mut(ACROSS)) {
            let mut start = 0;
            for run in row.chunk_by(|a, b| a == b) {
                // Rows and columns are shorter than 16 bits count.
                lengths[start..start + run.len()].fill(run.len() as u16);
                start += run.len();
            }
        }
        // Downwards the lengths so far; then the whole length goes back up.
        for at in 0..pixels.len() {
            let above = at.checked_sub(ACROSS).filter(|&above| pixels[above] == pixels[at]);
            down[at] = above.map_or(1, |above| down[above] + 1);
        }
        for at in (0..pixels.len().saturating_sub(ACROSS)).rev() {
            if pixels[at + ACROSS] == pixels[at] {
                down[at] = down[at + ACROSS];
            }
        }
        Runs { across, down }
    }

    fn kinds(&self) -> Vec<Kind> {
        let kind = |(&across, &down): (&u16, &u16)| {
            let (across, down) = (usize::from(across), usize::from(down));
            match (across < AREA, down < AREA) {
                (false, true) if across >= RULE.0 => Kind::Across,
                (true, false) if down >= RULE.1 => Kind::Down,
                (false, false) => Kind::Area,
                _ => Kind::Thin,
            }
        };
        self.across.iter().zip(&self.down).map(kind).collect()
    }
}

/// Of straight lines side by side only the longest stays a line, the first among equals.
fn hush_echoes(kinds: &mut [Kind], runs: &Runs) {
    let mut hush = |kind: Kind, lengths: &[u16], at: usize, last: &mut Option<usize>, step: usize| {
        if kinds[at] != kind {
            return;
        }
        match *last {
            Some(before) if (at - before) / step < ECHO => {
                let longer = lengths[at] > lengths[before];
                kinds[if longer { before } else { at }] = Kind::Ground;
                if longer {
                    *last = Some(at);
                }
            }
            _ => *last = Some(at),
        }
    };
    for y in 0..DOWN {
        let mut last = None;
        (0..ACROSS).for_each(|x| hush(Kind::Down, &runs.down, y * ACROSS + x, &mut last, 1));
    }
    let mut last = vec![None; ACROSS];
    for y in 0..DOWN {
        for (x, last) in last.iter_mut().enumerate() {
            hush(Kind::Across, &runs.across, y * ACROSS + x, last, ACROSS);
        }
    }
}

/// A regular grid: its colour, and on which rows and columns of pixels its lines lie.
struct Grid {
    color: u8,
    rows: Vec<bool>,
    columns: Vec<bool>,
}

/// Finds the grid of the picture: many long lines of one pixel in one colour, in both directions.
fn grid(pixels: &[u8], runs: &Runs) -> Option<Grid> {
    // For every colour, on which rows and columns there are long thin runs. An area is thick everywhere, a line only
    // where others cross it.
    let (mut rows, mut columns) = (vec![[false; 16]; DOWN], vec![[false; 16]; ACROSS]);
    let thin = |lengths: &[u16], from: usize, step: usize| {
        (0..3).filter(|at| usize::from(lengths[from + at * step]) < AREA).count() > 1
    };
    for (y, row) in rows.iter_mut().enumerate() {
        let mut x = 0;
        while x < ACROSS {
            let at = y * ACROSS + x;
            let length = usize::from(runs.across[at]).max(1);
            if length >= GRID_LINE && thin(&runs.down, at + length / 2, 1) {
                row[usize::from(pixels[at] & 15)] = true;
            }
            x += length;
        }
    }
    for (x, column) in columns.iter_mut().enumerate() {
        let mut y = 0;
        while y < DOWN {
            let at = y * ACROSS + x;
            let length = usize::from(runs.down[at]).max(1);
            if length >= GRID_LINE && thin(&runs.across, at + length / 2 * ACROSS, ACROSS) {
                column[usize::from(pixels[at] & 15)] = true;
            }
            y += length;
        }
    }
    (0..16u8).find_map(|color| {
        let single = |marks: &[[bool; 16]]| -> Vec<bool> {
            let on = |at: Option<usize>| {
                at.and_then(|at| marks.get(at)).is_some_and(|marks| marks[usize::from(color)])
            };
            (0..marks.len()).map(|at| on(Some(at)) && !on(at.checked_sub(1)) && !on(Some(at + 1))).collect()
        };
        let (rows, columns) = (single(&rows), single(&columns));
        let (across, down) = (places(&rows), places(&columns));
        if across.len() < GRID_LINES || down.len() < GRID_LINES {
            return None;
        }
        let crossings = across.iter().flat_map(|y| down.iter().map(move |x| y * ACROSS + x));
        let crossed = crossings.filter(|&at| pixels[at] == color).count();
        // Points and curves cover some.
        (2 * crossed > across.len() * down.len()).then_some(Grid { color, rows, columns })
    })
}
