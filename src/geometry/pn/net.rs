//! All patches of the data, and which of them are regular.

use super::bernstein::Tensor;
use super::chart::Chart;
use super::patch::{tensors, wedge};
use super::{PnData, PnMethod, PnSurface, isotropic};
use crate::geometry::{GeometryError, Patch};

/// How often a patch is quartered until its sign is given up.
const DEPTH: u32 = 6;
/// A Jacobian below this part of the product of the largest derivatives is zero.
const ZERO: f64 = 1e-12;
/// The rounding of the derivatives of p and q, whose coefficients are of the size of 1.
const ROUNDING: f64 = 1e-14;

/// The sign of the Jacobian of a patch's image on the sphere of normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Jacobian {
    /// Positive everywhere in the patch, proved by Bernstein coefficients.
    Positive,
    /// Negative everywhere in the patch, proved by Bernstein coefficients.
    Negative,
    /// Zero somewhere, or so near to zero that no sign can be proved: parabolic points.
    Changes,
}

impl Jacobian {
    /// Its name in files: `positive`, `negative`, `changes`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Positive => "positive",
            Self::Negative => "negative",
            Self::Changes => "changes",
        }
    }

    /// The sign of a patch.
    fn of(y: &Patch) -> Self {
        let [p, q, _] = tensors(y);
        let slopes = [&p, &q].into_iter().flat_map(|it| [it.derivative(0), it.derivative(1)]);
        let steepest = slopes.flat_map(|it| it.range()).fold(0.0_f64, |most, slope| most.max(slope.abs()));
        Self::proved(&wedge(&p, &q), (ZERO * steepest).max(ROUNDING) * steepest, DEPTH)
    }

    fn proved(tensor: &Tensor, zero: f64, depth: u32) -> Self {
        let [low, high] = tensor.range();
        if low > zero {
            return Self::Positive;
        }
        if high < -zero {
            return Self::Negative;
        }
        let corners = tensor.corners();
        let all = |sign: f64| corners.iter().all(|value| sign * value > zero);
        if depth == 0 || !(all(1.0) || all(-1.0)) {
            return Self::Changes;
        }
        let quarters = tensor.quarters();
        let whole = if corners[0] > 0.0 { Self::Positive } else { Self::Negative };
        let same = |quarter: &Tensor| Self::proved(quarter, zero, depth - 1) == whole;
        if quarters.iter().all(same) { whole } else { Self::Changes }
    }
}

/// The patches that interpolate a net of points and normals, each with the sign of its Jacobian. Parabolic
/// patches are among them, so that an editor can show the others.
///
/// ```
/// use grafika::geometry::{Jacobian, ParamSurface, PnData, PnMethod, PnNet};
///
/// // A bowl z = (x² + y²)/8 with the normals of a spline, which point upwards.
/// let at = |i: i32, j: i32| [f64::from(i), f64::from(j), f64::from(i * i + j * j) / 8.0];
/// let points: Vec<Vec<[f64; 3]>> = (-1..=1).map(|i| (-1..=1).map(|j| at(i, j)).collect()).collect();
/// let net = PnNet::new(&PnData::automatic(&points)?, PnMethod::Normalised)?;
/// assert_eq!((net.size(), net.jacobian(0, 1)), ([2, 2], Some(Jacobian::Negative)));
/// let middle = net.surface()?.eval([1, 1], [0.0, 0.0]).expect("there is such a patch");
/// assert!(middle.iter().all(|coordinate| coordinate.abs() < 1e-15));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PnNet {
    pub(super) chart: Chart,
    size: [usize; 2],
    patches: Vec<(Patch, Jacobian)>,
}

impl PnNet {
    /// The patches of some data.
    ///
    /// # Errors
    /// [`GeometryError::NormalsEqual`] for the data of a plane; normals that do not fit into one chart:
    /// [`GeometryError::NormalsTooWide`], with the thesis's method [`GeometryError::NormalUp`].
    pub fn new(data: &PnData, method: PnMethod) -> Result<Self, GeometryError> {
        let (chart, points, normals) = Chart::of(data, method)?;
        let patches = isotropic::patches(data.size(), &points, &normals, chart.projection);
        let patches = patches.into_iter().map(|y| (y, Jacobian::of(&y))).collect();
        Ok(Self { chart, size: data.size().map(|count| count.saturating_sub(1)), patches })
    }

    /// The numbers of patches along u and v.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    fn patch(&self, i: usize, j: usize) -> Option<(Patch, Jacobian)> {
        if j < self.size[1] { self.patches.get(i * self.size[1] + j).copied() } else { None }
    }

    /// The sign of a patch's Jacobian; `None` outside the net.
    #[must_use]
    pub fn jacobian(&self, i: usize, j: usize) -> Option<Jacobian> {
        self.patch(i, j).map(|(_, sign)| sign)
    }

    /// The Bézier points of a patch in the space of (p, q, r), in the chart of the data: (p, q) is the
    /// stereographic image of the normals, also where the patch is parabolic. `None` outside the net.
    #[must_use]
    pub fn isotropic(&self, i: usize, j: usize) -> Option<Patch> {
        self.patch(i, j).map(|(y, _)| y)
    }

    /// The whole surface.
    ///
    /// # Errors
    /// [`GeometryError::Parabolic`] names the first patch that is not regular.
    pub fn surface(&self) -> Result<PnSurface, GeometryError> {
        let parabolic = self.patches.iter().position(|(_, sign)| *sign == Jacobian::Changes);
        match parabolic {
            Some(index) => {
                Err(GeometryError::Parabolic { patch: [index / self.size[1], index % self.size[1]] })
            }
            None => Ok(PnSurface::of(self.chart, self.size, self.patches.clone())),
        }
    }

    /// A single patch as a surface of one span each way; `None` outside the net.
    ///
    /// # Errors
    /// [`GeometryError::Parabolic`] where it is not regular.
    #[must_use]
    pub fn patch_surface(&self, i: usize, j: usize) -> Option<Result<PnSurface, GeometryError>> {
        self.patch(i, j).map(|patch| match patch.1 {
            Jacobian::Changes => Err(GeometryError::Parabolic { patch: [i, j] }),
            _ => Ok(PnSurface::of(self.chart, [1, 1], vec![patch])),
        })
    }
}
