//! Shaped curves against tables of 40 digits, printed formulas, and curves that they describe exactly.

mod exact;
mod properties;
mod table;

use super::*;
use crate::geometry::ParamCurve;

/// The largest difference of coordinates.
fn off<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(b).fold(0.0, |off, (a, b)| off.max((a - b).abs()))
}

/// The point at a position.
fn at<const D: usize>(curve: &ShapedCurve<D>, position: f64) -> [f64; D] {
    let (span, x) = curve.basis().place(position);
    curve.eval(span, x).unwrap()
}

#[test]
fn points_are_those_of_the_tables() {
    for case in table::sampled() {
        let curve = ShapedCurve::new(case.family, case.points, case.closed).unwrap();
        for (position, expected) in case.at {
            let got = at(&curve, position);
            assert!(off(got, expected) < 1e-12, "{:?} at {position}: {got:?} {expected:?}", curve.basis());
        }
    }
}

#[test]
fn paths_are_those_of_the_tables() {
    for case in table::ways() {
        let curve = ShapedCurve::new(case.family, case.points, false).unwrap();
        let (values, expected): (Vec<f64>, Vec<[f64; 2]>) = case.steps.into_iter().unzip();
        let (span, x) = curve.basis().place(case.at);
        let path = curve.path(case.parameter, span, x, &values).unwrap();
        assert!(path.iter().zip(&expected).all(|(a, b)| off(*a, *b) < 1e-12), "{:?}", curve.basis());
    }
}

#[test]
fn curves_go_through_targets_by_a_parameter_alone() {
    for (family, points, parameter, target, admissible) in table::targets() {
        let curve = ShapedCurve::new(family, points, false).unwrap();
        let reach = curve.through(parameter, target).unwrap();
        assert_eq!(reach.admissible, admissible, "{:?} {reach:?}", curve.basis());
        let moved = curve.with(parameter, reach.value).unwrap();
        let there = moved.eval(reach.span, reach.x).unwrap();
        assert!(off(there, reach.point) < 1e-12);
        if admissible {
            assert!(off(there, target) < 1e-10, "{:?} {reach:?}", curve.basis());
        }
    }
}

#[test]
fn cyclic_curves_are_elevated_as_in_the_tables() {
    for (points, by, expected) in table::elevated() {
        let raised = elevate_cyclic(&points, by).unwrap();
        assert_eq!(raised.len(), expected.len());
        assert!(raised.iter().zip(&expected).all(|(a, b)| off(*a, *b) < 1e-12), "{raised:?}");
    }
}

#[test]
fn interpolating_curves_pass_their_data() {
    for (family, closed, data) in table::data() {
        let found = interpolate(&family, &data, closed).unwrap();
        assert_eq!(found.points.len(), data.len() + if closed { 0 } else { 2 });
        let curve = found.curve(family, closed).unwrap();
        let joints = curve.joints();
        for (i, datum) in data.iter().enumerate() {
            // A closed curve's joint 0 is at its second point.
            let joint = if closed { joints[(i + data.len() - 1) % data.len()] } else { joints[i] };
            assert!(off(joint, *datum) < 1e-11, "{:?} {i}: {joint:?} {datum:?}", curve.basis());
        }
    }
}
