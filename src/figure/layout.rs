//! The layout of a picture: the map from world coordinates to pixels, and the places of text.
//!
//! All sizes here are nominal pixels, y downwards.

use super::axes::{Axes, PlaneAxes, Rules, SpaceAxes};
use super::legend;
use super::letters::{ASCENT, Area, DESCENT, LETTER_WIDTH, Letters, length};
use super::picture::{Figure, Item, NOMINAL_WIDTH, Style};
use super::wrap::wrap;
use crate::geometry::{BoundingBox, CubicBezier, Point};
use std::collections::HashMap;

const TEXT_SIZE: f64 = 15.0;
const TITLE_SIZE: f64 = 22.0;
/// Height of a line of the caption, and the margin below the last one.
const CAPTION_LINE: f64 = 20.0;
const CAPTION_END: f64 = 12.0;
/// Height of the band above the picture that holds the title.
const TITLE_BAND: f64 = 44.0;
/// Margin around everything.
const MARGIN: f64 = 32.0;
/// The least height of a picture without its title.
const LEAST_HEIGHT: f64 = 160.0;
/// Gap between the numbers of axes and the edge of the picture or the caption.
const BAND_GAP: f64 = 12.0;
/// Gap between a disc and its label.
const GAP: f64 = 3.0;
/// Gap between the middle of a line and its name.
const NAME_GAP: f64 = 7.0;
/// Labels times obstacles that are looked at; beyond it, labels stand at the upper right of their discs or
/// nowhere.
const MOST_LOOKS: usize = 4_000_000;
/// Number of chords that approximate an arc when labels are placed.
const PIECES: u32 = 8;

/// The style of the lines of axes.
pub(super) const RULE: Style = Style { stroke: Some([0; 3]), width: 1.0, fill: None, dash: None };

/// The measures of a picture.
#[derive(Debug)]
pub(super) struct Layout {
    /// Height of the picture, a whole number.
    pub(super) height: f64,
    /// Pixels per world unit.
    pub(super) scale: f64,
    /// The pixel of the world's origin.
    pub(super) origin: Point<2>,
    /// The title, all labels and texts, the numbers of the axes and the caption.
    pub(super) letters: Vec<Letters>,
    /// The lines of axes.
    pub(super) rules: Vec<[Point<2>; 2]>,
}

impl Layout {
    /// Fits a checked figure into its picture.
    pub(super) fn new(figure: &Figure) -> Layout {
        let width = f64::from(NOMINAL_WIDTH);
        let overhang = figure.overhang();
        let margin = MARGIN + overhang;
        let measured = Measured::new(figure, width - 2.0 * margin, overhang);
        let [left, bottom] = measured.bands().map(|band| (band - margin + BAND_GAP).max(0.0));
        let window = measured.window();
        let room = width - left - 2.0 * margin;
        let [across, up] = window.size();
        // At least one extent is positive.
        let scale = room / across.max(up);
        let top = if figure.title.is_some() { TITLE_BAND } else { 0.0 };
        let caption = caption_lines(figure);
        let under = if caption.is_empty() { 0.0 } else { CAPTION_LINE * caption.len() as f64 + CAPTION_END };
        let end = under + legend::height(&figure.legend);
        let height = (top + (up * scale + 2.0 * margin + bottom).max(LEAST_HEIGHT) + end).ceil();
        let middle: Point<2> = std::array::from_fn(|d| window.min[d] + (window.max[d] - window.min[d]) / 2.0);
        let center = [(width + left) / 2.0, (height + top - bottom - end) / 2.0];
        let origin = [center[0] - scale * middle[0], center[1] + scale * middle[1]];
        let mut layout = Layout { height, scale, origin, letters: Vec::new(), rules: Vec::new() };
        let Rules { lines, letters } = measured.rules(|point| layout.place(point));
        layout.rules = lines;
        let labels = layout.labels(figure, &letters);
        let title = figure.title.iter().map(|title| heading(title));
        let legend = legend::letters(&figure.legend, height - end);
        let caption = below(height - under, &caption);
        layout.letters = title.chain(labels).chain(letters).chain(legend).chain(caption).collect();
        layout
    }

    /// The pixel of a point of the world.
    pub(super) fn place(&self, [x, y]: Point<2>) -> Point<2> {
        [self.origin[0] + self.scale * x, self.origin[1] - self.scale * y]
    }

