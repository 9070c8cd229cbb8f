//! The life of a configuration, the same in every program that edits one: new or stored, edited, saved, left. Nothing
//! is lost without a question.

use super::files::{Files, dos_files, has_json, json_name, read_document, with_json, with_twin};
use super::{History, rescue};
use crate::design;
use crate::file::{Document, FileKind, Format, Method};
use crate::machine::{Asked, Asking, Key, Manner, Stop, Storage};
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, MIDDLE, Picture, Question, Stay, Way};
use serde::Serialize;

/// What a program does after a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// The same configuration goes on.
    Work,
    /// A new configuration.
    Restart,
    /// The end.
    End,
}

/// A program's state with a configuration that is edited and kept in files.
pub trait Configuration: Picture {
    /// What is changed, undone and saved.
    type Value: Clone + PartialEq;

    /// The format of the stored configurations.
    fn format(&self) -> Format;

    /// The method that the program draws by where a document names none.
    fn implied(&self) -> Option<Method> {
        None
    }

    /// Whether a file of the format can hold the configuration apart from its recipe; otherwise it is saved as JSON.
    fn fits_format(&self) -> bool {
        true
    }

    /// The edited value with its past.
    fn history(&mut self) -> &mut History<Self::Value>;

    /// Goes back to the state before there is a configuration.
    fn reset(&mut self);

    /// Takes up a document that needs no saving.
    ///
    /// # Errors
    /// Why the program cannot work with it.
    fn open(&mut self, document: &Document) -> Result<(), Phrase>;

    /// The configuration as a document.
    fn document(&self) -> Document;

    /// The model as `dump` writes it.
    fn model(&self) -> impl Serialize + 'static;

    /// Asks what comes before the question for a new or a stored configuration; `true` if the answer already is a
    /// configuration.
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    fn ask_first(&mut self, _desk: &mut Desk<'_>) -> impl Future<Output = Asked<bool>> {
        async { Ok(false) }
    }

    /// Works until a command leads out of the configuration.
    ///
    /// # Errors
    /// [`Stop::Closed`] when the display is being closed.
    fn work(&mut self, desk: &mut Desk<'_>) -> impl Future<Output = Asked<Next>>;

    /// The whole configuration as text, including what its files cannot hold: what is kept while it is unsaved.
    ///
    /// # Errors
    /// What cannot be written.
    fn unsaved_work(&self) -> Result<String, Phrase> {
        self.document().to_json().map_err(|error| words::plain(&error))
    }

    /// Takes up what [`Configuration::unsaved_work`] has written.
    ///
    /// # Errors
    /// What is wrong with it; the configuration stays as it was.
    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        self.open(&Document::from_json(work).map_err(|error| words::plain(&error))?)
    }

    /// Reads a stored configuration, including its twin or the JSON file beside it.
    ///
    /// # Errors
    /// What is wrong with the file.
    fn read(&mut self, storage: &mut dyn Storage, name: &str) -> Result<(), Phrase> {
        let document = with_twin(read_document(storage, name, self.format())?, storage, name);
        self.open(&with_json(document, storage, name))
    }

    /// The configuration as a JSON file, which names the method too.
    ///
    /// # Errors
    /// What JSON cannot hold.
    fn json(&self, name: &str) -> Result<(String, Vec<u8>), Phrase> {
        let document = design::naming(self.document(), self.implied());
        let content = document.encode(FileKind::Json).map_err(|error| words::in_file(name, &error))?;
        Ok((name.to_owned(), content))
    }
}

/// Runs a program that edits configurations, with the document named at the start, if any. Lost work is offered
/// first.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed and nothing is left to save.
pub async fn run<C: Configuration>(
    mut state: C,
    desk: &mut Desk<'_>,
    document: Option<Document>,
) -> Asked<()> {
    let ended = live(&mut state, desk, document).await;
    // The user has answered everything; a session that breaks off does not get here.
    rescue::forget(desk);
    ended
}

async fn live<C: Configuration>(state: &mut C, desk: &mut Desk<'_>, document: Option<Document>) -> Asked<()> {
    let mut next = match document {
        Some(document) => begin_with(state, desk, &document).await?,
        None => Next::Restart,
    };
    loop {
        let step = match next {
            Next::Restart => start(state, desk).await.map(|()| Next::Work),
            Next::Work => state.work(desk).await,
            Next::End => return Ok(()),
        };
        next = match step {
            Ok(next) => next,
            // A cancelled command; nothing has changed.
            Err(Stop::Cancelled) => Next::Work,
            Err(Stop::Closed) if may_close(state, desk).await => return Err(Stop::Closed),
            Err(Stop::Closed) => {
                desk.machine.stay();
                Next::Work
            }
        };
    }
}

