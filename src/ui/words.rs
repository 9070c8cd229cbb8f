//! Every text that the user sees, in Hungarian and English. The hot letters are the same in both, so
//! that scripts and habits work in either language.

pub use super::phrase::{Hot, Phrase, Words};
use crate::figure::FigureError;
use crate::file::{FileError, Format};
use crate::geometry::{Border, GeometryError, Residuals};
use crate::machine::{Language, StorageError};
use std::borrow::Cow;
use std::time::Duration;

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

// The help page.
pub(crate) const HELP_SETTINGS: Words = Words("beállítások", "settings");
pub(crate) const HELP_FIGURE: Words = Words("ábra mentése: SVG, PNG, PDF", "save a figure: SVG, PNG, PDF");
pub(crate) const HELP_FILM: Words = Words("film (GIF) indítása, leállítása", "film (GIF): start, stop");
pub(crate) const HELP_UNDO: Words = Words("visszavonás, újra", "undo, redo");
// The settings page.
pub(crate) const SETTINGS: Words = Words("Minden program beállításai", "Settings for all programs");
pub(crate) const SETTINGS_KEYS: Words =
    Words("Fel Le: sor   Bal Jobb: érték   Esc: vissza", "Up Down: row   Left Right: value   Esc: back");
pub(crate) const SETTINGS_CLOSE: Words = Words("Vissza", "Back");
pub(crate) const FOLDER_ENTRY: Words = Words("Mappa:", "Folder:");

pub(crate) const HELP_HELP: Words = Words("ez a lap", "this page");
pub(crate) const HELP_LANGUAGE: Words = Words("nyelv: magyar, angol", "language: Hungarian, English");
pub(crate) const HELP_WINDOW_LOOK: Words =
    Words("teljes képernyő; az ablak képe: éles, kitöltő, képcső", "full screen; look: sharp, filling, CRT");
pub(crate) const HELP_PICTURE: Words = Words("a képernyő mentése PNG-be", "save the screen as PNG");
pub(crate) const HELP_ESC: Words = Words("kérdés, beírás megszakítása", "cancel a question or an entry");
pub(crate) const HELP_LEAVE: Words = Words("Vissza: bármely billentyű", "Any key: back");
pub(crate) const HELP_TURN: Words =
    Words("Tovább: bármely billentyű   Vissza: Esc", "Any key: next page   Esc: back");
pub(crate) const HELP_POINTER: Words =
    Words("Az egér billentyűkkel, a terminálban:", "The mouse by keys, in the terminal:");

/// What is wrong with a stored file.
pub(crate) fn storage_problem(error: &StorageError) -> Phrase {
    Phrase::plain(error)
}

// The plane editor's help.
pub(crate) const HELP_DRAG: Words = Words(
    "pont húzása; új a Tárból; ki a mezőről: törlés",
    "drag a point (new: Points); off the field to delete",
);
pub(crate) const HELP_INSERT: Words = Words("pont beszúrása: sorszám, hely", "insert a point: number, place");
pub(crate) const HELP_CHANGE: Words =
    Words("pont változtatása: sorszám vagy hely", "change a point: number or place");
pub(crate) const HELP_DELETE: Words = Words("pont törlése: sorszám", "delete a point: number");
pub(crate) const HELP_DELETE_HERE: Words =
    Words("az egér alatti pont törlése", "delete the point under the mouse");
pub(crate) const HELP_CLICK: Words =
    Words("a mezőn: új pont; a görbén: pont oda", "on the field: new point; on the curve: one there");
pub(crate) const HELP_CLICK_3D: Words =
    Words("a görbén: pont oda; máshol húzva: forgat", "on the curve: a point there; elsewhere, drag: turn");
pub(crate) const HELP_CURVE: Words = Words(
    "görbe: nyitott, zárt, eljárás; S: ív sima, sarok",
    "open or closed, method; S: arcs smooth, corner",
);
pub(crate) const HELP_RESULT: Words =
    Words("eredmény: a görbe keret nélkül", "result: the curve alone, without the frame");
pub(crate) const HELP_QUIT: Words =
    Words("mentés, kilépés, új konfiguráció", "save, quit, start or open another");
pub(crate) const HELP_AIDS: Words =
    Words("poligon és burok, súlyok, csatlakozások", "polygon and hull, weights, joints and comb");
pub(crate) const HELP_PICK: Words =
    Words("pont kiválasztása; a nyilak mozgatják", "choose a point; the arrows move it");
pub(crate) const HELP_PICK_3D: Words =
    Words("pont; a nyilak mozgatják, tengely mentén is", "a point; arrows move it, also along an axis");
pub(crate) const HELP_AXIS: Words =
    Words("húzás közben: csak a tengely mentén", "while dragging: along that axis only");
