//! Any text as a script: refused with its line, or played by a program to its end.
#![no_main]

use grafika::machine::{Machine, Memory, Outlet, Script, Session, Settings, play};
use grafika::programs::gb_2d_ip::PROGRAM;
use grafika::screen::Screen;
use libfuzzer_sys::fuzz_target;

/// Takes what the script writes and keeps nothing.
struct Nowhere;

impl Outlet for Nowhere {
    fn picture(&mut self, _: &str, _: &Screen) -> Result<(), String> {
        Ok(())
    }

    fn text(&mut self, _: &str, _: &str) -> Result<(), String> {
        Ok(())
    }
}

fuzz_target!(|text: &str| {
    let Ok(script) = Script::parse(text) else { return };
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let Ok(start) = (PROGRAM.start)(None) else { return };
    let mut session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    let _ = play(&mut session, &script, &mut Nowhere);
});
