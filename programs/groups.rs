//! The groups of the programs: the families that the menu shows together and the installer copies together.

use super::ALL;
use crate::file::{Document, FileKind, Format};
use crate::machine::SAMPLES;
use crate::ui::{Group, Program, Words};

/// Cursors.
pub const CURSORS: Group = Group {
    folder: "KURZOR",
    id: "kurzor",
    chapter: "1",
    name: Words("Kurzorok", "Cursors"),
    about: Words(
        "Kurzor KIZÁRÓ VAGY és VAGY műveletekkel, az egér kurzorának két maszkja, virtuális joystick.",
        "A cursor by exclusive-or and by or, the two masks of the mouse pointer, a virtual joystick.",
    ),
};

/// Curves in the plane.
pub const PLANE_CURVES: Group = Group {
    folder: "GB_2D",
    id: "gb_2d",
    chapter: "2",
    name: Words("Síkgörbék", "Plane curves"),
    about: Words(
        "Sima görbék kontrollpontokkal a síkban: Fourier, Coons-Hermite, Bézier, spline, B-spline, béta-spline.",
        "Smooth curves by control points in the plane: Fourier, Coons-Hermite, Bézier, spline, B-spline, beta-spline.",
    ),
};

/// Curves in space.
pub const SPACE_CURVES: Group = Group {
    folder: "GB_3D",
    id: "gb_3d",
    chapter: "2",
    name: Words("Térgörbék", "Space curves"),
    about: Words(
        "Ugyanazok a módszerek a térben: a görbe forgatható.",
        "The same methods in space: the curve can be turned.",
    ),
};

/// Open surfaces.
pub const OPEN_SURFACES: Group = Group {
    folder: "FT_NYILT",
    id: "ft_nyilt",
    chapter: "3",
    name: Words("Nyílt felületek", "Open surfaces"),
    about: Words(
        "Nyílt felületek kontrollhálóval: Hermite, spline, Bézier, B-spline, béta-spline, helyi spline.",
        "Open surfaces by control nets: Hermite, spline, Bézier, B-spline, beta-spline, local spline.",
    ),
};

/// Surfaces like a sphere.
pub const SPHERES: Group = Group {
    folder: "FT_GOMB",
    id: "ft_gomb",
    chapter: "3",
    name: Words("Gömbszerű felületek", "Sphere surfaces"),
    about: Words(
        "Gömb módjára zárt felületek: spline, B-spline, béta-spline, helyi spline; kockák, oktaéder.",
        "Surfaces closed like a sphere: spline, B-spline, beta-spline, local spline; cubes, an octahedron.",
    ),
};

/// Surfaces like a ring.
pub const RINGS: Group = Group {
    folder: "FT_GYURU",
    id: "ft_gyuru",
    chapter: "3",
    name: Words("Gyűrűszerű felületek", "Ring surfaces"),
    about: Words(
        "Gyűrű módjára zárt felületek: spline, B-spline, béta-spline, helyi spline; a csavart gyűrű.",
        "Surfaces closed like a ring: spline, B-spline, beta-spline, local spline; the twisted ring.",
    ),
};

/// The programs of later documents on geometric modelling.
pub const THESIS: Group = Group {
    folder: "TEZIS",
    id: "tezis",
    chapter: "T",
    name: Words("Későbbi módszerek", "Later methods"),
    about: Words(
        "Görbék és felületek későbbi dolgozatok módszereivel: kiterjesztett Csebisev-terek.",
        "Curves and surfaces by the methods of later theses: extended Chebyshev spaces.",
    ),
};

/// Curves and surfaces with exact offsets.
pub const OFFSETS: Group = Group {
    folder: "PARHUZAM",
    id: "parhuzam",
    chapter: "P",
    name: Words("Pontos párhuzamosok", "Exact offsets"),
    about: Words(
        "Görbék és felületek, amelyek párhuzamosa is pontosan leírható: szerszámpályák, falak, héjak.",
        "Curves and surfaces whose offsets are exact too: paths of tools, walls, shells.",
    ),
};

