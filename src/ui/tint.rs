//! Colours that show how a surface bends, and that tell lines apart.

use crate::geometry::{Point, dot};
use crate::screen::Color;

/// Stripes in an angle of one radian: nineteen from the middle of the surface to its silhouette.
const STRIPES: f64 = 12.0;
/// Borders between stripes up to a right angle.
const BORDERS: usize = 18;
/// Colours of negative curvature from strong to weak, of none, and of positive curvature from weak to strong.
const SADDLE: [Color; 4] = [Color::LightBlue, Color::Blue, Color::LightCyan, Color::Cyan];
const DOME: [Color; 4] = [Color::Brown, Color::Yellow, Color::Red, Color::LightRed];
/// Colours from below to above.
const HEIGHTS: [Color; 6] =
    [Color::Blue, Color::Cyan, Color::Green, Color::Yellow, Color::LightRed, Color::White];
/// Colours of lines that are told apart, in turn, clear on black.
pub(crate) const LINES: [Color; 7] = [
    Color::LightRed,
    Color::LightGreen,
    Color::Yellow,
    Color::LightBlue,
    Color::LightMagenta,
    Color::LightCyan,
    Color::Brown,
];
/// The colour of what does not bend, and of what is not known.
pub(crate) const FLAT: Color = Color::DarkGray;

/// Isophotes: bands of equal angle between the normal and the direction to the viewer.
pub(crate) struct Zebra {
    /// The cosines at which the stripes after the first begin, from the steepest.
    borders: [f64; BORDERS],
}

impl Zebra {
    /// The stripes, ready to colour many places.
    pub(crate) fn new() -> Zebra {
        Zebra { borders: std::array::from_fn(|k| ((k + 1) as f64 / STRIPES).cos()) }
    }

    /// The colour where the surface has this unit normal.
    pub(crate) fn color(&self, normal: Option<Point<3>>, toward: Point<3>) -> Color {
        let Some(normal) = normal else { return FLAT };
        let cosine = dot(normal, toward).abs();
        // Cosines fall while angles grow, and comparing them is quicker.
        let stripe = self.borders.partition_point(|border| cosine <= *border);
        if stripe % 2 == 0 { Color::White } else { Color::Blue }
    }
}

/// Blue where the surface is a saddle, red where it is a dome, grey where it is flat. `relative` is the Gaussian curvature
/// times the square of the surface's size: that of a sphere is 4. The mean curvature times the size does as well.
pub(crate) fn curvature(relative: Option<f64>) -> Color {
    let Some(relative) = relative else { return FLAT };
    let strength = [0.5, 4.0, 32.0, 256.0].iter().filter(|&&limit| relative.abs() > limit).count();
    match strength {
        0 => FLAT,
        strength if relative > 0.0 => DOME[strength.min(4) - 1],
        strength => SADDLE[4 - strength.min(4)],
    }
}

/// Bands of a radius of curvature: red where it is shorter than `reach`, so that an offset so far away folds on one
/// side, then yellow, green, cyan and blue for every doubling.
pub(crate) fn radius(radius: Option<f64>, reach: f64) -> Color {
    let Some(radius) = radius else { return Color::Blue };
    let bands = [Color::LightRed, Color::Yellow, Color::Green, Color::Cyan, Color::Blue];
    let doublings = [1.0, 2.0, 4.0, 8.0].iter().filter(|&&times| radius.abs() > times * reach).count();
    bands[doublings]
}

/// Bands of height; `part` is 0 at the lowest and 1 at the highest point.
pub(crate) fn height(part: f64) -> Color {
    // A cast saturates, and NaN is 0.
    HEIGHTS[((part * HEIGHTS.len() as f64) as usize).min(HEIGHTS.len() - 1)]
}

/// Bands of a weight, from none over a tenth and a half to 1; magenta where it is negative.
pub(crate) fn weight(weight: Option<f64>) -> Color {
    let Some(weight) = weight else { return FLAT };
    if weight <= -0.005 {
        return if weight <= -0.05 { Color::LightMagenta } else { Color::Magenta };
    }
    let bands = [
        FLAT,
        Color::Blue,
        Color::LightBlue,
        Color::Cyan,
        Color::Green,
        Color::LightGreen,
        Color::Yellow,
        Color::LightRed,
        Color::White,
    ];
    bands[[0.005, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8].iter().filter(|&&limit| weight > limit).count()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stripes_are_as_wide_as_angles_say() {
        let zebra = Zebra::new();
        for k in 0..=1570 {
            let angle = f64::from(k) * 1e-3 + 3e-4;
            let normal = [angle.sin(), 0.0, -angle.cos()];
            let white = (angle * STRIPES) as i64 % 2 == 0;
            assert_eq!(zebra.color(Some(normal), [0.0, 0.0, 1.0]) == Color::White, white, "{angle}");
        }
        assert_eq!(zebra.color(None, [0.0, 0.0, 1.0]), FLAT);
    }
}
