//! Where an editor is between the first question and the result.

/// What the screen shows besides what is edited.
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
    /// The result without its surroundings, with or without the control points.
    Result { points: bool },
    /// On the way back from the result of a surface.
    Returning,
}

impl Stage {
    /// The stage of a program that has just been started.
    pub(super) const FIRST: Stage = Stage::Starting { buttons: false };

    /// The stage before a new configuration: once the buttons are on the screen, they stay.
    pub(super) fn restarted(self) -> Stage {
        Stage::Starting { buttons: self != Stage::FIRST }
    }

    /// Whether there is a configuration to show.
    pub(super) fn begun(self) -> bool {
        !matches!(self, Stage::Starting { .. })
    }

    /// Whether the result is shown.
    pub(super) fn is_result(self) -> bool {
        matches!(self, Stage::Result { .. })
    }
}

/// Whether the curve or surface is in the picture, and when it goes out of it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shown {
    /// Whether there is one to show as a result: not any more after a change by number, as in the original.
    pub(super) known: bool,
    /// Whether it is in the picture.
    pub(super) visible: bool,
    /// Whether it stays in the picture after a change and follows it.
    pub(super) follow: bool,
}

impl Shown {
    /// Shows the curve, or none.
    pub(super) fn take(&mut self, known: bool) {
        (self.known, self.visible) = (known, known);
    }

    /// After a change it leaves the picture, unless it follows.
    pub(super) fn after_change(&mut self) {
        self.visible &= self.follow;
    }

    /// After a change by number there is none, unless it follows.
    pub(super) fn after_edit(&mut self) {
        if !self.follow {
            self.take(false);
        }
    }
}
