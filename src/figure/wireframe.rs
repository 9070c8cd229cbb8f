//! Hidden line removal: the visible lines of an opaque surface as vectors.
//!
//! Every edge of the grid is clipped against the triangles of the grid, without pixels, so that the lines can be
//! enlarged at will. The triangles are flat, so near the silhouette of a coarse grid visibility is that of the
//! triangles, not that of the curved surface.

use super::mesh::{FLATTEST, split};
use super::tree::{Place, Tree, along_squares};
use crate::geometry::{BoundingBox, Grid, Point, View};

/// A triangle hides an edge that is behind it by at least this depth, relative to the size of the picture.
const BEHIND: f64 = 1e-7;
/// Pieces shorter than this fraction of the picture are left out.
const SHORT: f64 = 1e-5;

/// The visible parts of the lines of grids, which hide each other, as polylines in the plane of the view. Of every grid
/// lines of constant `u` come first, then those of constant `v`; a closing line is not drawn twice.
///
/// ```
/// use grafika::figure::visible_lines;
/// use grafika::geometry::{Grid, View};
///
/// // A square seen from above: three lines in either direction.
/// let square = Grid::from_fn([3, 3], [false; 2], |k, l| [k as f64, l as f64, 0.0]);
/// let lines = visible_lines(&[square], &View::from_direction([0.0, -0.1, 1.0]));
/// assert_eq!(lines.iter().map(Vec::len).collect::<Vec<_>>(), [3; 6]);
/// ```
#[must_use]
pub fn visible_lines(grids: &[Grid], view: &View) -> Vec<Vec<Point<2>>> {
    let places: Vec<Point<2>> = grids.iter().flat_map(Grid::points).map(|&point| view.place(point)).collect();
    let Some(scene) = Scene::new(grids, view) else { return Vec::new() };
    let place = |index: usize| places.get(index).copied().unwrap_or([0.0; 2]);
    let mut lines = Vec::new();
    for line in numbered(grids).flat_map(|(first, grid)| grid_lines(grid, first)) {
        let (mut chain, mut joined) = (Vec::new(), false);
        for (&from, &to) in line.iter().zip(line.iter().skip(1)) {
            let (a, b) = (place(from), place(to));
            let pieces = scene.visible(from, to);
            for &[start, end] in &pieces {
                if start > 0.0 || !joined {
                    lines.push(std::mem::replace(&mut chain, vec![lerp(a, b, start)]));
                }
                chain.push(lerp(a, b, end));
                joined = end >= 1.0;
            }
            joined &= pieces.last().is_some_and(|piece| piece[1] >= 1.0);
        }
        lines.push(chain);
    }
    lines.retain(|line| line.len() > 1);
    lines
}

/// All lines of a grid, as polylines in the plane of the view: those of constant `u`, then those of constant `v`; a
/// closing line is not drawn twice.
#[must_use]
pub fn all_lines(grid: &Grid, view: &View) -> Vec<Vec<Point<2>>> {
    let place = |index: &usize| grid.points().get(*index).map(|&point| view.place(point));
    grid_lines(grid, 0).iter().map(|line| line.iter().filter_map(place).collect()).collect()
}

/// Grids with the number that their first point has among the points of all.
fn numbered(grids: &[Grid]) -> impl Iterator<Item = (usize, &Grid)> {
    grids.iter().scan(0, |next, grid| {
        let first = *next;
        *next += grid.points().len();
        Some((first, grid))
    })
}

/// The numbers of the points of every line of a grid whose first point has number `first`.
fn grid_lines(grid: &Grid, first: usize) -> Vec<Vec<usize>> {
    let [rows, columns] = [grid.rows(), grid.columns()];
    let [closed_u, closed_v] = grid.closed().map(usize::from);
    let along_v =
        (0..rows.saturating_sub(closed_u)).map(|k| (0..columns).map(|l| first + k * columns + l).collect());
    let along_u =
        (0..columns.saturating_sub(closed_v)).map(|l| (0..rows).map(|k| first + k * columns + l).collect());
    along_v.chain(along_u).collect()
}

