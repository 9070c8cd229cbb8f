//! Where executables are found, and which folder is offered.

use std::path::{Path, PathBuf};

/// The executable of a name beside this one, if it is there.
pub(crate) fn executable(name: &str) -> Option<PathBuf> {
    // Of a link, where it leads: beside it are the others.
    let here = std::env::current_exe().ok()?;
    let here = std::fs::canonicalize(&here).unwrap_or(here);
    let beside = here.parent()?.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    beside.is_file().then_some(beside)
}

fn home() -> Option<PathBuf> {
    let named = |name| std::env::var_os(name).filter(|value| !value.is_empty());
    named("HOME").or_else(|| named("USERPROFILE")).map(PathBuf::from)
}

/// The folder that is offered: `grafika` at home, as the original offered `c:\grafika`.
pub(crate) fn offered() -> PathBuf {
    home().unwrap_or_default().join("grafika")
}

/// The folder of a text that was typed, with `~` for home.
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
