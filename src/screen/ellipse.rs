//! Circles, ellipses, arcs and discs.
//!
//! An ellipse is a quarter that is mirrored: `n` steps of equal angle from the end of the horizontal
//! axis to the end of the vertical one, each rounded to the nearest pixel, with
//! `n = √3 · √(rx² + ry²)`, which leaves no gaps (a step is shorter than a pixel). Steps and rows
//! outside of the screen are not computed.

use super::{Color, HEIGHT, Screen, Stroke, WIDTH, Width};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::RangeInclusive;

/// A quarter of an ellipse around (0, 0).
struct Quarter {
    rx: f64,
    ry: f64,
    steps: i64,
}

impl Quarter {
    /// A quarter with these radii in pixels; those below 1 count as 1.
    fn new(rx: i32, ry: i32) -> Quarter {
        let (rx, ry) = (f64::from(rx.max(1)), f64::from(ry.max(1)));
        Quarter { rx, ry, steps: (3f64.sqrt() * rx.hypot(ry)).round() as i64 }
    }

    /// Whether the ellipse is too small for anything but its centre.
    fn is_dot(&self) -> bool {
        self.rx <= 1.0 && self.ry <= 1.0
    }

    /// Angle of a step in radians.
    fn angle(&self, step: i64) -> f64 {
        FRAC_PI_2 * step as f64 / self.steps as f64
    }

    /// The pixel of a step.
    fn pixel(&self, step: i64) -> (i64, i64) {
        let (sin, cos) = self.angle(step).sin_cos();
        ((self.rx * cos).round_ties_even() as i64, (self.ry * sin).round_ties_even() as i64)
    }

    /// The outermost pixel of the quarter in the row at distance `y` from the centre.
    fn reach(&self, y: i64) -> i64 {
        let sine = ((y as f64 - 0.5) / self.ry).clamp(0.0, 1.0);
        let step = (sine.asin() / FRAC_PI_2 * self.steps as f64).ceil() as i64;
        self.pixel(step.min(self.steps)).0
    }

    /// The steps that may lie in a window: distances from the centre along the two axes, in pixels.
    fn visible(&self, xs: &RangeInclusive<i64>, ys: &RangeInclusive<i64>) -> RangeInclusive<i64> {
        let part = |distance: i64, radius: f64| (distance as f64 / radius).clamp(0.0, 1.0);
        if *xs.end() < 0 || *ys.end() < 0 {
            return RangeInclusive::new(1, 0);
        }
        let first = part(xs.end() + 1, self.rx).acos().max(part(ys.start() - 1, self.ry).asin());
        let last = part(xs.start() - 1, self.rx).acos().min(part(ys.end() + 1, self.ry).asin());
        let step = |angle: f64| (angle / FRAC_PI_2 * self.steps as f64) as i64;
        (step(first) - 1).max(0)..=(step(last) + 2).min(self.steps)
    }
}

/// The angles of an arc in radians: where it begins, and how far it goes counter-clockwise.
#[derive(Clone, Copy)]
struct Sweep {
    start: f64,
    length: f64,
}

impl Sweep {
    const FULL: Sweep = Sweep { start: 0.0, length: TAU };

    fn new(start_deg: i32, end_deg: i32) -> Sweep {
        let length = i64::from(end_deg) - i64::from(start_deg);
        if length.abs() >= 360 {
            return Sweep::FULL;
        }
        let length = length.rem_euclid(360) as f64;
        Sweep { start: f64::from(start_deg.rem_euclid(360)).to_radians(), length: length.to_radians() }
    }

    fn contains(&self, angle: f64) -> bool {
        // A hair's breadth, so that the last step of an arc is not lost to rounding.
        const HAIR: f64 = 1e-9;
        (angle - self.start + HAIR).rem_euclid(TAU) <= self.length + 2.0 * HAIR
    }
}

/// The four mirrorings: factors of x (to the right) and y (upwards), and the angle of a point whose
/// angle in the first quarter is `t`, as `base + sign * t`.
const MIRRORS: [(i64, i64, f64, f64); 4] =
    [(1, 1, 0.0, 1.0), (-1, 1, 0.5, -1.0), (-1, -1, 0.5, 1.0), (1, -1, 1.0, -1.0)];

