//! Draws surfaces: as wires, or as filled cells with a depth buffer.

use super::fine::Fine;
use super::plan::Family;
use super::{Nets, normals};
use crate::design::{DesignError, NetDesign};
use crate::geometry::painter::Step;
use crate::geometry::{BoundingBox, DepthBuffer, GeometryError, Grid, ParamSurface, Vertex, near_first};
use crate::machine::Language;
use crate::screen::{Color, HEIGHT, Screen, Stroke, WIDTH};
use crate::ui::look::Look;
use crate::ui::words;
use std::cell::OnceCell;

/// Wires or filled cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Display {
    /// Every line is visible.
    Wire,
    /// Black cells with white edges hide what is behind them.
    Filled,
}

impl Display {
    /// Writes the key that switches to the other one.
    pub(crate) fn draw_legend(self, screen: &mut Screen, language: Language) {
        let other = match self {
            Display::Wire => words::FILLED_LEGEND,
            Display::Filled => words::WIRE_LEGEND,
        };
        screen.text(15, 102, other.of(language), Color::LightGray);
    }
}

/// A surface with the grid of points it is drawn from.
#[derive(Debug)]
pub(crate) struct Drawn {
    /// What it is drawn from: the whole surface, or patches, offsets and walls.
    pub(crate) parts: Vec<Part>,
    /// Cells of the net without surface.
    pub(crate) gaps: Vec<Grid>,
    /// Spans of the whole surface along u and v.
    pub(crate) spans: [usize; 2],
    /// Grid cells per cell of the net, in each direction.
    pub(crate) steps: usize,
    /// What inspection colours it by, once it has been asked for: it stays the same while the surface is turned.
    pub(super) fine: OnceCell<Fine>,
}

/// A part of what is drawn.
#[derive(Debug)]
pub(crate) struct Part {
    /// The surface; walls have none.
    pub(crate) surface: Option<Box<dyn ParamSurface>>,
    pub(crate) grid: Grid,
    /// Its own colour, for what stands beside the surface.
    pub(crate) ink: Option<Color>,
    /// Whether it is folded, and so drawn in red.
    pub(crate) folded: bool,
}

impl Part {
    /// The colour of its lines, in a picture of the given one.
    fn lines(&self, ink: Color) -> Color {
        if self.folded { Color::LightRed } else { self.ink.unwrap_or(ink) }
    }
}

impl Drawn {
    /// A whole surface, with so many grid cells per cell of its net.
    ///
    /// # Errors
    /// More points than a grid may have.
    pub(crate) fn of(surface: Box<dyn ParamSurface>, steps: usize) -> Result<Drawn, GeometryError> {
        let grid = surface.grid(steps)?;
        let spans = surface.spans();
        let part = Part { surface: Some(surface), grid, ink: None, folded: false };
        Ok(Drawn { parts: vec![part], gaps: Vec::new(), spans, steps, fine: OnceCell::new() })
    }

    /// The parts of the surface itself.
    pub(super) fn own(&self) -> impl Iterator<Item = (&dyn ParamSurface, &Grid)> {
        let own = self.parts.iter().filter(|part| part.ink.is_none());
        own.filter_map(|part| Some((&**part.surface.as_ref()?, &part.grid)))
    }

    /// Whether there is more than a line to see.
    pub(crate) fn has_area(&self) -> bool {
        self.parts.iter().map(|part| &part.grid).chain(&self.gaps).any(Grid::has_area)
    }

    /// All points that it is drawn from.
    pub(crate) fn bounds(&self) -> Option<BoundingBox<3>> {
        let grids = self.parts.iter().map(|part| &part.grid).chain(&self.gaps);
        grids.filter_map(|grid| BoundingBox::of_points(grid.points())).reduce(BoundingBox::union)
    }
}

/// What the cells are filled with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fill {
    /// The same colour on both sides.
    Plain,
    /// Grey on the lower side.
    Sides,
}

