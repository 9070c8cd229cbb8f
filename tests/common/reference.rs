//! The screens of the original programs: every script in `tests/reference` gives its picture.

use super::{path, pictures, play_script, storage};
use grafika::ui::Program;

/// The least part of all pixels that must agree with a screen of the original. Its letters are of
/// another face, which alone is some 0.3 %.
const LEAST_AGREEMENT: f64 = 0.985;

/// How far a screen may be from the original's.
#[derive(Clone, Copy)]
pub(crate) enum Allowance {
    /// The least part of all pixels that must agree, 0 to 1.
    Agreement(f64),
    /// The largest number of pixels that may differ.
    Pixels(usize),
}

impl Allowance {
    /// What is wrong with a screen, if it is further off.
    fn problem(self, ours: &[u8], theirs: &[u8]) -> Option<String> {
        match self {
            Allowance::Agreement(least) => {
                let agreement = pictures::agreement(ours, theirs);
                (agreement < least).then(|| format!("{agreement:.4} agree"))
            }
            Allowance::Pixels(most) => {
                let difference = pictures::difference(ours, theirs)?;
                (difference.pixels > most).then(|| difference.to_string())
            }
        }
    }
}

/// Plays every script of a folder whose name begins so, and compares the screens. Returns how many
/// there were and the problems.
fn compare_all(
    program: Program,
    folder: &str,
    prefix: &str,
    allowance: impl Fn(&str) -> Allowance,
) -> (usize, Vec<String>) {
    let folder_path = path(folder);
    let mut scripts = 0;
    let mut problems = Vec::new();
    for entry in std::fs::read_dir(&folder_path).expect("the folder is there") {
        let file = entry.expect("the folder can be read").path();
        let name = file.file_stem().expect("files have names").to_string_lossy().into_owned();
        if file.extension().is_none_or(|extension| extension != "script") || !name.starts_with(prefix) {
            continue;
        }
        let script = std::fs::read_to_string(&file).expect("scripts are text");
        let needs = script.lines().find_map(|line| line.strip_prefix("# needs ")).unwrap_or("");
        let files: Vec<&str> = needs.split_whitespace().collect();
        let kept = play_script(program, storage(folder, &files), &script);
        let picture = format!("{name}.png");
        let ours = kept.pictures[&picture].pixels();
        let theirs = pictures::read(&folder_path.join(&picture));
        if let Some(problem) = allowance(&name).problem(ours, &theirs) {
            let kept = pictures::keep_both(&name, ours, &theirs);
            problems.push(format!("{name}: {problem}, see {}", kept.display()));
        }
        scripts += 1;
    }
    (scripts, problems)
}

/// Fails unless there are so many scripts whose names begin so, and each gives the original's screen.
pub(crate) fn assert_screens(program: Program, folder: &str, prefix: &str, count: usize) {
    assert_screens_within(program, folder, prefix, count, Allowance::Agreement(LEAST_AGREEMENT));
}

/// As [`assert_screens`], with an allowance of one's own.
pub(crate) fn assert_screens_within(
    program: Program,
    folder: &str,
    prefix: &str,
    count: usize,
    allowance: Allowance,
) {
    assert_screens_each(program, folder, prefix, count, |_| allowance);
}

/// As [`assert_screens`], with an allowance for each screen by its name.
pub(crate) fn assert_screens_each(
    program: Program,
    folder: &str,
    prefix: &str,
    count: usize,
    allowance: impl Fn(&str) -> Allowance,
) {
    let (scripts, problems) = compare_all(program, folder, prefix, allowance);
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert_eq!(scripts, count);
}