pub(crate) const HELP_DIAL: Words =
    Words("az értékek élőben; görgő az értéken is", "values live; also the wheel over a value");
pub(crate) const POLYGON_SHOWN: Words = Words("Karakterisztikus poligon", "Characteristic polygon");
pub(crate) const HULL_SHOWN: Words = Words("Poligon és konvex burka", "Polygon and its convex hull");
pub(crate) const POLYGON_HIDDEN: Words = Words("Poligon nélkül", "Without the polygon");
pub(crate) const WEIGHTS_SHOWN: Words =
    Words("Súlyok; az egér alatti ponté a görbén", "Weights; along the curve that of the point at the mouse");
pub(crate) const WEIGHTS_HIDDEN: Words = Words("Súlyok nélkül", "Without weights");
pub(crate) const NO_WEIGHTS: Words = Words(
    "Itt nincsenek súlyok: a görbe nem lineáris a pontokban",
    "No weights here: this curve is not linear in its points",
);
pub(crate) const JOINTS_SHOWN: Words =
    Words("Szakaszok száma és csatlakozásuk", "Numbers of the spans, and how they join");
pub(crate) const COMB_SHOWN: Words = Words("Görbületi fésű", "Comb of curvature");
pub(crate) const JOINTS_HIDDEN: Words = Words("Csatlakozások és fésű nélkül", "Without joints and comb");
pub(crate) const HELP_FOLLOW: Words = Words(
    "a görbe változtatás után is követi a pontokat: be, ki",
    "the curve stays and follows every change: on, off",
);
pub(crate) const HELP_SERIES: Words =
    Words("egy paraméter több értéke együtt", "several values of a parameter together");
pub(crate) const ASK_SERIES: Words = Words("Melyik paraméter?", "Which parameter?");
pub(crate) const BIAS_ANSWER: Hot = Hot::new('A', " elt.", " bias");
pub(crate) const TENSION_ANSWER: Hot = Hot::new('C', " fesz", " tens");
pub(crate) const HELP_COMPARE: Words =
    Words("több eljárás görbéje együtt, színekkel", "compare methods: several curves, in colours");
pub(crate) const HELP_SAVE: Words = Words("mentés", "save");

/// Asks for values of a parameter.
pub(crate) fn series_of(name: Words) -> Phrase {
    let Words(hungarian, english) = name;
    Phrase::new(format!("{hungarian}, pl. 0.5 1 2:"), format!("{english}, e.g. 0.5 1 2:"))
}
pub(crate) fn wrong_value(word: &str, low: f64, high: f64) -> Phrase {
    Phrase::new(
        format!("\"{word}\" nem {low} és {high} közötti szám"),
        format!("\"{word}\" is no number from {low} to {high}"),
    )
}
pub(crate) fn too_many_values(count: usize, most: usize) -> Phrase {
    Phrase::new(
        format!("{count} érték túl sok: legfeljebb {most}"),
        format!("{count} values are too many: {most} at most"),
    )
}

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

// Beta-splines and their joints.
pub(crate) const HELP_SHAPE: Words =
    Words("eltolás, feszültség az egész görbén", "bias, tension of the whole curve");
pub(crate) const HELP_CURVE_FORM: Words = Words("görbe: nyitott vagy zárt", "draw a curve: open or closed");
pub(crate) const HELP_JOINTS: Words =
    Words("egy csatlakozás eltolása, feszültsége (2.68)", "bias, tension of one joint (2.68)");
pub(crate) const HELP_JOINTS_OFF: Words =
    Words("minden csatlakozás újra egyforma", "make all joints alike again");
pub(crate) const JOINT_ENTRY: Words = Words("Csatl.:", "Joint:");
pub(crate) const JOINT_BIAS: Words = Words("elt.=", "bias=");
pub(crate) const JOINT_TENSION: Words = Words("fesz.=", "tens.=");
pub(crate) const JOINTS_ALIKE: Words = Words("Minden csatlakozás egyforma", "All joints are alike");

// Tangents.
pub(crate) const POINT: Hot = Hot::new('P', "ont", "-oint");
pub(crate) const TANGENT: Hot = Hot::new('E', "rintő", "-tang.");
pub(crate) const LENGTH: Hot = Hot::new('H', "ossz", "-len.");
pub(crate) const ANGLE: Hot = Hot::new('S', "zög", "-angle");
// The accented capitals of the ROM font are hard to read; the original draws commas over plain ones.
pub(crate) const COONS_TITLE: Words = Words("COONS INTERPOLACIO", "COONS INTERPOLATION");
pub(crate) const COONS_ACCENTS: Words = Words(",  ,", "");
pub(crate) const ASK_AUTOMATIC: Words = Words(" Önműködő érintőszámítás ?", "    Automatic tangents?");
pub(crate) const TANGENT_LENGTH: Words = Words("Érintő hossza", "Tangent length");
pub(crate) const TANGENT_ANGLE: Words = Words("Érintő iránya", "Tangent angle");
pub(crate) const NEW_VALUE: Words = Words("új:", "new:");
pub(crate) const NO_TANGENTS: Words = Words(
    "Nincs hozzá .EC2: az érintőket a szomszédos pontok adják, k0 = 0.5",
    "There is no .EC2 file: tangents are computed from the neighbouring points, k0 = 0.5",
);
pub(crate) const HELP_CHANGE_TANGENT: Words =
    Words("változtatás: pont vagy érintő (hossz, szög)", "change: point or tangent (length, angle)");
