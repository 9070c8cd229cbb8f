//! A surface by its knots in the form in which other programs take it: over clamped knots from 0.

use super::local::Hom;
use super::{KnotCurve, KnotError, KnotSurface, KnotVector};
use crate::geometry::{BSplineSurface, Basis};

impl KnotSurface {
    /// The same surface over knots that are clamped along both directions, closed ones too, and begin with 0.
    pub(super) fn clamped(&self) -> Result<BSplineSurface, KnotError> {
        let [u, v] = self.vectors();
        let rational = self.weights().is_some();
        let rows: Result<Vec<Vec<Hom<3>>>, KnotError> = (0..u.controls())
            .map(|i| clamped_line(v, |j| self.homogeneous([i, j]), rational).map(|(_, points)| points))
            .collect();
        let rows = rows?;
        let columns: Result<Vec<Vec<Hom<3>>>, KnotError> = (0..rows.first().map_or(0, Vec::len))
            .map(|l| {
                let point = |i: usize| rows.get(i).and_then(|row| row.get(l)).copied().unwrap_or(Hom::ZERO);
                clamped_line(u, point, rational).map(|(_, points)| points)
            })
            .collect();
        let columns = columns?;
        let net: Vec<Vec<Hom<3>>> = (0..columns.first().map_or(0, Vec::len))
            .map(|k| columns.iter().filter_map(|column| column.get(k).copied()).collect())
            .collect();
        let (along_u, along_v) = (
            clamped_line(u, |_| Hom::of([0.0; 3], 1.0), rational)?.0,
            clamped_line(v, |_| Hom::of([0.0; 3], 1.0), rational)?.0,
        );
        let degrees = [u.order() - 1, v.order() - 1];
        let [(knots_u, counts_u), (knots_v, counts_v)] = [along_u, along_v].map(|vector| different(&vector));
        let (knots, counts) = ([knots_u, knots_v], [counts_u, counts_v]);
        for (degree, counts) in degrees.iter().zip(&counts) {
            let inner = counts.iter().take(counts.len().saturating_sub(1)).skip(1);
            if let Some(knot) = inner.copied().position(|count| count > *degree) {
                return Err(KnotError::TooMultiple { knot, most: *degree });
            }
        }
        let mut surface = if rational {
            let net: Vec<Vec<[f64; 4]>> = net
                .iter()
                .map(|row| row.iter().map(|Hom { p: [x, y, z], w }| [*x, *y, *z, *w]).collect())
                .collect();
            BSplineSurface::rational(degrees, knots, counts, &net)
        } else {
            let net = net.iter().map(|row| row.iter().map(|point| point.p).collect()).collect();
            BSplineSurface { degrees, knots, multiplicities: counts, net, weights: None }
        };
        surface.close([u.closed(), v.closed()]);
        Ok(surface)
    }
}

/// The knots of a direction clamped, and the control points of one of its lines over them.
fn clamped_line(
    vector: &KnotVector,
    point: impl Fn(usize) -> Hom<3>,
    rational: bool,
) -> Result<(KnotVector, Vec<Hom<3>>), KnotError> {
    // A closed line goes on over its seam.
    let open = KnotVector::new(vector.order(), vector.knots().to_vec())?;
    let points: Vec<Hom<3>> = (0..vector.controls()).map(point).collect();
    let curve = KnotCurve::of_homogeneous(open, &points, rational)?.clamped()?;
    let clamped = (0..curve.vector().controls()).map(|i| curve.homogeneous(i)).collect();
    Ok((curve.vector().clone(), clamped))
}

/// The different knots from 0 and how often each is there.
fn different(vector: &KnotVector) -> (Vec<f64>, Vec<usize>) {
    let first = vector.domain()[0];
    let (mut knots, mut counts): (Vec<f64>, Vec<usize>) = (Vec::new(), Vec::new());
    for knot in vector.knots().iter().map(|knot| knot - first) {
        if let (Some(last), Some(count)) = (knots.last(), counts.last_mut())
            && *last == knot
        {
            *count += 1;
        } else {
            knots.push(knot);
            counts.push(1);
        }
    }
    (knots, counts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{ParamSurface, Point, Rim};
    use proptest::prelude::*;

    /// Clamped, uniform and closed knots of some orders.
    fn vector() -> impl Strategy<Value = KnotVector> {
        (2_usize..5, 0_usize..4, 0..3_u8).prop_map(|(order, more, kind)| match kind {
            0 => KnotVector::clamped(order, order + more).unwrap(),
            1 => KnotVector::uniform(order, order + more).unwrap(),
            _ => {
                let breaks: Vec<f64> = (0..=order + more).map(|k| (k * (k + 3)) as f64 / 4.0 - 1.0).collect();
                KnotVector::closed(order, &breaks).unwrap()
            }
        })
    }

    proptest! {
        #[test]
        fn the_exact_form_is_the_surface(
            vectors in [vector(), vector()],
            numbers in proptest::collection::vec(-3.0..3.0_f64, 40),
            rational: bool,
            places in proptest::collection::vec([0.0..1.0_f64, 0.0..1.0_f64], 10),
        ) {
            let [rows, columns] = [0, 1].map(|d| vectors[d].points());
            let number = |i: usize, j: usize, d: usize| numbers[(i * 7 + j * 13 + d * 5) % numbers.len()];
            let net: Vec<Vec<Point<3>>> = (0..rows)
                .map(|i| (0..columns).map(|j| [0, 1, 2].map(|d| number(i, j, d))).collect())
                .collect();
            let weights = rational.then(|| {
                (0..rows).map(|i| (0..columns).map(|j| 1.0 + number(i, j, 3).abs()).collect()).collect()
            });
            let surface = KnotSurface::new(vectors.clone(), net, weights).unwrap();
            let form = surface.to_bspline().unwrap();
            for place in places {
                let domains = [0, 1].map(|d| vectors[d].domain());
                let at = [0, 1].map(|d| domains[d][0] + place[d] * (domains[d][1] - domains[d][0]));
                let expected = surface.point_at(at).unwrap();
                let found = form.eval(at[0] - domains[0][0], at[1] - domains[1][0]).unwrap();
                for d in 0..3 {
                    prop_assert!((expected[d] - found[d]).abs() < 1e-11, "{:?} {:?}", expected, found);
                }
            }
            for (d, _) in vectors.iter().enumerate().filter(|(_, vector)| vector.closed()) {
                prop_assert_eq!(form.border(d, Rim::First), form.border(d, Rim::Last));
            }
        }
    }
}
