//! The picture of VJS: track, stick, axes and the seven displays.

use super::motion::Readings;
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Area, Hint, Picture, Words, window};

/// The track, inside of its frame.
const TRACK_AREA: Area = Area::new(50, 20, 470, 440);
/// The middle of the track.
const TRACK: (i32, i32) = (260, 230);
/// The stick's square, inside of its frame.
const STICK_AREA: Area = Area::new(529, 369, 629, 469);
/// The middle of the stick's square.
pub(crate) const STICK: (i32, i32) = (579, 419);
/// Radius of the handle and of the point, in pixels.
pub(crate) const HANDLE_RADIUS: i32 = 10;
/// Length of the ticks of the axes, in pixels.
const TICK: i32 = 10;

const HINT: Words = Words(
    "Húzza a piros fogantyút. Szóköz: elölről, F1 súgó, Esc vége",
    "Drag the red stick. Space: start again, F1 help, Esc end",
);
const KEYS: Words = Words(
    "Nyilak: a fogantyú. Szóköz: elölről, F1 súgó, Esc vége",
    "Arrows tilt the stick. Space: start again, F1 help, Esc end",
);
const HINT_HELD: Words = Words(
    "Elengedve visszaugrik, a pont továbbgurul. Esc: elengedi",
    "Let go: it springs back, and the point rolls on. Esc: let go",
);
const TIME: Words = Words("Idő:", "Time:");
const SECONDS: Words = Words("s", "s");
/// The three pairs of displays: heading, the letters over the windows, their unit, and how far below the
/// heading these and the windows stand.
const ROWS: [(i32, Words, &str, Words); 3] = [
    (45, Words("Hely:", "Place:"), "", Words("pixel", "pixel")),
    (135, Words("Sebesség:", "Velocity:"), "v        v", Words("pixel / s", "pixel / s")),
    (225, Words("Gyorsulás:", "Acceleration:"), "a        a", Words("pixel / s²", "pixel / s²")),
];

/// The picture: a fixed background, drawn once for each language, and the moving parts.
pub(crate) struct Panel {
    grounds: [(Language, Screen); 2],
    point: [f64; 2],
    handle: (i32, i32),
    readings: Readings,
    held: bool,
}

impl Panel {
    /// The picture at the start.
    pub(crate) fn new() -> Panel {
        let grounds = [Language::Hungarian, Language::English].map(|language| (language, ground(language)));
        Panel { grounds, point: [0.0; 2], handle: (0, 0), readings: Readings::default(), held: false }
    }

    /// Sets what is shown: the point's place, the handle's offset, whether the mouse holds it, and the numbers.
    pub(crate) fn show(&mut self, point: [f64; 2], (handle, held): ((i32, i32), bool), readings: Readings) {
        (self.point, self.handle, self.held, self.readings) = (point, handle, held, readings);
    }
}

impl Picture for Panel {
    fn draw(&self, screen: &mut Screen, language: Language) {
        if let Some((_, ground)) = self.grounds.iter().find(|(spoken, _)| *spoken == language) {
            screen.clone_from(ground);
        }
        let [x, y] = self.point.map(|place| place.round() as i32);
        screen.disc(TRACK.0 + x, TRACK.1 - y, HANDLE_RADIUS, Color::LightGreen, Color::Black);
        let (x, y) = self.handle;
        screen.disc(STICK.0 + x, STICK.1 - y, HANDLE_RADIUS, Color::LightRed, Color::Black);
        screen.text(562, 12, &format!("{:7}", self.readings.seconds), Color::White);
        for ((top, ..), numbers) in ROWS.into_iter().zip(self.readings.rows) {
            for (x, number) in [504, 574].into_iter().zip(numbers) {
                // Adding zero makes a negative zero positive.
                screen.text(
                    x,
                    top_of_window(top) + 7,
                    &format!("{:5.0}", number.round() + 0.0),
                    Color::White,
                );
            }
        }
    }

    /// Under the track.
    fn hint(&self) -> Option<Hint> {
        let [mouse, keys] = if self.held { [HINT_HELD; 2] } else { [HINT, KEYS] };
        Some(Hint::at((5, 469), 60, mouse).by_keys(keys))
    }
}

/// Where the windows of a pair of displays begin.
fn top_of_window(heading: i32) -> i32 {
    heading + 35
}

/// What never changes.
fn ground(language: Language) -> Screen {
    let mut screen = Screen::new();
    screen.clear(Color::LightCyan);
    for Area { x1, y1, x2, y2 } in [TRACK_AREA, STICK_AREA] {
        window(&mut screen, Area::new(x1 - 2, y1 - 2, x2 + 2, y2 + 2));
    }
    for k in -4..=4 {
        grid(&mut screen, STICK_AREA, STICK, 10 * k);
        grid(&mut screen, TRACK_AREA, TRACK, 50 * k);
    }
    for k in -4..=4 {
        axes(&mut screen, k);
    }
    displays(&mut screen, language);
    screen
}

/// The two lines of a square's grid at a distance from its middle.
fn grid(screen: &mut Screen, area: Area, (x, y): (i32, i32), distance: i32) {
    let gray = Stroke::thin(Color::LightGray);
    screen.line(area.x1, y + distance, area.x2, y + distance, gray);
    screen.line(x + distance, area.y1, x + distance, area.y2, gray);
}

/// Ticks and labels of all axes, `k` lines from the middle. Vertical axes count upwards.
fn axes(screen: &mut Screen, k: i32) {
    let black = Stroke::thin(Color::Black);
    let (x, y) = (STICK.0 + 10 * k, STICK.1 - 10 * k);
    screen.line(STICK_AREA.x1 - TICK, y, STICK_AREA.x1, y, black);
    screen.line(x, STICK_AREA.y1 - TICK, x, STICK_AREA.y1, black);
    let label = format!("{:3}", 10 * k);
    if k % 2 == 0 {
        screen.text(STICK_AREA.x1 - 35, y - 3, &label, Color::Black);
    }
    if k % 4 == 0 {
        screen.text(STICK.0 + 11 * k - 18, STICK_AREA.y1 - 20, &label, Color::Black);
    }
    let (x, y) = (TRACK.0 + 50 * k, TRACK.1 - 50 * k);
    screen.line(TRACK_AREA.x1 - TICK, y, TRACK_AREA.x1, y, black);
    screen.line(x, TRACK_AREA.y2, x, TRACK_AREA.y2 + TICK, black);
    let label = format!("{:4}", 50 * k);
    screen.text(TRACK_AREA.x1 - 50, y - 3, &label, Color::Black);
    screen.text(x - 20, TRACK_AREA.y2 + 15, &label, Color::Black);
}

/// Windows, headings and units of the seven displays.
fn displays(screen: &mut Screen, language: Language) {
    let ink = Color::Black;
    screen.text(500, 12, TIME.of(language), ink);
    screen.text(625, 12, SECONDS.of(language), ink);
    window(screen, Area::new(560, 5, 620, 25));
    for (top, heading, letters, unit) in ROWS {
        let windows = top_of_window(top);
        screen.text(500, top, heading.of(language), ink);
        screen.text(500, top + 15, letters, ink);
        screen.text(507, top + 20, "x        y", ink);
        window(screen, Area::new(500, windows, 550, windows + 20));
        window(screen, Area::new(570, windows, 620, windows + 20));
        screen.text(520, top + 65, unit.of(language), ink);
    }
}
