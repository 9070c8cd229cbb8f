//! What is read from files of every format, in one piece and in many, and what is refused.

use super::*;
use proptest::prelude::*;

const CUBE_CORNERS: usize = 8;

fn read(format: CloudFormat, text: &str) -> Result<Cloud, String> {
    Cloud::read(format, text.as_bytes()).map_err(|error| error.to_string())
}

/// Reads pieces of these lengths, again and again.
fn in_pieces(format: CloudFormat, bytes: &[u8], lengths: &[usize]) -> Result<Cloud, FileError> {
    let mut reader = CloudReader::new(format, &TableOptions::default())?;
    let (mut rest, mut lengths) = (bytes, lengths.iter().cycle());
    while !rest.is_empty() {
        let length = lengths.next().map_or(1, |&length| length.clamp(1, rest.len()));
        let (piece, after) = rest.split_at(length);
        reader.feed(piece)?;
        rest = after;
    }
    reader.finish()
}

/// The corners of a cube.
fn cube() -> Vec<[f64; 3]> {
    (0..CUBE_CORNERS).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|bit| bit as f64)).collect()
}

/// Some triangles between the corners of a cube.
fn triangles() -> Vec<[[f64; 3]; 3]> {
    let cube = cube();
    (0..CUBE_CORNERS).map(|k| [0, 1, 3].map(|step| cube[(k + step) % CUBE_CORNERS])).collect()
}

fn binary_stl(header: &[u8], triangles: &[[[f64; 3]; 3]]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([9.0_f32; 3].into_iter().flat_map(f32::to_le_bytes));
        bytes.extend(triangle.iter().flatten().flat_map(|&value| (value as f32).to_le_bytes()));
        bytes.extend([7; 2]);
    }
    bytes
}

fn text_stl(triangles: &[[[f64; 3]; 3]]) -> String {
    let corner = |[x, y, z]: &[f64; 3]| format!("      vertex {x:e} {y} {z}\n");
    let facet = |corners: &[[f64; 3]; 3]| {
        let corners: String = corners.iter().map(corner).collect();
        format!("  facet normal 0 0 1\n    outer loop\n{corners}    endloop\n  endfacet\n")
    };
    format!("solid cube of 8\n{}endsolid cube\n", triangles.iter().map(facet).collect::<String>())
}

/// Binary PLY with lists and other elements before the points, properties before x, and a list within the points.
fn binary_ply(points: &[[f64; 3]], big_endian: bool, lists: bool) -> Vec<u8> {
    let (order, list) =
        (if big_endian { "big" } else { "little" }, if lists { "property list short float w\n" } else { "" });
    let mut bytes = format!(
        "ply\r\nformat binary_{order}_endian 1.0\r\nelement face 2\r\nproperty list uchar int i\r\nelement more 3\r\n\
         property double d\r\nelement none 0\r\nproperty list int int i\r\nelement vertex {}\r\nproperty uchar red\r\n{list}\
         property double z\r\nproperty float x\r\nproperty double y\r\nproperty int last\r\nelement edge 5\r\nproperty int a\r\nend_header\r\n",
        points.len()
    )
    .replace(list, &list.replace('\n', "\r\n"))
    .into_bytes();
    let mut put = |number: &[u8]| {
        let mut number = number.to_vec();
        if big_endian {
            number.reverse();
        }
        bytes.extend(number);
    };
    for length in [3_u8, 0] {
        put(&[length]);
        (0..length).for_each(|k| put(&i32::from(k).to_le_bytes()));
    }
    (0..3).for_each(|k| put(&f64::from(k).to_le_bytes()));
    for (k, [x, y, z]) in points.iter().enumerate() {
        put(&[k as u8]);
        if lists {
            let length = (k % 3) as i16;
            put(&length.to_le_bytes());
            (0..length).for_each(|w| put(&f32::from(w).to_le_bytes()));
        }
        put(&z.to_le_bytes());
        put(&(*x as f32).to_le_bytes());
        put(&y.to_le_bytes());
        put(&[1, 2, 3, 4]);
    }
    bytes
}

