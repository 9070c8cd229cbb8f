//! The values of the table.

use super::reference::{CHAINS, RULES, SPHERES, TREES};
use super::*;

/// The largest coordinate or radius, by which errors are measured.
fn size(rows: &[[f64; 3]]) -> f64 {
    rows.iter().flatten().fold(1.0, |size, x| size.max(x.abs()))
}

#[test]
fn touching_points_and_plain_arcs_are_those_of_the_table() {
    for (rows, closed, points, arcs) in CHAINS {
        let links = if *closed { Links::Ring } else { Links::Chain };
        let circles = Circles::new(discs(rows), links).unwrap();
        let skin = circles.skin(Clearing::Plain);
        assert!(skin.is_whole() && skin.skipped.is_empty());
        assert_eq!(skin.loops.len(), if *closed { 2 } else { 1 });
        let near = |a: [f64; 2], b: [f64; 2]| apart(a, b) < 1e-13 * size(rows);
        for (touch, (left, right)) in skin.sides().iter().zip(points[0].iter().zip(points[1])) {
            assert!(
                near(touch[0].unwrap(), *left) && near(touch[1].unwrap(), *right),
                "{touch:?} {left:?} {right:?}"
            );
        }
        for (side, expected) in [Side::Left, Side::Right].into_iter().zip(arcs) {
            let found = skin.side_arcs(side);
            assert_eq!(found.len(), expected.len());
            for (k, (arc, expected)) in found.iter().zip(*expected).enumerate() {
                assert_eq!(arc.circles, [k, (k + 1) % rows.len()]);
                assert!(arc.bezier.p.iter().zip(expected).all(|(a, b)| near(*a, *b)), "{arc:?} {expected:?}");
            }
        }
    }
}

#[test]
fn broken_rules_are_those_of_the_table() {
    for (rows, expected) in RULES {
        let circles = Circles::chain(discs(rows)).unwrap();
        let mut rules: Vec<u8> = circles.violations().iter().map(Violation::rule).collect();
        assert!(rules.is_sorted());
        rules.dedup();
        assert_eq!(&rules, expected, "{rows:?}");
        assert_eq!(circles.is_admissible(), expected.is_empty());
    }
}

#[test]
fn outlines_of_trees_are_those_of_the_table() {
    for (rows, edges, expected, pieces) in TREES {
        let circles = Circles::new(discs(rows), Links::Edges(edges.to_vec())).unwrap();
        assert_eq!(circles.check_tree(), Ok(()));
        let skin = circles.skin(Clearing::Plain);
        let [outline] = skin.loops.as_slice() else { panic!("one outline") };
        assert!(outline.closed && skin.is_whole());
        assert_eq!(outline.pieces.len(), *pieces);
        let mut points: Vec<(usize, [f64; 2])> =
            outline.arcs().map(|arc| (arc.circles[0], arc.bezier.p[0])).collect();
        points.sort_by(|a, b| a.0.cmp(&b.0).then(a.1[0].total_cmp(&b.1[0])));
        assert_eq!(points.len(), expected.len());
        for (found, expected) in points.iter().zip(*expected) {
            assert_eq!(found.0, expected.0);
            assert!(apart(found.1, expected.1) < 1e-13 * size(rows), "{found:?} {expected:?}");
        }
    }
}

#[test]
fn cleared_arcs_keep_out_of_the_discs_of_the_table() {
    let chains =
        CHAINS.iter().map(|(rows, closed, ..)| (rows, if *closed { Links::Ring } else { Links::Chain }));
    let trees = TREES.iter().map(|(rows, edges, ..)| (rows, Links::Edges(edges.to_vec())));
    for (rows, links) in chains.chain(trees) {
        let circles = Circles::new(discs(rows), links).unwrap();
        let skin = circles.skin(Clearing::Scaled);
        let arcs: Vec<&SkinArc> = skin.loops.iter().flat_map(Outline::arcs).collect();
        assert!(10 * skin.unclear().len() <= arcs.len());
        for arc in arcs.iter().filter(|arc| arc.clear) {
            for t in (0..=80).map(|k| f64::from(k) / 80.0) {
                let point = arc.bezier.eval(t);
                let deep =
                    arc.circles.map(|k| circles.circles()[k]).map(|disc| disc.radius - disc.distance(point));
                assert!(deep.iter().all(|deep| *deep < 1e-8 * size(rows)));
            }
        }
    }
}

