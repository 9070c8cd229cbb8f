//! The page of space: PH quintics with their frames, and the pipe around them.

use super::recipe;
use super::table::{Own, SPACE};
use super::texts;
use crate::design::Sketch;
use crate::editor::curve::layer::{Action, Canvas, Doing, Layer, Map, Part, Scene, Trace, Turn};
use crate::editor::passage::Passage;
use crate::figure::wrap;
use crate::file::{Format, Method};
use crate::geometry::ParamCurve;
use crate::geometry::Point;
use crate::geometry::ph::{Place, SpacePhCurve};
use crate::machine::{Key, Tick};
use crate::screen::Color;
use crate::ui::{Area, Caption, Commands, Desk, Field, Form, Hint, Number, Picture, TOP, Words};
use serde_json::{Value, json};
use std::rc::Rc;

/// The moving frames that can be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
enum Frame {
    Frenet,
    EulerRodrigues,
    RotationMinimising,
}

impl Frame {
    const ALL: [Option<Frame>; 4] =
        [None, Some(Frame::Frenet), Some(Frame::EulerRodrigues), Some(Frame::RotationMinimising)];

    fn name(of: Option<Frame>) -> Words {
        match of {
            None => texts::NO_FRAME,
            Some(Frame::Frenet) => texts::FRENET,
            Some(Frame::EulerRodrigues) => texts::EULER,
            Some(Frame::RotationMinimising) => texts::MINIMAL,
        }
    }

    fn at(self, curve: &SpacePhCurve, place: Place) -> Option<[Point<3>; 3]> {
        match self {
            Frame::Frenet => frenet(curve, place),
            Frame::EulerRodrigues => curve.frame(place),
            Frame::RotationMinimising => curve.minimal_frame(place),
        }
    }
}

/// Frames, and rings of the pipe, along the whole curve.
const FRAMES: usize = 36;
const RINGS: usize = 48;
/// Wires along the pipe.
const WIRES: usize = 12;
/// Length of a stick.
const STICK: f64 = 28.0;
/// Radii of the pipe.
const RADII: std::ops::RangeInclusive<f64> = 0.1..=999.0;

/// The layer over curves in space.
#[derive(Clone)]
pub(super) struct Space {
    frame: Option<Frame>,
    radius: Option<f64>,
    /// Set where the page of the plane is wanted.
    passage: Rc<Passage>,
}

impl Space {
    pub(super) fn new(passage: Rc<Passage>) -> Space {
        Space { frame: Some(Frame::RotationMinimising), radius: None, passage }
    }

    fn curve(scene: &Scene<3>) -> Option<SpacePhCurve> {
        scene.sketch.space_ph_curve().ok().filter(|_| scene.shown)
    }
}

impl Layer<3> for Space {
    fn commands(&self) -> Commands<Action> {
        SPACE
    }

    fn formats(&self, _: &Sketch<3>) -> Vec<Format> {
        vec![Format::Ip3]
    }

    fn method(&self, sketch: &Sketch<3>, usual: bool) -> Option<Method> {
        recipe::method(sketch, usual)
    }

    fn completed(&self, sketch: Sketch<3>) -> Sketch<3> {
        recipe::completed(sketch)
    }

    fn has_tips(&self, _: &Sketch<3>) -> bool {
        true
    }

    fn hint(&self, scene: &Scene<3>) -> Option<Hint> {
        let text = match () {
            () if !scene.shown => texts::HINT_CURVE,
            () if scene.held => texts::HINT_HELD,
            () => texts::HINT_SPACE,
        };
        Some(Hint::at((TOP.0 + 8, TOP.1 + 32), 28, text))
    }

    fn watched(&mut self, _: &Scene<3>, tick: &Tick) -> bool {
        let by = match tick.key() {
            Some(Key::PageUp) => 1.0,
            Some(Key::PageDown) => -1.0,
            _ => return false,
        };
        self.radius = self.radius.map(|radius| (radius + by).clamp(*RADII.start(), *RADII.end()));
        self.radius.is_some()
    }

