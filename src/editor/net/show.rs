//! Viewer of a surface: turned, zoomed, in wires or filled.

use super::picture::of_grid;
use super::surface::{Display, Fill, draw_grid};
use crate::editor::keys;
use crate::figure::Figure;
use crate::geometry::{Grid, Point};
use crate::machine::{Asked, Key, Language, Machine};
use crate::screen::{Color, Screen};
use crate::ui::axes::draw_legend;
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::words;
use crate::ui::{Command, Commands, Desk, END, KeyHelp, Manual, Picture, Words};
use serde::Serialize;

/// A surface to show.
#[derive(Clone, Debug)]
pub struct Show {
    /// The manual of the program.
    pub manual: Manual,
    /// The initial direction of view.
    pub view: Point<3>,
    /// The surface.
    pub grid: Grid,
}

/// What a key does: `None` ends.
type Action = Option<Display>;

pub(super) const COMMANDS: Commands<Action> = Commands(&[
    Command::key(Key::Char('D'), (Words("D T", "D T"), words::HELP_SURFACE), Some(Display::Wire)),
    Command::also(Key::Char('T'), Some(Display::Filled)),
    Command::told(keys::TURN_KEYS),
    Command::told(keys::TURN_DRAG),
    Command::told(keys::ZOOM),
    Command::told(keys::HOME),
    Command::key(Key::Esc, END, None),
]);

/// The help page of [`show`].
pub const SHOW_KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

struct Shown {
    grid: Grid,
    viewer: Viewer,
    display: Display,
}

#[derive(Serialize)]
struct Dump {
    filled: bool,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
}

impl Picture for Shown {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::Black);
        draw_grid(screen, &self.grid, self.viewer.look, (self.display, Fill::Plain), Color::White);
        draw_legend(screen, words::ESC_ENDS, language);
        self.display.draw_legend(screen, language);
    }

    fn figure(&self) -> Option<Figure> {
        of_grid(&self.grid, self.viewer.look.view, self.display)
    }
}

/// Shows a surface until Esc.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub async fn show(machine: &mut Machine, show: Show) -> Asked<()> {
    let viewer = Viewer::new(Look::new(show.view, Poles::Cross));
    let mut shown = Shown { grid: show.grid, viewer, display: Display::Wire };
    let mut desk = Desk::new(machine, show.manual);
    loop {
        let view = shown.viewer.look.view;
        desk.machine.publish(Dump {
            filled: shown.display == Display::Filled,
            azimuth: view.azimuth().to_degrees(),
            elevation: view.elevation().to_degrees(),
            zoom: shown.viewer.look.scale(),
        });
        let tick = desk.event(&shown).await?;
        if shown.viewer.look_around(&tick) {
            continue;
        }
        match COMMANDS.find(&tick) {
            Some(Some(display)) => shown.display = display,
            Some(None) => return Ok(()),
            None => {}
        }
    }
}
