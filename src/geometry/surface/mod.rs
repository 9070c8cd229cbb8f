//! Surfaces by a net of control points (chapter 3): interpolation, B-splines and beta-splines as nets of
//! bicubic Bézier patches, and the Bézier patch by all points.
//!
//! A surface is weights along `u` times the net times weights along `v`; sphere and torus topology, doubled
//! borders and auxiliary pole points only change the weights ([`weave`](self::weave)).
//!
//! What all surfaces can do is [`ParamSurface`]; sampling, sections and shading are written there once.

mod bspline;
mod contact;
mod exact;
mod fit;
mod grid;
mod inspect;
mod joined;
mod joint;
mod param;
mod patch;
mod patches;
mod refine;
mod scheme;
mod section;
mod tensor;
mod weave;

pub use bspline::{BSplineSurface, Rim};
pub use contact::{Contact, Deviation as JointDeviation, Order};
pub(super) use grid::indices;
pub use grid::{Grid, triangle_width};
pub use joined::Joined;
pub use joint::Joint;
pub use param::{ParamSurface, SurfaceSample, surface_samples};
pub use patch::{Derivatives, Patch};
pub use patches::Surface;
pub(super) use patches::check_net;
pub use refine::{RefineDirection, refine};
pub use scheme::{Border, Scheme, Topology};
pub use section::{Plane, section};
pub use tensor::Weave;
