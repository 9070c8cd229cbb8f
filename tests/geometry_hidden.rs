//! Hidden surfaces by depth: pictures of single cells, and three independent routes: the screen's own
//! lines for the outlines, every triangle at every pixel for the depths, and a sphere's equation for
//! what of a surface is seen.

use grafika::geometry::{DepthBuffer, MAX_SIDE, Point, Vertex, View};
use grafika::screen::{Color, HEIGHT, Screen, Stroke, WIDTH};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

type Cell = [Vertex; 4];

fn at(x: i32, y: i32, depth: f32) -> Vertex {
    Vertex { x, y, depth }
}

fn rectangle([left, top]: [i32; 2], [right, bottom]: [i32; 2], depths: [f32; 2]) -> Cell {
    let [west, east] = depths;
    [at(left, top, west), at(right, top, east), at(right, bottom, east), at(left, bottom, west)]
}

/// The picture as text: a hexadecimal digit for a colour, a point where nothing is drawn.
fn art(buffer: &DepthBuffer) -> String {
    let rows = buffer.rows().map(|(_, row)| {
        let letter =
            |color: Option<u8>| color.map_or('.', |color| b"0123456789ABCDEF"[usize::from(color)] as char);
        row.iter().map(|pixel| letter(pixel.color())).collect::<String>()
    });
    rows.collect::<Vec<_>>().join("\n")
}

#[track_caller]
fn assert_art(buffer: &DepthBuffer, expected: &str) {
    let expected: Vec<&str> = expected.lines().map(str::trim).collect();
    let picture = art(buffer);
    assert!(picture == expected.join("\n"), "the picture is\n{picture}");
}

#[test]
fn one_cell_is_filled_and_outlined() {
    let mut buffer = DepthBuffer::new(14, 6);
    buffer.cell(&[at(4, 1, 0.0), at(1, 4, 0.0), at(12, 4, 0.0), at(9, 1, 0.0)], 7, Some(15));
    let picture = "..............
                   ....FFFFFF....
                   ...F777777F...
                   ..F77777777F..
                   .FFFFFFFFFFFF.
                   ..............";
    assert_art(&buffer, picture);
    buffer.clear();
    buffer.polygon(&[at(4, 1, 0.0), at(1, 4, 0.0), at(12, 4, 0.0), at(9, 1, 0.0)], 7, Some(15));
    assert_art(&buffer, picture);
    buffer.clear();
    assert!(buffer.rows().all(|(_, row)| row.iter().all(|pixel| pixel.color().is_none())));
    buffer.cell(&[at(4, 1, 0.0), at(1, 4, 0.0), at(12, 4, 0.0), at(9, 1, 0.0)], 7, None);
    assert_art(&buffer, &picture.replace('F', "7"));
}

/// A dart is filled as it is seen: beside the diagonal that lies outside of it, too.
#[test]
fn a_dart_keeps_its_notch() {
    let mut dart = [at(0, 0, 0.0), at(5, 3, 0.0), at(10, 0, 0.0), at(5, 7, 0.0)];
    for _ in 0..4 {
        let mut buffer = DepthBuffer::new(11, 8);
        buffer.cell(&dart, 7, Some(15));
        assert_art(
            &buffer,
            "F.........F
             .FF.....FF.
             .F7FF.FF7F.
             ..F77F77F..
             ...F777F...
             ....F7F....
             ....F7F....
             .....F.....",
        );
        dart.rotate_left(1);
    }
}

#[test]
fn the_nearer_cell_covers_in_any_order() {
    let cells = [rectangle([1, 1], [7, 4], [1.0, 1.0]), rectangle([4, 0], [10, 3], [2.0, 2.0])];
    for order in [[0, 1], [1, 0]] {
        let mut buffer = DepthBuffer::new(11, 5);
        order.iter().for_each(|&k| buffer.cell(&cells[k], k as u8, Some(15)));
        assert_art(
            &buffer,
            "....FFFFFFF
             .FFFF11111F
             .F00F11111F
             .F00FFFFFFF
             .FFFFFFF...",
        );
    }
}

