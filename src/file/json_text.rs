//! JSON as text: laying it out for people, and finding the field at a place of the text.

/// Breaks a compact JSON text into lines: one for every field, and one for every item of an outer list;
/// inner lists stay on their line. Whole numbers lose their `.0`.
pub(super) fn laid_out(compact: &str) -> String {
    let mut out = String::with_capacity(compact.len() * 2);
    let mut open: Vec<Bracket> = Vec::new();
    let mut rest = compact;
    while let Some(token) = next_token(rest) {
        let after = rest.get(token.len()..).unwrap_or("");
        match token {
            "{" | "[" => {
                let outer = open.last().is_none_or(|parent| !parent.list);
                let filled = !after.starts_with(['}', ']']);
                let list = token == "[";
                open.push(Bracket { list, broken: outer && filled && (!list || holds_brackets(after)) });
                out.push_str(token);
                break_line(&mut out, &open, "");
            }
            "}" | "]" => {
                if open.pop().is_some_and(|bracket| bracket.broken) {
                    new_line(&mut out, open.len());
                }
                out.push_str(token);
            }
            "," => {
                out.push(',');
                break_line(&mut out, &open, " ");
            }
            ":" => out.push_str(": "),
            "-0.0" => out.push_str(token),
            _ => out.push_str(token.strip_suffix(".0").unwrap_or(token)),
        }
        rest = after;
    }
    out.push('\n');
    out
}

/// An open bracket while a text is being laid out.
struct Bracket {
    list: bool,
    /// Whether its items stand on lines of their own.
    broken: bool,
}

/// The field and index (from 0) at a line and column as serde_json counts them: `points[2][0]`; empty at the
/// outermost level.
pub(super) fn place(text: &str, line: usize, column: usize) -> String {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let end = (before + column).min(text.len());
    let mut rest = text.get(..end).unwrap_or(text);
    let mut path: Vec<Step> = Vec::new();
    while let Some(token) = next_token(rest) {
        rest = rest.get(token.len()..).unwrap_or("");
        match (token, path.last_mut()) {
            ("{", _) => path.push(Step::Field(String::new(), Awaiting::Key)),
            ("[", _) => path.push(Step::Item(0)),
            ("}" | "]", _) => {
                path.pop();
            }
            (",", Some(Step::Item(index))) => *index += 1,
            (",", Some(Step::Field(_, awaiting))) => *awaiting = Awaiting::Key,
            (":", Some(Step::Field(_, awaiting))) => *awaiting = Awaiting::Value,
            (key, Some(Step::Field(name, Awaiting::Key))) => *name = key.trim_matches('"').to_owned(),
            _ => {}
        }
    }
    let mut out = String::new();
    for step in path {
        match step {
            Step::Item(index) => out.push_str(&format!("[{index}]")),
            Step::Field(name, _) if out.is_empty() => out = name,
            Step::Field(name, _) if name.is_empty() => {}
            Step::Field(name, _) => out.push_str(&format!(".{name}")),
        }
    }
    out
}

enum Step {
    Item(usize),
    Field(String, Awaiting),
}

enum Awaiting {
    Key,
    Value,
}

/// The text up to the end of the next bracket, comma, colon, string or run of other characters; blanks go
/// with it only in front of the latter, where they do no harm.
fn next_token(text: &str) -> Option<&str> {
    let bytes = text.as_bytes();
    let length = match *bytes.first()? {
        b'{' | b'}' | b'[' | b']' | b',' | b':' => 1,
        b'"' => string_length(bytes),
        first => {
            let blank = first.is_ascii_whitespace();
            let ends = |b: &u8| b"{}[],:\"".contains(b) || b.is_ascii_whitespace() != blank;
            bytes.iter().position(ends).unwrap_or(bytes.len())
        }
    };
    // Tokens end before or after ASCII characters, so this is a character boundary.
    text.get(..length)
}

/// Bytes of the string that begins here, with its quotes; all of them if it does not end.
fn string_length(bytes: &[u8]) -> usize {
    let mut escaped = false;
    for (index, byte) in bytes.iter().enumerate().skip(1) {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'"' => return index + 1,
            _ => {}
        }
    }
    bytes.len()
}

/// Whether a list, whose bracket has just been opened, has lists or objects in it.
fn holds_brackets(mut text: &str) -> bool {
    while let Some(token) = next_token(text) {
        match token {
            "{" | "[" => return true,
            "]" => return false,
            _ => text = text.get(token.len()..).unwrap_or(""),
        }
    }
    false
}

fn break_line(out: &mut String, open: &[Bracket], otherwise: &str) {
    let broken = open.last().is_some_and(|bracket| bracket.broken);
    if broken { new_line(out, open.len()) } else { out.push_str(otherwise) }
}

fn new_line(out: &mut String, depth: usize) {
    out.push('\n');
    out.push_str(&"  ".repeat(depth));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_lists_break_once() {
        let compact =
            r#"{"format":"X","row":[1.0,-0.0,2.5],"net":[[[1.0,2],[3,4]],[[5,6]]],"empty":[],"o":{"a":1}}"#;
        let expected = "{
  \"format\": \"X\",
  \"row\": [1, -0.0, 2.5],
  \"net\": [
    [[1, 2], [3, 4]],
    [[5, 6]]
  ],
  \"empty\": [],
  \"o\": {
    \"a\": 1
  }
}
";
        assert_eq!(laid_out(compact), expected);
    }

    #[test]
    fn the_field_at_a_place() {
        let text = "{\n \"a\": [[1, 2],\n [3, \"x, y\", 5]], \"b\": {\"c\": 7}}";
        assert_eq!(place(text, 3, 4), "a[1][1]");
        assert_eq!(place(text, 3, 13), "a[1][2]");
        assert_eq!(place(text, 3, 30), "b.c");
        assert_eq!(place(text, 1, 1), "");
        assert_eq!(place("ő", 1, 1), "");
        assert_eq!(place(text, 99, 99), "");
    }
}
