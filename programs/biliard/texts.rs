//! The texts of BILIARD in Hungarian and English.

use crate::machine::Language;
use crate::table::{GOAL, Points};
use crate::ui::{KeyHelp, Words, line};

pub(crate) const SHOOT: KeyHelp =
    (Words("egér", "mouse"), Words("lökés: húzza el egy golyó képét", "shot: drag a ball's ghost away"));
pub(crate) const BACK: KeyHelp =
    line("Esc", "húzás közben: mégsem; különben kilépés", "while dragging: no shot; else quit");
pub(crate) const SKIP: KeyHelp =
    line("Enter", "ugrás a mozgás végére", "skip to where the balls come to rest");
pub(crate) const LINE: KeyHelp = line("A", "célzóvonal be, ki", "aiming line on, off");
pub(crate) const CLOTH: KeyHelp = line("T", "a posztó színe", "colour of the cloth");
pub(crate) const SLOWLY: KeyHelp = line("R", "az utolsó lökés lassítva", "the last shot in slow motion");
pub(crate) const ROUGH: KeyHelp =
    line("S", "érdes golyók, falssal: be, ki", "rough balls, with spin: on, off");
pub(crate) const SPIN: KeyHelp =
    (Words("← →  görgő", "← →  wheel"), Words("fals a lökésben", "spin of the shot"));
pub(crate) const POINTS: KeyHelp =
    line("P", "két játékos, pontra: be, ki", "two players, for points: on, off");
pub(crate) const RACK: KeyHelp = line("N", "új felállítás", "a new rack");
pub(crate) const FILES: KeyHelp = line("Ctrl+S Ctrl+O", "mentés, betöltés (.JSON)", "save, open (.JSON)");
pub(crate) const UNDO: KeyHelp =
    line("Ctrl+Z Ctrl+Y", "a lökés visszavonása, ismétlése", "undo, redo the shot");
pub(crate) const END: KeyHelp = line("Q", "kilépés", "quit");

pub(crate) const ASK_NEW: Words = Words("      Új felállítás ?", "         New rack ?");
pub(crate) const ASK_SAVE: Words = Words("     Menteni a játékot ?", "      Save the game ?");
pub(crate) const NO_SHOT: Words = Words("Még nem volt lökés", "There has been no shot yet");
pub(crate) const SAVED: Words = Words("Elmentve", "Saved");
pub(crate) const REPLAY: Words = Words("Lassítva", "Slow motion");
pub(crate) const NO_DOCUMENT: Words = Words("Ez nem biliárdjátszma", "This is not a game of billiards");

// What can be done now, under the table.
pub(crate) const HINT_SHOOT: Words = Words(
    "Lökés: húzza el egy golyó képét arra, amerre guruljon, és engedje el. Minél messzebb, annál gyorsabb. F1: súgó",
    "To shoot, drag a ball's ghost to where the ball is to roll, and let go. The farther, the faster. F1: help",
);
pub(crate) const HINT_AIM: Words = Words("Engedje el: lökés. Esc: mégsem", "Let go to shoot. Esc: no shot");
pub(crate) const KEYS_SHOOT: Words = Words(
    "Lökés: Ctrl+nyíllal egy golyó képére, Ctrl+szóköz, tovább arra, amerre guruljon, Ctrl+szóköz. F1: súgó",
    "To shoot, Ctrl+arrows to a ball's ghost, Ctrl+Space, on to where it is to roll, Ctrl+Space. F1: help",
);
pub(crate) const KEYS_AIM: Words =
    Words("Ctrl+szóköz: lökés. Esc: mégsem", "Ctrl+Space shoots. Esc: no shot");
pub(crate) const HINT_ROLL: Words = Words(
    "Enter vagy kattintás: ugrás a mozgás végére",
    "Enter or a click: skip to where the balls come to rest",
);
pub(crate) const HINT_REPLAY: Words =
    Words("Lassítva. Esc, Enter vagy kattintás: vége", "Slow motion. Esc, Enter or a click: back");
pub(crate) const HINT_WON: Words =
    Words("N: új játszma. P: pontok nélkül", "N: a new game. P: without points");
pub(crate) const STRENGTH: Words = Words("Erő", "Strength");

/// The line above the table: whose turn it is and the points.
pub(crate) fn score(points: &Points, language: Language) -> String {
    let [first, second] = points.scores;
    let turn = points.turn + 1;
    match (language, points.winner()) {
        (Language::Hungarian, None) => {
            format!("Pontok: {first} - {second}   lök: {turn}. játékos   cél: {GOAL}")
        }
        (Language::English, None) => {
            format!("Points: {first} - {second}   to play: player {turn}   goal: {GOAL}")
        }
        (Language::Hungarian, Some(winner)) => {
            format!("Pontok: {first} - {second}   nyert: {}. játékos", winner + 1)
        }
        (Language::English, Some(winner)) => {
            format!("Points: {first} - {second}   player {} has won", winner + 1)
        }
    }
}

/// The spin of the next shot, in quarters of the shot's speed.
pub(crate) fn spin(quarters: i32, language: Language) -> String {
    let word = Words("Fals", "Spin").of(language);
    match quarters {
        0 => format!("{word}: 0"),
        quarters => format!("{word}: {quarters:+}/4"),
    }
}
