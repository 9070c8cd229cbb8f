//! A message of the list with holes: `{}` carries over what stands there, `{*}` also puts it into Hungarian.

/// A message with holes, cut into pieces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pattern {
    /// What stands before the first hole.
    start: &'static str,
    /// The holes: whether what stands there is put into Hungarian, and what follows.
    holes: Vec<(bool, &'static str)>,
}

impl Pattern {
    pub(super) fn new(text: &'static str) -> Pattern {
        let mut pieces = Vec::new();
        let mut rest = text;
        let mut translated = false;
        loop {
            let next = ["{}", "{*}"].map(|hole| rest.find(hole));
            let (at, hole) = match next {
                [Some(plain), Some(told)] if told < plain => (told, "{*}"),
                [Some(plain), _] => (plain, "{}"),
                [None, Some(told)] => (told, "{*}"),
                [None, None] => break,
            };
            pieces.push((translated, rest.get(..at).unwrap_or_default()));
            translated = hole.len() == 3;
            rest = rest.get(at + hole.len()..).unwrap_or_default();
        }
        pieces.push((translated, rest));
        let (_, start) = pieces.remove(0);
        Pattern { start, holes: pieces }
    }

    /// Whether it has no hole.
    pub(super) fn is_fixed(&self) -> bool {
        self.holes.is_empty()
    }

    /// How many letters of a message it names itself: of two patterns that fit, the one with more is meant.
    pub(super) fn letters(&self) -> usize {
        self.start.len() + self.holes.iter().map(|(_, after)| after.len()).sum::<usize>()
    }

    /// What stands in the holes of a message, and whether that is put into Hungarian; `None` for another message. A hole
    /// ends where what follows it stands for the first time.
    pub(super) fn values<'a>(&self, message: &'a str) -> Option<Vec<(bool, &'a str)>> {
        let mut rest = message.strip_prefix(self.start)?;
        let Some((last, inner)) = self.holes.split_last() else {
            return rest.is_empty().then(Vec::new);
        };
        let mut values = Vec::with_capacity(self.holes.len());
        for &(translated, after) in inner {
            let at = rest.find(after)?;
            values.push((translated, rest.get(..at)?));
            rest = rest.get(at + after.len()..)?;
        }
        values.push((last.0, rest.strip_suffix(last.1)?));
        // A plain value is a name or a number, not a part of another sentence.
        let plain = |value: &str| !value.contains("; ") && !value.contains(": ") && !value.ends_with(':');
        let fits = |(told, value): &(bool, &str)| !value.is_empty() && (*told || plain(value));
        values.iter().all(fits).then_some(values)
    }
}

/// Whether a message begins and ends like a text of the list, up to its holes. A quick look, so that few of the thousands
/// of texts have to be cut into pieces.
pub(super) fn may_fit(text: &str, message: &str) -> bool {
    let mut begin = text.bytes().zip(message.bytes()).take_while(|&(own, _)| own != b'{');
    let mut end = text.bytes().rev().zip(message.bytes().rev()).take_while(|&(own, _)| own != b'}');
    begin.all(|(own, other)| own == other) && end.all(|(own, other)| own == other)
}

/// A text of the list with the values in its holes: `{}` is the next one, `{2}` the second.
pub(super) fn filled(text: &str, values: &[String]) -> String {
    let mut filled = String::new();
    let (mut rest, mut next) = (text, 0);
    while let Some((before, hole, after)) = first_hole(rest) {
        filled += before;
        let number = if hole.is_empty() { next } else { hole.parse().unwrap_or(usize::MAX).wrapping_sub(1) };
        next = number.wrapping_add(1);
        filled += values.get(number).map_or("", String::as_str);
        rest = after;
    }
    filled + rest
}

/// What stands before the first hole, in it and behind it.
pub(super) fn first_hole(text: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = text.split_once('{')?;
    let (hole, after) = rest.split_once('}')?;
    Some((before, hole, after))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_quick_look_lets_through_what_fits(message in "[ab{}* ]{0,8}", text in 0_usize..7) {
            let text = ["a{}b", "{}", "{*} b", "a", "a {", "b}", "a{*}{}"][text];
            prop_assert!(may_fit(text, &message) || Pattern::new(text).values(&message).is_none());
        }
    }

    #[test]
    fn a_message_is_recognized_with_its_values() {
        let pattern = Pattern::new("knot {} is {*}, not {}");
        let values = pattern.values("knot 5 is too near, not 7").unwrap();
        assert_eq!(values, [(false, "5"), (true, "too near"), (false, "7")]);
        assert_eq!(pattern.letters(), "knot  is , not ".len());
        for other in ["knot 5 is 6", "a knot 5 is 6, not 7", "knot 5 is , not 7", ""] {
            assert_eq!(pattern.values(other), None, "{other}");
        }
        assert!(Pattern::new("nothing").is_fixed());
        assert_eq!(Pattern::new("nothing").values("nothing"), Some(vec![]));
        assert_eq!(Pattern::new("nothing").values("nothing more"), None);
    }

    #[test]
    fn values_stand_where_the_text_wants_them() {
        let values = ["a", "b"].map(String::from);
        assert_eq!(filled("{} és {}.", &values), "a és b.");
        assert_eq!(filled("{2} ({1})", &values), "b (a)");
        assert_eq!(filled("{9} {x} {0}!", &values), "  !");
        assert_eq!(filled("nyitva {", &values), "nyitva {");
    }
}
