//! The display in a window of the desktop: the picture by one of its looks, the keys of the user's layout,
//! the mouse in the coordinates of the picture.
//!
//! The window sleeps until the desktop tells something or the session's deadline has come, and paints
//! only a picture that has changed. It knows nothing of what the program draws.

mod keys;

use super::Display;
use super::clock::Clock;
use super::desktop::{LARGEST_SCALE, WindowError, checked_scale};
use super::layout::Layout;
use crate::machine::{Button, Event, Key, Look, Modifier, Session};
use crate::screen::{Color, HEIGHT, Palette, Screen, WIDTH};
use keys::{CommandKey, Stroke};
use std::convert::Infallible;
use std::fmt;
use std::num::NonZeroU32;
use std::rc::Rc;
use std::time::Duration;
use winit::application::ApplicationHandler;
use winit::dpi::{PhysicalPosition, PhysicalSize};
use winit::event::{ElementState, MouseButton, MouseScrollDelta, Touch, TouchPhase, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, OwnedDisplayHandle};
use winit::keyboard::ModifiersState;
use winit::platform::run_on_demand::EventLoopExtRunOnDemand;
use winit::window::{Fullscreen, Icon, Window, WindowId};

/// The key that fills the whole desktop and goes back; programs do not get it.
pub const FULL_SCREEN_KEY: Key = Key::F(11);

/// What a window is opened with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WindowOptions {
    /// The program's name, for the title bar.
    pub title: String,
    /// Pixels of the window to a pixel of the picture, 1 to [`LARGEST_SCALE`]; `None` takes 2 (more on a
    /// desktop of fine pixels) where there is room for it, else 1.
    pub scale: Option<u32>,
}

/// Paints a window of a size with a picture in it, row by row as 0x00RRGGBB; `pixels` of another number are left alone.
pub fn paint(picture: &Screen, look: Look, palette: Palette, size: (usize, usize), pixels: &mut [u32]) {
    Layout::of(size, look).paint(picture, palette, pixels);
}

/// The connection to the desktop. A process can have one only, so that whoever shows several sessions
/// one after the other keeps it.
#[derive(Debug)]
pub struct Desktop {
    events: EventLoop<()>,
}

impl Desktop {
    /// Connects to the desktop, from the main thread.
    ///
    /// # Errors
    /// [`WindowError::Open`] when there is no desktop, or when a connection was opened before.
    pub fn connect() -> Result<Desktop, WindowError> {
        // The windowing library panics over a system library that is missing; that must not keep a
        // caller from showing the terminal instead.
        let connected = std::panic::catch_unwind(event_loop);
        match connected {
            Ok(Ok(events)) => Ok(Desktop { events }),
            Ok(Err(error)) => Err(WindowError::Open(reason(&error))),
            Err(_) => Err(WindowError::Open("a library of the desktop is missing".to_string())),
        }
    }

    /// Runs a session in a window until its program has ended. The close button reaches the program as
    /// [`Event::Close`]; the window stays as long as the program goes on.
    ///
    /// # Errors
    /// [`WindowError`] when the window cannot be opened or painted.
    pub fn run(&mut self, session: &mut Session, options: &WindowOptions) -> Result<(), WindowError> {
        checked_scale(options.scale)?;
        let display = self.events.owned_display_handle();
        let mut view = View::new(session, options, display);
        let ran = self.events.run_app_on_demand(&mut view);
        match view.problem {
            Some(problem) => Err(problem),
            None => ran.map_err(|error| WindowError::Open(reason(&error))),
        }
    }
}

fn event_loop() -> Result<EventLoop<()>, winit::error::EventLoopError> {
    let mut builder = EventLoop::builder();
    // The library's menu would end the process at Cmd+Q without any question about unsaved work.
    #[cfg(target_os = "macos")]
    winit::platform::macos::EventLoopBuilderExtMacOS::with_default_menu(&mut builder, false);
    builder.build()
}

/// Runs one session in a window: [`Desktop::connect`] and [`Desktop::run`].
///
/// # Errors
/// [`WindowError`] when the window cannot be opened or painted.
pub fn run(session: &mut Session, options: &WindowOptions) -> Result<(), WindowError> {
    Desktop::connect()?.run(session, options)
}

