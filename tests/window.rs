//! Drives the window display on an X server without a screen, as a user and a window manager would.
//!
//! Needs Xvfb; where it is missing the test says so and passes, unless GRAFIKA_CI=1.
#![cfg(all(target_os = "linux", feature = "window"))]

#[path = "common/needs.rs"]
mod needs;

use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    self, AtomEnum, ClientMessageEvent, ConfigureWindowAux, ConnectionExt, EventMask, ImageFormat,
    InputFocus, MapState, Window,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

/// What is started and what it shows: the only part that knows the program. Places are pixels of the
/// picture, colours are 0RRGGBB.
mod program {
    pub(super) const NAME: &str = "display_probe";
    pub(super) const ARGUMENTS: [&str; 1] = ["window"];
    /// Pixels and their colours at the start.
    pub(super) const PICTURE: [((i32, i32), u32); 4] =
        [((100, 300), 0x55_FFFF), ((0, 0), 0xAA_0000), ((639, 479), 0xAA_0000), ((30, 75), 0)];
    /// A click here makes this pixel this colour.
    pub(super) const CLICK: ((i32, i32), (i32, i32), u32) = ((150, 250), (145, 250), 0xFF_FF55);
    /// A pixel of the question before closing, its colour, and the keys for no and yes.
    pub(super) const QUESTION: ((i32, i32), u32) = ((210, 210), 0xAA_AAAA);
    pub(super) const NO: char = 'n';
    pub(super) const YES: char = 'y';
}

fn path() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows where it is");
    let folder = test.ancestors().nth(2).expect("tests lie in a folder of the target folder");
    let path = folder.join("examples").join(program::NAME);
    assert!(
        path.exists(),
        "{} is missing; build it: cargo build --example {}",
        path.display(),
        program::NAME
    );
    path
}

