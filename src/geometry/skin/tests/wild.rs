//! Circles that nobody would draw: nothing panics, nothing is NaN, and errors say what is wrong.

use super::*;
use crate::geometry::ParamCurve;
use proptest::prelude::*;

/// Coordinates that coincide, are tiny, or huge.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-3_i32..4).prop_map(f64::from),
        2 => -10.0..10.0,
        1 => prop::sample::select(vec![1e-300, 5e-324, 1e-160, 1e-9, -1e-9, 1e9, 1e150, -1e150, 1e77, 0.1 + 0.2]),
    ]
}

fn radius() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (1_i32..5).prop_map(f64::from),
        2 => 0.01..5.0,
        1 => prop::sample::select(vec![5e-324, 1e-300, 1e-160, 1e-9, 1e9, 1e80, 1e150]),
    ]
}

fn anything() -> impl Strategy<Value = Circles> {
    let disc = (coordinate(), coordinate(), radius()).prop_map(|(x, y, r)| Circle::new([x, y], r));
    let edges = prop::collection::vec([0_usize..8, 0_usize..8], 0..14);
    (prop::collection::vec(disc, 1..9), 0..3, edges).prop_map(|(circles, kind, edges)| {
        let count = circles.len();
        let mut good: Vec<[usize; 2]> = edges
            .into_iter()
            .map(|[a, b]| [a.min(b), a.max(b)])
            .filter(|[a, b]| a != b && *b < count)
            .collect();
        good.sort_unstable();
        good.dedup();
        let links = match kind {
            0 => Links::Chain,
            1 if count > 2 => Links::Ring,
            _ => Links::Edges(good),
        };
        Circles::new(circles, links).unwrap()
    })
}

fn finite(points: impl IntoIterator<Item = [f64; 2]>) -> bool {
    points.into_iter().flatten().all(f64::is_finite)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn nothing_is_nan(circles in anything()) {
        for clearing in [Clearing::Plain, Clearing::Scaled] {
            let skin = circles.skin(clearing);
            prop_assert!(finite(skin.touches.iter().flat_map(|touch| [touch.point, touch.normal])));
            for outline in &skin.loops {
                prop_assert!(!outline.pieces.is_empty());
                for span in 0..outline.spans() {
                    for u in [0.0, 0.3, 0.5, 1.0] {
                        prop_assert!(outline.eval(span, u).is_some_and(|point| finite([point])));
                    }
                    // Pieces hang together.
                    if span > 0 || outline.closed {
                        let before = (span + outline.spans() - 1) % outline.spans();
                        prop_assert_eq!(outline.eval(before, 1.0), outline.eval(span, 0.0));
                    }
                }
            }
            prop_assert_eq!(skin.is_whole(), skin.missing.is_empty());
            let _ = (skin.sides(), skin.side_arcs(Side::Left), skin.side_arcs(Side::Right), skin.unclear());
        }
        prop_assert!(finite(circles.power_points().iter().map(|found| found.point)));
        prop_assert!(finite(circles.radical_lines().iter().flat_map(|line| [line.point, line.direction])));
        for figure in circles.apollonius() {
            prop_assert!(finite([figure.touch]));
            match figure.shape {
                TouchingShape::Circle(circle) => prop_assert!(finite([circle.center, [circle.radius; 2]])),
                TouchingShape::Line(direction) => prop_assert!(finite([direction])),
            }
        }
        let _ = (circles.violations(), circles.check_tree());
    }
}

#[test]
fn wrong_circles_are_refused() {
    let good = Circle::new([0.0; 2], 1.0);
    let chain = |circle: Circle| Circles::chain(vec![good, circle]);
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e151] {
        let refused = chain(Circle::new([0.0; 2], radius));
        assert!(matches!(refused, Err(SkinError::Radius { number: 2, .. })), "{refused:?}");
    }
    for x in [f64::NAN, f64::NEG_INFINITY, 1e151] {
        let refused = chain(Circle::new([0.0, x], 1.0));
        assert!(matches!(refused, Err(SkinError::Center { number: 2, .. })), "{refused:?}");
    }
    assert_eq!(Circles::chain(vec![]), Err(SkinError::TooFew { shape: "skin", given: 0, needed: 1 }));
    let many = vec![good; MAX_BALLS + 1];
    assert_eq!(Circles::chain(many), Err(SkinError::TooMany { given: MAX_BALLS + 1 }));
    let ring = Circles::new(vec![good; 2], Links::Ring);
    assert_eq!(ring.unwrap_err().to_string(), "too few for a ring: 2 given, at least 3 needed");
}

