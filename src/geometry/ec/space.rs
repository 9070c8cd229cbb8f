//! A space of functions, given by the roots of its characteristic polynomial.

use super::text::roots;
use super::{EcError, MAX_DIMENSION, Root};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// The solutions of a linear differential equation with constant coefficients (1.11), given by the roots of its
/// characteristic polynomial (1.12). 0 is among the roots and comes first, so that 1 is in the space.
///
/// ```
/// use grafika::geometry::ec::Space;
///
/// let space: Space = "i^2, 0^3, 2i".parse()?;
/// assert_eq!(space.to_string(), "0^3,i^2,2i");
/// assert_eq!((space.dimension(), space.is_symmetric()), (9, true));
/// assert_eq!(space.equation("v"), "v(9) + 6 v(7) + 9 v(5) + 4 v(3) = 0");
/// assert_eq!("P5".parse::<Space>()?.dimension(), 6);
/// # Ok::<(), grafika::geometry::ec::EcError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Root>", into = "Vec<Root>")]
pub struct Space {
    roots: Vec<Root>,
}

impl Space {
    /// The space of these roots. 0 moves to the front, the others keep their order.
    ///
    /// # Errors
    /// [`EcError`] where 0 is missing, a root is there twice, a multiplicity is 0, or the dimension is not 2 to
    /// [`MAX_DIMENSION`].
    pub fn new(mut roots: Vec<Root>) -> Result<Self, EcError> {
        for (at, root) in roots.iter_mut().enumerate() {
            root.im = std::mem::take(&mut root.im).abs();
            for (part, name) in [(&root.re, "real part"), (&root.im, "imaginary part")] {
                if !part.value().is_finite() {
                    return Err(EcError::NoNumber {
                        text: format!("{name} of root {}", at + 1),
                        problem: NOT_FINITE,
                    });
                }
            }
            if !(1..=MAX_DIMENSION).contains(&root.multiplicity) {
                return Err(EcError::Multiplicity { root: root.number(), given: root.multiplicity });
            }
        }
        if let Some(root) = (1..roots.len()).find_map(|k| roots[..k].iter().find(|root| root.is(&roots[k]))) {
            return Err(EcError::Twice { root: root.number() });
        }
        let zero = roots.iter().position(Root::is_zero).ok_or(EcError::NoZero)?;
        if let Some(front) = roots.get_mut(..=zero) {
            front.rotate_right(1);
        }
        let dimension = roots.iter().map(Root::dimension).sum();
        if !(2..=MAX_DIMENSION).contains(&dimension) {
            return Err(EcError::Dimension { given: dimension });
        }
        Ok(Self { roots })
    }

    /// The polynomials of degree `n`, 1 to 30; others are clipped.
    #[must_use]
    pub fn polynomials(n: usize) -> Self {
        Self { roots: vec![Root::zero(n.clamp(1, MAX_DIMENSION - 1) + 1)] }
    }

    /// The roots, 0 first.
    #[must_use]
    pub fn roots(&self) -> &[Root] {
        &self.roots
    }

    /// The dimension, n + 1.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.roots.iter().map(Root::dimension).sum()
    }

    /// Whether all roots are real, so that intervals may be of any length.
    #[must_use]
    pub fn is_real(&self) -> bool {
        self.fastest() == 0.0
    }

    /// The largest imaginary part of a root.
    pub(super) fn fastest(&self) -> f64 {
        self.roots.iter().fold(0.0, |most, root| most.max(root.im.value()))
    }

    /// Whether the roots lie symmetrically to 0, so that reflection maps the space to itself.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.roots.iter().all(|root| {
            let opposite = Root { re: (-root.re.value()).into(), ..root.clone() };
            self.roots.iter().any(|other| other.is(&opposite) && other.multiplicity == root.multiplicity)
        })
    }

    /// The space with a root more; if the root is there, its multiplicity grows.
    ///
    /// # Errors
    /// [`EcError::Dimension`] if the space becomes too large.
    pub fn with(&self, root: &Root) -> Result<Self, EcError> {
        let mut roots = self.roots.clone();
        match roots.iter_mut().find(|other| other.is(root)) {
            Some(other) => other.multiplicity = other.multiplicity.saturating_add(root.multiplicity),
            None => roots.push(root.clone()),
        }
        let given = roots.iter().map(Root::dimension).fold(0, usize::saturating_add);
        if given > MAX_DIMENSION {
            return Err(EcError::Dimension { given });
        }
        Self::new(roots)
    }

    /// The space with one zero root more, whose derivatives this space is.
    pub(super) fn integral(&self) -> Self {
        let mut integral = self.clone();
        if let Some(zero) = integral.roots.first_mut() {
            zero.multiplicity += 1;
        }
        integral
    }

    /// Whether all functions of `other` are in this space.
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        let has =
            |root: &Root| self.roots.iter().any(|it| it.is(root) && it.multiplicity >= root.multiplicity);
        other.roots.iter().all(has)
    }

    /// The coefficients of the characteristic polynomial, the constant first; the last is 1.
    #[must_use]
    pub fn polynomial(&self) -> Vec<f64> {
        super::series::polynomial(self, super::dd::ONE, false).into_iter().map(super::dd::Dd::value).collect()
    }

    /// The differential equation of the functions, as a sum of derivatives.
    #[must_use]
    pub fn equation(&self, function: &str) -> String {
        let polynomial = self.polynomial();
        let mut text = String::new();
        for (order, &factor) in polynomial.iter().enumerate().rev().filter(|(_, factor)| **factor != 0.0) {
            let sign = match (text.is_empty(), factor < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let size = match factor.abs() {
                1.0 => String::new(),
                size => format!("{} ", rounded(size)),
            };
            let derivative = match order {
                0 => String::new(),
                1 | 2 => "'".repeat(order),
                _ => format!("({order})"),
            };
            text.push_str(&format!("{sign}{size}{function}{derivative}"));
        }
        text + " = 0"
    }

    /// The functions of the ordinary basis in closed form, in the order of the roots.
    #[must_use]
    pub fn functions(&self, u: &str) -> Vec<String> {
        self.roots.iter().flat_map(|root| functions_of(root, u)).collect()
    }
}

