//! Text from outside as it may be shown.

use std::borrow::Cow;

/// The text with its control characters as escapes such as `\u{1b}` and `\n`. A terminal would obey them, and the
/// marks that turn the direction of writing would show a name as another one.
pub fn visible(text: &str) -> Cow<'_, str> {
    let hidden = |letter: char| letter.is_control() || turns(letter);
    if !text.contains(hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 8);
    for letter in text.chars() {
        if hidden(letter) { shown.extend(letter.escape_default()) } else { shown.push(letter) }
    }
    Cow::Owned(shown)
}

/// Whether a character changes the direction of the characters around it (Unicode Standard Annex 9).
fn turns(letter: char) -> bool {
    matches!(letter, '\u{200e}' | '\u{200f}' | '\u{61c}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_escaped_and_letters_stay() {
        assert!(matches!(visible("görbe ű 12.5 \\"), Cow::Borrowed("görbe ű 12.5 \\")));
        assert_eq!(visible("a\u{1b}]0;x\u{7}\n"), "a\\u{1b}]0;x\\u{7}\\n");
        assert_eq!(visible("\u{9b}1m\u{202e}"), "\\u{9b}1m\\u{202e}");
    }
}
