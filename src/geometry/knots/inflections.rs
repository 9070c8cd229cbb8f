//! Inflections of a plane curve.

use super::KnotCurve;
use crate::geometry::ParamCurve;

/// Steps of a span between which they are searched.
const STEPS: u32 = 400;

impl KnotCurve<2> {
    /// The signed curvature at a parameter: positive where the curve turns left. `None` outside the domain and where
    /// the curve stands.
    #[must_use]
    pub fn curvature(&self, u: f64) -> Option<f64> {
        let all = self.derivatives(u, 2)?;
        let speed = all[1][0].hypot(all[1][1]);
        let curvature = turning(all[1], all[2]) / (speed * speed * speed);
        curvature.is_finite().then_some(curvature)
    }

    /// The parameters of the inflections: sign changes of `x' y'' - y' x''` over 400 steps a span.
    #[must_use]
    pub fn inflections(&self) -> Vec<f64> {
        let sign = |span: usize, t: f64| {
            self.at(span, t).map_or(0.0, |[_, slope, bend]| {
                let (value, size) = (turning(slope, bend), slope[0].hypot(slope[1]) * bend[0].hypot(bend[1]));
                // Straight parts turn by rounding only.
                if value.abs() <= 1e-12 * size { 0.0 } else { value.signum() }
            })
        };
        let (mut found, mut last) = (Vec::new(), None::<(usize, f64, f64)>);
        for span in 0..self.spans() {
            for t in (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)) {
                let here = sign(span, t);
                if here == 0.0 {
                    continue;
                }
                if let Some((before, from, _)) = last.filter(|(.., other)| *other != here) {
                    let from = if before == span { from } else { 0.0 };
                    let bounds = (0..50).fold([from, t], |[a, b], _| {
                        let middle = 0.5 * (a + b);
                        if sign(span, middle) == here { [a, middle] } else { [middle, b] }
                    });
                    found.extend(self.vector().place(span, bounds[1]).map(|(_, u, _)| u));
                }
                last = Some((span, t, here));
            }
        }
        found
    }
}

fn turning(slope: [f64; 2], bend: [f64; 2]) -> f64 {
    slope[0] * bend[1] - slope[1] * bend[0]
}
