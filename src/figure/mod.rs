//! Pictures, tables and models for other programs: the screen as PNG, SVG or PDF, curves and surfaces with
//! their control points as SVG, PNG or PDF, samples of them as CSV or JSON, surfaces as meshes (OBJ, STL, PLY) and
//! exactly (STEP), rational curves of the plane exactly as well.
//!
//! A [`Figure`] is a picture in world coordinates, built once and written in any of the formats. This room turns
//! values into bytes or text. It writes no files and does not decide what to draw.
//!
//! A closed spline with its control points:
//!
//! ```
//! use grafika::figure::{Figure, Style};
//! use grafika::geometry::{Closure, Curve, Method, ParamCurve};
//!
//! let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
//! let curve = Curve::through(Method::Spline, Closure::Closed, &points)?;
//! let mut figure = Figure::new();
//! figure.set_title("Spline");
//! figure.curve(curve.to_cubics(1e-6)?, Closure::Closed, Style::line([0, 0, 160], 2.0));
//! for (index, &point) in points.iter().enumerate() {
//!     figure.disc(point, 5.0, Style::filled([255, 255, 255], [0, 0, 0]), Some(format!("{}", index + 1)));
//! }
//! let svg = figure.to_svg()?;
//! assert!(svg.contains("M0 0 C"));
//! let png = figure.to_png(400)?;
//! assert!(png.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axes;
mod buckets;
mod closed;
mod error;
mod layout;
mod legend;
mod letters;
mod mesh;
mod mesh_rows;
mod model;
mod narrow;
mod number;
mod pdf;
mod pdf_forms;
mod ph;
mod picture;
mod plot;
mod raster;
mod raster_letters;
mod screen_png;
mod screen_shapes;
mod skin;
mod step;
mod step_curve;
mod stl;
mod svg;
mod table;
mod tree;
mod wireframe;
mod wrap;

pub use axes::Axes;
pub use error::FigureError;
pub use mesh::Mesh;
pub use model::{MODEL_TOLERANCE, Model, ModelFormat, ModelOptions};
pub use ph::{CUT_INK, OFFSET_INK};
pub use picture::{Figure, LARGEST_WIDTH, LONGEST_CAPTION, NOMINAL_WIDTH, SMALLEST_WIDTH, Style};
pub use plot::{CURVE_INK, Hidden, SERIES_INKS, closure, point_labels, print_ink, tolerance};
pub use screen_png::{LARGEST_SCALE, screen_png, screen_png_of_scale};
pub use screen_shapes::{screen_pdf, screen_svg};
pub use skin::{is_hole, outline_step};
pub use step::{surface_step, surfaces_step};
pub use step_curve::{StepCurve, curves_step};
pub use stl::Stl;
pub use table::{
    CurveRow, TableFormat, curve_csv, curve_json, quantity_csv, quantity_json, surface_csv, surface_json,
    write_curve, write_quantities, write_surface,
};
pub use wireframe::{all_lines, visible_lines};
pub use wrap::wrap;
