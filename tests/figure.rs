//! Figures as other programs read them: SVG numbers, XML, PNG pictures, limits, and `grafika render`.

#![cfg(feature = "native")]

mod common;

use common::pictures;
use grafika::figure::{Figure, FigureError, LARGEST_WIDTH, Style};
use grafika::geometry::{Closure, CubicBezier, Curve, Method, ParamCurve, Point};
use proptest::prelude::*;
use std::process::{Command, Output};

const BLUE: [u8; 3] = [0, 0, 170];
const GRAY: [u8; 3] = [130, 130, 130];
const WHITE: [u8; 3] = [255, 255, 255];

const STAR: [Point<2>; 5] = [[0.0, 30.0], [90.0, 60.0], [20.0, 0.0], [50.0, 90.0], [75.0, 5.0]];

/// A figure with every kind of item.
fn star() -> Figure {
    let curve = Curve::through(Method::Spline, Closure::Closed, &STAR).unwrap();
    let mut figure = Figure::new();
    figure.set_title("Görbe <5 pont> & \"őű\"");
    let style = Style { fill: Some([230, 240, 255]), ..Style::line(BLUE, 2.0) };
    figure.curve(curve.to_cubics(1e-6).unwrap(), Closure::Closed, style);
    figure.polyline(STAR.to_vec(), Closure::Closed, Style::line(GRAY, 1.0).dashed(6.0, 4.0));
    for (index, &point) in STAR.iter().enumerate() {
        figure.disc(point, 5.0, Style::filled(WHITE, [170, 0, 0]), Some(format!("P{}", index + 1)));
    }
    figure.text([70.0, 40.0], "a < b && c > d");
    figure
}

fn line(arcs: Vec<CubicBezier<2>>, closure: Closure) -> Figure {
    let mut figure = Figure::new();
    figure.curve(arcs, closure, Style::line(BLUE, 2.0));
    figure
}

/// The values of an attribute in the order of the document.
fn attributes<'a>(svg: &'a str, name: &str) -> Vec<&'a str> {
    let opening = format!(" {name}=\"");
    svg.split(&opening).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// The numbers of path data by their commands, as bits.
fn commands(data: &str) -> Vec<(char, Vec<u64>)> {
    let mut commands: Vec<(char, Vec<u64>)> = Vec::new();
    for word in data.split(' ') {
        let letter = word.chars().next().filter(char::is_ascii_alphabetic);
        if let Some(letter) = letter {
            commands.push((letter, Vec::new()));
        }
        let number = if letter.is_some() { &word[1..] } else { word };
        if !number.is_empty() {
            let bits = number.parse::<f64>().expect("a number").to_bits();
            commands.last_mut().expect("data begin with a command").1.push(bits);
        }
    }
    commands
}

/// Checks that a document is well-formed in the part of XML that figures use, and gives its elements.
fn elements(xml: &str) -> Result<Vec<String>, String> {
    let (mut open, mut seen, mut rest) = (Vec::new(), Vec::new(), xml);
    while let Some(start) = rest.find('<') {
        check_text(&rest[..start])?;
        let end = start + rest[start..].find('>').ok_or("a tag without end")?;
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            let opened: Option<String> = open.pop();
            if opened.as_deref() != Some(name) {
                return Err(format!("{name} closes {opened:?}"));
            }
            continue;
        }
        let (inner, empty) = tag.strip_suffix('/').map_or((tag, false), |inner| (inner, true));
        let name = inner.split(' ').next().unwrap_or("").to_string();
        check_attributes(&inner[name.len()..]).map_err(|problem| format!("{name}: {problem}"))?;
        if !empty {
            open.push(name.clone());
        }
        seen.push(name);
    }
    check_text(rest)?;
    if open.is_empty() { Ok(seen) } else { Err(format!("{open:?} stay open")) }
}

fn check_text(text: &str) -> Result<(), String> {
    for part in text.split('&').skip(1) {
        if !["amp;", "lt;", "gt;", "quot;"].iter().any(|entity| part.starts_with(entity)) {
            return Err(format!("no entity: &{part}"));
        }
    }
    let bad = |ch: &char| (ch.is_control() && *ch != '\n') || matches!(ch, '\u{FFFE}' | '\u{FFFF}' | '>');
    text.chars().find(bad).map_or(Ok(()), |ch| Err(format!("{ch:?} in text")))
}

