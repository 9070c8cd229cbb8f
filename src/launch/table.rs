//! The options that say how a table of text is read.

use super::words;
use crate::file::{Columns, Decimal, Delimiter, TableOptions};
use clap::Args;

/// What the command line says about a table that is read.
#[derive(Args, Clone, Debug, Default)]
pub struct TableArgs {
    /// Columns of a table that hold x,y or x,y,z, by their names or numbers from 1
    #[arg(long, value_name = "A,B[,C]")]
    columns: Option<Columns>,
    /// What separates the cells of a table: comma, semicolon, tab, blanks
    #[arg(long, value_name = "SIGN", add = words(&["comma", "semicolon", "tab", "blanks"]))]
    delimiter: Option<Delimiter>,
    /// The decimal sign of a table's numbers: point, comma
    #[arg(long, value_name = "SIGN", add = words(&["point", "comma"]))]
    decimal: Option<Decimal>,
}

impl TableArgs {
    /// The names of the options, for commands that hide them.
    pub(super) const NAMES: [&'static str; 3] = ["columns", "delimiter", "decimal"];

    /// An option that is given.
    pub(super) fn given(&self) -> Option<&'static str> {
        let given = [
            ("--columns", self.columns.is_some()),
            ("--delimiter", self.delimiter.is_some()),
            ("--decimal", self.decimal.is_some()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }

    /// The options as the readers of files take them.
    #[must_use]
    pub fn options(&self) -> TableOptions {
        TableOptions { columns: self.columns.clone(), delimiter: self.delimiter, decimal: self.decimal }
    }
}
