//! Taking an installation back: what its notes name and nobody has changed since.

use super::notes::{NAME, Notes, Print};
use crate::disk::reason;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What became of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fate {
    /// It is gone.
    Removed,
    /// It was gone already.
    Missing,
    /// It is not what was installed, and stays.
    Changed,
}

/// Removes what was installed into a folder, and says of every file what became of it. The notes go last, so that an end
/// before them can be followed by another try.
///
/// # Errors
/// That there are no notes, or that something cannot be removed; what was removed before is gone.
pub(crate) fn remove(root: &Path, mut tell: impl FnMut(&Path, Fate)) -> Result<(), String> {
    let failed = |path: &Path, error: &io::Error| format!("{}: {}", path.display(), reason(error));
    let mut notes = Notes::read(root)
        .map_err(|error| failed(root, &error))?
        .ok_or_else(|| format!("{}: nothing was installed here, as {NAME} would note", root.display()))?;
    let inside = fs::canonicalize(root).map_err(|error| failed(root, &error))?;
    for (name, print) in &notes.files {
        let path = root.join(name);
        let fate = fate(&inside, &path, print).map_err(|error| failed(&path, &error))?;
        tell(Path::new(name), fate);
    }
    let made = notes.folders.remove("");
    let own = root.join(NAME);
    fs::remove_file(&own).map_err(|error| failed(&own, &error))?;
    // Deeper ones first; those with something else in them stay.
    let folders: Vec<PathBuf> = notes.folders.iter().rev().map(|name| root.join(name)).collect();
    for folder in folders.iter().filter(|folder| !folder.is_symlink()) {
        let _ = fs::remove_dir(folder);
    }
    if made {
        let _ = fs::remove_dir(root);
    }
    Ok(())
}

fn fate(inside: &Path, path: &Path, print: &Print) -> io::Result<Fate> {
    // A folder that has become a link since leads elsewhere.
    let folder = path.parent().map(fs::canonicalize);
    let found = match folder {
        Some(Ok(folder)) if folder.starts_with(inside) => fs::symlink_metadata(path),
        Some(Err(error)) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        Some(Err(_)) => return Ok(Fate::Missing),
        _ => return Ok(Fate::Changed),
    };
    match found {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Fate::Missing),
        Err(error) => Err(error),
        Ok(about) if about.is_file() || about.is_symlink() => match Print::of(path)? == *print {
            true => fs::remove_file(path).map(|()| Fate::Removed),
            false => Ok(Fate::Changed),
        },
        Ok(_) => Ok(Fate::Changed),
    }
}

#[cfg(test)]
mod tests {
    use super::super::job::{Answer, Job, Step};
    use super::super::journal::tests::{contents, scratch};
    use super::super::plan::{Plan, System, Way};
    use super::*;
    use crate::programs::groups::GROUPS;

    fn install(root: &Path, groups: &[&'static crate::ui::Group], way: Way) {
        let executable = std::env::current_exe().unwrap();
        let find = |name: &str| (name == "grafika").then(|| executable.clone());
        let plan = Plan::new(groups, &find, System::HERE, way).unwrap();
        let mut job = Job::new(root.to_path_buf(), plan, Some(Answer::All));
        while !matches!(job.step().unwrap(), Step::Finished(_)) {}
    }

    #[test]
    fn what_was_installed_is_taken_back() {
        let folder = scratch("removal");
        let root = folder.join("grafika");
        for way in [Way::default(), Way { copy: true, flat: false }, Way { copy: true, flat: true }] {
            install(&root, &GROUPS[..2], way);
            // Once more, with other groups: the notes are of both.
            install(&root, &GROUPS[1..4], way);
            let mut all = 0;
            remove(&root, |path, fate| {
                all += 1;
                assert_eq!(fate, Fate::Removed, "{}", path.display());
            })
            .unwrap();
            assert!(all > 10);
            assert_eq!(contents(&folder), [], "{way:?}");
        }
        assert!(remove(&root, |_, _| {}).is_err());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_was_there_or_is_changed_stays() {
        let root = scratch("removal-changed");
        fs::create_dir(root.join("GB_2D")).unwrap();
        fs::write(root.join("GB_2D/mine"), b"mine").unwrap();
        // It is there already as it would be installed.
        fs::write(root.join("GB_2D/B.IP2"), crate::machine::sample("B.IP2").unwrap()).unwrap();
        install(&root, &[GROUPS[1]], Way::default());
        fs::write(root.join("GB_2D/A.IP2"), b"edited").unwrap();
        fs::remove_file(root.join("GB_2D/gb_2d_ip")).unwrap();
        let mut fates = Vec::new();
        remove(&root, |path, fate| fates.push((path.to_path_buf(), fate))).unwrap();
        let fate = |name: &str| fates.iter().find(|(path, _)| path.ends_with(name)).map(|(_, fate)| *fate);
        assert_eq!(fate("A.IP2"), Some(Fate::Changed));
        assert_eq!(fate("gb_2d_ip"), Some(Fate::Missing));
        assert_eq!(fate("B.IP2"), None);
        let left: Vec<PathBuf> = contents(&root)
            .into_iter()
            .map(|(path, _)| path.strip_prefix(&root).unwrap().to_path_buf())
            .collect();
        assert_eq!(left, ["GB_2D", "GB_2D/A.IP2", "GB_2D/B.IP2", "GB_2D/mine"].map(PathBuf::from));
        fs::remove_dir_all(root).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn no_link_leads_out_of_the_folder() {
        use std::os::unix::fs::symlink;
        let folder = scratch("removal-links");
        let (root, outside) = (folder.join("root"), folder.join("outside"));
        for path in [&root, &outside] {
            fs::create_dir(path).unwrap();
        }
        symlink(&outside, root.join("GB_2D")).unwrap();
        let before = contents(&folder);
        let executable = std::env::current_exe().unwrap();
        let find = |_: &str| Some(executable.clone());
        let plan = Plan::new(&[GROUPS[1]], &find, System::HERE, Way::default()).unwrap();
        let mut job = Job::new(root.clone(), plan, Some(Answer::All));
        let failed = loop {
            if let Err(failed) = job.step() {
                break failed;
            }
        };
        assert!(failed.to_string().contains("is a link that leads out of the folder"), "{failed}");
        assert_eq!(contents(&folder), before);
        // A folder that becomes a link after the installation.
        fs::remove_file(root.join("GB_2D")).unwrap();
        install(&root, &[GROUPS[1]], Way::default());
        fs::remove_dir(&outside).unwrap();
        fs::rename(root.join("GB_2D"), &outside).unwrap();
        symlink(&outside, root.join("GB_2D")).unwrap();
        let there = contents(&outside);
        remove(&root, |_, _| {}).unwrap();
        assert_eq!(contents(&outside), there);
        fs::remove_dir_all(folder).unwrap();
    }
}
