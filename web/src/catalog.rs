//! What the start page shows: the programs by groups with a sentence each, and the samples, from the library's own tables.

use grafika::file::Format;
use grafika::machine::SAMPLES;
use grafika::programs::groups::MENU;
use grafika::ui::{Group, Program};
use serde::Serialize;

#[derive(Serialize)]
struct GroupEntry {
    id: &'static str,
    /// Hungarian and English, as everywhere here.
    name: [&'static str; 2],
    about: [&'static str; 2],
    programs: Vec<Entry>,
}

#[derive(Serialize)]
struct Entry {
    name: &'static str,
    about: [&'static str; 2],
    intro: [&'static str; 2],
    chapter: &'static str,
    /// Samples that it opens.
    samples: Vec<&'static str>,
    /// The extensions of the files that it opens.
    extensions: Vec<&'static str>,
}

fn entry(program: &'static Program) -> Entry {
    let manual = &program.manual;
    let fits = |name: &str| Format::from_name(name).is_some_and(|format| program.opens.contains(&format));
    Entry {
        name: manual.name,
        about: [manual.about.0, manual.about.1],
        intro: [manual.intro.0, manual.intro.1],
        chapter: program.chapter,
        samples: SAMPLES.iter().map(|(name, _)| *name).filter(|name| fits(name)).collect(),
        extensions: program.opens.iter().map(|format| format.extension()).collect(),
    }
}

/// The groups in the order of the menu, those without a program left out.
pub(crate) fn json() -> String {
    let groups = MENU.iter().map(|group: &&'static Group| GroupEntry {
        id: group.id,
        name: [group.name.0, group.name.1],
        about: [group.about.0, group.about.1],
        programs: group.programs().map(entry).collect(),
    });
    let groups: Vec<GroupEntry> = groups.filter(|group| !group.programs.is_empty()).collect();
    serde_json::to_string(&groups).unwrap_or_default()
}
