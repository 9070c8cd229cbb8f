//! Circles, ellipses, arcs and discs.
//!
//! An ellipse is a quarter that is mirrored: `n` steps of equal angle from the end of the horizontal
//! axis to the end of the vertical one, each rounded to the nearest pixel, with
//! `n = √3 · √(rx² + ry²)`, which leaves no gaps (a step is shorter than a pixel). Steps and rows
//! outside of the screen are not computed.

use super::{Color, HEIGHT, Screen, Stroke, WIDTH, Width};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::RangeInclusive;

/// Halves of pixels, which come at 30 and 60 degrees, are rounded down in x and up in y, whatever the
/// last digits of sine and cosine are.
const TIE: f64 = 1e-7;

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
        ((self.rx * cos - TIE).round() as i64, (self.ry * sin + TIE).round() as i64)
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

/// Ellipses with larger radii than this, in pixels, are not kept.
const KEPT_RADIUS: i32 = 64;
/// How many different ellipses a screen keeps.
const KEPT: usize = 8;

/// The pixels of whole ellipses that were drawn lately: pictures have many equal discs. They belong to the screen, but
/// say nothing of its picture.
#[derive(Clone, Default)]
pub(super) struct Kept(Vec<Whole>);

/// A whole ellipse around (0, 0).
#[derive(Clone)]
struct Whole {
    radii: (i32, i32),
    /// The pixels of a quarter.
    outline: Vec<(i32, i32)>,
    /// The outermost pixel in the rows at distance 0, 1, ... from the centre.
    reaches: Vec<i32>,
}

impl Whole {
    fn new(radii: (i32, i32)) -> Whole {
        let quarter = Quarter::new(radii.0, radii.1);
        // All of them are within the small radii.
        let mut outline: Vec<(i32, i32)> =
            (0..=quarter.steps).map(|step| quarter.pixel(step)).map(|(x, y)| (x as i32, y as i32)).collect();
        outline.dedup();
        let reaches = (0..=quarter.ry as i64).map(|y| quarter.reach(y) as i32).collect();
        Whole { radii, outline, reaches }
    }
}

impl Kept {
    /// A small ellipse, the one kept or a new one. `None` for a large one, which is not worth its memory.
    fn whole(&mut self, radii: (i32, i32)) -> Option<&Whole> {
        if !(1..=KEPT_RADIUS).contains(&radii.0) || !(1..=KEPT_RADIUS).contains(&radii.1) {
            return None;
        }
        let known = self.0.iter().position(|whole| whole.radii == radii);
        let index = known.unwrap_or_else(|| {
            if self.0.len() >= KEPT {
                self.0.remove(0);
            }
            self.0.push(Whole::new(radii));
            self.0.len() - 1
        });
        self.0.get(index)
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
        self.length >= TAU || (angle - self.start + HAIR).rem_euclid(TAU) <= self.length + 2.0 * HAIR
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
        // The centre of what is kept may lie anywhere near the screen, so that sums do not overflow.
        if (-WIDTH..2 * WIDTH).contains(&x) && (-WIDTH..2 * WIDTH).contains(&y) {
            let mut kept = std::mem::take(&mut self.ellipses);
            let whole = kept.whole((rx, ry));
            if let Some(whole) = whole {
                self.filled((x, y), whole, fill, outline);
            }
            let done = whole.is_some();
            self.ellipses = kept;
            if done {
                return;
            }
        }
        let height = quarter.ry as i32;
        for row in y.saturating_sub(height).max(0)..=y.saturating_add(height).min(HEIGHT - 1) {
            let distance = (i64::from(row) - i64::from(y)).abs();
            let reach = quarter.reach(distance).min(i64::from(i32::MAX)) as i32;
            self.span(x.saturating_sub(reach), x.saturating_add(reach), row, fill);
        }
        self.outline(x, y, &quarter, Sweep::FULL, outline);
    }

