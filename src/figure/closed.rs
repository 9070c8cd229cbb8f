//! Whether triangles enclose something: in time and memory that grow as the triangles do, without hashing.
//!
//! The corners are sorted by their vertices by counting. Then the triangles around a vertex are walked through a row of
//! numbers as long as the mesh has vertices, of which those that belong to this vertex bear its mark.

use super::buckets::Buckets;

/// A triangle by the numbers of its corners.
type Triangle = [usize; 3];

/// The corners of triangles, sorted by their vertices: three times the number of a triangle, plus which of its corners.
pub(super) struct Fans(Buckets);

impl Fans {
    /// `None` if a corner has no vertex, or there are too many corners.
    pub(super) fn new(vertices: usize, triangles: &[Triangle]) -> Option<Fans> {
        Some(Fans(Buckets::new(vertices, triangles.iter().flatten().copied())?))
    }

    /// The corners at a vertex: number of the triangle, and which of its corners.
    pub(super) fn at(&self, vertex: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.0.of(vertex).iter().map(|&corner| (corner as usize / 3, corner as usize % 3))
    }

    /// The same with the corners at every vertex sorted by the vertices that their triangles run to from there.
    pub(super) fn sorted(vertices: usize, triangles: &[Triangle]) -> Option<Fans> {
        let mut fans = Fans::new(vertices, triangles)?;
        for corners in fans.0.each_mut() {
            corners.sort_unstable_by_key(|&corner| (next(triangles, corner), corner));
        }
        Some(fans)
    }

    /// The numbers of the triangles along a side, in their order; of [sorted](Fans::sorted) corners.
    pub(super) fn along(
        &self,
        triangles: &[Triangle],
        [from, to]: [usize; 2],
    ) -> impl Iterator<Item = usize> {
        let corners = self.0.of(from);
        let first = corners.partition_point(|&corner| next(triangles, corner) < to);
        let after = corners.partition_point(|&corner| next(triangles, corner) <= to);
        corners.get(first..after).unwrap_or_default().iter().map(|&corner| corner as usize / 3)
    }
}

/// The vertex that a triangle runs to from a corner.
fn next(triangles: &[Triangle], corner: u32) -> usize {
    triangles.get(corner as usize / 3).map_or(0, |corners| corners[(corner as usize + 1) % 3])
}

/// The Euler characteristic of a closed surface of so many vertices; see
/// [`Mesh::closed_characteristic`](super::Mesh::closed_characteristic).
pub(super) fn characteristic(vertices: usize, triangles: &[Triangle]) -> Option<i64> {
    if !may_be_closed(vertices, triangles) {
        return None;
    }
    let fans = Fans::new(vertices, triangles)?;
    // From a neighbour of this vertex to the next one around it, where the mark is this vertex' own.
    let mut next = vec![(0_u32, 0_usize); vertices];
    for (mark, vertex) in (1..).zip(0..vertices) {
        let (mut count, mut first) = (0_usize, None);
        for (triangle, corner) in fans.at(vertex) {
            let corners = triangles.get(triangle)?;
            let (from, to) = (corners[(corner + 1) % 3], corners[(corner + 2) % 3]);
            let slot = next.get_mut(from)?;
            if slot.0 == mark {
                return None;
            }
            *slot = (mark, to);
            (count, first) = (count + 1, Some(from));
        }
        let first = first?;
        let after = |neighbour: usize| next.get(neighbour).filter(|it| it.0 == mark).map(|it| it.1);
        let (mut steps, mut neighbour) = (1, after(first)?);
        while neighbour != first && steps <= count {
            neighbour = after(neighbour)?;
            steps += 1;
        }
        if steps != count {
            return None;
        }
    }
    // Every edge is there twice, once from each of its ends.
    let [vertices, edges, faces] = [vertices, 3 * triangles.len() / 2, triangles.len()];
    Some(vertices as i64 - edges as i64 + faces as i64)
}

