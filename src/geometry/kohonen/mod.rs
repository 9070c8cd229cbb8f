//! Kohonen nets: a net of neurons in space that learns the shape of a cloud of points (Kohonen 1984; Hoffmann and Várady
//! 1997, "Free-form surfaces for scattered data by neural networks").
//!
//! At every step a point of the cloud is taken, the neuron nearest to it wins, and the winner and its neighbours on the
//! net move towards it. Gain and radius fall, and the net unfolds over the cloud ([`Learning`]). A growing net begins
//! small and gets rows and columns where it wins most ([`Learning::growing`]). The net of one row or column is a
//! polygon that puts the points of a plane cloud in order. A surface is made of the net, and fitted to the cloud, in
//! [`fit`](super::fit).
//!
//! Learning is a value that is asked to advance a number of steps, can be looked at whenever that is done, and dropped at
//! any time. One step of a 20 x 20 net takes less than a microsecond, so a picture at 60 a second may have 12 000.
//!
//! ```
//! use grafika::geometry::cloud::{Cloud, CloudShape};
//! use grafika::geometry::kohonen::{Learning, Net, Rule, Topology};
//!
//! let cloud = Cloud::of_shape(CloudShape::Saddle, 2000, 0.02, 1)?;
//! let start = Net::random(&cloud, [8, 8], Topology::Open, 1)?;
//! let mut learning = Learning::new(&cloud, start, Rule::default())?;
//! while learning.advance(500).is_none() {
//!     // A picture: the net, the last point and its winner, gain and radius.
//!     let (lines, step) = (learning.net().lines(), learning.last().expect("500 steps are made"));
//!     assert!(lines.len() == 16 && step.winner[0] < 8 && step.gain <= 0.5);
//! }
//! let net = learning.into_net();
//! let near = net.rows().concat().iter().all(|neuron| CloudShape::Saddle.distance(*neuron) < 0.1);
//! assert!(near);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod growth;
mod learning;
mod neighbours;
mod net;
mod schedule;
mod shaped;
#[cfg(test)]
mod tests;
mod topology;

pub use error::KohonenError;
pub use learning::{End, Learning, Order, Rule, Step};
pub use net::Net;
pub(in crate::geometry) use net::Search;
pub use schedule::{Schedule, Weighting};
pub use topology::Topology;

/// The most rows or columns of a net.
pub const MAX_SIDE: usize = 512;
/// The most neurons of a net.
pub const MAX_NEURONS: usize = 16_384;
/// The most steps of learning.
pub const MAX_STEPS: u64 = 1_000_000_000_000;
