//! The data files of the book's disk, made again and built into the program.

/// Every built-in sample: name and content.
pub const SAMPLES: &[(&str, &[u8])] = &[
    ("A.CSK", include_bytes!("../../data/A.CSK")),
    ("A.EC2", include_bytes!("../../data/A.EC2")),
    ("A.FBS", include_bytes!("../../data/A.FBS")),
    ("A.FEM", include_bytes!("../../data/A.FEM")),
    ("A.FHC", include_bytes!("../../data/A.FHC")),
    ("A.FPB", include_bytes!("../../data/A.FPB")),
    ("A.FPS", include_bytes!("../../data/A.FPS")),
    ("A.GBP", include_bytes!("../../data/A.GBP")),
    ("A.IC2", include_bytes!("../../data/A.IC2")),
    ("A.IP2", include_bytes!("../../data/A.IP2")),
    ("A.IP3", include_bytes!("../../data/A.IP3")),
    ("A.ZMB", include_bytes!("../../data/A.ZMB")),
    ("A.ZMS", include_bytes!("../../data/A.ZMS")),
    ("A.ZYB", include_bytes!("../../data/A.ZYB")),
    ("A.ZYS", include_bytes!("../../data/A.ZYS")),
    ("B.CSK", include_bytes!("../../data/B.CSK")),
    ("B.IP2", include_bytes!("../../data/B.IP2")),
    ("B.IP3", include_bytes!("../../data/B.IP3")),
    ("B.ZMB", include_bytes!("../../data/B.ZMB")),
    ("B.ZMS", include_bytes!("../../data/B.ZMS")),
    ("C.IP2", include_bytes!("../../data/C.IP2")),
    ("D.IP2", include_bytes!("../../data/D.IP2")),
    ("K1.ZMB", include_bytes!("../../data/K1.ZMB")),
    ("K1.ZMS", include_bytes!("../../data/K1.ZMS")),
    ("K2.ZMB", include_bytes!("../../data/K2.ZMB")),
    ("K2.ZMS", include_bytes!("../../data/K2.ZMS")),
    ("K3.ZMB", include_bytes!("../../data/K3.ZMB")),
    ("K3.ZMS", include_bytes!("../../data/K3.ZMS")),
    ("X.IP2", include_bytes!("../../data/X.IP2")),
    ("Y.IP2", include_bytes!("../../data/Y.IP2")),
    ("Z.FBS", include_bytes!("../../data/Z.FBS")),
    ("Z.IP2", include_bytes!("../../data/Z.IP2")),
];

/// The content of the built-in sample of a name, in whatever case.
pub fn sample(name: &str) -> Option<&'static [u8]> {
    SAMPLES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, content)| content)
}
