//! Unsaved work is kept after every change, and offered again after a session that broke off.
//!
//! The program decides how its work is written as text and read again.

use crate::machine::{Asked, Asking, Verdict, Work};
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, Picture, Stay};

/// Keeps the unsaved work, or notes that there is none. `work` is not called on a machine without a recovery. Errors are
/// reported once.
pub fn keep(desk: &mut Desk<'_>, work: impl FnOnce() -> Option<Result<String, Phrase>>) {
    let (program, file) = (desk.program().to_string(), desk.machine.file().map(str::to_string));
    let Some(recovery) = desk.machine.recovery() else { return };
    match work() {
        Some(Ok(content)) => recovery.keep(Work { program, file, content }),
        Some(Err(problem)) => desk.tell(problem, Stay::UntilRead),
        None => recovery.forget(),
    }
}

/// Reports that work could not be kept.
pub fn tell_problem(desk: &mut Desk<'_>) {
    if let Some(problem) = desk.machine.recovery().and_then(|recovery| recovery.problem()) {
        desk.tell(words::not_kept(&problem), Stay::UntilRead);
    }
}

/// Notes that nothing is left to keep: everything is saved or given up.
pub fn forget(desk: &mut Desk<'_>) {
    if let Some(recovery) = desk.machine.recovery() {
        recovery.forget();
    }
}

/// Offers the work of sessions that broke off, newest first, until one is taken up (`true`) or none is left. `take_up`
/// loads the work, so that the program shows it under the question; `put_down` goes back to the start.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed; the work will be offered at the next start.
pub async fn offer<P: Picture>(
    program: &mut P,
    desk: &mut Desk<'_>,
    take_up: fn(&mut P, &str) -> Result<(), Phrase>,
    put_down: fn(&mut P),
) -> Asked<bool> {
    let mut broken: Option<(String, Phrase)> = None;
    let mut more = 0;
    let name = desk.program();
    let taken = loop {
        let Some(lost) = desk.machine.recovery().and_then(|recovery| recovery.lost(name)) else { break None };
        let readable = lost.work.map_err(|problem| Phrase::plain(&problem)).and_then(|work| {
            take_up(program, &work.content)?;
            Ok(work)
        });
        let verdict = match &readable {
            Ok(work) => {
                let facts = words::broke_off(name, work.file.as_deref(), lost.age);
                let verdict = decide(program, desk, &facts).await;
                if verdict != Ok(Verdict::TakenUp) {
                    put_down(program);
                }
                verdict?
            }
            Err(_) => Verdict::Broken,
        };
        if let Some(recovery) = desk.machine.recovery() {
            recovery.settle(verdict);
        }
        match readable {
            Ok(work) if verdict == Verdict::TakenUp => break Some(work),
            Ok(_) => {}
            Err(_) if broken.is_some() => more += 1,
            Err(problem) => broken = Some((lost.name, problem)),
        }
    };
    if let Some((name, problem)) = broken {
        desk.tell(words::broken_work(&name, &problem, more), Stay::UntilRead);
    }
    let found = taken.is_some();
    if let Some(work) = taken {
        desk.machine.set_file(work.file);
    }
    Ok(found)
}

/// Asks what to do with lost work. Only a second yes deletes it.
async fn decide(picture: &impl Picture, desk: &mut Desk<'_>, facts: &Phrase) -> Asked<Verdict> {
    match desk.ask_about(picture, facts, words::ASK_TAKE_UP).await.unless_cancelled()? {
        Some(Answer::First) => return Ok(Verdict::TakenUp),
        None => return Ok(Verdict::Later),
        Some(Answer::Second) => {}
    }
    let answer = desk.ask_about(picture, &words::GIVING_UP.into(), words::ASK_GIVE_UP).await;
    Ok(if answer.unless_cancelled()? == Some(Answer::First) { Verdict::Deleted } else { Verdict::Later })
}
