//! The panel of the open page: rows of values and of actions, each with its letter.

use super::studio::{Page, Studio};
use super::texts;
use crate::file::ec::{Fill, Item, Light, Material};
use crate::geometry::ec::Real;
use crate::machine::Language;
use crate::screen::{Color, Screen};
use crate::ui::words::Words;
use crate::ui::{Area, panel, window};

/// The panel.
pub(super) const PANEL: Area = Area::new(489, 60, 633, 462);
/// Upper edge of the first row, distance of rows, left edges of names and windows.
const TOP: i32 = 64;
const LINE: i32 = 17;
const NAMES: i32 = 494;
const WINDOWS: [i32; 2] = [570, 630];
/// Letters in a window.
pub(super) const SHOWN: usize = 7;

/// A value of the scene, an item, a point, or of a command that is yet to come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Value {
    Line,
    SelectedLine,
    Points,
    Mesh,
    PolygonColor,
    Ground,
    Axes,
    Light,
    Polygon,
    First,
    Second,
    Scale,
    Color,
    FirstColor,
    SecondColor,
    Real,
    Imaginary,
    Times,
    At,
    Normals,
    Isolines,
    Fill,
    Material,
    NormalColor,
    LineColor,
    Index,
    X,
    Y,
    Z,
    Step,
}

/// What a row without a window does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Centre,
    Load,
    Save,
    Items,
    Elevate,
    Divide,
    IntoEqual,
    Coefficients,
    Join,
    Interpolate,
    NextPoint,
    PreviousPoint,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Row {
    Value(char, Words, Value),
    /// One action, or two beside each other.
    Actions(&'static [(char, Words, Action)]),
    Title(Words),
}

const VIEW: &[Row] = &[
    Row::Value('A', Words("-vonal", "-line"), Value::Line),
    Row::Value('J', Words("-kijel.", "-select."), Value::SelectedLine),
    Row::Value('N', Words("-pontok", "-points"), Value::Points),
    Row::Value('M', Words("-háló", "-mesh"), Value::Mesh),
    Row::Value('P', Words("-poligon", "-polygon"), Value::PolygonColor),
    Row::Value('H', Words("-háttér", "-ground"), Value::Ground),
    Row::Value('T', Words("-tengely", "-axes"), Value::Axes),
    Row::Value('L', Words("-fény", "-light"), Value::Light),
    Row::Actions(&[('K', Words("-közép", "-centre"), Action::Centre)]),
    Row::Actions(&[
        ('O', Words("-betölt", "-load"), Action::Load),
        ('S', Words("-ment", "-save"), Action::Save),
    ]),
    Row::Actions(&[('I', Words("-elemek:", "-items:"), Action::Items)]),
];

const RAISE: Words = Words("-- rend emelése", "-- raise order");
const DIVIDE: Words = Words("-- osztás", "-- divide");

const CURVE: &[Row] = &[
    Row::Value('P', Words("-poligon", "-polygon"), Value::Polygon),
    Row::Value('F', Words("-1. der.", "-1st d."), Value::First),
    Row::Value('M', Words("-2. der.", "-2nd d."), Value::Second),
    Row::Value('L', Words("-hossz", "-scale"), Value::Scale),
    Row::Value('S', Words("-szín", "-colour"), Value::Color),
    Row::Value('E', Words("-1. szín", "-1st c."), Value::FirstColor),
    Row::Value('A', Words("-2. szín", "-2nd c."), Value::SecondColor),
    Row::Title(RAISE),
    Row::Value('R', Words("-valós", "-real"), Value::Real),
    Row::Value('I', Words("-képz.", "-imag."), Value::Imaginary),
    Row::Value('T', Words("-szoros", "-times"), Value::Times),
    Row::Actions(&[('O', Words("-mehet!", "-go!"), Action::Elevate)]),
    Row::Title(DIVIDE),
    Row::Value('G', Words("-hely u=", "-at u="), Value::At),
    Row::Actions(&[
        ('D', Words("-darab.", "-divide"), Action::Divide),
        ('C', Words("-sávok", "-equal"), Action::IntoEqual),
    ]),
    Row::Title(Words("-- leírás", "-- description")),
    Row::Actions(&[('K', Words("-együtthatók", "-coefficients"), Action::Coefficients)]),
    Row::Actions(&[
        ('J', Words("-kötés", "-join"), Action::Join),
        ('N', Words("-interp", "-interp"), Action::Interpolate),
    ]),
];

const SURFACE: &[Row] = &[
    Row::Value('P', Words("-háló", "-net"), Value::Polygon),
    Row::Value('N', Words("-normál", "-normals"), Value::Normals),
    Row::Value('S', Words("-vonalak", "-isolin."), Value::Isolines),
    Row::Value('F', Words("-felület", "-fill"), Value::Fill),
    Row::Value('A', Words("-anyag", "-mater."), Value::Material),
    Row::Value('L', Words("-hossz", "-scale"), Value::Scale),
    Row::Value('E', Words("-n.szín", "-nor.col"), Value::NormalColor),
    Row::Value('M', Words("-v.szín", "-iso.col"), Value::LineColor),
    Row::Title(RAISE),
    Row::Value('R', Words("-valós", "-real"), Value::Real),
    Row::Value('I', Words("-képz.", "-imag."), Value::Imaginary),
    Row::Value('T', Words("-szoros", "-times"), Value::Times),
    Row::Actions(&[('O', Words("-mehet!", "-go!"), Action::Elevate)]),
    Row::Title(DIVIDE),
    Row::Value('G', Words("-hely", "-at"), Value::At),
    Row::Actions(&[
        ('D', Words("-darab.", "-divide"), Action::Divide),
        ('C', Words("-sávok", "-equal"), Action::IntoEqual),
    ]),
    Row::Actions(&[
        ('K', Words("-együt.", "-coeffs"), Action::Coefficients),
        ('J', Words("-kötés", "-join"), Action::Join),
    ]),
];

const POINT: &[Row] = &[
    Row::Value('I', Words("-index", "-index"), Value::Index),
    Row::Value('X', Words("", ""), Value::X),
    Row::Value('Y', Words("", ""), Value::Y),
    Row::Value('Z', Words("", ""), Value::Z),
    Row::Value('L', Words("-lépés", "-step"), Value::Step),
    Row::Actions(&[
        ('N', Words("-köv.", "-next"), Action::NextPoint),
        ('P', Words("-előző", "-prev."), Action::PreviousPoint),
    ]),
];

/// The rows of a page.
pub(super) fn rows(page: Page) -> &'static [Row] {
    match page {
        Page::View => VIEW,
        Page::Curve => CURVE,
        Page::Surface => SURFACE,
        Page::Point => POINT,
    }
}

