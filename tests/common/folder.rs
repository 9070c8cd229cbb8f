//! A folder in which the command line is tried.

use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

/// A folder of its own, which is gone in the end.
pub(crate) struct Folder(TempDir);

impl Folder {
    pub(crate) fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Runs `grafika` there with the words of a line, in English whatever the locale is.
    pub(crate) fn run(&self, line: &str) -> Output {
        Command::new(env!("CARGO_BIN_EXE_grafika"))
            .current_dir(self.0.path())
            .env("LC_ALL", "C")
            .args(line.split(' ').filter(|word| !word.is_empty()))
            .output()
            .expect("it starts")
    }

    /// What a command writes, and what it says, that does its work.
    #[track_caller]
    pub(crate) fn done_saying(&self, line: &str) -> [String; 2] {
        let output = self.run(line);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{line}: {said}");
        [String::from_utf8(output.stdout).unwrap(), said]
    }

    /// What a command writes that does its work.
    #[track_caller]
    pub(crate) fn done(&self, line: &str) -> String {
        let [written, _] = self.done_saying(line);
        written
    }

    /// The same as JSON.
    #[track_caller]
    pub(crate) fn json(&self, line: &str) -> Value {
        serde_json::from_str(&self.done(line)).unwrap()
    }

    /// The one line that a command says that fails with this status.
    #[track_caller]
    pub(crate) fn refused(&self, status: i32, line: &str) -> String {
        let output = self.run(line);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{line}: {said}");
        assert_eq!(said.trim_end().lines().count(), 1, "{said}");
        said
    }

    pub(crate) fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// A file as text; what is none is shown as well as it can be.
    pub(crate) fn read(&self, name: &str) -> String {
        String::from_utf8_lossy(&self.bytes(name)).into_owned()
    }
}