    /// Draws a small ellipse whose pixels are known.
    fn filled(&mut self, (x, y): (i32, i32), whole: &Whole, fill: Color, outline: Color) {
        for (distance, &reach) in (0..).zip(&whole.reaches) {
            self.span(x - reach, x + reach, y - distance, fill);
            self.span(x - reach, x + reach, y + distance, fill);
        }
        for &(right, down) in &whole.outline {
            for (px, py) in
                [(x + right, y - down), (x - right, y - down), (x - right, y + down), (x + right, y + down)]
            {
                self.set(px, py, outline);
            }
        }
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

#[cfg(test)]
mod tests {
    use super::super::testing::assert_art;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn control_point_disc() {
        let mut screen = Screen::new();
        screen.disc(10, 10, 10, Color::DarkGray, Color::White);
        assert_art(&screen, DISC_10);
    }

    const DISC_10: &str = "
        .......FFFFFFF.......
        .....FFF88888FFF.....
        ...FF88888888888FF...
        ..FF8888888888888FF..
        ..F888888888888888F..
        .F88888888888888888F.
        .F88888888888888888F.
        FF88888888888888888FF
        F8888888888888888888F
        F8888888888888888888F
        F8888888888888888888F
        F8888888888888888888F
        F8888888888888888888F
        FF88888888888888888FF
        .F88888888888888888F.
        .F88888888888888888F.
        ..F888888888888888F..
        ..FF8888888888888FF..
        ...FF88888888888FF...
        .....FFF88888FFF.....
        .......FFFFFFF.......";

    #[test]
    fn small_disc_and_dot() {
        let mut screen = Screen::new();
        screen.disc(3, 3, 3, Color::LightGray, Color::White);
        screen.disc(9, 3, 1, Color::LightGray, Color::White);
        assert_art(&screen, DISC_3);
    }

    const DISC_3: &str = "
        ..FFF......
        .F777F.....
        F77777F....
        F77777F..F.
        F77777F....
        .F777F.....
        ..FFF......";

    #[test]
    fn arc_of_the_turning_arrow() {
        let mut screen = Screen::new();
        screen.ellipse(8, 8, 4, 8, 30, 330, Stroke::thin(Color::LightRed));
        assert_art(&screen, ARC);
    }

    const ARC: &str = "
        .......CCC....
        ......C...C...
        .....CC...CC..
        .....C.....C..
        .....C.....C..
        ....C.........
        ....C.........
        ....C.........
        ....C.........
        ....C.........
        ....C.........
        ....C.........
        .....C.....C..
        .....C.....C..
        .....CC...CC..
        ......C...C...
        .......CCC....";

    #[test]
    fn thick_circle_is_three_thin_ones() {
        let (mut thick, mut thin) = (Screen::new(), Screen::new());
        thick.circle(100, 100, 30, Stroke::thick(Color::Green));
        for r in 29..=31 {
            thin.circle(100, 100, r, Stroke::thin(Color::Green));
        }
        assert_eq!(thick, thin);
    }

    #[test]
    fn arcs_make_up_the_circle() {
        let (mut arcs, mut circle) = (Screen::new(), Screen::new());
        let stroke = Stroke::thin(Color::Green);
        for (start, end) in [(-30, 30), (30, 200), (200, 330)] {
            arcs.arc(300, 200, 57, start, end, stroke);
        }
        circle.circle(300, 200, 57, stroke);
        assert_eq!(arcs, circle);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Small discs, whose pixels are kept, have those that are found row by row and step by step.
        #[test]
        fn kept_discs_have_the_pixels_of_new_ones(
            discs in prop::collection::vec((-80..720, -80..560, -1..80, -1..80), 1..12),
        ) {
            let (mut kept, mut anew) = (Screen::new(), Screen::new());
            for (x, y, rx, ry) in discs {
                kept.ellipse_filled(x, y, rx, ry, Color::Red, Color::White);
                let quarter = Quarter::new(rx, ry);
                if quarter.is_dot() {
                    anew.set(x, y, Color::White);
                    continue;
                }
                let height = quarter.ry as i32;
                for row in y - height..=y + height {
                    let reach = quarter.reach(i64::from((row - y).abs())) as i32;
                    anew.span(x - reach, x + reach, row, Color::Red);
                }
                anew.outline(x, y, &quarter, Sweep::FULL, Color::White);
            }
            prop_assert!(kept == anew);
        }

        /// Shifting an ellipse out of the screen cuts it and changes nothing else.
        #[test]
        fn clipping_only_cuts(
            x in -300..900, y in -300..700, rx in 0..200, ry in 0..200, start in 0..360, end in 0..360,
        ) {
            let (mut whole, mut cut) = (Screen::new(), Screen::new());
            whole.ellipse_filled(320, 240, rx, ry, Color::Red, Color::White);
            whole.ellipse(320, 240, rx, ry, start, end, Stroke::thick(Color::Blue));
            cut.ellipse_filled(x, y, rx, ry, Color::Red, Color::White);
            cut.ellipse(x, y, rx, ry, start, end, Stroke::thick(Color::Blue));
            for (px, py) in (0..640).flat_map(|px| (0..480).step_by(3).map(move |py| (px, py))) {
                if let Some(color) = whole.pixel(px - x + 320, py - y + 240) {
                    prop_assert_eq!(cut.pixel(px, py), Some(color));
                }
            }
        }

        /// Every pixel of an outline of any size is within a pixel of the ellipse.
        #[test]
        fn pixels_lie_on_the_circle(x in -9_000_000..9_000_000, toward in 0..640, y in -900..900) {
            let r: i32 = i32::abs(toward - x).max(1);
            let mut screen = Screen::new();
            screen.circle(x, y, r, Stroke::thin(Color::White));
            let mut count = 0;
            for (px, py) in (0..640).flat_map(|px| (0..480).map(move |py| (px, py))) {
                if screen.pixel(px, py) == Some(Color::White) {
                    count += 1;
                    let distance = f64::from(px - x).hypot(f64::from(py - y));
                    prop_assert!((distance - f64::from(r)).abs() < 0.75);
                }
            }
            prop_assert!(count > 0 || !(0..480).contains(&y));
        }

        #[test]
        fn any_ellipse_is_clipped(x: i32, y: i32, rx: i32, ry: i32, start: i32, end: i32) {
            let mut screen = Screen::new();
            screen.ellipse(x, y, rx, ry, start, end, Stroke::thick(Color::White));
            screen.ellipse(x % 1000, y % 1000, rx, ry, start, end, Stroke::thick(Color::White));
            screen.ellipse_filled(x % 1000, y % 1000, rx, ry % 1000, Color::Red, Color::White);
        }
    }
}
