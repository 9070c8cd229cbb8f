//! What PH curves show of themselves in a figure: the comb of curvature and the plot of speed.

use super::picture::{Figure, Style};
use crate::geometry::ph::{PhCurve, Place};
use crate::geometry::{Closure, ParamCurve, Point};

/// The colour of offsets.
pub const OFFSET_INK: [u8; 3] = [170, 85, 0];
/// The colour of what trimming cuts off.
pub const CUT_INK: [u8; 3] = [200, 0, 0];
const COMB_INK: [u8; 3] = [0, 120, 0];
const SPEED_INK: [u8; 3] = [120, 120, 120];

const COMB_WIDTH: f64 = 0.75;
/// Teeth of the comb a span.
const TEETH: usize = 40;
/// The longest tooth, as a part of the curve's size.
const LONGEST: f64 = 0.15;
/// Steps of the plot of speed a span.
const STEPS: usize = 50;
/// Height of the plot of speed as a part of its width.
const HEIGHT: f64 = 0.12;

impl Figure {
    /// Adds the comb of curvature: teeth along the normal, on the outside of every bend, whose lengths are in proportion
    /// to the curvature, and the line of their tips.
    pub fn plot_comb(&mut self, curve: &PhCurve) {
        let size = curve.bounding_box().map_or(0.0, |bounds| bounds.extent());
        let places: Vec<(Point<2>, Point<2>, f64)> = (0..curve.spans())
            .flat_map(|span| (0..=TEETH).map(move |k| Place { span, u: k as f64 / TEETH as f64 }))
            .filter_map(|place| {
                let point = curve.eval(place.span, place.u)?;
                Some((point, curve.normal(place)?, curve.curvature(place)?))
            })
            .collect();
        let most = places.iter().fold(0.0_f64, |most, (.., curvature)| most.max(curvature.abs()));
        let scale = if most > 0.0 { LONGEST * size / most } else { 0.0 };
        let tip = |&(point, normal, curvature): &(Point<2>, Point<2>, f64)| -> Point<2> {
            std::array::from_fn(|d| point[d] - scale * curvature * normal[d])
        };
        let style = Style::line(COMB_INK, COMB_WIDTH);
        for tooth in &places {
            self.polyline(vec![tooth.0, tip(tooth)], Closure::Open, style);
        }
        if places.len() > 1 {
            self.polyline(places.iter().map(tip).collect(), Closure::Open, style);
        }
    }

    /// Adds the plot of the speed over the length in a strip below the curve, as wide as the curve is. The line below it
    /// is speed 0, the strip as high as the largest speed.
    pub fn plot_speed(&mut self, curve: &PhCurve) {
        let Some(bounds) = curve.bounding_box() else { return };
        let size = bounds.extent();
        let (width, height) = ((bounds.max[0] - bounds.min[0]).max(0.5 * size), HEIGHT * size);
        let (left, bottom) = (bounds.min[0], bounds.min[1] - 1.5 * height);
        let total = curve.total_length();
        let places: Vec<[f64; 2]> = (0..curve.spans())
            .flat_map(|span| (0..=STEPS).map(move |k| Place { span, u: k as f64 / STEPS as f64 }))
            .filter_map(|place| Some([curve.length_at(place)?, curve.speed(place)?]))
            .collect();
        let most = places.iter().fold(0.0_f64, |most, [_, speed]| most.max(*speed));
        if !(total > 0.0 && most > 0.0) {
            return;
        }
        let line =
            places.iter().map(|[s, speed]| [left + width * (s / total), bottom + height * (speed / most)]);
        self.polyline(line.collect(), Closure::Open, Style::line(SPEED_INK, 1.0));
        let floor = vec![[left, bottom], [left + width, bottom]];
        self.polyline(floor, Closure::Open, Style::line(SPEED_INK, 0.5));
    }
}
