//! Points in tables as people have them: what is read, what is refused with which sentence, and that every command
//! reads what the others write.

use grafika::file::{Document, FileKind, PlanePoints, SpacePoints, TableOptions};
use proptest::prelude::*;

fn options(columns: &str, delimiter: &str, decimal: &str) -> TableOptions {
    TableOptions {
        columns: (!columns.is_empty()).then(|| columns.parse().unwrap()),
        delimiter: (!delimiter.is_empty()).then(|| delimiter.parse().unwrap()),
        decimal: (!decimal.is_empty()).then(|| decimal.parse().unwrap()),
    }
}

fn read(text: &str, said: &TableOptions) -> Result<Document, String> {
    Document::decode_table(FileKind::Csv, text.as_bytes(), said).map_err(|error| error.to_string())
}

fn plane(points: &[[f64; 2]]) -> Result<Document, String> {
    Ok(Document::PlanePoints(PlanePoints::new(points.to_vec())))
}

fn space(points: &[[f64; 3]]) -> Result<Document, String> {
    Ok(Document::SpacePoints(SpacePoints::new(points.to_vec())))
}

#[test]
fn tables_of_the_plane() {
    let two = plane(&[[1.5, 2.0], [3.0, 4.25]]);
    for text in [
        "x,y\n1.5,2\n3,4.25\n",
        "X , Y\n1.5, 2\n 3,4.25",
        // Spreadsheets where the decimal sign is a comma.
        "\u{feff}x;y\r\n1,5;2\r\n3;4,25\r\n",
        "sep=;\r\nx;y\r\n1,5;2\r\n3;4,25\r\n",
        "\"x\";\"y\"\n\"1,5\";\"2\"\n\"3\";\"4,25\"\n",
        "x,y\n\"1,5\",\"2\"\n\"3\",\"4,25\"\n",
        "x\ty\r1,5\t2\r3\t4,25\r",
        "x y\n1,5 2\n3 4,25\n",
        "  1.5   2\n  3.0   4.25\n",
        // No names, other names, units, comments, lines before the header.
        "1.5,2\n3,4.25\n",
        "1.5;2\n3;4.25\n",
        "# scope\n\nTime (s),Channel 1 (V)\n1.5,2\n3,4.25\n",
        "Model,DS1054\nRate,1000\nDate,2024-01-05\n\nTime,Volt\n(s),(V)\n1.5,2\n3,4.25\n",
        "% x y\n1.5 2\n3 4.25\n",
        "X [mm],Y [mm]\n1.5,2\n3,4.25\n",
        "X [mm] Y [mm]\n1.5 2\n3 4.25\n",
        "x,y\nmm,mm\n1.5,2\n3,4.25\n",
        "mérés\nx_pos;y_pos\n1,5;2\n3;4,25\n",
        // Other columns beside them.
        "y,x\n2,1.5\n4.25,3\n",
        "span,u,x,y\n0,0,1.5,2\n0,1,3,4.25\n",
        ",x,y\n0,1.5,2\n1,3,4.25\n",
        "when,x,y,note\n12:30:00,1.5,2,\"a, b\"\n12:30:01,3,4.25,\n",
        "1.5,2,first\n3,4.25,second\n",
        "2024-01-05 12:30:00;1,5;2\n2024-01-05 12:30:01;3;4,25\n",
        // Delimiters at the ends, and rows of nothing else.
        "x,y,\n1.5,2,\n3,4.25,\n,,\n",
        "1,5;2;\n3;4,25;\n",
    ] {
        assert_eq!(read(text, &TableOptions::default()), two, "{text}");
    }
    assert_eq!(read("x,y\n", &TableOptions::default()), plane(&[]));
    // Thousands, where there is no doubt.
    let thousands = "x;y\n1.234,5;1\u{a0}000\n\u{2212}1.234.567;2,5e3\n";
    assert_eq!(read(thousands, &TableOptions::default()), plane(&[[1234.5, 1000.0], [-1234567.0, 2500.0]]));
    assert_eq!(read("x\ty\n1,234.5\t1\n", &TableOptions::default()), plane(&[[1234.5, 1.0]]));
    assert_eq!(read("x;y\n1,234;5\n2,5;3\n", &TableOptions::default()), plane(&[[1.234, 5.0], [2.5, 3.0]]));
}

