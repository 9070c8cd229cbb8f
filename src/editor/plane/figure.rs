//! The plane editor's picture as a figure: the curves by their arcs, control points and tangents.

use super::curves::{Kind, Traced, trace};
use super::sketch::Sketch;
use super::{Editor, Stage};
use crate::editor::choice::Choice;
use crate::figure::{CURVE_INK, Figure, print_ink};

impl Editor {
    /// The curves and points that the picture shows; `None` while it shows none.
    pub(super) fn as_figure(&self) -> Option<Figure> {
        if matches!(self.stage, Stage::Starting { .. }) {
            return None;
        }
        let (mut figure, sketch) = (Figure::new(), self.preview());
        let points = !matches!(self.stage, Stage::Result { points: false });
        if points {
            add_tangents(&mut figure, &sketch);
        }
        self.add_curves(&mut figure, &sketch);
        if points {
            figure.plot_points(sketch.points());
        }
        (!figure.is_empty()).then_some(figure)
    }

    /// The compared curves with their names, and the chosen one.
    fn add_curves(&self, figure: &mut Figure, sketch: &Sketch) {
        let closure = self.closure();
        let compared = Kind::ALL.into_iter().filter(|(kind, ..)| self.compared.contains(kind));
        for (index, (kind, name, color)) in compared.enumerate() {
            let traced = trace(self.tools, Choice { closure, method: kind.method(self.k0) }, sketch);
            // A curve that does not exist is not drawn; it was told when it was chosen.
            let Some(arcs) = traced.and_then(|traced| traced.arcs(sketch.points())).ok() else { continue };
            // The names stand apart, each at its own part of its curve.
            let part = (2 * index + 1) * arcs.len() / (2 * Kind::ALL.len());
            if let Some(arc) = arcs.get(part) {
                figure.text(arc.eval(0.5), name);
            }
            let Ok(()) = figure.plot_curve(&arcs, print_ink(color)) else { continue };
        }
        let shown = self.shown.visible || matches!(self.stage, Stage::Result { .. });
        let Some(choice) = self.shown.choice.filter(|_| shown) else { return };
        let Ok(traced) = trace(self.tools, choice, sketch) else { return };
        self.add_chosen(figure, &traced, choice, sketch);
    }

    fn add_chosen(&self, figure: &mut Figure, traced: &Traced, choice: Choice, sketch: &Sketch) {
        let Ok(arcs) = traced.arcs(sketch.points()) else { return };
        let Ok(()) = figure.plot_curve(&arcs, CURVE_INK) else { return };
        for joint in traced.joints(self.tools, choice.closure) {
            figure.plot_joint(joint);
        }
    }
}

/// The tangents, each from its tip to its mirror image.
fn add_tangents(figure: &mut Figure, sketch: &Sketch) {
    for (index, &[x, y]) in sketch.points().iter().enumerate() {
        if let Some(tip) = sketch.tip(index) {
            figure.plot_tangent(tip, [2.0 * x - tip[0], 2.0 * y - tip[1]]);
        }
    }
}
