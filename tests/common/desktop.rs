//! An X server without a screen, and a program's window on it, driven as a user and a window manager would.
//!
//! Needs Xvfb; where it is missing a test says so and passes, unless GRAFIKA_CI=1.

use super::needs;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    self, AtomEnum, ClientMessageEvent, ConfigureWindowAux, ConnectionExt, EventMask, ImageFormat,
    InputFocus, MapState, Window,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

/// A process that ends with the test.
pub(crate) struct Process(pub(crate) Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Starts an X server on a free display and gives the display's name; `None` where there is no Xvfb.
pub(crate) fn server() -> Option<(Process, String)> {
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
pub(crate) struct Desktop {
    pub(crate) connection: RustConnection,
    pub(crate) root: Window,
    pub(crate) window: Window,
    pub(crate) program: Process,
    /// Pixels of the window to a pixel of the picture, and the picture's corner in the window.
    pub(crate) scale: i32,
    pub(crate) corner: (i32, i32),
}

#[track_caller]
pub(crate) fn wait<T>(what: &str, mut come: impl FnMut() -> Option<T>) -> T {
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
    /// Starts any program; its window bears this name.
    pub(crate) fn start_program(display: &str, command: &mut Command, name: &str) -> Desktop {
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

    pub(crate) fn size(&self) -> (i32, i32) {
        let geometry = self.connection.get_geometry(self.window).unwrap().reply().unwrap();
        (i32::from(geometry.width), i32::from(geometry.height))
    }

    /// The colour of a pixel of the window.
    pub(crate) fn color(&self, x: i32, y: i32) -> u32 {
        let (x, y) = (x as i16, y as i16);
        let image = self.connection.get_image(ImageFormat::Z_PIXMAP, self.window, x, y, 1, 1, !0).unwrap();
        let data = image.reply().unwrap().data;
        u32::from_le_bytes([data[0], data[1], data[2], 0])
    }

    /// The place in the window of a pixel of the picture.
    pub(crate) fn place(&self, (x, y): (i32, i32)) -> (i32, i32) {
        (self.corner.0 + x * self.scale, self.corner.1 + y * self.scale)
    }

    /// Whether all the window's pixels of a pixel of the picture have a colour.
    pub(crate) fn shows(&self, pixel: (i32, i32), color: u32) -> bool {
        let (x, y) = self.place(pixel);
        let last = self.scale - 1;
        [(x, y), (x + last, y + last)].into_iter().all(|(x, y)| self.color(x, y) == color)
    }

    #[track_caller]
    pub(crate) fn wait_for(&self, pixel: (i32, i32), color: u32) {
        wait(&format!("{color:06X} at {pixel:?}"), || self.shows(pixel, color).then_some(()));
    }

    pub(crate) fn fake(&self, kind: u8, detail: u8, x: i32, y: i32) {
        let sent = self.connection.xtest_fake_input(kind, detail, 0, self.root, x as i16, y as i16, 0);
        sent.unwrap().check().unwrap();
    }

    /// Moves the mouse to a pixel of the picture.
    pub(crate) fn point(&self, pixel: (i32, i32)) {
        let (x, y) = self.place(pixel);
        let translated = self.connection.translate_coordinates(self.window, self.root, x as i16, y as i16);
        let on_root = translated.unwrap().reply().unwrap();
        self.fake(xproto::MOTION_NOTIFY_EVENT, 0, i32::from(on_root.dst_x), i32::from(on_root.dst_y));
    }

    /// Clicks a pixel of the picture, without any time between press and release.
    pub(crate) fn click(&self, pixel: (i32, i32)) {
        self.point(pixel);
        self.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
        self.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
    }

    /// A part of the picture, at a scale of 1, as the server has it.
    pub(crate) fn image(&self, (x, y): (i16, i16), (width, height): (u16, u16)) -> Vec<u8> {
        let image = self.connection.get_image(ImageFormat::Z_PIXMAP, self.window, x, y, width, height, !0);
        image.unwrap().reply().unwrap().data
    }

    /// User and system time in hundredths of a second, fields 14 and 15.
    pub(crate) fn used(&self) -> u64 {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.program.0.id())).unwrap();
        let (_, fields) = stat.rsplit_once(')').unwrap();
        fields.split_whitespace().skip(11).take(2).map(|field| field.parse::<u64>().unwrap()).sum()
    }

    pub(crate) fn press_key(&self, letter: char) {
        // The key symbols of Latin letters are their codes.
        self.press_symbol(u32::from(letter));
    }

    pub(crate) fn press_symbol(&self, symbol: u32) {
        let code = self.key_code(symbol);
        self.fake(xproto::KEY_PRESS_EVENT, code, 0, 0);
        self.fake(xproto::KEY_RELEASE_EVENT, code, 0, 0);
    }

    pub(crate) fn key_code(&self, symbol: u32) -> u8 {
        let setup = self.connection.setup();
        let (first, last) = (setup.min_keycode, setup.max_keycode);
        let mapping = self.connection.get_keyboard_mapping(first, last - first + 1).unwrap().reply().unwrap();
        let mut codes = mapping.keysyms.chunks(usize::from(mapping.keysyms_per_keycode));
        let place = codes.position(|symbols| symbols[0] == symbol).unwrap();
        first + place as u8
    }

    /// What a window manager does when the close button is clicked.
    pub(crate) fn close(&self) {
        let atom = |name: &[u8]| self.connection.intern_atom(false, name).unwrap().reply().unwrap().atom;
        let data = [atom(b"WM_DELETE_WINDOW"), x11rb::CURRENT_TIME, 0, 0, 0];
        let message = ClientMessageEvent::new(32, self.window, atom(b"WM_PROTOCOLS"), data);
        let sent = self.connection.send_event(false, self.window, EventMask::NO_EVENT, message);
        sent.unwrap().check().unwrap();
    }

    pub(crate) fn resize(&mut self, width: u32, height: u32, scale: i32, corner: (i32, i32)) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        self.connection.configure_window(self.window, &size).unwrap().check().unwrap();
        (self.scale, self.corner) = (scale, corner);
    }

    pub(crate) fn ended(&mut self) -> Option<ExitStatus> {
        self.program.0.try_wait().unwrap()
    }
}

/// The visible window that bears a name.
pub(crate) fn find_window(connection: &RustConnection, root: Window, name: &str) -> Option<Window> {
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
