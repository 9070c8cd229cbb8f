//! The small cells that an inspected surface is coloured in, and what their colours tell. None of it depends on the view,
//! so it is computed once, when it is first asked for.

use super::surface::Drawn;
use crate::geometry::{BoundingBox, Grid, ParamSurface, Point};
use std::cell::OnceCell;

/// Coloured cells per cell of the net, in each direction.
const FINE: usize = 28;
/// The same where a patch has no cells of a net, as a Hermite patch.
const FINEST: usize = 84;
/// Largest number of coloured cells along one direction.
const MOST_CELLS: usize = 256;

/// The cells of a surface, and its values at their centres.
#[derive(Debug)]
pub(crate) struct Fine {
    /// Cells per span, in each direction.
    steps: usize,
    /// The grid of each part that is a surface of its own, and the number of its first cell.
    grids: Vec<(Grid, usize)>,
    normals: OnceCell<Vec<Option<Point<3>>>>,
    curvatures: OnceCell<Vec<Option<f64>>>,
    radii: OnceCell<Vec<Option<f64>>>,
    size: OnceCell<Option<f64>>,
}

impl Fine {
    fn of(drawn: &Drawn) -> Fine {
        let [rows, columns] = drawn.spans;
        let alone = rows.max(columns) <= 2 && drawn.own().all(|(surface, _)| surface.steps(0, 0, 1) == 1);
        let most = if alone { FINEST } else { FINE };
        let steps = most.min(MOST_CELLS / rows.max(columns).max(1)).max(2);
        let mut first = 0;
        let grids = surfaces(drawn, steps).map(|(_, grid)| {
            let start = first;
            first += grid.rows().saturating_sub(1) * grid.columns().saturating_sub(1);
            (grid, start)
        });
        Fine {
            steps,
            grids: grids.collect(),
            normals: OnceCell::new(),
            curvatures: OnceCell::new(),
            radii: OnceCell::new(),
            size: OnceCell::new(),
        }
    }

    /// The grids of the cells.
    pub(super) fn grids(&self) -> Vec<&Grid> {
        self.grids.iter().map(|(grid, _)| grid).collect()
    }

    /// The number of a cell among all, by its grid and its number there.
    pub(super) fn number(&self, [grid, cell]: [usize; 2]) -> usize {
        self.grids.get(grid).map_or(0, |(_, first)| first + cell)
    }

    /// A value at the centres of all cells, by surface, spans and parameters.
    pub(super) fn values<T>(
        &self,
        drawn: &Drawn,
        of: impl Fn(&dyn ParamSurface, [usize; 2], [f64; 2]) -> T,
    ) -> Vec<T> {
        let mut values = Vec::new();
        for (surface, grid) in surfaces(drawn, self.steps) {
            let [u, v] = [surface.line_places(0, self.steps), surface.line_places(1, self.steps)];
            // A closed surface has a line less than its grid, whose last one is the first again.
            for &(i, u) in u.iter().take(grid.rows().saturating_sub(1)) {
                let columns = v.iter().take(grid.columns().saturating_sub(1));
                values.extend(columns.map(|&(j, v)| of(surface, [i, j], [u, v])));
            }
        }
        values
    }

    /// The unit normals.
    pub(super) fn normals(&self, drawn: &Drawn) -> &[Option<Point<3>>] {
        self.normals.get_or_init(|| self.values(drawn, |surface, spans, at| surface.normal(spans, at)))
    }

    /// The Gaussian curvatures.
    pub(super) fn curvatures(&self, drawn: &Drawn) -> &[Option<f64>] {
        self.curvatures
            .get_or_init(|| self.values(drawn, |surface, spans, at| surface.gaussian_curvature(spans, at)))
    }

    /// The smaller ones of the two radii of curvature.
    pub(super) fn radii(&self, drawn: &Drawn) -> &[Option<f64>] {
        self.radii.get_or_init(|| self.values(drawn, radius))
    }

    /// From corner to corner of the box round the surface itself.
    pub(super) fn size(&self, drawn: &Drawn) -> Option<f64> {
        *self.size.get_or_init(|| {
            let boxes = drawn.own().filter_map(|(surface, _)| surface.bounding_box());
            boxes.reduce(BoundingBox::union).map(|bounds| bounds.extent())
        })
    }
}

impl Drawn {
    /// The cells that it is coloured in.
    pub(super) fn fine(&self) -> &Fine {
        self.fine.get_or_init(|| Fine::of(self))
    }
}

/// The parts that are surfaces of their own, with grids of so many cells per span.
fn surfaces(drawn: &Drawn, steps: usize) -> impl Iterator<Item = (&dyn ParamSurface, Grid)> {
    drawn.own().filter_map(move |(surface, _)| Some((surface, surface.grid(steps).ok()?)))
}

fn radius(surface: &dyn ParamSurface, spans: [usize; 2], parameters: [f64; 2]) -> Option<f64> {
    let at = surface.at(spans, parameters)?;
    let (mean, gauss) = (at.mean_curvature()?, at.gaussian_curvature()?);
    Some(1.0 / (mean.abs() + (mean * mean - gauss).max(0.0).sqrt()))
}
