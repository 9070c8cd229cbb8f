//! The commands.

use super::bench::{Bench, Handle};
use super::sheet::FIELD;
use super::table::Action;
use super::texts;
use crate::design::knots::edit::{self, Ends};
use crate::editor::curve::ask::{ask_existing, ask_index};
use crate::editor::place::ask_place_in_field;
use crate::editor::{Craft, Editor};
use crate::file::MAX_POINTS;
use crate::geometry::knots::{KnotError, MAX_ORDER, MIN_ORDER};
use crate::machine::{Asked, Stop};
use crate::ui::words::{self, Hot, Words};
use crate::ui::{
    Answer, Area, Caption, Choices, Desk, Field, Form, Number, Phrase, Picture, Question, Stay, TOP,
};
use crate::work::{Next, offer_to_save, quit};

/// What V changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    Point,
    Knot,
    Weight,
}

/// The range of weights that can be typed.
const WEIGHTS: std::ops::RangeInclusive<f64> = 1e-3..=1e3;
/// How far a first or last knot may be moved by number.
const FAR: f64 = 1e6;
/// Letters of a number that is typed.
const LONGEST: usize = 11;

impl Editor<Bench, 2> {
    /// Carries out a command.
    pub(super) async fn carry_out(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        let options = &mut self.craft.options;
        match action {
            Action::Paths => options.paths = !options.paths,
            Action::Envelope => options.envelope = !options.envelope,
            Action::Compare => options.compared = !options.compared,
            Action::Comb => options.comb = !options.comb,
            Action::Hodograph => options.hodograph = !options.hodograph,
            Action::Region if options.region => options.region = false,
            Action::Region => match self.region_problem() {
                Some(error) => desk.tell(texts::refusal(&error), Stay::UntilRead),
                None => self.craft.options.region = true,
            },
            Action::Follow => {
                options.live = !options.live;
                let text = if options.live { texts::FOLLOWS } else { texts::FOLLOWS_NOT };
                desk.tell(text, Stay::Briefly);
            }
            Action::Opposed => self.toggle_opposed(desk),
            Action::NextKnot => self.next_knot(),
            Action::Insert => self.insert(desk).await?,
            Action::Change => self.change(desk).await?,
            Action::Delete => self.delete(desk).await?,
            Action::DeleteHere => self.delete_here(desk),
            Action::Choose => self.choose(desk).await?,
            Action::Elevate => self.rewrite(desk, |curve| curve.elevated()),
            Action::Through if self.history.now().is_curve() => self.go_through(desk).await?,
            Action::Through => desk.tell(texts::NO_CURVE, Stay::Briefly),
            Action::Result => self.show_result(desk).await?,
            Action::Quit => return quit(self, desk).await,
            Action::Surface => {
                if self.history.unsaved() {
                    offer_to_save(self, desk).await?;
                }
                self.craft.passage.lead(None);
                return Ok(Next::End);
            }
        }
        Ok(Next::Work)
    }

    /// Changes the document by an exact change of its knots, or says why not.
    fn rewrite(
        &mut self,
        desk: &mut Desk<'_>,
        change: impl FnOnce(&super::bench::Curve) -> Result<super::bench::Curve, KnotError>,
    ) {
        match edit::rewritten(self.history.now(), change) {
            Ok(curve) if curve.points.len() > MAX_POINTS => desk.tell(words::FULL, Stay::Briefly),
            Ok(curve) => self.history.change(curve),
            Err(error) => desk.tell(texts::refusal(&error), Stay::UntilRead),
        }
    }

    /// The key Tab: the next knot that the curve depends on.
    fn next_knot(&mut self) {
        let now = self.history.now();
        let (all, chosen) = (self.movable(now), self.chosen(now));
        let at = chosen.and_then(|chosen| all.iter().position(|stack| stack.first > chosen.first));
        self.craft.knot = at.and_then(|at| all.get(at)).or(all.first()).map(|stack| stack.first);
    }

