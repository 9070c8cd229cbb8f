//! The words of the installer.

use super::job::{Answer, Failed, Report};
use crate::machine::{Key, Language};
use crate::ui::Group;
use crate::ui::{KeyHelp, Phrase, Words};
use std::path::Path;

pub(crate) const TITLE: Words = Words(
    "TELEPIT - Füzi János: Interaktív grafika (1997)",
    "TELEPIT - János Füzi: Interaktív grafika (1997)",
);
pub(crate) const GROUPS: Words = Words("Csoportok", "Groups");
pub(crate) const WHERE: Words =
    Words("Hova kívánja a példákat telepíteni?", "Where should the programs be installed?");
pub(crate) const NONE_MARKED: Words = Words(
    "Nincs kijelölt csoport: a szóköz jelöl ki egyet, a * mindet.",
    "No group is selected: Space selects one, * selects all.",
);
pub(crate) const INSTALLING: Words = Words("Telepítés", "Installing");
pub(crate) const EXISTS: Words = Words("Már van ilyen fájl", "File exists");
pub(crate) const OVERWRITE: Words = Words("Felülírja?", "Overwrite it?");
pub(crate) const DONE: Words = Words("Kész", "Done");
pub(crate) const NOT_DONE: Words = Words("Nem sikerült", "Failed");
pub(crate) const CANCELLED: Words = Words("Megszakítva", "Cancelled");
pub(crate) const AS_BEFORE: Words =
    Words("Minden úgy van, ahogy előtte volt.", "Everything is as it was before.");
pub(crate) const GO_ON: Words = Words("tovább", "continue");

/// The keys of the list: their meanings, and their words on the last line.
pub(crate) const KEYS: [(Key, Words, Words); 5] = [
    (Key::Char(' '), Words("Szóköz", "Space"), Words("jelöl", "select")),
    (Key::Char('*'), Words("*", "*"), Words("mind", "all")),
    (Key::Enter, Words("Enter", "Enter"), Words("tovább", "continue")),
    (Key::F(2), Words("F2", "F2"), Words("English", "magyar")),
    (Key::Esc, Words("Esc", "Esc"), Words("kilép", "quit")),
];

/// The keys for the help page and the manual page.
pub(crate) const HELP: &[KeyHelp] = &[
    (Words("Fel Le", "Up Down"), Words("csoport választása", "choose a group")),
    (Words("Szóköz", "Space"), Words("kijelölés, illetve törlése", "select or deselect it")),
    (Words("*", "*"), Words("mindegyik kijelölése, illetve törlése", "select or deselect all")),
    (Words("Enter", "Enter"), Words("tovább", "continue")),
    (Words("F2", "F2"), Words("magyar vagy angol", "Hungarian or English")),
    (Words("Esc", "Esc"), Words("vissza; telepítés közben megszakítás", "back; while installing, cancel")),
];

/// The answers to whether a file is overwritten; both languages' letters are understood in either.
pub(crate) const ANSWERS: [(Answer, char, char, Words); 4] = [
    (Answer::Yes, 'I', 'Y', Words("igen", "yes")),
    (Answer::No, 'N', 'N', Words("nem", "no")),
    (Answer::All, 'M', 'A', Words("mindet", "all")),
    (Answer::None, 'E', 'O', Words("egyiket sem", "none")),
];

/// The answer of a letter.
pub(crate) fn answer_of(letter: char) -> Option<Answer> {
    let found = ANSWERS.iter().find(|(_, hungarian, english, _)| letter == *hungarian || letter == *english);
    found.map(|&(answer, ..)| answer)
}

/// The answers as a question offers them.
pub(crate) fn answers(language: Language) -> Vec<(String, String)> {
    let letter = |hungarian: char, english: char| match language {
        Language::Hungarian => hungarian,
        Language::English => english,
    };
    let offered = ANSWERS.iter().map(|&(_, hungarian, english, word)| {
        (letter(hungarian, english).to_string(), word.of(language).to_owned())
    });
    offered.collect()
}

/// The contents of a group: chapter, programs, samples, number of files and bytes.
pub(crate) fn summary(group: &Group, language: Language) -> Vec<String> {
    let samples: Vec<(&str, &[u8])> = group.samples().collect();
    let names: Vec<&str> = samples.iter().map(|(name, _)| *name).collect();
    let bytes: usize = samples.iter().map(|(_, content)| content.len()).sum();
    let programs: Vec<String> = group.programs().map(|it| it.manual.name.to_uppercase()).collect();
    let files = programs.len() + samples.len();
    let programs = programs.join(" ");
    let of = |words: Words| words.of(language);
    let mut lines = vec![group.about.of(language).to_owned(), String::new()];
    lines.push(format!("{}: {}", of(Words("Fejezet", "Chapter")), group.chapter));
    lines.push(format!("{}: {programs}", of(Words("Programok", "Programs"))));
    if !names.is_empty() {
        lines.push(format!("{}: {}", of(Words("Példák", "Samples")), names.join(" ")));
    }
    lines.push(String::new());
    lines.push(match language {
        Language::Hungarian => format!("{files} fájl, a példák {bytes} bájt", bytes = grouped(bytes)),
        Language::English => format!("{files} files, the samples {bytes} bytes", bytes = grouped(bytes)),
    });
    lines
}

/// A number with a space between thousands.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let before = digits.len();
    let with_gaps = digits.chars().enumerate().flat_map(|(at, digit)| {
        let gap = (at > 0 && (before - at).is_multiple_of(3)).then_some(' ');
        gap.into_iter().chain([digit])
    });
    with_gaps.collect()
}

/// What a job did, in lines.
pub(crate) fn report(report: &Report, root: &Path) -> Vec<Phrase> {
    let Report { written, same, kept, left_over } = report;
    let root = root.display();
    let mut lines =
        vec![Phrase::new(format!("{written} fájl ide: {root}"), format!("{written} files into {root}"))];
    if *same > 0 {
        lines.push(Phrase::new(format!("{same} már ott volt"), format!("{same} were already there")));
    }
    if *kept > 0 {
        lines.push(Phrase::new(format!("{kept} régi megmaradt"), format!("{kept} old ones were kept")));
    }
    for problem in left_over {
        lines.push(Phrase::new(format!("Nem törölhető: {problem}"), format!("Not removed: {problem}")));
    }
    lines
}

/// Why a job failed and what is left of it, in lines.
pub(crate) fn failure(failed: &Failed) -> Vec<Phrase> {
    let problem = format!("{}: {}", failed.path.display(), failed.problem);
    [vec![Phrase::plain(&problem)], undone(&failed.left)].concat()
}

/// What is left after everything was undone, in lines.
pub(crate) fn undone(left: &[String]) -> Vec<Phrase> {
    if left.is_empty() {
        return vec![AS_BEFORE.into()];
    }
    let line = |problem: &String| {
        Phrase::new(format!("Nem vonható vissza: {problem}"), format!("Not undone: {problem}"))
    };
    left.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_apart() {
        let texts = [0, 12, 999, 1000, 34048, 1234567].map(grouped);
        assert_eq!(texts, ["0", "12", "999", "1 000", "34 048", "1 234 567"]);
    }

    #[test]
    fn letters_of_both_languages_answer() {
        assert_eq!("IYNMAEO".chars().filter_map(answer_of).count(), 7);
        assert_eq!(answer_of('X'), None);
    }
}
