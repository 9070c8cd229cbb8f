//! Where a session shows itself: a window, a terminal. The canvas of a browser would be the third.
//!
//! A display has what only the system can give: a clock, keys, a mouse, something to paint on. It knows nothing of
//! what a program draws, and programs know nothing of it. What displays do alike is [`Display::step`]; whether it
//! is called by a loop, as in the terminal, or by a desktop that calls when something has happened, is theirs.

#[cfg(any(feature = "window", feature = "terminal"))]
mod clock;
#[cfg(feature = "terminal")]
pub mod terminal;
#[cfg(feature = "window")]
pub mod window;

use crate::machine::Session;
use std::time::Duration;

/// A place where the picture of a session can be seen.
pub trait Display {
    /// What can go wrong with it.
    type Error: std::error::Error;

    /// The time since it began to show the session, in whole milliseconds, as scripts count: the time of
    /// everything that the session is told.
    fn now(&self) -> Duration;

    /// Shows the picture, unless it is shown already. A display that is slower than the session may let a picture
    /// pass; it shows a later one when it is asked again.
    ///
    /// # Errors
    /// What went wrong; nothing more can be shown then.
    fn show(&mut self, session: &Session) -> Result<(), Self::Error>;

    /// Lets the session's time go on until now, and shows what has come of it. Gives the moment, in the time of
    /// [`Display::now`], when the session wants this again although nothing has happened; `None` when it waits for
    /// an event, or has ended.
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

/// A moment rounded up to whole milliseconds, so that a deadline that is due by the display's clock is due by the
/// session's too.
fn whole_milliseconds(moment: Duration) -> Duration {
    Duration::from_millis(u64::try_from(moment.as_nanos().div_ceil(1_000_000)).unwrap_or(u64::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Event, Key, Machine, Memory, Settings};
    use crate::screen::Color;
    use std::convert::Infallible;

    /// A display whose time is what it is set to; it notes a pixel of every picture.
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
