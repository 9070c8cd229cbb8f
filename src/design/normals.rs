//! Surfaces with Pythagorean normals: the normals of a net, and rational patches that were written down.

use super::{DesignError, Index, NetDesign};
use crate::file::{Method, NetKind, PatchItem, Patches};
use crate::geometry::{
    Method as Formula, ParamSurface, PnData, PnMethod, PnNet, Point, RationalPatch, RationalPatches, Scheme,
    Surface, Topology, norm,
};

/// The fewest and the most points of an editor's net with normals, in either direction.
pub const NORMALS_SIZE: std::ops::RangeInclusive<usize> = 2..=8;

impl NetDesign {
    /// Whether the surface has Pythagorean normals, and by which method; `None` for other surfaces.
    #[must_use]
    pub fn pn_method(&self) -> Option<PnMethod> {
        match self.method() {
            Method::Pn => Some(PnMethod::Normalised),
            Method::PnThesis => Some(PnMethod::Thesis),
            _ => None,
        }
    }

    /// The points with their normals, which follow from the points if the net has none.
    ///
    /// # Errors
    /// Those of [`PnData`].
    pub fn normals_data(&self) -> Result<PnData, DesignError> {
        let points = &self.net.points;
        Ok(match &self.net.normals {
            Some(normals) => PnData::new(points, normals)?,
            None => PnData::automatic(points)?,
        })
    }

    /// All patches of the surface with Pythagorean normals, also those that are parabolic somewhere.
    ///
    /// # Errors
    /// Those of [`NetDesign::scheme`], [`PnData`] and [`PnNet::new`]; [`DesignError::Needs`] for another method.
    pub fn patches_with_normals(&self) -> Result<PnNet, DesignError> {
        self.scheme()?;
        let method = self.pn_method().ok_or(DesignError::Needs(Method::Pn))?;
        Ok(PnNet::new(&self.normals_data()?, method)?)
    }

    /// The normal in a point that the net itself has.
    #[must_use]
    pub fn normal(&self, [k, l]: Index) -> Option<Point<3>> {
        self.net.normals.as_ref()?.get(k)?.get(l).copied()
    }

    /// The design with another normal in a point, made a unit vector; unchanged where it has no length.
    #[must_use]
    pub fn with_normal(&self, [k, l]: Index, normal: Point<3>) -> NetDesign {
        let mut design = self.with_given_normals();
        let length = norm(normal);
        let unit = normal.map(|x| x / length);
        if unit.iter().all(|x| x.is_finite())
            && let Some(place) =
                design.net.normals.as_mut().and_then(|rows| rows.get_mut(k)).and_then(|row| row.get_mut(l))
        {
            *place = unit;
        }
        design
    }

    /// The design with the normals of the bicubic spline through its points; unchanged where that has none.
    #[must_use]
    pub fn with_automatic_normals(&self) -> NetDesign {
        let mut design = self.clone();
        if let Ok(data) = PnData::automatic(&self.net.points) {
            design.net.normals = Some(rows(&data, PnData::normal));
        }
        design
    }

    /// The design with normals that are its own and no longer follow from the points.
    #[must_use]
    pub fn with_given_normals(&self) -> NetDesign {
        if self.net.normals.is_some() { self.clone() } else { self.with_automatic_normals() }
    }

    /// The distance of the offset beside the surface; 0 is none.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.net.settings.distance.unwrap_or(0.0)
    }

    /// The design with as many points along u and v, taken from its surface with their normals; where there is no
    /// surface with normals, from the bicubic spline through its points.
    ///
    /// # Errors
    /// The points have no spline.
    pub fn resized(&self, size: [usize; 2]) -> Result<NetDesign, DesignError> {
        let pn = self.patches_with_normals().and_then(|net| Ok(net.surface()?)).ok();
        let spline;
        let surface: &dyn ParamSurface = match &pn {
            Some(surface) => surface,
            None => {
                spline = Surface::new(Scheme::new(Formula::Spline, Topology::Open), &self.net.points)?;
                &spline
            }
        };
        let place = |k: usize, direction: usize| {
            let spans = surface.spans()[direction];
            let along = spans as f64 * k as f64 / size[direction].saturating_sub(1).max(1) as f64;
            let span = (along as usize).min(spans.saturating_sub(1));
            (span, along - span as f64)
        };
        let net = |at: &dyn Fn([usize; 2], [f64; 2]) -> Option<Point<3>>| -> Option<Vec<Vec<Point<3>>>> {
            let row = |k: usize| {
                let point = |l: usize| {
                    let [(i, u), (j, v)] = [place(k, 0), place(l, 1)];
                    at([i, j], [u, v])
                };
                (0..size[1]).map(point).collect()
            };
            (0..size[0]).map(row).collect()
        };
        let mut design = self.clone();
        if let Some(points) = net(&|spans, uv| surface.eval(spans, uv)) {
            design.net.points = points;
            design.net.normals = match &pn {
                Some(pn) => net(&|spans, uv| pn.place(spans, uv).map(|place| place.normal)),
                None => None,
            };
        }
        Ok(design.with_given_normals())
    }

    /// Whether normals may be edited: those of a net of [`NetKind::Pn`].
    #[must_use]
    pub fn has_normals(&self) -> bool {
        self.net.kind == NetKind::Pn
    }
}

/// A value of every point, row by row.
fn rows(data: &PnData, value: impl Fn(&PnData, usize, usize) -> Option<Point<3>>) -> Vec<Vec<Point<3>>> {
    let [rows, columns] = data.size();
    (0..rows).map(|k| (0..columns).map(|l| value(data, k, l).unwrap_or_default()).collect()).collect()
}

/// The surface of rational patches.
///
/// # Errors
/// [`DesignError::PatchMissing`] where the net of patches has a gap or a place is there twice, and a patch that is none.
pub(super) fn patches(written: &Patches) -> Result<RationalPatches, DesignError> {
    let count = |along: fn(&PatchItem) -> usize| {
        written.patches.iter().map(along).max().map_or(0, |last| last.saturating_add(1))
    };
    let size = [count(|patch| patch.i), count(|patch| patch.j)];
    let needed = size[0].saturating_mul(size[1]);
    // As many as there are: so a gap shows before anything of its size is made.
    if needed == 0 || needed > written.patches.len() {
        let gap = (0..=written.patches.len()).find_map(|index| {
            let place = [index / size[1].max(1), index % size[1].max(1)];
            (!written.patches.iter().any(|patch| [patch.i, patch.j] == place)).then_some(place)
        });
        return Err(DesignError::PatchMissing(gap.unwrap_or_default()));
    }
    let mut patches = Vec::with_capacity(needed);
    for index in 0..needed {
        let place = [index / size[1], index % size[1]];
        let mut found = written.patches.iter().filter(|patch| [patch.i, patch.j] == place);
        match (found.next(), found.next()) {
            (Some(patch), None) => patches.push(RationalPatch::new(&patch.homogeneous)?),
            (None, _) => return Err(DesignError::PatchMissing(place)),
            (Some(_), Some(_)) => return Err(DesignError::PatchTwice(place)),
        }
    }
    Ok(RationalPatches::new(size, patches)?)
}
