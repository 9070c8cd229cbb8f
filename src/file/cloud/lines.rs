//! Lines of text from pieces of a file, and the words and numbers in them.

use super::super::FileError;

/// More than any line of points has; a longer one is refused before it fills the memory.
const LONGEST_LINE: usize = 1 << 20;

/// Cuts pieces of text into lines, which end with a carriage return, a line feed or both.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// The beginning of a line whose end is still to come.
    begun: Vec<u8>,
    /// How many lines have been handed on.
    number: usize,
    /// Whether the last piece ended with a carriage return.
    after_return: bool,
}

impl Lines {
    /// Lines that follow so many others.
    pub(super) fn after(number: usize) -> Lines {
        Lines { number, ..Lines::default() }
    }

    /// The number of the line that is being read, from 1.
    pub(super) fn current(&self) -> usize {
        self.number + 1
    }

    /// Hands on every line that ends in this piece, with its number.
    ///
    /// # Errors
    /// [`FileError::Text`] for a zero byte and an endless line, and those of `line`.
    pub(super) fn feed(
        &mut self,
        piece: &[u8],
        mut line: impl FnMut(usize, &[u8]) -> Result<(), FileError>,
    ) -> Result<(), FileError> {
        let mut rest = piece;
        if !rest.is_empty() && std::mem::take(&mut self.after_return) {
            rest = rest.strip_prefix(b"\n").unwrap_or(rest);
        }
        while let Some(at) = rest.iter().position(|&byte| byte == b'\n' || byte == b'\r') {
            let (part, end) = rest.split_at(at);
            self.check_length(part)?;
            if self.begun.is_empty() {
                self.number += 1;
                checked(self.number, part).and_then(|()| line(self.number, part))?;
            } else {
                self.begun.extend_from_slice(part);
                self.end(&mut line)?;
            }
            rest = match end {
                [b'\r', b'\n', rest @ ..] | [_, rest @ ..] => rest,
                [] => end,
            };
            self.after_return = end == b"\r";
        }
        self.check_length(rest)?;
        self.begun.extend_from_slice(rest);
        Ok(())
    }

    /// Hands on the last line, if it has no end.
    ///
    /// # Errors
    /// Those of [`Lines::feed`].
    pub(super) fn finish(
        &mut self,
        mut line: impl FnMut(usize, &[u8]) -> Result<(), FileError>,
    ) -> Result<(), FileError> {
        if self.begun.is_empty() { Ok(()) } else { self.end(&mut line) }
    }

    fn end(&mut self, line: &mut impl FnMut(usize, &[u8]) -> Result<(), FileError>) -> Result<(), FileError> {
        self.number += 1;
        checked(self.number, &self.begun).and_then(|()| line(self.number, &self.begun))?;
        self.begun.clear();
        Ok(())
    }

    fn check_length(&self, part: &[u8]) -> Result<(), FileError> {
        if self.begun.len() + part.len() <= LONGEST_LINE {
            return Ok(());
        }
        let problem = format!("it is longer than {LONGEST_LINE} bytes; this is no text of points");
        Err(wrong(self.current(), String::new(), problem))
    }
}

/// A line without zero bytes.
fn checked(number: usize, line: &[u8]) -> Result<(), FileError> {
    if !line.contains(&0) {
        return Ok(());
    }
    Err(wrong(number, String::new(), "there is a zero byte; this is no text of points".to_owned()))
}

/// Something wrong in a line.
pub(super) fn wrong(line: usize, place: String, problem: String) -> FileError {
    FileError::Text { line, place, problem }
}

/// Whether a byte separates words.
pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

/// The words of a line, up to a comment after `#`.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    let words = line.split(|&byte| is_blank(byte)).filter(|word| !word.is_empty());
    words.take_while(|word| word.first() != Some(&b'#'))
}

/// A line without blanks around it.
pub(super) fn trimmed(mut line: &[u8]) -> &[u8] {
    while let [first, rest @ ..] = line
        && is_blank(*first)
    {
        line = rest;
    }
    while let [rest @ .., last] = line
        && is_blank(*last)
    {
        line = rest;
    }
    line
}

/// A number as programs write it: besides what Rust reads, the exponents of Fortran (`1.5D+03`) and what is no number
/// (`-nan(ind)`, `1.#INF`), which is NaN or infinite.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| unusual(text))
}

