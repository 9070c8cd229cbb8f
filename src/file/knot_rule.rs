//! The knots that a curve's settings name: a rule, or the knots themselves.

use crate::geometry::ph::Knots;
use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;

/// The knots of a PH spline, a spline or a B-spline; in JSON the name of a rule or a list of numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum KnotRule {
    /// They follow from the points.
    By(Knots),
    /// They are given, for B-splines.
    Given(Vec<f64>),
}

impl KnotRule {
    /// The rule; `None` for knots that are given.
    #[must_use]
    pub fn rule(&self) -> Option<Knots> {
        match self {
            Self::By(rule) => Some(*rule),
            Self::Given(_) => None,
        }
    }
}

impl From<Knots> for KnotRule {
    fn from(rule: Knots) -> Self {
        Self::By(rule)
    }
}

impl Serialize for KnotRule {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::By(rule) => rule.serialize(serializer),
            Self::Given(knots) => knots.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for KnotRule {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Either)
    }
}

struct Either;

impl<'de> Visitor<'de> for Either {
    type Value = KnotRule;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("chord, uniform, centripetal or a list of knots")
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<KnotRule, E> {
        let rule = Knots::from_name(name).map(KnotRule::By);
        rule.ok_or_else(|| E::invalid_value(de::Unexpected::Str(name), &self))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<KnotRule, A::Error> {
        let mut knots = Vec::new();
        while let Some(knot) = list.next_element()? {
            knots.push(knot);
        }
        Ok(KnotRule::Given(knots))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_or_a_list() {
        for (text, rule) in [
            ("\"chord\"", KnotRule::By(Knots::Chord)),
            ("[0.0,0.5,1.0]", KnotRule::Given(vec![0.0, 0.5, 1.0])),
        ] {
            assert_eq!(serde_json::from_str::<KnotRule>(text).unwrap(), rule);
            assert_eq!(serde_json::to_string(&rule).unwrap(), text);
        }
        for text in ["3", "null", "\"round\"", "[0,\"x\"]", "{}"] {
            assert!(serde_json::from_str::<KnotRule>(text).is_err(), "{text}");
        }
    }
}
