//! Curves with shape parameters, `.ALP`, which are JSON only.

use super::check::{self, number};
use super::{FileError, Fourier, HARMONICS, Places};
use crate::geometry::GeometryError;
use crate::geometry::shaped::{
    Family, LambdaKind, Lambdas, Phi, Trig, cyclic_from_fourier, cyclic_to_fourier,
};
use serde::{Deserialize, Serialize};

/// The kinds of curve by the names in documents and commands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs, reason = "geometry::shaped::Family says what each one is")]
pub enum FamilyName {
    #[default]
    CBezier,
    #[serde(rename = "c-bspline")]
    CBSpline,
    FBezier,
    #[serde(rename = "f-bspline")]
    FBSpline,
    TrigBezier,
    Han,
    Alpha,
    Gb,
    Spb,
    HanQuadratic,
    Cyclic,
}

impl FamilyName {
    /// Every family with its name.
    pub const ALL: [(Self, &'static str); 11] = [
        (Self::CBezier, "c-bezier"),
        (Self::CBSpline, "c-bspline"),
        (Self::FBezier, "f-bezier"),
        (Self::FBSpline, "f-bspline"),
        (Self::TrigBezier, "trig-bezier"),
        (Self::Han, "han"),
        (Self::Alpha, "alpha"),
        (Self::Gb, "gb"),
        (Self::Spb, "spb"),
        (Self::HanQuadratic, "han-quadratic"),
        (Self::Cyclic, "cyclic"),
    ];

    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(family, _)| *family == self).map_or("", |(_, name)| name)
    }

    /// The family of a name.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| known.eq_ignore_ascii_case(name)).map(|(family, _)| *family)
    }

    /// The fields that its documents have besides points.
    fn fields(self) -> &'static [&'static str] {
        match self {
            Self::CBezier | Self::CBSpline => &["alpha"],
            Self::FBezier | Self::FBSpline => &["omega"],
            Self::TrigBezier => &["n1", "n2", "alpha", "beta", "phi"],
            Self::Han | Self::HanQuadratic => &["lambda"],
            Self::Alpha | Self::Gb | Self::Spb => &["lambda", "blend"],
            Self::Cyclic => &[],
        }
    }

    fn lambda_kind(self) -> Option<LambdaKind> {
        match self {
            Self::Han => Some(LambdaKind::Han),
            Self::Alpha => Some(LambdaKind::Alpha),
            Self::Gb => Some(LambdaKind::Gb),
            Self::Spb => Some(LambdaKind::Spb),
            _ => None,
        }
    }
}

/// One lambda for the curve, or one for every control point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "a number, or a list with a number for every control point")]
pub enum LambdaValue {
    /// The same everywhere.
    One(f64),
    /// One for every control point (`han` and `gb`).
    Each(Vec<f64>),
}

/// How a trigonometric Bézier curve is run through, by the names in documents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs, reason = "geometry::shaped::Phi says what each one is")]
pub enum PhiName {
    Trig,
    Power,
    Rational,
}

/// A curve with shape parameters: the family, control points, and the parameters that the family has.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShapedPoints {
    /// The kind of curve.
    pub family: FamilyName,
    /// The control points.
    pub points: Places,
    /// Whether the last span is followed by the first; cyclic curves always are.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// Of `c-bezier` and `c-bspline` in (0, pi]; of `trig-bezier` from n1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub alpha: Option<f64>,
    /// Of `trig-bezier`, from n2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beta: Option<f64>,
    /// Of `f-bezier` and `f-bspline`, -900 to pi^2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub omega: Option<f64>,
    /// Of `trig-bezier`: control points before the middle one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub n1: Option<usize>,
    /// Of `trig-bezier`: control points behind the middle one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub n2: Option<usize>,
    /// Of `trig-bezier`: the parametrization; `trig` if it is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi: Option<PhiName>,
    /// Of the others but `cyclic`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lambda: Option<LambdaValue>,
    /// Of `alpha`, `gb` and `spb`: the polygon that is blended in, where it is not that of the points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blend: Option<Places>,
    /// Whether the joints of the curve are points that it was made to pass. The curve is the same without it; editors
    /// then show those points in place of the control points.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub through: bool,
}

impl ShapedPoints {
    /// The uniform cubic B-spline, as the F-B-spline of omega 0.
    #[must_use]
    pub fn of_points(points: impl Into<Places>) -> Self {
        let (family, omega) = (FamilyName::FBSpline, Some(0.0));
        Self { family, points: points.into(), omega, ..Self::default() }
    }

    /// The cyclic curve of Fourier coefficients, with as many harmonics as are not 0; `None` where its points leave the
    /// limits of coordinates.
    #[must_use]
    pub fn of_fourier(fourier: &Fourier) -> Option<Self> {
        let used = (1..HARMONICS).rev().find(|&k| fourier.a[k] != 0.0 || fourier.b[k] != 0.0);
        let points = cyclic_from_fourier(&fourier.curve().ok()?, used.unwrap_or(1)).ok()?;
        Some(Self { family: FamilyName::Cyclic, points: points.into(), ..Self::default() })
    }

