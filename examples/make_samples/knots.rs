//! The samples of CSOMO and ALAKPAR: curves and a surface by their knots, curves with shape parameters.

use grafika::file::{
    Document, FamilyName, FileError, FileKind, KnotNet, KnotPoints, LambdaValue, ShapedPoints,
};
use grafika::file::{Format, Fourier};
use grafika::geometry::shaped::{bezier_points, cyclic_from_fourier};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Every file: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let documents: [(&str, Document); 13] = [
        ("A.CSM", waves().into()),
        ("B.CSM", bowl().into()),
        ("D.CSM", double().into()),
        ("K.CSM", circle().into()),
        ("A.CSF", Document::KnotNet(Box::new(hill()))),
        ("A.ALP", letter()?.into()),
        ("CIKLOIS.ALP", cycloid().into()),
        ("CSAVAR.ALP", helix().into()),
        ("FELKOR.ALP", half_circle().into()),
        ("HAN.ALP", han().into()),
        ("KOR.ALP", ring().into()),
        ("LANC.ALP", catenary().into()),
        ("TRIG.ALP", trigonometric().into()),
    ];
    documents.into_iter().map(|(name, document)| Ok((name, document.encode(FileKind::Json)?))).collect()
}

/// Thirteen points in waves, over knots of changing distance.
fn waves() -> KnotPoints {
    let points = [
        (0, 0),
        (1, 3),
        (3, 4),
        (5, 3),
        (6, 0),
        (8, -1),
        (10, 1),
        (11, 4),
        (13, 5),
        (15, 3),
        (16, 0),
        (18, -1),
        (20, 2),
    ];
    let points: Vec<[f64; 2]> =
        points.iter().map(|&(x, y)| [f64::from(26 * x + 20), f64::from(26 * y + 60)]).collect();
    let knots = (0..17).map(|j| f64::from(5 * j + (j * j) % 3) / 5.0).collect();
    KnotPoints { knots, ..KnotPoints::of_points(points) }
}

/// A convex curve.
fn bowl() -> KnotPoints {
    let points = [(20, 36), (45, 135), (130, 207), (280, 229), (430, 207), (515, 135), (540, 36)];
    KnotPoints::of_points(points.map(|(x, y)| [f64::from(x), f64::from(y)]).to_vec())
}

/// A curve of order 6 with a double knot.
fn double() -> KnotPoints {
    let points = [(30, 60), (90, 210), (170, 40), (250, 230), (330, 50), (400, 220), (470, 70), (535, 190)];
    let points = points.map(|(x, y)| [f64::from(x), f64::from(y)]).to_vec();
    let knots = vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.5, 6.5, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0];
    KnotPoints { order: 6, knots, ..KnotPoints::of_points(points) }
}

/// A full circle.
fn circle() -> KnotPoints {
    let sides = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let points = sides.map(|(x, y)| [f64::from(280 + 110 * x), f64::from(130 + 110 * y)]).to_vec();
    let weights = (0..9).map(|at| if at % 2 == 0 { 1.0 } else { FRAC_1_SQRT_2 }).collect();
    let knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4].map(f64::from).to_vec();
    KnotPoints { order: 3, closed: false, points: points.into(), weights: Some(weights), knots }
}

/// A hill.
fn hill() -> KnotNet {
    let height = |r2: i32| (400.0 / (2.0 + f64::from(r2)) - 50.0).round();
    let point = |k: i32, l: i32| {
        let [x, y] = [k - 3, l - 3];
        [f64::from(50 * x), f64::from(50 * y), height(x * x + y * y)]
    };
    let knots: Vec<f64> = (0..11).map(f64::from).collect();
    KnotNet {
        order: [4, 4],
        closed: [false; 2],
        points: (0..7).map(|k| (0..7).map(|l| point(k, l)).collect()).collect(),
        weights: None,
        knots: [knots.clone(), knots],
    }
}

fn c_bezier(alpha: f64, points: Vec<[f64; 2]>) -> ShapedPoints {
    let (family, alpha) = (FamilyName::CBezier, Some(alpha));
    ShapedPoints { family, points: points.into(), alpha, ..ShapedPoints::default() }
}

/// Half an arch of a cycloid.
fn cycloid() -> ShapedPoints {
    let points = [(0.0, 0.0), (0.0, 0.0), (0.0, 2.0), (PI, 2.0)];
    c_bezier(PI, points.map(|(x, y)| [90.0 + 120.0 * x, 70.0 + 120.0 * y]).to_vec())
}

