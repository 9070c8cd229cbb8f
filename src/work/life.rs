//! The life of a configuration or a game: new or stored, edited, saved, left. Nothing is lost without a question.

use super::History;
use super::choose::choose_file;
use super::files::{Files, dos_files, has_json, json_name, read_document, with_json, with_twin};
use super::rescue::{self, keep};
use crate::design;
use crate::file::{Document, FileKind, Format, Method};
use crate::machine::{Asked, Asking, Key, Manner, Stop, Storage, Tick};
use crate::ui::words::{self, Phrase, Words};
use crate::ui::{Answer, Desk, MIDDLE, Picture, Question, Stay, Way};
use serde::Serialize;
use std::time::Duration;

/// The extension of files that are not in a DOS format.
const JSON: &str = "JSON";

/// What a program does after a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// Continue with the same configuration.
    Work,
    /// Start a new configuration.
    Restart,
    /// The end.
    End,
}

/// A program's state with work that is undone, saved and rescued. It is a [`Document`].
pub trait Work: Picture {
    /// The value that is edited, undone and saved.
    type Value: Clone + PartialEq;

    /// The question whether to save.
    const ASK_SAVE: Words = words::ASK_SAVE;
    /// The message when it has been saved.
    const SAVED: Option<Words> = None;

    /// The format of the stored documents.
    fn format(&self) -> Format;

    /// The program's method, for documents that name none.
    fn implied(&self) -> Option<Method> {
        None
    }

    /// The DOS format that it is saved in; `None`, JSON, where there is none, or none with room for it, its recipe
    /// aside.
    fn saved_as(&self) -> Option<Format> {
        Some(self.format()).filter(|format| format.size().is_some())
    }

    /// The extensions of its stored files; the first is that of a name without one.
    fn extensions(&self) -> Vec<&'static str> {
        vec![extension(Some(self.format()))]
    }

    /// The format of the stored file of a name.
    fn format_of(&self, _name: &str) -> Format {
        self.format()
    }

    /// The edited value with its history.
    fn history(&mut self) -> &mut History<Self::Value>;

    /// Whether there are unsaved changes.
    fn unsaved(&mut self) -> bool {
        self.history().unsaved()
    }

    /// Returns to the state before there is a configuration.
    fn reset(&mut self);

    /// Opens a document that needs no saving.
    ///
    /// # Errors
    /// The reason why the program cannot open it.
    fn open(&mut self, document: &Document) -> Result<(), Phrase>;

    /// The work as a document.
    ///
    /// # Errors
    /// The reason why it is not a document.
    fn document(&self) -> Result<Document, Phrase>;

    /// The model as `dump` writes it.
    fn model(&self) -> impl Serialize + 'static;

    /// Ends what cannot continue during a question about saving.
    fn settle(&mut self) {}

    /// Asks a question before the one for a new or a stored configuration; returns `true` if the answer is already a
    /// configuration.
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    fn ask_first(&mut self, _desk: &mut Desk<'_>) -> impl Future<Output = Asked<bool>> {
        async { Ok(false) }
    }

    /// Advances to the present time.
    fn look(&mut self, _desk: &Desk<'_>) {}

    /// How long after that time the next step or picture is due; `None` if none is.
    fn due(&self) -> Option<Duration> {
        None
    }

    /// Works until a command leaves the configuration.
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    fn work(&mut self, desk: &mut Desk<'_>) -> impl Future<Output = Asked<Next>>;

    /// The whole configuration as text, including what its files cannot hold. It is kept while it is unsaved.
    ///
    /// # Errors
    /// What cannot be written.
    fn unsaved_work(&self) -> Result<String, Phrase> {
        self.document()?.to_json().map_err(|error| Phrase::plain(&error))
    }

    /// Restores what [`Work::unsaved_work`] has written.
    ///
    /// # Errors
    /// What is wrong with it; the configuration is then unchanged.
    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        self.open(&Document::from_json(work).map_err(|error| Phrase::plain(&error))?)
    }

    /// Reads a stored configuration, including its twin or the JSON file beside it.
    ///
    /// # Errors
    /// What is wrong with the file.
    fn read(&mut self, storage: &mut dyn Storage, name: &str) -> Result<(), Phrase> {
        let (document, _) = with_twin(read_document(storage, name, self.format_of(name))?, storage, name);
        self.open(&with_json(document, storage, name))
    }

    /// The work as the content of a JSON file, including the method.
    ///
    /// # Errors
    /// What JSON cannot hold.
    fn json(&self, name: &str) -> Result<Vec<u8>, Phrase> {
        let document = design::naming(self.document()?, self.implied());
        document.encode(FileKind::Json).map_err(|error| words::in_file(name, &error))
    }
}

