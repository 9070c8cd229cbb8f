//! The shapes of single joints, which the book proposes (2.68) and its program does not have, and the
//! common shape of all of them.

use super::layout::to_screen;
use super::{Editor, Sketch, Tools, curves};
use crate::editor::beta;
use crate::geometry::Shape;
use crate::machine::Asked;
use crate::screen::{Color, Screen};
use crate::ui::words;
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Stay};

impl Editor {
    /// Changes the bias (`A`) or the tension (`C`) of the whole curve.
    pub(super) async fn change_shape(&mut self, desk: &mut Desk<'_>, letter: char) -> Asked<()> {
        let number = match letter {
            'A' => beta::ask_bias(desk, self).await?,
            _ => beta::ask_tension(desk, self).await?,
        };
        let set = |shape: &mut Shape| match letter {
            'A' => shape.bias = number,
            _ => shape.tension = number,
        };
        let mut sketch = self.history.now().clone();
        set(&mut sketch.shape);
        sketch.joints.iter_mut().flatten().for_each(set);
        self.reshape(desk, sketch);
        Ok(())
    }

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
                field(264, 30, 4, Number::Real(beta::BIAS)),
                field(376, 30, 5, Number::Real(beta::TENSION)),
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

    /// Makes a sketch of another shape the present one; if it has no curve, that is explained and the
    /// numbers stay as the user typed them.
    fn reshape(&mut self, desk: &mut Desk<'_>, sketch: Sketch) {
        self.history.change(sketch);
        self.shown.after_change();
        if let Some(choice) = self.shown.choice
            && let Err(error) = curves::pixels(self.tools, choice, self.history.now())
        {
            desk.tell(words::no_curve(&error), Stay::UntilRead);
        }
    }

    /// The shapes of the joints that have one of their own, written beside them.
    pub(super) fn draw_joint_shapes(&self, screen: &mut Screen) {
        let sketch = self.preview();
        let (Tools::Beta, Some(joints)) = (self.tools, &sketch.joints) else { return };
        let marks = self.shown.choice.and_then(|choice| curves::pixels(self.tools, choice, &sketch).ok());
        for (index, (shape, &point)) in joints.iter().zip(sketch.points()).enumerate() {
            if *shape == sketch.shape {
                continue;
            }
            let mark = marks.as_ref().and_then(|pixels| pixels.joints.get(index)).copied();
            // Without a curve there are no joints to see yet: the values stand at the control point.
            let (x, y) = mark.unwrap_or_else(|| to_screen(point));
            let text = format!("{};{}", shape.bias, shape.tension);
            let width = 8 * i32::try_from(text.len()).unwrap_or(0);
            screen.bar(x + 8, y - 15, x + 8 + width, y - 5, Color::Black);
            screen.text(x + 9, y - 14, &text, Color::Yellow);
        }
    }
}