impl Nets {
    /// The surface of a net; else why there is none.
    pub(super) fn draw_up(&self, net: &NetDesign) -> Result<Drawn, DesignError> {
        if self.plan.family == Family::Normals {
            return normals::draw_up(net, self.beside);
        }
        let surface = net.surface()?;
        let [rows, columns] = net.shape();
        // Large nets are drawn with fewer cells, which keeps the picture quick and readable.
        let steps = (self.plan.steps * 64 / (rows * columns).max(64)).max(2);
        Ok(Drawn::of(surface, steps)?)
    }

    pub(super) fn fill(&self) -> Fill {
        if self.plan.family == Family::Heights { Fill::Sides } else { Fill::Plain }
    }

    /// The present display; height fields have no wires.
    pub(super) fn display_now(&self) -> Display {
        if self.plan.family == Family::Heights { Display::Filled } else { self.display }
    }
}

/// Draws the points of a grid.
pub(super) fn draw_grid(
    screen: &mut Screen,
    grid: &Grid,
    look: Look,
    (display, fill): (Display, Fill),
    ink: Color,
) {
    match display {
        Display::Wire => draw_wires(screen, grid, look, ink),
        Display::Filled => draw_cells(screen, &[grid], look, |_, corners| match fill {
            Fill::Sides if below(corners) => (Color::LightGray, Some(ink)),
            Fill::Sides | Fill::Plain => (Color::Black, Some(ink)),
        }),
    }
}

/// Draws all parts of a surface; cells without surface are red.
pub(crate) fn draw_parts(
    screen: &mut Screen,
    drawn: &Drawn,
    look: Look,
    (display, fill): (Display, Fill),
    ink: Color,
) {
    if let ([part], []) = (drawn.parts.as_slice(), drawn.gaps.as_slice()) {
        return draw_grid(screen, &part.grid, look, (display, fill), ink);
    }
    match display {
        Display::Wire => {
            drawn.gaps.iter().for_each(|gap| draw_gap(screen, gap, look));
            // The surface itself over what stands beside it.
            for own in [false, true] {
                let parts = drawn.parts.iter().filter(|part| part.ink.is_none() == own);
                parts.for_each(|part| draw_wires(screen, &part.grid, look, part.lines(ink)));
            }
        }
        Display::Filled => {
            let grids: Vec<&Grid> = drawn.parts.iter().map(|part| &part.grid).chain(&drawn.gaps).collect();
            draw_cells(screen, &grids, look, |[index, _], _| match drawn.parts.get(index) {
                Some(part) => (Color::Black, Some(part.lines(ink))),
                None => (Color::Red, Some(Color::LightRed)),
            });
        }
    }
}

/// Draws a cell without surface: its outline and its diagonals.
pub(super) fn draw_gap(screen: &mut Screen, gap: &Grid, look: Look) {
    let pixels: Vec<(i32, i32)> = gap.points().iter().map(|&point| look.to_screen(point)).collect();
    if let &[a, b, c, d] = pixels.as_slice() {
        screen.polyline(&[a, b, d, c, a, d], Stroke::thick(Color::LightRed));
        screen.polyline(&[b, c], Stroke::thick(Color::LightRed));
    }
}

pub(crate) fn draw_wires(screen: &mut Screen, grid: &Grid, look: Look, ink: Color) {
    let places = look.places();
    let pixels: Vec<(i32, i32)> = grid.points().iter().map(|&point| places.to_screen(point)).collect();
    let stroke = Stroke::thin(ink);
    for row in pixels.chunks(grid.columns()) {
        screen.polyline(row, stroke);
    }
    for l in 0..grid.columns() {
        let column: Vec<(i32, i32)> = pixels.iter().skip(l).step_by(grid.columns()).copied().collect();
        screen.polyline(&column, stroke);
    }
}

/// Cells that have fewer pixels than this are drawn as they come: to find out which are near costs more than what is hidden.
const LEAST_CELL: usize = 8;

