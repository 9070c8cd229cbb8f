//! GYONGY_K as its user sees it: the originals' screens, moves, undo, hints, solutions, the demonstration, saved
//! positions, random input.

mod common;

use common::reference::Allowance;
use common::{Kept, pictures, play_script, play_today, random, reference};
use grafika::file::{Document, Format};
use grafika::machine::{Best, Bests, Machine, Manner, Memory, Script, Settings, Storage, play};
use grafika::programs::gyongy_k::PROGRAM;
use grafika::puzzle::wheel::{Move, Wheel, moves_from_text};
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    reference::assert_screens_each(PROGRAM, "reference/games", "GYONGY_K_", 9, |screen| match screen {
        // Beads of a random problem: no two runs of the original have the same.
        "GYONGY_K_mouse_click_J" => Allowance::Agreement(0.94),
        // The original has left its lines thick here: frames of questions and buttons.
        "GYONGY_K_q_new_or_stored" | "GYONGY_K_q_newconf" | "GYONGY_K_q_save" => Allowance::Agreement(0.97),
        _ => Allowance::Agreement(0.985),
    });
}

/// Plays a script from the solved wheel.
fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("key T\n{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

fn shown(script: &str) -> Wheel {
    model(script)["shown"].as_str().unwrap().parse().unwrap()
}

/// The wheel after some letters, by the rules alone.
fn wheel(letters: &str) -> Wheel {
    Wheel::solved().after_all(&moves_from_text(letters).unwrap())
}

fn keys(letters: &str) -> String {
    letters.chars().map(|letter| format!("key {letter}\n")).collect()
}

#[test]
fn letters_and_clicks_make_moves() {
    assert_eq!(shown(&keys("MCEMAAJLN")), wheel("MCEMAAJLN"));
    assert_eq!(shown("click 322 118"), wheel("A"));
    assert_eq!(shown("click 536 360\nclick 432 360"), wheel("JM"));
    // A handle moves with its drawer, and a held button makes one move.
    assert_eq!(shown("move 404 260\npress left\nwait 3000\nrelease left"), wheel("F"));
    assert_eq!(shown("click 404 260\nclick 372 260"), wheel("FF"));
    // Special keys are no letters.
    assert_eq!(shown("key Left\nkey Right\nkey PageUp\nkey F7\nkey F8"), wheel(""));
}

#[test]
fn a_move_that_is_not_possible_counts_nothing() {
    assert_eq!(model("key A")["game"]["moves"], 1);
    assert_eq!(model("key A\nkey A")["game"], model("key A")["game"]);
}

#[test]
fn moves_are_undone_redone_and_begun_again() {
    let made = model(&keys("MCEM"));
    let undone = model(&format!("{}key Ctrl+Z\nkey Ctrl+Z", keys("MCEM")));
    assert_eq!(undone["game"], model(&keys("MC"))["game"]);
    assert_eq!(model(&format!("{}key Ctrl+Z\nkey Ctrl+Y", keys("MCEM")))["game"], made["game"]);
    assert_eq!(shown(&format!("{}key R", keys("MCEM"))), wheel(""));
    assert_eq!(model(&format!("{}key R\nkey Ctrl+Z", keys("MCEM")))["game"], made["game"]);
}

#[test]
fn the_clock_runs_from_the_first_move_until_solved() {
    assert_eq!(model("wait 9000")["seconds"], 0);
    assert_eq!(model("key A\nwait 9000")["seconds"], 9);
    assert_eq!(model("key A\nwait 9000\nkey D\nwait 9000")["seconds"], 9);
    assert_eq!(model("key A\nwait 2000\nkey F1\nwait 9000\nkey Esc\nwait 1000")["seconds"], 3);
}

#[test]
fn the_demonstration_goes_back_to_solved_and_leaves_the_game_alone() {
    let before = model(&keys("MC"));
    let demonstration = format!("{}key X\n", keys("MC"));
    let begun = model(&demonstration);
    assert_eq!(begun["show"], "demonstration");
    assert_eq!(begun["shown"], model(&format!("{demonstration}wait 2990"))["shown"]);
    assert_ne!(begun["shown"], model(&format!("{demonstration}wait 3010"))["shown"]);
    let mut waited = 0;
    let solved = (0..120).find(|step| {
        waited = 3010 + 600 * step;
        shown(&format!("{demonstration}wait {waited}")).is_solved()
    });
    assert!(solved.is_some());
    assert_eq!(model(&format!("{demonstration}wait {}", waited + 2900))["show"], "demonstration");
    let after = model(&format!("{demonstration}wait {}", waited + 3100));
    assert_eq!((&after["show"], &after["shown"]), (&"none".into(), &before["shown"]));
    for stop in ["key Esc", "key A", "click 404 260"] {
        assert_eq!(model(&format!("{demonstration}wait 5000\n{stop}"))["game"], before["game"]);
    }
}

#[test]
fn a_hint_is_shown_and_not_made() {
    let hinted = model(&format!("{}key H\nwait 5000", keys("MCEM")));
    assert_eq!(hinted["shown"], model(&keys("MCEM"))["shown"]);
    let letter = hinted["hint"].as_str().unwrap();
    assert!(shown(&keys(&format!("MCEM{letter}"))) != wheel("MCEM"));
    assert_eq!(model(&format!("{}key H\nwait 5000\nkey I", keys("MCEM")))["hint"], Value::Null);
    assert_eq!(model("key H")["show"], "none", "there is nothing to hint");
}

#[test]
fn a_solution_is_played_and_can_be_taken_over() {
    let script = format!("{}key S\nwait 8000\n", keys("MCEM"));
    let solved = model(&script);
    assert_eq!((&solved["solved"], &solved["game"]["moves"]), (&true.into(), &8.into()));
    // The search takes a while; two of the four moves later it is stopped.
    let stopped = model(&format!("{}key S\nwait 2000\nkey Esc\nwait 9000", keys("MCEM")));
    let moves = stopped["game"]["moves"].as_u64().unwrap();
    assert!((5..8).contains(&moves) && stopped["show"] == "none", "{stopped}");
    let taken_over = model(&format!("{}key S\nwait 2000\nkey I\nwait 9000", keys("MCEM")));
    assert_eq!(taken_over["game"]["moves"], moves + 1);
    let undone = model(&format!("{script}{}", "key Ctrl+Z\n".repeat(4)));
    assert_eq!(undone["shown"], model(&keys("MCEM"))["shown"]);
}

#[test]
fn esc_stops_a_search() {
    let start = "key U\nkey V\nkey 7\nkey Enter\n";
    assert_eq!(model(&format!("{start}key S\nwait 50"))["show"], "search");
    assert_eq!(model(&format!("{start}key S\nwait 50\nkey Esc\nwait 100"))["show"], "none");
    assert_eq!(model(&format!("{start}key S\nwait 50\nkey Esc"))["game"], model(start)["game"]);
}

#[test]
fn a_problem_has_a_number_and_a_difficulty() {
    let problem = |keys: &str| model(&format!("key U\n{keys}"));
    let eight = problem("key 8\ntype 123\nkey Enter");
    assert_eq!(eight["shown"], problem("key 8\ntype 123\nkey Enter")["shown"]);
    assert_ne!(eight["shown"], problem("key 8\ntype 124\nkey Enter")["shown"]);
    assert_ne!(eight["shown"], problem("key 4\ntype 123\nkey Enter")["shown"]);
    assert_eq!(eight["unsaved"], true);
    for cancelled in ["key Esc", "key 8\nkey Esc"] {
        assert_eq!(problem(cancelled)["game"], model("")["game"]);
    }
}

#[test]
fn a_saved_position_is_the_dos_programs() {
    let script = format!("{}key Ctrl+S\ntype akb\nkey Enter", keys("MC"));
    assert_eq!(model(&script)["unsaved"], false);
    let mut disk = Memory::default();
    let akb = std::fs::read(common::path("files/AKB.GYK")).unwrap();
    disk.write("AKB.GYK", &akb).unwrap();
    let opened = play_script(PROGRAM, disk, "key J\nkey T\ntype akb\nkey Enter\ndump end.json\n");
    let Document::BeadWheel(wheel) = Document::read(Format::Gyk, &akb).unwrap() else { panic!() };
    let wheel = Wheel::try_from(&wheel).unwrap();
    assert_eq!(opened.models["end.json"]["shown"], wheel.to_string());
}

#[test]
fn an_impossible_position_is_refused() {
    let good = std::fs::read(common::path("files/AKB.GYK")).unwrap();
    let mut wrong: Vec<Vec<u8>> = vec![vec![], good[..36].to_vec(), [&good[..], &[0]].concat()];
    for (place, byte) in [(0, 11), (0, 15), (30, 9), (31, 3), (31, 0), (36, 0xff), (29, 9), (18, 15)] {
        let mut damaged = good.clone();
        damaged[place] = byte;
        wrong.push(damaged);
    }
    for content in wrong {
        let mut disk = Memory::default();
        disk.write("X.GYK", &content).unwrap();
        let script = "key J\nkey T\ntype x\nkey Enter\nwait 2100\nkey T\ntype x\nkey Enter\nshot end.png\ndump end.json\n";
        let kept = play_script(PROGRAM, disk, script);
        assert_eq!(kept.models["end.json"]["shown"], Wheel::solved().to_string(), "{content:?}");
        // Still asked for: no beads in the picture.
        assert_ne!(kept.pictures["end.png"].pixel(240, 260), run("").pictures["end.png"].pixel(240, 260));
    }
}

#[test]
fn the_end_is_asked_for_and_nothing_is_lost() {
    let ended = |script: &str| {
        let mut session = common::session(PROGRAM, Memory::default(), Default::default());
        play(&mut session, &Script::parse(script).unwrap(), &mut Kept::default()).unwrap();
        session.ended()
    };
    assert!(ended("close") && ended("key T\nclose"));
    assert!(!ended("key T\nkey A\nclose") && !ended("key T\nkey A\nclose\nclose"));
    assert!(ended("key T\nkey A\nclose\nkey N") && !ended("key T\nkey A\nclose\nkey Esc"));
    assert!(ended("key T\nkey Q\nkey N\nkey I") && !ended("key T\nkey Q\nkey N\nkey N\nkey N"));
    assert!(ended("key T\nkey A\nkey S\nclose\nkey N") && ended("key J\nkey U\nkey X\nclose"));
}

#[test]
fn golden_pictures() {
    let problem = "key U\nkey V\ntype 42\nkey Enter\n";
    let cases = [
        ("gyongy_k_solved", "key A\nwait 3000\nkey D".to_string()),
        ("gyongy_k_out", keys("ABC")),
        ("gyongy_k_in", keys("DEF")),
        ("gyongy_k_problem", format!("{problem}key A\nwait 61000")),
        ("gyongy_k_difficulty", "key U".to_string()),
        ("gyongy_k_number", "key U\nkey 8\ntype 12".to_string()),
        ("gyongy_k_search", format!("{problem}key S\nwait 2000")),
        ("gyongy_k_hint_drawer", format!("{}key H\nwait 5000", keys("AK"))),
        ("gyongy_k_hint_ring", format!("{}key H\nwait 5000", keys("MCEM"))),
        ("gyongy_k_playing", format!("{}key S\nwait 2000", keys("MCEM"))),
        ("gyongy_k_demonstration", "key X\nwait 4000".to_string()),
        ("gyongy_k_english", format!("key F2\n{problem}key X")),
        ("gyongy_k_help", "key F1".to_string()),
        ("gyongy_k_help_english", "key F1\nkey F2".to_string()),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &run(&script).pictures["end.png"]);
    }
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    random::assert_replays(PROGRAM, &format!("key T\n{}", random::script(7, random::part(500))));
    random::assert_replays(PROGRAM, "key T\nkey A\nkey K\nkey S\nwait 2345\n");
}

