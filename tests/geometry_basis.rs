//! Bases: weights that sum to 1, and the curves that they blend.

use grafika::geometry::{
    Basis, Blend, Closure, Curve, Ends, GeometryError, Method, ParamCurve, Point, Weights,
};
use proptest::prelude::*;

/// The methods that have weights.
const METHODS: [Method; 6] = [
    Method::Coons { k0: 0.625 },
    Method::Spline,
    Method::BSpline2,
    Method::BSpline3,
    Method::Beta { bias: 1.5, tension: 2.25 },
    Method::Local { k0: 0.375 },
];

/// Weights that do not say that they are cubic, so that every place is computed from them.
#[derive(Debug)]
struct Plain(Weights);

impl Basis for Plain {
    fn points(&self) -> usize {
        self.0.points()
    }

    fn spans(&self) -> usize {
        self.0.spans()
    }

    fn closed(&self) -> bool {
        self.0.closed()
    }

    fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize> {
        self.0.weights(span, u, out)
    }
}

fn method() -> impl Strategy<Value = Method> {
    prop::sample::select(METHODS.to_vec())
}

fn ends() -> impl Strategy<Value = Ends> {
    prop::sample::select(vec![Ends::Open, Ends::Closed, Ends::Doubled, Ends::Auxiliary])
}

fn points() -> impl Strategy<Value = Vec<Point<3>>> {
    prop::collection::vec(prop::array::uniform3(-100.0..100.0), 2..12)
}

fn distance(a: Point<3>, b: Point<3>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn weights_sum_to_one_and_blend_to_the_arcs(
        method in method(), ends in ends(), points in points(), u in 0.0..=1.0,
    ) {
        let Ok(weights) = Weights::with_ends(method, ends, points.len()) else { return Ok(()) };
        let arcs = weights.arcs(&points).unwrap();
        prop_assert_eq!(weights.closed(), ends == Ends::Closed);
        let mut seen = vec![[9.0; 3]; 2];
        for (span, arc) in arcs.iter().enumerate() {
            let first = weights.weights(span, u, &mut seen).unwrap();
            prop_assert!(first < points.len() && seen.len() <= points.len());
            let sum: [f64; 3] = std::array::from_fn(|order| seen.iter().map(|w| w[order]).sum());
            prop_assert!((sum[0] - 1.0).abs() < 1e-13 && sum[1].abs() < 1e-12 && sum[2].abs() < 1e-11, "{sum:?}");
            let blend = |order: usize| -> Point<3> {
                let followers = points.iter().cycle().skip(first);
                seen.iter().zip(followers).fold([0.0; 3], |sum, (w, p)| {
                    std::array::from_fn(|d| sum[d] + w[order] * p[d])
                })
            };
            prop_assert!(distance(blend(0), arc.eval(u)) < 1e-11);
            prop_assert!(distance(blend(1), arc.derivative(u)) < 1e-10);
            prop_assert!(distance(blend(2), arc.second_derivative(u)) < 1e-9);
        }
        prop_assert_eq!(weights.weights(arcs.len(), u, &mut seen), None);
    }

    #[test]
    fn blends_are_the_curves(method in method(), closed: bool, points in points(), u in 0.0..=1.0) {
        let closure = if closed { Closure::Closed } else { Closure::Open };
        let Ok(curve) = Curve::through(method, closure, &points) else { return Ok(()) };
        let weights = Weights::new(method, closure, points.len()).unwrap();
        // By exact arcs: the same doubles.
        let exact = Blend::new(&weights, points.clone()).unwrap();
        prop_assert_eq!(exact.sample(9), curve.sample(9));
        prop_assert_eq!(exact.to_cubics(1.0), curve.to_cubics(1.0));
        prop_assert_eq!((exact.bounding_box(), exact.length(0.1)), (curve.bounding_box(), curve.length(0.1)));
        // By weights: the same curve.
        let plain = Blend::new(Plain(weights), points).unwrap();
        let plain: &dyn ParamCurve<3> = &plain;
        prop_assert_eq!((plain.spans(), plain.closed()), (curve.spans(), closed));
        for span in 0..curve.spans() {
            let (a, b) = (plain.at(span, u).unwrap(), curve.at(span, u).unwrap());
            for (order, (a, b)) in a.into_iter().zip(b).enumerate() {
                prop_assert!(distance(a, b) < 1e-11 * 10.0_f64.powi(order as i32), "{order} {a:?} {b:?}");
            }
        }
        for (a, b) in plain.sample(5).unwrap().iter().zip(curve.sample(5).unwrap()) {
            prop_assert!(a.span == b.span && distance(a.point, b.point) < 1e-11);
        }
        // An arc a span is enough.
        prop_assert_eq!(plain.to_cubics(1e-6).unwrap().len(), curve.spans());
        prop_assert!((plain.length(1e-9) - curve.length(1e-9)).abs() < 1e-6);
    }
}

#[test]
fn points_have_to_belong_to_the_basis() {
    let basis: Box<dyn Basis> = Box::new(Weights::new(Method::Spline, Closure::Open, 4).unwrap());
    let points = vec![[0.0, 1.0], [2.0, 3.0], [4.0, 3.0]];
    let error = Blend::new(&basis, points.clone()).unwrap_err();
    assert_eq!(error, GeometryError::WrongCount { given: 3, needed: 4 });
    let whole = [points, vec![[f64::NAN, 0.0]]].concat();
    assert_eq!(Blend::new(basis, whole).unwrap_err(), GeometryError::NotFinite { number: 4 });
}
