//! Curves and surfaces over extended Chebyshev spaces: the geometry of an item, and its named edits.
//!
//! Every edit is exact: elevated, divided and described items are the same functions as before, and those that are
//! exact keep their coefficients.

use super::DesignError;
use crate::file::ec::{
    Coefficients, CurveTerm, EcCurve, EcDocument, EcPatch, Interval, Item, PatchTerm, Scene, values,
};
use crate::geometry::ec::{CriticalLength, EcBasis, EcError, Real, Root, Space};
use crate::geometry::{Basis, Blend, Point, Weave};
use std::sync::Arc;

/// One arc.
pub type EcArc = Blend<Arc<EcBasis>, 3>;
/// One patch.
pub type EcWeave = Weave<Arc<EcBasis>, Arc<EcBasis>>;

/// The curves and patches of a document, in its order.
#[derive(Debug, Default)]
pub struct EcShapes {
    /// The curves.
    pub curves: Vec<EcArc>,
    /// The patches.
    pub patches: Vec<EcWeave>,
}

/// Bases that were made, so that items with the same space and interval share one.
#[derive(Clone, Debug, Default)]
pub struct Bases {
    known: Vec<Arc<EcBasis>>,
}

/// How many bases are kept.
const KEPT: usize = 64;

impl Bases {
    /// The basis of a space on an interval.
    ///
    /// # Errors
    /// Those of [`EcBasis::new`].
    pub fn of(&mut self, space: &Space, interval: [f64; 2]) -> Result<Arc<EcBasis>, EcError> {
        let same = |basis: &Arc<EcBasis>| basis.interval() == interval && basis.space() == space;
        if let Some(at) = self.known.iter().position(same) {
            let basis = self.known.remove(at);
            self.known.push(basis.clone());
            return Ok(basis);
        }
        let basis = Arc::new(EcBasis::new(space, interval)?);
        if self.known.len() >= KEPT {
            self.known.remove(0);
        }
        self.known.push(basis.clone());
        Ok(basis)
    }

    /// The geometry of a curve.
    ///
    /// # Errors
    /// Those of [`EcBasis::new`] and [`Blend::new`].
    pub fn arc(&mut self, curve: &EcCurve) -> Result<EcArc, EcError> {
        let basis = self.of(&curve.space, values(&curve.interval))?;
        Ok(Blend::new(basis, curve.points.clone())?)
    }

    /// The geometry of a patch.
    ///
    /// # Errors
    /// Those of [`EcBasis::new`] and [`Weave::new`].
    pub fn weave(&mut self, patch: &EcPatch) -> Result<EcWeave, EcError> {
        let [u, v] = self.both(patch)?;
        Ok(Weave::new(u, v, patch.net.clone())?)
    }

    fn both(&mut self, patch: &EcPatch) -> Result<[Arc<EcBasis>; 2], EcError> {
        Ok([
            self.of(&patch.space_u, values(&patch.interval_u))?,
            self.of(&patch.space_v, values(&patch.interval_v))?,
        ])
    }

    /// The geometry of all items of a document.
    ///
    /// # Errors
    /// [`DesignError::NoShape`] for a space alone, [`DesignError::Ec`] with the number of the item that has none.
    pub fn shapes(&mut self, document: &EcDocument) -> Result<EcShapes, DesignError> {
        let mut shapes = EcShapes::default();
        let scene = self.scene(document)?;
        let alone = scene.items.len() == 1;
        for (number, item) in (1..).zip(&scene.items) {
            let wrong = |error| DesignError::Ec { item: (!alone).then_some(number), error };
            match item {
                Item::Curve(curve) => shapes.curves.push(self.arc(curve).map_err(wrong)?),
                Item::Patch(patch) => shapes.patches.push(self.weave(patch).map_err(wrong)?),
            }
        }
        Ok(shapes)
    }

    /// The scene that a document is: a curve, a patch or an exact description is one with a single item.
    ///
    /// # Errors
    /// As [`Bases::shapes`].
    pub fn scene(&mut self, document: &EcDocument) -> Result<Scene, DesignError> {
        Ok(match document {
            EcDocument::Space(_) => return Err(DesignError::NoShape),
            EcDocument::Curve(curve) => Item::Curve(curve.clone()).into(),
            EcDocument::Patch(patch) => Item::Patch(patch.clone()).into(),
            EcDocument::Coefficients(coefficients) => {
                self.described(coefficients).map_err(|error| DesignError::Ec { item: None, error })?.into()
            }
            EcDocument::Scene(scene) => scene.clone(),
        })
    }

