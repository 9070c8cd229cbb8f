//! `grafika`: the menu and the command line over all programs.

mod at;
mod config;
mod convert;
mod curve;
mod ec;
mod fit;
mod info;
mod knots;
mod measure;
mod models;
mod normals;
mod numbers;
mod offset;
mod page;
mod ph;
mod picture;
mod poly;
mod reference;
mod render;
mod sample;
mod series;
mod shape;
mod skin;
mod smooth;
mod solve;
mod source;
mod space;
mod steps;
mod surface;

use clap::error::ErrorKind;
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use grafika::file::Format;
use grafika::launch::{
    Failure, Install, Options, RunOptions, Uninstall, complete, exit, meant, ordered, speaking, spoken,
    write_output,
};
use grafika::programs::{self, ALL};
#[cfg(feature = "terminal")]
use grafika::{launch::DisplayKind, programs::menu::text::TextMenu, textmode::in_terminal};
use serde_json::{Value, json};
use std::ffi::OsString;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

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

const COMPLETIONS_EXAMPLES: &str = "Examples:
  grafika completions bash > grafika.bash
  grafika completions zsh gb_2d_ip > _gb_2d_ip";

#[derive(Subcommand)]
enum Command {
    /// List the programs
    #[command(after_help = "Examples:\n  grafika list\n  grafika list --json")]
    List(List),
    /// Open a data file with its program; without a file, the menu
    #[command(after_help = "Examples:\n  grafika open A.ZMS\n  grafika open a.json --lang en")]
    Open(Options),
    /// Tell what data files hold, or what an extended Chebyshev space is
    Info(info::Info),
    /// Write points of a curve or a surface as CSV or JSON
    Sample(sample::Sample),
    /// Draw a curve or a surface as PNG, SVG or PDF; write a surface as OBJ, STL, PLY or STEP
    Render(render::Render),
    /// Tell the exact length of a PH curve, how it bends, and how far it can be offset
    Measure(measure::Measure),
    /// Write the exact offset of a PH curve, whole or trimmed
    Offset(offset::OffsetArgs),
    /// Compute with polynomials and rational functions in exact fractions
    Poly(poly::Poly),
    /// Convert a data file into another format, by the extensions
    Convert(convert::Convert),
    /// Smooth measured points by a B-spline and a Bézier curve, and tell the residuals
    Smooth(smooth::Smooth),
    /// Tell the moves that finish a puzzle, or count the ways
    Solve(solve::Solve),
    /// Write the functions of an extended Chebyshev space as a table
    Basis(space::BasisTable),
    /// Tell how long the intervals of an extended Chebyshev space may be
    Critical(space::Critical),
    /// Raise the order of a curve or surface over extended Chebyshev spaces by a root
    Elevate(ec::Elevate),
    /// Divide a curve or surface over extended Chebyshev spaces
    Split(ec::Split),
    /// Make control points from the coefficients of an exact description
    Exact(ec::Exact),
    /// Let a net of neurons learn a cloud of points, and fit a surface to it
    Fit(fit::FitArgs),
    /// What becomes of a B-spline when knots move; knots that bring it through a point
    Knots(knots::Knots),
    /// What becomes of a curve when shape parameters change; those that bring it through points
    Shape(shape::Shape),
    /// The skin of circles: a smooth outline that touches each of them
    Skin(skin::SkinCommand),
    /// Install programs with their samples into a folder, on a page of text or as a plain command
    #[command(after_help = Install::examples("grafika install"))]
    Install(Install),
    /// Take back what was installed into a folder, as noted there; what has been changed since stays
    Uninstall(Uninstall),
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
    let linked = linked_name();
    let called = linked.as_ref().and_then(|words| programs::by_name(words.first()?.to_str()?));
    if let Some(answer) = complete(|| called.map_or_else(reference::unbuilt, |program| program.command())) {
        return answer;
    }
    if let Some(words) = linked {
        return run_program(words);
    }
    if let Some(help) = program_help() {
        return Err(help);
    }
    let command = speaking(Cli::command(), spoken());
    let matches = command.try_get_matches_from(ordered(std::env::args_os()))?;
    check_outputs(&matches)?;
    let cli = Cli::from_arg_matches(&matches)?;
    match cli.command {
        None => show_menu(&cli.options),
        Some(Command::List(list)) => list.run(),
        Some(Command::Open(options)) => open_with_program(&options),
        Some(Command::Info(info)) => info.run(),
        Some(Command::Sample(sample)) => sample.run(),
        Some(Command::Render(render)) => render.run(),
        Some(Command::Measure(measure)) => measure.run(),
        Some(Command::Offset(offset)) => offset.run(),
        Some(Command::Poly(poly)) => poly.run(),
        Some(Command::Convert(convert)) => convert.run(),
        Some(Command::Smooth(smooth)) => smooth.run(),
        Some(Command::Solve(solve)) => solve.run(),
        Some(Command::Basis(basis)) => basis.run(),
        Some(Command::Critical(critical)) => critical.run(),
        Some(Command::Elevate(elevate)) => elevate.run(),
        Some(Command::Split(split)) => split.run(),
        Some(Command::Exact(exact)) => exact.run(),
        Some(Command::Fit(fit)) => fit.run(),
        Some(Command::Knots(knots)) => knots.run(),
        Some(Command::Shape(shape)) => shape.run(),
        Some(Command::Skin(skin)) => skin.run(),
        Some(Command::Install(install)) => install.run(),
        Some(Command::Uninstall(uninstall)) => uninstall.run(),
        Some(Command::Config(config)) => config.run(),
        Some(Command::Completions(completions)) => completions.run(),
        Some(Command::Man(manuals)) => manuals.run(),
        Some(Command::Program(words)) => run_program(words),
    }
}

