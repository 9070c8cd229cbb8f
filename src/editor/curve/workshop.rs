//! The workshop of section 2.3.8: treats the control points as measured points, compares the curves of that section
//! on them, and smooths them by a B-spline and a Bézier curve.

use super::ask::FEWEST;
use super::compare::Kind;
use super::{Ambient, Curves};
use crate::design::{Place, Sketch};
use crate::editor::field::apart;
use crate::editor::lens::Lens;
use crate::editor::{Editor, refusal};
use crate::figure::Figure;
use crate::geometry::{FEWEST_MEASURED, Point, Smoothed, Smoothing, slopes, smooth, smoothed_tangents};
use crate::machine::{Asked, Key, Language, Manner, Stop};
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
/// How near to a smoothed point the mouse asks for its value and slope, in pixels.
const REACH: i32 = 8;
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
        let (points, smoothing) = (&self.history.now().points, Smoothing::of(self.count()));
        let made = smooth(points, smoothing)
            .and_then(|smoothed| Ok((smoothed, smoothed_tangents(points, smoothing)?)));
        let (smoothed, tangents) = match made {
            Ok(made) => made,
            Err(error) => {
                desk.tell(refusal::of_curve(&error.into()), Stay::UntilRead);
                return Ok(());
            }
        };
        // Measured points are open, even if the chosen curve is closed.
        let compared = std::mem::replace(&mut self.craft.compared, COMPARED.to_vec());
        self.craft.measured = true;
        let taken = self.look_at(desk, &smoothed, &tangents).await;
        (self.craft.measured, self.craft.compared) = (false, compared);
        taken?;
        self.take_over(&smoothed);
        Ok(())
    }

    /// Shows the workshop until Enter; Esc cancels. In the manner of today the mouse asks points for their values.
    async fn look_at(&self, desk: &mut Desk<'_>, smoothed: &Smoothed<D>, tangents: &[Point<D>]) -> Asked<()> {
        let mut workshop = Workshop { editor: self, smoothed, tangents, asked: None };
        loop {
            let tick = desk.event(&workshop).await?;
            match tick.key() {
                Some(Key::Enter) => return Ok(()),
                Some(Key::Esc | Key::F(5)) => return Err(Stop::Cancelled),
                _ => {}
            }
            let today = desk.machine.manner() == Manner::Today;
            workshop.asked = workshop.nearest((tick.mouse.x, tick.mouse.y)).filter(|_| today);
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
    /// The tangents of the smooth curve at the smoothed points.
    tangents: &'e [Point<D>],
    /// The point whose value and slope are shown.
    asked: Option<usize>,
}

impl<const D: usize> Workshop<'_, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// The smoothed point at a pixel.
    fn nearest(&self, at: (i32, i32)) -> Option<usize> {
        let distance =
            |(index, &point): (usize, &Point<D>)| (apart(self.editor.lens.pixel(point), at), index);
        let nearest = self.smoothed.points.iter().enumerate().map(distance).min()?;
        Some(nearest.1).filter(|_| nearest.0 <= i64::from(REACH * REACH))
    }

    /// What the page tells: value and slope of a point, else how far the points have moved.
    fn told(&self, language: Language) -> String {
        let point = self.asked.and_then(|index| {
            let (point, tangent) = (self.smoothed.points.get(index)?, self.tangents.get(index)?);
            Some(words::value_and_slope(index + 1, point, &slopes(*tangent)))
        });
        let residuals = || words::residuals(&self.smoothed.residuals);
        point.unwrap_or_else(residuals).of(language).to_owned()
    }
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
        draw_page(screen, &self.told(language), language);
    }

    fn figure(&self) -> Option<Figure> {
        let mut figure = self.editor.figure()?;
        self.smoothed.points.iter().for_each(|&point| figure.plot_joint(self.editor.lens.flat(point)));
        Some(figure)
    }
}

/// The communication page: which colour is which curve, a line about the points, the keys.
fn draw_page(screen: &mut Screen, told: &str, language: Language) {
    page(screen, TOP);
    let mut x = LEFT;
    for (_, name, color) in Kind::ALL.into_iter().filter(|(kind, ..)| COMPARED.contains(kind)) {
        screen.bar(x, 10, x + 8, 17, color);
        screen.text(x + 12, 10, name, Color::Black);
        x += 26 + 8 * name.chars().count() as i32; // names of a few letters
    }
    screen.text(LEFT, 22, told, Color::Black);
    screen.text(LEFT, 35, words::TAKE_OVER.of(language), Color::Black);
}
