//! All hits within one step, exactly and in the order of their times.
//!
//! Every ball is entered into the cells of a grid that it can sweep over until the end of the step, so that
//! only balls with a cell in common are compared: the work grows with the number of balls, not with its
//! square. The hits found wait in a queue; the earliest one is carried out, which makes what was found for
//! its balls void, and their new ways are entered and compared again.
//!
//! Hits of balls at the same moment are solved together where they have a ball in common, so that what is symmetric
//! stays symmetric. What these hits pass on in a cluster of touching balls is hit next, until no ball approaches
//! another, which ends after finitely many hits.
//! Should rounding ever make a cluster rattle on, the step ends early, with nothing lost but its remaining
//! time.

use super::aim::Obstacle;
use super::collide::{SAME_MOMENT, hit_together, hit_wall, minus, moved, time_to_touch, time_to_wall};
use super::{Ball, Field, Hit, RADIUS, Surface, Vector, Wall};
use std::cmp::{Ordering, Reverse};
use std::collections::{BTreeSet, BinaryHeap};

/// Up to so many balls, comparing all is faster than looking into cells.
const FEW: usize = 24;
/// More hits than this for each ball in one step are rattling.
const MOST_HITS: usize = 1000;
/// How much larger than exact the swept boxes are, in pixels, for the rounding of the places in them.
const MARGIN: f64 = 1e-3;
/// The end of a cell's list.
const NONE: u32 = u32::MAX;

/// Lets balls roll for some seconds without slowing down.
pub(super) fn roll(
    field: &Field,
    surface: Surface,
    balls: &mut [Ball],
    seconds: f64,
    mut seen: impl FnMut(Hit),
) {
    let mut sweep = Sweep::new(field, balls, seconds);
    (0..sweep.balls.len()).for_each(|ball| sweep.foresee(ball, 0.0));
    let most = MOST_HITS.saturating_mul(sweep.balls.len());
    let mut hits = 0;
    let mut end = seconds;
    while let Some(Reverse(event)) = sweep.queue.pop() {
        if !sweep.is_valid(&event) {
            continue;
        }
        if hits >= most {
            end = event.time;
            break;
        }
        match event.other {
            Other::Wall(wall) => {
                hits += 1;
                sweep.hit_wall(event.time, event.ball, wall, surface);
                seen(Hit { time: event.time, ball: event.ball, obstacle: Obstacle::Wall(wall) });
            }
            Other::Ball { ball, .. } => {
                let pairs = sweep.pairs_at_the_moment(event.time, [event.ball, ball]);
                for pairs in connected(pairs) {
                    hits += pairs.len();
                    sweep.hit_balls(event.time, &pairs, surface);
                    pairs.iter().for_each(|&[ball, other]| {
                        seen(Hit { time: event.time, ball, obstacle: Obstacle::Ball(other) });
                    });
                }
            }
        }
    }
    sweep.finish(end);
}

/// What a hit meets, ordered for hits at the same time: walls first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Other {
    Wall(Wall),
    Ball { ball: usize, version: u32 },
}

/// A hit that will happen unless one of its balls is hit before.
#[derive(Clone, Copy, Debug)]
struct Event {
    time: f64,
    ball: usize,
    version: u32,
    other: Other,
}

impl Ord for Event {
    fn cmp(&self, other: &Event) -> Ordering {
        let rest = |event: &Event| (event.ball, event.other, event.version);
        self.time.total_cmp(&other.time).then_with(|| rest(self).cmp(&rest(other)))
    }
}

impl PartialOrd for Event {
    fn partial_cmp(&self, other: &Event) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Event {
    fn eq(&self, other: &Event) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Event {}

/// What the sweep knows of a ball beside its state.
#[derive(Clone, Copy, Default)]
struct Track {
    /// The time at which the ball is where its state says.
    since: f64,
    /// How often it was hit.
    version: u32,
    /// The cells of its present way: first and last column, first and last row.
    cells: [[u32; 2]; 2],
}

struct Sweep<'a> {
    field: &'a Field,
    balls: &'a mut [Ball],
    tracks: Vec<Track>,
    seconds: f64,
    grid: Grid,
    queue: BinaryHeap<Reverse<Event>>,
}

impl<'a> Sweep<'a> {
    fn new(field: &'a Field, balls: &'a mut [Ball], seconds: f64) -> Sweep<'a> {
        let tracks = vec![Track::default(); balls.len()];
        let grid = Grid::new(field, balls.len());
        Sweep { field, balls, tracks, seconds, grid, queue: BinaryHeap::new() }
    }

