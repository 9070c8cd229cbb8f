//! The data files: what the DOS programs wrote is read and written again, and wrong files are refused with
//! a reason.

use grafika::file::{
    CsangoCube, CurveSettings, Document, FileKind, Format, Method, PlanePoints, SpacePoints, convert,
};

const SIX: &[u8] = include_bytes!("files/SIX.IP2");
const GAUSS: &[u8] = include_bytes!("files/GAUSS.IP2");
const CH_POINTS: &[u8] = include_bytes!("files/CH.IC2");
const CH_TANGENTS: &[u8] = include_bytes!("files/CH.EC2");
const CUBE: &[u8] = include_bytes!("files/CUBE.IP3");
const FIGURE_A: &[u8] = include_bytes!("files/FIGA.GBP");
const HEIGHTS: &[u8] = include_bytes!("files/TESZT.FEM");
const HERMITE: &[u8] = include_bytes!("files/TESZT.FHC");
const SPHERE: &[u8] = include_bytes!("files/TESZT.ZMS");
const WHEEL: &[u8] = include_bytes!("files/AKB.GYK");
const FINISHED: &[u8] = include_bytes!("files/SOL1.CSK");

const REFERENCES: [(&str, &[u8]); 11] = [
    ("SIX.IP2", SIX),
    ("GAUSS.IP2", GAUSS),
    ("CH.IC2", CH_POINTS),
    ("CH.EC2", CH_TANGENTS),
    ("CUBE.IP3", CUBE),
    ("FIGA.GBP", FIGURE_A),
    ("TESZT.FEM", HEIGHTS),
    ("TESZT.FHC", HERMITE),
    ("TESZT.ZMS", SPHERE),
    ("AKB.GYK", WHEEL),
    ("SOL1.CSK", FINISHED),
];

fn read(format: Format, bytes: &[u8]) -> Document {
    Document::read(format, bytes).unwrap()
}

fn refusal(format: Format, bytes: &[u8]) -> String {
    Document::read(format, bytes).unwrap_err().to_string()
}

/// `bytes` with some of them replaced from `offset` on.
fn patched(bytes: &[u8], offset: usize, patch: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[offset..offset + patch.len()].copy_from_slice(patch);
    bytes
}

/// Which bytes of a record mean something, by format and record.
fn means_something(format: Format, record: usize, offset: usize) -> bool {
    match format {
        // x, y and screen place, not the pointer and the flag; of record 0 only the count.
        Format::Ip2 | Format::Ic2 if record == 0 => offset < 4,
        Format::Ip2 | Format::Ic2 => !(4..9).contains(&offset),
        Format::Ec2 => record > 0 && !(4..9).contains(&offset),
        // Screen place, depth and order are those of the view at the time.
        Format::Ip3 if record == 0 => offset >= 28,
        Format::Ip3 => offset < 18,
        Format::Gbp | Format::Gyk | Format::Csk => true,
        _ => offset < 12,
    }
}

#[test]
fn reference_files_come_back_in_every_field_that_means_something() {
    for (name, bytes) in REFERENCES {
        let format = Format::from_name(name).unwrap();
        let document = read(format, bytes);
        let written = document.write(format).unwrap();
        assert_eq!(written.len(), format.size().unwrap(), "{name}");
        assert_eq!(read(format, &written), document, "{name}");
        let record = match format {
            Format::Ip2 | Format::Ic2 | Format::Ec2 => 13,
            Format::Ip3 => 30,
            Format::Gbp | Format::Gyk | Format::Csk => format.size().unwrap(),
            _ => 16,
        };
        let used = match &document {
            Document::PlanePoints(p) => p.points.len() + 1,
            Document::Tangents(t) => t.tangents.len() + 1,
            Document::SpacePoints(p) => p.points.len() + 1,
            _ => usize::MAX,
        };
        for (offset, (&old, &new)) in bytes.iter().zip(&written).enumerate() {
            if offset / record < used && means_something(format, offset / record, offset % record) {
                assert_eq!(old, new, "{name}, byte {offset}");
            } else if offset / record >= used {
                assert_eq!(new, 0, "{name}, byte {offset} is past the last record");
            }
        }
    }
}

#[test]
fn documents_come_back_from_json() {
    for (name, bytes) in REFERENCES {
        let document = read(Format::from_name(name).unwrap(), bytes);
        let json = document.to_json().unwrap();
        assert_eq!(Document::from_json(&json).as_ref(), Ok(&document), "{name}:\n{json}");
    }
}

