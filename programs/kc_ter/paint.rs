//! The picture of a scene: curves, patches in wires, shaded or coloured, needles and lines, what is nearest in front.

use super::edit::{self, Index};
use super::eye::{Eye, FIELD};
use super::shape::{Shape, Shapes};
use crate::design::ec::EcWeave;
use crate::file::ec::{CurveStyle, Fill, Item, Light, Material, PatchStyle, Scene};
use crate::geometry::{
    BoundingBox, DepthBuffer, Grid, ParamCurve, ParamSurface, Plane, Point, Vertex, cross, dot, norm, section,
};
use crate::screen::{Color, Screen};
use crate::ui::Area;
use crate::ui::tint::{self, Zebra};

/// The most needles on an item.
const NEEDLES: usize = 50;
/// The most control points that are seen with their numbers.
const MOST_NUMBERS: usize = 30;
/// Radii of control points with and without a number.
const RADII: [i32; 2] = [10, 3];
/// Length of an axis in pixels.
const AXIS: f64 = 90.0;
/// How far lines on a surface lie before it, in pixels, and what always lies in front.
const BEFORE: f32 = 1.5;
const FRONT: f32 = 1e9;

/// Tones from dark to light.
const fn tones(material: Material) -> [Color; 4] {
    use Color::*;
    match material {
        Material::Brass => [Black, Brown, Yellow, White],
        Material::Gold => [Brown, Yellow, Yellow, White],
        Material::Silver => [Black, DarkGray, LightGray, White],
        Material::Emerald => [Black, Green, LightGreen, White],
        Material::Pearl => [DarkGray, LightGray, White, White],
        Material::Ruby => [Black, Red, LightRed, White],
        Material::Turquoise => [Black, Cyan, LightCyan, White],
        Material::Copper => [Black, Red, Brown, Yellow],
        Material::Sapphire => [Black, Blue, LightBlue, White],
        Material::Rubber => [Black, Black, DarkGray, LightGray],
    }
}

/// Steps of brightness from the darkest to the lightest tone, and between two tones.
const LEVELS: u8 = 18;
const BETWEEN: u8 = LEVELS / 3;
/// Codes of the depth buffer: the colours, then the levels of every material.
const SHADES: u8 = 16;

/// The ordered dither of 4x4 pixels (Bayer).
const ORDER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

fn shade(material: Material, brightness: f64) -> u8 {
    let kind = Material::ALL.iter().position(|&it| it == material).unwrap_or(0) as u8;
    // A cast saturates, and NaN is 0.
    let level = (brightness.clamp(0.0, 1.0) * f64::from(LEVELS)).round() as u8;
    SHADES + kind * (LEVELS + 1) + level
}

/// The colour of a code at a pixel.
fn dithered(code: u8, x: usize, y: usize) -> Color {
    let Some(code) = code.checked_sub(SHADES) else { return Color::from_index(code) };
    let (kind, level) = (code / (LEVELS + 1), code % (LEVELS + 1));
    let tones = tones(Material::ALL.get(usize::from(kind)).copied().unwrap_or_default());
    let (tone, rest) = (usize::from(level / BETWEEN), level % BETWEEN);
    // Sixteenths of the cell that have the lighter tone.
    let share = rest * 16 / BETWEEN;
    let lighter = ORDER[y % 4][x % 4] < share;
    tones[(tone + usize::from(lighter)).min(3)]
}

/// What is seen of a scene besides itself.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Show {
    /// The selected item and its control point.
    pub(super) selected: Option<usize>,
    pub(super) point: Option<Index>,
    /// Whether the control points and polygons of all items are seen.
    pub(super) polygons: bool,
    /// Whether control points are seen at all.
    pub(super) handles: bool,
    /// What fills all patches instead of their own fill.
    pub(super) fill: Option<Fill>,
    /// A plane across an axis.
    pub(super) section: Option<(usize, f64)>,
}

struct Canvas<'a> {
    buffer: DepthBuffer,
    corner: (i32, i32),
    eye: Eye,
    scene: &'a Scene,
}

