//! Keeps unsaved work during a session, and offers it again after a session that broke off.

use super::life::Work;
use crate::design;
use crate::machine::{self, Asked, Asking, Verdict};
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, Picture, Question, Stay};

/// Keeps the work while it is unsaved. To be called before the program waits, when the work may have changed, as
/// [`event`](super::event) does. Without a [`Recovery`](crate::machine::Recovery), the work is not asked for. If it
/// cannot be kept, the reason is shown once.
pub fn keep<W: Work>(state: &mut W, desk: &mut Desk<'_>) {
    let touched = state.history().take_touched();
    if touched && desk.machine.wants_documents() {
        let document = state.document().map(|document| design::naming(document, state.implied()));
        desk.machine.tell_document(move || document.as_ref().ok()?.to_json().ok());
    }
    let (program, file) = (desk.program(), desk.machine.file().map(str::to_string));
    let Some(recovery) = desk.machine.recovery() else { return };
    if touched {
        match state.unsaved().then(|| state.unsaved_work()) {
            None => recovery.forget(),
            Some(Ok(content)) => recovery.keep(machine::Work { program: program.to_string(), file, content }),
            Some(Err(problem)) => return desk.tell(problem, Stay::UntilRead),
        }
    }
    if let Some(problem) = recovery.problem() {
        desk.tell(words::not_kept(&problem), Stay::UntilRead);
    }
}

/// Notes that nothing is left to keep: everything is saved, or the user gave it up.
pub(super) fn forget(desk: &mut Desk<'_>) {
    if let Some(recovery) = desk.machine.recovery() {
        recovery.forget();
    }
}

/// Offers the work of sessions that broke off, newest first, until one is restored (`true`) or none is left. During
/// the question the program shows the work.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed; the work will be offered at
/// the next start.
pub(super) async fn offer<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<bool> {
    let mut broken: Option<(String, Phrase)> = None;
    let mut more = 0;
    let name = desk.program();
    let taken = loop {
        let Some(lost) = desk.machine.recovery().and_then(|recovery| recovery.lost(name)) else { break None };
        let readable = lost.work.map_err(|problem| Phrase::plain(&problem)).and_then(|work| {
            state.take_up(&work.content)?;
            Ok(work)
        });
        let verdict = match &readable {
            Ok(work) => {
                let facts = words::broke_off(name, work.file.as_deref(), lost.age);
                let verdict = decide(state, desk, &facts).await;
                if verdict != Ok(Verdict::TakenUp) {
                    state.reset();
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
    match desk.ask_about(picture, facts, Question::yes_no(words::ASK_TAKE_UP)).await.unless_cancelled()? {
        Some(Answer::First) => return Ok(Verdict::TakenUp),
        None => return Ok(Verdict::Later),
        Some(Answer::Second) => {}
    }
    let answer = desk
        .ask_about(picture, &words::GIVING_UP.into(), Question::yes_no(words::ASK_GIVE_UP).careful())
        .await;
    Ok(if answer.unless_cancelled()? == Some(Answer::First) { Verdict::Deleted } else { Verdict::Later })
}
