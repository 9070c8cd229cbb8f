//! The theorems on moving knots (M. Hoffmann's dissertation, 2.3 to 2.10) as identities of exact fractions: de Boor's
//! algorithm is run on rational functions of a variable `h`, and the curves of `geometry::knots` are compared with the
//! values.

use grafika::algebra::{
    Additive, AlgebraError, Field, Formula, Fraction, Polynomial, PowerProduct, Rational, Ring, Variable,
};
use grafika::geometry::Point;
use grafika::geometry::knots::{KnotCurve, KnotVector};
use proptest::prelude::*;

type F = Formula<Fraction>;
type Place = [F; 2];

fn number(value: i64) -> F {
    F::from(Fraction::from(value))
}

fn fraction(numerator: i64, denominator: i64) -> F {
    number(numerator) / number(denominator)
}

fn h() -> F {
    F::variable("h")
}

/// The formula of span `span` at `u`: the span is given, never looked up.
fn de_boor(points: &[[i64; 2]], order: usize, knots: &[F], u: &F, span: usize) -> Place {
    let first = span + 1 - order;
    let mut row: Vec<Place> = (first..=span).map(|i| points[i].map(number)).collect();
    for r in 1..order {
        for q in (r..order).rev() {
            let i = first + q;
            let width = knots[i + order - r].clone() - knots[i].clone();
            let a = (u.clone() - knots[i].clone()) / width;
            let rest = number(1) - a.clone();
            row[q] = [0, 1].map(|d| rest.clone() * row[q - 1][d].clone() + a.clone() * row[q][d].clone());
        }
    }
    row[order - 1].clone()
}

fn rational(formula: F) -> Result<Rational<Fraction>, AlgebraError> {
    formula.rational()
}

fn variable() -> Variable {
    Variable::new("h").unwrap()
}

/// The `r`-th derivatives by `h` at `h = 0`.
fn derivative(place: &Place, r: usize) -> Result<[Fraction; 2], AlgebraError> {
    let of = |formula: &F| {
        let mut function = rational(formula.clone())?;
        for _ in 0..r {
            function = function.derivative(&variable())?;
        }
        function.evaluate(&[(variable(), Fraction::from(0))])
    };
    Ok([of(&place[0])?, of(&place[1])?])
}

fn degree(polynomial: &Polynomial<Fraction>) -> u32 {
    polynomial.degree(&variable()).unwrap_or(0)
}

/// The coefficients by rising powers.
fn coefficients(polynomial: &Polynomial<Fraction>) -> Vec<Fraction> {
    let power = |exponent: u32| PowerProduct::power_of(&variable(), exponent);
    let coefficient =
        |exponent| polynomial.coefficient(&power(exponent)).copied().unwrap_or(Fraction::from(0));
    (0..=degree(polynomial)).map(coefficient).collect()
}

/// The degree of a rational function without common factors of numerator and denominator.
fn reduced_degree(function: &Rational<Fraction>) -> Result<usize, AlgebraError> {
    let zero = Fraction::from(0);
    let [top, bottom] = [function.numerator(), function.denominator()].map(coefficients);
    let longest = top.len().max(bottom.len());
    if top == [zero] {
        return Ok(0);
    }
    // Euclid's algorithm; polynomials end with what is not 0.
    let (mut a, mut b) = (top, bottom);
    while b != [zero] {
        while a.len() >= b.len() {
            let (Some(last), Some(leading)) = (a.last(), b.last()) else { break };
            let factor = last.over(leading)?;
            let shift = a.len() - b.len();
            for (i, coefficient) in b.iter().enumerate() {
                a[shift + i] = a[shift + i].minus(&factor.times(coefficient)?)?;
            }
            while a.len() > 1 && a.last() == Some(&zero) {
                a.pop();
            }
            if a == [zero] {
                break;
            }
        }
        std::mem::swap(&mut a, &mut b);
    }
    Ok(longest - a.len())
}

fn cross(a: [Fraction; 2], b: [Fraction; 2]) -> Result<Fraction, AlgebraError> {
    a[0].times(&b[1])?.minus(&a[1].times(&b[0])?)
}

fn times(a: Fraction, b: Fraction) -> Result<Fraction, AlgebraError> {
    a.times(&b)
}

/// A curve in general position with copies of a knot, in whole numbers.
#[derive(Clone, Debug)]
struct Case {
    order: usize,
    points: Vec<[i64; 2]>,
    knots: Vec<i64>,
    /// The first of the copies, and how many there are.
    knot: usize,
    copies: usize,
    /// Where something is in a span, in eighths.
    part: i64,
}

impl Case {
    /// Its knots, the copies at another place.
    fn knots_with(&self, place: &F) -> Vec<F> {
        let moved = |i: usize| (self.knot..self.knot + self.copies).contains(&i);
        let knot = |(i, &knot): (usize, &i64)| if moved(i) { place.clone() } else { number(knot) };
        self.knots.iter().enumerate().map(knot).collect()
    }

    fn present(&self) -> F {
        number(self.knots[self.knot])
    }

