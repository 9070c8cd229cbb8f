//! What stands beside the picture: title, line of status, the page of a search, the hodograph in its window.

use super::bench::{Bench, index};
use super::facts::Facts;
use super::rail::Stack;
use super::texts::{self, PathKind, Status};
use crate::design::knots::edit;
use crate::editor::Editor;
use crate::editor::picture::{Layer, Page};
use crate::figure::wrap;
use crate::file::KnotPoints;
use crate::geometry::{ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::look::pixel;
use crate::ui::{Area, TOP, words};

/// Where the title and the line of status stand.
const TITLE: (i32, i32) = (28, 7);
const STATUS: (i32, i32) = (28, 470);
/// Letters in a line of the page.
const LETTERS: usize = 28;
/// The window of the hodograph.
const WINDOW: Area = Area::new(451, 74, 597, 170);

impl Editor<Bench, 2> {
    /// Draws one layer.
    pub(super) fn draw_layer(&self, layer: Layer, page: &mut Page<'_>) {
        match layer {
            Layer::Under if !self.stage.is_result() => {
                self.draw_region(page.screen);
                let store = words::STORE.of(page.language);
                let width = 8 * i32::try_from(store.chars().count()).unwrap_or(0);
                page.screen.text(631 - width, 67, store, Color::White);
            }
            Layer::Over if !self.stage.is_result() => {
                let facts = self.facts(&self.drawn());
                if let Some(facts) = facts.filter(|_| self.craft.options.hodograph && self.stage.begun()) {
                    self.draw_hodograph(page.screen, &facts);
                }
                self.draw_strips(page.screen);
            }
            Layer::Page => self.draw_search(page),
            Layer::Titles => {
                let now = self.history.now();
                let title = texts::title(now.order, edit::ends(now));
                page.screen.text(TITLE.0, TITLE.1, title.of(page.language), Color::Black);
                if let Some(status) = self.status(&self.drawn()) {
                    page.screen.text(STATUS.0, STATUS.1, status.phrase().of(page.language), Color::Black);
                }
            }
            _ => {}
        }
    }

    /// What is known of the chosen knot at the marked parameter.
    pub(super) fn status(&self, drawn: &KnotPoints) -> Option<Status> {
        let facts = self.facts(drawn)?;
        let (u, chosen) = (self.u(&facts), self.chosen(drawn));
        let of_family = |stack: Stack| {
            let envelope = facts.curve.envelope(index(drawn, stack.first), stack.copies);
            let own = self.paths(drawn, &facts, stack, u).into_iter().find(|path| path.own);
            (envelope.ok().and_then(|envelope| envelope.curvature_ratio), own.map(|path| path.kind))
        };
        let (ratio, path) = chosen.map_or((None, None), of_family);
        let against = chosen.filter(|_| self.craft.options.opposed).and_then(|stack| {
            let span = stack.first + drawn.order - 2;
            let opposed = facts.curve.opposed(stack.first, *facts.curve.vector().knots().get(span)?).ok()?;
            // Where it is not straight, it is rational of order 3 (Juhász).
            Some(if opposed.straight() { PathKind::Straight } else { PathKind::Order(3) })
        });
        let path = against.or(path);
        let before = self.craft.start.as_ref().filter(|_| self.craft.options.compared);
        Some(Status {
            knot: chosen.map(|stack| (stack.first, stack.value, stack.copies)),
            u,
            ratio,
            path: path.unwrap_or(PathKind::None),
            inflections: facts.inflections.len(),
            before: before.and_then(|start| self.facts(start)).map(|facts| facts.inflections.len()),
        })
    }

    /// The page of a search: what to do, what was found, or why nothing was.
    fn draw_search(&self, page: &mut Page<'_>) {
        let Some(search) = &self.craft.search else { return };
        let (text, ink) = search.told(self.history.now());
        for (row, line) in (0..).zip(wrap(text.of(page.language), LETTERS).iter().take(3)) {
            page.screen.text(TOP.0 + 8, TOP.1 + 7 + 11 * row, line, ink);
        }
    }

    /// The derivative as a curve of its own, as large as it goes into its window, with the vector at `u`.
    fn draw_hodograph(&self, screen: &mut Screen, facts: &Facts) {
        let Area { x1, y1, x2, y2 } = WINDOW;
        screen.bar(x1, y1, x2, y2, Color::Black);
        screen.rectangle(x1, y1, x2, y2, Stroke::thin(Color::LightCyan));
        let slope = |u: f64| facts.curve.derivatives(u, 1).map(|all| all[1]);
        let vectors: Vec<Vec<Point<2>>> = match facts.curve.hodograph() {
            Ok(hodograph) => vec![hodograph.polyline(24).unwrap_or_default()],
            // A quotient's derivative is no curve by knots: span by span.
            Err(_) => {
                let spans = facts.curve.spans();
                let at = |span: usize, k: u32| {
                    let (first, last) =
                        facts.curve.vector().filled_spans().get(span).map(|&j| {
                            (facts.curve.vector().knots()[j], facts.curve.vector().knots()[j + 1])
                        })?;
                    slope(first + (last - first) * f64::from(k) / 24.001)
                };
                (0..spans).map(|span| (0..=24).filter_map(|k| at(span, k)).collect()).collect()
            }
        };
        let most = vectors.iter().flatten().flatten().map(|x| x.abs()).fold(0.0, f64::max);
        if most <= 0.0 {
            return;
        }
        let (middle, scale) = (((x1 + x2) / 2, (y1 + y2) / 2), 44.0 / most);
        let place = |[x, y]: Point<2>| (middle.0 + pixel(scale * x), middle.1 - pixel(scale * y));
        screen.line(x1 + 3, middle.1, x2 - 3, middle.1, Stroke::thin(Color::DarkGray));
        screen.line(middle.0, y1 + 3, middle.0, y2 - 3, Stroke::thin(Color::DarkGray));
        for line in &vectors {
            let pixels: Vec<(i32, i32)> = line.iter().map(|&vector| place(vector)).collect();
            screen.polyline(&pixels, Stroke::thin(Color::White));
        }
        if let Some((x, y)) = slope(self.u(facts)).map(place) {
            screen.line(middle.0, middle.1, x, y, Stroke::thin(Color::LightCyan));
            screen.disc(x, y, 3, Color::LightCyan, Color::White);
        }
    }
}
