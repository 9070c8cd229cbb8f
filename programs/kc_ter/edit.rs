//! Named edits of a scene. An item that is exact stays exact where the edit keeps its functions.

use crate::design::ec::{Bases, coefficients, patch_space};
use crate::file::ec::{Border, EcCurve, EcPatch, Item, Join, Scene, values};
use crate::geometry::ec::{EcBasis, EcError, Real, Space};
use crate::geometry::{BoundingBox, Point, norm};
use std::sync::Arc;

/// A control point: its number in a curve, or its row and column in a net.
pub(super) type Index = [usize; 2];

/// How far a new item is moved, so that it does not cover the last.
const OFFSET: f64 = 20.0;

/// A new curve over cubic polynomials.
pub(super) fn new_curve(number: usize) -> Item {
    let by = OFFSET * (number % 10) as f64;
    let points = [[-100.0, -50.0], [-40.0, 60.0], [40.0, 60.0], [100.0, -50.0]];
    Item::Curve(EcCurve {
        space: Space::polynomials(3),
        interval: [0.0.into(), 1.0.into()],
        points: points.into_iter().map(|[x, y]| [x + by, y + by, 0.0]).collect(),
        exact: None,
        style: Default::default(),
        name: None,
    })
}

/// A new patch over cubic polynomials: a grid with a bump.
pub(super) fn new_patch(number: usize) -> Item {
    let by = OFFSET * (number % 10) as f64;
    let place = |k: usize| 60.0 * (k as f64 - 1.5) + by;
    let height = |k: usize, l: usize| if [k, l].iter().all(|at| (1..3).contains(at)) { 40.0 } else { 0.0 };
    Item::Patch(EcPatch {
        space_u: Space::polynomials(3),
        interval_u: [0.0.into(), 1.0.into()],
        space_v: Space::polynomials(3),
        interval_v: [0.0.into(), 1.0.into()],
        net: (0..4).map(|k| (0..4).map(|l| [place(k), place(l), height(k, l)]).collect()).collect(),
        exact: None,
        style: Default::default(),
        name: None,
    })
}

/// All control points with their indices.
pub(super) fn control_points(item: &Item) -> Vec<(Index, Point<3>)> {
    match item {
        Item::Curve(curve) => curve.points.iter().enumerate().map(|(i, &point)| ([i, 0], point)).collect(),
        Item::Patch(patch) => {
            let row = |(k, row): (usize, &Vec<Point<3>>)| {
                row.iter().enumerate().map(|(l, &point)| ([k, l], point)).collect::<Vec<_>>()
            };
            patch.net.iter().enumerate().flat_map(row).collect()
        }
    }
}

pub(super) fn control_point(item: &Item, [k, l]: Index) -> Option<Point<3>> {
    match item {
        Item::Curve(curve) => curve.points.get(k).copied(),
        Item::Patch(patch) => patch.net.get(k)?.get(l).copied(),
    }
}

/// The item with a control point at another place; it is no exact description any more.
pub(super) fn with_point(mut item: Item, [k, l]: Index, place: Point<3>) -> Item {
    let (slot, exact) = match &mut item {
        Item::Curve(curve) => (curve.points.get_mut(k), curve.exact.is_some()),
        Item::Patch(patch) => (patch.net.get_mut(k).and_then(|row| row.get_mut(l)), patch.exact.is_some()),
    };
    if let Some(slot) = slot.filter(|slot| **slot != place) {
        *slot = place;
        if exact {
            match &mut item {
                Item::Curve(curve) => curve.exact = None,
                Item::Patch(patch) => patch.exact = None,
            }
        }
    }
    item
}

/// A map of space: a matrix by rows, and a shift.
pub(super) struct Affine {
    pub(super) rows: [Point<3>; 3],
    pub(super) shift: Point<3>,
}

