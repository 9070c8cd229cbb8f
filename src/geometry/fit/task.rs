//! The fit as a task that advances by a budget of points.

use super::axis::Axis;
use super::chart::Chart;
use super::cholesky::Cholesky;
use super::equations::Sums;
use super::frame::Frame;
use super::gradients::Gradients;
use super::orientation::side;
use super::sheet::{Foot, Sheet};
use super::{FitError, Fitted, Report, fitted};
use crate::geometry::cloud::Cloud;
use crate::geometry::kohonen::{KohonenError, Net, Topology};
use crate::geometry::{BoundingBox, Point};

/// The most control points for which a band is decomposed.
const MOST_BANDED: usize = 2500;
/// A correction that makes the root mean square less than this part smaller is the last.
const LEAST_GAIN: f64 = 0.01;

/// What a fit is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Step 1: parameters from the net.
    Parameters,
    /// Step 2: the equations are gathered.
    Equations,
    /// Step 2: they are solved.
    Solution,
    /// Step 3: parameters are corrected, and distances measured.
    Correction,
    /// All is done.
    Done,
}

#[derive(Clone, Debug)]
enum Work {
    Parameters(Box<Chart>),
    Equations,
    Banded(Box<Cholesky>),
    Gradients(Box<Gradients>),
    Correction,
    Distances(Option<Box<Chart>>),
    Done(Report),
}

/// The least squares fit of the surface of a net to a cloud (after Hoffmann and Várady 1997).
///
/// Every point `p_r` gets parameters by the net. Then the control points `C` are those that make
/// `sum |s(u_r, v_r) - p_r|^2 + mu N |D C|^2` least, where `D` are the second differences along rows and columns, `N` is the
/// number of points and `mu` 1e-6; then parameters are corrected by two steps of Gauss and Newton each, and so on. At the end
/// every point looks for its foot once more, from where it is and by the surface as the chart: near a border it may have
/// got stuck.
///
/// It depends on cloud, net and corrections only, never on how it is divided into budgets.
#[derive(Clone, Debug)]
pub struct Fit {
    cloud: Cloud,
    topology: Topology,
    axes: [Axis; 2],
    frame: Frame,
    /// The control points in the order of the net, in the unit of the frame.
    nodes: Vec<Point<3>>,
    sheet: Sheet,
    parameters: Vec<[f64; 2]>,
    distances: Vec<f64>,
    sums: Sums,
    work: Work,
    /// The next point of the present pass, and the sum of the squares of the distances in it.
    next: usize,
    squares: f64,
    corrections: usize,
    history: Vec<f64>,
}

impl Fit {
    /// The default number of corrections.
    pub const CORRECTIONS: usize = 5;

    /// Begins to fit the surface (or curve) of a net to a cloud. After the first solution parameters are corrected and the
    /// equations solved again up to `corrections` times, as long as this gains 1 % or more.
    ///
    /// # Errors
    /// A net that is too small, or fewer points than control points.
    pub fn new(cloud: &Cloud, net: &Net, corrections: usize) -> Result<Self, FitError> {
        let topology = net.topology();
        let axes = fitted::axes(topology, net.size())?;
        let [m, n] = net.size();
        let poles = topology == Topology::Sphere && n > 1;
        let (given, needed) = (cloud.points().len(), if poles { (m - 2) * n + 2 } else { m * n });
        if given < needed {
            return Err(FitError::TooFewPoints { given, needed });
        }
        let neurons = net.rows();
        let around = BoundingBox::around(neurons.iter().flatten().copied());
        let bounds = cloud.bounds();
        let frame = Frame::new(around.map_or(bounds, |around| bounds.union(around)));
        let neurons: Vec<Vec<Point<3>>> =
            neurons.iter().map(|row| row.iter().map(|point| frame.inside(*point)).collect()).collect();
        let nodes = neurons.concat();
        // The net was one before it was scaled.
        let chart = Chart::new(&axes, topology, &neurons).map_err(|_| FitError::Net { given: net.size() })?;
        Ok(Self {
            sheet: Sheet::new(&axes, &nodes),
            sums: Sums::new(&axes),
            cloud: cloud.clone(),
            topology,
            axes,
            frame,
            nodes,
            parameters: Vec::with_capacity(given),
            distances: vec![0.0; given],
            work: Work::Parameters(Box::new(chart)),
            next: 0,
            squares: 0.0,
            corrections,
            history: Vec::new(),
        })
    }

