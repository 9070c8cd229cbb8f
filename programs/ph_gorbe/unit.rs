//! The key F7: what a pixel is in millimetres, and the path as lines for a numerically controlled machine.

use super::analysis::Analysis;
use super::plane::Options;
use super::texts;
use crate::geometry::{ParamCurve, Point};
use crate::machine::Asked;
use crate::ui::Area;
use crate::ui::words;
use crate::ui::{Answer, Caption, Desk, Field, Form, Number, Picture, Question, Stay, TOP};
use std::fmt::Write;

/// Millimetres in a pixel.
const UNITS: std::ops::RangeInclusive<f64> = 0.001..=1000.0;
/// How far a chord may be from the path, in millimetres.
const CHORD_ERROR: f64 = 0.01;
/// Steps a piece is tried with at most.
const MOST: usize = 4096;

/// Asks for the unit, then whether to save the path.
pub(super) async fn ask(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    analysis: &Analysis,
    options: &mut Options,
) -> Asked<()> {
    let (x, y) = TOP;
    let area = Area::new(x + 150, y + 14, x + 206, y + 27);
    let field = Field { area, at: (x + 156, y + 17), longest: 6, kind: Number::Real(UNITS) };
    let form = Form::new(vec![Caption::new((x + 12, y + 17), texts::UNIT)], [field]);
    let [unit] = desk.numbers_or(picture, &form, [options.unit.to_string()]).await?;
    options.unit = unit;
    let question =
        Question { proposed: Answer::Second, ..Question::new(TOP, texts::ASK_NC, [words::YES, words::NO]) };
    if desk.ask(picture, &question).await? == Answer::Second {
        return Ok(());
    }
    let stem = desk.machine.file().and_then(|name| name.rsplit_once('.')).map_or("PH", |(stem, _)| stem);
    let name = format!("{}.NC", stem.to_uppercase());
    if !desk.may_write(picture, &[&name]).await? {
        return Ok(());
    }
    let (program, lines) = nc(&paths(analysis, unit), unit, options.feed);
    let stored = desk.machine.storage().write(&name, program.as_bytes());
    match stored {
        Ok(()) => desk.tell(texts::nc_saved(&name, lines), Stay::Briefly),
        Err(error) => desk.tell(words::storage_problem(&error), Stay::UntilRead),
    }
    Ok(())
}

/// The kept parts of the offsets, or the curve where there is none, as chains of points near enough to the path.
fn paths(analysis: &Analysis, unit: f64) -> Vec<Vec<Point<2>>> {
    let tolerance = CHORD_ERROR / unit;
    let runs = analysis.sides.iter().flat_map(|side| &side.runs).filter(|(kept, _)| *kept);
    let kept: Vec<Vec<Point<2>>> = runs.map(|(_, run)| chain(run, tolerance)).collect();
    if analysis.sides.is_empty() { vec![chain(&analysis.curve, tolerance)] } else { kept }
}

/// Points of a path, every span in as many equal steps as its chords need.
fn chain(path: &dyn ParamCurve<2>, tolerance: f64) -> Vec<Point<2>> {
    let mut points: Vec<Point<2>> = path.eval(0, 0.0).into_iter().collect();
    for span in 0..path.spans() {
        let mut steps = 4;
        while steps < MOST && sag(path, span, steps) > tolerance {
            steps *= 2;
        }
        points.extend((1..=steps).filter_map(|k| path.eval(span, k as f64 / steps as f64)));
    }
    points
}

/// How far the middles of the steps are from their chords at most.
fn sag(path: &dyn ParamCurve<2>, span: usize, steps: usize) -> f64 {
    let at = |k: usize| path.eval(span, k as f64 / (2 * steps) as f64);
    let height = |k: usize| -> Option<f64> {
        let [a, m, b] = [at(2 * k)?, at(2 * k + 1)?, at(2 * k + 2)?];
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        let cross = (m[0] - a[0]) * dy - (m[1] - a[1]) * dx;
        Some(if length > 0.0 { (cross / length).abs() } else { (m[0] - a[0]).hypot(m[1] - a[1]) })
    };
    (0..steps).filter_map(height).fold(0.0, f64::max)
}

/// The lines of the program, and how many there are.
fn nc(paths: &[Vec<Point<2>>], unit: f64, feed: f64) -> (String, usize) {
    let mut program = String::from("G21 G90\n");
    let mut lines = 1;
    for path in paths {
        for (k, [x, y]) in path.iter().enumerate() {
            // Writing into a string cannot fail.
            let _ = match k {
                0 => writeln!(program, "G0 X{:.4} Y{:.4}", unit * x, unit * y),
                _ => writeln!(program, "G1 X{:.4} Y{:.4} F{:.0}", unit * x, unit * y, 60.0 * unit * feed),
            };
            lines += 1;
        }
    }
    program.push_str("M2\n");
    (program, lines + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Sketch;
    use crate::file::Method;

    #[test]
    fn chords_stay_near_the_path() {
        let points = vec![[60.0, 120.0], [150.0, 300.0], [250.0, 170.0], [330.0, 110.0]];
        let sketch = Sketch::<2> { points, ..Sketch::default() }.by(Method::PhSpline);
        let analysis = Analysis::new(&sketch, &[20.0], true).unwrap();
        let paths = paths(&analysis, 0.5);
        assert_eq!(paths.len(), analysis.sides[0].runs.iter().filter(|(kept, _)| *kept).count());
        for point in paths.iter().flatten() {
            let (_, far) = analysis.nearest(*point).unwrap();
            assert!((far - 20.0).abs() < 1e-3, "{far}");
        }
        let (program, lines) = nc(&paths, 0.5, 100.0);
        assert_eq!(program.lines().count(), lines);
        assert!(program.contains(" F3000\n"));
    }
}