/// Draws a scene into an area of the screen.
pub(super) fn paint(screen: &mut Screen, area: Area, eye: Eye, scene: &Scene, shapes: &Shapes, show: Show) {
    let settings = &scene.settings;
    screen.bar(area.x1, area.y1, area.x2, area.y2, Color::from_index(settings.ground));
    let size = [area.x2 - area.x1 + 1, area.y2 - area.y1 + 1].map(|side| usize::try_from(side).unwrap_or(0));
    let mut canvas =
        Canvas { buffer: DepthBuffer::new(size[0], size[1]), corner: (area.x1, area.y1), eye, scene };
    if settings.axes {
        canvas.axes();
    }
    let bounds = shapes.bounds(None);
    for (at, item) in scene.items.iter().enumerate() {
        let Some(shape) = shapes.of(at) else { continue };
        let width = if show.selected == Some(at) { settings.selected } else { settings.line };
        match (item, shape) {
            (Item::Curve(curve), Shape::Curve { arc, line }) if !curve.style.hidden => {
                canvas.polyline(line, curve.style.colour, width, 0.0);
                canvas.curve_needles(arc, &curve.style);
            }
            (Item::Patch(patch), Shape::Patch { weave, grid }) if !patch.style.hidden => {
                canvas.patch(weave, grid, &patch.style, width, show, bounds);
            }
            _ => continue,
        }
        if has_polygon(item, show, at) {
            canvas.polygon(item);
        }
    }
    for (y, (_, row)) in (area.y1..).zip(canvas.buffer.rows()) {
        let line = (y - area.y1) as usize;
        let colors =
            row.iter().enumerate().map(|(x, pixel)| pixel.color().map(|code| dithered(code, x, line)));
        screen.row(area.x1, y, colors);
    }
    if show.handles {
        handles(screen, area, eye, scene, show);
    }
    if settings.axes {
        for (name, end) in axis_ends(eye) {
            let (x, y) = eye.pixel(end);
            text_inside(screen, area, (x + 3, y - 3), name, Color::White);
        }
    }
}

/// Whether an item is hidden.
pub(super) fn is_hidden(item: &Item) -> bool {
    match item {
        Item::Curve(curve) => curve.style.hidden,
        Item::Patch(patch) => patch.style.hidden,
    }
}

fn has_polygon(item: &Item, show: Show, at: usize) -> bool {
    let always = match item {
        Item::Curve(curve) => curve.style.polygon,
        Item::Patch(patch) => patch.style.polygon,
    };
    show.handles && (show.polygons || always || show.selected == Some(at))
}

