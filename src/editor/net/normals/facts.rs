//! What the editor says about a surface with Pythagorean normals.

use super::by_the_other;
use crate::design::NetDesign;
use crate::geometry::{Jacobian, Overview, ParamSurface, PnNet, Point, norm};
use serde::Serialize;

/// Places along each direction of a patch: at rest, and while something is dragged.
const PLACES: usize = 9;
const FEWER: usize = 4;
/// Steps of a patch where surfaces are compared.
const COMPARED: usize = 6;

/// Facts about the surface of a net.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::editor::net) struct Facts {
    /// The net that they are about, and whether the other method was looked at.
    of: (NetDesign, bool, bool),
    pub(super) told: Told,
}

/// The facts as `dump` writes them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(in crate::editor::net) struct Told {
    /// The number of patches, and of those that are parabolic somewhere.
    pub(super) patches: usize,
    pub(super) parabolic: usize,
    /// Whether J is positive in all others.
    pub(super) positive: bool,
    pub(super) r1: Option<[f64; 2]>,
    pub(super) r2: Option<[f64; 2]>,
    /// Between which distances there are no folds; `None` where the surface itself is folded.
    pub(super) limits: Option<[Option<f64>; 2]>,
    /// The largest distance from the best sphere.
    pub(super) sphere: Option<f64>,
    /// The largest distance between the methods.
    pub(super) apart: Option<f64>,
}

impl Facts {
    /// The facts of a net; while it is being dragged, from fewer places.
    pub(in crate::editor::net) fn of(net: &NetDesign, compared: bool, dragged: bool) -> Facts {
        let told = net.patches_with_normals().map(|patches| told(net, &patches, compared, dragged));
        Facts { of: (net.clone(), compared, dragged), told: told.unwrap_or_default() }
    }

    /// Whether they are those of a net.
    pub(in crate::editor::net) fn are_of(&self, net: &NetDesign, compared: bool, dragged: bool) -> bool {
        self.of.1 == compared && self.of.2 == dragged && self.of.0 == *net
    }

    pub(in crate::editor::net) fn told(&self) -> &Told {
        &self.told
    }
}

fn told(net: &NetDesign, patches: &PnNet, compared: bool, dragged: bool) -> Told {
    let [rows, columns] = patches.size();
    let signs = (0..rows).flat_map(|i| (0..columns).filter_map(move |j| patches.jacobian(i, j)));
    let signs: Vec<Jacobian> = signs.collect();
    let overview = patches.overview(if dragged { FEWER } else { PLACES }, !dragged);
    let radii = |of: fn(&Overview) -> [f64; 2]| overview.as_ref().map(of);
    Told {
        patches: signs.len(),
        parabolic: signs.iter().filter(|sign| **sign == Jacobian::Changes).count(),
        positive: signs.iter().all(|sign| *sign != Jacobian::Negative),
        r1: radii(|it| it.r1),
        r2: radii(|it| it.r2),
        limits: overview.and_then(|it| it.limits).map(|limits| [limits.low, limits.high]),
        sphere: net.normals_data().ok().and_then(|data| data.sphere()).map(|(centre, radius)| {
            points(patches)
                .flatten()
                .map(|point| (apart(point, centre) - radius.abs()).abs())
                .fold(0.0, f64::max)
        }),
        apart: compared.then(|| by_the_other(net).patches_with_normals().ok()).flatten().map(|other| {
            let pairs = points(patches).zip(points(&other));
            let pairs = pairs.filter_map(|(one, other)| one.zip(other));
            pairs.map(|(one, other)| apart(one, other)).fold(0.0, f64::max)
        }),
    }
}

/// Places of all patches; `None` in those that are parabolic.
fn points(patches: &PnNet) -> impl Iterator<Item = Option<Point<3>>> + '_ {
    let [rows, columns] = patches.size();
    let places = (0..rows).flat_map(move |i| (0..columns).map(move |j| [i, j]));
    places.flat_map(|[i, j]| {
        let surface = patches.patch_surface(i, j).and_then(Result::ok);
        (0..(COMPARED + 1) * (COMPARED + 1)).map(move |k| {
            let place = |k: usize| k as f64 / COMPARED as f64;
            surface.as_ref()?.eval([0, 0], [place(k / (COMPARED + 1)), place(k % (COMPARED + 1))])
        })
    })
}

fn apart(a: Point<3>, b: Point<3>) -> f64 {
    norm::<3>(std::array::from_fn(|d| a[d] - b[d]))
}
