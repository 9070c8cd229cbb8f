//! Learning as a task that advances by a budget of steps.

use super::growth::{Growth, Turn};
use super::neighbours::{Bell, Neighbours};
use super::net::Search;
use super::{KohonenError, MAX_NEURONS, Net, Schedule, Weighting};
use crate::geometry::cloud::Cloud;
use crate::geometry::{Dice, Point};

/// Steps between two looks at how far the net has moved.
const BLOCK: u64 = 1000;

/// In which order a net is shown the points of its cloud.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Any point at every step, by the random numbers of a seed.
    Random(u64),
    /// As they are listed, from the first again after the last.
    Listed,
}

/// How a net of fixed size learns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// Who is a neighbour.
    pub weighting: Weighting,
    /// The order of the points.
    pub order: Order,
    /// The number of steps; by default 100 for every neuron, in [`Order::Listed`] the number of points.
    pub steps: Option<u64>,
    /// The radius at the start in neurons; by default half the larger number of rows and columns. Take 1 for a start that
    /// has its shape already ([`Net::shaped`]).
    pub radius: Option<f64>,
    /// Learning ends when the neurons have moved in 1000 steps by less than this part of the cloud's diagonal on the
    /// average; 0 for never. [`Order::Listed`] always goes through.
    pub settle: f64,
}

impl Default for Rule {
    /// Gauss, random order of seed 1, a settled net at 1e-4.
    fn default() -> Self {
        let order = Order::Random(1);
        Self { weighting: Weighting::Gauss, order, steps: None, radius: None, settle: 1e-4 }
    }
}

/// Why learning is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All steps are made.
    Steps,
    /// The net hardly moves any more.
    Settled,
}

/// What happened in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Its number `t` in the present stage of learning, from 0.
    pub number: u64,
    /// The index of the point in the cloud.
    pub index: usize,
    /// The point.
    pub point: Point<3>,
    /// The winner: row and column of the neuron that was nearest.
    pub winner: [usize; 2],
    /// The gain.
    pub gain: f64,
    /// The radius in neurons.
    pub radius: f64,
}

/// A net that learns a cloud.
///
/// It depends on cloud, start, rule and the number of steps only, never on how they are divided into budgets. The doubles
/// are the same on every machine; only those of a sphere, as far as its sines and cosines are.
#[derive(Clone, Debug)]
pub struct Learning {
    cloud: Cloud,
    net: Net,
    order: Order,
    dice: Dice,
    schedule: Schedule,
    settle: f64,
    neighbours: Neighbours,
    search: Search,
    growth: Option<Growth>,
    wins: Vec<u64>,
    /// The step within the schedule, and since the very beginning.
    t: u64,
    total: u64,
    last: Option<Step>,
    /// The net at the beginning of the block.
    before: Net,
    /// Sum of the squares of the distances of the winners in this block, and the mean of the block before.
    squares: f64,
    mean: Option<f64>,
    end: Option<End>,
}

impl Learning {
    /// Begins with a net of fixed size.
    ///
    /// # Errors
    /// A wrong number of steps or radius; a negative `settle` or one that is no number.
    pub fn new(cloud: &Cloud, start: Net, rule: Rule) -> Result<Self, KohonenError> {
        let [rows, columns] = start.size();
        let settle = if rule.order == Order::Listed { 0.0 } else { rule.settle };
        if !(settle >= 0.0 && settle.is_finite()) {
            let wanted = "a part of the cloud's diagonal from 0";
            return Err(KohonenError::Parameter { name: "settle", value: settle, wanted });
        }
        let steps = rule.steps.unwrap_or(match rule.order {
            Order::Random(_) => 100 * (rows * columns) as u64,
            Order::Listed => cloud.points().len() as u64,
        });
        let radius = rule.radius.unwrap_or(rows.max(columns) as f64 / 2.0);
        let schedule = Schedule::new(rule.weighting, steps, radius)?;
        let bell = Bell::Of(rule.weighting);
        Ok(Self::with(cloud, start, rule.order, schedule, bell, settle, None))
    }

    /// Begins with a small net that grows: where a neuron wins most often, a row or column is inserted, until there
    /// would be more neurons than the limit. See [`Net::seedling`].
    ///
    /// # Errors
    /// A limit below the number of neurons at the start, or too large.
    pub fn growing(cloud: &Cloud, start: Net, limit: usize, seed: u64) -> Result<Self, KohonenError> {
        let least = start.size().into_iter().product();
        if !(least..=MAX_NEURONS).contains(&limit) {
            return Err(KohonenError::Limit { given: limit, least });
        }
        let (growth, schedule) = Growth::new(limit, &start);
        Ok(Self::with(cloud, start, Order::Random(seed), schedule, Bell::Sum, 0.0, Some(growth)))
    }

    fn with(
        cloud: &Cloud,
        net: Net,
        order: Order,
        schedule: Schedule,
        bell: Bell,
        settle: f64,
        growth: Option<Growth>,
    ) -> Self {
        // Other numbers than those of a start with the same seed.
        let dice = Dice::new(if let Order::Random(seed) = order { !seed } else { 0 });
        let mut learning = Self {
            cloud: cloud.clone(),
            order,
            dice,
            schedule,
            settle,
            neighbours: Neighbours::new(&net, bell),
            search: Search::default(),
            growth,
            wins: Vec::new(),
            t: 0,
            total: 0,
            last: None,
            before: net.clone(),
            net,
            squares: 0.0,
            mean: None,
            end: None,
        };
        learning.forget_wins();
        learning
    }

