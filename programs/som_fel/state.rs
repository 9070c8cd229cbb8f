//! What is undone, saved and rescued: the cloud, how a net learns it, the net, and its surface.

use super::texts;
use crate::file::{Document, SomNet};
use crate::geometry::Point;
use crate::geometry::cloud::{Cloud, CloudShape};
use crate::geometry::fit::{Fitted, Report};
use crate::geometry::kohonen::{KohonenError, Learning, Net, Order, Rule, Topology, Weighting};
use crate::ui::Phrase;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// The seed of random numbers where none is given.
const SEED: u32 = 1;

/// How a cloud of a known surface is made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Recipe {
    /// Its name as [`CloudShape::name`] has it.
    pub(super) shape: String,
    pub(super) points: u32,
    pub(super) noise: f64,
    pub(super) seed: u32,
}

impl Default for Recipe {
    fn default() -> Self {
        Recipe { shape: CloudShape::Saddle.name().to_owned(), points: 2000, noise: 0.02, seed: SEED }
    }
}

impl Recipe {
    /// The surface.
    pub(super) fn shape(&self) -> CloudShape {
        let known = CloudShape::ALL.into_iter().find(|shape| shape.name() == self.shape);
        known.unwrap_or(CloudShape::Saddle)
    }

    /// The cloud.
    pub(super) fn cloud(&self) -> Result<Cloud, Phrase> {
        Cloud::of_shape(self.shape(), self.points as usize, self.noise, self.seed.into())
            .map_err(|error| Phrase::plain(&error))
    }
}

/// Where a cloud is from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Source {
    /// A file in the folder, or a sample.
    File(String),
    Made(Recipe),
}

/// A cloud with its source.
#[derive(Debug)]
pub(super) struct Named {
    pub(super) cloud: Cloud,
    pub(super) source: Source,
}

impl Named {
    /// Whether all points are in the plane z = 0.
    pub(super) fn is_plane(&self) -> bool {
        let bounds = self.cloud.bounds();
        bounds.min[2] == 0.0 && bounds.max[2] == 0.0
    }
}

/// How a net learns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Settings {
    pub(super) size: [usize; 2],
    /// By their names.
    pub(super) topology: String,
    pub(super) weighting: String,
    /// The number of steps; 0 for the usual one.
    pub(super) steps: u64,
    pub(super) seed: u32,
    /// Whether the net begins in the shape of its topology, and not drawn together at random.
    #[serde(default)]
    pub(super) shaped: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Settings::for_topology(Topology::Open)
    }
}

impl Settings {
    /// A net of a size that suits a topology.
    fn for_topology(topology: Topology) -> Settings {
        let size = match topology {
            Topology::Open => [12, 12],
            Topology::Cylinder => [6, 16],
            Topology::Torus => [10, 16],
            Topology::Sphere => [11, 16],
        };
        // At random, most tori unfold with a pinch.
        let shaped = topology == Topology::Torus;
        let (topology, weighting) = (topology.name().to_owned(), Weighting::Gauss.name().to_owned());
        Settings { size, topology, weighting, steps: 0, seed: SEED, shaped }
    }

    /// Settings that suit a cloud: a polygon for one of the plane, and the topology of a known surface.
    pub(super) fn for_cloud(&self, named: &Named) -> Settings {
        let topology = match &named.source {
            Source::Made(recipe) => match recipe.shape() {
                CloudShape::Sphere => Topology::Sphere,
                CloudShape::Torus => Topology::Torus,
                CloudShape::Ring => Topology::Cylinder,
                _ => Topology::Open,
            },
            Source::File(_) => Topology::Open,
        };
        let polygon = self.size.contains(&1);
        if named.is_plane() {
            let size = if polygon { self.size } else { [40, 1] };
            let topology = Topology::Open.name().to_owned();
            return Settings { size, topology, shaped: false, ..self.clone() };
        }
        let from_file = matches!(named.source, Source::File(_));
        if !polygon && (from_file || self.topology() == topology) {
            return self.clone();
        }
        Settings { seed: self.seed, steps: self.steps, ..Settings::for_topology(topology) }
    }

    pub(super) fn topology(&self) -> Topology {
        Topology::of_name(&self.topology).unwrap_or(Topology::Open)
    }

    pub(super) fn weighting(&self) -> Weighting {
        Weighting::of_name(&self.weighting).unwrap_or(Weighting::Gauss)
    }

    pub(super) fn rule(&self) -> Rule {
        Rule {
            weighting: self.weighting(),
            order: Order::Random(self.seed.into()),
            steps: (self.steps > 0).then_some(self.steps),
            radius: self.shaped.then_some(1.0),
            ..Rule::default()
        }
    }