fn axis_ends(eye: Eye) -> [(&'static str, Point<3>); 3] {
    let long = AXIS / eye.zoom;
    [("x", [long, 0.0, 0.0]), ("y", [0.0, long, 0.0]), ("z", [0.0, 0.0, long])]
}

/// Draws a text if all of it lies inside.
fn text_inside(screen: &mut Screen, area: Area, (x, y): (i32, i32), text: &str, color: Color) {
    let right = x + 8 * i32::try_from(text.chars().count()).unwrap_or(0);
    if area.holds(x, y) && area.holds(right, y + 8) {
        screen.text(x, y, text, color);
    }
}

/// The items whose control points are seen, the selected one last.
fn with_handles(scene: &Scene, show: Show) -> impl Iterator<Item = (usize, &Item)> {
    let seen = move |&(at, item): &(usize, &Item)| !is_hidden(item) && has_polygon(item, show, at);
    let all = move || scene.items.iter().enumerate().filter(seen);
    all()
        .filter(move |(at, _)| show.selected != Some(*at))
        .chain(all().filter(move |(at, _)| show.selected == Some(*at)))
}

/// The radius of control points: those of curves have their numbers in them, if they are few.
pub(super) fn radius(scene: &Scene, show: Show) -> i32 {
    let count = |item: &Item| match item {
        Item::Curve(curve) => curve.points.len(),
        Item::Patch(_) => MOST_NUMBERS + 1,
    };
    let count: usize = with_handles(scene, show).map(|(_, item)| count(item)).sum();
    RADII[usize::from(count > MOST_NUMBERS)]
}

fn handles(screen: &mut Screen, area: Area, eye: Eye, scene: &Scene, show: Show) {
    let radius = radius(scene, show);
    let numbers = radius == RADII[0];
    let inside = |(x, y): (i32, i32), r: i32| area.holds(x - r, y - r) && area.holds(x + r, y + r);
    for (at, item) in with_handles(scene, show) {
        let mut points = edit::control_points(item);
        // From far to near.
        points.sort_by(|a, b| eye.view.depth(a.1).total_cmp(&eye.view.depth(b.1)));
        for (index, point) in points {
            let (x, y) = eye.pixel(point);
            let chosen = show.selected == Some(at) && show.point == Some(index);
            let r = if chosen { radius.max(RADII[1] + 2) } else { radius };
            if !inside((x, y), r) {
                continue;
            }
            let fill = if chosen { Color::Red } else { Color::Blue };
            screen.disc(x, y, r, fill, Color::White);
            match item {
                Item::Curve(_) if numbers => number(screen, (x, y), index[0]),
                Item::Patch(_) if chosen => {
                    let text = format!("{},{}", index[0], index[1]);
                    text_inside(screen, area, (x + r + 4, y - 3), &text, Color::White);
                }
                _ => {}
            }
        }
    }
}

fn number(screen: &mut Screen, (x, y): (i32, i32), number: usize) {
    screen.text(if number <= 9 { x - 3 } else { x - 7 }, y - 3, &number.to_string(), Color::White);
}

impl Canvas<'_> {
    fn vertex(&self, point: Point<3>, lift: f32) -> Vertex {
        let Vertex { x, y, depth } = self.eye.vertex(point);
        Vertex { x: x - self.corner.0, y: y - self.corner.1, depth: depth + lift }
    }

    /// A line of some width: parallel lines, above and below each other or side by side.
    fn line(&mut self, a: Vertex, b: Vertex, color: u8, width: u8) {
        let flat = (a.x - b.x).abs() >= (a.y - b.y).abs();
        let width = i32::from(width.max(1));
        for by in -(width - 1) / 2..=width / 2 {
            let moved = |v: Vertex| match flat {
                true => Vertex { y: v.y + by, ..v },
                false => Vertex { x: v.x + by, ..v },
            };
            self.buffer.line(moved(a), moved(b), color);
        }
    }

    fn polyline(&mut self, points: &[Point<3>], color: u8, width: u8, lift: f32) {
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|point| self.vertex(point, lift));
            self.line(a, b, color, width);
        }
    }

    fn needle(&mut self, from: Point<3>, vector: Point<3>, scale: f64, color: u8) {
        let to: Point<3> = std::array::from_fn(|d| from[d] + scale * vector[d]);
        if to.iter().all(|x| x.is_finite()) {
            self.polyline(&[from, to], color, 1, BEFORE);
        }
    }

    fn axes(&mut self) {
        for (_, end) in axis_ends(self.eye) {
            self.polyline(&[[0.0; 3], end], Color::LightGray as u8, 1, 0.0);
        }
    }

    fn polygon(&mut self, item: &Item) {
        let color = self.scene.settings.polygon;
        match item {
            Item::Curve(curve) => self.polyline(&curve.points, color, 1, FRONT),
            Item::Patch(patch) => {
                patch.net.iter().for_each(|row| self.polyline(row, color, 1, FRONT));
                let columns = patch.net.first().map_or(0, Vec::len);
                for l in 0..columns {
                    let column: Vec<Point<3>> =
                        patch.net.iter().filter_map(|row| row.get(l)).copied().collect();
                    self.polyline(&column, color, 1, FRONT);
                }
            }
        }
    }

    /// First and second derivatives by the parameter of the space.
    fn curve_needles(&mut self, arc: &crate::design::ec::EcArc, style: &CurveStyle) {
        if !style.first && !style.second {
            return;
        }
        let steps = self.scene.settings.points.min(NEEDLES);
        let length = arc.basis().length();
        for k in 0..=steps {
            let Some([point, first, second]) = arc.at(0, k as f64 / steps as f64) else { continue };
            if style.second {
                let vector = second.map(|x| x / (length * length));
                self.needle(point, vector, style.scale, style.second_colour);
            }
            if style.first {
                self.needle(point, first.map(|x| x / length), style.scale, style.first_colour);
            }
        }
    }

    fn patch(
        &mut self,
        weave: &EcWeave,
        grid: &Grid,
        style: &PatchStyle,
        width: u8,
        show: Show,
        bounds: Option<BoundingBox<3>>,
    ) {
        let fill = show.fill.unwrap_or(style.fill);
        let lines = |it: &mut Self, [rows, columns]: [usize; 2], lift: f32| {
            for (direction, count) in [(0, rows), (1, columns)] {
                it.isolines(weave, direction, count, style.line_colour, width, lift);
            }
        };
        match fill {
            Fill::Wires => self.mesh(grid, style.line_colour, width),
            Fill::Hidden => {
                let ground = self.scene.settings.ground;
                self.cells(grid, |_, _| (ground, Some(style.line_colour)));
            }
            Fill::Shaded => {
                let toward = self.light();
                self.cells(grid, |corners, _| (shade(style.material, brightness(corners, toward)), None));
                lines(self, style.isolines, BEFORE);
            }
            Fill::Zebra | Fill::Gaussian | Fill::Mean | Fill::Height => {
                let (stripes, toward) = (Zebra::new(), self.eye.view.toward());
                let size = bounds.map_or(1.0, |bounds| bounds.extent());
                let [low, high] = bounds.map_or([0.0, 1.0], |it| [it.min[2], it.max[2]]);
                self.cells(grid, |corners, uv| {
                    let color = match fill {
                        Fill::Zebra => stripes.color(weave.normal([0, 0], uv), toward),
                        Fill::Gaussian => {
                            let curvature = weave.gaussian_curvature([0, 0], uv);
                            tint::curvature(curvature.map(|it| it * size * size))
                        }
                        Fill::Mean => {
                            let at = weave.at([0, 0], uv);
                            tint::curvature(at.and_then(|at| at.mean_curvature()).map(|it| it * size))
                        }
                        _ => {
                            let middle = corners.iter().map(|p| p[2]).sum::<f64>() / 4.0;
                            tint::height((middle - low) / (high - low))
                        }
                    };
                    (color as u8, None)
                });
            }
        }
        if style.normals {
            self.normals(weave, style, bounds);
        }
        if let Some((axis, offset)) = show.section {
            let mut normal = [0.0; 3];
            normal[axis.min(2)] = 1.0;
            let lines = section(weave, Plane { normal, offset }, 20).unwrap_or_default();
            for line in lines {
                self.polyline(&line, Color::LightRed as u8, 2, BEFORE);
            }
        }
    }

    fn light(&self) -> Point<3> {
        match self.scene.settings.light {
            Light::Eye => self.eye.view.toward(),
            // From the upper left before the picture.
            Light::UpperLeft => {
                let aside = self.eye.view.moved([0.0; 3], [-0.6, 0.6]);
                let toward = self.eye.view.toward();
                let sum: Point<3> = std::array::from_fn(|d| aside[d] + toward[d]);
                let length = norm(sum);
                sum.map(|x| x / length)
            }
        }
    }

    fn mesh(&mut self, grid: &Grid, color: u8, width: u8) {
        for row in grid.points().chunks(grid.columns().max(1)) {
            self.polyline(row, color, width, 0.0);
        }
        for l in 0..grid.columns() {
            let column: Vec<Point<3>> =
                grid.points().iter().skip(l).step_by(grid.columns()).copied().collect();
            self.polyline(&column, color, width, 0.0);
        }
    }

    /// Fills the cells of a grid; colours are told by the corners and the middle of the parameters.
    fn cells(&mut self, grid: &Grid, ink: impl Fn([Point<3>; 4], [f64; 2]) -> (u8, Option<u8>)) {
        let vertices: Vec<Vertex> = grid.points().iter().map(|&point| self.vertex(point, 0.0)).collect();
        let columns = grid.columns().saturating_sub(1).max(1);
        let rows = grid.rows().saturating_sub(1).max(1);
        for (number, cell) in grid.cells().enumerate() {
            let uv = [(number / columns) as f64 + 0.5, (number % columns) as f64 + 0.5];
            let uv = [uv[0] / rows as f64, uv[1] / columns as f64];
            // The indices come from the grid.
            let points = cell.map(|at| grid.points().get(at).copied().unwrap_or_default());
            let (fill, edge) = ink(points, uv);
            self.buffer.cell(&cell.map(|at| vertices.get(at).copied().unwrap_or_default()), fill, edge);
        }
    }

    /// Lines of constant parameter of a direction, the borders among them.
    fn isolines(&mut self, weave: &EcWeave, direction: usize, count: usize, color: u8, width: u8, lift: f32) {
        let steps = self.scene.settings.mesh;
        let last = count.saturating_sub(1).max(1) as f64;
        // The lines are rows or columns of a mesh that is as fine along them as the patch is.
        let mesh = match direction {
            0 => weave.mesh([last as usize, steps[1]]),
            _ => weave.mesh([steps[0], last as usize]),
        };
        for k in 0..count {
            let line: Vec<Point<3>> = match direction {
                0 => mesh.points().iter().skip(k * mesh.columns()).take(mesh.columns()).copied().collect(),
                _ => mesh.points().iter().skip(k).step_by(mesh.columns().max(1)).copied().collect(),
            };
            self.polyline(&line, color, width, lift);
        }
    }

    fn normals(&mut self, weave: &EcWeave, style: &PatchStyle, bounds: Option<BoundingBox<3>>) {
        let size = bounds.map_or(1.0, |bounds| bounds.extent());
        let steps = self.scene.settings.mesh.map(|steps| steps.min(7));
        for k in 0..=steps[0] {
            for l in 0..=steps[1] {
                let uv = [k as f64 / steps[0] as f64, l as f64 / steps[1] as f64];
                if let (Some(point), Some(normal)) = (weave.eval([0, 0], uv), weave.normal([0, 0], uv)) {
                    self.needle(point, normal, style.scale * size / 4.0, style.normal_colour);
                }
            }
        }
    }
}

