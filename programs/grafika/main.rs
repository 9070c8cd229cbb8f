//! `grafika`: the menu and the command line over all programs.

#[path = "../biliard.rs"]
mod biliard;
#[path = "../csango_k.rs"]
mod csango_k;
#[path = "../csav_gy.rs"]
mod csav_gy;
#[path = "../eg_kz_k.rs"]
mod eg_kz_k;
#[path = "../f_em_spl.rs"]
mod f_em_spl;
#[path = "../f_p_bets.rs"]
mod f_p_bets;
#[path = "../f_p_bezr.rs"]
mod f_p_bezr;
#[path = "../f_p_bspl.rs"]
mod f_p_bspl;
#[path = "../f_p_herm.rs"]
mod f_p_herm;
#[path = "../f_p_hspl.rs"]
mod f_p_hspl;
#[path = "../f_p_spln.rs"]
mod f_p_spln;
#[path = "../gb_2d_bt.rs"]
mod gb_2d_bt;
#[path = "../gb_2d_ch.rs"]
mod gb_2d_ch;
#[path = "../gb_2d_ip.rs"]
mod gb_2d_ip;
#[path = "../gb_3d_bt.rs"]
mod gb_3d_bt;
#[path = "../gb_3d_ip.rs"]
mod gb_3d_ip;
#[path = "../gb_p_2d.rs"]
mod gb_p_2d;
#[path = "../gr_kz_o.rs"]
mod gr_kz_o;
#[path = "../gr_kz_x.rs"]
mod gr_kz_x;
#[path = "../gyongy_k.rs"]
mod gyongy_k;
#[path = "../telepit.rs"]
mod telepit;
#[path = "../vjs.rs"]
mod vjs;
#[path = "../zm_betsp.rs"]
mod zm_betsp;
#[path = "../zm_bspl.rs"]
mod zm_bspl;
#[path = "../zm_hspl.rs"]
mod zm_hspl;
#[path = "../zm_spln.rs"]
mod zm_spln;
#[path = "../zy_betsp.rs"]
mod zy_betsp;
#[path = "../zy_bspl.rs"]
mod zy_bspl;
#[path = "../zy_hspl.rs"]
mod zy_hspl;
#[path = "../zy_spln.rs"]
mod zy_spln;

mod config;
mod convert;
mod curve;
mod menu;
mod reference;
mod render;
mod sample;
mod smooth;
mod solve;
mod source;
mod surface;
#[cfg(feature = "terminal")]
mod terminal_menu;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use grafika::launch::{Failure, Options, Program, RunOptions, exit, write_output};
use source::Source;
use std::ffi::OsString;
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;
use telepit::groups;

/// Every program, in the order of the book.
const PROGRAMS: &[Program] = &[
    gr_kz_x::PROGRAM,
    gr_kz_o::PROGRAM,
    eg_kz_k::PROGRAM,
    vjs::PROGRAM,
    gb_p_2d::PROGRAM,
    gb_2d_ch::PROGRAM,
    gb_2d_ip::PROGRAM,
    gb_2d_bt::PROGRAM,
    gb_3d_ip::PROGRAM,
    gb_3d_bt::PROGRAM,
    csav_gy::PROGRAM,
    f_p_herm::PROGRAM,
    f_p_spln::PROGRAM,
    f_em_spl::PROGRAM,
    f_p_bezr::PROGRAM,
    f_p_bspl::PROGRAM,
    f_p_bets::PROGRAM,
    f_p_hspl::PROGRAM,
    zm_spln::PROGRAM,
    zm_bspl::PROGRAM,
    zm_betsp::PROGRAM,
    zm_hspl::PROGRAM,
    zy_spln::PROGRAM,
    zy_bspl::PROGRAM,
    zy_betsp::PROGRAM,
    zy_hspl::PROGRAM,
    biliard::PROGRAM,
    gyongy_k::PROGRAM,
    csango_k::PROGRAM,
    telepit::PROGRAM,
];

/// The programs of János Füzi's book "Interaktív grafika"; without a command, the menu
#[derive(Parser)]
#[command(name = "grafika", version, args_conflicts_with_subcommands = true, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    options: RunOptions,
}

const EXAMPLES: &str = "Examples:
  grafika
  grafika gb_2d_ip A.IP2
  grafika --display terminal
  grafika render A.IP2 --method spline --closed -o a.svg";

const INFO_EXAMPLES: &str = "Examples:
  grafika info A.IP2
  cat a.json | grafika info - --from json";

const COMPLETIONS_EXAMPLES: &str = "Examples:
  grafika completions bash > grafika.bash
  grafika completions zsh gb_2d_ip > _gb_2d_ip";

#[derive(Subcommand)]
enum Command {
    /// List the programs
    #[command(after_help = "Examples:\n  grafika list")]
    List,
    /// Open a data file with its program; without a file, the menu
    #[command(after_help = "Examples:\n  grafika open A.ZMS\n  grafika open a.json --lang en")]
    Open(Options),
    /// Tell what a data file holds
    #[command(after_help = INFO_EXAMPLES)]
    Info(Source),
    /// Write points of a curve or a surface as CSV or JSON
    Sample(sample::Sample),
    /// Draw a curve or a surface as PNG, SVG or PDF; write a surface as OBJ, STL, PLY or STEP
    Render(render::Render),
    /// Convert a data file into another format, by the extensions
    Convert(convert::Convert),
    /// Smooth measured points by a B-spline and a Bézier curve, and tell the residuals
    Smooth(smooth::Smooth),
    /// Tell the moves that finish a puzzle, or count the ways
    Solve(solve::Solve),
    /// Install programs with their samples into a folder, on a page of text or as a plain command
    #[command(after_help = telepit::examples("grafika install"))]
    Install(telepit::Install),
    /// Write completions of the command line for a shell
    #[command(after_help = COMPLETIONS_EXAMPLES)]
    Completions(reference::Completions),
    /// Write the manual pages of grafika, its commands and the programs
    #[command(after_help = "Examples:\n  grafika man\n  grafika man share/man/man1")]
    Man(reference::Manuals),
    /// Show or change the settings of all programs
    Config(config::Config),
    /// Run a program by its name, as in "grafika gb_2d_ip A.IP2"
    #[command(external_subcommand)]
    Program(Vec<OsString>),
}

