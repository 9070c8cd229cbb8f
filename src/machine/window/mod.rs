//! The display in a window of the desktop: sharp pixels by whole factors, the keys of the user's layout,
//! the mouse in the coordinates of the picture.
//!
//! The loop sleeps between looks at the window and paints only what changed. What the windowing library
//! leaves out is made up for here: it cannot take back a close button or resize a window, so that the
//! window is opened anew for these; and it tells a mouse button's state, not its history, so that a click
//! shorter than [`ACTIVE_PAUSE`] goes unseen.

mod keys;
mod layout;

use super::event::{Button, Event, Key};
use super::session::{Clock, Session};
use crate::screen::{HEIGHT, Screen, WIDTH};
use keys::{Heard, Keyboard, Telling};
use layout::Layout;
use minifb::{HasWindowHandle, MouseButton, MouseMode, Scale, ScaleMode};
use raw_window_handle::RawWindowHandle;
use std::fmt;
use std::time::{Duration, Instant};

/// Time between looks at the window while the user is busy or something moves.
pub const ACTIVE_PAUSE: Duration = Duration::from_millis(4);

/// Time between looks at the window when nothing has happened for [`BUSY`].
const IDLE_PAUSE: Duration = Duration::from_millis(12);

/// How long the user counts as busy after the last event.
const BUSY: Duration = Duration::from_secs(2);

/// Time between paintings of an unchanged picture where a window uncovered by another one says nothing.
const REPAINT: Duration = Duration::from_secs(1);

/// The key that switches to the largest scale and back; programs do not get it.
pub const FULL_SCALE_KEY: Key = Key::F(11);

/// What a window is opened with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WindowOptions {
    /// The program's name, for the title bar.
    pub title: String,
    /// Pixels of the window to a pixel of the picture; `None` takes 2 where the desktop has room for it,
    /// else 1.
    pub scale: Option<u32>,
}

/// The largest scale that a window can be opened with: 16 is more than any desktop shows.
pub const LARGEST_SCALE: u32 = 16;

/// What can go wrong with a window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WindowError {
    /// The scale is not 1 to [`LARGEST_SCALE`].
    Scale(u32),
    /// No window could be opened; the system's own message.
    Open(String),
    /// The window could not be painted; the system's own message.
    Paint(String),
}

impl fmt::Display for WindowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WindowError::Scale(scale) => {
                write!(
                    f,
                    "the window cannot be scaled by {scale}; give a whole number from 1 to {LARGEST_SCALE}"
                )
            }
            WindowError::Open(message) => {
                write!(f, "no window could be opened ({message}); try the terminal display")
            }
            WindowError::Paint(message) => write!(f, "the window could not be painted ({message})"),
        }
    }
}

impl std::error::Error for WindowError {}

/// Whether there is a desktop to open a window on: always on Windows and macOS, elsewhere when the
/// environment names an X11 or Wayland display.
pub fn window_possible() -> bool {
    let named = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    cfg!(any(windows, target_os = "macos")) || named("DISPLAY") || named("WAYLAND_DISPLAY")
}

/// Runs a session in a window until its program has ended. The close button reaches the program as
/// [`Event::Close`]; the window stays as long as the program goes on.
///
/// # Errors
/// [`WindowError`] when the window cannot be opened or painted.
pub fn run(session: &mut Session, options: &WindowOptions) -> Result<(), WindowError> {
    let mut view = View::open(options)?;
    let clock = Clock::start();
    let mut last_change = Instant::now();
    let mut ran = true;
    while !session.ended() {
        if ran {
            last_change = Instant::now();
            view.take(session.picture());
        }
        view.show()?;
        let events = view.events()?;
        let now = clock.now();
        ran = !events.is_empty() || session.deadline().is_some_and(|deadline| deadline <= now);
        session.advance(now);
        for event in events {
            session.send(event, now);
        }
        if view.closing && !session.ended() {
            view.reopen(view.size)?;
        }
        let busy = last_change.elapsed() < BUSY;
        let longest = if busy { ACTIVE_PAUSE } else { IDLE_PAUSE };
        let rest = clock.due(session).map(|due| due.saturating_duration_since(Instant::now()));
        std::thread::sleep(rest.unwrap_or(longest).min(longest));
    }
    Ok(())
}

