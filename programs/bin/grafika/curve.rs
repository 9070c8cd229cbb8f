//! The curve or surface that `sample` and `render` are asked for: a file with a method and its parameters.

use crate::source::Source;
use crate::surface::{Common, SurfaceArgs};
use clap::Args;
use clap::builder::PossibleValuesParser;
use grafika::design::{Design, DesignError, Shape, Sketch};
use grafika::file::{CurveSettings, Document, Method};
use grafika::geometry::Point;
use grafika::geometry::ph::Knots;
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
    /// Knots of phspline: chord, uniform or centripetal [default: chord]
    #[arg(long, value_parser = PossibleValuesParser::new(Knots::ALL.map(|(name, _)| name)))]
    knots: Option<String>,
    /// Derivative at the start of an open phspline, by knots of mean step 1
    #[arg(long, value_name = "DX,DY", value_parser = vector, allow_hyphen_values = true)]
    start: Option<Point<2>>,
    /// Derivative at the end of an open phspline
    #[arg(long, value_name = "DX,DY", value_parser = vector, allow_hyphen_values = true)]
    end: Option<Point<2>>,
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
        let points = matches!(design, Design::Plane(_) | Design::Space(_));
        if let Some(option) = self.spline_option().filter(|_| !points) {
            return Err(Failure::usage(format!(
                "{option} is for phspline; {name} holds no control points of one"
            )));
        }
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
                let net = self.surface.net(net, common)?;
                let by = self.surface.by_direction();
                self.check_parameters(Some(net.method()), by, false)?;
                Design::Net(net)
            }
            design @ (Design::Ec(_)
            | Design::Patches(_)
            | Design::Knots(_)
            | Design::KnotNet(_)
            | Design::Shaped(_)
            | Design::Skin(_)) => {
                if let Some(option) = self.of_points() {
                    return Err(Failure::usage(format!(
                        "{option} is for other curves and surfaces; {name} says itself what it describes"
                    )));
                }
                design
            }
            Design::Rational(spans) => {
                if let Some(option) = self.of_points() {
                    return Err(Failure::usage(format!(
                        "{option} is for control points; {name} holds a rational curve as it is"
                    )));
                }
                Design::Rational(spans)
            }
            Design::Fourier(coefficients) => {
                if self.named().is_some_and(|other| other != Method::Fourier) {
                    return Err(Failure::usage(format!(
                        "{name}: coefficients of a Fourier curve have no other method than fourier"
                    )));
                }
                if let Some(option) = self.of_points().filter(|option| *option != "--method") {
                    return Err(Failure::usage(format!(
                        "{option} is for control points; {name} holds coefficients of a Fourier curve, which is closed"
                    )));
                }
                Design::Fourier(coefficients)
            }
            Design::Plane(mut sketch) => {
                self.apply(&mut sketch.settings);
                let method = sketch.method().filter(|method| *method != Method::PhSpline);
                if let Some((option, method)) = self.spline_option().zip(method) {
                    let method = method.name();
                    return Err(Failure::usage(format!(
                        "{option} is for phspline; {method} has no such thing"
                    )));
                }
                self.check_sketch(&sketch)?;
                Design::Plane(sketch)
            }
            Design::Space(mut sketch) => {
                self.apply(&mut sketch.settings);
                self.check_sketch(&sketch)?;
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
        settings.knots = self.knots.as_deref().and_then(Knots::from_name).or(settings.knots);
        settings.start = self.start.or(settings.start);
        settings.end = self.end.or(settings.end);
    }

    /// An option that says how control points become a curve, if one is given.
    fn of_points(&self) -> Option<&'static str> {
        let given = [
            ("--method", self.method.is_some()),
            ("--closed", self.closed),
            ("--k0", self.k0.is_some()),
            ("--bias", self.bias.is_some()),
            ("--tension", self.tension.is_some()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }

    fn check_sketch<const D: usize>(&self, sketch: &Sketch<D>) -> Result<(), Failure> {
        if let (Some(option), Some(_)) = (self.of_beta(), &sketch.joints) {
            return Err(Failure::usage(format!(
                "{option} is for all joints at once; this file says the shape of each"
            )));
        }
        self.check_parameters(sketch.method(), [None; 2], sketch.tangents.is_some())
    }

    fn of_beta(&self) -> Option<&'static str> {
        let given = [("--bias", self.bias), ("--tension", self.tension)];
        given.into_iter().find(|(_, value)| value.is_some()).map(|(option, _)| option)
    }

    /// Refuses parameters that the method does not have; `by` are those of surfaces by direction, of beta-splines and of
    /// tangents.
    fn check_parameters(
        &self,
        method: Option<Method>,
        by: [Option<&'static str>; 2],
        has_tangents: bool,
    ) -> Result<(), Failure> {
        // Without a method something else is told.
        let Some(method) = method else { return Ok(()) };
        let [beta, tangents] = by;
        let beta = beta.or(self.of_beta()).filter(|_| method != Method::Beta);
        if let Some(option) = beta {
            let method = method.name();
            return Err(Failure::usage(format!("{option} is for beta; {method} has no such thing")));
        }
        let automatic = match method {
            Method::Coons | Method::Local => true,
            Method::PhHermite => !has_tangents,
            _ => false,
        };
        match tangents.or(self.k0.map(|_| "--k0")).filter(|_| !automatic) {
            Some(option) => {
                let method = method.name();
                Err(Failure::usage(match has_tangents {
                    true => format!("{option} is for automatic tangents; this file has its own"),
                    false => format!("{option} is for coons and local; {method} has no such thing"),
                }))
            }
            None => Ok(()),
        }
    }

    /// An option that only phspline has, if one is given.
    fn spline_option(&self) -> Option<&'static str> {
        let given = [
            ("--knots", self.knots.is_some()),
            ("--start", self.start.is_some()),
            ("--end", self.end.is_some()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }
}

/// Why a file describes no curve or surface: what the command line can mend is a matter of usage.
pub(crate) fn failure(name: &str, error: &DesignError) -> Failure {
    match error {
        DesignError::Geometry(_)
        | DesignError::Knots(_)
        | DesignError::Skin(_)
        | DesignError::Unfinished { .. }
        | DesignError::Ec { .. }
        | DesignError::NoMatrix
        | DesignError::NoShape => Failure::work(format!("{name}: {error}")),
        _ => Failure::usage(error),
    }
}

/// Reads a vector of the plane.
fn vector(text: &str) -> Result<Point<2>, String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let vector = numbers.ok().and_then(|numbers| <Point<2>>::try_from(numbers).ok());
    let vector = vector.filter(|vector| vector.iter().all(|x| x.is_finite()));
    vector.ok_or_else(|| "give two numbers DX,DY, as in 150,-20".to_owned())
}

/// The names of the methods.
fn method_names() -> PossibleValuesParser {
    PossibleValuesParser::new(Method::ALL.map(|(name, _)| name))
}
