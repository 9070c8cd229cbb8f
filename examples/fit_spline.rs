//! A closed spline through points, as an SVG on standard output:
//!
//!     cargo run --example fit_spline > clover.svg

use grafika::figure::{Figure, Style};
use grafika::geometry::{Closure, Curve, Method, ParamCurve};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let points = [[100.0, 0.0], [60.0, 60.0], [0.0, 100.0], [-60.0, 60.0], [-100.0, 0.0], [0.0, -30.0]];
    let spline = Curve::through(Method::Spline, Closure::Closed, &points)?;

    let mut figure = Figure::new();
    figure.set_title("A closed spline");
    // Every span is one exact Bézier arc; only beta-splines that vary need the tolerance.
    figure.curve(spline.to_cubics(1e-6)?, Closure::Closed, Style::line([0, 0, 160], 2.0));
    for (number, &point) in (1..).zip(&points) {
        figure.disc(point, 6.0, Style::filled([255, 255, 255], [0, 0, 0]), Some(format!("{number}")));
    }
    print!("{}", figure.to_svg()?);
    Ok(())
}
