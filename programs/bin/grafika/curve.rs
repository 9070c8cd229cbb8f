//! The curve or surface that `sample` and `render` are asked for: a file with a method and its parameters.

use crate::numbers::Numbers;
use crate::series::value;
use crate::source::Source;
use crate::surface::{Common, SurfaceArgs};
use clap::Args;
use clap::builder::PossibleValuesParser;
use grafika::design::{Design, DesignError, Shape, Sketch};
use grafika::file::{CurveSettings, Document, KnotRule, Method};
use grafika::geometry::Closure;
use grafika::geometry::ph::Knots;
use grafika::launch::{Failure, Opened};

/// A file with a method and its parameters.
#[derive(Args)]
pub(crate) struct CurveArgs {
    #[command(flatten)]
    pub(crate) source: Source,
    /// Method; without it the one that the file implies or, in JSON, names. render draws several together, as in
    /// spline,coons, and so several values of --k0, --bias and --tension
    #[arg(long, value_delimiter = ',', value_parser = method_names())]
    pub(crate) method: Vec<String>,
    /// Join the last point to the first
    #[arg(long)]
    closed: bool,
    /// Coefficient of the tangents of coons and local, of surfaces along u and v [default: 0.5]
    #[arg(long, value_delimiter = ',', value_parser = value, allow_hyphen_values = true)]
    pub(crate) k0: Vec<f64>,
    /// Bias of a beta-spline [default: 1]
    #[arg(long, value_delimiter = ',', value_parser = value, allow_hyphen_values = true)]
    pub(crate) bias: Vec<f64>,
    /// Tension of a beta-spline, half of Barsky's [default: 0]
    #[arg(long, value_delimiter = ',', value_parser = value, allow_hyphen_values = true)]
    pub(crate) tension: Vec<f64>,
    /// Degree of bspline, 1 to 5 [default: 3]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=5))]
    degree: Option<u8>,
    /// Knots of phspline (else by chord), spline and bspline (else uniform): chord, uniform or centripetal; of bspline also
    /// the knots themselves, joined by commas: points + degree + 1 of them, of a closed one points + 1
    #[arg(long, value_name = "RULE", value_parser = knots, allow_hyphen_values = true)]
    knots: Option<KnotRule>,
    /// Derivative at the start of an open phspline or spline, by knots of mean step 1; without it a spline has no curvature
    /// there
    #[arg(long, value_name = "DX,DY", value_parser = vector, allow_hyphen_values = true)]
    start: Option<Derivative>,
    /// Derivative at the end of an open phspline or spline
    #[arg(long, value_name = "DX,DY", value_parser = vector, allow_hyphen_values = true)]
    end: Option<Derivative>,
    #[command(flatten)]
    surface: SurfaceArgs,
}

impl CurveArgs {
    /// Opens the file; its design, with what the command line says about it, and its name.
    pub(crate) fn design(&self) -> Result<(Design, String), Failure> {
        let common = self.common()?;
        let Opened { name, document, .. } = self.source.open()?;
        Ok((self.design_of(document, &name, common)?, name))
    }

