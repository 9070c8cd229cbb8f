//! What surrounds the field: title, panels, buttons.

use super::texts;
use crate::machine::{Key, Language, Manner};
use crate::screen::{Color, Direction, Screen, Stroke};
use crate::ui::{Area, raised, sunken, window};

/// The white field with the table.
pub(crate) const FIELD: Area = Area::new(24, 54, 506, 456);
/// Half the length of an arrow on a button.
const ARROW: i32 = 12;
/// The three panels of moves: upper edge, name, letters.
const PANELS: [(i32, &str, [char; 4]); 3] =
    [(90, "x", ['X', 'U', 'R', 'E']), (220, "y", ['Y', 'V', 'S', 'F']), (350, "z", ['Z', 'W', 'T', 'G'])];
/// Where the buttons of a panel are.
const OFFSETS: [(i32, i32); 4] = [(5, 25), (60, 25), (5, 75), (60, 75)];
/// The other buttons.
const BUTTONS: [(Key, Area); 7] = [
    (Key::Char('A'), Area::new(526, 40, 546, 70)),
    (Key::Char('B'), Area::new(605, 40, 625, 70)),
    (Key::Char('Q'), Area::new(450, 10, 510, 45)),
    (Key::Up, Area::new(2, 200, 16, 240)),
    (Key::Down, Area::new(2, 250, 16, 290)),
    (Key::Left, Area::new(220, 464, 260, 478)),
    (Key::Right, Area::new(270, 464, 310, 478)),
];

/// Every button of a move with its letter.
fn moves() -> impl Iterator<Item = (char, Area)> {
    PANELS.into_iter().flat_map(|(top, _, letters)| {
        letters.into_iter().zip(OFFSETS).map(move |(letter, (dx, dy))| {
            let (x, y) = (520 + dx, top + dy);
            (letter, Area::new(x, y, x + 45, y + 40))
        })
    })
}

/// The key of the button at a pixel.
pub(crate) fn key_at(x: i32, y: i32) -> Option<Key> {
    let moves = moves().map(|(letter, area)| (Key::Char(letter), area));
    moves.chain(BUTTONS).find(|(_, area)| area.holds(x, y)).map(|(key, _)| key)
}

/// Draws all but what is in the field; `hint` is the letter of a move to be shown.
pub(crate) fn draw(
    screen: &mut Screen,
    language: Language,
    manner: Manner,
    selected: Color,
    hint: Option<char>,
) {
    screen.clear(Color::LightCyan);
    title(screen, language);
    sunken(screen, Area::new(20, 50, 510, 460), 4);
    screen.bar(FIELD.x1, FIELD.y1, FIELD.x2, FIELD.y2, Color::White);
    screen.line(26, 456, 504, 456, Stroke::thin(Color::Cyan));
    screen.line(506, 56, 506, 454, Stroke::thin(Color::Cyan));
    selection(screen, language, selected);
    for (top, name, _) in PANELS {
        raised(screen, Area::new(520, top, 630, top + 120), 2);
        screen.text(570, top + 10, name, Color::Black);
    }
    for (letter, area) in moves() {
        if hint == Some(letter) {
            screen.bar(area.x1, area.y1, area.x2, area.y2, Color::Yellow);
        }
        raised(screen, area, 1);
        match manner {
            Manner::Original => {
                capital(screen, area.x1 + 16, area.y1 + 10, letter);
                sign(screen, letter, area);
            }
            // The letter beside its sign and in a colour that is read.
            Manner::Today => {
                let mut text = [0; 4];
                let text = letter.encode_utf8(&mut text);
                screen.title(area.x1 + 4, area.y1 + 10, text, Color::Blue, 2, Direction::Horizontal);
                let aside = if "XYZUVW".contains(letter) { 22 } else { 8 };
                sign(screen, letter, Area { x1: area.x1 + aside, ..area });
            }
        }
    }
    let thick = Stroke::thick(Color::LightRed);
    for (key, area) in BUTTONS {
        raised(screen, area, 1);
        let centre = ((area.x1 + area.x2) / 2, (area.y1 + area.y2) / 2);
        match key {
            Key::Up => arrow(screen, centre, (0, -1), thick),
            Key::Down => arrow(screen, centre, (0, 1), thick),
            Key::Left => arrow(screen, centre, (-1, 0), thick),
            Key::Right => arrow(screen, centre, (1, 0), thick),
            _ => {}
        }
    }
}

fn title(screen: &mut Screen, language: Language) {
    screen.title(10, 10, "CSANGO KOCKA", Color::Magenta, 4, Direction::Horizontal);
    screen.text(58, 10, "/       /", Color::Magenta);
    screen.ellipse_filled(330, 25, 65, 18, Color::LightGreen, Color::Black);
    screen.ellipse_filled(330, 25, 57, 13, Color::White, Color::Black);
    screen.text(280, 21, texts::LOGO.of(language), Color::LightRed);
    screen.text(462, 14, texts::LEAVE.of(language), Color::Black);
    capital(screen, 470, 18, 'Q');
    screen.circle(8, 471, 7, Stroke::thin(Color::Magenta));
    screen.text(5, 468, "C", Color::Magenta);
    screen.text(20, 468, "Füzi János", Color::Magenta);
}

fn selection(screen: &mut Screen, language: Language, selected: Color) {
    raised(screen, Area::new(520, 10, 630, 80), 2);
    screen.text(535, 20, texts::SELECTION.of(language), Color::Black);
    window(screen, Area::new(552, 40, 600, 70));
    screen.bar(555, 42, 597, 68, selected);
    let thin = Stroke::thin(Color::Black);
    capital(screen, 533, 47, 'A');
    arrow(screen, (530, 55), (0, 1), thin);
    capital(screen, 612, 47, 'B');
    arrow(screen, (609, 55), (0, -1), thin);
}

fn capital(screen: &mut Screen, x: i32, y: i32, letter: char) {
    let mut text = [0; 4];
    screen.title(x, y, letter.encode_utf8(&mut text), Color::Cyan, 2, Direction::Horizontal);
}

/// The symbol of a move: a straight arrow, or one with an arc around it.
fn sign(screen: &mut Screen, letter: char, area: Area) {
    let thin = Stroke::thin(Color::Black);
    let (x, y) = (area.x1, area.y1 + 20);
    match letter {
        'X' | 'Y' | 'Z' => return arrow(screen, (x + 10, y), (0, -1), thin),
        'U' | 'V' | 'W' => return arrow(screen, (x + 10, y), (0, 1), thin),
        _ => arrow(screen, (x + 22, y), (1, 0), thin),
    }
    let red = Stroke::thin(Color::LightRed);
    screen.ellipse(x + 22, y, 8, 16, 30, 330, red);
    // The head of the arc: below for the turns that go the positive way round.
    let down = if matches!(letter, 'R' | 'S' | 'T') { 1 } else { -1 };
    let tip = (x + 29, y + 8 * down);
    screen.line(tip.0, tip.1, tip.0, tip.1 + 5 * down, red);
    screen.line(tip.0, tip.1, tip.0 - 4, tip.1 + 3 * down, red);
}

/// An arrow in one of the four directions, by its middle.
fn arrow(screen: &mut Screen, (x, y): (i32, i32), (dx, dy): (i32, i32), stroke: Stroke) {
    let tip = (x + ARROW * dx, y + ARROW * dy);
    screen.line(x - ARROW * dx, y - ARROW * dy, tip.0, tip.1, stroke);
    for side in [-3, 3] {
        screen.line(tip.0, tip.1, tip.0 - 7 * dx + side * dy, tip.1 - 7 * dy + side * dx, stroke);
    }
}
