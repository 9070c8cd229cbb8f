//! The dialog of a space: its roots and its interval, with the functions and the verdict on the interval beside them.

use super::asking::{ask_key, whole};
use super::studio::Studio;
use super::texts;
use crate::file::ec::{EcDocument, Interval, Item, SpaceFile, values};
use crate::geometry::Point;
use crate::geometry::ec::{CriticalLength, EcBasis, EcError, MAX_DIMENSION, Real, Root, Space};
use crate::machine::{Asked, Asking, Key, Language, Request, Stop};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::words::{Hot, Phrase, Words};
use crate::ui::{
    Answer, Area, Command, Commands, Desk, KeyHelp, Picture, Question, Stay, TOP, line, page, panel, sunken,
    window,
};
use serde::Serialize;

/// The rows of roots, and where they and the graphs stand.
const ROWS: usize = 8;
const LIST: Area = Area::new(28, 70, 236, 300);
const GRAPH: Area = Area::new(252, 66, 630, 380);
/// Values of the graphs from the lower to the upper edge.
const RANGE: [f64; 2] = [-0.5, 1.5];
/// Steps of a graph.
const STEPS: u32 = 180;

#[derive(Clone, Copy)]
enum Do {
    Add,
    Change,
    Delete,
    Undo,
    Ready,
    Load,
    Keep,
    Preset,
    Graphs,
    Scroll(bool),
}

const fn at(x: i32, y: i32, text: Hot) -> crate::ui::Button {
    crate::ui::Button::new(x, y, text)
}

const HELP: KeyHelp = line("B V T U R O M P F", "lásd a gombokat", "see the buttons");

const COMMANDS: Commands<Do> = Commands(&[
    Command::button(at(460, 4, Hot::new('B', "-gyök", "-root")), HELP, Do::Add),
    Command::button(at(460, 21, Hot::new('V', "áltozás", "-change")), HELP, Do::Change),
    Command::button(at(460, 38, Hot::new('T', "örlés", "-delete")), HELP, Do::Delete),
    Command::button(at(550, 4, Hot::new('U', "-vissza", "-undo")), HELP, Do::Undo),
    Command::button(at(550, 21, Hot::new('R', "endben", "-ready")), HELP, Do::Ready),
    Command::button(at(30, 21, Hot::new('O', "-betölt", "-load")), HELP, Do::Load),
    Command::button(at(120, 21, Hot::new('M', "-jegyez", "-keep")), HELP, Do::Keep),
    Command::button(at(30, 38, Hot::new('P', "-minta", "-preset")), HELP, Do::Preset),
    Command::button(at(120, 38, Hot::new('F', "üggvény", "-funct.")), HELP, Do::Graphs),
    Command::also(Key::PageUp, Do::Scroll(false)),
    Command::also(Key::PageDown, Do::Scroll(true)),
]);

/// What is known of an interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    /// The search goes on.
    Open,
    Good,
    TooLong,
    TooShort,
    TooLarge,
}

/// The dialog as `dump` tells it.
#[derive(Serialize)]
pub(super) struct Told {
    roots: Vec<Root>,
    interval: Interval,
    verdict: &'static str,
    critical: Option<f64>,
    dimension: usize,
}

struct Dialog {
    title: Words,
    roots: Vec<Root>,
    interval: Interval,
    /// The first row that is seen.
    first: usize,
    /// Which graphs are seen.
    graphs: usize,
    ground: u8,
    /// What follows from roots and interval.
    space: Result<Space, EcError>,
    basis: Result<Option<EcBasis>, EcError>,
    search: Option<CriticalLength>,
    own: Option<CriticalLength>,
}

impl Dialog {
    fn new(title: Words, space: &Space, interval: &Interval) -> Dialog {
        let mut dialog = Dialog {
            title,
            roots: space.roots().to_vec(),
            interval: interval.clone(),
            first: 0,
            graphs: 0,
            ground: 0,
            space: Ok(space.clone()),
            basis: Ok(None),
            search: None,
            own: None,
        };
        dialog.follow();
        dialog
    }

