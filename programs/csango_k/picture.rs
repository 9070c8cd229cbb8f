//! The table and the pieces on it, with what is nearest to the viewer at every pixel.

use super::eye::{EDGE, Eye, centre};
use super::panel::FIELD;
use super::texts;
use crate::file::cube::{CsangoCube, CubePiece, shape};
use crate::geometry::painter::{Backs, Painting};
use crate::geometry::{DepthBuffer, Vertex};
use crate::machine::Language;
use crate::puzzle::cube::{CORNER, PIECES};
use crate::screen::{Color, HEIGHT, Screen, Stroke, WIDTH};
use crate::ui::painter::Steps;

/// The visible pieces: piece `k`, from 1, in colour `k`.
pub(crate) struct Scene(DepthBuffer);

impl Scene {
    pub(crate) fn new(cube: &CsangoCube, eye: Eye, goal: Goal) -> Scene {
        let mut buffer = ground(eye, goal);
        for face in faces(cube, eye).iter().filter(|face| face.is_seen()) {
            buffer.polygon(&face.outline, face.color, Some(Color::Black.index()));
        }
        Scene(buffer)
    }

    /// The pieces as a painter leaves them who has got so far; the last face is marked.
    pub(crate) fn painted(cube: &CsangoCube, eye: Eye, goal: Goal, steps: &Steps) -> Scene {
        let Some(painted) = steps.painted() else { return Scene::new(cube, eye, goal) };
        let mut buffer = ground(eye, goal);
        let faces = faces(cube, eye);
        // What is painted later is nearer than anything before.
        let above = |corners: &[Vertex], order: usize| -> Vec<Vertex> {
            corners.iter().map(|corner| Vertex { depth: ABOVE + order as f32, ..*corner }).collect()
        };
        for (order, step) in painted.iter().enumerate() {
            let Some(face) = faces.get(step.face) else { continue };
            buffer.polygon(&above(&face.outline, order), face.color, Some(Color::Black.index()));
        }
        if let Some((step, face)) = steps.last().and_then(|step| Some((step, faces.get(step.face)?))) {
            let ink = 16 + if step.spoils > 0 { Color::LightRed } else { Color::Yellow }.index();
            let outline = above(&face.outline, painted.len());
            for (&from, &to) in outline.iter().zip(outline.iter().cycle().skip(1)) {
                for (dx, dy) in [(0, 0), (1, 0), (0, 1)] {
                    let [from, to] =
                        [from, to].map(|vertex| Vertex { x: vertex.x + dx, y: vertex.y + dy, ..vertex });
                    buffer.line(from, to, ink);
                }
            }
        }
        Scene(buffer)
    }

    /// The visible piece at a pixel of the screen, from 0.
    pub(crate) fn piece_at(&self, x: i32, y: i32) -> Option<usize> {
        let color = self.0.pixel(x - FIELD.x1, y - FIELD.y1)?;
        usize::from(color).checked_sub(1).filter(|&piece| piece < PIECES)
    }

    pub(crate) fn draw(&self, screen: &mut Screen) {
        for (y, (_, row)) in (FIELD.y1..).zip(self.0.rows()) {
            screen.row(FIELD.x1, y, row.iter().map(|pixel| pixel.color().map(Color::from_index)));
        }
    }
}

/// A depth above everything on the table.
const ABOVE: f32 = 10_000.0;

/// The table without pieces.
fn ground(eye: Eye, goal: Goal) -> DepthBuffer {
    let size = |from: i32, to: i32| usize::try_from(to - from + 1).unwrap_or(0);
    let mut buffer = DepthBuffer::new(size(FIELD.x1, FIELD.x2), size(FIELD.y1, FIELD.y2));
    for k in -5..=5 {
        let (along, end) = (f64::from(k) * EDGE, 5.0 * EDGE);
        for [from, to] in [[[along, -end], [along, end]], [[-end, along], [end, along]]] {
            let [from, to] = [from, to].map(|[x, y]| in_field(eye.vertex([x, y, 0.0])));
            buffer.line(from, to, Color::Black.index());
        }
    }
    if goal == Goal::Marked {
        let [[x1, x2], [y1, y2]] =
            [CORNER[0], CORNER[1]].map(|low| [low - 5, low - 1].map(|it| f64::from(it) * EDGE));
        for [from, to] in
            [[[x1, y1], [x2, y1]], [[x2, y1], [x2, y2]], [[x2, y2], [x1, y2]], [[x1, y2], [x1, y1]]]
        {
            // A line of one pixel is easily lost among the others: it is drawn three times.
            for (dx, dy) in [(0, 0), (1, 0), (0, 1)] {
                let [from, to] = [from, to].map(|[x, y]| {
                    let vertex = in_field(eye.vertex([x, y, 0.0]));
                    Vertex { x: vertex.x + dx, y: vertex.y + dy, ..vertex }
                });
                buffer.line(from, to, MARK);
            }
        }
    }
    buffer
}