    /// Where a ball is at a time.
    fn place(&self, ball: usize, now: f64) -> Vector {
        moved(self.balls[ball].at, self.balls[ball].velocity, now - self.tracks[ball].since)
    }

    /// Finds the hits of a ball with walls and with the balls entered so far, and enters its own way.
    fn foresee(&mut self, ball: usize, now: f64) {
        let at = self.place(ball, now);
        let velocity = self.balls[ball].velocity;
        let version = self.tracks[ball].version;
        let left = self.seconds - now;
        if let Some((time, wall)) = time_to_wall(self.field, at, velocity, left) {
            let event = Event { time: now + time, ball, version, other: Other::Wall(wall) };
            self.queue.push(Reverse(event));
        }
        if self.grid.is_one_cell() {
            // At the start, pairs are found by the one with the larger number.
            let others = if version == 0 { ball } else { self.balls.len() };
            (0..others).filter(|&other| other != ball).for_each(|other| {
                self.foresee_pair(ball, at, other, now);
            });
            return;
        }
        let end = moved(at, velocity, left);
        let cells =
            [0, 1].map(|axis| self.grid.range(axis, at[axis].min(end[axis]), at[axis].max(end[axis])));
        self.tracks[ball].cells = cells;
        for row in cells[1][0]..=cells[1][1] {
            for column in cells[0][0]..=cells[0][1] {
                self.compare_in_cell(ball, at, [column, row], now);
                self.grid.enter(column, row, ball);
            }
        }
    }

    /// Finds the hits of a ball with those entered into a cell.
    fn compare_in_cell(&mut self, ball: usize, at: Vector, cell: [u32; 2], now: f64) {
        let cells = self.tracks[ball].cells;
        let mut entry = self.grid.first(cell[0], cell[1]);
        while let Some(&Entry { ball: other, next }) = self.grid.entries.get(entry as usize) {
            entry = next;
            let theirs = self.tracks[other].cells;
            // Pairs with several cells in common are compared in the first of them.
            let first = cell == [0, 1].map(|axis| cells[axis][0].max(theirs[axis][0]));
            if first && other != ball {
                self.foresee_pair(ball, at, other, now);
            }
        }
    }

    fn foresee_pair(&mut self, ball: usize, at: Vector, other: usize, now: f64) {
        let apart = minus(self.place(other, now), at);
        let velocity = minus(self.balls[other].velocity, self.balls[ball].velocity);
        let Some(time) = time_to_touch(apart, velocity) else { return };
        if now + time <= self.seconds {
            let (ball, other) = (ball.min(other), ball.max(other));
            let version = self.tracks[ball].version;
            let other = Other::Ball { ball: other, version: self.tracks[other].version };
            self.queue.push(Reverse(Event { time: now + time, ball, version, other }));
        }
    }

    /// Whether none of an event's balls was hit since it was foreseen.
    fn is_valid(&self, event: &Event) -> bool {
        let same = |ball: usize, version| self.tracks[ball].version == version;
        same(event.ball, event.version)
            && match event.other {
                Other::Wall(_) => true,
                Other::Ball { ball, version } => same(ball, version),
            }
    }

    /// Brings a ball to the place of a hit, which makes what was foreseen for it void.
    fn bring(&mut self, ball: usize, now: f64) {
        self.balls[ball].at = self.place(ball, now);
        let track = &mut self.tracks[ball];
        track.since = now;
        track.version = track.version.wrapping_add(1);
    }

    /// All pairs of balls that hit each other at the moment of a first one.
    fn pairs_at_the_moment(&mut self, time: f64, first: [usize; 2]) -> Vec<[usize; 2]> {
        let mut pairs = vec![first];
        let mut walls = Vec::new();
        while let Some(Reverse(event)) = self.queue.peek().copied()
            && event.time <= time + SAME_MOMENT
        {
            self.queue.pop();
            match event.other {
                _ if !self.is_valid(&event) => {}
                Other::Wall(_) => walls.push(Reverse(event)),
                // A pair may have been foreseen from both sides.
                Other::Ball { ball, .. } if pairs.contains(&[event.ball, ball]) => {}
                Other::Ball { ball, .. } => pairs.push([event.ball, ball]),
            }
        }
        self.queue.extend(walls);
        pairs
    }