/// The upper edge of a row.
fn top(row: usize) -> i32 {
    TOP + LINE * i32::try_from(row).unwrap_or(0)
}

/// Below the rows of a page.
pub(super) fn below(page: Page) -> i32 {
    top(rows(page).len())
}

fn window_of(row: usize) -> Area {
    Area::new(WINDOWS[0], top(row) - 3, WINDOWS[1], top(row) + 10)
}

/// Where an action stands: the whole row, or a half of it.
fn place(row: usize, at: usize, of: usize) -> Area {
    let [left, right] = match (at, of) {
        (_, 1) => [PANEL.x1, PANEL.x2],
        (0, _) => [PANEL.x1, 564],
        _ => [564, PANEL.x2],
    };
    Area::new(left, top(row) - 4, right, top(row) + 12)
}

/// The value with this letter on a page.
pub(super) fn value_of(page: Page, letter: char) -> Option<Value> {
    rows(page).iter().find_map(|row| match row {
        Row::Value(own, _, value) if *own == letter => Some(*value),
        _ => None,
    })
}

/// The action with this letter on a page.
pub(super) fn action_of(page: Page, letter: char) -> Option<Action> {
    let actions = rows(page).iter().filter_map(|row| match row {
        Row::Actions(actions) => Some(*actions),
        _ => None,
    });
    actions.flatten().find(|(own, ..)| *own == letter).map(|(.., action)| *action)
}

/// What a pixel of the panel belongs to.
pub(super) enum Hit {
    Value(Value),
    Action(Action),
}