/// The options and arguments that name a file to be written.
const OUTPUTS: [&str; 3] = ["output", "nc", "residuals"];

/// Says of a folder that is named as a file what it is, before anything is done.
fn check_outputs(matches: &ArgMatches) -> Result<(), Failure> {
    let named = |id: &&str| matches.try_get_one::<PathBuf>(id).ok().flatten();
    match (OUTPUTS.iter().filter_map(named).find(|path| path.is_dir()), matches.subcommand()) {
        (Some(folder), _) => {
            Err(Failure::work(format!("{}: this is a folder, not a file", folder.display())))
        }
        (None, Some((_, below))) => check_outputs(below),
        (None, None) => Ok(()),
    }
}

/// The menu: in the terminal a page of text, elsewhere a picture.
fn show_menu(options: &RunOptions) -> Result<(), Failure> {
    options.check()?;
    let options = &options.preferred();
    #[cfg(feature = "terminal")]
    if grafika::launch::in_terminal(options) {
        return show_text_menu(options);
    }
    programs::menu::PROGRAM.visit(options.clone())
}

/// Shows the menu as a page of text, and the programs that are started from it, until it is left.
#[cfg(feature = "terminal")]
fn show_text_menu(options: &RunOptions) -> Result<(), Failure> {
    let mut menu = TextMenu::new(options.language());
    let mut options = options.clone();
    loop {
        in_terminal(&mut menu)?;
        if menu.language() != options.language() {
            options = options.preferring(menu.language());
        }
        let Some(program) = menu.take_started() else { return Ok(()) };
        let mut options = options.in_language(menu.language());
        options.display = Some(DisplayKind::Terminal);
        if let Err(failure) = program.visit(options) {
            menu.tell(failure.told(menu.language()));
        }
    }
}

/// Starts the program that a data file belongs to.
fn open_with_program(options: &Options) -> Result<(), Failure> {
    let Some(file) = &options.file else { return show_menu(&options.run) };
    let format = grafika::launch::open_as(file, None, &options.table.options())?.document.format();
    match programs::of_format(format) {
        Some(program) => program.start(options),
        None => Err(Failure::work(format!("{}: no program opens {}", file.display(), format.english()))),
    }
}

