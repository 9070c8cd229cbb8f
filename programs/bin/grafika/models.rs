//! Surfaces as models for other programs, written as they are made: a mesh need not stand in memory.

use grafika::figure::{ModelFormat, ModelOptions};
use grafika::geometry::ParamSurface;
use grafika::launch::{Failure, Sort, Target, progress, say};

/// Writes a model of surfaces, and tells what the user should know about it.
pub(crate) fn write(
    target: &Target<'_>,
    format: ModelFormat,
    surfaces: &[&dyn ParamSurface],
    options: &ModelOptions<'_>,
) -> Result<(), Failure> {
    let sort = if format.is_text() { Sort::Text } else { Sort::Binary };
    let alive = progress::alive("drawing");
    let model = format.model(surfaces, options).map_err(Failure::work)?;
    drop(alive);
    if let Some(note) = &model.note {
        say("grafika", note);
    }
    target.write_with(sort, |out| Ok(model.write(out)?))
}