    /// The knots without the copies.
    fn without(&self) -> Vec<F> {
        let moved = |i: usize| (self.knot..self.knot + self.copies).contains(&i);
        (0..self.knots.len()).filter(|i| !moved(*i)).map(|i| number(self.knots[i])).collect()
    }

    /// The envelope at `v`, order `k - m`, continued from its span before the present knot (2.6).
    fn envelope(&self, v: &F) -> Place {
        let points = &self.points[..];
        // Control points and knots keep their numbers: without the copies knot j is the j-th again.
        de_boor(points, self.order - self.copies, &self.without(), v, self.knot - 1)
    }

    /// The curve at `u` in the span before the copies.
    fn before(&self, u: &F, place: &F) -> Place {
        de_boor(&self.points, self.order, &self.knots_with(place), u, self.knot - 1)
    }

    fn curve(&self) -> KnotCurve<2> {
        let knots = self.knots.iter().map(|&knot| knot as f64).collect();
        let points: Vec<Point<2>> = self.points.iter().map(|point| point.map(|x| x as f64)).collect();
        KnotCurve::new(KnotVector::new(self.order, knots).unwrap(), points).unwrap()
    }
}

fn cases(copies: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Case> {
    let numbers = prop::collection::vec([-9..10_i64, -9..10_i64], 12);
    let steps = prop::collection::vec(1..4_i64, 24);
    (3..=5_usize, copies, numbers, steps, 1..8_i64).prop_map(|(order, copies, numbers, steps, part)| {
        let copies = copies.min(order - 1);
        let count = 2 * order + copies;
        // The middle of the curve, so that all spans beside the copies exist.
        let knot = order + order / 2;
        let mut at = 0;
        let knots = (0..count + order).map(|i| {
            if !(knot + 1..knot + copies).contains(&i) {
                at += steps[i];
            }
            at
        });
        let (knots, points) = (knots.collect(), numbers.into_iter().cycle().take(count).collect());
        Case { order, points, knots, knot, copies, part }
    })
}

/// Whether a double is the exact value.
fn is(double: f64, exact: Fraction) -> bool {
    (double - exact.to_f64()).abs() < 1e-11 * exact.to_f64().abs().max(1.0)
}

/// Exact numbers have 128 bits: what overflows says nothing.
macro_rules! exact {
    ($value:expr) => {
        match $value {
            Ok(value) => value,
            Err(AlgebraError::Overflow) => return Err(TestCaseError::reject("overflow")),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        }
    };
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, max_global_rejects: 200, ..ProptestConfig::default() })]

    /// 2.3, 2.4: in the m-th span from a knot, points move on rational curves of order k - m. 2.5: the last are straight.
    #[test]
    fn paths_are_rational_curves_of_lower_order(case in cases(1..=1)) {
        let (k, i) = (case.order, case.knot);
        for m in 1..k {
            for (span, right) in [(i - m, false), (i + m - 1, true)] {
                let [from, to] = [span, span + 1].map(|j| number(case.knots[j]));
                let u = from.clone() + (to - from) * fraction(case.part, 8);
                let place = de_boor(&case.points, k, &case.knots_with(&(case.present() + h())), &u, span);
                let functions = [exact!(rational(place[0].clone())), exact!(rational(place[1].clone()))];
                for function in &functions {
                    // The order of the theorem is the degree in the knot: straight paths have 1.
                    let degree = exact!(reduced_degree(function));
                    prop_assert!(degree <= k - m, "degree {degree} in span {span}");
                }
                // The path of the library, at half a step to either side.
                let at = exact!(exact!(rational(u.clone())).evaluate(&[])).to_f64();
                let curve = case.curve();
                let path = curve.path(i, span, at).unwrap();
                prop_assert_eq!(path.order(), k - m);
                for by in [Fraction::new(1, 2).unwrap(), Fraction::new(-1, 4).unwrap()] {
                    let found = path.at(case.knots[i] as f64 + by.to_f64()).unwrap();
                    for d in 0..2 {
                        let expected = exact!(functions[d].evaluate(&[(variable(), by)]));
                        prop_assert!(is(found[d], expected), "{found:?} {expected}");
                    }
                }
                if m == k - 1 {
                    let side = if right { [i - 1, i] } else { [i - k, i - k + 1] };
                    prop_assert_eq!(path.straight().unwrap().side, side);
                    let [a, b] = side.map(|j| case.points[j]);
                    let along = [b[0] - a[0], b[1] - a[1]];
                    let moved = |d: usize| {
                        let now = F::from(functions[d].evaluate(&[(variable(), Fraction::from(0))])?);
                        Ok::<F, AlgebraError>(place[d].clone() - now)
                    };
                    let off = exact!(moved(0)) * number(along[1]) - exact!(moved(1)) * number(along[0]);
                    prop_assert_eq!(exact!(rational(off)).as_constant(), Some(Fraction::from(0)));
                }
            }
        }
    }

    /// 2.6: for every place of the knot the curve meets its envelope there, and both have one tangent. 2.7: the paths of
    /// the meeting points touch it too.
    #[test]
    fn curves_and_paths_touch_the_envelope(case in cases(1..=2)) {
        prop_assume!(case.order > case.copies + 1);
        // Anywhere: the identity is one of rational functions.
        let place = case.present() + h();
        let (on_envelope, on_curve) = (case.envelope(&place), case.before(&place, &place));
        for d in 0..2 {
            let off = on_envelope[d].clone() - on_curve[d].clone();
            prop_assert_eq!(exact!(rational(off)).as_constant(), Some(Fraction::from(0)));
        }
        let slope = exact!(derivative(&case.envelope(&(case.present() + h())), 1));
        let along = exact!(derivative(&case.before(&(case.present() + h()), &case.present()), 1));
        prop_assert_eq!(exact!(cross(slope, along)), Fraction::from(0));
        let path = exact!(derivative(&case.before(&case.present(), &(case.present() + h())), 1));
        prop_assert_eq!(exact!(cross(slope, path)), Fraction::from(0));
        // The library's envelope.
        let envelope = case.curve().envelope(case.knot, case.copies).unwrap();
        prop_assert_eq!(envelope.curve.vector().order(), case.order - case.copies);
        let touching = envelope.touching().unwrap();
        let expected = exact!(derivative(&case.envelope(&(case.present() + h())), 0));
        prop_assert!((0..2).all(|d| is(touching[d], expected[d])));
    }

    /// 2.8: where all copies of a knot move without end, the arc behind them ends in one control point and the arc before
    /// them in another, whichever way they move.
    #[test]
    fn arcs_shrink_to_control_points(case in cases(1..=2)) {
        let (i, m, k) = (case.knot, case.copies, case.order);
        prop_assume!(m < k - 1);
        let limits = case.curve().limits(i, m).unwrap();
        for (span, end, told) in [(i + m - 1, i + m - 1, limits.after), (i - 1, i - k, limits.before)] {
            let u = number(case.knots[span]) + fraction(case.part, 8);
            let place = de_boor(&case.points, k, &case.knots_with(&(case.present() + h())), &u, span);
            for (d, coordinate) in place.into_iter().enumerate() {
                let function = exact!(rational(coordinate));
                let (top, bottom) = (function.numerator(), function.denominator());
                let limit = match (degree(top), degree(bottom)) {
                    (a, b) if a < b => Fraction::from(0),
                    (a, b) if a == b => {
                        let [top, bottom] = [top, bottom].map(|it| it.leading().map(|(_, c)| *c));
                        exact!(top.unwrap_or(Fraction::from(0)).over(&bottom.unwrap_or(Fraction::from(1))))
                    }
                    _ => return Err(TestCaseError::fail("no limit")),
                };
                prop_assert_eq!(limit, Fraction::from(case.points[end][d]));
                prop_assert_eq!(told.unwrap()[d], case.points[end][d] as f64);
            }
        }
    }

    /// 2.9: at the touching point the r-th derivatives are (k - 1 - r) / (k - 1) of those of the curve. 2.10: so are the
    /// curvatures, for any multiplicity.
    #[test]
    fn derivatives_and_curvatures_are_in_proportion(case in cases(1..=2)) {
        let (k, m) = (case.order, case.copies);
        prop_assume!(k > m + 1);
        let on_envelope = case.envelope(&(case.present() + h()));
        let on_curve = case.before(&(case.present() + h()), &case.present());
        if m == 1 {
            for r in 0..=k - 2 {
                let (b, s) = (exact!(derivative(&on_envelope, r)), exact!(derivative(&on_curve, r)));
                let factor = Fraction::new((k - 1 - r) as i128, (k - 1) as i128).unwrap();
                for d in 0..2 {
                    prop_assert_eq!(b[d], exact!(times(factor, s[d])), "derivative {}", r);
                }
            }
        }
        let told = case.curve().envelope(case.knot, m).unwrap().curvature_ratio;
        if k == m + 2 {
            prop_assert_eq!(told, Some(0.0));
        }
        let [b1, b2, s1, s2] = [
            exact!(derivative(&on_envelope, 1)),
            exact!(derivative(&on_envelope, 2)),
            exact!(derivative(&on_curve, 1)),
            exact!(derivative(&on_curve, 2)),
        ];
        let turning = exact!(cross(s1, s2));
        let along = if s1[0] == Fraction::from(0) { 1 } else { 0 };
        prop_assume!(turning != Fraction::from(0) && s1[along] != Fraction::from(0));
        // b' = scale s', so the ratio of the curvatures is (b' x b'') / (scale^3 s' x s'').
        let scale = exact!(b1[along].over(&s1[along]));
        let cube = exact!(times(scale, exact!(times(scale, scale))));
        let ratio = exact!(exact!(cross(b1, b2)).over(&exact!(times(cube, turning))));
        let expected = Fraction::new(((k - 1) * (k - m - 2)) as i128, ((k - 2) * (k - m - 1)) as i128).unwrap();
        prop_assert_eq!(ratio, expected);
        prop_assert!(is(told.unwrap(), expected));
    }
}
