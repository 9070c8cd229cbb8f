//! Pages, and how they are drawn into cells of any number.

use super::entry::Line;
use crate::machine::Language;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Margin, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line as Text, Span};
use ratatui::widgets::{Block, BorderType, Clear, Gauge, Paragraph, Widget, Wrap};

/// The smallest page, in columns and rows.
pub const LEAST: (u16, u16) = (48, 12);

/// Columns of the list on wide pages; on narrow ones it gets a little less than half.
const LIST: u16 = 36;

/// The colours of DOS installers: light letters on blue windows, a grey bar of keys with red letters.
const WINDOW: Style = Style::new().fg(Color::Gray).bg(Color::Blue);
const TITLE: Style = Style::new().fg(Color::White).bg(Color::Blue);
const HEADING: Style = Style::new().fg(Color::LightCyan).bg(Color::Blue);
const MARK: Style = Style::new().fg(Color::Yellow).bg(Color::Blue);
const CHOSEN: Style = Style::new().fg(Color::Black).bg(Color::Cyan);
const BAR: Style = Style::new().fg(Color::Black).bg(Color::Gray);
const HOT: Style = Style::new().fg(Color::Red).bg(Color::Gray);
const QUESTION: Style = Style::new().fg(Color::Black).bg(Color::Gray);
const FIELD: Style = Style::new().fg(Color::White).bg(Color::Blue);
const DONE: Style = Style::new().fg(Color::Blue).bg(Color::Cyan);

/// A line of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Row {
    /// A heading, which cannot be chosen.
    Heading(String),
    /// Can be chosen.
    Item(String),
    /// Can be chosen and marked; marked lines begin with a V.
    Mark(bool, String),
}

/// The summary of the chosen line, on the right.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// The title in the frame.
    pub title: String,
    /// Paragraphs; an empty one gives an empty line.
    pub lines: Vec<String>,
}

/// An overlay on a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// A message, or a question with its answers, each a hot letter and a word.
    Message {
        /// The title in the frame.
        title: String,
        /// The message or question.
        lines: Vec<String>,
        /// The answers, or the key that continues.
        answers: Vec<(String, String)>,
    },
    /// A line to type.
    Entry {
        /// The question.
        title: String,
        /// The text typed so far.
        line: Line,
    },
    /// The progress of work.
    Progress {
        /// The title in the frame.
        title: String,
        /// Finished parts.
        done: usize,
        /// Total number of parts.
        total: usize,
        /// The part being done.
        now: String,
    },
}

/// A page: a list, a summary, the keys, and perhaps something over it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Page {
    /// The language of the page's own words.
    pub language: Language,
    /// The title on the first line.
    pub title: String,
    /// The title of the list.
    pub list_title: String,
    /// The list.
    pub rows: Vec<Row>,
    /// The line that is chosen.
    pub chosen: usize,
    /// The summary of the chosen line.
    pub summary: Summary,
    /// Keys and their meanings, for the last line.
    pub keys: Vec<(String, String)>,
    /// The overlay, if any.
    pub overlay: Option<Overlay>,
}

/// What a click hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hit {
    /// A line of the list.
    Row(usize),
    /// An answer of a question.
    Answer(usize),
    /// One of the keys on the last line.
    Key(usize),
}

/// The areas of the parts of a page.
struct Parts {
    title: Rect,
    list: Rect,
    summary: Rect,
    keys: Rect,
}

impl Parts {
    fn of(area: Rect) -> Parts {
        let [title, middle, keys] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0), Constraint::Length(1)]).areas(area);
        let width = LIST.min(area.width.saturating_mul(9) / 20);
        let [list, summary] =
            Layout::horizontal([Constraint::Length(width), Constraint::Min(0)]).areas(middle);
        Parts { title, list, summary, keys }
    }
}

/// The area inside a frame.
fn inside(frame: Rect) -> Rect {
    frame.inner(Margin::new(1, 1))
}

fn window(title: &str) -> Block<'_> {
    let title = Span::styled(format!(" {title} "), TITLE);
    Block::bordered().border_type(BorderType::Double).style(WINDOW).title_top(Text::from(title).centered())
}

