//! Hidden surfaces by the depth of every pixel: cells of a surface, flat faces and lines in any order,
//! of which the picture keeps what is nearest to the viewer. So it is right from every side, also where
//! a surface folds over itself or cuts through itself, which the order of far to near that the book
//! paints cells in (chapter 3, unit RAJZ_F3D) cannot do.
//!
//! A cell is two triangles with their boundary pixels, and its outline over them: the pixels of thin
//! lines. An outline belongs to its cell: where a cell's own fill is nearest its outline shows, however
//! steep the cell is, and a pixel counts as near as the nearer of both. Neighbours share whole sides,
//! with the same pixels from both, so that neither covers the other's outline and no depth needs a bias.
//!
//! Where depths are exactly equal, outlines go before fills, then the larger colour before the smaller.
//! So every pixel is the greatest of what the cells are there, and the order of drawing does not matter
//! at all. Colours are numbers; what they look like, and the projection, are the caller's.

mod pixel;

use super::walk::Walk;
pub use pixel::Pixel;
use pixel::{Ink, OWNER};

/// The largest width and height of a depth buffer in pixels.
pub const MAX_SIDE: usize = 4096;

/// Coordinates beyond are taken as this: products of two differences fit 64 bits with room.
const FAR_AWAY: i32 = 1 << 24;

/// Depths beyond are taken as this, so that interpolation overflows nowhere.
const DEEP: f32 = 1e20;

/// Rows of a triangle wider than this are narrowed by divisions before they are scanned.
const WIDE: i64 = 16;

/// Cells at most this many columns and rows larger than a pixel are first looked at whether all of them
/// is hidden.
const SMALL: i64 = 32;

/// A corner in the picture: the pixel it falls on, and its depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// Pixels from the left edge of the picture to the right.
    pub x: i32,
    /// Pixels from the upper edge of the picture down.
    pub y: i32,
    /// How near to the viewer, larger is nearer, in any unit that grows linearly along straight lines
    /// of the picture (as [`super::View::depth`] does).
    pub depth: f32,
}

impl Vertex {
    /// The vertex within the limits of coordinates and depths.
    #[inline]
    fn limited(self) -> Vertex {
        Vertex {
            x: self.x.clamp(-FAR_AWAY, FAR_AWAY),
            y: self.y.clamp(-FAR_AWAY, FAR_AWAY),
            depth: self.depth.clamp(-DEEP, DEEP),
        }
    }
}

/// A picture that knows how near every pixel is.
///
/// ```
/// use grafika::geometry::{DepthBuffer, Vertex};
///
/// let at = |x, y, depth| Vertex { x, y, depth };
/// let mut buffer = DepthBuffer::new(12, 8);
/// let square = |depth| [at(1, 1, depth), at(5, 1, depth), at(5, 5, depth), at(1, 5, depth)];
/// buffer.cell(&square(2.0), 0, Some(15));
/// buffer.cell(&square(1.0), 4, Some(4));
/// assert_eq!(buffer.pixel(3, 3), Some(0));
/// assert_eq!(buffer.pixel(5, 3), Some(15));
/// assert_eq!(buffer.pixel(6, 3), None);
/// ```
#[derive(Clone, Debug)]
pub struct DepthBuffer {
    width: i64,
    height: i64,
    pixels: Vec<Pixel>,
    /// The number of the last cell drawn.
    owner: u64,
}

impl DepthBuffer {
    /// An empty buffer of some width and height in pixels, each at most [`MAX_SIDE`]: what is larger is
    /// cut to it.
    #[must_use]
    pub fn new(width: usize, height: usize) -> DepthBuffer {
        let (width, height) = (width.min(MAX_SIDE), height.min(MAX_SIDE));
        let pixels = vec![Pixel::default(); width * height];
        DepthBuffer { width: width as i64, height: height as i64, pixels, owner: 0 }
    }