fn check_attributes(mut text: &str) -> Result<(), String> {
    let mut names = Vec::new();
    while !text.is_empty() {
        let (name, rest) = text.split_once("=\"").ok_or_else(|| format!("no attribute: {text}"))?;
        let (value, rest) = rest.split_once('"').ok_or("a value without end")?;
        let name = name.strip_prefix(' ').ok_or("attributes without a blank between")?;
        if names.contains(&name) {
            return Err(format!("{name} twice"));
        }
        names.push(name);
        check_text(value)?;
        text = rest;
    }
    Ok(())
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e3..1e3,
        -1e150..1e150,
        -1e-200..1e-200,
        Just(-0.0),
        Just(1e150),
        (-9_i32..9).prop_map(f64::from)
    ]
}

fn point() -> impl Strategy<Value = Point<2>> {
    prop::array::uniform2(coordinate())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn control_points_read_back_bit_for_bit(
        start in point(), rest in prop::collection::vec(prop::array::uniform3(point()), 1..8), closed: bool,
    ) {
        let mut from = start;
        let mut arcs = Vec::new();
        for [b, c, d] in rest {
            arcs.push(CubicBezier { p: [from, b, c, d] });
            from = d;
        }
        let closure = if closed { Closure::Closed } else { Closure::Open };
        let svg = line(arcs.clone(), closure).to_svg().unwrap();
        let paths = attributes(&svg, "d");
        prop_assert_eq!(paths.len(), 1);
        let bits = |points: &[Point<2>]| points.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
        let mut want = vec![('M', bits(&[start]))];
        want.extend(arcs.iter().map(|arc| ('C', bits(&arc.p[1..]))));
        want.extend(closed.then(|| ('Z', Vec::new())));
        prop_assert_eq!(commands(paths[0]), want);
    }

    #[test]
    fn any_finite_figure_is_written(points in prop::collection::vec(point(), 0..6), text: String, width in 16_u32..200) {
        let mut figure = Figure::new();
        figure.set_title(text.clone());
        figure.polyline(points.clone(), Closure::Closed, Style::line(BLUE, 3.0).dashed(4.0, 2.0));
        for &point in &points {
            figure.disc(point, 4.0, Style::filled(WHITE, BLUE), Some(text.clone()));
            figure.text(point, text.clone());
        }
        let svg = figure.to_svg().unwrap();
        prop_assert!(elements(&svg).is_ok(), "{:?}", elements(&svg));
        for (name, value) in ["cx", "cy", "x", "y"].iter().flat_map(|name| attributes(&svg, name).into_iter().map(move |v| (name, v))) {
            prop_assert!(value.parse::<f64>().unwrap().is_finite(), "{name} {value}");
        }
        prop_assert_eq!(pictures::decode(&figure.to_png(width).unwrap()).width, width as usize);
    }
}

#[test]
fn spline_is_one_path_of_its_arcs() {
    for (closure, end) in [(Closure::Closed, 'Z'), (Closure::Open, 'C')] {
        let arcs = Curve::through(Method::Spline, closure, &STAR).unwrap().to_cubics(1e-6).unwrap();
        let svg = line(arcs.clone(), closure).to_svg().unwrap();
        let found = commands(attributes(&svg, "d")[0]);
        assert_eq!(found.iter().filter(|(letter, _)| *letter == 'C').count(), arcs.len());
        assert_eq!((found[0].0, found.last().unwrap().0), ('M', end));
    }
}

#[test]
fn interrupted_rows_are_taken_up_anew() {
    let arc = |x: f64| CubicBezier { p: [[x, 0.0], [x, 1.0], [x + 1.0, 1.0], [x + 1.0, 0.0]] };
    let svg = line(vec![arc(0.0), arc(1.0 + 1e-15), arc(5.0)], Closure::Open).to_svg().unwrap();
    let letters: String = commands(attributes(&svg, "d")[0]).iter().map(|(letter, _)| *letter).collect();
    assert_eq!(letters, "MCCMC");
}

#[test]
fn svg_maps_the_world_to_where_the_discs_stand() {
    let svg = star().to_svg().unwrap();
    let matrix = attributes(&svg, "transform")[0].trim_start_matches("matrix(").trim_end_matches(')');
    let matrix: Vec<f64> = matrix.split(' ').map(|number| number.parse().unwrap()).collect();
    let numbers = |name| attributes(&svg, name).into_iter().map(|x| x.parse::<f64>().unwrap());
    let discs: Vec<(f64, f64)> = numbers("cx").zip(numbers("cy")).collect();
    for ([x, y], (cx, cy)) in STAR.into_iter().zip(discs) {
        assert!(
            (matrix[0] * x + matrix[4] - cx).abs() < 1e-9 && (matrix[3] * y + matrix[5] - cy).abs() < 1e-9
        );
    }
    assert_eq!((matrix[1], matrix[2], matrix[0]), (0.0, 0.0, -matrix[3]));
}