impl TryFrom<Vec<Root>> for Space {
    type Error = EcError;

    fn try_from(roots: Vec<Root>) -> Result<Self, EcError> {
        Self::new(roots)
    }
}

impl From<Space> for Vec<Root> {
    fn from(space: Space) -> Self {
        space.roots
    }
}

const NOT_FINITE: &str = "is not a finite number";

/// A number with six digits at most, as in texts.
fn rounded(value: f64) -> String {
    let digits = format!("{value:.5e}").parse::<f64>().unwrap_or(value);
    digits.to_string()
}

/// The functions of a root: u^r e^(au) (1.3), with cos(bu) and sin(bu) for a pair.
fn functions_of(root: &Root, u: &str) -> Vec<String> {
    // "u", "2 u", "1/4 u", "(1/4 + 1) u".
    let product = |factor: &super::Real| match factor.value() {
        1.0 => u.to_owned(),
        -1.0 => format!("-{u}"),
        _ => {
            let text = factor.text().map_or_else(|| rounded(factor.value()), str::to_owned);
            let sum = text.char_indices().any(|(at, c)| at > 0 && matches!(c, '+' | '-'));
            if sum { format!("({text}) {u}") } else { format!("{text} {u}") }
        }
    };
    let exponential = (root.re.value() != 0.0).then(|| {
        let exponent = product(&root.re);
        if exponent == u { format!("e^{u}") } else { format!("e^({exponent})") }
    });
    let waves: Vec<Option<String>> = match root.im.value() {
        0.0 => vec![None],
        _ => {
            let argument = product(&root.im);
            let argument =
                if argument.contains(['/', '*', '+']) { format!("({argument})") } else { argument };
            ["cos", "sin"].map(|wave| Some(format!("{wave} {argument}"))).into()
        }
    };
    let power = |r: usize| match r {
        0 => None,
        1 => Some(u.to_owned()),
        _ => Some(format!("{u}^{r}")),
    };
    let parts = |r: usize, wave: &Option<String>| -> String {
        let parts = [power(r), exponential.clone(), wave.clone()];
        let text = parts.into_iter().flatten().collect::<Vec<_>>().join(" ");
        if text.is_empty() { "1".to_owned() } else { text }
    };
    (0..root.multiplicity)
        .flat_map(|r| waves.iter().map(move |wave| (r, wave)))
        .map(|(r, wave)| parts(r, wave))
        .collect()
}

impl FromStr for Space {
    type Err = EcError;

    /// A list of roots, or one of the named families: `P5`, `T3`, `H2`, `AT2`, `AH2`, `AET1`, `M4(1,0.2)`.
    fn from_str(text: &str) -> Result<Self, EcError> {
        match preset(text.trim()) {
            Some(space) => space,
            None => Self::new(roots(text)?),
        }
    }
}

impl fmt::Display for Space {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts: Vec<String> = self.roots.iter().map(Root::to_string).collect();
        f.write_str(&texts.join(","))
    }
}

/// The space of a family with its number, if the text names one (section 1.3 of the thesis; AET and M are Róth's).
fn preset(text: &str) -> Option<Result<Space, EcError>> {
    let letters = text.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (family, rest) = text.split_at_checked(letters)?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let (number, rest) = rest.split_at_checked(digits)?;
    if number.is_empty() || family.is_empty() {
        return None;
    }
    let family = family.to_ascii_uppercase();
    if !["P", "T", "H", "AT", "AH", "AET", "M"].contains(&family.as_str()) {
        return None;
    }
    // What is too large is told as a dimension.
    let n: usize = number.parse().unwrap_or(usize::MAX).min(1000);
    if family == "M" {
        return Some(mixed(text, n, rest));
    }
    if !rest.is_empty() {
        let at = text.chars().count() - rest.chars().count() + 1;
        let problem = "nothing more belongs to the name of this space";
        return Some(Err(EcError::Syntax { text: text.to_owned(), at, problem }));
    }
    let falling = |k: usize| n + 1 - k;
    let mut roots = match family.as_str() {
        "P" | "AT" | "AH" | "AET" => vec![Root::zero(n + 1)],
        _ => vec![Root::zero(1)],
    };
    for k in 1..=n {
        let w = k as f64;
        match family.as_str() {
            "T" => roots.push(Root::of(0.0, w, 1)),
            "H" => roots.extend([w, -w].map(|w| Root::of(w, 0.0, 1))),
            "AT" => roots.push(Root::of(0.0, w, falling(k))),
            "AH" => roots.extend([w, -w].map(|w| Root::of(w, 0.0, falling(k)))),
            "AET" => roots.extend([w, -w].map(|a| Root::of(a, w, falling(k)))),
            _ => {}
        }
    }
    let given = roots.iter().map(Root::dimension).sum();
    Some(if given > MAX_DIMENSION { Err(EcError::Dimension { given }) } else { Space::new(roots) })
}