/// A process that ends with the test.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Starts an X server on a free display and gives the display's name; `None` where there is no Xvfb.
fn server() -> Option<(Process, String)> {
    let started = Command::new("Xvfb")
        .args(["-displayfd", "1", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn();
    let mut server = match started {
        Ok(server) => Process(server),
        Err(error) => {
            needs::left_out(&format!("Xvfb cannot be started ({error}); install it to test the window"));
            return None;
        }
    };
    let mut number = String::new();
    BufReader::new(server.0.stdout.take().unwrap()).read_line(&mut number).unwrap();
    assert!(!number.trim().is_empty(), "Xvfb did not start");
    Some((server, format!(":{}", number.trim())))
}

/// The desktop, and the program's window on it.
struct Desktop {
    connection: RustConnection,
    root: Window,
    window: Window,
    program: Process,
    /// Pixels of the window to a pixel of the picture, and the picture's corner in the window.
    scale: i32,
    corner: (i32, i32),
}

#[track_caller]
fn wait<T>(what: &str, mut come: impl FnMut() -> Option<T>) -> T {
    let end = Instant::now() + Duration::from_secs(10);
    loop {
        if let Some(result) = come() {
            return result;
        }
        assert!(Instant::now() < end, "{what} did not come");
        std::thread::sleep(Duration::from_millis(10));
    }
}

impl Desktop {
    fn start(display: &str, arguments: &[&str]) -> Desktop {
        let arguments = [&program::ARGUMENTS, arguments].concat();
        Desktop::start_program(display, Command::new(path()).args(arguments), program::NAME)
    }

    /// Starts any program; its window bears this name.
    fn start_program(display: &str, command: &mut Command, name: &str) -> Desktop {
        let child = command
            .env("DISPLAY", display)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .spawn()
            .unwrap();
        let program = Process(child);
        let (connection, screen) = RustConnection::connect(Some(display)).unwrap();
        let root = connection.setup().roots[screen].root;
        let window = wait("the window", || find_window(&connection, root, name));
        // There is no window manager to give the window the keyboard.
        connection.set_input_focus(InputFocus::PARENT, window, x11rb::CURRENT_TIME).unwrap();
        connection.flush().unwrap();
        let mut desktop = Desktop { connection, root, window, program, scale: 1, corner: (0, 0) };
        desktop.scale = desktop.size().0 / 640;
        desktop
    }

    fn size(&self) -> (i32, i32) {
        let geometry = self.connection.get_geometry(self.window).unwrap().reply().unwrap();
        (i32::from(geometry.width), i32::from(geometry.height))
    }

    /// The colour of a pixel of the window.
    fn color(&self, x: i32, y: i32) -> u32 {
        let (x, y) = (x as i16, y as i16);
        let image = self.connection.get_image(ImageFormat::Z_PIXMAP, self.window, x, y, 1, 1, !0).unwrap();
        let data = image.reply().unwrap().data;
        u32::from_le_bytes([data[0], data[1], data[2], 0])
    }

    /// The place in the window of a pixel of the picture.
    fn place(&self, (x, y): (i32, i32)) -> (i32, i32) {
        (self.corner.0 + x * self.scale, self.corner.1 + y * self.scale)
    }

    /// Whether all the window's pixels of a pixel of the picture have a colour.
    fn shows(&self, pixel: (i32, i32), color: u32) -> bool {
        let (x, y) = self.place(pixel);
        let last = self.scale - 1;
        [(x, y), (x + last, y + last)].into_iter().all(|(x, y)| self.color(x, y) == color)
    }

    #[track_caller]
    fn wait_for(&self, pixel: (i32, i32), color: u32) {
        wait(&format!("{color:06X} at {pixel:?}"), || self.shows(pixel, color).then_some(()));
    }

    fn fake(&self, kind: u8, detail: u8, x: i32, y: i32) {
        let sent = self.connection.xtest_fake_input(kind, detail, 0, self.root, x as i16, y as i16, 0);
        sent.unwrap().check().unwrap();
    }

    /// Moves the mouse to a pixel of the picture.
    fn point(&self, pixel: (i32, i32)) {
        let (x, y) = self.place(pixel);
        let translated = self.connection.translate_coordinates(self.window, self.root, x as i16, y as i16);
        let on_root = translated.unwrap().reply().unwrap();
        self.fake(xproto::MOTION_NOTIFY_EVENT, 0, i32::from(on_root.dst_x), i32::from(on_root.dst_y));
    }

    /// Clicks a pixel of the picture, without any time between press and release.
    fn click(&self, pixel: (i32, i32)) {
        self.point(pixel);
        self.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
        self.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
    }

    /// A part of the picture, at a scale of 1, as the server has it.
    fn image(&self, (x, y): (i16, i16), (width, height): (u16, u16)) -> Vec<u8> {
        let image = self.connection.get_image(ImageFormat::Z_PIXMAP, self.window, x, y, width, height, !0);
        image.unwrap().reply().unwrap().data
    }

    /// User and system time in hundredths of a second, fields 14 and 15.
    fn used(&self) -> u64 {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.program.0.id())).unwrap();
        let (_, fields) = stat.rsplit_once(')').unwrap();
        fields.split_whitespace().skip(11).take(2).map(|field| field.parse::<u64>().unwrap()).sum()
    }

    fn press_key(&self, letter: char) {
        // The key symbols of Latin letters are their codes.
        self.press_symbol(u32::from(letter));
    }

    fn press_symbol(&self, symbol: u32) {
        let code = self.key_code(symbol);
        self.fake(xproto::KEY_PRESS_EVENT, code, 0, 0);
        self.fake(xproto::KEY_RELEASE_EVENT, code, 0, 0);
    }

    fn key_code(&self, symbol: u32) -> u8 {
        let setup = self.connection.setup();
        let (first, last) = (setup.min_keycode, setup.max_keycode);
        let mapping = self.connection.get_keyboard_mapping(first, last - first + 1).unwrap().reply().unwrap();
        let mut codes = mapping.keysyms.chunks(usize::from(mapping.keysyms_per_keycode));
        let place = codes.position(|symbols| symbols[0] == symbol).unwrap();
        first + place as u8
    }

    /// What a window manager does when the close button is clicked.
    fn close(&self) {
        let atom = |name: &[u8]| self.connection.intern_atom(false, name).unwrap().reply().unwrap().atom;
        let data = [atom(b"WM_DELETE_WINDOW"), x11rb::CURRENT_TIME, 0, 0, 0];
        let message = ClientMessageEvent::new(32, self.window, atom(b"WM_PROTOCOLS"), data);
        let sent = self.connection.send_event(false, self.window, EventMask::NO_EVENT, message);
        sent.unwrap().check().unwrap();
    }

    fn resize(&mut self, width: u32, height: u32, scale: i32, corner: (i32, i32)) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        self.connection.configure_window(self.window, &size).unwrap().check().unwrap();
        (self.scale, self.corner) = (scale, corner);
    }

    fn ended(&mut self) -> Option<ExitStatus> {
        self.program.0.try_wait().unwrap()
    }
}

