//! Questions and entries on the communication page. Esc cancels the question and the command that asks it, and the
//! close button works too. The program's picture is redrawn under the page whenever something changes.

use super::desk::{Desk, Over, Picture};
use super::entry::{Accepts, Entry, Typed};
use super::frame::{Area, hot_text, page, window};
use super::save::line_entry;
use super::words::{self, Hot, Phrase};
use crate::machine::{Asked, Key, Language, Manner, Request, Stop, Tick};
use crate::screen::{Color, Screen};
use std::ops::RangeInclusive;

/// The place of the communication page at the top of the screen.
pub const TOP: (i32, i32) = (208, 5);
/// The page's place in the middle of the picture.
pub const MIDDLE: (i32, i32) = (200, 200);

/// A question with two answers.
#[derive(Clone, Debug)]
pub struct Question {
    /// The page's upper left corner.
    pub place: (i32, i32),
    /// What is asked.
    pub title: Phrase,
    /// The two answers.
    pub answers: [Hot; 2],
    /// What Enter answers in the manner of today.
    pub proposed: Answer,
}

impl Question {
    /// A question at a place.
    pub fn new(place: (i32, i32), title: impl Into<Phrase>, answers: [Hot; 2]) -> Question {
        Question { place, title: title.into(), answers, proposed: Answer::First }
    }

    /// The question with no as what is proposed: for what cannot be undone.
    #[must_use]
    pub fn careful(self) -> Question {
        Question { proposed: Answer::Second, ..self }
    }

    /// A yes-or-no question in the middle of the picture.
    pub fn yes_no(title: impl Into<Phrase>) -> Question {
        Question::new(MIDDLE, title, [words::YES, words::NO])
    }

    fn windows(&self) -> [Area; 2] {
        let (x, y) = self.place;
        [Area::new(x + 40, y + 21, x + 104, y + 34), Area::new(x + 150, y + 21, x + 210, y + 34)]
    }

    /// The question as a page of choices.
    pub(crate) fn choices(&self) -> Choices<Answer> {
        let (x, y) = self.place;
        let title = Caption { at: (x + 7, y + 8), text: self.title.clone(), color: Color::Black };
        let [first, second] = self.windows();
        let answers =
            vec![(first, self.answers[0], Answer::First), (second, self.answers[1], Answer::Second)];
        Choices { place: self.place, captions: vec![title], answers }
    }
}

/// A page with some answers to choose from.
#[derive(Clone, Debug)]
pub struct Choices<T> {
    /// The page's upper left corner.
    pub place: (i32, i32),
    /// The texts on the page.
    pub captions: Vec<Caption>,
    /// The answers in their windows, with what they mean.
    pub answers: Vec<(Area, Hot, T)>,
}

impl<T: Copy + PartialEq> Choices<T> {
    /// Draws the page.
    pub fn draw(&self, screen: &mut Screen, language: Language) {
        self.draw_with(None, screen, language);
    }

    /// Draws the page, with the answer of Enter highlighted.
    fn draw_with(&self, default: Option<T>, screen: &mut Screen, language: Language) {
        page(screen, self.place);
        for caption in &self.captions {
            screen.text(caption.at.0, caption.at.1, caption.text.of(language), caption.color);
        }
        for &(area, answer, meaning) in &self.answers {
            let ink = if default == Some(meaning) { Color::Yellow } else { Color::White };
            window(screen, area);
            hot_text(screen, area.x1 + 5, area.y1 + 3, answer, ink, language);
        }
    }
}

impl<T> Choices<T> {
    /// The answer of a key or a click. In English, Y says yes too.
    fn answer(&self, tick: &Tick, language: Language) -> Option<&T> {
        let letter = tick.letter();
        let yes = letter == Some('Y') && language == Language::English;
        let chosen = |&&(area, text, _): &&(Area, Hot, T)| {
            letter == Some(text.letter)
                || (yes && text == words::YES)
                || tick.click().is_some_and(|(x, y)| area.holds(x, y))
        };
        self.answers.iter().find(chosen).map(|(.., meaning)| meaning)
    }

