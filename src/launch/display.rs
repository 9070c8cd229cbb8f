//! Chooses the display of a session and runs it until the end.

use super::outlet::Disk;
use super::{DisplayKind, Failure, RunOptions};
use crate::disk::{create, read_limited, read_stream, reason, text};
#[cfg(feature = "minifb")]
use crate::display::minifb;
#[cfg(feature = "window")]
use crate::display::window;
#[cfg(any(feature = "window", feature = "minifb"))]
use crate::display::{WindowError, window_possible};
use crate::machine::{Recorder, Script, Session, play};
use std::io::IsTerminal;
use std::path::Path;

/// Shows a session, or plays a script in it, until it has ended.
pub(super) fn show(
    mut session: Session,
    name: &str,
    options: &RunOptions,
    script: Option<&Script>,
) -> Result<(), Failure> {
    if let Some(path) = &options.record {
        session.record(recorder(path, name)?);
    }
    let shown = match (script, options.display) {
        (Some(script), _) => play(&mut session, script, &mut Disk)
            .map_err(|error| Failure::work(format!("{}: {error}", path_of(options.script.as_deref())))),
        (None, Some(DisplayKind::None)) => {
            Err(Failure::usage("--display none shows nothing and waits for ever; it needs --script FILE"))
        }
        (None, wish) => live(&mut session, name, wish, options),
    };
    let recorded = session.finish_recording();
    let saved = session.finish();
    shown?;
    saved.map_err(Failure::work)?;
    recorded.map_err(|error| Failure::work(format!("{}: {error}", path_of(options.record.as_deref()))))
}

/// Whether input and output are a terminal that a program can be shown in.
pub fn has_terminal() -> bool {
    cfg!(feature = "terminal") && std::io::stdin().is_terminal() && std::io::stdout().is_terminal()
}

/// Whether a session with these options is shown in a terminal and not recorded, so that pages of text can replace
/// pictures.
pub fn in_terminal(options: &RunOptions) -> bool {
    let wished = match options.display {
        Some(kind) => kind == DisplayKind::Terminal,
        None => window_kind().is_none(),
    };
    has_terminal() && wished && options.script.is_none() && options.record.is_none()
}

fn path_of(path: Option<&Path>) -> String {
    path.map(|path| path.display().to_string()).unwrap_or_default()
}

fn recorder(path: &Path, name: &str) -> Result<Recorder, Failure> {
    let refused = |error| Failure::work(format!("{}: {}", path.display(), reason(&error)));
    let file = create(path).map_err(refused)?;
    Ok(Recorder::new(Box::new(file), name))
}

/// The script of a path; `-` is standard input.
pub(super) fn read_script(path: &Path) -> Result<Script, Failure> {
    let shown = path.display();
    let read = if path == Path::new("-") { read_stream(std::io::stdin().lock()) } else { read_limited(path) };
    let text = read.and_then(text);
    let text = text.map_err(|error| Failure::usage(format!("{shown}: {}", reason(&error))))?;
    Script::parse(&text).map_err(|error| Failure::usage(format!("{shown}: {error}")))
}

/// The window that is opened where none is asked for, if there is a desktop and this build has one.
fn window_kind() -> Option<DisplayKind> {
    #[cfg(any(feature = "window", feature = "minifb"))]
    if window_possible() {
        return Some(if cfg!(feature = "window") { DisplayKind::Window } else { DisplayKind::Minifb });
    }
    None
}

/// Shows a session in a window, or in the terminal where none can be opened.
fn live(
    session: &mut Session,
    name: &str,
    wish: Option<DisplayKind>,
    options: &RunOptions,
) -> Result<(), Failure> {
    let kind = wish.or_else(window_kind);
    #[cfg(any(feature = "window", feature = "minifb"))]
    {
        #[cfg(windows)]
        if matches!(kind, Some(DisplayKind::Window | DisplayKind::Minifb)) {
            super::console::let_go();
        }
        let title = name.to_uppercase();
        let shown = match kind {
            #[cfg(feature = "window")]
            Some(DisplayKind::Window) => {
                let options = window::WindowOptions { title, scale: options.scale };
                Some(window::run(session, &options))
            }
            #[cfg(feature = "minifb")]
            Some(DisplayKind::Minifb) => {
                Some(minifb::run(session, &title, options.scale).map(|end| tell(end, name)))
            }
            _ => None,
        };
        match shown {
            // Fall back to the terminal unless a window was asked for.
            Some(Err(WindowError::Open(_))) if wish.is_none() && cfg!(feature = "terminal") => {}
            Some(shown) => return shown.map_err(Failure::work),
            None => {}
        }
    }
    #[cfg(feature = "terminal")]
    if wish.is_none() || kind == Some(DisplayKind::Terminal) {
        return Ok(crate::display::terminal::run(session)?);
    }
    let _ = (session, name, options);
    Err(Failure::work(match kind {
        Some(DisplayKind::Minifb) => {
            "this build has no display by minifb; one that is built with --features minifb has it"
        }
        _ => "this build has no such display; play a script with --script FILE",
    }))
}

/// Says what becomes of work that a closed window has left.
#[cfg(feature = "minifb")]
fn tell(end: minifb::End, name: &str) {
    if end == minifb::End::Closed {
        super::say(name, "the window was closed; what was not saved is kept, and the next start offers it");
    }
}
