//! Named edits of plane curves by knots. The list of knots stays right through all of them: as many as points and
//! order together, ascending, none too often.

use super::{Curve, curve, document};
use crate::file::{KnotPoints, Places};
use crate::geometry::Point;
use crate::geometry::knots::{KnotCurve, KnotError, KnotVector};
use serde::Serialize;

/// How a curve begins and ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Ends {
    /// Anywhere between its control points.
    Open,
    /// At its first and its last control point.
    Clamped,
    /// Nowhere: the last span is followed by the first.
    Closed,
}

/// How close to a place that they must not reach knots may come, in mean distances.
const NEAREST: f64 = 1e-3;

/// The control points of a plane curve; none of one in space.
#[must_use]
pub fn places(curve: &KnotPoints) -> &[Point<2>] {
    match &curve.points {
        Places::Plane(points) => points,
        Places::Space(_) => &[],
    }
}

/// The plane curve; `None` for fewer points than the order.
#[must_use]
pub fn plane(points: &KnotPoints) -> Option<KnotCurve<2>> {
    match curve(points) {
        Ok(Curve::Plane(curve)) => Some(curve),
        _ => None,
    }
}

/// How it begins and ends.
#[must_use]
pub fn ends(curve: &KnotPoints) -> Ends {
    let (order, knots) = (curve.order, &curve.knots);
    let equal = |from: usize| knots.get(from..from + order).is_some_and(|row| row[0] == row[order - 1]);
    match curve.closed {
        true => Ends::Closed,
        false if curve.is_curve() && equal(0) && equal(knots.len() - order) => Ends::Clamped,
        false => Ends::Open,
    }
}

/// The mean distance of neighbouring knots, which steps are measured by: of those that differ.
#[must_use]
pub fn mean_step(curve: &KnotPoints) -> f64 {
    mean_of(&curve.knots)
}

/// The mean distance of neighbouring knots of a list.
#[must_use]
pub fn mean_of(knots: &[f64]) -> f64 {
    let [Some(first), Some(last)] = [knots.first(), knots.last()] else { return 1.0 };
    let steps = knots.windows(2).filter(|pair| pair[0] < pair[1]).count();
    if steps == 0 { 1.0 } else { (last - first) / steps as f64 }
}

/// With a control point at another place.
#[must_use]
pub fn moved(curve: &KnotPoints, index: usize, at: Point<2>) -> KnotPoints {
    with_places(curve, |points| {
        if let Some(point) = points.get_mut(index) {
            *point = at;
        }
    })
}

/// With a further control point and a further knot, by which the list goes on.
#[must_use]
pub fn inserted(curve: &KnotPoints, index: usize, at: Point<2>) -> KnotPoints {
    let index = index.min(curve.points.len());
    let mut new = with_places(curve, |points| points.insert(index, at));
    if let Some(weights) = &mut new.weights {
        weights.insert(index.min(weights.len()), 1.0);
    }
    let (step, last) = (mean_step(curve), curve.knots.last().copied().unwrap_or(-1.0));
    match ends(curve) {
        // The end with all its copies goes one step further and leaves one knot behind.
        Ends::Clamped => {
            let end = new.knots.len() - curve.order;
            new.knots[end..].iter_mut().for_each(|knot| *knot = last + step);
            new.knots.insert(end, last);
        }
        _ => new.knots.push(last + step),
    }
    right(new)
}

/// Without a control point; the list of knots ends earlier.
#[must_use]
pub fn deleted(curve: &KnotPoints, index: usize) -> KnotPoints {
    if index >= curve.points.len() {
        return curve.clone();
    }
    let mut new = with_places(curve, |points| {
        points.remove(index);
    });
    if let Some(weights) = new.weights.as_mut().filter(|weights| index < weights.len()) {
        weights.remove(index);
    }
    match ends(curve) {
        Ends::Clamped if new.is_curve() => {
            let end = new.knots.len() - curve.order;
            let before = new.knots[end - 1];
            new.knots.remove(end - 1);
            new.knots[end - 1..].iter_mut().for_each(|knot| *knot = before);
        }
        _ => {
            new.knots.pop();
        }
    }
    if new.points.is_empty() && new.closed {
        new.knots.clear();
    }
    right(new)
}