#[test]
fn svg_is_well_formed_and_holds_every_item() {
    let svg = star().to_svg().unwrap();
    let count = |name: &str| elements(&svg).unwrap().iter().filter(|found| *found == name).count();
    assert_eq!(["svg", "title", "path", "circle", "text"].map(count), [1, 1, 2, 5, 7]);
    assert!(svg.contains("<title>Görbe &lt;5 pont&gt; &amp; \"őű\"</title>"));
    assert!(svg.contains(">a &lt; b &amp;&amp; c &gt; d</text>"));
    assert!(elements("<a><b></a>").is_err() && elements("<a x=\"1\" x=\"2\"/>").is_err());
    assert!(elements("<a>& b</a>").is_err() && elements("<a>").is_err());
}

#[test]
fn png_is_the_golden_picture() {
    pictures::assert_golden_png("figure_star", &star().to_png(500).unwrap());
    pictures::assert_golden_png("figure_star_small", &star().to_png(160).unwrap());
}

#[test]
fn figures_are_written_the_same_every_time() {
    assert_eq!(star().to_svg(), star().to_svg());
    assert_eq!(star().to_png(300), star().to_png(300));
}

/// Bands of rows leave no trace: the large picture, reduced, is the small one.
#[test]
fn large_pictures_look_like_small_ones() {
    let (small, large) = (star().to_png(600).unwrap(), star().to_png(4800).unwrap());
    let (small, large) = (pictures::decode(&small), pictures::decode(&large));
    assert_eq!(large.height.div_ceil(8), small.height);
    let mut far = 0;
    for (index, pixel) in small.rgb.iter().enumerate() {
        let (x, y) = (index % small.width * 8, index / small.width * 8);
        let rows = (y..(y + 8).min(large.height)).map(|y| &large.rgb[y * large.width + x..][..8]);
        let values: Vec<u32> = rows.flatten().map(|rgb| u32::from(rgb[0])).collect();
        let mean = values.iter().sum::<u32>() / values.len() as u32;
        far += usize::from(mean.abs_diff(u32::from(pixel[0])) > 48);
    }
    // Letters stand on whole pixels and differ a little.
    assert!(far < 900, "{far} pixels are far off");
}

#[test]
fn far_and_tiny_windows_keep_their_shape() {
    let picture = |offset: f64, scale: f64| {
        let mut figure = Figure::new();
        let points = STAR.map(|[x, y]| [offset + scale * x, offset + scale * y]).to_vec();
        figure.polyline(points, Closure::Open, Style::line(BLUE, 2.0));
        pictures::decode(&figure.to_png(100).unwrap()).rgb
    };
    let plain = picture(0.0, 1.0);
    for (offset, scale) in [(1e6, 1.0), (0.0, 1e-140), (0.0, 1e140), (1e12, 1.0)] {
        let differing =
            picture(offset, scale).iter().zip(&plain).filter(|(a, b)| a[0].abs_diff(b[0]) > 8).count();
        assert_eq!(differing, 0, "{offset} {scale}");
    }
}

#[test]
fn nothing_and_single_points_are_pictures() {
    let empty = Figure::new();
    assert_eq!(elements(&empty.to_svg().unwrap()).unwrap(), ["svg", "rect"]);
    assert!(pictures::decode(&empty.to_png(16).unwrap()).rgb.iter().all(|rgb| *rgb == WHITE));
    let nothing = line(Vec::new(), Closure::Closed);
    assert!(!nothing.to_svg().unwrap().contains("<path"));
    for at in [[0.0, 0.0], [1e150, -1e150], [1e-320, 0.0], [7.0, 9.0]] {
        let mut dot = Figure::new();
        dot.disc(at, 10.0, Style::filled([255, 0, 0], [255, 0, 0]), None);
        let picture = pictures::decode(&dot.to_png(100).unwrap());
        assert_eq!(picture.rgb[picture.height / 2 * 100 + 50], [255, 0, 0], "{at:?}");
    }
}

#[test]
fn bad_numbers_are_errors_that_name_the_item() {
    let message = |figure: &Figure| {
        let error = figure.to_svg().unwrap_err();
        assert_eq!(figure.to_png(100).unwrap_err().to_string(), error.to_string());
        error.to_string()
    };
    let mut figure = line(vec![CubicBezier { p: [[0.0; 2]; 4] }; 3], Closure::Open);
    assert!(figure.to_svg().is_ok());
    figure.curve(vec![CubicBezier { p: [[0.0, f64::NAN]; 4] }], Closure::Open, Style::line(BLUE, 1.0));
    assert_eq!(message(&figure), "curve 2, arc 1: coordinate NaN is not a finite number");
    let mut figure = Figure::new();
    figure.polyline(vec![[0.0; 2], [f64::INFINITY, 0.0]], Closure::Open, Style::line(BLUE, 1.0));
    assert_eq!(message(&figure), "polyline 1, point 2: coordinate inf is not a finite number");
    let mut figure = Figure::new();
    figure.text([0.0, -1e200], "far");
    assert_eq!(message(&figure), "text 1: coordinate -1e200 is too large; at most 1e150");
    let mut figure = Figure::new();
    figure.disc([0.0; 2], -1.0, Style::line(BLUE, 1.0), None);
    assert_eq!(message(&figure), "disc 1: radius is -1, must be 0 to 100 pixels");
    for style in
        [Style::line(BLUE, f64::NAN), Style::line(BLUE, 1.0).dashed(0.1, 0.1), Style::line(BLUE, 101.0)]
    {
        let mut figure = Figure::new();
        figure.polyline(Vec::new(), Closure::Open, style);
        assert!(matches!(figure.to_svg(), Err(FigureError::Style { .. })));
    }
}