#[test]
fn tables_in_space() {
    let two = space(&[[1.5, 2.0, 3.0], [4.0, 5.0, 6.25]]);
    for text in [
        "x,y,z\n1.5,2,3\n4,5,6.25\n",
        "1.5 2 3\n4 5 6.25\n",
        "1,5;2;3\n4;5;6,25\n",
        "i,j,u,v,x,y,z\n0,0,0,0,1.5,2,3\n0,0,1,0,4,5,6.25\n",
        "East,North,Height\n1.5,2,3\n4,5,6.25\n",
        "t;x;y;z\n0;1,5;2;3\n1;4;5;6,25\n",
    ] {
        assert_eq!(read(text, &TableOptions::default()), two, "{text}");
    }
}

#[test]
fn what_the_user_says_decides() {
    let two = plane(&[[1.5, 2.0], [3.0, 4.25]]);
    for (text, said) in [
        ("time,a,b\n1.5,0,2\n3,0,4.25\n", options("time,b", "", "")),
        ("time,a,b\n1.5,0,2\n3,0,4.25\n", options("1,3", "", "")),
        ("Time (s),A (V),B (V)\n1.5,0,2\n3,0,4.25\n", options("TIME,b", "", "")),
        ("1.5,0,2,9\n3,0,4.25,9\n", options("1,3", "", "")),
        ("a b\n1.5 2\n3 4.25\n", options("", "blanks", "")),
        ("x,y,x\n9,2,1.5\n9,4.25,3\n", options("3,2", "", "")),
    ] {
        assert_eq!(read(text, &said), two, "{text} {said:?}");
    }
    let doubtful = "x;y\n1,234;5,678\n";
    assert_eq!(read(doubtful, &options("", "", "comma")), plane(&[[1.234, 5.678]]));
    assert_eq!(read(doubtful, &options("", "", "point")), plane(&[[1234.0, 5678.0]]));
    assert_eq!(read("1,234\n", &options("", "comma", "")), plane(&[[1.0, 234.0]]));
    assert_eq!(read("a,b,c\n1,2,3\n", &options("c,a,b", "", "")), space(&[[3.0, 1.0, 2.0]]));
}

#[test]
fn what_cannot_be_decided_is_said_with_the_option_that_decides() {
    for (text, said, sentence) in [
        (
            "1,234\n",
            "",
            "line 1: \"1,234\" alone may be a point or a number with a decimal comma; --delimiter comma",
        ),
        ("x;y\n1,234;5\n", "", "line 2, column 1 (x): \"1,234\" may be 1.234 or 1234; --decimal point or"),
        ("x;y\n1.234;5,5\n", "", "line 2, column 1 (x): \"1.234\" may be 1.234 or 1234; --decimal point or"),
        ("x;y\n1,5;5\n1.5;3\n", "", "line 3, column 1 (x): \"1.5\" has a decimal point, a number before it"),
        (
            "x,y,x\n1,2,3\n",
            "",
            "line 1: more than one column is called \"x\"; say which by numbers, as in --columns",
        ),
        (
            "Time,A,B\n1,2,3\n",
            "",
            "line 2: which columns are the coordinates? Say it, as in --columns 1,2; there are",
        ),
        (
            "1,2,3,4\n",
            "",
            "line 1: 4 columns of numbers without names; say which are the coordinates, as in --columns",
        ),
        ("1,5,2,5\n3,5,4,5\n", "", "line 1: 4 columns of numbers without names"),
        ("a,b\n1,2\n", "a,c", "line 2: no column is called \"c\"; there are \"a\", \"b\""),
        ("a,b\n1,2\n", "1,7", "line 1: no row has numbers in columns 1 and 7"),
        ("x,y\n1,5,2,5\n", "", "line 2, row: 4 columns; the header has 2"),
        ("x,y\n1,\n", "", "line 2, column 2 (y): the cell is empty"),
        ("x,y\n1,2\n2\n", "", "line 3, column 2 (y): the cell is empty"),
        ("1,2\n2,oops\n3,4\n", "", "line 2, column 2: \"oops\" is not a finite number"),
        ("oops,2\n2,5\n3,4\n", "", "line 1, column 1: \"oops\" is not a finite number"),
        ("1,2,a\n2,oops,b\n3,4,7\n", "", "line 2, column 2: \"oops\" is not a finite number"),
        ("a,b\n1,oops\n3,4\n", "1,2", "line 2, column 2 (b): \"oops\" is not a finite number"),
        ("x,y\nnan,nan\n3,4\n", "", "line 2, column 1 (x): \"nan\" is not a finite number"),
        ("x,y\n1e999,4\n", "", "line 2, column 1 (x): \"1e999\" is not a finite number"),
        ("x,y\n1,\0\n", "", "line 2: there is a zero byte; text is UTF-8, or UTF-16 with a byte order mark"),
        ("only words\n", "", "line 1: there is no table of points"),
        ("1\n2\n", "", "line 1: there is no table of points"),
    ] {
        let refusal = read(text, &options(said, "", "")).unwrap_err();
        assert!(refusal.starts_with(sentence), "{text:?}: {refusal}");
    }
    let refusal = read("x;y\n1,5;2\n", &options("", "", "point")).unwrap_err();
    assert_eq!(refusal, "line 2, column 1 (x): \"1,5\" has a decimal comma, not a decimal point");
    let bytes = Document::PlanePoints(PlanePoints::default()).write(grafika::file::Format::Ip2).unwrap();
    let dos =
        Document::decode_table(FileKind::from_extension("ip2").unwrap(), &bytes, &options("1,2", "", ""));
    assert!(dos.unwrap_err().to_string().starts_with("--columns is for tables"));
}

