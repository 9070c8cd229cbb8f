//! Viewer of a surface by its equation: turned, zoomed, in wires or filled, with other constants, and as a painter
//! paints it.

use super::picture::of_grid;
use super::surface::{Display, Fill, draw_grid, draw_in_order};
use crate::editor::keys;
use crate::figure::Figure;
use crate::geometry::painter::{Backs, Painting};
use crate::geometry::{BoundingBox, Grid, ParamSurface, Point};
use crate::machine::{Asked, Key, Language, Machine, Tick};
use crate::screen::{Color, HEIGHT, Screen, WIDTH};
use crate::ui::axes::draw_legend;
use crate::ui::look::{Look, Poles, SIGHT_KEY, Sight, Viewer};
use crate::ui::painter::{PAINTER_HELP, PAINTER_KEY, Steps, StepsModel};
use crate::ui::words;
use crate::ui::{Command, Commands, Desk, END, KeyHelp, Manual, Picture, Stay, Words};
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// A surface to show.
#[derive(Clone, Debug)]
pub struct Show {
    /// The manual of the program.
    pub manual: Manual,
    /// The initial direction of view.
    pub view: Point<3>,
    /// The constants of its equation, at most six.
    pub constants: &'static [Constant],
    /// The points that it is drawn from, by the values of the constants.
    pub grid: fn(&[i32]) -> Grid,
    /// The surface itself, for models.
    pub surface: fn(&[i32]) -> Box<dyn ParamSurface>,
}

/// A constant of the equation of a surface, or of how finely it is drawn.
#[derive(Clone, Debug)]
pub struct Constant {
    /// Its name in the equation.
    pub name: &'static str,
    /// The values of the sets that a key goes through; the first is that of the start.
    pub sets: [i32; 2],
    /// Its least and its largest value.
    pub range: RangeInclusive<i32>,
    /// What one step changes.
    pub step: i32,
}

/// What a key does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Display(Display),
    /// The constant of a number from 0.
    Choose(usize),
    Change(i32),
    /// The next set of constants.
    Set,
    /// The constants of the start.
    Reset,
    Sight,
    Paint,
    End,
}

pub(super) const COMMANDS: Commands<Action> = Commands(&[
    Command::key(Key::Char('D'), (Words("D T", "D T"), words::HELP_SURFACE), Action::Display(Display::Wire)),
    Command::also(Key::Char('T'), Action::Display(Display::Filled)),
    Command::key(Key::Char('1'), (Words("1 ... 6", "1 ... 6"), CHOOSE), Action::Choose(0)),
    Command::also(Key::Char('2'), Action::Choose(1)),
    Command::also(Key::Char('3'), Action::Choose(2)),
    Command::also(Key::Char('4'), Action::Choose(3)),
    Command::also(Key::Char('5'), Action::Choose(4)),
    Command::also(Key::Char('6'), Action::Choose(5)),
    Command::key(Key::Char('+'), (Words("+ -", "+ -"), CHANGE), Action::Change(1)),
    Command::also(Key::Char('-'), Action::Change(-1)),
    Command::key(Key::Char('N'), (Words("N", "N"), SET), Action::Set),
    Command::key(Key::Char('0'), (Words("0", "0"), RESET), Action::Reset),
    Command::told(keys::TURN_KEYS),
    Command::told(keys::TURN_DRAG),
    Command::told(keys::ZOOM),
    Command::told(keys::HOME),
    Command::key(SIGHT_KEY, keys::SIGHT, Action::Sight),
    Command::key(PAINTER_KEY, PAINTER_HELP, Action::Paint),
    Command::key(Key::Esc, END, Action::End),
]);

const CHOOSE: Words = Words("az egyenlet egy állandója", "a constant of the equation");
const CHANGE: Words = Words("a választott állandó több, kevesebb", "the chosen constant, more, less");
const SET: Words = Words("a könyv másik, finomabb felbontása", "the book's other, finer division");
const RESET: Words = Words("az eredeti állandók", "the constants of the start");

/// The help page of [`show`].
pub const SHOW_KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

/// Where the constants stand.
const CONSTANTS: (i32, i32) = (15, 130);
/// Where a painter's steps are told.
const STEPS: (i32, i32) = (15, 424);

struct Shown {
    show: Show,
    values: Vec<i32>,
    grid: Grid,
    /// The constant that is changed, once one has been chosen.
    chosen: Option<usize>,
    set: usize,
    viewer: Viewer,
    display: Display,
    /// The painter's steps, if they are shown.
    steps: Option<Steps>,
}

#[derive(Serialize)]
struct Dump {
    filled: bool,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    projection: Sight,
    constants: BTreeMap<&'static str, i32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    painter: Option<StepsModel>,
}

