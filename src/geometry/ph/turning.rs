//! How much a planar segment turns, and what it costs to bend it: turning and rotation in closed form, the energy.

use super::bernstein::eval;
use super::complex::Complex;
use super::quadrature::integral;
use super::segment::PhSegment;
use std::f64::consts::TAU;

impl PhSegment {
    /// How far the tangent turns from `from` to `to` in [0, 1], in radians, to the left positive; any number of whole
    /// turns is in it. Exactly twice the sum of the angles under which the stretch of the axis is seen from the
    /// complex roots of `w`, since the tangent has twice the argument of `w`.
    #[must_use]
    pub fn turning(&self, from: f64, to: f64) -> f64 {
        let seen = |root: Complex| {
            let (a, b) = (Complex::new(from, 0.0) - root, Complex::new(to, 0.0) - root);
            // A root on the axis is a point of zero speed that is passed without turning.
            if a.cross(b) == 0.0 { 0.0 } else { a.angle_to(b) }
        };
        2.0 * complex_roots(self.w()).into_iter().flatten().map(seen).sum::<f64>()
    }

    /// The integral of `|kappa|` over the length, divided by a full turn: the absolute rotation (Choi and Kwon
    /// 2008), from the turning between inflections.
    #[must_use]
    pub fn absolute_rotation(&self) -> f64 {
        let mut ends = self.inflections();
        ends.push(1.0);
        let mut from = 0.0;
        let mut sum = 0.0;
        for to in ends {
            sum += self.turning(from, to).abs();
            from = to;
        }
        sum / TAU
    }

    /// The bending energy: the integral of the squared curvature over the length, in 1/unit. `None` where it is
    /// infinite: where a bent segment has a point of zero speed.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        if self.is_straight() {
            return Some(0.0);
        }
        if self.stops() {
            return None;
        }
        let parts = self.parts();
        let density = |u: f64| {
            let (bend, square) = (eval(parts.bend, u), eval(self.w(), u).norm_squared());
            let curved = bend / square;
            4.0 * curved * curved / (parts.step * square)
        };
        Some(integral(&density, [0.0, 1.0], 0.0)).filter(|energy| energy.is_finite())
    }

    /// Whether a point of zero speed makes the energy infinite. There `w` is `(u - u0) v`, and the density grows as
    /// `1 / (u - u0)^2` unless `v` keeps its direction, which makes the whole segment straight.
    fn stops(&self) -> bool {
        complex_roots(self.w()).into_iter().flatten().any(|root| {
            let nearest = Complex::new(root.re.clamp(0.0, 1.0), 0.0);
            (root - nearest).norm() <= 1e-12
        })
    }
}

