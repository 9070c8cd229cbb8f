//! A program in a pseudo-terminal, as a user and a terminal would drive it.

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
use std::io::{Read, Write};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Questions to the terminal end with this one, which every terminal answers.
pub(crate) const LAST_QUESTION: &[u8] = b"\x1b[c";
/// The answer of a terminal without graphics.
pub(crate) const PLAIN: &str = "\x1b[?62;c";

/// The question where the cursor is, which says that a picture has arrived.
const WHERE: &[u8] = b"\x1b[6n";

/// A terminal with a program in it.
pub(crate) struct Terminal {
    pub(crate) master: Box<dyn MasterPty + Send>,
    pub(crate) child: Box<dyn Child + Send + Sync>,
    keyboard: Arc<Mutex<Box<dyn Write + Send>>>,
    pub(crate) screen: Arc<Mutex<vt100::Parser>>,
    pub(crate) output: Arc<Mutex<Vec<u8>>>,
}

fn size(columns: u16, rows: u16) -> PtySize {
    PtySize { rows, cols: columns, pixel_width: 0, pixel_height: 0 }
}

impl Terminal {
    /// Starts a command in a terminal of some size.
    pub(crate) fn start(columns: u16, rows: u16, command: CommandBuilder) -> Terminal {
        Terminal::start_on(columns, rows, command, None)
    }

    /// The same on a line of so many bytes a second.
    pub(crate) fn start_on(
        columns: u16,
        rows: u16,
        mut command: CommandBuilder,
        speed: Option<usize>,
    ) -> Terminal {
        let pair = native_pty_system().openpty(size(columns, rows)).unwrap();
        command.env("TERM", "xterm-256color");
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let screen = Arc::new(Mutex::new(vt100::Parser::new(rows, columns, 0)));
        let output = Arc::new(Mutex::new(Vec::new()));
        let keyboard = Arc::new(Mutex::new(pair.master.take_writer().unwrap()));
        let (parser, log, answers) = (Arc::clone(&screen), Arc::clone(&output), Arc::clone(&keyboard));
        std::thread::spawn(move || {
            // A slow line brings a hundredth of a second's bytes at a time.
            let mut buffer = vec![0; speed.map_or(65536, |speed| speed / 100)];
            while let Ok(length @ 1..) = reader.read(&mut buffer) {
                if let Some(speed) = speed {
                    std::thread::sleep(Duration::from_secs_f64(length as f64 / speed as f64));
                }
                log.lock().unwrap().extend_from_slice(&buffer[..length]);
                parser.lock().unwrap().process(&buffer[..length]);
                // The question may come in pieces.
                let asked = {
                    let log = log.lock().unwrap();
                    let from = log.len().saturating_sub(length + WHERE.len() - 1);
                    log[from..].windows(WHERE.len()).any(|window| window == WHERE)
                };
                if asked {
                    let _ = answers.lock().unwrap().write_all(b"\x1b[1;1R");
                }
            }
        });
        Terminal { master: pair.master, child, keyboard, screen, output }
    }

    /// Waits for the questions of a display of pictures, and answers.
    #[track_caller]
    pub(crate) fn answer(&mut self, answers: &str) {
        self.wait("the questions", |terminal| terminal.wrote(LAST_QUESTION));
        self.send(answers);
    }

    pub(crate) fn send(&mut self, text: &str) {
        let mut keyboard = self.keyboard.lock().unwrap();
        keyboard.write_all(text.as_bytes()).unwrap();
        keyboard.flush().unwrap();
    }

    pub(crate) fn resize(&mut self, columns: u16, rows: u16) {
        self.screen.lock().unwrap().screen_mut().set_size(rows, columns);
        self.master.resize(size(columns, rows)).unwrap();
    }

    pub(crate) fn contents(&self) -> String {
        self.screen.lock().unwrap().screen().contents()
    }

    pub(crate) fn shows(&self, text: &str) -> bool {
        self.contents().contains(text)
    }

    /// Whether these bytes were ever written.
    pub(crate) fn wrote(&self, bytes: &[u8]) -> bool {
        self.output.lock().unwrap().windows(bytes.len()).any(|window| window == bytes)
    }

    pub(crate) fn running(&mut self) -> bool {
        self.child.try_wait().unwrap().is_none()
    }

    #[track_caller]
    pub(crate) fn wait(&mut self, what: &str, mut come: impl FnMut(&mut Terminal) -> bool) {
        let end = Instant::now() + Duration::from_secs(20);
        while !come(self) {
            assert!(Instant::now() < end, "{what} did not come; the terminal shows\n{}", self.contents());
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits for a text on the screen.
    #[track_caller]
    pub(crate) fn wait_for(&mut self, text: &str) {
        self.wait(text, |terminal| terminal.shows(text));
    }

    #[track_caller]
    pub(crate) fn wait_for_end(&mut self) {
        self.wait("the end of the program", |terminal| !terminal.running());
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
