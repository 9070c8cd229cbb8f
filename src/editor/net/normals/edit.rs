//! The commands of surfaces with Pythagorean normals.

use super::other;
use crate::design::{Index, NORMALS_SIZE, NetDesign};
use crate::editor::net::Nets;
use crate::editor::net::tables::Action;
use crate::editor::{Editor, refusal};
use crate::file::Method;
use crate::machine::Asked;
use crate::ui::words::Words;
use crate::ui::{Area, Caption, Desk, Field, Form, Number, Stay};

/// The largest distance that can be typed.
const FARTHEST: f64 = 99_999.0;

const ANGLES: Words = Words("Normális (fok)", "Normal (degrees)");
const AROUND: Words = Words("körül = ", "round = ");
const UP: Words = Words("fel = ", "up = ");
const DISTANCE: Words = Words("Távolság:", "Distance:");
const POINTS: Words = Words("Pontok u és v mentén", "Points along u and v");
const BOTH: [Words; 2] = [Words("egy oldal", "one side"), Words("mindkét oldal", "both sides")];
const SHELL: [Words; 2] = [Words("héj nélkül", "no shell"), Words("héj: peremfalakkal", "shell: with walls")];
const NO_OFFSET: Words = Words("előbb távolságot adjon: P", "give a distance first: P");
const AUTOMATIC: Words = Words("a normálisok a spline-felületéi", "the normals are those of a spline");
const NO_SPLINE: Words =
    Words("a pontok egybeesnek: nincs normálisuk", "points coincide and have no normals");
const COMPARED: [Words; 2] = [
    Words("lila: a másik módszer felülete", "magenta: the surface by the other method"),
    Words("a másik módszer lép a helyébe", "the other method takes its place"),
];

fn field(x: i32, range: std::ops::RangeInclusive<i32>) -> Field {
    let area = Area::new(x, 27, x + 38, 39);
    Field { area, at: (area.x1 + 4, 30), longest: 4, kind: Number::Whole(range) }
}

impl Editor<Nets, 3> {
    /// Carries out a command that only these surfaces have.
    pub(in crate::editor::net) async fn change_normals(
        &mut self,
        desk: &mut Desk<'_>,
        action: Action,
    ) -> Asked<()> {
        match action {
            Action::Normal => {
                let index = self.ask_index(desk).await?;
                self.ask_normal(desk, index).await?;
            }
            Action::NormalAt(index) => self.ask_normal(desk, index).await?,
            Action::Automatic => {
                let design = self.history.now().with_automatic_normals();
                let known = design.net.normals.is_some();
                desk.tell(if known { AUTOMATIC } else { NO_SPLINE }, Stay::Briefly);
                self.change_surface(desk, design);
            }
            Action::Distance => {
                let area = Area::new(330, 19, 393, 32);
                let kind = Number::Real(-FARTHEST..=FARTHEST);
                let field = Field { area, at: (338, 22), longest: 7, kind };
                let form = Form::new(vec![Caption::new((232, 22), DISTANCE)], [field]);
                let [distance] = desk.numbers(self, &form).await?;
                let named = (distance != 0.0).then_some(distance);
                let design = self.history.now().with_settings(|settings| settings.distance = named);
                self.change_surface(desk, design);
            }
            Action::Both => self.switch(desk, |beside| &mut beside.both, BOTH),
            Action::Shell => self.switch(desk, |beside| &mut beside.shell, SHELL),
            Action::Compare => {
                let compared = self.craft.beside.compared;
                self.craft.beside.compared = !compared;
                desk.tell(COMPARED[usize::from(compared)], Stay::Briefly);
                if compared {
                    let method = Some(other(self.history.now().method())).filter(|it| *it != Method::Pn);
                    let design = self.history.now().with_settings(|settings| settings.method = method);
                    self.change_surface(desk, design);
                } else if self.craft.drawn.is_some() {
                    self.refresh(desk);
                }
            }
            Action::Gauss => self.craft.beside.gauss = !self.craft.beside.gauss,
            Action::Size => {
                let range = || {
                    let end = |value: usize| i32::try_from(value).unwrap_or(i32::MAX);
                    end(*NORMALS_SIZE.start())..=end(*NORMALS_SIZE.end())
                };
                let names = [(250, Words("u:", "u:")), (330, Words("v:", "v:"))];
                let names = names.map(|(x, name)| Caption::new((x, 30), name));
                let captions = std::iter::once(Caption::new((232, 13), POINTS)).chain(names).collect();
                let form = Form::new(captions, [field(275, range()), field(355, range())]);
                let size = desk.numbers(self, &form).await?.map(|count| count as usize);
                match self.history.now().resized(size) {
                    Ok(design) => self.change_surface(desk, design),
                    Err(error) => desk.tell(refusal::of_surface(&error), Stay::UntilRead),
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Asks for the two angles of a normal.
    async fn ask_normal(&mut self, desk: &mut Desk<'_>, index: Index) -> Asked<()> {
        self.craft.chosen = Some((index, crate::design::Part::Place));
        let names = [(225, AROUND), (345, UP)].map(|(x, name)| Caption::new((x, 30), name));
        let captions = std::iter::once(Caption::new((285, 13), ANGLES)).chain(names).collect();
        let form = Form::new(captions, [field(292, -360..=360), field(395, -90..=90)]);
        let angles = desk.numbers(self, &form).await;
        self.craft.chosen = None;
        let [around, up] = angles?.map(f64::to_radians);
        let normal = [up.cos() * around.cos(), up.cos() * around.sin(), up.sin()];
        self.change_surface(desk, self.history.now().with_normal(index, normal));
        Ok(())
    }

    fn switch(
        &mut self,
        desk: &mut Desk<'_>,
        of: impl Fn(&mut super::Beside) -> &mut bool,
        said: [Words; 2],
    ) {
        let it = of(&mut self.craft.beside);
        *it = !*it;
        let said = said[usize::from(*it)];
        let none = self.history.now().distance() == 0.0;
        desk.tell(if none { NO_OFFSET } else { said }, Stay::Briefly);
        if self.craft.drawn.is_some() {
            self.refresh(desk);
        }
    }

    /// Takes up what is known of the present net.
    pub(in crate::editor::net) fn look_at_facts(&mut self) {
        let (net, dragged) = (self.preview(), self.held.is_some());
        let compared = self.craft.beside.compared;
        let known = |facts: &super::Facts| facts.are_of(&net, compared, dragged);
        if !self.craft.facts.as_ref().is_some_and(known) {
            self.craft.facts = Some(super::Facts::of(&net, compared, dragged));
        }
    }

    /// The surface and its offsets as models for other programs.
    pub(in crate::editor::net) fn models_with_offsets(&self) -> Vec<Box<dyn crate::geometry::ParamSurface>> {
        let net: &NetDesign = self.history.now();
        let Ok(surface) = net.patches_with_normals().and_then(|patches| Ok(patches.surface()?)) else {
            return Vec::new();
        };
        let d = net.distance();
        let sides = [
            Some(0.0),
            Some(d).filter(|d| *d != 0.0),
            Some(-d).filter(|d| *d != 0.0 && self.craft.beside.both),
        ];
        let offsets = sides.into_iter().flatten().filter_map(|d| surface.offset(d).ok());
        offsets.map(|surface| Box::new(surface) as Box<dyn crate::geometry::ParamSurface>).collect()
    }
}
