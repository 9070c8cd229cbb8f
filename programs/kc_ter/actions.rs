//! Actions on an item: elevate, divide, join, interpolate, describe.

use super::asking::{ask_interval, ask_parts};
use super::edit;
use super::rows::Action;
use super::studio::Studio;
use super::{coefficients, space, texts};
use crate::design::ec::{coefficients as coefficients_of, equal_parts, fewest_parts, patch_space};
use crate::file::ec::{Coefficients, Item, Join, values};
use crate::geometry::ec::{EcError, Real};
use crate::machine::Asked;
use crate::ui::words::Phrase;
use crate::ui::{Answer, Desk, Question, Stay, TOP};

/// Colours of the parts of a divided curve.
pub(super) const PART_COLORS: [u8; 4] = [15, 14, 11, 10];

impl Studio {
    /// An action of the page.
    pub(super) async fn act(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<()> {
        match action {
            Action::Centre => {
                if let Some(bounds) = self.selected.and_then(|at| self.shapes.bounds(Some(at))) {
                    let middle = std::array::from_fn(|d| bounds.min[d] / 2.0 + bounds.max[d] / 2.0);
                    self.eye = self.eye.centred(middle);
                } else {
                    desk.tell(texts::NOTHING_SELECTED, Stay::Briefly);
                }
            }
            Action::Load => self.load(desk).await?,
            Action::Save => self.save_item(desk).await?,
            Action::Items if self.scene().items.is_empty() => desk.tell(texts::EMPTY, Stay::Briefly),
            Action::Items => self.list = Some(self.selected.unwrap_or(0)),
            Action::Elevate => self.elevate(desk).await?,
            Action::Divide => {
                let direction = self.ask_direction(desk).await?;
                if let Some(at) = self.at.clone() {
                    self.divide(desk, direction, &[at]);
                }
            }
            Action::IntoEqual => self.divide_equally(desk).await?,
            Action::Coefficients => coefficients::edit(self, desk).await?,
            Action::Join => self.join(desk).await?,
            Action::Interpolate => self.interpolate(desk),
            Action::NextPoint => self.step_point(true),
            Action::PreviousPoint => self.step_point(false),
        }
        Ok(())
    }

    pub(super) async fn elevate(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let direction = self.ask_direction(desk).await?;
        let root = self.order.clone();
        let Some(item) = self.item().cloned() else { return Ok(()) };
        let raised = match &item {
            Item::Curve(curve) => self.bases.elevated_curve(curve, &root).map(Item::Curve),
            Item::Patch(patch) => self.bases.elevated_patch(patch, direction, &root).map(Item::Patch),
        };
        match raised {
            Ok(item) => self.change_item(item),
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// Divides the selected item; the second part of a curve has another colour.
    pub(super) fn divide(&mut self, desk: &mut Desk<'_>, direction: usize, places: &[Real]) {
        let (Some(at), Some(item)) = (self.selected, self.item().cloned()) else { return };
        match self.bases.divided(&item, direction, places) {
            Ok(mut parts) => {
                for (number, part) in parts.iter_mut().enumerate().skip(1) {
                    if let Item::Curve(curve) = part {
                        curve.style.colour = PART_COLORS[number % PART_COLORS.len()];
                    }
                }
                let mut scene = self.history.now().clone();
                edit::replace(&mut scene, at, parts);
                self.change(scene);
                self.select(Some(at));
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
    }

    /// A strip of equal parts: of an exact item over a freely typed interval, of another over its own.
    pub(super) async fn divide_equally(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let (Some(at), Some(item)) = (self.selected, self.item().cloned()) else { return Ok(()) };
        let Some(coefficients) = coefficients_of(&item) else {
            let direction = self.ask_direction(desk).await?;
            let parts = ask_parts(desk, &*self, texts::ASK_PARTS, 2).await?;
            if let Some(interval) = self.own_interval() {
                let interval = interval.map(Real::from);
                let places: Vec<Real> =
                    equal_parts(&interval, parts).into_iter().skip(1).map(|[start, _]| start).collect();
                self.divide(desk, direction, &places);
            }
            return Ok(());
        };
        let (coefficients, parts) = match coefficients {
            Coefficients::Curve { space, interval, coefficients } => {
                let interval = ask_interval(desk, &*self, texts::ASK_INTERVAL, &interval).await?;
                let proposed = fewest_parts(&space, values(&interval));
                let parts = ask_parts(desk, &*self, texts::ASK_PARTS, proposed).await?;
                (Coefficients::Curve { space, interval, coefficients }, [Some(parts), None])
            }
            Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients } => {
                let interval_u = ask_interval(desk, &*self, texts::ASK_INTERVAL_U, &interval_u).await?;
                let proposed = fewest_parts(&space_u, values(&interval_u));
                let u = ask_parts(desk, &*self, texts::ASK_PARTS_U, proposed).await?;
                let interval_v = ask_interval(desk, &*self, texts::ASK_INTERVAL_V, &interval_v).await?;
                let proposed = fewest_parts(&space_v, values(&interval_v));
                let v = ask_parts(desk, &*self, texts::ASK_PARTS_V, proposed).await?;
                let all = Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients };
                (all, [Some(u), Some(v)])
            }
        };
        match self.bases.strips(&coefficients, parts) {
            Ok(mut strip) => {
                for part in &mut strip {
                    match (part, &item) {
                        (Item::Curve(part), Item::Curve(whole)) => part.style = whole.style.clone(),
                        (Item::Patch(part), Item::Patch(whole)) => part.style = whole.style.clone(),
                        _ => {}
                    }
                }
                let mut scene = self.history.now().clone();
                edit::replace(&mut scene, at, strip);
                self.change(scene);
                self.select(Some(at));
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// Joins another item to the selected one, and keeps them joined.
    pub(super) async fn join(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let (Some(at), Some(item)) = (self.selected, self.item().cloned()) else { return Ok(()) };
        let count = self.scene().items.len();
        let proposal = if at + 1 < count { at + 2 } else { 1 };
        let read = |text: &str| {
            let number: Option<usize> = text.trim().parse().ok();
            number
                .and_then(|number| number.checked_sub(1))
                .filter(|&other| other < count && other != at)
                .ok_or_else(|| Phrase::from(texts::NO_ITEM))
        };
        let other = desk.meaning(&*self, texts::ASK_OTHER, &proposal.to_string(), read).await?;
        let Some(second) = self.scene().items.get(other).cloned() else { return Ok(()) };
        if matches!(item, Item::Curve(_)) != matches!(second, Item::Curve(_)) {
            desk.tell(texts::OTHER_KIND, Stay::UntilRead);
            return Ok(());
        }
        let read = |text: &str| match text.trim() {
            "g" | "G" => Ok((1, true)),
            text => match text.parse::<usize>() {
                Ok(order @ 0..=3) => Ok((order, false)),
                _ => Err(texts::NO_ORDER.into()),
            },
        };
        let (order, geometric) = desk.meaning(&*self, texts::ASK_ORDER, "1", read).await?;
        let [from, to] = edit::nearest_borders(&item, &second);
        let join = Join { a: (at, from), b: (other, to), order, geometric };
        match edit::joined(&item, from, &second, to, &join, &mut self.bases) {
            Ok(changed) => {
                let mut scene = self.history.now().clone();
                if let Some(slot) = scene.items.get_mut(other) {
                    *slot = changed;
                }
                scene.joins.retain(|it| {
                    let sides = [it.a, it.b];
                    !(sides.contains(&join.a) || sides.contains(&join.b))
                });
                scene.joins.push(join);
                self.change(scene);
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// The curve goes through its present control points, at equal steps of its parameter.
    pub(super) fn interpolate(&mut self, desk: &mut Desk<'_>) {
        let Some(Item::Curve(curve)) = self.item().cloned() else { return };
        let through = self.bases.of(&curve.space, values(&curve.interval)).and_then(|basis| {
            let last = curve.points.len().saturating_sub(1).max(1) as f64;
            let places: Vec<f64> = (0..curve.points.len()).map(|k| k as f64 / last).collect();
            basis.interpolate(&places, &curve.points)
        });
        match through {
            Ok(points) => {
                self.change_item(Item::Curve(crate::file::ec::EcCurve { points, exact: None, ..curve }));
            }
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
    }

    /// The space dialog of the selected item, and what follows from another space.
    pub(super) async fn change_space(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some(item) = self.item().cloned() else {
            desk.tell(texts::NOTHING_SELECTED, Stay::Briefly);
            return Ok(());
        };
        let direction = self.ask_direction(desk).await?;
        let (old, old_interval) = match &item {
            Item::Curve(curve) => (curve.space.clone(), curve.interval.clone()),
            Item::Patch(patch) => {
                let (space, interval) = patch_space(patch, direction);
                (space.clone(), interval.clone())
            }
        };
        let title = match (&item, direction) {
            (Item::Curve(_), _) => texts::SPACE_OF_CURVE,
            (_, 0) => texts::SPACE_OF_U,
            _ => texts::SPACE_OF_V,
        };
        let (space, interval) = space::edit(self, desk, title, (&old, &old_interval)).await?;
        if space == old && values(&interval) == values(&old_interval) {
            return Ok(());
        }
        let same_place = values(&interval) == values(&old_interval);
        let mut stays = false;
        if same_place && space.contains(&old) {
            let question = Question::new(TOP, texts::ASK_KEEP_CURVE, [texts::ELEVATE, texts::KEEP_POINTS]);
            stays = desk.ask(&*self, &question).await? == Answer::First;
        }
        let exact = space.contains(&old).then(|| coefficients_of(&item)).flatten().is_some();
        let made = if stays || exact {
            // The same functions, in the larger space, on the new interval.
            match &item {
                Item::Curve(curve) => self.bases.moved_curve(curve, &space, &interval).map(Item::Curve),
                Item::Patch(patch) => {
                    self.bases.moved_patch(patch, direction, &space, &interval).map(Item::Patch)
                }
            }
        } else {
            Ok(space::with_space(&item, direction, &space, &interval))
        };
        match made {
            Ok(item) => self.change_item(item),
            Err(error) => desk.tell(texts::problem(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// The selected item becomes what coefficients describe, over its own interval.
    pub(super) fn describe(&mut self, coefficients: &Coefficients) -> Result<(), EcError> {
        let Some(old) = self.item().cloned() else { return Ok(()) };
        let described = match (self.bases.described(coefficients)?, old) {
            (Item::Curve(new), Item::Curve(old)) => {
                Item::Curve(crate::file::ec::EcCurve { style: old.style, name: old.name, ..new })
            }
            (Item::Patch(new), Item::Patch(old)) => {
                Item::Patch(crate::file::ec::EcPatch { style: old.style, name: old.name, ..new })
            }
            (_, old) => old,
        };
        self.change_item(described);
        Ok(())
    }
}