    /// Works on about so many points; the report when all is done.
    pub fn advance(&mut self, points: usize) -> Option<&Report> {
        let mut left = points;
        while left > 0 && !matches!(self.work, Work::Done(_)) {
            left = left.saturating_sub(self.work_on(left));
        }
        self.report()
    }

    /// Works on the next piece, of some of so many points; what it cost.
    fn work_on(&mut self, most: usize) -> usize {
        let end = self.cloud.points().len().min(self.next.saturating_add(most));
        let range = self.next..end;
        let points = self.cloud.points().get(range.clone()).unwrap_or_default();
        match &mut self.work {
            Work::Parameters(chart) => {
                let (axes, frame) = (&self.axes, &self.frame);
                self.parameters.extend(points.iter().map(|p| chart.parameters(axes, frame.inside(*p))));
            }
            Work::Equations => {
                for (point, parameters) in points.iter().zip(&self.parameters[range.clone()]) {
                    self.sums.add(&self.axes, *parameters, self.frame.inside(*point));
                }
            }
            Work::Banded(cholesky) => {
                let cost = cholesky.cost();
                if let Some(moves) = cholesky.advance() {
                    self.solved(&moves);
                }
                return cost;
            }
            Work::Gradients(gradients) => {
                let cost = gradients.cost();
                if let Some(moves) = gradients.advance(&self.axes) {
                    self.solved(&moves);
                }
                return cost;
            }
            Work::Correction => {
                let at = self.parameters[range.clone()].iter_mut().zip(&mut self.distances[range.clone()]);
                for (point, at) in points.iter().zip(at) {
                    let foot = self.sheet.foot(self.frame.inside(*point), *at.0);
                    self.squares += noted(&foot, &self.frame, at);
                }
            }
            Work::Distances(chart) => {
                let at = self.parameters[range.clone()].iter_mut().zip(&mut self.distances[range.clone()]);
                for (point, at) in points.iter().zip(at) {
                    let point = self.frame.inside(*point);
                    let mut foot = self.sheet.settled(point, *at.0);
                    if let Some(chart) = chart {
                        let other = self.sheet.settled(point, chart.parameters(&self.axes, point));
                        if other.distance.abs() < foot.distance.abs() {
                            foot = other;
                        }
                    }
                    self.squares += noted(&foot, &self.frame, at);
                }
            }
            Work::Done(_) => return most,
        }
        self.next = end;
        if end == self.cloud.points().len() {
            self.next = 0;
            self.pass_is_over();
        }
        range.len().max(1)
    }

    /// After the last point.
    fn pass_is_over(&mut self) {
        self.work = match &self.work {
            Work::Parameters(_) => Work::Equations,
            Work::Equations => {
                let equations = self.sums.equations(&self.axes, &self.nodes);
                self.sums.clear();
                let closed = self.axes.iter().any(Axis::closed);
                if closed || self.nodes.len() > MOST_BANDED {
                    let poles = self.topology == Topology::Sphere && !self.axes[1].is_point();
                    Work::Gradients(Box::new(Gradients::new(&self.axes, equations, poles)))
                } else {
                    Work::Banded(Box::new(Cholesky::new(&self.axes, &equations)))
                }
            }
            Work::Correction => {
                let rms = self.root_mean_square();
                let gained = self.history.last().is_none_or(|last| rms < (1.0 - LEAST_GAIN) * last);
                self.history.push(rms);
                if gained && self.history.len() <= self.corrections {
                    Work::Equations
                } else {
                    Work::Distances(self.chart_of_surface().map(Box::new))
                }
            }
            Work::Distances(_) => {
                let rms = self.root_mean_square();
                if let Some(last) = self.history.last_mut() {
                    *last = rms;
                }
                let side = side(&self.axes, &self.sheet);
                self.distances.iter_mut().for_each(|distance| *distance *= side);
                Work::Done(Report::new(&self.distances, self.history.clone()))
            }
            _ => return,
        };
    }

    /// Of the distances of a pass, in the unit of the points.
    fn root_mean_square(&mut self) -> f64 {
        let squares = std::mem::take(&mut self.squares);
        self.frame.length((squares / self.cloud.points().len().max(1) as f64).sqrt())
    }