pub(crate) const HELP_DRAG_TANGENT: Words =
    Words("pont vagy érintő húzása", "drag a point or the tip of a tangent");

/// The value of a number before it is changed.
pub(crate) fn now_it_is(number: f64) -> Phrase {
    Phrase::new(format!("most: {number}"), format!("now: {number}"))
}

// Beta-splines.
pub(crate) const BIAS_BUTTON: Hot = Hot::new('A', " - elt.", " - bias");
pub(crate) const TENSION_BUTTON: Hot = Hot::new('C', " - fesz", " - tens");
pub(crate) const BIAS_ENTRY: Words = Words("Eltolás:", "Bias:");
pub(crate) const TENSION_ENTRY: Words = Words("Feszültség:", "Tension:");
pub(crate) const BIAS_NAME: Words = Words("Eltolás", "Bias");
pub(crate) const TENSION_NAME: Words = Words("Feszültség", "Tension");
pub(crate) const K0_NAME: Words = Words("k0", "k0");
pub(crate) const BIAS_VALUE: Words = Words("Eltolás = ", "Bias = ");
pub(crate) const TENSION_VALUE: Words = Words("Feszültség = ", "Tension = ");

/// Why there is no curve.
pub(crate) fn no_curve(error: &GeometryError) -> Phrase {
    let GeometryError::CriticalTension { bias, critical, .. } = error else { return Phrase::plain(error) };
    let number = |value: &f64| format!("{value:.4}").trim_end_matches('0').trim_end_matches('.').to_string();
    let (bias, critical) = (number(bias), number(critical));
    Phrase::new(
        format!(
            "{bias} eltolásnál a {critical} feszültség kritikus: a görbe pontjai a végtelenbe mennek. Más feszültség kell: C"
        ),
        format!(
            "With bias {bias} the tension {critical} is critical: the points of the curve go to infinity. Choose another tension (C)"
        ),
    )
}

// The space editor.
pub(crate) const PLACE_3D: Words = Words("Hely", "Place");
pub(crate) const LEAVE: Words = Words("ESC - kilép", "ESC - back");
pub(crate) const ESC_ENDS: Words = Words("ESC - kilép", "ESC - quit");
pub(crate) const HELP_DRAG_3D: Words =
    Words("pont húzása a kép síkjában", "drag a point in the plane of the picture");
pub(crate) const HELP_TURN_DRAG: Words = Words("forgatás húzással", "drag to turn");
pub(crate) const HELP_TURN_KEYS: Words = Words("forgatás 3 fokkal", "turn by 3 degrees");
pub(crate) const HELP_ZOOM: Words = Words("nagyítás, kicsinyítés", "zoom in, out");
pub(crate) const HELP_HOME: Words = Words("az eredeti nézet", "back to the first view");
pub(crate) const HELP_SIGHT: Words =
    Words("vetítés: párhuzamos, középpontos", "projection: parallel, central");
pub(crate) const NOT_IN_SPACE: Words =
    Words("Ebben a fájlban nem térbeli kontrollpontok vannak", "This file holds no control points in space");
pub(crate) const OUTSIDE_SPACE: Words =
    Words("99-nél több pont vagy túl nagy koordináta", "More than 99 points, or too large a coordinate");

/// The line under the picture: the place of a point, counted from 1.
pub(crate) fn place_of(number: usize, place: [f64; 3]) -> Phrase {
    let [x, y, z] = place.map(in_line);
    let line = |number_word: &str, place_word: &str| {
        format!("{number_word}: {number}   {place_word}: x = {x}   y = {y}   z = {z}")
    };
    Phrase::new(line("Sorszám", "Hely"), line("Number", "Place"))
}

