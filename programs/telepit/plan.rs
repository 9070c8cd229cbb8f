//! The plan of an installation: the files of the chosen groups with their content. No file is touched here.

use crate::machine::SAMPLES_PAGE;
use crate::ui::Group;
use std::fmt;
use std::path::{Path, PathBuf};

/// The kind of system that is installed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum System {
    /// Programs are started by links, or by scripts of `sh`.
    Unix,
    /// Programs are started by `.cmd` files.
    Windows,
}

impl System {
    /// The one that this is.
    pub(crate) const HERE: System = if cfg!(windows) { System::Windows } else { System::Unix };
}

/// How the files are laid out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Way {
    /// The executable is copied into the folder, so that everything there lasts by itself; else starters lead to where
    /// the executables are.
    pub(crate) copy: bool,
    /// Starters alone, and no folders of groups: for a folder in which shells look for programs.
    pub(crate) flat: bool,
}

/// What starts a program: its own executable, or `grafika` with the program's name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Starter {
    /// Where it is, or, of a copy, the way there from the starter's folder.
    pub(crate) executable: PathBuf,
    pub(crate) program: Option<&'static str>,
}

/// What is in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum What {
    Data(&'static [u8]),
    Starter(Starter),
    /// A copy of an executable.
    Copy(PathBuf),
}

/// A file to be installed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    /// The folder of its group; empty for the target folder itself.
    pub(crate) folder: &'static str,
    pub(crate) name: String,
    pub(crate) what: What,
}

/// Every file to be installed, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Plan {
    pub(crate) entries: Vec<Entry>,
}

/// A program that nothing can start.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct NoExecutable(pub(crate) &'static str);

impl fmt::Display for NoExecutable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.0;
        match name {
            "grafika" => f.write_str("grafika is not beside this program; what should be copied?"),
            _ => write!(f, "neither {name} nor grafika is beside this program; what should start {name}?"),
        }
    }
}

impl std::error::Error for NoExecutable {}

impl Plan {
    /// The plan for some groups: in a folder for each its programs, then its samples; above them the menu. `find`
    /// gives the executable of a name, if there is one.
    pub(crate) fn new(
        groups: &[&'static Group],
        find: &dyn Fn(&str) -> Option<PathBuf>,
        system: System,
        way: Way,
    ) -> Result<Plan, NoExecutable> {
        let menu = find("grafika");
        if way.copy {
            let executable = menu.ok_or(NoExecutable("grafika"))?;
            return Ok(Plan::copied(groups, executable, system, way.flat));
        }
        let entry = |folder, name: &'static str, starter| Entry {
            folder,
            name: system.starter_name(name),
            what: What::Starter(starter),
        };
        let mut entries = Vec::new();
        if let (Some(executable), false) = (&menu, groups.is_empty()) {
            entries.push(entry("", "grafika", Starter { executable: executable.clone(), program: None }));
        }
        for group in groups {
            let place = if way.flat { "" } else { group.folder };
            for name in group.programs().map(|program| program.manual.name) {
                let own = find(name).map(|executable| Starter { executable, program: None });
                let through_menu =
                    || menu.clone().map(|executable| Starter { executable, program: Some(name) });
                let starter = own.or_else(through_menu).ok_or(NoExecutable(name))?;
                entries.push(entry(place, name, starter));
            }
            entries.extend(data(group).filter(|_| !way.flat));
        }
        entries.extend(page(groups).into_iter().filter(|_| !way.flat));
        Ok(Plan { entries })
    }

    /// The same around a copy of `grafika`, which all starters lead to.
    fn copied(groups: &[&'static Group], executable: PathBuf, system: System, flat: bool) -> Plan {
        let name = system.executable_name();
        let copy = Entry { folder: "", name: name.to_owned(), what: What::Copy(executable) };
        let mut entries: Vec<Entry> = (!groups.is_empty()).then_some(copy).into_iter().collect();
        for group in groups {
            let (folder, above) = if flat { ("", "") } else { (group.folder, "..") };
            entries.extend(group.programs().map(|program| program.manual.name).map(|program| Entry {
                folder,
                name: system.starter_name(program),
                what: What::Starter(Starter {
                    executable: Path::new(above).join(name),
                    program: Some(program),
                }),
            }));
            entries.extend(data(group).filter(|_| !flat));
        }
        entries.extend(page(groups).into_iter().filter(|_| !flat));
        Plan { entries }
    }
}

/// The samples of a group.
fn data(group: &'static Group) -> impl Iterator<Item = Entry> {
    group.samples().map(|(name, content)| Entry {
        folder: group.folder,
        name: name.to_owned(),
        what: What::Data(content),
    })
}

/// The page about the samples, above all groups, if there are any samples.
fn page(groups: &[&'static Group]) -> Option<Entry> {
    let samples = groups.iter().any(|group| group.samples().next().is_some());
    samples.then(|| Entry { folder: "", name: "SAMPLES.md".to_owned(), what: What::Data(SAMPLES_PAGE) })
}

impl Entry {
    /// The path of the file, relative to the target folder.
    pub(crate) fn path(&self) -> PathBuf {
        Path::new(self.folder).join(&self.name)
    }
}

impl System {
    fn executable_name(self) -> &'static str {
        match self {
            System::Unix => "grafika",
            System::Windows => "grafika.exe",
        }
    }

    fn starter_name(self, program: &str) -> String {
        match self {
            System::Unix => program.to_owned(),
            System::Windows => format!("{program}.cmd"),
        }
    }
}

impl Starter {
    /// The script in a folder that starts the program, for systems or disks without links.
    pub(crate) fn script(&self, system: System, folder: &Path) -> Vec<u8> {
        match system {
            System::Unix => self.script_of_sh(),
            System::Windows => self.script_of_cmd(folder),
        }
    }

