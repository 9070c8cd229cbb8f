//! The surface that `sample` and `render` are asked for: a control net with a method and its parameters.

use clap::Args;
use grafika::file::{Method as MethodName, Net, NetKind};
use grafika::geometry::{Border, GeometryError, Method, Point, Scheme, Surface, Topology};
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
}

/// Parameters for both directions at once, as curves have them.
#[derive(Clone, Copy)]
pub(crate) struct Common {
    /// The method that the command line names.
    pub(crate) method: Option<MethodName>,
    pub(crate) k0: Option<f64>,
    pub(crate) bias: Option<f64>,
    pub(crate) tension: Option<f64>,
}

/// A surface with what it is made of.
pub(crate) struct Surfaced {
    /// The control net.
    pub(crate) net: Net,
    /// The surface as the book draws it, or extended to its borders.
    pub(crate) surface: Surface,
    /// How it is woven; a Hermite matrix is not.
    scheme: Option<Scheme>,
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
        number.or(self.extended.then_some("--extended"))
    }

    /// The surface of a net; `name` is that of its file.
    pub(crate) fn surface(&self, name: &str, net: &Net, common: Common) -> Result<Surfaced, Failure> {
        let failure = |error: GeometryError| Failure::work(format!("{name}: {error}"));
        let topology = net.kind.topology();
        let method = method_of(net, common.method)?;
        let extended = self.extended || net.settings.extended == Some(true);
        let border = if extended { Border::Reached } else { Border::Doubled };
        if self.extended && (method != MethodName::BSpline3 || topology == Topology::Torus) {
            return Err(Failure::usage(
                "--extended leads a cubic B-spline (--method bspline3) to its borders; this surface has none that it misses",
            ));
        }
        let (surface, scheme) = match self.methods(method, net, common) {
            None => (Surface::hermite(&matrix(name, net)?).map_err(failure)?, None),
            Some([u, v]) => {
                let scheme = Scheme { u, v, topology, border };
                (Surface::new(scheme, &net.points).map_err(failure)?, Some(scheme))
            }
        };
        Ok(Surfaced { net: net.clone(), surface, scheme })
    }

    /// The method along u and v with its parameters; `None` for the Hermite patch.
    fn methods(&self, method: MethodName, net: &Net, common: Common) -> Option<[Method; 2]> {
        let pair = |own: [Option<f64>; 2], both: Option<f64>, stored: Option<[f64; 2]>, default: f64| {
            [0, 1].map(|d| own[d].or(both).or(stored.map(|stored| stored[d])).unwrap_or(default))
        };
        let k0 = pair([self.k0_u, self.k0_v], common.k0, net.settings.k0, 0.5);
        let bias = pair([self.bias_u, self.bias_v], common.bias, net.settings.bias, 1.0);
        let tension = pair([self.tension_u, self.tension_v], common.tension, net.settings.tension, 0.0);
        let along = |d: usize| method.with(k0[d], bias[d], tension[d]);
        Some([along(0)?, along(1)?])
    }
}

impl Surfaced {
    /// The surface as a model: that of a sphere is led to its poles, where the book's cubic B-spline leaves
    /// holes.
    pub(crate) fn solid(&self) -> Result<Surface, GeometryError> {
        match self.scheme {
            Some(scheme) if scheme.topology == Topology::Sphere => {
                Surface::new(Scheme { border: Border::Reached, ..scheme }, &self.net.points)
            }
            _ => Ok(self.surface.clone()),
        }
    }

    /// The lines of the control net, and whether they are closed: along u, then along v.
    pub(crate) fn polygons(&self) -> Vec<(Vec<Point<3>>, bool)> {
        let points = self.points();
        let columns = points.first().map_or(0, Vec::len);
        let [closed_u, closed_v] = self.net.kind.topology().closed();
        let along_u = (0..columns).map(|l| points.iter().filter_map(|row| row.get(l).copied()).collect());
        let along_u = along_u.map(|line| (line, closed_u));
        along_u.chain(points.iter().map(|row| (row.clone(), closed_v))).collect()
    }

    /// The control points with their numbers, a pole only once.
    pub(crate) fn discs(&self) -> Vec<([usize; 2], Point<3>)> {
        let points = self.points();
        let sphere = self.net.kind.topology() == Topology::Sphere;
        let last = points.first().map_or(0, |row| row.len().saturating_sub(1));
        let numbered = points
            .iter()
            .enumerate()
            .flat_map(|(k, row)| row.iter().enumerate().map(move |(l, &point)| ([k, l], point)));
        numbered.filter(|&([k, l], _)| !(sphere && k > 0 && (l == 0 || l == last))).collect()
    }

    /// The control points; of a Hermite matrix the corners, the rest being vectors.
    fn points(&self) -> Vec<Vec<Point<3>>> {
        let shown = if self.scheme.is_some() { usize::MAX } else { 2 };
        self.net.points.iter().take(shown).map(|row| row.iter().take(shown).copied().collect()).collect()
    }
}

/// The method from the command line, else from the file, else the one that the kind of net implies.
fn method_of(net: &Net, named: Option<MethodName>) -> Result<MethodName, Failure> {
    let method = named.or(net.settings.method).unwrap_or(match net.kind {
        NetKind::Fhc => MethodName::Hermite,
        NetKind::Fps | NetKind::Fem | NetKind::Zms | NetKind::Zys => MethodName::Spline,
        NetKind::Fpb => MethodName::Bezier,
        NetKind::Fbs | NetKind::Zmb | NetKind::Zyb => MethodName::BSpline3,
        NetKind::Zyp => MethodName::Beta,
    });
    match (method, net.kind) {
        (MethodName::Hermite, NetKind::Fhc) => Ok(method),
        (_, NetKind::Fhc) => Err(Failure::usage(
            "an .FHC file holds points, tangents and twists; it has no other method than hermite",
        )),
        (MethodName::Hermite, _) => {
            Err(Failure::usage("hermite needs tangents and twists, as an .FHC file has them"))
        }
        (MethodName::Coons, _) => Err(Failure::usage("coons is for curves; of surfaces it is called local")),
        (MethodName::Fourier, _) => Err(Failure::usage(
            "fourier is for curves; surfaces have spline, local, bezier, bspline2, bspline3 and beta",
        )),
        _ => Ok(method),
    }
}

/// The matrix of a Hermite net, which JSON may hold in another size.
fn matrix(name: &str, net: &Net) -> Result<[[Point<3>; 4]; 4], Failure> {
    let rows: Option<Vec<[Point<3>; 4]>> =
        net.points.iter().map(|row| row.as_slice().try_into().ok()).collect();
    rows.and_then(|rows| rows.try_into().ok())
        .ok_or_else(|| Failure::work(format!("{name}: a Hermite matrix has 4 rows of 4")))
}
