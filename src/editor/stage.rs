//! The stages of an editor, from the first question to the result.

/// What the screen shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    /// Before there is a configuration. Before the first one, there are no buttons either.
    Starting { buttons: bool },
    /// Editing.
    Working,
    /// Editing, while the curve is being chosen.
    Choosing,
    /// Editing, while automatic tangents are offered after an action.
    Offering,
    /// The result without frame and buttons, with or without the control points.
    Result { points: bool },
    /// On the way back from the result of a surface.
    Returning,
}

impl Stage {
    /// The stage of a program that has just been started.
    pub(crate) const FIRST: Stage = Stage::Starting { buttons: false };

    /// The stage before a new configuration; buttons that are shown stay.
    pub(crate) fn restarted(self) -> Stage {
        Stage::Starting { buttons: self != Stage::FIRST }
    }

    /// Whether there is a configuration to show.
    pub(crate) fn begun(self) -> bool {
        !matches!(self, Stage::Starting { .. })
    }

    /// Whether the result is shown.
    pub(crate) fn is_result(self) -> bool {
        matches!(self, Stage::Result { .. })
    }
}

/// Whether the curve or surface is in the picture, and when it disappears.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shown {
    /// Whether there is one to show as a result. As in the original, a change by number ends that.
    pub(crate) known: bool,
    /// Whether it is in the picture.
    pub(crate) visible: bool,
    /// Whether it stays in the picture and follows changes.
    pub(crate) follow: bool,
}

impl Shown {
    /// Shows the curve, or none.
    pub(crate) fn take(&mut self, known: bool) {
        (self.known, self.visible) = (known, known);
    }

    /// Called after a change: it leaves the picture, unless it follows.
    pub(crate) fn after_change(&mut self) {
        self.visible &= self.follow;
    }

    /// Called after a change by number: there is no result any more, unless it follows.
    pub(crate) fn after_edit(&mut self) {
        if !self.follow {
            self.take(false);
        }
    }
}