/// An open window and its surface to paint on.
struct Pane {
    window: Rc<Window>,
    surface: softbuffer::Surface<OwnedDisplayHandle, Rc<Window>>,
}

/// What there is to be seen.
struct Front {
    clock: Clock,
    pane: Option<Pane>,
    /// The picture that the window shows, or is about to be painted with.
    picture: Screen,
    palette: Palette,
    look: Look,
}

impl Front {
    fn paint(&mut self) -> Result<(), softbuffer::SoftBufferError> {
        let Some(pane) = &mut self.pane else { return Ok(()) };
        let size = pane.window.inner_size();
        let (Some(width), Some(height)) = (NonZeroU32::new(size.width), NonZeroU32::new(size.height)) else {
            // A window that is folded away has no pixels.
            return Ok(());
        };
        pane.surface.resize(width, height)?;
        let mut pixels = pane.surface.buffer_mut()?;
        layout_of(size, self.look).paint(&self.picture, self.palette, &mut pixels);
        pane.window.pre_present_notify();
        pixels.present()
    }
}

impl Display for Front {
    /// Asking for a painting never fails; the painting itself comes when the desktop calls for it.
    type Error = Infallible;

    fn now(&self) -> Duration {
        self.clock.now()
    }

    /// Asks for a painting when the picture has changed.
    fn show(&mut self, session: &Session) -> Result<(), Infallible> {
        let (picture, palette, look) = (session.picture(), session.palette(), session.look());
        if picture != self.picture || palette != self.palette || look != self.look {
            (self.picture, self.palette, self.look) = (picture, palette, look);
            if let Some(pane) = &self.pane {
                pane.window.request_redraw();
            }
        }
        Ok(())
    }
}

/// A session as a window shows it.
struct View<'s> {
    session: &'s mut Session,
    options: &'s WindowOptions,
    display: OwnedDisplayHandle,
    front: Front,
    modifiers: ModifiersState,
    /// Where the mouse has moved since the program was told last.
    moved: Option<(i32, i32)>,
    held: [bool; 3],
    /// Parts of a wheel's notch that have not made a whole one.
    turned: f64,
    problem: Option<WindowError>,
    /// The window's title.
    title: String,
}

