//! The whole command line with the programs as commands, for everything that describes it: shell completions and
//! manual pages come from the same table that is parsed.

use crate::Cli;
use crate::page::page;
use clap::{Args, CommandFactory};
use grafika::disk::reason;
use grafika::launch::{Failure, ShellName, meant, registration, speaking, write_file, write_output};
use grafika::machine::Language;
use grafika::programs::{ALL, by_name};
use grafika::ui::Program;
use std::path::PathBuf;

/// The command line of `grafika completions`.
#[derive(Args)]
pub(crate) struct Completions {
    /// The shell
    shell: ShellName,
    /// A program that has a command of its own [default: grafika with all programs]
    #[arg(value_name = "PROGRAM")]
    program: Option<String>,
}

/// The command line of `grafika man`.
#[derive(Args)]
pub(crate) struct Manuals {
    /// Folder for all pages; without it the page of grafika goes to standard output
    #[arg(value_name = "DIR")]
    folder: Option<PathBuf>,
}

/// The command line of `grafika` with every program as a command.
pub(crate) fn whole() -> clap::Command {
    let mut whole = unbuilt();
    whole.build();
    whole
}

/// The same before its parts know of each other.
pub(crate) fn unbuilt() -> clap::Command {
    speaking(Cli::command(), Language::English).subcommands(ALL.iter().map(Program::command))
}

impl Completions {
    /// Writes what a shell reads to standard output.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let name = match self.program.as_deref().map(str::to_lowercase) {
            Some(name) if name != "grafika" => {
                let alike = meant(&name, ALL.iter().map(|program| program.manual.name));
                let unknown =
                    || format!("there is no program {name:?}{alike}; grafika list tells which there are");
                by_name(&name).ok_or_else(|| Failure::usage(unknown()))?.manual.name
            }
            _ => "grafika",
        };
        write_output(&registration(self.shell, name)?)
    }
}

impl Manuals {
    /// Writes the pages.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let Some(folder) = &self.folder else {
            return write_output(&page(&whole(), None)?);
        };
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::work(format!("{}: {}", folder.display(), reason(&error))))?;
        for (name, text) in pages()? {
            write_file(&folder.join(name), &text)?;
        }
        Ok(())
    }
}

/// Every page by the name of its file: `grafika.1`, `grafika-render.1`, `gb_2d_ip.1`.
fn pages() -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let whole = whole();
    let mut pages = vec![("grafika.1".to_owned(), page(&whole, None)?)];
    add_pages(&whole, "grafika", &mut pages)?;
    Ok(pages)
}

