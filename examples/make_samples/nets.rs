//! The nets of chapter 3: hills, a vault, solids in two positions, closed bodies and a ring. Row k is the
//! points of constant u; what lies like a sphere has 8 meridians from pole to pole.

use grafika::file::{Document, FileError, FileKind, Net, NetKind};
use grafika::geometry::Joint;
use std::f64::consts::{FRAC_PI_2, TAU};

type Point = [f64; 3];
type Rows = Vec<Vec<Point>>;

const MERIDIANS: usize = 8;
const ON_A_MERIDIAN: usize = 5;
/// Half an edge of the two cubes.
const CUBE: f64 = 100.0;
/// From the middle of the octahedron to a corner.
const OCTAHEDRON: f64 = 150.0;

/// Every net: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let nets = [
        ("A.FHC", NetKind::Fhc, vault()),
        ("A.FPB", NetKind::Fpb, sail()),
        ("A.FPS", NetKind::Fps, hills(NetKind::Fps, 80.0)),
        ("A.FBS", NetKind::Fbs, hills(NetKind::Fbs, 80.0)),
        ("Z.FBS", NetKind::Fbs, one_raised()),
        ("A.FEM", NetKind::Fem, hills(NetKind::Fem, 70.0)),
        ("A.ZMS", NetKind::Zms, pebble()),
        ("A.ZMB", NetKind::Zmb, pebble()),
        ("B.ZMS", NetKind::Zms, gourd()),
        ("B.ZMB", NetKind::Zmb, gourd()),
        ("K1.ZMS", NetKind::Zms, cube_on_an_edge()),
        ("K1.ZMB", NetKind::Zmb, cube_on_an_edge()),
        ("K2.ZMS", NetKind::Zms, cube_on_a_face()),
        ("K2.ZMB", NetKind::Zmb, cube_on_a_face()),
        ("K3.ZMS", NetKind::Zms, octahedron()),
        ("K3.ZMB", NetKind::Zmb, octahedron()),
        ("A.ZYS", NetKind::Zys, ring()),
        ("A.ZYB", NetKind::Zyb, ring()),
    ];
    let joined =
        [("KETBEZ.JSON", NetKind::Fpb, two_bezier_patches()), ("KETHERM.JSON", NetKind::Fhc, two_vaults())];
    let joined = joined.into_iter().map(|(name, kind, points)| {
        let mut net = Net::new(kind, points);
        net.settings.joint = Some(Joint::C1);
        Ok((name, Document::Net(net).encode(FileKind::Json)?))
    });
    nets.into_iter()
        .map(|(name, kind, points)| Ok((name, Document::Net(Net::new(kind, points)).write(kind.format())?)))
        .chain(joined)
        .collect()
}

/// Two Bézier patches that meet in the crest of a roof, C1 and not C2.
fn two_bezier_patches() -> Rows {
    let heights =
        [[-60.0; 2], [33.0, 72.0], [66.0, 144.0], [66.0, 144.0], [66.0, 144.0], [-20.0; 2], [-60.0; 2]];
    let row = |(k, [outer, inner]): (usize, [f64; 2])| {
        let across = [(-130.0, outer), (-45.0, inner), (45.0, inner), (130.0, outer)];
        across.map(|(y, z)| [(k as f64 - 3.0) * 70.0, y, z]).to_vec()
    };
    heights.into_iter().enumerate().map(row).collect()
}

/// Two Hermite patches, vaults that meet over the middle, C1 and not C2.
fn two_vaults() -> Rows {
    let places = [(-200.0, -50.0, 120.0), (0.0, 70.0, 330.0), (200.0, -40.0, 120.0)];
    let place = |(x, z, rise): (f64, f64, f64)| {
        vec![[x, -130.0, z], [x, 130.0, z], [0.0, 260.0, rise], [0.0, 260.0, -rise]]
    };
    let along = |rise: f64| vec![[200.0, 0.0, rise], [200.0, 0.0, rise], [0.0; 3], [0.0; 3]];
    places.into_iter().map(place).chain([420.0, -60.0, -60.0, -420.0].map(along)).collect()
}

