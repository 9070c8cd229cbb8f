//! What holds for all admissible circles, and what the rules mean, by other ways than those of the room.

use super::*;
use crate::geometry::{CubicBezier, ParamCurve, cross};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::f64::consts::{PI, TAU};

/// A chain by turns, distances in sums of radii, and radii.
fn chain_of(steps: &[(f64, f64, f64)]) -> Vec<Circle> {
    let mut circles: Vec<Circle> = Vec::new();
    let mut direction = 0.0;
    for (turn, distance, radius) in steps {
        direction += turn;
        let place = circles.last().map_or([0.0; 2], |last| {
            let away = distance * (last.radius + radius);
            [last.center[0] + away * f64::cos(direction), last.center[1] + away * f64::sin(direction)]
        });
        circles.push(Circle::new(place, *radius));
    }
    circles
}

fn chains() -> impl Strategy<Value = Circles> {
    let steps = prop::collection::vec((-1.1..1.1, 0.6..2.0, 0.4..2.0), 2..9);
    steps.prop_filter_map("admissible", |steps| {
        Circles::chain(chain_of(&steps)).ok().filter(Circles::is_admissible)
    })
}

fn rings() -> impl Strategy<Value = Circles> {
    let spokes = prop::collection::vec((-0.2..0.2, 0.8..1.25, 0.3..1.1), 3..12);
    spokes.prop_filter_map("admissible", |spokes| {
        let step = TAU / spokes.len() as f64;
        let reach = 0.7 / (0.5 * step).sin();
        let circles = spokes.iter().enumerate().map(|(k, (turn, far, radius))| {
            let (sine, cosine) = (step * (k as f64 + turn)).sin_cos();
            Circle::new([reach * far * cosine, reach * far * sine], *radius)
        });
        Circles::new(circles.collect(), Links::Ring).ok().filter(Circles::is_admissible)
    })
}

/// Stars of three to five arms of one to three circles.
fn trees() -> impl Strategy<Value = Circles> {
    let arm = (-0.2..0.2, prop::collection::vec((-0.4..0.4, 0.8..2.0, 0.4..1.2), 1..4));
    (0.8..2.5, prop::collection::vec(arm, 3..6)).prop_filter_map("admissible", |(radius, arms)| {
        let mut circles = vec![Circle::new([0.0; 2], radius)];
        let mut edges = Vec::new();
        let step = TAU / arms.len() as f64;
        for (k, (turn, links)) in arms.iter().enumerate() {
            let mut steps = vec![(step * (k as f64 + turn), 0.0, radius)];
            steps.extend(links);
            let mut last = 0;
            for circle in chain_of(&steps).into_iter().skip(1) {
                edges.push([last, circles.len()]);
                last = circles.len();
                circles.push(circle);
            }
        }
        Circles::new(circles, Links::Edges(edges)).ok().filter(Circles::is_admissible)
    })
}

fn any_shape() -> impl Strategy<Value = Circles> {
    prop_oneof![chains(), rings(), trees()]
}

/// Whether samples say of an arc what it says of itself. One that enters a disc by less than they show hugs it.
fn agrees(arc: &SkinArc, circles: &[Circle]) -> bool {
    let places = (1..200).map(|k| arc.bezier.eval(f64::from(k) / 200.0));
    let deep =
        |point: [f64; 2]| circles.iter().map(|disc| disc.radius - disc.distance(point)).fold(-1.0, f64::max);
    let deepest = places.map(deep).fold(-1.0, f64::max);
    if arc.clear { deepest < 1e-9 } else { deepest > -1e-5 }
}

