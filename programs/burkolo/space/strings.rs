//! Edits of spheres on chains: the chains follow.

use crate::file::Spheres;
use crate::geometry::skin::MAX_BALLS;

/// A sphere: centre and radius.
pub(super) type Row = [f64; 4];

/// Whether there is no room for another sphere.
pub(super) fn is_full(value: &Spheres) -> bool {
    value.spheres.len() >= MAX_BALLS
}

/// A ring of less than three is a chain.
fn settled(value: Spheres) -> Spheres {
    Spheres { closed: value.closed && value.spheres.len() > 2, ..value }
}

/// With a sphere at another place or of another size.
pub(super) fn with_sphere(value: &Spheres, index: usize, row: Row) -> Spheres {
    let mut value = value.clone();
    if let Some(place) = value.spheres.get_mut(index) {
        *place = row;
    }
    value
}

/// With a sphere before the one at an index. Of several chains, those that pass from the sphere before it to that one
/// pass the new one too, which is the last; else it is behind the last sphere of the last chain.
pub(super) fn inserted(value: &Spheres, index: usize, row: Row) -> Spheres {
    if is_full(value) {
        return value.clone();
    }
    let (mut value, count) = (value.clone(), value.spheres.len());
    let Some(chains) = &mut value.chains else {
        value.spheres.insert(index.min(count), row);
        return value;
    };
    value.spheres.push(row);
    let before = index.wrapping_sub(1);
    let mut strung = false;
    for chain in chains.iter_mut() {
        let at = chain.windows(2).position(|pair| *pair == [before, index] || *pair == [index, before]);
        if let Some(at) = at {
            chain.insert(at + 1, count);
            strung = true;
        }
    }
    if !strung {
        match chains.last_mut() {
            Some(chain) => chain.push(count),
            None => value.chains = None,
        }
    }
    value
}

/// Without a sphere.
pub(super) fn deleted(value: &Spheres, index: usize) -> Spheres {
    if index >= value.spheres.len() {
        return value.clone();
    }
    let mut value = value.clone();
    value.spheres.remove(index);
    if let Some(chains) = &mut value.chains {
        for chain in chains.iter_mut() {
            chain.retain(|sphere| *sphere != index);
            chain.iter_mut().for_each(|sphere| *sphere -= usize::from(*sphere > index));
        }
        chains.retain(|chain| chain.len() > 1);
        let strung = |sphere: usize| chains.iter().flatten().any(|it| *it == sphere);
        // What is left may hang on no chain.
        if !(0..value.spheres.len()).all(strung) {
            value.chains = None;
        }
    }
    settled(value)
}

/// A chain as a ring, and anything else as a chain in the order of the numbers.
pub(super) fn as_ring(value: &Spheres) -> Spheres {
    let closed = value.chains.is_some() || !value.closed;
    settled(Spheres { spheres: value.spheres.clone(), closed, chains: None })
}

/// The sphere halfway between two others.
pub(super) fn halfway(value: &Spheres, [a, b]: [usize; 2]) -> Option<Row> {
    let (a, b) = (value.spheres.get(a)?, value.spheres.get(b)?);
    Some(std::array::from_fn(|d| 0.5 * a[d] + 0.5 * b[d]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spheres(count: u8, chains: Option<Vec<Vec<usize>>>) -> Spheres {
        let spheres = (0..count).map(|k| [10.0 * f64::from(k), 0.0, 0.0, 4.0]).collect();
        Spheres { spheres, closed: false, chains }
    }

    #[test]
    fn chains_follow() {
        let arms = spheres(5, Some(vec![vec![0, 1, 2], vec![1, 3, 4]]));
        let more = inserted(&arms, 2, [1.0; 4]);
        assert_eq!(more.chains, Some(vec![vec![0, 1, 5, 2], vec![1, 3, 4]]));
        assert_eq!(inserted(&arms, 5, [1.0; 4]).chains, Some(vec![vec![0, 1, 2], vec![1, 3, 4, 5]]));
        assert_eq!(deleted(&arms, 3).chains, Some(vec![vec![0, 1, 2], vec![1, 3]]));
        // The last sphere would be on no chain.
        let short = spheres(4, Some(vec![vec![0, 1], vec![2, 3]]));
        assert_eq!(deleted(&short, 2).chains, None);
    }

    #[test]
    fn rings_come_and_go() {
        let chain = spheres(3, None);
        assert!(as_ring(&chain).closed);
        assert!(!deleted(&as_ring(&chain), 0).closed);
        assert_eq!(as_ring(&as_ring(&chain)), chain);
        assert_eq!(halfway(&chain, [0, 2]), Some([10.0, 0.0, 0.0, 4.0]));
        assert_eq!(inserted(&chain, 1, [1.0; 4]).spheres[1], [1.0; 4]);
    }
}
