//! Axes, captions and PDF: what a textbook wants to see, read back by a reader of its own.

#![cfg(feature = "native")]

mod common;

use common::pictures;
use grafika::figure::{Axes, CURVE_INK, Figure, FigureError, LONGEST_CAPTION, Style};
use grafika::geometry::{BoundingBox, Closure, Curve, Method, ParamCurve, Point, View};
use proptest::prelude::*;
use std::process::Command;

const POINTS: [Point<2>; 5] = [[0.0, 30.0], [90.0, 60.0], [20.0, 0.0], [50.0, 90.0], [75.0, 5.0]];

fn figure() -> Figure {
    let curve = Curve::through(Method::Spline, Closure::Closed, &POINTS).unwrap();
    let mut figure = Figure::new();
    figure.set_title("Zárt spline: ő, ű");
    figure.set_caption("2.14. ábra. Egy zárt harmadfokú spline öt ponton át; minden csatlakozásban kétszer folytonosan deriválható.");
    figure.set_axes(Axes::Plane);
    figure.plot_polygon(POINTS.to_vec(), Closure::Closed);
    figure.plot_curve(&curve, CURVE_INK).unwrap();
    figure.plot_points(&POINTS);
    figure
}

/// The attribute `name` of every element, as numbers.
fn numbers(svg: &str, name: &str) -> Vec<f64> {
    let opening = format!(" {name}=\"");
    let values = svg.split(&opening).skip(1).filter_map(|rest| rest.split('"').next());
    values.filter_map(|value| value.parse().ok()).collect()
}

/// The map from the world to nominal pixels.
fn matrix(svg: &str) -> [f64; 6] {
    let inner = svg.split("matrix(").nth(1).unwrap().split(')').next().unwrap();
    let numbers: Vec<f64> = inner.split(' ').map(|number| number.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

#[test]
fn golden_pictures_of_axes() {
    pictures::assert_golden_png("figure_axes", &figure().to_png(500).unwrap());
    let mut space = Figure::new();
    let view = View::from_direction([0.7, 0.2, 0.3]);
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.5], [2.0, 3.0, 0.0], [0.0, 3.0, 1.0]];
    space.polyline(
        corners.map(|corner| view.place(corner)).to_vec(),
        Closure::Closed,
        Style::line([0; 3], 2.0),
    );
    space.set_axes(Axes::Space { view, bounds: BoundingBox::of_points(&corners).unwrap() });
    pictures::assert_golden_png("figure_axes_space", &space.to_png(500).unwrap());
}

