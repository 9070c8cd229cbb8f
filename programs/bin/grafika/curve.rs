//! The curve or surface that `sample` and `render` are asked for: a file with a method and its parameters.

use crate::source::Source;
use crate::surface::{Common, SurfaceArgs};
use clap::Args;
use clap::builder::PossibleValuesParser;
use grafika::design::{Design, DesignError, Shape};
use grafika::file::{CurveSettings, Document, Method};
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

impl CurveArgs {
    /// Opens the file; its design, with what the command line says about it, and its name.
    pub(crate) fn design(&self) -> Result<(Design, String), Failure> {
        let Opened { name, document, .. } = self.source.open()?;
        let is_net = matches!(document, Document::Net(_));
        if let Some(option) = self.surface.given().filter(|_| !is_net) {
            return Err(Failure::usage(format!("{option} is for surfaces; {name} holds none")));
        }
        let design = Design::of_document(document).map_err(|error| failure(&name, &error))?;
        let design = match design {
            Design::Net(net) if self.closed => {
                return Err(Failure::usage(format!(
                    "--closed is for curves; what a surface is joined by, its extension says, here .{}",
                    net.net.kind.format().extension()
                )));
            }
            Design::Net(net) => {
                let (k0, bias, tension) = (self.k0, self.bias, self.tension);
                let common = Common { method: self.named(), k0, bias, tension };
                Design::Net(self.surface.net(net, common)?)
            }
            design @ (Design::Ec(_) | Design::Patches(_)) => {
                let given = [
                    ("--method", self.method.is_some()),
                    ("--closed", self.closed),
                    ("--k0", self.k0.is_some()),
                    ("--bias", self.bias.is_some()),
                    ("--tension", self.tension.is_some()),
                ];
                if let Some((option, _)) = given.into_iter().find(|(_, given)| *given) {
                    return Err(Failure::usage(format!(
                        "{option} is for other curves and surfaces; {name} says itself what it describes"
                    )));
                }
                design
            }
            Design::Fourier(coefficients) => {
                if self.named().is_some_and(|other| other != Method::Fourier) {
                    return Err(Failure::usage(format!(
                        "{name}: coefficients of a Fourier curve have no other method than fourier"
                    )));
                }
                Design::Fourier(coefficients)
            }
            Design::Plane(mut sketch) => {
                self.apply(&mut sketch.settings);
                Design::Plane(sketch)
            }
            Design::Space(mut sketch) => {
                self.apply(&mut sketch.settings);
                Design::Space(sketch)
            }
        };
        Ok((design, name))
    }

    /// Opens the file and makes the curve or surface that it describes.
    pub(crate) fn shape(&self) -> Result<(Design, Shape), Failure> {
        let (design, name) = self.design()?;
        let shape = design.shape().map_err(|error| failure(&name, &error))?;
        Ok((design, shape))
    }

    fn named(&self) -> Option<Method> {
        self.method.as_deref().and_then(Method::from_name)
    }

    /// Puts what the command line says over what the file says.
    fn apply(&self, settings: &mut CurveSettings) {
        settings.method = self.named().or(settings.method);
        settings.closed = if self.closed { Some(true) } else { settings.closed };
        settings.k0 = self.k0.or(settings.k0);
        settings.bias = self.bias.or(settings.bias);
        settings.tension = self.tension.or(settings.tension);
    }
}

/// Why a file describes no curve or surface: what the command line can mend is a matter of usage.
pub(crate) fn failure(name: &str, error: &DesignError) -> Failure {
    match error {
        DesignError::Geometry(_) | DesignError::Ec { .. } | DesignError::NoMatrix | DesignError::NoShape => {
            Failure::work(format!("{name}: {error}"))
        }
        _ => Failure::usage(error),
    }
}

/// The names of the methods.
fn method_names() -> PossibleValuesParser {
    PossibleValuesParser::new(Method::ALL.map(|(name, _)| name))
}
