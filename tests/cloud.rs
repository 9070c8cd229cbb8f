//! Clouds of points: as documents, from the models that `figure` writes, and through the commands.

use grafika::figure::Mesh;
use grafika::file::{Cloud, CloudFormat, Document, FileKind, Format, SpacePoints};
use grafika::geometry::Point;

fn points(document: Document) -> Vec<Point<3>> {
    let Document::Cloud(cloud) = document else { panic!("this is no cloud: {document:?}") };
    cloud.points
}

#[test]
fn clouds_are_documents() {
    let cloud = Document::Cloud(Cloud::new(vec![[0.1, 2.0, 3.0], [4.0, -5.0, 6.5]]));
    assert_eq!(cloud.format(), Format::Xyz);
    let json = cloud.to_json().unwrap();
    assert!(json.contains("\"format\": \"XYZ\""), "{json}");
    assert_eq!(Document::from_json(&json), Ok(cloud.clone()));
    assert_eq!(Document::from_json(&json.replace("XYZ", "PLY")), Ok(cloud.clone()));
    let space = Document::SpacePoints(SpacePoints::new(points(cloud.clone())));
    assert_eq!(space.clone().adapted(Format::Obj), cloud);
    assert_eq!(cloud.clone().adapted(Format::Ip3), space);
    for name in ["a.XYZ", "a.ply", "a.obj"] {
        let kind = FileKind::from_name(name).unwrap();
        let read = Document::decode(kind, &cloud.encode(kind).unwrap()).unwrap();
        assert_eq!(points(read), points(cloud.clone()), "{name}");
    }
    assert_eq!(Document::from_csv(&cloud.to_csv().unwrap()), Ok(space));
    let refusal = cloud.write(Format::Stl).unwrap_err().to_string();
    assert_eq!(refusal, "does not fit into .STL: the points of a cloud; it holds triangles");
    for wrong in
        ["{\"format\": \"XYZ\", \"points\": []}", "{\"format\": \"XYZ\", \"points\": [[1,2,3]], \"more\": 1}"]
    {
        assert!(Document::from_json(wrong).is_err(), "{wrong}");
    }
}

/// What `figure` writes is read, vertex for vertex.
#[test]
fn models_are_clouds_of_their_vertices() {
    let grid = surface_grid();
    let mesh = Mesh::from_grid(&grid).unwrap();
    let read = |format: CloudFormat, bytes: &[u8]| Cloud::read(format, bytes).unwrap().points;
    assert_eq!(read(CloudFormat::Ply, &mesh.to_ply().unwrap()), mesh.vertices());
    assert_eq!(read(CloudFormat::Obj, mesh.to_obj().as_bytes()), mesh.vertices());
    let sorted = |points: &[Point<3>]| {
        let mut bits: Vec<[u64; 3]> =
            points.iter().map(|p| p.map(|x| (f64::from(x as f32) + 0.0).to_bits())).collect();
        bits.sort_unstable();
        bits
    };
    let corners = read(CloudFormat::Stl, &mesh.to_stl().unwrap().bytes);
    assert_eq!(sorted(&corners), sorted(mesh.vertices()));
}

/// A bumpy surface through 4 x 4 points.
fn surface_grid() -> grafika::geometry::Grid {
    let net: Vec<Vec<Point<3>>> = (0..4)
        .map(|k| (0..4).map(|l| [f64::from(k) / 3.0, f64::from(l) / 7.0, f64::from(k * l % 3)]).collect())
        .collect();
    let net = grafika::design::NetDesign::new(grafika::file::Net::new(grafika::file::NetKind::Fpb, net));
    net.surface().unwrap().grid(9).unwrap()
}

/// The commands.
#[cfg(feature = "native")]
mod commands {
    use std::fmt::Write as _;
    use std::io::{Read as _, Write as _};
    use std::path::PathBuf;
    use std::process::{Command, Output, Stdio};