    fn forget_wins(&mut self) {
        self.wins.clear();
        self.wins.resize(self.net.size().into_iter().product(), 0);
    }

    /// Makes at most so many steps; why learning is over when it is.
    pub fn advance(&mut self, steps: u64) -> Option<End> {
        for _ in 0..steps {
            if self.end.is_some() {
                break;
            }
            self.step();
        }
        self.end
    }

    /// One step: `W += h (x - W)` for every neuron, where `h` is the gain times what a neighbour takes part in.
    fn step(&mut self) {
        let points = self.cloud.points();
        let index = match self.order {
            Order::Random(_) => self.dice.below(points.len()),
            Order::Listed => (self.total % points.len().max(1) as u64) as usize,
        };
        let Some(&point) = points.get(index) else { return };
        let (winner, square) = self.net.search(point, &mut self.search);
        let (gain, radius) = (self.schedule.gain(self.t), self.schedule.radius(self.t));
        self.neighbours.set(winner, gain, radius);
        let [rows, columns] = self.net.size();
        for i in 0..rows {
            if let Some(factors) = self.neighbours.row(i) {
                self.net.pull(i, factors, point);
            }
        }
        if let Some(wins) = self.wins.get_mut(winner[0] * columns + winner[1]) {
            *wins += 1;
        }
        self.last = Some(Step { number: self.t, index, point, winner, gain, radius });
        self.squares += square;
        self.t += 1;
        self.total += 1;
        if self.total.is_multiple_of(BLOCK) {
            self.mean = Some(self.squares / BLOCK as f64);
            self.squares = 0.0;
        }
        if self.t == self.schedule.steps() {
            self.next_stage();
        } else if self.settle > 0.0 && self.t.is_multiple_of(BLOCK) {
            let moved = self.net.mean_distance(&self.before);
            self.before.clone_from(&self.net);
            if moved < self.settle * self.cloud.diagonal() {
                self.end = Some(End::Settled);
            }
        }
    }

    /// After the last step of a schedule: a growing net goes on.
    fn next_stage(&mut self) {
        match self.growth.as_mut().map_or(Turn::Over, |growth| growth.turn(&mut self.net, &self.wins)) {
            Turn::Next(schedule) => {
                self.schedule = schedule;
                self.t = 0;
                self.neighbours = Neighbours::new(&self.net, Bell::Sum);
                self.forget_wins();
            }
            Turn::Over => self.end = Some(End::Steps),
        }
    }

    /// The net as it is now.
    #[must_use]
    pub fn net(&self) -> &Net {
        &self.net
    }

    /// The net at the end, or whenever it is wanted.
    #[must_use]
    pub fn into_net(self) -> Net {
        self.net
    }

    /// What is learnt.
    #[must_use]
    pub fn cloud(&self) -> &Cloud {
        &self.cloud
    }

    /// Gain and radius over the present stage of learning, of which [`Learning::t`] steps are made.
    #[must_use]
    pub fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// The steps made in the present stage; all there are but for growing nets, whose stages are their sizes.
    #[must_use]
    pub fn t(&self) -> u64 {
        self.t
    }

    /// All steps made so far.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.total
    }

    /// How much of learning is done, from 0 to 1. For a growing net a guess: by the steps that its present size and the
    /// ones before take of those up to the limit.
    #[must_use]
    pub fn progress(&self) -> f64 {
        if self.end.is_some() {
            return 1.0;
        }
        let share = self.t as f64 / self.schedule.steps() as f64;
        self.growth.as_ref().map_or(share, |growth| growth.progress(&self.net, share))
    }

    /// Whether the net may still get rows and columns.
    #[must_use]
    pub fn is_growing(&self) -> bool {
        self.growth.as_ref().is_some_and(Growth::is_growing)
    }

    /// Why learning is over, if it is.
    #[must_use]
    pub fn end(&self) -> Option<End> {
        self.end
    }

    /// How often every neuron has won, row by row; of a growing net since the last insertion.
    #[must_use]
    pub fn wins(&self) -> &[u64] {
        &self.wins
    }

    /// The last step.
    #[must_use]
    pub fn last(&self) -> Option<&Step> {
        self.last.as_ref()
    }

    /// The part of the way to the point that every neuron went in the last step, row by row.
    #[must_use]
    pub fn influence(&self) -> Vec<f64> {
        let Some(step) = &self.last else { return vec![0.0; self.wins.len()] };
        let [rows, columns] = self.net.size();
        // A net that has just grown has other neighbours.
        let mut neighbours = self.neighbours.clone();
        neighbours.set(step.winner, step.gain, step.radius);
        let mut row = |i| match neighbours.row(i) {
            Some((share, factors)) => factors.iter().take(columns).map(|factor| share * factor).collect(),
            None => vec![0.0; columns],
        };
        (0..rows).flat_map(&mut row).collect()
    }

    /// The root of the mean squared distance of points from the neurons that won them, over the last thousand steps;
    /// `None` before any step.
    #[must_use]
    pub fn rms(&self) -> Option<f64> {
        let steps = self.total % BLOCK;
        let mean = self.mean.or_else(|| (steps > 0).then(|| self.squares / steps as f64))?;
        Some(mean.sqrt())
    }
}