/// The space M of index `index` with its two numbers in brackets: 0^(index - 3), a ± bi, -a ± bi.
fn mixed(text: &str, index: usize, rest: &str) -> Result<Space, EcError> {
    let wrong = |problem| EcError::Syntax { text: text.to_owned(), at: 1, problem };
    let inner = rest.trim().strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    let numbers = inner.and_then(|inner| inner.split_once(','));
    let (a, b) = numbers.ok_or_else(|| wrong("this space needs two numbers, as in M4(1,0.2)"))?;
    let zeros = index.checked_sub(3).filter(|&zeros| zeros > 0);
    let zeros = zeros.ok_or_else(|| wrong("the smallest of these spaces is M4"))?;
    let [a, b] = [super::Real::typed(a)?, super::Real::typed(b)?];
    if a.value() == 0.0 || b.value() == 0.0 {
        return Err(wrong("neither number may be 0 here"));
    }
    if zeros > MAX_DIMENSION {
        return Err(EcError::Dimension { given: zeros + 4 });
    }
    let opposite = super::Real::from(-a.value());
    Space::new(vec![
        Root::zero(zeros),
        Root { re: a, im: b.clone(), multiplicity: 1 },
        Root { re: opposite, im: b, multiplicity: 1 },
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(text: &str) -> Space {
        text.parse().unwrap()
    }

    fn said(text: &str) -> String {
        text.parse::<Space>().unwrap_err().to_string()
    }

    #[test]
    fn families_have_their_roots() {
        let dimensions =
            ["P5", "T3", "H2", "AT2", "AH2", "AET1", "M4(1,0.2)"].map(|name| space(name).dimension());
        assert_eq!(dimensions, [6, 7, 5, 9, 9, 6, 5]);
        assert_eq!(space("AT2").to_string(), "0^3,i^2,2i");
        assert_eq!(space("aet1").to_string(), "0^2,1+i,-1+i");
        assert_eq!(space("M4(1, 1/5)").to_string(), "0,1+(1/5)*i,-1+(1/5)*i");
    }

    #[test]
    fn functions_and_equations_are_written() {
        assert_eq!(space("0^3,i^2").functions("u").join(", "), "1, u, u^2, cos u, sin u, u cos u, u sin u");
        let functions = space("0,1/4+2i,-1,1/(6*pi)").functions("t").join(", ");
        assert_eq!(functions, "1, e^(1/4 t) cos 2 t, e^(1/4 t) sin 2 t, e^(-t), e^(1/(6*pi) t)");
        assert_eq!(space("0,1/4+i").equation("y"), "y(3) - 0.5 y'' + 1.0625 y' = 0");
        assert_eq!(space("0^2,1^2,2^2").equation("v"), "v(6) - 6 v(5) + 13 v(4) - 12 v(3) + 4 v'' = 0");
    }

    #[test]
    fn wrong_spaces_say_what_is_right() {
        assert_eq!(said("i"), "the root 0 is missing; without it no basis sums to 1");
        assert_eq!(said("0,i,-i"), "the root i is there twice; raise its multiplicity instead, as in i^2");
        assert_eq!(
            said("0^2,1/2,0.5"),
            "the root 1/2 is there twice; raise its multiplicity instead, as in 1/2^2"
        );
        assert_eq!(said("0"), "the space has dimension 1; it must be 2 to 31");
        assert_eq!(said("0^2,i^15"), "the space has dimension 32; it must be 2 to 31");
        assert_eq!(said("T999999999999999999999999"), "the space has dimension 2001; it must be 2 to 31");
        assert_eq!(said("M3(1,2)"), "\"M3(1,2)\", character 1: the smallest of these spaces is M4");
        assert!(said("P5x").contains("character 3"));
    }

    #[test]
    fn roots_are_added_and_compared() {
        let space = space("0^2,i");
        let raised = space.with(&"i".parse().unwrap()).unwrap();
        assert_eq!(raised.to_string(), "0^2,i^2");
        assert!(raised.contains(&space) && !space.contains(&raised));
        assert!(space.with(&"i^31".parse().unwrap()).is_err());
        assert!(!self::space("0,1/4+i").is_symmetric() && self::space("0,1,-1,2+i,-2+i").is_symmetric());
    }
}
