//! What `docs/methods.md` says about smoothness is true: every row of its tables is checked on random points, by the
//! derivatives on both sides of every joint.

use grafika::design::{Design, Shape};
use grafika::file::{Document, FileKind, Format};
use grafika::geometry::{
    Derivatives, ParamCurve, ParamSurface, Point, SpanContact, contact, cross, dot, norm,
};
use proptest::prelude::*;
use std::fmt;

/// What a row says.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Claim {
    /// Derivatives up to an order agree.
    C(u8),
    /// Direction, or direction and curvature, agree.
    G(u8),
    /// There is nothing to join: one arc or patch.
    One,
}

impl Claim {
    fn holds(self, contact: SpanContact) -> bool {
        match self {
            Claim::C(order) => contact.parametric.is_some_and(|found| found >= order),
            Claim::G(order) => contact.geometric.is_some_and(|found| found >= order),
            Claim::One => false,
        }
    }
}

type Points = Vec<[f64; 2]>;

/// A kind of curve: the row of the table, what stands in its column, what that means, and its files as JSON.
type Row = (&'static str, &'static str, Claim, fn(&Points) -> Vec<String>);

fn list(points: &Points) -> String {
    serde_json::to_string(points).expect("numbers are written")
}

fn named(points: &Points, method: &str, more: &str) -> Vec<String> {
    let of = |closed| {
        format!(
            r#"{{"format":"IP2","points":{},"settings":{{"method":"{method}","closed":{closed}{more}}}}}"#,
            list(points)
        )
    };
    vec![of(false), of(true)]
}

fn shaped(points: &Points, family: &str, parameters: &str) -> Vec<String> {
    let of = |closed| {
        format!(
            r#"{{"format":"ALP","family":"{family}","closed":{closed},{parameters}"points":{}}}"#,
            list(points)
        )
    };
    vec![of(false), of(true)]
}

fn tangents(points: &Points) -> String {
    list(&points.iter().map(|[x, y]| [y - 130.0, 170.0 - x]).collect())
}

