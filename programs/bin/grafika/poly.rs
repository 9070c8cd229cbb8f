//! `grafika poly`: polynomials and rational functions with exact fractions.

use crate::source::Answer;
use clap::Args;
use grafika::algebra::{AlgebraError, Fraction, Polynomial, Rational, Variable, assignments, values};
use grafika::launch::Failure;
use serde_json::{Map, Value, json};

/// The command line of `grafika poly`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika poly \"(x + y)^3 - x^3\"
  grafika poly \"x^3 - 2*x*y^2 + 1\" --derivative x --at x=3,y=-1/2
  grafika poly \"x^2 + 3*x*y\" --substitute x=u^2-1 --substitute y=u+v --to json")]
pub(crate) struct Poly {
    /// The formula, with + - * / ^ and parentheses
    #[arg(value_name = "EXPR", allow_hyphen_values = true)]
    formula: String,
    /// Derive by this variable; may be repeated, and comes before substitutions
    #[arg(long, value_name = "X")]
    derivative: Vec<String>,
    /// Put a formula in place of a variable; may be repeated, all at once
    #[arg(long, value_name = "X=EXPR")]
    substitute: Vec<String>,
    /// Values of the variables: the result is a number
    #[arg(long, value_name = "X=NUMBER,...")]
    at: Option<String>,
    #[command(flatten)]
    answer: Answer,
}

impl Poly {
    /// Computes and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let json = self.answer.is_json("formulas")?;
        let result = self.computed().map_err(Failure::work)?;
        let value = match &self.at {
            Some(at) => Some(values(at).and_then(|at| result.evaluate(&at)).map_err(Failure::work)?),
            None => None,
        };
        let text = match (value, json) {
            (Some(value), true) => json!({ "value": value.to_string() }).to_string(),
            (Some(value), false) => value.to_string(),
            (None, true) => as_json(&result).to_string(),
            (None, false) => result.to_string(),
        };
        self.answer.write(format!("{text}\n").as_bytes())
    }

    /// The formula after derivatives and substitutions.
    fn computed(&self) -> Result<Rational<Fraction>, AlgebraError> {
        let mut result: Rational<Fraction> = self.formula.parse()?;
        for name in &self.derivative {
            result = result.derivative(&Variable::new(name)?)?;
        }
        if self.substitute.is_empty() {
            return Ok(result);
        }
        result.substitute(&assignments(&self.substitute.join(","))?)
    }
}

/// The terms of a polynomial; of a rational function those of numerator and denominator.
fn as_json(formula: &Rational<Fraction>) -> Value {
    match formula.clone().into_polynomial() {
        Ok(polynomial) => json!({ "terms": terms(&polynomial) }),
        Err(_) => json!({
            "numerator": { "terms": terms(formula.numerator()) },
            "denominator": { "terms": terms(formula.denominator()) },
        }),
    }
}

fn terms(polynomial: &Polynomial<Fraction>) -> Vec<Value> {
    let term = polynomial.terms().map(|(powers, coefficient)| {
        let powers = powers
            .factors()
            .iter()
            .map(|(variable, power)| (variable.name().to_owned(), Value::from(*power)));
        json!({ "powers": powers.collect::<Map<String, Value>>(), "coefficient": coefficient.to_string() })
    });
    term.collect()
}
