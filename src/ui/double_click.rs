//! Two clicks in the same place within a short time.

use crate::machine::Tick;
use std::time::Duration;

/// The longest time between the two clicks.
const LONGEST: Duration = Duration::from_millis(400);
/// The greatest distance between them in pixels, in each direction.
const REACH: i32 = 4;

/// Tells double clicks from single ones.
#[derive(Clone, Copy, Debug, Default)]
pub struct DoubleClick {
    /// When and where the click before was.
    before: Option<(Duration, (i32, i32))>,
}

impl DoubleClick {
    /// Where a double click ended, if the event is the second of its two clicks. To be told of every event.
    pub fn of(&mut self, tick: &Tick) -> Option<(i32, i32)> {
        let (x, y) = tick.click()?;
        let double = self.before.take().is_some_and(|(then, (left, top))| {
            tick.now.saturating_sub(then) <= LONGEST && (x - left).abs() <= REACH && (y - top).abs() <= REACH
        });
        if double {
            return Some((x, y));
        }
        self.before = Some((tick.now, (x, y)));
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Button, Event, Mouse};

    #[test]
    fn two_clicks_are_one_double_click() {
        let mut clicks = DoubleClick::default();
        let mut click = |now, x| {
            let mouse = Mouse { x, y: 0, ..Mouse::default() };
            let event = Some(Event::Press(Button::Left));
            clicks.of(&Tick { event, mouse, now: Duration::from_millis(now) })
        };
        assert_eq!(click(0, 10), None);
        assert_eq!(click(300, 12), Some((12, 0)));
        // The third click begins anew; what is too late or too far is single.
        assert_eq!(click(400, 12), None);
        assert_eq!(click(900, 12), None);
        assert_eq!(click(1000, 30), None);
        assert_eq!(click(1100, 30), Some((30, 0)));
    }
}