// The Fourier editor.
pub(crate) const COEFFICIENT_NAME: Words = Words("Együttható:", "Coeff.:");
pub(crate) const LETTER: Words = Words("név", "name");
pub(crate) const DIGITS: Words = Words("szám", "no.");
pub(crate) const HARMONICS_ENTRY: Words = Words("harmonikusok:", "harmonics:");
pub(crate) const ASK_FIT_SHAPE: Words = Words("Mit közelítsen ?", "Fit to what?");
pub(crate) const POLYGON: Hot = Hot::new('P', "oligon", "olygon");
pub(crate) const SPLINE_SHAPE: Hot = Hot::new('S', "pline", "pline");
pub(crate) const OF_POLYGON: Words = Words("poligon", "polygon");
pub(crate) const OF_SPLINE: Words = Words("spline", "spline");
pub(crate) const NO_COEFFICIENTS: Words = Words(
    "Ebben a fájlban nem egy Fourier-görbe együtthatói vannak",
    "This file holds no coefficients of a Fourier curve",
);
pub(crate) const HELP_WINDOW: Words = Words("ablakra kattintás: új érték", "click a window: new value");
pub(crate) const HELP_COEFFICIENT: Words =
    Words("együttható neve és száma, új érték", "a coefficient by name and number, new value");
pub(crate) const HELP_STEP: Words =
    Words("az érték változtatása: a, b 1, p, q 0.01", "change the value: a, b by 1, p, q by 0.01");
pub(crate) const HELP_TEN_STEPS: Words = Words("ennek tízszerese", "ten times as much");
pub(crate) const HELP_OTHER_WINDOW: Words = Words("másik együttható", "another coefficient");
pub(crate) const HELP_TYPE: Words = Words("új érték beírása", "type a new value");
pub(crate) const HELP_FIT: Words =
    Words("közelítés egy .IP2 fájl pontjaihoz", "fit the curve to the points of an .IP2 file");

/// There is no coefficient of a number in this column.
pub(crate) fn no_such_coefficient(numbers: &std::ops::RangeInclusive<usize>) -> Phrase {
    let (first, last) = (numbers.start(), numbers.end());
    Phrase::new(format!("Nincs ilyen: {first}...{last}"), format!("No such number: {first}...{last}"))
}

// The workshop of measured points.
pub(crate) const HELP_WORKSHOP: Words =
    Words("mérési pontok simítása (2.3.8): Enter átveszi", "smooth measured points (2.3.8); Enter accepts");
pub(crate) const TAKE_OVER: Words = Words("Enter - átvesz  ESC - vissza", "Enter - accept ESC - back");

/// How far smoothed points are from the measured ones, with the number of the farthest.
pub(crate) fn residuals(residuals: &Residuals) -> Phrase {
    let ([rms, largest], at) = (residuals.texts(2), residuals.at);
    Phrase::new(format!("RMS {rms}, max. {largest} ({at}.)"), format!("RMS {rms}, max. {largest} (no. {at})"))
}

/// How many points Bézier arcs lack.
pub(crate) fn arcs_lack(count: usize) -> Phrase {
    let points = if count == 1 { "point" } else { "points" };
    Phrase::new(format!("Az ívekhez még {count} pont kell"), format!("The arcs need {count} more {points}"))
}

/// What a joint of Bézier arcs has become.
pub(crate) fn joint_is(number: usize, smooth: bool) -> Phrase {
    match smooth {
        true => Phrase::new(format!("A {number}. pont sima"), format!("Point {number} is smooth")),
        false => Phrase::new(format!("A {number}. pont sarok"), format!("Point {number} is a corner")),
    }
}

/// The value of a smoothed point and the slope of the curve there; in space, its two slopes. Short enough for a page.
pub(crate) fn value_and_slope(number: usize, point: &[f64], slopes: &[Option<f64>]) -> Phrase {
    let shown = |slope: &Option<f64>| slope.map_or("-".to_owned(), |slope| format!("{slope:.2}"));
    let text = match (point, slopes) {
        ([_, y], [slope]) => format!("{number}: y {y:.1}, dy/dx {}", shown(slope)),
        (_, [across, up]) => format!("{number}: dy/dx {} dz/dx {}", shown(across), shown(up)),
        _ => String::new(),
    };
    Phrase::new(text.clone(), text)
}

// The surface programs.
pub(crate) const SURFACE: Hot = Hot::new('F', "elület", "-surf.");
pub(crate) const NET_QUIT: Hot = Hot::new('Q', "- kilép", "- quit");
pub(crate) const NORMAL_BUTTON: Hot = Hot::new('N', "-normál", "-normal");
pub(crate) const OFFSET_BUTTON: Hot = Hot::new('P', "-párhuz", "-offset");
pub(crate) const HELP_NORMAL: Words =
    Words("normális választása, két új szöge", "choose a normal, then its two new angles");
pub(crate) const HELP_OFFSET: Words =
    Words("párhuzamos felület távolsága (0: nincs)", "distance of the offset along the normals (0: none)");
pub(crate) const HELP_AUTOMATIC_NORMALS: Words =
    Words("normálisok a pontok spline-felületéről", "normals from the spline through the points");
