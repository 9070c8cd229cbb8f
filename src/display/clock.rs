//! The clock of the displays that have the system's.

use std::time::{Duration, Instant};

/// The time since a display began.
pub(super) struct Clock(Instant);

impl Clock {
    pub(super) fn start() -> Clock {
        Clock(Instant::now())
    }

    /// Whole milliseconds, as scripts count.
    pub(super) fn now(&self) -> Duration {
        Duration::from_millis(u64::try_from(self.0.elapsed().as_millis()).unwrap_or(u64::MAX))
    }

    /// A moment as the system counts; `None` if it is too far away for that.
    pub(super) fn at(&self, moment: Duration) -> Option<Instant> {
        self.0.checked_add(moment)
    }
}
