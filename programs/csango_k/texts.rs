//! The texts of CSANGO_K in Hungarian and English.

use crate::machine::Language;
use crate::puzzle::cube::{Move, Rules};
use crate::ui::{KeyHelp, Phrase, Stopwatch, Words, line};
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
    line("F3", "merev forgatás, semmin sem megy át: be, ki", "rigid turns, through nothing: on, off");
pub(crate) const HINT: KeyHelp = line("F4", "tipp: a következő lépés", "hint: the next move");
pub(crate) const SOLVE: KeyHelp =
    line("F5", "megoldás lejátszása; Esc megállítja", "play a solution; Esc stops it");
pub(crate) const RESTART: KeyHelp = line("F6", "újra az elejéről", "start again");
pub(crate) const SCRAMBLE: KeyHelp = line("F7", "összekeverés", "scramble");

pub(crate) const LOGO: Words = Words("Emőke játéka", "Emőke's game");
pub(crate) const LEAVE: Words = Words("kilép", " quit");
pub(crate) const SELECTION: Words = Words("Kiválasztás", " Selection");
pub(crate) const NO_CUBE: Words =
    Words("Ebben a fájlban nincs Csángó kocka", "This file holds no position of the Csángó cube");
pub(crate) const FINISHED: Words = Words("Kész a kocka!", "The cube is finished!");
pub(crate) const ALREADY: Words = Words("A kocka kész", "The cube is finished");
pub(crate) const NO_WAY: Words = Words("Nem találok megoldást", "No solution found");
pub(crate) const RIGID_ON: Words = Words("A forgatás merev", "Turns are rigid");
pub(crate) const RIGID_OFF: Words = Words("A forgatás átmegy máson", "Turns go through others");
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
