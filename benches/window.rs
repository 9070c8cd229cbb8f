//! How long painting a window of 1920x1440 pixels takes, by each look.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::display::window::paint;
use grafika::machine::Look;
use grafika::screen::{Color, HEIGHT, Palette, Screen, WIDTH};
use std::hint::black_box;

const SIZE: (usize, usize) = (1920, 1440);

/// Lines of letters in all colours: a picture with no two rows alike.
fn busy() -> Screen {
    let mut screen = Screen::new();
    for (y, color) in (0..HEIGHT).step_by(10).zip(Color::ALL.into_iter().cycle()) {
        screen.bar(0, y, WIDTH - 1, y + 9, color);
        screen.text(y % 17, y + 1, &"Interaktív grafika ".repeat(4), Color::White);
    }
    screen
}

fn painting(criterion: &mut Criterion) {
    let picture = busy();
    let mut pixels = vec![0; SIZE.0 * SIZE.1];
    for (name, look) in [("sharp", Look::Sharp), ("fill", Look::Fill), ("crt", Look::Crt)] {
        criterion.bench_function(&format!("a window of 1920x1440, {name}"), |bencher| {
            bencher.iter(|| paint(black_box(&picture), look, Palette::Vga, SIZE, &mut pixels));
        });
    }
}

criterion_group!(benches, painting);
criterion_main!(benches);