#[test]
fn cells_that_cut_through_each_other_show_half_of_each() {
    let cells = [rectangle([0, 0], [10, 4], [0.0, 10.0]), rectangle([0, 1], [10, 3], [9.0, -1.0])];
    for order in [[0, 1], [1, 0]] {
        let mut buffer = DepthBuffer::new(11, 5);
        order.iter().for_each(|&k| buffer.cell(&cells[k], k as u8 + 1, Some(15)));
        assert_art(
            &buffer,
            "FFFFFFFFFFF
             FFFFF11111F
             F222211111F
             FFFFF11111F
             FFFFFFFFFFF",
        );
    }
}

#[test]
fn a_line_pierces_a_cell() {
    let mut buffer = DepthBuffer::new(11, 5);
    buffer.line(at(10, 2, -4.0), at(0, 2, 6.0), 4);
    buffer.cell(&rectangle([2, 0], [8, 4], [0.5, 0.5]), 0, Some(15));
    assert_art(
        &buffer,
        "..FFFFFFF..
         ..F00000F..
         44444400F44
         ..F00000F..
         ..FFFFFFF..",
    );
}

#[test]
fn a_folded_sheet_shows_its_near_layer_from_both_sides() {
    let layers = [
        rectangle([0, 0], [8, 2], [0.0, 1.0]),
        rectangle([3, 0], [8, 2], [2.0, 1.0]),
        rectangle([3, 0], [11, 2], [2.0, 3.0]),
    ];
    let front = "FFFFFFFFFFFF\nF00F2222222F\nFFFFFFFFFFFF";
    let back = "FFFFFFFFFFFF\nF0000000F22F\nFFFFFFFFFFFF";
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for (side, expected) in [(1.0, front), (-1.0, back)] {
            let mut buffer = DepthBuffer::new(12, 3);
            for k in order {
                let cell = layers[k].map(|corner| Vertex { depth: side * corner.depth, ..corner });
                buffer.cell(&cell, k as u8, Some(15));
            }
            assert_art(&buffer, expected);
        }
    }
}

#[test]
fn cells_seen_as_lines_and_points_are_their_outlines() {
    let mut buffer = DepthBuffer::new(9, 5);
    buffer.cell(&[at(0, 0, 0.0), at(4, 2, 1.0), at(8, 4, 2.0), at(4, 2, 3.0)], 7, Some(15));
    buffer.cell(&[at(8, 0, 0.0); 4], 7, Some(4));
    buffer.cell(&[at(0, 4, 0.0); 4], 7, None);
    buffer.polygon(&[at(1, 4, 0.0)], 7, Some(2));
    buffer.polygon(&[at(3, 4, 0.0), at(5, 4, 0.0)], 7, Some(2));
    buffer.polygon(&[], 7, Some(2));
    assert_art(&buffer, "F.......4\n.FF......\n...FF....\n.....FF..\n.2.222.FF");
}

/// A surface over a square of parameters, `count` cells along each, as seen.
fn mesh(count: usize, view: &View, surface: impl Fn(f64, f64) -> Point<3>) -> Vec<Cell> {
    let vertex = |k: usize, l: usize| {
        let point = surface(k as f64 / count as f64, l as f64 / count as f64);
        let [x, y] = view.pixel(point, 1.0);
        at(x as i32, y as i32, view.depth(point) as f32)
    };
    let cell = |(k, l)| [vertex(k + 1, l), vertex(k + 1, l + 1), vertex(k, l + 1), vertex(k, l)];
    (0..count).flat_map(|k| (0..count).map(move |l| (k, l))).map(cell).collect()
}

const RADIUS: f64 = 150.0;
const BELTS: usize = 12;
/// Cells along a meridian of a belt.
const ROWS: usize = 5;

