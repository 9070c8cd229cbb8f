//! The curve that `sample` and `render` are asked for: a file with a method and its parameters. A file with a
//! net gives a [`Surfaced`].

use crate::source::Source;
use crate::surface::{Common, SurfaceArgs, Surfaced};
use clap::Args;
use clap::builder::PossibleValuesParser;
use grafika::editor::fourier;
use grafika::file::{CurveSettings, Document, Method as MethodName, PlanePoints};
use grafika::geometry::{Closure, Curve, Fourier, GeometryError, Method, Point, VaryingBeta, hermite_arcs};
use grafika::launch::{Failure, Opened};

/// A file with a method and its parameters.
#[derive(Args)]
pub(crate) struct CurveArgs {
    #[command(flatten)]
    source: Source,
    /// Method; without it the one that the file implies or, in JSON, names
    #[arg(long, value_parser = method_names())]
    method: Option<String>,
    /// Join the last point to the first
    #[arg(long)]
    closed: bool,
    /// Coefficient of the tangents of coons and local, of surfaces along u and v [default: 0.5]
    #[arg(long, allow_negative_numbers = true)]
    k0: Option<f64>,
    /// Bias of a beta-spline [default: 1]
    #[arg(long, allow_negative_numbers = true)]
    bias: Option<f64>,
    /// Tension of a beta-spline, half of Barsky's [default: 0]
    #[arg(long, allow_negative_numbers = true)]
    tension: Option<f64>,
    #[command(flatten)]
    surface: SurfaceArgs,
}

/// A curve or a surface with what it is made of.
pub(crate) enum Curved {
    /// By control points of the plane.
    Plane(Vec<Point<2>>, Curve<2>),
    /// By control points of the plane, a beta-spline whose joints differ in shape.
    Varying(Vec<Point<2>>, VaryingBeta<2>),
    /// By control points in space.
    Space(Vec<Point<3>>, Curve<3>),
    /// By Fourier coefficients, in one span.
    Fourier(Fourier<2>),
    /// By a control net: a surface.
    Surface(Box<Surfaced>),
}

impl CurveArgs {
    /// Opens the file and makes the curve or surface that it describes.
    pub(crate) fn curve(&self) -> Result<Curved, Failure> {
        let opened = self.source.open()?;
        let failure = |error: GeometryError| Failure::work(format!("{}: {error}", opened.name));
        let is_net = matches!(opened.document, Document::Net(_));
        if let Some(option) = self.surface.given().filter(|_| !is_net) {
            return Err(Failure::usage(format!("{option} is for surfaces; {} holds none", opened.name)));
        }
        match &opened.document {
            Document::Net(net) if self.closed => Err(Failure::usage(format!(
                "--closed is for curves; what a surface is joined by, its extension says, here .{}",
                net.kind.format().extension()
            ))),
            Document::Net(net) => {
                let (k0, bias, tension) = (self.k0, self.bias, self.tension);
                let common = Common { method: self.named(), k0, bias, tension };
                let surface = self.surface.surface(&opened.name, net, common)?;
                Ok(Curved::Surface(Box::new(surface)))
            }
            Document::Fourier(coefficients) => {
                self.refuse_other_than(MethodName::Fourier, &opened)?;
                fourier::curve(coefficients).map(Curved::Fourier).map_err(failure)
            }
            Document::PlanePoints(plane) => {
                let curve = self.plane(plane)?;
                curve.map_err(failure)
            }
            Document::SpacePoints(space) => {
                let (method, closure) = self.choice(&space.settings)?;
                let curve = Curve::through(method, closure, &space.points).map_err(failure)?;
                Ok(Curved::Space(space.points.clone(), curve))
            }
            _ => Err(Failure::work(format!(
                "{}: this file holds no curve and no surface; .IP2, .IC2, .IP3, .GBP and the nets .FHC to .ZYP do",
                opened.name
            ))),
        }
    }

    fn named(&self) -> Option<MethodName> {
        self.method.as_deref().and_then(MethodName::from_name)
    }

    fn refuse_other_than(&self, only: MethodName, opened: &Opened) -> Result<(), Failure> {
        match self.named() {
            Some(other) if other != only => Err(Failure::usage(format!(
                "{}: coefficients of a Fourier curve have no other method than fourier",
                opened.name
            ))),
            _ => Ok(()),
        }
    }

    /// The curve by points of the plane; where the file has tangents or shapes of joints, by these.
    fn plane(&self, plane: &PlanePoints) -> Result<Result<Curved, GeometryError>, Failure> {
        let points = plane.points.clone();
        let named = self.named().or(plane.settings.method);
        match (&plane.tangents, &plane.joints) {
            (Some(tangents), _) if named.is_none_or(|name| name == MethodName::Hermite) => {
                let arcs = hermite_arcs(self.closure(&plane.settings), &points, tangents);
                Ok(arcs.map(|arcs| Curved::Plane(points, Curve::Piecewise(arcs))))
            }
            (_, Some(joints)) if named.is_none_or(|name| name == MethodName::Beta) => {
                let curve = VaryingBeta::new(self.closure(&plane.settings), &points, joints);
                Ok(curve.map(|curve| Curved::Varying(points, curve)))
            }
            _ => {
                let (method, closure) = self.choice(&plane.settings)?;
                Ok(Curve::through(method, closure, &points).map(|curve| Curved::Plane(points, curve)))
            }
        }
    }

    fn closure(&self, settings: &CurveSettings) -> Closure {
        let closed = self.closed || settings.closed.unwrap_or(false);
        if closed { Closure::Closed } else { Closure::Open }
    }

    /// The method and form, from the command line or else from the file.
    fn choice(&self, settings: &CurveSettings) -> Result<(Method, Closure), Failure> {
        let k0 = self.k0.or(settings.k0).unwrap_or(0.5);
        let bias = self.bias.or(settings.bias).unwrap_or(1.0);
        let tension = self.tension.or(settings.tension).unwrap_or(0.0);
        let Some(name) = self.named().or(settings.method) else {
            return Err(Failure::usage("which method? Give --method, as in --method spline"));
        };
        let method = name.with(k0, bias, tension).ok_or_else(|| {
            Failure::usage(match name {
                MethodName::Fourier => "fourier needs coefficients, as a .GBP file has them",
                _ => "hermite needs tangents, as an .IC2 file with its .EC2 has them",
            })
        })?;
        Ok((method, self.closure(settings)))
    }
}

/// The names of the methods.
fn method_names() -> PossibleValuesParser {
    PossibleValuesParser::new(MethodName::ALL.map(|(name, _)| name))
}
