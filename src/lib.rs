//! The programs of János Füzi's book *Interaktív grafika* (Budapest, 1997) as native programs, and the
//! rooms they are built from: a 640x480 screen of 16 colours, smooth curves and surfaces by control
//! points, the data files of the DOS programs, and pictures for other programs.
//!
//! Rooms stand on floors; a room imports only from floors below (see `ARCHITECTURE.md`):
//!
//! 1. [`screen`], [`geometry`], [`algebra`], [`table`], [`puzzle`], [`pascal`]: values and algorithms without I/O;
//! 2. [`machine`], [`figure`], [`mod@file`]: what a program runs on, and the formats it reads and writes;
//! 3. [`ui`], [`design`], [`display`], `disk`: the toolkit, what a document describes, and where it is shown and kept;
//! 4. [`work`], [`cursor`], `textmode`: the life of a document, cursors, pages of text;
//! 5. [`editor`]: the editor of curves and surfaces;
//! 6. [`programs`]: the programs themselves;
//! 7. `launch`: their start from a command line.

pub mod algebra;
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
