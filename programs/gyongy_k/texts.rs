//! The texts of GYONGY_K in Hungarian and English.

use super::game::Problem;
use crate::machine::Language;
use crate::puzzle::wheel::{Difficulty, Move, Progress};
use crate::ui::{Hot, KeyHelp, Phrase, Stopwatch, Words, line};
use std::time::Duration;

pub(crate) const PUSH: KeyHelp =
    line("A B C D E F", "fiók betolása egy gyönggyel", "push a drawer in by one bead");
pub(crate) const TURN: KeyHelp =
    line("I K M  J L N", "gyűrű forgatása balra, jobbra", "turn a ring to the left, right");
pub(crate) const CLICK: KeyHelp = (
    Words("egér", "mouse"),
    Words("kattintás a fiókra, a kerék betűire", "click a drawer or a letter of the wheel"),
);
pub(crate) const UNDO: KeyHelp = line("Ctrl+Z Ctrl+Y", "lépés visszavonása, újra", "undo, redo a move");
pub(crate) const RESTART: KeyHelp = line("R", "a feladat elölről", "start the problem again");
pub(crate) const NEW_PROBLEM: KeyHelp =
    line("U", "új feladat: nehézség, sorszám", "a new problem: difficulty, number");
pub(crate) const HINT: KeyHelp = line("H", "segítség: a következő lépés", "hint: the next move");
pub(crate) const SOLVE: KeyHelp = line("S", "megoldás keresése és lejátszása", "find and play a solution");
pub(crate) const DEMONSTRATE: KeyHelp = line("X", "bemutató", "demonstration");
pub(crate) const SAVE: KeyHelp = line("Ctrl+S", "mentés (.GYK)", "save (.GYK)");
pub(crate) const STOP: KeyHelp = (
    Words("Esc", "Esc"),
    Words(
        "keresés, lejátszás, bemutató vége; kérdésben mégsem",
        "stop a search or a show; cancel a question",
    ),
);

pub(crate) const LOGO: Words = Words("Emőke játéka", "Emőke's game");
pub(crate) const GOAL: Words = Words("   Cél", "  Goal");
pub(crate) const ASK_START: Words = Words("Hány lépés?", "How many moves?");
/// The presets of the first question; the rest is under P.
pub(crate) const START: [(Hot, Option<Difficulty>); 5] = [
    (Hot::new('4', "", ""), Some(Difficulty::Four)),
    (Hot::new('8', "", ""), Some(Difficulty::Eight)),
    (Hot::new('1', "6", "6"), Some(Difficulty::Sixteen)),
    (Hot::new('K', "önyv", "-book"), Some(Difficulty::Book)),
    (Hot::new('T', "-fájl", "-file"), None),
];
pub(crate) const DRAG: KeyHelp = (
    Words("egér", "mouse"),
    Words("gyűrű, fiók húzása; kattintás a fiókra: betolás", "drag a ring or a drawer; click to push it"),
);

/// What can be done at the start of a problem.
pub(crate) const BEGIN: Words = Words(
    "Húzza a gyűrűket, tolja a fiókokat (A-F, I-N). H: segítség",
    "Drag rings, push drawers (or A-F, I-N). H: a hint",
);
pub(crate) const GO_ON: Words =
    Words("H: segítség, F6: elölről, F1: a szabályok", "H: a hint, F6: restart, F1: the rules");
pub(crate) const FREE: Words =
    Words("Próbálja ki! F7: új játék, P: szint és szám", "Try it out! F7: new game, P: level and number");
pub(crate) const AGAIN: Words =
    Words("F7: új játék, P: nehezebb, F6: még egyszer", "F7: new game, P: a harder one, F6: once more");

/// A drawer that cannot be pushed in any further.
pub(crate) fn is_in(drawer: Move, opposite: Move) -> Phrase {
    let (letter, other) = (drawer.letter(), opposite.letter());
    let article = if matches!(letter, 'A' | 'E' | 'F') { "Az" } else { "A" };
    Phrase::new(
        format!("{article} {letter} fiók már bent van; kijön, ha a szemköztit tolja: {other}"),
        format!("Drawer {letter} is in; push the opposite one, {other}, to bring it out"),
    )
}

