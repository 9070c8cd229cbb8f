use super::*;
use crate::geometry::{DepthBuffer, Vertex, View};
use proptest::prelude::*;

const SIZE: [usize; 2] = [200, 200];

/// A place of a view in pixels, y down.
fn pixel(view: &View, point: Point<3>) -> Point<3> {
    let [x, y, depth] = view.image(point);
    [100.0 + x, 100.0 - y, depth]
}

/// The six faces of a box, anticlockwise from outside.
fn cuboid(low: Point<3>, high: Point<3>) -> Vec<Vec<Point<3>>> {
    let corner = |bits: usize| std::array::from_fn(|d| if bits >> d & 1 == 0 { low[d] } else { high[d] });
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        .map(|face| face.map(corner).to_vec())
        .to_vec()
}

fn seen(faces: &[Vec<Point<3>>], view: &View) -> Vec<Vec<Point<3>>> {
    faces.iter().map(|face| face.iter().map(|&corner| pixel(view, corner)).collect()).collect()
}

/// Three bars, each over one neighbour and under the other.
fn cycle() -> Vec<Vec<Point<3>>> {
    (0..3)
        .map(|k| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 3.0).sin_cos();
            let turned = |[x, y, z]: Point<3>| [100.0 + x * cos - y * sin, 100.0 + x * sin + y * cos, z];
            // Along x, one end up, the other down, beside the middle.
            [[-70.0, 20.0, -30.0], [-70.0, 40.0, -30.0], [70.0, 40.0, 30.0], [70.0, 20.0, 30.0]]
                .map(turned)
                .to_vec()
        })
        .collect()
}

#[test]
fn three_faces_in_a_circle_have_no_right_order() {
    let painting = Painting::new(&cycle(), Backs::Painted, SIZE);
    assert_eq!((painting.steps.len(), painting.decided, painting.possible), (3, 3, false));
    assert!(painting.wrong.len() > 100, "{}", painting.wrong.len());
    // Whatever the order is, some pixels are wrong.
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let faces: Vec<Face> = order.iter().filter_map(|&k| Face::new(k, &cycle()[k])).collect();
        let mut field = Field::new(SIZE, 1e-6);
        faces.iter().for_each(|face| {
            field.paint(face);
        });
        assert!(field.wrong() > 100, "{order:?}");
    }
    let two = Painting::new(&cycle()[..2], Backs::Painted, SIZE);
    assert!(two.possible && two.wrong.is_empty());
}

/// A long face that is farther in the mean, but before a small one where both are seen.
#[test]
fn a_face_in_the_wrong_place_by_depth_is_moved() {
    let small = vec![[90.0, 90.0, 0.0], [90.0, 110.0, 0.0], [110.0, 110.0, 0.0], [110.0, 90.0, 0.0]];
    let long = [[80.0, 95.0, 5.0], [80.0, 105.0, 5.0], [198.0, 105.0, -80.0], [198.0, 95.0, -80.0]];
    // Where they overlap the long one goes from -2 to -17: behind; then lifted, it is in front.
    for (lift, first) in [(0.0, 1), (20.0, 0)] {
        let lifted: Vec<Point<3>> = long.iter().map(|&[x, y, z]| [x, y, z + lift]).collect();
        let painting = Painting::new(&[small.clone(), lifted], Backs::LeftOut, SIZE);
        assert_eq!(painting.steps[0].face, first, "{painting:?}");
        assert_eq!(painting.steps[0].moved.is_some(), first == 0);
        assert!(painting.wrong.is_empty() && painting.possible);
        assert_eq!(painting.decided, 1);
    }
}

#[test]
fn a_face_inside_another_one_is_compared_by_a_corner() {
    let large = vec![[20.0, 20.0, 0.0], [20.0, 180.0, 0.0], [180.0, 180.0, 90.0], [180.0, 20.0, 90.0]];
    let small = vec![[30.0, 90.0, 30.0], [30.0, 110.0, 30.0], [50.0, 110.0, 30.0], [50.0, 90.0, 30.0]];
    let painting = Painting::new(&[large, small], Backs::LeftOut, SIZE);
    assert_eq!(painting.steps[0].moved, Some((1, Test::Corner)));
    assert_eq!((painting.steps[0].face, painting.wrong.len()), (0, 0));
}

