//! The samples of SOM_FEL: clouds of known surfaces with noise.

use grafika::file::{Cloud, Document, FileError, Format};
use grafika::geometry::cloud::{self, CloudShape};

/// The standard deviation of the noise.
const NOISE: f64 = 0.02;

/// Every file: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let clouds = [
        ("FELGOMB.XYZ", CloudShape::Hemisphere, 2000),
        ("NYEREG.XYZ", CloudShape::Saddle, 2000),
        ("NYOM.XYZ", CloudShape::Letter, 800),
        ("TEREP.XYZ", CloudShape::Terrain, 2000),
        ("TORUSZ.XYZ", CloudShape::Torus, 2000),
    ];
    clouds.into_iter().map(|(name, shape, count)| Ok((name, points(shape, count)?))).collect()
}

/// Points rounded to four decimals, a two-hundredth of the noise, so that the files stay small.
fn points(shape: CloudShape, count: usize) -> Result<Vec<u8>, FileError> {
    let cloud = cloud::Cloud::of_shape(shape, count, NOISE, 1)
        .map_err(|error| FileError::Invalid(error.to_string()))?;
    // The sum makes a zero of a negative one.
    let round = |value: f64| (value * 1e4).round() / 1e4 + 0.0;
    let points = cloud.points().iter().map(|point| point.map(round)).collect();
    Document::Cloud(Cloud::new(points)).write(Format::Xyz)
}