/// Whether at every vertex the neighbours that its triangles come from are, in sum, those that they go to, as they are
/// all around it. At a simple border they are not, so that most open surfaces are known as such after one look at each
/// of their triangles.
pub(super) fn may_be_closed(vertices: usize, triangles: &[Triangle]) -> bool {
    let mut sums = vec![0_usize; vertices];
    for &[a, b, c] in triangles {
        for (at, from, to) in [(a, b, c), (b, c, a), (c, a, b)] {
            match sums.get_mut(at) {
                Some(sum) => *sum = sum.wrapping_add(to).wrapping_sub(from),
                None => return false,
            }
        }
    }
    sums.iter().all(|&sum| sum == 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashMap;

    /// The same by a map of half edges.
    fn by_half_edges(vertices: usize, triangles: &[Triangle]) -> Option<i64> {
        let mut next = HashMap::new();
        let mut fans = vec![(0, 0); vertices];
        for &[a, b, c] in triangles {
            for (at, from, to) in [(a, b, c), (b, c, a), (c, a, b)] {
                if next.insert((at, from), to).is_some() {
                    return None;
                }
                let fan: &mut (usize, usize) = fans.get_mut(at)?;
                *fan = (fan.0 + 1, from);
            }
        }
        for (at, (count, first)) in fans.into_iter().enumerate() {
            let (mut steps, mut neighbour) = (1, *next.get(&(at, first))?);
            while neighbour != first && steps <= count {
                neighbour = *next.get(&(at, neighbour))?;
                steps += 1;
            }
            if steps != count {
                return None;
            }
        }
        Some(vertices as i64 - next.len() as i64 / 2 + triangles.len() as i64)
    }

    /// A torus of triangles, `n` by `m` cells.
    fn torus([n, m]: [usize; 2]) -> Vec<Triangle> {
        let at = |k: usize, l: usize| k % n * m + l % m;
        let cells = (0..n).flat_map(|k| (0..m).map(move |l| (k, l)));
        cells
            .flat_map(|(k, l)| {
                let [a, b, c, d] = [at(k, l), at(k + 1, l), at(k + 1, l + 1), at(k, l + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect()
    }

    #[test]
    fn tori_and_a_tetrahedron_are_closed() {
        assert_eq!(characteristic(20, &torus([4, 5])), Some(0));
        assert_eq!(characteristic(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]), Some(2));
        // A vertex of no triangle, a corner of no vertex.
        assert_eq!(characteristic(21, &torus([4, 5])), None);
        assert_eq!(characteristic(19, &torus([4, 5])), None);
    }

    proptest! {
        /// A torus with some triangles away, turned, twice there or joined elsewhere.
        #[test]
        fn agrees_with_half_edges(
            size in [3_usize..6, 3_usize..6],
            changes in prop::collection::vec((0..4, 0_usize..99, 0_usize..99), 0..3),
        ) {
            let (vertices, mut triangles) = (size[0] * size[1], torus(size));
            for (kind, which, vertex) in changes {
                let which = which % triangles.len();
                match kind {
                    0 => drop(triangles.remove(which)),
                    1 => triangles[which].swap(0, 1),
                    2 => triangles.push(triangles[which]),
                    _ => triangles.iter_mut().flatten().filter(|it| **it == which % vertices).for_each(|it| *it = vertex % vertices),
                }
            }
            triangles.retain(|[a, b, c]| a != b && b != c && c != a);
            prop_assert_eq!(characteristic(vertices, &triangles), by_half_edges(vertices, &triangles));
        }

        #[test]
        fn agrees_on_any_triangles(triangles in prop::collection::vec([0_usize..5, 0_usize..5, 0_usize..5], 0..9)) {
            let triangles: Vec<_> = triangles.into_iter().filter(|[a, b, c]| a != b && b != c && c != a).collect();
            prop_assert_eq!(characteristic(5, &triangles), by_half_edges(5, &triangles));
        }
    }
}
