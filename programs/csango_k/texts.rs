//! The texts of CSANGO_K in Hungarian and English.

use super::game::Preset;
use crate::machine::Language;
use crate::puzzle::cube::{Move, Refused, Rules};
use crate::ui::{Hot, KeyHelp, Phrase, Stopwatch, Words, line};
use std::time::Duration;

pub(crate) const MOVE: KeyHelp =
    line("X Y Z, U V W", "eltolás a tengely mentén, vissza", "move along the axis, back");
pub(crate) const TURN: KeyHelp =
    line("R S T, E F G", "forgatás a tengely körül, vissza", "turn about the axis, back");
pub(crate) const OTHER: KeyHelp = (
    Words("A  B  szám", "A  B  number"),
    Words("másik elem; a száma 1...14", "another piece; its number 1...14"),
);
pub(crate) const DRAG: KeyHelp =
    (Words("egér", "mouse"), Words("elem választása, húzása", "choose a piece, drag it"));
pub(crate) const LIFT: KeyHelp =
    (Words("görgő", "wheel"), Words("az elem emelése, süllyesztése", "lift the piece, lower it"));
pub(crate) const LOOK: KeyHelp = line("← → ↑ ↓", "nézőpont", "point of view");
pub(crate) const RIGID: KeyHelp =
    line("F3", "forgatást más elem megállít: be, ki", "turns blocked by other pieces: on, off");
pub(crate) const HINT: KeyHelp = line("F4", "tipp: a következő lépés", "hint: the next move");
pub(crate) const SOLVE: KeyHelp =
    line("F5", "megoldás lejátszása; Esc megállítja", "play a solution; Esc stops it");
pub(crate) const RESTART: KeyHelp = line("F6", "újra az elejéről", "start again");
pub(crate) const SCRAMBLE: KeyHelp = line("F7", "összekeverés", "scramble");

pub(crate) const GOAL: Words = Words("Cél", "Goal");
pub(crate) const ASK_START: Words = Words("Hány elem hiányzik?", "Pieces missing?");
/// The presets of the first question, with the file.
pub(crate) const START: [(Hot, Option<Preset>); 5] = [
    (Hot::new('3', "", ""), Some(Preset::Three)),
    (Hot::new('6', "", ""), Some(Preset::Six)),
    (Hot::new('1', "4", "4"), Some(Preset::All)),
    (Hot::new('K', "everve", "-mixed"), Some(Preset::Mixed)),
    (Hot::new('T', "-fájl", "-file"), None),
];
/// The presets of a new game.
pub(crate) const PRESETS: [(Hot, Preset); 4] = [
    (Hot::new('3', "", ""), Preset::Three),
    (Hot::new('6', "", ""), Preset::Six),
    (Hot::new('1', "4", "4"), Preset::All),
    (Hot::new('K', "everve", "-mixed"), Preset::Mixed),
];

/// What can be done at the start of a game.
pub(crate) const BEGIN: Words = Words(
    "Húzzon egy elemet a piros helyre; a görgő emeli, R S T fordítja. H: segítség",
    "Drag a piece to the red place; the wheel lifts it, R S T turn it. H: a hint",
);
pub(crate) const BEGIN_BY_KEYS: Words = Words(
    "A és B választ elemet, X Y Z tolja, R S T forgatja. H: segítség",
    "A and B choose a piece, X Y Z move it, R S T turn it. H: a hint",
);
pub(crate) const GO_ON: Words = Words(
    "H: segítség, F6: elölről, F1: a szabályok, nyilak: nézőpont",
    "H: a hint, F6: restart, F1: the rules, arrows: point of view",
);
pub(crate) const AGAIN: Words =
    Words("F7: új játék, P: nehezebb, F6: még egyszer", "F7: new game, P: a harder one, F6: once more");