    fn script_of_sh(&self) -> Vec<u8> {
        let quoted = replaced(self.executable.as_os_str().as_encoded_bytes(), b'\'', b"'\\''");
        let here: &[u8] = if is_beside(&self.executable) { b"\"$(dirname -- \"$0\")\"/" } else { b"" };
        [b"#!/bin/sh\nexec ", here, b"'", &quoted[..], b"'", self.argument().as_bytes(), b" \"$@\"\n"]
            .concat()
    }

    /// The way to the executable from the script's own folder if there is one: what lies above both may be called anything,
    /// and cmd reads the script in the code page of its console. A name outside ASCII that remains is read in the code
    /// page of UTF-8, and the console has its own again at the end.
    fn script_of_cmd(&self, folder: &Path) -> Vec<u8> {
        let way = match is_beside(&self.executable) {
            true => Some(self.executable.clone()),
            false => pathdiff::diff_paths(&self.executable, folder).filter(|way| is_beside(way)),
        };
        let (here, way): (&[u8], _) = match &way {
            Some(way) => (b"%~dp0", replaced(way.as_os_str().as_encoded_bytes(), b'/', b"\\")),
            None => (b"", self.executable.as_os_str().as_encoded_bytes().to_vec()),
        };
        let way = replaced(&way, b'%', b"%%");
        let start = [b"\"", here, &way[..], b"\"", self.argument().as_bytes(), b" %*\r\n"].concat();
        match start.is_ascii() {
            true => [b"@", &start[..]].concat(),
            false => [UTF_8[0], &start, UTF_8[1]].concat(),
        }
    }

    /// The name of the program for `grafika`, behind a blank.
    fn argument(&self) -> String {
        self.program.map(|name| format!(" {name}")).unwrap_or_default()
    }
}

/// What stands in a script of cmd before and behind a line with letters outside ASCII. The line of `chcp` ends with the number
/// in any language.
const UTF_8: [&[u8]; 2] = [
    b"@echo off\r\nsetlocal\r\nfor /f \"tokens=2 delims=:.\" %%p in ('chcp') do set page=%%p\r\nchcp 65001 >nul\r\n",
    b"set status=%errorlevel%\r\nchcp %page% >nul\r\nexit /b %status%\r\n",
];

/// Whether a path leads from the script's own folder.
fn is_beside(path: &Path) -> bool {
    !path.is_absolute() && !path.as_os_str().as_encoded_bytes().starts_with(b"/")
}

/// Bytes with one of them replaced by others.
fn replaced(bytes: &[u8], from: u8, to: &[u8]) -> Vec<u8> {
    bytes
        .iter()
        .flat_map(|byte| if *byte == from { to } else { std::slice::from_ref(byte) })
        .copied()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::groups::GROUPS;

    fn all() -> Vec<&'static Group> {
        GROUPS.to_vec()
    }

    fn everything(name: &str) -> Option<PathBuf> {
        Some(Path::new("/bin").join(name))
    }

    #[test]
    fn every_program_and_sample_is_planned_once() {
        for system in [System::Unix, System::Windows] {
            let plan = Plan::new(&all(), &everything, system, Way::default()).unwrap();
            let mut paths: Vec<PathBuf> = plan.entries.iter().map(Entry::path).collect();
            let programs: usize = crate::programs::ALL.len();
            // A sample may belong to two groups, and is in the folders of both.
            let samples: usize = all().iter().map(|group| group.samples().count()).sum();
            assert!(samples >= crate::machine::SAMPLES.len());
            assert_eq!(paths.len(), 1 + programs + samples + 1);
            assert!(paths.contains(&PathBuf::from("SAMPLES.md")));
            paths.sort();
            paths.dedup();
            assert_eq!(paths.len(), plan.entries.len());
        }
    }

