//! The model as `dump` writes it.

use super::edit;
use super::paint;
use super::space;
use super::studio::{Page, Studio};
use crate::design::ec::patch_space;
use crate::file::ec::{Interval, Item, Join};
use crate::geometry::ec::Space;
use crate::ui::Desk;
use serde::Serialize;

/// The model as `dump` writes it.
#[derive(Serialize)]
pub(super) struct Model {
    pub(super) page: Page,
    pub(super) selected: Option<Selected>,
    pub(super) view: crate::file::ec::SceneView,
    pub(super) settings: crate::file::ec::SceneSettings,
    pub(super) items: Vec<Dumped>,
    pub(super) joins: Vec<Join>,
    pub(super) unsaved: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) dialog: Option<space::Told>,
}

#[derive(Serialize)]
pub(super) struct Selected {
    pub(super) item: usize,
    pub(super) point: Option<Vec<usize>>,
}

#[derive(Serialize)]
pub(super) struct Dumped {
    #[serde(flatten)]
    pub(super) item: Item,
    pub(super) is_exact: bool,
    pub(super) hidden: bool,
    pub(super) length: Vec<f64>,
    pub(super) critical: Vec<Option<f64>>,
}

impl Studio {
    pub(super) fn told(&self) -> impl Serialize + 'static {
        self.model_with(None)
    }

    pub(super) fn model_with(&self, dialog: Option<space::Told>) -> Model {
        let scene = self.scene();
        let items = scene.items.iter().map(|item| {
            let spaces: Vec<(&Space, &Interval)> = match item {
                Item::Curve(curve) => vec![(&curve.space, &curve.interval)],
                Item::Patch(patch) => vec![patch_space(patch, 0), patch_space(patch, 1)],
            };
            let length = |interval: &Interval| interval[1].value() - interval[0].value();
            Dumped {
                item: item.clone(),
                is_exact: edit::is_exact(item),
                hidden: paint::is_hidden(item),
                length: spaces.iter().map(|(_, interval)| length(interval)).collect(),
                critical: spaces
                    .iter()
                    .map(|(space, _)| self.lengths.of(space).filter(|length| length.is_finite()))
                    .collect(),
            }
        });
        let selected = self.selected.map(|item| Selected {
            item,
            point: self.point.map(|index| match self.item() {
                Some(Item::Patch(_)) => index.to_vec(),
                _ => vec![index[0]],
            }),
        });
        Model {
            page: self.page,
            selected,
            view: self.eye.to_file(),
            settings: scene.settings.clone(),
            items: items.collect(),
            joins: scene.joins.clone(),
            unsaved: self.history.unsaved(),
            dialog,
        }
    }

    /// Publishes the model while a dialog is open.
    pub(super) fn publish(&self, desk: &mut Desk<'_>, dialog: space::Told) {
        desk.machine.publish(self.model_with(Some(dialog)));
    }
}
