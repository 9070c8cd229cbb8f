//! The files of this browser, in memory.

use crate::host::Host;
use grafika::machine::{Storage, StorageError, check_name, sample_or_not_found};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{Cursor, Write};
use std::rc::Rc;
use zip::write::{SimpleFileOptions, ZipWriter};

/// The files by their names, which differ in more than case.
pub(crate) struct Files {
    files: BTreeMap<String, Vec<u8>>,
    host: Rc<Host>,
}

/// The files, shared by the page and the program.
pub(crate) type Shared = Rc<RefCell<Files>>;

impl Files {
    pub(crate) fn new(host: Rc<Host>) -> Files {
        Files { files: BTreeMap::new(), host }
    }

    /// A file that the page has brought, or `None` where it is gone.
    pub(crate) fn set(&mut self, name: &str, content: Option<Vec<u8>>) {
        let stored = self.find(name).unwrap_or_else(|| name.to_owned());
        match content {
            Some(content) => drop(self.files.insert(stored, content)),
            None => drop(self.files.remove(&stored)),
        }
    }

    /// The content of a file; samples do not count.
    pub(crate) fn content(&self, name: &str) -> Option<&[u8]> {
        self.files.get(&self.find(name)?).map(Vec::as_slice)
    }

    /// All files in one, as they are.
    pub(crate) fn zip(&self) -> zip::result::ZipResult<Vec<u8>> {
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        let plain = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
        for (name, content) in &self.files {
            zip.start_file(name.as_str(), plain)?;
            zip.write_all(content)?;
        }
        zip.finish().map(Cursor::into_inner)
    }
}

impl Storage for Files {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        check_name(name)?;
        self.content(name).map_or_else(|| sample_or_not_found(name), |content| Ok(content.to_vec()))
    }

    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        check_name(name)?;
        let stored = self.find(name).unwrap_or_else(|| name.to_owned());
        self.host.saved(&stored, content);
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
