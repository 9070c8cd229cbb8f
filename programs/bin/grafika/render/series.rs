//! Curves of several methods or values in one picture, each in its colour, with a legend.

use super::Render;
use crate::curve::failure;
use crate::picture::Format;
use grafika::design::{Controls, Shape};
use grafika::figure::{Figure, SERIES_INKS, closure};
use grafika::file::SPACE_VIEW;
use grafika::geometry::{BoundingBox, Closure, Point, View};
use grafika::launch::{Failure, progress};

impl Render {
    /// The picture of a series.
    pub(super) fn series(&self, format: Format) -> Result<Vec<u8>, Failure> {
        self.check_series(format)?;
        let (members, name) = self.curve.series()?;
        let alive = progress::alive("drawing");
        let view = View::from_direction(self.view.unwrap_or(SPACE_VIEW));
        let mut figure = self.titled();
        let mut points: Vec<Point<2>> = Vec::new();
        let mut bounds: Option<BoundingBox<3>> = None;
        let shape = |member: &crate::series::Member| {
            member.design.shape().map_err(|error| failure(&format!("{name}, {}", member.label), &error))
        };
        let shapes = members.iter().map(shape).collect::<Result<Vec<Shape>, Failure>>()?;
        if self.view.is_some() && !shapes.iter().all(|shape| matches!(shape, Shape::Space(_))) {
            return Err(Failure::usage(
                "--view is for space curves and surfaces; this file holds a curve of the plane",
            ));
        }
        if let Some(member) = members.first() {
            points = match member.design.controls() {
                Controls::Plane(points) => points,
                Controls::Space(points) => {
                    bounds = BoundingBox::of_points(&points);
                    points.iter().map(|&point| view.place(point)).collect()
                }
                _ => Vec::new(),
            };
        }
        if self.polygon {
            let closed = shapes.first().is_some_and(|shape| match shape {
                Shape::Plane(curve) => closure(&**curve) == Closure::Closed,
                Shape::Space(curve) => closure(&**curve) == Closure::Closed,
                _ => false,
            });
            figure.plot_polygon(points.clone(), if closed { Closure::Closed } else { Closure::Open });
        }
        for ((member, shape), ink) in members.iter().zip(&shapes).zip(SERIES_INKS) {
            let plotted = match shape {
                Shape::Plane(curve) => figure.plot_curve(&**curve, ink),
                Shape::Space(curve) => {
                    bounds = bounds.into_iter().chain(curve.bounding_box()).reduce(BoundingBox::union);
                    figure.plot_space_curve(&**curve, &view, ink)
                }
                // The series is of control points, and these make curves.
                _ => Ok(()),
            };
            plotted.map_err(|error| Failure::work(format!("{name}, {}: {error}", member.label)))?;
            self.plot_joints(&mut figure, shape, &view, ink);
            figure.add_to_legend(&member.label, ink);
        }
        if self.points {
            figure.plot_points(&points);
        }
        self.measure_space(&mut figure, view, bounds);
        let content = self.picture(&figure, format)?;
        drop(alive);
        Ok(content)
    }

    /// The joints of a curve, if they are to be shown.
    pub(super) fn plot_joints(&self, figure: &mut Figure, shape: &Shape, view: &View, ink: [u8; 3]) {
        if !self.joints {
            return;
        }
        match shape {
            Shape::Plane(curve) => curve.joints().into_iter().for_each(|at| figure.plot_joint_in(at, ink)),
            Shape::Space(curve) => {
                curve.joints().into_iter().for_each(|at| figure.plot_joint_in(view.place(at), ink));
            }
            _ => {}
        }
    }

    fn check_series(&self, format: Format) -> Result<(), Failure> {
        if format.is_model() {
            return Err(Failure::usage("several curves are drawn as pictures, .png, .svg or .pdf"));
        }
        let given = [
            ("--distance", !self.distance.is_empty()),
            ("--comb", self.comb),
            ("--speed", self.speed),
            ("--tolerance", self.tolerance.is_some()),
            ("--per-span", self.per_span.is_some()),
        ];
        match given.into_iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(Failure::usage(format!(
                "{option} is for single curves and surfaces, not for several together"
            ))),
            None => Ok(()),
        }
    }
}
