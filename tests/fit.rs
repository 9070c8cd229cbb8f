//! Nets and surfaces from clouds on the command line: `fit`.

#![cfg(feature = "native")]

mod common;

use common::folder::Folder;
use grafika::file::{Document, Format};
use grafika::geometry::Point;
use grafika::geometry::cloud::{Cloud, CloudShape};
use grafika::geometry::kohonen::{Learning, Net, Rule, Topology};

/// The net in a file.
fn net(folder: &Folder, name: &str) -> (Topology, Vec<Vec<Point<3>>>) {
    match Document::read(Format::Som, &folder.bytes(name)) {
        Ok(Document::Som(net)) => (net.topology, net.points),
        other => panic!("{name}: {other:?}"),
    }
}

/// What a command says that does its work.
#[track_caller]
fn told(folder: &Folder, line: &str) -> String {
    let [_, said] = folder.done_saying(line);
    said
}

/// The cloud of a built-in sample.
fn sample(name: &str) -> Cloud {
    let document = Document::read(Format::Xyz, grafika::machine::sample(name).unwrap()).unwrap();
    let Document::Cloud(cloud) = document else { panic!("{name} is a cloud") };
    Cloud::new(cloud.points).unwrap()
}

#[test]
fn the_net_is_that_of_the_library() {
    let folder = Folder::new();
    let said = told(&folder, "fit NYEREG.XYZ -o net.som --grid 8x9 --seed 3");
    assert!(said.contains("8 x 9 neurons after 7200 steps, RMS "), "{said}");
    let cloud = sample("NYEREG.XYZ");
    let start = Net::random(&cloud, [8, 9], Topology::Open, 3).unwrap();
    let rule = Rule { order: grafika::geometry::kohonen::Order::Random(3), ..Rule::default() };
    let mut learning = Learning::new(&cloud, start, rule).unwrap();
    while learning.advance(77).is_none() {}
    assert_eq!(net(&folder, "net.som"), (Topology::Open, learning.net().rows()));
    // The same again, and another one by another seed.
    told(&folder, "fit NYEREG.XYZ -o again.som --grid 8x9 --seed 3");
    assert_eq!(folder.bytes("again.som"), folder.bytes("net.som"));
    told(&folder, "fit NYEREG.XYZ -o other.som --grid 8x9 --seed 4");
    assert_ne!(folder.bytes("other.som"), folder.bytes("net.som"));
}