/// A sphere whose belts between parallels have different colours, drawn with depths times a sign: the
/// number of pixels looked at, and of those whose colour is not that of the sphere's near side.
fn sphere(view: &View, sign: f32) -> (usize, usize) {
    let mut buffer = DepthBuffer::new(WIDTH as usize, HEIGHT as usize);
    let cells = mesh(BELTS * ROWS, view, |u, v| {
        let ((sin, cos), (sin_v, cos_v)) = ((TAU * u).sin_cos(), (PI * v).sin_cos());
        [RADIUS * sin_v * cos, RADIUS * sin_v * sin, RADIUS * cos_v]
    });
    for (index, cell) in cells.iter().enumerate() {
        let belt = (index / ROWS % BELTS) as u8;
        buffer.cell(&cell.map(|c| Vertex { depth: sign * c.depth, ..c }), belt, Some(belt));
    }
    let ((sin_a, cos_a), (sin_e, cos_e)) = (view.azimuth().sin_cos(), view.elevation().sin_cos());
    let (mut seen, mut wrong) = (0, 0);
    for (x, y) in (0..WIDTH).flat_map(|x| (0..HEIGHT).map(move |y| (x, y))) {
        let [right, up] = [f64::from(x) - 331.0, 260.0 - f64::from(y)];
        let near = RADIUS * RADIUS - right * right - up * up;
        // Beside the silhouette a pixel is many cells deep.
        if near < 0.1 * RADIUS * RADIUS {
            continue;
        }
        let near = near.sqrt();
        let foot = view.moved([0.0; 3], [right, up]);
        let z = foot[2] + near * sin_e;
        let on_sphere = [foot[0] + near * cos_e * cos_a, foot[1] + near * cos_e * sin_a, z];
        assert!((on_sphere.iter().map(|c| c * c).sum::<f64>().sqrt() - RADIUS).abs() < 1e-9);
        // Corners are rounded to pixels, and what is upright in the picture by less than one pixel may
        // be some more along z.
        let border = |belt: usize| RADIUS * (PI * belt as f64 / BELTS as f64).cos();
        if (0..=BELTS).any(|belt| (border(belt) - z).abs() < 4.0) {
            continue;
        }
        let belt = (1..BELTS).filter(|&belt| border(belt) > z).count();
        seen += 1;
        wrong += usize::from(buffer.pixel(x, y) != Some(belt as u8));
    }
    (seen, wrong)
}

#[test]
fn the_far_side_of_a_sphere_never_shows() {
    for step in 0..8 {
        let view = View::from_angles(0.9 * f64::from(step), 0.39 * f64::from(step) - 1.4);
        let (seen, wrong) = sphere(&view, 1.0);
        assert!(seen > 20_000 && wrong == 0, "{wrong} of {seen} pixels from {view:?}");
        // The check can fail: the same from inside out.
        let (_, wrong) = sphere(&view, -1.0);
        assert!(5 * wrong > seen, "only {wrong} of {seen} pixels from {view:?}");
    }
}

/// A picture of 640x480 of numbered cells.
fn picture<'a>(
    cells: impl Iterator<Item = &'a (usize, Cell)>,
    colors: fn(usize) -> [u8; 2],
) -> Vec<Option<u8>> {
    let mut buffer = DepthBuffer::new(WIDTH as usize, HEIGHT as usize);
    for (index, cell) in cells {
        let [fill, edge] = colors(*index);
        buffer.cell(cell, fill, Some(edge));
    }
    buffer.rows().flat_map(|(_, row)| row.iter().map(|pixel| pixel.color())).collect()
}

fn differing(one: &[Option<u8>], other: &[Option<u8>]) -> usize {
    one.iter().zip(other).filter(|(one, other)| one != other).count()
}

const NET: usize = 5;

/// A surface through a net of points, linear between them: it folds and cuts through itself.
fn crumpled(net: &[[f64; 3]], u: f64, v: f64) -> Point<3> {
    let place = |t: f64| ((t * (NET - 1) as f64) as usize).min(NET - 2);
    let (k, l) = (place(u), place(v));
    let (s, t) = (u * (NET - 1) as f64 - k as f64, v * (NET - 1) as f64 - l as f64);
    let blend =
        |a: Point<3>, b: Point<3>, t: f64| -> Point<3> { std::array::from_fn(|d| a[d] + (b[d] - a[d]) * t) };
    let row = |k: usize| blend(net[k * NET + l], net[k * NET + l + 1], t);
    blend(row(k), row(k + 1), s)
}

/// A flat cell by a corner and two sides, and the depths there.
fn parallelogram([x, y, z]: [i32; 3], [ux, uy, uz]: [i32; 3], [vx, vy, vz]: [i32; 3]) -> Cell {
    [
        at(x, y, z as f32),
        at(x + ux, y + uy, (z + uz) as f32),
        at(x + ux + vx, y + uy + vy, (z + uz + vz) as f32),
        at(x + vx, y + vy, (z + vz) as f32),
    ]
}