pub(crate) const HELP_SIDES: Words =
    Words("M mindkét oldalon, H héj peremfalakkal", "M on both sides, H shell with walls");
pub(crate) const HELP_NET_SIZE: Words =
    Words("a háló új mérete: 2 x 2 ... 8 x 8", "another size of the net: 2 x 2 to 8 x 8");
pub(crate) const HELP_COMPARE_PN: Words =
    Words("pn és pn-thesis együtt, majd csere", "pn and pn-thesis together, then exchanged");
pub(crate) const HELP_INSPECT_RADII: Words =
    Words("zebracsíkok, Gauss-görbület, sugarak, semmi", "zebra stripes, Gaussian curvature, radii, none");
pub(crate) const HELP_GAUSS: Words =
    Words("a normálisok képe a gömbön és a síkon", "image of the normals on sphere and plane");
pub(crate) const HELP_NORMALS_DRAG: Words =
    Words("pont vagy normális húzása", "drag a point or the tip of a normal");
pub(crate) const K0_BUTTON: Hot = Hot::new('C', " - k0", " - k0");
pub(crate) const ASK_DISPLAY: Words = Words("          Megjelenítés ?", "    Wireframe or solid?");
pub(crate) const WIRE: Hot = Hot::new('D', "rótváz", "-wire");
pub(crate) const FILLED: Hot = Hot::new('T', "ele", "-solid");
pub(crate) const ASK_DIRECTION: Words = Words("          Irány ?", "         Direction?");
pub(crate) const ALONG_U: Hot = Hot::new('U', "", "");
pub(crate) const ALONG_V: Hot = Hot::new('V', "", "");
pub(crate) const ASK_AXIS: Words = Words("Melyik tengely irányában ?", "Mirror along which axis?");
pub(crate) const AXES: [Hot; 3] = [Hot::new('X', "", ""), Hot::new('Y', "", ""), Hot::new('Z', "", "")];
pub(crate) const WHAT_CHANGES: Words = Words("Mi változik ?", "Change what?");
pub(crate) const TANGENT_TITLE: Words = Words("Érintő", "Tangent");
pub(crate) const TWIST: Hot = Hot::new('T', "wist", "wist");
pub(crate) const TANGENT_U: Hot = Hot::new('U', " irány", " dir.");
pub(crate) const TANGENT_V: Hot = Hot::new('V', " irány", " dir.");
pub(crate) const TANGENT_U_TITLE: Words = Words("Érintő-u", "Tangent-u");
pub(crate) const TANGENT_V_TITLE: Words = Words("Érintő-v", "Tangent-v");
pub(crate) const TWIST_TITLE: Words = Words("Twist", "Twist");
pub(crate) const HEIGHT_TITLE: Words = Words("Magasság:", "Height:");
pub(crate) const COEFFICIENT_ENTRY: Words = Words("Együttható:", "Coeff.:");
pub(crate) const WIRE_LEGEND: Words = Words("D - drótváz", "D - wireframe");
pub(crate) const FILLED_LEGEND: Words = Words("T - tele", "T - hidden lines");
pub(crate) const NO_SURFACE: Words = Words("Előbb felületet rajzoljon: F", "Draw a surface first (F)");
pub(crate) const SURFACE_FOLLOWS: Words = Words("A felület követi a hálót", "The surface follows the net");
pub(crate) const SURFACE_FOLLOWS_NOT: Words = Words("Csak húzáskor követ", "Follows only while dragging");
pub(crate) const BORDER_REACHED: Words = Words("A peremig ér", "It ends at the border");
pub(crate) const BORDER_DOUBLED: Words = Words("A perem előtt ér véget", "It ends before the border");
pub(crate) const BORDER_INNER: Words =
    Words("A perempontok segédpontok", "The border points are auxiliary points");
pub(crate) const POLES_FREE: Words = Words("Szabad végek a pólusokban", "Free ends at the poles");
pub(crate) const POLES_TRIPLE: Words = Words("A pólusok háromszoros pontok", "The poles are triple points");
pub(crate) const POLES_JOINED: Words =
    Words("A szemközti meridiánok összeérnek", "Opposite meridians are joined at the poles");

/// Where a surface ends now; of splines, what its poles are.
pub(crate) fn border(border: Border, splines: bool) -> Words {
    match border {
        Border::Free if splines => POLES_FREE,
        Border::Free => POLES_TRIPLE,
        Border::Doubled if splines => POLES_JOINED,
        Border::Doubled => BORDER_DOUBLED,
        Border::Reached => BORDER_REACHED,
        Border::Inner => BORDER_INNER,
    }
}
pub(crate) const COLLAPSED: Words = Words(
    "A háló egy vonalon fekszik: a felület vonallá zsugorodik",
    "The net lies on a line, and so does the surface",
);
pub(crate) const NOT_A_NET: Words =
    Words("Ebben a fájlban nincs kontrollháló", "This file holds no control net");
