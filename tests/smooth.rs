//! `grafika smooth`: the samples of section 2.3.8 through the command line, its files and its one line.

#![cfg(feature = "native")]

use grafika::file::{Document, FileKind};
use grafika::geometry::{Point, Residuals};
use std::path::PathBuf;
use std::process::{Command, Output};

fn smooth(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_grafika"))
        .current_dir(env!("CARGO_TARGET_TMPDIR"))
        .arg("smooth")
        .args(arguments)
        .output()
        .expect("it starts")
}

/// What a command writes that does its work: standard output and error.
fn done(arguments: &[&str]) -> [String; 2] {
    let output = smooth(arguments);
    let texts = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {texts:?}");
    texts
}

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn document(name: &str) -> Document {
    let content = std::fs::read(path(name)).unwrap();
    Document::decode(FileKind::from_name(name).unwrap(), &content).unwrap()
}

fn plane(document: Document) -> Vec<Point<2>> {
    match document {
        Document::PlanePoints(plane) => plane.points,
        other => panic!("{other:?}"),
    }
}

fn sample(name: &str) -> Vec<Point<2>> {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data").join(name);
    let kind = FileKind::from_name(name).unwrap();
    plane(Document::decode(kind, &std::fs::read(file).unwrap()).unwrap())
}

/// The points that the command writes to standard output, with other options.
fn smoothed(name: &str, options: &[&str]) -> Vec<Point<2>> {
    let arguments: Vec<&str> = [name, "-o", "-"].into_iter().chain(options.iter().copied()).collect();
    plane(Document::from_csv(&done(&arguments)[0]).unwrap())
}

/// The Gauss curve that the samples were made from.
fn clean(points: &[Point<2>]) -> Vec<Point<2>> {
    let gauss = |x: f64| 40.0 + 300.0 * (-((x - 280.0) / 60.0).powi(2) / 2.0).exp();
    points.iter().map(|&[x, _]| [x, gauss(x)]).collect()
}

/// The root of the mean square error of the ordinates.
fn error(points: &[Point<2>]) -> f64 {
    Residuals::between(points, &clean(points)).unwrap().rms
}

fn assert_near(ours: f64, stated: f64) {
    assert!((ours - stated).abs() < 0.005, "{ours}, not {stated}");
}

const STAGES: [&str; 3] = ["bspline", "bezier", "both"];

#[test]
fn the_samples_of_the_section_come_out_as_it_says() {
    // The clean, the noisy and the sparse curve with one gross error: as measured, and after each stage.
    let stated = [
        ("X.IP2", 0.215, [1.046, 21.873, 2.764]),
        ("Y.IP2", 7.260, [5.808, 21.792, 5.794]),
        ("Z.IP2", 41.416, [32.696, 46.072, 31.868]),
    ];
    for (name, raw, stages) in stated {
        assert_near(error(&sample(name)), raw);
        for (stage, stated) in STAGES.into_iter().zip(stages) {
            assert_near(error(&smoothed(name, &["--stage", stage])), stated);
        }
    }
    assert!(error(&smoothed("Y.IP2", &[])) < 0.8 * error(&sample("Y.IP2")));
}

#[test]
fn a_large_number_of_points_of_the_spline_is_needed() {
    // With few of them the Bézier curve flattens the peak more than it filters.
    let stated = [("1", 22.355), ("4", 8.773), ("6", 7.230), ("8", 6.550)];
    for (density, stated) in stated {
        assert_near(error(&smoothed("Y.IP2", &["--density", density])), stated);
    }
}

/// The slope of the Gauss curve that the samples were made from.
fn gauss_slope(x: f64) -> f64 {
    -300.0 * (x - 280.0) / 3600.0 * (-((x - 280.0) / 60.0).powi(2) / 2.0).exp()
}

