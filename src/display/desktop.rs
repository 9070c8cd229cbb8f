//! Whether there is a desktop to open a window on, and what can go wrong with a window.

use std::ffi::OsString;

/// The largest scale that a window can be opened with: 16 is more than any desktop shows.
pub const LARGEST_SCALE: u32 = 16;

/// What can go wrong with a window.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WindowError {
    /// The scale is not 1 to [`LARGEST_SCALE`].
    #[error("a window cannot be scaled by {0}; give a whole number from 1 to {LARGEST_SCALE}")]
    Scale(u32),
    /// No window could be opened; the system's own message.
    #[error("no window could be opened ({0}); try the terminal display")]
    Open(String),
    /// The window could not be painted; the system's own message.
    #[error("the window could not be painted ({0})")]
    Paint(String),
}

/// A scale that a window can be opened with, or none.
///
/// # Errors
/// [`WindowError::Scale`] for any other.
pub(super) fn checked_scale(scale: Option<u32>) -> Result<Option<u32>, WindowError> {
    match scale {
        Some(scale) if !(1..=LARGEST_SCALE).contains(&scale) => Err(WindowError::Scale(scale)),
        scale => Ok(scale),
    }
}

/// Systems by how they tell that there is a desktop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum System {
    Windows,
    Mac,
    /// Any other.
    Unix,
}

/// Whether there is a desktop to open a window on: always on Windows; on macOS unless the process was started over the
/// network; elsewhere when the environment names an X11 or Wayland display.
#[must_use]
pub fn window_possible() -> bool {
    let system = match () {
        () if cfg!(windows) => System::Windows,
        () if cfg!(target_os = "macos") => System::Mac,
        () => System::Unix,
    };
    possible(system, |name| std::env::var_os(name))
}

fn possible(system: System, variable: impl Fn(&str) -> Option<OsString>) -> bool {
    let set = |name| variable(name).is_some_and(|value| !value.is_empty());
    match system {
        System::Windows => true,
        // A window would open on the desk of whoever sits there, or nowhere. A server of X11 is of no use to it.
        System::Mac => !["SSH_CONNECTION", "SSH_CLIENT", "SSH_TTY"].into_iter().any(set),
        System::Unix => ["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(set),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(system: System, set: &[(&str, &str)]) -> bool {
        possible(system, |name| set.iter().find(|(known, _)| *known == name).map(|(_, value)| value.into()))
    }

    #[test]
    fn every_system_tells_in_its_own_way() {
        let over_ssh = [("SSH_CONNECTION", "10.0.0.2 50000 10.0.0.1 22")];
        for (system, set, possible) in [
            (System::Windows, &[][..], true),
            (System::Windows, &over_ssh, true),
            (System::Mac, &[], true),
            (System::Mac, &over_ssh, false),
            (System::Mac, &[("SSH_TTY", "/dev/ttys001"), ("DISPLAY", ":0")], false),
            (System::Unix, &[], false),
            (System::Unix, &[("DISPLAY", "")], false),
            (System::Unix, &[("DISPLAY", ":0")], true),
            (System::Unix, &[("WAYLAND_DISPLAY", "wayland-0"), over_ssh[0]], true),
        ] {
            assert_eq!(with(system, set), possible, "{system:?} {set:?}");
        }
    }
}