    /// The chart of the surface as it is; `None` if its places are no net.
    fn chart_of_surface(&self) -> Option<Chart> {
        let [m, n] = self.axes.each_ref().map(Axis::count);
        let place = |i: usize, j: usize| {
            self.sheet.at([self.axes[0].parameter(i, 0.0), self.axes[1].parameter(j, 0.0)]).point
        };
        let rows: Vec<Vec<Point<3>>> = (0..m).map(|i| (0..n).map(|j| place(i, j)).collect()).collect();
        Chart::new(&self.axes, self.topology, &rows).ok()
    }

    /// Moves the control points.
    fn solved(&mut self, moves: &[Point<3>]) {
        for (node, by) in self.nodes.iter_mut().zip(moves) {
            *node = std::array::from_fn(|d| node[d] + by[d]);
        }
        self.sheet = Sheet::new(&self.axes, &self.nodes);
        self.work = Work::Correction;
        self.next = 0;
    }

    /// The surface as it is now: before the first solution that of the net.
    ///
    /// # Errors
    /// Control points beyond what coordinates may be.
    pub fn fitted(&self) -> Result<Fitted, FitError> {
        let nodes: Vec<Point<3>> = self.nodes.iter().map(|node| self.frame.outside(*node)).collect();
        Fitted::of(&self.axes, &nodes)
    }

    /// The control points as they are now, in the order of the net.
    ///
    /// # Errors
    /// As [`Fit::fitted`].
    pub fn net(&self) -> Result<Net, KohonenError> {
        let point = |node: &Point<3>| self.frame.outside(*node);
        let rows: Vec<Vec<Point<3>>> =
            self.nodes.chunks(self.axes[1].count()).map(|row| row.iter().map(point).collect()).collect();
        Net::new(self.topology, &rows)
    }

    /// The parameters of the points in their order, from 0 to 1; as many as have any yet.
    #[must_use]
    pub fn parameters(&self) -> &[[f64; 2]] {
        &self.parameters
    }

    /// The signed distances of the points in their order, in their unit, when all is done; before that those of the last
    /// correction, with signs that may still change, or zeros. What is closed has positive distances outside; of other
    /// surfaces above is where the mean normal points to, taken so that its largest coordinate is positive.
    #[must_use]
    pub fn distances(&self) -> &[f64] {
        &self.distances
    }

    /// What the fit is at.
    #[must_use]
    pub fn stage(&self) -> Stage {
        match self.work {
            Work::Parameters(_) => Stage::Parameters,
            Work::Equations => Stage::Equations,
            Work::Banded(_) | Work::Gradients(_) => Stage::Solution,
            Work::Correction | Work::Distances(_) => Stage::Correction,
            Work::Done(_) => Stage::Done,
        }
    }

    /// The root mean square distances after the solutions so far, in the unit of the points; one more after every
    /// correction.
    #[must_use]
    pub fn history(&self) -> &[f64] {
        &self.history
    }

    /// How much is done, from 0 to 1, by the passes through the points. It jumps to 1 if corrections gain no more.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let part = self.next as f64 / self.cloud.points().len().max(1) as f64;
        let before = 3.0 * self.history.len() as f64;
        // The first parameters take about as long as a correction, the equations half as long.
        let all = 2.0 + 3.0 * (self.corrections as f64 + 1.0) + 4.0;
        let passes = match self.work {
            Work::Parameters(_) => 2.0 * part,
            Work::Equations => before + 2.0 + part,
            Work::Banded(_) | Work::Gradients(_) => before + 3.0,
            Work::Correction => before + 3.0 + 2.0 * part,
            Work::Distances(_) => all - 4.0 + 4.0 * part,
            Work::Done(_) => return 1.0,
        };
        passes / all
    }

    /// The report, when all is done.
    #[must_use]
    pub fn report(&self) -> Option<&Report> {
        match &self.work {
            Work::Done(report) => Some(report),
            _ => None,
        }
    }
}

/// Notes the foot of a point as its parameters and its distance; the square of this in the unit of the frame.
fn noted(foot: &Foot, frame: &Frame, (parameters, distance): (&mut [f64; 2], &mut f64)) -> f64 {
    *parameters = foot.parameters;
    *distance = frame.length(foot.distance);
    foot.distance * foot.distance
}
