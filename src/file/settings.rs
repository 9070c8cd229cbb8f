//! How a document is to be drawn: what the DOS programs ask at every start and JSON remembers.

use super::{FileError, KnotRule};
use crate::geometry::Joint;
use serde::{Deserialize, Serialize};

/// A method of interpolation or approximation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Coons-Hermite interpolation with tangents from the neighbours (2.13).
    Coons,
    /// Bézier approximation of all points (2.47).
    Bezier,
    /// Cubic spline interpolation (2.28).
    Spline,
    /// Cubic Bézier arcs from joint to joint (2.49).
    Arcs,
    /// B-spline of any degree and knots (2.50).
    #[serde(rename = "bspline")]
    BSpline,
    /// Quadratic B-spline (2.57).
    #[serde(rename = "bspline2")]
    BSpline2,
    /// Cubic B-spline (2.58).
    #[serde(rename = "bspline3")]
    BSpline3,
    /// Beta-spline (2.63).
    Beta,
    /// Spline interpolation with local control (3.61).
    Local,
    /// Hermite interpolation with given tangents (2.12).
    Hermite,
    /// Fourier series (2.8).
    Fourier,
    /// The C2 Pythagorean-hodograph quintic spline through the points of the plane.
    PhSpline,
    /// Pythagorean-hodograph quintics with given tangents, in the plane or in space.
    PhHermite,
    /// Pythagorean-hodograph cubics with given directions of the tangents.
    PhCubic,
    /// Pythagorean normals: through points with unit normals, in standard position.
    Pn,
    /// Pythagorean normals by the thesis's method on the data as they are.
    #[serde(rename = "pn-thesis")]
    PnThesis,
}

impl Method {
    /// Every method with its name in JSON and on command lines.
    pub const ALL: [(&'static str, Self); 16] = [
        ("coons", Self::Coons),
        ("bezier", Self::Bezier),
        ("arcs", Self::Arcs),
        ("spline", Self::Spline),
        ("bspline", Self::BSpline),
        ("bspline2", Self::BSpline2),
        ("bspline3", Self::BSpline3),
        ("beta", Self::Beta),
        ("local", Self::Local),
        ("hermite", Self::Hermite),
        ("fourier", Self::Fourier),
        ("phspline", Self::PhSpline),
        ("phhermite", Self::PhHermite),
        ("phcubic", Self::PhCubic),
        ("pn", Self::Pn),
        ("pn-thesis", Self::PnThesis),
    ];

    /// The method that draws so, with the parameters that it has among these; `None` for those that need
    /// more than control points.
    #[must_use]
    pub fn with(self, k0: f64, bias: f64, tension: f64) -> Option<crate::geometry::Method> {
        use crate::geometry::Method;
        Some(match self {
            Self::Coons => Method::Coons { k0 },
            Self::Bezier => Method::Bezier,
            Self::Arcs => Method::Arcs,
            Self::Spline => Method::Spline,
            Self::BSpline2 => Method::BSpline2,
            Self::BSpline3 => Method::BSpline3,
            Self::Beta => Method::Beta { bias, tension },
            Self::Local => Method::Local { k0 },
            Self::BSpline
            | Self::Hermite
            | Self::Fourier
            | Self::PhSpline
            | Self::PhHermite
            | Self::PhCubic
            | Self::Pn
            | Self::PnThesis => return None,
        })
    }

    /// Its name on the command line and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, method)| *method == self).map_or("", |(name, _)| name)
    }

    /// The method of a name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|&(_, method)| method)
    }
}

/// How a curve is drawn; every part may be missing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CurveSettings {
    /// The method.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub method: Option<Method>,
    /// Whether the last point is joined to the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub closed: Option<bool>,
    /// Tangent coefficient of Coons-Hermite and local splines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub k0: Option<f64>,
    /// Bias of a beta-spline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bias: Option<f64>,
    /// Tension of a beta-spline (half of Barsky's).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
    /// The degree of a B-spline, 1 to 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub degree: Option<usize>,
    /// The rule for the knots of a PH spline, a spline or a B-spline, or the knots of a B-spline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub knots: Option<KnotRule>,
    /// The derivative at the start of an open PH spline or spline, in units per knot, with knot steps whose mean is 1:
    /// as many coordinates as the points have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<Vec<f64>>,
    /// The derivative at the end of such a curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<Vec<f64>>,
    /// The joints of Bézier arcs, as numbers of points from 1, whose two handles are kept on a line with them; the other
    /// joints are corners.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smooth: Option<Vec<usize>>,
}

/// How a surface is drawn; every part may be missing. Pairs are for the directions u and v.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NetSettings {
    /// The method.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub method: Option<Method>,
    /// Tangent coefficients of local splines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub k0: Option<[f64; 2]>,
    /// Biases of a beta-spline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bias: Option<[f64; 2]>,
    /// Tensions of a beta-spline (half of Barsky's).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<[f64; 2]>,
    /// Whether a cubic B-spline is led to its borders and poles instead of ending before them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extended: Option<bool>,
    /// The distance along the normals of the offset that is drawn beside a surface with Pythagorean normals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distance: Option<f64>,
    /// What two patches keep at their joint; a net with it holds two patches with a common border.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<Joint>,
    /// How long the derivatives of the second patch are across the joint by those of the first, where the tangent plane
    /// is kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Whether the meridians of a sphere end at the poles for themselves, which makes them singular.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_poles: Option<bool>,
    /// Whether the border points of an open B-spline net are auxiliary: the inner patches alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inner: Option<bool>,
}

impl CurveSettings {
    /// Whether nothing is set; an empty object is not written.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// # Errors
    /// [`FileError::Invalid`] for an end with another number of coordinates than the points, a number that is not
    /// finite, and a smooth joint that is none of the points.
    pub(super) fn check(&self, coordinates: usize, points: usize) -> Result<(), FileError> {
        for (name, end) in [("start", &self.start), ("end", &self.end)] {
            let Some(end) = end else { continue };
            if end.len() != coordinates {
                let given = end.len();
                return Err(FileError::Invalid(format!(
                    "settings, {name}: {given} coordinates; there must be {coordinates}"
                )));
            }
            finite(name, end)?;
        }
        if let Some(KnotRule::Given(knots)) = &self.knots {
            finite("knots", knots)?;
        }
        let wrong = self.smooth.iter().flatten().find(|number| !(1..=points).contains(*number));
        match wrong {
            Some(number) => {
                Err(FileError::Invalid(format!("settings, smooth: there is no point {number} of {points}")))
            }
            None => Ok(()),
        }
    }
}

fn finite(name: &str, values: &[f64]) -> Result<(), FileError> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(index) => {
            Err(FileError::Invalid(format!("settings, {name}: number {} is not finite", index + 1)))
        }
        None => Ok(()),
    }
}

impl NetSettings {
    /// Whether nothing is set; an empty object is not written.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// The names of the settings that are given, as JSON calls them.
pub(super) fn given(settings: &impl Serialize) -> Vec<String> {
    // Plain structs of numbers and names always become a map; an error would only mean "nothing known".
    match serde_json::to_value(settings) {
        Ok(serde_json::Value::Object(map)) => map.keys().cloned().collect(),
        _ => Vec::new(),
    }
}

/// One line for each given setting: `method: "beta"`.
pub(super) fn describe(settings: &impl Serialize) -> Vec<String> {
    match serde_json::to_value(settings) {
        Ok(serde_json::Value::Object(map)) => {
            map.iter().map(|(name, value)| format!("{name}: {value}")).collect()
        }
        _ => Vec::new(),
    }
}