/// How large a window is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    /// With a frame, of this many pixels.
    Pixels(usize, usize),
    /// Without a frame, by the largest whole factor that the desktop holds.
    Largest,
}

/// A window and what it shows.
struct View {
    title: String,
    window: minifb::Window,
    heard: Heard,
    keyboard: Keyboard,
    /// Whether the system tells when a part of the window has to be painted again.
    repaints: bool,
    size: Size,
    /// The size to go back to from the largest.
    former: (usize, usize),
    picture: Screen,
    /// The layout and the time of the last painting, unless the picture has changed since then.
    painted: Option<(Layout, Instant)>,
    pixels: Vec<u32>,
    mouse: (i32, i32),
    buttons: [bool; 3],
    active: bool,
    closing: bool,
}

impl View {
    fn open(options: &WindowOptions) -> Result<View, WindowError> {
        let scale = match options.scale {
            Some(scale @ 1..=LARGEST_SCALE) => scale,
            Some(scale) => return Err(WindowError::Scale(scale)),
            None => likely_scale()?,
        };
        let former = scaled(scale);
        let size = Size::Pixels(former.0, former.1);
        let window = open_window(&options.title, size)?;
        let mut view = View {
            title: options.title.clone(),
            keyboard: Keyboard::new(telling(&window)),
            repaints: tells_exposure(&window),
            window,
            heard: Heard::default(),
            size,
            former,
            picture: Screen::new(),
            painted: None,
            pixels: Vec::new(),
            mouse: (-1, -1),
            buttons: [false; 3],
            active: false,
            closing: false,
        };
        view.prepare();
        Ok(view)
    }

    /// Puts a new window of a size in the place of the old one.
    fn reopen(&mut self, size: Size) -> Result<(), WindowError> {
        let place = self.window.get_position();
        let same = self.size == size;
        // A window that was resized by hand keeps its size.
        let opened = match size {
            Size::Pixels(..) if same => Size::Pixels(self.window.get_size().0, self.window.get_size().1),
            size => size,
        };
        let mut window = open_window(&self.title, opened)?;
        if same && place != (0, 0) {
            window.set_position(place.0, place.1);
        }
        // The new window is there before the old one goes, so that the desktop shows no gap.
        self.window = window;
        self.size = size;
        self.closing = false;
        self.prepare();
        Ok(())
    }

    fn prepare(&mut self) {
        // The loop keeps the time.
        self.window.set_target_fps(0);
        self.window.set_cursor_visibility(false);
        self.heard = Heard::default();
        self.window.set_input_callback(Box::new(self.heard.clone()));
        self.keyboard.let_go();
        self.active = false;
        self.painted = None;
    }

    /// Takes the picture to show from now on.
    fn take(&mut self, picture: Screen) {
        if picture != self.picture {
            self.picture = picture;
            self.painted = None;
        }
    }

    /// Looks at the window, and paints it if anything has changed.
    fn show(&mut self) -> Result<(), WindowError> {
        let layout = Layout::of(self.window.get_size());
        let fresh = |&(place, when): &(Layout, Instant)| {
            place == layout && (self.repaints || when.elapsed() < REPAINT)
        };
        if self.painted.as_ref().is_some_and(fresh) {
            self.window.update();
            return Ok(());
        }
        layout.paint(&self.picture, &mut self.pixels);
        let (width, height) = layout.window;
        self.painted = Some((layout, Instant::now()));
        self.window
            .update_with_buffer(&self.pixels, width, height)
            .map_err(|error| WindowError::Paint(error.to_string()))
    }

    /// What the user did since the last look, in the order of mouse, keys, buttons, wheel.
    fn events(&mut self) -> Result<Vec<Event>, WindowError> {
        let mut events = Vec::new();
        let layout = Layout::of(self.window.get_size());
        events.extend(self.moved(layout));
        let told = self.heard.take();
        let keys = self.keyboard.keys(&told, Instant::now());
        events.extend(keys.iter().filter(|&&key| key != FULL_SCALE_KEY).map(|&key| Event::Key(key)));
        events.extend(self.pressed());
        events.extend(self.wheel());
        let active = self.window.is_active();
        if self.active && !active {
            self.keyboard.let_go();
        }
        self.active = active;
        if !self.window.is_open() {
            self.closing = true;
            events.extend(self.release_all());
            events.push(Event::Close);
        } else if keys.contains(&FULL_SCALE_KEY) {
            events.extend(self.release_all());
            self.toggle_size()?;
        }
        Ok(events)
    }

