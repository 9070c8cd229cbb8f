//! The motion of the point of VJS: equations (1.1) in fixed steps, with reflection at the walls.
//!
//! Between walls the equations are exact for an acceleration that does not change, so the length of the
//! step is no matter of accuracy. At a wall the moment of contact is computed, and the rest of the step
//! goes on from the wall with the velocity turned round. A point that is only mirrored at the end of the
//! step would gain energy at every bounce against a wall it is pressed to.

use serde::Serialize;

/// Largest distance of the point from the middle of its track, in pixels.
pub(crate) const REACH: f64 = 200.0;
/// Steps in a second.
pub(crate) const STEPS_PER_SECOND: u32 = 1000;
/// Updates of the numbers on the screen per second.
const READINGS_PER_SECOND: u64 = 6;
/// After this many bounces within a step the point stays at the wall; that takes a million pixels a second.
const MOST_BOUNCES: u32 = 16;

/// One direction of the motion: place in pixels from the middle, velocity in pixels a second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Axis {
    pub(crate) place: f64,
    pub(crate) velocity: f64,
}

impl Axis {
    /// The motion by equations (1.1) after a time in seconds, without walls.
    fn free(self, acceleration: f64, time: f64) -> Axis {
        let velocity = self.velocity + acceleration * time;
        Axis { place: self.place + (self.velocity + velocity) * time / 2.0, velocity }
    }

    /// The motion after a time in seconds, walls included.
    pub(crate) fn after(mut self, acceleration: f64, mut time: f64) -> Axis {
        for _ in 0..MOST_BOUNCES {
            let free = self.free(acceleration, time);
            if free.place.abs() <= REACH {
                return free;
            }
            let side = free.place.signum();
            let distance = side * REACH - self.place;
            // v² - v0² = 2 a (x - x0), which rounding must not make negative.
            let square = self.velocity * self.velocity + 2.0 * acceleration * distance;
            let speed = square.max(0.0).sqrt();
            let contact = if distance == 0.0 { 0.0 } else { 2.0 * distance / (self.velocity + side * speed) };
            self = Axis { place: side * REACH, velocity: -side * speed };
            time = (time - contact).clamp(0.0, time);
            if acceleration * side > 0.0 {
                // Pressed to the wall the point comes back to it after every such time, as fast as it left.
                let period = 2.0 * speed / (acceleration * side);
                if period <= time {
                    time = if period > 0.0 { time % period } else { 0.0 };
                }
            }
        }
        Axis { place: self.place.clamp(-REACH, REACH), velocity: self.velocity }
    }
}

/// The numbers on the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Readings {
    /// Whole seconds since the start.
    pub(crate) seconds: u64,
    /// Place, velocity and acceleration, x and y (upwards) each.
    pub(crate) rows: [[f64; 2]; 3],
}

/// The moving point: x grows to the right and y upwards from the middle of the track.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Motion {
    steps: u64,
    axes: [Axis; 2],
    /// The acceleration, in pixels per square second.
    pub(crate) acceleration: [f64; 2],
    readings: Readings,
}

/// The motion for `dump`: seconds, pixels, pixels a second, pixels per square second.
#[derive(Serialize)]
pub(crate) struct Model {
    pub(crate) time: f64,
    pub(crate) position: [f64; 2],
    pub(crate) velocity: [f64; 2],
    pub(crate) acceleration: [f64; 2],
}

impl Motion {
    /// Advances to a number of steps since the start.
    pub(crate) fn run_to(&mut self, steps: u64) {
        while self.steps < steps {
            self.step();
        }
    }

    fn step(&mut self) {
        let time = 1.0 / f64::from(STEPS_PER_SECOND);
        let [x, y] = self.axes;
        let [ax, ay] = self.acceleration;
        self.axes = [x.after(ax, time), y.after(ay, time)];
        self.steps += 1;
        let reading = |steps: u64| steps * READINGS_PER_SECOND / u64::from(STEPS_PER_SECOND);
        if reading(self.steps) > reading(self.steps - 1) {
            self.readings = Readings {
                seconds: self.steps / u64::from(STEPS_PER_SECOND),
                rows: [
                    self.axes.map(|axis| axis.place),
                    self.axes.map(|axis| axis.velocity),
                    self.acceleration,
                ],
            };
        }
    }

    /// The place a part of a step later, 0 to 1.
    pub(crate) fn place(&self, part: f64) -> [f64; 2] {
        let later = |axis: Axis| axis.place + axis.velocity * part / f64::from(STEPS_PER_SECOND);
        self.axes.map(|axis| later(axis).clamp(-REACH, REACH))
    }

    /// The numbers on the screen.
    pub(crate) fn readings(&self) -> Readings {
        self.readings
    }

    /// The motion as it is now.
    pub(crate) fn model(&self) -> Model {
        Model {
            time: self.steps as f64 / f64::from(STEPS_PER_SECOND),
            position: self.axes.map(|axis| axis.place),
            velocity: self.axes.map(|axis| axis.velocity),
            acceleration: self.acceleration,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Energy of a unit mass in the field of the acceleration.
    fn energy(axis: Axis, acceleration: f64) -> f64 {
        axis.velocity * axis.velocity / 2.0 - acceleration * axis.place
    }

    #[test]
    fn free_motion_is_that_of_equations_1_1() {
        let mut motion = Motion { acceleration: [40.0, -30.0], ..Motion::default() };
        motion.run_to(2000);
        let Model { time, position, velocity, .. } = motion.model();
        assert_eq!(time, 2.0);
        for (found, expected) in position.into_iter().chain(velocity).zip([80.0, -60.0, 80.0, -60.0]) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }

    #[test]
    fn a_virtual_hour_keeps_the_energy() {
        for (acceleration, velocity) in [(40.0, 0.0), (3.0, 150.0), (0.0, 77.7), (-1.0, 1e-3)] {
            let start = Axis { place: 0.0, velocity };
            let mut axis = start;
            for _ in 0..3_600_000 {
                axis = axis.after(acceleration, 1e-3);
                assert!(axis.place.abs() <= REACH);
            }
            let (before, after) = (energy(start, acceleration), energy(axis, acceleration));
            assert!((after - before).abs() < 1e-5 * (before.abs() + 1.0), "{acceleration}: {before} {after}");
        }
    }

    #[test]
    fn a_point_at_rest_at_a_wall_stays_there_while_it_is_pressed() {
        let rest = Axis { place: REACH, velocity: 0.0 };
        assert_eq!(rest.after(40.0, 1.0), rest);
        assert!(rest.after(-40.0, 1.0).place < REACH);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(256))]
        #[test]
        fn energy_is_kept_at_the_walls(
            place in -200.0..200.0, velocity in -5000.0..5000.0, acceleration in -40.0..40.0, time in 1e-4..0.1,
        ) {
            let start = Axis { place, velocity };
            let end = start.after(acceleration, time);
            prop_assert!(end.place.abs() <= REACH);
            let scale = 1.0 + energy(start, acceleration).abs();
            prop_assert!((energy(end, acceleration) - energy(start, acceleration)).abs() < 1e-9 * scale);
        }

        #[test]
        fn wild_numbers_stay_finite(
            place in -200.0..200.0, velocity in -1e9..1e9, acceleration in -40.0..40.0,
        ) {
            let end = Axis { place, velocity }.after(acceleration, 1e-3);
            prop_assert!(end.place.abs() <= REACH && end.velocity.is_finite());
        }
    }
}
