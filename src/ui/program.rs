//! The description of a program: its manual, its place in the menu, the files it opens, and how it starts.

use super::{Manual, Phrase, Words};
use crate::file::{Document, Format};
use crate::machine::{Asked, Key, Machine};
use std::pin::Pin;

/// A running program: a future that is ready when it has ended.
pub type Run<'m> = Pin<Box<dyn Future<Output = Asked<()>> + 'm>>;

/// A program that is ready to run on a machine.
pub type Start = Box<dyn for<'m> FnOnce(&'m mut Machine) -> Run<'m>>;

/// A program of the family.
#[derive(Clone, Copy)]
pub struct Program {
    /// Its name, description and keys.
    pub manual: Manual,
    /// The book's chapters about it.
    pub chapter: &'static str,
    /// The programs it is shown and installed with.
    pub group: &'static Group,
    /// The formats it opens. A file belongs to the first program in the list that opens its format.
    pub opens: &'static [Format],
    /// The demo in its small picture in the menu.
    pub demo: Demo,
    /// Prepares it, with or without a document.
    ///
    /// # Errors
    /// The reason why it cannot open the document.
    pub start: fn(Option<Document>) -> Result<Start, Phrase>,
    /// What its command line takes.
    pub command_line: CommandLine,
}

/// Programs that belong together.
#[derive(Debug)]
pub struct Group {
    /// The folder that the installer creates for it, of at most eight letters as on the book's disk.
    pub folder: &'static str,
    /// The folder in lower case, which is the group's name on the command line.
    pub id: &'static str,
    /// The book's chapter.
    pub chapter: &'static str,
    /// Its name.
    pub name: Words,
    /// Its description, in a sentence or two.
    pub about: Words,
}

/// How the menu demonstrates a program.
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

/// The start of a program that takes no document.
///
/// # Errors
/// A message that it takes no document, if there is one.
pub fn without_document<F>(document: Option<Document>, run: F) -> Result<Start, Phrase>
where
    F: for<'m> FnOnce(&'m mut Machine) -> Run<'m> + 'static,
{
    match document {
        Some(_) => Err(Phrase::new("ez a program fájl nélkül működik", "this program takes no file")),
        None => Ok(Box::new(run)),
    }
}
