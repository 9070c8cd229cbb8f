//! What a command reads and writes: files by name, or standard input and output with a format that is said.

use crate::sample::extension;
use clap::Args;
use grafika::file::{Document, FileKind, Format};
use grafika::launch::{
    CloudFile, Failure, Opened, Overwrite, TableArgs, answer, input_kind, kind_of, meant, open_as, open_cloud,
};
use std::path::{Path, PathBuf};

/// The file that a command reads.
#[derive(Args)]
pub(crate) struct Source {
    /// Data file, built-in sample, or - for standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) from: InputFormat,
    #[command(flatten)]
    table: TableArgs,
}

/// The format of what is read.
#[derive(Args)]
pub(crate) struct InputFormat {
    /// Format of what is read (ip2, zms, json, csv, ...), where no name says it
    #[arg(long, value_name = "EXT", value_parser = input_kind_by_extension)]
    pub(crate) from: Option<FileKind>,
}

impl Source {
    /// A file with what is said about it.
    pub(crate) fn new(file: PathBuf, from: Option<FileKind>, table: TableArgs) -> Source {
        Source { file, from: InputFormat { from }, table }
    }

    /// The kind of what is read, as said or by the name, if either tells.
    pub(crate) fn kind(&self) -> Option<FileKind> {
        self.from.from.or_else(|| input_kind(&self.file))
    }

    /// Reads the file or standard input as a cloud of points, with its name for messages.
    pub(crate) fn open_cloud(&self) -> Result<(String, Document), Failure> {
        let (name, cloud) = open_cloud(&self.file, self.from.from, &self.table.options())?;
        Ok((name, Document::Cloud(cloud)))
    }

    /// The file, if it is one of a cloud that can be read several times; tables may be clouds.
    pub(crate) fn cloud_file(&self, tables: bool) -> Option<CloudFile> {
        CloudFile::new(&self.file, self.from.from, &self.table.options(), tables)
    }

    /// Reads the file or standard input.
    pub(crate) fn open(&self) -> Result<Opened, Failure> {
        let known = self.from.from.is_some() || is_stream(&self.file) || self.file.is_dir();
        if let (false, Err(failure)) = (known || input_kind(&self.file).is_some(), kind_of(&self.file)) {
            return Err(Failure::work(format!("{failure}; --from says what else it holds")));
        }
        open_as(&self.file, self.from.from, &self.table.options())
    }
}

/// Refuses to write a result that is not the data any more over the data themselves.
pub(crate) fn apart(input: &Path, output: Option<&Path>) -> Result<(), Failure> {
    let Some(output) = output.filter(|path| !is_stream(path)) else { return Ok(()) };
    match (dunce::canonicalize(input), dunce::canonicalize(output)) {
        (Ok(read), Ok(written)) if read == written => Err(Failure::usage(format!(
            "{} is the file that is read: name another one for the result",
            output.display()
        ))),
        _ => Ok(()),
    }
}

/// Whether a name stands for standard input or output.
pub(crate) fn is_stream(path: &Path) -> bool {
    path == Path::new("-")
}

/// The format of a file that is written: as said, else by its name.
pub(crate) fn output_kind(path: &Path, said: Option<FileKind>) -> Result<FileKind, Failure> {
    match said {
        Some(kind) => Ok(kind),
        None if is_stream(path) => {
            Err(Failure::usage("- has no extension: say what to write, as in --to json"))
        }
        None => kind_of(path).map_err(|failure| Failure::work(format!("{failure}; --to says what to write"))),
    }
}

/// A kind of file that is read by its extension, with or without a dot.
fn input_kind_by_extension(text: &str) -> Result<FileKind, String> {
    FileKind::from_input_extension(text.trim_start_matches('.')).map_or_else(|| kind_by_extension(text), Ok)
}

/// A kind of file that is written by its extension, with or without a dot.
pub(crate) fn kind_by_extension(text: &str) -> Result<FileKind, String> {
    FileKind::from_extension(text.trim_start_matches('.')).ok_or_else(|| {
        let known = Format::ALL.iter().map(|format| format.extension().to_lowercase());
        let known: Vec<String> = known.chain(["json", "csv"].map(str::to_owned)).collect();
        let alike = meant(text.trim_start_matches('.'), known.iter().map(String::as_str));
        format!("no data file has this extension{alike}; there are {}", known.join(" "))
    })
}

/// Where an answer goes, and whether it is text or JSON.
#[derive(Args)]
pub(crate) struct Answer {
    /// Where to write; .json or .txt [default: text on standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Format of what is written, json or txt, where no name says it
    #[arg(long, value_name = "EXT", value_parser = ["json", "txt"], ignore_case = true)]
    to: Option<String>,
    #[command(flatten)]
    overwrite: Overwrite,
}

impl Answer {
    /// Whether JSON is asked for; `what` names the answer in the message about another format.
    pub(crate) fn is_json(&self, what: &str) -> Result<bool, Failure> {
        let said = self.to.as_ref().map(|said| said.to_lowercase());
        match said.or_else(|| extension(self.output.as_deref())).as_deref() {
            None | Some("txt") => Ok(false),
            Some("json") => Ok(true),
            Some(other) => {
                Err(Failure::usage(format!("-o: {what} are written as .json or .txt, not .{other}")))
            }
        }
    }

    /// Refuses to write the answer over the data.
    pub(crate) fn apart(&self, input: &Path) -> Result<(), Failure> {
        apart(input, self.output.as_deref())
    }

    /// Writes an answer in words, on standard output in the user's language.
    pub(crate) fn tell(&self, text: &str) -> Result<(), Failure> {
        match &self.output {
            Some(_) => self.write(text.as_bytes()),
            None => answer(text),
        }
    }

    /// Writes the answer.
    pub(crate) fn write(&self, content: &[u8]) -> Result<(), Failure> {
        self.overwrite.write(self.output.as_deref(), content)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extensions_with_and_without_a_dot() {
        assert_eq!(kind_by_extension(".ZMS"), Ok(FileKind::Dos(Format::Zms)));
        assert_eq!(kind_by_extension("json"), Ok(FileKind::Json));
        let message = kind_by_extension("doc").unwrap_err();
        for format in Format::ALL {
            assert!(message.contains(&format.extension().to_lowercase()), "{format}");
        }
    }

    #[test]
    fn a_stream_needs_a_format() {
        assert!(output_kind(Path::new("-"), None).is_err());
        assert_eq!(output_kind(Path::new("-"), Some(FileKind::Csv)).ok(), Some(FileKind::Csv));
        assert_eq!(output_kind(Path::new("a.json"), None).ok(), Some(FileKind::Json));
    }
}
