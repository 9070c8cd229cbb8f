//! The screens of the original programs: every script in `tests/reference` gives its picture.

use super::{path, pictures, play_script, shared_out, storage};
use grafika::ui::Program;

/// The least part of all pixels that must agree with a screen of the original. Its letters are of
/// another face, which alone is some 0.3 %.
const LEAST_AGREEMENT: f64 = 0.985;

/// The most strays. Right pictures have up to 440, those with a question over the picture the most:
/// letters again. A curve is so thin that a wrong one hardly touches the agreement, but it has 970 and
/// more.
const MOST_STRAYS: usize = 450;

/// The most strays on the screens of the curve editors. They ask beside the picture, so that right ones
/// have up to 16; a closed curve instead of an open one has no more than 283 where the last side is short.
const MOST_STRAYS_OF_CURVES: usize = 50;

/// How far a screen may be from the original's.
#[derive(Clone, Copy)]
pub(crate) enum Allowance {
    /// The least part of all pixels that must agree, 0 to 1, with at most [`MOST_STRAYS`].
    Agreement(f64),
    /// What the screens of the curve editors keep: [`LEAST_AGREEMENT`] with [`MOST_STRAYS_OF_CURVES`].
    Curve,
    /// The largest number of pixels that may differ.
    Pixels(usize),
}

/// Screens that have more strays than others may, although ours are right: how many they may have, and
/// why. An entry that is not needed is an error, so that none is left behind.
const STRAYS_EXPECTED: &[(&str, usize, &str)] = &[
    ("BILIARD_s2_ghost_at_560_246", 460, "ours has an aiming line"),
    (
        "F_P_BETS_A_eltolas",
        650,
        "the original leaves the auxiliary points of the border where a change was; see F_P_BETSX",
    ),
    ("F_P_HERM_Q_file", 5900, POLES),
    ("F_P_HERM_Q_mentes", 5900, POLES),
    ("F_P_HERM_Q_utan", 3500, POLES),
    ("F_P_HERM_Q_vege", 6200, POLES),
    ("GB_2D_IP_closed_bezier", 2600, "the original draws nothing; ours is the curve of the closed polygon"),
    (
        "GB_2D_IP_drag_new_held",
        4000,
        "ours follows the point that is held, the original leaves the old curve",
    ),
    ("GB_P_2D_thin_f_shifted", 720, OVER_THE_FRAME),
    ("GB_P_2D_thin_load_filenev", 720, OVER_THE_FRAME),
    ("GB_P_2D_thin_loaded_figa", 720, OVER_THE_FRAME),
    (
        "GYONGY_K_mouse_click_J",
        22_500,
        "the beads of a random problem: no two runs of the original have the same",
    ),
    ("GYONGY_K_q_new_or_stored", 1700, THICK),
    ("GYONGY_K_q_newconf", 2100, THICK),
    ("GYONGY_K_q_save", 2100, THICK),
];

const POLES: &str = "the original's arrows stop before the poles, ours go on, so that the view is another";
const OVER_THE_FRAME: &str =
    "the original draws a curve that leaves the field over the frame, where it stays";
const THICK: &str = "the original has left its lines thick: frames of questions and buttons";

impl Allowance {
    /// What is wrong with a screen, if it is further off.
    pub(crate) fn problem(self, name: &str, ours: &[u8], theirs: &[u8]) -> Option<String> {
        match self {
            Allowance::Agreement(least) => problem(name, ours, theirs, least, MOST_STRAYS),
            Allowance::Curve => problem(name, ours, theirs, LEAST_AGREEMENT, MOST_STRAYS_OF_CURVES),
            Allowance::Pixels(most) => {
                let difference = pictures::difference(ours, theirs)?;
                (difference.pixels > most).then(|| difference.to_string())
            }
        }
    }
}

/// What is wrong with a screen of which too little agrees or that has too many strays. `SHOW_STRAYS=1`
/// prints both for every screen.
fn problem(name: &str, ours: &[u8], theirs: &[u8], least: f64, usual: usize) -> Option<String> {
    let agreement = pictures::agreement(ours, theirs);
    let strays = pictures::strays(ours, theirs);
    if std::env::var_os("SHOW_STRAYS").is_some() {
        println!("{agreement:.4} {strays} {name}");
    }
    let expected = STRAYS_EXPECTED.iter().find(|(screen, ..)| *screen == name);
    if expected.is_some() && strays <= usual {
        return Some(format!("{strays} strays are no exception any more"));
    }
    let most = expected.map_or(usual, |(_, most, _)| *most);
    (agreement < least || strays > most)
        .then(|| format!("{agreement:.4} agree, at least {least} should; {strays} strays, at most {most}"))
}

/// A script of the originals with the files it needs and the screen they gave.
pub(crate) struct Reference {
    folder: String,
    pub(crate) name: String,
    pub(crate) script: String,
    pub(crate) screen: pictures::Pixels,
}

impl Reference {
    pub(crate) fn read(folder: &str, name: &str) -> Reference {
        let folder_path = path(folder);
        let script = std::fs::read_to_string(folder_path.join(format!("{name}.script")));
        Reference {
            folder: folder.to_string(),
            name: name.to_string(),
            script: script.unwrap_or_else(|error| panic!("{name}: {error}")),
            screen: pictures::read(&folder_path.join(format!("{name}.png"))),
        }
    }

    /// Plays a script where this one is played, and compares the picture it takes last.
    pub(crate) fn problem(&self, program: Program, script: &str, allowance: Allowance) -> Option<String> {
        let needs = self.script.lines().find_map(|line| line.strip_prefix("# needs ")).unwrap_or("");
        let files: Vec<&str> = needs.split_whitespace().collect();
        let kept = play_script(program, storage(&self.folder, &files), script);
        let ours = kept.pictures[&format!("{}.png", self.name)].pixels();
        let problem = allowance.problem(&self.name, ours, &self.screen)?;
        let kept = pictures::keep_both(&self.name, ours, &self.screen);
        Some(format!("{}: {problem}, see {}", self.name, kept.display()))
    }
}

/// Plays every script of a folder whose name begins so, and compares the screens. Returns how many
/// there were and the problems.
pub(crate) fn compare_all(
    program: Program,
    folder: &str,
    prefix: &str,
    allowance: impl Fn(&str) -> Allowance + Sync,
) -> (usize, Vec<String>) {
    let files = std::fs::read_dir(path(folder)).expect("the folder is there");
    let files = files.map(|entry| entry.expect("the folder can be read").file_name());
    let mut names: Vec<String> =
        files.filter_map(|file| Some(file.to_str()?.strip_suffix(".script")?.to_string())).collect();
    names.retain(|name| name.starts_with(prefix));
    names.sort();
    let problem = |name: &String| {
        let it = Reference::read(folder, name);
        it.problem(program, &it.script, allowance(&it.name))
    };
    // There are hundreds of screens.
    let problems = shared_out(&names, problem).into_iter().flatten().collect();
    (names.len(), problems)
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
    allowance: impl Fn(&str) -> Allowance + Sync,
) {
    let (scripts, problems) = compare_all(program, folder, prefix, allowance);
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert_eq!(scripts, count);
}