/// The Hermite matrix of a vault: corners on the ground, tangents that rise from all of them, and a twist
/// that lifts one.
fn vault() -> Rows {
    let side = [-140.0, 140.0];
    let rise = [320.0, -320.0];
    let mut rows = vec![vec![[0.0; 3]; 4]; 4];
    for (k, x) in side.into_iter().enumerate() {
        for (l, y) in side.into_iter().enumerate() {
            rows[k][l] = [x, y, -60.0];
            rows[k + 2][l] = [280.0, 0.0, rise[k]];
            rows[k][l + 2] = [0.0, 280.0, rise[l]];
        }
    }
    rows[2][2] = [0.0, 0.0, -2400.0];
    rows
}

/// The net of a Bézier patch: a sail between four corners, of which two opposite ones are up.
fn sail() -> Rows {
    let heights = [
        [90.0, 20.0, -30.0, -90.0],
        [20.0, 190.0, 160.0, -30.0],
        [-30.0, 160.0, 190.0, 20.0],
        [-90.0, -30.0, 20.0, 90.0],
    ];
    let place = |index: usize| (index as f64 - 1.5) * 100.0;
    let row = |(k, row): (usize, [f64; 4])| {
        row.into_iter().enumerate().map(|(l, z)| [place(k), place(l), z]).collect()
    };
    heights.into_iter().enumerate().map(row).collect()
}

/// Two hills and a dell on a flat grid.
fn hills(kind: NetKind, spacing: f64) -> Rows {
    let bells = [([-80.0, 70.0], 130.0), ([90.0, -70.0], 90.0), ([-90.0, -110.0], -70.0)];
    grid(kind, spacing, |x, y| {
        let bell = |([a, b], height): ([f64; 2], f64)| {
            height * (-((x - a).powi(2) + (y - b).powi(2)) / 6000.0).exp()
        };
        bells.into_iter().map(bell).sum()
    })
}

/// A flat grid with its middle point up: the surface over it is that point's blending function.
fn one_raised() -> Rows {
    grid(NetKind::Fbs, 80.0, |x, y| if x == 0.0 && y == 0.0 { 180.0 } else { 0.0 })
}

/// A grid around the origin with heights, rounded to whole numbers.
fn grid(kind: NetKind, spacing: f64, height: impl Fn(f64, f64) -> f64) -> Rows {
    let [rows, columns] = kind.shape();
    let place = |index: usize, count: usize| (index as f64 - (count - 1) as f64 / 2.0) * spacing;
    let point = |k, l| [place(k, rows), place(l, columns)];
    let row = |k| (0..columns).map(|l| point(k, l)).map(|[x, y]| whole([x, y, height(x, y)])).collect();
    (0..rows).map(row).collect()
}

/// A pebble: wide along x above, along y below. Opposite points of a circle are equally high, so the poles
/// are smooth.
fn pebble() -> Rows {
    // Height of each circle, its mean radius, and how much it is wider along x than that.
    let circles = [
        (110.0, 0.0, 0.0),
        (95.0, 95.0, 45.0),
        (5.0, 135.0, 15.0),
        (-85.0, 100.0, -45.0),
        (-115.0, 0.0, 0.0),
    ];
    rings(|k, l| {
        let (z, radius, wider) = circles[l];
        let along = angle(k, MERIDIANS);
        let radius = radius + wider * (2.0 * along).cos();
        [radius * along.cos(), radius * along.sin(), z]
    })
}

/// A gourd: circles about an axis that bends, so that the upper pole is not on the z axis and the tangent
/// plane there is oblique (figure 3.11).
fn gourd() -> Rows {
    // The middle of each circle, its radius, and how far it leans over to x in degrees.
    let circles = [
        ([105.0, 0.0, 150.0], 0.0, 45.0),
        ([75.0, 0.0, 118.0], 62.0, 45.0),
        ([5.0, 0.0, 15.0], 110.0, 25.0),
        ([-25.0, 0.0, -85.0], 130.0, 0.0),
        ([-25.0, 0.0, -130.0], 0.0, 0.0),
    ];
    rings(|k, l| {
        let ([x, y, z], radius, lean) = circles[l];
        let (sin, cos) = angle(k, MERIDIANS).sin_cos();
        let (down, along) = f64::to_radians(lean).sin_cos();
        [x + radius * cos * along, y + radius * sin, z - radius * cos * down]
    })
}

