//! The table of the data files: extension, size, what is in it.

use std::fmt;

/// A kind of data file, named after its extension: those of the DOS programs, kinds that are JSON only, and clouds of
/// points in formats of other programs ([`CloudFormat`](super::CloudFormat)).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the table below says what each one is")]
pub enum Format {
    Ip2,
    Ic2,
    Ec2,
    Gbp,
    Ip3,
    Fhc,
    Fps,
    Fem,
    Fpb,
    Fbs,
    Zms,
    Zmb,
    Zys,
    Zyb,
    Zyp,
    Gyk,
    Csk,
    Bil,
    Kct,
    Kcg,
    Kcf,
    Kce,
    Kcj,
    Rbc,
    Pn,
    Rbs,
    Csm,
    Csf,
    Alp,
    Som,
    Kor,
    Gom,
    Xyz,
    Ply,
    Obj,
    Stl,
}

/// One row of the table.
struct Row {
    format: Format,
    extension: &'static str,
    /// The bytes of the DOS file; `None` where there is none.
    size: Option<usize>,
    english: &'static str,
    hungarian: &'static str,
}

macro_rules! rows {
    ($($format:ident $extension:literal $size:expr, $english:literal $hungarian:literal;)*) => {
        /// Every format, in the order of the table.
        const ALL: &[Format] = &[$(Format::$format),*];
        const ROWS: &[Row] = &[$(Row {
            format: Format::$format,
            extension: $extension,
            size: $size,
            english: $english,
            hungarian: $hungarian,
        }),*];
    };
}

rows! {
    Ip2 "IP2" Some(1300), "control points in the plane" "síkbeli kontrollpontok";
    Ic2 "IC2" Some(1300), "control points with tangents" "kontrollpontok érintőkkel";
    Ec2 "EC2" Some(1300), "tangents at control points" "érintők a kontrollpontokban";
    Gbp "GBP" Some(504), "coefficients of a Fourier curve" "Fourier-görbe együtthatói";
    Ip3 "IP3" Some(3000), "control points in space" "térbeli kontrollpontok";
    Fhc "FHC" Some(640), "Hermite patch" "Hermite-folt";
    Fps "FPS" Some(640), "net of an open spline surface" "nyílt spline felület hálója";
    Fem "FEM" Some(640), "heights of a spline surface" "spline felület magasságai";
    Fpb "FPB" Some(640), "net of a Bézier patch" "Bézier-folt hálója";
    Fbs "FBS" Some(640), "net of an open B-spline surface" "nyílt B-spline felület hálója";
    Zms "ZMS" Some(640), "net of a spline surface like a sphere" "gömbszerű spline felület hálója";
    Zmb "ZMB" Some(640), "net of a B-spline surface like a sphere" "gömbszerű B-spline felület hálója";
    Zys "ZYS" Some(640), "net of a spline surface like a torus" "gyűrűszerű spline felület hálója";
    Zyb "ZYB" Some(640), "net of a B-spline surface like a torus" "gyűrűszerű B-spline felület hálója";
    Zyp "ZYP" Some(640), "net of a beta-spline surface like a torus" "gyűrűszerű béta-spline felület hálója";
    Gyk "GYK" Some(37), "position of the bead wheel" "a gyöngykerék állása";
    Csk "CSK" Some(17024), "position of the Csángó cube" "a csángó kocka állása";
    Bil "BIL" None, "game of billiards" "biliárdjátszma";
    Kct "KCT" None, "extended Chebyshev space" "kiterjesztett Csebisev-tér";
    Kcg "KCG" None, "curve over an extended Chebyshev space" "görbe kiterjesztett Csebisev-térben";
    Kcf "KCF" None, "surface over extended Chebyshev spaces" "felület kiterjesztett Csebisev-térben";
    Kce "KCE" None, "coefficients of an exact description" "pontos leírás együtthatói";
    Kcj "KCJ" None, "scene of curves and surfaces" "görbék és felületek jelenete";
    Rbc "RBC" None, "rational curve of the plane" "síkbeli racionális görbe";
    Pn "PN" None, "net of points with normals" "pontok hálója normálisokkal";
    Rbs "RBS" None, "rational Bézier patches" "racionális Bézier-foltok";
    Csm "CSM" None, "B-spline curve by its knots" "B-spline görbe a csomóival";
    Csf "CSF" None, "B-spline surface by its knots" "B-spline felület a csomóival";
    Alp "ALP" None, "curve with shape parameters" "alakparaméteres görbe";
    Som "SOM" None, "net of neurons" "neuronháló";
    Kor "KOR" None, "circles with a skin" "körök burkolóval";
    Gom "GOM" None, "spheres with a skin" "gömbök burkolóval";
    Xyz "XYZ" None, "points of a cloud" "felhő pontjai";
    Ply "PLY" None, "points of a cloud or a mesh" "felhő vagy háló pontjai";
    Obj "OBJ" None, "points of a mesh" "háló pontjai";
    Stl "STL" None, "corners of triangles" "háromszögek csúcsai";
}

