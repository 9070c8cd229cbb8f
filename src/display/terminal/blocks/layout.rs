//! Which pixels belong to which cell, and which cells the texts take.

use super::super::place::LETTERS;
use super::Place;
use crate::screen::{HEIGHT, Text, WIDTH};
use std::collections::BTreeMap;

/// Where the cells of a picture begin and end in its pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// One more than there are columns.
    pub(super) columns: Vec<usize>,
    /// One more than there are rows.
    pub(super) rows: Vec<usize>,
}

/// Lines of text whose middles are closer than this can share a row of cells.
const SAME_LINE: i32 = 8;

impl Layout {
    /// Equal cells, unless lines of text would then meet: so that every line has a row of its own, rows are lower where
    /// lines are close and higher elsewhere. Only texts with words count, so that the picture does not move when
    /// numbered points do.
    pub(super) fn new(place: Place, texts: &[Text]) -> Layout {
        let columns = (0..=place.width).map(|column| column * WIDTH as usize / place.width.max(1)).collect();
        let even = (0..=place.height).map(|row| row * HEIGHT as usize / place.height.max(1)).collect();
        // Where there are more lines than rows, those share a row that are the closest.
        let lines = lines(texts);
        let fit =
            (SAME_LINE..HEIGHT).map(|least| apart(&lines, least)).find(|lines| lines.len() <= place.height);
        Layout { columns, rows: fit.and_then(|lines| uneven(&lines, place.height)).unwrap_or(even) }
    }

    /// The cell of a pixel: column and row.
    pub(super) fn cell(&self, (x, y): (i32, i32)) -> (usize, usize) {
        let at = |edges: &[usize], pixel: i32| {
            let pixel = usize::try_from(pixel).unwrap_or(0);
            edges.partition_point(|&edge| edge <= pixel).saturating_sub(1).min(edges.len().saturating_sub(2))
        };
        (at(&self.columns, x), at(&self.rows, y))
    }
}

/// Whether a text has words, other than numbers and names of points, which move.
pub(super) fn is_wordy(text: &Text) -> bool {
    !text.covered && text.letters.iter().filter(|(ch, _)| ch.is_alphabetic()).count() >= 3
}

/// So many texts side by side are a row of a table.
const TABLE: usize = 4;

/// The middles of the lines of words and of the rows of tables, from above.
fn lines(texts: &[Text]) -> Vec<i32> {
    let middle = |text: &Text| text.y + text.height / 2;
    let mut counts: BTreeMap<i32, usize> = BTreeMap::new();
    texts.iter().for_each(|text| *counts.entry(middle(text)).or_default() += 1);
    let wordy = |y: i32| texts.iter().any(|text| middle(text) == y && is_wordy(text));
    counts.into_iter().filter(|&(y, count)| count >= TABLE || wordy(y)).map(|(y, _)| y).collect()
}

/// The lines without those that are nearer than this to the last one above that is left.
fn apart(lines: &[i32], least: i32) -> Vec<i32> {
    let mut lines = lines.to_vec();
    lines.dedup_by(|below, above| *below - *above < least);
    lines
}

/// The edges of rows that give each line its own; `None` when equal rows do so, or there are more lines than rows.
fn uneven(lines: &[i32], height: usize) -> Option<Vec<usize>> {
    let even: Vec<usize> =
        lines.iter().map(|&y| usize::try_from(y).unwrap_or(0) * height / HEIGHT as usize).collect();
    if lines.len() > height || even.windows(2).all(|pair| pair[0] < pair[1]) {
        return None;
    }
    // From above every line moves down as far as it must, from below up; between the two is the least of both.
    let last = even.len();
    let below = |(at, row): (usize, usize)| row.min(height - (last - at));
    let spread = |rows: &mut Vec<usize>| {
        for at in 1..last {
            rows[at] = rows[at].max(rows[at - 1] + 1);
        }
    };
    let mut down = even.clone();
    spread(&mut down);
    let down: Vec<usize> = down.into_iter().enumerate().map(below).collect();
    let mut up: Vec<usize> = even.into_iter().enumerate().map(below).collect();
    for at in (1..last).rev() {
        up[at - 1] = up[at - 1].min(up[at].saturating_sub(1));
    }
    spread(&mut up);
    let rows: Vec<usize> = down.iter().zip(&up).map(|(down, up)| (down + up) / 2).collect();
    let mut anchors: Vec<(f64, f64)> = vec![(0.0, 0.0)];
    anchors.extend(rows.iter().zip(lines).map(|(&row, &y)| (row as f64 + 0.5, f64::from(y))));
    anchors.push((height as f64, f64::from(HEIGHT)));
    let edge = |row: usize| {
        let row = row as f64;
        let pair = anchors.windows(2).find(|pair| row <= pair[1].0);
        let y = pair.map_or(f64::from(HEIGHT), |pair| {
            let ((r1, y1), (r2, y2)) = (pair[0], pair[1]);
            y1 + (y2 - y1) * (row - r1) / (r2 - r1)
        });
        // Between 0 and the height.
        y.round() as usize
    };
    Some((0..=height).map(edge).collect())
}

