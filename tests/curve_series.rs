//! `grafika render` with several values of an option: curves of a series in one picture, with a legend, and joints.

#![cfg(feature = "native")]

use std::path::PathBuf;
use std::process::Command;

fn folder() -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("curve_series");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Exit status and what is said on standard error.
fn run(words: &str) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_grafika"))
        .current_dir(folder())
        .args(words.split_whitespace())
        .output()
        .expect("it starts");
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// The picture that a command draws.
fn drawn(words: &str, name: &str) -> Vec<u8> {
    assert_eq!(run(&format!("render {words} -o {name}")), (Some(0), String::new()), "{words}");
    std::fs::read(folder().join(name)).unwrap()
}

fn svg(words: &str, name: &str) -> String {
    String::from_utf8(drawn(words, name)).unwrap()
}

/// The data of all curves of a picture.
fn paths(svg: &str) -> Vec<&str> {
    let lines = svg.lines().filter(|line| line.starts_with("<path"));
    lines.filter_map(|line| line.split('"').nth(1)).filter(|data| data.contains('C')).collect()
}

fn texts(svg: &str) -> Vec<&str> {
    let texts = svg.lines().filter(|line| line.starts_with("<text"));
    texts.map(|line| line.split('>').nth(1).unwrap().trim_end_matches("</text")).collect()
}

#[test]
fn every_curve_of_a_series_is_the_one_alone() {
    let series = svg("A.IP2 --method coons --closed --k0 0.3,0.5,-1", "k.svg");
    assert_eq!(texts(&series), ["── k0=0.3", "── k0=0.5", "── k0=-1"]);
    for (k0, path) in ["0.3", "0.5", "-1"].into_iter().zip(paths(&series)) {
        assert_eq!(paths(&svg(&format!("A.IP2 --method coons --closed --k0 {k0}"), "one.svg")), [path]);
    }
    // Repeated options say the same.
    assert_eq!(svg("A.IP2 --method coons --closed --k0 0.3 --k0 0.5 --k0 -1", "again.svg"), series);
    // Every curve has its colour, in the legend too.
    let inks: Vec<&str> = series.split("stroke=\"#").skip(1).map(|rest| &rest[..6]).collect();
    assert!(inks[0] != inks[1] && inks[1] != inks[2] && inks[0] != inks[2], "{inks:?}");
    assert!(inks[..3].iter().all(|ink| series.contains(&format!("fill=\"#{ink}\""))));
}

#[test]
fn a_single_value_has_no_legend() {
    let one = svg("A.IP2 --method beta --closed --tension 2", "single.svg");
    assert_eq!((paths(&one).len(), texts(&one).len()), (1, 0));
}

#[test]
fn two_series_are_a_product_and_methods_take_what_they_have() {
    let product = svg("A.IP3 --method beta --closed --tension 0,5 --bias 1,2", "product.svg");
    let legend = ["── bias=1 tension=0", "── bias=1 tension=5", "── bias=2 tension=0", "── bias=2 tension=5"];
    assert_eq!(texts(&product), legend);
    assert_eq!(paths(&product).len(), 4);
    let methods = svg("A.IP2 --method spline,coons,beta --k0 0.2,1 --bias 3", "methods.svg");
    assert_eq!(texts(&methods), ["── spline", "── coons k0=0.2", "── coons k0=1", "── beta"]);
    assert_eq!(paths(&methods)[3], paths(&svg("A.IP2 --method beta --bias 3", "beta.svg"))[0]);
    for format in ["pdf", "png"] {
        let content =
            drawn("A.IP2 --method spline,bezier --points --polygon --axes", &format!("all.{format}"));
        assert!(content.len() > 1000);
    }
}

#[test]
fn joints_are_where_spans_end() {
    let circles = |words: &str| svg(words, "joints.svg").matches("<circle").count();
    assert_eq!(circles("O.IP2 --method spline --joints"), circles("O.IP2 --method spline --points"));
    assert_eq!(circles("A.IP3 --method beta --closed --joints"), 8);
    assert_eq!(circles("A.IP3 --method beta --joints"), 8);
    assert_eq!(circles("A.IP3 --method bezier --joints"), 2);
    assert_eq!(circles("A.IP3 --method bezier"), 0);
    assert_eq!(circles("A.IP3 --method beta --closed --tension 0,5 --joints"), 16);
}

#[test]
fn wrong_values_are_told_by_their_name() {
    for (words, status, part) in [
        ("A.IP2 --method coons --k0 0.3,nan", 2, "'nan' for '--k0"),
        ("A.IP2 --method coons --k0 0.3,,1", 2, "'' for '--k0"),
        ("A.IP2 --method coons --k0 0.3,0.30", 2, "--k0 has 0.3 twice"),
        ("A.IP2 --method spline,spline", 2, "--method has spline twice"),
        ("A.IP2 --method spline,splyne", 2, "'splyne' for '--method"),
        ("A.IP2 --method beta --bias 1,-2", 1, "bias=-2: bias is -2, but must be positive"),
        ("A.IP2 --method beta --tension 1,-6", 1, "tension=-6: tension -6 is the critical one"),
        ("A.IP2 --method spline --k0 1,2", 2, "--k0 is for coons and local; spline has no such thing"),
        ("A.IP2 --method spline,bezier --k0 1", 2, "--k0: none of these methods has it"),
        (
            "A.IP2 --method beta --tension 1,2,3,4,5 --bias 1,2,3,4",
            2,
            "20 curves or more; a picture takes 16",
        ),
        ("A.IP2 --method spline,bezier --comb", 2, "--comb is for single curves"),
        ("A.IP2 --method spline,bezier --view 1,2,3", 2, "--view is for space curves"),
        ("A.ZMS --method local --k0 1,2", 2, "A.ZMS holds no control points of curves"),
        ("A.ZMS --joints", 2, "--joints is for single curves"),
    ] {
        let (found, said) = run(&format!("render {words} -o wrong.svg"));
        assert_eq!(found, Some(status), "{words}: {said}");
        assert!(said.contains(part) && said.lines().count() == 1, "{words}: {said}");
        assert!(!folder().join("wrong.svg").exists());
    }
    let (status, said) = run("sample A.IP2 --method coons --k0 1,2");
    assert!(status == Some(2) && said.contains("--k0 has 2 values; one is taken here"), "{said}");
    let (status, said) = run("render A.IP2 --method spline,bezier -o a.step");
    assert!(status == Some(2) && said.contains("drawn as pictures"), "{said}");
}
