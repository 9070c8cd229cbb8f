//! What CSOMO says, in Hungarian and English.

use super::rail::Stack;
use crate::design::knots::edit::Ends;
use crate::geometry::knots::{KnotError, Pair, Unreached, Way};
use crate::ui::{Hot, Phrase, Words};

pub(super) const THROUGH: Hot = Hot::new('A', "-átmegy", "-target");
pub(super) const PATHS: Hot = Hot::new('P', "álya", "ath");
pub(super) const ENVELOPE: Hot = Hot::new('U', "-burok", "-envel.");
pub(super) const ELEVATE: Hot = Hot::new('F', "okszám", "-raise");

pub(super) const KNOT: Hot = Hot::new('C', "somó", "-knot");
pub(super) const WEIGHT: Hot = Hot::new('S', "úly", "-weight");
pub(super) const OPEN: Hot = Hot::new('N', "yitott", "-open");
pub(super) const CLAMPED: Hot = Hot::new('R', "ögz.", "-clamp");
pub(super) const CLOSED: Hot = Hot::new('Z', "árt", "-loop");
pub(super) const ASK_INSERT: Words = Words("      Mit szúr be ?", "       Insert what?");
pub(super) const ASK_DELETE: Words = Words("      Mit töröl ?", "       Delete what?");
pub(super) const KNOT_ENTRY: Words = Words("Csomó: u", "Knot: u");
pub(super) const VALUE_ENTRY: Words = Words("Értéke:", "Its value:");
pub(super) const WEIGHT_ENTRY: Words = Words("Súly:", "Weight:");
pub(super) const INSERT_ENTRY: Words = Words("Új csomó:", "New knot:");
pub(super) const ORDER_ENTRY: Words = Words("Rend (2-8):", "Order (2-8):");
pub(super) const ASK_REMOVE: Words = Words("    Törli a csomót ?", "    Delete the knot?");

pub(super) const IN_SPACE: Words = Words(
    "A CSOMO síkgörbéket szerkeszt; ez a görbe a térben van.",
    "CSOMO edits curves of the plane; this one is in space.",
);
pub(super) const WRONG_FILE: Words = Words(
    "A CSOMO csomókkal leírt görbét nyit meg: .CSM, .CSF, vagy pontokat: .IP2, .CSV.",
    "CSOMO opens a curve or surface by its knots: .CSM, .CSF, or points: .IP2, .CSV.",
);
pub(super) const SHRUNK: Words = Words(
    "A pontok a mező fölé értek, ezért arányosan kicsinyítve jelennek meg; a görbe köbös.",
    "The points reached above the field, so they are shown reduced in proportion; the curve is cubic.",
);
pub(super) const NO_CURVE: Words = Words("Ehhez több pont kell", "More points are needed");
pub(super) const FOLLOWS: Words = Words("A görbe húzás közben is él", "Live while dragging");
pub(super) const FOLLOWS_NOT: Words = Words("A görbe elengedéskor követ", "Follows when released");
pub(super) const NO_KNOT: Words = Words("Nincs ilyen csomó", "No such knot");
pub(super) const NOT_REACHED: Words = Words("Nem érhető el. O: legközelebb", "Out of reach. O: nearest");

pub(super) const HINT_FIRST: Words = Words(
    "Kattintson a mezőbe: pontok. A görbéhez annyi kell, amennyi a rend.",
    "Click points into the field. A curve needs as many as its order.",
);
pub(super) const HINT_EDIT: Words = Words(
    "Húzzon pontot vagy csomót. P pálya, U burok, A átmegy, Tab másik. F1 súgó",
    "Drag a point or a knot. P paths, U envelope, A through, Tab next. F1 help",
);
pub(super) const HINT_KNOT: Words = Words(
    "A csomó a szomszédainál áll meg, Shift: tovább. Esc: mégsem",
    "The knot stops at its neighbours; Shift: on beyond. Esc: cancel",
);
pub(super) const HINT_POINT: Words = Words(
    "Engedje el, ahol legyen; a mezőn kívül törlődik. Esc: mégsem",
    "Release it where it belongs; outside the field deletes it. Esc: cancel",
);
pub(super) const HINT_MARK: Words =
    Words("Az u paraméter az egérnél. Esc: mégsem", "The parameter u is at the mouse. Esc: cancel");
pub(super) const HINT_TARGET: Words = Words(
    "Kattintson oda, ahol a görbe átmenjen. Esc: vissza",
    "Click where the curve shall pass. Esc: back",
);

pub(super) const WRONG_NET: Words = Words(
    "A felületek lapja csomókkal leírt felületet nyit meg: CSF.",
    "The page of surfaces opens a surface by its knots: CSF.",
);
pub(super) const ROW_ENTRY: Words = Words("Sor (u):", "Row (u):");
pub(super) const COLUMN_ENTRY: Words = Words("Oszlop (v):", "Column (v):");
pub(super) const TARGET: Words = Words("Cél", "Target");
pub(super) const HINT_NET: Words = Words(
    "Húzzon pontot vagy csomót. U burok, A átmegy, Tab másik. F5 görbék",
    "Drag a point or a knot. U envelope, A through, Tab next. F5 curves",
);
pub(super) const HINT_NET_KNOT: Words = Words(
    "A csomó a szomszédainál áll meg; a burok marad. Esc: mégsem",
    "The knot stops at its neighbours; the envelope stays. Esc: cancel",
);