/// Meridians from pole to pole with whole coordinates.
fn rings(point: impl Fn(usize, usize) -> Point) -> Rows {
    (0..MERIDIANS).map(|k| (0..ON_A_MERIDIAN).map(|l| whole(point(k, l))).collect()).collect()
}

/// A cube on one of its edges (figure 3.12): the poles are the middles of the highest and the lowest edge.
/// All corners are control points; the others are middles of edges and faces.
fn cube_on_an_edge() -> Rows {
    let diagonal = CUBE * f64::sqrt(2.0);
    let meridian = |k: usize| {
        let [x, y] = square(k);
        // Over the ends of the upper edge the meridian runs along it to a corner and down a face.
        let (side, shoulder) = if x == 0.0 { (0.0, diagonal) } else { (x * diagonal, diagonal / 2.0) };
        let y = y * CUBE;
        vec![
            [0.0, 0.0, diagonal],
            [side / 2.0, y, shoulder],
            [side, y, 0.0],
            [side / 2.0, y, -shoulder],
            [0.0, 0.0, -diagonal],
        ]
    };
    (0..MERIDIANS).map(meridian).collect()
}

/// The same cube on a face (figure 3.13): the poles are the middles of two faces.
fn cube_on_a_face() -> Rows {
    let meridian = |k: usize| {
        let [x, y] = square(k).map(|c| c * CUBE);
        let corner = |z: f64| [x, y, z * CUBE];
        vec![[0.0, 0.0, CUBE], corner(1.0), corner(0.0), corner(-1.0), [0.0, 0.0, -CUBE]]
    };
    (0..MERIDIANS).map(meridian).collect()
}

/// An octahedron on a corner: the poles are two corners, every other meridian runs over edges.
fn octahedron() -> Rows {
    let meridian = |k: usize| {
        let [x, y] = square(k);
        let out = OCTAHEDRON / (x.abs() + y.abs());
        let at = |share: f64, z: f64| [share * out * x, share * out * y, z * OCTAHEDRON];
        vec![at(0.0, 1.0), at(0.5, 0.5), at(1.0, 0.0), at(0.5, -0.5), at(0.0, -1.0)]
    };
    (0..MERIDIANS).map(|k| meridian(k).into_iter().map(|point| point.map(|c| c + 0.0)).collect()).collect()
}

/// Corners and middles of the sides of a square, around its middle.
fn square(k: usize) -> [f64; 2] {
    const AROUND: [f64; MERIDIANS] = [1.0, 1.0, 0.0, -1.0, -1.0, -1.0, 0.0, 1.0];
    [AROUND[k % MERIDIANS], AROUND[(k + MERIDIANS - 2) % MERIDIANS]]
}

/// A ring that waves up and down twice and is thick on one side (figure 3.14).
fn ring() -> Rows {
    let (middle, circle) = (120.0, ON_A_MERIDIAN);
    rings(|k, l| {
        let (along, around) = (angle(k, MERIDIANS), angle(l, circle) + FRAC_PI_2);
        let tube = 45.0 - 20.0 * along.cos();
        let out = middle + tube * around.sin();
        [out * along.cos(), out * along.sin(), tube * around.cos() + 40.0 * (2.0 * along).cos()]
    })
}

fn angle(index: usize, count: usize) -> f64 {
    TAU * index as f64 / count as f64
}

/// The nearest whole coordinates, so that the last bits of a sine do not matter; adding zero makes a
/// negative zero positive.
fn whole(point: Point) -> Point {
    point.map(|c| c.round() + 0.0)
}