    /// The width in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width as usize
    }

    /// The height in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height as usize
    }

    /// Forgets all that is drawn.
    pub fn clear(&mut self) {
        self.pixels.fill(Pixel::default());
        self.owner = 0;
    }

    /// Draws a cell of a surface: four corners in their order around it, filled, and outlined if an edge
    /// colour is given. It is two triangles, parted by the diagonal from the first corner to the third
    /// unless only the other one lies inside of it as it is seen. Of a cell that is seen as a line or a
    /// point only the outline is drawn; nothing of a cell with a depth that is no finite number. Where two
    /// sides of a twisted cell are seen to cross, its triangles reach beyond the outline.
    pub fn cell(&mut self, corners: &[Vertex; 4], fill: u8, edge: Option<u8>) {
        if !finite(corners) {
            return;
        }
        let corners = corners.map(Vertex::limited);
        let Some((window, owner)) = self.begin(&corners, edge) else { return };
        if !window.is_empty() {
            let ink = Ink::fill(fill, owner);
            halves(corners).into_iter().for_each(|half| self.triangle(half, &window, ink));
        }
        if let Some(edge) = edge {
            self.around(&corners, Ink::outline(edge, owner));
        }
    }

    /// Draws a flat convex face: its corners in their order around it, filled, and outlined if an edge
    /// colour is given. Of fewer than three corners only the outline is drawn; nothing of a face with a
    /// depth that is no finite number.
    pub fn polygon(&mut self, corners: &[Vertex], fill: u8, edge: Option<u8>) {
        if !finite(corners) {
            return;
        }
        let corners: Vec<Vertex> = corners.iter().map(|corner| corner.limited()).collect();
        let Some((&first, others)) = corners.split_first() else { return };
        let Some((window, owner)) = self.begin(&corners, edge) else { return };
        for pair in others.windows(2) {
            let &[b, c] = pair else { continue };
            self.triangle([first, b, c], &window, Ink::fill(fill, owner));
        }
        if let Some(edge) = edge {
            self.around(&corners, Ink::outline(edge, owner));
        }
    }

    /// Draws a line one pixel wide where nothing nearer is, itself before a fill as near. Its pixels are
    /// those of the outlines: stepped from the left end, of an upright line from the upper end, whichever
    /// end is given first. Nothing is drawn if a depth is no finite number.
    pub fn line(&mut self, from: Vertex, to: Vertex, color: u8) {
        let ends = [from, to];
        if !finite(&ends) {
            return;
        }
        let ends = ends.map(Vertex::limited);
        if let Some((_, owner)) = self.begin(&ends, Some(color)) {
            self.around(&ends, Ink::outline(color, owner));
        }
    }

    /// The colour at a pixel; `None` where nothing is drawn, and outside.
    #[must_use]
    pub fn pixel(&self, x: i32, y: i32) -> Option<u8> {
        let (x, y) = (i64::from(x), i64::from(y));
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        let at = inside.then_some((y * self.width + x) as usize)?;
        self.pixels.get(at)?.color()
    }

    /// The rows from the upper one down, each with its `y` and its pixels from the left to the right:
    /// the way to copy the picture to a screen, with [`Pixel::color`] telling what is drawn.
    pub fn rows(&self) -> impl Iterator<Item = (usize, &[Pixel])> {
        self.pixels.chunks_exact(self.width().max(1)).enumerate()
    }

    /// Begins a cell: where its fill may show, and its number; `None` if nothing of it can be seen.
    #[inline]
    fn begin(&mut self, corners: &[Vertex], edge: Option<u8>) -> Option<(Extent, u64)> {
        let extent = Extent::of(corners);
        let nearest = corners.iter().map(|corner| corner.depth).fold(-DEEP, f32::max);
        if self.hides(&extent, nearest) {
            return None;
        }
        Some((self.window(&extent, edge), self.next_owner()))
    }

    /// Whether nothing of a cell can be seen: it is outside, or it is small and all there is nearer.
    #[inline]
    fn hides(&self, extent: &Extent, nearest: f32) -> bool {
        let [left, top, right, bottom] =
            [extent.left, extent.top, extent.right, extent.bottom].map(i64::from);
        if right < 0 || bottom < 0 || left >= self.width || top >= self.height {
            return true;
        }
        let whole = left >= 0 && top >= 0 && right < self.width && bottom < self.height;
        if !whole || right - left > SMALL || bottom - top > SMALL {
            return false;
        }
        let limit = Ink::fill(0, 0).at(nearest).least_nearer();
        (top..=bottom).all(|y| {
            // Inside of the picture, so not negative.
            let (first, last) = (y * self.width + left, y * self.width + right);
            let row = self.pixels.get(first as usize..=last as usize).unwrap_or_default();
            row.iter().all(|pixel| *pixel >= limit)
        })
    }

    /// The pixels that a cell's fill may show at: without the outermost of a cell with an outline, which
    /// belong to that.
    #[inline]
    fn window(&self, extent: &Extent, edge: Option<u8>) -> Extent {
        let margin = i32::from(edge.is_some());
        Extent {
            left: (extent.left + margin).max(0),
            top: (extent.top + margin).max(0),
            right: (extent.right - margin).min(self.width as i32 - 1),
            bottom: (extent.bottom - margin).min(self.height as i32 - 1),
        }
    }

    /// A new number for a cell.
    #[inline]
    fn next_owner(&mut self) -> u64 {
        if self.owner == OWNER {
            self.pixels.iter_mut().for_each(|pixel| *pixel = pixel.disowned());
            self.owner = 0;
        }
        self.owner += 1;
        self.owner
    }

    /// Fills a triangle, its boundary pixels included, within a window of the picture; nothing if it is
    /// seen as a line.
    #[inline]
    fn triangle(&mut self, [a, b, c]: [Vertex; 3], window: &Extent, ink: Ink) {
        let area = turn(a, b, c);
        let (b, c) = if area < 0 { (c, b) } else { (b, c) };
        let own = Extent::of(&[a, b, c]).common(window);
        if area == 0 || own.is_empty() {
            return;
        }
        let [left, top, right, bottom] = [own.left, own.top, own.right, own.bottom].map(i64::from);
        // The weights of the corners, times the area: whole numbers, none negative inside.
        let sides = [Side::new(b, c), Side::new(c, a), Side::new(a, b)];
        let mut starts = sides.each_ref().map(|side| side.weight(left, top));
        let (across, down) =
            (sides.each_ref().map(|side| side.across), sides.each_ref().map(|side| side.down));
        let scale = 1.0 / area.abs() as f32;
        let (to_b, to_c) = ((b.depth - a.depth) * scale, (c.depth - a.depth) * scale);
        let low = a.depth.min(b.depth).min(c.depth);
        let high = a.depth.max(b.depth).max(c.depth);
        for y in top..=bottom {
            let steps = 0..right - left + 1;
            let steps = if right - left < WIDE { steps } else { narrowed(steps, &sides, starts) };
            let mut weights = starts;
            add(&mut weights, [across[0] * steps.start, across[1] * steps.start, across[2] * steps.start]);
            // Clipped to the picture, so not negative.
            let at = (y * self.width + left) as usize;
            let range = at + steps.start as usize..at + steps.end.max(steps.start) as usize;
            for pixel in self.pixels.get_mut(range).unwrap_or_default() {
                if (weights[0] | weights[1] | weights[2]) >= 0 {
                    let depth = a.depth + (weights[1] as f32 * to_b + weights[2] as f32 * to_c);
                    let (new, old) = (ink.at(depth.max(low).min(high)), *pixel);
                    let shown = new.max(old);
                    // Where it is as near as what is there, the own outline may go before that.
                    *pixel = if new.is_as_near_as(old) { shown.owned_as(new) } else { shown };
                }
                add(&mut weights, across);
            }
            add(&mut starts, down);
        }
    }

    /// Draws an outline: the corners and what is between them. A line is one around two corners.
    #[inline]
    fn around(&mut self, corners: &[Vertex], ink: Ink) {
        corners.iter().for_each(|&corner| self.point(corner, ink));
        let Some(&last) = corners.last() else { return };
        let mut from = last;
        for &to in corners {
            self.side(from, to, ink);
            from = to;
        }
    }

    /// Draws a side of an outline between its ends: stepped from the left end or, where it is upright,
    /// from the upper one, so that both neighbours of a side have the same pixels and depths of it.
    #[inline]
    fn side(&mut self, a: Vertex, b: Vertex, ink: Ink) {
        let (from, to) = if (b.x, b.y) < (a.x, a.y) { (b, a) } else { (a, b) };
        let walk = Walk::new([from.x, from.y], [to.x, to.y], [self.width, self.height]);
        if walk.length() <= 1 {
            return;
        }
        let slope = (to.depth - from.depth) / walk.length() as f32;
        let (low, high) = (from.depth.min(to.depth), from.depth.max(to.depth));
        walk.visit(|step, at| {
            self.outline(at, (from.depth + step as f32 * slope).max(low).min(high), ink);
        });
    }

    /// Draws a pixel of an outline, if it is inside of the picture.
    #[inline]
    fn point(&mut self, vertex: Vertex, ink: Ink) {
        let (x, y) = (i64::from(vertex.x), i64::from(vertex.y));
        if (0..self.width).contains(&x) && (0..self.height).contains(&y) {
            self.outline((y * self.width + x) as usize, vertex.depth, ink);
        }
    }

    /// Draws a pixel of an outline where it is nearest or the cell's own fill is.
    #[inline]
    fn outline(&mut self, at: usize, depth: f32, ink: Ink) {
        if let Some(pixel) = self.pixels.get_mut(at) {
            let old = if pixel.is_of(ink) { pixel.inked(ink).max(*pixel) } else { *pixel };
            *pixel = ink.at(depth).max(old);
        }
    }
}