#[test]
fn points_and_tangents_of_the_listing() {
    let Document::PlanePoints(points) = read(Format::Ic2, CH_POINTS) else { panic!("points") };
    let Document::Tangents(twin) = read(Format::Ec2, CH_TANGENTS) else { panic!("tangents") };
    assert_eq!(points.points, [[100.0, 50.0], [160.0, 300.0], [300.0, 120.0], [440.0, 320.0]]);
    let points = points.with_tangents(&twin);
    let tangents = points.tangents.clone().unwrap();
    assert_eq!(tangents, [[-280.0, -20.0], [0.0, 300.0], [118.0, 160.0], [-240.0, -40.0]]);

    let document = Document::PlanePoints(points);
    assert_eq!(document.format(), Format::Ic2);
    let written = read(Format::Ec2, &document.write(Format::Ec2).unwrap());
    assert_eq!(written, Document::Tangents(twin), "the tips are those that the original stored");
    assert!(document.write(Format::Ip2).unwrap_err().to_string().contains("tangents"));
}

#[test]
fn space_points_are_written_in_the_first_view() {
    let document = Document::SpacePoints(SpacePoints::new(vec![[100.0, 0.0, 0.0], [-1.0, 5.0, 0.0]]));
    let bytes = document.write(Format::Ip3).unwrap();
    // x of the screen: 331 + (0.7 y - 0.2 x) / sqrt(0.53); y: 260 + 0.3 (0.7 x + 0.2 y) / (sqrt(0.53) sqrt(0.62)).
    assert_eq!(bytes[48..52], [(331 - 27) as u16, 260 + 37].map(u16::to_le_bytes).concat());
    assert_eq!(bytes[58..60], [2, 0], "nearest to the viewer, so drawn last");
    assert_eq!(bytes[88..90], [1, 0]);
}

#[test]
fn the_finished_cube_is_finished() {
    let Document::CsangoCube(cube) = read(Format::Csk, FINISHED) else { panic!("cube") };
    assert!(cube.is_finished());
    let start = Document::CsangoCube(CsangoCube::start());
    assert_eq!(read(Format::Csk, &start.write(Format::Csk).unwrap()), start);
}

#[test]
fn wrong_files_are_refused_with_the_reason() {
    for (format, bytes, message) in [
        (Format::Ip2, SIX[1..].to_vec(), "the file has 1299 bytes; an .IP2 file has 1300"),
        (Format::Gbp, vec![], "the file has 0 bytes; a .GBP file has 504"),
        (Format::Ip2, patched(SIX, 0, &[100]), "number of points (byte 0): 100; it must be 0 to 99"),
        (Format::Ip2, patched(SIX, 1, &[0xff]), "number of points (byte 0): -250; it must be 0 to 99"),
        (Format::Ip2, patched(SIX, 2, &[1]), "record 0, yp (byte 2): 1; it must be 0"),
        (Format::Ip2, patched(SIX, 26, &[0x31, 2]), "point 2 (byte 26): x = 561; the field is 0 to 560"),
        (Format::Ip2, patched(SIX, 28, &[0xff, 0xff]), "point 2 (byte 28): y = -1; the field is 0 to 380"),
        (Format::Ip3, patched(CUBE, 28, &[0, 1]), "number of points (byte 28): 256; it must be 0 to 99"),
        (
            Format::Zms,
            patched(SPHERE, 16 * 7 + 4, &[0, 0, 0x80, 0x7f]),
            "point 2, 3 (byte 116): y is inf; it must be a finite number",
        ),
        (Format::Gyk, patched(WHEEL, 31, &[2]), "drawer 1 (byte 31): 2; it must be -1, 1 or 3"),
        (
            Format::Gyk,
            patched(WHEEL, 31, &[3]),
            "drawer 1 (byte 31): 3, and drawer 4 opposite 1; the two must add up to 2",
        ),
        (
            Format::Gyk,
            patched(WHEEL, 19, &[15]),
            "arm 2 (byte 19): ring 4 is empty; with the drawer at 1 rings 1 to 4 hold beads",
        ),
        (
            Format::Gyk,
            patched(WHEEL, 30, &[8]),
            "centre (byte 30): colour 8; beads have the colours 7 and 9 to 14",
        ),
        (Format::Gyk, patched(WHEEL, 30, &[9]), "centre (byte 30): bead 5 of colour 9; the wheel has 4"),
        (Format::Csk, patched(FINISHED, 19, &[4]), "piece 1 (byte 19): 4 cells; this piece has 5"),
        (
            Format::Csk,
            patched(FINISHED, 994 + 3, &[2]),
            "piece 1 (byte 997): the cells [[2, 0, 0], [-1, 0, 0], [0, 1, 0], [0, 1, 1]] from cell 1 are none of the \
             24 rotations of its shape",
        ),
    ] {
        assert_eq!(refusal(format, &bytes), message);
    }
    assert!(
        refusal(Format::Csk, &patched(FINISHED, 0, &[0])).starts_with("piece 1 (byte 0): its centre is [0.0")
    );
    assert!(
        refusal(Format::Csk, &patched(FINISHED, 22, &[0])).starts_with("piece 1 (byte 22): corner 1 is [0.0")
    );
    assert!(
        refusal(Format::Csk, &patched(FINISHED, 1010, &[9]))
            .starts_with("piece 1 (byte 1009): face 1 is none")
    );
}