/// How bright a cell is on both of its sides: the cosine between its normal and the light.
fn brightness([a, b, c, d]: [Point<3>; 4], toward: Point<3>) -> f64 {
    let leg = |from: Point<3>, to: Point<3>| -> Point<3> { std::array::from_fn(|k| to[k] - from[k]) };
    let normal = cross(leg(a, c), leg(b, d));
    let length = norm(normal);
    if length > 0.0 { (dot(normal, toward) / length).abs() } else { 0.5 }
}

/// Whether a pixel lies on an item as it is seen, and how near that is.
pub(super) fn hit(shape: &Shape, eye: Eye, (x, y): (i32, i32)) -> Option<f32> {
    match shape {
        Shape::Curve { line, .. } => {
            let vertices: Vec<Vertex> = line.iter().map(|&point| eye.vertex(point)).collect();
            let near = vertices.windows(2).filter(|pair| distance(pair[0], pair[1], (x, y)) <= CLOSE);
            // A thin line is chosen before what lies behind it.
            near.map(|pair| pair[0].depth.max(pair[1].depth) + FRONT).reduce(f32::max)
        }
        Shape::Patch { grid, .. } => {
            let vertices: Vec<Vertex> = grid.points().iter().map(|&point| eye.vertex(point)).collect();
            let cells = grid.cells().map(|cell| cell.map(|at| vertices.get(at).copied().unwrap_or_default()));
            let over = cells.filter(|&[a, b, c, d]| covers([a, b, c], (x, y)) || covers([a, c, d], (x, y)));
            over.map(|cell| cell.iter().map(|v| v.depth).fold(f32::MIN, f32::max)).reduce(f32::max)
        }
        Shape::None => None,
    }
}

