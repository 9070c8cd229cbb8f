//! The board on the screen: arms with their drawers, rings, beads, and the wheel of the controls.

use super::super::puzzles::Party;
use super::game::Game;
use super::player::{COMMANDS, TODAY};
use super::texts;
use crate::machine::{Language, Manner};
use crate::puzzle::wheel::{ARMS, Move, Progress, RINGS, Wheel};
use crate::screen::{Color, Direction, Screen, Stroke};
use crate::ui::{Area, MIDDLE, page, sunken};
use std::time::Duration;

/// Centre of the wheel.
pub(crate) const CENTRE: (i32, i32) = (240, 260);
/// Radius of a bead, and the distance of two.
const BEAD: i32 = 14;
pub(crate) const STEP: f64 = 32.0;
/// Half the width of a drawer.
pub(crate) const HALF: f64 = 16.0;
/// Where the drawers begin, and by how much a bead moves them for each step of their displacement.
const INNER: f64 = 27.0;
/// Centre of the controls' wheel, and half the distance of its rings.
const CONTROLS: (i32, i32) = (510, 360);
const RIM: i32 = 13;
/// The offset of a letter from the head of its drawer's arrow.
const LETTERS: [(i32, i32); ARMS] = [(-15, -28), (-26, -20), (-23, 3), (-1, 8), (16, 0), (12, -23)];
/// Where the texts beside the board begin, and their lines.
const SIDE: i32 = 404;
const LINES: [i32; 5] = [76, 92, 108, 124, 140];
/// The lines in the manner of today, above the hint and the buttons.
const LINES_TODAY: [i32; 5] = [70, 82, 94, 106, 118];
/// The small picture of the goal: its centre, and the distance of its beads.
const GOAL: (i32, i32) = (60, 112);
const GOAL_STEP: f64 = 8.0;

/// What is to be seen.
pub(crate) struct View<'a> {
    /// Whether the buttons are shown, which is after the first question.
    pub(crate) buttons: bool,
    /// The board; none while it is asked for.
    pub(crate) board: Option<Board<'a>>,
    pub(crate) style: Style,
}

/// How everything is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub(crate) manner: Manner,
    /// Whether the beads bear the letters of their home arms, for eyes that do not tell the colours apart.
    pub(crate) signs: bool,
}

/// What is moved by the mouse, beyond the moves that are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Slide {
    None,
    /// A ring, counter-clockwise in degrees.
    Ring(usize, f64),
    /// The diameter of an arm, inwards on that arm in pixels.
    Diameter(usize, f64),
}

impl Slide {
    /// Pixels outwards of what lies on an arm.
    fn out(self, arm: usize) -> f64 {
        match self {
            Slide::Diameter(held, inwards) if held == arm => -inwards,
            Slide::Diameter(held, inwards) if (held + ARMS / 2) % ARMS == arm % ARMS => inwards,
            _ => 0.0,
        }
    }

    fn turn(self, ring: usize) -> f64 {
        match self {
            Slide::Ring(held, degrees) if held == ring => degrees,
            _ => 0.0,
        }
    }
}

/// The board with what stands beside it.
pub(crate) struct Board<'a> {
    pub(crate) wheel: Wheel,
    pub(crate) game: &'a Game,
    pub(crate) time: Duration,
    pub(crate) hint: Option<Move>,
    pub(crate) going_on: GoingOn,
    pub(crate) slide: Slide,
    /// More lines beside the board.
    pub(crate) told: Vec<String>,
    pub(crate) party: Option<(Party, Duration)>,
}

/// What goes on by itself.
pub(crate) enum GoingOn {
    Nothing,
    Search(Progress),
    Solution { count: usize, proven: bool },
    Demonstration,
}

impl View<'_> {
    pub(crate) fn draw(&self, screen: &mut Screen, language: Language) {
        draw_desk(screen, self.style.manner, language);
        if self.buttons {
            COMMANDS.draw(screen, language);
            if self.style.manner == Manner::Today {
                TODAY.draw(screen, language);
            }
        }
        if let Some(board) = &self.board {
            draw_rings(screen);
            (1..=ARMS).for_each(|arm| draw_drawer(screen, &board.wheel, arm, board.slide));
            draw_beads(screen, &board.wheel, board.slide, self.style.signs);
            draw_controls(screen);
            if self.style.manner == Manner::Today {
                draw_goal(screen, language);
            }
            board.draw_side(screen, self.style.manner, language);
            if let Some((party, now)) = board.party {
                party.draw(screen, CENTRE, now);
            }
        }
    }
}

