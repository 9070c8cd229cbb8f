//! Fitting the coefficients to the control points of a stored plane curve.

use super::{Editor, layout};
use crate::file::{Document, Format, Fourier, HARMONICS, PlanePoints};
use crate::geometry::{self, BoundingBox, ClosedPath, CubicBezier, Deviation, GeometryError, Point};
use crate::machine::Asked;
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Area, Caption, Desk, Field, Form, Number, Question, Stay, TOP, Way};
use crate::work::read_document;

/// Number of samples for measuring the error.
const STEPS: usize = 1000;

/// The number of harmonics a file can hold.
const MOST: usize = HARMONICS - 1;

/// The closed curve through the control points that is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// The polygon, parametrized by arc length.
    Polygon,
    /// The closed spline of chapter 2.3.5.
    Spline,
}

/// The target of a fit.
pub(super) struct Target {
    /// The file's name and the shape.
    pub(super) name: Phrase,
    /// The curve itself, in the middle of the field.
    pub(super) path: ClosedPath<2>,
    /// The curve in pixels.
    pub(super) outline: Vec<(i32, i32)>,
}

impl Target {
    /// The closed curve of these points, centred in the field and reduced if it does not fit.
    fn new(name: &str, shape: Shape, points: &[Point<2>]) -> Result<Target, GeometryError> {
        let moved: Vec<Point<2>>;
        let path = shape.path(
            match shape.path(points)?.arcs().iter().map(CubicBezier::bounding_box).reduce(BoundingBox::union)
            {
                Some(bounds) => {
                    moved = points.iter().map(|&point| into_field(bounds, point)).collect();
                    &moved
                }
                None => points,
            },
        )?;
        // The last sample is the first one again.
        let outline = (0..=STEPS).map(|j| layout::to_screen(path.eval(j as f64 / STEPS as f64))).collect();
        let words = match shape {
            Shape::Polygon => words::OF_POLYGON,
            Shape::Spline => words::OF_SPLINE,
        };
        let name = Phrase::new(format!("{name} {}", words.0), format!("{name} {}", words.1));
        Ok(Target { name, path, outline })
    }

    /// The curve of so many harmonics nearest to the target.
    fn fit(&self, harmonics: usize) -> Result<Fourier, GeometryError> {
        geometry::Fourier::fit(&self.path, harmonics).map(|curve| Fourier::of_curve(&curve))
    }

    /// How far a curve is from the target, in pixels at equal parameters.
    pub(super) fn deviation(&self, fourier: &Fourier) -> Option<Deviation> {
        fourier.curve().and_then(|curve| curve.deviation(&self.path, STEPS)).ok()
    }
}

impl Shape {
    fn path(self, points: &[Point<2>]) -> Result<ClosedPath<2>, GeometryError> {
        match self {
            Shape::Polygon => ClosedPath::polygon(points),
            Shape::Spline => ClosedPath::spline(points),
        }
    }
}

/// The place in the field of a point of something with these bounds.
fn into_field(bounds: BoundingBox<2>, point: Point<2>) -> Point<2> {
    let size = bounds.size();
    let fits = |d: usize| if size[d] > 0.0 { 2.0 * layout::REACH[d] / size[d] } else { 1.0 };
    let scale = fits(0).min(fits(1)).min(1.0);
    std::array::from_fn(|d| scale * (point[d] - 0.5 * (bounds.min[d] + bounds.max[d])))
}

impl Editor {
    /// Asks for a file of control points, the number of harmonics and the shape, and fits.
    pub(super) async fn fit(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        self.marked = None;
        let name = desk.file_name(self, Format::Ip2.extension(), Way::Load).await?;
        let points = match read_document(desk.machine.storage(), &name, Format::Ip2) {
            Ok(Document::PlanePoints(PlanePoints { points, .. })) => points,
            Ok(_) => Vec::new(),
            Err(problem) => {
                desk.tell(problem, Stay::UntilRead);
                return Ok(());
            }
        };
        let harmonics = self.ask_harmonics(desk).await?;
        let question = Question::new(TOP, words::ASK_FIT_SHAPE, [words::POLYGON, words::SPLINE_SHAPE]);
        let shape = match desk.ask(self, &question).await? {
            Answer::First => Shape::Polygon,
            Answer::Second => Shape::Spline,
        };
        let fitted =
            Target::new(&name, shape, &points).and_then(|target| Ok((target.fit(harmonics)?, target)));
        match fitted {
            Ok((fourier, target)) => {
                self.change(fourier);
                self.target = Some(target);
            }
            Err(error) => desk.tell(Phrase::plain(&error), Stay::UntilRead),
        }
        Ok(())
    }

    async fn ask_harmonics(&self, desk: &mut Desk<'_>) -> Asked<usize> {
        let field = Field {
            area: Area::new(330, 19, 361, 32),
            at: (338, 22),
            longest: 2,
            kind: Number::Whole(1..=MOST as i32),
        };
        let form = Form::new(vec![Caption::new((222, 23), words::HARMONICS_ENTRY)], [field]);
        let [number] = desk.numbers(self, &form).await?;
        Ok(number as usize)
    }
}