/// The depth of a flat cell at a pixel, in double precision; `None` beside it.
fn depth_at([a, b, _, d]: &Cell, x: i32, y: i32) -> Option<f64> {
    let cross = |(ax, ay): (i32, i32), (bx, by): (i32, i32)| {
        i64::from(ax) * i64::from(by) - i64::from(ay) * i64::from(bx)
    };
    let (u, v, p) = ((b.x - a.x, b.y - a.y), (d.x - a.x, d.y - a.y), (x - a.x, y - a.y));
    let area = cross(u, v);
    let (s, t) = (cross(p, v) * area.signum(), cross(u, p) * area.signum());
    let inside = area != 0 && (0..=area.abs()).contains(&s) && (0..=area.abs()).contains(&t);
    let share = |part: i64, to: &Vertex| part as f64 / area.abs() as f64 * f64::from(to.depth - a.depth);
    inside.then(|| f64::from(a.depth) + share(s, b) + share(t, d))
}

/// The check of the order can fail: where what is drawn last is nearest, as on paper.
#[test]
fn the_order_of_painting_matters() {
    let net: Vec<Point<3>> = (0..NET * NET)
        .map(|k| [4.7, 9.1, 6.3].map(|phase| 180.0 * (phase * (k * k + 1) as f64).sin()))
        .collect();
    let cells = mesh(28, &View::from_angles(0.5, 0.6), |u, v| crumpled(&net, u, v));
    let paint = |cells: &mut dyn Iterator<Item = (usize, &Cell)>| {
        let ranked = cells
            .enumerate()
            .map(|(rank, (index, cell))| (index, cell.map(|corner| Vertex { depth: rank as f32, ..corner })));
        picture(ranked.collect::<Vec<_>>().iter(), |_| [0, 15])
    };
    let there = paint(&mut cells.iter().enumerate());
    let back = paint(&mut cells.iter().enumerate().rev());
    let drawn = there.iter().filter(|color| color.is_some()).count();
    assert!(20 * differing(&there, &back) > drawn, "{} of {drawn}", differing(&there, &back));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_order_of_cells_does_not_matter(
        net in prop::collection::vec(prop::array::uniform3(-180.0..180.0f64), NET * NET),
        angles in prop::array::uniform2(-4.0..4.0f64),
        keys in prop::collection::vec(any::<u32>(), 28 * 28),
    ) {
        let view = View::from_angles(angles[0], angles[1]);
        let cells: Vec<(usize, Cell)> =
            mesh(28, &view, |u, v| crumpled(&net, u, v)).into_iter().enumerate().collect();
        let mut shuffled = cells.clone();
        shuffled.sort_by_key(|(index, _)| keys[*index]);
        let schemes: [fn(usize) -> [u8; 2]; 2] =
            [|_| [0, 15], |index| [(index % 7) as u8 + 8, (index % 5) as u8]];
        for colors in schemes {
            prop_assert_eq!(differing(&picture(cells.iter(), colors), &picture(shuffled.iter(), colors)), 0);
        }
    }

    #[test]
    fn every_pixel_shows_the_nearest_cell(
        corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-40..70i32)), 1..14),
    ) {
        let cells: Vec<Cell> = corners.iter().map(|&[p, u, v]| parallelogram(p, u, v)).collect();
        let mut buffer = DepthBuffer::new(50, 40);
        let mut faces = buffer.clone();
        for (index, cell) in cells.iter().enumerate() {
            buffer.cell(cell, index as u8, None);
            faces.polygon(cell, index as u8, None);
        }
        for (x, y) in (0..50).flat_map(|x| (0..40).map(move |y| (x, y))) {
            let mut depths: Vec<(f64, u8)> = cells.iter().enumerate()
                .filter_map(|(index, cell)| Some((depth_at(cell, x, y)?, index as u8))).collect();
            depths.sort_by(|one, other| other.0.total_cmp(&one.0));
            let doubtful = matches!(depths[..], [(one, _), (other, _), ..] if one - other < 1e-4);
            if !doubtful {
                let expected = depths.first().map(|(_, index)| *index);
                prop_assert_eq!(buffer.pixel(x, y), expected, "at {} {}", x, y);
                prop_assert_eq!(faces.pixel(x, y), expected, "at {} {}", x, y);
            }
        }
    }

    #[test]
    fn outlines_are_the_screens_lines(
        corners in prop::array::uniform4((-300..940i32, -300..780i32)), small: bool,
        depths in prop::array::uniform4(-1e3..1e3f32), turn in 0..4usize, back: bool,
    ) {
        let corners = if small { corners.map(|(x, y)| (300 + x % 9, 200 + y % 9)) } else { corners };
        let mut cell: Cell = std::array::from_fn(|k| at(corners[k].0, corners[k].1, depths[k]));
        let mut screen = Screen::new();
        for (k, a) in cell.iter().enumerate() {
            let b = cell[(k + 1) % 4];
            let [a, b] = if (b.x, b.y) < (a.x, a.y) { [&b, a] } else { [a, &b] };
            screen.line(a.x, a.y, b.x, b.y, Stroke::thin(Color::White));
        }
        // Whichever corner is first, and whichever way around.
        cell.rotate_left(turn);
        if back {
            cell.reverse();
        }
        let mut buffer = DepthBuffer::new(WIDTH as usize, HEIGHT as usize);
        buffer.cell(&cell, 7, Some(15));
        for (y, row) in buffer.rows() {
            for (x, pixel) in row.iter().enumerate() {
                let on_screen = screen.pixel(x as i32, y as i32) == Some(Color::White);
                prop_assert_eq!(pixel.color() == Some(15), on_screen, "at {} {}", x, y);
            }
        }
    }

    #[test]
    fn anything_is_clipped(
        cells in prop::collection::vec(prop::array::uniform4(any::<(i32, i32, f32)>()), 1..8),
        wild in prop::collection::vec(prop::array::uniform4((-30_000..30_000i32, -30_000..30_000i32, any::<f32>())), 1..8),
        special in prop::sample::select(vec![f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, -0.0]),
    ) {
        let mut buffer = DepthBuffer::new(160, 100);
        for cell in cells.iter().chain(&wild) {
            let mut cell = cell.map(|(x, y, depth)| at(x, y, depth));
            buffer.cell(&cell, 3, Some(5));
            buffer.line(cell[0], cell[2], 4);
            cell[1].depth = special;
            buffer.cell(&cell, 3, None);
            buffer.polygon(&cell, 3, Some(5));
        }
        let known = |color: Option<u8>| matches!(color, None | Some(3..=5));
        prop_assert!(buffer.rows().all(|(_, row)| row.iter().all(|pixel| known(pixel.color()))));
    }
}

