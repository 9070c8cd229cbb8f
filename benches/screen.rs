//! How long drawing takes: an oblique line of 600 pixels, clearing, letters, discs and titles.

use criterion::{Criterion, criterion_group, criterion_main};
use grafika::screen::{Color, Direction, Put, Screen, Stroke};
use std::hint::black_box;

fn drawing(criterion: &mut Criterion) {
    let mut screen = Screen::new();
    let mut bench = |name: &str, draw: &dyn Fn(&mut Screen)| {
        criterion.bench_function(name, |bencher| bencher.iter(|| draw(black_box(&mut screen))));
    };
    let (thin, thick) = (Stroke::thin(Color::White), Stroke::thick(Color::White));
    bench("thin oblique line of 600 pixels", &|screen| screen.line(20, 30, 619, 400, thin));
    bench("thick oblique line of 600 pixels", &|screen| screen.line(20, 30, 619, 400, thick));
    bench("steep thick line of 470 pixels", &|screen| screen.line(20, 5, 319, 474, thick));
    bench("line across the integers", &|screen| screen.line(i32::MIN, -9, i32::MAX, 400, thin));
    bench("clear", &|screen| screen.clear(Color::LightCyan));
    bench("text of 28 letters", &|screen| {
        screen.text(207, 208, " Kontrollpontok látszanak ? ", Color::Black);
    });
    bench("disc of radius 10", &|screen| screen.disc(300, 200, 10, Color::DarkGray, Color::White));
    bench("99 discs of radius 10", &|screen| {
        for k in 0..99 {
            screen.disc(20 + 6 * k, 30 + 4 * k, 10, Color::DarkGray, Color::White);
        }
    });
    bench("huge circle", &|screen| screen.circle(2_000_000_300, 200, 2_000_000_000, thin));
    bench("polygon", &|screen| {
        screen.polygon(&[(100, 50), (130, 60), (125, 90), (95, 85)], Color::Cyan, thin);
    });
    bench("title of 11 letters", &|screen| {
        screen.title(10, 10, "GYÖNGYKERÉK", Color::Magenta, 4, Direction::Horizontal);
    });
    let ball = screen.take(0, 0, 16, 16);
    criterion.bench_function("put of 17x17 pixels", |bencher| {
        bencher.iter(|| black_box(&mut screen).put(300, 200, &ball, Put::Xor));
    });
}

criterion_group!(benches, drawing);
criterion_main!(benches);
