//! A manual page: what clap knows of a command, and what users want to know besides.

use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, roman};
use grafika::launch::Failure;
use grafika::machine::POINTER_KEYS;
use grafika::ui::Manual;

/// The day of the pages: that on which what they tell was last looked through.
const DATE: &str = "2026-11-26";
/// The most signs of a line of input; one beyond ASCII counts as it is spelt there, `\[u00E1]`.
const WIDTH: usize = 80;

/// A manual page; that of a program with its keys.
pub(crate) fn page(command: &clap::Command, manual: Option<Manual>) -> Result<Vec<u8>, Failure> {
    let title = command.get_display_name().unwrap_or(command.get_name()).to_uppercase();
    let source = format!("grafika {}", env!("CARGO_PKG_VERSION"));
    let man = Man::new(command.clone()).title(title).date(DATE).source(source).manual("Interaktív grafika");
    let mut text = Vec::new();
    let mut render = || -> std::io::Result<()> {
        man.render_title(&mut text)?;
        man.render_name_section(&mut text)?;
        man.render_synopsis_section(&mut text)?;
        man.render_description_section(&mut text)?;
        if let Some(manual) = manual.filter(|manual| !manual.intro.1.is_empty()) {
            let mut intro = Roff::default();
            intro.control("PP", []);
            intro.text([roman(manual.intro.1)]);
            intro.to_writer(&mut text)?;
        }
        man.render_options_section(&mut text)?;
        if command.has_subcommands() {
            man.render_subcommands_section(&mut text)?;
        }
        let mut own = Roff::default();
        keys_section(manual, &mut own);
        terms(&mut own, "EXIT STATUS", &STATUS);
        terms(&mut own, "ENVIRONMENT", &ENVIRONMENT);
        terms(&mut own, "FILES", &FILES);
        examples_section(command, &mut own);
        own.to_writer(&mut text)
    };
    render().map_err(|error| Failure::work(format!("{}: {error}", command.get_name())))?;
    Ok(tidy(&String::from_utf8_lossy(&text)).into_bytes())
}

/// What the numbers mean that commands and programs end with.
const STATUS: [(&str, &str); 4] = [
    ("0", "The work is done."),
    ("1", "The work failed, or there is no solution; one line on standard error says why."),
    ("2", "The command line or a script is wrong."),
    ("128 + N", "Signal N ended the program."),
];

/// What the programs ask of their surroundings.
const ENVIRONMENT: [(&str, &str); 7] = [
    (
        "LC_ALL, LC_MESSAGES, LANG",
        "The language, unless the settings or --lang say it: Hungarian for hu, else English.",
    ),
    (
        "DISPLAY, WAYLAND_DISPLAY",
        "Where a window can be opened; without either, programs show themselves in the terminal.",
    ),
    ("TERM, COLORTERM", "What the terminal can show: its colours and its graphics."),
    (
        "LC_ALL, LC_CTYPE, LANG",
        "The encoding: where it is not UTF-8, a terminal without graphics gets ASCII.",
    ),
    ("NO_COLOR", "If set, a terminal without graphics gets no colours."),
    ("XDG_CONFIG_HOME", "Where the settings are, instead of ~/.config."),
    ("XDG_STATE_HOME", "Where unsaved work and best results are kept, instead of ~/.local/state."),
];

/// Where things are kept.
const FILES: [(&str, &str); 2] = [
    ("~/.config/grafika/config.toml", "The settings of all programs; see grafika config."),
    ("~/.local/state/grafika/", "Unsaved work of sessions that were cut off, and the best results of games."),
];

/// A section of terms with their explanations.
fn terms(page: &mut Roff, title: &str, terms: &[(&str, &str)]) {
    page.control("SH", [title]);
    for (term, told) in terms {
        page.control("TP", []);
        page.text([bold(*term)]);
        page.text([roman(*told)]);
    }
}