    /// The item that coefficients describe (1.45 to 1.48).
    ///
    /// # Errors
    /// [`EcError`] for a bad interval, or points that are too large.
    pub fn described(&mut self, coefficients: &Coefficients) -> Result<Item, EcError> {
        match coefficients {
            Coefficients::Curve { space, interval, coefficients } => {
                let curve = self.exact_curve(space, interval, coefficients)?;
                Ok(Item::Curve(curve))
            }
            Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients } => {
                let spaces = [(space_u, interval_u), (space_v, interval_v)];
                Ok(Item::Patch(self.exact_patch(spaces, coefficients)?))
            }
        }
    }

    /// The exact curve of some coefficients.
    ///
    /// # Errors
    /// As [`Bases::described`].
    pub fn exact_curve(
        &mut self,
        space: &Space,
        interval: &Interval,
        terms: &[CurveTerm],
    ) -> Result<EcCurve, EcError> {
        let basis = self.of(space, values(interval))?;
        let mut sums = vec![[0.0; 3]; space.dimension()];
        for term in terms {
            add(&mut sums, term.function, &term.value)?;
        }
        let points = basis.exact(&sums)?;
        Ok(EcCurve {
            space: space.clone(),
            interval: interval.clone(),
            points,
            exact: Some(terms.to_vec()),
            style: Default::default(),
            name: None,
        })
    }

    /// The exact patch of some coefficients.
    ///
    /// # Errors
    /// As [`Bases::described`].
    pub fn exact_patch(
        &mut self,
        [(space_u, interval_u), (space_v, interval_v)]: [(&Space, &Interval); 2],
        terms: &[PatchTerm],
    ) -> Result<EcPatch, EcError> {
        let u = self.of(space_u, values(interval_u))?;
        let v = self.of(space_v, values(interval_v))?;
        let mut sums = vec![vec![[0.0; 3]; v.points()]; u.points()];
        for term in terms {
            let row = sums.get_mut(term.u);
            let row = row.ok_or(EcError::Function { given: term.u, dimension: space_u.dimension() })?;
            add(row, term.v, &term.value)?;
        }
        // Along v for every function of u, then along u.
        let rows: Vec<Vec<Point<3>>> = sums.iter().map(|row| v.exact(row)).collect::<Result<_, _>>()?;
        let net = along_u(&rows, |column| u.exact(column))?;
        Ok(EcPatch {
            space_u: space_u.clone(),
            interval_u: interval_u.clone(),
            space_v: space_v.clone(),
            interval_v: interval_v.clone(),
            net,
            exact: Some(terms.to_vec()),
            style: Default::default(),
            name: None,
        })
    }

    /// The same curve in another space or on another interval. The space must contain the old one.
    ///
    /// # Errors
    /// [`EcError`] for a bad interval, or points that are too large.
    pub fn moved_curve(
        &mut self,
        curve: &EcCurve,
        space: &Space,
        interval: &Interval,
    ) -> Result<EcCurve, EcError> {
        let from = self.of(&curve.space, values(&curve.interval))?;
        let to = self.of(space, values(interval))?;
        Ok(EcCurve {
            points: from.transfer(&curve.points, &to)?,
            exact: curve.exact.as_ref().map(|terms| {
                let number = |k: usize| renumbered(&curve.space, space, k);
                terms
                    .iter()
                    .map(|term| CurveTerm { function: number(term.function), ..term.clone() })
                    .collect()
            }),
            space: space.clone(),
            interval: interval.clone(),
            ..curve.clone()
        })
    }

    /// The same patch in another space or on another interval along u (0) or v (1).
    ///
    /// # Errors
    /// As [`Bases::moved_curve`].
    pub fn moved_patch(
        &mut self,
        patch: &EcPatch,
        direction: usize,
        space: &Space,
        interval: &Interval,
    ) -> Result<EcPatch, EcError> {
        let (old, old_interval) = patch_space(patch, direction);
        let from = self.of(old, values(old_interval))?;
        let to = self.of(space, values(interval))?;
        let net = match direction {
            0 => along_u(&patch.net, |column| from.transfer(column, &to))?,
            _ => patch.net.iter().map(|row| from.transfer(row, &to)).collect::<Result<_, _>>()?,
        };
        let exact = patch.exact.as_ref().map(|terms| {
            let number = |term: &PatchTerm| match direction {
                0 => PatchTerm { u: renumbered(old, space, term.u), ..term.clone() },
                _ => PatchTerm { v: renumbered(old, space, term.v), ..term.clone() },
            };
            terms.iter().map(number).collect()
        });
        let mut moved = EcPatch { net, exact, ..patch.clone() };
        let (slot, interval_slot) = match direction {
            0 => (&mut moved.space_u, &mut moved.interval_u),
            _ => (&mut moved.space_v, &mut moved.interval_v),
        };
        (*slot, *interval_slot) = (space.clone(), interval.clone());
        Ok(moved)
    }

    /// The curve with a root more in its space: order elevation.
    ///
    /// # Errors
    /// [`EcError`] where the larger space has no basis on the interval.
    pub fn elevated_curve(&mut self, curve: &EcCurve, root: &Root) -> Result<EcCurve, EcError> {
        self.moved_curve(curve, &curve.space.with(root)?, &curve.interval)
    }

    /// The patch with a root more in its space along u (0) or v (1).
    ///
    /// # Errors
    /// As [`Bases::elevated_curve`].
    pub fn elevated_patch(
        &mut self,
        patch: &EcPatch,
        direction: usize,
        root: &Root,
    ) -> Result<EcPatch, EcError> {
        let (space, interval) = patch_space(patch, direction);
        self.moved_patch(patch, direction, &space.with(root)?, &interval.clone())
    }

    /// The parts of an item between parameters, along u (0) or v (1); curves have u only.
    ///
    /// # Errors
    /// [`EcError::Outside`] for a parameter that does not lie between its neighbours.
    pub fn divided(&mut self, item: &Item, direction: usize, at: &[Real]) -> Result<Vec<Item>, EcError> {
        let [start, end] = match item {
            Item::Curve(curve) => &curve.interval,
            Item::Patch(patch) => patch_space(patch, direction).1,
        };
        let stops: Vec<&Real> = std::iter::once(start).chain(at).chain([end]).collect();
        if let Some(pair) = stops.windows(2).find(|pair| pair[0].value() >= pair[1].value()) {
            let wrong = if std::ptr::eq(pair[1], end) { pair[0] } else { pair[1] };
            return Err(EcError::Outside { at: wrong.value(), interval: [start.value(), end.value()] });
        }
        stops
            .windows(2)
            .map(|pair| {
                let interval = [pair[0].clone(), pair[1].clone()];
                Ok(match item {
                    Item::Curve(curve) => {
                        Item::Curve(self.moved_curve(curve, &curve.space.clone(), &interval)?)
                    }
                    Item::Patch(patch) => {
                        let space = patch_space(patch, direction).0.clone();
                        Item::Patch(self.moved_patch(patch, direction, &space, &interval)?)
                    }
                })
            })
            .collect()
    }

    /// The arcs or patches over equal parts of the intervals that coefficients describe: as many along u and v as
    /// `parts` says, or the fewest that are shorter than nine tenths of the critical length.
    ///
    /// # Errors
    /// [`EcError`] for parts that are too long, or points that are too large.
    pub fn strips(
        &mut self,
        coefficients: &Coefficients,
        parts: [Option<usize>; 2],
    ) -> Result<Vec<Item>, EcError> {
        let pieces = |space: &Space, interval: &Interval, parts: Option<usize>| {
            let parts = parts.unwrap_or_else(|| fewest_parts(space, values(interval)));
            equal_parts(interval, parts)
        };
        match coefficients {
            Coefficients::Curve { space, interval, coefficients } => pieces(space, interval, parts[0])
                .iter()
                .map(|interval| self.exact_curve(space, interval, coefficients).map(Item::Curve))
                .collect(),
            Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients } => {
                let along_v = pieces(space_v, interval_v, parts[1]);
                let mut items = Vec::new();
                for u in pieces(space_u, interval_u, parts[0]) {
                    for v in &along_v {
                        let spaces = [(space_u, &u), (space_v, v)];
                        items.push(Item::Patch(self.exact_patch(spaces, coefficients)?));
                    }
                }
                Ok(items)
            }
        }
    }
}

