//! Comparing pictures: pixel by pixel with golden ones, by agreement with the originals' screens.

use grafika::screen::{Color, HEIGHT, Screen, WIDTH};
use std::fmt;
use std::path::{Path, PathBuf};

/// A picture of 640x480 colour numbers.
pub type Pixels = Vec<u8>;

/// The 16-colour pixels of a PNG of 640x480; every colour becomes the nearest of the palette.
pub fn read(path: &Path) -> Pixels {
    let file = std::fs::File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut decoder = png::Decoder::new(std::io::BufReader::new(file));
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut buffer = vec![0; reader.output_buffer_size().expect("a PNG of this size")];
    let info = reader.next_frame(&mut buffer).expect("a whole PNG");
    assert_eq!((info.width as i32, info.height as i32), (WIDTH, HEIGHT), "{}", path.display());
    let samples = info.color_type.samples();
    let nearest = |rgb: [u8; 3]| {
        let distance = |color: &Color| -> u32 {
            color.rgb().iter().zip(rgb).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
        };
        Color::ALL.iter().min_by_key(|color| distance(color)).expect("there are colours").index()
    };
    buffer[..info.buffer_size()]
        .chunks_exact(samples)
        .map(
            |pixel| {
                if samples >= 3 { nearest([pixel[0], pixel[1], pixel[2]]) } else { nearest([pixel[0]; 3]) }
            },
        )
        .collect()
}

/// Where two pictures differ.
#[derive(Debug, PartialEq, Eq)]
pub struct Difference {
    pub pixels: usize,
    /// Left, upper, right and lower edge of the area that holds all of them.
    pub area: [usize; 4],
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x1, y1, x2, y2] = self.area;
        write!(f, "{} pixels differ, all within ({x1},{y1})-({x2},{y2})", self.pixels)
    }
}

/// The difference of two pictures, if there is one.
pub fn difference(ours: &[u8], theirs: &[u8]) -> Option<Difference> {
    let width = WIDTH as usize;
    let places = ours.iter().zip(theirs).enumerate().filter(|(_, (a, b))| a != b);
    let places: Vec<(usize, usize)> = places.map(|(index, _)| (index % width, index / width)).collect();
    let bounds = |of: fn(&(usize, usize)) -> usize| {
        let values = || places.iter().map(of);
        (values().min().unwrap_or(0), values().max().unwrap_or(0))
    };
    let ((x1, x2), (y1, y2)) = (bounds(|place| place.0), bounds(|place| place.1));
    (!places.is_empty()).then_some(Difference { pixels: places.len(), area: [x1, y1, x2, y2] })
}

/// How many of all pixels agree, 0 to 1.
pub fn agreement(ours: &[u8], theirs: &[u8]) -> f64 {
    let differing = difference(ours, theirs).map_or(0, |difference| difference.pixels);
    1.0 - differing as f64 / theirs.len() as f64
}

/// Compares a screen with the golden picture `tests/golden/NAME.png`. With `UPDATE_PICTURES=1` the
/// golden picture becomes what the screen shows.
pub fn assert_golden(name: &str, screen: &Screen) {
    let path = super::path("golden").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        let png = grafika::figure::screen_png(screen).expect("a screen is a picture");
        std::fs::write(&path, png).expect("the golden picture can be written");
    }
    if let Err(problem) = compare(name, screen, &path) {
        panic!("{problem}");
    }
}

/// Compares a screen with a picture; a difference is told with where both lie side by side.
pub fn compare(name: &str, screen: &Screen, golden: &Path) -> Result<(), String> {
    let theirs = read(golden);
    match difference(screen.pixels(), &theirs) {
        None => Ok(()),
        Some(difference) => {
            let kept = keep_both(name, screen.pixels(), &theirs);
            Err(format!("{name}: {difference}; ours and the golden one: {}", kept.display()))
        }
    }
}

/// Writes two pictures side by side into the folder of build results.
pub fn keep_both(name: &str, ours: &[u8], theirs: &[u8]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    let width = WIDTH as usize;
    let rows = ours.chunks(width).zip(theirs.chunks(width));
    let rgb: Vec<u8> = rows
        .flat_map(|(ours, theirs)| ours.iter().chain(theirs))
        .flat_map(|&index| Color::from_index(index).rgb())
        .collect();
    let file = std::fs::File::create(&path).expect("build results can be written");
    let mut encoder = png::Encoder::new(file, 2 * WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a PNG header");
    writer.write_image_data(&rgb).expect("a PNG");
    path
}