    fn moved(&mut self, layout: Layout) -> Option<Event> {
        let (x, y) = self.window.get_unscaled_mouse_pos(MouseMode::Pass)?;
        // A mouse that is busy elsewhere on the desktop is none of the program's business.
        if !layout.holds(x, y) && !self.buttons.contains(&true) {
            return None;
        }
        let place = layout.pixel_at(x, y);
        (std::mem::replace(&mut self.mouse, place) != place).then_some(Event::Move(place.0, place.1))
    }

    fn pressed(&mut self) -> Vec<Event> {
        const BUTTONS: [(MouseButton, Button); 3] = [
            (MouseButton::Left, Button::Left),
            (MouseButton::Right, Button::Right),
            (MouseButton::Middle, Button::Middle),
        ];
        let mut events = Vec::new();
        for ((known, button), held) in BUTTONS.into_iter().zip(&mut self.buttons) {
            let down = self.window.get_mouse_down(known);
            if down != *held {
                *held = down;
                events.push(if down { Event::Press(button) } else { Event::Release(button) });
            }
        }
        events
    }

    fn release_all(&mut self) -> Vec<Event> {
        let buttons = Button::ALL.into_iter().zip(std::mem::take(&mut self.buttons));
        buttons.filter(|&(_, held)| held).map(|((_, button), _)| Event::Release(button)).collect()
    }

    fn wheel(&self) -> Option<Event> {
        let (_, turned) = self.window.get_scroll_wheel()?;
        // Systems count a notch as anything from 1 to 15, and Wayland counts the other way round.
        let away = if self.keyboard.telling() == Telling::KeyLast { -turned } else { turned };
        let notches = if self.repaints { away.signum() } else { away.round() };
        // The conversion saturates.
        Some(notches as i32).filter(|&steps| steps != 0).map(Event::Wheel)
    }

    fn toggle_size(&mut self) -> Result<(), WindowError> {
        match self.size {
            Size::Pixels(..) => {
                self.former = self.window.get_size();
                self.reopen(Size::Largest)
            }
            Size::Largest => self.reopen(Size::Pixels(self.former.0, self.former.1)),
        }
    }
}

fn scaled(scale: u32) -> (usize, usize) {
    // No overflow: the scale is at most 16.
    ((WIDTH as u32 * scale) as usize, (HEIGHT as u32 * scale) as usize)
}

fn open_window(title: &str, size: Size) -> Result<minifb::Window, WindowError> {
    let framed = size != Size::Largest;
    let (width, height) = match size {
        Size::Pixels(width, height) => (width, height),
        Size::Largest => scaled(1),
    };
    let options = minifb::WindowOptions {
        borderless: !framed,
        title: framed,
        resize: true,
        scale: if framed { Scale::X1 } else { Scale::FitScreen },
        scale_mode: ScaleMode::UpperLeft,
        ..minifb::WindowOptions::default()
    };
    minifb::Window::new(title, width.max(1), height.max(1), options)
        .map_err(|error| WindowError::Open(error.to_string()))
}

/// 2 where the desktop has room for it beside bars and frames, else 1. The library tells the desktop's
/// size only by the size of a window that fits it.
fn likely_scale() -> Result<u32, WindowError> {
    let roomy = (WIDTH as usize + 10, HEIGHT as usize + 30);
    let options = minifb::WindowOptions {
        borderless: true,
        title: false,
        scale: Scale::FitScreen,
        ..minifb::WindowOptions::default()
    };
    let window = minifb::Window::new("", roomy.0, roomy.1, options)
        .map_err(|error| WindowError::Open(error.to_string()))?;
    Ok(if window.get_size().0 >= 2 * roomy.0 { 2 } else { 1 })
}

fn telling(window: &minifb::Window) -> Telling {
    match window.window_handle().map(|handle| handle.as_raw()) {
        Ok(RawWindowHandle::Wayland(_)) => Telling::KeyLast,
        _ => Telling::KeyFirst,
    }
}

/// X11 forgets what a covered window showed, and the library does not ask to be told.
fn tells_exposure(window: &minifb::Window) -> bool {
    !matches!(window.window_handle().map(|handle| handle.as_raw()), Ok(RawWindowHandle::Xlib(_)))
}
