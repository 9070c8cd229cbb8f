//! What a user may have meant by a name that does not exist.

/// How alike two names must be, 0 to 1.
const ALIKE: f64 = 0.75;

/// `; did you mean "gb_2d_ip"?` for the known name that is most like the given one, or nothing.
#[must_use]
pub fn meant<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let given = given.to_lowercase();
    let likeness = |name: &str| strsim::jaro_winkler(&given, &name.to_lowercase());
    let alike =
        known.into_iter().map(|name| (likeness(name), name)).filter(|(likeness, _)| *likeness >= ALIKE);
    let best = alike.max_by(|a, b| a.0.total_cmp(&b.0));
    best.map_or_else(String::new, |(_, name)| format!("; did you mean {name:?}?"))
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn the_most_alike_is_told() {
        let known = ["gb_2d_ip", "gb_2d_bt", "biliard", "render"];
        assert_eq!(meant("bilard", known), "; did you mean \"biliard\"?");
        assert_eq!(meant("GB2D_IP", known), "; did you mean \"gb_2d_ip\"?");
        assert_eq!(meant("rneder", known), "; did you mean \"render\"?");
        assert_eq!(meant("xylophone", known), "");
        assert_eq!(meant("", known), "");
    }
}
