//! The panels of cloud and net, which stay open while the picture follows.

use super::state::{Named, Recipe, Settings, Source, State};
use super::texts;
use super::trainer::{Shown, Trainer};
use crate::geometry::cloud::{Cloud, CloudShape};
use crate::geometry::kohonen::{MAX_SIDE, MAX_STEPS, Topology, Weighting};
use crate::machine::{Asked, Asking, Language};
use crate::ui::{Area, Desk, Done, Panel, Phrase, Row, Stay, Tab, Words};

/// The most points of a cloud that is made; files may hold more.
const MOST_POINTS: f64 = 1e6;
const MOST_NOISE: f64 = 10.0;
const MOST_SEED: f64 = 1e9;

fn one_tab<M>(title: Words, rows: Vec<Row<M>>) -> Panel<M> {
    let height = 20 * i32::try_from(rows.len()).unwrap_or(10) + 76;
    let area = Area::new(88, 180, 551, 180 + height);
    Panel { area, title, keys: texts::PANEL_KEYS, tabs: vec![Tab { name: title, rows }], chosen: [0, 0] }
}

/// The value after another one in a list, or before it, around.
fn turned<T: Copy + PartialEq>(all: &[T], present: T, forward: bool) -> T {
    let at = all.iter().position(|it| *it == present).unwrap_or(0);
    let step = if forward { 1 } else { all.len().saturating_sub(1) };
    all.get((at + step) % all.len().max(1)).copied().unwrap_or(present)
}

fn cloud_panel() -> Panel<Recipe> {
    one_tab(
        texts::CLOUD_PANEL,
        vec![
            Row::Choice {
                name: texts::ROW_SHAPE,
                shown: |it, _, language: Language| texts::shape(it.shape()).of(language).to_owned(),
                turn: |it, _, forward| {
                    it.shape = turned(&CloudShape::ALL, it.shape(), forward).name().to_owned();
                },
            },
            Row::Value {
                name: texts::ROW_POINTS,
                get: |it| it.points.into(),
                set: |it, points| it.points = points as u32,
                range: 1.0..=MOST_POINTS,
            },
            Row::Value {
                name: texts::ROW_NOISE,
                get: |it| it.noise,
                set: |it, noise| it.noise = noise,
                range: 0.0..=MOST_NOISE,
            },
            Row::Value {
                name: texts::ROW_SEED,
                get: |it| it.seed.into(),
                set: |it, seed| it.seed = seed as u32,
                range: 0.0..=MOST_SEED,
            },
        ],
    )
}

fn net_panel() -> Panel<Settings> {
    let choice = |name, shown, turn| Row::Choice { name, shown, turn };
    one_tab(
        texts::NET_PANEL,
        vec![
            Row::Value {
                name: texts::ROW_ROWS,
                get: |it| it.size[0] as f64,
                set: |it, rows| it.size[0] = rows as usize,
                range: 1.0..=MAX_SIDE as f64,
            },
            Row::Value {
                name: texts::ROW_COLUMNS,
                get: |it| it.size[1] as f64,
                set: |it, columns| it.size[1] = columns as usize,
                range: 1.0..=MAX_SIDE as f64,
            },
            choice(
                texts::ROW_TOPOLOGY,
                |it: &Settings, _, language: Language| texts::topology(it.topology()).of(language).to_owned(),
                |it: &mut Settings, _, forward| {
                    it.topology = turned(&Topology::ALL, it.topology(), forward).name().to_owned();
                },
            ),
            choice(
                texts::ROW_WEIGHTING,
                |it: &Settings, _, language: Language| {
                    texts::weighting(it.weighting()).of(language).to_owned()
                },
                |it: &mut Settings, _, forward| {
                    let all = [Weighting::Gauss, Weighting::Bubble];
                    it.weighting = turned(&all, it.weighting(), forward).name().to_owned();
                },
            ),
            choice(
                texts::ROW_START,
                |it: &Settings, _, language: Language| {
                    let name = if it.shaped { texts::SHAPED } else { texts::AT_RANDOM };
                    name.of(language).to_owned()
                },
                |it: &mut Settings, _, _| it.shaped = !it.shaped,
            ),
            Row::Value {
                name: texts::ROW_STEPS,
                get: |it| it.steps as f64,
                set: |it, steps| it.steps = steps as u64,
                range: 0.0..=MAX_STEPS as f64,
            },
            Row::Value {
                name: texts::ROW_SEED,
                get: |it| it.seed.into(),
                set: |it, seed| it.seed = seed as u32,
                range: 0.0..=MOST_SEED,
            },
        ],
    )
}

/// The command K: a cloud of a known surface, which is seen while its numbers change.
pub(super) async fn ask_cloud(trainer: &mut Trainer, desk: &mut Desk<'_>) -> Asked<()> {
    let before = trainer.history.now().clone();
    let made = before.cloud.as_ref().and_then(|named| match &named.source {
        Source::Made(recipe) => Some(recipe.clone()),
        Source::File(_) => None,
    });
    let mut recipe = made.clone().unwrap_or_default();
    let make = |recipe: &Recipe| -> Result<State, Phrase> {
        let named = Named { cloud: recipe.cloud()?, source: Source::Made(recipe.clone()) };
        Ok(State { net: None, ..before.clone() }.with_cloud(named))
    };
    let mut panel = cloud_panel();
    // A cloud from a file stays until a value is changed.
    let mut shown = made.or_else(|| before.cloud.as_ref().map(|_| recipe.clone()));
    loop {
        if shown.as_ref() != Some(&recipe) {
            match make(&recipe) {
                Ok(state) => {
                    trainer.trial = Some(state);
                    trainer.options.shown = Shown::Both;
                    trainer.look_at_cloud();
                    shown = Some(recipe.clone());
                }
                Err(problem) => {
                    desk.tell(problem, Stay::UntilRead);
                    recipe = shown.clone().unwrap_or_default();
                }
            }
        }
        if desk.panel(&*trainer, &mut panel, &mut recipe).await.unless_cancelled()?.is_none() {
            break;
        }
    }
    if let Some(state) = trainer.trial.take() {
        trainer.history.change(state);
    }
    Ok(())
}

/// The command H: how a net learns.
pub(super) async fn ask_net(trainer: &mut Trainer, desk: &mut Desk<'_>) -> Asked<()> {
    let mut settings = trainer.history.now().settings.clone();
    let mut panel = net_panel();
    loop {
        let before = settings.clone();
        let asked = desk.panel(&*trainer, &mut panel, &mut settings).await.unless_cancelled()?;
        if asked.is_none() {
            break;
        }
        if asked == Some(Done::Changed)
            && let Some(problem) = impossible(&settings, trainer.history.now().cloud())
        {
            desk.tell(problem, Stay::UntilRead);
            settings = before;
        }
    }
    trainer.history.change(trainer.history.now().with_settings(settings));
    Ok(())
}

/// Why there is no net of these settings, if there is none.
fn impossible(settings: &Settings, cloud: Option<&Cloud>) -> Option<Phrase> {
    let any = Cloud::new(vec![[0.0; 3]]).ok()?;
    settings.start(cloud.unwrap_or(&any)).err().map(|error| Phrase::plain(&error))
}
