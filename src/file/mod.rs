//! The data files of the DOS programs by extension: bytes to values and back, and JSON and CSV beside them.
//!
//! [`Document::read`] trusts no byte: a file is refused with what is wrong and where.
//! [`Document::write`] gives a file that the DOS program reads and draws rightly. JSON holds everything
//! that a document can, also what the DOS format has no place for: settings, fractions, more points. Points are
//! read from tables of text as people have them, with [`TableOptions`] for what a table does not tell.
//! Clouds of points come from files of other programs; a [`CloudReader`] reads them in pieces.
//! Nothing is opened or saved here; [`crate::machine`] does that.
//!
//! ```
//! use grafika::file::{Document, FileError, FileKind, Format, convert};
//!
//! let text = "{\"format\": \"IP2\", \"points\": [[60, 80], [250, 200.5]], \"settings\": {\"closed\": true}}";
//! let document = Document::from_json(text)?.without_settings();
//! let refusal = document.write(Format::Ip2).unwrap_err().to_string();
//! assert_eq!(refusal, "does not fit into .IP2: point 2: y = 200.5; it holds whole numbers 0 to 380");
//!
//! let bytes = convert(b"x,y\n60,80\n250,200\n", FileKind::Csv, FileKind::Dos(Format::Ip2))?;
//! assert_eq!(bytes.len(), 1300);
//! assert_eq!(Document::read(Format::Ip2, &bytes)?.describe()[1], "x 60 .. 250, y 80 .. 200");
//! # Ok::<(), FileError>(())
//! ```

mod billiards;
mod check;
mod circles;
mod cloud;
mod convert;
pub mod cube;
mod document;
pub mod ec;
mod error;
mod format;
mod fourier;
mod json;
mod json_points;
mod json_text;
mod knot_rule;
mod knots;
mod net;
mod patches;
mod places;
mod plane;
mod rational;
mod settings;
mod shaped;
mod som;
mod space;
mod table;
pub mod wheel;

pub use check::{MAX_POINTS, number};
pub use circles::{Circles, Spheres};
pub use cloud::{
    Cloud, CloudFormat, CloudReader, CloudWriter, Encoding, LeftOut, MAX_CLOUD_POINTS, Skipped, Spot,
};
pub use convert::{FileKind, TABLES, convert};
pub use cube::{CsangoCube, CubePiece};
pub use document::Document;
pub use error::FileError;
pub use format::Format;
pub use fourier::{Fourier, HARMONICS};
pub use knot_rule::KnotRule;
pub use knots::{KnotNet, KnotPoints, MAX_CONTROLS};
pub use net::{Net, NetKind, RATIOS};
pub use patches::{PatchItem, Patches};
pub use places::Places;
pub use plane::{FIELD, PlanePoints, Tangent, Tangents};
pub use rational::{Cusp, RationalSpan, RationalSpans, SelfCrossing};
pub use settings::{CurveSettings, Method, NetSettings};
pub use shaped::{FamilyName, LambdaValue, PhiName, ShapedPoints};
pub use som::SomNet;
pub use space::{SPACE_VIEW, SpacePoints};
pub use table::{Columns, Decimal, Delimiter, TableOptions};
pub use wheel::BeadWheel;