/// The pages of the commands below a command.
fn add_pages(above: &clap::Command, path: &str, pages: &mut Vec<(String, Vec<u8>)>) -> Result<(), Failure> {
    for command in above.get_subcommands().filter(|command| command.get_name() != "help") {
        let name = command.get_name();
        let program = by_name(name);
        let (title, manual) = match program {
            Some(program) => (name.to_owned(), Some(program.manual)),
            None => (format!("{path}-{name}"), None),
        };
        let named = command.clone().display_name(title.clone());
        // A program is a command by itself, not of grafika.
        let named = if program.is_some() { named.bin_name(title.clone()) } else { named };
        pages.push((format!("{title}.1"), page(&named, manual)?));
        if program.is_none() {
            add_pages(command, &title, pages)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Command;
    use grafika::launch::completed;
    use grafika::ui::hungarian;

    /// Calls `see` for a command and all below it, with the words that lead there.
    fn walk(command: &Command, path: &str, see: &mut impl FnMut(&Command, &str)) {
        see(command, path);
        for below in command.get_subcommands().filter(|below| below.get_name() != "help") {
            walk(below, &format!("{path} {}", below.get_name()), see);
        }
    }

    #[test]
    fn every_command_and_option_is_told_with_an_example() {
        let mut seen = Vec::new();
        walk(&whole(), "grafika", &mut |command, path| {
            seen.push(path.to_owned());
            assert!(command.get_about().is_some_and(|about| !about.to_string().is_empty()), "{path}");
            for option in command.get_arguments() {
                let help = option.get_help().map(ToString::to_string).unwrap_or_default();
                assert!(!help.is_empty(), "{path} {}", option.get_id());
                assert!(!help.ends_with('.'), "{path} {}: {help}", option.get_id());
            }
            let examples = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let name = path.rsplit_once(' ').map_or(path, |(_, name)| name);
            assert!(examples.starts_with("Examples:\n  "), "{path}: {examples}");
            for line in examples.lines().skip(1) {
                assert!(line.contains(name), "{path}: {line}");
            }
        });
        for command in
            ["list", "info", "sample", "render", "convert", "smooth", "solve", "completions", "man"]
        {
            assert!(seen.contains(&format!("grafika {command}")), "{command}");
        }
        for program in ALL {
            let name = program.manual.name;
            assert!(seen.contains(&format!("grafika {name}")));
            let about = program.command().get_about().map(ToString::to_string);
            assert_eq!(about.as_deref(), Some(program.manual.about.1), "{name}");
        }
    }

    #[test]
    fn examples_are_command_lines_that_are_understood() {
        walk(&whole(), "grafika", &mut |command, path| {
            let examples = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            for line in examples.lines().skip(1) {
                // What comes before a pipe or after a redirection is the shell's.
                let line = line.rsplit_once("| ").map_or(line, |(_, line)| line);
                let line = line.split_once(" > ").map_or(line, |(line, _)| line).trim();
                // Every second piece stands in quotes.
                let pieces = line.split('"').enumerate().map(|(at, piece)| match at % 2 {
                    0 => piece.split_whitespace().collect(),
                    _ => vec![piece],
                });
                let words: Vec<&str> = pieces.flatten().collect();
                let whole_line = words.first() == Some(&"grafika");
                let matched = if whole_line {
                    whole().try_get_matches_from(&words)
                } else {
                    command.clone().no_binary_name(false).try_get_matches_from(&words)
                };
                assert!(matched.is_ok(), "{path}: {line}: {}", matched.unwrap_err());
            }
        });
    }

    /// How a line goes on.
    fn goes_on(line: &str) -> Vec<String> {
        let mut words: Vec<std::ffi::OsString> = line.split_whitespace().map(Into::into).collect();
        if line.ends_with(' ') {
            words.push("".into());
        }
        let at = words.len() - 1;
        let found =
            clap_complete::engine::complete(&mut completed(unbuilt()), words, at, None).unwrap_or_default();
        found.iter().map(|it| it.get_value().to_string_lossy().into_owned()).collect()
    }

    #[test]
    fn completions_cover_every_command_and_option() {
        walk(&whole(), "grafika", &mut |command, path| {
            let found = goes_on(&format!("{path} --"));
            let told = command.get_arguments().filter(|argument| !argument.is_hide_set());
            for long in told.filter_map(clap::Arg::get_long) {
                assert!(found.contains(&format!("--{long}")), "{path} --{long}: {found:?}");
            }
            if let Some((above, name)) = path.rsplit_once(' ') {
                assert!(goes_on(&format!("{above} ")).iter().any(|found| found == name), "{path}");
            }
        });
    }

    #[test]
    fn completions_know_values() {
        for (line, value) in [
            ("grafika info A.I", "A.IP2"),
            ("grafika gb_2d_ip a.i", "A.IP2"),
            ("grafika solve A.CS", "A.CSK"),
            ("grafika convert A.IP2 a.x --to j", "json"),
            ("grafika info - --from t", "tsv"),
            ("grafika render A.IP2 --to s", "svg"),
            ("grafika render A.IP2 --method sp", "spline"),
            ("grafika skin KIGYO.KOR --to j", "json"),
            ("grafika config pal", "palette"),
            ("grafika config palette am", "amber"),
            ("grafika config folder sr", "src/"),
            ("grafika completions ba", "bash"),
            ("grafika completions bash gb_2d_i", "gb_2d_ip"),
            ("grafika help gb_2d_i", "gb_2d_ip"),
            ("grafika knots path A.CS", "A.CSM"),
            ("grafika knots through B.CSM --by pair:o", "pair:outer"),
            ("grafika shape path KOR.ALP --parameter o", "omega"),
            ("grafika info a.csv --decimal po", "point"),
            ("grafika fit TEREP.XYZ --initial Cargo.t", "Cargo.toml"),
            ("grafika install --groups gb_", "gb_2d"),
        ] {
            assert!(goes_on(line).iter().any(|it| it == value), "{line}: {:?}", goes_on(line));
        }
        let found = goes_on("grafika biliard ");
        assert!(!found.contains(&"A.IP2".to_owned()), "no file that the program cannot open: {found:?}");
    }

    #[test]
    fn manual_pages_cover_every_command_and_option() {
        let pages = pages().unwrap();
        let text = |name: &str| {
            let (_, text) = pages.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("{name}"));
            String::from_utf8(text.clone()).unwrap().replace("\\-", "-")
        };
        walk(&whole(), "grafika", &mut |command, path| {
            let name = command.get_name();
            let is_program = by_name(name).is_some();
            let page = match (path, is_program) {
                ("grafika", _) => text("grafika.1"),
                (_, true) => text(&format!("{name}.1")),
                (_, false) => text(&format!("{}.1", path.replace(' ', "-"))),
            };
            for section in ["EXAMPLES", "\"EXIT STATUS\"", "ENVIRONMENT", "FILES"] {
                assert!(page.contains(&format!(".SH {section}\n")), "{path}: {section}");
            }
            let told = command.get_arguments().filter(|argument| !argument.is_hide_set());
            for long in told.filter_map(clap::Arg::get_long) {
                assert!(page.contains(&format!("--{long}")), "{path} --{long}");
            }
            if let Some(program) = by_name(name) {
                assert!(page.contains("KEYS") || program.manual.keys.is_empty(), "{path}");
                assert!(page.contains(program.manual.intro.1.get(..20).unwrap_or_default()), "{path}");
            }
        });
        let mut commands = 0;
        walk(&whole(), "grafika", &mut |_, _| commands += 1);
        assert_eq!(pages.len(), commands);
    }

    #[test]
    fn every_help_text_has_its_hungarian() {
        let mut missing = Vec::new();
        let mut look = |text: &str, place: String| {
            let lines = text.lines().filter(|line| !line.is_empty());
            missing.extend(
                lines.filter(|line| hungarian::help(line).is_none()).map(|line| format!("{place}: {line}")),
            );
        };
        walk(&whole(), "grafika", &mut |command, path| {
            // Programs describe themselves in both languages.
            let program = by_name(command.get_name()).is_some();
            for about in
                [command.get_about(), command.get_long_about()].into_iter().flatten().filter(|_| !program)
            {
                look(&about.to_string(), path.to_owned());
            }
            for option in command.get_arguments() {
                let helps = [option.get_help(), option.get_long_help()];
                helps
                    .into_iter()
                    .flatten()
                    .for_each(|help| look(&help.to_string(), format!("{path} {}", option.get_id())));
                for value in option.get_possible_values() {
                    value
                        .get_help()
                        .iter()
                        .for_each(|help| look(&help.to_string(), format!("{path} {}", value.get_name())));
                }
            }
        });
        assert!(missing.is_empty(), "{}", missing.join("\n"));
    }

    #[test]
    fn the_programs_are_no_second_command_line() {
        // The line that is parsed finds programs by name; the whole one has to mean the same.
        Cli::command().debug_assert();
        whole().debug_assert();
    }
}
