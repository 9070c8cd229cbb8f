//! `grafika convert`: a data file in another format.

use clap::Args;
use grafika::file::FileKind;
use grafika::launch::{Failure, kind_of, open, write_output};
use std::path::PathBuf;

/// The command line of `grafika convert`.
#[derive(Args)]
pub(crate) struct Convert {
    /// The file to read, or a built-in sample
    input: PathBuf,
    /// The file to write; its extension says the format
    output: PathBuf,
}

impl Convert {
    /// Converts.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let to = kind_of(&self.output)?;
        let opened = open(&self.input)?;
        let document = match to {
            FileKind::Dos(format) => opened.document.adapted(format),
            FileKind::Json | FileKind::Csv => opened.document,
        };
        let content = document.encode(to).map_err(|error| {
            Failure::work(format!("{} as {}: {error}", opened.name, self.output.display()))
        })?;
        write_output(Some(&self.output), &content)
    }
}