#[test]
fn surfaces_are_written_in_every_form() {
    let folder = Folder::new();
    let said = told(&folder, "fit FELGOMB.XYZ -o a.csf --grid 12x12 --residuals r.csv");
    assert!(said.contains("2000 points, RMS 0.0") && said.contains("RMS by solution"), "{said}");
    let Ok(Document::KnotNet(net)) = Document::read(Format::Csf, &folder.bytes("a.csf")) else {
        panic!("a.csf is a surface")
    };
    assert_eq!((net.order, net.points.len(), net.points[0].len()), ([4, 4], 12, 12));
    // Points of the surface are on the sphere, within the noise.
    let surface = net.surface().unwrap();
    for k in 0..=10 {
        for l in 0..=10 {
            let point = surface.point_at([f64::from(k) / 10.0, f64::from(l) / 10.0]).unwrap();
            assert!(CloudShape::Hemisphere.distance(point) < 0.08, "{point:?}");
        }
    }
    let residuals = String::from_utf8(folder.bytes("r.csv")).unwrap();
    let mut lines = residuals.lines();
    assert_eq!(lines.next(), Some("x,y,z,distance"));
    let distances: Vec<f64> = lines.map(|line| line.rsplit(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(distances.len(), 2000);
    let rms = (distances.iter().map(|d| d * d).sum::<f64>() / 2000.0).sqrt();
    assert!((0.015..0.023).contains(&rms), "{rms}");
    let starts: [(&str, &[u8]); 4] =
        [("step", b"ISO-10303-21;"), ("stl", b""), ("obj", b""), ("ply", b"ply")];
    for (extension, start) in starts {
        told(&folder, &format!("fit NYEREG.XYZ -o b.{extension} --grid 6x6"));
        let bytes = folder.bytes(&format!("b.{extension}"));
        assert!(bytes.len() > 1000 && bytes.starts_with(start), "{extension}");
    }
    told(&folder, "fit NYEREG.XYZ -o c.json --grid 6x6 --corrections 2");
    let json = String::from_utf8(folder.bytes("c.json")).unwrap();
    assert!(json.contains("CSF"), "{json}");
}

#[test]
fn polygons_become_curves() {
    let folder = Folder::new();
    told(&folder, "fit NYOM.XYZ -o s.som --grid 40x1");
    assert_eq!(net(&folder, "s.som").1.len(), 40);
    told(&folder, "fit NYOM.XYZ -o s.csm --grid 40x1");
    assert!(matches!(Document::read(Format::Csm, &folder.bytes("s.csm")), Ok(Document::Knots(_))));
    for (line, right) in [
        ("fit NYOM.XYZ -o s.step --grid 40x1", ".csm"),
        ("fit NYOM.XYZ -o s.csf --grid 40x1", ".csm"),
        ("fit NYEREG.XYZ -o s.csm --grid 6x6", ".csf"),
    ] {
        let said = folder.refused(2, line);
        assert!(said.contains(right), "{said}");
    }
}

#[test]
fn topologies_and_growth() {
    let folder = Folder::new();
    told(&folder, "fit TORUSZ.XYZ -o t.som --grid 10x16 --topology torus");
    assert_eq!(net(&folder, "t.som").0, Topology::Torus);
    told(&folder, "fit TEREP.XYZ -o g.som --grow 36");
    let rows = net(&folder, "g.som").1;
    assert!((24..=36).contains(&(rows.len() * rows[0].len())), "{} x {}", rows.len(), rows[0].len());
}

#[test]
fn points_in_their_order_from_a_net() {
    let folder = Folder::new();
    folder.write("start.som", r#"{"format":"SOM","topology":"open","points":[[[0,0,0]],[[1,0,0]]]}"#);
    folder.write("one.xyz", "0.25 0 1\n");
    told(&folder, "fit one.xyz -o end.som --initial start.som --order file");
    // One step with the gain 0.5 and the radius 1: the winner goes half way, its neighbour exp(-1/2) of that.
    let (_, rows) = net(&folder, "end.som");
    let share = 0.5 * (-0.5_f64).exp();
    let expected = [[0.125, 0.0, 0.5], [1.0 - 0.75 * share, 0.0, share]];
    for (found, expected) in rows.concat().iter().zip(expected) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {expected:?}");
    }
}

#[test]
fn what_is_wrong_is_said_in_a_line() {
    let folder = Folder::new();
    folder.write("few.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 1\n");
    folder.write("empty.xyz", "# nothing\n");
    folder.write("bad.xyz", "1 2 3\n1 two 3\n");
    folder.write("nan.xyz", "1 2 3\nnan 2 3\n4 5\n2 2 2\n0 1 0\n");
    for (status, line, told) in [
        (1, "fit few.xyz -o a.csf --grid 4x4", "take a smaller net"),
        (1, "fit empty.xyz -o a.som", "no table of points"),
        (1, "fit bad.xyz -o a.som", "line 2"),
        (1, "fit none.xyz -o a.som", "no such file"),
        (1, "fit NYEREG.XYZ -o a.csf --grid 3x3", "at least 4 rows"),
        (1, "fit NYEREG.XYZ -o a.som --grid 0x5", "not possible"),
        (1, "fit NYEREG.XYZ -o a.som --initial NYEREG.XYZ", ".som"),
        (1, "fit A.CSK -o a.som", "cloud of points"),
        (2, "fit NYEREG.XYZ -o a.png", "not .png"),
        (2, "fit NYEREG.XYZ -o a.som --corrections 3", ".som"),
        (2, "fit NYEREG.XYZ -o a.som --grid 5", "20x20"),
        (2, "fit NYEREG.XYZ -o a.som --topology ball", "sphere"),
    ] {
        let said = folder.refused(status, line);
        assert!(said.contains(told), "{line}: {said}");
    }
    let said = told(&folder, "fit nan.xyz -o a.som --grid 2x1");
    assert!(said.contains("1 point with NaN") && said.contains("line 3"), "{said}");
}
