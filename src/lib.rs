//! The programs of János Füzi's book *Interaktív grafika* (Budapest, 1997) as native programs, and the
//! rooms they are built from: a 640x480 screen of 16 colours, smooth curves and surfaces by control
//! points, the data files of the DOS programs, and pictures for other programs.
//!
//! Rooms stand on floors; a room imports only from floors below (see `ARCHITECTURE.md`):
//! [`screen`], [`geometry`], [`table`], [`puzzle`] and [`pascal`] on the ground floor, above them [`mod@file`], [`figure`] and
//! [`machine`], then [`ui`], [`display`] and `disk`, then [`editor`], [`cursor`] and the pages of a text mode. The programs themselves
//! stand on top of the library.

pub mod cursor;
pub mod design;
#[cfg(feature = "native")]
pub mod disk;
pub mod display;
pub mod editor;
pub mod figure;
pub mod file;
pub mod geometry;
#[cfg(feature = "native")]
pub mod launch;
pub mod machine;
pub mod pascal;
#[path = "../programs/mod.rs"]
pub mod programs;
pub mod puzzle;
pub mod screen;
pub mod table;
#[cfg(feature = "native")]
pub mod textmode;
pub mod ui;
pub mod work;
