//! The texts of BILIARD in Hungarian and English.

use crate::machine::Language;
use crate::table::{GOAL, Points};
use crate::ui::{KeyHelp, Words, line};

pub(crate) const SHOOT: KeyHelp =
    (Words("egér", "mouse"), Words("lökés: a golyó képének húzása", "shot: drag a ball's ghost away"));
pub(crate) const BACK: KeyHelp =
    line("Esc", "húzás közben: mégsem; különben kilépés", "while dragging: no shot; otherwise quit");
pub(crate) const SKIP: KeyHelp =
    line("Enter", "a mozgás végére ugrik", "skip to where the balls come to rest");
pub(crate) const LINE: KeyHelp = line("A", "célzóvonal be, ki", "aiming line on, off");
pub(crate) const SLOWLY: KeyHelp = line("R", "az utolsó lökés lassítva", "the last shot in slow motion");
pub(crate) const ROUGH: KeyHelp = line("S", "érdes golyók: fals be, ki", "rough balls: spin on, off");
pub(crate) const SPIN: KeyHelp =
    (Words("← →  görgő", "← →  wheel"), Words("fals a lökésben", "spin of the shot"));
pub(crate) const POINTS: KeyHelp = line("P", "két játékos pontra, vissza", "two players with points, back");
pub(crate) const RACK: KeyHelp = line("N", "új felállítás", "a new rack");
pub(crate) const FILES: KeyHelp = line("Ctrl+S Ctrl+O", "mentés, betöltés (.JSON)", "save, load (.JSON)");
pub(crate) const UNDO: KeyHelp = line("Ctrl+Z Ctrl+Y", "a lökés visszavonása, újra", "undo, redo the shot");
pub(crate) const END: KeyHelp = line("Q", "kilépés", "quit");

pub(crate) const ASK_NEW: Words = Words("      Új felállítás ?", "         New rack?");
pub(crate) const ASK_SAVE: Words = Words("     Menteni a játékot ?", "       Save the game?");
pub(crate) const NO_SHOT: Words = Words("Még nem volt lökés", "No shot yet");
pub(crate) const SAVED: Words = Words("Elmentve", "Saved");
pub(crate) const REPLAY: Words = Words("Lassítva", "Slow motion");
pub(crate) const NO_DOCUMENT: Words = Words("Ez nem biliárdjátszma", "This is not a game of billiards");

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
