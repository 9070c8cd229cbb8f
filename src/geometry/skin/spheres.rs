//! Spheres with their chains: what a surface is put over.

use super::admissible::shrunk;
use super::links::check_balls;
use super::rules::{Violation, violations};
use super::touching::flattened;
use super::{Links, MAX_EDGES, SkinError, Sphere};
use crate::geometry::Point;
use std::f64::consts::PI;

/// Directions in which a sphere is looked at for being covered.
const DIRECTIONS: u32 = 2000;

/// Spheres that hang together by chains, which may have spheres in common.
#[derive(Clone, Debug, PartialEq)]
pub struct Spheres {
    spheres: Vec<Sphere>,
    chains: Vec<Vec<usize>>,
    closed: bool,
}

impl Spheres {
    /// Spheres with the chains that they are strung on, by numbers from 0; without any they are one chain in their
    /// order. A single chain may be closed, its last sphere a neighbour of its first.
    ///
    /// # Errors
    /// [`SkinError`] for no spheres or too many, coordinates and radii out of range, chains that name what does not
    /// exist, pass a sphere twice or have less than two, spheres in no chain, and a ring of less than three.
    pub fn new(spheres: Vec<Sphere>, chains: Vec<Vec<usize>>, closed: bool) -> Result<Self, SkinError> {
        check_balls(&spheres)?;
        let count = spheres.len();
        let chains = if chains.is_empty() { vec![(0..count).collect()] } else { chains };
        check_chains(&chains, count)?;
        if closed {
            let [chain] = chains.as_slice() else {
                return Err(SkinError::ClosedChains { given: chains.len() });
            };
            Links::Ring.check(chain.len())?;
        }
        Ok(Self { spheres, chains, closed })
    }

    /// One chain in the order of the spheres.
    ///
    /// # Errors
    /// As [`Spheres::new`].
    pub fn chain(spheres: Vec<Sphere>) -> Result<Self, SkinError> {
        Self::new(spheres, Vec::new(), false)
    }

    /// The same spheres, one of which has another place or radius; unchanged where there is no such sphere.
    ///
    /// # Errors
    /// As [`Spheres::new`].
    pub fn with_sphere(&self, index: usize, sphere: Sphere) -> Result<Self, SkinError> {
        let mut spheres = self.spheres.clone();
        if let Some(place) = spheres.get_mut(index) {
            *place = sphere;
        }
        Self::new(spheres, self.chains.clone(), self.closed)
    }

    /// The spheres.
    #[must_use]
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres
    }

    /// The chains, by numbers of spheres.
    #[must_use]
    pub fn chains(&self) -> &[Vec<usize>] {
        &self.chains
    }

    /// Whether the single chain is a ring.
    #[must_use]
    pub fn closed(&self) -> bool {
        self.closed
    }

    /// The parts of the chains between spheres that several of them have in common. Each is skinned alone, so a shared
    /// sphere is an end of all that come to it.
    #[must_use]
    pub fn arms(&self) -> Vec<Vec<usize>> {
        let mut uses = vec![0_usize; self.spheres.len()];
        self.chains.iter().flatten().for_each(|&sphere| uses[sphere] += 1);
        let mut arms = Vec::new();
        for chain in &self.chains {
            let mut from = 0;
            for (at, &sphere) in chain.iter().enumerate().skip(1) {
                if uses[sphere] > 1 || at + 1 == chain.len() {
                    arms.push(chain[from..=at].to_vec());
                    from = at;
                }
            }
        }
        arms
    }

    /// The rules of definition 2.14 that the spheres break, with balls in place of discs: see
    /// [`Circles::violations`](super::Circles::violations). Several chains follow the rules of trees. Whether a ball is covered is
    /// told by 2000 directions from its centre; rule 3 is looked at in the plane of the three centres.
    #[must_use]
    pub fn violations(&self) -> Vec<Violation> {
        let flat = |three: [&Sphere; 3]| flattened(three).0;
        let [chain] = self.chains.as_slice() else {
            let mut edges: Vec<[usize; 2]> = self
                .chains
                .iter()
                .flat_map(|chain| chain.windows(2).map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])]))
                .collect();
            edges.sort_unstable();
            edges.dedup();
            let covered = |meeting: &[Vec<usize>], e| covered_balls(&self.spheres, meeting, e);
            return violations(&self.spheres, &Links::Edges(edges), covered, flat);
        };
        // In the order of the chain, which the rules go by.
        let spheres: Vec<Sphere> = chain.iter().map(|&number| self.spheres[number]).collect();
        let links = if self.closed { Links::Ring } else { Links::Chain };
        let covered = |meeting: &[Vec<usize>], e| covered_balls(&spheres, meeting, e);
        let found = violations(&spheres, &links, covered, flat);
        found.into_iter().map(|violation| violation.renumbered(chain)).collect()
    }

    /// Whether the spheres are admissible.
    #[must_use]
    pub fn is_admissible(&self) -> bool {
        self.violations().is_empty()
    }

    /// Admissible spheres with the same centres: see
    /// [`Circles::nearest_admissible`](super::Circles::nearest_admissible).
    #[must_use]
    pub fn nearest_admissible(&self) -> Option<Spheres> {
        let with = |spheres: Vec<Sphere>| Self { spheres, ..self.clone() };
        shrunk(&self.spheres, |spheres| Some(with(spheres.to_vec()).violations())).map(with)
    }
}

/// Whether chains pass spheres that exist, each once, and leave none out.
fn check_chains(chains: &[Vec<usize>], count: usize) -> Result<(), SkinError> {
    let given = chains.iter().map(Vec::len).fold(0, usize::saturating_add);
    if given > MAX_EDGES {
        return Err(SkinError::TooManyEdges { given });
    }
    let mut last_chain = vec![None; count];
    for (index, chain) in chains.iter().enumerate() {
        for &named in chain {
            let Some(last) = last_chain.get_mut(named) else {
                return Err(SkinError::NoSuch { what: "chain", index, named, count });
            };
            if last.replace(index) == Some(index) {
                return Err(SkinError::Repeated { chain: index, sphere: named });
            }
        }
        // One sphere alone is a chain that has only begun.
        if chain.len() < 2 && count > 1 || chain.is_empty() {
            return Err(SkinError::ShortChain { chain: index });
        }
    }
    match last_chain.iter().position(Option::is_none) {
        Some(sphere) => Err(SkinError::Unlinked { sphere }),
        None => Ok(()),
    }
}

/// The balls whose whole surface, as far as some directions tell, is in the union of the others.
fn covered_balls(spheres: &[Sphere], meeting: &[Vec<usize>], e: f64) -> Vec<usize> {
    // Evenly over the sphere along a spiral.
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let directions: Vec<Point<3>> = (0..DIRECTIONS)
        .map(|k| {
            let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(DIRECTIONS);
            let ((sine, cosine), r) = ((golden * f64::from(k)).sin_cos(), ((1.0 - z) * (1.0 + z)).sqrt());
            [r * cosine, r * sine, z]
        })
        .collect();
    let is_covered = |i: &usize| {
        let (sphere, others) = (&spheres[*i], &meeting[*i]);
        directions.iter().all(|direction| {
            let point = sphere.point(*direction);
            others.iter().any(|&j| spheres[j].contains(point, e))
        })
    };
    (0..spheres.len()).filter(|i| !meeting[*i].is_empty()).filter(is_covered).collect()
}