/// The title of the page of surfaces.
pub(super) fn net_title([k, l]: [usize; 2], [rows, columns]: [usize; 2]) -> Phrase {
    Phrase::new(format!("Rend {k} x {l}  {rows} x {columns}"), format!("Order {k} x {l}  {rows} x {columns}"))
}

/// The line under a surface.
pub(super) fn net_status(chosen: Option<(usize, Stack)>, [u, v]: [f64; 2]) -> Phrase {
    let [u, v] = [u, v].map(number);
    let knot = chosen.map_or(String::new(), |(direction, stack)| {
        let (letter, times) = (["u", "v"][direction.min(1)], stack.copies);
        let times = if times > 1 { format!(" x{times}") } else { String::new() };
        format!("{letter}{} = {}{times}   ", stack.first, number(stack.value))
    });
    let text = format!("{knot}(u, v) = ({u}, {v})");
    Phrase::new(text.clone(), text)
}

/// A net has too many points for the picture.
pub(super) fn net_too_large(count: usize, most: usize) -> Phrase {
    Phrase::new(
        format!("A hálónak {count} sora vagy oszlopa van; a kép legfeljebb {most}-et mutat."),
        format!("The net has {count} rows or columns; the picture shows {most} at most."),
    )
}

/// What is missing to a curve.
pub(super) fn more_points(missing: usize, order: usize) -> Phrase {
    Phrase::new(
        format!("Még nincs görbe: {order}-rendűhöz még {missing} pont kell. Kattintson a mezőbe, vagy B."),
        format!(
            "No curve yet: order {order} needs {missing} more point{}. Click in the field, or B.",
            if missing == 1 { "" } else { "s" }
        ),
    )
}

/// The title: order and ends.
pub(super) fn title(order: usize, ends: Ends) -> Phrase {
    let (hungarian, english) = match ends {
        Ends::Open => ("nyitott", "open"),
        Ends::Clamped => ("rögzített", "clamped"),
        Ends::Closed => ("zárt", "closed"),
    };
    Phrase::new(format!("Rend k = {order}  {hungarian}"), format!("Order k = {order}  {english}"))
}