#[test]
fn tables_as_people_have_them() {
    let two = vec![[1.5, 2.0, -3e3], [4.0, 5.0, 6.0]];
    for text in [
        "1.5 2 -3e3\n4 5 6\n",
        "# cloud\n\n 1.5\t2 \t -3000\r\n\r\n4   5 6.0   \r\n",
        "1.5 2 -3e3 0.7 255\n4 5 6 0.7 0\n",
        "1.5 2 -3000 red # a comment\n4 5 6 green",
        "\u{feff}1.5 2 -3.D+3\r4 5 6\r",
        "2\n1.5 2 -3e3\n4 5 6\n",
        "1.5,2,-3e3\n4, 5, 6\n",
        "1.5, 2, -3e3\n4, 5, 6\n",
        "1,5;2;-3e3\n4;5;6\n",
        "1,5 2,0 -3000,0\n4,0 5,0 6,0\n",
        "1.5;2;-3e3;\n4;5;6;\n",
        "x,y,z\n1.5,2,-3e3\n4,5,6\n",
        "x y z\n1.5 2 -3e3\n4 5 6\n",
        "//X Y Z R\n2\n1.5 2 -3e3 9\n4 5 6 9\n",
        "# z y x\n-3e3 2 1.5\n6 5 4\n",
        "id,\"z\",name,\"X [mm]\",y\n7,-3e3,\"a, b\",1.5,2\n8,6,,\"4\",5,9\n",
        "East;North;Height\n1,5;2;-3 000\n4;5;6\n".replace(' ', "\u{a0}").as_str(),
        "a scan\n1.5 2 -3e3 1\n4 5 6 1\n",
        "sep=;\n1.5;2;-3e3\n4;5;6\n",
        "% q r s\n1.5 2 -3e3\n4 5 6",
    ] {
        for format in [CloudFormat::Xyz, CloudFormat::Csv] {
            let cloud = read(format, text).unwrap();
            assert_eq!(cloud.points, two, "{text}");
            assert!(cloud.skipped.is_empty(), "{text}: {:?}", cloud.skipped);
        }
    }
    let latin: Vec<u8> =
        "# m\u{e9}r\u{e9}s\n1.5 2 -3e3\n4 5 6 \u{e9}\n".chars().map(|letter| letter as u8).collect();
    assert_eq!(Cloud::read(CloudFormat::Xyz, &latin).unwrap().points, two);
}

#[test]
fn plane_clouds_have_two_columns() {
    let flat = vec![[1.0, 2.5, 0.0], [3.0, 4.0, 0.0]];
    for text in
        ["1 2.5\n3 4\n", "x,y\n1,2.5\n3,4\n", "y,n,x\n2.5,7,1\n4,7,3\n", "1;2,5\n3;4\n", "1,2.5\n3,4\n"]
    {
        let cloud = read(CloudFormat::Xyz, text).unwrap();
        assert_eq!(cloud.points, flat, "{text}");
        assert!(cloud.is_plane());
    }
    // As most rows have it.
    let cloud = read(CloudFormat::Xyz, "1 2\n3 4 5\n6 7\n8 9 10\n11 12 13\n").unwrap();
    assert_eq!(cloud.points, [[3.0, 4.0, 5.0], [8.0, 9.0, 10.0], [11.0, 12.0, 13.0]]);
    assert_eq!(cloud.skipped.told(), ["2 lines with too few coordinates, the first in line 1"]);
    let cloud = read(CloudFormat::Xyz, "1 2 a\n3 4 5\n6 7\n").unwrap();
    assert_eq!(cloud.points, [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0], [6.0, 7.0, 0.0]]);
}

