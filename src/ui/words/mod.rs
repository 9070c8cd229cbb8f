//! Every text that the user sees, in Hungarian and English. The hot letters are the same in both, so
//! that scripts and habits work in either language.

pub use super::phrase::{Hot, Phrase, Words};
use crate::file::{FileError, Format};
use crate::machine::Language;
use std::borrow::Cow;
use std::time::Duration;

mod curves;
mod figures;
mod help;
mod hints;
mod surfaces;

pub(crate) use curves::*;
pub(crate) use figures::*;
pub(crate) use help::*;
pub(crate) use hints::*;
pub(crate) use surfaces::*;

// Answers.
pub(crate) const YES: Hot = Hot::new('I', "gen", "-yes");
pub(crate) const NO: Hot = Hot::new('N', "em", "-no");
pub(crate) const NEW: Hot = Hot::new('U', "j", "-new");
pub(crate) const STORED: Hot = Hot::new('T', "árolt", "-open");
pub(crate) const OPEN: Hot = Hot::new('N', "yitott", "-open");
pub(crate) const CLOSED: Hot = Hot::new('Z', "árt", "-loop");
pub(crate) const NUMBER: Hot = Hot::new('S', "orszám", "-no.");
pub(crate) const PLACE: Hot = Hot::new('H', "ely", "-place");
pub(crate) const TWO: Hot = Hot::new('2', "", "");
pub(crate) const THREE: Hot = Hot::new('3', "", "");

// Command buttons of the curve programs.
pub(crate) const CHANGE: Hot = Hot::new('V', "álaszt", "-change");
pub(crate) const QUIT: Hot = Hot::new('Q', "-kilép", "-quit");
pub(crate) const RESULT: Hot = Hot::new('E', "redmény", "-result");
pub(crate) const INSERT: Hot = Hot::new('B', "eszúr", "-insert");
pub(crate) const DELETE: Hot = Hot::new('T', "öröl", "-delete");
pub(crate) const CURVE: Hot = Hot::new('G', "örbe", "-curve");

// Method buttons.
pub(crate) const COONS: Hot = Hot::new('1', " Coons", " Coons");
pub(crate) const BEZIER: Hot = Hot::new('2', " Bézier", " Bézier");
pub(crate) const SPLINE: Hot = Hot::new('3', " Spline", " Spline");
pub(crate) const ARCS: Hot = Hot::new('5', " Ívek", " Arcs");
pub(crate) const B_SPLINE: Hot = Hot::new('4', " B-spl.", " B-spl.");

// Questions. The blanks centre them as in the original.
/// The question whether to end.
pub const ASK_END: Words = Words("      Vége a munkának ?", "           Quit?");
pub(crate) const ASK_NEW: Words = Words("     Uj konfiguráció ?", "   Start or open another?");
pub(crate) const ASK_SAVE: Words = Words(" Menteni a konfigurációt ?", "      Save your work?");
pub(crate) const ASK_CONFIGURATION: Words = Words("       Konfiguráció ?", "        New or open?");
pub(crate) const ASK_SHAPE: Words = Words("       Görbe alakja ?", "    Shape of the curve?");
pub(crate) const ASK_DEGREE: Words = Words("      Polinomok foka ?", "          Degree?");
pub(crate) const ASK_CHANGE: Words = Words("      Mi változik ?", "        Change what?");
pub(crate) const ASK_POINTS: Words = Words(" Kontrollpontok látszanak ?", "    Show control points?");
pub(crate) const FILE_NAME: Words = Words("File neve ?", "File name?");
/// A name that no file has.
pub const NO_SUCH_FILE: Words = Words("Nincs ilyen file", "No such file");

// The help page's tables of operations.
pub(crate) const LESSON_AXES: Words = Words("képernyő le, kép jobbra", "screen down, image right");
pub(crate) const LESSON_MASKS: Words =
    Words("AND     XOR     c = 0...15 a képernyőn", "AND     XOR     c = 0...15 on the screen");
pub(crate) const LESSON_BLACK: Words = Words("fekete (0)", "black (0)");
pub(crate) const LESSON_WHITE: Words = Words("fehér (15)", "white (15)");
pub(crate) const LESSON_KEPT: Words = Words("marad (c)", "kept (c)");
pub(crate) const LESSON_INVERSE: Words = Words("ellentett (15-c)", "inverse (15-c)");

