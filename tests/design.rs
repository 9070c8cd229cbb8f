//! The recipe of a curve or surface is part of what is edited: undone, saved, rescued, read again and drawn alike
//! by editors and by commands.

mod common;

use common::SharedDisk;
use common::shelf::Shelf;
use grafika::design::{Design, NetDesign, Shape};
use grafika::file::{
    CurveSettings, Document, FileKind, Method, Net, NetKind, NetSettings, PlanePoints, SpacePoints,
};
use grafika::geometry::{
    self, Border, Closure, Curve, GeometryError, Method as Formula, ParamCurve, ParamSurface, Point, Scheme,
    Surface, VaryingBeta, Wave, hermite_arcs,
};
use grafika::machine::{Machine, Manner, Script, Session, Settings, Storage, play, sample};
use grafika::programs::{f_p_bspl, gb_2d_bt, gb_2d_ch, gb_2d_ip, gb_3d_bt, gb_3d_ip, zm_betsp, zm_bspl};
use grafika::ui::Program;
use grafika::work;
use serde_json::{Value, json};

const TODAY: Settings =
    Settings { language: grafika::machine::Language::Hungarian, seed: 1, manner: Manner::Today };

/// A running program with the disk it works on.
struct Window {
    session: Session,
    disk: SharedDisk,
    kept: common::Kept,
}

impl Window {
    fn open(program: Program, settings: Settings, document: Option<Document>) -> Window {
        Window::on(program, settings, document, &SharedDisk::default(), &Shelf::default())
    }

    fn on(
        program: Program,
        settings: Settings,
        document: Option<Document>,
        disk: &SharedDisk,
        shelf: &Shelf,
    ) -> Window {
        let machine = Machine::new(Box::new(disk.clone()), settings).with_recovery(shelf.slot());
        let session = common::session_on(program, machine, document);
        Window { session, disk: disk.clone(), kept: common::Kept::default() }
    }

    fn play(&mut self, script: &str) -> &mut Window {
        let script = Script::parse(script).expect("the test's script is right");
        play(&mut self.session, &script, &mut self.kept).expect("the outlet takes all");
        self
    }

    /// The model after a script.
    fn model(&mut self, script: &str) -> Value {
        self.play(&format!("{script}\ndump end.json"));
        self.kept.models["end.json"].clone()
    }

    /// One value of the model after a script, and whether there is something unsaved.
    fn state(&mut self, script: &str, name: &str) -> (Value, Value) {
        let model = self.model(script);
        (model[name].clone(), model["unsaved"].clone())
    }
}

/// A built-in sample.
fn stored(name: &str) -> Document {
    let content = sample(name).unwrap_or_else(|| panic!("{name} is a sample"));
    Document::decode(FileKind::from_name(name).unwrap(), content).unwrap()
}

/// The document that a file and what belongs to it on a disk say.
fn read(disk: &SharedDisk, name: &str) -> Document {
    let document = Document::decode(FileKind::from_name(name).unwrap(), &disk.file(name)).unwrap();
    work::with_json(work::with_twin(document, disk, name).0, disk, name)
}

fn curve_settings(document: &Document) -> CurveSettings {
    match document {
        Document::PlanePoints(plane) => plane.settings.clone(),
        Document::SpacePoints(space) => space.settings.clone(),
        other => panic!("{other:?}"),
    }
}

