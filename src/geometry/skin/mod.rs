//! Skins: smooth outlines over circles, and smooth surfaces over spheres, that touch each of them.
//!
//! [`Circles`] hang together as a chain, a ring or a tree ([`Links`]). Their [`Skin`] touches every circle where a circle
//! of Apollonius, which touches it and two neighbours, does; between touching points it is a cubic arc. Circles that are
//! not admissible ([`Circles::violations`]) have what exists of a skin, so that an editor can draw it while a disc is
//! dragged. After M. Hoffmann's dissertation (booklet, 2.3) and R. Kunkli and M. Hoffmann ("Skinning of circles and
//! spheres", 2010).
//!
//! ```
//! use grafika::geometry::ParamCurve;
//! use grafika::geometry::skin::{Circle, Circles, Clearing, Side};
//!
//! let discs = [([0.0, 0.0], 1.0), ([4.0, 0.0], 2.0), ([8.0, 0.0], 1.0)];
//! let circles = Circles::chain(discs.map(|(center, radius)| Circle { center, radius }).to_vec())?;
//! assert!(circles.is_admissible());
//! let skin = circles.skin(Clearing::Scaled);
//! // One outline: two arcs on either side, and two caps.
//! assert_eq!((skin.loops.len(), skin.loops[0].spans()), (1, 6));
//! assert_eq!(skin.sides()[1], [Some([4.0, 2.0]), Some([4.0, -2.0])]);
//! assert!(skin.side_arcs(Side::Left).iter().all(|arc| arc.clear));
//! // The middle one is dragged aside: the broken rule is told.
//! let dragged = circles.with_circle(1, Circle { center: [1.0, 0.0], radius: 2.0 })?;
//! assert_eq!(dragged.violations()[0].to_string(), "circle 1 is covered by the others");
//! # Ok::<(), grafika::geometry::skin::SkinError>(())
//! ```
//!
//! [`Spheres`] are strung on chains. Their [`SphereSkin`] consists of tubes and end caps, which are surfaces, exact for
//! CAD programs, and together a closed mesh:
//!
//! ```
//! use grafika::geometry::skin::{Clearing, MESH_STEPS, Sphere, Spheres};
//!
//! let balls = [([0.0, 0.0, 0.0], 1.0), ([3.0, 1.0, 0.5], 1.3), ([6.0, 0.5, 2.0], 0.9)];
//! let spheres = Spheres::chain(balls.map(|(center, radius)| Sphere { center, radius }).to_vec())?;
//! let skin = spheres.skin(Clearing::Scaled);
//! assert_eq!((skin.circles().len(), skin.parts().len()), (3, 3));
//! assert!(skin.parts().iter().all(|part| part.to_bspline().is_some()));
//! assert!(skin.mesh(MESH_STEPS)?.triangles.len() > 1000);
//! # Ok::<(), grafika::geometry::skin::SkinError>(())
//! ```

mod admissible;
mod apollonius;
mod ball;
mod circles;
mod clear;
mod contact;
mod end_cap;
mod error;
mod frame;
mod graph;
mod hermite;
mod links;
mod mesh;
mod outline;
mod plane;
mod rules;
mod solid;
mod spheres;
mod touching;
mod tube;

pub use apollonius::{Apollonius, PowerPoint, RadicalLine, TouchingShape};
pub use ball::{Ball, Circle, Sphere};
pub use circles::Circles;
pub use clear::Clearing;
pub use end_cap::EndCap;
pub use error::SkinError;
pub use links::Links;
pub use mesh::SkinMesh;
pub use outline::{Cap, Outline, Piece, SkinArc};
pub use plane::{Side, Skin, Touch};
pub use rules::Violation;
pub use solid::{Arm, MESH_STEPS, SphereSkin};
pub use spheres::Spheres;
pub use touching::TouchingCircle;
pub use tube::{Tube, TubeSpan};

/// The largest number of circles or spheres.
pub const MAX_BALLS: usize = 1000;
/// The largest number of edges, and of spheres in all chains together.
pub const MAX_EDGES: usize = 4000;

/// What comparisons allow for: 1e-12 of the largest coordinate or radius.
fn tolerance<const D: usize>(balls: &[Ball<D>]) -> f64 {
    let sizes = balls.iter().flat_map(|ball| ball.center.into_iter().chain([ball.radius]));
    1e-12 * sizes.fold(0.0_f64, |largest, x| largest.max(x.abs()))
}

#[cfg(test)]
mod tests;
