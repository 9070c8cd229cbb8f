//! The page of the plane: what PH_GORBE adds to the editor of plane curves.

use super::analysis::{Analysis, Cache, STEPS, Stretch};
use super::table::{Own, PLANE};
use super::{comb, compare, distance, formula, recipe, solutions, speed, status, texts, travel, unit};
use crate::design::{DesignError, Sketch};
use crate::editor::curve::layer::{Action, Canvas, Doing, Layer, Map, Part, Scene, Trace, Turn};
use crate::editor::passage::Passage;
use crate::file::{Format, Method};
use crate::geometry::Point;
use crate::machine::{Event, Key, Tick};
use crate::ui::{Commands, Desk, Hint, Picture};
use serde_json::{Value, json};
use std::rc::Rc;

/// What the user has chosen to see. It belongs to the view, not to the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Options {
    /// The distance of the offset, positive to the left; `None` for no offset.
    pub(super) distance: Option<f64>,
    /// Whether the other side has one too.
    pub(super) both: bool,
    /// Whether what comes nearer than the distance is cut off.
    pub(super) trim: bool,
    /// Whether the strip of the speed is shown.
    pub(super) speed: bool,
    /// The scale of the comb of curvature, in square pixels, if it is shown.
    pub(super) comb: Option<f64>,
    /// Millimetres in a pixel.
    pub(super) unit: f64,
    /// The feed of the travel in pixels a second.
    pub(super) feed: f64,
    /// The scale that the comb had last.
    pub(super) last_comb: f64,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            distance: Some(20.0),
            both: false,
            trim: true,
            speed: false,
            comb: None,
            unit: 1.0,
            feed: 100.0,
            last_comb: 2000.0,
        }
    }
}

/// Distances that the offset may have.
pub(super) const FARTHEST: f64 = 999.0;

impl Options {
    /// The distances of the offsets.
    pub(super) fn distances(&self) -> Vec<f64> {
        let sides = if self.both { [Some(1.0), Some(-1.0)] } else { [Some(1.0), None] };
        let distance = self.distance;
        sides.into_iter().flatten().filter_map(|side| distance.map(|it| side * it)).collect()
    }

    fn step(&mut self, by: f64) {
        let distance = self.distance.unwrap_or(0.0) + by;
        self.distance = Some(((10.0 * distance).round() / 10.0).clamp(-FARTHEST, FARTHEST));
    }
}

/// The layer over plane curves.
#[derive(Clone)]
pub(super) struct Plane {
    pub(super) options: Options,
    cache: Rc<Cache>,
    /// Where the mouse is.
    mouse: Option<(i32, i32)>,
    /// Set where the page of space is wanted.
    passage: Rc<Passage>,
}

impl Plane {
    pub(super) fn new(passage: Rc<Passage>) -> Plane {
        Plane { options: Options::default(), cache: Rc::default(), mouse: None, passage }
    }

    /// The options while the offset is dragged.
    fn seen(&self, scene: &Scene<2>) -> Options {
        let mut options = self.options;
        let bare = scene.grip.and_then(|_| self.cache.of(&scene.sketch, &options.distances(), false).ok());
        if let Some((at, bare)) = scene.grip.zip(bare) {
            let other =
                |it: f64| if options.both && it * options.distance.unwrap_or(0.0) < 0.0 { -it } else { it };
            options.distance = bare.signed_distance(at).map(other).map(|it| it.clamp(-FARTHEST, FARTHEST));
        }
        options
    }

    /// The analysis for what is shown now. While something is held, crossings wait.
    pub(super) fn analysis(&self, scene: &Scene<2>) -> Result<Rc<Analysis>, DesignError> {
        let options = self.seen(scene);
        self.cache.of(&scene.sketch, &options.distances(), options.trim && !scene.held)
    }

    /// The place in the field of a pixel.
    fn mouse_place(&self, map: Map<'_, 2>) -> Option<Point<2>> {
        let (x, y) = self.mouse?;
        let (left, bottom) = map([0.0, 0.0]);
        Some([f64::from(x - left), f64::from(bottom - y)])
    }
}

impl Layer<2> for Plane {
    fn commands(&self) -> Commands<Action> {
        PLANE
    }

    fn formats(&self, sketch: &Sketch<2>) -> Vec<Format> {
        let formats = [Format::Ip2, Format::Ic2];
        let [first, second] = if sketch.tangents.is_some() { [formats[1], formats[0]] } else { formats };
        vec![first, second]
    }

    fn method(&self, sketch: &Sketch<2>, usual: bool) -> Option<Method> {
        recipe::method(sketch, usual)
    }

    fn completed(&self, sketch: Sketch<2>) -> Sketch<2> {
        recipe::completed(sketch)
    }

    fn has_tips(&self, sketch: &Sketch<2>) -> bool {
        sketch.settings.method != Some(Method::PhSpline)
    }

    fn hint(&self, scene: &Scene<2>) -> Option<Hint> {
        Some(status::hint(scene, &self.options))
    }

