//! The families as the program offers them: keys, names, how many points, and the parameters with their ranges.

use super::form::{Form, is_local};
use crate::file::FamilyName;
use crate::geometry::shaped::{Family, LambdaKind, Lambdas, MAX_EXPONENT, MAX_LAMBDA, OMEGA, Parameter};
use crate::ui::Words;
use std::f64::consts::PI;

/// A family in the list of the command G.
pub(super) struct Kind {
    /// Its key.
    pub(super) key: char,
    pub(super) name: FamilyName,
    /// What it is called on the page.
    pub(super) title: Words,
    /// What the list tells of it.
    pub(super) about: Words,
}

const fn kind(key: char, name: FamilyName, title: [&'static str; 2], about: [&'static str; 2]) -> Kind {
    Kind { key, name, title: Words(title[0], title[1]), about: Words(about[0], about[1]) }
}

/// Every family, in the order of its keys.
pub(super) const KINDS: [Kind; 11] = [
    kind('1', FamilyName::CBezier, ["C-Bézier"; 2], ["4 pont, alpha", "4 points, alpha"]),
    kind('2', FamilyName::CBSpline, ["C-B-spline"; 2], ["alpha"; 2]),
    kind('3', FamilyName::FBezier, ["F-Bézier"; 2], ["4 pont, omega", "4 points, omega"]),
    kind('4', FamilyName::FBSpline, ["F-B-spline"; 2], ["omega"; 2]),
    kind(
        '5',
        FamilyName::TrigBezier,
        ["trig. Bézier"; 2],
        ["n1 + n2 + 1 pont, alpha, beta", "n1 + n2 + 1 points, alpha, beta"],
    ),
    kind('6', FamilyName::Han, ["Han"; 2], ["lambda; pontonként is (F5)", "lambda, also of points (F5)"]),
    kind('7', FamilyName::Alpha, ["alpha-B-spline"; 2], ["lambda; 1: a poligon", "lambda; 1: the polygon"]),
    kind(
        '8',
        FamilyName::Gb,
        ["GB-spline"; 2],
        ["lambda; pontonként is (F5)", "lambda, also of points (F5)"],
    ),
    kind('9', FamilyName::Spb, ["SPB-spline"; 2], ["lambda; 1: a poligon", "lambda; 1: the polygon"]),
    kind(
        '0',
        FamilyName::HanQuadratic,
        ["Han, másodfokú", "Han quadratic"],
        ["lambda -1 és 1 között", "lambda from -1 to 1"],
    ),
    kind(
        'K',
        FamilyName::Cyclic,
        ["ciklikus", "cyclic"],
        ["páratlan számú pont, zárt", "an odd number of points, closed"],
    ),
];

/// What the program offers under a name.
pub(super) fn of_name(name: FamilyName) -> &'static Kind {
    // Every name is in the list; a test says so.
    KINDS.iter().find(|kind| kind.name == name).unwrap_or(&KINDS[0])
}

/// A parameter that the user may turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Knob {
    pub(super) parameter: Parameter,
    pub(super) name: &'static str,
    /// The values of the slider, the series and the paths.
    pub(super) range: [f64; 2],
    /// The values that may be typed.
    pub(super) allowed: [f64; 2],
    /// A step of the wheel.
    pub(super) step: f64,
}

/// The smallest alpha of C-curves that is offered; 0 itself is no value.
const LEAST_ALPHA: f64 = 0.01;
/// How far above the least exponent the slider of trigonometric curves goes.
const EXPONENTS: f64 = 8.0;

/// The parameters of a curve, the first and the second.
pub(super) fn knobs<const D: usize>(form: &Form<D>, joint: Option<usize>) -> Vec<Knob> {
    let name = form.family();
    let lambda = |parameter, range, step| {
        vec![Knob { parameter, name: "lambda", range, allowed: [-MAX_LAMBDA, MAX_LAMBDA], step }]
    };
    match name {
        FamilyName::CBezier | FamilyName::CBSpline => {
            let range = [LEAST_ALPHA, PI];
            vec![Knob { parameter: Parameter::Alpha, name: "alpha", range, allowed: range, step: 0.05 }]
        }
        FamilyName::FBezier | FamilyName::FBSpline => {
            let range = [-25.0, OMEGA[1]];
            vec![Knob { parameter: Parameter::Omega, name: "omega", range, allowed: OMEGA, step: 0.5 }]
        }
        FamilyName::TrigBezier => {
            let Ok(Family::Trig(trig)) = form.parameters() else { return Vec::new() };
            let knob = |parameter, name, n: usize| {
                let least = n as f64;
                let (range, allowed) = ([least, least + EXPONENTS], [least, MAX_EXPONENT]);
                Knob { parameter, name, range, allowed, step: 0.1 }
            };
            let [n1, n2] = trig.sides();
            vec![knob(Parameter::Alpha, "alpha", n1), knob(Parameter::Beta, "beta", n2)]
        }
        FamilyName::Han | FamilyName::Gb => {
            let local = form.parameters().is_ok_and(|family| is_local(&family));
            let joint = joint.filter(|&joint| local && joint < form.points.len());
            let parameter = joint.map_or(Parameter::Lambda, Parameter::LambdaOf);
            let range = if name == FamilyName::Han { [-8.0, 8.0] } else { [-1.0, 2.0] };
            lambda(parameter, range, if name == FamilyName::Han { 0.1 } else { 0.05 })
        }
        FamilyName::Alpha | FamilyName::Spb => lambda(Parameter::Lambda, [-1.0, 2.0], 0.05),
        FamilyName::HanQuadratic => {
            let range = [-1.0, 1.0];
            vec![Knob { parameter: Parameter::Lambda, name: "lambda", range, allowed: range, step: 0.05 }]
        }
        FamilyName::Cyclic => Vec::new(),
    }
}