/// The roots of a complex polynomial of degree 1 or 2 in Bernstein form. A leading coefficient that is a rounding
/// error of zero is left out.
fn complex_roots(w: &[Complex]) -> [Option<Complex>; 2] {
    let (c, b, a) = match *w {
        [p, q] => (p, q - p, Complex::default()),
        [p, q, r] => (p, (q - p) * 2.0, (p - q) + (r - q)),
        _ => return [None; 2],
    };
    let largest = w.iter().fold(0.0_f64, |most, value| most.max(value.norm()));
    let small = |value: Complex| value.norm() <= 1e-14 * largest;
    if small(a) {
        let root = if small(b) { None } else { Some(-c / b) };
        return [root, None];
    }
    // The sign of the root that does not cancel with b.
    let root = (b * b - a * c * 4.0).sqrt();
    let root = if b.dot(root) < 0.0 { -root } else { root };
    let q = (b + root) * -0.5;
    if q.norm() == 0.0 {
        return [Some(Complex::default()); 2];
    }
    [Some(q / a), Some(c / q)]
}

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, point, quintic};
    use super::*;
    use crate::geometry::arclen::integrate;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_speed_is_the_length_of_the_derivative(segment in quintic(), u in 0.0..1.0) {
            let [_, first, second] = segment.at(u);
            let length = first[0].hypot(first[1]);
            let size = segment.speed_coefficients().iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            prop_assert!((segment.speed(u) - length).abs() < 1e-14 * size);
            prop_assert!((eval(segment.speed_coefficients(), u) - length).abs() < 1e-14 * size);
            let curvature = (first[0] * second[1] - first[1] * second[0]) / length.powi(3);
            let got = segment.curvature(u).unwrap();
            prop_assert!((got - curvature).abs() <= 1e-10 * curvature.abs().max(1.0 / length), "{} {}", got, curvature);
            let normal = segment.normal(u).unwrap();
            prop_assert!(distance(normal, [-first[1] / length, first[0] / length]) < 1e-12);
        }

        #[test]
        fn derivatives_agree_with_differences(segment in quintic(), u in 0.01..0.99) {
            let h = 1e-5;
            let [[_, first, second], [before, slope_before, _], [after, slope_after, _]] =
                [u, u - h, u + h].map(|u| segment.at(u));
            for d in 0..2 {
                prop_assert!(((after[d] - before[d]) / (2.0 * h) - first[d]).abs() < 1e-4);
                prop_assert!(((slope_after[d] - slope_before[d]) / (2.0 * h) - second[d]).abs() < 1e-2);
            }
            let [before, after] = [u - h, u + h].map(|u| segment.curvature(u).unwrap());
            let slope = segment.curvature_slope(u).unwrap();
            let by_difference = (after - before) / (2.0 * h);
            prop_assert!((slope - by_difference).abs() < 1e-4 * slope.abs().max(1.0), "{} {}", slope, by_difference);
        }

        #[test]
        fn turning_and_energy_agree_with_quadrature(segment in quintic(), from in 0.0..1.0, to in 0.0..1.0) {
            let bend = |u: f64| segment.curvature(u).unwrap() * segment.speed(u);
            prop_assert!((segment.turning(from, to) - integrate(&bend, [from, to], 1e-12)).abs() < 1e-10);
            // Plain midpoint sums: the absolute value has kinks.
            let whole: f64 = (0..4000).map(|k| bend((f64::from(k) + 0.5) / 4000.0).abs() / 4000.0).sum();
            prop_assert!((segment.absolute_rotation() * TAU - whole).abs() < 1e-4 * (1.0 + whole));
            let density = |u: f64| segment.curvature(u).unwrap().powi(2) * segment.speed(u);
            let energy = segment.energy().unwrap();
            let measured = integrate(&density, [0.0, 1.0], 1e-11 * energy);
            prop_assert!((energy - measured).abs() < 1e-9 * energy);
        }

        #[test]
        fn inflections_and_extrema_are_where_a_scan_sees_them(segment in quintic()) {
            let steps = 4000;
            let values: Vec<f64> =
                (0..=steps).map(|k| segment.curvature(f64::from(k) / f64::from(steps)).unwrap()).collect();
            let near = |found: &[f64], k: usize| {
                found.iter().any(|u| (u * f64::from(steps) - k as f64).abs() < 2.5)
            };
            let (inflections, extrema) = (segment.inflections(), segment.curvature_extrema());
            prop_assert!(inflections.len() <= 2 && extrema.len() <= 5);
            for (k, pair) in values.windows(2).enumerate() {
                prop_assert!(pair[0] * pair[1] >= 0.0 || near(&inflections, k));
            }
            let noise = values.iter().fold(0.0_f64, |most, value| most.max(value.abs())) * 1e-12;
            for (k, three) in values.windows(3).enumerate() {
                let (before, after) = (three[1] - three[0], three[2] - three[1]);
                let turns = before * after < 0.0 && before.abs().min(after.abs()) > noise;
                prop_assert!(!turns || near(&extrema, k + 1), "{} {:?}", k, extrema);
            }
        }

        #[test]
        fn any_ends_give_numbers(a in point(), b in point(), c in point(), d in point(), exponent in -70_i32..70) {
            let scale = 10.0_f64.powi(exponent);
            let [a, b, c, d] = [a, b, c, d].map(|p| p.map(|x| x * scale));
            let (four, _) = PhSegment::hermite([a, b], [c, d]).unwrap();
            for segment in four {
                let numbers = [segment.turning(0.0, 1.0), segment.absolute_rotation(), segment.speed(0.5)];
                prop_assert!(numbers.iter().all(|x| x.is_finite()));
                prop_assert!(segment.energy().is_none_or(f64::is_finite));
            }
        }
    }

    #[test]
    fn points_of_zero_speed_have_no_energy_but_turning() {
        let chord = [[0.0, 0.0], [100.0, 0.0]];
        let (four, number) = PhSegment::hermite(chord, [[0.0, 0.0], [50.0, 80.0]]).unwrap();
        for segment in &four {
            assert_eq!((segment.energy(), segment.curvature(0.0), segment.normal(0.0)), (None, None, None));
            assert!(segment.turning(0.0, 1.0).is_finite());
        }
        // All energies are infinite, so the one that turns least is taken.
        let least = four.iter().map(PhSegment::absolute_rotation).fold(f64::INFINITY, f64::min);
        assert!(four[number].absolute_rotation() <= least * (1.0 + 1e-9));
    }

    #[test]
    fn straight_segments_have_no_energy_inflections_or_extrema() {
        let (four, number) =
            PhSegment::hermite([[1.0, 2.0], [31.0, 42.0]], [[6.0, 8.0], [9.0, 12.0]]).unwrap();
        let segment = &four[number];
        assert!(segment.energy() == Some(0.0) && segment.absolute_rotation() < 1e-15);
        assert!(segment.inflections().is_empty() && segment.curvature_extrema().is_empty());
    }
}
