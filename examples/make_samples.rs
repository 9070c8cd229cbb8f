//! Makes the sample files in `data/`: `cargo run --example make_samples [FOLDER]`.
//!
//! The disk of the book had `A.IP2` to `D.IP2`, `X.IP2` to `Z.IP2`, `A.IC2` with `A.EC2`, `A.GBP` and, in space,
//! `A.IP3` and `B.IP3`; what exactly was in them is lost. These show what the book shows with such files: closed
//! frames, multiple points (2.3.4 to 2.3.6), tangents (2.3.3), a measured curve with noise and with an error
//! (2.3.8), and the "characteristic frames" of chapter 5's list as the corners of two solids. `A.GBP` is a
//! Fourier curve (2.2) near `A.IP2`. `A.CSK` and `B.CSK` are two finished Csángó
//! cubes (4.4). The nets of chapter 3 are in `make_samples/nets.rs`, those of KC_TER in
//! `make_samples/spaces.rs`, those of PH_GORBE in `make_samples/offsets.rs`, those of CSOMO and ALAKPAR in
//! `make_samples/knots.rs`, those of BURKOLO in `make_samples/skins.rs`, those of SOM_FEL in `make_samples/clouds.rs`. The
//! same bytes come out every time.

#[path = "make_samples/clouds.rs"]
mod clouds;
#[path = "make_samples/knots.rs"]
mod knots;
#[path = "make_samples/nets.rs"]
mod nets;
#[path = "make_samples/normals.rs"]
mod normals;
#[path = "make_samples/offsets.rs"]
mod offsets;
#[path = "make_samples/skins.rs"]
mod skins;
#[path = "make_samples/spaces.rs"]
mod spaces;

use grafika::file::{self, Document, FileError, Format, PlanePoints, SpacePoints};
use grafika::geometry::{ClosedPath, Fourier};
use grafika::puzzle::cube::{CORNER, Progress, Search};

type Point = [f64; 2];

/// Number of points of the measured curve, 14 pixels apart, and of the sparse one, 40 pixels apart.
const DENSE: u8 = 41;
const SPARSE: u8 = 15;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "data".to_owned());
    for (name, bytes) in samples()? {
        std::fs::write(std::path::Path::new(&folder).join(name), bytes)?;
    }
    Ok(())
}

/// Every sample file: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let plane = [
        ("A.IP2", letter_a()),
        ("B.IP2", letter_b()),
        ("C.IP2", letter_c()),
        ("D.IP2", multiple_points()),
        ("X.IP2", (0..DENSE).map(|k| gauss(14 * u16::from(k))).collect()),
        ("Y.IP2", noisy()),
        ("Z.IP2", with_an_error()),
        ("W.IP2", sparse()),
        ("S.IP2", corner()),
    ];
    let space = [("A.IP3", cube()), ("B.IP3", tetrahedron())];
    let plane = plane.into_iter().map(|(name, points)| Ok((name, bytes(points)?)));
    let space = space.into_iter().map(|(name, points)| {
        Ok((name, Document::SpacePoints(SpacePoints::new(points)).write(Format::Ip3)?))
    });
    let cubes = [("A.CSK", 1997), ("B.CSK", 1998)];
    let cubes = cubes.into_iter().map(|(name, seed)| Ok((name, finished_cube(seed)?)));
    let waves = WAVES.into_iter().map(|(name, waves)| Ok((name, of_waves(waves)?)));
    let single = [
        ("A.GBP", fourier_a()),
        ("A.IC2", Document::PlanePoints(clef()).write(Format::Ic2)),
        ("A.EC2", Document::PlanePoints(clef()).write(Format::Ec2)),
    ];
    let single = single.into_iter().map(|(name, bytes)| Ok((name, bytes?)));
    let nets = nets::samples()?.into_iter().map(Ok);
    let spaces = spaces::samples()?.into_iter().map(Ok);
    let normals = normals::samples()?.into_iter().map(Ok);
    let offsets = offsets::samples()?.into_iter().map(Ok);
    let knots = knots::samples()?.into_iter().map(Ok);
    let skins = skins::samples()?.into_iter().map(Ok);
    let clouds = clouds::samples()?.into_iter().map(Ok);
    plane
        .chain(space)
        .chain(cubes)
        .chain(single)
        .chain(waves)
        .chain(nets)
        .chain(spaces)
        .chain(normals)
        .chain(offsets)
        .chain(knots)
        .chain(skins)
        .chain(clouds)
        .collect()
}

/// A finished Csángó cube where the program builds it: the first filling that a search of this seed finds.
fn finished_cube(seed: u64) -> Result<Vec<u8>, FileError> {
    let filling = match Search::new(&[], seed).advance(u64::MAX) {
        Progress::Found(filling) => filling.position(CORNER),
        Progress::Working | Progress::Exhausted => None,
    };
    let cube = filling.ok_or_else(|| FileError::Invalid("there is no filling of the cube".to_owned()))?;
    Document::CsangoCube(cube).write(Format::Csk)
}