/// The visible window that bears a name.
fn find_window(connection: &RustConnection, root: Window, name: &str) -> Option<Window> {
    let windows = connection.query_tree(root).ok()?.reply().ok()?.children;
    windows.into_iter().find(|&window| {
        let found = connection.get_property(false, window, AtomEnum::WM_NAME, AtomEnum::ANY, 0, 64);
        let named = found.is_ok_and(|found| found.reply().is_ok_and(|found| found.value == name.as_bytes()));
        let attributes = connection.get_window_attributes(window);
        let visible = attributes.is_ok_and(|attributes| {
            attributes.reply().is_ok_and(|attributes| attributes.map_state == MapState::VIEWABLE)
        });
        named && visible
    })
}

/// A whole visit: picture, click, other window sizes, closing with a question.
#[test]
fn a_window_from_start_to_end() {
    let Some((_server, display)) = server() else { return };
    let mut desktop = Desktop::start(&display, &[]);
    assert_eq!(desktop.size(), (1280, 960), "the screen has room for twice the picture");
    for (pixel, color) in program::PICTURE {
        desktop.wait_for(pixel, color);
    }

    let (place, pixel, color) = program::CLICK;
    assert!(!desktop.shows(pixel, color));
    desktop.click(place);
    desktop.wait_for(pixel, color);

    for (width, height, scale, corner) in
        [(1403, 1000, 2, (61, 20)), (1279, 1100, 1, (319, 310)), (640, 480, 1, (0, 0))]
    {
        desktop.resize(width, height, scale, corner);
        desktop.wait_for(program::PICTURE[1].0, program::PICTURE[1].1);
        desktop.wait_for(pixel, color);
        if corner != (0, 0) {
            assert_eq!(desktop.color(corner.0 - 1, corner.1 + 5), 0, "the margin is black");
        }
    }
    desktop.resize(400, 350, 1, (0, 0));
    // The middle of a pixel whose neighbours have its colour: (100, 300).
    let reduced = || (desktop.color(62, 212) == program::PICTURE[0].1).then_some(());
    wait("the reduced picture", || (desktop.color(0, 24) == 0).then(reduced).flatten());
    desktop.resize(1280, 960, 2, (0, 0));

    let (question, color) = program::QUESTION;
    desktop.close();
    desktop.wait_for(question, color);
    desktop.press_key(program::NO);
    wait("the end of the question", || (!desktop.shows(question, color)).then_some(()));
    desktop.close();
    desktop.wait_for(question, color);
    desktop.close();
    std::thread::sleep(Duration::from_millis(100));
    assert!(desktop.ended().is_none() && desktop.shows(question, color));
    desktop.press_key(program::YES);
    assert!(wait("the end of the program", || desktop.ended()).success());
}

#[test]
fn a_window_of_the_wanted_scale_needs_no_time_while_nothing_happens() {
    let Some((_server, display)) = server() else { return };
    let desktop = Desktop::start(&display, &["1"]);
    assert_eq!(desktop.size(), (640, 480));
    for (pixel, color) in program::PICTURE {
        desktop.wait_for(pixel, color);
    }
    std::thread::sleep(Duration::from_millis(500));
    let before = desktop.used();
    std::thread::sleep(Duration::from_secs(2));
    let ticks = desktop.used() - before;
    assert!(ticks <= 4, "{ticks} hundredths of a second of two seconds at rest");
}

/// Another window may get the release of a button; the program must not go on dragging.
#[test]
fn a_window_without_the_keyboard_holds_no_button() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let record = folder.path().join("session.txt");
    let mut command = Command::new(env!("CARGO_BIN_EXE_gb_2d_ip"));
    command.args(["--display", "window", "--scale", "1", "--record"]).arg(&record);
    command.env("XDG_STATE_HOME", folder.path()).env("XDG_CONFIG_HOME", folder.path());
    let desktop = Desktop::start_program(&display, command.current_dir(folder.path()), "GB_2D_IP");
    let recorded = |line: &str| {
        wait(line, || {
            let text = std::fs::read_to_string(&record).unwrap_or_default();
            text.lines()
                .any(|known| known == line)
                .then(|| text.lines().filter(|&known| known == line).count())
        })
    };
    let focus = |window: Window| {
        desktop
            .connection
            .set_input_focus(InputFocus::NONE, window, x11rb::CURRENT_TIME)
            .unwrap()
            .check()
            .unwrap();
    };
    desktop.fake(xproto::MOTION_NOTIFY_EVENT, 0, 100, 100);
    desktop.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
    recorded("press left");
    focus(desktop.root);
    assert_eq!(recorded("release left"), 1);
    // The real release comes too late to be another one; the next click counts.
    desktop.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
    focus(desktop.window);
    desktop.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
    desktop.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
    wait("the second click", || (recorded("release left") == 2).then_some(()));
    assert_eq!(recorded("press left"), 2);
}

