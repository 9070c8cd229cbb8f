//! Comparing pictures: pixel by pixel with golden ones, by agreement with the originals' screens.

use grafika::screen::{Color, HEIGHT, Screen, WIDTH};
use std::fmt;
use std::path::{Path, PathBuf};

/// A picture of 640x480 colour numbers.
pub(crate) type Pixels = Vec<u8>;

/// A picture of any size.
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// Red, green and blue, row by row from the top left.
    pub(crate) rgb: Vec<[u8; 3]>,
}

/// How far a channel may be off before a pixel of a smoothed picture differs: processors round
/// differently.
const ROUNDING: u8 = 4;

/// The pixels of a PNG.
pub(crate) fn decode(png: &[u8]) -> Picture {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut buffer = vec![0; reader.output_buffer_size().expect("a PNG of this size")];
    let info = reader.next_frame(&mut buffer).expect("a whole PNG");
    let samples = info.color_type.samples();
    let rgb = |pixel: &[u8]| if samples >= 3 { [pixel[0], pixel[1], pixel[2]] } else { [pixel[0]; 3] };
    let rgb = buffer[..info.buffer_size()].chunks_exact(samples).map(rgb).collect();
    Picture { width: info.width as usize, height: info.height as usize, rgb }
}

/// The 16-colour pixels of a PNG of 640x480; every colour becomes the nearest of the palette.
pub(crate) fn read(path: &Path) -> Pixels {
    let picture = decode(&content(path));
    assert_eq!((picture.width as i32, picture.height as i32), (WIDTH, HEIGHT), "{}", path.display());
    let nearest = |rgb: [u8; 3]| {
        let distance = |color: &Color| -> u32 {
            color.rgb().iter().zip(rgb).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
        };
        Color::ALL.iter().min_by_key(|color| distance(color)).expect("there are colours").index()
    };
    // A screen has few colours, and most pixels have the colour of the one before.
    let mut known = vec![([0; 3], nearest([0; 3]))];
    let mut last = 0;
    let index = |&rgb: &[u8; 3]| {
        if known[last].0 != rgb {
            last = known.iter().position(|it| it.0 == rgb).unwrap_or(known.len());
        }
        if last == known.len() {
            known.push((rgb, nearest(rgb)));
        }
        known[last].1
    };
    picture.rgb.iter().map(index).collect()
}

fn content(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Where two pictures differ.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Difference {
    pub(crate) pixels: usize,
    /// Left, upper, right and lower edge of the area that holds all of them.
    pub(crate) area: [usize; 4],
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x1, y1, x2, y2] = self.area;
        write!(f, "{} pixels differ, all within ({x1},{y1})-({x2},{y2})", self.pixels)
    }
}

/// The difference of two screens, if there is one.
pub(crate) fn difference(ours: &[u8], theirs: &[u8]) -> Option<Difference> {
    difference_by(ours, theirs, WIDTH as usize, |a, b| a != b)
}

/// The difference of two pictures of the same size.
fn difference_by<T>(
    ours: &[T],
    theirs: &[T],
    width: usize,
    differ: impl Fn(&T, &T) -> bool,
) -> Option<Difference> {
    let places = ours.iter().zip(theirs).enumerate().filter(|(_, (a, b))| differ(a, b));
    let places: Vec<(usize, usize)> = places.map(|(index, _)| (index % width, index / width)).collect();
    let bounds = |of: fn(&(usize, usize)) -> usize| {
        let values = || places.iter().map(of);
        (values().min().unwrap_or(0), values().max().unwrap_or(0))
    };
    let ((x1, x2), (y1, y2)) = (bounds(|place| place.0), bounds(|place| place.1));
    (!places.is_empty()).then_some(Difference { pixels: places.len(), area: [x1, y1, x2, y2] })
}

/// How many of all pixels agree, 0 to 1.
pub(crate) fn agreement(ours: &[u8], theirs: &[u8]) -> f64 {
    let differing = difference(ours, theirs).map_or(0, |difference| difference.pixels);
    1.0 - differing as f64 / theirs.len() as f64
}

