//! Spaces, curves, surfaces and scenes of KC_TER: `.KCT`, `.KCG`, `.KCF`, `.KCE` and `.KCJ`, which are JSON only.
//!
//! A number may be an expression in quotes, `"pi/2"`; it is kept as written where it is part of a space, an interval or
//! an exact description. Coefficients belong to functions of the ordinary basis, by their number in the order of the
//! roots, 0 first ([`Space::functions`]).

mod describe;
mod point;
mod scene;
mod style;

pub use describe::{curve_formulas, patch_formulas};
pub use scene::{Border, Corner, Item, Join, Scene, SceneSettings, SceneView};
pub use style::{CurveStyle, Fill, Light, Material, PatchStyle};

use super::{Document, FileError, Format};
use crate::geometry::Point;
use crate::geometry::ec::{EcError, MAX_DIMENSION, Real, Space};
use serde::{Deserialize, Serialize};

/// What a file of KC_TER holds.
#[derive(Clone, Debug, PartialEq)]
pub enum EcDocument {
    /// `.KCT`: a space and an interval.
    Space(SpaceFile),
    /// `.KCG`: a curve.
    Curve(EcCurve),
    /// `.KCF`: a surface patch.
    Patch(EcPatch),
    /// `.KCE`: the coefficients of an exact description.
    Coefficients(Coefficients),
    /// `.KCJ`: a scene.
    Scene(Scene),
}

/// An interval of the parameter.
pub type Interval = [Real; 2];

/// A space with an interval.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpaceFile {
    /// The space.
    #[serde(rename = "roots")]
    pub space: Space,
    /// The interval, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interval: Option<Interval>,
    /// What the space is called.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

/// One arc of a curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EcCurve {
    /// The space.
    #[serde(rename = "roots")]
    pub space: Space,
    /// The interval.
    pub interval: Interval,
    /// The control points, as many as the space has functions.
    #[serde(with = "point::list")]
    pub points: Vec<Point<3>>,
    /// The exact description, where the control points are one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exact: Option<Vec<CurveTerm>>,
    /// How it is drawn.
    #[serde(default, skip_serializing_if = "CurveStyle::is_usual")]
    pub style: CurveStyle,
    /// What it is called.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

impl EcCurve {
    /// Whether there is a space for so many control points.
    pub(in crate::file) fn holds(points: usize) -> bool {
        (2..=MAX_DIMENSION).contains(&points)
    }

    /// The Bézier curve of these control points: polynomials on [0, 1].
    pub(in crate::file) fn of_points(points: Vec<Point<3>>) -> Self {
        Self {
            space: Space::polynomials(points.len().saturating_sub(1)),
            interval: [0.0, 1.0].map(Real::from),
            points,
            exact: None,
            style: CurveStyle::default(),
            name: None,
        }
    }
}

impl From<EcCurve> for Document {
    fn from(curve: EcCurve) -> Self {
        EcDocument::Curve(curve).into()
    }
}

/// One patch of a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EcPatch {
    /// The space along u.
    #[serde(rename = "roots_u")]
    pub space_u: Space,
    /// The interval of u.
    pub interval_u: Interval,
    /// The space along v.
    #[serde(rename = "roots_v")]
    pub space_v: Space,
    /// The interval of v.
    pub interval_v: Interval,
    /// The control points: a row for each function along u.
    #[serde(with = "point::net")]
    pub net: Vec<Vec<Point<3>>>,
    /// The exact description, where the control points are one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exact: Option<Vec<PatchTerm>>,
    /// How it is drawn.
    #[serde(default, skip_serializing_if = "PatchStyle::is_usual")]
    pub style: PatchStyle,
    /// What it is called.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

/// A function of the ordinary basis with its coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CurveTerm {
    /// The function's number, from 0.
    pub function: usize,
    /// Its coefficient in x, y and z.
    #[serde(with = "point::reals")]
    pub value: [Real; 3],
}

/// A product of two functions of the ordinary bases with its coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PatchTerm {
    /// The number of the function along u, from 0.
    pub u: usize,
    /// The number of the function along v, from 0.
    pub v: usize,
    /// The coefficient in x, y and z.
    #[serde(with = "point::reals")]
    pub value: [Real; 3],
}

/// An exact description.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Coefficients {
    /// Of a curve.
    Curve {
        /// The space.
        #[serde(rename = "roots")]
        space: Space,
        /// The interval.
        interval: Interval,
        /// The coefficients that are not 0; those of the same function add up.
        coefficients: Vec<CurveTerm>,
    },
    /// Of a surface.
    Surface {
        /// The space along u.
        #[serde(rename = "roots_u")]
        space_u: Space,
        /// The interval of u.
        interval_u: Interval,
        /// The space along v.
        #[serde(rename = "roots_v")]
        space_v: Space,
        /// The interval of v.
        interval_v: Interval,
        /// The coefficients that are not 0; those of the same product add up.
        coefficients: Vec<PatchTerm>,
    },
}