    fn watched(&mut self, scene: &Scene<2>, tick: &Tick) -> bool {
        self.mouse = Some((tick.mouse.x, tick.mouse.y));
        let by = match (tick.event, tick.key()) {
            (Some(Event::Wheel(steps)), _) => f64::from(steps),
            (_, Some(Key::PageUp)) => 1.0,
            (_, Some(Key::PageDown)) => -1.0,
            (_, Some(Key::Char('.'))) => 0.1,
            (_, Some(Key::Char(','))) => -0.1,
            (_, Some(Key::Char(sign @ ('+' | '-')))) if self.options.comb.is_some() => {
                let factor = if sign == '+' { 1.25 } else { 0.8 };
                self.options.comb = self.options.comb.map(|scale| (scale * factor).clamp(20.0, 2e5));
                return true;
            }
            _ => return false,
        };
        if !scene.shown {
            return false;
        }
        self.options.step(by);
        true
    }

    fn grips(&self, scene: &Scene<2>, map: Map<'_, 2>, at: (i32, i32)) -> bool {
        let Ok(analysis) = self.analysis(scene) else { return false };
        let near = |point: &Point<2>| {
            let (x, y) = map(*point);
            (x - at.0).abs() <= 4 && (y - at.1).abs() <= 4
        };
        let runs = analysis.sides.iter().flat_map(|side| &side.runs).filter(|(kept, _)| *kept);
        scene.shown && runs.flat_map(|(_, run)| line(run)).any(|point| near(&point))
    }

    fn let_go(&mut self, scene: &Scene<2>, at: Point<2>) {
        self.options = self.seen(&Scene { grip: Some(at), ..scene.clone() });
    }

    fn traces(&self, scene: &Scene<2>) -> Vec<Trace<2>> {
        let Ok(analysis) = self.analysis(scene) else { return Vec::new() };
        if !scene.shown {
            return Vec::new();
        }
        let mut traces = self.options.comb.map_or(Vec::new(), |scale| comb::traces(&analysis.curve, scale));
        for (kept, run) in analysis.sides.iter().flat_map(|side| &side.runs) {
            let (curve, stroke) = (Box::new(run.clone()), Stretch::stroke(*kept));
            traces.push(Trace::Curve { curve, steps: STEPS, stroke });
        }
        traces
    }

    fn paint(&self, scene: &Scene<2>, map: Map<'_, 2>, part: Part, canvas: &mut Canvas<'_>) {
        let analysis = self.analysis(scene);
        let options = self.seen(scene);
        match (part, &analysis) {
            (Part::Titles, _) => status::draw(scene, &analysis, &options, canvas),
            (Part::Over, Ok(analysis)) if scene.shown => {
                comb::draw_marks(analysis, &options, map, canvas);
                if scene.result {
                    return;
                }
                let at = self.mouse.filter(|_| options.speed || options.comb.is_some());
                let place = self.mouse_place(map).filter(|_| at.is_some());
                let place = match (at, place) {
                    (Some(at), _) if options.speed && speed::holds(at) => {
                        speed::place_at(&analysis.curve, at)
                    }
                    (_, Some(at)) => {
                        analysis.nearest(at).filter(|(_, far)| *far <= 12.0).map(|(place, _)| place)
                    }
                    _ => None,
                };
                if let Some(place) = place {
                    comb::draw_circle(analysis, place, &options, map, canvas);
                }
                if options.speed {
                    speed::draw(analysis, &scene.sketch, place, canvas);
                }
            }
            _ => {}
        }
    }

    fn model(&self, scene: &Scene<2>) -> Value {
        let options = self.seen(scene);
        let common = json!({
            "distance": options.distance, "both": options.both, "trim": options.trim,
            "speed": options.speed, "comb": options.comb, "unit": options.unit, "feed": options.feed,
        });
        let mut model = match self.analysis(scene) {
            Ok(analysis) => status::model(&analysis),
            Err(error) => json!({ "refused": error.to_string() }),
        };
        if let (Value::Object(model), Value::Object(common)) = (&mut model, common) {
            model.extend(common);
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
        scene: Scene<2>,
        command: u8,
    ) -> Doing<'a, 2> {
        Box::pin(async move {
            let mut options = self.options;
            let mut sketch = None;
            match Own::of(command) {
                Some(Own::Curve) => sketch = recipe::choose(desk, picture, &scene.sketch).await?,
                Some(Own::Distance) => distance::ask(desk, picture, &mut options).await?,
                Some(Own::Speed) => options.speed = !options.speed,
                Some(Own::Comb) => match options.comb.take() {
                    Some(scale) => options.last_comb = scale,
                    None => options.comb = Some(options.last_comb),
                },
                Some(Own::Elsewhere) => return Ok(Turn { layer: None, sketch: None, leave: true }),
                Some(other) => match self.analysis(&scene) {
                    Err(error) => texts::tell_refusal(desk, &error),
                    Ok(_) if !scene.shown => desk.tell(texts::FIRST_A_CURVE, crate::ui::Stay::Briefly),
                    Ok(analysis) => match other {
                        Own::Travel => travel::run(desk, picture, &analysis, &mut options).await?,
                        Own::Solutions => {
                            sketch = solutions::show(desk, picture, &scene.sketch).await?;
                        }
                        Own::Compare => compare::show(desk, picture, &analysis, &options).await?,
                        Own::Formula => formula::show(desk, picture, &analysis).await?,
                        _ => unit::ask(desk, picture, &analysis, &mut options).await?,
                    },
                },
                None => {}
            }
            let layer = Plane { options, ..self.clone() };
            Ok(Turn { layer: Some(Box::new(layer)), sketch, leave: false })
        })
    }
}

/// A stretch as a line for the screen.
pub(super) fn line(run: &Stretch) -> Vec<Point<2>> {
    use crate::geometry::ParamCurve;
    run.polyline(STEPS).unwrap_or_default()
}