    /// The command L: the chosen knot moves against its partner, or alone again.
    fn toggle_opposed(&mut self, desk: &mut Desk<'_>) {
        let now = self.history.now();
        let possible = self.movable(now).into_iter().find(|stack| self.partner(now, stack.first).is_some());
        let chosen = self.chosen(now).filter(|stack| self.partner(now, stack.first).is_some());
        if self.craft.options.opposed {
            self.craft.options.opposed = false;
        } else if let Some(stack) = chosen.or(possible) {
            self.craft.knot = Some(stack.first);
            self.craft.options.opposed = true;
        } else {
            let error = if now.closed { KnotError::Closed } else { KnotError::NoSpan };
            desk.tell(texts::refusal(&error), Stay::UntilRead);
        }
    }

    /// The command B.
    async fn insert(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let question = Question::new(TOP, texts::ASK_INSERT, [words::POINT, texts::KNOT]);
        if desk.ask(self, &question).await? == Answer::First {
            if self.history.now().points.len() >= MAX_POINTS {
                desk.tell(words::FULL, Stay::Briefly);
                return Ok(());
            }
            let index = ask_index(desk, self).await?;
            let place = ask_place_in_field(desk, self, FIELD).await?;
            self.history.change(edit::inserted(self.history.now(), index, place));
            return Ok(());
        }
        let Some(facts) = self.facts(self.history.now()) else {
            desk.tell(texts::NO_CURVE, Stay::Briefly);
            return Ok(());
        };
        let [from, to] = facts.curve.vector().domain();
        let u = (self.u(&facts) * 1e4).round() / 1e4;
        let value = ask_number(self, desk, texts::INSERT_ENTRY, Number::Real(from..=to), Some(u)).await?;
        self.rewrite(desk, |curve| curve.with_inserted(value));
        Ok(())
    }

    /// The command V.
    async fn change(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let what = three(
            words::ASK_CHANGE,
            [(words::POINT, What::Point), (texts::KNOT, What::Knot), (texts::WEIGHT, What::Weight)],
        );
        let count = self.history.now().points.len();
        match desk.choose(self, &what).await? {
            What::Point => {
                let index = ask_existing(desk, self, count).await?;
                let question = Question::new(TOP, words::ASK_CHANGE, [words::NUMBER, words::PLACE]);
                let changed = match desk.ask(self, &question).await? {
                    Answer::First => {
                        let to = ask_existing(desk, self, count).await?;
                        edit::renumbered(self.history.now(), index, to)
                    }
                    Answer::Second => {
                        let place = ask_place_in_field(desk, self, FIELD).await?;
                        edit::moved(self.history.now(), index, place)
                    }
                };
                self.history.change(changed);
            }
            What::Knot => {
                let knot = self.ask_knot(desk).await?;
                let now = self.history.now();
                let [low, high] = edit::room(now, knot, 1);
                let old = now.knots.get(knot).copied();
                let value = ask_number(
                    self,
                    desk,
                    texts::VALUE_ENTRY,
                    Number::Real(low.max(-FAR)..=high.min(FAR)),
                    old,
                );
                let value = value.await?;
                self.craft.knot = Some(knot);
                self.history.change(edit::knot_moved(self.history.now(), knot, 1, value));
            }
            What::Weight => {
                let index = ask_existing(desk, self, count).await?;
                let weights = self.history.now().weights.as_ref();
                let old = weights.and_then(|weights| weights.get(index)).copied().unwrap_or(1.0);
                let weight =
                    ask_number(self, desk, texts::WEIGHT_ENTRY, Number::Real(WEIGHTS), Some(old)).await?;
                self.history.change(edit::weighted(self.history.now(), index, weight));
            }
        }
        Ok(())
    }