impl Page {
    /// Draws the page into an area, or a message if the area is too small.
    pub(super) fn draw(&self, area: Rect, cells: &mut Buffer) {
        let area = area.intersection(cells.area);
        Clear.render(area, cells);
        if area.width < LEAST.0 || area.height < LEAST.1 {
            return Paragraph::new(too_small(self.language, area))
                .wrap(Wrap { trim: true })
                .render(area, cells);
        }
        let parts = Parts::of(area);
        cells.set_style(area, WINDOW);
        cells.set_style(parts.title, BAR);
        cells.set_stringn(parts.title.x + 1, parts.title.y, &self.title, room(parts.title), BAR);
        self.draw_list(parts.list, cells);
        self.draw_summary(parts.summary, cells);
        self.draw_keys(parts.keys, cells);
        match &self.overlay {
            Some(Overlay::Message { title, lines, answers }) => {
                draw_message(area, title, lines, answers, cells);
            }
            Some(Overlay::Entry { title, line }) => draw_entry(area, title, line, cells),
            Some(Overlay::Progress { title, done, total, now }) => {
                draw_progress(area, title, (*done, *total), now, cells);
            }
            None => {}
        }
    }

    /// The page as lines of text on a display of the given size.
    pub fn to_text(&self, columns: u16, rows: u16) -> String {
        let area = Rect::new(0, 0, columns, rows);
        let mut cells = Buffer::empty(area);
        self.draw(area, &mut cells);
        let cell = |x, y| cells.cell((x, y)).map_or(" ", |cell| cell.symbol());
        let line = |y| (0..area.width).map(|x| cell(x, y)).collect::<String>().trim_end().to_owned();
        (0..area.height).map(line).collect::<Vec<_>>().join("\n")
    }

    /// What a click on a cell hits.
    pub(super) fn hit(&self, area: Rect, column: u16, row: u16) -> Option<Hit> {
        if area.width < LEAST.0 || area.height < LEAST.1 {
            return None;
        }
        let at = (column, row).into();
        if let Some(overlay) = &self.overlay {
            let Overlay::Message { lines, answers, .. } = overlay else { return None };
            let places = answer_places(message_area(area, lines, answers), answers);
            return places.iter().position(|place| place.contains(at)).map(Hit::Answer);
        }
        let parts = Parts::of(area);
        if parts.keys.contains(at) {
            return self.key_places(parts.keys).iter().position(|place| place.contains(at)).map(Hit::Key);
        }
        let list = inside(parts.list);
        let line = usize::from(row.checked_sub(list.y)?);
        let index = self.first_row(list) + line;
        let is_item = matches!(self.rows.get(index), Some(Row::Item(_) | Row::Mark(..)));
        (list.contains(at) && is_item).then_some(Hit::Row(index))
    }

    /// The first visible line of the list. The chosen line is in the middle, except near the ends.
    fn first_row(&self, list: Rect) -> usize {
        let height = usize::from(list.height);
        self.chosen.saturating_sub(height / 2).min(self.rows.len().saturating_sub(height))
    }

    fn draw_list(&self, frame: Rect, cells: &mut Buffer) {
        window(&self.list_title).render(frame, cells);
        let list = inside(frame);
        let seen = self.rows.iter().enumerate().skip(self.first_row(list));
        for (y, (index, row)) in (list.top()..list.bottom()).zip(seen) {
            let chosen = index == self.chosen;
            let (mark, text, style) = match row {
                Row::Heading(text) => ("", text, HEADING),
                Row::Item(text) => ("", text, WINDOW),
                Row::Mark(true, text) => ("V ", text, MARK),
                Row::Mark(false, text) => ("  ", text, WINDOW),
            };
            let line = Rect { y, height: 1, ..list };
            let style = if chosen { CHOSEN } else { style };
            cells.set_style(line, style);
            let shown = cut(format!("{mark}{text}"), room(line));
            cells.set_stringn(line.x + 1, y, shown, room(line), style);
        }
        self.draw_scrollers(frame, list, cells);
    }