/// The part of the screen that holds the picture on the programs' desks: columns and rows.
const PICTURE: [std::ops::Range<usize>; 2] = [29..634, 58..463];

/// How many pixels of the picture area have no pixel of their colour within one pixel in the other
/// screen, counted both ways. A line that is drawn a little otherwise has next to none; a line that is
/// in one picture only has nearly all of its own.
pub(crate) fn strays(ours: &[u8], theirs: &[u8]) -> usize {
    let [columns, rows] = PICTURE;
    let near =
        |at: usize, range: &std::ops::Range<usize>| at.max(range.start + 1) - 1..(at + 2).min(range.end);
    let one_way = |from: &[u8], to: &[u8]| {
        let is_stray = |x: usize, y: usize| {
            let color = from[y * WIDTH as usize + x];
            !near(y, &rows).any(|y| near(x, &columns).any(|x| to[y * WIDTH as usize + x] == color))
        };
        rows.clone().map(|y| columns.clone().filter(|&x| is_stray(x, y)).count()).sum::<usize>()
    };
    one_way(ours, theirs) + one_way(theirs, ours)
}

/// Compares a screen with the golden picture `tests/golden/NAME.png`. With `UPDATE_PICTURES=1` the
/// golden picture becomes what the screen shows.
pub(crate) fn assert_golden(name: &str, screen: &Screen) {
    let png = || grafika::figure::screen_png(screen).expect("a screen is a picture");
    if let Err(problem) = compare(name, screen, &golden(name, png)) {
        panic!("{problem}");
    }
}

/// Compares a PNG of any size with the golden picture, pixel by pixel but for rounding, as
/// [`assert_golden`] does with screens.
pub(crate) fn assert_golden_png(name: &str, png: &[u8]) {
    let ours = decode(png);
    let theirs = decode(&content(&golden(name, || png.to_vec())));
    let sizes = [(ours.width, ours.height), (theirs.width, theirs.height)];
    assert_eq!(sizes[0], sizes[1], "{name}: width and height, ours and the golden one's");
    let differ = |a: &[u8; 3], b: &[u8; 3]| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > ROUNDING);
    if let Some(difference) = difference_by(&ours.rgb, &theirs.rgb, ours.width, differ) {
        let kept = keep_beside(name, ours.width, &ours.rgb, &theirs.rgb);
        panic!("{name}: {difference}; ours and the golden one: {}", kept.display());
    }
}

/// The path of a golden picture, which is written first if that is asked for.
fn golden(name: &str, png: impl FnOnce() -> Vec<u8>) -> PathBuf {
    let path = super::path("golden").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::write(&path, png()).expect("the golden picture can be written");
    }
    path
}

/// Compares a screen with a picture; a difference is told with where both lie side by side.
pub(crate) fn compare(name: &str, screen: &Screen, golden: &Path) -> Result<(), String> {
    let theirs = read(golden);
    match difference(screen.pixels(), &theirs) {
        None => Ok(()),
        Some(difference) => {
            let kept = keep_both(name, screen.pixels(), &theirs);
            Err(format!("{name}: {difference}; ours and the golden one: {}", kept.display()))
        }
    }
}

/// Writes two screens side by side into the folder of build results.
pub(crate) fn keep_both(name: &str, ours: &[u8], theirs: &[u8]) -> PathBuf {
    let [ours, theirs] = [ours, theirs]
        .map(|pixels| pixels.iter().map(|&index| Color::from_index(index).rgb()).collect::<Vec<_>>());
    keep_beside(name, WIDTH as usize, &ours, &theirs)
}

/// Writes two pictures of the same size side by side into the folder of build results.
fn keep_beside(name: &str, width: usize, ours: &[[u8; 3]], theirs: &[[u8; 3]]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    let rows = ours.chunks(width).zip(theirs.chunks(width));
    let rgb: Vec<u8> = rows.flat_map(|(ours, theirs)| ours.iter().chain(theirs)).flatten().copied().collect();
    let file = std::fs::File::create(&path).expect("build results can be written");
    let mut encoder = png::Encoder::new(file, 2 * width as u32, (ours.len() / width) as u32);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a PNG header");
    writer.write_image_data(&rgb).expect("a PNG");
    path
}
