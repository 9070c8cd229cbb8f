//! The clock of displays that run on the system's time.

use std::time::{Duration, Instant};

/// Time since a display was opened.
pub(super) struct Clock(Instant);

impl Clock {
    pub(super) fn start() -> Clock {
        Clock(Instant::now())
    }

    /// The time in whole milliseconds, the resolution of scripts.
    pub(super) fn now(&self) -> Duration {
        Duration::from_millis(u64::try_from(self.0.elapsed().as_millis()).unwrap_or(u64::MAX))
    }

    /// The instant of a moment; `None` if it is beyond the range of [`Instant`].
    #[cfg(any(feature = "window", feature = "terminal"))]
    pub(super) fn at(&self, moment: Duration) -> Option<Instant> {
        self.0.checked_add(moment)
    }
}