    /// Computes anew what follows from roots and interval.
    fn follow(&mut self) {
        self.space = Space::new(self.roots.clone());
        if let Ok(space) = &self.space {
            self.roots = space.roots().to_vec();
        }
        self.basis = match &self.space {
            Ok(space) => EcBasis::formal(space, values(&self.interval)),
            Err(error) => Err(error.clone()),
        };
        self.search = self.space.as_ref().ok().map(CriticalLength::new);
        self.own = self.space.as_ref().ok().map(CriticalLength::of_itself);
        self.first = self.first.min(self.roots.len().saturating_sub(1));
    }

    /// Goes on with the searches; whether there is more to do.
    fn advance(&mut self) -> bool {
        let dimension = self.roots.iter().map(Root::dimension).sum();
        for search in [&mut self.search, &mut self.own].into_iter().flatten() {
            for _ in 0..budget(dimension) {
                if search.advance().is_some() {
                    break;
                }
            }
            if search.result().is_none() {
                return true;
            }
        }
        false
    }

    fn critical(&self) -> Option<f64> {
        self.search.as_ref()?.result()
    }

    fn verdict(&self) -> Verdict {
        let [start, end] = values(&self.interval);
        match (&self.space, &self.basis) {
            (Err(_), _) => return Verdict::TooLarge,
            (_, Err(EcError::TooShort { .. } | EcError::Interval { .. })) => return Verdict::TooShort,
            (_, Err(_)) => return Verdict::TooLarge,
            _ => {}
        }
        match self.search.as_ref().and_then(|search| search.admits(end - start)) {
            None => Verdict::Open,
            Some(false) => Verdict::TooLong,
            Some(true) => match &self.basis {
                Ok(Some(basis)) if basis.is_precise() => Verdict::Good,
                _ => Verdict::TooLarge,
            },
        }
    }

    fn told(&self) -> Told {
        Told {
            roots: self.roots.clone(),
            interval: self.interval.clone(),
            verdict: match self.verdict() {
                Verdict::Open => "open",
                Verdict::Good => "good",
                Verdict::TooLong => "too long",
                Verdict::TooShort => "too short",
                Verdict::TooLarge => "too large",
            },
            critical: self.critical().filter(|length| length.is_finite()),
            dimension: self.roots.iter().map(Root::dimension).sum(),
        }
    }

    /// The values of the functions at a part of the interval.
    fn graph(&self, basis: &EcBasis, s: f64) -> Vec<f64> {
        let mut values_at = Vec::new();
        match self.graphs {
            1 => {
                basis.derivatives(1, s, &mut values_at);
                // As tall as the values themselves, roughly.
                values_at.iter_mut().for_each(|value| *value /= 4.0);
            }
            2 => {
                let [start, _] = basis.interval();
                values_at = basis.space().ordinary(0, start + s * basis.length());
            }
            3 => values_at = basis.canonical(s),
            _ => basis.derivatives(0, s, &mut values_at),
        }
        values_at
    }

    fn draw_graphs(&self, screen: &mut Screen, language: Language) {
        let area = GRAPH;
        screen.bar(area.x1, area.y1, area.x2, area.y2, Color::from_index(self.ground));
        let good = self.verdict() == Verdict::Good || self.graphs > 1;
        let [low, high] = RANGE;
        let place = |s: f64, value: f64| {
            let x = f64::from(area.x1 + 4) + s * f64::from(area.x2 - area.x1 - 8);
            let part = (value.clamp(low, high) - low) / (high - low);
            (
                x.round() as i32,
                (f64::from(area.y2) - 2.0 - part * f64::from(area.y2 - area.y1 - 4)).round() as i32,
            )
        };
        let axis = Stroke::thin(Color::DarkGray);
        for value in [0.0, 1.0] {
            let (from, to) = (place(0.0, value), place(1.0, value));
            screen.line(from.0, from.1, to.0, to.1, axis);
            screen.text(from.0, from.1 - 9, &value.to_string(), Color::LightGray);
        }
        if let Ok(Some(basis)) = &self.basis {
            let columns: Vec<(f64, Vec<f64>)> = (0..=STEPS)
                .map(|k| f64::from(k) / f64::from(STEPS))
                .map(|s| (s, self.graph(basis, s)))
                .collect();
            let dimension = basis.space().dimension();
            for i in 0..dimension {
                let color = if good { GRAPH_COLORS[i % GRAPH_COLORS.len()] } else { Color::LightRed };
                let line: Vec<(i32, i32)> = columns
                    .iter()
                    .filter_map(|(s, values)| {
                        values.get(i).filter(|it| it.is_finite()).map(|it| place(*s, *it))
                    })
                    .collect();
                screen.polyline(&line, Stroke::thin(color));
            }
            if self.graphs == 4 {
                let text = format!("{}: {:.0e}", texts::PRECISION.of(language), basis.precision());
                screen.text(area.x1 + 20, area.y1 + 30, &text, Color::Yellow);
            }
        }
        screen.text(area.x1 + 8, area.y1 + 8, texts::GRAPHS[self.graphs].of(language), Color::Yellow);
        let ends = values(&self.interval).map(super::rows::short);
        screen.text(area.x1 + 4, area.y2 - 12, &ends[0], Color::LightGray);
        let width = 8 * i32::try_from(ends[1].chars().count()).unwrap_or(0);
        screen.text(area.x2 - 4 - width, area.y2 - 12, &ends[1], Color::LightGray);
    }