/// Runs a program that edits configurations, with the document named at the start, if any. Lost work is offered
/// first.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed and nothing is left to save.
pub async fn run<W: Work>(mut state: W, desk: &mut Desk<'_>, document: Option<Document>) -> Asked<()> {
    let ended = live(&mut state, desk, document).await;
    // The user has answered every question; a session that breaks off does not get here.
    rescue::forget(desk);
    ended
}

async fn live<W: Work>(state: &mut W, desk: &mut Desk<'_>, document: Option<Document>) -> Asked<()> {
    let begun = match document {
        Some(document) => offer_lost(state, desk).await? || desk.done(state.open(&document), Stay::UntilRead),
        None => false,
    };
    desk.machine.publish(state.model());
    let mut next = if begun { Next::Work } else { Next::Restart };
    loop {
        let step = match next {
            Next::Restart => start(state, desk).await.map(|()| Next::Work),
            Next::Work => state.work(desk).await,
            Next::End => return Ok(()),
        };
        next = match step {
            Ok(next) => next,
            // The command was cancelled; nothing has changed.
            Err(Stop::Cancelled) => Next::Work,
            Err(Stop::Closed) if may_close(state, desk).await => return Err(Stop::Closed),
            Err(Stop::Closed) => {
                desk.machine.stay_guest();
                Next::Work
            }
        };
    }
}

/// Offers lost work; returns whether some was restored. It is still unsaved.
async fn offer_lost<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<bool> {
    let taken = rescue::offer(state, desk).await?;
    if taken {
        state.history().mark_unsaved();
        keep(state, desk);
    }
    Ok(taken)
}

/// Keeps unsaved work, shows the program's picture and sleeps until something happens or is due.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed.
pub async fn event<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<Tick> {
    state.look(desk);
    keep(state, desk);
    desk.machine.publish(state.model());
    let unsaved = state.unsaved();
    desk.machine.set_unsaved(unsaved);
    let tick = match state.due() {
        Some(due) => desk.event_before(&*state, desk.machine.now() + due).await?,
        None => desk.event(&*state).await?,
    };
    state.look(desk);
    Ok(tick)
}

/// Carries out the keys common to all editors: undo, redo, save, and Esc, which returns to the menu that runs the
/// program. Returns whether the key was one of them.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed, or to go back.
pub async fn common_key<W: Work>(state: &mut W, desk: &mut Desk<'_>, key: Option<Key>) -> Asked<bool> {
    let moved = match key {
        Some(Key::Ctrl('Z')) => state.history().undo(),
        Some(Key::Ctrl('Y')) => state.history().redo(),
        Some(Key::Ctrl('S')) => {
            save(state, desk).await.unless_cancelled()?;
            true
        }
        Some(Key::Esc) if desk.machine.return_to_host() => return Err(Stop::Closed),
        _ => return Ok(false),
    };
    if !moved {
        let said = if key == Some(Key::Ctrl('Y')) { words::NO_REDO } else { words::NO_UNDO };
        desk.tell(said, Stay::Briefly);
    }
    Ok(true)
}

/// Asks for a new or a stored configuration until there is one.
async fn start<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<()> {
    state.reset();
    desk.machine.set_file(None);
    keep(state, desk);
    if offer_lost(state, desk).await? {
        return Ok(());
    }
    desk.machine.publish(state.model());
    if state.ask_first(desk).await? {
        return Ok(());
    }
    loop {
        desk.machine.publish(state.model());
        let question = Question::new(MIDDLE, words::ASK_CONFIGURATION, [words::NEW, words::STORED]);
        match desk.ask(&*state, &question).await.unless_cancelled()? {
            Some(Answer::Second) => {}
            None if desk.machine.return_to_host() => return Err(Stop::Closed),
            Some(Answer::First) | None => return Ok(()),
        }
        if load(state, desk, Stay::Briefly).await.unless_cancelled()? == Some(true) {
            return Ok(());
        }
    }
}

/// The extension of the files of a format.
pub(super) fn extension(format: Option<Format>) -> &'static str {
    format.filter(|format| format.size().is_some()).map_or(JSON, Format::extension)
}

