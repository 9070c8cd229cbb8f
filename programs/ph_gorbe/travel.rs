//! The command J: a tool travels along the curve at a constant feed, beside a point for which the parameter runs on
//! evenly.

use super::analysis::Analysis;
use super::plane::Options;
use super::{in_field, texts};
use crate::geometry::ph::{PhCurve, Place};
use crate::geometry::{ParamCurve, Point};
use crate::machine::{Asked, Key, Language};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Over, Picture, TOP, page};
use std::ops::RangeInclusive;
use std::time::Duration;

/// Feeds in pixels a second.
const FEEDS: RangeInclusive<f64> = 1.0..=2000.0;
/// Pixels of the curve between two marks, and how many there are.
const APART: f64 = 12.0;
const MARKS: RangeInclusive<f64> = 12.0..=120.0;
/// The lamp rows at the left edge: red and white, from bottom to top.
const ROWS: [i32; 2] = [32, 37];
const ROW_BOTTOM: i32 = 450;
const ROW_HEIGHT: f64 = 380.0;
/// Radius of the tool where there is no offset.
const POINT: i32 = 5;

/// Both runners at equal times, worked out once.
struct Tracks<'a> {
    curve: &'a PhCurve,
    /// The distance of the tool's centre from the curve.
    distance: f64,
    /// The marks of equal times: places by equal length and by equal parameter.
    marks: Vec<[Place; 2]>,
    /// The shortest and longest step of each, in parts of the mean.
    ranges: [[f64; 2]; 2],
}

impl Tracks<'_> {
    fn new(curve: &PhCurve, distance: f64) -> Tracks<'_> {
        let mut tracks = Tracks { curve, distance, marks: Vec::new(), ranges: [[1.0; 2]; 2] };
        let steps = (curve.total_length() / APART).clamp(*MARKS.start(), *MARKS.end()).round();
        let at = |k: usize| tracks.places(k as f64 / steps);
        tracks.marks = (0..=steps as usize).filter_map(at).collect();
        for kind in 0..2 {
            let along = |pair: &[Place; 2]| curve.length_at(pair[kind]).unwrap_or(0.0);
            let mean = curve.total_length() / steps;
            let steps = tracks.marks.windows(2).map(|pair| (along(&pair[1]) - along(&pair[0])) / mean);
            let range = steps
                .filter(|it| it.is_finite())
                .fold([f64::INFINITY, 0.0], |[low, high], it| [it.min(low), it.max(high)]);
            tracks.ranges[kind] = if range[0].is_finite() { range } else { [1.0; 2] };
        }
        tracks
    }

    /// The places at a share of the time: by equal length and by equal parameter.
    fn places(&self, share: f64) -> Option<[Place; 2]> {
        let share = share.clamp(0.0, 1.0);
        let even = self.curve.place_at_length(share * self.curve.total_length())?;
        let steps = self.curve.segments().iter().map(|segment| segment.step());
        let total: f64 = steps.clone().sum();
        let mut rest = share * total;
        let last = self.curve.spans().checked_sub(1)?;
        let mut by_parameter = Place { span: last, u: 1.0 };
        for (span, step) in steps.enumerate() {
            if rest < step || span == last {
                by_parameter = Place { span, u: (rest / step).clamp(0.0, 1.0) };
                break;
            }
            rest -= step;
        }
        Some([even, by_parameter])
    }

    /// A point beside the curve, to the left.
    fn beside(&self, place: Place, by: f64) -> Option<Point<2>> {
        let at = self.curve.eval(place.span, place.u)?;
        let normal = self.curve.normal(place)?;
        Some([at[0] + by * normal[0], at[1] + by * normal[1]])
    }

    fn draw(&self, share: f64, screen: &mut Screen) {
        let pixel = |[x, y]: Point<2>| (41 + x.round() as i32, 450 - y.round() as i32);
        let passed = (share * (self.marks.len().saturating_sub(1)) as f64).floor() as usize;
        for x in ROWS {
            screen.line(x, ROW_BOTTOM, x, ROW_BOTTOM - ROW_HEIGHT as i32, Stroke::thin(Color::DarkGray));
        }
        for marks in self.marks.iter().take(passed + 1) {
            for (kind, side, ink) in [(0, 6.0, Color::White), (1, -6.0, Color::LightRed)] {
                let place = marks[kind];
                let ends = [0.0, side].map(|by| self.beside(place, by).map(pixel));
                if let [Some((x1, y1)), Some((x2, y2))] = ends {
                    in_field(screen, &[(x1, y1), (x2, y2)], Stroke::thin(ink));
                }
                let s = self.curve.length_at(place).unwrap_or(0.0) / self.curve.total_length();
                let y = ROW_BOTTOM - (ROW_HEIGHT * s.clamp(0.0, 1.0)).round() as i32;
                screen.bar(ROWS[1 - kind] - 1, y - 1, ROWS[1 - kind] + 1, y, ink);
            }
        }
        let Some([even, by_parameter]) = self.places(share) else { return };
        if let Some((x, y)) = self.beside(by_parameter, 0.0).map(pixel) {
            screen.disc(x, y, 4, Color::LightRed, Color::Black);
        }
        if let Some((x, y)) = self.beside(even, self.distance).map(pixel) {
            let radius = self.distance.abs().round() as i32;
            if radius > POINT {
                let turn = |k: i32| (f64::from(k) * std::f64::consts::TAU / 90.0).sin_cos();
                let far = f64::from(radius);
                let point = |(sine, cosine): (f64, f64)| {
                    (x + (far * cosine).round() as i32, y + (far * sine).round() as i32)
                };
                let ring: Vec<(i32, i32)> = (0..=90).map(turn).map(point).collect();
                in_field(screen, &ring, Stroke::thick(Color::White));
            }
            screen.disc(x, y, POINT.min(radius.max(3)), Color::White, Color::Black);
        }
    }
}