    fn draw_roots(&self, screen: &mut Screen, language: Language) {
        let Area { x1, y1, x2, y2 } = LIST;
        panel(screen, x1, y1, x2 - x1, y2 - y1);
        screen.text(x1 + 18, y1 + 6, texts::ROOT_HEADER.of(language), Color::Black);
        for row in 0..ROWS {
            let y = y1 + 20 + 17 * i32::try_from(row).unwrap_or(0);
            screen.text(x1 + 4, y + 3, &(row + 1).to_string(), Color::Red);
            window(screen, Area::new(x1 + 16, y, x1 + 136, y + 13));
            window(screen, Area::new(x1 + 142, y, x1 + 166, y + 13));
            if let Some(root) = self.roots.get(self.first + row) {
                let text: String = root.number().chars().take(14).collect();
                screen.text(x1 + 20, y + 3, &text, Color::White);
                screen.text(x1 + 146, y + 3, &root.multiplicity.to_string(), Color::White);
                screen.text(x1 + 174, y + 3, &root.dimension().to_string(), Color::Black);
            }
        }
        for (row, (letter, end)) in ['A', 'E'].into_iter().zip(&self.interval).enumerate() {
            let y = y1 + 164 + 20 * i32::try_from(row).unwrap_or(0);
            screen.text(x1 + 4, y + 3, letter.encode_utf8(&mut [0; 4]), Color::Red);
            window(screen, Area::new(x1 + 16, y, x1 + 116, y + 13));
            let text: String = end.to_string().chars().take(11).collect();
            screen.text(x1 + 20, y + 3, &text, Color::White);
            screen.text(x1 + 122, y + 3, &super::rows::short(end.value()), Color::Black);
        }
        let y = y1 + 208;
        screen.text(x1 + 4, y + 3, "H", Color::Red);
        let ground = texts::COLORS[usize::from(self.ground & 15)].of(language);
        screen.text(x1 + 20, y + 3, ground, Color::Black);
    }

    fn draw_facts(&self, screen: &mut Screen, language: Language) {
        let y = GRAPH.y2 + 14;
        let dimension: usize = self.roots.iter().map(Root::dimension).sum();
        let [start, end] = values(&self.interval);
        let length = |search: &Option<CriticalLength>, digits: usize| match search
            .as_ref()
            .and_then(CriticalLength::result)
        {
            Some(length) if length.is_finite() => format!("{length:.digits$}"),
            Some(_) => "inf".to_owned(),
            None => "...".to_owned(),
        };
        let facts = format!(
            "{} {dimension}   h = {}   l' = {}   l = {}",
            texts::DIMENSION.of(language),
            super::rows::short(end - start),
            length(&self.search, 4),
            length(&self.own, 4)
        );
        screen.text(28, y, &facts, Color::Black);
        let (text, color) = match self.verdict() {
            Verdict::Open => ("...", Color::Blue),
            Verdict::Good => (texts::GOOD.of(language), Color::Green),
            Verdict::TooLong => (texts::LONG.of(language), Color::LightRed),
            Verdict::TooShort => (texts::SHORT.of(language), Color::LightRed),
            Verdict::TooLarge => (texts::LARGE.of(language), Color::LightRed),
        };
        let more = match (self.verdict(), self.critical()) {
            (Verdict::Good, Some(critical)) if critical.is_finite() => {
                format!(" ({:.0} % l')", 100.0 * (end - start) / critical)
            }
            (Verdict::TooLong, Some(critical)) => {
                format!(" ({} {:.4})", texts::AT_MOST.of(language), start + 0.999 * critical)
            }
            _ => String::new(),
        };
        screen.text(460, y, &format!("{text}{more}"), color);
        if let Ok(space) = &self.space {
            let lines = [space.equation("v"), space.functions("u").join(", ")];
            for (row, text) in (0..).zip(lines.iter().flat_map(|it| crate::figure::wrap(it, 72)).take(6)) {
                screen.text(28, y + 14 + 12 * row, &text, Color::Black);
            }
        }
    }
}

