//! The groups of the programs: the families that the menu shows together and the installer copies together.

use grafika::file::Format;
use grafika::machine::SAMPLES;
use grafika::ui::Words;

/// Programs that belong together.
pub(crate) struct Group {
    /// The folder that the installer makes for it, of eight letters at most as on the book's disk.
    pub(crate) folder: &'static str,
    /// The same in lower case: the group's name on the command line.
    pub(crate) id: &'static str,
    /// The book's chapter.
    pub(crate) chapter: &'static str,
    /// What the group is called.
    pub(crate) name: Words,
    /// What it is, in a sentence or two.
    pub(crate) about: Words,
    /// Its programs in the order of the book, in lower case.
    pub(crate) programs: &'static [&'static str],
}

/// Every group in the order of the book. Every program is in exactly one.
pub(crate) const GROUPS: &[Group] = &[
    Group {
        folder: "KURZOR",
        id: "kurzor",
        chapter: "1",
        name: Words("Kurzorok", "Cursors"),
        about: Words(
            "Kurzor KIZÁRÓ VAGY és VAGY műveletekkel, az egér kurzorának két maszkja, virtuális joystick.",
            "A cursor by exclusive-or and by or, the two masks of the mouse pointer, a virtual joystick.",
        ),
        programs: &["gr_kz_x", "gr_kz_o", "eg_kz_k", "vjs"],
    },
    Group {
        folder: "GB_2D",
        id: "gb_2d",
        chapter: "2",
        name: Words("Síkgörbék", "Plane curves"),
        about: Words(
            "Sima görbék kontrollpontokkal a síkban: Fourier, Coons-Hermite, Bézier, spline, B-spline, béta-spline.",
            "Smooth curves by control points in the plane: Fourier, Coons-Hermite, Bézier, spline, B-spline, beta-spline.",
        ),
        programs: &["gb_p_2d", "gb_2d_ch", "gb_2d_ip", "gb_2d_bt"],
    },
    Group {
        folder: "GB_3D",
        id: "gb_3d",
        chapter: "2",
        name: Words("Térgörbék", "Space curves"),
        about: Words(
            "Ugyanazok a módszerek a térben: a görbe forgatható.",
            "The same methods in space: the curve can be turned.",
        ),
        programs: &["gb_3d_ip", "gb_3d_bt"],
    },
    Group {
        folder: "FT_NYILT",
        id: "ft_nyilt",
        chapter: "3",
        name: Words("Nyílt felületek", "Open surfaces"),
        about: Words(
            "Nyílt felületek kontrollhálóval: Hermite, spline, Bézier, B-spline, béta-spline, helyi spline.",
            "Open surfaces by control nets: Hermite, spline, Bézier, B-spline, beta-spline, local spline.",
        ),
        programs: &["f_p_herm", "f_p_spln", "f_em_spl", "f_p_bezr", "f_p_bspl", "f_p_bets", "f_p_hspl"],
    },
    Group {
        folder: "FT_GOMB",
        id: "ft_gomb",
        chapter: "3",
        name: Words("Gömbszerű felületek", "Sphere surfaces"),
        about: Words(
            "Gömb módjára zárt felületek: spline, B-spline, béta-spline, helyi spline; kockák, oktaéder.",
            "Surfaces closed like a sphere: spline, B-spline, beta-spline, local spline; cubes, an octahedron.",
        ),
        programs: &["zm_spln", "zm_bspl", "zm_betsp", "zm_hspl"],
    },
    Group {
        folder: "FT_GYURU",
        id: "ft_gyuru",
        chapter: "3",
        name: Words("Gyűrűszerű felületek", "Ring surfaces"),
        about: Words(
            "Gyűrű módjára zárt felületek: spline, B-spline, béta-spline, helyi spline; a csavart gyűrű.",
            "Surfaces closed like a ring: spline, B-spline, beta-spline, local spline; the twisted ring.",
        ),
        programs: &["csav_gy", "zy_spln", "zy_bspl", "zy_betsp", "zy_hspl"],
    },
    Group {
        folder: "JATEK",
        id: "jatek",
        chapter: "4",
        name: Words("Játékok, fejtörők", "Games and puzzles"),
        about: Words(
            "Biliárd rugalmas ütközésekkel, a gyöngykerék és a Csángó kocka.",
            "Billiards with elastic hits, the bead wheel and the Csángó cube.",
        ),
        programs: &["biliard", "gyongy_k", "csango_k"],
    },
    Group {
        folder: "TELEPIT",
        id: "telepit",
        chapter: "5",
        name: Words("Telepítő", "Installer"),
        about: Words(
            "Ez a program: a kiválasztott csoportokat egy mappába telepíti.",
            "This program: it installs the chosen groups into a folder.",
        ),
        programs: &["telepit"],
    },
];

impl Group {
    /// The built-in samples that its programs open: name and content.
    pub(crate) fn samples(&self) -> impl Iterator<Item = (&'static str, &'static [u8])> + '_ {
        SAMPLES.iter().copied().filter(|(name, _)| {
            let readers = Format::from_name(name).map(Format::programs).unwrap_or_default();
            readers.iter().any(|reader| self.programs.iter().any(|name| name.eq_ignore_ascii_case(reader)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_is_in_one_group() {
        let grouped: Vec<&str> =
            GROUPS.iter().flat_map(|group| group.samples().map(|(name, _)| name)).collect();
        assert_eq!(grouped.len(), SAMPLES.len());
        assert!(SAMPLES.iter().all(|(name, _)| grouped.contains(name)));
    }

    #[test]
    fn folders_are_names_of_the_disk_operating_system() {
        for (at, group) in GROUPS.iter().enumerate() {
            assert!((1..=8).contains(&group.folder.len()), "{}", group.folder);
            assert_eq!(group.folder, group.id.to_ascii_uppercase());
            assert!(GROUPS[..at].iter().all(|earlier| earlier.folder != group.folder));
        }
    }
}