/// Asks for the feed and lets the tool travel until Esc.
pub(super) async fn run(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    analysis: &Analysis,
    options: &mut Options,
) -> Asked<()> {
    let (x, y) = TOP;
    let field = Field {
        area: Area::new(x + 150, y + 14, x + 206, y + 27),
        at: (x + 156, y + 17),
        longest: 6,
        kind: Number::Real(FEEDS),
    };
    let form = Form::new(vec![Caption::new((x + 12, y + 17), texts::FEED)], [field]);
    let [feed] = desk.numbers_or(picture, &form, [options.feed.to_string()]).await?;
    options.feed = feed;
    let tracks = Tracks::new(&analysis.curve, options.distance.unwrap_or(0.0));
    let length = analysis.curve.total_length();
    let (mut way, mut running, mut last) = (0.0, true, desk.clock());
    loop {
        let share = if length > 0.0 { way / length } else { 1.0 };
        let over = Over::new(picture, |screen: &mut Screen, language: Language| {
            tracks.draw(share, screen);
            draw_page(screen, language, options, &tracks, way);
        });
        let tick = if running { desk.frame(&over).await? } else { desk.event(&over).await? };
        let now = desk.clock();
        if running {
            way += options.feed * now.saturating_sub(last).min(Duration::from_secs(1)).as_secs_f64();
        }
        last = now;
        match tick.key() {
            Some(Key::Esc | Key::Enter) => return Ok(()),
            Some(key) if key.letter() == Some('J') => return Ok(()),
            Some(Key::Char(' ')) => {
                // At the end it begins again.
                way = if way >= length { 0.0 } else { way };
                running = !running;
            }
            Some(Key::Char(sign @ ('+' | '-'))) => {
                let factor = if sign == '+' { 1.25 } else { 0.8 };
                options.feed = (options.feed * factor).clamp(*FEEDS.start(), *FEEDS.end());
            }
            _ => {}
        }
        if way >= length && running {
            (way, running) = (length, false);
        }
    }
}

fn draw_page(screen: &mut Screen, language: Language, options: &Options, tracks: &Tracks<'_>, way: f64) {
    page(screen, TOP);
    let lines = texts::travel(options, way, tracks.ranges);
    for (row, (line, ink)) in (0..).zip(lines.iter().zip([Color::Black, Color::Black, Color::Red])) {
        screen.text(TOP.0 + 8, TOP.1 + 4 + 9 * row, line.of(language), ink);
    }
    screen.text(TOP.0 + 8, TOP.1 + 32, texts::TRAVEL_KEYS.of(language), Color::Black);
}
