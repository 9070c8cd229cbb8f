//! The curve that `sample` and `render` are asked for: a file with a method and its parameters.

use clap::Args;
use clap::builder::PossibleValuesParser;
use grafika::editor::fourier;
use grafika::file::{CurveSettings, Document, Method as MethodName};
use grafika::geometry::{Closure, Curve, Fourier, GeometryError, Method, Point};
use grafika::launch::{Failure, Opened, open};
use std::path::PathBuf;

/// A file with a method and its parameters.
#[derive(Args)]
pub(crate) struct CurveArgs {
    /// A data file or a built-in sample with control points
    file: PathBuf,
    /// Method; without it the one that a JSON file names
    #[arg(long, value_parser = method_names())]
    method: Option<String>,
    /// Join the last point to the first
    #[arg(long)]
    closed: bool,
    /// Coefficient of the tangents of coons and local [default: 0.5]
    #[arg(long, allow_negative_numbers = true)]
    k0: Option<f64>,
    /// Bias of a beta-spline [default: 1]
    #[arg(long, allow_negative_numbers = true)]
    bias: Option<f64>,
    /// Tension of a beta-spline, half of Barsky's [default: 0]
    #[arg(long, allow_negative_numbers = true)]
    tension: Option<f64>,
}

/// Control points in the plane or in space with their curve.
pub(crate) enum Curved {
    /// In the plane.
    Plane(Vec<Point<2>>, Curve<2>),
    /// In space.
    Space(Vec<Point<3>>, Curve<3>),
}

/// What points can be computed of.
pub(crate) enum Sampled {
    /// A curve by control points.
    Controlled(Curved),
    /// A curve by Fourier coefficients, in one span.
    Fourier(Fourier<2>),
}

impl CurveArgs {
    /// Opens the file and makes the curve that it describes, by control points or by coefficients.
    pub(crate) fn sampled(&self) -> Result<Sampled, Failure> {
        let opened = open(&self.file)?;
        let Document::Fourier(coefficients) = &opened.document else {
            return self.controlled(&opened).map(Sampled::Controlled);
        };
        let named = self.method.as_deref().and_then(MethodName::from_name);
        if named.is_some_and(|method| method != MethodName::Fourier) {
            return Err(Failure::usage(format!(
                "{}: coefficients of a Fourier curve have no other method than fourier",
                opened.name
            )));
        }
        let curve = fourier::curve(coefficients);
        curve.map(Sampled::Fourier).map_err(|error| Failure::work(format!("{}: {error}", opened.name)))
    }

    /// Opens the file and makes the curve by its control points.
    #[allow(dead_code, reason = "for commands that need control points")]
    pub(crate) fn curve(&self) -> Result<Curved, Failure> {
        self.controlled(&open(&self.file)?)
    }

    /// The curve by the control points of a file.
    fn controlled(&self, opened: &Opened) -> Result<Curved, Failure> {
        let failure = |error: GeometryError| Failure::work(format!("{}: {error}", opened.name));
        match opened.document {
            Document::PlanePoints(ref plane) => {
                let (method, closure) = self.choice(&plane.settings)?;
                let curve = Curve::through(method, closure, &plane.points).map_err(failure)?;
                Ok(Curved::Plane(plane.points.clone(), curve))
            }
            Document::SpacePoints(ref space) => {
                let (method, closure) = self.choice(&space.settings)?;
                let curve = Curve::through(method, closure, &space.points).map_err(failure)?;
                Ok(Curved::Space(space.points.clone(), curve))
            }
            _ => Err(Failure::work(format!(
                "{}: this file holds no control points of a curve; .IP2, .IC2 and .IP3 do",
                opened.name
            ))),
        }
    }

    /// The method and form, from the command line or else from the file.
    fn choice(&self, settings: &CurveSettings) -> Result<(Method, Closure), Failure> {
        let k0 = self.k0.or(settings.k0).unwrap_or(0.5);
        let bias = self.bias.or(settings.bias).unwrap_or(1.0);
        let tension = self.tension.or(settings.tension).unwrap_or(0.0);
        let named = self.method.as_deref().and_then(MethodName::from_name);
        let method = match named.or(settings.method) {
            Some(MethodName::Coons) => Method::Coons { k0 },
            Some(MethodName::Bezier) => Method::Bezier,
            Some(MethodName::Spline) => Method::Spline,
            Some(MethodName::BSpline2) => Method::BSpline2,
            Some(MethodName::BSpline3) => Method::BSpline3,
            Some(MethodName::Beta) => Method::Beta { bias, tension },
            Some(MethodName::Local) => Method::Local { k0 },
            Some(MethodName::Hermite | MethodName::Fourier) => {
                return Err(Failure::usage(
                    "this method needs more than control points; give another --method",
                ));
            }
            None => return Err(Failure::usage("which method? Give --method, as in --method spline")),
        };
        let closed = self.closed || settings.closed.unwrap_or(false);
        Ok((method, if closed { Closure::Closed } else { Closure::Open }))
    }
}

/// The names of the methods.
fn method_names() -> PossibleValuesParser {
    PossibleValuesParser::new(MethodName::ALL.map(|(name, _)| name))
}
