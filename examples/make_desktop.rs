//! Makes the files in `data/desktop/`: `cargo run --example make_desktop [FOLDER]`.
//!
//! The icon is drawn on the screen of the programs, in its 16 colours: a smooth curve with its control points on
//! the light cyan of the editors. It is 64x64 pixels; the large PNG doubles them and the SVG has a rectangle for
//! every run of one colour. The types of files come from the table of the data files. The same bytes come out
//! every time.

use grafika::file::{CloudFormat, Format};
use grafika::geometry::{Closure, Curve, Method, ParamCurve};
use grafika::screen::{Color, Screen, Stroke};
use std::fmt::Write;
use std::path::Path;

/// Width and height of the icon in pixels.
const SIZE: i32 = 64;

/// The curve's control points.
const POINTS: [[f64; 2]; 5] = [[11.0, 47.0], [17.0, 15.0], [32.0, 37.0], [46.0, 13.0], [53.0, 48.0]];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "data/desktop".to_owned());
    std::fs::create_dir_all(&folder)?;
    for (name, content) in files()? {
        std::fs::write(Path::new(&folder).join(name), content)?;
    }
    Ok(())
}

/// A file: its name and its content.
type File = (&'static str, Vec<u8>);

/// Every file.
pub(crate) fn files() -> Result<Vec<File>, Box<dyn std::error::Error>> {
    let icon = icon()?;
    Ok(vec![
        ("grafika-64.png", png(&icon, 1)?),
        ("grafika-128.png", png(&icon, 2)?),
        ("grafika.svg", svg(&icon).into_bytes()),
        ("grafika.desktop", desktop().into_bytes()),
        ("grafika.xml", types().into_bytes()),
    ])
}

/// The upper left corner of a screen with the icon.
fn icon() -> Result<Screen, Box<dyn std::error::Error>> {
    let mut screen = Screen::new();
    let last = SIZE - 1;
    screen.bar(0, 0, last, last, Color::LightCyan);
    // The sunken frame of a field.
    screen.bar(4, 4, last - 4, last - 4, Color::Black);
    let (dark, light) = (Stroke::thin(Color::DarkGray), Stroke::thin(Color::White));
    for inset in 2..4 {
        let far = last - inset;
        screen.line(inset, inset, far, inset, dark);
        screen.line(inset, inset, inset, far, dark);
        screen.line(inset, far, far, far, light);
        screen.line(far, inset, far, far, light);
    }
    let pixel = |[x, y]: [f64; 2]| (x.round() as i32, y.round() as i32);
    for pair in POINTS.windows(2) {
        let ((x1, y1), (x2, y2)) = (pixel(pair[0]), pixel(pair[1]));
        screen.line(x1, y1, x2, y2, Stroke::thin(Color::DarkGray));
    }
    let curve = Curve::through(Method::Spline, Closure::Open, &POINTS)?;
    let samples: Vec<_> = curve.sample(24)?.iter().map(|sample| pixel(sample.point)).collect();
    for pair in samples.windows(2) {
        let ((x1, y1), (x2, y2)) = (pair[0], pair[1]);
        screen.line(x1, y1, x2, y2, Stroke::thick(Color::Yellow));
    }
    for (x, y) in POINTS.map(pixel) {
        screen.bar(x - 3, y - 3, x + 3, y + 3, Color::White);
        screen.bar(x - 2, y - 2, x + 2, y + 2, Color::LightRed);
    }
    Ok(screen)
}

fn color(screen: &Screen, x: i32, y: i32) -> Color {
    screen.pixel(x, y).unwrap_or_default()
}

/// The icon as a PNG with the palette of the screen, every pixel `scale` wide and high.
fn png(screen: &Screen, scale: i32) -> Result<Vec<u8>, png::EncodingError> {
    let side = SIZE * scale;
    let pixels = (0..side).flat_map(|y| (0..side).map(move |x| (x / scale, y / scale)));
    let pixels: Vec<u8> = pixels.map(|(x, y)| color(screen, x, y).index()).collect();
    let packed: Vec<u8> = pixels.chunks(2).map(|pair| pair[0] << 4 | pair[1]).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, side.unsigned_abs(), side.unsigned_abs());
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Four);
    encoder.set_palette(Color::ALL.iter().flat_map(|color| color.rgb()).collect::<Vec<u8>>());
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&packed)?;
    writer.finish()?;
    Ok(file)
}

/// The icon as an SVG: a rectangle for every run of one colour in a row.
fn svg(screen: &Screen) -> String {
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {SIZE} {SIZE}\" shape-rendering=\"crispEdges\">\n"
    );
    for y in 0..SIZE {
        let mut x = 0;
        while x < SIZE {
            let ink = color(screen, x, y);
            let width = (x..SIZE).take_while(|&right| color(screen, right, y) == ink).count();
            let [r, g, b] = ink.rgb();
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"1\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>"
            );
            x += width as i32;
        }
    }
    text + "</svg>\n"
}

/// The formats of our own; desktops know those of clouds, which are other programs'.
pub(crate) fn own_formats() -> impl Iterator<Item = Format> {
    Format::ALL.iter().copied().filter(|&format| CloudFormat::of(format).is_none())
}

/// The name of the type of a data file.
fn mime(format: Format) -> String {
    format!("application/x-grafika-{}", format.extension().to_lowercase())
}

/// The entry of the desktop's menu.
fn desktop() -> String {
    let types: String = own_formats().map(|format| mime(format) + ";").collect();
    format!(
        "[Desktop Entry]
Type=Application
Name=Grafika
Comment=Curves, surfaces, games and puzzles of the book Interaktív grafika
Comment[hu]=Az Interaktív grafika könyv görbéi, felületei, játékai és fejtörői
Exec=grafika open %f
TryExec=grafika
Icon=grafika
Terminal=false
Categories=Education;Science;Math;Graphics;
Keywords=curve;spline;surface;billiards;puzzle;
MimeType={types}
"
    )
}

/// The types of the data files.
fn types() -> String {
    let mut text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<mime-info xmlns=\"http://www.freedesktop.org/standards/shared-mime-info\">
"
    .to_owned();
    for format in own_formats() {
        let _ = writeln!(
            text,
            "  <mime-type type=\"{}\">
    <comment>{} (Grafika)</comment>
    <comment xml:lang=\"hu\">{} (Grafika)</comment>
    <icon name=\"grafika\"/>
    <glob pattern=\"*.{}\"/>
  </mime-type>",
            mime(format),
            format.english(),
            format.hungarian(),
            format.extension().to_lowercase()
        );
    }
    text + "</mime-info>\n"
}
