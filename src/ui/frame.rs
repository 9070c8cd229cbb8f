//! Drawing of raised and sunken frames, the communication page, black windows and visual buttons (units KOZOS and
//! GOMB_KEZ of the book).

use super::words::{Hot, Words};
use crate::machine::{Key, Language};
use crate::screen::{Color, Screen, Stroke};

/// A rectangle by its first and last pixel in each direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// Left edge.
    pub x1: i32,
    /// Upper edge.
    pub y1: i32,
    /// Right edge.
    pub x2: i32,
    /// Lower edge.
    pub y2: i32,
}

impl Area {
    /// The area between two corners.
    pub const fn new(x1: i32, y1: i32, x2: i32, y2: i32) -> Area {
        Area { x1, y1, x2, y2 }
    }

    /// The area around a line of so many letters.
    pub const fn of_line((x, y): (i32, i32), letters: i32) -> Area {
        Area::new(x - 3, y - 4, x + 8 * letters + 2, y + 11)
    }

    /// Whether a pixel lies strictly inside, the original's test of clicks.
    pub fn holds(self, x: i32, y: i32) -> bool {
        self.x1 < x && x < self.x2 && self.y1 < y && y < self.y2
    }
}

/// Whether the area of a frame looks raised or sunken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relief {
    Raised,
    Sunken,
}

/// A frame of four black-edged bars, lit from the upper left. A raised one lies outside the area, a sunken one inside
/// it.
fn frame(screen: &mut Screen, area: Area, width: i32, relief: Relief) {
    let Area { x1, y1, x2, y2 } = area;
    let (out, upper_left, lower_right) = match relief {
        Relief::Raised => (width, Color::White, Color::Cyan),
        Relief::Sunken => (-width, Color::Cyan, Color::White),
    };
    let right = [(x2, y1), (x2 + out, y1 - out), (x2 + out, y2 + out), (x2, y2)];
    let left = [(x1, y1), (x1 - out, y1 - out), (x1 - out, y2 + out), (x1, y2)];
    let top = [(x1, y1), (x2, y1), (x2 + out, y1 - out), (x1 - out, y1 - out)];
    let bottom = [(x1, y2), (x2, y2), (x2 + out, y2 + out), (x1 - out, y2 + out)];
    for (bar, color) in [(right, lower_right), (left, upper_left), (top, upper_left), (bottom, lower_right)] {
        screen.polygon(&bar, color, Stroke::thin(Color::Black));
    }
}

/// A frame around an area, which makes it look raised.
pub fn raised(screen: &mut Screen, area: Area, width: i32) {
    frame(screen, area, width, Relief::Raised);
}

/// A frame inside an area, which makes it look sunken.
pub fn sunken(screen: &mut Screen, area: Area, width: i32) {
    frame(screen, area, width, Relief::Sunken);
}

/// A raised panel for messages and questions.
pub fn panel(screen: &mut Screen, x: i32, y: i32, width: i32, height: i32) {
    screen.bar(x, y, x + width, y + height, Color::LightCyan);
    raised(screen, Area::new(x, y, x + width, y + height + 1), 3);
}

/// The communication page: the panel of 240x40 pixels with its upper left corner at a place.
pub fn page(screen: &mut Screen, (x, y): (i32, i32)) {
    panel(screen, x, y, 240, 40);
}

/// A black window to write in.
pub fn window(screen: &mut Screen, area: Area) {
    screen.bar(area.x1, area.y1, area.x2, area.y2, Color::Black);
    sunken(screen, Area { y2: area.y2 + 1, ..area }, 2);
}

/// A visual button of 70x12 pixels with its hot letter in red.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Button {
    /// Left edge.
    pub x: i32,
    /// Upper edge.
    pub y: i32,
    /// The text; its hot letter is a key.
    pub text: Hot,
}

impl Button {
    /// A button of a text at a place.
    pub const fn new(x: i32, y: i32, text: Hot) -> Button {
        Button { x, y, text }
    }

    /// Whether a click at a pixel is on the button.
    pub fn hit(&self, x: i32, y: i32) -> bool {
        self.area().holds(x, y)
    }

    fn area(&self) -> Area {
        Area::new(self.x, self.y, self.x + 70, self.y + 12)
    }

    /// Whether the text lies inside the button in a language.
    pub fn fits(&self, language: Language) -> bool {
        self.x + 4 + self.text.width(language) < self.area().x2
    }

    /// Draws the button. The original's pressed button has the same pixels, since a frame of one pixel shows only its
    /// black edge.
    pub fn draw(&self, screen: &mut Screen, language: Language) {
        raised(screen, Area::new(self.x, self.y, self.x + 70, self.y + 12), 1);
        hot_text(screen, self.x + 4, self.y + 2, self.text, Color::Black, language);
    }
}

/// A visual button that shows its key in red before its text, for keys that begin no word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pad {
    /// Where it is.
    pub area: Area,
    /// What the key does.
    pub text: Words,
}

impl Pad {
    /// A button of a text with its upper left corner at a place, for 13 letters together with the key.
    pub const fn new(x: i32, y: i32, text: Words) -> Pad {
        Pad { area: Area::new(x, y, x + 107, y + 13), text }
    }

    /// Draws the button with its key.
    pub fn draw(&self, screen: &mut Screen, key: Key, language: Language) {
        let Area { x1, y1, x2, y2 } = self.area;
        screen.bar(x1, y1, x2, y2, Color::LightCyan);
        raised(screen, self.area, 1);
        let key = key.to_string();
        let width = 8 * i32::try_from(key.chars().count()).unwrap_or(0);
        screen.text(x1 + 2, y1 + 3, &key, Color::Red);
        screen.text(x1 + 2 + width + 4, y1 + 3, self.text.of(language), Color::Black);
    }
}

/// A hot letter in red and the rest of its word.
pub(super) fn hot_text(screen: &mut Screen, x: i32, y: i32, text: Hot, rest: Color, language: Language) {
    let mut letter = [0; 4];
    screen.text(x, y, text.letter.encode_utf8(&mut letter), Color::LightRed);
    screen.text(x + 8, y, text.rest.of(language), rest);
}