#[test]
fn numbers_stand_at_their_ticks() {
    let svg = figure().to_svg().unwrap();
    let [scale, _, _, _, x, y] = matrix(&svg);
    let texts: Vec<(String, f64, f64)> = svg
        .split("<text ")
        .skip(1)
        .map(|rest| {
            let text = rest.split('>').nth(1).unwrap().split('<').next().unwrap();
            (text.to_string(), numbers(&format!(" {rest}"), "x")[0], numbers(&format!(" {rest}"), "y")[0])
        })
        .collect();
    // The advance of a letter at the size of the numbers.
    let advance = 13.0 * 1233.0 / 2048.0;
    for number in ["20", "40", "60", "80", "100"] {
        let value: f64 = number.parse().unwrap();
        let middle = |left: f64| left + advance * number.len() as f64 / 2.0;
        let under_x = texts
            .iter()
            .any(|(text, left, _)| text == number && (middle(*left) - (x + scale * value)).abs() < 1e-6);
        let beside_y =
            texts.iter().any(|(text, _, base)| text == number && (base - (y - scale * value)).abs() < 6.0);
        assert!(under_x && beside_y, "{number}: {texts:?}");
    }
    for name in ["x", "y"] {
        assert!(texts.iter().any(|(text, ..)| text == name));
    }
    // The caption stands below everything, in two lines.
    let lowest = texts
        .iter()
        .filter(|(text, ..)| !text.contains("ábra") && !text.contains("deriv"))
        .map(|(_, _, y)| *y);
    let lowest = lowest.fold(0.0, f64::max);
    assert_eq!(texts.iter().filter(|(_, _, y)| *y > lowest).count(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn any_figure_has_axes_or_none_in_every_format(
        points in prop::collection::vec(prop::array::uniform3(prop_oneof![-1e3..1e3, -1e150..1e150, -1e-200..1e-200, Just(0.0), 1e12..1.000001e12]), 0..5),
        space: bool, caption: String,
    ) {
        let mut figure = Figure::new();
        let view = View::from_direction([0.3, 0.5, 0.4]);
        let place = |p: &Point<3>| if space { view.place(*p) } else { [p[0], p[1]] };
        figure.polyline(points.iter().map(place).collect(), Closure::Open, Style::line([0; 3], 1.0));
        let bounds = BoundingBox::of_points(&points).unwrap_or(BoundingBox::of_point([0.0; 3]));
        figure.set_axes(if space { Axes::Space { view, bounds } } else { Axes::Plane });
        figure.set_caption(caption.clone());
        // A projected coordinate may be beyond the limit.
        if let Ok(svg) = figure.to_svg() {
            for name in ["x", "y", "height"] {
                prop_assert!(numbers(&svg, name).iter().all(|value| value.is_finite()));
            }
            prop_assert!(!svg.contains("NaN") && !svg.contains("inf"));
            prop_assert_eq!(pictures::decode(&figure.to_png(40).unwrap()).width, 40);
            let pdf = Pdf::read(&figure.to_pdf().unwrap());
            prop_assert!(!pdf.content.contains("NaN") && !pdf.content.contains("inf"));
        }
    }
}

#[test]
fn a_caption_has_its_limit() {
    let mut figure = figure();
    figure.set_caption("ő".repeat(LONGEST_CAPTION));
    assert!(figure.to_svg().is_ok());
    figure.set_caption("ő".repeat(LONGEST_CAPTION + 1));
    assert_eq!(figure.to_pdf(), Err(FigureError::Caption { given: 2001, most: 2000 }));
}

/// A document as far as figures need it: what the cross-reference table points at, and the page's drawing.
struct Pdf {
    objects: Vec<String>,
    content: String,
}

impl Pdf {
    fn read(bytes: &[u8]) -> Pdf {
        // As many characters as bytes.
        let ascii = |&byte: &u8| if byte.is_ascii() { char::from(byte) } else { '?' };
        let text: String = bytes.iter().map(ascii).collect();
        assert!(text.starts_with("%PDF-1.") && text.trim_end().ends_with("%%EOF"));
        let after = |text: &str, mark: &str| text.rsplit(mark).next().unwrap().trim().to_string();
        let table: usize = after(&text, "startxref").lines().next().unwrap().parse().unwrap();
        let lines: Vec<&str> = text[table..].lines().map(str::trim).collect();
        assert_eq!(lines[0], "xref");
        let count: usize = lines[1].split(' ').nth(1).unwrap().parse().unwrap();
        let mut objects = Vec::new();
        for (number, line) in (1..count).zip(&lines[3..]) {
            assert!(line.ends_with(" n"), "{line}");
            let from: usize = line.split(' ').next().unwrap().parse().unwrap();
            let object = text[from..].split("endobj").next().unwrap();
            assert!(object.starts_with(&format!("{number} 0 obj")), "{object}");
            objects.push(object.to_string());
        }
        let stream = objects.iter().find(|object| object.contains("/FlateDecode")).expect("a page is drawn");
        let length = stream.split("/Length ").nth(1).unwrap().split(['\n', ' ', '/']).next().unwrap();
        let length: usize = length.parse().unwrap();
        let start = text.find("stream\n").unwrap() + "stream\n".len();
        let packed = &bytes[start..start + length];
        let content = miniz_oxide::inflate::decompress_to_vec_zlib(packed).expect("zlib");
        Pdf { objects, content: String::from_utf8(content).expect("operators are ASCII") }
    }

    /// The operands of an operator wherever it stands.
    fn operands(&self, operator: &str) -> Vec<Vec<f64>> {
        let mut found = Vec::new();
        for line in self.content.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            if words.last() == Some(&operator) {
                found.push(
                    words[..words.len() - 1].iter().map(|word| word.parse().expect("a number")).collect(),
                );
            }
        }
        found
    }
}

#[test]
fn a_pdf_is_the_same_drawing() {
    let (pdf, svg) = (Pdf::read(&figure().to_pdf().unwrap()), figure().to_svg().unwrap());
    let [scale, _, _, _, x, y] = matrix(&svg);
    let arcs = Curve::through(Method::Spline, Closure::Closed, &POINTS).unwrap().to_cubics(1e-6).unwrap();
    // The arcs come before the circles and the letters.
    for (arc, found) in arcs.iter().zip(pdf.operands("c")) {
        let wanted = arc.p[1..].iter().flat_map(|[px, py]| [x + scale * px, y - scale * py]);
        for (wanted, found) in wanted.zip(found) {
            assert!((wanted - found).abs() < 1e-3, "{wanted} {found}");
        }
    }
    // Five circles of four arcs; letters are outlines and no text.
    assert!(pdf.operands("c").len() > arcs.len() + 20);
    assert!(!pdf.content.contains("BT") && !pdf.objects.iter().any(|object| object.contains("/Font")));
    let size = |object: &String| {
        object.contains(&format!("/MediaBox [0 0 600 {}]", numbers(&svg, "height")[0] * 0.75))
    };
    assert!(pdf.objects.iter().any(size), "{:?}", pdf.objects);
    assert!(pdf.content.starts_with("0.75 0 0 -0.75 0 "));
}

#[test]
fn a_pdf_of_another_width_is_the_same_page_enlarged() {
    let pdf = Pdf::read(&figure().to_pdf_of_width(1600).unwrap());
    assert!(pdf.content.starts_with("1.5 0 0 -1.5 0 "));
    assert!(matches!(figure().to_pdf_of_width(15), Err(FigureError::Width { .. })));
    assert_eq!(figure().to_pdf(), figure().to_pdf());
    let screen = Pdf::read(&grafika::figure::screen_pdf(&grafika::screen::Screen::new()));
    assert_eq!(screen.operands("re"), [[0.0, 0.0, 640.0, 480.0]]);
}

/// Runs `grafika render` in the folder of build results.
fn render(arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
    let output = command.current_dir(env!("CARGO_TARGET_TMPDIR")).arg("render").args(arguments).output();
    let output = output.expect("it starts");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn the_command_line_draws_axes_and_captions() {
    let six = common::path("files/SIX.IP2").display().to_string();
    let around = ["--axes", "--caption", "Egy görbe", "--title", "Görbe"];
    for file in ["axes.svg", "axes.png", "axes.pdf"] {
        let (status, message) = render(&[&[&six, "--method", "spline", "-o", file], &around[..]].concat());
        assert_eq!(status, Some(0), "{message}");
    }
    let read =
        |name: &str| std::fs::read(std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)).unwrap();
    let svg = String::from_utf8(read("axes.svg")).unwrap();
    assert!(svg.contains(">Egy görbe<") && svg.contains("class=\"axes\""));
    assert!(!Pdf::read(&read("axes.pdf")).content.is_empty());
    let (status, message) = render(&["A.ZYS", "-o", "axes.stl", "--axes"]);
    assert_eq!(status, Some(2), "{message}");
    let cube = common::path("files/CUBE.IP3").display().to_string();
    assert_eq!(render(&[&cube, "--method", "spline", "-o", "cube_axes.svg", "--axes"]).0, Some(0));
    assert!(String::from_utf8(read("cube_axes.svg")).unwrap().contains(">z<"));
}