/// With a control point, and its weight, under another number.
#[must_use]
pub fn renumbered(curve: &KnotPoints, from: usize, to: usize) -> KnotPoints {
    let count = curve.points.len();
    if from >= count || to >= count {
        return curve.clone();
    }
    let mut new = with_places(curve, |points| {
        let point = points.remove(from);
        points.insert(to, point);
    });
    if let Some(weights) = &mut new.weights {
        let weight = weights.remove(from);
        weights.insert(to, weight);
    }
    new
}

/// With a weight; the others are 1 if there were none.
#[must_use]
pub fn weighted(curve: &KnotPoints, index: usize, weight: f64) -> KnotPoints {
    let mut weights = curve.weights.clone().unwrap_or_else(|| vec![1.0; curve.points.len()]);
    if let Some(old) = weights.get_mut(index) {
        *old = weight;
    }
    // Equal weights are none.
    let weights = Some(weights).filter(|weights| weights.windows(2).any(|pair| pair[0] != pair[1]));
    KnotPoints { weights, ..curve.clone() }
}

/// Between which values copies of a knot, `first` the first of them, may be moved together.
#[must_use]
pub fn room(curve: &KnotPoints, first: usize, copies: usize) -> [f64; 2] {
    let at = |index: Option<usize>| index.and_then(|index| curve.knots.get(index)).copied();
    [
        at(first.checked_sub(1)).unwrap_or(f64::NEG_INFINITY),
        at(first.checked_add(copies)).unwrap_or(f64::INFINITY),
    ]
}

/// With copies of a knot at a value, or as near to it as their neighbours allow. The first and last break of a closed
/// curve stay.
#[must_use]
pub fn knot_moved(curve: &KnotPoints, first: usize, copies: usize, value: f64) -> KnotPoints {
    if seam(curve, first, copies) {
        return curve.clone();
    }
    let with = |knots: &[f64]| KnotPoints { knots: knots.to_vec(), ..curve.clone() };
    let moved = list_moved(&curve.knots, (first, copies), value, |knots| holds(&with(knots)));
    moved.map_or_else(|| curve.clone(), |knots| with(&knots))
}

/// A list of knots with copies of one of them, the first of which is told, at a value, or as near to it as their
/// neighbours and `right` allow. `None` where they cannot move.
#[must_use]
pub fn list_moved(
    knots: &[f64],
    (first, copies): (usize, usize),
    value: f64,
    right: impl Fn(&[f64]) -> bool,
) -> Option<Vec<f64>> {
    let before = *knots.get(first)?;
    if copies == 0 || first.checked_add(copies)? > knots.len() || !value.is_finite() {
        return None;
    }
    let low = first.checked_sub(1).map_or(f64::NEG_INFINITY, |before| knots[before]);
    let high = knots.get(first + copies).copied().unwrap_or(f64::INFINITY);
    let at = |value: f64| {
        let mut new = knots.to_vec();
        new[first..first + copies].fill(value);
        Some(new).filter(|new| right(new))
    };
    let aim = value.max(low).min(high);
    // A place that is full already is not reached.
    let short = NEAREST * mean_of(knots);
    let near = if aim > before { (aim - short).max(before) } else { (aim + short).min(before) };
    at(aim).or_else(|| at(near))
}

/// Whether copies of a knot contain an end of the period of a closed curve.
fn seam(curve: &KnotPoints, first: usize, copies: usize) -> bool {
    curve.closed && (first == 0 || first + copies >= curve.knots.len())
}

/// With two knots moved against each other by as much as both have room.
#[must_use]
pub fn opposed(curve: &KnotPoints, [first, second]: [usize; 2], by: f64) -> KnotPoints {
    let Some((&left, &right)) = curve.knots.get(first).zip(curve.knots.get(second)) else {
        return curve.clone();
    };
    let ([low, high], [under, over]) = (room(curve, first, 1), room(curve, second, 1));
    let by = by.max(low - left).max(right - over).min(high - left).min(right - under);
    let mut new = curve.clone();
    (new.knots[first], new.knots[second]) = (left + by, right - by);
    if by.is_finite() && holds(&new) { new } else { curve.clone() }
}

