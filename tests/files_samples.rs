//! The sample files in `data/` are those that `examples/make_samples.rs` makes.

#[allow(dead_code, reason = "its main function")]
#[path = "../examples/make_samples.rs"]
mod make_samples;

use grafika::file::{Document, FileKind, Net, NetKind};
use grafika::geometry::View;
use std::path::Path;

#[test]
fn the_samples_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let samples = make_samples::samples().unwrap();
    assert_eq!(samples.len(), grafika::machine::SAMPLES.len());
    for (name, bytes) in samples {
        let found = std::fs::read(folder.join(name)).unwrap();
        assert!(found == bytes, "{name}: run `cargo run --example make_samples`");
        let format = match FileKind::from_name(name) {
            Some(FileKind::Dos(format)) => format,
            Some(FileKind::Json) => {
                let document = Document::decode(FileKind::Json, &bytes).unwrap();
                assert_eq!(document.encode(FileKind::Json), Ok(bytes));
                continue;
            }
            other => panic!("{name}: {other:?}"),
        };
        let document = Document::read(format, &bytes).unwrap();
        assert_eq!(document.write(format), Ok(bytes));
    }
}

type Point = [f64; 3];

/// The sample nets of some kinds, as they are read.
fn nets(kinds: &[NetKind]) -> Vec<(&'static str, Net)> {
    let read = |(name, bytes): &(&'static str, Vec<u8>)| match FileKind::from_name(name) {
        Some(FileKind::Dos(format)) => match Document::read(format, bytes) {
            Ok(Document::Net(net)) if kinds.contains(&net.kind) => Some((*name, net)),
            _ => None,
        },
        _ => None,
    };
    make_samples::samples().unwrap().iter().filter_map(read).collect()
}

/// Whether all points of a body lie where a function of them is 1.
fn on_the_surface(net: &Net, norm: impl Fn(Point) -> f64) -> bool {
    net.points.iter().flatten().all(|&point| (norm(point) - 1.0).abs() < 1e-6)
}

#[test]
fn nets_are_whole_in_the_first_picture() {
    let view = View::from_direction([0.3, -0.7, 0.2]);
    let found = nets(&NetKind::ALL);
    assert_eq!(found.len(), 22);
    for (name, net) in found {
        // The rest of the matrix of a Hermite patch is vectors.
        let count = if net.kind == NetKind::Fhc { 2 } else { 8 };
        for point in net.points.iter().take(count).flat_map(|row| row.iter().take(count)) {
            let [right, down] = view.pixel(*point, 1.0);
            assert!((31.0..631.0).contains(&right) && (60.0..460.0).contains(&down), "{name}: {point:?}");
        }
    }
}

#[test]
fn poles_are_one_point() {
    for (name, net) in nets(&[NetKind::Zms, NetKind::Zmb]) {
        for l in [0, 4] {
            assert!(net.points.iter().all(|row| row[l] == net.points[0][l]), "{name}");
        }
    }
}

#[test]
fn control_points_of_the_solids_lie_on_them() {
    let largest = |point: Point| point.map(f64::abs).into_iter().fold(0.0, f64::max);
    let on_a_face = |point: Point| largest(point) / 100.0;
    // The same cube turned by 45 degrees about y.
    let on_an_edge = |[x, y, z]: Point| {
        let half = f64::sqrt(0.5);
        on_a_face([(x - z) * half, y, (x + z) * half])
    };
    let octahedron = |point: Point| point.map(f64::abs).iter().sum::<f64>() / 150.0;
    for (name, net) in nets(&[NetKind::Zms, NetKind::Zmb]) {
        match &name[..2] {
            "K1" => assert!(on_the_surface(&net, on_an_edge), "{name}"),
            "K2" => assert!(on_the_surface(&net, on_a_face), "{name}"),
            "K3" => assert!(on_the_surface(&net, octahedron), "{name}"),
            _ => {}
        }
    }
}