pub(crate) const HELP_NET_CHANGE: Words =
    Words("kontrollpont választása, új hely", "choose a control point, then its new place");
pub(crate) const HELP_SURFACE: Words = Words(
    "felület: drótváz, vagy takart vonalak nélkül (tele)",
    "surface: wireframe, or solid without hidden lines",
);
pub(crate) const HELP_SURFACE_RESULT: Words =
    Words("eredmény: a felület magában, keret nélkül (D, T)", "result: the surface alone (D, T)");
pub(crate) const HELP_NET_DRAG: Words =
    Words("pont húzása; kattintás a térképre: V", "drag a point; click a disc of the map: V");
pub(crate) const HELP_NET_FOLLOW: Words = Words(
    "a felület mindig látszik és követi a hálót: be, ki",
    "the surface stays and follows every change: on, off",
);
pub(crate) const HELP_BORDER: Words =
    Words("perem: kétszeres pontok, elért, segédpontok", "border: doubled, reached, auxiliary points");
pub(crate) const HELP_POLES: Words =
    Words("szabad végek a pólusokban: be, ki", "free ends at the poles: on, off");
pub(crate) const HELP_TRIPLE: Words =
    Words("pólus: kétszeres, elért, háromszoros", "poles: doubled, reached, triple points");
pub(crate) const HELP_JOIN: Words =
    Words("második folt; a csatlakozás feltétele", "a second patch; what is kept at the joint");
pub(crate) const HELP_FRAME: Words = Words(
    "K kontrollháló, konvex burok; W egy pont súlya",
    "K control net, convex hull; W weight of a point",
);
pub(crate) const HELP_HULL: Words = Words("kontrollháló, konvex burok", "control net, convex hull");
pub(crate) const HELP_INSPECT: Words =
    Words("zebracsíkok, Gauss-görbület, semmi", "zebra stripes, Gaussian curvature, none");
pub(crate) const HELP_SECTION: Words =
    Words("síkmetszet x, y, z mentén; + - tolja", "plane section along x, y, z; + - move it");
pub(crate) const HELP_MIRROR: Words = Words("a háló tükrözése", "mirror the net");
pub(crate) const HELP_REFINE: Words =
    Words("a háló finomítása, a felület ugyanaz", "refine the net; the surface stays the same");
pub(crate) const HELP_K0: Words =
    Words("az érintők együtthatója, u és v", "coefficient of the tangents, u and v");
pub(crate) const HELP_SHAPES: Words = Words("eltolás, feszültség, u és v", "bias, tension, u and v");
pub(crate) const INSPECTIONS: [Words; 3] =
    [Words("", ""), Words("zebracsíkok", "zebra stripes"), Words("Gauss-görbület", "Gaussian curvature")];

/// A coordinate in the line under the picture.
fn in_line(value: f64) -> String {
    // Adding zero makes a negative zero positive.
    if value.abs() < 1e6 { format!("{:3.0}", value.round() + 0.0) } else { format!("{value:.2e}") }
}

/// The line under the picture: a part of a control point of a net.
pub(crate) fn part_of([k, l]: [usize; 2], name: Words, place: [f64; 3]) -> Phrase {
    let [x, y, z] = place.map(in_line);
    let line = |number: &str, name: &str| format!("{number}: {k}, {l} {name}: x = {x} y = {y} z = {z}");
    Phrase::new(line("Sorszám", name.0), line("Number", name.1))
}

/// The line under the picture: a height.
pub(crate) fn height_of([k, l]: [usize; 2], height: f64) -> Phrase {
    let z = in_line(height);
    Phrase::new(format!("Sorszám: {k}, {l} Magasság: z ={z}"), format!("Number: {k}, {l} Height: z ={z}"))
}

/// A number has been clamped to its range.
pub(crate) fn taken_into(range: &std::ops::RangeInclusive<f64>) -> Phrase {
    let (least, most) = (range.start(), range.end());
    Phrase::new(
        format!("Csak {least} és {most} között lehet: a legközelebbi érték lett"),
        format!("It must be {least} to {most}: the nearest value is used"),
    )
}

/// Why there is no surface.
pub(crate) fn no_surface(error: &GeometryError) -> Phrase {
    let GeometryError::CriticalTension { bias, critical, .. } = error else { return Phrase::plain(error) };
    Phrase::new(
        format!("{bias:.2} eltolásnál a {critical:.2} feszültség kritikus: nincs felület. Más kell: C"),
        format!(
            "With bias {bias:.2} the tension {critical:.2} is critical: there is no surface. Choose another (C)"
        ),
    )
}