/// The values of two expressions.
#[must_use]
pub fn values(interval: &Interval) -> [f64; 2] {
    [interval[0].value(), interval[1].value()]
}

impl EcDocument {
    pub(super) fn format(&self) -> Format {
        match self {
            Self::Space(_) => Format::Kct,
            Self::Curve(_) => Format::Kcg,
            Self::Patch(_) => Format::Kcf,
            Self::Coefficients(_) => Format::Kce,
            Self::Scene(_) => Format::Kcj,
        }
    }

    /// # Errors
    /// [`FileError::Invalid`] with what does not belong together.
    pub(super) fn check(&self) -> Result<(), FileError> {
        match self {
            Self::Space(file) => {
                file.interval.as_ref().map_or(Ok(()), |interval| ordered("interval", interval))
            }
            Self::Curve(curve) => curve.check(),
            Self::Patch(patch) => patch.check(),
            Self::Coefficients(Coefficients::Curve { space, interval, coefficients }) => {
                ordered("interval", interval)?;
                known(coefficients, space)
            }
            Self::Coefficients(Coefficients::Surface {
                space_u,
                interval_u,
                space_v,
                interval_v,
                coefficients,
            }) => {
                ordered("interval_u", interval_u)?;
                ordered("interval_v", interval_v)?;
                known_products(coefficients, space_u, space_v)
            }
            Self::Scene(scene) => scene.check(),
        }
    }
}

impl From<EcDocument> for super::Document {
    fn from(document: EcDocument) -> Self {
        Self::Ec(Box::new(document))
    }
}

impl EcCurve {
    fn check(&self) -> Result<(), FileError> {
        ordered("interval", &self.interval)?;
        let (given, needed) = (self.points.len(), self.space.dimension());
        if given != needed {
            let text = format!("the curve has {given} control points, but its space has dimension {needed}");
            return Err(FileError::Invalid(text));
        }
        super::check::finite("point", &self.points)?;
        self.exact.as_ref().map_or(Ok(()), |terms| known(terms, &self.space))?;
        self.style.check()
    }
}

impl EcPatch {
    fn check(&self) -> Result<(), FileError> {
        ordered("interval_u", &self.interval_u)?;
        ordered("interval_v", &self.interval_v)?;
        let [rows, columns] = [&self.space_u, &self.space_v].map(Space::dimension);
        if self.net.len() != rows {
            let text =
                format!("the net has {} rows, but its space along u has dimension {rows}", self.net.len());
            return Err(FileError::Invalid(text));
        }
        for (row, points) in self.net.iter().enumerate() {
            if points.len() != columns {
                return Err(FileError::Invalid(format!(
                    "row {} of the net has {} points, but its space along v has dimension {columns}",
                    row + 1,
                    points.len()
                )));
            }
            super::check::finite(&format!("row {}, point", row + 1), points)?;
        }
        self.exact.as_ref().map_or(Ok(()), |terms| known_products(terms, &self.space_u, &self.space_v))?;
        self.style.check()
    }
}

/// The interval has a start before its end.
fn ordered(name: &str, interval: &Interval) -> Result<(), FileError> {
    let [start, end] = values(interval);
    match start < end && (end - start).is_finite() {
        true => Ok(()),
        false => Err(FileError::Invalid(format!("{name}: {}", EcError::Interval { start, end }))),
    }
}

/// All functions are there, and their coefficients are numbers.
fn known(terms: &[CurveTerm], space: &Space) -> Result<(), FileError> {
    terms.iter().try_for_each(|term| exists(term.function, space).and_then(|()| numbers(&term.value)))
}

fn known_products(terms: &[PatchTerm], u: &Space, v: &Space) -> Result<(), FileError> {
    terms.iter().try_for_each(|term| {
        exists(term.u, u)?;
        exists(term.v, v)?;
        numbers(&term.value)
    })
}

fn exists(given: usize, space: &Space) -> Result<(), FileError> {
    let dimension = space.dimension();
    match given < dimension {
        true => Ok(()),
        false => Err(FileError::Invalid(EcError::Function { given, dimension }.to_string())),
    }
}

fn numbers(value: &[Real; 3]) -> Result<(), FileError> {
    match value.iter().find(|value| !value.value().is_finite()) {
        None => Ok(()),
        Some(value) => Err(FileError::Invalid(format!("the coefficient {value} is not a finite number"))),
    }
}
