//! Surfaces against the meshes that the originals computed, in single precision.

use grafika::geometry::{Border, Method, ParamSurface, Patch, Point, Scheme, Surface, Topology};
use std::path::Path;

/// A mesh of the originals with the net and the parameters that it was made from.
struct Reference {
    net: Vec<Vec<Point<3>>>,
    /// b1u, b2u, b1v, b2v, k0u, k0v.
    parameters: [f64; 6],
    nodes: Vec<(usize, usize, Point<3>)>,
}

/// The text of a file packed by `gzip -n`, which writes ten bytes before the deflated text, and behind it
/// a check sum and the length.
fn unpacked(packed: &[u8]) -> Option<String> {
    let (head, rest) = packed.split_at_checked(10)?;
    let (deflated, tail) = rest.split_at_checked(rest.len().checked_sub(8)?)?;
    let text = miniz_oxide::inflate::decompress_to_vec(deflated).ok()?;
    let length = u32::from_le_bytes(tail[4..].try_into().ok()?);
    let is_whole = head[..4] == [0x1f, 0x8b, 8, 0] && text.len() == length as usize;
    is_whole.then(|| String::from_utf8(text).ok())?
}

fn reference(name: &str, [rows, columns]: [usize; 2]) -> Reference {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/surfaces/grids").join(name);
    let packed = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let text = unpacked(&packed).unwrap_or_else(|| panic!("{}: not packed by gzip -n", path.display()));
    let mut reference =
        Reference { net: vec![vec![[0.0; 3]; columns]; rows], parameters: [0.0; 6], nodes: Vec::new() };
    for line in text.lines() {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |index: usize| fields[index].parse::<f64>().unwrap();
        match fields[0] {
            "A" | "R" => {
                let (k, l) = (number(1) as usize, number(2) as usize);
                let point = [number(3), number(4), number(5)];
                if fields[0] == "R" {
                    reference.nodes.push((k, l, point));
                } else if k < rows && l < columns {
                    reference.net[k][l] = point;
                }
            }
            "P" => reference.parameters = std::array::from_fn(|index| number(index + 1)),
            _ => {}
        }
    }
    reference
}

#[test]
fn meshes_are_those_of_the_originals() {
    let beta = |p: &[f64; 6]| {
        [Method::Beta { bias: p[0], tension: p[1] }, Method::Beta { bias: p[2], tension: p[3] }]
    };
    let local = |p: &[f64; 6]| [Method::Local { k0: p[4] }, Method::Local { k0: p[5] }];
    type Methods<'a> = &'a dyn Fn(&[f64; 6]) -> [Method; 2];
    let plain = |method: Method| move |_: &[f64; 6]| [method; 2];
    let (spline, bezier) = (plain(Method::Spline), plain(Method::Bezier));
    let (quadratic, cubic) = (plain(Method::BSpline2), plain(Method::BSpline3));
    use Topology::{Open, Sphere, Torus};
    let cases: [(&str, [usize; 2], usize, Topology, Methods<'_>); 28] = [
        ("F_P_SPLN_default", [5, 5], 12, Open, &spline),
        ("F_P_SPLN_edited", [5, 5], 12, Open, &spline),
        ("F_EM_SPL_default", [8, 5], 12, Open, &spline),
        ("F_EM_SPL_edited", [8, 5], 12, Open, &spline),
        ("F_P_BEZR_default", [4, 4], 16, Open, &bezier),
        ("F_P_BEZR_edited", [4, 4], 16, Open, &bezier),
        ("F_P_BSPL_fok2_default", [5, 5], 12, Open, &quadratic),
        ("F_P_BSPL_fok3_default", [5, 5], 12, Open, &cubic),
        ("F_P_BETSX_default", [5, 5], 10, Open, &beta),
        ("F_P_BETSX_edited", [5, 5], 10, Open, &beta),
        ("F_P_HSPL_default", [5, 5], 10, Open, &local),
        ("F_P_HSPL_edited", [5, 5], 10, Open, &local),
        ("ZM_SPLNX_default", [8, 5], 10, Sphere, &spline),
        ("ZM_SPLNX_edited", [8, 5], 10, Sphere, &spline),
        ("ZM_BSPL_fok2_default", [8, 5], 10, Sphere, &quadratic),
        ("ZM_BSPL_fok3_default", [8, 5], 10, Sphere, &cubic),
        ("ZM_HSPLX_default", [8, 5], 10, Sphere, &local),
        ("ZM_HSPLX_edited", [8, 5], 10, Sphere, &local),
        ("ZM_BETSPX_default", [8, 5], 10, Sphere, &beta),
        ("ZM_BETSPX_edited", [8, 5], 10, Sphere, &beta),
        ("ZY_SPLNX_default", [8, 5], 10, Torus, &spline),
        ("ZY_SPLNX_edited", [8, 5], 10, Torus, &spline),
        ("ZY_BSPL_fok2_default", [8, 5], 10, Torus, &quadratic),
        ("ZY_BSPL_fok3_default", [8, 5], 10, Torus, &cubic),
        ("ZY_HSPL_default", [8, 5], 10, Torus, &local),
        ("ZY_HSPL_edited", [8, 5], 10, Torus, &local),
        ("ZY_BETSP_default", [8, 5], 10, Torus, &beta),
        ("ZY_BETSP_edited", [8, 5], 10, Torus, &beta),
    ];
    for (name, shape, steps, topology, methods) in cases {
        let reference = reference(&format!("{name}.csv.gz"), shape);
        let [u, v] = methods(&reference.parameters);
        let surface =
            Surface::new(Scheme { u, v, topology, border: Border::Doubled }, &reference.net).unwrap();
        check(name, &surface, steps, &reference);
    }
}

#[test]
fn hermite_patches_are_those_of_the_original() {
    for name in ["F_P_HERM_default", "F_P_HERM_edited"] {
        let reference = reference(&format!("{name}.csv.gz"), [4, 4]);
        let matrix = std::array::from_fn(|r| std::array::from_fn(|c| reference.net[r][c]));
        check(name, &Surface::hermite(&matrix).unwrap(), 16, &reference);
        assert_eq!(Patch::from_hermite(&matrix).eval(1.0, 0.0), matrix[1][0]);
    }
}

fn check(name: &str, surface: &Surface, steps: usize, reference: &Reference) {
    let grid = surface.grid(steps).unwrap();
    let mut worst = (0.0, 0, 0);
    assert_eq!(reference.nodes.len(), grid.points().len(), "{name}");
    for &(k, l, theirs) in &reference.nodes {
        let ours = grid.point(k, l).unwrap_or_else(|| panic!("{name}: no node {k}, {l}"));
        for (a, b) in ours.iter().zip(theirs) {
            if (a - b).abs() > worst.0 {
                worst = ((a - b).abs(), k, l);
            }
        }
    }
    println!("{name}: {worst:?}");
    // The originals' singles; their spline's elimination loses digits.
    let tolerance = if name.contains("SPLN") { 0.02 } else { 2e-4 };
    assert!(worst.0 < tolerance, "{name}: off by {worst:?}");
}
