//! What a program is, before it runs: its manual, its place in the menu, the files it opens, its start.

use super::{Manual, Phrase, Words};
use crate::file::{Document, Format};
use crate::machine::{Asked, Key, Machine};
use std::pin::Pin;

/// A running program: ready when it has ended.
pub type Run<'m> = Pin<Box<dyn Future<Output = Asked<()>> + 'm>>;

/// A program that is ready to run on a machine.
pub type Start = Box<dyn for<'m> FnOnce(&'m mut Machine) -> Run<'m>>;

/// A program of the family.
#[derive(Clone, Copy)]
pub struct Program {
    /// Its name, a line about it, its keys.
    pub manual: Manual,
    /// The book's chapters about it.
    pub chapter: &'static str,
    /// The programs it is shown and installed with.
    pub group: &'static Group,
    /// The data files it opens. A file belongs to the first program of the list that opens it.
    pub opens: &'static [Format],
    /// What its small picture in the menu shows.
    pub demo: Demo,
    /// Makes it ready, with a document or without.
    ///
    /// # Errors
    /// Why it cannot work with the document.
    pub start: fn(Option<Document>) -> Result<Start, Phrase>,
    /// What its command line takes.
    pub command_line: CommandLine,
}

/// Programs that belong together.
#[derive(Debug)]
pub struct Group {
    /// The folder that the installer makes for it, of eight letters at most as on the book's disk.
    pub folder: &'static str,
    /// The same in lower case: the group's name on the command line.
    pub id: &'static str,
    /// The book's chapter.
    pub chapter: &'static str,
    /// What the group is called.
    pub name: Words,
    /// What it is, in a sentence or two.
    pub about: Words,
}

/// How a program is brought to show what it is for.
#[derive(Clone, Copy, Debug)]
pub struct Demo {
    /// The built-in sample that it opens; empty for none.
    pub file: &'static str,
    /// The script that leads to the picture.
    pub script: &'static str,
    /// The key that it gets at every step while the program is chosen. Programs that move by themselves need
    /// none.
    pub motion: Option<Key>,
}

/// What a program's command line takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommandLine {
    /// A data file, and the options of every program.
    Usual,
    /// A folder to install into, and the groups of programs.
    Install,
}

/// The start of a program that works without any document.
///
/// # Errors
/// With a document: that it takes none.
pub fn without_document<F>(document: Option<Document>, run: F) -> Result<Start, Phrase>
where
    F: for<'m> FnOnce(&'m mut Machine) -> Run<'m> + 'static,
{
    match document {
        Some(_) => Err(Phrase::new("ez a program fájl nélkül működik", "this program takes no file")),
        None => Ok(Box::new(run)),
    }
}