/// The projected triangles of grids, coordinates from -1 to 1, with boxes around them.
struct Scene {
    places: Vec<Place>,
    triangles: Vec<[usize; 3]>,
    tree: Tree,
}

impl Scene {
    /// `None` for grids without extent.
    fn new(grids: &[Grid], view: &View) -> Option<Self> {
        let seen = |p: &Point<3>| {
            let [x, y] = view.place(*p);
            [x, y, view.depth(*p)]
        };
        let mut places: Vec<Place> = grids.iter().flat_map(Grid::points).map(seen).collect();
        let first = *places.first()?;
        let (mut low, mut high) = (first, first);
        for place in &places {
            low = std::array::from_fn(|d| low[d].min(place[d]));
            high = std::array::from_fn(|d| high[d].max(place[d]));
        }
        let half = (0..3).fold(0.0_f64, |m, d| m.max(high[d] / 2.0 - low[d] / 2.0));
        if half <= 0.0 || !half.is_finite() {
            return None;
        }
        for place in &mut places {
            *place = std::array::from_fn(|d| (place[d] - (low[d] / 2.0 + high[d] / 2.0)) / half);
        }
        let place = |index: usize| places.get(index).copied().unwrap_or([0.0; 3]);
        let bounds = BoundingBox::around(grids.iter().flat_map(Grid::points).copied())?;
        let narrowest = (bounds.rounding() / half).max(FLATTEST);
        let mut triangles: Vec<[usize; 3]> = Vec::new();
        for (first, grid) in numbered(grids) {
            let columns = grid.columns().saturating_sub(1).max(1);
            let mut cells: Vec<(u64, [usize; 4])> = (0..)
                .zip(grid.cells())
                .map(|(index, cell)| (along_squares([index / columns, index % columns]), cell))
                .collect();
            cells.sort_unstable_by_key(|(along, _)| *along);
            let both = cells.iter().flat_map(|(_, cell)| split(*cell, grid.points()));
            let numbers = both.map(|corners| corners.map(|n| first + n));
            // What is seen edge-on hides nothing; but for rounding, it would hide anything.
            triangles.extend(numbers.filter(|corners| width(corners.map(place)) > narrowest));
        }
        let tree = Tree::new(triangles.iter().map(|corners| corners.map(place)));
        Some(Self { places, triangles, tree })
    }

    fn place(&self, index: usize) -> Place {
        self.places.get(index).copied().unwrap_or([0.0; 3])
    }

    /// The parts of an edge that no triangle hides, as parameters from 0 to 1.
    fn visible(&self, from: usize, to: usize) -> Vec<[f64; 2]> {
        let ends = [self.place(from), self.place(to)];
        let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
        let mut hidden = Vec::new();
        // Half of the depth that counts, so that rounding leaves nothing out.
        self.tree.visit(ends, BEHIND / 2.0, |number| {
            let Some(corners) = self.triangles.get(number) else { return false };
            let part = behind(ends, corners.map(|index| self.place(index)));
            hidden.extend(part);
            part == Some([0.0, 1.0])
        });
        rest(hidden, if length > 0.0 { SHORT / length } else { 0.0 })
    }
}

/// The least width of a triangle in the picture: the height over its longest side.
fn width([a, b, c]: [Place; 3]) -> f64 {
    let side = |p: Place, q: Place| (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2);
    let longest = side(a, b).max(side(b, c)).max(side(c, a)).sqrt();
    if longest > 0.0 { side_of(a, b, c).abs() / longest } else { 0.0 }
}

