//! Words about figures, pictures of the screen and films.

use super::{Hot, Phrase, Words};
use crate::figure::FigureError;

// Figures and films.
pub(crate) const SVG: Hot = Hot::new('S', "VG", "VG");
pub(crate) const CSM: Hot = Hot::new('C', "SM", "SM");
pub(crate) const CSF: Hot = Hot::new('C', "SF", "SF");
pub(crate) const PNG: Hot = Hot::new('P', "NG", "NG");
pub(crate) const PDF: Hot = Hot::new('D', " - PDF", " - PDF");
pub(crate) const ASK_KIND: Words = Words("      Ábra formátuma ?", "       Figure format?");
pub(crate) const ASK_AXES: Words = Words("   Tengelyek számokkal ?", "     Axes with numbers?");
pub(crate) const WIDTH_ENTRY: Words = Words("Szélesség képpontban:", "Width in pixels:");
pub(crate) const TITLE_ENTRY: Words = Words("Cím (lehet üres):", "Title (may be empty):");
pub(crate) const CAPTION_ENTRY: Words = Words("Képaláírás (lehet üres):", "Caption (may be empty):");

/// A figure has been saved.
pub(crate) fn figure_saved(name: &str) -> Phrase {
    Phrase::new(format!("Ábra: {name}"), format!("Figure: {name}"))
}

/// A figure has been saved, but its axes could not be drawn.
pub(crate) fn figure_saved_without_axes(name: &str) -> Phrase {
    Phrase::new(
        format!("Ábra: {name}, tengelyek nélkül: ily messze az origótól a számaik nem különböznének"),
        format!("Figure: {name}, without axes: so far from the origin their numbers could not be told apart"),
    )
}

/// Why there is no figure.
pub(crate) fn figure_problem(error: &FigureError) -> Phrase {
    match error {
        FigureError::NoArea => Phrase::new(
            "A felületnek nincs területe: vonallá vagy ponttá zsugorodik",
            "The surface has no area: it is no more than a line or a point",
        ),
        other => Phrase::plain(other),
    }
}

/// A picture of the screen has been saved.
pub(crate) fn picture_saved(name: &str) -> Phrase {
    Phrase::new(format!("Kép: {name}"), format!("Picture: {name}"))
}

/// A film begins.
pub(crate) fn film_begun(name: &str) -> Phrase {
    Phrase::new(format!("Film készül: {name}"), format!("Filming: {name}"))
}

/// A film has been saved.
pub(crate) fn film_saved(name: &str) -> Phrase {
    Phrase::new(format!("Film: {name}"), format!("Film: {name}"))
}

/// A film has come to the end of its room, and has been saved.
pub(crate) fn film_full(name: &str) -> Phrase {
    Phrase::new(
        format!("Film: {name}. Automatikusan leállt: legfeljebb 10 perc vagy 64 MB lehet"),
        format!("Film: {name}. It has stopped: the limit is 10 minutes or 64 MB"),
    )
}
