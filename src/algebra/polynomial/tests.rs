use super::*;
use crate::algebra::{Complex, Field, Fraction};
use proptest::prelude::*;

type Exact = Polynomial<Fraction>;

fn exact(text: &str) -> Exact {
    text.parse().unwrap()
}

fn var(name: &str) -> Variable {
    Variable::new(name).unwrap()
}

fn values(x: Fraction, y: Fraction) -> [(Variable, Fraction); 2] {
    [(var("x"), x), (var("y"), y)]
}

#[test]
fn zero_has_no_terms() {
    let zero = exact("(x + y)^2 - x^2 - 2*x*y - y^2");
    assert_eq!((zero.term_count(), zero.degree(&var("x")), zero.as_constant()), (0, None, Some(0.into())));
    assert_eq!(exact("0^0"), Exact::one());
    assert_eq!(exact("x - x + 3").as_constant(), Some(3.into()));
    // Doubles whose product underflows leave no term with coefficient 0 either.
    let tiny: Polynomial<f64> = Polynomial::constant(1e-200);
    assert!(tiny.times(&tiny).unwrap().is_zero());
}

#[test]
fn derivatives_and_degrees() {
    let p = exact("x^3 - 2*x*y^2 + 1");
    assert_eq!(
        p.gradient(&[var("x"), var("y"), var("z")]).unwrap(),
        [exact("3*x^2 - 2*y^2"), exact("-4*x*y"), Exact::zero()]
    );
    assert_eq!((p.degree(&var("y")), p.degree(&var("z")), p.total_degree()), (Some(2), Some(0), Some(3)));
    assert_eq!(p.variables().into_iter().collect::<Vec<_>>(), [var("x"), var("y")]);
    assert_eq!(p.coefficient(&PowerProduct::power_of(&var("x"), 3)), Some(&1.into()));
}

#[test]
fn missing_and_repeated_values_are_named() {
    let p = exact("x + y");
    let error = p.evaluate(&[(var("x"), 1.into())]);
    assert_eq!(error, Err(AlgebraError::Unbound { variable: "y".to_string() }));
    let error = p.evaluate(&[(var("x"), 1.into()), (var("x"), 2.into())]);
    assert_eq!(error, Err(AlgebraError::Repeated { variable: "x".to_string() }));
}

#[test]
fn substitution_is_simultaneous() {
    let swapped = exact("x^2 + y").substitute(&[(var("x"), exact("y")), (var("y"), exact("x"))]);
    assert_eq!(swapped.unwrap(), exact("y^2 + x"));
    let same = exact("x^2 + y").substitute(&[(var("z"), exact("y"))]);
    assert_eq!(same.unwrap(), exact("x^2 + y"));
}

#[test]
fn vectors_may_be_coefficients() {
    let (t, one) = (var("t"), PowerProduct::default());
    let curve = Polynomial::term([1.0, 0.0], one)
        .plus(&Polynomial::term([2.0, 3.0], PowerProduct::power_of(&t, 2)))
        .unwrap();
    let scaled = |c: &[f64; 2], x: &f64| Ok(c.map(|component| component * x));
    assert_eq!(curve.evaluate_with(&[(t.clone(), 2.0)], scaled), Ok([9.0, 12.0]));
    let speed = curve.derivative(&t).unwrap();
    assert_eq!(speed.evaluate_with(&[(t, 2.0)], scaled), Ok([8.0, 12.0]));
}

/// The speed of a planar curve whose derivative is w² is |w|², a polynomial; twice the curvature's numerator
/// Im(conj(w) w') has degree 2 only.
#[test]
fn square_of_a_complex_polynomial_has_polynomial_speed() {
    let i = Complex { re: Fraction::from(0), im: Fraction::from(1) };
    let real = |text: &str| exact(text).map(|c| Ok(Complex { re: *c, im: 0.into() })).unwrap();
    let w = real("1 + 2*t - t^2").plus(&real("t/3 + 4*t^2").scaled(&i).unwrap()).unwrap();
    let conjugate = w.map(Complex::conjugate).unwrap();
    let hodograph = w.power(2).unwrap();
    let part =
        |p: &Polynomial<Complex<Fraction>>, im: bool| p.map(|c| Ok(if im { c.im } else { c.re })).unwrap();
    let square = |p: Exact| p.power(2).unwrap();
    let speed = w.times(&conjugate).unwrap();
    assert!(part(&speed, true).is_zero());
    let sum = square(part(&hodograph, false)).plus(&square(part(&hodograph, true))).unwrap();
    assert_eq!(sum, square(part(&speed, false)));
    let bend = part(&conjugate.times(&w.derivative(&var("t")).unwrap()).unwrap(), true);
    assert_eq!(bend.total_degree(), Some(2));
    assert!(Complex::<Fraction>::one().over(&i).is_ok());
}