/// Half a circle.
fn half_circle() -> ShapedPoints {
    let points = [(1.0, 0.0), (1.0, PI / 2.0), (-1.0, PI / 2.0), (-1.0, 0.0)];
    c_bezier(PI, points.map(|(x, y)| [280.0 + 150.0 * x, 80.0 + 150.0 * y]).to_vec())
}

/// A piece of a helix (cos t, sin t, t / 3) for t from 0 to 2.
fn helix() -> ShapedPoints {
    let point = |t: f64| [100.0 * t.cos(), 100.0 * t.sin(), 100.0 * t / 3.0];
    let slope = |t: f64| [-200.0 * t.sin(), 200.0 * t.cos(), 200.0 / 3.0];
    let points = bezier_points(4.0, [point(0.0), slope(0.0)], [point(2.0), slope(2.0)]);
    let (family, alpha) = (FamilyName::CBezier, Some(2.0));
    ShapedPoints { family, points: points.to_vec().into(), alpha, ..ShapedPoints::default() }
}

/// A chain that hangs: (t, cosh t) for t from -1 to 1.
fn catenary() -> ShapedPoints {
    let point = |t: f64| [280.0 + 200.0 * t, 200.0 * t.cosh() - 100.0];
    let slope = |t: f64| [400.0, 400.0 * t.sinh()];
    let points = bezier_points(-4.0, [point(-1.0), slope(-1.0)], [point(1.0), slope(1.0)]);
    let (family, omega) = (FamilyName::FBezier, Some(-4.0));
    ShapedPoints { family, points: points.to_vec().into(), omega, ..ShapedPoints::default() }
}

/// Five points of a trigonometric Bézier curve.
fn trigonometric() -> ShapedPoints {
    let points = vec![[60.0, 80.0], [120.0, 300.0], [290.0, 340.0], [430.0, 250.0], [510.0, 60.0]];
    ShapedPoints {
        family: FamilyName::TrigBezier,
        points: points.into(),
        n1: Some(2),
        n2: Some(2),
        alpha: Some(3.0),
        beta: Some(2.5),
        ..ShapedPoints::default()
    }
}

/// Nine points with a lambda each; the curve passes the one whose lambda is 4.
fn han() -> ShapedPoints {
    let points = [
        (40, 100),
        (90, 280),
        (160, 320),
        (220, 130),
        (280, 300),
        (340, 90),
        (400, 310),
        (470, 290),
        (520, 110),
    ];
    let lambdas = [0, -2, 1, 0, 4, -1, 2, 1, 0].map(f64::from).to_vec();
    ShapedPoints {
        family: FamilyName::Han,
        points: points.map(|(x, y)| [f64::from(x), f64::from(y)]).to_vec().into(),
        lambda: Some(LambdaValue::Each(lambdas)),
        ..ShapedPoints::default()
    }
}

/// A cyclic triangle: a circle of half its radius.
fn ring() -> ShapedPoints {
    let corner = |k: u8| {
        let (sin, cos) = (f64::from(k) * 2.0 * PI / 3.0).sin_cos();
        [280.0 + (160.0 * cos).round(), 190.0 + (160.0 * sin).round()]
    };
    let points: Vec<[f64; 2]> = (0..3).map(corner).collect();
    ShapedPoints { family: FamilyName::Cyclic, points: points.into(), ..ShapedPoints::default() }
}

/// The Fourier curve of the letter A with 8 of its harmonics, by control points.
fn letter() -> Result<ShapedPoints, FileError> {
    let invalid = |error: &dyn std::fmt::Display| FileError::Invalid(error.to_string());
    let Document::Fourier(fourier) = Document::read(Format::Gbp, &super::fourier_a()?)? else {
        return Err(FileError::Invalid("A.GBP holds coefficients".to_owned()));
    };
    let curve = Fourier::curve(&fourier).map_err(|error| invalid(&error))?;
    let points = cyclic_from_fourier(&curve, 8).map_err(|error| invalid(&error))?;
    // Tenths, so that the last bits of a cosine do not matter, and the letter in the middle of the field.
    let points: Vec<[f64; 2]> =
        points.into_iter().map(|[x, y]| [tenths(x + 280.0), tenths(y + 190.0)]).collect();
    Ok(ShapedPoints { family: FamilyName::Cyclic, points: points.into(), ..ShapedPoints::default() })
}

fn tenths(value: f64) -> f64 {
    (10.0 * value).round() / 10.0
}