    /// The labels of discs, the names of lines and the texts; they keep off the numbers of axes. Labels that would cover
    /// others are left out: neither could be read.
    fn labels(&self, figure: &Figure, numbers: &[Letters]) -> Vec<Letters> {
        let crowded = looks(figure) > MOST_LOOKS;
        let mut taken = Taken { legs: Vec::new(), areas: Vec::new(), height: self.height };
        if !crowded {
            taken.legs = self.legs(figure);
            taken.legs.extend(&self.rules);
            taken.areas = self.areas(figure);
            taken.areas.extend(numbers.iter().map(Letters::area));
        }
        let mut written = Written::default();
        numbers.iter().for_each(|number| written.add(number.area()));
        let mut letters = Vec::new();
        for item in &figure.items {
            let (places, text, ink, distance) = match item {
                Item::Disc { at, label: Some(label), .. } => {
                    (std::slice::from_ref(at), label, [0; 3], overhang(item) + GAP)
                }
                Item::Name { places, text, ink } => (places.as_slice(), text, *ink, NAME_GAP),
                Item::Text { at, text } => {
                    let ([x, y], text) = (self.place(*at), printable(text));
                    let rightmost = f64::from(NOMINAL_WIDTH) - 4.0 - length(&text, TEXT_SIZE);
                    letters.push(Letters::black(text, [x.min(rightmost).max(4.0), y], TEXT_SIZE));
                    continue;
                }
                _ => continue,
            };
            let text = printable(text);
            let size = [length(&text, TEXT_SIZE), TEXT_SIZE * (ASCENT + DESCENT)];
            let around = places.iter().map(|at| self.place(*at));
            let areas = around.flat_map(|at| DIRECTIONS.map(|way| beside(at, distance, size, way)));
            let areas: Vec<Area> = if crowded { areas.take(1).collect() } else { areas.collect() };
            let area = taken.freest(&areas);
            if written.covers(area) {
                continue;
            }
            taken.areas.push(area);
            written.add(area);
            let at = [area[0], area[1] + TEXT_SIZE * ASCENT];
            letters.push(Letters { text, at, size: TEXT_SIZE, ink });
        }
        letters
    }

    /// All lines as straight segments.
    fn legs(&self, figure: &Figure) -> Vec<[Point<2>; 2]> {
        let mut legs = Vec::new();
        for item in &figure.items {
            match item {
                Item::Curve { arcs, .. } => legs.extend(arcs.iter().flat_map(|arc| self.pieces(arc))),
                Item::Polyline { points, .. } => {
                    let pairs = points.iter().zip(points.iter().skip(1));
                    legs.extend(pairs.map(|(&a, &b)| [self.place(a), self.place(b)]));
                }
                Item::Disc { .. } | Item::Name { .. } | Item::Text { .. } => {}
            }
        }
        legs
    }

    fn pieces(&self, arc: &CubicBezier<2>) -> impl Iterator<Item = [Point<2>; 2]> {
        let point = |j: u32| self.place(arc.eval(f64::from(j) / f64::from(PIECES)));
        (0..PIECES).map(move |j| [point(j), point(j + 1)])
    }

    /// The inscribed squares of all discs: labels may come near their round edges.
    fn areas(&self, figure: &Figure) -> Vec<Area> {
        let square = |item: &Item| match item {
            Item::Disc { at, .. } => {
                let ([x, y], r) = (self.place(*at), DIAGONAL * overhang(item));
                Some([x - r, y - r, x + r, y + r])
            }
            _ => None,
        };
        figure.items.iter().filter_map(square).collect()
    }
}

/// The visible part of the world with its axes.
enum Measured {
    Plain(BoundingBox<2>),
    Plane(PlaneAxes),
    Space(BoundingBox<2>, SpaceAxes),
}

impl Measured {
    /// The visible part of a figure of the given size in pixels. Axes whose numbers have too many digits are left
    /// out.
    fn new(figure: &Figure, room: f64, overhang: f64) -> Measured {
        let window = window(figure);
        let axes = match figure.axes {
            None => None,
            Some(Axes::Plane) => PlaneAxes::new(window, room, overhang).map(Measured::Plane),
            Some(Axes::Space { view, bounds }) => {
                SpaceAxes::new(view, bounds).map(|axes| Measured::Space(window.union(axes.window()), axes))
            }
        };
        axes.unwrap_or(Measured::Plain(window))
    }

    fn window(&self) -> BoundingBox<2> {
        match self {
            Measured::Plain(window) | Measured::Space(window, _) => *window,
            Measured::Plane(axes) => axes.window(),
        }
    }