    /// The net before its first step.
    pub(super) fn start(&self, cloud: &Cloud) -> Result<Net, KohonenError> {
        match self.shaped {
            true => Net::shaped(cloud, self.size, self.topology()),
            false => Net::random(cloud, self.size, self.topology(), self.seed.into()),
        }
    }
}

/// The surface or curve of a net.
#[derive(Debug)]
pub(super) struct Surface {
    pub(super) fitted: Fitted,
    /// Whether the neurons are its control points.
    pub(super) base: bool,
    /// What came of a fit that went to its end.
    pub(super) fit: Option<Fit>,
}

/// What came of a fit.
#[derive(Debug)]
pub(super) struct Fit {
    pub(super) report: Report,
    /// The signed distances of all points.
    pub(super) distances: Vec<f64>,
}

/// The value that is undone. Copies share what is large.
#[derive(Clone, Debug, Default)]
pub(super) struct State {
    pub(super) cloud: Option<Rc<Named>>,
    pub(super) settings: Settings,
    pub(super) net: Option<Rc<Net>>,
    /// The learning that the net is of, which can go on; none for a net from a file.
    pub(super) learning: Option<Rc<Learning>>,
    pub(super) surface: Option<Rc<Surface>>,
}

fn same<T>(one: Option<&Rc<T>>, other: Option<&Rc<T>>) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => Rc::ptr_eq(one, other),
        _ => false,
    }
}

impl PartialEq for State {
    /// Clouds and surfaces are equal where they are shared; there may be millions of points.
    fn eq(&self, other: &State) -> bool {
        let nets = same(self.net.as_ref(), other.net.as_ref()) || self.net == other.net;
        nets && same(self.cloud.as_ref(), other.cloud.as_ref())
            && self.settings == other.settings
            && same(self.learning.as_ref(), other.learning.as_ref())
            && same(self.surface.as_ref(), other.surface.as_ref())
    }
}

impl State {
    /// The state with another cloud. The net of a cloud that was made is not that of another one.
    pub(super) fn with_cloud(&self, named: Named) -> State {
        let settings = if self.cloud.is_none() && self.net.is_some() {
            self.settings.clone()
        } else {
            self.settings.for_cloud(&named)
        };
        let net = self.net.clone().filter(|_| self.cloud.is_none());
        State { cloud: Some(Rc::new(named)), settings, net, learning: None, surface: None }
    }

    /// The state with what has been learnt, of which there is no surface yet.
    pub(super) fn with_learning(&self, learning: Learning) -> State {
        let net = Some(Rc::new(learning.net().clone()));
        State { net, learning: Some(Rc::new(learning)), surface: None, ..self.clone() }
    }

    /// The state with other settings, by which the next learning begins.
    pub(super) fn with_settings(&self, settings: Settings) -> State {
        let learning = self.learning.clone().filter(|_| settings == self.settings);
        State { settings, learning, ..self.clone() }
    }

    pub(super) fn with_surface(&self, surface: Rc<Surface>) -> State {
        State { surface: Some(surface), ..self.clone() }
    }

    /// The state of a document: a net without a cloud, or a cloud that is to be learnt. `name` is that of its file.
    pub(super) fn opened(document: &Document, name: &str) -> Result<State, Phrase> {
        match document {
            Document::Som(net) => {
                let net = Net::new(net.topology, &net.points).map_err(|error| Phrase::plain(&error))?;
                let settings = Settings { size: net.size(), ..Settings::for_topology(net.topology()) };
                Ok(State { settings, net: Some(Rc::new(net)), ..State::default() })
            }
            Document::Cloud(cloud) => {
                let cloud = Cloud::new(cloud.points.as_slice()).map_err(|error| Phrase::plain(&error))?;
                Ok(State::default().with_cloud(Named { cloud, source: Source::File(name.to_owned()) }))
            }
            _ => Err(texts::NO_DOCUMENT.into()),
        }
    }

    /// The state before anything is opened: there is a cloud to begin with.
    pub(super) fn fresh() -> State {
        let recipe = Recipe::default();
        match recipe.cloud() {
            Ok(cloud) => State::default().with_cloud(Named { cloud, source: Source::Made(recipe) }),
            Err(_) => State::default(),
        }
    }

    /// The net as a document.
    pub(super) fn som(&self) -> Option<SomNet> {
        self.net.as_ref().map(|net| SomNet { topology: net.topology(), points: net.rows() })
    }

    /// The cloud.
    pub(super) fn cloud(&self) -> Option<&Cloud> {
        self.cloud.as_ref().map(|named| &named.cloud)
    }