#[test]
fn sizes_are_limited() {
    for (width, height) in [(0, 0), (0, 5), (5, 0), (usize::MAX, 1)] {
        let mut buffer = DepthBuffer::new(width, height);
        buffer.cell(&rectangle([-1, -1], [30_000, 30_000], [0.0, 1.0]), 1, Some(2));
        assert_eq!((buffer.width(), buffer.height()), (width.min(MAX_SIDE), height.min(MAX_SIDE)));
        assert!(buffer.rows().all(|(_, row)| row.len() == buffer.width()));
        assert_eq!(buffer.pixel(0, 0), (width > 0 && height > 0).then_some(1));
    }
    let buffer = DepthBuffer::new(3, 3);
    assert_eq!([buffer.pixel(-1, 0), buffer.pixel(0, 3), buffer.pixel(i32::MIN, i32::MAX)], [None; 3]);
}

/// The largest cells there are, and none of them costs more than the picture's pixels.
#[test]
fn far_corners_take_no_time() {
    let mut buffer = DepthBuffer::new(WIDTH as usize, HEIGHT as usize);
    let far = [-30_000, -20_001, 19_999, 30_000, 7, 333];
    let corner = |k: usize| at(far[k % 6], far[k / 6 % 6], k as f32);
    let start = std::time::Instant::now();
    for k in 0..100 {
        buffer.cell(&[corner(k), corner(5 * k + 7), corner(11 * k + 3), corner(17 * k + 20)], 1, Some(2));
    }
    assert!(start.elapsed().as_secs() < 5);
}
