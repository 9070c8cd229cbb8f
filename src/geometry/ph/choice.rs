//! Which of several PH segments with the same ends is the best one.

use super::length::Lengths;
use super::segment::PhSegment;

/// What segments are compared by.
struct Merit {
    energy: Option<f64>,
    rotation: f64,
    length: f64,
}

/// Numbers that differ by less than this share of the smaller are equal.
const SAME: f64 = 1e-9;

/// The number of the best segment: the one of least bending energy, of those the shortest, of those the first. Where
/// all have infinite energy, the one of least absolute rotation. `size` is the size of the data.
pub(super) fn best(candidates: &[PhSegment], size: f64) -> Option<usize> {
    let merits: Vec<Merit> = candidates
        .iter()
        .map(|segment| Merit {
            energy: segment.energy(),
            rotation: segment.absolute_rotation(),
            length: Lengths::new(std::iter::once(segment.speed_coefficients())).total(),
        })
        .collect();
    let bent = merits.iter().all(|merit| merit.energy.is_none());
    let cost = |merit: &Merit| if bent { merit.rotation } else { merit.energy.unwrap_or(f64::INFINITY) };
    let little = if bent { SAME } else { 1e-12 / size };
    let least = smallest(merits.iter().map(cost));
    let close = |value: f64, least: f64, little: f64| value <= least * (1.0 + SAME) + little;
    let cheap = |merit: &Merit| close(cost(merit), least, little);
    let shortest = smallest(merits.iter().filter(|merit| cheap(merit)).map(|merit| merit.length));
    merits.iter().position(|merit| cheap(merit) && close(merit.length, shortest, 0.0))
}

/// The number of the best of those that turn least. The bending energy alone would prefer a loop where it is large
/// enough, since the energy falls with the size; cubics have no other freedom than size and turn.
pub(super) fn gentlest(candidates: &[PhSegment], size: f64) -> Option<usize> {
    let turns: Vec<f64> = candidates.iter().map(PhSegment::absolute_rotation).collect();
    let least = smallest(turns.iter().copied());
    let gentle: Vec<usize> = (0..turns.len()).filter(|&k| turns[k] <= least * (1.0 + SAME) + SAME).collect();
    let segments: Vec<PhSegment> = gentle.iter().map(|&k| candidates[k].clone()).collect();
    best(&segments, size).map(|k| gentle[k])
}

fn smallest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::INFINITY, f64::min)
}
