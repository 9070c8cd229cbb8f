//! Lines of the help page that mean the same in several programs.

use crate::ui::KeyHelp;
use crate::ui::words::{self, Words};

pub(super) const INSERT: KeyHelp = (Words("B", "B"), words::HELP_INSERT);
pub(super) const CHANGE: KeyHelp = (Words("V", "V"), words::HELP_CHANGE);
pub(super) const DELETE: KeyHelp = (Words("T", "T"), words::HELP_DELETE);
pub(super) const METHOD: KeyHelp = (Words("G 1-4", "G 1-4"), words::HELP_CURVE);
pub(super) const FORM: KeyHelp = (Words("G", "G"), words::HELP_CURVE_FORM);
pub(super) const SHAPE: KeyHelp = (Words("A C", "A C"), words::HELP_SHAPE);
pub(super) const RESULT: KeyHelp = (Words("E", "E"), words::HELP_RESULT);
/// The questions at the end.
pub const QUIT: KeyHelp = (Words("Q", "Q"), words::HELP_QUIT);
pub(super) const FOLLOW: KeyHelp = (Words("F3", "F3"), words::HELP_FOLLOW);
/// Saving.
pub const SAVE: KeyHelp = (Words("Ctrl+S", "Ctrl+S"), words::HELP_SAVE);
/// Undo and redo.
pub const UNDO: KeyHelp = (Words("Ctrl+Z Ctrl+Y", "Ctrl+Z Ctrl+Y"), words::HELP_UNDO);
