//! Two patches with a common border as one surface of two spans along `u`.

use super::{BSplineSurface, Derivatives, ParamSurface, Surface};
use crate::geometry::{BoundingBox, GeometryError, Method, Point};
use crate::geometry::{Scheme, Topology};

/// Two patches beside each other, the second where `u` goes on.
#[derive(Clone, Debug, PartialEq)]
pub struct Joined {
    halves: [Surface; 2],
}

impl Joined {
    /// Two Bézier patches of equal degrees by 2m + 1 rows, of which the middle one is the common border (3.24).
    ///
    /// # Errors
    /// [`GeometryError::WrongCount`] for an even number of rows or fewer than 5, and those of [`Surface::new`].
    pub fn bezier(net: &[Vec<Point<3>>]) -> Result<Self, GeometryError> {
        let m = net.len() / 2;
        if net.len() < 5 || net.len().is_multiple_of(2) {
            return Err(GeometryError::WrongCount { given: net.len(), needed: (2 * m + 1).max(5) });
        }
        super::check_net(net)?;
        let scheme = Scheme::new(Method::Bezier, Topology::Open);
        let (first, second) = (Surface::new(scheme, &net[..=m])?, Surface::new(scheme, &net[m..])?);
        Ok(Self { halves: [first, second] })
    }

    /// Two Hermite patches (3.17) by the rows of places at the beginning, the joint and the end, then the derivatives
    /// by `u` at the beginning, at the joint of the first and of the second patch, and at the end; columns as in
    /// [`Surface::hermite`].
    ///
    /// # Errors
    /// As [`Surface::hermite`].
    pub fn hermite(rows: &[[Point<3>; 4]; 7]) -> Result<Self, GeometryError> {
        let [p0, p1, p2, u0, u1, v1, u2] = *rows;
        Ok(Self { halves: [Surface::hermite(&[p0, p1, u0, u1])?, Surface::hermite(&[p1, p2, v1, u2])?] })
    }

    /// The two patches.
    #[must_use]
    pub fn halves(&self) -> &[Surface; 2] {
        &self.halves
    }
}

impl ParamSurface for Joined {
    fn spans(&self) -> [usize; 2] {
        [2, 1]
    }

    fn closed(&self) -> [bool; 2] {
        [false; 2]
    }

    fn at(&self, [i, j]: [usize; 2], uv: [f64; 2]) -> Option<Derivatives> {
        self.halves.get(i)?.at([0, j], uv)
    }

    fn eval(&self, [i, j]: [usize; 2], uv: [f64; 2]) -> Option<Point<3>> {
        self.halves.get(i)?.eval([0, j], uv)
    }

    fn steps(&self, direction: usize, _: usize, per_cell: usize) -> usize {
        self.halves[0].steps(direction, 0, per_cell)
    }

    fn patch_bounds(&self, [i, j]: [usize; 2]) -> Option<BoundingBox<3>> {
        self.halves.get(i)?.patch_bounds([0, j])
    }

    fn row(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
        if let Some(half) = self.halves.get(i) {
            half.row(0, u, per_cell, row);
        }
    }

    fn bounding_box(&self) -> Option<BoundingBox<3>> {
        let [first, second] = self.halves.each_ref().map(ParamSurface::bounding_box);
        Some(first?.union(second?))
    }

    /// The knot of the joint is as often there as its smoothness asks, as far as rounding tells it.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        let [first, second] = self.halves.each_ref().map(ParamSurface::to_bspline);
        let (mut surface, second) = (first?, second?);
        let m = surface.degrees[0];
        let rounding = self.bounding_box()?.rounding();
        surface.net.extend(second.net.into_iter().skip(1));
        let mut inner = m;
        // A point of the border, or the two beside it, that follow from the others.
        let rules: [(usize, [f64; 3], [usize; 3]); 2] = [
            (1, [0.5, 0.5, 0.0], [m - 1, m + 1, m]),
            (2, [1.0, 2.0, -2.0], [m.saturating_sub(2), m + 1, m - 1]),
        ];
        for (order, factors, from) in rules {
            let target = if order == 1 { m } else { m + 2 };
            let follows = (0..surface.net[0].len()).all(|l| {
                let point = |row: usize| surface.net.get(row).and_then(|row| row.get(l)).copied();
                let Some(wanted) = point(target) else { return false };
                (0..3).all(|axis| {
                    let sum: f64 =
                        factors.iter().zip(from).filter_map(|(k, row)| Some(k * point(row)?[axis])).sum();
                    (sum - wanted[axis]).abs() <= rounding
                })
            });
            if !follows || m <= order {
                break;
            }
            inner = m - order;
        }
        match m - inner {
            1 => drop(surface.net.remove(m)),
            2 => {
                // The blossom at the joint's neighbours: b(m-1) and c1 are the middles of its legs.
                let outer = surface.net.get(m - 2)?.clone();
                let near = surface.net.get(m - 1)?.clone();
                let point =
                    |(z, a): (&Point<3>, &Point<3>)| std::array::from_fn(|axis| 2.0 * a[axis] - z[axis]);
                let row = outer.iter().zip(&near).map(point).collect();
                surface.net.splice(m - 1..=m + 1, [row]);
            }
            _ => {}
        }
        surface.knots[0] = vec![0.0, 1.0, 2.0];
        surface.multiplicities[0] = vec![m + 1, inner, m + 1];
        Some(surface)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Joint;
    use proptest::prelude::*;

    fn net(rows: usize, columns: usize) -> impl Strategy<Value = Vec<Vec<Point<3>>>> {
        prop::collection::vec(prop::collection::vec(prop::array::uniform3(-100.0..100.0), columns), rows)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]
        #[test]
        fn is_the_same_surface_as_its_bspline_form(
            m in 2_usize..5, mut points in net(9, 4), joint in prop::sample::select(&Joint::ALL[..]),
        ) {
            points.truncate(2 * m + 1);
            for l in 0..4 {
                let mut column: Vec<Point<3>> = points.iter().map(|row| row[l]).collect();
                joint.impose_bezier(0.7, &mut column);
                points.iter_mut().zip(column).for_each(|(row, point)| row[l] = point);
            }
            let surface = Joined::bezier(&points).unwrap();
            let form = surface.to_bspline().unwrap();
            let smooth = match joint { Joint::C0 | Joint::Plane => 0, Joint::C1 => 1, Joint::C2 => 2.min(m - 1) };
            prop_assert_eq!(form.multiplicities[0][1], m - smooth);
            prop_assert_eq!(form.knot_vector(0).len(), form.net.len() + m + 1);
            for (i, u, v) in [(0, 0.0, 0.0), (0, 0.3, 0.8), (0, 1.0, 0.4), (1, 0.0, 0.4), (1, 0.6, 0.1), (1, 1.0, 1.0)] {
                let (one, other) = (surface.eval([i, 0], [u, v]).unwrap(), form.eval(i as f64 + u, v).unwrap());
                for axis in 0..3 {
                    prop_assert!((one[axis] - other[axis]).abs() < 1e-9, "{one:?} {other:?}");
                }
            }
        }
    }

    #[test]
    fn two_patches_have_an_odd_number_of_rows() {
        let net = |rows: usize| vec![vec![[0.0; 3]; 4]; rows];
        for (rows, needed) in [(0, 5), (3, 5), (4, 5), (6, 7)] {
            assert_eq!(Joined::bezier(&net(rows)), Err(GeometryError::WrongCount { given: rows, needed }));
        }
        assert!(Joined::bezier(&net(7)).is_ok());
    }
}
