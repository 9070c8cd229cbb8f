//! `grafika convert`: a data file in another format.

use crate::source::{Source, kind_by_extension, output_kind};
use clap::Args;
use grafika::file::FileKind;
use grafika::launch::{Failure, write_output};
use std::path::PathBuf;

/// The command line of `grafika convert`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika convert A.IP2 a.json
  cat points.csv | grafika convert - a.ip2 --from csv
  grafika convert A.ZMS - --to json > a.json")]
pub(crate) struct Convert {
    #[command(flatten)]
    source: Source,
    /// The file to write; its extension says the format; - is standard output, with --to
    output: PathBuf,
    /// Format of what is written (ip2, json, csv, ...), where no name says it
    #[arg(long, value_name = "EXT", value_parser = kind_by_extension)]
    to: Option<FileKind>,
}

impl Convert {
    /// Converts.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let to = output_kind(&self.output, self.to)?;
        let opened = self.source.open()?;
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
