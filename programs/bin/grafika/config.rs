//! `grafika config`: the settings of all programs on the command line.

use clap::Args;
use grafika::disk::ConfigFile;
use grafika::launch::{Failure, configure, settings, write_output};

/// The command line of `grafika config`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika config
  grafika config palette amber
  grafika config folder ~/curves
  grafika config --json
  grafika config --path")]
pub(crate) struct Config {
    /// The setting to show or change; without it, all of them
    #[arg(value_name = "SETTING")]
    key: Option<String>,
    /// Its new value
    #[arg(value_name = "VALUE")]
    value: Option<String>,
    /// Show where the settings are kept
    #[arg(long, conflicts_with = "key")]
    path: bool,
    /// Tell the settings as JSON
    #[arg(long, conflicts_with_all = ["path", "value"])]
    json: bool,
}

impl Config {
    /// Shows or changes settings.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.path {
            let path = ConfigFile::path()
                .ok_or_else(|| Failure::work("the environment names no home folder to keep settings in"))?;
            return write_output(format!("{}\n", path.display()).as_bytes());
        }
        if self.json {
            let told = settings(self.key.as_deref())?;
            return write_output(format!("{told}\n").as_bytes());
        }
        write_output(configure(self.key.as_deref(), self.value.as_deref())?.as_bytes())
    }
}
