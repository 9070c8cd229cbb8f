//! The words of KC_TER.

use crate::ui::words::{Hot, Phrase, Words};
use crate::ui::{KeyHelp, line};

pub(super) const PAGE: Words = Words("Lap:", "Page:");
pub(super) const ASK_KIND: Words = Words("   Görbe vagy felület ?", "    Curve or surface?");
pub(super) const CURVE: Hot = Hot::new('G', "örbe", "-curve");
pub(super) const SURFACE: Hot = Hot::new('F', "elület", "-surf.");
pub(super) const ASK_DIRECTION: Words = Words("   Melyik irányban ?", "   Along which direction?");
pub(super) const ALONG_U: Hot = Hot::new('U', "", "");
pub(super) const ALONG_V: Hot = Hot::new('V', "", "");
pub(super) const ASK_ROW: Words = Words("Melyik sor változik? A betűje", "Which row changes? Its letter");
pub(super) const ASK_ROOT_ROW: Words = Words("Mi változik? 1-8, A, E vagy H", "Change what? 1-8, A, E or H");
pub(super) const ASK_DELETED_ROW: Words = Words("Melyik gyök törlődik? 1-8", "Delete which root? 1-8");
pub(super) const ASK_DELETE: Words = Words("       Törlés ?", "     Delete the item?");
pub(super) const ASK_MIDDLE: Words = Words("Hol? Kifejezés, vagy kattintás", "Where? Type it, or click");
pub(super) const ASK_PARTS: Words = Words("Hány egyenlő részre?", "Into how many equal parts?");
pub(super) const ASK_INTERVAL: Words = Words("Intervallum: kezdet, vég", "Interval: start, end");
pub(super) const ASK_INTERVAL_U: Words = Words("Az u intervallum: kezdet, vég", "Interval of u: start, end");
pub(super) const ASK_INTERVAL_V: Words = Words("A v intervallum: kezdet, vég", "Interval of v: start, end");
pub(super) const ASK_PARTS_U: Words = Words("Hány rész u irányban?", "How many parts along u?");
pub(super) const ASK_PARTS_V: Words = Words("Hány rész v irányban?", "How many parts along v?");
pub(super) const ASK_OTHER: Words = Words("Melyik elemmel? A száma", "Join with which item? Its number");
pub(super) const ASK_ORDER: Words = Words("Folytonosság: 0-3, vagy G", "Continuity: 0-3, or G");
pub(super) const ASK_ROOT: Words = Words("Gyök, mint i, 1/4+i, -2", "Root, as i, 1/4+i, -2");
pub(super) const ASK_MULTIPLICITY: Words = Words("Hányszoros?", "Its multiplicity");
pub(super) const ASK_START: Words = Words("Az intervallum kezdete", "Start of the interval");
pub(super) const ASK_END: Words = Words("Az intervallum vége", "End of the interval");
/// As many as fit; P3 is where the dialog begins.
pub(super) const ASK_PRESET: Words = Words("T2 H2 AT2 AH1 AET1 M4(1,1/5)", "T2 H2 AT2 AH1 AET1 M4(1,1/5)");
pub(super) const ASK_KEEP_CURVE: Words = Words("  A görbe maradjon meg ?", "   Keep the shape?");
pub(super) const ELEVATE: Hot = Hot::new('E', "melés", "-yes");
pub(super) const KEEP_POINTS: Hot = Hot::new('K', "-pont", "-pts");
pub(super) const ASK_WHERE_FROM: Words = Words("     Honnan ?", "     From where?");
pub(super) const ASK_WHERE_TO: Words = Words("      Hová ?", "     To where?");
pub(super) const BUFFER: Hot = Hot::new('M', "emória", "-memo");
pub(super) const FILE: Hot = Hot::new('F', "ájl", "-file");

pub(super) const NOTHING_SELECTED: Words = Words("Nincs kijelölt elem", "Nothing is selected");
pub(super) const NOTHING_KEPT: Words = Words("A memória üres", "The memory is empty");
pub(super) const KEPT: Words = Words("Megjegyezve", "Kept in memory");
pub(super) const ZERO_STAYS: Words = Words("A 0 gyök nem törölhető", "The root 0 cannot be deleted");
pub(super) const NO_SUCH_ROW: Words = Words("Nincs ilyen sor", "There is no such row");
pub(super) const NO_ITEM: Words = Words("Nincs ilyen elem", "There is no such item");
pub(super) const OTHER_KIND: Words = Words(
    "Görbe csak görbéhez, felület felülethez illeszthető",
    "A curve joins a curve, a surface a surface",
);
pub(super) const NO_ORDER: Words = Words("0, 1, 2, 3 vagy G kell", "Type 0, 1, 2, 3 or G");
pub(super) const NO_DOCUMENT: Words = Words(
    "ez a program .KCJ, .KCG, .KCF, .KCE és .KCT fájlokat nyit meg",
    "this program opens .KCJ, .KCG, .KCF, .KCE and .KCT files",
);
pub(super) const NOT_GOOD: Words = Words("Ez az intervallum nem jó", "This interval is not good");
pub(super) const COPIED: Words = Words("Lemásolva", "Copied");
pub(super) const NO_WHOLE: Words = Words("Egész szám kell", "A whole number is needed");
pub(super) const TWO_ENDS: Words = Words("Két szám kell, vesszővel", "Two numbers with a comma are needed");

