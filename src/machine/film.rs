//! The film of a session: the screens a program drew, with their timing, as an endlessly looping GIF of 16 colours.
//!
//! A frame holds the rectangle that changed. GIF counts hundredths of a second, and viewers do not show frames
//! shorter than two, so faster changes share a frame. Delays are differences of rounded times; rounding errors do
//! not add up.

use crate::screen::{Color, HEIGHT, Screen, WIDTH};
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use std::borrow::Cow;
use std::time::Duration;

/// The longest film.
const LONGEST: Duration = Duration::from_secs(600);
/// The largest film in bytes.
const LARGEST: usize = 64 * 1024 * 1024;
/// The shortest frame in hundredths of a second.
const SHORTEST: u64 = 2;

/// A film being recorded.
pub(super) struct Film {
    /// The program's name, which the film is named after.
    pub(super) program: &'static str,
    begun: Duration,
    encoder: Encoder<Vec<u8>>,
    /// The screen as the written frames show it.
    written: Vec<u8>,
    /// The screen not yet written, and when it appeared, in hundredths of a second.
    next: Option<(Vec<u8>, u64)>,
}

impl Film {
    /// A film that begins now, without frames.
    pub(super) fn new(program: &'static str, now: Duration) -> Result<Film, EncodingError> {
        let palette: Vec<u8> = Color::ALL.iter().flat_map(|color| color.rgb()).collect();
        let [width, height] = size();
        let mut encoder = Encoder::new(Vec::new(), width, height, &palette)?;
        encoder.set_repeat(Repeat::Infinite)?;
        Ok(Film { program, begun: now, encoder, written: Vec::new(), next: None })
    }

    /// When the film reaches its maximum length.
    pub(super) fn end(&self) -> Duration {
        self.begun + LONGEST
    }

    /// Whether the film has reached its maximum length or size.
    pub(super) fn is_full(&self, now: Duration) -> bool {
        now >= self.end() || self.encoder.get_ref().len() >= LARGEST
    }

    /// Shows a screen from now on.
    pub(super) fn show(&mut self, screen: &Screen, now: Duration) -> Result<(), EncodingError> {
        let now = self.hundredths(now);
        let since = match self.next.take() {
            None => now,
            Some((shown, since)) if shown == screen.pixels() => {
                self.next = Some((shown, since));
                return Ok(());
            }
            Some((_, since)) if now < since + SHORTEST => since,
            Some((shown, since)) => {
                self.write(shown, now - since)?;
                now
            }
        };
        self.next = Some((screen.pixels().to_vec(), since));
        Ok(())
    }

    /// The film as a file.
    pub(super) fn finish(mut self, now: Duration) -> Result<Vec<u8>, EncodingError> {
        let now = self.hundredths(now);
        if let Some((shown, since)) = self.next.take() {
            self.write(shown, now.saturating_sub(since).max(SHORTEST))?;
        }
        self.encoder.into_inner()
    }

    /// Time since the beginning in hundredths of a second, at most the maximum length.
    fn hundredths(&self, now: Duration) -> u64 {
        let time = now.saturating_sub(self.begun).min(LONGEST);
        // Ten minutes fit into the type.
        ((time.as_micros() + 5_000) / 10_000) as u64
    }

    fn write(&mut self, pixels: Vec<u8>, delay: u64) -> Result<(), EncodingError> {
        let [left, top, right, bottom] = changed(&self.written, &pixels);
        let rows = pixels.chunks_exact(usize::from(size()[0])).take(bottom).skip(top);
        let buffer: Vec<u8> = rows.flat_map(|row| row.iter().take(right).skip(left)).copied().collect();
        let frame = Frame {
            // The end of the longest film is below what sixteen bits count.
            delay: u16::try_from(delay).unwrap_or(u16::MAX),
            dispose: DisposalMethod::Keep,
            // Places on the screen fit into sixteen bits.
            left: left as u16,
            top: top as u16,
            width: (right - left) as u16,
            height: (bottom - top) as u16,
            buffer: Cow::Owned(buffer),
            ..Frame::default()
        };
        self.written = pixels;
        self.encoder.write_frame(&frame)
    }
}

/// The size of a film.
fn size() -> [u16; 2] {
    // The screen's size fits.
    [WIDTH as u16, HEIGHT as u16]
}