/// The row under a pixel.
pub(super) fn hit(page: Page, (x, y): (i32, i32)) -> Option<Hit> {
    rows(page).iter().enumerate().find_map(|(row, kind)| match kind {
        Row::Value(_, _, value) => place(row, 0, 1).holds(x, y).then_some(Hit::Value(*value)),
        Row::Actions(actions) => {
            let inside =
                |&(at, _): &(usize, &(char, Words, Action))| place(row, at, actions.len()).holds(x, y);
            actions.iter().enumerate().find(inside).map(|(_, (.., action))| Hit::Action(*action))
        }
        Row::Title(_) => None,
    })
}

fn letter_and_word(screen: &mut Screen, (x, y): (i32, i32), letter: char, word: &str) {
    screen.text(x, y, letter.encode_utf8(&mut [0; 4]), Color::Red);
    screen.text(x + 8, y, word, Color::Black);
}

/// Draws the panel of the open page.
pub(super) fn draw(studio: &Studio, screen: &mut Screen, language: Language) {
    panel(screen, PANEL.x1, PANEL.y1, PANEL.x2 - PANEL.x1, PANEL.y2 - PANEL.y1);
    for (row, kind) in rows(studio.page).iter().enumerate() {
        let y = top(row);
        match kind {
            Row::Value(letter, name, value) => {
                letter_and_word(screen, (NAMES, y), *letter, name.of(language));
                window(screen, window_of(row));
                let text: String = studio.shown(*value, language).chars().take(SHOWN).collect();
                let width = 8 * i32::try_from(text.chars().count()).unwrap_or(0);
                let middle = (WINDOWS[0] + WINDOWS[1]) / 2;
                screen.text((middle - width / 2).max(WINDOWS[0] + 3), y, &text, Color::White);
            }
            Row::Actions(actions) => {
                for (at, (letter, name, action)) in actions.iter().enumerate() {
                    let x = place(row, at, actions.len()).x1 + if at == 0 { NAMES - PANEL.x1 } else { 4 };
                    letter_and_word(screen, (x, y), *letter, name.of(language));
                    if *action == Action::Elevate {
                        let (text, color) = studio.elevation_told();
                        screen.text(x + 70, y, &text, color);
                    }
                }
            }
            Row::Title(title) => {
                screen.text(NAMES, y, title.of(language), Color::Blue);
                if studio.page == Page::Surface {
                    let along = if studio.along == 0 { "U" } else { "V" };
                    screen.text(PANEL.x2 - 16, y, along, Color::Brown);
                }
            }
        }
    }
}

/// Whether all names lie beside their windows, for the test over all programs.
#[cfg(test)]
pub(super) fn too_wide() -> Vec<String> {
    let mut wide = Vec::new();
    let width = |text: &str| 8 * (1 + i32::try_from(text.chars().count()).unwrap_or(99));
    for page in Page::ALL {
        for (row, kind) in rows(page).iter().enumerate() {
            for language in [Language::Hungarian, Language::English] {
                match kind {
                    Row::Value(_, name, _) if NAMES + width(name.of(language)) > WINDOWS[0] => {
                        wide.push(name.of(language).to_owned());
                    }
                    Row::Actions(actions) => {
                        for (at, (_, name, _)) in actions.iter().enumerate() {
                            let area = place(row, at, actions.len());
                            if area.x1 + 4 + width(name.of(language)) > area.x2 {
                                wide.push(name.of(language).to_owned());
                            }
                        }
                    }
                    _ => {}
                }
            }
        }
    }
    wide
}

/// How a value is changed.
pub(super) enum Way {
    /// To the next of some.
    Turn,
    /// By an expression in a range.
    Number([f64; 2]),
    /// By a whole number in a range.
    Whole([i64; 2]),
    /// By two whole numbers in a range.
    Pair([i64; 2]),
    /// By a place on the item.
    Place,
    /// By the index of a control point.
    Index,
}