/// With another order and other ends, the control points at their places. The same order with other ends gives the same
/// curve where an open one is clamped or the other way round.
#[must_use]
pub fn of_kind(points: &KnotPoints, order: usize, kind: Ends) -> KnotPoints {
    if order == points.order && kind == ends(points) {
        return points.clone();
    }
    if order == points.order
        && let Some(same) = plane(points).and_then(|curve| match kind {
            Ends::Open => curve.unclamped().ok(),
            Ends::Clamped => curve.clamped().ok(),
            Ends::Closed => None,
        })
    {
        return document(&same);
    }
    let (count, closed) = (points.points.len(), kind == Ends::Closed);
    let knots = match kind {
        Ends::Clamped => KnotVector::clamped(order, count).map(|vector| vector.knots().to_vec()).ok(),
        Ends::Closed if !points.closed => {
            let from = points.order - 1;
            points.knots.get(from..from + count + 1).map(<[f64]>::to_vec)
        }
        Ends::Closed => Some(points.knots.clone()),
        Ends::Open => resized(&points.knots, count + order),
    };
    let fewest = || (0..=count).map(|knot| knot as f64).collect();
    let knots = knots.unwrap_or_else(fewest);
    right(KnotPoints { order, closed, knots, ..points.clone() })
}

/// The list with as many knots as needed: more by its mean step at both ends, or fewer at both.
fn resized(knots: &[f64], needed: usize) -> Option<Vec<f64>> {
    let mut knots = knots.to_vec();
    let step = (knots.last()? - knots.first()?) / (knots.len() - 1).max(1) as f64;
    while knots.len() > needed {
        if knots.len().is_multiple_of(2) {
            knots.remove(0);
        } else {
            knots.pop();
        }
    }
    while knots.len() < needed {
        if knots.len().is_multiple_of(2) {
            knots.insert(0, knots[0] - step);
        } else {
            knots.push(knots[knots.len() - 1] + step);
        }
    }
    Some(knots)
}

/// The document, over the knots 0, 1, 2, ... if its own make no curve.
fn right(points: KnotPoints) -> KnotPoints {
    let count = points.points.len();
    let needed = match points.closed {
        true if count == 0 => 0,
        true => count + 1,
        false => count + points.order,
    };
    if points.knots.len() == needed && holds(&points) {
        return points;
    }
    KnotPoints { knots: (0..needed).map(|knot| knot as f64).collect(), ..points }
}

/// Whether the knots make a curve, or will when there are more points.
fn holds(points: &KnotPoints) -> bool {
    let ascending = points.knots.windows(2).all(|pair| pair[0] <= pair[1]);
    ascending && (!points.is_curve() || points.vector().is_ok())
}

fn with_places(curve: &KnotPoints, change: impl FnOnce(&mut Vec<Point<2>>)) -> KnotPoints {
    let mut points = places(curve).to_vec();
    change(&mut points);
    KnotPoints { points: points.into(), ..curve.clone() }
}