/// Key symbols of F9, F11, Control and Down.
const F9: u32 = 0xFFC6;
const F11: u32 = 0xFFC8;
const CONTROL: u32 = 0xFFE3;
const DOWN: u32 = 0xFF54;

/// A program in a window of the picture's size, with settings in a folder.
fn in_window(display: &str, executable: &str, folder: &std::path::Path, title: &str) -> Desktop {
    let mut command = Command::new(executable);
    command.args(["--display", "window", "--scale", "1"]).current_dir(folder);
    command.env("XDG_STATE_HOME", folder).env("XDG_CONFIG_HOME", folder).env("LC_ALL", "en_US.UTF-8");
    Desktop::start_program(display, &mut command, title)
}

#[test]
fn the_language_is_changed_in_the_settings_by_mouse_and_kept() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let desktop = in_window(&display, env!("CARGO_BIN_EXE_gb_2d_ip"), folder.path(), "GB_2D_IP");
    let names = || desktop.image((100, 100), (190, 200));
    wait("the first picture", || names().iter().any(|&byte| byte != 0).then_some(()));
    let before = names();
    desktop.press_symbol(F9);
    wait("the settings", || (names() != before).then_some(()));
    std::thread::sleep(Duration::from_millis(200));
    let english = names();
    let kept = || std::fs::read_to_string(folder.path().join("grafika/config.toml")).unwrap_or_default();
    // The first row is the language: a click on the value turns it forward, left of it back.
    desktop.click((400, 114));
    wait("Hungarian", || kept().contains("language = \"hu\"").then_some(()));
    wait("Hungarian names", || (names() != english).then_some(()));
    desktop.click((308, 114));
    wait("the language of the locale", || (!kept().contains("language") && names() == english).then_some(()));
    // The last row closes the page.
    desktop.click((130, 354));
    wait("the end of the settings", || (names() == before).then_some(()));
}

#[test]
fn a_key_changes_the_look_of_the_window_and_it_is_kept() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut desktop = in_window(&display, env!("CARGO_BIN_EXE_biliard"), folder.path(), "BILIARD");
    desktop.resize(900, 600, 1, (130, 60));
    let margin = |desktop: &Desktop| desktop.color(60, 300);
    desktop.wait_for((5, 5), 0x55_FFFF);
    assert_eq!(margin(&desktop), 0);
    let control = desktop.key_code(CONTROL);
    desktop.fake(xproto::KEY_PRESS_EVENT, control, 0, 0);
    desktop.press_symbol(F11);
    desktop.fake(xproto::KEY_RELEASE_EVENT, control, 0, 0);
    wait("the filling picture", || (margin(&desktop) == 0x55_FFFF).then_some(()));
    let kept = std::fs::read_to_string(folder.path().join("grafika/config.toml")).unwrap();
    assert!(kept.contains("look = \"fill\""), "{kept}");
}

/// What the menu takes of a core, row by row of its grid.
#[test]
#[ignore = "measures for a minute; for a release build on an idle machine"]
fn the_menu_takes_little_power_wherever_it_stands() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let desktop = in_window(&display, env!("CARGO_BIN_EXE_grafika"), folder.path(), "GRAFIKA");
    for row in 0..18 {
        std::thread::sleep(Duration::from_secs(2));
        let before = desktop.used();
        std::thread::sleep(Duration::from_secs(3));
        println!("row {row}: {:.1} %", (desktop.used() - before) as f64 / 3.0);
        desktop.press_symbol(DOWN);
    }
}