    /// The design of a document, with what the command line says about it.
    pub(crate) fn design_of(
        &self,
        document: Document,
        name: &str,
        common: Common,
    ) -> Result<Design, Failure> {
        let is_net = matches!(document, Document::Net(_));
        if let Some(option) = self.surface.given().filter(|_| !is_net) {
            return Err(Failure::usage(format!("{option} is for surfaces; {name} holds none")));
        }
        let design = Design::of_document(document).map_err(|error| failure(name, &error))?;
        let points = matches!(design, Design::Plane(_) | Design::Space(_));
        if let Some(option) = self.spline_option().filter(|_| !points) {
            return Err(Failure::usage(format!(
                "{option} is for phspline, spline and bspline; {name} holds no control points of one"
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
                let net = self.surface.net(net, common)?;
                let by = self.surface.by_direction();
                self.check_parameters(common, Some(net.method()), by, false)?;
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
                if common.method.is_some_and(|other| other != Method::Fourier) {
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
                self.apply(common, &mut sketch.settings);
                self.check_spline(&sketch)?;
                self.check_sketch(common, &sketch)?;
                Design::Plane(sketch)
            }
            Design::Space(mut sketch) => {
                self.apply(common, &mut sketch.settings);
                self.check_spline(&sketch)?;
                self.check_sketch(common, &sketch)?;
                Design::Space(sketch)
            }
        };
        Ok(design)
    }

    /// Opens the file and makes the curve or surface that it describes.
    pub(crate) fn shape(&self) -> Result<(Design, Shape), Failure> {
        let (design, name) = self.design()?;
        let shape = design.shape().map_err(|error| failure(&name, &error))?;
        Ok((design, shape))
    }

    /// Puts what the command line says over what the file says.
    fn apply(&self, common: Common, settings: &mut CurveSettings) {
        settings.method = common.method.or(settings.method);
        settings.closed = if self.closed { Some(true) } else { settings.closed };
        settings.k0 = common.k0.or(settings.k0);
        settings.bias = common.bias.or(settings.bias);
        settings.tension = common.tension.or(settings.tension);
        settings.degree = self.degree.map(usize::from).or(settings.degree);
        settings.knots = self.knots.clone().or(settings.knots.take());
        settings.start = self.start.as_ref().map(|end| end.0.clone()).or(settings.start.take());
        settings.end = self.end.as_ref().map(|end| end.0.clone()).or(settings.end.take());
    }

    /// An option that says how control points become a curve, if one is given.
    fn of_points(&self) -> Option<&'static str> {
        let given = [
            ("--method", !self.method.is_empty()),
            ("--closed", self.closed),
            ("--k0", !self.k0.is_empty()),
            ("--bias", !self.bias.is_empty()),
            ("--tension", !self.tension.is_empty()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }

    fn check_sketch<const D: usize>(&self, common: Common, sketch: &Sketch<D>) -> Result<(), Failure> {
        if let (Some(option), Some(_)) = (of_beta(common), &sketch.joints) {
            return Err(Failure::usage(format!(
                "{option} is for all joints at once; this file says the shape of each"
            )));
        }
        self.check_parameters(common, sketch.method(), [None; 2], sketch.tangents.is_some())
    }

    /// Refuses parameters that the method does not have; `by` are those of surfaces by direction, of beta-splines and of
    /// tangents.
    fn check_parameters(
        &self,
        common: Common,
        method: Option<Method>,
        by: [Option<&'static str>; 2],
        has_tangents: bool,
    ) -> Result<(), Failure> {
        // Without a method something else is told.
        let Some(method) = method else { return Ok(()) };
        let [beta, tangents] = by;
        let beta = beta.or(of_beta(common)).filter(|_| method != Method::Beta);
        if let Some(option) = beta {
            let method = method.name();
            return Err(Failure::usage(format!("{option} is for beta; {method} has no such thing")));
        }
        let automatic = match method {
            Method::Coons | Method::Local => true,
            Method::PhHermite => !has_tangents,
            _ => false,
        };
        match tangents.or(common.k0.map(|_| "--k0")).filter(|_| !automatic) {
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

    /// Refuses what the splines have that the method of a sketch has not.
    fn check_spline<const D: usize>(&self, sketch: &Sketch<D>) -> Result<(), Failure> {
        // Without a method something else is told.
        let Some(method) = sketch.method() else { return Ok(()) };
        let ends = self.start.as_ref().map(|_| "--start").or(self.end.as_ref().map(|_| "--end"));
        let known = [
            (self.degree.map(|_| "--degree"), &[Method::BSpline][..]),
            (self.knots.as_ref().map(|_| "--knots"), &[Method::PhSpline, Method::Spline, Method::BSpline]),
            (ends, &[Method::PhSpline, Method::Spline]),
        ];
        for (option, methods) in known {
            let Some(option) = option.filter(|_| !methods.contains(&method)) else { continue };
            let names: Vec<&str> = methods.iter().map(|method| method.name()).collect();
            let (names, method) = (names.join(", "), method.name());
            return Err(Failure::usage(format!("{option} is for {names}; {method} has no such thing")));
        }
        if sketch.closure() == Closure::Closed
            && let Some(option) = ends
        {
            return Err(Failure::usage(format!("{option} is for open curves; a closed one has no ends")));
        }
        Ok(())
    }

    /// An option that only splines have, if one is given.
    fn spline_option(&self) -> Option<&'static str> {
        let given = [
            ("--degree", self.degree.is_some()),
            ("--knots", self.knots.is_some()),
            ("--start", self.start.is_some()),
            ("--end", self.end.is_some()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }
}

fn of_beta(common: Common) -> Option<&'static str> {
    let given = [("--bias", common.bias), ("--tension", common.tension)];
    given.into_iter().find(|(_, value)| value.is_some()).map(|(option, _)| option)
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

/// A derivative at an end, with as many coordinates as the points have.
#[derive(Clone, Debug)]
struct Derivative(Vec<f64>);

/// Reads a vector of the plane or of space.
fn vector(text: &str) -> Result<Derivative, String> {
    let numbers = text.parse::<Numbers>().ok().filter(|numbers| (2..=3).contains(&numbers.0.len()));
    let wanted = "give two numbers DX,DY, as in 150,-20, or in space three";
    numbers.map(|numbers| Derivative(numbers.0)).ok_or_else(|| wanted.to_owned())
}

/// Reads a rule for knots, or the knots.
fn knots(text: &str) -> Result<KnotRule, String> {
    let given = || text.parse::<Numbers>().ok().map(|numbers| KnotRule::Given(numbers.0));
    let rule = Knots::from_name(text).map(KnotRule::By).or_else(given);
    rule.ok_or_else(|| {
        "give chord, uniform or centripetal, or knots joined by commas, as in 0,0,0,1,2,2,2".to_owned()
    })
}

/// The names of the methods.
fn method_names() -> PossibleValuesParser {
    PossibleValuesParser::new(Method::ALL.map(|(name, _)| name))
}
