//! The folders that a system has for what belongs to a user and a program, beside the user's own files.

use std::ffi::OsString;
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
    /// when the environment names no such place.
    #[must_use]
    pub fn path(self) -> Option<PathBuf> {
        self.path_by(|name| std::env::var_os(name))
    }

    fn path_by(self, variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
        let (windows, standard, below_home) = match self {
            UserFolder::State => ("LOCALAPPDATA", "XDG_STATE_HOME", ".local/state"),
            UserFolder::Config => ("APPDATA", "XDG_CONFIG_HOME", ".config"),
        };
        // A relative path would be another folder for every current one; the standard says to ignore it.
        let path = |name| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let home = |below: &str| path("HOME").map(|home| home.join(below));
        let base = if cfg!(windows) {
            path(windows)
        } else if cfg!(target_os = "macos") {
            home("Library/Application Support")
        } else {
            path(standard).or_else(|| home(below_home))
        };
        base.map(|base| base.join("grafika"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn the_folders_are_the_standards() {
        for (kind, standard, below) in [
            (UserFolder::State, "XDG_STATE_HOME", ".local/state"),
            (UserFolder::Config, "XDG_CONFIG_HOME", ".config"),
        ] {
            let folder = |set: &[(&str, &str)]| {
                kind.path_by(|name| {
                    set.iter().find(|(known, _)| *known == name).map(|(_, value)| value.into())
                })
            };
            if cfg!(all(unix, not(target_os = "macos"))) {
                let home = ("HOME", "/home/me");
                let below_home = Path::new("/home/me").join(below).join("grafika");
                assert_eq!(folder(&[home]).as_deref(), Some(&*below_home));
                for unset in ["", "relative"] {
                    assert_eq!(folder(&[(standard, unset), home]).as_deref(), Some(&*below_home));
                }
                assert_eq!(folder(&[(standard, "/x"), home]).as_deref(), Some(Path::new("/x/grafika")));
            }
            assert_eq!(folder(&[]), None);
        }
    }
}
