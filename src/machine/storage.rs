//! Where programs keep their files: a flat set of names.
//!
//! The folder on disk is in `disk`; [`Memory`] serves tests and displays without a disk.

use super::samples::sample;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::io::{Cursor, Read};
use std::rc::Rc;

/// What can go wrong with a stored file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StorageProblem {
    /// There is no file of this name.
    NotFound,
    /// The name is not one that can be used; the text says why.
    BadName(&'static str),
    /// The system's own message.
    System(String),
}

/// A stored file that could not be read or written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StorageError {
    /// The name of the file.
    pub name: String,
    /// What is wrong with it.
    pub problem: StorageProblem,
}

impl fmt::Display for StorageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = &self.name;
        match &self.problem {
            StorageProblem::NotFound => write!(f, "{name}: there is no such file"),
            StorageProblem::BadName(why) => write!(f, "{name:?} is no file name: {why}"),
            StorageProblem::System(message) => write!(f, "{name}: {message}"),
        }
    }
}

impl std::error::Error for StorageError {}

/// The content of a file, to be read piece by piece.
pub struct Stream {
    /// Its length in bytes, if it is known before its end.
    pub length: Option<u64>,
    /// Where the pieces come from.
    pub content: Box<dyn Read>,
}

impl From<Vec<u8>> for Stream {
    fn from(content: Vec<u8>) -> Stream {
        Stream { length: Some(content.len() as u64), content: Box::new(Cursor::new(content)) }
    }
}

/// A set of files. Names are plain file names without folders; case does not matter when reading.
pub trait Storage {
    /// The whole content of a file; a name that is not there is looked up among the built-in samples.
    ///
    /// # Errors
    /// [`StorageError`] with the name and what is wrong.
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError>;

    /// The content of a file piece by piece, for files that are too large for [`Storage::read`], such as clouds of
    /// points.
    ///
    /// # Errors
    /// Those of [`Storage::read`].
    fn stream(&self, name: &str) -> Result<Stream, StorageError> {
        self.read(name).map(Stream::from)
    }

    /// Writes a whole file, so that a crash leaves the old content or the new one.
    ///
    /// # Errors
    /// [`StorageError`] with the name and what is wrong; the old content is whole then.
    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError>;

    /// The name as it is stored here, whatever its case; built-in samples do not count.
    fn find(&self, name: &str) -> Option<String>;

    /// Where the files are, for the user; `None` where a name alone says it.
    fn place(&self) -> Option<String> {
        None
    }

    /// The names of all files, in any order; a place that cannot be listed has none.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

/// Checks that a name is a plain file name, as every storage has to. What one system cannot hold is refused on all, so that
/// a folder can be taken from one to another; on Windows some of these names would even lead out of the folder.
///
/// # Errors
/// [`StorageError`] with what is wrong with it.
pub fn check_name(name: &str) -> Result<(), StorageError> {
    let why = if name.is_empty() {
        "it is empty"
    } else if name.len() > 255 {
        "it is longer than 255 bytes"
    } else if name.contains(['/', '\\']) {
        "it contains a slash; give a name without folders"
    } else if name == "." || name == ".." {
        "it stands for a folder"
    } else if name.chars().any(char::is_control) {
        "it contains a control character"
    } else if name.contains([':', '*', '?', '"', '<', '>', '|']) {
        "it contains one of : * ? \" < > |, which Windows cannot hold"
    } else if name.ends_with(['.', ' ']) {
        "it ends with a dot or a blank, which Windows takes off"
    } else if is_device(name) {
        "it stands for a device on Windows, whatever its extension"
    } else {
        return Ok(());
    };
    Err(StorageError { name: name.to_string(), problem: StorageProblem::BadName(why) })
}

/// Whether Windows takes a name for that of a device: `NUL`, `com1`, `CON.IP2`, `AUX .TXT`.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().trim_end().to_uppercase();
    let numbered = |device: &str| {
        let number = stem.strip_prefix(device);
        // The digits 1 to 3 count written high, too.
        number.is_some_and(|number| {
            number.chars().count() == 1 && number.contains(|ch: char| "0123456789¹²³".contains(ch))
        })
    };
    ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"].contains(&stem.as_str())
        || ["COM", "LPT"].into_iter().any(numbered)
}

