//! Help lines that several programs share.

use crate::ui::KeyHelp;
use crate::ui::words::{self, Words};

/// The questions at the end.
pub const QUIT: KeyHelp = (Words("Q", "Q"), words::HELP_QUIT);
/// Saving.
pub const SAVE: KeyHelp = (Words("Ctrl+S", "Ctrl+S"), words::HELP_SAVE);
/// Undo and redo.
pub const UNDO: KeyHelp = (Words("Ctrl+Z Ctrl+Y", "Ctrl+Z Ctrl+Y"), words::HELP_UNDO);
pub(crate) const TURN_DRAG: KeyHelp = (Words("jobb gomb", "right button"), words::HELP_TURN_DRAG);
pub(crate) const TURN_KEYS: KeyHelp = (Words("nyilak", "arrows"), words::HELP_TURN_KEYS);
pub(crate) const ZOOM: KeyHelp = (Words("görgő", "wheel"), words::HELP_ZOOM);
pub(crate) const HOME: KeyHelp = (Words("Home", "Home"), words::HELP_HOME);
/// Parallel and central projection.
pub(crate) const SIGHT: KeyHelp = (Words("L", "L"), words::HELP_SIGHT);
