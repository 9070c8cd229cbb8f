//! The display on the canvas of a browser: the picture by one of its looks, the keys of the user's layout, mouse, pen and
//! fingers in the coordinates of the picture.
//!
//! The page tells what happens, with the time of every event, and calls [`Display::step`] when the session's deadline has
//! come. The canvas is painted only when the picture has changed. It knows nothing of what the program draws, and nothing
//! of the page but its own element.

mod fingers;
mod keys;

pub use fingers::{Fingers, Phase};
pub use keys::{Stroke, taken};

use super::Display;
use super::layout::Layout;
use crate::machine::{Look, Session};
use crate::screen::{Color, HEIGHT, Palette, Screen, WIDTH};
use std::time::Duration;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, ImageData};

/// How late the page may come, in milliseconds: a little more than a frame.
const HELD_UP: f64 = 20.0;

/// How long the pieces of a search may take before the next picture, in milliseconds: most of a frame.
const SLICE: f64 = 12.0;

/// What can go wrong with a canvas.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CanvasError {
    /// The browser gives no context to paint with.
    #[error("this browser does not paint on a canvas")]
    Context,
    /// The browser's own message.
    #[error("the canvas could not be painted ({0})")]
    Paint(String),
}

impl CanvasError {
    fn told(error: &JsValue) -> CanvasError {
        CanvasError::Paint(format!("{error:?}"))
    }
}

/// The place that the page gives to a picture, in the pixels of style sheets, and how many pixels of the screen there are to
/// one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// Pixels of the screen to one of these.
    pub density: f64,
}

impl Stage {
    /// The size in pixels of the screen.
    fn size(self) -> (usize, usize) {
        // The conversion saturates and turns a NaN into 0.
        let whole = |length: f64| (length * self.density + 0.01).floor() as usize;
        (whole(self.width), whole(self.height))
    }
}

/// What the canvas was painted with last.
#[derive(Clone, PartialEq)]
struct Seen {
    picture: Screen,
    palette: Palette,
    look: Look,
    stage: Stage,
}

/// A canvas and the session's time on it.
pub struct Canvas {
    element: HtmlCanvasElement,
    context: CanvasRenderingContext2d,
    stage: Stage,
    /// When the session began, and the present, by the page's clock in milliseconds.
    began: f64,
    now: f64,
    /// When the session wanted to go on.
    due: Option<f64>,
    seen: Option<Seen>,
    layout: Layout,
    pixels: Vec<u32>,
    bytes: Vec<u8>,
}

impl Canvas {
    /// Takes the element that shows the picture.
    ///
    /// # Errors
    /// [`CanvasError::Context`] where the browser cannot paint.
    pub fn new(element: HtmlCanvasElement, stage: Stage) -> Result<Canvas, CanvasError> {
        let context = element.get_context("2d").ok().flatten();
        let context = context.and_then(|context| context.dyn_into().ok()).ok_or(CanvasError::Context)?;
        Ok(Canvas {
            element,
            context,
            stage,
            began: 0.0,
            now: 0.0,
            due: None,
            seen: None,
            layout: Layout::of(stage.size(), Look::default()),
            pixels: Vec::new(),
            bytes: Vec::new(),
        })
    }

    /// Begins the time of a session at a moment of the page's clock, in milliseconds.
    pub fn begin(&mut self, now: f64) {
        (self.began, self.now, self.due) = (now, now, None);
        self.seen = None;
    }

    /// Sets the time; it never goes back. The session's time stands while the page is held up or hidden: what it has missed
    /// would have to be caught up at once, and hold up the page again.
    pub fn set_now(&mut self, now: f64) {
        self.now = self.now.max(now);
        if let Some(due) = self.due.take() {
            self.began += (self.now - due - HELD_UP).max(0.0);
        }
    }

