//! What a picture consists of: items in world coordinates with their styles.

use super::{Axes, FigureError};
use crate::geometry::{BoundingBox, COORDINATE_LIMIT, Closure, CubicBezier, Point};

/// Width of a picture in nominal pixels, the unit of line widths, radii and dashes. A picture that is
/// written with another width is the same picture enlarged or reduced.
pub const NOMINAL_WIDTH: u32 = 800;
/// The smallest width of a picture in pixels.
pub const SMALLEST_WIDTH: u32 = 16;
/// The largest width of a picture in pixels.
pub const LARGEST_WIDTH: u32 = 16384;

/// The longest caption in letters.
pub const LONGEST_CAPTION: usize = 2000;

/// The largest line width, radius and dash in nominal pixels.
const LARGEST_SIZE: f64 = 100.0;
/// The shortest period of dashes in nominal pixels; finer ones would be a million strokes.
const SHORTEST_PERIOD: f64 = 0.5;

/// How an item is drawn; colours are red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The colour of the line, `None` for no line.
    pub stroke: Option<[u8; 3]>,
    /// The width of the line in nominal pixels, 0 to 100.
    pub width: f64,
    /// The colour of the inside, `None` for an empty one.
    pub fill: Option<[u8; 3]>,
    /// The lengths of dashes and of the gaps between them in nominal pixels, `None` for a solid line.
    /// Each is 0 to 100, both together 0.5 at least. Dashes have round ends.
    pub dash: Option<[f64; 2]>,
}

impl Style {
    /// A solid line of a width in nominal pixels.
    #[must_use]
    pub fn line(stroke: [u8; 3], width: f64) -> Style {
        Style { stroke: Some(stroke), width, fill: None, dash: None }
    }

    /// The same with dashes and gaps of these lengths in nominal pixels.
    #[must_use]
    pub fn dashed(self, dash: f64, gap: f64) -> Style {
        Style { dash: Some([dash, gap]), ..self }
    }

    /// An area with a thin edge.
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

/// One thing in a picture.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    Curve { arcs: Vec<CubicBezier<2>>, closure: Closure, style: Style },
    Polyline { points: Vec<Point<2>>, closure: Closure, style: Style },
    Disc { at: Point<2>, radius: f64, style: Style, label: Option<String> },
    Text { at: Point<2>, text: String },
}

impl Item {
    /// What users call this kind of item.
    fn kind(&self) -> &'static str {
        match self {
            Self::Curve { .. } => "curve",
            Self::Polyline { .. } => "polyline",
            Self::Disc { .. } => "disc",
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
/// Items are drawn in the order in which they are added, all letters above them. The picture shows
/// everything that was added with a margin around; nothing at all gives an empty picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    pub(super) title: Option<String>,
    pub(super) caption: Option<String>,
    pub(super) axes: Option<Axes>,
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

    /// Puts a title above the picture.
    pub fn set_title(&mut self, title: impl Into<String>) {
        self.title = Some(title.into());
    }

    /// Puts a caption below the picture, in as many lines as it needs; 2000 letters at most.
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

    /// Takes the axes away.
    pub fn clear_axes(&mut self) {
        self.axes = None;
    }

    /// Adds a row of cubic arcs, each beginning where the one before ends; where it does not, the line
    /// is interrupted.
    pub fn curve(&mut self, arcs: Vec<CubicBezier<2>>, closure: Closure, style: Style) {
        self.items.push(Item::Curve { arcs, closure, style });
    }

    /// Adds straight lines from point to point, as a control polygon.
    pub fn polyline(&mut self, points: Vec<Point<2>>, closure: Closure, style: Style) {
        self.items.push(Item::Polyline { points, closure, style });
    }

    /// Adds a disc, as a control point, with a radius of 0 to 100 nominal pixels. Its label stands
    /// beside it, where it covers least.
    pub fn disc(&mut self, at: Point<2>, radius: f64, style: Style, label: Option<String>) {
        self.items.push(Item::Disc { at, radius, style, label });
    }

    /// Adds a line of letters that begins at a point, or as far left of it as the picture needs.
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

/// Whether a width in pixels is one of a picture.
pub(super) fn check_width(width: u32) -> Result<(), FigureError> {
    if (SMALLEST_WIDTH..=LARGEST_WIDTH).contains(&width) {
        return Ok(());
    }
    Err(FigureError::Width { given: width, least: SMALLEST_WIDTH, most: LARGEST_WIDTH })
}

/// Where a row of arcs has to be taken up anew, because an arc does not begin where the one before
/// ends; differences by rounding do not count. The first arc always begins.
pub(super) fn begins(arcs: &[CubicBezier<2>]) -> impl Iterator<Item = (bool, &CubicBezier<2>)> {
    let bounds = BoundingBox::around(arcs.iter().flat_map(|arc| arc.p));
    let rounding = bounds.map_or(0.0, |it| it.rounding());
    let apart = move |a: Point<2>, b: Point<2>| (0..2).any(|d| (a[d] - b[d]).abs() > rounding);
    let ends = std::iter::once(None).chain(arcs.iter().map(|arc| Some(arc.p[3])));
    arcs.iter().zip(ends).map(move |(arc, end)| (end.is_none_or(|end| apart(end, arc.p[0])), arc))
}