fn root_mean_square(errors: &[f64]) -> f64 {
    (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt()
}

/// The error of the slopes from each point to the next, against the Gauss curve halfway.
fn slope_error(points: &[Point<2>]) -> f64 {
    let leg = |pair: &[Point<2>]| {
        let ([x0, y0], [x1, y1]) = (pair[0], pair[1]);
        (y1 - y0) / (x1 - x0) - gauss_slope((x0 + x1) / 2.0)
    };
    root_mean_square(&points.windows(2).map(leg).collect::<Vec<_>>())
}

/// What the page of GB_2D_IP says, to its last digit.
fn assert_stated(ours: f64, stated: &str) {
    let decimals = stated.len() - stated.find('.').unwrap() - 1;
    assert_eq!(format!("{ours:.decimals$}"), stated, "{ours}");
    let page = include_str!("../docs/gb_2d_ip.md");
    assert!(page.contains(&format!(" {stated}")), "{stated} is not on the page");
}

#[test]
fn the_table_of_the_page_is_true() {
    let stated = [
        ("X.IP2", ["0.22", "1.05", "21.87", "2.76"], ["0.027", "0.036", "0.540", "0.081"]),
        ("Y.IP2", ["7.26", "5.81", "21.79", "5.79"], ["0.675", "0.357", "0.561", "0.237"]),
        ("Z.IP2", ["41.42", "32.70", "46.07", "31.87"], ["1.524", "0.902", "1.057", "0.793"]),
    ];
    for (name, values, slopes) in stated {
        let stages = STAGES.map(|stage| smoothed(name, &["--stage", stage]));
        let all: Vec<Vec<Point<2>>> = std::iter::once(sample(name)).chain(stages).collect();
        for ((points, value), slope) in all.iter().zip(values).zip(slopes) {
            assert_stated(error(points), value);
            assert_stated(slope_error(points), slope);
        }
    }
    for (density, value, slope) in [
        ("1", "22.36", "0.572"),
        ("4", "8.77", "0.260"),
        ("6", "7.23", "0.229"),
        ("8", "6.55", "0.221"),
        ("16", "5.79", "0.237"),
        ("64", "5.66", "0.304"),
    ] {
        let points = smoothed("Y.IP2", &["--density", density]);
        assert_stated(error(&points), value);
        assert_stated(slope_error(&points), slope);
    }
}

/// The numbers of a table, `None` where a field is empty.
fn table(text: &str) -> (Vec<&str>, Vec<Vec<Option<f64>>>) {
    let mut lines = text.lines();
    let header = lines.next().unwrap().split(',').collect();
    let row = |line: &str| line.split(',').map(|field| field.parse().ok()).collect();
    (header, lines.map(row).collect())
}

fn sampled(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_grafika")).arg("sample").args(arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_spline_through_the_points_keeps_the_noise() {
    let text = sampled(&["Y.IP2", "--method", "spline", "--slopes"]);
    let (header, rows) = table(&text);
    assert_eq!(header, ["span", "u", "x", "y", "dy/dx"]);
    let place = |row: &[Option<f64>]| (row[2].unwrap(), row[3].unwrap(), row[4].unwrap());
    let slopes: Vec<f64> = rows.iter().map(|row| place(row)).map(|(x, _, s)| s - gauss_slope(x)).collect();
    assert_stated(root_mean_square(&slopes), "0.75");
    let points: Vec<Point<2>> = rows.iter().map(|row| place(row)).map(|(x, y, _)| [x, y]).collect();
    assert_stated(error(&points), "6.51");
}

#[test]
fn slopes_are_quotients_of_derivatives() {
    let text = sampled(&["A.IP2", "--method", "spline", "--closed", "--derivatives", "2", "--slopes"]);
    let (header, rows) = table(&text);
    assert_eq!(header, ["span", "u", "x", "y", "dx", "dy", "ddx", "ddy", "dy/dx"]);
    for row in rows {
        let [dx, dy] = [row[4].unwrap(), row[5].unwrap()];
        match row[8] {
            Some(slope) => assert!((slope * dx - dy).abs() <= 1e-12 * dy.abs()),
            None => assert!(dx.abs() <= 1e-12 * dy.abs()),
        }
    }
    let text = sampled(&["A.IP3", "--method", "bezier", "--slopes", "--at", "0.5"]);
    assert_eq!(table(&text).0, ["u", "x", "y", "z", "dy/dx", "dz/dx"]);
    // The ends of a cubic B-spline stand still.
    let text = sampled(&["Y.IP2", "--method", "bspline3", "--slopes"]);
    assert_eq!(table(&text).1[0][4], None);
    let json = sampled(&["Y.IP2", "--method", "bspline3", "--slopes", "--per-span", "1", "--to", "json"]);
    assert!(json.contains("\"dy/dx\":null"), "{json}");
}

#[test]
fn smoothed_points_come_with_their_slopes() {
    let [csv, _] = done(&["Y.IP2", "-o", "-", "--slopes", "--density", "8"]);
    let (header, rows) = table(&csv);
    assert_eq!((header, rows.len()), (vec!["x", "y", "dy/dx"], 41));
    let slopes: Vec<f64> = rows.iter().map(|row| row[2].unwrap() - gauss_slope(row[0].unwrap())).collect();
    assert!((root_mean_square(&slopes) - 0.247).abs() < 0.001);
    // The points are the same as without, and both tables read back.
    let plain = smoothed("Y.IP2", &["--density", "8"]);
    assert_eq!(plane(Document::from_csv(&csv).unwrap()), plain);
    done(&["Y.IP2", "-o", "slopes.json", "--slopes", "--density", "8"]);
    assert_eq!(plane(document("slopes.json")), plain);
    let output = smooth(&["Y.IP2", "-o", "y3.IP2", "--slopes"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains(".IP2 has no place for slopes"));
}

#[test]
fn the_line_tells_the_residuals_of_the_points() {
    let [stdout, stderr] = done(&["Y.IP2", "-o", "y.csv"]);
    assert_eq!(stderr, "");
    let Residuals { rms, largest, at } =
        Residuals::between(&sample("Y.IP2"), &plane(document("y.csv"))).unwrap();
    assert_eq!(stdout, format!("Y.IP2: RMS residual {rms:.4}, largest {largest:.4} at point {at}\n"));
    // To standard output the very same, with the line out of the way.
    let [csv, line] = done(&["Y.IP2", "-o", "-"]);
    assert_eq!(csv.into_bytes(), std::fs::read(path("y.csv")).unwrap());
    assert_eq!(line, format!("grafika: {stdout}"));
}

#[test]
fn every_format_holds_the_smoothed_points() {
    let exact = smoothed("Y.IP2", &[]);
    done(&["Y.IP2", "-o", "y.json"]);
    assert_eq!(plane(document("y.json")), exact);
    for name in ["y2.IP2", "y2.ic2"] {
        done(&["Y.IP2", "-o", name]);
        let rounded: Vec<Point<2>> = exact.iter().map(|point| point.map(f64::round_ties_even)).collect();
        assert_eq!(plane(document(name)), rounded);
    }
    done(&["A.IP3", "-o", "a.csv"]);
    done(&["A.IP3", "-o", "a.IP3"]);
    match [document("a.csv"), document("a.IP3")] {
        [Document::SpacePoints(exact), Document::SpacePoints(dos)] => {
            assert_eq!(exact.points.len(), 8);
            let gap = Residuals::between(&exact.points, &dos.points).unwrap().largest;
            assert!(gap < 1e-9, "{gap}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn measurements_of_any_size_are_taken() {
    // Seconds and volts, far from any field of pixels.
    let rows: String =
        (0..200).map(|i| format!("{},{}\n", 1e-3 * f64::from(i), -4e6 + f64::from(i % 2))).collect();
    std::fs::write(path("volts.csv"), format!("x,y\n{rows}")).unwrap();
    let [stdout, _] = done(&["volts.csv", "-o", "quiet.csv"]);
    let quiet = plane(document("quiet.csv"));
    assert_eq!(quiet.len(), 200);
    assert!(quiet[20..180].iter().all(|[_, y]| (y + 4e6 - 0.5).abs() < 0.002));
    assert!(stdout.starts_with("volts.csv: RMS residual 0.4"), "{stdout}");
}

#[test]
fn residuals_have_the_digits_that_they_need() {
    std::fs::write(path("small.csv"), "x,y\n0,1e-6\n1e-9,3e-6\n2e-9,2e-6\n3e-9,5e-6\n4e-9,1e-6\n").unwrap();
    let [stdout, _] = done(&["small.csv", "-o", "small_out.csv"]);
    assert_eq!(stdout, "small.csv: RMS residual 8.0e-7, largest 1.5e-6 at point 4\n");
}

#[test]
fn many_points_are_smoothed_like_few() {
    let rows: String = (0..40_000).map(|i| format!("{i},{}\n", f64::from(i % 8))).collect();
    std::fs::write(path("record.csv"), format!("x,y\n{rows}")).unwrap();
    let [stdout, stderr] = done(&["record.csv", "-o", "record_out.csv"]);
    let points = plane(document("record_out.csv"));
    assert_eq!((points.len(), stderr.as_str()), (40_000, ""));
    assert!(stdout.starts_with("record.csv: RMS residual 2."), "{stdout}");
    // In the middle the saw is filtered out, to its mean and to steps of 1 along x.
    for (i, [x, y]) in points.iter().enumerate().skip(20_000).take(50) {
        assert!((x - i as f64).abs() < 1e-6 && (y - 3.5).abs() < 1e-6, "{i}: {x} {y}");
    }
    let output = smooth(&["record.csv", "-o", "-", "--density", "1000"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(
        output.status.code() == Some(1) && stderr.contains("a smaller --density needs fewer"),
        "{stderr}"
    );
}

#[test]
fn what_cannot_be_done_is_told_in_a_line() {
    std::fs::write(path("two.csv"), "x,y\n1,2\n3,4\n").unwrap();
    std::fs::write(path("far.csv"), "x,y\n1,2\n3,4\n900,4\n").unwrap();
    for (arguments, status, part) in [
        (&["two.csv", "-o", "-"][..], 1, "two.csv: too few control points: 2 given, at least 3 needed"),
        (&["far.csv", "-o", "far.IP2"], 1, "far.csv as far.IP2: "),
        (&["A.GBP", "-o", "-"], 1, "A.GBP: this file holds no points"),
        (&["Y.IP2", "-o", "y.doc"], 1, "y.doc: no data file has this extension"),
        (&["Y.IP2", "-o", "-", "--density", "1000000"], 1, "Y.IP2: too many control points"),
        (&["Y.IP2", "-o", "-", "--density", "0"], 2, "--density"),
        (&["Y.IP2", "-o", "-", "--stage", "spline"], 2, "bspline, bezier, both"),
        (&["Y.IP2"], 2, "--output"),
    ] {
        let output = smooth(arguments);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {stderr}");
        assert!(stderr.contains(part) && stderr.lines().count() == 1, "{arguments:?}: {stderr}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
    assert!(!path("far.IP2").exists());
}
