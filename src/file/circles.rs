//! Circles with a skin, `.KOR`, and spheres with a skin, `.GOM`, which are JSON only.

use super::FileError;
use super::check::{self, number};
use serde::{Deserialize, Serialize};

/// The most circles or spheres of a document.
const MOST: usize = 10_000;

/// Circles of the plane: a chain, a ring, or a tree by its edges.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circles {
    /// Centre and radius: `[x, y, r]`.
    pub circles: Vec<[f64; 3]>,
    /// Whether the last circle of a chain is followed by the first.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// Pairs of neighbours, counted from 0; without them the circles are a chain in their order.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Vec<[usize; 2]>>,
}

/// Spheres: a chain, a ring, or several chains.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spheres {
    /// Centre and radius: `[x, y, z, r]`.
    pub spheres: Vec<[f64; 4]>,
    /// Whether the last sphere of the chain is followed by the first.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// Chains of spheres, counted from 0, that may share spheres; without them there is one in their order.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chains: Option<Vec<Vec<usize>>>,
}

/// Every number is finite, and the last of each, the radius, positive.
fn check_rounds<const N: usize>(what: &str, rounds: &[[f64; N]]) -> Result<(), FileError> {
    if rounds.len() > MOST {
        return Err(FileError::Invalid(format!("{} {what}s; there may be {MOST} at most", rounds.len())));
    }
    for (index, round) in rounds.iter().enumerate() {
        let place = index + 1;
        let radius = round.last().copied().unwrap_or(f64::NAN);
        if round.iter().any(|it| !it.is_finite()) {
            return Err(FileError::Invalid(format!("{what} {place} has a number that is not finite")));
        }
        if radius <= 0.0 {
            return Err(FileError::Invalid(format!(
                "{what} {place} has the radius {}; it must be larger than 0",
                number(radius)
            )));
        }
    }
    Ok(())
}

/// The circle or sphere exists that edges or chains name.
fn check_index(by: &str, what: &str, index: usize, count: usize) -> Result<(), FileError> {
    if index < count {
        return Ok(());
    }
    let most = count.saturating_sub(1);
    Err(FileError::Invalid(format!("there is no {what} {index}; {by} count {what}s from 0 to {most}")))
}

fn told<const N: usize>(what: &str, rounds: &[[f64; N]]) -> Vec<String> {
    let row = |(index, round): (usize, &[f64; N])| {
        let (radius, centre) = round.split_last().unwrap_or((&0.0, &[]));
        let centre: Vec<String> = centre.iter().copied().map(number).collect();
        format!("{what} {}: centre {}, radius {}", index + 1, centre.join(", "), number(*radius))
    };
    rounds.iter().enumerate().map(row).collect()
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

impl Circles {
    /// # Errors
    /// [`FileError::Invalid`] for a number that is not finite, a radius that is not positive, an edge to nowhere.
    pub(super) fn check(&self) -> Result<(), FileError> {
        check_rounds("circle", &self.circles)?;
        if self.closed && self.edges.is_some() {
            let problem = "\"closed\" is for chains; edges say themselves what is joined";
            return Err(FileError::Invalid(problem.to_owned()));
        }
        let mut ends = self.edges.iter().flatten().flatten();
        ends.try_for_each(|&end| check_index("edges", "circle", end, self.circles.len()))
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let kind = match (&self.edges, self.closed) {
            (Some(edges), _) => format!("joined by {}", counted(edges.len(), "edge")),
            (None, true) => "in a ring".to_owned(),
            (None, false) => "in a chain".to_owned(),
        };
        let mut lines = vec![format!("{} {kind}", counted(self.circles.len(), "circle"))];
        let corners: Vec<[f64; 2]> =
            self.circles.iter().flat_map(|&[x, y, r]| [[x - r, y - r], [x + r, y + r]]).collect();
        lines.extend(check::Bounds::of(corners.iter()).map(|bounds| bounds.describe()));
        lines.extend(told("circle", &self.circles));
        lines
    }
}

impl Spheres {
    /// # Errors
    /// [`FileError::Invalid`] for a number that is not finite, a radius that is not positive, a chain of what is not
    /// there.
    pub(super) fn check(&self) -> Result<(), FileError> {
        check_rounds("sphere", &self.spheres)?;
        if self.closed && self.chains.is_some() {
            let problem = "\"closed\" is for a single chain; there are \"chains\" as well";
            return Err(FileError::Invalid(problem.to_owned()));
        }
        let mut all = self.chains.iter().flatten().flatten();
        all.try_for_each(|&index| check_index("chains", "sphere", index, self.spheres.len()))
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let kind = match (&self.chains, self.closed) {
            (Some(chains), _) => format!("in {}", counted(chains.len(), "chain")),
            (None, true) => "in a ring".to_owned(),
            (None, false) => "in a chain".to_owned(),
        };
        let mut lines = vec![format!("{} {kind}", counted(self.spheres.len(), "sphere"))];
        let low = self.spheres.iter().map(|&[x, y, z, r]| [x - r, y - r, z - r]);
        let high = self.spheres.iter().map(|&[x, y, z, r]| [x + r, y + r, z + r]);
        let corners: Vec<[f64; 3]> = low.chain(high).collect();
        lines.extend(check::Bounds::of(corners.iter()).map(|bounds| bounds.describe()));
        lines.extend(told("sphere", &self.spheres));
        lines
    }
}