fn main() -> ExitCode {
    exit("grafika", run())
}

fn run() -> Result<(), Failure> {
    if let Some(words) = linked_name() {
        return run_program(words);
    }
    let cli = Cli::try_parse()?;
    match cli.command {
        None => show_menu(&cli.options),
        Some(Command::List) => write_output(None, list().as_bytes()),
        Some(Command::Open(options)) => open_with_program(&options),
        Some(Command::Info(source)) => {
            let opened = source.open()?;
            let lines = opened.document.describe().join("\n");
            write_output(None, format!("{lines}\n").as_bytes())
        }
        Some(Command::Sample(sample)) => sample.run(),
        Some(Command::Render(render)) => render.run(),
        Some(Command::Convert(convert)) => convert.run(),
        Some(Command::Smooth(smooth)) => smooth.run(),
        Some(Command::Solve(solve)) => solve.run(),
        Some(Command::Install(install)) => install.run(),
        Some(Command::Config(config)) => config.run(),
        Some(Command::Completions(completions)) => completions.run(),
        Some(Command::Man(manuals)) => manuals.run(),
        Some(Command::Program(words)) => run_program(words),
    }
}

/// The menu: in the terminal a page of text, elsewhere a picture.
fn show_menu(options: &RunOptions) -> Result<(), Failure> {
    let options = &options.preferred();
    #[cfg(feature = "terminal")]
    if grafika::launch::in_terminal(options) {
        return terminal_menu::run(options, &|program, options| match program.manual.name {
            "telepit" => telepit::Install::shown(options).run(),
            _ => program.start(&options.with_file(None)),
        });
    }
    menu::MENU.start(&options.with_file(None))
}

/// Starts the program that a data file belongs to.
fn open_with_program(options: &Options) -> Result<(), Failure> {
    let Some(file) = &options.file else { return show_menu(&options.run) };
    let format = grafika::launch::open(file)?.document.format();
    let belongs = |program: &&Program| {
        let first = format.programs().first();
        first.is_some_and(|name| name.eq_ignore_ascii_case(program.manual.name))
    };
    match PROGRAMS.iter().find(belongs) {
        Some(program) => program.start(options),
        None => Err(Failure::work(format!("{}: no program opens {}", file.display(), format.english()))),
    }
}

/// The command line, if this executable was started under the name of a program, as a link to it is.
fn linked_name() -> Option<Vec<OsString>> {
    let words: Vec<OsString> = std::env::args_os().collect();
    let name = Path::new(words.first()?).file_stem()?.to_string_lossy().to_lowercase();
    PROGRAMS.iter().any(|program| program.manual.name == name).then(|| {
        // The name, for messages, without the folders before it.
        [OsString::from(name)].into_iter().chain(words.into_iter().skip(1)).collect()
    })
}

/// The command line of a program.
fn command_of(program: &Program) -> clap::Command {
    match program.manual.name {
        "telepit" => telepit::described(),
        _ => program.command(),
    }
}

/// Every program with a line about it.
fn list() -> String {
    let mut text = String::new();
    for program in PROGRAMS {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:10} {}", program.manual.name, program.manual.about.1);
    }
    text
}

/// Starts the program that the first word names, in whatever case, with the rest as its command line.
fn run_program(words: Vec<OsString>) -> Result<(), Failure> {
    let name = words.first().map(|word| word.to_string_lossy().to_lowercase()).unwrap_or_default();
    match PROGRAMS.iter().find(|program| program.manual.name == name) {
        Some(program) if program.manual.name == "telepit" => telepit::start_from(words),
        Some(program) => program.start_from(words),
        None => {
            let programs: Vec<&str> = PROGRAMS.iter().map(|program| program.manual.name).collect();
            let known = Cli::command();
            let commands: Vec<&str> = known.get_subcommands().map(clap::Command::get_name).collect();
            let message = format!(
                "there is no command or program {name:?}; commands are {}, programs are {}",
                commands.join(", "),
                programs.join(", ")
            );
            Err(Cli::command().error(ErrorKind::InvalidSubcommand, message).into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use groups::GROUPS;

    #[test]
    fn every_program_is_in_one_group() {
        let grouped: Vec<&str> = GROUPS.iter().flat_map(|group| group.programs.iter().copied()).collect();
        for program in PROGRAMS {
            let name = program.manual.name;
            assert_eq!(grouped.iter().filter(|known| **known == name).count(), 1, "{name}");
            let group = GROUPS.iter().find(|group| group.programs.contains(&name)).expect("just counted");
            assert!(program.chapter.starts_with(group.chapter), "{name}: {}", program.chapter);
        }
        assert_eq!(grouped.len(), PROGRAMS.len());
    }
}