    /// The letters that answer.
    fn letters(&self, language: Language) -> Vec<Key> {
        let letter = |text: Hot| match language {
            Language::English if text == words::YES => 'Y',
            _ => text.letter,
        };
        self.answers.iter().map(|&(_, text, _)| Key::Char(letter(text))).collect()
    }

    /// The keys that answer, for the user.
    fn keys(&self, language: Language) -> String {
        let letters: String = self.letters(language).iter().map(|key| format!("{key} ")).collect();
        format!("{letters} Enter")
    }
}

/// What stands under a page in the manner of today: which keys or numbers are right, and a place to click that cancels.
struct Strip {
    page: (i32, i32),
}

impl Strip {
    /// Letters of its text.
    const LETTERS: usize = 22;

    fn area(&self) -> Area {
        let (x, y) = self.page;
        Area::new(x, y + 46, x + 240, y + 60)
    }

    fn cancel(&self) -> Area {
        let Area { y1, x2, y2, .. } = self.area();
        Area::new(x2 - 52, y1, x2, y2)
    }

    fn draw(&self, screen: &mut Screen, text: &str) {
        let Area { x1, y1, .. } = self.area();
        super::frame::panel(screen, x1, y1, 240, 14);
        let text: String = text.chars().take(Strip::LETTERS).collect();
        screen.text(x1 + 6, y1 + 4, &text, Color::Blue);
        screen.text(x1 + 192, y1 + 4, "x Esc", Color::LightRed);
    }

    /// Whether an event cancels what is asked.
    fn cancels(strip: Option<&Strip>, tick: &Tick) -> bool {
        let clicked = |strip: &Strip| tick.click().is_some_and(|(x, y)| strip.cancel().holds(x, y));
        tick.pressed(Key::Esc) || strip.is_some_and(clicked)
    }
}

/// The first or the second answer of a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The answer on the left.
    First,
    /// The answer on the right.
    Second,
}

/// A text on an entry page.
#[derive(Clone, Debug)]
pub struct Caption {
    /// Upper left pixel.
    pub at: (i32, i32),
    /// The text.
    pub text: Phrase,
    /// Its colour.
    pub color: Color,
}

impl Caption {
    /// A black text at a place.
    pub fn new(at: (i32, i32), text: impl Into<Phrase>) -> Caption {
        Caption { at, text: text.into(), color: Color::Black }
    }

    /// The text in another colour.
    pub fn colored(self, color: Color) -> Caption {
        Caption { color, ..self }
    }
}

/// A number to be typed.
#[derive(Clone, Debug)]
pub struct Field {
    /// The window around it.
    pub area: Area,
    /// Where the first character stands.
    pub at: (i32, i32),
    /// How many characters fit.
    pub longest: usize,
    /// The numbers that are accepted.
    pub kind: Number,
}

/// The numbers that a field accepts. As in the original, a number is clamped to the range.
#[derive(Clone, Debug, PartialEq)]
pub enum Number {
    /// Whole numbers.
    Whole(RangeInclusive<i32>),
    /// Decimal numbers.
    Real(RangeInclusive<f64>),
}

impl Number {
    /// The numbers that are taken, for the user; empty where there is no end.
    fn range(&self) -> String {
        match self {
            Number::Whole(range) if *range.end() == i32::MAX => String::new(),
            Number::Whole(range) => format!("{} ... {}", range.start(), range.end()),
            Number::Real(range) if *range.end() == f64::MAX => String::new(),
            Number::Real(range) => format!("{} ... {}", range.start(), range.end()),
        }
    }

