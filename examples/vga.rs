//! The VGA screen without any program: shapes, letters and the exclusive-or, as a PNG on standard output:
//!
//!     cargo run --example vga > vga.png

use grafika::figure::screen_png;
use grafika::screen::{Color, Direction, Put, Screen, Stroke};
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let mut screen = Screen::new();
    for (x, color) in (0..).step_by(40).zip(Color::ALL) {
        screen.bar(x, 400, x + 39, 479, color);
    }
    screen.title(40, 20, "Interaktív grafika", Color::LightMagenta, 5, Direction::Horizontal);
    screen.text(40, 100, "640x480, 16 colours", Color::LightCyan);
    for radius in (20..140).step_by(8) {
        screen.circle(320, 250, radius, Stroke::thin(Color::Yellow));
    }
    // Put twice, a picture by exclusive-or leaves the screen as it was; put once, it is seen everywhere.
    let word = screen.take(40, 20, 600, 90);
    screen.put(40, 210, &word, Put::Xor);
    std::io::stdout().write_all(&screen_png(&screen)?)?;
    Ok(())
}