#[test]
fn fields_that_only_cache_are_free() {
    let noise = |bytes: &[u8], offset: usize, length| patched(bytes, offset, &vec![0xee; length]);
    for (format, bytes, offset, length) in [
        (Format::Ip2, SIX, 4, 9),      // the rest of record 0
        (Format::Ip2, SIX, 13 + 4, 9), // pointer, flag, screen place of point 1
        (Format::Ip2, SIX, 7 * 13, 93 * 13),
        (Format::Ip3, CUBE, 0, 28),
        (Format::Ip3, CUBE, 30 + 18, 12),
        (Format::Ip3, CUBE, 8 * 30, 92 * 30),
        (Format::Fhc, HERMITE, 12, 4),
        (Format::Fhc, HERMITE, 64, 16), // point 0, 4 is outside the 4 x 4 matrix
        (Format::Fhc, HERMITE, 320, 320),
        (Format::Gbp, FIGURE_A, 126, 6),   // p0
        (Format::Csk, FINISHED, 21, 1),    // nlh
        (Format::Csk, FINISHED, 346, 648), // s and p
        (Format::Csk, FINISHED, 1117, 99), // lth, mg, l_sorr
    ] {
        assert_eq!(read(format, &noise(bytes, offset, length)), read(format, bytes), "{format} at {offset}");
    }
}

#[test]
fn json_holds_what_the_dos_format_cannot() {
    let text = r#"{"format": "ip2", "points": [[-1000.25, 5], [1e300, 0]],
        "settings": {"method": "beta", "closed": true, "bias": 2, "tension": -4.5}}"#;
    let document = Document::from_json(text).unwrap();
    let settings = CurveSettings {
        method: Some(Method::Beta),
        closed: Some(true),
        bias: Some(2.0),
        tension: Some(-4.5),
        ..CurveSettings::default()
    };
    let points = vec![[-1000.25, 5.0], [1e300, 0.0]];
    assert_eq!(document, Document::PlanePoints(PlanePoints { points, settings, ..PlanePoints::default() }));
    assert_eq!(Document::from_json(&document.to_json().unwrap()), Ok(document.clone()));

    let refusal = document.write(Format::Ip2).unwrap_err().to_string();
    assert_eq!(refusal, "does not fit into .IP2: the setting \"bias\" has no place there");
    let plain = document.without_settings();
    let refusal = plain.write(Format::Ip2).unwrap_err().to_string();
    assert_eq!(refusal, "does not fit into .IP2: point 1: x = -1000.25; it holds whole numbers 0 to 560");
    let many = Document::PlanePoints(PlanePoints::new(vec![[0.0; 2]; 100]));
    let refusal = many.write(Format::Ip2).unwrap_err().to_string();
    assert_eq!(refusal, "does not fit into .IP2: 100 points; it holds at most 99");
    let far = Document::SpacePoints(SpacePoints::new(vec![[0.0, 0.0, 1e39]]));
    let refusal = far.write(Format::Ip3).unwrap_err().to_string();
    assert!(refusal.starts_with("does not fit into .IP3: point 1: z = 1e39 is too large"), "{refusal}");
    let refusal = far.write(Format::Gyk).unwrap_err().to_string();
    let message = "does not fit into .GYK: control points in space; it holds position of the bead wheel";
    assert_eq!(refusal, message);
}