/// The space and the interval of a patch along u (0) or v (1).
#[must_use]
pub fn patch_space(patch: &EcPatch, direction: usize) -> (&Space, &Interval) {
    match direction {
        0 => (&patch.space_u, &patch.interval_u),
        _ => (&patch.space_v, &patch.interval_v),
    }
}

/// The fewest equal parts of an interval that are shorter than nine tenths of the critical length.
#[must_use]
pub fn fewest_parts(space: &Space, [start, end]: [f64; 2]) -> usize {
    let critical = CriticalLength::new(space).finish();
    if critical.is_infinite() {
        return 1;
    }
    (((end - start) / (0.9 * critical)).floor() as usize).saturating_add(1).min(MOST_PARTS)
}

/// The most parts of an interval.
pub const MOST_PARTS: usize = 1000;

/// Equal parts of an interval; where they meet, the ends are the same doubles.
#[must_use]
pub fn equal_parts(interval: &Interval, parts: usize) -> Vec<Interval> {
    let [start, end] = values(interval);
    let parts = parts.clamp(1, MOST_PARTS);
    let stop = |k: usize| match k {
        0 => interval[0].clone(),
        k if k == parts => interval[1].clone(),
        // Weighted ends: symmetric intervals have symmetric parts.
        k => Real::from((start * (parts - k) as f64 + end * k as f64) / parts as f64),
    };
    (0..parts).map(|k| [stop(k), stop(k + 1)]).collect()
}

