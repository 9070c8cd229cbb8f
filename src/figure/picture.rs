//! Figures: items in world coordinates with their styles.

use super::legend::Entry;
use super::{Axes, FigureError};
use crate::geometry::{BoundingBox, COORDINATE_LIMIT, Closure, CubicBezier, Point};

/// Width of a picture in nominal pixels, the unit of line widths, radii and dashes. A picture written with another
/// width is the same picture, scaled.
pub const NOMINAL_WIDTH: u32 = 800;
/// The smallest width of a picture in pixels.
pub const SMALLEST_WIDTH: u32 = 16;
/// The largest width of a picture in pixels.
pub const LARGEST_WIDTH: u32 = 16384;

/// Greatest length of a caption in characters.
pub const LONGEST_CAPTION: usize = 2000;

/// The largest line width, radius and dash in nominal pixels.
const LARGEST_SIZE: f64 = 100.0;
/// The shortest period of dashes in nominal pixels; shorter ones would make millions of strokes.
const SHORTEST_PERIOD: f64 = 0.5;

/// The style of an item; colours are red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The colour of the line, `None` for no line.
    pub stroke: Option<[u8; 3]>,
    /// The width of the line in nominal pixels, 0 to 100.
    pub width: f64,
    /// The fill colour, `None` for no fill.
    pub fill: Option<[u8; 3]>,
    /// The lengths of dashes and of the gaps between them in nominal pixels, `None` for a solid line.
    /// Each is 0 to 100, their sum at least 0.5. Dashes have round caps.
    pub dash: Option<[f64; 2]>,
}

impl Style {
    /// A solid line of the given width in nominal pixels.
    #[must_use]
    pub fn line(stroke: [u8; 3], width: f64) -> Style {
        Style { stroke: Some(stroke), width, fill: None, dash: None }
    }

    /// The same with dashes and gaps of these lengths in nominal pixels.
    #[must_use]
    pub fn dashed(self, dash: f64, gap: f64) -> Style {
        Style { dash: Some([dash, gap]), ..self }
    }

    /// A filled area with a thin edge.
    #[must_use]
    pub fn filled(fill: [u8; 3], edge: [u8; 3]) -> Style {
        Style { fill: Some(fill), ..Style::line(edge, 1.0) }
    }

    fn check(&self, item: &str) -> Result<(), FigureError> {
        check_size(item, "line width", self.width)?;
        let Some([dash, gap]) = self.dash else { return Ok(()) };
        check_size(item, "dash", dash)?;
        check_size(item, "gap of the dashes", gap)?;
        if dash + gap < SHORTEST_PERIOD {
            let (name, wanted) = ("dash and gap together", "0.5 pixels at least");
            return Err(FigureError::Style { item: item.to_string(), name, value: dash + gap, wanted });
        }
        Ok(())
    }
}

fn check_size(item: &str, name: &'static str, value: f64) -> Result<(), FigureError> {
    if (0.0..=LARGEST_SIZE).contains(&value) {
        return Ok(());
    }
    Err(FigureError::Style { item: item.to_string(), name, value, wanted: "0 to 100 pixels" })
}

/// An item of a picture.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    Curve { arcs: Vec<CubicBezier<2>>, closure: Closure, style: Style },
    Polyline { points: Vec<Point<2>>, closure: Closure, style: Style },
    Disc { at: Point<2>, radius: f64, style: Style, label: Option<String> },
    Name { places: Vec<Point<2>>, text: String, ink: [u8; 3] },
    Text { at: Point<2>, text: String },
}

impl Item {
    /// The name of this kind of item in messages.
    fn kind(&self) -> &'static str {
        match self {
            Self::Curve { .. } => "curve",
            Self::Polyline { .. } => "polyline",
            Self::Disc { .. } => "disc",
            Self::Name { .. } => "name",
            Self::Text { .. } => "text",
        }
    }

    fn check(&self, name: &str) -> Result<(), FigureError> {
        match self {
            Self::Curve { arcs, style, .. } => {
                style.check(name)?;
                arcs.iter().enumerate().try_for_each(|(index, arc)| {
                    check_points(&arc.p, |_| format!("{name}, arc {}", index + 1))
                })
            }
            Self::Polyline { points, style, .. } => {
                style.check(name)?;
                check_points(points, |index| format!("{name}, point {}", index + 1))
            }
            Self::Disc { at, radius, style, .. } => {
                style.check(name)?;
                check_size(name, "radius", *radius)?;
                check_points(&[*at], |_| name.to_string())
            }
            Self::Name { places, .. } => check_points(places, |_| name.to_string()),
            Self::Text { at, .. } => check_points(&[*at], |_| name.to_string()),
        }
    }
}

fn check_points(points: &[Point<2>], name: impl Fn(usize) -> String) -> Result<(), FigureError> {
    let usable = |value: f64| value.abs() <= COORDINATE_LIMIT;
    for (index, point) in points.iter().enumerate() {
        if let Some(&value) = point.iter().find(|&&value| !usable(value)) {
            return Err(FigureError::Coordinate { item: name(index), value });
        }
    }
    Ok(())
}

