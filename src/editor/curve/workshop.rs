//! The workshop of section 2.3.8: treats the control points as measured points, compares the curves of that section
//! on them, and smooths them by a B-spline and a Bézier curve.

use super::ask::FEWEST;
use super::compare::Kind;
use super::{Ambient, Curves};
use crate::design::{Place, Sketch};
use crate::editor::lens::Lens;
use crate::editor::{Editor, refusal};
use crate::figure::Figure;
use crate::geometry::{FEWEST_MEASURED, Point, Residuals, Smoothed, Smoothing, smooth};
use crate::machine::{Asked, Key, Language, Stop};
use crate::screen::{Color, Screen};
use crate::ui::words;
use crate::ui::{Desk, Picture, Stay, TOP, page};
use serde::Serialize;

// Points that have a curve can be smoothed.
const _: () = assert!(FEWEST >= FEWEST_MEASURED);

/// The compared curves.
const COMPARED: [Kind; 3] = [Kind::Spline, Kind::Bezier, Kind::BSpline3];
/// Radius of a smoothed point's disc in pixels.
const RADIUS: i32 = 3;
/// Left edge of the text on the communication page.
const LEFT: i32 = 214;

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// The key F5: shows the curves and the smoothed points. Enter adopts the points, Esc changes nothing.
    pub(super) async fn open_workshop(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.count() < FEWEST {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        }
        let smoothed = match smooth(&self.history.now().points, Smoothing::of(self.count())) {
            Ok(smoothed) => smoothed,
            Err(error) => {
                desk.tell(refusal::of_curve(&error.into()), Stay::UntilRead);
                return Ok(());
            }
        };
        // Measured points are open, even if the chosen curve is closed.
        let compared = std::mem::replace(&mut self.craft.compared, COMPARED.to_vec());
        self.craft.measured = true;
        let taken = self.look_at(desk, &smoothed).await;
        (self.craft.measured, self.craft.compared) = (false, compared);
        taken?;
        self.take_over(&smoothed);
        Ok(())
    }

    /// Shows the workshop until Enter; Esc cancels.
    async fn look_at(&self, desk: &mut Desk<'_>, smoothed: &Smoothed<D>) -> Asked<()> {
        let workshop = Workshop { editor: self, smoothed };
        loop {
            match desk.event(&workshop).await?.key() {
                Some(Key::Enter) => return Ok(()),
                Some(Key::Esc | Key::F(5)) => return Err(Stop::Cancelled),
                _ => {}
            }
        }
    }

    /// Replaces the points by the smoothed ones, rounded to integers as the files hold them.
    fn take_over(&mut self, smoothed: &Smoothed<D>) {
        let rounded = smoothed.points.iter().map(|point| point.map(f64::round_ties_even)).collect();
        // Averages of points in the field lie in the field, so they fit.
        if let Ok(sketch) = (Sketch { points: rounded, ..self.history.now().clone() }).fitting() {
            self.change(sketch);
        }
    }
}

/// The picture of the workshop.
struct Workshop<'e, const D: usize>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    editor: &'e Editor<Curves<D>, D>,
    smoothed: &'e Smoothed<D>,
}

impl<const D: usize> Picture for Workshop<'_, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    fn draw(&self, screen: &mut Screen, language: Language) {
        self.editor.draw(screen, language);
        for (x, y) in self.smoothed.points.iter().map(|&point| self.editor.lens.pixel(point)) {
            screen.disc(x, y, RADIUS, Color::LightGreen, Color::Black);
        }
        draw_page(screen, &self.smoothed.residuals, language);
    }

    fn figure(&self) -> Option<Figure> {
        let mut figure = self.editor.figure()?;
        self.smoothed.points.iter().for_each(|&point| figure.plot_joint(self.editor.lens.flat(point)));
        Some(figure)
    }
}

/// The communication page: which colour is which curve, the residuals, the keys.
fn draw_page(screen: &mut Screen, residuals: &Residuals, language: Language) {
    page(screen, TOP);
    let mut x = LEFT;
    for (_, name, color) in Kind::ALL.into_iter().filter(|(kind, ..)| COMPARED.contains(kind)) {
        screen.bar(x, 10, x + 8, 17, color);
        screen.text(x + 12, 10, name, Color::Black);
        x += 26 + 8 * name.chars().count() as i32; // names of a few letters
    }
    screen.text(LEFT, 22, words::residuals(residuals).of(language), Color::Black);
    screen.text(LEFT, 35, words::TAKE_OVER.of(language), Color::Black);
}