/// How near the mouse has to be to a curve.
const CLOSE: f64 = 5.0;

/// The distance of a pixel from a segment.
fn distance(a: Vertex, b: Vertex, (x, y): (i32, i32)) -> f64 {
    let [ax, ay, bx, by, x, y] = [a.x, a.y, b.x, b.y, x, y].map(f64::from);
    let (dx, dy) = (bx - ax, by - ay);
    let square = dx * dx + dy * dy;
    let t = if square > 0.0 { (((x - ax) * dx + (y - ay) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (x - ax - t * dx).hypot(y - ay - t * dy)
}

fn covers(corners: [Vertex; 3], (x, y): (i32, i32)) -> bool {
    let [a, b, c] = corners.map(|v| (i64::from(v.x), i64::from(v.y)));
    let p = (i64::from(x), i64::from(y));
    let side = |a: (i64, i64), b: (i64, i64)| (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0);
    let sides = [side(a, b), side(b, c), side(c, a)];
    sides.iter().all(|&s| s >= 0) || sides.iter().all(|&s| s <= 0)
}

/// The whole screen, for the picture alone.
pub(super) const WHOLE: Area = Area::new(0, 0, 639, 479);

/// The place of the parameter on a curve that is nearest to a pixel, and how far that is.
pub(super) fn nearest_parameter(line: &[Point<3>], eye: Eye, at: (i32, i32)) -> Option<f64> {
    let vertices: Vec<Vertex> = line.iter().map(|&point| eye.vertex(point)).collect();
    let count = vertices.len().saturating_sub(1).max(1) as f64;
    let away = |v: &Vertex| f64::from(v.x - at.0).hypot(f64::from(v.y - at.1));
    let nearest = vertices.iter().enumerate().min_by(|a, b| away(a.1).total_cmp(&away(b.1)));
    nearest.map(|(k, _)| k as f64 / count)
}

/// Whether the mouse is in the field.
pub(super) fn in_field((x, y): (i32, i32)) -> bool {
    FIELD.holds(x, y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_of_a_material_is_a_mixture_of_neighbouring_tones() {
        for material in Material::ALL {
            let tones = tones(material);
            for level in 0..=LEVELS {
                let code = shade(material, f64::from(level) / f64::from(LEVELS));
                let cell: Vec<Color> = (0..16).map(|k| dithered(code, k % 4, k / 4)).collect();
                let tone = usize::from(level / BETWEEN);
                assert!(cell.iter().all(|color| *color == tones[tone] || *color == tones[(tone + 1).min(3)]));
                if level % BETWEEN == 0 {
                    assert!(cell.iter().all(|color| *color == tones[tone]));
                }
            }
        }
        assert_eq!(dithered(Color::Yellow as u8, 3, 5), Color::Yellow);
        assert!(u16::from(SHADES) + Material::ALL.len() as u16 * u16::from(LEVELS + 1) <= 256);
    }
}