/// The same curve after an exact change of its knots.
///
/// # Errors
/// What the change refuses; [`KnotError::NoSpan`] for fewer points than the order.
pub fn rewritten(
    points: &KnotPoints,
    change: impl FnOnce(&KnotCurve<2>) -> Result<KnotCurve<2>, KnotError>,
) -> Result<KnotPoints, KnotError> {
    Ok(document(&change(&plane(points).ok_or(KnotError::NoSpan)?)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ParamCurve;
    use proptest::prelude::*;

    fn row(count: usize) -> KnotPoints {
        KnotPoints::of_points(
            (0..count).map(|i| [20.0 * i as f64, (i * i % 7) as f64 * 30.0]).collect::<Vec<_>>(),
        )
    }

    #[test]
    fn the_list_stays_right_while_points_come_and_go() {
        for kind in [Ends::Open, Ends::Clamped, Ends::Closed] {
            let mut curve = of_kind(&row(5), 4, kind);
            assert_eq!(ends(&curve), kind);
            for index in [5, 0, 3] {
                curve = inserted(&curve, index, [1.0, 2.0]);
                assert!(plane(&curve).is_some(), "{kind:?} {curve:?}");
                assert_eq!((places(&curve)[index], ends(&curve)), ([1.0, 2.0], kind));
            }
            for count in (0..8).rev() {
                curve = deleted(&curve, count / 2);
                let needed = match (kind, count) {
                    (Ends::Closed, 0) => 0,
                    (Ends::Closed, _) => count + 1,
                    _ => count + 4,
                };
                assert_eq!((curve.points.len(), curve.knots.len()), (count, needed), "{kind:?}");
                assert_eq!(plane(&curve).is_some(), count >= 4);
            }
        }
    }

    #[test]
    fn a_knot_stops_at_its_neighbours_and_before_a_full_place() {
        let curve = row(7);
        assert_eq!(knot_moved(&curve, 5, 1, 5.5).knots[5], 5.5);
        assert_eq!(knot_moved(&curve, 5, 1, 9.0).knots[5], 6.0);
        assert_eq!(knot_moved(&curve, 5, 1, -9.0).knots[5], 4.0);
        assert_eq!(knot_moved(&curve, 10, 1, 99.0).knots[10], 99.0);
        assert_eq!(knot_moved(&curve, 5, 1, f64::NAN), curve);
        assert_eq!(knot_moved(&curve, 40, 1, 1.0), curve);
        let full =
            KnotPoints { knots: vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 5.0, 9.0, 10.0], ..row(7) };
        let near = knot_moved(&full, 4, 1, 6.0);
        assert!(near.knots[4] > 4.9 && near.knots[4] < 5.0, "{near:?}");
    }

    #[test]
    fn two_knots_move_as_far_as_both_can() {
        let curve = row(9);
        assert_eq!(opposed(&curve, [3, 8], 0.25).knots[3..9], [3.25, 4.0, 5.0, 6.0, 7.0, 7.75]);
        assert_eq!(opposed(&curve, [3, 8], 5.0).knots[3..9], [4.0, 4.0, 5.0, 6.0, 7.0, 7.0]);
        assert_eq!(opposed(&curve, [3, 80], 5.0), curve);
    }

    #[test]
    fn other_ends_give_the_same_curve() {
        let open = row(7);
        let clamped = of_kind(&open, 4, Ends::Clamped);
        assert_eq!(ends(&clamped), Ends::Clamped);
        let again = of_kind(&clamped, 4, Ends::Open);
        for other in [&clamped, &again] {
            for (a, b) in [&open, other].map(|it| plane(it).unwrap().polyline(4).unwrap())[0]
                .iter()
                .zip(plane(other).unwrap().polyline(4).unwrap())
            {
                assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-10);
            }
        }
    }

    #[test]
    fn weights_that_are_all_equal_are_none() {
        let curve = weighted(&row(5), 2, 3.0);
        assert_eq!(curve.weights, Some(vec![1.0, 1.0, 3.0, 1.0, 1.0]));
        assert_eq!(weighted(&curve, 2, 1.0).weights, None);
    }

    proptest! {
        #[test]
        fn every_order_and_end_has_a_right_list(
            count in 0_usize..14, order in 2_usize..=8, kinds in prop::collection::vec(0..3, 1..5),
        ) {
            let mut curve = row(count);
            for kind in kinds {
                let kind = [Ends::Open, Ends::Clamped, Ends::Closed][kind as usize];
                curve = of_kind(&curve, order, kind);
                prop_assert_eq!(plane(&curve).is_some(), curve.is_curve());
                let document = crate::file::Document::Knots(Box::new(curve.clone()));
                let text = document.to_json().unwrap();
                prop_assert_eq!(crate::file::Document::from_json(&text).unwrap(), document);
            }
        }

        #[test]
        fn moved_knots_stay_in_order(
            moves in prop::collection::vec((0_usize..17, 1_usize..4, -2.0..18.0), 1..20),
        ) {
            let mut curve = row(13);
            for (first, copies, value) in moves {
                curve = knot_moved(&curve, first, copies, value);
                prop_assert!(plane(&curve).is_some());
            }
        }
    }
}