    /// Draws arrows in the frame where the list continues.
    fn draw_scrollers(&self, frame: Rect, list: Rect, cells: &mut Buffer) {
        let first = self.first_row(list);
        let right = frame.right().saturating_sub(1);
        if first > 0 {
            cells.set_string(right, list.top(), "▲", TITLE);
        }
        if first + usize::from(list.height) < self.rows.len() {
            cells.set_string(right, list.bottom().saturating_sub(1), "▼", TITLE);
        }
    }

    fn draw_summary(&self, frame: Rect, cells: &mut Buffer) {
        window(&self.summary.title).render(frame, cells);
        let lines: Vec<Text> = self.summary.lines.iter().map(|line| Text::from(line.as_str())).collect();
        let area = frame.inner(Margin::new(2, 1));
        Paragraph::new(lines).style(WINDOW).wrap(Wrap { trim: false }).render(area, cells);
    }

    fn draw_keys(&self, bar: Rect, cells: &mut Buffer) {
        cells.set_style(bar, BAR);
        for (place, (key, what)) in self.key_places(bar).into_iter().zip(&self.keys) {
            let (next, _) = cells.set_stringn(place.x, place.y, key, usize::from(place.width), HOT);
            let left = usize::from(place.right().saturating_sub(next + 1));
            cells.set_stringn(next + 1, place.y, what, left, BAR);
        }
    }

    /// Where the keys stand; those without room stand nowhere.
    fn key_places(&self, bar: Rect) -> Vec<Rect> {
        row_of(&self.keys, Rect { x: bar.x + 1, width: bar.width.saturating_sub(1), ..bar }, 2)
    }
}

/// The number of letters in a line of an area, one column from its left edge.
fn room(area: Rect) -> usize {
    usize::from(area.width.saturating_sub(1))
}

/// A text without what there is no room for.
fn cut(text: String, room: usize) -> String {
    match usize::from(width(&text)) > room {
        true => text.chars().take(room.saturating_sub(1)).chain(['…']).collect(),
        false => text,
    }
}

fn width(text: &str) -> u16 {
    u16::try_from(Text::from(text).width()).unwrap_or(u16::MAX)
}

/// The areas of words with their hot keys, side by side, as many as fit.
fn row_of(words: &[(String, String)], area: Rect, gap: u16) -> Vec<Rect> {
    let mut x = area.x;
    let mut places = Vec::new();
    for (key, word) in words {
        let wide = width(key).saturating_add(1).saturating_add(width(word));
        if wide > area.right().saturating_sub(x) {
            break;
        }
        places.push(Rect { x, y: area.y, width: wide, height: 1 });
        x = x.saturating_add(wide).saturating_add(gap);
    }
    places
}

/// An area of the given size, centred in another one.
fn middle(area: Rect, width: u16, height: u16) -> Rect {
    let (width, height) = (width.min(area.width), height.min(area.height));
    Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height }
}

fn framed(title: &str, area: Rect, cells: &mut Buffer) {
    Clear.render(area, cells);
    let title = Span::styled(format!(" {title} "), QUESTION.add_modifier(Modifier::BOLD));
    let block = Block::bordered().border_type(BorderType::Double).style(QUESTION);
    block.title_top(Text::from(title).centered()).render(area, cells);
}

/// The area of a message: wide enough for its lines if possible; otherwise they are wrapped.
fn message_area(area: Rect, lines: &[String], answers: &[(String, String)]) -> Rect {
    let most = area.width.saturating_sub(4);
    let longest = lines.iter().map(|line| width(line)).max().unwrap_or(0);
    let answered: u16 =
        answers.iter().map(|(key, word)| width(key).saturating_add(width(word)).saturating_add(4)).sum();
    let wide = longest.max(answered).saturating_add(6).clamp(30.min(most), most);
    let rows: u16 = lines.iter().map(|line| wrapped(line, wide.saturating_sub(4))).sum();
    middle(area, wide, rows.saturating_add(4))
}