    /// Why the net cannot learn the cloud, if it cannot.
    pub(super) fn unlearnable(&self) -> Option<Phrase> {
        let Some(named) = &self.cloud else { return Some(texts::NO_CLOUD.into()) };
        if named.cloud.diagonal() == 0.0 {
            return Some(texts::ONE_PLACE.into());
        }
        let [_, (_, second), _] = named.cloud.principal_axes();
        let straight = second <= 1e-9 * named.cloud.diagonal();
        (straight && !self.settings.size.contains(&1)).then(|| texts::STRAIGHT.into())
    }
}

/// What is kept of unsaved work: a cloud by its source, everything else whole.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Rescued {
    #[serde(default)]
    pub(super) cloud: Option<Source>,
    pub(super) settings: Settings,
    pub(super) topology: String,
    pub(super) neurons: Vec<Vec<Point<3>>>,
}

impl Rescued {
    pub(super) fn of(state: &State) -> Rescued {
        let net = state.net.as_deref();
        Rescued {
            cloud: state.cloud.as_ref().map(|named| named.source.clone()),
            settings: state.settings.clone(),
            topology: net.map_or(Topology::Open, Net::topology).name().to_owned(),
            neurons: net.map(Net::rows).unwrap_or_default(),
        }
    }

    /// The state, and the file that its cloud is still to be read from.
    pub(super) fn state(self) -> Result<(State, Option<String>), Phrase> {
        let topology = Topology::of_name(&self.topology).ok_or(Phrase::from(texts::NO_DOCUMENT))?;
        let net = match self.neurons.as_slice() {
            [] => None,
            rows => Some(Net::new(topology, rows).map_err(|error| Phrase::plain(&error))?),
        };
        let (cloud, file) = match self.cloud {
            Some(Source::Made(recipe)) => {
                let named = Named { cloud: recipe.cloud()?, source: Source::Made(recipe) };
                (Some(Rc::new(named)), None)
            }
            Some(Source::File(name)) => (None, Some(name).filter(|name| !name.is_empty())),
            None => (None, None),
        };
        Ok((State { cloud, settings: self.settings, net: net.map(Rc::new), ..State::default() }, file))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rescued_work_is_as_before() {
        let state = State::fresh();
        let cloud = state.cloud().unwrap();
        let settings = Settings { size: [5, 6], steps: 500, ..state.settings.clone() };
        let mut learning = Learning::new(cloud, settings.start(cloud).unwrap(), settings.rule()).unwrap();
        learning.advance(77);
        let state = state.with_settings(settings).with_learning(learning);
        let text = serde_json::to_string(&Rescued::of(&state)).unwrap();
        let (taken, file) = serde_json::from_str::<Rescued>(&text).unwrap().state().unwrap();
        assert_eq!(taken.cloud().unwrap().points(), cloud.points());
        assert_eq!((taken.net, taken.settings, file), (state.net, state.settings, None));
        for bad in ["{}", "{\"settings\":{},\"topology\":\"open\",\"neurons\":[[[0,0]]]}"] {
            assert!(serde_json::from_str::<Rescued>(bad).is_err());
        }
        let wrong = text.replace("\"open\",\"neurons\"", "\"ball\",\"neurons\"");
        assert!(serde_json::from_str::<Rescued>(&wrong).unwrap().state().is_err());
    }

    #[test]
    fn the_cloud_of_a_file_is_read_again() {
        let cloud = Cloud::new(vec![[0.0; 3], [1.0; 3]]).unwrap();
        let state = State::fresh().with_cloud(Named { cloud, source: Source::File("A.PLY".to_owned()) });
        let (taken, file) = Rescued::of(&state).state().unwrap();
        assert_eq!((taken.cloud.is_none(), file.as_deref()), (true, Some("A.PLY")));
    }

    #[test]
    fn settings_suit_the_cloud() {
        let named = |shape: CloudShape| {
            let recipe = Recipe { shape: shape.name().to_owned(), points: 50, ..Recipe::default() };
            Named { cloud: recipe.cloud().unwrap(), source: Source::Made(recipe) }
        };
        for (shape, topology, plane) in [
            (CloudShape::Saddle, Topology::Open, false),
            (CloudShape::Sphere, Topology::Sphere, false),
            (CloudShape::Torus, Topology::Torus, false),
            (CloudShape::Ring, Topology::Cylinder, false),
            (CloudShape::Letter, Topology::Open, true),
        ] {
            let settings = Settings::for_topology(Topology::Torus).for_cloud(&named(shape));
            assert_eq!((settings.topology(), settings.size == [40, 1]), (topology, plane), "{shape:?}");
            let settings = Settings { size: [7, 1], ..Settings::default() }.for_cloud(&named(shape));
            assert_eq!((settings.topology(), settings.size == [7, 1]), (topology, plane), "{shape:?}");
        }
    }
}
