//! CSANGO_K as its user sees it: the originals' screens, moves by keys and mouse, undo, hint, solution, files,
//! random input.

mod common;

use common::{Kept, pictures, play_script, play_today, random};
use grafika::file::{Document, Format};
use grafika::machine::{Memory, Script, Storage, play};
use grafika::programs::csango_k::PROGRAM;
use grafika::puzzle::cube::{Action, CsangoCube, Move, Rules, Way};
use serde_json::Value;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    common::reference::assert_screens(PROGRAM, "reference/games", "CSANGO_K_", 13);
}

/// Plays a script from the start position; the end is kept as `end`.
fn run(script: &str) -> Kept {
    run_on(Memory::default(), &format!("key U\n{script}"))
}

fn run_on(disk: Memory, script: &str) -> Kept {
    play_script(PROGRAM, disk, &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

fn state(script: &str) -> String {
    model(script)["state"].as_str().expect("it is a text").to_string()
}

fn position(model: &Value) -> CsangoCube {
    model["state"].as_str().expect("it is a text").parse().expect("a legal position")
}

/// A position half way to the finished cube.
const HALF: &str = "key F5\nwait 8000\nkey Esc\n";

#[test]
fn golden_pictures() {
    let cases = [
        ("csango_hint", "key F4\nwait 1000".to_string()),
        ("csango_playing", "key F5\nwait 8000".to_string()),
        ("csango_half", format!("{HALF}key Down\nwait 3000")),
        ("csango_finished", "key F5\nwait 60000".to_string()),
        ("csango_from_above", format!("{HALF}key Down\nkey Down\nwait 3000")),
        ("csango_behind", format!("{HALF}{}wait 3000", "key Left\n".repeat(5))),
        ("csango_scrambled", "key F7\nkey Left".to_string()),
        ("csango_scrambled_above", "key F7\nkey F7\nkey Down\nkey Down\nkey Right".to_string()),
        ("csango_rigid", "key F3\nkey 1\nkey 4\nkey Z\nkey R\nwait 3000".to_string()),
        ("csango_english", "key F2\nkey Z\nwait 65000".to_string()),
        ("csango_end", "key Q".to_string()),
        ("csango_help", "key F1".to_string()),
        ("csango_help_english", "key F1\nkey F2".to_string()),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &run(&script).pictures["end.png"]);
    }
}

#[test]
fn pieces_are_chosen_by_letter_number_and_click() {
    let piece = |script: &str| model(script)["piece"].clone();
    assert_eq!(piece(""), 1);
    assert_eq!([piece("key A"), piece("key B"), piece("key 7")], [2, 14, 7]);
    assert_eq!([piece("key 1\nkey 2"), piece("key 1\nwait 1500\nkey 2"), piece("key 9\nkey 9")], [12, 2, 9]);
    assert_eq!(piece("click 200 420"), 5);
    assert_eq!(piece("click 200 100"), 1, "the field is no piece");
    assert_eq!(piece("click 506 200"), 1, "nor is its edge");
    assert_eq!([piece("click 536 55"), piece("click 615 55")], [2, 14]);
}

#[test]
fn buttons_do_what_their_letters_do() {
    let buttons = [('Z', 547, 395), ('W', 602, 395), ('V', 602, 265), ('T', 547, 445), ('X', 547, 135)];
    for (letter, x, y) in buttons {
        let before = "key Z\nkey V\n";
        assert_eq!(
            state(&format!("{before}key {letter}")),
            state(&format!("{before}click {x} {y}")),
            "{letter}"
        );
    }
    assert_ne!(state("key Z"), state(""));
    assert_eq!(model("key Down\nkey Left")["eye"], model("click 9 270\nclick 240 471")["eye"]);
}

#[test]
fn moves_are_counted_undone_and_redone() {
    assert_eq!(model("key Z\nkey V\nkey X")["moves"], 3);
    assert_eq!(model("key X")["moves"], 0, "a refused move is none");
    let before = "key Z\nkey V\n";
    assert_eq!(state(&format!("{before}key Ctrl+Z\nkey Ctrl+Z")), state(""));
    assert_eq!(state(&format!("{before}key Ctrl+Z\nkey Ctrl+Y")), state(before));
    assert_eq!(state(&format!("{before}key F6")), state(""));
    assert_eq!(state(&format!("{before}key F6\nkey Ctrl+Z")), state(before));
    assert_ne!(state("key F7"), state(""));
}

#[test]
fn rigid_turns_go_through_nothing() {
    assert_ne!(state("key R"), state(""));
    assert_eq!(state("key F3\nkey R"), state(""), "through the table");
    assert_eq!(model("key F3")["rigid"], true);
    assert_ne!(state("key F3\nkey Z\nkey Z\nkey R"), state("key Z\nkey Z"));
}

#[test]
fn a_piece_is_dragged_and_lifted() {
    // Seen from above, x and y are in the plane that faces the viewer.
    let above = "key Down\nkey Down\n";
    let dragged =
        model(&format!("{above}key 1\nkey 4\nmove 150 245\npress left\nmove 190 245\nrelease left"));
    println!("{}", dragged["state"]);
    let lifted = position(&model("key 5\nwheel 3"));
    assert_eq!(lifted.pieces[4].cell, [9, 0, 3]);
    assert_eq!(model("key 5\nwheel 3")["moves"], 3);
    assert_eq!(position(&model("key 5\nwheel 99")).pieces[4].cell, [9, 0, 5]);
    // From the front, y and z are.
    let up = "move 200 420\npress left\nmove 200 340\n";
    let held = position(&model(&format!("{up}release left")));
    assert_eq!(held.pieces[4].cell, [9, 0, 3]);
    assert_eq!(state(&format!("{up}key Esc\nrelease left")), state(""));
    assert_eq!(state(&format!("{up}release left\nkey Ctrl+Z")), state(""));
    assert_eq!(state(&format!("{up}move 200 420\nrelease left")), state(""));
}

#[test]
fn the_hint_is_shown_and_not_made() {
    let hinted = model("key F4\nwait 1000");
    assert_eq!((&hinted["moves"], hinted["hint"].is_string()), (&0.into(), true));
    let text = hinted["hint"].as_str().unwrap();
    let letter = &text[text.len() - 1..];
    // The hinted piece is chosen; its move leads to the next hint at once.
    let next = model(&format!("key F4\nwait 1000\nkey {letter}\nkey F4"));
    assert_eq!(next["moves"], 1);
    assert!(next["hint"].is_string());
}

#[test]
fn the_solution_is_played_stopped_and_taken_over() {
    let whole = model("key F5\nwait 60000");
    assert_eq!((&whole["finished"], &whole["task"]), (&true.into(), &"idle".into()));
    assert!((80..200).contains(&whole["moves"].as_u64().unwrap()), "{}", whole["moves"]);
    let half = model(HALF);
    assert_eq!((&half["finished"], &half["task"]), (&false.into(), &"idle".into()));
    assert_eq!(model(&format!("{HALF}wait 5000"))["state"], half["state"]);
    assert_eq!(model(&format!("{HALF}key F5\nwait 60000"))["finished"], true);
    assert_eq!(model("key F3\nkey F5\nwait 60000")["finished"], true, "rigid turns");
    let moves = half["moves"].as_u64().unwrap() as usize;
    assert_eq!(state(&format!("{HALF}{}", "key Ctrl+Z\n".repeat(moves))), state(""));
    assert_eq!(model("key F7\nkey F5\nwait 120000")["finished"], true, "from a scramble");
}

fn disk() -> Memory {
    common::storage("reference/games", &["SOL1.CSK"])
}

#[test]
fn positions_are_saved_and_loaded() {
    let kept = run_on(
        disk(),
        "key T\ntype SOL1\nkey Enter\ndump sol.json\nkey Ctrl+S\ntype COPY\nkey Enter\nkey Q\nkey N\nkey N\nkey I\nkey T\ntype COPY\nkey Enter",
    );
    assert_eq!(kept.models["sol.json"]["finished"], true);
    assert_eq!(kept.models["end.json"]["state"], kept.models["sol.json"]["state"]);
    let sample = run_on(Memory::default(), "key T\ntype A\nkey Enter");
    assert_eq!(sample.models["end.json"]["finished"], true);
}

#[test]
fn impossible_files_are_refused() {
    let mut disk = disk();
    let good = disk.read("SOL1.CSK").unwrap();
    let mut shared = good.clone();
    shared.copy_within(0..1216, 8 * 1216); // piece 9 is of the same type, and on the same cells then
    for (number, bytes) in
        [good[..17023].to_vec(), vec![0; 17024], vec![0xFF; 17024], shared].iter().enumerate()
    {
        disk.write("X.CSK", bytes).unwrap();
        let kept = run_on(disk.clone(), "key T\ntype X\nkey Enter\nkey U");
        assert_eq!(kept.models["end.json"]["state"], Value::from(state("")), "{number}");
    }
}

#[test]
fn a_finished_cube_comes_apart_and_together_by_moves_alone() {
    let bytes = disk().read("SOL1.CSK").unwrap();
    let Ok(Document::CsangoCube(finished)) = Document::read(Format::Csk, &bytes) else { panic!("a cube") };
    let filling = finished.filling().expect("it is finished");
    let start = CsangoCube::start();
    for rules in [Rules::Book, Rules::Rigid] {
        let moves = Way::new(&start, &filling, rules).and_then(Way::finish).unwrap();
        println!("{rules:?}: {} moves", moves.len());
        let together = start.after_all(&moves, rules).unwrap();
        assert!(together.is_finished());
        let apart: Vec<Move> = moves.iter().rev().map(|step| step.reverse()).collect();
        assert_eq!(together.after_all(&apart, rules), Ok(start));
        // A list without its first move is found out.
        assert_ne!(together.after_all(&apart[1..], rules), Ok(start));
        // From where the file has the cube, one cell aside.
        let aside = Way::new(&finished, &filling, rules).and_then(Way::finish).unwrap();
        assert!(finished.after_all(&aside, rules).unwrap().is_finished());
    }
}

#[cfg(feature = "native")]
#[test]
fn the_command_line_counts_the_same_on_any_number_of_threads() {
    let grafika = |arguments: &[&str]| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_grafika")).args(arguments).output();
        let output = output.unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let bytes = disk().read("SOL1.CSK").unwrap();
    let Ok(Document::CsangoCube(finished)) = Document::read(Format::Csk, &bytes) else { panic!("a cube") };
    let filling = finished.filling().expect("it is finished");
    let mut cube = CsangoCube::start();
    let moves = Way::new(&cube, &filling, Rules::Book).and_then(Way::finish).unwrap();
    for step in moves {
        cube = cube.after_all(&[step], Rules::Book).unwrap();
        if cube.placed().len() == 4 {
            break;
        }
    }
    let number = grafika::puzzle::cube::Count::with_fixed(&cube.placed()).total();
    assert!(number > 0);
    let expected = format!("{number} fillings, 4 of the pieces in their places\n");
    for threads in ["1", "2", "3"] {
        assert_eq!(grafika(&["solve", &cube.to_string(), "--count", "--threads", threads]), expected);
    }
    // A finished cube is one filling wherever it stands.
    for corner in [[3, 2, 0], [4, 2, 0], [0, 0, 0], [6, 6, 3]] {
        let full = filling.position(corner).unwrap().to_string();
        assert_eq!(grafika(&["solve", &full, "--count"]), "1 filling, 14 of the pieces in their places\n");
    }
    // A piece that goes a cell out of the finished cube sticks out of it.
    let full = filling.position([3, 2, 0]).unwrap();
    let steps = (0..14).flat_map(|piece| Action::ALL.map(|action| Move { piece, action }));
    let mut out = steps.filter(|step| step.action.step().is_some());
    let (piece, cube) = out.find_map(|step| Some((step.piece, full.after(step, Rules::Book).ok()?))).unwrap();
    assert_eq!(cube.sticking_out(), [piece]);
    let text = grafika(&["solve", &cube.to_string(), "--count"]);
    let told = format!(
        "1 filling, 13 of the pieces in their places\npiece {} lies partly in the cube's place and was not counted\n",
        piece + 1
    );
    assert_eq!(text, told);
}

#[cfg(feature = "native")]
#[test]
fn the_command_line_solves_with_rigid_turns_and_counts_from_nothing() {
    let start = CsangoCube::start();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_grafika"));
    let output = command.args(["solve", &start.to_string(), "--rigid"]).output().unwrap();
    let text = String::from_utf8(output.stdout.clone()).unwrap();
    let (number, list) = text.split_once(" moves\n").unwrap_or_else(|| panic!("{output:?}"));
    let step = |word: &str| {
        let (piece, letter) = word.split_at(word.len() - 1);
        let action = Action::from_letter(letter.chars().next().unwrap()).unwrap();
        Move { piece: piece.parse::<usize>().unwrap() - 1, action }
    };
    let moves: Vec<Move> = list.split_whitespace().map(step).collect();
    assert_eq!(moves.len().to_string(), number);
    assert!(moves.len() < 180, "{number}");
    assert!(start.after_all(&moves, Rules::Rigid).unwrap().is_finished());
    // The empty cube takes long to count; that it has begun is enough.
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_grafika"));
    let mut counting = command.args(["solve", "--count", "--threads", "1"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_secs(1));
    assert!(counting.try_wait().unwrap().is_none());
    counting.kill().unwrap();
    counting.wait().unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_grafika")).arg("solve").output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn the_end_is_asked_for_and_nothing_is_lost() {
    let ended = |script: &str| {
        let mut session = common::session(PROGRAM, Memory::default(), Default::default());
        play(&mut session, &Script::parse(script).unwrap(), &mut Kept::default()).unwrap();
        session.ended()
    };
    assert!(ended("close") && ended("key U\nclose"));
    assert!(!ended("key U\nkey Z\nclose") && ended("key U\nkey Z\nclose\nkey N"));
    assert!(ended("key U\nkey Q\nkey N\nkey I") && !ended("key U\nkey Q\nkey Esc"));
    assert!(!ended("key U\nkey F5\nwait 1000\nclose"));
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    random::assert_replays(PROGRAM, &random::script(7, random::part(500)));
    random::assert_replays(PROGRAM, &format!("key U\n{HALF}key F7\nkey F4\nwait 999\n"));
}

/// The end of a script in the manner of today.
fn today(script: &str) -> Kept {
    play_today(PROGRAM, &format!("{script}\nshot end.png\ndump end.json\n"))
}

#[test]
fn golden_pictures_of_today() {
    let cases = [
        ("csango_today_first", ""),
        ("csango_today_begin", "key F2\nkey Enter\nwait 3000"),
        ("csango_today_hint", "key Enter\nwait 3000\nkey H\nwait 3000"),
        ("csango_today_refused", "key Esc\nkey W"),
        ("csango_today_solution", "key Enter\nwait 3000\nkey O\nwait 20000"),
        ("csango_today_help", "key Enter\nkey F1"),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &today(script).pictures["end.png"]);
    }
}

#[test]
fn a_game_of_three_pieces_is_dealt_by_its_number() {
    let model = |script: &str| today(script).models["end.json"].clone();
    let dealt = model("key Enter\nwait 3000");
    assert_eq!((&dealt["task"], &dealt["moves"]), (&"idle".into(), &0.into()));
    assert_eq!(position(&dealt).placed().len(), 11);
    let typed = |number: u32| {
        let model = model(&format!("key Esc\nkey P\nkey 3\ntype {number}\nkey Enter\nwait 3000"));
        model["state"].as_str().unwrap().to_owned()
    };
    assert_eq!(typed(77), typed(77));
    assert_ne!(typed(77), typed(78));
    assert_eq!(model("key Enter\nwait 3000\nkey O\nwait 20000")["finished"], true);
    let moved = "key Enter\nwait 3000\nkey 1\nkey 0\nkey Z\n";
    assert_eq!(model(&format!("{moved}key F6"))["state"], dealt["state"]);
}

#[test]
fn every_drag_is_legal_and_undo_brings_the_position_back() {
    let mut dice = random::Dice::new(4);
    let mut dragged = 0;
    for _ in 0..40 {
        let mut number = |low: i32, high: i32| low + dice.below((high - low) as u64) as i32;
        let before = format!("key Esc\n{}", "key Down\n".repeat(number(0, 3) as usize));
        let mut place = || (number(90, 440), number(180, 440));
        let [(x, y), (x1, y1), (x2, y2)] = [place(), place(), place()];
        let drag =
            format!("{before}move {x} {y}\npress left\nmove {x1} {y1}\nmove {x2} {y2}\nrelease left\n");
        let model = |script: &str| today(script).models["end.json"].clone();
        let [was, is] = [&before, &drag].map(|script| model(script));
        assert_eq!(position(&is).fault(), None);
        if is["moves"] != 0 {
            dragged += 1;
            assert_eq!(model(&format!("{drag}key Ctrl+Z"))["state"], was["state"], "{drag}");
        }
    }
    assert!(dragged > 5, "{dragged}");
}

#[test]
fn the_field_is_empty_until_there_is_a_configuration_and_the_view_stays() {
    let field = |script: &str| {
        let kept = play_script(PROGRAM, Memory::default(), &format!("{script}shot end.png\n"));
        let screen = &kept.pictures["end.png"];
        let ink = |x, y| screen.pixel(x, y) != Some(grafika::screen::Color::White);
        (60..500).any(|x| (260..450).any(|y| ink(x, y)))
    };
    assert!(!field("") && field("key U\n") && !field("key U\nkey Q\nkey N\nkey N\nkey I\n"));
    let again = model("key Left\nkey Q\nkey N\nkey N\nkey I\nkey U");
    assert_eq!(again["eye"], model("key Left")["eye"]);
}

/// Random events, more of them with `GRAFIKA_EVENTS`; then a legal position, whatever was done.
#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
    for seed in 1..4 {
        let kept = run(&random::script(seed, random::share(random::SOME) / 10));
        // The program may have ended before; then there is no model.
        if let Some(model) = kept.models.get("end.json") {
            assert_eq!(position(model).fault(), None);
        }
    }
}