// Entries.
pub(crate) const NUMBER_ENTRY: Words = Words("Sorszám:", "Number:");
pub(crate) const PLACE_ENTRY: Words = Words("Hely:", "Place:");
pub(crate) const COEFFICIENT: Words = Words("együttható = ", "coefficient =");

// The plane editor.
pub(crate) const STORE: Words = Words("Tár", "Points");
pub(crate) const METHOD_TITLE: Words = Words("Interpolációs eljárás", "Interpolation method");
pub(crate) const BACK: Words = Words("ESC - vissza", "ESC - back");
pub(crate) const NO_DOT: Words = Words(
    "A névben nem lehet pont: legfeljebb 8 betű, szám vagy -",
    "No dot in a name: up to 8 letters, digits or -",
);

// Short messages of the plane editor: 28 letters fit on the communication page.
pub(crate) const FULL: Words = Words("Több pont nem fér el (99)", "No more than 99 points");
pub(crate) const NO_POINTS: Words = Words("Nincs még pont", "No points yet");
pub(crate) const TOO_FEW: Words = Words("Legalább 3 pont kell", "At least 3 points are needed");
pub(crate) const NO_CURVE: Words = Words("Előbb rajzoljon görbét (G)", "Draw a curve first (G)");
/// There is nothing to undo.
pub const NO_UNDO: Words = Words("Nincs mit visszavonni", "Nothing to undo");
/// There is nothing to redo.
pub const NO_REDO: Words = Words("Nincs mit újra elvégezni", "Nothing to redo");
pub(crate) const FOLLOWS: Words = Words("A görbe követi a pontokat", "The curve follows the points");
pub(crate) const FOLLOWS_NOT: Words = Words("Csak húzáskor követ", "Follows only while dragging");
pub(crate) const ENTER_ONLY: Words = Words("Enter", "Enter");
pub(crate) const WRONG_CONTENT: Words = Words(
    "Ebben a fájlban nem síkbeli kontrollpontok vannak",
    "This file holds no control points in the plane",
);

/// There is no point of a number; `count` is the largest.
pub(crate) fn no_such_point(count: usize) -> Phrase {
    Phrase::new(format!("Nincs ilyen pont: 1...{count}"), format!("No such point: 1...{count}"))
}

/// A point of a file, counted from 1, lies outside the field.
pub(crate) fn outside_field(number: usize, [x, y]: [f64; 2]) -> Phrase {
    let field = "x = 0...560, y = 0...380";
    Phrase::new(
        format!("{number}. pont ({x}; {y}) a mezőn kívül van; a mező {field}"),
        format!("Point {number} ({x}; {y}) lies outside the field: {field}"),
    )
}

/// A file has more points than the editor can hold.
pub(crate) fn too_many_points(count: usize) -> Phrase {
    Phrase::new(
        format!("{count} pont; legfeljebb 99 lehet"),
        format!("{count} points; at most 99 are possible"),
    )
}

/// What a DOS format cannot hold, and which file can.
pub(crate) fn not_held(format: Format, lost: &[String], json: &str) -> Phrase {
    let english = lost.join(", ");
    let hungarian: Vec<&str> = lost.iter().map(|name| setting(name)).collect();
    let hungarian = hungarian.join(", ");
    Phrase::new(
        format!("{format} nem tárolja: {hungarian}. {json} tárolná."),
        format!("{format} cannot hold: {english}. {json} would."),
    )
}

/// What a setting of a document is called in Hungarian.
fn setting(name: &str) -> &str {
    match name {
        "method" => "eljárás",
        "closed" => "zárt",
        "bias" => "eltolás",
        "tension" => "feszültség",
        "extended" => "perem",
        "joint" => "csatlakozás",
        "ratio" => "arány",
        "free_poles" => "szabad pólusok",
        "inner" => "segédpontok a peremen",
        "joints" => "csatlakozások",
        "tangents" => "érintők",
        "points" => "pontok",
        other => other,
    }
}

/// The caption of an entry for a number of a panel.
pub(crate) const NEW_NUMBER: Words = Words("Új szám:", "New number:");
/// A number lies outside of what it may be.
pub(crate) fn out_of(range: &std::ops::RangeInclusive<f64>) -> Phrase {
    let range = format!("{}...{}", range.start(), range.end());
    Phrase::new(format!("Megengedett: {range}"), format!("Allowed: {range}"))
}
/// Whether a JSON file shall be written too.
pub(crate) const ASK_JSON: Words = Words("JSON is mellé?", "Save JSON as well?");

