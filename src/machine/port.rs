//! The port between a program and the display that polls it.
//!
//! A program and its display never run at the same time: the program runs until it awaits, then the display runs. The
//! screen is moved from one to the other at the await, so it is never shared.

use super::event::{Mouse, Tick};
use super::prompt::Prompt;
use super::{Asked, Language, Manner, Pointer, Pointing, Preferences, StorageError};
use crate::screen::Screen;
use serde::Serialize;
use std::cell::RefCell;
use std::future::Future;
use std::pin::Pin;
use std::rc::Rc;
use std::task::{Context, Poll};
use std::time::Duration;

/// What a program waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wait {
    /// The next event, however long it takes.
    Event,
    /// The next event, or the next frame of an animation.
    Frame,
    /// The next event, or this moment.
    Until(Duration),
}

/// A model that can be written as JSON at any time.
pub(super) trait Model {
    fn json(&self) -> serde_json::Result<String>;
}

impl<T: Serialize> Model for T {
    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(self)
    }
}

/// What program and display exchange while the program waits.
pub(super) struct Port {
    /// The screen as the program left it; while the program runs, the spare one.
    pub(super) screen: Box<Screen>,
    pub(super) pointer: Pointer,
    pub(super) mouse: Mouse,
    pub(super) now: Duration,
    pub(super) wait: Wait,
    pub(super) model: Option<Box<dyn Model>>,
    pub(super) language: Language,
    pub(super) manner: Manner,
    pub(super) pointing: Pointing,
    pub(super) preferences: Preferences,
    /// The file that the work belongs to.
    pub(super) file: Option<String>,
    /// Whether something would be lost.
    pub(super) unsaved: bool,
    /// Whether a film is being recorded.
    pub(super) filming: bool,
    /// The error of saving after the program had ended.
    pub(super) lost: Option<StorageError>,
    pub(super) prompt: Prompt,
    /// What the waiting program gets when it is polled next.
    pub(super) answer: Option<Asked<Tick>>,
}

/// The future of one wait: hands the screen over when it starts to wait and takes it back at the end.
pub(super) struct Turn<'m> {
    pub(super) port: &'m Rc<RefCell<Port>>,
    pub(super) screen: &'m mut Box<Screen>,
    pub(super) wait: Wait,
    pub(super) handed_over: bool,
}

impl Turn<'_> {
    fn swap_screens(&mut self) {
        std::mem::swap(self.screen, &mut self.port.borrow_mut().screen);
        self.handed_over = !self.handed_over;
    }
}

impl Future for Turn<'_> {
    type Output = Asked<Tick>;

    fn poll(mut self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Self::Output> {
        if !self.handed_over {
            self.swap_screens();
            self.port.borrow_mut().wait = self.wait;
            return Poll::Pending;
        }
        let answer = self.port.borrow_mut().answer.take();
        match answer {
            Some(answer) => {
                self.swap_screens();
                Poll::Ready(answer)
            }
            None => Poll::Pending,
        }
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        // A wait dropped half way must not leave the program with the display's screen.
        if self.handed_over {
            self.swap_screens();
        }
    }
}