/// A treble clef in one open stroke: few points, and tangents that say the rest.
fn clef() -> PlanePoints {
    let stroke = [
        ([285.0, 150.0], [0.0, 60.0]),
        ([330.0, 175.0], [70.0, -40.0]),
        ([285.0, 95.0], [-200.0, 0.0]),
        ([200.0, 175.0], [0.0, 190.0]),
        ([300.0, 285.0], [120.0, 110.0]),
        ([318.0, 370.0], [-60.0, 20.0]),
        ([265.0, 270.0], [0.0, -220.0]),
        ([300.0, 40.0], [-10.0, -110.0]),
        ([235.0, 25.0], [-30.0, 80.0]),
    ];
    let tangents = stroke.iter().map(|&(_, tangent)| tangent).collect();
    let points = stroke.iter().map(|&(point, _)| point).collect();
    PlanePoints { tangents: Some(tangents), ..PlanePoints::new(points) }
}

/// The Fourier curve of 20 harmonics nearest to the polygon of the letter A, in the middle of its field.
/// Rounded to thousandths, so that the last bits of a sine do not matter.
fn fourier_a() -> Result<Vec<u8>, FileError> {
    let points: Vec<Point> = letter_a().into_iter().map(|[x, y]| [x - 280.0, y - 190.0]).collect();
    let curve = ClosedPath::polygon(&points).and_then(|polygon| Fourier::fit(&polygon, 20));
    let mut fourier = file::Fourier::of_curve(&curve.map_err(|error| FileError::Invalid(error.to_string()))?);
    for row in [&mut fourier.a, &mut fourier.p, &mut fourier.b, &mut fourier.q] {
        *row = row.map(|value| (value * 1000.0).round() / 1000.0);
    }
    Document::Fourier(Box::new(fourier)).write(Format::Gbp)
}

fn bytes(points: Vec<Point>) -> Result<Vec<u8>, FileError> {
    let points = points.into_iter().map(|point| point.map(f64::round)).collect();
    Document::PlanePoints(PlanePoints::new(points)).write(Format::Ip2)
}

/// The outline of a stencil A: straight sides, rounded corners, and a gap instead of a hole.
fn letter_a() -> Vec<Point> {
    outline(&[
        [110.0, 20.0],
        [245.0, 360.0],
        [315.0, 360.0],
        [450.0, 20.0],
        [385.0, 20.0],
        [280.0, 285.0],
        [227.0, 150.0],
        [311.0, 150.0],
        [329.0, 105.0],
        [209.0, 105.0],
        [175.0, 20.0],
    ])
}

/// A B in one stroke: up the stem, and back down over the two bowls, which meet at the stem.
fn letter_b() -> Vec<Point> {
    let stem = (0..=6).map(|k| [150.0, 56.0 + 45.0 * f64::from(k)]);
    let top = [[152.0, 353.0], [178.0, 360.0]];
    let upper = arc([240.0, 273.0], [115.0, 87.0], [105.0, -75.0], 8);
    let waist = [[215.0, 191.0], [170.0, 188.0], [215.0, 185.0]];
    let lower = arc([250.0, 104.0], [150.0, 84.0], [75.0, -105.0], 10);
    let bottom = [[178.0, 20.0], [152.0, 27.0]];
    stem.chain(top).chain(upper).chain(waist).chain(lower).chain(bottom).collect()
}

/// The outline of a C: two arcs of ellipses, joined at the ends.
fn letter_c() -> Vec<Point> {
    let centre = [295.0, 190.0];
    let outer = arc(centre, [200.0, 170.0], [40.0, 320.0], 22);
    let inner = arc(centre, [130.0, 105.0], [320.0, 40.0], 15);
    let middle = |angle| arc(centre, [165.0, 137.0], [angle, angle], 1);
    [outer, middle(320.0), inner, middle(40.0)].concat()
}

/// A frame with a double point at the lower right and a triple one at the upper right, as in figures 2.11,
/// 2.14 and 2.22.
fn multiple_points() -> Vec<Point> {
    let [lower, upper] = [[470.0, 50.0], [470.0, 330.0]];
    vec![[150.0, 50.0], lower, lower, upper, upper, upper, [150.0, 330.0], [60.0, 190.0]]
}

/// A Gauss curve 300 pixels high in the middle of the field, on a ground of 40 pixels.
fn gauss(x: u16) -> Point {
    let x = f64::from(x);
    let deviation = (x - 280.0) / 60.0;
    [x, 40.0 + 300.0 * (-deviation * deviation / 2.0).exp()]
}