/// The number of rows of a line wrapped at a width.
fn wrapped(line: &str, width: u16) -> u16 {
    let paragraph = Paragraph::new(line).wrap(Wrap { trim: true });
    let probe = Rect { x: 0, y: 0, width: width.max(1), height: 16 };
    let mut cells = Buffer::empty(probe);
    paragraph.render(probe, &mut cells);
    let empty =
        |row: &u16| (0..probe.width).all(|x| cells.cell((x, *row)).is_none_or(|cell| cell.symbol() == " "));
    (0..probe.height).rev().find(|row| !empty(row)).map_or(1, |last| last + 1)
}

fn answer_places(frame: Rect, answers: &[(String, String)]) -> Vec<Rect> {
    let row = Rect {
        x: frame.x + 2,
        y: frame.bottom().saturating_sub(2),
        width: frame.width.saturating_sub(4),
        height: 1,
    };
    row_of(answers, row, 3)
}

fn draw_message(area: Rect, title: &str, lines: &[String], answers: &[(String, String)], cells: &mut Buffer) {
    let frame = message_area(area, lines, answers);
    framed(title, frame, cells);
    let text: Vec<Text> = lines.iter().map(|line| Text::from(line.as_str())).collect();
    let inner = frame.inner(Margin::new(2, 1));
    let inner = Rect { height: inner.height.saturating_sub(2), ..inner };
    Paragraph::new(text).style(QUESTION).wrap(Wrap { trim: true }).render(inner, cells);
    for (place, (key, word)) in answer_places(frame, answers).into_iter().zip(answers) {
        let (next, _) = cells.set_stringn(place.x, place.y, key, usize::from(place.width), HOT);
        cells.set_stringn(
            next + 1,
            place.y,
            word,
            usize::from(place.right().saturating_sub(next + 1)),
            QUESTION,
        );
    }
}

fn draw_entry(area: Rect, title: &str, line: &Line, cells: &mut Buffer) {
    let frame = middle(area, area.width.saturating_sub(8).clamp(40, 64), 3);
    framed(title, frame, cells);
    let field = frame.inner(Margin::new(2, 1));
    cells.set_style(field, FIELD);
    // Scrolled so that the cursor is visible, with one cell per letter.
    let (text, at) = (line.text(), line.cursor());
    let first = at.saturating_sub(usize::from(field.width).saturating_sub(1));
    let seen: String = text.chars().skip(first).collect();
    cells.set_stringn(field.x, field.y, seen, usize::from(field.width), FIELD);
    let before: String = text.chars().skip(first).take(at - first).collect();
    let cursor = field.x.saturating_add(width(&before)).min(field.right().saturating_sub(1));
    if let Some(cell) = cells.cell_mut((cursor, field.y)) {
        cell.set_style(FIELD.add_modifier(Modifier::REVERSED));
    }
}

fn draw_progress(area: Rect, title: &str, (done, total): (usize, usize), now: &str, cells: &mut Buffer) {
    let frame = middle(area, area.width.saturating_sub(8).clamp(40, 60), 5);
    framed(title, frame, cells);
    let [text, _, bar] =
        Layout::vertical([Constraint::Length(1), Constraint::Length(1), Constraint::Length(1)])
            .areas(frame.inner(Margin::new(2, 1)));
    cells.set_stringn(text.x, text.y, now, usize::from(text.width), QUESTION);
    let share = if total == 0 { 1.0 } else { (done.min(total) as f64) / total as f64 };
    Gauge::default().gauge_style(DONE).ratio(share).label(format!("{done} / {total}")).render(bar, cells);
}