/// The part of an edge that is hidden by a triangle.
fn behind([from, to]: [Place; 2], [a, b, c]: [Place; 3]) -> Option<[f64; 2]> {
    let area = side_of(a, b, c);
    // A triangle seen edge-on hides nothing.
    if area == 0.0 {
        return None;
    }
    let weights =
        |place: Place| [side_of(b, c, place), side_of(c, a, place), side_of(a, b, place)].map(|x| x / area);
    let (at_from, at_to) = (weights(from), weights(to));
    let mut range = [0.0, 1.0];
    for (&start, &end) in at_from.iter().zip(&at_to) {
        range = positive(range, start, end)?;
    }
    // Both are inside the triangle now, where weights and depths are bounded.
    let depth = |t: f64| {
        let w: [f64; 3] = std::array::from_fn(|n| (1.0 - t) * at_from[n] + t * at_to[n]);
        let over = w[0] * a[2] + w[1] * b[2] + w[2] * c[2] - ((1.0 - t) * from[2] + t * to[2]);
        over - BEHIND
    };
    let [start, end] = range;
    let [first, last] = positive([0.0, 1.0], depth(start), depth(end))?;
    let at = |t: f64| (1.0 - t) * start + t * end;
    Some([at(first), at(last)]).filter(|[start, end]| start < end)
}

/// Twice the signed area of a triangle in the picture.
fn side_of(a: Place, b: Place, c: Place) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The part of a range where a linear function, given at 0 and 1, is not negative.
fn positive([start, end]: [f64; 2], at_0: f64, at_1: f64) -> Option<[f64; 2]> {
    let range = match (at_0 >= 0.0, at_1 >= 0.0) {
        (true, true) => [start, end],
        (true, false) => [start, end.min(at_0 / (at_0 - at_1))],
        (false, true) => [start.max(at_0 / (at_0 - at_1)), end],
        (false, false) => return None,
    };
    (range[0] < range[1]).then_some(range)
}

/// The interval 0 to 1 without some parts, in pieces no shorter than a given length.
fn rest(mut hidden: Vec<[f64; 2]>, short: f64) -> Vec<[f64; 2]> {
    hidden.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let (mut pieces, mut reached) = (Vec::new(), 0.0);
    for [start, end] in hidden.into_iter().chain([[1.0, 1.0]]) {
        // The whole edge stays, however short.
        if start - reached > short || [reached, start] == [0.0, 1.0] {
            pieces.push([reached, start]);
        }
        reached = end.max(reached);
    }
    pieces
}