impl<'s> View<'s> {
    fn new(session: &'s mut Session, options: &'s WindowOptions, display: OwnedDisplayHandle) -> View<'s> {
        View {
            front: Front {
                clock: Clock::start(),
                pane: None,
                picture: session.picture(),
                palette: session.palette(),
                look: session.look(),
            },
            session,
            options,
            display,
            modifiers: ModifiersState::empty(),
            moved: None,
            held: [false; 3],
            turned: 0.0,
            problem: None,
            title: options.title.clone(),
        }
    }

    /// Tells the program one event, after the mouse's last place.
    fn send(&mut self, event: Event) {
        self.send_move();
        self.session.send(event, self.front.now());
    }

    fn send_move(&mut self) {
        if let Some((x, y)) = self.moved.take() {
            self.session.send(Event::Move(x, y), self.front.now());
        }
    }

    fn open(&self, desktop: &ActiveEventLoop) -> Result<Pane, WindowError> {
        let scale = self.options.scale.unwrap_or_else(|| likely_scale(desktop));
        let attributes = Window::default_attributes()
            .with_title(&self.options.title)
            .with_window_icon(icon())
            .with_inner_size(PhysicalSize::new(WIDTH as u32 * scale, HEIGHT as u32 * scale));
        let attributes = named(attributes, &self.options.title);
        let window = desktop.create_window(attributes).map_err(|error| WindowError::Open(reason(&error)))?;
        let window = Rc::new(window);
        // The picture has a pointer of its own.
        window.set_cursor_visible(false);
        let surface = softbuffer::Context::new(self.display.clone())
            .and_then(|context| softbuffer::Surface::new(&context, Rc::clone(&window)))
            .map_err(|error| WindowError::Open(error.to_string()))?;
        Ok(Pane { window, surface })
    }

    fn point(&mut self, place: PhysicalPosition<f64>) {
        let Some(pane) = &self.front.pane else { return };
        let layout = layout_of(pane.window.inner_size(), self.front.look);
        // Outside of the window the mouse is the program's business only while it drags.
        if layout.holds(place.x, place.y) || self.held.contains(&true) {
            self.moved = Some(layout.pixel_at(place.x, place.y));
        }
    }

    fn button(&mut self, button: Button, state: ElementState) {
        // A press and its release always come in pairs, whatever the desktop leaves out: a second press ends the first.
        let down = state == ElementState::Pressed;
        if std::mem::replace(&mut self.held[button as usize], down) {
            self.send(Event::Release(button));
        }
        if down {
            self.send(Event::Press(button));
        }
    }

    /// Tells which modifiers are held.
    fn modify(&mut self, modifiers: ModifiersState) {
        self.modifiers = modifiers;
        let ctrl = CommandKey::HERE.is_held(modifiers);
        for (modifier, down) in [(Modifier::Shift, modifiers.shift_key()), (Modifier::Ctrl, ctrl)] {
            if self.session.mouse().with(modifier) != down {
                self.send(Event::Hold(modifier, down));
            }
        }
    }

    /// Lets go of every button: their releases may go to another window.
    fn let_go(&mut self) {
        for button in [Button::Left, Button::Right, Button::Middle] {
            self.button(button, ElementState::Released);
        }
    }

    fn wheel(&mut self, delta: MouseScrollDelta) {
        /// Pixels that a touchpad moves to a notch of a wheel.
        const NOTCH: f64 = 40.0;
        self.turned += match delta {
            MouseScrollDelta::LineDelta(_, notches) => f64::from(notches),
            MouseScrollDelta::PixelDelta(distance) => distance.y / NOTCH,
        };
        // The conversion saturates.
        let steps = self.turned.trunc() as i32;
        if steps != 0 {
            self.turned = self.turned.fract();
            self.send(Event::Wheel(steps));
        }
    }

    /// A finger is a mouse with its left button down.
    fn touch(&mut self, touch: &Touch) {
        self.point(touch.location);
        match touch.phase {
            TouchPhase::Started => self.button(Button::Left, ElementState::Pressed),
            TouchPhase::Ended | TouchPhase::Cancelled => self.button(Button::Left, ElementState::Released),
            TouchPhase::Moved => {}
        }
    }

    fn key(&mut self, stroke: &Stroke, repeated: bool) {
        if stroke.closes() {
            return self.send(Event::Close);
        }
        for key in stroke.keys() {
            if key != FULL_SCREEN_KEY {
                self.send(Event::Key(key));
            } else if let (Some(pane), false) = (&self.front.pane, repeated) {
                let full = pane.window.fullscreen().is_some();
                pane.window.set_fullscreen((!full).then_some(Fullscreen::Borderless(None)));
            }
        }
    }

    fn event(&mut self, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => self.send(Event::Close),
            WindowEvent::Focused(false) | WindowEvent::Occluded(true) => self.let_go(),
            WindowEvent::Resized(_) => {
                if let Some(pane) = &self.front.pane {
                    pane.window.request_redraw();
                }
            }
            WindowEvent::RedrawRequested => {
                if let Err(error) = self.front.paint() {
                    self.problem = Some(WindowError::Paint(error.to_string()));
                }
            }
            WindowEvent::ModifiersChanged(modifiers) => self.modify(modifiers.state()),
            // A synthetic press is a key that was already down when the window got the keyboard.
            WindowEvent::KeyboardInput { event, is_synthetic: false, .. }
                if event.state == ElementState::Pressed =>
            {
                let stroke = Stroke {
                    command: CommandKey::HERE,
                    logical: event.logical_key,
                    physical: event.physical_key,
                    text: event.text,
                    modifiers: self.modifiers,
                };
                self.key(&stroke, event.repeat);
            }
            WindowEvent::CursorMoved { position, .. } => self.point(position),
            WindowEvent::MouseInput { state, button: MouseButton::Left, .. } => {
                self.button(Button::Left, state);
            }
            WindowEvent::MouseInput { state, button: MouseButton::Right, .. } => {
                self.button(Button::Right, state);
            }
            WindowEvent::MouseInput { state, button: MouseButton::Middle, .. } => {
                self.button(Button::Middle, state);
            }
            WindowEvent::MouseWheel { delta, .. } => self.wheel(delta),
            WindowEvent::Touch(touch) => self.touch(&touch),
            _ => {}
        }
    }
}