    /// The coefficients of a cyclic curve of the plane; `None` for other curves, or more harmonics than a file holds.
    #[must_use]
    pub fn to_fourier(&self) -> Option<Fourier> {
        let points = self.points.plane().filter(|_| self.family == FamilyName::Cyclic)?;
        let curve = cyclic_to_fourier(points).ok()?;
        (curve.harmonics() < HARMONICS).then(|| Fourier::of_curve(&curve))
    }

    /// The family with its parameters.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a value out of range; a missing parameter counts as NaN.
    pub fn parameters(&self) -> Result<Family, GeometryError> {
        let given = |value: Option<f64>| value.unwrap_or(f64::NAN);
        if let Some(kind) = self.family.lambda_kind() {
            let lambda = match &self.lambda {
                Some(LambdaValue::Each(all)) => Lambdas::Each(all.clone()),
                Some(LambdaValue::One(lambda)) => Lambdas::One(*lambda),
                None => Lambdas::One(f64::NAN),
            };
            return Ok(Family::Lambda { kind, lambda });
        }
        Ok(match self.family {
            FamilyName::CBezier => Family::c_bezier(given(self.alpha))?,
            FamilyName::CBSpline => Family::c_b_spline(given(self.alpha))?,
            FamilyName::FBezier => Family::FBezier { omega: given(self.omega) },
            FamilyName::FBSpline => Family::FBSpline { omega: given(self.omega) },
            FamilyName::TrigBezier => {
                let phi = match self.phi.unwrap_or(PhiName::Trig) {
                    PhiName::Trig => Phi::Trig,
                    PhiName::Power => Phi::Power,
                    PhiName::Rational => Phi::Rational,
                };
                let sides = [self.n1, self.n2].map(|n| n.unwrap_or(0));
                Family::Trig(Trig::new(sides[0], sides[1], given(self.alpha), given(self.beta), phi)?)
            }
            FamilyName::HanQuadratic => Family::HanQuadratic {
                lambda: match &self.lambda {
                    Some(LambdaValue::One(lambda)) => *lambda,
                    _ => f64::NAN,
                },
            },
            _ => Family::Cyclic,
        })
    }

    /// The document with the parameters of a family, the other fields kept that it has.
    #[must_use]
    pub fn with_parameters(&self, family: &Family) -> Self {
        let of_waves = matches!(self.family, FamilyName::CBezier | FamilyName::CBSpline);
        let mut next = Self {
            family: self.family,
            points: self.points.clone(),
            closed: self.closed,
            phi: self.phi,
            blend: self.blend.clone(),
            through: self.through,
            ..Self::default()
        };
        match family {
            Family::FBezier { omega } | Family::FBSpline { omega } if of_waves && *omega > 0.0 => {
                next.alpha = Some(omega.sqrt());
            }
            Family::FBezier { omega } | Family::FBSpline { omega } => {
                let bezier = matches!(family, Family::FBezier { .. });
                next.family = if bezier { FamilyName::FBezier } else { FamilyName::FBSpline };
                next.omega = Some(*omega);
            }
            Family::Trig(trig) => {
                let ([n1, n2], [alpha, beta]) = (trig.sides(), trig.exponents());
                (next.n1, next.n2, next.alpha, next.beta) = (Some(n1), Some(n2), Some(alpha), Some(beta));
                next.phi = Some(match trig.phi() {
                    Phi::Trig => PhiName::Trig,
                    Phi::Power => PhiName::Power,
                    Phi::Rational => PhiName::Rational,
                });
                next.family = FamilyName::TrigBezier;
            }
            Family::Lambda { kind, lambda } => {
                next.family = match kind {
                    LambdaKind::Han => FamilyName::Han,
                    LambdaKind::Alpha => FamilyName::Alpha,
                    LambdaKind::Gb => FamilyName::Gb,
                    LambdaKind::Spb => FamilyName::Spb,
                };
                next.lambda = Some(match lambda {
                    Lambdas::One(lambda) => LambdaValue::One(*lambda),
                    Lambdas::Each(all) => LambdaValue::Each(all.clone()),
                });
            }
            Family::HanQuadratic { lambda } => {
                (next.family, next.lambda) = (FamilyName::HanQuadratic, Some(LambdaValue::One(*lambda)));
            }
            Family::Cyclic => next.family = FamilyName::Cyclic,
        }
        if !next.family.fields().contains(&"blend") {
            next.blend = None;
        }
        if !next.family.fields().contains(&"phi") {
            next.phi = None;
        }
        next
    }

