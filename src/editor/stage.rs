//! Where an editor of curves is between the first question and the result.

/// What the screen shows besides the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stage {
    /// Before there is a configuration; before the first one there are no buttons either.
    Starting { buttons: bool },
    /// Editing.
    Working,
    /// Editing, while the curve is being chosen.
    Choosing,
    /// Editing, while automatic tangents are offered after an action.
    Offering,
    /// The curve without its surroundings, with or without the control points.
    Result { points: bool },
}

impl Stage {
    /// The stage of a program that has just been started.
    pub(super) const FIRST: Stage = Stage::Starting { buttons: false };

    /// The stage before a new configuration: once the buttons are on the screen, they stay.
    pub(super) fn restarted(self) -> Stage {
        Stage::Starting { buttons: self != Stage::FIRST }
    }
}