impl ApplicationHandler for View<'_> {
    fn resumed(&mut self, desktop: &ActiveEventLoop) {
        if self.front.pane.is_none() {
            match self.open(desktop) {
                Ok(pane) => self.front.pane = Some(pane),
                Err(problem) => self.problem = Some(problem),
            }
        }
    }

    fn window_event(&mut self, _: &ActiveEventLoop, window: WindowId, event: WindowEvent) {
        // A window of an earlier session may have something left to say.
        if self.front.pane.as_ref().is_some_and(|pane| pane.window.id() == window) {
            self.event(event);
        }
    }

    fn about_to_wait(&mut self, desktop: &ActiveEventLoop) {
        self.send_move();
        let Ok(due) = self.front.step(self.session);
        if self.session.ended() || self.problem.is_some() {
            self.front.pane = None;
            desktop.exit();
            return;
        }
        let title = self.session.title(&self.options.title);
        if let (Some(pane), true) = (&self.front.pane, title != self.title) {
            pane.window.set_title(&title);
            self.title = title;
        }
        desktop.set_control_flow(match due.and_then(|due| self.front.clock.at(due)) {
            Some(moment) => ControlFlow::WaitUntil(moment),
            None => ControlFlow::Wait,
        });
    }
}

fn layout_of(size: PhysicalSize<u32>, look: Look) -> Layout {
    Layout::of((size.width as usize, size.height as usize), look)
}

/// An error of the windowing library without the line of the library's source that found it.
fn reason(error: &dyn fmt::Display) -> String {
    let text = error.to_string();
    let message = text.split_once(".rs:").and_then(|(_, rest)| rest.split_once(": "));
    message.map_or(text.as_str(), |(_, message)| message).trim_end_matches('.').to_string()
}

/// The scale for a desktop: 2 where its pixels are of the usual size, more where they are finer, but never
/// more than fits beside bars and frames.
fn likely_scale(desktop: &ActiveEventLoop) -> u32 {
    let monitor = desktop.primary_monitor().or_else(|| desktop.available_monitors().next());
    let Some(monitor) = monitor else { return 1 };
    let size = monitor.size();
    let wanted = (2.0 * monitor.scale_factor()).round() as u32;
    let room = (size.width / WIDTH as u32).min(size.height.saturating_sub(64) / HEIGHT as u32);
    wanted.min(room).clamp(1, LARGEST_SCALE)
}

/// Gives a window the name by which desktops group windows and find their icons.
#[cfg(all(unix, not(target_os = "macos")))]
fn named(attributes: winit::window::WindowAttributes, name: &str) -> winit::window::WindowAttributes {
    use winit::platform::{wayland::WindowAttributesExtWayland, x11::WindowAttributesExtX11};
    let attributes = WindowAttributesExtX11::with_name(attributes, name, name);
    WindowAttributesExtWayland::with_name(attributes, name, name)
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn named(attributes: winit::window::WindowAttributes, _: &str) -> winit::window::WindowAttributes {
    attributes
}

/// A wave through four control points, on the colour of the programs' background.
fn icon() -> Option<Icon> {
    const SIDE: i32 = 32;
    let mut picture = Screen::new();
    picture.bar(0, 0, SIDE - 1, SIDE - 1, Color::LightCyan);
    let wave = |x: i32| 15 - (f64::from(x - 15) * 0.22).sin().mul_add(9.0, 0.0).round() as i32;
    let points: Vec<(i32, i32)> = (2..SIDE - 2).map(|x| (x, wave(x))).collect();
    picture.polyline(&points, crate::screen::Stroke::thick(Color::Blue));
    for x in [3, 11, 20, 28] {
        picture.disc(x, wave(x), 2, Color::Yellow, Color::Black);
    }
    let pixels = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    let rgba = pixels.filter_map(|(x, y)| picture.pixel(x, y)).flat_map(|color| {
        let [red, green, blue] = color.rgb();
        [red, green, blue, 255]
    });
    Icon::from_rgba(rgba.collect(), SIDE as u32, SIDE as u32).ok()
}
