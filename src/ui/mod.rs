//! What every program shows its user: frames, visual buttons with hot letters, the communication page
//! with its questions and entries, messages, the help page, and the words in Hungarian and English.
//!
//! The toolkit holds no state of a program. A question draws the program's picture and itself on top, so that the
//! language can change and the help page can open in the middle of a question.

mod ask;
pub(crate) mod axes;
mod command;
mod desk;
mod double_click;
mod entry;
mod frame;
mod help;
mod hint;
pub mod hungarian;
mod key_lines;
mod lesson;
pub(crate) mod look;
mod notice;
mod overwrite;
pub(crate) mod painter;
mod panel;
mod phrase;
mod program;
mod save;
mod seen;
mod settings;
mod slider;
mod stopwatch;
pub(crate) mod tint;
pub mod words;

pub use ask::{Answer, Caption, Choices, Field, Form, MIDDLE, Number, Question, TOP, Way};
pub use command::{Command, Commands};
pub use desk::{Desk, END, KeyHelp, Manual, Over, Picture, line};
pub use double_click::DoubleClick;
pub use entry::{Accepts, Entry, Typed};
pub use frame::{Area, Button, Pad, page, panel, raised, sunken, window};
pub use hint::{HINT_LINES, Hint};
pub use lesson::Lesson;
pub use notice::Stay;
pub use panel::{Done, Panel, Row, Tab};
pub use phrase::{Hot, Phrase, Words};
pub use program::{CommandLine, Demo, Group, Program, Run, Start, without_document};
pub use slider::Slider;
pub use stopwatch::Stopwatch;
