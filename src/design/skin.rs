//! Circles and spheres with a skin as documents, and back.

use crate::file;
use crate::geometry::skin::{Circle, Circles, Links, Outline, Piece, Skin, SkinError, Sphere, Spheres};

/// The circles of a document.
///
/// # Errors
/// Those of [`Circles::new`].
pub fn circles(document: &file::Circles) -> Result<Circles, SkinError> {
    let balls = document.circles.iter().map(|&[x, y, r]| Circle::new([x, y], r)).collect();
    let links = match &document.edges {
        Some(edges) => Links::Edges(edges.clone()),
        None if document.closed => Links::Ring,
        None => Links::Chain,
    };
    Circles::new(balls, links)
}

/// The document of circles.
#[must_use]
pub fn document(circles: &Circles) -> file::Circles {
    let row = |circle: &Circle| [circle.center[0], circle.center[1], circle.radius];
    file::Circles {
        circles: circles.circles().iter().map(row).collect(),
        closed: *circles.links() == Links::Ring,
        edges: match circles.links() {
            Links::Edges(edges) => Some(edges.clone()),
            Links::Chain | Links::Ring => None,
        },
    }
}

/// The spheres of a document.
///
/// # Errors
/// Those of [`Spheres::new`].
pub fn spheres(document: &file::Spheres) -> Result<Spheres, SkinError> {
    let balls = document.spheres.iter().map(|&[x, y, z, r]| Sphere::new([x, y, z], r)).collect();
    Spheres::new(balls, document.chains.clone().unwrap_or_default(), document.closed)
}

/// The outlines of a skin, with the caps of the end circles or open at them.
#[must_use]
pub fn outlines(skin: &Skin, caps: bool) -> Vec<Outline> {
    if caps { skin.loops.clone() } else { skin.loops.iter().flat_map(without_caps).collect() }
}

fn without_caps(outline: &Outline) -> Vec<Outline> {
    let is_cap = |piece: &Piece| matches!(piece, Piece::Cap(_));
    let Some(first) = outline.pieces.iter().position(is_cap) else { return vec![outline.clone()] };
    // A closed outline goes on behind its last piece with its first.
    let start = if outline.closed { first } else { 0 };
    let (head, tail) = outline.pieces.split_at(start);
    let pieces = [tail, head].concat();
    let runs = pieces.split(is_cap).filter(|run| !run.is_empty());
    runs.map(|run| Outline { pieces: run.to_vec(), closed: false }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ParamCurve;
    use crate::geometry::skin::Clearing;

    #[test]
    fn documents_come_back() {
        let rows = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.5], [2.0, 4.0, 1.0]];
        let chain = file::Circles { circles: rows, closed: false, edges: None };
        let ring = file::Circles { closed: true, ..chain.clone() };
        let tree = file::Circles { edges: Some(vec![[0, 1], [0, 2]]), ..chain.clone() };
        for given in [chain, ring, tree] {
            assert_eq!(document(&circles(&given).unwrap()), given);
        }
        assert!(circles(&file::Circles::default()).is_err());
    }

    #[test]
    fn a_chain_without_caps_has_two_sides() {
        let rows = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.5], [8.0, 1.0, 1.0]];
        let chain = file::Circles { circles: rows, closed: false, edges: None };
        let skin = circles(&chain).unwrap().skin(Clearing::Scaled);
        assert_eq!(outlines(&skin, true), skin.loops);
        let open = outlines(&skin, false);
        assert_eq!(open.iter().map(ParamCurve::spans).collect::<Vec<_>>(), [2, 2]);
        assert!(open.iter().all(|outline| !outline.closed));
    }
}
