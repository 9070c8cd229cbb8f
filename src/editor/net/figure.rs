//! The surface editor's picture as a figure: the lines of the surface, the net, a section.

use super::inspect::Inspection;
use super::model::Model;
use super::surface::{Display, Drawn};
use super::{Editor, Stage};
use crate::figure::{Axes, Figure, Hidden};
use crate::geometry::{BoundingBox, Closure, Grid, Point, View};
use crate::screen::Color;

impl Editor {
    /// The surface or the net that the picture shows, with the axes of space. `None` while it shows neither,
    /// and where it tells something by colours, which lines cannot.
    pub(super) fn as_figure(&self) -> Option<Figure> {
        if matches!(self.stage, Stage::Starting { .. } | Stage::Returning) {
            return None;
        }
        let (mut figure, view) = (Figure::new(), self.viewer.look.view);
        let model = self.preview();
        let under = if self.drawn.is_none() { self.under_net(&model) } else { None };
        let surface = self.drawn.as_ref().or(under.as_ref());
        if surface.is_some() && self.inspection != Inspection::Off {
            return None;
        }
        let mut bounds = None;
        if let Some(drawn) = surface {
            self.add_surface(&mut figure, drawn, &view);
            bounds = BoundingBox::of_points(drawn.grid.points());
        }
        if self.drawn.is_none() {
            let points: Vec<_> = model.indices(&self.plan).filter_map(|index| model.point(index)).collect();
            self.add_net(&mut figure, &model, &points, &view);
            bounds = bounds.into_iter().chain(BoundingBox::of_points(&points)).reduce(BoundingBox::union);
        }
        figure.set_axes(Axes::Space { view, bounds: bounds? });
        Some(figure)
    }

    fn add_surface(&self, figure: &mut Figure, drawn: &Drawn, view: &View) {
        figure.plot_surface(&drawn.grid, view, hidden(self.display_now()));
        for line in self.section_lines(drawn) {
            figure.plot_section(line.into_iter().map(|point| view.place(point)).collect());
        }
    }

    /// The lines of the net and the control points that can be chosen.
    fn add_net(&self, figure: &mut Figure, model: &Model, points: &[Point<3>], view: &View) {
        for (from, to, ink) in self.strokes(model) {
            let line = vec![view.place(from), view.place(to)];
            match ink {
                Color::White => figure.plot_border(line),
                _ => figure.plot_polygon(line, Closure::Open),
            }
        }
        points.iter().for_each(|&point| figure.plot_point(view.place(point), None));
    }
}

/// A surface that is only looked at as a figure.
pub(super) fn of_grid(grid: &Grid, view: View, display: Display) -> Option<Figure> {
    let mut figure = Figure::new();
    figure.plot_surface(grid, &view, hidden(display));
    let bounds = BoundingBox::of_points(grid.points())?;
    figure.set_axes(Axes::Space { view, bounds });
    Some(figure)
}

/// Cells hide what is behind them, wires do not.
fn hidden(display: Display) -> Hidden {
    match display {
        Display::Wire => Hidden::Drawn,
        Display::Filled => Hidden::LeftOut,
    }
}