#[test]
fn widths_have_limits() {
    for given in [0, 15, LARGEST_WIDTH + 1, u32::MAX] {
        let error = star().to_png(given).unwrap_err();
        assert_eq!(error, FigureError::Width { given, least: 16, most: 16384 });
        assert_eq!(star().to_svg_of_width(given).unwrap_err(), error);
        assert!(error.to_string().ends_with("must be 16 to 16384"));
    }
    let svg = star().to_svg_of_width(1600).unwrap();
    assert_eq!((attributes(&svg, "width")[0], &attributes(&svg, "viewBox")[0][..8]), ("1600", "0 0 800 "));
}

/// Runs `grafika render` in a folder of build results.
fn render(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
    command
        .current_dir(env!("CARGO_TARGET_TMPDIR"))
        .arg("render")
        .args(arguments)
        .output()
        .expect("it starts")
}

fn rendered(file: &str, arguments: &[&str]) -> Vec<u8> {
    let output = render(&[arguments, &["-o", file]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    std::fs::read(std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(file)).unwrap()
}

#[test]
fn files_are_rendered() {
    let six = common::path("files/SIX.IP2").display().to_string();
    let cube = common::path("files/CUBE.IP3").display().to_string();
    let plane = ["--closed", "--method", "spline", "--points", "--polygon", "--title", "Spline"];
    let png = rendered("six.png", &[&[six.as_str(), "--width", "400"], &plane[..]].concat());
    pictures::assert_golden_png("figure_render_plane", &png);
    let png =
        rendered("cube.PNG", &[&cube, "--method", "bspline3", "--points", "--polygon", "--width", "400"]);
    pictures::assert_golden_png("figure_render_space", &png);
    let svg = String::from_utf8(rendered("six.svg", &[&[six.as_str()], &plane[..]].concat())).unwrap();
    assert_eq!(elements(&svg).unwrap().iter().filter(|name| *name == "circle").count(), 6);
    assert!(attributes(&svg, "d").iter().all(|data| data.starts_with("M60 80 ") && data.ends_with(" Z")));
    rendered("bezier.svg", &[&six, "--method", "bezier"]);
    // Multiple points are one disc with all their numbers.
    let svg =
        String::from_utf8(rendered("multiple.svg", &["D.IP2", "--method", "bspline3", "--points"])).unwrap();
    assert_eq!(elements(&svg).unwrap().iter().filter(|name| *name == "circle").count(), 5);
    assert!(svg.contains(">2-3<") && svg.contains(">4-6<") && !svg.contains(">5<"), "{svg}");
    rendered("turned.svg", &[&cube, "--method", "spline", "--view", "-1,0.5,2"]);
    // The top views of (4.17): the axis y is to the right, and x goes down from above, up from below.
    let top = |view: &str| {
        let svg = rendered("top.svg", &[&cube, "--method", "bezier", "--view", view, "--points"]);
        let svg = String::from_utf8(svg).unwrap();
        attributes(&svg, "d").into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(top("0,0,1"), top("0,0,7"));
    assert_eq!(top("0,0,1"), top("-0,-0,1"));
    assert_ne!(top("0,0,1"), top("0,0,-1"));
}

#[test]
fn wrong_command_lines_are_usage_errors() {
    let six = common::path("files/SIX.IP2").display().to_string();
    let cases: [(&[&str], &str); 6] = [
        (&["-o", "a.gif"], ".png .svg .pdf"),
        (&["-o", "-"], ".png .svg .pdf"),
        (&[], "--output"),
        (&["-o", "a.png", "--width", "15"], "16 to 16384"),
        (&["-o", "a.png", "--view", "1,2,3"], "space curves"),
        (&["-o", "a.png", "--view", "0,0,0"], "three numbers"),
    ];
    for (arguments, said) in cases {
        let output = render(&[&[six.as_str(), "--method", "spline"], arguments].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{message}");
        assert!(message.contains(said), "{message}");
    }
}