    /// The command T. Of a knot it first says how far the curve would move.
    async fn delete(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let question = Question::new(TOP, texts::ASK_DELETE, [words::POINT, texts::KNOT]);
        if desk.ask(self, &question).await? == Answer::First {
            let index = ask_existing(desk, self, self.history.now().points.len()).await?;
            self.history.change(edit::deleted(self.history.now(), index));
            return Ok(());
        }
        let knot = self.ask_knot(desk).await?;
        let now = self.history.now();
        let removed = match self.facts(now) {
            Some(facts) => facts.curve.with_removed(super::bench::index(now, knot), f64::INFINITY),
            None => Err(KnotError::NoSpan),
        };
        match removed {
            Ok((curve, by)) => {
                desk.tell(texts::would_move(knot, by), Stay::UntilRead);
                if desk.yes(self, texts::ASK_REMOVE).await? {
                    self.history.change(crate::design::knots::document(&curve));
                }
            }
            Err(error) => desk.tell(texts::refusal(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// The key Delete: the point under the mouse goes.
    fn delete_here(&mut self, desk: &mut Desk<'_>) {
        let mouse = desk.machine.mouse();
        match Bench::handle_at(self, (mouse.x, mouse.y)) {
            Some(Handle::Point(index)) if index < self.history.now().points.len() => {
                self.history.change(edit::deleted(self.history.now(), index));
                desk.tell(words::deleted(index + 1), Stay::Briefly);
            }
            _ => desk.tell(words::NOTHING_HERE, Stay::Briefly),
        }
    }

    /// The command G: order and ends.
    async fn choose(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let now = self.history.now();
        let orders = i32::try_from(MIN_ORDER).unwrap_or(2)..=i32::try_from(MAX_ORDER).unwrap_or(8);
        let old = Some(now.order as f64);
        let order = ask_number(self, desk, texts::ORDER_ENTRY, Number::Whole(orders), old).await? as usize;
        let what = three(
            words::ASK_SHAPE,
            [(texts::OPEN, Ends::Open), (texts::CLAMPED, Ends::Clamped), (texts::CLOSED, Ends::Closed)],
        );
        let kind = desk.choose(self, &what).await?;
        let changed = edit::of_kind(self.history.now(), order, kind);
        self.history.change(changed);
        Ok(())
    }

    /// Asks for the number of a knot; the chosen one is proposed.
    async fn ask_knot(&self, desk: &mut Desk<'_>) -> Asked<usize> {
        let now = self.history.now();
        let Some(last) = now.knots.len().checked_sub(1) else {
            desk.tell(texts::NO_KNOT, Stay::Briefly);
            return Err(Stop::Cancelled);
        };
        let range = 0..=i32::try_from(last).unwrap_or(i32::MAX);
        let chosen = self.chosen(now).map(|stack| stack.first as f64);
        let knot = ask_number(self, desk, texts::KNOT_ENTRY, Number::Whole(range), chosen).await?;
        Ok(knot as usize)
    }
}

/// Asks for a number on the page at the top, with a proposal.
pub(super) async fn ask_number(
    picture: &dyn Picture,
    desk: &mut Desk<'_>,
    caption: Words,
    kind: Number,
    proposal: Option<f64>,
) -> Asked<f64> {
    let (x, y) = (TOP.0 + 104, TOP.1 + 14);
    let field = Field { area: Area::new(x, y, x + 104, y + 13), at: (x + 8, y + 3), longest: LONGEST, kind };
    let form = Form::new(vec![Caption::new((TOP.0 + 12, y + 3), caption)], [field]);
    let proposal = proposal.map_or(String::new(), |number| number.to_string());
    let proposal = if proposal.len() > LONGEST { String::new() } else { proposal };
    let [number] = desk.numbers_or(picture, &form, [proposal]).await?;
    Ok(number)
}

/// A page of three answers.
fn three<T: Copy>(title: impl Into<Phrase>, answers: [(Hot, T); 3]) -> Choices<T> {
    let (x, y) = TOP;
    let title = Caption::new((x + 7, y + 8), title);
    let window = |at: i32| Area::new(x + 8 + 76 * at, y + 21, x + 78 + 76 * at, y + 34);
    let answers = (0..).zip(answers).map(|(at, (text, meaning))| (window(at), text, meaning)).collect();
    Choices { place: TOP, captions: vec![title], answers }
}
