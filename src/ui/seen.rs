//! What the picture of a program shows, and one thing to try: the last page of its help. The texts are those of
//! `docs/what_you_see.md`, so that the page and the document say the same.

use crate::machine::Language;

const HUNGARIAN: &str = include_str!("../../docs/what_you_see_hu.md");
const ENGLISH: &str = include_str!("../../docs/what_you_see.md");

/// A paragraph of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Paragraph {
    /// Running text, to be broken into lines.
    Text(String),
    /// What to try, to be broken into lines.
    Try(String),
    /// A line of a formula.
    Formula(&'static str),
}

/// The paragraphs about a program; none about one that the document does not know.
pub(super) fn paragraphs(name: &str, language: Language) -> Vec<Paragraph> {
    let (document, attempt) = match language {
        Language::Hungarian => (HUNGARIAN, "Próba:"),
        Language::English => (ENGLISH, "Try:"),
    };
    let title = format!("## {}", name.to_uppercase());
    let section = document.lines().skip_while(|line| *line != title).skip(1);
    let lines: Vec<&str> = section.take_while(|line| !line.starts_with("## ")).collect();
    let paragraph = |lines: &[&'static str]| -> Vec<Paragraph> {
        if lines.iter().all(|line| line.starts_with("    ")) {
            return lines.iter().map(|line| Paragraph::Formula(line.trim())).collect();
        }
        let text = lines.join(" ");
        vec![if text.starts_with(attempt) { Paragraph::Try(text) } else { Paragraph::Text(text) }]
    };
    lines.split(|line| line.is_empty()).filter(|lines| !lines.is_empty()).flat_map(paragraph).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_section_is_told_apart_by_its_paragraphs() {
        let told = paragraphs("gb_2d_ch", Language::English);
        assert!(
            matches!(&told[0], Paragraph::Text(text) if text.starts_with("What you see: ") && !text.contains('\n'))
        );
        assert!(told.iter().any(|it| matches!(it, Paragraph::Formula(text) if text.starts_with("r = "))));
        assert!(matches!(told.last(), Some(Paragraph::Try(_))));
        assert_eq!(paragraphs("nobody", Language::Hungarian), []);
    }
}