impl Picture for Shown {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::Black);
        let look = self.viewer.look;
        if let Some(steps) = &self.steps {
            match steps.painted() {
                Some(painted) => {
                    draw_in_order(screen, &self.grid, look, painted);
                    for &[x, y] in steps.wrong() {
                        screen.bar(x, y, x, y, Color::LightRed);
                    }
                }
                None => draw_grid(screen, &self.grid, look, (Display::Filled, Fill::Plain), Color::White),
            }
            steps.draw(screen, STEPS, [Color::LightCyan, Color::Black], language);
            return;
        }
        draw_grid(screen, &self.grid, look, (self.display, Fill::Plain), Color::White);
        draw_legend(screen, words::ESC_ENDS, language);
        self.display.draw_legend(screen, language);
        if self.chosen.is_none() {
            return;
        }
        let (x, y) = CONSTANTS;
        for (number, (constant, value)) in self.show.constants.iter().zip(&self.values).enumerate() {
            let ink = if self.chosen == Some(number) { Color::Yellow } else { Color::LightGray };
            let row = y + 12 * i32::try_from(number).unwrap_or(0);
            screen.text(x, row, &format!("{} {:>2} = {value}", number + 1, constant.name), ink);
        }
    }

    fn figure(&self) -> Option<Figure> {
        match self.steps {
            // A figure has no order.
            Some(_) => None,
            None => of_grid(&self.grid, self.viewer.look.seen(), self.display),
        }
    }

    fn surfaces(&self) -> Vec<Box<dyn ParamSurface>> {
        vec![(self.show.surface)(&self.values)]
    }
}

impl Shown {
    fn new(show: Show) -> Shown {
        let values = of_set(&show, 0);
        Shown {
            grid: (show.grid)(&values),
            values,
            chosen: None,
            set: 0,
            viewer: Viewer::new(Look::new(show.view, Poles::Cross)),
            display: Display::Wire,
            steps: None,
            show,
        }
    }

    fn dump(&self) -> Dump {
        let [azimuth, elevation, zoom] = self.viewer.look.angles();
        let names = self.show.constants.iter().map(|constant| constant.name);
        Dump {
            filled: self.display == Display::Filled,
            azimuth,
            elevation,
            zoom,
            projection: self.viewer.look.sight(),
            constants: names.zip(self.values.iter().copied()).collect(),
            painter: self.steps.as_ref().map(Steps::model),
        }
    }

    /// Looks from another distance, which the size of the body limits.
    fn see_from(&mut self, sight: Sight) {
        let bounds = BoundingBox::of_points(self.grid.points());
        self.viewer.look = self.viewer.look.seen_from(sight, bounds);
    }

    fn take(&mut self, values: Vec<i32>) {
        self.grid = (self.show.grid)(&values);
        self.values = values;
        self.see_from(self.viewer.look.sight());
    }

    /// Changes the chosen constant by steps, within its range.
    fn change(&mut self, steps: i32) {
        let chosen = *self.chosen.get_or_insert(0);
        let Some(constant) = self.show.constants.get(chosen) else { return };
        let mut values = self.values.clone();
        if let Some(value) = values.get_mut(chosen) {
            let changed = value.saturating_add(steps.saturating_mul(constant.step));
            *value = changed.clamp(*constant.range.start(), *constant.range.end());
        }
        self.take(values);
    }

    /// The painter's order of the cells, seen from here.
    fn painting(&self) -> Painting {
        let look = self.viewer.look;
        let place = |corner: usize| {
            let point = self.grid.points().get(corner).copied().unwrap_or([0.0; 3]);
            let (x, y) = look.to_screen(point);
            [f64::from(x), f64::from(y), look.seen().depth(point) * look.scale()]
        };
        let cells: Vec<Vec<Point<3>>> = self.grid.cells().map(|cell| cell.map(place).to_vec()).collect();
        // Neither is negative.
        Painting::new(&cells, Backs::Painted, [WIDTH as usize, HEIGHT as usize])
    }

    /// Carries out an event; returns `false` at the end.
    fn obey(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        if let Some(steps) = &mut self.steps {
            if !steps.heed(tick) {
                self.steps = None;
            }
            return true;
        }
        if self.viewer.look_around(tick) {
            return true;
        }
        match COMMANDS.find(tick) {
            Some(Action::End) => return false,
            Some(Action::Display(display)) => self.display = display,
            Some(Action::Choose(number)) => {
                self.chosen =
                    Some(number).filter(|&number| number < self.show.constants.len()).or(self.chosen);
            }
            Some(Action::Change(steps)) => self.change(steps),
            Some(Action::Set) => {
                self.set = (self.set + 1) % 2;
                // What both sets have in common stays as it is.
                let [first, second] = [0, 1].map(|set| of_set(&self.show, set));
                let both = self.values.iter().zip(first.iter().zip(&second));
                let values = both.map(|(&value, (a, b))| match (a == b, self.set) {
                    (true, _) => value,
                    (false, 0) => *a,
                    (false, _) => *b,
                });
                self.chosen = self.chosen.or(Some(0));
                self.take(values.collect());
            }
            Some(Action::Reset) => {
                (self.set, self.chosen) = (0, None);
                self.take(of_set(&self.show, 0));
            }
            Some(Action::Sight) => {
                let sight = self.viewer.look.sight().next();
                self.see_from(sight);
                desk.tell(sight.told(), Stay::Briefly);
            }
            Some(Action::Paint) => self.steps = Some(Steps::new(self.painting())),
            None => {}
        }
        true
    }
}

/// The values of a set of constants.
fn of_set(show: &Show, set: usize) -> Vec<i32> {
    show.constants
        .iter()
        .map(|constant| constant.sets.get(set).copied().unwrap_or(constant.sets[0]))
        .collect()
}

/// Shows a surface until Esc.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub async fn show(machine: &mut Machine, show: Show) -> Asked<()> {
    let manual = show.manual;
    let mut shown = Shown::new(show);
    let mut desk = Desk::new(machine, manual);
    loop {
        desk.machine.publish(shown.dump());
        let tick = desk.event(&shown).await?;
        if !shown.obey(&mut desk, &tick) {
            return Ok(());
        }
    }
}
