//! The time of a game.

use std::time::Duration;

/// Measures a game from its first change until it is solved. It reads no clock; callers pass the time.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stopwatch {
    begun: Option<Duration>,
    ended: Option<Duration>,
}

impl Stopwatch {
    /// Notes a change of the position.
    pub fn note(&mut self, solved: bool, now: Duration) {
        self.begun.get_or_insert(now);
        self.ended = solved.then(|| self.ended.unwrap_or(now));
    }

    /// The time of the game so far.
    #[must_use]
    pub fn time(&self, now: Duration) -> Duration {
        self.begun.map_or(Duration::ZERO, |begun| self.ended.unwrap_or(now).saturating_sub(begun))
    }

    /// When the displayed second changes; `None` while the time stands still.
    #[must_use]
    pub fn next_second(&self, now: Duration) -> Option<Duration> {
        let begun = self.begun.filter(|_| self.ended.is_none())?;
        Some(begun + Duration::from_secs(self.time(now).as_secs() + 1))
    }

    /// The time as minutes and seconds, `1:05`.
    #[must_use]
    pub fn text(time: Duration) -> String {
        let seconds = time.as_secs();
        format!("{}:{:02}", seconds / 60, seconds % 60)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_runs_from_the_first_change_until_solved() {
        let second = Duration::from_secs;
        let mut watch = Stopwatch::default();
        assert_eq!((watch.time(second(9)), watch.next_second(second(9))), (Duration::ZERO, None));
        watch.note(false, second(10));
        assert_eq!(watch.time(second(75)), second(65));
        assert_eq!(watch.next_second(Duration::from_millis(75_400)), Some(second(76)));
        watch.note(true, second(80));
        watch.note(true, second(90));
        assert_eq!((watch.time(second(99)), watch.next_second(second(99))), (second(70), None));
        // Undoing the last move continues the game.
        watch.note(false, second(100));
        assert_eq!(Stopwatch::text(watch.time(second(101))), "1:31");
    }
}