/// The rational form of a patch with Pythagorean normals: with p, q, r bicubic, the point of weight J (1 + rho)
/// satisfies n·x = h, n_u·x = h_u and n_v·x = h_v exactly, in degree (11, 11). Z is the determinant of (p, q, r)
/// and its derivatives, whose highest coefficients cancel: of degree (7, 7) only.
#[test]
fn patches_with_rational_normals_have_degree_eleven() {
    let (u, v) = (var("u"), var("v"));
    let p = exact("u + u^3*v^2/2 - v^3*u^2/3 + u^3*v^3 - v");
    let q = exact("v - u*v/4 + u^2*v^3 + 2*u^3 - u^3*v^3/5");
    let r = exact("1 + u*v - u^3*v/2 + 3*u*v^3 + u^3*v^3/7 + u^2");
    let times = |a: &Exact, b: &Exact| a.times(b).unwrap();
    let plus = |a: &Exact, b: &Exact| a.clone().plus(b).unwrap();
    let minus = |a: &Exact, b: &Exact| a.clone().minus(b).unwrap();
    let by = |a: &Exact, v: &Variable| a.derivative(v).unwrap();
    let wedge = |a: &Exact, b: &Exact| minus(&times(&by(a, &u), &by(b, &v)), &times(&by(a, &v), &by(b, &u)));
    let (jacobian, a, b) = (wedge(&p, &q), wedge(&r, &q), wedge(&p, &r));
    let rho = plus(&times(&p, &p), &times(&q, &q));
    let above = plus(&rho, &Exact::one());
    let z = minus(&plus(&times(&p, &a), &times(&q, &b)), &times(&r, &jacobian)).multiple(2).unwrap();
    let weight = times(&jacobian, &above);
    let x = minus(&times(&a, &above), &times(&p, &z));
    let y = minus(&times(&b, &above), &times(&q, &z));
    for (part, degree) in [(&x, 11), (&y, 11), (&z, 7), (&weight, 11)] {
        assert_eq!((part.degree(&u), part.degree(&v)), (Some(degree), Some(degree)));
        let highest = PowerProduct::power_of(&u, 11).times(&PowerProduct::power_of(&v, 11)).unwrap();
        assert_eq!(part.coefficient(&highest), None);
    }
    // n = (2p, 2q, rho - 1)/(1 + rho) and h = 2r/(1 + rho); (n·x - h) (1 + rho) and its derivatives.
    let normal = [p.multiple(2).unwrap(), q.multiple(2).unwrap(), minus(&rho, &Exact::one())];
    let support = r.multiple(2).unwrap();
    let rest = |normal: [Exact; 3], support: &Exact| {
        let sum = normal.iter().zip([&x, &y, &z]).fold(Exact::zero(), |sum, (n, x)| plus(&sum, &times(n, x)));
        minus(&sum, &times(support, &weight))
    };
    assert!(rest(normal.clone(), &support).is_zero());
    for variable in [&u, &v] {
        assert!(rest(normal.each_ref().map(|n| by(n, variable)), &by(&support, variable)).is_zero());
    }
}

#[test]
fn too_much_is_refused() {
    let sum = exact("a + b + c + d + e + f");
    assert_eq!(sum.power(60), Err(AlgebraError::TooLarge));
    assert_eq!(exact("x^4000000000").power(2), Err(AlgebraError::Exponent { variable: "x".to_string() }));
    assert_eq!(exact("x + 1").power(u32::MAX), Err(AlgebraError::Overflow));
    let deep = exact("x^4000000000").substitute(&[(var("x"), exact("x + y"))]);
    assert!(matches!(deep, Err(AlgebraError::TooLarge | AlgebraError::Overflow)), "{deep:?}");
    let deep = Polynomial::<f64>::variable(&var("x")).plus(&Polynomial::one()).unwrap().power(5000);
    assert!(matches!(deep, Err(AlgebraError::TooLarge | AlgebraError::Overflow)), "{deep:?}");
}