/// The coefficients of an item that is exact.
#[must_use]
pub fn coefficients(item: &Item) -> Option<Coefficients> {
    Some(match item {
        Item::Curve(curve) => Coefficients::Curve {
            space: curve.space.clone(),
            interval: curve.interval.clone(),
            coefficients: curve.exact.clone()?,
        },
        Item::Patch(patch) => Coefficients::Surface {
            space_u: patch.space_u.clone(),
            interval_u: patch.interval_u.clone(),
            space_v: patch.space_v.clone(),
            interval_v: patch.interval_v.clone(),
            coefficients: patch.exact.clone()?,
        },
    })
}

fn add(sums: &mut [Point<3>], function: usize, value: &[Real; 3]) -> Result<(), EcError> {
    let dimension = sums.len();
    let sum = sums.get_mut(function).ok_or(EcError::Function { given: function, dimension })?;
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value.value());
    Ok(())
}

/// A net whose columns are changed.
fn along_u(
    net: &[Vec<Point<3>>],
    change: impl Fn(&[Point<3>]) -> Result<Vec<Point<3>>, EcError>,
) -> Result<Vec<Vec<Point<3>>>, EcError> {
    let columns = net.first().map_or(0, Vec::len);
    let changed: Vec<Vec<Point<3>>> = (0..columns)
        .map(|l| change(&net.iter().filter_map(|row| row.get(l)).copied().collect::<Vec<_>>()))
        .collect::<Result<_, _>>()?;
    let rows = changed.first().map_or(0, Vec::len);
    Ok((0..rows).map(|k| changed.iter().filter_map(|column| column.get(k)).copied().collect()).collect())
}