    /// Carries out hits of balls at the same moment.
    fn hit_balls(&mut self, now: f64, pairs: &[[usize; 2]], surface: Surface) {
        let balls: BTreeSet<usize> = pairs.iter().flatten().copied().collect();
        let numbers: Vec<usize> = balls.into_iter().collect();
        numbers.iter().for_each(|&ball| self.bring(ball, now));
        let mut hit: Vec<Ball> = numbers.iter().map(|&ball| self.balls[ball]).collect();
        let place = |ball: usize| numbers.partition_point(|&number| number < ball);
        let pairs: Vec<[usize; 2]> = pairs.iter().map(|pair| pair.map(place)).collect();
        hit_together(&mut hit, &pairs, surface);
        numbers.iter().zip(hit).for_each(|(&ball, hit)| self.balls[ball] = hit);
        numbers.iter().rev().for_each(|&ball| self.foresee(ball, now));
    }

    fn hit_wall(&mut self, now: f64, ball: usize, wall: Wall, surface: Surface) {
        self.bring(ball, now);
        hit_wall(self.field, &mut self.balls[ball], wall, surface);
        self.foresee(ball, now);
    }

    /// Brings all balls to the end of the step.
    fn finish(self, end: f64) {
        for (ball, track) in self.balls.iter_mut().zip(&self.tracks) {
            let at = moved(ball.at, ball.velocity, end - track.since);
            // A wall that is reached at the very end may be passed by rounding.
            ball.at = [0, 1].map(|axis| at[axis].clamp(self.field.min[axis], self.field.max[axis]));
        }
    }
}

/// The pairs in groups that have no ball in common with another group.
fn connected(mut pairs: Vec<[usize; 2]>) -> Vec<Vec<[usize; 2]>> {
    let mut groups = Vec::new();
    while let Some(first) = pairs.first().copied() {
        let mut balls = BTreeSet::from(first);
        let mut group = Vec::new();
        loop {
            let near = |pair: &[usize; 2]| pair.iter().any(|ball| balls.contains(ball));
            let (joined, rest): (Vec<_>, Vec<_>) = pairs.into_iter().partition(near);
            pairs = rest;
            if joined.is_empty() {
                break;
            }
            balls.extend(joined.iter().flatten());
            group.extend(joined);
        }
        groups.push(group);
    }
    groups
}

/// One ball in the list of a cell.
#[derive(Clone, Copy)]
struct Entry {
    ball: usize,
    next: u32,
}

/// The cells of the field with the balls that can be in them.
struct Grid {
    origin: Vector,
    /// Cells a pixel.
    scale: Vector,
    /// Columns and rows.
    size: [u32; 2],
    heads: Vec<u32>,
    entries: Vec<Entry>,
}

impl Grid {
    /// About as many cells as balls, none narrower than a ball.
    fn new(field: &Field, count: usize) -> Grid {
        let extent = minus(field.max, field.min);
        let side = (extent[0] * extent[1] / count.max(1) as f64).sqrt().max(2.0 * RADIUS);
        let cells = |length: f64| {
            // Long thin fields must not have more cells than is sensible; the cast saturates.
            let cells = (length / side) as u32;
            if count <= FEW { 1 } else { cells.clamp(1, 4096) }
        };
        let size = extent.map(cells);
        let scale = [0, 1].map(|axis| f64::from(size[axis]) / extent[axis].max(1.0));
        let mut grid = Grid { origin: field.min, scale, size, heads: Vec::new(), entries: Vec::new() };
        if !grid.is_one_cell() {
            grid.heads = vec![NONE; size[0] as usize * size[1] as usize];
            grid.entries.reserve(2 * count);
        }
        grid
    }

    /// Whether everything is compared with everything; then there are no lists.
    fn is_one_cell(&self) -> bool {
        self.size == [1, 1]
    }

    /// The first and last cell, in one direction, that a ball touches while its centre goes between two
    /// coordinates.
    fn range(&self, axis: usize, low: f64, high: f64) -> [u32; 2] {
        let last = self.size[axis] - 1;
        // The cast saturates: what is left of the field is in the first cell.
        let cell = |x: f64| (((x - self.origin[axis]) * self.scale[axis]) as u32).min(last);
        [cell(low - RADIUS - MARGIN), cell(high + RADIUS + MARGIN)]
    }

    fn index(&self, column: u32, row: u32) -> usize {
        row as usize * self.size[0] as usize + column as usize
    }

    fn first(&self, column: u32, row: u32) -> u32 {
        self.heads[self.index(column, row)]
    }

    fn enter(&mut self, column: u32, row: u32, ball: usize) {
        let index = self.index(column, row);
        // Fewer than 2^32 entries fit into memory; beyond that the list would just end.
        let entry = u32::try_from(self.entries.len()).unwrap_or(NONE);
        self.entries.push(Entry { ball, next: self.heads[index] });
        self.heads[index] = entry;
    }
}
