//! Lists of values in options: one curve, or a series of them in one picture.

use crate::curve::CurveArgs;
use crate::surface::Common;
use grafika::design::Design;
use grafika::file::{Document, Method, number};
use grafika::launch::{Failure, Opened};

/// The most curves that a series has.
pub(crate) const MOST: usize = 16;

/// A curve of a series.
pub(crate) struct Member {
    /// What is different about it, as in `k0=0.5`.
    pub(crate) label: String,
    pub(crate) design: Design,
}

/// A parameter that a series may run through: its name, its values, and how one of them is set.
type Parameter<'a> = (&'static str, &'a [f64], fn(&mut Common, f64));

impl CurveArgs {
    /// What the command line says about one curve.
    ///
    /// # Errors
    /// Several values of an option.
    pub(crate) fn common(&self) -> Result<Common, Failure> {
        let counts = [
            ("--method", self.method.len()),
            ("--k0", self.k0.len()),
            ("--bias", self.bias.len()),
            ("--tension", self.tension.len()),
        ];
        if let Some((option, count)) = counts.into_iter().find(|(_, count)| *count > 1) {
            return Err(Failure::usage(format!(
                "{option} has {count} values; one is taken here, and grafika render draws several curves together"
            )));
        }
        let first = |values: &[f64]| values.first().copied();
        let method = self.methods().first().copied();
        Ok(Common { method, k0: first(&self.k0), bias: first(&self.bias), tension: first(&self.tension) })
    }

    /// Whether several curves are asked for.
    pub(crate) fn is_series(&self) -> bool {
        [self.k0.len(), self.bias.len(), self.tension.len(), self.method.len()].into_iter().any(|n| n > 1)
    }

    fn methods(&self) -> Vec<Method> {
        self.method.iter().filter_map(|name| Method::from_name(name)).collect()
    }

    fn parameters(&self) -> [Parameter<'_>; 3] {
        [
            ("k0", &self.k0, |common, value| common.k0 = Some(value)),
            ("bias", &self.bias, |common, value| common.bias = Some(value)),
            ("tension", &self.tension, |common, value| common.tension = Some(value)),
        ]
    }

    /// Opens the file; the curves of the series, and the name of the file.
    ///
    /// # Errors
    /// A value that comes twice, too many curves, a parameter that no method has, a surface, and what is wrong with one
    /// of the curves.
    pub(crate) fn series(&self) -> Result<(Vec<Member>, String), Failure> {
        self.check_values()?;
        let Opened { name, document, .. } = self.source.open()?;
        if !matches!(document, Document::PlanePoints(_) | Document::SpacePoints(_) | Document::Cloud(_)) {
            return Err(Failure::usage(format!(
                "{name} holds no control points of curves; several values are for those"
            )));
        }
        let named = self.methods();
        let methods = if named.is_empty() { vec![None] } else { named.iter().copied().map(Some).collect() };
        let mut used = [false; 3];
        let mut choices: Vec<(String, Common)> = Vec::new();
        for method in methods {
            let plain = Common { method, k0: None, bias: None, tension: None };
            let drawn = match method {
                Some(method) => Some(method),
                None => sketched(&self.design_of(document.clone(), &name, plain)?),
            };
            let label = method.filter(|_| named.len() > 1).map_or("", Method::name);
            let mut of_method = vec![(label.to_owned(), plain)];
            for ((parameter, values, set), used) in self.parameters().into_iter().zip(&mut used) {
                // With one method alone, what it lacks is told below.
                if values.is_empty() || named.len() > 1 && !has(drawn, parameter) {
                    continue;
                }
                *used = true;
                of_method = of_method
                    .iter()
                    .flat_map(|(label, common)| values.iter().map(move |&value| (label, *common, value)))
                    .map(|(label, mut common, value)| {
                        set(&mut common, value);
                        let told = if values.len() > 1 {
                            format!("{parameter}={}", number(value))
                        } else {
                            String::new()
                        };
                        ([label.as_str(), &told].join(" ").trim().to_owned(), common)
                    })
                    .collect();
            }
            choices.extend(of_method);
            if choices.len() > MOST {
                let count = self.count();
                return Err(Failure::usage(format!(
                    "these are {count} curves or more; a picture takes {MOST} at most: give fewer values"
                )));
            }
        }
        for ((parameter, values, _), used) in self.parameters().into_iter().zip(used) {
            if !values.is_empty() && !used {
                return Err(Failure::usage(format!("--{parameter}: none of these methods has it")));
            }
        }
        let member = |(label, common): (String, Common)| {
            let design = self.design_of(document.clone(), &name, common)?;
            Ok(Member { label, design })
        };
        Ok((choices.into_iter().map(member).collect::<Result<_, Failure>>()?, name))
    }

    /// How many curves the values make, if every method has every parameter.
    fn count(&self) -> usize {
        let counts = [self.method.len(), self.k0.len(), self.bias.len(), self.tension.len()];
        counts.into_iter().map(|count| count.max(1)).fold(1, usize::saturating_mul)
    }

    /// No value may come twice: nobody could tell the curves apart.
    fn check_values(&self) -> Result<(), Failure> {
        let twice = |option: &str, value: &str| {
            Failure::usage(format!("--{option} has {value} twice; give every value once"))
        };
        let mut named = self.method.iter().enumerate();
        if let Some((_, name)) = named.find(|(index, name)| self.method[..*index].contains(name)) {
            return Err(twice("method", name));
        }
        for (parameter, values, _) in self.parameters() {
            let mut numbered = values.iter().enumerate();
            if let Some((_, value)) = numbered.find(|(index, value)| values[..*index].contains(value)) {
                return Err(twice(parameter, &number(*value)));
            }
        }
        Ok(())
    }
}

/// The method that control points are drawn by.
fn sketched(design: &Design) -> Option<Method> {
    match design {
        Design::Plane(sketch) => sketch.method(),
        Design::Space(sketch) => sketch.method(),
        _ => None,
    }
}

/// Whether a method has a parameter of this name.
fn has(method: Option<Method>, parameter: &str) -> bool {
    match method {
        Some(Method::Coons | Method::Local) => parameter == "k0",
        Some(Method::Beta) => parameter != "k0",
        Some(Method::PhHermite) => parameter == "k0",
        _ => false,
    }
}

/// Reads one of the values.
pub(crate) fn value(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| "give a number, or several joined by commas, as in 0.3,0.5,1".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_finite_numbers() {
        assert_eq!([value("0.5"), value(" -3 "), value("1e3")], [Ok(0.5), Ok(-3.0), Ok(1000.0)]);
        for text in ["", "nan", "inf", "-inf", "1;2", "0,5", "x"] {
            assert!(value(text).is_err(), "{text:?}");
        }
    }

    #[test]
    fn parameters_belong_to_methods() {
        assert!(has(Some(Method::Coons), "k0") && !has(Some(Method::Spline), "k0"));
        assert!(has(Some(Method::Beta), "bias") && has(Some(Method::Beta), "tension"));
        assert!(!has(None, "k0") && !has(Some(Method::Beta), "k0"));
    }
}