/// The order in which a painter paints the pieces.
pub(crate) fn painting(cube: &CsangoCube, eye: Eye) -> Painting {
    let corners: Vec<_> = faces(cube, eye).into_iter().map(|face| face.corners).collect();
    // Neither is negative.
    Painting::new(&corners, Backs::LeftOut, [WIDTH as usize, HEIGHT as usize])
}

/// Dots on the pixels that a painter has got wrong.
pub(crate) fn draw_wrong(screen: &mut Screen, steps: &Steps) {
    for &[x, y] in steps.wrong() {
        if (x + y) % 2 == 0 && FIELD.holds(x, y) {
            screen.bar(x, y, x, y, Color::LightRed);
        }
    }
}

/// Whether the place where the cube will stand is marked on the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Goal {
    Unmarked,
    Marked,
}

/// The colour of that mark: light red by a number that is no piece's.
const MARK: u8 = 16 + Color::LightRed.index();

/// A finished cube in the corner of the field, small.
pub(crate) fn draw_goal(screen: &mut Screen, language: Language) {
    let (x, y, edge) = (405, 84, 6);
    let place = |[u, v, w]: [i32; 3]| (x + edge * (v - u), y + edge * (u + v) / 2 - edge * w);
    let thin = Stroke::thin(Color::Black);
    type Face = fn(i32, i32) -> [i32; 3];
    let faces: [(Face, [u8; 4]); 3] = [
        (|a, b| [a, b, 4], [10, 9, 14, 13]),
        (|a, b| [4, a, b], [4, 12, 3, 2]),
        (|a, b| [a, 4, b], [5, 6, 1, 11]),
    ];
    for (face, colors) in faces {
        for (a, b) in (0..4).flat_map(|a| (0..4).map(move |b| (a, b))) {
            let corners = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| place(face(a, b)));
            // Some pattern of pieces.
            let color = colors[((a / 2 + 2 * (b / 2)) % 4) as usize];
            screen.polygon(&corners, Color::from_index(color), thin);
        }
    }
    screen.text(x - 16, y + 32, texts::GOAL.of(language), Color::Blue);
}

/// A corner in pixels of the field.
fn in_field(vertex: Vertex) -> Vertex {
    Vertex { x: vertex.x - FIELD.x1, y: vertex.y - FIELD.y1, ..vertex }
}

/// A face of a piece.
struct Face {
    /// The colour of the piece.
    color: u8,
    /// Its corners on the screen, anticlockwise from outside.
    corners: Vec<[f64; 3]>,
    /// The same in pixels of the field, from one that sees the whole face.
    outline: Vec<Vertex>,
}

impl Face {
    /// Whether its outer side is seen: anticlockwise from outside is clockwise where y goes down.
    fn is_seen(&self) -> bool {
        area(&self.corners) < 0.0
    }
}

/// The faces of all pieces.
fn faces(cube: &CsangoCube, eye: Eye) -> Vec<Face> {
    let pieces = cube.pieces.iter().enumerate();
    pieces.flat_map(|(index, piece)| faces_of(eye, index, *piece)).collect()
}