/// The number that ordinary function `k` of a space has in a space that contains it.
fn renumbered(from: &Space, to: &Space, k: usize) -> usize {
    let mut before = 0;
    for root in from.roots() {
        if k < before + root.dimension() {
            let mut start = 0;
            for other in to.roots() {
                if other.is(root) {
                    return start + k - before;
                }
                start += other.dimension();
            }
        }
        before += root.dimension();
    }
    k
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{ParamCurve, ParamSurface};
    use std::f64::consts::PI;

    fn term(function: usize, value: [f64; 3]) -> CurveTerm {
        CurveTerm { function, value: value.map(Real::from) }
    }

    fn spiral() -> Coefficients {
        Coefficients::Curve {
            space: "0,1/4+i".parse().unwrap(),
            interval: [0.0.into(), "3*pi".parse().unwrap()],
            coefficients: vec![term(1, [1.0, 0.0, 0.0]), term(2, [0.0, 1.0, 0.0])],
        }
    }

    fn torus() -> Coefficients {
        let product = |u, v, value: [f64; 3]| PatchTerm { u, v, value: value.map(Real::from) };
        let space: Space = "0,i".parse().unwrap();
        Coefficients::Surface {
            space_u: space.clone(),
            interval_u: [0.0.into(), "2*pi".parse().unwrap()],
            space_v: space,
            interval_v: [0.0.into(), "2*pi".parse().unwrap()],
            coefficients: vec![
                product(0, 1, [2.0, 0.0, 0.0]),
                product(1, 1, [1.0, 0.0, 0.0]),
                product(0, 2, [0.0, 2.0, 0.0]),
                product(1, 2, [0.0, 1.0, 0.0]),
                product(2, 0, [0.0, 0.0, 1.0]),
            ],
        }
    }

    #[test]
    fn a_long_spiral_is_a_strip_of_arcs() {
        let mut bases = Bases::default();
        assert!(bases.described(&spiral()).is_err());
        let strip = bases.strips(&spiral(), [None; 2]).unwrap();
        assert_eq!(strip.len(), 4);
        let ends: Vec<_> = strip
            .iter()
            .map(|item| match item {
                Item::Curve(curve) => [curve.points[0], curve.points[2]],
                Item::Patch(_) => [[0.0; 3]; 2],
            })
            .collect();
        for pair in ends.windows(2) {
            assert!(pair[0][1].iter().zip(pair[1][0]).all(|(a, b)| (a - b).abs() < 1e-13));
        }
        let growth = (0.75 * PI).exp();
        assert!((ends[3][1][0] + growth).abs() < 1e-13 * growth);
    }

    #[test]
    fn the_torus_of_the_thesis() {
        let mut bases = Bases::default();
        let items = bases.strips(&torus(), [Some(4); 2]).unwrap();
        assert_eq!(items.len(), 16);
        let Item::Patch(first) = &items[0] else { panic!("a patch") };
        let expected = [
            [[3.0, 0.0, 0.0], [3.0, 3.0, 0.0], [0.0, 3.0, 0.0]],
            [[3.0, 0.0, 1.0], [3.0, 3.0, 1.0], [0.0, 3.0, 1.0]],
            [[2.0, 0.0, 1.0], [2.0, 2.0, 1.0], [0.0, 2.0, 1.0]],
        ];
        for (row, expected) in first.net.iter().zip(expected) {
            for (point, expected) in row.iter().zip(expected) {
                assert!(point.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{point:?}");
            }
        }
    }

    #[test]
    fn elevated_items_stay_exact_with_their_coefficients() {
        let mut bases = Bases::default();
        let coefficients = Coefficients::Curve {
            space: "0^2,i".parse().unwrap(),
            interval: [0.0.into(), 2.0.into()],
            coefficients: vec![term(1, [0.0, 0.0, 1.0]), term(2, [1.0, 0.0, 0.0]), term(3, [0.0, 1.0, 0.0])],
        };
        let Item::Curve(helix) = bases.described(&coefficients).unwrap() else { panic!("a curve") };
        let raised = bases.elevated_curve(&helix, &"0^2".parse().unwrap()).unwrap();
        assert_eq!(raised.space.to_string(), "0^4,i");
        let again = bases.described(&super::coefficients(&Item::Curve(raised.clone())).unwrap()).unwrap();
        let Item::Curve(again) = again else { panic!("a curve") };
        for (a, b) in raised.points.iter().flatten().zip(again.points.iter().flatten()) {
            assert!((a - b).abs() < 1e-13);
        }
        let (one, other) = (bases.arc(&helix).unwrap(), bases.arc(&raised).unwrap());
        let (one, other) = (one.eval(0, 0.3).unwrap(), other.eval(0, 0.3).unwrap());
        assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-14));
    }

    #[test]
    fn a_patch_divided_both_ways_is_the_same_surface() {
        let mut bases = Bases::default();
        let items = bases.strips(&torus(), [Some(4); 2]).unwrap();
        let whole = items[5].clone();
        let Item::Patch(patch) = &whole else { panic!("a patch") };
        let surface = bases.weave(patch).unwrap();
        let middle = |interval: &Interval| Real::from(0.3 * interval[0].value() + 0.7 * interval[1].value());
        for half in bases.divided(&whole, 0, &[middle(&patch.interval_u)]).unwrap() {
            for quarter in bases.divided(&half, 1, &[middle(&patch.interval_v)]).unwrap() {
                let Item::Patch(part) = &quarter else { panic!("a patch") };
                let part_surface = bases.weave(part).unwrap();
                for [s, t] in [[0.0, 0.0], [0.4, 0.7], [1.0, 0.2], [1.0, 1.0]] {
                    let place = |interval: &Interval, whole: &Interval, s: f64| {
                        let ([a, b], [start, end]) = (values(interval), values(whole));
                        (a + s * (b - a) - start) / (end - start)
                    };
                    let u = place(&part.interval_u, &patch.interval_u, s);
                    let v = place(&part.interval_v, &patch.interval_v, t);
                    let one = surface.eval([0, 0], [u, v]).unwrap();
                    let other = part_surface.eval([0, 0], [s, t]).unwrap();
                    assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-13));
                }
            }
        }
        let outside = bases.divided(&whole, 0, &[100.0.into()]).unwrap_err().to_string();
        assert!(outside.starts_with("100 does not lie inside the interval"), "{outside}");
    }
}