/// The unit tangents of a piece at its beginning and end.
fn tangents_of(outline: &Outline, span: usize) -> [[f64; 2]; 2] {
    [0.0, 1.0].map(|u| {
        let [_, tangent, _] = outline.at(span, u).unwrap();
        tangent.map(|x| x / norm(tangent))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn skins_of_admissible_circles_keep_their_promises(circles in any_shape()) {
        let discs = circles.circles();
        let skin = circles.skin(Clearing::Scaled);
        prop_assert!(skin.is_whole());
        let loops = if *circles.links() == Links::Ring { 2 } else { 1 };
        prop_assert_eq!(skin.loops.len(), loops);
        for touch in &skin.touches {
            let disc = &discs[touch.circle];
            prop_assert!((disc.distance(touch.point) - disc.radius).abs() < 1e-12);
            prop_assert!((norm(touch.normal) - 1.0).abs() < 1e-14);
            let inside = discs.iter().filter(|other| other.contains(touch.point, -1e-9)).count();
            prop_assert_eq!(inside, 0);
        }
        for outline in &skin.loops {
            let count = outline.spans();
            for span in 0..count {
                let next = (span + 1) % count;
                let joint = [(span, 1.0), (next, 0.0)].map(|(span, u)| outline.eval(span, u).unwrap());
                prop_assert_eq!(joint[0], joint[1]);
                let (before, behind) = (tangents_of(outline, span)[1], tangents_of(outline, next)[0]);
                prop_assert!(apart(before, behind) < 1e-9, "{:?} {:?}", before, behind);
            }
        }
        let arcs: Vec<&SkinArc> = skin.loops.iter().flat_map(Outline::arcs).collect();
        for arc in &arcs {
            prop_assert!(agrees(arc, discs), "{arc:?}");
        }
        // Plain arcs have the same ends.
        let plain = circles.skin(Clearing::Plain);
        for (a, b) in plain.loops.iter().flat_map(Outline::arcs).zip(&arcs) {
            prop_assert_eq!([a.bezier.p[0], a.bezier.p[3]], [b.bezier.p[0], b.bezier.p[3]]);
            prop_assert!(agrees(a, discs), "{a:?}");
            prop_assert!(!a.clear || a == *b);
        }
    }

    #[test]
    fn outlines_run_round_their_discs(circles in prop_oneof![chains(), trees()]) {
        // The area on the left, by the polygon of the outline, is that of one loop counterclockwise.
        let skin = circles.skin(Clearing::Scaled);
        let points = skin.loops[0].polyline(32).unwrap();
        let area: f64 = points.windows(2).map(|p| 0.5 * (p[0][0] * p[1][1] - p[0][1] * p[1][0])).sum();
        let largest = circles.circles().iter().map(|disc| disc.radius).fold(0.0, f64::max);
        prop_assert!(area > 0.9 * PI * largest * largest);
    }

    #[test]
    fn apollonius_circles_touch_all_three(circles in any_shape()) {
        let discs = circles.circles();
        let found = circles.apollonius();
        prop_assert!(discs.len() == 2 || !found.is_empty());
        for figure in &found {
            for disc in figure.circles.map(|number| discs[number]) {
                let off = match figure.shape {
                    TouchingShape::Circle(circle) => {
                        let distance = circle.distance(disc.center);
                        let (outside, inside) = (circle.radius + disc.radius, circle.radius - disc.radius);
                        (distance - outside).abs().min((distance - inside).abs()) / circle.radius.max(1.0)
                    }
                    TouchingShape::Line([x, y]) => {
                        let way = scaled_difference(1.0, figure.touch, disc.center);
                        (y * way[0] - x * way[1]).abs() - disc.radius
                    }
                };
                prop_assert!(off.abs() < 1e-9, "{:?} {}", figure, off);
            }
        }
    }

    #[test]
    fn power_points_are_in_none_of_the_discs(circles in prop_oneof![chains(), rings()]) {
        let discs = circles.circles();
        for found in circles.power_points() {
            for disc in found.circles.map(|number| discs[number]) {
                let off = disc.power(found.point) - found.power;
                prop_assert!(off.abs() < 1e-7 * (1.0 + found.power.abs()), "{found:?} {off}");
            }
            // Three that surround a point, as in rings of three, have it outside too.
            prop_assert!(found.power > -1e-9, "{found:?}");
        }
        for line in circles.radical_lines() {
            for t in [-3.0, 0.0, 2.0] {
                let place = [line.point[0] + t * line.direction[0], line.point[1] + t * line.direction[1]];
                let [a, b] = line.circles.map(|number| discs[number].power(place));
                prop_assert!((a - b).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn turned_and_scaled_circles_have_the_turned_and_scaled_skin(
        circles in any_shape(), angle in 0.0..TAU, scale in -6..6, shift in -100.0..100.0
    ) {
        let scale = 10.0_f64.powi(scale);
        let (sine, cosine) = f64::sin_cos(angle);
        let moved = |[x, y]: [f64; 2]| {
            [scale * (cosine * x - sine * y + shift), scale * (sine * x + cosine * y - 2.0 * shift)]
        };
        let there: Vec<Circle> =
            circles.circles().iter().map(|disc| Circle::new(moved(disc.center), scale * disc.radius)).collect();
        let there = Circles::new(there, circles.links().clone()).unwrap();
        let (here, there) = (circles.skin(Clearing::Plain), there.skin(Clearing::Plain));
        // Where neighbours begin to be counted may change, where the points are not.
        for touch in &here.touches {
            let expected = moved(touch.point);
            let nearest = there.touches.iter().map(|other| apart(other.point, expected)).fold(f64::MAX, f64::min);
            prop_assert!(nearest < 1e-9 * scale, "{nearest}");
        }
    }
}

/// Discs that may or may not be admissible.
fn crowds() -> impl Strategy<Value = Vec<Circle>> {
    let disc = (-3.0..3.0, -3.0..3.0, 0.5..2.5);
    let crowd = prop::collection::vec(disc, 2..9)
        .prop_map(|rows| rows.into_iter().map(|(x, y, r)| Circle::new([x, y], r)).collect());
    let chain =
        prop::collection::vec((-1.5..1.5, 0.1..1.3, 0.5..2.0), 3..7).prop_map(|steps| chain_of(&steps));
    prop_oneof![crowd, chain]
}

/// Points of a square grid on a disc, and how far apart they can be from any other point of it.
fn grid(disc: &Circle) -> (Vec<[f64; 2]>, f64) {
    let steps = 120;
    let step = 2.0 * disc.radius / f64::from(steps);
    let at = |k: i32| disc.radius * (2.0 * f64::from(k) / f64::from(steps) - 1.0);
    let places = (0..=steps).flat_map(|k| (0..=steps).map(move |l| [k, l]));
    let places = places.map(|[k, l]| [disc.center[0] + at(k), disc.center[1] + at(l)]);
    (places.filter(|place| disc.contains(*place, 1e-9)).collect(), 1.5 * step)
}

/// Whether some point is surely outside all (`Some(true)`), or surely none is (`Some(false)`), when points are
/// sampled so densely.
fn verdict(farthest: f64, spacing: f64) -> Option<bool> {
    if farthest > 1e-9 { Some(true) } else { (farthest < -spacing).then_some(false) }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn rules_mean_what_samples_say(discs in crowds()) {
        let circles = Circles::chain(discs.clone()).unwrap();
        let found = circles.violations();
        let outside = |point: [f64; 2], disc: &Circle| disc.distance(point) - disc.radius;
        for (i, disc) in discs.iter().enumerate() {
            let (points, spacing) = grid(disc);
            let others = |point: [f64; 2]| {
                let others = discs.iter().enumerate().filter(|(j, _)| *j != i);
                others.map(|(_, other)| outside(point, other)).fold(f64::MAX, f64::min)
            };
            let farthest = points.iter().map(|point| others(*point)).fold(f64::MIN, f64::max);
            if let Some(free) = verdict(farthest, spacing) {
                prop_assert_eq!(found.contains(&Violation::Covered { number: i }), !free, "disc {}", i);
            }
            let [Some(before), Some(behind)] = [i.checked_sub(1), Some(i + 1)].map(|j| discs.get(j?)) else {
                continue;
            };
            // The common part of both neighbours.
            let (points, spacing) = grid(before);
            let farthest = |wider: f64| {
                let common = points.iter().filter(|point| behind.contains(**point, wider));
                common.map(|point| outside(*point, disc)).fold(f64::MIN, f64::max)
            };
            let said = found.contains(&Violation::MeetOutside { numbers: [i - 1, i + 1], middle: i });
            prop_assert!(farthest(0.0) <= 1e-9 || said, "disc {i}");
            // Every common point has a sample near it, perhaps beside the common part.
            prop_assert!(farthest(spacing) >= -spacing || !said, "disc {i}");
        }
        for i in 0..discs.len() {
            for j in i + 3..discs.len() {
                let apart = discs[i].distance(discs[j].center) > discs[i].radius + discs[j].radius;
                prop_assert_eq!(found.contains(&Violation::Meet { numbers: [i, j] }), !apart);
            }
        }
    }

    #[test]
    fn shrunk_circles_are_admissible_and_have_the_same_centres(discs in crowds(), ring: bool) {
        let links = if ring && discs.len() > 2 { Links::Ring } else { Links::Chain };
        let circles = Circles::new(discs, links).unwrap();
        let near = circles.nearest_admissible().unwrap();
        prop_assert!(near.is_admissible());
        prop_assert_eq!(circles.is_admissible(), near == circles);
        for (new, old) in near.circles().iter().zip(circles.circles()) {
            prop_assert!(new.center == old.center && new.radius <= old.radius);
        }
    }
}

/// How many arcs enter a disc, of how many, for a sample of admissible circles.
fn entering(circles: &impl Strategy<Value = Circles>, clearing: Clearing) -> [usize; 2] {
    let mut runner = TestRunner::deterministic();
    let mut sum = [0; 2];
    for _ in 0..400 {
        let skin = circles.new_tree(&mut runner).unwrap().current().skin(clearing);
        sum[0] += skin.unclear().len();
        sum[1] += skin.loops.iter().map(|outline| outline.arcs().count()).sum::<usize>();
    }
    sum
}

#[test]
fn few_arcs_are_plain_and_hardly_any_unclear() {
    let share = |[entering, all]: [usize; 2]| entering as f64 / all as f64;
    let plain = share(entering(&chains(), Clearing::Plain));
    let scaled = share(entering(&chains(), Clearing::Scaled));
    assert!(plain > 0.02 && plain < 0.1, "{plain}");
    assert!(scaled < 0.01, "{scaled}");
    for circles in [rings().boxed(), trees().boxed()] {
        assert!(share(entering(&circles, Clearing::Scaled)) < 0.01);
    }
}

/// Where the exact test is decided by little: arcs that graze a disc from outside and from inside.
#[test]
fn grazing_is_not_entering() {
    let line = CubicBezier { p: [[-3.0, 1.0], [-1.0, 1.0], [1.0, 1.0], [3.0, 1.0]] };
    let graze = |radius: f64| clear::keeps_out(&line, &Circle::new([0.3, 0.0], radius));
    assert!(graze(1.0 - 1e-9) && graze(1.0) && !graze(1.0 + 1e-9));
}

/// The same in space, where no arc of a plane is.
#[test]
fn the_plane_of_an_arc_does_not_matter() {
    let turn = |[x, y]: [f64; 2]| -> [f64; 3] {
        let (a, b) = ([0.6, 0.48, 0.64], [0.0, 0.8, -0.6]);
        assert!(norm(cross(a, b)) > 0.9);
        std::array::from_fn(|d| x * a[d] + y * b[d])
    };
    for bulge in [-0.4, 0.0, 0.3, 0.9, 1.4] {
        let flat = CubicBezier { p: [[-1.0, 0.0], [-1.0, bulge], [1.2, bulge], [1.2, 0.0]] };
        let space = CubicBezier { p: flat.p.map(turn) };
        for radius in [0.2, 0.5, 0.9] {
            let center = [0.1, -0.2];
            let flat = clear::keeps_out(&flat, &Circle::new(center, radius));
            assert_eq!(flat, clear::keeps_out(&space, &Sphere::new(turn(center), radius)));
        }
    }
}
