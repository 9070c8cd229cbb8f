//! The nets of PN_FELUL: points of known surfaces with their normals.

use grafika::file::{Document, FileError, Format, Net, NetKind};

type Point = [f64; 3];

/// A point and its normal by two parameters.
type Form = fn(f64, f64) -> (Point, Point);

/// Points along u and v.
const COUNT: usize = 4;

/// Every net: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let nets: [(&str, Form); 4] = [("G.PN", cap), ("P.PN", vault), ("N.PN", saddle), ("Y.PN", torus)];
    nets.into_iter().map(|(name, surface)| Ok((name, net(surface).write(Format::Pn)?))).collect()
}

/// The net of a surface given by parameters from -1 to 1: point, and normal of any length. Rounded, so that the last
/// bits of a tangent do not matter.
fn net(surface: Form) -> Document {
    let place = |k: usize| 2.0 * k as f64 / (COUNT - 1) as f64 - 1.0;
    let rounded = |point: Point| point.map(|x| (x * 1e12).round() / 1e12 + 0.0);
    let row = |value: &dyn Fn(f64, f64) -> Point, k: usize| -> Vec<Point> {
        (0..COUNT).map(|l| rounded(value(place(k), place(l)))).collect()
    };
    let rows = |value: &dyn Fn(f64, f64) -> Point| (0..COUNT).map(|k| row(value, k)).collect();
    let mut net = Net::new(NetKind::Pn, rows(&|s, t| surface(s, t).0));
    net.normals = Some(rows(&|s, t| unit(surface(s, t).1)));
    Document::Net(net)
}

fn unit(normal: Point) -> Point {
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    normal.map(|x| x / length)
}

/// A cap of the sphere round (2, -1, 3) with the radius 30.
fn cap(s: f64, t: f64) -> (Point, Point) {
    let normal = [(0.7 * s).tan(), (0.7 * t).tan(), -1.0];
    let [x, y, z] = unit(normal);
    ([2.0 + 30.0 * x, -1.0 + 30.0 * y, 3.0 + 30.0 * z], normal)
}

/// The graph of a x² + b y², with normals that point down.
fn graph([x, y]: [f64; 2], [a, b]: [f64; 2]) -> (Point, Point) {
    ([x, y, a * x * x + b * y * y], [2.0 * a * x, 2.0 * b * y, -1.0])
}

/// A vault, upside down.
fn vault(s: f64, t: f64) -> (Point, Point) {
    graph([20.0 * s, 15.0 * t], [0.01, 0.025])
}

/// A saddle.
fn saddle(s: f64, t: f64) -> (Point, Point) {
    graph([2.0 * s, 2.0 * t], [0.15, -0.1])
}

/// A piece of the outside of a torus of the radii 60 and 25.
fn torus(s: f64, t: f64) -> (Point, Point) {
    let (around, up) = ((0.6 * s).sin_cos(), (0.6 * t).sin_cos());
    let normal = [up.1 * around.1, up.1 * around.0, up.0];
    ([60.0 * around.1 + 25.0 * normal[0], 60.0 * around.0 + 25.0 * normal[1], 25.0 * normal[2]], normal)
}