pub(super) const YES: Words = Words("igen", "yes");
pub(super) const NO: Words = Words("nem", "no");
pub(super) const ALWAYS: Words = Words("mindig", "always");
pub(super) const WHEN_SELECTED: Words = Words("kijel.", "select.");
pub(super) const EYE: Words = Words("szem", "eye");
pub(super) const UPPER_LEFT: Words = Words("balról", "left");
pub(super) const EXACT: Words = Words("pontos", "exact");
pub(super) const EMPTY: Words = Words("üres jelenet", "empty scene");

/// The names of the colours, as short as a window.
pub(super) const COLORS: [Words; 16] = [
    Words("fekete", "black"),
    Words("kék", "blue"),
    Words("zöld", "green"),
    Words("türkiz", "cyan"),
    Words("piros", "red"),
    Words("lila", "magenta"),
    Words("barna", "brown"),
    Words("szürke", "grey"),
    Words("s.szür.", "d.grey"),
    Words("v.kék", "l.blue"),
    Words("v.zöld", "l.green"),
    Words("v.türk.", "l.cyan"),
    Words("v.piros", "l.red"),
    Words("v.lila", "l.mag."),
    Words("sárga", "yellow"),
    Words("fehér", "white"),
];

pub(super) const FILLS: [Words; 7] = [
    Words("huzal", "wires"),
    Words("takart", "hidden"),
    Words("árnyalt", "shaded"),
    Words("zebra", "zebra"),
    Words("K görb.", "K curv."),
    Words("H görb.", "H curv."),
    Words("magas.", "height"),
];

pub(super) const MATERIALS: [Words; 10] = [
    Words("rézöt.", "brass"),
    Words("arany", "gold"),
    Words("ezüst", "silver"),
    Words("smaragd", "emerald"),
    Words("gyöngy", "pearl"),
    Words("rubin", "ruby"),
    Words("türkiz", "turqu."),
    Words("vörösr.", "copper"),
    Words("zafír", "sapphir"),
    Words("gumi", "rubber"),
];

pub(super) const GOOD: Words = Words("JÓ", "GOOD");
pub(super) const LONG: Words = Words("HOSSZÚ", "TOO LONG");
pub(super) const SHORT: Words = Words("RÖVID", "TOO SHORT");
pub(super) const LARGE: Words = Words("NAGY", "TOO LARGE");
pub(super) const AT_MOST: Words = Words("legfeljebb", "at most");
pub(super) const DIMENSION: Words = Words("dimenzió", "dimension");
pub(super) const PRECISION: Words = Words("pontosság", "precision");
pub(super) const GRAPHS: [Words; 5] = [
    Words("NB-bázis", "B-basis"),
    Words("1. derivált", "1st derivatives"),
    Words("közönséges bázis", "ordinary basis"),
    Words("kanonikus bázis", "canonical basis"),
    Words("pontosság", "precision"),
];
pub(super) const SPACE_OF_CURVE: Words = Words("A görbe KC-tere", "EC space of the curve");
pub(super) const SPACE_OF_U: Words = Words("A felület KC-tere, u", "EC space along u");
pub(super) const SPACE_OF_V: Words = Words("A felület KC-tere, v", "EC space along v");
pub(super) const ROOT_HEADER: Words = Words("gyök           m.  dim.", "root           mult deg");
pub(super) const EXACT_TITLE: Words = Words("Pontos leírás", "Exact description");
pub(super) const COLUMNS: Words = Words("oszlop", "columns");
pub(super) const TIMES: Words =
    Words("Az idők (ms), a dolgozaté mellett", "Times (ms), beside those of the thesis");

// Hints.
pub(super) const HINT_EMPTY: Words =
    Words("B új görbe vagy felület, O minták. F1 súgó", "B new curve or surface, O samples. F1 help");
pub(super) const HINT_NONE: Words = Words(
    "Kattintson egy elemre, vagy Tab. Húzás: mozgat, jobb: forgat",
    "Click an item, or Tab. Drag moves, right drag turns",
);
pub(super) const HINT_CURVE: Words = Words(
    "Húzzon egy pontot. G gyökök, D darabol, K együtthatók",
    "Drag a point. G roots, D divides, K coefficients",
);
pub(super) const HINT_POINT: Words =
    Words("Húzza a pontot, vagy V és X, Y, Z. Esc: vissza", "Drag the point, or V and X, Y, Z. Esc: back");