#[test]
fn touching_circles_are_those_of_the_table() {
    for (rows, expected) in SPHERES {
        let spheres = rows.iter().map(|[x, y, z, r]| Sphere::new([*x, *y, *z], *r)).collect();
        let spheres = Spheres::chain(spheres).unwrap();
        assert!(spheres.is_admissible());
        let skin = spheres.skin(Clearing::Plain);
        assert!(skin.is_whole() && skin.unclear().is_empty());
        let found = skin.circles();
        assert_eq!(found.len(), expected.len());
        for (number, (found, (center, axis, radius))) in found.iter().zip(*expected).enumerate() {
            assert_eq!(found.sphere, number);
            assert!(apart(found.center, *center) < 1e-13 && apart(found.axis, *axis) < 1e-13, "{found:?}");
            assert!((found.radius - radius).abs() < 1e-13);
        }
    }
}

/// The samples of the program, in their own unit.
#[test]
fn samples_are_admissible_and_clear() {
    let round = |degrees: f64, [x, y]: [f64; 2], far: f64, radius: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Circle::new([x + far * cosine, y + far * sine], radius)
    };
    let chain = |rows: &[[f64; 3]]| Circles::chain(discs(rows)).unwrap();
    let snake = chain(&[[0.0, 0.0, 1.0], [3.0, 1.0, 1.4], [6.0, 0.5, 0.8], [8.5, 2.5, 1.2], [9.0, 6.0, 1.0]]);
    let hand = chain(&[
        [0.0, 0.0, 3.0],
        [4.0, 2.0, 1.2],
        [6.5, 4.0, 1.0],
        [9.0, 5.0, 1.5],
        [12.0, 4.0, 0.9],
        [14.5, 2.5, 1.1],
        [17.0, 2.6, 0.5],
    ]);
    let overlapping = chain(&[[0.0, 0.0, 2.0], [2.0, 0.3, 2.0], [3.6, 0.0, 2.0], [6.5, 0.5, 1.5]]);
    let mut fork = vec![Circle::new([8.0, 4.0], 1.5)];
    for arm in [20.0, 140.0, 260.0] {
        fork.extend([round(arm, [8.0, 4.0], 3.2, 0.9), round(arm, [8.0, 4.0], 5.4, 0.6)]);
    }
    let edges = vec![[0, 1], [1, 2], [0, 3], [3, 4], [0, 5], [5, 6]];
    let fork = Circles::new(fork, Links::Edges(edges)).unwrap();
    let ring =
        (0..8_u32).map(|k| round(45.0 * f64::from(k), [8.0, 3.0], 5.0, if k % 2 == 0 { 1.2 } else { 1.8 }));
    let ring = Circles::new(ring.collect(), Links::Ring).unwrap();
    for circles in [snake, hand, overlapping, fork, ring] {
        let skin = circles.skin(Clearing::Scaled);
        assert!(circles.is_admissible() && skin.is_whole() && skin.unclear().is_empty(), "{circles:?}");
    }
    let bad = chain(&[[0.0, 0.0, 2.0], [1.5, 3.0, 1.0], [3.0, 0.0, 2.0]]);
    assert_eq!(bad.violations(), [Violation::MeetOutside { numbers: [0, 2], middle: 1 }]);
    let near = bad.nearest_admissible().unwrap();
    assert!(near.circles()[1] == bad.circles()[1] && near.circles()[0].radius < 1.5);
    let snail = [
        [0.0, 0.0, 0.0, 1.0],
        [3.0, 1.0, 0.5, 1.3],
        [6.0, 0.5, 2.0, 0.9],
        [8.0, 2.5, 4.0, 1.2],
        [8.5, 6.0, 5.0, 0.7],
    ];
    let snail = Spheres::chain(snail.map(|[x, y, z, r]| Sphere::new([x, y, z], r)).to_vec()).unwrap();
    let skin = snail.skin(Clearing::Scaled);
    assert!(snail.is_admissible() && skin.is_whole() && skin.unclear().is_empty());
}
