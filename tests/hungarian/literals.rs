//! The texts in a Rust source that a user may come to see, with their holes filled in.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The literals of a source that are sentences: with words and blanks between them, outside of tests, attributes, and
/// tables of both languages. Every hole of a format is 7.
pub(crate) fn sentences(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    read(source.parse().expect("the source is Rust"), &mut found);
    found.retain(|text| text.split(' ').filter(|word| word.chars().any(char::is_lowercase)).count() > 1);
    found
}

fn read(tokens: TokenStream, found: &mut Vec<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match token {
            // An attribute, and with that of tests the item below it.
            TokenTree::Punct(sign) if sign.as_char() == '#' => {
                let inner = matches!(tokens.get(at), Some(TokenTree::Punct(sign)) if sign.as_char() == '!');
                at += usize::from(inner);
                let attribute = tokens.get(at).map(ToString::to_string).unwrap_or_default();
                at += 1;
                if ["[cfg (test)]", "[test]", "[cfg(test)]"].contains(&attribute.as_str()) {
                    at += tokens[at..].iter().position(is_end).map_or(0, |end| end + 1);
                }
            }
            // What is written for both languages, and what is said of a mistake of ours.
            TokenTree::Ident(name)
                if ["Words", "Hot", "expect", "assert", "debug_assert"]
                    .contains(&name.to_string().as_str()) =>
            {
                let arguments = tokens[at..].iter().position(|it| matches!(it, TokenTree::Group(_)));
                if arguments.is_some_and(|after| after < 4) {
                    at += arguments.map_or(0, |after| after + 1);
                }
            }
            TokenTree::Group(group) => read(group.stream(), found),
            TokenTree::Literal(literal) => found.extend(text_of(&literal.to_string()).map(|it| filled(&it))),
            _ => {}
        }
    }
}

/// Whether an item ends with this token.
fn is_end(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(sign) => sign.as_char() == ';',
        _ => false,
    }
}

/// The text of a literal, if it is one.
fn text_of(literal: &str) -> Option<String> {
    let written = literal.strip_prefix('"')?.strip_suffix('"')?;
    let mut text = String::new();
    let mut signs = written.chars().peekable();
    while let Some(sign) = signs.next() {
        match (sign, sign == '\\') {
            (_, false) => text.push(sign),
            (_, true) => match signs.next()? {
                'n' => text.push('\n'),
                't' => text.push('\t'),
                'r' => text.push('\r'),
                '\n' => while signs.next_if(|sign| sign.is_whitespace()).is_some() {},
                other => text.push(other),
            },
        }
    }
    Some(text)
}

/// A format with 7 in its holes.
fn filled(format: &str) -> String {
    let mut text = String::new();
    let mut rest = format;
    while let Some(at) = rest.find(['{', '}']) {
        let (before, brackets) = rest.split_at(at);
        text += before;
        rest = if brackets.starts_with("{{") || brackets.starts_with("}}") {
            text += &brackets[..1];
            &brackets[2..]
        } else if let Some(end) = brackets.find('}').filter(|_| brackets.starts_with('{')) {
            text += "7";
            &brackets[end + 1..]
        } else {
            text += &brackets[..1];
            &brackets[1..]
        };
    }
    text + rest
}
