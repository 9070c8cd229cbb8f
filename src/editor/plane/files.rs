//! Opening, saving and leaving: nothing is lost without having been asked.

use super::{Drawing, Editor, Next, Stage};
use crate::file::{Document, Format, PlanePoints};
use crate::machine::{Quit, StorageProblem};
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, MIDDLE, Question, Stay, Way};

/// The format that the editor reads and writes.
const FORMAT: Format = Format::Ip2;

/// Whether the editor can work with a document; else why not.
///
/// # Errors
/// The reason, in both languages.
pub fn check(document: &Document) -> Result<(), Phrase> {
    drawing_of(document).map(|_| ())
}

fn drawing_of(document: &Document) -> Result<Drawing, Phrase> {
    let Document::PlanePoints(PlanePoints { points, .. }) = document else {
        return Err(words::WRONG_CONTENT.into());
    };
    Ok(Drawing::new(points.clone()).ok_or(words::OUTSIDE_FIELD)?)
}

impl Editor {
    /// Takes up the points of a document.
    pub(super) fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        self.load(drawing_of(document)?);
        Ok(())
    }

    /// Asks for a new or a stored configuration until there is one.
    pub(super) async fn start(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        self.load(Drawing::default());
        loop {
            desk.machine.publish(self.model());
            let question = Question::new(MIDDLE, words::ASK_CONFIGURATION, [words::NEW, words::STORED]);
            let answer = desk.ask(self, &question).await?;
            if answer != Some(Answer::Second) {
                break;
            }
            let name = desk.file_name(self, FORMAT.extension(), Way::Load);
            let Some(name) = name.await? else { continue };
            match self.read(desk, &name) {
                Ok(()) => break,
                Err(problem) => desk.tell(problem, Stay::Briefly),
            }
        }
        Ok(())
    }

    fn read(&mut self, desk: &mut Desk<'_>, name: &str) -> Result<(), Phrase> {
        let content = desk.machine.storage().read(name).map_err(|error| match error.problem {
            StorageProblem::NotFound => words::NO_SUCH_FILE.into(),
            _ => words::storage_problem(&error),
        })?;
        let document = Document::read(FORMAT, &content).map_err(|error| words::in_file(name, &error))?;
        self.open(&document)
    }

    /// Asks for a name and saves; whether it was done.
    pub(super) async fn save(&mut self, desk: &mut Desk<'_>) -> Result<bool, Quit> {
        let name = desk.file_name(self, FORMAT.extension(), Way::Save).await?;
        let Some(name) = name else { return Ok(false) };
        if desk.machine.storage().find(&name).is_some() {
            let question = words::exists(&name);
            if !desk.yes(self, question).await? {
                return Ok(false);
            }
        }
        let document = Document::PlanePoints(PlanePoints::new(self.history.now().points().to_vec()));
        let written = document.write(FORMAT).map_err(|error| words::in_file(&name, &error));
        let stored = written.and_then(|content| {
            desk.machine.storage().write(&name, &content).map_err(|error| words::storage_problem(&error))
        });
        match stored {
            Ok(()) => {
                self.history.mark_saved();
                Ok(true)
            }
            Err(problem) => {
                desk.tell(problem, Stay::UntilRead);
                Ok(false)
            }
        }
    }

    /// Asks whether to save until it is answered and done; `false` is Esc: nothing shall be left.
    async fn offer_to_save(&mut self, desk: &mut Desk<'_>) -> Result<bool, Quit> {
        loop {
            let question = Question::yes_no(words::ASK_SAVE);
            match desk.ask(self, &question).await? {
                None => return Ok(false),
                Some(Answer::Second) => return Ok(true),
                Some(Answer::First) if self.save(desk).await? => return Ok(true),
                Some(Answer::First) => {}
            }
        }
    }

    /// The command Q: save, end, or a new configuration.
    pub(super) async fn quit(&mut self, desk: &mut Desk<'_>) -> Result<Next, Quit> {
        if !self.offer_to_save(desk).await? {
            return Ok(Next::Work);
        }
        if desk.yes(self, words::ASK_END).await? {
            return Ok(Next::End);
        }
        if desk.yes(self, words::ASK_NEW).await? {
            return Ok(Next::Restart);
        }
        Ok(Next::Work)
    }

    /// Whether the display may close: at once if everything is saved, else as the user decides. The
    /// close button pressed again leaves the question standing, so that no slip loses work.
    pub(super) async fn may_close(&mut self, desk: &mut Desk<'_>) -> bool {
        self.held = None;
        self.stage = Stage::Working;
        while self.history.unsaved() {
            match self.offer_to_save(desk).await {
                Ok(leave) => return leave,
                Err(Quit) => {}
            }
        }
        true
    }
}
