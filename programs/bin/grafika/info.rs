//! `grafika info`: what data files hold.

use crate::source::{InputFormat, Source};
use crate::space;
use clap::Args;
use grafika::file::Document;
use grafika::launch::{Failure, TableArgs, answer, say, write_output};
use grafika::screen::visible;
use serde_json::{Value, json};
use std::path::PathBuf;

/// The command line of `grafika info`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika info A.IP2
  grafika info A.IP2 B.IP2 --json
  grafika info \"0^3,i^2,2i\"
  grafika info measured.csv --columns time,volts
  cat a.json | grafika info - --from json")]
pub(crate) struct Info {
    /// Data files, built-in samples, the text of a space, or - for standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    from: InputFormat,
    #[command(flatten)]
    table: TableArgs,
    /// Tell the same as JSON: a list with an object for every file
    #[arg(long)]
    json: bool,
}

impl Info {
    /// Tells what the files hold. Of several, one that cannot be read is told on stderr, and the others are told all the same.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let (mut text, mut list, mut failed) = (String::new(), Vec::new(), None);
        for file in &self.files {
            let document = match self.document(file) {
                Ok(document) => document,
                Err(failure) if self.files.len() == 1 => return Err(failure),
                Err(failure) => {
                    failed.iter().for_each(|failure: &Failure| say("grafika", &failure.to_string()));
                    failed = Some(failure);
                    continue;
                }
            };
            let lines = document.describe();
            if self.json {
                list.push(as_json(file, &document, &lines));
                continue;
            }
            if self.files.len() > 1 {
                let gap = if text.is_empty() { "" } else { "\n" };
                text += &format!("{gap}{}:\n", visible(&file.display().to_string()));
            }
            text.extend(lines.iter().map(|line| format!("{}\n", visible(line))));
        }
        match self.json {
            true => write_output(format!("{:#}\n", Value::Array(list)).as_bytes())?,
            false => answer(&text)?,
        }
        failed.map_or(Ok(()), Err)
    }

    fn document(&self, file: &std::path::Path) -> Result<Document, Failure> {
        let source = Source::new(file.to_path_buf(), self.from.from, self.table.clone());
        Ok(match space::written(&source)? {
            Some(space) => space.into(),
            None => source.open()?.document,
        })
    }
}

fn as_json(file: &std::path::Path, document: &Document, lines: &[String]) -> Value {
    let format = document.format();
    json!({
        "file": file.display().to_string(),
        "format": format.extension(),
        "what": format.english(),
        "facts": lines,
    })
}
