//! A program's files, with the contents it last read or wrote, so that it notices a file changed by something else
//! before overwriting it.

use super::storage::{Storage, StorageError, Stream};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hasher};

/// What is known about a name before something is written under it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Standing {
    /// There is no such file.
    Free,
    /// There is one, with this content (`None` if it cannot be read), which is either new to this program or what it
    /// last read or wrote.
    There(Option<Vec<u8>>),
    /// There is one, and its content is not what this program last read or wrote.
    Changed(Option<Vec<u8>>),
}

/// A storage that remembers the contents read and written. It compares contents because file times are unreliable:
/// files are copied, and clocks of other machines differ.
pub struct Files {
    place: Box<dyn Storage>,
    /// What the program read or wrote last, by the name in lower case.
    seen: RefCell<BTreeMap<String, Digest>>,
}

/// What is remembered of a content: films are too large to be kept.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Digest {
    length: usize,
    hash: u64,
}

impl Digest {
    fn of(content: &[u8]) -> Digest {
        let mut hasher = DefaultHasher::new();
        hasher.write(content);
        Digest { length: content.len(), hash: hasher.finish() }
    }
}

impl Files {
    pub(super) fn new(place: Box<dyn Storage>) -> Files {
        Files { place, seen: RefCell::default() }
    }

    /// What is known about a name.
    pub fn standing(&self, name: &str) -> Standing {
        if self.place.find(name).is_none() {
            return Standing::Free;
        }
        let content = self.place.read(name).ok();
        match self.seen.borrow().get(&name.to_ascii_lowercase()) {
            Some(&seen) if content.as_deref().map(Digest::of) != Some(seen) => Standing::Changed(content),
            _ => Standing::There(content),
        }
    }

    fn remember(&self, name: &str, content: &[u8]) {
        self.seen.borrow_mut().insert(name.to_ascii_lowercase(), Digest::of(content));
    }
}

impl Storage for Files {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        let content = self.place.read(name)?;
        self.remember(name, &content);
        Ok(content)
    }

    /// What is read so is not remembered; programs read so what they do not write.
    fn stream(&self, name: &str) -> Result<Stream, StorageError> {
        self.place.stream(name)
    }

    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        self.place.write(name, content)?;
        self.remember(name, content);
        Ok(())
    }

    fn find(&self, name: &str) -> Option<String> {
        self.place.find(name)
    }

    fn names(&self) -> Vec<String> {
        self.place.names()
    }

    fn place(&self) -> Option<String> {
        self.place.place()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Memory;
    use std::rc::Rc;

    #[test]
    fn only_what_others_have_written_is_a_change() {
        let place = Rc::new(RefCell::new(Memory::default()));
        let [mut one, mut other] = [0, 1].map(|_| Files::new(Box::new(place.clone())));
        assert_eq!(one.standing("P.IP2"), Standing::Free);
        one.write("P.IP2", b"1").unwrap();
        assert_eq!(one.standing("p.ip2"), Standing::There(Some(b"1".to_vec())));
        assert_eq!(other.standing("P.IP2"), Standing::There(Some(b"1".to_vec())));
        other.write("p.IP2", b"2").unwrap();
        assert_eq!(one.standing("P.IP2"), Standing::Changed(Some(b"2".to_vec())));
        // Looking is not reading: the program has not seen this content.
        assert_eq!(one.standing("P.IP2"), Standing::Changed(Some(b"2".to_vec())));
        one.read("P.IP2").unwrap();
        assert_eq!(one.standing("P.IP2"), Standing::There(Some(b"2".to_vec())));
        one.write("P.IP2", b"2").unwrap();
        assert_eq!(other.standing("P.IP2"), Standing::There(Some(b"2".to_vec())), "the same content again");
    }

    #[test]
    fn a_sample_is_no_file_but_a_file_in_its_place_is_a_change() {
        let mut place = Rc::new(RefCell::new(Memory::default()));
        let files = Files::new(Box::new(place.clone()));
        files.read("A.IP2").unwrap();
        assert_eq!(files.standing("A.IP2"), Standing::Free);
        place.write("A.IP2", b"mine").unwrap();
        assert_eq!(files.standing("A.IP2"), Standing::Changed(Some(b"mine".to_vec())));
    }
}