    fn traces(&self, scene: &Scene<3>) -> Vec<Trace<3>> {
        let Some(curve) = Space::curve(scene) else { return Vec::new() };
        let mut traces = self.radius.map_or(Vec::new(), |radius| pipe(&curve, radius));
        let Some(frame) = self.frame.filter(|_| !scene.held) else { return traces };
        for place in curve.equal_lengths(FRAMES).unwrap_or_default() {
            let Some((at, axes)) = curve.eval(place.span, place.u).zip(frame.at(&curve, place)) else {
                continue;
            };
            for (axis, ink) in axes.into_iter().zip([Color::LightRed, Color::LightGreen, Color::LightBlue]) {
                traces.push(Trace::Line { ends: [at, along(at, [(STICK, axis)])], ink });
            }
        }
        traces
    }

    fn paint(&self, scene: &Scene<3>, _: Map<'_, 3>, part: Part, canvas: &mut Canvas<'_>) {
        if part != Part::Titles {
            return;
        }
        let Canvas { screen, language } = canvas;
        screen.text(28, 5, texts::SPACE_TITLE.of(*language), Color::Black);
        let (x, y) = (TOP.0 + 8, TOP.1 + 4);
        let curve = match scene.sketch.space_ph_curve() {
            Ok(curve) => curve,
            Err(error) if scene.sketch.points.len() >= 2 && scene.sketch.method().is_some() => {
                let lines = wrap(texts::refusal(&error).of(*language), 28);
                for (row, line) in (0..).zip(lines.iter().take(3)) {
                    screen.text(x, y + 9 * row, line, Color::Red);
                }
                return;
            }
            Err(_) => return,
        };
        if !scene.shown {
            return;
        }
        let lines = [
            texts::length_and_energy(curve.total_length(), curve.energy()),
            texts::pipe(self.radius, tightest(&curve)),
            Frame::name(self.frame).into(),
        ];
        for (row, line) in (0..).zip(lines) {
            screen.text(x, y + 9 * row, line.of(*language), Color::Black);
        }
    }

    fn model(&self, scene: &Scene<3>) -> Value {
        let mut model = json!({ "frame": self.frame, "radius": self.radius });
        if let (Value::Object(model), Ok(curve)) = (&mut model, scene.sketch.space_ph_curve()) {
            model.insert("length".to_owned(), json!(curve.total_length()));
            model.insert("energy".to_owned(), json!(curve.energy()));
        }
        model
    }

    fn left(&self) {
        self.passage.lead(None);
    }

    fn obey<'a>(
        &'a self,
        desk: &'a mut Desk<'_>,
        picture: &'a dyn Picture,
        scene: Scene<3>,
        command: u8,
    ) -> Doing<'a, 3> {
        Box::pin(async move {
            let mut space = self.clone();
            let mut sketch = None;
            match Own::of(command) {
                Some(Own::Curve) => sketch = choose(desk, picture, &scene.sketch).await?,
                Some(Own::Distance) => space.radius = ask_radius(desk, picture, self.radius).await?,
                Some(Own::Comb) => {
                    let now = Frame::ALL.iter().position(|it| *it == self.frame).unwrap_or(0);
                    space.frame = Frame::ALL[(now + 1) % Frame::ALL.len()];
                }
                Some(Own::Elsewhere) => return Ok(Turn { layer: None, sketch: None, leave: true }),
                _ => {}
            }
            Ok(Turn { layer: Some(Box::new(space)), sketch, leave: false })
        })
    }
}

/// The command G: the form of the curve.
async fn choose(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    sketch: &Sketch<3>,
) -> crate::machine::Asked<Option<Sketch<3>>> {
    let closed = recipe::ask_closed(desk, picture).await?;
    let mut chosen = recipe::completed(sketch.by(Method::PhHermite));
    chosen.settings.closed = Some(closed);
    if let Err(error) = chosen.space_ph_curve() {
        texts::tell_refusal(desk, &error);
        return Ok(None);
    }
    Ok(Some(chosen))
}

