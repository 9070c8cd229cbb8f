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
    ("A.KCJ", include_bytes!("../../data/A.KCJ")),
    ("A.ZMB", include_bytes!("../../data/A.ZMB")),
    ("A.ZMS", include_bytes!("../../data/A.ZMS")),
    ("A.ZYB", include_bytes!("../../data/A.ZYB")),
    ("A.ZYS", include_bytes!("../../data/A.ZYS")),
    ("AE5.KCT", include_bytes!("../../data/AE5.KCT")),
    ("AT8.KCT", include_bytes!("../../data/AT8.KCT")),
    ("B.CSK", include_bytes!("../../data/B.CSK")),
    ("B.IP2", include_bytes!("../../data/B.IP2")),
    ("B.IP3", include_bytes!("../../data/B.IP3")),
    ("B.ZMB", include_bytes!("../../data/B.ZMB")),
    ("B.ZMS", include_bytes!("../../data/B.ZMS")),
    ("C.IP2", include_bytes!("../../data/C.IP2")),
    ("CYCLOID.KCJ", include_bytes!("../../data/CYCLOID.KCJ")),
    ("D.IP2", include_bytes!("../../data/D.IP2")),
    ("HELIX.KCG", include_bytes!("../../data/HELIX.KCG")),
    ("K1.ZMB", include_bytes!("../../data/K1.ZMB")),
    ("K1.ZMS", include_bytes!("../../data/K1.ZMS")),
    ("K2.ZMB", include_bytes!("../../data/K2.ZMB")),
    ("K2.ZMS", include_bytes!("../../data/K2.ZMS")),
    ("K3.ZMB", include_bytes!("../../data/K3.ZMB")),
    ("K3.ZMS", include_bytes!("../../data/K3.ZMS")),
    ("SNAIL.KCE", include_bytes!("../../data/SNAIL.KCE")),
    ("SNAIL.KCJ", include_bytes!("../../data/SNAIL.KCJ")),
    ("SPIRAL.KCJ", include_bytes!("../../data/SPIRAL.KCJ")),
    ("TORUS.KCJ", include_bytes!("../../data/TORUS.KCJ")),
    ("TREFOIL.KCJ", include_bytes!("../../data/TREFOIL.KCJ")),
    ("X.IP2", include_bytes!("../../data/X.IP2")),
    ("Y.IP2", include_bytes!("../../data/Y.IP2")),
    ("Z.FBS", include_bytes!("../../data/Z.FBS")),
    ("Z.IP2", include_bytes!("../../data/Z.IP2")),
];

/// The content of the built-in sample of a name, in whatever case.
pub fn sample(name: &str) -> Option<&'static [u8]> {
    SAMPLES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, content)| content)
}
