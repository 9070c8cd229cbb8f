//! Finds executables, and proposes a folder.

use std::path::{Path, PathBuf};

/// The executable of a name beside this one, if it exists.
pub(crate) fn executable(name: &str) -> Option<PathBuf> {
    // Links are resolved: the other executables lie beside the target. On Windows the standard library would give a path
    // that begins with `\\?\`, which cmd does not start.
    let here = std::env::current_exe().ok()?;
    let here = dunce::canonicalize(&here).unwrap_or(here);
    let beside = here.parent()?.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    beside.is_file().then_some(beside)
}

fn home() -> Option<PathBuf> {
    let named = |name| std::env::var_os(name).filter(|value| !value.is_empty());
    named("HOME").or_else(|| named("USERPROFILE")).map(PathBuf::from)
}

/// The proposed folder: `grafika` in the home folder, as the original proposed `c:\grafika`.
pub(crate) fn offered() -> PathBuf {
    home().unwrap_or_default().join("grafika")
}

/// The folder of a typed text, with `~` for the home folder.
pub(crate) fn of_text(text: &str) -> PathBuf {
    expanded(text, home().as_deref())
}

fn expanded(text: &str, home: Option<&Path>) -> PathBuf {
    let rest = text.strip_prefix('~').filter(|rest| rest.is_empty() || rest.starts_with(['/', '\\']));
    match (rest, home) {
        (Some(rest), Some(home)) => home.join(rest.trim_start_matches(['/', '\\'])),
        _ => PathBuf::from(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tilde_is_home() {
        let home = Path::new("/home/me");
        assert_eq!(expanded("~/a", Some(home)), home.join("a"));
        assert_eq!(expanded("~", Some(home)), home);
        assert_eq!(expanded("~you/a", Some(home)), Path::new("~you/a"));
        assert_eq!(expanded("/a", Some(home)), Path::new("/a"));
        assert_eq!(expanded("~/a", None), Path::new("~/a"));
    }
}