/// The command P: the radius; 0 is no pipe.
async fn ask_radius(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    now: Option<f64>,
) -> crate::machine::Asked<Option<f64>> {
    let (x, y) = TOP;
    let area = Area::new(x + 140, y + 14, x + 196, y + 27);
    let field = Field { area, at: (x + 146, y + 17), longest: 6, kind: Number::Real(0.0..=*RADII.end()) };
    let form = Form::new(vec![Caption::new((x + 12, y + 17), texts::RADIUS)], [field]);
    let [radius] = desk.numbers_or(picture, &form, [now.unwrap_or(15.0).to_string()]).await?;
    Ok((radius > 0.0).then(|| radius.max(*RADII.start())))
}

/// A point moved along some vectors.
fn along<const N: usize>(at: Point<3>, ways: [(f64, Point<3>); N]) -> Point<3> {
    std::array::from_fn(|d| at[d] + ways.iter().map(|(far, way)| far * way[d]).sum::<f64>())
}

/// The Frenet frame; `None` where the curvature is zero.
fn frenet(curve: &SpacePhCurve, place: Place) -> Option<[Point<3>; 3]> {
    let [_, first, second] = curve.at(place.span, place.u)?;
    let cross = |a: Point<3>, b: Point<3>| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let unit = |a: Point<3>| {
        let size = crate::geometry::norm(a);
        (size > 1e-9).then(|| a.map(|it| it / size))
    };
    let (tangent, binormal) = (unit(first)?, unit(cross(first, second))?);
    Some([tangent, cross(binormal, tangent), binormal])
}

/// The smallest radius of curvature along the curve, which a pipe must stay under.
fn tightest(curve: &SpacePhCurve) -> Option<f64> {
    let places = curve.equal_lengths(400).ok()?;
    let most = places.into_iter().filter_map(|place| curve.curvature(place)).fold(0.0, f64::max);
    (most > 1e-6).then(|| 1.0 / most)
}

/// The wires of the pipe `r + rho (cos v f2 + sin v f3)` over the rotation-minimising frame: yellow, red where the curve
/// is too tight for it.
fn pipe(curve: &SpacePhCurve, radius: f64) -> Vec<Trace<3>> {
    let ring = |place: Place| -> Option<(bool, Vec<Point<3>>)> {
        let at = curve.eval(place.span, place.u)?;
        let [_, f2, f3] = curve.minimal_frame(place)?;
        let points = (0..WIRES).map(|k| {
            let (sine, cosine) = (std::f64::consts::TAU * k as f64 / WIRES as f64).sin_cos();
            along(at, [(radius * cosine, f2), (radius * sine, f3)])
        });
        let tight = curve.curvature(place).is_some_and(|it| it * radius >= 1.0);
        Some((tight, points.collect()))
    };
    let rings: Vec<(bool, Vec<Point<3>>)> =
        curve.equal_lengths(RINGS).unwrap_or_default().into_iter().filter_map(ring).collect();
    let ink = |tight: bool| if tight { Color::LightRed } else { Color::Yellow };
    let mut traces = Vec::new();
    for (tight, points) in &rings {
        for (k, point) in points.iter().enumerate() {
            let next = points.get((k + 1) % points.len()).copied().unwrap_or(*point);
            traces.push(Trace::Line { ends: [*point, next], ink: ink(*tight) });
        }
    }
    for pair in rings.windows(2) {
        let tight = pair[0].0 || pair[1].0;
        let lines = pair[0].1.iter().zip(&pair[1].1);
        traces.extend(lines.map(|(a, b)| Trace::Line { ends: [*a, *b], ink: ink(tight) }));
    }
    traces
}