fn unusual(text: &str) -> Option<f64> {
    let text = text.to_ascii_lowercase();
    let bare = text.trim_start_matches(['+', '-']);
    if bare.starts_with("nan") || bare.starts_with("1.#") {
        return Some(f64::NAN);
    }
    let (digits, exponent) = text.split_once('d')?;
    format!("{digits}e{exponent}").parse().ok()
}

/// The message about a word that is no number. What is very long is cut.
pub(super) fn no_number(word: &[u8]) -> String {
    const MOST: usize = 40;
    let text = String::from_utf8_lossy(word);
    let cut = text.char_indices().nth(MOST).map_or(text.len(), |(at, _)| at);
    let dots = if cut < text.len() { "..." } else { "" };
    format!("\"{}{dots}\" is not a number", text.get(..cut).unwrap_or_default())
}

/// The point in the next three words; `None` if there are fewer. `before` words stand before them in the line.
///
/// # Errors
/// [`FileError::Text`] for a word that is no number.
pub(super) fn point<'l>(
    mut words: impl Iterator<Item = &'l [u8]>,
    line: usize,
    before: usize,
) -> Result<Option<[f64; 3]>, FileError> {
    let mut point = [0.0; 3];
    for (at, value) in point.iter_mut().enumerate() {
        let Some(word) = words.next() else { return Ok(None) };
        *value =
            number(word).ok_or_else(|| wrong(line, format!("word {}", before + at + 1), no_number(word)))?;
    }
    Ok(Some(point))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn lines(pieces: &[&[u8]]) -> Result<Vec<(usize, String)>, FileError> {
        let mut found = Vec::new();
        let mut lines = Lines::default();
        let mut keep = |number: usize, line: &[u8]| {
            found.push((number, String::from_utf8_lossy(line).into_owned()));
            Ok(())
        };
        for piece in pieces {
            lines.feed(piece, &mut keep)?;
        }
        lines.finish(&mut keep)?;
        Ok(found)
    }

    #[test]
    fn line_ends_of_all_systems() {
        let found = lines(&[b"a\nb\r", b"", b"\nc\rd\n", b"\r\ne"]).unwrap();
        let found: Vec<&str> = found.iter().map(|(_, line)| line.as_str()).collect();
        assert_eq!(found, ["a", "b", "c", "d", "", "e"]);
        assert_eq!(
            lines(&[b"a\nb\0c\n"]).unwrap_err().to_string().split(';').next(),
            Some("line 2: there is a zero byte")
        );
        let long = vec![b'1'; LONGEST_LINE];
        assert!(lines(&[b"a\n", &long]).is_ok());
        let problem = lines(&[b"a\n", &long, b"1"]).unwrap_err().to_string();
        assert!(problem.starts_with("line 2: it is longer than 1048576 bytes"), "{problem}");
    }

    #[test]
    fn numbers_of_other_languages() {
        for (word, value) in [("1e3", 1000.0), ("+.5", 0.5), ("5.", 5.0), ("-1.5D+03", -1500.0), ("2d0", 2.0)]
        {
            assert_eq!(number(word.as_bytes()), Some(value), "{word}");
        }
        for word in ["nan", "NaN", "-nan(ind)", "+NAN", "1.#QNAN", "-1.#IND00", "inf", "-Infinity", "1e999"] {
            assert!(number(word.as_bytes()).is_some_and(|value| !value.is_finite()), "{word}");
        }
        for word in ["", "x", "1,5", "1.5.2", "0x10", "d", "1d", "dd1", "1_000", "--1", "\u{ff11}"] {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
    }

    proptest! {
        #[test]
        fn pieces_make_no_difference(text in "[a\r\n]{0,40}", cuts in prop::collection::vec(0_usize..40, 0..5)) {
            let mut cuts: Vec<usize> = cuts.into_iter().map(|cut| cut.min(text.len())).collect();
            cuts.extend([0, text.len()]);
            cuts.sort_unstable();
            let pieces: Vec<&[u8]> = cuts.windows(2).map(|cut| &text.as_bytes()[cut[0]..cut[1]]).collect();
            let found = lines(&pieces).unwrap();
            prop_assert_eq!(&found, &lines(&[text.as_bytes()]).unwrap());
            let expected = text.replace("\r\n", "\n").replace('\r', "\n");
            let expected: Vec<(usize, String)> = (1..).zip(expected.lines().map(str::to_owned)).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