impl Board<'_> {
    fn draw_side(&self, screen: &mut Screen, manner: Manner, language: Language) {
        let mut lines = vec![texts::score(self.game.moves, self.time, language)];
        lines.extend(self.game.problem.map(|problem| texts::problem(problem, language)));
        lines.extend(self.told.iter().cloned());
        if self.told.is_empty() && self.game.moves > 0 && self.game.wheel.is_solved() {
            lines.push(texts::SOLVED.of(language).to_string());
        }
        lines.extend(self.hint.map(|hint| texts::hint(hint, language)));
        match &self.going_on {
            GoingOn::Nothing | GoingOn::Search(_) => {}
            &GoingOn::Solution { count, proven } => {
                lines.extend(texts::solution(count, proven, language));
                lines.push(texts::TAKE_OVER.of(language).to_string());
            }
            GoingOn::Demonstration => {
                lines = [texts::SHOWN, texts::ESC_BACK].map(|it| it.of(language).to_string()).to_vec();
            }
        }
        let rows = match manner {
            Manner::Original => LINES,
            Manner::Today => LINES_TODAY,
        };
        for (line, y) in lines.iter().zip(rows) {
            screen.text(SIDE, y, line, Color::Blue);
        }
        screen.text(136, 468, &self.wheel.to_string(), Color::Blue);
        if let Some(hint) = self.hint {
            let (x, y) = handle(&self.wheel, hint);
            screen.circle(x, y, 17, Stroke::thick(Color::Green));
        }
        if let GoingOn::Search(progress) = &self.going_on {
            let (x, y) = MIDDLE;
            page(screen, MIDDLE);
            screen.text(x + 8, y + 8, texts::SEARCH.of(language), Color::Black);
            screen.text(x + 8, y + 24, &texts::progress(progress, language), Color::Black);
        }
    }
}

/// Everything that is always there.
fn draw_desk(screen: &mut Screen, manner: Manner, language: Language) {
    screen.clear(Color::LightCyan);
    sunken(screen, Area::new(10, 60, 629, 460), 4);
    screen.bar(14, 64, 625, 456, Color::White);
    screen.line(16, 456, 623, 456, Stroke::thin(Color::Cyan));
    screen.line(625, 66, 625, 454, Stroke::thin(Color::Cyan));
    screen.ellipse_filled(560, 30, 65, 20, Color::LightGreen, Color::Black);
    screen.ellipse_filled(560, 30, 57, 15, Color::White, Color::Black);
    let logo = match manner {
        Manner::Original => texts::LOGO.0,
        Manner::Today => texts::LOGO.of(language),
    };
    screen.text(510, 26, logo, Color::LightRed);
    screen.title(10, 10, "GYÖNGYKERÉK", Color::Magenta, 4, Direction::Horizontal);
    screen.text(5, 468, "C Füzi János", Color::Magenta);
    screen.circle(8, 471, 7, Stroke::thin(Color::Magenta));
}

fn draw_rings(screen: &mut Screen) {
    for radius in [48, 80, 112] {
        screen.circle(CENTRE.0, CENTRE.1, radius, Stroke::thin(Color::Black));
    }
}

/// The pixel at a distance along an arm and to its right, seen from the centre.
fn on_arm(arm: usize, along: f64, aside: f64) -> (i32, i32) {
    towards(60.0 * arm as f64, along, aside)
}

/// How far a pixel is along an arm and to its left.
pub(crate) fn on_arm_of(arm: usize, (x, y): (i32, i32)) -> (f64, f64) {
    let (sin, cos) = (60.0 * arm as f64).to_radians().sin_cos();
    let (right, up) = (f64::from(x - CENTRE.0), f64::from(CENTRE.1 - y));
    (right * cos + up * sin, up * cos - right * sin)
}

/// The pixel so far in a direction and so far to its right, seen from the centre.
fn towards(degrees: f64, along: f64, aside: f64) -> (i32, i32) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let place = |centre: i32, offset: f64| centre + offset.round() as i32;
    (place(CENTRE.0, along * cos + aside * sin), place(CENTRE.1, aside * cos - along * sin))
}

fn draw_drawer(screen: &mut Screen, wheel: &Wheel, arm: usize, slide: Slide) {
    let out = HALF * f64::from(wheel.drawer(arm)) + slide.out(arm);
    let (middle, end) = (4.0 * STEP + out + 4.0, 5.0 * STEP + out + 4.0);
    let mut line = |from: (f64, f64), to: (f64, f64), stroke: Stroke| {
        let [(x1, y1), (x2, y2)] = [from, to].map(|(along, aside)| on_arm(arm, along, aside));
        screen.line(x1, y1, x2, y2, stroke);
    };
    let black = Stroke::thin(Color::Black);
    for side in [-HALF, HALF] {
        line((INNER, side), (end, side), black);
    }
    line((middle, -HALF), (middle, HALF), black);
    line((end, -HALF), (end, HALF), black);
    let gray = Stroke::thick(Color::LightGray);
    line((end - 2.0, 8.0), (middle + 2.0, 8.0), gray);
    for side in [5.0, 11.0] {
        line((middle + 7.0, side), (middle + 2.0, 8.0), gray);
    }
    let (x, y) = on_arm(arm, middle + 2.0, 8.0);
    let (dx, dy) = LETTERS.get(arm - 1).copied().unwrap_or_default(); // arms are 1 to 6
    letter(screen, x + dx, y + dy, Move::ALL[(arm - 1) % ARMS]);
}

