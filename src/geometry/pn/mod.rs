//! Surfaces with Pythagorean normals (PN surfaces): rational surfaces whose unit normals are rational too, so
//! that all their offsets are rational. They interpolate a net of points with unit normals.
//!
//! The unit normals and the support function h = x·n map a surface to the cylinder S² x R, and projection
//! from its point (0, 0, 1, 0) maps that to space: (p, q, r) = (n_x, n_y, h)/(1 - n_z). A bicubic C1 patchwork
//! there goes back to a surface that is G1: its normals are continuous and have continuous derivatives, its
//! points meet with common tangent planes (Lávička, Šír and Vršek, arXiv:1602.01224).
//!
//! - [`PnData`]: the net of points and normals;
//! - [`PnNet`]: all patches, also those that are parabolic somewhere, and the sign of their Jacobian;
//! - [`PnSurface`]: the surface, once all patches are proved regular; its offsets, radii of curvature, rational
//!   form ([`RationalSurface`]) and shells ([`Shell`]);
//! - [`RationalPatches`]: a surface of rational patches that were written down.

mod bernstein;
mod chart;
mod data;
mod isotropic;
mod jet;
mod net;
mod overview;
mod patch;
mod patches;
mod radii;
mod rational;
mod shell;
mod surface;

pub use chart::PnMethod;
pub use data::PnData;
pub use net::{Jacobian, PnNet};
pub use overview::Overview;
pub use patches::RationalPatches;
pub use radii::{RadiusRange, SafeDistances};
pub use rational::{RationalPatch, RationalSurface};
pub use shell::Shell;
pub use surface::{PnPlace, PnSurface};

#[cfg(test)]
mod examples;
#[cfg(test)]
mod tests;
