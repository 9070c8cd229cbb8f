//! Choosing a stored file: those that fit, of the folder and of the built-in samples, each in a small picture.

use super::files::read_document;
use super::life::Work;
use crate::design::{Design, Shape};
use crate::figure::all_lines;
use crate::file::{CloudFormat, CloudReader, Document, Format, Method, SPACE_VIEW, TableOptions};
use crate::geometry::{BoundingBox, ParamCurve, ParamSurface, Point, View};
use crate::machine::{Asked, Event, Key, Language, Request, SAMPLES, Stop, Storage, Tick};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::words;
use crate::ui::{Accepts, Area, Desk, Entry, Over, Typed, panel, window};
use std::io::Read;

/// The page, and the cells of the small pictures on it.
const PAGE: Area = Area::new(60, 62, 580, 436);
const COLUMNS: usize = 5;
const ROWS: usize = 4;
const CELL: (i32, i32) = (100, 78);
const PICTURE: (i32, i32) = (92, 60);
/// Letters of a name under a picture.
const LETTERS: usize = 11;
/// Letters of a name that is typed.
const LONGEST: usize = 20;
/// Steps of a span in a small picture.
const STEPS: usize = 8;
/// Steps of a patch there.
const MESH: usize = 5;
/// More files than anybody looks through; the others are opened by typing their names.
const MOST: usize = 400;

/// Bytes of a cloud that are read for its small picture, and points that are drawn.
const BEGINNING: u64 = 1 << 16;
const MOST_DOTS: usize = 600;

/// A file that fits.
struct Found {
    name: String,
    /// Whether it is a built-in sample.
    built_in: bool,
    /// Its curve or the lines of its net, in a plane of their own.
    lines: Vec<Vec<Point<2>>>,
}

/// The page while it is open.
struct Chooser {
    found: Vec<Found>,
    entry: Entry,
    /// The index of the chosen one among those that are shown.
    chosen: usize,
}

/// Lets a file of the program's format be chosen by keys, the mouse, or typing its name.
///
/// # Errors
/// [`Stop`]: Esc, or the display is being closed.
pub(crate) async fn choose_file<W: Work>(state: &W, desk: &mut Desk<'_>) -> Asked<String> {
    let area = Area::new(PAGE.x1 + 150, PAGE.y2 - 22, PAGE.x1 + 330, PAGE.y2 - 9);
    let entry = Entry::new(area, (area.x1 + 8, area.y1 + 3), LONGEST, Accepts::Name);
    let endings: Vec<String> = state.extensions().iter().map(|it| format!(".{it}")).collect();
    let found = fitting(desk.machine.storage(), state.format(), &endings);
    let mut chooser = Chooser { found, entry, chosen: 0 };
    let ending = endings.into_iter().next().unwrap_or_default();
    loop {
        let over = Over::new(state, |screen: &mut Screen, language: Language| {
            chooser.draw(screen, language, &ending);
        });
        let tick = desk.event_asked(&over, Request::Text).await?;
        if let Some(name) = chooser.event(&tick, &ending)? {
            return Ok(name);
        }
    }
}

