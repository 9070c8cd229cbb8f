//! The skin of spheres: tubes, end caps, and both as a closed mesh.

use super::end_cap::EndCap;
use super::frame::{Framed, framed};
use super::mesh::SkinMesh;
use super::touching::{TouchingCircle, touching_circles};
use super::tube::{Tube, TubeSpan, span};
use super::{Clearing, SkinError, Sphere, Spheres};
use crate::geometry::{MAX_SAMPLES, ParamSurface};

/// Steps round a tube and along a span with which meshes are made if no others are asked for.
pub const MESH_STEPS: [usize; 2] = [48, 12];

/// The skin of an arm of a chain: one tube, or several where a touching circle does not exist, and the ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// The spheres.
    pub spheres: Vec<usize>,
    /// The tubes between them. One, if the spheres are admissible.
    pub tubes: Vec<Tube>,
    /// What closes the tubes at the first and the last sphere; a ring has none.
    pub caps: [Option<EndCap>; 2],
    /// The spheres that have no touching circle, or nothing that can be drawn behind it.
    pub missing: Vec<usize>,
}

/// What is put over spheres. Where they are not admissible it is what exists of it.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereSkin {
    /// The parts that are skinned alone: one for a single chain or ring, else see [`Spheres::arms`].
    pub arms: Vec<Arm>,
}

impl Spheres {
    /// The skin of the spheres.
    #[must_use]
    pub fn skin(&self, clearing: Clearing) -> SphereSkin {
        let arms = self.arms().into_iter().map(|chain| arm(self.spheres(), chain, self.closed(), clearing));
        SphereSkin { arms: arms.collect() }
    }
}

/// The skin of one arm.
fn arm(spheres: &[Sphere], chain: Vec<usize>, closed: bool, clearing: Clearing) -> Arm {
    let found = touching_circles(spheres, &chain, closed);
    let mut missing: Vec<usize> =
        chain.iter().zip(&found).filter(|(_, circle)| circle.is_none()).map(|(sphere, _)| *sphere).collect();
    let mut tubes = Vec::new();
    let ring = closed && missing.is_empty();
    // A ring with a gap is a chain from behind the gap round to it.
    let start = if closed { found.iter().position(Option::is_none).map_or(0, |gap| gap + 1) } else { 0 };
    let turned: Vec<Option<TouchingCircle>> = found[start..].iter().chain(&found[..start]).copied().collect();
    for run in turned.split(Option::is_none) {
        let circles: Vec<TouchingCircle> = run.iter().copied().flatten().collect();
        let framed = framed(spheres, &circles, ring);
        let next = framed.iter().skip(1).chain(framed.first().filter(|_| ring));
        let spans: Vec<Option<TubeSpan>> =
            framed.iter().zip(next).map(|(from, to)| span([from, to], spheres, clearing)).collect();
        add_tubes(&mut tubes, &mut missing, framed, spans, ring);
    }
    let end = |last: bool| {
        let sphere = if last { chain.last() } else { chain.first() }?;
        let tube = if last { tubes.last() } else { tubes.first() }?;
        let framed = if last { tube.framed().last() } else { tube.framed().first() }?;
        (framed.circle.sphere == *sphere).then(|| EndCap::new(*framed, last))
    };
    let caps = if closed { [None, None] } else { [end(false), end(true)] };
    Arm { spheres: chain, tubes, caps, missing }
}

/// The tubes along successive circles, as far as spans exist.
fn add_tubes(
    tubes: &mut Vec<Tube>,
    missing: &mut Vec<usize>,
    circles: Vec<Framed>,
    spans: Vec<Option<TubeSpan>>,
    ring: bool,
) {
    if spans.iter().all(Option::is_some) {
        if !spans.is_empty() {
            tubes.push(Tube::new(circles, spans.into_iter().flatten().collect(), ring));
        }
        return;
    }
    missing.extend(
        circles.iter().zip(&spans).filter(|(_, span)| span.is_none()).map(|(at, _)| at.circle.sphere),
    );
    let mut from = 0;
    for run in spans.split(Option::is_none) {
        // Circles are one more than spans; the last span of a ring leads back to its first circle.
        let own: Vec<Framed> = circles.iter().cycle().skip(from).take(run.len() + 1).copied().collect();
        if !run.is_empty() {
            tubes.push(Tube::new(own, run.iter().copied().flatten().collect(), false));
        }
        from += run.len() + 1;
    }
}

impl SphereSkin {
    /// The touching circles in the order of the arms.
    #[must_use]
    pub fn circles(&self) -> Vec<TouchingCircle> {
        self.arms.iter().flat_map(|arm| &arm.tubes).flat_map(Tube::circles).copied().collect()
    }

    /// The surfaces that the skin is made of, with normals outwards: of every arm cap, tubes, cap.
    #[must_use]
    pub fn parts(&self) -> Vec<&dyn ParamSurface> {
        let mut parts: Vec<&dyn ParamSurface> = Vec::new();
        for Arm { tubes, caps: [first, last], .. } in &self.arms {
            parts.extend(first.as_ref().map(|cap| cap as &dyn ParamSurface));
            parts.extend(tubes.iter().map(|tube| tube as &dyn ParamSurface));
            parts.extend(last.as_ref().map(|cap| cap as &dyn ParamSurface));
        }
        parts
    }

    /// The pairs of spheres between which the skin enters a sphere.
    #[must_use]
    pub fn unclear(&self) -> Vec<[usize; 2]> {
        let spans = self.arms.iter().flat_map(|arm| &arm.tubes).flat_map(Tube::tube_spans);
        spans.filter(|span| !span.clear).map(|span| span.spheres).collect()
    }

    /// Whether nothing is missing, so that the mesh is closed.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.arms.iter().all(|arm| arm.missing.is_empty())
    }

    /// The skin as triangles, in so many steps round the tubes and along every span and cap ([`MESH_STEPS`]). If the
    /// skin is whole, every arm of a chain is a closed surface with the Euler characteristic 2, and a ring one with 0;
    /// arms that come to the same sphere have it in common, each with its own cap.
    ///
    /// # Errors
    /// [`SkinError::Steps`] for less than three steps round, none along, or too many vertices.
    pub fn mesh(&self, [round, along]: [usize; 2]) -> Result<SkinMesh, SkinError> {
        let spans: usize = self
            .arms
            .iter()
            .map(|arm| 2 + arm.tubes.iter().map(|tube| tube.tube_spans().len() + 1).sum::<usize>())
            .sum();
        let most = MAX_SAMPLES / spans.max(1);
        for (given, least, most) in [(round, 3, most), (along, 1, most / round.clamp(1, most.max(1)))] {
            if given < least || given > most {
                return Err(SkinError::Steps { given, least, most });
            }
        }
        let mut mesh = SkinMesh::default();
        for arm in &self.arms {
            let [first, last] = &arm.caps;
            let count = arm.tubes.len();
            for (index, tube) in arm.tubes.iter().enumerate() {
                let first = first.as_ref().filter(|_| index == 0);
                let last = last.as_ref().filter(|_| index + 1 == count);
                mesh.add(tube, [first, last], [round, along]);
            }
        }
        Ok(mesh)
    }
}
