//! The Hungarian of what is said in English first: errors, answers and the help of the command line.
//!
//! The mathematics, the files and the command line know no language: their errors are types with one English sentence
//! each. Here is the one list of these sentences with their Hungarian. The screen ([`Phrase::plain`](super::Phrase::plain))
//! and the command line use it alike, and tests look for sentences that it lacks.
//!
//! In the lists of text, a line at the margin is English, the indented one below it Hungarian. `{}` is a value that is
//! carried over, `{*}` one that is put into Hungarian as well; in the Hungarian, `{2}` is the second value.

mod pattern;

use crate::file::Format;
use pattern::{Pattern, filled, may_fit};

/// The sentences: what is wrong, and what is answered.
const SENTENCES: [&str; 9] = [
    include_str!("geometry.txt"),
    include_str!("knots.txt"),
    include_str!("spaces.txt"),
    include_str!("files.txt"),
    include_str!("tables.txt"),
    include_str!("pictures.txt"),
    include_str!("puzzles.txt"),
    include_str!("system.txt"),
    include_str!("commands.txt"),
];
/// The help of the command line.
const HELP: [&str; 2] = [include_str!("help.txt"), include_str!("options.txt")];
/// Words and ends of sentences, which are looked for in the holes of sentences only.
const WORDS: [&str; 1] = [include_str!("words.txt")];
/// Places in a file, which stand before a colon.
const PLACES: [&str; 1] = [include_str!("places.txt")];

/// Sentences within sentences that are followed; messages of the programs have three.
const DEPTH: usize = 6;
/// Semicolons behind which another sentence may begin.
const SPLITS: usize = 3;

/// A text of the library in Hungarian; as it is where the list lacks it.
#[must_use]
pub fn told(english: &str) -> String {
    find(english).unwrap_or_else(|| english.to_owned())
}

/// A text of the library in Hungarian, if the list has it: a sentence, sentences with semicolons between them, or one
/// behind the name of a file or a place and a colon. Blanks before it stay.
#[must_use]
pub fn find(english: &str) -> Option<String> {
    let text = english.trim_start_matches(' ');
    let blanks = english.get(..english.len() - text.len()).unwrap_or_default();
    sentence(text, &SENTENCES, DEPTH).map(|found| format!("{blanks}{found}"))
}

/// A help text of the command line in Hungarian, if the list has it.
#[must_use]
pub fn help(english: &str) -> Option<String> {
    best(english, &[&HELP], DEPTH)
}

/// The help in Hungarian that the list has for exactly this text, such as a heading.
#[must_use]
pub fn heading(english: &str) -> Option<&'static str> {
    rows(&HELP).find(|(key, _)| *key == english).map(|(_, hungarian)| hungarian)
}

/// Whether any list has a text: as a sentence, as help, or as what stands in the holes of these.
#[must_use]
pub fn knows(english: &str) -> bool {
    let text = english.trim_start_matches(' ');
    part(text, &SENTENCES, DEPTH).is_some() || help(text).is_some() || best(text, &[&PLACES], DEPTH).is_some()
}

/// A word in Hungarian, if the list has it, such as what stands for a value in the help.
#[must_use]
pub fn word(english: &str) -> Option<&'static str> {
    let format = || Format::ALL.iter().find(|format| format.english() == english).map(|it| it.hungarian());
    rows(&WORDS).find(|(key, _)| *key == english).map(|(_, hungarian)| hungarian).or_else(format)
}

/// Some lists of rows.
type Lists = &'static [&'static str];

/// The rows of lists, the English before the Hungarian.
fn rows(lists: Lists) -> impl Iterator<Item = (&'static str, &'static str)> {
    lists.iter().flat_map(|list| {
        let mut lines = list.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
        std::iter::from_fn(move || Some((lines.next()?, lines.next().unwrap_or_default().trim_start())))
    })
}

/// One sentence, several that are joined, or one behind what it is about.
fn sentence(text: &str, lists: Lists, depth: usize) -> Option<String> {
    let depth = depth.checked_sub(1)?;
    best(text, &[lists], depth).or_else(|| behind(text, lists, depth)).or_else(|| joined(text, lists, depth))
}

/// Sentences with semicolons between them, each of which is known.
fn joined(text: &str, lists: Lists, depth: usize) -> Option<String> {
    text.match_indices("; ").take(SPLITS).find_map(|(at, sign)| {
        let first = sentence(text.get(..at)?, lists, depth)?;
        let rest = sentence(text.get(at + sign.len()..)?, lists, depth)?;
        Some(format!("{first}{sign}{rest}"))
    })
}

/// A sentence behind a colon; before it stands a file, or a place in one. It is looked for before sentences that are
/// joined, so that one with a semicolon of its own is not cut.
fn behind(text: &str, lists: Lists, depth: usize) -> Option<String> {
    let (about, rest) = text.split_once(": ").filter(|(about, _)| !about.contains("; "))?;
    let rest = sentence(rest, lists, depth).or_else(|| word(rest).map(str::to_owned))?;
    let about = best(about, &[&PLACES], depth).unwrap_or_else(|| about.to_owned());
    Some(format!("{about}: {rest}"))
}

