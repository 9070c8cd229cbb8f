//! Bias and tension of single joints, which the book proposes (2.68) but its program lacks, and of all joints in
//! common.

use super::{Ambient, Curves};
use crate::design::{Place, Sketch};
use crate::editor::Editor;
use crate::editor::lens::Lens;
use crate::editor::picture::Page;
use crate::editor::stage::Stage;
use crate::editor::values;
use crate::geometry::{Point, Shape};
use crate::machine::Asked;
use crate::screen::Color;
use crate::ui::words;
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Stay};
use serde::Serialize;

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// Asks for a joint and gives it a shape of its own.
    pub(super) async fn change_joint(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.count() == 0 {
            desk.tell(words::NO_POINTS, Stay::Briefly);
            return Ok(());
        }
        let count = i32::try_from(self.count()).unwrap_or(i32::MAX);
        let field = |x: i32, y: i32, longest: i32, kind: Number| Field {
            area: Area::new(x, y - 3, x + 13 + 8 * longest, y + 10),
            at: (x + 8, y),
            longest: longest as usize,
            kind,
        };
        let form = Form::new(
            vec![
                Caption::new((216, 12), words::JOINT_ENTRY),
                Caption::new((216, 30), words::JOINT_BIAS),
                Caption::new((324, 30), words::JOINT_TENSION),
            ],
            [
                field(284, 12, 2, Number::Whole(1..=count)),
                field(264, 30, 4, Number::Real(values::BIAS.range())),
                field(376, 30, 5, Number::Real(values::TENSION.range())),
            ],
        );
        let [joint, bias, tension] = desk.numbers(self, &form).await?;
        let sketch = self.history.now().with_joint(joint as usize - 1, Shape { bias, tension });
        self.reshape(desk, sketch);
        Ok(())
    }

    /// Gives every joint the common shape again.
    pub(super) fn make_joints_alike(&mut self, desk: &mut Desk<'_>) {
        let sketch = Sketch { joints: None, ..self.history.now().clone() };
        self.reshape(desk, sketch);
        desk.tell(words::JOINTS_ALIKE, Stay::Briefly);
    }

    /// Writes the shapes of joints that have their own beside them.
    pub(super) fn draw_joint_shapes(&self, page: &mut Page<'_>) {
        let sketch = self.drawn();
        let points = self.stage != Stage::Result { points: false };
        let Some(joints) = sketch.joints.as_ref().filter(|_| points) else { return };
        // Without a curve no joints are shown; the values are written at the control point.
        let marks = sketch.curve().ok().filter(|_| self.shown.known).map(|curve| curve.joints());
        let marks = marks.unwrap_or_default();
        for (index, (shape, &point)) in joints.iter().zip(&sketch.points).enumerate() {
            if *shape == sketch.shape() {
                continue;
            }
            let (x, y) = self.lens.pixel(marks.get(index).copied().unwrap_or(point));
            let text = format!("{};{}", shape.bias, shape.tension);
            let width = 8 * i32::try_from(text.len()).unwrap_or(0);
            page.screen.bar(x + 8, y - 15, x + 8 + width, y - 5, Color::Black);
            page.screen.text(x + 9, y - 14, &text, Color::Yellow);
        }
    }
}