/// The parameters that a family begins with; from a curve of a related family they are taken over.
pub(super) fn beginning<const D: usize>(name: FamilyName, before: &Form<D>) -> Family {
    let old = before.parameters().ok();
    let omega = match old {
        Some(Family::FBezier { omega } | Family::FBSpline { omega }) => Some(omega),
        _ => None,
    };
    let waves = omega.filter(|omega| *omega > 0.0).unwrap_or(4.0);
    let lambda_of = |wanted: LambdaKind| match &old {
        Some(Family::Lambda { kind, lambda }) if *kind == wanted => lambda.clone(),
        _ => Lambdas::One(if wanted == LambdaKind::Han { 1.0 } else { 0.5 }),
    };
    match name {
        FamilyName::CBezier => Family::FBezier { omega: waves },
        FamilyName::CBSpline => Family::FBSpline { omega: waves },
        FamilyName::FBezier => Family::FBezier { omega: omega.unwrap_or(-4.0) },
        FamilyName::FBSpline => Family::FBSpline { omega: omega.unwrap_or(-4.0) },
        FamilyName::Han => Family::Lambda { kind: LambdaKind::Han, lambda: lambda_of(LambdaKind::Han) },
        FamilyName::Alpha => Family::Lambda { kind: LambdaKind::Alpha, lambda: lambda_of(LambdaKind::Alpha) },
        FamilyName::Gb => Family::Lambda { kind: LambdaKind::Gb, lambda: lambda_of(LambdaKind::Gb) },
        FamilyName::Spb => Family::Lambda { kind: LambdaKind::Spb, lambda: lambda_of(LambdaKind::Spb) },
        FamilyName::HanQuadratic => match old {
            Some(Family::HanQuadratic { lambda }) => Family::HanQuadratic { lambda },
            _ => Family::HanQuadratic { lambda: 0.0 },
        },
        // Trigonometric curves ask for their numbers.
        FamilyName::TrigBezier | FamilyName::Cyclic => Family::Cyclic,
    }
}

/// How many points a family needs: exactly, or at least.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Needs {
    Exactly(usize),
    AtLeast(usize),
    /// An odd number, at least 3.
    Odd,
}

impl Needs {
    /// What the curve needs now.
    pub(super) fn of<const D: usize>(form: &Form<D>) -> Needs {
        let closed = form.closure() == crate::geometry::Closure::Closed;
        match (form.family(), form.parameters()) {
            (FamilyName::CBezier | FamilyName::FBezier, _) => Needs::Exactly(4),
            (FamilyName::TrigBezier, Ok(Family::Trig(trig))) => {
                Needs::Exactly(trig.sides().iter().sum::<usize>() + 1)
            }
            (FamilyName::Cyclic, _) => Needs::Odd,
            _ if form.through => Needs::AtLeast(if closed { 3 } else { 2 }),
            (FamilyName::HanQuadratic, _) => Needs::AtLeast(3),
            _ => Needs::AtLeast(if closed { 3 } else { 4 }),
        }
    }

    /// Whether a number of points is right.
    pub(super) fn met(self, count: usize) -> bool {
        match self {
            Needs::Exactly(needed) => count == needed,
            Needs::AtLeast(needed) => count >= needed,
            Needs::Odd => count >= 3 && count % 2 == 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_family_is_offered_once() {
        for (name, _) in FamilyName::ALL {
            assert_eq!(KINDS.iter().filter(|kind| kind.name == name).count(), 1, "{name:?}");
            assert_eq!(of_name(name).name, name);
        }
        let keys: Vec<char> = KINDS.iter().map(|kind| kind.key).collect();
        assert!(keys.iter().enumerate().all(|(at, key)| !keys[..at].contains(key)));
    }

    #[test]
    fn every_beginning_is_a_family_of_its_name() {
        for (name, _) in FamilyName::ALL.into_iter().filter(|(name, _)| *name != FamilyName::TrigBezier) {
            let form = Form::<2>::empty().by(name, &beginning(name, &Form::<2>::empty()), false);
            assert_eq!(form.family(), name);
            assert!(form.parameters().is_ok(), "{name:?}");
            for knob in knobs(&form, None) {
                let value = form.value(knob.parameter).expect("a knob has a value");
                assert!((knob.range[0]..=knob.range[1]).contains(&value), "{name:?}");
                for end in knob.range.into_iter().chain(knob.allowed) {
                    assert!(form.with(knob.parameter, end).is_ok(), "{name:?} {end}");
                }
            }
        }
    }
}