/// The smallest rectangle that contains every difference between two screens: left, top, and exclusive right and
/// bottom. The whole screen if there was none before; one pixel if nothing differs, because a frame cannot be empty.
fn changed(before: &[u8], after: &[u8]) -> [usize; 4] {
    let [width, height] = size().map(usize::from);
    if before.len() != after.len() {
        return [0, 0, width, height];
    }
    let mut area: Option<[usize; 4]> = None;
    let rows = before.chunks_exact(width).zip(after.chunks_exact(width));
    for (y, (before, after)) in rows.enumerate().filter(|(_, (before, after))| before != after) {
        let differs = |(a, b): (&u8, &u8)| a != b;
        let pairs = || before.iter().zip(after);
        let left = pairs().position(differs).unwrap_or(0);
        let right = pairs().rposition(differs).map_or(width, |x| x + 1);
        area = Some(match area {
            None => [left, y, right, y + 1],
            Some([l, t, r, _]) => [l.min(left), t, r.max(right), y + 1],
        });
    }
    area.unwrap_or([0, 0, 1, 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ms(time: u64) -> Duration {
        Duration::from_millis(time)
    }

    /// The frames of a film: whole screens with their delays.
    fn frames(film: &[u8]) -> Vec<(Vec<u8>, u16)> {
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::Indexed);
        let mut decoder = options.read_info(film).unwrap();
        let (mut screen, mut frames) = (vec![255; 640 * 480], Vec::new());
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            let [left, top, width] = [frame.left, frame.top, frame.width].map(usize::from);
            for (y, row) in frame.buffer.chunks_exact(width).enumerate() {
                screen[(top + y) * 640 + left..][..width].copy_from_slice(row);
            }
            frames.push((screen.clone(), frame.delay));
        }
        frames
    }

    fn dot(x: i32) -> Screen {
        let mut screen = Screen::new();
        screen.bar(x, 40, x + 3, 43, Color::Yellow);
        screen
    }

    #[test]
    fn frames_are_the_screens_with_their_times() {
        let mut film = Film::new("x", ms(1003)).unwrap();
        for (time, x) in [(1003, 10), (1100, 10), (1337, 50), (2000, 90)] {
            film.show(&dot(x), ms(time)).unwrap();
        }
        let frames = frames(&film.finish(ms(3003)).unwrap());
        let screens: Vec<Vec<u8>> = [10, 50, 90].map(|x| dot(x).pixels().to_vec()).into();
        assert!(frames.iter().map(|(screen, _)| screen.clone()).collect::<Vec<_>>() == screens);
        assert_eq!(frames.iter().map(|(_, delay)| *delay).collect::<Vec<_>>(), [33, 67, 100]);
    }

    #[test]
    fn what_changes_sooner_than_a_frame_is_one_frame() {
        let mut film = Film::new("x", ms(0)).unwrap();
        for step in 0..=60_u64 {
            film.show(&dot(step as i32 * 5), Duration::from_nanos(step * 16_666_667)).unwrap();
        }
        let frames = frames(&film.finish(ms(2000)).unwrap());
        assert!(frames.iter().all(|(_, delay)| *delay >= 2), "{:?}", frames.len());
        assert_eq!(frames.iter().map(|(_, delay)| u64::from(*delay)).sum::<u64>(), 200);
        assert!(frames.last().unwrap().0 == dot(300).pixels());
    }

    #[test]
    fn a_change_that_is_taken_back_at_once_leaves_a_frame_of_a_pixel() {
        let mut film = Film::new("x", ms(0)).unwrap();
        for (time, x) in [(0, 10), (500, 50), (510, 10), (900, 90)] {
            film.show(&dot(x), ms(time)).unwrap();
        }
        let frames = frames(&film.finish(ms(1000)).unwrap());
        assert_eq!(frames.iter().map(|(_, delay)| *delay).collect::<Vec<_>>(), [50, 40, 10]);
        assert!(frames[1].0 == dot(10).pixels());
    }

    #[test]
    fn a_film_has_an_end() {
        let mut film = Film::new("x", ms(500)).unwrap();
        film.show(&dot(0), ms(500)).unwrap();
        assert!(!film.is_full(ms(600_499)) && film.is_full(ms(600_500)));
        let frames = frames(&film.finish(ms(99_000_000)).unwrap());
        assert_eq!(frames[0].1, 60_000);
    }

    #[test]
    fn a_film_without_frames_is_a_file_too() {
        assert!(frames(&Film::new("x", ms(0)).unwrap().finish(ms(0)).unwrap()).is_empty());
    }
}