/// Buckets that depths are sorted into.
const BUCKETS: usize = 4096;

/// The order in which cells of these greatest depths are drawn quickest: the nearest first, up to a 4096th of the way
/// between nearest and farthest, so that most of what is hidden is left out at once. The picture is the same in any order.
///
/// ```
/// assert_eq!(grafika::geometry::near_first(&[1.0, 3.0, f32::NAN, 2.0]), [1, 3, 0, 2]);
/// ```
#[must_use]
pub fn near_first(depths: &[f32]) -> Vec<u32> {
    let limits = |(low, high): (f32, f32), depth: &f32| (low.min(*depth), high.max(*depth));
    let (low, high) = depths.iter().fold((f32::INFINITY, f32::NEG_INFINITY), limits);
    let scale = (BUCKETS - 1) as f32 / (high - low).max(f32::MIN_POSITIVE);
    // The cast makes 0 of NaN, and limits are those of the buckets: such cells are the last.
    let bucket = |depth: f32| BUCKETS - 1 - (((depth - low) * scale) as usize).min(BUCKETS - 1);
    let mut starts = vec![0_u32; BUCKETS + 1];
    for &depth in depths {
        starts[bucket(depth) + 1] += 1;
    }
    for k in 1..starts.len() {
        starts[k] += starts[k - 1];
    }
    let mut order = vec![0; depths.len()];
    for (number, &depth) in (0..).zip(depths) {
        let at = &mut starts[bucket(depth)];
        order[*at as usize] = number;
        *at += 1;
    }
    order
}