/// Asks for a name and takes up what is stored under it; whether it was done.
pub(crate) async fn load<W: Work>(state: &mut W, desk: &mut Desk<'_>, stay: Stay) -> Asked<bool> {
    state.settle();
    let name = match desk.machine.manner() {
        Manner::Today => choose_file(&*state, desk).await?,
        Manner::Original => {
            desk.file_name(&*state, state.extensions().first().copied().unwrap_or(JSON), Way::Load).await?
        }
    };
    let read = state.read(desk.machine.storage(), &name);
    let done = desk.done(read, stay);
    if done {
        desk.machine.set_file(Some(name));
        state.history().mark_saved();
    }
    Ok(done)
}

/// Asks for a name and saves; returns whether that was done.
pub(crate) async fn save<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<bool> {
    state.settle();
    let extension = match state.saved_as() {
        Some(format) if format == state.format() => state.extensions().first().copied().unwrap_or(JSON),
        other => extension(other),
    };
    let name = match desk.machine.manner() {
        Manner::Today => desk.file_name_or(&*state, extension).await?,
        Manner::Original => desk.file_name(&*state, extension, Way::Save).await?,
    };
    let stored = match files(state, desk, &name).await? {
        Ok(files) => {
            let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
            if !desk.may_write(&*state, &names).await? {
                return Ok(false);
            }
            store(&files, desk.machine.storage())
        }
        Err(problem) => Err(problem),
    };
    let done = desk.done(stored, Stay::UntilRead);
    if done {
        desk.machine.set_file(Some(name));
        state.history().mark_saved();
        if let Some(saved) = W::SAVED {
            desk.tell(saved, Stay::Briefly);
        }
        keep(state, desk);
    }
    Ok(done)
}

/// The files of a configuration under a name. It says what the format cannot hold and offers a JSON file beside it. A
/// JSON file that already belongs to it is written without a question.
async fn files<W: Work>(state: &W, desk: &mut Desk<'_>, name: &str) -> Asked<Result<Files, Phrase>> {
    let json_file = |name: &str| Ok((name.to_owned(), state.json(name)?));
    let Some(format) = state.saved_as() else { return Ok(json_file(name).map(|file| vec![file])) };
    let document = match state.document() {
        Ok(document) => document,
        Err(problem) => return Ok(Err(problem)),
    };
    let json = json_name(name);
    let files = dos_files(&document, format, name);
    let lost = design::lost(&document, format, state.implied());
    let mut files = match files {
        Ok(files) => files,
        Err(problem) => return Ok(Err(problem)),
    };
    let belongs = has_json(desk.machine.files(), name, format, &files);
    if lost.is_empty() && !belongs {
        return Ok(Ok(files));
    }
    let wanted = match desk.machine.manner() {
        _ if belongs => true,
        Manner::Today => {
            let facts = words::not_held(format, &lost, &json);
            desk.ask_about(state, &facts, Question::yes_no(words::ASK_JSON)).await? == Answer::First
        }
        // The originals have no such question, and no shapes of joints.
        Manner::Original => lost.iter().any(|name| name == "joints"),
    };
    Ok(wanted.then(|| json_file(&json)).transpose().map(|json| {
        files.extend(json);
        files
    }))
}

fn store(files: &Files, storage: &mut dyn Storage) -> Result<(), Phrase> {
    for (name, content) in files {
        storage.write(name, content).map_err(|error| words::storage_problem(&error))?;
    }
    Ok(())
}

/// Asks whether to save, until that is answered and done. Esc cancels leaving.
pub(crate) async fn offer_to_save<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<()> {
    while desk.yes(&*state, W::ASK_SAVE).await? {
        // Esc in the question for the name returns to this one.
        if save(state, desk).await.unless_cancelled()? == Some(true) {
            break;
        }
    }
    Ok(())
}

/// The command Q: save, end, or a new configuration. Esc goes back to work; where no is an answer, it means no.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed.
pub async fn quit<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> Asked<Next> {
    if offer_to_save(state, desk).await.unless_cancelled()?.is_none() {
        return Ok(Next::Work);
    }
    if desk.yes(&*state, words::ASK_END).await.unless_cancelled()? == Some(true) {
        return Ok(Next::End);
    }
    if desk.yes(&*state, words::ASK_NEW).await.unless_cancelled()? == Some(true) {
        return Ok(Next::Restart);
    }
    Ok(Next::Work)
}

/// Whether the display may close: at once if everything is saved, else as the user decides. Pressing the close button
/// again keeps the question open, so that no slip loses work.
async fn may_close<W: Work>(state: &mut W, desk: &mut Desk<'_>) -> bool {
    state.settle();
    while state.unsaved() {
        match offer_to_save(state, desk).await {
            Ok(()) => return true,
            Err(Stop::Cancelled) => return false,
            Err(Stop::Closed) => {}
        }
    }
    true
}
