//! How curves and patches are drawn. Colours are those of the screen, 0 to 15.

use crate::file::FileError;
use serde::{Deserialize, Serialize};

/// How a curve is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CurveStyle {
    /// The colour of the curve.
    pub colour: u8,
    /// Whether the control polygon is seen always, and not only while the curve is selected.
    pub polygon: bool,
    /// Whether the first derivatives are seen as needles.
    pub first: bool,
    /// Whether the second derivatives are.
    pub second: bool,
    /// The length of a needle for a derivative of 1.
    pub scale: f64,
    /// The colour of first derivatives.
    pub first_colour: u8,
    /// The colour of second derivatives.
    pub second_colour: u8,
    /// Whether the curve is left out of the picture.
    pub hidden: bool,
}

impl Default for CurveStyle {
    fn default() -> Self {
        Self {
            colour: 15,
            polygon: false,
            first: false,
            second: false,
            scale: 0.25,
            first_colour: 12,
            second_colour: 9,
            hidden: false,
        }
    }
}

/// How a patch is filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fill {
    /// All lines.
    Wires,
    /// The lines that nothing hides.
    Hidden,
    /// Dithered by the light in the tones of its material.
    #[default]
    Shaded,
    /// Stripes of equal brightness.
    Zebra,
    /// Coloured by Gaussian curvature.
    Gaussian,
    /// Coloured by mean curvature.
    Mean,
    /// Coloured by height.
    Height,
}

impl Fill {
    /// All, in the order in which they are chosen.
    pub const ALL: [Self; 7] =
        [Self::Wires, Self::Hidden, Self::Shaded, Self::Zebra, Self::Gaussian, Self::Mean, Self::Height];
}

/// What a shaded patch is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs, reason = "their names say what they are")]
pub enum Material {
    #[default]
    Brass,
    Gold,
    Silver,
    Emerald,
    Pearl,
    Ruby,
    Turquoise,
    Copper,
    Sapphire,
    Rubber,
}

impl Material {
    /// All, in the order in which they are chosen.
    pub const ALL: [Self; 10] = [
        Self::Brass,
        Self::Gold,
        Self::Silver,
        Self::Emerald,
        Self::Pearl,
        Self::Ruby,
        Self::Turquoise,
        Self::Copper,
        Self::Sapphire,
        Self::Rubber,
    ];
}

/// Where the light comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Light {
    /// From the eye.
    #[default]
    Eye,
    /// From above at the left.
    UpperLeft,
}

/// How a patch is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PatchStyle {
    /// Whether the control net is seen always, and not only while the patch is selected.
    pub polygon: bool,
    /// Whether normals are seen as needles.
    pub normals: bool,
    /// The numbers of lines of constant u and of constant v over the filled patch.
    pub isolines: [usize; 2],
    /// How the patch is filled.
    pub fill: Fill,
    /// What it is made of.
    pub material: Material,
    /// The length of a normal.
    pub scale: f64,
    /// The colour of normals.
    pub normal_colour: u8,
    /// The colour of lines.
    pub line_colour: u8,
    /// Whether the patch is left out of the picture.
    pub hidden: bool,
}

impl Default for PatchStyle {
    fn default() -> Self {
        Self {
            polygon: false,
            normals: false,
            isolines: [5, 3],
            fill: Fill::Shaded,
            material: Material::Brass,
            scale: 0.25,
            normal_colour: 14,
            line_colour: 15,
            hidden: false,
        }
    }
}

impl CurveStyle {
    pub(super) fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    pub(super) fn check(&self) -> Result<(), FileError> {
        check(&[self.colour, self.first_colour, self.second_colour], self.scale)
    }
}

impl PatchStyle {
    pub(super) fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    pub(super) fn check(&self) -> Result<(), FileError> {
        if let Some(count) = self.isolines.iter().find(|&&count| count > 100) {
            return Err(FileError::Invalid(format!("isolines: {count} lines; there may be 0 to 100")));
        }
        check(&[self.normal_colour, self.line_colour], self.scale)
    }
}

fn check(colours: &[u8], scale: f64) -> Result<(), FileError> {
    colours.iter().try_for_each(|&colour| super::scene::colour(colour))?;
    match scale.is_finite() && scale > 0.0 {
        true => Ok(()),
        false => Err(FileError::Invalid(format!("scale {scale}; it must be a positive number"))),
    }
}