/// Polynomials of x, y and z with small coefficients.
fn small() -> impl Strategy<Value = Exact> {
    let term = (-6_i64..7, 1_i64..4, 0_u32..3, 0_u32..3, 0_u32..2);
    prop::collection::vec(term, 0..5).prop_map(|terms| {
        let texts = terms.iter().map(|(p, q, x, y, z)| format!("+ {p}/{q}*x^{x}*y^{y}*z^{z}"));
        exact(&format!("0 {}", texts.collect::<String>()))
    })
}

proptest! {
    #[test]
    fn is_a_ring(a in small(), b in small(), c in small()) {
        let plus = |a: &Exact, b: &Exact| a.clone().plus(b).unwrap();
        let times = |a: &Exact, b: &Exact| a.times(b).unwrap();
        prop_assert_eq!(plus(&a, &b), plus(&b, &a));
        prop_assert_eq!(plus(&plus(&a, &b), &c), plus(&a, &plus(&b, &c)));
        prop_assert_eq!(times(&a, &b), times(&b, &a));
        prop_assert_eq!(times(&times(&a, &b), &c), times(&a, &times(&b, &c)));
        prop_assert_eq!(times(&a, &plus(&b, &c)), plus(&times(&a, &b), &times(&a, &c)));
        prop_assert_eq!(times(&a, &Exact::one()), a.clone());
        prop_assert!(plus(&a, &a.negated().unwrap()).is_zero());
        prop_assert!(times(&a, &b).terms().all(|(_, coefficient)| !coefficient.is_zero()));
        prop_assert_eq!(a.power(3).unwrap(), times(&times(&a, &a), &a));
    }

    #[test]
    fn derivative_follows_leibniz_and_the_chain_rule(a in small(), b in small(), c in small()) {
        let (x, y) = (var("x"), var("y"));
        let by = |p: &Exact| p.derivative(&x).unwrap();
        let rule = by(&a).times(&b).unwrap().plus(&a.times(&by(&b)).unwrap()).unwrap();
        prop_assert_eq!(by(&a.times(&b).unwrap()), rule);
        // a(x = b, y = c), where b and c are polynomials of x, y and z; z stays.
        let inner = [(x.clone(), b.clone()), (y.clone(), c.clone())];
        let at = |p: &Exact| p.substitute(&inner).unwrap();
        let of_y = |p: &Exact| p.derivative(&y).unwrap();
        let chain = at(&by(&a)).times(&by(&b)).unwrap().plus(&at(&of_y(&a)).times(&by(&c)).unwrap()).unwrap();
        prop_assert_eq!(by(&at(&a)), chain);
    }

    #[test]
    fn evaluation_respects_sums_and_products(a in small(), b in small(), p in -9_i64..9, q in 1_i64..9) {
        let number = Fraction::from(p).over(&q.into()).unwrap();
        let mut at = values(number, q.into()).to_vec();
        at.push((var("z"), number));
        let value = |p: &Exact| p.evaluate(&at).unwrap();
        prop_assert_eq!(value(&a.times(&b).unwrap()), value(&a).times(&value(&b)).unwrap());
        prop_assert_eq!(value(&a.clone().plus(&b).unwrap()), value(&a).plus(&value(&b)).unwrap());
        // Composition with constants is evaluation.
        let constants: Vec<_> = at.iter().map(|(variable, value)| (variable.clone(), Exact::constant(*value))).collect();
        prop_assert_eq!(a.substitute(&constants).unwrap().as_constant(), Some(value(&a)));
    }

    #[test]
    fn reads_back_what_it_prints(a in small(), scale in -1e3..1e3_f64) {
        prop_assert_eq!(exact(&a.to_string()), a.clone());
        let double = a.map(|c| Ok(c.to_f64() * scale)).unwrap();
        prop_assert_eq!(double.to_string().parse::<Polynomial<f64>>().unwrap(), double);
    }
}