/// Takes up lost work, or else the document.
async fn begin_with<C: Configuration>(
    state: &mut C,
    desk: &mut Desk<'_>,
    document: &Document,
) -> Asked<Next> {
    if offer_lost(state, desk).await? {
        return Ok(Next::Work);
    }
    match state.open(document) {
        Ok(()) => Ok(Next::Work),
        Err(problem) => {
            desk.tell(problem, Stay::UntilRead);
            Ok(Next::Restart)
        }
    }
}

/// Offers lost work; whether some was taken up. It counts as unsaved.
async fn offer_lost<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> Asked<bool> {
    let taken = rescue::offer(state, desk, C::take_up, C::reset).await?;
    if taken {
        state.history().mark_unsaved();
        keep(state, desk);
    }
    Ok(taken)
}

/// Keeps the configuration while it is unsaved. To be called after changes, before the program waits; [`event`] does.
pub fn keep<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) {
    if state.history().take_touched() {
        let unsaved = state.history().unsaved();
        rescue::keep(desk, || unsaved.then(|| state.unsaved_work()));
    }
    rescue::tell_problem(desk);
}

/// Keeps unsaved work, shows the program's picture and sleeps until something happens.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed.
pub async fn event<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> Asked<crate::machine::Tick> {
    keep(state, desk);
    desk.machine.publish(state.model());
    desk.event(&*state).await
}

/// Carries out the keys that every editor shares: undo, redo, save, and Esc, which returns to the menu that runs the
/// program. Whether the key was one of them.
///
/// # Errors
/// [`Stop::Closed`] when the display is being closed, or to go back.
pub async fn common_key<C: Configuration>(
    state: &mut C,
    desk: &mut Desk<'_>,
    key: Option<Key>,
) -> Asked<bool> {
    let moved = match key {
        Some(Key::Ctrl('Z')) => state.history().undo(),
        Some(Key::Ctrl('Y')) => state.history().redo(),
        Some(Key::Ctrl('S')) => {
            save(state, desk).await.unless_cancelled()?;
            true
        }
        Some(Key::Esc) if desk.machine.leave() => return Err(Stop::Closed),
        _ => return Ok(false),
    };
    if !moved {
        desk.tell(words::NO_MORE, Stay::Briefly);
    }
    Ok(true)
}

/// Asks for a new or a stored configuration until there is one.
async fn start<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> Asked<()> {
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
            None if desk.machine.leave() => return Err(Stop::Closed),
            Some(Answer::First) | None => return Ok(()),
        }
        let name = desk.file_name(&*state, state.format().extension(), Way::Load).await;
        let Some(name) = name.unless_cancelled()? else { continue };
        match state.read(desk.machine.storage(), &name) {
            Ok(()) => {
                desk.machine.set_file(Some(name));
                return Ok(());
            }
            Err(problem) => desk.tell(problem, Stay::Briefly),
        }
    }
}

/// Asks for a name and saves; whether it was done.
async fn save<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> Asked<bool> {
    let extension = if state.fits_format() { state.format().extension() } else { "JSON" };
    let name = desk.file_name(&*state, extension, Way::Save).await?;
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
    match stored {
        Ok(()) => {
            desk.machine.set_file(Some(name));
            state.history().mark_saved();
            keep(state, desk);
            Ok(true)
        }
        Err(problem) => {
            desk.tell(problem, Stay::UntilRead);
            Ok(false)
        }
    }
}

/// The files that a configuration is stored in. What the format cannot hold is named, and a JSON file beside it is
/// offered; a JSON file that already belongs to it is written without a question.
async fn files<C: Configuration>(state: &C, desk: &mut Desk<'_>, name: &str) -> Asked<Result<Files, Phrase>> {
    if !state.fits_format() {
        return Ok(state.json(name).map(|file| vec![file]));
    }
    let (document, format, json) = (state.document(), state.format(), json_name(name));
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
            desk.ask_about(state, &facts, words::ASK_JSON).await? == Answer::First
        }
        // The originals have no such question, and no shapes of joints.
        Manner::Original => lost.iter().any(|name| name == "joints"),
    };
    Ok(wanted.then(|| state.json(&json)).transpose().map(|json| {
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

/// Asks whether to save until that is answered and done; Esc goes back to work.
async fn offer_to_save<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> Asked<()> {
    while desk.yes(&*state, words::ASK_SAVE).await? {
        // Esc in the questions for the name leads back to this one.
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
pub async fn quit<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> Asked<Next> {
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
/// again leaves the question standing, so that a slip loses no work.
async fn may_close<C: Configuration>(state: &mut C, desk: &mut Desk<'_>) -> bool {
    while state.history().unsaved() {
        match offer_to_save(state, desk).await {
            Ok(()) => return true,
            Err(Stop::Cancelled) => return false,
            Err(Stop::Closed) => {}
        }
    }
    true
}