/// Whether a file that exists shall be overwritten.
pub fn exists(name: &str) -> Phrase {
    Phrase::new(format!("{name} létezik. Ráírni?"), format!("{name} exists. Overwrite?"))
}

pub(crate) const ASK_OVERWRITE: Words = Words("          Ráírni ?", "         Overwrite?");

/// A file that exists is not what the program has read or written.
pub(crate) fn changed(name: &str) -> Phrase {
    Phrase::new(
        format!("{name} időközben megváltozott: más is írta, mióta ez a program olvasta vagy mentette."),
        format!("{name} has changed: something else has written it since this program read or saved it."),
    )
}

// Work of a session that ended unexpectedly.
pub(crate) const ASK_TAKE_UP: Words = Words("     Visszaállítja ?", "        Restore it?");
pub(crate) const ASK_GIVE_UP: Words = Words("     Biztosan törli ?", "     Really delete it?");
pub(crate) const GIVING_UP: Words = Words(
    "A mentetlen munka törlése végleges. Nem vagy Esc: a következő indításkor újra kérdezi.",
    "Deleting the unsaved work is final. No or Esc: you are asked again at the next start.",
);

/// There is unsaved work of a program, from a file if it is known, kept so long ago if that is known.
pub(crate) fn broke_off(program: &str, file: Option<&str>, age: Option<Duration>) -> Phrase {
    let program = program.to_uppercase();
    let (hungarian_age, english_age) = age.map_or_else(Default::default, ago);
    let file = file.map_or((Cow::from("még nincs fájlban"), Cow::from("not yet in a file")), |file| {
        (file.to_string().into(), file.to_string().into())
    });
    Phrase::new(
        format!("A {program} váratlanul ért véget{hungarian_age}; a mentetlen munka megvan ({}).", file.0),
        format!("{program} ended unexpectedly{english_age}; your unsaved work was kept ({}).", file.1),
    )
}

/// How long ago something was, behind a sentence.
fn ago(age: Duration) -> (String, String) {
    let minutes = age.as_secs() / 60;
    let (count, hungarian, english) = match minutes {
        0 => return (" az imént".to_string(), " a moment ago".to_string()),
        1..60 => (minutes, "perce", "minute"),
        60..1440 => (minutes / 60, "órája", "hour"),
        _ => (minutes / 1440, "napja", "day"),
    };
    let plural = if count == 1 { "" } else { "s" };
    (format!(" {count} {hungarian}"), format!(" {count} {english}{plural} ago"))
}

/// Files of unsaved work that cannot be read were set aside: the name of one, what is wrong with it, and how
/// many more there are.
pub(crate) fn broken_work(name: &str, problem: &Phrase, more: usize) -> Phrase {
    let [hungarian, english] = [Language::Hungarian, Language::English].map(|language| problem.of(language));
    let (others, and_others) = match more {
        0 => Default::default(),
        more => (format!(" És még {more}."), format!(" And {more} more.")),
    };
    Phrase::new(
        format!("Sérült mentetlen munka, .broken végződéssel félretéve: {name}: {hungarian}.{others}"),
        format!("Damaged unsaved work was set aside as .broken: {name}: {english}.{and_others}"),
    )
}

/// Unsaved work cannot be kept against a crash.
pub(crate) fn not_kept(problem: &str) -> Phrase {
    Phrase::new(
        format!("A mentetlen munka összeomlás ellen most nem védett: {problem}"),
        format!("Unsaved work is not protected from a crash now: {problem}"),
    )
}

/// What is wrong in a data file.
pub(crate) fn in_file(name: &str, error: &FileError) -> Phrase {
    Phrase::plain(&format!("{name}: {error}"))
}

// The page of files.
pub(crate) const CHOOSE_FILE: Words =
    Words("Megnyitás: nyilak, Enter, egér vagy a név", "Open: arrows, Enter, mouse, or type the name");
pub(crate) const NO_FITTING_FILE: Words = Words("Nincs ilyen nevű fájl", "No file of such a name");