impl Value {
    pub(super) fn way(self) -> Way {
        match self {
            Value::Line => Way::Whole([1, 5]),
            Value::SelectedLine => Way::Whole([1, 7]),
            Value::Points => Way::Whole([10, 1000]),
            Value::Mesh => Way::Pair([2, 80]),
            Value::Isolines => Way::Pair([0, 100]),
            Value::Scale => Way::Number([1e-6, 1e6]),
            Value::Real | Value::Imaginary => Way::Number([-100.0, 100.0]),
            Value::Times => Way::Whole([1, 31]),
            Value::X | Value::Y | Value::Z => Way::Number([-super::edit::FARTHEST, super::edit::FARTHEST]),
            Value::Step => Way::Number([1e-6, 1e6]),
            Value::At => Way::Place,
            Value::Index => Way::Index,
            _ => Way::Turn,
        }
    }
}

/// A number in a window of seven letters.
pub(super) fn short(value: f64) -> String {
    let whole = value.to_string();
    if whole.chars().count() <= SHOWN {
        return whole;
    }
    let fixed =
        (0..6).rev().map(|digits| format!("{value:.digits$}")).find(|text| text.chars().count() <= SHOWN);
    // A number that is too small or too large for that.
    match fixed {
        Some(text) if value == 0.0 || !text.trim_matches(['0', '.', '-']).is_empty() => text,
        _ => (0..4)
            .rev()
            .map(|digits| format!("{value:.digits$e}"))
            .find(|text| text.chars().count() <= SHOWN)
            .unwrap_or(whole),
    }
}

/// The next of some, or the one before, around.
fn turned<T: PartialEq + Copy>(all: &[T], now: T, forward: bool) -> T {
    let at = all.iter().position(|&it| it == now).unwrap_or(0);
    let step = if forward { 1 } else { all.len() - 1 };
    all.get((at + step) % all.len().max(1)).copied().unwrap_or(now)
}

fn turned_color(now: u8, forward: bool) -> u8 {
    if forward { (now + 1) % 16 } else { (now + 15) % 16 }
}

impl Studio {
    /// A value as its window shows it.
    pub(super) fn shown(&self, value: Value, language: Language) -> String {
        let settings = &self.scene().settings;
        let word = |words: Words| words.of(language).to_owned();
        let yes = |it: bool| word(if it { texts::YES } else { texts::NO });
        let color = |it: u8| word(texts::COLORS[usize::from(it & 15)]);
        let curve = || match self.item() {
            Some(Item::Curve(curve)) => Some(&curve.style),
            _ => None,
        };
        let patch = || match self.item() {
            Some(Item::Patch(patch)) => Some(&patch.style),
            _ => None,
        };
        let pair = |[a, b]: [usize; 2]| format!("{a}x{b}");
        let of = |text: Option<String>| text.unwrap_or_default();
        match value {
            Value::Line => settings.line.to_string(),
            Value::SelectedLine => settings.selected.to_string(),
            Value::Points => settings.points.to_string(),
            Value::Mesh => pair(settings.mesh),
            Value::PolygonColor => color(settings.polygon),
            Value::Ground => color(settings.ground),
            Value::Axes => yes(settings.axes),
            Value::Light => word(if settings.light == Light::Eye { texts::EYE } else { texts::UPPER_LEFT }),
            Value::Polygon => {
                let always = curve().map(|it| it.polygon).or(patch().map(|it| it.polygon));
                of(always.map(|it| word(if it { texts::ALWAYS } else { texts::WHEN_SELECTED })))
            }
            Value::First => of(curve().map(|it| yes(it.first))),
            Value::Second => of(curve().map(|it| yes(it.second))),
            Value::Scale => of(curve().map(|it| it.scale).or(patch().map(|it| it.scale)).map(short)),
            Value::Color => of(curve().map(|it| color(it.colour))),
            Value::FirstColor => of(curve().map(|it| color(it.first_colour))),
            Value::SecondColor => of(curve().map(|it| color(it.second_colour))),
            Value::Real => real(&self.order.re),
            Value::Imaginary => real(&self.order.im),
            Value::Times => self.order.multiplicity.to_string(),
            Value::At => of(self.at.as_ref().map(|at| short(at.value()))),
            Value::Normals => of(patch().map(|it| yes(it.normals))),
            Value::Isolines => of(patch().map(|it| pair(it.isolines))),
            Value::Fill => {
                let place = |fill| Fill::ALL.iter().position(|&it| it == fill).unwrap_or(0);
                of(patch().map(|it| word(texts::FILLS[place(it.fill)])))
            }
            Value::Material => {
                let place = |it| Material::ALL.iter().position(|&other| other == it).unwrap_or(0);
                of(patch().map(|it| word(texts::MATERIALS[place(it.material)])))
            }
            Value::NormalColor => of(patch().map(|it| color(it.normal_colour))),
            Value::LineColor => of(patch().map(|it| color(it.line_colour))),
            Value::Index => of(self.point_name()),
            Value::X => of(self.coordinate(0).map(short)),
            Value::Y => of(self.coordinate(1).map(short)),
            Value::Z => of(self.coordinate(2).map(short)),
            Value::Step => short(self.step),
        }
    }