#[test]
fn what_is_no_number_is_left_out_or_refused() {
    let text = "1 2 3\n1 nan 3\n1 2\n# c\n4 5 -inf\n7\n-nan(ind) 1 1\n1e999 0 0\n1e200 0 0\n";
    let cloud = read(CloudFormat::Xyz, text).unwrap();
    assert_eq!(cloud.points, [[1.0, 2.0, 3.0]]);
    assert_eq!(
        cloud.skipped.told(),
        [
            "5 points with NaN, infinite or huge coordinates, the first in line 2",
            "2 lines with too few coordinates, the first in line 3"
        ]
    );
    for (text, message) in [
        ("1 2 3\n4 x5 6\n", "line 2, column 2: \"x5\" is not a number"),
        (
            "1.5 2 3\n4 5,5 6\n",
            "line 2, column 2: \"5,5\" has a decimal comma, a number before it a decimal point",
        ),
        (
            "1;2,5;3\n4;5.5;6\n",
            "line 2, column 2: \"5.5\" has a decimal point, a number before it a decimal comma",
        ),
        ("x;y;z\n1,234;5;6\n", "line 2, column 1 (x): \"1,234\" may be 1.234 or 1234; --decimal point or"),
        ("z,y,x\n1,2,3\n4,5,oops\n", "line 3, column 3 (x): \"oops\" is not a number"),
        ("x,y,x\n1,2,3\n", "line 1: more than one column is called \"x\""),
        (
            "a,b,c,d\n1,2,3,4\n",
            "line 2: which columns are the coordinates? Say it, as in --columns 1,2; there are",
        ),
        ("C 1 2 3\nH 4 5 6\n", "line 1, column 1: \"C\" is not a number"),
        ("1 2 3\n4 5 6\0\n", "line 2: there is a zero byte"),
        ("", "line 1: there is no table of points"),
        ("# nothing\n\n", "line 1: there is no table of points"),
        ("only words\nand more\n", "line 1: there is no table of points"),
        ("1\n2\n", "line 1: there is no table of points"),
        (
            "1 2 nan\n",
            "there are no points; left out: 1 point with NaN, infinite or huge coordinates, in line 1",
        ),
    ] {
        let error = read(CloudFormat::Xyz, text).unwrap_err();
        assert!(error.starts_with(message), "{text:?}: {error}");
    }
    let far = format!("{}1 2 x\n", "1 2 3\n".repeat(100_000));
    assert_eq!(read(CloudFormat::Xyz, &far).unwrap_err(), "line 100001, column 3: \"x\" is not a number");
}

#[test]
fn what_the_user_says_decides() {
    let with = |format: CloudFormat, text: &str, columns: &str, decimal: &str| {
        let options = TableOptions {
            columns: (!columns.is_empty()).then(|| columns.parse().unwrap()),
            decimal: (!decimal.is_empty()).then(|| decimal.parse().unwrap()),
            delimiter: None,
        };
        let mut reader = CloudReader::new(format, &options).map_err(|error| error.to_string())?;
        reader.feed(text.as_bytes()).and_then(|()| reader.finish()).map_err(|error| error.to_string())
    };
    let points = |columns: &str, decimal: &str, text: &str| {
        with(CloudFormat::Csv, text, columns, decimal).unwrap().points
    };
    assert_eq!(points("4,1,2", "", "1 2 3 4\n5 6 7 8\n"), [[4.0, 1.0, 2.0], [8.0, 5.0, 6.0]]);
    assert_eq!(points("c,a", "", "a,b,c,d\n1,2,3,4\n"), [[3.0, 1.0, 0.0]]);
    assert_eq!(points("", "comma", "1,234;5;6\n"), [[1.234, 5.0, 6.0]]);
    assert_eq!(points("", "point", "1,234;5;6\n"), [[1234.0, 5.0, 6.0]]);
    let error = with(CloudFormat::Csv, "a,b\n1,2\n", "a,q", "").unwrap_err();
    assert_eq!(error, "line 2: no column is called \"q\"; there are \"a\", \"b\"");
    let error = with(CloudFormat::Obj, "v 1 2 3\n", "1,2", "").unwrap_err();
    assert!(error.starts_with("--columns is for tables"), "{error}");
}