/// One key goes through the projections.
#[test]
fn projections_are_on_one_key() {
    let told = |keys: &str| model(keys)["eye"]["projection"].clone();
    let (one, two, three) = ("key L\n", "key L\nkey L\n", "key L\nkey L\nkey L\n");
    assert_eq!(["", one, two, three].map(told), ["central", "near", "parallel", "central"]);
    assert_eq!(told("key L\nkey Left\nkey Home"), "near", "Home is about the place, not the distance");
    let solved = "key F5\nwait 60000\n";
    for (name, keys) in [("csango_near", one), ("csango_parallel", two)] {
        pictures::assert_golden(name, &run(&format!("{solved}{keys}wait 3000")).pictures["end.png"]);
    }
}

/// The painter's steps: every step is in the dump, the last picture is the right one, and Esc leaves all as it was.
#[test]
fn the_painters_order_is_shown_step_by_step() {
    let painter = |script: &str| model(script)["painter"].clone();
    let begun = painter("key F8");
    let faces = begun["faces"].as_u64().unwrap();
    assert!(faces > 30 && begun["step"] == 0 && begun["left_out"].as_u64().unwrap() > 30, "{begun}");
    assert_eq!(painter("key F8\nkey Space\nkey Right\nkey Down\nkey Left")["step"], 2);
    assert_eq!(painter("key F8\nkey End")["step"].as_u64(), Some(faces + 1));
    assert_eq!(painter("key F8\nkey End\nkey Home")["step"], 0);
    assert_eq!(painter("key F8\nkey Esc"), Value::Null);
    // The book's scattered pieces that it paints wrongly: some face covers something nearer.
    let mixed = "key F7\nkey F7\nkey F7\n";
    let faults = painter(&format!("{mixed}key F8\nkey F8"));
    assert!(
        faults["spoils"].as_u64().unwrap() > 0 && faults["wrong_at_last"].as_u64().unwrap() > 0,
        "{faults}"
    );
    // Inside of the finished cube faces overlap in a circle, but its outside covers them.
    let solved = painter("key F5\nwait 60000\nkey F8\nkey End");
    assert_eq!(solved["wrong_at_last"], 0, "{solved}");
    let before = run(mixed);
    let after = run(&format!("{mixed}key F8\nkey F8\nkey X\nkey Esc"));
    assert_eq!(before.models["end.json"], after.models["end.json"], "no move is made meanwhile");
    assert!(before.pictures["end.png"] == after.pictures["end.png"]);
    for (name, script) in [
        ("csango_painter_begun", "key F8".to_owned()),
        ("csango_painter_half", format!("{mixed}key F8\n{}", "key Space\n".repeat(25))),
        ("csango_painter_fault", format!("{mixed}key F8\nkey F8")),
        ("csango_painter_end", format!("{mixed}key F2\nkey F8\nkey End")),
    ] {
        pictures::assert_golden(name, &run(&script).pictures["end.png"]);
    }
}
