//! The command P: the distance of the offset, both sides, trimming.

use super::plane::{FARTHEST, Options};
use super::texts;
use crate::machine::{Asked, Key, Language, Request, Stop};
use crate::screen::{Color, Screen};
use crate::ui::{Accepts, Area, Choices, Desk, Entry, Over, Picture, TOP, Typed};

/// Asks for a number, or a letter that changes something at once.
pub(super) async fn ask(desk: &mut Desk<'_>, picture: &dyn Picture, options: &mut Options) -> Asked<()> {
    let (x, y) = TOP;
    let area = Area::new(x + 128, y + 4, x + 184, y + 17);
    let mut entry = Entry::new(area, (area.x1 + 6, y + 7), 6, Accepts::Number);
    let window = |at: i32| Area::new(x + at, y + 21, x + at + 70, y + 34);
    let answers =
        vec![(window(8), texts::BOTH, 'M'), (window(84), texts::TRIM, 'C'), (window(160), texts::NONE, 'N')];
    let digits = ('0'..='9').chain(['-', '.', 'M', 'C', 'N']).map(Key::Char);
    let request = Request::Keys(digits.chain([Key::Backspace]).collect());
    let choices = Choices { place: TOP, captions: Vec::new(), answers };
    loop {
        let typing = Over::new(picture, |screen: &mut Screen, language: Language| {
            choices.draw(screen, language);
            screen.text(x + 12, y + 7, texts::DISTANCE.of(language), Color::Black);
            entry.draw(screen);
        });
        let tick = desk.event_asked(&typing, request.clone()).await?;
        let clicked = tick.click().and_then(|(x, y)| {
            choices.answers.iter().find(|(area, ..)| area.holds(x, y)).map(|&(.., letter)| letter)
        });
        match clicked.or(tick.letter()) {
            Some('M') => {
                options.both = !options.both;
                options.distance = options.distance.or(Some(20.0));
                return Ok(());
            }
            Some('C') => {
                options.trim = !options.trim;
                return Ok(());
            }
            Some('N') => {
                options.distance = None;
                return Ok(());
            }
            _ => {}
        }
        if tick.pressed(Key::Esc) {
            return Err(Stop::Cancelled);
        }
        match tick.key().map_or(Typed::On, |key| entry.key(key)) {
            Typed::On => {}
            Typed::Cancelled => return Err(Stop::Cancelled),
            Typed::Done => match entry.text.parse::<f64>().ok().filter(|it| it.is_finite()) {
                Some(number) => {
                    options.distance = Some(number.clamp(-FARTHEST, FARTHEST));
                    return Ok(());
                }
                None => entry.text.clear(),
            },
        }
    }
}
