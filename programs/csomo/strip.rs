//! The strip of basis functions and the line of knots under the field.

use super::bench::{Bench, Curve, Handle, index};
use super::facts::Facts;
use super::rail::{Scale, stacks};
use super::sheet::{self, LINE, ORIGIN, RAIL, STRIP, column};
use crate::editor::Editor;
use crate::editor::field::PICTURE;
use crate::file::KnotPoints;
use crate::geometry::Basis;
use crate::geometry::knots::KnotVector;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Area, tint};

/// Pixels between places of the functions.
const STEP: i32 = 2;

impl Editor<Bench, 2> {
    /// Strip and line.
    pub(super) fn draw_strips(&self, screen: &mut Screen) {
        let Area { x1, x2, y2, .. } = PICTURE;
        // What of the field comes down here is covered.
        screen.bar(x1, STRIP.y1 - 3, x2, y2, Color::Black);
        let frame = Stroke::thin(Color::DarkGray);
        screen.rectangle(STRIP.x1 - 1, STRIP.y1 - 1, STRIP.x2 + 1, STRIP.y2 + 1, frame);
        let (drawn, scale) = (self.drawn(), sheet::scale(self.history.now()));
        let facts = self.facts(&drawn);
        self.draw_region_spans(screen, &scale);
        if let Some(facts) = &facts {
            draw_functions(screen, facts.curve.vector(), &scale);
            self.draw_graphs(screen, facts, &scale);
            let at = column(&scale, self.u(facts));
            screen.line(at, STRIP.y1, at, LINE.y2, Stroke::thin(Color::White).dotted());
        }
        // The triangle is at the mouse, also where the curve waits.
        let held = if self.held.is_some() { self.preview() } else { drawn };
        self.draw_knots(screen, &held, facts.as_deref(), &scale);
    }

    /// Curvature and speed over the parameter.
    fn draw_graphs(&self, screen: &mut Screen, facts: &Facts, scale: &Scale) {
        let options = self.craft.options;
        if options.comb {
            let middle = (STRIP.y1 + STRIP.y2) / 2;
            screen.line(STRIP.x1, middle, STRIP.x2, middle, Stroke::thin(Color::DarkGray));
            let bend = |u: f64| facts.curve.curvature(u);
            graph(screen, &facts.curve, scale, bend, (middle, 40.0), Color::LightGreen);
        }
        if options.hodograph {
            let speed = |u: f64| {
                let all = facts.curve.derivatives(u, 1)?;
                Some(all[1][0].hypot(all[1][1]))
            };
            graph(screen, &facts.curve, scale, speed, (STRIP.y2, 84.0), Color::LightCyan);
        }
    }

    /// Triangles of the knots, one over the other where they are equal.
    fn draw_knots(&self, screen: &mut Screen, drawn: &KnotPoints, facts: Option<&Facts>, scale: &Scale) {
        let chosen = self.chosen(drawn);
        let partner =
            chosen.and_then(|stack| self.partner(drawn, stack.first)).filter(|_| self.craft.options.opposed);
        let fill = |knot: usize| match chosen {
            Some(stack) if stack.holds(knot) => Color::Yellow,
            _ if partner == Some(knot) => Color::LightCyan,
            _ if facts.is_some_and(|facts| idle(&facts.curve, index(drawn, knot))) => Color::DarkGray,
            _ => Color::LightGray,
        };
        let domain = facts.map(|facts| facts.curve.vector().domain());
        RAIL.draw(screen, scale, &drawn.knots, domain, fill);
        if let Some(value) = self.beyond() {
            RAIL.mark(screen, scale.along(value), Stroke::thick(Color::Yellow).dotted());
        }
        if let Some(Handle::Knots { .. } | Handle::Opposed(_)) = self.held.map(|held| held.handle) {
            // Where it was.
            let before = stacks(&self.history.now().knots);
            for stack in before.iter().filter(|stack| !drawn.knots.contains(&stack.value)) {
                RAIL.mark(screen, scale.along(stack.value), Stroke::thin(Color::DarkGray));
            }
        }
    }
}

fn idle(curve: &Curve, knot: usize) -> bool {
    curve.changed_spans(knot).is_empty()
}

/// All functions, also beyond the domain.
fn draw_functions(screen: &mut Screen, vector: &KnotVector, scale: &Scale) {
    let Some((wide, before)) = extended(vector) else { return };
    let count = vector.points();
    for end in vector.domain().map(|u| column(scale, u)) {
        screen.line(end, STRIP.y1, end, STRIP.y2, Stroke::thin(Color::DarkGray));
    }
    // Of every function its pixels so far.
    let mut lines: Vec<Vec<(i32, i32)>> = vec![Vec::new(); wide.controls()];
    let mut values = Vec::new();
    for column in (STRIP.x1..=STRIP.x2).step_by(STEP as usize) {
        let u = scale.value(f64::from(column - ORIGIN.0));
        let Some(span) = wide.span_of(u) else { continue };
        let Some(number) = wide.filled_spans().iter().position(|other| *other == span) else { continue };
        let (from, to) = (wide.knots()[span], wide.knots()[span + 1]);
        if wide.values(number, (u - from) / (to - from), &mut values).is_none() {
            continue;
        }
        let first = span + 1 - wide.order();
        for (line, value) in lines.iter_mut().skip(first).zip(&values) {
            let up = (value * f64::from(STRIP.y2 - STRIP.y1)).round() as i32;
            line.push((column, STRIP.y2 - up));
        }
    }
    for (function, line) in lines.iter().enumerate() {
        let Some(own) = function.checked_sub(before).filter(|own| *own < vector.controls()) else { continue };
        if line.len() > 1 {
            screen.polyline(line, Stroke::thin(tint::LINES[own % count % tint::LINES.len()]));
        }
    }
}

/// The knots with more of them at both ends, so that the domain is the whole list, and how many functions come before.
fn extended(vector: &KnotVector) -> Option<(KnotVector, usize)> {
    if vector.breaks().is_some() {
        // A closed list goes on by itself; its domain is all that the document has.
        let open = KnotVector::new(vector.order(), vector.knots().to_vec()).ok()?;
        return Some((open, 0));
    }
    let (order, knots) = (vector.order(), vector.knots());
    let (first, last) = (*knots.first()?, *knots.last()?);
    let step = (last - first) / knots.len() as f64;
    let before = (1..order).rev().map(|i| first - i as f64 * step);
    let after = (1..order).map(|i| last + i as f64 * step);
    let all = before.chain(knots.iter().copied()).chain(after).collect();
    Some((KnotVector::new(order, all).ok()?, order - 1))
}

/// A function of the parameter over the domain, as high as there is room.
fn graph(
    screen: &mut Screen,
    curve: &Curve,
    scale: &Scale,
    value: impl Fn(f64) -> Option<f64>,
    (zero, room): (i32, f64),
    ink: Color,
) {
    let [from, to] = curve.vector().domain();
    let columns = column(scale, from)..=column(scale, to);
    let at = |column: i32| {
        let u = scale.value(f64::from(column - ORIGIN.0)).clamp(from, to);
        Some((column, value(u)?))
    };
    let values: Vec<(i32, f64)> = columns.step_by(STEP as usize).filter_map(at).collect();
    let most = values.iter().map(|(_, value)| value.abs()).fold(0.0, f64::max);
    if most > 0.0 {
        let up = |value: f64| (room * value / most).round() as i32;
        let line: Vec<(i32, i32)> =
            values.iter().map(|&(column, value)| (column, zero - up(value))).collect();
        screen.polyline(&line, Stroke::thick(ink));
    }
}
