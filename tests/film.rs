//! Ctrl+F12 as a user sees it: films that hold the very screens at their times, and are never lost.

mod common;

use grafika::programs::{gb_2d_ip, vjs};

use common::{Kept, Refusing, SharedDisk};
use grafika::machine::{Event, Key, Script, Session, Settings, Storage, play};
use grafika::screen::{Color, Screen};
use grafika::ui::Program;
use std::time::Duration;

const EDITOR: Program = gb_2d_ip::PROGRAM;
const ANIMATED: Program = vjs::PROGRAM;

fn play_on(program: Program, disk: impl Storage + 'static, script: &str) -> (Session, Kept) {
    let mut kept = Kept::default();
    let script = Script::parse(script).expect("the test's script is right");
    let mut session = common::session(program, disk, Settings::default());
    play(&mut session, &script, &mut kept).expect("the outlet takes all");
    (session, kept)
}

/// The frames of a film: whole screens, each with the time at which it ends, in hundredths of a second.
fn frames(film: &[u8]) -> Vec<(Vec<u8>, u32)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::Indexed);
    let mut decoder = options.read_info(film).expect("a GIF");
    assert_eq!((decoder.width(), decoder.height()), (640, 480));
    assert_eq!(decoder.global_palette(), Some(Color::ALL.map(Color::rgb).concat().as_slice()));
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
    let (mut screen, mut frames, mut end) = (vec![0; 640 * 480], Vec::new(), 0);
    while let Some(frame) = decoder.read_next_frame().expect("a whole GIF") {
        let [left, top, width] = [frame.left, frame.top, frame.width].map(usize::from);
        for (y, row) in frame.buffer.chunks_exact(width).enumerate() {
            screen[(top + y) * 640 + left..][..width].copy_from_slice(row);
        }
        assert!(frame.delay >= 2);
        end += u32::from(frame.delay);
        frames.push((screen.clone(), end));
    }
    frames
}

fn shown_at(frames: &[(Vec<u8>, u32)], time: u32) -> &[u8] {
    &frames.iter().find(|(_, end)| time < *end).expect("the film is as long").0
}

/// Points are taken out of the store, dragged, and a curve is drawn, with pauses.
const WORK: &str = "key U\nkey Ctrl+F12\nwait 2500\nshot 2500.png\ndrag 618 90 161 150\nwait 300\nshot 2800.png\n\
    drag 618 90 261 110\nwait 40\nshot 2840.png\ndrag 618 90 361 330\nwait 20\nshot 2860.png\n\
    type gn3\nwait 1000\nshot 3860.png\nkey Ctrl+F12\nwait 10\nshot end.png";

#[test]
fn a_film_is_the_screens_at_their_times() {
    let disk = SharedDisk::default();
    let (_, kept) = play_on(EDITOR, disk.clone(), WORK);
    assert_eq!(disk.names(), ["gb_2d_ip-1.gif"]);
    let frames = frames(&disk.file("gb_2d_ip-1.gif"));
    assert_eq!(frames.last().unwrap().1, 386);
    for (name, time) in [("2500", 249), ("2800", 279), ("2840", 283), ("2860", 285), ("3860", 385)] {
        let screen = &kept.pictures[&format!("{name}.png")];
        assert!(shown_at(&frames, time) == screen.pixels(), "{name}");
    }
    common::pictures::assert_golden("film_end", &kept.pictures["end.png"]);
}

#[test]
fn only_what_changes_is_in_a_frame_and_the_beginning_is_not_announced() {
    let disk = SharedDisk::default();
    let (_, kept) =
        play_on(EDITOR, disk.clone(), "key U\nshot a.png\nkey Ctrl+F12\nshot b.png\nwait 3000\nkey Ctrl+F12");
    let film = disk.file("gb_2d_ip-1.gif");
    let frames = frames(&film);
    assert_eq!((frames.len(), frames[0].1), (1, 300));
    assert!(frames[0].0 == kept.pictures["a.png"].pixels());
    common::pictures::assert_golden("film_begun", &kept.pictures["b.png"]);
    assert!(film.len() < 20_000, "{} bytes", film.len());
}