/// Why a move was refused.
pub(crate) fn refused(why: Refused) -> Phrase {
    match why {
        Refused::NoPiece => Words("Nincs ilyen elem", "There is no such piece").into(),
        Refused::OffTable => Words(
            "Itt az asztal széle: az elem nem mehet tovább",
            "The table ends here: the piece cannot go on",
        )
        .into(),
        Refused::ThroughTable => Words(
            "Az asztal útban van: előbb emelje meg (Z)",
            "The table is in the way: lift the piece first (Z)",
        )
        .into(),
        Refused::Occupied(other) => Phrase::new(
            format!("Útban van egy másik elem (szám: {}); emelje át (Z) vagy kerülje meg", other + 1),
            format!("Piece {} is in the way; lift yours over it (Z) or go around", other + 1),
        ),
    }
}

/// What a hinted move is.
pub(crate) fn do_this(step: Move) -> Phrase {
    let (piece, letter) = (step.piece + 1, step.action.letter());
    Phrase::new(
        format!("Nyomja le: {letter}. A kiválasztott elem (szám: {piece}) a sárga gombbal mozog"),
        format!("Press {letter}: piece {piece}, which is chosen, moves by the yellow button"),
    )
}

/// Which game it is.
pub(crate) fn game(preset: Preset, number: u64, language: Language) -> String {
    let name = match preset {
        Preset::Three => "3",
        Preset::Six => "6",
        Preset::All => "14",
        Preset::Mixed => Words("kevert", "mixed").of(language),
    };
    format!("{} {name} / {number}", Words("Feladat:", "Game:").of(language))
}

pub(crate) const LOGO: Words = Words("Emőke játéka", "Emőke's game");
pub(crate) const LEAVE: Words = Words("kilép", " quit");
pub(crate) const SELECTION: Words = Words("Kiválasztás", " Selection");
pub(crate) const NO_CUBE: Words =
    Words("Ebben a fájlban nincs Csángó kocka", "This file holds no position of the Csángó cube");
pub(crate) const FINISHED: Words = Words("Kész a kocka!", "The cube is finished!");
pub(crate) const ALREADY: Words = Words("A kocka kész", "The cube is finished");
pub(crate) const NO_WAY: Words = Words("Nem találok megoldást", "I find no solution");
pub(crate) const RIGID_ON: Words = Words("Más elem megállít", "Pieces block turns now");
pub(crate) const RIGID_OFF: Words = Words("A forgatás átmegy máson", "Turns pass through pieces");
pub(crate) const STOPPED: Words = Words("Megállítva", "Stopped");

/// The line under the field: moves, time, rules.
pub(crate) fn score(moves: u32, time: Duration, rules: Rules, language: Language) -> String {
    let word = Words("Lépés", "Moves").of(language);
    let rigid = match rules {
        Rules::Book => "",
        Rules::Rigid => Words("  merev", "  rigid").of(language),
    };
    format!("{word}: {moves}  {}{rigid}", Stopwatch::text(time))
}

/// The move that is shown.
pub(crate) fn hint(step: Move, language: Language) -> String {
    format!("{} {} {}", Words("Tipp:", "Hint:").of(language), step.piece + 1, step.action.letter())
}

/// How far a search is.
pub(crate) fn progress((nodes, pieces): (u64, usize), language: Language) -> String {
    match (nodes, language) {
        (0, Language::Hungarian) => format!("Út: {pieces}/14  Esc"),
        (0, Language::English) => format!("Way: {pieces}/14  Esc"),
        (nodes, Language::Hungarian) => format!("Keresés: {nodes}  Esc"),
        (nodes, Language::English) => format!("Search: {nodes}  Esc"),
    }
}

/// How many moves are left to be played.
pub(crate) fn left(moves: usize, language: Language) -> String {
    format!("{}: {moves}  Esc", Words("Hátra", "Left").of(language))
}

/// What the finished cube took.
pub(crate) fn finished(moves: u32) -> Phrase {
    Phrase::new(format!("{} {moves} lépés", FINISHED.0), format!("{} {moves} moves", FINISHED.1))
}
