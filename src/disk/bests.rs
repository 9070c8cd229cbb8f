//! The best results of games in a file of the state folder.

use super::{UserFolder, read_regular, reason, text, write_safely};
use crate::machine::{Best, Bests};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::{fs, io};

/// The file of the best results, `bests.json`. It is read whenever it is asked, so that programs which run at the same
/// time see each other's results.
#[derive(Clone, Debug)]
pub struct BestsFile {
    path: Option<PathBuf>,
}

impl Default for BestsFile {
    /// The file in [`UserFolder::State`]; nothing is kept where the environment names no such place.
    fn default() -> Self {
        BestsFile { path: UserFolder::State.path().map(|folder| folder.join("bests.json")) }
    }
}

impl BestsFile {
    /// The file at a path.
    #[must_use]
    pub fn at(path: PathBuf) -> BestsFile {
        BestsFile { path: Some(path) }
    }

    fn read(&self) -> Result<BTreeMap<String, Best>, String> {
        let Some(path) = &self.path else { return Ok(BTreeMap::new()) };
        let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        match read_regular(path).and_then(text) {
            Ok(text) => serde_json::from_str(&text).map_err(|error| told(&error)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(BTreeMap::new()),
            Err(error) => Err(told(&reason(&error))),
        }
    }
}

impl Bests for BestsFile {
    fn best(&self, game: &str) -> Option<Best> {
        self.read().ok()?.get(game).copied()
    }

    fn keep(&mut self, game: &str, result: Best) -> Result<(), String> {
        let Some(path) = &self.path else { return Ok(()) };
        // A file that cannot be read is not written over.
        let mut all = self.read()?;
        let before = all.get(game).copied();
        let better = before.map_or(result, |before| before.with(result));
        if before == Some(better) {
            return Ok(());
        }
        all.insert(game.to_owned(), better);
        let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let text = serde_json::to_string_pretty(&all).map_err(|error| told(&error))?;
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(|error| told(&reason(&error)))?;
        }
        write_safely(path, text.as_bytes()).map_err(|error| told(&reason(&error)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_better_number_stays_and_a_broken_file_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new").join("bests.json");
        let mut bests = BestsFile::at(path.clone());
        assert_eq!(bests.best("a"), None);
        bests.keep("a", Best { moves: 9, seconds: 30 }).unwrap();
        bests.keep("a", Best { moves: 12, seconds: 20 }).unwrap();
        bests.keep("b", Best { moves: 1, seconds: 1 }).unwrap();
        assert_eq!(bests.best("a"), Some(Best { moves: 9, seconds: 20 }));
        fs::write(&path, "{").unwrap();
        assert_eq!(bests.best("a"), None);
        assert!(bests.keep("a", Best { moves: 1, seconds: 1 }).unwrap_err().contains("bests.json"));
        assert_eq!(fs::read_to_string(&path).unwrap(), "{");
    }
}