fn keys_section(manual: Option<Manual>, page: &mut Roff) {
    let Some(manual) = manual.filter(|manual| !manual.keys.is_empty()) else { return };
    page.control("SH", ["KEYS"]);
    for (key, what) in manual.keys {
        page.control("TP", []);
        page.text([bold(key.1)]);
        page.text([roman(what.1)]);
    }
    // Arrows are signs that not every typesetter has.
    let spelt = |keys: &str| keys.replace("↑ ↓ ← →", "arrows");
    let keys: Vec<(String, &str)> = POINTER_KEYS.iter().map(|key| (spelt(key.keys), key.english)).collect();
    let keys: Vec<(&str, &str)> = keys.iter().map(|(keys, what)| (keys.as_str(), *what)).collect();
    terms(page, "KEYS OF THE TERMINAL", &keys);
}

/// The examples of the help, line by line.
fn examples_section(command: &clap::Command, page: &mut Roff) {
    let Some(help) = command.get_after_help() else { return };
    page.control("SH", ["EXAMPLES"]);
    page.control("nf", []);
    for line in help.to_string().lines().skip(1) {
        page.text([roman(line.trim())]);
    }
    page.control("fi", []);
}

/// The input of the typesetter as its own checks want it: lines that are not too long, no blanks at their ends, no
/// break beside a gap.
fn tidy(page: &str) -> String {
    let mut tidied: Vec<String> = Vec::new();
    let (mut set, mut seen) = (true, Vec::new());
    for line in page.lines().map(str::trim_end) {
        match line {
            // Every part begins with these, which are needed once.
            _ if line.starts_with(".ie ") || line.starts_with(".el ") => {
                if !seen.contains(&line) {
                    seen.push(line);
                    tidied.push(line.to_owned());
                }
            }
            "" => {
                if tidied.last().is_some_and(|last| last == ".br") {
                    tidied.pop();
                }
                tidied.push(".sp".to_owned());
            }
            ".br" if tidied.last().is_some_and(|last| last == ".sp") => {}
            _ => {
                set = match line {
                    ".nf" => false,
                    ".fi" => true,
                    _ => set,
                };
                tidied.extend(if line.starts_with('.') { vec![line.to_owned()] } else { folded(line, set) });
            }
        }
    }
    tidied.push(String::new());
    tidied.join("\n")
}

/// A line of text in lines that are short enough; where lines are set as they are, their ends are hidden.
fn folded(line: &str, set: bool) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = line;
    while length(rest) > WIDTH {
        // Not after a backslash, which makes the blank a part of the word, nor where a sign of commands would come first.
        let breaks = rest.match_indices(' ').map(|(at, _)| at).filter(|at| {
            let (before, after) = rest.split_at(*at);
            !before.ends_with('\\') && !before.is_empty() && !after.trim_start().starts_with(['.', '\'', ' '])
        });
        let Some(at) = breaks.take_while(|at| length(&rest[..*at]) < WIDTH - 1).last() else { break };
        let (before, after) = rest.split_at(at);
        lines.push(if set { before.to_owned() } else { format!("{before} \\") });
        rest = after.trim_start();
    }
    lines.push(rest.to_owned());
    lines
}

fn length(text: &str) -> usize {
    text.chars().map(|sign| if sign.is_ascii() { 1 } else { r"\[u00E1]".len() }).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_folded_where_they_may_be() {
        let long = format!("{} .nothing {}", "word ".repeat(14).trim(), "word ".repeat(10).trim());
        for set in [true, false] {
            let lines = folded(&long, set);
            assert!(lines.len() == 2 && lines.iter().all(|line| line.len() <= WIDTH), "{lines:?}");
            assert!(!lines[1].starts_with('.'));
            let whole: String = lines.join(if set { " " } else { "" }).replace('\\', "");
            assert_eq!(whole, long);
        }
        let word = "x".repeat(100);
        assert_eq!(folded(&word, true), [word.as_str()]);
    }

    #[test]
    fn gaps_stand_alone() {
        assert_eq!(tidy("a \n.br\n\n.br\nb\n"), "a\n.sp\nb\n");
    }
}