/// A file holds a net of another kind.
pub(crate) fn other_net(wanted: Format, found: Format) -> Phrase {
    Phrase::new(
        format!("Ez egy {found} háló; ide {wanted} való"),
        format!("This is a {found} net; a {wanted} net is needed"),
    )
}

/// A net is too small, too large or too far away.
pub(crate) fn net_size([rows, columns]: [usize; 2], [least_u, least_v]: [usize; 2], most: usize) -> Phrase {
    Phrase::new(
        format!(
            "A háló {rows} x {columns} pont; {least_u} x {least_v} és {most} x {most} közötti kell, koordináták 1000000-ig"
        ),
        format!(
            "The net has {rows} x {columns} points; {least_u} x {least_v} to {most} x {most} are possible, coordinates up to 1000000"
        ),
    )
}

// The page of files.
pub(crate) const CHOOSE_FILE: Words =
    Words("Megnyitás: nyilak, Enter, egér vagy a név", "Open: arrows, Enter, mouse, or type the name");
pub(crate) const NO_FITTING_FILE: Words = Words("Nincs ilyen nevű fájl", "No file of such a name");

// Hints: three lines of 28 letters.
pub(crate) const HINT_FIRST: Words = Words(
    "Kattintson a mezőre: minden kattintás egy pont. F1: súgó",
    "Click on the field: every click is a point. F1 help",
);
pub(crate) const HINT_MORE: Words =
    Words("Még pontok kellenek: kattintson a mezőre", "A curve needs more points: click on the field");
pub(crate) const HINT_MORE_3D: Words = Words(
    "Még pontok kellenek: B és a három koordináta",
    "A curve needs more points: B and their coordinates",
);
pub(crate) const HINT_ARCS: Words = Words(
    "Húzza a pontokat; S: sima csatlakozás vagy sarok. G eljárás, F1 súgó",
    "Drag points; S: the nearest joint smooth or a corner. G method, F1 help",
);
pub(crate) const ONLY_ARCS: Words = Words("Bézier-ívekhez való (G, 5)", "For Bézier arcs (G, 5) only");
pub(crate) const NO_JOINT: Words = Words("Az ívek nem csatlakoznak", "There is no joint of arcs");
pub(crate) const HINT_CURVE: Words = Words("G görbét rajzol. F1: súgó", "G draws a curve. F1 help");
pub(crate) const HINT_EDIT: Words = Words(
    "Húzza a pontokat; kattintás: új pont. G eljárás, E eredmény, F1 súgó",
    "Drag points; a click adds one. G method, E result, F1 help",
);
pub(crate) const HINT_EDIT_BETA: Words = Words(
    "Húzza a pontokat; kattintás: új pont. G görbe, E eredmény, F1 súgó",
    "Drag points; a click adds one. G curve, E result, F1 help",
);
pub(crate) const HINT_EDIT_3D: Words = Words(
    "Húzza a pontokat; mellettük húzva forog. G eljárás, F1 súgó",
    "Drag points; drag beside them to turn. G method, F1 help",
);
pub(crate) const HINT_EDIT_BETA_3D: Words = Words(
    "Húzza a pontokat; mellettük húzva forog. G görbe, F1 súgó",
    "Drag points; drag beside them to turn. G curve, F1 help",
);
pub(crate) const HINT_TANGENTS: Words = Words(
    "Húzza a pontokat és az érintők végét. G görbe, F1 súgó",
    "Drag points and the tips of tangents. G curve, F1 help",
);
pub(crate) const HINT_HELD: Words = Words(
    "Engedje el, ahová kerüljön; a mezőn kívül: törlés. Esc: vissza",
    "Let go where it belongs; off the field deletes it. Esc: back",
);
pub(crate) const HINT_HELD_3D: Words =
    Words("Engedje el, ahová kerüljön. Esc: vissza", "Let go where it belongs. Esc: back");
pub(crate) const HINT_TIP: Words = Words(
    "Az érintő iránya és hossza alakítja a görbét. Esc: vissza",
    "Direction and length of the tangent shape it. Esc: back",
);
pub(crate) const HINT_NET: Words = Words(
    "Húzza a pontokat; mellettük húzva forog. F felület, E teljes képernyő, F1 súgó",
    "Drag points; drag beside them to turn. F surface, E full screen, F1 help",
);
pub(crate) const HINT_NORMALS: Words = Words(
    "Húzza a pontokat, normálisokat. P párhuzamos, F5 térkép, F8 Gauss, F1 súgó",
    "Drag points and normals. P offset, F5 maps, F8 Gauss image, F1 help",
);
pub(crate) const KEYS_NORMALS: Words = Words(
    "V pont, N normális, P párhuzamos, F5 térkép, F8 Gauss, F1 súgó",
    "V point, N normal, P offset, F5 maps, F8 Gauss image, F1 help",
);
pub(crate) const HINT_SURFACE: Words = Words(
    "Húzva forog, kerék nagyít. V pont, E teljes képernyő (D drót, T tele), F1 súgó",
    "Drag turns, wheel zooms. V point, E full screen (D wires, T solid), F1 help",
);
pub(crate) const HINT_HEIGHTS: Words = Words(
    "Húzva forog, kerék nagyít. V pont, E teljes képernyő, F1 súgó",
    "Drag turns, wheel zooms. V point, E full screen, F1 help",
);
pub(crate) const HINT_COEFFICIENTS: Words = Words(
    "Kattintson egy ablakra, vagy válasszon nyíllal. Q kilép, F1 súgó, F5 illesztés",
    "Click a window, or choose one by arrows. Q quit, F1 help, F5 fit to points",
);
/// Under the number itself.
pub(crate) const HINT_COEFFICIENT: Words =
    Words("Fel/Le változtatja, Enter: beírás, Esc: vissza", "Up/Down change it, Enter: type it, Esc: back");