const CURVES: [Row; 22] = [
    ("Fourier", "all derivatives", Claim::C(2), |points| {
        let row = |axis: usize, part: f64| {
            let mut row = vec![0.0; 21];
            row.iter_mut().zip(points).for_each(|(value, point)| *value = point[axis] / part);
            row
        };
        let [a, p, b, q] = [row(0, 9.0), row(1, 300.0), row(1, 9.0), row(0, 300.0)];
        vec![serde_json::json!({"format": "GBP", "a": a, "p": p, "b": b, "q": q}).to_string()]
    }),
    ("Coons, Hermite", "C1", Claim::C(1), |points| {
        let of = |closed| {
            format!(
                r#"{{"format":"IC2","points":{},"tangents":{},"settings":{{"closed":{closed}}}}}"#,
                list(points),
                tangents(points)
            )
        };
        vec![of(false), of(true)]
    }),
    ("local spline, Overhauser", "C1", Claim::C(1), |points| named(points, "coons", r#","k0":0.7"#)),
    ("spline", "C2", Claim::C(2), |points| named(points, "spline", "")),
    ("Bézier", "all derivatives, one arc", Claim::One, |points| named(points, "bezier", "")[..1].to_vec()),
    ("Bézier arcs", "G1 in smooth joints, else corners", Claim::G(1), |p| {
        let along = [0, 1].map(|d| (p[4][d] - p[0][d]) / 6.0);
        let beside = |part: f64| [0, 1].map(|d| p[2][d] + part * along[d]);
        let points = vec![p[0], p[1], beside(-1.0), p[2], beside(1.7), p[3], p[4]];
        vec![format!(
            r#"{{"format":"IP2","points":{},"settings":{{"method":"arcs","smooth":[4]}}}}"#,
            list(&points)
        )]
    }),
    ("B-spline, degree 2", "C1", Claim::C(1), |points| named(points, "bspline2", "")),
    ("B-spline, degree 3", "C2", Claim::C(2), |points| named(points, "bspline3", "")),
    ("B-spline, degree 1 to 5", "C(degree - 1) at single knots", Claim::C(2), |points| {
        [3, 4, 5]
            .iter()
            .flat_map(|degree| named(points, "bspline", &format!(r#","degree":{degree}"#)))
            .collect()
    }),
    ("beta-spline", "G2", Claim::G(2), |points| named(points, "beta", r#","bias":1.7,"tension":3"#)),
    ("EC curves", "all derivatives in an arc", Claim::One, |points| {
        let points: Vec<[f64; 3]> = points[..4].iter().map(|[x, y]| [*x, *y, 0.0]).collect();
        let points = serde_json::to_string(&points).expect("numbers are written");
        vec![format!(
            r#"{{"format":"kcg","roots":[{{"re":0,"multiplicity":2}},{{"re":0,"im":1}}],"interval":[0,1.5],"points":{points}}}"#
        )]
    }),
    // Knots by chords: the parameter of a span is not that of the curve.
    ("PH spline", "C2", Claim::G(2), |points| named(points, "phspline", "")),
    ("PH quintics, PH cubics", "C1, G1", Claim::C(1), |points| {
        let way = |[x, y]: [f64; 2]| [x * 0.8 + 20.0, y * 0.7];
        let tangents: Points = points.iter().map(|point| way(*point)).collect();
        vec![format!(
            r#"{{"format":"IC2","points":{},"tangents":{},"settings":{{"method":"phhermite"}}}}"#,
            list(points),
            list(&tangents)
        )]
    }),
    ("B-spline, NURBS by knots", "C(k-2) at single knots", Claim::C(2), |points| {
        vec![format!(
            r#"{{"format":"CSM","order":4,"points":{},"knots":[0,1,2,3,4,5,6,7,8,9]}}"#,
            list(points)
        )]
    }),
    ("C- and F-Bézier", "all derivatives, one arc", Claim::One, |points| {
        let four = points[..4].to_vec();
        ["c-bezier", "f-bezier"]
            .iter()
            .flat_map(|family| {
                let parameter = if *family == "c-bezier" { r#""alpha":1.3,"# } else { r#""omega":2,"# };
                shaped(&four, family, parameter)[..1].to_vec()
            })
            .collect()
    }),
    ("C- and F-B-spline", "C2", Claim::C(2), |points| {
        [shaped(points, "c-bspline", r#""alpha":1.3,"#), shaped(points, "f-bspline", r#""omega":-3,"#)]
            .concat()
    }),
    ("trigonometric Bézier", "one arc", Claim::One, |points| {
        shaped(&points[..5].to_vec(), "trig-bezier", r#""n1":2,"n2":2,"alpha":2.5,"beta":2.5,"#)[..1].to_vec()
    }),
    ("Han", "C2", Claim::C(2), |points| shaped(points, "han", r#""lambda":0.6,"#)),
    ("alpha, GB, SPB", "C2", Claim::C(2), |points| {
        ["alpha", "gb", "spb"].iter().flat_map(|family| shaped(points, family, r#""lambda":0.4,"#)).collect()
    }),
    ("Han's quadratic", "C1", Claim::C(1), |points| shaped(points, "han-quadratic", r#""lambda":0.4,"#)),
    ("cyclic", "all derivatives", Claim::C(2), |points| {
        vec![format!(r#"{{"format":"ALP","family":"cyclic","points":{}}}"#, list(&points[..5].to_vec()))]
    }),
    ("skins", "G1", Claim::G(1), |points| {
        // Circles in a row that do not swallow each other.
        let circles: Vec<[f64; 3]> = points
            .iter()
            .zip(0..)
            .map(|(point, k)| [60.0 + 85.0 * f64::from(k), 150.0 + point[1] / 8.0, 22.0 + point[0] / 60.0])
            .collect();
        let circles = serde_json::to_string(&circles).expect("numbers are written");
        vec![format!(r#"{{"format":"KOR","circles":{circles}}}"#)]
    }),
];

/// The rows of the table with a heading: the text of a row, without its link, and of its column `smooth`.
fn table(heading: &str) -> Vec<(String, String)> {
    let page = include_str!("../docs/methods.md");
    let mut lines = page.lines().skip_while(|line| !line.starts_with(heading));
    let titles: Vec<&str> = lines.next().expect("there is such a table").split('|').map(str::trim).collect();
    let smooth = titles.iter().position(|title| *title == "smooth").expect("it has the column");
    let row = |line: &str| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let (text, rest) = cells[1].trim_start_matches('[').split_once(']').expect("it is a link");
        let behind = rest.split_once(')').expect("it is a link").1;
        (format!("{text}{behind}"), cells[smooth].to_owned())
    };
    lines.skip(1).take_while(|line| line.starts_with('|')).map(row).collect()
}

/// The shape of a file, if its points have one.
fn shape(text: &str) -> Result<Shape, TestCaseError> {
    let document = Document::decode(FileKind::Json, text.as_bytes())
        .map_err(|error| TestCaseError::fail(format!("{error}: {text}")))?;
    let shape = Design::of_document(document).and_then(|design| design.shape());
    shape.map_err(|error| TestCaseError::reject(error.to_string()))
}

fn check<const D: usize>(curve: &dyn ParamCurve<D>, claim: Claim, text: &str) -> Result<(), TestCaseError> {
    if claim == Claim::One {
        prop_assert_eq!(curve.spans(), 1, "{}", text);
        return Ok(());
    }
    let joints = (0..curve.spans()).filter_map(|joint| Some((joint, contact(curve, joint)?)));
    for (joint, found) in joints {
        prop_assert!(claim.holds(found), "{found} at joint {joint}, not {claim:?}: {text}");
    }
    Ok(())
}

fn points() -> impl Strategy<Value = Points> {
    // Neighbours are apart, so that no span is a point.
    let steps = prop::collection::vec((30.0..70.0f64, -90.0..90.0f64), 6);
    steps.prop_map(|steps| {
        let mut x = 40.0;
        let place = |(step, y): (f64, f64)| {
            x += step;
            [x, 190.0 + y]
        };
        steps.into_iter().map(place).collect()
    })
}

#[test]
fn every_row_of_the_tables_is_checked() {
    let rows: Vec<(String, String)> =
        CURVES.iter().map(|(row, column, ..)| (row.to_string(), column.to_string())).collect();
    assert_eq!(table("| method | points |"), rows);
    let rows: Vec<(String, String)> =
        SURFACES.iter().map(|(row, column, ..)| (row.to_string(), column.to_string())).collect();
    assert_eq!(table("| surface | points |"), rows);
}

#[test]
fn a_curve_that_is_less_smooth_is_found() {
    let points = vec![[0.0, 0.0], [60.0, 90.0], [120.0, 0.0], [190.0, 50.0], [260.0, 0.0], [300.0, 80.0]];
    let Ok(Shape::Plane(curve)) = shape(&named(&points, "coons", "")[0]) else { panic!("it is a curve") };
    assert!(check(&*curve, Claim::C(1), "").is_ok() && check(&*curve, Claim::C(2), "").is_err());
    let Ok(Shape::Plane(curve)) = shape(&named(&points, "beta", r#","bias":3,"tension":1"#)[0]) else {
        panic!("it is a curve")
    };
    assert!(check(&*curve, Claim::G(2), "").is_ok() && check(&*curve, Claim::C(1), "").is_err());
}

/// A net, with sphere-like nets between poles.
type Net = [[Point<3>; 6]; 6];

/// A kind of surface, as [`Row`].
type SurfaceRow = (&'static str, &'static str, Claim, fn(&Net) -> Vec<Box<dyn ParamSurface>>);

/// The surface of a net in a format, by a method.
fn net(net: &Net, format: Format, method: &str) -> Box<dyn ParamSurface> {
    let mut points: Vec<Vec<Point<3>>> = net.iter().map(|row| row.to_vec()).collect();
    if matches!(format, Format::Zms | Format::Zmb) {
        // Round a ball: rows are meridians between common poles.
        for (k, row) in points.iter_mut().enumerate() {
            let around = k as f64 / 6.0 * std::f64::consts::TAU;
            for (l, point) in row.iter_mut().enumerate() {
                let down = l as f64 / 5.0 * std::f64::consts::PI;
                let radius = 100.0 + point[2] / 4.0;
                *point = [
                    radius * down.sin() * around.cos(),
                    radius * down.sin() * around.sin(),
                    radius * down.cos(),
                ];
            }
            row[0] = [0.0, 0.0, 110.0];
            row[5] = [0.0, 0.0, -110.0];
        }
    }
    if matches!(format, Format::Zys | Format::Zyb) {
        for (k, row) in points.iter_mut().enumerate() {
            let around = k as f64 / 6.0 * std::f64::consts::TAU;
            for (l, point) in row.iter_mut().enumerate() {
                let round = l as f64 / 6.0 * std::f64::consts::TAU;
                let (tube, ring) = (40.0 + point[2] / 8.0, 120.0);
                let far = ring + tube * round.cos();
                *point = [far * around.cos(), far * around.sin(), tube * round.sin()];
            }
        }
    }
    let points = serde_json::to_string(&points).expect("numbers are written");
    let text = format!(
        r#"{{"format":"{}","points":{points},"settings":{{"method":"{method}","bias":[1.5,1],"tension":[2,4],"k0":[0.6,0.4]}}}}"#,
        format.extension()
    );
    match shape(&text) {
        Ok(Shape::Surface(surface)) => surface,
        other => panic!("{other:?}: {text}"),
    }
}

fn nets(points: &Net, formats: [Format; 3], methods: &[&str]) -> Vec<Box<dyn ParamSurface>> {
    let each = |method: &&str| formats.map(|format| net(points, format, method));
    methods.iter().flat_map(each).collect()
}

const SPLINES: [Format; 3] = [Format::Fps, Format::Zms, Format::Zys];
const B_SPLINES: [Format; 3] = [Format::Fbs, Format::Zmb, Format::Zyb];

const SURFACES: [SurfaceRow; 8] = [
    ("Hermite patch", "one patch", Claim::One, |_| Vec::new()),
    ("spline", "C2", Claim::C(2), |points| nets(points, SPLINES, &["spline"])),
    ("local spline", "C1", Claim::C(1), |points| nets(points, SPLINES, &["local"])),
    ("Bézier patch", "one patch", Claim::One, |points| vec![net(points, Format::Fpb, "bezier")]),
    // The end spans of degree 2 are half as long (3.32): their parameter runs at half the speed.
    ("B-spline", "C1, C2", Claim::G(1), |points| nets(points, B_SPLINES, &["bspline2", "bspline3"])),
    ("beta-spline", "G2 along the lines", Claim::G(2), |points| nets(points, B_SPLINES, &["beta"])),
    ("PN", "G1", Claim::G(1), |points| {
        let heights: Vec<Vec<Point<3>>> = (points.iter().zip(0..))
            .map(|(row, k)| {
                let place = |(point, l): (&Point<3>, i32)| {
                    let (x, y) = (20.0 * f64::from(k) - 40.0, 20.0 * f64::from(l) - 50.0);
                    [x, y, (x * x + 0.7 * y * y) / 60.0 + point[2] / 200.0]
                };
                row.iter().zip(0..).map(place).collect()
            })
            .collect();
        let heights = serde_json::to_string(&heights).expect("numbers are written");
        match shape(&format!(r#"{{"format":"PN","points":{heights}}}"#)) {
            Ok(Shape::Surface(surface)) => vec![surface],
            _ => Vec::new(),
        }
    }),
    ("fitted", "C2", Claim::C(2), |points| {
        let net = serde_json::to_string(points).expect("numbers are written");
        let text = format!(
            r#"{{"format":"CSF","order":[4,4],"knots":[[0,1,2,3,4,5,6,7,8,9],[0,1,2,3,4,5,6,7,8,9]],"points":{net}}}"#
        );
        match shape(&text) {
            Ok(Shape::Surface(surface)) => vec![surface],
            other => panic!("{other:?}"),
        }
    }),
];

/// The line of a surface along one direction, as a curve.
struct Line<'s> {
    surface: &'s dyn ParamSurface,
    along: usize,
    /// The span and the parameter of the other direction.
    across: (usize, f64),
}

impl fmt::Debug for Line<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a line along {}", self.along)
    }
}

impl Line<'_> {
    fn jet(&self, span: usize, u: f64) -> Option<Derivatives> {
        match self.along {
            0 => self.surface.at([span, self.across.0], [u, self.across.1]),
            _ => self.surface.at([self.across.0, span], [self.across.1, u]),
        }
    }
}

impl ParamCurve<3> for Line<'_> {
    fn spans(&self) -> usize {
        self.surface.spans()[self.along]
    }

    fn closed(&self) -> bool {
        self.surface.closed()[self.along]
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<3>; 3]> {
        let jet = self.jet(span, u)?;
        Some(if self.along == 0 { [jet.point, jet.u, jet.uu] } else { [jet.point, jet.v, jet.vv] })
    }
}

fn check_surface(surface: &dyn ParamSurface, claim: Claim, row: &str, at: f64) -> Result<(), TestCaseError> {
    if claim == Claim::One {
        prop_assert_eq!(surface.spans(), [1, 1]);
        return Ok(());
    }
    for along in [0, 1] {
        for other in 0..surface.spans()[1 - along] {
            let line = Line { surface, along, across: (other, at) };
            if row != "PN" {
                check(&line, claim, row)?;
                continue;
            }
            // Patches of different parameters: their tangent planes agree.
            for joint in 1..line.spans() {
                let [before, after] = [line.jet(joint - 1, 1.0), line.jet(joint, 0.0)].map(|jet| {
                    let jet = jet.expect("it is a span");
                    let normal = cross(jet.u, jet.v);
                    (jet.point, normal.map(|x| x / norm(normal)))
                });
                let apart: Point<3> = std::array::from_fn(|d| before.0[d] - after.0[d]);
                prop_assert!(norm(apart) < 1e-8, "patches are apart by {}", norm(apart));
                prop_assert!(dot(before.1, after.1).abs() > 1.0 - 1e-10, "{}", dot(before.1, after.1));
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn curves_are_as_smooth_as_the_page_says(points in points()) {
        for (row, _, claim, files) in CURVES {
            for text in files(&points) {
                let found = match shape(&text) {
                    Ok(Shape::Plane(curve)) => check(&*curve, claim, &text),
                    Ok(Shape::Space(curve)) => check(&*curve, claim, &text),
                    Ok(Shape::Parts(parts)) => {
                        parts.curves.iter().try_for_each(|curve| check(curve, claim, &text))
                    }
                    Ok(Shape::Outlines(outlines)) => outlines.iter().try_for_each(|it| check(it, claim, &text)),
                    Ok(Shape::Surface(_)) => panic!("{row} is a curve"),
                    // Not every row of points has such a curve.
                    Err(TestCaseError::Reject(_)) => Ok(()),
                    Err(error) => Err(error),
                };
                found.map_err(|error| TestCaseError::fail(format!("{row}: {error}")))?;
            }
        }
    }

    #[test]
    fn surfaces_are_as_smooth_as_the_page_says(
        heights in prop::array::uniform6(prop::array::uniform6(-100.0..100.0f64)), at in 0.05..0.95f64,
    ) {
        let points: Net = std::array::from_fn(|k| {
            std::array::from_fn(|l| [60.0 * k as f64, 50.0 * l as f64, heights[k][l]])
        });
        for (row, _, claim, surfaces) in SURFACES {
            for surface in surfaces(&points) {
                let found = check_surface(&*surface, claim, row, at);
                found.map_err(|error| TestCaseError::fail(format!("{row}: {error}")))?;
            }
        }
    }
}
