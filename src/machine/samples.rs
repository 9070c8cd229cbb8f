//! The data files of the book's disk, made again and built into the program.

/// Every built-in sample: name and content.
pub const SAMPLES: &[(&str, &[u8])] = &[
    ("A.GBP", include_bytes!("../../data/A.GBP")),
    ("A.CSK", include_bytes!("../../data/A.CSK")),
    ("A.EC2", include_bytes!("../../data/A.EC2")),
    ("A.IC2", include_bytes!("../../data/A.IC2")),
    ("A.IP2", include_bytes!("../../data/A.IP2")),
    ("A.IP3", include_bytes!("../../data/A.IP3")),
    ("B.CSK", include_bytes!("../../data/B.CSK")),
    ("B.IP2", include_bytes!("../../data/B.IP2")),
    ("B.IP3", include_bytes!("../../data/B.IP3")),
    ("C.IP2", include_bytes!("../../data/C.IP2")),
    ("D.IP2", include_bytes!("../../data/D.IP2")),
    ("X.IP2", include_bytes!("../../data/X.IP2")),
    ("Y.IP2", include_bytes!("../../data/Y.IP2")),
    ("Z.IP2", include_bytes!("../../data/Z.IP2")),
];

/// The content of the built-in sample of a name, in whatever case.
pub fn sample(name: &str) -> Option<&'static [u8]> {
    SAMPLES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, content)| content)
}
