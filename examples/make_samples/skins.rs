//! The samples of BURKOLO: circles and spheres for skins.

use grafika::file::{Circles, Document, FileError, FileKind, Spheres};

/// Every file: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let documents: [(&str, Document); 7] = [
        ("ATFEDO.KOR", chain(&[[0.0, 0.0, 2.0], [2.0, 0.3, 2.0], [3.6, 0.0, 2.0], [6.5, 0.5, 1.5]])),
        ("GYURU.KOR", ring()),
        ("KEZ.KOR", hand()),
        (
            "KIGYO.KOR",
            chain(&[[0.0, 0.0, 1.0], [3.0, 1.0, 1.4], [6.0, 0.5, 0.8], [8.5, 2.5, 1.2], [9.0, 6.0, 1.0]]),
        ),
        ("ROSSZ.KOR", chain(&[[0.0, 0.0, 2.0], [1.5, 3.0, 1.0], [3.0, 0.0, 2.0]])),
        ("VILLA.KOR", fork()),
        ("CSIGA.GOM", snail()),
    ];
    documents.into_iter().map(|(name, document)| Ok((name, document.encode(FileKind::Json)?))).collect()
}

/// Pixels a unit, and the place of the origin in the field.
const SCALE: f64 = 26.0;
const ORIGIN: [f64; 2] = [90.0, 120.0];

/// A circle in the field, to hundredths, so that the last bits of a cosine do not matter.
fn placed([x, y, r]: [f64; 3]) -> [f64; 3] {
    [ORIGIN[0] + SCALE * x, ORIGIN[1] + SCALE * y, SCALE * r].map(|value| (100.0 * value).round() / 100.0)
}

fn chain(circles: &[[f64; 3]]) -> Document {
    let circles = circles.iter().copied().map(placed).collect();
    Document::Circles(Box::new(Circles { circles, ..Circles::default() }))
}

/// An arm with a hand at one end and a shoulder at the other.
fn hand() -> Document {
    chain(&[
        [0.0, 0.0, 3.0],
        [4.0, 2.0, 1.2],
        [6.5, 4.0, 1.0],
        [9.0, 5.0, 1.5],
        [12.0, 4.0, 0.9],
        [14.5, 2.5, 1.1],
        [17.0, 2.6, 0.5],
    ])
}

/// Eight circles around, large and small in turn.
fn ring() -> Document {
    let circle = |k: u8| {
        let (sine, cosine) = (f64::from(k) * 45.0).to_radians().sin_cos();
        placed([8.0 + 5.0 * cosine, 3.0 + 5.0 * sine, if k.is_multiple_of(2) { 1.2 } else { 1.8 }])
    };
    let circles = (0..8).map(circle).collect();
    Document::Circles(Box::new(Circles { circles, closed: true, edges: None }))
}

/// A joint with three arms of two circles each.
fn fork() -> Document {
    let arm = |degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [(3.2, 0.9), (5.4, 0.6)].map(|(far, r)| placed([8.0 + far * cosine, 4.0 + far * sine, r]))
    };
    let arms = [20.0, 140.0, 260.0].into_iter().flat_map(arm);
    let circles = std::iter::once(placed([8.0, 4.0, 1.5])).chain(arms).collect();
    let edges = vec![[0, 1], [1, 2], [0, 3], [3, 4], [0, 5], [5, 6]];
    Document::Circles(Box::new(Circles { circles, closed: false, edges: Some(edges) }))
}

/// Five spheres that wind upwards.
fn snail() -> Document {
    let spheres = vec![
        [0.0, 0.0, 0.0, 1.0],
        [3.0, 1.0, 0.5, 1.3],
        [6.0, 0.5, 2.0, 0.9],
        [8.0, 2.5, 4.0, 1.2],
        [8.5, 6.0, 5.0, 0.7],
    ];
    Document::Spheres(Box::new(Spheres { spheres, ..Spheres::default() }))
}