/// The first name `PROGRAM-1.EXTENSION`, `PROGRAM-2.EXTENSION`, ... that no file has.
pub fn free_name(storage: &dyn Storage, program: &str, extension: &str) -> String {
    let name = |number: u32| format!("{program}-{number}.{extension}");
    let number = (1..u32::MAX).find(|&number| storage.find(&name(number)).is_none());
    name(number.unwrap_or(u32::MAX))
}

/// The built-in sample of this name: what a storage reads where it has no file.
///
/// # Errors
/// [`StorageError`] that there is no such file.
pub fn sample_or_not_found(name: &str) -> Result<Vec<u8>, StorageError> {
    sample(name)
        .map(<[u8]>::to_vec)
        .ok_or_else(|| StorageError { name: name.to_string(), problem: StorageProblem::NotFound })
}

/// Files in memory.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    files: BTreeMap<String, Vec<u8>>,
}

impl Storage for Memory {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        check_name(name)?;
        match self.find(name).and_then(|found| self.files.get(&found)) {
            Some(content) => Ok(content.clone()),
            None => sample_or_not_found(name),
        }
    }

    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        check_name(name)?;
        let stored = self.find(name).unwrap_or_else(|| name.to_string());
        self.files.insert(stored, content.to_vec());
        Ok(())
    }

    fn find(&self, name: &str) -> Option<String> {
        self.files.keys().find(|known| known.eq_ignore_ascii_case(name)).cloned()
    }

    fn names(&self) -> Vec<String> {
        self.files.keys().cloned().collect()
    }
}

/// Files shared by several programs.
impl<S: Storage> Storage for Rc<RefCell<S>> {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        self.borrow().read(name)
    }

    fn stream(&self, name: &str) -> Result<Stream, StorageError> {
        self.borrow().stream(name)
    }

    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        self.borrow_mut().write(name, content)
    }

    fn find(&self, name: &str) -> Option<String> {
        self.borrow().find(name)
    }

    fn names(&self) -> Vec<String> {
        self.borrow().names()
    }

    fn place(&self) -> Option<String> {
        self.borrow().place()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_in_any_case() {
        let mut memory = Memory::default();
        memory.write("Six.IP2", b"one").unwrap();
        memory.write("SIX.ip2", b"two").unwrap();
        assert_eq!(memory.read("six.ip2").unwrap(), b"two");
        assert_eq!(memory.find("SIX.IP2").as_deref(), Some("Six.IP2"));
    }

    #[test]
    fn bad_names_say_what_is_wrong() {
        let mut memory = Memory::default();
        for name in ["", "a/b", "..", "a\\b", "a\nb", &"x".repeat(300)] {
            let message = memory.write(name, b"").unwrap_err().to_string();
            assert!(message.contains("is no file name"), "{message}");
        }
        let windows = [
            "a:b",
            "C:x",
            "what?.ip2",
            "*",
            "a\"b",
            "<a>",
            "a|b",
            "a.",
            "a.ip2 ",
            "NUL",
            "con.ip2",
            "Com1.txt.ip2",
        ];
        for name in windows.into_iter().chain(["lpt¹", "AUX .IP2", "conin$"]) {
            let message = memory.write(name, b"").unwrap_err().to_string();
            assert!(message.contains("Windows"), "{message}");
        }
        for name in
            ["CONE.IP2", "COM.IP2", "COM10", "NULL", ".ip2", "a b.ip2", "ő.ip2", "LPTX", "AUXILIARY.JSON"]
        {
            assert_eq!(memory.write(name, b""), Ok(()), "{name}");
        }
        assert_eq!(memory.read("NOFILE.IP2").unwrap_err().to_string(), "NOFILE.IP2: there is no such file");
    }
}