const UNIT: [Point<3>; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Affine {
    pub(super) fn moved(shift: Point<3>) -> Affine {
        Affine { rows: UNIT, shift }
    }

    /// A matrix that leaves a point where it is.
    pub(super) fn about(rows: [Point<3>; 3], point: Point<3>) -> Affine {
        let image = Affine { rows, shift: [0.0; 3] }.vector(point);
        Affine { rows, shift: std::array::from_fn(|d| point[d] - image[d]) }
    }

    pub(super) fn scaled(factor: f64, point: Point<3>) -> Affine {
        Affine::about(UNIT.map(|row| row.map(|x| factor * x)), point)
    }

    fn vector(&self, p: Point<3>) -> Point<3> {
        self.rows.map(|row| crate::geometry::dot(row, p))
    }

    fn point(&self, p: Point<3>) -> Point<3> {
        let image = self.vector(p);
        std::array::from_fn(|d| (image[d] + self.shift[d]).clamp(-FARTHEST, FARTHEST))
    }

    /// The coefficients of an exact description: those of the constant function take the shift.
    fn coefficient(&self, value: &[Real; 3], constant: bool) -> [Real; 3] {
        let image = self.vector(value.each_ref().map(Real::value));
        std::array::from_fn(|d| {
            let number = image[d] + if constant { self.shift[d] } else { 0.0 };
            // What does not change stays as it was written.
            if number == value[d].value() { value[d].clone() } else { Real::from(number) }
        })
    }
}

/// The largest coordinate.
pub(super) const FARTHEST: f64 = 1e6;

/// The image of an item, which stays exact.
pub(super) fn mapped(item: &Item, map: &Affine) -> Item {
    use crate::file::ec::{CurveTerm, PatchTerm};
    let is_far = |p: &Point<3>| p.iter().any(|x| x.abs() >= FARTHEST);
    match item {
        Item::Curve(curve) => {
            let points: Vec<Point<3>> = curve.points.iter().map(|&p| map.point(p)).collect();
            let cut = points.iter().any(is_far);
            let exact = curve.exact.as_ref().filter(|_| !cut).map(|terms| {
                let mut terms = terms.clone();
                if !terms.iter().any(|term| term.function == 0) {
                    terms.push(CurveTerm { function: 0, value: Default::default() });
                }
                let mut first = true;
                for term in &mut terms {
                    let constant = term.function == 0 && std::mem::take(&mut first);
                    term.value = map.coefficient(&term.value, constant);
                }
                terms.retain(|term| term.value.iter().any(|x| x.value() != 0.0));
                terms
            });
            Item::Curve(EcCurve { points, exact, ..curve.clone() })
        }
        Item::Patch(patch) => {
            let net: Vec<Vec<Point<3>>> =
                patch.net.iter().map(|row| row.iter().map(|&p| map.point(p)).collect()).collect();
            let cut = net.iter().flatten().any(is_far);
            let exact = patch.exact.as_ref().filter(|_| !cut).map(|terms| {
                let mut terms = terms.clone();
                if !terms.iter().any(|term| [term.u, term.v] == [0, 0]) {
                    terms.push(PatchTerm { u: 0, v: 0, value: Default::default() });
                }
                let mut first = true;
                for term in &mut terms {
                    let constant = [term.u, term.v] == [0, 0] && std::mem::take(&mut first);
                    term.value = map.coefficient(&term.value, constant);
                }
                terms.retain(|term| term.value.iter().any(|x| x.value() != 0.0));
                terms
            });
            Item::Patch(EcPatch { net, exact, ..patch.clone() })
        }
    }
}

/// The middle of an item's control points.
pub(super) fn middle(item: &Item) -> Point<3> {
    let points: Vec<Point<3>> = control_points(item).into_iter().map(|(_, point)| point).collect();
    let bounds = BoundingBox::of_points(&points);
    bounds.map_or([0.0; 3], |bounds| std::array::from_fn(|d| bounds.min[d] / 2.0 + bounds.max[d] / 2.0))
}

/// Whether the control points are an exact description.
pub(super) fn is_exact(item: &Item) -> bool {
    coefficients(item).is_some()
}

/// The number of items after one has been replaced by several, or by none: joins go with the items, and those of a
/// replaced one are gone.
pub(super) fn replace(scene: &mut Scene, at: usize, with: Vec<Item>) {
    let count = with.len();
    scene.items.splice(at..(at + 1).min(scene.items.len()), with);
    let renumbered = |number: usize| match number {
        number if number < at => Some(number),
        number if number == at => None,
        number => Some(number + count - 1),
    };
    scene.joins = std::mem::take(&mut scene.joins)
        .into_iter()
        .filter_map(|join| {
            let (a, b) = (renumbered(join.a.0)?, renumbered(join.b.0)?);
            Some(Join { a: (a, join.a.1), b: (b, join.b.1), ..join })
        })
        .collect();
}

/// Makes the other sides of the joins of an item meet it again, and those that are joined with them, each once.
pub(super) fn keep_joins(scene: &mut Scene, leader: usize, bases: &mut Bases) {
    let mut done = vec![leader];
    let mut next = 0;
    while let Some(&leading) = done.get(next) {
        next += 1;
        for join in scene.joins.clone() {
            let (from, to) = match (join.a, join.b) {
                (a, b) if a.0 == leading && !done.contains(&b.0) => (a, b),
                (a, b) if b.0 == leading && !done.contains(&a.0) => (b, a),
                _ => continue,
            };
            done.push(to.0);
            let (Some(one), Some(other)) = (scene.items.get(from.0), scene.items.get(to.0)) else { continue };
            if let Ok(joined) = joined(one, from.1, other, to.1, &join, bases)
                && let Some(slot) = scene.items.get_mut(to.0)
            {
                *slot = joined;
            }
        }
    }
}

/// The item `other`, changed so that its border meets that of `one` with equal derivatives.
///
/// # Errors
/// [`EcError`] where the borders of patches have different spaces.
pub(super) fn joined(
    one: &Item,
    from: Border,
    other: &Item,
    to: Border,
    join: &Join,
    bases: &mut Bases,
) -> Result<Item, EcError> {
    let mut result = match (one, other) {
        (Item::Curve(one), Item::Curve(other)) => {
            let bases = [
                bases.of(&one.space, values(&one.interval))?,
                bases.of(&other.space, values(&other.interval))?,
            ];
            let points = joined_points(&bases, [&one.points, &other.points], [from, to], join)?;
            Item::Curve(EcCurve { points, ..other.clone() })
        }
        (Item::Patch(one), Item::Patch(other)) => {
            let (u, v) = patch_space(one, from.direction());
            let (u2, v2) = patch_space(other, to.direction());
            let bases = [bases.of(u, values(v))?, bases.of(u2, values(v2))?];
            let [lines, other_lines] =
                [(one, from), (other, to)].map(|(patch, border)| lines(&patch.net, border));
            if lines.len() != other_lines.len() {
                let (given, needed) = (other_lines.len(), lines.len());
                return Err(crate::geometry::GeometryError::WrongCount { given, needed }.into());
            }
            let changed = lines
                .iter()
                .zip(&other_lines)
                .map(|(line, other)| joined_points(&bases, [line, other], [from, to], join))
                .collect::<Result<Vec<_>, _>>()?;
            let net = if to.direction() == 0 { transposed(&changed) } else { changed };
            Item::Patch(EcPatch { net, ..other.clone() })
        }
        _ => other.clone(),
    };
    if result != *other {
        match &mut result {
            Item::Curve(curve) => curve.exact = None,
            Item::Patch(patch) => patch.exact = None,
        }
    }
    Ok(result)
}

/// The lines of a net that cross a border.
fn lines(net: &[Vec<Point<3>>], border: Border) -> Vec<Vec<Point<3>>> {
    if border.direction() == 0 { transposed(net) } else { net.to_vec() }
}

fn transposed(net: &[Vec<Point<3>>]) -> Vec<Vec<Point<3>>> {
    let columns = net.first().map_or(0, Vec::len);
    (0..columns).map(|l| net.iter().filter_map(|row| row.get(l)).copied().collect()).collect()
}

fn joined_points(
    [one, other]: &[Arc<EcBasis>; 2],
    [points, others]: [&[Point<3>]; 2],
    [from, to]: [Border; 2],
    join: &Join,
) -> Result<Vec<Point<3>>, EcError> {
    let mut derivatives = one.end_derivatives(points, from.is_end(), join.order)?;
    // Where both ends or both starts meet, the parameter runs back.
    if from.is_end() == to.is_end() {
        derivatives.iter_mut().skip(1).step_by(2).for_each(|derivative| *derivative = derivative.map(|x| -x));
    }
    if join.geometric && derivatives.len() > 1 {
        // Its length stays that of the other side.
        let own = other.end_derivatives(others, to.is_end(), 1)?;
        let lengths = [norm(derivatives[1]), own.get(1).map_or(0.0, |own| norm(*own))];
        if lengths[0] > 0.0 && lengths[1] > 0.0 {
            derivatives[1] = derivatives[1].map(|x| x * lengths[1] / lengths[0]);
        }
        derivatives.truncate(2);
    }
    other.set_end_derivatives(others, to.is_end(), &derivatives)
}

/// The borders of two items that lie nearest to each other.
pub(super) fn nearest_borders(one: &Item, other: &Item) -> [Border; 2] {
    let all = |item: &Item| -> Vec<(Border, Vec<Point<3>>)> {
        match item {
            Item::Curve(curve) => {
                let ends = [(Border::Start, curve.points.first()), (Border::End, curve.points.last())];
                ends.into_iter()
                    .map(|(border, point)| (border, point.into_iter().copied().collect()))
                    .collect()
            }
            Item::Patch(patch) => {
                let column = |last: bool| {
                    let end =
                        |row: &Vec<Point<3>>| if last { row.last().copied() } else { row.first().copied() };
                    patch.net.iter().filter_map(end).collect()
                };
                vec![
                    (Border::Start, patch.net.first().cloned().unwrap_or_default()),
                    (Border::End, patch.net.last().cloned().unwrap_or_default()),
                    (Border::VStart, column(false)),
                    (Border::VEnd, column(true)),
                ]
            }
        }
    };
    let mut best = ([Border::End, Border::Start], f64::INFINITY);
    // Ends are tried before starts, so that equal distances continue a curve.
    for (from, points) in all(one).into_iter().rev() {
        for (to, others) in all(other) {
            if points.len() != others.len() {
                continue;
            }
            let away: f64 = points
                .iter()
                .zip(&others)
                .map(|(a, b)| norm::<3>(std::array::from_fn(|d| a[d] - b[d])))
                .sum();
            if away < best.1 {
                best = ([from, to], away);
            }
        }
    }
    best.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::ec::CurveTerm;

    fn circle() -> Item {
        let term = |function, value: [f64; 3]| CurveTerm { function, value: value.map(Real::from) };
        let coefficients = [term(1, [100.0, 0.0, 0.0]), term(2, [0.0, 100.0, 0.0])];
        let space: Space = "0,i".parse().unwrap();
        let interval = [0.0.into(), 2.0.into()];
        Item::Curve(Bases::default().exact_curve(&space, &interval, &coefficients).unwrap())
    }

    #[test]
    fn moved_and_turned_items_stay_exact() {
        let mut bases = Bases::default();
        let item = circle();
        let turned = super::super::eye::Eye::default().rotation((80, -30));
        for map in [
            Affine::moved([3.0, -2.0, 7.0]),
            Affine::about(turned, middle(&item)),
            Affine::scaled(1.05, middle(&item)),
        ] {
            let image = mapped(&item, &map);
            let again = bases.described(&coefficients(&image).unwrap()).unwrap();
            let pairs = control_points(&image).into_iter().zip(control_points(&again));
            for ((_, a), (_, b)) in pairs {
                assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-11), "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn a_moved_point_ends_exactness_and_a_kept_one_does_not() {
        let item = circle();
        let place = control_point(&item, [1, 0]).unwrap();
        assert!(is_exact(&with_point(item.clone(), [1, 0], place)));
        assert!(!is_exact(&with_point(item.clone(), [1, 0], [0.0; 3])));
        assert!(is_exact(&with_point(item, [9, 0], [0.0; 3])));
    }

    #[test]
    fn joined_curves_follow_each_other() {
        let mut bases = Bases::default();
        let mut scene = Scene { items: vec![new_curve(0), new_curve(1), new_curve(2)], ..Scene::default() };
        for at in 1..3 {
            scene.joins.push(Join {
                a: (at - 1, Border::End),
                b: (at, Border::Start),
                order: 1,
                geometric: false,
            });
        }
        scene.items[0] = with_point(scene.items[0].clone(), [3, 0], [50.0, 20.0, 9.0]);
        keep_joins(&mut scene, 0, &mut bases);
        let point = |item: usize, at: usize| control_point(&scene.items[item], [at, 0]).unwrap();
        assert_eq!(point(1, 0), [50.0, 20.0, 9.0]);
        // Equal derivatives of equal intervals: the leg goes on.
        for d in 0..3 {
            let (before, after) = (point(0, 3)[d] - point(0, 2)[d], point(1, 1)[d] - point(1, 0)[d]);
            assert!((before - after).abs() < 1e-12);
        }
        assert_eq!(point(2, 0), point(1, 3));
        assert_eq!(nearest_borders(&scene.items[0], &scene.items[1]), [Border::End, Border::Start]);
    }

    #[test]
    fn replacing_an_item_renumbers_the_joins() {
        let mut scene = Scene { items: (0..4).map(new_curve).collect(), ..Scene::default() };
        let join = |a, b| Join { a: (a, Border::End), b: (b, Border::Start), order: 0, geometric: false };
        scene.joins = vec![join(0, 1), join(2, 3)];
        replace(&mut scene, 1, vec![new_curve(0), new_curve(1)]);
        assert_eq!((scene.items.len(), scene.joins.clone()), (5, vec![join(3, 4)]));
        replace(&mut scene, 4, Vec::new());
        assert_eq!((scene.items.len(), scene.joins.len()), (4, 0));
    }
}