/// A number with as many decimals as are worth reading.
pub(super) fn number(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What is known of the chosen path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PathKind {
    Straight,
    Order(usize),
    /// The arc of `u` does not depend on the knot.
    None,
}

/// The line under the picture.
pub(super) struct Status {
    pub(super) knot: Option<(usize, f64, usize)>,
    pub(super) u: f64,
    pub(super) ratio: Option<f64>,
    pub(super) path: PathKind,
    pub(super) inflections: usize,
    /// Those of the curve at the start, while both are compared.
    pub(super) before: Option<usize>,
}

impl Status {
    pub(super) fn phrase(&self) -> Phrase {
        let knot = self.knot.map_or(String::new(), |(index, value, copies)| {
            let times = if copies > 1 { format!(" x{copies}") } else { String::new() };
            format!("u{index} = {}{times}   ", number(value))
        });
        let ratio = self.ratio.map_or(String::from("-"), |ratio| format!("{ratio:.3}"));
        let (straight, order) = match self.path {
            PathKind::Straight => ("egyenes".to_owned(), "straight".to_owned()),
            PathKind::Order(order) => (format!("{order}-rendű"), format!("order {order}")),
            PathKind::None => ("-".to_owned(), "-".to_owned()),
        };
        let before = self.before.map_or(String::new(), |count| format!(" ({count})"));
        let (u, count) = (number(self.u), self.inflections);
        Phrase::new(
            format!("{knot}u = {u}   kb/ks = {ratio}   pálya: {straight}   inflexió {count}{before}"),
            format!("{knot}u = {u}   kb/ks = {ratio}   path: {order}   inflections {count}{before}"),
        )
    }
}

/// How far the curve would move without a knot.
pub(super) fn would_move(knot: usize, by: f64) -> Phrase {
    let by = number(by);
    Phrase::new(
        format!("Az u{knot} csomó nélkül a görbe legfeljebb {by} képpontot mozdul."),
        format!("Without knot u{knot} the curve moves by at most {by} pixels."),
    )
}

/// How a curve goes through the target, and which of the solutions it is.
pub(super) fn solution(way: Way, at: usize, count: usize, effort: f64) -> Phrase {
    let (hungarian, english) = match way {
        Way::Outer(span) => (format!("{span}. ív szélső csomói"), format!("outer knots of span {span}")),
        Way::Pair(knot, pair) => {
            let (hungarian, english) = pair_names(pair);
            (format!("u{knot} és a {hungarian} pár"), format!("u{knot}, {english} pair"))
        }
        Way::Knot(knot) => (format!("egyetlen csomó, u{knot}"), format!("one knot, u{knot}")),
    };
    let effort = number(effort);
    Phrase::new(
        format!("{at}/{count}: {hungarian} ({effort}). Enter: kell, Bal Jobb: másik, Esc"),
        format!("{at}/{count}: {english} ({effort}). Enter takes, Left Right others, Esc"),
    )
}

fn pair_names(pair: Pair) -> (&'static str, &'static str) {
    match pair {
        Pair::Outer => ("külső", "outer"),
        Pair::Left => ("bal", "left"),
        Pair::Right => ("jobb", "right"),
        Pair::LeftCross => ("bal kereszt", "left-cross"),
        Pair::RightCross => ("jobb kereszt", "right-cross"),
        Pair::Inner => ("belső", "inner"),
    }
}

/// A point of an opened file lies outside the field.
pub(super) fn outside(number: usize, [x, y]: [f64; 2]) -> Phrase {
    let (x, y) = (self::number(x), self::number(y));
    Phrase::new(
        format!(
            "A {number}. pont ({x}; {y}) az 560 x 260-as mezőn kívül van: V, P, H mozdítja, \
             vagy így marad."
        ),
        format!("Point {number} ({x}; {y}) lies outside the field of 560 x 260; V, P, H brings it in."),
    )
}

/// Why something cannot be done.
pub(super) fn refusal(error: &KnotError) -> Phrase {
    match *error {
        KnotError::OrderNeeded { given, least, most } if least == most => Phrase::new(
            format!("A görbe {given}-rendű; ez {least}-rendű görbékhez való."),
            format!("The curve has order {given}; this is for order {least}."),
        ),
        KnotError::OrderNeeded { given, least, most } => Phrase::new(
            format!("A görbe {given}-rendű; ez {least}-től {most}-rendig lehetséges."),
            format!("The curve has order {given}; this is for orders {least} to {most}."),
        ),
        KnotError::Rational => Words(
            "A görbének súlyai vannak; ez súlyok nélküli görbékhez való.",
            "The curve has weights; this is for curves without weights.",
        )
        .into(),
        KnotError::Closed => Words(
            "A görbe zárt; ez nyitott görbékhez való (G).",
            "The curve is closed; this is for open curves (G).",
        )
        .into(),
        KnotError::TooMultiple { most, .. } => Phrase::new(
            format!("Itt legfeljebb {most} egyenlő csomó lehet."),
            format!("There may be {most} equal knots here at most."),
        ),
        KnotError::Outside { value, range: [from, to], .. } => {
            let [value, from, to] = [value, from, to].map(number);
            Phrase::new(
                format!("{value} kívül esik; {from} és {to} között lehet."),
                format!("{value} is outside; it must be between {from} and {to}."),
            )
        }
        KnotError::NoEnvelope { order, multiplicity } => Phrase::new(
            format!("{order}-rendű görbének {multiplicity}-szeres csomóhoz nincs burkolója."),
            format!("A curve of order {order} has no envelope for a knot of multiplicity {multiplicity}."),
        ),
        KnotError::Index { first, last, .. } if first <= last => Phrase::new(
            format!("Ez a csomó itt nem jó; {first} és {last} között kell lennie."),
            format!("That knot does not do here; it must be {first} to {last}."),
        ),
        KnotError::Index { .. } => {
            Words("Ehhez a görbe túl rövid.", "The curve is too short for this.").into()
        }
        KnotError::NoSpan => NO_CURVE.into(),
        KnotError::Unreached(Unreached::NotFound) => {
            Words("Ez a hely nem érhető el a csomókkal.", "Knots do not reach this place.").into()
        }
        ref other => Phrase::plain(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Language, Pointing};
    use crate::ui::{HINT_LINES, Hint};

    #[test]
    fn hints_fit_their_page() {
        let texts =
            [HINT_FIRST, HINT_EDIT, HINT_KNOT, HINT_POINT, HINT_MARK, HINT_TARGET, HINT_NET, HINT_NET_KNOT]
                .map(Phrase::from);
        let more = [more_points(8, 8), more_points(1, 2)];
        let found = solution(Way::Pair(12, Pair::RightCross), 10, 99, 0.123);
        for text in texts.iter().chain(&more).chain([&found]) {
            for language in [Language::Hungarian, Language::English] {
                let lines = Hint::new(text.clone()).lines(language, Pointing::Mouse);
                assert!(lines.len() <= HINT_LINES, "{lines:?}");
            }
        }
    }

    #[test]
    fn numbers_have_the_decimals_worth_reading() {
        let texts = [5.35, 4.0, 0.0, -1.25, 1e-9, 123456789.0].map(number);
        assert_eq!(texts, ["5.35", "4", "0", "-1.25", "1.000e-9", "1.235e8"]);
    }
}
