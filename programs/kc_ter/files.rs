//! Files of single items and of spaces.

use super::edit;
use super::studio::Studio;
use super::{space, texts};
use crate::file::ec::{EcDocument, Item, Join, Scene, SpaceFile, values};
use crate::file::{Document, Format};
use crate::geometry::ec::EcError;
use crate::machine::{Asked, Manner};
use crate::ui::words::{self, Phrase};
use crate::ui::{Desk, Stay};
use crate::work::{self, Work};

/// Asks for a name and stores a document under it.
pub(super) async fn store(studio: &mut Studio, desk: &mut Desk<'_>, document: EcDocument) -> Asked<()> {
    let document = Document::from(document);
    let name = desk.file_name(&*studio, document.format().extension(), crate::ui::Way::Save).await?;
    if !desk.may_write(&*studio, &[&name]).await? {
        return Ok(());
    }
    let content = document.write(document.format()).map_err(|error| words::in_file(&name, &error));
    let stored = content.and_then(|content| {
        let written = desk.machine.storage().write(&name, &content);
        written.map_err(|error| words::storage_problem(&error))
    });
    match stored {
        Ok(()) => desk.tell(words::figure_saved(&desk.located(&name)), Stay::Briefly),
        Err(problem) => desk.tell(problem, Stay::UntilRead),
    }
    Ok(())
}

impl Studio {
    /// The scene of a document.
    pub(super) fn scene_of(&mut self, document: &EcDocument) -> Result<Scene, Phrase> {
        match document {
            EcDocument::Space(file) => {
                let curve = self.curve_over(file).map_err(|error| texts::problem(&error))?;
                Ok(curve.into())
            }
            EcDocument::Coefficients(coefficients) => {
                let items = self.bases.strips(coefficients, [None; 2]);
                let items = items.map_err(|error| texts::problem(&error))?;
                Ok(Scene { items, ..Scene::default() })
            }
            other => self.bases.scene(other).map_err(|error| Phrase::plain(&error)),
        }
    }

    /// A new curve over a space.
    pub(super) fn curve_over(&mut self, file: &SpaceFile) -> Result<Item, EcError> {
        let Item::Curve(mut curve) = edit::new_curve(0) else { return Ok(edit::new_curve(0)) };
        let interval = file.interval.clone().unwrap_or([0.0.into(), 1.0.into()]);
        self.bases.of(&file.space, values(&interval))?;
        curve.points = space::fitting_points(&curve.points, file.space.dimension());
        (curve.space, curve.interval, curve.name) = (file.space.clone(), interval, file.name.clone());
        Ok(Item::Curve(curve))
    }

    /// Asks for a stored file.
    pub(super) async fn ask_file(&mut self, desk: &mut Desk<'_>) -> Asked<String> {
        if desk.machine.manner() == Manner::Today {
            return work::choose_file(&*self, desk).await;
        }
        let name = desk.text(&*self, words::FILE_NAME, "").await?.trim().to_uppercase();
        Ok(if name.contains('.') { name } else { format!("{name}.KCJ") })
    }

    /// Reads a stored document.
    pub(super) fn read_file(&mut self, desk: &mut Desk<'_>, name: &str) -> Result<EcDocument, Phrase> {
        let format = Format::from_name(name).unwrap_or(Format::Kcj);
        match work::read_document(desk.machine.storage(), name, format)? {
            Document::Ec(document) => Ok(*document),
            _ => Err(texts::NO_DOCUMENT.into()),
        }
    }

    /// Opens a scene, or adds what a file holds to the one that is there.
    pub(super) async fn load(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let name = self.ask_file(desk).await?;
        let empty = self.history.now().items.is_empty();
        let read = self.read_file(desk, &name).and_then(|document| {
            if empty {
                let is_scene = matches!(document, EcDocument::Scene(_));
                self.open(&document.into())?;
                return Ok(is_scene);
            }
            let scene = self.scene_of(&document)?;
            let checked = self.bases.shapes(&EcDocument::Scene(scene.clone()));
            checked.map_err(|error| Phrase::plain(&error))?;
            let mut whole = self.history.now().clone();
            let first = whole.items.len();
            whole.items.extend(scene.items);
            whole.joins.extend(scene.joins.into_iter().map(|join| Join {
                a: (join.a.0 + first, join.a.1),
                b: (join.b.0 + first, join.b.1),
                ..join
            }));
            self.change(whole);
            Ok(false)
        });
        match read {
            Ok(true) => desk.machine.set_file(Some(name)),
            Ok(false) => {}
            Err(problem) => desk.tell(problem, Stay::UntilRead),
        }
        self.fit();
        Ok(())
    }

    /// Saves the selected item alone, or the scene where nothing is selected.
    pub(super) async fn save_item(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let document = match self.item().cloned() {
            None => return work::save(self, desk).await.map(|_| ()),
            Some(Item::Curve(curve)) => EcDocument::Curve(curve),
            Some(Item::Patch(patch)) => EcDocument::Patch(patch),
        };
        store(self, desk, document).await
    }
}
