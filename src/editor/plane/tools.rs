//! What the programs of the plane editor have of their own: their curves, buttons and files.

use super::Words;
use crate::editor::keys::{CHANGE, DELETE, FOLLOW, FORM, INSERT, METHOD, QUIT, RESULT, SAVE, SHAPE, UNDO};
use crate::editor::{beta, choice};
use crate::file::Format;
use crate::ui::words;
use crate::ui::{Button, KeyHelp};

/// The program that the editor is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tools {
    /// Curves by several methods (GB_2D_IP).
    Methods,
    /// Coons-Hermite curves with tangents of the user's own (GB_2D_CH).
    Tangents,
    /// Beta-splines (GB_2D_BT).
    Beta,
}

impl Tools {
    /// The format of its files.
    pub(super) fn format(self) -> Format {
        match self {
            Tools::Methods | Tools::Beta => Format::Ip2,
            Tools::Tangents => Format::Ic2,
        }
    }

    /// Its own buttons, left of the communication page.
    pub(super) fn buttons(self) -> &'static [Button] {
        match self {
            Tools::Methods => &choice::METHODS,
            Tools::Tangents => &[],
            Tools::Beta => &beta::BUTTONS,
        }
    }

    /// Its keys, for the help page.
    pub const fn keys(self) -> &'static [KeyHelp] {
        match self {
            Tools::Methods => METHOD_KEYS,
            Tools::Tangents => TANGENT_KEYS,
            Tools::Beta => BETA_KEYS,
        }
    }
}

const DRAG: KeyHelp = (Words("egér", "mouse"), words::HELP_DRAG);

const METHOD_KEYS: &[KeyHelp] = &[
    DRAG,
    INSERT,
    CHANGE,
    DELETE,
    METHOD,
    RESULT,
    QUIT,
    FOLLOW,
    (Words("F4 1-5", "F4 1-5"), words::HELP_COMPARE),
    (Words("F5", "F5"), words::HELP_WORKSHOP),
    SAVE,
    UNDO,
];

const TANGENT_KEYS: &[KeyHelp] = &[
    DRAG,
    (Words("egér", "mouse"), words::HELP_DRAG_TANGENT),
    INSERT,
    (Words("V", "V"), words::HELP_CHANGE_TANGENT),
    DELETE,
    FORM,
    RESULT,
    QUIT,
    FOLLOW,
    SAVE,
    UNDO,
];

const BETA_KEYS: &[KeyHelp] = &[
    DRAG,
    INSERT,
    CHANGE,
    DELETE,
    SHAPE,
    FORM,
    RESULT,
    QUIT,
    FOLLOW,
    (Words("F5", "F5"), words::HELP_JOINTS),
    (Words("F6", "F6"), words::HELP_JOINTS_OFF),
    SAVE,
    UNDO,
];
