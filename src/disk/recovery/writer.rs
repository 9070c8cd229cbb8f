//! The thread that writes the latest work of a session, at its own pace.

use super::super::reason;
use super::place::Place;
use crate::machine::Work;
use std::io;
use std::path::Path;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The shortest time from one writing to the next.
const PACE: Duration = Duration::from_millis(300);
/// What is wrong when there is no folder to write to.
const NO_FOLDER: &str = "the environment names no folder of the user's own";

/// What the session and its writing thread have in common.
#[derive(Default)]
pub(super) struct Shared {
    state: Mutex<State>,
    pub(super) changed: Condvar,
}

#[derive(Default)]
pub(super) struct State {
    /// What is still to be done; a later wish takes the place of an earlier one.
    pub(super) wish: Option<Wish>,
    /// Whether the thread is at work; it has the session's place then.
    pub(super) busy: bool,
    /// Whether wishes are fulfilled at once: somebody waits for it.
    pub(super) hurry: bool,
    pub(super) ended: bool,
    pub(super) own: Option<Place>,
    pub(super) problem: Option<String>,
    /// Whether a problem has been noted: the same one would come again and again.
    noted: bool,
}

/// What is to be done with the session's file.
pub(super) enum Wish {
    Keep(Work),
    Forget,
}

impl Shared {
    pub(super) fn state(&self) -> MutexGuard<'_, State> {
        // The state is whole between any two statements that change it.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until something has changed, or for a time.
    pub(super) fn wait<'s>(
        &self,
        state: MutexGuard<'s, State>,
        time: Option<Duration>,
    ) -> MutexGuard<'s, State> {
        match time {
            None => self.changed.wait(state).unwrap_or_else(PoisonError::into_inner),
            Some(time) => match self.changed.wait_timeout(state, time) {
                Ok((state, _)) => state,
                Err(poisoned) => poisoned.into_inner().0,
            },
        }
    }

    /// Waits for the next wish whose time has come, and takes the session's place for it; `None` when the
    /// session has ended.
    fn next_wish(&self, written: Option<Instant>) -> Option<(Wish, Option<Place>)> {
        let mut state = self.state();
        loop {
            let pause = written.map_or(Duration::ZERO, |written| PACE.saturating_sub(written.elapsed()));
            state = match state.wish.take() {
                None if state.ended => return None,
                None => self.wait(state, None),
                Some(wish @ Wish::Keep(_)) if !pause.is_zero() && !state.hurry && !state.ended => {
                    state.wish = Some(wish);
                    self.wait(state, Some(pause))
                }
                Some(wish) => {
                    state.busy = true;
                    return Some((wish, state.own.take()));
                }
            };
        }
    }
}

impl State {
    pub(super) fn note(&mut self, problem: String) {
        if !std::mem::replace(&mut self.noted, true) {
            self.problem = Some(problem);
        }
    }
}

/// The thread: fulfils wishes until the session has ended.
pub(super) fn write(shared: &Shared, folder: Option<&Path>) {
    let mut written = None;
    while let Some((wish, mut own)) = shared.next_wish(written) {
        let result = match wish {
            Wish::Keep(work) => {
                written = Some(Instant::now());
                keep(&mut own, folder, &work)
            }
            Wish::Forget => {
                if let Some(place) = own.take() {
                    place.remove();
                }
                Ok(())
            }
        };
        let mut state = shared.state();
        state.own = own;
        state.busy = false;
        if let Err(error) = result {
            let folder = folder.unwrap_or(Path::new("")).display();
            state.note(format!("{folder}: {}", reason(&error)));
        }
        drop(state);
        shared.changed.notify_all();
    }
}

/// Writes work into the session's place, which is made first if there is none yet.
fn keep(own: &mut Option<Place>, folder: Option<&Path>, work: &Work) -> io::Result<()> {
    if own.is_none() {
        let folder = folder.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, NO_FOLDER))?;
        *own = Some(Place::new(folder, &work.program)?);
    }
    let Some(place) = own else { return Ok(()) };
    place.write(work)
}
