//! Pictures and models by the extensions of their files.

use crate::sample::extension;
use grafika::figure::{Figure, ModelFormat};
use grafika::launch::{Failure, meant, say};

/// A figure in the format of a picture.
pub(crate) fn picture(figure: &Figure, format: Format, width: u32) -> Result<Vec<u8>, Failure> {
    if figure.lacks_axes() {
        say("grafika", NO_AXES);
    }
    let content = match format {
        Format::Svg => figure.to_svg_of_width(width).map(String::into_bytes),
        Format::Pdf => figure.to_pdf_of_width(width),
        _ => figure.to_png(width),
    };
    content.map_err(Failure::work)
}

/// What is said where axes were asked for and cannot be drawn.
const NO_AXES: &str = "the picture has no axes: so far from the origin their numbers would need too many digits to be \
                       told apart; move the points nearer to the origin";

const FORMATS: &str =
    "pictures are written as .png .svg .pdf, surfaces also as .obj .stl .ply .step, PH curves also as .step";

/// The extensions.
pub(crate) const NAMES: [&str; 7] = ["png", "svg", "pdf", "obj", "stl", "ply", "step"];

/// What is written, by the extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Png,
    Svg,
    Pdf,
    Obj,
    Stl,
    Ply,
    Step,
}

impl Format {
    pub(crate) fn of(path: &std::path::Path) -> Result<Format, Failure> {
        let Some(extension) = extension(Some(path)) else {
            return Err(Failure::usage(format!("-o - has no extension; say it, as in --to png: {FORMATS}")));
        };
        Format::parse(&extension).map_err(|why| Failure::usage(format!("-o {}: {why}", path.display())))
    }

    /// The format of an extension without its dot, in any case.
    pub(crate) fn parse(extension: &str) -> Result<Format, String> {
        Ok(match extension.to_lowercase().as_str() {
            "png" => Format::Png,
            "svg" => Format::Svg,
            "pdf" => Format::Pdf,
            "obj" => Format::Obj,
            "stl" => Format::Stl,
            "ply" => Format::Ply,
            "step" | "stp" => Format::Step,
            other => return Err(format!("{FORMATS}{}", meant(other, NAMES))),
        })
    }

    /// The format of models; `None` for pictures.
    pub(crate) fn model(self) -> Option<ModelFormat> {
        match self {
            Format::Step => Some(ModelFormat::Step),
            Format::Stl => Some(ModelFormat::Stl),
            Format::Obj => Some(ModelFormat::Obj),
            Format::Ply => Some(ModelFormat::Ply),
            Format::Png | Format::Svg | Format::Pdf => None,
        }
    }

    pub(crate) fn is_model(self) -> bool {
        !matches!(self, Format::Png | Format::Svg | Format::Pdf)
    }
}