#[test]
fn wrong_edges_are_refused() {
    let linked = |edges: &[[usize; 2]]| {
        let row = (0..4).map(|k| Circle::new([4.0 * f64::from(k), 0.0], 1.0)).collect();
        Circles::new(row, Links::Edges(edges.to_vec()))
    };
    let error = |edges: &[[usize; 2]]| linked(edges).unwrap_err();
    assert_eq!(
        error(&[[0, 1], [1, 4]]).to_string(),
        "edge 2 names number 4, but there are 4, numbered from 0"
    );
    assert_eq!(error(&[[2, 2]]), SkinError::ToItself { edge: 0, circle: 2 });
    assert_eq!(error(&[[0, 1], [1, 2], [1, 0]]), SkinError::Doubled { edge: 2, circles: [1, 0] });
    // What is no tree can be drawn all the same.
    let cycle = linked(&[[0, 1], [1, 2], [2, 0], [2, 3]]).unwrap();
    assert_eq!(cycle.check_tree(), Err(SkinError::Cycle { edge: 2, circles: [2, 0] }));
    let parts = linked(&[[0, 1], [2, 3]]).unwrap();
    assert_eq!(parts.check_tree(), Err(SkinError::NotConnected { circle: 2 }));
    assert_eq!(parts.skin(Clearing::Scaled).loops.len(), 2);
    assert_eq!(linked(&[[3, 2], [1, 2], [1, 0]]).unwrap().check_tree(), Ok(()));
    let many: Vec<[usize; 2]> = vec![[0, 1]; MAX_EDGES + 1];
    assert_eq!(error(&many), SkinError::TooManyEdges { given: MAX_EDGES + 1 });
}

#[test]
fn what_is_not_admissible_has_the_skin_that_exists() {
    let rows = |rows: &[[f64; 3]]| Circles::chain(discs(rows)).unwrap();
    // The second disc lies in the first: nothing between them, the arcs behind are there.
    let swallowed = rows(&[[0.0, 0.0, 3.0], [1.0, 0.0, 1.0], [6.0, 0.0, 2.0], [12.0, 0.0, 2.0]]);
    let skin = swallowed.skin(Clearing::Scaled);
    assert!(!skin.is_whole() && skin.missing.contains(&1));
    assert_eq!(skin.side_arcs(Side::Left).iter().map(|arc| arc.circles).collect::<Vec<_>>(), [[2, 3]]);
    assert!(skin.loops.iter().all(|outline| !outline.closed));
    // Rule 3 is broken, but the skin is whole.
    let bent = rows(&[[0.0, 0.0, 2.0], [1.5, 3.0, 1.0], [3.0, 0.0, 2.0]]);
    assert!(!bent.is_admissible() && bent.skin(Clearing::Scaled).is_whole());
    // One disc alone has no outline, equal ones have none either, and no radii make them admissible.
    assert!(rows(&[[0.0, 0.0, 1.0]]).skin(Clearing::Scaled).loops.is_empty());
    let equal = rows(&[[1.0, 1.0, 2.0], [1.0, 1.0, 2.0], [1.0, 1.0, 2.0]]);
    assert!(equal.skin(Clearing::Scaled).loops.is_empty());
    assert_eq!(equal.violations().len(), 3);
    assert_eq!(equal.nearest_admissible(), None);
}

#[test]
fn a_branch_that_cannot_be_touched_is_passed() {
    // The arms of a small joint are so wide that they cover its touching points.
    let star = discs(&[[0.0, 0.0, 0.5], [3.0, 0.0, 2.0], [-1.5, 2.6, 2.0], [-1.5, -2.6, 2.0]]);
    let star = Circles::new(star, Links::Edges(vec![[0, 1], [0, 2], [0, 3]])).unwrap();
    let skin = star.skin(Clearing::Scaled);
    assert!(skin.is_whole());
    let touched = skin.touches.iter().filter(|touch| touch.circle == 0).count();
    assert_eq!(touched + skin.skipped.len(), 3);
}

#[test]
fn a_net_with_cycles_has_an_outline_for_every_boundary() {
    // Two squares with a common side.
    let places = [[0.0, 0.0], [6.0, 0.0], [12.0, 0.0], [12.0, 6.0], [6.0, 6.0], [0.0, 6.0]];
    let circles = places.map(|place| Circle::new(place, 1.0)).to_vec();
    let mut edges: Vec<[usize; 2]> = (0..6).map(|k| [k, (k + 1) % 6]).collect();
    edges.push([1, 4]);
    let skin = Circles::new(circles, Links::Edges(edges)).unwrap().skin(Clearing::Scaled);
    assert!(skin.is_whole() && skin.unclear().is_empty());
    assert_eq!(skin.loops.len(), 3);
}
