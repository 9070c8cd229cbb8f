//! The virtual potentiometer (1.5.2): a track with a knob, which the mouse drags and the wheel and keys turn by steps.

use super::Area;
use crate::screen::{Color, Screen, Stroke};

/// A potentiometer for one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// The values at the ends of the track.
    pub range: [f64; 2],
    /// The values that are allowed; they may go beyond the track.
    pub allowed: [f64; 2],
    /// What one step of the wheel changes.
    pub step: f64,
    /// Left and right end of the track, and its height on the screen.
    pub track: (i32, i32, i32),
}

/// How far from the track the mouse takes the knob up.
const REACH: i32 = 6;

impl Slider {
    /// Where the mouse takes the knob up.
    pub fn area(&self) -> Area {
        let (left, right, y) = self.track;
        Area::new(left - REACH, y - REACH, right + REACH, y + REACH)
    }

    /// The value under a pixel, with two decimals; the ends of the track exactly.
    pub fn value_at(&self, x: i32) -> f64 {
        let [low, high] = self.range;
        let (left, right, _) = self.track;
        let part = f64::from(x - left) / f64::from((right - left).max(1));
        match part {
            _ if part <= 0.0 => low,
            _ if part >= 1.0 => high,
            _ => ((100.0 * (low + part * (high - low))).round() / 100.0).clamp(low, high),
        }
    }

    /// Where the knob of a value stands; at an end for values beyond the track.
    pub fn pixel_of(&self, value: f64) -> i32 {
        let [low, high] = self.range;
        let (left, right, _) = self.track;
        let part = ((value - low) / (high - low)).clamp(0.0, 1.0);
        let part = if part.is_nan() { 0.0 } else { part };
        left + (part * f64::from(right - left)).round() as i32
    }

    /// A value some steps further, on the grid of tenths of a step, within what is allowed.
    pub fn stepped(&self, value: f64, steps: f64) -> f64 {
        let grid = self.step / 10.0;
        let next = ((value + steps * self.step) / grid).round() * grid;
        // Decimal steps have no decimal doubles.
        let next = (1e6 * next).round() / 1e6;
        next.clamp(self.allowed[0], self.allowed[1])
    }

    /// Draws the track, and the knob of a value.
    pub fn draw(&self, screen: &mut Screen, value: Option<f64>, thin: bool) {
        let (left, right, y) = self.track;
        let (stroke, radius) =
            if thin { (Stroke::thin(Color::Black), 2) } else { (Stroke::thick(Color::Black), 4) };
        screen.line(left, y, right, y, stroke);
        if let Some(value) = value {
            screen.disc(self.pixel_of(value), y, radius, Color::Yellow, Color::Black);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLIDER: Slider =
        Slider { range: [-25.0, 9.0], allowed: [-900.0, 9.0], step: 0.5, track: (54, 152, 34) };

    #[test]
    fn the_slider_has_exact_ends_and_two_decimals() {
        assert_eq!(SLIDER.value_at(0), -25.0);
        assert_eq!(SLIDER.value_at(600), 9.0);
        let middle = SLIDER.value_at(103);
        assert_eq!(middle, (middle * 100.0).round() / 100.0);
        assert_eq!(SLIDER.pixel_of(-900.0), 54);
        for x in 54..=152 {
            assert!((SLIDER.pixel_of(SLIDER.value_at(x)) - x).abs() <= 1);
        }
    }

    #[test]
    fn steps_stay_on_their_grid_and_within_what_is_allowed() {
        assert_eq!(SLIDER.stepped(0.0, 1.0), 0.5);
        assert_eq!(SLIDER.stepped(0.0, -0.1), -0.05);
        assert_eq!(SLIDER.stepped(8.9, 3.0), 9.0);
        assert_eq!(SLIDER.stepped(-899.9, -1.0), -900.0);
    }
}