    /// The number that was typed, moved into the range; `None` if it is no number.
    pub fn read(&self, text: &str) -> Option<f64> {
        match self {
            // Parsed as a wide type: a number too large for the range is still a number.
            Number::Whole(range) => text
                .parse::<i64>()
                .ok()
                .map(|number| number.clamp(i64::from(*range.start()), i64::from(*range.end())) as f64),
            Number::Real(range) => {
                let number: f64 = text.parse().ok()?;
                number.is_finite().then(|| number.clamp(*range.start(), *range.end()))
            }
        }
    }
}

/// A page with `N` numbers to type, one after the other.
#[derive(Clone, Debug)]
pub struct Form<const N: usize> {
    /// The texts on the page.
    pub captions: Vec<Caption>,
    /// The numbers, in the order in which they are typed.
    pub fields: [Field; N],
    /// Draws the rest of the page.
    pub ornament: fn(&mut Screen),
}

impl<const N: usize> Form<N> {
    /// A page of texts and numbers.
    pub fn new(captions: Vec<Caption>, fields: [Field; N]) -> Form<N> {
        Form { captions, fields, ornament: |_| {} }
    }
}

impl Desk<'_> {
    /// Asks a question.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn ask(&mut self, picture: &dyn Picture, question: &Question) -> Asked<Answer> {
        let proposed = (self.machine.manner() == Manner::Today).then_some(question.proposed);
        self.choose_or(picture, &question.choices(), proposed).await
    }

    /// Asks for one of several answers, chosen by letter or click, and returns its meaning.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn choose<T: Copy + PartialEq>(
        &mut self,
        picture: &dyn Picture,
        choices: &Choices<T>,
    ) -> Asked<T> {
        self.choose_or(picture, choices, None).await
    }

    /// Like [`Desk::choose`]; Enter gives the default answer, if any. In the manner of today Tab and the arrows make
    /// another answer the default.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn choose_or<T: Copy + PartialEq>(
        &mut self,
        picture: &dyn Picture,
        choices: &Choices<T>,
        default: Option<T>,
    ) -> Asked<T> {
        let strip = self.strip(choices.place);
        let first = choices.answers.first().map(|&(.., meaning)| meaning);
        let mut default = default.or(first.filter(|_| strip.is_some()));
        loop {
            let page = Over::new(picture, |screen: &mut Screen, language: Language| {
                choices.draw_with(default, screen, language);
                strip.iter().for_each(|strip| strip.draw(screen, &choices.keys(language)));
            });
            let tick =
                self.event_asked(&page, Request::Keys(choices.letters(self.machine.language()))).await?;
            if Strip::cancels(strip.as_ref(), &tick) {
                return Err(Stop::Cancelled);
            }
            if strip.is_some() && matches!(tick.key(), Some(Key::Tab | Key::Right | Key::Left)) {
                // The answer that Enter gives is another one (1.5.3).
                let count = choices.answers.len().max(1);
                let now = choices.answers.iter().position(|&(.., meaning)| default == Some(meaning));
                let step = if tick.pressed(Key::Left) { count - 1 } else { 1 };
                let next = now.map_or(0, |now| (now + step) % count);
                default = choices.answers.get(next).map(|&(.., meaning)| meaning);
            }
            let entered = default.filter(|_| tick.pressed(Key::Enter));
            if let Some(meaning) = entered.or(choices.answer(&tick, self.machine.language()).copied()) {
                return Ok(meaning);
            }
        }
    }

    /// The strip under a page, in the manner of today.
    fn strip(&self, page: (i32, i32)) -> Option<Strip> {
        (self.machine.manner() == Manner::Today).then_some(Strip { page })
    }

    /// Asks a yes-or-no question.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn yes(&mut self, picture: &dyn Picture, title: impl Into<Phrase>) -> Asked<bool> {
        Ok(self.ask(picture, &Question::yes_no(title)).await? == Answer::First)
    }

    /// Asks for numbers on the page at the top, one for each field of the form. Text that is not a number is cleared
    /// and asked for again.
    ///
    /// # Errors
    /// [`Stop`]: Esc in any of them, or the display is being closed.
    pub async fn numbers<const N: usize>(
        &mut self,
        picture: &dyn Picture,
        form: &Form<N>,
    ) -> Asked<[f64; N]> {
        self.numbers_or(picture, form, [const { String::new() }; N]).await
    }

    /// As [`Desk::numbers`], with proposals that Enter takes.
    ///
    /// # Errors
    /// [`Stop`]: Esc in any of them, or the display is being closed.
    pub async fn numbers_or<const N: usize>(
        &mut self,
        picture: &dyn Picture,
        form: &Form<N>,
        proposals: [String; N],
    ) -> Asked<[f64; N]> {
        let mut entries = form
            .fields
            .each_ref()
            .map(|field| Entry::new(field.area, field.at, field.longest, Accepts::Number));
        for (entry, proposal) in entries.iter_mut().zip(proposals) {
            if !proposal.is_empty() {
                *entry = entry.clone().proposing(proposal);
            }
        }
        let mut numbers = [0.0; N];
        let strip = self.strip(TOP);
        for (index, field) in form.fields.iter().enumerate() {
            numbers[index] = loop {
                let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
                    page(screen, TOP);
                    for caption in &form.captions {
                        screen.text(caption.at.0, caption.at.1, caption.text.of(language), caption.color);
                    }
                    (form.ornament)(screen);
                    entries.iter().for_each(|entry| entry.draw(screen));
                    strip.iter().for_each(|strip| strip.draw(screen, &field.kind.range()));
                });
                let tick = self.event_asked(&typing, Request::Number).await?;
                if Strip::cancels(strip.as_ref(), &tick) {
                    return Err(Stop::Cancelled);
                }
                let entry = &mut entries[index];
                match tick.key().map_or(Typed::On, |key| entry.key(key)) {
                    Typed::On => {}
                    Typed::Cancelled => return Err(Stop::Cancelled),
                    Typed::Done => match field.kind.read(&entry.text) {
                        Some(number) => {
                            entry.text = number.to_string();
                            break number;
                        }
                        None => entry.text.clear(),
                    },
                }
            };
        }
        Ok(numbers)
    }

    /// Asks for a file name, typed without extension.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn file_name(&mut self, picture: &dyn Picture, extension: &str, way: Way) -> Asked<String> {
        // The original places the window differently for saving and loading.
        let (right, dot_x, y) = match way {
            Way::Save => (350, 350, 221),
            Way::Load => (360, 364, 222),
        };
        let entry = Entry::new(Area::new(270, 219, right, 232), (278, y + 1), 8, Accepts::Name);
        self.type_name(picture, extension, entry, dot_x).await
    }

    /// As [`Desk::file_name`], for a file to be saved; the name of the present one is proposed.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn file_name_or(&mut self, picture: &dyn Picture, extension: &str) -> Asked<String> {
        let present = self.machine.file().and_then(|name| name.rsplit_once('.'));
        let proposal = present.map(|(stem, _)| stem.to_uppercase()).unwrap_or_default();
        self.name_proposed(picture, extension, &proposal).await
    }

    /// Lets a file name without extension be typed, with a proposal and room for it.
    pub(super) async fn name_proposed(
        &mut self,
        picture: &dyn Picture,
        extension: &str,
        proposal: &str,
    ) -> Asked<String> {
        let entry = Entry::new(Area::new(214, 219, 390, 232), (222, 222), LONGEST_NAME, Accepts::Name);
        self.type_name(picture, extension, entry.proposing(proposal), 394).await
    }

    async fn type_name(
        &mut self,
        picture: &dyn Picture,
        extension: &str,
        mut entry: Entry,
        dot_x: i32,
    ) -> Asked<String> {
        let dotted = format!(".{extension}");
        let strip = self.strip(MIDDLE);
        loop {
            let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
                page(screen, MIDDLE);
                screen.text(262, 208, words::FILE_NAME.of(language), Color::Black);
                entry.draw(screen);
                screen.text(dot_x, 222, &dotted, Color::Black);
                strip.iter().for_each(|strip| strip.draw(screen, "Enter"));
            });
            let tick = self.event_asked(&typing, Request::Text).await?;
            if Strip::cancels(strip.as_ref(), &tick) {
                return Err(Stop::Cancelled);
            }
            match tick.key().map_or(Typed::On, |key| entry.key(key)) {
                Typed::On => {}
                Typed::Cancelled => return Err(Stop::Cancelled),
                Typed::Done => {
                    let name = entry.text.strip_suffix(&dotted).unwrap_or(&entry.text);
                    if name.contains('.') {
                        self.tell(words::NO_DOT, super::Stay::UntilRead);
                    } else if !name.is_empty() {
                        return Ok(format!("{name}{dotted}"));
                    }
                }
            }
        }
    }

    /// Asks for a line of text on the page at the top, below a caption; Enter takes what is proposed.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn text(
        &mut self,
        picture: &dyn Picture,
        caption: impl Into<Phrase>,
        proposal: &str,
    ) -> Asked<String> {
        let entry = line_entry(LONGEST_TEXT, Accepts::Text);
        let entry = if proposal.is_empty() { entry } else { entry.proposing(proposal) };
        self.type_line(picture, caption, entry).await
    }

    /// As [`Desk::text`], until a text has a meaning; why one has none is said.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn meaning<T>(
        &mut self,
        picture: &dyn Picture,
        caption: impl Into<Phrase>,
        proposal: &str,
        read: impl Fn(&str) -> Result<T, Phrase>,
    ) -> Asked<T> {
        let caption = caption.into();
        let mut proposal = proposal.to_owned();
        loop {
            let text = self.text(picture, caption.clone(), &proposal).await?;
            match read(&text) {
                Ok(meaning) => return Ok(meaning),
                Err(problem) => self.tell(problem, super::Stay::UntilRead),
            }
            proposal = text;
        }
    }

    pub(super) async fn type_line(
        &mut self,
        picture: &dyn Picture,
        caption: impl Into<Phrase>,
        mut entry: Entry,
    ) -> Asked<String> {
        let caption = caption.into();
        let strip = self.strip(TOP);
        loop {
            let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
                page(screen, TOP);
                screen.text(TOP.0 + 8, TOP.1 + 5, caption.of(language), Color::Black);
                entry.draw(screen);
                strip.iter().for_each(|strip| strip.draw(screen, "Enter"));
            });
            let tick = self.event_asked(&typing, Request::Text).await?;
            if Strip::cancels(strip.as_ref(), &tick) {
                return Err(Stop::Cancelled);
            }
            match tick.key().map_or(Typed::On, |key| entry.key(key)) {
                Typed::On => {}
                Typed::Cancelled => return Err(Stop::Cancelled),
                Typed::Done => return Ok(entry.text),
            }
        }
    }
}

/// Greatest length of a line of text, in characters.
const LONGEST_TEXT: usize = 200;
/// Greatest length of a file name with a proposal, in characters.
const LONGEST_NAME: usize = 20;

/// Whether a file name is asked for to save or to load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The file will be written.
    Save,
    /// The file will be read.
    Load,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_the_original_reads_them() {
        let whole = Number::Whole(0..=560);
        assert_eq!(whole.read("999"), Some(560.0));
        assert_eq!(whole.read("-5"), Some(0.0));
        assert_eq!(whole.read("99999999999"), Some(560.0));
        for junk in ["", "-", "1.5", "1E2", "--1"] {
            assert_eq!(whole.read(junk), None, "{junk:?}");
        }
        let real = Number::Real(-10.0..=10.0);
        assert_eq!(real.read("0.5"), Some(0.5));
        assert_eq!(real.read("1E1"), Some(10.0));
        assert_eq!(real.read("1E999"), None);
        for junk in ["", ".", "E", "1E", "-"] {
            assert_eq!(real.read(junk), None, "{junk:?}");
        }
    }
}