#[test]
fn what_is_no_face_is_left_out() {
    let face = vec![[0.0, 0.0, 0.0], [0.0, 9.0, 0.0], [9.0, 9.0, 0.0]];
    let back: Vec<Point<3>> = face.iter().rev().copied().collect();
    let broken = vec![[0.0, f64::NAN, 0.0], [0.0, 9.0, 0.0], [9.0, 9.0, f64::INFINITY]];
    let painting = Painting::new(&[Vec::new(), face, back, broken], Backs::LeftOut, [4, 4]);
    assert_eq!((painting.steps.len(), painting.left_out), (1, vec![0, 2, 3]));
    assert!(Painting::new(&[], Backs::LeftOut, [0, 0]).steps.is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_convex_body_has_no_wrong_pixel(
        size in prop::array::uniform3(5.0..50.0f64),
        angles in prop::array::uniform2(-3.0..3.0f64),
    ) {
        let view = View::from_angles(angles[0], angles[1]);
        let painting = Painting::new(&seen(&cuboid(size.map(|x| -x), size), &view), Backs::LeftOut, SIZE);
        prop_assert!(painting.wrong.is_empty() && painting.possible && painting.steps.len() <= 3);
        prop_assert_eq!(painting.steps.len() + painting.left_out.len(), 6);
    }

    /// Two bodies that a plane parts have a right order, and the tests find it.
    #[test]
    fn two_boxes_are_painted_right(
        gap in 1.0..20.0f64,
        sizes in prop::array::uniform2(prop::array::uniform3(5.0..40.0f64)),
        angles in prop::array::uniform2(-3.0..3.0f64),
    ) {
        let view = View::from_angles(angles[0], angles[1]);
        let [one, other] = sizes;
        let mut faces = cuboid([-one[0] - gap, -one[1], -one[2]], [-gap, one[1], one[2]]);
        faces.extend(cuboid([gap, -other[1], -other[2]], [gap + other[0], other[1], other[2]]));
        let painting = Painting::new(&seen(&faces, &view), Backs::LeftOut, SIZE);
        prop_assert!(painting.possible, "{painting:?}");
    }

    /// Wrong pixels are those where the depth buffer shows another face: away from outlines by two pixels.
    #[test]
    fn wrong_pixels_are_those_of_the_depth_buffer(
        places in prop::collection::vec((prop::array::uniform3(-50.0..50.0f64), prop::array::uniform3(4.0..30.0f64)), 1..8),
        angles in prop::array::uniform2(-3.0..3.0f64),
    ) {
        let view = View::from_angles(angles[0], angles[1]);
        let boxes = places.iter().flat_map(|(at, size)| {
            cuboid(*at, std::array::from_fn(|d| at[d] + size[d]))
        });
        let faces = seen(&boxes.collect::<Vec<_>>(), &view);
        let painting = Painting::new(&faces, Backs::LeftOut, SIZE);
        let (mut by_depth, mut by_order) = (DepthBuffer::new(200, 200), DepthBuffer::new(200, 200));
        for (rank, step) in painting.steps.iter().enumerate() {
            let corners = |depth: Option<f64>| -> Vec<Vertex> {
                let vertex = |corner: &Point<3>| Vertex {
                    x: corner[0].round() as i32,
                    y: corner[1].round() as i32,
                    depth: depth.unwrap_or(corner[2]) as f32,
                };
                faces[step.face].iter().map(vertex).collect()
            };
            by_depth.polygon(&corners(None), step.face as u8 + 1, Some(0));
            by_order.polygon(&corners(Some(rank as f64)), step.face as u8 + 1, Some(0));
        }
        let differs = |x: i32, y: i32| by_depth.pixel(x, y) != by_order.pixel(x, y);
        let wrong = |x: i32, y: i32| painting.wrong.binary_search_by_key(&[y, x], |&[x, y]| [y, x]).is_ok();
        let quiet = |buffer: &DepthBuffer, x: i32, y: i32| {
            (-2..=2).all(|dx| (-2..=2).all(|dy| buffer.pixel(x + dx, y + dy) == buffer.pixel(x, y)))
        };
        for (x, y) in (3..197).step_by(3).flat_map(|x| (3..197).step_by(3).map(move |y| (x, y))) {
            if quiet(&by_depth, x, y) && quiet(&by_order, x, y) {
                prop_assert_eq!(wrong(x, y), differs(x, y), "{} {}", x, y);
            }
        }
        prop_assert_eq!(painting.steps.last().map_or(0, |step| step.wrong), painting.wrong.len());
        for count in [1, painting.steps.len() / 2, painting.steps.len()] {
            let wrong = painting.wrong_after(count).len();
            prop_assert_eq!(count.checked_sub(1).and_then(|at| painting.steps.get(at)).map_or(0, |step| step.wrong), wrong);
        }
    }
}