pub(crate) const HINT_TYPING: Words = Words("Enter: kész, Esc: mégsem", "Enter: done, Esc: cancel");
pub(crate) const HINT_CURSOR: Words = Words(
    "Vigye a színek fölé az egérrel vagy a nyilakkal. F1 súgó, Esc vége",
    "Move it over the colours by mouse or arrows. F1 help, Esc end",
);

// The same where keys move the pointer.
pub(crate) const KEYS_FIRST: Words = Words(
    "Ctrl+nyíl visz a helyére, Ctrl+szóköz kétszer: pont. F1 súgó",
    "Ctrl+arrows go to a place, Ctrl+Space twice: a point. F1 help",
);
pub(crate) const KEYS_MORE: Words = Words(
    "Még pontok kellenek: Ctrl+nyíl, Ctrl+szóköz kétszer",
    "A curve needs more points: Ctrl+arrows, Ctrl+Space twice",
);
pub(crate) const KEYS_EDIT: Words = Words(
    "Ctrl+nyíllal egy pontra, Ctrl+szóköz megfogja. G eljárás, F1 súgó",
    "Ctrl+arrows to a point, Ctrl+Space takes it. G method, E result, F1 help",
);
pub(crate) const KEYS_EDIT_CURVE: Words = Words(
    "Ctrl+nyíllal egy pontra, Ctrl+szóköz megfogja. G görbe, F1 súgó",
    "Ctrl+arrows to a point, Ctrl+Space takes it. G curve, E result, F1 help",
);
pub(crate) const KEYS_EDIT_3D: Words = Words(
    "Nyíl forgat; Ctrl+nyíl, Ctrl+szóköz: pont fogása. G eljárás, F1 súgó",
    "Arrows turn it; Ctrl+arrows, Ctrl+Space take a point. G method, F1 help",
);
pub(crate) const KEYS_EDIT_CURVE_3D: Words = Words(
    "Nyíl forgat; Ctrl+nyíl, Ctrl+szóköz: pont fogása. G görbe, F1 súgó",
    "Arrows turn it; Ctrl+arrows, Ctrl+Space take a point. G curve, F1 help",
);
pub(crate) const KEYS_HELD: Words = Words(
    "Ctrl+nyíl viszi, Ctrl+szóköz elengedi. Esc: vissza",
    "Ctrl+arrows move it, Ctrl+Space lets go. Esc: back",
);
pub(crate) const KEYS_NET: Words = Words(
    "Nyíl forgat; Ctrl+nyíl, Ctrl+szóköz: pont fogása. F felület, F1 súgó",
    "Arrows turn it; Ctrl+arrows, Ctrl+Space take a point. F surface, F1 help",
);
pub(crate) const KEYS_SURFACE: Words = Words(
    "Nyíl forgat. V pont, E teljes képernyő (D drót, T tele), F1 súgó",
    "Arrows turn, Alt+PgUp zooms. V point, E full screen (D wires, T solid), F1 help",
);
pub(crate) const KEYS_HEIGHTS: Words = Words(
    "Nyíl forgat, Alt+PgUp nagyít. V pont, E teljes képernyő, F1 súgó",
    "Arrows turn, Alt+PgUp zooms. V point, E full screen, F1 help",
);
pub(crate) const KEYS_COEFFICIENTS: Words = Words(
    "Nyíllal válasszon ablakot. Q kilép, F1 súgó, F5 illesztés",
    "Choose a window by arrows. Q quit, F1 help, F5 fit to points",
);

/// A point has been deleted by the key.
pub(crate) fn deleted(number: usize) -> Phrase {
    Phrase::new(format!("{number}. pont törölve (Ctrl+Z)"), format!("Point {number} deleted (Ctrl+Z)"))
}

pub(crate) const NOTHING_HERE: Words = Words("Az egér alatt nincs pont", "No point under the mouse");

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