/// A side of a triangle as a function of the pixel: the area that it spans with it (twice), positive
/// to the inner side.
struct Side {
    /// What one pixel to the right and one down add.
    across: i64,
    down: i64,
    /// A corner on it.
    x: i64,
    y: i64,
}

impl Side {
    #[inline]
    fn new(from: Vertex, to: Vertex) -> Side {
        let (across, down) = (i64::from(from.y - to.y), i64::from(to.x - from.x));
        Side { across, down, x: i64::from(from.x), y: i64::from(from.y) }
    }

    #[inline]
    fn weight(&self, x: i64, y: i64) -> i64 {
        self.across * (x - self.x) + self.down * (y - self.y)
    }
}

/// The steps to the right at which no weight is negative, of a row where the weights start so.
fn narrowed(steps: std::ops::Range<i64>, sides: &[Side; 3], starts: [i64; 3]) -> std::ops::Range<i64> {
    let (mut first, mut end) = (steps.start, steps.end);
    for (side, start) in sides.iter().zip(starts) {
        match side.across {
            0 if start < 0 => end = first,
            0 => {}
            across if across > 0 => first = first.max(-start.div_euclid(across)),
            across => end = end.min(start.div_euclid(-across) + 1),
        }
    }
    // An empty row stays where the triangle is.
    first.min(steps.end)..end.max(first.min(steps.end))
}