/// The files of a format, which have one of some endings, those of the folder first.
fn fitting(storage: &dyn Storage, format: Format, endings: &[String]) -> Vec<Found> {
    let endings: Vec<String> = endings.iter().map(|ending| ending.to_ascii_lowercase()).collect();
    let fits = |name: &str| endings.iter().any(|ending| name.to_ascii_lowercase().ends_with(ending));
    let mut own: Vec<String> = storage.names().into_iter().filter(|name| fits(name)).collect();
    own.sort_by_key(|name| name.to_ascii_lowercase());
    own.truncate(MOST);
    let hidden = |sample: &str| own.iter().any(|name| name.eq_ignore_ascii_case(sample));
    let samples = SAMPLES.iter().map(|&(name, _)| name).filter(|name| fits(name) && !hidden(name));
    let samples: Vec<String> = samples.map(str::to_owned).collect();
    let named = |built_in: bool| move |name: String| (name, built_in);
    let names = own.into_iter().map(named(false)).chain(samples.into_iter().map(named(true)));
    // What cannot be read is left out only where the name alone does not say that it fits.
    let readable = names.filter_map(|(name, built_in)| {
        if let Some(cloud) = cloud_format(&name) {
            let lines = beginning(storage, &name, cloud).map(|points| dots(&points)).unwrap_or_default();
            return Some(Found { name, built_in, lines });
        }
        let document = read_document(storage, &name, Format::from_name(&name).unwrap_or(format)).ok();
        let lines = document.as_ref().map(lines_of).unwrap_or_default();
        (document.is_some() || endings != [".json"]).then_some(Found { name, built_in, lines })
    });
    readable.collect()
}

/// The format of the cloud that a file of this name holds, if it does.
fn cloud_format(name: &str) -> Option<CloudFormat> {
    name.rsplit_once('.').and_then(|(_, extension)| CloudFormat::from_extension(extension))
}

/// The points at the beginning of a cloud, which may be too large to be read just to show it.
fn beginning(storage: &dyn Storage, name: &str, format: CloudFormat) -> Option<Vec<Point<3>>> {
    let mut reader = CloudReader::new(format, &TableOptions::default()).ok()?;
    let mut piece = Vec::new();
    storage.stream(name).ok()?.content.take(BEGINNING).read_to_end(&mut piece).ok()?;
    reader.feed(&piece).ok()?;
    match reader.points() {
        [] => reader.finish().ok().map(|cloud| cloud.points),
        points => Some(points.to_vec()),
    }
}

/// Points as lines without length, every n-th of many.
fn dots(points: &[Point<3>]) -> Vec<Vec<Point<2>>> {
    let view = View::from_direction(SPACE_VIEW);
    let flat = points.iter().all(|[_, _, z]| *z == 0.0);
    let place = |point: &Point<3>| if flat { [point[0], point[1]] } else { view.place(*point) };
    let every = points.len().div_ceil(MOST_DOTS).max(1);
    points.iter().step_by(every).map(|point| vec![place(point); 2]).collect()
}

/// The lines that a document is recognised by: its curve, or its net.
fn lines_of(document: &Document) -> Vec<Vec<Point<2>>> {
    let view = View::from_direction(SPACE_VIEW);
    let net = match document {
        Document::Net(net) => Some(&net.points),
        Document::KnotNet(net) => Some(&net.points),
        Document::Som(net) => Some(&net.points),
        _ => None,
    };
    if let Some(net) = net {
        let rows = net.iter().cloned();
        let longest = net.iter().map(Vec::len).max().unwrap_or(0);
        let column = |at: usize| net.iter().filter_map(|row| row.get(at).copied()).collect();
        let lines = rows.chain((0..longest).map(column));
        return lines.map(|line| line.into_iter().map(|point| view.place(point)).collect()).collect();
    }
    let mut document = document.clone();
    match &mut document {
        Document::PlanePoints(plane) if plane.settings.method.is_none() => {
            plane.settings.method =
                Some(if plane.tangents.is_some() { Method::Hermite } else { Method::Spline });
        }
        Document::SpacePoints(space) => {
            let usual = if space.tangents.is_some() { Method::Hermite } else { Method::Spline };
            space.settings.method = space.settings.method.or(Some(usual));
        }
        _ => {}
    }
    match Design::of_document(document).and_then(|design| design.shape()) {
        Ok(Shape::Plane(curve)) => curve.polyline(STEPS).into_iter().collect(),
        Ok(Shape::Space(curve)) => {
            let line = curve.polyline(STEPS).unwrap_or_default();
            vec![line.into_iter().map(|point| view.place(point)).collect()]
        }
        Ok(Shape::Parts(parts)) => {
            let curves = parts.curves.iter().map(|curve| curve.polyline(STEPS).unwrap_or_default());
            let mut lines: Vec<Vec<Point<2>>> =
                curves.map(|line| line.into_iter().map(|point| view.place(point)).collect()).collect();
            let grids = parts.patches.iter().filter_map(|patch| patch.grid(MESH).ok());
            lines.extend(grids.flat_map(|grid| all_lines(&grid, &view)));
            lines
        }
        Ok(Shape::Outlines(outlines)) => {
            outlines.iter().map(|outline| outline.polyline(STEPS).unwrap_or_default()).collect()
        }
        Ok(Shape::Surface(_)) | Err(_) => Vec::new(),
    }
}

