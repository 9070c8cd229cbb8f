//! Questions and entries on the communication page. Esc cancels every one of them and what asks it, and the
//! close button works in them; the program's picture is drawn under them again whenever something changes.

use super::desk::{Desk, Over, Picture};
use super::entry::{Accepts, Entry, Typed};
use super::frame::{Area, hot_text, page, window};
use super::words::{self, Hot, Phrase, Words};
use crate::machine::{Asked, Key, Language, Stop};
use crate::screen::{Color, Screen};
use std::ops::RangeInclusive;

/// The communication page's place at the top of the screen.
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
}

impl Question {
    /// A question at a place.
    pub fn new(place: (i32, i32), title: impl Into<Phrase>, answers: [Hot; 2]) -> Question {
        Question { place, title: title.into(), answers }
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

    /// Draws the page; the answer of Enter stands out.
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
    /// What is taken.
    pub kind: Number,
}

/// What numbers a field takes. A number outside the range becomes its nearest end, as in the original.
#[derive(Clone, Debug, PartialEq)]
pub enum Number {
    /// Whole numbers.
    Whole(RangeInclusive<i32>),
    /// Numbers with a fraction.
    Real(RangeInclusive<f64>),
}

impl Number {
    /// The number that was typed, moved into the range; `None` if it is no number.
    pub fn read(&self, text: &str) -> Option<f64> {
        match self {
            // Through a wide type: what is too large for the range is still a number.
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

/// A page of `N` numbers that are typed one after the other.
#[derive(Clone, Debug)]
pub struct Form<const N: usize> {
    /// The texts on the page.
    pub captions: Vec<Caption>,
    /// The numbers, in the order in which they are typed.
    pub fields: [Field; N],
    /// What is drawn on the page besides.
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
        self.choose(picture, &question.choices()).await
    }

    /// Lets one of several answers be chosen by its letter or a click, and gives what it means.
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

    /// As [`Desk::choose`]; Enter gives the default answer, if there is one.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn choose_or<T: Copy + PartialEq>(
        &mut self,
        picture: &dyn Picture,
        choices: &Choices<T>,
        default: Option<T>,
    ) -> Asked<T> {
        loop {
            let page = Over::new(picture, |screen: &mut Screen, language: Language| {
                choices.draw_with(default, screen, language);
            });
            let tick = self.event(&page).await?;
            match (tick.key(), default) {
                (Some(Key::Esc), _) => return Err(Stop::Cancelled),
                (Some(Key::Enter), Some(meaning)) => return Ok(meaning),
                _ => {}
            }
            let chosen = choices.answers.iter().find(|&&(area, answer, _)| {
                tick.letter() == Some(answer.letter) || tick.click().is_some_and(|(x, y)| area.holds(x, y))
            });
            if let Some(&(.., meaning)) = chosen {
                return Ok(meaning);
            }
        }
    }

    /// Asks a yes-or-no question.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn yes(&mut self, picture: &dyn Picture, title: impl Into<Phrase>) -> Asked<bool> {
        Ok(self.ask(picture, &Question::yes_no(title)).await? == Answer::First)
    }

    /// Lets numbers be typed on the page at the top, one for each field of the form. What is no number
    /// empties its window and is asked for again.
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
        for (index, field) in form.fields.iter().enumerate() {
            numbers[index] = loop {
                let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
                    page(screen, TOP);
                    for caption in &form.captions {
                        screen.text(caption.at.0, caption.at.1, caption.text.of(language), caption.color);
                    }
                    (form.ornament)(screen);
                    entries.iter().for_each(|entry| entry.draw(screen));
                });
                let tick = self.event(&typing).await?;
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

    /// Lets a file name without extension be typed.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub async fn file_name(&mut self, picture: &dyn Picture, extension: &str, way: Way) -> Asked<String> {
        // Where the original puts the window differs by some pixels between saving and loading.
        let (right, dot_x, y) = match way {
            Way::Save => (350, 350, 221),
            Way::Load => (360, 364, 222),
        };
        let entry = Entry::new(Area::new(270, 219, right, 232), (278, y + 1), 8, Accepts::Name);
        self.type_name(picture, extension, entry, dot_x).await
    }

    /// As [`Desk::file_name`], for a file to be saved, with a proposal and room for it.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub(super) async fn file_name_or(
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
        loop {
            let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
                page(screen, MIDDLE);
                screen.text(262, 208, words::FILE_NAME.of(language), Color::Black);
                entry.draw(screen);
                screen.text(dot_x, 222, &dotted, Color::Black);
            });
            let tick = self.event(&typing).await?;
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

    /// Lets one line be typed on the page at the top, below its caption.
    ///
    /// # Errors
    /// [`Stop`]: Esc, or the display is being closed.
    pub(super) async fn type_line(
        &mut self,
        picture: &dyn Picture,
        caption: Words,
        mut entry: Entry,
    ) -> Asked<String> {
        loop {
            let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
                page(screen, TOP);
                screen.text(TOP.0 + 8, TOP.1 + 5, caption.of(language), Color::Black);
                entry.draw(screen);
            });
            let tick = self.event(&typing).await?;
            match tick.key().map_or(Typed::On, |key| entry.key(key)) {
                Typed::On => {}
                Typed::Cancelled => return Err(Stop::Cancelled),
                Typed::Done => return Ok(entry.text),
            }
        }
    }
}

/// Characters of a file name that is proposed, or typed instead.
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
