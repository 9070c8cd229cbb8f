//! What a user may have meant by a name that does not exist.

/// The letters of which one may be wrong: a third of a name, and always one.
const OF_WRONG: usize = 3;
/// The letters from which on a name is known by its beginning.
const BEGUN: usize = 3;

/// `; did you mean "gb_2d_ip"?` for the known name that is most like the given one, or nothing.
#[must_use]
pub fn meant<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let typed = given.to_lowercase();
    let letters = typed.chars().count();
    let wrong = |name: &str| {
        let name = name.to_lowercase();
        match letters >= BEGUN && name.starts_with(&typed) {
            true => 1,
            false => strsim::damerau_levenshtein(&typed, &name),
        }
    };
    let near = known.into_iter().map(|name| (wrong(name), name));
    let near = near.filter(|(wrong, _)| letters > 1 && *wrong <= (letters / OF_WRONG).max(1));
    near.min_by_key(|(wrong, _)| *wrong)
        .map_or_else(String::new, |(_, name)| format!("; did you mean {name:?}?"))
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn the_most_alike_is_told() {
        let known = ["gb_2d_ip", "gb_2d_bt", "biliard", "render", "config", "SNAIL.KCE", "svg"];
        for (given, name) in [
            ("bilard", "biliard"),
            ("GB2D_IP", "gb_2d_ip"),
            ("rneder", "render"),
            ("conf", "config"),
            ("svgg", "svg"),
            ("snall.kce", "SNAIL.KCE"),
        ] {
            assert_eq!(meant(given, known), format!("; did you mean {name:?}?"));
        }
        for given in ["xylophone", "", "x", "nofile.CSK", "ab"] {
            assert_eq!(meant(given, known), "", "{given}");
        }
    }
}
