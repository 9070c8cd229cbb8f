//! Polynomials and rational functions in named variables over any ring: read, printed, composed, derived and
//! evaluated.
//!
//! Coefficients may be exact [`Fraction`]s, doubles, 64-bit integers, [`Complex`] numbers, vectors (which are
//! only added and evaluated), polynomials again, or whatever else is [`Additive`], a [`Ring`] or a [`Field`]. A
//! variable is its name. All results are in a fixed order, so that they print alike every time.
//!
//! Nothing here panics. Exact numbers that grow too large, doubles that are no longer finite, and formulas with
//! too many terms ([`MAX_WORK`]) are an [`AlgebraError`] with a sentence.
//!
//! The composition of a polynomial with others, all put in at once:
//!
//! ```
//! use grafika::algebra::{Fraction, Rational, assignments};
//!
//! let p: Rational<Fraction> = "x^2 + 3*x*y - 5".parse()?;
//! let composed = p.substitute(&assignments("x = u^2 - 1, y = u + v")?)?;
//! assert_eq!(composed.to_string(), "u^4 + 3*u^3 + 3*u^2*v - 2*u^2 - 3*u - 3*v - 4");
//! # Ok::<(), grafika::algebra::AlgebraError>(())
//! ```

mod complex;
mod error;
mod formula;
mod fraction;
mod parse;
mod polynomial;
mod print;
mod rational;
mod ring;
mod variable;
mod work;

pub use complex::Complex;
pub use error::AlgebraError;
pub use formula::Formula;
pub use fraction::Fraction;
pub use parse::{MAX_DEPTH, MAX_TEXT, assignments, values};
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use ring::{Additive, Field, Number, Ring};
pub use variable::{PowerProduct, Variable};
pub use work::MAX_WORK;