    #[test]
    fn programs_start_by_themselves_or_through_the_menu() {
        let group = [GROUPS[1]];
        let plan = Plan::new(&group, &everything, System::Unix, Way::default()).unwrap();
        let own = Starter { executable: "/bin/gb_p_2d".into(), program: None };
        assert_eq!(plan.entries[1].what, What::Starter(own));
        assert_eq!(plan.entries[1].path(), Path::new("GB_2D").join("gb_p_2d"));

        let only_menu = |name: &str| (name == "grafika").then(|| PathBuf::from("/opt/grafika"));
        let plan = Plan::new(&group, &only_menu, System::Windows, Way::default()).unwrap();
        let through = Starter { executable: "/opt/grafika".into(), program: Some("gb_p_2d") };
        assert_eq!(plan.entries[1].what, What::Starter(through));
        assert_eq!(plan.entries[1].name, "gb_p_2d.cmd");

        let nothing = |_: &str| None;
        assert_eq!(Plan::new(&group, &nothing, System::Unix, Way::default()), Err(NoExecutable("gb_p_2d")));
        assert_eq!(Plan::new(&[], &nothing, System::Unix, Way::default()), Ok(Plan { entries: Vec::new() }));
    }

    #[test]
    fn a_copy_is_all_that_starters_lead_to() {
        let way = Way { copy: true, flat: false };
        let plan = Plan::new(&all(), &everything, System::Unix, way).unwrap();
        assert_eq!(plan.entries[0].what, What::Copy("/bin/grafika".into()));
        let starters = plan.entries.iter().filter_map(|entry| match &entry.what {
            What::Starter(starter) => Some((entry, starter)),
            _ => None,
        });
        let mut count = 0;
        for (entry, starter) in starters {
            count += 1;
            let folder = entry.path();
            assert_eq!(
                folder.parent().map(|it| it.join(&starter.executable)),
                Some(Path::new(entry.folder).join("../grafika"))
            );
        }
        assert_eq!(count, crate::programs::ALL.len());
        let nothing = |name: &str| (name != "grafika").then(|| PathBuf::from("/bin/x"));
        assert_eq!(Plan::new(&all(), &nothing, System::Unix, way), Err(NoExecutable("grafika")));
    }

    #[test]
    fn a_flat_installation_has_programs_alone() {
        for copy in [false, true] {
            let plan = Plan::new(&all(), &everything, System::Windows, Way { copy, flat: true }).unwrap();
            assert_eq!(plan.entries.len(), 1 + crate::programs::ALL.len());
            assert!(plan.entries.iter().all(|entry| entry.folder.is_empty()));
        }
    }

    #[test]
    fn scripts_quote_any_path() {
        let starter = Starter { executable: "/it's 100%/grafika".into(), program: Some("vjs") };
        let text = |starter: &Starter, system| {
            String::from_utf8(starter.script(system, Path::new("/home/me/GB_2D"))).unwrap()
        };
        assert_eq!(text(&starter, System::Unix), "#!/bin/sh\nexec '/it'\\''s 100%/grafika' vjs \"$@\"\n");
        assert_eq!(text(&starter, System::Windows), "@\"%~dp0..\\..\\..\\it's 100%%\\grafika\" vjs %*\r\n");
        let beside = Starter { executable: "../grafika".into(), program: Some("vjs") };
        assert_eq!(
            text(&beside, System::Unix),
            "#!/bin/sh\nexec \"$(dirname -- \"$0\")\"/'../grafika' vjs \"$@\"\n"
        );
        assert_eq!(text(&beside, System::Windows), "@\"%~dp0..\\grafika\" vjs %*\r\n");
    }

    #[test]
    fn a_script_of_cmd_is_ascii_or_says_that_it_is_utf_8() {
        let text = |folder: &str, executable: &str| {
            let starter = Starter { executable: executable.into(), program: None };
            String::from_utf8(starter.script(System::Windows, Path::new(folder))).unwrap()
        };
        // The names above both are not in the script.
        assert_eq!(text("/Jánoš/grafika", "/Jánoš/bin/grafika"), "@\"%~dp0..\\bin\\grafika\" %*\r\n");
        let other = text("/Jánoš/grafika", "/Jánoš/Letöltések/grafika");
        assert!(other.contains("\r\nchcp 65001 >nul\r\n\"%~dp0..\\Letöltések\\grafika\" %*\r\n"), "{other}");
        assert!(other.starts_with("@echo off") && other.ends_with("exit /b %status%\r\n"), "{other}");
        assert!(other.split("\r\n").all(|line| !line.contains('\n')));
    }
}
