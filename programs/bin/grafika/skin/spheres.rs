//! The skin of spheres as a picture, as JSON, as a mesh, or exactly for CAD programs.

use super::{SkinCommand, Wanted, check, complain};
use crate::picture::{Format, picture};
use grafika::design::skin::spheres;
use grafika::figure::{Figure, Hidden, MODEL_TOLERANCE, ModelFormat, ModelOptions, NOMINAL_WIDTH};
use grafika::file::{SPACE_VIEW, Spheres};
use grafika::geometry::skin::{Clearing, MESH_STEPS, SphereSkin};
use grafika::geometry::{Grid, View};
use grafika::launch::{Failure, progress, say};
use serde_json::{Value, json};

/// Lines of a picture: steps of a quarter turn and of a span.
const STEPS: usize = 6;

impl SkinCommand {
    /// Computes and writes the skin of spheres.
    pub(super) fn of_spheres(&self, name: &str, document: &Spheres) -> Result<(), Failure> {
        let spheres = spheres(document).map_err(|error| Failure::work(format!("{name}: {error}")))?;
        let violations = spheres.violations();
        if self.check {
            return check(name, &violations, "sphere");
        }
        let wanted = self.wanted()?;
        let alive = progress::alive("putting on the skin");
        let skin = spheres.skin(if self.plain { Clearing::Plain } else { Clearing::Scaled });
        if !skin.is_whole() {
            let missing = skin.arms.iter().flat_map(|arm| &arm.missing).next();
            return Err(complain(name, &violations, "sphere", missing.copied()));
        }
        let content = match wanted {
            Wanted::Json => format!("{}\n", written(&skin)).into_bytes(),
            Wanted::Other(format) => self.surface(&skin, format)?,
        };
        drop(alive);
        if let Some(violation) = violations.first() {
            say("grafika", &format!("{name} is not admissible: {}", violation.sentence("sphere")));
        }
        self.overwrite.write(self.output.as_deref(), &content)
    }

    fn surface(&self, skin: &SphereSkin, format: Format) -> Result<Vec<u8>, Failure> {
        let parts = skin.parts();
        let Some(model) = format.model() else {
            let grids = parts.iter().map(|part| part.grid(STEPS)).collect::<Result<Vec<Grid>, _>>();
            let mut figure = Figure::new();
            let view = View::from_direction(SPACE_VIEW);
            figure.plot_surfaces(&grids.map_err(Failure::work)?, &view, Hidden::LeftOut);
            return picture(&figure, format, NOMINAL_WIDTH);
        };
        let name = self.part_name();
        // A quarter turn and a span have the same number of steps.
        let options = ModelOptions { steps: MESH_STEPS[1], tolerance: MODEL_TOLERANCE, name: &name };
        let (content, warning) = ModelFormat::encode(model, &parts, &options).map_err(Failure::work)?;
        if let Some(warning) = warning {
            say("grafika", &warning);
        }
        Ok(content)
    }
}

fn written(skin: &SphereSkin) -> Value {
    let circles = skin
        .circles()
        .into_iter()
        .map(|circle| json!({ "center": circle.center, "axis": circle.axis, "radius": circle.radius }));
    json!({ "format": "SKN", "circles": circles.collect::<Vec<_>>(), "unclear": skin.unclear() })
}
