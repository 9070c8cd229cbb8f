//! Smooth curves by control points: interpolation, B-splines, beta-splines and Bézier curves as
//! rows of cubic Bézier arcs, with sampling, derivatives, lengths and boxes written once for arcs.
//!
//! The room holds mathematics only: no screen, no files, no state. Every piecewise method of the
//! book (chapters 2.3 and 3) is linear in the control points and cubic at most, so it is a set of
//! [`Weights`] fixed by the method, the ends and the number of points; weights times points are
//! arcs. The Bézier curve by all points is one arc of any degree. What all curves and surfaces can do,
//! also those that are not cubic, is [`ParamCurve`] and [`ParamSurface`]; functions that blend control
//! points are a [`Basis`]. Curves with exact lengths and offsets are in [`ph`], rational surfaces whose offsets
//! are rational too are [`PnSurface`], functions beyond polynomials in [`ec`], curves by
//! their knots in [`knots`], curves with shape parameters in [`shaped`], skins over
//! circles and spheres in [`skin`]. In which order faces hide each other is asked in [`painter`]. Points without order are a [`cloud`]; a
//! Kohonen net ([`kohonen`]) learns its shape, and [`fit`] makes a surface of the net. Nothing here panics or answers
//! with NaN: what cannot be computed is a [`GeometryError`] with a sentence.
//!
//! Accuracy: every method agrees with an independent computation to 3e-14 of the polygon's size
//! (`tests/geometry_methods.rs`, `tests/geometry_bezier.rs`), for 3 to 99 points and more.
//!
//! A closed spline through four points, and the middle of its first arc:
//!
//! ```
//! use grafika::geometry::{Closure, Curve, Method, ParamCurve};
//!
//! let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
//! let curve = Curve::through(Method::Spline, Closure::Closed, &square)?;
//! assert_eq!(curve.spans(), 4);
//! let [x, y] = curve.eval(0, 0.5).expect("span 0 exists");
//! assert!((x - 2.0).abs() < 1e-12 && (y + 0.75).abs() < 1e-12);
//! # Ok::<(), grafika::geometry::GeometryError>(())
//! ```
//!
//! Weights are computed once and serve every later set of as many points, in any dimension:
//!
//! ```
//! use grafika::geometry::{Closure, Method, Weights};
//!
//! let weights = Weights::new(Method::BSpline3, Closure::Open, 4)?;
//! assert_eq!((weights.points(), weights.spans()), (4, 5));
//! let arcs = weights.arcs(&[[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [6.0, 6.0, 0.0], [6.0, 6.0, 6.0]])?;
//! assert_eq!(arcs[0].p[0], [0.0, 0.0, 0.0]);
//! assert_eq!(arcs[4].eval(1.0), [6.0, 6.0, 6.0]);
//! # Ok::<(), grafika::geometry::GeometryError>(())
//! ```

mod arclen;
mod arcs;
mod basis;
mod beta;
mod bezier;
mod bezier_far;
mod binomial;
mod bounds;
mod chebyshev;
pub mod cloud;
mod contact;
mod cubic;
mod curve;
mod cyclic;
mod dice;
pub mod ec;
mod error;
pub mod fit;
mod fourier;
mod hermite;
mod hidden;
mod hull3;
mod jet;
pub mod knots;
pub mod kohonen;
mod limits;
mod method;
pub mod painter;
mod param;
pub mod ph;
mod pn;
mod point;
mod portable;
mod projection;
pub mod shaped;
pub mod skin;
mod slopes;
mod smooth;
mod spline;
mod stepped;
mod surface;
mod tridiagonal;
mod view;
mod walk;
mod weights;
mod window;

pub use arcs::{ArcPoint, smoothed_handles, turned_handle};
pub use basis::{Basis, Blend};
pub use beta::{Shape, VaryingBeta};
pub use bezier::Bezier;
pub use bounds::BoundingBox;
pub use chebyshev::Chebyshev;
pub use contact::{SpanContact, contact};
pub use cubic::CubicBezier;
pub use curve::Curve;
pub use dice::Dice;
pub use error::GeometryError;
pub use fourier::{ClosedPath, Deviation, Fourier, MAX_HARMONICS, Wave};
pub use hermite::{automatic_tangents, hermite_arcs};
pub use hidden::{DepthBuffer, MAX_SIDE, Pixel, Vertex, near_first};
pub use hull3::{Hull, convex_hull};
pub use limits::{COORDINATE_LIMIT, MAX_POINTS, MAX_SAMPLES};
pub use method::{Closure, Ends, Method};
pub use param::{ParamCurve, Sample, samples};
pub use pn::{
    Jacobian, Overview, PnData, PnMethod, PnNet, PnPlace, PnSurface, RadiusRange, RationalPatch,
    RationalPatches, RationalSurface, SafeDistances, Shell,
};
pub use point::{Point, cross, curvature_vector, dot, norm};
pub use projection::Projection;
pub use slopes::{slopes, smoothed_tangents};
pub use smooth::{
    DENSITY, Degree, FEWEST_MEASURED, MAX_FILTERED, Residuals, Smoothed, Smoothing, Stage, smooth,
};
pub use stepped::stepped_spline;
pub use surface::{
    BSplineSurface, Border, Contact, Derivatives, Grid, Joined, Joint, JointDeviation, Order, ParamSurface,
    Patch, Plane, RefineDirection, Rim, Scheme, Surface, SurfaceSample, Topology, Weave, refine, section,
    surface_samples, triangle_width,
};
pub use view::{CENTRE, STEP, Turn, View};
pub use weights::Weights;