/// How many steps of a search for a critical length fit between two pictures: one costs about the fourth power of the
/// dimension.
pub(super) fn budget(dimension: usize) -> usize {
    match dimension {
        ..14 => 120,
        14..20 => 20,
        _ => 4,
    }
}

/// Colours of the functions.
const GRAPH_COLORS: [Color; 7] = [
    Color::White,
    Color::Yellow,
    Color::LightGreen,
    Color::LightCyan,
    Color::LightMagenta,
    Color::LightBlue,
    Color::LightGray,
];

impl Picture for Dialog {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::LightCyan);
        screen.text(30, 6, self.title.of(language), Color::Black);
        page(screen, TOP);
        COMMANDS.draw(screen, language);
        sunken(screen, Area::new(GRAPH.x1 - 4, GRAPH.y1 - 4, GRAPH.x2 + 4, GRAPH.y2 + 4), 4);
        self.draw_graphs(screen, language);
        self.draw_roots(screen, language);
        self.draw_facts(screen, language);
    }
}

/// Shows the dialog until its space is accepted; Esc leaves everything as it was.
///
/// # Errors
/// [`Stop`]: Esc, or the display is being closed.
pub(super) async fn edit(
    studio: &mut Studio,
    desk: &mut Desk<'_>,
    title: Words,
    (space, interval): (&Space, &Interval),
) -> Asked<(Space, Interval)> {
    let mut dialog = Dialog::new(title, space, interval);
    loop {
        let busy = dialog.advance();
        studio.publish(desk, dialog.told());
        let now = desk.machine.now();
        let tick = if busy {
            desk.event_before(&dialog, now).await?
        } else {
            desk.event_asked(&dialog, Request::Keys(COMMANDS.keys())).await?
        };
        if tick.pressed(Key::Esc) {
            return Err(Stop::Cancelled);
        }
        let Some(command) = COMMANDS.find(&tick) else { continue };
        if let Some(done) = carry_out(studio, desk, &mut dialog, command, (space, interval))
            .await
            .unless_cancelled()?
            .flatten()
        {
            return Ok(done);
        }
    }
}