#[test]
fn vertices_of_obj() {
    let text = "# cube\no a\nv 1 2 3\nvn 0 0 1\nvt 0 0\n\n  v\t4 5e0 6 1.0\r\nv 7 8 9 1 0 0 # c\nf 1/1 2/2 3/3\nv 1 2\nv nan 0 0\nvp 1 2 3\n";
    let cloud = read(CloudFormat::Obj, text).unwrap();
    assert_eq!(cloud.points, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
    assert_eq!(cloud.encoding, Some(Encoding::Obj));
    let [not_finite, short] = [cloud.skipped.not_finite, cloud.skipped.short];
    assert_eq!((not_finite.count, not_finite.first), (1, Some(Spot::Line(11))));
    assert_eq!((short.count, short.first), (1, Some(Spot::Line(10))));
    assert_eq!(
        read(CloudFormat::Obj, "v 1 2 3\nv 1 b 3\n").unwrap_err(),
        "line 2, word 3: \"b\" is not a number"
    );
    assert_eq!(read(CloudFormat::Obj, "f 1 2 3\n").unwrap_err(), "there are no points");
}

#[test]
fn corners_of_stl() {
    let triangles = triangles();
    // The order in which they come.
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for corner in triangles.iter().flatten() {
        if !corners.contains(corner) {
            corners.push(*corner);
        }
    }
    assert_eq!(corners.len(), CUBE_CORNERS);
    let text = text_stl(&triangles);
    // The header of a binary file may look like text.
    let (plain, solid) = (binary_stl(b"", &triangles), binary_stl(b"solid cube\nfacet", &triangles));
    for (bytes, encoding) in [
        (text.as_bytes(), Encoding::StlText),
        (text.replace('\n', "\r\n").to_uppercase().as_bytes(), Encoding::StlText),
        (&plain[..], Encoding::StlBinary),
        (&solid[..], Encoding::StlBinary),
        (&[&plain[..], b"more"].concat(), Encoding::StlBinary),
    ] {
        let cloud = Cloud::read(CloudFormat::Stl, bytes).unwrap();
        assert_eq!((cloud.points, cloud.encoding), (corners.clone(), Some(encoding)));
    }
    // Zero has one sign.
    let same = "solid\nvertex 0 0 0\nvertex -0 0 0\nvertex 1 nan 2\nvertex 1 2\nendsolid";
    let cloud = read(CloudFormat::Stl, same).unwrap();
    assert_eq!((cloud.points.len(), cloud.skipped.told().len()), (1, 2));
    let refusal = |bytes: &[u8]| Cloud::read(CloudFormat::Stl, bytes).unwrap_err().to_string();
    assert_eq!(
        refusal(&plain[..84 + 50 * 3 + 11]),
        "triangle 4 (byte 245): the file ends here; 3 of 8 triangles were read"
    );
    assert_eq!(refusal(&plain[..84]), "triangle 1 (byte 84): the file ends here; 0 of 8 triangles were read");
    assert_eq!(refusal(&binary_stl(b"", &[])), "there are no points");
    let cut = text.len() - 14;
    assert_eq!(
        refusal(&text.as_bytes()[..cut]),
        "line 58: the file ends before \"endsolid\"; 8 different corners were read"
    );
    assert!(
        refusal(text.replacen("vertex", "vertx", 1).as_bytes())
            .starts_with("line 4: \"vertx\" begins no line of STL")
    );
    for bytes in [&b"Solids"[..], b"", &[0; 83], &[b'a'; 200]] {
        assert!(refusal(bytes).starts_with("this is no STL file"));
    }
}

#[test]
fn points_of_binary_ply() {
    let points = vec![[0.5, 1e-3, 3.0], [f64::NAN, 0.0, 1.0], [-4.0, 5.0, 1e300], [7.0, -8.0, 1e100]];
    for (big_endian, lists) in [(false, false), (true, false), (false, true), (true, true)] {
        let bytes = binary_ply(&points, big_endian, lists);
        // Whatever it is called.
        let cloud = Cloud::read(CloudFormat::Xyz, &bytes).unwrap();
        assert_eq!(cloud.points, [points[0], points[3]]);
        assert_eq!(
            cloud.skipped.told(),
            ["2 points with NaN, infinite or huge coordinates, the first in point 2"]
        );
        assert_eq!(
            cloud.encoding,
            Some(if big_endian { Encoding::PlyBigEndian } else { Encoding::PlyLittleEndian })
        );
        let cut = &bytes[..bytes.len() - 30];
        let error = Cloud::read(CloudFormat::Ply, cut).unwrap_err().to_string();
        let expected = format!("point 3 (byte {}): the file ends here; 2 of 4 points were read", cut.len());
        assert_eq!(error, expected);
        let header = bytes.windows(12).position(|it| it == b"end_header\r\n").unwrap() + 12;
        let error = Cloud::read(CloudFormat::Ply, &bytes[..header + 2]).unwrap_err().to_string();
        assert!(error.ends_with("the file ends here; 0 of 4 points were read"), "{error}");
    }
    let negative = binary_ply(&points, false, true);
    let at = negative.len() - 24 - 2;
    let mut negative = negative;
    negative[at..at + 2].copy_from_slice(&(-1_i16).to_le_bytes());
    let error = Cloud::read(CloudFormat::Ply, &negative).unwrap_err().to_string();
    assert!(error.starts_with("element 4 of \"vertex\" (byte "), "{error}");
}

#[test]
fn text_in_two_bytes_a_letter() {
    let text = "\u{feff}# \u{1f600}\r\nx;y;z\r\n1,5;2;3\r\n";
    let [little, big]: [Vec<u8>; 2] = [
        text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        text.encode_utf16().flat_map(u16::to_be_bytes).collect(),
    ];
    for bytes in [little, big] {
        for length in [1, 2, 3, 100] {
            let cloud = in_pieces(CloudFormat::Csv, &bytes, &[length]).unwrap();
            assert_eq!(cloud.points, [[1.5, 2.0, 3.0]]);
        }
    }
}

#[test]
fn clouds_are_written_and_described() {
    let cloud = Cloud::new(vec![[0.1, -2.0, 1e300 / 1e200], [1e-9, 0.0, 4.0]]);
    let text = |format: CloudFormat| String::from_utf8(cloud.write(format).unwrap()).unwrap();
    assert_eq!(text(CloudFormat::Xyz), "0.1 -2 1e100\n1e-9 0 4\n");
    assert_eq!(text(CloudFormat::Csv), "x,y,z\n0.1,-2,1e100\n1e-9,0,4\n");
    assert_eq!(text(CloudFormat::Obj), "v 0.1 -2 1e100\nv 1e-9 0 4\n");
    let error = cloud.write(CloudFormat::Stl).unwrap_err().to_string();
    assert_eq!(error, "does not fit into .STL: the points of a cloud; it holds triangles");
    let flat = Cloud::new(vec![[1.0, 2.0, 0.0]]);
    assert_eq!(flat.write(CloudFormat::Xyz).unwrap(), b"1 2\n");
    assert_eq!(flat.write(CloudFormat::Csv).unwrap(), b"x,y\n1,2\n");
    assert_eq!(flat.describe(), ["1 point of a cloud in the plane", "x 1 .. 1, y 2 .. 2, z 0 .. 0"]);
    let read = read(CloudFormat::Xyz, "1 2 3\n4 5 6\n7 8\n").unwrap();
    assert_eq!(
        read.describe(),
        [
            "2 points of a cloud in space",
            "XYZ",
            "x 1 .. 4, y 2 .. 5, z 3 .. 6",
            "left out: 1 line with too few coordinates, in line 3"
        ]
    );
    assert!(Cloud::default().write(CloudFormat::Xyz).is_err());
    assert!(Cloud::new(vec![[0.0, f64::NAN, 0.0]]).write(CloudFormat::Ply).is_err());
    for (name, format) in [("xyz", CloudFormat::Xyz), ("TXT", CloudFormat::Csv), ("Stl", CloudFormat::Stl)] {
        assert_eq!(CloudFormat::from_extension(name), Some(format));
    }
    assert_eq!(CloudFormat::from_extension("ip3"), None);
}

const ALL: [CloudFormat; 5] =
    [CloudFormat::Xyz, CloudFormat::Csv, CloudFormat::Ply, CloudFormat::Obj, CloudFormat::Stl];

fn coordinate() -> impl Strategy<Value = f64> {
    let any = prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO;
    prop_oneof![
        any.prop_map(|value: f64| value.clamp(-1e150, 1e150)),
        (-1000..1000).prop_map(|n| f64::from(n) / 8.0)
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn what_is_written_is_read_back(
        points in prop::collection::vec([coordinate(), coordinate(), coordinate()], 1..40),
        flat: bool,
        lengths in prop::collection::vec(1_usize..50, 1..4),
    ) {
        let points = points.into_iter().map(|[x, y, z]| if flat { [x, y, 0.0] } else { [x, y, z] }).collect();
        let cloud = Cloud::new(points);
        for format in &ALL[..4] {
            let bytes = cloud.write(*format)?;
            let read = in_pieces(*format, &bytes, &lengths)?;
            prop_assert_eq!(&read.points, &cloud.points);
            prop_assert!(read.skipped.is_empty());
            prop_assert_eq!(read.is_plane(), cloud.is_plane());
            prop_assert_eq!(read, Cloud::read(*format, &bytes)?);
        }
    }

    #[test]
    fn pieces_of_any_length_make_no_difference(
        points in prop::collection::vec([coordinate(), coordinate(), coordinate()], 1..9),
        lengths in prop::collection::vec(1_usize..200, 1..4),
        cut in 0_usize..400,
        kind in 0..6,
    ) {
        let corners: Vec<[[f64; 3]; 3]> = points.iter().map(|&p| [p, points[0], [1.0; 3]]).collect();
        let (format, mut bytes) = match kind {
            0 => (CloudFormat::Ply, binary_ply(&points, false, false)),
            1 => (CloudFormat::Ply, binary_ply(&points, true, true)),
            2 => (CloudFormat::Stl, binary_stl(b"solid", &corners)),
            3 => (CloudFormat::Stl, text_stl(&corners).into_bytes()),
            4 => (CloudFormat::Csv, Cloud::new(points).write(CloudFormat::Csv)?),
            _ => (CloudFormat::Obj, Cloud::new(points).write(CloudFormat::Obj)?),
        };
        bytes.truncate(bytes.len().saturating_sub(cut));
        prop_assert_eq!(in_pieces(format, &bytes, &lengths), Cloud::read(format, &bytes));
    }

    #[test]
    fn any_bytes_are_a_cloud_or_a_reason(
        bytes in prop::collection::vec(any::<u8>(), 0..300),
        begin in prop::sample::select(vec!["", "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty list char char l\nproperty float x\nproperty float y\nproperty float z\nend_header\n", "solid\n", "v 1 2 3\nv ", "1 2 3\n"]),
        lengths in prop::collection::vec(1_usize..200, 1..4),
    ) {
        let bytes = [begin.as_bytes(), &bytes].concat();
        for format in ALL {
            let whole = Cloud::read(format, &bytes);
            match &whole {
                Ok(cloud) => prop_assert_eq!(cloud.check(), Ok(())),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
            prop_assert_eq!(in_pieces(format, &bytes, &lengths), whole);
        }
    }

    #[test]
    fn any_text_is_a_cloud_or_a_reason(text in "[0-9xyzvn.,;\"\t\n\r #%+e\u{a0}ő-]{0,80}", lengths in prop::collection::vec(1_usize..40, 1..4)) {
        for format in ALL {
            let whole = Cloud::read(format, text.as_bytes());
            prop_assert_eq!(in_pieces(format, text.as_bytes(), &lengths), whole);
        }
    }
}
