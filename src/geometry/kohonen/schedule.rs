//! Gain and radius over time.

use super::{KohonenError, MAX_STEPS};
use crate::geometry::portable::{exp, ln};

/// Gain at the start and at the end.
const GAIN: [f64; 2] = [0.5, 0.01];
/// The radius at the end.
const LAST_RADIUS: f64 = 0.5;
/// The largest radius at the start.
const MAX_RADIUS: f64 = 1e4;

/// Who is a neighbour of the winner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Weighting {
    /// All neurons, the nearer the more: `exp(-D / (2 r^2))`, where `D` is the square of the distance on the net.
    #[default]
    Gauss,
    /// Those within a square of `2 N + 1` neurons (on a sphere within a circle), all alike.
    Bubble,
}

impl Weighting {
    /// What it is called: `gauss`, `bubble`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gauss => "gauss",
            Self::Bubble => "bubble",
        }
    }

    /// The weighting of a name.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        [Self::Gauss, Self::Bubble].into_iter().find(|weighting| weighting.name() == name)
    }
}

/// Gain and radius as functions of the step `t`, with `f = t / T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    weighting: Weighting,
    steps: u64,
    /// At t = 0, and the logarithm of what it falls to.
    gain: [f64; 2],
    radius: [f64; 2],
}

impl Schedule {
    /// Learning in `steps` steps from a radius.
    ///
    /// # Errors
    /// A wrong number of steps or radius.
    pub fn new(weighting: Weighting, steps: u64, radius: f64) -> Result<Self, KohonenError> {
        if !(1..=MAX_STEPS).contains(&steps) {
            return Err(KohonenError::Steps { given: steps });
        }
        // Not a number is outside too.
        if !(LAST_RADIUS..=MAX_RADIUS).contains(&radius) {
            let wanted = "a number of neurons from 0.5 to 10000";
            return Err(KohonenError::Parameter { name: "radius", value: radius, wanted });
        }
        let (gain, radius) = ([GAIN[0], ln(GAIN[1] / GAIN[0])], [radius, ln(LAST_RADIUS / radius)]);
        Ok(Self { weighting, steps, gain, radius })
    }

    /// A constant radius, and a gain that falls from one value to another.
    pub(super) fn constant(steps: u64, gain: [f64; 2], radius: f64) -> Self {
        let gain = [gain[0], ln(gain[1] / gain[0])];
        Self { weighting: Weighting::Gauss, steps: steps.max(1), gain, radius: [radius, 0.0] }
    }

    /// How many steps there are.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Who is a neighbour.
    #[must_use]
    pub fn weighting(&self) -> Weighting {
        self.weighting
    }

    fn share(&self, t: u64) -> f64 {
        t as f64 / self.steps as f64
    }

    /// The gain of step `t`: `0.5 (0.01 / 0.5)^f`.
    #[must_use]
    pub fn gain(&self, t: u64) -> f64 {
        self.gain[0] * exp(self.share(t) * self.gain[1])
    }

    /// The radius of step `t` in neurons: `r0 (0.5 / r0)^f`; of bubbles the whole number `(r0 + 1) (1 - f)^2`.
    #[must_use]
    pub fn radius(&self, t: u64) -> f64 {
        match self.weighting {
            Weighting::Gauss => self.radius[0] * exp(self.share(t) * self.radius[1]),
            Weighting::Bubble => {
                let left = (1.0 - self.share(t)).max(0.0);
                ((self.radius[0] + 1.0) * (left * left)).floor()
            }
        }
    }
}