    /// A value as it is typed.
    pub(super) fn typed(&self, value: Value) -> String {
        let of = |number: Option<f64>| number.map(|number| number.to_string()).unwrap_or_default();
        match value {
            Value::Real => self.order.re.to_string(),
            Value::Imaginary => self.order.im.to_string(),
            Value::X => of(self.coordinate(0)),
            Value::Y => of(self.coordinate(1)),
            Value::Z => of(self.coordinate(2)),
            Value::Step => self.step.to_string(),
            Value::Scale => of(match self.item() {
                Some(Item::Curve(curve)) => Some(curve.style.scale),
                Some(Item::Patch(patch)) => Some(patch.style.scale),
                None => None,
            }),
            Value::At => self.at.as_ref().map(ToString::to_string).unwrap_or_default(),
            _ => self.shown(value, Language::English),
        }
    }

    /// Turns a choice, or steps a number, forward or back.
    pub(super) fn turn(&mut self, value: Value, forward: bool) {
        let by = if forward { 1_i64 } else { -1 };
        let mut scene = self.scene().clone();
        let settings = &mut scene.settings;
        let within = |now: usize, by: i64, [low, high]: [i64; 2]| {
            (i64::try_from(now).unwrap_or(high) + by).clamp(low, high) as usize
        };
        match value {
            Value::Line => settings.line = within(settings.line.into(), by, [1, 5]) as u8,
            Value::SelectedLine => settings.selected = within(settings.selected.into(), by, [1, 7]) as u8,
            Value::Points => settings.points = within(settings.points, 10 * by, [10, 1000]),
            Value::Mesh => settings.mesh = settings.mesh.map(|it| within(it, by, [2, 80])),
            Value::PolygonColor => settings.polygon = turned_color(settings.polygon, forward),
            Value::Ground => settings.ground = turned_color(settings.ground, forward),
            Value::Axes => settings.axes = !settings.axes,
            Value::Light => {
                settings.light = turned(&[Light::Eye, Light::UpperLeft], settings.light, forward);
            }
            Value::Times => {
                self.order.multiplicity = within(self.order.multiplicity, by, [1, 31]);
                return;
            }
            Value::Real | Value::Imaginary => {
                let part = if value == Value::Real { &mut self.order.re } else { &mut self.order.im };
                *part = Real::from(part.value() + by as f64);
                return;
            }
            Value::Step => {
                self.step = (self.step * if forward { 2.0 } else { 0.5 }).clamp(1e-6, 1e6);
                return;
            }
            Value::X | Value::Y | Value::Z => {
                let axis = value as usize - Value::X as usize;
                if let Some(now) = self.coordinate(axis) {
                    self.set_coordinate(axis, now + by as f64 * self.step);
                }
                return;
            }
            Value::Index => {
                self.step_point(forward);
                return;
            }
            Value::At => {
                self.step_place(forward);
                return;
            }
            _ => match self.selected.and_then(|at| scene.items.get_mut(at)) {
                Some(Item::Curve(curve)) => {
                    let style = &mut curve.style;
                    match value {
                        Value::Polygon => style.polygon = !style.polygon,
                        Value::First => style.first = !style.first,
                        Value::Second => style.second = !style.second,
                        Value::Color => style.colour = turned_color(style.colour, forward),
                        Value::FirstColor => style.first_colour = turned_color(style.first_colour, forward),
                        Value::SecondColor => {
                            style.second_colour = turned_color(style.second_colour, forward);
                        }
                        Value::Scale => style.scale = scaled(style.scale, forward),
                        _ => {}
                    }
                }
                Some(Item::Patch(patch)) => {
                    let style = &mut patch.style;
                    match value {
                        Value::Polygon => style.polygon = !style.polygon,
                        Value::Normals => style.normals = !style.normals,
                        Value::Isolines => style.isolines = style.isolines.map(|it| within(it, by, [0, 100])),
                        Value::Fill => style.fill = turned(&Fill::ALL, style.fill, forward),
                        Value::Material => style.material = turned(&Material::ALL, style.material, forward),
                        Value::NormalColor => {
                            style.normal_colour = turned_color(style.normal_colour, forward);
                        }
                        Value::LineColor => style.line_colour = turned_color(style.line_colour, forward),
                        Value::Scale => style.scale = scaled(style.scale, forward),
                        _ => {}
                    }
                }
                None => {}
            },
        }
        self.change(scene);
    }