    /// Which fields are given.
    fn given(&self) -> [(&'static str, bool); 8] {
        [
            ("alpha", self.alpha.is_some()),
            ("beta", self.beta.is_some()),
            ("omega", self.omega.is_some()),
            ("n1", self.n1.is_some()),
            ("n2", self.n2.is_some()),
            ("phi", self.phi.is_some()),
            ("lambda", self.lambda.is_some()),
            ("blend", self.blend.is_some()),
        ]
    }

    /// # Errors
    /// [`FileError::Invalid`]: a parameter is missing, does not belong to the family or is out of range.
    pub(super) fn check(&self) -> Result<(), FileError> {
        self.points.check()?;
        let (name, fields) = (self.family.name(), self.family.fields());
        for (field, given) in self.given() {
            let optional = matches!(field, "phi" | "blend");
            match (fields.contains(&field), given) {
                (true, false) if !optional => {
                    return Err(FileError::Invalid(format!("{name} curves need \"{field}\"")));
                }
                (false, true) => {
                    return Err(FileError::Invalid(format!("{name} curves have no \"{field}\"")));
                }
                _ => {}
            }
        }
        let one = matches!(self.family, FamilyName::Alpha | FamilyName::Spb | FamilyName::HanQuadratic);
        match &self.lambda {
            Some(LambdaValue::Each(_)) if one => {
                let problem = format!("{name} curves have one lambda, not one for every point");
                return Err(FileError::Invalid(problem));
            }
            Some(LambdaValue::Each(all)) => {
                check::one_each("lambdas", all.len(), self.points.len())?;
            }
            _ => {}
        }
        if let Some(blend) = &self.blend {
            blend.check()?;
            check::one_each("points of the polygon \"blend\"", blend.len(), self.points.len())?;
            if matches!(blend, Places::Plane(_)) != matches!(self.points, Places::Plane(_)) {
                let problem = "the points of \"blend\" must have as many coordinates as the control points";
                return Err(FileError::Invalid(problem.to_owned()));
            }
        }
        let checked = self.parameters().and_then(|family| family.check(self.points.len()));
        checked.map_err(|error| FileError::Invalid(error.to_string()))
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let place = if matches!(self.points, Places::Plane(_)) { "of the plane" } else { "in space" };
        let closed = if self.closed && self.family != FamilyName::Cyclic { ", closed" } else { "" };
        let count = check::counted(self.points.len(), "control point");
        let mut lines = vec![format!("{} curve {place}: {count}{closed}", self.family.name())];
        lines.extend(self.points.bounds());
        let whole = |n: Option<usize>| n.map(|n| n.to_string());
        let values = [
            ("n1", whole(self.n1)),
            ("n2", whole(self.n2)),
            ("alpha", self.alpha.map(number)),
            ("beta", self.beta.map(number)),
            ("omega", self.omega.map(number)),
            (
                "lambda",
                self.lambda.as_ref().map(|lambda| match lambda {
                    LambdaValue::One(lambda) => number(*lambda),
                    LambdaValue::Each(_) => "one for every point".to_owned(),
                }),
            ),
        ];
        lines.extend(values.into_iter().filter_map(|(name, value)| value.map(|it| format!("{name}: {it}"))));
        lines.extend(self.points.table(|index| match &self.lambda {
            Some(LambdaValue::Each(all)) => {
                all.get(index).map_or(String::new(), |it| format!(", lambda {}", number(*it)))
            }
            _ => String::new(),
        }));
        if self.blend.is_some() {
            lines.push("it passes the points: the polygon blended in is another".to_owned());
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::Document;

    #[test]
    fn parameters_that_a_family_does_not_have_or_lacks_are_told() {
        let points = "\"points\":[[0,0],[1,2],[3,0],[4,4]]";
        for (fields, told) in [
            ("\"family\":\"c-bezier\"", "c-bezier curves need \"alpha\""),
            ("\"family\":\"c-bezier\",\"alpha\":4", "alpha is 4, but must be larger than 0 and at most pi"),
            ("\"family\":\"han\",\"lambda\":1,\"alpha\":1", "han curves have no \"alpha\""),
            ("\"family\":\"spb\",\"lambda\":[1,1,1,1]", "spb curves have one lambda"),
            ("\"family\":\"gb\",\"lambda\":[1,1]", "2 lambdas for 4 points"),
            ("\"family\":\"f-bspline\",\"omega\":10", "omega"),
            ("\"family\":\"bezier\"", "there is no \"bezier\" here, only \""),
        ] {
            let text = format!("{{\"format\":\"ALP\",{fields},{points}}}");
            let refused = Document::from_json(&text).unwrap_err().to_string();
            assert!(refused.contains(told), "{refused}");
        }
    }

    #[test]
    fn names_are_those_of_json() {
        for (family, name) in FamilyName::ALL {
            assert_eq!(serde_json::to_string(&family).unwrap(), format!("\"{name}\""));
            assert_eq!(FamilyName::of_name(name), Some(family));
        }
    }

    #[test]
    fn parameters_go_into_a_family_and_back() {
        let text = "{\"format\":\"ALP\",\"family\":\"trig-bezier\",\"n1\":2,\"n2\":2,\"alpha\":3,\"beta\":2.5,\
            \"points\":[[0,0],[1,2],[3,0],[4,4],[5,0]]}";
        let Ok(Document::Shaped(shaped)) = Document::from_json(text) else { panic!("it is one") };
        let again = shaped.with_parameters(&shaped.parameters().unwrap());
        assert_eq!(ShapedPoints { phi: None, ..again }, *shaped);
    }
}