impl Chooser {
    /// Those whose names begin as what is typed.
    fn shown(&self) -> impl Iterator<Item = &Found> {
        let typed = self.entry.text.to_ascii_lowercase();
        self.found.iter().filter(move |found| found.name.to_ascii_lowercase().starts_with(&typed))
    }

    /// The first row on the page, so that the chosen one is on it.
    fn first_row(&self) -> usize {
        (self.chosen / COLUMNS).saturating_sub(ROWS - 1)
    }

    /// The place of a cell, counted from the first on the page.
    fn cell(at: usize) -> Area {
        // There are few cells.
        let (column, row) = ((at % COLUMNS) as i32, (at / COLUMNS) as i32);
        let (x, y) = (PAGE.x1 + 12 + column * CELL.0, PAGE.y1 + 26 + row * CELL.1);
        Area::new(x, y, x + PICTURE.0, y + PICTURE.1)
    }

    fn cancel() -> Area {
        Area::new(PAGE.x2 - 56, PAGE.y1 + 4, PAGE.x2 - 8, PAGE.y1 + 20)
    }

    /// The name that an event decides for.
    fn event(&mut self, tick: &Tick, ending: &str) -> Asked<Option<String>> {
        let count = self.shown().count();
        let last = count.saturating_sub(1);
        let mut step = |by: isize| self.chosen = self.chosen.saturating_add_signed(by).min(last);
        match tick.event {
            Some(Event::Wheel(steps)) => step(if steps > 0 { -(COLUMNS as isize) } else { COLUMNS as isize }),
            Some(Event::Key(Key::Left)) => step(-1),
            Some(Event::Key(Key::Right)) => step(1),
            Some(Event::Key(Key::Up)) => step(-(COLUMNS as isize)),
            Some(Event::Key(Key::Down)) => step(COLUMNS as isize),
            Some(Event::Key(Key::PageUp)) => step(-((ROWS * COLUMNS) as isize)),
            Some(Event::Key(Key::PageDown)) => step((ROWS * COLUMNS) as isize),
            Some(Event::Key(Key::Home)) => self.chosen = 0,
            Some(Event::Key(Key::End)) => self.chosen = last,
            Some(Event::Key(key)) => match self.entry.key(key) {
                Typed::On => self.chosen = 0,
                Typed::Cancelled => return Err(Stop::Cancelled),
                Typed::Done => {
                    let typed = self.entry.text.strip_suffix(ending).unwrap_or(&self.entry.text);
                    let whole = format!("{typed}{ending}");
                    let same = self.shown().find(|found| found.name.eq_ignore_ascii_case(&whole));
                    let chosen = same.or_else(|| self.shown().nth(self.chosen));
                    let name = chosen.map(|found| found.name.clone());
                    return Ok(name.or((!typed.is_empty()).then_some(whole)));
                }
            },
            Some(Event::Move(x, y)) => self.chosen = self.under((x, y)).unwrap_or(self.chosen),
            _ => {
                let Some(at) = tick.click() else { return Ok(None) };
                if Chooser::cancel().holds(at.0, at.1) {
                    return Err(Stop::Cancelled);
                }
                return Ok(self
                    .under(at)
                    .and_then(|at| self.shown().nth(at))
                    .map(|found| found.name.clone()));
            }
        }
        Ok(None)
    }