    /// Advances the session as [`Display::step`] does, and tells when to come again by the page's clock. Of a long search,
    /// whose pieces are due one after the other, only so many are done as take [`SLICE`]; the session's time stands for the
    /// rest.
    ///
    /// # Errors
    /// Those of [`Display::show`].
    pub fn advance(&mut self, session: &mut Session) -> Result<Option<f64>, CanvasError> {
        let clock = web_sys::window().and_then(|window| window.performance());
        let begun = clock.as_ref().map(|clock| clock.now());
        while let Some(deadline) = session.deadline().filter(|&deadline| deadline <= self.now()) {
            session.advance(deadline);
            let spent = clock.as_ref().zip(begun).map_or(0.0, |(clock, begun)| clock.now() - begun);
            if spent > SLICE {
                self.began = self.now - deadline.as_secs_f64() * 1000.0;
                break;
            }
        }
        let deadline = self.step(session)?;
        self.due = deadline.map(|deadline| self.began + deadline.as_secs_f64() * 1000.0);
        Ok(self.due)
    }

    /// Changes the place that the page gives to the picture.
    pub fn set_stage(&mut self, stage: Stage) {
        self.stage = stage;
    }

    /// The pixel of the picture under a point of the stage, in the pixels of style sheets.
    #[must_use]
    pub fn pixel_at(&self, x: f64, y: f64) -> (i32, i32) {
        self.layout.pixel_at(x * self.stage.density, y * self.stage.density)
    }

    /// Puts the element where the picture stands and paints it.
    fn paint(&mut self, seen: &Seen) -> Result<(), JsValue> {
        let layout = Layout::of(self.stage.size(), seen.look);
        let (shown, picture) = (layout.shown, (WIDTH as usize, HEIGHT as usize));
        // Whole pixels magnified are left to the browser, which does it much faster.
        let whole = seen.look == Look::Sharp && shown.0 >= picture.0 && shown.0 % picture.0 == 0;
        let bitmap = if whole { picture } else { shown };
        if (self.element.width() as usize, self.element.height() as usize) != bitmap {
            self.element.set_width(bitmap.0 as u32);
            self.element.set_height(bitmap.1 as u32);
        }
        if layout != self.layout || self.seen.as_ref().is_none_or(|before| before.stage != seen.stage) {
            let style = self.element.style();
            let density = self.stage.density;
            let placed = [
                ("left", layout.corner.0),
                ("top", layout.corner.1),
                ("width", shown.0),
                ("height", shown.1),
            ];
            for (name, length) in placed {
                style.set_property(name, &format!("{}px", length as f64 / density))?;
            }
            self.layout = layout;
        }
        self.bytes.clear();
        if whole {
            let shades = Color::ALL.map(|color| {
                let [red, green, blue] = seen.palette.rgb(color);
                [red, green, blue, 255]
            });
            let pixels = seen.picture.pixels().iter();
            self.bytes.extend(pixels.flat_map(|&index| shades[usize::from(index & 15)]));
        } else {
            self.pixels.clear();
            self.pixels.resize(bitmap.0 * bitmap.1, 0);
            Layout::of(shown, seen.look).paint(&seen.picture, seen.palette, &mut self.pixels);
            let bytes = self.pixels.iter().flat_map(|pixel| {
                let [_, red, green, blue] = pixel.to_be_bytes();
                [red, green, blue, 255]
            });
            self.bytes.extend(bytes);
        }
        let image = ImageData::new_with_u8_clamped_array(Clamped(&self.bytes), bitmap.0 as u32)?;
        self.context.put_image_data(&image, 0.0, 0.0)
    }
}

impl Display for Canvas {
    type Error = CanvasError;

    fn now(&self) -> Duration {
        // The conversion saturates and turns a NaN into 0.
        Duration::from_millis((self.now - self.began) as u64)
    }

    fn show(&mut self, session: &Session) -> Result<(), CanvasError> {
        let seen = Seen {
            picture: session.picture(),
            palette: session.palette(),
            look: session.look(),
            stage: self.stage,
        };
        if self.seen.as_ref() != Some(&seen) {
            self.paint(&seen).map_err(|error| CanvasError::told(&error))?;
            self.seen = Some(seen);
        }
        Ok(())
    }
}
