//! The data files of the book's disk, made again and built into the program.

/// Every built-in sample: name and content.
pub const SAMPLES: &[(&str, &[u8])] = &[];

/// The content of the built-in sample of a name, in whatever case.
pub fn sample(name: &str) -> Option<&'static [u8]> {
    SAMPLES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, content)| content)
}
