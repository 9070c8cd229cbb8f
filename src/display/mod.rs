//! Where a session is shown: a window, a terminal, or the canvas of a browser. A second, smaller window (`minifb`) is for
//! systems where the usual one does not build.
//!
//! A display provides what only the system can: a clock, keys, a mouse and a surface to paint on. It knows nothing of
//! what a program draws, and programs know nothing of it. All displays share [`Display::step`]. The terminal calls it
//! in a loop, the window from desktop events, the canvas from the frames of a browser.

#[cfg(feature = "web")]
pub mod canvas;
#[cfg(any(feature = "window", feature = "terminal", feature = "minifb"))]
mod clock;
#[cfg(any(feature = "window", feature = "minifb"))]
mod desktop;
#[cfg(any(feature = "window", feature = "minifb", feature = "web"))]
mod layout;
#[cfg(feature = "minifb")]
pub mod minifb;
#[cfg(feature = "terminal")]
pub mod terminal;
#[cfg(feature = "window")]
pub mod window;

#[cfg(any(feature = "window", feature = "minifb"))]
pub use desktop::{LARGEST_SCALE, WindowError, window_possible};

use crate::machine::Session;
use std::time::Duration;

/// Shows the picture of a session.
pub trait Display {
    /// Its error.
    type Error: std::error::Error;

    /// The time since it began to show the session, in whole milliseconds. Events are passed to the session with
    /// this time.
    fn now(&self) -> Duration;

    /// Shows the picture, unless it is shown already. A display that is slower than the session may skip pictures.
    ///
    /// # Errors
    /// The display has failed and can show nothing more.
    fn show(&mut self, session: &Session) -> Result<(), Self::Error>;

    /// Advances the session to the present and shows the result. Returns the session's next deadline, in the time of
    /// [`Display::now`]; `None` when it waits for an event or has ended.
    ///
    /// # Errors
    /// Those of [`Display::show`].
    fn step(&mut self, session: &mut Session) -> Result<Option<Duration>, Self::Error> {
        session.advance(self.now());
        if !session.ended() {
            self.show(session)?;
        }
        Ok(session.deadline().map(whole_milliseconds))
    }
}

/// Rounds up to whole milliseconds, so that a deadline reached on the display's clock is also reached on the
/// session's.
fn whole_milliseconds(moment: Duration) -> Duration {
    Duration::from_millis(u64::try_from(moment.as_nanos().div_ceil(1_000_000)).unwrap_or(u64::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Event, Key, Machine, Memory, Settings};
    use crate::screen::Color;
    use std::convert::Infallible;

    /// A display with a settable time; it records a pixel of every picture.
    #[derive(Default)]
    struct Wall {
        now: Duration,
        seen: Vec<Option<Color>>,
    }

    impl Display for Wall {
        type Error = Infallible;

        fn now(&self) -> Duration {
            self.now
        }

        fn show(&mut self, session: &Session) -> Result<(), Infallible> {
            self.seen.push(session.screen().pixel(0, 0));
            Ok(())
        }
    }

    #[test]
    fn a_step_shows_what_has_come_of_the_time_and_tells_when_the_next_is_due() {
        let machine = Machine::new(Box::new(Memory::default()), Settings::default());
        let mut session = Session::start(machine, |mut machine| async move {
            machine.event_before(Duration::from_micros(2500)).await?;
            machine.screen().clear(Color::Red);
            machine.event().await?;
            Ok(())
        });
        let mut wall = Wall::default();
        assert_eq!(wall.step(&mut session), Ok(Some(Duration::from_millis(3))));
        wall.now = Duration::from_millis(3);
        assert_eq!(wall.step(&mut session), Ok(None));
        session.send(Event::Key(Key::Esc), wall.now());
        assert_eq!(wall.step(&mut session), Ok(None));
        assert_eq!(
            wall.seen,
            [Some(Color::Black), Some(Color::Red)],
            "a program that has ended shows nothing"
        );
    }
}