fn faces_of(eye: Eye, index: usize, piece: CubePiece) -> Vec<Face> {
    let Some(shape) = shape(index) else { return Vec::new() };
    let middle = centre(piece.cell);
    let place = |corner: &[i8; 3]| {
        let turned = piece.rotation.map(|row| {
            row.iter().zip(corner).map(|(&m, &v)| f64::from(m) * f64::from(v)).sum::<f64>() * EDGE / 2.0
        });
        [middle[0] + turned[0], middle[1] + turned[1], middle[2] + turned[2]]
    };
    let color = u8::try_from(index + 1).unwrap_or(0); // there are 14
    let face = |numbers: &&[u8]| {
        let corners: Vec<_> = numbers
            .iter()
            .filter_map(|&number| shape.corners.get(usize::from(number).checked_sub(1)?))
            .map(place)
            .collect();
        let mut outline: Vec<Vertex> = corners.iter().map(|&corner| in_field(eye.vertex(corner))).collect();
        let corners: Vec<[f64; 3]> = corners.into_iter().map(|corner| eye.image(corner)).collect();
        outline.rotate_left(hub(&corners));
        Face { color, corners, outline }
    };
    shape.faces.iter().map(face).collect()
}

/// Twice the signed area of a polygon of the picture.
fn area(pixels: &[[f64; 3]]) -> f64 {
    let next = pixels.iter().cycle().skip(1);
    pixels.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

/// A corner from which all of a face is seen: one where it is bent in, if there is any. Faces are of four
/// cells at most, and such a corner is on the edge of both of their bars.
fn hub(pixels: &[[f64; 3]]) -> usize {
    let count = pixels.len().max(1);
    let turn = |k: usize| {
        let at = |k: usize| pixels.get(k % count).copied().unwrap_or_default();
        let (a, b, c) = (at(k + count - 1), at(k), at(k + 1));
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    (0..count).find(|&k| turn(k) > 1e-6).unwrap_or(0)
}

/// The axes in the corner of the field.
pub(crate) fn draw_axes(screen: &mut Screen, eye: Eye) {
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mut tip = [0.0; 3];
        tip[axis] = 30.0;
        let (dx, dy) = eye.axis(tip);
        screen.line(470, 90, 470 + dx, 90 + dy, Stroke::thin(Color::Black));
        screen.text(470 + dx, 90 + dy, name, Color::Black);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::cube::Rules;

    /// The piece whose cell a ray meets first: the faces of every cell, one by one.
    fn first_met(cube: &CsangoCube, from: [f64; 3], to: [f64; 3]) -> Option<usize> {
        let mut nearest = (f64::MAX, None);
        for (index, piece) in cube.pieces.iter().enumerate() {
            for cell in piece.cells(index).map(centre) {
                let (mut enter, mut leave) = (f64::MIN, f64::MAX);
                for axis in 0..3 {
                    let way = to[axis] - from[axis];
                    let sides = [-0.5, 0.5].map(|side| (cell[axis] + side * EDGE - from[axis]) / way);
                    enter = enter.max(sides[0].min(sides[1]));
                    leave = leave.min(sides[0].max(sides[1]));
                }
                if enter < leave && enter < nearest.0 {
                    nearest = (enter, Some(index));
                }
            }
        }
        nearest.1
    }

    /// Rays from the viewer meet the same pieces that the picture shows, wherever the pieces are: away from
    /// edges by two pixels, where roundings and outlines are.
    #[test]
    fn what_is_nearest_is_seen() {
        let mut compared = 0;
        for seed in 0..12_u32 {
            let cube = CsangoCube::start().scrambled(u64::from(seed), 150 * seed, Rules::Book);
            let eye = (0..seed % 3).fold(Eye::HOME.turned(7 * seed as i32), |eye, _| eye.higher());
            let eye = (0..seed / 3 % 3).fold(eye, |eye, _| eye.next_sight());
            let scene = Scene::new(&cube, eye, Goal::Unmarked);
            let met = |x: i32, y: i32| {
                let (viewer, pixel) = eye.ray(f64::from(x), f64::from(y));
                first_met(&cube, viewer, pixel)
            };
            for (x, y) in (40..490).step_by(9).flat_map(|x| (60..450).step_by(7).map(move |y| (x, y))) {
                let right = met(x, y);
                let around = [(2, 0), (-2, 0), (0, 2), (0, -2), (2, 2), (-2, -2), (2, -2), (-2, 2)];
                if around.iter().all(|&(dx, dy)| met(x + dx, y + dy) == right) {
                    let outline = scene.0.pixel(x - FIELD.x1, y - FIELD.y1) == Some(0);
                    assert!(outline || scene.piece_at(x, y) == right, "seed {seed}: {x} {y}");
                    compared += usize::from(right.is_some() && !outline);
                }
            }
        }
        assert!(compared > 3000, "{compared}");
    }
}
