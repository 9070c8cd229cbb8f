//! The commands of the surface editor.

use super::Nets;
use super::ask::ask_display;
use super::plan::Family;
use super::tables::Action;
use crate::design::{Index, NetDesign, Part};
use crate::editor::curve::ask::ask_real;
use crate::editor::place::{ask_height, ask_place};
use crate::editor::values::{BIAS, SURFACE_K0, TENSION};
use crate::editor::{Craft, Editor, refusal};
use crate::file::{Method, NetSettings};
use crate::geometry::{Border, Topology};
use crate::machine::Asked;
use crate::ui::words::{self, Words};
use crate::ui::{Desk, Stay};
use crate::work::{Next, quit};
use std::ops::RangeInclusive;
use std::rc::Rc;

/// Places of the parameters' captions.
const ENTRY: (i32, i32) = (232, 26);

impl Editor<Nets, 3> {
    /// Carries out a command.
    pub(super) async fn carry_out(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        match action {
            Action::Normal
            | Action::NormalAt(_)
            | Action::Automatic
            | Action::Distance
            | Action::Both
            | Action::Shell
            | Action::Compare
            | Action::Gauss
            | Action::Size => self.change_normals(desk, action).await?,
            Action::Change => self.change(desk, None).await?,
            Action::ChangeAt(index) => self.change(desk, Some(index)).await?,
            Action::Surface => self.show_surface(desk).await?,
            Action::Result => self.show_result(desk).await?,
            Action::Bias(direction) => {
                let set = |settings: &mut NetSettings, bias| settings.bias = Some(bias);
                self.ask_parameter(desk, direction, words::BIAS_ENTRY, BIAS.range(), NetDesign::bias, set)
                    .await?;
            }
            Action::Tension(direction) => {
                let set = |settings: &mut NetSettings, tension| settings.tension = Some(tension);
                self.ask_parameter(
                    desk,
                    direction,
                    words::TENSION_ENTRY,
                    TENSION.range(),
                    NetDesign::tension,
                    set,
                )
                .await?;
            }
            Action::K0(direction) => {
                let set = |settings: &mut NetSettings, k0| settings.k0 = Some(k0);
                self.ask_parameter(
                    desk,
                    direction,
                    words::COEFFICIENT_ENTRY,
                    SURFACE_K0.range(),
                    NetDesign::k0,
                    set,
                )
                .await?;
            }
            Action::Follow => {
                self.shown.follow = !self.shown.follow;
                self.craft.drawn = None;
                self.shown.known |= self.shown.follow;
                let follows = self.shown.follow;
                let said = if follows { words::SURFACE_FOLLOWS } else { words::SURFACE_FOLLOWS_NOT };
                desk.tell(said, Stay::Briefly);
            }
            Action::Border => {
                let border = self.next_border();
                self.change_surface(desk, self.history.now().with_border(border));
                desk.tell(words::border(border, self.plan_is_of_splines()), Stay::Briefly);
            }
            Action::Join => self.join(desk).await?,
            Action::Mirror => {
                let heights = self.craft.plan.family == Family::Heights;
                let axis = if heights { 2 } else { self.ask_axis(desk).await? };
                self.change_surface(desk, self.history.now().mirrored(axis));
            }
            Action::Refine => {
                let direction = self.ask_direction(desk).await?;
                match self.history.now().refined(direction) {
                    Ok(design) => self.change_surface(desk, design),
                    Err(error) => desk.tell(refusal::of_refining(&error), Stay::UntilRead),
                }
            }
            Action::Quit => {
                let next = quit(self, desk).await?;
                self.craft.drawn = None;
                self.shown.known &= self.shown.follow;
                return Ok(next);
            }
        }
        Ok(Next::Work)
    }