/// The row that fits a text best, with what stands in its holes, in Hungarian where it is to be.
fn best(text: &str, lists: &[Lists], depth: usize) -> Option<String> {
    let mut found = None;
    let mut most = 0;
    let all = lists.iter().flat_map(|lists| rows(lists));
    for (english, hungarian) in all.filter(|(english, _)| may_fit(english, text)) {
        let pattern = Pattern::new(english);
        // A text without holes is meant before one with.
        let letters = 2 * pattern.letters() + usize::from(pattern.is_fixed());
        if letters > most
            && let Some(values) = pattern.values(text)
        {
            most = letters;
            found = Some((values, hungarian));
        }
    }
    let (values, hungarian) = found?;
    let value = |(translated, value): (bool, &str)| {
        let told = lists.first().filter(|_| translated).and_then(|lists| part(value, lists, depth));
        told.unwrap_or_else(|| value.to_owned())
    };
    let values: Vec<String> = values.into_iter().map(value).collect();
    Some(filled(hungarian, &values))
}

/// What stands in a hole: a word, a part of a sentence, or a sentence.
fn part(value: &str, lists: Lists, depth: usize) -> Option<String> {
    let depth = depth.checked_sub(1)?;
    let word = word(value).map(str::to_owned);
    word.or_else(|| best(value, &[lists, &WORDS], depth)).or_else(|| sentence(value, lists, depth))
}

#[cfg(test)]
mod tests {
    use super::*;
    use pattern::first_hole;

    /// The holes of a text.
    fn holes(text: &str) -> Vec<&str> {
        let mut rest = text;
        let mut holes = Vec::new();
        while let Some((_, hole, after)) = first_hole(rest) {
            holes.push(hole);
            rest = after;
        }
        holes
    }

    #[test]
    fn every_row_has_both_languages_and_the_same_values() {
        for list in [&SENTENCES[..], &HELP, &WORDS, &PLACES].concat() {
            let lines = list.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
            for (at, line) in lines.enumerate() {
                assert_eq!(line.starts_with(' '), at % 2 == 1, "{line}");
            }
        }
        let mut seen = Vec::new();
        for lists in [&SENTENCES[..], &HELP, &WORDS, &PLACES] {
            seen.clear();
            for (english, hungarian) in lists.iter().flat_map(|list| rows_of(list)) {
                assert!(!seen.contains(&english), "twice: {english}");
                seen.push(english);
                let (of_english, of_hungarian) = (holes(english), holes(hungarian));
                let count = of_english.len();
                assert!(of_english.iter().all(|hole| ["", "*"].contains(hole)), "{english}");
                let by_number = of_hungarian.iter().any(|hole| !hole.is_empty());
                if by_number {
                    // What is said twice in English may be said once, but nothing is lost.
                    for number in 1..=count {
                        let named = of_hungarian.contains(&number.to_string().as_str());
                        assert!(named || hungarian.ends_with('\u{a0}'), "{english}: {hungarian}");
                    }
                } else {
                    assert_eq!(of_hungarian.len(), count, "{english}: {hungarian}");
                }
            }
        }
    }

    fn rows_of(list: &'static str) -> Vec<(&'static str, &'static str)> {
        let lines: Vec<&str> =
            list.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).collect();
        lines.chunks(2).map(|pair| (pair[0], pair[1].trim_start())).collect()
    }

    #[test]
    fn sentences_are_found_behind_names_in_one_another_and_side_by_side() {
        assert_eq!(told("A.IP2: there is no such file"), "A.IP2: nincs ilyen fájl");
        assert_eq!(told("unknown to all lists"), "unknown to all lists");
        assert_eq!(
            told("a.csv: line 3, column 2: the cell is empty; a point needs every coordinate"),
            "a.csv: 3. sor, 2. oszlop: a cella üres; egy pontnak minden koordinátája kell"
        );
        assert_eq!(find("nothing of that; neither this"), None);
        // A sentence with a semicolon of its own is not cut in two behind a place.
        assert_eq!(
            told("a.csv: line 2: no column is called \"q\"; there are \"a\", \"b\""),
            "a.csv: 2. sor: nincs \"q\" nevű oszlop; ezek vannak: \"a\", \"b\""
        );
        assert_eq!(
            told("\"0-1\": number of arms: 1, must be 6; the solved wheel is 0"),
            "\"0-1\": ágak száma: 1; 6 kell; a kész kerék: 0"
        );
    }

    #[test]
    fn any_text_is_answered_at_once() {
        for text in ["", " ", ": ", "; ", "{}", "{*}", "é: é; é", "is  is  is "] {
            let _ = (find(text), help(text), word(text));
        }
        let long = "a: b; c, d {} ".repeat(20_000);
        assert_eq!(find(&long), None);
    }
}
