//! The folders that a system has for what belongs to a user and a program, beside the user's own files.

use etcetera::base_strategy::{BaseStrategy, choose_native_strategy};
use std::path::PathBuf;

/// What a folder is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UserFolder {
    /// What is to outlive a session: `$XDG_STATE_HOME` or else `~/.local/state`; `%LOCALAPPDATA%` on Windows.
    State,
    /// What the user has chosen: `$XDG_CONFIG_HOME` or else `~/.config`; `%APPDATA%` on Windows.
    Config,
}

impl UserFolder {
    /// The programs' own folder there, `grafika`; on macOS in `~/Library/Application Support` either way. `None`
    /// when the system knows no such place.
    #[must_use]
    pub fn path(self) -> Option<PathBuf> {
        let folders = choose_native_strategy().ok()?;
        let folder = match self {
            // Preferences are there for what the system itself writes, and there is no folder for state.
            _ if cfg!(target_os = "macos") => folders.data_dir(),
            UserFolder::Config => folders.config_dir(),
            // Windows has no folder for state either; like a cache, it stays on the machine.
            UserFolder::State => folders.state_dir().unwrap_or_else(|| folders.cache_dir()),
        };
        // A relative path would be another folder for every current one.
        folder.is_absolute().then(|| folder.join("grafika"))
    }
}
