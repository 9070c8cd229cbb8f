//! The reachable region (F8).

use super::bench::Bench;
use crate::editor::Editor;
use crate::screen::Screen;

impl Editor<Bench, 2> {
    /// Shades what the knots reach.
    pub(super) fn draw_region(&self, _: &mut Screen) {}
}
