//! The table of commands, and what keys and clicks do.

use super::edit::{self, Affine};
use super::eye::Eye;
use super::rows::{self, Hit};
use super::studio::{Page, Studio};
use super::{speed, status, texts};
use crate::file::ec::{Fill, Item};
use crate::machine::{Asked, Event, Key, Tick};
use crate::ui::words::{self, Hot};
use crate::ui::{Answer, Command, Commands, Desk, KeyHelp, Question, Stay, TOP};
use crate::work::{self, Next};

/// What a command does.
#[derive(Clone, Copy)]
pub(super) enum Do {
    Page(Page),
    Change,
    New,
    Result,
    Roots,
    Delete,
    Quit,
    Polygons,
    Inspect,
    Section,
    Speed,
    Copy,
    Paste,
    NextItem,
    Home,
    Larger,
    Smaller,
}

pub(super) const fn button(x: i32, y: i32, text: Hot) -> crate::ui::Button {
    crate::ui::Button::new(x, y, text)
}

pub(super) const COMMANDS: Commands<Do> = Commands(&[
    Command::button(
        button(30, 21, Hot::new('1', " Nézet", " View")),
        texts::HELP_PAGES,
        Do::Page(Page::View),
    ),
    Command::button(
        button(30, 38, Hot::new('2', " Görbe", " Curve")),
        texts::HELP_PAGES,
        Do::Page(Page::Curve),
    )
    .untold(),
    Command::button(
        button(120, 21, Hot::new('3', " Felül.", " Surf.")),
        texts::HELP_PAGES,
        Do::Page(Page::Surface),
    )
    .untold(),
    Command::button(
        button(120, 38, Hot::new('4', " Pont", " Point")),
        texts::HELP_PAGES,
        Do::Page(Page::Point),
    )
    .untold(),
    Command::button(button(460, 4, Hot::new('V', "áltozás", "-change")), texts::HELP_CHANGE, Do::Change),
    Command::button(button(460, 21, Hot::new('B', "-új", "-new")), texts::HELP_NEW, Do::New),
    Command::button(button(460, 38, Hot::new('E', "redmény", "-result")), texts::HELP_RESULT, Do::Result),
    Command::button(button(550, 4, Hot::new('G', "yökök", "-roots")), texts::HELP_ROOTS, Do::Roots),
    Command::button(button(550, 21, Hot::new('T', "örlés", "-delete")), texts::HELP_NEW, Do::Delete).untold(),
    Command::button(button(550, 38, Hot::new('Q', "-kilép", "-quit")), texts::HELP_QUIT, Do::Quit),
    Command::told(texts::HELP_PANEL),
    Command::told(texts::HELP_SELECT),
    Command::also(Key::Tab, Do::NextItem),
    Command::told(texts::HELP_DRAG),
    Command::told(texts::HELP_TURN),
    Command::told(texts::HELP_ZOOM),
    Command::also(Key::Home, Do::Home),
    Command::key(Key::PageUp, texts::HELP_SCALE, Do::Larger),
    Command::also(Key::PageDown, Do::Smaller),
    Command::key(Key::F(3), texts::HELP_POLYGONS, Do::Polygons),
    Command::key(Key::F(5), texts::HELP_INSPECT, Do::Inspect),
    Command::also(Key::F(6), Do::Section),
    Command::key(Key::F(7), texts::HELP_SPEED, Do::Speed),
    Command::key(Key::Ctrl('C'), texts::HELP_COPY, Do::Copy),
    Command::also(Key::Ctrl('V'), Do::Paste),
    Command::told(texts::HELP_UNDO),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

impl Studio {
    /// Carries out a key or a click; the next step if the scene is left.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> Asked<Option<Next>> {
        if self.result.is_some() {
            self.in_result(tick);
            return Ok(None);
        }
        if self.list.is_some() && self.in_list(tick) {
            return Ok(None);
        }
        if tick.pressed(Key::Esc) && (self.selected.is_some() || self.page != Page::View) {
            match self.point.take() {
                Some(_) if self.page == Page::Point => self.back_from_point(),
                _ => self.select(None),
            }
            return Ok(None);
        }
        if work::common_key(self, desk, tick.key()).await? {
            self.settle_selection();
            return Ok(None);
        }
        // Rows of the page first: their actions have letters that no command has.
        let letter = tick.letter().and_then(|letter| rows::action_of(self.page, letter));
        let clicked = tick.click().and_then(|at| rows::hit(self.page, at));
        match (letter, clicked) {
            (Some(action), _) | (_, Some(Hit::Action(action))) => {
                self.act(desk, action).await?;
                return Ok(None);
            }
            (_, Some(Hit::Value(value))) => {
                self.change_value(desk, value).await?;
                return Ok(None);
            }
            _ => {}
        }
        if let (Some(Event::Wheel(steps)), Some(Hit::Value(value))) =
            (tick.event, rows::hit(self.page, (tick.mouse.x, tick.mouse.y)))
        {
            self.turn(value, steps > 0);
            return Ok(None);
        }
        if let Some(row) = tick.click().and_then(|at| status::row_at(self, at)) {
            self.list = None;
            self.select(Some(row));
            return Ok(None);
        }
        match COMMANDS.find(tick) {
            Some(command) => self.command(desk, command).await,
            None => Ok(None),
        }
    }

    pub(super) fn back_from_point(&mut self) {
        self.page = match self.item() {
            Some(Item::Patch(_)) => Page::Surface,
            _ => Page::Curve,
        };
    }

    pub(super) fn in_result(&mut self, tick: &Tick) {
        match tick.key() {
            Some(Key::Esc) => self.result = None,
            Some(Key::Char('d' | 'D')) => self.result = Some(true),
            Some(Key::Char('t' | 'T')) => self.result = Some(false),
            Some(Key::Home) => self.fit(),
            _ => {}
        }
    }

    /// Moves in the list of items; whether the event was for that.
    pub(super) fn in_list(&mut self, tick: &Tick) -> bool {
        let Some(row) = self.list else { return false };
        let last = self.scene().items.len().saturating_sub(1);
        match tick.key() {
            Some(Key::Up) => self.list = Some(row.saturating_sub(1)),
            Some(Key::Down) => self.list = Some((row + 1).min(last)),
            Some(Key::Enter) => {
                self.list = None;
                self.select(Some(row));
            }
            Some(Key::Char(' ')) => {
                let mut scene = self.history.now().clone();
                match scene.items.get_mut(row) {
                    Some(Item::Curve(curve)) => curve.style.hidden = !curve.style.hidden,
                    Some(Item::Patch(patch)) => patch.style.hidden = !patch.style.hidden,
                    None => {}
                }
                self.change(scene);
            }
            Some(Key::Esc) => self.list = None,
            _ => return false,
        }
        true
    }

    pub(super) async fn command(&mut self, desk: &mut Desk<'_>, command: Do) -> Asked<Option<Next>> {
        match command {
            Do::Page(page) if self.is_open(page) => self.page = page,
            Do::Page(_) => desk.tell(texts::NOTHING_SELECTED, Stay::Briefly),
            Do::Change => {
                let value = self.ask_row(desk).await?;
                self.change_value(desk, value).await?;
            }
            Do::New => {
                let question = Question::new(TOP, texts::ASK_KIND, [texts::CURVE, texts::SURFACE]);
                let answer = desk.ask(&*self, &question).await?;
                let number = self.scene().items.len();
                self.add(vec![match answer {
                    Answer::First => edit::new_curve(number),
                    Answer::Second => edit::new_patch(number),
                }]);
                if number == 0 {
                    self.eye = Eye { zoom: 1.0, shift: [0.0; 2], ..self.eye };
                }
            }
            Do::Result => self.result = Some(false),
            Do::Roots => self.change_space(desk).await?,
            Do::Delete => self.delete(desk).await?,
            Do::Quit => {
                return work::quit(self, desk).await.map(|next| Some(next).filter(|it| *it != Next::Work));
            }
            Do::Polygons => self.polygons = !self.polygons,
            Do::Inspect => self.inspect(desk),
            Do::Section => {
                let middle = self
                    .shapes
                    .bounds(None)
                    .map_or([0.0; 3], |it| std::array::from_fn(|d| it.min[d] / 2.0 + it.max[d] / 2.0));
                self.section = match self.section {
                    None => Some((0, middle[0])),
                    Some((axis @ (0 | 1), _)) => Some((axis + 1, middle[axis + 1])),
                    Some(_) => None,
                };
            }
            Do::Speed => speed::measure(self, desk).await?,
            Do::Copy => match self.item().cloned() {
                Some(item) => {
                    self.copied = Some(item);
                    desk.tell(texts::COPIED, Stay::Briefly);
                }
                None => desk.tell(texts::NOTHING_SELECTED, Stay::Briefly),
            },
            Do::Paste => match self.copied.clone() {
                Some(item) => self.add(vec![item]),
                None => desk.tell(texts::NOTHING_KEPT, Stay::Briefly),
            },
            Do::NextItem => {
                let count = self.scene().items.len();
                let next = self.selected.map_or(0, |at| at + 1);
                self.select(Some(next).filter(|&next| next < count));
            }
            Do::Home => self.fit(),
            Do::Larger | Do::Smaller => {
                let factor = if matches!(command, Do::Larger) { 1.05 } else { 1.0 / 1.05 };
                match self.item().cloned() {
                    Some(item) => {
                        let map = Affine::scaled(factor, edit::middle(&item));
                        self.change_item(edit::mapped(&item, &map));
                    }
                    None => desk.tell(texts::NOTHING_SELECTED, Stay::Briefly),
                }
            }
        }
        Ok(None)
    }

    pub(super) fn inspect(&mut self, desk: &mut Desk<'_>) {
        let order = [None, Some(Fill::Zebra), Some(Fill::Gaussian), Some(Fill::Mean), Some(Fill::Height)];
        let at = order.iter().position(|it| *it == self.inspection).unwrap_or(0);
        self.inspection = order[(at + 1) % order.len()];
        if let Some(fill) = self.inspection {
            let name = Fill::ALL.iter().position(|it| *it == fill).map(|at| texts::FILLS[at]);
            if let Some(name) = name {
                desk.tell(name, Stay::Briefly);
            }
        }
    }

    pub(super) async fn delete(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some(at) = self.selected else {
            desk.tell(texts::NOTHING_SELECTED, Stay::Briefly);
            return Ok(());
        };
        if desk.ask(&*self, &Question::new(TOP, texts::ASK_DELETE, [words::YES, words::NO])).await?
            == Answer::First
        {
            let mut scene = self.history.now().clone();
            edit::replace(&mut scene, at, Vec::new());
            self.select(None);
            self.change(scene);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!(super::COMMANDS.shared_keys(), []);
        assert_eq!(super::COMMANDS.too_wide(), [""; 0]);
    }
}