#[test]
fn json_holds_tangents_in_space_and_the_recipe_of_ph_curves() {
    let text = r#"{"format": "IP3", "points": [[1, 2, 3], [4, 5, 6.5]], "tangents": [[7, 8, 9], [0, -1, 0.5]],
        "settings": {"method": "phhermite"}}"#;
    let document = Document::from_json(text).unwrap();
    assert_eq!(Document::from_json(&document.to_json().unwrap()), Ok(document.clone()));
    let Document::SpacePoints(space) = &document else { panic!("points in space") };
    assert_eq!(space.tangents, Some(vec![[7.0, 8.0, 9.0], [0.0, -1.0, 0.5]]));
    assert!(document.describe().contains(&"tangent 2: 0, -1, 0.5".to_owned()));
    let refusal = document.write(Format::Ip3).unwrap_err().to_string();
    assert_eq!(refusal, "does not fit into .IP3: the tangents have no place there");
    assert!(document.to_csv().unwrap_err().to_string().contains("tangents"));
    let short = Document::from_json(r#"{"format": "IP3", "points": [[1, 2, 3]], "tangents": []}"#);
    let refusal = short.unwrap_err().to_string();
    assert!(refusal.contains("0 tangents for 1 points; there must be one for every point"), "{refusal}");

    let text = r#"{"format": "IP2", "points": [[1, 2], [4, 5]],
        "settings": {"method": "phspline", "knots": "centripetal", "start": [1, 0.5], "end": [-3, 0]}}"#;
    let document = Document::from_json(text).unwrap();
    assert_eq!(Document::from_json(&document.to_json().unwrap()), Ok(document.clone()));
    assert_eq!(document.settings(), ["end", "knots", "method", "start"]);
    assert!(Document::from_json(&text.replace("centripetal", "random")).is_err());
}

#[test]
fn wrong_json_names_the_line_and_the_field() {
    for (text, message) in [
        ("", "line 1: the text is empty"),
        (
            "[1]",
            "line 1, [0]: this is no point; a document has a format, as in {\"format\": \"IP2\", \"points\": \
             [[1, 2], [3, 4]]}; points alone are a list, [[1, 2], [3, 4]] or [{\"x\": 1, \"y\": 2}]",
        ),
        (
            "{\"points\": []}",
            "line 1: a document has a format, as in {\"format\": \"IP2\", \"points\": [[1, 2], [3, 4]]}; points alone \
             are a list, [[1, 2], [3, 4]] or [{\"x\": 1, \"y\": 2}]",
        ),
        (
            "{\"format\": \"IP4\"}",
            "line 1, format: \"IP4\" is none of IP2, IC2, EC2, GBP, IP3, FHC, FPS, FEM, FPB, FBS, ZMS, ZMB, ZYS, ZYB, ZYP, \
             GYK, CSK, BIL, KCT, KCG, KCF, KCE, KCJ, RBC, PN, RBS, CSM, CSF, ALP, SOM, KOR, GOM, XYZ, PLY, OBJ, STL",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [[1, 2],\n[3, NaN]]}",
            "line 2, points[1][1]: a value is needed here",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [[1, 2],\n[3, 1e999]]}",
            "line 2, points[1][1]: the number is too large",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [[1, 2],\n[\"3\", 4]]}",
            "line 2, points[1][0]: there must be a number here, not the text \"3\"",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [[1, 2, 3]]}",
            "line 1, points[0][2]: there is more than belongs here",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [],\n\"colour\": 3}",
            "line 2, colour: there is no field \"colour\" here, only \"points\", \"tangents\", \"joints\", \"settings\"",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [], \"settings\": {\"k1\": 3}}",
            "line 1, settings.k1: there is no field \"k1\" here, only \"method\", \"closed\", \"k0\", \"bias\", \"tension\", \"degree\", \"knots\", \"start\", \"end\", \"smooth\"",
        ),
        (
            "{\"format\": \"IP2\", \"points\": [], \"tangents\": [[1, 2]]}",
            "1 tangents for 0 points; there must be one for every point",
        ),
        (
            "{\"format\": \"FPS\", \"points\": [[[1, 2, 3]], []]}",
            "row 2 of the net has 0 points and row 1 has 1; all must have the same",
        ),
    ] {
        assert_eq!(Document::from_json(text).unwrap_err().to_string(), message, "{text}");
    }
}

