//! The text of a file of tables: its bytes as letters, and its lines without comments and blank ones.

use super::super::FileError;
use super::Delimiter;
use std::borrow::Cow;

/// How comment lines begin.
const COMMENTS: [&str; 3] = ["#", "%", "//"];

/// How spreadsheets name the delimiter in a first line of its own: `sep=;`.
const SEPARATOR: &str = "sep=";

/// The text in the bytes of a file: UTF-8, or UTF-16 with a byte order mark.
///
/// # Errors
/// [`FileError::Text`] for what is neither.
pub(in crate::file) fn decoded(bytes: &[u8]) -> Result<Cow<'_, str>, FileError> {
    if let Some(text) = utf16(bytes) {
        return Ok(Cow::Owned(text));
    }
    std::str::from_utf8(bytes).map(Cow::Borrowed).map_err(|error| {
        let before = bytes.iter().take(error.valid_up_to());
        let line = 1 + before.filter(|&&byte| byte == b'\n').count();
        FileError::Text { line, place: String::new(), problem: "the text is not UTF-8".to_owned() }
    })
}

/// The text of a table. Only numbers and names matter there, which have the same bytes in all the code pages of
/// instruments and spreadsheets: what is not UTF-8 is read as Latin 1.
pub(in crate::file) fn decoded_table(bytes: &[u8]) -> Cow<'_, str> {
    decoded(bytes).unwrap_or_else(|_| Cow::Owned(bytes.iter().copied().map(char::from).collect()))
}

/// The text in UTF-16, if the byte order mark says that it is one.
fn utf16(bytes: &[u8]) -> Option<String> {
    let (order, bytes): (fn([u8; 2]) -> u16, _) = match bytes {
        [0xff, 0xfe, rest @ ..] => (u16::from_le_bytes, rest),
        [0xfe, 0xff, rest @ ..] => (u16::from_be_bytes, rest),
        _ => return None,
    };
    let units = bytes.chunks(2).map(|pair| match pair {
        &[a, b] => order([a, b]),
        // Half a letter at the end.
        _ => 0xfffd,
    });
    Some(char::decode_utf16(units).map(|letter| letter.unwrap_or('\u{fffd}')).collect())
}

/// The lines of a table.
#[derive(Debug)]
pub(in crate::file) struct Lines<'t> {
    /// Those that count, each with a line feed behind it.
    pub(in crate::file) text: String,
    /// Their numbers in the file.
    pub(in crate::file) numbers: Vec<usize>,
    /// The comments without their sign, with the numbers of their lines.
    pub(in crate::file) comments: Vec<(usize, &'t str)>,
    /// The delimiter that the first line names.
    pub(in crate::file) delimiter: Option<Delimiter>,
}

impl<'t> Lines<'t> {
    /// The lines of a text, which end with a carriage return, a line feed or both.
    ///
    /// # Errors
    /// [`FileError::Text`] for a text with zero bytes.
    pub(in crate::file) fn read(text: &'t str) -> Result<Lines<'t>, FileError> {
        let text = text.trim_start_matches('\u{feff}');
        let mut lines = Lines {
            text: String::with_capacity(text.len() + 1),
            numbers: Vec::new(),
            comments: Vec::new(),
            delimiter: None,
        };
        let mut number = 0;
        for line in text.split('\n').map(|line| line.strip_suffix('\r').unwrap_or(line)) {
            for line in line.split('\r') {
                number += 1;
                lines.add(number, line)?;
            }
        }
        Ok(lines)
    }

    fn add(&mut self, number: usize, line: &'t str) -> Result<(), FileError> {
        if line.contains('\0') {
            let problem = "there is a zero byte; text is UTF-8, or UTF-16 with a byte order mark".to_owned();
            return Err(FileError::Text { line: number, place: String::new(), problem });
        }
        let bare = line.trim();
        if let Some(comment) = COMMENTS.iter().find_map(|sign| bare.strip_prefix(sign)) {
            self.comments.push((number, comment.trim_start_matches(['#', '%', '/']).trim()));
        } else if let Some(sign) = bare.strip_prefix(SEPARATOR).filter(|_| self.numbers.is_empty()) {
            self.delimiter = match line.trim_start().get(SEPARATOR.len()..).unwrap_or(sign) {
                "\t" => Some(Delimiter::Tab),
                sign => sign.parse().ok(),
            };
        } else if !bare.is_empty() {
            self.text.push_str(line);
            self.text.push('\n');
            self.numbers.push(number);
        }
        Ok(())
    }

    /// The comment right above a line of the file.
    pub(in crate::file) fn comment_above(&self, line: usize) -> Option<&'t str> {
        let after = self.comments.partition_point(|(number, _)| *number < line);
        self.comments.get(after.checked_sub(1)?).map(|(_, comment)| *comment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_ends_comments_and_blank_lines() {
        let lines = Lines::read("\u{feff}a\r\n\r\n# one\rb\n\n  % x, y\nc").unwrap();
        assert_eq!(lines.text, "a\nb\nc\n");
        assert_eq!(lines.numbers, [1, 4, 7]);
        assert_eq!(lines.comments, [(3, "one"), (6, "x, y")]);
        assert_eq!(
            [lines.comment_above(4), lines.comment_above(7), lines.comment_above(1)],
            [Some("one"), Some("x, y"), None]
        );
        assert_eq!(Lines::read("sep=;\nx;y\n").unwrap().delimiter, Some(Delimiter::Semicolon));
        assert!(Lines::read("a\0b").is_err());
    }

    #[test]
    fn wide_text() {
        assert_eq!(decoded(b"\xff\xfea\0\x51\x01").unwrap(), "aő");
        assert_eq!(decoded(b"\xfe\xff\0a\x01\x51").unwrap(), "aő");
        assert_eq!(decoded_table(b"\xff\xfea\0\x00\xd8b"), "a\u{fffd}\u{fffd}");
        assert_eq!(decoded(b"a\n\xff").unwrap_err().to_string(), "line 2: the text is not UTF-8");
        assert_eq!(decoded_table(b"\xb5m\xa0"), "µm\u{a0}");
    }
}