/// Draws the cells of grids that hide each other; fill and edge colour of each are given by the indices of its grid and
/// of the cell in it, and by its corners.
pub(crate) fn draw_cells(
    screen: &mut Screen,
    grids: &[&Grid],
    look: Look,
    inks: impl Fn([usize; 2], &[Vertex; 4]) -> (Color, Option<Color>),
) {
    let points = grids.iter().flat_map(|grid| grid.points());
    let places = look.places();
    let mut vertices: Vec<Vertex> = points.map(|&point| places.vertex(point)).collect();
    let Some((corner, [width, height])) = seen(&vertices) else { return };
    for vertex in &mut vertices {
        (vertex.x, vertex.y) = (vertex.x.saturating_sub(corner.0), vertex.y.saturating_sub(corner.1));
    }
    let mut first = 0;
    let starts = grids.iter().map(|grid| {
        let start = first;
        first += grid.points().len();
        start
    });
    let cells: Vec<([usize; 2], [usize; 4])> = starts
        .zip(grids.iter().enumerate())
        .flat_map(|(start, (index, grid))| {
            let cells = grid.cells().enumerate();
            cells.map(move |(number, cell)| ([index, number], cell.map(|corner| start + corner)))
        })
        .collect();
    // The indices come from the grids' points.
    let corners = |cell: &[usize; 4]| cell.map(|corner| vertices.get(corner).copied().unwrap_or_default());
    let order = if cells.len().saturating_mul(LEAST_CELL) < width * height {
        let nearest = |cell: &[usize; 4]| corners(cell).iter().map(|it| it.depth).fold(f32::MIN, f32::max);
        near_first(&cells.iter().map(|(_, cell)| nearest(cell)).collect::<Vec<_>>())
    } else {
        (0..).take(cells.len()).collect()
    };
    let mut buffer = DepthBuffer::new(width, height);
    for number in order {
        let Some((place, cell)) = cells.get(number as usize) else { continue };
        let corners = corners(cell);
        let (fill, edge) = inks(*place, &corners);
        buffer.cell(&corners, fill as u8, edge.map(|edge| edge as u8));
    }
    show(screen, &buffer, corner);
}

/// Draws cells of a grid one over the other, in the order of a painter's steps; the last one in another colour.
pub(super) fn draw_in_order(screen: &mut Screen, grid: &Grid, look: Look, steps: &[Step]) {
    let cells: Vec<[usize; 4]> = grid.cells().collect();
    let mut buffer = DepthBuffer::new(WIDTH as usize, HEIGHT as usize);
    for (order, step) in steps.iter().enumerate() {
        let Some(cell) = cells.get(step.face) else { continue };
        let corners = cell.map(|corner| {
            let (x, y) = look.to_screen(grid.points().get(corner).copied().unwrap_or([0.0; 3]));
            Vertex { x, y, depth: order as f32 }
        });
        let (fill, edge) = match (order + 1 == steps.len(), step.spoils > 0) {
            (false, _) => (Color::Black, Color::White),
            (true, false) => (Color::Brown, Color::Yellow),
            (true, true) => (Color::Red, Color::LightRed),
        };
        buffer.cell(&corners, fill as u8, Some(edge as u8));
    }
    show(screen, &buffer, (0, 0));
}

/// The bounding box of vertices on the screen: upper left pixel, width and height. `None` if it is empty.
fn seen(vertices: &[Vertex]) -> Option<((i32, i32), [usize; 2])> {
    let span = |along: fn(&Vertex) -> i32, size: i32| {
        let (least, most) = vertices.iter().map(along).fold((size, -1), |(a, b), x| (a.min(x), b.max(x)));
        let (least, most) = (least.max(0), most.min(size - 1));
        (least <= most).then(|| (least, (most - least + 1) as usize))
    };
    let ((x, width), (y, height)) = (span(|it| it.x, WIDTH)?, span(|it| it.y, HEIGHT)?);
    Some(((x, y), [width, height]))
}

/// Whether the lower side of a height field's cell is visible: its corners then have the opposite orientation.
fn below(corners: &[Vertex; 4]) -> bool {
    let [a, b, c, d] = corners.map(|corner| (f64::from(corner.x), f64::from(corner.y)));
    (c.0 - a.0) * (d.1 - b.1) - (c.1 - a.1) * (d.0 - b.0) < 0.0
}

/// Copies a depth buffer to the screen, with its upper left pixel at the given one.
fn show(screen: &mut Screen, buffer: &DepthBuffer, (x, y): (i32, i32)) {
    for (y, (_, row)) in (y..).zip(buffer.rows()) {
        screen.row(x, y, row.iter().map(|pixel| pixel.color().map(Color::from_index)));
    }
}
