//! What the tests of programs share: running a program in memory and comparing pictures.

#![allow(dead_code, reason = "every test file uses its own part of this")]

pub(crate) mod pictures;
pub(crate) mod random;
pub(crate) mod reference;
pub(crate) mod shelf;

use grafika::figure::screen_png;
use grafika::launch::Program;
use grafika::machine::{Machine, Memory, Outlet, Script, Session, Settings, Storage, play};
use grafika::screen::Screen;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A file of the tests' folder.
pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// What a script wrote.
#[derive(Default)]
pub(crate) struct Kept {
    pub(crate) pictures: BTreeMap<String, Screen>,
    pub(crate) models: BTreeMap<String, serde_json::Value>,
}

impl Kept {
    /// The PNG of a picture.
    pub(crate) fn png(&self, name: &str) -> Vec<u8> {
        screen_png(&self.pictures[name]).expect("a screen is a picture")
    }
}

impl Outlet for Kept {
    fn picture(&mut self, path: &str, screen: &Screen) -> Result<(), String> {
        self.pictures.insert(path.to_string(), screen.clone());
        Ok(())
    }

    fn text(&mut self, path: &str, text: &str) -> Result<(), String> {
        self.models.insert(path.to_string(), serde_json::from_str(text).map_err(|error| error.to_string())?);
        Ok(())
    }
}

/// Starts a program on a storage, without a file.
pub(crate) fn session(program: Program, storage: impl Storage + 'static, settings: Settings) -> Session {
    let machine = Machine::new(Box::new(storage), settings);
    Session::start(machine, move |mut machine| async move { (program.run)(&mut machine, None).await })
}

/// Plays a script with a program in memory and returns what it wrote.
pub(crate) fn play_script(program: Program, storage: Memory, script: &str) -> Kept {
    let mut kept = Kept::default();
    let script = Script::parse(script).expect("the test's script is right");
    play(&mut session(program, storage, Settings::default()), &script, &mut kept)
        .expect("the outlet takes all");
    kept
}

/// A storage with files of the tests' folder.
pub(crate) fn storage(folder: &str, names: &[&str]) -> Memory {
    let mut storage = Memory::default();
    for name in names {
        let content = std::fs::read(path(folder).join(name)).expect("the test's file is there");
        storage.write(name, &content).expect("memory takes all");
    }
    storage
}