/// A picture in world coordinates, x to the right and y upwards, with the same scale for both.
///
/// Items are drawn in the order in which they are added, and all text above them. The picture shows all items with a
/// margin around them. Without items it is empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    pub(super) title: Option<String>,
    pub(super) caption: Option<String>,
    pub(super) axes: Option<Axes>,
    pub(super) legend: Vec<Entry>,
    pub(super) items: Vec<Item>,
    /// Whether a surface without area is in it, which cannot be seen as one.
    pub(super) lacks_area: bool,
}

impl Figure {
    /// An empty picture.
    #[must_use]
    pub fn new() -> Figure {
        Figure::default()
    }

    /// Whether nothing has been added.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Sets the title above the picture.
    pub fn set_title(&mut self, title: impl Into<String>) {
        self.title = Some(title.into());
    }

    /// Sets the caption below the picture, of at most 2000 characters. It is wrapped.
    pub fn set_caption(&mut self, caption: impl Into<String>) {
        self.caption = Some(caption.into());
    }

    /// Draws axes with ticks and numbers; where they would have more digits than can be told apart, they are
    /// left out: [`Figure::lacks_axes`].
    pub fn set_axes(&mut self, axes: Axes) {
        self.axes = Some(axes);
    }

    /// The axes, if it has any.
    #[must_use]
    pub fn axes(&self) -> Option<Axes> {
        self.axes
    }

    /// Removes the axes.
    pub fn clear_axes(&mut self) {
        self.axes = None;
    }

    /// Adds a chain of cubic arcs. Where an arc does not begin at the end of the previous one, the line is
    /// interrupted.
    pub fn curve(&mut self, arcs: Vec<CubicBezier<2>>, closure: Closure, style: Style) {
        self.items.push(Item::Curve { arcs, closure, style });
    }

    /// Adds straight lines from point to point, such as a control polygon.
    pub fn polyline(&mut self, points: Vec<Point<2>>, closure: Closure, style: Style) {
        self.items.push(Item::Polyline { points, closure, style });
    }

    /// Adds a disc, as a control point, with a radius of 0 to 100 nominal pixels. Its label stands
    /// beside it, where it covers least; where it would cover other letters, it is left out.
    pub fn disc(&mut self, at: Point<2>, radius: f64, style: Style, label: Option<String>) {
        self.items.push(Item::Disc { at, radius, style, label });
    }

    /// Adds the name of a line in a colour (red, green, blue). It stands beside one of these places on the line, where it
    /// covers least; where it would cover other letters, it is left out.
    pub fn name(&mut self, places: Vec<Point<2>>, text: impl Into<String>, ink: [u8; 3]) {
        self.items.push(Item::Name { places, text: text.into(), ink });
    }

    /// Adds a line of text that begins at a point, or further left if it would leave the picture.
    pub fn text(&mut self, at: Point<2>, text: impl Into<String>) {
        self.items.push(Item::Text { at, text: text.into() });
    }

    /// Whether everything can be drawn.
    ///
    /// # Errors
    /// [`FigureError`] says what cannot: a coordinate, a style, a caption that is too long, or a surface without area.
    pub fn check(&self) -> Result<(), FigureError> {
        if self.lacks_area {
            return Err(FigureError::NoArea);
        }
        let letters = self.caption.as_deref().map_or(0, |caption| caption.chars().count());
        if letters > LONGEST_CAPTION {
            return Err(FigureError::Caption { given: letters, most: LONGEST_CAPTION });
        }
        let mut counts = std::collections::BTreeMap::new();
        for item in &self.items {
            let count = counts.entry(item.kind()).or_insert(0_usize);
            *count += 1;
            item.check(&format!("{} {count}", item.kind()))?;
        }
        Ok(())
    }
}

/// Checks the width of a picture in pixels.
pub(super) fn check_width(width: u32) -> Result<(), FigureError> {
    if (SMALLEST_WIDTH..=LARGEST_WIDTH).contains(&width) {
        return Ok(());
    }
    Err(FigureError::Width { given: width, least: SMALLEST_WIDTH, most: LARGEST_WIDTH })
}

/// For each arc, whether it starts a new subpath because it does not begin at the end of the previous one, up to
/// rounding errors. The first arc always does.
pub(super) fn begins(arcs: &[CubicBezier<2>]) -> impl Iterator<Item = (bool, &CubicBezier<2>)> {
    let bounds = BoundingBox::around(arcs.iter().flat_map(|arc| arc.p));
    let rounding = bounds.map_or(0.0, |it| it.rounding());
    let apart = move |a: Point<2>, b: Point<2>| (0..2).any(|d| (a[d] - b[d]).abs() > rounding);
    let ends = std::iter::once(None).chain(arcs.iter().map(|arc| Some(arc.p[3])));
    arcs.iter().zip(ends).map(move |(arc, end)| (end.is_none_or(|end| apart(end, arc.p[0])), arc))
}