    /// The index of the picture at a pixel.
    fn under(&self, (x, y): (i32, i32)) -> Option<usize> {
        let first = COLUMNS * self.first_row();
        let on_page = (0..ROWS * COLUMNS).find(|&at| Chooser::cell(at).holds(x, y))?;
        Some(first + on_page).filter(|&at| at < self.shown().count())
    }

    fn draw(&self, screen: &mut Screen, language: Language, ending: &str) {
        let Area { x1, y1, x2, y2 } = PAGE;
        panel(screen, x1, y1, x2 - x1, y2 - y1);
        screen.text(x1 + 12, y1 + 9, words::CHOOSE_FILE.of(language), Color::Black);
        screen.text(Chooser::cancel().x1 + 4, y1 + 9, "x Esc", Color::LightRed);
        let first = COLUMNS * self.first_row();
        for (at, found) in self.shown().enumerate().skip(first).take(ROWS * COLUMNS) {
            found.draw(screen, Chooser::cell(at - first), at == self.chosen);
        }
        if self.shown().next().is_none() {
            screen.text(x1 + 12, y1 + 40, words::NO_FITTING_FILE.of(language), Color::Black);
        }
        let rows = self.shown().count().div_ceil(COLUMNS);
        if rows > ROWS {
            let text = format!("{} / {rows}", self.chosen / COLUMNS + 1);
            screen.text(x2 - 90, y2 - 19, &text, Color::Black);
        }
        screen.text(x1 + 12, y2 - 19, words::FILE_NAME.of(language), Color::Black);
        self.entry.draw(screen);
        screen.text(self.entry.area.x2 + 6, y2 - 19, ending, Color::Black);
    }
}

impl Found {
    fn draw(&self, screen: &mut Screen, area: Area, chosen: bool) {
        window(screen, area);
        if chosen {
            for grown in [2, 3] {
                let corners = [
                    (area.x1 - grown, area.y1 - grown),
                    (area.x2 + grown, area.y1 - grown),
                    (area.x2 + grown, area.y2 + grown),
                    (area.x1 - grown, area.y2 + grown),
                    (area.x1 - grown, area.y1 - grown),
                ];
                screen.polyline(&corners, Stroke::thin(Color::Blue));
            }
        }
        let room = Area::new(area.x1 + 6, area.y1 + 5, area.x2 - 6, area.y2 - 5);
        let points: Vec<Point<2>> = self.lines.concat();
        if let Some(bounds) = BoundingBox::of_points(&points) {
            for line in &self.lines {
                screen.polyline(&fitted(line, &bounds, room), Stroke::thin(Color::White));
            }
        }
        let name: String = self.name.chars().take(LETTERS).collect();
        let ink = if self.built_in { Color::Blue } else { Color::Black };
        screen.text(area.x1, area.y2 + 6, &name, ink);
    }
}

/// A line in an area of the screen, as large as it goes in.
fn fitted(line: &[Point<2>], bounds: &BoundingBox<2>, room: Area) -> Vec<(i32, i32)> {
    let extent = |axis: usize| bounds.max[axis] - bounds.min[axis];
    let (width, height) = (f64::from(room.x2 - room.x1), f64::from(room.y2 - room.y1));
    let scale = (width / extent(0)).min(height / extent(1));
    let scale = if scale.is_finite() { scale } else { 0.0 };
    let middle = |axis: usize| 0.5 * (bounds.max[axis] + bounds.min[axis]);
    let center = (0.5 * f64::from(room.x1 + room.x2), 0.5 * f64::from(room.y1 + room.y2));
    let place = |&[x, y]: &Point<2>| {
        // The conversion saturates.
        let across = center.0 + scale * (x - middle(0));
        let down = center.1 - scale * (y - middle(1));
        (across.round() as i32, down.round() as i32)
    };
    line.iter().map(place).collect()
}