fn net_settings(document: &Document) -> NetSettings {
    match document {
        Document::Net(net) => net.settings,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_bias_is_undone_redone_and_saved_in_space() {
    let mut window = Window::open(gb_3d_bt::PROGRAM, Settings::default(), Some(stored("B.IP3")));
    let yes = Value::Bool(true);
    let no = Value::Bool(false);
    for (script, bias, unsaved) in [
        ("", 1.0, &no),
        ("type a2\nkey Enter", 2.0, &yes),
        ("key Ctrl+Z", 1.0, &no),
        ("key Ctrl+Y", 2.0, &yes),
        ("key Ctrl+S\ntype b\nkey Enter", 2.0, &no),
        ("key Ctrl+Z", 1.0, &yes),
    ] {
        assert_eq!(window.state(script, "bias"), (json!(bias), unsaved.clone()), "{script:?}");
    }
}

#[test]
fn choosing_a_curve_is_a_change_that_is_undone() {
    let choice = |model: &Value| (model["method"].clone(), model["closed"].clone(), model["unsaved"].clone());
    for (program, file) in [(gb_2d_ip::PROGRAM, "B.IP2"), (gb_3d_ip::PROGRAM, "B.IP3")] {
        let mut window = Window::open(program, TODAY, Some(stored(file)));
        for (script, expected) in [
            ("type gz3", (json!("spline"), json!(true), json!(true))),
            ("type gn2", (json!("bezier"), json!(false), json!(true))),
            ("key Ctrl+Z", (json!("spline"), json!(true), json!(true))),
            ("key Ctrl+Y", (json!("bezier"), json!(false), json!(true))),
            // The file names no method: the usual one is drawn.
            ("key Ctrl+Z\nkey Ctrl+Z", (json!("spline"), json!(false), json!(false))),
        ] {
            assert_eq!(choice(&window.model(script)), expected, "{file}: {script:?}");
        }
    }
}

/// Programs with a recipe that their DOS format cannot hold: a change of the bias, and where it stands in the model.
fn cases() -> [(Program, &'static str, &'static str, &'static str, Value); 3] {
    [
        (gb_2d_bt::PROGRAM, "B.IP2", "type a2\nkey Enter\n", "NEW.IP2", json!(2.0)),
        (gb_3d_bt::PROGRAM, "B.IP3", "type a2\nkey Enter\n", "NEW.IP3", json!(2.0)),
        (zm_betsp::PROGRAM, "K2.ZMB", "key A\nkey U\ntype 2\nkey Enter\n", "NEW.ZMB", json!([2.0, 1.0])),
    ]
}

/// The bias of a document as the model shows it.
fn bias(document: &Document) -> Value {
    match document {
        Document::Net(_) => json!(net_settings(document).bias),
        _ => json!(curve_settings(document).bias),
    }
}

const SAVE: &str = "key Ctrl+S\ntype new\nkey Enter\n";

#[test]
fn what_a_dos_file_cannot_hold_is_offered_a_json_file() {
    for (program, file, change, saved, expected) in cases() {
        let mut window = Window::open(program, TODAY, Some(stored(file)));
        window.play(&format!("{change}{SAVE}"));
        assert_eq!(window.disk.names(), [""; 0], "{file}: the question stands");
        assert_eq!(window.state("key I", "unsaved").0, false, "{file}");
        assert_eq!(window.disk.names().len(), 2);
        assert!(window.disk.names().contains(&"NEW.JSON".to_owned()));
        assert_eq!(bias(&read(&window.disk, saved)), expected, "{file}");
        // By the file's name in the program, which asks for a stored configuration.
        let disk = window.disk.clone();
        let mut again = Window::on(program, TODAY, None, &disk, &Shelf::default());
        assert_eq!(again.state("type tnew\nkey Enter", "bias"), (expected.clone(), json!(false)), "{file}");
        // The JSON file that belongs to it goes on being written without a question about it.
        let other = change.replace('2', "3");
        again.play(&format!("{other}{SAVE}key I\n"));
        assert_eq!(
            bias(&read(&disk, saved)).to_string(),
            expected.to_string().replace("2.0", "3.0"),
            "{file}"
        );
    }
}

#[test]
fn without_the_json_file_the_dos_file_alone_is_written() {
    for (program, file, change, saved, expected) in cases() {
        let mut window = Window::open(program, TODAY, Some(stored(file)));
        assert_eq!(window.state(&format!("{change}{SAVE}key N"), "unsaved").0, false, "{file}");
        assert_eq!(window.disk.names(), [saved]);
        assert_ne!(bias(&read(&window.disk, saved)), expected);
        // Esc saves nothing.
        let mut window = Window::open(program, TODAY, Some(stored(file)));
        assert_eq!(window.state(&format!("{change}{SAVE}key Esc"), "unsaved").0, true, "{file}");
        assert_eq!(window.disk.names(), [""; 0]);
        // The manner of 1997 has no such question.
        let mut window = Window::open(program, Settings::default(), Some(stored(file)));
        assert_eq!(window.state(&format!("{change}{SAVE}"), "unsaved").0, false, "{file}");
        assert_eq!(window.disk.names(), [saved]);
    }
}

#[test]
fn a_json_file_of_something_else_is_neither_read_nor_replaced() {
    let other = br#"{"format": "IP2", "points": [[1, 2], [3, 4], [5, 6]], "settings": {"bias": 9}}"#;
    let mut disk = SharedDisk::default();
    disk.write("NEW.IP2", sample("B.IP2").unwrap()).unwrap();
    disk.write("NEW.JSON", other).unwrap();
    let mut window = Window::on(gb_2d_bt::PROGRAM, TODAY, None, &disk, &Shelf::default());
    assert_eq!(window.state("type tnew\nkey Enter", "bias"), (json!(1.0), json!(false)));
    // Nothing is lost, so nothing is asked but whether the file may be overwritten.
    window.play(&format!("type t1\nkey Enter\n{SAVE}key I"));
    assert_eq!(window.model("")["unsaved"], false);
    assert_ne!(disk.file("NEW.IP2"), sample("B.IP2").unwrap());
    assert_eq!(disk.file("NEW.JSON"), other);
    window.play(&format!("type a2\nkey Enter\n{SAVE}key N\nkey I"));
    assert_eq!(disk.file("NEW.JSON"), other);
}

#[test]
fn a_json_file_is_written_anew_where_it_would_be_read() {
    let mut window = Window::open(gb_2d_bt::PROGRAM, TODAY, Some(stored("B.IP2")));
    window.play(&format!("type a2\nkey Enter\n{SAVE}key I\ntype a1\nkey Enter\n{SAVE}key I"));
    let settings = curve_settings(&read(&window.disk, "NEW.IP2"));
    assert_ne!(settings.bias, Some(2.0));
}

/// A document of the plane with settings.
fn plane(settings: CurveSettings) -> Document {
    let Document::PlanePoints(points) = stored("B.IP2") else { panic!("B.IP2 holds points") };
    Document::PlanePoints(PlanePoints { settings, ..points })
}

fn net(name: &str, settings: NetSettings) -> Document {
    let Document::Net(net) = stored(name) else { panic!("{name} holds a net") };
    Document::Net(Net { settings, ..net })
}

#[test]
fn editors_obey_the_settings_of_a_document() {
    let spline =
        CurveSettings { method: Some(Method::Spline), closed: Some(true), ..CurveSettings::default() };
    let model = Window::open(gb_2d_ip::PROGRAM, TODAY, Some(plane(spline))).model("");
    assert_eq!((&model["method"], &model["closed"]), (&json!("spline"), &json!(true)));
    assert_eq!((&model["visible"], &model["unsaved"]), (&json!(true), &json!(false)));
    let beta =
        CurveSettings { bias: Some(3.0), tension: Some(4.0), closed: Some(true), ..CurveSettings::default() };
    let model = Window::open(gb_2d_bt::PROGRAM, TODAY, Some(plane(beta))).model("");
    assert_eq!(
        (&model["bias"], &model["tension"], &model["visible"]),
        (&json!(3.0), &json!(4.0), &json!(true))
    );

    let quadratic = NetSettings { method: Some(Method::BSpline2), ..NetSettings::default() };
    let extended = NetSettings { extended: Some(true), ..NetSettings::default() };
    for (settings, degree, reached, surface) in
        [(quadratic, 2, false, true), (extended, 3, true, true), (NetSettings::default(), 3, false, false)]
    {
        let model = Window::open(zm_bspl::PROGRAM, TODAY, Some(net("A.ZMB", settings))).model("");
        assert_eq!((&model["degree"], &model["extended"]), (&json!(degree), &json!(reached)), "{settings:?}");
        assert_eq!((&model["surface"], &model["unsaved"]), (&json!(surface), &json!(false)), "{settings:?}");
    }
}

#[test]
fn a_recipe_is_rescued() {
    for (program, file, script, parts) in [
        (gb_2d_ip::PROGRAM, "B.IP2", "type gz1.25\nkey Enter", &["method", "closed", "k0", "visible"][..]),
        (gb_2d_ip::PROGRAM, "B.IP2", "type gn42", &["method", "closed", "visible"]),
        (gb_2d_bt::PROGRAM, "B.IP2", "type a2\nkey Enter\ntype c3\nkey Enter", &["bias", "tension"]),
        (
            gb_2d_bt::PROGRAM,
            "B.IP2",
            "key F5\ntype 2\nkey Enter\ntype 3\nkey Enter\ntype 20\nkey Enter",
            &["joints"],
        ),
        (gb_2d_ch::PROGRAM, "B.IP2", "type iz.25\nkey Enter", &["k0", "tangents"]),
        (gb_3d_bt::PROGRAM, "B.IP3", "type a2\nkey Enter\ntype gz", &["bias", "closed", "visible"]),
        (f_p_bspl::PROGRAM, "A.FBS", "type f2d", &["degree", "surface"]),
        (zm_bspl::PROGRAM, "A.ZMB", "key F4", &["extended"]),
        (zm_betsp::PROGRAM, "K2.ZMB", "key A\nkey U\ntype 2\nkey Enter", &["bias"]),
    ] {
        let (disk, shelf) = (SharedDisk::default(), Shelf::default());
        let mut window = Window::on(program, TODAY, Some(stored(file)), &disk, &shelf);
        // GB_2D_CH asks first and has no model yet.
        let start = window.session.model().map(|model| serde_json::from_str(&model.unwrap()).unwrap());
        let start: Value = start.unwrap_or_default();
        let lost = window.model(script);
        assert_eq!(lost["unsaved"], true, "{file}: {script:?}");
        drop(window);
        let mut again = Window::on(program, TODAY, None, &disk, &shelf);
        let found = again.model("key I\nkey Esc");
        assert_eq!(found["unsaved"], true, "{file}: {script:?}");
        assert!(parts.iter().any(|part| lost[part] != start[part]), "{file}: {script:?} changes something");
        for part in parts {
            assert_eq!(found[part], lost[part], "{file}: {script:?}: {part}");
        }
    }
}

/// Every finite number of a curve or surface, so that even the sign of a zero counts.
fn samples(shape: &Shape) -> String {
    match shape {
        Shape::Plane(curve) => format!("{:?}", curve.sample(7)),
        Shape::Space(curve) => format!("{:?}", curve.sample(7)),
        Shape::Surface(surface) => format!("{:?}", surface.sample(3)),
        Shape::Parts(parts) => {
            let curves: Vec<_> = parts.curves.iter().map(|curve| curve.sample(7)).collect();
            let patches: Vec<_> = parts.patches.iter().map(|patch| patch.sample(3)).collect();
            format!("{curves:?} {patches:?}")
        }
        Shape::Outlines(outlines) => {
            let outlines: Vec<_> = outlines.iter().map(|outline| outline.sample(7)).collect();
            format!("{outlines:?}")
        }
    }
}

/// What a document describes, or why it describes nothing.
fn described(document: &Document) -> Result<String, String> {
    let shape = Design::of_document(document.clone()).and_then(|design| design.shape());
    shape.map(|shape| samples(&shape)).map_err(|error| error.to_string())
}

fn curve<const D: usize>(result: Result<impl ParamCurve<D>, GeometryError>) -> Result<String, String> {
    result.map(|curve| format!("{:?}", curve.sample(7))).map_err(|error| error.to_string())
}

fn surface(result: Result<Surface, GeometryError>) -> Result<String, String> {
    result.map(|surface| format!("{:?}", surface.sample(3))).map_err(|error| error.to_string())
}

const K0: f64 = 0.375;
const SHAPE: geometry::Shape = geometry::Shape { bias: 1.75, tension: 2.5 };

/// The methods that need nothing but control points, as files name them and as geometry does.
const FORMULAS: [(Method, Formula); 7] = [
    (Method::Coons, Formula::Coons { k0: K0 }),
    (Method::Bezier, Formula::Bezier),
    (Method::Spline, Formula::Spline),
    (Method::BSpline2, Formula::BSpline2),
    (Method::BSpline3, Formula::BSpline3),
    (Method::Beta, Formula::Beta { bias: SHAPE.bias, tension: SHAPE.tension }),
    (Method::Local, Formula::Local { k0: K0 }),
];

const PLANE: [Point<2>; 6] =
    [[60.0, 80.0], [250.0, 200.0], [320.0, 120.0], [520.0, 300.0], [400.0, 20.0], [130.0, 33.0]];

fn in_space() -> Vec<Point<3>> {
    PLANE.iter().zip([5.0, -70.0, 33.0, 0.0, 128.0, 9.0]).map(|(&[x, y], z)| [x, y, z]).collect()
}

/// The settings of every method, both closures, and closure left out, which is open.
fn settings(method: Method) -> [(CurveSettings, Closure); 3] {
    let with = |closed| CurveSettings {
        method: Some(method),
        closed,
        k0: Some(K0),
        bias: Some(SHAPE.bias),
        tension: Some(SHAPE.tension),
        ..CurveSettings::default()
    };
    [(with(Some(false)), Closure::Open), (with(Some(true)), Closure::Closed), (with(None), Closure::Open)]
}

#[test]
fn a_document_of_points_is_the_curve_that_geometry_makes() {
    let mut different = std::collections::BTreeSet::new();
    for (method, formula) in FORMULAS {
        for (settings, closure) in settings(method) {
            let plane = PlanePoints { settings: settings.clone(), ..PlanePoints::new(PLANE.to_vec()) };
            let found = described(&Document::PlanePoints(plane));
            assert_eq!(found, curve(Curve::through(formula, closure, &PLANE)), "{settings:?}");
            different.insert(found.expect("six points have every curve"));
            let space = SpacePoints { settings: settings.clone(), ..SpacePoints::new(in_space()) };
            let expected = curve(Curve::through(formula, closure, &in_space()));
            assert_eq!(described(&Document::SpacePoints(space)), expected, "{settings:?}");
        }
    }
    // Coons and local are the same curves when they are open; nothing else is.
    assert!(different.len() >= 12, "{}", different.len());
    // Nothing is drawn that nobody has named.
    let nameless = Document::PlanePoints(PlanePoints::new(PLANE.to_vec()));
    assert_eq!(described(&nameless).unwrap_err(), "which method? Give --method, as in --method spline");
}

#[test]
fn tangents_and_joints_are_the_curve_that_geometry_makes() {
    let tangents: Vec<Point<2>> = PLANE.iter().map(|&[x, y]| [y - 100.0, 200.0 - x]).collect();
    let joints: Vec<geometry::Shape> =
        [1.0, 2.0, 0.5, 3.0, 1.5, 1.0].map(|bias| geometry::Shape { bias, tension: 4.0 * bias }).to_vec();
    for named in [true, false] {
        for closed in [false, true] {
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let settings = |method| CurveSettings {
                method: named.then_some(method),
                closed: Some(closed),
                ..CurveSettings::default()
            };
            let points = PlanePoints::new(PLANE.to_vec());
            let hermite = PlanePoints {
                tangents: Some(tangents.clone()),
                settings: settings(Method::Hermite),
                ..points.clone()
            };
            let expected = curve(hermite_arcs(closure, &PLANE, &tangents).map(Curve::Piecewise));
            assert_eq!(described(&Document::PlanePoints(hermite)), expected);
            let beta =
                PlanePoints { joints: Some(joints.clone()), settings: settings(Method::Beta), ..points };
            let expected = curve(VaryingBeta::new(closure, &PLANE, &joints));
            assert_eq!(described(&Document::PlanePoints(beta)), expected);
        }
    }
}

#[test]
fn coefficients_are_the_curve_that_geometry_makes() {
    let Document::Fourier(file) = stored("A.GBP") else { panic!("A.GBP holds coefficients") };
    let wave = |amplitude: f64, phase: f64| Wave { amplitude, phase };
    let rows: Vec<[Wave; 2]> =
        (1..file.a.len()).map(|k| [wave(file.a[k], file.p[k]), wave(file.b[k], file.q[k])]).collect();
    let expected = curve(geometry::Fourier::new([file.a[0], file.b[0]], &rows));
    assert_eq!(curve(file.curve()), expected);
    assert_eq!(described(&Document::Fourier(file)), expected);
}

#[test]
fn a_net_is_the_surface_that_geometry_makes() {
    let (k0, bias, tension) = ([0.25, 0.75], [1.5, 2.0], [3.0, 5.0]);
    let along = |formula: Formula, d: usize| match formula {
        Formula::Beta { .. } => Formula::Beta { bias: bias[d], tension: tension[d] },
        Formula::Local { .. } => Formula::Local { k0: k0[d] },
        other => other,
    };
    let mut surfaces = 0;
    for kind in NetKind::ALL {
        let [rows, columns] = kind.shape();
        let place = |k: usize, l: usize| {
            // The poles of a sphere are one point.
            let pole = kind.topology() == geometry::Topology::Sphere && (l == 0 || l + 1 == columns);
            let (k, l) = (if pole { 0.0 } else { k as f64 }, l as f64);
            [30.0 * k - 7.0 * l, 40.0 * l + k * k, 9.0 * (k - 2.0) * (l - 1.0)]
        };
        let points: Vec<Vec<Point<3>>> =
            (0..rows).map(|k| (0..columns).map(|l| place(k, l)).collect()).collect();
        let document = |settings| Document::Net(Net { settings, ..Net::new(kind, points.clone()) });
        if kind == NetKind::Fhc {
            let matrix: Vec<[Point<3>; 4]> =
                points.iter().map(|row| row.as_slice().try_into().unwrap()).collect();
            let expected = surface(Surface::hermite(&matrix.try_into().unwrap()));
            for method in [None, Some(Method::Hermite)] {
                assert_eq!(described(&document(NetSettings { method, ..NetSettings::default() })), expected);
            }
            continue;
        }
        for (method, formula) in FORMULAS {
            for extended in [None, Some(false), Some(true)] {
                let settings = NetSettings {
                    method: Some(method),
                    k0: Some(k0),
                    bias: Some(bias),
                    tension: Some(tension),
                    extended,
                    distance: None,
                    ..NetSettings::default()
                };
                let found = described(&document(settings));
                if method == Method::Coons {
                    assert_eq!(found.unwrap_err(), "coons is for curves; of surfaces it is called local");
                    continue;
                }
                let border = if extended == Some(true) { Border::Reached } else { Border::Doubled };
                let scheme =
                    Scheme { u: along(formula, 0), v: along(formula, 1), topology: kind.topology(), border };
                let expected = surface(Surface::new(scheme, &points));
                surfaces += usize::from(expected.is_ok());
                assert_eq!(found, expected, "{kind:?} {settings:?}");
                // What a file does not name its kind implies.
                if NetDesign::new(Net::new(kind, points.clone())).implied == method {
                    assert_eq!(described(&document(NetSettings { method: None, ..settings })), expected);
                }
            }
        }
    }
    assert!(surfaces > 100, "{surfaces}");
}

#[cfg(feature = "native")]
mod commands {
    use super::*;
    use std::path::PathBuf;
    use std::process::{Command, Output};

    /// A scratch folder, gone at the end.
    struct Scratch(PathBuf);

    impl Scratch {
        fn new(name: &str) -> Scratch {
            let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("design-{name}"));
            let _ = std::fs::remove_dir_all(&path);
            std::fs::create_dir_all(&path).unwrap();
            Scratch(path)
        }

        fn run(&self, arguments: &[&str]) -> Output {
            let program = env!("CARGO_BIN_EXE_grafika");
            Command::new(program).current_dir(&self.0).args(arguments).output().expect("it starts")
        }

        /// What a command writes on standard output and error that does its work.
        fn done(&self, arguments: &[&str]) -> [String; 2] {
            let output = self.run(arguments);
            let texts =
                [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
            assert_eq!(output.status.code(), Some(0), "{arguments:?}: {texts:?}");
            texts
        }

        /// Status and message of a command that does not.
        fn refused(&self, arguments: &[&str]) -> (Option<i32>, String) {
            let output = self.run(arguments);
            (output.status.code(), String::from_utf8(output.stderr).unwrap().trim_end().to_owned())
        }

        fn write(&self, name: &str, document: &Document) {
            let content = document.encode(FileKind::from_name(name).unwrap()).unwrap();
            std::fs::write(self.0.join(name), content).unwrap();
        }

        fn read(&self, name: &str) -> Document {
            let content = std::fs::read(self.0.join(name)).unwrap();
            Document::decode(FileKind::from_name(name).unwrap(), &content).unwrap()
        }

        fn names(&self) -> Vec<String> {
            let entries = std::fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().file_name());
            let mut names: Vec<String> = entries.map(|name| name.into_string().unwrap()).collect();
            names.sort();
            names
        }
    }

    impl Drop for Scratch {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    /// The data of the paths that are curves.
    fn curves(svg: &str) -> Vec<&str> {
        let paths = svg.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
        paths.filter(|data| data.contains('C')).collect()
    }

    #[test]
    fn the_figure_of_an_editor_is_that_of_render() {
        let scratch = Scratch::new("figure");
        let spline =
            CurveSettings { method: Some(Method::Spline), closed: Some(true), ..CurveSettings::default() };
        let open =
            CurveSettings { method: Some(Method::BSpline2), closed: Some(false), ..CurveSettings::default() };
        let coons = CurveSettings { method: Some(Method::Coons), k0: Some(0.25), ..CurveSettings::default() };
        for settings in [spline, open, coons] {
            let document = plane(settings.clone());
            scratch.write("s.json", &document);
            scratch.done(&["render", "s.json", "-o", "s.svg"]);
            let rendered = std::fs::read_to_string(scratch.0.join("s.svg")).unwrap();
            let mut window = Window::open(gb_2d_ip::PROGRAM, TODAY, Some(document));
            window.play("key F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter");
            let figure = String::from_utf8(window.disk.file("gb_2d_ip-1.svg")).unwrap();
            assert_eq!(curves(&rendered).len(), 1, "{settings:?}");
            assert_eq!(curves(&rendered), curves(&figure), "{settings:?}");
        }
    }

    #[test]
    fn commands_obey_settings_and_the_command_line_comes_first() {
        let scratch = Scratch::new("settings");
        let settings = CurveSettings {
            method: Some(Method::Beta),
            closed: Some(true),
            bias: Some(2.0),
            tension: Some(3.0),
            ..CurveSettings::default()
        };
        scratch.write("bare.json", &plane(CurveSettings::default()));
        scratch.write("s.json", &plane(settings));
        let sampled = |arguments: &[&str]| scratch.done(&[&["sample"], arguments].concat())[0].clone();
        let beta = ["--method", "beta", "--closed", "--bias", "2", "--tension", "3"];
        assert_eq!(sampled(&["s.json"]), sampled(&[&["bare.json"], &beta[..]].concat()));
        assert_eq!(
            sampled(&["s.json", "--method", "spline"]),
            sampled(&["bare.json", "--method", "spline", "--closed"])
        );
        assert_ne!(sampled(&["s.json"]), sampled(&["s.json", "--bias", "1"]));

        let quadratic = NetSettings { method: Some(Method::BSpline2), ..NetSettings::default() };
        scratch.write("bare-net.json", &net("A.ZMB", NetSettings::default()));
        scratch.write("net.json", &net("A.ZMB", quadratic));
        assert_eq!(sampled(&["net.json"]), sampled(&["bare-net.json", "--method", "bspline2"]));
        assert_ne!(sampled(&["net.json"]), sampled(&["bare-net.json"]));
        scratch.done(&["render", "net.json", "-o", "net.png"]);
    }

    #[test]
    fn commands_say_what_a_document_lacks() {
        let scratch = Scratch::new("refused");
        scratch.write("bare.json", &plane(CurveSettings::default()));
        for command in [&["sample"][..], &["render", "-o", "x.png"]] {
            for (arguments, status, message) in [
                (&["bare.json"][..], 2, "grafika: which method? Give --method, as in --method spline"),
                (
                    &["bare.json", "--method", "hermite"],
                    2,
                    "grafika: hermite needs tangents, as an .IC2 file with its .EC2 has them",
                ),
                (
                    &["bare.json", "--method", "fourier"],
                    2,
                    "grafika: fourier needs coefficients, as a .GBP file has them",
                ),
                (
                    &["A.ZMB", "--method", "coons"],
                    2,
                    "grafika: coons is for curves; of surfaces it is called local",
                ),
                (
                    &["A.FHC", "--method", "spline"],
                    2,
                    "grafika: an .FHC file holds points, tangents and twists; it has no other method than hermite",
                ),
                (
                    &["A.CSK"],
                    1,
                    "grafika: A.CSK: this file holds no curve and no surface; .IP2, .IC2, .IP3, .GBP, the nets .FHC to .ZYP and .PN, .KCG to .KCJ, .RBC, .RBS, .CSM, .CSF, .ALP and .KOR do",
                ),
            ] {
                let refused = scratch.refused(&[command, arguments].concat());
                assert_eq!(refused, (Some(status), message.to_owned()), "{command:?} {arguments:?}");
            }
        }
    }

    #[test]
    fn convert_writes_the_tangents_beside_the_points() {
        let scratch = Scratch::new("tangents");
        assert_eq!(scratch.done(&["convert", "A.IC2", "y.ic2"]), ["", ""]);
        assert_eq!(scratch.names(), ["y.ec2", "y.ic2"]);
        assert_eq!(scratch.read("y.ec2"), stored("A.EC2"));
        assert_eq!(scratch.done(&["convert", "A.IC2", "Z.IC2"]), ["", ""]);
        assert_eq!(scratch.names(), ["Z.EC2", "Z.IC2", "y.ec2", "y.ic2"]);
        // Through JSON and back nothing is lost.
        scratch.done(&["convert", "y.ic2", "a.json"]);
        scratch.done(&["convert", "a.json", "b.ic2"]);
        assert_eq!((scratch.read("b.ic2"), scratch.read("b.ec2")), (stored("A.IC2"), stored("A.EC2")));
        // Points without tangents have no such twin.
        scratch.done(&["convert", "A.IP2", "p.ic2"]);
        assert!(!scratch.names().contains(&"p.ec2".to_owned()));
    }

    #[test]
    fn convert_says_what_has_no_place() {
        let scratch = Scratch::new("lost");
        let said = |arguments: &[&str]| scratch.done(&[&["convert"], arguments].concat())[1].clone();
        assert_eq!(said(&["A.IC2", "a.ip2"]), "grafika: a.ip2 has no place for: tangents\n");
        assert_eq!(said(&["A.IC2", "a.ip3"]), "grafika: a.ip3 has no place for: tangents\n");
        assert_eq!(said(&["A.IC2", "a.csv"]), "grafika: a.csv has no place for: tangents\n");
        assert_eq!(said(&["A.IC2", "a.ec2"]), "grafika: a.ec2 has no place for: points\n");
        assert_eq!(
            said(&["A.IC2", "-", "--to", "ic2"]),
            "grafika: standard output has no place for: tangents\n"
        );
        let settings = CurveSettings { bias: Some(2.0), closed: Some(false), ..CurveSettings::default() };
        let Document::PlanePoints(points) = plane(settings) else { panic!() };
        let joints = Some(vec![geometry::Shape::default(); points.points.len()]);
        scratch.write("j.json", &Document::PlanePoints(PlanePoints { joints, ..points }));
        assert_eq!(said(&["j.json", "j.ip2"]), "grafika: j.ip2 has no place for: bias, joints\n");
        assert_eq!(scratch.read("j.ip2"), stored("B.IP2"));
        assert_eq!(said(&["j.json", "j.csv"]), "grafika: j.csv has no place for: bias, closed, joints\n");
        let named =
            NetSettings { method: Some(Method::BSpline3), bias: Some([2.0; 2]), ..NetSettings::default() };
        scratch.write("n.json", &net("A.ZMB", named));
        assert_eq!(said(&["n.json", "n.zmb"]), "grafika: n.zmb has no place for: bias\n");
        assert_eq!(said(&["n.json", "m.json"]), "");
        assert_eq!(said(&["A.IP2", "q.csv"]), "");
        // What does not fit at all is refused, and nothing is written.
        let (status, message) = scratch.refused(&["convert", "A.IP3", "x.ip2"]);
        assert_eq!(status, Some(1));
        assert!(message.starts_with("grafika: A.IP3 as x.ip2: does not fit into .IP2"), "{message}");
        assert!(!scratch.names().contains(&"x.ip2".to_owned()));
    }
}
