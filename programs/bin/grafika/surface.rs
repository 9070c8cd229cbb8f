//! The surface that `sample` and `render` are asked for: a control net with a method and its parameters.

use clap::Args;
use grafika::design::NetDesign;
use grafika::file::Method;
use grafika::geometry::{Border, Topology};
use grafika::launch::Failure;

/// What only surfaces have: parameters by direction.
#[derive(Args)]
pub(crate) struct SurfaceArgs {
    /// Bias of a beta-spline surface along u [default: --bias]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    bias_u: Option<f64>,
    /// Bias of a beta-spline surface along v [default: --bias]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    bias_v: Option<f64>,
    /// Tension of a beta-spline surface along u [default: --tension]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    tension_u: Option<f64>,
    /// Tension of a beta-spline surface along v [default: --tension]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    tension_v: Option<f64>,
    /// Coefficient of the tangents of a local surface along u [default: --k0]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    k0_u: Option<f64>,
    /// Coefficient of the tangents of a local surface along v [default: --k0]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    k0_v: Option<f64>,
    /// Lead a cubic B-spline surface up to its borders and poles
    #[arg(long)]
    extended: bool,
    /// End the meridians of a surface like a sphere at its poles, each for itself: the poles become singular
    #[arg(long, conflicts_with = "extended")]
    free_poles: bool,
    /// Take the border points of an open B-spline net as auxiliary points: the inner patches alone
    #[arg(long, conflicts_with_all = ["extended", "free_poles"])]
    inner: bool,
}

/// Parameters for both directions at once, as curves have them.
#[derive(Clone, Copy)]
pub(crate) struct Common {
    /// The method that the command line names.
    pub(crate) method: Option<Method>,
    pub(crate) k0: Option<f64>,
    pub(crate) bias: Option<f64>,
    pub(crate) tension: Option<f64>,
}

impl SurfaceArgs {
    /// An option that only surfaces have, if one is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let numbers = [
            ("--bias-u", self.bias_u),
            ("--bias-v", self.bias_v),
            ("--tension-u", self.tension_u),
            ("--tension-v", self.tension_v),
            ("--k0-u", self.k0_u),
            ("--k0-v", self.k0_v),
        ];
        let number = numbers.into_iter().find(|(_, value)| value.is_some()).map(|(name, _)| name);
        let switches =
            [("--extended", self.extended), ("--free-poles", self.free_poles), ("--inner", self.inner)];
        let switch = switches.into_iter().find(|(_, given)| *given).map(|(name, _)| name);
        number.or(switch)
    }

    /// An option of beta-splines by direction, and one of tangents, if they are given.
    pub(crate) fn by_direction(&self) -> [Option<&'static str>; 2] {
        let given = |options: &[(&'static str, Option<f64>)]| {
            options.iter().find(|(_, value)| value.is_some()).map(|(option, _)| *option)
        };
        let beta = [
            ("--bias-u", self.bias_u),
            ("--bias-v", self.bias_v),
            ("--tension-u", self.tension_u),
            ("--tension-v", self.tension_v),
        ];
        [given(&beta), given(&[("--k0-u", self.k0_u), ("--k0-v", self.k0_v)])]
    }

    /// The net with what the command line says put over what the file says.
    pub(crate) fn net(&self, design: NetDesign, common: Common) -> Result<NetDesign, Failure> {
        let pair = |own: [Option<f64>; 2], both: Option<f64>, stored: [f64; 2]| -> Option<[f64; 2]> {
            let said = own.iter().chain([&both]).any(Option::is_some);
            said.then(|| [0, 1].map(|d| own[d].or(both).unwrap_or(stored[d])))
        };
        let k0 = pair([self.k0_u, self.k0_v], common.k0, design.k0());
        let bias = pair([self.bias_u, self.bias_v], common.bias, design.bias());
        let tension = pair([self.tension_u, self.tension_v], common.tension, design.tension());
        let design = design.with_settings(|settings| {
            settings.method = common.method.or(settings.method);
            settings.k0 = k0.or(settings.k0);
            settings.bias = bias.or(settings.bias);
            settings.tension = tension.or(settings.tension);
        });
        let border =
            [(self.extended, Border::Reached), (self.free_poles, Border::Free), (self.inner, Border::Inner)];
        let said = border.into_iter().find(|(given, _)| *given).map(|(_, border)| border);
        let design = said.map_or(design.clone(), |border| design.with_border(border));
        let topology = design.net.kind.topology();
        let torus = topology == Topology::Torus;
        if self.extended && (design.method() != Method::BSpline3 || torus) {
            return Err(Failure::usage(
                "--extended leads a cubic B-spline (--method bspline3) to its borders; this surface has none that it misses",
            ));
        }
        if self.free_poles && topology != Topology::Sphere {
            return Err(Failure::usage(
                "--free-poles is for surfaces like a sphere, as .ZMS and .ZMB files hold them; this one has no poles",
            ));
        }
        let blended = matches!(design.method(), Method::BSpline2 | Method::BSpline3 | Method::Beta);
        if self.inner && !(topology == Topology::Open && blended) {
            return Err(Failure::usage(
                "--inner is for open nets of B-splines and beta-splines (--method bspline3), whose border points can be auxiliary",
            ));
        }
        Ok(design)
    }
}