#[test]
fn nets_of_one_family_change_places() {
    let sphere = read(Format::Zms, SPHERE);
    let bytes = sphere.write(Format::Zmb).unwrap();
    assert_eq!(bytes[..12], SPHERE[..12]);
    let refusal = sphere.write(Format::Zys).unwrap_err().to_string();
    assert_eq!(
        refusal,
        "does not fit into .ZYS: net of a spline surface like a sphere; it holds net of a spline surface like a torus"
    );
}

#[test]
fn facts_about_a_file() {
    let lines = read(Format::Ip2, SIX).describe();
    assert_eq!(lines[..3], ["6 control points in the plane", "x 60 .. 520, y 60 .. 300", "point 1: 60, 80"]);
    assert_eq!(read(Format::Csk, FINISHED).describe()[0], "position of the Csángó cube, the finished cube");
    let fourier = read(Format::Gbp, FIGURE_A).describe();
    assert_eq!(fourier[1..], ["a1 = 100, b1 = 100, q1 = 0.5", "a2 = 50, p2 = 1, b2 = 50, q2 = 0.5"]);
}

#[test]
fn conversions_between_kinds() {
    let kind = |name: &str| FileKind::from_name(name).unwrap();
    let to = |bytes: &[u8], from, into| convert(bytes, kind(from), kind(into));
    let csv = to(SIX, "six.ip2", "six.csv").unwrap();
    assert_eq!(String::from_utf8_lossy(&csv[..26]), "x,y\n60,80\n250,200\n320,120\n");
    assert_eq!(read(Format::Ip2, &to(&csv, "A.CSV", "A.IP2").unwrap()), read(Format::Ip2, SIX));
    assert_eq!(read(Format::Ic2, &to(SIX, "A.IP2", "A.IC2").unwrap()), read(Format::Ip2, SIX));
    let space = to(SIX, "A.IP2", "A.IP3").unwrap();
    assert_eq!(read(Format::Ip2, &to(&space, "A.IP3", "A.IP2").unwrap()), read(Format::Ip2, SIX));
    let json = to(&space, "A.IP3", "A.json").unwrap();
    assert_eq!(to(&json, "A.json", "A.IP3"), Ok(space));
    assert_eq!(to(b" X , Y,Z\r\n\r\n1, -2.5e3 ,0.1\r\n", "A.csv", "B.csv").unwrap(), b"x,y,z\n1,-2500,0.1\n");
    for (bytes, from, into, message) in [
        (
            &b"length\n1\n"[..],
            "a.csv",
            "a.ip2",
            "line 1: there is no table of points: rows of two or three numbers with commas, semicolons, tabs or blanks \
             between them, perhaps below a row of names as in x,y",
        ),
        (b"", "a.csv", "a.ip2", "line 1: the table is empty; it has a row for every point, as in 1,2"),
        (b"x,y\n\n1,2,3\n", "a.csv", "a.ip2", "line 3, row: 3 columns; the header has 2"),
        (b"x,y\n1,2\n1,inf\n", "a.csv", "a.ip2", "line 3, column 2 (y): \"inf\" is not a finite number"),
        (b"x,y\n1,\xff\n", "a.csv", "a.ip2", "line 2, column 2 (y): \"ÿ\" is not a finite number"),
        (
            CUBE,
            "a.ip3",
            "a.ip2",
            "does not fit into .IP2: control points in space; it holds control points in the plane",
        ),
        (
            WHEEL,
            "a.gyk",
            "a.csv",
            "does not fit into .CSV: position of the bead wheel; it holds the coordinates of points",
        ),
    ] {
        assert_eq!(to(bytes, from, into).unwrap_err().to_string(), message);
    }
    assert_eq!(FileKind::from_name("a.txt"), None);
}

#[test]
fn json_is_for_people() {
    let document = read(Format::Ic2, CH_POINTS);
    assert_eq!(
        document.to_json().unwrap(),
        "{\n  \"format\": \"IP2\",\n  \"points\": [\n    [100, 50],\n    [160, 300],\n    [300, 120],\n    [440, 320]\n  ]\n}\n"
    );
}
