//! A small program that shows what a display passes on: it draws its last key and the mouse, a click
//! draws a disc, `a` starts and stops an animation, and closing asks first.
//!
//! `display_probe window [SCALE] | terminal [hu|en]`

use grafika::machine::{Asked, Event, Key, Language, Machine, Memory, Session, Settings};
use grafika::screen::{Color, Stroke};

struct State {
    last: String,
    frames: i32,
    animated: bool,
    asking: bool,
    discs: Vec<(i32, i32)>,
}

fn draw(machine: &mut Machine, state: &State) {
    let mouse = machine.mouse();
    let screen = machine.screen();
    screen.clear(Color::LightCyan);
    screen.rectangle(0, 0, 639, 479, Stroke::thin(Color::Red));
    screen.line(0, 479, 639, 0, Stroke::thick(Color::Blue));
    for (number, color) in (0..).zip(Color::ALL) {
        screen.bar(20 + number * 38, 60, 50 + number * 38, 90, color);
    }
    for &(x, y) in &state.discs {
        screen.disc(x, y, 12, Color::Yellow, Color::Black);
    }
    screen.bar(300, 400, 340, 440, Color::LightCyan);
    screen.bar(300 + state.frames % 40, 400, 302 + state.frames % 40, 440, Color::Magenta);
    screen.text(16, 16, "DISPLAY PROBE őű ÁRVÍZTŰRŐ", Color::Black);
    screen.text(16, 36, &state.last, Color::Red);
    screen.text(16, 452, &format!("mouse {} {} {:?}", mouse.x, mouse.y, mouse.down), Color::Black);
    if state.asking {
        screen.bar(200, 200, 440, 260, Color::LightGray);
        screen.text(240, 226, "Close? y/n", Color::Black);
    }
}

async fn probe(mut machine: Machine) -> Asked<()> {
    let mut state =
        State { last: "ready".into(), frames: 0, animated: false, asking: false, discs: Vec::new() };
    loop {
        draw(&mut machine, &state);
        let tick = if state.animated { machine.frame().await } else { machine.event().await };
        let Ok(tick) = tick else {
            state.asking = true;
            continue;
        };
        match tick.event {
            None => state.frames += 1,
            Some(Event::Key(Key::Char('y'))) if state.asking => return Ok(()),
            Some(Event::Key(Key::Char('n'))) if state.asking => state.asking = false,
            Some(event) => state.last = format!("{} {event:?}", tick.now.as_millis()),
        }
        if std::env::var_os("PROBE_LOG").is_some() && tick.event.is_some() {
            eprintln!("{}", state.last);
        }
        if tick.pressed(Key::Char('a')) {
            state.animated = !state.animated;
        }
        state.discs.extend(tick.click());
    }
}

fn run(session: &mut Session, arguments: &[String]) -> Result<(), String> {
    match arguments.first().map(String::as_str) {
        #[cfg(feature = "window")]
        Some("window") => {
            use grafika::display::window;
            let scale = arguments.get(1).and_then(|scale| scale.parse().ok());
            let options = window::WindowOptions { title: "display_probe".into(), scale };
            window::run(session, &options).map_err(|error| error.to_string())
        }
        #[cfg(feature = "terminal")]
        Some("terminal") => grafika::display::terminal::run(session).map_err(|error| error.to_string()),
        _ => {
            // Without a display of its own the session is of no use.
            let _ = session;
            Err("say which display to use: window [SCALE] or terminal [hu|en]".into())
        }
    }
}

fn main() -> std::process::ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let language = arguments.get(1).and_then(|code| Language::from_code(code)).unwrap_or_default();
    let settings = Settings { language, ..Settings::default() };
    let machine = Machine::new(Box::new(Memory::default()), settings);
    let mut session = Session::start(machine, probe);
    match run(&mut session, &arguments) {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            std::process::ExitCode::FAILURE
        }
    }
}