    /// A folder of its own for a test.
    fn folder(name: &str) -> PathBuf {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("cloud").join(name);
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn grafika(folder: &PathBuf, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
        command.current_dir(folder).args(arguments).output().expect("it starts")
    }

    fn texts(output: Output) -> [String; 2] {
        [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap())
    }

    /// Standard output and standard error of a command that does its work.
    fn done(folder: &PathBuf, arguments: &[&str]) -> [String; 2] {
        let output = grafika(folder, arguments);
        let status = output.status.code();
        let texts = texts(output);
        assert_eq!(status, Some(0), "{arguments:?}: {texts:?}");
        texts
    }

    /// The message of a command that fails.
    fn refused(folder: &PathBuf, arguments: &[&str]) -> String {
        let output = grafika(folder, arguments);
        let status = output.status.code();
        let [_, message] = texts(output);
        assert_eq!(status, Some(1), "{arguments:?}: {message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        message
    }

    #[test]
    fn what_a_cloud_is_and_what_was_left_out_is_told() {
        let folder = folder("info");
        std::fs::write(folder.join("scan.xyz"), "# scan\n1 2 3 200\n\n4 5 nan 7\n8 9\n-1 0 5 1\n").unwrap();
        let [facts, said] = done(&folder, &["info", "scan.xyz"]);
        assert_eq!(
            facts,
            "2 points of a cloud in space\nXYZ\nx -1 .. 1, y 0 .. 2, z 3 .. 5\n\
             left out: 1 point with NaN, infinite or huge coordinates, in line 4\n\
             left out: 1 line with too few coordinates, in line 5\n"
        );
        assert_eq!(said, "");
        let [rows, said] = done(&folder, &["convert", "scan.xyz", "-", "--to", "csv"]);
        assert_eq!(rows, "x,y,z\n1,2,3\n-1,0,5\n");
        let lines: Vec<&str> = said.lines().collect();
        assert_eq!(lines.len(), 2, "{said}");
        assert!(
            lines[1] == "grafika: scan.xyz: left out: 1 line with too few coordinates, in line 5",
            "{said}"
        );
        std::fs::write(folder.join("wrong.obj"), "v 1 2 3\nv 1 2 three\n").unwrap();
        assert_eq!(
            refused(&folder, &["info", "wrong.obj"]),
            "grafika: wrong.obj: line 2, word 4: \"three\" is not a number\n"
        );
        std::fs::write(folder.join("empty.xyz"), "").unwrap();
        assert!(refused(&folder, &["info", "empty.xyz"]).contains("there is no table of points"));
        assert!(refused(&folder, &["sample", "scan.xyz"]).contains("no curve and no surface"));
    }

    #[test]
    fn clouds_become_each_other() {
        let folder = folder("convert");
        std::fs::write(folder.join("a.csv"), "id;x;y;z;w\n1;0,1;2;-3;9\n2;1e-9;5;6;9\n").unwrap();
        done(&folder, &["convert", "a.csv", "a.ply"]);
        done(&folder, &["convert", "a.ply", "a.obj"]);
        done(&folder, &["convert", "a.obj", "a.json"]);
        done(&folder, &["convert", "a.json", "a.xyz"]);
        assert_eq!(std::fs::read_to_string(folder.join("a.xyz")).unwrap(), "0.1 2 -3\n1e-9 5 6\n");
        done(&folder, &["convert", "a.xyz", "b.csv"]);
        assert_eq!(std::fs::read_to_string(folder.join("b.csv")).unwrap(), "x,y,z\n0.1,2,-3\n1e-9,5,6\n");
        let [facts, _] = done(&folder, &["info", "a.ply"]);
        assert!(facts.contains("PLY, binary, little-endian"), "{facts}");
        // Without a header a cloud passes over what stands behind the coordinates.
        std::fs::write(folder.join("rgb.csv"), "1,2,3,255,0,0\n4,5,6,255,0,0\n").unwrap();
        done(&folder, &["convert", "rgb.csv", "rgb.xyz"]);
        assert_eq!(std::fs::read_to_string(folder.join("rgb.xyz")).unwrap(), "1 2 3\n4 5 6\n");
        done(&folder, &["convert", "rgb.csv", "rgb.xyz", "--columns", "3,1"]);
        assert_eq!(std::fs::read_to_string(folder.join("rgb.xyz")).unwrap(), "3 1\n6 4\n");
        // Control points are points.
        let [_, said] = done(&folder, &["convert", "A.IC2", "ic2.xyz"]);
        assert!(said.contains("ic2.xyz has no place for: tangents"), "{said}");
        let [facts, _] = done(&folder, &["info", "ic2.xyz"]);
        assert!(facts.contains("in the plane"), "{facts}");
        done(&folder, &["convert", "ic2.xyz", "ic2.ip2"]);
        done(&folder, &["smooth", "ic2.xyz", "-o", "smooth.ply"]);
        assert_eq!(
            refused(&folder, &["convert", "a.ply", "a.stl"]),
            "grafika: a.ply as a.stl: does not fit into .STL: the points of a cloud; it holds triangles\n"
        );
        assert!(refused(&folder, &["convert", "A.ZMS", "net.ply"]).contains("net of a spline surface"));
        done(&folder, &["render", "A.ZMS", "-o", "net.stl"]);
        let [facts, _] = done(&folder, &["info", "net.stl"]);
        assert!(facts.contains("STL, binary"), "{facts}");
    }

    /// From a file row by row, from a pipe by way of memory.
    #[test]
    fn files_and_pipes_are_converted_to_the_same() {
        let folder = folder("rows");
        let mut text = String::from("id,x,y,z\n");
        // More than is read at a time, with a point that is left out.
        (0..30_000)
            .for_each(|k| writeln!(text, "{k},{},{},{}", k as f64 / 7.0, 1e-9 * k as f64, k % 5).unwrap());
        text.push_str("no,1,nan,3\n4,5,6,-0.0\n");
        std::fs::write(folder.join("rows.csv"), &text).unwrap();
        std::fs::write(folder.join("plane.csv"), text.replace(['1', '2', '3', '4'], "0")).unwrap();
        for name in ["rows", "plane"] {
            let csv = folder.join(format!("{name}.csv"));
            for format in ["xyz", "obj", "ply"] {
                let output = format!("{name}.{format}");
                let [_, said] = done(&folder, &["convert", &format!("{name}.csv"), &output]);
                assert!(said.contains("left out: 1 point"), "{said}");
                let piped = Command::new(env!("CARGO_BIN_EXE_grafika"))
                    .current_dir(&folder)
                    .args(["convert", "-", "piped", "--from", "csv", "--to", format])
                    .stdin(std::fs::File::open(&csv).unwrap())
                    .output()
                    .unwrap();
                assert_eq!(piped.status.code(), Some(0), "{piped:?}");
                let [file, piped] = [&output, "piped"].map(|name| std::fs::read(folder.join(name)).unwrap());
                assert!(file == piped, "{name} {format}");
            }
            // A cloud, once more as one and as JSON and CSV.
            for format in ["json", "csv"] {
                let [file, _] = done(&folder, &["convert", &format!("{name}.xyz"), "-", "--to", format]);
                let cloud = std::fs::read(folder.join(format!("{name}.xyz"))).unwrap();
                let cloud = grafika::file::Cloud::read(grafika::file::CloudFormat::Xyz, &cloud).unwrap();
                let kind = grafika::file::FileKind::from_extension(format).unwrap();
                let document = grafika::file::Document::Cloud(cloud);
                assert!(file.as_bytes() == document.encode(kind).unwrap(), "{name} {format}");
            }
        }
    }

    /// Who stops reading ends the command, without a word, also in the middle of many rows.
    #[test]
    fn readers_may_stop() {
        let folder = folder("stop");
        let text: String = (0..100_000).map(|k| format!("{k} {} 1\n", k % 7)).collect();
        std::fs::write(folder.join("a.xyz"), text).unwrap();
        std::fs::write(folder.join("p.csv"), "x,y\n0,1\n2,5\n4,-3\n").unwrap();
        for arguments in [
            &["convert", "a.xyz", "-", "--to", "csv"][..],
            &["sample", "p.csv", "--method", "spline", "--per-span", "200000"],
            &["render", "A.ZMS", "-o", "-", "--to", "obj", "--per-span", "60"],
        ] {
            let mut child = Command::new(env!("CARGO_BIN_EXE_grafika"))
                .current_dir(&folder)
                .args(arguments)
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap();
            let mut first = [0; 10];
            child.stdout.take().unwrap().read_exact(&mut first).unwrap();
            let output = child.wait_with_output().unwrap();
            let [_, said] = texts(output.clone());
            assert_eq!((output.status.code(), said.as_str()), (Some(0), ""), "{arguments:?}");
        }
    }

    #[test]
    fn large_files_and_streams_are_read() {
        let folder = folder("large");
        let row =
            "0.12345678901234 0.12345678901234 0.12345678901234 padding that no file of control points has\n";
        let rows = (65 << 20) / row.len();
        std::fs::write(folder.join("large.xyz"), row.repeat(rows)).unwrap();
        let [facts, _] = done(&folder, &["info", "large.xyz"]);
        assert!(facts.starts_with(&format!("{rows} points of a cloud in space\nXYZ\n")), "{facts}");
        // A table of this size is a cloud.
        std::fs::rename(folder.join("large.xyz"), folder.join("large.csv")).unwrap();
        let [facts, _] = done(&folder, &["info", "large.csv"]);
        assert!(facts.starts_with(&format!("{rows} points of a cloud")), "{facts}");
        std::fs::remove_dir_all(&folder).unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_grafika"))
            .args(["info", "-", "--from", "xyz"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let mut text = String::new();
        (0..1000).for_each(|k| writeln!(text, "{k} {} 1", k * k).unwrap());
        child.stdin.take().expect("it is piped").write_all(text.as_bytes()).expect("it reads");
        let facts = String::from_utf8(child.wait_with_output().expect("it ends").stdout).unwrap();
        assert_eq!(facts, "1000 points of a cloud in space\nXYZ\nx 0 .. 999, y 0 .. 998001, z 1 .. 1\n");
    }
}