    /// Sets a number that was typed.
    pub(super) fn set(&mut self, value: Value, number: Real) {
        let plain = number.value();
        match value {
            Value::Real => self.order.re = number,
            Value::Imaginary => self.order.im = if plain < 0.0 { Real::from(-plain) } else { number },
            Value::Step => self.step = plain,
            Value::X | Value::Y | Value::Z => self.set_coordinate(value as usize - Value::X as usize, plain),
            Value::Scale => {
                let mut scene = self.scene().clone();
                match self.selected.and_then(|at| scene.items.get_mut(at)) {
                    Some(Item::Curve(curve)) => curve.style.scale = plain,
                    Some(Item::Patch(patch)) => patch.style.scale = plain,
                    None => {}
                }
                self.change(scene);
            }
            _ => {}
        }
    }

    /// Sets whole numbers that were typed.
    pub(super) fn set_whole(&mut self, value: Value, [a, b]: [usize; 2]) {
        let mut scene = self.scene().clone();
        let byte = |number: usize| u8::try_from(number).unwrap_or(1);
        match value {
            Value::Line => scene.settings.line = byte(a),
            Value::SelectedLine => scene.settings.selected = byte(a),
            Value::Points => scene.settings.points = a,
            Value::Mesh => scene.settings.mesh = [a, b],
            Value::Times => self.order.multiplicity = a,
            Value::Isolines => {
                if let Some(Item::Patch(patch)) = self.selected.and_then(|at| scene.items.get_mut(at)) {
                    patch.style.isolines = [a, b];
                }
            }
            _ => {}
        }
        self.change(scene);
    }
}

fn scaled(scale: f64, forward: bool) -> f64 {
    (scale * if forward { 1.25 } else { 0.8 }).clamp(1e-6, 1e6)
}

fn real(number: &Real) -> String {
    let text = number.to_string();
    if text.chars().count() <= SHOWN { text } else { short(number.value()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_fit_and_letters_have_one_meaning() {
        assert_eq!(too_wide(), [""; 0]);
        for page in Page::ALL {
            let mut letters: Vec<char> = Vec::new();
            for row in rows(page) {
                match row {
                    Row::Value(letter, ..) => letters.push(*letter),
                    Row::Actions(actions) => letters.extend(actions.iter().map(|(letter, ..)| *letter)),
                    Row::Title(_) => {}
                }
            }
            let count = letters.len();
            letters.sort_unstable();
            letters.dedup();
            assert_eq!(letters.len(), count, "{page:?}");
            // Actions work at once, so they have letters that no command has.
            for letter in "VBEGTQ".chars() {
                assert!(action_of(page, letter).is_none());
            }
        }
    }

    #[test]
    fn numbers_are_shown_in_seven_letters() {
        assert_eq!([0.0, 25.5, -1.25, 0.25].map(short), ["0", "25.5", "-1.25", "0.25"]);
        let shown = [std::f64::consts::FRAC_PI_4, -1e6, 1e-9].map(short);
        assert_eq!(shown, ["0.78540", "-1.00e6", "1.00e-9"]);
        for value in [1.0 / 3.0, -123_456.789, 1e300, -1e-300, 12.434_999] {
            assert!(short(value).chars().count() <= SHOWN, "{}", short(value));
        }
    }
}