#[test]
fn lists_in_json_are_points() {
    let json = |text: &str, said: &TableOptions| {
        Document::decode_table(FileKind::Json, text.as_bytes(), said).map_err(|error| error.to_string())
    };
    let none = TableOptions::default();
    assert_eq!(json("[[1,2],[3,4]]", &none), plane(&[[1.0, 2.0], [3.0, 4.0]]));
    assert_eq!(json("[[1,2,3],[4,5,6]]", &none), space(&[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]));
    assert_eq!(
        json("[{\"x\":1,\"y\":2},\n{\"y\":4,\"x\":3,\"n\":[1]}]", &none),
        plane(&[[1.0, 2.0], [3.0, 4.0]])
    );
    assert_eq!(json("[{\"span\":0,\"u\":0.5,\"x\":1,\"y\":2}]", &none), plane(&[[1.0, 2.0]]));
    assert_eq!(json("[{\"t\":1,\"label\":\"a\",\"volts\":2}]", &none), plane(&[[1.0, 2.0]]));
    assert_eq!(json("[{\"t\":1,\"a\":3,\"b\":2}]", &options("t,b", "", "")), plane(&[[1.0, 2.0]]));
    assert_eq!(json("[[1,7,2]]", &options("1,3", "", "")), plane(&[[1.0, 2.0]]));
    for (text, sentence) in [
        ("[[1,2],[3]]", "line 1: point 2: a list of 1; the first has 2"),
        ("[[1,2],{\"x\":1,\"y\":2}]", "line 1: point 2: lists and objects are mixed"),
        ("[{\"x\":1,\"y\":2},{\"x\":1}]", "line 1: point 2: there is no \"y\""),
        ("[{\"x\":1,\"y\":null}]", "line 1: point 1: \"y\" is not a number"),
        ("[{\"t\":1,\"a\":3,\"b\":2}]", "line 1: which columns are the coordinates?"),
        ("[1,2,3]", "line 1, [0]: this is no point; a document has a format, as in {\"format\": \"IP2\""),
        ("[]", "line 1: the list is empty; a document has a format"),
        ("{\"x\": [1, 2]}", "line 1: a document has a format"),
        ("17", "line 1: a document has a format"),
        ("[[1,2]", "line 1, [0]: the text ends too early"),
        ("[1,2", "line 1, [1]: the text ends too early"),
        ("[1 2]", "line 1, [0]: a comma or ] is needed here"),
        ("[[1,2]] 3", "line 1: there is more than belongs here"),
    ] {
        let refusal = json(text, &none).unwrap_err();
        assert!(refusal.starts_with(sentence), "{text}: {refusal}");
    }
    assert!(json("[[1,2]]", &options("", "", "comma")).unwrap_err().starts_with("--decimal is for tables"));
    let document = "{\"format\": \"IP2\", \"points\": [[1, 2]]}";
    assert!(json(document, &options("1,2", "", "")).unwrap_err().starts_with("--columns is for tables"));
    // As a shell of another system writes it.
    let wide: Vec<u8> =
        [0xfeff_u16].into_iter().chain(document.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert_eq!(Document::decode(FileKind::Json, &wide).map_err(|e| e.to_string()), plane(&[[1.0, 2.0]]));
}

/// How a table is written.
#[derive(Clone, Debug)]
struct Dialect {
    delimiter: &'static str,
    comma: bool,
    header: Option<usize>,
    encoding: usize,
    line_end: &'static str,
    quotes: bool,
    comment: bool,
    units: bool,
}

const HEADERS: [[&str; 3]; 3] = [["x", "y", "z"], ["X [mm]", "Y [mm]", "Z [mm]"], ["ő 1", "b", "c"]];

impl Dialect {
    fn write(&self, points: &[[f64; 3]], coordinates: usize) -> Vec<u8> {
        let number = |value: &f64| {
            let text = format!("{value}");
            if self.comma { text.replace('.', ",") } else { text }
        };
        let quoted = |cell: String| if self.quotes { format!("\"{cell}\"") } else { cell };
        let row = |cells: Vec<String>| {
            cells.into_iter().map(quoted).collect::<Vec<_>>().join(self.delimiter) + self.line_end
        };
        let mut text = String::new();
        if self.comment {
            text += &format!("# from 1,5 to \"3; 4{}", self.line_end);
        }
        // Names of several words are one cell only between quotes or other delimiters.
        let spaced = self.delimiter.trim_matches(' ').is_empty() && !self.quotes;
        if let Some(header) = self.header {
            let names = HEADERS[if spaced && header == 2 { 0 } else { header }];
            text += &row(names[..coordinates].iter().map(|name| (*name).to_owned()).collect());
            if self.units {
                text += &row(vec!["(s)".to_owned(); coordinates]);
            }
        }
        for point in points {
            text += &row(point[..coordinates].iter().map(number).collect());
        }
        match self.encoding {
            0 => text.into_bytes(),
            1 => [b"\xef\xbb\xbf", text.as_bytes()].concat(),
            2 => [0xfeff].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect(),
            _ => [0xfeff].into_iter().chain(text.encode_utf16()).flat_map(u16::to_be_bytes).collect(),
        }
    }
}

fn dialect() -> impl Strategy<Value = Dialect> {
    let delimiter = prop::sample::select(vec![",", ";", "\t", " ", "  ", " \t "]);
    let line_end = prop::sample::select(vec!["\n", "\r\n", "\r"]);
    let header = prop::option::of(0_usize..3);
    (delimiter, any::<[bool; 4]>(), header, 0_usize..4, line_end).prop_map(
        |(delimiter, [comma, quotes, comment, units], header, encoding, line_end)| {
            // A decimal comma between commas needs quotes.
            let quotes = quotes || comma && delimiter == ",";
            Dialect { delimiter, comma, header, encoding, line_end, quotes, comment, units }
        },
    )
}

/// Numbers of every size; the first has a fraction that is not three digits long.
fn points() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let any = prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO;
    let number = prop_oneof![any, (-1000..1000).prop_map(|n| f64::from(n) / 8.0)];
    let rest = prop::collection::vec([number.clone(), number.clone(), number.clone()], 1..20);
    (-1000..1000_i32, number.clone(), number, rest)
        .prop_map(|(n, y, z, rest)| std::iter::once([f64::from(n) + 0.5, y, z]).chain(rest).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn every_dialect_is_read_back(dialect in dialect(), points in points(), coordinates in 2_usize..4) {
        let bytes = dialect.write(&points, coordinates);
        let read = Document::decode(FileKind::Csv, &bytes).map_err(|error| error.to_string());
        let flat: Vec<[f64; 2]> = points.iter().map(|&[x, y, _]| [x, y]).collect();
        let expected = if coordinates == 2 { plane(&flat) } else { space(&points) };
        prop_assert_eq!(&read, &expected, "{}", String::from_utf8_lossy(&bytes));
        // Equal as doubles, and bit for bit.
        prop_assert_eq!(format!("{read:?}"), format!("{expected:?}"));
    }

    #[test]
    fn any_text_is_points_or_a_reason(
        text in "[0-9xy.,;\"\t\n\r #%+e\u{a0}ő(\\[-]{0,60}",
        columns in prop::sample::select(vec!["", "1,2", "x,y", "x,3", "2,1,9"]),
        delimiter in prop::sample::select(vec!["", "comma", "blanks"]),
        decimal in prop::sample::select(vec!["", "comma"]),
    ) {
        let said = options(columns, delimiter, decimal);
        match Document::decode_table(FileKind::Csv, text.as_bytes(), &said) {
            Ok(document) => {
                prop_assert_eq!(document.check(), Ok(()));
                prop_assert_eq!(Document::from_csv(&document.to_csv()?)?, document);
            }
            Err(error) => prop_assert!(error.to_string().starts_with("line "), "{}", error),
        }
    }

    #[test]
    fn any_bytes_are_points_or_a_reason(bytes in prop::collection::vec(any::<u8>(), 0..200), wide: bool) {
        let bytes = if wide { [&b"\xff\xfe"[..], &bytes].concat() } else { bytes };
        for kind in [FileKind::Csv, FileKind::Json] {
            if let Err(error) = Document::decode(kind, &bytes) {
                prop_assert!(error.to_string().starts_with("line "), "{}", error);
            }
        }
    }

    #[test]
    fn any_list_in_json_is_points_or_a_reason(text in "\\[[0-9xy.,:\"{}\\[\\] -]{0,40}\\]") {
        match Document::from_json(&text) {
            Ok(document) => prop_assert_eq!(Document::from_json(&document.to_json()?)?, document),
            Err(error) => prop_assert!(error.to_string().starts_with("line "), "{}", error),
        }
    }
}

/// The commands on tables.
#[cfg(feature = "native")]
mod commands {
    use std::path::PathBuf;
    use std::process::{Command, Output};

    /// A folder of its own for a test.
    fn folder(name: &str) -> PathBuf {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("tables").join(name);
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn grafika(folder: &PathBuf, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
        command.current_dir(folder).args(arguments).output().expect("it starts")
    }

    /// Standard output and standard error of a command that does its work.
    fn done(folder: &PathBuf, arguments: &[&str]) -> [String; 2] {
        let output = grafika(folder, arguments);
        let texts = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {texts:?}");
        texts
    }

    #[test]
    fn every_command_reads_what_the_others_write() {
        let folder = folder("written");
        done(&folder, &["sample", "A.IP2", "--method", "spline", "--per-span", "3", "-o", "curve.csv"]);
        done(&folder, &["sample", "A.IP2", "--method", "spline", "--per-span", "3", "-o", "curve.json"]);
        done(&folder, &["sample", "A.IP3", "--method", "bspline3", "--per-span", "3", "-o", "space.csv"]);
        done(&folder, &["sample", "A.ZMS", "--per-span", "1", "-o", "surface.csv"]);
        done(&folder, &["sample", "A.ZMS", "--per-span", "1", "-o", "surface.json"]);
        done(&folder, &["smooth", "Y.IP2", "-o", "smooth.csv"]);
        done(&folder, &["smooth", "A.IP3", "-o", "smooth.json"]);
        let names = [
            "curve.csv",
            "curve.json",
            "space.csv",
            "surface.csv",
            "surface.json",
            "smooth.csv",
            "smooth.json",
        ];
        for name in names {
            let [facts, _] = done(&folder, &["info", name]);
            let place =
                if ["curve.csv", "curve.json", "smooth.csv"].contains(&name) { "the plane" } else { "space" };
            assert!(facts.lines().next().unwrap().ends_with(place), "{name}: {facts}");
            done(&folder, &["sample", name, "--method", "bspline3", "-o", "again.csv"]);
            done(&folder, &["render", name, "--method", "bspline3", "--points", "-o", "again.png"]);
            done(&folder, &["smooth", name, "-o", "again.csv"]);
            done(&folder, &["convert", name, "again.json"]);
            done(&folder, &["convert", name, "again.csv"]);
            assert_eq!(done(&folder, &["info", "again.json"]), [facts, String::new()], "{name}");
        }
    }

    #[test]
    fn the_options_of_tables_are_those_of_every_command() {
        let folder = folder("options");
        std::fs::write(folder.join("doubtful.csv"), "t;a;b\n1,234;9;5,678\n2;9;3,5\n3;9;4\n4;9;5\n").unwrap();
        let said = ["--columns", "t,b", "--delimiter", "semicolon", "--decimal", "comma"];
        let with = |words: &[&'static str]| -> Vec<&str> { words.iter().chain(&said).copied().collect() };
        let [facts, _] = done(&folder, &with(&["info", "doubtful.csv"]));
        assert!(facts.contains("x 1.234 .. 4, y 3.5 .. 5.678"), "{facts}");
        done(&folder, &with(&["sample", "doubtful.csv", "--method", "spline", "-o", "s.csv"]));
        done(&folder, &with(&["render", "doubtful.csv", "--method", "spline", "-o", "s.svg"]));
        done(&folder, &with(&["convert", "doubtful.csv", "s.json"]));
        done(&folder, &with(&["smooth", "doubtful.csv", "-o", "s.csv"]));
        std::fs::write(folder.join("wait.script"), "wait 10\nclose\n").unwrap();
        done(&folder, &with(&["open", "doubtful.csv", "--script", "wait.script"]));
        done(&folder, &with(&["gb_2d_ip", "doubtful.csv", "--script", "wait.script"]));
        for (arguments, part) in [
            (&["info", "A.IP2", "--columns", "1,2"][..], "A.IP2: --columns is for tables"),
            (&["info", "doubtful.csv", "--columns", "1"], "two or three different names, or numbers from 1"),
            (&["info", "doubtful.csv", "--delimiter", "dash"], "there are comma, semicolon, tab and blanks"),
            (&["info", "doubtful.csv", "--decimal", "dash"], "there are point and comma"),
            (&["biliard", "A.BIL", "--columns", "1"], "two or three different names"),
        ] {
            let output = grafika(&folder, arguments);
            let stderr = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
            assert!(stderr.contains(part) && stderr.lines().count() == 1, "{arguments:?}: {stderr}");
        }
        // Programs that open no points do not speak of tables.
        assert!(done(&folder, &["gb_2d_ip", "--help"])[0].contains("--columns"));
        assert!(!done(&folder, &["gyongy_k", "--help"])[0].contains("--columns"));
    }

    #[test]
    fn tables_have_several_extensions() {
        let folder = folder("extensions");
        for name in ["a.tsv", "a.TXT", "a.dat", "a.tab"] {
            std::fs::write(folder.join(name), "1,5\t2\n3\t4\n").unwrap();
            let [facts, _] = done(&folder, &["info", name]);
            assert!(facts.starts_with("2 control points in the plane"), "{name}: {facts}");
            // What is written says itself what it is.
            assert_eq!(grafika(&folder, &["convert", "A.IP2", name]).status.code(), Some(1), "{name}");
        }
        done(&folder, &["info", "a.dat", "--from", "txt"]);
    }

    #[test]
    fn pictures_of_many_points_take_no_longer_than_they_must() {
        let folder = folder("many");
        let rows: String = (0..100_000).map(|i| format!("{},{}\n", f64::from(i) * 0.01, i % 97)).collect();
        std::fs::write(folder.join("many.csv"), format!("x,y\n{rows}")).unwrap();
        let start = std::time::Instant::now();
        done(&folder, &["render", "many.csv", "--method", "bspline3", "--points", "-o", "many.pdf"]);
        done(
            &folder,
            &["render", "many.csv", "--method", "bspline3", "--points", "--axes", "-o", "many.png"],
        );
        // It takes some seconds; with every label among all others it was a minute for the first alone.
        assert!(start.elapsed().as_secs() < 40, "{:?}", start.elapsed());
        let size = std::fs::metadata(folder.join("many.pdf")).unwrap().len();
        assert!(size < 30_000_000, "{size} bytes");
    }
}
