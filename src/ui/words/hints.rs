//! Hints of what can be done now: three lines of 28 letters, with a mouse and by keys.

use super::{Phrase, Words};

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