/// The distances, counted in direction `sign`, from a centre to the pixels of the screen.
fn window(center: i32, sign: i64, size: i32) -> RangeInclusive<i64> {
    let (first, last) = (-i64::from(center), i64::from(size - 1) - i64::from(center));
    if sign > 0 { first..=last } else { -last..=-first }
}

impl Screen {
    /// Draws a circle.
    pub fn circle(&mut self, x: i32, y: i32, r: i32, stroke: Stroke) {
        self.sweep(x, y, (r, r), Sweep::FULL, stroke);
    }

    /// Draws a part of a circle, counter-clockwise between two angles in degrees; 0 is to the right.
    pub fn arc(&mut self, x: i32, y: i32, r: i32, start_deg: i32, end_deg: i32, stroke: Stroke) {
        self.ellipse(x, y, r, r, start_deg, end_deg, stroke);
    }

    /// Draws a part of an ellipse with horizontal and vertical radius `rx` and `ry`, counter-clockwise
    /// from one angle to the other; the whole of it when they are 360 degrees or more apart. Angles
    /// are in degrees, 0 to the right, and are those of the circle that the ellipse is a squeezed
    /// image of. Ellipses are always solid.
    #[expect(
        clippy::too_many_arguments,
        reason = "centre, radii, angles: the ellipse of every graphics library"
    )]
    pub fn ellipse(
        &mut self,
        x: i32,
        y: i32,
        rx: i32,
        ry: i32,
        start_deg: i32,
        end_deg: i32,
        stroke: Stroke,
    ) {
        self.sweep(x, y, (rx, ry), Sweep::new(start_deg, end_deg), stroke);
    }

    /// Draws a filled circle with a thin outline.
    pub fn disc(&mut self, x: i32, y: i32, r: i32, fill: Color, outline: Color) {
        self.ellipse_filled(x, y, r, r, fill, outline);
    }

    /// Draws a filled ellipse with a thin outline.
    pub fn ellipse_filled(&mut self, x: i32, y: i32, rx: i32, ry: i32, fill: Color, outline: Color) {
        let quarter = Quarter::new(rx, ry);
        if quarter.is_dot() {
            return self.set(x, y, outline);
        }
        for row in 0..HEIGHT {
            let distance = (i64::from(row) - i64::from(y)).abs();
            if distance <= quarter.ry as i64 {
                let reach = quarter.reach(distance).min(i64::from(i32::MAX)) as i32;
                self.span(x.saturating_sub(reach), x.saturating_add(reach), row, fill);
            }
        }
        self.outline(x, y, &quarter, Sweep::FULL, outline);
    }

    /// A thick ellipse is three thin ones with radii one pixel apart.
    fn sweep(&mut self, x: i32, y: i32, radii: (i32, i32), sweep: Sweep, stroke: Stroke) {
        let wider: &[i32] = match stroke.width {
            Width::Thin => &[0],
            Width::Thick => &[-1, 0, 1],
        };
        for more in wider {
            let quarter = Quarter::new(radii.0.saturating_add(*more), radii.1.saturating_add(*more));
            if quarter.is_dot() {
                self.set(x, y, stroke.color);
            } else {
                self.outline(x, y, &quarter, sweep, stroke.color);
            }
        }
    }

    fn outline(&mut self, x: i32, y: i32, quarter: &Quarter, sweep: Sweep, color: Color) {
        for (right, up, base, turn) in MIRRORS {
            let (xs, ys) = (window(x, right, WIDTH), window(y, -up, HEIGHT));
            for step in quarter.visible(&xs, &ys) {
                let (dx, dy) = quarter.pixel(step);
                if sweep.contains(TAU * base + turn * quarter.angle(step))
                    && xs.contains(&dx)
                    && ys.contains(&dy)
                {
                    // On the screen, as the windows hold the distances.
                    let (px, py) = (i64::from(x) + right * dx, i64::from(y) - up * dy);
                    self.set(px as i32, py as i32, color);
                }
            }
        }
    }
}