/// Where a text, or a line of a wrapped one, stands: the cells of a row from a column on, and which of its letters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Placed {
    /// The number of the text.
    pub(super) text: usize,
    pub(super) letters: std::ops::Range<usize>,
    pub(super) row: usize,
    pub(super) column: usize,
}

/// Words of at most so many letters are commands.
const COMMAND: usize = 14;

/// When a text is placed: commands and numbers first, then sentences, then other signs, such as the indices of a formula,
/// then numbers that are hidden in part.
fn turn(text: &Text) -> u8 {
    let number = text.letters.iter().all(|(ch, _)| !ch.is_alphabetic());
    match (text.covered, is_wordy(text)) {
        (true, _) => 3,
        (false, wordy) if number || wordy && text.letters.len() <= COMMAND => 0,
        (false, true) => 1,
        (false, false) => 2,
    }
}

/// The cells of the texts, each in its [`turn`] and from above; every text takes the free cells nearest to its place.
/// What finds no room is left out.
pub(super) fn place(texts: &[Text], layout: &Layout) -> Vec<Placed> {
    let (width, height) = (layout.columns.len() - 1, layout.rows.len() - 1);
    let mut order: Vec<usize> = (0..texts.len()).collect();
    order.sort_by_key(|&at| turn(&texts[at]));
    let mut room = Room { taken: vec![false; width * height], width, height };
    let mut placed = Vec::new();
    for at in order {
        let text = &texts[at];
        let (_, row) = layout.cell((text.x, text.y + text.height / 2));
        let middle = f64::from(2 * text.x + text.width) * width as f64 / f64::from(2 * WIDTH);
        let lines = wrapped(text, width);
        // A wrapped text continues below, so it begins where there are rows for all of its lines.
        let first = row.min(height.saturating_sub(lines.len()));
        let mut below = 0;
        for (line, letters) in lines.into_iter().enumerate() {
            let length = letters.len();
            // Negative places become 0. Where letters have less than a cell, columns of texts keep their left edges.
            let column = match width < LETTERS.0 {
                true => usize::try_from(text.x).unwrap_or(0) * width / WIDTH as usize,
                false => (middle - length as f64 / 2.0).floor().max(0.0) as usize,
            };
            let wanted = ((first + line).max(below).min(height - 1), column.min(width - length));
            let farthest = if text.covered { 1 } else { height.max(width) };
            let nearest = |from| room.nearest(wanted, length, farthest, from);
            let found = nearest(below).or_else(|| nearest(0));
            if let Some((row, column)) = found {
                room.take(row, column, length);
                placed.push(Placed { text: at, letters, row, column });
                below = row + 1;
            }
        }
    }
    placed
}

/// The lines of a text that is wider than the picture.
fn wrapped(text: &Text, width: usize) -> Vec<std::ops::Range<usize>> {
    let mut lines = Vec::new();
    let mut from = 0;
    while text.letters.len() - from > width {
        let part = &text.letters[from..from + width + 1];
        let end = part.iter().rposition(|&(ch, _)| ch == ' ').filter(|&at| at > 0);
        lines.push(from..from + end.unwrap_or(width));
        from += end.map_or(width, |end| end + 1);
    }
    lines.push(from..text.letters.len());
    lines
}

/// The cells that texts have taken.
struct Room {
    taken: Vec<bool>,
    width: usize,
    height: usize,
}

