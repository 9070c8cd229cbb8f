//! Edits of circles that hang together: the links follow.

use crate::file::Circles;
use crate::geometry::skin::MAX_BALLS;

/// A circle: centre and radius.
pub(super) type Row = [f64; 3];

/// Two circles as an edge, the smaller number first.
fn edge(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// Whether there is no room for another circle.
pub(super) fn is_full(value: &Circles) -> bool {
    value.circles.len() >= MAX_BALLS
}

/// The pairs of neighbours.
pub(super) fn edges(value: &Circles) -> Vec<[usize; 2]> {
    if let Some(edges) = &value.edges {
        return edges.clone();
    }
    let count = value.circles.len();
    let along = (1..count).map(|at| [at - 1, at]);
    let closing = (value.closed && count > 2).then(|| [0, count.saturating_sub(1)]);
    along.chain(closing).collect()
}

/// With other edges. Those of a chain or a ring in the order of the numbers are one, for which the rules are milder.
fn with_edges(value: &Circles, edges: Vec<[usize; 2]>) -> Circles {
    let mut sorted: Vec<[usize; 2]> = edges.iter().map(|&[a, b]| edge(a, b)).collect();
    sorted.sort_unstable();
    for closed in [false, true] {
        let plain = Circles { circles: value.circles.clone(), closed, edges: None };
        let mut own = self::edges(&plain);
        own.sort_unstable();
        if own == sorted {
            return settled(plain);
        }
    }
    Circles { circles: value.circles.clone(), closed: false, edges: Some(edges) }
}

/// A ring of less than three is a chain.
fn settled(value: Circles) -> Circles {
    Circles { closed: value.closed && value.circles.len() > 2, ..value }
}

/// With a circle at another place or of another size.
pub(super) fn with_circle(value: &Circles, index: usize, row: Row) -> Circles {
    let mut value = value.clone();
    if let Some(place) = value.circles.get_mut(index) {
        *place = row;
    }
    value
}

/// With a circle behind the last; in a tree it is linked to the nearest.
pub(super) fn appended(value: &Circles, row: Row) -> Circles {
    if is_full(value) {
        return value.clone();
    }
    let mut value = value.clone();
    let index = value.circles.len();
    let [x, y, _] = row;
    let far = |[a, b, r]: &Row| (x - a).hypot(y - b) - r;
    let nearest = (0..index).min_by(|&i, &j| far(&value.circles[i]).total_cmp(&far(&value.circles[j])));
    if let (Some(edges), Some(nearest)) = (&mut value.edges, nearest) {
        edges.push([nearest, index]);
    }
    value.circles.push(row);
    value
}

/// With a circle before the one at an index of a chain or ring.
pub(super) fn inserted(value: &Circles, index: usize, row: Row) -> Circles {
    if is_full(value) || value.edges.is_some() {
        return appended(value, row);
    }
    let mut value = value.clone();
    value.circles.insert(index.min(value.circles.len()), row);
    value
}

/// With a circle between two neighbours: of a chain or ring the numbers behind it shift, of a tree it is the last.
/// `None` if they are none.
pub(super) fn between(value: &Circles, [a, b]: [usize; 2], row: Row) -> Option<Circles> {
    let edges = edges(value);
    let at = edges.iter().position(|&[c, d]| edge(c, d) == edge(a, b))?;
    if is_full(value) {
        return None;
    }
    if value.edges.is_none() {
        let [first, last] = edge(a, b);
        return Some(inserted(value, if last - first == 1 { last } else { value.circles.len() }, row));
    }
    let (mut circles, mut edges, new) = (value.circles.clone(), edges, value.circles.len());
    circles.push(row);
    edges[at] = [a, new];
    edges.push([new, b]);
    Some(Circles { circles, closed: false, edges: Some(edges) })
}

/// The circle halfway between two others.
pub(super) fn halfway(value: &Circles, [a, b]: [usize; 2]) -> Option<Row> {
    let (a, b) = (value.circles.get(a)?, value.circles.get(b)?);
    Some(std::array::from_fn(|d| 0.5 * a[d] + 0.5 * b[d]))
}

/// Without a circle; its neighbours in a tree become neighbours of the first of them.
pub(super) fn deleted(value: &Circles, index: usize) -> Circles {
    if index >= value.circles.len() {
        return value.clone();
    }
    let mut circles = value.circles.clone();
    circles.remove(index);
    let plain = Circles { circles, closed: value.closed, edges: None };
    let Some(edges) = &value.edges else { return settled(plain) };
    let of_it = |&[a, b]: &[usize; 2]| if a == index { Some(b) } else { Some(a).filter(|_| b == index) };
    let neighbours: Vec<usize> = edges.iter().filter_map(of_it).collect();
    let bridges = neighbours.iter().skip(1).map(|&other| [neighbours[0], other]);
    let mut kept: Vec<[usize; 2]> = edges.iter().filter(|edge| of_it(edge).is_none()).copied().collect();
    for [a, b] in bridges {
        // In a cycle they may be neighbours already.
        if !kept.iter().any(|&[c, d]| edge(c, d) == edge(a, b)) {
            kept.push([a, b]);
        }
    }
    let renumbered = kept.into_iter().map(|ends| ends.map(|end| end - usize::from(end > index)));
    with_edges(&plain, renumbered.collect())
}

/// Two circles linked, or, if they were, no longer; and whether they are now.
pub(super) fn linked(value: &Circles, [a, b]: [usize; 2]) -> (Circles, bool) {
    let mut edges = edges(value);
    let before = edges.len();
    edges.retain(|&[c, d]| edge(c, d) != edge(a, b));
    let links = edges.len() == before;
    if links {
        edges.push(edge(a, b));
    }
    (with_edges(value, edges), links)
}

/// A chain as a ring, and anything else as a chain; a tree becomes a ring in the order of its numbers.
pub(super) fn as_ring(value: &Circles) -> Circles {
    let closed = value.edges.is_some() || !value.closed;
    settled(Circles { circles: value.circles.clone(), closed, edges: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circles(count: u8, edges: Option<&[[usize; 2]]>) -> Circles {
        let circles = (0..count).map(|k| [10.0 * f64::from(k), 0.0, 4.0]).collect();
        Circles { circles, closed: false, edges: edges.map(<[_]>::to_vec) }
    }

    #[test]
    fn links_that_are_a_chain_again_are_one() {
        let chain = circles(4, None);
        let (fork, linked_now) = linked(&chain, [1, 3]);
        assert!(linked_now);
        assert_eq!(fork.edges.as_ref().map(Vec::len), Some(4));
        let (again, linked_now) = linked(&fork, [3, 1]);
        assert!(!linked_now);
        assert_eq!(again, chain);
        let (ring, _) = linked(&chain, [3, 0]);
        assert_eq!((ring.closed, &ring.edges), (true, &None));
        assert_eq!(linked(&ring, [0, 3]).0, chain);
    }

    #[test]
    fn a_tree_stays_one_when_a_circle_goes() {
        let fork = circles(5, Some(&[[0, 1], [1, 2], [1, 3], [3, 4]]));
        // What is a chain then is none in the order of its numbers.
        assert_eq!(deleted(&fork, 1).edges, Some(vec![[2, 3], [0, 1], [0, 2]]));
        assert_eq!(deleted(&fork, 4).edges, Some(vec![[0, 1], [1, 2], [1, 3]]));
        assert_eq!(deleted(&fork, 3).edges, Some(vec![[0, 1], [1, 2], [1, 3]]));
        assert_eq!(deleted(&fork, 9), fork);
    }

    #[test]
    fn new_circles_find_their_place() {
        let fork = circles(4, Some(&[[0, 1], [1, 2], [1, 3]]));
        assert_eq!(appended(&fork, [31.0, 5.0, 2.0]).edges.unwrap()[3], [3, 4]);
        let split = between(&fork, [3, 1], [1.0, 2.0, 3.0]).unwrap();
        assert_eq!(split.edges, Some(vec![[0, 1], [1, 2], [3, 4], [4, 1]]));
        assert_eq!(between(&fork, [0, 3], [1.0, 2.0, 3.0]), None);
        let chain = circles(3, None);
        assert_eq!(between(&chain, [2, 1], [1.0, 2.0, 3.0]).unwrap().circles[2], [1.0, 2.0, 3.0]);
        let ring = as_ring(&chain);
        assert_eq!(between(&ring, [2, 0], [1.0, 2.0, 3.0]).unwrap().circles[3], [1.0, 2.0, 3.0]);
        assert_eq!(halfway(&chain, [0, 2]), Some([10.0, 0.0, 4.0]));
        assert_eq!(deleted(&ring, 0), circles_of(&ring, 1));
    }

    fn circles_of(value: &Circles, from: usize) -> Circles {
        Circles { circles: value.circles[from..].to_vec(), closed: false, edges: None }
    }

    #[test]
    fn rings_come_and_go() {
        let chain = circles(3, None);
        assert_eq!(as_ring(&as_ring(&chain)), chain);
        assert!(!as_ring(&circles(2, None)).closed);
        let tree = circles(4, Some(&[[0, 1], [0, 2], [0, 3]]));
        assert!(as_ring(&tree).closed);
    }
}