impl Format {
    /// Every format, in the order of the table.
    pub const ALL: &[Self] = ALL;

    /// The extension in capitals, without the dot.
    #[must_use]
    pub fn extension(self) -> &'static str {
        self.row().extension
    }

    /// The formats of the DOS programs, whose files are records of bytes.
    pub fn dos() -> impl Iterator<Item = Self> {
        ALL.iter().copied().filter(|format| format.size().is_some())
    }

    /// The size of every DOS file of this format, in bytes; `None` for what is JSON only, and for clouds.
    #[must_use]
    pub fn size(self) -> Option<usize> {
        self.row().size
    }

    /// The size of a file that is written record by record.
    pub(super) fn bytes(self) -> usize {
        self.row().size.unwrap_or_default()
    }

    /// What such a file holds, in English.
    #[must_use]
    pub fn english(self) -> &'static str {
        self.row().english
    }

    /// What such a file holds, in Hungarian.
    #[must_use]
    pub fn hungarian(self) -> &'static str {
        self.row().hungarian
    }

    /// The format of a file by its name (`A.IP2`, `curves/a.ip2`); the case does not matter.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        name.rsplit_once('.').and_then(|(_, extension)| Self::from_extension(extension))
    }

    /// The format with this extension, given without the dot; the case does not matter.
    #[must_use]
    pub fn from_extension(extension: &str) -> Option<Self> {
        ROWS.iter().find(|row| row.extension.eq_ignore_ascii_case(extension)).map(|row| row.format)
    }

    fn row(self) -> &'static Row {
        // The macro writes both lists in the order of its rows; a test sees that they agree with the enum.
        &ROWS[self as usize]
    }
}

impl fmt::Display for Format {
    /// The extension with its dot: `.IP2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, ".{}", self.extension())
    }
}

/// `an .IP2 file`, `a .GBP file`.
pub(super) fn a_file(format: Format) -> String {
    // Read letter by letter: I, E and F begin with a vowel.
    let article = if format.extension().starts_with(['I', 'E', 'F']) { "an" } else { "a" };
    format!("{article} {format} file")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_enum() {
        for (index, &format) in Format::ALL.iter().enumerate() {
            assert_eq!(format as usize, index);
            assert_eq!(format.row().format, format);
        }
        assert_eq!(Format::Stl as usize + 1, Format::ALL.len());
    }

    #[test]
    fn names_in_any_case() {
        assert_eq!(Format::from_name("A.IP2"), Some(Format::Ip2));
        assert_eq!(Format::from_name("some.where/a.b.zyp"), Some(Format::Zyp));
        assert_eq!(Format::from_name("IP2"), None);
        assert_eq!(Format::from_name("a.ip4"), None);
    }
}