    /// The border after the present one: of splines poles are joined or free, of B-splines there are three.
    fn next_border(&self) -> Border {
        let now = self.history.now();
        match (now.border(), now.net.kind.topology()) {
            (Border::Doubled, _) if self.plan_is_of_splines() => Border::Free,
            (Border::Doubled, _) => Border::Reached,
            (Border::Reached, Topology::Sphere) => Border::Free,
            (Border::Reached, Topology::Open) => Border::Inner,
            _ => Border::Doubled,
        }
    }

    fn plan_is_of_splines(&self) -> bool {
        self.craft.plan.family == Family::Spline
    }

    /// Commits another net; a surface in the picture follows it.
    pub(super) fn change_surface(&mut self, desk: &mut Desk<'_>, design: NetDesign) {
        self.history.change(design);
        if self.craft.drawn.is_some() {
            self.refresh(desk);
        }
    }

    /// Shows the surface of the present net; if there is none, says why.
    pub(super) fn refresh(&mut self, desk: &mut Desk<'_>) -> bool {
        let drawn = self.craft.draw_up(self.history.now());
        self.shown.known = drawn.is_ok();
        match &drawn {
            Ok(drawn) if !drawn.has_area() => desk.tell(words::COLLAPSED, Stay::Briefly),
            Ok(_) => {}
            Err(error) => desk.tell(refusal::of_surface(error), Stay::UntilRead),
        }
        self.craft.drawn = drawn.ok().map(Rc::new);
        self.shown.known
    }

    /// The command V: a new place for a control point, chosen by number or beforehand.
    pub(super) async fn change(&mut self, desk: &mut Desk<'_>, index: Option<Index>) -> Asked<()> {
        Nets::changed(self);
        let index = match index {
            Some(index) => index,
            None => self.ask_index(desk).await?,
        };
        self.craft.chosen = Some((index, Part::Place));
        let changed = self.ask_change(desk, index).await;
        self.craft.chosen = None;
        self.history.change(changed?);
        Ok(())
    }

    /// Asks for a new value of a control point.
    async fn ask_change(&mut self, desk: &mut Desk<'_>, index: Index) -> Asked<NetDesign> {
        let part = match self.craft.plan.family {
            Family::Hermite => self.ask_part(desk).await?,
            _ => Part::Place,
        };
        self.craft.chosen = Some((index, part));
        if self.craft.plan.family == Family::Heights {
            let height = ask_height(desk, self, words::HEIGHT_TITLE).await?;
            return Ok(self.history.now().moved(index, [0.0, 0.0, height]));
        }
        let value = ask_place(desk, self, part.title()).await?;
        Ok(self.history.now().with_part(index, part, value))
    }

    /// The command F: shows the surface instead of the net.
    async fn show_surface(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        match self.craft.plan.family {
            Family::Heights => {}
            Family::BSpline => {
                let (degree, display) = self.ask_degree_and_display(desk).await?;
                self.craft.display = display;
                let named = (degree != Method::BSpline3).then_some(degree);
                self.history.change(self.history.now().with_settings(|settings| settings.method = named));
            }
            _ => self.craft.display = ask_display(desk, self).await?,
        }
        self.refresh(desk);
        Ok(())
    }

    /// Asks for a direction, unless it is chosen, and the value of a parameter in it.
    async fn ask_parameter(
        &mut self,
        desk: &mut Desk<'_>,
        direction: Option<usize>,
        caption: Words,
        range: RangeInclusive<f64>,
        get: fn(&NetDesign) -> [f64; 2],
        set: fn(&mut NetSettings, [f64; 2]),
    ) -> Asked<()> {
        let direction = match direction {
            Some(direction) => direction,
            None => self.ask_direction(desk).await?,
        };
        let typed = ask_real(desk, self, (caption, ENTRY), TENSION.range()).await?;
        let value = typed.clamp(*range.start(), *range.end());
        if value != typed {
            desk.tell(words::taken_into(&range), Stay::Briefly);
        }
        let mut values = get(self.history.now());
        values[direction.min(1)] = value;
        self.reshape(desk, self.history.now().with_settings(|settings| set(settings, values)));
        Ok(())
    }
}