impl Room {
    /// The free cells nearest to a wanted row and column, in no row above `from`. Texts that would touch read as one, so
    /// that a blank between them is worth some distance.
    fn nearest(
        &self,
        (row, column): (usize, usize),
        length: usize,
        farthest: usize,
        from: usize,
    ) -> Option<(usize, usize)> {
        let mut best: Option<(usize, (usize, usize))> = None;
        let dearer =
            |best: Option<(usize, (usize, usize))>, cost: usize| best.is_some_and(|(known, _)| cost > known);
        let rows = around(row, self.height).take_while(|&(away, _)| away <= farthest);
        for (away, at) in rows.filter(|&(_, at)| at >= from) {
            if dearer(best, 3 * away) {
                break;
            }
            let Some(line) = self.taken.get(at * self.width..(at + 1) * self.width) else { continue };
            let starts = around(column, self.width - length + 1);
            for (aside, start) in starts.take_while(|&(aside, _)| aside <= farthest) {
                if dearer(best, 3 * away + aside) {
                    break;
                }
                if line[start..start + length].contains(&true) {
                    continue;
                }
                let touched = |at: Option<usize>| at.and_then(|at| line.get(at)) == Some(&true);
                let touching = touched(start.checked_sub(1)) || touched(Some(start + length));
                let found = (3 * away + aside + if touching { 3 } else { 0 }, (at, start));
                // Among equals the upper and left one.
                if best.is_none_or(|known| found < known) {
                    best = Some(found);
                }
            }
        }
        best.map(|(_, place)| place)
    }

    fn take(&mut self, row: usize, column: usize, length: usize) {
        let from = row * self.width + column;
        self.taken[from..from + length].fill(true);
    }
}

/// The numbers below a size by their distance from a middle, the distance first.
fn around(middle: usize, size: usize) -> impl Iterator<Item = (usize, usize)> {
    let both = move |distance: usize| {
        let below = middle.checked_sub(distance);
        let above = Some(middle + distance).filter(|_| distance > 0);
        [below, above].into_iter().flatten().filter(move |&at| at < size).map(move |at| (distance, at))
    };
    (0..=middle.max(size)).flat_map(both)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_rows_where_they_do() {
        assert_eq!(uneven(&[10, 30, 50], 24), None);
        assert_eq!(uneven(&[10, 20, 30], 2), None, "more lines than rows");
    }

    #[test]
    fn what_is_wrapped_goes_on_below() {
        use crate::screen::Color;
        let text = |words: &str, y: i32| Text {
            x: 0,
            y,
            width: 8 * words.len() as i32,
            height: 8,
            letters: words.chars().map(|ch| (ch, Color::White)).collect(),
            covered: false,
        };
        let columns = (0..=20).map(|column| column * 32).collect();
        let layout = Layout { columns, rows: (0..=10).map(|row| row * 48).collect() };
        let rows = |texts: &[Text]| {
            let placed = place(texts, &layout);
            placed.iter().map(|it| (it.text, it.row)).collect::<Vec<_>>()
        };
        // In the last row there is no room below, so it begins higher.
        let long = text("twenty columns are too few for this sentence", 470);
        assert_eq!(rows(std::slice::from_ref(&long)), [(0, 7), (0, 8), (0, 9)]);
        // A row that another text has is passed over, downwards.
        let command = text("a command here", 6 * 48);
        assert_eq!(rows(&[Text { y: 5 * 48, ..long }, command]), [(1, 6), (0, 5), (0, 7), (0, 8)]);
    }

    #[test]
    fn close_lines_have_rows_of_their_own() {
        let lines: Vec<i32> = (0..14).map(|line| 60 + 12 * line).collect();
        let rows = uneven(&lines, 24).unwrap();
        assert_eq!((rows.len(), rows[0], rows[24]), (25, 0, 480));
        assert!(rows.windows(2).all(|pair| pair[0] < pair[1]), "{rows:?}");
        let row = |y: i32| rows.partition_point(|&edge| edge <= y as usize) - 1;
        let taken: Vec<usize> = lines.iter().map(|&y| row(y)).collect();
        assert!(taken.windows(2).all(|pair| pair[1] == pair[0] + 1), "{taken:?}");
        // As many lines as rows, all at the lower edge.
        let lines: Vec<i32> = (0..24).map(|line| 240 + 10 * line).collect();
        let rows = uneven(&lines, 24).unwrap();
        assert!(rows.windows(2).all(|pair| pair[0] <= pair[1]), "{rows:?}");
    }
}