/// The command line, if this executable was started under the name of a program, as a link to it is.
fn linked_name() -> Option<Vec<OsString>> {
    let words: Vec<OsString> = std::env::args_os().collect();
    let name = Path::new(words.first()?).file_stem()?.to_string_lossy().to_lowercase();
    programs::by_name(&name).map(|_| {
        // The name, for messages, without the folders before it.
        [OsString::from(name)].into_iter().chain(words.into_iter().skip(1)).collect()
    })
}

/// The command line of `grafika list`.
#[derive(clap::Args)]
struct List {
    /// Tell names, groups, formats and what the programs are, as JSON
    #[arg(long)]
    json: bool,
}

impl List {
    /// Every program with a line about it.
    fn run(&self) -> Result<(), Failure> {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = match self.json {
            false => ALL.iter().try_for_each(|program| {
                writeln!(text, "{:10} {}", program.manual.name, program.manual.about.of(spoken()))
            }),
            true => {
                let programs = ALL.iter().map(|program| {
                    let manual = program.manual;
                    let opens = program.opens.iter().map(|format| format.extension());
                    json!({
                        "name": manual.name,
                        "about": { "en": manual.about.1, "hu": manual.about.0 },
                        "group": program.group.id,
                        "chapter": program.chapter,
                        "opens": opens.collect::<Vec<_>>(),
                    })
                });
                writeln!(text, "{:#}", Value::Array(programs.collect()))
            }
        };
        write_output(text.as_bytes())
    }
}

/// The help of a program, as `grafika help NAME` shows it, or that nothing has this name; that of a command is clap's.
fn program_help() -> Option<Failure> {
    // Which language is spoken stands behind, if it is said.
    let words: Vec<OsString> = ordered(std::env::args_os()).into_iter().skip(1).collect();
    let [help, name] = words.split(|word| word.to_string_lossy().starts_with("--lang")).next()? else {
        return None;
    };
    let name = name.to_str().filter(|_| help == "help")?;
    match programs::by_name(&name.to_lowercase()) {
        Some(program) => program.start_from([program.manual.name, "--help"].map(OsString::from)).err(),
        None => {
            Cli::command().find_subcommand(name).is_none().then(|| unknown(name)).filter(|_| name != "help")
        }
    }
}

/// Starts the program that the first word names, in whatever case, with the rest as its command line.
fn run_program(words: Vec<OsString>) -> Result<(), Failure> {
    let name = words.first().map(|word| word.to_string_lossy().into_owned()).unwrap_or_default();
    match programs::by_name(&name.to_lowercase()) {
        Some(program) => program.start_from(words),
        None => Err(unknown(&name)),
    }
}

/// Whether a word is the name of a file that programs open.
fn is_file(name: &str) -> bool {
    let extension = Path::new(name).extension().and_then(|extension| extension.to_str());
    extension.and_then(Format::from_extension).is_some()
}

/// That there is no such name, and which there are.
fn unknown(name: &str) -> Failure {
    if is_file(name) {
        let message =
            format!("there is no command or program {name:?}; a file is opened by: grafika open {name}");
        return Cli::command().error(ErrorKind::InvalidSubcommand, message).into();
    }
    let programs: Vec<&str> = ALL.iter().map(|program| program.manual.name).collect();
    let known = Cli::command();
    let commands: Vec<&str> = known.get_subcommands().map(clap::Command::get_name).collect();
    let message = format!(
        "there is no command or program {name:?}{}; commands are {}, programs are {}",
        meant(&name.to_lowercase(), commands.iter().chain(&programs).copied()),
        commands.join(", "),
        programs.join(", ")
    );
    Cli::command().error(ErrorKind::InvalidSubcommand, message).into()
}