fn letter(screen: &mut Screen, x: i32, y: i32, a_move: Move) {
    let mut text = [0; 4];
    let text = a_move.letter().encode_utf8(&mut text);
    screen.title(x, y, text, Color::LightRed, 1, Direction::Horizontal);
}

fn draw_beads(screen: &mut Screen, wheel: &Wheel, slide: Slide, signs: bool) {
    let mut bead = |(x, y): (i32, i32), colour: u8| {
        let color = if colour == 0 { Color::LightGray } else { Color::from_index(8 + colour) };
        screen.disc(x, y, BEAD, color, Color::Black);
        if let Some(sign) = (1..=ARMS).contains(&usize::from(colour)).then_some(colour).filter(|_| signs) {
            let sign = char::from(b'A' + sign - 1); // at most six
            screen.text(x - 4, y - 3, sign.encode_utf8(&mut [0; 4]), Color::Black);
        }
    };
    for arm in 1..=ARMS {
        for ring in 1..=RINGS {
            if let Some(colour) = wheel.bead(ring, arm) {
                let degrees = 60.0 * arm as f64 + slide.turn(ring);
                bead(towards(degrees, STEP * ring as f64 + slide.out(arm), 0.0), colour);
            }
        }
    }
    // The bead of the centre goes with the diameter that is held.
    let centre = match slide {
        Slide::Diameter(arm, inwards) => on_arm(arm, -inwards, 0.0),
        _ => CENTRE,
    };
    bead(centre, wheel.centre());
}

/// The solved wheel, small.
fn draw_goal(screen: &mut Screen, language: Language) {
    let (x, y) = GOAL;
    let wheel = Wheel::solved();
    for arm in 1..=ARMS {
        let (sin, cos) = (60.0 * arm as f64).to_radians().sin_cos();
        for ring in 1..=RINGS {
            if let Some(colour) = wheel.bead(ring, arm) {
                let far = GOAL_STEP * ring as f64;
                let at = (x + (far * cos).round() as i32, y - (far * sin).round() as i32);
                screen.disc(at.0, at.1, 3, Color::from_index(8 + colour), Color::Black);
            }
        }
    }
    screen.disc(x, y, 3, Color::LightGray, Color::Black);
    screen.text(x - 36, y + 38, texts::GOAL.of(language), Color::Blue);
}

/// The moves of the rings with the sides of their letters.
const TURNS: [[Move; 2]; 3] = [[Move::I, Move::J], [Move::K, Move::L], [Move::M, Move::N]];

fn draw_controls(screen: &mut Screen) {
    let (x, y) = CONTROLS;
    for radius in [1, 3, 5, 7] {
        screen.circle(x, y, RIM * radius, Stroke::thin(Color::Black));
    }
    for y in [y - RIM, y + RIM] {
        screen.line(420, y, 600, y, Stroke::thin(Color::Black));
    }
    for ([left, right], way) in TURNS.into_iter().zip([26, 52, 78]) {
        letter(screen, x + way - 2, y - 10, right);
        letter(screen, x - way - 9, y - 10, left);
        for x in [x + way - 8, x - way + 8] {
            let gray = Stroke::thick(Color::LightGray);
            screen.line(x, y - 10, x, y + 10, gray);
            for side in [-2, 2] {
                screen.line(x + side, y + 5, x, y + 10, gray);
            }
        }
    }
}

/// The middle of what is clicked for a move.
fn handle(wheel: &Wheel, a_move: Move) -> (i32, i32) {
    if let Some(arm) = (1..=ARMS).find(|arm| Move::ALL.get(arm - 1) == Some(&a_move)) {
        return on_arm(arm, 5.0 * STEP - 12.0 + HALF * f64::from(wheel.drawer(arm)), 0.0);
    }
    let turns = TURNS.into_iter().zip([26, 52, 78]);
    let mut sides = turns.flat_map(|([left, right], way)| [(left, -way), (right, way)]);
    let way = sides.find(|&(turn, _)| turn == a_move).map_or(0, |(_, way)| way); // every other move is there
    (CONTROLS.0 + way, CONTROLS.1)
}

/// The move of a click: within 20 pixels of a drawer's handle or 12 of a ring's letter.
pub(crate) fn move_at(wheel: &Wheel, x: i32, y: i32) -> Option<Move> {
    let near = |a_move: &Move| {
        let (hx, hy) = handle(wheel, *a_move);
        let reach = if (*a_move as usize) < ARMS { 400 } else { 144 };
        (x - hx) * (x - hx) + (y - hy) * (y - hy) < reach
    };
    Move::ALL.into_iter().find(near)
}