/// Random events; `GRAFIKA_EVENTS` says how many.
#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
}

/// The end of a script in the manner of today.
fn today(script: &str) -> Kept {
    play_today(PROGRAM, &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn today_model(script: &str) -> Value {
    today(script).models["end.json"].clone()
}

#[test]
fn golden_pictures_of_today() {
    let cases = [
        ("gyongy_k_today_first", String::new()),
        ("gyongy_k_today_begin", "key F2\nkey Enter".to_string()),
        ("gyongy_k_today_ring", "key Enter\nmove 330 260\npress left\nmove 325 290".to_string()),
        ("gyongy_k_today_drawer", "key Esc\nmove 400 260\npress left\nmove 386 260".to_string()),
        ("gyongy_k_today_solution", "key Enter\nkey O\nwait 9000".to_string()),
        ("gyongy_k_today_help", "key Enter\nkey F1".to_string()),
        // The last of the palettes is for the colour-blind: the beads have signs.
        (
            "gyongy_k_today_signs",
            format!("key Enter\nkey F9\n{}key Left\nkey Esc\nmove 20 20", "key Down\n".repeat(5)),
        ),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &today(&script).pictures["end.png"]);
    }
}

#[test]
fn a_wheel_of_four_moves_is_played_to_its_end() {
    let mut script = "key Enter\n".to_string();
    for step in 0..4 {
        let hinted = today_model(&format!("{script}key H\nwait 5000"));
        let letter = hinted["hint"].as_str().expect("there is a hint").to_owned();
        script += &format!("key {letter}\n");
        if step == 1 {
            let there = today_model(&script);
            assert_ne!(today_model(&format!("{script}key Ctrl+Z"))["game"], there["game"]);
            script += "key Ctrl+Z\nkey Ctrl+Y\n";
            assert_eq!(today_model(&script)["game"], there["game"]);
        }
    }
    let end = today_model(&script);
    assert_eq!((&end["solved"], &end["game"]["moves"]), (&true.into(), &4.into()));
    assert_eq!(end["game"]["help"], "none");
    // The celebration comes to its end, and nothing moves any more.
    let at = |wait: u32| today(&format!("{script}wait {wait}")).pictures["end.png"].pixels().to_vec();
    assert!(at(500) != at(800) && at(3000) == at(60_000));
    pictures::assert_golden(
        "gyongy_k_today_sparks",
        &today(&format!("{script}wait 900")).pictures["end.png"],
    );
    // A hint is told, and a solution of the machine counts as none.
    let hinted = today_model("key Enter\nkey H\nwait 5000\nkey I");
    assert_eq!(hinted["game"]["help"], "hints");
    assert_eq!(today_model("key Enter\nkey O\nwait 9000")["game"]["help"], "solution");
}

#[test]
fn every_drag_is_a_legal_move_and_undo_brings_the_wheel_back() {
    let mut dice = random::Dice::new(25);
    let mut dragged = 0;
    for _ in 0..80 {
        let mut number = |low: i32, high: i32| low + dice.below((high - low) as u64) as i32;
        let letters: String = (0..6).map(|_| Move::ALL[number(0, 12) as usize].letter()).collect();
        let before = format!("key Esc\n{}", keys(&letters));
        let mut place = || (number(60, 420), number(80, 440));
        let [(x, y), (x1, y1), (x2, y2)] = [place(), place(), place()];
        let drag =
            format!("{before}move {x} {y}\npress left\nmove {x1} {y1}\nmove {x2} {y2}\nrelease left\n");
        let [was, is] = [&before, &drag].map(|script| today_model(script));
        let made = is["game"]["moves"].as_u64().unwrap() - was["game"]["moves"].as_u64().unwrap();
        let wheel = |model: &Value| model["shown"].as_str().unwrap().parse::<Wheel>().unwrap();
        let mut reached = vec![wheel(&was)];
        for _ in 0..made {
            let next = |wheel: &Wheel| Move::ALL.map(|a_move| wheel.after(a_move));
            reached = reached.iter().flat_map(next).flatten().collect();
            reached.sort_unstable();
            reached.dedup();
        }
        assert!(reached.contains(&wheel(&is)), "{drag}");
        if made > 0 {
            dragged += 1;
            assert_eq!(today_model(&format!("{drag}key Ctrl+Z"))["game"], was["game"], "{drag}");
        }
        // A key puts everything back.
        let given_up = drag.replace("release left", "key Esc\nrelease left");
        assert_eq!(today_model(&given_up)["game"], was["game"], "{given_up}");
    }
    assert!(dragged > 20, "{dragged}");
}

#[test]
fn a_second_click_on_a_drawer_works_where_the_first_one_did() {
    let twice = today_model("key Esc\nkey C\nclick 396 260\nclick 396 260");
    assert_eq!(twice["shown"], wheel("CFF").to_string());
    assert_eq!(twice["game"]["moves"], 3);
}

#[derive(Clone, Default)]
struct Shelf(Rc<RefCell<BTreeMap<String, Best>>>);

impl Bests for Shelf {
    fn best(&self, game: &str) -> Option<Best> {
        self.0.borrow().get(game).copied()
    }

    fn keep(&mut self, game: &str, result: Best) -> Result<(), String> {
        self.0.borrow_mut().insert(game.to_owned(), result);
        Ok(())
    }
}

#[test]
fn the_best_result_is_kept_unless_the_machine_has_helped() {
    let kept = |script: &str| {
        let shelf = Shelf::default();
        let settings = Settings { manner: Manner::Today, ..Settings::default() };
        let machine = Machine::new(Box::new(Memory::default()), settings).with_bests(shelf.clone());
        let mut session = common::session_on(PROGRAM, machine, None);
        play(&mut session, &Script::parse(script).unwrap(), &mut Kept::default()).unwrap();
        shelf.0.take()
    };
    let solution = |script: &str| {
        let mut script = script.to_owned();
        while today_model(&script)["solved"] == false {
            let hint = today_model(&format!("{script}key H\nwait 5000"))["hint"].clone();
            script += &format!("key {}\n", hint.as_str().unwrap());
        }
        script
    };
    let solved = solution("key Enter\n");
    assert_eq!(kept(&solved)["gyongy_k four"], Best { moves: 4, seconds: 0 });
    assert!(kept("key Enter\nkey O\nwait 9000\n").is_empty());
    assert!(kept(&solved.replacen("key Enter\n", "key Enter\nkey H\nwait 5000\n", 1)).is_empty());
}
