//! What the tests of programs share: running a program in memory and comparing pictures.

#![allow(dead_code, reason = "every test file uses its own part of this")]

#[cfg(target_os = "linux")]
pub(crate) mod desktop;
#[cfg(feature = "native")]
pub(crate) mod folder;
pub(crate) mod needs;
pub(crate) mod pictures;
pub(crate) mod random;
pub(crate) mod reference;
pub(crate) mod shelf;

use grafika::figure::screen_png;
use grafika::file::Document;
use grafika::machine::{
    Language, Machine, Manner, Memory, Outlet, Script, Session, Settings, Storage, StorageError,
    StorageProblem, play,
};
use grafika::screen::Screen;
use grafika::ui::Program;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// A file of the tests' folder.
pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// Does some work on every item, on all processors; the results are in no particular order.
pub(crate) fn shared_out<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let part = |first| items.iter().skip(first).step_by(threads).map(&work).collect::<Vec<_>>();
    std::thread::scope(|scope| {
        let parts: Vec<_> = (0..threads).map(|first| scope.spawn(move || part(first))).collect();
        parts.into_iter().flat_map(|part| part.join().expect("a part says itself what is wrong")).collect()
    })
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
    session_on(program, Machine::new(Box::new(storage), settings), None)
}

/// Starts a program on a machine with a document that it can work with.
pub(crate) fn session_on(program: Program, machine: Machine, document: Option<Document>) -> Session {
    let start =
        (program.start)(document).unwrap_or_else(|problem| panic!("{}", problem.of(Language::English)));
    Session::start(machine, move |mut machine| async move { start(&mut machine).await })
}

/// Plays a script with a program in memory and returns what it wrote.
pub(crate) fn play_script(program: Program, storage: Memory, script: &str) -> Kept {
    let mut kept = Kept::default();
    let script = Script::parse(script).expect("the test's script is right");
    play(&mut session(program, storage, Settings::default()), &script, &mut kept)
        .expect("the outlet takes all");
    kept
}

/// Plays a script in the manner of today.
pub(crate) fn play_today(program: Program, script: &str) -> Kept {
    let mut kept = Kept::default();
    let script = Script::parse(script).expect("the test's script is right");
    let settings = Settings { manner: Manner::Today, ..Settings::default() };
    play(&mut session(program, Memory::default(), settings), &script, &mut kept)
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

/// A disk that is looked into after a program has written on it.
#[derive(Clone, Default)]
pub(crate) struct SharedDisk {
    files: Rc<RefCell<Memory>>,
    names: Rc<RefCell<std::collections::BTreeSet<String>>>,
}

impl SharedDisk {
    /// The names of all files in their order.
    pub(crate) fn names(&self) -> Vec<String> {
        self.names.borrow().iter().cloned().collect()
    }

    /// What a file holds.
    pub(crate) fn file(&self, name: &str) -> Vec<u8> {
        self.files.borrow().read(name).unwrap_or_else(|error| panic!("{error}; there is {:?}", self.names()))
    }
}

impl Storage for SharedDisk {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        self.files.borrow().read(name)
    }
    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        self.files.borrow_mut().write(name, content)?;
        let stored = self.find(name).expect("it has just been written");
        self.names.borrow_mut().insert(stored);
        Ok(())
    }
    fn find(&self, name: &str) -> Option<String> {
        self.files.borrow().find(name)
    }
    fn names(&self) -> Vec<String> {
        SharedDisk::names(self)
    }
}

/// A disk that takes nothing.
#[derive(Clone, Default)]
pub(crate) struct Refusing(Memory);

impl Storage for Refusing {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        self.0.read(name)
    }
    fn write(&mut self, name: &str, _: &[u8]) -> Result<(), StorageError> {
        let problem = StorageProblem::System("No space left on device (os error 28)".to_string());
        Err(StorageError { name: name.to_string(), problem })
    }
    fn find(&self, name: &str) -> Option<String> {
        self.0.find(name)
    }
}
