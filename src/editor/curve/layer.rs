//! What a program may add to the editor of curves: methods and keys of its own, and pictures over the curve.

use super::{Ambient, Curves};
use crate::design::{Place, Sketch};
use crate::editor::Editor;
use crate::editor::lens::Lens;
use crate::editor::picture::Page;
use crate::editor::seen::Item;
use crate::file::{Format, Method};
use crate::geometry::{ParamCurve, Point};
use crate::machine::{Asked, Tick};
use crate::screen::{Color, Stroke};
use crate::ui::{Commands, Desk, Hint, Picture};
use crate::work::Next;
use serde::Serialize;
use std::pin::Pin;

pub use super::tables::{Action, rows};
pub use crate::editor::picture::{Layer as Part, Page as Canvas};

/// What a layer sees of the editor.
#[derive(Clone)]
pub struct Scene<const D: usize> {
    /// The sketch as it is drawn: with the held handle at the mouse, and the method of the program.
    pub sketch: Sketch<D>,
    /// Whether the curve is in the picture.
    pub shown: bool,
    /// Whether the picture is a result, without frame and buttons.
    pub result: bool,
    /// Whether the mouse holds something, so that slow parts of a picture may wait.
    pub held: bool,
    /// Where the mouse holds what is the layer's own.
    pub grip: Option<Point<D>>,
}

/// A line of the layer, on the screen and in figures.
pub enum Trace<const D: usize> {
    /// A curve.
    Curve {
        /// The curve.
        curve: Box<dyn ParamCurve<D>>,
        /// Its segments per span on the screen.
        steps: usize,
        /// How it is drawn.
        stroke: Stroke,
    },
    /// A straight line.
    Line {
        /// Its ends.
        ends: [Point<D>; 2],
        /// Its colour.
        ink: Color,
    },
}

/// What a command of the layer changes.
pub struct Turn<const D: usize> {
    /// The layer as it is from now on.
    pub layer: Option<Box<dyn Layer<D>>>,
    /// The sketch, as an edit that can be undone; its curve is then shown.
    pub sketch: Option<Sketch<D>>,
    /// Whether to leave the editor, after the question about unsaved work.
    pub leave: bool,
}

/// A command of the layer that is being carried out.
pub type Doing<'a, const D: usize> = Pin<Box<dyn Future<Output = Asked<Turn<D>>> + 'a>>;

/// From places to pixels.
pub type Map<'a, const D: usize> = &'a dyn Fn(Point<D>) -> (i32, i32);

/// A program's own part of the editor of curves.
pub trait Layer<const D: usize> {
    /// All commands of the program.
    fn commands(&self) -> Commands<Action>;
    /// The formats of its files, first that of the sketch.
    fn formats(&self, sketch: &Sketch<D>) -> Vec<Format>;
    /// The method that a sketch is drawn by; `usual` in the manner of today, where there is always one.
    fn method(&self, sketch: &Sketch<D>, usual: bool) -> Option<Method>;
    /// The sketch after an edit, with what the program's methods need.
    fn completed(&self, sketch: Sketch<D>) -> Sketch<D>;
    /// Whether tangents are shown.
    fn has_tips(&self, sketch: &Sketch<D>) -> bool;
    /// What can be done now, once there are enough points.
    fn hint(&self, scene: &Scene<D>) -> Option<Hint>;
    /// Takes up an event that changes the picture only; returns whether it did.
    fn watched(&mut self, scene: &Scene<D>, tick: &Tick) -> bool;
    /// Whether there is something of the layer at a pixel that the mouse can drag.
    fn grips(&self, _scene: &Scene<D>, _map: Map<'_, D>, _at: (i32, i32)) -> bool {
        false
    }
    /// Takes up where it has been dragged to.
    fn let_go(&mut self, _scene: &Scene<D>, _at: Point<D>) {}
    /// The lines over or under the curve.
    fn traces(&self, scene: &Scene<D>) -> Vec<Trace<D>>;
    /// Draws what is not a line, in a part of the screen.
    fn paint(&self, scene: &Scene<D>, map: Map<'_, D>, part: Part, canvas: &mut Canvas<'_>);
    /// Its part of the model that `dump` writes; a map.
    fn model(&self, scene: &Scene<D>) -> serde_json::Value;
    /// Called when the editor is left by one of its commands.
    fn left(&self) {}
    /// Carries out a command of its own, [`Action::Own`].
    fn obey<'a>(
        &'a self,
        desk: &'a mut Desk<'_>,
        picture: &'a dyn Picture,
        scene: Scene<D>,
        command: u8,
    ) -> Doing<'a, D>;
}

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// What the layer sees now.
    pub(super) fn scene(&self) -> Scene<D> {
        let own = self.held.filter(|held| held.handle == super::Handle::Own);
        let result = self.stage.is_result();
        Scene {
            sketch: self.drawn(),
            shown: (self.shown.visible || result) && !self.craft.measured,
            result,
            held: self.held.is_some(),
            grip: own.filter(|held| held.at != held.from).map(|held| held.at),
        }
    }

    /// The lines of the layer.
    pub(super) fn layer_traces(&self) -> Vec<Item<D>> {
        let Some(layer) = &self.craft.layer else { return Vec::new() };
        let item = |trace| match trace {
            Trace::Curve { curve, steps, stroke } => Item::Curve { curve, steps, stroke, name: None },
            Trace::Line { ends, ink } => Item::Line { ends, ink },
        };
        layer.traces(&self.scene()).into_iter().map(item).collect()
    }

    /// Whether the layer has something to drag at a pixel.
    pub(super) fn layer_grips(&self, at: (i32, i32)) -> bool {
        let map = |place: Point<D>| self.lens.pixel(place);
        self.craft.layer.as_ref().is_some_and(|layer| layer.grips(&self.scene(), &map, at))
    }

    /// Draws the layer in a part of the screen.
    pub(super) fn paint_layer(&self, part: Part, page: &mut Page<'_>) {
        let map = |place: Point<D>| self.lens.pixel(place);
        if let Some(layer) = &self.craft.layer {
            layer.paint(&self.scene(), &map, part, page);
        }
    }

    /// Gives the layer an event; returns whether it was for it.
    pub(super) fn layer_watches(&mut self, tick: &Tick) -> bool {
        let scene = self.scene();
        self.craft.layer.as_mut().is_some_and(|layer| layer.watched(&scene, tick))
    }

    /// The sketch after an edit, with what the program needs.
    pub(super) fn completed(&self, sketch: Sketch<D>) -> Sketch<D> {
        match &self.craft.layer {
            Some(layer) => layer.completed(sketch),
            None => sketch,
        }
    }

    /// Carries out a command of the layer.
    pub(super) async fn obey_layer(&mut self, desk: &mut Desk<'_>, command: u8) -> Asked<Next> {
        let Some(layer) = &self.craft.layer else { return Ok(Next::Work) };
        let turn = layer.obey(desk, self, self.scene(), command).await?;
        if turn.leave {
            if self.history.unsaved() {
                crate::work::offer_to_save(self, desk).await?;
            }
            self.craft.layer.iter().for_each(|layer| layer.left());
            return Ok(Next::End);
        }
        if let Some(layer) = turn.layer {
            self.craft.layer = Some(layer);
        }
        if let Some(sketch) = turn.sketch {
            self.history.change(sketch);
            self.shown.take(true);
        }
        Ok(Next::Work)
    }
}