/// A coordinate in the line under the picture.
fn in_line(value: f64) -> String {
    // Adding zero makes a negative zero positive.
    if value.abs() < 1e6 { format!("{:3.0}", value.round() + 0.0) } else { format!("{value:.2e}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Pointing;
    use crate::ui::{HINT_LINES, Hint};

    const LANGUAGES: [Language; 2] = [Language::Hungarian, Language::English];

    #[test]
    fn answers_lie_inside_their_windows() {
        // The window on the left is 64 pixels wide, that on the right 60; an answer begins 5 pixels inside.
        let left = [YES, NEW, OPEN, NUMBER, POINT, LENGTH, POLYGON, WIRE, ALONG_U, TWO];
        let right = [
            NO,
            STORED,
            CLOSED,
            PLACE,
            TANGENT,
            ANGLE,
            SPLINE_SHAPE,
            FILLED,
            ALONG_V,
            THREE,
            TWIST,
            TANGENT_U,
            TANGENT_V,
        ];
        for (answers, room) in [(left.as_slice(), 64), (right.as_slice(), 60)] {
            for (answer, language) in answers.iter().flat_map(|answer| LANGUAGES.map(|it| (answer, it))) {
                assert!(5 + answer.width(language) <= room, "{}{}", answer.letter, answer.rest.of(language));
            }
        }
    }

    #[test]
    fn hints_lie_on_the_communication_page() {
        let hints = [
            HINT_FIRST,
            HINT_MORE,
            HINT_MORE_3D,
            HINT_CURVE,
            HINT_ARCS,
            HINT_EDIT,
            HINT_EDIT_BETA,
            HINT_EDIT_3D,
            HINT_EDIT_BETA_3D,
            HINT_TANGENTS,
            HINT_HELD,
            HINT_HELD_3D,
            HINT_TIP,
            HINT_NET,
            HINT_SURFACE,
            HINT_NORMALS,
            KEYS_NORMALS,
            HINT_HEIGHTS,
            HINT_COEFFICIENTS,
            HINT_CURSOR,
            KEYS_FIRST,
            KEYS_MORE,
            KEYS_EDIT,
            KEYS_EDIT_CURVE,
            KEYS_EDIT_3D,
            KEYS_EDIT_CURVE_3D,
            KEYS_HELD,
            KEYS_NET,
            KEYS_SURFACE,
            KEYS_HEIGHTS,
            KEYS_COEFFICIENTS,
        ];
        for (hint, language) in hints.iter().flat_map(|hint| LANGUAGES.map(|it| (hint, it))) {
            let lines = Hint::new(*hint).lines(language, Pointing::Mouse);
            assert!(lines.len() <= HINT_LINES, "{lines:?}");
        }
        // The number itself takes the first line.
        for (hint, language) in
            [HINT_COEFFICIENT, HINT_TYPING].iter().flat_map(|hint| LANGUAGES.map(|it| (hint, it)))
        {
            let lines = Hint::new(*hint).lines(language, Pointing::Mouse);
            assert!(lines.len() < HINT_LINES, "{lines:?}");
        }
    }

    #[test]
    fn questions_and_short_messages_lie_inside_their_pages() {
        let questions = [
            ASK_END,
            ASK_NEW,
            ASK_SAVE,
            ASK_CONFIGURATION,
            ASK_SHAPE,
            ASK_DEGREE,
            ASK_CHANGE,
            ASK_POINTS,
            ASK_KIND,
            ASK_AXES,
            ASK_JSON,
            ASK_OVERWRITE,
            ASK_TAKE_UP,
            ASK_GIVE_UP,
            ASK_AUTOMATIC,
            ASK_DISPLAY,
            ASK_DIRECTION,
            ASK_AXIS,
            ASK_FIT_SHAPE,
            WIDTH_ENTRY,
            TITLE_ENTRY,
            CAPTION_ENTRY,
        ];
        let messages = [
            NO_SUCH_FILE,
            FULL,
            NO_POINTS,
            TOO_FEW,
            NO_CURVE,
            ONLY_ARCS,
            NO_JOINT,
            NO_UNDO,
            NO_REDO,
            FOLLOWS,
            FOLLOWS_NOT,
            TAKE_OVER,
            NO_SURFACE,
            SURFACE_FOLLOWS,
            SURFACE_FOLLOWS_NOT,
            BORDER_REACHED,
            BORDER_DOUBLED,
            JOINTS_ALIKE,
        ];
        for text in questions.iter().chain(&messages).flat_map(|words| LANGUAGES.map(|it| words.of(it))) {
            assert!(text.chars().count() <= 28, "{text}");
        }
    }
}