/// Does by keyboard and mouse what a script says, in a window and without, and waits until both show the same. The
/// clock of a game, below `top`, is left out, and so is the pointer.
#[track_caller]
fn assert_like_script(
    executable: &str,
    program: grafika::ui::Program,
    script: &str,
    clock: Option<[i32; 4]>,
) {
    use grafika::machine::{Machine, Memory, Script, Session, Settings, play};
    let Some((_server, display)) = server() else { return };
    let parsed = Script::parse(&format!("lang en\nmanner today\n{script}move 638 478\nwait 9000\n")).unwrap();
    let machine = Machine::new(Box::new(Memory::default()), parsed.begun_with(Settings::default()));
    let start = (program.start)(None).unwrap_or_else(|_| panic!("it needs no document"));
    let mut session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    play(&mut session, &parsed, &mut ()).unwrap();

    let folder = tempfile::tempdir().unwrap();
    let title = program.manual.name.to_uppercase();
    let mut command = Command::new(executable);
    command
        .args(["--display", "window", "--scale", "1", "--lang", "en", "--seed", "1"])
        .current_dir(folder.path());
    command.env("XDG_STATE_HOME", folder.path()).env("XDG_CONFIG_HOME", folder.path());
    let desktop = Desktop::start_program(&display, &mut command, &title);
    wait("the first picture", || {
        desktop.image((0, 0), (640, 480)).iter().any(|&byte| byte != 0).then_some(())
    });
    std::thread::sleep(Duration::from_millis(300));
    for line in script.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let at = |index: usize| words[index].parse::<i32>().unwrap();
        match words[0] {
            "key" if words[1] == "Enter" => desktop.press_symbol(0xFF0D),
            "key" if words[1] == "Ctrl+Z" => {
                let control = desktop.key_code(CONTROL);
                desktop.fake(xproto::KEY_PRESS_EVENT, control, 0, 0);
                desktop.press_key('z');
                desktop.fake(xproto::KEY_RELEASE_EVENT, control, 0, 0);
            }
            "key" => desktop.press_key(words[1].to_lowercase().chars().next().unwrap()),
            "click" => desktop.click((at(1), at(2))),
            "drag" => {
                desktop.point((at(1), at(2)));
                desktop.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
                std::thread::sleep(Duration::from_millis(60));
                desktop.point((at(3), at(4)));
                std::thread::sleep(Duration::from_millis(60));
                desktop.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
            }
            "wait" => std::thread::sleep(Duration::from_millis(words[1].parse().unwrap())),
            other => panic!("no {other} in a window"),
        }
        std::thread::sleep(Duration::from_millis(60));
    }
    // Out of the way, so that only a corner is covered.
    desktop.point((638, 478));
    let left_out = |x: i32, y: i32| {
        (x > 620 && y > 460)
            || clock.is_some_and(|[x1, y1, x2, y2]| (x1..=x2).contains(&x) && (y1..=y2).contains(&y))
    };
    let screen = session.screen();
    let end = Instant::now() + Duration::from_secs(10);
    loop {
        let shown = desktop.image((0, 0), (640, 480));
        let differs = |index: usize| {
            let (x, y) = ((index % 640) as i32, (index / 640) as i32);
            let [red, green, blue] = screen.pixel(x, y).map_or([0; 3], |color| color.rgb());
            !left_out(x, y) && shown[4 * index..4 * index + 3] != [blue, green, red]
        };
        let count = (0..640 * 480).filter(|&index| differs(index)).count();
        if count == 0 {
            return;
        }
        assert!(Instant::now() < end, "{count} pixels differ from what the script shows");
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[test]
fn a_sample_is_chosen_by_mouse() {
    let script = "key T\nclick 320 120\n";
    assert_like_script(env!("CARGO_BIN_EXE_gb_2d_ip"), grafika::programs::gb_2d_ip::PROGRAM, script, None);
}

#[test]
fn three_clicks_are_three_points() {
    let script = "key U\nclick 141 350\nclick 241 150\nclick 341 350\n";
    assert_like_script(env!("CARGO_BIN_EXE_gb_2d_ip"), grafika::programs::gb_2d_ip::PROGRAM, script, None);
}

#[test]
fn a_surface_is_turned_by_a_left_drag() {
    let script = "key T\nkey Enter\ndrag 560 420 500 380\n";
    assert_like_script(env!("CARGO_BIN_EXE_zm_hspl"), grafika::programs::zm_hspl::PROGRAM, script, None);
}

/// Where the wheel shows moves and time, and what it says of the last move.
const CLOCK: [i32; 4] = [400, 0, 639, 170];

#[test]
fn a_ring_of_the_wheel_is_dragged() {
    let script = "key Enter\ndrag 330 260 300 311\nwait 500\n";
    let program = grafika::programs::gyongy_k::PROGRAM;
    assert_like_script(env!("CARGO_BIN_EXE_gyongy_k"), program, script, Some(CLOCK));
}

#[test]
fn a_wheel_of_four_moves_is_played_to_its_end() {
    // The first move by a hint, one of them taken back and made again.
    let script = "key Enter\nkey H\nwait 3000\nkey C\nkey J\nkey Ctrl+Z\nkey J\nkey L\nkey M\nwait 3000\n";
    let program = grafika::programs::gyongy_k::PROGRAM;
    assert_like_script(env!("CARGO_BIN_EXE_gyongy_k"), program, script, Some(CLOCK));
}
