//! Points with unit normals, in a net.

use crate::geometry::point::{add_scaled, check_count, norm, within_limit};
use crate::geometry::surface::{check_net, indices};
use crate::geometry::{GeometryError, Method, ParamSurface, Point, Scheme, Surface, Topology};

/// How far the length of a normal may be from 1.
const UNIT: f64 = 1e-6;

/// A net of points with a unit normal each: at least 2 x 2, row `i` in the direction of `u`, point `j` of it in
/// that of `v`. The normals are oriented alike; positive distances of offsets are along them.
#[derive(Clone, Debug, PartialEq)]
pub struct PnData {
    size: [usize; 2],
    points: Vec<Point<3>>,
    normals: Vec<Point<3>>,
}

impl PnData {
    /// The net of these points and normals, whose lengths may be off by 1e-6 and are made 1.
    ///
    /// # Errors
    /// [`GeometryError::TooFewPoints`] for less than two rows or columns, [`GeometryError::TooManyPoints`],
    /// [`GeometryError::Ragged`], [`GeometryError::NormalCount`], [`GeometryError::NotUnit`], and a bad
    /// coordinate.
    pub fn new(points: &[Vec<Point<3>>], normals: &[Vec<Point<3>>]) -> Result<Self, GeometryError> {
        let size = [points.len(), points.first().map_or(0, Vec::len)];
        check_count(size[0], 2)?;
        check_net(points)?;
        check_count(size[1], 2)?;
        check_count(size[0].saturating_mul(size[1]), 4)?;
        let fits = normals.len() == size[0] && normals.iter().all(|row| row.len() == size[1]);
        if !fits {
            let odd = normals.iter().map(Vec::len).find(|columns| *columns != size[1]);
            let given = [normals.len(), odd.unwrap_or(size[1])];
            return Err(GeometryError::NormalCount { given, needed: size });
        }
        let mut units = Vec::with_capacity(size[0] * size[1]);
        for (row, row_of) in normals.iter().enumerate() {
            for (column, normal) in row_of.iter().enumerate() {
                let length = norm(*normal);
                let is_unit = (length - 1.0).abs() <= UNIT && within_limit(normal);
                if !is_unit {
                    return Err(GeometryError::NotUnit { row, column, length });
                }
                units.push(normal.map(|x| x / length));
            }
        }
        Ok(Self { size, points: points.concat(), normals: units })
    }

    /// The net of these points with the normals of the bicubic spline through them, in the direction of
    /// r_u x r_v.
    ///
    /// # Errors
    /// Those of [`PnData::new`] for the points; [`GeometryError::NotUnit`] with length 0 where the spline has no
    /// normal, as where points coincide.
    pub fn automatic(points: &[Vec<Point<3>>]) -> Result<Self, GeometryError> {
        let surface = Surface::new(Scheme::new(Method::Spline, Topology::Open), points)?;
        let place = |index: usize, spans: usize| {
            let span = index.min(spans.saturating_sub(1));
            (span, if index == span { 0.0 } else { 1.0 })
        };
        let normal = |i: usize, j: usize| {
            let [(i, u), (j, v)] = [place(i, surface.spans()[0]), place(j, surface.spans()[1])];
            surface.normal([i, j], [u, v]).unwrap_or([0.0; 3])
        };
        let row = |(i, row): (usize, &Vec<Point<3>>)| (0..row.len()).map(|j| normal(i, j)).collect();
        Self::new(points, &points.iter().enumerate().map(row).collect::<Vec<_>>())
    }

    /// The numbers of rows and columns.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The point of a row and column.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> Option<Point<3>> {
        self.points.get(self.index(i, j)?).copied()
    }

    /// The unit normal of a row and column.
    #[must_use]
    pub fn normal(&self, i: usize, j: usize) -> Option<Point<3>> {
        self.normals.get(self.index(i, j)?).copied()
    }

    fn index(&self, i: usize, j: usize) -> Option<usize> {
        (i < self.size[0] && j < self.size[1]).then(|| i * self.size[1] + j)
    }

    /// All points, row by row.
    #[must_use]
    pub fn points(&self) -> &[Point<3>] {
        &self.points
    }

    /// All unit normals, row by row.
    #[must_use]
    pub fn normals(&self) -> &[Point<3>] {
        &self.normals
    }

    /// Row and column of every point, in the order of [`PnData::points`].
    pub fn indices(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        indices(self.size)
    }

    /// The net moved by a distance along its normals.
    ///
    /// # Errors
    /// A bad coordinate.
    pub fn offset(&self, distance: f64) -> Result<Self, GeometryError> {
        let moved = self.points.iter().zip(&self.normals);
        let points: Vec<_> = moved.map(|(point, normal)| add_scaled(*point, distance, *normal)).collect();
        crate::geometry::point::check_points(&points)?;
        Ok(Self { points, ..self.clone() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Net = Vec<Vec<Point<3>>>;

    fn net(rows: usize, columns: usize, at: impl Fn(f64, f64) -> Point<3>) -> Net {
        (0..rows).map(|i| (0..columns).map(|j| at(i as f64, j as f64)).collect()).collect()
    }

    #[test]
    fn wrong_data_are_named() {
        let points = net(3, 4, |i, j| [i, j, 0.0]);
        let up = net(3, 4, |_, _| [0.0, 0.0, 1.0]);
        assert!(PnData::new(&points, &up).is_ok());
        assert_eq!(PnData::new(&[], &[]), Err(GeometryError::TooFewPoints { given: 0, needed: 2 }));
        let line = PnData::new(&net(3, 1, |i, j| [i, j, 0.0]), &net(3, 1, |_, _| [0.0, 0.0, 1.0]));
        assert_eq!(line, Err(GeometryError::TooFewPoints { given: 1, needed: 2 }));
        let error = PnData::new(&points, &up[..2]);
        assert_eq!(error, Err(GeometryError::NormalCount { given: [2, 4], needed: [3, 4] }));
        for bad in [[0.0, 0.0, 1.1], [0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0]] {
            let mut normals = up.clone();
            normals[1][2] = bad;
            let error = PnData::new(&points, &normals);
            assert!(matches!(error, Err(GeometryError::NotUnit { row: 1, column: 2, .. })), "{error:?}");
        }
        let mut ragged = points.clone();
        ragged[1].pop();
        assert_eq!(PnData::new(&ragged, &up), Err(GeometryError::Ragged { row: 1, given: 3, needed: 4 }));
        let mut bad = points;
        bad[2][0][1] = f64::NAN;
        assert_eq!(PnData::new(&bad, &up), Err(GeometryError::NotFinite { number: 9 }));
    }

    #[test]
    fn automatic_normals_are_those_of_the_surface() {
        let at = |i: f64, j: f64| [i - 2.0, j - 2.0, 0.1 * (i - 2.0) * (j - 2.0)];
        let data = PnData::automatic(&net(5, 5, at)).unwrap();
        for ([i, j], normal) in data.indices().zip(data.normals()) {
            let [x, y, _] = at(i as f64, j as f64);
            let exact = [-0.1 * y, -0.1 * x, 1.0];
            let length = norm(exact);
            assert!(exact.iter().zip(normal).all(|(a, b)| (a / length - b).abs() < 1e-12));
        }
        assert!(PnData::automatic(&net(2, 2, at)).is_ok());
        let error = PnData::automatic(&net(3, 3, |_, _| [1.0; 3]));
        assert_eq!(error, Err(GeometryError::NotUnit { row: 0, column: 0, length: 0.0 }));
    }
}