#[test]
fn the_same_script_gives_the_same_film() {
    let film = || {
        let disk = SharedDisk::default();
        play_on(ANIMATED, disk.clone(), "key Ctrl+F12\nkey Right\nwait 1003\nkey Up\nwait 998\nkey Ctrl+F12");
        disk.file("vjs-1.gif")
    };
    let first = film();
    assert!(first == film());
    let frames = frames(&first);
    // The last frame, which has just begun, is a whole one.
    assert!((200..=202).contains(&frames.last().unwrap().1));
    assert!((10..=100).contains(&frames.len()), "{} frames", frames.len());
}

#[test]
fn a_film_survives_the_end_the_close_button_and_the_display() {
    for end in ["key Q", "close", ""] {
        let disk = SharedDisk::default();
        let (session, _) = play_on(ANIMATED, disk.clone(), &format!("key Ctrl+F12\nwait 500\n{end}"));
        drop(session);
        assert_eq!(frames(&disk.file("vjs-1.gif")).last().unwrap().1, 50, "{end:?}");
    }
}

#[test]
fn films_have_free_names_and_go_on_over_the_help_page() {
    let disk = SharedDisk::default();
    let script = "key Ctrl+F12\nwait 100\nkey F1\nwait 200\nshot help.png\nkey Ctrl+F12\nkey Ctrl+F12\nwait 100\nkey Ctrl+F12";
    let (_, kept) = play_on(ANIMATED, disk.clone(), script);
    assert_eq!(disk.names(), ["vjs-1.gif", "vjs-2.gif"]);
    let frames = frames(&disk.file("vjs-1.gif"));
    assert!(shown_at(&frames, 25) == kept.pictures["help.png"].pixels());
    assert_eq!(frames.last().unwrap().1, 30);
}

#[test]
fn a_film_ends_by_itself_and_says_so() {
    let disk = SharedDisk::default();
    let (_, kept) =
        play_on(EDITOR, disk.clone(), "key U\nkey Ctrl+F12\nwait 600000\nshot end.png\nwait 100000");
    let frames = frames(&disk.file("gb_2d_ip-1.gif"));
    assert_eq!(frames.last().unwrap().1, 60_000);
    common::pictures::assert_golden("film_full", &kept.pictures["end.png"]);
}

#[test]
fn a_disk_that_takes_no_film_is_told() {
    let (_, kept) =
        play_on(EDITOR, Refusing::default(), "key U\nkey Ctrl+F12\nwait 50\nkey Ctrl+F12\nshot end.png");
    common::pictures::assert_golden("film_refused", &kept.pictures["end.png"]);
    let (mut session, _) = play_on(EDITOR, Refusing::default(), "key U\nkey Ctrl+F12\nwait 50");
    let message = session.finish().unwrap_err().to_string();
    assert!(message.starts_with("gb_2d_ip-1.gif: ") && message.contains("space"), "{message}");
    assert_eq!(session.finish(), Ok(()));
}

#[test]
fn the_display_has_a_mark_that_is_in_no_picture() {
    let mut session = common::session(EDITOR, SharedDisk::default(), Settings::default());
    let send = |session: &mut Session, key: Key, ms: u64| {
        session.send(Event::Key(key), Duration::from_millis(ms));
    };
    send(&mut session, Key::Char('u'), 0);
    let same = |session: &Session| -> Screen { session.marked_screen() };
    assert!(same(&session) == *session.screen());
    send(&mut session, Key::CtrlF(12), 1);
    let marked = session.marked_screen();
    let plain = session.screen().clone();
    let places = plain.pixels().iter().zip(marked.pixels()).enumerate();
    let differing: Vec<usize> = places.filter(|(_, (a, b))| a != b).map(|(index, _)| index).collect();
    assert!(!differing.is_empty());
    assert!(differing.iter().all(|index| index % 640 > 620 && index / 640 < 16));
    assert!(session.picture() != *session.screen());
    send(&mut session, Key::CtrlF(12), 1000);
    assert!(same(&session) == *session.screen());
}