fn too_small(language: Language, area: Rect) -> String {
    let (columns, rows) = LEAST;
    let Rect { width, height, .. } = area;
    match language {
        Language::Hungarian => {
            format!("A terminál {width}x{height} karakteres, legalább {columns}x{rows} kell. Esc: kilépés")
        }
        Language::English => {
            format!("The terminal is {width}x{height}; at least {columns}x{rows} are needed. Esc: quit")
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A page with a list of a length.
    pub(in super::super) fn example(length: usize, chosen: usize) -> Page {
        let item = |index: usize| match index % 5 {
            0 => Row::Heading(format!("heading {index}")),
            1 => Row::Mark(true, format!("marked {index}")),
            2 => Row::Mark(false, format!("not marked {index}")),
            _ => Row::Item(format!("item {index}, which is long enough to be cut")),
        };
        Page {
            language: Language::English,
            title: "TITLE".into(),
            list_title: "List".into(),
            rows: (0..length).map(item).collect(),
            chosen,
            summary: Summary { title: "About".into(), lines: vec!["What it is".repeat(9), String::new()] },
            keys: vec![("Enter".into(), "start".into()), ("Esc".into(), "end".into())],
            overlay: None,
        }
    }

    #[test]
    fn the_chosen_line_is_seen_in_any_size() {
        for chosen in 1..40 {
            for rows in LEAST.1..40 {
                let page = example(40, chosen);
                let (Row::Heading(text) | Row::Item(text) | Row::Mark(_, text)) = &page.rows[chosen];
                let shown = page.to_text(80, rows);
                assert!(shown.contains(text.split(',').next().unwrap()), "{chosen} in {rows} rows:\n{shown}");
            }
        }
    }

    fn overlays() -> [Option<Overlay>; 4] {
        let message = Overlay::Message {
            title: "A title".into(),
            lines: vec!["a line ".repeat(40), "x".repeat(200)],
            answers: vec![("Y".into(), "yes".into()), ("N".into(), "no".into())],
        };
        let entry = Overlay::Entry { title: "Where?".into(), line: Line::offering(&"/long/path".repeat(20)) };
        let progress =
            Overlay::Progress { title: "Copying".into(), done: 7, total: 3, now: "file ".repeat(30) };
        [None, Some(message), Some(entry), Some(progress)]
    }

    #[test]
    fn nothing_goes_wrong_in_any_size() {
        for overlay in overlays() {
            for (columns, rows) in (0..100).step_by(7).flat_map(|x| (0..40).step_by(3).map(move |y| (x, y))) {
                let page = Page { overlay: overlay.clone(), ..example(20, 19) };
                let shown = page.to_text(columns, rows);
                let enough = columns >= LEAST.0 && rows >= LEAST.1;
                assert_eq!(enough, shown.contains("═"), "{columns}x{rows}");
                let area = Rect::new(0, 0, columns, rows);
                for (column, row) in [(0, 0), (3, 4), (columns, rows), (u16::MAX, u16::MAX)] {
                    let _ = page.hit(area, column, row);
                }
            }
        }
        assert!(example(3, 1).to_text(60, 8).contains("at least 48x12"));
    }

    #[test]
    fn clicks_hit_what_is_seen() {
        let area = Rect::new(0, 0, 80, 25);
        let page = example(100, 50);
        let shown = page.to_text(80, 25);
        for (row, line) in (0..).zip(shown.lines()) {
            let named = line.split_whitespace().find_map(|word| word.trim_matches(',').parse::<usize>().ok());
            let hit = page.hit(area, 5, row);
            match named.filter(|index| index % 5 > 0 && row > 1 && row < 24) {
                Some(index) => assert_eq!(hit, Some(Hit::Row(index)), "{line}"),
                None => assert!(!matches!(hit, Some(Hit::Row(_))), "{line}"),
            }
        }
        assert_eq!(page.hit(area, 2, 24), Some(Hit::Key(0)));
        assert_eq!(page.hit(area, 15, 24), Some(Hit::Key(1)));
        let overlay = Overlay::Message {
            title: String::new(),
            lines: vec!["Sure?".into()],
            answers: vec![("Y".into(), "yes".into()), ("N".into(), "no".into())],
        };
        let page = Page { overlay: Some(overlay), ..page };
        let shown = page.to_text(80, 25);
        let at = |word: &str| {
            let (row, line) = (0..).zip(shown.lines()).find(|(_, line)| line.contains(word)).unwrap();
            (line.split(word).next().unwrap().chars().count() as u16, row)
        };
        let (column, row) = at("N no");
        assert_eq!(page.hit(area, column, row), Some(Hit::Answer(1)));
        assert_eq!(page.hit(area, 5, 5), None);
    }
}
