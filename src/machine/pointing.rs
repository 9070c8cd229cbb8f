//! What moves the pointer where a program is shown, and the keys that do.

/// What moves the pointer where a program is shown, for hints that name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Pointing {
    /// A mouse or the like.
    #[default]
    Mouse,
    /// Keys that the display keeps for it: Ctrl with the arrows moves it, Ctrl+Space presses and releases its button.
    Keys,
}

/// A key that a display without a mouse keeps for itself, and what it does, in both languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointerKey {
    /// The keys.
    pub keys: &'static str,
    /// What they do, in Hungarian.
    pub hungarian: &'static str,
    /// What they do, in English.
    pub english: &'static str,
}

/// The keys that a display in a terminal keeps for itself: everything that a mouse does. Alt with the arrows
/// serves where the desktop keeps Ctrl with the arrows.
pub const POINTER_KEYS: [PointerKey; 7] = [
    PointerKey {
        keys: "Ctrl+↑ ↓ ← →, Alt+↑ ↓ ← →",
        hungarian: "az egér mozgatása egy karakterhellyel",
        english: "move the mouse by one character",
    },
    PointerKey {
        keys: "Shift+↑ ↓ ← →",
        hungarian: "az egér mozgatása egy képponttal",
        english: "move the mouse by one pixel",
    },
    PointerKey {
        keys: "Ctrl+Space, Alt+L",
        hungarian: "a bal egérgomb lenyomása, illetve felengedése",
        english: "press or release the left mouse button",
    },
    PointerKey {
        keys: "Alt+R",
        hungarian: "a jobb egérgomb lenyomása, illetve felengedése",
        english: "press or release the right mouse button",
    },
    PointerKey {
        keys: "Alt+PgUp, Alt+PgDn",
        hungarian: "az egér kerekének forgatása",
        english: "turn the mouse wheel",
    },
    PointerKey {
        keys: "Ctrl+Alt+Z",
        hungarian: "szünet: vissza a parancssorhoz; folytatás: fg",
        english: "pause: back to the shell; fg goes on",
    },
    PointerKey { keys: "Ctrl+C", hungarian: "kilépés", english: "close the program" },
];