    /// The margins that the axes need, left of the window and below it.
    fn bands(&self) -> [f64; 2] {
        match self {
            Measured::Plain(_) | Measured::Space(..) => [0.0; 2],
            Measured::Plane(axes) => axes.bands(),
        }
    }

    fn rules(&self, place: impl Fn(Point<2>) -> Point<2>) -> Rules {
        match self {
            Measured::Plain(_) => Rules::default(),
            Measured::Plane(axes) => axes.rules(place),
            Measured::Space(_, axes) => axes.rules(place),
        }
    }
}

impl Figure {
    /// How far items reach beyond their points.
    fn overhang(&self) -> f64 {
        self.items.iter().map(overhang).fold(0.0, f64::max)
    }

    /// Whether it shall have axes, but cannot: their numbers would have more digits than can be told apart.
    #[must_use]
    pub fn lacks_axes(&self) -> bool {
        let overhang = self.overhang();
        let room = f64::from(NOMINAL_WIDTH) - 2.0 * (MARGIN + overhang);
        self.axes.is_some() && matches!(Measured::new(self, room, overhang), Measured::Plain(_))
    }
}

/// How far an item reaches beyond its points.
fn overhang(item: &Item) -> f64 {
    match item {
        Item::Curve { style, .. } | Item::Polyline { style, .. } => style.width / 2.0,
        Item::Disc { radius, style, .. } => radius + style.stroke.map_or(0.0, |_| style.width / 2.0),
        Item::Name { .. } | Item::Text { .. } => 0.0,
    }
}

/// The bounding box of everything, padded so that at least one extent is positive and can be divided by.
fn window(figure: &Figure) -> BoundingBox<2> {
    let of_item = |item: &Item| match item {
        Item::Curve { arcs, .. } => arcs.iter().map(CubicBezier::bounding_box).reduce(BoundingBox::union),
        Item::Polyline { points, .. } => BoundingBox::of_points(points),
        Item::Name { places, .. } => BoundingBox::of_points(places),
        Item::Disc { at, .. } | Item::Text { at, .. } => Some(BoundingBox::of_point(*at)),
    };
    let all = figure.items.iter().filter_map(of_item).reduce(BoundingBox::union);
    let window = all.unwrap_or(BoundingBox { min: [0.0; 2], max: [1.0; 2] });
    let (largest, extent) = (window.largest_coordinate(), window.extent());
    // Smaller extents hold rounding only; the smallest numbers have no finite reciprocal.
    if extent > (1e-14 * largest).max(1e-150) {
        return window;
    }
    let pad = if largest > 1e-150 { 0.5 * largest } else { 0.5 };
    BoundingBox { min: window.min.map(|x| x - pad), max: window.max.map(|x| x + pad) }
}

/// The title, centred in its band; in a smaller font if it is long.
fn heading(title: &str) -> Letters {
    let (text, width) = (printable(title), f64::from(NOMINAL_WIDTH));
    let size = TITLE_SIZE * (0.95 * width / length(&text, TITLE_SIZE).max(1.0)).min(1.0);
    let at = [(width - length(&text, size)) / 2.0, TITLE_BAND / 2.0 + 0.4 * size];
    Letters::black(text, at, size)
}

/// The caption in lines that fit; none for a blank one.
fn caption_lines(figure: &Figure) -> Vec<String> {
    let text = figure.caption.as_deref().unwrap_or("");
    if text.trim().is_empty() {
        return Vec::new();
    }
    let fitting = 0.95 * f64::from(NOMINAL_WIDTH) / (LETTER_WIDTH * TEXT_SIZE);
    wrap(text, fitting as usize).iter().map(|line| printable(line)).collect()
}

/// Centred lines, from a given height on.
fn below(top: f64, lines: &[String]) -> impl Iterator<Item = Letters> {
    (0..).zip(lines).map(move |(row, text)| {
        let left = (f64::from(NOMINAL_WIDTH) - length(text, TEXT_SIZE)) / 2.0;
        let at = [left, top + CAPTION_LINE * f64::from(row) + TEXT_SIZE];
        Letters::black(text.clone(), at, TEXT_SIZE)
    })
}

/// A text without characters that XML or fonts cannot show.
pub(super) fn printable(text: &str) -> String {
    let shown =
        |ch: char| if ch.is_control() || matches!(ch, '\u{FFFE}' | '\u{FFFF}') { '\u{FFFD}' } else { ch };
    text.chars().map(shown).collect()
}

const DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The directions in which a label may lie from its disc, best first.
const DIRECTIONS: [[f64; 2]; 8] = [
    [DIAGONAL, -DIAGONAL],
    [-DIAGONAL, -DIAGONAL],
    [DIAGONAL, DIAGONAL],
    [-DIAGONAL, DIAGONAL],
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, -1.0],
    [0.0, 1.0],
];

/// The area of a given size at a distance from a place.
fn beside([x, y]: Point<2>, distance: f64, [width, height]: [f64; 2], [right, down]: [f64; 2]) -> Area {
    let corner = |along: f64, size: f64| match along {
        along if along > 0.0 => along * distance,
        along if along < 0.0 => along * distance - size,
        _ => -size / 2.0,
    };
    let (left, top) = (x + corner(right, width), y + corner(down, height));
    [left, top, left + width, top + height]
}

/// Labels times obstacles of a figure.
fn looks(figure: &Figure) -> usize {
    let (mut labels, mut obstacles) = (0_usize, 0_usize);
    for item in &figure.items {
        obstacles += match item {
            Item::Curve { arcs, .. } => arcs.len().saturating_mul(PIECES as usize),
            Item::Polyline { points, .. } => points.len(),
            Item::Disc { .. } => 1,
            Item::Name { .. } | Item::Text { .. } => 0,
        };
        labels += match item {
            Item::Disc { label, .. } => usize::from(label.is_some()),
            Item::Name { places, .. } => places.len(),
            _ => 0,
        };
    }
    labels.saturating_mul(obstacles)
}

/// What is written, by squares of the picture, so that finding what is near takes no longer for many letters.
#[derive(Default)]
struct Written(HashMap<[i64; 2], Vec<Area>>);

impl Written {
    /// The side of a square: about a label.
    const SIDE: f64 = 32.0;
    /// Lines of letters whose areas meet by no more than this can be read: digits do not fill the height.
    const TOUCH: f64 = 3.0;

    fn squares([left, top, right, bottom]: Area) -> impl Iterator<Item = [i64; 2]> {
        let square = |place: f64| (place / Self::SIDE).floor() as i64;
        let rows = square(top)..=square(bottom);
        rows.flat_map(move |row| (square(left)..=square(right)).map(move |column| [column, row]))
    }

    fn add(&mut self, area: Area) {
        Self::squares(area).for_each(|square| self.0.entry(square).or_default().push(area));
    }

    /// Whether something is written there.
    fn covers(&self, [left, top, right, bottom]: Area) -> bool {
        let inner = [left, top + Self::TOUCH, right, bottom - Self::TOUCH];
        let near = Self::squares(inner).filter_map(|square| self.0.get(&square));
        near.flatten().any(|area| overlap(*area, inner))
    }
}

/// What labels should not cover.
struct Taken {
    legs: Vec<[Point<2>; 2]>,
    areas: Vec<Area>,
    height: f64,
}

impl Taken {
    /// The area that covers least; the first one of equals.
    fn freest(&self, areas: &[Area]) -> Area {
        let free = match areas {
            // There is nothing to choose from.
            [only] => Some(only),
            areas => areas.iter().min_by_key(|area| self.cost(**area)),
        };
        free.copied().unwrap_or_default()
    }

    /// The penalty for covering an area: text and discs count more than lines, and leaving the picture counts most.
    fn cost(&self, area: Area) -> usize {
        let lines = self.legs.iter().filter(|leg| crosses(**leg, area)).count();
        let others = self.areas.iter().filter(|other| overlap(**other, area)).count();
        let [left, top, right, bottom] = area;
        let outside = left < 0.0 || top < 0.0 || right > f64::from(NOMINAL_WIDTH) || bottom > self.height;
        lines.min(50) + 100 * others + if outside { 10_000 } else { 0 }
    }
}

fn overlap(a: Area, b: Area) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Whether a segment crosses an area.
fn crosses([a, b]: [Point<2>; 2], area: Area) -> bool {
    let around = [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])];
    // Strict comparison would miss horizontal and vertical lines.
    let apart = around[0] > area[2] || around[2] < area[0] || around[1] > area[3] || around[3] < area[1];
    // Are all corners on one side of the line?
    let side = |x: f64, y: f64| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let [left, top, right, bottom] = area;
    let sides = [side(left, top), side(right, top), side(left, bottom), side(right, bottom)];
    !apart && !sides.iter().all(|s| *s > 0.0) && !sides.iter().all(|s| *s < 0.0)
}
