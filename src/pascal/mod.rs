//! Turbo Pascal's typed files, `file of T`: packed records without header or padding, little-endian
//! integers, IEEE singles and the 6-byte `real`.
//!
//! [`Reader`] and [`Writer`] walk over the bytes of such a file field by field; [`real48`] converts the
//! 6-byte real. What the fields mean, and which values are allowed, is not known here, and no file is
//! opened: see [`crate::file`].

pub mod real48;
mod record;

pub use real48::Real48Error;
pub use record::{Reader, ShortRead, Writer};
