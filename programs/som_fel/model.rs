//! The model as `dump` writes it.

use super::run::Run;
use super::state::{Source, State};
use super::trainer::{Shown, Trainer};
use crate::editor::net::{Display, Inspection};
use crate::geometry::Point;
use crate::geometry::kohonen::{End, Learning, Net};
use serde::Serialize;

/// Angles are in degrees.
#[derive(Serialize)]
struct Model {
    /// `nothing`, `learning`, `step`, `fitting` or `reading`.
    run: &'static str,
    cloud: Option<Cloud>,
    /// How the next net learns.
    settings: super::state::Settings,
    net: Option<Neurons>,
    learning: Option<Learnt>,
    surface: Option<Surface>,
    options: Options,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    unsaved: bool,
}

#[derive(Serialize)]
struct Cloud {
    source: Source,
    points: usize,
    plane: bool,
}

#[derive(Serialize)]
struct Neurons {
    size: [usize; 2],
    topology: &'static str,
    points: Vec<Vec<Point<3>>>,
}

#[derive(Serialize)]
struct Learnt {
    /// Steps of the present stage of how many, and all that were made.
    step: u64,
    steps: u64,
    total: u64,
    growing: bool,
    /// Why it is over: `steps` or `settled`.
    end: Option<&'static str>,
    gain: Option<f64>,
    radius: Option<f64>,
    winner: Option<[usize; 2]>,
    rms: Option<f64>,
    wins: Vec<u64>,
}

#[derive(Serialize)]
struct Surface {
    /// `surface` or `curve`.
    kind: &'static str,
    /// Whether the neurons are its control points.
    base: bool,
    fit: Option<Report>,
}

#[derive(Serialize)]
struct Report {
    points: usize,
    rms: f64,
    largest: f64,
    mean: f64,
    percentile_95: f64,
    history: Vec<f64>,
}

#[derive(Serialize)]
struct Options {
    shown: Shown,
    errors: bool,
    /// `off`, `zebra` or `curvature`.
    colours: &'static str,
    section: Option<String>,
    filled: bool,
    alone: bool,
}

/// The model of the program.
pub(super) fn of(trainer: &Trainer) -> impl Serialize + 'static {
    let (state, options) = (trainer.state(), trainer.options);
    let [azimuth, elevation, zoom] = trainer.viewer.look.angles();
    Model {
        run: match &trainer.run {
            Run::Nothing => "nothing",
            Run::Learning(_) => "learning",
            Run::Slow(_) => "step",
            Run::Fitting(_) => "fitting",
            Run::Reading(_) => "reading",
        },
        cloud: cloud(state),
        settings: state.settings.clone(),
        net: trainer.net().map(neurons),
        learning: trainer.learning().map(learnt),
        surface: trainer.surface().map(|surface| Surface {
            kind: if surface.fitted.curve().is_some() { "curve" } else { "surface" },
            base: surface.base,
            fit: surface.fit.as_ref().map(|fit| Report {
                points: fit.report.points,
                rms: fit.report.rms,
                largest: fit.report.largest,
                mean: fit.report.mean,
                percentile_95: fit.report.percentile_95,
                history: fit.report.history.clone(),
            }),
        }),
        options: Options {
            shown: options.shown,
            errors: options.errors,
            colours: match options.inspection {
                Inspection::Off => "off",
                Inspection::Zebra => "zebra",
                Inspection::Curvature | Inspection::Radius => "curvature",
            },
            section: options.section.map(|section| section.name()),
            filled: options.display == Display::Filled,
            alone: options.alone,
        },
        azimuth,
        elevation,
        zoom,
        unsaved: trainer.history.unsaved() && trainer.history.now().net.is_some(),
    }
}

fn cloud(state: &State) -> Option<Cloud> {
    let named = state.cloud.as_ref()?;
    let (source, plane) = (named.source.clone(), named.is_plane());
    Some(Cloud { source, points: named.cloud.points().len(), plane })
}

fn neurons(net: &Net) -> Neurons {
    Neurons { size: net.size(), topology: net.topology().name(), points: net.rows() }
}

fn learnt(learning: &Learning) -> Learnt {
    let last = learning.last();
    Learnt {
        step: learning.t(),
        steps: learning.schedule().steps(),
        total: learning.total(),
        growing: learning.is_growing(),
        end: learning.end().map(|end| match end {
            End::Steps => "steps",
            End::Settled => "settled",
        }),
        gain: last.map(|step| step.gain),
        radius: last.map(|step| step.radius),
        winner: last.map(|step| step.winner),
        rms: learning.rms(),
        wins: learning.wins().to_vec(),
    }
}