/// The dense curve with noise of up to 14 pixels on every ordinate.
fn noisy() -> Vec<Point> {
    let mut state = 1997u32;
    let mut noise = || {
        // The generator of Numerical Recipes; its high bits are random enough for a picture.
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 16) / 65536.0 * 28.0 - 14.0
    };
    (0..DENSE).map(|k| gauss(14 * u16::from(k))).map(|[x, y]| [x, y + noise()]).collect()
}

/// The sparse curve, figures 2.38 and 2.39.
fn sparse() -> Vec<Point> {
    (0..SPARSE).map(|k| gauss(40 * u16::from(k))).collect()
}

/// A corner with one more point on it, figure 2.15: without that the Bézier curve is far from the corner.
fn corner() -> Vec<Point> {
    vec![[130.0, 40.0], [280.0, 340.0], [280.0, 340.0], [430.0, 40.0]]
}

/// A wave of figure 2.2: its number, amplitude and phase in x, and the same in y.
type Wave = (usize, [f64; 2], [f64; 2]);

/// The coefficients that are printed for figure 2.2; in d, where the printed ones give a straight line, the phase belongs
/// to the first wave.
const WAVES: [(&str, &[Wave]); 6] = [
    ("22A.GBP", &[(1, [100.0, 0.0], [100.0, 0.5]), (2, [50.0, 1.0], [50.0, 0.5])]),
    (
        "22B.GBP",
        &[(1, [100.0, 0.0], [100.0, 0.5]), (2, [50.0, 0.0], [50.0, 1.5]), (7, [40.0, 0.0], [40.0, 1.5])],
    ),
    (
        "22C.GBP",
        &[(1, [100.0, 0.0], [100.0, 0.5]), (5, [50.0, 0.0], [0.0, 0.0]), (7, [0.0, 0.0], [50.0, 0.0])],
    ),
    ("22D.GBP", &[(1, [160.0, 0.0], [160.0, 0.5])]),
    ("22E.GBP", &[(1, [100.0, 0.0], [100.0, 0.5]), (7, [60.0, 0.0], [60.0, 0.5])]),
    ("22F.GBP", &[(1, [100.0, 0.0], [100.0, 0.5]), (7, [60.0, 0.0], [60.0, 1.5])]),
];

fn of_waves(waves: &[Wave]) -> Result<Vec<u8>, FileError> {
    let mut fourier = file::Fourier::default();
    for &(number, [a, p], [b, q]) in waves {
        (fourier.a[number], fourier.p[number]) = (a, p);
        (fourier.b[number], fourier.q[number]) = (b, q);
    }
    Document::Fourier(Box::new(fourier)).write(Format::Gbp)
}

/// The sparse curve whose 11th ordinate is 160 pixels too high.
fn with_an_error() -> Vec<Point> {
    let mut points = sparse();
    points[10][1] += 160.0; // there are 15
    points
}

/// The corners of a cube, along a closed way over eight of its edges.
fn cube() -> Vec<[f64; 3]> {
    let lower = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let bottom = lower.iter().map(|&[x, y]| [x, y, -1.0]);
    let top = lower.iter().rev().map(|&[x, y]| [x, y, 1.0]);
    bottom.chain(top).map(|corner| corner.map(|c| 100.0 * c)).collect()
}

/// The corners of a regular tetrahedron.
fn tetrahedron() -> Vec<[f64; 3]> {
    let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    corners.map(|corner| corner.map(|c: f64| 120.0 * c)).to_vec()
}

/// Points on an arc of an ellipse with this centre and these half axes, between two angles in degrees.
fn arc(centre: Point, axes: Point, angles: [f64; 2], count: u8) -> Vec<Point> {
    let [from, to] = angles.map(f64::to_radians);
    let at = |k| {
        let (sin, cos) = (from + (to - from) * f64::from(k) / f64::from(count.max(2) - 1)).sin_cos();
        [centre[0] + axes[0] * cos, centre[1] + axes[1] * sin]
    };
    (0..count).map(at).collect()
}

/// The sides of a polygon, each as evenly spaced points that stay away from the corners.
fn outline(corners: &[Point]) -> Vec<Point> {
    const CUT: f64 = 10.0;
    const SPACING: f64 = 34.0;
    let mut points = Vec::new();
    for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let side = [to[0] - from[0], to[1] - from[1]];
        let length = side[0].hypot(side[1]);
        let steps = ((length - 2.0 * CUT) / SPACING).round().max(1.0);
        for step in 0..=steps as u8 {
            let t = (CUT + (length - 2.0 * CUT) * f64::from(step) / steps) / length;
            points.push([from[0] + side[0] * t, from[1] + side[1] * t]);
        }
    }
    points
}