/// What a hinted move is.
pub(crate) fn do_this(a_move: Move) -> Phrase {
    let letter = a_move.letter();
    Phrase::new(
        format!("Nyomja le: {letter}, vagy kattintson a zöld körre"),
        format!("Press {letter}, or click in the green circle"),
    )
}

pub(crate) const ASK_GAME: Words = Words("       Konfiguráció ?", "      Configuration ?");
pub(crate) const PLAY: Hot = Hot::new('J', "áték", "-game");
pub(crate) const LEARN: Hot = Hot::new('T', "anulás", "-learn");
pub(crate) const DEMONSTRATION: Hot = Hot::new('X', "-bemut.", "-demo");
pub(crate) const QUIT: Hot = Hot::new('Q', "-kilép", "-quit");

pub(crate) const ASK_DIFFICULTY: Words = Words("Hány lépésre a megoldástól ?", "How many moves away?");
pub(crate) const DIFFICULTIES: [(Hot, Difficulty); 5] = [
    (Hot::new('4', "", ""), Difficulty::Four),
    (Hot::new('8', "", ""), Difficulty::Eight),
    (Hot::new('1', "6", "6"), Difficulty::Sixteen),
    (Hot::new('K', "önyv", "-book"), Difficulty::Book),
    (Hot::new('V', "életlen", "-any"), Difficulty::Any),
];
pub(crate) const NUMBER: Words = Words("Sorszám:", "Number:");

pub(crate) const IS_SOLVED: Words = Words("Már ki van rakva", "Already solved");
pub(crate) const NO_WHEEL: Words =
    Words("ebben a fájlban nincs gyöngykerék", "this file holds no bead wheel; there should be a .GYK");
pub(crate) const SEARCH: Words = Words("Keresés      Esc - elég", "Searching    Esc - stop");
pub(crate) const SHOWN: Words = Words("Bemutató", "Demonstration");
pub(crate) const TAKE_OVER: Words = Words("Esc - átveszem", "Esc - take over");
pub(crate) const ESC_BACK: Words = Words("Esc - vissza", "Esc - back");
pub(crate) const SOLVED: Words = Words("Kirakva!", "Solved!");

/// The moves and the time of a game.
pub(crate) fn score(moves: u32, time: Duration, language: Language) -> String {
    let [moved, took] = [Words("Lépés:", "Moves:"), Words("Idő:", "Time:")].map(|it| it.of(language));
    format!("{moved} {moves}   {took} {}", Stopwatch::text(time))
}

/// Which problem it is.
pub(crate) fn problem(problem: Problem, language: Language) -> String {
    let word = Words("Feladat:", "Problem:").of(language);
    let name = match problem.difficulty {
        Difficulty::Four => "4",
        Difficulty::Eight => "8",
        Difficulty::Sixteen => "16",
        Difficulty::Book => Words("könyv", "book").of(language),
        Difficulty::Any => Words("véletlen", "any").of(language),
    };
    format!("{word} {name} / {}", problem.number)
}

/// The next move.
pub(crate) fn hint(a_move: Move, language: Language) -> String {
    format!("{} {}", Words("Segítség:", "Hint:").of(language), a_move.letter())
}

/// How far a search is.
pub(crate) fn progress(progress: &Progress, language: Language) -> String {
    let best = progress.best.map_or_else(|| "-".to_string(), |best| best.to_string());
    let [least, found] = [Words("legalább", "at least"), Words("eddig", "so far")].map(|it| it.of(language));
    format!("{least} {}, {found} {best}", progress.at_least)
}

/// The solution that is being played.
pub(crate) fn solution(count: usize, proven: bool, language: Language) -> [String; 2] {
    let proof = match proven {
        true => Words("ennél rövidebb nincs", "none is shorter"),
        false => Words("talán van rövidebb", "there may be a shorter one"),
    };
    let words = Words("Megoldás: lépés:", "Solution: moves:");
    [format!("{} {count}", words.of(language)), proof.of(language).to_string()]
}
