//! Words of the help page and the settings, and the help lines of the curve editors.

use super::{Hot, Phrase, Words};
use crate::machine::StorageError;
use std::ops::RangeInclusive;

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
pub(crate) fn wrong_value(word: &str, range: &RangeInclusive<f64>) -> Phrase {
    let (low, high) = (range.start(), range.end());
    if *low == f64::MIN {
        return Phrase::new(format!("\"{word}\" nem szám"), format!("\"{word}\" is not a number"));
    }
    Phrase::new(
        format!("\"{word}\" nem {low} és {high} közötti szám"),
        format!("\"{word}\" is not a number from {low} to {high}"),
    )
}
pub(crate) fn too_many_values(count: usize, most: usize) -> Phrase {
    Phrase::new(
        format!("{count} érték túl sok: legfeljebb {most}"),
        format!("{count} values are too many: {most} at most"),
    )
}