/// Curves by their knots and by shape parameters.
pub const SHAPES: Group = Group {
    folder: "ALAK",
    id: "alak",
    chapter: "H",
    name: Words("Csomók és alakok", "Knots and shape"),
    about: Words(
        "Görbék, amelyek alakját a csomók vagy néhány szám változtatja, a kontrollpontok helyükön maradnak.",
        "Curves that are shaped by their knots or by a number while the control points stay.",
    ),
};

/// Surfaces from clouds of points, and skins.
pub const CLOUDS: Group = Group {
    folder: "FELHO",
    id: "felho",
    chapter: "H",
    name: Words("Pontfelhők, burkolók", "Clouds and skins"),
    about: Words(
        "Felületek szétszórt pontokból neuronhálóval, és körök, gömbök sima burkolója.",
        "Surfaces from scattered points by nets of neurons, and smooth skins of circles and spheres.",
    ),
};

/// Games and puzzles.
pub const GAMES: Group = Group {
    folder: "JATEK",
    id: "jatek",
    chapter: "4",
    name: Words("Játékok, fejtörők", "Games and puzzles"),
    about: Words(
        "Biliárd rugalmas ütközésekkel, a gyöngykerék és a Csángó kocka.",
        "Billiards with elastic hits, the bead wheel and the Csángó cube.",
    ),
};

/// The installer.
pub const INSTALLER: Group = Group {
    folder: "TELEPIT",
    id: "telepit",
    chapter: "5",
    name: Words("Telepítő", "Installer"),
    about: Words(
        "Ez a program: a kiválasztott csoportokat egy mappába telepíti.",
        "This program: it installs the chosen groups into a folder.",
    ),
};

/// Every group in the order of the book.
pub const GROUPS: [&Group; 12] = [
    &CURSORS,
    &PLANE_CURVES,
    &SPACE_CURVES,
    &OPEN_SURFACES,
    &SPHERES,
    &RINGS,
    &THESIS,
    &OFFSETS,
    &SHAPES,
    &CLOUDS,
    &GAMES,
    &INSTALLER,
];

/// Every group in the order of the menu: it begins with what shows at once what it is.
pub const MENU: [&Group; 12] = [
    &PLANE_CURVES,
    &GAMES,
    &SPACE_CURVES,
    &OPEN_SURFACES,
    &SPHERES,
    &RINGS,
    &THESIS,
    &OFFSETS,
    &SHAPES,
    &CLOUDS,
    &CURSORS,
    &INSTALLER,
];

impl PartialEq for Group {
    /// Groups are told apart by their folders.
    fn eq(&self, other: &Group) -> bool {
        self.folder == other.folder
    }
}

impl Group {
    /// Its programs, in the order of the book.
    pub fn programs(&self) -> impl Iterator<Item = &'static Program> {
        ALL.iter().filter(move |program| program.group == self)
    }

    /// The built-in samples that its programs open: name and content. A JSON file goes with the file of its name.
    pub fn samples(&self) -> impl Iterator<Item = (&'static str, &'static [u8])> + '_ {
        let opens = |format: Format| self.programs().any(|program| program.opens.contains(&format));
        SAMPLES.iter().copied().filter(move |(name, content)| format_of(name, content).is_some_and(opens))
    }
}

/// The format of a sample; that of a JSON file is the one of the file beside it, else what it says itself.
fn format_of(name: &str, content: &[u8]) -> Option<Format> {
    let beside = |(stem, extension): (&str, &str)| {
        let twin = |other: &&str| *other != name && other.rsplit_once('.').is_some_and(|(it, _)| it == stem);
        let json = extension.eq_ignore_ascii_case("JSON");
        json.then(|| SAMPLES.iter().map(|(name, _)| *name).find(twin).and_then(Format::from_name)).flatten()
    };
    let said = || Document::decode(FileKind::Json, content).ok().map(|document| document.format());
    Format::from_name(name).or_else(|| name.rsplit_once('.').and_then(beside)).or_else(said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_is_in_a_group() {
        let grouped: Vec<&str> =
            GROUPS.iter().flat_map(|group| group.samples().map(|(name, _)| name)).collect();
        // Points of curves belong to the programs of two groups.
        assert!(grouped.len() >= SAMPLES.len());
        assert!(SAMPLES.iter().all(|(name, _)| grouped.contains(name)));
    }

    #[test]
    fn the_menu_has_every_group() {
        assert!(GROUPS.iter().all(|group| MENU.contains(group)));
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