async fn carry_out(
    studio: &mut Studio,
    desk: &mut Desk<'_>,
    dialog: &mut Dialog,
    command: Do,
    (space, interval): (&Space, &Interval),
) -> Asked<Option<(Space, Interval)>> {
    match command {
        Do::Add => {
            let root = ask_root(desk, dialog, "i", None).await?;
            let multiplicity = ask_multiplicity(desk, dialog, 1).await?;
            dialog.roots.push(Root { multiplicity, ..root });
            too_large(desk, dialog);
            dialog.follow();
        }
        Do::Change => change(desk, dialog).await?,
        Do::Delete => {
            let first = dialog.first;
            let count = dialog.roots.len();
            let row = ask_key(desk, &*dialog, texts::ASK_DELETED_ROW, "1 ... 8", |tick| {
                let row = tick.letter()?.to_digit(10)?.checked_sub(1)? as usize;
                (row < ROWS && first + row < count).then_some(first + row)
            })
            .await?;
            match dialog.roots.get(row) {
                Some(root) if root.is_zero() => desk.tell(texts::ZERO_STAYS, Stay::UntilRead),
                Some(_) => {
                    dialog.roots.remove(row);
                    dialog.follow();
                }
                None => desk.tell(texts::NO_SUCH_ROW, Stay::Briefly),
            }
        }
        Do::Undo => *dialog = Dialog::new(dialog.title, space, interval),
        Do::Ready => {
            while dialog.verdict() == Verdict::Open && dialog.advance() {}
            let found = match (&dialog.space, dialog.verdict()) {
                (Ok(space), Verdict::Good) => return Ok(Some((space.clone(), dialog.interval.clone()))),
                (Err(error), _) => Err(error.clone()),
                (Ok(space), _) => EcBasis::new(space, values(&dialog.interval)).map(|_| ()),
            };
            match found {
                Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
                Ok(()) => desk.tell(texts::NOT_GOOD, Stay::UntilRead),
            }
        }
        Do::Load => {
            let question = Question::new(TOP, texts::ASK_WHERE_FROM, [texts::BUFFER, texts::FILE]);
            let loaded = match desk.ask(&*dialog, &question).await? {
                Answer::First => studio.kept_space.clone().ok_or(Phrase::from(texts::NOTHING_KEPT)),
                Answer::Second => {
                    let name = studio.ask_file(desk).await?;
                    match studio.read_file(desk, &name) {
                        Ok(EcDocument::Space(file)) => Ok(file),
                        Ok(EcDocument::Curve(curve)) => Ok(SpaceFile {
                            space: curve.space,
                            interval: Some(curve.interval),
                            name: curve.name,
                        }),
                        Ok(_) => Err(texts::NO_DOCUMENT.into()),
                        Err(problem) => Err(problem),
                    }
                }
            };
            match loaded {
                Ok(file) => {
                    dialog.roots = file.space.roots().to_vec();
                    dialog.interval = file.interval.unwrap_or(dialog.interval.clone());
                    dialog.follow();
                }
                Err(problem) => desk.tell(problem, Stay::UntilRead),
            }
        }
        Do::Keep => {
            let Ok(space) = dialog.space.clone() else { return Ok(None) };
            let file = SpaceFile { space, interval: Some(dialog.interval.clone()), name: None };
            let question = Question::new(TOP, texts::ASK_WHERE_TO, [texts::BUFFER, texts::FILE]);
            match desk.ask(&*dialog, &question).await? {
                Answer::First => {
                    studio.kept_space = Some(file);
                    desk.tell(texts::KEPT, Stay::Briefly);
                }
                Answer::Second => super::files::store(studio, desk, EcDocument::Space(file)).await?,
            }
        }
        Do::Preset => {
            let read = |text: &str| text.parse::<Space>().map_err(|error| texts::problem(&error));
            let preset = desk.meaning(&*dialog, texts::ASK_PRESET, "T1", read).await?;
            dialog.roots = preset.roots().to_vec();
            dialog.follow();
        }
        Do::Graphs => dialog.graphs = (dialog.graphs + 1) % texts::GRAPHS.len(),
        Do::Scroll(down) => {
            let last = dialog.roots.len().saturating_sub(ROWS);
            dialog.first =
                if down { (dialog.first + ROWS).min(last) } else { dialog.first.saturating_sub(ROWS) };
        }
    }
    Ok(None)
}

/// Changes a root, an end of the interval, or the ground.
async fn change(desk: &mut Desk<'_>, dialog: &mut Dialog) -> Asked<()> {
    let first = dialog.first;
    let count = dialog.roots.len();
    let row = ask_key(desk, &*dialog, texts::ASK_ROOT_ROW, "1 ... 8  A E H", |tick| match tick.letter()? {
        letter @ ('A' | 'E' | 'H') => Some(Err(letter)),
        digit => {
            let row = digit.to_digit(10)?.checked_sub(1)? as usize;
            (row < ROWS && first + row < count).then_some(Ok(first + row))
        }
    })
    .await?;
    match row {
        Err('H') => dialog.ground = (dialog.ground + 1) % 16,
        Err(letter) => {
            let end = usize::from(letter == 'E');
            let caption = if end == 0 { texts::ASK_START } else { texts::ASK_END };
            let present = dialog.interval[end].to_string();
            let other = dialog.interval[1 - end].value();
            let read = |text: &str| {
                let real = Real::typed(text).map_err(|error| texts::problem(&error))?;
                let [start, stop] = if end == 0 { [real.value(), other] } else { [other, real.value()] };
                match start < stop {
                    true => Ok(real),
                    false => Err(texts::problem(&EcError::Interval { start, end: stop })),
                }
            };
            dialog.interval[end] = desk.meaning(&*dialog, caption, &present, read).await?;
            dialog.follow();
        }
        Ok(row) => {
            let Some(old) = dialog.roots.get(row).cloned() else { return Ok(()) };
            let root = match old.is_zero() {
                true => old.clone(),
                false => ask_root(desk, dialog, &old.number(), Some(row)).await?,
            };
            let multiplicity = ask_multiplicity(desk, dialog, old.multiplicity).await?;
            if let Some(slot) = dialog.roots.get_mut(row) {
                *slot = Root { multiplicity, ..root };
            }
            too_large(desk, dialog);
            dialog.follow();
        }
    }
    Ok(())
}

