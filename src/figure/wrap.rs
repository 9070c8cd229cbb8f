//! Breaking text into lines.

/// Breaks a text into lines of at most `width` characters, at blanks where possible; longer words are broken
/// anywhere. No line breaks at a no-break space (U+00A0). An empty text is one empty line.
///
/// ```
/// assert_eq!(grafika::figure::wrap("one two three", 7), ["one two", "three"]);
/// ```
#[must_use]
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = vec![String::new()];
    let breaks = |letter: char| letter.is_whitespace() && letter != '\u{a0}';
    for word in text.split(breaks).filter(|word| !word.is_empty()) {
        let mut word: Vec<char> = word.chars().collect();
        while !word.is_empty() {
            let line = lines.last_mut().expect("there is always a line: the list starts with one");
            let used = line.chars().count();
            let gap = usize::from(used > 0);
            if used + gap + word.len() <= width {
                line.extend(std::iter::repeat_n(' ', gap));
                line.extend(word.drain(..));
            } else if used > 0 {
                lines.push(String::new());
            } else {
                // A word that is longer than a line is broken behind a hyphen, or anywhere.
                let hyphen = word.iter().take(width).rposition(|letter| *letter == '-');
                line.extend(word.drain(..hyphen.map_or(width, |at| at + 1)));
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_at_blanks_and_long_words_anywhere() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("abcdefghij kl", 4), ["abcd", "efgh", "ij", "kl"]);
        assert_eq!(wrap("a b\u{a0}c", 4), ["a", "b\u{a0}c"]);
        assert_eq!(wrap("", 4), [""]);
        assert_eq!(wrap("ab", 0), ["a", "b"]);
    }
}
