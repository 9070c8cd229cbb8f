use super::*;
use crate::algebra::Fraction;
use proptest::prelude::*;

fn printed(text: &str) -> String {
    match text.parse::<Rational<Fraction>>() {
        Ok(formula) => formula.to_string(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn precedence_and_signs() {
    for (text, expected) in [
        ("1+2*3", "7"),
        ("-x^2", "-x^2"),
        ("(-x)^2", "x^2"),
        ("2--3", "5"),
        ("2*-x", "-2*x"),
        ("6/2/3", "1"),
        ("6/2*3", "9"),
        ("x-y-z", "x - y - z"),
        ("x^(-1)", "1/x"),
        ("2^10", "1024"),
        (" ( x ) ", "x"),
        ("1.5e1*x", "15*x"),
        ("2*e", "2*e"),
        (
            "(1+u)^3*(2*v-1/3)^2 - 4*u^3*v^2 - (1+u)^3/9",
            "12*u^2*v^2 - 4/3*u^3*v + 12*u*v^2 - 4*u^2*v + 4*v^2 - 4*u*v - 4/3*v",
        ),
    ] {
        let same = printed(text) == expected || text.parse::<Rational<Fraction>>() == expected.parse();
        assert!(same, "{text}: {} instead of {expected}", printed(text));
    }
}

#[test]
fn wrong_text_is_said_with_its_place() {
    for (text, message) in [
        ("", "character 1: the end of the formula, but a number, a variable or ( is needed"),
        ("2x", "character 2: 'x', but an operator, such as *, is needed"),
        ("x y", "character 3: 'y', but an operator or the end is needed"),
        ("(x+1", "character 5: the end of the formula, but an operator or ) is needed"),
        ("x)", "character 2: ')', but an operator or the end is needed"),
        ("x^y", "character 3: 'y', but a whole number as exponent is needed"),
        ("x^1.5", "character 4: '.', but a whole number as exponent is needed"),
        ("x^2^3", "character 4: '^', but a parenthesis round one of the powers is needed"),
        (
            "x^99999999999",
            "character 3: the result has too many terms; at most 2097152 products of terms are formed",
        ),
        ("1 + 1/0", "character 6: division by zero; the denominator must be different from 0"),
        ("0^-1", "character 2: division by zero; the denominator must be different from 0"),
        ("x + .", "character 5: '.', but a number is needed"),
        ("1.2.3", "character 4: '.', but an operator, such as *, is needed"),
        ("x = 2", "character 3: '=', but an operator or the end is needed"),
        ("1e99", "character 1: a number is too large to be computed exactly; smaller ones are needed"),
    ] {
        assert_eq!(printed(text), message, "{text}");
    }
    assert_eq!("1/x".parse::<Polynomial<Fraction>>(), Err(AlgebraError::NotPolynomial));
}

#[test]
fn values_and_assignments() {
    let texts =
        |pairs: Vec<(Variable, Fraction)>| pairs.iter().map(|(v, c)| format!("{v}={c}")).collect::<Vec<_>>();
    assert_eq!(values::<Fraction>("x=3,y=-1/2").map(texts), Ok(vec!["x=3".into(), "y=-1/2".into()]));
    let pairs = assignments::<Fraction>("x = y/2, y = x").unwrap();
    assert_eq!(pairs.iter().map(|(v, r)| format!("{v}={r}")).collect::<Vec<_>>(), ["x=1/2*y", "y=x"]);
    assert_eq!(values::<Fraction>("x = z"), Err(AlgebraError::Unbound { variable: "z".to_string() }));
    assert_eq!(assignments::<f64>("x=1,x=2"), Err(AlgebraError::Repeated { variable: "x".to_string() }));
    assert!(matches!(values::<f64>("x=1,"), Err(AlgebraError::Syntax { at: 5, .. })));
    assert!(matches!(values::<f64>("3"), Err(AlgebraError::Syntax { at: 1, .. })));
}

#[test]
fn deep_and_long_texts_are_refused() {
    let nested = |depth: usize| format!("{}x{}", "(".repeat(depth), ")".repeat(depth));
    assert_eq!(printed(&nested(MAX_DEPTH)), "x");
    let error = nested(MAX_DEPTH + 1).parse::<Rational<f64>>();
    assert_eq!(error, Err(AlgebraError::TooDeep { at: MAX_DEPTH + 1, most: MAX_DEPTH }));
    assert!(nested(30_000).parse::<Rational<f64>>().is_err());
    let error = "x".repeat(MAX_TEXT + 1).parse::<Rational<f64>>();
    assert_eq!(error, Err(AlgebraError::TextTooLong { given: MAX_TEXT + 1, most: MAX_TEXT }));
    let signs = format!("{}x", "-".repeat(MAX_TEXT - 1));
    assert_eq!(printed(&signs), "-x");
    // Many large products, a product of very many variables, nested powers.
    let square = "(a+b+c+d+e)^12*".repeat(2000) + "1";
    assert!(matches!(square.parse::<Rational<f64>>(), Err(AlgebraError::Part { .. })));
    let names: Vec<String> = (0..8000).map(|n| format!("v{n}")).collect();
    assert!(matches!(names.join("*").parse::<Rational<f64>>(), Err(AlgebraError::Part { .. })));
    assert!(names.join("+").parse::<Rational<f64>>().is_ok());
    assert!("((((x+1)^99)^99)^99)^99".parse::<Rational<f64>>().is_err());
    assert!("(1-x^100000000)/(1-x)".parse::<Rational<Fraction>>().is_ok());
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in "[-+*/^() .,=0-9exyα²]{0,40}") {
        let _ = text.parse::<Rational<Fraction>>();
        let _ = values::<f64>(&text);
    }

    #[test]
    fn a_sum_of_powers_is_read_as_it_is_meant(a in -9_i64..10, m in 0_u32..5, b in 1_i64..10, n in 0_u32..5) {
        let text = format!("{a}*x^{m} - y^{n}/{b}");
        let read: Polynomial<Fraction> = text.parse().unwrap();
        let value = read.evaluate(&values("x=2, y=3").unwrap()).unwrap();
        let expected = Fraction::new(i128::from(a) * 2_i128.pow(m) * i128::from(b) - 3_i128.pow(n), b.into()).unwrap();
        prop_assert_eq!(value, expected);
    }
}