pub(super) const HINT_ITEMS: Words = Words(
    "Fel, Le, Enter választ; Szóköz elrejt; Esc vissza",
    "Up, Down, Enter selects; Space hides; Esc back",
);

// Help lines.
pub(super) const HELP_PAGES: KeyHelp =
    line("1 2 3 4", "lapok: nézet, görbe, felület, pont", "pages: view, curve, surface, point");
pub(super) const HELP_CHANGE: KeyHelp = line(
    "V",
    "a lap egy sorának értéke, betűvel (vagy kattintás)",
    "a row of the page by its letter (or a click)",
);
pub(super) const HELP_NEW: KeyHelp =
    line("B T", "új elem; a kijelölt törlése", "new item; delete the selected one");
pub(super) const HELP_RESULT: KeyHelp =
    line("E", "a kép egyedül (D huzal, T kitöltve)", "the picture alone (D wires, T filled)");
pub(super) const HELP_ROOTS: KeyHelp =
    line("G", "a kijelölt elem tere: gyökök, intervallum", "the item's space: roots, interval");
pub(super) const HELP_QUIT: KeyHelp = line("Q", "mentés, vége, új jelenet", "save, end, new scene");
pub(super) const HELP_PANEL: KeyHelp = line(
    "O D C K J N",
    "a lapon: emelés, osztás, sáv, együtthatók, illesztés...",
    "on pages: raise, divide, strip, coefficients, join...",
);
pub(super) const HELP_SELECT: KeyHelp = (
    Words("klikk Tab", "click Tab"),
    Words("elem vagy pont kijelölése; Esc: semmi", "select an item or point; Esc: nothing"),
);
pub(super) const HELP_DRAG: KeyHelp =
    (Words("húzás", "drag"), Words("pont, elem vagy a nézet mozgatása", "move a point, an item or the view"));
pub(super) const HELP_TURN: KeyHelp = (
    Words("jobb gomb", "right button"),
    Words("az elem vagy a nézet forgatása (nyilak is)", "turn an item or the view (arrows, too)"),
);
pub(super) const HELP_ZOOM: KeyHelp = (
    Words("kerék + -", "wheel + -"),
    Words("nagyítás; Home: az egész jelenet", "zoom; Home: the whole scene"),
);
pub(super) const HELP_SCALE: KeyHelp =
    line("PgUp PgDn", "a kijelölt elem nagyobb, kisebb", "selected item larger, smaller");
pub(super) const HELP_POLYGONS: KeyHelp =
    line("F3", "minden poligon, vagy csak a kijelölté", "all control polygons, or the selected");
pub(super) const HELP_INSPECT: KeyHelp = line(
    "F5 F6",
    "zebra, görbület, magasság; metszet síkkal",
    "zebra, curvature, height; section by a plane",
);
pub(super) const HELP_COPY: KeyHelp =
    line("Ctrl+C Ctrl+V", "elem másolása, beillesztése", "copy an item, insert the copy");
pub(super) const HELP_UNDO: KeyHelp =
    line("Ctrl+Z Ctrl+Y", "visszavonás, ismét; Ctrl+S ment", "undo, redo; Ctrl+S saves");
pub(super) const HELP_SPEED: KeyHelp =
    line("F7", "sebesség: mérés a dolgozat táblázata mellett", "speed: measured beside the thesis's table");

/// An error of the mathematics for the user: Hungarian where it is one of those that are met while typing.
pub(super) fn problem(error: &crate::geometry::ec::EcError) -> Phrase {
    use crate::geometry::ec::EcError;
    let english = error.to_string();
    let hungarian = match error {
        EcError::Interval { .. } => "Hibás intervallum: kezdet < vég kell".to_owned(),
        EcError::Twice { root } => format!("A {root} gyök már szerepel; a multiplicitását növelje"),
        EcError::TooLong { critical, .. } => format!("Túl hosszú: l' = {critical:.6}"),
        EcError::TooShort { .. } => "Túl rövid: legalább 1e-6 kell".to_owned(),
        EcError::TooStiff { most, .. } => format!("A pontossághoz túl hosszú: legfeljebb {most:.6}"),
        EcError::Imprecise { .. } => "A pontossághoz túl hosszú".to_owned(),
        EcError::Dimension { .. } => "A tér mérete 2 és 31 között lehet".to_owned(),
        EcError::Outside { interval: [a, b], .. } => format!("{a} és {b} között kell lennie"),
        EcError::NoZero => "A 0 gyöknek szerepelnie kell".to_owned(),
        EcError::Syntax { at, .. } => format!("Nem szám: a {at}. jelnél hibás"),
        EcError::NoNumber { .. } => "Nem véges szám".to_owned(),
        _ => english.clone(),
    };
    Phrase::new(hungarian, english)
}
