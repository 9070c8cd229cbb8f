//! Questions that several parts ask.

use super::studio::Studio;
use super::texts;
use crate::design::ec::MOST_PARTS;
use crate::file::ec::{Interval, values};
use crate::geometry::ec::{EcError, Real};
use crate::machine::{Asked, Key, Language, Request, Tick};
use crate::screen::{Color, Screen};
use crate::ui::words::{Phrase, Words};
use crate::ui::{Desk, Picture, TOP, page};

/// A key or a click that means something; the page says which keys do.
pub(super) async fn ask_key<T>(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    caption: Words,
    letters: &str,
    found: impl Fn(&Tick) -> Option<T>,
) -> Asked<T> {
    loop {
        let asking = crate::ui::Over::new(picture, |screen: &mut Screen, language: Language| {
            page(screen, TOP);
            screen.text(TOP.0 + 8, TOP.1 + 8, caption.of(language), Color::Black);
            let shown: String = letters.chars().take(28).collect();
            screen.text(TOP.0 + 8, TOP.1 + 24, &shown, Color::Blue);
        });
        let tick = desk.event_asked(&asking, Request::Text).await?;
        if tick.pressed(Key::Esc) {
            return Err(crate::machine::Stop::Cancelled);
        }
        if let Some(found) = found(&tick) {
            return Ok(found);
        }
    }
}

pub(super) async fn ask_parts(
    desk: &mut Desk<'_>,
    studio: &Studio,
    caption: Words,
    proposed: usize,
) -> Asked<usize> {
    let most = i64::try_from(MOST_PARTS).unwrap_or(i64::MAX).min(100);
    desk.meaning(studio, caption, &proposed.to_string(), |text| whole(text, [1, most])).await
}

pub(super) async fn ask_interval(
    desk: &mut Desk<'_>,
    studio: &Studio,
    caption: Words,
    present: &Interval,
) -> Asked<Interval> {
    let proposal = format!("{}, {}", present[0], present[1]);
    desk.meaning(studio, caption, &proposal, |text| {
        let (start, end) = text.split_once(',').ok_or(Phrase::from(texts::TWO_ENDS))?;
        let read = |text: &str| Real::typed(text).map_err(|error| texts::problem(&error));
        let interval = [read(start)?, read(end)?];
        let [start, end] = values(&interval);
        match start < end {
            true => Ok(interval),
            false => Err(texts::problem(&EcError::Interval { start, end })),
        }
    })
    .await
}

/// A number in a range, typed as an expression.
pub(super) fn number(text: &str, [low, high]: [f64; 2]) -> Result<Real, Phrase> {
    let real = Real::typed(text).map_err(|error| texts::problem(&error))?;
    match (low..=high).contains(&real.value()) {
        true => Ok(real),
        false => Err(Phrase::new(format!("{low} és {high} között kell"), format!("{low} to {high}, please"))),
    }
}

/// A whole number in a range.
pub(super) fn whole(text: &str, [low, high]: [i64; 2]) -> Result<usize, Phrase> {
    let number: i64 = text.trim().parse().map_err(|_| Phrase::from(texts::NO_WHOLE))?;
    match (low..=high).contains(&number) {
        true => Ok(usize::try_from(number).unwrap_or(0)),
        false => Err(Phrase::new(format!("{low} és {high} között kell"), format!("{low} to {high}, please"))),
    }
}