fn lerp(a: Point<2>, b: Point<2>, t: f64) -> Point<2> {
    std::array::from_fn(|d| (1.0 - t) * a[d] + t * b[d])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A ball of radius 1, closed in u.
    fn ball() -> Grid {
        Grid::from_fn([49, 25], [true, false], |k, l| {
            let (psi, fi) = (k as f64 * std::f64::consts::TAU / 48.0, l as f64 * std::f64::consts::PI / 24.0);
            [fi.sin() * psi.cos(), fi.sin() * psi.sin(), fi.cos()]
        })
    }

    fn length(line: &[Point<2>]) -> f64 {
        line.windows(2).map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1])).sum()
    }

    #[test]
    fn the_front_half_of_a_ball_is_seen() {
        let view = View::from_direction([0.3, -0.7, 0.2]);
        let lines = visible_lines(&[ball()], &view);
        let seen: f64 = lines.iter().map(|line| length(line)).sum();
        let all: f64 = all_lines(&ball(), &view).iter().map(|line| length(line)).sum();
        // Cells across the silhouette are visible as a whole.
        assert!((0.5..0.52).contains(&(seen / all)), "{}", seen / all);
    }

    #[test]
    fn a_sheet_in_front_cuts_lines_exactly() {
        // Two levels of one strip, seen from above: the upper one hides what lies under it.
        let view = View::from_direction([0.0, -1e-9, 1.0]);
        let strip = Grid::from_fn([5, 2], [false; 2], |k, l| {
            let l = l as f64;
            [
                [-3.0, l, 0.0],
                [3.0, l, 0.0],
                [4.0, l, 1.0],
                [1.0, 4.0 * l - 1.0, 2.0],
                [-1.0, 4.0 * l - 1.0, 2.0],
            ][k]
        });
        let lines = visible_lines(&[strip], &view);
        // The border v = 0 of the lower level is hidden between x = -1 and x = 1.
        let ends = |x: f64| {
            lines.iter().any(|line| line.iter().any(|p| (p[0] - x).abs() < 1e-6 && p[1].abs() < 1e-6))
        };
        assert!(ends(-1.0), "{lines:?}");
    }

    /// Whether a ray from a point towards the viewer meets a triangle: by determinants in space, where the
    /// picture plays no part.
    fn meets(from: Point<3>, way: Point<3>, [a, b, c]: [Point<3>; 3]) -> bool {
        let minus = |p: Point<3>, q: Point<3>| -> Point<3> { std::array::from_fn(|d| p[d] - q[d]) };
        let det = |p: Point<3>, q: Point<3>, r: Point<3>| {
            p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
                + p[2] * (q[0] * r[1] - q[1] * r[0])
        };
        let (first, second, back) = (minus(b, a), minus(c, a), way.map(|x| -x));
        let (whole, rest) = (det(first, second, back), minus(from, a));
        let [p, q, far] =
            [det(rest, second, back), det(first, rest, back), det(first, second, rest)].map(|x| x / whole);
        p >= 0.0 && q >= 0.0 && p + q <= 1.0 && far > 1e-5
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn what_is_seen_is_what_rays_reach(
            heights in prop::collection::vec(-2.0..2.0, 36),
            direction in (-1.0..1.0, -1.0..1.0, 0.1..1.0).prop_map(|(a, b, c)| [a, b, c]),
        ) {
            let grid = Grid::from_fn([6, 6], [false; 2], |k, l| [k as f64, l as f64, heights[6 * k + l]]);
            let view = View::from_direction(direction);
            let way = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| view.depth(axis));
            let scene = Scene::new(std::slice::from_ref(&grid), &view).unwrap();
            for line in grid_lines(&grid, 0) {
                for (&from, &to) in line.iter().zip(&line[1..]) {
                    let pieces = scene.visible(from, to);
                    for t in [0.11, 0.37, 0.53, 0.91] {
                        // At the very end of a piece rounding decides.
                        if pieces.iter().flatten().any(|end| (end - t).abs() < 1e-3) {
                            continue;
                        }
                        let (a, b) = (grid.points()[from], grid.points()[to]);
                        let point = std::array::from_fn(|d| (1.0 - t) * a[d] + t * b[d]);
                        let hidden = scene.triangles.iter().any(|corners| {
                            meets(point, way, corners.map(|index| grid.points()[index]))
                        });
                        let seen = pieces.iter().any(|piece| piece[0] < t && t < piece[1]);
                        prop_assert_eq!(seen, !hidden, "edge {} to {} at {}: {:?}", from, to, t, pieces);
                    }
                }
            }
        }

        #[test]
        fn pieces_and_hidden_parts_fill_the_edge(
            hidden in prop::collection::vec((0.0..0.9, 0.0..0.5).prop_map(|(a, b): (f64, f64)| [a, (a + b).min(1.0)]), 0..6),
        ) {
            let pieces = rest(hidden.clone(), 0.0);
            for step in 0..=1000 {
                let t = f64::from(step) / 1000.0;
                let inside = |parts: &[[f64; 2]]| parts.iter().any(|part| part[0] < t && t < part[1]);
                prop_assert!(!(inside(&pieces) && inside(&hidden)));
                let touches = |parts: &[[f64; 2]]| parts.iter().any(|part| part[0] <= t && t <= part[1]);
                prop_assert!(touches(&pieces) || touches(&hidden));
            }
        }
    }
}
