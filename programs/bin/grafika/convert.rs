//! `grafika convert`: a data file in another format.

use crate::source::{Source, is_stream, kind_by_extension, output_kind};
use clap::Args;
use grafika::design::{self, NetDesign};
use grafika::file::ec::EcDocument;
use grafika::file::{CloudFormat, CloudWriter, Document, FileKind, Format, Method, PlanePoints};
use grafika::launch::{Broken, CloudFile, CloudSurvey, Failure, Opened, Overwrite, Sort, say};
use grafika::machine::Language;
use grafika::work;
use std::path::{Path, PathBuf};

/// The command line of `grafika convert`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika convert A.IP2 a.json
  cat points.csv | grafika convert - a.ip2 --from csv
  grafika convert A.ZMS - --to json > a.json
  grafika convert A.IC2 b.ic2
  grafika convert scan.ply scan.xyz")]
pub(crate) struct Convert {
    #[command(flatten)]
    source: Source,
    /// The file to write; its extension says the format; - is standard output, with --to
    output: PathBuf,
    /// Format of what is written (ip2, json, csv, ...), where no name says it
    #[arg(long, value_name = "EXT", value_parser = kind_by_extension)]
    to: Option<FileKind>,
    #[command(flatten)]
    overwrite: Overwrite,
}

impl Convert {
    /// Converts, and names on stderr what has no place in the target.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let to = output_kind(&self.output, self.to)?;
        let cloud = match to {
            FileKind::Dos(format) => CloudFormat::of(format).is_some(),
            FileKind::Json | FileKind::Csv => false,
        };
        // A cloud of which another one is made is not kept in memory.
        let rows = cloud || matches!(to, FileKind::Json | FileKind::Csv);
        if let Some(file) = self.source.cloud_file(cloud).filter(|_| rows) {
            return self.stream(&file, to);
        }
        let (name, document) = match self.source.kind() {
            // Of a table that becomes a cloud, columns behind the coordinates are passed over.
            Some(FileKind::Csv) if cloud => self.source.open_cloud()?,
            _ => {
                let Opened { name, document, .. } = self.source.open()?;
                (name, document)
            }
        };
        if let Document::Cloud(cloud) = &document {
            for told in cloud.skipped.told() {
                say("grafika", &format!("{name}: left out: {told}"));
            }
        }
        let output = self.output.display().to_string();
        let encoded = |document: &Document| {
            let content = document.encode(to);
            content.map_err(|error| Failure::work(format!("{name} as {output}: {error}")))
        };
        let mut lost = Vec::new();
        let mut twin = None;
        let content = match to {
            FileKind::Json => encoded(&document)?,
            FileKind::Csv => {
                lost = extras(&document);
                encoded(&bare(document))?
            }
            FileKind::Dos(format) if cloud => {
                lost = extras(&document);
                encoded(&document.adapted(format))?
            }
            FileKind::Dos(format) => {
                lost = design::lost(&document, format, implied(&document, format));
                let files = work::dos_files(&document, format, &output);
                let mut files = files
                    .map_err(|problem| Failure::work(format!("{name} as {}", problem.of(Language::English))))?
                    .into_iter();
                let content = files.next().map(|(_, content)| content).unwrap_or_default();
                twin = files.next();
                content
            }
        };
        if is_stream(&self.output) && twin.take().is_some() {
            lost.push("tangents".to_owned());
        }
        self.overwrite.write(Some(&self.output), &content)?;
        if let Some((name, content)) = twin {
            // Only the extension differs.
            let extension = Path::new(&name).extension().unwrap_or_default();
            self.overwrite.write(Some(&self.output.with_extension(extension)), &content)?;
        }
        if !lost.is_empty() {
            let target = if is_stream(&self.output) { "standard output".to_owned() } else { output };
            say("grafika", &format!("{target} has no place for: {}", lost.join(", ")));
        }
        Ok(())
    }

    /// Converts a cloud row by row. It is read twice: how many points there are, and whether they lie in the plane, is
    /// written first.
    fn stream(&self, file: &CloudFile, to: FileKind) -> Result<(), Failure> {
        let (name, output) = (file.name(), self.output.display());
        let CloudSurvey { count, plane, skipped } = file.survey()?;
        for told in skipped.told() {
            say("grafika", &format!("{name}: left out: {told}"));
        }
        let mut writer = CloudWriter::new(to, count, plane)
            .map_err(|error| Failure::work(format!("{name} as {output}: {error}")))?;
        let sort = if to == FileKind::Dos(Format::Ply) { Sort::Binary } else { Sort::Text };
        self.overwrite.target(Some(&self.output))?.write_with(sort, |out| {
            let mut written = 0;
            writer.begin(out)?;
            file.points(|points| {
                written += points.len();
                writer.points(out, points).map_err(Broken::from)
            })?;
            if written != count {
                let problem = "it has changed while it was read; it is left unconverted";
                return Err(Failure::work(format!("{name}: {problem}")).into());
            }
            Ok(writer.end(out)?)
        })
    }
}

/// The method that a surface of this format has without naming it.
fn implied(document: &Document, format: Format) -> Option<Method> {
    match document.clone().adapted(format) {
        Document::Net(net) => Some(NetDesign::new(net).implied),
        _ => None,
    }
}

/// The names of what belongs to control points besides their coordinates.
fn extras(document: &Document) -> Vec<String> {
    let mut extras = document.settings();
    extras.extend(design::without_points(document));
    if let Document::PlanePoints(plane) = document {
        extras.extend(plane.tangents.iter().map(|_| "tangents".to_owned()));
        extras.extend(plane.joints.iter().map(|_| "joints".to_owned()));
    }
    if let Document::SpacePoints(space) = document {
        extras.extend(space.tangents.iter().map(|_| "tangents".to_owned()));
    }
    if let Document::Ec(document) = document
        && let EcDocument::Curve(curve) = &**document
    {
        extras.extend(["roots", "interval"].map(str::to_owned));
        extras.extend(curve.exact.iter().map(|_| "exact".to_owned()));
        extras.extend(curve.name.iter().map(|_| "name".to_owned()));
    }
    extras
}

/// The document without them.
fn bare(document: Document) -> Document {
    match document.without_settings() {
        Document::PlanePoints(plane) => Document::PlanePoints(PlanePoints::new(plane.points)),
        other => other,
    }
}
