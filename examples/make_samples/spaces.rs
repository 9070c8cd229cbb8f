//! The samples of KC_TER: spaces of the thesis's figures, and curves and surfaces that are described exactly.

use grafika::design::ec::Bases;
use grafika::file::ec::{Coefficients, CurveTerm, EcDocument, Interval, Item, PatchTerm, Scene, SpaceFile};
use grafika::file::{Document, FileError};
use grafika::geometry::ec::{EcError, Real, Space};

type Value = [&'static str; 3];

/// Every file: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let made = documents().map_err(|error| FileError::Invalid(error.to_string()))?;
    made.into_iter()
        .map(|(name, document)| {
            let document = Document::from(document);
            Ok((name, document.write(document.format())?))
        })
        .collect()
}

fn documents() -> Result<Vec<(&'static str, EcDocument)>, EcError> {
    let spiral = curve("0,1/4+i", ["0", "3*pi"], &[(1, ["10", "0", "0"]), (2, ["0", "10", "0"])])?;
    let circle = curve("0,i", ["0", "2*pi"], &[(1, ["100", "0", "0"]), (2, ["0", "100", "0"])])?;
    let helix =
        curve("0^2,i", ["0", "pi"], &[(1, ["0", "0", "30"]), (2, ["80", "0", "0"]), (3, ["0", "80", "0"])])?;
    let cycloid = curve(
        "0^2,i",
        ["0", "4*pi"],
        &[(0, ["0", "0", "20"]), (1, ["20", "0", "0"]), (3, ["-20", "0", "0"]), (2, ["0", "0", "-20"])],
    )?;
    // (2 + cos 3u)(cos 2u, sin 2u), sin 3u, multiplied out.
    let trefoil = curve(
        "0,i,2i,3i,5i",
        ["0", "2*pi"],
        &[
            (1, ["20", "0", "0"]),
            (3, ["80", "0", "0"]),
            (7, ["20", "0", "0"]),
            (2, ["0", "-20", "0"]),
            (4, ["0", "80", "0"]),
            (8, ["0", "20", "0"]),
            (6, ["0", "0", "40"]),
        ],
    )?;
    let torus = surface(
        [("0,i", ["0", "2*pi"]), ("0,i", ["0", "2*pi"])],
        &[
            ([0, 1], ["2", "0", "0"]),
            ([1, 1], ["1", "0", "0"]),
            ([0, 2], ["0", "2", "0"]),
            ([1, 2], ["0", "1", "0"]),
            ([2, 0], ["0", "0", "1"]),
        ],
    )?;
    let snail = snail()?;
    Ok(vec![
        ("A.KCJ", strips(&circle, [Some(3), None])?),
        ("SPIRAL.KCJ", strips(&spiral, [Some(6), None])?),
        ("HELIX.KCG", single(&helix)?),
        ("CYCLOID.KCJ", strips(&cycloid, [Some(4), None])?),
        ("TREFOIL.KCJ", strips(&trefoil, [None; 2])?),
        ("TORUS.KCJ", strips(&torus, [Some(4); 2])?),
        ("SNAIL.KCJ", strips(&snail, [Some(4), Some(3)])?),
        ("SNAIL.KCE", EcDocument::Coefficients(snail)),
        ("AT8.KCT", space("AT8", "0^3,i^2,2i", ["-pi/2", "pi/2"])?),
        ("AE5.KCT", space("AE5", "0^2,1^2,2^2", ["-1", "1"])?),
    ])
}

/// The snail shell (3.3) of the thesis.
fn snail() -> Result<Coefficients, EcError> {
    let spaces = [("0,i,1/(6*pi),1/(3*pi),1/(6*pi)+i", ["30*pi/8", "50*pi/8"]), ("0,i", ["-pi/3", "5*pi/3"])];
    surface(
        spaces,
        &[
            ([1, 0], ["5/4", "0", "0"]),
            ([1, 1], ["1", "0", "0"]),
            ([5, 0], ["-5/4", "0", "0"]),
            ([5, 1], ["-1", "0", "0"]),
            ([6, 0], ["0", "5/4", "0"]),
            ([6, 1], ["0", "1", "0"]),
            ([2, 0], ["0", "-5/4", "0"]),
            ([2, 1], ["0", "-1", "0"]),
            ([0, 0], ["0", "0", "7"]),
            ([4, 0], ["0", "0", "-1"]),
            ([0, 2], ["0", "0", "-1"]),
            ([3, 2], ["0", "0", "1"]),
        ],
    )
}

fn interval([start, end]: [&str; 2]) -> Result<Interval, EcError> {
    Ok([Real::typed(start)?, Real::typed(end)?])
}

fn value([x, y, z]: Value) -> Result<[Real; 3], EcError> {
    Ok([Real::typed(x)?, Real::typed(y)?, Real::typed(z)?])
}

fn curve(roots: &str, ends: [&str; 2], terms: &[(usize, Value)]) -> Result<Coefficients, EcError> {
    let terms = terms.iter().map(|&(function, it)| Ok(CurveTerm { function, value: value(it)? }));
    Ok(Coefficients::Curve {
        space: roots.parse()?,
        interval: interval(ends)?,
        coefficients: terms.collect::<Result<_, EcError>>()?,
    })
}

fn surface(
    [(u, ends_u), (v, ends_v)]: [(&str, [&str; 2]); 2],
    terms: &[([usize; 2], Value)],
) -> Result<Coefficients, EcError> {
    let terms = terms.iter().map(|&([u, v], it)| Ok(PatchTerm { u, v, value: value(it)? }));
    Ok(Coefficients::Surface {
        space_u: u.parse()?,
        interval_u: interval(ends_u)?,
        space_v: v.parse()?,
        interval_v: interval(ends_v)?,
        coefficients: terms.collect::<Result<_, EcError>>()?,
    })
}

fn strips(coefficients: &Coefficients, parts: [Option<usize>; 2]) -> Result<EcDocument, EcError> {
    let items = Bases::default().strips(coefficients, parts)?;
    Ok(EcDocument::Scene(Scene { items, ..Scene::default() }))
}

fn single(coefficients: &Coefficients) -> Result<EcDocument, EcError> {
    Ok(match Bases::default().described(coefficients)? {
        Item::Curve(curve) => EcDocument::Curve(curve),
        Item::Patch(patch) => EcDocument::Patch(patch),
    })
}

fn space(name: &str, roots: &str, ends: [&str; 2]) -> Result<EcDocument, EcError> {
    let space: Space = roots.parse()?;
    Ok(EcDocument::Space(SpaceFile { space, interval: Some(interval(ends)?), name: Some(name.to_owned()) }))
}