/// Adds to the weights of a triangle's corners. Written out, for it is done at every pixel.
#[inline(always)]
fn add(weights: &mut [i64; 3], step: [i64; 3]) {
    weights[0] += step[0];
    weights[1] += step[1];
    weights[2] += step[2];
}

/// Whether all depths are finite numbers.
#[inline]
fn finite(corners: &[Vertex]) -> bool {
    corners.iter().all(|corner| corner.depth.is_finite())
}

/// Twice the area of a triangle of the picture; its sign tells the direction around it.
#[inline]
fn turn(a: Vertex, b: Vertex, c: Vertex) -> i64 {
    i64::from(b.x - a.x) * i64::from(c.y - a.y) - i64::from(b.y - a.y) * i64::from(c.x - a.x)
}

/// The two triangles of a cell.
#[inline]
fn halves([a, b, c, d]: [Vertex; 4]) -> [[Vertex; 3]; 2] {
    let folded = |one: i64, other: i64| (one < 0 && other > 0) || (one > 0 && other < 0);
    let other_diagonal = folded(turn(a, b, c), turn(a, c, d)) && !folded(turn(b, c, d), turn(b, d, a));
    if other_diagonal { [[b, c, d], [b, d, a]] } else { [[a, b, c], [a, c, d]] }
}

/// Columns and rows of the picture, the last ones included.
struct Extent {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

impl Extent {
    #[inline]
    fn of(corners: &[Vertex]) -> Extent {
        let nothing = Extent { left: i32::MAX, top: i32::MAX, right: i32::MIN, bottom: i32::MIN };
        corners.iter().fold(nothing, |extent, corner| Extent {
            left: extent.left.min(corner.x),
            top: extent.top.min(corner.y),
            right: extent.right.max(corner.x),
            bottom: extent.bottom.max(corner.y),
        })
    }

    #[inline]
    fn common(&self, other: &Extent) -> Extent {
        Extent {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    #[inline]
    fn is_empty(&self) -> bool {
        self.left > self.right || self.top > self.bottom
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers of cells begin anew without a cell being taken for another one.
    #[test]
    fn cells_are_told_apart_after_the_last_number() {
        let square = |size: i32, depth: f32| {
            [(0, 0), (size, 0), (size, size), (0, size)].map(|(x, y)| Vertex { x, y, depth })
        };
        let mut buffer = DepthBuffer::new(5, 5);
        buffer.cell(&square(4, 2.0), 1, Some(2));
        buffer.owner = OWNER;
        // Reaching out of the picture, it is not left out as hidden, and is the first cell's namesake.
        buffer.cell(&square(9, 1.0), 3, Some(4));
        assert_eq!(buffer.owner, 1);
        assert_eq!([buffer.pixel(0, 0), buffer.pixel(2, 2)], [Some(2), Some(1)]);
        buffer.cell(&square(4, 3.0), 5, Some(6));
        assert_eq!([buffer.pixel(0, 0), buffer.pixel(2, 2)], [Some(6), Some(5)]);
    }
}