/// Says when the space has become too large.
fn too_large(desk: &mut Desk<'_>, dialog: &Dialog) {
    if let Err(error) = Space::new(dialog.roots.clone()) {
        desk.tell(texts::problem(&error), Stay::UntilRead);
    }
}

/// Asks for a root that is not there yet, but for the one that is changed.
async fn ask_root(desk: &mut Desk<'_>, dialog: &Dialog, proposal: &str, row: Option<usize>) -> Asked<Root> {
    let read = |text: &str| {
        let root: Root = text.parse().map_err(|error| texts::problem(&error))?;
        let twice = dialog.roots.iter().enumerate().any(|(at, other)| Some(at) != row && other.is(&root));
        match twice {
            true => Err(texts::problem(&EcError::Twice { root: root.number() })),
            false => Ok(root),
        }
    };
    desk.meaning(dialog, texts::ASK_ROOT, proposal, read).await
}

async fn ask_multiplicity(desk: &mut Desk<'_>, dialog: &Dialog, proposal: usize) -> Asked<usize> {
    let most = i64::try_from(MAX_DIMENSION).unwrap_or(31);
    desk.meaning(dialog, texts::ASK_MULTIPLICITY, &proposal.to_string(), |text| whole(text, [1, most])).await
}

/// As many points as a space needs: the first ones, or more along the last leg.
pub(super) fn fitting_points(points: &[Point<3>], count: usize) -> Vec<Point<3>> {
    let mut points: Vec<Point<3>> = points.iter().take(count).copied().collect();
    while points.len() < count {
        let next = match points.as_slice() {
            [.., a, b] => std::array::from_fn(|d| 2.0 * b[d] - a[d]),
            [only] => std::array::from_fn(|d| only[d] + if d == 0 { 20.0 } else { 0.0 }),
            [] => [0.0; 3],
        };
        points.push(next.map(|x: f64| x.clamp(-super::edit::FARTHEST, super::edit::FARTHEST)));
    }
    points
}

/// The item with another space, and its points as far as they go.
pub(super) fn with_space(item: &Item, direction: usize, space: &Space, interval: &Interval) -> Item {
    let count = space.dimension();
    match item {
        Item::Curve(curve) => {
            let mut curve = curve.clone();
            curve.points = fitting_points(&curve.points, count);
            (curve.space, curve.interval, curve.exact) = (space.clone(), interval.clone(), None);
            Item::Curve(curve)
        }
        Item::Patch(patch) => {
            let mut patch = patch.clone();
            patch.exact = None;
            if direction == 0 {
                let columns = patch.net.first().map_or(0, Vec::len);
                let changed: Vec<Vec<Point<3>>> = (0..columns)
                    .map(|l| {
                        let column: Vec<Point<3>> =
                            patch.net.iter().filter_map(|row| row.get(l)).copied().collect();
                        fitting_points(&column, count)
                    })
                    .collect();
                patch.net = (0..count)
                    .map(|k| changed.iter().filter_map(|column| column.get(k)).copied().collect())
                    .collect();
                (patch.space_u, patch.interval_u) = (space.clone(), interval.clone());
            } else {
                patch.net = patch.net.iter().map(|row| fitting_points(row, count)).collect();
                (patch.space_v, patch.interval_v) = (space.clone(), interval.clone());
            }
            Item::Patch(patch)
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!(super::COMMANDS.shared_keys(), []);
        assert_eq!(super::COMMANDS.too_wide(), [""; 0]);
    }
}
