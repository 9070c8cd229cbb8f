//! Scenes over extended Chebyshev spaces in pictures and models.

use super::Render;
use crate::picture::Format;
use crate::steps::{self, For};
use grafika::design::ec::EcShapes;
use grafika::figure::{CURVE_INK, Hidden, print_ink};
use grafika::file::SPACE_VIEW;
use grafika::file::ec::{EcCurve, EcDocument, Item};
use grafika::geometry::{BoundingBox, Closure, Grid, ParamCurve, ParamSurface, Point, View};
use grafika::launch::{Failure, say};
use grafika::screen::Color;

impl Render {
    /// Writes the patches of a scene as a model.
    pub(super) fn model_of_parts(&self, parts: &EcShapes, format: Format) -> Result<(), Failure> {
        self.check_model(format)?;
        if parts.patches.is_empty() {
            let message = "models are of surfaces; a curve is drawn as .png, .svg or .pdf";
            return Err(Failure::usage(format!("-o {}: {message}", self.output.display())));
        }
        if !parts.curves.is_empty() {
            say("grafika", "models are of surfaces; the curves of this scene are left out");
        }
        let surfaces: Vec<&dyn ParamSurface> =
            parts.patches.iter().map(|patch| patch as &dyn ParamSurface).collect();
        self.model(&surfaces, format)
    }

    /// Arcs and patches over extended Chebyshev spaces: curves within a tolerance that no picture shows, patches by
    /// the lines that nothing hides.
    pub(super) fn parts(
        &self,
        document: &EcDocument,
        parts: &EcShapes,
        format: Format,
    ) -> Result<Vec<u8>, Failure> {
        match parts.patches.is_empty() {
            true => self.check_curve()?,
            false => self.check_wires()?,
        }
        let view = View::from_direction(self.view.unwrap_or(SPACE_VIEW));
        let surfaces: Vec<&dyn ParamSurface> =
            parts.patches.iter().map(|patch| patch as &dyn ParamSurface).collect();
        let steps = steps::of_surfaces(self.per_span, &surfaces, For::Picture);
        let grids: Vec<Grid> = parts
            .patches
            .iter()
            .map(|patch| patch.grid(steps))
            .collect::<Result<_, _>>()
            .map_err(Failure::work)?;
        let mut figure = self.titled();
        if !grids.is_empty() {
            figure.plot_surfaces(&grids, &view, Hidden::LeftOut);
        }
        let place = |&point: &Point<3>| view.place(point);
        let lines = |net: &[Vec<Point<3>>]| -> Vec<Vec<Point<2>>> {
            let columns = net.first().map_or(0, Vec::len);
            let across = (0..columns).map(|l| net.iter().filter_map(|row| row.get(l)).map(place).collect());
            net.iter().map(|row| row.iter().map(place).collect()).chain(across).collect()
        };
        let nets = parts.patches.iter().map(|patch| patch.net());
        if self.polygon {
            let polygons = parts.curves.iter().map(|arc| arc.points().iter().map(place).collect());
            let all = polygons.chain(nets.clone().flat_map(lines));
            all.for_each(|line: Vec<Point<2>>| figure.plot_polygon(line, Closure::Open));
        }
        let inks = curve_inks(document);
        for (arc, ink) in parts.curves.iter().zip(inks.into_iter().chain(std::iter::repeat(CURVE_INK))) {
            figure.plot_space_curve(arc, &view, ink).map_err(Failure::work)?;
        }
        if self.points {
            for arc in &parts.curves {
                let labelled = arc.points().iter().enumerate();
                labelled.for_each(|(i, point)| figure.plot_point(place(point), Some(i.to_string())));
            }
            for (i, row) in nets.clone().flat_map(|net| net.iter().enumerate()) {
                let labelled = row.iter().enumerate();
                labelled.for_each(|(j, point)| figure.plot_point(place(point), Some(format!("{i},{j}"))));
            }
        }
        let curves = parts.curves.iter().map(|arc| arc.bounding_box());
        let patches = grids.iter().map(|grid| BoundingBox::of_points(grid.points()));
        let bounds = curves.chain(patches).flatten().reduce(BoundingBox::union);
        self.measure(&mut figure, view, [bounds, None]);
        self.picture(&figure, format)
    }
}

/// The colours of the curves of a document, for paper; a white one is drawn as curves are.
fn curve_inks(document: &EcDocument) -> Vec<[u8; 3]> {
    let ink = |curve: &EcCurve| match Color::from_index(curve.style.colour) {
        Color::White => CURVE_INK,
        color => print_ink(color),
    };
    match document {
        EcDocument::Curve(curve) => vec![ink(curve)],
        EcDocument::Scene(scene) => scene
            .items
            .iter()
            .filter_map(|item| match item {
                Item::Curve(curve) => Some(ink(curve)),
                Item::Patch(_) => None,
            })
            .collect(),
        _ => Vec::new(),
    }
}
